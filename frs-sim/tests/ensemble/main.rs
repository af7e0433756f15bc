//! Trajectories side by side have the bits that each has alone.

mod failing;
mod fleet;
mod refused;

use frs_core::lanes::{F64x4, F64x8, Lane};
use frs_core::spatial::Wrench;
use frs_core::{Model, Real};
use frs_sim::ensemble::{Arrival, Ensemble};
use frs_sim::integrate::{DOP853, DOPRI5, State};
use frs_sim::motion::{Conserved, Driven, Momentum, Zero};

use fleet::Fleet;

/// What is known of the momentum, over any number.
pub trait Case {
    type Momentum<T: Real>: Momentum<T>;

    fn make<T: Real>() -> Self::Momentum<T>;

    /// Puts a trajectory's momentum into a lane.
    fn set<T: Lane<Element = f64>>(_: &mut Self::Momentum<T>, _: usize, _: Wrench<f64>) {}
}

struct AtZero;
struct Constant;
struct Integrated;

impl Case for AtZero {
    type Momentum<T: Real> = Zero;

    fn make<T: Real>() -> Zero {
        Zero
    }
}

impl Case for Constant {
    type Momentum<T: Real> = Conserved<T>;

    fn make<T: Real>() -> Conserved<T> {
        Conserved { momentum: Wrench::zero() }
    }

    fn set<T: Lane<Element = f64>>(known: &mut Conserved<T>, lane: usize, momentum: Wrench<f64>) {
        known.set(lane, momentum);
    }
}

impl Case for Integrated {
    type Momentum<T: Real> = Driven;

    fn make<T: Real>() -> Driven {
        Driven
    }
}

fn model(robot: &str) -> Model {
    let path = format!("{}/../robots/{robot}.urdf", env!("CARGO_MANIFEST_DIR"));
    Model::from_urdf(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// All bits of a state.
fn bits(state: &State) -> Vec<u64> {
    let pose = state.pose.rotation.iter().chain(&state.pose.translation);
    pose.chain(&state.flat).map(|number| number.to_bits()).collect()
}

fn assert_same(found: &[Arrival], expected: &[Arrival], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (number, (found, expected)) in found.iter().zip(expected).enumerate() {
        let counts = |of: &Arrival| (of.steps, of.rejected, of.evaluations, of.samples.len());
        assert_eq!(counts(found), counts(expected), "{what}: trajectory {number}");
        assert_eq!((found.time, &found.end), (expected.time, &expected.end), "{what}: trajectory {number}");
        assert_eq!(bits(&found.state), bits(&expected.state), "{what}: trajectory {number}");
        for (found, expected) in found.samples.iter().zip(&expected.samples) {
            assert_eq!(found.time, expected.time, "{what}: trajectory {number}");
            assert_eq!(bits(&found.state), bits(&expected.state), "{what}: trajectory {number}, {} s", found.time);
        }
    }
}

/// Trajectories that differ in all that they may, of which there are no multiple of the lanes.
fn assert_bits<C: Case>(robot: &str, ensemble: Ensemble) {
    let fleet = Fleet::random::<C>(model(robot), 21, ensemble);
    let alone = fleet.alone::<C>();
    let steps = || alone.iter().filter(|arrival| arrival.end.is_ok()).map(|arrival| arrival.steps);
    assert_eq!(alone.iter().filter(|arrival| arrival.end.is_err()).count(), 1);
    assert!(alone.iter().any(|arrival| arrival.rejected > 2) && alone.iter().any(|arrival| arrival.rejected == 0));
    assert!(steps().max() > steps().filter(|&steps| steps > 0).min().map(|steps| 5 * steps));

    for threads in [1, 2] {
        let what = |lanes: usize| format!("{robot}, {lanes} lanes, {threads} threads");
        assert_same(&fleet.fly::<C, f64>(threads).arrivals, &alone, &what(1));
        assert_same(&fleet.fly::<C, F64x4>(threads).arrivals, &alone, &what(4));
        assert_same(&fleet.fly::<C, F64x8>(threads).arrivals, &alone, &what(8));
    }
    // In another order, in other lanes.
    let mut turned = fleet.reversed().fly::<C, F64x4>(1).arrivals;
    turned.reverse();
    assert_same(&turned, &alone, "the other way round");
}

#[test]
fn lanes_have_the_bits_of_one_at_zero_momentum() {
    assert_bits::<AtZero>(
        "lwr_satellite",
        Ensemble { tableau: &DOP853, accuracy: 1e-8, times: vec![0.0, 0.05, 0.0501, 0.3] },
    );
}

#[test]
fn lanes_have_the_bits_of_one_at_constant_momentum() {
    assert_bits::<Constant>(
        "quadruped",
        Ensemble { tableau: &DOPRI5, accuracy: 1e-5, times: (0..50).map(|i| 0.01 * f64::from(i)).collect() },
    );
}

#[test]
fn lanes_have_the_bits_of_one_where_the_momentum_is_driven() {
    assert_bits::<Integrated>("humanoid", Ensemble { tableau: &DOP853, accuracy: 1e-4, times: Vec::new() });
    // A joint that mimics another.
    assert_bits::<Integrated>("chaser", Ensemble { tableau: &DOPRI5, accuracy: 1e-6, times: vec![0.2] });
}

#[test]
fn samples_change_no_step() {
    let ensemble = Ensemble { tableau: &DOP853, accuracy: 1e-6, times: vec![0.1, 0.2] };
    let mut fleet = Fleet::random::<AtZero>(model("lwr_satellite"), 9, ensemble);
    let mut sampled = fleet.fly::<AtZero, F64x4>(1);
    assert!(sampled.arrivals.iter().any(|arrival| arrival.samples.len() == 2));
    sampled.arrivals.iter_mut().for_each(|arrival| arrival.samples.clear());
    fleet.ensemble.times.clear();
    let plain = fleet.fly::<AtZero, F64x4>(1);
    assert_same(&plain.arrivals, &sampled.arrivals, "without samples");
    assert_eq!(plain.passes, sampled.passes);
}

/// Were lanes not taken again before all had arrived, trajectories of which some are ten times as long as others would leave half of them
/// empty.
const BUSY: f64 = 0.85;

#[test]
fn lanes_that_have_arrived_take_the_next_trajectory() {
    let ensemble = Ensemble { tableau: &DOPRI5, accuracy: 1e-4, times: Vec::new() };
    let fleet = Fleet::random::<AtZero>(model("planar_three_link"), 200, ensemble);
    let (one, eight) = (fleet.fly::<AtZero, f64>(1), fleet.fly::<AtZero, F64x8>(1));
    assert_eq!((one.occupancy(), one.rejected()), (1.0, eight.rejected()));
    assert!(eight.occupancy() > BUSY && eight.occupancy() < 1.0, "{}", eight.occupancy());
    assert!(eight.rejected() > 0.0);
}
