//! The rooms of the core know only the rooms below them.

use std::fs;
use std::path::Path;

/// Each room of `frs-core/src` and the rooms it may name as `crate::…`; `Real`, `Lanes`, `FUSED` and `Model` stand at the crate's root.
const ARROWS: [(&str, &[&str]); 17] = [
    ("turn.rs", &[]),
    ("lanes/types.rs", &["turn"]),
    ("real.rs", &["lanes", "turn"]),
    ("spatial", &["FUSED", "Real"]),
    ("ldl.rs", &["Real"]),
    ("model", &["Real", "spatial", "model"]),
    ("urdf", &["Model", "model", "spatial", "urdf"]),
    ("sweep", &["Lanes", "Real", "model", "spatial", "sweep"]),
    ("rel", &["Real", "Model", "ldl", "model", "spatial", "sweep"]),
    ("hamel", &["Real", "ldl", "model", "spatial", "sweep"]),
    ("derivatives", &["Real"]),
    ("extended.rs", &["Real"]),
    ("enclosure.rs", &["Real", "extended"]),
    ("lanes/real.rs", &["Lanes", "Real"]),
    ("quantity.rs", &[]),
    ("floating_base.rs", &["Curvature", "Model", "Moving", "Quantity", "Real", "Shape", "Workspace", "spatial"]),
    ("generated.rs", &["Quantity", "model"]),
];

/// Each crate beside the façade, and those of the project on which it stands.
const CRATES: [(&str, &[&str]); 9] = [
    ("frs-core", &[]),
    ("frs-batch", &["frs-codegen", "frs-core"]),
    ("frs-codegen", &["frs-core"]),
    ("frs-gait", &["frs-core"]),
    ("frs-jit", &["frs-codegen", "frs-core"]),
    ("frs-macros", &["frs-codegen", "frs-core"]),
    ("frs-oracles", &["frs-core", "frs-macros"]),
    ("frs-sim", &["frs-core"]),
    ("generated", &["frs-core"]),
];

#[test]
fn crates_stand_only_on_those_below() {
    for (name, expected) in CRATES {
        let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join(name).join("Cargo.toml");
        let text = fs::read_to_string(manifest).unwrap();
        let dependencies = text.split("\n[").find(|part| part.starts_with("dependencies]")).unwrap();
        let own: Vec<&str> =
            dependencies.lines().filter_map(|line| line.split_once('.').map(|(name, _)| name)).collect();
        let own: Vec<&str> = own.into_iter().filter(|name| name.starts_with("frs-")).collect();
        assert_eq!(own, expected, "{name} (ARCHITECTURE.md)");
    }
}

#[test]
fn arrows_point_one_way() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("frs-core/src");
    let mut back = Vec::new();
    for (room, allowed) in ARROWS {
        for_each_file(&source.join(room), &mut |path, text| {
            for (number, line) in text.lines().enumerate() {
                // Documentation may link anywhere; code may not.
                let code = !line.trim_start().starts_with("//");
                if code && named_rooms(line).iter().any(|name| !allowed.contains(&name.as_str())) {
                    back.push(format!("{}:{}: {}", path.display(), number + 1, line.trim()));
                }
            }
        });
    }
    assert!(back.is_empty(), "these lines point back up the house (ARCHITECTURE.md):\n{}", back.join("\n"));
}

/// Every room of the core has its line in [`ARROWS`].
#[test]
fn every_room_is_known() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("frs-core/src");
    let mut rooms: Vec<_> =
        fs::read_dir(source).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    rooms.retain(|room| room != "lib.rs");
    rooms.sort();
    let mut known = ARROWS.map(|(room, _)| room.split('/').next().unwrap().to_owned()).to_vec();
    known.sort();
    known.dedup();
    assert_eq!(rooms, known);
}

fn for_each_file(path: &Path, visit: &mut impl FnMut(&Path, &str)) {
    if path.is_dir() {
        for entry in fs::read_dir(path).unwrap() {
            for_each_file(&entry.unwrap().path(), visit);
        }
    } else {
        visit(path, &fs::read_to_string(path).unwrap());
    }
}

/// What follows each `crate::` of a line: one name, or the first names within braces.
fn named_rooms(line: &str) -> Vec<String> {
    let word = |text: &str| text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    let mut names = Vec::new();
    for rest in line.split("crate::").skip(1) {
        match rest.strip_prefix('{') {
            Some(list) => names.extend(list.split(',').map(|item| word(item.trim_start()))),
            None => names.push(word(rest)),
        }
    }
    names.retain(|name| !name.is_empty());
    names
}
