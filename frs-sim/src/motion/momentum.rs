//! What is known about the momentum of a motion.

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Real, Shape};
use nalgebra::Vector3;

/// How a motion knows its locked velocity μ.
pub trait Momentum<T: Real> {
    /// Numbers of a state that are integrated for it: 6 for μ, or none.
    const NUMBERS: usize;

    /// μ of a robot in a shape, at a time (s) and a pose; `numbers` are those integrated for it.
    fn locked_velocity(&self, time: T, pose: &Pose<T>, shape: &Shape<'_, '_, T>, numbers: &[T]) -> Twist<T>;

    /// At a time (s) the robot becomes one of another mass (kg), with another momentum about its centre of mass (world axes).
    ///
    /// Not for [`Zero`], which has none.
    fn change(&mut self, time: T, momentum: Wrench<T>, mass: T);
}

/// No momentum, and nothing that gives one: μ = 0. The base moves as the shape's connection says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zero;

/// No wrench acts: momentum stays what it is, and μ is not integrated but follows from it,
/// with h the momentum about the centre of mass in world axes, `Λ_c μ_c = [R₁ᵀ h_ω; R₁ᵀ h_v]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conserved<T: Real = f64> {
    /// Momentum h about the centre of mass, world axes (kg·m²/s, kg·m/s); both halves are constant.
    pub momentum: Wrench<T>,
}

/// Uniform gravity and no other wrench: [`Conserved`] but for `ḣ_v = m a`. Gravity pulls on all mass alike, so that the shape and the
/// angular momentum do not notice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ballistic<T: Real = f64> {
    /// Momentum about the centre of mass at the time `since`, world axes (kg·m²/s, kg·m/s).
    pub momentum: Wrench<T>,
    /// a, acceleration of free fall, world axes (m/s²).
    pub acceleration: Vector3<T>,
    /// m, kg.
    pub mass: T,
    /// s.
    pub since: T,
}

/// Wrenches act: μ is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driven;

impl<T: Real> Momentum<T> for Zero {
    const NUMBERS: usize = 0;

    fn locked_velocity(&self, _: T, _: &Pose<T>, _: &Shape<'_, '_, T>, _: &[T]) -> Twist<T> {
        Twist::zero()
    }

    fn change(&mut self, _: T, _: Wrench<T>, _: T) {}
}

impl<T: Real> Momentum<T> for Conserved<T> {
    const NUMBERS: usize = 0;

    fn locked_velocity(&self, _: T, pose: &Pose<T>, shape: &Shape<'_, '_, T>, _: &[T]) -> Twist<T> {
        let turned = Pose::new(pose.rotation.transpose(), Vector3::zeros()).act_wrench(self.momentum);
        shape.velocity_of_centroidal_momentum(turned)
    }

    fn change(&mut self, _: T, momentum: Wrench<T>, _: T) {
        self.momentum = momentum;
    }
}

impl<T: Real> Momentum<T> for Ballistic<T> {
    const NUMBERS: usize = 0;

    fn locked_velocity(&self, time: T, pose: &Pose<T>, shape: &Shape<'_, '_, T>, numbers: &[T]) -> Twist<T> {
        let Wrench { moment, force } = self.momentum;
        let fallen = force + self.acceleration * (self.mass * (time - self.since));
        Conserved { momentum: Wrench::new(moment, fallen) }.locked_velocity(time, pose, shape, numbers)
    }

    fn change(&mut self, since: T, momentum: Wrench<T>, mass: T) {
        *self = Self { momentum, mass, since, ..*self };
    }
}

impl<T: Real> Momentum<T> for Driven {
    const NUMBERS: usize = 6;

    fn locked_velocity(&self, _: T, _: &Pose<T>, _: &Shape<'_, '_, T>, numbers: &[T]) -> Twist<T> {
        Twist::from_array(std::array::from_fn(|i| numbers[i]))
    }

    fn change(&mut self, _: T, _: Wrench<T>, _: T) {}
}
