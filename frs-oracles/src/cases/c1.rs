//! C1, two different axisymmetric bodies with a z-y-z wrist on their axes.
//!
//! Source: the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, RobotDescription};

use super::Formula;
use crate::Values;
use crate::description::solid;
use crate::wrist::Wrist;

pub const FORMULA: Formula = Formula {
    source: "the project's own",
    connection: "A_ω = R_z(q₁)[z − j₁K⁻¹z, ηy, j₂K⁻¹b], b = (sin q₂, 0, cos q₂), η = (a₂ + εℓ₂(ℓ₂ + ℓ₁cos q₂))/K_yy; A_v = c × A_ω + J_c",
    curvature: "𝓑_ω,12 = j₁R_z(q₁)(u′ − ηw, 0, w′ + ηu), (u, w) = K⁻¹z; 𝓑_ω,23 the same with j₂K⁻¹b; 𝓑_ω,13 = (j₁j₂ sin q₂/Δ) R_z(q₁)y",
};

const BASE: InertialDescription = solid(2.0, [0.0, 0.0, -0.125], [0.5, 0.5, 0.25], [0.0, 0.0, 0.0]);
const TAIL: InertialDescription = solid(1.5, [0.0, 0.0, 0.25], [0.375, 0.375, 0.125], [0.0, 0.0, 0.0]);

const WRIST: Wrist = Wrist { base: BASE, tail: TAIL, height: 0.5 };

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    WRIST.values(q)
}

/// The robot of `robots/oracles/c1.urdf`, built in code.
pub fn robot() -> RobotDescription {
    WRIST.robot("c1")
}
