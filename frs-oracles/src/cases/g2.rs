//! G2, a gyrostat in general position: rotors anywhere, each symmetric about its axis, one of them askew.
//!
//! Source: the project's own, from `K⁻¹u × K⁻¹w = K(u × w)/det K`.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::{Matrix3, Vector3};

use super::Formula;
use crate::Values;
use crate::adjugate::{determinant, inverse};
use crate::description::{at, solid};
use crate::rotation::{lifted, polar};

pub const FORMULA: Formula = Formula {
    source: "the project's own, from K⁻¹u × K⁻¹w = K(u × w)/det K",
    connection: "A_ω,i = j_i K⁻¹u_i, A_v = c × A_ω; K the constant locked inertia about the centre of mass c",
    curvature: "𝓑_ω(e_i, e_j) = −(j_i j_j/det K) K(u_i × u_j), 𝓑_v = c × 𝓑_ω",
};

const BASE: InertialDescription = solid(4.0, [0.125, -0.25, 0.0625], [1.0, 1.25, 1.5], [0.125, -0.0625, 0.1875]);
const ROTOR_1: InertialDescription = solid(0.5, [0.0, 0.0, 0.0], [0.25, 0.1875, 0.1875], [0.0, 0.0, 0.0]);
const ROTOR_2: InertialDescription = solid(0.75, [0.0, 0.0, 0.0], [0.1875, 0.25, 0.1875], [0.0, 0.0, 0.0]);
const ROTOR_3: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.1875, 0.1875, 0.1875], [0.0, 0.0, 0.0]);

/// Where the rotors stand in the base, m.
const PLACES: [Vector3<f64>; 3] =
    [Vector3::new(0.5, 0.25, 0.0), Vector3::new(-0.25, 0.5, 0.75), Vector3::new(0.25, -0.75, 0.5)];

pub fn values<T: Real>(_: &[T]) -> Values<T> {
    let skew = Vector3::new(1.0, 2.0, 2.0).map(|x| T::from_f64(x) / T::from_f64(3.0));
    let axes = [Vector3::x(), Vector3::y(), skew];
    let axial = [ROTOR_1.inertia.xx, ROTOR_2.inertia.yy, ROTOR_3.inertia.zz].map(T::from_f64);
    let bodies = [(BASE, BASE.com), (ROTOR_1, PLACES[0]), (ROTOR_2, PLACES[1]), (ROTOR_3, PLACES[2])];
    let total: f64 = bodies.iter().map(|(body, _)| body.mass).sum();
    let moment: Vector3<f64> = bodies.iter().map(|(body, x)| x * body.mass).sum();
    let com = lifted::<T>(moment) / T::from_f64(total);
    // Rotors do not change their inertia by turning, and the third one has the same about every axis.
    let locked = bodies.iter().fold(Matrix3::zeros(), |locked, (body, x)| {
        let arm = lifted::<T>(*x) - com;
        locked + body.inertia.to_matrix().map(T::from_f64) + polar(arm, arm) * T::from_f64(body.mass)
    });
    let solve = inverse(&locked);
    let turns: [Vector3<T>; 3] = std::array::from_fn(|i| solve * axes[i] * axial[i]);
    let field =
        |(i, j): (usize, usize)| locked * axes[j].cross(&axes[i]) * (axial[i] * axial[j] / determinant(&locked));
    let curvature: Vec<_> = Values::<T>::pairs(3).map(field).collect();
    Values::turning(&turns, com, &[Vector3::zeros(); 3], &curvature)
}

/// The robot of `robots/oracles/g2.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("g2");
    robot.link("base", BASE);
    robot.link("rotor_1", ROTOR_1);
    robot.link("rotor_2", ROTOR_2);
    robot.link("rotor_3", ROTOR_3);
    robot.joint("joint_1", JointKind::Continuous, "base", "rotor_1").origin(at([0.5, 0.25, 0.0])).axis(1.0, 0.0, 0.0);
    robot.joint("joint_2", JointKind::Continuous, "base", "rotor_2").origin(at([-0.25, 0.5, 0.75])).axis(0.0, 1.0, 0.0);
    robot.joint("joint_3", JointKind::Continuous, "base", "rotor_3").origin(at([0.25, -0.75, 0.5])).axis(1.0, 2.0, 2.0);
    robot
}
