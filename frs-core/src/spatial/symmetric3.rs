//! Symmetric 3×3 matrices, six numbers, and their LDLᵀ factors.

use std::ops::{Add, Mul, Sub};

use nalgebra::{Matrix3, Vector3};

use crate::Real;

/// A symmetric 3×3 matrix, stored once per pair of entries.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // the fields are the entries
pub struct Symmetric3<T: Real> {
    pub xx: T,
    pub xy: T,
    pub xz: T,
    pub yy: T,
    pub yz: T,
    pub zz: T,
}

impl<T: Real> Symmetric3<T> {
    /// The matrix 0.
    pub fn zero() -> Self {
        Self::diagonal(Vector3::zeros())
    }

    /// The matrix `diag(d)`.
    pub fn diagonal(d: Vector3<T>) -> Self {
        let zero = T::zero();
        Self { xx: d.x, xy: zero, xz: zero, yy: d.y, yz: zero, zz: d.z }
    }

    /// Reads the lower triangle of `m`.
    pub fn from_lower(m: &Matrix3<T>) -> Self {
        Self { xx: m.m11, xy: m.m21, xz: m.m31, yy: m.m22, yz: m.m32, zz: m.m33 }
    }

    /// The full matrix.
    #[inline(always)]
    pub fn to_matrix(self) -> Matrix3<T> {
        Matrix3::new(
            self.xx, self.xy, self.xz, //
            self.xy, self.yy, self.yz, //
            self.xz, self.yz, self.zz,
        )
    }

    /// `R·self·Rᵀ`: the same tensor in the axes of a frame in which this one has orientation `R`.
    #[inline(always)]
    pub fn rotated(self, r: &Matrix3<T>) -> Self {
        let half = [
            self * Vector3::new(r.m11, r.m12, r.m13),
            self * Vector3::new(r.m21, r.m22, r.m23),
            self * Vector3::new(r.m31, r.m32, r.m33),
        ];
        let entry = |row: &Vector3<T>, x: T, y: T, z: T| (row.x * x).plus_product(row.y, y).plus_product(row.z, z);
        Self {
            xx: entry(&half[0], r.m11, r.m12, r.m13),
            xy: entry(&half[0], r.m21, r.m22, r.m23),
            xz: entry(&half[0], r.m31, r.m32, r.m33),
            yy: entry(&half[1], r.m21, r.m22, r.m23),
            yz: entry(&half[1], r.m31, r.m32, r.m33),
            zz: entry(&half[2], r.m31, r.m32, r.m33),
        }
    }

    /// `self + factor·1`.
    #[inline(always)]
    pub(crate) fn plus_multiple(self, factor: T) -> Self {
        Self { xx: self.xx + factor, yy: self.yy + factor, zz: self.zz + factor, ..self }
    }

    /// `−a× b× − b× a× = 2(a·b)·1 − a bᵀ − b aᵀ`: the rate of a rotational inertia whose first moment `a` moves at `b`.
    #[inline(always)]
    pub fn outer(a: Vector3<T>, b: Vector3<T>) -> Self {
        let (x, y, z) = (a.x * b.x, a.y * b.y, a.z * b.z);
        Self {
            xx: (y + y) + (z + z),
            xy: -(a.x * b.y).plus_product(a.y, b.x),
            xz: -(a.x * b.z).plus_product(a.z, b.x),
            yy: (x + x) + (z + z),
            yz: -(a.y * b.z).plus_product(a.z, b.y),
            zz: (x + x) + (y + y),
        }
    }

    /// `mass·(|d|²·1 − d dᵀ)`: the rotational inertia about the origin of a point mass at `d`.
    #[inline(always)]
    pub fn point_mass(mass: T, d: Vector3<T>) -> Self {
        let m = d * mass;
        let (x, y, z) = (m.x * d.x, m.y * d.y, m.z * d.z);
        Self { xx: y + z, xy: -(m.x * d.y), xz: -(m.x * d.z), yy: x + z, yz: -(m.y * d.z), zz: x + y }
    }

