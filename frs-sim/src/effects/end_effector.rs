//! A link pulled to a place in the world, through the generalized Jacobian.
//!
//! ```text
//! F_k = [0; −R_kᵀ K (x − x_d) − D v_k]                x, v_k: position (world) and velocity (link axes) of the link's origin
//! τ = J̃_kᵀ F_k − c(μ) − D_q q̇
//! ```
//!
//! J̃ is the Jacobian on the floating base, `v_k = J̃_k q̇ + X_k μ`: with the momentum conserved, torques `J̃ᵀ F` do the work that the force F
//! would do on the link, and the base reacts as it will. D_q (N·m·s/rad, N·s/m) damps what the hand does not see.

use frs_core::{Moving, Real};
use nalgebra::{Matrix6xX, Vector3};

use super::Effect;
use crate::motion::{Instant, Load, Loads};

/// What the controller is told.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// The link's number.
    pub link: usize,
    /// x_d, m, world.
    pub position: [f64; 3],
    /// K, N/m.
    pub stiffness: f64,
    /// D, N·s/m.
    pub damping: f64,
    /// D_q, one per coordinate (N·m·s/rad, N·s/m).
    pub joint_damping: Vec<f64>,
}

/// A link pulled to a place in the world.
#[derive(Clone, Debug)]
pub struct EndEffector<T: Real = f64> {
    target: Target,
    jacobian: Matrix6xX<T>,
    coupling: Vec<T>,
}

impl<T: Real> EndEffector<T> {
    /// Control to `target`.
    pub fn new(target: Target) -> Self {
        let n = target.joint_damping.len();
        Self { target, jacobian: Matrix6xX::zeros(n), coupling: vec![T::zero(); n] }
    }
}

impl<T: Real> Loads<T> for EndEffector<T> {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        let Self { target, jacobian, coupling } = self;
        let place = *instant.pose * robot.link_pose(target.link);
        let [stiffness, damping] = [target.stiffness, target.damping].map(T::from_f64);
        let error = place.translation - Vector3::from(target.position.map(T::from_f64));
        let velocity = robot.link_twist(target.link, instant.mu).linear;
        let force = -(place.rotation.transpose() * error * stiffness + velocity * damping);
        robot.generalized_jacobian(target.link, jacobian);
        robot.coupling_torque(instant.mu, coupling);
        for (j, tau) in load.tau.iter_mut().enumerate() {
            let pulled = jacobian[(3, j)] * force.x + jacobian[(4, j)] * force.y + jacobian[(5, j)] * force.z;
            *tau += pulled - coupling[j] - T::from_f64(target.joint_damping[j]) * instant.qd[j];
        }
    }
}

impl<T: Real> Effect<T> for EndEffector<T> {}
