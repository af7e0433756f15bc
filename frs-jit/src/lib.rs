//! Compiles recordings of the core to machine code while a program runs, bit for bit.
//!
//! Nothing here knows dynamics, and no compiler has to be installed. What the core did over [`Recorded`] is folded as
//! `frs-codegen` folds it, put into an order that a processor likes, and translated by Cranelift, which fuses nothing and
//! re-associates nothing. [`Code`] is any recording, [`Robot`] a robot's quantities:
//!
//! ```
//! use frs_core::{Evaluator, FloatingBase, Model, Quantity};
//! let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
//! let mut robot = frs_jit::Robot::new(&model, &[Quantity::KineticEnergy])?;
//!
//! let (q, qd, mu) = ([0.3; 7], [0.1; 7], [0.0, 0.2, 0.0, 0.0, 0.0, 0.0]);
//! let energy = |robot: &mut dyn FloatingBase| {
//!     let mut energy = [0.0];
//!     robot.answer(Quantity::KineticEnergy, &[&q, &qd, &mu], &mut [&mut energy]);
//!     energy[0]
//! };
//! assert_eq!(energy(&mut robot), energy(&mut Evaluator::new(&model)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`Recorded`]: frs_codegen::record::Recorded

mod code;
mod error;
mod machine;
mod order;
mod robot;
mod stages;
mod translate;

pub use code::Code;
pub use error::JitError;
pub use robot::Robot;
