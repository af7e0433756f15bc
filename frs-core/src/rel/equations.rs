//! The REL equations solved: for the accelerations, and for the forces.

use crate::Real;
use crate::ldl::{factor, solve};
use crate::spatial::{Twist, Wrench};
use crate::sweep::{Data, Moving, articulated_accelerations, newton_euler, project};

use super::vectors::turning;

/// How `q̈` is found. All ways give the same but for rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Route {
    /// An articulated-body sweep, which never forms Λ_q: O(n). Over a light base it loses about as many digits as the base is
    /// lighter than the arm.
    #[default]
    Articulated,
    /// Λ_q by the complement form, factored: O(n³), and as accurate as Λ_q is well conditioned.
    Complement,
    /// Λ_q by the textbook form `M_q − A_lᵀ Λ_b A_l`, factored: O(n³), and it loses digits over a light base.
    Textbook,
}

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
        self.shape_acceleration_by(Route::Complement, mu, base_wrench, tau, &mut xi_dot[6..]);
        xi_dot[..6].copy_from_slice(&self.locked_acceleration(mu, base_wrench).to_array());
    }

    /// `ξ̇ = [μ̇; q̈]` as [`forward_dynamics`](Self::forward_dynamics), in O(n) by an articulated-body sweep:
    /// `(M⁻¹)_qq = Λ_q⁻¹`.
    ///
    /// A mimic joint ties joints that the sweep takes as independent: for such robots Λ_q is factored.
    ///
    /// # Panics
    /// If `tau` does not have n entries or `xi_dot` 6+n.
    pub fn forward_dynamics_articulated(&mut self, mu: Twist<T>, base_wrench: Wrench<T>, tau: &[T], xi_dot: &mut [T]) {
        self.shape_acceleration(mu, base_wrench, tau, &mut xi_dot[6..]);
        xi_dot[..6].copy_from_slice(&self.locked_acceleration(mu, base_wrench).to_array());
    }

    /// The shape's half `q̈` (length n) of [`forward_dynamics_articulated`](Self::forward_dynamics_articulated): all that is to be
    /// integrated where the momentum is known.
    ///
    /// # Panics
    /// If `tau` or `qdd` does not have n entries.
    pub fn shape_acceleration(&mut self, mu: Twist<T>, base_wrench: Wrench<T>, tau: &[T], qdd: &mut [T]) {
        self.shape_acceleration_by(Route::Articulated, mu, base_wrench, tau, qdd);
    }

    /// [`shape_acceleration`](Self::shape_acceleration) by a route of one's own.
    ///
    /// # Panics
    /// If `tau` or `qdd` does not have n entries.
    pub fn shape_acceleration_by(
        &mut self,
        route: Route,
        mu: Twist<T>,
        base_wrench: Wrench<T>,
        tau: &[T],
        qdd: &mut [T],
    ) {
        assert!(
            tau.len() == self.model.dof() && qdd.len() == tau.len(),
            "tau and q̈ must have one entry per coordinate"
        );
        let wrench = base_wrench.at(self.com());
        if route == Route::Articulated && !self.model.has_mimic() {
            articulated_accelerations(self.model, self.data, turning(mu), wrench, tau);
            return self.model.gather(qdd, |j| self.data.row[j]);
        }
        let mut matrix = std::mem::take(&mut self.data.matrix);
        match route {
            Route::Textbook => self.shape_inertia_textbook(&mut matrix),
            Route::Articulated | Route::Complement => self.shape_inertia(&mut matrix),
        }
        self.required_torques(mu, wrench, None);
        let Data { vector, vector_more, .. } = &*self.data;
        for (((x, &tau), &carried), &bias) in qdd.iter_mut().zip(tau).zip(vector_more).zip(vector) {
            *x = tau - carried - bias;
        }
        factor(&mut matrix);
        solve(&matrix, qdd);
        self.data.matrix = matrix;
    }

    /// Hybrid dynamics: some joints are given torques and accelerate, others are given accelerations and need torques.
    ///
    /// Coordinate i is of the second kind where `given[i]`: there `qdd[i]` is read and `tau[i]` written, elsewhere `tau[i]` is read
    /// and `qdd[i]` written. With f for the free and g for the given ones, `b` for all terms without accelerations,
    /// `(Λ_q + J)_ff q̈_f = τ_f − b_f − Λ_q,fg q̈_g` and `τ_g = [(Λ_q + J) q̈ + b]_g`: Λ is block diagonal, so that μ̇ does not enter.
    /// `rotor` is the diagonal of J, what the drives' rotors add to the shape inertia (kg·m², kg).
    ///
    /// # Panics
    /// If a slice does not have n entries.
    pub fn hybrid_dynamics(
        &mut self,
        mu: Twist<T>,
        base_wrench: Wrench<T>,
        rotor: &[T],
        given: &[bool],
        tau: &mut [T],
        qdd: &mut [T],
    ) {
        let n = self.model.dof();
        assert!(
            [rotor.len(), given.len(), tau.len(), qdd.len()] == [n; 4],
            "each slice must have one entry per coordinate"
        );
        let com = self.com();
        let wrench = base_wrench.at(com);
        if given.contains(&false) {
            let mut matrix = std::mem::take(&mut self.data.matrix);
            self.shape_inertia(&mut matrix);
            self.required_torques(mu, wrench, None);
            for i in 0..n {
                matrix[(i, i)] += rotor[i];
            }
            for i in (0..n).filter(|&i| !given[i]) {
                qdd[i] = tau[i] - self.data.vector_more[i] - self.data.vector[i];
                for k in (0..n).filter(|&k| given[k]) {
                    qdd[i] -= matrix[(i, k)] * qdd[k];
                }
            }
            // What is given solves an equation of its own.
            for k in (0..n).filter(|&k| given[k]) {
                matrix.row_mut(k).fill(T::zero());
                matrix.column_mut(k).fill(T::zero());
                matrix[(k, k)] = T::one();
            }
            factor(&mut matrix);
            solve(&matrix, qdd);
            self.data.matrix = matrix;
        }
        if given.contains(&true) {
            self.required_torques(mu, wrench, Some(qdd));
            for k in (0..n).filter(|&k| given[k]) {
                tau[k] = self.data.vector[k] + self.data.vector_more[k] + rotor[k] * qdd[k];
            }
        }
    }

    /// The shape's half of [`inverse_dynamics`](Self::inverse_dynamics) without a wrench on the base: the torques
    /// `τ = Λ_q q̈ + [D_q̇ ξ − D_μ ξ]_q` (length n) that give `q̈`.
    ///
    /// # Panics
    /// If `qdd` or `tau` does not have n entries.
    pub fn shape_torque(&mut self, mu: Twist<T>, qdd: &[T], tau: &mut [T]) {
        self.required_torques(mu, Wrench::zero(), Some(qdd));
        tau.copy_from_slice(&self.data.vector);
    }

    /// The torques that joint accelerations (none: 0) and the motion require, into `data.vector`, and those that a wrench on the base
    /// requires, into `data.vector_more`. The wrench in the centroidal frame; of μ only the angular part is read.
    fn required_torques(&mut self, mu: Twist<T>, wrench: Wrench<T>, qdd: Option<&[T]>) {
        let (model, data, mu) = (self.model, &mut *self.data, turning(mu));
        let (mut torque, mut carried) = (std::mem::take(&mut data.vector), std::mem::take(&mut data.vector_more));
        match qdd {
            None => newton_euler(model, data, mu, Twist::zero(), |_| T::zero()),
            Some(qdd) => {
                let acceleration = |j: usize| {
                    let drive = model.bodies()[j + 1].drive;
                    qdd[drive.coordinate] * drive.ratio
                };
                let mut base = Twist::zero();
                for j in 0..model.joints() {
                    base = base - data.connection.at::<Twist<T>>(j) * acceleration(j);
                }
                newton_euler(model, data, mu, base, acceleration);
            }
        }
        project(model, data, &mut torque);
        model.gather(&mut carried, |j| data.connection.at::<Twist<T>>(j).dot(wrench));
        (data.vector, data.vector_more) = (torque, carried);
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

        self.required_torques(centroidal, required, Some(qdd));
        for ((tau, &torque), &carried) in tau.iter_mut().zip(&self.data.vector).zip(&self.data.vector_more) {
            *tau = torque + carried;
        }
        required.at(-com)
    }

    /// The momentum's half of the equations, `μ̇ = Λ_b⁻¹ (F₁ + ad_{V₁}ᵀ Λ_b μ − P(q̇) μ)` (all base frame).
    pub fn locked_acceleration(&mut self, mu: Twist<T>, base_wrench: Wrench<T>) -> Twist<T> {
        let com = self.com();
        let mu = mu.at(com);
        let rate = self.momentum_rate(mu) - self.locked_rate() * mu + base_wrench.at(com);
        self.locked_solve(rate).at(-com)
    }
}
