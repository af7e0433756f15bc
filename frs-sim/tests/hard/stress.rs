//! Forces that jump, pulses that are shorter than a step, accuracies from one end to the other.

use frs_core::Model;
use frs_sim::integrate::Steps;
use frs_sim::scene::{Scene, Solver};
use frs_sim::study::{Truth, Variant};
use nalgebra::Vector3;

use crate::{robot, scene, whole};

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
    for accuracy in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
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
        before = error.max(ROUNDING);
    }
    assert!(truth.error().of_state() < ROUNDING);
}

/// What the last digits of the times of 1 ns blows of 5e8 N make: 0.5 N·s, off by the rounding of 0.7 s over 1 ns, 1e-7 of it, on 17.5 kg.
/// The scene has these times in doubles, and so has the yardstick; what is left is the rounding of accelerations of 1e8 rad/s².
const ROUNDING: f64 = 1e-11;

/// Momentum is the sum of the blows, whatever the steps.
#[test]
fn blows_give_their_impulse_at_the_coarsest_accuracy() {
    let model = robot("lwr_satellite");
    for accuracy in ["1e-2", "1e-8"] {
        let text = JUMPING.replace("duration = 1\n", &format!("duration = 1\naccuracy = {accuracy}\n"));
        let record = whole(&text, &model);
        let last = record.samples.last().expect("samples are there");
        let start = record.samples[0].momentum.force;
        let times = [(0.2, 0.201), (0.5, 0.500001), (0.7, 0.700000001)];
        let expected = Vector3::new(
            500.0 * (times[0].1 - times[0].0),
            5e5 * (times[1].1 - times[1].0),
            5e8 * (times[2].1 - times[2].0),
        );
        let off = (last.momentum.force - start - expected).amax();
        println!("accuracy {accuracy}: impulse off by {off:.1e} N·s of {:.3}", expected.norm());
        // Momentum is rounded in each of the steps of the blows and after them.
        assert!(off <= IMPULSE, "{accuracy}: {off:e}");
    }
}

/// N·s: ε of an impulse of 0.5 a step, and as much again for turning it into the base's axes and back, for a hundred steps.
const IMPULSE: f64 = 1e-13;

#[test]
fn accuracies_that_cannot_be_kept_are_refused_by_their_range() {
    let model: Model = robot("lwr_satellite");
    for accuracy in ["1e-1", "1e-15", "0", "-1"] {
        let text = JUMPING.replace("duration = 1\n", &format!("duration = 1\naccuracy = {accuracy}\n"));
        let error = Scene::parse("scene.toml", &text, &model).unwrap_err().to_string();
        assert!(error.contains("accuracy") && error.contains("1e-14") && error.contains("1e-2"), "{error}");
    }
}
