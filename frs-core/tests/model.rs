//! From links and joints to bodies: every model is the same robot as its description.

use frs_core::Model;
use frs_core::model::{Body, InertialDescription, JointDescription, JointKind, Motion, RobotDescription, Severity};
use frs_core::spatial::{Inertia, Pose, Symmetric3};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use proptest::prelude::*;

/// Poses and inertias of eight links at unit scale, composed in two different ways.
const ROUNDING: f64 = 1e-13;

type Values = Vec<[f64; 3]>;

fn solid(mass: f64, com: [f64; 3]) -> InertialDescription {
    let inertia = Symmetric3 { xx: 0.5, xy: 0.125, xz: -0.0625, yy: 0.625, yz: 0.03125, zz: 0.75 };
    InertialDescription { mass, com: com.into(), inertia: inertia * mass }
}

fn turn(axis: Vector3<f64>, angle: f64) -> Pose<f64> {
    Pose::new(Rotation3::from_axis_angle(&Unit::new_normalize(axis), angle).into_inner(), Vector3::zeros())
}

fn slide(along: Vector3<f64>) -> Pose<f64> {
    Pose::new(Matrix3::identity(), along)
}

/// Pose of the child in the parent, as a URDF defines it.
fn crossing(joint: &JointDescription, [x, y, yaw]: [f64; 3]) -> Pose<f64> {
    let motion = match joint.kind {
        JointKind::Fixed | JointKind::Floating => Pose::identity(),
        JointKind::Revolute | JointKind::Continuous => turn(joint.axis, x),
        JointKind::Prismatic => slide(joint.axis.normalize() * x),
        JointKind::Planar => slide(Vector3::new(x, y, 0.0)) * turn(Vector3::z(), yaw),
    };
    joint.origin * motion
}

/// Value of joint `index`, of its leader's if it is a mimic.
fn value(robot: &RobotDescription, values: &Values, index: usize) -> [f64; 3] {
    match &robot.joints[index].mimic {
        Some(mimic) => {
            let leader = robot.joints.iter().position(|joint| joint.name == mimic.joint).unwrap();
            [mimic.multiplier * value(robot, values, leader)[0] + mimic.offset, 0.0, 0.0]
        }
        None => values[index],
    }
}

/// Pose of each link in the link that is nobody's child; every joint's parent must be described before it.
fn poses_by_description(robot: &RobotDescription, values: &Values) -> Vec<Pose<f64>> {
    let number = |name: &str| robot.links.iter().position(|link| link.name == name).unwrap();
    let mut poses = vec![Pose::identity(); robot.links.len()];
    for (index, joint) in robot.joints.iter().enumerate() {
        poses[number(&joint.child)] = poses[number(&joint.parent)] * crossing(joint, value(robot, values, index));
    }
    poses
}

/// The shape at which the joints have these values.
fn shape(model: &Model, robot: &RobotDescription, values: &Values) -> Vec<f64> {
    let of = |name: &str| {
        robot.joints.iter().enumerate().find_map(|(index, joint)| {
            let [x, y, yaw] = values[index];
            let rest = name.strip_prefix(joint.name.as_str())?;
            Some(match rest {
                "" | "_x" => x,
                "_y" => y,
                "_yaw" => yaw,
                _ => return None,
            })
        })
    };
    model.coordinates().iter().map(|coordinate| of(&coordinate.name).unwrap()).collect()
}

/// Pose of each body in the base body.
fn body_poses(model: &Model, q: &[f64]) -> Vec<Pose<f64>> {
    let mut poses: Vec<Pose<f64>> = Vec::new();
    for (k, body) in model.bodies().iter().enumerate() {
        let value = |body: &Body| body.drive.ratio * q[body.drive.coordinate] + body.drive.offset;
        poses.push(match (k, body.motion) {
            (0, _) => Pose::identity(),
            (_, Motion::Revolute) => poses[body.parent] * body.placement * turn(Vector3::z(), value(body)),
            (_, Motion::Prismatic) => poses[body.parent] * body.placement * slide(Vector3::z() * value(body)),
        });
    }
    poses
}

