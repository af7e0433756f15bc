//! A run on its way: from event to event, from sample to sample.

use std::ops::ControlFlow;

use frs_core::Model;
use nalgebra::Vector3;

use super::handover::Changed;
use super::metered::Metered;
use super::{End, Record, Sample};
use crate::effects::Effects;
use crate::integrate::{Adaptive, DOP853, State, System, Tangent};
use crate::motion::{Momentum, Motion};
use crate::scene::{Case, Scene, Start};

/// A run on its way.
pub struct Flight<'s, 'm, M> {
    scene: &'s Scene,
    /// The robot at the start, and from each handover on.
    models: &'m [Model],
    /// Which of them flies.
    phase: usize,
    fall: FreeFall,
    system: Metered<'m, M>,
    path: Adaptive,
    tangent: Tangent,
    touching: Touching,
    samples: Vec<Sample>,
    steps: usize,
}

/// What is touched, gap by gap.
#[derive(Default)]
struct Touching {
    closed: Vec<bool>,
    gaps: Vec<f64>,
    owners: Vec<[usize; 2]>,
}

/// Parts of a step that are searched for gaps that pass 0 twice within it.
const PARTS: u32 = 8;

/// Halvings of such a part until its ends are neighbours.
const HALVINGS: u32 = 48;

impl<'s, 'm, M: Momentum<f64>> Flight<'s, 'm, M> {
    pub fn new(scene: &'s Scene, models: &'m [Model], momentum: M, effects: Effects<'m>) -> Self {
        let start = &scene.start;
        let mut motion = Motion::new(&models[0], momentum, effects);
        if let Some(drives) = scene.drives() {
            motion = motion.with_drives(drives);
        }
        let state = motion.state(start.pose, &start.q, &start.qd, start.mu);
        let weighs = scene.case() == Case::Driven && scene.gravity() != Vector3::zeros();
        let system = Metered::new(motion, state.clone(), weighs);
        let mut metered = state;
        metered.flat.push(0.0);
        let tangent = Tangent::zero(metered.flat.len());
        let path = Adaptive::new(&DOP853, metered, 0.0, scene.accuracy);
        let Start { com, centroidal, mass, .. } = *start;
        let fall = FreeFall { since: 0.0, com, momentum: centroidal.force, mass, work: 0.0 };
        Self {
            scene,
            models,
            phase: 0,
            fall,
            system,
            path,
            tangent,
            touching: Touching::default(),
            samples: Vec::new(),
            steps: 0,
        }
    }

    pub fn computed(mut self, mut each: impl FnMut(f64) -> ControlFlow<()>) -> Record {
        let end = self.fly(&mut each);
        // Where a run ends is written down, between samples or not.
        if self.samples.last().is_none_or(|last| last.time < self.path.time()) {
            let state = self.path.state().clone();
            self.sample(self.path.time(), &state);
        }
        Record { samples: self.samples, end, steps: self.steps, evaluations: self.path.evaluations() }
    }

    fn fly(&mut self, each: &mut impl FnMut(f64) -> ControlFlow<()>) -> End {
        let duration = self.scene.duration;
        let mut limits: Vec<f64> = self.scene.forces.iter().flat_map(|named| named.force.knots()).collect();
        limits.retain(|time| (0.0..duration).contains(time) && *time > 0.0);
        limits.push(duration);
        limits.sort_by(f64::total_cmp);
        let mut between = self.path.state().clone();
        let handovers = self.scene.handovers();
        for limit in limits {
            while handovers.get(self.phase).is_some_and(|time| *time <= self.path.time()) {
                self.hand_over();
            }
            self.enter();
            if self.samples.is_empty() {
                self.meet(&between);
                self.sample(0.0, &between);
            }
            while self.path.time() < limit {
                if let Err(error) = self.path.advance(&mut self.system, limit) {
                    return End::Failed(error);
                }
                self.steps += 1;
                let met = self.cut_where_something_is_met(&mut between);
                while self.next_sample() <= self.path.time() {
                    let time = self.next_sample();
                    self.path.at(&mut self.system, time, &mut between);
                    self.sample(time, &between);
                }
                if let Some(gap) = met {
                    let closed = !self.touching.closed[gap];
                    self.touching.closed[gap] = closed;
                    self.system.motion.loads_mut().touch(self.touching.owners[gap], closed);
                    self.path.event();
                }
                if each(self.path.time()).is_break() {
                    return End::Stopped;
                }
            }
        }
        End::Whole
    }

    /// The forces from now on; the same state has another rate.
    fn enter(&mut self) {
        let time = self.path.time();
        self.system.motion.loads_mut().enter(time);
        if let Some(drives) = self.system.motion.drives_mut() {
            drives.enter(time);
        }
        self.path.event();
    }

