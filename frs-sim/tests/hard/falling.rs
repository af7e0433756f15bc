//! An hour of flight, without gravity and in a fall: the joints and the base's turning do not notice.

use nalgebra::Vector3;

use super::{robot, whole};

const HOUR: f64 = 3600.0;

const GRAVITY: [f64; 3] = [1.5, -2.0, -9.81];

#[test]
fn an_hour_of_fall_is_an_hour_of_flight_on_a_parabola() {
    let model = robot("chaser");
    let text = format!(
        "robot = 'chaser.urdf'\nduration = {HOUR}\nsamples_per_second = 0.1
[start]\nq = [0.4, -0.7, 1.1]\nqd = [0.02, 0.05, -0.03]\nmu = [0.01, -0.02, 0.03, 0.5, 0.25, 7]
[spring]\nstiffness = 0.1\n[solver]\nmethod = 'rkmk4'\nstep = 0.0625\n"
    );
    let floating = whole(&text, &model);
    let falling = whole(&format!("{text}[gravity]\nacceleration = {GRAVITY:?}\n"), &model);
    assert_eq!(floating.samples.len(), falling.samples.len());
    let start = &falling.samples[0];
    let velocity = falling.samples[0].momentum.force / model.bodies().iter().map(|body| body.mass).sum::<f64>();
    let mut off = 0.0_f64;
    for (floating, falling) in floating.samples.iter().zip(&falling.samples) {
        let t = falling.time;
        assert_eq!((&floating.q, &floating.qd), (&falling.q, &falling.qd), "{t} s");
        assert_eq!(floating.pose.rotation, falling.pose.rotation, "{t} s");
        let expected = start.com + velocity * t + Vector3::from(GRAVITY) * (0.5 * t * t);
        off = off.max((falling.com - expected).amax() / expected.amax().max(1.0));
    }
    println!(
        "an hour, {} samples: q, q̇ and R the same bits, the centre of mass {off:.1e} of its way beside the parabola",
        floating.samples.len()
    );
    // Its three terms, each rounded a few times.
    assert!(off <= 8.0 * f64::EPSILON, "{off:e}");
}
