//! A scene's equations as machine code.

use frs::Model;
use frs::jit::{Code, JitError};
use frs::spatial::Twist;
use frs_sim::integrate::{State, Tangent};
use frs_sim::run::{self, Acting};

use super::recording::Recording;

/// Equations as machine code.
pub struct Compiled {
    code: Code,
    inputs: Vec<f64>,
    outputs: Vec<f64>,
}

impl Compiled {
    /// Compiles what was recorded.
    ///
    /// # Errors
    /// Where no machine code can be made.
    pub fn new(recording: &Recording) -> Result<Self, JitError> {
        let Recording { tape, outputs, .. } = recording;
        let numbers = outputs.len() - 6;
        let inputs = 12 + numbers + 1;
        let code = Code::compile(tape, outputs, inputs)?;
        Ok(Self { code, inputs: vec![0.0; inputs], outputs: vec![0.0; outputs.len()] })
    }
}

impl run::Code for Compiled {
    fn rate(&mut self, time: f64, state: &State, rate: &mut Tangent) {
        let Self { code, inputs, outputs } = self;
        let rotation = state.pose.rotation.transpose();
        let numbers = rotation.iter().chain(&state.pose.translation).chain(&state.flat).chain([&time]);
        inputs.iter_mut().zip(numbers).for_each(|(input, number)| *input = *number);
        code.call(inputs, outputs);
        let (twist, flat) = outputs.split_at(6);
        rate.twist = Twist::from_array(std::array::from_fn(|i| twist[i]));
        rate.flat.copy_from_slice(flat);
    }
}

/// Makes code for what acts in a run; where none can be made, the core goes on.
pub fn code(acting: &Acting<'_>) -> Option<Box<dyn run::Code>> {
    let recording = Recording::of(acting.model(), acting.numbers(), |model: &Model<_>| acting.system(model));
    Compiled::new(&recording).ok().map(|code| -> Box<dyn run::Code> { Box::new(code) })
}
