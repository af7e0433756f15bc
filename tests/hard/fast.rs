//! A robot that flies past at orbital speed and beyond.
//!
//! Joints do not feel a common velocity: their equations do not read it. And where the momentum's do, `v × m v = 0` is left out: it would be
//! the rounding of numbers of 10⁹ N·m at 7.5 km/s.

use frs::{Evaluator, Model, Quantity, urdf};

use crate::judge::{answer, judge_all};
use crate::robots::turned;
use crate::state::State;

const SPEEDS: [f64; 3] = [1.0, 7.5e3, 1e6];

const SHAPES: u64 = 20;

fn at_speed(model: &Model, seed: u64, speed: f64) -> State {
    let state = turned(model, seed, 3.0);
    let mut mu = state.numbers("mu", 6);
    mu[3..].iter_mut().for_each(|v| *v *= speed);
    state.with("mu", mu)
}

#[test]
fn joints_do_not_feel_a_common_velocity() {
    let model = Model::from_urdf(urdf::LWR_SATELLITE).expect("the robot is well formed");
    let mut robot = Evaluator::new(&model);
    for seed in 0..SHAPES {
        let slow = at_speed(&model, seed, SPEEDS[0]);
        for speed in &SPEEDS[1..] {
            let fast = at_speed(&model, seed, *speed);
            let mut felt = |state: &State| {
                let mut felt = answer(&mut robot, Quantity::CouplingTorque, state).concat();
                let xi_dot = answer(&mut robot, Quantity::ForwardDynamics, state).concat();
                felt.extend(&xi_dot[6..]);
                felt
            };
            assert_eq!(felt(&slow), felt(&fast), "seed {seed} at {speed} m/s");
        }
    }
}

#[test]
fn quantities_at_speed_are_as_accurate_as_at_rest() {
    let model = Model::from_urdf(urdf::LWR_SATELLITE).expect("the robot is well formed");
    for speed in SPEEDS {
        judge_all(&format!("at {speed} m/s"), &model, (0..SHAPES).map(|seed| at_speed(&model, seed, speed)));
    }
}
