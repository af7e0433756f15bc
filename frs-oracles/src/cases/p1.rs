//! P1, Elroy's beanie.
//!
//! Source: Marsden, Montgomery, Ratiu, Mem. AMS 436 (1990), §1, eq. (1), whose mechanical connection this is.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::solid;

pub const FORMULA: Formula = Formula {
    source: "Marsden, Montgomery, Ratiu, Mem. AMS 436 (1990), §1, eq. (1)",
    connection: "A = (0, 0, a, 0, 0, 0), a = I₁/(I₀ + I₁)",
    curvature: "0: one coordinate",
};

const BASE: InertialDescription = solid(2.0, [0.0, 0.0, 0.0], [0.25, 0.375, 0.5], [0.0, 0.0, 0.0]);
const ROTOR: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.09375, 0.09375, 0.125], [0.0, 0.0, 0.0]);

pub fn values<T: Real>(_: &[T]) -> Values<T> {
    let [base, rotor] = [BASE, ROTOR].map(|body| T::from_f64(body.inertia.zz));
    Values::planar(&[rotor / (base + rotor)], Vector3::zeros(), &[Vector3::zeros()], &[])
}

/// The robot of `robots/oracles/p1.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("p1");
    robot.link("base", BASE);
    robot.link("rotor", ROTOR);
    robot.joint("joint_1", JointKind::Continuous, "base", "rotor").axis(0.0, 0.0, 1.0);
    robot
}
