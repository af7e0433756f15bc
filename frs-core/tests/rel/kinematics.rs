//! How every link of a description moves relative to its base: poses, body Jacobians and their rates, link by link.

use frs_core::model::{JointDescription, JointKind, RobotDescription};
use frs_core::spatial::Pose;
use nalgebra::{DVector, Matrix3, Matrix6xX, Rotation3, Vector3, Vector6};

use crate::algebra::{ad, adjoint_inverse, six};

/// A link's motion relative to the base, everything in the link's own frame.
#[derive(Clone, Debug)]
pub struct LinkMotion {
    pub rotation: Matrix3<f64>,
    pub translation: Vector3<f64>,
    /// Body Jacobian J_k, 6×n.
    pub jacobian: Matrix6xX<f64>,
    /// dJ_k/dt at the rate q̇.
    pub jacobian_rate: Matrix6xX<f64>,
}

/// One rigid displacement on the way from the base to a link: a constant one, or a motion along a screw.
struct Step {
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
    screw: Vector6<f64>,
    /// Row of the constant matrix G that takes rates of coordinates to rates of joints.
    drive: DVector<f64>,
}

/// The description's links, in its order, relative to its root link, at `q` and `q̇` of the named coordinates.
pub fn kinematics(
    robot: &RobotDescription,
    coordinates: &[String],
    q: &DVector<f64>,
    qd: &DVector<f64>,
) -> Vec<LinkMotion> {
    let names = robot.links.iter().map(|link| link.name.as_str());
    let from_top = |name: &str| follow(&path(robot, coordinates, q, name), qd);
    let top = names.clone().find(|name| robot.joints.iter().all(|joint| joint.child != *name)).expect("a top link");
    let base = from_top(robot.root.as_deref().unwrap_or(top));
    names.map(|name| relative(&from_top(name), &base, qd)).collect()
}

/// The motion of a link relative to the base, from the motions of both relative to the top of the tree.
fn relative(link: &LinkMotion, base: &LinkMotion, qd: &DVector<f64>) -> LinkMotion {
    let rotation = base.rotation.transpose() * link.rotation;
    let translation = base.rotation.transpose() * (link.translation - base.translation);
    let seen = adjoint_inverse(&rotation, &translation);
    let jacobian = &link.jacobian - seen * &base.jacobian;
    let velocity = &jacobian * qd;
    let jacobian_rate = &link.jacobian_rate + ad(&velocity) * seen * &base.jacobian - seen * &base.jacobian_rate;
    LinkMotion { rotation, translation, jacobian, jacobian_rate }
}

/// Walks from a link back to the top of the tree and collects what each step does to the link.
fn follow(path: &[Step], qd: &DVector<f64>) -> LinkMotion {
    let n = qd.len();
    let (mut rotation, mut translation) = (Matrix3::identity(), Vector3::zeros());
    let (mut jacobian, mut jacobian_rate) = (Matrix6xX::zeros(n), Matrix6xX::zeros(n));
    // Velocity of the link relative to the step's frame, in the link's frame.
    let mut velocity = Vector6::zeros();
    for step in path.iter().rev() {
        let column = adjoint_inverse(&rotation, &translation) * step.screw;
        jacobian += column * step.drive.transpose();
        jacobian_rate -= ad(&velocity) * column * step.drive.transpose();
        velocity += column * step.drive.dot(qd);
        translation = step.rotation * translation + step.translation;
        rotation = step.rotation * rotation;
    }
    LinkMotion { rotation, translation, jacobian, jacobian_rate }
}

fn path(robot: &RobotDescription, coordinates: &[String], q: &DVector<f64>, link: &str) -> Vec<Step> {
    let Some(joint) = robot.joints.iter().find(|joint| joint.child == link) else { return Vec::new() };
    let mut steps = path(robot, coordinates, q, &joint.parent);
    let still = DVector::zeros(q.len());
    let Pose { rotation, translation } = joint.origin;
    steps.push(Step { rotation, translation, screw: Vector6::zeros(), drive: still });
    for (screw, name) in motions(joint) {
        let (drive, offset) = drive(robot, joint, coordinates, &name);
        let value = drive.dot(q) + offset;
        let (angular, linear) = (screw.fixed_rows::<3>(0), screw.fixed_rows::<3>(3));
        let rotation = Rotation3::from_scaled_axis(angular * value).into_inner();
        steps.push(Step { rotation, translation: linear * value, screw, drive });
    }
    steps
}

/// The screws of a joint in the child's frame, each with the name of its coordinate; a screw turns or slides.
pub fn motions(joint: &JointDescription) -> Vec<(Vector6<f64>, String)> {
    let axis = joint.axis.normalize();
    let turn = six(axis, Vector3::zeros());
    let slide = |along: Vector3<f64>| six(Vector3::zeros(), along);
    match joint.kind {
        JointKind::Fixed => Vec::new(),
        JointKind::Revolute | JointKind::Continuous => vec![(turn, joint.name.clone())],
        JointKind::Prismatic => vec![(slide(axis), joint.name.clone())],
        JointKind::Planar => {
            let (x, y) = plane(axis);
            let name = |of: &str| format!("{}_{of}", joint.name);
            vec![(slide(x), name("x")), (slide(y), name("y")), (turn, name("yaw"))]
        }
        JointKind::Floating => panic!("a floating joint is no part of a random tree"),
    }
}

/// Row of G and offset of a joint's motion: its own coordinate, or its leader's.
pub fn drive(
    robot: &RobotDescription,
    joint: &JointDescription,
    coordinates: &[String],
    name: &str,
) -> (DVector<f64>, f64) {
    match &joint.mimic {
        None => {
            (DVector::from_iterator(coordinates.len(), coordinates.iter().map(|c| f64::from(u8::from(c == name)))), 0.0)
        }
        Some(mimic) => {
            let leader = robot.joints.iter().find(|joint| joint.name == mimic.joint).expect("a leader");
            let (row, offset) = drive(robot, leader, coordinates, &leader.name);
            (row * mimic.multiplier, offset * mimic.multiplier + mimic.offset)
        }
    }
}

/// The coordinate directions of the plane normal to `axis`: the shortest rotation that takes ±z, whichever is nearer,
/// to `axis` takes x and ±y to them.
fn plane(axis: Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let side = 1.0_f64.copysign(axis.z);
    let (sine, cosine) = ((Vector3::z() * side).cross(&axis).cross_matrix(), side * axis.z);
    let shortest = Matrix3::identity() + sine + sine * sine / (1.0 + cosine);
    (shortest * Vector3::x(), shortest * Vector3::y() * side)
}
