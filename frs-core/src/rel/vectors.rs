//! The terms of the equations as vectors, without forming a matrix: one sweep each.

use nalgebra::Vector3;

use crate::Real;
use crate::spatial::{Twist, Wrench};
use crate::sweep::{Moving, Shape, newton_euler, project, subtree_sums};

impl<T: Real> Shape<'_, '_, T> {
    /// The coupling torque `S(μ)ᵀ μ − A_lᵀ ad~_{Λ_bμ} μ` (length n): the (μ, μ) term of the shape equation.
    ///
    /// Per joint `ŝ_j·(ad_μᵀ Iᶜ_j μ) − A_j·(ad_μᵀ Iᵒ_j μ)`: what turning as one rigid body asks of the joints. It depends on the
    /// angular part of μ alone.
    ///
    /// # Panics
    /// If `out` does not have n entries.
    pub fn coupling_torque(&self, mu: Twist<T>, out: &mut [T]) {
        let (data, mu) = (&*self.data, turning(mu));
        self.model.gather(out, |j| {
            let inside = mu.ad_transpose(data.composite[j + 1] * mu);
            let outside = mu.ad_transpose(data.complement[j + 1] * mu);
            data.reaction.at::<Twist<T>>(j).dot(inside) - data.connection.at::<Twist<T>>(j).dot(outside)
        });
    }
}

/// The locked velocity without that of the centre of mass, which no joint feels: the forces `m ω × v` of a common velocity v are those
/// of a common acceleration, and joints move at zero momentum. Kept in, it would be rounded: `v × m v` is not 0 (docs/hard.md).
pub(super) fn turning<T: Real>(mu: Twist<T>) -> Twist<T> {
    Twist::new(mu.angular, Vector3::zeros())
}

impl<T: Real> Moving<'_, '_, '_, T> {
    /// `D_q̇ ξ = [½ P(q̇) μ; Γ'_q(q̇) q̇]` (length 6+n).
    ///
    /// # Panics
    /// If `out` does not have 6+n entries.
    pub fn d_qdot_xi(&mut self, mu: Twist<T>, out: &mut [T]) {
        let (com, half) = (self.com(), T::from_f64(0.5));
        let upper = ((self.locked_rate() * mu.at(com)) * half).at(-com);
        self.gamma_q_rates(&mut out[6..]);
        out[..6].copy_from_slice(&upper.to_array());
    }

    /// `D_μ ξ` (length 6+n): with momentum h = Λ_b μ, `[ad_{V₁}ᵀ h − ½ P(q̇) μ; coupling torque − 2 B_2(μ) q̇]`.
    ///
    /// # Panics
    /// If `out` does not have 6+n entries.
    pub fn d_mu_xi(&mut self, mu: Twist<T>, out: &mut [T]) {
        let (com, half) = (self.com(), T::from_f64(0.5));
        let upper = (self.momentum_rate(mu.at(com)) - (self.locked_rate() * mu.at(com)) * half).at(-com);
        let (model, data) = (self.model, &mut *self.data);
        for k in 0..model.bodies().len() {
            data.wrench[k] = data.inertia[k].coriolis(mu.angular, data.velocity[k]);
        }
        let mut turned = std::mem::take(&mut data.vector);
        project(model, data, &mut turned);
        self.coupling_torque(mu, &mut out[6..]);
        for (out, turned) in out[6..].iter_mut().zip(&turned) {
            *out = *out - *turned - *turned;
        }
        self.data.vector = turned;
        out[..6].copy_from_slice(&upper.to_array());
    }

    /// `∂T/∂q` (length n), the gradient of the kinetic energy where the base twist and q̇ are held: per joint `h_j·ad_{V_p} s_j`, with
    /// the momentum h of its subtree and the velocity of the body that it is on.
    ///
    /// # Panics
    /// If `out` does not have n entries.
    pub fn kinetic_gradient(&mut self, mu: Twist<T>, out: &mut [T]) {
        let mu = mu.at(self.com());
        let (model, data) = (self.model, &mut *self.data);
        for k in 0..model.bodies().len() {
            data.wrench[k] = data.inertia[k] * (data.velocity[k] + mu);
        }
        subtree_sums(model.bodies(), &mut data.wrench, &mut data.wrench_outside);
        model.gather(out, |j| {
            let carried = data.velocity[model.bodies()[j + 1].parent] + mu;
            carried.ad(data.screw.at(j)).dot(data.wrench[j + 1])
        });
    }

    /// `Γ'_q(q̇) q̇` (length n), one Newton-Euler sweep at zero momentum.
    ///
    /// # Panics
    /// If `out` does not have n entries.
    pub fn gamma_q_rates(&mut self, out: &mut [T]) {
        let (model, data) = (self.model, &mut *self.data);
        newton_euler(model, data, Twist::zero(), Twist::zero(), |_| T::zero());
        project(model, data, out);
    }

    /// ad_{V₁}ᵀ Λ_c μ, everything in the centroidal frame: the rate of the body momentum without a wrench.
    ///
    /// `v × m v = 0` is left out, see [`turning`].
    pub(crate) fn momentum_rate(&self, mu: Twist<T>) -> Wrench<T> {
        (turning(mu) + self.data.velocity[0]).ad_transpose(self.locked_momentum(mu))
    }
}
