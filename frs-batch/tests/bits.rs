//! A batch has the bits of its states asked one by one: at every width, on every number of threads, by all instructions, in both orders of memory.

mod states;

use frs_batch::{Group, Instructions, Lane, Recording, Side, answer};
use frs_core::lanes::{F32x8, F32x16, F64x4, F64x8};
use frs_core::{Evaluator, FloatingBase, Model, Quantity};
use ndarray::Array2;

use states::{Order, answers, bits, model, states};

/// Fewer states than lanes, as many, one more, and more than a task of every thread; more than a block and no multiple of one.
const COUNTS: [usize; 7] = [0, 1, 7, 8, 9, 33, 1000];

const QUANTITIES: [Quantity; 6] = [
    Quantity::Inertia,
    Quantity::Matrices,
    Quantity::DQdotXi,
    Quantity::Curvature,
    Quantity::ForwardDynamics,
    Quantity::Kinematics(2),
];

/// One state after the other.
fn one_by_one(model: &Model, quantity: Quantity, inputs: &[Array2<f64>]) -> Vec<Vec<u64>> {
    let mut robot = Evaluator::new(model);
    let mut found: Vec<Vec<u64>> = quantity.outputs().map(|_| Vec::new()).collect();
    for state in 0..inputs[0].nrows() {
        let given: Vec<Vec<f64>> = inputs.iter().map(|array| array.row(state).to_vec()).collect();
        let given: Vec<&[f64]> = given.iter().map(Vec::as_slice).collect();
        let mut outputs: Vec<Vec<f64>> =
            quantity.outputs().map(|output| vec![f64::NAN; output.len(model.dof())]).collect();
        robot.answer(quantity, &given, &mut outputs.iter_mut().map(Vec::as_mut_slice).collect::<Vec<_>>());
        found.iter_mut().zip(outputs).for_each(|(all, state)| all.extend(state.iter().map(|number| number.to_bits())));
    }
    found
}

/// Asserts that `robot` answers as the core does state by state, whatever the count, the order and the threads.
fn assert_bits<G: Group<Element = f64>>(
    name: &str,
    robot: impl Fn(&Model, Quantity) -> G + Sync,
    quantities: &[Quantity],
) {
    let model = model(name);
    for &quantity in quantities {
        let (all, numbers) = (states(&model, quantity, 1000, 7), quantity.outputs().count());
        let expected = one_by_one(&model, quantity, &all);
        for count in COUNTS {
            for (threads, order) in [(1, Order::Rows), (1, Order::Columns), (2, Order::Columns), (3, Order::Rows)] {
                let found = answers(|| robot(&model, quantity), quantity, &all, count, order, threads);
                for output in 0..numbers {
                    let len = expected[output].len() / 1000 * count;
                    assert!(
                        bits(&found[output]).eq(expected[output][..len].iter().copied()),
                        "{name}: {}, output {output}: {count} states {order:?} on {threads} threads",
                        quantity.name()
                    );
                }
            }
        }
    }
}

fn assert_side<T: Lane<Element = f64>>() {
    for name in ["chaser", "dual_arm_satellite"] {
        let cast = model(name).cast::<T>();
        assert_bits(name, |_, _| Side::new(Evaluator::new(&cast)), &QUANTITIES);
    }
}

#[test]
fn one_state_at_a_time_is_the_core() {
    assert_side::<f64>();
}

#[test]
fn four_lanes_have_the_bits_of_one() {
    assert_side::<F64x4>();
}

#[test]
fn eight_lanes_have_the_bits_of_one() {
    assert_side::<F64x8>();
}

/// Checked-in code is made without the feature.
#[cfg(not(feature = "fused"))]
#[test]
fn generated_robots_answer_batches() {
    use frs_generated::lwr_satellite::LwrSatellite;
    assert_bits(
        "lwr_satellite",
        |_, _| Side::<f64, _>::new(LwrSatellite),
        &[Quantity::Inertia, Quantity::ForwardDynamics],
    );
}

/// Every quantity, of a robot whose joints mimic others and of one in which none does.
#[test]
fn blocks_have_the_bits_of_one_state() {
    for name in ["chaser", "lwr_satellite", "dual_arm_satellite"] {
        for quantity in Quantity::ALL.into_iter().chain([Quantity::Kinematics(2)]) {
            let recording = Recording::new(&model(name), quantity).unwrap();
            assert_bits(name, |_, _| recording.blocks(), &[quantity]);
        }
    }
}

#[test]
fn all_instructions_give_the_same_bits_and_are_those_asked_for() {
    let model = model("lwr_satellite");
    for instructions in Instructions::ALL.into_iter().filter(|instructions| instructions.are_here()) {
        for quantity in QUANTITIES {
            let recording = Recording::new(&model, quantity).unwrap();
            assert_bits("lwr_satellite", |_, _| recording.blocks_by(instructions), &[quantity]);
            let mut robot = recording.blocks_by(instructions);
            let inputs = states(&model, quantity, 3, 5);
            let mut outputs: Vec<_> = quantity.outputs().map(|output| Array2::zeros((3, output.len(7)))).collect();
            let views: Vec<_> = inputs.iter().map(|array| array.view()).collect();
            robot.answer(quantity, &views, &mut outputs.iter_mut().map(|array| array.view_mut()).collect::<Vec<_>>());
            assert_eq!(robot.performed(), Some(instructions));
        }
    }
}

#[test]
fn the_widest_instructions_are_taken() {
    let recording = Recording::new(&model("chaser"), Quantity::Momentum).unwrap();
    assert_eq!(recording.blocks().instructions(), Instructions::widest());
    assert!(
        Instructions::ALL
            .into_iter()
            .all(|instructions| !instructions.are_here() || instructions <= Instructions::widest())
    );
}

/// 77 is no multiple of eight or sixteen.
fn singles<T: Lane<Element = f32>>(model: &Model<T>, quantity: Quantity, inputs: &[Array2<f32>]) -> Vec<u32> {
    let n = model.dof();
    let mut outputs: Vec<_> =
        quantity.outputs().map(|output| Array2::from_elem((77, output.len(n)), f32::NAN)).collect();
    let given: Vec<_> = inputs.iter().map(|array| array.view()).collect();
    let asked = outputs.iter_mut().map(|array| array.view_mut()).collect();
    answer(|| Side::new(Evaluator::new(model)), quantity, &given, asked).unwrap();
    outputs.iter().flatten().map(|number| number.to_bits()).collect()
}

#[test]
fn singles_in_lanes_have_the_bits_of_one() {
    let model = model("dual_arm_satellite");
    for quantity in QUANTITIES {
        let inputs: Vec<_> =
            states(&model, quantity, 77, 3).iter().map(|array| array.mapv(|number| number as f32)).collect();
        let expected = singles(&model.cast::<f32>(), quantity, &inputs);
        assert_eq!(singles(&model.cast::<F32x8>(), quantity, &inputs), expected, "{}", quantity.name());
        assert_eq!(singles(&model.cast::<F32x16>(), quantity, &inputs), expected, "{}", quantity.name());
    }
}
