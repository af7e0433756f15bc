//! P7, a planar chain of four links, by the formula for any planar tree of revolute joints.
//!
//! Source: the project's own. Link a stands at `x_a = Σ_i L_ai e(θ_i)` from the base's centre of mass.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{at, solid};
use crate::reduced_mass::reduced_masses;
use crate::rotation::{direction, lifted, quarter_turn};

pub const FORMULA: Formula = Formula {
    source: "any planar tree of revolute joints; the project's own",
    connection: "a_k = Σ_{j≥k} P_j/D, C_ij = β_ij cos(θ_j − θ_i) + I_i δ_ij, P_j = Σ_i C_ij, D = Σ_j P_j; A_v = c × A_ω + J_c",
    curvature: "𝓑 = F (0, 0, 1, c_y, −c_x, 0), F_kl = Σ_{i≥k, j≥l, i≠j} (2 s_ij/D − 2(P_j σ_i − P_i σ_j)/D²), s_ij = β_ij sin(θ_j − θ_i), σ_i = Σ_j s_ij",
};

const BASE: InertialDescription = solid(2.0, [0.25, 0.0, 0.0], [0.25, 0.375, 0.5], [0.0, 0.0, 0.0]);
const LINK_1: InertialDescription = solid(1.0, [0.375, 0.0, 0.0], [0.125, 0.1875, 0.25], [0.0, 0.0, 0.0]);
const LINK_2: InertialDescription = solid(0.75, [0.5, 0.0, 0.0], [0.0625, 0.09375, 0.125], [0.0, 0.0, 0.0]);
const LINK_3: InertialDescription = solid(0.5, [0.25, 0.0, 0.0], [0.03125, 0.0625, 0.0625], [0.0, 0.0, 0.0]);

/// L_ai, m: how far link a stands along each link of the chain, the base first.
const LEVERS: [[f64; 4]; 3] = [[0.5, 0.375, 0.0, 0.0], [0.5, 0.875, 0.5, 0.0], [0.5, 0.875, 0.75, 0.25]];

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let (zero, two) = (T::zero(), T::from_f64(2.0));
    let links = [LINK_1, LINK_2, LINK_3];
    let masses = links.map(|link| link.mass);
    let mu = reduced_masses::<T, 3>(BASE.mass, masses);
    let levers = LEVERS.map(|row| row.map(T::from_f64));
    let inertia = [BASE, LINK_1, LINK_2, LINK_3].map(|body| T::from_f64(body.inertia.zz));
    let theta = [zero, q[0], q[0] + q[1], q[0] + q[1] + q[2]];

    let sum = |terms: &mut dyn Iterator<Item = T>| terms.fold(zero, |sum, term| sum + term);
    let all = || (0..3).flat_map(|a| (0..3).map(move |b| (a, b)));
    let beta = |i: usize, j: usize| sum(&mut all().map(|(a, b)| mu[a][b] * levers[a][i] * levers[b][j]));
    let s = |i: usize, j: usize| beta(i, j) * (theta[j] - theta[i]).sin_cos().0;
    let p = |j: usize| inertia[j] + sum(&mut (0..4).map(|i| beta(i, j) * (theta[j] - theta[i]).sin_cos().1));
    let p: [T; 4] = std::array::from_fn(p);
    let sigma: [T; 4] = std::array::from_fn(|i| sum(&mut (0..4).map(|j| s(i, j))));
    let d = sum(&mut p.into_iter());

    let turns: [T; 3] = std::array::from_fn(|k| sum(&mut (k + 1..4).map(|j| p[j])) / d);
    let field = |(k, l): (usize, usize)| {
        let moved = (k + 1..4).flat_map(|i| (l + 1..4).map(move |j| (i, j))).filter(|(i, j)| i != j);
        sum(&mut moved.map(|(i, j)| two * s(i, j) / d - two * (p[j] * sigma[i] - p[i] * sigma[j]) / (d * d)))
    };
    let total = T::from_f64(BASE.mass + masses.iter().sum::<f64>());
    // What each link of the chain, turned to its angle, contributes to the centre of mass.
    let parts: [Vector3<T>; 4] = std::array::from_fn(|i| {
        direction(theta[i]) * (sum(&mut (0..3).map(|a| T::from_f64(masses[a]) * levers[a][i])) / total)
    });
    let beyond = |k: usize| parts[k..].iter().fold(Vector3::zeros(), |sum, part| sum + part);
    Values::planar(
        &turns,
        lifted::<T>(BASE.com) + beyond(0),
        &[1, 2, 3].map(|k| quarter_turn(beyond(k))),
        &Values::<T>::pairs(3).map(field).collect::<Vec<_>>(),
    )
}

/// The robot of `robots/oracles/p7.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("p7");
    robot.link("base", BASE);
    robot.link("link_1", LINK_1);
    robot.link("link_2", LINK_2);
    robot.link("link_3", LINK_3);
    robot.joint("joint_1", JointKind::Continuous, "base", "link_1").origin(at([0.75, 0.0, 0.0])).axis(0.0, 0.0, 1.0);
    robot.joint("joint_2", JointKind::Continuous, "link_1", "link_2").origin(at([0.875, 0.0, 0.0])).axis(0.0, 0.0, 1.0);
    robot.joint("joint_3", JointKind::Continuous, "link_2", "link_3").origin(at([0.75, 0.0, 0.0])).axis(0.0, 0.0, 1.0);
    robot
}
