//! Displacements of closed shape paths.

mod robots;

use frs_core::spatial::{Pose, Twist};
use frs_core::{Evaluator, FloatingBase, Model, Quantity, Workspace};
use frs_gait::{DisplacementError, Gait, Path, Reversed, ShapePlane, displacement};
use nalgebra::{Matrix3, Vector3};

/// What a tight run asks for (rad, m).
const TIGHT: f64 = 1e-12;

/// How far two tight runs may differ: both errors, and the rounding of a few hundred poses of metres.
const AGREEMENT: f64 = 3e-12;

fn pose(model: &Model, path: &impl Path, tolerance: f64) -> Pose<f64> {
    displacement(&mut Evaluator::new(model), path, tolerance).unwrap().pose
}

fn apart(a: &Pose<f64>, b: &Pose<f64>) -> f64 {
    (a.inverse() * *b).log().to_vector().norm()
}

/// A loop that uses all joints, with as many harmonics as `harmonics`.
fn wild(model: &Model, harmonics: usize) -> Gait {
    let n = model.dof();
    let vector =
        |seed: usize, size: f64| (0..n).map(|i| size * ((7 * i + 3 * seed + 1) as f64).sin()).collect::<Vec<_>>();
    let series = |seed: usize| (1..=harmonics).map(|k| vector(seed + k, 0.5 / k as f64)).collect::<Vec<_>>();
    Gait::fourier(vector(0, 0.8), series(10), series(20)).unwrap()
}

/// The counter-clockwise square of edge `size` from [`robots::middle`].
fn square(model: &Model, coordinates: [usize; 2], size: f64) -> Gait {
    let plane = ShapePlane::new(robots::middle(model), coordinates);
    let [x, y] = plane.point(&robots::middle(model));
    let corners = [[x, y], [x + size, y], [x + size, y + size], [x, y + size]];
    Gait::polygon(&corners.map(|corner| plane.shape(corner))).unwrap()
}

/// The same path, walked at another pace.
struct Repaced<P>(P);

impl<P: Path> Path for Repaced<P> {
    fn dof(&self) -> usize {
        self.0.dof()
    }
    fn pieces(&self) -> usize {
        self.0.pieces()
    }
    fn at(&self, piece: usize, t: f64, q: &mut [f64], dq: &mut [f64]) {
        self.0.at(piece, t * t * (3.0 - 2.0 * t), q, dq);
        dq.iter_mut().for_each(|rate| *rate *= 6.0 * t * (1.0 - t));
    }
}

#[test]
fn error_estimates_bound_the_errors_down_to_1e_12() {
    for model in robots::all() {
        let path = wild(&model, 3);
        let best = pose(&model, &path, 1e-14);
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            let found = displacement(&mut Evaluator::new(&model), &path, tolerance).unwrap();
            let error = apart(&best, &found.pose);
            println!(
                "{} {tolerance:e}: {error:e} est {:e} evaluations {}",
                model.name(),
                found.error,
                found.evaluations
            );
            assert!(found.error <= tolerance && error <= tolerance.max(AGREEMENT), "{}", model.name());
        }
    }
}

#[test]
fn closed_paths_turn_the_base_about_the_centre_of_mass() {
    for model in robots::all() {
        for path in [wild(&model, 2), square(&model, [0, 1], 0.7)] {
            let (mut q, mut dq) = (vec![0.0; model.dof()], vec![0.0; model.dof()]);
            path.at(0, 0.0, &mut q, &mut dq);
            let com = Workspace::new(&model).shape(&q).com();
            let pose = pose(&model, &path, TIGHT);
            let off = (Matrix3::identity() - pose.rotation) * com - pose.translation;
            assert!(off.norm() < AGREEMENT && pose.rotation != Matrix3::identity(), "{}: {off}", model.name());
        }
    }
}

#[test]
fn the_reversed_path_gives_the_inverse() {
    for model in robots::all() {
        let path = wild(&model, 2);
        let (there, back) = (pose(&model, &path, TIGHT), pose(&model, &Reversed(&path), TIGHT));
        assert!(apart(&there.inverse(), &back) < AGREEMENT, "{}", model.name());
        assert!(apart(&there, &back) > 1e-3, "{}: the path does nothing", model.name());
    }
}

