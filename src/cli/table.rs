//! Quantities as tables for people.

use std::io::{self, Write};

use comfy_table::{CellAlignment, Table, presets};
use frs::Model;
use frs::nalgebra::DMatrix;

use super::answer::{Key, Value};
use clap::ValueEnum;

/// What the robot is, in two lines.
pub fn robot(out: &mut impl Write, model: &Model) -> io::Result<()> {
    let mass: f64 = model.bodies().iter().map(|body| body.mass).sum();
    writeln!(
        out,
        "{}: {} links, {} coordinates, {} kg; base frame: link '{}'",
        model.name(),
        model.links().len(),
        model.dof(),
        significant(mass),
        model.links()[0].name
    )?;
    let names: Vec<&str> = model.coordinates().iter().map(|c| c.name.as_str()).collect();
    writeln!(out, "coordinates: {}\n", if names.is_empty() { "none".into() } else { names.join(", ") })
}

/// Every quantity, titled by its meaning and key.
pub fn quantities(out: &mut impl Write, model: &Model, keys: &[Key], values: &[Value]) -> io::Result<()> {
    robot(out, model)?;
    for (key, value) in keys.iter().zip(values) {
        let meaning = key.to_possible_value().and_then(|v| v.get_help().map(ToString::to_string)).unwrap_or_default();
        writeln!(out, "{meaning}   [{}]", key.name())?;
        match value {
            Value::Scalar(x) => writeln!(out, "{}", significant(*x))?,
            Value::Vector(v) => matrix(out, &DMatrix::from_row_slice(1, v.len(), v))?,
            Value::Matrix(m) => matrix(out, m)?,
            Value::Tensor(rows) => {
                for (row, component) in rows.iter().zip(["ω_x", "ω_y", "ω_z", "v_x", "v_y", "v_z"]) {
                    writeln!(out, "component {component}:")?;
                    matrix(out, row)?;
                }
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

/// A matrix with aligned columns.
pub fn matrix(out: &mut impl Write, matrix: &DMatrix<f64>) -> io::Result<()> {
    if matrix.is_empty() {
        return writeln!(out, "  (empty: {}×{})", matrix.nrows(), matrix.ncols());
    }
    let mut table = Table::new();
    table.load_preset(presets::NOTHING);
    for row in matrix.row_iter() {
        table.add_row(row.iter().map(|&x| significant(x)));
    }
    for column in table.column_iter_mut() {
        column.set_cell_alignment(CellAlignment::Right);
        column.set_padding((1, 0));
    }
    writeln!(out, "{table}")
}

/// A number in five significant digits.
pub fn significant(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if (1e-3..1e5).contains(&x.abs()) {
        let digits = (4 - x.abs().log10().floor() as i32).clamp(0, 8) as usize;
        format!("{x:.digits$}")
    } else {
        format!("{x:.4e}")
    }
}
