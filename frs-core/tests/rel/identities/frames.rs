//! What does not depend on how the robot is described: its base link, its base frame, the names of its coordinates.

use frs_core::model::{InertialDescription, JointKind, Model, RobotDescription};
use frs_core::spatial::{Pose, Twist};
use nalgebra::{DMatrix, DVector, Matrix6, Matrix6xX, Vector1, Vector6};
use proptest::prelude::*;
use proptest::sample::Index;

use crate::algebra::{adjoint, adjoint_inverse};
use crate::asking::{coordinates, moving, six_by, square, twist};
use crate::closeness::{ROUNDING, close};
use crate::kinematics::{drive, motions};
use crate::specification::Specification;
use crate::trees::{Case, case, config};

/// What is compared between two descriptions of a robot, with columns in the order of given coordinates.
struct View {
    lambda_b: Matrix6<f64>,
    a: Matrix6xX<f64>,
    lambda_q: DMatrix<f64>,
    gamma_q: DMatrix<f64>,
    b2: DMatrix<f64>,
    curvature: Vector6<f64>,
    base_twist: Vector6<f64>,
    energy: f64,
}

impl View {
    /// `to_model` takes vectors over the case's coordinates to vectors over the model's; μ is in the model's frame.
    fn new(model: &Model, case: &Case, to_model: &DMatrix<f64>, mu: Twist<f64>) -> Self {
        let n = case.dof();
        let (x, y) = (to_model * &case.x, to_model * &case.y);
        moving(model, &(to_model * &case.q), &(to_model * &case.qd), |robot| Self {
            lambda_b: robot.locked_inertia().to_matrix(),
            a: six_by(n, |out| robot.connection(out)) * to_model,
            lambda_q: to_model.transpose() * square(n, |out| robot.shape_inertia(out)) * to_model,
            gamma_q: to_model.transpose() * square(n, |out| robot.gamma_q(out)) * to_model,
            b2: to_model.transpose() * square(n, |out| robot.b2(mu, out)) * to_model,
            curvature: robot.curvature_on(x.as_slice(), y.as_slice()).to_vector(),
            base_twist: robot.base_twist(mu).to_vector(),
            energy: robot.kinetic_energy(mu),
        })
    }
}

