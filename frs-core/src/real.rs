//! The scalar contract: all that an algorithm may ask of a number.

use std::ops::Neg;

use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Scalar};
use num_traits::{One, Zero};

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
    /// Whether a processor has several of these side by side, so that a few more than are asked for cost nothing.
    const SIDE_BY_SIDE: bool = false;

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

    /// [`sin_cos`](Self::sin_cos) of several angles, which may go faster at once.
    fn sin_cos_each<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
        angles.map(Self::sin_cos)
    }

    /// The angle of the point (`x`, `self`) in (−π, π].
    fn atan2(self, x: Self) -> Self;

    /// `below` where `self < limit`, else `otherwise`. Both are already computed: a select, not a branch.
    fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self;
}

macro_rules! impl_real {
    ($float:ty, $from_f64:expr, $sin_cos:expr, $sin_cos_each:expr) => {
        impl Real for $float {
            const SIDE_BY_SIDE: bool = true;

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
            fn sin_cos_each<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
                $sin_cos_each(angles)
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

impl_real!(f64, std::convert::identity, turn::sin_cos, turn::sin_cos_each);
impl_real!(f32, |value: f64| value as f32, turn::sin_cos_single, turn::sin_cos_single_each);
