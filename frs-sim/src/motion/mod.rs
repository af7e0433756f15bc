//! The equations of motion of a robot, as an integrator takes them.
//!
//! What is known about the momentum decides what is integrated ([`Momentum`]): nothing but the shape where it is [`Zero`] or
//! [`Conserved`], the locked velocity too where it is [`Driven`]. Forces are types ([`Loads`]): what a motion does not name is
//! not computed.

mod loads;
mod momentum;

use std::ops::Range;

use frs_core::spatial::{Twist, Wrench};
use frs_core::{FloatingBase, Quantity, Real};

use crate::integrate::{State, System, Tangent};

pub use loads::{Instant, Load, Loads};
pub use momentum::{Conserved, Driven, Momentum, Zero};

/// A robot in motion: `ġ₁ = g₁ V₁^`, and the shape's half of the REL equations; both halves where the momentum is [`Driven`].
///
/// The numbers of a state are `q`, `q̇` and, where it is driven, `μ`. The robot is any [`FloatingBase`] that answers
/// [`Quantity::BaseTwist`] and [`Quantity::ForwardDynamics`]: read from a URDF, or generated, with the same bits.
///
/// ```
/// use frs_core::{Evaluator, Model};
/// use frs_core::spatial::{Pose, Twist, Wrench};
/// use frs_sim::integrate::{Adaptive, DOP853};
/// use frs_sim::motion::{Conserved, Motion};
///
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// // A tumbling satellite whose arm swings: momentum is constant, so only the shape and the pose are integrated.
/// let momentum = Wrench::from_array([0.3, 0.1, -0.2, 0.0, 0.0, 0.0]);
/// let mut motion = Motion::new(Evaluator::new(&model), Conserved { momentum }, ());
/// let start = motion.state(Pose::identity(), &[0.3; 7], &[0.1; 7], Twist::zero());
/// let energy = motion.kinetic_energy(&start);
///
/// let mut flight = Adaptive::new(&DOP853, start, 0.0, 1e-10);
/// while flight.time() < 1.0 {
///     flight.advance(&mut motion, 1.0)?;
/// }
/// assert!((motion.kinetic_energy(flight.state()) - energy).abs() < 1e-9 * energy);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Motion<R, M, L, T: Real = f64> {
    robot: R,
    momentum: M,
    loads: L,
    load: Load<T>,
    xi_dot: Vec<T>,
}

impl<R: FloatingBase<T>, M: Momentum<T>, L: Loads<T>, T: Real> Motion<R, M, L, T> {
    /// The motion of `robot` with what is known about its momentum, under `loads`.
    ///
    /// # Panics
    /// If the robot does not answer what is asked of it.
    pub fn new(robot: R, momentum: M, loads: L) -> Self {
        for quantity in [Quantity::BaseTwist, Quantity::ForwardDynamics].iter().chain(M::QUANTITIES) {
            assert!(robot.answers(*quantity), "the robot must answer {}", quantity.name());
        }
        let n = robot.dof();
        let load = Load { base_wrench: Wrench::zero(), gravity: [T::zero(); 3], tau: vec![T::zero(); n] };
        Self { robot, momentum, loads, load, xi_dot: vec![T::zero(); 6 + n] }
    }

    /// A state of this motion; `mu` counts where the momentum is driven, else it follows.
    ///
    /// # Panics
    /// If `q` or `qd` does not have n entries.
    pub fn state(&self, pose: frs_core::spatial::Pose<T>, q: &[T], qd: &[T], mu: Twist<T>) -> State<T> {
        let n = self.robot.dof();
        assert!(q.len() == n && qd.len() == n, "q and q̇ must have one entry per coordinate");
        let mut flat = [q, qd].concat();
        flat.extend(mu.to_array().iter().take(M::NUMBERS));
        State { pose, flat }
    }

    /// The forces at the state whose rate was asked for last.
    pub fn last_load(&self) -> &Load<T> {
        &self.load
    }

    /// What exerts the forces, to be changed at an event.
    pub fn loads_mut(&mut self) -> &mut L {
        &mut self.loads
    }

    /// The locked velocity μ of a state.
    pub fn locked_velocity(&mut self, state: &State<T>) -> Twist<T> {
        let (q, rest) = state.flat.split_at(self.robot.dof());
        self.momentum.locked_velocity(&mut self.robot, &state.pose, q, &rest[q.len()..])
    }

    /// The kinetic energy `½ ξᵀ Λ ξ` of a state (J).
    ///
    /// # Panics
    /// If the robot does not answer [`Quantity::KineticEnergy`].
    pub fn kinetic_energy(&mut self, state: &State<T>) -> T {
        let mu = self.locked_velocity(state);
        let n = self.robot.dof();
        let mut energy = [T::zero()];
        let inputs = [&state.flat[..n], &state.flat[n..2 * n], &mu.to_array()];
        self.robot.answer(Quantity::KineticEnergy, &inputs, &mut [&mut energy]);
        energy[0]
    }

    /// The momentum `Ad_{g₁}⁻ᵀ Λ_b μ` about the world's origin.
    ///
    /// # Panics
    /// If the robot does not answer [`Quantity::Momentum`].
    pub fn spatial_momentum(&mut self, state: &State<T>) -> Wrench<T> {
        let mu = self.locked_velocity(state);
        let (mut body, mut centroidal) = ([T::zero(); 6], [T::zero(); 6]);
        let inputs = [&state.flat[..self.robot.dof()], &mu.to_array()];
        self.robot.answer(Quantity::Momentum, &inputs, &mut [&mut body, &mut centroidal]);
        state.pose.act_wrench(Wrench::from_array(body))
    }
}

impl<R: FloatingBase<T>, M: Momentum<T>, L: Loads<T>, T: Real> System<T> for Motion<R, M, L, T> {
    fn dimension(&self) -> usize {
        2 * self.robot.dof() + M::NUMBERS
    }

    fn velocities(&self) -> Range<usize> {
        self.robot.dof()..self.dimension()
    }

    fn rate(&mut self, time: T, state: &State<T>, rate: &mut Tangent<T>) {
        let n = self.robot.dof();
        let mu = self.locked_velocity(state);
        let (q, qd) = (&state.flat[..n], &state.flat[n..2 * n]);
        let Self { robot, loads, load, xi_dot, .. } = self;
        load.clear();
        loads.add(&Instant { time, pose: &state.pose, q, qd, mu }, load);

        let (mu, wrench, mut twist) = (mu.to_array(), load.base_wrench.to_array(), [T::zero(); 6]);
        robot.answer(Quantity::BaseTwist, &[q, qd, &mu], &mut [&mut twist]);
        let inputs: [&[T]; 6] = [q, qd, &mu, &load.gravity, &wrench, &load.tau];
        robot.answer(Quantity::ForwardDynamics, &inputs, &mut [xi_dot]);

        rate.twist = Twist::from_array(twist);
        rate.flat[..n].copy_from_slice(qd);
        rate.flat[n..2 * n].copy_from_slice(&xi_dot[6..]);
        rate.flat[2 * n..].copy_from_slice(&xi_dot[..M::NUMBERS]);
    }
}
