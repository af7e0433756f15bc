//! The area rule: a loop displaces the base by −∬ 𝓑 over what it encloses, to leading order.

use frs_core::FloatingBase;
use frs_core::spatial::Twist;
use nalgebra::{SVector, Vector3, Vector6};

use crate::{MinimumPerturbation, Path, PlaneCurvature, ShapePlane};

/// What the area rule says of a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaIntegral {
    /// `−∬ 𝓑(e_i, e_j) dq_i dq_j`, base frame (rad, m). For planar robots its angular part is the exact rotation.
    pub body: Twist<f64>,
    /// Estimated error of it.
    pub error: f64,
}

/// −∬ 𝓑 over what `path` encloses in `plane`, each region counted as often as the path winds around it.
///
/// # Panics
/// As [`PlaneCurvature::new`] and [`PlaneCurvature::at`].
pub fn area_integral(
    robot: &mut impl FloatingBase,
    plane: &ShapePlane,
    path: &impl Path,
    tolerance: f64,
) -> AreaIntegral {
    let mut curvature = PlaneCurvature::new(robot, plane);
    let (sum, error) = winding_integral(plane, path, tolerance, |point| Vector6::from(curvature.at(point).to_array()));
    AreaIntegral { body: Twist::from_array((-sum).into()), error }
}

impl MinimumPerturbation {
    /// `−∬ Rᵀ 𝓑_ω`, the area rule for the rotation in these coordinates, and its error (rad); not finite if `path` leaves
    /// the window.
    ///
    /// To compare with `Rᵀ φ`: φ the exact rotation vector in the base frame, R at the start.
    ///
    /// # Panics
    /// As [`area_integral`].
    pub fn area_integral(
        &self,
        robot: &mut impl FloatingBase,
        plane: &ShapePlane,
        path: &impl Path,
        tolerance: f64,
    ) -> (Vector3<f64>, f64) {
        let mut curvature = PlaneCurvature::new(robot, plane);
        let outside = Vector3::repeat(f64::NAN);
        let turned = |point| self.rotation(point).map_or(outside, |r| r.tr_mul(&curvature.at(point).angular));
        let (sum, error) = winding_integral(plane, path, tolerance, turned);
        (-sum, error)
    }
}

/// `∬ w(x, y) f(x, y) dx dy` with w the number of times that `path`, seen in `plane`, winds around (x, y); and its error.
///
/// Every bit of the path spans a triangle with a fixed point, and what it sweeps counts with its orientation: for γ seen
/// from that point, `∮ det(γ, γ') ∫₀¹ f(s γ) s ds dt`. Composite Gauss-Legendre quadrature, with twice the panels until
/// two results differ by less than `tolerance`; at most a million values of f. Shapes off the plane count as the points
/// below them, and a path that is not closed is closed by the straight line.
pub fn winding_integral<const K: usize>(
    plane: &ShapePlane,
    path: &impl Path,
    tolerance: f64,
    mut f: impl FnMut([f64; 2]) -> SVector<f64, K>,
) -> (SVector<f64, K>, f64) {
    let (mut panels, mut before): (_, Option<SVector<f64, K>>) = (1, None);
    loop {
        let sum = fan(plane, path, panels, &mut f);
        let error = before.map_or(f64::INFINITY, |before| (sum - before).norm());
        let dearer = path.pieces() * (2 * panels * NODES).pow(2);
        if error <= tolerance || dearer > MOST_VALUES || !sum.norm().is_finite() {
            return (sum, error);
        }
        before = Some(sum);
        panels *= 2;
    }
}

/// Values of the integrand that a result may cost.
const MOST_VALUES: usize = 1_000_000;

/// Gauss-Legendre nodes a panel.
const NODES: usize = 4;

/// The sum over all triangles between `path` and its middle.
fn fan<const K: usize>(
    plane: &ShapePlane,
    path: &impl Path,
    panels: usize,
    f: &mut impl FnMut([f64; 2]) -> SVector<f64, K>,
) -> SVector<f64, K> {
    let (mut q, mut dq) = (vec![0.0; path.dof()], vec![0.0; path.dof()]);
    let mut at = |piece: usize, t: f64| {
        path.at(piece, t, &mut q, &mut dq);
        (plane.point(&q), plane.point(&dq))
    };
    let starts: Vec<_> = (0..path.pieces()).map(|piece| at(piece, 0.5).0).collect();
    let mean = |axis: usize| starts.iter().map(|start| start[axis]).sum::<f64>() / starts.len() as f64;
    let pole = [mean(0), mean(1)];
    let mut sum = SVector::zeros();
    for piece in 0..path.pieces() {
        for (t, weight) in nodes(panels) {
            let ([x, y], [dx, dy]) = at(piece, t);
            let arm = [x - pole[0], y - pole[1]];
            let swept = weight * (arm[0] * dy - arm[1] * dx);
            for (s, weight) in nodes(panels) {
                sum += f([pole[0] + s * arm[0], pole[1] + s * arm[1]]) * (swept * weight * s);
            }
        }
    }
    sum
}

/// Nodes and weights of Gauss and Legendre on [0, 1], four a panel.
fn nodes(panels: usize) -> impl Iterator<Item = (f64, f64)> {
    let spread = 2.0 / 7.0 * 1.2_f64.sqrt();
    let (inner, outer) = ((3.0 / 7.0 - spread).sqrt(), (3.0 / 7.0 + spread).sqrt());
    let root = 30.0_f64.sqrt();
    let (heavy, light) = ((18.0 + root) / 72.0, (18.0 - root) / 72.0);
    let width = 1.0 / panels as f64;
    (0..panels).flat_map(move |panel| {
        [(-outer, light), (-inner, heavy), (inner, heavy), (outer, light)]
            .map(|(node, weight)| ((panel as f64 + 0.5 * (1.0 + node)) * width, weight * width))
    })
}
