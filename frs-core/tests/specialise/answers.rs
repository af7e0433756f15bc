//! What a robot answers at a state.

use frs_core::spatial::Twist;
use frs_core::{Model, Workspace};
use nalgebra::{DMatrix, Matrix6xX};
use proptest::prelude::*;

use crate::robots::MOST_LINKS;

/// A state: q, q̇ and q̈ of each coordinate, and μ.
#[derive(Clone, Debug)]
pub struct State {
    pub coordinates: Vec<[f64; 3]>,
    pub mu: [f64; 6],
}

/// A state with as many coordinates as a random robot can have.
pub fn states() -> impl Strategy<Value = State> {
    let coordinates = prop::collection::vec(prop::array::uniform3(-1.5..1.5), MOST_LINKS);
    (coordinates, prop::array::uniform6(-1.5..1.5)).prop_map(|(coordinates, mu)| State { coordinates, mu })
}

/// Quantities that together need everything of the model.
pub struct Answers {
    pub locked_inertia: DMatrix<f64>,
    pub connection: DMatrix<f64>,
    pub shape_inertia: DMatrix<f64>,
    pub d_mu: DMatrix<f64>,
    /// Rotations and translations, a column a link.
    pub link_poses: DMatrix<f64>,
    /// Base wrench and torques that ξ̇ = [1, …, 1; q̈] takes.
    pub forces: DMatrix<f64>,
}

impl Answers {
    /// The answers of `model` at the first coordinates of `state`.
    pub fn new(model: &Model, state: &State) -> Self {
        let n = model.dof();
        let [q, qd, qdd] = [0, 1, 2].map(|i| state.coordinates[..n].iter().map(|c| c[i]).collect::<Vec<_>>());
        let mu = Twist::from_array(state.mu);
        let (mut connection, mut torque) = (Matrix6xX::from_element(n, f64::NAN), vec![f64::NAN; n]);
        let (mut shape_inertia, mut d_mu) = (DMatrix::repeat(n, n, f64::NAN), DMatrix::repeat(6 + n, 6 + n, f64::NAN));
        let mut work = Workspace::new(model);
        let mut shape = work.shape(&q);
        shape.connection(&mut connection);
        shape.shape_inertia(&mut shape_inertia);
        shape.d_mu(mu, &mut d_mu);
        let poses = (0..model.links().len()).flat_map(|link| {
            let pose = shape.link_pose(link);
            pose.rotation.iter().chain(&pose.translation).copied().collect::<Vec<_>>()
        });
        let link_poses = DMatrix::from_iterator(12, model.links().len(), poses);
        let locked_inertia = DMatrix::from_column_slice(6, 6, shape.locked_inertia().to_matrix().as_slice());
        let wrench = shape.moving(&qd).inverse_dynamics(mu, &[&[1.0; 6], &qdd[..]].concat(), &mut torque);
        Self {
            locked_inertia,
            connection: DMatrix::from_column_slice(6, n, connection.as_slice()),
            shape_inertia,
            d_mu,
            link_poses,
            forces: DMatrix::from_vec(6 + n, 1, [&wrench.to_array(), &torque[..]].concat()),
        }
    }

    pub fn matrices(&self) -> [&DMatrix<f64>; 6] {
        [&self.locked_inertia, &self.connection, &self.shape_inertia, &self.d_mu, &self.link_poses, &self.forces]
    }

    /// What is left of them of the coordinates `free`.
    pub fn keep(&self, free: &[usize]) -> Self {
        let with_base: Vec<usize> = (0..6).chain(free.iter().map(|coordinate| 6 + coordinate)).collect();
        Self {
            locked_inertia: self.locked_inertia.clone(),
            connection: self.connection.select_columns(free),
            shape_inertia: self.shape_inertia.select_rows(free).select_columns(free),
            d_mu: self.d_mu.select_rows(&with_base).select_columns(&with_base),
            link_poses: self.link_poses.clone(),
            forces: self.forces.select_rows(&with_base),
        }
    }
}
