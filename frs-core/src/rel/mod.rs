//! The quantities of the Reduced Euler-Lagrange (REL) equations, one file each; no loop over the tree.
//!
//! `diag(Λ_b, Λ_q) [μ̇; q̈] + D_q̇(q, q̇) ξ = D_μ(q, μ) ξ + [F₁; τ − A_lᵀ F₁]` with `ξ = [μ; q̇]` (the paper, Theorem 1).

mod connection;
mod coriolis;
mod curvature;
mod derivative;
mod equations;
mod inertia;
mod links;
mod momentum;
mod vectors;

pub use curvature::Curvature;
pub use equations::Route;
