//! The closed gait of given perimeter that turns the base most.

use std::f64::consts::TAU;

use frs_core::FloatingBase;
use frs_core::spatial::so3;
use nalgebra::{DVector, Matrix3, Vector2, Vector3};

use crate::displacement::{Walk, continued};
use crate::fourier_loop::{FourierLoop, NODES, ellipse};
use crate::{Displacement, DisplacementError, Gait, PlaneCurvature, ShapePlane, descent, displacement, length};

/// What a gait shall do, and within what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Unit vector, base frame: the base shall turn about it, by its rotation vector's component.
    pub axis: Vector3<f64>,
    /// Euclidean length of the loop in the two coordinates (rad, m).
    pub perimeter: f64,
    /// Lowest and highest value of either coordinate.
    pub window: [[f64; 2]; 2],
}

/// A gait that no small change makes better.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The loop, a Fourier series; it winds so that the turn about the axis is positive. Reversed, it undoes the turn.
    pub gait: Gait,
    /// What it does, reconstructed to 1e-11.
    pub displacement: Displacement,
    /// The turn about the axis (rad).
    pub turn: f64,
    /// How far the loop leaves the window at most (rad, m): 0, unless the perimeter leaves no room.
    pub outside: f64,
}

/// Centres of starting loops along either coordinate.
const CENTRES: usize = 7;

/// How many starting loops are followed to their optimum.
const STARTS: usize = 3;

/// How far apart starting loops are along one coordinate at least, as a share of half the window.
const APART: f64 = 0.3;

/// Cost of leaving the window, per mean square of the distance (1/rad²), in rounds, each from where the last one ended.
const FENCE: [f64; 3] = [30.0, 3e3, 3e5];

/// The fence stands inside the window by this share of its width, so that what it gives way does not leave the window.
const FENCE_INSET: f64 = 0.005;

/// Cost of walking unevenly (rad): the pace of a loop does not matter, and this settles it.
const EVEN_PACE: f64 = 1e-4;

/// Panels to measure the perimeter of the result: its nodes know it to a few 1e-5 where it bends sharply.
const PANELS: usize = 2000;

/// Tolerance of the reconstruction that judges the result.
const JUDGED: f64 = 1e-11;

/// Maximises the turn of the base about `target.axis` over the loops of `target.perimeter` in `plane`.
///
/// The loop is a Fourier series, scaled to the perimeter. The turn is that of the exact reconstruction, its derivative
/// comes from the curvature met on the way, with `R` the rotation up to there and φ the rotation vector of the whole:
///
/// ```text
/// δφ = dexp_φ⁻¹ ( ∮ R 𝓑_ω(γ', δγ) dt + (1 − R_T) A_ω δγ(0) )
/// ```
///
/// Starts are the best of circles all over the window; each descends to its own optimum, and the best is returned.
/// `start_done` is called after each. Loops that no circle grows into, like those that run twice around a peak, are not
/// found.
///
/// # Errors
/// If the robot is singular on a loop that is tried.
///
/// # Panics
/// If `robot` does not answer [`Quantity::Curvature`](frs_core::Quantity::Curvature) and
/// [`Quantity::BaseTwist`](frs_core::Quantity::BaseTwist), or has another number of coordinates than `plane`.
pub fn best_gait(
    robot: &mut impl FloatingBase,
    plane: &ShapePlane,
    target: Target,
    mut start_done: impl FnMut(),
) -> Result<Optimum, DisplacementError> {
    let mut best: Option<(f64, DVector<f64>)> = None;
    for mut parameters in starts(robot, plane, &target)? {
        let mut cost = f64::INFINITY;
        for fence in FENCE {
            (parameters, cost) = descent::minimum(parameters, |x| turn_cost(robot, plane, &target, fence, x))?;
        }
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, parameters));
        }
        start_done();
    }
    let (_, parameters) = best.expect("there are several starts");
    let rough = FourierLoop::new(&parameters, target.perimeter);
    let measured = length(&gait_of(&rough, &parameters, plane)?, PANELS);
    let loop_ = FourierLoop::new(&parameters, target.perimeter * (target.perimeter / measured));
    let gait = gait_of(&loop_, &parameters, plane)?;
    let displacement = displacement(robot, &gait, JUDGED)?;
    let outside = loop_.point.iter().flat_map(|point| excess(point, &target.window, 0.0).abs().data.0[0]);
    Ok(Optimum {
        turn: displacement.rotation.dot(&target.axis),
        displacement,
        outside: outside.fold(0.0, f64::max),
        gait,
    })
}

/// Circles, or ellipses where the window is narrow, that turn the base most among those around a lattice of centres.
fn starts(
    robot: &mut impl FloatingBase,
    plane: &ShapePlane,
    target: &Target,
) -> Result<Vec<DVector<f64>>, DisplacementError> {
    let radius = target.perimeter / TAU;
    let room = target.window.map(|[low, high]| 0.5 * (high - low));
    let radii = room.map(|room| radius.min(room));
    let mut found = Vec::new();
    for (i, j) in (0..CENTRES * CENTRES).map(|k| (k % CENTRES, k / CENTRES)) {
        let share = |k: usize| k as f64 / (CENTRES - 1) as f64 * 2.0 - 1.0;
        let offset = [share(i) * (room[0] - radii[0]), share(j) * (room[1] - radii[1])];
        let centre: [f64; 2] = std::array::from_fn(|axis| target.window[axis][0] + room[axis] + offset[axis]);
        let turn = -turn_cost(robot, plane, target, 0.0, &ellipse(centre, radii))?.0;
        found.push((turn, centre));
    }
    found.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    let mut chosen: Vec<(f64, [f64; 2])> = Vec::new();
    for candidate in found {
        let near =
            |other: &(f64, [f64; 2])| (0..2).all(|axis| (other.1[axis] - candidate.1[axis]).abs() < APART * room[axis]);
        if chosen.len() < STARTS && !chosen.iter().any(near) {
            chosen.push(candidate);
        }
    }
    Ok(chosen.into_iter().map(|(turn, centre)| ellipse(centre, [radii[0], radii[1].copysign(turn)])).collect())
}

