//! The recording scalar: a number that remembers what was done to it.
//!
//! Running the core over [`Recorded`] leaves its operations on a [`Tape`], in order, whatever the state: the core has no
//! branch on a value. Over [`Grouped`] the passes over several bodies at once stay what they are: operations on vectors.

use std::array::from_fn;
use std::cell::RefCell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use frs_core::{Lanes, Real};
use num_traits::{One, Zero};

/// A place on a tape.
pub type Place = u32;

/// Numbers in a recorded vector.
pub const WIDTH: usize = 4;

/// One operation; operands are earlier places. Arithmetic is of two numbers or, lane by lane, of two vectors.
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
    /// The vector of these numbers.
    Gather([Place; WIDTH]),
    /// The vector of this number alone.
    Splat(Place),
    /// One number of a vector.
    Lane(Place, u8),
}

impl Operation {
    /// The constant `value`.
    pub fn constant(value: f64) -> Self {
        Self::Constant(value.to_bits())
    }

    /// The places it reads.
    pub fn operands(self) -> impl DoubleEndedIterator<Item = Place> {
        let operands = match self {
            Self::Input(_) | Self::Constant(_) => [None; WIDTH],
            Self::Neg(a) | Self::Sqrt(a) | Self::Sin(a) | Self::Cos(a) | Self::Splat(a) | Self::Lane(a, _) => {
                [Some(a), None, None, None]
            }
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => [Some(a), Some(b), None, None],
            Self::MulAdd(a, b, c) => [Some(a), Some(b), Some(c), None],
            Self::Gather(numbers) => numbers.map(Some),
        };
        operands.into_iter().flatten()
    }

