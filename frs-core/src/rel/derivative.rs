//! P and S: how the locked inertia changes with the shape.

use nalgebra::{Matrix6, Matrix6xX};

use crate::Real;
use crate::spatial::{Inertia, Twist, Wrench};
use crate::sweep::{Moving, Shape, base_matrix};

impl<T: Real> Shape<'_, '_, T> {
    /// The inertia velocity `P(x) = −Σ_k X_kᵀ(ad_{J_k x}ᵀ M_k + M_k ad_{J_k x}) X_k` (6×6, base frame) in a shape
    /// direction `x` (length n); `P(q̇) = dΛ_b/dt`.
    ///
    /// # Panics
    /// If `x` does not have n entries.
    pub fn inertia_velocity(&mut self, x: &[T]) -> Matrix6<T> {
        assert_eq!(x.len(), self.model.dof(), "x must have one entry per coordinate");
        self.fill_inertia_rates();
        let rates = self.model.bodies().iter().zip(&self.data.inertia_rate).skip(1);
        let sum = rates
            .fold(Inertia::zero(), |sum, (body, rate)| sum + *rate * (x[body.drive.coordinate] * body.drive.ratio));
        base_matrix(&sum.to_matrix(), self.com())
    }

    /// The inertia derivative `S(x)` (6×n, base frame), column j = ½ P(e_j) x; `½ ∂(xᵀ Λ_b x)/∂q = S(x)ᵀ x`.
    ///
    /// # Panics
    /// If `out` does not have n columns.
    pub fn inertia_derivative(&mut self, x: Twist<T>, out: &mut Matrix6xX<T>) {
        self.fill_inertia_rates();
        let (com, centroidal) = (self.com(), x.at(self.com()));
        self.model.gather_columns(out, |j| self.half_rate(j, centroidal).at(-com).to_array());
    }

    /// ½ P_j x in the centroidal frame; P_j must have been filled.
    pub(crate) fn half_rate(&self, j: usize, x: Twist<T>) -> Wrench<T> {
        (self.data.inertia_rate[j + 1] * x) * T::from_f64(0.5)
    }

    /// P_j = −(ad_{s_j}ᵀ Iᶜ_j + Iᶜ_j ad_{s_j}) of every joint.
    pub(crate) fn fill_inertia_rates(&mut self) {
        for j in 0..self.model.joints() {
            let screw = self.data.screw[j];
            self.data.inertia_rate[j + 1] = self.data.composite[j + 1].rate(screw);
        }
    }
}

impl<T: Real> Moving<'_, '_, '_, T> {
    /// P(q̇) in the centroidal frame.
    pub(crate) fn locked_rate(&mut self) -> Inertia<T> {
        let shape = &mut **self;
        shape.fill_inertia_rates();
        let rates = shape.data.inertia_rate.iter().skip(1);
        rates.zip(&shape.data.rate).fold(Inertia::zero(), |sum, (rate, &x)| sum + *rate * x)
    }
}
