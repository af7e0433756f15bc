//! Forces that jump, pulses that are shorter than a step, accuracies from one end to the other.

use frs_core::Model;
use frs_sim::integrate::Steps;
use frs_sim::scene::{Scene, Solver};
use frs_sim::study::{Truth, Variant};
use nalgebra::Vector3;

use super::{robot, scene, whole};

/// Torques that jump, and blows of 1 ms, of 1 μs and of 1 ns.
const JUMPING: &str = "robot = 'lwr_satellite.urdf'
duration = 1
samples_per_second = 10
[start]
q = { joint_2 = 0.5, joint_4 = 1.2 }
qd = { joint_3 = 0.5 }
[friction]
viscous = 0.05
[[joint_torque]]
tau = { joint_1 = 0.5, joint_5 = -0.2 }
start = 0.1
end = 0.31
[[joint_torque]]
tau = { joint_1 = -0.7 }
start = 0.31
end = 0.4321
[[wrench]]
force = [500, 0, 0]
axes = 'world'
start = 0.2
end = 0.201
[[wrench]]
force = [0, 5e5, 0]
axes = 'world'
start = 0.5
end = 0.500001
[[wrench]]
force = [0, 0, 5e8]
axes = 'world'
start = 0.7
end = 0.700000001
";

#[test]
fn every_accuracy_is_kept_over_jumps_and_short_blows() {
    let model = robot("lwr_satellite");
    let asked = scene(JUMPING, &model);
    let truth = Truth::of(&asked, &model).unwrap();
    let mut before = f64::INFINITY;
    for accuracy in [1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
        let solver = Solver { steps: Steps::Accuracy(accuracy), ..asked.solver };
        let judged = truth.judge(&Variant { solver, ..Variant::default() }).unwrap();
        let error = judged.errors.of_state();
        // DOP853 takes eleven evaluations a step at least.
        let allowed = (judged.evaluations / 11) as f64 * accuracy + ROUNDING;
        println!(
            "accuracy {accuracy:e}: {} evaluations, off by {error:.1e}, allowed {allowed:.1e}",
            judged.evaluations
        );
        assert!(error <= allowed, "{accuracy:e}: {error:e}");
        assert!(error <= before, "{accuracy:e}: {error:e} after {before:e}");
        before = error;
    }
    assert!(truth.error().of_state() < ROUNDING);
}

/// Rounding of accelerations of 1e9 rad/s² over 1 ns, and of all else, with a few digits lost in Λ_q.
const ROUNDING: f64 = 1e-11;

/// The blows are met from edge to edge: what they give is as exact as the turning of the base meanwhile, in whose axes it is added up.
#[test]
fn blows_shorter_than_a_step_give_their_whole_impulse() {
    let model = robot("lwr_satellite");
    for accuracy in [1e-1, 1e-2, 1e-8, 1e-14] {
        let text = JUMPING.replace("duration = 1\n", &format!("duration = 1\naccuracy = {accuracy:e}\n"));
        let record = whole(&text, &model);
        let last = record.samples.last().expect("samples are there");
        let blows = Vector3::new(500.0 * (0.201 - 0.2), 5e5 * (0.500001 - 0.5), 5e8 * (0.700000001 - 0.7));
        let off = (last.momentum.force - record.samples[0].momentum.force - blows).amax();
        let allowed = record.steps as f64 * accuracy + ROUNDING;
        println!("accuracy {accuracy:e}: {} steps, impulse off by {off:.1e} N·s of {:.3}", record.steps, blows.norm());
        assert!(off <= allowed, "{accuracy:e}: {off:e}");
    }
}

#[test]
fn accuracies_that_cannot_be_kept_are_refused_by_their_range() {
    let model: Model = robot("lwr_satellite");
    for accuracy in ["0.11", "9e-15"] {
        let text = JUMPING.replace("duration = 1\n", &format!("duration = 1\naccuracy = {accuracy}\n"));
        let error = Scene::parse("scene.toml", &text, &model).unwrap_err().to_string();
        assert!(error.contains("accuracy") && error.contains("1e-14") && error.contains("1e-1"), "{error}");
    }
}
