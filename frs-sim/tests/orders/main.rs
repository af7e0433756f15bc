//! Every integrator has its theoretical order, on three motions, against a double-double reference.

mod motions;

use frs_core::Real;
use frs_core::extended::DoubleDouble;
use frs_core::spatial::Pose;
use frs_sim::integrate::{
    Adaptive, DOP853, DOPRI5, EULER, Explicit, ImplicitMidpoint, MIDPOINT, RK4, SemiImplicit, State, System, Tableau,
};
use motions::{DURATION, Motion, Robot, Shaken, Top};
use nalgebra::Vector3;

/// Observed orders may be off by this: what the next power of h still contributes.
const ORDER_TOLERANCE: f64 = 0.2;

type Wide = State<DoubleDouble>;

/// The same state with 31 digits.
fn wide<T: Real + Into<DoubleDouble>>(state: &State<T>) -> Wide {
    let widen = |x: T| x.into();
    let pose = Pose::new(state.pose.rotation.map(widen), state.pose.translation.map(widen));
    State { pose, flat: state.flat.iter().copied().map(widen).collect() }
}

/// How far apart two states are: rotation, translation and numbers.
fn distance<T: Real + Into<DoubleDouble>>(one: &State<T>, other: &Wide) -> f64 {
    let one = wide(one);
    let turn = (one.pose.inverse() * other.pose).log().to_array();
    let numbers = one.flat.iter().zip(&other.flat).map(|(&a, &b)| a - b);
    turn.into_iter().chain(numbers).map(|x| x.high().powi(2)).sum::<f64>().sqrt()
}

/// The end of the motion by steps of order 8 with 31 digits.
fn reference<M: Motion>() -> Wide {
    let mut system = M::make::<DoubleDouble>();
    let mut motion = Adaptive::new(&DOP853, M::start(), DoubleDouble::from(0.0), 1e-24);
    while motion.time() != DoubleDouble::from(DURATION) {
        motion.advance(&mut system, DURATION.into()).unwrap();
    }
    motion.state().clone()
}

/// The orders seen as `steps` are doubled again and again; a step is given the time and its length.
fn orders<M: Motion, T: Real + Into<DoubleDouble>, S>(
    steps: usize,
    mut stepper: impl FnMut(usize) -> S,
    mut step: impl FnMut(&mut S, &mut M::System<T>, [T; 2], &State<T>, &mut State<T>),
) -> Vec<f64> {
    let reference = reference::<M>();
    let errors = [steps, 2 * steps, 4 * steps].map(|steps| {
        let (mut system, mut state) = (M::make(), M::start());
        let mut next = state.clone();
        let mut stepper = stepper(system.dimension());
        let h = T::from_f64(DURATION) / T::from_f64(steps as f64);
        for i in 0..steps {
            step(&mut stepper, &mut system, [T::from_f64(i as f64) * h, h], &state, &mut next);
            std::mem::swap(&mut state, &mut next);
        }
        distance(&state, &reference)
    });
    errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect()
}

fn assert_order(orders: &[f64], expected: usize) {
    let last = orders.last().unwrap();
    assert!((last - expected as f64).abs() <= ORDER_TOLERANCE, "observed {orders:?}, expected {expected}");
}

/// `steps`: few enough for the error to stand above rounding, many enough for the leading power to stand out.
fn explicit<M: Motion, T: Real + Into<DoubleDouble>>(tableau: &'static Tableau, steps: usize) {
    let seen = orders::<M, T, _>(
        steps,
        |dimension| Explicit::new(tableau, dimension),
        |stepper, system, [time, h], from, to| stepper.step(system, time, h, from, to),
    );
    assert_order(&seen, tableau.order);
}

fn semi_implicit<M: Motion>(steps: usize) {
    let seen = orders::<M, f64, _>(steps, SemiImplicit::new, |stepper, system, [time, h], from, to| {
        stepper.step(system, time, h, from, to);
    });
    assert_order(&seen, 1);
}

fn implicit_midpoint<M: Motion>(steps: usize) {
    let seen = orders::<M, f64, _>(steps, ImplicitMidpoint::new, |stepper, system, [time, h], from, to| {
        stepper.step(system, time, h, from, to).unwrap();
    });
    assert_order(&seen, 2);
}

