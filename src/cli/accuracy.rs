//! `frs accuracy`: what accuracy costs in a scene.

mod advice;
#[cfg(feature = "jit")]
mod compiled;
mod page;
mod peers;
mod picture;
mod search;
mod settings;
mod single;
mod table;

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use comfy_table::{Table, presets};
use frs_sim::study::{Evaluation, Scalar, Truth, Variant, reason_against};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Value, json};

use self::advice::ASKED;
use self::peers::Peers;
use self::search::{Cost, Point, Search, words};
use super::scene::{self, Loaded};
use super::{Failure, RobotArgs, parquet, write};

/// Find what accuracy costs in a scene: compute it in many ways, judge each by a motion with 31 digits, and tell the cheapest.
///
/// Tries methods of integration × steps × equations (reduced, with the momentum integrated, Hamel) × routes to the accelerations ×
/// numbers (f32, f64, double-double), and leaves a way as soon as others are as accurate for much less. Writes accuracy.csv and
/// accuracy.parquet (all points), accuracy.svg and accuracy.html (cost over error) with --out.
#[derive(Args)]
#[command(after_help = "Exit codes: 0 ok, 1 what was asked cannot be had, 2 bad input.")]
pub struct Accuracy {
    /// The scenes (docs/scenes.md).
    #[arg(value_name = "SCENE.toml", required_unless_present = "eval")]
    scenes: Vec<PathBuf>,
    /// Instead of scenes: how far each quantity of this robot is from itself with 31 digits, and provably is at most, over random and hard states.
    #[arg(long, value_name = "ROBOT.urdf", conflicts_with_all = ["scenes", "out", "counts", "want"])]
    eval: Option<PathBuf>,
    /// States of each kind for --eval.
    #[arg(long, value_name = "COUNT", default_value_t = 100, requires = "eval")]
    states: usize,
    /// Folder for the files, with one folder a scene where there are several; made if need be.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Rank by counted operations instead of time: the same result on every machine.
    #[arg(long)]
    counts: bool,
    /// Tell the cheapest settings of a scene file for this error.
    #[arg(long, value_name = "ERROR")]
    want: Option<f64>,
    /// Write them into the scene.
    #[arg(long, requires = "want")]
    write: bool,
    /// Let MuJoCo and Pinocchio compute the scene, too, and draw them beside; with a Python that has them (pip install mujoco pin).
    #[arg(
        long, value_name = "PYTHON", num_args = 0..=1, require_equals = true, default_missing_value = "python3",
        conflicts_with_all = ["counts", "eval"]
    )]
    peers: Option<String>,
    /// Try and time for this long at most, a scene (s).
    #[arg(long, value_name = "SECONDS", default_value_t = 120.0)]
    seconds: f64,
    /// Print one JSON object a scene instead of tables.
    #[arg(long)]
    json: bool,
}

impl Accuracy {
    pub fn run(self) -> Result<(), Failure> {
        for (option, value) in [("--want", self.want), ("--seconds", Some(self.seconds))] {
            if let Some(value) = value.filter(|value| !(*value > 0.0 && value.is_finite())) {
                return Err(Failure::Input(format!("{option}: found {value}; expected a number above 0")));
            }
        }
        if let Some(robot) = self.eval {
            let model = RobotArgs { robot, root: None, lenient: false }.model()?;
            let bar = ProgressBar::no_length();
            let study = single::Study::of(&model, self.states, &bar);
            bar.finish_and_clear();
            let mut out = io::stdout().lock();
            if self.json {
                writeln!(out, "{}", study.json(&model))?;
            } else {
                study.print(&mut out, &model)?;
            }
            return Ok(());
        }
        let mut missed = Vec::new();
        for path in &self.scenes {
            missed.extend(self.scene(path)?);
        }
        if missed.is_empty() { Ok(()) } else { Err(Failure::Check(missed.join("\n"))) }
    }

    /// One scene; what was asked and cannot be had, if so.
    fn scene(&self, path: &Path) -> Result<Option<String>, Failure> {
        let Loaded { scene, model, scene_text, robot_text, .. } = scene::load(path)?;
        let name = path.display();
        if let Some(reason) = reason_against(&scene) {
            return Err(Failure::Input(format!(
                "{name}: {reason}; expected a scene that is smooth between known times"
            )));
        }
        let style = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} ways, {elapsed}");
        let bar = ProgressBar::no_length().with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.set_message(format!("{name}: the motion with 31 digits"));
        bar.tick();
        let truth = Truth::of(&scene, &model)
            .map_err(|error| Failure::Check(format!("{name}: it cannot be computed with 31 digits: {error}")))?;
        bar.set_message(name.to_string());
        let cost = if self.counts { Cost::Operations } else { Cost::Time };
        let search = Search::of(&scene, &model, &truth, cost, self.seconds, &bar);
        let peers = match &self.peers {
            Some(python) => Peers::of(python, &scene, &model, &robot_text, &truth, &bar)?,
            None => Peers::default(),
        };
        bar.finish_and_clear();
        for reason in &peers.left_out {
            eprintln!("{name}: peers: {reason}");
        }

