//! A recording performed on blocks of states.

use frs_core::Quantity;
use ndarray::{ArrayView2, ArrayViewMut2};

use crate::group::Group;
use crate::instructions::Instructions;
use crate::perform::{Block, STATES};
use crate::recording::Recording;

/// A [`Recording`] at work, 32 states at a time: each of its operations is performed at all of them before the next one.
///
/// It allocates when it is made and never again.
#[derive(Clone, Debug)]
pub struct Blocks<'r> {
    recording: &'r Recording,
    instructions: Instructions,
    memory: Vec<Block>,
}

impl<'r> Blocks<'r> {
    pub(crate) fn new(recording: &'r Recording, instructions: Instructions) -> Self {
        let steps = &recording.steps;
        let mut memory = vec![Block::splat(0.0); steps.slots];
        memory.iter_mut().zip(&steps.constants).for_each(|(block, constant)| *block = Block::splat(*constant));
        Self { recording, instructions, memory }
    }

    /// The instructions that perform it; after an answer, those that did.
    pub fn instructions(&self) -> Instructions {
        self.instructions
    }
}

impl Group for Blocks<'_> {
    type Element = f64;

    fn states(&self) -> usize {
        STATES
    }

    fn dof(&self) -> usize {
        self.recording.dof
    }

    fn answers(&self, quantity: Quantity) -> bool {
        self.recording.quantity == quantity
    }

    fn answer(&mut self, quantity: Quantity, inputs: &[ArrayView2<'_, f64>], outputs: &mut [ArrayViewMut2<'_, f64>]) {
        assert!(self.answers(quantity), "this recording does not answer {}", quantity.name());
        let Recording { steps, entries, .. } = self.recording;
        let columns = inputs.iter().flat_map(|array| array.columns());
        for (block, column) in self.memory[steps.constants.len()..].iter_mut().zip(columns) {
            // What is missing is the last state once more.
            let last = column.len() - 1;
            let numbers = block.0.as_flattened_mut();
            numbers.iter_mut().enumerate().for_each(|(state, number)| *number = column[state.min(last)]);
        }
        self.instructions = self.instructions.perform(&steps.steps, &mut self.memory, &mut |output, block| {
            let [array, entry] = entries[output as usize];
            // Adding 0 makes 0 of −0.
            outputs[array].column_mut(entry).iter_mut().zip(block.0.as_flattened()).for_each(|(to, from)| *to = from + 0.0);
        });
    }
}
