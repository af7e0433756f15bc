//! What a gait did, for people and for programs.

use std::io::{self, Write};

use comfy_table::{CellAlignment, Table, presets};
use frs::nalgebra::Vector3;
use frs::spatial::so3;
use frs::{Evaluator, Model};
use frs_gait::{Displacement, Gait, Grid, MinimumPerturbation, Optimum, Path, area_integral, displacement, length};
use serde_json::{Value, json};

use super::plane::Axes;
use crate::cli::Failure;
use crate::cli::table::{self, significant};

/// Tolerance of the exact displacement (rad, m).
const EXACT: f64 = 1e-11;

/// Tolerance of area integrals (rad, m).
const AREA: f64 = 1e-8;

/// The same in minimum-perturbation coordinates, which are known on the grid's points.
const AREA_ON_GRID: f64 = 1e-5;

/// Panels of a piece for the perimeter.
const PANELS: usize = 500;

/// What a gait does: by the area rule and exactly.
pub struct Outcome {
    perimeter: f64,
    exact: Displacement,
    /// Rotation vector and translation part of its logarithm.
    log: [f64; 6],
    area: [f64; 6],
    area_error: f64,
    /// In minimum-perturbation coordinates: area rule and exact rotation; `None` if the gait leaves the window.
    minimum: Option<[Vector3<f64>; 2]>,
}

impl Outcome {
    /// Follows the gait.
    pub fn of(
        model: &Model,
        axes: &Axes<'_>,
        gait: &Gait,
        minimum: Option<&MinimumPerturbation>,
    ) -> Result<Self, Failure> {
        let mut robot = Evaluator::new(model);
        let exact = displacement(&mut robot, gait, EXACT)
            .map_err(|error| Failure::Check(format!("the gait cannot be followed: {error}")))?;
        let translation = so3::dexp_inverse(exact.rotation, exact.pose.translation);
        let area = area_integral(&mut robot, &axes.plane, gait, AREA);
        let (mut q, mut dq) = (vec![0.0; model.dof()], vec![0.0; model.dof()]);
        gait.at(0, 0.0, &mut q, &mut dq);
        let minimum = minimum.and_then(|minimum| {
            let (area, _) = minimum.area_integral(&mut robot, &axes.plane, gait, AREA_ON_GRID);
            let turned = minimum.rotation(axes.plane.point(&q))?.tr_mul(&exact.rotation);
            area.norm().is_finite().then_some([area, turned])
        });
        Ok(Self {
            perimeter: length(gait, PANELS.div_ceil(gait.pieces())),
            exact,
            log: std::array::from_fn(|row| if row < 3 { exact.rotation[row] } else { translation[row - 3] }),
            area: area.body.to_array(),
            area_error: area.error,
            minimum,
        })
    }

    /// The rows of the table: what, by the area rule, exactly.
    fn rows(&self) -> Vec<(&'static str, f64, f64)> {
        let base =
            ["rotation x / rad", "rotation y / rad", "rotation z / rad", "translation x / m", "translation y / m"]
                .into_iter()
                .chain(["translation z / m"]);
        let least = ["minimum perturbation, rotation x / rad", "…, rotation y / rad", "…, rotation z / rad"];
        let base = base.enumerate().map(|(row, name)| (name, self.area[row], self.log[row]));
        let minimum = self
            .minimum
            .iter()
            .flat_map(|[area, exact]| least.into_iter().enumerate().map(|(row, name)| (name, area[row], exact[row])));
        base.chain(minimum).collect()
    }
}

/// All that is told at the end.
pub struct Report<'a, 'm> {
    pub model: &'m Model,
    pub axes: &'a Axes<'m>,
    pub grid: Grid,
    pub files: Vec<String>,
    pub minimum: Option<MinimumPerturbation>,
    pub outcome: Option<Outcome>,
    pub best: Option<Optimum>,
}

