//! What is known about the momentum changes what is integrated, not what happens.

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Evaluator, FloatingBase, Model, urdf};
use frs_generated::lwr_satellite::LwrSatellite;
use frs_sim::integrate::{Adaptive, DOP853, Explicit, RK4, State, System};
use frs_sim::motion::{Conserved, Driven, Instant, Load, Loads, Momentum, Motion, Zero};
use nalgebra::Vector3;

const ACCURACY: f64 = 1e-11;

/// Errors of steps add up over a motion of seconds.
const ACCUMULATION: f64 = 100.0;

const Q: [f64; 7] = [0.1, -0.4, 0.3, 1.2, 0.0, -0.7, 0.2];
const QD: [f64; 7] = [0.5, -0.2, 0.1, 0.3, -0.4, 0.2, 0.6];

fn model() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

fn pose() -> Pose<f64> {
    Pose::from_rpy(Vector3::new(1.0, -2.0, 0.5), [0.3, -0.6, 1.1])
}

/// Springs and dampers in the joints: torques that leave the momentum alone.
fn springs(instant: &Instant<'_>, load: &mut Load) {
    for ((tau, q), qd) in load.tau.iter_mut().zip(instant.q).zip(instant.qd) {
        *tau -= 0.8 * q + 0.1 * qd;
    }
}

fn flown<R: FloatingBase, M: Momentum<f64>, L: Loads<f64>>(
    motion: &mut Motion<R, M, L>,
    start: State,
    duration: f64,
    mut each: impl FnMut(&mut Motion<R, M, L>, &State),
) -> State {
    let mut flight = Adaptive::new(&DOP853, start, 0.0, ACCURACY);
    while flight.time() < duration {
        flight.advance(motion, duration).unwrap();
        each(motion, flight.state());
    }
    flight.state().clone()
}

fn distance(one: &State, other: &State) -> f64 {
    let turn = (one.pose.inverse() * other.pose).log().to_vector().norm();
    // Where μ is integrated it follows q and q̇ in the list.
    one.flat.iter().zip(&other.flat).map(|(a, b)| (a - b).abs()).fold(turn, f64::max)
}

#[test]
fn a_momentum_that_is_known_need_not_be_integrated() {
    let model = model();
    let mu = Twist::from_array([0.2, 0.4, -0.3, 0.1, -0.2, 0.3]);
    let mut driven = Motion::new(Evaluator::new(&model), Driven, springs);
    let start = driven.state(pose(), &Q, &QD, mu);
    let momentum = driven.spatial_momentum(&start);
    let mut conserved = Motion::new(Evaluator::new(&model), Conserved { momentum }, springs);
    let start_conserved = conserved.state(pose(), &Q, &QD, mu);
    assert_eq!((start.flat.len(), start_conserved.flat.len()), (20, 14));

    let end = flown(&mut driven, start, 3.0, |_, _| {});
    let end_conserved = flown(&mut conserved, start_conserved, 3.0, |_, _| {});
    let error = distance(&end_conserved, &end);
    assert!(error < ACCUMULATION * ACCURACY, "{error:e}");
}

/// Rounding of one evaluation of the momentum, relative.
const MOMENTUM_ROUNDING: f64 = 1e-14;

#[test]
fn a_momentum_that_is_not_integrated_does_not_drift() {
    let model = model();
    let momentum = Wrench::from_array([1.0, -2.0, 0.5, 0.3, 0.2, -0.1]);
    let mut motion = Motion::new(Evaluator::new(&model), Conserved { momentum }, springs);
    let start = motion.state(pose(), &Q, &QD, Twist::zero());
    let (mut worst, mut seen): (f64, usize) = (0.0, 0);
    flown(&mut motion, start, 10.0, |motion, state| {
        let off = (motion.spatial_momentum(state) - momentum).to_array();
        worst = off.into_iter().fold(worst, |worst, x| worst.max(x.abs()));
        seen += 1;
    });
    assert!(seen > 50 && worst < MOMENTUM_ROUNDING * 2.0 * 10.0, "{worst:e} in {seen} steps");
}

/// A hundred steps of fixed length: nothing but the equations decides the bits.
fn stepped(system: &mut impl System, start: State) -> State {
    let mut method = Explicit::new(&RK4, system.dimension());
    let (mut state, mut next) = (start.clone(), start);
    for i in 0..100 {
        method.step(system, 0.005 * f64::from(i), 0.005, &state, &mut next);
        std::mem::swap(&mut state, &mut next);
    }
    state
}

