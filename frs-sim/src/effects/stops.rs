//! Stops at the joints' limits.
//!
//! ```text
//! τ_j = ±k d (1 + c ḋ)        while d > 0, the depth beyond the limit (rad, m); never away from the joint's range
//! ```
//!
//! k (N·m/rad, N/m) stores `½ k d²`; c (s/rad, s/m) dissipates in proportion to the depth, so that the torque is continuous where the
//! stop is met (Hunt and Crossley 1975). Meeting and leaving a stop are events that steps meet.

use frs_core::{Model, Moving, Real};

use super::{Effect, positive};
use crate::motion::{Instant, Load, Loads};

/// Stops at the limits of all joints that have them.
#[derive(Clone, Debug, PartialEq)]
pub struct Stops {
    stops: Vec<Stop>,
    stiffness: f64,
    dissipation: f64,
}

/// One end of a joint's range.
#[derive(Clone, Debug, PartialEq)]
struct Stop {
    coordinate: usize,
    limit: f64,
    /// Which way it pushes: +1 at the lower end.
    sign: f64,
    met: bool,
}

impl Stops {
    /// Stops at the limits that the robot's description gives, with stiffness k and dissipation c.
    pub fn new<T: Real>(model: &Model<T>, stiffness: f64, dissipation: f64) -> Self {
        let stop = |(coordinate, limit, sign)| Stop { coordinate, limit, sign, met: false };
        let ends = model.coordinates().iter().enumerate().filter(|(_, c)| !c.continuous).flat_map(|(i, c)| {
            let (lower, upper) =
                (c.limits.lower.map(|limit| (i, limit, 1.0)), c.limits.upper.map(|limit| (i, limit, -1.0)));
            lower.into_iter().chain(upper)
        });
        Self { stops: ends.map(stop).collect(), stiffness, dissipation }
    }
}

impl<T: Real> Loads<T> for Stops {
    fn add(&mut self, instant: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        for Stop { coordinate, limit, sign, .. } in self.stops.iter().filter(|stop| stop.met) {
            let sign = T::from_f64(*sign);
            let depth = sign * (T::from_f64(*limit) - instant.q[*coordinate]);
            let share = T::one() - T::from_f64(self.dissipation) * sign * instant.qd[*coordinate];
            load.tau[*coordinate] += sign * T::from_f64(self.stiffness) * depth * positive(share);
        }
    }
}

impl<T: Real> Effect<T> for Stops {
    fn gaps(&self, instant: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, gaps: &mut Vec<T>) {
        let gap = |stop: &Stop| T::from_f64(stop.sign) * (instant.q[stop.coordinate] - T::from_f64(stop.limit));
        gaps.extend(self.stops.iter().map(gap));
    }

    fn touch(&mut self, gap: usize, closed: bool) {
        self.stops[gap].met = closed;
    }
}
