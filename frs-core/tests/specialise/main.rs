//! Robots with coordinates held or with other masses are the robots they stand for.

mod answers;
mod inertial;
mod lock;
mod robots;
