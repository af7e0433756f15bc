//! The identities of docs/mathematics.md §2 and §3 between the core's own outputs.

mod curvature;
mod dynamics;
mod frames;
mod rates;
mod sizes;
mod structure;
