//! Thousands of trajectories of one system, several side by side in the lanes of a number.
//!
//! A trajectory has a start, torques, a momentum of its own; the robot is the same. The lanes of an
//! [`F64x4`](frs_core::lanes::F64x4) or [`F64x8`](frs_core::lanes::F64x8) step together, but each chooses its steps alone: a lane that
//! rejects its step stays where it was and tries a shorter one while the others go on, and a lane that has arrived takes the next
//! trajectory. Every trajectory has the bits that [`Adaptive`](crate::integrate::Adaptive) gives it alone, whatever the number of lanes and
//! threads.

mod arrival;
mod check;
mod lanes;
mod lockstep;
mod torques;

use std::sync::atomic::{AtomicUsize, Ordering};

use frs_core::lanes::Lane;
use rayon::prelude::*;

use crate::integrate::{State, System, Tableau};
use lockstep::Lockstep;

pub use arrival::{Arrival, Flown, Sample};
pub use check::EnsembleError;
pub use torques::Torques;

/// How trajectories are integrated.
///
/// ```
/// use frs_core::lanes::F64x4;
/// use frs_core::spatial::{Pose, Twist};
/// use frs_core::Model;
/// use frs_sim::ensemble::{Ensemble, Start, Torques};
/// use frs_sim::integrate::{Adaptive, DOP853};
/// use frs_sim::motion::{Motion, Zero};
///
/// // A satellite at rest, its arm driven by twenty sets of torques, for one second.
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// let torques: Vec<[f64; 7]> = (0..20).map(|number| [0.01 * f64::from(number); 7]).collect();
/// let mut alone = Motion::new(&model, Zero, Torques::none(7));
/// let state = alone.state(Pose::identity(), &[0.3; 7], &[0.0; 7], Twist::zero());
/// let starts = vec![Start { state: state.clone(), from: 0.0, until: 1.0 }; 20];
///
/// let four = model.cast::<F64x4>();
/// let ensemble = Ensemble { tableau: &DOP853, accuracy: 1e-9, times: vec![0.5] };
/// let flown = ensemble.fly(
///     &starts,
///     || Motion::new(&four, Zero, Torques::none(7)),
///     |motion, seat| motion.loads_mut().set(seat.lane, &torques[seat.trajectory]),
/// )?;
///
/// // The same as one alone, bit by bit.
/// alone.loads_mut().set(0, &torques[13]);
/// let mut one = Adaptive::new(&DOP853, state, 0.0, 1e-9);
/// while one.time() < 1.0 {
///     one.advance(&mut alone, 1.0)?;
/// }
/// let arrival = &flown.arrivals[13];
/// assert_eq!((&arrival.state, arrival.evaluations), (one.state(), one.evaluations()));
/// assert_eq!(arrival.samples[0].time, 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Ensemble {
    /// A method that estimates its error: [`DOPRI5`](crate::integrate::DOPRI5) or [`DOP853`](crate::integrate::DOP853).
    pub tableau: &'static Tableau,
    /// Allowed error of a step, as of [`Adaptive`](crate::integrate::Adaptive).
    pub accuracy: f64,
    /// Times at which samples are taken, each later than the one before (s); a trajectory has those between its start and its end.
    /// Samples are interpolated and change no step.
    pub times: Vec<f64>,
}

/// Where a trajectory begins, and when it ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// The state at the time `from`.
    pub state: State,
    /// s.
    pub from: f64,
    /// s, not before `from`.
    pub until: f64,
}

/// Which trajectory goes on in which lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seat {
    /// The lane, from 0.
    pub lane: usize,
    /// Number of the trajectory in the list of starts.
    pub trajectory: usize,
}

impl Ensemble {
    /// Integrates trajectories on the threads of the rayon pool in which this is called.
    ///
    /// Every thread asks for a `system` of its own, over numbers with 1, 4 or 8 lanes: a
    /// [`Motion`](crate::motion::Motion) of [`Model::cast`](frs_core::Model::cast), or any other. `take` is called when a lane takes a
    /// trajectory; it puts what the system has of that trajectory (torques, a momentum) into that lane, and leaves the other lanes alone.
    /// There are no events: what acts does so from the start to the end of a trajectory, and signals with knots stay on their piece.
    ///
    /// Trajectories are taken in their order. The last ones leave lanes empty: what takes long should come early.
    ///
    /// # Errors
    /// If the method estimates no error, if the accuracy, a time or a number of a start is not what it must be, or if a state has not the
    /// dimension of the system. A trajectory that cannot be continued is no error here: its [`Arrival::end`] tells.
    pub fn fly<T: Lane<Element = f64>, S: System<T>>(
        &self,
        starts: &[Start],
        system: impl Fn() -> S + Sync,
        take: impl Fn(&mut S, Seat) + Sync,
    ) -> Result<Flown, EnsembleError> {
        let first = system();
        check::ensemble(self)?;
        check::starts(starts, first.dimension())?;
        let queue = AtomicUsize::new(0);
        let next = || Some(queue.fetch_add(1, Ordering::Relaxed)).filter(|&number| number < starts.len());
        let threads = rayon::current_num_threads().min(starts.len().div_ceil(T::WIDTH));
        let parts: Vec<_> = match threads {
            0 | 1 => vec![Lockstep::new(self, starts, first).run(next, &take)],
            // A thread that is busy elsewhere leaves its share to the others.
            _ => (0..threads)
                .into_par_iter()
                .with_max_len(1)
                .map(|_| Lockstep::new(self, starts, system()).run(next, &take))
                .collect(),
        };
        Ok(Flown::of(parts, T::WIDTH))
    }
}
