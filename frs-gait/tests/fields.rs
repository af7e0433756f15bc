//! Curvature over windows: the area rule, minimum-perturbation coordinates, best gaits.

mod robots;

use std::f64::consts::{PI, TAU};

use frs_core::spatial::{Twist, so3};
use frs_core::urdf::Options;
use frs_core::{Evaluator, FloatingBase, Model, Quantity, Workspace};
use frs_gait::{
    CurvatureField, Gait, Grid, MinimumPerturbation, Path, PlaneCurvature, ShapePlane, Target, area_integral,
    best_gait, displacement, length, winding_integral,
};
use nalgebra::{Matrix3, SVector, Vector2, Vector3};

/// Rounding of a few thousand sums of numbers about 1.
const ROUNDING: f64 = 1e-12;

/// Second derivatives of a series that is cut at its eighth harmonic: rest of the ninth, times 9².
const BENDING: f64 = 0.02;

const WINDOW: [[f64; 2]; 2] = [[-1.5, 1.0], [0.2, 2.0]];

fn unit_plane() -> ShapePlane {
    ShapePlane::new(vec![0.0; 2], [0, 1])
}

fn moment(path: &impl Path, f: impl Fn(f64, f64) -> f64) -> f64 {
    winding_integral(&unit_plane(), path, 1e-13, |[x, y]| SVector::<f64, 1>::new(f(x, y))).0[0]
}

#[test]
fn regions_count_as_often_as_a_loop_winds_around_them() {
    let plane = unit_plane();
    let circle = |radius: f64| Gait::ellipse(&plane, [0.3, -0.2], [radius, 2.0 * radius]).unwrap();
    assert!((moment(&circle(0.5), |_, _| 1.0) - PI * 0.5).abs() < ROUNDING);
    assert!((moment(&circle(0.5), |x, y| x * x * y) - -0.2 * (PI * 0.5) * (0.09 + 0.0625)).abs() < ROUNDING);
    let twice =
        Gait::fourier(vec![0.0; 2], vec![vec![0.0; 2], vec![1.0, 0.0]], vec![vec![0.0; 2], vec![0.0, -1.0]]).unwrap();
    assert!((moment(&twice, |_, _| 1.0) + TAU).abs() < ROUNDING, "twice around, clockwise");
    // A lemniscate winds once forwards and once backwards: ∬ w x is twice that of its right lobe.
    let eight = Gait::fourier(vec![0.0; 2], vec![vec![0.0; 2]; 2], vec![vec![1.0, 0.0], vec![0.0, 0.5]]).unwrap();
    assert!(moment(&eight, |_, _| 1.0).abs() < ROUNDING);
    // y = ±x √(1 − x²): the right lobe's moment is ∫₀¹ 2 x² √(1 − x²) dx = π/8.
    assert!((moment(&eight, |x, _| x) + 2.0 * PI / 8.0).abs() < ROUNDING, "{}", moment(&eight, |x, _| x));
}

#[test]
fn the_curvature_of_a_plane_is_that_of_its_pair() {
    for model in robots::all() {
        let mut all = frs_core::Curvature::new(model.dof());
        let q = robots::middle(&model);
        Workspace::new(&model).shape(&q).curvature(&mut all);
        for [i, j] in [[0, 1], [1, 0]] {
            let plane = ShapePlane::new(q.clone(), [i, j]);
            let found = PlaneCurvature::new(&mut Evaluator::new(&model), &plane).at(plane.point(&q));
            assert!((found - all.get(i, j)).to_vector().norm() < ROUNDING, "{}", model.name());
        }
    }
}

