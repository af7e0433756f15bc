//! `frs diff`: what a change of a robot changes in its generated code, in words.

mod code;
mod report;
mod robot;

use std::path::{Path, PathBuf};

use clap::Args;
use frs::{Model, urdf};
use frs_codegen::{GenerateError, Options};

use self::code::CodeChanges;
use self::report::Report;
use self::robot::RobotChanges;
use super::options::GenerateArgs;
use super::{Failure, RobotArgs, read};

/// Explain a change of a robot in words.
///
/// Compares two URDFs: which links, joints and coordinates came, went or got another name, which numbers moved and how far,
/// and what of that does not matter to the dynamics. Then compares the code that would be generated for the two: whether a
/// function stays as it is, changes its constants alone, or changes its structure, and what it costs before and after.
///
/// Products with 0, 1 and −1 are no operations of generated code: a number that comes to be one of these, or ceases to be,
/// changes the structure. Something has got another name if it is gone, and something new has the same numbers in the same place.
#[derive(Args)]
#[command(after_help = "Exit codes: 0 the two could be compared, whether they differ or not; 2 bad input.")]
pub struct Diff {
    /// The robot before the change.
    #[arg(value_name = "OLD.urdf")]
    old: PathBuf,
    /// The robot after it.
    #[arg(value_name = "NEW.urdf")]
    new: PathBuf,
    /// Take this link of both as the base instead of the roots of the files.
    #[arg(long, value_name = "LINK")]
    root: Option<String>,
    /// Warn about, instead of refuse, inertias that violate the triangle inequality.
    #[arg(long)]
    lenient: bool,
    #[command(flatten)]
    options: GenerateArgs,
    /// Write the result as JSON instead of words and tables.
    #[arg(long)]
    json: bool,
}

/// One of the two robots.
struct Side<'a> {
    path: &'a Path,
    description: frs::model::RobotDescription,
    model: Model,
}

impl Diff {
    pub fn run(self) -> Result<(), Failure> {
        let options = Options { standalone: true, ..self.options.options()? };
        let sides = [self.side(&self.old)?, self.side(&self.new)?];
        let invalid = |side: &Side, error: GenerateError| Failure::Input(format!("{}: {error}", side.path.display()));
        let [old, new] = &sides;
        let free = |side: &Side| -> Result<Model, Failure> {
            options.specialise(&side.model).map_err(|error| invalid(side, error))
        };
        let robot = RobotChanges::new([&old.description, &new.description], [&free(old)?, &free(new)?]);
        let [old_code, new_code] =
            [old, new].map(|side| code::functions(&side.model, &options).map_err(|error| invalid(side, error)));
        let code = CodeChanges::new(old_code?, new_code?, &robot.renamed_links);
        let report = Report { paths: [old.path, new.path], robot: &robot, code: &code };
        Ok(report.write(self.json)?)
    }

    fn side<'a>(&'a self, path: &'a Path) -> Result<Side<'a>, Failure> {
        let robot = RobotArgs { robot: path.to_owned(), root: self.root.clone(), lenient: self.lenient };
        let model = robot.model()?;
        let file = path.display().to_string();
        let options = urdf::Options { file: &file, root: self.root.as_deref(), lenient: self.lenient };
        let description = urdf::parse(&read(path)?, &options).map_err(|error| Failure::Input(error.to_string()))?;
        Ok(Side { path, description, model })
    }
}
