//! A wrench on a link, as a function of time.
//!
//! ```text
//! F_k = [m + p × f; f]                       axes of the link
//! m, f ← R_kᵀ m, R_kᵀ f                      if they are written in axes of the world
//! F₁ += X_kᵀ F_k,   τ += J_kᵀ F_k
//! ```
//!
//! The force f (N) acts at the point p of the link (m, link frame), the moment m (N·m) is about it. The disturbance of the paper's
//! example is such a wrench on the base, for 40 ms.

use frs_core::spatial::{Pose, Wrench};
use frs_core::{Moving, Real};
use nalgebra::Vector3;

use super::Effect;
use crate::motion::{Instant, Load, Loads};
use crate::signal::Signal;

/// Whose axes a wrench is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// The link's: the wrench turns with it.
    Link,
    /// The world's: the wrench keeps its direction.
    World,
}

/// A wrench on a link.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkWrench {
    /// The link's number ([`Model::link`](frs_core::Model::link)); none: the base.
    pub link: Option<usize>,
    /// Where it acts, m, link frame.
    pub point: [f64; 3],
    /// Moment (N·m), then force (N).
    pub wrench: [Signal; 6],
    /// What they are written in.
    pub axes: Axes,
}

impl<T: Real> Loads<T> for LinkWrench {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        if self.wrench.iter().all(Signal::is_zero) {
            return;
        }
        let mut wrench = Wrench::from_array(self.wrench.each_ref().map(|signal| signal.at(instant.time)));
        if self.axes == Axes::World {
            let base = instant.pose.rotation;
            let rotation = self.link.map_or(base, |link| base * robot.link_pose(link).rotation);
            wrench = Pose::new(rotation.transpose(), Vector3::zeros()).act_wrench(wrench);
        }
        if self.point != [0.0; 3] {
            wrench = wrench.at(-Vector3::from(self.point.map(T::from_f64)));
        }
        load.base_wrench += match self.link {
            None => wrench,
            Some(link) => robot.add_link_wrench(link, wrench, &mut load.tau),
        };
    }
}

impl<T: Real> Effect<T> for LinkWrench {
    fn enter(&mut self, time: f64) {
        self.wrench.iter_mut().for_each(|signal| signal.enter(time));
    }
}
