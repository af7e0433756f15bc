//! The core over other scalars: one that records what is done to it, single precision, and one that encloses.

use frs_codegen::record::{Recorded, record, replay};
use frs_core::enclosure::Interval;
use frs_core::extended::DoubleDouble;
use nalgebra::DVector;
use proptest::prelude::*;

use crate::closeness::close;
use crate::outputs::{inputs, outputs};
use crate::trees::{case, config};

/// Rounding of single precision per unit of the condition numbers, which it cannot afford as double precision can.
const SINGLE_ROUNDING: f64 = 2e-5;

proptest! {
    #![proptest_config(config())]

    /// What the core does to a number depends on no value: recorded once, it can be replayed at any state, bit for bit.
    #[test]
    fn a_recording_replays_to_the_same_bits(case in case(), shift in -1.0..1.0) {
        let model = case.model();
        let here = inputs(&case);
        let (recorded, tape) = record(|| {
            let inputs: Vec<_> = (0..here.len() as u32).map(Recorded::input).collect();
            outputs(&model.cast::<Recorded>(), &inputs)
        });

        let elsewhere: Vec<f64> = here.iter().map(|number| number + shift).collect();
        for state in [here, elsewhere] {
            let values = replay(&tape, &state);
            let expected = outputs(&model, &state);
            prop_assert_eq!(recorded.len(), expected.len());
            for (number, (place, expected)) in recorded.iter().zip(&expected).enumerate() {
                // −0 and 0 are one number: a sum that starts at 0 may or may not see the sign.
                let [actual, expected] = [values[place.0 as usize], *expected].map(|value| (value + 0.0).to_bits());
                prop_assert_eq!(actual, expected, "output number {}", number);
            }
        }
    }

    #[test]
    fn single_precision_gives_the_same_numbers_to_its_own_rounding(case in case()) {
        let model = case.model();
        let state = inputs(&case);
        let single_state: Vec<f32> = state.iter().map(|number| *number as f32).collect();
        // Both precisions answer for the state that single precision can hold.
        let state: Vec<f64> = single_state.iter().copied().map(f64::from).collect();
        let expected = DVector::from_vec(outputs(&model, &state));
        let single = outputs(&model.cast::<f32>(), &single_state);
        let actual = DVector::from_iterator(single.len(), single.into_iter().map(f64::from));
        let spec = case.specification(&model);
        close(&actual, &expected, SINGLE_ROUNDING * spec.shape_condition())?;
    }

    /// Two numbers that are made without each other: exact to 31 digits, and between two doubles.
    #[test]
    fn what_31_digits_give_is_enclosed(case in case()) {
        let model = case.model();
        let state = inputs(&case);
        let precise: Vec<_> = state.iter().copied().map(DoubleDouble::from).collect();
        let expected = outputs(&model.cast::<DoubleDouble>().orthonormalised(), &precise);
        let enclosing: Vec<_> = state.iter().copied().map(Interval::from).collect();
        let enclosed = outputs(&model.cast::<Interval>().orthonormalised(), &enclosing);
        for (number, (interval, exact)) in enclosed.iter().zip(&expected).enumerate() {
            prop_assert!(interval.contains(exact.high()), "output {number}: {interval:?} without {exact:?}");
        }
    }
}