fn distance(a: &Pose<f64>, b: &Pose<f64>) -> f64 {
    (a.rotation - b.rotation).amax().max((a.translation - b.translation).amax())
}

fn inertia_of(inertial: &InertialDescription) -> Inertia<f64> {
    Inertia::from_com(inertial.mass, inertial.com, inertial.inertia)
}

fn assert_same_robot(robot: &RobotDescription, values: &Values) {
    let model = robot.build().unwrap();
    let bodies = body_poses(&model, &shape(&model, robot, values));
    let described = poses_by_description(robot, values);
    let number = |name: &str| robot.links.iter().position(|link| link.name == name).unwrap();

    // Links stand where the description puts them.
    let root = described[number(&model.links()[0].name)];
    assert_eq!(model.links().len(), robot.links.len());
    for link in model.links() {
        let expected = root.inverse() * described[number(&link.name)];
        let found = bodies[0] * model.links()[0].placement;
        let found = found.inverse() * bodies[link.body] * link.placement;
        assert!(distance(&found, &expected) < ROUNDING, "{}: {found:?} is not {expected:?}", link.name);
    }

    // Bodies weigh together what links weigh together.
    let mut expected = Inertia::zero();
    for (link, pose) in robot.links.iter().zip(&described) {
        expected += inertia_of(&link.inertial).transformed(pose);
    }
    let base = root * model.links()[0].placement.inverse();
    let mut found = Inertia::zero();
    for (body, pose) in model.bodies().iter().zip(&bodies) {
        found += Inertia::from_com(body.mass, body.com, body.inertia).transformed(&(base * *pose));
    }
    let scale = expected.to_matrix().amax();
    assert!((found.to_matrix() - expected.to_matrix()).amax() < ROUNDING * scale);

    assert_depth_first(&model);
}

fn assert_depth_first(model: &Model) {
    for (k, body) in model.bodies().iter().enumerate().skip(1) {
        let parent = &model.bodies()[body.parent];
        assert!(body.parent < k && k < body.end && body.end <= parent.end);
        assert_eq!((k..body.end).len(), 1 + model.bodies()[k + 1..].iter().filter(|b| below(model, b, k)).count());
    }
    assert_eq!((model.bodies()[0].parent, model.bodies()[0].end), (0, model.bodies().len()));
    assert_eq!(model.bodies()[0].com, Vector3::zeros());
}

fn below(model: &Model, body: &Body, ancestor: usize) -> bool {
    let mut parent = body.parent;
    while parent > ancestor {
        parent = model.bodies()[parent].parent;
    }
    parent == ancestor
}

