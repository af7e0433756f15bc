//! What is known about the momentum of a motion.

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{FloatingBase, Quantity, Real};

/// How a motion knows its locked velocity μ.
pub trait Momentum<T: Real> {
    /// Numbers of a state that are integrated for it: 6 for μ, or none.
    const NUMBERS: usize;

    /// What the robot must answer for it.
    const QUANTITIES: &'static [Quantity];

    /// μ at a pose and a shape; `numbers` are those integrated for it.
    fn locked_velocity(&self, robot: &mut impl FloatingBase<T>, pose: &Pose<T>, q: &[T], numbers: &[T]) -> Twist<T>;
}

/// No momentum, and nothing that gives one: μ = 0. The base moves as the shape's connection says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zero;

/// No wrench acts: the momentum about the world's origin stays what it is, and `μ = Λ_b⁻¹ Ad_{g₁}ᵀ J` is not integrated.
///
/// A fall under uniform gravity alone is of this kind in a frame that falls with the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conserved<T: Real = f64> {
    /// The momentum J (moment in kg·m²/s, force in kg·m/s), about the origin and in the axes of the world.
    pub momentum: Wrench<T>,
}

/// Wrenches or gravity act: μ is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driven;

impl<T: Real> Momentum<T> for Zero {
    const NUMBERS: usize = 0;
    const QUANTITIES: &'static [Quantity] = &[];

    fn locked_velocity(&self, _: &mut impl FloatingBase<T>, _: &Pose<T>, _: &[T], _: &[T]) -> Twist<T> {
        Twist::zero()
    }
}

impl<T: Real> Momentum<T> for Conserved<T> {
    const NUMBERS: usize = 0;
    const QUANTITIES: &'static [Quantity] = &[Quantity::VelocityOfMomentum];

    fn locked_velocity(&self, robot: &mut impl FloatingBase<T>, pose: &Pose<T>, q: &[T], _: &[T]) -> Twist<T> {
        let body = pose.inverse().act_wrench(self.momentum).to_array();
        let mut mu = [T::zero(); 6];
        robot.answer(Quantity::VelocityOfMomentum, &[q, &body], &mut [&mut mu]);
        Twist::from_array(mu)
    }
}

impl<T: Real> Momentum<T> for Driven {
    const NUMBERS: usize = 6;
    const QUANTITIES: &'static [Quantity] = &[];

    fn locked_velocity(&self, _: &mut impl FloatingBase<T>, _: &Pose<T>, _: &[T], numbers: &[T]) -> Twist<T> {
        Twist::from_array(std::array::from_fn(|i| numbers[i]))
    }
}
