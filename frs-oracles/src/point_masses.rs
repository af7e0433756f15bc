//! Masses that slide in a base of any inertia: the connection of a deformable body made of points.

use frs_core::Real;
use nalgebra::{Matrix3, Vector3};

use crate::Values;
use crate::adjugate::inverse;
use crate::rotation::polar;

/// Masses at positions r_a from the base's centre of mass; they keep their orientation.
pub struct PointMasses<T: Real, const N: usize> {
    /// The base's centre of mass in the base frame, m.
    pub base_com: Vector3<T>,
    /// All rotational inertias about their own centres, summed, kg·m².
    pub inertia: Matrix3<T>,
    /// μ_ab, kg.
    pub reduced: [[T; N]; N],
    /// m_a/M.
    pub share: [T; N],
    /// r_a, m.
    pub position: [Vector3<T>; N],
}

impl<T: Real, const N: usize> PointMasses<T, N> {
    /// With g_a = Σ_b μ_ab r_b and K = ΣI + Σ_ab μ_ab((r_a·r_b)1 − r_a r_bᵀ), coordinate i sliding body a along e, j b along f:
    /// `A_ω,i = K⁻¹(g_a × e)` and `𝓑_ω = K⁻¹(2μ_ab e × f − (∂_iK)A_j + (∂_jK)A_i) − A_i × A_j`,
    /// `∂_iK = 2(g_a·e)1 − e g_aᵀ − g_a eᵀ`.
    pub fn values(&self, coordinates: &[(usize, Vector3<T>)]) -> Values<T> {
        let (r, mu) = (&self.position, &self.reduced);
        let mut locked = self.inertia;
        let mut g = [Vector3::zeros(); N];
        for a in 0..N {
            for b in 0..N {
                g[a] += r[b] * mu[a][b];
                locked += polar(r[a], r[b]) * mu[a][b];
            }
        }
        let solve = inverse(&locked);
        let connection: Vec<_> = coordinates.iter().map(|(a, e)| solve * g[*a].cross(e)).collect();
        let locked_rate = |i: usize| {
            let (a, e) = coordinates[i];
            polar(g[a], e) + polar(e, g[a])
        };
        let field = |(i, j): (usize, usize)| {
            let ((a, e), (b, f)) = (coordinates[i], coordinates[j]);
            let curl = e.cross(&f) * (mu[a][b] + mu[a][b]);
            solve * (curl - locked_rate(i) * connection[j] + locked_rate(j) * connection[i])
                - connection[i].cross(&connection[j])
        };
        let com = (0..N).fold(self.base_com, |com, a| com + r[a] * self.share[a]);
        Values::turning(
            &connection,
            com,
            &coordinates.iter().map(|(a, e)| e * self.share[*a]).collect::<Vec<_>>(),
            &Values::<T>::pairs(coordinates.len()).map(field).collect::<Vec<_>>(),
        )
    }
}
