//! Rotations: the exponential of SO(3), its principal logarithm and its tangent.
//!
//! A rotation vector φ is axis times angle, in radians. The tangent is *right-trivialised*: `dexp` gives the angular
//! velocity that stands left of the rotation,
//!
//! ```text
//! d/dt exp(φ(t)) = (dexp_φ φ̇)× exp(φ) = exp(φ) (dexp_{−φ} φ̇)×
//! ```
//!
//! so for a body angular velocity, `Ṙ = R ω×` with `R = R₀ exp(φ)`, the equation a Munthe-Kaas method integrates is
//! `φ̇ = dexp⁻¹_{−φ} ω`: [`dexp_inverse`]`(-phi, omega)`. The equations for SE(3) are the same, see [`Twist::dexp`].
//!
//! No value decides what is computed. Errors are a few units in the last place, at φ = 0 and at |φ| = π too; for angles
//! of many turns they grow as |φ|, since the angle itself is rounded.
//!
//! [`Twist::dexp`]: super::Twist::dexp

use nalgebra::{Matrix3, Vector3};

use super::stumpff::Stumpff;
use crate::Real;

/// `exp(φ) = 1 + sin θ/θ φ× + (1 − cos θ)/θ² φ×φ×`, θ = |φ|: the rotation by θ about φ.
///
/// ```
/// use frs_core::spatial::so3;
/// use nalgebra::Vector3;
/// let quarter = so3::exp(Vector3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2));
/// assert!((quarter * Vector3::x() - Vector3::y()).norm() < 1e-15);
/// ```
pub fn exp<T: Real>(phi: Vector3<T>) -> Matrix3<T> {
    let Stumpff { half_cos: w, half_sin, .. } = Stumpff::new(phi.dot(&phi));
    // By the quaternion (w, v), divided by its norm, which takes the roundings of θ and of sin ½θ out.
    let v = phi * half_sin;
    let scale = T::from_f64(2.0) / (w * w + v.dot(&v));
    let (xx, yy, zz) = (v.x * v.x, v.y * v.y, v.z * v.z);
    let (xy, xz, yz) = (v.x * v.y, v.x * v.z, v.y * v.z);
    let (wx, wy, wz) = (w * v.x, w * v.y, w * v.z);
    let one = T::one();
    Matrix3::new(
        one - scale * (yy + zz),
        scale * (xy - wz),
        scale * (xz + wy),
        scale * (xy + wz),
        one - scale * (xx + zz),
        scale * (yz - wx),
        scale * (xz - wy),
        scale * (yz + wx),
        one - scale * (xx + yy),
    )
}

/// `log(R)`: the shortest rotation vector φ with `exp(φ) = R`, |φ| ≤ π; of the two at |φ| = π, one.
///
/// `rotation` must be a rotation matrix; its rounding passes through, magnified at most a few times.
///
/// ```
/// use frs_core::spatial::so3;
/// use nalgebra::{Matrix3, Vector3};
/// assert_eq!(so3::log(&Matrix3::<f64>::identity()), Vector3::zeros());
/// let half_turn = Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, -1.0));
/// assert_eq!(so3::log(&half_turn), Vector3::new(0.0, std::f64::consts::PI, 0.0));
/// ```
pub fn log<T: Real>(rotation: &Matrix3<T>) -> Vector3<T> {
    let (r, one, two) = (rotation, T::one(), T::from_f64(2.0));
    let (x, y, z) = (r.m32 - r.m23, r.m13 - r.m31, r.m21 - r.m12);
    let (yz, zx, xy) = (r.m32 + r.m23, r.m13 + r.m31, r.m21 + r.m12);
    let (ww, xx) = (one + r.m11 + r.m22 + r.m33, one + r.m11 - r.m22 - r.m33);
    let (yy, zz) = (one - r.m11 + r.m22 - r.m33, one - r.m11 - r.m22 + r.m33);

    // The rows of 4 q qᵀ, q = ±(cos ½θ, sin ½θ n): each is a multiple of q, the one with the largest square the best.
    let (w_or_x, square_wx) = larger(([ww, x, y, z], ww), ([x, xx, xy, zx], xx));
    let (y_or_z, square_yz) = larger(([y, xy, yy, yz], yy), ([z, zx, yz, zz], zz));
    let ([w, x, y, z], _) = larger((w_or_x, square_wx), (y_or_z, square_yz));

    // Of ±q the one with cos ½θ ≥ 0, hence θ ≤ π.
    let sign = w.select_below(0.0, -one, one);
    let (cos, axis) = (w * sign, Vector3::new(x, y, z) * sign);
    let square = axis.dot(&axis);
    let sin = square.sqrt();
    // |φ|/|axis| = 2 atan(t)/(t cos), t = tan ½θ. Two terms of its series, the third is 10⁻³⁵ of it, serve axes whose
    // square underflows.
    let tt = square / (cos * cos);
    let near = (one - tt / T::from_f64(3.0)) / cos;
    axis * (two * tt.select_below(1e-17, near, sin.atan2(cos) / sin))
}

/// The candidate with the larger square.
fn larger<T: Real>(a: ([T; 4], T), b: ([T; 4], T)) -> ([T; 4], T) {
    let select = |a_value: T, b_value: T| (a.1 - b.1).select_below(0.0, b_value, a_value);
    (std::array::from_fn(|i| select(a.0[i], b.0[i])), select(a.1, b.1))
}

/// `dexp_φ y = Σ (φ×)^k y/(k+1)!`: the angular velocity, left of `exp(φ)`, that φ̇ = y makes.
///
/// For the body's (right of `exp(φ)`) take `-phi`.
///
/// ```
/// use frs_core::spatial::so3;
/// use nalgebra::Vector3;
/// let (phi, rate) = (Vector3::new(0.3, -0.2, 0.9), Vector3::new(1.0, 2.0, 3.0));
/// let (space, body) = (so3::dexp(phi, rate), so3::dexp(-phi, rate));
/// assert!((space - so3::exp(phi) * body).norm() < 1e-14);
/// ```
pub fn dexp<T: Real>(phi: Vector3<T>, y: Vector3<T>) -> Vector3<T> {
    Stumpff::new(phi.dot(&phi)).dexp().apply(phi, y)
}

/// `dexp_φ⁻¹ y`: the φ̇ that makes the angular velocity y, left of `exp(φ)`. Singular at |φ| = 2π, 4π, …
///
/// For a body angular velocity take `-phi`.
pub fn dexp_inverse<T: Real>(phi: Vector3<T>, y: Vector3<T>) -> Vector3<T> {
    Stumpff::new(phi.dot(&phi)).dexp_inverse().apply(phi, y)
}
