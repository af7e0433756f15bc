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

pub mod identities;

pub use frs_core::*;
pub use nalgebra;
