//! The equations of motion of a robot, as an integrator takes them.
//!
//! What is known about the momentum decides what is integrated ([`Momentum`]): nothing but the shape where it is [`Zero`],
//! [`Conserved`] or [`Ballistic`], the locked velocity too where it is [`Driven`]. Forces are types ([`Loads`]): what a motion does
//! not name is not computed.

mod answered;
mod drives;
mod free_flight;
mod loads;
mod momentum;
mod variational;

use std::ops::Range;

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Model, Moving, Real, Route, Workspace};

use crate::integrate::{State, System, Tangent};

pub use answered::{Answered, Forces};
pub use drives::{Course, Drives};
pub use free_flight::free_flight;
pub use loads::{Instant, Load, Loads};
pub use momentum::{Ballistic, Conserved, Driven, Hamel, Momentum, Zero};
pub use variational::{Canonical, Variational, Velocities};

/// A robot in motion: `ġ₁ = g₁ V₁^`, and the shape's half of the REL equations; both halves where the momentum is [`Driven`].
///
/// The numbers of a state are `q`, `q̇` and, where it is driven, `μ`. One sweep over the robot serves everything that is asked at a
/// state: the momentum, the forces, and the accelerations.
///
/// ```
/// use frs_core::Model;
/// use frs_core::spatial::{Pose, Twist, Wrench};
/// use frs_sim::integrate::{Adaptive, DOP853};
/// use frs_sim::motion::{Conserved, Motion};
///
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// // A tumbling satellite whose arm swings: momentum is constant, so only the shape and the pose are integrated.
/// let momentum = Wrench::from_array([0.3, 0.1, -0.2, 0.0, 0.0, 0.0]);
/// let mut motion = Motion::new(&model, Conserved { momentum }, ());
/// let start = motion.state(Pose::identity(), &[0.3; 7], &[0.1; 7], Twist::zero());
/// let energy = motion.kinetic_energy(0.0, &start);
///
/// let mut flight = Adaptive::new(&DOP853, start, 0.0, 1e-10);
/// while flight.time() < 1.0 {
///     flight.advance(&mut motion, 1.0)?;
/// }
/// assert!((motion.kinetic_energy(1.0, flight.state()) - energy).abs() < 1e-9 * energy);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Motion<'m, M, L, T: Real = f64> {
    work: Workspace<'m, T>,
    momentum: M,
    loads: L,
    drives: Option<Drives<T>>,
    route: Route,
    /// Shape and its rates, as the drives have them.
    q: Vec<T>,
    qd: Vec<T>,
    qdd: Vec<T>,
    load: Load<T>,
}

impl<'m, M: Momentum<T>, L: Loads<T>, T: Real> Motion<'m, M, L, T> {
    /// The motion of a robot with what is known about its momentum, under `loads`.
    pub fn new(model: &'m Model<T>, momentum: M, loads: L) -> Self {
        let n = model.dof();
        let zeros = vec![T::zero(); n];
        let (q, qd, qdd) = (zeros.clone(), zeros.clone(), zeros);
        Self {
            work: Workspace::new(model),
            momentum,
            loads,
            drives: None,
            route: Route::default(),
            q,
            qd,
            qdd,
            load: Load::zero(n),
        }
    }

    /// The same with rotors in the joints, or joints that follow a course.
    ///
    /// # Panics
    /// If the drives are not those of n joints.
    pub fn with_drives(self, drives: Drives<T>) -> Self {
        assert_eq!(drives.dof(), self.q.len(), "the drives must be those of the robot's joints");
        Self { drives: Some(drives), ..self }
    }

    /// The same with `q̈` found by another route; where there are drives, Λ_q is factored whatever the route.
    pub fn by(self, route: Route) -> Self {
        Self { route, ..self }
    }

    /// A state of this motion; `mu` counts where the momentum is driven, else it follows.
    ///
    /// # Panics
    /// If `q` or `qd` does not have n entries.
    pub fn state(&mut self, pose: Pose<T>, q: &[T], qd: &[T], mu: Twist<T>) -> State<T> {
        let n = self.q.len();
        assert!(q.len() == n && qd.len() == n, "q and q̇ must have one entry per coordinate");
        let mut flat = [q, qd].concat();
        let numbers = self.momentum.numbers(&self.work.shape(q).moving(qd), mu);
        flat.extend(numbers.to_array().iter().take(M::NUMBERS));
        State { pose, flat }
    }

    /// The forces at the state whose rate was asked for last; torques of joints that follow a course are those that they need.
    pub fn last_load(&self) -> &Load<T> {
        &self.load
    }

