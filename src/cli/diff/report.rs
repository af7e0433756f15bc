//! A change in words, and as JSON.

use std::io::{self, Write};
use std::path::Path;

use comfy_table::{CellAlignment, Table, presets};
use serde_json::{Value, json};

use super::code::{Change, CodeChanges};
use super::robot::{Parameter, RobotChanges, Set};

/// Two robots compared.
pub struct Report<'r> {
    /// Their files.
    pub paths: [&'r Path; 2],
    /// What changed in the robot.
    pub robot: &'r RobotChanges,
    /// What changed in its code.
    pub code: &'r CodeChanges,
}

impl Report<'_> {
    /// Writes it to standard output.
    pub fn write(&self, as_json: bool) -> io::Result<()> {
        let mut out = io::stdout().lock();
        if as_json { writeln!(out, "{}", self.json()) } else { self.words(&mut out) }
    }

    fn json(&self) -> serde_json::Value {
        let functions = self.code.functions.iter().map(|function| {
            let operations = function.counts.map(|counts| counts.map(|counts| counts.flops()));
            json!({ "name": function.name, "change": function.change, "operations": operations })
        });
        json!({
            "files": self.paths.map(|path| path.display().to_string()),
            "robot": self.robot,
            "functions": functions.collect::<Vec<_>>(),
            "lines_removed": self.code.lines[0],
            "lines_added": self.code.lines[1],
            "lines": self.code.total_lines,
            "summary": self.summary(),
        })
    }

    fn words(&self, out: &mut impl Write) -> io::Result<()> {
        let RobotChanges { names: [old, new], links, joints, coordinates, parameters, without_effect, .. } = self.robot;
        writeln!(out, "{old} ({}) → {new} ({})\n", self.paths[0].display(), self.paths[1].display())?;
        for (what, set) in [("links", links), ("joints", joints), ("coordinates", coordinates)] {
            writeln!(out, "{what}: {}", set_words(set))?;
        }
        if parameters.is_empty() {
            writeln!(out, "\nEvery number on which the dynamics depend is the same.")?;
        } else {
            writeln!(out, "\nNumbers on which the dynamics depend:\n{}", parameter_table(parameters))?;
        }
        if !without_effect.is_empty() {
            writeln!(out, "\nWithout effect on the dynamics:\n{}", parameter_table(without_effect))?;
        }
        writeln!(out, "\nGenerated functions, with all that they stand on:\n{}", self.function_table())?;
        writeln!(out, "\n{}", self.summary())
    }

    fn function_table(&self) -> Table {
        let mut table = Table::new();
        table.load_preset(presets::NOTHING).set_header(["function", "what changed", "operations", "after", ""]);
        for function in &self.code.functions {
            let [old, new] = function.counts.map(|counts| counts.map(|counts| counts.flops()));
            let shown = |count: Option<usize>| count.map_or("–".into(), |count| count.to_string());
            let by = match (old, new) {
                (Some(old), Some(new)) if old != new => format!("{:+}", new as i64 - old as i64),
                _ => String::new(),
            };
            let words = function.change.words().to_owned();
            table.add_row([function.name.clone(), words, shown(old), shown(new), by]);
        }
        for column in table.column_iter_mut().skip(2) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        table
    }

    /// All of it in a line.
    fn summary(&self) -> String {
        let RobotChanges { links, joints, coordinates, parameters, .. } = self.robot;
        let kinds = [
            (Change::Unchanged, "unchanged"),
            (Change::Names, "changed in names only"),
            (Change::Constants, "changed in constants only"),
            (Change::Structure, "changed in structure"),
            (Change::Added, "added"),
            (Change::Removed, "removed"),
        ];
        let counted = kinds.map(|(change, words)| (self.code.count(change), words));
        let functions: Vec<String> = counted
            .into_iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, words)| format!("{count} {words}"))
            .collect();
        let names = if [links, joints, coordinates].iter().all(|set| set.is_same()) {
            "the same links and joints".into()
        } else {
            let sum = |names: fn(&Set) -> usize| names(links) + names(joints);
            format!(
                "links and joints: {} added, {} removed, {} renamed",
                sum(|set| set.added.len()),
                sum(|set| set.removed.len()),
                sum(|set| set.renamed.len())
            )
        };
        let ([removed, added], [old, new]) = (self.code.lines, self.code.total_lines);
        let lines = match (removed, added) {
            (0, 0) => format!("the code's {new} lines are the same"),
            _ => format!("of the code's {old} lines {removed} went and {added} came, which makes {new}"),
        };
        format!(
            "Summary: {names}; {} moved; functions: {}; {lines}.",
            match parameters.len() {
                0 => "no parameter".into(),
                1 => "1 parameter".into(),
                count => format!("{count} parameters"),
            },
            functions.join(", ")
        )
    }
}

/// What came and went.
fn set_words(set: &Set) -> String {
    let [old, new] = set.counts;
    if set.is_same() {
        return format!("the same {new}");
    }
    let mut words = Vec::new();
    for (what, names) in [("added", &set.added), ("removed", &set.removed)] {
        if !names.is_empty() {
            words.push(format!("{what} {}", names.join(", ")));
        }
    }
    words.extend(set.renamed.iter().map(|[old, new]| format!("{old} is called {new}")));
    if set.reordered {
        words.push("in another order".into());
    }
    let counts = if old == new { new.to_string() } else { format!("{old} → {new}") };
    format!("{counts}: {}", words.join("; "))
}

fn parameter_table(parameters: &[Parameter]) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::NOTHING);
    for Parameter { of, name, old, new, relative } in parameters {
        let relative = relative.map_or(String::new(), |relative| percent(relative, old.is_number()));
        table.add_row([of.clone(), (*name).into(), format!("{} → {}", words(old), words(new)), relative]);
    }
    if let Some(column) = table.column_mut(3) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

/// Three digits; only a number alone moves up or down.
fn percent(relative: f64, signed: bool) -> String {
    let percent = 100.0 * relative;
    let digits = (2.0 - percent.abs().log10().floor()).clamp(0.0, 15.0) as usize;
    if signed { format!("{percent:+.digits$} %") } else { format!("by {percent:.digits$} %") }
}

/// Numbers with as many digits as tell them from others.
fn words(value: &Value) -> String {
    match value {
        Value::Null => "none".into(),
        Value::String(word) => word.clone(),
        Value::Array(numbers) => numbers.iter().map(words).collect::<Vec<_>>().join(" "),
        number => number.as_f64().map_or(String::new(), |number| number.to_string()),
    }
}
