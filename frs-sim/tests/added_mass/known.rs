//! Motions in water that are known otherwise, and what the water does beside other effects.

use frs_core::Model;
use frs_core::extended::DoubleDouble;
use frs_core::spatial::{Pose, Twist};
use frs_sim::integrate::{State, Tangent};
use frs_sim::run::{Sample, equations};
use frs_sim::scene::Case;
use nalgebra::Vector3;

use super::{ACCUMULATED, ROUNDING, SWING, WATER, added, body, flown, satellite, scene, water};

/// A light sphere (½ ρ V, the water that it displaces is ρ V) rises with `(ρ V − m) g / (m + ½ ρ V)`.
#[test]
fn a_light_sphere_rises_as_half_the_displaced_water_lets_it() {
    let model = body();
    let (displaced, gravity) = (8.0, 10.0);
    // Both act at the centre of mass, about which the sphere is round.
    let text = format!(
        "[gravity]\nacceleration = [0, 0, -{gravity}]\n[wrench]\nforce = [0, 0, {}]\naxes = 'world'\npoint = [0.1, 0.05, -0.1]\n\
         [added_mass]\nlink = 'body'\ninertia = [0, 0, 0, {m}, {m}, {m}]\npoint = [0.1, 0.05, -0.1]\n",
        displaced * gravity,
        m = 0.5 * displaced
    );
    assert_eq!(scene(&model, &text).case(), Case::Driven);
    let acceleration = (displaced - 2.0) * gravity / (2.0 + 0.5 * displaced);
    for sample in &flown(&model, &text).samples {
        let risen = sample.com.z - -0.1;
        assert!((risen - 0.5 * acceleration * sample.time.powi(2)).abs() < ACCUMULATED, "{}: {risen}", sample.time);
    }
}

/// In a frame that moves with the water, the water is still.
#[test]
fn a_current_carries_the_motion_of_still_water() {
    let (model, current) = (satellite(), Vector3::new(0.5, -0.3, 0.2));
    let still = flown(&model, &format!("{SWING}{WATER}"));
    let rotation = Pose::from_rpy(Vector3::zeros(), [0.3, -0.2, 0.5]).rotation;
    let [x, y, z]: [f64; 3] = (Vector3::new(0.4, -0.2, 0.1) + rotation.transpose() * current).into();
    let carried = SWING.replace("0.4, -0.2, 0.1]", &format!("{x}, {y}, {z}]"));
    let moving = WATER.replace("\ninertia", "\ncurrent = [0.5, -0.3, 0.2]\ninertia");
    assert!(carried != SWING && moving != WATER);
    let carried = flown(&model, &format!("{carried}{moving}"));
    for (one, other) in carried.samples.iter().zip(&still.samples) {
        let way = one.pose.translation - other.pose.translation - current * one.time;
        let turned = (one.pose.rotation - other.pose.rotation).amax();
        let apart = one.q.iter().zip(&other.q).fold(turned.max(way.amax()), |most, (a, b)| most.max((a - b).abs()));
        assert!(apart < ACCUMULATED, "{}: {apart:e}", one.time);
    }
}

/// Wrenches of 0 are added: what is driven anyhow does not change by a bit.
#[test]
fn added_mass_of_size_zero_changes_no_bit() {
    let model = satellite();
    let nothing = "[added_mass]\nlink = 'link_3'\ninertia = [0, 0, 0, 0, 0, 0]\n";
    for rest in [
        "[gravity]\nacceleration = [0, 0, -9.81]\n[wrench]\nforce = [1, 2, 3]\n",
        "[drag]\nlink = 'link_5'\ntranslational = [1, 2, 3]\n[rotors]\ninertia = 0.1\n[prescribed]\njoint = 'joint_2'\nhold = 0.5\n",
        "[solver]\nequations = 'hamel'\n[spring]\nstiffness = 1\n",
        "[solver]\nequations = 'integrated'\nroute = 'articulated'\n[spring]\nstiffness = 1\n",
    ] {
        let [without, mut with] = ["", nothing].map(|water| flown(&model, &format!("{SWING}{rest}{water}")));
        assert_eq!((with.steps, with.samples.len()), (without.steps, without.samples.len()));
        for (sample, other) in with.samples.iter_mut().zip(&without.samples) {
            assert_eq!(sample.works.pop(), Some(0.0));
            assert_eq!(sample, other, "{rest}");
        }
    }
}

/// Two halves are a whole.
#[test]
fn added_masses_of_one_link_add_up() {
    let model = satellite();
    let once = "[[added_mass]]\nlink = 'link_3'\ninertia = [0.1, 0.2, 0.3, 1, 2, 3]\n";
    let half = "[[added_mass]]\nlink = 'link_3'\ninertia = [0.05, 0.1, 0.15, 0.5, 1, 1.5]\n";
    let [whole, halves] = [once.to_owned(), half.repeat(2)].map(|water| flown(&model, &format!("{SWING}{water}")));
    for (one, other) in whole.samples.iter().zip(&halves.samples) {
        let apart = one.q.iter().zip(&other.q).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(apart < ACCUMULATED, "{}: {apart:e}", one.time);
    }
}

