//! Extended precision: [`Big`] numbers to judge the core by, [`Wide`] numbers to run it over.

pub mod exact;
pub mod judge;
mod wide;

use std::cell::RefCell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use astro_float::{BigFloat, Consts, RoundingMode};
use num_traits::{One, Zero};

pub use wide::Wide;

const BITS: usize = 256;
const ROUNDING: RoundingMode = RoundingMode::ToEven;

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().expect("a cache can be allocated"));
}

/// A number of 256 bits, whose exponent has no end.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Big(BigFloat);

impl Big {
    /// The number `value`, exactly.
    pub fn new(value: f64) -> Self {
        if value.is_subnormal() {
            // BigFloat::from_f64 halves subnormal numbers.
            return Self::new(value * 2.0_f64.powi(64)) * Self::new(0.5_f64.powi(64));
        }
        Self(BigFloat::from_f64(value, BITS))
    }

    /// This number to within a unit in the last place of `f64`.
    pub fn to_f64(&self) -> f64 {
        let Some((words, _, sign, exponent, _)) = self.0.as_raw_parts() else { return f64::NAN };
        let mantissa = words.last().map_or(0.0, |&word| word as f64) / 2.0_f64.powi(64);
        // In two steps, that neither factor leaves the range of f64.
        let half = exponent / 2;
        f64::from(sign.to_int()) * (mantissa * 2.0_f64.powi(half)) * 2.0_f64.powi(exponent - half)
    }

    pub fn is_nan(&self) -> bool {
        self.0.is_nan()
    }

    pub fn abs(&self) -> Self {
        Self(self.0.abs())
    }

    pub fn sqrt(&self) -> Self {
        Self(self.0.sqrt(BITS, ROUNDING))
    }

    pub fn sin_cos(&self) -> (Self, Self) {
        CONSTANTS.with_borrow_mut(|c| (Self(self.0.sin(BITS, ROUNDING, c)), Self(self.0.cos(BITS, ROUNDING, c))))
    }

    /// The angle of the point (`x`, `self`), which is not on the negative x axis.
    pub fn atan2(&self, x: &Self) -> Self {
        // From the half angle: tan ½θ = y/(r + x).
        let r = (self.clone() * self.clone() + x.clone() * x.clone()).sqrt();
        let half_tan = self.clone() / (r + x.clone());
        CONSTANTS.with_borrow_mut(|c| Self(half_tan.0.atan(BITS, ROUNDING, c))) * Self::new(2.0)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $method_assign:ident;)*) => {$(
        impl $operator for Big {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(&other.0, BITS, ROUNDING))
            }
        }
        impl $assign for Big {
            fn $method_assign(&mut self, other: Self) {
                self.0 = self.0.$method(&other.0, BITS, ROUNDING);
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

impl Neg for Big {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.neg())
    }
}

impl Zero for Big {
    fn zero() -> Self {
        Self::new(0.0)
    }
    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl One for Big {
    fn one() -> Self {
        Self::new(1.0)
    }
}
