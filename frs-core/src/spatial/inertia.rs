//! Spatial inertias, ten numbers, and the Coriolis matrices they give.

use std::ops::{Add, AddAssign};

use nalgebra::{Matrix3, Matrix6, Vector3};

use super::{Pose, Symmetric3, Twist, Wrench, cross, cross_matrix, dot, plus_scaled, times, transposed_times};
use crate::{FUSED, Real};

/// A spatial inertia `I = [[J, h×], [−h×, m·1]]` about a frame's origin.
///
/// Ten numbers: mass `m` (kg), first moment of mass `h = m·c` (kg·m), rotational inertia `J` about the origin (kg·m²).
/// Inertias add; an inertia with `m = 0` is also the type of an inertia's rate ([`Inertia::rate`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia<T: Real> {
    /// Mass m.
    pub mass: T,
    /// First moment of mass h = m·c.
    pub moment: Vector3<T>,
    /// Rotational inertia J about the frame's origin.
    pub rotational: Symmetric3<T>,
}

impl<T: Real> Inertia<T> {
    /// The inertia 0.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { mass: T::zero(), moment: Vector3::zeros(), rotational: Symmetric3::zero() }
    }

    /// The inertia of a body of mass `m` with centre of mass `c` and rotational inertia `about_com` about it.
    ///
    /// ```
    /// use frs_core::spatial::{Inertia, Symmetric3};
    /// use nalgebra::Vector3;
    /// let rod = Inertia::from_com(2.0, Vector3::new(0.5, 0.0, 0.0), Symmetric3::diagonal(Vector3::new(0.0, 0.1, 0.1)));
    /// assert_eq!(rod.rotational.yy, 0.1 + 2.0 * 0.25);
    /// ```
    #[inline(always)]
    pub fn from_com(mass: T, com: Vector3<T>, about_com: Symmetric3<T>) -> Self {
        Self { mass, moment: com * mass, rotational: about_com + Symmetric3::point_mass(mass, com) }
    }

    /// The same body's inertia in the frame in which its own frame has pose `pose`.
    pub fn transformed(self, pose: &Pose<T>) -> Self {
        let moment = times(&pose.rotation, &self.moment);
        let p = pose.translation;
        Self {
            mass: self.mass,
            moment: plus_scaled(moment, p, self.mass),
            rotational: self.rotational.rotated(&pose.rotation)
                + Symmetric3::outer(moment, p)
                + Symmetric3::point_mass(self.mass, p),
        }
    }

    /// `dI/dt = −(ad_Vᵀ I + I ad_V)` of a body moving with twist `V`; its mass is 0.
    #[inline(always)]
    pub fn rate(&self, twist: Twist<T>) -> Self {
        let (j, w) = (&self.rotational, twist.angular);
        // W = ω× J; the rate of J is W + Wᵀ and what the moving first moment adds.
        let (w00, w11, w22) = (w.y * j.xz - w.z * j.xy, w.z * j.xy - w.x * j.yz, w.x * j.yz - w.y * j.xz);
        let turning = Symmetric3 {
            xx: w00 + w00,
            xy: (w.y * j.yz).minus_product(w.z, j.yy) + (w.z * j.xx).minus_product(w.x, j.xz),
            xz: (w.y * j.zz).minus_product(w.z, j.yz) + (w.x * j.xy).minus_product(w.y, j.xx),
            yy: w11 + w11,
            yz: (w.z * j.xz).minus_product(w.x, j.zz) + (w.x * j.yy).minus_product(w.y, j.xy),
            zz: w22 + w22,
        };
        Self {
            mass: T::zero(),
            moment: self.momentum_linear(twist),
            rotational: turning + Symmetric3::outer(self.moment, twist.linear),
        }
    }

    /// The linear momentum `m v + ω × h`.
    #[inline(always)]
    fn momentum_linear(&self, twist: Twist<T>) -> Vector3<T> {
        if FUSED {
            plus_scaled(cross(&twist.angular, &self.moment), twist.linear, self.mass)
        } else {
            twist.linear * self.mass + cross(&twist.angular, &self.moment)
        }
    }

    /// `C(I; X) V` for a twist `X` with angular part `omega`: the skew Coriolis matrix in closed form.
    ///
    /// `C(I; X) = ½(I ad_X − ad_Xᵀ I − ad~_{I X}) = [[(Σω)×, h×ω×], [−ω×h×, m ω×]]` with `Σ = ½ tr(J)·1 − J`;
    /// it does not depend on the linear part of `X`.
    #[inline(always)]
    pub fn coriolis(&self, omega: Vector3<T>, twist: Twist<T>) -> Wrench<T> {
        let (a, b) = (twist.angular, twist.linear);
        let turned = cross(&omega, &b);
        Wrench::new(
            cross(&self.sigma(omega), &a) + cross(&self.moment, &turned),
            turned * self.mass - cross(&omega, &cross(&self.moment, &a)),
        )
    }

    /// `Σω = ½ tr(J) ω − J ω`.
    #[inline(always)]
    pub fn sigma(&self, omega: Vector3<T>) -> Vector3<T> {
        let j = &self.rotational;
        let half_trace = (j.xx + j.yy + j.zz) * T::from_f64(0.5);
        omega * half_trace - *j * omega
    }

    /// `C(I; V) − I ad_V`, what the link's own motion adds to a Coriolis matrix.
    #[inline(always)]
    pub fn coriolis_factor(&self, twist: Twist<T>) -> CoriolisFactor<T> {
        let (j, h) = (&self.rotational, self.moment);
        let (w, v) = (twist.angular, twist.linear);
        let s = self.sigma(w);
        let hv = dot(&h, &v);
        // (Σω)× − J ω× − h× v×, with h× v× = v hᵀ − (h·v)·1.
        let rotational = Matrix3::new(
            (w.y * j.xz).minus_product(w.z, j.xy).minus_product(v.x, h.x) + hv,
            (w.z * j.xx).minus_product(w.x, j.xz).minus_product(v.x, h.y) - s.z,
            (w.x * j.xy).minus_product(w.y, j.xx).minus_product(v.x, h.z) + s.y,
            (w.y * j.yz).minus_product(w.z, j.yy).minus_product(v.y, h.x) + s.z,
            (w.z * j.xy).minus_product(w.x, j.yz).minus_product(v.y, h.y) + hv,
            (w.x * j.yy).minus_product(w.y, j.xy).minus_product(v.y, h.z) - s.x,
            (w.y * j.zz).minus_product(w.z, j.yz).minus_product(v.z, h.x) - s.y,
            (w.z * j.xz).minus_product(w.x, j.zz).minus_product(v.z, h.y) + s.x,
            (w.x * j.yz).minus_product(w.y, j.xz).minus_product(v.z, h.z) + hv,
        );
        CoriolisFactor { rotational, momentum: self.momentum_linear(twist) }
    }

    /// The 6×6 matrix `[[J, h×], [−h×, m·1]]`.
    pub fn to_matrix(&self) -> Matrix6<T> {
        let mut matrix = Matrix6::zeros();
        let moment = cross_matrix(self.moment);
        matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&self.rotational.to_matrix());
        matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&moment);
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&-moment);
        matrix.fixed_view_mut::<3, 3>(3, 3).fill_diagonal(self.mass);
        matrix
    }
}

