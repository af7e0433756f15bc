//! Momentum in its three frames, and kinetic energy.

use crate::Real;
use crate::spatial::{Pose, Twist, Wrench};
use crate::sweep::{Moving, Shape};

impl<T: Real> Shape<'_, '_, T> {
    /// The body momentum `Λ_b μ` (base frame).
    pub fn body_momentum(&self, mu: Twist<T>) -> Wrench<T> {
        self.centroidal_momentum(mu).at(-self.com())
    }

    /// `μ = Λ_b⁻¹ p`, the locked velocity with the body momentum `p` (both base frame): [`body_momentum`](Self::body_momentum) undone.
    pub fn velocity_of_momentum(&self, momentum: Wrench<T>) -> Twist<T> {
        self.velocity_of_centroidal_momentum(momentum.at(self.com()))
    }

    /// μ (base frame) from the momentum `h` about the centre of mass in base axes: [`centroidal_momentum`](Self::centroidal_momentum)
    /// undone.
    pub fn velocity_of_centroidal_momentum(&self, momentum: Wrench<T>) -> Twist<T> {
        self.locked_solve(momentum).at(-self.com())
    }

    /// The momentum about the centre of mass, in base axes.
    pub fn centroidal_momentum(&self, mu: Twist<T>) -> Wrench<T> {
        self.locked_momentum(mu.at(self.com()))
    }

    /// Λ_c μ, both in the centroidal frame.
    pub(crate) fn locked_momentum(&self, mu: Twist<T>) -> Wrench<T> {
        let locked = &self.data.composite[0];
        Wrench::new(locked.rotational * mu.angular, mu.linear * locked.mass)
    }

    /// The spatial momentum `J = Ad_{g₁}⁻ᵀ Λ_b μ` about the world's origin, constant in free flight; `pose` is `g₁`.
    pub fn spatial_momentum(&self, pose: &Pose<T>, mu: Twist<T>) -> Wrench<T> {
        pose.act_wrench(self.body_momentum(mu))
    }
}

impl<T: Real> Moving<'_, '_, '_, T> {
    /// The kinetic energy `½ ξᵀ Λ ξ = ½ μᵀ Λ_b μ + ½ q̇ᵀ Λ_q q̇` (J).
    pub fn kinetic_energy(&self, mu: Twist<T>) -> T {
        let centroidal = mu.at(self.com());
        let mut twice = centroidal.dot(self.centroidal_momentum(mu));
        for k in 0..self.model.bodies().len() {
            let (velocity, inertia) = (self.data.velocity[k], self.data.inertia[k]);
            twice += velocity.dot(inertia * velocity);
        }
        twice * T::from_f64(0.5)
    }
}
