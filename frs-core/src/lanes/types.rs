//! Several numbers side by side, each lane with the bits of the plain number.

use std::array::from_fn;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::turn;

/// An operation lane by lane, with the plain number on either side and with assignment.
macro_rules! operation {
    ($Lanes:ident, $element:ty, $Operation:ident, $operation:ident, $Assign:ident, $assign:ident) => {
        impl $Operation for $Lanes {
            type Output = Self;
            #[inline(always)]
            fn $operation(self, other: Self) -> Self {
                Self(self.0.$operation(other.0))
            }
        }

        impl $Operation<$element> for $Lanes {
            type Output = Self;
            #[inline(always)]
            fn $operation(self, other: $element) -> Self {
                self.$operation(Self::splat(other))
            }
        }

        impl $Operation<$Lanes> for $element {
            type Output = $Lanes;
            #[inline(always)]
            fn $operation(self, other: $Lanes) -> $Lanes {
                $Lanes::splat(self).$operation(other)
            }
        }

        impl $Assign for $Lanes {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                *self = (*self).$operation(other);
            }
        }

        impl $Assign<$element> for $Lanes {
            #[inline(always)]
            fn $assign(&mut self, other: $element) {
                *self = (*self).$operation(other);
            }
        }
    };
}

macro_rules! lanes {
    ($Lanes:ident, $wide:ty, $element:ty, $count:literal, $caption:literal) => {
        #[doc = $caption]
        ///
        /// Arithmetic is plain IEEE arithmetic in each lane: nothing is contracted that does not say so, nothing approximated.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[repr(transparent)]
        pub struct $Lanes($wide);

        impl $Lanes {
            /// Number of lanes.
            pub const LANES: usize = $count;

            /// The same number in every lane.
            #[inline(always)]
            pub fn splat(value: $element) -> Self {
                Self(<$wide>::splat(value))
            }

            /// The numbers of the lanes, the first one first.
            #[inline(always)]
            pub fn from_array(lanes: [$element; $count]) -> Self {
                Self(<$wide>::new(lanes))
            }

            /// The numbers of the lanes, the first one first.
            #[inline(always)]
            pub fn to_array(self) -> [$element; $count] {
                self.0.to_array()
            }

            /// The numbers of the lanes, where they stand.
            #[inline(always)]
            pub fn as_array(&self) -> &[$element; $count] {
                self.0.as_array()
            }

            /// The numbers of the lanes, to be written where they stand.
            #[inline(always)]
            pub fn as_mut_array(&mut self) -> &mut [$element; $count] {
                self.0.as_mut_array()
            }

            /// `self`·`factor` + `summand` in each lane, rounded once.
            #[inline(always)]
            pub fn mul_add(self, factor: Self, summand: Self) -> Self {
                if cfg!(target_feature = "fma") {
                    return Self(self.0.mul_add(factor.0, summand.0));
                }
                // Without the instruction `wide` rounds twice.
                let (a, b, c) = (self.to_array(), factor.to_array(), summand.to_array());
                Self::from_array(from_fn(|lane| a[lane].mul_add(b[lane], c[lane])))
            }

            /// √ of each lane.
            #[inline(always)]
            pub fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }

            /// The angle of the point (`x`, `self`) in each lane, in (−π, π].
            #[inline(always)]
            pub fn atan2(self, x: Self) -> Self {
                let (y, x) = (self.to_array(), x.to_array());
                Self::from_array(from_fn(|lane| y[lane].atan2(x[lane])))
            }
        }

        impl Neg for $Lanes {
            type Output = Self;
            /// Turns the sign of every lane, of zeros too.
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        operation!($Lanes, $element, Add, add, AddAssign, add_assign);
        operation!($Lanes, $element, Sub, sub, SubAssign, sub_assign);
        operation!($Lanes, $element, Mul, mul, MulAssign, mul_assign);
        operation!($Lanes, $element, Div, div, DivAssign, div_assign);
    };
}

/// What doubles do at once, and singles as doubles.
macro_rules! doubles {
    ($Lanes:ident, $wide:ty) => {
        impl $Lanes {
            /// (sin, cos) of each lane, in radians.
            pub fn sin_cos(self) -> (Self, Self) {
                if self.0.abs().simd_lt(<$wide>::splat(turn::NEAR)).all() {
                    return turn::near(self, Self::splat, |x, limit, below, otherwise| {
                        x.select_below(limit, below, otherwise)
                    });
                }
                let pairs = self.to_array().map(turn::sin_cos);
                (Self::from_array(pairs.map(|(sin, _)| sin)), Self::from_array(pairs.map(|(_, cos)| cos)))
            }

            /// `below` in the lanes where `self < limit`, else `otherwise`.
            #[inline(always)]
            pub fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self {
                Self(self.0.simd_lt(<$wide>::splat(limit)).select(below.0, otherwise.0))
            }
        }
    };
}

/// What singles do as doubles, eight at a time.
macro_rules! singles {
    ($Lanes:ident, $count:literal) => {
        impl $Lanes {
            /// (sin, cos) of each lane, in radians.
            pub fn sin_cos(self) -> (Self, Self) {
                let (mut sin, mut cos) = (self.to_array(), self.to_array());
                for first in (0..$count).step_by(8) {
                    let doubles = F64x8::from_array(from_fn(|lane| f64::from(sin[first + lane])));
                    let (sines, cosines) = doubles.sin_cos();
                    let (sines, cosines) = (sines.to_array(), cosines.to_array());
                    for lane in 0..8 {
                        (sin[first + lane], cos[first + lane]) = (sines[lane] as f32, cosines[lane] as f32);
                    }
                }
                (Self::from_array(sin), Self::from_array(cos))
            }

            /// `below` in the lanes where `self < limit`, else `otherwise`.
            #[inline(always)]
            pub fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self {
                let (value, below, otherwise) = (self.to_array(), below.to_array(), otherwise.to_array());
                let select = |lane: usize| if f64::from(value[lane]) < limit { below[lane] } else { otherwise[lane] };
                Self::from_array(from_fn(select))
            }
        }
    };
}

lanes!(F64x4, wide::f64x4, f64, 4, "Four doubles side by side.");
lanes!(F64x8, wide::f64x8, f64, 8, "Eight doubles side by side.");
lanes!(F32x8, wide::f32x8, f32, 8, "Eight singles side by side.");
lanes!(F32x16, wide::f32x16, f32, 16, "Sixteen singles side by side.");
doubles!(F64x4, wide::f64x4);
doubles!(F64x8, wide::f64x8);
singles!(F32x8, 8);
singles!(F32x16, 16);
