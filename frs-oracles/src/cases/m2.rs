//! M2, a satellite with a yaw-pitch arm and any mass distribution.
//!
//! Source: the project's own: `𝓑_ω = ∂₁A₂ − ∂₂A₁ − A₁ × A₂` of A = K⁻¹h, every derivative written out.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::{Matrix3, Vector3};

use super::Formula;
use crate::Values;
use crate::adjugate::inverse;
use crate::description::{at, solid};
use crate::rotation::{about_y, about_z, lifted, polar};

pub const FORMULA: Formula = Formula {
    source: "the project's own: the definition with every derivative written out",
    connection: "A_ω,i = K⁻¹h_i, h_i = Σ(J_kω_k,i + m_k y_k × x_k,i), K = Σ(J_k + m_k(|y_k|²1 − y_k y_kᵀ)); A_v = c × A_ω + J_c",
    curvature: "𝓑_ω = K⁻¹(∂₁h₂ − ∂₂h₁ − (∂₁K)A₂ + (∂₂K)A₁) − A₁ × A₂; 𝓑_v = c × 𝓑_ω",
};

const BASE: InertialDescription = solid(4.0, [0.125, -0.0625, 0.125], [1.0, 1.25, 1.5], [0.125, -0.0625, 0.0625]);
const TURRET: InertialDescription =
    solid(1.0, [0.0625, 0.125, 0.25], [0.125, 0.1875, 0.25], [0.015625, 0.03125, -0.015625]);
const ARM: InertialDescription =
    solid(0.75, [0.5, 0.125, -0.0625], [0.125, 0.25, 0.3125], [0.03125, 0.015625, -0.03125]);

/// The yaw joint in the base and the pitch joint in the turret, m.
const HINGES: [Vector3<f64>; 2] = [Vector3::new(0.25, 0.125, 0.5), Vector3::new(0.25, -0.125, 0.375)];

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let yaw = about_z(q[0]);
    let turns = [Matrix3::identity(), yaw, yaw * about_y(q[1])];
    let axes: [Vector3<T>; 2] = [Vector3::z(), yaw * Vector3::y()];
    let first = lifted::<T>(HINGES[0]);
    let hinges = [first, first + yaw * lifted::<T>(HINGES[1])];
    let origins = [Vector3::zeros(), hinges[0], hinges[1]];

    let bodies = [BASE, TURRET, ARM];
    let mass = bodies.map(|body| T::from_f64(body.mass));
    let total = mass[0] + mass[1] + mass[2];
    let inertia: [Matrix3<T>; 3] =
        std::array::from_fn(|k| turns[k] * bodies[k].inertia.to_matrix().map(T::from_f64) * turns[k].transpose());
    let place: [Vector3<T>; 3] = std::array::from_fn(|k| origins[k] + turns[k] * lifted::<T>(bodies[k].com));
    let weighed = |x: [Vector3<T>; 3]| (x[0] * mass[0] + x[1] * mass[1] + x[2] * mass[2]) / total;
    let com = weighed(place);
    let y = place.map(|x| x - com);

    // Joint i moves body k where i < k: rates of orientation, of centres of mass, and of the common one.
    let spin = |k: usize, i: usize| if i < k { axes[i] } else { Vector3::zeros() };
    let slide = |k: usize, i: usize| spin(k, i).cross(&(place[k] - hinges[i]));
    let com_rate = [0, 1].map(|i| weighed(std::array::from_fn(|k| slide(k, i))));
    let drift = |k: usize, i: usize| slide(k, i) - com_rate[i];
    let sum = |term: &dyn Fn(usize) -> Vector3<T>| term(0) + term(1) + term(2);
    // (ω× J − J ω×) w
    let turned =
        |k: usize, i: usize, w: Vector3<T>| spin(k, i).cross(&(inertia[k] * w)) - inertia[k] * spin(k, i).cross(&w);

    let mut locked = Matrix3::zeros();
    for k in 0..3 {
        locked += inertia[k] + polar(y[k], y[k]) * mass[k];
    }
    let solve = inverse(&locked);
    let connection = [0, 1].map(|i| solve * sum(&|k| inertia[k] * spin(k, i) + y[k].cross(&slide(k, i)) * mass[k]));
    let locked_rate = |i: usize, w: Vector3<T>| {
        sum(&|k| turned(k, i, w) + (polar(y[k], drift(k, i)) + polar(drift(k, i), y[k])) * w * mass[k])
    };
    let acceleration = y[2].cross(&axes[0].cross(&slide(2, 1))) * mass[2];
    let rate_of_second = turned(2, 0, axes[1])
        + inertia[2] * axes[0].cross(&axes[1])
        + drift(2, 0).cross(&slide(2, 1)) * mass[2]
        + acceleration;
    let rate_of_first = turned(2, 1, axes[0]) + sum(&|k| drift(k, 1).cross(&slide(k, 0)) * mass[k]) + acceleration;
    let curvature = solve
        * (rate_of_second - rate_of_first - locked_rate(0, connection[1]) + locked_rate(1, connection[0]))
        - connection[0].cross(&connection[1]);
    Values::turning(&connection, com, &com_rate, &[curvature])
}

/// The robot of `robots/oracles/m2.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("m2");
    robot.link("base", BASE);
    robot.link("turret", TURRET);
    robot.link("arm", ARM);
    robot.joint("yaw", JointKind::Continuous, "base", "turret").origin(at([0.25, 0.125, 0.5])).axis(0.0, 0.0, 1.0);
    robot.joint("pitch", JointKind::Continuous, "turret", "arm").origin(at([0.25, -0.125, 0.375])).axis(0.0, 1.0, 0.0);
    robot
}
