//! What the sweeps hold, by name: for whoever explains or generates their operations.

use super::parts::Parts;
use super::{Data, Workspace};
use crate::Real;
use crate::spatial::ArticulatedInertia;

/// The passes of the recursion, in the order in which they run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Pass {
    /// Rotations and origins of the bodies, and the centre of mass.
    Poses,
    /// Inertias of the bodies and of their subtrees.
    Inertias,
    /// Inertias of what is outside each subtree.
    Complements,
    /// Screw axes, their momenta, and the connection.
    Screws,
    /// Momenta of the screws outside the subtrees.
    Outside,
    /// How each joint moves its own subtree at zero momentum.
    Reactions,
    /// Velocities at zero momentum.
    Velocities,
    /// What the last question left behind.
    Question,
}

/// A named group of numbers that belong to one body, or to the robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Label<T> {
    /// The pass that computes it.
    pub pass: Pass,
    /// Name of the quantity, as in NOTATION.md §6.
    pub symbol: &'static str,
    /// Number of the body; `None` for the robot as a whole.
    pub body: Option<usize>,
    /// Names of the components.
    pub components: &'static [&'static str],
    /// Values of the components.
    pub values: Vec<T>,
}

const XYZ: &[&str] = &["x", "y", "z"];
const MATRIX: &[&str] = &["xx", "yx", "zx", "xy", "yy", "zy", "xz", "yz", "zz"];
const TWIST: &[&str] = &["wx", "wy", "wz", "vx", "vy", "vz"];
const WRENCH: &[&str] = &["mx", "my", "mz", "fx", "fy", "fz"];
const INERTIA: &[&str] = &["m", "hx", "hy", "hz", "xx", "xy", "xz", "yy", "yz", "zz"];
const FACTOR: &[&str] = &["xx", "yx", "zx", "xy", "yy", "zy", "xz", "yz", "zz", "px", "py", "pz"];
const ARTICULATED: &[&str] = &[
    "jxx", "jxy", "jxz", "jyy", "jyz", "jzz", "hxx", "hyx", "hzx", "hxy", "hyy", "hzy", "hxz", "hyz", "hzz", "mxx",
    "mxy", "mxz", "myy", "myz", "mzz",
];

impl<T: Real> Workspace<'_, T> {
    /// What the sweeps hold, pass by pass and body by body.
    ///
    /// ```
    /// use frs_core::{Model, Workspace};
    /// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
    /// let mut work = Workspace::new(&model);
    /// work.shape(&[0.0; 7]);
    /// let screws: Vec<_> = work.labels().into_iter().filter(|label| label.symbol == "screw").collect();
    /// assert_eq!(screws.len(), 7);
    /// assert_eq!(screws[0].components[..3], ["wx", "wy", "wz"]);
    /// # Ok::<(), frs_core::urdf::UrdfError>(())
    /// ```
    pub fn labels(&self) -> Vec<Label<T>> {
        let (data, bodies) = (&self.data, self.model.bodies().len());
        let mut list = List { labels: Vec::new() };
        poses(data, bodies, &mut list);
        inertias(data, bodies, &mut list);
        joints(data, bodies, &mut list);
        question(data, bodies, &mut list);
        list.labels.sort_by_key(|label| label.pass);
        list.labels
    }
}

struct List<T> {
    labels: Vec<Label<T>>,
}

impl<T: Real> List<T> {
    fn add(
        &mut self,
        pass: Pass,
        symbol: &'static str,
        body: Option<usize>,
        components: &'static [&'static str],
        values: impl IntoIterator<Item = T>,
    ) {
        self.labels.push(Label { pass, symbol, body, components, values: values.into_iter().collect() });
    }
}

fn poses<T: Real>(data: &Data<T>, bodies: usize, list: &mut List<T>) {
    for k in 0..bodies {
        list.add(Pass::Poses, "rotation", Some(k), MATRIX, data.rotation[k].parts());
        list.add(Pass::Poses, "origin", Some(k), XYZ, data.origin[k].parts());
    }
    list.add(Pass::Poses, "com", None, XYZ, data.com.parts());
}

fn inertias<T: Real>(data: &Data<T>, bodies: usize, list: &mut List<T>) {
    for k in 0..bodies {
        list.add(Pass::Inertias, "inertia", Some(k), INERTIA, data.inertia[k].parts());
    }
    for k in 0..bodies {
        list.add(Pass::Inertias, "composite", Some(k), INERTIA, data.composite[k].parts());
    }
    list.add(Pass::Inertias, "locked_inverse_pivot", None, XYZ, data.locked.inverse_pivots.parts());
    for k in 0..bodies {
        list.add(Pass::Complements, "complement", Some(k), INERTIA, data.complement[k].parts());
    }
}

fn joints<T: Real>(data: &Data<T>, bodies: usize, list: &mut List<T>) {
    for k in 1..bodies {
        list.add(Pass::Screws, "screw", Some(k), TWIST, data.screw.at::<[T; 6]>(k - 1));
        list.add(Pass::Screws, "inside", Some(k), WRENCH, data.inside.at::<[T; 6]>(k - 1));
        list.add(Pass::Screws, "connection", Some(k), TWIST, data.connection.at::<[T; 6]>(k - 1));
        list.add(Pass::Outside, "outside", Some(k), WRENCH, data.outside.at::<[T; 6]>(k - 1));
        list.add(Pass::Reactions, "reaction", Some(k), TWIST, data.reaction.at::<[T; 6]>(k - 1));
    }
    for k in 0..bodies {
        list.add(Pass::Velocities, "velocity", Some(k), TWIST, data.velocity[k].parts());
    }
}

/// Scratch: what it means, the file of the question says.
fn question<T: Real>(data: &Data<T>, bodies: usize, list: &mut List<T>) {
    let pass = Pass::Question;
    for k in 0..bodies {
        list.add(pass, "factor", Some(k), FACTOR, data.factor[k].parts());
        list.add(pass, "factor_outside", Some(k), FACTOR, data.factor_outside[k].parts());
        list.add(pass, "articulated", Some(k), ARTICULATED, articulated_values(&data.articulated[k]));
        list.add(pass, "twist", Some(k), TWIST, data.twist[k].parts());
        list.add(pass, "wrench", Some(k), WRENCH, data.wrench[k].parts());
        list.add(pass, "wrench_outside", Some(k), WRENCH, data.wrench_outside[k].parts());
    }
    for k in 1..bodies {
        list.add(pass, "six", Some(k), WRENCH, data.six_rows.at::<[T; 6]>(k - 1));
        list.add(pass, "six_more", Some(k), WRENCH, data.six_rows_more.at::<[T; 6]>(k - 1));
        list.add(pass, "three", Some(k), XYZ, data.three_rows.at::<[T; 3]>(k - 1));
        list.add(pass, "three_more", Some(k), XYZ, data.three_rows_more.at::<[T; 3]>(k - 1));
        list.add(pass, "inverse_pivot", Some(k), &["d"], [data.inverse_pivot[k - 1]]);
    }
}

fn articulated_values<T: Real>(inertia: &ArticulatedInertia<T>) -> impl Iterator<Item = T> {
    let [rotational, linear] = [inertia.rotational, inertia.linear].map(Parts::parts);
    rotational.into_iter().chain(inertia.coupling.parts()).chain(linear)
}
