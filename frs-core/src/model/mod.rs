//! A robot as data.
//!
//! A [`Model`] is made by [`RobotDescription::build`], which checks everything; once it exists nothing in it can fail.
//! It knows no dynamics.
//!
//! *Links* are what the user named; *bodies* are what moves: links joined by fixed joints are one body. Body 0 is the
//! base, body k > 0 is driven by the joint towards its parent. Bodies are numbered depth first, so the subtree of body k
//! is the contiguous range `k..end_k` and a parent's number is lower than its children's. Inside the model every joint
//! acts along or about the z axis of its body's own frame; a link's frame stands in its body's frame at a constant
//! placement.

mod builder;
mod description;
mod error;
mod inertial;
mod specialise;
mod tables;

pub use description::{
    InertialDescription, JointDescription, JointKind, Limits, LinkDescription, Mimic, RobotDescription,
};
pub(crate) use error::Lines;
pub use error::{ModelError, Part, Place, Problem, Severity, Subject};
pub use inertial::Inertial;
pub use specialise::SpecialiseError;
pub use tables::{BodyTable, LinkTable, Tables};

use nalgebra::{Matrix3, Vector3};

use crate::Real;
use crate::spatial::{Pose, Symmetric3};

/// How a body moves relative to its parent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// About the body's z axis; the coordinate is in radians.
    Revolute,
    /// Along the body's z axis; the coordinate is in metres.
    Prismatic,
}

/// One moving body and, unless it is the base, the joint that drives it.
#[derive(Clone, Debug)]
pub struct Body<T: Real = f64> {
    /// Number of the parent body; the base is its own parent.
    pub parent: usize,
    /// One past the last body of the subtree: the subtree of body k is `k..end`.
    pub end: usize,
    /// How the joint moves; unused for the base.
    pub motion: Motion,
    /// Pose of the body's frame in its parent's frame at joint value 0.
    pub placement: Pose<T>,
    /// Which coordinate drives the joint, and how: joint value = `ratio·q[coordinate] + offset`.
    pub drive: Drive<T>,
    /// Mass, kg.
    pub mass: T,
    /// Centre of mass in the body's frame, m.
    pub com: Vector3<T>,
    /// Rotational inertia about the centre of mass, axes of the body's frame, kg·m².
    pub inertia: Symmetric3<T>,
    /// The axis (0, 1, 2) about which the inertia of the description was least; it stays where a payload changes the inertia.
    pub least_moment: usize,
}

impl<T: Real> Body<T> {
    /// The joint's value (rad or m) at shape `q`.
    #[inline(always)]
    pub(crate) fn value(&self, q: &[T]) -> T {
        q[self.drive.coordinate] * self.drive.ratio + self.drive.offset
    }
}

/// How a coordinate drives a joint: joint value = `ratio·q[coordinate] + offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive<T: Real = f64> {
    /// Column of the coordinate.
    pub coordinate: usize,
    /// Multiplier; 1 for a joint that is its own coordinate, the mimic multiplier for a follower, 0 for a held joint.
    pub ratio: T,
    /// Offset; 0 for a joint that is its own coordinate, the value of a held joint.
    pub offset: T,
}

/// A link of the description: a frame that stands still in a body, and what it weighs.
#[derive(Clone, Debug)]
pub struct Link<T: Real = f64> {
    /// Name.
    pub name: String,
    /// Number of the body it belongs to.
    pub body: usize,
    /// Pose of the link's frame in the body's frame.
    pub placement: Pose<T>,
    /// The link's share of the body's mass; zero for a frame without mass.
    pub inertial: Inertial<T>,
    /// Whether the link has mass, which numbers without a value cannot tell.
    massive: bool,
    /// Where the link's frame stands in the frame in which the body is weighed: in the root link's for the base, elsewhere
    /// in the body's own, where it is `placement.translation`.
    weighed_at: Vector3<T>,
}

/// A generalised coordinate, one column of every matrix.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Name: the joint's, or `<joint>_x`, `<joint>_y`, `<joint>_yaw` for the three of a planar joint.
    pub name: String,
    /// Body whose joint this coordinate drives directly (mimic followers are driven too).
    pub body: usize,
    /// Limits, effort, damping, friction and rotor inertia: kept for whoever needs them.
    pub limits: Limits,
    /// Whether the joint may turn without limit.
    pub continuous: bool,
}

