//! From a checked tree of links to numbered bodies.

use nalgebra::{Matrix3, Vector3};

use super::axis;
use super::mimic::Following;
use super::tree::{Tree, Via};
use crate::model::inertial::weigh;
use crate::model::{
    Body, Coordinate, Drive, Inertial, JointDescription, JointKind, Link, LinkDescription, Model, Motion,
    RobotDescription,
};
use crate::spatial::{Pose, Symmetric3};

/// A model, and where it came from.
pub(super) struct Lowered {
    pub model: Model,
    /// The joint of the description that drives body k + 1.
    pub joints: Vec<usize>,
}

/// Makes the model of a robot in which no error was found.
pub(super) fn lower(robot: &RobotDescription, tree: &Tree, followings: &[Following]) -> Lowered {
    let mut bodies = vec![body(0, 0, Motion::Revolute, Pose::identity())];
    // The joint that drives each body but the base, and what its coordinate's name adds to the joint's.
    let mut drivers: Vec<(usize, &str)> = Vec::new();
    let mut links: Vec<Link> = Vec::with_capacity(tree.steps.len());
    for step in &tree.steps {
        let (mut at, mut number) = (Pose::identity(), 0);
        if let Some(Via { joint, reversed, from }) = step.via {
            let description = &robot.joints[joint];
            (at, number) = (links[from].placement, links[from].body);
            if !reversed {
                at = at * description.origin;
            }
            for Move { motion, axis, suffix } in moves(description, reversed) {
                let turn = axis::along(axis);
                let parent = number;
                number = bodies.len();
                bodies.push(body(number, parent, motion, at * Pose::new(turn, Vector3::zeros())));
                drivers.push((joint, suffix));
                at = Pose::new(turn.transpose(), Vector3::zeros());
            }
            if reversed {
                at = at * description.origin.inverse();
            }
        }
        let LinkDescription { name, inertial } = &robot.links[step.link];
        links.push(Link {
            name: name.clone(),
            body: number,
            placement: at,
            inertial: *inertial,
            massive: inertial.mass > 0.0,
            weighed_at: at.translation,
        });
    }
    for k in (1..bodies.len()).rev() {
        let parent = bodies[k].parent;
        bodies[parent].end = bodies[parent].end.max(bodies[k].end);
    }
    weigh_bodies(&links, &mut bodies);
    centre_base(&mut bodies, &mut links);
    let coordinates = drive(robot, followings, &drivers, &mut bodies);
    let has_mimic = bodies.len() > coordinates.len() + 1;
    // Adding 0 makes 0 of −0.
    let model = Model { name: robot.name.clone(), bodies, links, coordinates, has_mimic, warnings: Vec::new() }
        .map(|number| number + 0.0);
    Lowered { model, joints: drivers.into_iter().map(|(joint, _)| joint).collect() }
}

/// A body without mass.
fn body(number: usize, parent: usize, motion: Motion, placement: Pose<f64>) -> Body {
    Body {
        parent,
        end: number + 1,
        motion,
        placement,
        drive: Drive { coordinate: 0, ratio: 1.0, offset: 0.0 },
        mass: 0.0,
        com: Vector3::zeros(),
        inertia: Symmetric3::zero(),
        least_moment: 0,
    }
}

/// One of the motions that a joint is made of.
struct Move {
    motion: Motion,
    axis: Vector3<f64>,
    suffix: &'static str,
}

/// The motions of a joint in the order in which they are met; crossed backwards, `J_a(q)⁻¹ = J_{−a}(q)`.
fn moves(joint: &JointDescription, reversed: bool) -> Vec<Move> {
    let one = |motion, axis, suffix| Move { motion, axis, suffix };
    let mut moves = match joint.kind {
        JointKind::Fixed | JointKind::Floating => vec![],
        JointKind::Revolute | JointKind::Continuous => vec![one(Motion::Revolute, joint.axis, "")],
        JointKind::Prismatic => vec![one(Motion::Prismatic, joint.axis, "")],
        JointKind::Planar => {
            let plane: Matrix3<f64> = axis::along(joint.axis);
            vec![
                one(Motion::Prismatic, plane.column(0).into(), "_x"),
                one(Motion::Prismatic, plane.column(1).into(), "_y"),
                one(Motion::Revolute, joint.axis, "_yaw"),
            ]
        }
    };
    if reversed {
        moves.reverse();
        moves.iter_mut().for_each(|one| one.axis = -one.axis);
    }
    moves
}

/// Gives each body the masses of its links.
fn weigh_bodies(links: &[Link], bodies: &mut [Body]) {
    let mut parts: Vec<Vec<&Link>> = vec![Vec::new(); bodies.len()];
    links.iter().for_each(|link| parts[link.body].push(link));
    for (body, parts) in bodies.iter_mut().zip(&parts) {
        Inertial { mass: body.mass, com: body.com, inertia: body.inertia } = weigh(parts);
        let Symmetric3 { xx, yy, zz, .. } = body.inertia;
        let least = [xx, yy, zz].into_iter().enumerate().min_by(|(_, a), (_, b)| a.total_cmp(b));
        body.least_moment = least.map_or(0, |(axis, _)| axis);
    }
}

/// Moves the origin of the base body to its centre of mass.
fn centre_base(bodies: &mut [Body], links: &mut [Link]) {
    let com = std::mem::replace(&mut bodies[0].com, Vector3::zeros());
    for link in links.iter_mut().filter(|link| link.body == 0) {
        link.placement.translation -= com;
    }
    for body in bodies[1..].iter_mut().filter(|body| body.parent == 0) {
        body.placement.translation -= com;
    }
}

/// Numbers the coordinates in the order of the bodies they drive first, and lets followers follow.
fn drive(
    robot: &RobotDescription,
    followings: &[Following],
    drivers: &[(usize, &str)],
    bodies: &mut [Body],
) -> Vec<Coordinate> {
    let mut coordinates = Vec::new();
    let mut coordinate_of = vec![0; robot.joints.len()];
    let driven = || (1..).zip(drivers.iter().copied());
    for (body, (joint, suffix)) in driven().filter(|(_, (joint, _))| followings[*joint].leader == *joint) {
        let description = &robot.joints[joint];
        coordinate_of[joint] = coordinates.len();
        bodies[body].drive.coordinate = coordinates.len();
        coordinates.push(Coordinate {
            name: format!("{}{suffix}", description.name),
            body,
            limits: description.limits,
            continuous: description.kind == JointKind::Continuous,
        });
    }
    for (body, (joint, _)) in driven().filter(|(_, (joint, _))| followings[*joint].leader != *joint) {
        let Following { leader, ratio, offset } = followings[joint];
        bodies[body].drive = Drive { coordinate: coordinate_of[leader], ratio, offset };
    }
    coordinates
}
