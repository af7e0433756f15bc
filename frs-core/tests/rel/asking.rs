//! How the tests ask the core: a case becomes a model, a specification and a workspace, and outputs become matrices.

use frs_core::model::Model;
use frs_core::spatial::{Twist, Wrench};
use frs_core::{Moving, Shape, Workspace};
use nalgebra::{DMatrix, DVector, Matrix6xX, Vector6};
use proptest::test_runner::TestCaseResult;

use crate::specification::Specification;
use crate::trees::Case;

impl Case {
    /// The case's robot, checked.
    pub fn model(&self) -> Model {
        self.robot.build().expect("random trees are valid robots")
    }

    /// The case's robot at its state, by the sums over links.
    pub fn specification(&self, model: &Model) -> Specification {
        Specification::new(&self.robot, &coordinates(model), &self.q, &self.qd)
    }

    /// n.
    pub fn dof(&self) -> usize {
        self.q.len()
    }

    /// Runs `check` on the core at the case's state.
    pub fn ask(&self, check: impl FnOnce(&mut Moving) -> TestCaseResult) -> TestCaseResult {
        moving(&self.model(), &self.q, &self.qd, check)
    }

    /// Runs `check` on the specification and the core at the case's state.
    pub fn judge(&self, check: impl FnOnce(&Specification, &mut Moving) -> TestCaseResult) -> TestCaseResult {
        let model = self.model();
        let specification = self.specification(&model);
        moving(&model, &self.q, &self.qd, |robot| check(&specification, robot))
    }
}

/// Names of a model's coordinates, in the order of the columns.
pub fn coordinates(model: &Model) -> Vec<String> {
    model.coordinates().iter().map(|coordinate| coordinate.name.clone()).collect()
}

/// Asks the core at `q`.
pub fn shaped<R>(model: &Model, q: &DVector<f64>, ask: impl FnOnce(&mut Shape) -> R) -> R {
    ask(&mut Workspace::new(model).shape(q.as_slice()))
}

/// Asks the core at `(q, q̇)`.
pub fn moving<R>(model: &Model, q: &DVector<f64>, qd: &DVector<f64>, ask: impl FnOnce(&mut Moving) -> R) -> R {
    ask(&mut Workspace::new(model).shape(q.as_slice()).moving(qd.as_slice()))
}

/// A 6×n output.
pub fn six_by(n: usize, fill: impl FnOnce(&mut Matrix6xX<f64>)) -> Matrix6xX<f64> {
    let mut out = Matrix6xX::from_element(n, f64::NAN);
    fill(&mut out);
    out
}

/// A square output.
pub fn square(size: usize, fill: impl FnOnce(&mut DMatrix<f64>)) -> DMatrix<f64> {
    let mut out = DMatrix::from_element(size, size, f64::NAN);
    fill(&mut out);
    out
}

/// An output over joints or over base and joints.
pub fn vector(length: usize, fill: impl FnOnce(&mut [f64])) -> DVector<f64> {
    let mut out = DVector::from_element(length, f64::NAN);
    fill(out.as_mut_slice());
    out
}

pub fn twist(six: &Vector6<f64>) -> Twist<f64> {
    Twist::from_array((*six).into())
}

pub fn wrench(six: &Vector6<f64>) -> Wrench<f64> {
    Wrench::from_array((*six).into())
}
