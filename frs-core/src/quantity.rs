//! The questions a robot answers, with fixed signatures.
//!
//! [`Shape`](crate::Shape) and [`Moving`](crate::Moving) answer anything about a robot that was read at run time. A
//! [`Quantity`] is a question with a fixed signature, plain numbers in and out, so that a robot whose code was generated
//! answers it in the same way: [`FloatingBase`](crate::FloatingBase) is implemented by both.

/// A question about a robot at a state. All matrices are column by column, six-vectors angular part first.
///
/// ```
/// use frs_core::Quantity;
/// assert_eq!(Quantity::B2.inputs().map(|input| input.name).collect::<Vec<_>>(), ["q", "mu"]);
/// assert_eq!(Quantity::Inertia.outputs().last().unwrap().shape(7), [7, 7]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Quantity {
    /// Λ_b, A_l and Λ_q.
    Inertia,
    /// D_μ, the Coriolis terms linear in the locked velocity.
    DMu,
    /// B_2, how momentum feels the curvature.
    B2,
    /// [`Inertia`](Self::Inertia), [`DMu`](Self::DMu) and [`B2`](Self::B2) at once, sharing their work.
    Matrices,
    /// D_q̇, the Coriolis terms in the shape velocity alone.
    DQdot,
    /// The (μ, μ) term of the shape equation.
    CouplingTorque,
    /// D_μ ξ without forming D_μ.
    DMuXi,
    /// D_q̇ ξ without forming D_q̇.
    DQdotXi,
    /// C V, the bias force in base velocity and joint rates.
    HamelBias,
    /// 𝓑, the curvature of the connection, all pairs.
    Curvature,
    /// The momentum of the body and about the centre of mass.
    Momentum,
    /// μ = Λ_b⁻¹ p, the locked velocity that a momentum gives.
    VelocityOfMomentum,
    /// V₁ = μ − A_l q̇, which reconstructs the base's motion.
    BaseTwist,
    /// ½ ξᵀ Λ ξ.
    KineticEnergy,
    /// ξ̇ from forces.
    ForwardDynamics,
    /// [`BaseTwist`](Self::BaseTwist) and [`ForwardDynamics`](Self::ForwardDynamics) at once: what an integrator asks of a state.
    StateRate,
    /// Forces from ξ̇.
    InverseDynamics,
    /// Pose and generalized Jacobian of a link, by its number ([`Model::link`](crate::Model::link)).
    Kinematics(usize),
}

/// One input or output of a [`Quantity`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Argument {
    /// Name, as NOTATION.md spells it.
    pub name: &'static str,
    /// Symbol.
    pub symbol: &'static str,
    /// What it is, in which frame.
    pub meaning: &'static str,
    /// Unit, without those of the coordinates.
    pub unit: &'static str,
    shape: [Extent; 2],
    layers: usize,
}

/// A length `constant + n·per_coordinate`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Extent {
    constant: usize,
    per_coordinate: usize,
}

const fn fixed(constant: usize) -> Extent {
    Extent { constant, per_coordinate: 0 }
}
const N: Extent = Extent { constant: 0, per_coordinate: 1 };
const SIX_AND_N: Extent = Extent { constant: 6, per_coordinate: 1 };
const ONE: Extent = fixed(1);
const THREE: Extent = fixed(3);
const SIX: Extent = fixed(6);

const fn argument(
    name: &'static str,
    symbol: &'static str,
    shape: [Extent; 2],
    unit: &'static str,
    meaning: &'static str,
) -> Argument {
    Argument { name, symbol, meaning, unit, shape, layers: 1 }
}

const Q: Argument = argument("q", "q", [N, ONE], "rad, m", "shape");
const QD: Argument = argument("qd", "q̇", [N, ONE], "rad/s, m/s", "shape velocity");
const MU: Argument = argument("mu", "μ", [SIX, ONE], "rad/s, m/s", "locked velocity, base frame");
const BASE: Argument = argument("base_twist", "V₁", [SIX, ONE], "rad/s, m/s", "body twist of the base, base frame");
const GRAVITY: Argument = argument("gravity", "γ", [THREE, ONE], "m/s²", "acceleration of free fall, base axes");
const F1: Argument = argument("base_wrench", "F₁", [SIX, ONE], "N·m, N", "wrench on the base, base frame");
const TAU: Argument = argument("tau", "τ", [N, ONE], "N·m, N", "joint torques");
const XI_DOT: Argument = argument("xi_dot", "ξ̇ = [μ̇; q̈]", [SIX_AND_N, ONE], "rad/s², m/s²", "acceleration, base frame");
const LAMBDA_B: Argument =
    argument("locked_inertia", "Λ_b", [SIX, SIX], "kg·m², kg·m, kg", "inertia with the joints locked, base frame");
const A_L: Argument =
    argument("connection", "A_l", [SIX, N], "rad, m", "local mechanical connection, base frame: V₁ = −A_l q̇ at rest");
