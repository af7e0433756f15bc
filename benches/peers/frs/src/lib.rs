//! Our side of the race beside peers: reads states, answers, measures.

mod contestant;
mod core;
mod number;
mod race;
mod ready;
mod serve;
mod states;
mod work;

pub use contestant::{Contestant, Part};
pub use race::race;
pub use ready::Ready;
pub use serve::{Named, serve};
pub use states::{State, states};
pub use work::Work;
