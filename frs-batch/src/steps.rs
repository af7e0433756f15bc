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
    /// −a.
    Neg,
    /// √a.
    Sqrt,
    /// sin a, and cos a into the slot behind.
    Turn,
    /// Output number `to` is a.
    Write,
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
/// reads its value any more.
#[derive(Clone, Debug)]
pub struct Steps {
    /// The steps.
    pub steps: Vec<Step>,
    /// The constants.
    pub constants: Vec<f64>,
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
        // Each with the place by which it is due.
        let mut steps: Vec<(Place, Step)> = Vec::new();
        for (place, &operation) in live() {
            match operation {
                Operation::Constant(_) => {}
                Operation::Input(number) => slots[place as usize] = Some(constants.len() as u32 + number),
                Operation::Sin(angle) | Operation::Cos(angle) => {
                    let sine = *turns.entry(angle).or_insert_with(|| {
                        steps.push((place, Step { code: Code::Turn, to: count, from: [angle; 3] }));
                        count += 2;
                        count - 2
                    });
                    slots[place as usize] = Some(sine + u32::from(operation == Operation::Cos(angle)));
                }
                _ => steps.extend(fusion.step(place).map(|step| (place, step))),
            }
        }
        let writes = (0..).zip(outputs);
        steps.extend(writes.map(|(to, &place)| (place, Step { code: Code::Write, to, from: [place; 3] })));
        // Stable: a value is written as soon as it is computed.
        steps.sort_by_key(|&(place, _)| place);
        let mut steps: Vec<Step> = steps.into_iter().map(|(_, step)| step).collect();
        let slots = lay(&mut steps, slots, count);
        Self { steps, constants, slots }
    }
}

/// Gives every step its slots instead of places: those known in `slots`, and from number `count` on those that are taken again. Returns their number.
fn lay(steps: &mut [Step], mut slots: Vec<Option<u32>>, mut count: u32) -> usize {
    let mut last = vec![0; slots.len()];
    for (number, step) in steps.iter().enumerate() {
        step.from.iter().for_each(|&place| last[place as usize] = number);
    }
    let kept: Vec<bool> = slots.iter().map(Option::is_some).collect();
    let mut free = Vec::new();
    for (number, step) in steps.iter_mut().enumerate() {
        // A step reads everything before it writes: its value may go where it has read.
        for place in step.from {
            if last[place as usize] == number && !kept[place as usize] {
                // Read twice, it is given back once.
                last[place as usize] = usize::MAX;
                free.extend(slots[place as usize]);
            }
        }
        step.from = step.from.map(|place| slots[place as usize].unwrap_or(0));
        if !matches!(step.code, Code::Write | Code::Turn) {
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
