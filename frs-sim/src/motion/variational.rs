//! A variational integrator: steps that come from a principle of least action of their own.
//!
//! ```text
//! L_d = h L(q₀ + ½ h q̇, V, q̇),   g₁ = g₀ exp(h V),  q₁ = q₀ + h q̇
//!
//! J = Ad_{g₀}⁻ᵀ Π₀,   Π₀ = (dexp⁻¹_{hV})ᵀ ∂L/∂V                            momentum about the world's origin
//! π₀ = ∂L/∂q̇ − ½ h (∂L/∂q + τ),   π₁ = ∂L/∂q̇ + ½ h (∂L/∂q + τ)     momentum of the shape
//! ```
//!
//! The discrete Euler-Lagrange equations say that the momenta at the end of a step are those at the start of the next. What follows
//! (Marsden, West, "Discrete mechanics and variational integrators", Acta Numerica 10 (2001)): J does not change by a bit, the map from
//! step to step is symplectic, and without friction the energy stays within `O(h²)` of what it was, for times that are exponentially long in
//! 1/h. The order is 2.

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Model, Workspace};

use super::{Instant, Load, Loads};
use crate::integrate::IntegrationError;

/// A state by its momenta.
#[derive(Clone, Debug, PartialEq)]
pub struct Canonical {
    /// Pose g₁ of the base in the world.
    pub pose: Pose<f64>,
    /// Shape (rad, m).
    pub q: Vec<f64>,
    /// Momentum J about the world's origin (kg·m²/s, kg·m/s); it is never changed.
    pub momentum: Wrench<f64>,
    /// Momentum of the shape, `π = Λ_q q̇ + A_lᵀ Λ_b μ` (kg·m²/s, kg·m/s).
    pub shape_momentum: Vec<f64>,
}

/// Velocities that belong to momenta.
#[derive(Clone, Debug, PartialEq)]
pub struct Velocities {
    /// Locked velocity, base frame.
    pub mu: Twist<f64>,
    /// Shape velocity (rad/s, m/s).
    pub qd: Vec<f64>,
}

/// Steps of a robot on which only joint torques act.
///
/// ```
/// use frs_core::Model;
/// use frs_core::spatial::{Pose, Twist};
/// use frs_sim::motion::Variational;
///
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// let mut motion = Variational::new(&model, ());
/// let mut state = motion.state(Pose::identity(), &[0.3; 7], &[0.1; 7], Twist::from_array([0.1, 0.2, 0.0, 0.0, 0.0, 0.0]));
/// let energy = motion.kinetic_energy(&state);
/// for i in 0..1000 {
///     motion.step(0.01 * f64::from(i), 0.01, &mut state)?;
/// }
/// assert!((motion.kinetic_energy(&state) / energy - 1.0).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Variational<'m, L> {
    work: Workspace<'m>,
    loads: L,
    load: Load,
    /// Of the last step, where the search for those of the next begins.
    velocities: Velocities,
    /// Those that are tried next, and the shape in the middle of the step.
    next: Vec<f64>,
    middle: Vec<f64>,
    /// ∂L/∂q + τ there, and the shape's momentum.
    push: Vec<f64>,
    pi: Vec<f64>,
    at_rest: Vec<f64>,
}

/// The equations of a step converge by a factor of the size of h each round, or not at all.
const ROUNDS: usize = 60;

/// Changes of the velocities below this, relative, are rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A change that is not smaller than this is no convergence when it stops decreasing.
const CONVERGED: f64 = 1e-11;

impl<'m, L: Loads<f64>> Variational<'m, L> {
    /// Steps of a robot under `loads`, of which only the joint torques count.
    pub fn new(model: &'m Model, loads: L) -> Self {
        let zeros = || vec![0.0; model.dof()];
        Self {
            work: Workspace::new(model),
            loads,
            load: Load::zero(model.dof()),
            velocities: Velocities { mu: Twist::zero(), qd: zeros() },
            next: zeros(),
            middle: zeros(),
            push: zeros(),
            pi: zeros(),
            at_rest: zeros(),
        }
    }

