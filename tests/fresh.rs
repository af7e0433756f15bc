//! The checked-in generated code is what the robots give.

use std::process::Command;

#[test]
fn checked_in_code_is_what_the_robots_give() {
    let output = Command::new(env!("CARGO_BIN_EXE_frs"))
        .args(["generate", "--all", "--check"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn stale_code_is_told_with_its_line_and_the_command_that_mends_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("arm.rs");
    let generate = |check: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_frs"))
            .args(["generate", "robots/planar_three_link.urdf", "--outputs", "inertia", "-o", file.to_str().unwrap()])
            .args(check)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .output()
            .unwrap()
    };
    assert!(generate(&[]).status.success());
    assert!(generate(&["--check"]).status.success());
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replacen("pub const DOF: usize = 2;", "pub const DOF: usize = 3;", 1)).unwrap();
    let stale = generate(&["--check"]);
    let told = String::from_utf8(stale.stderr).unwrap();
    assert_eq!(stale.status.code(), Some(1), "{told}");
    assert!(told.contains("- pub const DOF: usize = 3;") && told.contains("+ pub const DOF: usize = 2;"), "{told}");
    assert!(told.contains("run: frs generate robots/planar_three_link.urdf"), "{told}");
    assert!(!std::fs::exists(file.with_extension("rs.new")).unwrap());
}
