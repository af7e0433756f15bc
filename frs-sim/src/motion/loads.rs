//! Forces on a robot in motion.

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Moving, Real};

/// A robot at an instant, as forces see it.
#[derive(Clone, Copy, Debug)]
pub struct Instant<'a, T: Real = f64> {
    /// Time, s.
    pub time: T,
    /// Pose g₁ of the base in the world.
    pub pose: &'a Pose<T>,
    /// Shape (rad, m).
    pub q: &'a [T],
    /// Shape velocity (rad/s, m/s).
    pub qd: &'a [T],
    /// Locked velocity, base frame.
    pub mu: Twist<T>,
}

/// What forces add up to.
#[derive(Clone, Debug, PartialEq)]
pub struct Load<T: Real = f64> {
    /// Wrench F₁ on the base, base frame.
    pub base_wrench: Wrench<T>,
    /// Acceleration γ of free fall, base axes (m/s²).
    pub gravity: [T; 3],
    /// Joint torques τ (N·m, N).
    pub tau: Vec<T>,
}

impl<T: Real> Load<T> {
    /// No load on n joints.
    pub fn zero(n: usize) -> Self {
        Self { base_wrench: Wrench::zero(), gravity: [T::zero(); 3], tau: vec![T::zero(); n] }
    }

    /// No load.
    pub fn clear(&mut self) {
        self.base_wrench = Wrench::zero();
        self.gravity = [T::zero(); 3];
        self.tau.fill(T::zero());
    }
}

/// Something that exerts forces. Two are a pair `(a, b)`, none is `()`.
///
/// Where the momentum is [`Zero`](super::Zero) or [`Conserved`](super::Conserved), only joint torques may be added.
pub trait Loads<T: Real> {
    /// Adds the forces at an instant. `robot` is the robot in that state: what was swept for its motion answers here, too.
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>);
}

impl<T: Real> Loads<T> for () {
    fn add(&mut self, _: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, _: &mut Load<T>) {}
}

impl<T: Real, A: Loads<T>, B: Loads<T>> Loads<T> for (A, B) {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        self.0.add(instant, robot, load);
        self.1.add(instant, robot, load);
    }
}

/// A function of the instant: `|instant, robot, load| …`.
impl<T: Real, F: FnMut(&Instant<'_, T>, &mut Moving<'_, '_, '_, T>, &mut Load<T>)> Loads<T> for F {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        self(instant, robot, load);
    }
}
