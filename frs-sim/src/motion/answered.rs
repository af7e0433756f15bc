//! The equations of motion of a robot that answers quantities: generated code, or any other [`FloatingBase`].

use std::ops::Range;

use frs_core::spatial::{Pose, Twist};
use frs_core::{FloatingBase, Quantity, Real};

use super::{Instant, Load};
use crate::integrate::{State, System, Tangent};

/// Something that exerts forces by the instant alone: no sweep over the robot is at hand. Two are a pair `(a, b)`, none is `()`.
///
/// What asks the robot is [`Loads`](super::Loads).
pub trait Forces<T: Real> {
    /// Adds the forces at an instant.
    fn add(&mut self, instant: &Instant<'_, T>, load: &mut Load<T>);
}

impl<T: Real> Forces<T> for () {
    fn add(&mut self, _: &Instant<'_, T>, _: &mut Load<T>) {}
}

impl<T: Real, A: Forces<T>, B: Forces<T>> Forces<T> for (A, B) {
    fn add(&mut self, instant: &Instant<'_, T>, load: &mut Load<T>) {
        self.0.add(instant, load);
        self.1.add(instant, load);
    }
}

/// A function of the instant: `|instant, load| …`.
impl<T: Real, F: FnMut(&Instant<'_, T>, &mut Load<T>)> Forces<T> for F {
    fn add(&mut self, instant: &Instant<'_, T>, load: &mut Load<T>) {
        self(instant, load);
    }
}

/// A robot in motion that is asked for [`Quantity::StateRate`] and nothing else: all that its forces know is the [`Instant`].
///
/// The numbers of a state are `q`, `q̇` and `μ`, as those of a [`Motion`](super::Motion) whose momentum is [`Driven`](super::Driven), and so
/// are its bits. Over lanes it is a system for an [`Ensemble`](crate::ensemble::Ensemble).
///
/// ```
/// use frs_core::spatial::{Pose, Twist};
/// use frs_core::{Evaluator, Model};
/// use frs_sim::integrate::{Adaptive, DOP853};
/// use frs_sim::motion::{Answered, Instant, Load};
///
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// // Instead of the evaluator: a type that `frs_model!` has made.
/// let dampers = |instant: &Instant<'_>, load: &mut Load| {
///     load.tau.iter_mut().zip(instant.qd).for_each(|(tau, qd)| *tau -= 0.1 * qd);
/// };
/// let mut motion = Answered::new(Evaluator::new(&model), dampers);
/// let start = motion.state(Pose::identity(), &[0.3; 7], &[0.1; 7], Twist::zero());
/// let mut flight = Adaptive::new(&DOP853, start, 0.0, 1e-10);
/// while flight.time() < 1.0 {
///     flight.advance(&mut motion, 1.0)?;
/// }
/// assert!(flight.state().flat[7..14].iter().all(|qd| qd.abs() < 0.1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Answered<R, F, T: Real = f64> {
    robot: R,
    forces: F,
    load: Load<T>,
    xi_dot: Vec<T>,
}

impl<T: Real, R: FloatingBase<T>, F: Forces<T>> Answered<R, F, T> {
    /// The motion of `robot` under `forces`, which are added to a load of none.
    ///
    /// # Panics
    /// If the robot does not answer [`Quantity::StateRate`].
    pub fn new(robot: R, forces: F) -> Self {
        assert!(robot.answers(Quantity::StateRate), "the robot must answer state_rate; add it to its outputs");
        let n = robot.dof();
        Self { robot, forces, load: Load::zero(n), xi_dot: vec![T::zero(); 6 + n] }
    }

    /// A state of this motion.
    ///
    /// # Panics
    /// If `q` or `qd` does not have n entries.
    pub fn state(&self, pose: Pose<T>, q: &[T], qd: &[T], mu: Twist<T>) -> State<T> {
        let n = self.robot.dof();
        assert!(q.len() == n && qd.len() == n, "q and q̇ must have one entry per coordinate");
        State { pose, flat: [q, qd, &mu.to_array()].concat() }
    }

    /// What exerts the forces, to be changed.
    pub fn forces_mut(&mut self) -> &mut F {
        &mut self.forces
    }
}

impl<T: Real, R: FloatingBase<T>, F: Forces<T>> System<T> for Answered<R, F, T> {
    fn dimension(&self) -> usize {
        2 * self.robot.dof() + 6
    }

    fn velocities(&self) -> Range<usize> {
        self.robot.dof()..self.dimension()
    }

    fn rate(&mut self, time: T, state: &State<T>, rate: &mut Tangent<T>) {
        let Self { robot, forces, load, xi_dot } = self;
        let n = robot.dof();
        let (q, rest) = state.flat.split_at(n);
        let (qd, mu) = rest.split_at(n);
        load.clear();
        let velocity = Twist::from_array(std::array::from_fn(|i| mu[i]));
        forces.add(&Instant { time, pose: &state.pose, q, qd, mu: velocity }, load);

        let (wrench, mut twist) = (load.base_wrench.to_array(), [T::zero(); 6]);
        let inputs: [&[T]; 6] = [q, qd, mu, &load.gravity, &wrench, &load.tau];
        robot.answer(Quantity::StateRate, &inputs, &mut [&mut twist, xi_dot]);
        let (mu_dot, qdd) = xi_dot.split_at(6);
        rate.twist = Twist::from_array(twist);
        rate.flat[..n].copy_from_slice(qd);
        rate.flat[n..2 * n].copy_from_slice(qdd);
        rate.flat[2 * n..].copy_from_slice(mu_dot);
    }
}