fn bits(state: &State) -> Vec<u64> {
    let numbers = state.pose.rotation.iter().chain(&state.pose.translation).chain(state.flat.iter().take(14));
    let bits = |x: &f64| {
        assert!(x.is_finite(), "all bits of what is no number are alike");
        (x + 0.0).to_bits()
    };
    numbers.map(bits).collect()
}

#[test]
fn zero_momentum_is_driven_momentum_that_nothing_drives_bit_for_bit() {
    let model = model();
    let mut driven = Motion::new(Evaluator::new(&model), Driven, springs);
    let mut zero = Motion::new(Evaluator::new(&model), Zero, springs);
    let start = driven.state(pose(), &Q, &QD, Twist::zero());
    let start_zero = zero.state(pose(), &Q, &QD, Twist::zero());
    assert_eq!(bits(&stepped(&mut zero, start_zero)), bits(&stepped(&mut driven, start)));
}

#[test]
fn a_generated_robot_moves_bit_for_bit_as_the_core_does() {
    let model = model();
    let mu = Twist::from_array([0.2, 0.4, -0.3, 0.1, -0.2, 0.3]);
    let push = |instant: &Instant<'_>, load: &mut Load| {
        load.base_wrench = Wrench::from_array([instant.time, 0.0, 0.1, 0.0, 0.2, 0.0]);
        load.gravity = (instant.pose.rotation.transpose() * Vector3::new(0.0, 0.0, -9.81)).into();
    };
    let mut core = Motion::new(Evaluator::new(&model), Driven, (springs, push));
    let mut generated = Motion::new(LwrSatellite, Driven, (springs, push));
    let start = core.state(pose(), &Q, &QD, mu);
    assert_eq!(bits(&stepped(&mut generated, start.clone())), bits(&stepped(&mut core, start)));
}

/// Gravity pulls all mass alike: the centre of mass falls on a parabola, and the shape does not notice.
#[test]
fn a_fall_is_a_flight_in_a_falling_frame() {
    const DURATION: f64 = 2.0;
    let model = model();
    let fall = Vector3::new(0.3, 0.1, -9.81);
    let gravity = move |instant: &Instant<'_>, load: &mut Load| {
        load.gravity = (instant.pose.rotation.transpose() * fall).into();
    };
    let mu = Twist::from_array([0.2, 0.4, -0.3, 0.1, -0.2, 0.3]);
    let mut falling = Motion::new(Evaluator::new(&model), Driven, (springs, gravity));
    let mut free = Motion::new(Evaluator::new(&model), Driven, springs);
    let start = falling.state(pose(), &Q, &QD, mu);
    let mut end = flown(&mut falling, start.clone(), DURATION, |_, _| {});
    let end_free = flown(&mut free, start, DURATION, |_, _| {});
    end.pose.translation -= fall * (0.5 * DURATION * DURATION);
    end.flat.truncate(14);
    let error = distance(&end, &end_free);
    assert!(error < ACCUMULATION * ACCURACY * fall.norm(), "{error:e}");
}

#[test]
fn springs_without_dampers_keep_the_energy() {
    let model = model();
    let elastic = |instant: &Instant<'_>, load: &mut Load| {
        load.tau.iter_mut().zip(instant.q).for_each(|(tau, q)| *tau -= 0.8 * q);
    };
    let momentum = Wrench::from_array([0.5, -0.2, 0.5, 0.3, 0.2, -0.1]);
    let mut motion = Motion::new(Evaluator::new(&model), Conserved { momentum }, elastic);
    let start = motion.state(pose(), &Q, &QD, Twist::zero());
    fn energy<L: Loads<f64>>(motion: &mut Motion<Evaluator<'_>, Conserved, L>, state: &State) -> f64 {
        motion.kinetic_energy(state) + state.flat[..7].iter().map(|q| 0.4 * q * q).sum::<f64>()
    }
    let before = energy(&mut motion, &start);
    let mut worst: f64 = 0.0;
    flown(&mut motion, start, 5.0, |motion, state| {
        worst = worst.max((energy(motion, state) / before - 1.0).abs());
    });
    assert!(worst < ACCUMULATION * ACCURACY, "{worst:e}");
}