impl Report<'_, '_> {
    /// Tables for people.
    pub fn print(&self) -> Result<(), Failure> {
        let mut out = io::stdout().lock();
        table::robot(&mut out, self.model)?;
        let [a, b] = self.axes.labels();
        let [[a0, a1], [b0, b1]] = self.grid.window().map(|range| range.map(significant));
        writeln!(out, "map: {a} from {a0} to {a1}, {b} from {b0} to {b1}, {0}×{0} points", self.grid.points())?;
        if let Some(minimum) = &self.minimum {
            writeln!(
                out,
                "size of A_ω over the map (root mean square): {} in the base frame, {} in minimum-perturbation coordinates",
                significant(minimum.before),
                significant(minimum.after)
            )?;
        }
        if let Some(best) = &self.best {
            writeln!(out, "best gait: turns the base by {} rad; written to best_gait.csv", significant(best.turn))?;
            if best.outside > 0.0 {
                writeln!(
                    out,
                    "  it leaves the window by {}: the perimeter is too long for it",
                    significant(best.outside)
                )?;
            }
        }
        if let Some(outcome) = &self.outcome {
            self.told(&mut out, outcome)?;
        }
        Ok(writeln!(out, "\nwritten: {}", self.files.join(", "))?)
    }

    fn told(&self, out: &mut impl Write, outcome: &Outcome) -> io::Result<()> {
        writeln!(
            out,
            "\nthe gait, {} {} long: what the area rule says, −∬𝓑, and what the base does, log g",
            significant(outcome.perimeter),
            self.axes.length_unit()
        )?;
        let mut rows = Table::new();
        rows.load_preset(presets::NOTHING).set_header(["", "area rule", "exact", "gap"]);
        for (name, area, exact) in outcome.rows() {
            rows.add_row([name.into(), fixed(area), fixed(exact), small(area - exact)]);
        }
        for column in rows.column_iter_mut().skip(1) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        writeln!(out, "{rows}")?;
        writeln!(
            out,
            "known to {:.0e} (exact, {} evaluations) and {:.0e} (area rule, base frame)",
            outcome.exact.error, outcome.exact.evaluations, outcome.area_error
        )?;
        if outcome.minimum.is_none() {
            writeln!(out, "no minimum-perturbation coordinates along the whole gait: it leaves the window")?;
        }
        Ok(())
    }

    /// One object for programs.
    pub fn json(&self) -> Result<(), Failure> {
        let gait = self.outcome.as_ref().map(|outcome| {
            let pose = &outcome.exact.pose;
            json!({
                "perimeter": outcome.perimeter,
                "area_integral": outcome.area,
                "area_integral_error": outcome.area_error,
                "displacement": outcome.log,
                "displacement_error": outcome.exact.error,
                "gap": (0..6).map(|row| outcome.area[row] - outcome.log[row]).collect::<Vec<_>>(),
                "rotation": (0..3).map(|row| (0..3).map(|c| pose.rotation[(row, c)]).collect()).collect::<Vec<Vec<_>>>(),
                "translation": pose.translation.as_slice(),
                "minimum_perturbation": outcome.minimum.map(|[area, exact]| json!({
                    "area_integral": area.as_slice(),
                    "rotation": exact.as_slice(),
                    "gap": (area - exact).as_slice(),
                })),
            })
        });
        let object: Value = json!({
            "robot": self.model.name(),
            "joints": self.axes.names(),
            "window": self.grid.window(),
            "grid": self.grid.points(),
            "files": self.files,
            "connection_size": self.minimum.as_ref().map(|minimum| json!({
                "base_frame": minimum.before,
                "minimum_perturbation": minimum.after,
            })),
            "best": self.best.as_ref().map(|best| json!({ "turn": best.turn, "outside": best.outside })),
            "gait": gait,
        });
        Ok(writeln!(io::stdout().lock(), "{object}")?)
    }
}

/// A number with six digits after the point: rows of a table compare.
fn fixed(x: f64) -> String {
    // Not −0.000000.
    let text = format!("{x:.6}");
    if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) { "0.000000".into() } else { text }
}

/// A difference in two digits.
fn small(x: f64) -> String {
    if x == 0.0 { "0".into() } else { format!("{x:.1e}") }
}
