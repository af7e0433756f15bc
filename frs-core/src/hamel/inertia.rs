//! M, the inertia matrix in base velocity and joint rates.

use nalgebra::DMatrix;

use crate::Real;
use crate::spatial::Wrench;
use crate::sweep::{Columns, Shape, Square, Symmetry, groups};

impl<T: Real> Shape<'_, '_, T> {
    /// The inertia matrix `M = [[Λ_b, M_bq], [M_bqᵀ, M_q]]` ((6+n)×(6+n), base frame), `M_q = Σ_k J_kᵀ M_k J_k`.
    ///
    /// `M_q(i,j) = s_i·h_j` where i is j or above it, 0 where neither is above the other (Featherstone, RBDA §6.2).
    ///
    /// # Panics
    /// If `out` is not (6+n)×(6+n).
    pub fn hamel_inertia(&mut self, out: &mut DMatrix<T>) {
        let (model, com) = (self.model, self.com());
        let data = &mut *self.data;
        let insides = data.inside.groups();
        let nothing = Columns::<T, 0>::new(model.joints());
        let mut joint_block = Square::new(model, out, 6, Symmetry::Symmetric, &mut data.row);
        for first in groups::<T>(0..model.joints()) {
            joint_block.rows(first, (data.screw.group(first), insides), (&[], nothing.groups()));
        }
        joint_block.mirror();
        out.fixed_view_mut::<6, 6>(0, 0).copy_from(&self.locked_inertia().to_matrix());
        out.view_range_mut(..6, 6..).fill(T::zero());
        for (j, body) in model.bodies()[1..].iter().enumerate() {
            let column = self.data.inside.at::<Wrench<T>>(j).at(-com).to_vector() * body.drive.ratio;
            let mut target = out.fixed_view_mut::<6, 1>(0, 6 + body.drive.coordinate);
            target += column;
        }
        for c in 6..out.ncols() {
            for r in 0..6 {
                out[(c, r)] = out[(r, c)];
            }
        }
    }
}
