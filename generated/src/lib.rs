//! Generated code of the robots in `robots/`, checked in so that changes are reviewed as diffs.
//!
//! `frs generate --all` writes it, `frs generate --all --check` checks it; docs/generated.md says how to read it.

#[rustfmt::skip] // laid out by the generator
pub mod chaser;
#[rustfmt::skip] // laid out by the generator
pub mod dual_arm_satellite;
#[rustfmt::skip] // laid out by the generator
pub mod humanoid;
#[rustfmt::skip] // laid out by the generator
pub mod lwr_satellite;
#[rustfmt::skip] // laid out by the generator
pub mod planar_three_link;
#[rustfmt::skip] // laid out by the generator
pub mod quadruped;
