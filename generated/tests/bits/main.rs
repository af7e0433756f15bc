//! Generated code performs the core's own operations: every output has the same bits.

mod answers;
mod states;

use std::path::Path;

use answers::{answer, difference};
use frs_codegen::record::{Recorded, record, replay};
use frs_codegen::{Options, Program};
use frs_core::{Evaluator, FloatingBase, Model, Quantity, Real};
use states::States;

/// States at which each quantity of each robot is compared.
const STATES: usize = 10_000;

/// States at which recordings are interpreted too: slower by the cost of an interpreter.
const INTERPRETED_STATES: usize = 100;

fn robot(file: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots").join(file);
    Model::from_urdf(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Every quantity that `generated` answers; those of its links too.
fn answered(model: &Model, generated: &impl FloatingBase) -> Vec<Quantity> {
    let links = (0..model.links().len()).map(Quantity::Kinematics);
    let known: Vec<_> = Quantity::ALL.into_iter().chain(links).filter(|&q| generated.answers(q)).collect();
    assert!(known.len() >= 4, "a robot that answers next to nothing proves nothing");
    known
}

fn every_output_has_the_bits_of_the_core(file: &str, mut generated: impl FloatingBase) {
    let model = robot(file);
    let mut core = Evaluator::new(&model);
    for quantity in answered(&model, &generated) {
        let mut states = States::new(1);
        let mut finite = 0;
        for state in 0..STATES {
            let inputs = states.next(quantity, model.dof());
            let expected = answer(&mut core, quantity, &inputs);
            let actual = answer(&mut generated, quantity, &inputs);
            if let Some(difference) = difference(quantity, &expected, &actual) {
                panic!("{file}, state {state}: {difference}\nat {inputs:?}");
            }
            finite += usize::from(expected.iter().flatten().all(|x| x.is_finite()));
        }
        assert!(finite > STATES / 2, "{file}, {quantity:?}: only {finite} of {STATES} states had finite answers");
    }
}

/// The recording as it was made, the recording as it was simplified, the compiled code, and the core: the same bits.
fn interpreted_recordings_have_the_bits_of_the_core(file: &str, mut generated: impl FloatingBase) {
    let model = robot(file);
    let n = model.dof();
    let mut core = Evaluator::new(&model);
    let program = Program::new(&model, &Options::default()).unwrap();
    for function in &program.functions {
        let quantity = function.quantity;
        let (places, tape) = record(|| {
            let mut number = 0;
            let mut next = || {
                number += 1;
                Recorded::input(number - 1)
            };
            let inputs: Vec<Vec<Recorded>> =
                quantity.inputs().map(|input| (0..input.len(n)).map(|_| next()).collect()).collect();
            let model = model.map(Recorded::from_f64);
            answer(&mut Evaluator::new(&model), quantity, &inputs)
        });
        let mut states = States::new(2);
        for _ in 0..INTERPRETED_STATES {
            let inputs = states.next(quantity, n);
            let expected = answer(&mut core, quantity, &inputs);
            let values = replay(&tape, &inputs.concat());
            let recorded: Vec<Vec<f64>> =
                places.iter().map(|output| output.iter().map(|place| values[place.0 as usize]).collect()).collect();
            assert_eq!(difference(quantity, &expected, &recorded), None, "{file}: the recording");

            let mut numbers = vec![0.0; program.inputs.iter().map(|input| input.len).sum()];
            for (&array, values) in function.inputs.iter().zip(&inputs) {
                numbers[program.inputs[array].start as usize..][..values.len()].copy_from_slice(values);
            }
            let values = replay(program.graph.operations(), &numbers);
            let simplified: Vec<Vec<f64>> =
                function.outputs.iter().map(|o| o.places.iter().map(|&p| values[p as usize] + 0.0).collect()).collect();
            assert_eq!(difference(quantity, &expected, &simplified), None, "{file}: the simplified recording");
            if generated.answers(quantity) {
                let compiled = answer(&mut generated, quantity, &inputs);
                assert_eq!(difference(quantity, &simplified, &compiled), None, "{file}: the compiled code");
            }
        }
    }
}

macro_rules! robots {
    ($($module:ident: $robot:ident, $file:literal;)*) => {
        $(mod $module {
            use super::*;

            #[test]
            fn compiled_code_has_the_bits_of_the_core() {
                every_output_has_the_bits_of_the_core($file, frs_generated::$module::$robot);
            }

            #[test]
            fn interpreted_code_has_the_bits_of_the_core() {
                interpreted_recordings_have_the_bits_of_the_core($file, frs_generated::$module::$robot);
            }
        })*
    };
}

robots! {
    chaser: Chaser, "chaser.urdf";
    dual_arm_satellite: DualArmSatellite, "dual_arm_satellite.urdf";
    humanoid: Humanoid, "humanoid.urdf";
    lwr_satellite: LwrSatellite, "lwr_satellite.urdf";
    planar_three_link: PlanarThreeLink, "planar_three_link.urdf";
    quadruped: Quadruped, "quadruped.urdf";
}
