//! 𝓑 as it is defined, by exact derivatives of A_l in double-double: of the formulas and of the core.

use frs_core::derivatives::Dual;
use frs_core::extended::DoubleDouble;
use frs_core::spatial::Twist;
use frs_core::{Evaluator, Model, Real};
use frs_oracles::{Case, EXTENDED, Robots, Values, compare, shapes};
use nalgebra::Vector3;

/// A scalar that carries a derivative in double-double.
pub type Wide = Dual<DoubleDouble>;

/// Shapes a case is tried at.
const SHAPES: usize = 20;

/// A derivative loses some digits that 𝓑 itself keeps.
const DERIVATIVE: f64 = 10.0 * EXTENDED;

/// The derivative along coordinate `i` of what `values` gives at `q`.
pub fn derivative(q: &[DoubleDouble], i: usize, values: impl Fn(&[Wide]) -> Values<Wide>) -> Values<DoubleDouble> {
    let mut along: Vec<Wide> = q.iter().map(|&q| q.into()).collect();
    along[i].derivative = DoubleDouble::from_f64(1.0);
    let values = values(&along);
    let rates = |twists: &[Twist<Wide>]| -> Vec<_> {
        twists.iter().map(|twist| Twist::from_array(twist.to_array().map(|x| x.derivative))).collect()
    };
    Values {
        connection: rates(&values.connection),
        curvature: rates(&values.curvature),
        com: values.com.map(|x| x.derivative),
    }
}

/// `∂_i A_j − ∂_j A_i − ad_{A_i} A_j` for all pairs.
fn curl_less_bracket(
    q: &[DoubleDouble],
    connection: &[Twist<DoubleDouble>],
    values: impl Fn(&[Wide]) -> Values<Wide>,
) -> Vec<Twist<DoubleDouble>> {
    let n = q.len();
    let rates: Vec<_> = (0..n).map(|i| derivative(q, i, &values).connection).collect();
    let defined = |(i, j): (usize, usize)| rates[i][j] - rates[j][i] - connection[i].ad(connection[j]);
    Values::<f64>::pairs(n).map(defined).collect()
}

pub fn wide(q: &[f64]) -> Vec<DoubleDouble> {
    q.iter().map(|&q| q.into()).collect()
}

fn curvature_formulas_are_the_curl_less_the_bracket_of_connection_formulas(case: Case) {
    for q in shapes(case, SHAPES, 4) {
        let q = wide(&q);
        let formula: Values<DoubleDouble> = case.values(&q);
        let curvature = curl_less_bracket(&q, &formula.connection, |q| case.values(q));
        let worst = compare(&Values { curvature, ..formula.clone() }, &formula).curvature;
        assert!(worst.relative <= DERIVATIVE, "{case:?} at {q:?}: {worst}");
    }
}

fn curvature_formulas_are_the_curl_less_the_bracket_of_the_cores_connection(case: Case) {
    let model: Model<Wide> = case.model().cast::<Wide>().orthonormalised();
    for q in shapes(case, SHAPES, 5) {
        let answers = Robots::new(case).answers(&q);
        let core = |q: &[Wide]| Values::of(&mut Evaluator::new(&model), q);
        let curvature = curl_less_bracket(&wide(&q), &answers.extended.connection, core);
        let worst = compare(&Values { curvature, ..answers.extended.clone() }, &answers.exact).curvature;
        let tolerance = DERIVATIVE.max(case.tolerances()[3]);
        assert!(worst.relative <= tolerance, "{case:?} at {q:?}: {worst}");
    }
}

/// 𝓑_v = c × 𝓑_ω of the curvature as it is defined: six rows of rank three, a turn about the centre of mass.
fn curvature_as_defined_turns_about_the_centre_of_mass(case: Case) {
    for q in shapes(case, SHAPES, 6) {
        let q = wide(&q);
        let formula: Values<DoubleDouble> = case.values(&q);
        let defined = curl_less_bracket(&q, &formula.connection, |q| case.values(q));
        let turn = |angular: Vector3<_>| Twist::new(angular, formula.com.cross(&angular));
        let turning = defined.iter().map(|twist| turn(twist.angular)).collect();
        let [left, right] = [defined, turning].map(|curvature| Values { curvature, ..formula.clone() });
        let worst = compare(&left, &right).curvature;
        assert!(worst.relative <= DERIVATIVE, "{case:?} at {q:?}: {worst}");
    }
}

every_case_with_pairs!(curvature_formulas_are_the_curl_less_the_bracket_of_connection_formulas);
every_case_with_pairs!(curvature_formulas_are_the_curl_less_the_bracket_of_the_cores_connection);
every_case_with_pairs!(curvature_as_defined_turns_about_the_centre_of_mass);