#[test]
fn the_area_rule_is_exact_for_the_rotation_of_a_planar_robot() {
    let model = robots::planar_three_link();
    let plane = unit_plane();
    let mut robot = Evaluator::new(&model);
    let samples: Vec<_> = (0..40)
        .map(|k| TAU * f64::from(k) / 40.0)
        .map(|t| vec![0.4 + 1.2 * t.cos() + 0.3 * (3.0 * t).sin(), 1.0 + 0.9 * t.sin()])
        .collect();
    let gaits = [
        Gait::ellipse(&plane, [0.2, 1.4], [1.3, 0.6]).unwrap(),
        Gait::polygon(&[vec![0.0, 0.0], vec![2.0, 0.3], vec![1.0, 2.5]]).unwrap(),
        Gait::spline(&samples).unwrap(),
        // Crosses itself.
        Gait::polygon(&[vec![0.0, 0.0], vec![2.0, 2.0], vec![2.0, 0.5], vec![0.0, 1.5]]).unwrap(),
    ];
    for gait in gaits {
        let area = area_integral(&mut robot, &plane, &gait, 1e-10);
        let exact = displacement(&mut robot, &gait, 1e-12).unwrap();
        let gap = (area.body.angular - exact.rotation).norm();
        println!("turn {:.6}, gap {gap:.1e}, error {:.1e}", exact.rotation.z, area.error);
        assert!(gap < 1e-9 && exact.rotation.norm() > 1e-2, "{gap}");
    }
}

#[test]
fn the_gap_of_the_area_rule_shrinks_faster_than_the_area() {
    let model = robots::lwr_satellite();
    let plane = ShapePlane::new(robots::middle(&model), [0, 1]);
    let mut robot = Evaluator::new(&model);
    let mut gap = |radius: f64| {
        let gait = Gait::ellipse(&plane, [0.3, 0.4], [radius, radius]).unwrap();
        let area = area_integral(&mut robot, &plane, &gait, 1e-13);
        (area.body - displacement(&mut robot, &gait, 1e-13).unwrap().pose.log()).to_vector().norm()
    };
    let order = (gap(0.02) / gap(0.01)).log2();
    assert!(order > 2.9, "order {order}");
}

#[test]
fn a_spline_through_an_ellipse_is_the_ellipse_to_fourth_order() {
    let off = |count: usize| {
        let point = |k: usize| TAU * k as f64 / count as f64;
        let samples: Vec<_> = (0..count).map(|k| vec![2.0 * point(k).cos(), point(k).sin()]).collect();
        (moment(&Gait::spline(&samples).unwrap(), |_, _| 1.0) - 2.0 * PI).abs()
    };
    let order = (off(20) / off(40)).log2();
    assert!(order > 3.5, "order {order}");
}

/// A robot whose axes turn by `twist(q)` against a frame that stands still: its connection is a pure gauge.
struct Gauge;

impl Gauge {
    fn rotation(q: &[f64]) -> Matrix3<f64> {
        let (x, y) = (q[0], q[1]);
        so3::exp(Vector3::new(0.6 * x.sin(), 0.5 * x * y, 0.4 * y))
            * so3::exp(Vector3::new(0.0, 0.3 * (x - y).cos(), 0.2 * x))
    }
}

impl FloatingBase for Gauge {
    fn dof(&self) -> usize {
        2
    }
    fn answers(&self, quantity: Quantity) -> bool {
        quantity == Quantity::BaseTwist
    }
    fn answer(&mut self, _: Quantity, inputs: &[&[f64]], outputs: &mut [&mut [f64]]) {
        const H: f64 = 1e-4;
        let shifted = |steps: f64| {
            let q: Vec<_> = inputs[0].iter().zip(inputs[1]).map(|(q, dq)| q + steps * H * dq).collect();
            so3::log(&(Self::rotation(inputs[0]).transpose() * Self::rotation(&q)))
        };
        let rate = ((shifted(1.0) - shifted(-1.0)) * 8.0 - (shifted(2.0) - shifted(-2.0))) / (12.0 * H);
        outputs[0].copy_from_slice(&Twist::new(rate, Vector3::zeros()).to_array());
    }
}

