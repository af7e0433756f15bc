//! Microseconds per state of batches, by every way of answering them, as the table of docs/batch.md.
//!
//! `cargo run --release -p frs-batch --example batch_times`, and the same with `RUSTFLAGS="-C target-cpu=native" CARGO_TARGET_DIR=target/native`.

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
    let one = ThreadPoolBuilder::new().num_threads(1).build()?;
    println!("| robot (n) | quantity | one state | 4 lanes | 8 lanes | blocks, as compiled | AVX2 | AVX-512 |");
    println!("|---|---|---|---|---|---|---|---|");
    for urdf in ["lwr_satellite", "humanoid"] {
        let path = format!("{}/../robots/{urdf}.urdf", env!("CARGO_MANIFEST_DIR"));
        let model = Model::from_urdf(&std::fs::read_to_string(path)?)?;
        let (four, eight) = (model.cast::<F64x4>(), model.cast::<F64x8>());
        for quantity in [Quantity::Inertia, Quantity::Matrices, Quantity::ForwardDynamics] {
            let recording = Recording::new(&model, quantity)?;
            let states = States::random(STATES, quantity, model.dof());
            let blocks = |instructions: Instructions| recording.blocks_by(instructions);
            let mut ways: Vec<Box<dyn FnMut() -> f64 + '_>> = vec![
                states.way(&one, || Side::new(Evaluator::new(&model))),
                states.way(&one, || Side::new(Evaluator::new(&four))),
                states.way(&one, || Side::new(Evaluator::new(&eight))),
            ];
            for instructions in Instructions::ALL {
                ways.push(match instructions.are_here() {
                    true => states.way(&one, move || blocks(instructions)),
                    false => Box::new(|| f64::NAN),
                });
            }
            let mut least = vec![f64::INFINITY; ways.len()];
            for _ in 0..TURNS {
                least.iter_mut().zip(&mut ways).for_each(|(least, way)| *least = least.min(way()));
            }
            let times: Vec<String> = least.iter().map(|time| format!("{time:.2}")).collect();
            println!("| {urdf} ({}) | `{}` | {} |", model.dof(), quantity.name(), times.join(" | "));
        }
    }
    threads()
}

/// How many times as fast as one thread several are, at the states of many calls.
fn threads() -> Result<(), Box<dyn std::error::Error>> {
    let most = std::thread::available_parallelism()?.get();
    let counts: Vec<usize> =
        std::iter::successors(Some(1), |count| Some(2 * count)).take_while(|&count| count <= most).collect();
    let pools: Vec<ThreadPool> =
        counts.iter().map(|&count| ThreadPoolBuilder::new().num_threads(count).build()).collect::<Result<_, _>>()?;
    let titles: Vec<String> = counts.iter().skip(1).map(|count| format!("{count} threads")).collect();
    println!("\n| robot (n) | quantity | way | 1 thread, µs | {} |", titles.join(" | "));
    println!("|---|---|---|---|{}", "---|".repeat(titles.len()));
    for urdf in ["lwr_satellite", "humanoid"] {
        let path = format!("{}/../robots/{urdf}.urdf", env!("CARGO_MANIFEST_DIR"));
        let model = Model::from_urdf(&std::fs::read_to_string(path)?)?;
        let eight = model.cast::<F64x8>();
        for quantity in [Quantity::Inertia, Quantity::ForwardDynamics] {
            let recording = Recording::new(&model, quantity)?;
            let states = States::random(64 * STATES, quantity, model.dof());
            let mut ways = Vec::new();
            for pool in &pools {
                ways.push(states.way(pool, || recording.blocks()));
                ways.push(states.way(pool, || Side::new(Evaluator::new(&eight))));
            }
            let mut least = vec![f64::INFINITY; ways.len()];
            for _ in 0..TURNS / 8 {
                least.iter_mut().zip(&mut ways).for_each(|(least, way)| *least = least.min(way()));
            }
            for (number, way) in ["blocks", "8 lanes"].into_iter().enumerate() {
                let times: Vec<f64> = least.iter().copied().skip(number).step_by(2).collect();
                let gains: Vec<String> = times[1..].iter().map(|time| format!("{:.2}", times[0] / time)).collect();
                let (n, name) = (model.dof(), quantity.name());
                println!("| {urdf} ({n}) | `{name}` | {way} | {:.2} | {} |", times[0], gains.join(" | "));
            }
        }
    }
    Ok(())
}

/// Random states of a quantity.
struct States {
    quantity: Quantity,
    inputs: Vec<Array2<f64>>,
    count: usize,
    dof: usize,
}

impl States {
    fn random(count: usize, quantity: Quantity, dof: usize) -> Self {
        let mut random = fastrand::Rng::with_seed(1);
        let inputs = quantity
            .inputs()
            .map(|input| Array2::from_shape_simple_fn((count, input.len(dof)), || 3.0 * (random.f64() - 0.5)))
            .collect();
        Self { quantity, inputs, count, dof }
    }

    /// A call, in microseconds per state.
    fn way<'a, G: Group<Element = f64>>(
        &'a self,
        pool: &'a ThreadPool,
        robot: impl Fn() -> G + Sync + Send + 'a,
    ) -> Box<dyn FnMut() -> f64 + 'a> {
        let mut outputs: Vec<Array2<f64>> =
            self.quantity.outputs().map(|output| Array2::zeros((self.count, output.len(self.dof)))).collect();
        Box::new(move || {
            let inputs: Vec<ArrayView2<f64>> = self.inputs.iter().map(|array| array.view()).collect();
            let asked = outputs.iter_mut().map(|array| array.view_mut()).collect();
            let robot = &robot;
            let begin = Instant::now();
            let answered = pool.install(|| answer(robot, self.quantity, &inputs, asked));
            let time = begin.elapsed().as_secs_f64();
            answered.map_or(f64::NAN, |()| time * 1e6 / self.count as f64)
        })
    }
}
