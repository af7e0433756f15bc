//! Descent to a minimum of a smooth function: the method of Broyden, Fletcher, Goldfarb and Shanno.

use nalgebra::{DMatrix, DVector};

/// Iterations at most.
const MOST_ITERATIONS: usize = 400;

/// The descent ends when so many steps together gain less than [`LEAST_GAIN`].
const PATIENCE: usize = 10;

/// Least gain of [`PATIENCE`] steps, relative to the function's value and 1e-3.
const LEAST_GAIN: f64 = 1e-10;

/// A step must gain this share of what the slope promises (Armijo).
const SUFFICIENT: f64 = 1e-4;

/// The minimum of `f`, value and gradient, that is reached from `x`.
///
/// A few dozen unknowns: the inverse Hessian is a dense matrix, and the step is halved until it gains enough.
pub fn minimum<E>(
    mut x: DVector<f64>,
    mut f: impl FnMut(&DVector<f64>) -> Result<(f64, DVector<f64>), E>,
) -> Result<(DVector<f64>, f64), E> {
    let n = x.len();
    let (mut value, mut gradient) = f(&x)?;
    let mut inverse: DMatrix<f64> = DMatrix::identity(n, n) * (0.1 / gradient.norm().max(f64::MIN_POSITIVE));
    let mut history = vec![value];
    for _ in 0..MOST_ITERATIONS {
        let mut direction = -(&inverse * &gradient);
        if direction.dot(&gradient) >= 0.0 {
            inverse.fill_with_identity();
            direction = -gradient.clone();
        }
        let slope = direction.dot(&gradient);
        let mut step = 1.0;
        let accepted = loop {
            let trial = &x + &direction * step;
            let (trial_value, trial_gradient) = f(&trial)?;
            if trial_value <= value + SUFFICIENT * step * slope {
                break Some((trial, trial_value, trial_gradient));
            }
            step *= 0.5;
            if step < 1e-10 {
                break None;
            }
        };
        let Some((next, next_value, next_gradient)) = accepted else { break };
        let (s, y) = (&next - &x, &next_gradient - &gradient);
        let sy = s.dot(&y);
        if sy > 1e-12 * s.norm() * y.norm() {
            let hy = &inverse * &y;
            let scale = (1.0 + y.dot(&hy) / sy) / sy;
            inverse += &s * s.transpose() * scale - (&hy * s.transpose() + &s * hy.transpose()) / sy;
        }
        (x, value, gradient) = (next, next_value, next_gradient);
        history.push(value);
        let earlier = history.len().checked_sub(PATIENCE + 1).map(|index| history[index]);
        if earlier.is_some_and(|earlier| earlier - value < LEAST_GAIN * (value.abs() + 1e-3)) {
            break;
        }
    }
    Ok((x, value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bottom_of_a_curved_valley_is_found() {
        let rosenbrock = |x: &DVector<f64>| {
            let (a, b) = (1.0 - x[0], x[1] - x[0] * x[0]);
            let gradient = DVector::from_vec(vec![-2.0 * a - 400.0 * x[0] * b, 200.0 * b]);
            Ok::<_, ()>((a * a + 100.0 * b * b, gradient))
        };
        let (x, value) = minimum(DVector::from_vec(vec![-1.2, 1.0]), rosenbrock).unwrap();
        // The descent stops by what it gains, so x is known to the root of that.
        assert!(value < 1e-12 && (x - DVector::from_element(2, 1.0)).norm() < 1e-5);
    }
}
