//! Prints the time of a call, in ns a state, for each robot, quantity and form of code, which must agree bit by bit.

use std::hint::black_box;
use std::time::Instant;

use frs::lanes::F64x8;
use frs::{Evaluator, FloatingBase, Model, Quantity, Real};

frs::frs_model!(mod satellite = "../../robots/lwr_satellite.urdf", form = unrolled, outputs(inertia, matrices, forward_dynamics));
frs::frs_model!(mod quadruped = "../../robots/quadruped.urdf", form = unrolled, outputs(inertia, matrices, forward_dynamics));
frs::frs_model!(mod humanoid = "../../robots/humanoid.urdf", form = unrolled, outputs(inertia, matrices, forward_dynamics));

const QUANTITIES: [Quantity; 3] = [Quantity::Inertia, Quantity::Matrices, Quantity::ForwardDynamics];

/// How often each of them is asked, and at how many states.
const ROUNDS: usize = 200;
const STATES: usize = 16;

fn main() {
    robot(include_str!("../../../robots/lwr_satellite.urdf"), satellite::LwrSatellite);
    robot(include_str!("../../../robots/quadruped.urdf"), quadruped::Quadruped);
    robot(include_str!("../../../robots/humanoid.urdf"), humanoid::Humanoid);
}

fn robot(urdf: &str, mut generated: impl FloatingBase) {
    let model = Model::from_urdf(urdf).unwrap_or_else(|error| panic!("{error}"));
    let eight = model.cast::<F64x8>();
    let (mut core, mut lanes) = (Evaluator::new(&model), Evaluator::new(&eight));
    for quantity in QUANTITIES {
        let (expected, core) = ask(&mut core, quantity, |x| x, |x| x);
        let (of_lanes, lanes) = ask(&mut lanes, quantity, F64x8::splat, |x| x.to_array()[7]);
        let (of_generated, generated) = ask(&mut generated, quantity, |x| x, |x| x);
        assert!(of_lanes == expected && of_generated == expected, "{} of {}", quantity.name(), model.name());
        for (form, time) in [("core", core), ("lanes", lanes / 8.0), ("generated", generated)] {
            println!("{} {} {form} {time:.0}", model.name(), quantity.name());
        }
    }
}

/// The bits of all answers, and the least mean time of a call.
fn ask<T: Real>(
    robot: &mut impl FloatingBase<T>,
    quantity: Quantity,
    lift: impl Fn(f64) -> T,
    lower: impl Fn(T) -> f64,
) -> (Vec<u64>, f64) {
    let n = robot.dof();
    let states: Vec<Vec<Vec<T>>> = (0..STATES)
        .map(|state| {
            let number = |k: usize| lift((1.0 + (7 * state + k) as f64).sin());
            quantity.inputs().map(|argument| (0..argument.len(n)).map(number).collect()).collect()
        })
        .collect();
    let mut outputs: Vec<Vec<T>> = quantity.outputs().map(|argument| vec![T::zero(); argument.len(n)]).collect();
    let mut bits = Vec::new();
    let mut least = f64::INFINITY;
    for round in 0..=ROUNDS {
        let start = Instant::now();
        for state in &states {
            let inputs: Vec<&[T]> = state.iter().map(Vec::as_slice).collect();
            let mut slices: Vec<&mut [T]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
            robot.answer(quantity, black_box(&inputs), &mut slices);
            if round == 0 {
                // −0 and 0 are one number.
                bits.extend(outputs.iter().flatten().map(|&x| (lower(x) + 0.0).to_bits()));
            }
        }
        if round > 0 {
            least = least.min(start.elapsed().as_secs_f64() * 1e9 / STATES as f64);
        }
    }
    (bits, least)
}
