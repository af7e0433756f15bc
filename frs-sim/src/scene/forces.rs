//! The effects' tables.

use frs_core::Model;
use frs_core::spatial::Wrench;

use super::reader::Table;
use crate::effects::{BaseWrench, Decoupling, Frame, Friction, Gains, Gravity, JointTorque, Spring};

/// An effect as a scene tells it.
#[derive(Clone, Debug, PartialEq)]
pub enum Force {
    /// `[gravity]`
    Gravity(Gravity),
    /// `[base_wrench]`
    BaseWrench(BaseWrench),
    /// `[joint_torque]`
    JointTorque(JointTorque),
    /// `[friction]`
    Friction(Friction),
    /// `[spring]`
    Spring(Spring),
    /// `[regulator]`
    Regulator(Gains),
}

/// An effect and where the scene names it.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// The effect.
    pub force: Force,
    /// Line of the file.
    pub line: usize,
}

/// Keys of a scene that are effects.
pub const EFFECTS: [&str; 6] = ["gravity", "base_wrench", "joint_torque", "friction", "spring", "regulator"];

impl Force {
    /// The key of its table.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Gravity(_) => "gravity",
            Self::BaseWrench(_) => "base_wrench",
            Self::JointTorque(_) => "joint_torque",
            Self::Friction(_) => "friction",
            Self::Spring(_) => "spring",
            Self::Regulator(_) => "regulator",
        }
    }

    /// Whether it can change the momentum.
    pub fn drives_momentum(&self) -> bool {
        matches!(self, Self::Gravity(_) | Self::BaseWrench(_))
    }

    /// What it adds, as a formula.
    pub fn equation(&self) -> &'static str {
        match self {
            Self::Gravity(_) => "ξ̇ += [0; R₁ᵀ a; 0]",
            Self::BaseWrench(_) => "F₁ += [m; f]",
            Self::JointTorque(_) => "τ += τ₀",
            Self::Friction(_) => "τ −= d q̇",
            Self::Spring(_) => "τ −= k (q − r)",
            Self::Regulator(gains) => match gains.decoupling {
                Decoupling::None => "τ −= K (q − q_d) + D q̇",
                Decoupling::Coupling => "τ −= K (q − q_d) + D q̇ + c(μ)",
                Decoupling::TauBar => "τ −= K (q − q_d) + D q̇ + c(μ) − B_2(μ) q̇",
            },
        }
    }
}

pub fn read(root: &Table<'_, '_>, model: &Model, duration: f64) -> Vec<Named> {
    let mut forces = Vec::new();
    for key in EFFECTS {
        for table in root.tables(key) {
            let force = match key {
                "gravity" => gravity(&table),
                "base_wrench" => base_wrench(&table, duration),
                "joint_torque" => joint_torque(&table, model),
                "friction" => friction(&table, model),
                "spring" => spring(&table, model),
                _ => regulator(&table, model),
            };
            forces.extend(force.map(|force| Named { force, line: table.line() }));
        }
    }
    forces
}

fn gravity(table: &Table<'_, '_>) -> Option<Force> {
    table.only(&["acceleration"]);
    let what = "three numbers, m/s², in world axes";
    let acceleration = table.required("acceleration", what)?.numbers(what)?;
    Some(Force::Gravity(Gravity { acceleration }))
}

fn base_wrench(table: &Table<'_, '_>, duration: f64) -> Option<Force> {
    table.only(&["moment", "force", "frame", "start", "end"]);
    let three = |key: &str, what: &str| Some(table.get(key)?.numbers::<3>(what));
    let (moment, force) = (three("moment", "three numbers, N·m"), three("force", "three numbers, N"));
    if moment.is_none() && force.is_none() {
        table.refuse("no wrench; expected moment, force, or both");
        return None;
    }
    let (moment, force) = (moment.unwrap_or(Some([0.0; 3])), force.unwrap_or(Some([0.0; 3])));
    let frame = table
        .get("frame")
        .map_or(Some(Frame::Base), |item| item.choice(&[("base", Frame::Base), ("world", Frame::World)]));
    let time = |key: &str, otherwise: f64| table.get(key).map_or(Some(otherwise), |item| item.number());
    let during = time("start", 0.0)?..time("end", f64::INFINITY)?;
    if during.is_empty() || during.end <= 0.0 || during.start >= duration {
        let span = format!("it acts from {} s to {} s", during.start, during.end);
        table.refuse(format!("{span}; expected a start before the end, within the motion's {duration} s"));
        return None;
    }
    let [mx, my, mz] = moment?;
    let [fx, fy, fz] = force?;
    Some(Force::BaseWrench(BaseWrench::new(Wrench::from_array([mx, my, mz, fx, fy, fz]), frame?, during)))
}

fn joint_torque(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["tau"]);
    let tau = table.required("tau", "a torque for each coordinate, N·m or N")?.coordinates(model)?;
    Some(Force::JointTorque(JointTorque { tau }))
}

fn friction(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["viscous"]);
    let viscous = table.required("viscous", "N·m·s/rad or N·s/m, one for all or one each")?.gains(model)?;
    Some(Force::Friction(Friction { viscous }))
}

fn spring(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["stiffness", "rest"]);
    let stiffness = table.required("stiffness", "N·m/rad or N/m, one for all or one each").and_then(|i| i.gains(model));
    let rest = table.get("rest").map_or_else(|| Some(vec![0.0; model.dof()]), |item| item.coordinates(model));
    Some(Force::Spring(Spring { stiffness: stiffness?, rest: rest? }))
}

fn regulator(table: &Table<'_, '_>, model: &Model) -> Option<Force> {
    table.only(&["set_point", "stiffness", "damping", "decoupling"]);
    let set_point = table.required("set_point", "a value for each coordinate, rad or m");
    let set_point = set_point.and_then(|item| item.coordinates(model));
    let stiffness = table.required("stiffness", "N·m/rad or N/m, one for all or one each").and_then(|i| i.gains(model));
    let damping = table.required("damping", "N·m·s/rad or N·s/m, one for all or one each").and_then(|i| i.gains(model));
    let ways = [("none", Decoupling::None), ("tau_bar", Decoupling::TauBar), ("coupling", Decoupling::Coupling)];
    let decoupling = table.get("decoupling").map_or(Some(Decoupling::None), |item| item.choice(&ways));
    let (set_point, stiffness, damping) = (set_point?, stiffness?, damping?);
    Some(Force::Regulator(Gains { set_point, stiffness, damping, decoupling: decoupling? }))
}
