//! The observer of the locked velocity converges as its Lyapunov function says, and does not disturb what it observes.

use std::ops::ControlFlow;

use frs_core::spatial::Twist;
use frs_core::{Model, Workspace, urdf};
use frs_sim::observer::Observation;
use frs_sim::run::{End, Record, Sample, run};
use frs_sim::scene::Scene;
use nalgebra::{Matrix3, Vector3};

/// Below this the error is that of the interpolated states, times the gain (rad/s, m/s).
const FLOOR: f64 = 1e-8;

/// Samples of these scenes, 1/s.
const RATE: f64 = 100.0;

fn satellite() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

/// A tumbling satellite with a moving arm.
const TUMBLING: &str = "robot = 'x.urdf'\nduration = 2\naccuracy = 1e-11\n\
    [start]\nq = { joint_2 = 0.5, joint_4 = 1.2 }\nmomentum = [1.5, -0.8, 0.6, 2, -1, 0.5]\n\
    [computed_torque]\nbandwidth = 8\ntimes = [0, 1, 2]\n\
    set_point = [{ joint_2 = 0.5, joint_4 = 1.2 }, { joint_1 = 0.8, joint_4 = 0.4 }, { joint_2 = 0.3, joint_6 = 0.5 }]\n";

fn flown(text: &str) -> Record {
    let model = satellite();
    let scene = Scene::parse("scene.toml", text, &model).unwrap_or_else(|error| panic!("{error}"));
    let record = run(&scene, &model, |_| ControlFlow::Continue(()));
    assert_eq!(record.end, End::Whole);
    record
}

fn observer(gain: f64, guess: Twist<f64>) -> String {
    format!("[observer]\ngain = {gain}\nguess = {:?}\n", guess.to_array())
}

fn observation(sample: &Sample) -> Observation {
    sample.observation.unwrap()
}

/// The error seen from the centre of mass: ω_e in base axes, v_e in those of the world.
fn about_com(work: &mut Workspace, sample: &Sample) -> [Vector3<f64>; 2] {
    let error = observation(sample).error.at(work.shape(&sample.q).com());
    [error.angular, sample.pose.rotation * error.linear]
}

/// `½ ω_eᵀ X ω_e` with `X = J̇ + Ω× J − J Ω×`, from the core's P(q̇), base twist and locked inertia.
fn turning(work: &mut Workspace, sample: &Sample, omega: Vector3<f64>) -> f64 {
    let mut shape = work.shape(&sample.q);
    let com = shape.com();
    let moment = shape.locked_rotational_inertia().to_matrix();
    // P about the centre of mass: with no velocity there, angular errors alone.
    let error = Twist::new(omega, Vector3::zeros()).at(-com);
    let p = shape.inertia_velocity(&sample.qd);
    let change = (p * error.to_vector()).dot(&error.to_vector());
    let base = shape.moving(&sample.qd).base_twist(sample.mu).angular;
    0.5 * change + omega.dot(&base.cross(&(moment * omega)))
}

#[test]
fn the_observed_motion_is_the_one_that_nobody_observes_bit_for_bit() {
    let pulse = "[wrench]\nmoment = [1, 2, 3]\nforce = [3, 0, 1]\nstart = 0.3\nend = 0.5\n";
    for text in [TUMBLING.to_owned(), format!("{TUMBLING}{pulse}")] {
        let alone = flown(&text);
        let mut observed = flown(&format!("{text}{}", observer(20.0, Twist::zero())));
        assert!(observed.samples.iter_mut().all(|sample| sample.observation.take().is_some()));
        assert!(observed.checkpoint.observer.take().is_some());
        assert_eq!(observed, alone);
    }
}

/// `V' = −2 k V − ½ ω_eᵀ X ω_e`, integrated along the motion, for errors that are small beside 1 rad/s.
#[test]
fn the_lyapunov_function_falls_at_the_derived_rate() {
    /// φ is of the size of the error over the gain, and J is anisotropic by a factor of some tens.
    const SMALL: f64 = 1e-4;
    /// Simpson's rule on samples of a motion of seconds, and the terms in φ.
    const QUADRATURE: f64 = 1e-4;
    const GAIN: f64 = 2.0;
    let model = satellite();
    let mut work = Workspace::new(&model);
    let start = flown(TUMBLING).samples[0].mu;
    let wrong = Twist::from_array([1.0, -0.6, 0.8, 0.3, -0.2, 0.4]) * SMALL;
    let record = flown(&format!("{TUMBLING}{}", observer(GAIN, start + wrong)));
    let rates: Vec<f64> = record
        .samples
        .iter()
        .map(|sample| {
            let [omega, _] = about_com(&mut work, sample);
            -2.0 * GAIN - turning(&mut work, sample, omega) / observation(sample).lyapunov
        })
        .collect();
    let turned = rates.iter().map(|rate| (rate + 2.0 * GAIN).abs()).fold(0.0, f64::max);
    assert!(turned > 0.05, "the inertia turns: {turned}");
    let mut predicted = 0.0;
    for i in (2..record.samples.len()).step_by(2) {
        predicted += (rates[i - 2] + 4.0 * rates[i - 1] + rates[i]) / (3.0 * RATE);
        let found = (observation(&record.samples[i]).lyapunov / observation(&record.samples[0]).lyapunov).ln();
        assert!((found - predicted).abs() < QUADRATURE, "{}: {found} {predicted}", record.samples[i].time);
    }
}

