//! Six-vectors and what acts on them. Knows no robot.
//!
//! Angular part first: a twist is `[ω; v]`, a wrench `[moment; force]`. Twists and wrenches are different types, and
//! their only product is the power [`Twist::dot`].

mod articulated;
mod cross;
mod inertia;
mod pose;
mod product;
mod se3;
mod six;
pub mod so3;
mod stumpff;
mod symmetric3;
mod twist;
mod wrench;

pub use articulated::ArticulatedInertia;
pub use cross::cross_matrix;
pub use inertia::{CoriolisFactor, Inertia};
pub use pose::Pose;
pub(crate) use product::{columns, compose, cross, dot, minus_scaled, plus_scaled, times, transposed_times};
pub use symmetric3::{LdlFactor3, Symmetric3};
pub use twist::Twist;
pub use wrench::Wrench;
