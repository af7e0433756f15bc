//! `frs check`: how far a robot's numbers can be trusted.

use std::io::{self, Write};

use clap::Args;
use comfy_table::{CellAlignment, Table, presets};
use frs::Model;
use frs::conditioning::{Bounded, Conditioning, Ratio};
use frs::plausibility::{Finding, findings};
use serde_json::json;

use super::{Failure, RobotArgs, table};

/// Check how far a robot's numbers can be trusted: mass ratios, conditioning, suspicious inertias.
///
/// Samples random shapes within the joints' limits and tells how many digits of each quantity rounding leaves, as a bound; and which
/// links have inertias that no body has, or hardly any.
#[derive(Args)]
pub struct Check {
    #[command(flatten)]
    robot: RobotArgs,
    /// Number of random shapes.
    #[arg(long, value_name = "N", default_value = "200", value_parser = clap::value_parser!(u32).range(1..))]
    shapes: u32,
    /// Fail if fewer digits of the accelerations can be trusted.
    #[arg(long, value_name = "N", default_value = "6")]
    digits: u32,
    /// Print one JSON document instead of text.
    #[arg(long)]
    json: bool,
}

/// The same shapes every time.
const SEED: u64 = 1;

/// What is known about a robot.
struct Report {
    conditioning: Conditioning,
    findings: Vec<Finding>,
    /// Lightest and heaviest body: its first link, and its mass in kg.
    masses: [(String, f64); 2],
}

impl Check {
    pub fn run(self) -> Result<(), Failure> {
        let model = self.robot.model()?;
        let report = Report {
            conditioning: Conditioning::sampled(&model, self.shapes as usize, SEED),
            findings: findings(&model),
            masses: masses(&model),
        };
        let mut out = io::stdout().lock();
        if self.json {
            serde_json::to_writer_pretty(&mut out, &report.json(&model)).map_err(io::Error::from)?;
            writeln!(out)?;
        } else {
            report.print(&mut out, &model, self.shapes)?;
        }
        self.verdict(&report)
    }

    fn verdict(&self, report: &Report) -> Result<(), Failure> {
        let impossible = report.findings.iter().filter(|finding| finding.oddity.is_impossible()).count();
        if impossible > 0 {
            let who = if impossible == 1 {
                "1 link has an inertia".into()
            } else {
                format!("{impossible} links have inertias")
            };
            return Err(Failure::Check(format!("{who} that no body can have")));
        }
        let digits = report.conditioning.digits(Bounded::Factored);
        if digits < f64::from(self.digits) {
            return Err(Failure::Check(format!(
                "only {digits:.1} digits of the accelerations can be trusted, asked for are {}; the ratios above say why, and \
                 --digits asks for fewer",
                self.digits
            )));
        }
        Ok(())
    }
}

/// Bodies without mass stand between the joints of a planar one, and are none.
fn masses(model: &Model) -> [(String, f64); 2] {
    let mut bodies: Vec<(String, f64)> = (model.bodies().iter().enumerate())
        .filter(|(_, body)| body.mass > 0.0)
        .filter_map(|(k, body)| {
            model.links().iter().find(|link| link.body == k).map(|link| (link.name.clone(), body.mass))
        })
        .collect();
    bodies.sort_by(|a, b| a.1.total_cmp(&b.1));
    let nothing = || (String::new(), 0.0);
    [bodies.first().cloned().unwrap_or_else(nothing), bodies.pop().unwrap_or_else(nothing)]
}

/// What a bound is about, for people and for programs.
fn name(bounded: Bounded) -> (&'static str, &'static str) {
    match bounded {
        Bounded::Quantities => ("all but accelerations", "quantities"),
        Bounded::TextbookInertia => ("Λ_q as M_q − A_lᵀ Λ_b A_l, for comparison", "textbook_inertia"),
        Bounded::Factored => ("accelerations, route complement", "accelerations_complement"),
        Bounded::Articulated => ("accelerations, route articulated", "accelerations_articulated"),
    }
}

impl Report {
    fn ratios(&self) -> [(&'static str, &'static str, Ratio); 4] {
        let Conditioning { lever, distance, lightness, condition, .. } = self.conditioning;
        [
            ("lever arms: terms of Λ_jj about the centre of mass over Λ_jj", "lever", lever),
            ("distance: way between joints over the robot's reach", "distance", distance),
            ("lightness of the base: M_jj over Λ_jj", "lightness", lightness),
            ("condition number of Λ_q, every joint in its own scale", "condition", condition),
        ]
    }

    fn print(&self, out: &mut impl Write, model: &Model, shapes: u32) -> io::Result<()> {
        table::robot(out, model)?;
        let [(light, least), (heavy, most)] = &self.masses;
        let (least, most, ratio) = (table::significant(*least), table::significant(*most), most / least);
        writeln!(
            out,
            "bodies from {least} kg ('{light}') to {most} kg ('{heavy}'): 1 to {}\n",
            table::significant(ratio)
        )?;

        let mut rows = Table::new();
        rows.load_preset(presets::NOTHING).set_header([&format!("worst of {shapes} shapes"), "ratio", "at"]);
        for (meaning, _, ratio) in self.ratios() {
            let at = ratio.coordinate.map_or("", |j| &model.coordinates()[j].name);
            rows.add_row([meaning, &format!("{:.1}", ratio.value), at]);
        }
        align(&mut rows);
        writeln!(out, "{rows}\n")?;

        let mut rows = Table::new();
        rows.load_preset(presets::NOTHING).set_header(["digits to trust, of 16", "at least"]);
        for bounded in Bounded::ALL {
            rows.add_row([name(bounded).0, &format!("{:.1}", self.conditioning.digits(bounded))]);
        }
        align(&mut rows);
        writeln!(out, "{rows}\n")?;

        if self.findings.is_empty() {
            return writeln!(out, "No inertia is suspicious.");
        }
        for Finding { link, oddity } in &self.findings {
            writeln!(out, "{}: link '{link}': {oddity}", if oddity.is_impossible() { "impossible" } else { "note" })?;
        }
        Ok(())
    }

    fn json(&self, model: &Model) -> serde_json::Value {
        let [lightest, heaviest] = self.masses.each_ref().map(|(link, mass)| json!({ "link": link, "mass": mass }));
        let ratio = |(_, key, ratio): (_, &str, Ratio)| {
            let coordinate = ratio.coordinate.map(|j| &model.coordinates()[j].name);
            (key.to_owned(), json!({ "value": ratio.value, "coordinate": coordinate }))
        };
        let digits = |bounded| (name(bounded).1.to_owned(), self.conditioning.digits(bounded).into());
        let finding = |Finding { link, oddity }: &Finding| json!({ "link": link, "impossible": oddity.is_impossible(), "what": oddity.to_string() });
        json!({
            "robot": model.name(),
            "lightest_body": lightest,
            "heaviest_body": heaviest,
            "ratios": self.ratios().into_iter().map(ratio).collect::<serde_json::Map<_, _>>(),
            "digits": Bounded::ALL.into_iter().map(digits).collect::<serde_json::Map<String, serde_json::Value>>(),
            "findings": self.findings.iter().map(finding).collect::<Vec<_>>(),
        })
    }
}

/// Numbers stand below each other.
fn align(rows: &mut Table) {
    if let Some(column) = rows.column_mut(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
}
