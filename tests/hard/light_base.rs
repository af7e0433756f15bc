//! A base from 10⁻¹² to 10¹² of its own mass.
//!
//! As the base gets lighter, a joint near it moves less and less mass against it: Λ_q loses a digit for each digit of the ratio
//! where it is formed as a difference. Here nothing is: every entry is as good as rounding allows, in the scale of its own joints.

use frs::{Model, urdf};

use crate::judge::judge_all;
use crate::robots::{scaled, turned};

/// Asked of every quantity relative to its natural scale. Moments are taken about the total centre of mass, at about
/// a metre from the last link, whose radius of inertia about its own joint is 2.6 cm: its inertia is the difference of terms 1,500
/// times as large, and each of them is rounded a few times.
const QUANTITY: f64 = 1e-12;

/// Of Λ_q by the usual difference where the base has 10⁻¹² of its mass: the digits of the ratio, but for two that the first joint
/// keeps by its own inertia.
const TEXTBOOK: f64 = 1e-4;

/// Shapes a ratio.
const SHAPES: u64 = 20;

fn robot(ratio: f64) -> Model {
    let model = Model::from_urdf(urdf::LWR_SATELLITE).expect("the robot is well formed");
    scaled(&model, "base", ratio)
}

#[test]
fn a_light_base_costs_no_digits() {
    for power in (-12..=12).step_by(3) {
        let model = robot(10.0_f64.powi(power));
        let worst = judge_all(&format!("base times 1e{power}"), &model, (0..SHAPES).map(|seed| turned(&model, seed, 3.0)));
        assert!(worst.worst() * f64::EPSILON <= QUANTITY, "base times 1e{power}: {worst}");
        assert!(power > -12 || worst.textbook * f64::EPSILON >= TEXTBOOK, "{worst}");
    }
}

/// The articulated sweep loses what the usual difference loses: a joint next to a light base gives way before the base is met.
#[test]
fn accelerations_by_factoring_keep_what_the_articulated_sweep_loses() {
    let model = robot(1e-12);
    let worst = judge_all("light base, accelerations", &model, (0..SHAPES).map(|seed| turned(&model, seed, 3.0)));
    assert!(worst.errors["xi_dot, factored"] * f64::EPSILON <= QUANTITY, "{worst}");
    assert!(worst.errors["xi_dot"] * f64::EPSILON >= TEXTBOOK, "{worst}");
}
