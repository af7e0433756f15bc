//! Products of three-vectors and 3×3 matrices, rounded as [`Real::plus_product`] rounds.
//!
//! nalgebra's own round every product by itself. Where nothing is fused they are taken, in their order.

use nalgebra::{Matrix3, Vector3};

use crate::{FUSED, Real};

/// `a·b`.
#[inline(always)]
pub(crate) fn dot<T: Real>(a: &Vector3<T>, b: &Vector3<T>) -> T {
    if FUSED { (a.x * b.x).plus_product(a.y, b.y).plus_product(a.z, b.z) } else { a.dot(b) }
}

/// `a × b`.
#[inline(always)]
pub(crate) fn cross<T: Real>(a: &Vector3<T>, b: &Vector3<T>) -> Vector3<T> {
    Vector3::new(
        (a.y * b.z).minus_product(a.z, b.y),
        (a.z * b.x).minus_product(a.x, b.z),
        (a.x * b.y).minus_product(a.y, b.x),
    )
}

/// `sum + v·factor`.
#[inline(always)]
pub(crate) fn plus_scaled<T: Real>(sum: Vector3<T>, v: Vector3<T>, factor: T) -> Vector3<T> {
    if FUSED { sum.zip_map(&v, |sum, x| sum.plus_product(x, factor)) } else { sum + v * factor }
}

/// `sum − v·factor`.
#[inline(always)]
pub(crate) fn minus_scaled<T: Real>(sum: Vector3<T>, v: Vector3<T>, factor: T) -> Vector3<T> {
    if FUSED { plus_scaled(sum, v, -factor) } else { sum - v * factor }
}

/// `m v`.
#[inline(always)]
pub(crate) fn times<T: Real>(m: &Matrix3<T>, v: &Vector3<T>) -> Vector3<T> {
    if !FUSED {
        return m * v;
    }
    let [x, y, z] = columns(m);
    plus_scaled(plus_scaled(x * v.x, y, v.y), z, v.z)
}

/// `mᵀ v`.
#[inline(always)]
pub(crate) fn transposed_times<T: Real>(m: &Matrix3<T>, v: &Vector3<T>) -> Vector3<T> {
    if FUSED { Vector3::from(columns(m).map(|column| dot(&column, v))) } else { m.tr_mul(v) }
}

/// `m n`.
#[inline(always)]
pub(crate) fn compose<T: Real>(m: &Matrix3<T>, n: &Matrix3<T>) -> Matrix3<T> {
    if FUSED { Matrix3::from_columns(&columns(n).map(|column| times(m, &column))) } else { m * n }
}

#[inline(always)]
fn columns<T: Real>(m: &Matrix3<T>) -> [Vector3<T>; 3] {
    [0, 1, 2].map(|c| m.column(c).into_owned())
}