    /// Goes on with a robot of the same joints and another mass distribution, from `time` (s) on, with momentum `momentum` about its
    /// centre of mass (world axes) and total mass `mass` (kg).
    pub fn change(&mut self, model: &'m Model<T>, time: T, momentum: Wrench<T>, mass: T) {
        self.work = Workspace::new(model);
        self.momentum.change(time, momentum, mass);
    }

    /// The drives.
    pub fn drives(&self) -> Option<&Drives<T>> {
        self.drives.as_ref()
    }

    /// What is known about the momentum, to be changed at an event.
    pub fn momentum_mut(&mut self) -> &mut M {
        &mut self.momentum
    }

    /// What exerts the forces.
    pub fn loads(&self) -> &L {
        &self.loads
    }

    /// The same, to be changed at an event.
    pub fn loads_mut(&mut self) -> &mut L {
        &mut self.loads
    }

    /// The drives, to be changed at an event.
    pub fn drives_mut(&mut self) -> Option<&mut Drives<T>> {
        self.drives.as_mut()
    }

    /// Shape and shape velocity of a state: joints that follow a course are on it.
    pub fn shape(&mut self, time: T, state: &State<T>) -> (&[T], &[T]) {
        let n = self.q.len();
        self.q.copy_from_slice(&state.flat[..n]);
        self.qd.copy_from_slice(&state.flat[n..2 * n]);
        if let Some(drives) = &self.drives {
            drives.place(time, &mut self.q, &mut self.qd, &mut self.qdd);
        }
        (&self.q, &self.qd)
    }

    /// Asks the robot in a state, which `ask` is given with its locked velocity μ.
    pub fn ask<A>(
        &mut self,
        time: T,
        state: &State<T>,
        ask: impl FnOnce(&mut Moving<'_, '_, '_, T>, Twist<T>) -> A,
    ) -> A {
        self.shape(time, state);
        let mut shape = self.work.shape(&self.q);
        let mut robot = shape.moving(&self.qd);
        let mu = self.momentum.locked_velocity(time, &state.pose, &robot, &state.flat[2 * self.q.len()..]);
        ask(&mut robot, mu)
    }

    /// The locked velocity μ of a state.
    pub fn locked_velocity(&mut self, time: T, state: &State<T>) -> Twist<T> {
        self.ask(time, state, |_, mu| mu)
    }

    /// The kinetic energy `½ ξᵀ Λ ξ` of a state, with that of the rotors (J).
    pub fn kinetic_energy(&mut self, time: T, state: &State<T>) -> T {
        let energy = self.ask(time, state, |robot, mu| robot.kinetic_energy(mu));
        energy + self.drives.as_ref().map_or(T::zero(), |drives| drives.kinetic_energy(&self.qd))
    }

    /// The momentum `Ad_{g₁}⁻ᵀ Λ_b μ` about the world's origin.
    pub fn spatial_momentum(&mut self, time: T, state: &State<T>) -> Wrench<T> {
        self.ask(time, state, |robot, mu| robot.spatial_momentum(&state.pose, mu))
    }
}

impl<M: Momentum<T>, L: Loads<T>, T: Real> System<T> for Motion<'_, M, L, T> {
    fn dimension(&self) -> usize {
        2 * self.q.len() + M::NUMBERS
    }

    fn velocities(&self) -> Range<usize> {
        self.q.len()..self.dimension()
    }

    fn rate(&mut self, time: T, state: &State<T>, rate: &mut Tangent<T>) {
        let n = self.q.len();
        self.shape(time, state);
        let Self { work, momentum, loads, drives, route, q, qd, qdd, load } = self;
        let mut shape = work.shape(q);
        let mut robot = shape.moving(qd);
        let mu = momentum.locked_velocity(time, &state.pose, &robot, &state.flat[2 * n..]);
        load.clear();
        loads.add(&Instant { time, pose: &state.pose, q, qd, mu }, &mut robot, load);

        rate.twist = robot.base_twist(mu);
        let numbers = &mut rate.flat[2 * n..];
        match drives {
            None => momentum.accelerations(&mut robot, *route, mu, load, qdd, numbers),
            Some(drives) => {
                drives.accelerations(&mut robot, mu, load, qdd);
                momentum.number_rates(&mut robot, mu, load, qdd, numbers);
            }
        }
        rate.flat[..n].copy_from_slice(qd);
        rate.flat[n..2 * n].copy_from_slice(qdd);
    }
}
