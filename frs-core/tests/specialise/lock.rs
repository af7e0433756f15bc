//! Held coordinates are coordinates that stand still.

use frs_core::Model;
use frs_core::model::{Inertial, JointKind, RobotDescription, SpecialiseError};
use frs_core::spatial::Symmetric3;
use nalgebra::{DMatrix, Vector3};
use proptest::prelude::*;
use proptest::sample::Index;

use crate::answers::{Answers, State, states};
use crate::robots::{bits, config, robots};

fn names(model: &Model) -> Vec<&str> {
    model.coordinates().iter().map(|coordinate| coordinate.name.as_str()).collect()
}

/// Adding 0 makes 0 of −0, which a sum that starts at 0 never is.
fn bits_of_matrix(matrix: &DMatrix<f64>) -> Vec<u64> {
    matrix.iter().map(|entry| (entry + 0.0).to_bits()).collect()
}

proptest! {
    #![proptest_config(config())]

    /// What a follower follows may be held, too.
    #[test]
    fn what_is_left_of_a_quantity_keeps_its_bits(
        robot in robots(), held in prop::array::uniform8(any::<bool>()), spared in any::<Index>(), mut state in states(),
    ) {
        let model = robot.build().unwrap();
        let n = model.dof();
        let spared = spared.index(n);
        let (free, held): (Vec<usize>, Vec<usize>) = (0..n).partition(|&c| c == spared || !held[c]);
        let pairs: Vec<_> = held.iter().rev().map(|&c| (names(&model)[c], state.coordinates[c][0])).collect();
        let locked = model.lock(&pairs).unwrap();
        prop_assert_eq!(names(&locked), free.iter().map(|&c| names(&model)[c]).collect::<Vec<_>>());

        held.iter().for_each(|&c| state.coordinates[c][1..].fill(0.0));
        let expected = Answers::new(&model, &state).keep(&free);
        let left = State { coordinates: free.iter().map(|&c| state.coordinates[c]).collect(), ..state };
        let found = Answers::new(&locked, &left);
        for (found, expected) in found.matrices().into_iter().zip(expected.matrices()) {
            prop_assert_eq!(bits_of_matrix(found), bits_of_matrix(expected));
        }
    }
}

#[test]
fn coordinates_held_one_after_the_other_are_held_together() {
    let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE).unwrap();
    let together = model.lock(&[("joint_4", 0.5), ("joint_2", -0.25)]).unwrap();
    let one_by_one = model.lock(&[("joint_2", -0.25)]).unwrap().lock(&[("joint_4", 0.5)]).unwrap();
    let drives = |model: &Model| model.bodies().iter().map(|body| body.drive).collect::<Vec<_>>();
    assert_eq!((bits(&one_by_one), drives(&one_by_one)), (bits(&together), drives(&together)));
    assert_eq!(names(&one_by_one), ["joint_1", "joint_3", "joint_5", "joint_6", "joint_7"]);
}

#[test]
fn holding_nothing_changes_nothing() {
    let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE).unwrap();
    let same = model.lock(&[]).unwrap();
    assert_eq!((bits(&same), same.dof(), same.has_mimic()), (bits(&model), 7, false));
}

#[test]
fn wrong_names_are_told_with_the_right_ones() {
    let mut robot = RobotDescription::new("door");
    let solid = Inertial { mass: 1.0, com: Vector3::x(), inertia: Symmetric3::diagonal(Vector3::repeat(1.0)) };
    for link in ["frame", "leaf", "handle"] {
        robot.link(link, solid);
    }
    robot.joint("hinge", JointKind::Revolute, "frame", "leaf");
    robot.joint("latch", JointKind::Revolute, "leaf", "handle");
    let model = robot.build().unwrap();
    let message = |result: Result<Model, SpecialiseError>| result.unwrap_err().to_string();
    assert_eq!(
        message(model.lock(&[("knob", 0.0)])),
        "coordinate 'knob': the robot has no such coordinate; expected one of its coordinates; choose from hinge, latch"
    );
    assert_eq!(
        message(model.lock(&[("hinge", 0.0), ("hinge", 0.0)])),
        "coordinate 'hinge': held twice; expected one value for each coordinate; take one of the two away"
    );
    assert_eq!(
        message(model.lock(&[("hinge", 0.0), ("latch", 0.5)])),
        "robot: all coordinates are held; expected one at least that stays free; leave one out"
    );
    assert_eq!(
        message(model.with_inertial("knob", solid)),
        "link 'knob': the robot has no such link; expected one of its links; choose from frame, leaf, handle"
    );
    // What is held is no coordinate any more.
    let stiff = model.lock(&[("latch", 0.0)]).unwrap();
    assert!(message(stiff.lock(&[("latch", 0.0)])).ends_with("choose from hinge"));
}
