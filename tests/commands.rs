//! All tests of the command line as one program: what they share is compiled once.

mod cli;
mod cli_accuracy;
#[path = "cli_batch/main.rs"]
mod cli_batch;
mod cli_check;
mod cli_curvature;
mod cli_generate;
mod cli_oracle;
mod cli_simulate;
mod fresh;
