//! P5, a planar chain of three links, an end link as base.
//!
//! Source: setting of Krishnaprasad and Yang (1991), Walsh and Sastry (1995); the cyclic form of F is the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{at, solid};
use crate::reduced_mass::reduced_masses;
use crate::rotation::{direction, lifted, quarter_turn};

pub const FORMULA: Formula = Formula {
    source: "three-link chain of Krishnaprasad, Yang (1991) and Walsh, Sastry (1995); the cyclic form is the project's own",
    connection: "a₁ = (P₁ + P₂)/D, a₂ = P₂/D, D = P₀ + P₁ + P₂, P_j = Σ_i β_ij cos(θ_j − θ_i); A_v = c × A_ω + J_c",
    curvature: "𝓑 = F (0, 0, 1, c_y, −c_x, 0), F = (2/D²)(β₀₁ sin q₁ P₂ + β₁₂ sin q₂ P₀ − β₀₂ sin(q₁ + q₂) P₁)",
};

const BASE: InertialDescription = solid(2.0, [0.25, 0.0, 0.0], [0.25, 0.375, 0.5], [0.0, 0.0, 0.0]);
const LINK_1: InertialDescription = solid(1.0, [0.375, 0.0, 0.0], [0.125, 0.1875, 0.25], [0.0, 0.0, 0.0]);
const LINK_2: InertialDescription = solid(0.75, [0.5, 0.0, 0.0], [0.0625, 0.09375, 0.125], [0.0, 0.0, 0.0]);

/// From the base's centre of mass to the first hinge, from there to the second, m.
const LENGTHS: [f64; 2] = [0.5, 0.875];

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let real = T::from_f64;
    let [l0, l1] = LENGTHS.map(real);
    let [s1, s2] = [LINK_1, LINK_2].map(|link| real(link.com.x));
    let [i0, i1, i2] = [BASE, LINK_1, LINK_2].map(|body| real(body.inertia.zz));
    let [[m11, m12], [_, m22]] = reduced_masses::<T, 2>(BASE.mass, [LINK_1.mass, LINK_2.mass]);
    let two = real(2.0);

    let b00 = i0 + l0 * l0 * (m11 + two * m12 + m22);
    let b01 = l0 * (s1 * (m11 + m12) + l1 * (m12 + m22));
    let b02 = l0 * s2 * (m12 + m22);
    let b11 = i1 + m11 * s1 * s1 + two * m12 * s1 * l1 + m22 * l1 * l1;
    let b12 = s2 * (m12 * s1 + m22 * l1);
    let b22 = i2 + m22 * s2 * s2;
    let [(sin1, cos1), (sin2, cos2), (sin12, cos12)] = [q[0], q[1], q[0] + q[1]].map(Real::sin_cos);
    let p0 = b00 + b01 * cos1 + b02 * cos12;
    let p1 = b01 * cos1 + b11 + b12 * cos2;
    let p2 = b02 * cos12 + b12 * cos2 + b22;
    let d = p0 + p1 + p2;
    let f = two * (b01 * sin1 * p2 + b12 * sin2 * p0 - b02 * sin12 * p1) / (d * d);

    let total = real(BASE.mass + LINK_1.mass + LINK_2.mass);
    let [w1, w2] = [LINK_1, LINK_2].map(|link| real(link.mass) / total);
    let [first, second] = [direction(q[0]) * (w1 * s1 + w2 * l1), direction(q[0] + q[1]) * (w2 * s2)];
    let com = lifted::<T>(BASE.com) + Vector3::x() * ((w1 + w2) * l0) + first + second;
    let com_jacobian = [quarter_turn(first + second), quarter_turn(second)];
    Values::planar(&[(p1 + p2) / d, p2 / d], com, &com_jacobian, &[f])
}

/// The robot of `robots/oracles/p5.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("p5");
    robot.link("base", BASE);
    robot.link("link_1", LINK_1);
    robot.link("link_2", LINK_2);
    robot.joint("joint_1", JointKind::Continuous, "base", "link_1").origin(at([0.75, 0.0, 0.0])).axis(0.0, 0.0, 1.0);
    robot.joint("joint_2", JointKind::Continuous, "link_1", "link_2").origin(at([0.875, 0.0, 0.0])).axis(0.0, 0.0, 1.0);
    robot
}
