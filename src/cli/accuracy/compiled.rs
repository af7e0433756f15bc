//! Motions by machine code that is made for the scene. Making it is not counted as their cost.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::Range;
use std::rc::Rc;

use frs::Model;
use frs::spatial::Wrench;
use frs_sim::integrate::{IntegrationError, State, System, Tangent};
use frs_sim::run::{Code, Equations, equations};
use frs_sim::scene::{Scene, Start};
use frs_sim::study::{Judged, Truth, Variant};

use crate::cli::compiled::Compiled;
use crate::cli::recording::Recording;

type Shared = Rc<RefCell<Compiled>>;

/// Code for the equations and routes of a scene, for each time at which other forces begin to act.
pub struct Codes<'s> {
    scene: &'s Scene,
    model: &'s Model,
    known: HashMap<([&'static str; 2], u64), Option<Shared>>,
}

impl<'s> Codes<'s> {
    pub fn new(scene: &'s Scene, model: &'s Model) -> Self {
        Self { scene, model, known: HashMap::new() }
    }

    /// The motion of a variant.
    ///
    /// # Errors
    /// If it cannot be computed this way.
    pub fn judge(&mut self, truth: &Truth, variant: &Variant) -> Result<Judged, IntegrationError> {
        let [_, _, kind, route, ..] = variant.names();
        let scene = Scene { solver: variant.solver, ..self.scene.clone() };
        let knots = scene.forces.iter().flat_map(|named| named.force.knots());
        for time in knots.chain([0.0]).filter(|time| (0.0..scene.duration).contains(time)) {
            self.known.entry(([kind, route], time.to_bits())).or_insert_with(|| made(&scene, self.model, time));
        }
        truth.judge_with(variant.solver, &mut |time| {
            let core = equations(&scene, self.model, time);
            match &self.known[&([kind, route], time.to_bits())] {
                Some(code) => Box::new(ByCode { core, code: Rc::clone(code) }),
                None => core,
            }
        })
    }
}

/// Code for what acts from `time` (s) on, where it can be made.
fn made(scene: &Scene, model: &Model, time: f64) -> Option<Shared> {
    let numbers = 2 * model.dof() + scene.case().numbers();
    let recording = Recording::of(model, numbers, |model| equations(scene, model, time));
    Compiled::new(&recording).ok().map(|code| Rc::new(RefCell::new(code)))
}

/// Equations whose rates are computed by code.
struct ByCode<'m> {
    core: Box<dyn Equations<f64> + 'm>,
    code: Shared,
}

impl System for ByCode<'_> {
    fn dimension(&self) -> usize {
        self.core.dimension()
    }

    fn velocities(&self) -> Range<usize> {
        self.core.velocities()
    }

    fn rate(&mut self, time: f64, state: &State, rate: &mut Tangent) {
        self.code.borrow_mut().rate(time, state, rate);
    }
}

impl Equations<f64> for ByCode<'_> {
    fn start(&mut self, start: &Start) -> State {
        self.core.start(start)
    }

    fn shape(&mut self, time: f64, state: &State) -> Vec<f64> {
        self.core.shape(time, state)
    }

    fn momentum(&mut self, time: f64, state: &State) -> Wrench<f64> {
        self.core.momentum(time, state)
    }

    fn kinetic_energy(&mut self, time: f64, state: &State) -> f64 {
        self.core.kinetic_energy(time, state)
    }
}
