//! The core, for any robot.

use std::hint::black_box;
use std::ops::Range;

use frs_core::spatial::{Twist, Wrench};
use frs_core::{Curvature, Model, Workspace};
use nalgebra::{DMatrix, Matrix6xX};

use crate::contestant::{Contestant, Part};
use crate::number::Number;
use crate::states::{State, grouped};
use crate::work::Work;

/// The core with room for its answers, asked as directly as its methods allow.
pub struct Core<'m, T: Number> {
    work: Workspace<'m, T>,
    states: Vec<State<T>>,
    locked: Vec<T>,
    connection: Matrix6xX<T>,
    shape: DMatrix<T>,
    d_mu: DMatrix<T>,
    d_qdot: DMatrix<T>,
    xi_dot: Vec<T>,
    curvature: Curvature<T>,
}

impl<'m, T: Number> Core<'m, T> {
    /// For `model`, at these states.
    pub fn new(model: &'m Model<T>, states: &[State]) -> Self {
        let n = model.dof();
        Self {
            work: Workspace::new(model),
            states: grouped(states),
            locked: vec![T::zero(); 36],
            connection: Matrix6xX::zeros(n),
            shape: DMatrix::zeros(n, n),
            d_mu: DMatrix::zeros(6 + n, 6 + n),
            d_qdot: DMatrix::zeros(6 + n, 6 + n),
            xi_dot: vec![T::zero(); 6 + n],
            curvature: Curvature::new(n),
        }
    }

    fn one(&mut self, work: Work, group: usize) {
        let state = black_box(&self.states[group]);
        let mut shape = self.work.shape(&state.q);
        let (mu, wrench) = (Twist::from_array(state.mu), Wrench::from_array(state.wrench));
        if matches!(work, Work::Inertia | Work::Matrices | Work::AllD) {
            self.locked.copy_from_slice(shape.locked_inertia().to_matrix().as_slice());
            shape.connection(&mut self.connection);
            shape.shape_inertia(&mut self.shape);
        }
        match work {
            Work::PositionSweep | Work::Inertia | Work::Mass => {}
            Work::Matrices => shape.d_mu(mu, &mut self.d_mu),
            Work::AllD => {
                shape.d_mu(mu, &mut self.d_mu);
                shape.moving(&state.qd).d_qdot(&mut self.d_qdot);
            }
            Work::ForwardFactored => shape.moving(&state.qd).forward_dynamics(mu, wrench, &state.tau, &mut self.xi_dot),
            Work::Forward => {
                shape.moving(&state.qd).forward_dynamics_articulated(mu, wrench, &state.tau, &mut self.xi_dot);
            }
            Work::Curvature => shape.curvature(&mut self.curvature),
        }
    }
}

impl<T: Number> Contestant for Core<'_, T> {
    fn does(&self, work: Work) -> bool {
        work != Work::Mass
    }

    fn groups(&self) -> usize {
        self.states.len()
    }

    fn lanes(&self) -> usize {
        T::LANES
    }

    fn run(&mut self, work: Work, groups: Range<usize>) {
        groups.for_each(|group| self.one(work, group));
        black_box(self);
    }

    fn answer(&self, work: Work, lane: usize) -> Vec<Part> {
        let part = |name, numbers: &[T]| (name, numbers.iter().map(|number| number.lane(lane)).collect());
        let mut parts = Vec::new();
        if matches!(work, Work::Inertia | Work::Matrices | Work::AllD) {
            parts.push(part("locked_inertia", &self.locked));
            parts.push(part("connection", self.connection.as_slice()));
            parts.push(part("shape_inertia", self.shape.as_slice()));
        }
        if matches!(work, Work::Matrices | Work::AllD) {
            parts.push(part("d_mu", self.d_mu.as_slice()));
        }
        match work {
            Work::AllD => parts.push(part("d_qdot", self.d_qdot.as_slice())),
            Work::Forward | Work::ForwardFactored => parts.push(part("xi_dot", &self.xi_dot)),
            Work::Curvature => {
                let layers: Vec<T> = self.curvature.angular.iter().flat_map(|layer| layer.iter().copied()).collect();
                parts.push(part("curvature", &layers));
                parts.push(part("com", self.curvature.com.as_slice()));
            }
            _ => {}
        }
        parts
    }
}
