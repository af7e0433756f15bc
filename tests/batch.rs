//! Robots generated over lanes answer batches with the bits of the core.

use frs::batch::{Group, Recording, Side, answer};
use frs::lanes::{F64x4, F64x8};
use frs::{Evaluator, Model, Quantity};
use ndarray::{Array2, ArrayView2};

frs::frs_model!(mod four = "robots/planar_three_link.urdf", lanes = 4, outputs(inertia, forward_dynamics));
frs::frs_model!(mod eight = "robots/planar_three_link.urdf", lanes = 8, outputs(inertia, forward_dynamics));

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
