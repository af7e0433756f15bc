//! What is wrong with a scene, and where.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use frs_core::model::Place;
use thiserror::Error;

/// One thing that is wrong: place, key, fact, expectation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Where.
    pub place: Place,
    /// The key with its table, as `regulator.stiffness`; empty for the whole file.
    pub key: String,
    /// What was found, what was expected, and perhaps a hint.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Place { file, line, column } = &self.place;
        let colon = if self.key.is_empty() { "" } else { ": " };
        write!(f, "{file}:{line}:{column}: {}{colon}{}", self.key, self.message)
    }
}

/// Everything that is wrong with a scene, in the order of the file.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub struct SceneError {
    /// At least one.
    pub problems: Vec<Problem>,
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, problem) in self.problems.iter().enumerate() {
            let newline = if i == 0 { "" } else { "\n" };
            write!(f, "{newline}{problem}")?;
        }
        Ok(())
    }
}

/// Where a span of the text begins.
pub(super) fn place(file: &str, text: &str, span: Range<usize>) -> Place {
    let before = text.get(..span.start).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    Place {
        file: Arc::from(file),
        line: before.matches('\n').count() + 1,
        column: before[line_start..].chars().count() + 1,
    }
}
