//! Folding and sharing that keep every finite result's bits.
//!
//! Each rule says why IEEE 754 (round to nearest) keeps the value. Signs of zero may change inside; outputs add 0 on both
//! sides, and no operation of the core turns the sign of a zero into another number.

use std::collections::HashMap;

use frs_core::Real;

use crate::record::{Operation, Place, Tape};

/// The precision in which constants are folded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// `f32`.
    Single,
    /// `f64`.
    #[default]
    Double,
}

impl Precision {
    /// The scalar's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::Double => "f64",
        }
    }
}

/// Operations without duplicates, in an order in which operands come first.
#[derive(Debug, Default)]
pub struct Graph {
    operations: Tape,
    places: HashMap<Operation, Place>,
    precision: Precision,
}

impl Graph {
    /// No operations yet; constants will be folded in `precision`.
    pub fn new(precision: Precision) -> Self {
        Self { precision, ..Self::default() }
    }

    /// The operations.
    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// The operation at `place`.
    pub fn operation(&self, place: Place) -> Operation {
        self.operations[place as usize]
    }

    /// Adds a recording; returns where each of its places went.
    pub fn absorb(&mut self, tape: &[Operation]) -> Vec<Place> {
        let mut map: Vec<Place> = Vec::with_capacity(tape.len());
        for &operation in tape {
            let at = |place: Place| map[place as usize];
            map.push(match operation {
                Operation::Input(_) => self.intern(operation),
                Operation::Constant(bits) => self.constant(f64::from_bits(bits)),
                Operation::Add(a, b) => self.add(at(a), at(b)),
                Operation::Sub(a, b) => self.sub(at(a), at(b)),
                Operation::Mul(a, b) => self.mul(at(a), at(b)),
                Operation::Div(a, b) => self.div(at(a), at(b)),
                Operation::MulAdd(a, b, c) => self.mul_add(at(a), at(b), at(c)),
                Operation::Neg(a) => self.neg(at(a)),
                Operation::Sqrt(a) => self.of_one(Operation::Sqrt(at(a)), at(a)),
                Operation::Sin(a) => self.of_one(Operation::Sin(at(a)), at(a)),
                Operation::Cos(a) => self.of_one(Operation::Cos(at(a)), at(a)),
            });
        }
        map
    }