    /// The factors `L D Lᵀ`, without pivoting: for positive definite matrices.
    #[inline(always)]
    pub fn factor(self) -> LdlFactor3<T> {
        let one = T::one();
        let inv_d0 = one / self.xx;
        let (l10, l20) = (self.xy * inv_d0, self.xz * inv_d0);
        let inv_d1 = one / self.yy.minus_product(l10, self.xy);
        let e21 = self.yz.minus_product(l20, self.xy);
        let l21 = e21 * inv_d1;
        let inv_d2 = one / self.zz.minus_product(l20, self.xz).minus_product(l21, e21);
        LdlFactor3 { l10, l20, l21, inverse_pivots: Vector3::new(inv_d0, inv_d1, inv_d2) }
    }
}

/// The factors of a symmetric positive definite 3×3 matrix, `L D Lᵀ` with unit lower triangular `L`.
#[derive(Clone, Copy, Debug)]
pub struct LdlFactor3<T: Real> {
    l10: T,
    l20: T,
    l21: T,
    /// `1/D`, entry by entry.
    pub inverse_pivots: Vector3<T>,
}

impl<T: Real> LdlFactor3<T> {
    /// The factors from their six numbers.
    #[inline(always)]
    pub(crate) fn from_array([l10, l20, l21, d0, d1, d2]: [T; 6]) -> Self {
        Self { l10, l20, l21, inverse_pivots: Vector3::new(d0, d1, d2) }
    }

    /// The six numbers of the factors.
    #[inline(always)]
    pub(crate) fn to_array(self) -> [T; 6] {
        let d = self.inverse_pivots;
        [self.l10, self.l20, self.l21, d.x, d.y, d.z]
    }

    /// The solution `x` of `L D Lᵀ x = b`.
    #[inline(always)]
    pub fn solve(&self, b: Vector3<T>) -> Vector3<T> {
        let y1 = b.y.minus_product(self.l10, b.x);
        let y2 = b.z.minus_product(self.l20, b.x).minus_product(self.l21, y1);
        let z = y2 * self.inverse_pivots.z;
        let y = (y1 * self.inverse_pivots.y).minus_product(self.l21, z);
        let x = (b.x * self.inverse_pivots.x).minus_product(self.l10, y).minus_product(self.l20, z);
        Vector3::new(x, y, z)
    }
}

impl<T: Real> Add for Symmetric3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self {
            xx: self.xx + o.xx,
            xy: self.xy + o.xy,
            xz: self.xz + o.xz,
            yy: self.yy + o.yy,
            yz: self.yz + o.yz,
            zz: self.zz + o.zz,
        }
    }
}

impl<T: Real> Sub for Symmetric3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self {
            xx: self.xx - o.xx,
            xy: self.xy - o.xy,
            xz: self.xz - o.xz,
            yy: self.yy - o.yy,
            yz: self.yz - o.yz,
            zz: self.zz - o.zz,
        }
    }
}

impl<T: Real> Mul<Vector3<T>> for Symmetric3<T> {
    type Output = Vector3<T>;
    #[inline(always)]
    fn mul(self, v: Vector3<T>) -> Vector3<T> {
        Vector3::new(
            (self.xx * v.x).plus_product(self.xy, v.y).plus_product(self.xz, v.z),
            (self.xy * v.x).plus_product(self.yy, v.y).plus_product(self.yz, v.z),
            (self.xz * v.x).plus_product(self.yz, v.y).plus_product(self.zz, v.z),
        )
    }
}

impl<T: Real> Mul<T> for Symmetric3<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, s: T) -> Self {
        Self { xx: self.xx * s, xy: self.xy * s, xz: self.xz * s, yy: self.yy * s, yz: self.yz * s, zz: self.zz * s }
    }
}
