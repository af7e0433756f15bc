//! Vectors over the joints, component by component, so that loops over pairs of joints run along memory.

use std::array::from_fn;
use std::ops::{Deref, DerefMut, Range};

use crate::Real;

/// Joints worked on at once: two 256-bit registers of doubles.
const LANES: usize = 8;

/// `R` numbers for each joint, stored in groups of [`LANES`] joints: all first numbers of a group, then all second ones, ….
///
/// Each joint's own order of operations is that of a plain loop.
#[derive(Clone, Debug)]
pub(crate) struct Columns<T, const R: usize> {
    groups: Vec<[[T; LANES]; R]>,
}

/// A number for each joint, in the groups of [`Columns`].
#[derive(Clone, Debug)]
pub(crate) struct Row<T> {
    groups: Vec<[T; LANES]>,
}

impl<T: Real, const R: usize> Columns<T, R> {
    pub fn new(joints: usize) -> Self {
        Self { groups: vec![[[T::zero(); LANES]; R]; joints.div_ceil(LANES)] }
    }

    /// Sets the `R` numbers of joint `j`.
    #[inline(always)]
    pub fn set(&mut self, j: usize, value: [T; R]) {
        let group = &mut self.groups[j / LANES];
        for (row, x) in group.iter_mut().zip(value) {
            row[j % LANES] = x;
        }
    }

    /// The `R` numbers of joint `j`.
    pub fn get(&self, j: usize) -> [T; R] {
        let group = &self.groups[j / LANES];
        from_fn(|r| group[r][j % LANES])
    }
}

impl<T: Real> Row<T> {
    pub fn new(joints: usize) -> Self {
        Self { groups: vec![[T::zero(); LANES]; joints.div_ceil(LANES)] }
    }

    /// `self[j] = Σ_r coefficients[r]·columns[j][r]` over the first `S` numbers, for the joints in `range`.
    ///
    /// Entries before the range stay, those behind it are lost.
    #[inline(always)]
    pub fn dot<const S: usize, const R: usize>(
        &mut self,
        coefficients: [T; S],
        columns: &Columns<T, R>,
        range: Range<usize>,
    ) {
        if !T::SIDE_BY_SIDE {
            return range.for_each(|j| self[j] = add(columns, j, coefficients, T::zero()));
        }
        let Some(groups) = groups(&range) else { return };
        let kept = self.groups[groups.start];
        let rows = self.groups[groups.clone()].iter_mut().zip(&columns.groups[groups.clone()]);
        for (row, columns) in rows {
            *row = add_dot(columns, coefficients, [T::zero(); LANES]);
        }
        self.restore(&range, kept);
    }

    /// `self[j] = Σ_r coefficients[r]·columns[j][r] + Σ_r others[r]·other[j][r]`, term by term, for the joints in `range`.
    ///
    /// Entries before the range stay, those behind it are lost.
    #[inline(always)]
    pub fn dot_both<const S: usize, const R: usize, const P: usize, const Q: usize>(
        &mut self,
        coefficients: [T; S],
        columns: &Columns<T, R>,
        others: [T; P],
        other: &Columns<T, Q>,
        range: Range<usize>,
    ) {
        if !T::SIDE_BY_SIDE {
            return range.for_each(|j| self[j] = add(other, j, others, add(columns, j, coefficients, T::zero())));
        }
        let Some(groups) = groups(&range) else { return };
        let kept = self.groups[groups.start];
        let rows = self.groups[groups.clone()].iter_mut().zip(&columns.groups[groups.clone()]);
        for ((row, columns), other) in rows.zip(&other.groups[groups.clone()]) {
            *row = add_dot(other, others, add_dot(columns, coefficients, [T::zero(); LANES]));
        }
        self.restore(&range, kept);
    }

    /// Puts the entries before `range` back into its first group.
    #[inline(always)]
    fn restore(&mut self, range: &Range<usize>, kept: [T; LANES]) {
        let (group, before) = (range.start / LANES, range.start % LANES);
        self.groups[group][..before].copy_from_slice(&kept[..before]);
    }
}

/// The groups that hold the joints in `range`.
fn groups(range: &Range<usize>) -> Option<Range<usize>> {
    (!range.is_empty()).then(|| range.start / LANES..(range.end - 1) / LANES + 1)
}

impl<T> Deref for Row<T> {
    type Target = [T];
    fn deref(&self) -> &[T] {
        self.groups.as_flattened()
    }
}

impl<T> DerefMut for Row<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        self.groups.as_flattened_mut()
    }
}

/// `sum + Σ_r coefficients[r]·columns[j][r]`.
#[inline(always)]
fn add<T: Real, const S: usize, const R: usize>(columns: &Columns<T, R>, j: usize, coefficients: [T; S], sum: T) -> T {
    columns.get(j).into_iter().zip(coefficients).fold(sum, |sum, (x, coefficient)| sum.plus_product(coefficient, x))
}

/// [`add`] for all joints of a group, lane by lane. By value: nothing can alias the sum, so it stays in registers.
#[inline(always)]
fn add_dot<T: Real, const S: usize, const R: usize>(
    columns: &[[T; LANES]; R],
    coefficients: [T; S],
    mut sum: [T; LANES],
) -> [T; LANES] {
    const { assert!(S <= R) };
    for (row, coefficient) in columns.iter().zip(coefficients) {
        for lane in 0..LANES {
            sum[lane] = sum[lane].plus_product(coefficient, row[lane]);
        }
    }
    sum
}
