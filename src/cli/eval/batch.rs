//! `frs eval --batch`: a quantity at millions of states, from file to file.

mod beside;
mod columns;
mod npy;
mod parquet;

use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use frs::batch::{Instructions, Recording, answer};
use frs::{Argument, Model, Quantity};
use indicatif::{ProgressBar, ProgressStyle};
use ndarray::{Array2, ArrayView2, ArrayViewMut2, Axis, ShapeBuilder, Slice};
use serde_json::json;

use super::super::{Failure, options};

/// Many states at once.
#[derive(Args)]
#[command(next_help_heading = "Many states at once")]
pub struct BatchArgs {
    /// Evaluate one quantity at every state of this file, on all threads, and write --out.
    ///
    /// .npy: a state a row, the inputs of the quantity beside each other in the order of docs/batch.md, q first; f8 or f4, C or Fortran order. A
    /// file of another width is told what is expected. .parquet: a column of numbers for each input, found by its name: q.NAME, qd.NAME, tau.NAME for each coordinate,
    /// mu.omega_x … mu.v_z, base_wrench.moment_x … base_wrench.force_z, gravity.x …; others are not read.
    #[arg(long, value_name = "STATES.npy|.parquet", requires_all = ["quantity", "out"], conflicts_with_all = ["states", "only"])]
    batch: Option<PathBuf>,
    /// The quantity.
    #[arg(long, value_name = "QUANTITY", requires = "batch", value_parser = options::quantity())]
    quantity: Option<Quantity>,
    /// With --quantity kinematics: the link.
    #[arg(long, value_name = "LINK", requires = "batch")]
    link: Option<String>,
    /// File for the answers, a state a row: .npy, matrices column by column, or .parquet, columns by name.
    #[arg(long, value_name = "FILE.npy|.parquet", requires = "batch")]
    out: Option<PathBuf>,
    /// Memory for states and answers (MiB): as many are read at a time as fit.
    #[arg(long, value_name = "MIB", default_value_t = 64, requires = "batch", value_parser = clap::value_parser!(u32).range(1..))]
    memory: u32,
    /// Threads; all that the machine has without it.
    #[arg(long, value_name = "COUNT", requires = "batch", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
}

/// Where states come from.
trait Source {
    /// How many there are.
    fn states(&self) -> usize;

    /// Reads the next states, as many as there are rows.
    fn read(&mut self, rows: &mut ArrayViewMut2<'_, f64>) -> Result<(), Failure>;
}

/// Where answers go.
trait Sink {
    /// Writes the next rows.
    fn write(&mut self, rows: ArrayView2<'_, f64>) -> Result<(), Failure>;

    /// Makes the file one that is there; before, none is.
    fn finish(self: Box<Self>) -> Result<(), Failure>;
}

/// How a file ends.
#[derive(Clone, Copy)]
enum Format {
    Npy,
    Parquet,
}

impl Format {
    fn of(path: &Path) -> Result<Self, Failure> {
        match path.extension().and_then(OsStr::to_str) {
            Some("npy") => Ok(Self::Npy),
            Some("parquet") => Ok(Self::Parquet),
            _ => Err(Failure::Input(format!(
                "{}: this is no file of states; expected a name that ends in .npy or .parquet",
                path.display()
            ))),
        }
    }

    /// Room for rows, in the order of memory that the file has.
    fn room(self, rows: usize, columns: usize) -> Array2<f64> {
        Array2::zeros((rows, columns).set_f(matches!(self, Self::Parquet)))
    }
}

impl BatchArgs {
    /// Whether this is what is asked for.
    pub fn is_asked(&self) -> bool {
        self.batch.is_some()
    }

