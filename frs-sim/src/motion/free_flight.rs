//! A rigid body that nothing holds: its centre of mass falls, its momentum turns it.

use std::ops::Range;

use frs_core::model::Inertial;
use frs_core::spatial::{Pose, Twist};
use nalgebra::{Matrix3, Vector3};

use crate::integrate::{Adaptive, DOP853, IntegrationError, State, System, Tangent};

/// `Ṙ = R ω^` with `ω = I⁻¹ Rᵀ h`: the spin h about the centre of mass is constant in axes of the world.
struct Spinning {
    inverse: Matrix3<f64>,
    spin: Vector3<f64>,
}

impl System for Spinning {
    fn dimension(&self) -> usize {
        0
    }

    fn velocities(&self) -> Range<usize> {
        0..0
    }

    fn rate(&mut self, _: f64, state: &State, rate: &mut Tangent) {
        let angular = self.inverse * (state.pose.rotation.transpose() * self.spin);
        rate.twist = Twist::new(angular, Vector3::zeros());
    }
}

/// Accuracy of a step.
const ACCURACY: f64 = 1e-10;

/// Principal moments below this share of the largest are those of a point or a rod, which does not turn about itself.
const THIN: f64 = 1e-12;

/// Poses of a free body's frame in the world at `times` (s) from now; all lie ahead or all in the past, and each is farther than the one
/// before.
///
/// Now the frame is at `pose` and moves with `twist` (its own axes, at its origin); `fall` is the acceleration of free fall (m/s², world axes).
///
/// # Errors
/// If it turns too fast for steps to follow.
pub fn free_flight(
    body: &Inertial,
    pose: &Pose<f64>,
    twist: Twist<f64>,
    fall: Vector3<f64>,
    times: impl IntoIterator<Item = f64>,
) -> Result<Vec<Pose<f64>>, IntegrationError> {
    let inertia = body.inertia.to_matrix();
    let thin = THIN * inertia.trace();
    let inverse = inertia.pseudo_inverse(thin).unwrap_or_else(|_| Matrix3::zeros());
    let (com, velocity) = (pose.transform(body.com), pose.rotation * twist.at(body.com).linear);
    let spin = pose.rotation * (inertia * twist.angular);
    let start = State { pose: Pose::new(pose.rotation, Vector3::zeros()), flat: Vec::new() };
    let mut path = Adaptive::new(&DOP853, start, 0.0, ACCURACY);
    let place = |time: f64| {
        // Back in time is ahead with the motion reversed.
        let mut spinning = Spinning { inverse, spin: spin * time.signum() };
        while path.time() < time.abs() {
            path.advance(&mut spinning, time.abs())?;
        }
        let rotation = path.state().pose.rotation;
        Ok(Pose::new(rotation, com + velocity * time + fall * (0.5 * time * time) - rotation * body.com))
    };
    times.into_iter().map(place).collect()
}