/// An immutable robot, checked when it was built. Cheap to share: nothing in it changes.
///
/// ```
/// let model = frs_core::Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// assert_eq!(model.dof(), 7);
/// assert_eq!(model.coordinates()[0].name, "joint_1");
/// # Ok::<(), frs_core::urdf::UrdfError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Model<T: Real = f64> {
    name: String,
    bodies: Vec<Body<T>>,
    links: Vec<Link<T>>,
    coordinates: Vec<Coordinate>,
    has_mimic: bool,
    warnings: Vec<Problem>,
}

impl<T: Real> Model<T> {
    /// The robot's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Number n of coordinates: the columns of `A_l`, `Λ_q`, ….
    pub fn dof(&self) -> usize {
        self.coordinates.len()
    }

    /// The bodies, base first, depth first.
    pub fn bodies(&self) -> &[Body<T>] {
        &self.bodies
    }

    /// Number of joints: bodies but the base. More than coordinates where a joint follows another one.
    pub fn joints(&self) -> usize {
        self.bodies.len() - 1
    }

    /// The links; `links()[0]` is the root link, whose frame is the base frame.
    pub fn links(&self) -> &[Link<T>] {
        &self.links
    }

    /// The coordinates, in the order of the columns.
    pub fn coordinates(&self) -> &[Coordinate] {
        &self.coordinates
    }

    /// The number of the link called `name`.
    pub fn link(&self, name: &str) -> Option<usize> {
        self.links.iter().position(|link| link.name == name)
    }

    /// Whether some joint follows another one or is held, so that joints and coordinates differ.
    pub fn has_mimic(&self) -> bool {
        self.has_mimic
    }

    /// What is odd about the robot without keeping it from being one.
    pub fn warnings(&self) -> &[Problem] {
        &self.warnings
    }

    /// The same robot with these warnings.
    pub(crate) fn with_warnings(self, warnings: Vec<Problem>) -> Self {
        Self { warnings, ..self }
    }

    /// Where the base frame (the root link's) stands in the base body's own frame, whose origin is the centre of mass with
    /// which the base was built: far-away root frames do not cost accuracy.
    pub(crate) fn root_offset(&self) -> Vector3<T> {
        self.links[0].placement.translation
    }

    /// The same robot over another scalar; every constant is lifted by [`Real::from_f64`] through `lift`.
    pub fn map<U: Real>(&self, lift: impl Fn(T) -> U) -> Model<U> {
        let vector = |v: &Vector3<T>| Vector3::new(lift(v.x), lift(v.y), lift(v.z));
        let pose = |p: &Pose<T>| Pose::new(Matrix3::from_fn(|r, c| lift(p.rotation[(r, c)])), vector(&p.translation));
        let symmetric = |m: &Symmetric3<T>| Symmetric3 {
            xx: lift(m.xx),
            xy: lift(m.xy),
            xz: lift(m.xz),
            yy: lift(m.yy),
            yz: lift(m.yz),
            zz: lift(m.zz),
        };
        Model {
            name: self.name.clone(),
            bodies: self
                .bodies
                .iter()
                .map(|body| Body {
                    parent: body.parent,
                    end: body.end,
                    motion: body.motion,
                    placement: pose(&body.placement),
                    drive: Drive {
                        coordinate: body.drive.coordinate,
                        ratio: lift(body.drive.ratio),
                        offset: lift(body.drive.offset),
                    },
                    mass: lift(body.mass),
                    com: vector(&body.com),
                    inertia: symmetric(&body.inertia),
                    least_moment: body.least_moment,
                })
                .collect(),
            links: self
                .links
                .iter()
                .map(|link| Link {
                    name: link.name.clone(),
                    body: link.body,
                    placement: pose(&link.placement),
                    inertial: Inertial {
                        mass: lift(link.inertial.mass),
                        com: vector(&link.inertial.com),
                        inertia: symmetric(&link.inertial.inertia),
                    },
                    massive: link.massive,
                    weighed_at: vector(&link.weighed_at),
                })
                .collect(),
            coordinates: self.coordinates.clone(),
            has_mimic: self.has_mimic,
            warnings: self.warnings.clone(),
        }
    }

    /// The same robot with rotations that are orthonormal to this scalar's digits, not only to those of a double.
    ///
    /// For scalars wider than `f64`, after [`Model::cast`].
    pub fn orthonormalised(mut self) -> Self {
        self.bodies.iter_mut().for_each(|body| body.placement = body.placement.orthonormalised());
        self.links.iter_mut().for_each(|link| link.placement = link.placement.orthonormalised());
        self
    }
}

impl Model<f64> {
    /// The same robot over the scalar `U`.
    pub fn cast<U: Real>(&self) -> Model<U> {
        self.map(U::from_f64)
    }
}
