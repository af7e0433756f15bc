//! A robot of straight-line code, generated or compiled at run time.

use std::hint::black_box;
use std::ops::Range;

use frs_core::{FloatingBase, Quantity};

use crate::contestant::{Contestant, Part};
use crate::number::Number;
use crate::states::{State, grouped};
use crate::work::Work;

/// Such a robot, with room for its answers.
pub struct Ready<T, R> {
    robot: R,
    states: Vec<State<T>>,
    /// A set of outputs for each quantity.
    answers: Vec<(Quantity, Vec<Vec<T>>)>,
    gravity: [T; 3],
}

impl<T: Number, R: FloatingBase<T>> Ready<T, R> {
    /// For `robot`, at these states.
    pub fn new(robot: R, states: &[State]) -> Self {
        let n = robot.dof();
        let room = |quantity: Quantity| quantity.outputs().map(|output| vec![T::zero(); output.len(n)]).collect();
        let known = Quantity::ALL.into_iter().filter(|&quantity| robot.answers(quantity));
        let answers = known.map(|quantity| (quantity, room(quantity))).collect();
        Self { robot, states: grouped(states), answers, gravity: [T::zero(); 3] }
    }

    fn all(&mut self, quantity: Quantity, groups: Range<usize>) {
        let Some((_, outputs)) = self.answers.iter_mut().find(|(known, _)| *known == quantity) else { return };
        let mut outputs = outputs.iter_mut().map(Vec::as_mut_slice);
        // As many as any of them has.
        let mut outputs: [&mut [T]; 5] = std::array::from_fn(|_| outputs.next().unwrap_or_default());
        let count = outputs.iter().take_while(|output| !output.is_empty()).count();
        let (robot, outputs) = (&mut self.robot, &mut outputs[..count]);
        for group in groups {
            let State { q, qd, mu, wrench, tau } = black_box(&self.states[group]);
            let (all, few): ([&[T]; 6], _) = match quantity {
                Quantity::ForwardDynamics => ([q, qd, mu, &self.gravity, wrench, tau], 6),
                Quantity::DQdot => ([q, qd, &[], &[], &[], &[]], 2),
                Quantity::Matrices => ([q, mu, &[], &[], &[], &[]], 2),
                _ => ([q, &[], &[], &[], &[], &[]], 1),
            };
            robot.answer(quantity, &all[..few], outputs);
        }
        black_box(outputs);
    }
}

impl<T: Number, R: FloatingBase<T>> Contestant for Ready<T, R> {
    fn does(&self, work: Work) -> bool {
        let quantities = work.quantities();
        !quantities.is_empty() && quantities.iter().all(|&quantity| self.robot.answers(quantity))
    }

    fn groups(&self) -> usize {
        self.states.len()
    }

    fn lanes(&self) -> usize {
        T::LANES
    }

    fn run(&mut self, work: Work, groups: Range<usize>) {
        match *work.quantities() {
            [quantity] => self.all(quantity, groups),
            _ => groups.for_each(|group| {
                work.quantities().iter().for_each(|&quantity| self.all(quantity, group..group + 1));
            }),
        }
    }

    fn answer(&self, work: Work, lane: usize) -> Vec<Part> {
        let given = self.answers.iter().filter(|(quantity, _)| work.quantities().contains(quantity));
        let parts = given.flat_map(|(quantity, outputs)| quantity.outputs().zip(outputs));
        parts.map(|(output, numbers)| (output.name, numbers.iter().map(|number| number.lane(lane)).collect())).collect()
    }
}
