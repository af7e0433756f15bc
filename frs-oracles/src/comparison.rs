//! How far two answers are apart, and where most.

use std::fmt;

use frs_core::extended::DoubleDouble;

use crate::Values;

/// The entry at which two answers differ most.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// The difference relative to the size of what is compared.
    pub relative: f64,
    /// The entry's name, as [`Values::entries`] has it; empty where nothing differs.
    pub entry: String,
    /// The entry on both sides.
    pub values: [f64; 2],
}

/// Two answers compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// A_l, relative to its largest entry.
    pub connection: Worst,
    /// 𝓑, relative to its largest entry or to the square of A_l's, whichever is larger: 𝓑 is a difference of terms of that
    /// size, and vanishes at some shapes.
    pub curvature: Worst,
}

/// Compares A_l and 𝓑, entry by entry.
///
/// # Panics
/// If the two are not of robots with as many coordinates.
pub fn compare(left: &Values<DoubleDouble>, right: &Values<DoubleDouble>) -> Comparison {
    let numbers = 6 * left.connection.len();
    let [left, right] = [left.entries(), right.entries()];
    assert_eq!(left.len(), right.len(), "both are of the same robot");
    let size = |entries: &[Entry]| entries.iter().map(|(_, x)| x.high().abs()).fold(0.0, f64::max);
    let [connection, curvature] = [size(&right[..numbers]), size(&right[numbers..])];
    Comparison {
        connection: worst(&left[..numbers], &right[..numbers], connection),
        curvature: worst(&left[numbers..], &right[numbers..], curvature.max(connection * connection)),
    }
}

type Entry = (String, DoubleDouble);

fn worst(left: &[Entry], right: &[Entry], size: f64) -> Worst {
    let mut worst = Worst { relative: 0.0, entry: String::new(), values: [0.0; 2] };
    for ((entry, left), (_, right)) in left.iter().zip(right) {
        let both_vanish = left.high() == 0.0 && right.high() == 0.0;
        let relative = if both_vanish { 0.0 } else { (*left - *right).high().abs() / size };
        // NaN must win: it is the worst of all, and `total_cmp` places it last.
        if relative.total_cmp(&worst.relative).is_gt() {
            worst = Worst { relative, entry: entry.clone(), values: [left.high(), right.high()] };
        }
    }
    worst
}

impl Comparison {
    /// The worse of the two.
    pub fn larger(&self) -> &Worst {
        let [connection, curvature] = [&self.connection, &self.curvature];
        if connection.relative.total_cmp(&curvature.relative).is_lt() { curvature } else { connection }
    }

    /// Whether both differences are within `tolerance`.
    pub fn within(&self, tolerance: f64) -> bool {
        self.larger().relative <= tolerance
    }

    /// The worse of each.
    pub(crate) fn or(self, other: Self) -> Self {
        let worse = |a: Worst, b: Worst| if a.relative.total_cmp(&b.relative).is_lt() { b } else { a };
        Self { connection: worse(self.connection, other.connection), curvature: worse(self.curvature, other.curvature) }
    }
}

impl fmt::Display for Worst {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [left, right] = self.values;
        if self.entry.is_empty() {
            return f.write_str("no difference");
        }
        write!(f, "{}: {left:e} and {right:e}, relative difference {:.1e}", self.entry, self.relative)
    }
}
