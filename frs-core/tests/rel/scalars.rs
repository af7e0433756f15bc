//! The core over other scalars: one that records what is done to it, and single precision.

use std::cell::RefCell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use frs_core::Real;
use nalgebra::DVector;
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::closeness::close;
use crate::outputs::{inputs, outputs};
use crate::trees::{case, config};

/// Rounding of single precision per unit of the condition numbers, which it cannot afford as double precision can.
const SINGLE_ROUNDING: f64 = 2e-5;

thread_local! {
    /// What was done to recorded numbers, in order.
    static TAPE: RefCell<Vec<Operation>> = const { RefCell::new(Vec::new()) };
}

/// One operation; operands are places on the tape.
#[derive(Clone, Copy, Debug)]
enum Operation {
    Input(usize),
    Constant(f64),
    Add(usize, usize),
    Sub(usize, usize),
    Mul(usize, usize),
    Div(usize, usize),
    Neg(usize),
    Sqrt(usize),
    Sin(usize),
    Cos(usize),
    Atan2(usize, usize),
    SelectBelow { value: usize, limit: f64, below: usize, otherwise: usize },
}

/// A number that has no value: only its place on the tape.
#[derive(Clone, Copy, Debug)]
struct Recorded(usize);

fn record(operation: Operation) -> Recorded {
    TAPE.with_borrow_mut(|tape| {
        tape.push(operation);
        Recorded(tape.len() - 1)
    })
}

/// Performs the tape's operations on `inputs`: the value at every place.
fn replay(tape: &[Operation], inputs: &[f64]) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::with_capacity(tape.len());
    for operation in tape {
        let value = |place: usize| values[place];
        values.push(match *operation {
            Operation::Input(number) => inputs[number],
            Operation::Constant(value) => value,
            Operation::Add(a, b) => value(a) + value(b),
            Operation::Sub(a, b) => value(a) - value(b),
            Operation::Mul(a, b) => value(a) * value(b),
            Operation::Div(a, b) => value(a) / value(b),
            Operation::Neg(a) => -value(a),
            Operation::Sqrt(a) => value(a).sqrt(),
            Operation::Sin(a) => value(a).sin_cos().0,
            Operation::Cos(a) => value(a).sin_cos().1,
            Operation::Atan2(y, x) => value(y).atan2(value(x)),
            Operation::SelectBelow { value: v, limit, below, otherwise } => {
                if value(v) < limit {
                    value(below)
                } else {
                    value(otherwise)
                }
            }
        });
    }
    values
}

macro_rules! record_operator {
    ($operator:ident, $method:ident, $assign:ident, $assign_method:ident) => {
        impl $operator for Recorded {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                record(Operation::$operator(self.0, other.0))
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
        record(Operation::Neg(self.0))
    }
}

impl PartialEq for Recorded {
    /// A recorded number has no value, so an algorithm that asks branches where it must not.
    fn eq(&self, _: &Self) -> bool {
        panic!("the core compared two numbers");
    }
}

impl Zero for Recorded {
    fn zero() -> Self {
        record(Operation::Constant(0.0))
    }

    /// A constant knows whether it is zero; what was computed must not be asked.
    fn is_zero(&self) -> bool {
        match TAPE.with_borrow(|tape| tape[self.0]) {
            Operation::Constant(value) => value == 0.0,
            computed => panic!("the core asked whether {computed:?} is zero"),
        }
    }
}

impl One for Recorded {
    fn one() -> Self {
        record(Operation::Constant(1.0))
    }
}

impl Real for Recorded {
    fn from_f64(value: f64) -> Self {
        record(Operation::Constant(value))
    }

    fn sqrt(self) -> Self {
        record(Operation::Sqrt(self.0))
    }

    fn sin_cos(self) -> (Self, Self) {
        (record(Operation::Sin(self.0)), record(Operation::Cos(self.0)))
    }

    fn atan2(self, x: Self) -> Self {
        record(Operation::Atan2(self.0, x.0))
    }

    fn select_below(self, limit: f64, below: Self, otherwise: Self) -> Self {
        record(Operation::SelectBelow { value: self.0, limit, below: below.0, otherwise: otherwise.0 })
    }
}

proptest! {
    #![proptest_config(config())]

    /// What the core does to a number depends on no value: recorded once, it can be replayed at any state, bit for bit.
    #[test]
    fn a_recording_replays_to_the_same_bits(case in case(), shift in -1.0..1.0) {
        let model = case.model();
        let here = inputs(&case);
        TAPE.with_borrow_mut(Vec::clear);
        let recorded_inputs: Vec<_> = (0..here.len()).map(|number| record(Operation::Input(number))).collect();
        let recorded = outputs(&model.cast::<Recorded>(), &recorded_inputs);
        let tape = TAPE.take();

        let elsewhere: Vec<f64> = here.iter().map(|number| number + shift).collect();
        for state in [here, elsewhere] {
            let values = replay(&tape, &state);
            let expected = outputs(&model, &state);
            prop_assert_eq!(recorded.len(), expected.len());
            for (number, (place, expected)) in recorded.iter().zip(&expected).enumerate() {
                // −0 and 0 are one number: a sum that starts at 0 may or may not see the sign.
                let [actual, expected] = [values[place.0], *expected].map(|value| (value + 0.0).to_bits());
                prop_assert_eq!(actual, expected, "output number {}", number);
            }
        }
    }

    #[test]
    fn single_precision_gives_the_same_numbers_to_its_own_rounding(case in case()) {
        let model = case.model();
        let state = inputs(&case);
        let single_state: Vec<f32> = state.iter().map(|number| *number as f32).collect();
        // Both precisions answer for the state that single precision can hold.
        let state: Vec<f64> = single_state.iter().copied().map(f64::from).collect();
        let expected = DVector::from_vec(outputs(&model, &state));
        let single = outputs(&model.cast::<f32>(), &single_state);
        let actual = DVector::from_iterator(single.len(), single.into_iter().map(f64::from));
        let spec = case.specification(&model);
        close(&actual, &expected, SINGLE_ROUNDING * spec.shape_condition())?;
    }
}
