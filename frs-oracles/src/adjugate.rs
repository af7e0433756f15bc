//! Determinant and inverse of a 3×3 matrix by its adjugate, over any scalar.

use frs_core::Real;
use nalgebra::Matrix3;

/// det m.
pub fn determinant<T: Real>(m: &Matrix3<T>) -> T {
    m.column(0).cross(&m.column(1)).dot(&m.column(2))
}

/// m⁻¹: its rows are the cross products of the columns of m, divided by det m.
pub fn inverse<T: Real>(m: &Matrix3<T>) -> Matrix3<T> {
    let [x, y, z] = [m.column(0), m.column(1), m.column(2)];
    let rows = [y.cross(&z), z.cross(&x), x.cross(&y)];
    Matrix3::from_columns(&rows).transpose() * (T::one() / determinant(m))
}
