//! A recording performed on blocks of states.

use frs_core::Quantity;
use ndarray::{ArrayView2, ArrayViewMut2, Axis};

use crate::group::Group;
use crate::instructions::Instructions;
use crate::perform::{Block, STATES, WIDTH};
use crate::recording::Recording;

/// A [`Recording`] at work, 32 states at a time: each of its operations is performed at all of them before the next one.
///
/// It allocates when it is made and never again.
#[derive(Clone, Debug)]
pub struct Blocks<'r> {
    recording: &'r Recording,
    instructions: Instructions,
    performed: Option<Instructions>,
    memory: Vec<Block>,
}

impl<'r> Blocks<'r> {
    pub(crate) fn new(recording: &'r Recording, instructions: Instructions) -> Self {
        let steps = &recording.steps;
        let mut memory = vec![Block::splat(0.0); steps.slots];
        memory.iter_mut().zip(&steps.constants).for_each(|(block, constant)| *block = Block::splat(*constant));
        Self { recording, instructions, performed: None, memory }
    }

    /// The instructions that it is to be performed by.
    pub fn instructions(&self) -> Instructions {
        self.instructions
    }

    /// Those that performed it last; none before the first answer.
    pub fn performed(&self) -> Option<Instructions> {
        self.performed
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
        let steps = &self.recording.steps;
        let columns = inputs.iter().flat_map(|array| array.columns());
        for (block, column) in self.memory[steps.constants.len()..].iter_mut().zip(columns) {
            // What is missing is the last state once more.
            let last = column.len() - 1;
            let numbers = block.0.as_flattened_mut();
            numbers.iter_mut().enumerate().for_each(|(state, number)| *number = column[state.min(last)]);
        }
        self.performed = Some(self.instructions.perform(&steps.steps, &mut self.memory));
        let mut slots = steps.outputs.as_slice();
        for array in outputs {
            let (of_array, rest) = slots.split_at(array.ncols());
            write(&self.memory, of_array, array);
            slots = rest;
        }
    }
}

/// Numbers of a state that are written at a time.
const TILE: usize = 64;

/// Writes the blocks in `slots`, a column each.
fn write(memory: &[Block], slots: &[u32], array: &mut ArrayViewMut2<'_, f64>) {
    // Adding 0 makes 0 of −0.
    if array.strides()[0] == 1 {
        for (mut column, &slot) in array.columns_mut().into_iter().zip(slots) {
            let numbers = memory[slot as usize].0.as_flattened();
            column.iter_mut().zip(numbers).for_each(|(entry, number)| *entry = number + 0.0);
        }
        return;
    }
    for (mut tile, slots) in array.axis_chunks_iter_mut(Axis(1), TILE).zip(slots.chunks(TILE)) {
        for (part, mut rows) in tile.axis_chunks_iter_mut(Axis(0), WIDTH).enumerate() {
            // Rows of a few states in the nearest cache, then each as it lies in the array.
            let mut states = [[0.0; TILE]; WIDTH];
            for (entry, &slot) in slots.iter().enumerate() {
                let numbers = memory[slot as usize].0[part];
                (0..WIDTH).for_each(|state| states[state][entry] = numbers[state] + 0.0);
            }
            for (mut row, state) in rows.rows_mut().into_iter().zip(&states) {
                match row.as_slice_mut() {
                    Some(entries) => entries.copy_from_slice(&state[..slots.len()]),
                    None => row.iter_mut().zip(state).for_each(|(entry, number)| *entry = *number),
                }
            }
        }
    }
}