    /// The constant at `place`, if it is one.
    pub fn constant_at(&self, place: Place) -> Option<f64> {
        match self.operation(place) {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Where `operation` stands: equal subexpressions are one.
    fn intern(&mut self, operation: Operation) -> Place {
        *self.places.entry(operation).or_insert_with(|| {
            self.operations.push(operation);
            (self.operations.len() - 1) as Place
        })
    }

    fn constant(&mut self, value: f64) -> Place {
        let value = match self.precision {
            Precision::Double => value,
            Precision::Single => f64::from(value as f32),
        };
        // One zero: its sign does not reach a result.
        self.intern(Operation::constant(value + 0.0))
    }

    /// a + b.
    fn add(&mut self, a: Place, b: Place) -> Place {
        if let Some(folded) = self.fold(Operation::Add(a, b)) {
            return folded;
        }
        match (self.sign(a), self.sign(b)) {
            // x + 0 = x.
            _ if self.is(a, 0.0) => b,
            _ if self.is(b, 0.0) => a,
            // Rounding is symmetric: (−a) + (−b) = −(a + b), a + (−b) = a − b.
            (Some(a), Some(b)) => {
                let sum = self.add(a, b);
                self.neg(sum)
            }
            (Some(a), None) => self.sub(b, a),
            (None, Some(b)) => self.sub(a, b),
            // a + b = b + a: one order, whichever was met first.
            (None, None) if self.places.contains_key(&Operation::Add(b, a)) => self.intern(Operation::Add(b, a)),
            (None, None) => self.intern(Operation::Add(a, b)),
        }
    }

    /// a − b.
    fn sub(&mut self, a: Place, b: Place) -> Place {
        if let Some(folded) = self.fold(Operation::Sub(a, b)) {
            return folded;
        }
        match (self.sign(a), self.sign(b)) {
            // x − 0 = x, 0 − x = −x, x − x = 0 for every finite x.
            _ if self.is(b, 0.0) => a,
            _ if self.is(a, 0.0) => self.neg(b),
            _ if a == b => self.constant(0.0),
            // a − (−b) = a + b, (−a) − b = −(a + b), (−a) − (−b) = b − a.
            (Some(a), Some(b)) => self.sub(b, a),
            (None, Some(b)) => self.add(a, b),
            (Some(a), None) => {
                let sum = self.add(a, b);
                self.neg(sum)
            }
            // a − b = −(b − a).
            (None, None) if self.places.contains_key(&Operation::Sub(b, a)) => {
                let other = self.intern(Operation::Sub(b, a));
                self.neg(other)
            }
            (None, None) => self.intern(Operation::Sub(a, b)),
        }
    }

    /// a · b.
    fn mul(&mut self, a: Place, b: Place) -> Place {
        if let Some(folded) = self.fold(Operation::Mul(a, b)) {
            return folded;
        }
        match (self.sign(a), self.sign(b)) {
            // x · 0 = 0 for every finite x, x · 1 = x.
            _ if self.is(a, 0.0) || self.is(b, 0.0) => self.constant(0.0),
            _ if self.is(a, 1.0) => b,
            _ if self.is(b, 1.0) => a,
            // The sign of a product is the product of the signs; its size does not depend on them.
            (Some(a), Some(b)) => self.mul(a, b),
            (Some(a), None) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (None, Some(b)) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (None, None) if self.places.contains_key(&Operation::Mul(b, a)) => self.intern(Operation::Mul(b, a)),
            (None, None) => self.intern(Operation::Mul(a, b)),
        }
    }

    /// a / b.
    fn div(&mut self, a: Place, b: Place) -> Place {
        if let Some(folded) = self.fold(Operation::Div(a, b)) {
            return folded;
        }
        match (self.sign(a), self.sign(b)) {
            // x / 1 = x.
            _ if self.is(b, 1.0) => a,
            // The sign of a quotient is the product of the signs.
            (Some(a), Some(b)) => self.div(a, b),
            (Some(a), None) => {
                let quotient = self.div(a, b);
                self.neg(quotient)
            }
            (None, Some(b)) => {
                let quotient = self.div(a, b);
                self.neg(quotient)
            }
            (None, None) => self.intern(Operation::Div(a, b)),
        }
    }

    /// a · b + c, rounded once.
    fn mul_add(&mut self, a: Place, b: Place, c: Place) -> Place {
        if let Some(folded) = self.fold(Operation::MulAdd(a, b, c)) {
            return folded;
        }
        match (self.sign(a), self.sign(b), self.sign(c)) {
            // x · 0 + y = y for every finite x, x · 1 + y = x + y, x · y + 0 = x · y.
            _ if self.is(a, 0.0) || self.is(b, 0.0) => c,
            _ if self.is(a, 1.0) => self.add(b, c),
            _ if self.is(b, 1.0) => self.add(a, c),
            _ if self.is(c, 0.0) => self.mul(a, b),
            // (−a) · (−b) = a · b, (−a) · b = a · (−b), and (−1) · b + c = c − b.
            (Some(a), Some(b), _) => self.mul_add(a, b, c),
            (Some(a), None, _) if self.is(a, 1.0) => self.sub(c, b),
            (Some(a), None, _) => {
                let b = self.neg(b);
                self.mul_add(a, b, c)
            }
            (None, Some(b), _) if self.is(b, 1.0) => self.sub(c, a),
            // Rounding is symmetric: a · (−b) + (−c) = −(a · b + c).
            (None, Some(b), Some(c)) => {
                let sum = self.mul_add(a, b, c);
                self.neg(sum)
            }
            // b · (−a) = a · (−b), b · a = a · b: one order, whichever was met first.
            (None, Some(positive), None) => {
                let minus_a = self.neg(a);
                self.either(Operation::MulAdd(positive, minus_a, c), Operation::MulAdd(a, b, c))
            }
            (None, None, _) => self.either(Operation::MulAdd(b, a, c), Operation::MulAdd(a, b, c)),
        }
    }

    /// −a.
    fn neg(&mut self, a: Place) -> Place {
        match self.operation(a) {
            Operation::Constant(bits) => self.constant(-f64::from_bits(bits)),
            Operation::Neg(b) => b,
            // −(a − b) = b − a.
            Operation::Sub(a, b) if self.places.contains_key(&Operation::Sub(b, a)) => {
                self.intern(Operation::Sub(b, a))
            }
            _ => self.intern(Operation::Neg(a)),
        }
    }

    /// A function of one number: folded where the number is known.
    fn of_one(&mut self, operation: Operation, a: Place) -> Place {
        match self.constant_at(a).map(|value| evaluate(operation, [value, 0.0, 0.0], self.precision)) {
            Some(value) if value.is_finite() => self.constant(value),
            _ => self.intern(operation),
        }
    }

    /// What `place` is the negative of, if it is written as one: −x, or a negative constant.
    fn sign(&mut self, place: Place) -> Option<Place> {
        match self.operation(place) {
            Operation::Neg(a) => Some(a),
            Operation::Constant(bits) if f64::from_bits(bits) < 0.0 => Some(self.constant(-f64::from_bits(bits))),
            _ => None,
        }
    }

    fn is(&self, place: Place, value: f64) -> bool {
        self.constant_at(place) == Some(value)
    }

    /// Two ways to write one number: the first if it stands there, else the second.
    fn either(&mut self, known: Operation, new: Operation) -> Place {
        if self.places.contains_key(&known) { self.intern(known) } else { self.intern(new) }
    }

    /// The result of an operation between constants, computed as it would be at run time.
    fn fold(&mut self, operation: Operation) -> Option<Place> {
        let mut numbers = [0.0; 3];
        for (number, operand) in numbers.iter_mut().zip(operation.operands()) {
            *number = self.constant_at(operand)?;
        }
        let value = evaluate(operation, numbers, self.precision);
        value.is_finite().then(|| self.constant(value))
    }
}

/// `operation` on known numbers, in `precision`.
fn evaluate(operation: Operation, numbers: [f64; 3], precision: Precision) -> f64 {
    match precision {
        Precision::Double => evaluate_over::<f64>(operation, numbers),
        Precision::Single => f64::from(evaluate_over::<f32>(operation, numbers.map(|number| number as f32))),
    }
}

fn evaluate_over<T: Real>(operation: Operation, [a, b, c]: [T; 3]) -> T {
    match operation {
        Operation::Add(..) => a + b,
        Operation::Sub(..) => a - b,
        Operation::Mul(..) => a * b,
        Operation::Div(..) => a / b,
        Operation::MulAdd(..) => a.mul_add(b, c),
        Operation::Sqrt(_) => a.sqrt(),
        Operation::Sin(_) => a.sin_cos().0,
        Operation::Cos(_) => a.sin_cos().1,
        _ => unreachable!("not an operation that is folded"),
    }
}
