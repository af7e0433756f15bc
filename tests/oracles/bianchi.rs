//! The Bianchi identity, with derivatives of the formulas in double-double.

use frs_core::extended::DoubleDouble;
use frs_core::spatial::Twist;
use frs_oracles::{Case, EXTENDED, Values, shapes};

use crate::definition::{derivative, wide};

/// Shapes a case is tried at.
const SHAPES: usize = 10;

/// A derivative loses some digits that 𝓑 itself keeps; entries of 𝓑 are of order one.
const DERIVATIVE: f64 = 10.0 * EXTENDED;

/// ∂_i 𝓑_jk − [A_i, 𝓑_jk] + cyclic = 0, where there are three coordinates.
fn bianchi(case: Case) {
    for q in shapes(case, SHAPES, 7) {
        let (q, n) = (wide(&q), q.len());
        let values: Values<DoubleDouble> = case.values(&q);
        let rates: Vec<_> = (0..n).map(|i| derivative(&q, i, |q| case.values(q))).collect();
        let covariant =
            |i: usize, j: usize, k: usize| rates[i].curvature(j, k) - values.connection[i].ad(values.curvature(j, k));
        for (i, j) in Values::<f64>::pairs(n) {
            for k in j + 1..n {
                let cyclic: Twist<_> = covariant(i, j, k) + covariant(j, k, i) + covariant(k, i, j);
                let worst = cyclic.to_array().map(|x| x.high().abs()).into_iter().fold(0.0, f64::max);
                assert!(worst <= DERIVATIVE, "{case:?} at {q:?}: ({i}, {j}, {k}): {cyclic:?} and 0");
            }
        }
    }
}

of_cases!(bianchi: p7 P7, g1 G1, g2 G2, d1 D1, d2 D2, d3 D3, d4 D4, d5 D5, c1 C1, c2 C2);
