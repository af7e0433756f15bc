//! The lanes under the scalar contract.

use num_traits::{One, Zero};

use super::{F32x8, F32x16, F64x4, F64x8};
use crate::Real;

macro_rules! impl_real {
    ($Lanes:ident, $element:ty) => {
        impl Real for $Lanes {
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                Self::splat(<$element>::from_f64(value))
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
                self.sin_cos()
            }

            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                self.atan2(x)
            }

            #[inline(always)]
            fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self {
                self.select_below(limit, below, otherwise)
            }
        }

        impl Zero for $Lanes {
            #[inline(always)]
            fn zero() -> Self {
                Self::splat(0.0)
            }

            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }

        impl One for $Lanes {
            #[inline(always)]
            fn one() -> Self {
                Self::splat(1.0)
            }
        }
    };
}

impl_real!(F64x4, f64);
impl_real!(F64x8, f64);
impl_real!(F32x8, f32);
impl_real!(F32x16, f32);
