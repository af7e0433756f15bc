//! Functions of time that scenes give: polynomials from knot to knot.

use std::ops::Range;

use frs_core::Real;

/// A function of time, polynomial between its knots.
///
/// It is evaluated on one piece, the one that [`enter`](Self::enter) chose, also beyond its ends: an integrator that stops at the knots
/// never sees two pieces in one step.
///
/// ```
/// use frs_sim::signal::Signal;
/// let mut ramp = Signal::linear(&[1.0, 3.0], &[0.0, 10.0]);
/// ramp.enter(2.0);
/// assert_eq!(ramp.at(2.5), 7.5);
/// ramp.enter(3.0);
/// assert_eq!(ramp.at(9.0), 10.0); // it stays at its last value
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Signal {
    knots: Vec<f64>,
    /// Coefficients in time since the knot before (the first: constant); one piece more than knots. None: 0.
    pieces: Vec<Vec<f64>>,
    piece: usize,
}

impl Signal {
    /// The same at all times.
    pub fn constant(value: f64) -> Self {
        Self { knots: Vec::new(), pieces: vec![coefficients([value, 0.0, 0.0, 0.0])], piece: 0 }
    }

    /// `value` within `during` (s; ends may be infinite), 0 elsewhere.
    pub fn pulse(value: f64, during: &Range<f64>) -> Self {
        let steps = [(f64::NEG_INFINITY, 0.0), (during.start, value), (during.end, 0.0)];
        let finite = steps.iter().map(|(time, _)| *time).filter(|time| time.is_finite());
        let first = steps.iter().rposition(|(time, _)| *time == f64::NEG_INFINITY).unwrap_or(0);
        let pieces = steps[first..].iter().filter(|(time, _)| *time < f64::INFINITY);
        let pieces = pieces.map(|(_, value)| coefficients([*value, 0.0, 0.0, 0.0])).collect();
        Self { knots: finite.collect(), pieces, piece: 0 }.entered()
    }

    /// Straight from point to point (increasing times, s), constant before the first and after the last.
    ///
    /// # Panics
    /// If there is no point, or not a value for each time.
    pub fn linear(times: &[f64], values: &[f64]) -> Self {
        let slopes = times.windows(2).zip(values.windows(2)).map(|(t, v)| (v[1] - v[0]) / (t[1] - t[0]));
        let inner = values.iter().zip(slopes).map(|(value, slope)| coefficients([*value, slope, 0.0, 0.0])).collect();
        Self::through(times, values, inner)
    }

    /// A clamped cubic spline: as [`linear`](Self::linear), but with continuous rates and accelerations, and at rest at both ends.
    ///
    /// # Panics
    /// If there is no point, or not a value for each time.
    pub fn spline(times: &[f64], values: &[f64]) -> Self {
        let rates = spline_rates(times, values);
        let pieces = (0..times.len().saturating_sub(1)).map(|i| {
            let (h, rise) = (times[i + 1] - times[i], values[i + 1] - values[i]);
            let (from, to) = (rates[i], rates[i + 1]);
            let square = (3.0 * rise / h - 2.0 * from - to) / h;
            let cube = (from + to - 2.0 * rise / h) / (h * h);
            coefficients([values[i], from, square, cube])
        });
        let inner = pieces.collect();
        Self::through(times, values, inner)
    }

    /// The inner pieces, and what holds before and after them.
    fn through(times: &[f64], values: &[f64], inner: Vec<Vec<f64>>) -> Self {
        assert!(!times.is_empty() && times.len() == values.len(), "a value for each time, and one at least");
        let ends = [values[0], values[values.len() - 1]].map(|value| coefficients([value, 0.0, 0.0, 0.0]));
        let [first, last] = ends;
        let pieces = std::iter::once(first).chain(inner).chain([last]).collect();
        Self { knots: times.to_vec(), pieces, piece: 0 }.entered()
    }

    /// On the piece of time 0.
    fn entered(mut self) -> Self {
        self.enter(0.0);
        self
    }

    /// Where the pieces meet, s.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Chooses the piece that holds from `time` (s) on.
    pub fn enter(&mut self, time: f64) {
        self.piece = self.knots.partition_point(|knot| *knot <= time);
    }

