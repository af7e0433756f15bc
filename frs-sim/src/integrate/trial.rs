//! A step that is tried: where it ends, and by how much that may be wrong.

use frs_core::Real;

use super::{Explicit, State, System, Tableau, Tangent};

/// DOP853 weighs its error of order 3 by this against the one of order 5.
const LOWER_ERROR: f64 = 0.01;

/// Memory for steps of one motion, or of several in the lanes of `T`, each with steps of its own.
#[derive(Clone, Debug)]
pub(crate) struct Trial<T: Real> {
    method: Explicit<T>,
    /// Where a step begins, and the tangent there.
    pub from: State<T>,
    pub slope: Tangent<T>,
    /// Where it ends, and the tangent there.
    pub to: State<T>,
    pub end_slope: Tangent<T>,
    /// Mean squares of the method's estimates, for each motion.
    squares: Vec<[f64; 2]>,
}

impl<T: Real> Trial<T> {
    /// Memory for `motions` motions; both ends are at `state`.
    ///
    /// # Panics
    /// If the method estimates no error.
    pub fn new(tableau: &'static Tableau, state: State<T>, motions: usize) -> Self {
        assert!(tableau.error_order > 0, "{} estimates no error", tableau.name);
        let dimension = state.flat.len();
        Self {
            method: Explicit::new(tableau, dimension),
            from: state.clone(),
            slope: Tangent::zero(dimension),
            to: state,
            end_slope: Tangent::zero(dimension),
            squares: vec![[0.0; 2]; motions],
        }
    }

    /// The method's numbers.
    pub fn tableau(&self) -> &'static Tableau {
        self.method.tableau()
    }

    /// Exchanges the ends: a step begins where the last one ended.
    pub fn turn(&mut self) {
        std::mem::swap(&mut self.from, &mut self.to);
        std::mem::swap(&mut self.slope, &mut self.end_slope);
    }

    /// A step between these times (s), from `from`, whose tangent is known.
    pub fn step(&mut self, system: &mut impl System<T>, [start, length, end]: [T; 3]) {
        self.method.first_slope().clone_from(&self.slope);
        self.method.step_on(system, start, length, &self.from, &mut self.to);
        self.method.end_slope(system, end, &self.to, &mut self.end_slope);
    }

    /// Estimates the [`error`](Self::error) of the step just made in the first `counted` numbers; `number` reads that of a motion.
    pub fn estimate(&mut self, length: T, counted: usize, accuracy: f64, number: impl Fn(T, usize) -> f64) {
        let Self { method, from, to, squares, .. } = self;
        let mut row = 0;
        method.errors(length, |error| {
            for (motion, squares) in squares.iter_mut().enumerate() {
                squares[row] = mean_square(error, from, to, counted, accuracy, |x| number(x, motion));
            }
            row += 1;
        });
    }

    /// The estimated error of a motion's step, in units of what is allowed; infinite where it is no number.
    pub fn error(&self, motion: usize) -> f64 {
        let squares = self.squares[motion];
        let error = match self.tableau().errors.len() {
            1 => squares[0].sqrt(),
            _ if squares[0] == 0.0 => 0.0,
            _ => squares[0] / (squares[0] + LOWER_ERROR * squares[1]).sqrt(),
        };
        if error.is_finite() { error } else { f64::INFINITY }
    }

    /// The state at `time + θh` within the step just made.
    pub fn interpolate(&mut self, system: &mut impl System<T>, [time, h, theta]: [T; 3], to: &mut State<T>) {
        self.method.interpolate(system, time, h, &self.from, theta, to);
    }
}

/// A first step by which an Euler step would move states by a hundredth of their size, not longer than what remains (s).
pub(crate) fn first_length<T: Real>(
    tangent: &Tangent<T>,
    state: &State<T>,
    counted: usize,
    remaining: f64,
    number: impl Fn(T) -> f64,
) -> f64 {
    let origin = State::origin(state.flat.len());
    let speed = mean_square(tangent, state, &origin, counted, 1.0, number).sqrt();
    let length = if speed > 0.0 { 0.01 / speed } else { remaining };
    if length.is_finite() { length.min(remaining) } else { remaining }
}

/// Mean square of a step's entries with its first `counted` numbers, each in units of `accuracy·max(1, |x|)`.
fn mean_square<T: Real>(
    step: &Tangent<T>,
    from: &State<T>,
    to: &State<T>,
    counted: usize,
    accuracy: f64,
    number: impl Fn(T) -> f64,
) -> f64 {
    let mut sum = 0.0;
    let mut add = |value: T, sizes: [T; 2]| {
        let [size, other] = sizes.map(|size| number(size).abs());
        let scaled = number(value) / (accuracy * size.max(other).max(1.0));
        sum += scaled * scaled;
    };
    for angle in step.twist.angular.iter() {
        add(*angle, [T::zero(); 2]);
    }
    for (i, &x) in step.twist.linear.iter().enumerate() {
        add(x, [from.pose.translation[i], to.pose.translation[i]]);
    }
    for (i, &x) in step.flat[..counted].iter().enumerate() {
        add(x, [from.flat[i], to.flat[i]]);
    }
    sum / (6 + counted) as f64
}
