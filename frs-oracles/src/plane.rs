//! The locked inertia of bodies whose centres lie in the x-z plane, while one of them turns about y.

use frs_core::Real;
use nalgebra::Vector3;

/// K about the centre of mass in the plane's axes, with y a principal axis, and its rates along the angle of the joint.
pub struct PlaneInertia<T: Real> {
    /// K_xx and its rate, kg·m².
    pub xx: [T; 2],
    /// K_xz and its rate.
    pub xz: [T; 2],
    /// K_zz and its rate.
    pub zz: [T; 2],
}

/// A vector (x, 0, z) of the plane and its rate.
#[derive(Clone, Copy)]
pub struct InPlane<T: Real> {
    /// x and its rate.
    pub x: [T; 2],
    /// z and its rate.
    pub z: [T; 2],
}

impl<T: Real> PlaneInertia<T> {
    /// Δ = K_xx K_zz − K_xz².
    pub fn determinant(&self) -> T {
        self.xx[0] * self.zz[0] - self.xz[0] * self.xz[0]
    }

    /// K⁻¹ b and its rate, `(K⁻¹b)′ = K⁻¹(b′ − K′ K⁻¹b)`.
    pub fn solve(&self, b: InPlane<T>) -> InPlane<T> {
        let at = |x: T, z: T| {
            let determinant = self.determinant();
            [(self.zz[0] * x - self.xz[0] * z) / determinant, (self.xx[0] * z - self.xz[0] * x) / determinant]
        };
        let [x, z] = at(b.x[0], b.z[0]);
        let [x_rate, z_rate] = at(b.x[1] - self.xx[1] * x - self.xz[1] * z, b.z[1] - self.xz[1] * x - self.zz[1] * z);
        InPlane { x: [x, x_rate], z: [z, z_rate] }
    }
}

impl<T: Real> InPlane<T> {
    /// z, at rest.
    pub fn z() -> Self {
        Self { x: [T::zero(); 2], z: [T::one(), T::zero()] }
    }

    /// (x, 0, z).
    pub fn vector(self) -> Vector3<T> {
        Vector3::new(self.x[0], T::zero(), self.z[0])
    }

    /// Its rate in a frame that turns with `turn` about −y: (x′ − turn·z, 0, z′ + turn·x).
    pub fn turned_rate(self, turn: T) -> Vector3<T> {
        Vector3::new(self.x[1] - turn * self.z[0], T::zero(), self.z[1] + turn * self.x[0])
    }
}
