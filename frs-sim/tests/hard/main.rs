//! Motions at which naive methods fail, each judged by what is known of it in closed form or with 31 digits (docs/hard.md).

mod falling;
mod gaits;
mod spinning;
mod stiff;
mod stress;

use std::ops::ControlFlow;

use frs_core::Model;
use frs_sim::run::{End, Record, run};
use frs_sim::scene::Scene;

/// A robot of the project.
fn robot(name: &str) -> Model {
    let path = format!("{}/../robots/{name}.urdf", env!("CARGO_MANIFEST_DIR"));
    Model::from_urdf(&std::fs::read_to_string(path).expect("the file is there")).expect("the robot is well formed")
}

#[track_caller]
fn scene(text: &str, model: &Model) -> Scene {
    Scene::parse("scene.toml", text, model).unwrap_or_else(|error| panic!("{error}"))
}

/// The whole motion.
#[track_caller]
fn whole(text: &str, model: &Model) -> Record {
    let record = run(&scene(text, model), model, |_| ControlFlow::Continue(()));
    assert_eq!(record.end, End::Whole, "{text}");
    record
}