/// Robots with all kinds of joints, some axes along coordinate axes and some joints mimics, and values for them.
fn robots() -> impl Strategy<Value = (RobotDescription, Values)> {
    let number = || -1.0..1.0_f64;
    let triple = move || [number(), number(), number()];
    let axis = prop_oneof![
        Just([1.0, 0.0, 0.0]),
        Just([0.0, -1.0, 0.0]),
        Just([0.0, 0.0, 3.0]),
        triple().prop_filter("an axis", |axis| axis.iter().any(|entry| entry.abs() > 0.01)),
    ];
    let link = (0..8_usize, 0..6_usize, axis, triple(), triple(), (triple(), 0.1..2.0_f64), 0..4_usize, triple());
    prop::collection::vec(link, 1..8).prop_map(|links| {
        let mut robot = RobotDescription::new("random");
        robot.link("link_0", solid(1.0, [0.25, -0.5, 0.125]));
        let mut values = Values::new();
        for (i, (parent, kind, axis, xyz, rpy, (com, mass), mimic, value)) in links.into_iter().enumerate() {
            let child = i + 1;
            robot.link(format!("link_{child}"), solid(mass, com));
            let (kind, [x, y, z]) = match kind {
                0 => (JointKind::Fixed, axis),
                1 => (JointKind::Continuous, axis),
                2 => (JointKind::Planar, [0.0, 0.0, 2.0]),
                3 => (JointKind::Prismatic, axis),
                _ => (JointKind::Revolute, axis),
            };
            let one_value = |joint: &&JointDescription| !matches!(joint.kind, JointKind::Fixed | JointKind::Planar);
            let leader = robot.joints.iter().rev().find(one_value).map(|joint| joint.name.clone());
            let name = ["a", "b", "c", "d", "e", "f", "g"][i];
            let joint = robot.joint(name, kind, format!("link_{}", parent % child), format!("link_{child}"));
            joint.axis(x, y, z).origin(Pose::from_rpy(xyz.into(), rpy));
            if let (Some(leader), 0, true) = (leader, mimic, one_value(&&*joint)) {
                joint.mimic(leader, -0.5, 0.25);
            }
            values.push(value);
        }
        (robot, values)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn a_model_is_the_robot_that_was_described((robot, values) in robots()) {
        assert_same_robot(&robot, &values);
    }

    #[test]
    fn a_model_is_the_same_robot_from_any_root((mut robot, values) in robots(), root in 0..8_usize) {
        robot.root = Some(format!("link_{}", root % robot.links.len()));
        assert_same_robot(&robot, &values);
        let model = robot.build().unwrap();
        prop_assert_eq!(&model.links()[0].name, robot.root.as_ref().unwrap());
    }
}

/// base → (fixed) shell, base → a → b, base → c, described out of order.
fn branched() -> RobotDescription {
    let mut robot = RobotDescription::new("branched");
    for name in ["b", "a", "shell", "base", "c"] {
        robot.link(name, solid(1.0, [0.25, 0.5, -0.125]));
    }
    robot.joint("base_a", JointKind::Revolute, "base", "a").axis(0.0, 0.0, 1.0);
    robot.joint("a_b", JointKind::Prismatic, "a", "b").axis(0.0, -1.0, 0.0);
    robot.joint("base_shell", JointKind::Fixed, "base", "shell");
    robot.joint("base_c", JointKind::Continuous, "base", "c").axis(1.0, 0.0, 0.0);
    robot
}

fn names<'a>(names: impl Iterator<Item = &'a String>) -> Vec<&'a str> {
    names.map(String::as_str).collect()
}

#[test]
fn bodies_are_numbered_depth_first_in_the_order_of_joints() {
    let model = branched().build().unwrap();
    assert_eq!(names(model.coordinates().iter().map(|c| &c.name)), ["base_a", "a_b", "base_c"]);
    assert_eq!(names(model.links().iter().map(|l| &l.name)), ["base", "a", "b", "shell", "c"]);
    assert_eq!(model.links().iter().map(|l| l.body).collect::<Vec<_>>(), [0, 1, 2, 0, 3]);
    assert_eq!(model.bodies().iter().map(|b| b.parent).collect::<Vec<_>>(), [0, 0, 1, 0]);
    assert_eq!(model.bodies().iter().map(|b| b.end).collect::<Vec<_>>(), [4, 3, 3, 4]);
    assert_eq!(model.coordinates().iter().map(|c| c.continuous).collect::<Vec<_>>(), [false, false, true]);
    assert!(!model.has_mimic());
    assert_eq!(model.link("shell"), Some(3));
}

#[test]
fn coordinate_axes_give_exact_constants_without_negative_zeros() {
    for root in ["base", "b", "c", "shell"] {
        let mut robot = branched();
        robot.root = Some(root.into());
        let model = robot.build().unwrap();
        let poses = model.bodies().iter().map(|b| b.placement).chain(model.links().iter().map(|l| l.placement));
        for pose in poses {
            assert!(pose.rotation.iter().all(|entry| [0.0, 1.0, -1.0].contains(entry)), "{}", pose.rotation);
            // Sums of the quarters and eighths of the description.
            assert!(pose.translation.iter().all(|entry| (entry * 8.0).fract() == 0.0), "{}", pose.translation);
            let negative_zero = |entry: &f64| *entry == 0.0 && entry.is_sign_negative();
            assert!(!pose.rotation.iter().chain(pose.translation.iter()).any(negative_zero));
        }
    }
}

