//! The Hamel equations solved for the accelerations.

use nalgebra::DMatrix;

use crate::Real;
use crate::ldl::{factor, solve};
use crate::spatial::{Twist, Wrench};
use crate::sweep::Moving;

impl<T: Real> Moving<'_, '_, '_, T> {
    /// `[V̇₁; q̈] = M⁻¹ ([F₁; τ] − C V)` (length 6+n, base frame) of a base moving with `V₁ = base_twist`, factoring M whole: O((6+n)³).
    ///
    /// What a simulator without the reduction does; for comparison. `inertia` is memory, (6+n)×(6+n), and holds the factors of M then.
    ///
    /// # Panics
    /// If `tau` does not have n entries, `out` 6+n, or `inertia` another size.
    pub fn hamel_acceleration(
        &mut self,
        base_twist: Twist<T>,
        base_wrench: Wrench<T>,
        tau: &[T],
        inertia: &mut DMatrix<T>,
        out: &mut [T],
    ) {
        self.hamel_bias(base_twist, out);
        let forces = base_wrench.to_array();
        for (x, &force) in out.iter_mut().zip(forces.iter().chain(tau)) {
            *x = force - *x;
        }
        self.hamel_inertia(inertia);
        factor(inertia);
        solve(inertia, out);
    }
}
