//! Microseconds per state of batches, by every way of answering them, as the table of docs/batch.md.
//!
//! `cargo run --release -p frs-batch --example times`, and the same with `RUSTFLAGS="-C target-cpu=native" CARGO_TARGET_DIR=target/native`.

use std::time::Instant;

use frs_batch::{Group, Instructions, Recording, Side, answer};
use frs_core::lanes::{F64x4, F64x8};
use frs_core::{Evaluator, Model, Quantity};
use ndarray::{Array2, ArrayView2};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// States of a call. Their answers fit into the caches that two cores share.
const STATES: usize = 512;

/// Calls of each way; they take turns, so that what else the machine does meets all alike. The least counts.
const TURNS: usize = 200;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let pools = [1, 2].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build());
    let [one, two] = pools;
    let (one, two) = (one?, two?);
    println!(
        "| robot (n) | quantity | one state | 4 lanes | 8 lanes | blocks, as compiled | AVX2 | AVX-512 | 8 lanes, 2 threads | blocks, 2 threads |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for urdf in ["lwr_satellite", "humanoid"] {
        let path = format!("{}/../robots/{urdf}.urdf", env!("CARGO_MANIFEST_DIR"));
        let model = Model::from_urdf(&std::fs::read_to_string(path)?)?;
        let (four, eight) = (model.cast::<F64x4>(), model.cast::<F64x8>());
        for quantity in [Quantity::Inertia, Quantity::Matrices, Quantity::ForwardDynamics] {
            let recording = Recording::new(&model, quantity)?;
            let states = States::random(quantity, model.dof());
            let blocks = |instructions: Instructions| recording.blocks_by(instructions);
            let lanes = || Side::new(Evaluator::new(&eight));
            let mut ways: Vec<Box<dyn FnMut() -> f64 + '_>> = vec![
                states.way(&one, || Side::new(Evaluator::new(&model))),
                states.way(&one, || Side::new(Evaluator::new(&four))),
                states.way(&one, lanes),
            ];
            for instructions in Instructions::ALL {
                ways.push(match instructions.are_here() {
                    true => states.way(&one, move || blocks(instructions)),
                    false => Box::new(|| f64::NAN),
                });
            }
            ways.push(states.way(&two, lanes));
            ways.push(states.way(&two, move || blocks(Instructions::widest())));
            let mut least = vec![f64::INFINITY; ways.len()];
            for _ in 0..TURNS {
                least.iter_mut().zip(&mut ways).for_each(|(least, way)| *least = least.min(way()));
            }
            let times: Vec<String> = least.iter().map(|time| format!("{time:.2}")).collect();
            println!("| {urdf} ({}) | `{}` | {} |", model.dof(), quantity.name(), times.join(" | "));
        }
    }
    Ok(())
}

/// Random states of a quantity.
struct States {
    quantity: Quantity,
    inputs: Vec<Array2<f64>>,
    dof: usize,
}

impl States {
    fn random(quantity: Quantity, dof: usize) -> Self {
        let mut random = fastrand::Rng::with_seed(1);
        let inputs = quantity
            .inputs()
            .map(|input| Array2::from_shape_simple_fn((STATES, input.len(dof)), || 3.0 * (random.f64() - 0.5)))
            .collect();
        Self { quantity, inputs, dof }
    }

    /// A call, in microseconds per state.
    fn way<'a, G: Group<Element = f64>>(
        &'a self,
        pool: &'a ThreadPool,
        robot: impl Fn() -> G + Sync + Send + 'a,
    ) -> Box<dyn FnMut() -> f64 + 'a> {
        let mut outputs: Vec<Array2<f64>> =
            self.quantity.outputs().map(|output| Array2::zeros((STATES, output.len(self.dof)))).collect();
        Box::new(move || {
            let inputs: Vec<ArrayView2<f64>> = self.inputs.iter().map(|array| array.view()).collect();
            let asked = outputs.iter_mut().map(|array| array.view_mut()).collect();
            let robot = &robot;
            let begin = Instant::now();
            let answered = pool.install(|| answer(robot, self.quantity, &inputs, asked));
            let time = begin.elapsed().as_secs_f64();
            answered.map_or(f64::NAN, |()| time * 1e6 / STATES as f64)
        })
    }
}
