//! M1, a satellite with a yaw-pitch arm, the base symmetric about the yaw axis.
//!
//! Source: the project's own. All centres of mass lie in a plane that turns with the yaw.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{at, solid};
use crate::plane::{InPlane, PlaneInertia};
use crate::rotation::{about_z, quarter_turn};

pub const FORMULA: Formula = Formula {
    source: "the project's own",
    connection: "A_ω = R_z(q₁)[z − C₀K⁻¹z, ηy], η = (I_2y + ½m₂(x₂cos q₂ − z₂sin q₂))/K_yy, C₀ the base's inertia about z; A_v = c × A_ω + J_c",
    curvature: "𝓑_ω = C₀R_z(q₁)(u′ − ηw, 0, w′ + ηu), (u, w) = K⁻¹z; 𝓑_v = c × 𝓑_ω",
};

const BASE: InertialDescription = solid(4.0, [0.0, 0.0, 0.125], [1.0, 1.0, 1.25], [0.0, 0.0, 0.0]);
const TURRET: InertialDescription = solid(1.0, [0.0, 0.0, 0.25], [0.125, 0.1875, 0.25], [0.0, 0.0, 0.0]);
const ARM: InertialDescription = solid(0.75, [0.5, 0.0, 0.0], [0.09375, 0.25, 0.3125], [0.0, 0.0, 0.0]);

/// Height of the turret's centre of mass in the base, m.
const TURRET_HEIGHT: f64 = 0.75;
/// Height of the pitch axis in the base, and its distance from the yaw axis, m.
const PITCH: [f64; 2] = [0.875, 0.25];

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let real = T::from_f64;
    let (two, zero) = (real(2.0), T::zero());
    let (turn, (s, c)) = (about_z(q[0]), q[1].sin_cos());
    let [base, turret, arm] = [BASE, TURRET, ARM].map(|body| body.inertia);
    let masses = [BASE, TURRET, ARM].map(|body| real(body.mass));
    let (axial, [m0, m1, m2]) = (real(base.zz), masses);
    let length = real(ARM.com.x);

    // Centres of mass in the plane, then from the common one.
    let (x, z) = (real(PITCH[1]) + length * c, real(PITCH[0]) - length * s);
    let (x_rate, z_rate) = (-(length * s), -(length * c));
    let heights = [real(BASE.com.z), real(TURRET_HEIGHT), z];
    let total = m0 + m1 + m2;
    let [com_x, com_z] = [m2 * x / total, (m0 * heights[0] + m1 * heights[1] + m2 * heights[2]) / total];
    let arms = [[-com_x, heights[0] - com_z], [-com_x, heights[1] - com_z], [x - com_x, heights[2] - com_z]];
    let second =
        |a: usize, b: usize| masses.iter().zip(&arms).fold(zero, |sum, (&mass, arm)| sum + mass * arm[a] * arm[b]);
    let [x2, z2] = arms[2];
    let (xx, zz) = (real(arm.xx), real(arm.zz));
    let locked = PlaneInertia {
        xx: [
            real(base.xx + turret.xx) + xx * c * c + zz * s * s + second(1, 1),
            two * (zz - xx) * s * c + two * m2 * z2 * z_rate,
        ],
        xz: [-((xx - zz) * s * c) - second(0, 1), (zz - xx) * (c * c - s * s) - m2 * (x_rate * z2 + x2 * z_rate)],
        zz: [
            axial + real(turret.zz) + xx * s * s + zz * c * c + second(0, 0),
            two * (xx - zz) * s * c + two * m2 * x2 * x_rate,
        ],
    };
    let about_y = real(base.yy + turret.yy + arm.yy) + second(0, 0) + second(1, 1);
    let eta = (real(arm.yy) + m2 * length * (x2 * c - z2 * s)) / about_y;
    let turned = locked.solve(InPlane::z());

    let com = turn * Vector3::new(com_x, zero, com_z);
    let pitched = turn * Vector3::new(x_rate, zero, z_rate) * (m2 / total);
    Values::turning(
        &[Vector3::z() - turn * turned.vector() * axial, turn * Vector3::y() * eta],
        com,
        &[quarter_turn(com), pitched],
        &[turn * turned.turned_rate(eta) * axial],
    )
}

/// The robot of `robots/oracles/m1.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("m1");
    robot.link("base", BASE);
    robot.link("turret", TURRET);
    robot.link("arm", ARM);
    robot.joint("yaw", JointKind::Continuous, "base", "turret").origin(at([0.0, 0.0, 0.5])).axis(0.0, 0.0, 1.0);
    robot.joint("pitch", JointKind::Continuous, "turret", "arm").origin(at([0.25, 0.0, 0.375])).axis(0.0, 1.0, 0.0);
    robot
}
