//! A closed gait again and again: each turn of it turns the base by the same holonomy, and nothing else does.

use frs_core::Model;
use frs_core::extended::DoubleDouble;
use frs_sim::integrate::{Method, Steps};
use frs_sim::run::equations;
use frs_sim::scene::{Scene, Solver};
use frs_sim::study::{Number, fly};
use nalgebra::Matrix3;

use super::{robot, scene};

const TURNS: u32 = 100_000;

/// Steps a turn, which takes 1 s.
const STEPS: f64 = 16.0;

fn gait(duration: u32, model: &Model) -> Scene {
    let rate = std::f64::consts::TAU;
    let text = format!(
        "robot = 'planar_three_link.urdf'\nduration = {duration}
[[prescribed]]\njoint = 'joint_1'\nsinusoid = {{ offset = 0.4, amplitude = 0.8, rate = {rate} }}
[[prescribed]]\njoint = 'joint_2'\nsinusoid = {{ offset = -0.7, amplitude = 0.6, rate = {rate}, phase = 1.5707963267948966 }}"
    );
    let solver = Solver { method: Method::Rkmk4, steps: Steps::Length(1.0 / STEPS), ..Solver::default() };
    Scene { solver, ..scene(&text, model) }
}

/// The base's rotation after so many turns.
fn turned<T: Number>(turns: u32, robot: &Model, model: &Model<T>) -> Matrix3<T> {
    let scene = gait(turns, robot);
    let end = [f64::from(turns)];
    fly(&scene, &end, true, &mut |time| equations(&scene, model, time)).unwrap().states[0].pose.rotation
}

#[test]
fn a_hundred_thousand_turns_of_a_gait_turn_the_base_by_as_many_holonomies() {
    let model = robot("planar_three_link");
    let once = turned(1, &model, &model.cast::<DoubleDouble>().orthonormalised());
    // Of a small angle, with 31 digits: sin and cos of multiples by doubling.
    let mut power = once;
    let mut all = Matrix3::<DoubleDouble>::identity();
    let mut left = TURNS;
    while left > 0 {
        if left % 2 == 1 {
            all *= power;
        }
        power = power * power;
        left /= 2;
    }
    let found = turned(TURNS, &model, &model);
    let apart = (found - all.map(DoubleDouble::high)).amax();
    let a_turn = once[(1, 0)].high().asin();
    // Each evaluation rounds the rate, which is of order 1, a few times; all to the same side.
    let allowed = f64::from(TURNS) * STEPS * 4.0 * f64::EPSILON;
    println!("{TURNS} turns of {a_turn:.3} rad each: off by {apart:.1e}, allowed {allowed:.1e}");
    assert!(a_turn.abs() > 0.01, "a gait that turns the base");
    assert!(apart <= allowed, "{apart:e}");
    assert!(once[(2, 0)].high() == 0.0, "it stays in its plane");
}
