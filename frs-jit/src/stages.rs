//! When an operation is due: sines and cosines are computed between two stages of machine code.

use frs_codegen::record::{Operation, Place};

/// The stages of a recording. A sine of a sine needs two pauses, and so three stages.
pub struct Stages {
    /// Number of stages.
    pub count: usize,
    /// Which operations the outputs stand on.
    pub live: Vec<bool>,
    /// The first stage in which each place can be read.
    pub known: Vec<usize>,
    /// The stage in which each place is computed, at the latest: before an angle that stands on it is turned.
    pub due: Vec<usize>,
}

impl Stages {
    /// The stages of what `outputs` stand on.
    pub fn new(operations: &[Operation], outputs: &[Place]) -> Self {
        let mut known = vec![0; operations.len()];
        for (place, operation) in operations.iter().enumerate() {
            let operands = operation.operands().map(|operand| known[operand as usize]).max().unwrap_or(0);
            known[place] = operands + usize::from(is_turned(*operation));
        }
        let last = outputs.iter().map(|&output| known[output as usize]).max().unwrap_or(0);
        let mut live = vec![false; operations.len()];
        outputs.iter().for_each(|&output| live[output as usize] = true);
        let mut due = vec![last; operations.len()];
        for place in (0..operations.len()).rev() {
            if live[place] {
                // What is turned is turned as soon as it can be.
                let stage = if is_turned(operations[place]) { known[place] - 1 } else { due[place] };
                for operand in operations[place].operands().map(|operand| operand as usize) {
                    live[operand] = true;
                    due[operand] = due[operand].min(stage);
                }
            }
        }
        Self { count: last + 1, live, known, due }
    }
}

/// Whether it is a sine or a cosine.
fn is_turned(operation: Operation) -> bool {
    matches!(operation, Operation::Sin(_) | Operation::Cos(_))
}
