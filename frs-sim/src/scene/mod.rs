//! Scenes: a robot, how it starts, what acts on it, and for how long; TOML texts.
//!
//! All keys: docs/scenes.md. What is known about the momentum is not said in a scene; it follows from what is.

mod added_mass;
mod columns;
mod force;
mod forces;
mod observer;
mod payload;
mod problem;
mod reader;
mod solver;
mod start;
mod timing;
mod work;

use std::io;

use frs_core::model::Place;
use frs_core::spatial::Twist;
use frs_core::{Model, Real};
use nalgebra::Vector3;

use crate::effects::{AddedMass, ComputedTorque, Effect, Effects, EndEffector, Regulator, Stops, Water};
use crate::motion::{Course, Drives};
use crate::observer::Observer;
use reader::{Reader, Table};

pub use force::{EFFECTS, Force, Named};
pub use payload::Payload;
pub use problem::{Problem, SceneError};
pub use reader::Files;
pub use solver::{EQUATIONS, Equations, ROUTES, Solver};
pub use start::Start;
pub use work::Work;

/// What is known about the momentum of a motion; each case is a type in [`motion`](crate::motion).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    /// It is zero and stays so: [`Zero`](crate::motion::Zero).
    Zero,
    /// It stays what it is: [`Conserved`](crate::motion::Conserved).
    Conserved,
    /// Gravity changes its linear half, in a way that is known: [`Ballistic`](crate::motion::Ballistic).
    Ballistic,
    /// Something changes it: [`Driven`](crate::motion::Driven).
    Driven,
    /// The base velocity is integrated in its place: [`Hamel`](crate::motion::Hamel).
    Hamel,
}

impl Case {
    /// In one word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Zero => "zero",
            Self::Conserved => "conserved",
            Self::Ballistic => "ballistic",
            Self::Driven => "driven",
            Self::Hamel => "hamel",
        }
    }

    /// How many numbers are integrated for it.
    pub fn numbers(self) -> usize {
        if self.is_integrated() { 6 } else { 0 }
    }

    /// Whether it is integrated, known or not.
    pub fn is_integrated(self) -> bool {
        matches!(self, Self::Driven | Self::Hamel)
    }
}

/// A motion to be computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// How long it lasts, s.
    pub duration: f64,
    /// How it is computed.
    pub solver: Solver,
    /// How often the motion is written down, 1/s.
    pub samples_per_second: f64,
    /// Where it starts.
    pub start: Start,
    /// What acts on it.
    pub forces: Vec<Named>,
    /// Who observes its locked velocity.
    pub observer: Option<Observer>,
}

/// Keys of a scene that are no effects.
const KEYS: [&str; 7] = ["robot", "duration", "accuracy", "solver", "samples_per_second", "start", "observer"];

/// Samples per second of a scene that does not say.
const SAMPLES_PER_SECOND: f64 = 100.0;

/// The most samples of a scene, beyond which the number is a slip.
const MOST_SAMPLES: f64 = 1e7;

impl Scene {
    /// The path of the robot that `text` names, and where it does; `file` names the text in messages.
    ///
    /// # Errors
    /// If the text is not TOML or names no robot.
    pub fn robot(file: &str, text: &str) -> Result<(String, Place), SceneError> {
        let reader = Reader::new(file, text, &no_files);
        let entries = reader.parse()?;
        let item = Table::root(&reader, &entries).required("robot", "the path of a URDF, from the scene's folder");
        let path = item.and_then(|item| Some((item.text("the path of a URDF")?.to_owned(), item.place())));
        reader.finish(path)
    }

    /// Reads a scene of `model` that names no files but the robot's; `file` names the text in messages.
    ///
    /// # Errors
    /// Everything that is wrong with it, with line and column.
    pub fn parse(file: &str, text: &str, model: &Model) -> Result<Self, SceneError> {
        Self::parse_with(file, text, model, &no_files)
    }

    /// Reads a scene of `model`; `files` reads a file that it names, by its path from the scene's folder.
    ///
    /// # Errors
    /// Everything that is wrong with it and with those files, with line and column.
    pub fn parse_with(file: &str, text: &str, model: &Model, files: &Files<'_>) -> Result<Self, SceneError> {
        let reader = Reader::new(file, text, files);
        let entries = reader.parse()?;
        let root = Table::root(&reader, &entries);
        root.only(&[&KEYS[..], &EFFECTS].concat());

        let duration = root.required("duration", "how long the motion lasts, s").and_then(|item| item.positive());
        let solver = solver::read(&root, model.dof());
        let samples_per_second = root.get("samples_per_second").map_or(Some(SAMPLES_PER_SECOND), |item| {
            let samples = item.positive()?;
            if samples * duration? <= MOST_SAMPLES {
                return Some(samples);
            }
            item.refuse(format!("found {samples}; expected at most {MOST_SAMPLES:e} samples in all"))
        });
        let forces = forces::read(&root, model, duration.unwrap_or(f64::INFINITY));
        forces::contradictions(&root, model, &forces);
        let start = start::read(&root, &payload::laden(model, payloads(&forces), 0.0), &forces);
        let observer = observer::read(&root);
        let scene = (|| {
            Some(Self {
                duration: duration?,
                solver: solver?,
                samples_per_second: samples_per_second?,
                start: start?,
                forces,
                observer: observer?,
            })
        })();
        reader.finish(scene)
    }

