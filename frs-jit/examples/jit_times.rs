//! How long compiling at run time takes, and how fast its code is beside the core's and rustc's.
//!
//!     cargo run --release -p frs-jit --example jit_times

use std::hint::black_box;
use std::time::Instant;

use frs_core::{Evaluator, FloatingBase, Model, Quantity};
use frs_generated::{humanoid::Humanoid, lwr_satellite::LwrSatellite, quadruped::Quadruped};
use frs_jit::Robot;

const QUANTITIES: [Quantity; 4] = [Quantity::Inertia, Quantity::DMu, Quantity::B2, Quantity::ForwardDynamics];

/// Samples of a time; the least counts, for everything else only adds to it.
const SAMPLES: usize = 300;

/// Calls of a sample.
const CALLS: u32 = 30;

fn main() {
    println!("| robot (n) | quantity | operations | compiled in, ms | bytes | ns a call | / core | / rustc |");
    println!("|---|---|---|---|---|---|---|---|");
    rows(include_str!("../../robots/lwr_satellite.urdf"), &mut LwrSatellite);
    rows(include_str!("../../robots/quadruped.urdf"), &mut Quadruped);
    rows(include_str!("../../robots/humanoid.urdf"), &mut Humanoid);
}

/// The lines of a robot; the last one compiles everything.
fn rows(urdf: &str, generated: &mut impl FloatingBase) {
    let model = Model::from_urdf(urdf).unwrap_or_else(|error| panic!("{error}"));
    let (name, n) = (model.name(), model.dof());
    for quantity in QUANTITIES {
        let (seconds, mut robot) = made(&model, &[quantity]);
        let code = &robot.codes()[0].1;
        let (operations, bytes) = (code.operations(), code.bytes());
        let mut others: [&mut dyn FloatingBase; 3] = [&mut robot, &mut Evaluator::new(&model), generated];
        let [own, core, rustc] = times(&mut others, quantity, n);
        let rustc = if rustc.is_finite() { format!("{:.2}", own / rustc) } else { "–".into() };
        let ms = 1e3 * seconds;
        let ratio = own / core;
        println!(
            "| {name} ({n}) | `{}` | {operations} | {ms:.0} | {bytes} | {own:.0} | {ratio:.2} | {rustc} |",
            quantity.name()
        );
    }
    let (seconds, robot) = made(&model, &Quantity::ALL);
    let operations: usize = robot.codes().iter().map(|(_, code)| code.operations()).sum();
    let bytes: usize = robot.codes().iter().map(|(_, code)| code.bytes()).sum();
    println!("| {name} ({n}) | all | {operations} | {:.0} | {bytes} | | | |", 1e3 * seconds);
}

/// Compiles, and says in how many seconds, the recording included.
fn made(model: &Model, quantities: &[Quantity]) -> (f64, Robot) {
    let start = Instant::now();
    let robot = Robot::new(model, quantities).unwrap_or_else(|error| panic!("{error}"));
    (start.elapsed().as_secs_f64(), robot)
}

/// Nanoseconds a call of each robot, which take turns; NaN for one that does not answer.
fn times<const R: usize>(robots: &mut [&mut dyn FloatingBase; R], quantity: Quantity, n: usize) -> [f64; R] {
    let mut random = fastrand::Rng::with_seed(1);
    let inputs: Vec<Vec<f64>> =
        quantity.inputs().map(|input| (0..input.len(n)).map(|_| 2.0 * random.f64() - 1.0).collect()).collect();
    let inputs: Vec<&[f64]> = inputs.iter().map(Vec::as_slice).collect();
    let mut outputs: Vec<Vec<f64>> = quantity.outputs().map(|output| vec![0.0; output.len(n)]).collect();
    let mut outputs: Vec<&mut [f64]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
    let mut least = [f64::NAN; R];
    for _ in 0..SAMPLES {
        for (robot, least) in robots.iter_mut().zip(&mut least).filter(|(robot, _)| robot.answers(quantity)) {
            let start = Instant::now();
            (0..CALLS).for_each(|_| robot.answer(quantity, black_box(&inputs), &mut outputs));
            *least = least.min(1e9 * start.elapsed().as_secs_f64() / f64::from(CALLS));
        }
    }
    least
}
