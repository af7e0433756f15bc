//! Scenes as motions: stepped from event to event, written down at regular times.

mod fall;
mod flight;
mod handover;
mod meter;
mod metered;
mod watch;

use std::ops::ControlFlow;

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Model, Real};
use nalgebra::Vector3;

use crate::effects::Effects;
use crate::integrate::{IntegrationError, Pace, State, System};
use crate::motion::{Ballistic, Conserved, Driven, Hamel, Momentum, Motion, Zero};

use crate::observer::Observation;
use crate::scene::{Case, Scene, Start};
use flight::Flight;

pub use fall::FreeFall;

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
    /// Centre of mass, world (m).
    pub com: Vector3<f64>,
    /// Work since the start of each of [`Scene::works`], in its order, J.
    pub works: Vec<f64>,
    /// Momentum about the world's origin (kg·m²/s, kg·m/s).
    pub momentum: Wrench<f64>,
    /// Joint torques (N·m, N); at a jump those before it.
    pub tau: Vec<f64>,
    /// What the observer is wrong by, if the scene has one.
    pub observation: Option<Observation>,
}

impl Sample {
    /// All work since the start, J: by so much the kinetic energy has changed.
    pub fn work(&self) -> f64 {
        self.works.iter().sum()
    }
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
    /// Where it can go on.
    pub checkpoint: Checkpoint,
}

/// Where a run goes on, with the bits that it would have had without a stop.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// Time, s.
    pub time: f64,
    /// Pose; q, q̇, μ where it is integrated, the work of each force of the scene, and what payloads brought.
    pub state: State,
    /// How the steps go on.
    pub pace: Pace,
    /// Which gaps are closed, in the order of the effects.
    pub closed: Vec<bool>,
    /// How many handovers of payloads were made.
    pub phase: usize,
    /// The centre of mass since the last of them.
    pub fall: FreeFall,
    /// The observer's state and pace, if the scene has one.
    pub observer: Option<(State, Pace)>,
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
    flown(scene, model, None, each)
}

/// Goes on with a run that was stopped: the record is then that of one run, bit for bit.
///
/// `scene` and `model` must be the same as before.
pub fn resume(scene: &Scene, model: &Model, record: Record, each: impl FnMut(f64) -> ControlFlow<()>) -> Record {
    flown(scene, model, Some(record), each)
}

fn flown(scene: &Scene, model: &Model, record: Option<Record>, each: impl FnMut(f64) -> ControlFlow<()>) -> Record {
    fn fly<'m, M: Momentum<f64>>(
        flight: Flight<'_, 'm, M>,
        record: Option<Record>,
        each: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Record {
        match record {
            None => flight.computed(each),
            Some(record) => flight.resumed(record).computed(each),
        }
    }
    let effects = scene.effects(model);
    let times = std::iter::once(0.0).chain(scene.handovers());
    let models: Vec<Model> = times.map(|time| scene.laden(model, time)).collect();
    let Start { centroidal: momentum, mass, .. } = scene.start;
    match scene.case() {
        Case::Zero => fly(Flight::new(scene, &models, Zero, effects), record, each),
        Case::Conserved => fly(Flight::new(scene, &models, Conserved { momentum }, effects), record, each),
        Case::Ballistic => {
            let ballistic = Ballistic { momentum, acceleration: scene.gravity(), mass, since: 0.0 };
            fly(Flight::new(scene, &models, ballistic, effects), record, each)
        }
        Case::Driven => fly(Flight::new(scene, &models, Driven, effects), record, each),
        Case::Hamel => fly(Flight::new(scene, &models, Hamel::new(model.dof()), effects), record, each),
    }
}

/// The equations of motion of a scene over the scalar `T`, whatever is known about its momentum.
pub trait Equations<T: Real>: System<T> {
    /// The state at the start of the scene.
    fn start(&mut self, start: &Start) -> State<T>;

    /// Shape q and its rate q̇ of a state, those on a course among them, in one list.
    fn shape(&mut self, time: T, state: &State<T>) -> Vec<T>;

    /// The momentum about the world's origin.
    fn momentum(&mut self, time: T, state: &State<T>) -> Wrench<T>;

    /// The kinetic energy, J.
    fn kinetic_energy(&mut self, time: T, state: &State<T>) -> T;
}

impl<T: Real, M: Momentum<T>> Equations<T> for Motion<'_, M, Effects<'_, T>, T> {
    fn start(&mut self, start: &Start) -> State<T> {
        let number = T::from_f64;
        let numbers = |numbers: &[f64]| numbers.iter().map(|x| number(*x)).collect::<Vec<_>>();
        let pose = Pose::new(start.pose.rotation.map(number), start.pose.translation.map(number)).orthonormalised();
        let mu = Twist::from_array(start.mu.to_array().map(number));
        self.state(pose, &numbers(&start.q), &numbers(&start.qd), mu)
    }

    fn shape(&mut self, time: T, state: &State<T>) -> Vec<T> {
        let (q, qd) = Motion::shape(self, time, state);
        [q, qd].concat()
    }

    fn momentum(&mut self, time: T, state: &State<T>) -> Wrench<T> {
        self.spatial_momentum(time, state)
    }

    fn kinetic_energy(&mut self, time: T, state: &State<T>) -> T {
        Motion::kinetic_energy(self, time, state)
    }
}

/// The equations of a scene over any scalar, with the forces that act from `time` (s) on; for instance to count their
/// operations. `model` is the robot as it is [laden](Scene::laden) then.
pub fn equations<'m, T: Real>(scene: &Scene, model: &'m Model<T>, time: f64) -> Box<dyn Equations<T> + 'm> {
    fn boxed<'m, T: Real, M: Momentum<T> + 'm>(
        scene: &Scene,
        model: &'m Model<T>,
        momentum: M,
        time: f64,
    ) -> Box<dyn Equations<T> + 'm> {
        let mut effects = scene.effects(model);
        effects.enter(time);
        let mut motion = Motion::new(model, momentum, effects).by(scene.solver.route);
        if let Some(mut drives) = scene.drives() {
            drives.enter(time);
            motion = motion.with_drives(drives);
        }
        Box::new(motion)
    }
    let momentum = Wrench::from_array(scene.start.centroidal.to_array().map(T::from_f64));
    match scene.case() {
        Case::Zero => boxed(scene, model, Zero, time),
        Case::Conserved => boxed(scene, model, Conserved { momentum }, time),
        Case::Ballistic => {
            let (acceleration, mass) = (scene.gravity().map(T::from_f64), T::from_f64(scene.start.mass));
            boxed(scene, model, Ballistic { momentum, acceleration, mass, since: T::zero() }, time)
        }
        Case::Driven => boxed(scene, model, Driven, time),
        Case::Hamel => boxed(scene, model, Hamel::new(model.dof()), time),
    }
}
