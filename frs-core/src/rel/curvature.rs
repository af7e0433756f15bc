//! 𝓑, the curvature of the mechanical connection.

use nalgebra::{DMatrix, Vector3};

use crate::Real;
use crate::spatial::{Inertia, Twist, Wrench, cross};
use crate::sweep::{Shape, Square, Symmetry, free_velocities, groups, joined, splat};

/// The local curvature `𝓑(e_i, e_j) = ∂_i A_j − ∂_j A_i − ad_{A_i} A_j` for all pairs of coordinates.
///
/// In the centroidal frame only its angular part is not zero, so three n×n skew matrices and the centre of mass hold it.
#[derive(Clone, Debug, PartialEq)]
pub struct Curvature<T: Real = f64> {
    /// The x, y and z angular components (base axes), each n×n and skew.
    pub angular: [DMatrix<T>; 3],
    /// The centre of mass in the base frame: `𝓑_v = com × 𝓑_ω`.
    pub com: Vector3<T>,
}

impl<T: Real> Curvature<T> {
    /// Room for `n` coordinates.
    pub fn new(n: usize) -> Self {
        Self { angular: std::array::from_fn(|_| DMatrix::zeros(n, n)), com: Vector3::zeros() }
    }

    /// `𝓑(e_i, e_j)`, a twist in the base frame.
    pub fn get(&self, i: usize, j: usize) -> Twist<T> {
        let [x, y, z] = &self.angular;
        Twist::new(Vector3::new(x[(i, j)], y[(i, j)], z[(i, j)]), Vector3::zeros()).at(-self.com)
    }
}

impl<T: Real> Shape<'_, '_, T> {
    /// The local curvature tensor, all pairs.
    ///
    /// Component by component, `𝓑_x = ⟨e_x, 𝓑_ω⟩ = ⟨Λ_c μ, 𝓑⟩` with `μ = Λ_c⁻¹ e_x`. Source: docs/mathematics.md §3.4.
    ///
    /// # Panics
    /// If `out` was not made for n coordinates.
    pub fn curvature(&mut self, out: &mut Curvature<T>) {
        out.com = self.com();
        for (axis, component) in out.angular.iter_mut().enumerate() {
            let unit = Vector3::from_fn(|row, _| if row == axis { T::one() } else { T::zero() });
            let omega = self.data.locked.solve(unit);
            self.curvature_of_momentum(omega, unit, component, 0);
        }
    }

    /// `⟨m, 𝓑_ω(e_i, e_j)⟩` into the block of `out` that starts at (`start`, `start`), for an angular momentum `m = Jω` about the centre of mass.
    ///
    /// Where joint i is above j, `(m×ω̂_i + J̇ᵒ_i ω)·A_j + 2m(ω×v̂_i)·A_v,j − ω̂_i·(J̇_j ω)`; where neither is above the other,
    /// the same with `−A_i` for `ŝ_i` and `−J̇_i` for `J̇ᵒ_i`. Source: docs/mathematics.md §3.4.
    pub(super) fn curvature_of_momentum(
        &mut self,
        omega: Vector3<T>,
        momentum: Vector3<T>,
        out: &mut DMatrix<T>,
        start: usize,
    ) {
        let data = &mut *self.data;
        let joints = self.model.joints();
        let twice = omega * (data.composite[0].mass + data.composite[0].mass);
        let (omega, momentum): (Vector3<T::Lanes>, Vector3<T::Lanes>) = (splat(omega), splat(momentum));
        let twice: Vector3<T::Lanes> = splat(twice);
        for first in groups::<T>(0..joints) {
            let screw: Twist<T::Lanes> = data.screw.lanes(first);
            let (composite, connection): (Inertia<T::Lanes>, Twist<_>) =
                (data.composite_columns.lanes(first), data.connection.lanes(first));
            let rate = composite.rate(screw).rotational * omega;
            let [columns, belows, besides] = &mut data.nine_rows;
            columns.set_lanes(first, joined(rate, connection));
            let (complement, reaction): (Inertia<T::Lanes>, Twist<_>) =
                (data.complement_columns.lanes(first), data.reaction.lanes(first));
            let rate_outside = complement.rate(screw).rotational * omega;
            let below =
                Wrench::new(cross(&reaction.angular, &momentum) - rate_outside, cross(&reaction.linear, &twice));
            let beside = Wrench::new(cross(&momentum, &connection.angular) + rate, cross(&twice, &connection.linear));
            // Where generated code knows them by name (sweep/labels.rs).
            data.six_rows.set_lanes(first, below);
            data.six_rows_more.set_lanes(first, beside);
            data.three_rows.set_lanes(first, rate);
            belows.set_lanes(first, joined(reaction.angular, below));
            besides.set_lanes(first, joined(-connection.angular, beside));
        }
        let [columns, belows, besides] = &data.nine_rows;
        let columns = columns.groups();
        let mut out = Square::new(self.model, out, start, Symmetry::Skew, &mut data.row);
        for first in groups::<T>(0..joints) {
            out.rows(first, (belows.group(first), columns), (besides.group(first), columns));
        }
        out.mirror();
    }

    /// The curvature `𝓑(x, y)` on two shape directions (length n), a twist in the base frame, in O(n).
    ///
    /// With the velocities `x̃_k`, `ỹ_k` that x and y give at zero momentum,
    /// `Λ_b 𝓑(x, y) = Σ_k X_kᵀ(ad_{ỹ_k}ᵀ M_k x̃_k − ad_{x̃_k}ᵀ M_k ỹ_k − M_k ad_{x̃_k} ỹ_k)`; no derivative is taken.
    ///
    /// # Panics
    /// If `x` or `y` does not have n entries.
    pub fn curvature_on(&mut self, x: &[T], y: &[T]) -> Twist<T> {
        let (model, data) = (self.model, &mut *self.data);
        let mut velocities = |direction: &[T], out: &mut [Twist<T>]| {
            assert_eq!(direction.len(), model.dof(), "a direction must have one entry per coordinate");
            for (j, body) in model.bodies()[1..].iter().enumerate() {
                data.rate_more[j] = direction[body.drive.coordinate] * body.drive.ratio;
            }
            free_velocities(model, &data.rate_more, &data.connection, &data.screw, out);
        };
        velocities(x, &mut data.twist);
        velocities(y, &mut data.twist_more);
        let mut sum = Wrench::zero();
        for k in 0..model.bodies().len() {
            let (inertia, x, y) = (&data.inertia[k], data.twist[k], data.twist_more[k]);
            sum += y.ad_transpose(*inertia * x) - x.ad_transpose(*inertia * y) - *inertia * x.ad(y);
        }
        self.locked_solve(sum).at(-self.com())
    }
}
