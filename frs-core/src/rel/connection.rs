//! A_l, the local mechanical connection, and M_bq.

use nalgebra::{Matrix6xX, Vector3};

use crate::Real;
use crate::spatial::{Twist, Wrench};
use crate::sweep::{Moving, Shape, splat};

impl<T: Real> Shape<'_, '_, T> {
    /// The coupling block `M_bq = Σ_k X_kᵀ M_k J_k` (6×n, base frame): momentum per joint rate with the base held still.
    ///
    /// # Panics
    /// If `out` does not have n columns.
    pub fn base_joint_inertia(&self, out: &mut Matrix6xX<T>) {
        let centre: Vector3<T::Lanes> = splat(-self.com());
        self.model.gather_groups(out.as_mut_slice(), 6, |first| {
            self.data.inside.lanes::<Wrench<_>>(first).at(centre).to_array()
        });
    }

    /// The local mechanical connection `A_l = Λ_b⁻¹ M_bq` (6×n, base frame): at zero momentum the base moves with
    /// `V₁ = −A_l q̇`.
    ///
    /// Source: the paper; docs/mathematics.md §2. Units: rad and m per unit of the coordinate.
    ///
    /// # Panics
    /// If `out` does not have n columns.
    pub fn connection(&self, out: &mut Matrix6xX<T>) {
        let centre: Vector3<T::Lanes> = splat(-self.com());
        self.model.gather_groups(out.as_mut_slice(), 6, |first| {
            self.data.connection.lanes::<Twist<_>>(first).at(centre).to_array()
        });
    }
}

impl<T: Real> Moving<'_, '_, '_, T> {
    /// The locked velocity `μ = V₁ + A_l q̇` (base frame) of a base moving with the body twist `V₁`.
    pub fn locked_velocity(&self, base_twist: Twist<T>) -> Twist<T> {
        base_twist - self.free_base_twist()
    }

    /// The base's body twist `V₁ = μ − A_l q̇`, which reconstructs the pose: `ġ₁ = g₁ V₁^`.
    ///
    /// ```
    /// # use frs_core::{Model, Workspace, spatial::Twist};
    /// # let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
    /// # let mut work = Workspace::new(&model);
    /// let mut shape = work.shape(&[0.3; 7]);
    /// let motion = shape.moving(&[1.0; 7]);
    /// let mu = Twist::from_array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
    /// let there_and_back = motion.locked_velocity(motion.base_twist(mu));
    /// assert!((there_and_back - mu).to_vector().norm() < 1e-15);
    /// # Ok::<(), frs_core::urdf::UrdfError>(())
    /// ```
    pub fn base_twist(&self, mu: Twist<T>) -> Twist<T> {
        mu + self.free_base_twist()
    }

    /// `−A_l q̇` in the base frame.
    fn free_base_twist(&self) -> Twist<T> {
        self.data.velocity[0].at(-self.com())
    }
}
