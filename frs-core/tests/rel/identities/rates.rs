//! Identities between quantities and their derivatives along the shape, the latter by central differences.

use frs_core::spatial::Wrench;
use nalgebra::{DMatrix, DVector, Vector1, Vector6};
use proptest::prelude::*;

use crate::algebra::moved;
use crate::asking::{moving, shaped, six_by, square, twist, vector};
use crate::closeness::{DIFFERENCES, ROUNDING, close, derivative};
use crate::specification::unit;
use crate::trees::{Case, case, config};

proptest! {
    #![proptest_config(config())]

    /// dΛ_b/dt = P(q̇).
    #[test]
    fn p_is_the_rate_of_the_locked_inertia(case in case()) {
        let model = case.model();
        let lambda_b = |h: f64| shaped(&model, &(&case.q + &case.qd * h), |robot| robot.locked_inertia().to_matrix());
        case.ask(|robot| {
            close(&robot.inertia_velocity(case.qd.as_slice()), &derivative(lambda_b), DIFFERENCES)
        })?;
    }

    /// ½∂(xᵀΛ_b x)/∂q = S(x)ᵀx.
    #[test]
    fn s_is_the_gradient_of_locked_energy(case in case()) {
        let model = case.model();
        let energy = |direction: DVector<f64>| {
            let (model, case) = (&model, &case);
            move |h: f64| {
                shaped(model, &(&case.q + &direction * h), |robot| {
                    Vector1::new(0.5 * case.mu.dot(&(robot.locked_inertia().to_matrix() * case.mu)))
                })
            }
        };
        case.ask(|robot| {
            let n = case.dof();
            let s = six_by(n, |out| robot.inertia_derivative(twist(&case.mu), out));
            let gradient = DVector::from_fn(n, |j, _| derivative(energy(unit(n, j))).x);
            close(&(s.transpose() * case.mu), &gradient, DIFFERENCES)
        })?;
    }

    /// ∂T/∂q while the base twist and q̇ are held.
    #[test]
    fn the_kinetic_gradient_is_the_derivative_of_the_kinetic_energy(case in case()) {
        let (model, n) = (case.model(), case.dof());
        let base = moving(&model, &case.q, &case.qd, |robot| robot.base_twist(twist(&case.mu)));
        let gradient = DVector::from_fn(n, |j, _| {
            let energy = |h: f64| {
                moving(&model, &(&case.q + unit(n, j) * h), &case.qd, |robot| {
                    Vector1::new(robot.kinetic_energy(robot.locked_velocity(base)))
                })
            };
            derivative(energy).x
        });
        case.ask(|robot| {
            close(&vector(n, |out| robot.kinetic_gradient(twist(&case.mu), out)), &gradient, DIFFERENCES)
        })?;
    }

    /// dΛ_q/dt − 2Γ'_q is skew: dΛ_q/dt = Γ'_q + Γ'_qᵀ.
    #[test]
    fn lambda_dot_minus_2gamma_is_skew(case in case()) {
        let rate = derivative(lambda_q(&case, &case.qd));
        case.ask(|robot| {
            let gamma = square(case.dof(), |out| robot.gamma_q(out));
            close(&(&gamma + gamma.transpose()), &rate, DIFFERENCES)
        })?;
    }

    /// Γ'_q(x)_ij = ½ Σ_k (∂_k Λ_ij + ∂_j Λ_ik − ∂_i Λ_jk) x_k.
    #[test]
    fn gamma_is_the_christoffel_matrix_of_lambda_q(case in case()) {
        let n = case.dof();
        let partial: Vec<DMatrix<f64>> = (0..n).map(|k| derivative(lambda_q(&case, &unit(n, k)))).collect();
        let expected = DMatrix::from_fn(n, n, |i, j| {
            let term = |k: usize| partial[k][(i, j)] + partial[j][(i, k)] - partial[i][(j, k)];
            (0..n).map(|k| 0.5 * term(k) * case.qd[k]).sum()
        });
        case.ask(|robot| {
            let gamma = square(n, |out| robot.gamma_q(out));
            close(&gamma, &expected, DIFFERENCES)
        })?;
    }

    /// Γ'_q(x)y = Γ'_q(y)x: the connection has no torsion.
    #[test]
    fn gamma_is_symmetric_in_its_arguments(case in case()) {
        let (model, n) = (case.model(), case.dof());
        let gamma = |rates: &DVector<f64>| moving(&model, &case.q, rates, |robot| square(n, |out| robot.gamma_q(out)));
        close(&(gamma(&case.x) * &case.y), &(gamma(&case.y) * &case.x), ROUNDING)?;
    }

    /// Ṁ = C + Cᵀ in the Hamel form.
    #[test]
    fn hamel_inertia_rate_minus_2c_is_skew(case in case()) {
        let (model, size) = (case.model(), 6 + case.dof());
        let inertia = |h: f64| {
            shaped(&model, &(&case.q + &case.qd * h), |robot| square(size, |out| robot.hamel_inertia(out)))
        };
        case.ask(|robot| {
            let c = square(size, |out| robot.hamel_coriolis(twist(&case.v1), out));
            close(&(&c + c.transpose()), &derivative(inertia), DIFFERENCES)
        })?;
    }

    /// The momentum of a free robot is constant: J = Ad_{g₁}⁻ᵀ Λ_b μ has no rate along ξ̇ of zero forces.
    #[test]
    fn momentum_is_conserved_in_free_flight(case in case()) {
        let model = case.model();
        case.ask(|robot| {
            let still = vec![0.0; case.dof()];
            let xi_rate = vector(6 + case.dof(), |out| {
                robot.forward_dynamics(twist(&case.mu), Wrench::zero(), &still, out);
            });
            let mu_rate = Vector6::from_column_slice(&xi_rate.as_slice()[..6]);
            let v1 = robot.base_twist(twist(&case.mu)).to_vector();
            let momentum = |h: f64| {
                let pose = moved(&case.pose, &(v1 * h));
                shaped(&model, &(&case.q + &case.qd * h), |robot| {
                    robot.spatial_momentum(&pose, twist(&(case.mu + mu_rate * h))).to_vector()
                })
            };
            close(&derivative(momentum), &Vector6::zeros(), DIFFERENCES)
        })?;
    }
}

/// Λ_q(q + h·direction).
fn lambda_q(case: &Case, direction: &DVector<f64>) -> impl Fn(f64) -> DMatrix<f64> {
    let (model, q, direction) = (case.model(), case.q.clone(), direction.clone());
    move |h| shaped(&model, &(&q + &direction * h), |robot| square(q.len(), |out| robot.shape_inertia(out)))
}
