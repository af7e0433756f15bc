//! How well conditioned a robot is: which of its digits rounding takes.
//!
//! Four ratios of a robot in a shape say by how much what is added up exceeds what is left. Together they bound what a quantity
//! loses; the bounds are held against evaluations with 31 digits, on thousands of robots, in `tests/hard`.

use frs_core::extended::DoubleDouble;
use frs_core::model::Motion;
use frs_core::{Model, Shape, Workspace};
use nalgebra::{DMatrix, DVector, Matrix6xX};

/// A ratio, at least 1, and the coordinate that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ratio {
    /// The ratio.
    pub value: f64,
    /// Number of the coordinate; a robot without coordinates has none.
    pub coordinate: Option<usize>,
}

/// The conditioning of a robot in a shape, or the worst in several.
#[derive(Clone, Debug, PartialEq)]
pub struct Conditioning {
    /// The terms of Λ_jj over Λ_jj: moments are taken about the total centre of mass, far from a small last link.
    pub lever: Ratio,
    /// The way from a joint's frame to the next one's over the robot's reach, the root mean square distance of its masses from
    /// their centre: positions are added up along the chain.
    pub distance: Ratio,
    /// M_jj/Λ_jj: by how much a joint moves less mass against a floating base than against one that is held.
    pub lightness: Ratio,
    /// The condition number of Λ_q in the scales `√Λ_jj` of its coordinates, with the coordinate that moves most in its
    /// weakest direction.
    pub condition: Ratio,
    /// Number of joints, each of which adds roundings.
    joints: usize,
}

/// What has a bound of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounded {
    /// Λ_b, Λ_q, A_l, 𝓑, the Coriolis matrices, momenta, energies, torques: all that is found without solving for q̈.
    Quantities,
    /// Λ_q as it is usually formed, `M_q − A_lᵀ Λ_b A_l`; for comparison.
    TextbookInertia,
    /// q̈ with Λ_q by the complement form, factored ([`Route::Complement`](crate::Route::Complement)).
    Factored,
    /// q̈ by the articulated-body sweep ([`Route::Articulated`](crate::Route::Articulated)).
    Articulated,
}

impl Bounded {
    /// Everything that has a bound.
    pub const ALL: [Self; 4] = [Self::Quantities, Self::TextbookInertia, Self::Factored, Self::Articulated];
}

impl Ratio {
    fn largest(ratios: impl Iterator<Item = f64>) -> Self {
        let all = ratios.enumerate().map(|(j, value)| Self { value, coordinate: Some(j) });
        all.fold(Self { value: 1.0, coordinate: None }, Self::larger)
    }

    fn larger(self, other: Self) -> Self {
        if other.value > self.value || other.value.is_nan() { other } else { self }
    }
}

impl Conditioning {
    /// The conditioning in a shape. It is measured with 31 digits, so as not to suffer from what it measures.
    ///
    /// ```
    /// use frs::conditioning::{Bounded, Conditioning};
    ///
    /// let model = frs::Model::from_urdf(frs::urdf::LWR_SATELLITE)?;
    /// let conditioning = Conditioning::at(&model.cast(), &[0.5.into(); 7]);
    /// assert!(conditioning.digits(Bounded::Quantities) > 10.0);
    /// # Ok::<(), frs::urdf::UrdfError>(())
    /// ```
    ///
    /// # Panics
    /// If `q` does not have n entries.
    pub fn at(model: &Model<DoubleDouble>, q: &[DoubleDouble]) -> Self {
        let n = model.dof();
        let mut work = Workspace::new(model);
        let mut shape = work.shape(q);
        let (mut inertia, mut connection) = (DMatrix::zeros(n, n), Matrix6xX::zeros(n));
        shape.shape_inertia(&mut inertia);
        shape.connection(&mut connection);
        let locked = shape.locked_inertia().to_matrix();
        let free = |j: usize| inertia[(j, j)].high();
        let reach = (second_moments(model, &mut shape).1 / locked[(3, 3)].high()).sqrt();
        let carried = |j: usize| connection.column(j).dot(&(locked * connection.column(j))).high();
        let correlation = DMatrix::from_fn(n, n, |i, j| inertia[(i, j)].high() / (free(i) * free(j)).sqrt());
        Self {
            lever: Ratio::largest(levers(model, &mut shape).into_iter()),
            distance: Ratio::largest((0..n).map(|j| way(model, j) / reach)),
            lightness: Ratio::largest((0..n).map(|j| 1.0 + carried(j) / free(j))),
            condition: condition(correlation),
            joints: model.joints(),
        }
    }

    /// The worst of each ratio over `shapes` random shapes, within the joints' limits where there are any; the same `seed` gives
    /// the same shapes.
    pub fn sampled(model: &Model, shapes: usize, seed: u64) -> Self {
        let mut rng = fastrand::Rng::with_seed(seed);
        let precise: Model<DoubleDouble> = model.cast();
        let mut worst = Self::at(&precise, &shape(model, &mut rng));
        for _ in 1..shapes {
            let here = Self::at(&precise, &shape(model, &mut rng));
            worst.lever = worst.lever.larger(here.lever);
            worst.distance = worst.distance.larger(here.distance);
            worst.lightness = worst.lightness.larger(here.lightness);
            worst.condition = worst.condition.larger(here.condition);
        }
        worst
    }

