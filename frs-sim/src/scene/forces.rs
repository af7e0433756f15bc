//! The effects' tables.

use frs_core::Model;

use super::added_mass;
use super::columns;
use super::force::{EFFECTS, Force, Named};
use super::payload;
use super::reader::{Item, Table};
use super::timing::{self, Timing};
use crate::effects::{
    Axes, Contact, Coulomb, Decoupling, Drag, Gains, Gravity, JointTorque, LinkWrench, Spring, Target, Viscous,
};
use crate::motion::Course;
use crate::signal::Signal;

pub fn read(root: &Table<'_, '_>, model: &Model, duration: f64) -> Vec<Named> {
    let mut forces = Vec::new();
    for key in EFFECTS {
        if key == "added_mass" {
            forces.extend(added_mass::read(root, model));
            continue;
        }
        for table in root.tables(key) {
            let read = match key {
                "gravity" => gravity(&table).into_iter().collect(),
                "wrench" => wrench(&table, model, duration).into_iter().collect(),
                "drag" => drag(&table, model).into_iter().collect(),
                "contact" => contact(&table, model).into_iter().collect(),
                "joint_torque" => joint_torque(&table, model, duration).into_iter().collect(),
                "friction" => friction(&table, model),
                "spring" => spring(&table, model).into_iter().collect(),
                "stops" => stops(&table, model).into_iter().collect(),
                "rotors" => rotors(&table, model).into_iter().collect(),
                "prescribed" => prescribed(&table, model).into_iter().collect(),
                "payload" => payload::read(&table, model, duration).map(Force::Payload).into_iter().collect(),
                "regulator" => regulator(&table, model).into_iter().collect(),
                "computed_torque" => computed_torque(&table, model).into_iter().collect(),
                _ => end_effector(&table, model).into_iter().collect::<Vec<_>>(),
            };
            forces.extend(read.into_iter().map(|force| Named { force, line: table.line() }));
        }
    }
    forces
}

/// Notes forces that cannot be together.
pub fn contradictions(root: &Table<'_, '_>, model: &Model, forces: &[Named]) {
    added_mass::contradictions(root, forces);
    let mut lines: Vec<Option<usize>> = vec![None; model.dof()];
    for named in forces {
        if let Force::Prescribed(i, _) = named.force
            && let Some(line) = lines[i].replace(named.line)
        {
            let name = &model.coordinates()[i].name;
            root.refuse(format!("{name} is prescribed in line {line} and in line {}; expected one course", named.line));
        }
    }
    for named in forces {
        if let Force::JointTorque(torque) = &named.force {
            for (i, line) in lines.iter().enumerate() {
                if let (Some(line), false) = (line, torque.tau[i].is_always_zero()) {
                    let name = &model.coordinates()[i].name;
                    root.refuse(format!(
                        "{name} is prescribed in line {line} and has a torque in line {}; expected one of the two: its torque is what the course takes",
                        named.line
                    ));
                }
            }
        }
    }
}

const ONE_OR_EACH: &str = "one for all or one each";

fn gravity(table: &Table<'_, '_>) -> Option<Force> {
    table.only(&["acceleration"]);
    let what = "three numbers, m/s², in world axes";
    let acceleration = table.required("acceleration", what)?.numbers(what)?;
    Some(Force::Gravity(Gravity { acceleration }))
}

/// Three numbers, zeros if they are not given.
fn three(table: &Table<'_, '_>, key: &str, what: &str) -> Option<[f64; 3]> {
    table.get(key).map_or(Some([0.0; 3]), |item| item.numbers(what))
}

fn wrench(table: &Table<'_, '_>, model: &Model, duration: f64) -> Option<Force> {
    table.only(&["link", "point", "moment", "force", "axes", "start", "end", "times", "csv"]);
    let link = table.get("link").map_or(Some(None), |item| item.link(model).map(Some));
    let point = three(table, "point", "x, y, z in m, link frame");
    let axes = [("link", Axes::Link), ("world", Axes::World)];
    let axes = table.get("axes").map_or(Some(Axes::Link), |item| item.choice(&axes));
    let others = ["moment", "force", "start", "end", "times"];
    if let Some(columns) = columns::read(table, &others, 6, "moment (N·m) and force (N), three numbers each")? {
        let wrench = columns.signals(Signal::linear).try_into().ok()?;
        return Some(Force::Wrench(Box::new(LinkWrench { link: link?, point: point?, wrench, axes: axes? })));
    }
    let timing = timing::read(table, duration);
    let (moment, force) = (table.get("moment"), table.get("force"));
    if moment.is_none() && force.is_none() {
        table.refuse("no wrench; expected moment, force, or both");
        return None;
    }
    let timing = timing?;
    let signals = |item: Option<Item<'_, '_>>, what: &str| match item {
        None => Some(vec![Signal::constant(0.0); 3]),
        Some(item) => timing.signals(&item, |item| item.numbers::<3>(what).map(|three| three.to_vec())),
    };
    let (moment, force) = (signals(moment, "three numbers, N·m"), signals(force, "three numbers, N"));
    let wrench = [moment?, force?].concat().try_into().ok()?;
    Some(Force::Wrench(Box::new(LinkWrench { link: link?, point: point?, wrench, axes: axes? })))
}

