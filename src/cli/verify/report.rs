//! What was compared, for people and for programs.

use std::io::{self, Write};

use comfy_table::{CellAlignment, Table, presets};
use frs_codegen::FunctionReport;
use serde_json::json;

use super::run::Outcome;

/// A finished comparison.
pub struct Report<'r> {
    /// The robot's name.
    pub robot: &'r str,
    /// The type of the numbers.
    pub scalar: &'static str,
    /// States at once.
    pub lanes: usize,
    /// Of the random states.
    pub seed: u64,
    /// The generated text.
    pub source: &'r str,
    /// How long the compiler took.
    pub compile_seconds: f64,
    /// The generated functions.
    pub functions: &'r [FunctionReport],
    /// What came out.
    pub outcome: &'r Outcome,
}

impl Report<'_> {
    /// Writes it to standard output.
    pub fn write(&self, as_json: bool) -> io::Result<()> {
        let mut out = io::stdout().lock();
        if as_json { writeln!(out, "{}", self.json()) } else { self.table(&mut out) }
    }

    fn json(&self) -> serde_json::Value {
        let Outcome { states: [states, hard], comparison, times } = self.outcome;
        let functions =
            self.functions.iter().zip(&comparison.tallies).zip(times).map(|((function, tally), [ns, core])| {
                let counts = &function.counts;
                json!({
                    "name": function.name,
                    "operations": {
                        "total": counts.flops(),
                        "add": counts.add,
                        "mul": counts.mul,
                        "div": counts.div,
                        "mul_add": counts.mul_add,
                        "sqrt": counts.sqrt,
                        "sin_cos": counts.sin_cos,
                    },
                    "code_bytes": function.code_bytes,
                    "compared": tally.compared,
                    "differences": tally.differences,
                    "not_finite": tally.not_finite,
                    "generated_ns": ns,
                    "core_ns": core,
                })
            });
        json!({
            "robot": self.robot,
            "scalar": self.scalar,
            "lanes": self.lanes,
            "seed": self.seed,
            "states": states,
            "hard_states": hard,
            "source_bytes": self.source.len(),
            "source_lines": self.source.lines().count(),
            "compile_seconds": self.compile_seconds,
            "functions": functions.collect::<Vec<_>>(),
            "differences": comparison.differences(),
            "first_difference": comparison.first.as_ref().map(|first| first.json()),
        })
    }

    fn table(&self, out: &mut impl Write) -> io::Result<()> {
        let Outcome { states: [states, hard], comparison, times } = self.outcome;
        let lanes = if self.lanes == 1 { String::new() } else { format!(", {} states at once", self.lanes) };
        writeln!(
            out,
            "{} in {}{lanes}: {} lines, {:.1} KiB of source, compiled in {:.1} s\n",
            self.robot,
            self.scalar,
            grouped(self.source.lines().count() as u64),
            self.source.len() as f64 / 1024.0,
            self.compile_seconds
        )?;
        let mut table = Table::new();
        table.load_preset(presets::NOTHING);
        table.set_header(["function", "operations", "code KiB", "compared", "differ", "ns/state", "core", "faster"]);
        for ((function, tally), [generated, core]) in self.functions.iter().zip(&comparison.tallies).zip(times) {
            table.add_row([
                function.name.clone(),
                grouped(function.counts.flops() as u64),
                format!("{:.1}", function.code_bytes as f64 / 1024.0),
                grouped(tally.compared),
                grouped(tally.differences),
                format!("{generated:.0}"),
                format!("{core:.0}"),
                format!("{:.1}×", core / generated),
            ]);
        }
        for column in table.column_iter_mut().skip(1) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        writeln!(out, "{table}\n")?;
        let compared: u64 = comparison.tallies.iter().map(|tally| tally.compared).sum();
        let not_finite: u64 = comparison.tallies.iter().map(|tally| tally.not_finite).sum();
        writeln!(
            out,
            "{} numbers at {} states ({} of them hard): {}",
            grouped(compared),
            grouped(*states as u64),
            grouped(*hard as u64),
            match comparison.differences() {
                0 => "all the same, bit for bit".into(),
                differences => format!("{} DIFFER", grouped(differences)),
            }
        )?;
        if not_finite > 0 {
            writeln!(out, "{} of them are not finite on both sides", grouped(not_finite))?;
        }
        Ok(())
    }
}

/// A count in groups of three digits.
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().map(|group| str::from_utf8(group).unwrap_or("")).collect();
    groups.join(" ")
}
