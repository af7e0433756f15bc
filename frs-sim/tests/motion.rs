//! What is known about the momentum changes what is integrated, not what happens.

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Evaluator, Model, Moving, urdf};
use frs_generated::lwr_satellite::LwrSatellite;
use frs_sim::integrate::{Adaptive, DOP853, Explicit, RK4, State, System};
use frs_sim::motion::{Answered, Ballistic, Conserved, Driven, Instant, Load, Loads, Momentum, Motion, Zero};
use nalgebra::Vector3;

const ACCURACY: f64 = 1e-11;

/// Errors of steps add up over a motion of seconds.
const ACCUMULATION: f64 = 100.0;

/// By which the error of a motion at `ACCURACY` is known; the difference of two such is good to a hundredth.
const FINER: f64 = 1e-13;

/// Of numbers of size 1 after some hundred steps.
const ROUNDING: f64 = 1e-12;

const Q: [f64; 7] = [0.1, -0.4, 0.3, 1.2, 0.0, -0.7, 0.2];
const QD: [f64; 7] = [0.5, -0.2, 0.1, 0.3, -0.4, 0.2, 0.6];

fn model() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

fn pose() -> Pose<f64> {
    Pose::from_rpy(Vector3::new(1.0, -2.0, 0.5), [0.3, -0.6, 1.1])
}

/// Springs and dampers in the joints: torques that leave the momentum alone.
fn springs(instant: &Instant<'_>, _: &mut Moving<'_, '_, '_>, load: &mut Load) {
    for ((tau, q), qd) in load.tau.iter_mut().zip(instant.q).zip(instant.qd) {
        *tau -= 0.8 * q + 0.1 * qd;
    }
}

