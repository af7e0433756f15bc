//! Scenes as motions: stepped from event to event, written down at regular times.

mod code;
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
use crate::motion::{Ballistic, Conserved, Driven, Hamel, Loads, Momentum, Motion, Zero};

use crate::observer::Observation;
use crate::scene::{Case, Scene, Start};
use flight::Flight;

pub use code::{Acting, Code, Coder};
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
    run_by(scene, model, None, None, each)
}

/// Goes on with a run that was stopped: the record is then that of one run, bit for bit.
///
/// `scene` and `model` must be the same as before.
pub fn resume(scene: &Scene, model: &Model, record: Record, each: impl FnMut(f64) -> ControlFlow<()>) -> Record {
    run_by(scene, model, Some(record), None, each)
}

/// [`run`], or [`resume`] from a record, by code that `coder` makes as soon as making it takes no longer than the core took since the last
/// event.
pub fn run_by(
    scene: &Scene,
    model: &Model,
    from: Option<Record>,
    coder: Option<Coder<'_>>,
    each: impl FnMut(f64) -> ControlFlow<()>,
) -> Record {
    struct Flying<'a, F> {
        scene: &'a Scene,
        models: &'a [Model],
        from: Option<Record>,
        coder: Option<Coder<'a>>,
        each: F,
    }
    impl<F: FnMut(f64) -> ControlFlow<()>> Knowing<f64> for Flying<'_, F> {
        type Out = Record;

        fn with<M: Momentum<f64>>(self, momentum: M) -> Record {
            let flight = Flight::new(self.scene, self.models, momentum, self.coder);
            match self.from {
                None => flight.computed(self.each),
                Some(record) => flight.resumed(record).computed(self.each),
            }
        }
    }
    let times = std::iter::once(0.0).chain(scene.handovers());
    let models: Vec<Model> = times.map(|time| scene.laden(model, time)).collect();
    knowing(scene, &FreeFall::of(&scene.start), Flying { scene, models: &models, from, coder, each })
}

/// Something to do with what is known about a momentum.
trait Knowing<T: Real> {
    type Out;

    fn with<M: Momentum<T> + 'static>(self, momentum: M) -> Self::Out;
}

/// What a scene knows about its momentum, from the last handover or the start on.
fn knowing<T: Real, K: Knowing<T>>(scene: &Scene, fall: &FreeFall, todo: K) -> K::Out {
    let momentum = Wrench::from_array(fall.momentum.to_array().map(T::from_f64));
    match scene.case() {
        Case::Zero => todo.with(Zero),
        Case::Conserved => todo.with(Conserved { momentum }),
        Case::Ballistic => {
            let (acceleration, mass) = (scene.gravity().map(T::from_f64), T::from_f64(fall.mass));
            todo.with(Ballistic { momentum, acceleration, mass, since: T::from_f64(fall.since) })
        }
        Case::Driven => todo.with(Driven),
        Case::Hamel => todo.with(Hamel::new(scene.start.q.len())),
    }
}

/// The motion of a scene under `loads`, with its route and the drives that act from `time` on.
fn motion<'m, T: Real, M: Momentum<T>, L: Loads<T>>(
    scene: &Scene,
    model: &'m Model<T>,
    momentum: M,
    loads: L,
    time: f64,
) -> Motion<'m, M, L, T> {
    let motion = Motion::new(model, momentum, loads).by(scene.solver.route);
    match scene.drives() {
        None => motion,
        Some(mut drives) => {
            drives.enter(time);
            motion.with_drives(drives)
        }
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
    struct Boxed<'a, 'm, T: Real> {
        scene: &'a Scene,
        model: &'m Model<T>,
        time: f64,
    }
    impl<'m, T: Real> Knowing<T> for Boxed<'_, 'm, T> {
        type Out = Box<dyn Equations<T> + 'm>;

        fn with<M: Momentum<T> + 'static>(self, momentum: M) -> Self::Out {
            let mut effects = self.scene.effects(self.model);
            effects.enter(self.time);
            Box::new(motion(self.scene, self.model, momentum, effects, self.time))
        }
    }
    knowing(scene, &FreeFall::of(&scene.start), Boxed { scene, model, time })
}
