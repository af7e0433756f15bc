//! A recording in the order in which it is performed, and where its values wait.

use std::collections::HashMap;

use frs_codegen::record::{Operation, Place};

use crate::fusion::Fusion;

/// What a step does with values a, b, c.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    /// a + b.
    Add,
    /// a − b.
    Sub,
    /// a · b.
    Mul,
    /// a / b.
    Div,
    /// a · b + c, rounded twice.
    MulAdd,
    /// a · b − c, rounded twice.
    MulSub,
    /// c − a · b, rounded twice.
    SubMul,
    /// a · b + c, rounded once.
    Fused,
    /// c − a · b, rounded once.
    FusedMinus,
    /// −a.
    Neg,
    /// √a.
    Sqrt,
    /// sin a, and cos a into the slot behind.
    Turn,
}

/// A step: what it does, the slots it reads, and the slot of its value.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// What it does.
    pub code: Code,
    /// Where its value goes.
    pub to: u32,
    /// What it reads, a, b, c; the first is there once more for what it does not need.
    pub from: [u32; 3],
}

/// The steps of a recording.
///
/// Slots hold the constants, then the inputs, then sines and cosines, then what else is computed; one of the last is taken again when nobody
/// reads its value any more. Outputs are read at the end.
#[derive(Clone, Debug)]
pub struct Steps {
    /// The steps.
    pub steps: Vec<Step>,
    /// The constants.
    pub constants: Vec<f64>,
    /// The slot of each output.
    pub outputs: Vec<u32>,
    /// Number of slots.
    pub slots: usize,
}

impl Steps {
    /// The steps that give `outputs` of `inputs` numbers.
    pub fn new(operations: &[Operation], outputs: &[Place], inputs: u32) -> Self {
        let fusion = Fusion::new(operations, outputs);
        let live = || (0..).zip(operations).filter(|&(place, _)| fusion.is_read(place));
        let mut slots: Vec<Option<u32>> = vec![None; operations.len()];
        let mut constants = Vec::new();
        for (place, operation) in live() {
            if let Operation::Constant(bits) = operation {
                slots[place as usize] = Some(constants.len() as u32);
                constants.push(f64::from_bits(*bits));
            }
        }
        let mut count = constants.len() as u32 + inputs;
        let mut turns: HashMap<Place, u32> = HashMap::new();
        let mut steps = Vec::new();
        for (place, &operation) in live() {
            match operation {
                Operation::Constant(_) => {}
                Operation::Input(number) => slots[place as usize] = Some(constants.len() as u32 + number),
                Operation::Sin(angle) | Operation::Cos(angle) => {
                    let sine = *turns.entry(angle).or_insert_with(|| {
                        steps.push(Step { code: Code::Turn, to: count, from: [angle; 3] });
                        count += 2;
                        count - 2
                    });
                    slots[place as usize] = Some(sine + u32::from(operation == Operation::Cos(angle)));
                }
                _ => steps.extend(fusion.step(place)),
            }
        }
        let count = lay(&mut steps, outputs, &mut slots, count);
        let outputs = outputs.iter().map(|&place| slots[place as usize].unwrap_or(0)).collect();
        Self { steps, constants, outputs, slots: count }
    }
}

/// Gives every step its slots instead of places: those known in `slots`, and from number `count` on those that are taken again. Returns the number
/// of all.
fn lay(steps: &mut [Step], outputs: &[Place], slots: &mut [Option<u32>], mut count: u32) -> usize {
    /// The step after which a slot is free: none, for what stays.
    const NEVER: usize = usize::MAX;
    let mut last = vec![NEVER; slots.len()];
    for (number, step) in steps.iter().enumerate() {
        let computed = step.from.iter().filter(|&&place| slots[place as usize].is_none());
        computed.for_each(|&place| last[place as usize] = number);
    }
    outputs.iter().for_each(|&place| last[place as usize] = NEVER);
    let mut free = Vec::new();
    for (number, step) in steps.iter_mut().enumerate() {
        let places = step.from;
        step.from = places.map(|place| slots[place as usize].unwrap_or(0));
        // A step reads everything before it writes: its value may go where it has read.
        for place in places {
            if last[place as usize] == number {
                // Read twice, it is given back once.
                last[place as usize] = NEVER;
                free.extend(slots[place as usize]);
            }
        }
        if step.code != Code::Turn {
            let slot = free.pop().unwrap_or_else(|| {
                count += 1;
                count - 1
            });
            slots[step.to as usize] = Some(slot);
            step.to = slot;
        }
    }
    count as usize
}
