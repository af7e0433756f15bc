//! Numbers that no robot can have.

use nalgebra::{Matrix3, Vector3};

use super::wording::{plain, rounded};
use crate::model::{
    InertialDescription, JointDescription, JointKind, LinkDescription, Part, Problem, RobotDescription, Subject,
};
use crate::spatial::{Pose, Symmetric3};

/// Magnitude beyond which a number is a mistake; the products of up to ten such numbers stay finite.
const LARGEST: f64 = 1e30;

/// Mass, kg, below which a mass that is not 0 is a mistake: its reciprocal must stay finite in products too.
const LIGHTEST: f64 = 1e-30;

/// Part of the largest principal moment by which a smaller one may be negative, or by which the largest may exceed the
/// sum of the others: URDFs print inertias with few digits.
const ROUNDING_OF_INERTIAS: f64 = 1e-3;

/// Size, m, below which a body is a point: smaller inertias than that size gives are what computing zero left.
const POINT: f64 = 1e-6;

/// Largest entry of `RᵀR − 1` for which `R` still counts as a rotation: what single precision leaves.
const ROUNDING_OF_ROTATIONS: f64 = 1e-6;

/// Checks every number of every link and joint by itself.
pub(super) fn check(robot: &RobotDescription, problems: &mut Vec<Problem>) {
    for (index, link) in robot.links.iter().enumerate() {
        let checked = check_link(link, &|| robot.link_subject(index), robot.lenient);
        problems.extend(checked.into_iter().flatten());
    }
    for (index, joint) in robot.joints.iter().enumerate() {
        let checked = check_joint(joint, &|| robot.joint_subject(index));
        problems.extend(checked.into_iter().flatten());
    }
}

fn check_link(link: &LinkDescription, subject: &dyn Fn() -> Subject, lenient: bool) -> [Option<Problem>; 3] {
    let inertial = &link.inertial;
    let Symmetric3 { xx, xy, xz, yy, yz, zz } = inertial.inertia;
    [
        usual(subject, Part::CentreOfMass, "centre of mass", inertial.com.as_slice()),
        usual(subject, Part::Mass, "mass", &[inertial.mass]).or_else(|| weighing(subject, inertial.mass)),
        usual(subject, Part::Inertia, "inertia (xx xy xz yy yz zz)", &[xx, xy, xz, yy, yz, zz])
            .or_else(|| physical(subject, inertial, lenient)),
    ]
}

fn check_joint(joint: &JointDescription, subject: &dyn Fn() -> Subject) -> [Option<Problem>; 5] {
    let limits = &joint.limits;
    let bounds: Vec<f64> = [limits.lower, limits.upper, limits.effort, limits.velocity].into_iter().flatten().collect();
    let losses = [limits.damping, limits.friction, limits.rotor_inertia];
    let mimic: &[f64] = match &joint.mimic {
        Some(mimic) => &[mimic.multiplier, mimic.offset],
        None => &[],
    };
    [
        usual(subject, Part::Origin, "origin", joint.origin.translation.as_slice())
            .or_else(|| usual(subject, Part::Origin, "orientation of the origin", joint.origin.rotation.as_slice()))
            .or_else(|| rotating(subject, &joint.origin)),
        usual(subject, Part::Axis, "axis", joint.axis.as_slice()).or_else(|| pointing(subject, joint)),
        usual(subject, Part::Limits, "limit", &bounds),
        usual(subject, Part::Dynamics, "dynamics (damping friction rotor-inertia)", &losses),
        usual(subject, Part::Mimic, "mimic (multiplier offset)", mimic),
    ]
}

/// Neither NaN nor infinite nor astronomical.
fn usual(subject: &dyn Fn() -> Subject, part: Part, what: &str, numbers: &[f64]) -> Option<Problem> {
    // A NaN is not within the bounds either.
    if numbers.iter().all(|number| number.abs() <= LARGEST) {
        return None;
    }
    let finite = numbers.iter().all(|number| number.is_finite());
    Some(Problem::error(
        subject(),
        part,
        format!("{what} is {}", plain(numbers)),
        if finite { format!("magnitudes up to {LARGEST:e}") } else { "finite numbers".into() },
        "write plain numbers in kg, m, rad and s",
    ))
}

