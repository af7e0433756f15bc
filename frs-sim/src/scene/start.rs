//! `[start]`: pose, shape and motion at time 0.

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Model, Workspace};
use nalgebra::Vector3;

use super::force::{Force, Named};
use super::reader::Table;

/// A motion at time 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// Pose g₁ of the base in the world.
    pub pose: Pose<f64>,
    /// Shape (rad, m).
    pub q: Vec<f64>,
    /// Shape velocity (rad/s, m/s).
    pub qd: Vec<f64>,
    /// Locked velocity, base frame.
    pub mu: Twist<f64>,
    /// Momentum about the world's origin.
    pub momentum: Wrench<f64>,
    /// Momentum about the centre of mass, world axes.
    pub centroidal: Wrench<f64>,
    /// Centre of mass, m, world.
    pub com: Vector3<f64>,
    /// Total mass, kg.
    pub mass: f64,
}

/// How the motion of the whole can be given.
const WAYS: [&str; 3] = ["mu", "base_twist", "momentum"];

const SIX: &str = "six numbers, angular part first";

pub fn read(root: &Table<'_, '_>, model: &Model, forces: &[Named]) -> Option<Start> {
    let zeros = || Some(vec![0.0; model.dof()]);
    let table = match root.get("start") {
        Some(item) => item.table()?,
        None => root.empty("start"),
    };
    table.only(&["pose", "q", "qd", "mu", "base_twist", "momentum"]);
    let pose = table.get("pose").map_or(Some(Pose::identity()), |item| read_pose(&item.table()?));
    let q = table.get("q").map_or_else(zeros, |item| item.coordinates(model));
    let qd = table.get("qd").map_or_else(zeros, |item| item.coordinates(model));
    let given: Vec<_> = WAYS.iter().filter_map(|way| Some((*way, table.get(way)?))).collect();
    if let [_, (second, item), ..] = given.as_slice() {
        let first = given[0].0;
        return item.refuse(format!("{first} is given, too; expected {first} or {second}: one follows from the other"));
    }
    let motion = given.first().map_or(Some(("mu", [0.0; 6])), |(way, item)| Some((*way, item.numbers(SIX)?)));
    let (pose, mut q, mut qd, (way, motion)) = (pose?, q?, qd?, motion?);
    for named in forces {
        if let Force::Prescribed(i, course) = &named.force {
            let mut course = course.clone();
            course.enter(0.0);
            let [value, rate, _] = course.at(0.0);
            for (key, given, value) in [("q", &mut q[*i], value), ("qd", &mut qd[*i], rate)] {
                if *given != 0.0 && *given != value {
                    let name = &model.coordinates()[*i].name;
                    let (given, line) = (*given, named.line);
                    return table.get(key)?.refuse(format!(
                        "found {given} for {name}; expected {value}, where its course of line {line} begins, or nothing"
                    ));
                }
                *given = value;
            }
        }
    }

    let mut work = Workspace::new(model);
    let mut shape = work.shape(&q);
    let mu = match way {
        "base_twist" => shape.moving(&qd).locked_velocity(Twist::from_array(motion)),
        "momentum" => shape.velocity_of_momentum(pose.inverse().act_wrench(Wrench::from_array(motion))),
        _ => Twist::from_array(motion),
    };
    let momentum = pose.act_wrench(shape.body_momentum(mu));
    if mu.to_array().iter().chain(&momentum.to_array()).any(|x| !x.is_finite()) {
        table.refuse(
            "the momentum here is not finite; expected a shape in which the robot is not singular; move the joints off it",
        );
        return None;
    }
    let centroidal = Pose::new(pose.rotation, Vector3::zeros()).act_wrench(shape.centroidal_momentum(mu));
    let (com, mass) = (pose.transform(shape.com()), shape.locked_inertia().mass);
    Some(Start { pose, q, qd, mu, momentum, centroidal, com, mass })
}

fn read_pose(table: &Table<'_, '_>) -> Option<Pose<f64>> {
    table.only(&["position", "rpy"]);
    let three = |key: &str, what: &str| table.get(key).map_or(Some([0.0; 3]), |item| item.numbers(what));
    let position = three("position", "x, y, z in m");
    let rpy = three("rpy", "roll, pitch, yaw in rad");
    Some(Pose::from_rpy(position?.into(), rpy?))
}
