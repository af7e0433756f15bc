//! Minimum-perturbation coordinates: the frame in which the connection is smallest over a window.

use std::f64::consts::PI;

use frs_core::FloatingBase;
use frs_core::spatial::so3;
use nalgebra::{DMatrix, Matrix3, Vector3};

use crate::displacement::Walk;
use crate::{CurvatureField, DisplacementError, Grid, Path, ShapePlane};

/// A frame that moves with the robot as little as the base's momentum-free motion lets it, over a grid of shapes.
///
/// Its origin is the centre of mass, which stands still at zero momentum: there `A_v` and `𝓑_v` vanish. Its axes are
/// `R(q)` in the base frame, chosen so that over the window the integral of |A'_ω|² is least:
///
/// ```text
/// A'_i = Rᵀ A_ω,i − (Rᵀ ∂_i R)^∨        𝓑'_ω = Rᵀ 𝓑_ω        R = 1 in the middle of the window
/// ```
///
/// The less the connection, the farther the area rule reaches: what it leaves out are brackets of A' with itself. For
/// planar robots A' is A_ω without its gradient part (Hodge-Helmholtz), one Poisson equation with Neumann sides; for
/// others such steps are repeated until they gain nothing.
///
/// Hatton, Choset, "Geometric motion planning: the local connection, Stokes' theorem, and the importance of coordinate
/// choice", IJRR 30(8) (2011); for rotations in space first by Travers, Whitman and Choset.
#[derive(Clone, Debug, PartialEq)]
pub struct MinimumPerturbation {
    grid: Grid,
    rotation: Vec<Matrix3<f64>>,
    /// Root mean square of |A_ω| of the base over the window, per unit of joint length (rad/rad, rad/m).
    pub before: f64,
    /// The same of |A'_ω|, the least.
    pub after: f64,
}

/// A step is worth its price as long as it lowers the integral by this share.
const LEAST_GAIN: f64 = 1e-10;

/// Gauss-Newton steps at most: each divides what is left by about ten.
const MOST_STEPS: usize = 200;

impl MinimumPerturbation {
    /// Finds R(q) for `robot` on the points of `grid` over `plane`; `step_done` is called after each step.
    ///
    /// # Errors
    /// If the robot is singular on a line of the grid.
    pub fn find(
        robot: &mut impl FloatingBase,
        plane: &ShapePlane,
        grid: Grid,
        mut step_done: impl FnMut(),
    ) -> Result<Self, DisplacementError> {
        let edges = Edges::new(robot, plane, grid)?;
        let poisson = Poisson::new(grid);
        let mut rotation = vec![Matrix3::identity(); grid.points() * grid.points()];
        let start = edges.energy(&rotation);
        let mut energy = start;
        for _ in 0..MOST_STEPS {
            let step = poisson.solve(&edges.divergence(&rotation));
            let mut share = 1.0;
            let (next, least) = loop {
                let next: Vec<_> = rotation.iter().zip(&step).map(|(r, step)| r * so3::exp(step * share)).collect();
                let least = edges.energy(&next);
                if least < energy || share < 1e-3 {
                    break (next, least);
                }
                share *= 0.5;
            };
            let gain = energy - least;
            if gain > 0.0 {
                (rotation, energy) = (next, least);
            }
            step_done();
            if gain <= LEAST_GAIN * start {
                break;
            }
        }
        let middle = grid.points() / 2;
        let back = rotation[middle + grid.points() * middle].transpose();
        rotation.iter_mut().for_each(|r| *r *= back);
        let area: f64 = grid.window().iter().map(|[low, high]| high - low).product();
        Ok(Self { grid, rotation, before: (start / area).sqrt(), after: (energy / area).sqrt() })
    }

    /// R at a point of the window, between the grid's points by the rotation vectors to a cell's corners; `None` outside.
    pub fn rotation(&self, point: [f64; 2]) -> Option<Matrix3<f64>> {
        let (spacing, window, last) = (self.grid.spacing(), self.grid.window(), self.grid.points() - 1);
        let place: [f64; 2] = std::array::from_fn(|axis| (point[axis] - window[axis][0]) / spacing[axis]);
        if !place.iter().all(|place| (-1e-9..=last as f64 + 1e-9).contains(place)) {
            return None;
        }
        let [i, j] = place.map(|place| (place.max(0.0) as usize).min(last - 1));
        let [x, y] = [place[0] - i as f64, place[1] - j as f64];
        let corner = |i: usize, j: usize| self.rotation[i + self.grid.points() * j];
        let first = corner(i, j);
        let to = |i: usize, j: usize| so3::log(&first.tr_mul(&corner(i, j)));
        let blend = to(i + 1, j) * (x * (1.0 - y)) + to(i, j + 1) * ((1.0 - x) * y) + to(i + 1, j + 1) * (x * y);
        Some(first * so3::exp(blend))
    }

    /// `Rᵀ 𝓑_ω` on the grid: x, y, z (rad, per unit of both coordinates).
    ///
    /// # Panics
    /// If `field` is over another grid.
    pub fn curvature(&self, field: &CurvatureField) -> [DMatrix<f64>; 3] {
        assert_eq!(field.grid, self.grid, "the field is over the same grid");
        let points = self.grid.points();
        std::array::from_fn(|row| {
            DMatrix::from_fn(points, points, |i, j| {
                let angular = Vector3::from_fn(|axis, _| field.components[axis][(i, j)]);
                self.rotation[i + points * j].tr_mul(&angular)[row]
            })
        })
    }
}

