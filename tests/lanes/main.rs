//! Generated code over lanes, in single precision and in every form, compiled: every lane has the bits of the core.

use std::path::Path;

use frs::lanes::{F32x8, F32x16, F64x4, F64x8};
use frs::{Evaluator, FloatingBase, Model, Quantity, Real};

frs::frs_model!(mod four = "robots/planar_three_link.urdf", lanes = 4);
frs::frs_model!(mod eight = "robots/planar_three_link.urdf", lanes = 8);
frs::frs_model!(mod arm = "robots/lwr_satellite.urdf", lanes = 8, outputs(inertia));
frs::frs_model!(mod hybrid = "robots/lwr_satellite.urdf", form = hybrid, outputs(inertia, matrices, forward_dynamics));
frs::frs_model!(mod every_form = "robots/quadruped.urdf", outputs(momentum, inertia, forward_dynamics));
frs::frs_model!(mod loops = "robots/humanoid.urdf", form = tabled);
frs::frs_model!(mod follower = "robots/dual_arm_satellite.urdf", form = tabled, lock(left_elbow_pitch = -0.5));
frs::frs_model!(mod eight_in_loops = "robots/quadruped.urdf", form = tabled, lanes = 8, outputs(matrices, kinematics));
frs::frs_model!(mod singles_in_loops = "robots/chaser.urdf", form = tabled, scalar = f32, lanes = 8);
frs::frs_model!(mod single = "robots/lwr_satellite.urdf", form = unrolled, scalar = f32, outputs(inertia, b2, forward_dynamics));
frs::frs_model!(mod eight_single = "robots/planar_three_link.urdf", scalar = f32, lanes = 8);
frs::frs_model!(mod sixteen_single = "robots/planar_three_link.urdf", scalar = f32, lanes = 16);

/// States at which each function is compared: at least ten thousand.
const STATES: usize = 10_000;

/// A number that is several numbers side by side.
trait Lanes: Real {
    type Element: Real;
    const COUNT: usize;
    fn from_lanes(lane: impl Fn(usize) -> Self::Element) -> Self;
    fn lane(self, lane: usize) -> Self::Element;
    fn element(value: f64) -> Self::Element;
    fn bits(element: Self::Element) -> Option<u64>;
}

macro_rules! lanes {
    ($($type:ty: $element:ty, $count:literal, $from:expr, $to:expr;)*) => {
        $(impl Lanes for $type {
            type Element = $element;
            const COUNT: usize = $count;
            fn from_lanes(lane: impl Fn(usize) -> $element) -> Self {
                $from(std::array::from_fn::<$element, $count, _>(lane))
            }
            fn lane(self, lane: usize) -> $element {
                $to(self)[lane]
            }
            fn element(value: f64) -> $element {
                value as $element
            }
            fn bits(element: $element) -> Option<u64> {
                element.is_finite().then(|| u64::from(element.to_bits()))
            }
        })*
    };
}

lanes! {
    F64x4: f64, 4, F64x4::from_array, F64x4::to_array;
    F64x8: f64, 8, F64x8::from_array, F64x8::to_array;
    F32x8: f32, 8, F32x8::from_array, F32x8::to_array;
    F32x16: f32, 16, F32x16::from_array, F32x16::to_array;
    f64: f64, 1, |[one]: [f64; 1]| one, |one| [one];
    f32: f32, 1, |[one]: [f32; 1]| one, |one| [one];
}

fn answer<T: Real>(robot: &mut impl FloatingBase<T>, quantity: Quantity, inputs: &[Vec<T>]) -> Vec<T> {
    let n = robot.dof();
    let mut outputs: Vec<Vec<T>> = quantity.outputs().map(|o| vec![T::from_f64(f64::NAN); o.len(n)]).collect();
    let inputs: Vec<&[T]> = inputs.iter().map(Vec::as_slice).collect();
    let mut slices: Vec<&mut [T]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
    robot.answer(quantity, &inputs, &mut slices);
    outputs.concat()
}

