//! Short words for the parts of a robot built in code.

use frs_core::model::{InertialDescription, JointKind, Limits, RobotDescription};
use frs_core::spatial::{Pose, Symmetric3};
use nalgebra::{Matrix3, Vector3};

/// The limits of every slider in `robots/oracles`; no formula depends on them.
pub const RAIL: Limits = Limits {
    lower: Some(-4.0),
    upper: Some(4.0),
    effort: Some(100.0),
    velocity: Some(10.0),
    damping: 0.0,
    friction: 0.0,
    rotor_inertia: 0.0,
};

/// Mass (kg), centre of mass (m), and rotational inertia about it (kg·m²): its diagonal, and xy, xz, yz.
pub const fn solid(
    mass: f64,
    [x, y, z]: [f64; 3],
    [xx, yy, zz]: [f64; 3],
    [xy, xz, yz]: [f64; 3],
) -> InertialDescription {
    InertialDescription { mass, com: Vector3::new(x, y, z), inertia: Symmetric3 { xx, xy, xz, yy, yz, zz } }
}

/// A joint's origin in the parent link, whose axes it keeps (m).
pub fn at([x, y, z]: [f64; 3]) -> Pose<f64> {
    Pose::new(Matrix3::identity(), Vector3::new(x, y, z))
}

/// Hangs `carried` on the base by three rails without mass, along x, y and z, that stand at `place` at q = 0; all names have `tag`.
pub fn gantry(robot: &mut RobotDescription, tag: &str, place: Vector3<f64>, carried: InertialDescription) {
    let [rail_x, rail_y, mass] = [format!("rail{tag}_x"), format!("rail{tag}_y"), format!("mass{tag}")];
    robot.link(&rail_x, InertialDescription::NONE);
    robot.link(&rail_y, InertialDescription::NONE);
    robot.link(&mass, carried);
    let mut slide = |axis: &str, parent: &str, child: &str, place: Vector3<f64>, [x, y, z]: [f64; 3]| {
        let name = format!("slide{tag}_{axis}");
        robot.joint(&name, JointKind::Prismatic, parent, child).origin(at(place.into())).axis(x, y, z).limits(RAIL);
    };
    slide("x", "base", &rail_x, place, [1.0, 0.0, 0.0]);
    slide("y", &rail_x, &rail_y, Vector3::zeros(), [0.0, 1.0, 0.0]);
    slide("z", &rail_y, &mass, Vector3::zeros(), [0.0, 0.0, 1.0]);
}
