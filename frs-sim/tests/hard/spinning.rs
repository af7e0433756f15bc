//! A body without joints that turns freely: about its intermediate axis it flips, at times that elliptic functions give.
//!
//! With principal inertias `I₁ < I₂ < I₃` and a start at `ω = (a, 0, b)`, `ω₂` is `sn` of a time that passes
//! `√((I₃−I₂)(I₃−I₁)/(I₁I₂)) b` a second, with the parameter `m = (I₂−I₁)I₁a²/((I₃−I₂)I₃b²)`: it changes its sign every 2K(m)
//! (Landau and Lifshitz, Mechanics, § 37).

use std::f64::consts::PI;

use frs_core::Model;
use frs_core::model::{InertialDescription, RobotDescription};
use frs_core::spatial::Symmetric3;
use frs_sim::integrate::{Method, Steps};
use frs_sim::run::equations;
use frs_sim::scene::{Scene, Solver};
use frs_sim::study::fly;
use nalgebra::Vector3;

use super::scene;

const INERTIA: [f64; 3] = [1.0, 2.0, 2.5];

/// 1 − m: so near to the separatrix, on which it never flips, that it turns about its intermediate axis for most of the time.
const BESIDE: f64 = 1e-3;

const FLIPS: usize = 100;

const ACCURACY: f64 = 1e-13;

fn body() -> Model {
    let mut robot = RobotDescription::new("body");
    let inertia = Symmetric3::diagonal(Vector3::from(INERTIA));
    robot.link("body", InertialDescription { mass: 3.0, com: Vector3::zeros(), inertia });
    robot.build().expect("the body is well formed")
}

/// K(m), with 1 − m: Gauss's arithmetic-geometric mean.
fn quarter(complement: f64) -> f64 {
    let (mut a, mut g) = (1.0_f64, complement.sqrt());
    while (a - g).abs() > 1e-15 * a {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    PI / (2.0 * a)
}

/// ω at the start where ω₃ is `b`, and the time between flips (s).
fn start(b: f64) -> ([f64; 3], f64) {
    let [i1, i2, i3] = INERTIA;
    let a = b * ((1.0 - BESIDE) * i3 * (i3 - i2) / (i1 * (i2 - i1))).sqrt();
    let pace = b * ((i3 - i2) * (i3 - i1) / (i1 * i2)).sqrt();
    ([a, 0.0, b], 2.0 * quarter(BESIDE) / pace)
}

fn turning(omega: [f64; 3], duration: f64, model: &Model) -> Scene {
    let [x, y, z] = omega;
    scene(&format!("robot = 'body.urdf'\nduration = {duration:e}\n[start]\nmu = [{x:e}, {y:e}, {z:e}, 0, 0, 0]"), model)
}

#[test]
fn a_body_flips_about_its_intermediate_axis_when_elliptic_functions_say() {
    let model = body();
    let [i1, i2, i3] = INERTIA;
    for b in [1e-6, 1e-3, 1.0, 1e4, 1e6] {
        let (omega, between) = start(b);
        let flips: Vec<f64> = (1..=FLIPS).map(|k| k as f64 * between).collect();
        let duration = flips[FLIPS - 1];
        let solver = Solver { steps: Steps::Accuracy(ACCURACY), ..Solver::default() };
        let scene = Scene { solver, ..turning(omega, duration, &model) };
        let track = fly(&scene, &flips, true, &mut |time| equations(&scene, &model, time)).unwrap();
        let momentum = Vector3::new(i1 * omega[0], 0.0, i3 * omega[2]);
        let energy = |turn: Vector3<f64>| 0.5 * (i1 * turn.x * turn.x + i2 * turn.y * turn.y + i3 * turn.z * turn.z);
        let before = energy(Vector3::from(omega));
        // ω₂ grows by this much a second where it is 0.
        let growth = omega[0] * omega[2] * (i3 - i1) / i2;
        let (mut late, mut lost) = (0.0_f64, 0.0_f64);
        for state in &track.states {
            // The momentum is known; the rate of turning follows from it.
            let turn = (state.pose.rotation.transpose() * momentum).component_div(&Vector3::from(INERTIA));
            late = late.max((turn.y / growth).abs() / duration);
            lost = lost.max((energy(turn) - before).abs() / before);
        }
        // How the time between flips answers to the energy: by K(m), dK/dm = 1/(2(1 − m)) near 1, and m by both its factors.
        let of_m = 2.0 * before * (i3 / (i1 * omega[0].powi(2)) + i1 / (i3 * omega[2].powi(2))) / (i3 - i1);
        let sensitivity = 1.0 + of_m / (2.0 * BESIDE * quarter(BESIDE));
        // A step every seven evaluations at least, each off by what it may be, all to the same side.
        let allowed = (track.evaluations / 7) as f64 * ACCURACY;
        println!(
            "b = {b:e} rad/s: late by {late:.1e} of the time, energy off by {lost:.1e}; allowed {allowed:.1e}, sensitivity {sensitivity:.0}"
        );
        assert!(lost <= allowed, "b = {b:e}: energy off by {lost:e}");
        assert!(late <= sensitivity * lost.max(f64::EPSILON) + allowed, "b = {b:e}: late by {late:e}");
    }
}

/// At 2ᵏ times the speed it is the same motion in 2⁻ᵏ of the time, bit for bit: no step, no limit and no tolerance has a unit.
#[test]
fn a_motion_at_a_million_times_the_speed_is_the_same_motion() {
    let model = body();
    let turned = |speed: f64| {
        let (omega, between) = start(1.0);
        let scene = turning(omega.map(|x| x * speed), between / speed, &model);
        let solver =
            Solver { method: Method::Dop853, steps: Steps::Length(between / 64.0 / speed), ..Solver::default() };
        let scene = Scene { solver, ..scene };
        let track = fly(&scene, &[scene.duration], true, &mut |time| equations(&scene, &model, time)).unwrap();
        track.states[0].pose.rotation
    };
    let expected = turned(1.0);
    for power in [-20, 13, 20] {
        assert_eq!(turned(2.0_f64.powi(power)), expected, "2^{power}");
    }
}
