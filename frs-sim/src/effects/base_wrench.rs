//! A wrench on the base, constant from one time to another.
//!
//! ```text
//! F₁ = [m; f]                 axes of the base
//! F₁ = [R₁ᵀ m; R₁ᵀ f]         axes of the world
//! ```
//!
//! The moment (N·m) is about the origin of the base frame, the force (N) acts there, whatever the axes. The disturbance of the
//! paper's example is such a pulse.

use std::ops::Range;

use frs_core::Real;
use frs_core::spatial::{Pose, Wrench};
use nalgebra::Vector3;

use super::Effect;
use crate::motion::{Instant, Load, Loads};

/// Whose axes a wrench is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// The base's: the wrench turns with it.
    Base,
    /// The world's: the wrench keeps its direction.
    World,
}

/// A wrench at the origin of the base frame.
#[derive(Clone, Debug, PartialEq)]
pub struct BaseWrench {
    wrench: Wrench<f64>,
    frame: Frame,
    during: Range<f64>,
    acts: bool,
}

impl BaseWrench {
    /// `wrench` (N·m, N) with the axes of `frame`, from `during.start` until `during.end` (s, infinite for a wrench that stays).
    pub fn new(wrench: Wrench<f64>, frame: Frame, during: Range<f64>) -> Self {
        let acts = during.contains(&0.0);
        Self { wrench, frame, during, acts }
    }

    /// When it acts, s.
    pub fn during(&self) -> &Range<f64> {
        &self.during
    }
}

impl<T: Real> Loads<T> for BaseWrench {
    fn add(&mut self, instant: &Instant<'_, T>, load: &mut Load<T>) {
        if !self.acts {
            return;
        }
        let wrench = Wrench::from_array(self.wrench.to_array().map(T::from_f64));
        load.base_wrench += match self.frame {
            Frame::Base => wrench,
            Frame::World => Pose::new(instant.pose.rotation.transpose(), Vector3::zeros()).act_wrench(wrench),
        };
    }
}

impl<T: Real> Effect<T> for BaseWrench {
    fn events(&self) -> Vec<f64> {
        [self.during.start, self.during.end].into_iter().filter(|time| time.is_finite()).collect()
    }

    fn enter(&mut self, time: f64) {
        self.acts = self.during.contains(&time);
    }
}