#[test]
fn a_flat_connection_is_combed_away() {
    let found = MinimumPerturbation::find(&mut Gauge, &unit_plane(), Grid::new(WINDOW, 21), || ()).unwrap();
    println!("{} → {:e}", found.before, found.after);
    assert!(found.before > 0.5 && found.after < 1e-6, "{} {}", found.before, found.after);
    // What undoes the robot's own turning is its inverse, up to the constant that makes it 1 in the middle.
    let point = [0.3, 1.7];
    let middle = Gauge::rotation(&[-0.25, 1.1]);
    let expected = Gauge::rotation(&point).transpose() * middle;
    let off = (found.rotation(point).unwrap() - expected).norm();
    assert!(off < 1e-2, "{off}");
    assert!(found.rotation([1.1, 1.0]).is_none());
}

/// The satellite with one of its links as base, over joints 1 and 2 with the others held.
fn combed(root: Option<&str>) -> (MinimumPerturbation, [nalgebra::DMatrix<f64>; 3]) {
    let text = include_str!("../../robots/lwr_satellite.urdf");
    let model = Model::from_urdf_with(text, &Options { root, ..Options::default() }).unwrap();
    let number = |name: &str| model.coordinates().iter().position(|c| c.name == name).unwrap();
    let mut q0 = vec![0.0; 7];
    q0[number("joint_4")] = 0.8;
    let plane = ShapePlane::new(q0, [number("joint_1"), number("joint_2")]);
    let (mut robot, grid) = (Evaluator::new(&model), Grid::new(WINDOW, 21));
    let found = MinimumPerturbation::find(&mut robot, &plane, grid, || ()).unwrap();
    let curvature = found.curvature(&CurvatureField::sample(&mut robot, &plane, grid, || ()));
    (found, curvature)
}

#[test]
fn minimum_perturbation_does_not_depend_on_which_link_is_the_base() {
    let ((base, _), (link, _)) = (combed(None), combed(Some("link_2")));
    println!("{} → {}; {} → {}", base.before, base.after, link.before, link.after);
    assert!((base.before - link.before).abs() > 0.1 && (base.after - link.after).abs() < 1e-6 * base.after);
}

#[test]
fn every_link_sees_the_same_curvature_in_minimum_perturbation_coordinates() {
    let ((_, base), (_, link)) = (combed(None), combed(Some("link_2")));
    let vector = |layers: &[nalgebra::DMatrix<f64>], point: usize| Vector3::from_fn(|axis, _| layers[axis][point]);
    // The two frames differ by a constant rotation, which angles between values at different shapes do not see.
    let angles = |layers: &[nalgebra::DMatrix<f64>]| -> Vec<f64> {
        (0..441).flat_map(|p| [0, 20, 220].map(|other| vector(layers, p).dot(&vector(layers, other)))).collect()
    };
    let (base, link) = (angles(&base), angles(&link));
    let largest = base.iter().copied().map(f64::abs).fold(0.0, f64::max);
    let apart = base.iter().zip(&link).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    println!("{apart:e} of {largest}");
    // The search ends where it gains 1e-10 of the integral; the frame is known to the root of that.
    assert!(apart < 1e-4 * largest, "{apart} of {largest}");
}

#[test]
fn minimum_perturbation_makes_the_area_rule_reach_farther() {
    let model = robots::lwr_satellite();
    let plane = ShapePlane::new(vec![0.3; 7], [0, 1]);
    let mut robot = Evaluator::new(&model);
    let gait = Gait::ellipse(&plane, [-0.25, 1.1], [0.8, 0.7]).unwrap();
    let found = MinimumPerturbation::find(&mut robot, &plane, Grid::new(WINDOW, 41), || ()).unwrap();
    let exact = displacement(&mut robot, &gait, 1e-10).unwrap().rotation;
    let body = (area_integral(&mut robot, &plane, &gait, 1e-7).body.angular - exact).norm();
    let (area, _) = found.area_integral(&mut robot, &plane, &gait, 1e-5);
    let least = (area - found.rotation([0.55, 1.1]).unwrap().tr_mul(&exact)).norm();
    println!(
        "of {:.3} rad the area rule misses {body:.3} in the base frame, {least:.3} in minimum perturbation",
        exact.norm()
    );
    assert!(least < 0.5 * body && exact.norm() > 0.1, "{least} {body}");
    let away = Gait::ellipse(&plane, [0.8, 1.1], [0.8, 0.7]).unwrap();
    assert!(!found.area_integral(&mut robot, &plane, &away, 1e-5).0.norm().is_finite());
}

