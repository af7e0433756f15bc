//! Numbers of 320 bits, to judge the others by.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use astro_float::{BigFloat, Consts, RoundingMode};
use nalgebra::SMatrix;
use num_traits::{One, Zero};

const BITS: usize = 320;
const ROUNDING: RoundingMode = RoundingMode::ToEven;

/// A number of 320 bits, whose exponent neither overflows nor underflows here.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Big(BigFloat);

impl Big {
    /// The number `value`, exactly.
    pub fn new(value: f64) -> Self {
        if value.is_subnormal() {
            // BigFloat::from_f64 halves them.
            return Self::new(value * 2.0_f64.powi(64)) * Self::new(0.5_f64.powi(64));
        }
        Self(BigFloat::from_f64(value, BITS))
    }

    /// The `f64` next to this number, within one unit in the last place.
    pub fn to_f64(&self) -> f64 {
        let Some((words, _, sign, exponent, _)) = self.0.as_raw_parts() else { return f64::NAN };
        let mantissa = words.last().map_or(0.0, |&word| word as f64) / 2.0_f64.powi(64);
        // In two steps, so that neither factor leaves the range of f64.
        let half = exponent / 2;
        f64::from(sign.to_int()) * (mantissa * 2.0_f64.powi(half)) * 2.0_f64.powi(exponent - half)
    }

    pub fn abs(&self) -> Self {
        Self(self.0.abs())
    }

    pub fn sqrt(&self) -> Self {
        Self(self.0.sqrt(BITS, ROUNDING))
    }

    pub fn sin_cos(&self) -> (Self, Self) {
        let mut constants = constants();
        (Self(self.0.sin(BITS, ROUNDING, &mut constants)), Self(self.0.cos(BITS, ROUNDING, &mut constants)))
    }

    /// The angle of the point (`x`, `self`), both ≥ 0.
    pub fn atan2_of_quadrant(&self, x: &Self) -> Self {
        let mut constants = constants();
        if x.is_zero() {
            return Self(constants.pi(BITS, ROUNDING)) / Self::new(2.0);
        }
        Self((self.clone() / x.clone()).0.atan(BITS, ROUNDING, &mut constants))
    }
}

fn constants() -> Consts {
    Consts::new().expect("the cache of constants can be allocated")
}

macro_rules! operator {
    ($($trait:ident $method:ident $trait_assign:ident $method_assign:ident),*) => {$(
        impl $trait for Big {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(&other.0, BITS, ROUNDING))
            }
        }
        impl $trait_assign for Big {
            fn $method_assign(&mut self, other: Self) {
                *self = self.clone().$method(other);
            }
        }
    )*};
}
operator!(Add add AddAssign add_assign, Sub sub SubAssign sub_assign);
operator!(Mul mul MulAssign mul_assign, Div div DivAssign div_assign);

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

/// The largest absolute entry.
pub fn largest<const R: usize, const C: usize>(matrix: &SMatrix<Big, R, C>) -> Big {
    matrix.iter().map(Big::abs).fold(Big::zero(), |a, b| if a < b { b } else { a })
}

/// `Σ a^k/(k+shift)!`: `exp(a)` for shift 0, its right-trivialised tangent for shift 1.
pub fn exponential_series<const N: usize>(a: &SMatrix<Big, N, N>, shift: u32) -> SMatrix<Big, N, N> {
    let enough = largest(a) * Big::new(1e-60);
    let mut term = SMatrix::<Big, N, N>::identity();
    let mut sum = term.clone();
    let mut k = 0;
    while enough < largest(&term) {
        k += 1;
        term = &term * a * (Big::one() / Big::new(f64::from(k + shift)));
        sum += &term;
    }
    sum
}

/// `exp(a)` for large a too: `(exp(a/2^m))^(2^m)`.
pub fn exponential<const N: usize>(a: &SMatrix<Big, N, N>) -> SMatrix<Big, N, N> {
    const HALVINGS: i32 = 9;
    let mut power = exponential_series(&(a * Big::new(0.5_f64.powi(HALVINGS))), 0);
    for _ in 0..HALVINGS {
        power = &power * &power;
    }
    power
}
