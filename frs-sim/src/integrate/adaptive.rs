//! Steps as long as the asked accuracy allows.

use frs_core::Real;
use thiserror::Error;

use super::{Explicit, State, System, Tableau, Tangent};

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
    method: Explicit<T>,
    accuracy: f64,
    /// Start of the last step, its length, and the state there.
    start: T,
    length: T,
    before: State<T>,
    /// Where the motion is.
    time: T,
    state: State<T>,
    tangent: Tangent<T>,
    /// Whether `tangent` belongs to `state`.
    known: bool,
    /// Length of the next step, 0 before the first.
    next: f64,
    /// Error of the step before, in units of the accuracy.
    error: f64,
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

/// A step is tried that should give this share of the allowed error, for the estimate is one.
const SAFETY: f64 = 0.9;

/// How much shorter or longer than the last one a step may be.
const SHRINK: f64 = 0.2;
const GROW: f64 = 6.0;

/// How much the error of the step before counts: damps steps that oscillate (Hairer, Wanner, §IV.2).
const MEMORY: f64 = 0.04;

/// A step that would leave less than this share of itself before the limit goes to the limit.
const STRETCH: f64 = 1e-2;

/// DOP853 weighs its error of order 3 by this against the one of order 5.
const LOWER_ERROR: f64 = 0.01;

impl<T: Real + Into<f64>> Adaptive<T> {
    /// The motion from `state` at `time` (s).
    ///
    /// # Panics
    /// If the method estimates no error, or `accuracy` is not positive.
    pub fn new(tableau: &'static Tableau, state: State<T>, time: T, accuracy: f64) -> Self {
        assert!(tableau.error_order > 0, "{} estimates no error", tableau.name);
        assert!(accuracy > 0.0, "the accuracy must be positive");
        let dimension = state.flat.len();
        Self {
            method: Explicit::new(tableau, dimension),
            accuracy,
            start: time,
            length: T::zero(),
            before: state.clone(),
            time,
            state,
            tangent: Tangent::zero(dimension),
            known: false,
            next: 0.0,
            error: 1.0,
            evaluations: 0,
        }
    }

    /// What it takes to go on from the present time and state.
    pub fn pace(&self) -> Pace {
        Pace { next: self.next, error: self.error, smooth: self.known, evaluations: self.evaluations }
    }

    /// The pace alone, which must not be smooth: then the next step asks the system how to go on.
    pub(crate) fn set_pace(&mut self, pace: Pace) {
        (self.next, self.error, self.known, self.evaluations) = (pace.next, pace.error, pace.smooth, pace.evaluations);
    }

