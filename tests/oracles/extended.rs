//! The core in double-double: 28 digits against the formulas, and its connection's differences against its curvature.

use frs_core::Evaluator;
use frs_core::extended::DoubleDouble;
use frs_core::spatial::Twist;
use frs_oracles::{Case, Robots, Values, compare, judged_shapes};

use crate::random;

/// Random robots.
const ROBOTS: u64 = 10;

/// Step of the differences: the stencil's error is some h⁶ = 5e-22, rounding adds 1e-31/h.
const STEP: f64 = 1.0 / 4096.0;

/// Sixth-order differences; fifteen digits are asked for.
const DIFFERENCES: f64 = 1e-18;

fn the_core_gives_28_digits(case: Case) {
    let (robots, [.., tolerance]) = (Robots::new(case), case.tolerances());
    for q in judged_shapes(case) {
        let answers = robots.answers(&q);
        let comparison = compare(&answers.extended, &answers.exact);
        let [connection, curvature] = [&comparison.connection, &comparison.curvature];
        assert!(comparison.within(tolerance), "{case:?} at {q:?}: {connection}; {curvature}");
    }
}

every_case!(the_core_gives_28_digits);

/// 𝓑(e_i, e_j) = ∂_i A_j − ∂_j A_i − [A_i, A_j], the derivatives by central differences of sixth order.
#[test]
fn differences_of_the_connection_give_the_curvature_of_random_robots() {
    for seed in 0..ROBOTS {
        let model = random::robot(seed).cast::<DoubleDouble>().orthonormalised();
        let mut robot = Evaluator::new(&model);
        let mut rng = fastrand::Rng::with_seed(seed + ROBOTS);
        let q: Vec<DoubleDouble> = (0..random::JOINTS).map(|_| (2.0 * rng.f64() - 1.0).into()).collect();
        let values = Values::of(&mut robot, &q);
        let rates: Vec<_> = (0..q.len()).map(|i| difference(&mut robot, &q, i)).collect();
        let defined =
            |(i, j): (usize, usize)| rates[i][j] - rates[j][i] - values.connection[i].ad(values.connection[j]);
        let curvature = Values::<f64>::pairs(q.len()).map(defined).collect();
        let worst = compare(&Values { curvature, ..values.clone() }, &values).curvature;
        assert!(worst.relative <= DIFFERENCES, "seed {seed}: {worst}");
        assert!(worst.relative > 0.0, "seed {seed}: two ways to one number differ somewhere");
    }
}

/// ∂A/∂q_i from the weights 45, −9, 1 over 60h.
fn difference(robot: &mut Evaluator<DoubleDouble>, q: &[DoubleDouble], i: usize) -> Vec<Twist<DoubleDouble>> {
    let mut sum = vec![Twist::zero(); q.len()];
    for (steps, weight) in [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)] {
        for side in [1.0, -1.0] {
            let mut moved = q.to_vec();
            moved[i] += (side * steps * STEP).into();
            let weight = DoubleDouble::from(side * weight) / DoubleDouble::from(60.0 * STEP);
            let columns = Values::of(robot, &moved).connection;
            sum.iter_mut().zip(columns).for_each(|(sum, column)| *sum += column * weight);
        }
    }
    sum
}
