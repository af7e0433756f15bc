//! C_b, B_2, Γ'_q and what they make: D_μ and D_q̇, the two halves of the Coriolis terms.

use nalgebra::{DMatrix, Matrix6};

use crate::Real;
use crate::spatial::{CoriolisFactor, Twist, Wrench, cross_matrix};
use crate::sweep::{Moving, Shape, Square, base_matrix, outside_sums, subtree_sums};

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
    /// It depends on the angular part of μ alone. Source: the paper, eq. (19e); docs/mathematics.md §3.
    ///
    /// # Panics
    /// If `out` is not n×n.
    pub fn b2(&mut self, mu: Twist<T>, out: &mut DMatrix<T>) {
        self.curvature_coupling(mu, T::one(), Square::new(self.model, out, 0));
    }

    /// `D_μ(q, μ)` ((6+n)×(6+n), skew): the part of the Coriolis terms that is linear in the locked velocity,
    /// `[[−C_b^μ, −S(μ) − ad~_{Λ_bμ} A_l], [S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}, −2 B_2(μ)]]`, `ad~_{Λ_bμ}ᵀ = −ad~_{Λ_bμ}`.
    ///
    /// Source: the paper, eq. (16), corrected in docs/mathematics.md §5.
    ///
    /// # Panics
    /// If `out` is not (6+n)×(6+n).
    pub fn d_mu(&mut self, mu: Twist<T>, out: &mut DMatrix<T>) {
        let block = Square::new(self.model, out, 6);
        self.curvature_coupling(mu, T::from_f64(-2.0), block);
        out.fixed_view_mut::<6, 6>(0, 0).copy_from(&-self.locked_coriolis(mu));

        self.fill_inertia_rates();
        let (com, mu, momentum) = (self.com(), mu.at(self.com()), self.centroidal_momentum(mu));
        out.view_range_mut(..6, 6..).fill(T::zero());
        for (j, body) in self.model.bodies()[1..].iter().enumerate() {
            let connection = Twist::from_array(self.data.connection.get(j));
            let upper = -(self.half_rate(j, mu) + connection.ad_transpose(momentum)).at(-com);
            let mut column = out.fixed_view_mut::<6, 1>(0, 6 + body.drive.coordinate);
            column += upper.to_vector() * body.drive.ratio;
        }
        for c in 6..out.ncols() {
            for r in 0..6 {
                out[(c, r)] = -out[(r, c)];
            }
        }
    }

    /// `factor·B_2(μ)` into a block.
    fn curvature_coupling(&mut self, mu: Twist<T>, factor: T, mut out: Square<'_, '_, T>) {
        let data = &mut *self.data;
        let (omega, locked) = (mu.angular, data.composite[0]);
        let joints = data.row.len();
        for j in 0..joints {
            let screw = Twist::from_array(data.screw.get(j));
            data.six.set(j, data.composite[j + 1].coriolis(omega, screw).to_array());
        }
        for i in 0..joints {
            let end = self.model.bodies()[i + 1].end - 1;
            let connection = Twist::from_array(data.connection.get(i));
            let reaction = Twist::from_array(data.reaction.get(i));
            let turned = data.composite[i + 1].coriolis(omega, reaction);
            let below = turned - data.complement[i + 1].coriolis(omega, connection);
            data.six.dot(reaction.to_array(), i + 1..end, &mut data.row);
            data.connection.add_dot(below.to_array(), i + 1..end, &mut data.row);
            let beside = Wrench::from_array(data.six.get(i)) - locked.coriolis_central(omega, connection);
            data.six.dot((-connection).to_array(), end..joints, &mut data.row);
            data.connection.add_dot(beside.to_array(), end..joints, &mut data.row);
            let row = &mut data.row;
            row[i] = T::zero();
            row[i + 1..].iter_mut().for_each(|entry| *entry *= factor);
            out.row(i, i..joints, |j| row[j]);
            out.column(i, i + 1..joints, |j| -row[j]);
        }
    }
}