impl<T: Real> std::ops::Mul<Twist<T>> for Inertia<T> {
    type Output = Wrench<T>;

    /// The momentum `I V = [J ω + h × v; m v − h × ω]`.
    #[inline(always)]
    fn mul(self, twist: Twist<T>) -> Wrench<T> {
        Wrench::new(self.rotational * twist.angular + cross(&self.moment, &twist.linear), self.momentum_linear(twist))
    }
}

impl<T: Real> Add for Inertia<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            moment: self.moment + other.moment,
            rotational: self.rotational + other.rotational,
        }
    }
}

impl<T: Real> AddAssign for Inertia<T> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

/// The matrix `D(I; V) = C(I; V) − I ad_V = [[Δ, 0], [−p×, 0]]`, linear in `I` for one `V`: these add over links.
///
/// Its right half is zero, so it acts on the angular part of a twist alone. `p = m v + ω × h` is the linear momentum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoriolisFactor<T: Real> {
    /// Upper left block Δ = (Σω)× − J ω× − h× v×.
    pub rotational: Matrix3<T>,
    /// Linear momentum p; the lower left block is −p×.
    pub momentum: Vector3<T>,
}

impl<T: Real> CoriolisFactor<T> {
    /// The matrix 0.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { rotational: Matrix3::zeros(), momentum: Vector3::zeros() }
    }

    /// `D V`, given the angular part of `V`.
    #[inline(always)]
    pub fn apply(&self, angular: Vector3<T>) -> Wrench<T> {
        Wrench::new(times(&self.rotational, &angular), cross(&angular, &self.momentum))
    }

    /// The angular part of `Dᵀ V`; the linear part is zero.
    #[inline(always)]
    pub fn apply_transpose(&self, twist: Twist<T>) -> Vector3<T> {
        transposed_times(&self.rotational, &twist.angular) + cross(&self.momentum, &twist.linear)
    }

    /// The full 6×6 matrix.
    pub fn to_matrix(&self) -> Matrix6<T> {
        let mut matrix = Matrix6::zeros();
        matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&self.rotational);
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&-cross_matrix(self.momentum));
        matrix
    }
}

impl<T: Real> std::ops::Mul<T> for Inertia<T> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self { mass: self.mass * factor, moment: self.moment * factor, rotational: self.rotational * factor }
    }
}

impl<T: Real> AddAssign for CoriolisFactor<T> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.rotational += other.rotational;
        self.momentum += other.momentum;
    }
}
