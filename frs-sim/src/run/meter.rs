//! The power of each force of a scene.

use frs_core::Moving;
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
pub struct Meter<'m> {
    pub effects: Effects<'m>,
    /// W; 0 for what is neither.
    power: Vec<f64>,
    /// Accelerations of gravity.
    falls: Vec<(usize, Vector3<f64>)>,
    /// Coordinates on a course.
    courses: Vec<(usize, usize)>,
    /// What the effects add up to.
    sum: Load,
}

impl<'m> Meter<'m> {
    /// For the effects of a scene.
    pub fn new(scene: &Scene, effects: Effects<'m>) -> Self {
        let (mut falls, mut courses) = (Vec::new(), Vec::new());
        for (number, named) in scene.forces.iter().enumerate() {
            match &named.force {
                Force::Gravity(gravity) => falls.push((number, Vector3::from(gravity.acceleration))),
                Force::Prescribed(coordinate, _) => courses.push((number, *coordinate)),
                _ => {}
            }
        }
        let sum = Load::zero(scene.start.q.len());
        Self { effects, power: vec![0.0; scene.forces.len()], falls, courses, sum }
    }

    /// How many forces there are.
    pub fn len(&self) -> usize {
        self.power.len()
    }

    /// The powers at the instant that was asked for last, at which the joints had these torques and rates.
    pub fn powers(&self, tau: &[f64], qd: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&self.power);
        for &(number, joint) in &self.courses {
            out[number] = (tau[joint] - self.sum.tau[joint]) * qd[joint];
        }
    }
}

impl Loads<f64> for Meter<'_> {
    fn add(&mut self, instant: &Instant<'_>, robot: &mut Moving<'_, '_, '_>, load: &mut Load) {
        let Self { effects, power, falls, sum, .. } = self;
        let twist = robot.base_twist(instant.mu);
        sum.clone_from(load);
        for (number, effect) in &mut effects.0 {
            effect.add(instant, robot, load);
            let torques = load.tau.iter().zip(&sum.tau).zip(instant.qd);
            let joints: f64 = torques.map(|((after, before), qd)| (after - before) * qd).sum();
            power[*number] = twist.dot(load.base_wrench - sum.base_wrench) + joints;
            sum.clone_from(load);
        }
        if !falls.is_empty() {
            let momentum = instant.pose.rotation * robot.body_momentum(instant.mu).force;
            falls.iter().for_each(|(number, acceleration)| power[*number] = momentum.dot(acceleration));
        }
    }
}
