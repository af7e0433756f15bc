//! `frs simulate`: what happens in a scene, as a table, as pictures and as a page that moves.

mod chart;
mod checkpoint;
mod decoupling;
mod pictures;
mod report;
mod summary;
mod trajectory;

use std::cell::Cell;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use clap::Args;
use frs_sim::run::{Acting, Code, End, Record, run_by};
use indicatif::{ProgressBar, ProgressStyle};

use self::summary::Summary;
use super::scene::{self, Loaded};
use super::{Failure, parquet, write};

/// Compute the motion of a scene and write it down.
///
/// Writes trajectory.csv and trajectory.parquet (time, pose, shape, locked velocity, energy, momentum, torques), pictures (SVG) of the shape, its
/// rates, the locked velocity, the torques, the energy and the momentum, and report.html, in which the robot moves beside them.
///
/// Ctrl-C keeps what was computed, and --resume goes on from there; long runs are saved on the way.
#[derive(Args)]
#[command(
    after_help = "Exit codes: 0 ok, 1 the motion could not be continued or was stopped (what was computed is written), 2 bad input."
)]
pub struct Simulate {
    /// The scene (docs/scenes.md).
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,
    /// Folder for the files; made if need be.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Go on with the run that was stopped in this folder, with the bits that it would have had.
    #[arg(long)]
    resume: bool,
    /// Save this often what it takes to resume, in seconds of your time.
    #[arg(long, value_name = "SECONDS", default_value_t = 60.0)]
    save_every: f64,
    /// Print one JSON object instead of a table.
    #[arg(long)]
    json: bool,
}

/// The table for programs.
const PARQUET: &str = "trajectory.parquet";

/// Machine code with which a long run goes on, where this program can make it.
fn code(acting: &Acting<'_>) -> Option<Box<dyn Code>> {
    #[cfg(feature = "jit")]
    return super::compiled::code(acting);
    #[cfg(not(feature = "jit"))]
    return {
        let _ = acting;
        None
    };
}

/// Steps of the progress bar a second of motion.
const TICKS: f64 = 1000.0;

impl Simulate {
    pub fn run(self) -> Result<(), Failure> {
        let loaded = scene::load(&self.scene)?;
        let Loaded { scene, model, .. } = &loaded;
        let stop = Arc::new(AtomicBool::new(false));
        let asked = Arc::clone(&stop);
        // Without a handler Ctrl-C ends the program, as it does everywhere.
        let _ = ctrlc::set_handler(move || asked.store(true, Ordering::Relaxed));
        let columns = trajectory::names(scene, model);
        let rows = |record: &Record| record.samples.iter().map(trajectory::row).collect::<Vec<_>>();
        let progress = ProgressBar::new((scene.duration * TICKS) as u64).with_style(ProgressStyle::default_bar());
        let saved = Cell::new(Instant::now());
        let each = |time: f64| {
            progress.set_position((time * TICKS) as u64);
            let pause = stop.load(Ordering::Relaxed) || saved.get().elapsed().as_secs_f64() >= self.save_every;
            if pause { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let coded = Cell::new(0);
        let coder = |acting: &Acting<'_>| code(acting).inspect(|_| coded.set(coded.get() + 1));
        let from = if self.resume { Some(checkpoint::load(&self.out, &loaded)?) } else { None };
        let mut record = run_by(scene, model, from, Some(&coder), each);
        while record.end == End::Stopped {
            write(&self.out.join("trajectory.csv"), &trajectory::table(&columns, &rows(&record)))?;
            write(&self.out.join(checkpoint::FILE), &checkpoint::text(&loaded, &record))?;
            saved.set(Instant::now());
            if stop.load(Ordering::Relaxed) {
                break;
            }
            record = run_by(scene, model, Some(record), Some(&coder), each);
        }
        progress.finish_and_clear();
        if record.end != End::Stopped {
            // There is nothing to resume any more.
            let _ = std::fs::remove_file(self.out.join(checkpoint::FILE));
        }

        let charts = pictures::all(scene, model, &record.samples);
        let summary = Summary::new(scene, model, &record, coded.get());
        let rows = rows(&record);
        let mut files = vec![("trajectory.csv", trajectory::table(&columns, &rows))];
        files.extend(charts.iter().map(|(name, chart)| (*name, chart.svg())));
        files.push(("report.html", report::page(&self.scene, scene, model, &record.samples, &summary, &charts)?));
        for (name, text) in &files {
            write(&self.out.join(name), text)?;
        }
        let path = self.out.join(PARQUET);
        let column = |i: usize| parquet::Column::Number(rows.iter().map(|row| row[i]).collect());
        let named = columns.iter().enumerate().map(|(i, name)| (name.as_str(), column(i)));
        parquet::write(&path, "trajectory", named)?;
        let names: Vec<&str> = files.iter().map(|(name, _)| *name).chain([PARQUET]).collect();
        if self.json {
            summary.json(&names)?
        } else {
            summary.print(&names)?
        }
        match summary.ending() {
            None => Ok(()),
            Some(ending) if record.end == End::Stopped => {
                Err(Failure::Check(format!("{ending}; what was computed is written; --resume goes on")))
            }
            Some(ending) => Err(Failure::Check(format!("{ending}; what was computed is written"))),
        }
    }
}
