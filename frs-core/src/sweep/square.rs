//! A matrix over the coordinates, made of values over pairs of joints.

use nalgebra::DMatrix;
use num_traits::Zero;

use super::Row;
use super::parts::each;
use crate::model::Model;
use crate::{Lanes, Real};

/// A square block over the coordinates, filled from values over pairs of joints: a triangle along memory, which is then
/// [mirrored](Self::mirror) to the other side of the diagonal.
///
/// A value is a sum of products, of one [form](Form) where the later joint is below the earlier one, in its subtree, of another where it
/// is beside it.
///
/// With mimic joints both sides are added to at once, and there is nothing to mirror.
pub(crate) struct Square<'a, 'm, T: Real> {
    model: &'m Model<T>,
    entries: &'a mut [T],
    stride: usize,
    first: usize,
    symmetry: Symmetry,
    /// For what cannot be written to its place at once.
    row: &'a mut Row<T>,
}

/// What one triangle says of the other.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Symmetry {
    /// It is the same. Values are entries (j, i), the later joint first.
    Symmetric,
    /// It is the negative. Values are entries (j, i), too.
    Skew,
    /// Nothing: [rows](Square::rows) give one triangle, which is mirrored to its side, [columns](Square::columns) the other one then.
    Absent,
}

/// A sum of `R` products: the factors of the joints of one group, and those of the joints of all groups.
pub(crate) type Form<'c, L, const R: usize> = (&'c [L; R], &'c [[L; R]]);

impl<'a, 'm, T: Real> Square<'a, 'm, T> {
    /// The block that starts at (`first`, `first`) of `out`; with mimic joints it is set to 0, ready to be added to.
    ///
    /// What `out` holds above the block is lost.
    pub fn new(
        model: &'m Model<T>,
        out: &'a mut DMatrix<T>,
        first: usize,
        symmetry: Symmetry,
        row: &'a mut Row<T>,
    ) -> Self {
        let size = first + model.dof();
        assert_eq!(out.shape(), (size, size), "the output must be {size}×{size}");
        if model.has_mimic() {
            out.view_range_mut(first.., first..).fill(T::zero());
        }
        Self { model, entries: out.as_mut_slice(), stride: size, first, symmetry, row }
    }

    /// Values over the joints i of the group of `first` and the joints j from i on; they stand in column i until they are mirrored.
    #[inline(always)]
    pub fn rows<const R: usize, const S: usize>(
        &mut self,
        first: usize,
        below: Form<T::Lanes, R>,
        beside: Form<T::Lanes, S>,
    ) {
        let (bodies, joints) = (self.model.bodies(), self.model.joints());
        let (below, beside) = (from(first, below), from(first, beside));
        // Whole groups hold more than column i from the diagonal on: what is above it, and what is in the next column, is written after
        // this. Behind the last column there is no room.
        let corner = (self.first + first) * (self.stride + 1);
        let room = joints.next_multiple_of(T::Lanes::WIDTH) - first;
        for (lane, body) in (0..T::Lanes::WIDTH).zip(&bodies[first + 1..]) {
            let column = corner + lane * self.stride;
            let direct = !self.model.has_mimic() && column + room <= self.entries.len();
            let place = if direct { &mut self.entries[column..column + room] } else { &mut self.row[first..] };
            let bounds = [body.end - 1 - first, joints - first];
            fill(place, bounds, values(below, lane), values(beside, lane));
            if self.model.has_mimic() {
                self.add_row(first + lane);
            } else if !direct {
                self.copy(first + lane, first + lane);
            }
        }
    }

    /// Entries (i, j) for the joints j of the group of `first` and the joints i after j.
    #[inline(always)]
    pub fn columns<const R: usize, const S: usize>(
        &mut self,
        first: usize,
        below: Form<T::Lanes, R>,
        beside: Form<T::Lanes, S>,
    ) {
        let joints = self.model.joints();
        let (below, beside) = (from(first, below), from(first, beside));
        for (lane, body) in (0..T::Lanes::WIDTH).zip(&self.model.bodies()[first + 1..]) {
            let (j, bounds) = (first + lane, [body.end - 1 - first, joints - first]);
            fill(&mut self.row[first..], bounds, values(below, lane), values(beside, lane));
            if self.model.has_mimic() {
                (j + 1..joints).for_each(|i| self.add(i, j, self.row[i]));
            } else {
                self.copy(j, j + 1);
            }
        }
    }

    /// Column j from `start` on becomes what is in `row`.
    fn copy(&mut self, j: usize, start: usize) {
        let values = &self.row[start..self.model.joints()];
        self.entries[(self.first + j) * self.stride + self.first + start..][..values.len()].copy_from_slice(values);
    }

