//! Chosen settings, written into a scene; everything else in it stays as it is.

use frs_sim::integrate::Steps;
use frs_sim::study::Variant;
use toml_edit::{DocumentMut, Item, Table, value};

/// The scene's text with the settings of `variant`.
pub fn set(text: &str, variant: &Variant) -> Result<String, toml_edit::TomlError> {
    let mut document: DocumentMut = text.parse()?;
    let [method, _, equations, route, ..] = variant.names();
    let steps = variant.solver.steps;
    match steps {
        Steps::Accuracy(accuracy) => document["accuracy"] = value(accuracy),
        Steps::Length(_) => drop(document.remove("accuracy")),
    }
    let solver = document.entry("solver").or_insert_with(|| Item::Table(Table::new()));
    for (key, name) in [("method", method), ("equations", equations), ("route", route)] {
        solver[key] = value(name);
    }
    match steps {
        Steps::Length(step) => solver["step"] = value(step),
        Steps::Accuracy(_) => {
            if let Some(table) = solver.as_table_like_mut() {
                table.remove("step");
            }
        }
    }
    Ok(document.to_string())
}