fn flown<M: Momentum<f64>, L: Loads<f64>>(
    motion: &mut Motion<'_, M, L>,
    start: State,
    duration: f64,
    mut each: impl FnMut(&mut Motion<'_, M, L>, f64, &State),
) -> State {
    let mut flight = Adaptive::new(&DOP853, start, 0.0, ACCURACY);
    while flight.time() < duration {
        flight.advance(motion, duration).unwrap();
        each(motion, flight.time(), flight.state());
    }
    flight.state().clone()
}

/// Where a motion is after 3 s.
fn ended(motion: &mut impl System, start: State, accuracy: f64) -> State {
    let mut flight = Adaptive::new(&DOP853, start, 0.0, accuracy);
    while flight.time() < 3.0 {
        flight.advance(motion, 3.0).unwrap();
    }
    flight.state().clone()
}

fn distance(one: &State, other: &State) -> f64 {
    let turn = (one.pose.inverse() * other.pose).log().to_vector().norm();
    // Where μ is integrated it follows q and q̇ in the list.
    one.flat.iter().zip(&other.flat).map(|(a, b)| (a - b).abs()).fold(turn, f64::max)
}

/// The momentum about the centre of mass, world axes.
fn about_com<M: Momentum<f64>, L: Loads<f64>>(motion: &mut Motion<'_, M, L>, time: f64, state: &State) -> Wrench<f64> {
    let momentum = motion.ask(time, state, |robot, mu| robot.centroidal_momentum(mu));
    Pose::new(state.pose.rotation, Vector3::zeros()).act_wrench(momentum)
}

#[test]
fn a_momentum_that_is_known_need_not_be_integrated() {
    let model = model();
    let mu = Twist::from_array([0.2, 0.4, -0.3, 0.1, -0.2, 0.3]);
    let mut driven = Motion::new(&model, Driven, springs);
    let start = driven.state(pose(), &Q, &QD, mu);
    let momentum = about_com(&mut driven, 0.0, &start);
    let mut conserved = Motion::new(&model, Conserved { momentum }, springs);
    let start_conserved = conserved.state(pose(), &Q, &QD, mu);
    assert_eq!((start.flat.len(), start_conserved.flat.len()), (20, 14));

    let [end, finer] = [ACCURACY, FINER].map(|accuracy| ended(&mut driven, start.clone(), accuracy));
    let [end_conserved, finer_conserved] =
        [ACCURACY, FINER].map(|accuracy| ended(&mut conserved, start_conserved.clone(), accuracy));
    let errors = distance(&finer, &end) + distance(&finer_conserved, &end_conserved) + ROUNDING;
    let apart = distance(&end_conserved, &end);
    assert!(errors < 1e-8 && apart < errors, "{apart:e}, each off by {errors:e} together");
}

/// Rounding of one evaluation of the momentum, relative.
const MOMENTUM_ROUNDING: f64 = 1e-14;

#[test]
fn a_momentum_that_is_not_integrated_does_not_drift() {
    let model = model();
    let momentum = Wrench::from_array([1.0, -2.0, 0.5, 0.3, 0.2, -0.1]);
    let mut motion = Motion::new(&model, Conserved { momentum }, springs);
    let start = motion.state(pose(), &Q, &QD, Twist::zero());
    let (mut worst, mut seen): (f64, usize) = (0.0, 0);
    flown(&mut motion, start, 10.0, |motion, time, state| {
        let off = (about_com(motion, time, state) - momentum).to_array();
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
    let mut driven = Motion::new(&model, Driven, springs);
    let mut zero = Motion::new(&model, Zero, springs);
    let start = driven.state(pose(), &Q, &QD, Twist::zero());
    let start_zero = zero.state(pose(), &Q, &QD, Twist::zero());
    assert_eq!(bits(&stepped(&mut zero, start_zero)), bits(&stepped(&mut driven, start)));
}

fn push(instant: &Instant<'_>, _: &mut Moving<'_, '_, '_>, load: &mut Load) {
    load.base_wrench = Wrench::from_array([instant.time, 0.0, 0.1, 0.0, 0.2, 0.0]);
    load.gravity = (instant.pose.rotation.transpose() * Vector3::new(0.0, 0.0, -9.81)).into();
}

/// The same without the core's sweeps at hand.
fn springs_and_push(instant: &Instant<'_>, load: &mut Load) {
    load.base_wrench = Wrench::from_array([instant.time, 0.0, 0.1, 0.0, 0.2, 0.0]);
    load.gravity = (instant.pose.rotation.transpose() * Vector3::new(0.0, 0.0, -9.81)).into();
    load.tau.iter_mut().zip(instant.q).zip(instant.qd).for_each(|((tau, q), qd)| *tau -= 0.8 * q + 0.1 * qd);
}

#[test]
fn a_generated_robot_moves_bit_for_bit_as_the_core_does() {
    let model = model();
    let mu = Twist::from_array([0.2, 0.4, -0.3, 0.1, -0.2, 0.3]);
    let mut core = Motion::new(&model, Driven, (springs, push));
    let start = core.state(pose(), &Q, &QD, mu);
    let expected = bits(&stepped(&mut core, start.clone()));
    let mut generated = Answered::new(LwrSatellite, springs_and_push);
    assert_eq!(bits(&generated.state(pose(), &Q, &QD, mu)), bits(&start));
    assert_eq!(bits(&stepped(&mut generated, start.clone())), expected);
    let mut any = Answered::new(Evaluator::new(&model), springs_and_push);
    assert_eq!(bits(&stepped(&mut any, start)), expected);
}

/// Gravity pulls all mass alike: the shape and the angular momentum do not notice, and nothing of it is integrated.
#[test]
fn a_fall_that_is_known_is_the_one_that_is_integrated() {
    const DURATION: f64 = 2.0;
    let model = model();
    let fall = Vector3::new(0.3, 0.1, -9.81);
    let gravity = move |instant: &Instant<'_>, _: &mut Moving<'_, '_, '_>, load: &mut Load| {
        load.gravity = (instant.pose.rotation.transpose() * fall).into();
    };
    let mu = Twist::from_array([0.2, 0.4, -0.3, 0.1, -0.2, 0.3]);
    let mut falling = Motion::new(&model, Driven, (springs, gravity));
    let start = falling.state(pose(), &Q, &QD, mu);
    let momentum = about_com(&mut falling, 0.0, &start);
    let mass = falling.ask(0.0, &start, |robot, _| robot.locked_inertia().mass);
    let known = Ballistic { momentum, acceleration: fall, mass, since: 0.0 };
    let mut ballistic = Motion::new(&model, known, springs);
    let free = ballistic.state(pose(), &Q, &QD, mu);
    let end = flown(&mut falling, start, DURATION, |_, _, _| {});
    let end_free = flown(&mut ballistic, free, DURATION, |_, _, _| {});
    let apart = distance(&end_free, &end);
    let velocities = ballistic.locked_velocity(DURATION, &end_free) - falling.locked_velocity(DURATION, &end);
    let error = apart.max(velocities.to_vector().norm());
    assert!(error < ACCUMULATION * ACCURACY * fall.norm(), "{error:e}");
}

#[test]
fn springs_without_dampers_keep_the_energy() {
    let model = model();
    let elastic = |instant: &Instant<'_>, _: &mut Moving<'_, '_, '_>, load: &mut Load| {
        load.tau.iter_mut().zip(instant.q).for_each(|(tau, q)| *tau -= 0.8 * q);
    };
    let momentum = Wrench::from_array([0.5, -0.2, 0.5, 0.3, 0.2, -0.1]);
    let mut motion = Motion::new(&model, Conserved { momentum }, elastic);
    let start = motion.state(pose(), &Q, &QD, Twist::zero());
    fn energy<L: Loads<f64>>(motion: &mut Motion<'_, Conserved, L>, time: f64, state: &State) -> f64 {
        motion.kinetic_energy(time, state) + state.flat[..7].iter().map(|q| 0.4 * q * q).sum::<f64>()
    }
    let before = energy(&mut motion, 0.0, &start);
    let mut worst: f64 = 0.0;
    flown(&mut motion, start, 5.0, |motion, time, state| {
        worst = worst.max((energy(motion, time, state) / before - 1.0).abs());
    });
    assert!(worst < ACCUMULATION * ACCURACY, "{worst:e}");
}

/// Nothing acts and nothing moves: not even rounding does, but for the last digits of the rotation, which each step makes one again.
#[test]
fn a_motion_from_rest_stays_where_it_is() {
    let model = model();
    let loose = |_: &Instant<'_>, _: &mut Moving<'_, '_, '_>, _: &mut Load| {};
    let stays = |start: &State, end: &State| {
        assert_eq!(bits(end)[9..], bits(start)[9..]);
        assert!((end.pose.rotation - start.pose.rotation).amax() < ROUNDING);
    };
    let mut driven = Motion::new(&model, Driven, loose);
    let start = driven.state(pose(), &Q, &[0.0; 7], Twist::zero());
    stays(&start, &stepped(&mut driven, start.clone()));
    let mut conserved = Motion::new(&model, Conserved { momentum: Wrench::zero() }, loose);
    let start = conserved.state(pose(), &Q, &[0.0; 7], Twist::zero());
    stays(&start, &stepped(&mut conserved, start.clone()));
}

/// A million steps: what is not integrated does not drift, and a rotation stays one.
#[test]
fn a_million_steps_leave_the_momentum_where_it_is() {
    const DRIFT: f64 = 1e-13;
    const STEPS: u32 = 1_000_000;
    let model = Model::from_urdf(include_str!("../../robots/planar_three_link.urdf")).unwrap();
    let momentum = Wrench::from_array([0.3, -0.2, 0.5, 0.3, 0.2, -0.1]);
    let loose = |_: &Instant<'_>, _: &mut Moving<'_, '_, '_>, _: &mut Load| {};
    let mut motion = Motion::new(&model, Conserved { momentum }, loose);
    let mut method = Explicit::new(&RK4, motion.dimension());
    let mut state = motion.state(pose(), &[0.5, -0.3], &[0.2, 0.4], Twist::zero());
    let mut next = state.clone();
    for i in 0..STEPS {
        method.step(&mut motion, 1e-3 * f64::from(i), 1e-3, &state, &mut next);
        std::mem::swap(&mut state, &mut next);
    }
    let drift = (about_com(&mut motion, 1e3, &state) - momentum).to_array();
    let size = momentum.to_array().into_iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let worst = drift.into_iter().fold(0.0, |worst: f64, x| worst.max(x.abs()));
    assert!(worst <= DRIFT * size, "{:e}", worst / size);
    let defect = (state.pose.rotation.transpose() * state.pose.rotation - nalgebra::Matrix3::identity()).norm();
    assert!(defect < DRIFT, "{defect:e}");
}
