//! A run on its way: from event to event, from sample to sample.

use std::ops::ControlFlow;

use frs_core::Model;
use nalgebra::Vector3;

use super::metered::Metered;
use super::{End, Record, Sample};
use crate::effects::Effects;
use crate::integrate::{Adaptive, DOP853, State, System, Tangent};
use crate::motion::{Momentum, Motion};
use crate::scene::{Case, Scene, Start};

/// A run on its way.
pub struct Flight<'s, 'm, M> {
    scene: &'s Scene,
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
    pub fn new(scene: &'s Scene, model: &'m Model, momentum: M, effects: Effects<'m>) -> Self {
        let start = &scene.start;
        let mut motion = Motion::new(model, momentum, effects);
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
        Self { scene, system, path, tangent, touching: Touching::default(), samples: Vec::new(), steps: 0 }
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
        for limit in limits {
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
        let free_fall = self.free_fall(time);
        self.system.rate(time, state, &mut self.tangent);
        let Metered { motion, state: own, .. } = &mut self.system;
        let tau = motion.last_load().tau.clone();
        let (q, qd) = motion.shape(time, own);
        let (q, qd) = (q.to_vec(), qd.to_vec());
        let (mu, com) = motion.ask(time, own, |robot, mu| (mu, robot.com()));
        let mut work = state.flat[state.flat.len() - 1];
        if let Some(free) = free_fall {
            // Known better than by integration: where the centre of mass is, and what gravity did to it.
            own.pose.translation = free.com - own.pose.rotation * com;
            work += free.work;
        }
        let (kinetic_energy, momentum) = (motion.kinetic_energy(time, own), motion.spatial_momentum(time, own));
        self.samples.push(Sample { time, pose: own.pose, q, qd, mu, kinetic_energy, work, momentum, tau });
    }

    /// What the centre of mass does unless the momentum is driven.
    fn free_fall(&self, time: f64) -> Option<FreeFall> {
        let Start { com, mass, centroidal, .. } = &self.scene.start;
        let fall = match self.scene.case() {
            Case::Driven => return None,
            Case::Ballistic => self.scene.gravity(),
            Case::Zero | Case::Conserved => Vector3::zeros(),
        };
        let way = centroidal.force * (time / mass) + fall * (0.5 * time * time);
        Some(FreeFall { com: com + way, work: fall.dot(&way) * mass })
    }
}

/// A centre of mass that falls freely.
struct FreeFall {
    /// Where it is, m, world.
    com: Vector3<f64>,
    /// What gravity did, J.
    work: f64,
}
