//! Random states of a robot.

use frs::Model;
use frs::spatial::{Twist, Wrench};

/// What a robot does, and what pushes it.
pub struct State {
    pub q: Vec<f64>,
    pub qd: Vec<f64>,
    pub mu: Twist<f64>,
    pub wrench: Wrench<f64>,
    pub tau: Vec<f64>,
}

/// `count` random states, always the same.
pub fn states(model: &Model, count: usize) -> Vec<State> {
    let mut rng = fastrand::Rng::with_seed(7);
    let mut unit = || 2.0 * rng.f64() - 1.0;
    (0..count)
        .map(|_| {
            let mut vector = |scale: f64| (0..model.dof()).map(|_| scale * unit()).collect::<Vec<_>>();
            let (q, qd, tau) = (vector(std::f64::consts::PI), vector(1.0), vector(1.0));
            let mut six = || std::array::from_fn(|_| unit());
            State { q, qd, mu: Twist::from_array(six()), wrench: Wrench::from_array(six()), tau }
        })
        .collect()
}
