//! Uniform gravity.
//!
//! ```text
//! γ = R₁ᵀ a        a: acceleration of free fall, world axes (m/s²);  γ: the same in base axes
//! ```
//!
//! It accelerates all mass alike, so it enters as the acceleration of the frame: `ξ̇` gets `[0; γ; 0]` (docs/mathematics.md §2).

use frs_core::{Moving, Real};
use nalgebra::Vector3;

use super::Effect;
use crate::motion::{Instant, Load, Loads};

/// Uniform gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gravity {
    /// Acceleration of free fall, world axes (m/s²).
    pub acceleration: [f64; 3],
}

impl<T: Real> Loads<T> for Gravity {
    fn add(&mut self, instant: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        let fall = instant.pose.rotation.transpose() * Vector3::from(self.acceleration.map(T::from_f64));
        load.gravity.iter_mut().zip(&fall).for_each(|(gravity, &fall)| *gravity += fall);
    }
}

impl<T: Real> Effect<T> for Gravity {}
