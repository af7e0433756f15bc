//! A robot compiled while the program runs.

use frs_codegen::record::Place;
use frs_codegen::{GenerateError, Options, Program};
use frs_core::generated::refuse;
use frs_core::{FloatingBase, Model, Quantity};

use crate::code::Code;
use crate::error::JitError;

/// A robot that answers the quantities it was compiled for, with the bits of [`Evaluator`](frs_core::Evaluator) and faster.
///
/// ```
/// use frs_core::{FloatingBase, Model, Quantity};
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// let mut robot = frs_jit::Robot::new(&model, &[Quantity::B2])?;
/// let mut b2 = [0.0; 49];
/// robot.answer(Quantity::B2, &[&[0.3; 7], &[0.0, 0.2, 0.0, 0.0, 0.0, 0.0]], &mut [&mut b2]);
/// assert_eq!(b2[1], -b2[7]); // skew
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// It allocates when it is made and never again.
#[derive(Debug)]
pub struct Robot {
    dof: usize,
    codes: Vec<(Quantity, Code)>,
}

impl Robot {
    /// Compiles `quantities` of `model`.
    ///
    /// # Errors
    /// If a link of [`Quantity::Kinematics`] is not there, or as [`Code::compile`].
    pub fn new(model: &Model, quantities: &[Quantity]) -> Result<Self, JitError> {
        let codes = quantities.iter().map(|&quantity| Ok((quantity, compile(model, quantity)?)));
        Ok(Self { dof: model.dof(), codes: codes.collect::<Result<_, JitError>>()? })
    }

    /// The code of each quantity.
    pub fn codes(&self) -> &[(Quantity, Code)] {
        &self.codes
    }
}

impl FloatingBase for Robot {
    fn dof(&self) -> usize {
        self.dof
    }

    fn answers(&self, quantity: Quantity) -> bool {
        self.codes.iter().any(|&(known, _)| known == quantity)
    }

    fn answer(&mut self, quantity: Quantity, inputs: &[&[f64]], outputs: &mut [&mut [f64]]) {
        match self.codes.iter_mut().find(|(known, _)| *known == quantity) {
            Some((_, code)) => code.call_slices(inputs, outputs),
            None => refuse(quantity, false),
        }
    }
}

/// Records and compiles one quantity.
fn compile(model: &Model, quantity: Quantity) -> Result<Code, JitError> {
    let links = match quantity {
        Quantity::Kinematics(link) => Some(vec![name(model, link)?]),
        _ => None,
    };
    let program = Program::new(model, &Options { outputs: Some(vec![quantity]), links, ..Options::default() })?;
    let outputs = program.functions.iter().flat_map(|function| &function.outputs);
    let outputs: Vec<&[Place]> = outputs.map(|output| output.places.as_slice()).collect();
    let inputs: Vec<usize> = program.inputs.iter().map(|input| input.len).collect();
    Code::compile_slices(program.graph.operations(), &outputs, &inputs)
}

/// The name of link number `link`.
fn name(model: &Model, link: usize) -> Result<String, GenerateError> {
    let names = || model.links().iter().map(|link| link.name.as_str());
    names().nth(link).map(str::to_owned).ok_or_else(|| GenerateError::UnknownLink {
        link: format!("number {link}"),
        known: names().collect::<Vec<_>>().join(", "),
    })
}
