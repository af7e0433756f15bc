//! Forces that a scene can name, one file each.

mod base_wrench;
mod friction;
mod gravity;
mod joint_torque;
mod regulator;
mod spring;

use frs_core::Real;

use crate::motion::{Instant, Load, Loads};

pub use base_wrench::{BaseWrench, Frame};
pub use friction::Friction;
pub use gravity::Gravity;
pub use joint_torque::JointTorque;
pub use regulator::{Decoupling, Gains, Regulator};
pub use spring::Spring;

/// Forces that are smooth in time but for jumps at known times.
///
/// Whoever integrates stops at each of [`events`](Self::events) and says [`enter`](Self::enter) there: until then the forces are
/// those of one side, so that no step straddles a jump, not even with its last evaluation.
pub trait Effect<T: Real>: Loads<T> {
    /// Times at which the forces jump, s.
    fn events(&self) -> Vec<f64> {
        Vec::new()
    }

    /// The motion goes on from `time` (s): the forces are those after it.
    fn enter(&mut self, time: f64) {
        let _ = time;
    }
}

/// The effects of one scene, in its order; what is not in the list is not computed.
#[derive(Default)]
pub struct Effects<'m, T: Real = f64>(pub Vec<Box<dyn Effect<T> + 'm>>);

impl<T: Real> Loads<T> for Effects<'_, T> {
    fn add(&mut self, instant: &Instant<'_, T>, load: &mut Load<T>) {
        self.0.iter_mut().for_each(|effect| effect.add(instant, load));
    }
}

impl<T: Real> Effect<T> for Effects<'_, T> {
    fn events(&self) -> Vec<f64> {
        self.0.iter().flat_map(|effect| effect.events()).collect()
    }

    fn enter(&mut self, time: f64) {
        self.0.iter_mut().for_each(|effect| effect.enter(time));
    }
}
