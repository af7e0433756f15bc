//! The recursion judged against docs/mathematics.md: every quantity against the sum over links that defines it, every
//! identity between quantities, and every correction to the printed paper.

mod algebra;
mod asking;
mod closeness;
mod corrections;
mod fixed_robot;
mod identities;
mod kinematics;
mod outputs;
mod quantities;
mod scalars;
mod specification;
mod specification_rates;
mod trees;
mod workspaces;