    /// Evaluates the file; prints a summary, as JSON if `json`.
    pub fn run(&self, model: &Model, as_json: bool) -> Result<(), Failure> {
        let (Some(from), Some(quantity), Some(to)) = (&self.batch, self.quantity, &self.out) else { return Ok(()) };
        let quantity = self.of_link(quantity, model)?;
        let recording = Recording::new(model, quantity).map_err(|error| Failure::Input(error.to_string()))?;
        let (given, asked) = (columns::names(quantity.inputs(), model), columns::names(quantity.outputs(), model));
        let (source_format, sink_format) = (Format::of(from)?, Format::of(to)?);
        let mut source: Box<dyn Source> = match source_format {
            Format::Npy => Box::new(npy::Reader::open(from, &columns::lengths(quantity.inputs(), model), given.len())?),
            Format::Parquet => Box::new(parquet::Reader::open(from, &given)?),
        };
        let states = source.states();
        let mut sink: Box<dyn Sink> = match sink_format {
            Format::Npy => Box::new(npy::Writer::create(to, states, asked.len())?),
            Format::Parquet => Box::new(parquet::Writer::create(to, quantity.name(), &asked)?),
        };
        // Each number is there twice: as a number, and as bytes of a file.
        let bytes = 2 * size_of::<f64>() * (given.len() + asked.len());
        let chunk = (((self.memory as usize) << 20) / bytes).clamp(1, states.max(1));
        let pool = rayon::ThreadPoolBuilder::new().num_threads(self.threads.map_or(0, usize::from)).build();
        let pool = pool.map_err(|error| Failure::Input(format!("--threads: {error}")))?;
        let stop = stop_flag();
        let progress = ProgressBar::new(states as u64).with_style(ProgressStyle::default_bar());
        let (mut inputs, mut outputs) = (source_format.room(chunk, given.len()), sink_format.room(chunk, asked.len()));
        let (mut done, mut unknown, mut first) = (0, 0, None);
        while done < states {
            if stop.load(Ordering::Relaxed) {
                progress.finish_and_clear();
                return Err(Failure::Check(format!(
                    "stopped after {done} of {states} states; {} was not written",
                    to.display()
                )));
            }
            let count = chunk.min(states - done);
            let mut rows = inputs.slice_axis_mut(Axis(0), Slice::from(..count));
            source.read(&mut rows)?;
            check_finite(from, rows.view(), done, &given)?;
            let mut answers = outputs.slice_axis_mut(Axis(0), Slice::from(..count));
            let (given, asked) = (
                parts(quantity.inputs(), model, rows.view()),
                parts_mut(quantity.outputs(), model, answers.view_mut()),
            );
            let answered = pool.install(|| answer(|| recording.blocks(), quantity, &given, asked));
            answered.map_err(|error| Failure::Input(error.to_string()))?;
            for (row, answer) in answers.rows().into_iter().enumerate() {
                if !answer.iter().all(|number| number.is_finite()) {
                    unknown += 1;
                    first = first.or(Some(done + row));
                }
            }
            sink.write(answers.view())?;
            done += count;
            progress.set_position(done as u64);
        }
        sink.finish()?;
        progress.finish_and_clear();
        let mut out = io::stdout().lock();
        let (instructions, threads) = (Instructions::widest().name(), pool.current_num_threads());
        if as_json {
            let object = json!({
                "quantity": quantity.name(), "states": states, "not_finite": unknown, "inputs": given, "outputs": asked,
                "at_a_time": chunk, "threads": threads, "instructions": instructions, "file": to,
            });
            writeln!(out, "{object}")?;
        } else {
            writeln!(out, "{}: {} at {states} states, {} numbers each", to.display(), quantity.name(), asked.len())?;
            writeln!(out, "{chunk} states at a time on {threads} threads, instructions {instructions}")?;
        }
        match first {
            None => Ok(()),
            Some(row) => Err(Failure::Check(format!(
                "{unknown} states, row {row} (from 0) first, have answers that are not finite: the robot is singular there, or a number overflowed; \
                 they are written as they are"
            ))),
        }
    }

    /// The quantity with the link that it is asked of.
    fn of_link(&self, quantity: Quantity, model: &Model) -> Result<Quantity, Failure> {
        match (quantity, &self.link) {
            (Quantity::Kinematics(_), Some(name)) => model.link(name).map(Quantity::Kinematics).ok_or_else(|| {
                let known: Vec<&str> = model.links().iter().map(|link| link.name.as_str()).collect();
                Failure::Input(format!(
                    "--link '{name}': the robot has no such link; its links are: {}",
                    known.join(", ")
                ))
            }),
            (Quantity::Kinematics(_), None) => {
                Err(Failure::Input("--quantity kinematics: of no link; expected --link NAME".into()))
            }
            (_, Some(name)) => Err(Failure::Input(format!(
                "--link '{name}': {} is of the whole robot; leave --link out",
                quantity.name()
            ))),
            (_, None) => Ok(quantity),
        }
    }
}

/// True from the moment of Ctrl-C on.
fn stop_flag() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let asked = Arc::clone(&stop);
    // Without a handler Ctrl-C ends the program, as it does everywhere.
    let _ = ctrlc::set_handler(move || asked.store(true, Ordering::Relaxed));
    stop
}

/// Refuses what is no number, by its row and column.
fn check_finite(path: &Path, rows: ArrayView2<'_, f64>, before: usize, names: &[String]) -> Result<(), Failure> {
    match rows.indexed_iter().filter(|(_, number)| !number.is_finite()).min_by_key(|(place, _)| *place) {
        None => Ok(()),
        Some(((row, column), number)) => Err(Failure::Input(format!(
            "{}: row {} (from 0): {} is {number}; expected a finite number",
            path.display(),
            before + row,
            names[column]
        ))),
    }
}

/// The columns of each argument.
fn parts<'a>(
    arguments: impl Iterator<Item = Argument>,
    model: &Model,
    mut rows: ArrayView2<'a, f64>,
) -> Vec<ArrayView2<'a, f64>> {
    arguments
        .map(|argument| {
            let (part, rest) = rows.split_at(Axis(1), argument.len(model.dof()));
            rows = rest;
            part
        })
        .collect()
}

/// The columns of each argument, to be written.
fn parts_mut<'a>(
    arguments: impl Iterator<Item = Argument>,
    model: &Model,
    rows: ArrayViewMut2<'a, f64>,
) -> Vec<ArrayViewMut2<'a, f64>> {
    let mut left = Some(rows);
    arguments
        .filter_map(|argument| {
            let (part, rest) = left.take()?.split_at(Axis(1), argument.len(model.dof()));
            left = Some(rest);
            Some(part)
        })
        .collect()
}
