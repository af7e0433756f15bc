//! Generated code as a program of its own: written, compiled, started.

use std::env;
use std::ffi::OsString;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use frs_codegen::{FunctionReport, Lanes, Options};
use tempfile::TempDir;

use super::element::Element;
use super::states::Layout;
use crate::cli::Failure;

/// The parts of the program that are the same for every robot.
const PROGRAM: &str = include_str!("program.rs");
const TIME: &str = include_str!("time.rs");

/// The crate that the lanes' types stand on.
const MANIFEST: &str = r#"[package]
name = "check"
edition = "2024"

[dependencies]
wide = "1.7"

[workspace]
"#;

/// A program that answers states with generated code.
pub struct Harness {
    /// Holds the program, as long as this lives.
    folder: TempDir,
    /// Whether the program holds vectors, which stand on a crate.
    vectors: bool,
}

impl Harness {
    /// Writes the program.
    pub fn write<E: Element>(
        robot: &str,
        functions: &[FunctionReport],
        layout: &Layout,
        options: &Options,
    ) -> Result<Self, String> {
        let folder = tempfile::tempdir().map_err(|error| format!("no temporary folder can be made: {error}"))?;
        let lanes = options.lanes;
        let number = number::<E>(lanes);
        let vector = match lanes {
            Lanes::One => robot.contains("F64x4").then_some("F64x4"),
            _ => Some(number.as_str()),
        };
        let lane_types = if vector.is_some() { "mod lanes;\nmod turn;\n" } else { "" };
        let imports = vector.map_or_else(String::new, |vector| format!("use crate::lanes::{vector};\n"));
        let main = format!(
            "{PROGRAM}\nmod robot;\nmod time;\n{lane_types}{}",
            definitions::<E>(functions, layout, lanes, &number)
        );
        let files = [
            ("Cargo.toml", MANIFEST),
            ("src/main.rs", &main),
            ("src/robot.rs", &(imports + robot)),
            ("src/time.rs", TIME),
            ("src/lanes.rs", frs::lanes::SOURCE),
            ("src/turn.rs", frs::generated::TURN),
        ];
        let write = || {
            fs::create_dir(folder.path().join("src"))?;
            files.iter().try_for_each(|(name, text)| fs::write(folder.path().join(name), text))
        };
        write().map_err(|error| format!("{}: cannot be written: {error}", folder.path().display()))?;
        Ok(Self { folder, vectors: vector.is_some() })
    }

    /// Compiles the program, at this level of optimisation.
    pub fn compile(&self, level: u8) -> Result<(), Failure> {
        if self.vectors {
            return self.cargo(level, true).or_else(|_| self.cargo(level, false));
        }
        let mut rustc = tool("RUSTC", "rustc");
        rustc.args(["--edition=2024", "--crate-name=check", "--cap-lints=allow"]);
        run(rustc
            .arg(format!("-Copt-level={level}"))
            .arg("-o")
            .arg(self.executable())
            .arg(self.folder.path().join("src/main.rs")))
    }

    fn cargo(&self, level: u8, offline: bool) -> Result<(), Failure> {
        let mut cargo = tool("CARGO", "cargo");
        cargo
            .args(["build", "--release", "--quiet", "--target-dir"])
            .arg(self.target())
            .current_dir(self.folder.path());
        cargo.arg(format!("--config=profile.release.opt-level={level}"));
        // For this processor: where eight lanes are one register, they compile in a fraction of the time.
        cargo.env("RUSTFLAGS", "--cap-lints=allow -Ctarget-cpu=native").env_remove("CARGO_BUILD_TARGET");
        run(if offline { cargo.arg("--offline") } else { &mut cargo })
    }

    fn executable(&self) -> PathBuf {
        let folder = if self.vectors { self.target().join("release") } else { self.folder.path().into() };
        folder.join("check").with_extension(env::consts::EXE_EXTENSION)
    }

    /// Where cargo builds: what the lanes stand on is then there for the next time, if the user has such a folder.
    fn target(&self) -> PathBuf {
        env::var_os("CARGO_TARGET_DIR").map_or_else(|| self.folder.path().join("target"), PathBuf::from)
    }

    /// Starts the program.
    pub fn start(&self) -> Result<Child, String> {
        let path = self.executable();
        Command::new(&path)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("{}: cannot be started: {error}", path.display()))
    }
}

