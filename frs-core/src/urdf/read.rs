//! From elements to a description.

use nalgebra::Vector3;
use roxmltree::{Document, Node};

use super::Options;
use super::values::{Values, children, quoted};
use crate::model::{
    InertialDescription, JointDescription, JointKind, Limits, LinkDescription, Mimic, Part, Problem, RobotDescription,
    Subject,
};
use crate::spatial::{Pose, Symmetric3};

/// What was read.
pub(super) struct Reading<'d, 'i> {
    /// The robot, with harmless values where the text has problems; nothing if the text is not about a robot.
    pub robot: Option<RobotDescription>,
    /// Where its parts stand.
    pub elements: Elements<'d, 'i>,
    /// Problems, with the byte they were found at.
    pub findings: Vec<(usize, Problem)>,
}

/// The elements that a robot was read from.
pub(super) struct Elements<'d, 'i> {
    robot: Node<'d, 'i>,
    links: Vec<Node<'d, 'i>>,
    joints: Vec<Node<'d, 'i>>,
}

/// Reads the robot in a document.
pub(super) fn read<'d, 'i>(document: &'d Document<'i>, options: &Options<'_>) -> Reading<'d, 'i> {
    let root = document.root_element();
    let mut findings = Vec::new();
    findings.extend(foreign(root));
    let elements =
        Elements { robot: root, links: children(root, "link").collect(), joints: children(root, "joint").collect() };
    let robot = findings.is_empty().then(|| RobotDescription {
        name: robot_name(root, options.file),
        links: elements
            .links
            .iter()
            .enumerate()
            .map(|(index, &node)| {
                let name = attribute(node, "name");
                let subject = Subject::Link { index, name: name.clone() };
                LinkDescription { name, inertial: inertial(node, Values { subject, findings: &mut findings }) }
            })
            .collect(),
        joints: elements
            .joints
            .iter()
            .enumerate()
            .map(|(index, &node)| {
                let name = attribute(node, "name");
                let subject = Subject::Joint { index, name };
                joint(node, Values { subject, findings: &mut findings })
            })
            .collect(),
        root: options.root.map(str::to_owned),
        lenient: options.lenient,
    });
    Reading { robot, elements, findings }
}

/// What tells that the document is not a URDF.
fn foreign(root: Node<'_, '_>) -> Option<(usize, Problem)> {
    let element = root.tag_name().name();
    let problem = |node: Node<'_, '_>, found: String, expected: &str, hint: &str| {
        Some((node.range().start, Problem::error(Subject::File, Part::Whole, found, expected, hint)))
    };
    if element != "robot" {
        let hint = match element {
            "sdf" | "world" | "model" => "this looks like SDF: convert it to URDF first",
            "mujoco" | "mujocoinclude" => "this looks like MJCF: convert it to URDF first",
            _ => "is it a URDF file?",
        };
        return problem(root, format!("the root element is <{element}>"), "<robot>", hint);
    }
    let xacro = |node: &Node<'_, '_>| node.tag_name().namespace().is_some_and(|uri| uri.contains("xacro"));
    let macro_ = root.descendants().find(xacro)?;
    problem(
        macro_,
        format!("a macro, <xacro:{}>", macro_.tag_name().name()),
        "plain URDF",
        "expand the file by xacro first",
    )
}

/// The robot's name: its own, or the stem of the file's.
fn robot_name(root: Node<'_, '_>, file: &str) -> String {
    let own = attribute(root, "name");
    let stem = || std::path::Path::new(file).file_stem().and_then(|stem| stem.to_str()).unwrap_or("robot").to_owned();
    if own.is_empty() { stem() } else { own }
}

/// An attribute, trimmed; empty if it is missing.
fn attribute(node: Node<'_, '_>, name: &str) -> String {
    node.attribute(name).unwrap_or_default().trim().to_owned()
}

fn inertial(link: Node<'_, '_>, mut values: Values<'_>) -> InertialDescription {
    let Some(node) = values.child(link, "inertial", Part::Whole) else {
        return InertialDescription::NONE;
    };
    let pose = origin(node, &mut values, Part::CentreOfMass);
    // The harmless mass and inertia are not zero, lest they cause problems that the text does not have.
    let mass = match values.required_child(node, "mass", Part::Mass) {
        Some(mass) => values.required_number(mass, "value", Part::Mass, 1.0),
        None => 1.0,
    };
    let inertia = match values.required_child(node, "inertia", Part::Inertia) {
        Some(inertia) => {
            let mut complete = true;
            let [xx, xy, xz, yy, yz, zz] = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"].map(|name| {
                let number = values.required_number(inertia, name, Part::Inertia, f64::NAN);
                complete &= !number.is_nan();
                number
            });
            if complete { Symmetric3 { xx, xy, xz, yy, yz, zz } } else { Symmetric3::diagonal(Vector3::repeat(1.0)) }
        }
        None => Symmetric3::diagonal(Vector3::repeat(1.0)),
    };
    InertialDescription { mass, com: pose.translation, inertia: inertia.rotated(&pose.rotation) }
}

