//! The corrections to the printed paper, docs/mathematics.md §5: on one robot the printed form fails, the corrected one
//! holds. Equation numbers are the paper's.

use std::ops::Add;

use frs_core::Moving;
use nalgebra::{DMatrix, DVector, Dim, Matrix, Matrix6, Matrix6xX, RawStorage, Vector1, Vector6};

use crate::algebra::{ad, ad_tilde, coriolis};
use crate::asking::{shaped, six_by, square, twist, vector};
use crate::closeness::{DIFFERENCES, derivative};
use crate::fixed_robot::branching_arm;
use crate::specification::{Link, Specification, unit};
use crate::trees::Case;

/// A form that holds leaves no more than rounding of quantities of order ten.
const HOLDS: f64 = 1e-12;

/// A form that fails leaves a residual of order one; the smallest on this robot is a few hundredths.
const FAILS: f64 = 1e-2;

fn residual<R: Dim, C: Dim, S: RawStorage<f64, R, C>, S2: RawStorage<f64, R, C>>(
    left: &Matrix<f64, R, C, S>,
    right: &Matrix<f64, R, C, S2>,
) -> f64 {
    left.iter().zip(right.iter()).map(|(left, right)| (left - right).abs()).fold(0.0, f64::max)
}

/// `left` equals `corrected` and does not equal `printed`.
macro_rules! corrected {
    ($left:expr, printed: $printed:expr, correct: $correct:expr) => {{
        let (printed, correct) = (residual(&$left, &$printed), residual(&$left, &$correct));
        assert!(printed > FAILS, "the printed form holds: {printed:e}");
        assert!(correct < HOLDS, "the corrected form fails: {correct:e}");
    }};
}

/// Runs `check` on the state, its specification and the core.
fn on_state(check: impl FnOnce(&Case, &Specification, &mut Moving)) {
    let state = branching_arm();
    let checked = state.judge(|spec, robot| {
        check(&state, spec, robot);
        Ok(())
    });
    checked.expect("the check itself panics when it fails");
}

/// D_μ ξ as the Hamel form has it, which knows nothing of D_μ: D_q̇ ξ + Λ[dA_l/dt q̇; 0] − Θ⁻ᵀ C V.
fn momentum_terms(state: &Case, spec: &Specification, robot: &mut Moving) -> (Vector6<f64>, DVector<f64>) {
    let size = 6 + spec.dof();
    let mu = twist(&state.mu);
    let base_twist = robot.base_twist(mu);
    let bias = vector(size, |out| robot.hamel_bias(base_twist, out));
    let rates = vector(size, |out| robot.d_qdot_xi(mu, out));
    let halves = |six_and_n: &DVector<f64>| {
        let (base, joints) = six_and_n.as_slice().split_at(6);
        (Vector6::from_column_slice(base), DVector::from_column_slice(joints))
    };
    let ((base, joints), (base_rates, joint_rates)) = (halves(&bias), halves(&rates));
    let of_joints = joint_rates + spec.a.transpose() * base - joints;
    (base_rates + spec.lambda_b * (&spec.a_rate * &state.qd) - base, of_joints)
}

/// Σ_k of what `of_link` makes of each link.
fn over_links<M: Add<Output = M>>(spec: &Specification, of_link: impl Fn(&Link) -> M) -> M {
    spec.links.iter().map(of_link).reduce(|sum, term| sum + term).expect("a base")
}

/// ad~_{Λ_bμ}.
fn turning(state: &Case, robot: &Moving) -> Matrix6<f64> {
    ad_tilde(&robot.body_momentum(twist(&state.mu)).to_vector())
}

fn connection(robot: &Moving) -> Matrix6xX<f64> {
    six_by(robot.model().dof(), |out| robot.connection(out))
}

fn s(x: &Vector6<f64>, robot: &mut Moving) -> Matrix6xX<f64> {
    six_by(robot.model().dof(), |out| robot.inertia_derivative(twist(x), out))
}

fn b2(x: &Vector6<f64>, robot: &mut Moving) -> DMatrix<f64> {
    square(robot.model().dof(), |out| robot.b2(twist(x), out))
}

