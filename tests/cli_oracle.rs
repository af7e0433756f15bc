//! `frs oracle`, as a person or a program meets it.

use std::process::{Command, Output};

use serde_json::Value;

fn frs(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_frs")).arg("oracle").args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn alone_it_lists_every_case_and_all_agree() {
    let output = frs(&[]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let shown = text(&output.stdout);
    for case in frs_oracles::Case::ALL {
        let line = shown.lines().find(|line| line.trim_start().starts_with(case.id()));
        assert!(line.is_some_and(|line| line.contains(case.title()) && !line.contains("BEYOND")), "{case:?}: {shown}");
    }
    assert!(shown.contains("G2, double-double: the axis (1, 2, 2)/3 is no double"), "{shown}");
}

#[test]
fn a_case_shows_its_formulas_and_every_entry() {
    let output = frs(&["p5"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let shown = text(&output.stdout);
    for part in
        ["P5: a planar chain", "coordinates: joint_1, joint_2", "a₁ = (P₁ + P₂)/D", "𝓑[v_x](0, 1)", "double-double"]
    {
        assert!(shown.contains(part), "no '{part}' in {shown}");
    }
}

#[test]
fn json_holds_what_the_tables_show() {
    let all: Value = serde_json::from_slice(&frs(&["--json"]).stdout).unwrap();
    let one: Value = serde_json::from_slice(&frs(&["P5", "--json"]).stdout).unwrap();
    assert_eq!(all.as_array().unwrap().len(), frs_oracles::Case::ALL.len());
    let summary = all.as_array().unwrap().iter().find(|case| case["case"] == "P5").unwrap();
    for (key, value) in summary.as_object().unwrap() {
        assert_eq!(&one[key], value, "{key}");
    }
    assert_eq!((summary["n"].as_u64(), summary["holds"].as_bool()), (Some(2), Some(true)));
    let turn = |way: &str| one["values"][way]["𝓑[ω_z](0, 1)"].as_f64().unwrap();
    assert_eq!(turn("core"), turn("generated"));
    assert!((turn("core") - turn("formula")).abs() < 1e-15 && turn("core").abs() > 1e-3);
}

#[test]
fn an_unknown_case_is_bad_input_and_the_nearest_is_named() {
    let output = frs(&["P55"]);
    assert_eq!(output.status.code(), Some(2));
    let shown = text(&output.stderr);
    assert!(shown.contains("case 'P55': there is no such case") && shown.contains("did you mean P5?"), "{shown}");
}
