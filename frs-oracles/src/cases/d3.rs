//! D3, two masses, each on its own gantry of three rails: the connection of a deformable body.
//!
//! Source: the gauge kinematics of deformable bodies, Guichardet (1984), Shapere and Wilczek (1989), Littlejohn and Reinsch
//! (1997); the closed form is the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::description::{gantry, solid};
use crate::point_masses::PointMasses;
use crate::reduced_mass::reduced_masses;
use crate::rotation::lifted;

pub const FORMULA: Formula = Formula {
    source: "deformable bodies, Guichardet (1984), Shapere, Wilczek (1989), Littlejohn, Reinsch (1997); this form is the project's own",
    connection: "A_(a,i) = K⁻¹(g_a × e_i), g_a = Σ_b μ_ab r_b, K = ΣI + Σ_ab μ_ab((r_a·r_b)1 − r_a r_bᵀ); A_v = c × A_ω + (m_a/M) e_i",
    curvature: "𝓑_(a,i)(b,j) = K⁻¹(2μ_ab e_i × e_j − (∂_(a,i)K)A_(b,j) + (∂_(b,j)K)A_(a,i)) − A_(a,i) × A_(b,j)",
};

const BASE: InertialDescription = solid(2.0, [0.0, 0.0, 0.0], [0.5, 0.75, 1.0], [0.0625, -0.125, 0.03125]);
const MASS_A: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.0625, 0.0625, 0.0625], [0.0, 0.0, 0.0]);
const MASS_B: InertialDescription = solid(0.75, [0.0, 0.0, 0.0], [0.03125, 0.03125, 0.03125], [0.0, 0.0, 0.0]);

/// Where the masses stand at q = 0, m.
const PLACES: [Vector3<f64>; 2] = [Vector3::new(0.25, -0.5, 0.125), Vector3::new(-0.5, 0.25, 0.75)];

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let masses = [MASS_A.mass, MASS_B.mass];
    let total = BASE.mass + masses.iter().sum::<f64>();
    let at = |a: usize| lifted::<T>(PLACES[a] - BASE.com) + Vector3::from_fn(|i, _| q[3 * a + i]);
    let masses_on_gantries = PointMasses {
        base_com: lifted(BASE.com),
        inertia: (BASE.inertia + MASS_A.inertia + MASS_B.inertia).to_matrix().map(T::from_f64),
        reduced: reduced_masses(BASE.mass, masses),
        share: masses.map(|mass| T::from_f64(mass) / T::from_f64(total)),
        position: [at(0), at(1)],
    };
    let coordinates: [_; 6] = std::array::from_fn(|k| (k / 3, Vector3::ith(k % 3, T::one())));
    masses_on_gantries.values(&coordinates)
}

/// The robot of `robots/oracles/d3.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("d3");
    robot.link("base", BASE);
    gantry(&mut robot, "_a", PLACES[0], MASS_A);
    gantry(&mut robot, "_b", PLACES[1], MASS_B);
    robot
}
