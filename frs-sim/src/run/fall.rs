//! A centre of mass that is not integrated.

use frs_core::spatial::Wrench;
use nalgebra::Vector3;

/// A centre of mass on its way in free fall, since the last handover or the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeFall {
    /// When it began, s.
    pub since: f64,
    /// Where it was then, m, world.
    pub com: Vector3<f64>,
    /// The momentum about it then, world axes (kg·m²/s, kg·m/s).
    pub momentum: Wrench<f64>,
    /// kg.
    pub mass: f64,
}

impl FreeFall {
    /// How far it is at `time`, m.
    pub(super) fn way(&self, time: f64, acceleration: Vector3<f64>) -> Vector3<f64> {
        let t = time - self.since;
        self.momentum.force * (t / self.mass) + acceleration * (0.5 * t * t)
    }
}
