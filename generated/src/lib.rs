//! Generated code of the robots in `robots/`, checked in so that changes are reviewed as diffs.
//!
//! `frs generate --all` writes it, `frs generate --all --check` checks it; docs/generated.md says how to read it.

pub mod chaser;
pub mod dual_arm_satellite;
pub mod humanoid;
pub mod lwr_satellite;
pub mod planar_three_link;
pub mod quadruped;