/// Zero, or a mass that can be divided by.
fn weighing(subject: &dyn Fn() -> Subject, mass: f64) -> Option<Problem> {
    if mass == 0.0 || mass >= LIGHTEST {
        return None;
    }
    Some(Problem::error(
        subject(),
        Part::Mass,
        format!("mass is {}", plain(&[mass])),
        if mass < 0.0 { "a mass that is not negative".into() } else { format!("0, or at least {LIGHTEST:e}") },
        "correct it, or write 0 for a link without mass",
    ))
}

/// A real body's: principal moments that are not negative, none larger than the sum of the other two.
fn physical(subject: &dyn Fn() -> Subject, inertial: &InertialDescription, lenient: bool) -> Option<Problem> {
    let [smallest, middle, largest] = principal_moments(inertial.inertia);
    let tolerance = ROUNDING_OF_INERTIAS * largest.max(-smallest) + inertial.mass.abs() * POINT * POINT;
    let problem = |expected: String, hint: &str| {
        let found = format!("inertia has the principal moments {}", plain(&[smallest, middle, largest].map(rounded)));
        Problem::error(subject(), Part::Inertia, found, expected, hint)
    };
    if smallest < -tolerance {
        return Some(problem(
            "moments that are not negative".into(),
            "correct the inertia: it is about the centre of mass, with the products ixy = −∫xy dm and so on",
        ));
    }
    if largest > smallest + middle + tolerance {
        let problem = problem(
            format!("the largest to be at most the sum of the other two, {}", plain(&[rounded(smallest + middle)])),
            "correct the inertia, which no body can have; lenient reading makes this a warning",
        );
        return Some(if lenient { problem.into_warning() } else { problem });
    }
    None
}

/// The eigenvalues, smallest first, in closed form (Smith, 1961): no iteration that could fail to end.
fn principal_moments(inertia: Symmetric3<f64>) -> [f64; 3] {
    let scale = inertia.to_matrix().amax();
    if scale == 0.0 {
        return [0.0; 3];
    }
    let scaled = inertia.to_matrix() / scale;
    let mean = scaled.trace() / 3.0;
    let deviator = scaled - Matrix3::from_diagonal_element(mean);
    let spread = (deviator.norm_squared() / 6.0).sqrt();
    let angle =
        if spread > 0.0 { ((deviator / spread).determinant() / 2.0).clamp(-1.0, 1.0).acos() / 3.0 } else { 0.0 };
    let largest = mean + 2.0 * spread * angle.cos();
    let smallest = mean + 2.0 * spread * (angle + std::f64::consts::TAU / 3.0).cos();
    [smallest, 3.0 * mean - largest - smallest, largest].map(|moment| moment * scale)
}

/// A proper rotation.
fn rotating(subject: &dyn Fn() -> Subject, origin: &Pose<f64>) -> Option<Problem> {
    let r = &origin.rotation;
    let defect = (r.transpose() * r - Matrix3::identity()).amax();
    if defect <= ROUNDING_OF_ROTATIONS && r.determinant() > 0.0 {
        return None;
    }
    let det = r.determinant();
    Some(Problem::error(
        subject(),
        Part::Origin,
        format!("the orientation of the origin is no rotation matrix: RᵀR is off by {defect}, det R is {det}"),
        "a rotation matrix",
        "make the origin with Pose::from_rpy",
    ))
}

/// An axis, where the joint has use for one.
fn pointing(subject: &dyn Fn() -> Subject, joint: &JointDescription) -> Option<Problem> {
    if joint.axis != Vector3::zeros() || matches!(joint.kind, JointKind::Fixed | JointKind::Floating) {
        return None;
    }
    Some(Problem::error(
        subject(),
        Part::Axis,
        "axis is 0 0 0",
        "a direction",
        "name the axis of motion in the child link's frame, such as 0 0 1",
    ))
}
