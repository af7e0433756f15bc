//! Wrenches: forces on rigid bodies, and momenta.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

use nalgebra::{Matrix6, Vector3, Vector6};

use super::cross_matrix;
use crate::Real;

/// A wrench `[m; f]`: moment about the frame's origin, and force. Also a momentum: angular and linear.
///
/// Units: N·m and N, or kg·m²/s and kg·m/s for a momentum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<T: Real> {
    /// Moment (or angular momentum) about the frame's origin.
    pub moment: Vector3<T>,
    /// Force (or linear momentum).
    pub force: Vector3<T>,
}

impl<T: Real> Wrench<T> {
    /// The wrench `[moment; force]`.
    #[inline(always)]
    pub fn new(moment: Vector3<T>, force: Vector3<T>) -> Self {
        Self { moment, force }
    }

    /// The wrench 0.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new(Vector3::zeros(), Vector3::zeros())
    }

    /// Reads `[m; f]`.
    #[inline(always)]
    pub fn from_array([a, b, c, d, e, f]: [T; 6]) -> Self {
        Self::new(Vector3::new(a, b, c), Vector3::new(d, e, f))
    }

    /// Writes `[m; f]`.
    #[inline(always)]
    pub fn to_array(self) -> [T; 6] {
        let (m, f) = (self.moment, self.force);
        [m.x, m.y, m.z, f.x, f.y, f.z]
    }

    /// Writes `[m; f]` as a vector.
    #[inline(always)]
    pub fn to_vector(self) -> Vector6<T> {
        Vector6::from(self.to_array())
    }

    /// The matrix `ad~_h = [[m×, f×], [f×, 0]]`, for which `ad~_h V = ad_Vᵀ h`.
    ///
    /// ```
    /// use frs_core::spatial::{Twist, Wrench};
    /// let v = Twist::from_array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    /// let h = Wrench::from_array([0.5, -1.0, 2.0, 3.0, 0.25, -4.0]);
    /// assert_eq!(h.ad_tilde() * v.to_vector(), v.ad_transpose(h).to_vector());
    /// ```
    pub fn ad_tilde(self) -> Matrix6<T> {
        let mut matrix = Matrix6::zeros();
        let force = cross_matrix(self.force);
        matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&cross_matrix(self.moment));
        matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&force);
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&force);
        matrix
    }

    /// The same wrench seen from a frame with the same axes whose origin stands at `point`: `Ad_{(1,point)}ᵀ h`.
    #[inline(always)]
    pub fn at(self, point: Vector3<T>) -> Self {
        Self::new(self.moment + self.force.cross(&point), self.force)
    }
}

impl<T: Real> Add for Wrench<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.moment + other.moment, self.force + other.force)
    }
}

impl<T: Real> AddAssign for Wrench<T> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Real> Sub for Wrench<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.moment - other.moment, self.force - other.force)
    }
}

impl<T: Real> Neg for Wrench<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.moment, -self.force)
    }
}

impl<T: Real> Mul<T> for Wrench<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self::new(self.moment * factor, self.force * factor)
    }
}
