//! The lanes under the scalar contract.

use num_traits::{One, Zero};

use super::{F32x8, F32x16, F64x4, F64x8};
use crate::{Lanes, Real};

macro_rules! impl_real {
    ($Lanes:ident, $element:ty, $($lane:literal)*) => {
        impl Real for $Lanes {
            type Lanes = Self;

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

        impl Lanes<$element> for $Lanes {
            const WIDTH: usize = Self::LANES;

            #[inline(always)]
            fn splat(value: $element) -> Self {
                Self::splat(value)
            }

            #[inline(always)]
            fn from_fn(number: impl Fn(usize) -> $element) -> Self {
                Self::from_array([$(number($lane)),*])
            }

            #[inline(always)]
            fn gather<const R: usize>(numbers: impl Fn(usize) -> [$element; R]) -> [Self; R] {
                let each = [$(numbers($lane)),*];
                let mut gathered = [Self::zero(); R];
                for (r, lanes) in gathered.iter_mut().enumerate() {
                    *lanes = Self::from_array([$(each[$lane][r]),*]);
                }
                gathered
            }

            #[inline(always)]
            fn lane(&self, lane: usize) -> $element {
                self.as_array()[lane]
            }

            #[inline(always)]
            fn set_lane(&mut self, lane: usize, value: $element) {
                self.as_mut_array()[lane] = value;
            }

            #[inline(always)]
            fn first_of(self, lanes: usize, others: Self) -> Self {
                Self::from_array([$($lane as $element),*]).select_below(lanes as f64, self, others)
            }

            #[inline(always)]
            fn read(numbers: &[$element]) -> Self {
                <Self as Lanes<$element>>::from_fn(|lane| numbers[lane])
            }

            #[inline(always)]
            fn write(self, numbers: &mut [$element]) {
                numbers[..Self::LANES].copy_from_slice(&self.to_array());
            }
        }

        impl Zero for $Lanes {
            #[inline(always)]
            fn zero() -> Self {
                Self::splat(0.0)
            }

            #[inline(always)]
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

impl_real!(F64x4, f64, 0 1 2 3);
impl_real!(F64x8, f64, 0 1 2 3 4 5 6 7);
impl_real!(F32x8, f32, 0 1 2 3 4 5 6 7);
impl_real!(F32x16, f32, 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
