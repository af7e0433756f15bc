//! All cases, with how far everything is from their formulas.

use std::io::{self, Write};

use comfy_table::{CellAlignment, Table, presets};
use frs_oracles::{Case, Comparison, Judgement};
use serde_json::json;

use super::{WAYS, comparisons};

/// Writes all cases to standard output.
pub fn write(cases: &[(Case, Judgement)], as_json: bool) -> io::Result<()> {
    let mut out = io::stdout().lock();
    if as_json {
        let cases: Vec<_> = cases.iter().map(|(case, judgement)| summary(*case, judgement)).collect();
        return writeln!(out, "{}", json!(cases));
    }
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_header(["case", "robot", "n"].into_iter().chain(WAYS).chain([""]));
    for (case, judgement) in cases {
        let n = case.model().dof();
        let differences = comparisons(judgement).map(|comparison| format!("{:.1e}", comparison.larger().relative));
        let mark = if judgement.holds(*case) { "" } else { "BEYOND" };
        let cells = [case.id().into(), case.title().into(), n.to_string()];
        table.add_row(cells.into_iter().chain(differences).chain([mark.into()]));
    }
    for column in table.column_iter_mut().skip(2) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    writeln!(out, "Largest relative differences from the formulas in double-double, of A_l and 𝓑:\n\n{table}\n")?;
    for (case, reason) in cases.iter().filter_map(|(case, _)| case.exception().map(|reason| (case, reason))) {
        writeln!(out, "{}, double-double: {reason}", case.id())?;
    }
    Ok(())
}

/// A case and how far each way is from its formulas, as JSON.
pub fn summary(case: Case, judgement: &Judgement) -> serde_json::Value {
    let both = |comparison: &Comparison| json!({"connection": comparison.connection.relative, "curvature": comparison.curvature.relative});
    let [formula, core, generated, extended] = comparisons(judgement).map(both);
    json!({
        "case": case.id(),
        "title": case.title(),
        "n": case.model().dof(),
        "source": case.source(),
        "formula": formula,
        "core": core,
        "generated": generated,
        "double_double": extended,
        "tolerances": case.tolerances(),
        "exception": case.exception(),
        "holds": judgement.holds(case),
    })
}
