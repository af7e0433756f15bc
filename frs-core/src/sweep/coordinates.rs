//! From joints to coordinates: where a mimic follower's column is added to its leader's.

use nalgebra::Matrix6xX;

use super::groups;
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

    /// The same for the first six numbers of columns of `size`, with the values of the joints from `first` on side by side in
    /// `values(first)`.
    pub(crate) fn gather_groups(&self, out: &mut [T], size: usize, values: impl Fn(usize) -> [T::Lanes; 6]) {
        assert_eq!(out.len(), self.dof() * size, "the output must have one column per coordinate");
        if self.has_mimic() {
            out.chunks_exact_mut(size).for_each(|column| column[..6].fill(T::zero()));
        }
        for first in groups::<T>(0..self.joints()) {
            let values = values(first);
            for (lane, body) in (0..T::Lanes::WIDTH).zip(&self.bodies()[1 + first..]) {
                let column = &mut out[body.drive.coordinate * size..][..6];
                for (entry, values) in column.iter_mut().zip(&values) {
                    // Without mimic joints a column is one joint's, and need not be empty before.
                    let before = if self.has_mimic() { *entry } else { T::zero() };
                    *entry = before + values.lane(lane) * body.drive.ratio;
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
