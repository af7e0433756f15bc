//! When two evaluations count as equal, and derivatives of what can only be evaluated.

use std::fmt::Debug;

use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, Matrix, OMatrix, RawStorage};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;

/// Rounding of a few hundred operations on numbers of order one, per unit of the condition number of Λ_b: the sums over
/// links solve with Λ_b in the base frame, which costs that factor.
pub const ROUNDING: f64 = 1e-14;

/// Step of [`derivative`].
const STEP: f64 = 1e-3;

/// Error of [`derivative`]: STEP⁴/30 of a fifth derivative, and rounding divided by STEP.
pub const DIFFERENCES: f64 = 1e-8;

/// `actual` = `expected` up to `tolerance` in units of `scale` and of the largest entry expected (at least 1).
pub fn close<R, C, S, R2, C2, S2>(
    actual: &Matrix<f64, R, C, S>,
    expected: &Matrix<f64, R2, C2, S2>,
    tolerance: f64,
    scale: f64,
) -> TestCaseResult
where
    R: Dim,
    C: Dim,
    S: RawStorage<f64, R, C> + Debug,
    R2: Dim,
    C2: Dim,
    S2: RawStorage<f64, R2, C2> + Debug,
{
    prop_assert_eq!(actual.shape(), expected.shape());
    let largest = expected.iter().fold(1.0, |largest: f64, entry| largest.max(entry.abs()));
    let error = actual.iter().zip(expected.iter()).map(|(a, e)| (a - e).abs()).fold(0.0, f64::max);
    let bound = tolerance * scale * largest;
    let finite = actual.iter().chain(expected.iter()).all(|entry| entry.is_finite());
    prop_assert!(
        finite && error <= bound,
        "off by {error:e}, more than {bound:e}\nactual {actual:?}\nexpected {expected:?}"
    );
    Ok(())
}

/// The derivative at 0 of `f`, by central differences of fourth order.
pub fn derivative<R: Dim, C: Dim>(f: impl Fn(f64) -> OMatrix<f64, R, C>) -> OMatrix<f64, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    let near = f(STEP) - f(-STEP);
    let far = f(2.0 * STEP) - f(-2.0 * STEP);
    (near * 8.0 - far) / (12.0 * STEP)
}
