//! Why nothing was compiled.

use cranelift_module::ModuleError;
use frs_codegen::GenerateError;
use frs_codegen::record::{Operation, Place};

/// Why nothing was compiled.
#[derive(Debug, thiserror::Error)]
pub enum JitError {
    /// This machine cannot be compiled for; the core answers on any.
    #[error("no code can be made for this machine while the program runs: {0}")]
    NoJit(String),
    /// An operation reads what is not there.
    #[error("place {place}: {operation:?} reads what is not there; expected earlier places and inputs below {inputs}")]
    Unknown {
        /// Where it stands.
        place: usize,
        /// What it is.
        operation: Operation,
        /// How many inputs there are.
        inputs: usize,
    },
    /// An operation that makes a vector or takes a number out of one.
    #[error("place {place}: {operation:?} is of vectors; expected operations on numbers; record over `Recorded`")]
    Vector {
        /// Where it stands.
        place: usize,
        /// What it is.
        operation: Operation,
    },
    /// An output that the recording does not hold.
    #[error("output {place}: the recording ends at {len}; expected a place of the recording")]
    NoPlace {
        /// What was asked for.
        place: Place,
        /// Number of operations.
        len: usize,
    },
    /// More than machine code can count.
    #[error("{len} {what} are too many; expected at most {most}; cut the recording into several")]
    TooMany {
        /// Of what.
        what: &'static str,
        /// How many.
        len: usize,
        /// How many there may be.
        most: usize,
    },
    /// A quantity of a robot that cannot be recorded as asked.
    #[error(transparent)]
    Record(#[from] GenerateError),
    /// The compiler refuses what it was given, or there is no memory for what it made.
    #[error("the operations could not be compiled: {0}")]
    Compiler(#[from] Box<ModuleError>),
}
