//! The cross product as a matrix.

use nalgebra::{Matrix3, Vector3};

use crate::Real;

/// The skew matrix `v×`, for which `v× w = v × w` (nalgebra's own asks for an ordered field).
#[inline(always)]
pub fn cross_matrix<T: Real>(v: Vector3<T>) -> Matrix3<T> {
    let zero = T::zero();
    Matrix3::new(
        zero, -v.z, v.y, //
        v.z, zero, -v.x, //
        -v.y, v.x, zero,
    )
}