    /// Entry (j, i) becomes ±entry (i, j) for i > j, four columns at a time.
    pub fn mirror(&mut self) {
        if self.model.has_mimic() {
            return;
        }
        let (joints, stride, first, sign) = (self.model.joints(), self.stride, self.first, self.symmetry.sign::<T>());
        let turned = |value: T| sign * value + T::zero();
        let mut columns = &mut self.entries[first * stride..];
        for corner in (0..joints).step_by(4) {
            let width = (joints - corner).min(4);
            let (strip, rest) = columns.split_at_mut(width * stride);
            let tile = &mut strip[first + corner..];
            for column in 0..width {
                for row in 0..column {
                    tile[row + column * stride] = turned(tile[column + row * stride]);
                }
                if self.symmetry == Symmetry::Skew {
                    tile[column * (stride + 1)] = T::zero();
                }
            }
            if rest.is_empty() {
                return;
            }
            let (a, b) = strip.split_at(2 * stride);
            let ((a, b), (c, d)) = (a.split_at(stride), b.split_at(stride));
            let [a, b, c, d] = [a, b, c, d].map(|column| &column[first + corner + 4..]);
            let values = a.iter().zip(b).zip(c).zip(d);
            for (column, (((&a, &b), &c), &d)) in rest.chunks_exact_mut(stride).zip(values) {
                column[first + corner..][..4].copy_from_slice(&[turned(a), turned(b), turned(c), turned(d)]);
            }
            columns = rest;
        }
    }

    /// Adds what is in `row` to row i from the diagonal on; with a symmetry to column i, and to row i what that says.
    fn add_row(&mut self, i: usize) {
        let joints = self.model.joints();
        if self.symmetry == Symmetry::Absent {
            return (i..joints).for_each(|j| self.add(i, j, self.row[j]));
        }
        if self.symmetry == Symmetry::Skew {
            self.row[i] = T::zero();
        }
        (i..joints).for_each(|j| self.add(j, i, self.row[j]));
        (i + 1..joints).for_each(|j| self.add(i, j, self.symmetry.sign::<T>() * self.row[j]));
    }

    /// Adds `value` of the joint pair (i, j) to the pair of their coordinates.
    fn add(&mut self, i: usize, j: usize, value: T) {
        let [row, column] = [i, j].map(|joint| self.model.bodies()[joint + 1].drive);
        let index = self.first + row.coordinate + (self.first + column.coordinate) * self.stride;
        self.entries[index] += value * row.ratio * column.ratio;
    }
}

impl Symmetry {
    /// What an entry is times the one that mirrors it.
    fn sign<T: Real>(self) -> T {
        match self {
            Self::Skew => -T::one(),
            _ => T::one(),
        }
    }
}

/// `out = factor·block` for the block in the last rows and columns of `whole`; 0 has no sign.
pub(crate) fn multiple_of_block<T: Real>(whole: &DMatrix<T>, factor: T, out: &mut DMatrix<T>) {
    let (n, size, width) = (out.nrows(), whole.nrows(), T::Lanes::WIDTH);
    let columns = whole.as_slice().chunks_exact(size).skip(size - n);
    for (column, whole) in out.as_mut_slice().chunks_exact_mut(n.max(1)).zip(columns) {
        let (mut entries, values) = (column.chunks_exact_mut(width), whole[size - n..].chunks_exact(width));
        let rest = values.remainder();
        for (entries, values) in (&mut entries).zip(values) {
            (T::Lanes::read(values) * T::Lanes::splat(factor) + T::Lanes::zero()).write(entries);
        }
        for (entry, &value) in entries.into_remainder().iter_mut().zip(rest) {
            *entry = value * factor + T::zero();
        }
    }
}

/// A form with the groups from that of `first` on.
#[inline(always)]
fn from<T: Real, L: Lanes<T>, const R: usize>(first: usize, (rows, columns): Form<L, R>) -> Form<L, R> {
    (rows, &columns[first / L::WIDTH..])
}

/// The values of a form over the joint in `lane` of its group, by groups.
#[inline(always)]
fn values<T: Real, L: Lanes<T>, const R: usize>((rows, columns): Form<L, R>, lane: usize) -> impl Fn(usize) -> L {
    let row = each(L::zero(), |r| L::splat(rows[r].lane(lane)));
    move |group| dot(&row, &columns[group])
}

/// `Σ_r a[r]·b[r]`, term by term.
#[inline(always)]
fn dot<L: Real, const R: usize>(a: &[L; R], b: &[L; R]) -> L {
    let mut products = a.iter().zip(b);
    let Some((&a, &b)) = products.next() else { return L::zero() };
    let mut sum = a * b;
    for (&a, &b) in products {
        sum = sum.plus_product(a, b);
    }
    sum
}

/// Writes whole groups: `below(k)` for the joints up to `middle`, `beside(k)` for those from there to `end`, k the number of
/// their group. What else the groups hold is no value.
#[inline(always)]
fn fill<T: Real>(
    entries: &mut [T],
    [middle, end]: [usize; 2],
    below: impl Fn(usize) -> T::Lanes,
    beside: impl Fn(usize) -> T::Lanes,
) {
    let width = T::Lanes::WIDTH;
    // Where nothing is beside, no group needs both.
    let middle = if middle == end { entries.len() } else { middle };
    let (stop, resume) = (middle / width, middle.div_ceil(width));
    for (k, entries) in entries.chunks_exact_mut(width).enumerate() {
        let values = match k {
            _ if k < stop => below(k),
            _ if k < resume => below(k).first_of(middle % width, beside(k)),
            _ => beside(k),
        };
        (values + T::Lanes::zero()).write(entries);
    }
}
