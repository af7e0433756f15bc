"""Writes our side as a cargo workspace: for each robot a package of its generated code, and one of the program around it.

The code stands apart so that it is compiled again only when it changes, and so that each function stays a symbol whose size
can be read.
"""

import re
import subprocess
from pathlib import Path

import plan

MANIFEST = """[workspace]
members = [{members}]
resolver = "3"

[profile.release]
opt-level = 3
"""
CODE = """[package]
name = "code_{name}"
version = "0.0.0"
edition = "2024"

[dependencies]
frs-core = {{ path = "{root}/frs-core" }}
"""
RACE = """[package]
name = "race_{name}"
version = "0.0.0"
edition = "2024"

[dependencies]
beside = {{ path = "{root}/benches/peers/frs" }}
code_{name} = {{ path = "code" }}
"""
MAIN = """//! The race of {name}.

fn main() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {{
    beside::race(|{states}| {{
        vec![
{contestants}        ]
    }})
}}
"""
CONTESTANT = '            ("{form}", Box::new(beside::Ready::new(code_{name}::{form}::{type}, states))),\n'


def settle(path, text):
    """Writes a file unless it holds this already, so that cargo sees what changed."""
    if not path.exists() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def generate(frs, urdf, form, works):
    """The module of one form."""
    outputs = ",".join(plan.quantities(works))
    command = [frs, "generate", urdf, "--outputs", outputs, *plan.FORMS[form][0]]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def package(folder, frs, name, urdf, n):
    """The packages of one robot."""
    modules = {}
    for form in plan.FORMS:
        works = plan.generated_works(form, n)
        if works:
            modules[form] = generate(frs, urdf, form, works)
            settle(folder / "code/src" / f"{form}.rs", modules[form])
    types = {form: re.search(r"^pub struct (\w+);", text, re.M)[1] for form, text in modules.items()}
    contestants = [CONTESTANT.format(form=form, name=name, type=kind) for form, kind in types.items()]
    main = MAIN.format(name=name, states="states" if types else "_", contestants="".join(contestants))
    library = f"//! {name}, generated.\n\n" + "".join(f"pub mod {form};\n" for form in modules)
    settle(folder / "code/Cargo.toml", CODE.format(name=name, root=plan.ROOT))
    settle(folder / "code/src/lib.rs", library)
    settle(folder / "Cargo.toml", RACE.format(name=name, root=plan.ROOT))
    settle(folder / "src/main.rs", main)
    return modules


def write(folder, frs, robots):
    """All packages; robots: {name: (urdf, n)}. The text of each form of each robot."""
    folder.mkdir(parents=True, exist_ok=True)
    texts = {name: package(folder / name, frs, name, urdf, n) for name, (urdf, n) in robots.items()}
    # What an earlier run wrote stays a member, so that cargo keeps what it compiled.
    members = sorted(path.parent.name for path in folder.glob("*/Cargo.toml"))
    listed = ", ".join(f'"{member}", "{member}/code"' for member in members)
    settle(folder / "Cargo.toml", MANIFEST.format(members=listed))
    return texts