fn drag(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["link", "rotational", "translational", "current"]);
    let link = table.required("link", "the name of a link").and_then(|item| item.link(model));
    let coefficients = |key: &str, what: &str| {
        let three = three(table, key, what)?;
        match three.iter().find(|by| **by < 0.0) {
            Some(by) => table.get(key)?.refuse(format!("found {by}; expected no negative number")),
            None => Some(three),
        }
    };
    let rotational = coefficients("rotational", "three numbers, N·m·s/rad, about the axes of the link");
    let translational = coefficients("translational", "three numbers, N·s/m, along the axes of the link");
    let current = three(table, "current", "three numbers, m/s, in world axes");
    let drag = Drag { link: link?, rotational: rotational?, translational: translational?, current: current? };
    Some(Force::Drag(drag))
}

fn contact(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["link", "point", "normal", "offset", "stiffness", "dissipation", "friction", "smooth_below"]);
    let link = table.required("link", "the name of a link").and_then(|item| item.link(model));
    let point = three(table, "point", "x, y, z in m, link frame");
    let normal = table.get("normal").map_or(Some([0.0, 0.0, 1.0]), |item| {
        let normal = item.numbers::<3>("the plane's normal, world axes")?;
        let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length > 0.0 && length.is_finite() {
            Some(normal.map(|x| x / length))
        } else {
            item.refuse("the plane has no normal; expected a direction")
        }
    });
    let offset = table.get("offset").map_or(Some(0.0), |item| item.number());
    let stiffness = table.required("stiffness", "N/m^1.5").and_then(|item| item.positive());
    let dissipation = table.get("dissipation").map_or(Some(0.0), |item| item.not_negative());
    let friction = table.get("friction").map_or(Some(0.0), |item| item.not_negative());
    let smooth_below = smooth_below(table);
    Some(Force::Contact(Contact {
        link: link?,
        point: point?,
        normal: normal?,
        offset: offset?,
        stiffness: stiffness?,
        dissipation: dissipation?,
        friction: friction?,
        smooth_below: smooth_below?,
        touches: false,
    }))
}

/// The rate or velocity below which friction passes from one side to the other.
fn smooth_below(table: &Table<'_, '_>) -> Option<f64> {
    /// rad/s, m/s: less than is seen, more than makes the equations stiff.
    const OTHERWISE: f64 = 0.01;
    table.get("smooth_below").map_or(Some(OTHERWISE), |item| item.positive())
}

fn joint_torque(table: &Table<'_, '_>, model: &Model, duration: f64) -> Option<Force> {
    table.only(&["tau", "start", "end", "times", "csv"]);
    let what = "a torque for each coordinate, N·m or N";
    if let Some(columns) = columns::read(table, &["tau", "start", "end", "times"], model.dof(), what)? {
        return Some(Force::JointTorque(JointTorque { tau: columns.signals(Signal::linear) }));
    }
    let timing = timing::read(table, duration);
    let tau = table.required("tau", what)?;
    let tau = timing?.signals(&tau, |item| item.coordinates(model))?;
    Some(Force::JointTorque(JointTorque { tau }))
}

fn friction(table: &Table<'_, '_>, model: &Model) -> Vec<Force> {
    table.only(&["viscous", "coulomb", "smooth_below"]);
    let (viscous, coulomb) = (table.get("viscous"), table.get("coulomb"));
    if viscous.is_none() && coulomb.is_none() {
        table.refuse("no friction; expected viscous (N·m·s/rad or N·s/m), coulomb (N·m or N), or both");
    }
    if let (None, Some(item)) = (&coulomb, table.get("smooth_below")) {
        item.refuse::<()>("nothing is made smooth; expected coulomb, too");
    }
    let smooth_below = smooth_below(table);
    let viscous = viscous.and_then(|item| Some(Force::Viscous(Viscous { damping: item.gains(model)? })));
    let coulomb = coulomb.and_then(|item| item.gains(model));
    let coulomb = coulomb.and_then(|torque| Some(Force::Coulomb(Coulomb { torque, smooth_below: smooth_below? })));
    viscous.into_iter().chain(coulomb).collect()
}

fn spring(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["stiffness", "rest"]);
    let what = format!("N·m/rad or N/m, {ONE_OR_EACH}");
    let stiffness = table.required("stiffness", &what).and_then(|item| item.gains(model));
    let rest = table.get("rest").map_or_else(|| Some(vec![0.0; model.dof()]), |item| item.coordinates(model));
    Some(Force::Spring(Spring { stiffness: stiffness?, rest: rest? }))
}

fn stops(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["stiffness", "dissipation"]);
    let stiffness = table.required("stiffness", "N·m/rad or N/m").and_then(|item| item.positive());
    let dissipation = table.get("dissipation").map_or(Some(0.0), |item| item.not_negative());
    let limited = |c: &frs_core::model::Coordinate| c.limits.lower.is_some() || c.limits.upper.is_some();
    if !model.coordinates().iter().any(limited) {
        table.refuse("no joint of the robot has a limit; expected a URDF with lower and upper in <limit>, or no stops");
    }
    Some(Force::Stops { stiffness: stiffness?, dissipation: dissipation? })
}

