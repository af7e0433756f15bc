//! How long steps are, by the errors of those before.

use frs_core::Real;

use super::IntegrationError;

/// A step is tried that should give this share of the allowed error, for the estimate is one.
const SAFETY: f64 = 0.9;

/// How much shorter or longer than the last one a step may be.
const SHRINK: f64 = 0.2;
const GROW: f64 = 6.0;

/// How much the error of the step before counts: damps steps that oscillate (Hairer, Wanner, §IV.2).
const MEMORY: f64 = 0.04;

/// A step that would leave less than this share of itself before the limit goes to the limit.
const STRETCH: f64 = 1e-2;

/// The lengths of the steps of one motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Control {
    /// Length of the next step, 0 before the first.
    pub next: f64,
    /// Error of the step before, in units of the accuracy.
    pub error: f64,
    /// Power of the length in the estimated error of a step.
    order: f64,
    accuracy: f64,
}

/// A step to be tried.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Attempt<T: Real = f64> {
    /// Where it begins, s.
    pub start: T,
    /// Its length, s.
    pub length: T,
    /// Where it ends, s.
    pub end: T,
    /// From its start to the limit, s.
    remaining: f64,
    /// Whether it goes to the limit.
    last: bool,
}

impl Control {
    /// Before the first step of a motion, by a method whose estimate has this order.
    pub fn new(order: usize, accuracy: f64) -> Self {
        Self { next: 0.0, error: 1.0, order: order as f64, accuracy }
    }

    /// What is allowed.
    pub fn accuracy(&self) -> f64 {
        self.accuracy
    }

    /// The motion goes on otherwise than before; if it has made no step yet, with one of length `first` (s).
    pub fn begin(&mut self, first: impl FnOnce() -> f64) {
        self.error = 1.0;
        if self.next == 0.0 {
            self.next = first();
        }
    }

    /// The next step from `start`, not beyond `limit`, and exactly to it when it is near (s).
    pub fn attempt<T: Real + Into<f64>>(&self, start: T, limit: T) -> Attempt<T> {
        let remaining: f64 = (limit - start).into();
        let last = self.next * (1.0 + STRETCH) >= remaining;
        let length = if last { limit - start } else { T::from_f64(self.next) };
        let end = if last { limit } else { start + length };
        Attempt { start, length, end, remaining, last }
    }

    /// Whether a step that was tried is made, by its error in units of the accuracy; if not, the next one is shorter.
    ///
    /// # Errors
    /// If none is short enough.
    pub fn judge<T: Real + Into<f64>>(&mut self, tried: &Attempt<T>, error: f64) -> Result<bool, IntegrationError> {
        let (time, h): (f64, f64) = (tried.start.into(), tried.length.into());
        if error <= 1.0 {
            let factor = SAFETY * error.max(1e-12).powf(MEMORY - 1.0 / self.order) * self.error.powf(-MEMORY);
            // A step cut short by the limit says little about the next one.
            let proposed = h * factor.clamp(SHRINK, GROW);
            self.next = if tried.last { proposed.max(self.next) } else { proposed };
            self.error = error.max(1e-4);
            return Ok(true);
        }
        if h <= 16.0 * f64::EPSILON * time.abs().max(tried.remaining) {
            return Err(match error.is_finite() {
                true => IntegrationError::StepTooSmall { time, step: h, accuracy: self.accuracy },
                false => IntegrationError::NotFinite { time },
            });
        }
        let factor = if error.is_finite() { (SAFETY * error.powf(-1.0 / self.order)).max(SHRINK) } else { 0.1 };
        self.next = h * factor;
        Ok(false)
    }
}
