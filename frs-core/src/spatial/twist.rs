//! Twists: velocities of rigid bodies, and columns of Jacobians and connections.

use nalgebra::{Matrix6, Vector3, Vector6};

use super::six::six_vector;
use super::{Wrench, cross, cross_matrix, plus_scaled};
use crate::{FUSED, Real};

/// A twist `V = [ω; v]`: angular velocity, and linear velocity of the point at the frame's origin.
///
/// Units: rad/s and m/s; the column of a revolute joint is per rad/s, of a prismatic joint per m/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<T: Real> {
    /// Angular part ω.
    pub angular: Vector3<T>,
    /// Linear part v.
    pub linear: Vector3<T>,
}

six_vector!(Twist, angular, linear);

impl<T: Real> Twist<T> {
    /// The power `⟨h, V⟩ = mᵀω + fᵀv` of a wrench on this twist.
    #[inline(always)]
    pub fn dot(self, wrench: Wrench<T>) -> T {
        let (w, v, m, f) = (self.angular, self.linear, wrench.moment, wrench.force);
        let turning = (w.x * m.x).plus_product(w.y, m.y).plus_product(w.z, m.z);
        turning.plus_product(v.x, f.x).plus_product(v.y, f.y).plus_product(v.z, f.z)
    }

    /// `ad_V W = [ω_V × ω_W; ω_V × v_W + v_V × ω_W]`, the Lie bracket `[V, W]` of body-fixed twists.
    ///
    /// ```
    /// use frs_core::spatial::Twist;
    /// let turn = Twist::from_array([0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    /// let slide = Twist::from_array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    /// assert_eq!(turn.ad(slide).to_array(), [0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    /// ```
    #[inline(always)]
    pub fn ad(self, other: Self) -> Self {
        Self::new(
            cross(&self.angular, &other.angular),
            cross(&self.angular, &other.linear) + cross(&self.linear, &other.angular),
        )
    }

    /// `ad_Vᵀ h = −[ω × m + v × f; ω × f]`, so that `⟨ad_Vᵀ h, W⟩ = ⟨h, ad_V W⟩`.
    #[inline(always)]
    pub fn ad_transpose(self, wrench: Wrench<T>) -> Wrench<T> {
        // x × y = −(y × x): the sign is taken by the order of the factors.
        Wrench::new(
            cross(&wrench.moment, &self.angular) + cross(&wrench.force, &self.linear),
            cross(&wrench.force, &self.angular),
        )
    }

    /// The 6×6 matrix of [`ad`](Self::ad), `[[ω×, 0], [v×, ω×]]`.
    pub fn ad_matrix(self) -> Matrix6<T> {
        let mut matrix = Matrix6::zeros();
        let angular = cross_matrix(self.angular);
        matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&angular);
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&cross_matrix(self.linear));
        matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&angular);
        matrix
    }

    /// The same motion seen from a frame with the same axes whose origin stands at `point`: `Ad_{(1,point)}⁻¹ V`.
    #[inline(always)]
    pub fn at(self, point: Vector3<T>) -> Self {
        Self::new(self.angular, self.linear + cross(&self.angular, &point))
    }
}
