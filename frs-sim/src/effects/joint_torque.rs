//! Constant joint torques.
//!
//! ```text
//! τ = τ₀        N·m, N; one per coordinate
//! ```

use frs_core::Real;

use super::Effect;
use crate::motion::{Instant, Load, Loads};

/// Constant joint torques.
#[derive(Clone, Debug, PartialEq)]
pub struct JointTorque {
    /// τ₀, one per coordinate (N·m, N).
    pub tau: Vec<f64>,
}

impl<T: Real> Loads<T> for JointTorque {
    fn add(&mut self, _: &Instant<'_, T>, load: &mut Load<T>) {
        load.tau.iter_mut().zip(&self.tau).for_each(|(tau, &torque)| *tau += T::from_f64(torque));
    }
}

impl<T: Real> Effect<T> for JointTorque {}
