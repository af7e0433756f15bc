//! Integrators on SE(3)×Rᵐ.
//!
//! All follow Munthe-Kaas: a step from the pose g looks for `ζ(t)` with `g(t) = g exp(ζ(t))`, and `ζ̇ = dexp⁻¹_{−ζ} V` is an
//! equation in a vector space, to which a method for vector spaces is applied with its order.
//! Munthe-Kaas, "High order Runge-Kutta methods on manifolds", Applied Numerical Mathematics 29 (1999).

mod adaptive;
mod control;
mod explicit;
mod implicit_midpoint;
mod path;
mod semi_implicit;
mod state;
mod tableau;
mod trial;

pub use adaptive::{Adaptive, IntegrationError, Pace};
pub(crate) use control::{Attempt, Control};
pub use explicit::Explicit;
pub use implicit_midpoint::ImplicitMidpoint;
pub use path::{Method, Path, Steps, Uniform};
pub use semi_implicit::SemiImplicit;
pub use state::{State, System, Tangent};
pub use tableau::{DOP853, DOPRI5, EULER, MIDPOINT, RK4, Tableau};
pub(crate) use trial::{Trial, first_length};
