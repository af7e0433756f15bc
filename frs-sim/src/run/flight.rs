//! A run on its way: from event to event, from sample to sample.

use std::ops::ControlFlow;

use frs_core::Model;
use nalgebra::Vector3;

use super::fall::FreeFall;
use super::handover::Changed;
use super::meter::Meter;
use super::metered::Metered;
use super::watch::Watch;
use super::{Acting, Checkpoint, Coder, End, Record, Sample, motion};
use crate::integrate::{Path, State, System};
use crate::motion::Momentum;
use crate::scene::{Scene, Work};

/// A run on its way.
pub struct Flight<'s, 'm, M> {
    scene: &'s Scene,
    /// What is measured of it.
    works: Vec<Work>,
    /// The robot at the start, and from each handover on.
    models: &'m [Model],
    /// Which of them flies.
    phase: usize,
    fall: FreeFall,
    coder: Option<Coder<'s>>,
    /// When it was last said what acts, s.
    entered: f64,
    system: Metered<'m, M>,
    path: Path,
    touching: Touching,
    watch: Option<Watch>,
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

/// Evaluations by the core that take about as long as making code: a recording, and its translation, cost each operation some ten
/// thousand times what performing it costs.
const AS_LONG_AS_CODING: u32 = 10_000;

/// Parts of a step that are searched for gaps that pass 0 twice within it.
const PARTS: u32 = 8;

/// Halvings of such a part until its ends are neighbours.
const HALVINGS: u32 = 48;

impl<'s, 'm, M: Momentum<f64>> Flight<'s, 'm, M> {
    pub fn new(scene: &'s Scene, models: &'m [Model], momentum: M, coder: Option<Coder<'s>>) -> Self {
        let start = &scene.start;
        let mut motion = motion(scene, &models[0], momentum, Meter::new(scene, scene.effects(&models[0])), 0.0);
        let state = motion.state(start.pose, &start.q, &start.qd, start.mu);
        let mut system = Metered::new(motion, state.clone());
        let mut metered = state;
        metered.flat.resize(system.dimension(), 0.0);
        let com = system.com(0.0, &metered);
        let watch = scene.observer.map(|observer| Watch::new(scene, observer, &start.pose, com));
        let path = Path::new(scene.solver.method, scene.solver.steps, metered, 0.0);
        Self {
            scene,
            works: scene.works(),
            models,
            phase: 0,
            fall: FreeFall::of(start),
            coder,
            entered: 0.0,
            system,
            path,
            touching: Touching::default(),
            watch,
            samples: Vec::new(),
            steps: 0,
        }
    }

    /// Goes on where a run was stopped.
    pub fn resumed(mut self, record: Record) -> Self {
        let Checkpoint { time, state, pace, closed, phase, fall, observer } = record.checkpoint;
        (self.samples, self.steps, self.phase, self.fall) = (record.samples, record.steps, phase, fall);
        // Where the run was stopped is none of the regular times, but by chance.
        if self.samples.last().is_some_and(|last| last.time != self.sample_time(self.samples.len() - 1)) {
            self.samples.pop();
        }
        if phase > 0 {
            self.system.motion.change(&self.models[phase], fall.since, fall.momentum, fall.mass);
        }
        self.choose_pieces(time);
        self.touch(time, &state, |gap, _| closed[gap]);
        self.path = Path::new(self.scene.solver.method, self.scene.solver.steps, state, time);
        self.path.resume(&mut self.system, pace);
        if let (Some(watch), Some(observer)) = (&mut self.watch, observer) {
            watch.resume(self.scene, time, observer);
        }
        self
    }

    pub fn computed(mut self, mut each: impl FnMut(f64) -> ControlFlow<()>) -> Record {
        let end = self.fly(&mut each);
        let (time, state) = (self.path.time(), self.path.state().clone());
        // Where a run ends is written down, between samples or not.
        if self.samples.last().is_none_or(|last| last.time < time) {
            self.sample(time, &state);
        }
        let (pace, closed) = (self.path.pace(), self.touching.closed);
        let checkpoint = Checkpoint {
            time,
            state,
            pace,
            closed,
            phase: self.phase,
            fall: self.fall,
            observer: self.watch.as_ref().map(Watch::checkpoint),
        };
        Record { samples: self.samples, end, steps: self.steps, checkpoint }
    }

