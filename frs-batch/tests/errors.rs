//! What is wrong with a batch is said in words, and nothing is written.

use frs_batch::{BatchError, Recording, Side, answer};
use frs_core::{Evaluator, Model, Quantity, urdf};
use frs_generated::humanoid::Humanoid;
use ndarray::Array2;

fn ask(q: [usize; 2], mu: Option<[usize; 2]>, b2: [usize; 2]) -> String {
    let model = Model::from_urdf(urdf::LWR_SATELLITE).unwrap();
    let (q, mut b2) = (Array2::zeros(q), Array2::from_elem(b2, f64::NAN));
    let mu = mu.map(Array2::zeros);
    let inputs: Vec<_> = [Some(&q), mu.as_ref()].into_iter().flatten().map(|array| array.view()).collect();
    let result = answer(|| Side::new(Evaluator::<f64>::new(&model)), Quantity::B2, &inputs, [b2.view_mut()].into());
    assert!(b2.iter().all(|number| number.is_nan()));
    result.unwrap_err().to_string()
}

#[test]
fn arrays_of_another_shape_are_named() {
    assert_eq!(
        ask([5, 8], Some([5, 6]), [5, 49]),
        "b2: q has 5 rows and 8 columns; expected 5 rows, a state each, of 7 numbers"
    );
    assert_eq!(
        ask([5, 7], Some([4, 6]), [5, 49]),
        "b2: mu has 4 rows and 6 columns; expected 5 rows, a state each, of 6 numbers"
    );
    assert_eq!(
        ask([5, 7], Some([5, 6]), [5, 7]),
        "b2: b2 has 5 rows and 7 columns; expected 5 rows, a state each, of 49 numbers"
    );
}

#[test]
fn a_missing_array_is_told_with_what_is_expected() {
    assert_eq!(ask([5, 7], None, [5, 49]), "b2: found 1 inputs; expected 2: q, mu");
}

#[test]
fn what_a_robot_does_not_answer_is_an_error() {
    let (q, mut curvature, mut com) = (Array2::zeros((2, 30)), Array2::zeros((2, 2700)), Array2::zeros((2, 3)));
    let asked = [curvature.view_mut(), com.view_mut()].into();
    let error = answer(|| Side::<f64, _>::new(Humanoid), Quantity::DMu, &[q.view()], asked).unwrap_err();
    assert!(matches!(error, BatchError::Unanswered { quantity: "d_mu" }), "{error}");
}

#[test]
fn a_link_that_is_not_there_is_an_error() {
    let model = Model::from_urdf(urdf::LWR_SATELLITE).unwrap();
    let error = Recording::new(&model, Quantity::Kinematics(99)).unwrap_err();
    assert!(matches!(error, BatchError::Unanswered { quantity: "kinematics" }), "{error}");
}
