//! D5, three rails in three directions, one slider on each: D3's formula, and no link without mass.
//!
//! Source: the project's own; robots of this kind are in Shen and McClamroch (2002).

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{RAIL, at, solid};
use crate::point_masses::PointMasses;
use crate::reduced_mass::reduced_masses;
use crate::rotation::lifted;

pub const FORMULA: Formula = Formula {
    source: "D3 with one direction for each body; robots of this kind are in Shen, McClamroch (2002)",
    connection: "A_ω,k = K⁻¹(g_k × e_k), g_k = Σ_l μ_kl r_l, K = ΣI + Σ_kl μ_kl((r_k·r_l)1 − r_k r_lᵀ); A_v = c × A_ω + (m_k/M) e_k",
    curvature: "𝓑_ω(e_k, e_l) = K⁻¹(2μ_kl e_k × e_l − (∂_kK)A_l + (∂_lK)A_k) − A_k × A_l; 𝓑_v = c × 𝓑_ω",
};

const BASE: InertialDescription = solid(2.0, [0.0625, -0.125, 0.1875], [0.5, 0.75, 1.0], [0.0625, -0.125, 0.03125]);
const SLIDER_1: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.0625, 0.0625, 0.0625], [0.0, 0.0, 0.0]);
const SLIDER_2: InertialDescription = solid(0.75, [0.0, 0.0, 0.0], [0.03125, 0.046875, 0.0625], [0.0, 0.0, 0.0]);
const SLIDER_3: InertialDescription = solid(0.5, [0.0, 0.0, 0.0], [0.046875, 0.03125, 0.03125], [0.0, 0.0, 0.0]);

/// Where the sliders stand at q = 0, m.
const PLACES: [Vector3<f64>; 3] =
    [Vector3::new(0.25, -0.5, 0.125), Vector3::new(-0.5, 0.25, 0.75), Vector3::new(0.375, 0.5, -0.25)];

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let sliders = [SLIDER_1, SLIDER_2, SLIDER_3];
    let masses = sliders.map(|slider| slider.mass);
    let total = BASE.mass + masses.iter().sum::<f64>();
    let inertia = sliders.iter().fold(BASE.inertia, |sum, slider| sum + slider.inertia);
    let masses_on_rails = PointMasses {
        base_com: lifted(BASE.com),
        inertia: inertia.to_matrix().map(T::from_f64),
        reduced: reduced_masses(BASE.mass, masses),
        share: masses.map(|mass| T::from_f64(mass) / T::from_f64(total)),
        position: std::array::from_fn(|k| lifted::<T>(PLACES[k] - BASE.com) + Vector3::ith(k, q[k])),
    };
    let coordinates: [_; 3] = std::array::from_fn(|k| (k, Vector3::ith(k, T::one())));
    masses_on_rails.values(&coordinates)
}

/// The robot of `robots/oracles/d5.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("d5");
    robot.link("base", BASE);
    robot.link("slider_1", SLIDER_1);
    robot.link("slider_2", SLIDER_2);
    robot.link("slider_3", SLIDER_3);
    robot
        .joint("joint_1", JointKind::Prismatic, "base", "slider_1")
        .origin(at([0.25, -0.5, 0.125]))
        .axis(1.0, 0.0, 0.0)
        .limits(RAIL);
    robot
        .joint("joint_2", JointKind::Prismatic, "base", "slider_2")
        .origin(at([-0.5, 0.25, 0.75]))
        .axis(0.0, 1.0, 0.0)
        .limits(RAIL);
    robot
        .joint("joint_3", JointKind::Prismatic, "base", "slider_3")
        .origin(at([0.375, 0.5, -0.25]))
        .axis(0.0, 0.0, 1.0)
        .limits(RAIL);
    robot
}
