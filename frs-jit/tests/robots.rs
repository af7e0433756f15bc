//! A robot compiled at run time performs the core's own operations: every output has the same bits.

#[path = "../../generated/tests/bits/answers.rs"]
mod answers;
#[path = "../../generated/tests/bits/states.rs"]
mod states;

use std::path::Path;

use answers::{answer, difference};
use frs_core::{Evaluator, FloatingBase, Model, Quantity};
use frs_jit::{JitError, Robot};
use states::States;

/// States at which each quantity of each robot is compared.
const STATES: usize = 1000;

/// The robots of a folder of `robots/`.
fn robots(folder: &str) -> Vec<Model> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots").join(folder);
    let files = std::fs::read_dir(folder).unwrap().map(|file| file.unwrap().path());
    let urdfs = files.filter(|file| file.extension().is_some_and(|extension| extension == "urdf"));
    let robots: Vec<_> = urdfs.map(|urdf| Model::from_urdf(&std::fs::read_to_string(urdf).unwrap()).unwrap()).collect();
    assert!(robots.len() >= 6, "a folder without robots proves nothing");
    robots
}

/// Every quantity, with the kinematics of the first link and of the last.
fn quantities(model: &Model) -> Vec<Quantity> {
    let links = [0, model.links().len() - 1].map(Quantity::Kinematics);
    Quantity::ALL.into_iter().chain(links).collect()
}

fn every_output_has_the_bits_of_the_core(model: &Model) {
    let quantities = quantities(model);
    let (mut core, mut compiled) = (Evaluator::new(model), Robot::new(model, &quantities).unwrap());
    for quantity in quantities {
        let mut states = States::new(4);
        let mut finite = 0;
        for state in 0..STATES {
            let inputs = states.next(quantity, model.dof());
            let expected = answer(&mut core, quantity, &inputs);
            if let Some(difference) = difference(quantity, &expected, &answer(&mut compiled, quantity, &inputs)) {
                panic!("{}, state {state}: {difference}\nat {inputs:?}", model.name());
            }
            finite += usize::from(expected.iter().flatten().all(|x| x.is_finite()));
        }
        assert!(finite > STATES / 2, "{}, {quantity:?}: only {finite} states had finite answers", model.name());
    }
}

#[test]
fn robots_have_the_bits_of_the_core() {
    robots("").iter().for_each(every_output_has_the_bits_of_the_core);
}

#[test]
fn robots_known_in_closed_form_have_the_bits_of_the_core() {
    robots("oracles").iter().for_each(every_output_has_the_bits_of_the_core);
}

fn satellite() -> Model {
    Model::from_urdf(frs_core::urdf::LWR_SATELLITE).unwrap()
}

#[test]
fn a_robot_answers_what_it_was_compiled_for() {
    let robot = Robot::new(&satellite(), &[Quantity::B2, Quantity::Kinematics(3)]).unwrap();
    assert_eq!(robot.dof(), 7);
    assert!(robot.answers(Quantity::B2) && robot.answers(Quantity::Kinematics(3)));
    assert!(!robot.answers(Quantity::Inertia) && !robot.answers(Quantity::Kinematics(2)));
}

#[test]
fn a_link_that_is_not_there_is_told() {
    let error = Robot::new(&satellite(), &[Quantity::Kinematics(99)]).unwrap_err();
    assert!(matches!(error, JitError::Record(_)) && error.to_string().contains("number 99"), "{error}");
}

#[test]
#[should_panic(expected = "B2 was not generated")]
fn a_quantity_that_was_not_compiled_is_refused() {
    let mut robot = Robot::new(&satellite(), &[Quantity::KineticEnergy]).unwrap();
    robot.answer(Quantity::B2, &[&[0.0; 7], &[0.0; 6]], &mut [&mut [0.0; 49]]);
}

#[test]
#[should_panic(expected = "must have the lengths")]
fn slices_of_other_lengths_are_refused() {
    let mut robot = Robot::new(&satellite(), &[Quantity::B2]).unwrap();
    robot.answer(Quantity::B2, &[&[0.0; 7], &[0.0; 6]], &mut [&mut [0.0; 48]]);
}

#[test]
fn a_call_allocates_nothing() {
    let mut robot = Robot::new(&satellite(), &[Quantity::B2]).unwrap();
    let mut b2 = [0.0; 49];
    let counted = allocation_counter::measure(|| robot.answer(Quantity::B2, &[&[0.3; 7], &[0.1; 6]], &mut [&mut b2]));
    assert_eq!(counted.count_total, 0);
    assert!(allocation_counter::measure(|| drop(satellite())).count_total > 0, "allocations are counted");
}
