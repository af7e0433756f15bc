//! Products that are computed by the sum that reads them: fewer steps, the same roundings.

use frs_codegen::record::{Operation, Place};

use crate::steps::{Code, Step};

/// Which operations of a recording are performed by others.
pub struct Fusion<'a> {
    operations: &'a [Operation],
    /// How often each place is read by what the outputs stand on.
    uses: Vec<u32>,
    /// Products that a sum or difference computes.
    absorbed: Vec<bool>,
}

impl<'a> Fusion<'a> {
    /// What `outputs` stand on.
    pub fn new(operations: &'a [Operation], outputs: &[Place]) -> Self {
        let mut uses = vec![0; operations.len()];
        outputs.iter().for_each(|&output| uses[output as usize] += 1);
        let mut absorbed = vec![false; operations.len()];
        for place in (0..operations.len()).rev() {
            if uses[place] > 0 {
                reads(operations, operations[place]).for_each(|operand| uses[operand as usize] += 1);
            }
        }
        let product =
            |place: Place| matches!(operations[place as usize], Operation::Mul(..)) && uses[place as usize] == 1;
        for (place, operation) in operations.iter().enumerate() {
            if let (Operation::Add(a, b) | Operation::Sub(a, b), true) = (*operation, uses[place] > 0) {
                // One of two.
                [b, a]
                    .into_iter()
                    .find(|&operand| product(operand))
                    .inspect(|&operand| absorbed[operand as usize] = true);
            }
        }
        Self { operations, uses, absorbed }
    }

    /// Whether an output stands on `place`.
    pub fn is_read(&self, place: Place) -> bool {
        self.uses[place as usize] > 0
    }

    /// The step that computes `place` of places; none where another step does, or where there is nothing to compute.
    pub fn step(&self, place: Place) -> Option<Step> {
        if self.absorbed[place as usize] {
            return None;
        }
        let (code, from) = match self.operations[place as usize] {
            Operation::Add(a, b) => match (self.product(a), self.product(b)) {
                (_, Some([x, y])) => (Code::MulAdd, [x, y, a]),
                (Some([x, y]), None) => (Code::MulAdd, [x, y, b]),
                (None, None) => (Code::Add, [a, b, a]),
            },
            Operation::Sub(a, b) => match (self.product(a), self.product(b)) {
                (_, Some([x, y])) => (Code::SubMul, [x, y, a]),
                (Some([x, y]), None) => (Code::MulSub, [x, y, b]),
                (None, None) => (Code::Sub, [a, b, a]),
            },
            Operation::Mul(a, b) => (Code::Mul, [a, b, a]),
            Operation::Div(a, b) => (Code::Div, [a, b, a]),
            Operation::MulAdd(a, b, c) => match negated(self.operations, b) {
                Some(b) => (Code::FusedMinus, [a, b, c]),
                None => (Code::Fused, [a, b, c]),
            },
            Operation::Neg(a) => (Code::Neg, [a; 3]),
            Operation::Sqrt(a) => (Code::Sqrt, [a; 3]),
            Operation::Input(_) | Operation::Constant(_) | Operation::Sin(_) | Operation::Cos(_) => return None,
            Operation::Gather(_) | Operation::Splat(_) | Operation::Lane(..) => {
                unreachable!("recordings over `Recorded` hold no vectors")
            }
        };
        Some(Step { code, to: place, from })
    }

    /// The factors of a product that the sum above it computes.
    fn product(&self, place: Place) -> Option<[Place; 2]> {
        match self.operations[place as usize] {
            Operation::Mul(a, b) if self.absorbed[place as usize] => Some([a, b]),
            _ => None,
        }
    }
}

/// The places that the step of an operation reads: a sign before the second factor is part of a fused step.
fn reads(operations: &[Operation], operation: Operation) -> impl Iterator<Item = Place> {
    let read = match operation {
        Operation::MulAdd(a, b, c) => Operation::MulAdd(a, negated(operations, b).unwrap_or(b), c),
        _ => operation,
    };
    read.operands()
}

/// What a place is the negative of.
fn negated(operations: &[Operation], place: Place) -> Option<Place> {
    match operations[place as usize] {
        Operation::Neg(a) => Some(a),
        _ => None,
    }
}
