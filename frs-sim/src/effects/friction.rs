//! Viscous friction in the joints.
//!
//! ```text
//! τ_j = −d_j q̇_j        d_j ≥ 0 (N·m·s/rad, N·s/m)
//! ```
//!
//! It takes the power `Σ d_j q̇_j²` and leaves the momentum alone.

use frs_core::Real;

use super::Effect;
use crate::motion::{Instant, Load, Loads};

/// Viscous friction in the joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    /// d, one per coordinate (N·m·s/rad, N·s/m).
    pub viscous: Vec<f64>,
}

impl<T: Real> Loads<T> for Friction {
    fn add(&mut self, instant: &Instant<'_, T>, load: &mut Load<T>) {
        for ((tau, &viscous), &qd) in load.tau.iter_mut().zip(&self.viscous).zip(instant.qd) {
            *tau -= T::from_f64(viscous) * qd;
        }
    }
}

impl<T: Real> Effect<T> for Friction {}
