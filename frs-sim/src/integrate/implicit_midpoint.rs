//! The implicit midpoint method, for stiff forces.

use frs_core::Real;
use nalgebra::{DMatrix, DVector};

use super::{IntegrationError, State, System, Tangent};

/// The implicit midpoint method, order 2, symmetric: `(V, ẋ) = f(t + ½h, g exp(½hV), x + ½hẋ)`, then a step of `h(V, ẋ)`.
///
/// Stable for every stiff linear force, and it conserves quadratic invariants. Solved by Newton's method with differences, which are
/// doubles whatever the scalar.
#[derive(Clone, Debug)]
pub struct ImplicitMidpoint<T: Real = f64> {
    slope: Tangent<T>,
    rate: Tangent<T>,
    step: Tangent<T>,
    middle: State<T>,
    displaced: State<T>,
    jacobian: DMatrix<f64>,
    residual: DVector<f64>,
}

/// Newton's method converges in a few rounds, or not.
const ROUNDS: usize = 12;

/// Corrections below this, relative to the slope, are rounding.
const ROUNDING: f64 = 1e-14;

/// Corrections that fall by less than this a round are not those of fresh differences.
const SLOW: f64 = 0.1;

/// A correction that is not smaller than this is no convergence when it stops decreasing.
const CONVERGED: f64 = 1e-9;

/// Displacement for differences, relative: the square root of a double's resolution.
const DISPLACEMENT: f64 = 1.5e-8;

impl<T: Real + Into<f64>> ImplicitMidpoint<T> {
    /// Memory for states of `dimension` numbers.
    pub fn new(dimension: usize) -> Self {
        Self {
            slope: Tangent::zero(dimension),
            rate: Tangent::zero(dimension),
            step: Tangent::zero(dimension),
            middle: State::origin(dimension),
            displaced: State::origin(dimension),
            jacobian: DMatrix::zeros(6 + dimension, 6 + dimension),
            residual: DVector::zeros(6 + dimension),
        }
    }

    /// One step of length `h` (s) from `from` at `time`, into `to`.
    ///
    /// # Errors
    /// If the equations of the step are not solved, or a rate is not finite.
    pub fn step(
        &mut self,
        system: &mut impl System<T>,
        time: T,
        h: T,
        from: &State<T>,
        to: &mut State<T>,
    ) -> Result<(), IntegrationError> {
        let half = h * T::from_f64(0.5);
        system.rate(time, from, &mut self.slope);
        let mut before = f64::INFINITY;
        for round in 0..ROUNDS {
            self.step.set_sum(half, &[T::one()], std::slice::from_ref(&self.slope));
            self.middle.set_moved(from, &self.step);
            system.rate(time + half, &self.middle, &mut self.rate);
            for i in 0..self.residual.len() {
                self.residual[i] = (entry(&self.rate, i) - entry(&self.slope, i)).into();
            }
            if round == 0 {
                self.differentiate(system, time + half, half);
            }
            let Some(correction) = self.jacobian.clone().lu().solve(&self.residual) else {
                return Err(IntegrationError::NotSolved { time: time.into(), step: h.into() });
            };
            let size = (0..correction.len()).map(|i| entry(&self.rate, i).into().powi(2)).sum::<f64>().sqrt();
            let change = correction.norm() / size.max(f64::MIN_POSITIVE);
            if !correction.norm().is_finite() {
                return Err(IntegrationError::NotFinite { time: time.into() });
            }
            (0..correction.len()).for_each(|i| *entry_mut(&mut self.slope, i) += T::from_f64(correction[i]));
            if correction.norm() == 0.0 || change < ROUNDING || (change >= before && before < CONVERGED) {
                self.step.set_sum(h, &[T::one()], std::slice::from_ref(&self.slope));
                to.set_moved(from, &self.step);
                return Ok(());
            }
            if change > SLOW * before {
                // The differences of an earlier round do not fit any more.
                self.differentiate(system, time + half, half);
            }
            before = change;
        }
        Err(IntegrationError::NotSolved { time: time.into(), step: h.into() })
    }

    /// `1 − ½h ∂f/∂(ζ, x)` at the middle, where `rate` is f.
    fn differentiate(&mut self, system: &mut impl System<T>, time: T, half: T) {
        let half: f64 = half.into();
        let mut displaced_rate = Tangent::zero(self.middle.flat.len());
        for column in 0..self.residual.len() {
            self.step.set_sum(T::zero(), &[], &[]);
            let size = column.checked_sub(6).map_or(1.0, |i| self.middle.flat[i].into().abs().max(1.0));
            let displacement = DISPLACEMENT * size;
            *entry_mut(&mut self.step, column) = T::from_f64(displacement);
            self.displaced.set_moved(&self.middle, &self.step);
            system.rate(time, &self.displaced, &mut displaced_rate);
            for row in 0..self.residual.len() {
                let change: f64 = (entry(&displaced_rate, row) - entry(&self.rate, row)).into();
                let slope = change / displacement;
                self.jacobian[(row, column)] = f64::from(row == column) - half * slope;
            }
        }
    }
}

fn entry<T: Real>(tangent: &Tangent<T>, i: usize) -> T {
    match i {
        0..3 => tangent.twist.angular[i],
        3..6 => tangent.twist.linear[i - 3],
        _ => tangent.flat[i - 6],
    }
}

fn entry_mut<T: Real>(tangent: &mut Tangent<T>, i: usize) -> &mut T {
    match i {
        0..3 => &mut tangent.twist.angular[i],
        3..6 => &mut tangent.twist.linear[i - 3],
        _ => &mut tangent.flat[i - 6],
    }
}
