//! Poses: elements of SE(3).

use std::ops::Mul;

use nalgebra::{Matrix3, Matrix6, Vector3};

use super::{Twist, Wrench, compose, cross, cross_matrix, times, transposed_times};
use crate::Real;

/// A pose `g = (R, p)`: where a frame stands in another one; `x ↦ R x + p` maps coordinates out of it.
///
/// ```
/// use frs_core::spatial::Pose;
/// use nalgebra::Vector3;
/// let g = Pose::from_rpy(Vector3::new(0.0, 0.0, 1.0), [0.0, 0.0, std::f64::consts::FRAC_PI_2]);
/// assert!((g.transform(Vector3::x()) - Vector3::new(0.0, 1.0, 1.0)).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<T: Real> {
    /// Orientation R.
    pub rotation: Matrix3<T>,
    /// Origin p.
    pub translation: Vector3<T>,
}

impl<T: Real> Pose<T> {
    /// The pose `(R, p)`; `rotation` must be a rotation matrix.
    #[inline(always)]
    pub fn new(rotation: Matrix3<T>, translation: Vector3<T>) -> Self {
        Self { rotation, translation }
    }

    /// The pose `(1, 0)`.
    pub fn identity() -> Self {
        Self::new(Matrix3::identity(), Vector3::zeros())
    }

    /// The pose `(R_z(yaw) R_y(pitch) R_x(roll), p)`, the convention of URDF's `origin`.
    pub fn from_rpy(translation: Vector3<T>, rpy: [T; 3]) -> Self {
        let [(sr, cr), (sp, cp), (sy, cy)] = rpy.map(T::sin_cos);
        let rotation = Matrix3::new(
            cy * cp,
            cy * sp * sr - sy * cr,
            cy * sp * cr + sy * sr,
            sy * cp,
            sy * sp * sr + cy * cr,
            sy * sp * cr - cy * sr,
            -sp,
            cp * sr,
            cp * cr,
        );
        Self::new(rotation, translation)
    }

    /// The same with a rotation nearer to one, where it is already one to rounding: a Newton step `R ← R + ½R(1 − RᵀR)`, which doubles
    /// the digits.
    pub fn orthonormalised(self) -> Self {
        let rotation = self.rotation;
        let defect = Matrix3::identity() - rotation.transpose() * rotation;
        Self::new(rotation + rotation * defect * T::from_f64(0.5), self.translation)
    }

    /// `R x + p`.
    #[inline(always)]
    pub fn transform(&self, point: Vector3<T>) -> Vector3<T> {
        times(&self.rotation, &point) + self.translation
    }

    /// `g⁻¹ = (Rᵀ, −Rᵀ p)`.
    pub fn inverse(&self) -> Self {
        Self::new(self.rotation.transpose(), -transposed_times(&self.rotation, &self.translation))
    }

    /// `Ad_g V = [R ω; R v + p × R ω]`.
    #[inline(always)]
    pub fn act(&self, twist: Twist<T>) -> Twist<T> {
        let angular = times(&self.rotation, &twist.angular);
        Twist::new(angular, times(&self.rotation, &twist.linear) + cross(&self.translation, &angular))
    }

    /// `Ad_g⁻¹ V`.
    #[inline(always)]
    pub fn act_inverse(&self, twist: Twist<T>) -> Twist<T> {
        let at = twist.at(self.translation);
        Twist::new(transposed_times(&self.rotation, &at.angular), transposed_times(&self.rotation, &at.linear))
    }

    /// `Ad_g⁻ᵀ h`: a wrench in this frame, seen from the outer one.
    #[inline(always)]
    pub fn act_wrench(&self, wrench: Wrench<T>) -> Wrench<T> {
        let force = times(&self.rotation, &wrench.force);
        Wrench::new(times(&self.rotation, &wrench.moment) + cross(&self.translation, &force), force)
    }

    /// The 6×6 matrix `Ad_g = [[R, 0], [p× R, R]]`.
    pub fn adjoint(&self) -> Matrix6<T> {
        let mut matrix = Matrix6::zeros();
        matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&self.rotation);
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&(cross_matrix(self.translation) * self.rotation));
        matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&self.rotation);
        matrix
    }
}

impl<T: Real> Mul for Pose<T> {
    type Output = Self;

    /// The pose `g h`.
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(compose(&self.rotation, &other.rotation), self.transform(other.translation))
    }
}
