//! Random robots from a seed.

use frs_core::Model;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use frs_core::spatial::{Pose, Symmetric3};
use nalgebra::Vector3;

/// Joints of a random robot.
pub const JOINTS: usize = 5;

/// A tree of links with any masses, joints anywhere, every third one sliding.
pub fn robot(seed: u64) -> Model {
    let mut rng = fastrand::Rng::with_seed(seed);
    let mut robot = RobotDescription::new(format!("random {seed}"));
    robot.link("link_0", solid(&mut rng));
    for k in 1..=JOINTS {
        let kind = if k % 3 == 0 { JointKind::Prismatic } else { JointKind::Revolute };
        let parent = rng.usize(k.saturating_sub(2)..k);
        robot.link(format!("link_{k}"), solid(&mut rng));
        let origin = Pose::from_rpy(vector(&mut rng), vector(&mut rng).into());
        let axis = vector(&mut rng);
        let joint = robot.joint(format!("joint_{k}"), kind, format!("link_{parent}"), format!("link_{k}"));
        joint.origin(origin).axis(axis.x, axis.y, axis.z);
    }
    robot.build().unwrap_or_else(|error| panic!("seed {seed}: {error}"))
}

/// Three numbers within ±1.
fn vector(rng: &mut fastrand::Rng) -> Vector3<f64> {
    Vector3::from_fn(|_, _| 2.0 * rng.f64() - 1.0)
}

/// An inertia that a body can have: from second moments of mass, turned somehow.
fn solid(rng: &mut fastrand::Rng) -> InertialDescription {
    let mass = 0.5 + rng.f64();
    let [a, b, c] = [(); 3].map(|()| mass * (0.05 + 0.2 * rng.f64()));
    let turn = Pose::from_rpy(Vector3::zeros(), vector(rng).into()).rotation;
    InertialDescription {
        mass,
        com: vector(rng) * 0.5,
        inertia: Symmetric3::diagonal(Vector3::new(b + c, a + c, a + b)).rotated(&turn),
    }
}
