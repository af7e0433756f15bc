//! A number of three `f64` words, to run the core over: where its error is far from 10⁻⁴⁸, the core cut a series short.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use frs_core::Real;
use num_traits::{One, Zero};

use super::Big;

/// The sum of three `f64`, calculated with by way of [`Big`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide([f64; 3]);

impl Wide {
    pub fn of(mut value: Big) -> Self {
        Self([(); 3].map(|()| {
            let word = value.to_f64();
            if word.is_finite() {
                value -= Big::new(word);
            }
            word
        }))
    }

    pub fn big(self) -> Big {
        self.0.map(Big::new).into_iter().fold(Big::zero(), Add::add)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $method_assign:ident;)*) => {$(
        impl $operator for Wide {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self::of(self.big().$method(other.big()))
            }
        }
        impl $assign for Wide {
            fn $method_assign(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}
operators! {
    Add add AddAssign add_assign;
    Sub sub SubAssign sub_assign;
    Mul mul MulAssign mul_assign;
    Div div DivAssign div_assign;
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

impl Zero for Wide {
    fn zero() -> Self {
        Self([0.0; 3])
    }
    fn is_zero(&self) -> bool {
        self.0 == [0.0; 3]
    }
}

impl One for Wide {
    fn one() -> Self {
        Self::from_f64(1.0)
    }
}

impl Real for Wide {
    type Lanes = Self;

    fn from_f64(value: f64) -> Self {
        Self([value, 0.0, 0.0])
    }

    fn sqrt(self) -> Self {
        Self::of(self.big().sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.big().sin_cos();
        (Self::of(sin), Self::of(cos))
    }

    /// Not on the negative x axis.
    fn atan2(self, x: Self) -> Self {
        Self::of(self.big().atan2(&x.big()))
    }

    fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self {
        if self.big() < Big::new(limit) { below } else { otherwise }
    }
}