/// A compiler: the one that a variable names, or that is found on the path.
fn tool(variable: &str, name: &str) -> Command {
    Command::new(env::var_os(variable).filter(|value| !value.is_empty()).unwrap_or_else(|| OsString::from(name)))
}

/// Runs a compiler.
fn run(command: &mut Command) -> Result<(), Failure> {
    let name = Path::new(command.get_program()).display().to_string();
    let output = command.stdin(Stdio::null()).output().map_err(|error| {
        Failure::Input(format!(
            "{name}: cannot be started: {error}; expected a Rust compiler of edition 2024; install one from \
             https://rustup.rs, or name it in the variable RUSTC (for lanes and the hybrid form cargo, in CARGO)"
        ))
    })?;
    if output.status.success() {
        return Ok(());
    }
    let complaint = String::from_utf8_lossy(&output.stderr);
    Err(Failure::Check(format!(
        "{name}: the generated code could not be compiled ({}); lanes and the hybrid form need the crate wide, from cargo's cache or \
         registry; the compiler said:\n{}",
        output.status,
        complaint.trim_end()
    )))
}

/// The type that generated code computes with.
fn number<E: Element>(lanes: Lanes) -> String {
    match lanes {
        Lanes::One => E::NAME.into(),
        _ => format!("{}x{}", E::NAME.to_uppercase(), lanes.count()),
    }
}

/// The definitions that depend on the robot.
fn definitions<E: Element>(functions: &[FunctionReport], layout: &Layout, lanes: Lanes, number: &str) -> String {
    let (path, pack, unpack) = match lanes {
        Lanes::One => (String::new(), "lanes[0]", "[number]"),
        _ => ("lanes::".into(), "Number::from_array(lanes)", "number.to_array()"),
    };
    let names: Vec<String> = (0..functions.len()).map(|number| format!("answer_{number}")).collect();
    let mut text = format!(
        "type Element = {};
type Number = {path}{number};
type State = [Number; INPUTS];
type Answer = fn(&[State], Option<&mut Vec<u8>>);
const INPUTS: usize = {};
const LANES: usize = {};
const FUNCTIONS: [Answer; {}] = [{}];
fn pack(lanes: [Element; LANES]) -> Number {{ {pack} }}
fn unpack(number: Number) -> [Element; LANES] {{ {unpack} }}
",
        E::NAME,
        layout.len,
        lanes.count(),
        names.len(),
        names.join(", ")
    );
    for (function, name) in functions.iter().zip(&names) {
        answer(&mut text, function, name);
    }
    text
}

/// A function that answers states: with the numbers as bytes, or without keeping them.
fn answer(text: &mut String, function: &FunctionReport, name: &str) {
    let mut arguments: Vec<String> =
        function.inputs.iter().map(|input| format!("part::<{}>(state, {})", input.len, input.start)).collect();
    let (mut outputs, mut kept, mut shown) = (String::new(), String::new(), Vec::new());
    for (number, &(_, [rows, columns], layers)) in function.outputs.iter().enumerate() {
        // The types follow the generator's: no array around a single number, nor around a single column.
        let (value, flat) = match ([rows, columns], layers) {
            ([1, 1], 1) => ("none".into(), format!("std::slice::from_ref(&o{number})")),
            ([_, 1], 1) => (format!("[none; {rows}]"), format!("&o{number}")),
            (_, 1) => (format!("[[none; {rows}]; {columns}]"), format!("o{number}.as_flattened()")),
            _ => {
                (format!("[[[none; {rows}]; {columns}]; {layers}]"), format!("o{number}.as_flattened().as_flattened()"))
            }
        };
        let _ = writeln!(outputs, "    let mut o{number} = {value};");
        let _ = writeln!(kept, "                write(answer, {flat});");
        arguments.push(format!("&mut o{number}"));
        shown.push(format!("&o{number}"));
    }
    let _ = write!(
        text,
        "#[inline(never)]
fn {name}(states: &[State], mut answer: Option<&mut Vec<u8>>) {{
    // An entry that nobody writes stays as it is, and is seen.
    let none = pack([Element::NAN; LANES]);
{outputs}    for state in states {{
        robot::{}({});
        match &mut answer {{
            Some(answer) => {{
{kept}            }}
            None => {{ std::hint::black_box(({},)); }}
        }}
    }}
}}
",
        function.name,
        arguments.join(", "),
        shown.join(", ")
    );
}
