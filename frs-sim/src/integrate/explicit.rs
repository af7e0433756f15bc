//! Explicit Runge-Kutta steps in Munthe-Kaas form.

use frs_core::Real;

use super::tableau::Coefficient;
use super::{State, System, Tableau, Tangent};

/// An explicit Runge-Kutta method with its memory: steps of SE(3)×Rᵐ with the order of its [`Tableau`].
///
/// After it is made nothing allocates.
///
/// ```
/// use frs_core::spatial::Twist;
/// use frs_sim::integrate::{Explicit, RK4, State, System, Tangent};
///
/// /// A base that moves on a circle.
/// struct Circle;
/// impl System for Circle {
///     fn dimension(&self) -> usize { 0 }
///     fn velocities(&self) -> std::ops::Range<usize> { 0..0 }
///     fn rate(&mut self, _: f64, _: &State, rate: &mut Tangent) {
///         rate.twist = Twist::from_array([0.0, 0.0, 1.0, 1.0, 0.0, 0.0]);
///     }
/// }
/// let (start, mut end) = (State::origin(0), State::origin(0));
/// Explicit::new(&RK4, 0).step(&mut Circle, 0.0, std::f64::consts::PI, &start, &mut end);
/// assert!((end.pose.translation.y - 2.0).abs() < 1e-15); // half the circle, in one step and exactly
/// ```
#[derive(Clone, Debug)]
pub struct Explicit<T: Real = f64> {
    tableau: &'static Tableau,
    nodes: Vec<T>,
    rows: Vec<Vec<T>>,
    errors: Vec<Vec<T>>,
    dense: Vec<Vec<T>>,
    /// ζ̇ and ẋ of each stage.
    slopes: Vec<Tangent<T>>,
    /// How many of the slopes belong to the last step.
    known: usize,
    stage: State<T>,
    step: Tangent<T>,
    weights: Vec<T>,
}

impl<T: Real> Explicit<T> {
    /// The method with memory for states of `dimension` numbers.
    pub fn new(tableau: &'static Tableau, dimension: usize) -> Self {
        let row = |row: &&[Coefficient]| row.iter().map(|c| c.value()).collect::<Vec<T>>();
        let slopes = tableau.rows.len().max(tableau.stages + 1);
        Self {
            tableau,
            nodes: row(&tableau.nodes),
            rows: tableau.rows.iter().map(row).collect(),
            errors: tableau.errors.iter().map(row).collect(),
            dense: tableau.dense.iter().map(row).collect(),
            slopes: vec![Tangent::zero(dimension); slopes],
            known: 0,
            stage: State::origin(dimension),
            step: Tangent::zero(dimension),
            weights: vec![T::zero(); slopes],
        }
    }

    /// The method's numbers.
    pub fn tableau(&self) -> &'static Tableau {
        self.tableau
    }

    /// One step of length `h` (s) from `from` at `time`, into `to`.
    pub fn step(&mut self, system: &mut impl System<T>, time: T, h: T, from: &State<T>, to: &mut State<T>) {
        system.rate(time, from, &mut self.slopes[0]);
        self.step_on(system, time, h, from, to);
    }

    /// The tangent at the start of the next step, where it is already known: slope 0 is taken as given.
    pub(super) fn first_slope(&mut self) -> &mut Tangent<T> {
        &mut self.slopes[0]
    }

    /// [`step`](Self::step) with slope 0 known.
    pub(super) fn step_on(&mut self, system: &mut impl System<T>, time: T, h: T, from: &State<T>, to: &mut State<T>) {
        self.known = 1;
        for stage in 1..self.tableau.stages {
            self.slope(system, time, h, from, stage);
        }
        self.step.set_sum(h, &self.rows[self.tableau.stages], &self.slopes);
        to.set_moved(from, &self.step);
    }

    /// Slope `stage` of the step of length `h` from `from`.
    fn slope(&mut self, system: &mut impl System<T>, time: T, h: T, from: &State<T>, stage: usize) {
        self.step.set_sum(h, &self.rows[stage], &self.slopes[..stage]);
        self.stage.set_moved(from, &self.step);
        let slope = &mut self.slopes[stage];
        system.rate(time + self.nodes[stage] * h, &self.stage, slope);
        slope.twist = (-self.step.twist).dexp_inverse(slope.twist);
        self.known = stage + 1;
    }

    /// The tangent at the end of the step just made, which estimates of its error need: the next step's first slope.
    pub(super) fn end_slope(&mut self, system: &mut impl System<T>, end: T, to: &State<T>, tangent: &mut Tangent<T>) {
        system.rate(end, to, tangent);
        let slope = &mut self.slopes[self.tableau.stages];
        slope.flat.copy_from_slice(&tangent.flat);
        slope.twist = (-self.step.twist).dexp_inverse(tangent.twist);
        self.known = self.tableau.stages + 1;
    }

    /// Estimates of the error of the step just made, one after the other, as steps `(ζ, Δx)`.
    pub(super) fn errors(&mut self, h: T, mut each: impl FnMut(&Tangent<T>)) {
        for row in &self.errors {
            self.step.set_sum(h, row, &self.slopes);
            each(&self.step);
        }
    }

    /// The state at `time + θh` within the step just made, θ from 0 to 1, whose end slope is known.
    pub(super) fn interpolate(
        &mut self,
        system: &mut impl System<T>,
        time: T,
        h: T,
        from: &State<T>,
        theta: T,
        to: &mut State<T>,
    ) {
        for stage in self.known..self.dense.len() {
            self.slope(system, time, h, from, stage);
        }
        for (weight, powers) in self.weights.iter_mut().zip(&self.dense) {
            *weight = powers.iter().rev().fold(T::zero(), |sum, &coefficient| (sum + coefficient) * theta);
        }
        self.step.set_sum(h, &self.weights[..self.dense.len()], &self.slopes);
        to.set_moved(from, &self.step);
    }
}
