//! Serial chains of any length, for timing growth.

use frs::Model;
use frs::model::{InertialDescription, JointKind, RobotDescription};
use frs::nalgebra::Vector3;
use frs::spatial::{Pose, Symmetric3};

/// A serial chain of `n` revolute joints with nothing aligned: no zero is free.
pub fn chain(n: usize) -> Model {
    let mut rng = fastrand::Rng::with_seed(n as u64);
    let mut unit = || 2.0 * rng.f64() - 1.0;
    let mut robot = RobotDescription::new(format!("chain_{n}"));
    let mut body = || {
        let mut unit = || 0.5 + 0.5 * unit();
        InertialDescription {
            mass: 1.0 + unit(),
            com: Vector3::new(0.1 * unit(), 0.1 * unit(), 0.1 * unit()),
            inertia: Symmetric3 {
                xy: 0.01 * unit(),
                xz: 0.01 * unit(),
                yz: 0.01 * unit(),
                ..Symmetric3::diagonal(Vector3::repeat(0.2 + 0.1 * unit()))
            },
        }
    };
    robot.link("link_0", body());
    for k in 1..=n {
        robot.link(format!("link_{k}"), body());
    }
    for k in 1..=n {
        let turn = k as f64;
        robot
            .joint(format!("joint_{k}"), JointKind::Revolute, format!("link_{}", k - 1), format!("link_{k}"))
            .axis(turn.sin(), turn.cos(), 0.3)
            .origin(Pose::from_rpy(Vector3::new(0.1, 0.05, 0.2), [0.1 * turn, 0.2, -0.3 * turn]));
    }
    robot.build().unwrap_or_else(|error| panic!("the chain is a robot: {error}"))
}
