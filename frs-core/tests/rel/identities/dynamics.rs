//! The equations of motion: forward against inverse, one route against another, the Hamel form against the reduced one.

use frs_core::Route;
use frs_core::spatial::{Twist, Wrench};
use nalgebra::{DMatrix, DVector, Matrix6, Matrix6xX, MatrixXx6, Vector1};
use proptest::prelude::*;

use crate::asking::{moving, six_by, square, twist, vector, wrench};
use crate::closeness::{ROUNDING, close};
use crate::specification::{blocks, stack};
use crate::trees::{case, config};

proptest! {
    #![proptest_config(config())]

    #[test]
    fn inverse_dynamics_undoes_forward_dynamics(case in case()) {
        case.judge(|spec, robot| {
            let (n, mu) = (spec.dof(), twist(&case.mu));
            let tolerance = ROUNDING * spec.shape_condition();
            let xi_rate = vector(6 + n, |out| {
                robot.forward_dynamics(mu, wrench(&case.wrench), case.tau.as_slice(), out);
            });
            let mut tau = DVector::zeros(n);
            let force = robot.inverse_dynamics(mu, xi_rate.as_slice(), tau.as_mut_slice());
            close(&force.to_vector(), &case.wrench, tolerance)?;
            close(&tau, &case.tau, tolerance)
        })?;
    }

    #[test]
    fn forward_dynamics_undoes_inverse_dynamics(case in case()) {
        case.judge(|spec, robot| {
            let (n, mu) = (spec.dof(), twist(&case.mu));
            let xi_rate = stack(&case.v1, &case.y);
            let mut tau = vec![0.0; n];
            let force = robot.inverse_dynamics(mu, xi_rate.as_slice(), &mut tau);
            let tolerance = ROUNDING * spec.shape_condition();
            close(&vector(6 + n, |out| robot.forward_dynamics(mu, force, &tau, out)), &xi_rate, tolerance)?;
            let swept = vector(6 + n, |out| robot.forward_dynamics_articulated(mu, force, &tau, out));
            close(&swept, &xi_rate, tolerance)?;
            // The difference M_q − A_lᵀ Λ_b A_l is as exact as its first term is.
            let cancelled = spec.m_q().norm() / spec.lambda_q().norm().max(f64::MIN_POSITIVE);
            let textbook = vector(n, |out| robot.shape_acceleration_by(Route::Textbook, mu, force, &tau, out));
            close(&textbook, &case.y, tolerance * cancelled.max(1.0))
        })?;
    }

    /// Torques for some joints and accelerations for the others: what is found is what the whole motion has.
    #[test]
    fn hybrid_dynamics_is_part_forward_and_part_inverse(case in case(), mask in any::<u32>()) {
        case.judge(|spec, robot| {
            let (n, mu, wrench) = (spec.dof(), twist(&case.mu), wrench(&case.wrench));
            let given: Vec<bool> = (0..n).map(|i| mask >> i & 1 == 1).collect();
            let rotor: Vec<f64> = (0..n).map(|i| 0.05 * i as f64).collect();
            let mu_rate = vector(6 + n, |out| robot.forward_dynamics(mu, wrench, case.tau.as_slice(), out)).fixed_rows::<6>(0).into_owned();
            let mut tau = DVector::zeros(n);
            robot.inverse_dynamics(mu, stack(&mu_rate, &case.y).as_slice(), tau.as_mut_slice());
            tau += DVector::from_column_slice(&rotor).component_mul(&case.y);

            let (mut found_tau, mut found) = (tau.clone(), case.y.clone());
            for i in 0..n {
                let unknown = if given[i] { &mut found_tau[i] } else { &mut found[i] };
                *unknown = f64::NAN;
            }
            robot.hybrid_dynamics(mu, wrench, &rotor, &given, found_tau.as_mut_slice(), found.as_mut_slice());
            let tolerance = ROUNDING * spec.shape_condition();
            close(&found, &case.y, tolerance)?;
            close(&found_tau, &tau, tolerance)
        })?;
    }

    /// M = Θᵀ diag(Λ_b, Λ_q) Θ with ξ = ΘV, Θ = [[1, A_l], [0, 1]].
    #[test]
    fn hamel_inertia_is_block_diagonal_in_locked_velocity(case in case()) {
        case.ask(|robot| {
            let n = case.dof();
            let theta = theta(&six_by(n, |out| robot.connection(out)));
            let lambda = {
                let (locked, shape) = (robot.locked_inertia().to_matrix(), square(n, |out| robot.shape_inertia(out)));
                let zero = Matrix6xX::zeros(n);
                blocks(&locked, &zero, &zero.transpose(), &shape)
            };
            let hamel = square(6 + n, |out| robot.hamel_inertia(out));
            close(&(theta.transpose() * lambda * theta), &hamel, ROUNDING)
        })?;
    }

    /// C V = Θᵀ( Λ Θ̇ V + (D_q̇ − D_μ) ξ ).
    #[test]
    fn hamel_bias_is_the_reduced_one_seen_through_theta(case in case()) {
        case.judge(|spec, robot| {
            let (n, mu) = (spec.dof(), twist(&case.mu));
            let base_twist = robot.base_twist(mu);
            let turning = robot.locked_inertia().to_matrix() * (&spec.a_rate * &case.qd);
            let reduced = vector(6 + n, |out| robot.d_qdot_xi(mu, out)) - vector(6 + n, |out| robot.d_mu_xi(mu, out));
            let theta = theta(&six_by(n, |out| robot.connection(out)));
            let expected = theta.transpose() * (stack(&turning, &DVector::zeros(n)) + reduced);
            let actual = vector(6 + n, |out| robot.hamel_bias(base_twist, out));
            close(&actual, &expected, ROUNDING)?;

            let velocity = stack(&base_twist.to_vector(), &case.qd);
            let of_matrix = square(6 + n, |out| robot.hamel_coriolis(base_twist, out)) * velocity;
            close(&actual, &of_matrix, ROUNDING)
        })?;
    }

    /// M V̇ + C V = F and Theorem 1 give the same motion: ξ̇ = ΘV̇ + Θ̇V.
    #[test]
    fn hamel_equations_give_the_reduced_acceleration(case in case()) {
        case.judge(|spec, robot| {
            let (n, mu) = (spec.dof(), twist(&case.mu));
            let base_twist = robot.base_twist(mu);
            let mut memory = DMatrix::zeros(6 + n, 6 + n);
            let acceleration = vector(6 + n, |out| {
                robot.hamel_acceleration(base_twist, wrench(&case.wrench), case.tau.as_slice(), &mut memory, out);
            });
            let theta = theta(&six_by(n, |out| robot.connection(out)));
            let expected = theta * acceleration + stack(&(&spec.a_rate * &case.qd), &DVector::zeros(n));
            let actual = vector(6 + n, |out| {
                robot.forward_dynamics(mu, wrench(&case.wrench), case.tau.as_slice(), out);
            });
            close(&actual, &expected, ROUNDING * spec.shape_condition())
        })?;
    }

    /// ξᵀ(Λξ̇ + D_q̇ ξ) = V₁ᵀF₁ + q̇ᵀτ: kinetic energy changes by the power of the forces.
    #[test]
    fn energy_changes_by_the_power_of_the_forces(case in case()) {
        case.judge(|spec, robot| {
            let (n, mu) = (spec.dof(), twist(&case.mu));
            let (xi, power) = (
                spec.xi(&case.mu),
                robot.base_twist(mu).dot(wrench(&case.wrench)) + case.qd.dot(&case.tau),
            );
            let xi_rate = vector(6 + n, |out| {
                robot.forward_dynamics(mu, wrench(&case.wrench), case.tau.as_slice(), out);
            });
            let d_qdot_xi = vector(6 + n, |out| robot.d_qdot_xi(mu, out));
            let actual = xi.dot(&(spec.lambda() * xi_rate + d_qdot_xi));
            let tolerance = ROUNDING * spec.shape_condition();
            close(&Vector1::new(actual), &Vector1::new(power), tolerance)
        })?;
    }

    /// A robot at rest with nothing acting on it stays at rest.
    #[test]
    fn rest_stays_rest(case in case()) {
        let (model, n) = (case.model(), case.dof());
        let still = DVector::zeros(n);
        moving(&model, &case.q, &still, |robot| {
            let xi_rate = vector(6 + n, |out| {
                robot.forward_dynamics(Twist::zero(), Wrench::zero(), still.as_slice(), out);
            });
            close(&xi_rate, &DVector::zeros(6 + n), 0.0)
        })?;
    }
}

/// Θ = [[1, A_l], [0, 1]].
fn theta(a: &Matrix6xX<f64>) -> DMatrix<f64> {
    let n = a.ncols();
    blocks(&Matrix6::identity(), a, &MatrixXx6::zeros(n), &DMatrix::identity(n, n))
}
