//! Where the base ends when the joints walk along a path at zero momentum.

use std::f64::consts::TAU;

use frs_core::spatial::{Pose, Twist, so3};
use frs_core::{FloatingBase, Quantity};
use nalgebra::Vector3;
use thiserror::Error;

use crate::Path;

/// Where a path left the base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacement {
    /// `g₀⁻¹ g_T`: the base frame at the end, seen from the base frame at the start (m).
    pub pose: Pose<f64>,
    /// Rotation vector of `pose`, continued along the path: a planar robot that turned by 4 rad has 4 here, not 4 − 2π (rad).
    pub rotation: Vector3<f64>,
    /// Estimated error of `pose`, as the length of a twist (rad and m).
    pub error: f64,
    /// How often the connection was evaluated.
    pub evaluations: usize,
}

/// Why a path cannot be followed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum DisplacementError {
    /// The base's twist is not finite: the robot is singular there.
    #[error(
        "piece {piece}, t = {t}: the motion of the base is not finite; expected a shape in which not all mass lies on one line"
    )]
    Singular {
        /// Piece of the path.
        piece: usize,
        /// Where in the piece, 0 to 1.
        t: f64,
    },
    /// The tolerance asks for steps that are too small.
    #[error(
        "piece {piece}, t = {t}: the tolerance {tolerance:e} is not reached; expected a larger one, or a smoother path"
    )]
    Tolerance {
        /// Piece of the path.
        piece: usize,
        /// Where in the piece, 0 to 1.
        t: f64,
        /// What was asked.
        tolerance: f64,
    },
}

/// Reconstructs `g' = g (−A_l(q) q')^` from g = 1 along `path`: zero momentum, the base free.
///
/// Sixth-order Magnus steps with three Gauss-Legendre nodes, each compared with two of half the length; pieces end exactly.
/// The sum of all steps' estimated errors stays below `tolerance` (rad and m), or at rounding: 1e-13 is reached by smooth
/// paths. Whoever gives [`Quantity::BaseTwist`] will do as `robot`, a generated robot too. The origin of [`Displacement::pose`]
/// moves as the base frame's; for closed paths it only turns about the centre of mass c: `p = (1 − R) c(q₀)`.
///
/// Blanes, Casas, Ros, "Improved high order integrators based on the Magnus expansion", BIT 40 (2000).
///
/// # Errors
/// If the robot is singular on the path, or the tolerance needs steps below 1e-9 of a piece.
///
/// # Panics
/// If `path` has another number of coordinates than `robot`, or `robot` does not answer [`Quantity::BaseTwist`].
pub fn displacement(
    robot: &mut impl FloatingBase,
    path: &impl Path,
    tolerance: f64,
) -> Result<Displacement, DisplacementError> {
    assert_eq!(path.dof(), robot.dof(), "the path and the robot have the same coordinates");
    let mut walk = Walk::new(robot, path);
    let share = tolerance / path.pieces() as f64;
    let (mut pose, mut rotation, mut error) = (Pose::identity(), Vector3::zeros(), 0.0);
    let mut length = FIRST_STEP;
    for piece in 0..path.pieces() {
        let mut t = 0.0;
        while t < 1.0 {
            let end = if t + length * (1.0 + LAST_STEP_STRETCH) >= 1.0 { 1.0 } else { t + length };
            let (h, middle) = (end - t, 0.5 * (t + end));
            let whole = walk.step(piece, t, end);
            let halves = Pose::exp(walk.step(piece, t, middle)) * Pose::exp(walk.step(piece, middle, end));
            let difference = (Pose::exp(-whole) * halves).log().to_vector().norm();
            let estimate = if difference.is_finite() { difference / HALVING_GAIN } else { f64::INFINITY };
            let allowed = (share * h).max(ROUNDING);
            let fits = estimate <= allowed && whole.angular.norm() <= LONGEST_TURN;
            if !fits && h < SHORTEST_STEP {
                return Err(match difference.is_finite() {
                    true => DisplacementError::Tolerance { piece, t, tolerance },
                    false => DisplacementError::Singular { piece, t },
                });
            }
            let gain = (0.8 * (allowed / estimate).powf(1.0 / ORDER)).clamp(0.1, 4.0);
            length = h * if whole.angular.norm() > LONGEST_TURN { gain.min(0.5) } else { gain };
            length = length.min(LONGEST_STEP);
            if fits {
                pose = pose * halves;
                rotation = continued(so3::log(&pose.rotation), rotation);
                error += estimate;
                t = end;
            }
        }
    }
    Ok(Displacement { pose, rotation, error, evaluations: walk.evaluations })
}

/// Order of a step as the sum of all steps sees it.
const ORDER: f64 = 6.0;

/// Two half steps have 2⁶ times less error than a whole one; what they differ by is 63 times theirs.
const HALVING_GAIN: f64 = 63.0;

/// First step on a path, as a share of a piece.
const FIRST_STEP: f64 = 1.0 / 16.0;

/// Longest step, as a share of a piece: no path is judged by fewer than 72 shapes a piece, 18 a quarter.
const LONGEST_STEP: f64 = 0.25;

