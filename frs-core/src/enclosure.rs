//! A number that is known to lie between two doubles.

use std::f64::consts::PI;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};
use twofloat::TwoFloat;

use crate::Real;
use crate::extended::DoubleDouble;

/// A closed interval of real numbers, for proving how accurate the core is by evaluating it with rounding outwards.
///
/// Whatever numbers the operands hold, the result holds what exact arithmetic makes of them. Sums, products, quotients and roots of
/// single numbers end at the two doubles next to the exact one, or at itself if it is a double (below 10⁻²⁷⁶ one double further). What is not bounded, such as a
/// quotient by an interval that holds 0, is everything from −∞ to ∞. Interval arithmetic, as in IEEE 1788.
///
/// ```
/// use frs_core::{Model, Workspace, enclosure::Interval};
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// let enclosed = model.cast::<Interval>().orthonormalised();
/// let q = [0.1, -0.4, 0.3, 1.2, 0.0, -0.7, 0.2];
/// let com = Workspace::new(&enclosed).shape(&q.map(Interval::from)).com();
/// assert!(com.x.contains(Workspace::new(&model).shape(&q).com().x) && com.x.upper() - com.x.lower() < 1e-14);
/// # Ok::<(), frs_core::urdf::UrdfError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    lower: f64,
    upper: f64,
}

/// Products and quotients below this may have lost digits to underflow.
const TINY: f64 = f64::MIN_POSITIVE / f64::EPSILON / f64::EPSILON;

/// The error of a double-double sine or cosine, absolute, and of an angle of a point, in units of itself.
const WIDE_ERROR: f64 = 1.0 / (1_u128 << 100) as f64;

/// Beyond this angle (rad) sines have fewer digits.
const FAR: f64 = 1e16;

/// An interval this wide (rad), or less, holds one extremum of the sine at most.
const NARROW: f64 = 1.0;

impl Interval {
    const EVERYTHING: Self = Self { lower: f64::NEG_INFINITY, upper: f64::INFINITY };

    /// The smallest of its numbers, or −∞.
    pub fn lower(self) -> f64 {
        self.lower
    }

    /// The largest of its numbers, or ∞.
    pub fn upper(self) -> f64 {
        self.upper
    }

    /// Whether `value` is one of its numbers.
    pub fn contains(self, value: f64) -> bool {
        self.lower <= value && value <= self.upper
    }

    /// The exact number whose nearest double is `nearest`, and which is as much above it as `rest` says by its sign.
    fn around(nearest: f64, rest: f64) -> Self {
        if rest == 0.0 {
            return Self { lower: nearest, upper: nearest };
        }
        let (above, below) = (rest > 0.0 || rest.is_nan(), rest < 0.0 || rest.is_nan());
        let lower = if below { nearest.next_down() } else { nearest };
        Self::between(lower, if above { nearest.next_up() } else { nearest })
    }

    /// What says nothing is everything.
    fn between(lower: f64, upper: f64) -> Self {
        if lower <= upper { Self { lower, upper } } else { Self::EVERYTHING }
    }

    fn sum(a: f64, b: f64) -> Self {
        let sum = TwoFloat::new_add(a, b);
        Self::around(sum.hi(), sum.lo())
    }

    fn product(a: f64, b: f64) -> Self {
        if a == 0.0 || b == 0.0 {
            return 0.0.into();
        }
        let product = a * b;
        Self::around(product, if product.abs() < TINY { f64::NAN } else { a.mul_add(b, -product) })
    }

    /// `b` is not 0.
    fn quotient(a: f64, b: f64) -> Self {
        if a == 0.0 {
            return 0.0.into();
        }
        let quotient = a / b;
        let lost = quotient.abs() < TINY || a.abs() < TINY;
        Self::around(quotient, if lost { f64::NAN } else { quotient.mul_add(-b, a) * b.signum() })
    }

    fn root(x: f64) -> Self {
        let root = x.sqrt();
        if x == 0.0 {
            root.into()
        } else {
            Self::around(root, if x < TINY { f64::NAN } else { root.mul_add(-root, x) })
        }
    }

