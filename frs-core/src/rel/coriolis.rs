//! C_b, B_2, Γ'_q and what they make: D_μ and D_q̇, the two halves of the Coriolis terms.

use nalgebra::{DMatrix, Matrix6, Vector3};

use crate::Real;
use crate::spatial::{CoriolisFactor, Inertia, Twist, Wrench, cross_matrix};
use crate::sweep::{
    Data, Moving, Shape, Square, Symmetry, base_matrix, factors, gather, groups, joined, multiple_of_block,
    outside_sums, splat, subtree_sums,
};

impl<T: Real> Shape<'_, '_, T> {
    /// The locked Coriolis matrix `C_b^μ = C(Λ_b; μ)` (6×6, skew, base frame).
    pub fn locked_coriolis(&self, mu: Twist<T>) -> Matrix6<T> {
        let locked = &self.data.composite[0];
        let mut matrix = Matrix6::zeros();
        matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&cross_matrix(locked.sigma(mu.angular)));
        matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&(cross_matrix(mu.angular) * locked.mass));
        base_matrix(&matrix, self.com())
    }

    /// `B_2(μ) = Σ_k J̃_kᵀ C(M_k; X_k μ) J̃_k` (n×n, skew): `B_2(μ)_ij = −½ ⟨Λ_b μ, 𝓑(e_i, e_j)⟩`.
    ///
    /// It depends on the angular part of μ alone. Source: the paper; docs/mathematics.md §2 and §3.4.
    ///
    /// # Panics
    /// If `out` is not n×n.
    pub fn b2(&mut self, mu: Twist<T>, out: &mut DMatrix<T>) {
        let momentum = self.locked_momentum(mu).moment;
        self.curvature_of_momentum(mu.angular, momentum, out, 0);
        out.as_mut_slice().iter_mut().for_each(|entry| *entry = *entry * minus_half() + T::zero());
    }

    /// `D_μ(q, μ)` ((6+n)×(6+n), skew): the part of the Coriolis terms that is linear in the locked velocity,
    /// `[[−C_b^μ, −S(μ) − ad~_{Λ_bμ} A_l], [S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}, −2 B_2(μ)]]`, `ad~_{Λ_bμ}ᵀ = −ad~_{Λ_bμ}`.
    ///
    /// Source: the paper, eq. (16), corrected in docs/corrections.md.
    ///
    /// # Panics
    /// If `out` is not (6+n)×(6+n).
    pub fn d_mu(&mut self, mu: Twist<T>, out: &mut DMatrix<T>) {
        let momentum = self.locked_momentum(mu).moment;
        self.curvature_of_momentum(mu.angular, momentum, out, 6);
        out.fixed_view_mut::<6, 6>(0, 0).copy_from(&self.locked_coriolis(mu).map(T::neg));

        let (com, mu) = (self.com(), mu.at(self.com()));
        let (momentum, half) = (self.locked_momentum(mu), mu * T::from_f64(0.5));
        let size = out.nrows();
        let (left, right) = out.as_mut_slice().split_at_mut(6 * size);
        self.data.momentum_columns(half, momentum, com);
        let columns = &self.data.six_rows;
        self.model.gather_groups(right, size, |first| (-columns.lanes::<Wrench<_>>(first)).to_array());
        for (r, row) in left.chunks_exact_mut(size).enumerate() {
            for (entry, column) in row[6..].iter_mut().zip(right.chunks_exact(size)) {
                *entry = -column[r];
            }
        }
    }

    /// [`d_mu`](Self::d_mu) and [`b2`](Self::b2) at the price of the first: B_2 is −½ of its lower right block.
    ///
    /// # Panics
    /// If `d_mu` is not (6+n)×(6+n) or `b2` is not n×n.
    pub fn d_mu_with_b2(&mut self, mu: Twist<T>, d_mu: &mut DMatrix<T>, b2: &mut DMatrix<T>) {
        let n = self.model.dof();
        assert_eq!(b2.shape(), (n, n), "B_2 must be n×n");
        self.d_mu(mu, d_mu);
        multiple_of_block(d_mu, minus_half(), b2);
    }
}

/// What B_2 is of the curvature that momentum feels.
fn minus_half<T: Real>() -> T {
    -T::from_f64(0.5)
}

