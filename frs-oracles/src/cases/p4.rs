//! P4, two planar bodies with an offset hinge.
//!
//! Source: the two coupled planar bodies of Sreenath, Oh, Krishnaprasad and Marsden (1988); this form is the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{at, solid};
use crate::reduced_mass::reduced_mass;
use crate::rotation::{about_z, lifted, quarter_turn};

pub const FORMULA: Formula = Formula {
    source: "two coupled planar bodies, Sreenath, Oh, Krishnaprasad, Marsden (1988); this form is the project's own",
    connection: "a = (I₁ + ε r·Rd)/(I₀ + I₁ + ε|r|²), r = p − c₀ + Rd, R = R_z(q); A_v = c × A_ω + J_c, c = c₀ + (m₁/M) r",
    curvature: "0: one coordinate",
};

const BASE: InertialDescription = solid(2.0, [0.25, -0.125, 0.0], [0.25, 0.375, 0.5], [0.0, 0.0, 0.0]);
const LINK_1: InertialDescription = solid(1.0, [0.5, 0.25, 0.0], [0.125, 0.1875, 0.25], [0.0, 0.0, 0.0]);

/// The hinge p in the base, m.
const HINGE: Vector3<f64> = Vector3::new(0.75, 0.25, 0.0);

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let [base, link] = [BASE, LINK_1].map(|body| T::from_f64(body.inertia.zz));
    let epsilon = reduced_mass::<T>(BASE.mass, LINK_1.mass);
    let share = T::from_f64(LINK_1.mass) / T::from_f64(BASE.mass + LINK_1.mass);
    let turned = about_z(q[0]) * lifted::<T>(LINK_1.com);
    let r = lifted::<T>(HINGE - BASE.com) + turned;
    let turn = (link + epsilon * r.dot(&turned)) / (base + link + epsilon * r.dot(&r));
    Values::planar(&[turn], lifted::<T>(BASE.com) + r * share, &[quarter_turn(turned) * share], &[])
}

/// The robot of `robots/oracles/p4.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("p4");
    robot.link("base", BASE);
    robot.link("link_1", LINK_1);
    robot.joint("joint_1", JointKind::Continuous, "base", "link_1").origin(at([0.75, 0.25, 0.0])).axis(0.0, 0.0, 1.0);
    robot
}
