//! Robots generated over lanes answer batches, and fly side by side, with the bits of the core.

use frs::batch::{Group, Recording, Side, answer};
use frs::lanes::{F64x4, F64x8, Lane};
use frs::spatial::Pose;
use frs::{Evaluator, FloatingBase, Model, Quantity};
use frs_sim::ensemble::{Arrival, Ensemble, Start, Torques};
use frs_sim::integrate::{DOPRI5, State};
use frs_sim::motion::Answered;
use ndarray::{Array2, ArrayView2};

frs::frs_model!(mod four = "robots/planar_three_link.urdf", lanes = 4, outputs(inertia, forward_dynamics, state_rate));
frs::frs_model!(mod eight = "robots/planar_three_link.urdf", lanes = 8, outputs(inertia, forward_dynamics, state_rate));

/// No multiple of four or eight.
const STATES: usize = 203;

fn bits<G: Group<Element = f64>>(robot: impl Fn() -> G + Sync, quantity: Quantity, inputs: &[Array2<f64>]) -> Vec<u64> {
    let mut outputs: Vec<Array2<f64>> =
        quantity.outputs().map(|output| Array2::from_elem((STATES, output.len(2)), f64::NAN)).collect();
    let inputs: Vec<ArrayView2<f64>> = inputs.iter().map(|array| array.view()).collect();
    answer(robot, quantity, &inputs, outputs.iter_mut().map(|array| array.view_mut()).collect()).unwrap();
    outputs.iter().flatten().map(|number| number.to_bits()).collect()
}

#[test]
fn generated_lanes_answer_batches_with_the_bits_of_the_core() {
    let model = Model::from_urdf(include_str!("../robots/planar_three_link.urdf")).unwrap();
    let mut random = fastrand::Rng::with_seed(11);
    for quantity in [Quantity::Inertia, Quantity::ForwardDynamics] {
        let mut number = || 6.0 * (random.f64() - 0.5);
        let inputs: Vec<_> =
            quantity.inputs().map(|input| Array2::from_shape_simple_fn((STATES, input.len(2)), &mut number)).collect();
        let expected = bits(|| Side::new(Evaluator::new(&model)), quantity, &inputs);
        assert!(expected.iter().all(|bits| f64::from_bits(*bits).is_finite()));
        assert_eq!(bits(|| Side::<F64x4, _>::new(four::PlanarThreeLink), quantity, &inputs), expected);
        assert_eq!(bits(|| Side::<F64x8, _>::new(eight::PlanarThreeLink), quantity, &inputs), expected);
        let recording = Recording::new(&model, quantity).unwrap();
        assert_eq!(bits(|| recording.blocks(), quantity, &inputs), expected);
    }
}

/// Where trajectories of the robot end whose torques are their numbers, and after how many steps.
fn flown<T: Lane<Element = f64>, R: FloatingBase<T>>(robot: impl Fn() -> R + Sync) -> Vec<(Vec<u64>, usize)> {
    let mut random = fastrand::Rng::with_seed(12);
    let starts: Vec<Start> = (0..21)
        .map(|number| {
            let mut flat = vec![0.0; 2 + 2 + 6];
            flat.iter_mut().for_each(|entry| *entry = random.f64() - 0.5);
            let state = State { pose: Pose::identity(), flat };
            Start { state, from: 0.0, until: 0.2 + 0.05 * f64::from(number) }
        })
        .collect();
    let ensemble = Ensemble { tableau: &DOPRI5, accuracy: 1e-10, times: Vec::new() };
    let flown = ensemble.fly(
        &starts,
        || Answered::new(robot(), Torques::none(2)),
        |motion, seat| motion.forces_mut().set(seat.lane, &[0.1 * seat.trajectory as f64, -0.3]),
    );
    let end = |arrival: Arrival| {
        assert!(arrival.end.is_ok() && arrival.steps > 3);
        let pose = arrival.state.pose;
        let numbers = pose.rotation.iter().chain(&pose.translation).chain(&arrival.state.flat);
        (numbers.map(|number| number.to_bits()).collect(), arrival.steps)
    };
    flown.unwrap().arrivals.into_iter().map(end).collect()
}

#[test]
fn generated_lanes_fly_with_the_bits_of_the_core() {
    let model = Model::from_urdf(include_str!("../robots/planar_three_link.urdf")).unwrap();
    let expected = flown::<f64, _>(|| Evaluator::new(&model));
    assert_eq!(flown::<F64x4, _>(|| four::PlanarThreeLink), expected);
    assert_eq!(flown::<F64x8, _>(|| eight::PlanarThreeLink), expected);
}
