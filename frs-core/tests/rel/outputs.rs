//! Every output of the core in one list, over any scalar.

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Curvature, Model, Moving, Real, Workspace};
use nalgebra::{DMatrix, Matrix3, Matrix6, Matrix6xX, Vector3};

use crate::trees::Case;

/// The numbers a case is made of, besides the robot: q, q̇, x, y, τ (n each), then μ, V₁, F₁, then a pose.
pub fn inputs(case: &Case) -> Vec<f64> {
    let shape = [&case.q, &case.qd, &case.x, &case.y, &case.tau];
    let sixes = [&case.mu, &case.v1, &case.wrench];
    let pose = case.pose.rotation.iter().chain(&case.pose.translation);
    shape.into_iter().flatten().chain(sixes.into_iter().flatten()).chain(pose).copied().collect()
}

/// A quantity that is written to a matrix; the twist is for those that ask for one.
type Quantity<T, Out> = fn(&mut Moving<'_, '_, '_, T>, Twist<T>, &mut Out);

/// Every output of a new workspace.
pub fn outputs<T: Real>(model: &Model<T>, inputs: &[T]) -> Vec<T> {
    let n = model.dof();
    let mut work = Workspace::new(model);
    let mut shape = work.shape(&inputs[..n]);
    outputs_of(&mut shape.moving(&inputs[n..2 * n]), inputs)
}

/// Every output at the state that `robot` is in, entry by entry.
pub fn outputs_of<T: Real>(robot: &mut Moving<T>, inputs: &[T]) -> Vec<T> {
    let model = robot.model();
    let n = model.dof();
    let (shape, rest) = inputs.split_at(5 * n);
    let [x, y, tau] = [2, 3, 4].map(|i| &shape[i * n..(i + 1) * n]);
    let six = |i: usize| [0, 1, 2, 3, 4, 5].map(|k| rest[6 * i + k]);
    let (mu, v1, force) = (Twist::from_array(six(0)), Twist::from_array(six(1)), Wrench::from_array(six(2)));
    let pose = Pose::new(Matrix3::from_column_slice(&rest[18..27]), Vector3::from_column_slice(&rest[27..30]));

    let mut list = Outputs(Vec::new());
    let (mut wide, mut shape_matrix) = (Matrix6xX::zeros(n), DMatrix::zeros(n, n));
    let mut full_matrix = DMatrix::zeros(6 + n, 6 + n);
    let (mut joints, mut all, mut curvature) = (vec![T::zero(); n], vec![T::zero(); 6 + n], Curvature::new(n));

    list.matrix6(&robot.locked_inertia().to_matrix());
    list.matrix6(&robot.inertia_velocity(x));
    list.matrix6(&robot.locked_coriolis(mu));
    list.take(robot.com().iter());
    list.take(robot.locked_rotational_inertia().to_matrix().iter());
    list.take(robot.locked_inverse_pivots().iter());
    for six in [robot.curvature_on(x, y), robot.locked_velocity(v1), robot.base_twist(mu)] {
        list.take(six.to_array().iter());
    }
    for six in [robot.body_momentum(mu), robot.centroidal_momentum(mu), robot.spatial_momentum(&pose, mu)] {
        list.take(six.to_array().iter());
    }
    list.0.push(robot.kinetic_energy(mu));

    let wides: [Quantity<T, Matrix6xX<T>>; 3] = [
        |robot, _, out| robot.base_joint_inertia(out),
        |robot, _, out| robot.connection(out),
        |robot, mu, out| robot.inertia_derivative(mu, out),
    ];
    for quantity in wides {
        quantity(robot, mu, &mut wide);
        list.take(wide.iter());
    }
    for link in 0..model.links().len() {
        let at = robot.link_pose(link);
        list.take(at.rotation.iter().chain(&at.translation));
        robot.link_jacobian(link, &mut wide);
        list.take(wide.iter());
        robot.generalized_jacobian(link, &mut wide);
        list.take(wide.iter());
    }

    let squares: [Quantity<T, DMatrix<T>>; 4] = [
        |robot, _, out| robot.shape_inertia(out),
        |robot, _, out| robot.shape_inertia_textbook(out),
        |robot, _, out| robot.gamma_q(out),
        |robot, mu, out| robot.b2(mu, out),
    ];
    for quantity in squares {
        quantity(robot, mu, &mut shape_matrix);
        list.take(shape_matrix.iter());
    }
    let full_squares: [Quantity<T, DMatrix<T>>; 4] = [
        |robot, _, out| robot.d_qdot(out),
        |robot, mu, out| robot.d_mu(mu, out),
        |robot, _, out| robot.hamel_inertia(out),
        |robot, v1, out| robot.hamel_coriolis(v1, out),
    ];
    for quantity in full_squares {
        quantity(robot, mu, &mut full_matrix);
        list.take(full_matrix.iter());
    }
    robot.curvature(&mut curvature);
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        list.take(curvature.get(i, j).to_array().iter());
    }

    robot.coupling_torque(mu, &mut joints);
    list.take(joints.iter());
    robot.gamma_q_rates(&mut joints);
    list.take(joints.iter());
    robot.d_mu_xi(mu, &mut all);
    list.take(all.iter());
    robot.d_qdot_xi(mu, &mut all);
    list.take(all.iter());
    robot.hamel_bias(v1, &mut all);
    list.take(all.iter());
    robot.forward_dynamics_articulated(mu, force, tau, &mut all);
    list.take(all.iter());
    robot.forward_dynamics(mu, force, tau, &mut all);
    list.take(all.iter());
    let needed = robot.inverse_dynamics(mu, &all, &mut joints);
    list.take(needed.to_array().iter());
    list.take(joints.iter());
    list.0
}

struct Outputs<T>(Vec<T>);

impl<T: Real> Outputs<T> {
    fn take<'a>(&mut self, entries: impl Iterator<Item = &'a T>) {
        self.0.extend(entries.copied());
    }

    fn matrix6(&mut self, matrix: &Matrix6<T>) {
        self.take(matrix.iter());
    }
}