/// ⟨Λ_bμ, 𝓑(x, ·)⟩.
fn felt(state: &Case, x: &DVector<f64>, robot: &mut Moving) -> DVector<f64> {
    let momentum = robot.body_momentum(twist(&state.mu));
    let n = x.len();
    DVector::from_fn(n, |j, _| robot.curvature_on(x.as_slice(), unit(n, j).as_slice()).dot(momentum))
}

/// Σ_k Ad⁻ᵀ(C_k − M_k ad_{J_k x})Ad⁻¹ with C_k = C(M_k; J_k x) is ½P(x) − ½ad~_h: h is a momentum, moved by Ad⁻ᵀ.
#[test]
fn eq_18a_moves_momentum_as_a_wrench() {
    on_state(|state, spec, robot| {
        let sum: Matrix6<f64> = spec
            .links
            .iter()
            .map(|k| {
                let velocity = &k.j * &state.x;
                k.x.transpose() * (coriolis(&k.m, &velocity) - k.m * ad(&velocity)) * k.x
            })
            .sum();
        let h = |moved: fn(&Link) -> Matrix6<f64>| -> Vector6<f64> {
            spec.links.iter().map(|k| moved(k) * k.m * (&k.j * &state.x)).sum()
        };
        let half_p = robot.inertia_velocity(state.x.as_slice()) * 0.5;
        corrected!(
            sum,
            printed: half_p - ad_tilde(&h(|k| k.x)) * 0.5,
            correct: half_p - ad_tilde(&h(|k| k.x.transpose())) * 0.5
        );
        let m_bq = six_by(spec.dof(), |out| robot.base_joint_inertia(out));
        assert!(residual(&h(|k| k.x.transpose()), &(&m_bq * &state.x)) < HOLDS);
    });
}

#[test]
fn eq_16_first_block_row_has_minus_c_b_and_minus_s() {
    on_state(|state, spec, robot| {
        let (of_base, _) = momentum_terms(state, spec, robot);
        let c_b = robot.locked_coriolis(twist(&state.mu)) * state.mu;
        let s = s(&state.mu, robot) * &state.qd;
        let turned = turning(state, robot) * (connection(robot) * &state.qd);
        corrected!(of_base, printed: c_b + s - turned, correct: -c_b - s - turned);
    });
}

#[test]
fn eq_16_second_block_row_has_plus_s_transposed() {
    on_state(|state, spec, robot| {
        let (_, of_joints) = momentum_terms(state, spec, robot);
        let s = s(&state.mu, robot).transpose() * state.mu;
        let rest =
            connection(robot).transpose() * (turning(state, robot) * state.mu) + b2(&state.mu, robot) * &state.qd * 2.0;
        corrected!(of_joints, printed: -&s - &rest, correct: &s - &rest);
    });
}

/// B_2(μ) = Σ_k J_kᵀ C_k J_k + S(μ)ᵀA_l − A_lᵀS(μ) − ½A_lᵀ ad~_{Λ_bμ} A_l with C_k = C(M_k; Ad_{1k}⁻¹μ).
#[test]
fn eq_18d_has_minus_one_half_of_the_turning_term() {
    on_state(|state, spec, robot| {
        let (a, s) = (connection(robot), s(&state.mu, robot));
        let sum = over_links(spec, |k| k.j.transpose() * coriolis(&k.m, &(k.x * state.mu)) * &k.j);
        let rest = sum + s.transpose() * &a - a.transpose() * &s;
        let turned = a.transpose() * turning(state, robot) * &a;
        corrected!(b2(&state.mu, robot), printed: &rest + &turned, correct: &rest - &turned * 0.5);
    });
}

/// Σ_k Ad⁻ᵀ C_k J_k = S̃, S̃ = S(μ) − ½ad_μᵀ M_bq.
#[test]
fn eq_26_is_plus_s_tilde() {
    on_state(|state, spec, robot| {
        let sum = over_links(spec, |k| k.x.transpose() * coriolis(&k.m, &(k.x * state.mu)) * &k.j);
        let m_bq = six_by(spec.dof(), |out| robot.base_joint_inertia(out));
        let s_tilde = s(&state.mu, robot) - ad(&state.mu).transpose() * m_bq * 0.5;
        corrected!(sum, printed: -&s_tilde, correct: s_tilde);
    });
}

