//! What the forces do, measured on the way.

use std::ops::Range;

use nalgebra::Vector3;

use crate::effects::Effects;
use crate::integrate::{State, System, Tangent};
use crate::motion::{Instant, Momentum, Motion};

/// A motion with one more number: the work that the forces did, but for gravity where it only moves the centre of mass.
///
/// `dW/dt = ⟨F₁, V₁⟩ + ⟨τ, q̇⟩ + ⟨p, γ⟩` with the linear momentum p, the last only where gravity is one of the effects.
pub struct Metered<'m, M> {
    pub motion: Motion<'m, M, Effects<'m>>,
    weighs: bool,
    /// What the motion knows of the state that was asked for last.
    pub state: State,
    rate: Tangent,
}

impl<M: Momentum<f64>> System for Metered<'_, M> {
    fn dimension(&self) -> usize {
        self.motion.dimension() + 1
    }

    fn velocities(&self) -> Range<usize> {
        self.motion.velocities()
    }

    fn rate(&mut self, time: f64, state: &State, rate: &mut Tangent) {
        let own = self.motion.dimension();
        self.set(state);
        self.motion.rate(time, &self.state, &mut self.rate);
        let load = self.motion.last_load();
        let mut power = self.rate.twist.dot(load.base_wrench);
        power += load.tau.iter().zip(&self.rate.flat).map(|(tau, qd)| tau * qd).sum::<f64>();
        if self.weighs {
            let fall = state.pose.rotation * Vector3::from(load.gravity);
            power += fall.dot(&self.motion.spatial_momentum(time, &self.state).force);
        }
        rate.twist = self.rate.twist;
        rate.flat[..own].copy_from_slice(&self.rate.flat);
        rate.flat[own] = power;
    }
}

impl<'m, M: Momentum<f64>> Metered<'m, M> {
    /// A motion from a state of its own; `weighs` if gravity is one of its effects.
    pub fn new(motion: Motion<'m, M, Effects<'m>>, state: State, weighs: bool) -> Self {
        let rate = Tangent::zero(state.flat.len());
        Self { motion, weighs, state, rate }
    }

    /// Takes what the motion knows of a state.
    pub fn set(&mut self, state: &State) {
        let own = self.motion.dimension();
        self.state.pose = state.pose;
        self.state.flat.copy_from_slice(&state.flat[..own]);
    }

    /// The centre of mass in a state, base frame.
    pub fn com(&mut self, time: f64, state: &State) -> Vector3<f64> {
        self.set(state);
        self.motion.ask(time, &self.state, |robot, _| robot.com())
    }

    /// Distances from what can be touched in a state, and whose they are.
    pub fn gaps(&mut self, time: f64, state: &State, gaps: &mut Vec<f64>, owners: &mut Vec<[usize; 2]>) {
        self.set(state);
        let (q, qd) = self.motion.shape(time, &self.state);
        let (q, qd, pose) = (q.to_vec(), qd.to_vec(), state.pose);
        let effects = std::mem::take(self.motion.loads_mut());
        self.motion.ask(time, &self.state, |robot, mu| {
            effects.gaps(&Instant { time, pose: &pose, q: &q, qd: &qd, mu }, robot, gaps, owners);
        });
        *self.motion.loads_mut() = effects;
    }
}
