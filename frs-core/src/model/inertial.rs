//! Masses of links, and what a body made of them weighs.

use nalgebra::Vector3;

use super::Link;
use crate::Real;
use crate::spatial::{Symmetric3, Twist, Wrench, cross, times};

/// A mass distribution: ten parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertial<T: Real = f64> {
    /// Mass, kg.
    pub mass: T,
    /// Centre of mass in the link's frame, m.
    pub com: Vector3<T>,
    /// Rotational inertia about the centre of mass, axes of the link's frame, kg·m².
    pub inertia: Symmetric3<T>,
}

impl Inertial {
    /// No mass, no inertia.
    pub const NONE: Self = Self {
        mass: 0.0,
        com: Vector3::new(0.0, 0.0, 0.0),
        inertia: Symmetric3 { xx: 0.0, xy: 0.0, xz: 0.0, yy: 0.0, yz: 0.0, zz: 0.0 },
    };
}

impl<T: Real> Inertial<T> {
    /// The mass distribution of two bodies fixed to each other, both in the same frame; one of them must have mass.
    pub fn joined(self, other: Self) -> Self {
        let mass = self.mass + other.mass;
        let (share, apart) = (other.mass / mass, other.com - self.com);
        let inertia = self.inertia + other.inertia + Symmetric3::point_mass(self.mass * share, apart);
        Self { mass, com: self.com + apart * share, inertia }
    }

    /// The momentum about the frame's origin of a body that moves with the twist `V` (both in this frame).
    pub fn momentum(self, twist: Twist<T>) -> Wrench<T> {
        let force = twist.at(self.com).linear * self.mass;
        Wrench::new(self.inertia * twist.angular + cross(&self.com, &force), force)
    }
}

/// What a body weighs that is made of `links`, in the frame in which they stood when they were [weighed](Link::weighed_at).
///
/// Lever arms are measured from the first link with mass, so that a body with one such link keeps its numbers exactly.
/// Which links have mass is told by [`Link::massive`] and not by the numbers: nothing here depends on a value.
pub(super) fn weigh<T: Real>(links: &[&Link<T>]) -> Inertial<T> {
    let com = |link: &Link<T>| times(&link.placement.rotation, &link.inertial.com) + link.weighed_at;
    let mut massive = links.iter().filter(|link| link.massive);
    let (mut mass, mut centre, mut alone) = (T::zero(), Vector3::zeros(), true);
    if let Some(first) = massive.next() {
        (mass, centre) = (first.inertial.mass, com(first));
        let mut moment = Vector3::zeros();
        for link in massive {
            mass += link.inertial.mass;
            moment += (com(link) - centre) * link.inertial.mass;
            alone = false;
        }
        if !alone {
            centre += moment / mass;
        }
    }
    let mut inertia = Symmetric3::zero();
    for link in links {
        inertia = inertia + link.inertial.inertia.rotated(&link.placement.rotation);
        // A mass alone has no lever arm.
        if !alone {
            inertia = inertia + Symmetric3::point_mass(link.inertial.mass, com(link) - centre);
        }
    }
    Inertial { mass, com: centre, inertia }
}
