//! Forces that a scene can name, one file each.

mod added_mass;
mod computed_torque;
mod contact;
mod drag;
mod end_effector;
mod friction;
mod gravity;
mod joint_torque;
mod regulator;
mod spring;
mod stops;
mod wrench;

use frs_core::{Moving, Real};

use crate::motion::{Instant, Load, Loads};

pub use added_mass::{AddedMass, Water};
pub use computed_torque::ComputedTorque;
pub use contact::Contact;
pub use drag::Drag;
pub use end_effector::{EndEffector, Target};
pub use friction::{Coulomb, Viscous};
pub use gravity::Gravity;
pub use joint_torque::JointTorque;
pub use regulator::{Decoupling, Gains, Regulator};
pub use spring::Spring;
pub use stops::Stops;
pub use wrench::{Axes, LinkWrench};

/// Forces that are smooth but for events: times that are known, and states in which something is met or left.
///
/// Whoever integrates stops at each known time and says [`enter`](Self::enter) there, and stops where one of [`gaps`](Self::gaps)
/// passes 0 and says [`touch`](Self::touch). Between events the forces are those of one side, so that no step
/// straddles a jump, not even with its last evaluation.
pub trait Effect<T: Real>: Loads<T> {
    /// The motion goes on from `time` (s): the forces are those after it.
    fn enter(&mut self, time: f64) {
        let _ = time;
    }

    /// Adds distances to the list, always as many: what they are from is touched where one is negative.
    fn gaps(&self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, gaps: &mut Vec<T>) {
        let _ = (instant, robot, gaps);
    }

    /// The forces are those with the gap of this number (counted from 0 within this effect) closed, or open.
    fn touch(&mut self, gap: usize, closed: bool) {
        let _ = (gap, closed);
    }
}

/// The larger of x and 0, without asking which it is: `½ (x + √(x²))`.
fn positive<T: Real>(x: T) -> T {
    (x + (x * x).sqrt()) * T::from_f64(0.5)
}

/// The effects of one scene, in its order, each with its number among the scene's forces; what is not in the list is not computed.
#[derive(Default)]
pub struct Effects<'m, T: Real = f64>(pub Vec<(usize, Box<dyn Effect<T> + 'm>)>);

impl<T: Real> Loads<T> for Effects<'_, T> {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        self.0.iter_mut().for_each(|(_, effect)| effect.add(instant, robot, load));
    }
}

impl<T: Real> Effects<'_, T> {
    /// The motion goes on from `time` (s).
    pub fn enter(&mut self, time: f64) {
        self.0.iter_mut().for_each(|(_, effect)| effect.enter(time));
    }

    /// All gaps in `gaps`, and whose they are in `owners`: the effect's place in the list, and the gap's number within it.
    pub fn gaps(
        &self,
        instant: &Instant<'_, T>,
        robot: &mut Moving<'_, '_, '_, T>,
        gaps: &mut Vec<T>,
        owners: &mut Vec<[usize; 2]>,
    ) {
        gaps.clear();
        owners.clear();
        for (place, (_, effect)) in self.0.iter().enumerate() {
            let first = gaps.len();
            effect.gaps(instant, robot, gaps);
            owners.extend((first..gaps.len()).map(|gap| [place, gap - first]));
        }
    }

    /// Closes or opens a gap.
    pub fn touch(&mut self, [effect, gap]: [usize; 2], closed: bool) {
        self.0[effect].1.touch(gap, closed);
    }
}
