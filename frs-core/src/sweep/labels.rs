//! What the sweeps hold, by name: for whoever explains or generates their operations.

use super::{Data, Workspace};
use crate::Real;
use crate::spatial::{ArticulatedInertia, CoriolisFactor, Inertia, Symmetric3};

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
        let data = &self.data;
        let mut list = List { labels: Vec::new() };
        poses(data, &mut list);
        inertias(data, &mut list);
        joints(data, &mut list);
        question(data, &mut list);
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

fn poses<T: Real>(data: &Data<T>, list: &mut List<T>) {
    for (k, (rotation, origin)) in data.rotation.iter().zip(&data.origin).enumerate() {
        list.add(Pass::Poses, "rotation", Some(k), MATRIX, rotation.iter().copied());
        list.add(Pass::Poses, "origin", Some(k), XYZ, origin.iter().copied());
    }
    list.add(Pass::Poses, "com", None, XYZ, data.com.iter().copied());
}

fn inertias<T: Real>(data: &Data<T>, list: &mut List<T>) {
    for (k, inertia) in data.inertia.iter().enumerate() {
        list.add(Pass::Inertias, "inertia", Some(k), INERTIA, inertia_values(inertia));
    }
    for (k, composite) in data.composite.iter().enumerate() {
        list.add(Pass::Inertias, "composite", Some(k), INERTIA, inertia_values(composite));
    }
    list.add(Pass::Inertias, "locked_inverse_pivot", None, XYZ, data.locked.inverse_pivots.iter().copied());
    for (k, complement) in data.complement.iter().enumerate() {
        list.add(Pass::Complements, "complement", Some(k), INERTIA, inertia_values(complement));
    }
}

fn joints<T: Real>(data: &Data<T>, list: &mut List<T>) {
    for (k, j) in (1..).zip(0..data.screw.len()) {
        list.add(Pass::Screws, "screw", Some(k), TWIST, data.screw[j].to_array());
        list.add(Pass::Screws, "inside", Some(k), WRENCH, data.inside[j].to_array());
        list.add(Pass::Screws, "connection", Some(k), TWIST, data.connection[j].to_array());
        list.add(Pass::Outside, "outside", Some(k), WRENCH, data.outside[j].to_array());
        list.add(Pass::Reactions, "reaction", Some(k), TWIST, data.reaction[j].to_array());
    }
    for (k, velocity) in data.velocity.iter().enumerate() {
        list.add(Pass::Velocities, "velocity", Some(k), TWIST, velocity.to_array());
    }
}

/// Scratch: what it means, the file of the question says.
fn question<T: Real>(data: &Data<T>, list: &mut List<T>) {
    let pass = Pass::Question;
    for k in 0..data.inertia.len() {
        list.add(pass, "factor", Some(k), FACTOR, factor_values(&data.factor[k]));
        list.add(pass, "factor_outside", Some(k), FACTOR, factor_values(&data.factor_outside[k]));
        list.add(pass, "inertia_rate", Some(k), INERTIA, inertia_values(&data.inertia_rate[k]));
        list.add(pass, "articulated", Some(k), ARTICULATED, articulated_values(&data.articulated[k]));
        list.add(pass, "twist", Some(k), TWIST, data.twist[k].to_array());
        list.add(pass, "wrench", Some(k), WRENCH, data.wrench[k].to_array());
        list.add(pass, "wrench_outside", Some(k), WRENCH, data.wrench_outside[k].to_array());
    }
    for (k, j) in (1..).zip(0..data.screw.len()) {
        list.add(pass, "turn", Some(k), XYZ, data.turn[j].iter().copied());
        list.add(pass, "six", Some(k), WRENCH, data.six_rows.get(j));
        list.add(pass, "three", Some(k), XYZ, data.three_rows_more.get(j));
        list.add(pass, "inverse_pivot", Some(k), &["d"], [data.inverse_pivot[j]]);
    }
}

fn symmetric_values<T: Real>(matrix: &Symmetric3<T>) -> [T; 6] {
    [matrix.xx, matrix.xy, matrix.xz, matrix.yy, matrix.yz, matrix.zz]
}

fn inertia_values<T: Real>(inertia: &Inertia<T>) -> impl Iterator<Item = T> {
    [inertia.mass].into_iter().chain(<[T; 3]>::from(inertia.moment)).chain(symmetric_values(&inertia.rotational))
}

fn factor_values<T: Real>(factor: &CoriolisFactor<T>) -> impl Iterator<Item = T> {
    factor.rotational.iter().copied().chain(factor.momentum.iter().copied())
}

fn articulated_values<T: Real>(inertia: &ArticulatedInertia<T>) -> impl Iterator<Item = T> {
    let [rotational, linear] = [&inertia.rotational, &inertia.linear].map(symmetric_values);
    rotational.into_iter().chain(inertia.coupling.iter().copied()).chain(linear)
}
