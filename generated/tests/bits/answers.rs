//! Answers, and where they differ.

use frs_core::{FloatingBase, Quantity, Real};

/// What `robot` answers, output after output. It starts as NaN, so that an entry that nobody writes is seen.
pub fn answer<T: Real>(robot: &mut impl FloatingBase<T>, quantity: Quantity, inputs: &[Vec<T>]) -> Vec<Vec<T>> {
    let n = robot.dof();
    let mut outputs: Vec<Vec<T>> = quantity.outputs().map(|o| vec![T::from_f64(f64::NAN); o.len(n)]).collect();
    let inputs: Vec<&[T]> = inputs.iter().map(Vec::as_slice).collect();
    let mut slices: Vec<&mut [T]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
    robot.answer(quantity, &inputs, &mut slices);
    outputs
}

/// Where two answers differ, in words.
///
/// What the core finds not to be finite has no bits to compare: `x·0` and `x − x` are folded to 0 for every finite x, and so
/// an entry that the core loses to an infinity may survive in compiled code.
pub fn difference(quantity: Quantity, expected: &[Vec<f64>], actual: &[Vec<f64>]) -> Option<String> {
    for ((output, expected), actual) in quantity.outputs().zip(expected).zip(actual) {
        assert_eq!(expected.len(), actual.len());
        for (entry, (&e, &a)) in expected.iter().zip(actual).enumerate() {
            if e.is_finite() && e.to_bits() != a.to_bits() {
                let bits = format!("{:016x} and {:016x}", e.to_bits(), a.to_bits());
                return Some(format!("{quantity:?}: {}[{entry}]: core {e:e}, compiled {a:e}: {bits}", output.name));
            }
        }
    }
    None
}
