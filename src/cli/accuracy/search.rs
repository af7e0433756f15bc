//! A scene computed in many ways: which are worth their time.

use std::collections::HashMap;
use std::time::{Duration, Instant};

use frs::Model;
use frs_sim::integrate::IntegrationError;
use frs_sim::scene::{Equations, Scene};
use frs_sim::study::{Curve, Errors, Judged, Scalar, Truth, Variant, curves, dominated, front};
use indicatif::ProgressBar;

use crate::cli::explain::Costs;

/// A variant with what it gives and costs.
#[derive(Clone, Debug)]
pub struct Point {
    pub variant: Variant,
    pub errors: Errors,
    /// How often the equations were evaluated.
    pub evaluations: usize,
    /// Floating-point operations of one evaluation.
    pub operations: usize,
    /// How long it took each time, s.
    pub runs: Vec<f64>,
}

/// What counts as cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cost {
    /// Seconds on this machine.
    Time,
    /// Floating-point operations: the same on every machine.
    Operations,
}

/// All points of a scene.
pub struct Search {
    pub points: Vec<Point>,
    /// The points that no other one beats, by falling error.
    pub front: Vec<usize>,
    pub cost: Cost,
    /// How many ways were tried, and whether time ran out before all were.
    pub curves: usize,
    pub cut: bool,
}

/// A way is left when three times in a row something as accurate was this much cheaper.
const HOPELESS: f64 = 6.0;

/// A way is left when it is so near to the resolution of its numbers (in units of it) and finer steps bring nothing.
const NEAR: f64 = 1e6;

/// A finer motion that has more than this share of the error brings nothing.
const NOTHING: f64 = 0.9;

/// No motion that takes longer than this share of all time is tried.
const LONGEST: f64 = 0.1;

/// Operations a second, for that limit where operations count.
const NOMINAL: f64 = 1e9;

/// Points within this factor of the front are timed again, this often.
const CLOSE: f64 = 1.5;
const ROUNDS: usize = 7;

/// Errors above this are no motion of this scene.
const LOST: f64 = 0.1;

/// What an operation of double-double numbers takes in doubles: a sum 20, a product 9 (twofloat, with fused products).
const WIDE: usize = 15;

impl Point {
    /// The middle one of the times it took.
    pub fn seconds(&self) -> f64 {
        let mut runs = self.runs.clone();
        runs.sort_by(f64::total_cmp);
        runs[runs.len() / 2]
    }

    /// The shortest and the longest time it took.
    pub fn spread(&self) -> [f64; 2] {
        let least = self.runs.iter().copied().fold(f64::INFINITY, f64::min);
        [least, self.runs.iter().copied().fold(0.0, f64::max)]
    }

    pub fn cost(&self, cost: Cost) -> f64 {
        match cost {
            Cost::Time => self.seconds(),
            Cost::Operations => (self.evaluations * self.operations) as f64,
        }
    }

    fn place(&self, cost: Cost) -> [f64; 2] {
        [self.errors.of_state(), self.cost(cost)]
    }
}

impl Search {
    /// Tries all curves, for `seconds` at most; `bar` shows how far it is.
    pub fn of(scene: &Scene, model: &Model, truth: &Truth, cost: Cost, seconds: f64, bar: &ProgressBar) -> Self {
        let (begin, limit) = (Instant::now(), Duration::from_secs_f64(seconds));
        let mut operations = Operations { scene, model, known: HashMap::new() };
        let curves = curves(scene, false);
        bar.set_length(curves.len() as u64);
        let mut search = Self { points: Vec::new(), front: Vec::new(), cost, curves: curves.len(), cut: false };
        for curve in &curves {
            search.follow(*curve, truth, &mut operations, scene.duration, seconds);
            bar.inc(1);
            // What is left is for timing the best again.
            if cost == Cost::Time && begin.elapsed() > limit.mul_f64(0.8) {
                search.cut = true;
                break;
            }
        }
        if cost == Cost::Time {
            search.time_again(truth, begin + limit);
        }
        search.front = front(&search.places());
        search
    }

    /// Where the points are: error and cost; lost ones at infinity.
    fn places(&self) -> Vec<[f64; 2]> {
        let place = |point: &Point| point.place(self.cost);
        self.points
            .iter()
            .map(place)
            .map(|[error, cost]| [if error > LOST { f64::INFINITY } else { error }, cost])
            .collect()
    }

    fn follow(&mut self, curve: Curve, truth: &Truth, operations: &mut Operations, duration: f64, seconds: f64) {
        let (mut best, mut hopeless) = (f64::INFINITY, 0);
        for variant in curve.variants(duration) {
            let Judged { errors, evaluations, seconds: took } = match truth.judge(&variant) {
                Ok(judged) => judged,
                // Shorter steps may do.
                Err(IntegrationError::NotFinite { .. } | IntegrationError::NotSolved { .. }) => continue,
                Err(IntegrationError::StepTooSmall { .. }) => break,
            };
            let point = Point { variant, errors, evaluations, operations: operations.of(&variant), runs: vec![took] };
            let place = point.place(self.cost);
            self.points.push(point);
            let error = place[0];
            let beaten = dominated(place, self.places(), HOPELESS);
            hopeless = if beaten { hopeless + 1 } else { 0 };
            let done = error > NOTHING * best && best < NEAR * variant.scalar.resolution();
            let long = match self.cost {
                Cost::Time => took,
                Cost::Operations => place[1] / NOMINAL,
            };
            if hopeless == 3 || done || long > LONGEST * seconds {
                break;
            }
            best = best.min(error);
        }
    }

    /// Times the best points again, one after the other, so that a disturbance meets all alike.
    fn time_again(&mut self, truth: &Truth, end: Instant) {
        let places = self.places();
        let close: Vec<usize> = (0..places.len())
            .filter(|&i| places[i][0].is_finite() && !dominated(places[i], places.iter().copied(), CLOSE))
            .collect();
        for _ in 0..ROUNDS {
            for &i in &close {
                if Instant::now() > end {
                    return;
                }
                if let Ok(judged) = truth.judge(&self.points[i].variant) {
                    self.points[i].runs.push(judged.seconds);
                }
            }
        }
    }
}

/// Operations of an evaluation, counted once for each set of equations and route.
struct Operations<'s> {
    scene: &'s Scene,
    model: &'s Model,
    known: HashMap<[&'static str; 2], usize>,
}

impl Operations<'_> {
    fn of(&mut self, variant: &Variant) -> usize {
        let [_, _, equations, route, ..] = variant.names();
        let count = *self.known.entry([equations, route]).or_insert_with(|| {
            let scene = Scene { solver: variant.solver, ..self.scene.clone() };
            Costs::of_equations(&scene, self.model)[0].flops()
        });
        if variant.scalar == Scalar::DoubleDouble { WIDE * count } else { count }
    }
}

/// The words of a solver.
pub fn words(variant: &Variant) -> String {
    let [method, _, equations, route, scalar, evaluation] = variant.names();
    let steps = match variant.solver.steps {
        frs_sim::integrate::Steps::Accuracy(accuracy) => format!("accuracy {accuracy:.1e}"),
        frs_sim::integrate::Steps::Length(step) => format!("step {}", super::advice::time(step)),
    };
    let route = if variant.solver.equations == Equations::Hamel { String::new() } else { format!(", {route}") };
    let evaluation = if evaluation == "core" { "" } else { ", compiled" };
    format!("{method}, {steps}, {equations}{route}, {scalar}{evaluation}")
}
