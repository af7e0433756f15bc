//! How much a function computes.

use std::fmt;
use std::ops::AddAssign;

use frs_core::Quantity;

use crate::options::Form;
use crate::program::Input;
use crate::record::{Operation, Place};
use crate::simplify::Graph;

/// What one generated function does.
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionReport {
    /// Its name.
    pub name: String,
    /// What it computes.
    pub quantity: Quantity,
    /// What it reads, in the order of its arguments.
    pub inputs: Vec<Input>,
    /// What it writes, in the order of its arguments: name, rows and columns, how many such matrices.
    pub outputs: Vec<(&'static str, [usize; 2], usize)>,
    /// What a call performs, the sections it stands on included; nothing is counted in the tabled form.
    pub counts: Counts,
    /// Predicted machine code of a call, bytes; in the tabled form 0, since it is the core's.
    pub code_bytes: usize,
    /// How it is written.
    pub form: Form,
}

impl FunctionReport {
    /// Whether nothing is known of what its quantity reads, so that it answers the quantity.
    pub(crate) fn has_the_inputs_of_its_quantity(&self) -> bool {
        let names = self.inputs.iter().map(|input| input.name).filter(|&name| name != "payload");
        names.eq(self.quantity.inputs().map(|argument| argument.name))
    }
}

/// Operations by kind. Signs are free: they are part of another instruction, or flip one bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Additions and subtractions.
    pub add: usize,
    /// Multiplications.
    pub mul: usize,
    /// Divisions.
    pub div: usize,
    /// Products and the sums they enter, rounded once.
    pub mul_add: usize,
    /// Square roots.
    pub sqrt: usize,
    /// Sines and cosines, each.
    pub sin_cos: usize,
    /// Those of the additions, multiplications, divisions and roots that are of vectors.
    pub of_vectors: usize,
    /// Vectors put together from numbers that are not all constants.
    pub gather: usize,
}

impl Counts {
    /// All additions, multiplications, divisions and roots, a fused product and sum as one: floating-point operations without sines and cosines.
    pub fn flops(&self) -> usize {
        self.add + self.mul + self.div + self.mul_add + self.sqrt
    }

    /// What the operations at `places` perform.
    pub(crate) fn of(graph: &Graph, places: impl IntoIterator<Item = Place>) -> Self {
        let mut counts = Self::default();
        for place in places.into_iter().filter(|&place| !graph.is_table(place)) {
            let before = counts.flops();
            counts.count(graph.operation(place));
            if graph.is_vector(place) {
                counts.of_vectors += counts.flops() - before;
            }
        }
        counts
    }

    /// Counts one operation.
    pub fn count(&mut self, operation: Operation) {
        match operation {
            Operation::Input(_)
            | Operation::Constant(_)
            | Operation::Neg(_)
            | Operation::Splat(_)
            | Operation::Lane(..) => {}
            Operation::Add(..) | Operation::Sub(..) => self.add += 1,
            Operation::Mul(..) => self.mul += 1,
            Operation::Div(..) => self.div += 1,
            Operation::MulAdd(..) => self.mul_add += 1,
            Operation::Sqrt(_) => self.sqrt += 1,
            Operation::Sin(_) | Operation::Cos(_) => self.sin_cos += 1,
            Operation::Gather(_) => self.gather += 1,
        }
    }

    /// Bytes of machine code that these operations take, one lane, loads and stores included.
    ///
    /// Twelve an operation: on baseline x86-64, `matrices` of lwr_satellite takes 11.9 and `inertia` of the quadruped 13.6. An operation of vectors
    /// 16 and a vector put together 24, where a vector is one register: in the hybrid form these two then take 23.1 and 24.9 KiB, and this says 24.9
    /// and 27.0.
    pub fn code_bytes(&self) -> usize {
        12 * self.flops() + 4 * self.of_vectors + 20 * self.sin_cos + 24 * self.gather
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.add += other.add;
        self.mul += other.mul;
        self.div += other.div;
        self.mul_add += other.mul_add;
        self.sqrt += other.sqrt;
        self.sin_cos += other.sin_cos;
        self.of_vectors += other.of_vectors;
        self.gather += other.gather;
    }
}

impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} operations: {} + −, {} ×", self.flops(), self.add, self.mul)?;
        for (count, sign) in [(self.mul_add, "× +"), (self.div, "÷"), (self.sqrt, "√")] {
            if count > 0 {
                write!(f, ", {count} {sign}")?;
            }
        }
        if self.sin_cos > 0 {
            write!(f, "; {} sin cos", self.sin_cos / 2)?;
        }
        if self.of_vectors > 0 {
            write!(f, "; {} of vectors, {} put together", self.of_vectors, self.gather)?;
        }
        Ok(())
    }
}
