//! Operations, counted by recording them.

use frs::spatial::Twist;
use frs::{Model, Workspace};
use frs_codegen::record::{Operation, Place, Recorded, record};
use frs_codegen::{Counts, Graph, Precision};
use frs_sim::motion::{Instant, Load, Loads};
use frs_sim::run::equations;
use frs_sim::scene::{Case, Equations, Scene};

use crate::cli::recording::{Inputs, Recording};

/// What one evaluation of a scene's equations performs.
pub struct Costs {
    /// Each effect, in the scene's order; none for those that change the equations instead of adding forces.
    pub effects: Vec<Option<Counts>>,
    /// Everything.
    pub whole: Counts,
    /// What is left when constants are folded, equal terms shared, and unused ones dropped.
    pub needed: Counts,
}

impl Costs {
    pub fn of(scene: &Scene, model: &Model) -> Self {
        let [whole, needed] = Self::of_equations(scene, model);
        Self { effects: (0..scene.forces.len()).map(|i| of_effect(scene, model, i)).collect(), whole, needed }
    }

    /// Everything, and what is needed, while most acts.
    pub fn of_equations(scene: &Scene, model: &Model) -> [Counts; 2] {
        let events: Vec<f64> = scene.forces.iter().flat_map(|named| named.force.knots()).collect();
        // Between two events the same forces act.
        let phases = events.into_iter().chain([0.0]).filter(|time| (0.0..scene.duration).contains(time));
        let each = phases.map(|time| of_phase(scene, model, time));
        each.max_by_key(|[whole, _]| whole.flops()).unwrap_or_default()
    }
}

/// What one evaluation performs with the forces that act from `time` on: all of it, and what is needed.
fn of_phase(scene: &Scene, model: &Model, time: f64) -> [Counts; 2] {
    let numbers = 2 * model.dof() + scene.case().numbers();
    let laden = scene.laden(model, time);
    let Recording { tape, start, outputs, .. } = Recording::of(&laden, numbers, |model| equations(scene, model, time));
    [counted(tape[start..].iter()), needed(&tape, &outputs)]
}

/// What an effect performs by itself, while it acts and touches what it can touch.
fn of_effect(scene: &Scene, model: &Model, number: usize) -> Option<Counts> {
    let mut alone = Scene { forces: vec![scene.forces[number].clone()], ..scene.clone() };
    if scene.case() != Case::Ballistic {
        // Alone, gravity would be known to move the centre of mass and nothing else.
        alone.solver.equations = Equations::Integrated;
    }
    let first = alone.forces[0].force.knots().first().copied().unwrap_or(0.0);
    if alone.effects::<f64>(model).0.is_empty() {
        return None;
    }
    let (start, tape) = record(|| {
        let model: Model<Recorded> = model.cast();
        let n = model.dof();
        let mut inputs = Inputs::default();
        let state = inputs.state(2 * n);
        let mu = Twist::from_array(std::array::from_fn(|_| inputs.next()));
        let (q, qd) = state.flat.split_at(n);
        let mut work = Workspace::new(&model);
        let mut shape = work.shape(q);
        let mut robot = shape.moving(qd);
        let mut effects = alone.effects(&model);
        effects.enter(first);
        let instant = Instant { time: inputs.next(), pose: &state.pose, q, qd, mu };
        let (mut gaps, mut owners) = (Vec::new(), Vec::new());
        effects.gaps(&instant, &mut robot, &mut gaps, &mut owners);
        owners.iter().for_each(|owner| effects.touch(*owner, true));
        let mut load = Load { gravity: [instant.time; 3], tau: vec![instant.time; n], ..Load::zero(n) };
        let start = inputs.next();
        effects.add(&instant, &mut robot, &mut load);
        start.0
    });
    Some(counted(tape[start as usize..].iter()))
}

fn counted<'a>(operations: impl Iterator<Item = &'a Operation>) -> Counts {
    let mut counts = Counts::default();
    operations.for_each(|operation| counts.count(*operation));
    counts
}

fn needed(tape: &[Operation], outputs: &[Place]) -> Counts {
    let mut graph = Graph::new(Precision::Double);
    let places = graph.absorb(tape);
    let mut used = vec![false; graph.operations().len()];
    outputs.iter().for_each(|&output| used[places[output as usize] as usize] = true);
    // Operands come first.
    for place in (0..used.len()).rev() {
        if used[place] {
            graph.operation(place as Place).operands().for_each(|operand| used[operand as usize] = true);
        }
    }
    counted(graph.operations().iter().zip(&used).filter(|(_, used)| **used).map(|(operation, _)| operation))
}
