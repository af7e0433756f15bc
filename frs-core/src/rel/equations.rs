//! The REL equations solved: for the accelerations, and for the forces.

use crate::Real;
use crate::spatial::{Twist, Wrench};
use crate::sweep::{Moving, articulated_accelerations, newton_euler, project};

use super::factor::{factor, solve};

impl<T: Real> Moving<'_, '_, '_, T> {
    /// `ξ̇ = [μ̇; q̈]` (length 6+n) from wrench `F₁` on the base (base frame) and joint torques `τ`, factoring Λ_q.
    ///
    /// `Λ_b μ̇ = ad_{V₁}ᵀ Λ_b μ − P(q̇) μ + F₁` and `Λ_q q̈ = [D_μ ξ − D_q̇ ξ]_q + τ − A_lᵀ F₁` (the paper, Theorem 1).
    /// O(n³), and accurate to the rounding of Λ_q.
    ///
    /// ```
    /// # use frs_core::{Model, Workspace, spatial::{Twist, Wrench}};
    /// # let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
    /// # let mut work = Workspace::new(&model);
    /// let mut xi_dot = [0.0; 13];
    /// let mut shape = work.shape(&[0.1; 7]);
    /// let mut motion = shape.moving(&[0.0; 7]);
    /// motion.forward_dynamics(Twist::zero(), Wrench::zero(), &[0.0; 7], &mut xi_dot);
    /// assert_eq!(xi_dot, [0.0; 13]); // at rest, and nothing pushes
    /// # Ok::<(), frs_core::urdf::UrdfError>(())
    /// ```
    ///
    /// # Panics
    /// If `tau` does not have n entries or `xi_dot` 6+n.
    pub fn forward_dynamics(&mut self, mu: Twist<T>, base_wrench: Wrench<T>, tau: &[T], xi_dot: &mut [T]) {
        let com = self.com();
        let (centroidal, wrench) = (mu.at(com), base_wrench.at(com));
        let mut matrix = std::mem::take(&mut self.data.matrix);
        self.shape_inertia(&mut matrix);

        let (model, data) = (self.model, &mut *self.data);
        newton_euler(model, data, centroidal, Twist::zero(), |_| T::zero());
        let acceleration = &mut xi_dot[6..];
        project(model, data, acceleration);
        let mut carried = std::mem::take(&mut data.vector);
        model.gather(&mut carried, |j| data.connection[j].dot(wrench));
        for ((x, &tau), &carried) in acceleration.iter_mut().zip(tau).zip(&carried) {
            *x = tau - carried - *x;
        }
        factor(&mut matrix);
        solve(&matrix, acceleration);
        (data.vector, data.matrix) = (carried, matrix);
        self.locked_acceleration(centroidal, wrench, xi_dot);
    }

    /// `ξ̇ = [μ̇; q̈]` as [`forward_dynamics`](Self::forward_dynamics), in O(n) by an articulated-body sweep:
    /// `(M⁻¹)_qq = Λ_q⁻¹`.
    ///
    /// A mimic joint ties joints that the sweep takes as independent: for such robots Λ_q is factored.
    ///
    /// # Panics
    /// If `tau` does not have n entries or `xi_dot` 6+n.
    pub fn forward_dynamics_articulated(&mut self, mu: Twist<T>, base_wrench: Wrench<T>, tau: &[T], xi_dot: &mut [T]) {
        if self.model.has_mimic() {
            return self.forward_dynamics(mu, base_wrench, tau, xi_dot);
        }
        let com = self.com();
        let (centroidal, wrench) = (mu.at(com), base_wrench.at(com));
        articulated_accelerations(self.model, self.data, centroidal, wrench, tau);
        self.model.gather(&mut xi_dot[6..], |j| self.data.row[j]);
        self.locked_acceleration(centroidal, wrench, xi_dot);
    }

    /// The base wrench `F₁` (base frame, returned) and joint torques `τ` (length n) that give `ξ̇ = [μ̇; q̈]`, in O(n).
    ///
    /// # Panics
    /// If `xi_dot` does not have 6+n entries or `tau` n.
    pub fn inverse_dynamics(&mut self, mu: Twist<T>, xi_dot: &[T], tau: &mut [T]) -> Wrench<T> {
        assert_eq!(xi_dot.len(), 6 + self.model.dof(), "ξ̇ must have 6+n entries");
        let (com, qdd) = (self.com(), &xi_dot[6..]);
        let centroidal = mu.at(com);
        let mu_dot = Twist::from_array(std::array::from_fn(|i| xi_dot[i])).at(com);
        let required = self.locked_momentum(mu_dot) + self.locked_rate() * centroidal - self.momentum_rate(centroidal);

        let (model, data) = (self.model, &mut *self.data);
        let joint_acceleration = |j: usize| {
            let drive = model.bodies()[j + 1].drive;
            qdd[drive.coordinate] * drive.ratio
        };
        let mut base = Twist::zero();
        for j in 0..model.joints() {
            base = base - data.connection[j] * joint_acceleration(j);
        }
        newton_euler(model, data, centroidal, base, joint_acceleration);
        project(model, data, tau);
        let mut carried = std::mem::take(&mut data.vector);
        model.gather(&mut carried, |j| data.connection[j].dot(required));
        for (tau, &carried) in tau.iter_mut().zip(&carried) {
            *tau += carried;
        }
        data.vector = carried;
        required.at(-com)
    }

    /// μ̇ from the momentum equation, into the first six entries of `xi_dot`; arguments in the centroidal frame.
    fn locked_acceleration(&mut self, mu: Twist<T>, base_wrench: Wrench<T>, xi_dot: &mut [T]) {
        let rate = self.momentum_rate(mu) - self.locked_rate() * mu + base_wrench;
        let acceleration = self.locked_solve(rate).at(-self.com());
        xi_dot[..6].copy_from_slice(&acceleration.to_array());
    }
}
