//! D4, a mass on a tether: the field of D1 in the coordinates yaw, pitch and length.
//!
//! Source: the project's own; a change of coordinates pulls connection and curvature back.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{RAIL, at, solid};
use crate::monopole::Monopole;
use crate::rotation::lifted;

pub const FORMULA: Formula = Formula {
    source: "D1 in other coordinates, which pull connection and curvature back",
    connection: "A_ω,k = (ε/κ) r × t_k, κ = I + ε|r|², r = h + ℓu, ℓ = ½ + q₃, u = R_z(q₁)R_y(q₂)x, t_k = ∂r/∂q_k; c = (m/M) r",
    curvature: "𝓑_ω(e_k, e_l) = (2εI n + ε²(r·n) r)/κ², n = t_k × t_l; 𝓑_v = c × 𝓑_ω",
};

const BASE: InertialDescription = solid(2.0, [0.0, 0.0, 0.0], [0.5, 0.5, 0.5], [0.0, 0.0, 0.0]);
const BOB: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]);

/// The hinge in the base, m.
const HINGE: Vector3<f64> = Vector3::new(0.25, -0.125, 0.5);
/// Length of the tether at q₃ = 0, m.
const LENGTH: f64 = 0.5;

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let ([(s1, c1), (s2, c2)], length) = ([q[0], q[1]].map(Real::sin_cos), T::from_f64(LENGTH) + q[2]);
    let u = Vector3::new(c1 * c2, s1 * c2, -s2);
    let yaw = Vector3::new(-(s1 * c2), c1 * c2, T::zero()) * length;
    let pitch = Vector3::new(-(c1 * s2), -(s1 * s2), -c2) * length;
    let monopole = Monopole { base: BASE.mass, base_com: BASE.com, mass: BOB.mass, inertia: BASE.inertia.xx };
    monopole.values(lifted::<T>(HINGE) + u * length, [yaw, pitch, u])
}

/// The robot of `robots/oracles/d4.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("d4");
    robot.link("base", BASE);
    robot.link("yaw", InertialDescription::NONE);
    robot.link("pitch", InertialDescription::NONE);
    robot.link("bob", BOB);
    robot.joint("joint_1", JointKind::Continuous, "base", "yaw").origin(at([0.25, -0.125, 0.5])).axis(0.0, 0.0, 1.0);
    robot.joint("joint_2", JointKind::Continuous, "yaw", "pitch").axis(0.0, 1.0, 0.0);
    robot
        .joint("joint_3", JointKind::Prismatic, "pitch", "bob")
        .origin(at([0.5, 0.0, 0.0]))
        .axis(1.0, 0.0, 0.0)
        .limits(RAIL);
    robot
}
