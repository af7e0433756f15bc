//! What trajectories must be given.

use thiserror::Error;

use super::{Ensemble, Start};

/// Why trajectories were not integrated.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum EnsembleError {
    /// Steps cannot be chosen by this method.
    #[error("{method} estimates no error; expected a method that does; take dopri5 or dop853")]
    NoEstimate {
        /// Name of the method.
        method: &'static str,
    },
    /// The accuracy is not positive.
    #[error("accuracy is {found}; expected a positive number")]
    Accuracy {
        /// What was given.
        found: f64,
    },
    /// Times of samples are not in order.
    #[error("times[{number}] is {found} s; expected finite times, each later than the one before")]
    Times {
        /// The first that is not later.
        number: usize,
        /// What was given.
        found: f64,
    },
    /// A state of another system.
    #[error(
        "trajectory {trajectory}: the state has {found} numbers besides its pose; expected {expected}, as the system has"
    )]
    Dimension {
        /// Number of the trajectory.
        trajectory: usize,
        /// How many there are.
        found: usize,
        /// How many there must be.
        expected: usize,
    },
    /// A start that is not finite.
    #[error("trajectory {trajectory}: {what} is {found}; expected a finite number")]
    NotFinite {
        /// Number of the trajectory.
        trajectory: usize,
        /// Which number.
        what: String,
        /// What was given.
        found: f64,
    },
    /// A trajectory that goes back.
    #[error(
        "trajectory {trajectory}: it ends at {until} s and begins at {from} s; expected an end that is not before the start"
    )]
    Backwards {
        /// Number of the trajectory.
        trajectory: usize,
        /// Its start, s.
        from: f64,
        /// Its end, s.
        until: f64,
    },
}

/// Checks how to integrate.
pub(super) fn ensemble(ensemble: &Ensemble) -> Result<(), EnsembleError> {
    let Ensemble { tableau, accuracy, times } = ensemble;
    if tableau.error_order == 0 {
        return Err(EnsembleError::NoEstimate { method: tableau.name });
    }
    if !(accuracy.is_finite() && *accuracy > 0.0) {
        return Err(EnsembleError::Accuracy { found: *accuracy });
    }
    let mut before = f64::NEG_INFINITY;
    for (number, &found) in times.iter().enumerate() {
        if !(found.is_finite() && found > before) {
            return Err(EnsembleError::Times { number, found });
        }
        before = found;
    }
    Ok(())
}

/// Checks the starts of a system with `expected` numbers.
pub(super) fn starts(starts: &[Start], expected: usize) -> Result<(), EnsembleError> {
    for (trajectory, start) in starts.iter().enumerate() {
        let Start { state, from, until } = start;
        let found = state.flat.len();
        if found != expected {
            return Err(EnsembleError::Dimension { trajectory, found, expected });
        }
        if let Some((what, found)) = not_finite(start) {
            return Err(EnsembleError::NotFinite { trajectory, what, found });
        }
        if until < from {
            return Err(EnsembleError::Backwards { trajectory, from: *from, until: *until });
        }
    }
    Ok(())
}

/// The first number of a start that is not finite, and which one it is.
fn not_finite(start: &Start) -> Option<(String, f64)> {
    let named = |name: &str, numbers: &[f64]| {
        let place = numbers.iter().position(|number| !number.is_finite())?;
        Some((format!("{name}[{place}]"), numbers[place]))
    };
    let Start { state, from, until } = start;
    named("state.flat", &state.flat)
        .or_else(|| named("state.pose.translation", state.pose.translation.as_slice()))
        .or_else(|| named("state.pose.rotation", state.pose.rotation.as_slice()))
        .or_else(|| (!from.is_finite()).then(|| ("from".to_owned(), *from)))
        .or_else(|| (!until.is_finite()).then(|| ("until".to_owned(), *until)))
}
