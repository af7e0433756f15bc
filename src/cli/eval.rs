//! `frs eval`: every quantity of a robot at given states.

mod batch;
#[cfg(feature = "jit")]
mod compiled;
mod evaluation;

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use frs::{Model, Workspace};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::answer::{Key, Value};
use super::state::State;
use super::{Failure, RobotArgs, table};
use evaluation::Evaluation;

/// Evaluate every quantity of a robot at given states.
///
/// Twists are [ω; v] and wrenches [moment; force], angular part first, body-fixed in the root link's frame.
///
/// States are JSON lines, all fields optional and zero by default:
///   {"q":[…], "qd":[…], "mu":[6] or "base_twist":[6], "base_wrench":[6], "tau":[…]}
/// q, qd and tau may also be objects, {"joint name": value}.
/// Each state gives one JSON line; matrices are arrays of rows. A state in which the robot is singular gives
/// {"error": …} and exit code 1.
///
/// Millions of states: --batch, from and to .npy or .parquet (docs/batch.md).
#[derive(Args)]
#[command(verbatim_doc_comment)]
pub struct Eval {
    #[command(flatten)]
    robot: RobotArgs,
    /// File of states, one JSON object per line; - reads standard input. Without it: the zero pose.
    #[arg(long, value_name = "FILE|-")]
    states: Option<PathBuf>,
    /// Compute only these quantities.
    #[arg(long, value_name = "KEY,…", value_delimiter = ',')]
    only: Option<Vec<Key>>,
    #[command(flatten)]
    batch: batch::BatchArgs,
    /// Without --states: write the zero pose as a JSON line instead of tables. With --batch: print the summary as a JSON object.
    #[arg(long, conflicts_with = "states")]
    json: bool,
    /// Let machine code answer that is compiled on the spot: the same bytes. Reading and writing numbers takes most of the time
    /// either way.
    #[cfg(feature = "jit")]
    #[arg(long)]
    compiled: bool,
}

impl Eval {
    pub fn run(self) -> Result<(), Failure> {
        let model = self.robot.model()?;
        if self.batch.is_asked() {
            return self.batch.run(&model, self.json);
        }
        let keys = self.only.clone().unwrap_or_else(|| Key::value_variants().to_vec());
        let mut evaluate = self.answering(&model, &keys);
        let mut out = BufWriter::new(io::stdout().lock());
        let Some(path) = &self.states else {
            let answers = evaluate(&State::zero(&model)).judged(&model, &keys);
            if self.json {
                write_line(&mut out, &Line { model: &model, keys: &keys, answers: &answers })?;
            } else {
                if let Ok(values) = &answers {
                    table::quantities(&mut out, &model, &keys, values)?;
                }
            }
            out.flush()?;
            return answers.map(drop).map_err(|error| Failure::Check(format!("the zero pose: {error}")));
        };
        let (name, lines) = open(path)?;
        let mut singular = 0;
        for (number, line) in lines.lines().enumerate() {
            let place = format!("{name}:{}", number + 1);
            let line = line.map_err(|error| Failure::Input(format!("{place}: cannot be read: {error}")))?;
            if line.trim().is_empty() {
                continue;
            }
            let parsed = State::parse(&line, &model);
            let state = match parsed {
                Ok(state) => state,
                Err(message) => {
                    out.flush()?;
                    return Err(Failure::Input(format!("{place}:{message}")));
                }
            };
            let answers = evaluate(&state).judged(&model, &keys);
            singular += usize::from(answers.is_err());
            write_line(&mut out, &Line { model: &model, keys: &keys, answers: &answers })?;
        }
        out.flush()?;
        match singular {
            0 => Ok(()),
            count => Err(Failure::Check(format!("{count} states could not be answered; their lines say why"))),
        }
    }
}

/// Computes quantities at a state.
type Answering<'r> = Box<dyn FnMut(&State) -> Evaluation<f64> + 'r>;

impl Eval {
    /// The core, or machine code that gives the same bits.
    fn answering<'r>(&self, model: &'r Model, keys: &'r [Key]) -> Answering<'r> {
        #[cfg(feature = "jit")]
        if self.compiled {
            match compiled::Compiled::new(model, keys) {
                Ok(mut compiled) => return Box::new(move |state| compiled.evaluate(state)),
                Err(error) => eprintln!("note: {error}; the core answers instead"),
            }
        }
        let mut work = Workspace::new(model);
        // No −0 is shown.
        Box::new(move |state| Evaluation::new(&mut work, state, keys).map(|x| x + 0.0))
    }
}

fn open(path: &Path) -> Result<(String, Box<dyn BufRead>), Failure> {
    if path == Path::new("-") {
        return Ok(("standard input".into(), Box::new(io::stdin().lock())));
    }
    let name = path.display().to_string();
    let file = File::open(path).map_err(|error| Failure::Input(format!("{name}: cannot be opened: {error}")))?;
    Ok((name, Box::new(BufReader::new(file))))
}

/// One line of output: the joints' names and the quantities, or the error.
struct Line<'a> {
    model: &'a Model,
    keys: &'a [Key],
    answers: &'a Result<Vec<Value>, String>,
}

impl Serialize for Line<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        match self.answers {
            Err(error) => map.serialize_entry("error", error)?,
            Ok(values) => {
                let names: Vec<&str> = self.model.coordinates().iter().map(|c| c.name.as_str()).collect();
                map.serialize_entry("joints", &names)?;
                for (key, value) in self.keys.iter().zip(values) {
                    map.serialize_entry(&key.name(), value)?;
                }
            }
        }
        map.end()
    }
}

fn write_line(out: &mut impl Write, line: &Line) -> io::Result<()> {
    serde_json::to_writer(&mut *out, line)?;
    writeln!(out)
}
