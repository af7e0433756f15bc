//! `checkpoint.json`: where a run goes on.
//!
//! It holds the texts of the scene and the robot, for which alone it is good, and numbers that read back bit for bit.

use std::path::Path;

use frs::Model;
use frs::nalgebra::{Matrix3, Vector3};
use frs::spatial::{Pose, Wrench};
use frs_sim::integrate::{Pace, State};
use frs_sim::run::{Checkpoint, End, FreeFall, Record};
use serde_json::{Value, json};

use super::trajectory;
use crate::cli::scene::Loaded;
use crate::cli::{Failure, read};

pub const FILE: &str = "checkpoint.json";

/// The file's text.
pub fn text(loaded: &Loaded, record: &Record) -> String {
    let Checkpoint { time, state, pace, closed, phase, fall } = &record.checkpoint;
    let numbers = [*time, pace.next, pace.error, fall.since, fall.mass, fall.work]
        .into_iter()
        .chain(fall.com.iter().copied())
        .chain(fall.momentum.to_array())
        .chain(state.pose.rotation.iter().copied())
        .chain(state.pose.translation.iter().copied())
        .chain(state.flat.iter().copied());
    let object = json!({
        "scene": loaded.scene_text,
        "robot": loaded.robot_text,
        "numbers": numbers.map(|number| number.to_string()).collect::<Vec<_>>().join(" "),
        "smooth": pace.smooth,
        "closed": closed,
        "phase": phase,
        "steps": record.steps,
        "evaluations": pace.evaluations,
    });
    format!("{object}\n")
}

/// The record of a run that was stopped, from its folder.
pub fn load(folder: &Path, loaded: &Loaded) -> Result<Record, Failure> {
    let path = folder.join(FILE);
    let file = path.display();
    if !path.exists() {
        return Err(Failure::Input(format!(
            "{file}: there is nothing to resume; expected what a run leaves that was stopped; run without --resume"
        )));
    }
    let broken = |what: &str| Failure::Input(format!("{file}: {what}; run without --resume"));
    let object: Value = serde_json::from_str(&read(&path)?).map_err(|error| broken(&error.to_string()))?;
    if object["scene"] != loaded.scene_text || object["robot"] != loaded.robot_text {
        return Err(broken("the scene or its robot has changed since; expected the same files"));
    }
    let mut record = parsed(&object, &loaded.model).ok_or_else(|| broken("it is not complete"))?;
    let table = folder.join("trajectory.csv");
    let samples = trajectory::samples(&loaded.model, &read(&table)?);
    record.samples = samples
        .ok_or_else(|| Failure::Input(format!("{}: it is not complete; run without --resume", table.display())))?;
    // The table may have been written once more than the checkpoint.
    record.samples.retain(|sample| sample.time <= record.checkpoint.time);
    Ok(record)
}

fn parsed(object: &Value, model: &Model) -> Option<Record> {
    let numbers = object["numbers"].as_str()?.split(' ').map(str::parse).collect::<Result<Vec<f64>, _>>().ok()?;
    let (&[time, next, error, since, mass, work], rest) = numbers.split_first_chunk()?;
    let (com, rest) = rest.split_first_chunk::<3>()?;
    let (momentum, rest) = rest.split_first_chunk::<6>()?;
    let (rotation, rest) = rest.split_first_chunk::<9>()?;
    let (translation, flat) = rest.split_first_chunk::<3>()?;
    let count = |key: &str| object[key].as_u64().and_then(|count| usize::try_from(count).ok());
    let fall = FreeFall { since, com: Vector3::from(*com), momentum: Wrench::from_array(*momentum), mass, work };
    let pose = Pose::new(Matrix3::from_column_slice(rotation), Vector3::from(*translation));
    let closed = object["closed"].as_array()?.iter().map(Value::as_bool).collect::<Option<Vec<bool>>>()?;
    let pace = Pace { next, error, smooth: object["smooth"].as_bool()?, evaluations: count("evaluations")? };
    let state = State { pose, flat: flat.to_vec() };
    let checkpoint = Checkpoint { time, state, pace, closed, phase: count("phase")?, fall };
    // q, q̇ and the work; μ, too, if it is integrated.
    let numbers = 2 * model.dof() + 1;
    let complete = flat.len() == numbers || flat.len() == numbers + 6;
    complete.then_some(Record { samples: Vec::new(), end: End::Stopped, steps: count("steps")?, checkpoint })
}
