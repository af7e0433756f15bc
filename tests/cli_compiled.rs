//! `frs eval --compiled` answers as `frs eval` does, byte for byte.

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
