//! A loop of given perimeter in a plane of shapes, as a Fourier series scaled to it.

use std::f64::consts::TAU;

use nalgebra::{DVector, Vector2};

use crate::{Gait, GaitError, ShapePlane};

/// Harmonics of a loop.
pub const HARMONICS: usize = 8;

/// Points at which a loop is looked at: sixteen for the shortest harmonic.
pub const NODES: usize = 16 * HARMONICS;

/// `γ(t) = c + s Σ_k cos(2πkt) a_k + sin(2πkt) b_k` with s such that the perimeter is as asked: any parameters will do.
///
/// The parameters are c, then a_k and b_k of each harmonic.
pub struct FourierLoop {
    /// γ at the nodes.
    pub point: Vec<Vector2<f64>>,
    /// γ' at the nodes.
    pub rate: Vec<Vector2<f64>>,
    raw: Vec<Vector2<f64>>,
    raw_rate: Vec<Vector2<f64>>,
    scale: f64,
    raw_length: f64,
}

/// Parameters of the ellipse with half-axes `radii`, counter-clockwise, or clockwise if one is negative.
pub fn ellipse(centre: [f64; 2], [a, b]: [f64; 2]) -> DVector<f64> {
    let mut parameters = DVector::zeros(2 + 4 * HARMONICS);
    parameters.as_mut_slice()[..6].copy_from_slice(&[centre[0], centre[1], a, 0.0, 0.0, b]);
    parameters
}

impl FourierLoop {
    /// The loop of `parameters`, with this perimeter.
    pub fn new(parameters: &DVector<f64>, perimeter: f64) -> Self {
        let (raw, raw_rate): (Vec<_>, Vec<_>) = (0..NODES)
            .map(|node| {
                let (mut point, mut rate) = (Vector2::zeros(), Vector2::zeros());
                for (entry, [value, slope]) in (2..parameters.len()).step_by(2).zip(waves(node)) {
                    let amplitude = Vector2::new(parameters[entry], parameters[entry + 1]);
                    point += amplitude * value;
                    rate += amplitude * slope;
                }
                (point, rate)
            })
            .unzip();
        let raw_length = mean(raw_rate.iter().map(|rate| rate.norm()));
        let scale = perimeter / raw_length;
        let centre = Vector2::new(parameters[0], parameters[1]);
        Self {
            point: raw.iter().map(|point| centre + point * scale).collect(),
            rate: raw_rate.iter().map(|rate| rate * scale).collect(),
            raw,
            raw_rate,
            scale,
            raw_length,
        }
    }

    /// The same as a gait.
    pub fn gait(&self, parameters: &DVector<f64>, plane: &ShapePlane) -> Result<Gait, GaitError> {
        let amplitudes = |first: usize| {
            let entries = (first..parameters.len()).step_by(4);
            entries.map(|at| plane.direction([parameters[at] * self.scale, parameters[at + 1] * self.scale])).collect()
        };
        Gait::fourier(plane.shape([parameters[0], parameters[1]]), amplitudes(2), amplitudes(4))
    }

    /// How unevenly the loop is walked: mean of |γ'|² over the square of the mean of |γ'|, less 1; and its derivative.
    pub fn unevenness(&self) -> (f64, DVector<f64>) {
        let square = mean(self.raw_rate.iter().map(|rate| rate.norm_squared()));
        let length = self.raw_length;
        let per_rate = self.raw_rate.iter().map(|rate| {
            let along = rate / rate.norm().max(f64::MIN_POSITIVE);
            (rate * 2.0 - along * (2.0 * square / length)) / (length * length * NODES as f64)
        });
        let still = vec![Vector2::zeros(); NODES];
        (square / (length * length) - 1.0, project(&still, &per_rate.collect::<Vec<_>>()))
    }

    /// The derivative to the parameters of what has the derivative `force` to γ at the nodes.
    pub fn pull_back(&self, force: &[Vector2<f64>]) -> DVector<f64> {
        let per_scale: f64 = force.iter().zip(&self.raw).map(|(force, raw)| force.dot(raw)).sum();
        let per_length = -per_scale * self.scale / self.raw_length;
        let per_rate: Vec<_> = self
            .raw_rate
            .iter()
            .map(|rate| rate * (per_length / (NODES as f64 * rate.norm().max(f64::MIN_POSITIVE))))
            .collect();
        let scaled: Vec<_> = force.iter().map(|force| force * self.scale).collect();
        let mut gradient = project(&scaled, &per_rate);
        let shift: Vector2<f64> = force.iter().sum();
        (gradient[0], gradient[1]) = (shift.x, shift.y);
        gradient
    }
}

/// Values and slopes of cos(2πkt), sin(2πkt), k = 1, 2, …, at a node.
fn waves(node: usize) -> impl Iterator<Item = [f64; 2]> {
    (1..=HARMONICS).flat_map(move |k| {
        let speed = TAU * k as f64;
        let (sin, cos) = (TAU * ((k * node) % NODES) as f64 / NODES as f64).sin_cos();
        [[cos, -speed * sin], [sin, speed * cos]]
    })
}

/// Derivatives to the amplitudes from those to the unscaled points and rates.
fn project(per_point: &[Vector2<f64>], per_rate: &[Vector2<f64>]) -> DVector<f64> {
    let mut gradient = DVector::zeros(2 + 4 * HARMONICS);
    for (node, (point, rate)) in per_point.iter().zip(per_rate).enumerate() {
        for (entry, [value, slope]) in (2..gradient.len()).step_by(2).zip(waves(node)) {
            gradient[entry] += value * point.x + slope * rate.x;
            gradient[entry + 1] += value * point.y + slope * rate.y;
        }
    }
    gradient
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    values.sum::<f64>() / NODES as f64
}
