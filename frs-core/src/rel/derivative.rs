//! P and S: how the locked inertia changes with the shape.

use nalgebra::{Matrix6, Matrix6xX};

use crate::Real;
use crate::spatial::{Inertia, Symmetric3, Twist};
use crate::sweep::{Data, Moving, Shape, base_matrix};

impl<T: Real> Shape<'_, '_, T> {
    /// The inertia velocity `P(x) = −Σ_k X_kᵀ(ad_{J_k x}ᵀ M_k + M_k ad_{J_k x}) X_k` (6×6, base frame) in a shape
    /// direction `x` (length n); `P(q̇) = dΛ_b/dt`.
    ///
    /// # Panics
    /// If `x` does not have n entries.
    pub fn inertia_velocity(&self, x: &[T]) -> Matrix6<T> {
        assert_eq!(x.len(), self.model.dof(), "x must have one entry per coordinate");
        let bodies = self.model.bodies()[1..].iter().enumerate();
        let sum = bodies.fold(Inertia::zero(), |sum, (j, body)| {
            sum + self.data.inertia_rate(j) * (x[body.drive.coordinate] * body.drive.ratio)
        });
        base_matrix(&sum.to_matrix(), self.com())
    }

    /// The inertia derivative `S(x)` (6×n, base frame), column j = ½ P(e_j) x; `½ ∂(xᵀ Λ_b x)/∂q = S(x)ᵀ x`.
    ///
    /// # Panics
    /// If `out` does not have n columns.
    pub fn inertia_derivative(&self, x: Twist<T>, out: &mut Matrix6xX<T>) {
        let (com, half) = (self.com(), x.at(self.com()) * T::from_f64(0.5));
        self.model.gather_columns(out, |j| (self.data.inertia_rate(j) * half).at(-com).to_array());
    }
}

impl<T: Real> Moving<'_, '_, '_, T> {
    /// P(q̇) in the centroidal frame.
    pub(crate) fn locked_rate(&self) -> Inertia<T> {
        let (data, locked) = (&*self.data, &self.data.composite[0]);
        let rotational = (0..self.model().joints())
            .fold(Symmetric3::zero(), |sum, j| sum + data.inertia_rate(j).rotational * data.rate[j]);
        // Momentum is zero: seen from the base, the centre of mass moves as the base does seen from it, the other way.
        Inertia { mass: T::zero(), moment: data.velocity[0].linear * -locked.mass, rotational }
    }
}

impl<T: Real> Data<T> {
    /// P_j = −(ad_{s_j}ᵀ Iᶜ_j + Iᶜ_j ad_{s_j}), the rate of the locked inertia as joint j moves.
    #[inline(always)]
    pub(super) fn inertia_rate(&self, j: usize) -> Inertia<T> {
        self.composite[j + 1].rate(self.screw.at(j))
    }
}
