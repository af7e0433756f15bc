//! Closed shape paths and what they do to a floating base.
//!
//! A robot that moves its joints along a closed path at zero momentum comes back to its shape, but not to its place: the
//! mechanical connection A_l has curvature, and the base ends where the path-ordered reconstruction `g' = g (−A_l q')^`
//! leads ([`displacement()`]). For small loops that is the curvature 𝓑 summed over what the loop encloses, and for planar
//! robots the rotation is that exactly ([`area_integral`]); maps of 𝓑 over two coordinates ([`CurvatureField`]) therefore
//! show which loops turn the base, and [`best_gait`] finds the one that does it best.
//!
//! ```
//! use frs_core::{Evaluator, Model};
//! use frs_gait::{Gait, ShapePlane, area_integral, displacement};
//!
//! let satellite = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
//! let mut robot = Evaluator::new(&satellite);
//! let plane = ShapePlane::new(vec![0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0], [1, 3]);
//!
//! let wide = Gait::ellipse(&plane, [0.3, 0.5], [0.8, 0.8])?;
//! let turned = displacement(&mut robot, &wide, 1e-11)?;
//! assert!(turned.rotation.norm() > 1.0 && turned.error < 1e-11);
//!
//! let narrow = Gait::ellipse(&plane, [0.3, 0.5], [0.1, 0.1])?;
//! let turned = displacement(&mut robot, &narrow, 1e-11)?.rotation;
//! let area = area_integral(&mut robot, &plane, &narrow, 1e-9).body.angular;
//! assert!((area - turned).norm() < 0.1 * turned.norm());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod area;
mod descent;
mod displacement;
mod field;
mod fourier_loop;
mod gait;
mod optimise;
mod path;
mod perturbation;
mod plane;

pub use area::{AreaIntegral, area_integral, winding_integral};
pub use displacement::{Displacement, DisplacementError, displacement};
pub use field::{CurvatureField, Grid, PlaneCurvature};
pub use gait::{Gait, GaitError};
pub use optimise::{Optimum, Target, best_gait};
pub use path::{Path, Reversed, length};
pub use perturbation::MinimumPerturbation;
pub use plane::ShapePlane;