#[test]
fn the_pace_does_not_matter() {
    for model in robots::all() {
        let path = wild(&model, 2);
        assert!(apart(&pose(&model, &path, TIGHT), &pose(&model, &Repaced(&path), TIGHT)) < AGREEMENT);
    }
}

#[test]
fn points_on_the_edges_of_a_polygon_do_not_matter() {
    let model = robots::lwr_satellite();
    let plane = ShapePlane::new(vec![0.2; 7], [1, 3]);
    let polygon = |points: &[[f64; 2]]| {
        Gait::polygon(&points.iter().map(|&point| plane.shape(point)).collect::<Vec<_>>()).unwrap()
    };
    let few = polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    let many = polygon(&[[0.0, 0.0], [0.3, 0.0], [1.0, 0.0], [0.9, 0.1], [0.25, 0.75], [0.0, 1.0], [0.0, 0.0]]);
    assert_eq!((few.pieces(), many.pieces()), (3, 6));
    assert!(apart(&pose(&model, &few, TIGHT), &pose(&model, &many, TIGHT)) < AGREEMENT);
}

#[test]
fn small_squares_displace_by_minus_curvature_times_area() {
    for model in robots::all() {
        let q0 = robots::middle(&model);
        let curvature = {
            let mut curvature = frs_core::Curvature::new(model.dof());
            Workspace::new(&model).shape(&q0).curvature(&mut curvature);
            curvature.get(0, 1)
        };
        let residual = |size: f64| {
            let log = pose(&model, &square(&model, [0, 1], size), 1e-14).log();
            (log + curvature * (size * size)).to_vector().norm()
        };
        let (large, small) = (residual(0.02), residual(0.01));
        let order = (large / small).log2();
        println!("{}: order {order}", model.name());
        assert!(order > 2.9 && curvature.to_vector().norm() > 1e-4, "{}: order {order}", model.name());
    }
}

#[test]
fn a_rotation_is_continued_beyond_half_a_turn() {
    let model = robots::planar_three_link();
    let plane = ShapePlane::new(vec![0.0; 2], [0, 1]);
    let once = Gait::ellipse(&plane, [0.0, 1.5], [1.5, 1.5]).unwrap();
    let turn = displacement(&mut Evaluator::new(&model), &once, TIGHT).unwrap().rotation;
    struct Often<P>(P, usize);
    impl<P: Path> Path for Often<P> {
        fn dof(&self) -> usize {
            self.0.dof()
        }
        fn pieces(&self) -> usize {
            self.1 * self.0.pieces()
        }
        fn at(&self, piece: usize, t: f64, q: &mut [f64], dq: &mut [f64]) {
            self.0.at(piece % self.0.pieces(), t, q, dq);
        }
    }
    let often = (8.0 / turn.norm()).ceil() as usize;
    let turns = displacement(&mut Evaluator::new(&model), &Often(&once, often), TIGHT).unwrap().rotation;
    assert!((turns - turn * often as f64).norm() < AGREEMENT && turns.norm() > 8.0, "{turn} {turns}");
}

/// A robot of one coordinate whose base moves at `(0.5 − q)^power` per unit of q.
struct Power(f64);

impl FloatingBase for Power {
    fn dof(&self) -> usize {
        1
    }
    fn answers(&self, quantity: Quantity) -> bool {
        quantity == Quantity::BaseTwist
    }
    fn answer(&mut self, _: Quantity, inputs: &[&[f64]], outputs: &mut [&mut [f64]]) {
        let twist = Twist::new(Vector3::z(), Vector3::x()) * (inputs[1][0] * (0.5 - inputs[0][0]).powf(self.0));
        outputs[0].copy_from_slice(&twist.to_array());
    }
}

#[test]
fn where_a_path_cannot_be_followed_is_said() {
    let there_and_back = Gait::polygon(&[vec![0.0], vec![1.0]]).unwrap();
    match displacement(&mut Power(-1.0), &there_and_back, TIGHT) {
        Err(DisplacementError::Tolerance { piece: 0, t, .. }) => assert!((t - 0.5).abs() < 1e-4, "{t}"),
        other => panic!("a pole was passed: {other:?}"),
    }
    match displacement(&mut Power(1.5), &there_and_back, 1e-6) {
        Err(DisplacementError::Singular { piece: 0, t }) => assert!((t - 0.5).abs() < 1e-8, "{t}"),
        other => panic!("what is no number was passed: {other:?}"),
    }
}
