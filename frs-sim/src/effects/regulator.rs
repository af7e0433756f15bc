//! Regulation of the shape about a set point, with the momentum decoupled or not.
//!
//! ```text
//! τ = −K (q − q_d) − D q̇ + τ_d
//!
//! none       τ_d = 0
//! coupling   τ_d = −c(μ)                      c(μ) = (S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}) μ
//! tau_bar    τ_d = −Γ_bqᵀ μ = −c(μ) + B_2(μ) q̇
//! ```
//!
//! With `coupling` the shape obeys `Λ_q q̈ + (Γ'_q + 2 B_2) q̇ = −K (q − q_d) − D q̇`, with `tau_bar` the same with one `B_2`: in the
//! older form of the equations `Γ_q = Γ'_q + B_2` and the momentum acts on the shape by `Γ_bqᵀ μ = c(μ) − B_2(μ) q̇`. As `B_2` is
//! skew, `q̇ᵀ B_2 q̇ = 0`: the two differ by a torque that does no work, and `½ q̇ᵀ Λ_q q̇ + ½ (q − q_d)ᵀ K (q − q_d)` falls with either.
//!
//! Source: the paper, Theorem 1 and its example; docs/mathematics.md §2.

use frs_core::spatial::Twist;
use frs_core::{Moving, Real};

use super::Effect;
use crate::motion::{Instant, Load, Loads};

/// What a regulator does about the momentum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decoupling {
    /// Nothing.
    None,
    /// Cancels `Γ_bqᵀ μ`, which depends on q̇.
    TauBar,
    /// Cancels the (μ, μ) coupling torque alone.
    Coupling,
}

/// What a regulator is told.
#[derive(Clone, Debug, PartialEq)]
pub struct Gains {
    /// q_d, one per coordinate (rad, m).
    pub set_point: Vec<f64>,
    /// K ≥ 0, one per coordinate (N·m/rad, N/m).
    pub stiffness: Vec<f64>,
    /// D ≥ 0, one per coordinate (N·m·s/rad, N·s/m).
    pub damping: Vec<f64>,
    /// What is done about the momentum.
    pub decoupling: Decoupling,
}

/// Regulation of the shape about a set point.
#[derive(Clone, Debug)]
pub struct Regulator<T: Real = f64> {
    gains: Gains,
    coupling: Vec<T>,
    d_mu_xi: Vec<T>,
}

impl<T: Real> Regulator<T> {
    /// Regulation with `gains`.
    pub fn new(gains: Gains) -> Self {
        let n = gains.set_point.len();
        Self { gains, coupling: vec![T::zero(); n], d_mu_xi: vec![T::zero(); 6 + n] }
    }

    /// τ_d of a robot with locked velocity μ, N·m, N.
    pub fn decoupling_torque(&mut self, robot: &mut Moving<'_, '_, '_, T>, mu: Twist<T>) -> &[T] {
        let Self { gains, coupling, d_mu_xi } = self;
        if gains.decoupling != Decoupling::None {
            robot.coupling_torque(mu, coupling);
        }
        match gains.decoupling {
            Decoupling::None => {}
            Decoupling::Coupling => coupling.iter_mut().for_each(|torque| *torque = -*torque),
            Decoupling::TauBar => {
                // The shape's half of D_μ ξ is c − 2 B_2 q̇, so −c + B_2 q̇ is half the sum of it and c, negated.
                robot.d_mu_xi(mu, d_mu_xi);
                let minus_half = T::from_f64(-0.5);
                for (torque, &whole) in coupling.iter_mut().zip(&d_mu_xi[6..]) {
                    *torque = minus_half * (*torque + whole);
                }
            }
        }
        coupling
    }
}

impl<T: Real> Loads<T> for Regulator<T> {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        if self.gains.decoupling != Decoupling::None {
            let decoupling = self.decoupling_torque(robot, instant.mu);
            load.tau.iter_mut().zip(decoupling).for_each(|(tau, &torque)| *tau += torque);
        }
        let Gains { set_point, stiffness, damping, .. } = &self.gains;
        for (j, tau) in load.tau.iter_mut().enumerate() {
            let [set_point, stiffness, damping] = [set_point, stiffness, damping].map(|of| T::from_f64(of[j]));
            *tau -= stiffness * (instant.q[j] - set_point) + damping * instant.qd[j];
        }
    }
}

impl<T: Real> Effect<T> for Regulator<T> {}
