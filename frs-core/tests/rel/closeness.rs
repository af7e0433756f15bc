//! When two evaluations count as equal, and derivatives of what can only be evaluated.

use std::fmt::Debug;

use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, Matrix, OMatrix, RawStorage};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;

/// Rounding of sums over a dozen links of order one, a hundred times what is seen on random trees.
pub const ROUNDING: f64 = 1e-12;

/// Step of [`Around`].
const STEP: f64 = 5e-4;

/// Error of [`Around::rate`]: STEP⁴/30 of a fifth derivative, and rounding divided by STEP.
pub const DIFFERENCES: f64 = 1e-8;

/// `actual` = `expected` up to `tolerance` in units of the largest entry expected, or of 1 if that is larger.
pub fn close<R, C, S, R2, C2, S2>(
    actual: &Matrix<f64, R, C, S>,
    expected: &Matrix<f64, R2, C2, S2>,
    tolerance: f64,
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
    let bound = tolerance * largest;
    let finite = actual.iter().chain(expected.iter()).all(|entry| entry.is_finite());
    prop_assert!(
        finite && error <= bound,
        "off by {error:e}, more than {bound:e}\nactual {actual:?}\nexpected {expected:?}"
    );
    Ok(())
}

/// What a function of one number gives at −2, −1, 1 and 2 steps from 0.
pub struct Around<V>([V; 4]);

impl<V> Around<V> {
    pub fn zero(f: impl Fn(f64) -> V) -> Self {
        Self([-2.0, -1.0, 1.0, 2.0].map(|steps| f(steps * STEP)))
    }

    /// The derivative at 0 of what `part` takes of the value, by central differences of fourth order.
    pub fn rate<R: Dim, C: Dim>(&self, part: impl Fn(&V) -> OMatrix<f64, R, C>) -> OMatrix<f64, R, C>
    where
        DefaultAllocator: Allocator<R, C>,
    {
        let [far_before, before, after, far_after] = self.0.each_ref().map(part);
        ((after - before) * 8.0 - (far_after - far_before)) / (12.0 * STEP)
    }
}

/// The derivative at 0 of `f`.
pub fn derivative<R: Dim, C: Dim>(f: impl Fn(f64) -> OMatrix<f64, R, C>) -> OMatrix<f64, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    Around::zero(f).rate(Clone::clone)
}