/// How the base turns from a point of the grid to the next: exact transports, the connection without its differential.
struct Edges {
    grid: Grid,
    /// Along the first coordinate: (i, j) → (i+1, j); along the second: (i, j) → (i, j+1).
    transport: [Vec<Matrix3<f64>>; 2],
}

impl Edges {
    fn new(robot: &mut impl FloatingBase, plane: &ShapePlane, grid: Grid) -> Result<Self, DisplacementError> {
        let lines = Lines { plane, grid };
        let mut walk = Walk::new(robot, &lines);
        let mut transport = [Vec::new(), Vec::new()];
        for piece in 0..lines.pieces() {
            let twist = walk.step(piece, 0.0, 1.0);
            if !twist.angular.norm().is_finite() {
                return Err(DisplacementError::Singular { piece, t: 0.0 });
            }
            transport[lines.edge(piece).0].push(so3::exp(twist.angular));
        }
        Ok(Self { grid, transport })
    }

    /// Calls `f` for every edge with its ends, its weight in the integral of |A|² and what A' times its length is, negative.
    fn each(&self, rotation: &[Matrix3<f64>], mut f: impl FnMut(usize, usize, f64, Vector3<f64>)) {
        let (points, [x, y]) = (self.grid.points(), self.grid.spacing());
        for (axis, (transport, scale)) in self.transport.iter().zip([y / x, x / y]).enumerate() {
            for (edge, transport) in transport.iter().enumerate() {
                let (from, across) = edge_start(points, axis, edge);
                let to = from + if axis == 0 { 1 } else { points };
                let side = if across == 0 || across == points - 1 { 0.5 } else { 1.0 };
                let turn = so3::log(&(rotation[from].tr_mul(transport) * rotation[to]));
                f(from, to, side * scale, turn);
            }
        }
    }

    /// ∫ |A'|² over the window.
    fn energy(&self, rotation: &[Matrix3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.each(rotation, |_, _, weight, turn| sum += weight * turn.norm_squared());
        sum
    }

    /// Half the derivative of −[`energy`](Self::energy) as points turn by δ in their own frames.
    fn divergence(&self, rotation: &[Matrix3<f64>]) -> [DMatrix<f64>; 3] {
        let points = self.grid.points();
        let mut out = std::array::from_fn(|_| DMatrix::zeros(points, points));
        self.each(rotation, |from, to, weight, turn| {
            for (axis, out) in out.iter_mut().enumerate() {
                out[from] += weight * turn[axis];
                out[to] -= weight * turn[axis];
            }
        });
        out
    }
}

/// The point where an edge begins, and how far across its direction it lies.
fn edge_start(points: usize, axis: usize, edge: usize) -> (usize, usize) {
    match axis {
        0 => (edge % (points - 1) + points * (edge / (points - 1)), edge / (points - 1)),
        _ => (edge, edge % points),
    }
}

/// The edges of a grid as a path, a piece each.
struct Lines<'p> {
    plane: &'p ShapePlane,
    grid: Grid,
}

impl Lines<'_> {
    /// Axis and number of an edge.
    fn edge(&self, piece: usize) -> (usize, usize) {
        let along_one = self.pieces() / 2;
        (piece / along_one, piece % along_one)
    }
}

impl Path for Lines<'_> {
    fn dof(&self) -> usize {
        self.plane.dof()
    }

    fn pieces(&self) -> usize {
        2 * self.grid.points() * (self.grid.points() - 1)
    }

    fn at(&self, piece: usize, t: f64, q: &mut [f64], dq: &mut [f64]) {
        let (axis, edge) = self.edge(piece);
        let (from, _) = edge_start(self.grid.points(), axis, edge);
        let mut point = self.grid.point(from % self.grid.points(), from / self.grid.points());
        let mut direction = [0.0; 2];
        direction[axis] = self.grid.spacing()[axis];
        point[axis] += t * direction[axis];
        q.copy_from_slice(&self.plane.shape(point));
        dq.copy_from_slice(&self.plane.direction(direction));
    }
}

/// Poisson's equation on a grid with Neumann sides, diagonal in products of cosines.
struct Poisson {
    /// `cos(π j k/(N−1))`.
    cosines: DMatrix<f64>,
    /// 1/eigenvalue, 0 for the constant.
    inverse: DMatrix<f64>,
}

impl Poisson {
    fn new(grid: Grid) -> Self {
        let (points, [x, y]) = (grid.points(), grid.spacing());
        let last = points - 1;
        // The angle's share of 2π is reduced exactly.
        let cosines = DMatrix::from_fn(points, points, |j, k| (PI * ((j * k) % (2 * last)) as f64 / last as f64).cos());
        let square = |k: usize| if k == 0 || k == last { last as f64 } else { 0.5 * last as f64 };
        let inverse = DMatrix::from_fn(points, points, |k, l| {
            let value = y / x * 2.0 * (1.0 - cosines[(1, k)]) + x / y * 2.0 * (1.0 - cosines[(1, l)]);
            if (k, l) == (0, 0) { 0.0 } else { 1.0 / (value * square(k) * square(l)) }
        });
        Self { cosines, inverse }
    }

    /// The turn δ of every point.
    fn solve(&self, divergence: &[DMatrix<f64>; 3]) -> Vec<Vector3<f64>> {
        let solved = divergence.each_ref().map(|divergence| {
            let amplitudes = (self.cosines.transpose() * divergence * &self.cosines).component_mul(&self.inverse);
            &self.cosines * amplitudes * self.cosines.transpose()
        });
        (0..divergence[0].len()).map(|point| Vector3::from_fn(|axis, _| solved[axis][point])).collect()
    }
}
