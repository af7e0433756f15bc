//! Whether the masses determine every motion.

use super::mimic::Following;
use super::tree::Tree;
use crate::model::{InertialDescription, JointKind, Part, Problem, RobotDescription, Subject};

/// Reports coordinates on one side of which nothing has the mass or inertia that their motion would move.
pub(super) fn check(robot: &RobotDescription, tree: &Tree, followings: &[Following], problems: &mut Vec<Problem>) {
    let inertial = |step: usize| &robot.links[tree.steps[step].link].inertial;
    let masses = Count::new(tree, |step| inertial(step).mass != 0.0);
    let inertias = Count::new(tree, |step| {
        inertial(step).mass != 0.0 || inertial(step).inertia != InertialDescription::NONE.inertia
    });
    if masses.total() == 0 {
        problems.push(Problem::error(
            Subject::Robot,
            Part::Whole,
            "no link has mass",
            "a total mass that is positive",
            "give at least one link an inertial with mass",
        ));
        return;
    }

    let mut determined = vec![false; robot.joints.len()];
    let mut bare = vec![None; robot.joints.len()];
    for (step, via) in tree.steps.iter().enumerate().filter_map(|(step, walked)| Some((step, walked.via?))) {
        let counts = match robot.joints[via.joint].kind {
            JointKind::Revolute | JointKind::Continuous => &inertias,
            JointKind::Prismatic | JointKind::Planar => &masses,
            JointKind::Fixed | JointKind::Floating => continue,
        };
        let Following { leader, ratio, .. } = followings[via.joint];
        let inside = counts.within(step, tree.steps[step].end);
        if inside == 0 {
            bare[via.joint] = Some((step, true));
        } else if inside == counts.total() {
            bare[via.joint] = Some((via.from, false));
        } else if ratio != 0.0 {
            determined[leader] = true;
        }
    }
    for (joint, bare) in bare.into_iter().enumerate() {
        if let Some((step, beyond)) = bare
            && followings[joint].leader == joint
            && !determined[joint]
        {
            report(robot, joint, tree.steps[step].link, beyond, problems);
        }
    }
}

fn report(robot: &RobotDescription, joint: usize, link: usize, beyond: bool, problems: &mut Vec<Problem>) {
    let link = &robot.links[link].name;
    let kind = robot.joints[joint].kind;
    let turns = matches!(kind, JointKind::Revolute | JointKind::Continuous);
    let side = if beyond { "beyond" } else { "on the base's side of" };
    problems.push(Problem::error(
        robot.joint_subject(joint),
        Part::Whole,
        format!(
            "nothing {side} the joint, from link '{link}' on, has {}",
            if turns { "mass or inertia" } else { "mass" }
        ),
        "something to move on both sides of a moving joint, else its motion is undetermined",
        format!("give '{link}' an inertial, or make the joint fixed"),
    ));
}

/// How many of the links up to each step have some property.
struct Count(Vec<usize>);

impl Count {
    fn new(tree: &Tree, has: impl Fn(usize) -> bool) -> Self {
        let mut counts = Vec::with_capacity(tree.steps.len() + 1);
        let mut count = 0;
        counts.push(count);
        for step in 0..tree.steps.len() {
            count += usize::from(has(step));
            counts.push(count);
        }
        Self(counts)
    }

    fn within(&self, start: usize, end: usize) -> usize {
        self.0[end] - self.0[start]
    }

    fn total(&self) -> usize {
        self.within(0, self.0.len() - 1)
    }
}
