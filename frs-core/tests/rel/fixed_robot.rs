//! One robot and one state of it, for what is to be seen once and exactly.

use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use frs_core::spatial::{Pose, Symmetric3};
use nalgebra::{DVector, Matrix3, Vector3, Vector6};

use crate::algebra::rotation;
use crate::trees::Case;

/// A base with an arm of four joints that branches, nothing on an axis, and a state of it.
pub fn branching_arm() -> Case {
    let mut robot = RobotDescription::new("branching arm");
    let solid = |mass: f64, com: [f64; 3], angles: [f64; 3]| {
        let r = rotation(angles);
        let principal = Matrix3::from_diagonal(&Vector3::new(0.5, 0.7, 0.4));
        let inertia = Symmetric3::from_lower(&(r * principal * r.transpose() * mass));
        InertialDescription { mass, com: Vector3::from(com), inertia }
    };
    robot.link("base", solid(3.0, [0.2, -0.3, 0.1], [0.4, 1.0, -0.3]));
    robot.link("shoulder", solid(1.5, [0.1, 0.4, -0.2], [1.2, 0.1, 0.5]));
    robot.link("slider", solid(1.0, [-0.3, 0.2, 0.3], [0.3, -0.8, 2.0]));
    robot.link("elbow", solid(1.2, [0.3, -0.1, 0.2], [-1.0, 0.4, 0.9]));
    robot.link("wing", solid(0.8, [0.5, 0.1, -0.4], [0.7, 0.7, -1.5]));
    let at = |p: [f64; 3], angles| Pose::new(rotation(angles), Vector3::from(p));
    let turn = JointKind::Revolute;
    robot.joint("j1", turn, "base", "shoulder").axis(0.2, 1.0, -0.5).origin(at([0.6, 0.2, -0.4], [0.5, -0.2, 1.0]));
    robot
        .joint("j2", JointKind::Prismatic, "shoulder", "slider")
        .axis(1.0, -0.4, 0.3)
        .origin(at([0.3, 0.7, 0.2], [-0.9, 0.4, 0.1]));
    robot.joint("j3", turn, "slider", "elbow").axis(-0.3, 0.4, 1.0).origin(at([-0.2, 0.5, 0.6], [1.4, 0.3, -0.6]));
    robot.joint("j4", turn, "base", "wing").axis(1.0, 0.5, 0.4).origin(at([-0.7, 0.1, 0.5], [0.2, 1.1, 0.3]));
    let vector = |numbers: [f64; 4]| DVector::from_row_slice(&numbers);
    Case {
        robot,
        q: vector([0.4, -0.3, 0.9, -0.7]),
        qd: vector([0.8, -0.6, 1.1, 0.5]),
        x: vector([-0.5, 0.9, 0.3, -1.0]),
        y: vector([1.0, 0.2, -0.7, 0.6]),
        tau: vector([0.0; 4]),
        mu: Vector6::new(0.9, -0.7, 0.6, 0.5, 0.8, -1.1),
        v1: Vector6::new(-0.4, 1.0, 0.7, -0.9, 0.3, 0.6),
        wrench: Vector6::zeros(),
        pose: Pose::identity(),
    }
}