#[test]
fn bodies_of_one_link_about_z_keep_their_numbers_bit_for_bit() {
    let mut robot = RobotDescription::new("pendulum");
    let bob = InertialDescription {
        mass: 0.7,
        com: Vector3::new(0.1, 0.2, 0.3),
        inertia: Symmetric3 { xx: 0.21, xy: 0.01, xz: 0.03, yy: 0.23, yz: 0.07, zz: 0.27 },
    };
    robot.link("base", bob);
    robot.link("bob", bob);
    robot.joint("swing", JointKind::Revolute, "base", "bob").axis(0.0, 0.0, 2.5);
    let model = robot.build().unwrap();
    let [base, body] = model.bodies() else { panic!("two bodies") };
    assert_eq!((body.mass, body.com, body.inertia), (bob.mass, bob.com, bob.inertia));
    assert_eq!((base.mass, base.com, base.inertia), (bob.mass, Vector3::zeros(), bob.inertia));
    assert_eq!(model.links()[0].placement, slide(-bob.com));
}

#[test]
fn chains_of_mimics_compose() {
    let mut robot = RobotDescription::new("fingers");
    robot.link("palm", solid(1.0, [0.0; 3]));
    for name in ["tip", "middle", "root"] {
        robot.link(name, solid(0.1, [0.25, 0.0, 0.0]));
    }
    // The leader comes last, the last follower first.
    robot.joint("third", JointKind::Prismatic, "middle", "tip").mimic("second", 3.0, 0.5);
    robot.joint("second", JointKind::Revolute, "root", "middle").mimic("first", -2.0, 0.25);
    robot.joint("first", JointKind::Continuous, "palm", "root");
    let model = robot.build().unwrap();
    assert_eq!(names(model.coordinates().iter().map(|c| &c.name)), ["first"]);
    assert!(model.has_mimic());
    let drives: Vec<_> =
        model.bodies()[1..].iter().map(|b| (b.drive.coordinate, b.drive.ratio, b.drive.offset)).collect();
    assert_eq!(drives, [(0, 1.0, 0.0), (0, -2.0, 0.25), (0, -6.0, 1.25)]);
}

#[test]
fn a_multiplier_of_zero_locks_the_joint_and_warns() {
    let mut robot = branched();
    robot.joints[3].mimic("base_a", 0.0, 0.5);
    let model = robot.build().unwrap();
    assert_eq!(model.dof(), 2);
    assert_eq!((model.bodies()[3].drive.ratio, model.bodies()[3].drive.offset), (0.0, 0.5));
    assert_eq!(model.warnings().len(), 1);
    assert_eq!(model.warnings()[0].severity, Severity::Warning);
}

#[test]
fn a_planar_joint_has_three_coordinates_whichever_side_is_the_base() {
    let mut robot = RobotDescription::new("puck");
    robot.link("table", solid(5.0, [0.0; 3]));
    robot.link("puck", solid(1.0, [0.0; 3]));
    robot.joint("glide", JointKind::Planar, "table", "puck").axis(0.0, 1.0, 0.0);
    let model = robot.build().unwrap();
    assert_eq!(names(model.coordinates().iter().map(|c| &c.name)), ["glide_x", "glide_y", "glide_yaw"]);
    assert_eq!(model.links().len(), 2);
    let height = |model: &Model, link: &str, q: &[f64]| {
        let link = &model.links()[model.link(link).unwrap()];
        (body_poses(model, q)[link.body] * link.placement).translation.y
    };
    assert_eq!(height(&model, "puck", &[0.5, 0.25, 1.0]), 0.0);

    robot.root = Some("puck".into());
    let model = robot.build().unwrap();
    assert_eq!(names(model.coordinates().iter().map(|c| &c.name)), ["glide_yaw", "glide_y", "glide_x"]);
    assert_eq!(height(&model, "table", &[1.0, 0.25, 0.5]), 0.0);
}

#[test]
fn a_massless_world_with_a_floating_joint_is_dropped() {
    let mut robot = branched();
    robot.link("world", InertialDescription::NONE);
    robot.joint("free", JointKind::Floating, "world", "base");
    let model = robot.build().unwrap();
    assert_eq!(model.links()[0].name, "base");
    assert_eq!((model.dof(), model.link("world")), (3, None));
    for (root, taken) in [("world", "base"), ("c", "c")] {
        robot.root = Some(root.into());
        assert_eq!(robot.build().unwrap().links()[0].name, taken);
    }
}

