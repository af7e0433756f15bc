//! `frs eval --compiled`: the same evaluation, recorded once and compiled.

use frs::jit::{Code, JitError};
use frs::spatial::{Twist, Wrench};
use frs::{Model, Workspace};
use frs_codegen::record::{Place, Recorded, record};

use super::evaluation::Evaluation;
use crate::cli::answer::Key;
use crate::cli::state::{BaseMotion, State};

/// The quantities of a robot as machine code.
pub struct Compiled {
    /// For states that give μ, and for those that give V₁.
    recordings: [Recording; 2],
}

struct Recording {
    code: Code,
    /// Where each number of an evaluation is among the outputs.
    evaluation: Evaluation<usize>,
    outputs: Vec<f64>,
}

impl Compiled {
    /// Compiles `keys` of `model`.
    ///
    /// # Errors
    /// Where no machine code can be made.
    pub fn new(model: &Model, keys: &[Key]) -> Result<Self, JitError> {
        let locked = Recording::new(model, keys, BaseMotion::Locked)?;
        Ok(Self { recordings: [locked, Recording::new(model, keys, BaseMotion::Base)?] })
    }

    /// Computes the quantities at `state`.
    pub fn evaluate(&mut self, state: &State) -> Evaluation<f64> {
        let [locked, moving] = &mut self.recordings;
        match state.base {
            BaseMotion::Locked(mu) => locked.evaluate(state, mu),
            BaseMotion::Base(base_twist) => moving.evaluate(state, base_twist),
        }
    }
}

impl Recording {
    fn new(model: &Model, keys: &[Key], base: fn(Twist<Recorded>) -> BaseMotion<Recorded>) -> Result<Self, JitError> {
        let n = model.dof();
        let mut inputs = 0;
        let mut next = || {
            inputs += 1;
            Recorded::input(inputs - 1)
        };
        let (evaluation, tape) = record(|| {
            let mut vector = |len| (0..len).map(|_| next()).collect::<Vec<_>>();
            let (q, qd, tau) = (vector(n), vector(n), vector(n));
            let mut six = || std::array::from_fn(|_| next());
            let (base, base_wrench) = (base(Twist::from_array(six())), Wrench::from_array(six()));
            let state = State { q, qd, base, base_wrench, tau };
            Evaluation::new(&mut Workspace::new(&model.cast()), &state, keys)
        });
        let mut places: Vec<Place> = Vec::new();
        let evaluation = evaluation.map(|number: Recorded| {
            places.push(number.0);
            places.len() - 1
        });
        let code = Code::compile(&tape, &places, inputs as usize)?;
        Ok(Self { code, evaluation, outputs: vec![0.0; places.len()] })
    }

    fn evaluate(&mut self, state: &State, base: Twist<f64>) -> Evaluation<f64> {
        let inputs = [&state.q, &state.qd, &state.tau, &base.to_array()[..], &state.base_wrench.to_array()].concat();
        self.code.call(&inputs, &mut self.outputs);
        self.evaluation.clone().map(|output| self.outputs[output])
    }
}
