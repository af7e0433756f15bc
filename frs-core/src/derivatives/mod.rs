//! Exact derivatives of everything in the core, by evaluating it over another scalar.

mod dual;

pub use dual::Dual;