#[test]
fn a_single_body_is_a_robot() {
    let mut robot = RobotDescription::new("rock");
    robot.link("rock", solid(2.0, [1.0, 0.0, 0.0]));
    let model = robot.build().unwrap();
    assert_eq!((model.dof(), model.bodies().len()), (0, 1));
}

#[test]
fn massless_links_points_and_rods_are_parts_of_robots() {
    let mut robot = RobotDescription::new("gimbal");
    robot.link("base", solid(2.0, [0.0; 3]));
    robot.link("ring", InertialDescription::NONE);
    robot.link(
        "rod",
        InertialDescription { inertia: Symmetric3::diagonal(Vector3::new(0.0, 0.5, 0.5)), ..solid(1.0, [0.0; 3]) },
    );
    robot.link("point", InertialDescription { mass: 1.0, com: Vector3::x(), inertia: Symmetric3::zero() });
    robot.link("wheel", InertialDescription { mass: 0.0, ..solid(1.0, [0.0; 3]) });
    robot.joint("pan", JointKind::Revolute, "base", "ring").axis(0.0, 0.0, 1.0);
    robot.joint("tilt", JointKind::Revolute, "ring", "rod").axis(0.0, 1.0, 0.0);
    robot.joint("swing", JointKind::Revolute, "rod", "point").axis(0.0, 0.0, 1.0);
    robot.joint("spin", JointKind::Revolute, "base", "wheel").axis(1.0, 0.0, 0.0);
    assert_eq!(robot.build().unwrap().dof(), 4);
}

#[test]
fn a_hundred_thousand_links_in_a_row_do_not_exhaust_the_stack() {
    const LINKS: usize = 100_000;
    for (kind, bodies) in [(JointKind::Fixed, 1), (JointKind::Revolute, LINKS)] {
        let mut robot = RobotDescription::new("snake");
        robot.link("0", solid(1.0, [0.0; 3]));
        for k in 1..LINKS {
            robot.link(k.to_string(), solid(1.0, [0.5, 0.0, 0.0]));
            let joint = robot.joint(k.to_string(), kind, (k - 1).to_string(), k.to_string());
            if kind == JointKind::Revolute && k > 1 {
                joint.mimic((k - 1).to_string(), 1.0, 0.0);
            }
        }
        assert_eq!(robot.build().unwrap().bodies().len(), bodies);
        robot.root = Some((LINKS - 1).to_string());
        assert_eq!(robot.build().unwrap().bodies().len(), bodies);
    }
}

#[test]
fn numbers_that_only_a_program_can_write_are_problems() {
    let mut robot = branched();
    robot.links[0].inertial.mass = f64::NAN;
    robot.links[1].inertial.com.y = f64::INFINITY;
    robot.links[2].inertial.inertia.xx = 1e31;
    robot.joints[0].origin.rotation = -Matrix3::identity();
    robot.joints[1].limits.upper = Some(f64::NEG_INFINITY);
    robot.joints[2].origin.translation.x = f64::NAN;
    robot.joints[3].limits.rotor_inertia = f64::NAN;
    let found: Vec<String> =
        robot.build().unwrap_err().problems().iter().map(|p| format!("{}: {}", p.subject, p.found)).collect();
    assert_eq!(
        found,
        [
            "link 'b': mass is NaN",
            "link 'a': centre of mass is 0.25 inf -0.125",
            "link 'shell': inertia (xx xy xz yy yz zz) is 1e31 0.125 -0.0625 0.625 0.03125 0.75",
            "joint 'base_a': the orientation of the origin is no rotation matrix: RᵀR is off by 0, det R is -1",
            "joint 'a_b': limit is -inf",
            "joint 'base_shell': origin is NaN 0 0",
            "joint 'base_c': dynamics (damping friction rotor-inertia) is 0 0 NaN",
        ]
    );
}

#[test]
fn a_model_is_shared_between_threads() {
    fn shared<T: Send + Sync>() {}
    shared::<Model>();
}
