//! The recording scalar: a number that remembers what was done to it.
//!
//! Running the core over [`Recorded`] leaves its operations on a [`Tape`], in order, whatever the state: the core has no
//! branch on a value.

use std::cell::RefCell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use frs_core::Real;
use num_traits::{One, Zero};

/// A place on a tape.
pub type Place = u32;

/// One operation; operands are earlier places.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A number given at run time, by its number.
    Input(u32),
    /// A number known now, by its bits.
    Constant(u64),
    /// a + b.
    Add(Place, Place),
    /// a − b.
    Sub(Place, Place),
    /// a · b.
    Mul(Place, Place),
    /// a / b.
    Div(Place, Place),
    /// a · b + c, rounded once.
    MulAdd(Place, Place, Place),
    /// −a.
    Neg(Place),
    /// √a.
    Sqrt(Place),
    /// sin a.
    Sin(Place),
    /// cos a.
    Cos(Place),
}

impl Operation {
    /// The constant `value`.
    pub fn constant(value: f64) -> Self {
        Self::Constant(value.to_bits())
    }

    /// The places it reads.
    pub fn operands(self) -> impl DoubleEndedIterator<Item = Place> {
        let operands = match self {
            Self::Input(_) | Self::Constant(_) => [None; 3],
            Self::Neg(a) | Self::Sqrt(a) | Self::Sin(a) | Self::Cos(a) => [Some(a), None, None],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => [Some(a), Some(b), None],
            Self::MulAdd(a, b, c) => [Some(a), Some(b), Some(c)],
        };
        operands.into_iter().flatten()
    }
}

/// Operations in the order in which they were performed.
pub type Tape = Vec<Operation>;

thread_local! {
    static TAPE: RefCell<Tape> = const { RefCell::new(Vec::new()) };
}

/// Runs `algorithm` over recorded numbers; returns what it returned and the tape.
pub fn record<R>(algorithm: impl FnOnce() -> R) -> (R, Tape) {
    TAPE.take();
    let result = algorithm();
    (result, TAPE.take())
}

/// A number without a value: a place on the tape of this thread.
#[derive(Clone, Copy, Debug)]
pub struct Recorded(pub Place);

impl Recorded {
    /// Run-time input number `number`.
    pub fn input(number: u32) -> Self {
        push(Operation::Input(number))
    }
}

fn push(operation: Operation) -> Recorded {
    TAPE.with_borrow_mut(|tape| {
        tape.push(operation);
        Recorded((tape.len() - 1) as Place)
    })
}

macro_rules! record_operator {
    ($operator:ident, $method:ident, $assign:ident, $assign_method:ident) => {
        impl $operator for Recorded {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                push(Operation::$operator(self.0, other.0))
            }
        }

        impl $assign for Recorded {
            fn $assign_method(&mut self, other: Self) {
                *self = $operator::$method(*self, other);
            }
        }
    };
}

record_operator!(Add, add, AddAssign, add_assign);
record_operator!(Sub, sub, SubAssign, sub_assign);
record_operator!(Mul, mul, MulAssign, mul_assign);
record_operator!(Div, div, DivAssign, div_assign);

impl Neg for Recorded {
    type Output = Self;
    fn neg(self) -> Self {
        push(Operation::Neg(self.0))
    }
}

impl PartialEq for Recorded {
    /// A recorded number has no value: an algorithm that compares branches where it must not.
    fn eq(&self, _: &Self) -> bool {
        panic!("an algorithm compared two recorded numbers");
    }
}

impl Zero for Recorded {
    fn zero() -> Self {
        push(Operation::constant(0.0))
    }

    /// A constant knows whether it is zero; what was computed must not be asked.
    fn is_zero(&self) -> bool {
        match TAPE.with_borrow(|tape| tape[self.0 as usize]) {
            Operation::Constant(bits) => f64::from_bits(bits) == 0.0,
            computed => panic!("an algorithm asked whether {computed:?} is zero"),
        }
    }
}

impl One for Recorded {
    fn one() -> Self {
        push(Operation::constant(1.0))
    }
}

impl Real for Recorded {
    type Lanes = Self;

    fn from_f64(value: f64) -> Self {
        push(Operation::constant(value))
    }

    fn mul_add(self, factor: Self, summand: Self) -> Self {
        push(Operation::MulAdd(self.0, factor.0, summand.0))
    }

    fn sqrt(self) -> Self {
        push(Operation::Sqrt(self.0))
    }

    fn sin_cos(self) -> (Self, Self) {
        (push(Operation::Sin(self.0)), push(Operation::Cos(self.0)))
    }

    /// # Panics
    /// Always: the dynamics of a robot takes no angle from a point; only logarithms of poses do.
    fn atan2(self, _: Self) -> Self {
        panic!("no quantity of a robot takes an angle from a point");
    }

    /// # Panics
    /// Always: the dynamics of a robot selects nothing; only exponentials and logarithms do.
    fn select_below(self, _: f64, _: Self, _: Self) -> Self {
        panic!("no quantity of a robot depends on which of two numbers is smaller");
    }
}

/// Performs a tape's operations on `inputs`, whatever the scalar: the value at every place.
pub fn replay<T: Real>(tape: &[Operation], inputs: &[T]) -> Vec<T> {
    let mut values: Vec<T> = Vec::with_capacity(tape.len());
    for operation in tape {
        let value = |place: Place| values[place as usize];
        values.push(match *operation {
            Operation::Input(number) => inputs[number as usize],
            Operation::Constant(bits) => T::from_f64(f64::from_bits(bits)),
            Operation::Add(a, b) => value(a) + value(b),
            Operation::Sub(a, b) => value(a) - value(b),
            Operation::Mul(a, b) => value(a) * value(b),
            Operation::Div(a, b) => value(a) / value(b),
            Operation::MulAdd(a, b, c) => value(a).mul_add(value(b), value(c)),
            Operation::Neg(a) => -value(a),
            Operation::Sqrt(a) => value(a).sqrt(),
            Operation::Sin(a) => value(a).sin_cos().0,
            Operation::Cos(a) => value(a).sin_cos().1,
        });
    }
    values
}
