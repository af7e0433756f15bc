//! In which order operations are performed, which values wait in memory, and where machine code pauses for sines.

use std::collections::HashMap;

use frs_codegen::record::{Operation, Place};

use crate::stages::Stages;

/// Steps of one function of machine code: allocating registers takes more than linear time in a long one.
const PART: usize = 8000;

/// Steps over which a value keeps a register; whoever reads it later loads it. Processors have 16 or 32 registers, and an
/// operand in memory costs nearly nothing: the allocator's own spills, which take an instruction each, then stay rare.
const REACH: usize = 32;

/// What machine code does next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// An operation; its value goes to its slot, too, if it has one.
    Perform(Place),
    /// A value comes back from its slot.
    Load(Place),
    /// A value is written to an output.
    Write(Place, usize),
    /// A value is written to a slot, as an angle.
    Aim(Place, usize),
}

/// An angle whose sine and cosine are computed between two parts: their slots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turn {
    /// Where the angle is.
    pub angle: usize,
    /// Where its sine goes.
    pub sine: usize,
    /// Where its cosine goes.
    pub cosine: usize,
}

/// Straight-line code, and the angles that are turned after it.
#[derive(Debug, Default)]
pub struct Part {
    /// The code.
    pub steps: Vec<Step>,
    /// The angles.
    pub turns: Vec<Turn>,
}

/// An order of performing operations.
#[derive(Debug)]
pub struct Order {
    /// What is done.
    pub parts: Vec<Part>,
    /// The slot of each place that has one.
    pub slots: Vec<Option<usize>>,
    /// Number of slots.
    pub memory: usize,
}

impl Order {
    /// Orders what `outputs` stand on: as recorded, but what an angle stands on goes before the angle is turned.
    pub fn new(operations: &[Operation], outputs: &[Place]) -> Self {
        let stages = Stages::new(operations, outputs);
        let mut laid = Laying::new(operations);
        let mut steps: Vec<(usize, Place, Step)> = Vec::new();
        let mut turns: Vec<Vec<(Place, Turn)>> = vec![Vec::new(); stages.count];
        let mut turned: HashMap<Place, Turn> = HashMap::new();
        for place in (0..).take(operations.len()).filter(|&place| stages.live[place as usize]) {
            match operations[place as usize] {
                Operation::Input(_) | Operation::Constant(_) => {}
                operation @ (Operation::Sin(angle) | Operation::Cos(angle)) => {
                    let turn = *turned.entry(angle).or_insert_with(|| {
                        let turn = Turn { angle: laid.slot(), sine: laid.slot(), cosine: laid.slot() };
                        turns[stages.known[angle as usize]].push((angle, turn));
                        turn
                    });
                    let slot = if operation == Operation::Sin(angle) { turn.sine } else { turn.cosine };
                    laid.order.slots[place as usize] = Some(slot);
                }
                _ => steps.push((stages.due[place as usize], place, Step::Perform(place))),
            }
        }
        for (output, &place) in outputs.iter().enumerate() {
            steps.push((stages.due[place as usize], place, Step::Write(place, output)));
        }
        // Stable: a value is written after it is computed.
        steps.sort_by_key(|&(stage, place, _)| (stage, place));
        let mut steps = steps.into_iter().peekable();
        for (stage, turns) in turns.into_iter().enumerate() {
            while let Some((_, _, step)) = steps.next_if(|&(due, ..)| due == stage) {
                laid.step(step);
            }
            for (place, turn) in turns {
                laid.step(Step::Aim(place, turn.angle));
                laid.part.turns.push(turn);
            }
            laid.end();
        }
        laid.order
    }
}

/// An order that is being written down.
struct Laying<'a> {
    operations: &'a [Operation],
    order: Order,
    part: Part,
    /// Where each place was computed or read last: number of the part, and of the step among all.
    touched: Vec<(usize, usize)>,
    steps: usize,
}

impl<'a> Laying<'a> {
    fn new(operations: &'a [Operation]) -> Self {
        let order = Order { parts: Vec::new(), slots: vec![None; operations.len()], memory: 0 };
        // No part has this number: what nobody touched is in no register.
        let touched = vec![(usize::MAX, 0); operations.len()];
        Self { operations, order, part: Part::default(), touched, steps: 0 }
    }

    fn slot(&mut self) -> usize {
        self.order.memory += 1;
        self.order.memory - 1
    }

    fn step(&mut self, step: Step) {
        self.steps += 1;
        match step {
            Step::Perform(place) => {
                self.operations[place as usize].operands().for_each(|operand| self.read(operand));
                self.touch(place);
            }
            Step::Write(place, _) | Step::Aim(place, _) => self.read(place),
            Step::Load(_) => {}
        }
        self.part.steps.push(step);
        if self.part.steps.len() >= PART {
            self.end();
        }
    }

    /// Sees to it that `place` is in a register; inputs and constants are, whenever they are asked for.
    fn read(&mut self, place: Place) {
        if matches!(self.operations[place as usize], Operation::Input(_) | Operation::Constant(_)) {
            return;
        }
        let (part, step) = self.touched[place as usize];
        if part != self.order.parts.len() || self.steps - step > REACH {
            if self.order.slots[place as usize].is_none() {
                self.order.slots[place as usize] = Some(self.slot());
            }
            self.part.steps.push(Step::Load(place));
        }
        self.touch(place);
    }

    fn touch(&mut self, place: Place) {
        self.touched[place as usize] = (self.order.parts.len(), self.steps);
    }

    fn end(&mut self) {
        self.order.parts.push(std::mem::take(&mut self.part));
    }
}
