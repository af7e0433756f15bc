//! The pieces of work that are timed, each as one call on a state.

use frs::nalgebra::{DMatrix, Matrix6xX};
use frs::{Model, Workspace};

use crate::states::State;

/// Memory for one robot, so that nothing is allocated while the clock runs.
pub struct Bench<'m> {
    work: Workspace<'m>,
    connection: Matrix6xX<f64>,
    shape_inertia: DMatrix<f64>,
    d_mu: DMatrix<f64>,
    xi_dot: Vec<f64>,
}

/// One piece of work.
pub type Work = fn(&mut Bench, &State) -> f64;

/// Every piece of work, by name.
pub const ALL: [(&str, Work); 5] = [
    ("position_sweep", |bench, state| bench.position_sweep(state)),
    ("inertia", |bench, state| bench.inertia(state)),
    ("inertia_coupling", |bench, state| bench.inertia_coupling(state)),
    ("forward_factored", |bench, state| bench.forward_factored(state)),
    ("forward_articulated", |bench, state| bench.forward_articulated(state)),
];

impl<'m> Bench<'m> {
    pub fn new(model: &'m Model) -> Self {
        let n = model.dof();
        Self {
            work: Workspace::new(model),
            connection: Matrix6xX::zeros(n),
            shape_inertia: DMatrix::zeros(n, n),
            d_mu: DMatrix::zeros(6 + n, 6 + n),
            xi_dot: vec![0.0; 6 + n],
        }
    }

    /// All that depends on q alone, before a matrix is asked for: O(n).
    fn position_sweep(&mut self, state: &State) -> f64 {
        self.work.shape(&state.q).com().x
    }

    /// Λ_b, A_l, Λ_q.
    fn inertia(&mut self, state: &State) -> f64 {
        let mut shape = self.work.shape(&state.q);
        shape.connection(&mut self.connection);
        shape.shape_inertia(&mut self.shape_inertia);
        shape.locked_inertia().rotational.xx
    }

    /// Λ_b, A_l, Λ_q, D_μ, and B_2, which is −½ of D_μ's last block.
    fn inertia_coupling(&mut self, state: &State) -> f64 {
        let mut shape = self.work.shape(&state.q);
        shape.connection(&mut self.connection);
        shape.shape_inertia(&mut self.shape_inertia);
        shape.d_mu(state.mu, &mut self.d_mu);
        shape.locked_inertia().rotational.xx
    }

    /// ξ̇ by factoring Λ_q.
    fn forward_factored(&mut self, state: &State) -> f64 {
        let mut shape = self.work.shape(&state.q);
        shape.moving(&state.qd).forward_dynamics(state.mu, state.wrench, &state.tau, &mut self.xi_dot);
        self.xi_dot[0]
    }

    /// ξ̇ by the articulated sweep.
    fn forward_articulated(&mut self, state: &State) -> f64 {
        let mut shape = self.work.shape(&state.q);
        shape.moving(&state.qd).forward_dynamics_articulated(state.mu, state.wrench, &state.tau, &mut self.xi_dot);
        self.xi_dot[0]
    }
}
