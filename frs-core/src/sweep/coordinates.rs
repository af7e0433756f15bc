//! From joints to coordinates: where a mimic follower's column is added to its leader's.

use nalgebra::{DMatrix, Matrix6xX};
use num_traits::Zero;

use crate::model::Model;
use crate::{Lanes, Real};

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
        let columns = self.empty_columns(out);
        for (j, body) in self.bodies()[1..].iter().enumerate() {
            let (column, value) = (&mut columns[body.drive.coordinate], value(j));
            for r in 0..6 {
                column[r] += value[r] * body.drive.ratio;
            }
        }
    }

    /// The same, with the values of the joints from `first` on side by side in `values(first)`.
    pub(crate) fn gather_groups(&self, out: &mut Matrix6xX<T>, values: impl Fn(usize) -> [T::Lanes; 6]) {
        let columns = self.empty_columns(out);
        for (group, bodies) in self.bodies()[1..].chunks(T::Lanes::WIDTH).enumerate() {
            let values = values(group * T::Lanes::WIDTH);
            for (lane, body) in bodies.iter().enumerate() {
                let column = &mut columns[body.drive.coordinate];
                for r in 0..6 {
                    column[r] += values[r].lane(lane) * body.drive.ratio;
                }
            }
        }
    }

    /// The columns of `out`, zero.
    fn empty_columns<'o>(&self, out: &'o mut Matrix6xX<T>) -> &'o mut [[T; 6]] {
        assert_eq!(out.ncols(), self.dof(), "the output must have one column per coordinate");
        let (columns, _) = out.as_mut_slice().as_chunks_mut();
        columns.fill([T::zero(); 6]);
        columns
    }
}

/// A square block over the coordinates, filled from values over pairs of joints: a triangle along memory, which is then
/// [mirrored](Self::mirror) to the other side of the diagonal.
///
/// With mimic joints both sides are added to at once, and there is nothing to mirror.
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

    /// Entries (i, j) = `values[i]` for the joints i from `start` on.
    #[inline(always)]
    pub fn column(&mut self, j: usize, start: usize, values: &[T]) {
        let joints = self.model.joints();
        if self.model.has_mimic() {
            return (start..joints).for_each(|i| self.add(i, j, values[i]));
        }
        let (values, column) = (&values[start..joints], self.first + (self.first + j) * self.stride);
        let entries = &mut self.entries[column + start..][..values.len()];
        let (whole, rest) = values.split_at(values.len() - values.len() % T::Lanes::WIDTH);
        let (entries, last) = entries.split_at_mut(whole.len());
        for (entries, values) in entries.chunks_exact_mut(T::Lanes::WIDTH).zip(whole.chunks_exact(T::Lanes::WIDTH)) {
            (T::Lanes::read(values) + T::Lanes::zero()).write(entries);
        }
        last.iter_mut().zip(rest).for_each(|(entry, &value)| *entry = value + T::zero());
    }

    /// Entries (i, j) = `values[j]` for the joints j from i on; they stand in column i until they are mirrored.
    #[inline(always)]
    pub fn row(&mut self, i: usize, values: &[T]) {
        if self.model.has_mimic() {
            return (i..self.model.joints()).for_each(|j| self.add(i, j, values[j]));
        }
        self.column(i, i, values);
    }

    /// Column j and, once they are mirrored, row j from the diagonal on of a matrix with `entry(j, i) = sign·entry(i, j)`, sign 1 or −1.
    #[inline(always)]
    pub fn both(&mut self, j: usize, sign: T, values: &[T]) {
        self.column(j, j, values);
        if self.model.has_mimic() {
            (j + 1..self.model.joints()).for_each(|i| self.add(j, i, sign * values[i]));
        }
    }

    /// Entry (j, i) becomes `sign`·entry (i, j) for i > j, tile by tile.
    pub fn mirror(&mut self, sign: T) {
        const TILE: usize = 4;
        if self.model.has_mimic() {
            return;
        }
        let (joints, stride, first) = (self.model.joints(), self.stride, self.first);
        let columns = &mut self.entries[first * stride..];
        let whole = joints - joints % TILE;
        for corner in (0..whole).step_by(TILE) {
            let (left, right) = columns.split_at_mut((corner + TILE) * stride);
            let tiles =
                |c: usize| left[(corner + c) * stride..][first + corner + TILE..first + whole].as_chunks::<TILE>().0;
            let ([a, b, c, d], right) =
                ([tiles(0), tiles(1), tiles(2), tiles(3)], right.chunks_exact_mut(TILE * stride));
            for ((((a, b), c), d), columns) in a.iter().zip(b).zip(c).zip(d).zip(right) {
                for (r, column) in columns.chunks_exact_mut(stride).enumerate() {
                    let turned = [a[r], b[r], c[r], d[r]].map(|value| sign * value + T::zero());
                    column[first + corner..][..TILE].copy_from_slice(&turned);
                }
            }
        }
        // What is in no tile: in those on the diagonal, and in the last rows.
        for column in 0..whole {
            for row in column + 1..column - column % TILE + TILE {
                columns[first + column + row * stride] = sign * columns[first + row + column * stride] + T::zero();
            }
        }
        for row in whole..joints {
            let (left, right) = columns.split_at_mut(row * stride);
            let values = left.iter().skip(first + row).step_by(stride);
            let entries = right[first..first + row].iter_mut().zip(values);
            entries.for_each(|(entry, &value)| *entry = sign * value + T::zero());
        }
    }

    /// Adds `value` of the joint pair (i, j) to the pair of their coordinates.
    fn add(&mut self, i: usize, j: usize, value: T) {
        let [row, column] = [i, j].map(|joint| self.model.bodies()[joint + 1].drive);
        let index = self.first + row.coordinate + (self.first + column.coordinate) * self.stride;
        self.entries[index] += value * row.ratio * column.ratio;
    }
}
