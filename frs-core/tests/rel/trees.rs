//! Random robots and states of order one: every joint carries its own link, so a failing tree shrinks joint by joint.

use frs_core::model::{
    InertialDescription, JointDescription, JointKind, Limits, LinkDescription, Mimic, RobotDescription,
};
use frs_core::spatial::{Pose, Symmetric3};
use nalgebra::{DVector, Matrix3, Vector3, Vector6};
use proptest::collection::SizeRange;
use proptest::prelude::*;
use proptest::sample::Index;

use crate::algebra::rotation;

/// Most joints a random tree has.
const MOST_JOINTS: usize = 12;

/// A joint's parent is one of this many links before it: trees are deep and branch often.
const PARENTS: usize = 4;

/// Share of the joints that follow another joint, where they can.
const FOLLOWERS: f64 = 0.1;

/// Random robots a property is tried on; the environment variable `PROPTEST_CASES` overrides it.
const CASES: u32 = 256;

/// How often a property is tried; failures print the shrunk case instead of leaving a file behind.
pub fn config() -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(CASES) }
}

/// A robot, a state of it, and the directions a property asks about.
#[derive(Clone, Debug)]
pub struct Case {
    pub robot: RobotDescription,
    pub q: DVector<f64>,
    pub qd: DVector<f64>,
    pub x: DVector<f64>,
    pub y: DVector<f64>,
    pub tau: DVector<f64>,
    /// A locked velocity μ.
    pub mu: Vector6<f64>,
    /// A second base twist, or a direction of μ.
    pub v1: Vector6<f64>,
    /// Wrench on the base, base frame.
    pub wrench: Vector6<f64>,
    /// A pose: of the base in the world, or of a new base frame.
    pub pose: Pose<f64>,
}

/// A random tree with a random state.
pub fn case() -> impl Strategy<Value = Case> {
    case_with(1..=MOST_JOINTS, true)
}

/// A random tree of as many joints as `joints` says, fixed ones included, with or without followers, with a random state.
pub fn case_with(joints: impl Into<SizeRange>, followers: bool) -> impl Strategy<Value = Case> {
    (inertial(), prop::collection::vec(branch(), joints), prop::array::uniform3(six()), pose()).prop_map(
        move |(base, branches, [mu, v1, wrench], pose)| {
            let robot = robot(base, &branches, followers);
            let numbers: Vec<_> = branches.iter().flat_map(|branch| branch.numbers).collect();
            let n = dof(&robot);
            let vector = |of: usize| DVector::from_fn(n, |i, _| numbers[i][of]);
            Case {
                q: vector(0),
                qd: vector(1),
                x: vector(2),
                y: vector(3),
                tau: vector(4),
                mu,
                v1,
                wrench,
                pose,
                robot,
            }
        },
    )
}

/// Number of coordinates of a description.
fn dof(robot: &RobotDescription) -> usize {
    let free = robot.joints.iter().filter(|joint| joint.mimic.is_none());
    free.map(|joint| match joint.kind {
        JointKind::Fixed => 0,
        JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic => 1,
        JointKind::Planar => 3,
        JointKind::Floating => 6,
    })
    .sum()
}

/// A joint with the link it carries.
#[derive(Clone, Debug)]
struct Branch {
    parent: Index,
    kind: JointKind,
    origin: Pose<f64>,
    axis: Vector3<f64>,
    inertial: InertialDescription,
    /// Whether the link is massless, where a massless link is allowed.
    massless: bool,
    /// Leader, multiplier and offset, where a follower is allowed.
    mimic: Option<(Index, f64, f64)>,
    /// Coordinates, rates, two directions and forces, for up to three coordinates.
    numbers: [[f64; 5]; 3],
}