    /// Whether it is 0 until the next knot.
    pub fn is_zero(&self) -> bool {
        self.pieces[self.piece].is_empty()
    }

    /// Whether it is 0 at all times.
    pub fn is_always_zero(&self) -> bool {
        self.pieces.iter().all(Vec::is_empty)
    }

    /// The value at `time`, s.
    pub fn at<T: Real>(&self, time: T) -> T {
        let coefficients = &self.pieces[self.piece];
        let Some((&highest, lower)) = coefficients.split_last() else { return T::zero() };
        if lower.is_empty() {
            return T::from_f64(highest);
        }
        let since = self.since(time);
        lower.iter().rev().fold(T::from_f64(highest), |sum, &c| sum * since + T::from_f64(c))
    }

    /// The value and its first two derivatives at `time`, s.
    pub fn with_rates<T: Real>(&self, time: T) -> [T; 3] {
        let mut c = [T::zero(); 4];
        c.iter_mut().zip(&self.pieces[self.piece]).for_each(|(c, &given)| *c = T::from_f64(given));
        let (since, [two, three]) = (self.since(time), [2.0, 3.0].map(T::from_f64));
        let (square, cube) = (c[2] * two, c[3] * three);
        [self.at(time), c[1] + since * (square + since * cube), square + since * cube * two]
    }

    /// Time since the knot at which the piece begins.
    fn since<T: Real>(&self, time: T) -> T {
        match self.piece.checked_sub(1) {
            Some(before) => time - T::from_f64(self.knots[before]),
            None => time,
        }
    }
}

/// Without those at the end that are 0.
fn coefficients(all: [f64; 4]) -> Vec<f64> {
    let len = all.iter().rposition(|c| *c != 0.0).map_or(0, |last| last + 1);
    all[..len].to_vec()
}

/// Rates of a clamped cubic spline at its points: continuity of the second derivative at each inner point, by elimination.
fn spline_rates(times: &[f64], values: &[f64]) -> Vec<f64> {
    let n = times.len();
    let (mut rates, mut share) = (vec![0.0; n], vec![0.0; n]);
    for i in 1..n.saturating_sub(1) {
        let [h0, h1] = [times[i] - times[i - 1], times[i + 1] - times[i]];
        let right = 3.0 * ((values[i] - values[i - 1]) / h0 * h1 + (values[i + 1] - values[i]) / h1 * h0);
        let pivot = 2.0 * (h0 + h1) - h1 * share[i - 1];
        share[i] = h0 / pivot;
        rates[i] = (right - h1 * rates[i - 1]) / pivot;
    }
    for i in (1..n.saturating_sub(1)).rev() {
        rates[i] -= share[i] * rates[i + 1];
    }
    rates
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of numbers of size 10.
    const ROUNDING: f64 = 1e-13;

    #[test]
    fn a_spline_meets_its_points_with_continuous_rates_and_accelerations() {
        let (times, values) = ([0.0, 1.0, 1.5, 4.0], [0.0, 2.0, -1.0, 3.0]);
        let mut spline = Signal::spline(&times, &values);
        let mut bent = false;
        for (i, (time, value)) in times.into_iter().zip(values).enumerate() {
            spline.enter(time - 0.1);
            let before = spline.with_rates(time);
            spline.enter(time);
            let after = spline.with_rates(time);
            let continuous = if i == 0 || i == 3 { 2 } else { 3 };
            for (before, after) in before.iter().zip(&after).take(continuous) {
                assert!((before - after).abs() < ROUNDING, "{time}: {before} {after}");
            }
            assert!((after[0] - value).abs() < ROUNDING);
            bent |= after[2].abs() > 1.0;
        }
        assert!(bent);
    }

    #[test]
    fn a_pulse_is_zero_outside() {
        let mut pulse = Signal::pulse(3.0, &(1.0..2.0));
        let values = [0.0, 0.99, 1.0, 1.99, 2.0].map(|time| {
            pulse.enter(time);
            (pulse.at(time), pulse.is_zero())
        });
        assert_eq!(values, [(0.0, true), (0.0, true), (3.0, false), (3.0, false), (0.0, true)]);
        assert!(Signal::pulse(3.0, &(f64::NEG_INFINITY..f64::INFINITY)).knots().is_empty());
    }
}
