//! Two axisymmetric bodies joined by a z-y-z wrist on both axes.

use frs_core::Real;
use frs_core::model::{InertialDescription, JointKind, RobotDescription};
use nalgebra::Vector3;

use crate::Values;
use crate::description::at;
use crate::plane::{InPlane, PlaneInertia};
use crate::reduced_mass::reduced_mass;
use crate::rotation::{about_z, quarter_turn};

/// Two bodies of revolution about z, joined where their axes meet.
pub struct Wrist {
    /// The base.
    pub base: InertialDescription,
    /// The other body, in a frame with its origin at the wrist.
    pub tail: InertialDescription,
    /// Height of the wrist in the base frame, m.
    pub height: f64,
}

impl Wrist {
    /// The robot, with two links without mass between the bodies.
    pub fn robot(&self, name: &str) -> RobotDescription {
        let mut robot = RobotDescription::new(name);
        robot.link("base", self.base);
        robot.link("wrist_1", InertialDescription::NONE);
        robot.link("wrist_2", InertialDescription::NONE);
        robot.link("tail", self.tail);
        let origin = at([0.0, 0.0, self.height]);
        robot.joint("joint_1", JointKind::Continuous, "base", "wrist_1").origin(origin).axis(0.0, 0.0, 1.0);
        robot.joint("joint_2", JointKind::Continuous, "wrist_1", "wrist_2").axis(0.0, 1.0, 0.0);
        robot.joint("joint_3", JointKind::Continuous, "wrist_2", "tail").axis(0.0, 0.0, 1.0);
        robot
    }

    /// With K the locked inertia in the plane of both axes, b the tail's axis, j₁ and j₂ the axial inertias:
    /// `A_ω = R_z(q₁)[z − j₁K⁻¹z, η y, j₂K⁻¹b]`, `𝓑_ω,12 = j₁R_z(q₁)(u′ − ηw, 0, w′ + ηu)` with (u, w) = K⁻¹z,
    /// `𝓑_ω,23` the same with j₂ and K⁻¹b, and `𝓑_ω,13 = (j₁j₂ sin q₂/Δ) R_z(q₁) y`.
    pub fn values<T: Real>(&self, q: &[T]) -> Values<T> {
        let real = T::from_f64;
        let (two, zero) = (real(2.0), T::zero());
        let (base, tail) = (&self.base, &self.tail);
        let [a1, j1] = [base.inertia.xx, base.inertia.zz].map(real);
        let [a2, j2] = [tail.inertia.xx, tail.inertia.zz].map(real);
        let (l1, l2) = (real(self.height - base.com.z), real(tail.com.z));
        let epsilon = reduced_mass::<T>(base.mass, tail.mass);
        let (turn, (s, c)) = (about_z(q[0]), q[1].sin_cos());

        let (rho_x, rho_z, delta) = (l2 * s, l1 + l2 * c, j2 - a2);
        let locked = PlaneInertia {
            xx: [
                a1 + a2 + delta * s * s + epsilon * rho_z * rho_z,
                two * delta * s * c - two * epsilon * l2 * s * rho_z,
            ],
            xz: [
                delta * s * c - epsilon * rho_x * rho_z,
                delta * (c * c - s * s) - epsilon * l2 * (c * rho_z - s * rho_x),
            ],
            zz: [
                j1 + a2 + delta * c * c + epsilon * rho_x * rho_x,
                two * epsilon * l2 * c * rho_x - two * delta * s * c,
            ],
        };
        let about_y = a1 + a2 + epsilon * (rho_x * rho_x + rho_z * rho_z);
        let eta = (a2 + epsilon * l2 * (l2 + l1 * c)) / about_y;
        let axial = locked.solve(InPlane::z());
        let tail_axial = locked.solve(InPlane { x: [s, c], z: [c, -s] });

        let total = real(base.mass + tail.mass);
        let lever = real(tail.mass) * l2 / total;
        let axis = turn * Vector3::new(s, zero, c);
        let height = real(base.mass * base.com.z + tail.mass * self.height) / total;
        let com = Vector3::z() * height + axis * lever;
        Values::turning(
            &[Vector3::z() - turn * axial.vector() * j1, turn * Vector3::y() * eta, turn * tail_axial.vector() * j2],
            com,
            &[quarter_turn(com), turn * Vector3::new(c, zero, -s) * lever, Vector3::zeros()],
            &[
                turn * axial.turned_rate(eta) * j1,
                turn * Vector3::y() * (j1 * j2 * s / locked.determinant()),
                turn * tail_axial.turned_rate(eta) * j2,
            ],
        )
    }
}
