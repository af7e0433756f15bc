//! Identities at one state: symmetry, definiteness, skewness, and one quantity written through another.

use frs_core::Moving;
use frs_core::spatial::Twist;
use nalgebra::{DMatrix, Matrix3, Matrix6, Vector1, Vector3, Vector6};
use proptest::prelude::*;

use crate::algebra::{ad_tilde, adjoint};
use crate::asking::{six_by, square, twist, vector};
use crate::closeness::{ROUNDING, close};
use crate::specification::{dense, stack, unit};
use crate::trees::{case, config};

proptest! {
    #![proptest_config(config())]

    #[test]
    fn inertias_are_symmetric_positive_definite(case in case()) {
        case.ask(|robot| {
            let n = case.dof();
            let lambda_q = square(n, |out| robot.shape_inertia(out));
            close(&lambda_q, &lambda_q.transpose(), ROUNDING)?;
            prop_assert!(lambda_q.cholesky().is_some());
            let lambda_b = dense(&robot.locked_inertia().to_matrix());
            close(&lambda_b, &lambda_b.transpose(), ROUNDING)?;
            prop_assert!(lambda_b.cholesky().is_some());
            let hamel = square(6 + n, |out| robot.hamel_inertia(out));
            close(&hamel, &hamel.transpose(), ROUNDING)?;
            prop_assert!(hamel.cholesky().is_some());
            Ok(())
        })?;
    }

    #[test]
    fn momentum_matrices_are_skew(case in case()) {
        case.ask(|robot| {
            let (n, mu) = (case.dof(), twist(&case.mu));
            let c_b = robot.locked_coriolis(mu);
            close(&c_b, &-c_b.transpose(), ROUNDING)?;
            let b2 = square(n, |out| robot.b2(mu, out));
            close(&b2, &-b2.transpose(), ROUNDING)?;
            let d_mu = square(6 + n, |out| robot.d_mu(mu, out));
            close(&d_mu, &-d_mu.transpose(), ROUNDING)
        })?;
    }

    /// S(x)ᵀy = S(y)ᵀx.
    #[test]
    fn s_is_symmetric_in_its_arguments(case in case()) {
        case.ask(|robot| {
            let s = |robot: &mut Moving, x: &Vector6<f64>| {
                six_by(case.dof(), |out| robot.inertia_derivative(twist(x), out)).transpose()
            };
            close(&(s(robot, &case.mu) * case.v1), &(s(robot, &case.v1) * case.mu), ROUNDING)
        })?;
    }

    /// ½P(z)y = S(y)z.
    #[test]
    fn half_p_of_z_times_y_is_s_of_y_times_z(case in case()) {
        case.ask(|robot| {
            let p = robot.inertia_velocity(case.x.as_slice());
            close(&p, &p.transpose(), ROUNDING)?;
            let s = six_by(case.dof(), |out| robot.inertia_derivative(twist(&case.mu), out));
            close(&(p * case.mu * 0.5), &(s * &case.x), ROUNDING)
        })?;
    }

    /// D_μ and D_q̇ block by block from the quantities they are made of, and applied to ξ.
    #[test]
    fn matrices_are_made_of_their_blocks(case in case()) {
        case.ask(|robot| {
            let (n, mu) = (case.dof(), twist(&case.mu));
            let d_mu = square(6 + n, |out| robot.d_mu(mu, out));
            let s = six_by(n, |out| robot.inertia_derivative(mu, out));
            let a = six_by(n, |out| robot.connection(out));
            let turning = ad_tilde(&robot.body_momentum(mu).to_vector());
            close(&d_mu.view((0, 0), (6, 6)), &-robot.locked_coriolis(mu), ROUNDING)?;
            close(&d_mu.view((0, 6), (6, n)), &(-s - turning * a), ROUNDING)?;
            close(&d_mu.view((6, 6), (n, n)), &(square(n, |out| robot.b2(mu, out)) * -2.0), ROUNDING)?;

            let d_qdot = square(6 + n, |out| robot.d_qdot(out));
            close(&d_qdot.view((0, 0), (6, 6)), &(robot.inertia_velocity(case.qd.as_slice()) * 0.5), ROUNDING)?;
            close(&d_qdot.view((6, 6), (n, n)), &square(n, |out| robot.gamma_q(out)), ROUNDING)?;
            prop_assert_eq!(d_qdot.view((0, 6), (6, n)).amax() + d_qdot.view((6, 0), (n, 6)).amax(), 0.0);

            let xi = stack(&case.mu, &case.qd);
            close(&vector(6 + n, |out| robot.d_mu_xi(mu, out)), &(d_mu * &xi), ROUNDING)?;
            close(&vector(6 + n, |out| robot.d_qdot_xi(mu, out)), &(d_qdot * xi), ROUNDING)?;
            let gamma_q = square(n, |out| robot.gamma_q(out));
            close(&vector(n, |out| robot.gamma_q_rates(out)), &(gamma_q * &case.qd), ROUNDING)
        })?;
    }

    /// Λ_b A_l = M_bq.
    #[test]
    fn connection_solves_for_the_momentum_of_joint_motion(case in case()) {
        case.ask(|robot| {
            let n = case.dof();
            let a = six_by(n, |out| robot.connection(out));
            let expected = six_by(n, |out| robot.base_joint_inertia(out));
            let actual = dense(&robot.locked_inertia().to_matrix()) * a;
            close(&actual, &expected, ROUNDING)
        })?;
    }

    /// The coupling torque is the part of D_μ ξ that is quadratic in μ.
    #[test]
    fn coupling_torque_is_the_lower_left_of_d_mu_on_mu(case in case()) {
        case.ask(|robot| {
            let (n, mu) = (case.dof(), twist(&case.mu));
            let d_mu = square(6 + n, |out| robot.d_mu(mu, out));
            let expected = d_mu.view((6, 0), (n, 6)) * case.mu;
            let actual = vector(n, |out| robot.coupling_torque(mu, out));
            close(&actual, &expected, ROUNDING)
        })?;
    }

    /// J̃_k = J_k − Ad_{1k}⁻¹ A_l, whose column space carries no momentum: Σ_k Ad_{1k}⁻ᵀ M_k J̃_k = 0.
    #[test]
    fn generalized_jacobians_carry_no_momentum(case in case()) {
        case.judge(|spec, robot| {
            let mut momentum = DMatrix::zeros(6, spec.dof());
            for (k, link) in spec.links.iter().zip(&case.robot.links) {
                let number = robot.model().link(&link.name).expect("every link is in the model");
                let generalized = six_by(spec.dof(), |out| robot.generalized_jacobian(number, out));
                momentum += k.x.transpose() * k.m * generalized;
            }
            close(&momentum, &DMatrix::zeros(6, spec.dof()), ROUNDING)
        })?;
    }

    /// B_2(μ) depends on the angular part of μ alone, in the base frame as well: the axes of both frames are the same.
    #[test]
    fn b2_does_not_see_linear_velocity(case in case()) {
        case.ask(|robot| {
            let mu = twist(&case.mu);
            let other = Twist::new(mu.angular, twist(&case.v1).linear);
            let expected = square(case.dof(), |out| robot.b2(mu, out));
            close(&square(case.dof(), |out| robot.b2(other, out)), &expected, ROUNDING)
        })?;
    }

    /// C_b^μ is diag((Σω)×, m ω×) about the centre of mass, Σ = ½ tr(J)·1 − J.
    #[test]
    fn locked_coriolis_is_block_diagonal_about_the_centre_of_mass(case in case()) {
        case.judge(|spec, robot| {
            let seen = adjoint(&Matrix3::identity(), &robot.com());
            let about_com = seen.transpose() * robot.locked_coriolis(twist(&case.mu)) * seen;
            let j = (seen.transpose() * spec.lambda_b * seen).fixed_view::<3, 3>(0, 0).into_owned();
            let w: Vector3<f64> = case.mu.fixed_rows::<3>(0).into_owned();
            let mut expected = Matrix6::zeros();
            let sigma = w * (0.5 * j.trace()) - j * w;
            expected.fixed_view_mut::<3, 3>(0, 0).copy_from(&sigma.cross_matrix());
            expected.fixed_view_mut::<3, 3>(3, 3).copy_from(&(w * spec.lambda_b[(3, 3)]).cross_matrix());
            close(&about_com, &expected, ROUNDING)
        })?;
    }

    /// ½ξᵀΛξ = ½VᵀMV.
    #[test]
    fn kinetic_energy_is_the_same_in_both_velocities(case in case()) {
        case.ask(|robot| {
            let mu = twist(&case.mu);
            let v1 = robot.base_twist(mu).to_vector();
            let velocity = stack(&v1, &case.qd);
            let hamel = square(6 + case.dof(), |out| robot.hamel_inertia(out));
            let expected = Vector1::new(0.5 * velocity.dot(&(hamel * &velocity)));
            let actual = Vector1::new(robot.kinetic_energy(mu));
            close(&actual, &expected, ROUNDING)
        })?;
    }

    /// The locked velocity of a base twist and the base twist of a locked velocity undo each other.
    #[test]
    fn locked_velocity_undoes_base_twist(case in case()) {
        case.ask(|robot| {
            let there_and_back = robot.locked_velocity(robot.base_twist(twist(&case.mu))).to_vector();
            close(&there_and_back, &case.mu, ROUNDING)
        })?;
    }

    #[test]
    fn velocity_of_momentum_undoes_body_momentum(case in case()) {
        case.ask(|robot| {
            let there_and_back = robot.velocity_of_momentum(robot.body_momentum(twist(&case.mu))).to_vector();
            close(&there_and_back, &case.mu, ROUNDING)
        })?;
    }

    /// The columns that matrices act on are those of unit vectors: P is linear and P(e_j) gives S.
    #[test]
    fn s_is_made_of_p_of_unit_vectors(case in case()) {
        case.ask(|robot| {
            let n = case.dof();
            let s = six_by(n, |out| robot.inertia_derivative(twist(&case.mu), out));
            for j in 0..n {
                let column = robot.inertia_velocity(unit(n, j).as_slice()) * case.mu * 0.5;
                close(&column, &(&s * &unit(n, j)), ROUNDING)?;
            }
            Ok(())
        })?;
    }
}
