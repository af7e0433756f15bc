//! What a robot is described by, before it is checked: links and joints as a URDF names them.

use std::fmt;

use nalgebra::Vector3;

use super::{Inertial, Model, ModelError, Subject, builder};
use crate::spatial::Pose;

/// A robot as links and joints; [`build`](Self::build) checks it and makes a [`Model`].
///
/// ```
/// use frs_core::model::{InertialDescription, JointKind, RobotDescription};
/// use frs_core::spatial::{Pose, Symmetric3};
/// use nalgebra::Vector3;
///
/// let solid = |mass: f64| InertialDescription {
///     mass,
///     com: Vector3::zeros(),
///     inertia: Symmetric3::diagonal(Vector3::repeat(0.1 * mass)),
/// };
/// let mut robot = RobotDescription::new("beanie");
/// robot.link("base", solid(2.0));
/// robot.link("rotor", solid(1.0));
/// robot.joint("spin", JointKind::Revolute, "base", "rotor").axis(0.0, 0.0, 1.0);
/// let model = robot.build()?;
/// assert_eq!(model.dof(), 1);
/// # Ok::<(), frs_core::model::ModelError>(())
/// ```
#[derive(Clone, Debug)]
pub struct RobotDescription {
    /// Name of the robot.
    pub name: String,
    /// Links, in the order in which they were described.
    pub links: Vec<LinkDescription>,
    /// Joints, in the order in which they were described.
    pub joints: Vec<JointDescription>,
    /// The link to take as base; by default the one link that is nobody's child.
    pub root: Option<String>,
    /// Whether a rotational inertia that violates the triangle inequality is a warning instead of an error.
    pub lenient: bool,
}

/// A link: a name and what it weighs.
#[derive(Clone, Debug)]
pub struct LinkDescription {
    /// Name, unique among links.
    pub name: String,
    /// Mass distribution; `InertialDescription::NONE` for a link without one.
    pub inertial: InertialDescription,
}

/// A link's mass distribution in numbers.
pub type InertialDescription = Inertial<f64>;

/// A joint: how the child link moves in the parent link.
#[derive(Clone, Debug)]
pub struct JointDescription {
    /// Name, unique among joints.
    pub name: String,
    /// Kind of motion.
    pub kind: JointKind,
    /// Name of the parent link.
    pub parent: String,
    /// Name of the child link.
    pub child: String,
    /// Pose of the child link's frame in the parent link's frame at joint value 0.
    pub origin: Pose<f64>,
    /// Axis of motion in the child link's frame, of any nonzero length; for a planar joint the normal of the plane.
    pub axis: Vector3<f64>,
    /// Limits, effort, damping, friction, rotor inertia.
    pub limits: Limits,
    /// The joint whose value this one follows.
    pub mimic: Option<Mimic>,
}

/// How a joint moves. Mimic is not a kind: any revolute, continuous or prismatic joint can follow another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// Turns about the axis between limits.
    Revolute,
    /// Turns about the axis without limits.
    Continuous,
    /// Slides along the axis.
    Prismatic,
    /// Does not move: the links are one body.
    Fixed,
    /// Slides in the plane normal to the axis and turns about it: three coordinates.
    Planar,
    /// Free in space: allowed only out of a massless root link, which it makes the world.
    Floating,
}

/// What a URDF says of a joint's actuation and bounds; the dynamics of the rigid bodies do not depend on it.
///
/// By default: no bounds, no losses, no rotor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// Lower bound of the joint value, rad or m.
    pub lower: Option<f64>,
    /// Upper bound of the joint value, rad or m.
    pub upper: Option<f64>,
    /// Largest torque or force, N·m or N.
    pub effort: Option<f64>,
    /// Largest rate, rad/s or m/s.
    pub velocity: Option<f64>,
    /// Viscous damping, N·m·s/rad or N·s/m.
    pub damping: f64,
    /// Coulomb friction, N·m or N.
    pub friction: f64,
    /// Inertia of the rotor, seen through the gear, kg·m² or kg.
    pub rotor_inertia: f64,
}

/// A true kinematic constraint: value = `multiplier` × the leader's value + `offset`.
#[derive(Clone, Debug, PartialEq)]
pub struct Mimic {
    /// Name of the leading joint.
    pub joint: String,
    /// Multiplier.
    pub multiplier: f64,
    /// Offset, rad or m.
    pub offset: f64,
}

impl RobotDescription {
    /// A robot called `name`, without links yet.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), links: Vec::new(), joints: Vec::new(), root: None, lenient: false }
    }

    /// Adds a link.
    pub fn link(&mut self, name: impl Into<String>, inertial: InertialDescription) -> &mut Self {
        self.links.push(LinkDescription { name: name.into(), inertial });
        self
    }

    /// Adds a joint between two links, which may be added later; origin identity and axis x until told otherwise.
    pub fn joint(
        &mut self,
        name: impl Into<String>,
        kind: JointKind,
        parent: impl Into<String>,
        child: impl Into<String>,
    ) -> &mut JointDescription {
        self.joints.push(JointDescription {
            name: name.into(),
            kind,
            parent: parent.into(),
            child: child.into(),
            origin: Pose::identity(),
            axis: Vector3::x(),
            limits: Limits::default(),
            mimic: None,
        });
        let last = self.joints.len() - 1;
        &mut self.joints[last]
    }

    /// Checks the robot and makes its [`Model`].
    ///
    /// # Errors
    /// All that is wrong with the robot, at once.
    pub fn build(&self) -> Result<Model, ModelError> {
        builder::build(self)
    }

    /// Link `index` as the subject of a problem.
    pub(crate) fn link_subject(&self, index: usize) -> Subject {
        Subject::Link { index, name: self.links[index].name.clone() }
    }

    /// Joint `index` as the subject of a problem.
    pub(crate) fn joint_subject(&self, index: usize) -> Subject {
        Subject::Joint { index, name: self.joints[index].name.clone() }
    }
}

impl JointDescription {
    /// Sets the axis of motion, in the child link's frame; any nonzero length.
    pub fn axis(&mut self, x: f64, y: f64, z: f64) -> &mut Self {
        self.axis = Vector3::new(x, y, z);
        self
    }

    /// Sets the pose of the child link's frame in the parent link's frame at joint value 0.
    pub fn origin(&mut self, origin: Pose<f64>) -> &mut Self {
        self.origin = origin;
        self
    }

    /// Sets the limits.
    pub fn limits(&mut self, limits: Limits) -> &mut Self {
        self.limits = limits;
        self
    }

    /// Makes this joint follow `joint`: value = `multiplier` × its value + `offset`.
    pub fn mimic(&mut self, joint: impl Into<String>, multiplier: f64, offset: f64) -> &mut Self {
        self.mimic = Some(Mimic { joint: joint.into(), multiplier, offset });
        self
    }
}

impl fmt::Display for JointKind {
    /// The word that a URDF uses.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Revolute => "revolute",
            Self::Continuous => "continuous",
            Self::Prismatic => "prismatic",
            Self::Fixed => "fixed",
            Self::Planar => "planar",
            Self::Floating => "floating",
        })
    }
}
