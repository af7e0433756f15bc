//! Shapes of every case: with numbers that were made once and for all, or at random.

use std::f64::consts::PI;

use frs_core::model::Motion;
use frs_core::spatial::Twist;
use nalgebra::Vector3;
use serde::Deserialize;

use crate::{Case, Values};

/// A shape with numbers made without this project's code; `data/points.json` says how.
#[derive(Clone, Debug)]
pub struct Point {
    /// The shape.
    pub q: Vec<f64>,
    /// A_l, 𝓑 and c there, rounded to doubles.
    pub values: Values<f64>,
}

#[derive(Deserialize)]
struct Data {
    points: Vec<Entry>,
}

#[derive(Deserialize)]
struct Entry {
    case: String,
    q: Vec<f64>,
    com: [f64; 3],
    connection: Vec<[f64; 6]>,
    curvature: Vec<[f64; 6]>,
}

/// The shapes of `case` whose numbers are known.
pub fn points(case: Case) -> Vec<Point> {
    let data: Data = serde_json::from_str(include_str!("../data/points.json")).expect("the crate's own data");
    let twists = |six: Vec<[f64; 6]>| six.into_iter().map(Twist::from_array).collect();
    let own = data.points.into_iter().filter(|entry| entry.case == case.id());
    own.map(|Entry { q, com, connection, curvature, .. }| Point {
        q,
        values: Values { connection: twists(connection), curvature: twists(curvature), com: Vector3::from(com) },
    })
    .collect()
}

/// `count` random shapes of `case`, angles within half a turn and sliders within 1 m; the same `seed` gives the same ones.
pub fn shapes(case: Case, count: usize, seed: u64) -> Vec<Vec<f64>> {
    let model = case.model();
    let mut rng = fastrand::Rng::with_seed(seed);
    let mut value = |motion| {
        let unit = 2.0 * rng.f64() - 1.0;
        match motion {
            Motion::Revolute => PI * unit,
            Motion::Prismatic => unit,
        }
    };
    let motions: Vec<_> = model.coordinates().iter().map(|c| model.bodies()[c.body].motion).collect();
    (0..count).map(|_| motions.iter().map(|&motion| value(motion)).collect()).collect()
}
