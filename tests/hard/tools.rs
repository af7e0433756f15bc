//! Tools of a milligram's thousandth and of a thousand tonnes, point masses and rods.
//!
//! The mass of what a joint moves cancels in the scale of its own entries: what counts is where it is. With a massive tip the
//! centre of mass stands beside it, so that the rounding of the centre of mass, times the mass, would be an impulse that the light
//! links feel; it is taken out (`sweep/position.rs`).

use frs::conditioning::roundings;
use frs::nalgebra::Vector3;
use frs::spatial::Symmetric3;
use frs::{Model, urdf};

use crate::judge::{Judged, judge_all};
use crate::robots::{brick, rods, turned, with_tool};

/// Shapes a robot.
const SHAPES: u64 = 20;

fn judged(name: &str, model: &Model) -> Judged {
    judge_all(name, model, (0..SHAPES).map(|seed| turned(model, seed, 3.0)))
}

#[track_caller]
fn keeps_its_digits(name: &str, model: &Model) {
    let worst = judged(name, model);
    assert!(worst.leverless <= roundings(model.joints()), "{name}: {worst}");
}

fn arm() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).expect("the robot is well formed")
}

#[test]
fn a_featherweight_tool_is_as_accurate_as_any() {
    for mass in [1e-9, 1e-6, 1e-3] {
        keeps_its_digits(&format!("tool of {mass:e} kg"), &with_tool(&arm(), brick(mass, Vector3::zeros(), [0.1; 3])));
    }
}

#[test]
fn a_massive_tip_is_as_accurate_as_any() {
    for mass in [1e2, 1e4, 1e6] {
        keeps_its_digits(&format!("tip of {mass:e} kg"), &with_tool(&arm(), brick(mass, Vector3::zeros(), [0.1; 3])));
    }
}

/// A point mass 7 cm beside the last axis: a link whose inertia has rank 3 of 6. Where it stands is known as well as its distance from the
/// base, of up to 1.4 m, so that its lever arm costs what a lever arm may (`judge_all`), wherever the centre of mass is.
#[test]
fn a_point_mass_at_the_tip_is_as_accurate_as_any() {
    for mass in [1e-9, 1.0, 1e6] {
        let mut point = brick(mass, Vector3::new(0.0625, 0.0, 0.03125), [0.0; 3]);
        point.inertia = Symmetric3::zero();
        judged(&format!("point of {mass:e} kg"), &with_tool(&arm(), point));
    }
}

/// Every link but the base is a rod without thickness.
#[test]
fn an_arm_of_rods_is_as_accurate_as_any() {
    keeps_its_digits("rods", &rods(6));
}
