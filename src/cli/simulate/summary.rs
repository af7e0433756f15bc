//! How a run went, in a few numbers.

use std::io::{self, Write};

use comfy_table::{Table, presets};
use frs::Model;
use frs::nalgebra::Matrix3;
use frs_sim::run::{End, Record, Sample};
use frs_sim::scene::{Case, Scene};
use serde_json::{Map, json};

use crate::cli::Failure;
use crate::cli::table::{self, significant};

/// What is told at the end.
pub struct Summary<'a> {
    scene: &'a Scene,
    model: &'a Model,
    record: &'a Record,
    /// Largest |E − E(0) − W|, J.
    energy: f64,
    /// Largest change of an entry of the momentum: of its angular half about the centre of mass where that is known to stay.
    momentum: f64,
    /// Largest entry of RᵀR − 1.
    rotation: f64,
}

impl<'a> Summary<'a> {
    pub fn new(scene: &'a Scene, model: &'a Model, record: &'a Record) -> Self {
        let start = &record.samples[0];
        let worst = |of: &dyn Fn(&Sample) -> f64| record.samples.iter().map(of).fold(0.0, f64::max);
        let energy = worst(&|s| (s.kinetic_energy - start.kinetic_energy - s.work()).abs());
        let spin = |s: &Sample| s.momentum.at(s.com).moment;
        let momentum = match keeps_spin(scene) {
            true => worst(&|s| largest((spin(s) - spin(start)).as_slice())),
            false => worst(&|s| largest(&(s.momentum - start.momentum).to_array())),
        };
        let rotation =
            worst(&|s| largest((s.pose.rotation.transpose() * s.pose.rotation - Matrix3::identity()).as_slice()));
        Self { scene, model, record, energy, momentum, rotation }
    }

    /// Where the run ended, s.
    pub fn time(&self) -> f64 {
        self.record.samples.last().map_or(0.0, |sample| sample.time)
    }

    /// Why the run did not reach its end, if it did not.
    pub fn ending(&self) -> Option<String> {
        match self.record.end {
            End::Whole => None,
            End::Stopped => Some(format!("stopped at t = {} s", self.time())),
            End::Failed(error) => Some(error.to_string()),
        }
    }

    /// What is told, and how much it is.
    pub fn rows(&self) -> Vec<(String, String)> {
        let Record { samples, steps, checkpoint, .. } = self.record;
        let evaluations = checkpoint.pace.evaluations;
        let case = self.scene.case();
        let (change, units) = match keeps_spin(self.scene) {
            true => ("spin drifted by", "kg·m²/s at most, about the centre of mass"),
            false => ("momentum changed by", "kg·m²/s, kg·m/s at most"),
        };
        let works = self.works().map(|(name, work)| (format!("work of {name}"), format!("{} J", significant(work))));
        let before = [
            ("computed", format!("{} s of {} s", significant(self.time()), significant(self.scene.duration))),
            ("steps", format!("{steps}, {evaluations} evaluations of the equations")),
            ("samples", samples.len().to_string()),
            ("momentum", case.name().to_owned()),
            (change, format!("{} {units}", small(self.momentum))),
            ("kinetic energy", self.energies()),
        ];
        let after = [
            ("energy and work differ by", format!("{} J at most", small(self.energy))),
            ("rotation is one to", small(self.rotation)),
        ];
        let observer = self.convergence().map(|(factor, time)| ("error of the observer", fallen(factor, time)));
        let told = |(what, amount): (&str, String)| (what.to_owned(), amount);
        before.map(told).into_iter().chain(works).chain(after.into_iter().chain(observer).map(told)).collect()
    }

    /// What did work, and how much until the end, J.
    fn works(&self) -> impl Iterator<Item = (String, f64)> {
        let last = self.record.samples.last();
        let amounts = last.into_iter().flat_map(|sample| sample.works.iter().copied());
        self.scene.works().into_iter().map(|work| work.name).zip(amounts)
    }

    /// By which factor the observer's error (the root of its Lyapunov function) fell until the end, and after which time (s) it was 1/e; none
    /// without an observer, or if that was right from the start.
    fn convergence(&self) -> Option<(f64, Option<f64>)> {
        let samples = &self.record.samples;
        let size = |sample: &Sample| sample.observation.map(|seen| seen.lyapunov.sqrt());
        let (first, last) = (size(samples.first()?)?, size(samples.last()?)?);
        let low = |sample: &Sample| size(sample).is_some_and(|size| size <= first / std::f64::consts::E);
        let time = samples.iter().find(|sample| low(sample)).map(|sample| sample.time);
        (first > 0.0).then_some((first / last, time))
    }

    /// A table for people.
    pub fn print(&self, files: &[&str]) -> Result<(), Failure> {
        let mut out = io::stdout().lock();
        table::robot(&mut out, self.model)?;
        let mut table = Table::new();
        table.load_preset(presets::NOTHING);
        for (what, amount) in self.rows() {
            table.add_row([what, amount]);
        }
        writeln!(out, "{table}")?;
        Ok(writeln!(out, "\nwritten: {}", files.join(", "))?)
    }

    fn energies(&self) -> String {
        let [first, last] = [self.record.samples.first(), self.record.samples.last()]
            .map(|sample| sample.map_or(0.0, |sample| sample.kinetic_energy));
        format!("{} J at the start, {} J at the end", significant(first), significant(last))
    }

    /// One object for programs.
    pub fn json(&self, files: &[&str]) -> Result<(), Failure> {
        let end = match self.record.end {
            End::Whole => "whole",
            End::Stopped => "stopped",
            End::Failed(_) => "failed",
        };
        let object = json!({
            "robot": self.model.name(),
            "momentum": self.scene.case().name(),
            "end": end,
            "time": self.time(),
            "samples": self.record.samples.len(),
            "steps": self.record.steps,
            "evaluations": self.record.checkpoint.pace.evaluations,
            "momentum_change": self.momentum,
            "work": self.works().map(|(name, work)| (name, work.into())).collect::<Map<_, _>>(),
            "energy_difference": self.energy,
            "observer": self.convergence().map(|(factor, time)| json!({ "factor": factor, "time_constant": time })),
            "rotation_defect": self.rotation,
            "files": files,
        });
        Ok(writeln!(io::stdout().lock(), "{object}")?)
    }
}

/// Whether nothing changes the momentum about the centre of mass, but for gravity its linear half.
fn keeps_spin(scene: &Scene) -> bool {
    scene.known_case() != Case::Driven && scene.handovers().is_empty()
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |largest, number| largest.max(number.abs()))
}

fn fallen(factor: f64, time: Option<f64>) -> String {
    let time = time.map_or("never to 1/e".to_owned(), |time| format!("to 1/e after {} s", significant(time)));
    format!("fell by a factor of {factor:.1e}, {time}")
}

fn small(number: f64) -> String {
    if number == 0.0 { "0".into() } else { format!("{number:.1e}") }
}
