//! The same robot in Hamel form, `M(q) V̇ + C(q, V) V = [F₁; τ]` with `V = [V₁; q̇]`: what other libraries compute.

mod bias;
mod coriolis;
mod dynamics;
mod inertia;