proptest! {
    #![proptest_config(config())]

    /// Another link as base: Λ_b^k = Ad_{1k}ᵀ Λ_b Ad_{1k}, A_l^k = −J̃_k, 𝓑^k = Ad_{1k}⁻¹ 𝓑; the shape's inertia stays.
    #[test]
    fn another_base_link_is_the_same_robot(case in case(), root in any::<Index>()) {
        let here = case.model();
        let spec = case.specification(&here);
        let root = root.index(case.robot.links.len());
        let rerooted = RobotDescription { root: Some(case.robot.links[root].name.clone()), ..case.robot.clone() };
        let there = rerooted.build().expect("any link can be the base");

        let link = &spec.links[root];
        let to_base = adjoint(&link.motion.rotation, &link.motion.translation);
        // The same motion in both: the base's locked velocity, seen from the new base.
        let mu = link.x * case.mu;
        let before = View::new(&here, &case, &DMatrix::identity(spec.dof(), spec.dof()), twist(&case.mu));
        let after = View::new(&there, &case, &permutation(&here, &there), twist(&mu));

        close(&after.lambda_b, &(to_base.transpose() * before.lambda_b * to_base), ROUNDING)?;
        close(&after.a, &-&link.jt, ROUNDING)?;
        close(&after.curvature, &(link.x * before.curvature), ROUNDING)?;
        close(&after.lambda_q, &before.lambda_q, ROUNDING)?;
        close(&after.gamma_q, &before.gamma_q, ROUNDING)?;
        close(&after.b2, &before.b2, ROUNDING)?;
        let link_twist = link.x * before.base_twist + &link.j * &case.qd;
        close(&after.base_twist, &link_twist, ROUNDING)?;
        close(&Vector1::new(after.energy), &Vector1::new(before.energy), ROUNDING)?;
    }

    /// The recursion at another base link equals the sums over links at that base.
    #[test]
    fn another_base_link_is_specified_alike(case in case(), root in any::<Index>()) {
        let root = case.robot.links[root.index(case.robot.links.len())].name.clone();
        let case = Case { robot: RobotDescription { root: Some(root), ..case.robot.clone() }, ..case };
        case.judge(|spec, robot| {
            let size = 6 + spec.dof();
            let d_mu = square(size, |out| robot.d_mu(twist(&case.mu), out));
            close(&d_mu, &spec.d_mu(&case.mu), ROUNDING)?;
            close(&square(size, |out| robot.d_qdot(out)), &spec.d_qdot(), ROUNDING)?;
            let hamel = square(size, |out| robot.hamel_coriolis(twist(&case.v1), out));
            close(&hamel, &spec.hamel_coriolis(&case.v1), ROUNDING)
        })?;
    }

    /// A base frame in which the old one has pose g: Λ_b becomes Ad_g⁻ᵀ Λ_b Ad_g⁻¹, A_l and 𝓑 are moved by Ad_g.
    #[test]
    fn another_base_frame_is_the_same_robot(case in case()) {
        let here = case.model();
        let mut reframed = case.robot.clone();
        reframed.link("frame", InertialDescription::NONE);
        reframed.joint("placement", JointKind::Fixed, "frame", "base").origin(case.pose);
        let there = reframed.build().expect("a base without mass of its own is carried by what is fixed to it");

        let Pose { rotation, translation } = case.pose;
        let (g, g_inverse) = (adjoint(&rotation, &translation), adjoint_inverse(&rotation, &translation));
        let spec = case.specification(&here);
        let before = View::new(&here, &case, &DMatrix::identity(spec.dof(), spec.dof()), twist(&case.mu));
        let after = View::new(&there, &case, &permutation(&here, &there), twist(&(g * case.mu)));

        close(&after.lambda_b, &(g_inverse.transpose() * before.lambda_b * g_inverse), ROUNDING)?;
        close(&after.a, &(g * before.a), ROUNDING)?;
        close(&after.curvature, &(g * before.curvature), ROUNDING)?;
        close(&after.lambda_q, &before.lambda_q, ROUNDING)?;
        close(&after.gamma_q, &before.gamma_q, ROUNDING)?;
        close(&after.b2, &before.b2, ROUNDING)?;
        close(&after.base_twist, &(g * before.base_twist), ROUNDING)?;
        close(&Vector1::new(after.energy), &Vector1::new(before.energy), ROUNDING)?;
    }

    /// A follower is a constant matrix G: quantities of the robot without followers, restricted to q_all = Gq + offset.
    #[test]
    fn followers_restrict_the_robot_without_followers(case in case()) {
        let mut free = case.robot.clone();
        free.joints.iter_mut().for_each(|joint| joint.mimic = None);
        let (here, all) = (case.model(), free.build().expect("a follower can move by itself"));
        let (g, offset) = followers(&case.robot, &here, &all);
        let n = case.dof();

        let spec = Specification::new(&free, &coordinates(&all), &(&g * &case.q + &offset), &(&g * &case.qd));
        case.ask(|robot| {
            close(&six_by(n, |out| robot.connection(out)), &(&spec.a * &g), ROUNDING)?;
            let restricted = |m: DMatrix<f64>| g.transpose() * m * &g;
            close(&square(n, |out| robot.shape_inertia(out)), &restricted(spec.lambda_q()), ROUNDING)?;
            close(&square(n, |out| robot.gamma_q(out)), &restricted(spec.gamma_q()), ROUNDING)?;
            let b2 = square(n, |out| robot.b2(twist(&case.mu), out));
            close(&b2, &restricted(spec.b2(&case.mu)), ROUNDING)?;
            let curvature = robot.curvature_on(case.x.as_slice(), case.y.as_slice()).to_vector();
            close(&curvature, &spec.curvature(&(&g * &case.x), &(&g * &case.y)), ROUNDING)
        })?;
    }
}

/// Takes vectors over the coordinates of `from` to vectors over the same coordinates in the order of `to`.
fn permutation(from: &Model, to: &Model) -> DMatrix<f64> {
    let (from, to) = (coordinates(from), coordinates(to));
    DMatrix::from_fn(to.len(), from.len(), |row, column| f64::from(u8::from(to[row] == from[column])))
}

/// G and offset: from the coordinates of `here` to those of `all`, where nobody follows anybody.
fn followers(robot: &RobotDescription, here: &Model, all: &Model) -> (DMatrix<f64>, DVector<f64>) {
    let (here, all) = (coordinates(here), coordinates(all));
    let (mut g, mut offset) = (DMatrix::zeros(all.len(), here.len()), DVector::zeros(all.len()));
    for joint in &robot.joints {
        for (_, name) in motions(joint) {
            let row = all.iter().position(|coordinate| *coordinate == name).expect("a coordinate of its own");
            let (ratios, shift) = drive(robot, joint, &here, &name);
            g.row_mut(row).tr_copy_from(&ratios);
            offset[row] = shift;
        }
    }
    (g, offset)
}