/// From a guess of nothing: each sample nearer than the one before, at least as fast as the gain less what the turning inertia takes.
#[test]
fn it_converges_from_no_guess_at_all() {
    let model = satellite();
    let mut work = Workspace::new(&model);
    for (gain, driven) in [
        (5.0, ""),
        (5.0, "[wrench]\nforce = [3, -1, 2]\nmoment = [0.1, 0.2, 0]\n[gravity]\nacceleration = [0, 0, -9.81]\n"),
    ] {
        let record = flown(&format!("{TUMBLING}{driven}{}", observer(gain, Twist::zero())));
        let mut slowest = 0.0_f64;
        for sample in &record.samples {
            let moment = work.shape(&sample.q).locked_rotational_inertia().to_matrix();
            let entry = |a: Vector3<f64>, work: &mut Workspace| 2.0 * turning(work, sample, a);
            let x = Matrix3::from_fn(|i, j| {
                let [a, b] = [i, j].map(|i| Vector3::ith(i, 1.0));
                0.5 * (entry(a + b, &mut work) - entry(a, &mut work) - entry(b, &mut work))
            });
            let inverse = moment.cholesky().unwrap().l().try_inverse().unwrap();
            let eigenvalues = (inverse * x * inverse.transpose()).symmetric_eigenvalues();
            slowest = slowest.max(0.5 * eigenvalues.amax());
        }
        let [first, .., last] = record.samples.as_slice() else { panic!("two samples at least") };
        assert!(observation(first).error.to_vector().norm() > 0.5 && slowest < gain, "{slowest}");
        for pair in record.samples.windows(2) {
            let [before, after] = [&pair[0], &pair[1]].map(|sample| observation(sample).lyapunov);
            assert!(after < before || after < FLOOR * FLOOR, "{}: {before:e} {after:e}", pair[0].time);
        }
        let fallen = (observation(last).lyapunov / observation(first).lyapunov).sqrt();
        assert!(fallen < (-(gain - slowest) * last.time).exp(), "{fallen:e} {slowest}");
        // Its linear half, whatever the rest does: e^(−k t).
        let [_, velocity] = about_com(&mut work, first);
        for sample in &record.samples {
            let [_, error] = about_com(&mut work, sample);
            let expected = velocity * (-gain * sample.time).exp();
            assert!((error - expected).norm() < FLOOR, "{}: {error} {expected}", sample.time);
        }
    }
}

/// Its own steps are as short as it needs: a gain for which the steps of the motion would be far too long.
#[test]
fn a_high_gain_is_followed_exactly() {
    const GAIN: f64 = 300.0;
    let model = satellite();
    let mut work = Workspace::new(&model);
    let record = flown(&format!("{TUMBLING}{}", observer(GAIN, Twist::zero())));
    assert!((record.steps as f64) < GAIN, "{} steps", record.steps);
    let [_, velocity] = about_com(&mut work, &record.samples[0]);
    for sample in &record.samples {
        let [omega, error] = about_com(&mut work, sample);
        let expected = velocity * (-GAIN * sample.time).exp();
        assert!((error - expected).norm() < 10.0 * FLOOR, "{}: {error} {expected}", sample.time);
        assert!(sample.time < 0.1 || omega.norm() < 10.0 * FLOOR, "{}: {omega}", sample.time);
    }
}

/// A target that is caught jumps the momentum, which nobody tells; the observer finds it again.
#[test]
fn what_a_payload_brings_is_found_again() {
    let target = "[payload]\nlink = 'link_7'\nmass = 8\ninertia = [0.1, 0.2, 0.15, 0, 0, 0]\ngrasp = 1\ntwist = [0.3, -0.2, 0.4, 0.1, 0.2, -0.1]\n";
    let record = flown(&format!("{TUMBLING}{target}{}", observer(10.0, Twist::zero())));
    let error = |time: f64| {
        let sample = record.samples.iter().rfind(|sample| sample.time <= time).unwrap();
        observation(sample).error.to_vector().norm()
    };
    assert!(
        error(1.0) < 1e-3 && error(1.02) > 0.1 && error(2.0) < 1e-3,
        "{} {} {}",
        error(1.0),
        error(1.02),
        error(2.0)
    );
}
