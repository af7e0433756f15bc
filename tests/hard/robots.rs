//! Robots that are hard in one way, and their states.

use frs::Model;
use frs::model::{InertialDescription, JointKind, RobotDescription};
use frs::nalgebra::Vector3;
use frs::spatial::{Pose, Symmetric3};

use crate::state::State;

/// A state whose joint values are within ±`size`.
pub fn turned(model: &Model, seed: u64, size: f64) -> State {
    let q = State::random(seed).numbers("q", model.dof());
    State::random(seed).with("q", q.iter().map(|q| size * q).collect())
}

/// A box of this mass whose sides are these (m), with its centre of mass at `com`.
pub fn brick(mass: f64, com: Vector3<f64>, sides: [f64; 3]) -> InertialDescription {
    let [x, y, z] = sides.map(|side| mass * side * side / 12.0);
    InertialDescription { mass, com, inertia: Symmetric3::diagonal(Vector3::new(y + z, x + z, x + y)) }
}

/// A base and links on hinges, one after the other along x; the axes are those of `axes`, again and again.
fn line(base: InertialDescription, links: &[InertialDescription], axes: &[[f64; 3]]) -> RobotDescription {
    let mut robot = RobotDescription::new("line");
    robot.link("link_0", base);
    for (k, &link) in (1..).zip(links) {
        robot.link(format!("link_{k}"), link);
        let (parent, child) = (format!("link_{}", k - 1), format!("link_{k}"));
        let [x, y, z] = axes[(k - 1) % axes.len()];
        let joint = robot.joint(format!("joint_{k}"), JointKind::Continuous, parent, child);
        joint.origin(Pose::from_rpy(Vector3::x(), [0.0; 3])).axis(x, y, z);
    }
    robot
}

pub fn built(robot: RobotDescription) -> Model {
    robot.build().expect("the robot is well formed")
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// A bar of 1 kg, 1 m and 1 dm², from the origin along x.
fn bar() -> InertialDescription {
    brick(1.0, Vector3::new(0.5, 0.0, 0.0), [1.0, 0.1, 0.1])
}

/// Bars, the hinges about y and z in turn.
pub fn chain(links: usize) -> Model {
    built(line(bar(), &vec![bar(); links], &[Y, Z]))
}

/// Bars without thickness.
pub fn rods(links: usize) -> Model {
    built(line(bar(), &vec![brick(1.0, Vector3::new(0.5, 0.0, 0.0), [1.0, 0.0, 0.0]); links], &[Y, Z]))
}

/// Two bars, and a bar of this thickness that turns about its own axis.
pub fn needle(thickness: f64) -> RobotDescription {
    let needle = brick(1.0, Vector3::new(0.5, 0.0, 0.0), [1.0, thickness, thickness]);
    line(bar(), &[bar(), bar(), needle], &[Y, Z, X])
}

/// The same robot with the mass and the inertia of a link times `ratio`.
pub fn scaled(model: &Model, link: &str, ratio: f64) -> Model {
    let mut inertial = model.links()[model.link(link).expect("the link is there")].inertial;
    inertial.mass *= ratio;
    inertial.inertia = inertial.inertia * ratio;
    model.with_inertial(link, inertial).expect("the link is there")
}

/// The default robot with another last link.
pub fn with_tool(model: &Model, tool: InertialDescription) -> Model {
    model.with_inertial("link_7", tool).expect("the link is there")
}