    fn fly(&mut self, each: &mut impl FnMut(f64) -> ControlFlow<()>) -> End {
        let duration = self.scene.duration;
        let mut events: Vec<f64> = self.scene.forces.iter().flat_map(|named| named.force.knots()).collect();
        events.retain(|time| *time > 0.0 && *time < duration);
        events.sort_by(f64::total_cmp);
        let mut between = self.path.state().clone();
        while self.path.time() < duration {
            let time = self.path.time();
            if time == 0.0 || events.contains(&time) {
                self.enter(time);
            }
            if self.samples.is_empty() {
                self.touch(time, &between, |_, distance| distance < 0.0);
                self.sample(time, &between);
            }
            let limit = events.iter().copied().find(|event| *event > time).unwrap_or(duration);
            if let Err(error) = self.path.advance(&mut self.system, limit) {
                return End::Failed(error);
            }
            self.steps += 1;
            let met = self.cut_where_something_is_met(&mut between);
            while self.sample_time(self.samples.len()) <= self.path.time() {
                let time = self.sample_time(self.samples.len());
                self.path.at(&mut self.system, time, &mut between);
                self.observe(time);
                self.sample(time, &between);
            }
            self.observe(self.path.time());
            if let Some(gap) = met {
                let closed = !self.touching.closed[gap];
                self.touching.closed[gap] = closed;
                self.system.motion.loads_mut().effects.touch(self.touching.owners[gap], closed);
                self.system.evaluate_by(None);
                self.path.event();
            }
            if self.system.evaluations > AS_LONG_AS_CODING {
                self.code();
            }
            if each(self.path.time()).is_break() {
                return End::Stopped;
            }
        }
        End::Whole
    }

    /// The robot and the forces from now on; the same state has another rate.
    fn enter(&mut self, time: f64) {
        if self.scene.handovers().get(self.phase) == Some(&time) {
            self.hand_over();
        }
        self.choose_pieces(time);
        self.path.event();
    }

    /// Lets code go on with what acts now.
    fn code(&mut self) {
        let Touching { closed, owners, .. } = &self.touching;
        let acting = Acting {
            scene: self.scene,
            model: &self.models[self.phase],
            time: self.entered,
            fall: self.fall,
            closed: owners.iter().copied().zip(closed.iter().copied()).collect(),
            numbers: self.path.state().flat.len(),
        };
        self.system.evaluate_by(self.coder.and_then(|coder| coder(&acting)));
    }

    fn choose_pieces(&mut self, time: f64) {
        self.entered = time;
        self.system.evaluate_by(None);
        self.system.motion.loads_mut().effects.enter(time);
        if let Some(drives) = self.system.motion.drives_mut() {
            drives.enter(time);
        }
    }

    /// Goes on with the next of the models.
    fn hand_over(&mut self) {
        self.phase += 1;
        let (time, mut state) = (self.path.time(), self.path.state().clone());
        let com = self.system.com(time, &state);
        if let Some(place) = self.fall_at(time) {
            state.pose.translation = place - state.pose.rotation * com;
        }
        let before = state.pose;
        let changed = self.system.hand_over(
            &self.models[self.phase],
            self.scene.payloads(),
            self.scene.still_water(),
            time,
            &mut state,
        );
        if let Some(watch) = &mut self.watch {
            watch.hand_over((&before, com), (&state.pose, self.system.com(time, &state)));
        }
        let Changed { momentum, com, mass } = changed;
        self.fall = FreeFall { since: time, com, momentum, mass };
        *self.path.event() = state;
    }

    /// Tells the forces which gaps are closed, by their numbers and the distances in a state.
    fn touch(&mut self, time: f64, state: &State, is_closed: impl Fn(usize, f64) -> bool) {
        let Touching { closed, gaps, owners } = &mut self.touching;
        self.system.gaps(time, state, gaps, owners);
        *closed = gaps.iter().enumerate().map(|(gap, distance)| is_closed(gap, *distance)).collect();
        for (owner, closed) in owners.iter().zip(closed) {
            self.system.motion.loads_mut().effects.touch(*owner, *closed);
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

    /// The observer follows to a time (s) within the last step.
    fn observe(&mut self, time: f64) {
        if let Some(watch) = &mut self.watch {
            watch.follow(&mut self.path, &mut self.system, time);
        }
    }

    /// The time of a regular sample, s.
    fn sample_time(&self, number: usize) -> f64 {
        number as f64 / self.scene.samples_per_second
    }

    fn sample(&mut self, time: f64, state: &State) {
        let falling = self.fall_at(time);
        let observation = self.watch.as_ref().map(|watch| watch.observation(&mut self.system, state));
        let tau = self.system.load(time, state).tau.clone();
        let Metered { motion, state: own, .. } = &mut self.system;
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
        let measured = &state.flat[motion.dimension()..];
        let works = self.works.iter().map(|work| measured[work.number]).collect();
        let (kinetic_energy, momentum) = (motion.kinetic_energy(time, own), motion.spatial_momentum(time, own));
        self.samples.push(Sample {
            time,
            pose: own.pose,
            q,
            qd,
            mu,
            kinetic_energy,
            com,
            works,
            momentum,
            tau,
            observation,
        });
    }

    /// Where the centre of mass is unless the momentum is driven.
    fn fall_at(&self, time: f64) -> Option<Vector3<f64>> {
        (!self.scene.case().is_integrated()).then(|| self.fall.com + self.fall.way(time, self.scene.gravity()))
    }
}