    /// The place that it only hands on, with another sign, to all lanes or out of one: what needs no line of its own.
    pub fn handed_on(self) -> Option<Place> {
        match self {
            Self::Neg(a) | Self::Splat(a) | Self::Lane(a, _) => Some(a),
            _ => None,
        }
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

fn push(operation: Operation) -> Place {
    TAPE.with_borrow_mut(|tape| {
        tape.push(operation);
        (tape.len() - 1) as Place
    })
}

/// A scalar that records.
pub trait Recording: Real {
    /// Run-time input number `number`.
    fn input(number: u32) -> Self;

    /// Where it stands on the tape of this thread.
    fn place(self) -> Place;
}

macro_rules! operator {
    ($Scalar:ident, $operator:ident, $method:ident, $assign:ident, $assign_method:ident) => {
        impl $operator for $Scalar {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(push(Operation::$operator(self.0, other.0)))
            }
        }

        impl $assign for $Scalar {
            fn $assign_method(&mut self, other: Self) {
                *self = $operator::$method(*self, other);
            }
        }
    };
}

macro_rules! scalar {
    ($Scalar:ident, $Lanes:ident, $constant:expr, $sin_cos:expr, $caption:literal) => {
        #[doc = $caption]
        #[derive(Clone, Copy, Debug)]
        pub struct $Scalar(pub Place);

        operator!($Scalar, Add, add, AddAssign, add_assign);
        operator!($Scalar, Sub, sub, SubAssign, sub_assign);
        operator!($Scalar, Mul, mul, MulAssign, mul_assign);
        operator!($Scalar, Div, div, DivAssign, div_assign);

        impl Neg for $Scalar {
            type Output = Self;
            fn neg(self) -> Self {
                Self(push(Operation::Neg(self.0)))
            }
        }

        impl PartialEq for $Scalar {
            /// A recorded number has no value: an algorithm that compares branches where it must not.
            fn eq(&self, _: &Self) -> bool {
                panic!("an algorithm compared two recorded numbers");
            }
        }

        impl Zero for $Scalar {
            fn zero() -> Self {
                Self::from_f64(0.0)
            }

            fn is_zero(&self) -> bool {
                is_zero(self.0)
            }
        }

        impl One for $Scalar {
            fn one() -> Self {
                Self::from_f64(1.0)
            }
        }

        impl Real for $Scalar {
            type Lanes = $Lanes;

            fn from_f64(value: f64) -> Self {
                Self($constant(push(Operation::constant(value))))
            }

            fn mul_add(self, factor: Self, summand: Self) -> Self {
                Self(push(Operation::MulAdd(self.0, factor.0, summand.0)))
            }

            fn sqrt(self) -> Self {
                Self(push(Operation::Sqrt(self.0)))
            }

            fn sin_cos(self) -> (Self, Self) {
                let (sin, cos) = $sin_cos(self.0);
                (Self(sin), Self(cos))
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
    };
}

macro_rules! number {
    ($Scalar:ident, $Lanes:ident, $caption:literal) => {
        scalar!($Scalar, $Lanes, std::convert::identity, sin_cos, $caption);

        impl Recording for $Scalar {
            fn input(number: u32) -> Self {
                Self(push(Operation::Input(number)))
            }

            fn place(self) -> Place {
                self.0
            }
        }
    };
}

number!(Recorded, Recorded, "A number without a value: a place on the tape of this thread.");
number!(Grouped, Group, "The same, several of which are recorded as a vector where the core treats several at once.");
scalar!(Group, Group, splat, sin_cos_each, "A vector of [`Grouped`] numbers.");

impl Recorded {
    /// Run-time input number `number`.
    pub fn input(number: u32) -> Self {
        Recording::input(number)
    }
}

/// A constant knows whether it is zero; what was computed must not be asked.
fn is_zero(a: Place) -> bool {
    match TAPE.with_borrow(|tape| tape[a as usize]) {
        Operation::Constant(bits) => f64::from_bits(bits) == 0.0,
        Operation::Splat(a) => is_zero(a),
        computed => panic!("an algorithm asked whether {computed:?} is zero"),
    }
}

fn sin_cos(a: Place) -> (Place, Place) {
    (push(Operation::Sin(a)), push(Operation::Cos(a)))
}

fn splat(a: Place) -> Place {
    push(Operation::Splat(a))
}

fn gather(number: impl Fn(usize) -> Place) -> Place {
    push(Operation::Gather(from_fn(number)))
}

fn lane(a: Place, lane: usize) -> Place {
    push(Operation::Lane(a, lane as u8))
}

/// Angles are turned one by one: a call is no instruction.
fn sin_cos_each(a: Place) -> (Place, Place) {
    let pairs: [_; WIDTH] = from_fn(|number| sin_cos(lane(a, number)));
    (gather(|number| pairs[number].0), gather(|number| pairs[number].1))
}

impl Lanes<Grouped> for Group {
    const WIDTH: usize = WIDTH;

    fn splat(value: Grouped) -> Self {
        Self(splat(value.0))
    }

    fn from_fn(number: impl Fn(usize) -> Grouped) -> Self {
        Self(gather(|lane| number(lane).0))
    }

    fn gather<const R: usize>(numbers: impl Fn(usize) -> [Grouped; R]) -> [Self; R] {
        let each: [_; WIDTH] = from_fn(numbers);
        from_fn(|r| Self(gather(|lane| each[lane][r].0)))
    }

    fn lane(&self, number: usize) -> Grouped {
        Grouped(lane(self.0, number))
    }

    fn set_lane(&mut self, number: usize, value: Grouped) {
        *self = Self(gather(|other| if other == number { value.0 } else { lane(self.0, other) }));
    }

    fn first_of(self, lanes: usize, others: Self) -> Self {
        Self(gather(|number| lane(if number < lanes { self.0 } else { others.0 }, number)))
    }

    fn read(numbers: &[Grouped]) -> Self {
        Self(gather(|lane| numbers[lane].0))
    }

    fn write(self, numbers: &mut [Grouped]) {
        for (number, slot) in numbers[..WIDTH].iter_mut().enumerate() {
            *slot = Grouped(lane(self.0, number));
        }
    }
}

/// Performs a tape's operations on `inputs`, whatever the scalar: the value at every place.
///
/// # Panics
/// If the tape holds vectors: it is for recordings over [`Recorded`].
pub fn replay<T: Real>(tape: &[Operation], inputs: &[T]) -> Vec<T> {
    let mut values: Vec<T> = Vec::with_capacity(tape.len());
    for &operation in tape {
        values.push(perform(operation, inputs, |place| values[place as usize]));
    }
    values
}

/// Performs one operation on numbers, given the value at every place before it.
///
/// # Panics
/// If it makes a vector or takes a number out of one.
pub fn perform<T: Real>(operation: Operation, inputs: &[T], value: impl Fn(Place) -> T) -> T {
    match operation {
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
        Operation::Gather(_) | Operation::Splat(_) | Operation::Lane(..) => panic!("{operation:?} is no number's"),
    }
}
