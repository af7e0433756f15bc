//! What a scene can name.

use super::payload::Payload;
use crate::effects::{
    AddedMass, Contact, Coulomb, Decoupling, Drag, Gains, Gravity, JointTorque, LinkWrench, Spring, Target, Viscous,
};
use crate::motion::Course;
use crate::signal::Signal;

/// An effect as a scene tells it.
#[derive(Clone, Debug, PartialEq)]
pub enum Force {
    /// `[gravity]`
    Gravity(Gravity),
    /// `[wrench]`
    Wrench(Box<LinkWrench>),
    /// `[drag]`
    Drag(Drag),
    /// `[contact]`
    Contact(Contact),
    /// `[joint_torque]`
    JointTorque(JointTorque),
    /// `[friction]`, viscous
    Viscous(Viscous),
    /// `[friction]`, Coulomb's
    Coulomb(Coulomb),
    /// `[spring]`
    Spring(Spring),
    /// `[stops]`: stiffness and dissipation
    Stops {
        /// k, N·m/rad, N/m.
        stiffness: f64,
        /// c, s/rad, s/m.
        dissipation: f64,
    },
    /// `[rotors]`: what they add to the shape inertia, one per coordinate
    Rotors(Vec<f64>),
    /// `[prescribed]`: a coordinate and what it does
    Prescribed(usize, Course),
    /// `[payload]`
    Payload(Payload),
    /// `[regulator]`
    Regulator(Gains),
    /// `[computed_torque]`: courses, one per coordinate, and the bandwidth
    ComputedTorque(Vec<Course>, f64),
    /// `[end_effector]`
    EndEffector(Target),
    /// `[added_mass]`, all of them: links, and how the water moves (m/s, world axes)
    AddedMass(Vec<AddedMass>, [f64; 3]),
}

/// An effect and where the scene names it.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// The effect.
    pub force: Force,
    /// Line of the file.
    pub line: usize,
}

/// Keys of a scene that are effects, in the order in which they act.
pub const EFFECTS: [&str; 15] = [
    "gravity",
    "wrench",
    "drag",
    "contact",
    "joint_torque",
    "friction",
    "spring",
    "stops",
    "rotors",
    "prescribed",
    "payload",
    "regulator",
    "computed_torque",
    "end_effector",
    "added_mass",
];

impl Force {
    /// The key of its table.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Gravity(_) => "gravity",
            Self::Wrench(_) => "wrench",
            Self::Drag(_) => "drag",
            Self::Contact(_) => "contact",
            Self::JointTorque(_) => "joint_torque",
            Self::Viscous(_) | Self::Coulomb(_) => "friction",
            Self::Spring(_) => "spring",
            Self::Stops { .. } => "stops",
            Self::Rotors(_) => "rotors",
            Self::Prescribed(..) => "prescribed",
            Self::Payload(_) => "payload",
            Self::Regulator(_) => "regulator",
            Self::ComputedTorque(..) => "computed_torque",
            Self::EndEffector(_) => "end_effector",
            Self::AddedMass(..) => "added_mass",
        }
    }

    /// Whether it can change the momentum about the centre of mass.
    pub fn drives_momentum(&self) -> bool {
        matches!(self, Self::Wrench(_) | Self::Drag(_) | Self::Contact(_) | Self::AddedMass(..))
    }

    /// The name of its work; none for what does none: rotors are kinetic energy, and payloads are told together.
    pub(super) fn work(&self) -> Option<&'static str> {
        match self {
            Self::Rotors(_) | Self::Payload(_) => None,
            Self::Viscous(_) => Some("viscous_friction"),
            Self::Coulomb(_) => Some("coulomb_friction"),
            _ => Some(self.key()),
        }
    }

    /// What it adds, as a formula.
    pub fn equation(&self) -> &'static str {
        match self {
            Self::Gravity(_) => "ξ̇ += [0; R₁ᵀ a; 0]",
            Self::Wrench(wrench) if wrench.link.is_none() => "F₁ += [m + p × f; f]",
            Self::Wrench(_) => "F₁ += X_kᵀ F_k, τ += J_kᵀ F_k,  F_k = [m + p × f; f]",
            Self::Drag(_) => "F₁ += X_kᵀ F_k, τ += J_kᵀ F_k,  F_k = −D (V_k − u)",
            Self::Contact(_) => "F₁ += X_kᵀ F_k, τ += J_kᵀ F_k,  N = k d^{3/2} (1 + c ḋ)",
            Self::JointTorque(_) => "τ += τ(t)",
            Self::Viscous(_) => "τ −= d q̇",
            Self::Coulomb(_) => "τ −= c q̇ / √(q̇² + v²)",
            Self::Spring(_) => "τ −= k (q − r)",
            Self::Stops { .. } => "τ ± = k d (1 + c ḋ)",
            Self::Rotors(_) => "Λ_q += J",
            Self::Prescribed(..) => "q = q(t), τ as it takes",
            Self::Payload(_) => "Λ_b, A_l, Λ_q, … of the robot with it",
            Self::Regulator(gains) => match gains.decoupling {
                Decoupling::None => "τ −= K (q − q_d) + D q̇",
                Decoupling::Coupling => "τ −= K (q − q_d) + D q̇ + c(μ)",
                Decoupling::TauBar => "τ −= K (q − q_d) + D q̇ + c(μ) − B_2(μ) q̇",
            },
            Self::ComputedTorque(..) => "τ += Λ_q (q̈_d − 2 ω ė − ω² e) + Γ'_q q̇ + 2 B_2 q̇ − c(μ)",
            Self::EndEffector(_) => "τ −= J̃_kᵀ [0; R_kᵀ K (x − x_d) + D v_k] + c(μ) + D_q q̇",
            Self::AddedMass(..) => "F₁ += X_kᵀ F_k, τ += J_kᵀ F_k,  F_k = ad_Vᵀ M_A V − M_A V̇",
        }
    }

    /// Times at which it jumps, s; increasing, each once.
    pub fn knots(&self) -> Vec<f64> {
        let mut knots: Vec<f64> = match self {
            Self::Wrench(wrench) => wrench.wrench.iter().flat_map(Signal::knots).copied().collect(),
            Self::JointTorque(torque) => torque.tau.iter().flat_map(Signal::knots).copied().collect(),
            Self::Prescribed(_, course) => course.knots().to_vec(),
            Self::Payload(payload) => payload.grasp.into_iter().chain(payload.release).collect(),
            Self::ComputedTorque(courses, _) => courses.iter().flat_map(Course::knots).copied().collect(),
            _ => Vec::new(),
        };
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        knots
    }
}
