//! The paper's example from end to end, by the commands that do it: is the generated code right, and what happens?

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::Path;

use super::{Failure, execute, write};

/// Where everything goes, in the current folder.
pub const FOLDER: &str = "frs-paper";

/// The scene, beside its robot; both are in the program.
const SCENE: &str = include_str!("../../scenes/paper.toml");

pub fn run() -> Result<(), Failure> {
    let folder = Path::new(FOLDER);
    let (robot, scene) = (folder.join("robots/lwr_satellite.urdf"), folder.join("scenes/paper.toml"));
    write(&robot, frs::urdf::LWR_SATELLITE)?;
    write(&scene, SCENE)?;
    command(["verify".into(), robot.into(), "--states".into(), "1000".into()])?;
    command(["explain".into(), scene.clone().into()])?;
    command(["simulate".into(), scene.into(), "--out".into(), folder.into()])?;
    Ok(writeln!(io::stdout().lock(), "\nopen {} in a browser\n", folder.join("report.html").display())?)
}

/// Shows a command and executes it.
fn command<const N: usize>(arguments: [OsString; N]) -> Result<(), Failure> {
    let shown = arguments.each_ref().map(|argument| argument.to_string_lossy());
    writeln!(io::stdout().lock(), "\n$ frs {}", shown.join(" "))?;
    execute(arguments)
}