impl<T: Real> Moving<'_, '_, '_, T> {
    /// `Γ'_q(q̇)` (n×n), the Christoffel matrix of Λ_q: `dΛ_q/dt − 2Γ'_q` is skew, `Γ'_q(x) y = Γ'_q(y) x`.
    ///
    /// `Γ'_q = Σ_k J̃_kᵀ(C(M_k; J̃_k q̇) J̃_k + M_k dJ̃_k/dt)`. Source: the paper; docs/mathematics.md §2 and §3.5.
    ///
    /// # Panics
    /// If `out` is not n×n.
    pub fn gamma_q(&mut self, out: &mut DMatrix<T>) {
        self.christoffel(out, 0);
    }

    /// `D_q̇(q, q̇) = diag(½ P(q̇), Γ'_q(q̇))` ((6+n)×(6+n)): the part of the Coriolis terms that is linear in q̇ alone.
    ///
    /// # Panics
    /// If `out` is not (6+n)×(6+n).
    pub fn d_qdot(&mut self, out: &mut DMatrix<T>) {
        self.christoffel(out, 6);
        out.view_range_mut(..6, 6..).fill(T::zero());
        out.view_range_mut(6.., ..6).fill(T::zero());
        let half = self.locked_rate().to_matrix() * T::from_f64(0.5);
        out.fixed_view_mut::<6, 6>(0, 0).copy_from(&base_matrix(&half, self.com()));
    }

    /// `Γ'_q(q̇)` into the block of `out` that starts at (`start`, `start`).
    ///
    /// With g_j = Iᶜ_j ṡ_j + Dᶜ_j s_j and z_i = Dᵒ_iᵀ A_i − Dᶜ_iᵀ ŝ_i the entry is ŝ_i·g_j + z_i·A_j where i is j or above it,
    /// A_i·(Iᵒ_j ṡ_j + Dᵒ_j A_j − Dᶜ_j ŝ_j) + (Dᶜ_iᵀ s_i)·ŝ_j where j is above i, and z_i·A_j − A_i·g_j elsewhere. Only differences
    /// that are small where the entry is small are formed (docs/mathematics.md §3.5).
    fn christoffel(&mut self, out: &mut DMatrix<T>, start: usize) {
        let (model, data) = (self.model, &mut *self.data);
        let bodies = model.bodies();
        let joints = model.joints();
        factors(model, data, Twist::zero());
        subtree_sums(bodies, &mut data.factor, &mut data.factor_outside);
        data.factor_before[0] = CoriolisFactor::zero();
        outside_sums(bodies, &data.factor, &mut data.factor_outside, &mut data.factor_before);

        for first in groups::<T>(0..joints) {
            let (screw, velocity): (Twist<T::Lanes>, Twist<_>) =
                (data.screw.lanes(first), gather(&data.velocity, first + 1));
            let inside: CoriolisFactor<T::Lanes> = gather(&data.factor, first + 1);
            let outside: CoriolisFactor<T::Lanes> = gather(&data.factor_outside, first + 1);
            let (connection, reaction): (Twist<T::Lanes>, Twist<_>) =
                (data.connection.lanes(first), data.reaction.lanes(first));
            let (composite, complement): (Inertia<T::Lanes>, Inertia<_>) =
                (data.composite_columns.lanes(first), data.complement_columns.lanes(first));
            let turning = velocity.ad(screw);
            let above = outside.apply(connection.angular) - inside.apply(reaction.angular) + complement * turning;
            let z = outside.apply_transpose(connection) - inside.apply_transpose(reaction);
            let (g, y) = (inside.apply(screw.angular) + composite * turning, inside.apply_transpose(screw));
            data.six_rows.set_lanes(first, g);
            data.six_rows_more.set_lanes(first, above);
            data.three_rows.set_lanes(first, z);
            data.three_rows_more.set_lanes(first, y);
            let [columns, belows, besides] = &mut data.nine_rows;
            columns.set_lanes(first, joined(g, connection.angular));
            belows.set_lanes(first, joined(connection, y));
            besides.set_lanes(first, joined(connection, z));
        }
        let (gs, aboves, zs) = (&data.six_rows, &data.six_rows_more, &data.three_rows);
        let [columns, belows, besides] = &data.nine_rows;
        let (columns, belows, besides) = (columns.groups(), belows.groups(), besides.groups());
        let (connections, reactions) = (&data.connection, &data.reaction);
        let mut out = Square::new(model, out, start, Symmetry::Absent, &mut data.row);
        for first in groups::<T>(0..joints) {
            let (connection, z): (Twist<T::Lanes>, Vector3<_>) = (connections.lanes(first), zs.lanes(first));
            let below = joined(reactions.lanes::<Twist<_>>(first), z);
            out.rows(first, (&below, columns), (&joined(-connection, z), columns));
        }
        out.mirror();
        for first in groups::<T>(0..joints) {
            let (connection, reaction): (Twist<T::Lanes>, Twist<_>) =
                (connections.lanes(first), reactions.lanes(first));
            let (g, above): (Wrench<T::Lanes>, Wrench<_>) = (gs.lanes(first), aboves.lanes(first));
            let beside = joined(-g, connection.angular);
            out.columns(first, (&joined(above, reaction.angular), belows), (&beside, besides));
        }
    }
}

impl<T: Real> Data<T> {
    /// `P_j `half` + ad_{A_j}ᵀ `momentum`` of every joint into `six_rows`: everything in the centroidal frame, the columns in the base's.
    fn momentum_columns(&mut self, half: Twist<T>, momentum: Wrench<T>, com: Vector3<T>) {
        let joints = self.inverse_pivot.len();
        let (half, momentum): (Twist<T::Lanes>, Wrench<T::Lanes>) = (splat(half), splat(momentum));
        let com: Vector3<T::Lanes> = splat(com);
        for first in groups::<T>(0..joints) {
            let composite: Inertia<T::Lanes> = self.composite_columns.lanes(first);
            let connection: Twist<T::Lanes> = self.connection.lanes(first);
            let column = composite.rate(self.screw.lanes(first)) * half + connection.ad_transpose(momentum);
            self.six_rows.set_lanes(first, column.at(-com));
        }
    }
}