fn robot(file: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("robots").join(file);
    Model::from_urdf(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn every_lane_has_the_bits_of_the_core<T: Lanes>(file: &str, generated: impl FloatingBase<T>) {
    every_lane_has_the_bits_of_its_core(&robot(file), generated);
}

/// Every lane of every answer has the bits of the core over that lane's state.
fn every_lane_has_the_bits_of_its_core<T: Lanes>(model: &Model, mut generated: impl FloatingBase<T>) {
    let model: Model<T::Element> = model.cast();
    let n = model.dof();
    let mut core = Evaluator::new(&model);
    let links = (0..model.links().len()).map(Quantity::Kinematics);
    let known: Vec<_> = Quantity::ALL.into_iter().chain(links).filter(|&q| generated.answers(q)).collect();
    assert!(!known.is_empty(), "a robot that answers nothing proves nothing");
    let mut random = fastrand::Rng::with_seed(8);
    for quantity in known {
        for _ in 0..STATES / T::COUNT {
            let mut state = || -> Vec<Vec<T::Element>> {
                let mut entries = |len| (0..len).map(|_| T::element(random.f64() * 16.0 - 8.0)).collect();
                quantity.inputs().map(|input| entries(input.len(n))).collect()
            };
            let states: Vec<_> = (0..T::COUNT).map(|_| state()).collect();
            let together = |i: usize, k: usize| T::from_lanes(|lane| states[lane][i][k]);
            let inputs: Vec<Vec<T>> = states[0]
                .iter()
                .enumerate()
                .map(|(i, input)| (0..input.len()).map(|k| together(i, k)).collect())
                .collect();
            let actual = answer(&mut generated, quantity, &inputs);
            for (lane, state) in states.iter().enumerate() {
                let expected = answer(&mut core, quantity, state);
                for (entry, (&expected, actual)) in expected.iter().zip(&actual).enumerate() {
                    let (expected, actual) = (T::bits(expected), T::bits(actual.lane(lane)));
                    assert!(expected.is_some() && expected == actual, "{quantity:?}, entry {entry}, lane {lane}");
                }
            }
        }
    }
}

#[test]
fn four_doubles() {
    every_lane_has_the_bits_of_the_core("planar_three_link.urdf", four::PlanarThreeLink);
}

#[test]
fn eight_doubles() {
    every_lane_has_the_bits_of_the_core("planar_three_link.urdf", eight::PlanarThreeLink);
}

#[test]
fn eight_doubles_of_an_arm() {
    every_lane_has_the_bits_of_the_core("lwr_satellite.urdf", arm::LwrSatellite);
}

#[test]
fn one_double_in_the_hybrid_form() {
    every_lane_has_the_bits_of_the_core("lwr_satellite.urdf", hybrid::LwrSatellite);
}

#[test]
fn all_forms_in_one_module() {
    every_lane_has_the_bits_of_the_core("quadruped.urdf", every_form::Quadruped);
}

#[test]
fn loops_over_tables() {
    every_lane_has_the_bits_of_the_core("humanoid.urdf", loops::Humanoid);
}

#[test]
fn loops_with_followers_and_a_held_joint() {
    let model = robot("dual_arm_satellite.urdf").lock(&[("left_elbow_pitch", -0.5)]).unwrap();
    every_lane_has_the_bits_of_its_core(&model, follower::DualArmSatellite);
}

#[test]
fn eight_doubles_in_loops() {
    every_lane_has_the_bits_of_the_core("quadruped.urdf", eight_in_loops::Quadruped);
}

#[test]
fn eight_singles_in_loops() {
    every_lane_has_the_bits_of_the_core("chaser.urdf", singles_in_loops::Chaser);
}

#[test]
fn one_single() {
    every_lane_has_the_bits_of_the_core("lwr_satellite.urdf", single::LwrSatellite);
}

#[test]
fn eight_singles() {
    every_lane_has_the_bits_of_the_core("planar_three_link.urdf", eight_single::PlanarThreeLink);
}

#[test]
fn sixteen_singles() {
    every_lane_has_the_bits_of_the_core("planar_three_link.urdf", sixteen_single::PlanarThreeLink);
}
