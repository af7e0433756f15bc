//! A number of some 31 digits: the sum of two doubles.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};
use twofloat::TwoFloat;

use crate::Real;

/// `high + low`, each a double, for measuring the accuracy of everything in the core by evaluating it with twice the digits.
///
/// Sums, products and roots are those of the crate `twofloat`. Its quotients (0.8.4) have the error of a double, its
/// trigonometric functions fewer digits than its sums, so these are computed here. Errors are below 2⁻¹⁰⁰, relatively; for sine
/// and cosine absolutely, for angles up to 10¹⁶ rad. Numbers below 10⁻²⁹⁰ have fewer digits.
///
/// ```
/// use frs_core::{Model, Workspace, extended::DoubleDouble};
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// let exact = model.cast::<DoubleDouble>().orthonormalised();
/// let q = [0.1, -0.4, 0.3, 1.2, 0.0, -0.7, 0.2];
/// let com = Workspace::new(&model).shape(&q).com();
/// let com_exact = Workspace::new(&exact).shape(&q.map(DoubleDouble::from)).com();
/// assert!((com_exact.x - com.x.into()).high().abs() < 1e-15);
/// # Ok::<(), frs_core::urdf::UrdfError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble(TwoFloat);

/// Four doubles whose sum is π/2 to 210 bits, the rounded part of what is left each time.
const HALF_PI: [f64; 4] =
    [FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_8e-33, 5.562_271_104_316_826e-50];

/// Terms of the series of sine and cosine: (π/4)³⁰/30! is below 2⁻¹¹⁰.
const TERMS: u32 = 14;

impl DoubleDouble {
    /// The double nearest to this number.
    pub fn high(self) -> f64 {
        self.0.hi()
    }

    /// What [`DoubleDouble::high`] leaves, to 53 bits.
    pub fn low(self) -> f64 {
        self.0.lo()
    }

    /// The quarter turns in this angle, modulo 4, and what is left, within ±π/4.
    fn quarters(self) -> (i64, TwoFloat) {
        let (mut quarters, mut rest) = (0, self.0);
        // Each round leaves the rounding of the one before it; NaN and what no double counts end after the third.
        for _ in 0..3 {
            let turns = (rest.hi() * FRAC_2_PI).round();
            if turns == 0.0 {
                break;
            }
            for part in HALF_PI {
                rest -= TwoFloat::new_mul(turns, part);
            }
            quarters += (turns % 4.0) as i64;
        }
        (quarters.rem_euclid(4), rest)
    }
}

/// `1 − x²/(k(k+1))·(1 − x²/((k+2)(k+3))·(…))`: cos x for k = 1, sin x/x for k = 2.
fn alternating(square: TwoFloat, k: u32) -> TwoFloat {
    let one = TwoFloat::from(1.0);
    (0..TERMS).rev().fold(one, |inner, term| {
        let k = k + 2 * term;
        one - square * inner / f64::from(k * (k + 1))
    })
}

/// `x/y`, by a second digit of base 2⁵³.
fn quotient(x: TwoFloat, y: TwoFloat) -> TwoFloat {
    let first = x.hi() / y.hi();
    TwoFloat::new_add(first, (x - y * first).hi() / y.hi())
}

impl From<f64> for DoubleDouble {
    fn from(value: f64) -> Self {
        Self(value.into())
    }
}

impl From<f32> for DoubleDouble {
    fn from(value: f32) -> Self {
        f64::from(value).into()
    }
}

impl From<DoubleDouble> for f64 {
    /// The double nearest to the number.
    fn from(number: DoubleDouble) -> Self {
        number.high()
    }
}

impl Real for DoubleDouble {
    type Lanes = Self;

    fn from_f64(value: f64) -> Self {
        value.into()
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (quarters, rest) = self.quarters();
        let square = rest * rest;
        let (sin, cos) = (Self(rest * alternating(square, 2)), Self(alternating(square, 1)));
        match quarters {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    fn atan2(self, x: Self) -> Self {
        let (y, nearest) = (self, self.high().atan2(x.high()));
        let (sin, cos) = Self::from(nearest).sin_cos();
        // The tangent of what is left; it is too small for its cube to count.
        let radius = x * cos + y * sin;
        if radius.is_zero() { nearest.into() } else { Self::from(nearest) + (y * cos - x * sin) / radius }
    }

    fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self {
        if self.0 < limit { below } else { otherwise }
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $method_assign:ident $compute:expr;)*) => {$(
        impl $operator for DoubleDouble {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self($compute(self.0, other.0))
            }
        }
        impl $assign for DoubleDouble {
            fn $method_assign(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}
operators! {
    Add add AddAssign add_assign Add::add;
    Sub sub SubAssign sub_assign Sub::sub;
    Mul mul MulAssign mul_assign Mul::mul;
    Div div DivAssign div_assign quotient;
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Zero for DoubleDouble {
    fn zero() -> Self {
        0.0.into()
    }
    fn is_zero(&self) -> bool {
        self.0.hi() == 0.0
    }
}

impl One for DoubleDouble {
    fn one() -> Self {
        1.0.into()
    }
}
