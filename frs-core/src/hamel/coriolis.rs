//! C, the Coriolis matrix in base velocity and joint rates.

use nalgebra::{DMatrix, Vector3};

use crate::Real;
use crate::spatial::{CoriolisFactor, Inertia, Twist, Wrench, cross_matrix};
use crate::sweep::{
    Columns, Moving, Square, Symmetry, base_matrix, factors, gather, groups, joined, scatter, splat, subtree_sums,
};

impl<T: Real> Moving<'_, '_, '_, T> {
    /// The Coriolis matrix `C = Σ_k [X_k J_k]ᵀ(C(M_k; V_k) [X_k J_k] + M_k d[X_k J_k]/dt)` ((6+n)×(6+n), base frame) of a
    /// base moving with `V₁ = base_twist`; `V_k = X_k V₁ + J_k q̇`. `dM/dt − 2C` is skew.
    ///
    /// With E_k = C(I_k; V_k) − I_k ad_{u_k}, u_k = J_k q̇, and subtree sums Eᶜ: the base columns are Eᶜ_root and, in row i,
    /// s_iᵀ Eᶜ_i; column j is g_j = Eᶜ_j s_j + Iᶜ_j ṡ_j in the base rows and s_i·g_j in row i at or above j,
    /// s_i·(Eᶜ_i s_j + Iᶜ_i ṡ_j) below j.
    ///
    /// # Panics
    /// If `out` is not (6+n)×(6+n).
    pub fn hamel_coriolis(&mut self, base_twist: Twist<T>, out: &mut DMatrix<T>) {
        let com = self.com();
        let omega = base_twist.angular;
        let (model, data) = (self.model, &mut *self.data);
        let bodies = model.bodies();
        let joints = model.joints();
        let base = data.velocity[0];
        factors(model, data, base);
        subtree_sums(bodies, &mut data.factor, &mut data.factor_outside);

        let (omega_lanes, base_lanes): (Vector3<T::Lanes>, Twist<T::Lanes>) = (splat(omega), splat(base));
        for first in groups::<T>(0..joints) {
            let screw: Twist<T::Lanes> = data.screw.lanes(first);
            let composite: Inertia<T::Lanes> = data.composite_columns.lanes(first);
            let factor: CoriolisFactor<T::Lanes> = gather(&data.factor, first + 1);
            let velocity: Twist<T::Lanes> = gather(&data.velocity, first + 1);
            let screw_rate = (velocity - base_lanes).ad(screw);
            let skew = composite.coriolis(omega_lanes, screw);
            scatter(&mut data.twist, first, screw_rate);
            data.six_rows.set_lanes(first, factor.apply(screw.angular) + skew + composite * screw_rate);
            // s_jᵀ Eᶜ_j: the closed-form C is skew.
            let turned = Wrench::new(factor.apply_transpose(screw), Vector3::zeros());
            data.six_rows_more.set_lanes(first, turned - skew);
            data.twelve_rows.set_lanes(first, joined(turned - skew, data.inside.lanes::<Wrench<_>>(first)));
        }

        // What is beside a joint takes no part in its entries.
        let nothing = Columns::<T, 0>::new(joints);
        let mut block = Square::new(model, out, 6, Symmetry::Absent, &mut data.row);
        let (columns, rows) = (data.six_rows.groups(), data.twelve_rows.groups());
        for first in groups::<T>(0..joints) {
            block.rows(first, (data.screw.group(first), columns), (&[], nothing.groups()));
        }
        block.mirror();
        for first in groups::<T>(0..joints) {
            let (screw, rate): (Twist<T::Lanes>, Twist<_>) = (data.screw.lanes(first), gather(&data.twist, first));
            block.columns(first, (&joined(screw, rate), rows), (&[], nothing.groups()));
        }
        self.base_block(omega, com, out);
    }

    /// The base rows and columns.
    fn base_block(&self, omega: Vector3<T>, com: Vector3<T>, out: &mut DMatrix<T>) {
        let (model, data) = (self.model, &*self.data);
        let locked = &data.composite[0];
        let root: &CoriolisFactor<T> = &data.factor[0];
        let mut matrix = root.to_matrix();
        let turning = root.rotational + cross_matrix(locked.sigma(omega));
        matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&turning);
        matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&(cross_matrix(omega) * locked.mass));
        out.view_range_mut(..6, ..).fill(T::zero());
        out.view_range_mut(6.., ..6).fill(T::zero());
        out.fixed_view_mut::<6, 6>(0, 0).copy_from(&base_matrix(&matrix, com));
        for (j, body) in model.bodies()[1..].iter().enumerate() {
            let c = 6 + body.drive.coordinate;
            let column = data.six_rows.at::<Wrench<T>>(j).at(-com).to_vector() * body.drive.ratio;
            let mut target = out.fixed_view_mut::<6, 1>(0, c);
            target += column;
            // A row acts on a twist of the base frame: T stands on its right, so it moves as a wrench does.
            let row = data.six_rows_more.at::<Wrench<T>>(j).at(-com).to_vector() * body.drive.ratio;
            let mut target = out.fixed_view_mut::<1, 6>(c, 0);
            target += row.transpose();
        }
    }
}
