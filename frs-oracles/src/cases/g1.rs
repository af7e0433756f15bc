//! G1, three rotors on the principal axes of a satellite: a constant connection whose curvature is the bracket alone.
//!
//! Source: the rigid body with internal rotors, Krishnaprasad (1985); Bloch, Krishnaprasad, Marsden, Sánchez de Alvarez
//! (1992). The formula in this form is the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::solid;

pub const FORMULA: Formula = Formula {
    source: "rigid body with internal rotors, Krishnaprasad (1985), Bloch and others (1992)",
    connection: "A_i = (j_i/λ_i) e_i, λ the locked inertia about the axes: (1, 3/2, 2)",
    curvature: "𝓑(e_i, e_j) = −(j_i j_j/λ_i λ_j) e_i × e_j",
};

const BASE: InertialDescription = solid(4.0, [0.0, 0.0, 0.0], [0.640625, 1.109375, 1.65625], [0.0, 0.0, 0.0]);
const ROTOR_1: InertialDescription = solid(0.5, [0.0, 0.0, 0.0], [0.125, 0.09375, 0.09375], [0.0, 0.0, 0.0]);
const ROTOR_2: InertialDescription = solid(0.75, [0.0, 0.0, 0.0], [0.1875, 0.25, 0.1875], [0.0, 0.0, 0.0]);
const ROTOR_3: InertialDescription = solid(0.25, [0.0, 0.0, 0.0], [0.046875, 0.046875, 0.0625], [0.0, 0.0, 0.0]);

pub fn values<T: Real>(_: &[T]) -> Values<T> {
    let diagonal = |body: &InertialDescription| Vector3::new(body.inertia.xx, body.inertia.yy, body.inertia.zz);
    let rotors = [ROTOR_1, ROTOR_2, ROTOR_3];
    let locked = rotors.iter().fold(diagonal(&BASE), |sum, rotor| sum + diagonal(rotor));
    let turns: [Vector3<T>; 3] =
        std::array::from_fn(|i| Vector3::ith(i, T::from_f64(diagonal(&rotors[i])[i]) / T::from_f64(locked[i])));
    let bracket = |(i, j): (usize, usize)| turns[j].cross(&turns[i]);
    let curvature: Vec<_> = Values::<T>::pairs(3).map(bracket).collect();
    Values::turning(&turns, Vector3::zeros(), &[Vector3::zeros(); 3], &curvature)
}

/// The robot of `robots/oracles/g1.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("g1");
    robot.link("base", BASE);
    robot.link("rotor_1", ROTOR_1);
    robot.link("rotor_2", ROTOR_2);
    robot.link("rotor_3", ROTOR_3);
    robot.joint("joint_1", JointKind::Continuous, "base", "rotor_1").axis(1.0, 0.0, 0.0);
    robot.joint("joint_2", JointKind::Continuous, "base", "rotor_2").axis(0.0, 1.0, 0.0);
    robot.joint("joint_3", JointKind::Continuous, "base", "rotor_3").axis(0.0, 0.0, 1.0);
    robot
}
