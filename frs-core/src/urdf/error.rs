//! Why a text is not a robot.

use thiserror::Error;

use crate::model::{Lines, Problem};

/// Why a URDF is not a robot: every problem that was found, in the order of the text, each with its
/// [`place`](Problem::place).
#[derive(Clone, Debug, Error)]
#[error("{}", Lines(.problems))]
pub struct UrdfError {
    problems: Vec<Problem>,
}

impl UrdfError {
    pub(super) fn new(problems: Vec<Problem>) -> Self {
        Self { problems }
    }

    /// The problems; at least one is an error.
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }
}
