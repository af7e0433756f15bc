//! The power of each force of a scene.

use frs_core::{Moving, Real};
use nalgebra::Vector3;

use crate::effects::Effects;
use crate::motion::{Instant, Load, Loads};
use crate::scene::{Force, Scene};

/// Effects, and the power of each of a scene's forces, by their numbers:
///
/// ```text
/// effects              ⟨F₁, V₁⟩ + ⟨τ, q̇⟩        with what the effect adds to F₁ and τ
/// gravity              ⟨p, R₁ᵀ a⟩               p: linear momentum, base axes
/// joints on a course   (τ − τ_e) q̇              τ: what the joint takes; τ_e: what the effects add to it
/// ```
pub struct Meter<'m, T: Real = f64> {
    pub effects: Effects<'m, T>,
    /// W; 0 for what is neither.
    power: Vec<T>,
    /// Accelerations of gravity.
    falls: Vec<(usize, Vector3<T>)>,
    /// Coordinates on a course.
    courses: Vec<(usize, usize)>,
    /// What the effects add up to.
    sum: Load<T>,
}

impl<'m, T: Real> Meter<'m, T> {
    /// For the effects of a scene.
    pub fn new(scene: &Scene, effects: Effects<'m, T>) -> Self {
        let (mut falls, mut courses) = (Vec::new(), Vec::new());
        for (number, named) in scene.forces.iter().enumerate() {
            match &named.force {
                Force::Gravity(gravity) => falls.push((number, Vector3::from(gravity.acceleration).map(T::from_f64))),
                Force::Prescribed(coordinate, _) => courses.push((number, *coordinate)),
                _ => {}
            }
        }
        let sum = Load::zero(scene.start.q.len());
        Self { effects, power: vec![T::zero(); scene.forces.len()], falls, courses, sum }
    }

    /// How many forces there are.
    pub fn len(&self) -> usize {
        self.power.len()
    }

    /// The powers at the instant that was asked for last, at which the joints had these torques and rates.
    pub fn powers(&self, tau: &[T], qd: &[T], out: &mut [T]) {
        out.copy_from_slice(&self.power);
        for &(number, joint) in &self.courses {
            out[number] = (tau[joint] - self.sum.tau[joint]) * qd[joint];
        }
    }
}

impl<T: Real> Loads<T> for Meter<'_, T> {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        let Self { effects, power, falls, sum, .. } = self;
        let twist = robot.base_twist(instant.mu);
        sum.clone_from(load);
        for (number, effect) in &mut effects.0 {
            effect.add(instant, robot, load);
            let torques = load.tau.iter().zip(&sum.tau).zip(instant.qd);
            let joints = torques.fold(T::zero(), |sum, ((&after, &before), &qd)| sum + (after - before) * qd);
            power[*number] = twist.dot(load.base_wrench - sum.base_wrench) + joints;
            sum.clone_from(load);
        }
        if !falls.is_empty() {
            let momentum = instant.pose.rotation * robot.body_momentum(instant.mu).force;
            falls.iter().for_each(|(number, acceleration)| power[*number] = momentum.dot(acceleration));
        }
    }
}
