//! P6, the planar skater: three equal uniform rods, the middle one as base.
//!
//! Source: the floating snake of Hatton and Choset (2011), also Mem. AMS 436 (1990), §1D; the form of F is the project's
//! own. Neither mass nor length of the rods enters the turns.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};

use super::Formula;
use crate::Values;
use crate::description::{at, solid};
use crate::rotation::{direction, quarter_turn};

pub const FORMULA: Formula = Formula {
    source: "floating snake, Hatton, Choset (2011) and Mem. AMS 436 (1990), §1D; the form of F is the project's own",
    connection: "a_i = P_i/D, P_i = 3 + 3 cos q_i + cos(q₂ − q₁), D = 13 + 6(cos q₁ + cos q₂) + 2 cos(q₂ − q₁); c = (e(q₂) − e(q₁))/6",
    curvature: "𝓑 = F (0, 0, 1, c_y, −c_x, 0), F = (2/D²)(3 sin q₁ P₂ + sin(q₂ − q₁) P₀ − 3 sin q₂ P₁), P₀ = 7 + 3(cos q₁ + cos q₂)",
};

const BASE: InertialDescription = solid(1.5, [0.0, 0.0, 0.0], [0.0625, 0.125, 0.125], [0.0, 0.0, 0.0]);
const LEFT: InertialDescription = solid(1.5, [-0.5, 0.0, 0.0], [0.0625, 0.125, 0.125], [0.0, 0.0, 0.0]);
const RIGHT: InertialDescription = solid(1.5, [0.5, 0.0, 0.0], [0.0625, 0.125, 0.125], [0.0, 0.0, 0.0]);

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let real = T::from_f64;
    let (two, three) = (real(2.0), real(3.0));
    let [(sin1, cos1), (sin2, cos2), (sin, cos)] = [q[0], q[1], q[1] - q[0]].map(Real::sin_cos);
    let p0 = real(7.0) + three * (cos1 + cos2);
    let p1 = three + three * cos1 + cos;
    let p2 = three + three * cos2 + cos;
    let d = p0 + p1 + p2;
    let f = two * (three * sin1 * p2 + sin * p0 - three * sin2 * p1) / (d * d);
    let [left, right] = [direction(q[0]) / real(-6.0), direction(q[1]) / real(6.0)];
    Values::planar(&[p1 / d, p2 / d], left + right, &[quarter_turn(left), quarter_turn(right)], &[f])
}

/// The robot of `robots/oracles/p6.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("p6");
    robot.link("base", BASE);
    robot.link("left", LEFT);
    robot.link("right", RIGHT);
    robot.joint("joint_1", JointKind::Continuous, "base", "left").origin(at([-0.5, 0.0, 0.0])).axis(0.0, 0.0, 1.0);
    robot.joint("joint_2", JointKind::Continuous, "base", "right").origin(at([0.5, 0.0, 0.0])).axis(0.0, 0.0, 1.0);
    robot
}
