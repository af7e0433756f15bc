//! Nothing is allocated once a workspace and the outputs exist.

use allocation_counter::measure;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use frs_core::spatial::{Pose, Symmetric3, Twist, Wrench};
use frs_core::{Curvature, Model, Workspace};
use nalgebra::{DMatrix, Matrix6xX, Vector3};

/// A base with two arms of three joints each; the last joint moves by itself or follows the first.
fn robot(follows: bool) -> RobotDescription {
    let solid = |mass: f64| InertialDescription {
        mass,
        com: Vector3::new(0.1, -0.2, 0.3),
        inertia: Symmetric3::diagonal(Vector3::new(0.3, 0.4, 0.5)),
    };
    let mut robot = RobotDescription::new("two arms");
    robot.link("base", solid(5.0));
    for arm in ["left", "right"] {
        let mut parent = "base".to_owned();
        for (joint, kind) in [JointKind::Revolute, JointKind::Prismatic, JointKind::Continuous].into_iter().enumerate()
        {
            let child = format!("{arm}_{joint}");
            robot.link(&child, solid(1.0));
            let origin = Pose::from_rpy(Vector3::new(0.4, 0.1, 0.2), [0.3, 0.5, 0.7]);
            robot.joint(format!("{child}_joint"), kind, &parent, &child).axis(0.3, 1.0, -0.5).origin(origin);
            parent = child;
        }
    }
    if let Some(last) = robot.joints.last_mut().filter(|_| follows) {
        last.mimic("left_0_joint", -0.5, 0.2);
    }
    robot
}

#[test]
fn no_quantity_allocates() {
    for follows in [false, true] {
        let model = robot(follows).build().expect("a valid robot");
        let allocated = allocations_of_every_quantity(&model);
        assert_eq!(allocated, 0, "with a follower: {follows}");
    }
}

/// How often asking everything of an existing workspace allocates.
fn allocations_of_every_quantity(model: &Model) -> u64 {
    let n = model.dof();
    let [q, qd, x, y, tau] = [0.3, 0.7, 1.0, -0.2, 0.1].map(|number| vec![number; n]);
    let mu = Twist::from_array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
    let force = Wrench::from_array([0.6, 0.5, 0.4, 0.3, 0.2, 0.1]);
    let (mut wide, mut shape_matrix) = (Matrix6xX::zeros(n), DMatrix::zeros(n, n));
    let mut full_matrix = DMatrix::zeros(6 + n, 6 + n);
    let (mut joints, mut all, mut curvature) = (vec![0.0; n], vec![0.0; 6 + n], Curvature::new(n));
    let mut work = Workspace::new(model);

    let allocated = measure(|| {
        let mut shape = work.shape(&q);
        let mut robot = shape.moving(&qd);
        let mut total = robot.locked_inertia().mass;
        total += robot.inertia_velocity(&x).sum() + robot.locked_coriolis(mu).sum() + robot.com().sum();
        robot.base_joint_inertia(&mut wide);
        robot.connection(&mut wide);
        robot.inertia_derivative(mu, &mut wide);
        for link in 0..model.links().len() {
            total += robot.link_pose(link).translation.sum();
            robot.link_jacobian(link, &mut wide);
            robot.generalized_jacobian(link, &mut wide);
        }
        robot.shape_inertia(&mut shape_matrix);
        robot.shape_inertia_textbook(&mut shape_matrix);
        robot.gamma_q(&mut shape_matrix);
        robot.b2(mu, &mut shape_matrix);
        robot.d_mu(mu, &mut full_matrix);
        robot.d_qdot(&mut full_matrix);
        robot.hamel_inertia(&mut full_matrix);
        robot.hamel_coriolis(mu, &mut full_matrix);
        robot.curvature(&mut curvature);
        total += robot.curvature_on(&x, &y).dot(force);
        robot.coupling_torque(mu, &mut joints);
        robot.gamma_q_rates(&mut joints);
        robot.d_mu_xi(mu, &mut all);
        robot.d_qdot_xi(mu, &mut all);
        robot.hamel_bias(mu, &mut all);
        robot.forward_dynamics(mu, force, &tau, &mut all);
        robot.forward_dynamics_articulated(mu, force, &tau, &mut all);
        total += robot.inverse_dynamics(mu, &all, &mut joints).force.sum();
        total += robot.locked_velocity(mu).linear.sum() + robot.base_twist(mu).linear.sum() + robot.kinetic_energy(mu);
        total += robot.body_momentum(mu).force.sum() + robot.centroidal_momentum(mu).force.sum();
        total += robot.spatial_momentum(&Pose::identity(), mu).force.sum();
        assert!(total.is_finite());
    });
    allocated.count_total
}

/// The counter counts: without it the test above could not fail.
#[test]
fn a_workspace_does_allocate() {
    let model = robot(false).build().expect("a valid robot");
    let allocated = measure(|| {
        Workspace::new(&model);
    });
    assert!(allocated.count_total > 0);
}
