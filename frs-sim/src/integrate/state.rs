//! Points of SE(3)×Rᵐ, tangents to them, and what gives each point its tangent.

use std::ops::Range;

use frs_core::Real;
use frs_core::spatial::{Pose, Twist};

/// A point of SE(3)×Rᵐ: the pose of the base, and numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct State<T: Real = f64> {
    /// Pose g of the base in the world.
    pub pose: Pose<T>,
    /// The m numbers: joint values, velocities.
    pub flat: Vec<T>,
}

/// A tangent: the body twist V of the base, `ġ = g V^`, and the rates of the numbers. Also a finite step, as `(ζ, Δx)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Tangent<T: Real = f64> {
    /// Twist V of the base, in its own frame.
    pub twist: Twist<T>,
    /// Rates of the m numbers.
    pub flat: Vec<T>,
}

/// An equation of motion: each time and state has its tangent.
pub trait System<T: Real = f64> {
    /// How many numbers m a state has besides the pose.
    fn dimension(&self) -> usize;

    /// Which of the numbers are velocities; the others are positions. Only methods that treat the two apart ask.
    fn velocities(&self) -> Range<usize>;

    /// How many of the last numbers are only measured: no rate depends on them. Error control does not see them, so that a motion has
    /// the same bits whatever is measured on the way.
    fn measured(&self) -> usize {
        0
    }

    /// The tangent at `state` and `time` (s), written into all of `rate`.
    fn rate(&mut self, time: T, state: &State<T>, rate: &mut Tangent<T>);
}

impl<T: Real> State<T> {
    /// Identity and zeros.
    pub fn origin(dimension: usize) -> Self {
        Self { pose: Pose::identity(), flat: vec![T::zero(); dimension] }
    }

    /// Sets `self` to `from` moved by the step `(ζ, Δx)`: `(g exp ζ, x + Δx)`. Rounding does not add up: the rotation is made one again.
    pub fn set_moved(&mut self, from: &Self, step: &Tangent<T>) {
        self.pose = (from.pose * Pose::exp(step.twist)).orthonormalised();
        for ((x, &from), &step) in self.flat.iter_mut().zip(&from.flat).zip(&step.flat) {
            *x = from + step;
        }
    }
}

impl<T: Real> Tangent<T> {
    /// Zeros.
    pub fn zero(dimension: usize) -> Self {
        Self { twist: Twist::zero(), flat: vec![T::zero(); dimension] }
    }

    /// Sets `self` to `factor·Σ_s coefficients[s]·terms[s]`; terms beyond the coefficients do not count.
    pub(super) fn set_sum(&mut self, factor: T, coefficients: &[T], terms: &[Self]) {
        self.twist = Twist::zero();
        self.flat.fill(T::zero());
        for (&coefficient, term) in coefficients.iter().zip(terms).filter(|(coefficient, _)| !coefficient.is_zero()) {
            let weight = factor * coefficient;
            self.twist += term.twist * weight;
            for (x, &rate) in self.flat.iter_mut().zip(&term.flat) {
                *x += rate * weight;
            }
        }
    }
}
