//! Names to numbers.

use std::collections::HashMap;

use crate::model::{Part, Problem, RobotDescription, Subject};

/// What the names of a description refer to.
pub(super) struct Names {
    /// Parent and child link of each joint; none if some link has no name of its own or some joint no known ends.
    pub ends: Option<Vec<(usize, usize)>>,
    /// The joint that each joint follows, where it is known.
    pub leader: Vec<Option<usize>>,
    /// The link that was asked for as root.
    pub root: Option<usize>,
}

/// Looks every name up; reports names that are missing, taken or unknown.
pub(super) fn resolve(robot: &RobotDescription, problems: &mut Vec<Problem>) -> Names {
    let before = problems.len();
    let links =
        index(robot.links.iter().map(|link| link.name.as_str()), |index| robot.link_subject(index), "link", problems);
    let unique = problems.len() == before;
    let joints = index(
        robot.joints.iter().map(|joint| joint.name.as_str()),
        |index| robot.joint_subject(index),
        "joint",
        problems,
    );

    let mut ends = Vec::with_capacity(robot.joints.len());
    for (j, joint) in robot.joints.iter().enumerate() {
        let mut end = |part, role, name: &str| {
            let link = links.get(name).copied();
            if link.is_none() {
                let found = if name.is_empty() { format!("no {role} link") } else { format!("{role} is '{name}'") };
                problems.push(Problem::error(
                    robot.joint_subject(j),
                    part,
                    found,
                    "the name of a link",
                    if name.is_empty() {
                        format!("say which link is the joint's {role}")
                    } else {
                        format!("add a link '{name}', or correct the name")
                    },
                ));
            }
            link
        };
        let parent = end(Part::Parent, "parent", &joint.parent);
        let child = end(Part::Child, "child", &joint.child);
        ends.extend(parent.zip(child));
    }

    let mut leader = Vec::with_capacity(robot.joints.len());
    for (j, joint) in robot.joints.iter().enumerate() {
        leader.push(joint.mimic.as_ref().and_then(|mimic| {
            let leader = joints.get(mimic.joint.as_str()).copied();
            if leader.is_none() {
                let name = &mimic.joint;
                problems.push(Problem::error(
                    robot.joint_subject(j),
                    Part::Mimic,
                    if name.is_empty() { "mimic names no joint".into() } else { format!("mimic of joint '{name}'") },
                    "the name of another joint",
                    "correct the name, or take the mimic away to make the joint a coordinate of its own",
                ));
            }
            leader
        }));
    }

    let root = robot.root.as_ref().and_then(|name| {
        let root = links.get(name.as_str()).copied();
        if root.is_none() {
            problems.push(Problem::error(
                Subject::Robot,
                Part::Whole,
                format!("root is '{name}'"),
                "the name of a link",
                match robot.links.first() {
                    Some(first) => format!("choose one of the links, such as '{}'", first.name),
                    None => "describe its links first".into(),
                },
            ));
        }
        root
    });

    let complete = unique && ends.len() == robot.joints.len();
    Names { ends: complete.then_some(ends), leader, root }
}

/// The position of each name; the first bearer keeps a name that is given twice.
fn index<'a>(
    names: impl Iterator<Item = &'a str>,
    subject: impl Fn(usize) -> Subject,
    what: &str,
    problems: &mut Vec<Problem>,
) -> HashMap<&'a str, usize> {
    let mut index = HashMap::new();
    for (i, name) in names.enumerate() {
        if name.is_empty() {
            problems.push(Problem::error(
                subject(i),
                Part::Name,
                format!("the {what} has no name"),
                "a name",
                format!("give it a name that no other {what} has"),
            ));
        } else if index.contains_key(name) {
            problems.push(Problem::error(
                subject(i),
                Part::Name,
                format!("an earlier {what} has the same name"),
                format!("names that are unique among {what}s"),
                "rename one of them",
            ));
        } else {
            index.insert(name, i);
        }
    }
    index
}
