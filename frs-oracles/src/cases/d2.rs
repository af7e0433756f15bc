//! D2, one mass on a gantry of three rails, any base inertia.
//!
//! Source: the project's own.

use frs_core::Real;
use frs_core::model::{InertialDescription, RobotDescription};
use nalgebra::Vector3;

use super::Formula;
use crate::Values;
use crate::adjugate::{determinant, inverse};
use crate::description::{gantry, solid};
use crate::reduced_mass::reduced_mass;
use crate::rotation::{lifted, polar};

pub const FORMULA: Formula = Formula {
    source: "the project's own",
    connection: "A_ω,i = εK⁻¹(r × e_i), K = I₀ + ε(|r|²1 − rrᵀ), r = r₀ + q − c₀; A_v = c × A_ω + (m/M) e_i, c = c₀ + (m/M) r",
    curvature: "𝓑_ω(e_i, e_j) = K⁻¹(2εn − (∂_iK)A_j + (∂_jK)A_i) − (ε²(r·n)/det K) I₀r, (∂_iK)w = ε(2r_i w − e_i(r·w) − r w_i), n = e_i × e_j",
};

const BASE: InertialDescription = solid(2.0, [0.125, 0.0, -0.25], [0.5, 0.75, 1.0], [0.0625, -0.125, 0.03125]);
const MASS: InertialDescription = solid(1.0, [0.0, 0.0, 0.0], [0.0625, 0.0625, 0.0625], [0.0, 0.0, 0.0]);

/// Where the mass stands at q = 0, m.
const PLACE: Vector3<f64> = Vector3::new(0.25, -0.5, 0.125);

pub fn values<T: Real>(q: &[T]) -> Values<T> {
    let epsilon = reduced_mass::<T>(BASE.mass, MASS.mass);
    let share = T::from_f64(MASS.mass) / T::from_f64(BASE.mass + MASS.mass);
    let r = lifted::<T>(PLACE - BASE.com) + Vector3::new(q[0], q[1], q[2]);
    let inertia = (BASE.inertia + MASS.inertia).to_matrix().map(T::from_f64);
    let locked = inertia + polar(r, r) * epsilon;
    let (solve, determinant) = (inverse(&locked), determinant(&locked));
    let axes: [Vector3<T>; 3] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let turns = axes.map(|e| solve * r.cross(&e) * epsilon);
    let locked_rate = |i: usize, w: Vector3<T>| (w * (r[i] + r[i]) - axes[i] * r.dot(&w) - r * w[i]) * epsilon;
    let field = |(i, j): (usize, usize)| {
        let n = axes[i].cross(&axes[j]);
        solve * (n * (epsilon + epsilon) - locked_rate(i, turns[j]) + locked_rate(j, turns[i]))
            - inertia * r * (epsilon * epsilon * r.dot(&n) / determinant)
    };
    let curvature: Vec<_> = Values::<T>::pairs(3).map(field).collect();
    Values::turning(&turns, lifted::<T>(BASE.com) + r * share, &axes.map(|e| e * share), &curvature)
}

/// The robot of `robots/oracles/d2.urdf`, built in code.
pub fn robot() -> RobotDescription {
    let mut robot = RobotDescription::new("d2");
    robot.link("base", BASE);
    gantry(&mut robot, "", PLACE, MASS);
    robot
}
