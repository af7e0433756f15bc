//! A quantity of one robot, recorded once to be performed at many states.

use frs_codegen::{Options, Program};
use frs_core::{Model, Quantity};

use crate::blocks::Blocks;
use crate::error::BatchError;
use crate::instructions::Instructions;
use crate::steps::Steps;

/// The operations by which the core computes a quantity of a robot.
///
/// It is made in milliseconds, without a compiler, and lent to any number of threads.
#[derive(Clone, Debug)]
pub struct Recording {
    pub(crate) quantity: Quantity,
    pub(crate) dof: usize,
    pub(crate) steps: Steps,
}

impl Recording {
    /// Records `quantity` of `model`.
    ///
    /// # Errors
    /// If a link of [`Quantity::Kinematics`] is not there, or if a constant of the robot is too large for its precision.
    pub fn new(model: &Model, quantity: Quantity) -> Result<Self, BatchError> {
        let links = match quantity {
            Quantity::Kinematics(link) => {
                let known = model.links().get(link).ok_or(BatchError::Unanswered { quantity: quantity.name() })?;
                Some(vec![known.name.clone()])
            }
            _ => None,
        };
        let program = Program::new(model, &Options { outputs: Some(vec![quantity]), links, ..Options::default() })?;
        let outputs = program.functions.iter().flat_map(|function| &function.outputs);
        let places: Vec<_> = outputs.flat_map(|output| &output.places).copied().collect();
        let inputs = program.inputs.iter().map(|input| input.len as u32).sum();
        let steps = Steps::new(program.graph.operations(), &places, inputs);
        Ok(Self { quantity, dof: model.dof(), steps })
    }

    /// What it takes to perform it, by the widest instructions of this processor; one for each thread.
    pub fn blocks(&self) -> Blocks<'_> {
        self.blocks_by(Instructions::widest())
    }

    /// [`blocks`](Self::blocks) by these instructions; as compiled where the processor has them not.
    pub fn blocks_by(&self, instructions: Instructions) -> Blocks<'_> {
        Blocks::new(self, instructions)
    }

    /// How many steps it has: operations, of which a product and a sum that alone reads it are one.
    pub fn steps(&self) -> usize {
        self.steps.steps.len()
    }

    /// How many numbers of a state it holds at a time.
    pub fn slots(&self) -> usize {
        self.steps.slots
    }
}
