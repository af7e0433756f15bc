//! A joint about the axis of a needle, from 10 cm to 10 μm thick; a thinner one is refused.
//!
//! What the joint moves vanishes with the square of the thickness, and Λ_q becomes singular. The needle's own inertia is the
//! difference of terms that are as large as the other joints' inertias, so what is lost is the condition number of Λ_q, and not more.

use frs::conditioning::roundings;

use crate::judge::judge_all;
use crate::robots::{built, needle, turned};

const SHAPES: u64 = 20;

#[test]
fn a_needle_costs_at_most_the_condition_of_the_shape_inertia() {
    for power in -5..=-1 {
        let model = built(needle(10.0_f64.powi(power)));
        let states = (0..SHAPES).map(|seed| turned(&model, seed, 3.0));
        let worst = judge_all(&format!("needle of 1e{power} m"), &model, states);
        let allowed = roundings(model.joints()) * worst.plain_condition;
        for output in ["shape_inertia", "xi_dot", "xi_dot, factored"] {
            assert!(worst.errors[output] <= allowed, "1e{power} m, {output}: {worst}");
        }
    }
}

#[test]
fn a_needle_of_a_micron_is_refused_by_the_name_of_its_joint() {
    let refusal = needle(1e-6).build().expect_err("nothing resists the joint's motion").to_string();
    assert!(refusal.contains("joint 'joint_3': nothing resists the joint's motion"), "{refusal}");
}
