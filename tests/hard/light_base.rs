//! A base from 10⁻¹² to 10¹² of its own mass.
//!
//! As the base gets lighter, a joint near it moves less and less mass against it: Λ_q loses a digit for each digit of the ratio
//! where it is formed as a difference. Here nothing is: every entry is as good as rounding allows, in the scale of its own joints.

use frs::{Model, urdf};

use crate::judge::{Judged, judge_all};
use crate::robots::{chain, scaled, turned};

/// Asked of Λ_q relative to √(Λ_ii Λ_jj), and of what else the base enters relative to its natural scale.
const ASKED: f64 = 1e-14;

/// What the last link's lever arm costs: its radius of inertia about its own axis is 2.04 cm, and moments are taken about the
/// centre of mass, which is up to 0.92 m away. Its inertia is the difference of terms (0.92/0.0204)² times as large.
const LEVER: f64 = 2.1e3;

/// Of Λ_q by the usual difference where the base has 10⁻¹² of its mass: the digits of the ratio, but for two that the first joint
/// keeps by its own inertia.
const TEXTBOOK: f64 = 1e-4;

/// Shapes a ratio.
const SHAPES: u64 = 20;

fn judged(name: &str, model: &Model, base: &str, power: i32) -> Judged {
    let model = scaled(model, base, 10.0_f64.powi(power));
    judge_all(&format!("{name}, base times 1e{power}"), &model, (0..SHAPES).map(|seed| turned(&model, seed, 3.0)))
}

fn arm() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).expect("the robot is well formed")
}

#[test]
fn a_light_base_costs_no_digits_but_those_of_lever_arms() {
    for power in (-12..=12).step_by(3) {
        let worst = judged("arm", &arm(), "base", power);
        assert!(worst.leverless * f64::EPSILON <= ASKED, "base times 1e{power}: {worst}");
        assert!(worst.lever <= LEVER, "base times 1e{power}: {worst}");
        assert!(power > -12 || worst.textbook * f64::EPSILON >= TEXTBOOK, "{worst}");
    }
}

/// What the mass of the base enters: Λ_q, B_2, Γ' (a block of D_q̇) and the coupling torque.
const OF_THE_BASE: [&str; 4] = ["shape_inertia", "b2", "d_qdot", "coupling_torque"];

/// Three bars, which are as long as they are far from the centre of mass.
#[test]
fn without_lever_arms_a_light_base_costs_no_digits() {
    for power in (-12..=12).step_by(3) {
        let worst = judged("three bars", &chain(3), "link_0", power);
        for output in OF_THE_BASE {
            assert!(worst.errors[output] * f64::EPSILON <= ASKED, "base times 1e{power}, {output}: {worst}");
        }
    }
}

/// The articulated sweep loses what the usual difference loses: a joint next to a light base gives way before the base is met.
#[test]
fn accelerations_by_factoring_keep_what_the_articulated_sweep_loses() {
    let worst = judged("accelerations", &arm(), "base", -12);
    assert!(worst.errors["xi_dot, factored"] * f64::EPSILON <= ASKED * worst.lever, "{worst}");
    assert!(worst.errors["xi_dot"] * f64::EPSILON >= TEXTBOOK, "{worst}");
}