    /// Goes on at a pace, as made by [`new`](Self::new) at the time and state at which it was taken.
    pub fn resume(&mut self, system: &mut impl System<T>, pace: Pace) {
        self.set_pace(pace);
        if self.known {
            // It is what the last step left: the same function of the same numbers.
            system.rate(self.time, &self.state, &mut self.tangent);
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
        &self.state
    }

    /// How often the system was evaluated so far.
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// The state, to be changed at an event. The next step asks the system again how to go on.
    pub fn event(&mut self) -> &mut State<T> {
        self.known = false;
        &mut self.state
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
        if !self.known {
            system.rate(self.time, &self.state, &mut self.tangent);
            self.evaluations += 1;
            (self.known, self.error) = (true, 1.0);
            if self.next == 0.0 {
                self.next = self.first_length(remaining, self.state.flat.len() - system.measured());
            }
        }
        std::mem::swap(&mut self.before, &mut self.state);
        let result = self.accepted(system, limit, remaining);
        if result.is_err() {
            std::mem::swap(&mut self.before, &mut self.state);
        }
        result
    }

    /// From `before` into `state` by the first step whose error is small enough.
    fn accepted(&mut self, system: &mut impl System<T>, limit: T, remaining: f64) -> Result<(), IntegrationError> {
        let order = self.method.tableau().error_order as f64;
        let (start, time): (T, f64) = (self.time, self.time.into());
        let shortest = 16.0 * f64::EPSILON * time.abs().max(remaining);
        let mut end_tangent = self.tangent.clone();
        let counted = self.state.flat.len() - system.measured();
        loop {
            let last = self.next * (1.0 + STRETCH) >= remaining;
            let length = if last { limit - start } else { T::from_f64(self.next) };
            let end = if last { limit } else { start + length };
            self.method.first_slope().clone_from(&self.tangent);
            self.method.step_on(system, start, length, &self.before, &mut self.state);
            self.method.end_slope(system, end, &self.state, &mut end_tangent);
            self.evaluations += self.method.tableau().stages;
            let error = self.step_error(length, counted);
            let h: f64 = length.into();
            if error <= 1.0 {
                let factor = SAFETY * error.max(1e-12).powf(MEMORY - 1.0 / order) * self.error.powf(-MEMORY);
                // A step cut short by the limit says little about the next one.
                let proposed = h * factor.clamp(SHRINK, GROW);
                self.next = if last { proposed.max(self.next) } else { proposed };
                self.error = error.max(1e-4);
                (self.start, self.length, self.time) = (start, length, end);
                self.tangent = end_tangent;
                return Ok(());
            }
            if h <= shortest {
                return Err(match error.is_finite() {
                    true => IntegrationError::StepTooSmall { time, step: h, accuracy: self.accuracy },
                    false => IntegrationError::NotFinite { time },
                });
            }
            let factor = if error.is_finite() { (SAFETY * error.powf(-1.0 / order)).max(SHRINK) } else { 0.1 };
            self.next = h * factor;
        }
    }

    /// The state at `time` (s) within the last step.
    pub fn at(&mut self, system: &mut impl System<T>, time: T, state: &mut State<T>) {
        let theta = (time - self.start) / self.length;
        self.method.interpolate(system, self.start, self.length, &self.before, theta, state);
    }

    /// Goes back to `time` (s) within the last step, whose states [`at`](Self::at) still knows: something happens there.
    pub fn cut(&mut self, system: &mut impl System<T>, time: T) {
        let mut state = self.state.clone();
        self.at(system, time, &mut state);
        (self.time, self.state, self.known) = (time, state, false);
    }

    /// Estimated error of the step just made in the first `counted` numbers, in units of what is allowed; infinite where it is no number.
    fn step_error(&mut self, h: T, counted: usize) -> f64 {
        let Self { method, before, state, accuracy, .. } = self;
        let mut squares = [0.0; 2];
        let mut row = 0;
        method.errors(h, |error| {
            squares[row] = mean_square(error, before, state, counted, *accuracy);
            row += 1;
        });
        let error = match row {
            1 => squares[0].sqrt(),
            _ if squares[0] == 0.0 => 0.0,
            _ => squares[0] / (squares[0] + LOWER_ERROR * squares[1]).sqrt(),
        };
        if error.is_finite() { error } else { f64::INFINITY }
    }

    /// A first step by which an Euler step would move states by a hundredth of their size.
    fn first_length(&self, remaining: f64, counted: usize) -> f64 {
        let origin = State::origin(self.state.flat.len());
        let speed = mean_square(&self.tangent, &self.state, &origin, counted, 1.0).sqrt();
        let length = if speed > 0.0 { 0.01 / speed } else { remaining };
        if length.is_finite() { length.min(remaining) } else { remaining }
    }
}

/// Mean square of a step's entries with its first `counted` numbers, each in units of `accuracy·max(1, |x|)`.
fn mean_square<T: Real + Into<f64>>(
    step: &Tangent<T>,
    from: &State<T>,
    to: &State<T>,
    counted: usize,
    accuracy: f64,
) -> f64 {
    let mut sum = 0.0;
    let mut add = |value: T, sizes: [T; 2]| {
        let [size, other] = sizes.map(|size| size.into().abs());
        let scaled = value.into() / (accuracy * size.max(other).max(1.0));
        sum += scaled * scaled;
    };
    for angle in step.twist.angular.iter() {
        add(*angle, [T::zero(); 2]);
    }
    for (i, &x) in step.twist.linear.iter().enumerate() {
        add(x, [from.pose.translation[i], to.pose.translation[i]]);
    }
    for (i, &x) in step.flat[..counted].iter().enumerate() {
        add(x, [from.flat[i], to.flat[i]]);
    }
    sum / (6 + counted) as f64
}
