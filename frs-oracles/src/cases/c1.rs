//! C1, two different axisymmetric bodies with a z-y-z wrist on their axes.
//!
//! Source: the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};

use super::Formula;
use crate::Values;
use crate::description::{at, solid};
use crate::wrist::Wrist;

pub const FORMULA: Formula = Formula {
    source: "the project's own",
    connection: "A_ω = R_z(q₁)[z − j₁K⁻¹z, ηy, j₂K⁻¹b], b = (sin q₂, 0, cos q₂), η = (a₂ + εℓ₂(ℓ₂ + ℓ₁cos q₂))/K_yy; A_v = c × A_ω + J_c",
    curvature: "𝓑_ω,12 = j₁R_z(q₁)(u′ − ηw, 0, w′ + ηu), (u, w) = K⁻¹z; 𝓑_ω,23 the same with j₂K⁻¹b; 𝓑_ω,13 = (j₁j₂ sin q₂/Δ) R_z(q₁)y",
};

const BASE: InertialDescription = solid(2.0, [0.0, 0.0, -0.125], [0.5, 0.5, 0.25], [0.0, 0.0, 0.0]);
const TAIL: InertialDescription = solid(1.5, [0.0, 0.0, 0.25], [0.375, 0.375, 0.125], [0.0, 0.0, 0.0]);

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    Wrist { base: BASE, tail: TAIL, height: 0.5 }.values(q)
}

/// The robot of `robots/oracles/c1.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("c1");
    robot.link("base", BASE);
    robot.link("wrist_1", InertialDescription::NONE);
    robot.link("wrist_2", InertialDescription::NONE);
    robot.link("tail", TAIL);
    robot.joint("joint_1", JointKind::Continuous, "base", "wrist_1").origin(at([0.0, 0.0, 0.5])).axis(0.0, 0.0, 1.0);
    robot.joint("joint_2", JointKind::Continuous, "wrist_1", "wrist_2").axis(0.0, 1.0, 0.0);
    robot.joint("joint_3", JointKind::Continuous, "wrist_2", "tail").axis(0.0, 0.0, 1.0);
    robot
}
