//! 𝓑, the curvature of the mechanical connection.

use nalgebra::{DMatrix, Vector3};

use crate::Real;
use crate::spatial::{Twist, Wrench};
use crate::sweep::{Shape, Square, free_velocities};

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
    /// For i above j, `Λ_c 𝓑 = −ad_{s_i}ᵀ h_j − P_i A_j − P_j ŝ_i`; where neither is above the other `−P_i A_j + P_j A_i`;
    /// minus `ad_{A_i} A_j` of the centroidal frame. Source: docs/mathematics.md §3.
    ///
    /// # Panics
    /// If `out` was not made for n coordinates.
    pub fn curvature(&mut self, out: &mut Curvature<T>) {
        for j in 0..self.model.joints() {
            self.data.inertia_rate[j] = self.data.inertia_rate(j);
        }
        out.com = self.com();
        let (model, data) = (self.model, &mut *self.data);
        let joints = model.joints();
        let mut out = out.angular.each_mut().map(|component| Square::new(model, component, 0));
        for i in 0..joints {
            let end = model.bodies()[i + 1].end - 1;
            let screw = data.screw[i];
            let [a_i, reaction] = [data.connection[i], data.reaction[i]];
            data.turn[i] = Vector3::zeros();
            for j in i + 1..joints {
                let a_j = data.connection[j];
                let (rate_i, rate_j) = (data.inertia_rate[i], data.inertia_rate[j]);
                let momentum = if j < end {
                    let carried = screw.ad_transpose(data.inside[j]);
                    -carried.moment - (rate_i * a_j).moment - (rate_j * reaction).moment
                } else {
                    (rate_j * a_i).moment - (rate_i * a_j).moment
                };
                let turn = data.locked.solve(momentum) - a_i.angular.cross(&a_j.angular);
                data.turn[j] = turn;
            }
            for (component, out) in out.iter_mut().enumerate() {
                let turns = data.turn[i..joints].iter();
                data.row[i..].iter_mut().zip(turns).for_each(|(entry, turn)| *entry = -turn[component]);
                out.lower(i, -T::one(), &data.row);
            }
        }
        out.iter_mut().for_each(|out| out.mirror(-T::one()));
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
        for (inertia, (&x, &y)) in data.inertia.iter().zip(data.twist.iter().zip(&data.twist_more)) {
            sum += y.ad_transpose(*inertia * x) - x.ad_transpose(*inertia * y) - *inertia * x.ad(y);
        }
        self.locked_solve(sum).at(-self.com())
    }
}
