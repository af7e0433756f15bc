//! The pieces of work that are timed.

use frs_core::Quantity;

/// A piece of work, one call a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// All that depends on q alone, before a matrix is asked for.
    PositionSweep,
    /// The inertia matrix M of (V₁, q̇): peers only.
    Mass,
    /// Λ_b, A_l, Λ_q.
    Inertia,
    /// Λ_b, A_l, Λ_q, D_μ, B_2.
    Matrices,
    /// The same with D_q̇.
    AllD,
    /// ξ̇ by factoring Λ_q.
    ForwardFactored,
    /// ξ̇, or V̇.
    Forward,
    /// 𝓑_ω of all pairs.
    Curvature,
}

impl Work {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::PositionSweep,
        Self::Mass,
        Self::Inertia,
        Self::Matrices,
        Self::AllD,
        Self::ForwardFactored,
        Self::Forward,
        Self::Curvature,
    ];

    /// Its name on the pipe.
    pub fn name(self) -> &'static str {
        match self {
            Self::PositionSweep => "position_sweep",
            Self::Mass => "mass",
            Self::Inertia => "inertia",
            Self::Matrices => "matrices",
            Self::AllD => "all_d",
            Self::ForwardFactored => "forward_factored",
            Self::Forward => "forward",
            Self::Curvature => "curvature",
        }
    }

    /// The questions to a robot that make it up; none where it is not made of questions.
    pub fn quantities(self) -> &'static [Quantity] {
        match self {
            Self::PositionSweep | Self::Mass | Self::ForwardFactored => &[],
            Self::Inertia => &[Quantity::Inertia],
            Self::Matrices => &[Quantity::Matrices],
            Self::AllD => &[Quantity::Matrices, Quantity::DQdot],
            Self::Forward => &[Quantity::ForwardDynamics],
            Self::Curvature => &[Quantity::Curvature],
        }
    }
}
