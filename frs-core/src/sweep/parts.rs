//! Values taken apart into numbers, so that those of several joints can be put side by side.

use nalgebra::{Matrix3, Vector3};

use crate::spatial::{CoriolisFactor, Inertia, LdlFactor3, Symmetric3, Twist, Wrench};
use crate::{Lanes, Real};

/// A value made of `R` numbers.
pub(crate) trait Parts<T, const R: usize>: Copy {
    fn from_parts(parts: [T; R]) -> Self;
    fn parts(self) -> [T; R];
}

/// `part(r)` for each of `R` parts. What [`std::array::from_fn`] is given is called, and not written out, where it is large or there are many;
/// `first` is any part, to begin with.
#[inline(always)]
pub(super) fn each<P: Copy, const R: usize>(first: P, part: impl Fn(usize) -> P) -> [P; R] {
    let mut parts = [first; R];
    for (r, slot) in parts.iter_mut().enumerate() {
        *slot = part(r);
    }
    parts
}

/// The same value in every lane.
#[inline(always)]
pub(crate) fn splat<T: Real, W, const R: usize>(value: impl Parts<T, R>) -> W
where
    W: Parts<T::Lanes, R>,
{
    let parts = value.parts();
    W::from_parts(each(T::Lanes::splat(parts[0]), |r| T::Lanes::splat(parts[r])))
}

/// The numbers of `a`, then those of `b`.
#[inline(always)]
pub(crate) fn joined<T: Copy, const A: usize, const B: usize, const R: usize>(
    a: impl Parts<T, A>,
    b: impl Parts<T, B>,
) -> [T; R] {
    const { assert!(A + B == R) };
    let (a, b) = (a.parts(), b.parts());
    each(a[0], |r| if r < A { a[r] } else { b[r - A] })
}

/// `values[first..]`, side by side.
#[inline(always)]
pub(crate) fn gather<T: Real, W, const R: usize>(values: &[impl Parts<T, R>], first: usize) -> W
where
    W: Parts<T::Lanes, R>,
{
    let values = &values[first..first + T::Lanes::WIDTH];
    W::from_parts(T::Lanes::gather(|lane| values[lane].parts()))
}

/// Writes what stands side by side to `values[first..]`.
#[inline(always)]
pub(crate) fn scatter<T: Real, V, const R: usize>(values: &mut [V], first: usize, lanes: impl Parts<T::Lanes, R>)
where
    V: Parts<T, R>,
{
    let parts = lanes.parts();
    for (lane, value) in values[first..first + T::Lanes::WIDTH].iter_mut().enumerate() {
        *value = V::from_parts(each(parts[0].lane(0), |r| parts[r].lane(lane)));
    }
}

impl<T: Copy, const R: usize> Parts<T, R> for [T; R] {
    #[inline(always)]
    fn from_parts(parts: [T; R]) -> Self {
        parts
    }

    #[inline(always)]
    fn parts(self) -> [T; R] {
        self
    }
}

impl<T: Real> Parts<T, 3> for Vector3<T> {
    #[inline(always)]
    fn from_parts(parts: [T; 3]) -> Self {
        parts.into()
    }

    #[inline(always)]
    fn parts(self) -> [T; 3] {
        self.into()
    }
}

impl<T: Real> Parts<T, 9> for Matrix3<T> {
    #[inline(always)]
    fn from_parts([xx, yx, zx, xy, yy, zy, xz, yz, zz]: [T; 9]) -> Self {
        Self::new(xx, xy, xz, yx, yy, yz, zx, zy, zz)
    }

    #[inline(always)]
    fn parts(self) -> [T; 9] {
        [self.m11, self.m21, self.m31, self.m12, self.m22, self.m32, self.m13, self.m23, self.m33]
    }
}

impl<T: Real> Parts<T, 6> for Symmetric3<T> {
    #[inline(always)]
    fn from_parts([xx, xy, xz, yy, yz, zz]: [T; 6]) -> Self {
        Self { xx, xy, xz, yy, yz, zz }
    }

    #[inline(always)]
    fn parts(self) -> [T; 6] {
        [self.xx, self.xy, self.xz, self.yy, self.yz, self.zz]
    }
}

macro_rules! six_numbers {
    ($($Value:ident),*) => {
        $(impl<T: Real> Parts<T, 6> for $Value<T> {
            #[inline(always)]
            fn from_parts(parts: [T; 6]) -> Self {
                Self::from_array(parts)
            }

            #[inline(always)]
            fn parts(self) -> [T; 6] {
                self.to_array()
            }
        })*
    };
}

six_numbers!(LdlFactor3, Twist, Wrench);

impl<T: Real> Parts<T, 10> for Inertia<T> {
    #[inline(always)]
    fn from_parts([mass, hx, hy, hz, xx, xy, xz, yy, yz, zz]: [T; 10]) -> Self {
        Self { mass, moment: Vector3::new(hx, hy, hz), rotational: Symmetric3 { xx, xy, xz, yy, yz, zz } }
    }

    #[inline(always)]
    fn parts(self) -> [T; 10] {
        let (h, j) = (self.moment, self.rotational);
        [self.mass, h.x, h.y, h.z, j.xx, j.xy, j.xz, j.yy, j.yz, j.zz]
    }
}

impl<T: Real> Parts<T, 12> for CoriolisFactor<T> {
    #[inline(always)]
    fn from_parts([xx, yx, zx, xy, yy, zy, xz, yz, zz, px, py, pz]: [T; 12]) -> Self {
        Self {
            rotational: Matrix3::from_parts([xx, yx, zx, xy, yy, zy, xz, yz, zz]),
            momentum: Vector3::new(px, py, pz),
        }
    }

    #[inline(always)]
    fn parts(self) -> [T; 12] {
        let ([xx, yx, zx, xy, yy, zy, xz, yz, zz], p) = (self.rotational.parts(), self.momentum);
        [xx, yx, zx, xy, yy, zy, xz, yz, zz, p.x, p.y, p.z]
    }
}
