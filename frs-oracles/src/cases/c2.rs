//! C2, the falling cat: C1 with two equal halves.
//!
//! Source: Kane and Scher, Int. J. Solids Struct. 5 (1969) 663, eq. (5), whose law the restriction to q = (α, β, −α) is;
//! gauge theory in Montgomery (1993). The closed form is the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::solid;
use crate::wrist::Wrist;

pub const FORMULA: Formula = Formula {
    source: "Kane, Scher, Int. J. Solids Struct. 5 (1969) 663; Montgomery (1993); the closed form is C1's",
    connection: "C1's; on q = (α, β, −α) a turn f dα about e, f = −kC/(S² + kC²), k = j/a, S and C of β/2",
    curvature: "C1's; on q = (α, β, −α): 𝓑_ω(∂α, ∂β) = −½kS(1 + (1 − k)C²)/(S² + kC²)² e, e = (S cos α, S sin α, C)",
};

const BASE: InertialDescription = solid(2.0, [0.0, 0.0, 0.0], [0.5, 0.5, 0.125], [0.0, 0.0, 0.0]);
const TAIL: InertialDescription = solid(2.0, [0.0, 0.0, 0.5], [0.5, 0.5, 0.125], [0.0, 0.0, 0.0]);

const WRIST: Wrist = Wrist { base: BASE, tail: TAIL, height: 0.5 };

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    WRIST.values(q)
}

/// 𝓑_ω(∂α, ∂β) of the falling cat, [`Case::C2`](crate::Case::C2), on the surface q = (α, β, −α) where its halves do not twist.
///
/// `−½ k S (1 + (1 − k)C²)/(S² + kC²)² e` with e = (S cos α, S sin α, C), S = sin ½β, C = cos ½β, k = ¼ the ratio of axial to
/// transverse inertia; neither masses nor lengths enter. In base axes, per rad².
pub fn no_twist_curvature<T: Real>(alpha: T, beta: T) -> Vector3<T> {
    let half = T::from_f64(0.5);
    let k = T::from_f64(BASE.inertia.zz) / T::from_f64(BASE.inertia.xx);
    let ((s, c), (sin, cos)) = ((half * beta).sin_cos(), alpha.sin_cos());
    let d = s * s + k * c * c;
    Vector3::new(s * cos, s * sin, c) * -(half * k * s * (T::one() + (T::one() - k) * c * c) / (d * d))
}

/// The robot of `robots/oracles/c2.urdf`, built in code.
pub fn robot() -> RobotDescription {
    WRIST.robot("c2")
}
