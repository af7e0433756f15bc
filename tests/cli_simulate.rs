//! `frs simulate` and `frs explain`, as a person or a program meets them.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// An empty folder of its own.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("simulate").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

fn frs(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_frs")).current_dir(ROOT).args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// A scene in a folder of its own, beside a copy of the robot.
fn scene(name: &str, rest: &str) -> PathBuf {
    let folder = folder(name);
    std::fs::copy(Path::new(ROOT).join("robots/lwr_satellite.urdf"), folder.join("robot.urdf")).unwrap();
    let path = folder.join("scene.toml");
    std::fs::write(&path, format!("robot = 'robot.urdf'\nduration = 0.5\n{rest}")).unwrap();
    path
}

#[test]
fn a_table_and_pictures_are_written_and_told() {
    let out = folder("written").join("made");
    let output = frs(&["simulate", "scenes/paper.toml", "--out", out.to_str().unwrap()]);
    let told = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(told.contains("momentum") && told.contains("driven") && told.contains("trajectory.csv"), "{told}");
    let pictures = ["energy", "locked_velocity", "momentum", "shape", "shape_rates", "torques"];
    for picture in pictures {
        let drawn = std::fs::read_to_string(out.join(picture).with_extension("svg")).unwrap();
        assert!(drawn.starts_with("<svg") && drawn.ends_with("</svg>\n") && !drawn.contains("NaN"), "{picture}");
    }
    assert_eq!(std::fs::read_dir(&out).unwrap().count(), pictures.len() + 1, "and nothing beside");

    let table = std::fs::read_to_string(out.join("trajectory.csv")).unwrap();
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| names.iter().position(|n| *n == name).unwrap_or_else(|| panic!("{name} in {names:?}"));
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|number| number.parse().unwrap()).collect()).collect();
    assert_eq!(rows.len(), 801);
    assert!(rows.iter().all(|row| row.len() == names.len()));
    assert_eq!((rows[0][column("time")], rows[800][column("time")]), (0.0, 4.0));
    assert_eq!(rows[0][column("mu.omega_y")], 0.20943951023931953);
    assert_eq!(rows[0][column("q.joint_4")], 1.0);
    // The base turns about its y axis: −sin of the angle stands in row z, column x.
    assert!(rows[100][column("pose.r_zx")] < -0.09 && rows[100][column("pose.r_xz")] > 0.09);
}

#[test]
fn json_tells_the_invariants() {
    let path = scene("json", "[start]\nmomentum = [0.5, 0, 0.2, 0, 0, 0]");
    let out = path.with_file_name("out");
    let output = frs(&["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap(), "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((told["momentum"].as_str(), told["end"].as_str()), (Some("conserved"), Some("whole")));
    assert_eq!((told["time"].as_f64(), told["samples"].as_u64()), (Some(0.5), Some(51)));
    assert!(told["momentum_change"].as_f64().unwrap() < 1e-13 && told["energy_difference"].as_f64().unwrap() < 1e-7);
}

#[test]
fn a_motion_that_cannot_go_on_is_kept_and_is_exit_code_1() {
    let path = scene("wild", "[start]\nqd = { joint_2 = 1e200 }");
    let out = path.with_file_name("out");
    let output = frs(&["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(told.contains("t = 0 s: the motion is not finite") && told.contains("is written"), "{told}");
    assert_eq!(std::fs::read_to_string(out.join("trajectory.csv")).unwrap().lines().count(), 2);
}

#[test]
fn bad_scenes_are_exit_code_2_with_their_place() {
    let unknown = scene("unknown", "[start]\nq = { joint_0 = 1 }");
    let missing = scene("missing", "");
    std::fs::remove_file(missing.with_file_name("robot.urdf")).unwrap();
    for (path, expected) in [
        (unknown.as_path(), "scene.toml:4:7: start.q.joint_0: unknown key; did you mean 'joint_"),
        (missing.as_path(), "scene.toml:1:9: robot: "),
        (Path::new("scenes/none.toml"), "scenes/none.toml: cannot be read"),
    ] {
        let out = folder("refused");
        for arguments in [
            &["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap()][..],
            &["explain", path.to_str().unwrap()],
        ] {
            let output = frs(arguments);
            let told = text(&output.stderr);
            assert_eq!(output.status.code(), Some(2), "{told}");
            assert!(told.contains(expected), "{told}");
        }
        assert_eq!(std::fs::read_dir(out).unwrap().count(), 0);
    }
}

#[test]
fn explain_tells_what_is_computed_and_what_is_not() {
    for (name, expected) in [
        (
            "paper",
            &[
                "[base_wrench], line",
                "Momentum: driven",
                "from 0.51 s to 0.55 s",
                "20 numbers",
                "Λ_b μ̇ = F₁",
                "gravity, joint_torque, friction, spring",
            ][..],
        ),
        (
            "tumbling",
            &["[spring], line 14", "Momentum: conserved", "14 numbers", "μ = Λ_b⁻¹ Ad_{g₁}ᵀ J", "the equation of μ"],
        ),
        ("reach", &["[regulator], line", "Momentum: zero", "Λ_q q̈ = τ − Γ'_q(q̇) q̇\n", "all terms with μ"]),
    ] {
        let output = frs(&["explain", &format!("scenes/{name}.toml")]);
        let told = text(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        for part in expected {
            assert!(told.contains(part), "{name}: '{part}' in\n{told}");
        }
    }
}
