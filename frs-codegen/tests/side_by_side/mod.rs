//! Recordings of numbers and vectors, performed: every number is held in all lanes, so that vectors can stand beside it.

use frs_codegen::record::{Operation, Place, perform};
use frs_core::lanes::F64x4;

/// The value at every place; that of a number in all lanes.
pub fn replay(operations: &[Operation], inputs: &[f64]) -> Vec<F64x4> {
    let inputs: Vec<F64x4> = inputs.iter().copied().map(F64x4::splat).collect();
    let mut values: Vec<F64x4> = Vec::new();
    for &operation in operations {
        let lane = |place: Place, number: u8| values[place as usize].as_array()[usize::from(number)];
        values.push(match operation {
            Operation::Gather(numbers) => F64x4::from_array(numbers.map(|number| lane(number, 0))),
            Operation::Splat(number) => values[number as usize],
            Operation::Lane(vector, number) => F64x4::splat(lane(vector, number)),
            _ => perform(operation, &inputs, |place| values[place as usize]),
        });
    }
    values
}
