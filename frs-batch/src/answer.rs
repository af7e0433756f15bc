//! A quantity at every row of arrays, on several threads.

use std::sync::{Mutex, PoisonError};

use frs_core::{Argument, Quantity};
use ndarray::{ArrayView2, ArrayViewMut2, Axis};

use crate::error::BatchError;
use crate::group::Group;

/// States of a task at least: so few are computed in less time than a thread takes to wake up.
const TASK: usize = 64;

/// Tasks a thread: a thread that is held up leaves its share to the others.
const SHARES: usize = 8;

/// Computes `quantity` at every state: arrays are those that it lists, in its order, a state a row, with any strides.
///
/// A matrix is a row of numbers, column by column. The states are shared among the threads of the rayon pool in which this is called; every
/// thread asks `robot` for one of its own. No thread count and no [`Group`] changes a bit of a state's answer. States beyond whole groups are computed
/// with the last state repeated; nothing outside of the arrays is read.
///
/// # Errors
/// If an array is missing or has not its shape, or if the robot does not answer `quantity`.
pub fn answer<G: Group>(
    robot: impl Fn() -> G + Sync,
    quantity: Quantity,
    inputs: &[ArrayView2<'_, G::Element>],
    outputs: Vec<ArrayViewMut2<'_, G::Element>>,
) -> Result<(), BatchError> {
    let mut first = robot();
    check(&first, quantity, inputs, &outputs)?;
    let states = inputs[0].nrows();
    let group = first.states();
    let threads = rayon::current_num_threads();
    let share = states.div_ceil(threads * SHARES).max(TASK).next_multiple_of(group);
    if threads == 1 || states <= share {
        work(&mut first, quantity, Task { inputs: inputs.to_vec(), outputs });
        return Ok(());
    }
    let tasks = Mutex::new(Task { inputs: inputs.to_vec(), outputs }.cut(share));
    // The lock is held only while a task is taken, which cannot panic.
    let next = || tasks.lock().unwrap_or_else(PoisonError::into_inner).pop();
    let thread = || {
        let Some(mut task) = next() else { return };
        let mut robot = robot();
        loop {
            work(&mut robot, quantity, task);
            match next() {
                Some(another) => task = another,
                None => return,
            }
        }
    };
    // Nobody waits for a thread that is busy elsewhere: the others leave it nothing to do.
    rayon::scope(|scope| (0..threads).for_each(|_| scope.spawn(|_| thread())));
    Ok(())
}

/// Rows of all arrays.
struct Task<'a, E> {
    inputs: Vec<ArrayView2<'a, E>>,
    outputs: Vec<ArrayViewMut2<'a, E>>,
}

impl<E> Task<'_, E> {
    fn states(&self) -> usize {
        self.inputs[0].nrows()
    }

    /// The first `states` rows, and what is left.
    fn split(self, states: usize) -> (Self, Self) {
        let (inputs, more_inputs) = self.inputs.into_iter().map(|array| array.split_at(Axis(0), states)).unzip();
        let (outputs, more_outputs) = self.outputs.into_iter().map(|array| array.split_at(Axis(0), states)).unzip();
        (Self { inputs, outputs }, Self { inputs: more_inputs, outputs: more_outputs })
    }

    /// Tasks of `states` rows, the last one with fewer.
    fn cut(mut self, states: usize) -> Vec<Self> {
        let mut tasks = Vec::new();
        while self.states() > states {
            let (task, rest) = self.split(states);
            tasks.push(task);
            self = rest;
        }
        tasks.push(self);
        tasks
    }
}

/// Answers a task, group by group.
fn work<G: Group>(robot: &mut G, quantity: Quantity, mut task: Task<'_, G::Element>) {
    let group = robot.states();
    while task.states() > group {
        let (mut now, rest) = task.split(group);
        robot.answer(quantity, &now.inputs, &mut now.outputs);
        task = rest;
    }
    if task.states() > 0 {
        robot.answer(quantity, &task.inputs, &mut task.outputs);
    }
}

fn check<G: Group>(
    robot: &G,
    quantity: Quantity,
    inputs: &[ArrayView2<'_, G::Element>],
    outputs: &[ArrayViewMut2<'_, G::Element>],
) -> Result<(), BatchError> {
    if !robot.answers(quantity) {
        return Err(BatchError::Unanswered { quantity: quantity.name() });
    }
    let inputs: Vec<[usize; 2]> = inputs.iter().map(|array| array.dim().into()).collect();
    let outputs: Vec<[usize; 2]> = outputs.iter().map(|array| array.dim().into()).collect();
    let arguments: [Vec<Argument>; 2] = [quantity.inputs().collect(), quantity.outputs().collect()];
    for ((side, arguments), found) in ["inputs", "outputs"].into_iter().zip(&arguments).zip([&inputs, &outputs]) {
        if found.len() != arguments.len() {
            let names = arguments.iter().map(|argument| argument.name).collect::<Vec<_>>().join(", ");
            let (found, expected) = (found.len(), arguments.len());
            return Err(BatchError::Arrays { quantity: quantity.name(), side, found, expected, names });
        }
    }
    for (argument, found) in arguments.iter().flatten().zip(inputs.iter().chain(&outputs)) {
        let expected = [inputs[0][0], argument.len(robot.dof())];
        if *found != expected {
            return Err(BatchError::Shape { quantity: quantity.name(), name: argument.name, found: *found, expected });
        }
    }
    Ok(())
}
