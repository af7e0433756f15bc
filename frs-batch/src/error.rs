//! Why a batch was not answered.

use frs_codegen::GenerateError;

/// Why a batch was not answered; nothing was written then.
#[derive(Debug, thiserror::Error)]
pub enum BatchError {
    /// The robot does not know the quantity.
    #[error("this robot does not answer {quantity}; expected a quantity for which it was made")]
    Unanswered {
        /// Name of the quantity.
        quantity: &'static str,
    },
    /// More or fewer arrays than the quantity lists.
    #[error("{quantity}: found {found} {side}; expected {expected}: {names}")]
    Arrays {
        /// Name of the quantity.
        quantity: &'static str,
        /// `inputs` or `outputs`.
        side: &'static str,
        /// How many arrays there are.
        found: usize,
        /// How many there must be.
        expected: usize,
        /// Their names.
        names: String,
    },
    /// An array of another shape.
    #[error("{quantity}: {name} has {} rows and {} columns; expected {} rows, a state each, of {} numbers", found[0], found[1], expected[0], expected[1])]
    Shape {
        /// Name of the quantity.
        quantity: &'static str,
        /// Name of the argument.
        name: &'static str,
        /// Rows and columns.
        found: [usize; 2],
        /// Rows and columns that it must have.
        expected: [usize; 2],
    },
    /// A quantity that cannot be recorded for this robot.
    #[error(transparent)]
    Record(#[from] GenerateError),
}
