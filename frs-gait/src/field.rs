//! 𝓑 over a plane of shapes: at a point, and on a grid.

use frs_core::spatial::Twist;
use frs_core::{FloatingBase, Quantity};
use nalgebra::{DMatrix, Vector3};

use crate::ShapePlane;

/// A robot asked for 𝓑(e_i, e_j) at points of a plane of shapes, with the memory for the answer.
#[derive(Debug)]
pub struct PlaneCurvature<'r, R> {
    robot: &'r mut R,
    plane: &'r ShapePlane,
    layers: Vec<f64>,
}

impl<'r, R: FloatingBase> PlaneCurvature<'r, R> {
    /// `robot` over `plane`.
    ///
    /// # Panics
    /// If they have not the same number of coordinates.
    pub fn new(robot: &'r mut R, plane: &'r ShapePlane) -> Self {
        let n = robot.dof();
        assert_eq!(plane.dof(), n, "the plane and the robot have the same coordinates");
        Self { robot, plane, layers: vec![0.0; 3 * n * n] }
    }

    /// 𝓑(e_i, e_j) at a point, base frame (rad and m, per unit of both coordinates); not finite where the robot is singular.
    ///
    /// # Panics
    /// If the robot does not answer [`Quantity::Curvature`].
    pub fn at(&mut self, point: [f64; 2]) -> Twist<f64> {
        let (n, [i, j]) = (self.plane.dof(), self.plane.coordinates());
        let mut com = [0.0; 3];
        let q = self.plane.shape(point);
        self.robot.answer(Quantity::Curvature, &[&q], &mut [&mut self.layers, &mut com]);
        let angular = Vector3::from_fn(|row, _| self.layers[row * n * n + j * n + i]);
        Twist::new(angular, Vector3::from(com).cross(&angular))
    }
}

/// Points of a rectangle, as many along each side, corners included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    window: [[f64; 2]; 2],
    points: usize,
}

impl Grid {
    /// `points` × `points` over `window`, the lowest and highest value of the first coordinate, then of the second.
    ///
    /// # Panics
    /// If there are fewer than 2 points, or if a lowest value is not below its highest.
    pub fn new(window: [[f64; 2]; 2], points: usize) -> Self {
        assert!(points >= 2 && window.iter().all(|[low, high]| low < high), "a grid has two points and a rectangle");
        Self { window, points }
    }

    /// Lowest and highest value of either coordinate (rad, m).
    pub fn window(&self) -> [[f64; 2]; 2] {
        self.window
    }

    /// How many points along each side.
    pub fn points(&self) -> usize {
        self.points
    }

    /// How far neighbours stand apart along either coordinate (rad, m).
    pub fn spacing(&self) -> [f64; 2] {
        self.window.map(|[low, high]| (high - low) / (self.points - 1) as f64)
    }

    /// The point that is `i`-th along the first coordinate, `j`-th along the second, from 0.
    pub fn point(&self, i: usize, j: usize) -> [f64; 2] {
        let last = (self.points - 1) as f64;
        let along = |[low, high]: [f64; 2], k: usize| low + (high - low) * (k as f64 / last);
        [along(self.window[0], i), along(self.window[1], j)]
    }
}

/// 𝓑(e_i, e_j) on a grid, base frame.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvatureField {
    /// Where.
    pub grid: Grid,
    /// ω_x, ω_y, ω_z (rad), v_x, v_y, v_z (m), per unit of both coordinates: entry (i, j) is at [`Grid::point`]`(i, j)`.
    ///
    /// The lower three follow from the upper: `𝓑_v = c × 𝓑_ω`. Not finite where the robot is singular.
    pub components: [DMatrix<f64>; 6],
}

impl CurvatureField {
    /// Asks `robot` at every point of `grid`; `row_done` is called after each of [`Grid::points`] rows.
    ///
    /// # Panics
    /// As [`PlaneCurvature::new`] and [`PlaneCurvature::at`].
    pub fn sample(robot: &mut impl FloatingBase, plane: &ShapePlane, grid: Grid, mut row_done: impl FnMut()) -> Self {
        let mut curvature = PlaneCurvature::new(robot, plane);
        let mut components: [DMatrix<f64>; 6] = std::array::from_fn(|_| DMatrix::zeros(grid.points, grid.points));
        for j in 0..grid.points {
            for i in 0..grid.points {
                let twist = curvature.at(grid.point(i, j)).to_array();
                components.iter_mut().zip(twist).for_each(|(component, value)| component[(i, j)] = value);
            }
            row_done();
        }
        Self { grid, components }
    }
}
