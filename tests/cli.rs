//! The command line, as a person or a program meets it.

use std::io::Write;
use std::process::{Command, Output, Stdio};

use serde_json::Value;

const LWR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/lwr_satellite.urdf");

/// Runs `frs` with `arguments` and `input` on its standard input.
fn frs(arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_frs"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // A program that stops at the first bad line may not read the rest.
    let _ = stdin.write_all(input.as_bytes());
    drop(stdin);
    child.wait_with_output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn json_lines(output: &Output) -> Vec<Value> {
    text(&output.stdout).lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// Writes a robot to a file of its own.
fn file(name: &str, content: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, content).unwrap();
    path.display().to_string()
}

#[test]
fn alone_it_shows_the_default_robot_and_runs_the_example_of_the_paper() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("alone");
    std::fs::create_dir_all(&folder).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_frs")).current_dir(&folder).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let shown = text(&output.stdout);
    assert!(shown.contains("all the same, bit for bit") && shown.contains("4.0000 s of 4.0000 s"), "{shown}");
    assert!(std::fs::read_to_string(folder.join("frs-paper/report.html")).unwrap().contains("lwr_satellite"));
    assert!(shown.contains("lwr_satellite: 8 links, 7 coordinates"));
    assert!(shown.contains("dΛ_b/dt = P(q̇)") && !shown.contains("BROKEN"), "{shown}");
}

#[test]
fn eval_answers_each_state_with_every_key() {
    let states = "{}\n\n{\"q\":[0.1,0.2,0.3,0.4,0.5,0.6,0.7],\"qd\":{\"joint_2\":1},\"mu\":[1,2,3,4,5,6]}\n";
    let output = frs(&["eval", LWR, "--states", "-"], states);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let lines = json_lines(&output);
    assert_eq!(lines.len(), 2);
    let keys = "joints locked_inertia connection shape_inertia p s c_b gamma_q b2 d_mu d_qdot curvature coupling_torque \
                momentum energy hamel_m hamel_c hamel_bias xi_dot";
    let object = lines[1].as_object().unwrap();
    assert_eq!(object.len(), keys.split_whitespace().count());
    for key in keys.split_whitespace() {
        assert!(object.contains_key(key), "no {key}");
    }
    let shape = |key: &str| (object[key].as_array().unwrap().len(), object[key][0].as_array().unwrap().len());
    assert_eq!((shape("connection"), shape("d_mu"), shape("curvature")), ((6, 7), (13, 13), (6, 7)));
    assert_eq!(object["joints"][6], "joint_7");
}

#[test]
fn only_the_asked_for_quantities_are_written() {
    let output = frs(&["eval", LWR, "--only", "energy,b2", "--states", "-"], "{}");
    let lines = json_lines(&output);
    let keys: Vec<_> = lines[0].as_object().unwrap().keys().cloned().collect();
    assert_eq!(keys, ["b2", "energy", "joints"]);
}

#[test]
fn base_twist_and_locked_velocity_are_the_same_state() {
    let moving = "\"q\":[0.1,0.2,0.3,0.4,0.5,0.6,0.7],\"qd\":[1,2,3,4,5,6,7]";
    let ask = |state: String| json_lines(&frs(&["eval", LWR, "--states", "-"], &state)).remove(0);
    let still = ask(format!("{{{moving},\"base_twist\":[0,0,0,0,0,0]}}"));
    // μ = A_l q̇ when the base stands still.
    let mu: Vec<f64> = still["connection"]
        .as_array()
        .unwrap()
        .iter()
        .map(|row| (0..7).map(|j| row[j].as_f64().unwrap() * (j + 1) as f64).sum())
        .collect();
    let locked = ask(format!("{{{moving},\"mu\":{mu:?}}}"));
    let (a, b) = (still["energy"].as_f64().unwrap(), locked["energy"].as_f64().unwrap());
    // Rounding of seven products.
    assert!((a - b).abs() <= 1e-14 * a, "{a} {b}");
}

