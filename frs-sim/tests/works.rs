//! The work of each force by itself, and that measuring it changes nothing.

use std::ops::ControlFlow;

use frs_core::{Model, Workspace, urdf};
use frs_sim::integrate::{Adaptive, DOP853};
use frs_sim::motion::{Conserved, Motion};
use frs_sim::run::{End, Record, run};
use frs_sim::scene::Scene;
use nalgebra::Vector3;

/// Errors of steps at the accuracy of these scenes add up over a second; forces of some newtons make joules of it.
const ACCUMULATED: f64 = 1e-8;

const HEAD: &str = "robot = 'x.urdf'\nduration = 1\naccuracy = 1e-11\n\
                    [start]\nq = { joint_2 = 0.5, joint_4 = 1 }\nmomentum = [0.3, 0.2, 0.1, 0.4, -0.2, 0.1]\n";

const SPRINGS: &str = "[[spring]]\nstiffness = 3\n[[spring]]\nstiffness = { joint_3 = 2 }\nrest = { joint_3 = 0.4 }\n";
const FRICTION: &str = "[friction]\nviscous = 0.1\ncoulomb = 0.02\n";
const GRAVITY: &str = "[gravity]\nacceleration = [0, 2, -9]\n";
const WRENCH: &str = "[wrench]\nlink = 'link_6'\npoint = [0.1, 0.2, 0.3]\nforce = [3, -1, 2]\naxes = 'world'\n";
const SWUNG: &str = "[prescribed]\njoint = 'joint_3'\nsinusoid = { amplitude = 0.3, rate = 4 }\n";

fn satellite() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

fn scene(text: &str) -> Scene {
    Scene::parse("scene.toml", &format!("{HEAD}{text}"), &satellite()).unwrap_or_else(|error| panic!("{error}"))
}

fn flown(scene: &Scene) -> Record {
    let record = run(scene, &satellite(), |_| ControlFlow::Continue(()));
    assert_eq!(record.end, End::Whole);
    record
}

fn names(scene: &Scene) -> Vec<String> {
    scene.works().into_iter().map(|work| work.name).collect()
}

/// What conservative forces did is what their potential lost, and what is left over of the energy is friction's.
#[test]
fn each_force_does_the_work_that_its_potential_loses() {
    let model = satellite();
    let mut work = Workspace::new(&model);
    for (driven, text) in [("", ""), ("wrench", WRENCH)] {
        let scene = scene(&format!("{SPRINGS}{FRICTION}{GRAVITY}{text}"));
        let names = names(&scene);
        let joints = ["viscous_friction", "coulomb_friction", "spring_1", "spring_2"];
        let expected: Vec<&str> =
            ["gravity", driven].into_iter().filter(|name| !name.is_empty()).chain(joints).collect();
        assert_eq!(names, expected);
        let record = flown(&scene);
        let mut potentials = Vec::new();
        for sample in &record.samples {
            let pose = work.shape(&sample.q).link_pose(model.link("link_6").unwrap());
            let point = sample.pose.transform(pose.transform(Vector3::new(0.1, 0.2, 0.3)));
            potentials.push([
                ("gravity", -scene.start.mass * Vector3::new(0.0, 2.0, -9.0).dot(&sample.com)),
                ("wrench", -Vector3::new(3.0, -1.0, 2.0).dot(&point)),
                ("spring_1", 1.5 * sample.q.iter().map(|q| q * q).sum::<f64>()),
                ("spring_2", (sample.q[2] - 0.4).powi(2)),
            ]);
        }
        let mut moved = [0.0_f64; 4];
        for (sample, potential) in record.samples.iter().zip(&potentials) {
            let of = |name: &str| names.iter().position(|other| other == name).map(|i| sample.works[i]);
            for (i, (name, value)) in potential.iter().enumerate() {
                let Some(work) = of(name) else { continue };
                let lost = potentials[0][i].1 - value;
                assert!((work - lost).abs() < ACCUMULATED, "{name} at {}: {work} {lost}", sample.time);
                moved[i] = moved[i].max(work.abs());
            }
            let gained = sample.kinetic_energy - record.samples[0].kinetic_energy;
            assert!((gained - sample.work()).abs() < ACCUMULATED, "{}", sample.time);
        }
        assert!(moved.iter().enumerate().all(|(i, moved)| *moved > 0.01 || (i == 1 && driven.is_empty())), "{moved:?}");
        for pair in record.samples.windows(2) {
            let lost = ["viscous_friction", "coulomb_friction"].map(|name| {
                let i = names.iter().position(|other| other == name).unwrap();
                pair[1].works[i] < pair[0].works[i]
            });
            assert_eq!(lost, [true; 2], "{}", pair[0].time);
        }
    }
}

/// A joint on a course feels the springs, too; its drive does what they do not.
#[test]
fn a_drive_does_the_work_that_effects_do_not() {
    let [with, without] = [format!("{SWUNG}{SPRINGS}"), SWUNG.to_owned()].map(|text| {
        let scene = scene(&text);
        (flown(&scene), names(&scene))
    });
    assert_eq!(
        (with.1.as_slice(), without.1.as_slice()),
        (&["spring_1", "spring_2", "prescribed"].map(str::to_owned)[..], &["prescribed".to_owned()][..])
    );
    for sample in &with.0.samples {
        let springs = 1.5 * 1.25 - 1.5 * sample.q.iter().map(|q| q * q).sum::<f64>();
        assert!((sample.works[0] - springs).abs() < ACCUMULATED);
        let gained = sample.kinetic_energy - with.0.samples[0].kinetic_energy;
        assert!((sample.works[2] - (gained - sample.works[0] - sample.works[1])).abs() < ACCUMULATED);
    }
    let most = |record: &Record, i: usize| record.samples.iter().map(|s| s.works[i].abs()).fold(0.0, f64::max);
    assert!(most(&with.0, 2) > 0.01 && most(&without.0, 0) > 0.01);
}

/// The same steps and the same states as without a meter, to the last bit.
#[test]
fn measuring_work_changes_no_bit_of_a_motion() {
    let (model, scene) = (satellite(), scene(&format!("{SPRINGS}{FRICTION}")));
    let record = flown(&scene);
    let start = &scene.start;
    let mut motion =
        Motion::new(&model, Conserved { momentum: start.centroidal }, scene.effects(&model)).by(scene.solver.route);
    let state = motion.state(start.pose, &start.q, &start.qd, start.mu);
    let mut path = Adaptive::new(&DOP853, state, 0.0, scene.solver.accuracy());
    let mut steps = 0;
    while path.time() < scene.duration {
        path.advance(&mut motion, scene.duration).unwrap();
        steps += 1;
    }
    let state = &record.checkpoint.state;
    let n = path.state().flat.len();
    assert_eq!((record.steps, &state.pose, &state.flat[..n]), (steps, &path.state().pose, &path.state().flat[..]));
    assert!(state.flat[n..].iter().filter(|work| work.abs() > 0.01).count() > 2, "and work was measured");
}
