//! Wrenches: forces on rigid bodies, and momenta.

use nalgebra::{Matrix6, Vector3, Vector6};

use super::six::six_vector;
use super::{cross, cross_matrix, plus_scaled};
use crate::{FUSED, Real};

/// A wrench `[m; f]`: moment about the frame's origin, and force. Also a momentum: angular and linear.
///
/// Units: N·m and N, or kg·m²/s and kg·m/s for a momentum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<T: Real> {
    /// Moment (or angular momentum) about the frame's origin.
    pub moment: Vector3<T>,
    /// Force (or linear momentum).
    pub force: Vector3<T>,
}

six_vector!(Wrench, moment, force);

impl<T: Real> Wrench<T> {
    /// The matrix `ad~_h = [[m×, f×], [f×, 0]]`, for which `ad~_h V = ad_Vᵀ h`.
    ///
    /// ```
    /// use frs_core::spatial::{Twist, Wrench};
    /// let v = Twist::from_array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    /// let h = Wrench::from_array([0.5, -1.0, 2.0, 3.0, 0.25, -4.0]);
    /// assert_eq!(h.ad_tilde() * v.to_vector(), v.ad_transpose(h).to_vector());
    /// ```
    pub fn ad_tilde(self) -> Matrix6<T> {
        let mut matrix = Matrix6::zeros();
        let force = cross_matrix(self.force);
        matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&cross_matrix(self.moment));
        matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&force);
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&force);
        matrix
    }

    /// The same wrench seen from a frame with the same axes whose origin stands at `point`: `Ad_{(1,point)}ᵀ h`.
    #[inline(always)]
    pub fn at(self, point: Vector3<T>) -> Self {
        Self::new(self.moment + cross(&self.force, &point), self.force)
    }
}
