//! What the position sweep reads of the model, joint by joint.

use super::columns::{Columns, Row};
use crate::Real;
use crate::model::Model;

/// Numbers of the bodies that the joints drive.
#[derive(Clone, Debug)]
pub(crate) struct Tables<T: Real> {
    /// Mass.
    pub mass: Row<T>,
    /// Centre of mass, in the body's frame.
    pub com: Columns<T, 3>,
    /// Rotational inertia about the centre of mass without the multiple `aside` of 1, which no rotation changes: it leaves a zero,
    /// of a sphere's inertia nothing, to rotate. `aside` was the least of the diagonal, so that no digit is lost.
    pub spare: Columns<T, 6>,
    pub aside: Row<T>,
}

impl<T: Real> Tables<T> {
    pub fn new(model: &Model<T>) -> Self {
        let joints = model.joints();
        let (mut mass, mut aside) = (Row::new(joints), Row::new(joints));
        let (mut com, mut spare) = (Columns::new(joints), Columns::new(joints));
        for (j, body) in model.bodies()[1..].iter().enumerate() {
            let inertia = body.inertia;
            mass[j] = body.mass;
            aside[j] = [inertia.xx, inertia.yy, inertia.zz][body.least_moment];
            com.set(j, body.com);
            spare.set(j, inertia.plus_multiple(-aside[j]));
        }
        Self { mass, com, spare, aside }
    }
}
