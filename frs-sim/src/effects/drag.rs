//! Linear drag on a link in a fluid.
//!
//! ```text
//! F_k = −[D_ω ω_k; D_v (v_k − R_kᵀ u)]        D_ω (N·m·s/rad), D_v (N·s/m): diagonal, axes of the link
//! ```
//!
//! v_k is the velocity of the link frame's origin, u the fluid's (m/s, world axes).

use frs_core::spatial::Wrench;
use frs_core::{Moving, Real};
use nalgebra::Vector3;

use super::Effect;
use crate::motion::{Instant, Load, Loads};

/// Linear drag on a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Drag {
    /// The link's number.
    pub link: usize,
    /// Diagonal of D_ω (N·m·s/rad), about the axes of the link.
    pub rotational: [f64; 3],
    /// Diagonal of D_v (N·s/m), along the axes of the link.
    pub translational: [f64; 3],
    /// u, velocity of the fluid (m/s, world axes).
    pub current: [f64; 3],
}

impl<T: Real> Loads<T> for Drag {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        let mut twist = robot.link_twist(self.link, instant.mu);
        if self.current != [0.0; 3] {
            let rotation = instant.pose.rotation * robot.link_pose(self.link).rotation;
            twist.linear -= rotation.transpose() * Vector3::from(self.current.map(T::from_f64));
        }
        let slowed = |by: [f64; 3], v: Vector3<T>| -Vector3::from(by.map(T::from_f64)).component_mul(&v);
        let wrench = Wrench::new(slowed(self.rotational, twist.angular), slowed(self.translational, twist.linear));
        load.base_wrench += robot.add_link_wrench(self.link, wrench, &mut load.tau);
    }
}

impl<T: Real> Effect<T> for Drag {}
