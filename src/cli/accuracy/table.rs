//! All points of a study as a table for programs.

use frs_sim::integrate::Steps;

use super::search::{Point, Search};
use crate::cli::parquet::Column;

/// A row a point; seconds are those of the whole motion, the middle of all runs. NaN is what a point does not have.
pub fn columns(search: &Search) -> Vec<(&'static str, Column)> {
    let points = &search.points;
    let text = |of: usize| Column::Text(points.iter().map(|point| point.variant.names()[of].to_owned()).collect());
    let number = |of: &dyn Fn(&Point) -> f64| Column::Number(points.iter().map(of).collect());
    let count = |of: &dyn Fn(&Point) -> usize| Column::Count(points.iter().map(|point| of(point) as i64).collect());
    let accuracy = |point: &Point| match point.variant.solver.steps {
        Steps::Accuracy(accuracy) => accuracy,
        Steps::Length(_) => f64::NAN,
    };
    let step = |point: &Point| match point.variant.solver.steps {
        Steps::Accuracy(_) => f64::NAN,
        Steps::Length(step) => step,
    };
    let on_front = (0..points.len()).map(|i| i64::from(search.front.contains(&i))).collect();
    vec![
        ("method", text(0)),
        ("pace", text(1)),
        ("equations", text(2)),
        ("route", text(3)),
        ("scalar", text(4)),
        ("evaluation", text(5)),
        ("accuracy", number(&accuracy)),
        ("step", number(&step)),
        ("error_pose", number(&|point| point.errors.pose)),
        ("error_shape", number(&|point| point.errors.shape)),
        ("error_momentum", number(&|point| point.errors.momentum)),
        ("error_energy", number(&|point| point.errors.energy)),
        ("evaluations", count(&|point| point.evaluations)),
        ("operations", count(&|point| point.operations)),
        ("seconds", number(&Point::seconds)),
        ("seconds_least", number(&|point| point.spread()[0])),
        ("seconds_most", number(&|point| point.spread()[1])),
        ("runs", count(&|point| point.runs.len())),
        ("on_front", Column::Count(on_front)),
    ]
}

/// The table as comma-separated values; what a point does not have is empty.
pub fn csv(columns: &[(&str, Column)]) -> String {
    let cells = |column: &Column| -> Vec<String> {
        match column {
            Column::Number(values) => {
                let cell = |x: &f64| if x.is_nan() { String::new() } else { format!("{x:e}") };
                values.iter().map(cell).collect()
            }
            Column::Count(values) => values.iter().map(i64::to_string).collect(),
            Column::Text(values) => values.clone(),
        }
    };
    let cells: Vec<_> = columns.iter().map(|(_, column)| cells(column)).collect();
    let mut text = columns.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(",") + "\n";
    for row in 0..cells.first().map_or(0, Vec::len) {
        text += &(cells.iter().map(|column| column[row].as_str()).collect::<Vec<_>>().join(",") + "\n");
    }
    text
}
