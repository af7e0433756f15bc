//! All tests of the crate as one program: what they share is compiled once.

#[path = "added_mass/main.rs"]
mod added_mass;
mod called_for;
mod columns;
mod effects;
#[path = "ensemble/main.rs"]
mod ensemble;
mod free_flight;
#[path = "hard/main.rs"]
mod hard;
mod motion;
mod observer;
#[path = "orders/main.rs"]
mod orders;
mod paper;
mod refused;
mod scenes;
mod solver;
mod variational;
mod works;
