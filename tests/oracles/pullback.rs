//! Other coordinates, and surfaces in the space of shapes, pull connection and curvature back.

use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use frs_core::spatial::{Pose, Twist};
use frs_core::{Evaluator, Workspace};
use frs_oracles::{Case, ROUNDING, Values, compare, no_twist_curvature, shapes};
use nalgebra::{Matrix3, Vector3};

/// Shapes a relation is tried at.
const SHAPES: usize = 100;

/// The tethered mass by a gantry: A_k = Σ_i A_i ∂r_i/∂q_k, 𝓑(∂_k, ∂_l) = Σ_ij 𝓑_ij ∂r_i/∂q_k ∂r_j/∂q_l.
#[test]
fn a_tether_is_a_gantry_in_other_coordinates() {
    let tether = Case::D4.robot();
    let bob = tether.links[3].inertial;
    let mut gantry = RobotDescription::new("gantry");
    gantry.link("base", tether.links[0].inertial);
    gantry.link("x", InertialDescription::NONE).link("y", InertialDescription::NONE).link("mass", bob);
    for (name, parent, child, axis) in [
        ("slide_x", "base", "x", Vector3::x()),
        ("slide_y", "x", "y", Vector3::y()),
        ("slide_z", "y", "mass", Vector3::z()),
    ] {
        gantry.joint(name, JointKind::Prismatic, parent, child).axis(axis.x, axis.y, axis.z);
    }
    let gantry = gantry.build().expect("D1's robot with other masses");
    let hinge = tether.joints[0].origin.translation;

    for q in shapes(Case::D4, SHAPES, 12) {
        let (yaw, pitch, length) = (q[0], q[1], 0.5 + q[2]);
        let turn = Pose::from_rpy(hinge, [0.0, pitch, yaw]).rotation;
        let u = turn * Vector3::x();
        let tangents = Matrix3::from_columns(&[Vector3::z().cross(&u) * length, -turn * Vector3::z() * length, u]);
        let straight = Values::of(&mut Evaluator::new(&gantry), (hinge + u * length).as_slice());
        let column = |k| (0..3).fold(Twist::zero(), |sum, i| sum + straight.connection[i] * tangents[(i, k)]);
        let pair = |(k, l)| {
            let entries = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
            entries.fold(Twist::zero(), |sum, (i, j)| {
                sum + straight.curvature(i, j) * (tangents[(i, k)] * tangents[(j, l)])
            })
        };
        let expected = Values {
            connection: (0..3).map(column).collect(),
            curvature: Values::<f64>::pairs(3).map(pair).collect(),
            com: straight.com,
        };
        let formula: Values<f64> = Case::D4.values(&q);
        let comparison = compare(&expected.widened(), &formula.widened());
        let [connection, curvature] = [&comparison.connection, &comparison.curvature];
        assert!(comparison.within(ROUNDING), "at {q:?}: {connection}; {curvature}");
    }
}

/// The law of the falling cat on q = (α, β, −α), in base axes.
fn no_twist(q: &[f64], found: Twist<f64>, com: Vector3<f64>) {
    let turn = no_twist_curvature(q[0], q[1]);
    for (row, (found, expected)) in
        found.to_array().into_iter().zip(Twist::new(turn, com.cross(&turn)).to_array()).enumerate()
    {
        let size = turn.amax().max(1.0);
        assert!((found - expected).abs() <= ROUNDING * size, "row {row} at {q:?}: {found:e} and {expected:e}");
    }
}

#[test]
fn the_cat_that_does_not_twist_follows_its_law() {
    let model = Case::C2.model();
    let mut work = Workspace::new(&model);
    for q in shapes(Case::C2, SHAPES, 13) {
        let mut shape = work.shape(&[q[0], q[1], -q[0]]);
        let found = shape.curvature_on(&[1.0, 0.0, -1.0], &[0.0, 1.0, 0.0]);
        no_twist(&q, found, shape.com());
    }
}

/// The same with the third joint following the first one backwards: two coordinates instead of a surface.
#[test]
fn the_cat_whose_joints_follow_obeys_the_same_law() {
    let mut robot = Case::C2.robot();
    robot.joints[2].mimic("joint_1", -1.0, 0.0);
    let model = robot.build().expect("a joint may follow another one");
    for q in shapes(Case::C2, SHAPES, 14) {
        let values = Values::of(&mut Evaluator::new(&model), &q[..2]);
        no_twist(&q, values.curvature(0, 1), values.com);
    }
}
