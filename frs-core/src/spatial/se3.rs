//! Rigid motions: the exponential of SE(3), its principal logarithm and its tangent.
//!
//! `ad_ζ = [[φ×, 0], [ρ×, φ×]]` of `ζ = [φ; ρ]` has the derivative of φ× along ρ below its diagonal. Power series keep that
//! form: where SO(3) has a map M(φ), SE(3) has `[[M, 0], [DM, M]]` with `DM` the derivative of M(φ) along ρ.

use super::stumpff::{Coaxial, Stumpff};
use super::{Pose, Twist, so3};
use crate::Real;

impl<T: Real> Pose<T> {
    /// `exp(ζ) = (exp φ, dexp_φ ρ)` for `ζ = [φ; ρ]`: where a frame arrives that moves with body twist ζ for unit time.
    ///
    /// ```
    /// use frs_core::spatial::{Pose, Twist};
    /// let quarter_of_a_circle = Twist::from_array([0.0, 0.0, 1.0, 1.0, 0.0, 0.0]) * std::f64::consts::FRAC_PI_2;
    /// let end = Pose::exp(quarter_of_a_circle).translation;
    /// assert!((end.x - 1.0).abs() < 1e-15 && (end.y - 1.0).abs() < 1e-15);
    /// ```
    pub fn exp(zeta: Twist<T>) -> Self {
        Self::new(so3::exp(zeta.angular), so3::dexp(zeta.angular, zeta.linear))
    }

    /// `log(g)`: the twist `ζ = [φ; ρ]` with `exp(ζ) = g` and |φ| ≤ π; of the two at |φ| = π, one.
    pub fn log(&self) -> Twist<T> {
        let phi = so3::log(&self.rotation);
        Twist::new(phi, so3::dexp_inverse(phi, self.translation))
    }
}

impl<T: Real> Twist<T> {
    /// `dexp_ζ W = Σ ad_ζ^k W/(k+1)!`, ζ = `self`: the right-trivialised tangent of [`Pose::exp`].
    ///
    /// ```text
    /// d/dt exp(ζ(t)) = (dexp_ζ ζ̇)^ exp(ζ) = exp(ζ) (dexp_{−ζ} ζ̇)^
    /// ```
    ///
    /// so the body twist is `(-zeta).dexp(rate)`, and `dexp_ζ = Ad_{exp ζ} dexp_{−ζ}`.
    pub fn dexp(self, other: Self) -> Self {
        self.lift(Stumpff::new(self.angular.dot(&self.angular)).dexp(), other)
    }

    /// `dexp_ζ⁻¹ W`, ζ = `self`; singular where the angle of ζ is 2π, 4π, …
    ///
    /// With `ġ = g V^` and `g = g₀ exp(ζ)`, the equation a Munthe-Kaas method integrates is `ζ̇ = dexp⁻¹_{−ζ} V`:
    ///
    /// ```
    /// use frs_core::spatial::Twist;
    /// let zeta = Twist::from_array([0.1, 0.2, -0.3, 1.0, 2.0, 3.0]);
    /// let body_twist = Twist::from_array([1.0, 0.0, -1.0, 0.5, 0.0, 2.0]);
    /// let rate = (-zeta).dexp_inverse(body_twist);
    /// assert!(((-zeta).dexp(rate) - body_twist).to_vector().norm() < 1e-14);
    /// ```
    pub fn dexp_inverse(self, other: Self) -> Self {
        self.lift(Stumpff::new(self.angular.dot(&self.angular)).dexp_inverse(), other)
    }

    /// `[[M, 0], [DM, M]]` of the map M at this twist, times `other`.
    fn lift(self, map: Coaxial<T>, other: Self) -> Self {
        let (phi, rho) = (self.angular, self.linear);
        Self::new(
            map.apply(phi, other.angular),
            map.apply(phi, other.linear) + map.apply_slope(phi, rho, other.angular),
        )
    }
}