/// Shortest step, as a share of a piece.
const SHORTEST_STEP: f64 = 1e-9;

/// The last step of a piece may be longer by this share, so that no sliver remains.
const LAST_STEP_STRETCH: f64 = 1e-3;

/// The base may turn so far in a step (rad): the series converges (below π), and the rotation can be continued.
const LONGEST_TURN: f64 = 1.0;

/// Estimated error of a step that is rounding: a few units in the last place, over 63.
const ROUNDING: f64 = 3e-17;

/// Of the rotation vectors of a rotation, principal `phi` plus multiples of 2π about its axis, the one nearest to `before`.
pub(crate) fn continued(phi: Vector3<f64>, before: Vector3<f64>) -> Vector3<f64> {
    let angle = phi.norm();
    if angle == 0.0 {
        // Every axis will do: stay on the one we were on.
        let turns = (before.norm() / TAU).round();
        return if turns == 0.0 { phi } else { before.normalize() * (turns * TAU) };
    }
    let axis = phi / angle;
    phi + axis * (((before - phi).dot(&axis) / TAU).round() * TAU)
}

/// A robot on a path, with the memory that a step needs.
pub(crate) struct Walk<'r, R, P> {
    robot: &'r mut R,
    path: &'r P,
    q: Vec<f64>,
    dq: Vec<f64>,
    evaluations: usize,
}

impl<'r, R: FloatingBase, P: Path> Walk<'r, R, P> {
    pub(crate) fn new(robot: &'r mut R, path: &'r P) -> Self {
        let n = path.dof();
        Self { robot, path, q: vec![0.0; n], dq: vec![0.0; n], evaluations: 0 }
    }

    /// `A_l q'` at a point of the path: the base's twist at zero momentum, sign reversed.
    fn connection(&mut self, piece: usize, t: f64) -> Twist<f64> {
        self.path.at(piece, t, &mut self.q, &mut self.dq);
        self.ask()
    }

    /// Columns `coordinates` of A_l at a point of the path.
    pub(crate) fn connections(&mut self, coordinates: [usize; 2], piece: usize, t: f64) -> [Twist<f64>; 2] {
        coordinates.map(|coordinate| {
            self.path.at(piece, t, &mut self.q, &mut self.dq);
            self.dq.fill(0.0);
            self.dq[coordinate] = 1.0;
            self.ask()
        })
    }

    fn ask(&mut self) -> Twist<f64> {
        let mut twist = [0.0; 6];
        self.robot.answer(Quantity::BaseTwist, &[&self.q, &self.dq, &[0.0; 6]], &mut [&mut twist]);
        self.evaluations += 1;
        -Twist::from_array(twist)
    }

    /// The twist whose exponential is a step's displacement.
    ///
    /// With a = A_l q', `(g⁻¹)' = a^ g⁻¹` has the Magnus series of the reference, and g is the inverse of what it gives.
    pub(crate) fn step(&mut self, piece: usize, from: f64, to: f64) -> Twist<f64> {
        let h = to - from;
        let root = 0.6_f64.sqrt();
        let [early, middle, late] =
            [-root, 0.0, root].map(|node| self.connection(piece, from + 0.5 * h * (1.0 + node)));
        let a1 = middle * h;
        let a2 = (late - early) * (h * 15.0_f64.sqrt() / 3.0);
        let a3 = (late - middle * 2.0 + early) * (h * 10.0 / 3.0);
        let c1 = a1.ad(a2);
        let c2 = a1.ad(a3 * 2.0 + c1) * (-1.0 / 60.0);
        let brackets = (c1 - a1 * 20.0 - a3).ad(a2 + c2);
        -(a1 + a3 * (1.0 / 12.0) + brackets * (1.0 / 240.0))
    }
}

#[cfg(test)]
mod tests {
    use frs_core::{Evaluator, Model};

    use super::*;
    use crate::Gait;

    /// Halving the step divides the error by 2⁶ in the limit; at these steps by half that at least.
    const LEAST_ORDER: f64 = 5.5;

    #[test]
    fn steps_are_of_sixth_order() {
        let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE).unwrap();
        let shapes = |seed: usize| (0..7).map(|i| (i * 5 + seed) as f64).map(f64::sin).collect::<Vec<_>>();
        let loop_ = Gait::fourier(shapes(0), vec![shapes(1)], vec![shapes(2)]).unwrap();
        let mut robot = Evaluator::new(&model);
        let best = displacement(&mut robot, &loop_, 1e-14).unwrap().pose;
        let mut error = |steps: usize| {
            let mut walk = Walk::new(&mut robot, &loop_);
            let time = |step: usize| step as f64 / steps as f64;
            let end = (0..steps)
                .fold(Pose::identity(), |pose, step| pose * Pose::exp(walk.step(0, time(step), time(step + 1))));
            (best.inverse() * end).log().to_vector().norm()
        };
        let errors = [16, 32, 64].map(&mut error);
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            println!("order {order:.2} from {:.1e} to {:.1e}", pair[0], pair[1]);
            assert!(order > LEAST_ORDER, "order {order} from {errors:?}");
        }
    }
}
