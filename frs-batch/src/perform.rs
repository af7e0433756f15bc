//! Steps on a block of states.

use frs_core::lanes::F64x8;

use crate::steps::{Code, Step};

/// Numbers that a processor treats at once, at most.
pub const WIDTH: usize = F64x8::LANES;

/// States of a block. What a step costs beside its arithmetic is shared by them; the values that wait stay in the nearer caches.
pub const STATES: usize = 32;

/// A number at every state of a block.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Block(pub [[f64; WIDTH]; STATES / WIDTH]);

impl Block {
    /// The same number at every state.
    pub fn splat(value: f64) -> Self {
        Self([[value; WIDTH]; STATES / WIDTH])
    }
}

/// Performs `steps` in `memory`.
///
/// It is inlined into functions that may use wider instructions than the rest of the program, and so is what it calls for sums and products.
#[inline(always)]
pub fn perform(steps: &[Step], memory: &mut [Block]) {
    for step in steps {
        match step.code {
            Code::Add => each(step, memory, |[a, b, _]| a + b),
            Code::Sub => each(step, memory, |[a, b, _]| a - b),
            Code::Mul => each(step, memory, |[a, b, _]| a * b),
            Code::Div => each(step, memory, |[a, b, _]| a / b),
            Code::MulAdd => each(step, memory, |[a, b, c]| a * b + c),
            Code::MulSub => each(step, memory, |[a, b, c]| a * b - c),
            Code::SubMul => each(step, memory, |[a, b, c]| c - a * b),
            Code::Fused => each(step, memory, |[a, b, c]| a.mul_add(b, c)),
            Code::FusedMinus => each(step, memory, |[a, b, c]| a.mul_add(-b, c)),
            Code::Neg => each(step, memory, |[a, ..]| -a),
            Code::Sqrt => each(step, memory, |[a, ..]| a.sqrt()),
            Code::Turn => turn(step, memory),
        }
    }
}

/// A step, state by state. What it reads is read before anything is written.
#[inline(always)]
fn each(step: &Step, memory: &mut [Block], operation: impl Fn([f64; 3]) -> f64) {
    let [a, b, c] = step.from.map(|slot| slot as usize);
    let to = step.to as usize;
    for part in 0..STATES / WIDTH {
        let (x, y, z) = (memory[a].0[part], memory[b].0[part], memory[c].0[part]);
        let mut result = [0.0; WIDTH];
        for lane in 0..WIDTH {
            result[lane] = operation([x[lane], y[lane], z[lane]]);
        }
        memory[to].0[part] = result;
    }
}

#[inline(always)]
fn turn(step: &Step, memory: &mut [Block]) {
    let (angle, to) = (step.from[0] as usize, step.to as usize);
    for part in 0..STATES / WIDTH {
        let (sin, cos) = F64x8::from_array(memory[angle].0[part]).sin_cos();
        memory[to].0[part] = sin.to_array();
        memory[to + 1].0[part] = cos.to_array();
    }
}