#[test]
fn eq_36_second_is_plus_s() {
    on_state(|state, _, robot| {
        let half_p = robot.inertia_velocity(state.x.as_slice()) * state.v1 * 0.5;
        let s = s(&state.v1, robot) * &state.x;
        corrected!(half_p, printed: -s, correct: s);
    });
}

/// −2B_2(μ)q̇ = 𝓑(q̇)μ with
/// 𝓑(q̇) = −2( Σ_k J_kᵀ(C_k − M_k ad_{J_k q̇})Ad⁻¹ + S(A_l q̇)ᵀ − ½A_lᵀP(q̇) − ½A_lᵀ ad_{A_l q̇}ᵀ Λ_b ) and
/// C_k = C(M_k; J_k q̇):
/// of all signs, and of the coefficients ±½ and ±1 of the last term, no others.
#[test]
fn eq_39_holds_with_one_choice_of_signs_and_coefficients() {
    on_state(|state, spec, robot| {
        let a = connection(robot);
        let moved = &a * &state.qd;
        let of_links = over_links(spec, |k| {
            let velocity = &k.j * &state.qd;
            k.j.transpose() * (coriolis(&k.m, &velocity) - k.m * ad(&velocity)) * k.x
        }) * state.mu;
        let of_s = s(&moved, robot).transpose() * state.mu;
        let of_p = a.transpose() * (robot.inertia_velocity(state.qd.as_slice()) * state.mu);
        let of_bracket = a.transpose() * (ad(&moved).transpose() * spec.lambda_b * state.mu);
        let force = b2(&state.mu, robot) * &state.qd * -2.0;

        let mut holding = Vec::new();
        for overall in [-2.0, 2.0] {
            for (s, p) in [(1.0, -0.5), (1.0, 0.5), (-1.0, -0.5), (-1.0, 0.5)] {
                for bracket in [-0.5, 0.5, -1.0, 1.0] {
                    let sum = (&of_links + &of_s * s + &of_p * p + &of_bracket * bracket) * overall;
                    let apart = residual(&force, &sum);
                    assert!(!(HOLDS..FAILS).contains(&apart), "neither holds nor fails: {apart:e}");
                    if apart < HOLDS {
                        holding.push([overall, s, p, bracket]);
                    }
                }
            }
        }
        assert_eq!(holding, [[-2.0, 1.0, -0.5, -0.5]]);
    });
}

/// Λ_q q̈ + Γ'_q q̇ = −⟨Λ_bμ, 𝓑(q̇, ·)⟩ + ½∂_q(μᵀΛ_bμ) − A_lᵀ ad_μᵀ Λ_bμ + τ − A_lᵀF₁.
#[test]
fn eq_14_has_minus_curvature_and_minus_turning() {
    on_state(|state, spec, robot| {
        let (_, of_joints) = momentum_terms(state, spec, robot);
        let felt = felt(state, &state.qd, robot);
        let gradient = s(&state.mu, robot).transpose() * state.mu;
        let turned = connection(robot).transpose() * (ad(&state.mu).transpose() * spec.lambda_b * state.mu);
        corrected!(of_joints, printed: &felt + &gradient + &turned, correct: -&felt + &gradient - &turned);
    });
}

#[test]
fn eq_40_is_plus_two_b2() {
    on_state(|state, _, robot| {
        let force = b2(&state.mu, robot) * &state.qd * 2.0;
        corrected!(felt(state, &state.qd, robot), printed: -&force, correct: force);
    });
}

/// Definition 5: S(x)ᵀx is half the gradient of xᵀΛ_b x, and of it alone.
#[test]
fn definition_5_keeps_its_half() {
    on_state(|state, spec, robot| {
        let model = robot.model();
        let form = |j| {
            derivative(|h| {
                shaped(model, &(&state.q + unit(spec.dof(), j) * h), |robot| {
                    Vector1::new(state.v1.dot(&(robot.locked_inertia().to_matrix() * state.v1)))
                })
            })
        };
        let gradient = DVector::from_fn(spec.dof(), |j, _| form(j).x);
        let s = s(&state.v1, robot).transpose() * state.v1;
        assert!(residual(&gradient, &s) > FAILS, "the form without a half holds");
        assert!(residual(&(gradient * 0.5), &s) < DIFFERENCES);
    });
}
