//! A robot as constants of a program, for generated code in loops: what the sweeps read of a [`Model`], in plain numbers.

use nalgebra::{Matrix3, Vector3};

use super::{Body, Coordinate, Drive, Inertial, Limits, Link, Model, Motion};
use crate::spatial::{Pose, Symmetric3};

/// The numbers of a model that a builder has made.
#[derive(Clone, Copy, Debug)]
pub struct Tables {
    /// The robot's name.
    pub name: &'static str,
    /// The coordinates: name, and number of the body that each drives.
    pub coordinates: &'static [(&'static str, usize)],
    /// Whether some joint follows another one or is held.
    pub has_mimic: bool,
    /// The bodies, base first, depth first.
    pub bodies: &'static [BodyTable],
    /// The links, root first.
    pub links: &'static [LinkTable],
}

/// A [`Body`].
#[derive(Clone, Copy, Debug)]
pub struct BodyTable {
    /// Number of the parent.
    pub parent: usize,
    /// One past the last body of the subtree.
    pub end: usize,
    /// How the joint moves.
    pub motion: Motion,
    /// Orientation in the parent at joint value 0, column by column.
    pub rotation: [f64; 9],
    /// Origin in the parent at joint value 0, m.
    pub translation: [f64; 3],
    /// What drives the joint.
    pub drive: Drive,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the body's frame, m.
    pub com: [f64; 3],
    /// Rotational inertia about the centre of mass: xx, xy, xz, yy, yz, zz, kg·m².
    pub inertia: [f64; 6],
    /// The axis about which the inertia was least.
    pub least_moment: usize,
}

/// Where a [`Link`] stands. What it weighs by itself is not kept.
#[derive(Clone, Copy, Debug)]
pub struct LinkTable {
    /// Name.
    pub name: &'static str,
    /// Number of its body.
    pub body: usize,
    /// Orientation in the body, column by column.
    pub rotation: [f64; 9],
    /// Origin in the body, m.
    pub translation: [f64; 3],
}

impl Tables {
    /// The model again, as far as the sweeps read it: links weigh nothing by themselves, coordinates have no limits.
    pub fn model(&self) -> Model {
        let pose = |rotation: &[f64; 9], translation: [f64; 3]| {
            Pose::new(Matrix3::from_column_slice(rotation), Vector3::from(translation))
        };
        let body = |body: &BodyTable| {
            let [xx, xy, xz, yy, yz, zz] = body.inertia;
            Body {
                parent: body.parent,
                end: body.end,
                motion: body.motion,
                placement: pose(&body.rotation, body.translation),
                drive: body.drive,
                mass: body.mass,
                com: body.com.into(),
                inertia: Symmetric3 { xx, xy, xz, yy, yz, zz },
                least_moment: body.least_moment,
            }
        };
        let link = |link: &LinkTable| Link {
            name: link.name.into(),
            body: link.body,
            placement: pose(&link.rotation, link.translation),
            inertial: Inertial::NONE,
            massive: false,
            weighed_at: Vector3::zeros(),
        };
        let coordinate = |&(name, body): &(&str, usize)| Coordinate {
            name: name.into(),
            body,
            limits: Limits::default(),
            continuous: false,
        };
        Model {
            name: self.name.into(),
            bodies: self.bodies.iter().map(body).collect(),
            links: self.links.iter().map(link).collect(),
            coordinates: self.coordinates.iter().map(coordinate).collect(),
            has_mimic: self.has_mimic,
            warnings: Vec::new(),
        }
    }
}
