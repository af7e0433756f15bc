//! What takes part.

use std::ops::Range;

use crate::work::Work;

/// Name and numbers of a part of an answer, matrices by columns.
pub type Part = (&'static str, Vec<f64>);

/// A way to compute, with its states.
pub trait Contestant {
    /// Whether it does this work.
    fn does(&self, work: Work) -> bool;

    /// How many groups of states it has.
    fn groups(&self) -> usize;

    /// States of a group, computed side by side.
    fn lanes(&self) -> usize;

    /// Does the work at these groups.
    fn run(&mut self, work: Work, groups: Range<usize>);

    /// What the work gave at a state of the group that ran last.
    fn answer(&self, work: Work, lane: usize) -> Vec<Part>;
}
