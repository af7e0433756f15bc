//! A part of an order as a function of Cranelift's: one instruction a step, in the same order.

use std::collections::HashMap;

use cranelift_codegen::cursor::{Cursor, FuncCursor};
use cranelift_codegen::ir::immediates::Ieee64;
use cranelift_codegen::ir::{Function, InstBuilder, MemFlags, Type, Value, types::F64};
use frs_codegen::record::{Operation, Place};

use crate::machine::Lengths;
use crate::order::{Order, Part, Step};

/// Bytes of a number.
const SIZE: i32 = size_of::<f64>() as i32;

/// Most numbers that an array may have, so that every offset into it can be written down.
pub const MOST: usize = (i32::MAX / SIZE) as usize;

/// Writes a function of inputs, memory and outputs.
pub struct Translation<'a> {
    operations: &'a [Operation],
    order: &'a Order,
    cursor: FuncCursor<'a>,
    /// Where each slice of inputs begins: its first number, and its address.
    inputs: Vec<(usize, Value)>,
    memory: Value,
    outputs: Vec<(usize, Value)>,
    registers: HashMap<Place, Value>,
}

impl<'a> Translation<'a> {
    /// Begins `function`, whose parameters are three pointers of type `pointer`.
    pub fn new(
        operations: &'a [Operation],
        order: &'a Order,
        lengths: &Lengths,
        function: &'a mut Function,
        pointer: Type,
    ) -> Self {
        let block = function.dfg.make_block();
        let [inputs, memory, outputs] = [(); 3].map(|()| function.dfg.append_block_param(block, pointer));
        let mut cursor = FuncCursor::new(function);
        cursor.insert_block(block);
        let mut slices = |table, lengths: &[usize]| {
            let (mut slices, mut start) = (Vec::new(), 0);
            for (number, len) in lengths.iter().enumerate() {
                let offset = (number as u32 * pointer.bytes()) as i32;
                slices.push((start, cursor.ins().load(pointer, MemFlags::trusted(), table, offset)));
                start += len;
            }
            slices
        };
        let (inputs, outputs) = (slices(inputs, &lengths.inputs), slices(outputs, &lengths.outputs));
        Self { operations, order, cursor, inputs, memory, outputs, registers: HashMap::new() }
    }

    /// Performs `part` and returns.
    pub fn part(mut self, part: &Part) {
        part.steps.iter().for_each(|&step| self.step(step));
        self.cursor.ins().return_(&[]);
    }

    fn step(&mut self, step: Step) {
        match step {
            Step::Perform(place) => {
                let value = self.perform(self.operations[place as usize]);
                self.registers.insert(place, value);
                if let Some(slot) = self.order.slots[place as usize] {
                    self.store(value, self.memory, slot);
                }
            }
            Step::Load(place) => {
                if let Some(slot) = self.order.slots[place as usize] {
                    let value = self.load(self.memory, slot);
                    self.registers.insert(place, value);
                }
            }
            Step::Write(place, output) => {
                let (value, zero) = (self.value(place), self.constant(0.0_f64.to_bits()));
                // No −0 leaves the code.
                let value = self.cursor.ins().fadd(value, zero);
                let (slice, index) = entry(&self.outputs, output);
                self.store(value, slice, index);
            }
            Step::Aim(place, slot) => {
                let value = self.value(place);
                self.store(value, self.memory, slot);
            }
        }
    }

    fn perform(&mut self, operation: Operation) -> Value {
        match operation {
            Operation::Input(number) => {
                let (slice, index) = entry(&self.inputs, number as usize);
                self.load(slice, index)
            }
            Operation::Constant(bits) => self.constant(bits),
            Operation::Add(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.cursor.ins().fadd(a, b)
            }
            Operation::Sub(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.cursor.ins().fsub(a, b)
            }
            Operation::Mul(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.cursor.ins().fmul(a, b)
            }
            Operation::Div(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.cursor.ins().fdiv(a, b)
            }
            Operation::MulAdd(a, b, c) => {
                let [a, b, c] = [a, b, c].map(|place| self.value(place));
                self.cursor.ins().fma(a, b, c)
            }
            Operation::Neg(a) => {
                let a = self.value(a);
                self.cursor.ins().fneg(a)
            }
            Operation::Sqrt(a) => {
                let a = self.value(a);
                self.cursor.ins().sqrt(a)
            }
            Operation::Sin(_) | Operation::Cos(_) => unreachable!("angles are turned between parts"),
            Operation::Gather(_) | Operation::Splat(_) | Operation::Lane(..) => {
                unreachable!("vectors are refused before")
            }
        }
    }

    /// The value of a place: inputs and constants are read anew, which costs less than a register.
    fn value(&mut self, place: Place) -> Value {
        match self.operations[place as usize] {
            operation @ (Operation::Input(_) | Operation::Constant(_)) => self.perform(operation),
            _ => self.registers[&place],
        }
    }

    fn constant(&mut self, bits: u64) -> Value {
        self.cursor.ins().f64const(Ieee64::with_bits(bits))
    }

    fn load(&mut self, array: Value, index: usize) -> Value {
        self.cursor.ins().load(F64, MemFlags::trusted(), array, SIZE * index as i32)
    }

    fn store(&mut self, value: Value, array: Value, index: usize) {
        self.cursor.ins().store(MemFlags::trusted(), value, array, SIZE * index as i32);
    }
}

/// The slice in which `number` stands, and where in it.
fn entry(slices: &[(usize, Value)], number: usize) -> (Value, usize) {
    let (start, slice) = slices[slices.partition_point(|&(start, _)| start <= number) - 1];
    (slice, number - start)
}
