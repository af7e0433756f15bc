//! What the forces do, measured on the way.

use std::ops::Range;

use nalgebra::Vector3;

use super::meter::Meter;
use crate::integrate::{State, System, Tangent};
use crate::motion::{Instant, Load, Momentum, Motion};

/// A motion with more numbers: the work of each force of the scene, and last what payloads brought, J.
pub struct Metered<'m, M> {
    pub motion: Motion<'m, M, Meter<'m>>,
    /// What the motion knows of the state that was asked for last.
    pub state: State,
    rate: Tangent,
}

impl<M: Momentum<f64>> System for Metered<'_, M> {
    fn dimension(&self) -> usize {
        self.motion.dimension() + self.measured()
    }

    fn velocities(&self) -> Range<usize> {
        self.motion.velocities()
    }

    fn measured(&self) -> usize {
        self.motion.loads().len() + 1
    }

    fn rate(&mut self, time: f64, state: &State, rate: &mut Tangent) {
        let own = self.motion.dimension();
        self.set(state);
        self.motion.rate(time, &self.state, &mut self.rate);
        rate.twist = self.rate.twist;
        let (moving, measured) = rate.flat.split_at_mut(own);
        moving.copy_from_slice(&self.rate.flat);
        let [powers @ .., brought] = measured else { unreachable!("what payloads brought is always measured") };
        // The first rates are q̇.
        self.motion.loads().powers(&self.motion.last_load().tau, moving, powers);
        *brought = 0.0;
    }
}

impl<'m, M: Momentum<f64>> Metered<'m, M> {
    /// A motion from a state of its own.
    pub fn new(motion: Motion<'m, M, Meter<'m>>, state: State) -> Self {
        let rate = Tangent::zero(state.flat.len());
        Self { motion, state, rate }
    }

    /// Takes what the motion knows of a state.
    pub fn set(&mut self, state: &State) {
        let own = self.motion.dimension();
        self.state.pose = state.pose;
        self.state.flat.copy_from_slice(&state.flat[..own]);
    }

    /// The forces in a state.
    pub fn load(&mut self, time: f64, state: &State) -> &Load {
        self.set(state);
        self.motion.rate(time, &self.state, &mut self.rate);
        self.motion.last_load()
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
        let effects = std::mem::take(&mut self.motion.loads_mut().effects);
        self.motion.ask(time, &self.state, |robot, mu| {
            effects.gaps(&Instant { time, pose: &pose, q: &q, qd: &qd, mu }, robot, gaps, owners);
        });
        self.motion.loads_mut().effects = effects;
    }
}
