//! Robots whose mechanical connection and curvature are known in closed form.
//!
//! Each [`Case`] is a small robot, three times: as a URDF in `robots/oracles`, built in code, and as generated code; with
//! its local connection A_l and the connection's curvature 𝓑 as formulas over any scalar. The formulas use nothing of the
//! core but its [`Real`](frs_core::Real) numbers and [`Twist`](frs_core::spatial::Twist)s, so a number on which both agree
//! has been reached by two ways. [`Point`]s and [`Loop`]s are numbers that were made with neither.
//!
//! ```
//! use frs_oracles::{Case, judge};
//! let judgement = judge(Case::P5);
//! assert!(judgement.core.within(1e-13) && judgement.extended.within(1e-28));
//! ```

mod adjugate;
mod cases;
mod comparison;
mod description;
mod generated;
mod judgement;
mod loops;
mod monopole;
mod plane;
mod point_masses;
mod points;
mod reduced_mass;
mod rotation;
mod values;
mod wrist;

pub use cases::{Case, no_twist_curvature};
pub use comparison::{Comparison, Worst, compare};
pub use judgement::{Answers, EXTENDED, Judgement, ROUNDING, Robots, judge, judged_shapes};
pub use loops::{Kind, Loop, Path, loops};
pub use points::{Point, points, shapes};
pub use values::Values;
