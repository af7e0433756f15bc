//! A workspace is memory, not state: answers depend on the state asked about, never on what was asked before.

use frs_core::Workspace;
use proptest::prelude::*;

use crate::outputs::{inputs, outputs, outputs_of};
use crate::trees::{case, config};

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

proptest! {
    #![proptest_config(config())]

    /// A workspace that has answered for another state, or every other question, answers bit for bit as a new one.
    #[test]
    fn a_used_workspace_answers_like_a_new_one(case in case(), shift in -1.0..1.0) {
        let (model, n) = (case.model(), case.dof());
        let here = inputs(&case);
        let elsewhere: Vec<f64> = here.iter().map(|number| number + shift).collect();
        let expected = bits(&outputs(&model, &here));

        let mut work = Workspace::new(&model);
        for state in [&elsewhere, &here] {
            let mut shape = work.shape(&state[..n]);
            let mut robot = shape.moving(&state[n..2 * n]);
            let first = bits(&outputs_of(&mut robot, state));
            let again = bits(&outputs_of(&mut robot, state));
            prop_assert_eq!(&first, &again);
            if state == &here {
                prop_assert_eq!(&first, &expected);
            }
        }
    }
}
