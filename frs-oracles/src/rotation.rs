//! Elementary rotations, and inertias of points and of turned bodies.

use frs_core::Real;
use nalgebra::{Matrix3, Vector3};

/// R_z(angle).
pub fn about_z<T: Real>(angle: T) -> Matrix3<T> {
    let ((s, c), zero, one) = (angle.sin_cos(), T::zero(), T::one());
    Matrix3::new(c, -s, zero, s, c, zero, zero, zero, one)
}

/// R_y(angle).
pub fn about_y<T: Real>(angle: T) -> Matrix3<T> {
    let ((s, c), zero, one) = (angle.sin_cos(), T::zero(), T::one());
    Matrix3::new(c, zero, s, zero, one, zero, -s, zero, c)
}

/// e(angle) = (cos, sin, 0).
pub fn direction<T: Real>(angle: T) -> Vector3<T> {
    let (s, c) = angle.sin_cos();
    Vector3::new(c, s, T::zero())
}

/// z × v.
pub fn quarter_turn<T: Real>(v: Vector3<T>) -> Vector3<T> {
    Vector3::z().cross(&v)
}

/// The vector with each number as a `T`.
pub fn lifted<T: Real>(v: Vector3<f64>) -> Vector3<T> {
    v.map(T::from_f64)
}

/// (a·b) 1 − a bᵀ: the locked inertia of points is a sum of these.
pub fn polar<T: Real>(a: Vector3<T>, b: Vector3<T>) -> Matrix3<T> {
    Matrix3::from_diagonal_element(a.dot(&b)) - a * b.transpose()
}