macro_rules! on {
    ($($name:ident: $motion:ty;)*) => {$(
        mod $name {
            use super::*;

            #[test]
            fn euler_has_order_one() {
                explicit::<$motion, f64>(&EULER, 1600);
            }

            #[test]
            fn semi_implicit_euler_has_order_one() {
                semi_implicit::<$motion>(1600);
            }

            #[test]
            fn rkmk2_has_order_two() {
                explicit::<$motion, f64>(&MIDPOINT, 200);
            }

            #[test]
            fn implicit_midpoint_has_order_two() {
                implicit_midpoint::<$motion>(200);
            }

            #[test]
            fn rkmk4_has_order_four() {
                explicit::<$motion, f64>(&RK4, 60);
            }

            #[test]
            fn dopri5_has_order_five() {
                explicit::<$motion, f64>(&DOPRI5, 30);
            }

            #[test]
            fn dop853_has_order_eight() {
                explicit::<$motion, DoubleDouble>(&DOP853, 12);
            }

            #[test]
            fn error_control_keeps_what_was_asked() {
                controlled::<$motion>();
            }

            #[test]
            fn interpolants_are_as_good_as_the_steps() {
                interpolated::<$motion>();
            }
        }
    )*};
}
on! {
    top: Top;
    shaken: Shaken;
    robot: Robot;
}

/// Errors of steps add up over a motion; a factor of so many between accuracy and final error is no surprise.
const ACCUMULATION: f64 = 100.0;

fn controlled<M: Motion>() {
    let reference = reference::<M>();
    for tableau in [&DOPRI5, &DOP853] {
        for accuracy in [1e-6, 1e-9, 1e-12] {
            let (mut system, mut motion) = (M::make::<f64>(), Adaptive::new(tableau, M::start(), 0.0, accuracy));
            while motion.time() < DURATION {
                motion.advance(&mut system, DURATION).unwrap();
            }
            let error = distance(motion.state(), &reference);
            assert!(error <= ACCUMULATION * accuracy, "{} at {accuracy:e}: {error:e}", tableau.name);
            assert!(error > 0.0, "{} at {accuracy:e} cannot be exact", tableau.name);
        }
    }
}

/// Within a step the state is that of a motion that ends there.
fn interpolated<M: Motion>() {
    const ACCURACY: f64 = 1e-9;
    for tableau in [&DOPRI5, &DOP853] {
        let (mut system, mut motion) = (M::make::<f64>(), Adaptive::new(tableau, M::start(), 0.0, ACCURACY));
        let mut between = M::start();
        let mut exact = Adaptive::new(&DOP853, M::start(), 0.0, 1e-3 * ACCURACY);
        let (mut before, mut seen) = (0.0, 0);
        while motion.time() < DURATION {
            motion.advance(&mut system, DURATION).unwrap();
            for theta in [0.3, 0.7, 1.0] {
                let time = before + theta * (motion.time() - before);
                motion.at(&mut system, time, &mut between);
                while exact.time() < time {
                    exact.advance(&mut system, time).unwrap();
                }
                let error = distance(&between, &wide(exact.state()));
                assert!(error <= ACCUMULATION * ACCURACY, "{} at {time}: {error:e}", tableau.name);
                seen += 1;
            }
            before = motion.time();
        }
        assert!(seen >= 6);
    }
}

/// A spinning top's angular momentum in the world stays, whatever the step: by 31 digits.
#[test]
fn the_reference_conserves_momentum_to_its_digits() {
    let mut system = Top::make::<DoubleDouble>();
    let start: State<DoubleDouble> = Top::start();
    let world = |state: &State<DoubleDouble>| state.pose.rotation * Vector3::from_column_slice(&state.flat);
    let before = world(&start);
    let mut motion = Adaptive::new(&DOP853, start, DoubleDouble::from(0.0), 1e-19);
    while motion.time() != DoubleDouble::from(DURATION) {
        motion.advance(&mut system, DURATION.into()).unwrap();
    }
    let drift = (world(motion.state()) - before).map(|x| x.high().abs()).max();
    assert!(drift < 1e-17, "{drift:e}");
}