fn joint(node: Node<'_, '_>, mut values: Values<'_>) -> JointDescription {
    let mut end = |role, part| values.child(node, role, part).map(|end| attribute(end, "link")).unwrap_or_default();
    let (parent, child) = (end("parent", Part::Parent), end("child", Part::Child));
    let kind = kind(node, &mut values);
    let axis = match values.child(node, "axis", Part::Axis) {
        Some(axis) if axis.has_attribute("xyz") => values.vector(axis, "xyz", Part::Axis).unwrap_or([1.0, 0.0, 0.0]),
        Some(axis) => {
            values.missing_attribute(axis, "xyz", Part::Axis, "three numbers");
            [1.0, 0.0, 0.0]
        }
        None => [1.0, 0.0, 0.0],
    };
    let mut limits = Limits::default();
    if let Some(limit) = values.child(node, "limit", Part::Limits) {
        let mut number = |name| values.number(limit, name, Part::Limits);
        limits.lower = number("lower");
        limits.upper = number("upper");
        limits.effort = number("effort");
        limits.velocity = number("velocity");
    }
    if let Some(dynamics) = values.child(node, "dynamics", Part::Dynamics) {
        let mut number = |name| values.number(dynamics, name, Part::Dynamics).unwrap_or_default();
        limits.damping = number("damping");
        limits.friction = number("friction");
    }
    let mimic = values.child(node, "mimic", Part::Mimic).map(|mimic| Mimic {
        joint: attribute(mimic, "joint"),
        multiplier: values.number(mimic, "multiplier", Part::Mimic).unwrap_or(1.0),
        offset: values.number(mimic, "offset", Part::Mimic).unwrap_or_default(),
    });
    JointDescription {
        name: attribute(node, "name"),
        kind,
        parent,
        child,
        origin: origin(node, &mut values, Part::Origin),
        axis: axis.into(),
        limits,
        mimic,
    }
}

fn kind(joint: Node<'_, '_>, values: &mut Values<'_>) -> JointKind {
    let Some(attribute) = joint.attribute_node("type") else {
        values.missing_attribute(joint, "type", Part::Kind, "a joint type");
        return JointKind::Fixed;
    };
    const KINDS: [JointKind; 6] = [
        JointKind::Revolute,
        JointKind::Continuous,
        JointKind::Prismatic,
        JointKind::Fixed,
        JointKind::Planar,
        JointKind::Floating,
    ];
    let word = attribute.value().trim();
    KINDS.into_iter().find(|kind| kind.to_string() == word).unwrap_or_else(|| {
        values.note(
            attribute.range_value().start,
            Part::Kind,
            format!("joint type is {}", quoted(word)),
            KINDS.map(|kind| kind.to_string()).join(", "),
            "choose one of these",
        );
        JointKind::Fixed
    })
}

/// The pose in the `<origin>` of `node`; the identity where there is none.
fn origin(node: Node<'_, '_>, values: &mut Values<'_>, part: Part) -> Pose<f64> {
    let Some(origin) = values.child(node, "origin", part) else {
        return Pose::identity();
    };
    let xyz = values.vector(origin, "xyz", part).unwrap_or_default();
    let rpy = values.vector(origin, "rpy", part).unwrap_or_default();
    Pose::from_rpy(xyz.into(), rpy)
}

impl Elements<'_, '_> {
    /// The byte where the part of the subject that `problem` is about stands; where it is missing, what it is missing in.
    pub fn offset(&self, problem: &Problem) -> usize {
        let node = match problem.subject {
            Subject::File | Subject::Robot => self.robot,
            Subject::Link { index, .. } => self.links[index],
            Subject::Joint { index, .. } => self.joints[index],
        };
        let (path, attribute): (&[&str], &str) = match problem.part {
            Part::Whole => (&[], ""),
            Part::Name => (&[], "name"),
            Part::Mass => (&["inertial", "mass"], "value"),
            Part::CentreOfMass => (&["inertial", "origin"], "xyz"),
            Part::Inertia => (&["inertial", "inertia"], ""),
            Part::Kind => (&[], "type"),
            Part::Parent => (&["parent"], "link"),
            Part::Child => (&["child"], "link"),
            Part::Origin => (&["origin"], ""),
            Part::Axis => (&["axis"], "xyz"),
            Part::Limits => (&["limit"], ""),
            Part::Dynamics => (&["dynamics"], ""),
            Part::Mimic => (&["mimic"], ""),
        };
        let mut found = node;
        for name in path {
            match children(found, name).next() {
                Some(child) => found = child,
                None => return found.range().start,
            }
        }
        found.attribute_node(attribute).map_or(found.range().start, |attribute| attribute.range_value().start)
    }
}
