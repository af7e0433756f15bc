//! `frs verify` and `frs diff`, as a person or a program meets them.

use std::process::{Command, Output};

use serde_json::Value;

const PLANAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/planar_three_link.urdf");

/// Functions of the planar robot: sixteen quantities, and the kinematics of the link at its end.
const FUNCTIONS: usize = 18;

fn frs(arguments: &[&str]) -> Command {
    let mut frs = Command::new(env!("CARGO_BIN_EXE_frs"));
    frs.args(arguments);
    frs
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

/// What `frs` answers in JSON.
fn answer(arguments: &[&str]) -> Value {
    let output = frs(arguments).arg("--json").output().unwrap();
    assert_eq!(code(&output), 0, "{arguments:?}: {}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Verifies the planar robot with `options`; names of the functions, none of which differs.
fn verified(options: &[&str]) -> Vec<String> {
    let answer = answer(&[&["verify", PLANAR, "--states", "50"], options].concat());
    assert_eq!(answer["differences"], 0, "{options:?}: {answer}");
    assert_eq!(answer["first_difference"], Value::Null);
    let states = answer["states"].as_u64().unwrap();
    assert_eq!(states - answer["hard_states"].as_u64().unwrap(), 50);
    let functions = answer["functions"].as_array().unwrap();
    for function in functions {
        let compared = function["compared"].as_u64().unwrap();
        assert!(compared >= states && compared.is_multiple_of(states), "{function}");
        assert_eq!((&function["differences"], &function["not_finite"]), (&0.into(), &0.into()), "{function}");
        assert!(function["generated_ns"].as_f64().unwrap() > 0.0 && function["core_ns"].as_f64().unwrap() > 0.0);
    }
    functions.iter().map(|function| function["name"].as_str().unwrap().to_owned()).collect()
}

/// The planar robot with one text replaced by another.
fn changed(name: &str, from: &str, to: &str) -> String {
    let robot = std::fs::read_to_string(PLANAR).unwrap();
    assert!(robot.contains(from), "{from}");
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, robot.replace(from, to)).unwrap();
    path.display().to_string()
}

#[test]
fn generated_code_has_the_bits_of_the_core() {
    let names = verified(&[]);
    assert_eq!(names.len(), FUNCTIONS);
    assert_eq!(names.last().unwrap(), "kinematics_link_2");
}

#[test]
fn a_held_coordinate_has_the_bits_of_the_core_that_holds_it() {
    assert_eq!(verified(&["--lock", "joint_1=0.7"]).len(), FUNCTIONS);
}

#[test]
fn what_is_left_without_momentum_has_the_bits_of_the_core_at_zero() {
    let names = verified(&["--momentum", "zero"]);
    assert!(names.contains(&"forward_dynamics".into()) && !names.contains(&"d_mu".into()), "{names:?}");
}

#[test]
fn a_payload_has_the_bits_of_the_core_that_carries_it() {
    assert_eq!(verified(&["--payload", "link_2", "--no-gravity"]).len(), FUNCTIONS);
}

#[test]
fn single_precision_has_the_bits_of_the_core_in_single_precision() {
    assert_eq!(verified(&["--f32", "--outputs", "inertia,forward_dynamics"]), ["inertia", "forward_dynamics"]);
}

#[test]
fn a_person_is_told_that_all_is_the_same() {
    let output = frs(&["verify", PLANAR, "--states", "1", "--outputs", "momentum"]).output().unwrap();
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    let shown = text(&output.stdout);
    assert!(shown.contains("planar_three_link in f64") && shown.contains("all the same, bit for bit"), "{shown}");
}

/// A compiler that changes the last bit of a constant of the robot, which shows that a difference is found.
#[cfg(unix)]
#[test]
fn one_bit_of_one_constant_is_found_and_named() {
    use std::os::unix::fs::PermissionsExt;
    let compiler = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("careless_rustc");
    let script = r#"#!/bin/sh
for main; do :; done
robot=$(dirname "$main")/robot.rs
sed 's/0\.875/0.8750000000000001/' "$robot" > "$robot.new" && mv "$robot.new" "$robot"
exec rustc "$@"
"#;
    std::fs::write(&compiler, script).unwrap();
    std::fs::set_permissions(&compiler, std::fs::Permissions::from_mode(0o755)).unwrap();
    let arguments = ["verify", PLANAR, "--states", "50", "--outputs", "inertia", "--json"];
    let output = frs(&arguments).env("RUSTC", &compiler).output().unwrap();
    assert_eq!(code(&output), 1);
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(answer["differences"].as_u64().unwrap() > 0);
    let (first, told) = (&answer["first_difference"], text(&output.stderr));
    assert_ne!(first["generated"]["bits"], first["core"]["bits"]);
    for part in ["entry", "function"].map(|key| first[key].as_str().unwrap()) {
        assert!(told.contains(part), "no {part}: {told}");
    }
    assert_eq!(first["inputs"]["q"].as_array().unwrap().len(), 2);
}

#[test]
fn what_cannot_be_verified_is_told() {
    let cases = [
        (&["--lock", "elbow=1"][..], "choose from joint_1, joint_2"),
        (&["--lock", "joint_1=straight"], "expected NAME=VALUE"),
        (&["--payload", "hand"], "choose from base, link_1, link_2"),
        (&["--f32", "--lanes", "4"], "4 lanes of f32"),
        (&["--lanes", "16"], "16 lanes of f64"),
        (&["--form", "hybrid", "--lanes", "8"], "hybrid and lanes exclude each other"),
        (&["--form", "hybrid", "--f32"], "hybrid and f32 exclude each other"),
        (&["--momentum", "zero", "--outputs", "d_mu"], "it vanishes with the momentum"),
    ];
    for (options, expected) in cases {
        let output = frs(&[&["verify", PLANAR], options].concat()).output().unwrap();
        assert_eq!(code(&output), 2, "{options:?}");
        assert!(text(&output.stderr).contains(expected), "{options:?}: {}", text(&output.stderr));
    }
    let output = frs(&["verify", PLANAR]).env("RUSTC", "/no/such/compiler").output().unwrap();
    assert_eq!(code(&output), 2);
    assert!(text(&output.stderr).contains("/no/such/compiler: cannot be started"), "{}", text(&output.stderr));
}

#[test]
fn a_robot_does_not_differ_from_itself() {
    let answer = answer(&["diff", PLANAR, PLANAR]);
    assert!(answer["functions"].as_array().unwrap().iter().all(|function| function["change"] == "unchanged"));
    assert_eq!((&answer["lines_added"], &answer["lines_removed"]), (&0.into(), &0.into()));
    assert_eq!(answer["robot"]["parameters"], Value::Array(Vec::new()));
}

#[test]
fn another_mass_changes_constants_alone() {
    // No product with either mass is folded away, as one with 1 would be.
    let (light, heavy) = (
        changed("light.urdf", "<mass value=\"0.75\"/>", "<mass value=\"0.7\"/>"),
        changed("heavy.urdf", "<mass value=\"0.75\"/>", "<mass value=\"0.91\"/>"),
    );
    let answer = answer(&["diff", &light, &heavy]);
    let [mass] = &answer["robot"]["parameters"].as_array().unwrap()[..] else { panic!("{answer}") };
    assert_eq!((&mass["of"], &mass["name"]), (&"link 'link_2'".into(), &"mass (kg)".into()));
    assert_eq!((mass["old"].as_f64(), mass["new"].as_f64()), (Some(0.7), Some(0.91)));
    assert!((mass["relative"].as_f64().unwrap() - 0.3).abs() < f64::EPSILON);
    for function in answer["functions"].as_array().unwrap() {
        assert_eq!(function["change"], "constants", "{function}");
        assert_eq!(function["operations"][0], function["operations"][1]);
    }
    assert!(answer["lines_added"].as_u64().unwrap() > 0);
}

#[test]
fn another_name_or_limit_changes_no_operation() {
    let renamed = answer(&["diff", PLANAR, &changed("renamed.urdf", "joint_2", "elbow")]);
    assert_eq!(renamed["robot"]["coordinates"]["renamed"][0][1], "elbow");
    assert!(renamed["functions"].as_array().unwrap().iter().all(|function| function["change"] == "names"));

    let limited = answer(&["diff", PLANAR, &changed("limited.urdf", "effort=\"10\"", "effort=\"20\"")]);
    assert_eq!(limited["robot"]["without_effect"].as_array().unwrap().len(), 2);
    assert!(limited["functions"].as_array().unwrap().iter().all(|function| function["change"] == "unchanged"));
}

#[test]
fn another_axis_changes_the_structure_and_a_person_is_told_how_much() {
    let turned = changed("turned.urdf", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 1 1\"/>");
    let output = frs(&["diff", PLANAR, &turned, "--outputs", "inertia"]).output().unwrap();
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    let shown = text(&output.stdout);
    for part in
        ["joint 'joint_1'  axis", "inertia   structure", "Summary: the same links and joints; 2 parameters moved"]
    {
        assert!(shown.contains(part), "no {part}: {shown}");
    }
}
