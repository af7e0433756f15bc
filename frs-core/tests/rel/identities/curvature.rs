//! What the local curvature is: the commutator of horizontal motions, felt as B_2, seen as the drift of small loops.

use frs_core::Curvature;
use frs_core::model::Model;
use nalgebra::{DVector, Matrix4, Matrix6xX, Vector1, Vector6};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;

use crate::algebra::{ad, hat};
use crate::asking::{shaped, six_by, square, twist};
use crate::closeness::{DIFFERENCES, ROUNDING, close, derivative};
use crate::specification::unit;
use crate::trees::{Case, case, config};

/// Side of a small loop in joint space.
const SIDE: f64 = 1e-3;

/// Parts into which a side of the loop is cut.
const STEPS: u32 = 4;

/// Area law of the loop: what is left is of third order in SIDE, divided by the area; a twentieth of this is seen.
const LOOP: f64 = 10.0 * SIDE;

proptest! {
    #![proptest_config(config())]

    /// 𝓑(e_i, e_j) = ∂_i A_j − ∂_j A_i − [A_i, A_j].
    #[test]
    fn curvature_is_the_curl_of_the_connection_less_the_bracket(case in case()) {
        let model = case.model();
        let n = case.dof();
        let partial: Vec<_> = (0..n).map(|i| derivative(|h| connection(&model, &(&case.q + unit(n, i) * h)))).collect();
        let a = connection(&model, &case.q);
        for_pairs(&case, |curvature, i, j| {
            let column = |m: &Matrix6xX<f64>, j| m * unit(n, j);
            let expected = column(&partial[i], j) - column(&partial[j], i) - ad(&column(&a, i)) * column(&a, j);
            close(&curvature.get(i, j).to_vector(), &expected, DIFFERENCES)
        })?;
    }

    /// ∂_i 𝓑_jk − [A_i, 𝓑_jk] + cyclic = 0.
    #[test]
    fn bianchi(case in case()) {
        let (model, n) = (case.model(), case.dof());
        let a = connection(&model, &case.q);
        let covariant = |i: usize, j: usize, k: usize| {
            let at = |h: f64| on(&model, &(&case.q + unit(n, i) * h), &unit(n, j), &unit(n, k));
            derivative(at) - ad(&(&a * &unit(n, i))) * at(0.0)
        };
        for (i, j, k) in (2..n).map(|k| (k - 2, k - 1, k)) {
            let cyclic = covariant(i, j, k) + covariant(j, k, i) + covariant(k, i, j);
            close(&cyclic, &Vector6::zeros(), DIFFERENCES)?;
        }
    }

    /// 𝓑(x, y) = Σ x_i y_j 𝓑(e_i, e_j), and 𝓑(y, x) = −𝓑(x, y).
    #[test]
    fn curvature_is_bilinear_and_antisymmetric(case in case()) {
        let model = case.model();
        let mut sum = Vector6::zeros();
        for_pairs(&case, |curvature, i, j| {
            let (there, back) = (curvature.get(i, j).to_vector(), curvature.get(j, i).to_vector());
            sum += there * (case.x[i] * case.y[j]);
            close(&there, &-back, ROUNDING)
        })?;
        close(&on(&model, &case.q, &case.x, &case.y), &sum, ROUNDING)?;
        close(&on(&model, &case.q, &case.y, &case.x), &-sum, ROUNDING)?;
    }

    /// B_2(μ)_ij = −½⟨Λ_b μ, 𝓑(e_i, e_j)⟩.
    #[test]
    fn b2_is_curvature_seen_by_momentum(case in case()) {
        let b2 = shaped(&case.model(), &case.q, |robot| square(case.dof(), |out| robot.b2(twist(&case.mu), out)));
        let momentum = shaped(&case.model(), &case.q, |robot| robot.body_momentum(twist(&case.mu)));
        for_pairs(&case, |curvature, i, j| {
            let expected = Vector1::new(-0.5 * curvature.get(i, j).dot(momentum));
            close(&Vector1::new(b2[(i, j)]), &expected, ROUNDING)
        })?;
    }

    /// Λ_b 𝓑(e_i, e_j) = −2 [B_2(e_a)_ij]_a over the six unit twists e_a.
    #[test]
    fn curvature_is_b2_of_the_six_unit_twists(case in case()) {
        let (model, n) = (case.model(), case.dof());
        let unit_twist = |a| Vector6::from_fn(|row, _| f64::from(u8::from(row == a)));
        let b2: Vec<_> = (0..6)
            .map(|a| shaped(&model, &case.q, |robot| square(n, |out| robot.b2(twist(&unit_twist(a)), out))))
            .collect();
        let lambda_b = shaped(&model, &case.q, |robot| robot.locked_inertia().to_matrix());
        for_pairs(&case, |curvature, i, j| {
            let expected = Vector6::from_fn(|a, _| -2.0 * b2[a][(i, j)]);
            close(&(lambda_b * curvature.get(i, j).to_vector()), &expected, ROUNDING)
        })?;
    }

    /// −2B_2(μ)q̇ = ⟨Λ_b μ, 𝓑(·, q̇)⟩.
    #[test]
    fn momentum_feels_curvature_as_a_force_on_the_shape(case in case()) {
        case.ask(|robot| {
            let n = case.dof();
            let force = square(n, |out| robot.b2(twist(&case.mu), out)) * &case.qd * -2.0;
            let momentum = robot.body_momentum(twist(&case.mu));
            let felt = |i| robot.curvature_on(unit(n, i).as_slice(), case.qd.as_slice()).dot(momentum);
            let expected = DVector::from_iterator(n, (0..n).map(felt));
            close(&force, &expected, ROUNDING)
        })?;
    }

    /// About the centre of mass c the curvature is a pure rotation: 𝓑 = [𝓑_ω; c × 𝓑_ω].
    #[test]
    fn curvature_turns_about_the_centre_of_mass(case in case()) {
        let com = shaped(&case.model(), &case.q, |robot| robot.com());
        for_pairs(&case, |curvature, i, j| {
            let turning = curvature.get(i, j);
            close(&turning.linear, &com.cross(&turning.angular), ROUNDING)
        })?;
    }

    /// The 6×n(n−1)/2 matrix of all curvatures has rank three at most.
    #[test]
    fn curvature_has_rank_three_at_most(case in case()) {
        let mut columns = vec![Vector6::zeros(); 4];
        for_pairs(&case, |curvature, i, j| {
            columns.push(curvature.get(i, j).to_vector());
            Ok(())
        })?;
        let mut singular_values = Matrix6xX::from_columns(&columns).singular_values();
        singular_values.as_mut_slice().sort_by(|a, b| b.total_cmp(a));
        prop_assert!(singular_values[3] <= ROUNDING * singular_values[0].max(1.0));
    }

    /// At μ = 0 a small loop in the (q_i, q_j) plane displaces the base by −𝓑(e_i, e_j)·area.
    #[test]
    fn a_small_loop_displaces_the_base_by_minus_curvature_times_area(case in case()) {
        let (model, n) = (case.model(), case.dof());
        if n < 2 {
            return Ok(());
        }
        let (x, y) = (unit(n, 0) * SIDE, unit(n, n - 1) * SIDE);
        // The loop is centred on q, so that the error of the area law is of fourth order.
        let mut q = &case.q - (&x + &y) * 0.5;
        let mut base = Matrix4::identity();
        for side in [x.clone(), y.clone(), -x, -y] {
            for _ in 0..STEPS {
                let step = &side / f64::from(STEPS);
                // ġ₁ = g₁(−A_l q̇)^ by the midpoint rule on the group.
                base *= hat(&-(&connection(&model, &(&q + &step * 0.5)) * &step)).exp();
                q += step;
            }
        }
        let expected = hat(&-on(&model, &case.q, &unit(n, 0), &unit(n, n - 1)));
        close(&((base - Matrix4::identity()) / (SIDE * SIDE)), &expected, LOOP)?;
    }
}

fn connection(model: &Model, q: &DVector<f64>) -> Matrix6xX<f64> {
    shaped(model, q, |robot| six_by(q.len(), |out| robot.connection(out)))
}

fn on(model: &Model, q: &DVector<f64>, x: &DVector<f64>, y: &DVector<f64>) -> Vector6<f64> {
    shaped(model, q, |robot| robot.curvature_on(x.as_slice(), y.as_slice()).to_vector())
}

/// Checks every pair (i, j), given the curvature at the case's shape.
fn for_pairs(case: &Case, mut check: impl FnMut(&Curvature, usize, usize) -> TestCaseResult) -> TestCaseResult {
    let n = case.dof();
    let mut curvature = Curvature::new(n);
    case.ask(|robot| {
        robot.curvature(&mut curvature);
        (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).try_for_each(|(i, j)| check(&curvature, i, j))
    })
}
