//! Reduced Euler-Lagrange (REL) dynamics of floating-base robots.
//!
//! Satellites with arms, humanoids in flight, drones with manipulators: from a URDF to the block-diagonal inertia
//! Λ = diag(Λ_b, Λ_q), the mechanical connection A_l and its curvature 𝓑, the Coriolis matrices D_q̇ and D_μ with their
//! velocity dependence separated, and the accelerations, exact to rounding and without allocation.
//!
//! ```
//! use frs::nalgebra::{DMatrix, Matrix6xX};
//! use frs::{Model, Workspace};
//!
//! let model = Model::from_urdf(frs::urdf::LWR_SATELLITE)?;
//! let mut work = Workspace::new(&model);
//! let mut shape = work.shape(&[0.1, -0.4, 0.3, 1.2, 0.0, -0.7, 0.2]);
//!
//! let mut connection = Matrix6xX::zeros(7);
//! let mut shape_inertia = DMatrix::zeros(7, 7);
//! shape.connection(&mut connection);
//! shape.shape_inertia(&mut shape_inertia);
//! assert!(shape_inertia.cholesky().is_some()); // symmetric positive definite
//! # Ok::<(), frs::urdf::UrdfError>(())
//! ```

pub mod conditioning;
pub mod identities;
pub mod plausibility;

#[cfg(feature = "batch")]
pub use frs_batch as batch;
pub use frs_core::*;
#[cfg(feature = "jit")]
pub use frs_jit as jit;
#[doc(hidden)]
pub use frs_macros::frs_model as __frs_model;
pub use nalgebra;

/// A robot's dynamics as a module of straight-line code, generated from its URDF when the crate is compiled.
///
/// Every function gives the bits of [`Evaluator`], faster. The path is relative to the directory of `Cargo.toml`; when the
/// file changes, the crate is compiled again.
///
/// ```
/// frs::frs_model!(pub mod arm = "robots/planar_three_link.urdf", outputs(inertia, forward_dynamics), gravity = off);
///
/// use frs::{FloatingBase, Quantity};
/// let (mut locked, mut connection, mut shape) = ([[0.0; 6]; 6], [[0.0; 6]; arm::DOF], [[0.0; arm::DOF]; arm::DOF]);
/// arm::inertia(&[0.1, -0.4], &mut locked, &mut connection, &mut shape);
/// assert!(shape[0][0] > shape[1][1]);
/// assert!(arm::PlanarThreeLink.answers(Quantity::Inertia));
/// ```
///
/// `frs_model!("arm.urdf")` is `frs_model!(pub mod arm = "arm.urdf")`. The module holds `DOF`, `COORDINATES`, a function for
/// each [`Quantity`], and a type named after the robot that is a [`FloatingBase`]. After the path come, in any order:
///
/// | key | what it says | without it |
/// |---|---|---|
/// | `root = "base"` | the link to take as base | the link that is nobody's child |
/// | `outputs(inertia, d_mu, kinematics)` | the quantities, by [`Quantity::name`] | all |
/// | `links("tool0", "camera")` | the links whose kinematics is generated | those at the ends of the chains |
/// | `momentum = zero`, `conserved`, `driven` | what is known about μ: zero, no input at all; conserved, no wrench acts | driven |
/// | `gravity = on`, `off` | whether free fall is an input | on |
/// | `lock(elbow = 1.2, "joint 3" = -0.5)` | coordinates that are held, rad or m ([`Model::lock`]) | none |
/// | `payload = "gripper"` | the link whose ten inertial numbers stay an input | none |
/// | `lanes = 1`, `4`, `8`, `16` | states evaluated at once ([`lanes`]): 4 of `f64` only, 16 of `f32` only | 1 |
/// | `form = unrolled`, `hybrid`, `tabled`, `auto` | how functions are written: number by number; what is the same for four bodies by vectors of [`lanes`], half the machine code where four doubles are one register; as constants for the core's loops, however many joints there are, with memory that each thread allocates at its first call; each in the first of these forms whose code is short enough for a processor's first cache | auto |
/// | `scalar = f64`, `f32` | the type of the numbers | f64 |
/// | `lenient = true`, `false` | as [`urdf::Options::lenient`] | false |
///
/// Cargo does not optimise macros by itself. For a robot of thirty joints with all quantities, these lines in the user's
/// `Cargo.toml` make checking it 5 s instead of 26 s: `[profile.dev.build-override]`, `opt-level = 2`.
#[macro_export]
macro_rules! frs_model {
    ($($request:tt)*) => {
        $crate::__frs_model! { [$crate] $($request)* }
    };
}
