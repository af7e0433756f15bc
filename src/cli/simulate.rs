//! `frs simulate`: what happens in a scene, as a table, as pictures and as a page that moves.

mod chart;
mod pictures;
mod report;
mod summary;
mod trajectory;

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use frs_sim::run::run;
use indicatif::{ProgressBar, ProgressStyle};

use self::summary::Summary;
use super::{Failure, scene, write};

/// Compute the motion of a scene and write it down.
///
/// Writes trajectory.csv (time, pose, shape, locked velocity, energy, momentum, torques), pictures (SVG) of the shape, its
/// rates, the locked velocity, the torques, the energy and the momentum, and report.html, in which the robot moves beside them.
/// Ctrl-C keeps what was computed.
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
    /// Print one JSON object instead of a table.
    #[arg(long)]
    json: bool,
}

/// Steps of the progress bar a second of motion.
const TICKS: f64 = 1000.0;

impl Simulate {
    pub fn run(self) -> Result<(), Failure> {
        let (scene, model) = scene::load(&self.scene)?;
        let stop = Arc::new(AtomicBool::new(false));
        let asked = Arc::clone(&stop);
        // Without a handler Ctrl-C ends the program, as it does everywhere.
        let _ = ctrlc::set_handler(move || asked.store(true, Ordering::Relaxed));
        let progress = ProgressBar::new((scene.duration * TICKS) as u64).with_style(ProgressStyle::default_bar());
        let record = run(&scene, &model, |time| {
            progress.set_position((time * TICKS) as u64);
            if stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        progress.finish_and_clear();

        let charts = pictures::all(&model, &record.samples);
        let summary = Summary::new(&scene, &model, &record);
        let mut files = vec![("trajectory.csv", trajectory::table(&model, &record.samples))];
        files.extend(charts.iter().map(|(name, chart)| (*name, chart.svg())));
        files.push(("report.html", report::page(&self.scene, &model, &record.samples, &summary, &charts)?));
        for (name, text) in &files {
            write(&self.out.join(name), text)?;
        }
        let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
        if self.json {
            summary.json(&names)?
        } else {
            summary.print(&names)?
        }
        match summary.ending() {
            None => Ok(()),
            Some(ending) => Err(Failure::Check(format!("{ending}; what was computed is written"))),
        }
    }
}
