//! Who follows whom: chains of mimic joints, composed.

use super::names::Names;
use super::wording::abridged;
use crate::model::{JointKind, Part, Problem, RobotDescription};

/// How a joint follows the coordinate of its leader: value = `ratio`·(the leader's value) + `offset`.
///
/// A joint that follows no other one is its own leader, with ratio 1 and offset 0.
#[derive(Clone, Copy)]
pub(super) struct Following {
    /// The joint at the end of the chain.
    pub leader: usize,
    /// Product of the multipliers along the chain.
    pub ratio: f64,
    /// Offset.
    pub offset: f64,
}

/// Composes the mimic chains; reports cycles, and joints that cannot follow or lead.
pub(super) fn compose(robot: &RobotDescription, names: &Names, problems: &mut Vec<Problem>) -> Vec<Following> {
    let leader: Vec<Option<usize>> =
        (0..robot.joints.len()).map(|joint| checked_leader(robot, names, joint, problems)).collect();
    let own = |leader| Following { leader, ratio: 1.0, offset: 0.0 };
    let mut followings: Vec<Option<Following>> = vec![None; robot.joints.len()];
    let mut entered = vec![false; robot.joints.len()];
    let mut chain = Vec::new();
    for start in 0..robot.joints.len() {
        // Up the chain, to a joint that is known, leads itself, or stands on the chain already.
        let mut joint = start;
        while followings[joint].is_none()
            && !entered[joint]
            && let Some(next) = leader[joint]
        {
            entered[joint] = true;
            chain.push(joint);
            joint = next;
        }
        if entered[joint] && followings[joint].is_none() {
            report_cycle(robot, &chain, joint, problems);
        }
        // Down again.
        let mut end = *followings[joint].get_or_insert(own(joint));
        for &follower in chain.iter().rev() {
            if let Some(mimic) = &robot.joints[follower].mimic {
                let (ratio, offset) = (mimic.multiplier * end.ratio, mimic.multiplier * end.offset + mimic.offset);
                end = Following { leader: end.leader, ratio, offset };
            }
            followings[follower] = Some(end);
        }
        chain.clear();
    }
    followings.into_iter().flatten().collect()
}

/// The joint that `joint` follows, if both are joints with one value.
fn checked_leader(robot: &RobotDescription, names: &Names, joint: usize, problems: &mut Vec<Problem>) -> Option<usize> {
    let description = &robot.joints[joint];
    let mimic = description.mimic.as_ref()?;
    let problem =
        |found: String, expected, hint| Problem::error(robot.joint_subject(joint), Part::Mimic, found, expected, hint);
    let one_value = |kind| matches!(kind, JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic);
    const ONE_VALUE: &str = "revolute, continuous or prismatic joints to follow one another";

    let kind = description.kind;
    if !one_value(kind) {
        let problem = problem(
            format!("a {kind} joint with a mimic"),
            ONE_VALUE,
            "take the mimic away, or change the joint's type",
        );
        // A joint that was made fixed and kept its mimic stands still either way.
        problems.push(if kind == JointKind::Fixed { problem.into_warning() } else { problem });
        return None;
    }
    let leader = names.leader[joint]?;
    let kind = robot.joints[leader].kind;
    if !one_value(kind) {
        let found = format!("mimic of joint '{}', which is {kind}", mimic.joint);
        problems.push(problem(found, ONE_VALUE, "take the mimic away, or change the leader's type"));
        return None;
    }
    if mimic.multiplier == 0.0 {
        let found = "mimic multiplier is 0, which locks the joint at the offset".into();
        let problem = problem(found, "a multiplier that is not 0", "make the joint fixed if it shall not move");
        problems.push(problem.into_warning());
    }
    Some(leader)
}

/// Reports the part of `chain` from `first` on, whose last joint follows `first`.
fn report_cycle(robot: &RobotDescription, chain: &[usize], first: usize, problems: &mut Vec<Problem>) {
    let cycle = chain.iter().skip_while(|&&joint| joint != first).chain([&first]);
    let names: Vec<_> = cycle.map(|&joint| format!("'{}'", robot.joints[joint].name)).collect();
    problems.push(Problem::error(
        robot.joint_subject(first),
        Part::Mimic,
        format!("mimic joints follow one another in a circle: {}", abridged(&names)),
        "a chain of mimics that ends at a joint without one",
        "take the mimic of one of these joints away",
    ));
}