impl<T: Real> Moving<'_, '_, '_, T> {
    /// `Γ'_q(q̇)` (n×n), the Christoffel matrix of Λ_q: `dΛ_q/dt − 2Γ'_q` is skew, `Γ'_q(x) y = Γ'_q(y) x`.
    ///
    /// `Γ'_q = Σ_k J̃_kᵀ(C(M_k; J̃_k q̇) J̃_k + M_k dJ̃_k/dt)`. Source: the paper, eq. (19d); docs/mathematics.md §3.
    ///
    /// # Panics
    /// If `out` is not n×n.
    pub fn gamma_q(&mut self, out: &mut DMatrix<T>) {
        let model = self.model;
        self.christoffel(Square::new(model, out, 0));
    }

    /// `D_q̇(q, q̇) = diag(½ P(q̇), Γ'_q(q̇))` ((6+n)×(6+n)): the part of the Coriolis terms that is linear in q̇ alone.
    ///
    /// # Panics
    /// If `out` is not (6+n)×(6+n).
    pub fn d_qdot(&mut self, out: &mut DMatrix<T>) {
        let model = self.model;
        self.christoffel(Square::new(model, out, 6));
        out.view_range_mut(..6, 6..).fill(T::zero());
        out.view_range_mut(6.., ..6).fill(T::zero());
        let half = self.locked_rate().to_matrix() * T::from_f64(0.5);
        out.fixed_view_mut::<6, 6>(0, 0).copy_from(&base_matrix(&half, self.com()));
    }

    /// `Γ'_q(q̇)` into a block.
    ///
    /// With z_i = Dᵒ_iᵀ A_i − Dᶜ_iᵀ ŝ_i every entry is z_i·A_j (angular parts) and, where i is j or above it, ŝ_i·g_j;
    /// elsewhere −A_i·g_j; where j is above i also s_i·(Dᶜ_i s_j + Iᶜ_i ṡ_j).
    fn christoffel(&mut self, mut out: Square<'_, '_, T>) {
        let (model, data) = (self.model, &mut *self.data);
        let bodies = model.bodies();
        let joints = data.row.len();
        for (k, factor) in data.factor.iter_mut().enumerate() {
            *factor = data.inertia[k].coriolis_factor(data.velocity[k]);
        }
        subtree_sums(bodies, &mut data.factor, &mut data.factor_outside);
        data.factor_before[0] = CoriolisFactor::zero();
        outside_sums(bodies, &data.factor, &mut data.factor_outside, &mut data.factor_before);

        let (g, z) = (&mut data.six, &mut data.three);
        let (below, turning) = (&mut data.three_more, &mut data.six_more);
        for j in 0..joints {
            let screw = Twist::from_array(data.screw.get(j));
            let (connection, reaction) =
                (Twist::from_array(data.connection.get(j)), Twist::from_array(data.reaction.get(j)));
            let (inside, outside) = (&data.factor[j + 1], &data.factor_outside[j + 1]);
            let screw_rate = data.velocity[j + 1].ad(screw);
            turning.set(j, screw_rate.to_array());
            g.set(j, (inside.apply(screw.angular) + data.composite[j + 1] * screw_rate).to_array());
            z.set(j, (outside.apply_transpose(connection) - inside.apply_transpose(reaction)).into());
            below.set(j, inside.apply_transpose(screw).into());
        }
        for i in 0..joints {
            let end = bodies[i + 1].end - 1;
            let row = &mut data.row;
            g.dot(data.reaction.get(i), i..end, row);
            g.dot((-Twist::from_array(data.connection.get(i))).to_array(), end..joints, row);
            data.connection.add_dot(z.get(i), i..joints, row);
            out.row(i, i..joints, |j| row[j]);
        }
        for j in 0..joints {
            let end = bodies[j + 1].end - 1;
            let [screw, connection] = [&data.screw, &data.connection].map(|columns| Twist::from_array(columns.get(j)));
            let column = &mut data.row;
            data.connection.dot((-Wrench::from_array(g.get(j))).to_array(), j + 1..joints, column);
            z.add_dot(connection.angular.into(), j + 1..joints, column);
            below.add_dot(screw.angular.into(), j + 1..end, column);
            data.inside.add_dot(turning.get(j), j + 1..end, column);
            out.column(j, j + 1..joints, |i| column[i]);
        }
    }
}
