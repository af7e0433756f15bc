//! P8, a hopper in flight: a leg that turns about the base's centre of mass and a foot that telescopes.
//!
//! Source: the hopper of Li and Montgomery (1990) and of Murray and Sastry (1993) with a floating body; the square cat of
//! Putterman and Raz (2008) is the same function. This form is the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};

use super::Formula;
use crate::Values;
use crate::description::{RAIL, at, solid};
use crate::reduced_mass::reduced_mass;
use crate::rotation::{direction, quarter_turn};

pub const FORMULA: Formula = Formula {
    source: "hopper of Li, Montgomery (1990) and Murray, Sastry (1993), floating; square cat of Putterman, Raz (2008)",
    connection: "a₁ = (J + εr²)/D, a₂ = 0, D = I₀ + J + εr², r = ¼ + q₂, J = I_leg + I_foot; c = (m_f/M) r e(q₁)",
    curvature: "𝓑 = F (0, 0, 1, c_y, −c_x, 0), F = −2εrI₀/D²",
};

const BASE: InertialDescription = solid(2.0, [0.0, 0.0, 0.0], [0.25, 0.375, 0.5], [0.0, 0.0, 0.0]);
const LEG: InertialDescription = solid(0.5, [0.0, 0.0, 0.0], [0.0625, 0.125, 0.125], [0.0, 0.0, 0.0]);
const FOOT: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.03125, 0.0625, 0.0625], [0.0, 0.0, 0.0]);

/// From the hip to the foot at q₂ = 0, m.
const LENGTH: f64 = 0.25;

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let real = T::from_f64;
    let (base, both) = (real(BASE.inertia.zz), real(LEG.inertia.zz + FOOT.inertia.zz));
    let epsilon = reduced_mass::<T>(BASE.mass + LEG.mass, FOOT.mass);
    let share = real(FOOT.mass) / real(BASE.mass + LEG.mass + FOOT.mass);
    let r = real(LENGTH) + q[1];
    let turned = both + epsilon * r * r;
    let d = base + turned;
    let along = direction(q[0]) * share;
    Values::planar(
        &[turned / d, T::zero()],
        along * r,
        &[quarter_turn(along) * r, along],
        &[real(-2.0) * epsilon * r * base / (d * d)],
    )
}

/// The robot of `robots/oracles/p8.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("p8");
    robot.link("base", BASE);
    robot.link("leg", LEG);
    robot.link("foot", FOOT);
    robot.joint("joint_1", JointKind::Continuous, "base", "leg").axis(0.0, 0.0, 1.0);
    robot
        .joint("joint_2", JointKind::Prismatic, "leg", "foot")
        .origin(at([0.25, 0.0, 0.0]))
        .axis(1.0, 0.0, 0.0)
        .limits(RAIL);
    robot
}
