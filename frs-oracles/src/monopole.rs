//! One mass that moves anywhere, on a base with equal principal moments: the field of a monopole, smoothed.

use frs_core::Real;
use nalgebra::Vector3;

use crate::Values;
use crate::reduced_mass::reduced_mass;
use crate::rotation::lifted;

/// A base with equal principal moments and one mass that moves in it.
pub struct Monopole {
    /// Mass of the base, kg.
    pub base: f64,
    /// Its centre of mass, m.
    pub base_com: Vector3<f64>,
    /// The moving mass, kg.
    pub mass: f64,
    /// I, the moments of base and moving mass about their centres, summed, kg·m².
    pub inertia: f64,
}

impl Monopole {
    /// With the mass at `r` from the base's centre of mass and `tangents` t_k = ∂r/∂q_k, κ = I + ε|r|²:
    /// `A_ω,k = (ε/κ) r × t_k` and `𝓑_ω = (2εI n + ε²(r·n) r)/κ²`, n = t_k × t_l.
    pub fn values<T: Real, const N: usize>(&self, r: Vector3<T>, tangents: [Vector3<T>; N]) -> Values<T> {
        let (epsilon, inertia) = (reduced_mass::<T>(self.base, self.mass), T::from_f64(self.inertia));
        let kappa = inertia + epsilon * r.dot(&r);
        let share = T::from_f64(self.mass) / T::from_f64(self.base + self.mass);
        let field = |(k, l): (usize, usize)| {
            let n = tangents[k].cross(&tangents[l]);
            (n * (T::from_f64(2.0) * epsilon * inertia) + r * (epsilon * epsilon * r.dot(&n))) / (kappa * kappa)
        };
        Values::turning(
            &tangents.map(|t| r.cross(&t) * (epsilon / kappa)),
            lifted::<T>(self.base_com) + r * share,
            &tangents.map(|t| t * share),
            &Values::<T>::pairs(N).map(field).collect::<Vec<_>>(),
        )
    }
}
