//! The core's own answers.

use frs::model::Inertial;
use frs::nalgebra::Vector3;
use frs::spatial::Symmetric3;
use frs::{Evaluator, FloatingBase, Model, Quantity};
use frs_codegen::{FunctionReport, Input};

use super::element::Element;

/// A generated function's question to the core.
pub struct Question<E> {
    quantity: Quantity,
    /// What the core reads: the place in a state, or zeros for what is no input of the function.
    inputs: Vec<Result<Input, Vec<E>>>,
    /// What the core writes.
    outputs: Vec<Vec<E>>,
    /// How many numbers at the end of each output the function writes, too.
    lengths: Vec<usize>,
}

impl<E: Element> Question<E> {
    /// The question that `function` answers about a robot of `dof` coordinates.
    pub fn new(function: &FunctionReport, dof: usize) -> Self {
        let quantity = function.quantity;
        let source = |argument: frs::Argument| {
            let known = function.inputs.iter().find(|input| input.name == argument.name);
            known.copied().ok_or_else(|| vec![E::zero(); argument.len(dof)])
        };
        Self {
            quantity,
            inputs: quantity.inputs().map(source).collect(),
            outputs: quantity.outputs().map(|argument| vec![E::zero(); argument.len(dof)]).collect(),
            lengths: function.outputs.iter().map(|(_, [rows, columns], layers)| rows * columns * layers).collect(),
        }
    }

    /// Asks the core.
    pub fn ask(&mut self, evaluator: &mut Evaluator<'_, E>, state: &[E]) {
        let Self { quantity, inputs, outputs, .. } = self;
        let (mut read, mut written) = ([&[][..]; 6], [(); 5].map(|()| <&mut [E]>::default()));
        for (slice, input) in read.iter_mut().zip(&*inputs) {
            *slice = match input {
                Ok(input) => part(state, input),
                Err(zeros) => zeros,
            };
        }
        let count = outputs.len();
        written.iter_mut().zip(outputs).for_each(|(slice, output)| *slice = output);
        evaluator.answer(*quantity, &read[..inputs.len()], &mut written[..count]);
    }

    /// The last answer, as far as the function gives it: of ξ̇ it may be the tail q̈ alone.
    pub fn answer(&self) -> impl Iterator<Item = E> {
        let parts = self.outputs.iter().zip(&self.lengths);
        parts.flat_map(|(output, length)| &output[output.len() - length..]).copied()
    }
}

/// An array of a state.
pub fn part<'s, E>(state: &'s [E], input: &Input) -> &'s [E] {
    &state[input.start as usize..][..input.len]
}

/// The robot with the payload of a state.
pub fn laden<E: Element>(model: &Model<E>, link: &str, payload: &[E]) -> Model<E> {
    let &[mass, cx, cy, cz, xx, xy, xz, yy, yz, zz] = payload else { unreachable!("a payload has ten parameters") };
    let inertial = Inertial { mass, com: Vector3::new(cx, cy, cz), inertia: Symmetric3 { xx, xy, xz, yy, yz, zz } };
    model.with_inertial(link, inertial).expect("the generator has found the link")
}
