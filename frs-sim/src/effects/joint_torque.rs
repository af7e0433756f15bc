//! Joint torques as functions of time.
//!
//! ```text
//! τ_j = τ_j(t)        N·m, N; one function per coordinate
//! ```

use frs_core::{Moving, Real};

use super::Effect;
use crate::motion::{Instant, Load, Loads};
use crate::signal::Signal;

/// Joint torques as functions of time.
#[derive(Clone, Debug, PartialEq)]
pub struct JointTorque {
    /// τ(t), one per coordinate (N·m, N).
    pub tau: Vec<Signal>,
}

impl<T: Real> Loads<T> for JointTorque {
    fn add(&mut self, instant: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        for (tau, torque) in load.tau.iter_mut().zip(&self.tau).filter(|(_, torque)| !torque.is_zero()) {
            *tau += torque.at(instant.time);
        }
    }
}

impl<T: Real> Effect<T> for JointTorque {
    fn enter(&mut self, time: f64) {
        self.tau.iter_mut().for_each(|torque| torque.enter(time));
    }
}
