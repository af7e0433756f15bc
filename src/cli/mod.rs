//! The command line: one file per subcommand.
//!
//! Exit codes: 0 ok, 1 a check failed, 2 bad input.

mod accuracy;
mod answer;
mod check;
#[cfg(feature = "jit")]
mod compiled;
mod curvature;
mod diff;
mod eval;
mod example;
mod explain;
mod generate;
mod options;
mod oracle;
mod overview;
mod parquet;
mod recording;
mod scene;
mod simulate;
mod state;
mod svg;
mod table;
mod verify;

use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use frs::Model;
use frs::urdf::Options;
use frs_codegen::fresh;

/// Reduced Euler-Lagrange dynamics of floating-base robots.
///
/// Without a subcommand: shows the default robot, a satellite with a seven-joint arm, checks every identity of its equations on
/// random states, and runs the example of the paper from end to end: generated code against the core, motion, and report, into
/// the folder frs-paper.
#[derive(Parser)]
#[command(version, after_help = "Exit codes: 0 ok, 1 a check failed, 2 bad input.")]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    Eval(eval::Eval),
    Generate(generate::Generate),
    Verify(verify::Verify),
    Diff(diff::Diff),
    Curvature(curvature::Curvature),
    Oracle(oracle::Oracle),
    Simulate(simulate::Simulate),
    Explain(explain::Explain),
    Accuracy(accuracy::Accuracy),
    Check(check::Check),
}

/// The robot, and how to read it.
#[derive(Args)]
struct RobotArgs {
    /// The robot's URDF file.
    #[arg(value_name = "ROBOT.urdf")]
    robot: PathBuf,
    /// Take this link as the base instead of the root of the file.
    #[arg(long, value_name = "LINK")]
    root: Option<String>,
    /// Warn about, instead of refuse, inertias that violate the triangle inequality.
    #[arg(long)]
    lenient: bool,
}

/// Why a command stopped; each reason has its exit code.
enum Failure {
    /// A check did not hold; what it was has been printed. Exit code 1.
    Check(String),
    /// The input cannot be used. Exit code 2.
    Input(String),
    /// Whoever reads our output has stopped reading: not an error.
    OutputClosed,
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        match error.kind() {
            std::io::ErrorKind::BrokenPipe => Self::OutputClosed,
            _ => Self::Input(format!("the output cannot be written: {error}")),
        }
    }
}

impl RobotArgs {
    /// Reads the robot; warnings go to standard error.
    fn model(&self) -> Result<Model, Failure> {
        let text = read(&self.robot)?;
        let file = self.robot.display().to_string();
        let options = Options { file: &file, root: self.root.as_deref(), lenient: self.lenient };
        let model = Model::from_urdf_with(&text, &options).map_err(|error| Failure::Input(error.to_string()))?;
        for warning in model.warnings() {
            eprintln!("warning: {warning}");
        }
        Ok(model)
    }
}

fn read(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path).map_err(|error| {
        Failure::Input(format!("{}: cannot be read: {error}; check the path and that it is UTF-8 text", path.display()))
    })
}

/// Writes beside and renames: an interrupted run leaves no half of a file.
fn write(path: &Path, text: &str) -> Result<(), Failure> {
    fresh::write(path, text).map(drop).map_err(|error| not_written(path, &error))
}

/// The same for what is no text, into a folder that is there.
fn write_bytes(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".new");
    let written = std::fs::write(&beside, bytes).and_then(|()| std::fs::rename(&beside, path));
    written.map_err(|error| not_written(path, &error))
}

fn not_written(path: &Path, error: &io::Error) -> Failure {
    Failure::Input(format!("{}: cannot be written: {error}; --out takes a folder that can be made", path.display()))
}

/// Executes a command that is given by its arguments.
fn execute(arguments: impl IntoIterator<Item = OsString>) -> Result<(), Failure> {
    match Cli::parse_from(std::iter::once("frs".into()).chain(arguments)).command {
        None => overview::run(),
        Some(Command::Eval(eval)) => eval.run(),
        Some(Command::Generate(generate)) => generate.run(),
        Some(Command::Verify(verify)) => verify.run(),
        Some(Command::Diff(diff)) => diff.run(),
        Some(Command::Curvature(curvature)) => curvature.run(),
        Some(Command::Oracle(oracle)) => oracle.run(),
        Some(Command::Simulate(simulate)) => simulate.run(),
        Some(Command::Explain(explain)) => explain.run(),
        Some(Command::Accuracy(accuracy)) => accuracy.run(),
        Some(Command::Check(check)) => check.run(),
    }
}

/// Runs the command line and says how it ended.
pub fn run() -> ExitCode {
    let result = execute(std::env::args_os().skip(1));
    match result {
        Ok(()) | Err(Failure::OutputClosed) => ExitCode::SUCCESS,
        Err(Failure::Check(message)) => {
            eprintln!("{message}");
            ExitCode::from(1)
        }
        Err(Failure::Input(message)) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}
