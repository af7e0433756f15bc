//! Scenes as motions: stepped from event to event, written down at regular times.

use std::ops::{ControlFlow, Range};

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Evaluator, Model, Real};

use crate::effects::{Effect, Effects};
use crate::integrate::{Adaptive, DOP853, IntegrationError, State, System, Tangent};
use crate::motion::{Conserved, Driven, Momentum, Motion, Zero};
use crate::scene::{Case, Force, Scene};

/// A motion at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Time, s.
    pub time: f64,
    /// Pose g₁ of the base in the world.
    pub pose: Pose<f64>,
    /// Shape (rad, m).
    pub q: Vec<f64>,
    /// Shape velocity (rad/s, m/s).
    pub qd: Vec<f64>,
    /// Locked velocity, base frame (rad/s, m/s).
    pub mu: Twist<f64>,
    /// Kinetic energy, J.
    pub kinetic_energy: f64,
    /// Work that all forces did since the start, J.
    pub work: f64,
    /// Momentum about the world's origin (kg·m²/s, kg·m/s).
    pub momentum: Wrench<f64>,
    /// Joint torques (N·m, N); at a jump those before it.
    pub tau: Vec<f64>,
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// The whole duration was computed.
    Whole,
    /// The caller stopped it.
    Stopped,
    /// The motion could not be continued.
    Failed(IntegrationError),
}

/// What a run leaves; all that was computed, however it ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// In the order of time; the first at 0, the last where the run ended.
    pub samples: Vec<Sample>,
    /// How it ended.
    pub end: End,
    /// Steps made.
    pub steps: usize,
    /// How often the right-hand side was evaluated to make them.
    pub evaluations: usize,
}

/// Computes a scene; `each` is told the time after each step and may stop the run.
///
/// ```
/// use std::ops::ControlFlow;
/// use frs_core::Model;
/// use frs_sim::{run::run, scene::Scene};
///
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// let text = "robot = 'lwr_satellite.urdf'\nduration = 1\n[start]\nqd = { joint_2 = 0.5 }\nmomentum = [0.1, 0, 0, 0, 0, 0]";
/// let scene = Scene::parse("example.toml", text, &model)?;
/// let record = run(&scene, &model, |_| ControlFlow::Continue(()));
/// let [first, .., last] = record.samples.as_slice() else { panic!("two samples at least") };
/// assert!((last.kinetic_energy - first.kinetic_energy).abs() < 1e-9); // nothing does work
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run(scene: &Scene, model: &Model, each: impl FnMut(f64) -> ControlFlow<()>) -> Record {
    let (robot, effects) = (Evaluator::new(model), scene.effects(model));
    match scene.case() {
        Case::Zero => Run::new(scene, Motion::new(robot, Zero, effects)).computed(each),
        Case::Driven => Run::new(scene, Motion::new(robot, Driven, effects)).computed(each),
        Case::Conserved => {
            let momentum = scene.start.momentum;
            Run::new(scene, Motion::new(robot, Conserved { momentum }, effects)).computed(each)
        }
    }
}

/// A motion with one more number: the work that the forces did.
///
/// `dW/dt = ⟨F₁, V₁⟩ + ⟨τ, q̇⟩ + ⟨p, γ⟩` with the linear momentum p, the last only where a scene has gravity.
struct Metered<'m, M> {
    motion: Motion<Evaluator<'m>, M, Effects<'m>>,
    weighs: bool,
    n: usize,
    state: State,
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
        self.state.pose = state.pose;
        self.state.flat.copy_from_slice(&state.flat[..own]);
        self.motion.rate(time, &self.state, &mut self.rate);
        let load = self.motion.last_load();
        let mut power = self.rate.twist.dot(load.base_wrench);
        power += load.tau.iter().zip(&state.flat[self.n..2 * self.n]).map(|(tau, qd)| tau * qd).sum::<f64>();
        if self.weighs {
            let fall = state.pose.rotation * nalgebra::Vector3::from(load.gravity);
            power += fall.dot(&self.motion.spatial_momentum(&self.state).force);
        }
        rate.twist = self.rate.twist;
        rate.flat[..own].copy_from_slice(&self.rate.flat);
        rate.flat[own] = power;
    }
}

/// A run on its way.
struct Run<'s, 'm, M> {
    scene: &'s Scene,
    system: Metered<'m, M>,
    flight: Adaptive,
    tangent: Tangent,
    samples: Vec<Sample>,
    steps: usize,
}