#[test]
fn minimum_perturbation_coordinates_only_turn_the_curvature() {
    let model = robots::lwr_satellite();
    let plane = ShapePlane::new(robots::middle(&model), [0, 1]);
    let (mut robot, grid) = (Evaluator::new(&model), Grid::new(WINDOW, 11));
    let field = CurvatureField::sample(&mut robot, &plane, grid, || ());
    let turned = MinimumPerturbation::find(&mut robot, &plane, grid, || ()).unwrap().curvature(&field);
    for point in 0..121 {
        let norm = |layers: &[nalgebra::DMatrix<f64>]| Vector3::from_fn(|axis, _| layers[axis][point]).norm();
        assert!((norm(&turned) - norm(&field.components[..3])).abs() < ROUNDING);
    }
    let middle = Vector3::from_fn(|axis, _| turned[axis][(5, 5)] - field.components[axis][(5, 5)]);
    assert!(middle.norm() < ROUNDING, "R = 1 in the middle");
}

#[test]
fn the_best_planar_gait_bends_as_the_curvature_along_it() {
    let model = robots::planar_three_link();
    let plane = unit_plane();
    let mut robot = Evaluator::new(&model);
    let target = Target { axis: Vector3::z(), perimeter: 4.0, window: [[-PI, PI]; 2] };
    let best = best_gait(&mut robot, &plane, target, || ()).unwrap();
    println!("turn {} {:?}", best.turn, best.displacement);
    assert!((length(&best.gait, 400) - 4.0).abs() < 1e-6 && best.outside == 0.0);
    let mut curvature = PlaneCurvature::new(&mut robot, &plane);
    let ratios: Vec<f64> = (0..64)
        .map(|k| {
            let at = |t: f64| {
                let (mut q, mut dq) = ([0.0; 2], [0.0; 2]);
                best.gait.at(0, t, &mut q, &mut dq);
                (q, Vector2::from(dq))
            };
            let t = f64::from(k) / 64.0;
            let ((q, rate), bend) = (at(t), (at(t + 1e-5).1 - at(t - 1e-5).1) / 2e-5);
            let bending = (rate.x * bend.y - rate.y * bend.x) / rate.norm().powi(3);
            bending / curvature.at(q).angular.z
        })
        .collect();
    let mean = ratios.iter().sum::<f64>() / 64.0;
    let off = (ratios.iter().map(|ratio| (ratio / mean - 1.0).powi(2)).sum::<f64>() / 64.0).sqrt();
    println!("bending over curvature: mean {mean}, off by {off:.1e} in the mean square");
    assert!(off < BENDING, "{ratios:?}");
}

#[test]
fn no_circle_beats_the_best_gait_of_the_satellite() {
    let model = robots::lwr_satellite();
    let plane = ShapePlane::new(vec![0.3; 7], [0, 1]);
    let mut robot = Evaluator::new(&model);
    let window = [[-2.9, 2.9], [-1.5, 1.5]];
    let (axis, perimeter) = (Vector3::y(), 5.0);
    let best = best_gait(&mut robot, &plane, Target { axis, perimeter, window }, || ()).unwrap();
    println!("turn {} outside {} {:?}", best.turn, best.outside, best.displacement);
    let radius = perimeter / TAU;
    for k in 0..25 {
        let centre = [f64::from(k % 5 - 2) * 0.9, f64::from(k / 5 - 2) * 0.3];
        let circle = Gait::ellipse(&plane, centre, [radius; 2]).unwrap();
        let turn = displacement(&mut robot, &circle, 1e-9).unwrap().rotation.dot(&axis);
        assert!(turn.abs() < best.turn, "{centre:?}: {turn}");
    }
}
