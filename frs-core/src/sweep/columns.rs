//! Vectors over the joints, component by component, so that loops over pairs of joints run along memory.

use std::ops::Range;

use crate::Real;

/// Joints worked on at once: one 256-bit register of doubles.
const LANES: usize = 4;

/// `R` numbers for each joint, stored as `R` rows over all joints.
///
/// Loops run in whole groups of lanes: they write up to [`LANES`] − 1 entries beyond the end of their range, so ranges of
/// one row are filled from left to right, and rows are longer than the joints by [`LANES`]. Each joint's own order of
/// operations is that of a plain loop.
#[derive(Clone, Debug)]
pub(crate) struct Columns<T, const R: usize> {
    data: Vec<T>,
    stride: usize,
}

/// Room for one row over `joints` joints, with the lanes beyond the end.
pub(crate) fn row<T: Real>(joints: usize) -> Vec<T> {
    vec![T::zero(); joints + LANES]
}

impl<T: Real, const R: usize> Columns<T, R> {
    pub fn new(joints: usize) -> Self {
        let stride = joints + LANES;
        Self { data: vec![T::zero(); R * stride], stride }
    }

    /// Sets the `R` numbers of joint `j`.
    #[inline(always)]
    pub fn set(&mut self, j: usize, value: [T; R]) {
        let last = (R - 1) * self.stride;
        let data = &mut self.data[j..][..=last];
        for (r, x) in value.into_iter().enumerate() {
            data[r * self.stride] = x;
        }
    }

    /// The `R` numbers of joint `j`.
    pub fn get(&self, j: usize) -> [T; R] {
        std::array::from_fn(|r| self.data[r * self.stride + j])
    }

    /// `out[j] = Σ_r coefficients[r]·self[j][r]` over the first `S` rows, for the joints in `range`.
    #[inline(always)]
    pub fn dot<const S: usize>(&self, coefficients: [T; S], range: Range<usize>, out: &mut [T]) {
        if range.is_empty() {
            return;
        }
        let rows = self.rows(&range);
        for (k, out) in lanes_mut(out, &range).iter_mut().enumerate() {
            *out = add_dot(&rows, coefficients, k, [T::zero(); LANES]);
        }
    }

    /// `out[j] = Σ_r coefficients[r]·self[j][r] + Σ_r others[r]·other[j][r]`, term by term, for the joints in `range`.
    #[inline(always)]
    pub fn dot_both<const S: usize, const Q: usize, const P: usize>(
        &self,
        coefficients: [T; S],
        other: &Columns<T, Q>,
        others: [T; P],
        range: Range<usize>,
        out: &mut [T],
    ) {
        if range.is_empty() {
            return;
        }
        let (rows, other_rows) = (self.rows(&range), other.rows(&range));
        for (k, out) in lanes_mut(out, &range).iter_mut().enumerate() {
            *out = add_dot(&other_rows, others, k, add_dot(&rows, coefficients, k, [T::zero(); LANES]));
        }
    }

    /// `out[j] += Σ_r coefficients[r]·self[j][r]`, term by term, for the joints in `range`.
    #[inline(always)]
    pub fn add_dot<const S: usize>(&self, coefficients: [T; S], range: Range<usize>, out: &mut [T]) {
        let rows = self.rows(&range);
        for (k, out) in lanes_mut(out, &range).iter_mut().enumerate() {
            *out = add_dot(&rows, coefficients, k, *out);
        }
    }

    /// The first `S` rows over `range`, in groups of lanes.
    #[inline(always)]
    fn rows<const S: usize>(&self, range: &Range<usize>) -> [&[[T; LANES]]; S] {
        const { assert!(S <= R) };
        let length = range.len().next_multiple_of(LANES);
        std::array::from_fn(|r| self.data[r * self.stride + range.start..][..length].as_chunks().0)
    }
}

#[inline(always)]
fn lanes_mut<'a, T: Real>(out: &'a mut [T], range: &Range<usize>) -> &'a mut [[T; LANES]] {
    out[range.start..][..range.len().next_multiple_of(LANES)].as_chunks_mut().0
}

/// `sum + Σ_r coefficients[r]·rows[r][group]`, lane by lane. By value: nothing can alias the sum, so it stays in one
/// register.
#[inline(always)]
fn add_dot<T: Real, const R: usize>(
    rows: &[&[[T; LANES]]; R],
    coefficients: [T; R],
    group: usize,
    mut sum: [T; LANES],
) -> [T; LANES] {
    for (row, coefficient) in rows.iter().zip(coefficients) {
        let values = row[group];
        for lane in 0..LANES {
            sum[lane] += coefficient * values[lane];
        }
    }
    sum
}