    /// Goes on with the next of the models.
    fn hand_over(&mut self) {
        self.phase += 1;
        let (time, mut state) = (self.path.time(), self.path.state().clone());
        let com = self.system.com(time, &state);
        if let Some(place) = self.fall_at(time) {
            state.pose.translation = place - state.pose.rotation * com;
        }
        let work = self.gravity_work(time);
        let changed = self.system.hand_over(&self.models[self.phase], self.scene.payloads(), time, &mut state);
        let Changed { momentum, com, mass } = changed;
        self.fall = FreeFall { since: time, com, momentum: momentum.force, mass, work };
        *self.path.event() = state;
    }

    /// Finds out what is touched at the start.
    fn meet(&mut self, state: &State) {
        let Touching { closed, gaps, owners } = &mut self.touching;
        self.system.gaps(0.0, state, gaps, owners);
        *closed = gaps.iter().map(|gap| *gap < 0.0).collect();
        for (owner, closed) in owners.iter().zip(closed) {
            self.system.motion.loads_mut().touch(*owner, *closed);
        }
    }

    /// Shortens the last step to where the first gap closes or opens, and tells which.
    fn cut_where_something_is_met(&mut self, between: &mut State) -> Option<usize> {
        if self.touching.closed.is_empty() {
            return None;
        }
        let (from, to) = (self.path.last_start(), self.path.time());
        let (mut before, mut after) = (from, None);
        for part in 1..=PARTS {
            let time = if part == PARTS { to } else { from + (to - from) * f64::from(part) / f64::from(PARTS) };
            if self.changed(time, between).is_some() {
                after = Some(time);
                break;
            }
            before = time;
        }
        let mut after = after?;
        for _ in 0..HALVINGS {
            let time = 0.5 * (before + after);
            if time <= before || time >= after {
                break;
            }
            if self.changed(time, between).is_some() { after = time } else { before = time }
        }
        let gap = self.changed(after, between);
        self.path.cut(&mut self.system, after);
        gap
    }

    /// The first gap that is open and was closed at `time` of the last step, or the other way round.
    fn changed(&mut self, time: f64, between: &mut State) -> Option<usize> {
        self.path.at(&mut self.system, time, between);
        let Touching { closed, gaps, owners } = &mut self.touching;
        self.system.gaps(time, between, gaps, owners);
        gaps.iter().zip(closed).position(|(gap, closed)| (*gap < 0.0) != *closed)
    }

    fn next_sample(&self) -> f64 {
        self.samples.len() as f64 / self.scene.samples_per_second
    }

    fn sample(&mut self, time: f64, state: &State) {
        let (falling, gravity_work) = (self.fall_at(time), self.gravity_work(time));
        self.system.rate(time, state, &mut self.tangent);
        let Metered { motion, state: own, .. } = &mut self.system;
        let tau = motion.last_load().tau.clone();
        let (q, qd) = motion.shape(time, own);
        let (q, qd) = (q.to_vec(), qd.to_vec());
        let mu = motion.locked_velocity(time, own);
        let place = motion.ask(time, own, |robot, _| robot.com());
        let mut com = own.pose.transform(place);
        if let Some(falling) = falling {
            // Known better than by integration.
            own.pose.translation = falling - own.pose.rotation * place;
            com = falling;
        }
        let work = state.flat[state.flat.len() - 1] + gravity_work;
        let (kinetic_energy, momentum) = (motion.kinetic_energy(time, own), motion.spatial_momentum(time, own));
        self.samples.push(Sample { time, pose: own.pose, q, qd, mu, kinetic_energy, com, work, momentum, tau });
    }

    /// Where the centre of mass is unless the momentum is driven.
    fn fall_at(&self, time: f64) -> Option<Vector3<f64>> {
        (self.scene.case() != Case::Driven).then(|| self.fall.com + self.fall.way(time, self.acceleration()))
    }

    /// What gravity did that the motion does not measure itself, J.
    fn gravity_work(&self, time: f64) -> f64 {
        let acceleration = self.acceleration();
        self.fall.work + acceleration.dot(&self.fall.way(time, acceleration)) * self.fall.mass
    }

    /// Acceleration of a centre of mass that is not integrated.
    fn acceleration(&self) -> Vector3<f64> {
        if self.scene.case() == Case::Ballistic { self.scene.gravity() } else { Vector3::zeros() }
    }
}

/// A centre of mass on its way in free fall.
struct FreeFall {
    /// When it began, s.
    since: f64,
    /// Where it was then, m, world.
    com: Vector3<f64>,
    /// Its momentum then, kg·m/s.
    momentum: Vector3<f64>,
    /// kg.
    mass: f64,
    /// What gravity did until then, J.
    work: f64,
}

impl FreeFall {
    /// How far it is at `time`, m.
    fn way(&self, time: f64, acceleration: Vector3<f64>) -> Vector3<f64> {
        let t = time - self.since;
        self.momentum * (t / self.mass) + acceleration * (0.5 * t * t)
    }
}
