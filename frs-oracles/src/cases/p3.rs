//! P3, two balanced rotors on parallel axes: a connection that is not zero and exactly flat.
//!
//! Source: the project's own. Both columns are turns about the same line through the centre of mass, so they commute.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{at, solid};
use crate::rotation::lifted;

pub const FORMULA: Formula = Formula {
    source: "two turns about one line through the centre of mass commute",
    connection: "A_i = a_i (0, 0, 1, c_y, −c_x, 0), a_i = I_i/K, K = Σ I + Σ m|x − c|²",
    curvature: "0",
};

const BASE: InertialDescription = solid(2.0, [0.25, -0.125, 0.0], [0.25, 0.375, 0.5], [0.0, 0.0, 0.0]);
const ROTOR_1: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.09375, 0.09375, 0.125], [0.0, 0.0, 0.0]);
const ROTOR_2: InertialDescription = solid(0.5, [0.0, 0.0, 0.0], [0.046875, 0.046875, 0.0625], [0.0, 0.0, 0.0]);

/// The rotors' axes in the base, m.
const AXES: [Vector3<f64>; 2] = [Vector3::new(0.5, 0.75, 0.0), Vector3::new(-0.75, 0.25, 0.0)];

pub fn values<T: Real>(_: &[T]) -> Values<T> {
    let bodies = [(BASE, BASE.com), (ROTOR_1, AXES[0]), (ROTOR_2, AXES[1])];
    let total: f64 = bodies.iter().map(|(body, _)| body.mass).sum();
    let moment: Vector3<f64> = bodies.iter().map(|(body, x)| x * body.mass).sum();
    let com = lifted::<T>(moment) / T::from_f64(total);
    let locked = bodies.iter().fold(T::zero(), |locked, (body, x)| {
        let arm = lifted::<T>(*x) - com;
        locked + T::from_f64(body.inertia.zz) + T::from_f64(body.mass) * arm.dot(&arm)
    });
    let turns = [ROTOR_1, ROTOR_2].map(|rotor| T::from_f64(rotor.inertia.zz) / locked);
    Values::planar(&turns, com, &[Vector3::zeros(); 2], &[T::zero()])
}

/// The robot of `robots/oracles/p3.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("p3");
    robot.link("base", BASE);
    robot.link("rotor_1", ROTOR_1);
    robot.link("rotor_2", ROTOR_2);
    robot.joint("joint_1", JointKind::Continuous, "base", "rotor_1").origin(at([0.5, 0.75, 0.0])).axis(0.0, 0.0, 1.0);
    robot.joint("joint_2", JointKind::Continuous, "base", "rotor_2").origin(at([-0.75, 0.25, 0.0])).axis(0.0, 0.0, 1.0);
    robot
}