const LAMBDA_Q: Argument =
    argument("shape_inertia", "Λ_q", [N, N], "kg·m²", "inertia that the joints feel on the floating base");
const D_MU: Argument =
    argument("d_mu", "D_μ", [SIX_AND_N, SIX_AND_N], "Λ's · 1/s", "Coriolis terms linear in μ, skew, base frame");
const B_2: Argument =
    argument("b2", "B_2(μ)", [N, N], "kg·m²/s", "how momentum feels the curvature, skew: −½ ⟨Λ_b μ, 𝓑(e_i, e_j)⟩");
const D_QDOT: Argument =
    argument("d_qdot", "D_q̇", [SIX_AND_N, SIX_AND_N], "Λ's · 1/s", "diag(½ P(q̇), Γ'_q(q̇)), base frame");
const COUPLING: Argument =
    argument("coupling_torque", "(S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}) μ", [N, ONE], "N·m, N", "what turning as one body asks");
const D_MU_XI: Argument = argument("d_mu_xi", "D_μ ξ", [SIX_AND_N, ONE], "N·m, N", "D_μ on ξ = [μ; q̇], base frame");
const D_QDOT_XI: Argument = argument("d_qdot_xi", "D_q̇ ξ", [SIX_AND_N, ONE], "N·m, N", "D_q̇ on ξ, base frame");
const HAMEL_BIAS: Argument =
    argument("hamel_bias", "C V", [SIX_AND_N, ONE], "N·m, N", "Coriolis force on V = [V₁; q̇], base frame");
const CURVATURE: Argument = Argument {
    layers: 3,
    ..argument("curvature", "𝓑_ω(e_i, e_j)", [N, N], "rad", "angular part of the curvature, base axes: x, y, z")
};
const COM: Argument = argument("com", "c", [THREE, ONE], "m", "total centre of mass, base frame; 𝓑_v = c × 𝓑_ω");
const MOMENTUM: Argument = argument("body_momentum", "Λ_b μ", [SIX, ONE], "kg·m²/s, kg·m/s", "momentum, base frame");
const CENTROIDAL: Argument =
    argument("centroidal_momentum", "Λ_c μ", [SIX, ONE], "kg·m²/s, kg·m/s", "momentum about c, base axes");
const ENERGY: Argument = argument("kinetic_energy", "½ ξᵀ Λ ξ", [ONE, ONE], "J", "kinetic energy");
const POSE: Argument =
    argument("pose", "g_k = [R p]", [THREE, fixed(4)], "m", "rotation and position of the link in the base frame");
const JACOBIAN: Argument = argument(
    "generalized_jacobian",
    "J̃_k = J_k − X_k A_l",
    [SIX, N],
    "rad, m",
    "body Jacobian of the link at zero momentum, link frame",
);

impl Argument {
    /// Rows and columns for a robot of `n` coordinates; a vector is one column.
    pub fn shape(&self, n: usize) -> [usize; 2] {
        self.shape.map(|extent| extent.constant + n * extent.per_coordinate)
    }

    /// How many matrices of this shape follow each other: 3 for the curvature, else 1.
    pub fn layers(&self) -> usize {
        self.layers
    }

    /// How many numbers it has for a robot of `n` coordinates.
    pub fn len(&self, n: usize) -> usize {
        let [rows, columns] = self.shape(n);
        rows * columns * self.layers
    }
}

impl Quantity {
    /// Every quantity of a robot as a whole; [`Kinematics`](Self::Kinematics) is asked link by link.
    pub const ALL: [Self; 17] = [
        Self::Inertia,
        Self::DMu,
        Self::B2,
        Self::Matrices,
        Self::DQdot,
        Self::CouplingTorque,
        Self::DMuXi,
        Self::DQdotXi,
        Self::HamelBias,
        Self::Curvature,
        Self::Momentum,
        Self::VelocityOfMomentum,
        Self::BaseTwist,
        Self::KineticEnergy,
        Self::ForwardDynamics,
        Self::StateRate,
        Self::InverseDynamics,
    ];

