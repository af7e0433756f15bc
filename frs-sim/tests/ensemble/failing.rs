//! A trajectory that cannot be continued does not disturb the others.

use std::ops::Range;

use frs_core::Real;
use frs_core::lanes::{F64x4, F64x8, Lane};
use frs_core::spatial::Twist;
use frs_sim::ensemble::{Arrival, Ensemble, Flown, Start};
use frs_sim::integrate::{Adaptive, DOP853, IntegrationError, State, System, Tangent};

use super::bits;

/// `ẋ = x²`, whose solution x = 1/(1/x₀ − t) ends at 1/x₀.
struct Square;

impl<T: Real> System<T> for Square {
    fn dimension(&self) -> usize {
        1
    }

    fn velocities(&self) -> Range<usize> {
        0..1
    }

    fn rate(&mut self, _: T, state: &State<T>, rate: &mut Tangent<T>) {
        rate.twist = Twist::zero();
        rate.flat[0] = state.flat[0] * state.flat[0];
    }
}

fn start(x: f64) -> Start {
    Start { state: State { flat: vec![x], ..State::origin(1) }, from: 0.0, until: 1.0 }
}

const ENSEMBLE: Ensemble = Ensemble { tableau: &DOP853, accuracy: 1e-10, times: Vec::new() };

fn flown<T: Lane<Element = f64>>(starts: &[Start]) -> Flown {
    ENSEMBLE.fly::<T, _>(starts, || Square, |_, _| {}).unwrap()
}

fn alone(start: &Start) -> (State, f64, Result<(), IntegrationError>) {
    let mut path = Adaptive::new(ENSEMBLE.tableau, start.state.clone(), start.from, ENSEMBLE.accuracy);
    let mut end = Ok(());
    while path.time() < start.until && end.is_ok() {
        end = path.advance(&mut Square, start.until);
    }
    (path.state().clone(), path.time(), end)
}

#[test]
fn a_pole_ends_its_own_trajectory_only() {
    let starts: Vec<_> = [0.5, 2.0, -1.0, 0.2, 4.0, 0.9, 0.1, 1e200, 0.3, -3.0].map(start).into();
    let ends =
        |flown: Flown| flown.arrivals.into_iter().map(|Arrival { state, time, end, .. }| (bits(&state), time, end));
    let expected: Vec<_> = starts.iter().map(alone).map(|(state, time, end)| (bits(&state), time, end)).collect();
    assert_eq!(expected.iter().filter(|(_, _, end)| end.is_err()).count(), 3);
    assert!(expected.iter().any(|(_, _, end)| matches!(end, Err(IntegrationError::StepTooSmall { .. }))));
    assert!(ends(flown::<f64>(&starts)).eq(expected.iter().cloned()));
    assert!(ends(flown::<F64x4>(&starts)).eq(expected.iter().cloned()));
    assert!(ends(flown::<F64x8>(&starts)).eq(expected));
}

#[test]
fn no_trajectory_is_no_work() {
    let flown = flown::<F64x4>(&[]);
    assert_eq!((flown.arrivals.len(), flown.passes, flown.occupancy(), flown.rejected()), (0, 0, 1.0, 0.0));
}
