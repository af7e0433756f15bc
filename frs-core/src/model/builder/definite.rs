//! Whether the kinetic energy is positive for every motion.
//!
//! Masses can be there and still determine nothing: a point on the axis of its joint, a rod alone in space, two coaxial
//! joints with nothing between them. Whether that is so depends on where the masses are and not on how large they are, so
//! it is judged with unit masses, at one shape of no special kind, by the pivots of the articulated-body sweep
//! (Featherstone, RBDA §7.1). Joints that drive one another are taken as locked.

use nalgebra::{Matrix3, Matrix6, Rotation3, Vector3};

use crate::model::{Body, Model, Motion, Part, Problem, RobotDescription, Subject};
use crate::spatial::{Inertia, Pose};

/// Part of what stands behind a pivot that the pivot must exceed, far above what rounding leaves of zero: a mass may be
/// as near to an axis as a millionth of its distance along it.
const SINGULAR: f64 = 1e-12;

/// Inertia of a unit mass, m², that counts as none: its reciprocal must stay finite in products too.
const NONE: f64 = 1e-60;

/// Reports joints, and the base, whose motion nothing resists; body k + 1 is driven by joint `joints[k]`.
pub(super) fn check(robot: &RobotDescription, model: &Model, joints: &[usize], problems: &mut Vec<Problem>) {
    let bodies = model.bodies();
    let size = bodies.iter().map(|body| body.placement.translation.amax().max(body.com.amax())).fold(1.0, f64::max);
    let mut driven = vec![0; model.dof()];
    bodies[1..].iter().for_each(|body| driven[body.drive.coordinate] += 1);

    // Articulated inertia of each body, and the same before the joints next to it gave way.
    let mut giving: Vec<Matrix6<f64>> = bodies.iter().map(|body| unit_inertia(body, size)).collect();
    let mut rigid = giving.clone();
    for k in (1..bodies.len()).rev() {
        let body = &bodies[k];
        let axis = match body.motion {
            Motion::Revolute => 2,
            Motion::Prismatic => 5,
        };
        let inertia = giving[k];
        let mut left = inertia;
        if driven[body.drive.coordinate] == 1 {
            let pivot = inertia[(axis, axis)];
            if pivot > SINGULAR * behind(&rigid[k], axis) + NONE {
                let column = inertia.column(axis);
                left -= column * column.transpose() / pivot;
            } else {
                problems.push(Problem::error(
                    robot.joint_subject(joints[k - 1]),
                    Part::Whole,
                    "nothing resists the joint's motion: all masses it moves lie on its axis, or give way by other joints",
                    "something to move, else the motion is undetermined",
                    "give the links beyond it rotational inertia, or make the joint fixed",
                ));
            }
        }
        let to_body = standing(body, k, size).inverse().adjoint();
        giving[body.parent] += to_body.transpose() * left * to_body;
        rigid[body.parent] += to_body.transpose() * inertia * to_body;
    }

    let mut base = giving[0];
    let resisted = (0..6).all(|axis| {
        let (column, pivot) = (base.column(axis).into_owned(), base[(axis, axis)]);
        base -= column * column.transpose() / pivot;
        pivot > SINGULAR * behind(&rigid[0], axis) + NONE
    });
    if !resisted {
        problems.push(Problem::error(
            Subject::Robot,
            Part::Whole,
            "nothing resists some motion of the base: all masses lie on one line, or give way by joints",
            "a base whose motion moves something",
            format!("give link '{}' mass and rotational inertia", model.links()[0].name),
        ));
    }
}

/// The body's inertia per mass; of a body without mass, its rotational inertia as that of a unit mass of the robot's size.
fn unit_inertia(body: &Body, size: f64) -> Matrix6<f64> {
    let trace = body.inertia.to_matrix().trace();
    let unit = if body.mass > 0.0 {
        Inertia::from_com(1.0, body.com, body.inertia * (1.0 / body.mass))
    } else if trace > NONE {
        Inertia::from_com(0.0, Vector3::zeros(), body.inertia * (size * size / trace))
    } else {
        Inertia::zero()
    };
    unit.to_matrix()
}

/// What stands behind a pivot: the sum over all three axes of its kind.
fn behind(inertia: &Matrix6<f64>, axis: usize) -> f64 {
    let first = 3 * (axis / 3);
    (first..first + 3).map(|i| inertia[(i, i)]).sum()
}

/// Pose of body k in its parent, its joint at some value that no other joint has.
fn standing(body: &Body, k: usize, size: f64) -> Pose<f64> {
    // Multiples of the golden ratio leave no two fractions near one another.
    let fraction = (k as f64 * 0.618_033_988_749_894_9).fract();
    let motion = match body.motion {
        Motion::Revolute => {
            let angle = std::f64::consts::TAU * fraction;
            Pose::new(Rotation3::from_axis_angle(&Vector3::z_axis(), angle).into_inner(), Vector3::zeros())
        }
        Motion::Prismatic => Pose::new(Matrix3::identity(), Vector3::new(0.0, 0.0, size * (0.5 + fraction))),
    };
    body.placement * motion
}
