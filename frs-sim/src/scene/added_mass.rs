//! `[added_mass]`: the water that links set in motion.

use frs_core::Model;
use frs_core::spatial::{Twist, Wrench};
use nalgebra::{Matrix6, Vector3};

use super::force::{Force, Named};
use super::reader::{Item, Table};
use crate::effects::AddedMass;

/// All tables as one effect: the accelerations, on which the wrenches depend, are found once for all.
pub fn read(root: &Table<'_, '_>, model: &Model) -> Option<Named> {
    let mut found: Option<(Vec<AddedMass>, [f64; 3], usize)> = None;
    for table in root.tables("added_mass") {
        table.only(&["link", "inertia", "point", "current"]);
        let link = table.required("link", "the name of a link").and_then(|item| item.link(model));
        let inertia = table.required("inertia", WHAT).and_then(|item| inertia(&item));
        let three = |key: &str, what: &str| table.get(key).map_or(Some([0.0; 3]), |item| item.numbers(what));
        let (point, current) = (three("point", "x, y, z in m, link frame"), three("current", "m/s, world axes"));
        let (Some(link), Some(inertia), Some(point), Some(current)) = (link, inertia, point, current) else { continue };
        let added = AddedMass { link, inertia: about_origin(&inertia, point.into()) };
        match &mut found {
            None => found = Some((vec![added], current, table.line())),
            Some((all, one, line)) => {
                if *one != current {
                    table.refuse(currents(&line.to_string(), *one, table.line(), current));
                }
                all.push(added);
            }
        }
    }
    found.map(|(added, current, line)| Named { force: Force::AddedMass(added, current), line })
}

/// Notes what cannot be together with added mass.
pub fn contradictions(root: &Table<'_, '_>, forces: &[Named]) {
    let water = forces.iter().find_map(|named| match &named.force {
        Force::AddedMass(_, current) => Some((*current, named.line)),
        _ => None,
    });
    let Some((current, line)) = water else { return };
    for named in forces {
        if let Force::Drag(drag) = &named.force
            && drag.current != current
        {
            let line = format!("{line} ([added_mass])");
            root.refuse(currents(&line, current, named.line, drag.current));
        }
    }
}

fn currents(line: &str, one: [f64; 3], other_line: usize, other: [f64; 3]) -> String {
    format!("the water moves with {one:?} in line {line} and with {other:?} in line {other_line}; expected one current")
}

const WHAT: &str =
    "six numbers, of turning about (kg·m²) and moving along (kg) the axes of the link, or six rows of six";

/// How far below 0 an eigenvalue may be by rounding, relative to the largest.
const ROUNDING: f64 = 1e-12;

/// A matrix that is symmetric and not negative.
fn inertia(item: &Item<'_, '_>) -> Option<Matrix6<f64>> {
    let matrix = if item.is_nested() {
        let rows = item.items(WHAT)?;
        if rows.len() != 6 {
            return item.refuse(format!("found {} rows; expected 6", rows.len()));
        }
        let rows: Option<Vec<[f64; 6]>> =
            rows.iter().map(|row| row.numbers("a row")).collect::<Vec<_>>().into_iter().collect();
        let rows = rows?;
        Matrix6::from_fn(|i, j| rows[i][j])
    } else {
        Matrix6::from_diagonal(&item.numbers::<6>(WHAT)?.into())
    };
    if let Some((i, j)) =
        (0..6).flat_map(|i| (0..i).map(move |j| (i, j))).find(|&(i, j)| matrix[(i, j)] != matrix[(j, i)])
    {
        let (below, above) = (matrix[(i, j)], matrix[(j, i)]);
        return item.refuse(format!(
            "found {below} in row {}, column {} and {above} across the diagonal; expected a symmetric matrix",
            i + 1,
            j + 1
        ));
    }
    let eigenvalues = matrix.symmetric_eigenvalues();
    let (least, most) = (eigenvalues.min(), eigenvalues.max());
    if least >= -ROUNDING * most.max(0.0) {
        return Some(matrix);
    }
    item.refuse(format!("found an eigenvalue of {least}; expected none below 0: water that moves has energy"))
}

/// The same about the origin of the link's frame.
fn about_origin(inertia: &Matrix6<f64>, point: Vector3<f64>) -> [[f64; 6]; 6] {
    let columns: [[f64; 6]; 6] = std::array::from_fn(|j| {
        let unit = Twist::from_array(std::array::from_fn(|i| f64::from(u8::from(i == j))));
        let momentum = inertia * unit.at(point).to_vector();
        Wrench::from_array(momentum.into()).at(-point).to_array()
    });
    // Symmetric but for rounding; what is above the diagonal counts.
    std::array::from_fn(|i| std::array::from_fn(|j| columns[i.max(j)][i.min(j)]))
}
