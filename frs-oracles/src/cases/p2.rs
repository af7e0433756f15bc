//! P2, a beanie with nothing at the origin.
//!
//! Source: the project's own extension of P1, by the parallel-axis theorem.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{at, solid};
use crate::reduced_mass::reduced_mass;
use crate::rotation::lifted;

pub const FORMULA: Formula = Formula {
    source: "P1 with the masses moved apart, by the parallel-axis theorem",
    connection: "A = a (0, 0, 1, c_y, −c_x, 0), a = I₁/(I₀ + I₁ + ε|p − c₀|²), c = (m₀c₀ + m₁p)/M",
    curvature: "0: one coordinate",
};

const BASE: InertialDescription = solid(2.0, [0.25, -0.125, 0.0], [0.25, 0.375, 0.5], [0.0, 0.0, 0.0]);
const ROTOR: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.09375, 0.09375, 0.125], [0.0, 0.0, 0.0]);

/// The rotor's axis in the base, m.
const AXIS: Vector3<f64> = Vector3::new(0.5, 0.75, 0.0);

pub fn values<T: Real>(_: &[T]) -> Values<T> {
    let [base, rotor] = [BASE, ROTOR].map(|body| T::from_f64(body.inertia.zz));
    let arm = lifted::<T>(AXIS - BASE.com);
    let locked = base + rotor + reduced_mass::<T>(BASE.mass, ROTOR.mass) * arm.dot(&arm);
    let com = lifted::<T>(BASE.com * BASE.mass + AXIS * ROTOR.mass) / T::from_f64(BASE.mass + ROTOR.mass);
    Values::planar(&[rotor / locked], com, &[Vector3::zeros()], &[])
}

/// The robot of `robots/oracles/p2.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("p2");
    robot.link("base", BASE);
    robot.link("rotor", ROTOR);
    robot.joint("joint_1", JointKind::Continuous, "base", "rotor").origin(at([0.5, 0.75, 0.0])).axis(0.0, 0.0, 1.0);
    robot
}