    /// The state with these velocities; the next step begins its search with them.
    ///
    /// # Panics
    /// If `q` or `qd` does not have n entries.
    pub fn state(&mut self, pose: Pose<f64>, q: &[f64], qd: &[f64], mu: Twist<f64>) -> Canonical {
        let mut shape = self.work.shape(q);
        let momentum = shape.spatial_momentum(&pose, mu);
        let mut shape_momentum = self.at_rest.clone();
        let xi = [&mu.to_array()[..], qd].concat();
        // At rest, accelerations and forces are as velocities and momenta.
        shape.moving(&self.at_rest).inverse_dynamics(Twist::zero(), &xi, &mut shape_momentum);
        self.velocities = Velocities { mu, qd: qd.to_vec() };
        Canonical { pose, q: q.to_vec(), momentum, shape_momentum }
    }

    /// The velocities of a state.
    pub fn velocities(&mut self, state: &Canonical) -> Velocities {
        let mut qd = self.at_rest.clone();
        let momentum = state.pose.inverse().act_wrench(state.momentum);
        let mut shape = self.work.shape(&state.q);
        let mut rest = shape.moving(&self.at_rest);
        rest.shape_acceleration(Twist::zero(), momentum, &state.shape_momentum, &mut qd);
        Velocities { mu: rest.velocity_of_momentum(momentum), qd }
    }

    /// The kinetic energy of a state, J.
    pub fn kinetic_energy(&mut self, state: &Canonical) -> f64 {
        let Velocities { mu, qd } = self.velocities(state);
        self.work.shape(&state.q).moving(&qd).kinetic_energy(mu)
    }

    /// One step of length `h` (s) from `state` at `time`.
    ///
    /// # Errors
    /// If the equations of the step are not solved: h is too long for the motion, or a force is not finite.
    pub fn step(&mut self, time: f64, h: f64, state: &mut Canonical) -> Result<(), IntegrationError> {
        let half = 0.5 * h;
        let start = state.pose.inverse().act_wrench(state.momentum);
        let Self { work, loads, load, velocities: Velocities { mu, qd }, next, middle, push, pi, at_rest } = self;
        let mut before = f64::INFINITY;
        for _ in 0..ROUNDS {
            for ((middle, q), qd) in middle.iter_mut().zip(&state.q).zip(&*qd) {
                *middle = q + half * qd;
            }
            let mut shape = work.shape(middle);
            let mut robot = shape.moving(qd);
            let twist = robot.base_twist(*mu);
            let pose = state.pose * Pose::exp(twist * half);
            load.clear();
            loads.add(&Instant { time: time + half, pose: &pose, q: middle, qd, mu: *mu }, &mut robot, load);
            robot.kinetic_gradient(*mu, push);
            for (((push, tau), pi), start) in push.iter_mut().zip(&load.tau).zip(&mut *pi).zip(&state.shape_momentum) {
                *push += tau;
                *pi = start + half * *push;
            }

            // The velocities that belong to the momenta in the middle.
            let momentum = dexp_transpose(twist * h, start);
            let mut rest = shape.moving(at_rest);
            rest.shape_acceleration(Twist::zero(), momentum, pi, next);
            let next_mu = rest.velocity_of_momentum(momentum);
            let changes = next.iter().zip(&*qd).map(|(next, last)| (next - last).abs());
            let change = changes.fold((next_mu - *mu).to_vector().norm(), f64::max);
            let size = next.iter().fold(next_mu.to_vector().norm(), |size, qd| size.max(qd.abs()));
            std::mem::swap(qd, next);
            *mu = next_mu;
            if !change.is_finite() {
                return Err(IntegrationError::NotFinite { time });
            }
            if change <= ROUNDING * size || (change >= before && before <= CONVERGED * size) {
                let twist = shape.moving(qd).base_twist(*mu);
                state.pose = (state.pose * Pose::exp(twist * h)).orthonormalised();
                for (((q, pi), qd), push) in state.q.iter_mut().zip(&mut state.shape_momentum).zip(&*qd).zip(&*push) {
                    *q += h * qd;
                    *pi += h * push;
                }
                return Ok(());
            }
            before = change;
        }
        Err(IntegrationError::NotSolved { time, step: h })
    }
}

/// `(dexp_ζ)ᵀ h`.
fn dexp_transpose(zeta: Twist<f64>, wrench: Wrench<f64>) -> Wrench<f64> {
    Wrench::from_array(std::array::from_fn(|i| {
        let mut unit = [0.0; 6];
        unit[i] = 1.0;
        zeta.dexp(Twist::from_array(unit)).dot(wrench)
    }))
}