#[test]
fn bad_states_are_told_with_their_line_and_field() {
    let cases = [
        ("{}\n{\"q\":[1,2]}", "standard input:2:1: q: found 2 numbers; expected 7, one per coordinate: joint_1"),
        ("{\"q\":{\"elbow\":1}}", "q: no coordinate is called 'elbow'; the coordinates are: joint_1"),
        ("{\"mu\":[1,2,3]}", "mu: found 3 numbers; expected 6"),
        ("{\"mu\":[0,0,0,0,0,0],\"base_twist\":[0,0,0,0,0,0]}", "both mu and base_twist are given"),
        ("{\"qdd\":[1]}", "unknown field `qdd`"),
        ("{\"q\":[1e999]}", "standard input:1:"),
        ("not json", "standard input:1:2: expected"),
    ];
    for (states, expected) in cases {
        let output = frs(&["eval", LWR, "--states", "-"], states);
        assert_eq!(output.status.code(), Some(2), "{states}");
        assert!(text(&output.stderr).contains(expected), "{states}: {}", text(&output.stderr));
    }
}

#[test]
fn bad_files_and_options_are_told() {
    let missing = frs(&["eval", "no_such_robot.urdf"], "");
    assert_eq!(missing.status.code(), Some(2));
    assert!(text(&missing.stderr).contains("no_such_robot.urdf: cannot be read"));

    let key = frs(&["eval", LWR, "--only", "inertia"], "");
    assert_eq!(key.status.code(), Some(2));
    assert!(text(&key.stderr).contains("shape_inertia"), "the possible keys are listed");

    let robot = file("zero_axis.urdf", include_str!("../robots/chaser.urdf").replacen("0 0 1", "0 0 0", 1).as_str());
    let axis = frs(&["eval", &robot], "");
    assert_eq!(axis.status.code(), Some(2));
    let message = text(&axis.stderr);
    assert!(
        message.contains("zero_axis.urdf:") && message.contains("axis") && message.contains("expected"),
        "{message}"
    );

    let root = frs(&["eval", LWR, "--root", "hand"], "");
    assert_eq!(root.status.code(), Some(2));
    assert!(text(&root.stderr).contains("hand"));
}

/// Two point masses and a slider between them: at zero length of the arm all mass lies on one line.
const ROD: &str = r#"<robot name="rod">
  <link name="base"><inertial><mass value="2"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="arm"><inertial><origin xyz="1 0 0"/><mass value="1"/><inertia ixx="0" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="tip"><inertial><origin xyz="1 0 0"/><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="elbow" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/><limit effort="1" velocity="1" lower="-3" upper="3"/></joint>
  <joint name="wrist" type="revolute"><parent link="arm"/><child link="tip"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/><limit effort="1" velocity="1" lower="-3" upper="3"/></joint>
</robot>"#;

#[test]
fn a_singular_shape_is_reported_and_never_nan() {
    let robot = file("rod.urdf", ROD);
    let output = frs(&["eval", &robot, "--states", "-"], "{\"q\":[0.5,0.5]}\n{}\n{\"q\":[1,1]}\n");
    assert_eq!(output.status.code(), Some(1));
    let lines = json_lines(&output);
    assert_eq!(lines.len(), 3, "the other states are answered");
    assert!(lines[1]["error"].as_str().unwrap().contains("locked inertia"), "{}", lines[1]);
    assert!(lines[0].get("error").is_none() && lines[2].get("error").is_none());
}

#[test]
fn tables_name_every_quantity() {
    let output = frs(&["eval", LWR], "");
    assert_eq!(output.status.code(), Some(0));
    let shown = text(&output.stdout);
    for part in ["Λ_b, 6×6   [locked_inertia]", "component v_z:", "ξ̇ = [μ̇; q̈], 6+n   [xi_dot]"] {
        assert!(shown.contains(part), "no {part}");
    }
}
