//! The scalar contract: all that an algorithm may ask of a number.

use std::ops::Neg;

use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Scalar};
use num_traits::{One, Zero};

use crate::lanes::{F32x8, F64x4};
use crate::turn;

/// Whether a product and the sum that it enters are rounded together, once: this crate was built with its feature `fused`.
///
/// Either way bits are the same on every machine, but one way's are not the other's.
pub const FUSED: bool = cfg!(feature = "fused");

/// A number the dynamics can be evaluated over.
///
/// `f64` and `f32` are numbers; so is anything that records, encloses, differentiates or widens them. The contract has
/// no ordering on purpose: `if x < y` inside an algorithm does not compile, so every evaluation of an algorithm performs
/// the same operations. The one value-dependent operation is [`Real::select_below`], a select without a branch.
pub trait Real:
    Scalar + Copy + Zero + One + ClosedAddAssign + ClosedSubAssign + ClosedMulAssign + ClosedDivAssign + Neg<Output = Self>
{
    /// Several of these side by side, as a processor works on them; the number itself where that gains nothing.
    type Lanes: Lanes<Self>;

    /// The number nearest to `value`; exact when this type holds every `f64`.
    fn from_f64(value: f64) -> Self;

    /// `self·factor + summand`, which numbers, lanes and recordings round once, with the same bits on every machine.
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }

    /// `self + a·b`, a term more of a sum: rounded once where [`FUSED`], else the product and then the sum.
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        if FUSED { a.mul_add(b, self) } else { self + a * b }
    }

    /// `self − a·b`, rounded as [`plus_product`](Self::plus_product).
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        if FUSED { a.mul_add(-b, self) } else { self - a * b }
    }

    /// √`self`.
    fn sqrt(self) -> Self;

    /// (sin `self`, cos `self`), `self` in radians; of floats with the same bits on every machine ([`turn`]).
    fn sin_cos(self) -> (Self, Self);

    /// The angle of the point (`x`, `self`) in (−π, π].
    fn atan2(self, x: Self) -> Self;

    /// `below` where `self < limit`, else `otherwise`. Both are already computed: a select, not a branch.
    fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self;
}

/// [`WIDTH`](Self::WIDTH) numbers `T` side by side, each with the bits that it would have by itself.
///
/// An algorithm that does the same to every body of a robot does it to a group of bodies at once over [`Real::Lanes`], and to
/// one after the other over a number that is its own group.
pub trait Lanes<T>: Real {
    /// How many.
    const WIDTH: usize;

    /// The same number in every lane.
    fn splat(value: T) -> Self;

    /// `number(lane)` in every lane.
    fn from_fn(number: impl Fn(usize) -> T) -> Self;

    /// `R` numbers in every lane: those of `numbers(lane)`.
    fn gather<const R: usize>(numbers: impl Fn(usize) -> [T; R]) -> [Self; R];

    /// The number in lane `lane`.
    fn lane(&self, lane: usize) -> T;

    /// Sets the number in lane `lane`.
    fn set_lane(&mut self, lane: usize, value: T);

    /// The first `lanes` of these, and the rest of `others`.
    fn first_of(self, lanes: usize, others: Self) -> Self;

    /// The first [`WIDTH`](Self::WIDTH) of `numbers`.
    fn read(numbers: &[T]) -> Self;

    /// Writes to the first [`WIDTH`](Self::WIDTH) of `numbers`.
    fn write(self, numbers: &mut [T]);
}

/// A number by itself.
impl<T: Real> Lanes<T> for T {
    const WIDTH: usize = 1;

    #[inline(always)]
    fn splat(value: T) -> Self {
        value
    }

    #[inline(always)]
    fn from_fn(number: impl Fn(usize) -> T) -> Self {
        number(0)
    }

    #[inline(always)]
    fn gather<const R: usize>(numbers: impl Fn(usize) -> [T; R]) -> [Self; R] {
        numbers(0)
    }

    #[inline(always)]
    fn lane(&self, _: usize) -> T {
        *self
    }

    #[inline(always)]
    fn set_lane(&mut self, _: usize, value: T) {
        *self = value;
    }

    #[inline(always)]
    fn first_of(self, lanes: usize, others: Self) -> Self {
        if lanes > 0 { self } else { others }
    }

    #[inline(always)]
    fn read(numbers: &[T]) -> Self {
        numbers[0]
    }

    #[inline(always)]
    fn write(self, numbers: &mut [T]) {
        numbers[0] = self;
    }
}

macro_rules! impl_real {
    ($float:ty, $lanes:ty, $from_f64:expr, $sin_cos:expr) => {
        impl Real for $float {
            type Lanes = $lanes;

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                $from_f64(value)
            }

            #[inline(always)]
            fn mul_add(self, factor: Self, summand: Self) -> Self {
                self.mul_add(factor, summand)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                self.sqrt()
            }

            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }

            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                self.atan2(x)
            }

            #[inline(always)]
            fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self {
                if f64::from(self) < limit { below } else { otherwise }
            }
        }
    };
}

impl_real!(f64, F64x4, std::convert::identity, turn::sin_cos);
impl_real!(f32, F32x8, |value: f64| value as f32, turn::sin_cos_single);
