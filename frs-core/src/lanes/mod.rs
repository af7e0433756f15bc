//! Several states at once: numbers that are four, eight or sixteen numbers side by side.
//!
//! Every operation acts on each lane by itself and leaves the bits that it would leave in the plain number: a robot over
//! [`F64x8`] answers for eight states as eight robots over `f64` would, bit for bit.
//!
//! ```
//! use frs_core::lanes::F64x4;
//! use frs_core::{Model, Workspace};
//! let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
//! let (one, four) = (&model, &model.cast::<F64x4>());
//! let (mut one, mut four) = (Workspace::new(one), Workspace::new(four));
//! // Joint 1 at four angles, the others at 0.25 rad.
//! let angles = [0.0, 0.5, 1.0, 1.5];
//! let mut q = [F64x4::splat(0.25); 7];
//! q[0] = F64x4::from_array(angles);
//! let com = four.shape(&q).com().map(F64x4::to_array);
//! assert_eq!(com.y[2], one.shape(&[1.0, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25]).com().y);
//! # Ok::<(), frs_core::urdf::UrdfError>(())
//! ```

mod lane;
mod real;
mod types;

pub use lane::Lane;
pub use types::{F32x8, F32x16, F64x4, F64x8};

/// The source of the lane types, for generated code that stands alone: it needs the crate `wide`, and beside it a module `turn`
/// ([`TURN`](crate::generated::TURN)).
pub const SOURCE: &str = include_str!("types.rs");
