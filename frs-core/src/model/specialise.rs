//! The same robot with less freedom, or with other masses.

use thiserror::Error;

use super::inertial::weigh;
use super::{Drive, Inertial, Link, Model};
use crate::Real;

/// Why a robot has no such special case.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SpecialiseError {
    /// A name that no coordinate has.
    #[error("coordinate '{name}': the robot has no such coordinate; expected one of its coordinates; {}", choice(.known))]
    UnknownCoordinate {
        /// The name.
        name: String,
        /// The names of all coordinates.
        known: Vec<String>,
    },
    /// A coordinate that is named twice.
    #[error("coordinate '{name}': held twice; expected one value for each coordinate; take one of the two away")]
    HeldTwice {
        /// Its name.
        name: String,
    },
    /// No coordinate is left.
    #[error("robot: all coordinates are held; expected one at least that stays free; leave one out")]
    NothingFree,
    /// A name that no link has.
    #[error("link '{name}': the robot has no such link; expected one of its links; {}", choice(.known))]
    UnknownLink {
        /// The name.
        name: String,
        /// The names of all links.
        known: Vec<String>,
    },
}

fn choice(known: &[String]) -> String {
    match known {
        [] => "it has none".into(),
        known => format!("choose from {}", known.join(", ")),
    }
}

impl<T: Real> Model<T> {
    /// The same robot with coordinates held at values (rad or m): `held` has names and values.
    ///
    /// Bodies and links stay as they are. A held coordinate is no column any more, and later columns move up; the joint
    /// that it drives, with its followers, stands where the value puts it. What is left of every quantity keeps its bits,
    /// up to the sign of zeros, if q̇ was zero where it is held; accelerations and torques are those of a joint that cannot
    /// move. Values must be finite.
    ///
    /// # Errors
    /// If a name is no coordinate's or is given twice, or if no coordinate stays free.
    ///
    /// ```
    /// let model = frs_core::Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
    /// let stiff = model.lock(&[("joint_3", 0.5)])?;
    /// assert_eq!((stiff.dof(), stiff.bodies().len()), (6, 8));
    /// assert!(model.lock(&[("elbow", 0.5)]).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lock(&self, held: &[(&str, T)]) -> Result<Self, SpecialiseError> {
        let mut values: Vec<Option<T>> = vec![None; self.dof()];
        for &(name, value) in held {
            let column = self.coordinates.iter().position(|coordinate| coordinate.name == name);
            let column = column.ok_or_else(|| SpecialiseError::UnknownCoordinate {
                name: name.into(),
                known: self.coordinates.iter().map(|coordinate| coordinate.name.clone()).collect(),
            })?;
            if values[column].replace(value).is_some() {
                return Err(SpecialiseError::HeldTwice { name: name.into() });
            }
        }
        let free: Vec<usize> = (0..values.len()).filter(|&column| values[column].is_none()).collect();
        if free.is_empty() && !held.is_empty() {
            return Err(SpecialiseError::NothingFree);
        }

        let mut model = self.clone();
        for body in &mut model.bodies[1..] {
            let Drive { coordinate, ratio, offset } = body.drive;
            body.drive = match values[coordinate] {
                Some(value) => Drive { coordinate: 0, ratio: T::zero(), offset: value * ratio + offset },
                None => Drive { coordinate: free.partition_point(|&column| column < coordinate), ratio, offset },
            };
        }
        model.coordinates = free.iter().map(|&column| self.coordinates[column].clone()).collect();
        model.has_mimic |= !held.is_empty();
        Ok(model)
    }

    /// The same robot in which `link` has another mass distribution, in the link's frame: other ten parameters.
    ///
    /// The link counts as one with mass, whatever it was before. All frames stay where they are, the base body's too. With
    /// the parameters that a link with mass has already, the model is the same bit for bit. The parameters are the caller's:
    /// the mass must be positive, and all of them finite and a real body's, for the answers to mean anything.
    ///
    /// # Errors
    /// If no link has this name.
    ///
    /// ```
    /// use frs_core::{Model, Workspace};
    /// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
    /// let mut hand = model.links()[model.link("link_7").unwrap()].inertial;
    /// hand.mass += 5.0;
    /// let laden = model.with_inertial("link_7", hand)?;
    /// let mass = |model| Workspace::new(model).shape(&[0.0; 7]).locked_inertia().mass;
    /// assert!((mass(&laden) - mass(&model) - 5.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_inertial(&self, link: &str, inertial: Inertial<T>) -> Result<Self, SpecialiseError> {
        let number = self.link(link).ok_or_else(|| SpecialiseError::UnknownLink {
            name: link.into(),
            known: self.links.iter().map(|link| link.name.clone()).collect(),
        })?;
        let mut model = self.clone();
        let changed = &mut model.links[number];
        (changed.inertial, changed.massive) = (inertial, true);
        let number = changed.body;
        let parts: Vec<&Link<T>> = model.links.iter().filter(|link| link.body == number).collect();
        let Inertial { mass, com, inertia } = weigh(&parts);
        // The base is weighed in the root link's frame.
        let com = if number == 0 { com + model.root_offset() } else { com };
        let body = &mut model.bodies[number];
        (body.mass, body.com, body.inertia) = (mass, com, inertia);
        Ok(model)
    }
}