fn rotors(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["inertia"]);
    let what = format!("kg·m² or kg as the joint feels them, {ONE_OR_EACH}");
    Some(Force::Rotors(table.required("inertia", &what)?.gains(model)?))
}

fn prescribed(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["joint", "hold", "sinusoid", "times", "values", "csv"]);
    let joint = table.required("joint", "the name of a coordinate").and_then(|item| item.coordinate(model));
    let ways: Vec<&str> =
        ["hold", "sinusoid", "times", "csv"].into_iter().filter(|way| table.get(way).is_some()).collect();
    let course = match ways.as_slice() {
        ["hold"] => Course::Pieces(Signal::constant(table.get("hold")?.number()?)),
        ["sinusoid"] => sinusoid(&table.get("sinusoid")?.table()?)?,
        ["times"] => {
            let times = table.get("times")?.times()?;
            let values = table.required("values", "a value for each time, rad or m")?;
            let list = values.list("a value for each time, rad or m")?;
            if list.len() != times.len() {
                return values.refuse(format!(
                    "found {} numbers; expected {}, one for each time",
                    list.len(),
                    times.len()
                ));
            }
            Course::Pieces(Signal::spline(&times, &list))
        }
        ["csv"] => {
            let columns = columns::read(table, &["values"], 1, "a value (rad, m)")??;
            Course::Pieces(columns.signals(Signal::spline).pop()?)
        }
        _ => {
            table.refuse(format!(
                "found {} courses; expected one of hold, sinusoid, times with values, csv",
                ways.len()
            ));
            return None;
        }
    };
    Some(Force::Prescribed(joint?, course))
}

fn sinusoid(table: &Table<'_, '_>) -> Option<Course> {
    table.only(&["offset", "amplitude", "rate", "phase"]);
    let number = |key: &str| table.get(key).map_or(Some(0.0), |item| item.number());
    let amplitude = table.required("amplitude", "half of the motion's width, rad or m").and_then(|item| item.number());
    let rate = table.required("rate", "the angular frequency, rad/s").and_then(|item| item.number());
    let (offset, phase) = (number("offset"), number("phase"));
    Some(Course::Sinusoid { offset: offset?, amplitude: amplitude?, rate: rate?, phase: phase? })
}

fn regulator(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["set_point", "stiffness", "damping", "decoupling"]);
    let set_point = table.required("set_point", "a value for each coordinate, rad or m");
    let set_point = set_point.and_then(|item| item.coordinates(model));
    let stiffness = table.required("stiffness", &format!("N·m/rad or N/m, {ONE_OR_EACH}")).and_then(|i| i.gains(model));
    let damping = table.required("damping", &format!("N·m·s/rad or N·s/m, {ONE_OR_EACH}")).and_then(|i| i.gains(model));
    let ways = [("none", Decoupling::None), ("tau_bar", Decoupling::TauBar), ("coupling", Decoupling::Coupling)];
    let decoupling = table.get("decoupling").map_or(Some(Decoupling::None), |item| item.choice(&ways));
    let (set_point, stiffness, damping) = (set_point?, stiffness?, damping?);
    Some(Force::Regulator(Gains { set_point, stiffness, damping, decoupling: decoupling? }))
}

fn computed_torque(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["bandwidth", "set_point", "times", "csv"]);
    let bandwidth = table.required("bandwidth", "rad/s").and_then(|item| item.positive());
    let what = "a value for each coordinate, rad or m";
    if let Some(columns) = columns::read(table, &["set_point", "times"], model.dof(), what)? {
        let courses = columns.signals(Signal::spline).into_iter().map(Course::Pieces).collect();
        return Some(Force::ComputedTorque(courses, bandwidth?));
    }
    let goal = table.required("set_point", &format!("{what}; with times, one such for each time"));
    let times = table.get("times").map_or(Some(None), |item| item.times().map(Some));
    let goal = goal?;
    let columns = match times? {
        None => goal.coordinates(model)?.into_iter().map(Signal::constant).collect(),
        Some(times) => Timing::Points(times).columns(&goal, |item| item.coordinates(model), Signal::spline)?,
    };
    Some(Force::ComputedTorque(columns.into_iter().map(Course::Pieces).collect(), bandwidth?))
}

fn end_effector(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["link", "position", "stiffness", "damping", "joint_damping"]);
    let link = table.required("link", "the name of a link").and_then(|item| item.link(model));
    let what = "x, y, z in m, world";
    let position = table.required("position", what).and_then(|item| item.numbers(what));
    let stiffness = table.required("stiffness", "N/m").and_then(|item| item.not_negative());
    let damping = table.required("damping", "N·s/m").and_then(|item| item.not_negative());
    let joint_damping =
        table.get("joint_damping").map_or_else(|| Some(vec![0.0; model.dof()]), |item| item.gains(model));
    let (link, position, stiffness, damping) = (link?, position?, stiffness?, damping?);
    Some(Force::EndEffector(Target { link, position, stiffness, damping, joint_damping: joint_damping? }))
}
