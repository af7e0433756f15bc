//! Steps as long as the asked accuracy allows.

use frs_core::Real;
use thiserror::Error;

use super::control::Control;
use super::trial::{Trial, first_length};
use super::{State, System, Tableau};

/// Why a motion cannot be continued; the state before is kept.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum IntegrationError {
    /// A rate or a state is not finite.
    #[error(
        "t = {time} s: the motion is not finite; expected finite rates; look for a singular shape, or forces that grow without bound"
    )]
    NotFinite {
        /// Time of the last finite state, s.
        time: f64,
    },
    /// The accuracy asks for steps below the resolution of time.
    #[error(
        "t = {time} s: steps of {step:e} s do not reach the accuracy {accuracy:e}; expected a motion that is smooth between events; ask for less, or use an implicit method"
    )]
    StepTooSmall {
        /// Time, s.
        time: f64,
        /// The step that was too long still, s.
        step: f64,
        /// The accuracy asked for.
        accuracy: f64,
    },
    /// An implicit step was not solved.
    #[error(
        "t = {time} s: the implicit step of {step:e} s was not solved; expected the search to converge; use shorter steps"
    )]
    NotSolved {
        /// Time at the start of the step, s.
        time: f64,
        /// Its length, s.
        step: f64,
    },
}

/// A motion with error control, by a method that estimates its error.
///
/// The estimated error of a step is kept below `accuracy`, as the root mean square over rotation, translation and all
/// numbers that are not only [measured](System::measured); relative to numbers above 1 (rad, m, s), absolute below.
///
/// ```
/// use frs_sim::integrate::{Adaptive, DOP853, State, System, Tangent};
///
/// /// x¨ = −x.
/// struct Spring;
/// impl System for Spring {
///     fn dimension(&self) -> usize { 2 }
///     fn velocities(&self) -> std::ops::Range<usize> { 1..2 }
///     fn rate(&mut self, _: f64, state: &State, rate: &mut Tangent) {
///         rate.twist = frs_core::spatial::Twist::zero();
///         rate.flat.copy_from_slice(&[state.flat[1], -state.flat[0]]);
///     }
/// }
/// let mut start = State::origin(2);
/// start.flat[0] = 1.0;
/// let mut motion = Adaptive::new(&DOP853, start, 0.0, 1e-12);
/// while motion.time() < 10.0 {
///     motion.advance(&mut Spring, 10.0)?; // one step, not beyond 10 s
/// }
/// assert!((motion.state().flat[0] - 10.0_f64.cos()).abs() < 1e-11);
/// # Ok::<(), frs_sim::integrate::IntegrationError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Adaptive<T: Real = f64> {
    /// The last step; the motion is at its end.
    trial: Trial<T>,
    control: Control,
    /// Start of the last step, and its length.
    start: T,
    length: T,
    time: T,
    /// Whether the tangent at the end of the last step is that of the motion.
    known: bool,
    evaluations: usize,
}

/// What [`Adaptive`] knows besides time and state: with it, a motion goes on with the bits that it would have had.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Length of the next step, 0 before the first.
    pub next: f64,
    /// Error of the step before, in units of the accuracy.
    pub error: f64,
    /// Whether the motion goes on smoothly from the step before.
    pub smooth: bool,
    /// How often the system was evaluated so far.
    pub evaluations: usize,
}

impl<T: Real + Into<f64>> Adaptive<T> {
    /// The motion from `state` at `time` (s).
    ///
    /// # Panics
    /// If the method estimates no error, or `accuracy` is not positive.
    pub fn new(tableau: &'static Tableau, state: State<T>, time: T, accuracy: f64) -> Self {
        assert!(accuracy > 0.0, "the accuracy must be positive");
        Self {
            trial: Trial::new(tableau, state, 1),
            control: Control::new(tableau.error_order, accuracy),
            start: time,
            length: T::zero(),
            time,
            known: false,
            evaluations: 0,
        }
    }

    /// What it takes to go on from the present time and state.
    pub fn pace(&self) -> Pace {
        let Control { next, error, .. } = self.control;
        Pace { next, error, smooth: self.known, evaluations: self.evaluations }
    }

    /// The pace alone, which must not be smooth: then the next step asks the system how to go on.
    pub(crate) fn set_pace(&mut self, pace: Pace) {
        (self.control.next, self.control.error) = (pace.next, pace.error);
        (self.known, self.evaluations) = (pace.smooth, pace.evaluations);
    }

    /// Goes on at a pace, as made by [`new`](Self::new) at the time and state at which it was taken.
    pub fn resume(&mut self, system: &mut impl System<T>, pace: Pace) {
        self.set_pace(pace);
        if self.known {
            // It is what the last step left: the same function of the same numbers.
            system.rate(self.time, &self.trial.to, &mut self.trial.end_slope);
        }
    }

    /// Where the motion is, s.
    pub fn time(&self) -> T {
        self.time
    }

    /// Where the last step began, s.
    pub fn last_start(&self) -> T {
        self.start
    }

    /// The state there.
    pub fn state(&self) -> &State<T> {
        &self.trial.to
    }

    /// How often the system was evaluated so far.
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// The state, to be changed at an event. The next step asks the system again how to go on.
    pub fn event(&mut self) -> &mut State<T> {
        self.known = false;
        &mut self.trial.to
    }

    /// One step, not beyond `limit` (s), and exactly to it when it is near.
    ///
    /// # Errors
    /// If the motion is not finite, or no step is short enough for the accuracy. The motion is where it was then.
    pub fn advance(&mut self, system: &mut impl System<T>, limit: T) -> Result<(), IntegrationError> {
        let remaining: f64 = (limit - self.time).into();
        if remaining <= 0.0 {
            return Ok(());
        }
        let Trial { to, end_slope, .. } = &mut self.trial;
        let counted = to.flat.len() - system.measured();
        if !self.known {
            system.rate(self.time, to, end_slope);
            self.evaluations += 1;
            self.known = true;
            self.control.begin(|| first_length(end_slope, to, counted, remaining, T::into));
        }
        self.trial.turn();
        let result = self.accepted(system, limit, counted);
        if result.is_err() {
            self.trial.turn();
        }
        result
    }

    /// The first step whose error in the first `counted` numbers is small enough.
    fn accepted(&mut self, system: &mut impl System<T>, limit: T, counted: usize) -> Result<(), IntegrationError> {
        let Self { trial, control, .. } = self;
        loop {
            let attempt = control.attempt(self.time, limit);
            trial.step(system, [attempt.start, attempt.length, attempt.end]);
            self.evaluations += trial.tableau().stages;
            trial.estimate(attempt.length, counted, control.accuracy(), |x, _| x.into());
            if control.judge(&attempt, trial.error(0))? {
                (self.start, self.length, self.time) = (attempt.start, attempt.length, attempt.end);
                return Ok(());
            }
        }
    }

    /// The state at `time` (s) within the last step.
    pub fn at(&mut self, system: &mut impl System<T>, time: T, state: &mut State<T>) {
        let theta = (time - self.start) / self.length;
        self.trial.interpolate(system, [self.start, self.length, theta], state);
    }

    /// Goes back to `time` (s) within the last step, whose states [`at`](Self::at) still knows: something happens there.
    pub fn cut(&mut self, system: &mut impl System<T>, time: T) {
        let mut state = self.trial.to.clone();
        self.at(system, time, &mut state);
        (self.time, self.trial.to, self.known) = (time, state, false);
    }
}
