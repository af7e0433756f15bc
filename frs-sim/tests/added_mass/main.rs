//! Added mass, judged by Kirchhoff's invariants, by Lagrange's equations of the whole, and by motions that are known otherwise.

mod grasp;
mod known;
mod lagrange;

use std::ops::ControlFlow;

use frs_core::spatial::{Twist, Wrench};
use frs_core::{Model, Real, Workspace, urdf};
use frs_sim::effects::AddedMass;
use frs_sim::run::{End, Record, Sample, run};
use frs_sim::scene::{Force, Scene};

/// Errors of steps at the accuracy of these scenes add up over a second.
const ACCUMULATED: f64 = 1e-9;

/// Rounding of one evaluation, relative.
const ROUNDING: f64 = 1e-12;

const HEAD: &str = "robot = 'x.urdf'\nduration = 1\naccuracy = 1e-11\n";

const SWING: &str = "[start]\npose = { position = [1, 2, 3], rpy = [0.3, -0.2, 0.5] }\nq = { joint_2 = 0.5, joint_4 = 1 }\n\
                     qd = { joint_3 = 1, joint_5 = -0.5 }\nbase_twist = [0.3, 0.2, 0.1, 0.4, -0.2, 0.1]\n";

/// On three links: diagonal, about a point, and full.
const WATER: &str = "[[added_mass]]\nlink = 'base'\ninertia = [0.1, 0.2, 0.3, 4, 5, 6]\n\
                     [[added_mass]]\nlink = 'link_3'\ninertia = [0.01, 0.02, 0.03, 1, 2, 3]\npoint = [0.1, -0.2, 0.15]\n\
                     [[added_mass]]\nlink = 'link_7'\ninertia = [[0.3, 0.1, 0, 0.2, 0, 0.1], [0.1, 0.4, 0.1, 0, 0.1, 0], \
                     [0, 0.1, 0.2, 0, 0, 0.1], [0.2, 0, 0, 2, 0.3, 0.1], [0, 0.1, 0, 0.3, 3, 0.2], [0.1, 0, 0.1, 0.1, 0.2, 1]]\n";

fn satellite() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

/// One body of 2 kg, its centre of mass off the origin of its frame.
fn body() -> Model {
    let inertia = "<origin xyz='0.1 0.05 -0.1'/><mass value='2'/><inertia ixx='0.1' iyy='0.2' izz='0.25' ixy='0' ixz='0.02' iyz='0'/>";
    Model::from_urdf(&format!("<robot name='body'><link name='body'><inertial>{inertia}</inertial></link></robot>"))
        .unwrap()
}

const AROUND_BODY: &str =
    "[added_mass]\nlink = 'body'\ninertia = [0.05, 0.1, 0.02, 1, 3, 5]\npoint = [-0.1, 0.2, 0.1]\n";

fn scene(model: &Model, text: &str) -> Scene {
    Scene::parse("scene.toml", &format!("{HEAD}{text}"), model).unwrap_or_else(|error| panic!("{error}"))
}

fn flown(model: &Model, text: &str) -> Record {
    let record = run(&scene(model, text), model, |_| ControlFlow::Continue(()));
    assert_eq!(record.end, End::Whole, "{text}");
    record
}

fn added(model: &Model, text: &str) -> Vec<AddedMass> {
    let force = scene(model, text).forces.pop().unwrap().force;
    let Force::AddedMass(added, _) = force else { panic!("{text}") };
    added
}

/// `M_A V`, by its rows.
fn momentum<T: Real>(added: &AddedMass, twist: Twist<T>) -> Wrench<T> {
    let twist = twist.to_array();
    Wrench::from_array(
        added.inertia.map(|row| row.into_iter().zip(twist).fold(T::zero(), |sum, (m, v)| sum + T::from_f64(m) * v)),
    )
}

/// Energy of the water (J) and its momentum about the world's origin.
fn water(model: &Model, added: &[AddedMass], sample: &Sample) -> (f64, Wrench<f64>) {
    let mut work = Workspace::new(model);
    let mut shape = work.shape(&sample.q);
    let robot = shape.moving(&sample.qd);
    added.iter().fold((0.0, Wrench::zero()), |(energy, sum), added| {
        let twist = robot.link_twist(added.link, sample.mu);
        let momentum = momentum(added, twist);
        let place = sample.pose * robot.link_pose(added.link);
        (energy + 0.5 * twist.dot(momentum), sum + place.act_wrench(momentum))
    })
}

/// In still water nothing changes the energy nor the momentum of robot and water, if nothing else acts: Kirchhoff's equations for one body,
/// the same for a robot whose arm swings.
#[test]
fn energy_and_momentum_of_robot_and_water_are_constant() {
    let turning =
        "[start]\npose = { position = [1, 2, 3], rpy = [0.3, -0.2, 0.5] }\nbase_twist = [2, 1, -1.5, 1, -2, 0.5]\n";
    for (model, text) in [(body(), format!("{turning}{AROUND_BODY}")), (satellite(), format!("{SWING}{WATER}"))] {
        let added = added(&model, &text);
        let record = flown(&model, &text);
        let whole = |sample: &Sample| {
            let (energy, momentum) = water(&model, &added, sample);
            (sample.kinetic_energy + energy, sample.momentum + momentum)
        };
        let (energy, momentum) = whole(&record.samples[0]);
        for sample in &record.samples {
            let now = whole(sample);
            assert!((now.0 / energy - 1.0).abs() < ACCUMULATED, "{}: {} {energy}", sample.time, now.0);
            let drift = (now.1 - momentum).to_array();
            assert!(drift.iter().all(|drift| drift.abs() < 10.0 * ACCUMULATED), "{}: {drift:?}", sample.time);
        }
        let last = record.samples.last().unwrap();
        let exchanged = (last.momentum - record.samples[0].momentum).to_array();
        assert!(exchanged.iter().all(|change| change.abs() > 0.01), "the robot's own changes: {exchanged:?}");
    }
}

/// The water's work is what its energy lost.
#[test]
fn the_work_of_the_water_is_its_energy() {
    let model = satellite();
    let text = format!("{SWING}[spring]\nstiffness = 2\n[rotors]\ninertia = 0.1\n{WATER}");
    let added = added(&model, &text);
    let names: Vec<String> = scene(&model, &text).works().into_iter().map(|work| work.name).collect();
    assert_eq!(names, ["spring", "added_mass"]);
    let record = flown(&model, &text);
    let start = water(&model, &added, &record.samples[0]).0;
    let mut most = 0.0_f64;
    for sample in &record.samples {
        let gained = water(&model, &added, sample).0 - start;
        assert!((sample.works[1] + gained).abs() < 10.0 * ACCUMULATED, "{}: {} {gained}", sample.time, sample.works[1]);
        let balance = sample.kinetic_energy - record.samples[0].kinetic_energy - sample.work();
        assert!(balance.abs() < 10.0 * ACCUMULATED, "{}: {balance:e}", sample.time);
        most = most.max(gained.abs());
    }
    assert!(most > 0.05, "{most}");
}
