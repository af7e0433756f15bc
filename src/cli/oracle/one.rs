//! One case: its formulas, and every entry beside what was computed.

use std::io::{self, Write};

use comfy_table::{CellAlignment, Table, presets};
use frs_oracles::{Answers, Case, Judgement, Robots, Values, judged_shapes, points};
use serde_json::json;

use super::super::table::significant;
use super::{WAYS, comparisons, list};

/// Writes a case to standard output.
pub fn write(case: Case, judgement: &Judgement, as_json: bool) -> io::Result<()> {
    let robots = Robots::new(case);
    // The first shape whose numbers are known: no entry vanishes there by accident.
    let q = points(case).into_iter().next().map(|point| point.q).unwrap_or_default();
    let answers = robots.answers(&q);
    let mut out = io::stdout().lock();
    if as_json {
        return writeln!(out, "{}", object(case, judgement, &q, &answers));
    }
    let names: Vec<_> = robots.model().coordinates().iter().map(|coordinate| coordinate.name.as_str()).collect();
    writeln!(out, "{}: {}", case.id(), case.title())?;
    writeln!(out, "coordinates: {}", names.join(", "))?;
    writeln!(out, "source: {}\n", case.source())?;
    writeln!(out, "A_l: {}", case.connection())?;
    writeln!(out, "𝓑:   {}\n", case.curvature())?;
    writeln!(out, "At q = {q:?}, base frame, rows and coordinates as in 𝓑[row](i, j):\n\n{}\n", entries(&answers))?;
    writeln!(
        out,
        "Largest relative differences from the formulas in double-double, at {} shapes:\n\n{}",
        judged_shapes(case).len(),
        worst(judgement)
    )?;
    match case.exception() {
        Some(reason) => writeln!(out, "\nDouble-double: {reason}"),
        None => Ok(()),
    }
}

/// The entries that do not vanish, with the differences of core and generated code from the formulas.
fn entries(answers: &Answers) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_header(["entry", "formula", "core", "generated", "core −", "generated −"]);
    let exact = answers.exact.entries();
    let [core, generated] = [&answers.core, &answers.generated].map(Values::entries);
    for (((name, exact), (_, core)), (_, generated)) in exact.into_iter().zip(core).zip(generated) {
        let differences = [core, generated].map(|x| (frs::extended::DoubleDouble::from(x) - exact).high());
        if [exact.high(), core, generated].iter().any(|&x| x != 0.0) {
            let values = [exact.high(), core, generated].map(significant);
            let differences = differences.map(|difference| format!("{difference:.1e}"));
            table.add_row([name].into_iter().chain(values).chain(differences));
        }
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

fn worst(judgement: &Judgement) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_header(["", "A_l", "worst entry", "𝓑", "worst entry"]);
    for (way, comparison) in WAYS.into_iter().zip(comparisons(judgement)) {
        let cells = |worst: &frs_oracles::Worst| [format!("{:.1e}", worst.relative), worst.entry.clone()];
        let numbers = [&comparison.connection, &comparison.curvature].map(cells);
        table.add_row([way.to_owned()].into_iter().chain(numbers.into_iter().flatten()));
    }
    table
}

fn object(case: Case, judgement: &Judgement, q: &[f64], answers: &Answers) -> serde_json::Value {
    let values = |values: &Values<f64>| -> serde_json::Value {
        values.entries().into_iter().map(|(name, value)| (name, json!(value))).collect::<serde_json::Map<_, _>>().into()
    };
    let mut object = list::summary(case, judgement);
    object["formulas"] = json!({"connection": case.connection(), "curvature": case.curvature()});
    object["q"] = json!(q);
    object["values"] = json!({
        "formula": values(&answers.formula),
        "core": values(&answers.core),
        "generated": values(&answers.generated),
    });
    object
}
