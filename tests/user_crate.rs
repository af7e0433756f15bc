//! `frs_model!` in a stranger's crate, outside the workspace, which knows `frs` by another name.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Mutex, MutexGuard};

const HERE: &str = env!("CARGO_MANIFEST_DIR");

/// A copy of the crate, to be changed. All copies are built in one place, so there is one copy at a time.
struct UserCrate {
    directory: PathBuf,
    _alone: MutexGuard<'static, ()>,
}

impl UserCrate {
    fn new(name: &str) -> Self {
        static ALONE: Mutex<()> = Mutex::new(());
        let _alone = ALONE.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("user_crates").join(name);
        let crate_ = Self { directory, _alone };
        fs::create_dir_all(crate_.file("src")).unwrap();
        for file in ["Cargo.toml", "arm.urdf", "src/main.rs"] {
            fs::copy(Path::new(HERE).join("tests/user_crate").join(file), crate_.file(file)).unwrap();
        }
        crate_.change("Cargo.toml", "../..", HERE);
        // Versions that are here already: nothing is downloaded.
        fs::copy(Path::new(HERE).join("Cargo.lock"), crate_.file("Cargo.lock")).unwrap();
        crate_
    }

    fn file(&self, name: &str) -> PathBuf {
        self.directory.join(name)
    }

    fn change(&self, file: &str, before: &str, after: &str) {
        let text = fs::read_to_string(self.file(file)).unwrap();
        assert!(text.contains(before), "{file} has no {before}");
        fs::write(self.file(file), text.replace(before, after)).unwrap();
    }

    fn run(&self) -> Output {
        let mut cargo = Command::new(env!("CARGO"));
        // What the outer cargo says of this package, or was told about flags, is not for the inner one.
        for (name, _) in std::env::vars_os() {
            let name = name.to_string_lossy();
            if name == "RUSTFLAGS" || name.starts_with("CARGO_") && name != "CARGO_HOME" {
                cargo.env_remove(&*name);
            }
        }
        let target = self.directory.with_file_name("target");
        cargo.args(["run", "--offline", "--quiet", "--color=never", "--target-dir"]).arg(target);
        cargo.current_dir(&self.directory).output().unwrap()
    }

    /// What it prints when it succeeds.
    fn prints(&self) -> String {
        let Output { status, stdout, stderr } = self.run();
        let [stdout, stderr] = [stdout, stderr].map(|text| String::from_utf8(text).unwrap());
        assert!(status.success(), "{stdout}{stderr}");
        stdout
    }
}

#[test]
fn a_stranger_gets_the_bits_of_the_recursion() {
    assert_eq!(UserCrate::new("bits").prints(), "2 coordinates, 45.5 kg, bit for bit: [true, true]\n");
}

#[test]
fn a_changed_urdf_is_compiled_again() {
    let user = UserCrate::new("changed");
    // The macro alone shall say that the crate stands on the file.
    user.change("src/main.rs", r#"include_str!("../arm.urdf")"#, r#"&std::fs::read_to_string("arm.urdf").unwrap()"#);
    let before = user.prints();
    user.change("arm.urdf", r#"<mass value="4"/>"#, r#"<mass value="5"/>"#);
    assert_eq!(
        (before.contains("45.5 kg"), user.prints().contains("46.5 kg, bit for bit: [true, true]")),
        (true, true)
    );
}

#[test]
fn a_missing_urdf_is_told_with_the_place_looked_at() {
    let user = UserCrate::new("missing");
    user.change("src/main.rs", r#"mod arm = "arm.urdf""#, r#"mod arm = "robots/arm.urdf""#);
    let complaints = String::from_utf8(user.run().stderr).unwrap();
    let full = user.file("robots/arm.urdf").display().to_string();
    let told = format!("error: file 'robots/arm.urdf': {full} cannot be read: ");
    assert!(complaints.contains(&told) && complaints.contains("CARGO_MANIFEST_DIR"), "{complaints}");
    assert!(complaints.contains(r#" | robots::frs_model!(mod arm = "robots/arm.urdf""#), "{complaints}");
}
