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
    /// Until it is mirrored, rows of `out` above the block hold anything.
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
        let (joints, width) = (self.model.joints(), T::Lanes::WIDTH);
        for (lane, body) in (0..width).zip(&self.model.bodies()[first + 1..]) {
            let i = first + lane;
            let column = (self.first + i) * self.stride + self.first;
            // Whole groups begin above the diagonal and end in the next column: there all is written after this, but in the last column.
            let stop = column + joints.next_multiple_of(width);
            let direct = !self.model.has_mimic() && stop <= self.entries.len();
            let place = if direct { &mut self.entries[column + first..stop] } else { &mut self.row[first..] };
            fill(
                place,
                [lane, body.end - 1 - first, joints - first],
                values(below, lane, first),
                values(beside, lane, first),
            );
            if self.model.has_mimic() {
                self.add_row(i);
            } else if !direct {
                self.copy(i, i);
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
        for (lane, body) in (0..T::Lanes::WIDTH).zip(&self.model.bodies()[first + 1..]) {
            let (j, bounds) = (first + lane, [lane + 1, body.end - 1 - first, joints - first]);
            fill(&mut self.row[first..], bounds, values(below, lane, first), values(beside, lane, first));
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
            for column in 0..width {
                for row in 0..column {
                    strip[first + corner + row + column * stride] =
                        turned(strip[first + corner + column + row * stride]);
                }
                if self.symmetry == Symmetry::Skew {
                    strip[first + corner + column * (stride + 1)] = T::zero();
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

/// The values of a form over the joint in `lane` of the group of `first` and the groups from its own on.
#[inline(always)]
fn values<T: Real, L: Lanes<T>, const R: usize>(
    (rows, columns): Form<L, R>,
    lane: usize,
    first: usize,
) -> impl Fn(usize) -> L {
    let columns = &columns[first / L::WIDTH..];
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

/// Writes whole groups: `below(k)` for the joints from `start` to `middle`, `beside(k)` for those from there to `end`, k the number of
/// their group. What else the groups hold is no value.
#[inline(always)]
fn fill<T: Real>(
    entries: &mut [T],
    [start, middle, end]: [usize; 3],
    below: impl Fn(usize) -> T::Lanes,
    beside: impl Fn(usize) -> T::Lanes,
) {
    let width = T::Lanes::WIDTH;
    // Where one form is all that is needed, no group needs both.
    let middle = match middle {
        _ if start == middle => 0,
        _ if middle == end => entries.len(),
        _ => middle,
    };
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