    /// The smallest interval that holds both.
    fn with(self, other: Self) -> Self {
        Self { lower: self.lower.min(other.lower), upper: self.upper.max(other.upper) }
    }

    fn each_with(self, other: Self, of: impl Fn(f64, f64) -> Self) -> Self {
        let ends = [
            (self.lower, other.lower),
            (self.lower, other.upper),
            (self.upper, other.lower),
            (self.upper, other.upper),
        ];
        let [a, b, c, d] = ends.map(|(a, b)| of(a, b));
        a.with(b).with(c.with(d))
    }

    /// A number of 31 digits that is off by `error` at most.
    fn of(number: DoubleDouble, error: f64) -> Self {
        Self::from(number.high()) + Self::from(number.low()) + Self { lower: -error, upper: error }
    }

    /// The values of sine or cosine, from those at both ends and their slopes there.
    fn wave(values: [Self; 2], slopes: [Self; 2]) -> Self {
        let ends = values[0].with(values[1]);
        let (rising, falling) = (slopes.map(|slope| slope.lower > 0.0), slopes.map(|slope| slope.upper < 0.0));
        let monotone = rising == [true; 2] || falling == [true; 2];
        let turning = Self::from(if ends.lower + ends.upper < 0.0 { -1.0 } else { 1.0 });
        let Self { lower, upper } = if monotone { ends } else { ends.with(turning) };
        Self { lower: lower.max(-1.0), upper: upper.min(1.0) }
    }
}

impl From<f64> for Interval {
    /// This number alone; what is no number may be any.
    fn from(value: f64) -> Self {
        Self::between(value, value)
    }
}

impl Real for Interval {
    type Lanes = Self;

    fn from_f64(value: f64) -> Self {
        value.into()
    }

    /// Numbers below 0 are rounding of one that is not.
    fn sqrt(self) -> Self {
        let least = Self::root(self.lower.max(0.0)).lower;
        Self::between(least, Self::root(self.upper).upper)
    }

    fn sin_cos(self) -> (Self, Self) {
        if self.is_zero() {
            return (Self::zero(), Self::one());
        }
        let small = self.lower > -FAR && self.upper < FAR && self.upper - self.lower < NARROW;
        if !small {
            let any = Self { lower: -1.0, upper: 1.0 };
            return (any, any);
        }
        let ends = [self.lower, self.upper].map(|end| DoubleDouble::from(end).sin_cos());
        let (sin, cos) =
            (ends.map(|(sin, _)| Self::of(sin, WIDE_ERROR)), ends.map(|(_, cos)| Self::of(cos, WIDE_ERROR)));
        (Self::wave(sin, cos), Self::wave(cos, sin.map(Neg::neg)))
    }

    fn atan2(self, x: Self) -> Self {
        let around_origin = x.lower <= 0.0 && self.contains(0.0);
        let finite = [self.lower, self.upper, x.lower, x.upper].iter().all(|end| end.is_finite());
        if around_origin || !finite {
            return Self { lower: (-PI).next_down(), upper: PI.next_up() };
        }
        self.each_with(x, |y, x| {
            let angle = DoubleDouble::from(y).atan2(x.into());
            Self::of(angle, angle.high().abs() * WIDE_ERROR)
        })
    }

    fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self {
        match (self.upper < limit, self.lower >= limit) {
            (true, _) => below,
            (_, true) => otherwise,
            _ => below.with(otherwise),
        }
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { lower: -self.upper, upper: -self.lower }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::between(Self::sum(self.lower, other.lower).lower, Self::sum(self.upper, other.upper).upper)
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.each_with(other, Self::product)
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.contains(0.0) { Self::EVERYTHING } else { self.each_with(other, Self::quotient) }
    }
}

macro_rules! assigning {
    ($($assign:ident $method_assign:ident $method:ident;)*) => {$(
        impl $assign for Interval {
            fn $method_assign(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}
assigning! {
    AddAssign add_assign add;
    SubAssign sub_assign sub;
    MulAssign mul_assign mul;
    DivAssign div_assign div;
}

impl Zero for Interval {
    fn zero() -> Self {
        0.0.into()
    }
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Interval {
    fn one() -> Self {
        1.0.into()
    }
}
