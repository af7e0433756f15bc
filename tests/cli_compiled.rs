//! Machine code made on the spot: `frs eval --compiled` answers as `frs eval` does, byte for byte, and `frs simulate` and `frs accuracy` move as the
//! core does.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn frs(arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_frs"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

/// Random states as JSON lines: with μ, with V₁, and one at rest.
fn states(n: usize) -> String {
    let mut random = fastrand::Rng::with_seed(5);
    let mut numbers = |len: usize| (0..len).map(|_| random.f64() * 6.0 - 3.0).collect::<Vec<_>>();
    let mut lines = "{}\n".to_owned();
    for base in ["mu", "base_twist"].repeat(20) {
        let (q, qd, tau, six, wrench) = (numbers(n), numbers(n), numbers(n), numbers(6), numbers(6));
        lines += &format!(r#"{{"q":{q:?},"qd":{qd:?},"tau":{tau:?},"{base}":{six:?},"base_wrench":{wrench:?}}}"#);
        lines += "\n";
    }
    lines
}

/// The same with `--compiled` and without it: output, errors, exit code.
fn answers_are_the_same(robot: &str, options: &[&str], states: &str) -> Output {
    let arguments = [&["eval", robot], options].concat();
    let (core, compiled) = (frs(&arguments, states), frs(&[&arguments[..], &["--compiled"]].concat(), states));
    assert!(core.stdout == compiled.stdout, "{robot}: the answers differ");
    assert_eq!((core.status, core.stderr), (compiled.status, compiled.stderr.clone()), "{robot}");
    compiled
}

#[test]
fn compiled_answers_are_the_same_byte_for_byte() {
    for (robot, n) in [("lwr_satellite", 7), ("dual_arm_satellite", 13), ("planar_three_link", 2)] {
        let robot = Path::new(env!("CARGO_MANIFEST_DIR")).join("robots").join(robot).with_extension("urdf");
        let output = answers_are_the_same(&robot.display().to_string(), &["--states", "-"], &states(n));
        assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
        assert_eq!(output.stdout.iter().filter(|&&byte| byte == b'\n').count(), 41);
    }
}

#[test]
fn compiled_tables_and_chosen_keys_are_the_same() {
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/chaser.urdf");
    for options in [&[][..], &["--json"], &["--only", "curvature,energy,hamel_c"]] {
        assert!(!answers_are_the_same(robot, options, "").stdout.is_empty());
    }
}

#[test]
fn a_state_without_an_answer_is_told_in_the_same_words() {
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/lwr_satellite.urdf");
    let output = answers_are_the_same(robot, &["--states", "-"], "{\"mu\":[1e200,1e200,0,0,0,0]}\n{}\n");
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stdout).unwrap().contains("is not finite"));
}

/// A scene of the project for a longer time: its table as it was computed on the way with machine code, and by the core alone.
#[test]
fn a_run_that_goes_on_in_machine_code_has_the_bits_of_the_core() {
    for (name, duration) in [("tumbling", "30"), ("thrown", "20"), ("underwater", "30")] {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("compiled").join(name);
        std::fs::create_dir_all(&folder).unwrap();
        let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
        let text = std::fs::read_to_string(scenes.join(name).with_extension("toml")).unwrap();
        let text = format!("accuracy = 1e-13\n{text}");
        let lines = text.lines().enumerate().map(|(i, line)| match line.split_once('=').map(|(key, _)| key.trim()) {
            Some("duration") => format!("duration = {duration}"),
            Some("accuracy") if i > 0 => String::new(),
            Some("robot") => {
                let robot = line.split('"').nth(1).unwrap();
                format!("robot = \"{}\"", scenes.join(robot).display())
            }
            _ => line.to_owned(),
        });
        let scene = folder.join("scene.toml");
        std::fs::write(&scene, lines.collect::<Vec<_>>().join("\n")).unwrap();
        let output = frs(&["simulate", scene.to_str().unwrap(), "--out", folder.to_str().unwrap(), "--json"], "");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let told: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(told["machine_codes"].as_u64() > Some(0), "{told}");

        let text = std::fs::read_to_string(&scene).unwrap();
        let robot = text.lines().find_map(|line| line.strip_prefix("robot = ")).unwrap().trim_matches('"');
        let model = frs::Model::from_urdf(&std::fs::read_to_string(robot).unwrap()).unwrap();
        let scene = frs_sim::scene::Scene::parse("scene.toml", &text, &model).unwrap();
        let core = frs_sim::run::run(&scene, &model, |_| std::ops::ControlFlow::Continue(()));
        let table = std::fs::read_to_string(folder.join("trajectory.csv")).unwrap();
        let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
        let q = names.iter().position(|name| name.starts_with("q.")).unwrap();
        assert_eq!(table.lines().count(), core.samples.len() + 1);
        for (line, sample) in table.lines().skip(1).zip(&core.samples) {
            let numbers: Vec<f64> = line.split(',').map(|number| number.parse().unwrap()).collect();
            let place: [f64; 3] = sample.pose.translation.into();
            let shape = [&sample.q[..], &sample.qd].concat();
            assert!(numbers[1..4] == place && numbers[q..q + shape.len()] == shape, "{name} at {} s", sample.time);
        }
    }
}

/// Of the same settings, code made for the scene gives the very motion and fewer operations.
#[test]
fn a_studied_motion_in_machine_code_is_that_of_the_core() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("compiled").join("study");
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/thrown.toml");
    let output = frs(&["accuracy", scene.to_str().unwrap(), "--counts", "--out", folder.to_str().unwrap()], "");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let table = std::fs::read_to_string(folder.join("accuracy.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
    // method, pace, equations, route, scalar, [evaluation], accuracy, step, four errors, evaluations, operations
    let settings = |row: &[&str]| [&row[..5], &row[6..8]].concat().join(",");
    let (compiled, core): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row[5] == "compiled");
    let mut pairs = 0;
    for by_code in &compiled {
        if let Some(by_core) = core.iter().find(|row| settings(row) == settings(by_code)) {
            pairs += 1;
            assert_eq!(by_code[8..13], by_core[8..13], "{}", settings(by_code));
            let [fewer, more] = [by_code, by_core].map(|row| row[13].parse::<usize>().unwrap());
            assert!(fewer < more, "{}", settings(by_code));
        }
    }
    assert!(pairs > 50, "{pairs} pairs of {}", compiled.len());
}
