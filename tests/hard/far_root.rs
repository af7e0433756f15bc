//! The root link's frame 1,600 km from the robot, and link frames anywhere.
//!
//! All offsets are multiples of 2⁻⁷ m below 2²¹ m, so that descriptions are exact: what differs is where the frames stand. A base body's
//! own frame stands at its centre of mass, and links that are fixed to each other are weighed from one another, so that joints and
//! everything they feel never see the distance.

use frs::conditioning::roundings;
use frs::model::{InertialDescription, JointKind, RobotDescription};
use frs::nalgebra::Vector3;
use frs::spatial::Pose;
use frs::{Evaluator, Model, Quantity};

use crate::judge::{answer, judge, judge_all};
use crate::robots::{brick, turned};
use crate::state::State;

/// Some 2²⁰ m each way.
const FAR: Vector3<f64> = Vector3::new(1_048_576.5, -1_048_576.25, 524_288.125);

const LINKS: usize = 5;

const SHAPES: u64 = 20;

/// An arm of bricks. The root frame stands at `−root` from the base's corner, each link's masses hang on the link by a fixed joint
/// whose frame stands `masses` from them, and each joint's frame is slid along its axis by `slid`.
fn arm(root: Vector3<f64>, masses: Vector3<f64>, slid: f64) -> Model {
    let mass = |com: Vector3<f64>| brick(1.0, com, [1.0, 0.5, 0.25]);
    let place = |p: Vector3<f64>| Pose::from_rpy(p, [0.0; 3]);
    let mut robot = RobotDescription::new("arm");
    robot.link("link_0", mass(root + Vector3::new(0.25, 0.125, 0.5)));
    // Where the joint's frame stands in the link's.
    let mut from = root;
    for k in 1..=LINKS {
        let (parent, child, hung) = (format!("link_{}", k - 1), format!("link_{k}"), format!("masses_{k}"));
        let axis = Vector3::ith(k % 3, 1.0);
        robot.link(&child, InertialDescription::NONE);
        robot.link(&hung, mass(Vector3::new(0.5, 0.125, -0.25) - masses));
        let joint = robot.joint(format!("joint_{k}"), JointKind::Continuous, parent, &child);
        joint.origin(place(from + Vector3::new(1.0, 0.25, 0.125) + axis * slid)).axis(axis.x, axis.y, axis.z);
        robot.joint(format!("fixed_{k}"), JointKind::Fixed, child, hung).origin(place(masses - axis * slid));
        from = -axis * slid;
    }
    robot.build().expect("the robot is well formed")
}

/// What joints feel: none of it depends on the root frame.
const SHAPE: [Quantity; 2] = [Quantity::B2, Quantity::CouplingTorque];

#[test]
fn what_joints_feel_has_the_same_bits_wherever_the_frames_stand() {
    let near = arm(Vector3::zeros(), Vector3::zeros(), 0.0);
    for (root, masses) in [(FAR, Vector3::zeros()), (Vector3::zeros(), FAR), (FAR, FAR)] {
        let far = arm(root, masses, 0.0);
        let (mut one, mut other) = (Evaluator::new(&near), Evaluator::new(&far));
        for seed in 0..SHAPES {
            let state = turned(&near, seed, 3.0);
            for quantity in SHAPE {
                assert_eq!(answer(&mut one, quantity, &state), answer(&mut other, quantity, &state), "{quantity:?}");
            }
            let third = |robot: &mut Evaluator| answer(robot, Quantity::Inertia, &state).swap_remove(2);
            assert_eq!(third(&mut one), third(&mut other), "Λ_q");
            let turning = |robot: &mut Evaluator| answer(robot, Quantity::Curvature, &state).swap_remove(0);
            assert_eq!(turning(&mut one), turning(&mut other), "𝓑");
        }
    }
}

/// What is told in the root frame is as accurate as numbers of that size are: its natural scale has the distance in it.
#[test]
fn what_is_told_in_a_far_root_frame_is_as_accurate_as_its_numbers() {
    let model = arm(FAR, FAR, 0.0);
    judge_all("far root", &model, (0..SHAPES).map(|seed| slow(turned(&model, seed, 3.0))));
}

/// The same where it is the masses and not the far frame that move at about a metre per second.
fn slow(state: State) -> State {
    ["mu", "base_twist"].into_iter().fold(state, |state, name| {
        let numbers = state.numbers(name, 6);
        let (turn, speed) = (Vector3::from_column_slice(&numbers[..3]), Vector3::from_column_slice(&numbers[3..]));
        let speed = speed - turn.cross(&FAR);
        state.with(name, turn.iter().chain(&speed).copied().collect())
    })
}

/// A body's frame stands where the joint's does: slid along its axis, it is a lever arm that is added and taken off, and rounded on
/// the way. The sweeps do not look for the point of an axis that is nearest to the masses; so this costs the digits of the distance.
#[test]
fn a_frame_far_along_its_axis_costs_the_digits_of_the_distance() {
    for slid in [1.0, 1024.0, 131_072.0] {
        let model = arm(Vector3::zeros(), Vector3::zeros(), slid);
        for seed in 0..SHAPES {
            let judged = judge(&model, &turned(&model, seed, 3.0));
            let allowed = roundings(model.joints()) * judged.lever * (1.0 + slid);
            assert!(judged.worst() <= allowed, "slid by {slid}: {judged}");
            if seed == 0 {
                println!("slid by {slid}: {judged}");
            }
        }
    }
}