fn branch() -> impl Strategy<Value = Branch> {
    let kind = prop_oneof![
        6 => Just(JointKind::Revolute),
        2 => Just(JointKind::Continuous),
        3 => Just(JointKind::Prismatic),
        2 => Just(JointKind::Fixed),
        1 => Just(JointKind::Planar),
    ];
    let mimic = prop::option::weighted(FOLLOWERS, (any::<Index>(), prop_oneof![-1.5..-0.5, 0.5..1.5], -1.0..1.0));
    let numbers = prop::array::uniform3(prop::array::uniform5(-1.5..1.5));
    (any::<Index>(), kind, pose(), axis(), inertial(), prop::bool::weighted(0.2), mimic, numbers).prop_map(
        |(parent, kind, origin, axis, inertial, massless, mimic, numbers)| Branch {
            parent,
            kind,
            origin,
            axis,
            inertial,
            massless,
            mimic,
            numbers,
        },
    )
}

fn robot(base: InertialDescription, branches: &[Branch], followers: bool) -> RobotDescription {
    let link = |k: usize| if k == 0 { "base".to_owned() } else { format!("link_{k}") };
    let joint = |k: usize| format!("joint_{k}");
    let slender = |branch: &Branch| branch.kind != JointKind::Planar;
    let parent = |(k, branch): (usize, &Branch)| k - branch.parent.index(PARENTS.min(k + 1));
    let parents: Vec<usize> = branches.iter().enumerate().map(parent).collect();

    // A massless link stands between two massive ones, on joints of one degree of freedom.
    let mut massless = vec![false];
    for (k, branch) in branches.iter().enumerate() {
        let mut children = (k + 1..branches.len()).filter(|&child| parents[child] == k + 1);
        let hollow = branch.massless && slender(branch) && !massless[parents[k]];
        massless.push(hollow && children.any(|child| slender(&branches[child])));
    }

    let mut robot = RobotDescription::new("random tree");
    robot.links.push(LinkDescription { name: link(0), inertial: base });
    let mut leaders: Vec<usize> = Vec::new();
    for (k, branch) in branches.iter().enumerate() {
        let number = k + 1;
        let inertial = if massless[number] { InertialDescription::NONE } else { branch.inertial };
        robot.links.push(LinkDescription { name: link(number), inertial });
        let turns_or_slides = matches!(branch.kind, JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic);
        let mimic = branch.mimic.filter(|_| followers && turns_or_slides && !leaders.is_empty()).map(
            |(leader, multiplier, offset)| Mimic {
                joint: joint(leaders[leader.index(leaders.len())]),
                multiplier,
                offset,
            },
        );
        if turns_or_slides {
            leaders.push(number);
        }
        robot.joints.push(JointDescription {
            name: joint(number),
            kind: branch.kind,
            parent: link(parents[k]),
            child: link(number),
            origin: branch.origin,
            axis: branch.axis,
            limits: Limits::default(),
            mimic,
        });
    }
    robot
}

/// A full inertia tensor that a body can have: from second moments of mass, which are positive in every direction.
fn inertial() -> impl Strategy<Value = InertialDescription> {
    let com = prop::array::uniform3(-0.5..0.5);
    let second_moments = prop::array::uniform3(0.02..0.3);
    (0.3..3.0, com, second_moments, angles()).prop_map(
        |(mass, com, [a, b, c], angles): (f64, [f64; 3], [f64; 3], _)| {
            let r = rotation(angles);
            let about_axes = Matrix3::from_diagonal(&Vector3::new(b + c, a + c, a + b));
            let inertia = Symmetric3::from_lower(&(r * about_axes * r.transpose() * mass));
            InertialDescription { mass, com: Vector3::from(com), inertia }
        },
    )
}

fn pose() -> impl Strategy<Value = Pose<f64>> {
    (prop::array::uniform3(-1.0..1.0), angles())
        .prop_map(|(translation, angles)| Pose::new(rotation(angles), Vector3::from(translation)))
}

/// A direction of any length, anywhere on the sphere.
fn axis() -> impl Strategy<Value = Vector3<f64>> {
    (angles(), 0.5..2.0).prop_map(|(angles, length)| rotation(angles) * Vector3::z() * length)
}

fn angles() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-3.0..3.0)
}

fn six() -> impl Strategy<Value = Vector6<f64>> {
    prop::array::uniform6(-1.5..1.5).prop_map(Vector6::from)
}
