//! A scene file and its robot.

use std::cell::RefCell;
use std::path::Path;

use frs::Model;
use frs::urdf::Options;
use frs_sim::scene::Scene;

use super::{Failure, read};

/// A scene and its robot, and the texts of both and of the files that the scene names besides.
pub struct Loaded {
    pub scene: Scene,
    pub model: Model,
    pub scene_text: String,
    pub robot_text: String,
    pub file_texts: Vec<String>,
}

/// Reads a scene and the robot that it names; the robot's path is relative to the scene's folder.
pub fn load(path: &Path) -> Result<Loaded, Failure> {
    let (file, text) = (path.display().to_string(), read(path)?);
    let told = |error: frs_sim::scene::SceneError| Failure::Input(error.to_string());
    let (robot, place) = Scene::robot(&file, &text).map_err(told)?;
    let robot = path.with_file_name(robot);
    let urdf = std::fs::read_to_string(&robot).map_err(|error| {
        let (line, column, robot) = (place.line, place.column, robot.display());
        Failure::Input(format!(
            "{file}:{line}:{column}: robot: {robot} cannot be read: {error}; expected the path of a URDF, from the scene's folder"
        ))
    })?;
    let options = Options { file: &robot.display().to_string(), root: None, lenient: false };
    let model = Model::from_urdf_with(&urdf, &options).map_err(|error| Failure::Input(error.to_string()))?;
    for warning in model.warnings() {
        eprintln!("warning: {warning}");
    }
    let texts = RefCell::new(Vec::new());
    let files = |name: &str| {
        let text = std::fs::read_to_string(path.with_file_name(name))?;
        texts.borrow_mut().push(text.clone());
        Ok(text)
    };
    let scene = Scene::parse_with(&file, &text, &model, &files).map_err(told)?;
    Ok(Loaded { scene, model, scene_text: text, robot_text: urdf, file_texts: texts.into_inner() })
}
