//! The recursive dynamics of floating-base robots in reduced Euler-Lagrange (REL) form.
//!
//! The core is the only place where dynamics is written. It is generic over a scalar ([`Real`]), reads a robot from a
//! [`Model`], allocates nothing after its [`Workspace`] is made, and cannot fail once a [`Model`] exists.

pub mod derivatives;
pub mod enclosure;
pub mod extended;
mod floating_base;
pub mod generated;
mod hamel;
pub mod lanes;
pub mod ldl;
pub mod model;
mod quantity;
mod real;
pub mod rel;
pub mod spatial;
mod sweep;
pub mod turn;
pub mod urdf;

pub use floating_base::{Evaluator, FloatingBase};
pub use model::Model;
pub use quantity::{Argument, Quantity};
pub use real::{FUSED, Lanes, Real};
pub use rel::{Curvature, Route};
pub use sweep::{Label, Moving, Pass, Shape, Workspace};
