//! Vectors over the joints, component by component, so that loops over joints run along memory.

use std::ops::Range;

use crate::Real;

/// `R` numbers for each joint, stored as `R` rows over all joints.
#[derive(Clone, Debug)]
pub(crate) struct Columns<T, const R: usize> {
    data: Vec<T>,
    joints: usize,
}

impl<T: Real, const R: usize> Columns<T, R> {
    pub fn new(joints: usize) -> Self {
        Self { data: vec![T::zero(); R * joints], joints }
    }

    /// The `R` numbers of joint `j`.
    #[inline(always)]
    pub fn get(&self, j: usize) -> [T; R] {
        let data = &self.data[..R * self.joints];
        assert!(j < self.joints);
        std::array::from_fn(|r| data[r * self.joints + j])
    }

    /// Sets the `R` numbers of joint `j`.
    #[inline(always)]
    pub fn set(&mut self, j: usize, value: [T; R]) {
        let joints = self.joints;
        let data = &mut self.data[..R * joints];
        assert!(j < joints);
        for (r, x) in value.into_iter().enumerate() {
            data[r * joints + j] = x;
        }
    }

    /// `out[j] = Σ_r coefficients[r]·self[j][r]` over the first `S` rows, for the joints in `range`.
    #[inline(always)]
    pub fn dot<const S: usize>(&self, coefficients: [T; S], range: Range<usize>, out: &mut [T]) {
        let rows = self.rows::<S>(range.clone());
        for (j, out) in out[range].iter_mut().enumerate() {
            let mut sum = coefficients[0] * rows[0][j];
            for r in 1..S {
                sum += coefficients[r] * rows[r][j];
            }
            *out = sum;
        }
    }

    /// `out[j] += Σ_r coefficients[r]·self[j][r]`, term by term, for the joints in `range`.
    #[inline(always)]
    pub fn add_dot<const S: usize>(&self, coefficients: [T; S], range: Range<usize>, out: &mut [T]) {
        let rows = self.rows::<S>(range.clone());
        for (j, out) in out[range].iter_mut().enumerate() {
            let mut sum = *out;
            for r in 0..S {
                sum += coefficients[r] * rows[r][j];
            }
            *out = sum;
        }
    }

    #[inline(always)]
    fn rows<const S: usize>(&self, range: Range<usize>) -> [&[T]; S] {
        const { assert!(S <= R) };
        std::array::from_fn(|r| &self.data[r * self.joints + range.start..r * self.joints + range.end])
    }
}
