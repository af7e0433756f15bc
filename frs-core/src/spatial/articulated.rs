//! Articulated-body inertias: symmetric 6×6 matrices, twenty-one numbers.

use std::ops::{Add, Mul};

use nalgebra::{Matrix3, Vector3};

use super::{Inertia, Symmetric3, Twist, Wrench, cross_matrix, dot, times, transposed_times};
use crate::Real;

/// The inertia `[[J, H], [Hᵀ, M]]` that a body seems to have when joints hang on it (Featherstone, RBDA §7.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArticulatedInertia<T: Real> {
    /// Rotational block J.
    pub rotational: Symmetric3<T>,
    /// Coupling block H.
    pub coupling: Matrix3<T>,
    /// Linear block M.
    pub linear: Symmetric3<T>,
}

impl<T: Real> ArticulatedInertia<T> {
    /// The inertia 0.
    pub fn zero() -> Self {
        Self { rotational: Symmetric3::zero(), coupling: Matrix3::zeros(), linear: Symmetric3::zero() }
    }

    /// A body on which nothing hangs.
    #[inline(always)]
    pub fn rigid(inertia: &Inertia<T>) -> Self {
        Self {
            rotational: inertia.rotational,
            coupling: cross_matrix(inertia.moment),
            linear: Symmetric3::diagonal(Vector3::repeat(inertia.mass)),
        }
    }

    /// `I − u uᵀ·factor`: what is left when a joint with `u = I s` gives way, `factor = 1/(sᵀ I s)`.
    #[inline(always)]
    pub fn without(&self, u: Wrench<T>, factor: T) -> Self {
        let (m, f) = (u.moment, u.force);
        let (sm, sf) = (m * factor, f * factor);
        let symmetric = |i: &Symmetric3<T>, a: Vector3<T>, b: Vector3<T>| Symmetric3 {
            xx: i.xx.minus_product(a.x, b.x),
            xy: i.xy.minus_product(a.x, b.y),
            xz: i.xz.minus_product(a.x, b.z),
            yy: i.yy.minus_product(a.y, b.y),
            yz: i.yz.minus_product(a.y, b.z),
            zz: i.zz.minus_product(a.z, b.z),
        };
        let h = &self.coupling;
        Self {
            rotational: symmetric(&self.rotational, sm, m),
            coupling: Matrix3::new(
                h.m11.minus_product(sm.x, f.x),
                h.m12.minus_product(sm.x, f.y),
                h.m13.minus_product(sm.x, f.z),
                h.m21.minus_product(sm.y, f.x),
                h.m22.minus_product(sm.y, f.y),
                h.m23.minus_product(sm.y, f.z),
                h.m31.minus_product(sm.z, f.x),
                h.m32.minus_product(sm.z, f.y),
                h.m33.minus_product(sm.z, f.z),
            ),
            linear: symmetric(&self.linear, sf, f),
        }
    }

    /// The twist `V` with `I V = wrench`, by block elimination of the linear part.
    pub fn solve(&self, wrench: Wrench<T>) -> Twist<T> {
        let linear = self.linear.factor();
        // Columns of M⁻¹Hᵀ.
        let solved = [0, 1, 2].map(|row| linear.solve(self.coupling.row(row).transpose()));
        let reduced = Matrix3::from_fn(|r, c| dot(&self.coupling.row(r).transpose(), &solved[c]));
        let rotational = (self.rotational - Symmetric3::from_lower(&reduced)).factor();
        let angular = rotational.solve(wrench.moment - times(&self.coupling, &linear.solve(wrench.force)));
        Twist::new(angular, linear.solve(wrench.force - transposed_times(&self.coupling, &angular)))
    }
}

impl<T: Real> Mul<Twist<T>> for ArticulatedInertia<T> {
    type Output = Wrench<T>;

    #[inline(always)]
    fn mul(self, twist: Twist<T>) -> Wrench<T> {
        Wrench::new(
            self.rotational * twist.angular + times(&self.coupling, &twist.linear),
            transposed_times(&self.coupling, &twist.angular) + self.linear * twist.linear,
        )
    }
}

impl<T: Real> Add for ArticulatedInertia<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            rotational: self.rotational + other.rotational,
            coupling: self.coupling + other.coupling,
            linear: self.linear + other.linear,
        }
    }
}
