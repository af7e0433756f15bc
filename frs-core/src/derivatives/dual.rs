//! First-order dual numbers: a value and its derivative along one direction.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::Real;

/// `x + ε ẋ` with `ε² = 0`: arithmetic carries the derivative along, exact to rounding.
///
/// ```
/// use frs_core::{Model, Workspace, derivatives::Dual};
/// // The rate of the total mass' first moment while joint 1 turns at 1 rad/s.
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?.cast::<Dual>();
/// let mut q = [Dual::from(0.3); 7];
/// q[0].derivative = 1.0;
/// let mut work = Workspace::new(&model);
/// let com_rate = work.shape(&q).com().map(|c| c.derivative);
/// assert!(com_rate.norm() > 0.01);
/// # Ok::<(), frs_core::urdf::UrdfError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T: Real = f64> {
    /// The value x.
    pub value: T,
    /// The derivative ẋ.
    pub derivative: T,
}

impl<T: Real> Dual<T> {
    /// `value + ε derivative`.
    pub fn new(value: T, derivative: T) -> Self {
        Self { value, derivative }
    }
}

impl<T: Real> From<T> for Dual<T> {
    fn from(value: T) -> Self {
        Self::new(value, T::zero())
    }
}

impl<T: Real> Real for Dual<T> {
    type Lanes = Self;

    fn from_f64(value: f64) -> Self {
        T::from_f64(value).into()
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, self.derivative / (root + root))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (Self::new(sin, cos * self.derivative), Self::new(cos, -(sin * self.derivative)))
    }

    fn atan2(self, x: Self) -> Self {
        let y = self;
        let radius_squared = x.value * x.value + y.value * y.value;
        let derivative = (x.value * y.derivative - y.value * x.derivative) / radius_squared;
        Self::new(y.value.atan2(x.value), derivative)
    }

    fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self {
        Self::new(
            self.value.select_below(limit, below.value, otherwise.value),
            self.value.select_below(limit, below.derivative, otherwise.derivative),
        )
    }
}

impl<T: Real> Add for Dual<T> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.value + o.value, self.derivative + o.derivative)
    }
}

impl<T: Real> Sub for Dual<T> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self::new(self.value - o.value, self.derivative - o.derivative)
    }
}

impl<T: Real> Mul for Dual<T> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::new(self.value * o.value, self.derivative * o.value + self.value * o.derivative)
    }
}

impl<T: Real> Div for Dual<T> {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Self::new(value, (self.derivative - value * o.derivative) / o.value)
    }
}

impl<T: Real> Neg for Dual<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.derivative)
    }
}

impl<T: Real> AddAssign for Dual<T> {
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl<T: Real> SubAssign for Dual<T> {
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

impl<T: Real> MulAssign for Dual<T> {
    fn mul_assign(&mut self, o: Self) {
        *self = *self * o;
    }
}

impl<T: Real> DivAssign for Dual<T> {
    fn div_assign(&mut self, o: Self) {
        *self = *self / o;
    }
}

impl<T: Real> Zero for Dual<T> {
    fn zero() -> Self {
        T::zero().into()
    }
    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.derivative.is_zero()
    }
}

impl<T: Real> One for Dual<T> {
    fn one() -> Self {
        T::one().into()
    }
}
