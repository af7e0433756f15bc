//! Motions of floating-base robots.
//!
//! The configuration space is SE(3)×Rⁿ, so [`integrate`] moves base poses by exponentials: a rotation stays one, whatever the
//! step. [`motion`] says what is integrated: with the momentum zero, conserved or driven, only what that case needs. A [`scene`]
//! names what acts ([`effects`]) and who observes ([`observer`]), and [`run`] computes it; a [`study`] computes it in many ways and
//! tells what each costs. An [`ensemble`] is many motions of one robot at once.

pub mod effects;
pub mod ensemble;
pub mod integrate;
pub mod motion;
pub mod observer;
pub mod run;
pub mod scene;
pub mod signal;
pub mod study;
