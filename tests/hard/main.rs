//! Robots and motions at which naive formulas fail, each judged by evaluations with 31 digits (docs/hard.md).

mod angles;
mod chains;
mod far_root;
mod fast;
mod judge;
mod light_base;
mod needle;
mod random_robots;
mod rest;
mod robots;
mod scales;
mod state;
mod tools;