/// Joints on a course move as it says; what they take beyond what the water does is the work of their drives.
#[test]
fn a_joint_on_a_course_takes_what_the_water_asks() {
    let model = satellite();
    let course = "[[prescribed]]\njoint = 'joint_2'\nsinusoid = { offset = 0.5, amplitude = 0.4, rate = 5 }\n\
                  [[prescribed]]\njoint = 'joint_6'\ntimes = [0.1, 0.6]\nvalues = [0, 1]\n[rotors]\ninertia = 0.05\n";
    let start = "[start]\nbase_twist = [0.3, 0.2, 0.1, 0.4, -0.2, 0.1]\n";
    let text = format!("{start}{course}{WATER}");
    let added = added(&model, &text);
    let [with, without] = [text, format!("{start}{course}")].map(|text| flown(&model, &text));
    let energy = water(&model, &added, &with.samples[0]).0;
    let mut drives = 0.0_f64;
    for sample in &with.samples {
        assert!((sample.q[1] - 0.5 - 0.4 * (5.0 * sample.time).sin()).abs() < ROUNDING);
        let (gained, work) = (sample.kinetic_energy - with.samples[0].kinetic_energy, sample.work());
        assert!((gained - work).abs() < 10.0 * ACCUMULATED, "{}: {gained} {work}", sample.time);
        let [one, other, by_water] = sample.works[..] else { panic!("{:?}", sample.works) };
        let lost = energy - water(&model, &added, sample).0;
        assert!((by_water - lost).abs() < 10.0 * ACCUMULATED, "{}: {by_water} {lost}", sample.time);
        drives = drives.max(one.abs()).max(other.abs());
    }
    let more = |i: usize| (with.samples[i].tau[1] - without.samples[i].tau[1]).abs();
    assert!(drives > 0.1 && more(50) > 0.1, "{drives} {}", more(50));
}

/// The robot's own momentum is zero at the start and does not stay so.
#[test]
fn water_drives_the_momentum() {
    let model = satellite();
    let text = "[start]\nqd = { joint_2 = 1 }\n[added_mass]\nlink = 'link_7'\ninertia = [0, 0, 0, 5, 5, 5]\n";
    let scene = scene(&model, text);
    assert_eq!((scene.case(), scene.start.mu), (Case::Driven, Twist::zero()));
    let record = flown(&model, text);
    let last = record.samples.last().unwrap();
    assert!(last.momentum.force.norm() > 0.05, "{:?}", last.momentum);
}

/// μ̂ follows μ though the water takes momentum: F₁ tells of it.
#[test]
fn an_observer_is_told_what_the_water_does() {
    let model = satellite();
    let record = flown(&model, &format!("{SWING}[observer]\ngain = 10\n{WATER}"));
    let energy = |sample: &Sample| sample.observation.as_ref().unwrap().lyapunov;
    let fallen = energy(record.samples.last().unwrap()) / energy(&record.samples[0]);
    // e^(−2 k t), but for what the turning inertia adds.
    assert!(fallen < 1e-7, "{fallen:e}");
}

/// The wrenches of heavy water are large and nearly cancel what else there is: so many digits are lost. 31 digits tell.
#[test]
fn heavy_water_costs_as_many_digits_as_it_exceeds_the_robot() {
    let model = satellite();
    let wide: Model<DoubleDouble> = model.cast().orthonormalised();
    for heavier in [1e-3_f64, 1.0, 1e3, 1e6] {
        let inertia = [0.1, 0.2, 0.3, 4.0, 5.0, 6.0].map(|x| x * heavier);
        let text = format!("{SWING}[added_mass]\nlink = 'base'\ninertia = {inertia:?}\n[spring]\nstiffness = 1\n");
        let scene = scene(&model, &text);
        let mut core = equations::<f64>(&scene, &model, 0.0);
        let state = core.start(&scene.start);
        let mut rate = Tangent::zero(state.flat.len());
        core.rate(0.0, &state, &mut rate);
        let mut exact = equations::<DoubleDouble>(&scene, &wide, 0.0);
        let number = DoubleDouble::from;
        let pose = Pose::new(state.pose.rotation.map(number), state.pose.translation.map(number)).orthonormalised();
        let wide_state = State { pose, flat: state.flat.iter().map(|x| number(*x)).collect() };
        let mut wide_rate = Tangent::zero(state.flat.len());
        exact.rate(number(0.0), &wide_state, &mut wide_rate);
        let expected: Vec<f64> = wide_rate.flat.iter().map(|x| x.high()).collect();
        let size = expected.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let error = rate.flat.iter().zip(&expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / size;
        assert!(error < 1e-13 * heavier.max(1.0), "{heavier:e}: {error:e}");
    }
}
