//! The tree that links and joints form, walked from the root link.

use super::names::Names;
use super::wording::abridged;
use crate::model::{InertialDescription, JointKind, Part, Problem, RobotDescription, Subject};

/// The links in the order in which they are walked: depth first from the root, joints in the order of description.
pub(super) struct Tree {
    /// One step per link; the root's comes first.
    pub steps: Vec<Step>,
}

/// A link, as it is met on the walk.
pub(super) struct Step {
    /// Number of the link in the description.
    pub link: usize,
    /// One past the last step that lies beyond this one: the subtree of step k is `k..end`.
    pub end: usize,
    /// How we came here; nothing for the root.
    pub via: Option<Via>,
}

/// The joint that a step crosses.
#[derive(Clone, Copy)]
pub(super) struct Via {
    /// Number of the joint in the description.
    pub joint: usize,
    /// Whether it is crossed from its child to its parent.
    pub reversed: bool,
    /// The step that we came from.
    pub from: usize,
}

/// Walks the tree; reports whatever keeps links and joints from being one.
pub(super) fn grow(robot: &RobotDescription, names: &Names, problems: &mut Vec<Problem>) -> Option<Tree> {
    let ends = names.ends.as_ref()?;
    let before = problems.len();
    let above = joints_above(robot, ends, problems);
    report_loops(robot, ends, &above, problems);
    let top = single_top(robot, ends, &above, problems);
    if problems.len() > before {
        return None;
    }
    let top = top?;
    let free = free_joint(robot, ends, top, problems);
    if problems.len() > before {
        return None;
    }
    let base = free.map_or(top, |joint| ends[joint].1);
    let root = names.root.filter(|&root| free.is_none() || root != top).unwrap_or(base);
    Some(walk(robot.links.len(), ends, root, free))
}

/// The joint whose child each link is; reports links with two.
fn joints_above(robot: &RobotDescription, ends: &[(usize, usize)], problems: &mut Vec<Problem>) -> Vec<Option<usize>> {
    let mut above: Vec<Option<usize>> = vec![None; robot.links.len()];
    for (joint, &(_, child)) in ends.iter().enumerate() {
        match above[child] {
            None => above[child] = Some(joint),
            Some(first) => problems.push(Problem::error(
                robot.joint_subject(joint),
                Part::Child,
                format!(
                    "link '{}' is the child of joint '{}' already",
                    robot.links[child].name, robot.joints[first].name
                ),
                "links that are the child of one joint at most",
                "take one of the joints away: a kinematic loop must be cut open",
            )),
        }
    }
    above
}

/// Reports each circle of joints, at the first of its joints in the order of description.
fn report_loops(
    robot: &RobotDescription,
    ends: &[(usize, usize)],
    above: &[Option<usize>],
    problems: &mut Vec<Problem>,
) {
    // The walk upwards on which each link was met first.
    let mut met: Vec<Option<usize>> = vec![None; robot.links.len()];
    for start in 0..robot.links.len() {
        let mut link = start;
        while met[link].is_none()
            && let Some(joint) = above[link]
        {
            met[link] = Some(start);
            link = ends[joint].0;
        }
        if met[link] != Some(start) {
            continue;
        }
        let mut circle = Vec::new();
        let mut at = link;
        while let Some(joint) = above[at] {
            circle.push(joint);
            at = ends[joint].0;
            if at == link {
                break;
            }
        }
        let joints: Vec<String> = circle.iter().rev().map(|&joint| format!("'{}'", robot.joints[joint].name)).collect();
        let first = circle.iter().copied().min().unwrap_or_default();
        problems.push(Problem::error(
            robot.joint_subject(first),
            Part::Whole,
            format!("a loop of the joints {}", abridged(&joints)),
            "a tree of links",
            "take one of these joints away, or give it another parent",
        ));
    }
}

/// The one link that is nobody's child; reports the others.
fn single_top(
    robot: &RobotDescription,
    ends: &[(usize, usize)],
    above: &[Option<usize>],
    problems: &mut Vec<Problem>,
) -> Option<usize> {
    let mut is_parent = vec![false; robot.links.len()];
    for &(parent, _) in ends {
        is_parent[parent] = true;
    }
    let tops: Vec<usize> = (0..robot.links.len()).filter(|&link| above[link].is_none()).collect();
    let top = tops.iter().copied().find(|&link| is_parent[link]).or(tops.first().copied());
    match top {
        None if robot.links.is_empty() => problems.push(Problem::error(
            Subject::Robot,
            Part::Whole,
            "the robot has no link",
            "at least one link",
            "describe its links",
        )),
        // Every link is somebody's child: a loop, which was told.
        None => {}
        Some(top) => {
            for other in tops.into_iter().filter(|&link| link != top) {
                let (name, top) = (&robot.links[other].name, &robot.links[top].name);
                problems.push(Problem::error(
                    robot.link_subject(other),
                    Part::Name,
                    if is_parent[other] {
                        format!("a second root: like '{top}', it is nobody's child")
                    } else {
                        "no joint connects the link".into()
                    },
                    "one tree with one root",
                    format!("connect it with a joint whose child is '{name}', or take it away"),
                ));
            }
        }
    }
    top
}

/// The floating joint out of a world link `top`, if that is what there is; reports floating joints elsewhere.
fn free_joint(
    robot: &RobotDescription,
    ends: &[(usize, usize)],
    top: usize,
    problems: &mut Vec<Problem>,
) -> Option<usize> {
    let world = &robot.links[top].inertial;
    let weightless = world.mass == 0.0 && world.inertia == InertialDescription::NONE.inertia;
    let children = ends.iter().filter(|(parent, _)| *parent == top).count();
    let mut free = None;
    for (joint, description) in robot.joints.iter().enumerate().filter(|(_, joint)| joint.kind == JointKind::Floating) {
        if ends[joint].0 == top && children == 1 && weightless {
            free = Some(joint);
            continue;
        }
        let parent = &description.parent;
        problems.push(Problem::error(
            robot.joint_subject(joint),
            Part::Kind,
            match (ends[joint].0 == top, weightless) {
                (false, _) => format!("floating joint out of '{parent}', which is not the root link"),
                (true, false) => format!("floating joint out of '{parent}', which has mass or inertia"),
                (true, true) => format!("floating joint out of '{parent}', which has other children too"),
            },
            "floating joints only out of a massless root link without other children, the world",
            "take the joint away, since the base floats anyway, or describe two robots",
        ));
    }
    free
}

/// Walks depth first from `root` over all joints but `closed`.
fn walk(links: usize, ends: &[(usize, usize)], root: usize, closed: Option<usize>) -> Tree {
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); links];
    for (joint, &(parent, child)) in ends.iter().enumerate().filter(|(joint, _)| Some(*joint) != closed) {
        around[parent].push(joint);
        around[child].push(joint);
    }
    let mut steps: Vec<Step> = Vec::with_capacity(links);
    let mut ahead = vec![(root, None)];
    while let Some((link, via)) = ahead.pop() {
        let from = steps.len();
        steps.push(Step { link, end: from + 1, via });
        let came = via.map(|via: Via| via.joint);
        for &joint in around[link].iter().rev().filter(|&&joint| Some(joint) != came) {
            let (parent, child) = ends[joint];
            let reversed = child == link;
            ahead.push((if reversed { parent } else { child }, Some(Via { joint, reversed, from })));
        }
    }
    for k in (1..steps.len()).rev() {
        if let Some(via) = steps[k].via {
            steps[via.from].end = steps[via.from].end.max(steps[k].end);
        }
    }
    Tree { steps }
}
