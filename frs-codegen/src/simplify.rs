//! Folding and sharing that keep every finite result's bits.
//!
//! Each rule says why IEEE 754 (round to nearest) keeps the value. Signs of zero may change inside; outputs add 0 on both
//! sides, and no operation of the core turns the sign of a zero into another number.

use std::collections::HashMap;

use frs_core::Real;

use crate::record::{Operation, Place, Tape, WIDTH};

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
    /// Whether a place is a vector.
    vectors: Vec<bool>,
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
                Operation::Gather(numbers) => self.gather(numbers.map(at)),
                Operation::Splat(a) => self.splat(at(a)),
                Operation::Lane(a, number) => self.lane(at(a), number),
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

    /// Whether `place` is a vector.
    pub fn is_vector(&self, place: Place) -> bool {
        self.vectors[place as usize]
    }

    /// Whether `place` is a vector of constants.
    pub fn is_table(&self, place: Place) -> bool {
        match self.operation(place) {
            Operation::Gather(numbers) => numbers.iter().all(|&number| self.constant_at(number).is_some()),
            _ => false,
        }
    }

    /// Where `operation` stands: equal subexpressions are one.
    fn intern(&mut self, operation: Operation) -> Place {
        *self.places.entry(operation).or_insert_with(|| {
            self.vectors.push(match operation {
                Operation::Gather(_) | Operation::Splat(_) => true,
                Operation::Lane(..) => false,
                _ => operation.operands().any(|operand| self.vectors[operand as usize]),
            });
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
            _ if a == b => {
                let zero = self.constant(0.0);
                if self.is_vector(a) { self.splat(zero) } else { zero }
            }
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
            _ if self.is(a, 0.0) => a,
            _ if self.is(b, 0.0) => b,
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

    /// The vector of these numbers.
    fn gather(&mut self, numbers: [Place; WIDTH]) -> Place {
        let lanes = numbers.map(|number| self.operation(number));
        let signs = numbers.map(|number| self.sign(number));
        match (lanes, signs) {
            // One number in all lanes.
            _ if numbers == [numbers[0]; WIDTH] => self.splat(numbers[0]),
            // All lanes of a vector are the vector.
            ([Operation::Lane(vector, _), ..], _)
                if (0..).zip(lanes).all(|(number, lane)| lane == Operation::Lane(vector, number)) =>
            {
                vector
            }
            // Lanes turn their signs together.
            (_, [Some(a), Some(b), Some(c), Some(d)]) => {
                let vector = self.gather([a, b, c, d]);
                self.neg(vector)
            }
            _ => self.intern(Operation::Gather(numbers)),
        }
    }

    /// The vector of the number `a` alone.
    fn splat(&mut self, a: Place) -> Place {
        match self.sign(a) {
            Some(a) => {
                let vector = self.splat(a);
                self.neg(vector)
            }
            None => self.intern(Operation::Splat(a)),
        }
    }

    /// Number `number` of the vector `a`.
    fn lane(&mut self, a: Place, number: u8) -> Place {
        match self.operation(a) {
            Operation::Gather(numbers) => numbers[usize::from(number)],
            Operation::Splat(a) => a,
            // Lanes turn their signs together.
            Operation::Neg(a) => {
                let number = self.lane(a, number);
                self.neg(number)
            }
            _ => self.intern(Operation::Lane(a, number)),
        }
    }

    /// A function of one number: folded where the number is known.
    fn of_one(&mut self, operation: Operation, a: Place) -> Place {
        if let (Operation::Sqrt(_), Operation::Splat(a)) = (operation, self.operation(a)) {
            let root = self.of_one(Operation::Sqrt(a), a);
            return self.splat(root);
        }
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

    /// Whether `place` is the constant `value`, or a vector of nothing else.
    fn is(&self, place: Place, value: f64) -> bool {
        match self.operation(place) {
            Operation::Splat(a) => self.is(a, value),
            _ => self.constant_at(place) == Some(value),
        }
    }

    /// Two ways to write one number: the first if it stands there, else the second.
    fn either(&mut self, known: Operation, new: Operation) -> Place {
        if self.places.contains_key(&known) { self.intern(known) } else { self.intern(new) }
    }

    /// The result of an operation between constants, computed as it would be at run time. An operation on vectors of one number each is one on
    /// the numbers, and one on numbers of the same lane is one on their vectors: each lane keeps its own.
    fn fold(&mut self, operation: Operation) -> Option<Place> {
        let places: Vec<Place> = operation.operands().collect();
        let operands: Vec<Operation> = places.iter().map(|&place| self.operation(place)).collect();
        let numbers: Option<Vec<f64>> = places.iter().map(|&place| self.constant_at(place)).collect();
        if let Some(numbers) = numbers {
            let mut three = [0.0; 3];
            three[..numbers.len()].copy_from_slice(&numbers);
            let value = evaluate(operation, three, self.precision);
            return value.is_finite().then(|| self.constant(value));
        }
        let alone = |operand: &Operation| if let Operation::Splat(a) = operand { Some(*a) } else { None };
        if let Some(numbers) = operands.iter().map(alone).collect::<Option<Vec<Place>>>() {
            let number = self.of(operation, &numbers);
            return Some(self.splat(number));
        }
        // Once for all lanes. A division is not: its time grows with the lanes.
        let lane = operands
            .iter()
            .find_map(|operand| if let Operation::Lane(_, lane) = operand { Some(*lane) } else { None })?;
        let same = |operand: &Operation| match operand {
            Operation::Lane(_, other) => *other == lane,
            Operation::Constant(_) => true,
            _ => false,
        };
        if matches!(operation, Operation::Div(..)) || !operands.iter().all(same) {
            return None;
        }
        let vectors: Vec<Place> = (operands.iter().zip(&places))
            .map(|(operand, &place)| if let Operation::Lane(vector, _) = operand { *vector } else { self.splat(place) })
            .collect();
        let vector = self.of(operation, &vectors);
        Some(self.lane(vector, lane))
    }

    /// `operation` of other operands.
    fn of(&mut self, operation: Operation, operands: &[Place]) -> Place {
        match (operation, operands) {
            (Operation::Add(..), &[a, b]) => self.add(a, b),
            (Operation::Sub(..), &[a, b]) => self.sub(a, b),
            (Operation::Mul(..), &[a, b]) => self.mul(a, b),
            (Operation::Div(..), &[a, b]) => self.div(a, b),
            (Operation::MulAdd(..), &[a, b, c]) => self.mul_add(a, b, c),
            _ => unreachable!("not an operation of several operands"),
        }
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
