//! Joints that are held, and masses that are scaled: the formulas stay what they are.

use frs_core::spatial::Symmetric3;
use frs_core::{Evaluator, Model};
use frs_oracles::{Case, ROUNDING, Values, compare, shapes};

/// Shapes a case is tried at.
const SHAPES: usize = 10;

/// No power of two, so that scaling changes every digit.
const FACTOR: f64 = 3.7;

fn agrees(case: Case, what: &str, model: &Model, q: &[f64], expected: &Values<f64>) {
    let found = Values::of(&mut Evaluator::new(model), q);
    let comparison = compare(&found.widened(), &expected.widened());
    let [connection, curvature] = [&comparison.connection, &comparison.curvature];
    assert!(comparison.within(ROUNDING), "{case:?}, {what}, at {q:?}: {connection}; {curvature}");
}

fn holding_a_joint_takes_its_column_away(case: Case) {
    let model = case.model();
    let n = model.dof();
    for (held, coordinate) in model.coordinates().iter().enumerate() {
        for q in shapes(case, SHAPES, 10) {
            let name = coordinate.name.as_str();
            let stiff = model.lock(&[(name, q[held])]).unwrap_or_else(|error| panic!("{case:?}: {error}"));
            let formula: Values<f64> = case.values(&q);
            let free: Vec<usize> = (0..n).filter(|&i| i != held).collect();
            let expected = Values {
                connection: free.iter().map(|&i| formula.connection[i]).collect(),
                curvature: Values::<f64>::pairs(n - 1).map(|(i, j)| formula.curvature(free[i], free[j])).collect(),
                com: formula.com,
            };
            let rest: Vec<f64> = free.iter().map(|&i| q[i]).collect();
            agrees(case, &format!("{name} held"), &stiff, &rest, &expected);
        }
    }
}

fn scaling_all_masses_changes_nothing(case: Case) {
    let mut robot = case.robot();
    for link in &mut robot.links {
        link.inertial.mass *= FACTOR;
        let Symmetric3 { xx, xy, xz, yy, yz, zz } = link.inertial.inertia;
        let [xx, xy, xz, yy, yz, zz] = [xx, xy, xz, yy, yz, zz].map(|entry| entry * FACTOR);
        link.inertial.inertia = Symmetric3 { xx, xy, xz, yy, yz, zz };
    }
    let model = robot.build().unwrap_or_else(|error| panic!("{case:?}: {error}"));
    for q in shapes(case, SHAPES, 11) {
        agrees(case, "all masses scaled", &model, &q, &case.values(&q));
    }
}

every_case_with_pairs!(holding_a_joint_takes_its_column_away);
every_case!(scaling_all_masses_changes_nothing);
