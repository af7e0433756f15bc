//! Vectors over the joints, component by component, so that what is done to every joint is done to several at once.

use std::ops::{Deref, DerefMut, Range};

use num_traits::Zero;

use super::parts::{Parts, each};
use crate::{Lanes, Real};

/// Room for `joints` joints, up to the end of their last group of lanes.
pub(crate) fn room<T: Real>(joints: usize) -> usize {
    joints.next_multiple_of(T::Lanes::WIDTH)
}

/// The first joints of the groups of lanes that hold the joints in `range`.
#[inline(always)]
pub(crate) fn groups<T: Real>(range: Range<usize>) -> impl Iterator<Item = usize> {
    let width = T::Lanes::WIDTH;
    let start = if range.is_empty() { range.end } else { range.start - range.start % width };
    (start..range.end).step_by(width)
}

/// A value of `R` numbers for each joint, in groups of lanes: all first numbers of a group, then all second ones, ….
#[derive(Clone, Debug)]
pub(crate) struct Columns<T: Real, const R: usize> {
    groups: Vec<[T::Lanes; R]>,
}

impl<T: Real, const R: usize> Columns<T, R> {
    pub fn new(joints: usize) -> Self {
        Self { groups: vec![[T::Lanes::zero(); R]; joints.div_ceil(T::Lanes::WIDTH)] }
    }

    /// Sets the value of joint `j`.
    #[inline(always)]
    pub fn set(&mut self, j: usize, value: impl Parts<T, R>) {
        let group = &mut self.groups[j / T::Lanes::WIDTH];
        for (lanes, part) in group.iter_mut().zip(value.parts()) {
            lanes.set_lane(j % T::Lanes::WIDTH, part);
        }
    }

    /// The value of joint `j`.
    #[inline(always)]
    pub fn at<V: Parts<T, R>>(&self, j: usize) -> V {
        let group = &self.groups[j / T::Lanes::WIDTH];
        V::from_parts(each(group[0].lane(0), |r| group[r].lane(j % T::Lanes::WIDTH)))
    }

    /// The values of the joints from `first` on, the first one of a group.
    #[inline(always)]
    pub fn lanes<W: Parts<T::Lanes, R>>(&self, first: usize) -> W {
        W::from_parts(self.groups[first / T::Lanes::WIDTH])
    }

    /// The numbers of the joints from `first` on, the first one of a group.
    #[inline(always)]
    pub fn group(&self, first: usize) -> &[T::Lanes; R] {
        &self.groups[first / T::Lanes::WIDTH]
    }

    /// The numbers of all joints, group by group.
    #[inline(always)]
    pub fn groups(&self) -> &[[T::Lanes; R]] {
        &self.groups
    }

    /// Sets the values of the joints from `first` on, the first one of a group.
    #[inline(always)]
    pub fn set_lanes(&mut self, first: usize, value: impl Parts<T::Lanes, R>) {
        self.groups[first / T::Lanes::WIDTH] = value.parts();
    }
}

/// A number for each joint, with room up to the end of the last group.
#[derive(Clone, Debug)]
pub(crate) struct Row<T> {
    numbers: Vec<T>,
}

impl<T: Real> Row<T> {
    pub fn new(joints: usize) -> Self {
        Self { numbers: vec![T::zero(); room::<T>(joints)] }
    }

    /// The numbers of the joints from `first` on, side by side.
    #[inline(always)]
    pub fn lanes(&self, first: usize) -> T::Lanes {
        T::Lanes::read(&self.numbers[first..])
    }
}

impl<T> Deref for Row<T> {
    type Target = [T];
    fn deref(&self) -> &[T] {
        &self.numbers
    }
}

impl<T> DerefMut for Row<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.numbers
    }
}