    /// What rounding may do at most, in units of `f64::EPSILON` of the natural scale: [`roundings`] times the ratios concerned.
    pub fn bound(&self, bounded: Bounded) -> f64 {
        let quantities = roundings(self.joints) * self.lever.value * self.distance.value;
        match bounded {
            Bounded::Quantities => quantities,
            Bounded::TextbookInertia => quantities * self.lightness.value,
            Bounded::Factored => quantities * self.condition.value,
            Bounded::Articulated => quantities * self.condition.value * self.lightness.value,
        }
    }

    /// How many decimal digits can be trusted, of the sixteen of a double.
    pub fn digits(&self, bounded: Bounded) -> f64 {
        (-(self.bound(bounded) * f64::EPSILON).log10()).max(0.0)
    }
}

/// What rounding may add up to in a robot of this many joints, in units of `f64::EPSILON`: three times the size of a random walk.
///
/// Some twenty roundings make an entry of Λ_q from the poses of two bodies (an inertia turned and moved, a 3×3 solve, two products of
/// six terms), and each joint before them adds four.
pub fn roundings(joints: usize) -> f64 {
    3.0 * (20.0 + 4.0 * joints as f64).sqrt()
}

/// By how much the terms of each Λ_jj exceed it, one ratio a coordinate; the largest is [`Conditioning::lever`].
pub fn levers(model: &Model<DoubleDouble>, shape: &mut Shape<'_, '_, DoubleDouble>) -> Vec<f64> {
    let mut inertia = DMatrix::zeros(model.dof(), model.dof());
    shape.shape_inertia(&mut inertia);
    let (seconds, total) = second_moments(model, shape);
    let lever = |j: usize| 1.0 + terms(model, &seconds, total, j) / inertia[(j, j)].high();
    (0..model.dof()).map(lever).collect()
}

/// A shape within the limits; where there are none, angles within ±π rad and ways within ±1 m.
fn shape(model: &Model, rng: &mut fastrand::Rng) -> Vec<DoubleDouble> {
    let within = |coordinate: &frs_core::model::Coordinate| {
        let reach = if model.bodies()[coordinate.body].motion == Motion::Revolute { std::f64::consts::PI } else { 1.0 };
        match (coordinate.limits.lower, coordinate.limits.upper) {
            (Some(lower), Some(upper)) if !coordinate.continuous => lower + (upper - lower) * rng.f64(),
            _ => reach * (2.0 * rng.f64() - 1.0),
        }
    };
    model.coordinates().iter().map(within).map(DoubleDouble::from).collect()
}

/// The condition number of a symmetric matrix.
fn condition(matrix: DMatrix<f64>) -> Ratio {
    if matrix.is_empty() {
        return Ratio::largest(std::iter::empty());
    }
    let eigen = matrix.symmetric_eigen();
    let (weakest, smallest) = eigen.eigenvalues.argmin();
    let direction: DVector<f64> = eigen.eigenvectors.column(weakest).abs();
    Ratio { value: eigen.eigenvalues.max() / smallest, coordinate: Some(direction.imax()) }
}

/// The second moments of mass about the total centre of mass of each body, and their sum (kg·m²).
fn second_moments(model: &Model<DoubleDouble>, shape: &mut Shape<'_, '_, DoubleDouble>) -> (Vec<f64>, f64) {
    let (com, bodies) = (shape.com(), model.bodies());
    let second = |k: usize| {
        // The bodies between the three joints of a planar one carry neither link nor mass.
        let Some(link) = model.links().iter().position(|link| link.body == k) else { return 0.0 };
        let pose = shape.link_pose(link) * model.links()[link].placement.inverse();
        let arm = (pose.transform(bodies[k].com) - com).map(DoubleDouble::high);
        bodies[k].mass.high() * arm.norm_squared() + 0.5 * bodies[k].inertia.to_matrix().trace().high()
    };
    let seconds: Vec<f64> = (0..bodies.len()).map(second).collect();
    let total = seconds.iter().sum();
    (seconds, total)
}

/// The terms of Λ_jj that cancel.
///
/// What a hinge moves is the difference of terms as large as the second moments of mass about the total centre of mass on its
/// two sides, of which the smaller one counts: `1/r_j = 1/Σ_in m x² + 1/Σ_out m x²`. What slides has no lever arm.
fn terms(model: &Model<DoubleDouble>, seconds: &[f64], total: f64, coordinate: usize) -> f64 {
    let bodies = model.bodies();
    let hinges =
        (1..bodies.len()).filter(|&k| bodies[k].drive.coordinate == coordinate && bodies[k].motion == Motion::Revolute);
    let term = |k: usize| {
        let inside = seconds[k..bodies[k].end].iter().sum::<f64>();
        bodies[k].drive.ratio.high().powi(2) * inside * (1.0 - inside / total)
    };
    hinges.map(term).sum()
}

/// The way to the frame of a coordinate's joint from that of the joint before it, m.
fn way(model: &Model<DoubleDouble>, coordinate: usize) -> f64 {
    model.bodies()[model.coordinates()[coordinate].body].placement.translation.map(DoubleDouble::high).norm()
}
