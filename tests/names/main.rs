//! Any name that a URDF may give becomes code that compiles without a warning, and is the right robot.

#![deny(warnings)]

use frs::{Evaluator, FloatingBase, Model, Quantity};

frs::frs_model!(mod odd = "tests/names/odd.urdf", outputs(inertia, b2, forward_dynamics, kinematics));

#[test]
fn odd_names_give_the_robot_they_name() {
    let model = Model::from_urdf(include_str!("odd.urdf")).unwrap();
    // The robot is called Poses, and so is a part of every module.
    let mut generated = odd::RobotPoses;
    let mut core = Evaluator::new(&model);
    assert_eq!(odd::COORDINATES.to_vec(), model.coordinates().iter().map(|c| c.name.as_str()).collect::<Vec<_>>());
    let mut answers = 0;
    for quantity in Quantity::ALL.into_iter().chain((0..model.links().len()).map(Quantity::Kinematics)) {
        if !generated.answers(quantity) {
            continue;
        }
        let number = |i: usize| (i as f64 * 0.37).sin();
        let inputs: Vec<Vec<f64>> = quantity.inputs().map(|i| (0..i.len(odd::DOF)).map(number).collect()).collect();
        let inputs: Vec<&[f64]> = inputs.iter().map(Vec::as_slice).collect();
        let answer = |robot: &mut dyn FloatingBase| {
            let mut outputs: Vec<Vec<f64>> = quantity.outputs().map(|o| vec![f64::NAN; o.len(odd::DOF)]).collect();
            let mut slices: Vec<&mut [f64]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
            robot.answer(quantity, &inputs, &mut slices);
            outputs.concat().into_iter().map(f64::to_bits).collect::<Vec<u64>>()
        };
        assert_eq!(answer(&mut generated), answer(&mut core), "{quantity:?}");
        answers += 1;
    }
    // Three of the whole robot, and the kinematics of the links at the four ends.
    assert_eq!(answers, 3 + model.bodies().iter().enumerate().filter(|(k, body)| body.end == k + 1).count());
}
