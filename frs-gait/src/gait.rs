//! Closed paths: polygons, ellipses, splines through sampled points, Fourier series.

use std::f64::consts::TAU;

use thiserror::Error;

use crate::path::norm;
use crate::{Path, ShapePlane};

/// A closed path of shapes.
#[derive(Clone, Debug, PartialEq)]
pub struct Gait {
    form: Form,
}

#[derive(Clone, Debug, PartialEq)]
enum Form {
    /// Per piece, the coefficients of 1, t, t², t³.
    Cubics(Vec<[Vec<f64>; 4]>),
    /// `mean + Σ_k cos(2πkt) cosines[k−1] + sin(2πkt) sines[k−1]`.
    Fourier { mean: Vec<f64>, cosines: Vec<Vec<f64>>, sines: Vec<Vec<f64>> },
}

/// Why numbers are not a closed path.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum GaitError {
    /// Too few distinct points.
    #[error("the gait has {found} distinct points; expected at least {expected}, neighbours not equal")]
    Points {
        /// How many there are.
        found: usize,
        /// How many are needed.
        expected: usize,
    },
    /// A point or coefficient has not one number per coordinate.
    #[error("point {point} of the gait has {found} numbers; expected {expected}, as many as the first")]
    Length {
        /// Which, from 1.
        point: usize,
        /// How many numbers it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// A number is infinite or not a number.
    #[error("point {point} of the gait has an entry that is no finite number; expected rad or m")]
    NotFinite {
        /// Which, from 1.
        point: usize,
    },
}

/// Sweeps of Gauss and Seidel for a spline's tangents: each at least halves the error, 60 leave rounding.
const TANGENT_SWEEPS: usize = 60;

impl Gait {
    /// Straight edges through `points` (each n numbers), and back from the last to the first.
    ///
    /// # Errors
    /// If there are fewer than two distinct points, if their lengths differ, or if a number is not finite.
    pub fn polygon(points: &[Vec<f64>]) -> Result<Self, GaitError> {
        let corners = distinct(points, 2)?;
        let edges = closed_pairs(&corners).map(|(from, to)| [from.clone(), minus(to, from), zeros(from), zeros(from)]);
        Ok(Self { form: Form::Cubics(edges.collect()) })
    }

    /// The periodic cubic spline through `points` (each n numbers), with continuous curvature, also where it closes.
    ///
    /// The knots stand apart as the points do, so unevenly sampled paths keep their form.
    ///
    /// # Errors
    /// If there are fewer than three distinct points, if their lengths differ, or if a number is not finite.
    pub fn spline(points: &[Vec<f64>]) -> Result<Self, GaitError> {
        let points = distinct(points, 3)?;
        let count = points.len();
        let chords: Vec<Vec<f64>> = closed_pairs(&points).map(|(from, to)| minus(to, from)).collect();
        let lengths: Vec<f64> = chords.iter().map(|chord| norm(chord)).collect();
        let dof = points[0].len();
        // Second derivatives agree at every knot, in the tangents m_i:
        // h_i m_{i−1} + 2 (h_{i−1} + h_i) m_i + h_{i−1} m_{i+1} = 3 (h_i d_{i−1}/h_{i−1} + h_{i−1} d_i/h_i)
        let mut tangents = vec![vec![0.0; dof]; count];
        for _ in 0..TANGENT_SWEEPS {
            for i in 0..count {
                let (before, after) = ((i + count - 1) % count, (i + 1) % count);
                let (h_before, h) = (lengths[before], lengths[i]);
                for c in 0..dof {
                    let slopes = h * chords[before][c] / h_before + h_before * chords[i][c] / h;
                    let beside = h * tangents[before][c] + h_before * tangents[after][c];
                    tangents[i][c] = (3.0 * slopes - beside) / (2.0 * (h_before + h));
                }
            }
        }
        let pieces = (0..count).map(|i| {
            let (chord, start, end) = (&chords[i], &tangents[i], &tangents[(i + 1) % count]);
            let h = lengths[i];
            let entry = |f: &dyn Fn(usize) -> f64| (0..dof).map(f).collect::<Vec<f64>>();
            [
                points[i].clone(),
                entry(&|c| h * start[c]),
                entry(&|c| 3.0 * chord[c] - h * (2.0 * start[c] + end[c])),
                entry(&|c| h * (start[c] + end[c]) - 2.0 * chord[c]),
            ]
        });
        Ok(Self { form: Form::Cubics(pieces.collect()) })
    }

