//! Friction in the joints.
//!
//! ```text
//! τ_j = −d_j q̇_j − c_j q̇_j / √(q̇_j² + v²)        d_j ≥ 0 (N·m·s/rad, N·s/m), c_j ≥ 0 (N·m, N)
//! ```
//!
//! The second term is Coulomb's, smooth: below the rate v (rad/s, m/s) it passes from one side to the other. Both take power and
//! leave the momentum alone.

use frs_core::{Moving, Real};

use super::Effect;
use crate::motion::{Instant, Load, Loads};

/// Viscous friction in the joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Viscous {
    /// d, one per coordinate (N·m·s/rad, N·s/m).
    pub damping: Vec<f64>,
}

/// Smooth Coulomb friction in the joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Coulomb {
    /// c, one per coordinate (N·m, N).
    pub torque: Vec<f64>,
    /// v > 0, rad/s or m/s.
    pub smooth_below: f64,
}

impl<T: Real> Loads<T> for Viscous {
    fn add(&mut self, instant: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        for ((tau, &damping), &qd) in load.tau.iter_mut().zip(&self.damping).zip(instant.qd) {
            *tau -= T::from_f64(damping) * qd;
        }
    }
}

impl<T: Real> Loads<T> for Coulomb {
    fn add(&mut self, instant: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        let square = T::from_f64(self.smooth_below * self.smooth_below);
        for ((tau, &torque), &qd) in load.tau.iter_mut().zip(&self.torque).zip(instant.qd) {
            *tau -= T::from_f64(torque) * qd / (qd * qd + square).sqrt();
        }
    }
}

impl<T: Real> Effect<T> for Viscous {}
impl<T: Real> Effect<T> for Coulomb {}
