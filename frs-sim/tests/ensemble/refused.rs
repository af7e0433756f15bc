//! What is wrong with a list of starts is told in place, before anything is computed.

use frs_core::lanes::F64x4;
use frs_core::urdf::LWR_SATELLITE;
use frs_core::{Model, spatial::Pose, spatial::Twist};
use frs_sim::ensemble::{Ensemble, Start, Torques};
use frs_sim::integrate::{DOP853, RK4};
use frs_sim::motion::{Motion, Zero};

/// The message for ten starts of a satellite, of which `spoil` spoils something.
fn refused(spoil: impl Fn(&mut Ensemble, &mut [Start])) -> String {
    let model = Model::from_urdf(LWR_SATELLITE).unwrap();
    let state = Motion::new(&model, Zero, ()).state(Pose::identity(), &[0.3; 7], &[0.1; 7], Twist::zero());
    let mut starts = vec![Start { state, from: 0.0, until: 0.1 }; 10];
    let mut ensemble = Ensemble { tableau: &DOP853, accuracy: 1e-6, times: vec![0.0, 0.1] };
    spoil(&mut ensemble, &mut starts);
    let model = model.cast::<F64x4>();
    let flown = ensemble.fly(&starts, || Motion::new(&model, Zero, Torques::none(7)), |_, _| {});
    flown.map_or_else(|error| error.to_string(), |_| "not refused".to_owned())
}

#[test]
fn what_is_wrong_is_told_in_place() {
    assert_eq!(refused(|_, _| {}), "not refused");
    let method = "rkmk4 estimates no error; expected a method that does; take dopri5 or dop853";
    assert_eq!(refused(|ensemble, _| ensemble.tableau = &RK4), method);
    for accuracy in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let message = format!("accuracy is {accuracy}; expected a positive number");
        assert_eq!(refused(|ensemble, _| ensemble.accuracy = accuracy), message);
    }
    for (second, shown) in [(0.0, "0"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let message = format!("times[1] is {shown} s; expected finite times, each later than the one before");
        assert_eq!(refused(|ensemble, _| ensemble.times[1] = second), message);
    }
    assert_eq!(
        refused(|_, starts| starts[3].state.flat.truncate(13)),
        "trajectory 3: the state has 13 numbers besides its pose; expected 14, as the system has"
    );
    assert_eq!(
        refused(|_, starts| starts[4].state.flat[8] = f64::NAN),
        "trajectory 4: state.flat[8] is NaN; expected a finite number"
    );
    assert_eq!(
        refused(|_, starts| starts[9].state.pose.translation.z = f64::INFINITY),
        "trajectory 9: state.pose.translation[2] is inf; expected a finite number"
    );
    assert_eq!(
        refused(|_, starts| starts[0].state.pose.rotation[(1, 0)] = f64::NAN),
        "trajectory 0: state.pose.rotation[1] is NaN; expected a finite number"
    );
    assert_eq!(
        refused(|_, starts| starts[1].until = f64::INFINITY),
        "trajectory 1: until is inf; expected a finite number"
    );
    assert_eq!(refused(|_, starts| starts[1].from = f64::NAN), "trajectory 1: from is NaN; expected a finite number");
    assert_eq!(
        refused(|_, starts| starts[2].from = 0.2),
        "trajectory 2: it ends at 0.1 s and begins at 0.2 s; expected an end that is not before the start"
    );
}
