//! A recording as machine code.

use std::array::from_fn;
use std::fmt;

use frs_codegen::record::{Operation, Place};
use frs_codegen::{Graph, Precision};
use frs_core::turn;

use crate::error::JitError;
use crate::machine::{Lengths, Machine, SLICES};
use crate::order::{Order, Step, Turn};
use crate::stages::Stages;
use crate::translate::MOST;

/// A recording as machine code: numbers in, numbers out, with the bits of the operations that were recorded.
///
/// ```
/// use frs_codegen::record::{Recorded, record};
/// use frs_core::Real;
///
/// let (outputs, tape) = record(|| {
///     let (length, angle) = (Recorded::input(0), Recorded::input(1));
///     let (sin, cos) = angle.sin_cos();
///     [(length * cos).0, (length * sin).0]
/// });
/// let mut code = frs_jit::Code::compile(&tape, &outputs, 2)?;
///
/// let mut point = [0.0; 2];
/// code.call(&[2.0, 0.7], &mut point);
/// assert_eq!(point, [2.0 * 0.7_f64.cos(), 2.0 * 0.7_f64.sin()]);
/// # Ok::<(), frs_jit::JitError>(())
/// ```
///
/// It allocates when it is made and never again.
pub struct Code {
    machine: Machine,
    /// What is turned after each part.
    turns: Vec<Vec<Turn>>,
    memory: Vec<f64>,
    operations: usize,
}

impl Code {
    /// Compiles what `outputs` of `tape` stand on, for `inputs` numbers.
    ///
    /// It is folded as generated code is: finite results keep their bits, −0 becomes 0; what the recorded operations lose to
    /// an infinity or to NaN may survive. Time and memory grow with the number of operations and no faster.
    ///
    /// # Errors
    /// If an operation reads a later place or an input that is not there, if an output is not on the tape, or if this machine
    /// cannot be compiled for.
    pub fn compile(tape: &[Operation], outputs: &[Place], inputs: usize) -> Result<Self, JitError> {
        Self::compile_slices(tape, &[outputs], &[inputs])
    }

    /// [`compile`](Self::compile) for inputs and outputs in several slices: the numbers of inputs count through them.
    ///
    /// # Errors
    /// As [`compile`](Self::compile), and if there are more than eight slices of one kind.
    pub fn compile_slices(tape: &[Operation], outputs: &[&[Place]], inputs: &[usize]) -> Result<Self, JitError> {
        let lengths: Vec<usize> = outputs.iter().map(|slice| slice.len()).collect();
        let outputs = outputs.concat();
        check(tape, &outputs, &lengths, inputs)?;
        let mut graph = Graph::new(Precision::Double);
        // What nobody reads becomes a number: it then costs nothing.
        let read = |(&operation, live)| if live { operation } else { Operation::constant(0.0) };
        let places = graph.absorb(&tape.iter().zip(Stages::new(tape, &outputs).live).map(read).collect::<Vec<_>>());
        let outputs: Vec<Place> = outputs.iter().map(|&output| places[output as usize]).collect();
        let order = Order::new(graph.operations(), &outputs);
        count("values that wait in memory", order.memory, MOST)?;
        let lengths = Lengths { inputs: inputs.to_vec(), memory: order.memory, outputs: lengths };
        let machine = Machine::new(graph.operations(), &order, lengths)?;
        let steps = order.parts.iter().flat_map(|part| &part.steps);
        Ok(Self {
            machine,
            operations: steps.filter(|step| matches!(step, Step::Perform(_))).count(),
            memory: vec![0.0; order.memory],
            turns: order.parts.into_iter().map(|part| part.turns).collect(),
        })
    }

    /// Computes the outputs at `inputs`; none is −0.
    ///
    /// # Panics
    /// If a slice has not the length that the code was compiled for.
    pub fn call(&mut self, inputs: &[f64], outputs: &mut [f64]) {
        self.call_slices(&[inputs], &mut [outputs]);
    }

    /// [`call`](Self::call) with inputs and outputs in the slices they were compiled for.
    ///
    /// # Panics
    /// If a slice is missing or has not its length.
    pub fn call_slices(&mut self, inputs: &[&[f64]], outputs: &mut [&mut [f64]]) {
        let Self { machine, turns, memory, .. } = self;
        machine.call(inputs, memory, outputs, |part, memory| {
            for turns in turns[part].chunks(4) {
                let angles = from_fn(|k| turns.get(k).map_or(0.0, |turn| memory[turn.angle]));
                for (turn, pair) in turns.iter().zip(turn::sin_cos_each::<4>(angles)) {
                    (memory[turn.sine], memory[turn.cosine]) = pair;
                }
            }
        });
    }

    /// How many operations a call performs: + − × ÷ √ and signs; sines and cosines come on top.
    pub fn operations(&self) -> usize {
        self.operations
    }

    /// Length of the machine code in bytes.
    pub fn bytes(&self) -> usize {
        self.machine.bytes()
    }
}

/// Whether everything that is read is there, and can be counted.
fn check(tape: &[Operation], outputs: &[Place], slices: &[usize], inputs: &[usize]) -> Result<(), JitError> {
    let all = inputs.iter().fold(0, |sum: usize, len| sum.saturating_add(*len));
    for (what, len, most) in [
        ("outputs", outputs.len(), MOST),
        ("inputs", all, MOST),
        ("slices of outputs", slices.len(), SLICES),
        ("slices of inputs", inputs.len(), SLICES),
    ] {
        count(what, len, most)?;
    }
    for (place, &operation) in tape.iter().enumerate() {
        let later = operation.operands().any(|operand| operand as usize >= place);
        if later || matches!(operation, Operation::Input(number) if number as usize >= all) {
            return Err(JitError::Unknown { place, operation, inputs: all });
        }
        if matches!(operation, Operation::Gather(_) | Operation::Splat(_) | Operation::Lane(..)) {
            return Err(JitError::Vector { place, operation });
        }
    }
    match outputs.iter().find(|&&output| output as usize >= tape.len()) {
        Some(&place) => Err(JitError::NoPlace { place, len: tape.len() }),
        None => Ok(()),
    }
}

/// Whether machine code can count so many.
fn count(what: &'static str, len: usize, most: usize) -> Result<(), JitError> {
    if len > most { Err(JitError::TooMany { what, len, most }) } else { Ok(()) }
}

impl fmt::Debug for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut debug = f.debug_struct("Code");
        debug.field("lengths", self.machine.lengths()).field("operations", &self.operations);
        debug.field("bytes", &self.bytes()).finish_non_exhaustive()
    }
}
