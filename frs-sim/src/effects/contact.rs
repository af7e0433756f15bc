//! Compliant contact of a point of a link with a plane.
//!
//! ```text
//! d = h − nᵀx > 0                            depth of the point x (world) below the plane nᵀx = h, m
//! N = k d^{3/2} (1 + c ḋ) ≥ 0                force along n (N)
//! F = N n − f N v_t / √(v_t² + v_s²)         friction against the tangential velocity v_t
//! ```
//!
//! Hunt and Crossley (1975): the force is continuous where the point meets the plane. Below the velocity v_s friction passes
//! smoothly from one side to the other, so that a point at rest creeps. Meeting and leaving the plane are events that steps meet.

use frs_core::spatial::{Pose, Wrench};
use frs_core::{Moving, Real};
use nalgebra::Vector3;

use super::{Effect, positive};
use crate::motion::{Instant, Load, Loads};

/// A point of a link that may touch a plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// The link's number.
    pub link: usize,
    /// The point, m, link frame.
    pub point: [f64; 3],
    /// n, unit normal of the plane, world axes; the robot is on its side.
    pub normal: [f64; 3],
    /// h, distance of the plane from the world's origin along n, m.
    pub offset: f64,
    /// k, N/m^{3/2}.
    pub stiffness: f64,
    /// c, s/m.
    pub dissipation: f64,
    /// f.
    pub friction: f64,
    /// v_s, m/s.
    pub smooth_below: f64,
    /// Whether it touches.
    pub touches: bool,
}

impl Contact {
    /// Pose of the point with the link's axes in the world.
    fn place<T: Real>(&self, instant: &Instant<'_, T>, robot: &Moving<'_, '_, '_, T>) -> Pose<T> {
        let point = Pose::new(nalgebra::Matrix3::identity(), self.point.map(T::from_f64).into());
        *instant.pose * (robot.link_pose(self.link) * point)
    }

    fn gap<T: Real>(&self, normal: &Vector3<T>, place: &Pose<T>) -> T {
        normal.dot(&place.translation) - T::from_f64(self.offset)
    }
}

impl<T: Real> Loads<T> for Contact {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        if !self.touches {
            return;
        }
        let [k, c, f, v_s] = [self.stiffness, self.dissipation, self.friction, self.smooth_below].map(T::from_f64);
        let (normal, point) = (Vector3::from(self.normal.map(T::from_f64)), Vector3::from(self.point.map(T::from_f64)));
        let place = self.place(instant, robot);
        let velocity = place.rotation * robot.link_twist(self.link, instant.mu).at(point).linear;

        let depth = positive(-self.gap(&normal, &place));
        let away = normal.dot(&velocity);
        let push = k * depth * depth.sqrt() * positive(T::one() - c * away);
        let slip = velocity - normal * away;
        let grip = f * push / (slip.dot(&slip) + v_s * v_s).sqrt();
        let force = normal * push - slip * grip;

        let wrench = Wrench::new(Vector3::zeros(), place.rotation.transpose() * force).at(-point);
        load.base_wrench += robot.add_link_wrench(self.link, wrench, &mut load.tau);
    }
}

impl<T: Real> Effect<T> for Contact {
    fn gaps(&self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, gaps: &mut Vec<T>) {
        let normal = Vector3::from(self.normal.map(T::from_f64));
        gaps.push(self.gap(&normal, &self.place(instant, robot)));
    }

    fn touch(&mut self, _: usize, closed: bool) {
        self.touches = closed;
    }
}
