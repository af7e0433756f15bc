//! `frs generate`: a robot as specialised Rust.

use std::path::{Path, PathBuf};

use clap::Args;
use frs::{Model, Quantity};
use frs_codegen::fresh::{self, Freshness};
use frs_codegen::{Generated, Options, generate};

use super::options::GenerateArgs;
use super::{Failure, RobotArgs};

/// Turn a robot into specialised Rust that equals the core bit for bit.
///
/// Writes a module: one function per quantity, straight-line code named after the robot and the mathematics, with its
/// operation counts on top. It stands on the crate frs-core, or with --standalone on nothing.
#[derive(Args)]
pub struct Generate {
    #[command(flatten)]
    robot: Option<RobotArgs>,
    #[command(flatten)]
    options: GenerateArgs,
    /// Write plain functions that need no other crate: rustc alone compiles them.
    #[arg(long)]
    standalone: bool,
    /// Where to write; without it, standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write the checked-in code of every robot in robots/ (run it at the top of the repository).
    #[arg(long, conflicts_with_all = ["robot", "output", "standalone"])]
    all: bool,
    /// Write nothing: check that what would be written is what is there. Exit code 1 if not.
    #[arg(long)]
    check: bool,
}

/// A robot whose code is checked in, and its quantities; `None` for all.
type CheckedIn = (&'static str, Option<&'static [Quantity]>);

/// Of the humanoid what a simulation needs: all of it would be ten megabytes.
const SIMULATED: [Quantity; 6] = [
    Quantity::Inertia,
    Quantity::Momentum,
    Quantity::VelocityOfMomentum,
    Quantity::BaseTwist,
    Quantity::ForwardDynamics,
    Quantity::StateRate,
];

/// The robots of robots/.
const CHECKED_IN: [CheckedIn; 6] = [
    ("chaser", None),
    ("dual_arm_satellite", None),
    ("humanoid", Some(&SIMULATED)),
    ("lwr_satellite", None),
    ("planar_three_link", None),
    ("quadruped", None),
];

impl Generate {
    pub fn run(self) -> Result<(), Failure> {
        if self.all {
            return self.all();
        }
        let Some(robot) = &self.robot else {
            return Err(Failure::Input("no robot; expected ROBOT.urdf, or --all for the checked-in robots".into()));
        };
        let model = robot.model()?;
        let options = Options { standalone: self.standalone, ..self.options.options()? };
        let generated = generated(&model, &options)?;
        match &self.output {
            None => print_text(&generated.text()),
            Some(path) => {
                let stale = self.settle(path, &generated.text())?;
                self.judge(stale.into_iter().collect())
            }
        }
    }

    fn all(&self) -> Result<(), Failure> {
        let mut library = String::from(
            "//! Generated code of the robots in `robots/`, checked in so that changes are reviewed as diffs.\n//!\n\
             //! `frs generate --all` writes it, `frs generate --all --check` checks it; docs/generated.md says how to read it.\n\n",
        );
        let mut stale = Vec::new();
        for (name, outputs) in CHECKED_IN {
            let path = PathBuf::from(format!("robots/{name}.urdf"));
            let model = RobotArgs { robot: path, root: None, lenient: false }.model()?;
            let options = Options { outputs: outputs.map(<[Quantity]>::to_vec), ..Options::default() };
            let text = generated(&model, &options)?.text();
            stale.extend(self.settle(Path::new(&format!("generated/src/{name}.rs")), &text)?);
            library += &format!("#[rustfmt::skip] // laid out by the generator\npub mod {name};\n");
        }
        stale.extend(self.settle(Path::new("generated/src/lib.rs"), &library)?);
        self.judge(stale)
    }

    /// Writes or checks a file; what is stale, in words.
    fn settle(&self, path: &Path, text: &str) -> Result<Option<String>, Failure> {
        let settled = if self.check { fresh::check(path, text) } else { fresh::write(path, text) };
        let settled = settled.map_err(|error| {
            Failure::Input(format!(
                "{}: cannot be {}: {error}",
                path.display(),
                if self.check { "read" } else { "written" }
            ))
        })?;
        Ok(match settled {
            Freshness::Fresh => None,
            Freshness::Written => {
                eprintln!("wrote {}", path.display());
                None
            }
            Freshness::Stale { line, found, expected } => {
                let told = |line: Option<String>| line.unwrap_or_else(|| "(nothing)".into());
                Some(format!("{}:{line}:\n  - {}\n  + {}", path.display(), told(found), told(expected)))
            }
        })
    }

    fn judge(&self, stale: Vec<String>) -> Result<(), Failure> {
        if stale.is_empty() {
            return Ok(());
        }
        let command = std::env::args().filter(|argument| argument != "--check").skip(1).collect::<Vec<_>>().join(" ");
        Err(Failure::Check(format!(
            "generated code is not what its robot gives (- what is there, + what should be):\n{}\nrun: frs {command}",
            stale.join("\n")
        )))
    }
}

fn generated(model: &Model, options: &Options) -> Result<Generated, Failure> {
    generate(model, options).map_err(|error| Failure::Input(error.to_string()))
}

fn print_text(text: &str) -> Result<(), Failure> {
    use std::io::Write;
    Ok(std::io::stdout().lock().write_all(text.as_bytes())?)
}
