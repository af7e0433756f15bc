//! What can be wrong with a robot, and how it is told: all problems at once, each with its place and a hint.

use std::fmt;
use std::sync::Arc;

use thiserror::Error;

/// Why a description is not a robot: every problem that was found, never just the first one.
///
/// ```
/// use frs_core::model::{InertialDescription, JointKind, RobotDescription};
/// let mut robot = RobotDescription::new("paper");
/// robot.link("base", InertialDescription::NONE);
/// robot.joint("hinge", JointKind::Revolute, "base", "lid").axis(0.0, 0.0, 0.0);
/// let error = robot.build().unwrap_err();
/// assert_eq!(error.problems().len(), 2);
/// assert!(error.to_string().starts_with("joint 'hinge': axis is 0 0 0; expected a direction;"));
/// ```
#[derive(Clone, Debug, Error)]
#[error("{}", Lines(.problems))]
pub struct ModelError {
    problems: Vec<Problem>,
}

impl ModelError {
    pub(crate) fn new(problems: Vec<Problem>) -> Self {
        Self { problems }
    }

    /// The problems; at least one is an error.
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }

    /// The problems, to keep.
    pub fn into_problems(self) -> Vec<Problem> {
        self.problems
    }
}

/// One thing that is wrong: where, what was found, what was expected, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Whether it stops the robot from being built.
    pub severity: Severity,
    /// The link or joint that has the problem.
    pub subject: Subject,
    /// Which part of the subject.
    pub part: Part,
    /// Where it stands in a file, if the robot came from one.
    pub place: Option<Place>,
    /// What was found.
    pub found: String,
    /// What was expected.
    pub expected: String,
    /// What to do about it.
    pub hint: String,
}

/// Whether a problem stops the robot from being built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// It does.
    Error,
    /// It does not: the problem travels with the model as [`Model::warnings`](super::Model::warnings).
    Warning,
}

/// Whom a problem is about; indices count in the order of the description.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The text the robot was to be read from.
    File,
    /// The robot as a whole.
    Robot,
    /// A link.
    Link {
        /// Position among the links.
        index: usize,
        /// Name.
        name: String,
    },
    /// A joint.
    Joint {
        /// Position among the joints.
        index: usize,
        /// Name.
        name: String,
    },
}

/// Which part of its subject a problem is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// The subject as a whole.
    Whole,
    /// Its name.
    Name,
    /// The mass of a link.
    Mass,
    /// The centre of mass of a link, with the orientation of its inertia.
    CentreOfMass,
    /// The rotational inertia of a link.
    Inertia,
    /// The kind of a joint.
    Kind,
    /// The parent of a joint.
    Parent,
    /// The child of a joint.
    Child,
    /// The origin of a joint.
    Origin,
    /// The axis of a joint.
    Axis,
    /// The limits of a joint.
    Limits,
    /// The damping and friction of a joint.
    Dynamics,
    /// The joint that a joint follows.
    Mimic,
}

/// A place in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Name of the file.
    pub file: Arc<str>,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

impl Problem {
    /// An error about a part of `subject`.
    pub(crate) fn error(
        subject: Subject,
        part: Part,
        found: impl Into<String>,
        expected: impl Into<String>,
        hint: impl Into<String>,
    ) -> Self {
        Self {
            severity: Severity::Error,
            subject,
            part,
            place: None,
            found: found.into(),
            expected: expected.into(),
            hint: hint.into(),
        }
    }

    /// The same problem as a warning.
    pub(crate) fn into_warning(self) -> Self {
        Self { severity: Severity::Warning, ..self }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = &self.place {
            write!(f, "{place}: ")?;
        }
        if self.severity == Severity::Warning {
            f.write_str("warning: ")?;
        }
        write!(f, "{}: {}; expected {}; {}", self.subject, self.found, self.expected, self.hint)
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => f.write_str("file"),
            Self::Robot => f.write_str("robot"),
            Self::Link { index, name } if name.is_empty() => write!(f, "link {index}"),
            Self::Joint { index, name } if name.is_empty() => write!(f, "joint {index}"),
            Self::Link { name, .. } => write!(f, "link '{name}'"),
            Self::Joint { name, .. } => write!(f, "joint '{name}'"),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// Problems, one a line.
pub(crate) struct Lines<'a>(pub &'a [Problem]);

impl fmt::Display for Lines<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, problem) in self.0.iter().enumerate() {
            if i > 0 {
                f.write_str("\n")?;
            }
            problem.fmt(f)?;
        }
        Ok(())
    }
}
