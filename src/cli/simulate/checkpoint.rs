//! `checkpoint.json`: where a run goes on.
//!
//! It holds the texts of the scene, the robot and the files that the scene names, for which alone it is good, and numbers that read back bit for bit.

use std::path::Path;

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
    let Checkpoint { time, state, pace, closed, phase, fall, observer } = &record.checkpoint;
    let numbers = [*time, pace.next, pace.error, fall.since, fall.mass]
        .into_iter()
        .chain(fall.com.iter().copied())
        .chain(fall.momentum.to_array())
        .chain(numbers_of(state));
    let observer = observer.as_ref().map(|(state, pace)| {
        text_of([pace.next, pace.error, pace.evaluations as f64].into_iter().chain(numbers_of(state)))
    });
    let object = json!({
        "scene": loaded.scene_text,
        "robot": loaded.robot_text,
        "files": loaded.file_texts,
        "numbers": text_of(numbers),
        "observer": observer,
        "smooth": pace.smooth,
        "closed": closed,
        "phase": phase,
        "steps": record.steps,
        "evaluations": pace.evaluations,
    });
    format!("{object}\n")
}

fn text_of(numbers: impl Iterator<Item = f64>) -> String {
    numbers.map(|number| number.to_string()).collect::<Vec<_>>().join(" ")
}

fn numbers_in(text: &Value) -> Option<Vec<f64>> {
    text.as_str()?.split(' ').map(str::parse).collect::<Result<_, _>>().ok()
}

fn numbers_of(state: &State) -> impl Iterator<Item = f64> {
    let Pose { rotation, translation } = &state.pose;
    rotation.iter().chain(translation).chain(&state.flat).copied()
}

fn state_of(numbers: &[f64]) -> Option<State> {
    let (rotation, rest) = numbers.split_first_chunk::<9>()?;
    let (translation, flat) = rest.split_first_chunk::<3>()?;
    let pose = Pose::new(Matrix3::from_column_slice(rotation), Vector3::from(*translation));
    Some(State { pose, flat: flat.to_vec() })
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
    let same =
        [("scene", json!(loaded.scene_text)), ("robot", json!(loaded.robot_text)), ("files", json!(loaded.file_texts))];
    if same.iter().any(|(key, text)| object[key] != *text) {
        return Err(broken("the scene or its robot has changed since; expected the same files"));
    }
    let mut record = parsed(&object, loaded).ok_or_else(|| broken("it is not complete"))?;
    let table = folder.join("trajectory.csv");
    let samples = trajectory::samples(&loaded.scene, &loaded.model, &read(&table)?);
    record.samples = samples
        .ok_or_else(|| Failure::Input(format!("{}: it is not complete; run without --resume", table.display())))?;
    // The table may have been written once more than the checkpoint.
    record.samples.retain(|sample| sample.time <= record.checkpoint.time);
    Ok(record)
}

fn parsed(object: &Value, Loaded { scene, model, .. }: &Loaded) -> Option<Record> {
    let numbers = numbers_in(&object["numbers"])?;
    let (&[time, next, error, since, mass], rest) = numbers.split_first_chunk()?;
    let (com, rest) = rest.split_first_chunk::<3>()?;
    let (momentum, rest) = rest.split_first_chunk::<6>()?;
    let state = state_of(rest)?;
    let count = |key: &str| object[key].as_u64().and_then(|count| usize::try_from(count).ok());
    let fall = FreeFall { since, com: Vector3::from(*com), momentum: Wrench::from_array(*momentum), mass };
    let closed = object["closed"].as_array()?.iter().map(Value::as_bool).collect::<Option<Vec<bool>>>()?;
    let pace = Pace { next, error, smooth: object["smooth"].as_bool()?, evaluations: count("evaluations")? };
    let observer = match scene.observer {
        None => None,
        Some(_) => {
            let numbers = numbers_in(&object["observer"])?;
            let (&[next, error, evaluations], rest) = numbers.split_first_chunk()?;
            let pace = Pace { next, error, smooth: false, evaluations: evaluations as usize };
            Some((state_of(rest)?, pace))
        }
    };
    // q, q̇, μ where it is integrated, and the work of each force and of payloads.
    let numbers = 2 * model.dof() + scene.case().numbers() + scene.forces.len() + 1;
    let complete = state.flat.len() == numbers;
    let checkpoint = Checkpoint { time, state, pace, closed, phase: count("phase")?, fall, observer };
    complete.then_some(Record { samples: Vec::new(), end: End::Stopped, steps: count("steps")?, checkpoint })
}
