//! An observer that goes along with a run.
//!
//! It is integrated by itself, with steps and an error control of its own, on states interpolated within the steps of the motion: the motion does
//! not notice it.

use std::ops::Range;

use frs_core::spatial::Pose;
use nalgebra::Vector3;

use super::metered::Metered;
use crate::integrate::{Adaptive, DOP853, Pace, Path, State, System, Tangent};
use crate::motion::Momentum;
use crate::observer::{Observation, Observer, Outside};
use crate::scene::Scene;

/// An observer on its way.
pub struct Watch {
    observer: Observer,
    gravity: Vector3<f64>,
    path: Adaptive,
}

/// The observer's equations along the last step of a motion.
struct Along<'a, 'm, M> {
    observer: Observer,
    gravity: Vector3<f64>,
    motion: &'a mut Path,
    system: &'a mut Metered<'m, M>,
    between: State,
}

impl Watch {
    /// From the scene's guess on, at time 0.
    pub fn new(scene: &Scene, observer: Observer, pose: &Pose<f64>, com: Vector3<f64>) -> Self {
        let state = observer.state(pose, com, observer.guess);
        Self { observer, gravity: scene.gravity(), path: Adaptive::new(&DOP853, state, 0.0, scene.solver.accuracy()) }
    }

    /// Goes on from where a run was stopped, at `time` (s).
    pub fn resume(&mut self, scene: &Scene, time: f64, (state, pace): (State, Pace)) {
        self.path = Adaptive::new(&DOP853, state, time, scene.solver.accuracy());
        self.path.set_pace(Pace { smooth: false, ..pace });
    }

    /// Where it can go on.
    pub fn checkpoint(&self) -> (State, Pace) {
        (self.path.state().clone(), self.path.pace())
    }

    /// Observes until `time` (s) within the last step of the motion. If it cannot, its estimate is no number from then on.
    pub fn follow<M: Momentum<f64>>(&mut self, motion: &mut Path, system: &mut Metered<'_, M>, time: f64) {
        let at_end = time == motion.time();
        let between = motion.state().clone();
        let mut along = Along { observer: self.observer, gravity: self.gravity, motion, system, between };
        while self.path.time() < time {
            if self.path.advance(&mut along, time).is_err() {
                self.path = Adaptive::new(&DOP853, self.path.state().clone(), time, 1.0);
                self.path.event().flat.fill(f64::NAN);
            }
        }
        if at_end {
            // The next step has rates of its own, if only by their last bits.
            self.path.event();
        }
    }

    /// The robot is another one: the estimate stays, and does not lag.
    pub fn hand_over(&mut self, before: (&Pose<f64>, Vector3<f64>), after: (&Pose<f64>, Vector3<f64>)) {
        let estimate = self.observer.estimate(before.0, before.1, self.path.state());
        *self.path.event() = self.observer.state(after.0, after.1, estimate);
    }

    /// What it is wrong by in a state of the motion, at the time up to which it has followed.
    pub fn observation<M: Momentum<f64>>(&self, system: &mut Metered<'_, M>, state: &State) -> Observation {
        let (observer, own, time) = (self.observer, self.path.state(), self.path.time());
        system.set(state);
        system.motion.ask(time, &system.state, |robot, mu| {
            let error = observer.estimate(&state.pose, robot.com(), own) - mu;
            Observation { error, lyapunov: 0.5 * error.dot(robot.body_momentum(error)) }
        })
    }
}

impl<M: Momentum<f64>> System for Along<'_, '_, M> {
    fn dimension(&self) -> usize {
        6
    }

    fn velocities(&self) -> Range<usize> {
        0..6
    }

    fn rate(&mut self, time: f64, state: &State, rate: &mut Tangent) {
        let Self { observer, gravity, motion, system, between } = self;
        motion.at(*system, time, between);
        let base_wrench = system.load(time, between).base_wrench;
        let outside = Outside { base_wrench, gravity: *gravity };
        let pose = between.pose;
        system.motion.ask(time, &system.state, |robot, _| observer.rate(&pose, robot, outside, state, rate));
    }
}
