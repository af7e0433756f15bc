//! What can be wrong with a request.

use frs_core::model::SpecialiseError;

/// Why a robot could not be generated as asked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GenerateError {
    /// A quantity and the other options exclude each other.
    #[error("output '{output}': {reason}; expected momentum = driven; leave the output out, or choose that")]
    Excluded {
        /// The quantity.
        output: &'static str,
        /// Why.
        reason: &'static str,
    },
    /// A link that the robot does not have.
    #[error("link '{link}': the robot has no such link; expected one of: {known}; correct the name")]
    UnknownLink {
        /// What was asked for.
        link: String,
        /// What there is.
        known: String,
    },
    /// There are no lanes of this kind.
    #[error(
        "lanes: there is no type of {lanes} lanes of {element}; expected 1, 4 or 8 of f64, or 1, 8 or 16 of f32; choose one of these"
    )]
    Lanes {
        /// How many were asked for.
        lanes: usize,
        /// Of what.
        element: &'static str,
    },
    /// A form and another option exclude each other.
    #[error(
        "form: {form} and {other} exclude each other; expected one of the two; leave the other out, or write form = auto"
    )]
    Form {
        /// The form.
        form: &'static str,
        /// What it was to be combined with.
        other: &'static str,
    },
    /// A number of the robot, or a held value, that the scalar cannot hold.
    #[error(
        "{element}: a number of this robot is too large for it; expected finite numbers; choose f64, or smaller values"
    )]
    TooLarge {
        /// The scalar.
        element: &'static str,
    },
    /// A coordinate cannot be held, or a payload not be carried, as asked.
    #[error(transparent)]
    Specialise(#[from] SpecialiseError),
}
