//! D1, one mass on a gantry of three rails, base with equal principal moments: the field of a smoothed monopole.
//!
//! Source: without the base's inertia the monopole of the three-body problem, Guichardet (1984), Iwai (1987), Littlejohn and
//! Reinsch (1997); with it, the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{gantry, solid};
use crate::monopole::Monopole;
use crate::rotation::lifted;

pub const FORMULA: Formula = Formula {
    source: "monopole of the three-body problem, Guichardet (1984), Iwai (1987), Littlejohn, Reinsch (1997), smoothed by the base",
    connection: "A_ω,i = (ε/κ) r × e_i, κ = I + ε|r|², r = r₀ + q − c₀; A_v = c × A_ω + (m/M) e_i, c = c₀ + (m/M) r",
    curvature: "𝓑_ω(e_i, e_j) = (2εI n + ε²(r·n) r)/κ², n = e_i × e_j; 𝓑_v = c × 𝓑_ω",
};

const BASE: InertialDescription = solid(2.0, [0.125, 0.0, -0.25], [0.5, 0.5, 0.5], [0.0, 0.0, 0.0]);
const MASS: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.0625, 0.0625, 0.0625], [0.0, 0.0, 0.0]);

/// Where the mass stands at q = 0, m.
const PLACE: Vector3<f64> = Vector3::new(0.25, -0.5, 0.125);

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let inertia = BASE.inertia.xx + MASS.inertia.xx;
    let monopole = Monopole { base: BASE.mass, base_com: BASE.com, mass: MASS.mass, inertia };
    let r = lifted::<T>(PLACE - BASE.com) + Vector3::new(q[0], q[1], q[2]);
    monopole.values(r, [Vector3::x(), Vector3::y(), Vector3::z()])
}

/// The robot of `robots/oracles/d1.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("d1");
    robot.link("base", BASE);
    gantry(&mut robot, "", PLACE, MASS);
    robot
}
