//! What to choose for an accuracy.

use frs_sim::study::{Scalar, Variant};

use super::search::{Cost, Point, Search};

/// Accuracies for which something is recommended.
pub const ASKED: [f64; 5] = [1e-3, 1e-6, 1e-9, 1e-12, 1e-14];

impl Search {
    /// The cheapest point that is at least as accurate as `want`, among those of which `of` says so.
    pub fn cheapest(&self, want: f64, of: impl Fn(&Variant) -> bool) -> Option<&Point> {
        let enough = self.points.iter().filter(|point| point.errors.of_state() <= want && of(&point.variant));
        enough.min_by(|a, b| a.cost(self.cost).total_cmp(&b.cost(self.cost)))
    }

    /// What ten times more accuracy costs, as a factor, if it can be had; over three powers of ten, or as many as there are.
    pub fn tenfold(&self, want: f64) -> Option<f64> {
        let cost = |want| Some(self.cheapest(want, |_| true)?.cost(self.cost));
        let from = cost(want)?;
        (1..=3)
            .rev()
            .find_map(|decades| Some((cost(want * 0.1_f64.powi(decades))? / from).powf(1.0 / f64::from(decades))))
    }

    /// Sentences about where numbers of one kind stop helping, as far as a yardstick that is off by `yardstick` tells.
    pub fn limits(&self, yardstick: f64) -> Vec<String> {
        let reached = |scalar: Scalar| {
            let own = self.points.iter().filter(|point| point.variant.scalar == scalar);
            own.map(|point| point.errors.of_state().max(yardstick)).min_by(f64::total_cmp)
        };
        let helps = |scalar: Scalar| {
            let own = self.front.iter().filter(|&&i| self.points[i].variant.scalar == scalar);
            own.map(|&i| self.points[i].errors.of_state().max(yardstick)).min_by(f64::total_cmp)
        };
        let mut limits = Vec::new();
        for scalar in [Scalar::Single, Scalar::Double, Scalar::DoubleDouble] {
            let Some(reached) = reached(scalar) else { continue };
            let name = scalar.name();
            limits.push(match helps(scalar) {
                Some(helps) => {
                    format!("{name} is worth its time down to {helps:.0e}; the least error it reaches is {reached:.0e}")
                }
                None => format!("{name} is nowhere the cheapest; the least error it reaches is {reached:.0e}"),
            });
        }
        if self.cut {
            limits.push("not all ways were tried: time ran out (--seconds)".into());
        }
        limits
    }

    /// A cost in words, for a motion of `duration` (s).
    pub fn price(&self, point: &Point, duration: f64) -> String {
        match self.cost {
            Cost::Time => format!("{} a simulated second", time(point.seconds() / duration)),
            Cost::Operations => format!("{:.2e} operations a simulated second", point.cost(self.cost) / duration),
        }
    }
}

/// A time with three digits, in a unit that fits.
pub fn time(seconds: f64) -> String {
    let (factor, unit) = match seconds {
        s if s < 1e-3 => (1e6, "µs"),
        s if s < 1.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    let number = seconds * factor;
    let decimals = if number >= 100.0 {
        0
    } else if number >= 10.0 {
        1
    } else {
        2
    };
    format!("{number:.decimals$} {unit}")
}