    /// What is known about the momentum, and used: [`known_case`](Self::known_case) unless the solver integrates it all the same.
    pub fn case(&self) -> Case {
        match self.solver.equations {
            Equations::Reduced => self.known_case(),
            Equations::Integrated => Case::Driven,
            Equations::Hamel => Case::Hamel,
        }
    }

    /// What is known about the momentum: driven if a force can change it, ballistic if only gravity can, else what it is at the
    /// start, unless a payload brings some.
    pub fn known_case(&self) -> Case {
        if self.forces.iter().any(|named| named.force.drives_momentum()) {
            Case::Driven
        } else if self.forces.iter().any(|named| matches!(named.force, Force::Gravity(_))) {
            Case::Ballistic
        } else if self.start.mu == Twist::zero() && self.handovers().is_empty() {
            Case::Zero
        } else {
            Case::Conserved
        }
    }

    /// The robot with the payloads that it has from `time` (s) on.
    pub fn laden(&self, model: &Model, time: f64) -> Model {
        payload::laden(model, payloads(&self.forces), time)
    }

    /// Times at which payloads are taken or let go, s.
    pub fn handovers(&self) -> Vec<f64> {
        let each = self.forces.iter().filter(|named| matches!(named.force, Force::Payload(_)));
        let mut times: Vec<f64> = each.flat_map(|named| named.force.knots()).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// The payloads, held or not.
    pub fn payloads(&self) -> impl Iterator<Item = &Payload> {
        payloads(&self.forces)
    }

    /// Acceleration of free fall, world axes (m/s²): the sum of all `[gravity]`.
    pub fn gravity(&self) -> Vector3<f64> {
        let each = self.forces.iter().filter_map(|named| match &named.force {
            Force::Gravity(gravity) => Some(Vector3::from(gravity.acceleration)),
            _ => None,
        });
        each.sum()
    }

    /// The forces as effects over any scalar; without gravity where that is known to move the centre of mass alone.
    pub fn effects<'m, T: Real>(&self, model: &'m Model<T>) -> Effects<'m, T> {
        let each = self.forces.iter().enumerate().filter_map(|(number, named)| {
            let effect: Box<dyn Effect<T>> = match &named.force {
                Force::Gravity(_) if self.case() == Case::Ballistic => return None,
                Force::Rotors(_) | Force::Prescribed(..) | Force::Payload(_) => return None,
                Force::Gravity(gravity) => Box::new(*gravity),
                Force::Wrench(wrench) => wrench.clone(),
                Force::Drag(drag) => Box::new(drag.clone()),
                Force::Contact(contact) => Box::new(contact.clone()),
                Force::JointTorque(torque) => Box::new(torque.clone()),
                Force::Viscous(friction) => Box::new(friction.clone()),
                Force::Coulomb(friction) => Box::new(friction.clone()),
                Force::Spring(spring) => Box::new(spring.clone()),
                Force::Stops { stiffness, dissipation } => Box::new(Stops::new(model, *stiffness, *dissipation)),
                Force::Regulator(gains) => Box::new(Regulator::new(gains.clone())),
                Force::ComputedTorque(courses, bandwidth) => Box::new(ComputedTorque::new(courses.clone(), *bandwidth)),
                Force::EndEffector(target) => Box::new(EndEffector::new(target.clone())),
                Force::AddedMass(added, current) => Box::new(self.water(added, *current)),
            };
            Some((number, effect))
        });
        Effects(each.collect())
    }

    /// What the water is to an impulse, and its number among the forces; none if the scene names none.
    pub(crate) fn still_water(&self) -> Option<(usize, Water)> {
        self.forces.iter().enumerate().find_map(|(number, named)| match &named.force {
            Force::AddedMass(added, _) => Some((number, self.water(added, [0.0; 3]))),
            _ => None,
        })
    }

    fn water<T: Real>(&self, added: &[AddedMass], current: [f64; 3]) -> Water<T> {
        Water::new(added, current, self.drives(), self.start.q.len())
    }

    /// Rotors and courses of the joints; none if the scene names none.
    pub fn drives<T: Real>(&self) -> Option<Drives<T>> {
        let n = self.start.q.len();
        let (mut rotor, mut courses): (Vec<f64>, Vec<Option<Course>>) = (vec![0.0; n], vec![None; n]);
        let mut any = false;
        for named in &self.forces {
            match &named.force {
                Force::Rotors(inertia) => rotor.iter_mut().zip(inertia).for_each(|(sum, inertia)| *sum += inertia),
                Force::Prescribed(coordinate, course) => courses[*coordinate] = Some(course.clone()),
                _ => continue,
            }
            any = true;
        }
        any.then(|| Drives::new(&rotor, courses))
    }
}

fn no_files(_: &str) -> io::Result<String> {
    Err(io::Error::new(io::ErrorKind::Unsupported, "the scene was read without its files"))
}

fn payloads(forces: &[Named]) -> impl Iterator<Item = &Payload> {
    forces.iter().filter_map(|named| match &named.force {
        Force::Payload(payload) => Some(payload),
        _ => None,
    })
}
