//! A body that nothing holds flies as the same body does in a scene, and back to where it came from.

use std::ops::ControlFlow;

use frs_core::Model;
use frs_core::model::Inertial;
use frs_core::spatial::{Pose, Symmetric3, Twist};
use frs_sim::motion::free_flight;
use frs_sim::run::run;
use frs_sim::scene::Scene;
use nalgebra::Vector3;

/// Errors of steps add up over two seconds.
const ACCUMULATED: f64 = 1e-8;

const BODY: Inertial = Inertial {
    mass: 2.0,
    com: Vector3::new(0.1, 0.05, -0.1),
    inertia: Symmetric3 { xx: 0.1, xy: 0.0, xz: 0.02, yy: 0.2, yz: 0.0, zz: 0.25 },
};

const TWIST: [f64; 6] = [2.0, 1.0, -1.5, 1.0, -2.0, 0.5];

fn apart(one: &Pose<f64>, other: &Pose<f64>) -> f64 {
    (one.rotation - other.rotation).amax().max((one.translation - other.translation).amax())
}

#[test]
fn a_free_body_flies_as_in_a_scene() {
    let urdf = "<robot name='body'><link name='body'><inertial><origin xyz='0.1 0.05 -0.1'/><mass value='2'/>\
                <inertia ixx='0.1' iyy='0.2' izz='0.25' ixy='0' ixz='0.02' iyz='0'/></inertial></link></robot>";
    let model = Model::from_urdf(urdf).unwrap();
    let text = format!(
        "robot = 'x'\nduration = 2\naccuracy = 1e-11\n[start]\npose = {{ position = [1, 2, 3], rpy = [0.3, -0.2, 0.5] }}\n\
         base_twist = {TWIST:?}\n[gravity]\nacceleration = [0, 1, -9]\n"
    );
    let scene = Scene::parse("scene.toml", &text, &model).unwrap();
    let record = run(&scene, &model, |_| ControlFlow::Continue(()));
    let times: Vec<f64> = record.samples.iter().map(|sample| sample.time).collect();
    let twist = Twist::from_array(TWIST);
    let flight = free_flight(&BODY, &scene.start.pose, twist, scene.gravity(), times).unwrap();
    assert!(flight.len() == 201 && apart(&flight[0], &flight[200]) > 1.0);
    for (pose, sample) in flight.iter().zip(&record.samples) {
        assert!(apart(pose, &sample.pose) < ACCUMULATED, "{}", sample.time);
    }
    // Back from the end it comes by the same places.
    let (last, times) = (record.samples.last().unwrap(), (0..=200).map(|i| -0.01 * f64::from(i)));
    let velocity = model_twist(&model, last.mu);
    let back = free_flight(&BODY, &last.pose, velocity, scene.gravity(), times).unwrap();
    for (pose, sample) in back.iter().zip(record.samples.iter().rev()) {
        assert!(apart(pose, &sample.pose) < ACCUMULATED, "{}", sample.time);
    }
}

/// The twist of a robot of one body is μ.
fn model_twist(model: &Model, mu: Twist<f64>) -> Twist<f64> {
    assert_eq!(model.dof(), 0);
    mu
}

/// A point does not turn, and flies straight.
#[test]
fn a_point_flies_straight() {
    let point =
        Inertial { mass: 1.0, com: Vector3::new(0.0, 0.0, 0.5), inertia: Symmetric3::diagonal(Vector3::zeros()) };
    let twist = Twist::from_array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    let pose = free_flight(&point, &Pose::identity(), twist, Vector3::zeros(), [2.0]).unwrap()[0];
    assert_eq!(pose, Pose::new(Pose::identity().rotation, Vector3::new(2.0, 0.0, 0.0)));
}