    /// Its name, as users write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Inertia => "inertia",
            Self::DMu => "d_mu",
            Self::B2 => "b2",
            Self::Matrices => "matrices",
            Self::DQdot => "d_qdot",
            Self::CouplingTorque => "coupling_torque",
            Self::DMuXi => "d_mu_xi",
            Self::DQdotXi => "d_qdot_xi",
            Self::HamelBias => "hamel_bias",
            Self::Curvature => "curvature",
            Self::Momentum => "momentum",
            Self::VelocityOfMomentum => "velocity_of_momentum",
            Self::BaseTwist => "base_twist",
            Self::KineticEnergy => "kinetic_energy",
            Self::ForwardDynamics => "forward_dynamics",
            Self::StateRate => "state_rate",
            Self::InverseDynamics => "inverse_dynamics",
            Self::Kinematics(_) => "kinematics",
        }
    }

    /// One sentence: what it computes, by which equation.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Inertia => "The block-diagonal inertia diag(Λ_b, Λ_q) and the connection A_l = Λ_b⁻¹ M_bq.",
            Self::DMu => "D_μ = [[−C_b^μ, −S(μ) − ad~_{Λ_bμ} A_l], [S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}, −2 B_2(μ)]].",
            Self::B2 => "B_2(μ) = Σ_k J̃_kᵀ C(M_k; X_k μ) J̃_k.",
            Self::Matrices => "Λ_b, A_l, Λ_q, D_μ and B_2 at once, sharing their work.",
            Self::DQdot => "D_q̇ = diag(½ P(q̇), Γ'_q(q̇)): dΛ_q/dt = Γ'_q + Γ'_qᵀ, dΛ_b/dt = P(q̇).",
            Self::CouplingTorque => "The (μ, μ) term of the shape equation.",
            Self::DMuXi => "D_μ ξ, without forming D_μ.",
            Self::DQdotXi => "D_q̇ ξ = [½ P(q̇) μ; Γ'_q(q̇) q̇], without forming D_q̇.",
            Self::HamelBias => "C(q, V) V in M V̇ + C V = [F₁; τ], V = [V₁; q̇], by one Newton-Euler sweep.",
            Self::Curvature => "𝓑(e_i, e_j) = ∂_i A_j − ∂_j A_i − ad_{A_i} A_j for all pairs of coordinates.",
            Self::Momentum => "The momentum Λ_b μ, in the base frame and about the centre of mass.",
            Self::VelocityOfMomentum => {
                "μ = Λ_b⁻¹ p: in free flight, where the momentum is known, μ need not be integrated."
            }
            Self::BaseTwist => "V₁ = μ − A_l q̇, which reconstructs the pose of the base: ġ₁ = g₁ V₁^.",
            Self::KineticEnergy => "½ μᵀ Λ_b μ + ½ q̇ᵀ Λ_q q̇.",
            Self::ForwardDynamics => {
                "ξ̇ = Λ⁻¹ (D_μ ξ − D_q̇ ξ + [F₁; τ − A_lᵀ F₁]) + [0; γ; 0], in O(n); factoring Λ_q where joints mimic."
            }
            Self::StateRate => "V₁ = μ − A_l q̇ and ξ̇ at once: the rates of the pose, ġ₁ = g₁ V₁^, and of ξ.",
            Self::InverseDynamics => "[F₁; τ − A_lᵀ F₁] = Λ (ξ̇ − [0; γ; 0]) + D_q̇ ξ − D_μ ξ, in O(n).",
            Self::Kinematics(_) => "Where a link is, and how the joints move it at zero momentum.",
        }
    }

    /// Its inputs, in order.
    pub fn inputs(self) -> impl Iterator<Item = Argument> {
        let inputs: &[Argument] = match self {
            Self::Inertia | Self::Curvature | Self::Kinematics(_) => &[Q],
            Self::DMu | Self::B2 | Self::Matrices | Self::CouplingTorque | Self::Momentum => &[Q, MU],
            Self::VelocityOfMomentum => &[Q, MOMENTUM],
            Self::DQdot => &[Q, QD],
            Self::DMuXi | Self::DQdotXi | Self::BaseTwist | Self::KineticEnergy => &[Q, QD, MU],
            Self::HamelBias => &[Q, QD, BASE],
            Self::ForwardDynamics | Self::StateRate => &[Q, QD, MU, GRAVITY, F1, TAU],
            Self::InverseDynamics => &[Q, QD, MU, GRAVITY, XI_DOT],
        };
        inputs.iter().copied()
    }

    /// Its outputs, in order.
    pub fn outputs(self) -> impl Iterator<Item = Argument> {
        let outputs: &[Argument] = match self {
            Self::Inertia => &[LAMBDA_B, A_L, LAMBDA_Q],
            Self::DMu => &[D_MU],
            Self::B2 => &[B_2],
            Self::Matrices => &[LAMBDA_B, A_L, LAMBDA_Q, D_MU, B_2],
            Self::DQdot => &[D_QDOT],
            Self::CouplingTorque => &[COUPLING],
            Self::DMuXi => &[D_MU_XI],
            Self::DQdotXi => &[D_QDOT_XI],
            Self::HamelBias => &[HAMEL_BIAS],
            Self::Curvature => &[CURVATURE, COM],
            Self::Momentum => &[MOMENTUM, CENTROIDAL],
            Self::VelocityOfMomentum => &[MU],
            Self::BaseTwist => &[BASE],
            Self::KineticEnergy => &[ENERGY],
            Self::ForwardDynamics => &[XI_DOT],
            Self::StateRate => &[BASE, XI_DOT],
            Self::InverseDynamics => &[F1, TAU],
            Self::Kinematics(_) => &[POSE, JACOBIAN],
        };
        outputs.iter().copied()
    }
}
