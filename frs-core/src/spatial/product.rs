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
    if !FUSED {
        return sum + v * factor;
    }
    Vector3::new(sum.x.plus_product(v.x, factor), sum.y.plus_product(v.y, factor), sum.z.plus_product(v.z, factor))
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
    if !FUSED {
        return m.tr_mul(v);
    }
    let [x, y, z] = columns(m);
    Vector3::new(dot(&x, v), dot(&y, v), dot(&z, v))
}

/// `m n`.
#[inline(always)]
pub(crate) fn compose<T: Real>(m: &Matrix3<T>, n: &Matrix3<T>) -> Matrix3<T> {
    if !FUSED {
        return m * n;
    }
    let [x, y, z] = columns(n);
    Matrix3::from_columns(&[times(m, &x), times(m, &y), times(m, &z)])
}

/// The columns of `m`; written out, as all here is: `map` of an array of lanes is not inlined.
#[inline(always)]
pub(crate) fn columns<T: Real>(m: &Matrix3<T>) -> [Vector3<T>; 3] {
    [Vector3::new(m.m11, m.m21, m.m31), Vector3::new(m.m12, m.m22, m.m32), Vector3::new(m.m13, m.m23, m.m33)]
}