/// Minus the turn, and the price of leaving the window and of walking unevenly; and the derivative.
fn turn_cost(
    robot: &mut impl FloatingBase,
    plane: &ShapePlane,
    target: &Target,
    fence: f64,
    parameters: &DVector<f64>,
) -> Result<(f64, DVector<f64>), DisplacementError> {
    let loop_ = FourierLoop::new(parameters, target.perimeter);
    let gait = gait_of(&loop_, parameters, plane)?;
    let mut walk = Walk::new(robot, &gait);
    let first = walk.connections(plane.coordinates(), 0, 0.0).map(|column| column.angular);
    let (mut rotation, mut phi) = (Matrix3::identity(), Vector3::zeros());
    let mut passed = Vec::with_capacity(NODES);
    for node in 0..NODES {
        passed.push(rotation);
        let time = |node: usize| node as f64 / NODES as f64;
        rotation *= so3::exp(walk.step(0, time(node), time(node + 1)).angular);
        phi = continued(so3::log(&rotation), phi);
    }
    if !phi.norm().is_finite() {
        return Err(DisplacementError::Singular { piece: 0, t: 0.0 });
    }
    // ⟨axis, dexp_φ⁻¹ w⟩ = ⟨dexp_{−φ}⁻¹ axis, w⟩
    let seen = so3::dexp_inverse(-phi, target.axis);
    // The loop closes, the rotation does not: the trapezoidal rule takes half of either end.
    passed[0] = (passed[0] + rotation) * 0.5;
    let mut curvature = PlaneCurvature::new(robot, plane);
    let mut cost = -phi.dot(&target.axis);
    let mut force = Vec::with_capacity(NODES);
    for ((point, rate), rotation) in loop_.point.iter().zip(&loop_.rate).zip(&passed) {
        let met = seen.dot(&(rotation * curvature.at([point.x, point.y]).angular));
        let outside = excess(point, &target.window, FENCE_INSET);
        cost += fence * outside.norm_squared() / NODES as f64;
        force.push((Vector2::new(rate.y, -rate.x) * met + outside * (2.0 * fence)) / NODES as f64);
    }
    let moved_start = first.map(|column| seen.dot(&(column - rotation * column)));
    force[0] -= Vector2::from(moved_start);
    let (unevenness, uneven) = loop_.unevenness();
    Ok((cost + EVEN_PACE * unevenness, loop_.pull_back(&force) + uneven * EVEN_PACE))
}

fn gait_of(loop_: &FourierLoop, parameters: &DVector<f64>, plane: &ShapePlane) -> Result<Gait, DisplacementError> {
    // Amplitudes that are not finite belong to a loop that shrank to a point; nothing turns there.
    loop_.gait(parameters, plane).map_err(|_| DisplacementError::Singular { piece: 0, t: 0.0 })
}

/// How far a point lies outside the window, made narrower by a share `inset` of its width on every side.
fn excess(point: &Vector2<f64>, window: &[[f64; 2]; 2], inset: f64) -> Vector2<f64> {
    Vector2::from_fn(|axis, _| {
        let [low, high] = window[axis];
        let margin = inset * (high - low);
        (point[axis] - (high - margin)).max(0.0) - ((low + margin) - point[axis]).max(0.0)
    })
}

#[cfg(test)]
mod tests {
    use frs_core::{Evaluator, Model};

    use super::*;

    /// The trapezoidal rule along a loop on which the rotation does not close: 1/128² of its slope's jump, over 12.
    const DIFFERENCES: f64 = 2e-6;

    #[test]
    fn the_derivative_of_the_cost_is_that_of_differences() {
        let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE).unwrap();
        let plane = ShapePlane::new(vec![0.2, 0.0, 1.0, 0.0, 0.3, 0.1, 0.0], [1, 3]);
        let mut robot = Evaluator::new(&model);
        let target = Target { axis: Vector3::x(), perimeter: 5.0, window: [[-0.8, 0.9], [-0.4, 1.2]] };
        let mut x = ellipse([0.2, 0.3], [0.9, 0.6]);
        (6..x.len()).for_each(|i| x[i] = 0.4 * (i as f64).sin() / (i * i) as f64);
        let mut cost = |x: &DVector<f64>| turn_cost(&mut robot, &plane, &target, 30.0, x).unwrap();
        let gradient = cost(&x).1;
        for i in 0..x.len() {
            const H: f64 = 1e-5;
            let mut at = |step: f64| {
                let mut moved = x.clone();
                moved[i] += step;
                cost(&moved).0
            };
            let difference = (at(H) - at(-H)) / (2.0 * H);
            assert!(
                (gradient[i] - difference).abs() < DIFFERENCES * gradient.norm(),
                "{i}: {} {difference}",
                gradient[i]
            );
        }
    }
}
