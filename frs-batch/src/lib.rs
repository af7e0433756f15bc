//! Many states of a floating-base robot at once, bit for bit.
//!
//! [`answer`] asks a [`Quantity`](frs_core::Quantity) at every row of arrays and writes the rows of others, in place, whatever their strides. Who
//! answers is a [`Group`], which takes several states at a time: [`Blocks`], a recording of the core performed by the widest
//! instructions of the processor, or [`Side`], any robot over a number or over [lanes](frs_core::lanes). All give the bits that one state
//! alone has, on any number of threads.
//!
//! ```
//! use frs_batch::{Recording, answer};
//! use frs_core::{Model, Quantity};
//! use ndarray::Array2;
//!
//! let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
//! let recording = Recording::new(&model, Quantity::Momentum)?;
//!
//! let states = 1_000;
//! let (q, mu) = (Array2::from_elem((states, 7), 0.3), Array2::from_elem((states, 6), 0.1));
//! let (mut body, mut centroidal) = (Array2::zeros((states, 6)), Array2::zeros((states, 6)));
//! answer(|| recording.blocks(), Quantity::Momentum, &[q.view(), mu.view()], [body.view_mut(), centroidal.view_mut()].into())?;
//! assert_eq!(body.row(0), body.row(999));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Arrays hold a state a row. Of an array with a state a column (a structure of arrays) the transposed view is given, `array.t()`: nothing is
//! copied.

mod answer;
mod blocks;
mod error;
mod fusion;
mod group;
mod instructions;
mod perform;
mod recording;
mod steps;

pub use answer::answer;
pub use blocks::Blocks;
pub use error::BatchError;
pub use frs_core::lanes::Lane;
pub use group::{Group, Side};
pub use instructions::Instructions;
pub use recording::Recording;
