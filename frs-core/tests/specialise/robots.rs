//! Random robots with many links a body, and the bits of a model.

use std::cell::RefCell;

use frs_core::Model;
use frs_core::model::{Inertial, InertialDescription, JointKind, RobotDescription};
use frs_core::spatial::{Pose, Symmetric3, so3};
use nalgebra::Vector3;
use proptest::prelude::*;
use proptest::sample::Index;

/// Most links that a random robot has beside its base.
pub const MOST_LINKS: usize = 8;

pub fn config() -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::default() }
}

/// Trees with many links joined by fixed joints, some of them frames without mass, with followers and from any root. The
/// first joint always turns.
pub fn robots() -> impl Strategy<Value = RobotDescription> {
    let link = (any::<Index>(), 0..8_usize, any::<Index>(), prop::array::uniform3(triple()), inertial());
    (inertial(), prop::collection::vec(link, 2..=MOST_LINKS), any::<Index>()).prop_map(|(base, links, root)| {
        let mut robot = RobotDescription::new("random");
        robot.link("link_0", base);
        for (i, (parent, kind, follows, [xyz, turn, axis], inertial)) in links.iter().enumerate() {
            let (kind, inertial) = match kind {
                _ if i == 0 => (JointKind::Revolute, *inertial),
                0 | 1 => (JointKind::Fixed, *inertial),
                2 => (JointKind::Fixed, InertialDescription::NONE),
                3 => (JointKind::Prismatic, *inertial),
                _ => (JointKind::Revolute, *inertial),
            };
            let [parent, child] = [parent.index(i + 1), i + 1].map(|link| format!("link_{link}"));
            robot.link(child.clone(), inertial);
            let joint = robot.joint(format!("joint_{i}"), kind, parent, child);
            joint.axis(axis.x + 2.0, axis.y, axis.z).origin(Pose::new(so3::exp(*turn), *xyz));
            if i > 0 && kind == JointKind::Revolute && follows.index(4) == 0 {
                joint.mimic("joint_0", -0.5, 0.25);
            }
        }
        robot.root = Some(format!("link_{}", root.index(robot.links.len())));
        robot
    })
}

/// A mass distribution that a body can have: second moments of mass are positive in every direction.
pub fn inertial() -> impl Strategy<Value = InertialDescription> {
    (0.1..3.0, triple(), prop::array::uniform3(0.02..0.3), triple()).prop_map(
        |(mass, com, [a, b, c], turn): (f64, _, _, _)| {
            let inertia = Symmetric3::diagonal(Vector3::new(b + c, a + c, a + b)).rotated(&so3::exp(turn * 3.0));
            Inertial { mass, com, inertia: inertia * mass }
        },
    )
}

fn triple() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vector3::from)
}

/// Every number of a model, in bits.
pub fn bits(model: &Model) -> Vec<u64> {
    let bits = RefCell::new(Vec::new());
    model.map(|number| {
        bits.borrow_mut().push(number.to_bits());
        number
    });
    bits.into_inner()
}