    /// `mean + Σ_k cos(2πkt) cosines[k−1] + sin(2πkt) sines[k−1]`; all vectors have n numbers.
    ///
    /// # Errors
    /// If lengths differ or a number is not finite; the mean counts as point 1, then come cosines, then sines.
    pub fn fourier(mean: Vec<f64>, cosines: Vec<Vec<f64>>, sines: Vec<Vec<f64>>) -> Result<Self, GaitError> {
        check([&mean].into_iter().chain(&cosines).chain(&sines))?;
        Ok(Self { form: Form::Fourier { mean, cosines, sines } })
    }

    /// The ellipse about `centre` with half-axes `radii` along the plane's coordinates, from the first's far end towards
    /// the second's: counter-clockwise if both radii are positive, clockwise if one is negative.
    ///
    /// # Errors
    /// If a number is not finite.
    pub fn ellipse(plane: &ShapePlane, centre: [f64; 2], radii: [f64; 2]) -> Result<Self, GaitError> {
        let [a, b] = radii;
        Self::fourier(plane.shape(centre), vec![plane.direction([a, 0.0])], vec![plane.direction([0.0, b])])
    }
}

impl Path for Gait {
    fn dof(&self) -> usize {
        match &self.form {
            Form::Cubics(pieces) => pieces[0][0].len(),
            Form::Fourier { mean, .. } => mean.len(),
        }
    }

    fn pieces(&self) -> usize {
        match &self.form {
            Form::Cubics(pieces) => pieces.len(),
            Form::Fourier { .. } => 1,
        }
    }

    fn at(&self, piece: usize, t: f64, q: &mut [f64], dq: &mut [f64]) {
        match &self.form {
            Form::Cubics(pieces) => {
                let [a, b, c, d] = &pieces[piece];
                for i in 0..a.len() {
                    q[i] = a[i] + t * (b[i] + t * (c[i] + t * d[i]));
                    dq[i] = b[i] + t * (2.0 * c[i] + t * 3.0 * d[i]);
                }
            }
            Form::Fourier { mean, cosines, sines } => {
                q.copy_from_slice(mean);
                dq.fill(0.0);
                for (k, cosine) in (1u32..).zip(cosines) {
                    let (sin, cos) = (TAU * f64::from(k) * t).sin_cos();
                    add(q, cos, cosine);
                    add(dq, -TAU * f64::from(k) * sin, cosine);
                }
                for (k, sine) in (1u32..).zip(sines) {
                    let (sin, cos) = (TAU * f64::from(k) * t).sin_cos();
                    add(q, sin, sine);
                    add(dq, TAU * f64::from(k) * cos, sine);
                }
            }
        }
    }
}

/// The points without those that repeat their neighbour, at least `expected` of them.
fn distinct(points: &[Vec<f64>], expected: usize) -> Result<Vec<Vec<f64>>, GaitError> {
    check(points)?;
    let mut distinct = points.to_vec();
    distinct.dedup();
    if distinct.len() > 1 && distinct.first() == distinct.last() {
        distinct.pop();
    }
    match distinct.len() {
        found if found < expected => Err(GaitError::Points { found, expected }),
        _ => Ok(distinct),
    }
}

fn check<'a>(points: impl IntoIterator<Item = &'a Vec<f64>>) -> Result<(), GaitError> {
    let mut expected = None;
    for (point, numbers) in (1..).zip(points) {
        let (found, expected) = (numbers.len(), *expected.get_or_insert(numbers.len()));
        if found != expected {
            return Err(GaitError::Length { point, found, expected });
        }
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(GaitError::NotFinite { point });
        }
    }
    Ok(())
}

/// Each point with the next one, the last with the first.
fn closed_pairs(points: &[Vec<f64>]) -> impl Iterator<Item = (&Vec<f64>, &Vec<f64>)> {
    points.iter().zip(points.iter().cycle().skip(1))
}

fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn zeros(like: &[f64]) -> Vec<f64> {
    vec![0.0; like.len()]
}

fn add(sum: &mut [f64], factor: f64, v: &[f64]) {
    sum.iter_mut().zip(v).for_each(|(sum, v)| *sum += factor * v);
}
