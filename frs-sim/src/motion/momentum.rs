//! What is known about the momentum of a motion.

use frs_core::lanes::Lane;
use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Moving, Real, Route};
use nalgebra::{DMatrix, Vector3};

use super::Load;

/// How a motion knows its locked velocity μ.
pub trait Momentum<T: Real> {
    /// Numbers of a state that are integrated for it: 6, or none.
    const NUMBERS: usize;

    /// μ of a robot, at a time (s) and a pose; `numbers` are those integrated for it.
    fn locked_velocity(&self, time: T, pose: &Pose<T>, robot: &Moving<'_, '_, '_, T>, numbers: &[T]) -> Twist<T>;

    /// The six numbers that stand for μ, where six are integrated: itself.
    fn numbers(&self, robot: &Moving<'_, '_, '_, T>, mu: Twist<T>) -> Twist<T> {
        let _ = robot;
        mu
    }

    /// `q̈` under a load, and the rates of the numbers.
    fn accelerations(
        &mut self,
        robot: &mut Moving<'_, '_, '_, T>,
        route: Route,
        mu: Twist<T>,
        load: &Load<T>,
        qdd: &mut [T],
        numbers: &mut [T],
    ) {
        robot.shape_acceleration_by(route, mu, load.base_wrench, &load.tau, qdd);
        self.number_rates(robot, mu, load, qdd, numbers);
    }

    /// The rates of the numbers where `q̈` is known.
    fn number_rates(
        &mut self,
        robot: &mut Moving<'_, '_, '_, T>,
        mu: Twist<T>,
        load: &Load<T>,
        qdd: &[T],
        numbers: &mut [T],
    ) {
        let _ = qdd;
        if Self::NUMBERS > 0 {
            let rate = robot.locked_acceleration(mu, load.base_wrench) + fall(load);
            numbers.copy_from_slice(&rate.to_array());
        }
    }

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

/// The equations that other simulators integrate, for comparison: the base velocity V₁ in place of μ, and `M V̇ + C V = F` solved whole.
#[derive(Clone, Debug, PartialEq)]
pub struct Hamel<T: Real = f64> {
    inertia: DMatrix<T>,
    rates: Vec<T>,
}

impl<T: Real> Hamel<T> {
    /// Memory for robots of n coordinates.
    pub fn new(n: usize) -> Self {
        Self { inertia: DMatrix::zeros(6 + n, 6 + n), rates: vec![T::zero(); 6 + n] }
    }
}

/// What free fall adds to the acceleration of the base.
fn fall<T: Real>(load: &Load<T>) -> Twist<T> {
    Twist::new(Vector3::zeros(), load.gravity.into())
}

impl<T: Lane<Element = f64>> Conserved<T> {
    /// The momentum of one lane.
    ///
    /// # Panics
    /// If there is no such lane.
    pub fn set(&mut self, lane: usize, momentum: Wrench<f64>) {
        let Wrench { moment, force } = &mut self.momentum;
        let numbers = moment.iter_mut().chain(force);
        numbers.zip(momentum.to_array()).for_each(|(number, given)| number.set_lane(lane, given));
    }
}

impl<T: Real> Momentum<T> for Zero {
    const NUMBERS: usize = 0;

    fn locked_velocity(&self, _: T, _: &Pose<T>, _: &Moving<'_, '_, '_, T>, _: &[T]) -> Twist<T> {
        Twist::zero()
    }

    fn change(&mut self, _: T, _: Wrench<T>, _: T) {}
}

impl<T: Real> Momentum<T> for Conserved<T> {
    const NUMBERS: usize = 0;

    fn locked_velocity(&self, _: T, pose: &Pose<T>, robot: &Moving<'_, '_, '_, T>, _: &[T]) -> Twist<T> {
        let turned = Pose::new(pose.rotation.transpose(), Vector3::zeros()).act_wrench(self.momentum);
        robot.velocity_of_centroidal_momentum(turned)
    }

    fn change(&mut self, _: T, momentum: Wrench<T>, _: T) {
        self.momentum = momentum;
    }
}

impl<T: Real> Momentum<T> for Ballistic<T> {
    const NUMBERS: usize = 0;

    fn locked_velocity(&self, time: T, pose: &Pose<T>, robot: &Moving<'_, '_, '_, T>, numbers: &[T]) -> Twist<T> {
        let Wrench { moment, force } = self.momentum;
        let fallen = force + self.acceleration * (self.mass * (time - self.since));
        Conserved { momentum: Wrench::new(moment, fallen) }.locked_velocity(time, pose, robot, numbers)
    }

    fn change(&mut self, since: T, momentum: Wrench<T>, mass: T) {
        *self = Self { momentum, mass, since, ..*self };
    }
}

impl<T: Real> Momentum<T> for Driven {
    const NUMBERS: usize = 6;

    fn locked_velocity(&self, _: T, _: &Pose<T>, _: &Moving<'_, '_, '_, T>, numbers: &[T]) -> Twist<T> {
        Twist::from_array(std::array::from_fn(|i| numbers[i]))
    }

    fn change(&mut self, _: T, _: Wrench<T>, _: T) {}
}

impl<T: Real> Momentum<T> for Hamel<T> {
    const NUMBERS: usize = 6;

    fn locked_velocity(&self, _: T, _: &Pose<T>, robot: &Moving<'_, '_, '_, T>, numbers: &[T]) -> Twist<T> {
        robot.locked_velocity(Twist::from_array(std::array::from_fn(|i| numbers[i])))
    }

    fn numbers(&self, robot: &Moving<'_, '_, '_, T>, mu: Twist<T>) -> Twist<T> {
        robot.base_twist(mu)
    }

    /// The route does not count: Λ_q is not formed.
    fn accelerations(
        &mut self,
        robot: &mut Moving<'_, '_, '_, T>,
        _: Route,
        mu: Twist<T>,
        load: &Load<T>,
        qdd: &mut [T],
        numbers: &mut [T],
    ) {
        let Self { inertia, rates } = self;
        robot.hamel_acceleration(robot.base_twist(mu), load.base_wrench, &load.tau, inertia, rates);
        let base = Twist::from_array(std::array::from_fn(|i| rates[i])) + fall(load);
        numbers.copy_from_slice(&base.to_array());
        qdd.copy_from_slice(&rates[6..]);
    }

    /// `V̇₁ = Λ_b⁻¹ (F₁ − (C V)_b) − A_l q̈`
    fn number_rates(
        &mut self,
        robot: &mut Moving<'_, '_, '_, T>,
        mu: Twist<T>,
        load: &Load<T>,
        qdd: &[T],
        numbers: &mut [T],
    ) {
        robot.hamel_bias(robot.base_twist(mu), &mut self.rates);
        let bias = Wrench::from_array(std::array::from_fn(|i| self.rates[i]));
        let locked = robot.velocity_of_momentum(load.base_wrench - bias);
        let rate = robot.moving(qdd).base_twist(locked) + fall(load);
        numbers.copy_from_slice(&rate.to_array());
    }

    fn change(&mut self, _: T, _: Wrench<T>, _: T) {}
}