impl<'s, 'm, M: Momentum<f64>> Run<'s, 'm, M> {
    fn new(scene: &'s Scene, motion: Motion<Evaluator<'m>, M, Effects<'m>>) -> Self {
        let start = &scene.start;
        let state = motion.state(start.pose, &start.q, &start.qd, start.mu);
        let weighs = scene.forces.iter().any(|named| matches!(named.force, Force::Gravity(_)));
        let rate = Tangent::zero(state.flat.len());
        let system = Metered { motion, weighs, n: start.q.len(), state: state.clone(), rate };
        let mut metered = state;
        metered.flat.push(0.0);
        let tangent = Tangent::zero(metered.flat.len());
        let flight = Adaptive::new(&DOP853, metered, 0.0, scene.accuracy);
        Self { scene, system, flight, tangent, samples: Vec::new(), steps: 0 }
    }

    fn computed(mut self, mut each: impl FnMut(f64) -> ControlFlow<()>) -> Record {
        let end = self.fly(&mut each);
        // Where a run ends is written down, between samples or not.
        if self.samples.last().is_none_or(|last| last.time < self.flight.time()) {
            let state = self.flight.state().clone();
            self.sample(self.flight.time(), &state);
        }
        Record { samples: self.samples, end, steps: self.steps, evaluations: self.flight.evaluations() }
    }

    fn fly(&mut self, each: &mut impl FnMut(f64) -> ControlFlow<()>) -> End {
        let duration = self.scene.duration;
        let mut limits = self.system.motion.loads_mut().events();
        limits.retain(|time| (0.0..duration).contains(time) && *time > 0.0);
        limits.push(duration);
        limits.sort_by(f64::total_cmp);
        let mut between = self.flight.state().clone();
        for limit in limits {
            self.system.motion.loads_mut().enter(self.flight.time());
            // The same state, but other forces.
            self.flight.event();
            if self.samples.is_empty() {
                self.sample(0.0, &between);
            }
            while self.flight.time() < limit {
                if let Err(error) = self.flight.advance(&mut self.system, limit) {
                    return End::Failed(error);
                }
                self.steps += 1;
                while self.next_sample() <= self.flight.time() {
                    let time = self.next_sample();
                    self.flight.at(&mut self.system, time, &mut between);
                    self.sample(time, &between);
                }
                if each(self.flight.time()).is_break() {
                    return End::Stopped;
                }
            }
        }
        End::Whole
    }

    fn next_sample(&self) -> f64 {
        self.samples.len() as f64 / self.scene.samples_per_second
    }

    fn sample(&mut self, time: f64, state: &State) {
        let Metered { motion, n, state: own, .. } = &mut self.system;
        let n = *n;
        own.pose = state.pose;
        own.flat.copy_from_slice(&state.flat[..motion.dimension()]);
        let (mu, kinetic_energy) = (motion.locked_velocity(own), motion.kinetic_energy(own));
        let momentum = motion.spatial_momentum(own);
        self.system.rate(time, state, &mut self.tangent);
        self.samples.push(Sample {
            time,
            pose: state.pose,
            q: state.flat[..n].to_vec(),
            qd: state.flat[n..2 * n].to_vec(),
            mu,
            kinetic_energy,
            work: state.flat[state.flat.len() - 1],
            momentum,
            tau: self.system.motion.last_load().tau.clone(),
        });
    }
}

/// A right-hand side over the scalar `T`: time, state, and where the tangent goes.
pub type Rate<'m, T> = Box<dyn FnMut(T, &State<T>, &mut Tangent<T>) + 'm>;

/// The right-hand side of a scene over any scalar, with the forces that act from `time` (s) on; for instance to count its
/// operations.
pub fn rate<'m, T: Real>(scene: &Scene, model: &'m Model<T>, time: f64) -> Rate<'m, T> {
    fn boxed<'m, T: Real, M: Momentum<T> + 'm>(
        mut motion: Motion<Evaluator<'m, T>, M, Effects<'m, T>, T>,
    ) -> Rate<'m, T> {
        Box::new(move |time, state, rate| motion.rate(time, state, rate))
    }
    let (robot, mut effects) = (Evaluator::new(model), scene.effects(model));
    effects.enter(time);
    match scene.case() {
        Case::Zero => boxed(Motion::new(robot, Zero, effects)),
        Case::Driven => boxed(Motion::new(robot, Driven, effects)),
        Case::Conserved => {
            let momentum = Wrench::from_array(scene.start.momentum.to_array().map(T::from_f64));
            boxed(Motion::new(robot, Conserved { momentum }, effects))
        }
    }
}
