//! The locked velocity, observed from pose, shape and shape velocity.
//!
//! ```text
//! φ = log(R̂ᵀ R₁),  d = c − ĉ                                  how far the estimates of attitude and centre of mass lag
//! ω̂ = z_ω + k φ,   v̂ = z_v + k d                              μ̂ seen from the centre of mass; v̂ in world axes
//!
//! R̂' = R₁ (Ω̂ + k φ)× R₁ᵀ R̂        Ω̂ = ω̂ − (A_l q̇)_ω            J ż_ω = n + (J ω̂) × Ω̂ − J̇ ω̂ + k² J φ
//! ĉ' = v̂ + k d                                                 ż_v = f/m + a + k² d
//! ```
//!
//! with n, f the wrench about the centre of mass (n in base axes, f in those of the world), a the acceleration of free fall. The error `e = μ̂ − μ`
//! obeys
//!
//! ```text
//! v_e' = −k v_e,   J ω_e' = (J ω_e) × Ω̂ + (J ω) × ω_e − J̇ ω_e − k J dexp⁻¹_{−φ} ω_e
//! V = ½ eᵀ Λ_b e,  V' = −2 k V − ½ ω_eᵀ X ω_e + O(|φ| V),   X = J̇ + Ω̂× J − J Ω̂×
//! ```
//!
//! Neither base twist nor μ is read. Derivation: docs/mathematics.md §6.

use frs_core::Moving;
use frs_core::spatial::{Pose, Twist, Wrench, so3};
use nalgebra::Vector3;

use crate::integrate::{State, Tangent};

/// An observer of the locked velocity. Its state has the pose (R̂, ĉ) and the numbers z_ω, z_v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observer {
    /// k > 0, 1/s: by so much a second the error falls.
    pub gain: f64,
    /// μ̂ at the start, base frame.
    pub guess: Twist<f64>,
}

/// What acts from outside on a robot that is observed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outside {
    /// F₁, base frame.
    pub base_wrench: Wrench<f64>,
    /// Acceleration of free fall, world axes (m/s²).
    pub gravity: Vector3<f64>,
}

/// What an observer is wrong by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// μ̂ − μ, base frame (rad/s, m/s).
    pub error: Twist<f64>,
    /// `½ (μ̂ − μ)ᵀ Λ_b (μ̂ − μ)`, J.
    pub lyapunov: f64,
}

impl Observer {
    /// The state that does not lag, with an estimate of μ (base frame) for a robot with this pose and centre of mass (base frame).
    pub fn state(&self, pose: &Pose<f64>, com: Vector3<f64>, estimate: Twist<f64>) -> State {
        let Twist { angular, linear } = estimate.at(com);
        let flat = angular.iter().chain(&(pose.rotation * linear)).copied().collect();
        State { pose: Pose::new(pose.rotation, pose.transform(com)), flat }
    }

    /// φ, and d in world axes.
    fn lags(pose: &Pose<f64>, com: Vector3<f64>, state: &State) -> [Vector3<f64>; 2] {
        let turn = state.pose.rotation.transpose() * pose.rotation;
        [so3::log(&turn), pose.transform(com) - state.pose.translation]
    }

    /// μ̂ (base frame) for a robot with this pose and centre of mass (base frame).
    pub fn estimate(&self, pose: &Pose<f64>, com: Vector3<f64>, state: &State) -> Twist<f64> {
        let [phi, lag] = Self::lags(pose, com, state);
        let angular = Vector3::from_column_slice(&state.flat[..3]) + phi * self.gain;
        let velocity = Vector3::from_column_slice(&state.flat[3..]) + lag * self.gain;
        Twist::new(angular, pose.rotation.transpose() * velocity).at(-com)
    }

    /// The state's tangent.
    pub fn rate(
        &self,
        pose: &Pose<f64>,
        robot: &mut Moving<'_, '_, '_>,
        outside: Outside,
        state: &State,
        rate: &mut Tangent,
    ) {
        let (com, k) = (robot.com(), self.gain);
        let [phi, lag] = Self::lags(pose, com, state);
        let estimate = self.estimate(pose, com, state);
        let velocity = pose.rotation * estimate.at(com).linear;

        let into = state.pose.rotation.transpose();
        let turning = robot.base_twist(estimate).angular + phi * k;
        rate.twist = Twist::new(into * (pose.rotation * turning), into * (velocity + lag * k));

        let faster = robot.locked_acceleration(estimate, outside.base_wrench).angular;
        let mass = robot.locked_inertia().mass;
        let thrown = pose.rotation * outside.base_wrench.force / mass + outside.gravity;
        rate.flat[..3].copy_from_slice((faster + phi * (k * k)).as_slice());
        rate.flat[3..].copy_from_slice((thrown + lag * (k * k)).as_slice());
    }
}