        if let Some(out) = &self.out {
            let folder =
                if self.scenes.len() > 1 { out.join(path.file_stem().unwrap_or_default()) } else { out.clone() };
            let file = path.file_name().unwrap_or_default().to_string_lossy();
            let mut about = format!("{}, {} s", model.name(), scene.duration);
            if cost == Cost::Time {
                about = format!("{about}; {}", machine());
            }
            let picture = picture::svg(&search, &peers, &format!("What accuracy costs: {file}"), scene.duration);
            let page = page::page(&search, &peers, &file, &about, scene.duration, truth.error(), &picture);
            let columns = table::columns(&search);
            for (name, text) in
                [("accuracy.csv", table::csv(&columns)), ("accuracy.svg", picture), ("accuracy.html", page)]
            {
                write(&folder.join(name), &text)?;
            }
            parquet::write(&folder.join("accuracy.parquet"), "accuracy", columns)?;
            if self.peers.is_some() {
                write(&folder.join("peers.csv"), &peers.csv())?;
            }
        }
        let chosen = self.want.map(|want| (want, search.cheapest(want, has_settings)));
        if let Some((_, Some(point))) = chosen
            && self.write
        {
            let text = settings::set(&scene_text, &point.variant)
                .map_err(|error| Failure::Input(format!("{name}: {error}")))?;
            write(path, &text)?;
        }
        let mut out = io::stdout().lock();
        if self.json {
            let mut told = object(path, &search, &truth, scene.duration, chosen);
            if self.peers.is_some() {
                told["peers"] = peers.json();
            }
            writeln!(out, "{told}")?;
        } else {
            told(&mut out, path, &search, &truth, scene.duration, chosen)?;
            peers.print(&mut out, scene.duration)?;
        }
        Ok(match chosen {
            Some((want, None)) => Some(format!("{name}: no setting that was tried has an error of {want:e} or less")),
            _ => None,
        })
    }
}

/// Whether a scene file can ask for it.
fn has_settings(variant: &Variant) -> bool {
    variant.scalar == Scalar::Double && variant.evaluation == Evaluation::Core
}

/// A table for people.
fn told(
    out: &mut impl Write,
    path: &Path,
    search: &Search,
    truth: &Truth,
    duration: f64,
    chosen: Option<(f64, Option<&Point>)>,
) -> io::Result<()> {
    writeln!(
        out,
        "{}: {} motions in {} ways, judged by one that is off by {:.0e} at most\n",
        path.display(),
        search.points.len(),
        search.curves,
        truth.error().of_state()
    )?;
    let mut rows = Table::new();
    rows.load_preset(presets::NOTHING);
    rows.add_row(["for", "the cheapest way", "its error", "it costs", "ten times more accuracy"]);
    for want in ASKED {
        let Some(point) = search.cheapest(want, |_| true) else {
            rows.add_row([&format!("{want:.0e}"), "nothing that was tried", "", "", ""]);
            continue;
        };
        rows.add_row([
            format!("{want:.0e}"),
            words(&point.variant),
            format!("{:.1e}", point.errors.of_state()),
            search.price(point, duration),
            search.tenfold(want).map_or("–".into(), |factor| format!("{factor:.2}×")),
        ]);
    }
    writeln!(out, "{rows}\n")?;
    for limit in search.limits(truth.error().of_state()) {
        writeln!(out, "{limit}")?;
    }
    if let Some((want, Some(point))) = chosen {
        let (settings, price) = (words(&point.variant), search.price(point, duration));
        writeln!(out, "\nfor {want:e}: {settings}; error {:.1e}, {price}", point.errors.of_state())?;
    }
    Ok(())
}

/// The same for programs.
fn object(path: &Path, search: &Search, truth: &Truth, duration: f64, chosen: Option<(f64, Option<&Point>)>) -> Value {
    let point = |point: &Point| {
        let [method, pace, equations, route, scalar, evaluation] = point.variant.names();
        json!({
            "settings": words(&point.variant), "method": method, "pace": pace, "equations": equations, "route": route,
            "scalar": scalar, "evaluation": evaluation,
            "error": point.errors.of_state(), "evaluations": point.evaluations, "operations": point.operations,
            "seconds": point.seconds(),
        })
    };
    let recommended = ASKED.map(|want| json!({ "want": want, "choice": search.cheapest(want, |_| true).map(point) }));
    json!({
        "scene": path.display().to_string(),
        "duration": duration,
        "motions": search.points.len(),
        "yardstick_error": truth.error().of_state(),
        "front": search.front.iter().map(|&i| point(&search.points[i])).collect::<Vec<_>>(),
        "recommended": recommended,
        "limits": search.limits(truth.error().of_state()),
        "wanted": chosen.map(|(want, choice)| json!({ "want": want, "choice": choice.map(point) })),
    })
}

/// What it was timed on.
fn machine() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = text.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    let name = model.map_or("an unnamed processor", |(_, name)| name.trim());
    format!("{name}, {}, {}", std::env::consts::ARCH, std::env::consts::OS)
}
