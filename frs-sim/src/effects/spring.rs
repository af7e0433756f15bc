//! Linear springs in the joints.
//!
//! ```text
//! τ_j = −k_j (q_j − r_j)        k_j ≥ 0 (N·m/rad, N/m), r_j: rest position (rad, m)
//! ```
//!
//! They store `½ Σ k_j (q_j − r_j)²` and leave the momentum alone.

use frs_core::{Moving, Real};

use super::Effect;
use crate::motion::{Instant, Load, Loads};

/// Linear springs in the joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    /// k, one per coordinate (N·m/rad, N/m).
    pub stiffness: Vec<f64>,
    /// r, one per coordinate (rad, m).
    pub rest: Vec<f64>,
}

impl<T: Real> Loads<T> for Spring {
    fn add(&mut self, instant: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        for (((tau, &stiffness), &rest), &q) in load.tau.iter_mut().zip(&self.stiffness).zip(&self.rest).zip(instant.q)
        {
            *tau -= T::from_f64(stiffness) * (q - T::from_f64(rest));
        }
    }
}

impl<T: Real> Effect<T> for Spring {}
