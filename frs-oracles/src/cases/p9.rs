//! P9, a planar base with two rails at right angles, one slider on each.
//!
//! Source: the project's own; sliding shape change as in Shen and McClamroch (2002).

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{RAIL, at, solid};
use crate::reduced_mass::reduced_masses;

pub const FORMULA: Formula = Formula {
    source: "the project's own; sliding shape change as in Shen, McClamroch (2002)",
    connection: "a_i = h_i/K, h₁ = −(μ₁₁b₁ + μ₁₂y), h₂ = μ₂₂b₂ + μ₁₂x, K = ΣI + μ₁₁(x² + b₁²) + 2μ₁₂(xb₂ + b₁y) + μ₂₂(b₂² + y²)",
    curvature: "𝓑 = F (0, 0, 1, c_y, −c_x, 0), F = (2μ₁₂K − h₂K_x + h₁K_y)/K², K_x = 2(μ₁₁x + μ₁₂b₂), K_y = 2(μ₂₂y + μ₁₂b₁)",
};

const BASE: InertialDescription = solid(2.0, [0.0, 0.0, 0.0], [0.25, 0.375, 0.5], [0.0, 0.0, 0.0]);
const SLIDER_1: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.0625, 0.0625, 0.0625], [0.0, 0.0, 0.0]);
const SLIDER_2: InertialDescription = solid(0.75, [0.0, 0.0, 0.0], [0.03125, 0.03125, 0.03125], [0.0, 0.0, 0.0]);

/// How far the rails stand off the base's centre of mass: the first one along y, the second one along x, m.
const OFFSETS: [f64; 2] = [0.25, -0.5];

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let real = T::from_f64;
    let [[m11, m12], [_, m22]] = reduced_masses::<T, 2>(BASE.mass, [SLIDER_1.mass, SLIDER_2.mass]);
    let ([b1, b2], [x, y], two) = (OFFSETS.map(real), [q[0], q[1]], real(2.0));
    let inertia = real(BASE.inertia.zz + SLIDER_1.inertia.zz + SLIDER_2.inertia.zz);
    let k = inertia + m11 * (x * x + b1 * b1) + two * m12 * (x * b2 + b1 * y) + m22 * (b2 * b2 + y * y);
    let (h1, h2) = (-(m11 * b1 + m12 * y), m22 * b2 + m12 * x);
    let (k_x, k_y) = (two * (m11 * x + m12 * b2), two * (m22 * y + m12 * b1));
    let f = (two * m12 * k - h2 * k_x + h1 * k_y) / (k * k);

    let total = real(BASE.mass + SLIDER_1.mass + SLIDER_2.mass);
    let [w1, w2] = [SLIDER_1, SLIDER_2].map(|slider| real(slider.mass) / total);
    let com = Vector3::new(w1 * x + w2 * b2, w1 * b1 + w2 * y, T::zero());
    Values::planar(&[h1 / k, h2 / k], com, &[Vector3::x() * w1, Vector3::y() * w2], &[f])
}

/// The robot of `robots/oracles/p9.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("p9");
    robot.link("base", BASE);
    robot.link("slider_1", SLIDER_1);
    robot.link("slider_2", SLIDER_2);
    robot
        .joint("joint_1", JointKind::Prismatic, "base", "slider_1")
        .origin(at([0.0, 0.25, 0.0]))
        .axis(1.0, 0.0, 0.0)
        .limits(RAIL);
    robot
        .joint("joint_2", JointKind::Prismatic, "base", "slider_2")
        .origin(at([-0.5, 0.0, 0.0]))
        .axis(0.0, 1.0, 0.0)
        .limits(RAIL);
    robot
}
