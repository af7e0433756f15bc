//! From joints to coordinates: where a mimic follower's column is added to its leader's.

use std::ops::Range;

use nalgebra::{DMatrix, Matrix6xX};

use crate::Real;
use crate::model::Model;

impl<T: Real> Model<T> {
    /// `out[c] = Σ_j ratio_j·value(j)` over the joints that coordinate c drives.
    pub(crate) fn gather(&self, out: &mut [T], value: impl Fn(usize) -> T) {
        assert_eq!(out.len(), self.dof(), "the output must have one entry per coordinate");
        out.fill(T::zero());
        for (j, body) in self.bodies()[1..].iter().enumerate() {
            out[body.drive.coordinate] += value(j) * body.drive.ratio;
        }
    }

    /// `out[·, c] = Σ_j ratio_j·value(j)`: the same for columns of six.
    pub(crate) fn gather_columns(&self, out: &mut Matrix6xX<T>, value: impl Fn(usize) -> [T; 6]) {
        assert_eq!(out.ncols(), self.dof(), "the output must have one column per coordinate");
        let (columns, _) = out.as_mut_slice().as_chunks_mut::<6>();
        columns.fill([T::zero(); 6]);
        for (j, body) in self.bodies()[1..].iter().enumerate() {
            let (column, value) = (&mut columns[body.drive.coordinate], value(j));
            for r in 0..6 {
                column[r] += value[r] * body.drive.ratio;
            }
        }
    }
}

/// A square block over the coordinates, filled from values over pairs of joints.
pub(crate) struct Square<'a, 'm, T: Real> {
    model: &'m Model<T>,
    entries: &'a mut [T],
    stride: usize,
    first: usize,
}

impl<'a, 'm, T: Real> Square<'a, 'm, T> {
    /// The block that starts at (`first`, `first`) of `out`; with mimic joints it is set to 0, ready to be added to.
    pub fn new(model: &'m Model<T>, out: &'a mut DMatrix<T>, first: usize) -> Self {
        let size = first + model.dof();
        assert_eq!(out.shape(), (size, size), "the output must be {size}×{size}");
        if model.has_mimic() {
            out.view_range_mut(first.., first..).fill(T::zero());
        }
        Self { model, entries: out.as_mut_slice(), stride: size, first }
    }

    /// Entries (i, j) for all joints i in `range`: along memory.
    #[inline(always)]
    pub fn column(&mut self, j: usize, range: Range<usize>, value: impl Fn(usize) -> T) {
        if self.model.has_mimic() {
            range.for_each(|i| self.add(i, j, value(i)));
        } else {
            let column = self.first + (self.first + j) * self.stride;
            let entries = &mut self.entries[column + range.start..column + range.end];
            for (entry, i) in entries.iter_mut().zip(range) {
                *entry = value(i) + T::zero();
            }
        }
    }

    /// Entries (i, j) for all joints j in `range`: across memory.
    #[inline(always)]
    pub fn row(&mut self, i: usize, range: Range<usize>, value: impl Fn(usize) -> T) {
        for j in range {
            self.column(j, i..i + 1, |_| value(j));
        }
    }

    /// Column j and row j, from the diagonal on, of a matrix with `entry(j, i) = sign·entry(i, j)`, sign 1 or −1: `values[i]` for
    /// the column's joints i.
    #[inline(always)]
    pub fn both(&mut self, j: usize, sign: T, values: &[T]) {
        let joints = self.model.joints();
        if self.model.has_mimic() {
            self.column(j, j..joints, |i| values[i]);
            self.row(j, j + 1..joints, |i| sign * values[i]);
        } else {
            let (values, diagonal) = (&values[j..joints], self.first + j + (self.first + j) * self.stride);
            let column = &mut self.entries[diagonal..][..values.len()];
            column.iter_mut().zip(values).for_each(|(entry, &value)| *entry = value + T::zero());
            for (k, &value) in values.iter().enumerate().skip(1) {
                self.entries[diagonal + k * self.stride] = sign * value + T::zero();
            }
        }
    }

    /// Adds `value` of the joint pair (i, j) to the pair of their coordinates.
    fn add(&mut self, i: usize, j: usize, value: T) {
        let [row, column] = [i, j].map(|joint| self.model.bodies()[joint + 1].drive);
        let index = self.first + row.coordinate + (self.first + column.coordinate) * self.stride;
        self.entries[index] += value * row.ratio * column.ratio;
    }
}
