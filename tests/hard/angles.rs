//! Joints that have turned often, or stand within rounding of a half and a whole turn.
//!
//! A double's own sine and cosine are good to the last digit at any angle, so that nothing is lost: the exponential maps, judged with
//! 256 bits from 10⁻³⁰⁰ to many turns, are in `frs-core/tests/exponential.rs`.

use std::f64::consts::{PI, TAU};

use frs::{Model, urdf};

use crate::judge::judge_all;
use crate::robots::turned;
use crate::state::State;

const SHAPES: u64 = 20;

#[test]
fn joints_at_any_angle_are_as_accurate_as_at_small_ones() {
    let model = Model::from_urdf(urdf::LWR_SATELLITE).expect("the robot is well formed");
    for size in [1e-300, 1e-8, 1e3, 1e8] {
        judge_all(&format!("angles of {size:e} rad"), &model, (0..SHAPES).map(|seed| turned(&model, seed, size)));
    }
    for (turn, near) in [("π", PI), ("2π", TAU), ("2π·10⁷", 1e7 * TAU)] {
        for off in [0.0, 1e-15, 1e-8] {
            let state = |seed: u64| {
                let signs = State::random(seed).numbers("q", model.dof());
                State::random(seed).with("q", signs.iter().map(|sign| near.copysign(*sign) + off * sign).collect())
            };
            judge_all(&format!("angles within {off:e} of {turn}"), &model, (0..SHAPES).map(state));
        }
    }
}
