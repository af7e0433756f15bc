//! Computed torque: the shape follows a desired motion as independent oscillators do.
//!
//! ```text
//! e = q − q_d
//! τ = Λ_q (q̈_d − 2 ω ė − ω² e) + Γ'_q(q̇) q̇ + 2 B_2(μ) q̇ − c(μ)        so that  ë + 2 ω ė + ω² e = 0
//! ```
//!
//! In REL form the shape's equation has no μ̇ in it: the controller needs μ, but not the wrenches that change it, of which `A_lᵀ F₁`
//! remains as a disturbance.

use frs_core::{Moving, Real};

use super::Effect;
use crate::motion::{Course, Instant, Load, Loads};

/// Computed torque along desired courses.
#[derive(Clone, Debug)]
pub struct ComputedTorque<T: Real = f64> {
    courses: Vec<Course>,
    bandwidth: f64,
    qdd: Vec<T>,
    tau: Vec<T>,
}

impl<T: Real> ComputedTorque<T> {
    /// Along `courses`, one per coordinate, with bandwidth ω (rad/s).
    pub fn new(courses: Vec<Course>, bandwidth: f64) -> Self {
        let n = courses.len();
        Self { courses, bandwidth, qdd: vec![T::zero(); n], tau: vec![T::zero(); n] }
    }
}

impl<T: Real> Loads<T> for ComputedTorque<T> {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        let Self { courses, bandwidth, qdd: wanted, tau } = self;
        let [twice, square] = [2.0 * *bandwidth, *bandwidth * *bandwidth].map(T::from_f64);
        for (j, course) in courses.iter().enumerate() {
            let [q, qd, qdd] = course.at(instant.time);
            wanted[j] = qdd - twice * (instant.qd[j] - qd) - square * (instant.q[j] - q);
        }
        robot.shape_torque(instant.mu, wanted, tau);
        load.tau.iter_mut().zip(tau).for_each(|(load, &mut tau)| *load += tau);
    }
}

impl<T: Real> Effect<T> for ComputedTorque<T> {
    fn enter(&mut self, time: f64) {
        self.courses.iter_mut().for_each(|course| course.enter(time));
    }
}
