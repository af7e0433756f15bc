//! Robots from URDF text.
//!
//! Reading never stops at the first problem: what is wrong with the text and what is wrong with the robot it describes
//! is told at once, in the order of the text, each with its line and column. Only links and joints are read; visuals,
//! collisions, transmissions, materials and elements of other tools are passed over.

mod error;
mod read;
mod source;
mod values;
mod xml;

pub use error::UrdfError;

use crate::Model;
use crate::model::{Problem, RobotDescription, Severity};
use read::Reading;
use source::Source;

/// The default robot: a light satellite that carries a KUKA LWR arm with seven joints.
pub const LWR_SATELLITE: &str = include_str!("../../../robots/lwr_satellite.urdf");

/// How to read a URDF.
///
/// ```
/// use frs_core::Model;
/// use frs_core::urdf::{LWR_SATELLITE, Options};
/// let by_the_hand = Options { root: Some("link_7"), ..Options::default() };
/// let model = Model::from_urdf_with(LWR_SATELLITE, &by_the_hand)?;
/// assert_eq!(model.links()[0].name, "link_7");
/// # Ok::<(), frs_core::urdf::UrdfError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Options<'a> {
    /// Name of the file, for messages; its stem names a robot that has no name.
    pub file: &'a str,
    /// The link to take as base; by default the one link that is nobody's child.
    pub root: Option<&'a str>,
    /// Whether a rotational inertia that violates the triangle inequality is a warning instead of an error.
    pub lenient: bool,
}

impl Default for Options<'_> {
    /// A text without a file, its own root, strict.
    fn default() -> Self {
        Self { file: "robot.urdf", root: None, lenient: false }
    }
}

/// Reads a URDF as a description, to be changed before it is built.
///
/// # Errors
/// All that keeps the text from being read, at once. What is wrong with the robot is told by
/// [`RobotDescription::build`], without places; [`Model::from_urdf`] tells both, with places.
pub fn parse(text: &str, options: &Options<'_>) -> Result<RobotDescription, UrdfError> {
    let source = Source::new(text, options.file);
    let document = xml::parse(&source)?;
    let reading = read::read(&document, options);
    match reading.robot {
        Some(robot) if reading.findings.is_empty() => Ok(robot),
        _ => Err(UrdfError::new(source.settle(reading.findings))),
    }
}

impl Model {
    /// The robot that a URDF describes.
    ///
    /// # Errors
    /// All that is wrong with the text and the robot, at once.
    ///
    /// ```
    /// let error = frs_core::Model::from_urdf("<robot name='r'>\n<link/>\n</robot>").unwrap_err();
    /// assert!(error.to_string().starts_with("robot.urdf:2:1: link 0: the link has no name; expected a name;"));
    /// ```
    pub fn from_urdf(text: &str) -> Result<Self, UrdfError> {
        Self::from_urdf_with(text, &Options::default())
    }

    /// The robot that a URDF describes, read as `options` say.
    ///
    /// # Errors
    /// As [`from_urdf`](Self::from_urdf).
    pub fn from_urdf_with(text: &str, options: &Options<'_>) -> Result<Self, UrdfError> {
        let source = Source::new(text, options.file);
        let document = xml::parse(&source)?;
        let Reading { robot, elements, mut findings } = read::read(&document, options);
        let (model, problems) = match robot.map(|robot| robot.build()) {
            Some(Ok(model)) => {
                let warnings = model.warnings().to_vec();
                (Some(model), warnings)
            }
            Some(Err(error)) => (None, error.into_problems()),
            None => (None, Vec::new()),
        };
        findings.extend(problems.into_iter().map(|problem| (elements.offset(&problem), problem)));
        let problems = source.settle(findings);
        match model {
            Some(model) if problems.iter().all(|problem: &Problem| problem.severity == Severity::Warning) => {
                Ok(model.with_warnings(problems))
            }
            _ => Err(UrdfError::new(problems)),
        }
    }
}
