//! What became of trajectories.

use crate::integrate::{IntegrationError, State};

/// Where a trajectory is at its end, and what it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrival {
    /// The state at `time`.
    pub state: State,
    /// The end of the trajectory, or the time at which it could not be continued, s.
    pub time: f64,
    /// Steps made.
    pub steps: usize,
    /// Steps tried in vain, because their error was too large.
    pub rejected: usize,
    /// How often the system was evaluated for its steps.
    pub evaluations: usize,
    /// The states at [`Ensemble::times`](super::Ensemble::times).
    pub samples: Vec<Sample>,
    /// Whether it arrived, or why not.
    pub end: Result<(), IntegrationError>,
}

/// A trajectory at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// s.
    pub time: f64,
    /// The state there.
    pub state: State,
}

/// What became of all trajectories.
#[derive(Clone, Debug, PartialEq)]
pub struct Flown {
    /// The end of each trajectory, in the order of their starts.
    pub arrivals: Vec<Arrival>,
    /// How often the lanes of a thread tried a step together.
    pub passes: usize,
    /// Lanes of a thread.
    pub lanes: usize,
}

/// What a thread computed.
pub(super) struct Part {
    /// Numbers of trajectories, and their ends.
    pub arrivals: Vec<(usize, Arrival)>,
    pub passes: usize,
}

impl Flown {
    pub(super) fn of(parts: Vec<Part>, lanes: usize) -> Self {
        let passes = parts.iter().map(|part| part.passes).sum();
        let mut arrivals: Vec<_> = parts.into_iter().flat_map(|part| part.arrivals).collect();
        arrivals.sort_unstable_by_key(|(number, _)| *number);
        Self { arrivals: arrivals.into_iter().map(|(_, arrival)| arrival).collect(), passes, lanes }
    }

    /// Share of the lanes that had a trajectory, as the mean over all passes; 1 where there was none. On several threads it depends on who
    /// was faster.
    pub fn occupancy(&self) -> f64 {
        share(self.tried(), self.passes * self.lanes).unwrap_or(1.0)
    }

    /// Share of the steps that were tried in vain; 0 where there was none.
    pub fn rejected(&self) -> f64 {
        share(self.arrivals.iter().map(|arrival| arrival.rejected).sum(), self.tried()).unwrap_or(0.0)
    }

    fn tried(&self) -> usize {
        self.arrivals.iter().map(|arrival| arrival.steps + arrival.rejected).sum()
    }
}

fn share(part: usize, whole: usize) -> Option<f64> {
    (whole > 0).then(|| part as f64 / whole as f64)
}
