//! Constant joint torques, in each lane its own.

use frs_core::lanes::Lane;
use frs_core::{Moving, Real};

use crate::motion::{Forces, Instant, Load, Loads};

/// Constant joint torques τ (N·m, N), one set a lane.
#[derive(Clone, Debug, PartialEq)]
pub struct Torques<T: Real = f64> {
    tau: Vec<T>,
}

impl<T: Lane<Element = f64>> Torques<T> {
    /// No torques on n joints.
    pub fn none(n: usize) -> Self {
        Self { tau: vec![T::zero(); n] }
    }

    /// The torques of a lane, one per coordinate.
    ///
    /// # Panics
    /// If there are not n, or if there is no such lane.
    pub fn set(&mut self, lane: usize, tau: &[f64]) {
        assert_eq!(tau.len(), self.tau.len(), "one torque per coordinate");
        self.tau.iter_mut().zip(tau).for_each(|(torque, &tau)| torque.set_lane(lane, tau));
    }
}

impl<T: Real> Loads<T> for Torques<T> {
    fn add(&mut self, instant: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        Forces::add(self, instant, load);
    }
}

impl<T: Real> Forces<T> for Torques<T> {
    fn add(&mut self, _: &Instant<'_, T>, load: &mut Load<T>) {
        load.tau.iter_mut().zip(&self.tau).for_each(|(tau, &torque)| *tau += torque);
    }
}
