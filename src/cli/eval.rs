//! `frs eval`: every quantity of a robot at given states.

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use frs::nalgebra::DMatrix;
use frs::{Model, Moving, Shape, Workspace};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::answer::{Key, Value};
use super::state::{BaseMotion, State};
use super::{Failure, RobotArgs, table};

/// Evaluate every quantity of a robot at given states.
///
/// Twists are [ω; v] and wrenches [moment; force], angular part first, body-fixed in the root link's frame.
///
/// States are JSON lines, all fields optional and zero by default:
///   {"q":[…], "qd":[…], "mu":[6] or "base_twist":[6], "base_wrench":[6], "tau":[…]}
/// q, qd and tau may also be objects, {"joint name": value}.
/// Each state gives one JSON line; matrices are arrays of rows. A state in which the robot is singular gives
/// {"error": …} and exit code 1.
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
    /// Without --states: write the zero pose as a JSON line instead of tables.
    #[arg(long, conflicts_with = "states")]
    json: bool,
}

impl Eval {
    pub fn run(self) -> Result<(), Failure> {
        let model = self.robot.model()?;
        let keys = self.only.unwrap_or_else(|| Key::value_variants().to_vec());
        let mut work = Workspace::new(&model);
        let mut out = BufWriter::new(io::stdout().lock());
        let Some(path) = self.states else {
            let answers = evaluate(&mut work, &State::zero(&model), &keys);
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
        let (name, lines) = open(&path)?;
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
            let answers = evaluate(&mut work, &state, &keys);
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

fn open(path: &Path) -> Result<(String, Box<dyn BufRead>), Failure> {
    if path == Path::new("-") {
        return Ok(("standard input".into(), Box::new(io::stdin().lock())));
    }
    let name = path.display().to_string();
    let file = File::open(path).map_err(|error| Failure::Input(format!("{name}: cannot be opened: {error}")))?;
    Ok((name, Box::new(BufReader::new(file))))
}

/// The quantities at a state, or why the state has no answer.
fn evaluate(work: &mut Workspace, state: &State, keys: &[Key]) -> Result<Vec<Value>, String> {
    let mut shape = work.shape(&state.q);
    if !is_definite(&shape) {
        return Err(
            "the locked inertia Λ_b is singular in this shape: all mass lies on one line, or a number overflowed; \
                    no locked velocity is determined. Move the joints off this shape or give a link its thickness"
                .into(),
        );
    }
    if keys.contains(&Key::XiDot) {
        let mut shape_inertia = DMatrix::zeros(state.q.len(), state.q.len());
        shape.shape_inertia(&mut shape_inertia);
        if let Some(joint) = undetermined(&shape_inertia, shape.model()) {
            return Err(format!(
                "the shape inertia Λ_q is singular in this shape: nothing resists the motion of joint '{joint}'; no \
                 acceleration is determined. Leave xi_dot out with --only, or give the joint's links their inertia"
            ));
        }
    }
    let mut motion: Moving = shape.moving(&state.qd);
    let mu = match state.base {
        BaseMotion::Locked(mu) => mu,
        BaseMotion::Base(base_twist) => motion.locked_velocity(base_twist),
    };
    let answers: Vec<Value> = keys.iter().map(|key| key.answer(&mut motion, mu, state)).collect();
    match answers.iter().zip(keys).find(|(value, _)| !value.is_finite()) {
        None => Ok(answers),
        Some((_, key)) => Err(format!(
            "{} is not finite: the numbers of this state are too large for double precision; check the units",
            key.name()
        )),
    }
}

/// Relative size below which a pivot of a factored inertia is rounding: a few times n ε for n of hundreds.
const SINGULAR_PIVOT: f64 = 1e-14;

/// Whether the locked rotational inertia is positive definite to working precision; false for what is not finite.
fn is_definite(shape: &Shape) -> bool {
    let (inertia, inverse_pivots) = (shape.locked_rotational_inertia(), shape.locked_inverse_pivots());
    let diagonal = [inertia.xx, inertia.yy, inertia.zz];
    diagonal.iter().zip(&inverse_pivots).all(|(own, inverse)| 1.0 / inverse > SINGULAR_PIVOT * own)
}

/// The coordinate whose pivot of Λ_q vanishes, if one does.
fn undetermined(matrix: &DMatrix<f64>, model: &Model) -> Option<String> {
    let vanishes = |size: usize| {
        let leading = matrix.view((0, 0), (size, size)).into_owned();
        let own: Vec<f64> = leading.diagonal().iter().copied().collect();
        leading.cholesky().is_none_or(|factors| {
            let l = factors.l_dirty();
            (0..size).any(|i| l[(i, i)] * l[(i, i)] <= SINGULAR_PIVOT * own[i])
        })
    };
    let n = matrix.nrows();
    let first = if vanishes(n) { (1..=n).find(|&size| vanishes(size)) } else { None };
    first.map(|size| model.coordinates()[size - 1].name.clone())
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
