//! S0, a rotor and a slider on one line: both columns differ from zero, and the connection is exactly flat.
//!
//! Source: the project's own. A turn about a line and a slide along it commute.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{RAIL, at, solid};

pub const FORMULA: Formula = Formula {
    source: "a turn about a line and a slide along it commute",
    connection: "A₁ = (j/λ)(1, 0, 0, 0, 0, 0), λ = ΣI_xx; A₂ = (m₂/M)(0, 0, 0, 1, 0, 0)",
    curvature: "0",
};

const BASE: InertialDescription = solid(2.0, [0.0, 0.0, 0.0], [0.25, 0.375, 0.5], [0.0, 0.0, 0.0]);
const ROTOR: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.125, 0.09375, 0.09375], [0.0, 0.0, 0.0]);
const SLIDER: InertialDescription = solid(0.5, [0.0, 0.0, 0.0], [0.0625, 0.0625, 0.0625], [0.0, 0.0, 0.0]);

/// Where the rotor and the slider stand on the line at q = 0, m.
const PLACES: [f64; 2] = [-0.25, 0.5];

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let real = T::from_f64;
    let axial = real(BASE.inertia.xx + ROTOR.inertia.xx + SLIDER.inertia.xx);
    let total = real(BASE.mass + ROTOR.mass + SLIDER.mass);
    let [w1, w2] = [ROTOR, SLIDER].map(|body| real(body.mass) / total);
    let [rotor, slider] = PLACES.map(real);
    Values::turning(
        &[Vector3::x() * (real(ROTOR.inertia.xx) / axial), Vector3::zeros()],
        Vector3::x() * (w1 * rotor + w2 * (slider + q[1])),
        &[Vector3::zeros(), Vector3::x() * w2],
        &[Vector3::zeros()],
    )
}

/// The robot of `robots/oracles/s0.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("s0");
    robot.link("base", BASE);
    robot.link("rotor", ROTOR);
    robot.link("slider", SLIDER);
    robot.joint("joint_1", JointKind::Continuous, "base", "rotor").origin(at([-0.25, 0.0, 0.0])).axis(1.0, 0.0, 0.0);
    robot
        .joint("joint_2", JointKind::Prismatic, "base", "slider")
        .origin(at([0.5, 0.0, 0.0]))
        .axis(1.0, 0.0, 0.0)
        .limits(RAIL);
    robot
}
