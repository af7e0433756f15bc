//! Simulated seconds per second of many trajectories, one at a time and in lanes, as the table of docs/ensemble.md.
//!
//! `cargo run --release -p frs-sim --example ensemble`, and the same with `RUSTFLAGS="-C target-cpu=native" CARGO_TARGET_DIR=target/native`.

use std::time::Instant;

use frs_core::Model;
use frs_core::lanes::{F64x4, F64x8, Lane};
use frs_core::spatial::{Pose, Twist, Wrench};
use frs_sim::effects::{Spring, Viscous};
use frs_sim::ensemble::{Ensemble, Flown, Start, Torques};
use frs_sim::integrate::{Adaptive, DOP853};
use frs_sim::motion::{Conserved, Motion};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Trajectories of a call.
const TRAJECTORIES: usize = 128;

/// Length of each, s.
const DURATION: f64 = 0.25;

/// Calls of each way; they take turns, so that what else the machine does meets all alike. The fastest counts.
const TURNS: usize = 40;

const ACCURACY: f64 = 1e-6;

type Tumbling<'m, T> = Motion<'m, Conserved<T>, (Torques<T>, (Spring, Viscous)), T>;

type Failure = Box<dyn std::error::Error>;

/// Integrates all trajectories; of lanes, what became of them.
type Way<'f> = Box<dyn Fn() -> Result<Option<Flown>, Failure> + 'f>;

fn main() -> Result<(), Failure> {
    let [one, all] = [1, 0].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build());
    let (one, all) = (one?, all?);
    println!(
        "| robot (n) | one at a time | 4 lanes | 8 lanes | {threads} threads: 1 lane | 4 lanes | 8 lanes | occupancy of 4, 8 lanes | rejected |",
        threads = all.current_num_threads()
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for robot in ["lwr_satellite", "quadruped", "humanoid"] {
        let path = format!("{}/../robots/{robot}.urdf", env!("CARGO_MANIFEST_DIR"));
        let fleet = Fleet::random(Model::from_urdf(&std::fs::read_to_string(path)?)?);
        let (four, eight) = (fleet.model.cast(), fleet.model.cast());
        let ways: Vec<Way<'_>> = vec![
            Box::new(|| fleet.alone()),
            Box::new(|| fleet.fly::<F64x4>(&four, &one)),
            Box::new(|| fleet.fly::<F64x8>(&eight, &one)),
            Box::new(|| fleet.fly::<f64>(&fleet.model, &all)),
            Box::new(|| fleet.fly::<F64x4>(&four, &all)),
            Box::new(|| fleet.fly::<F64x8>(&eight, &all)),
        ];
        let (mut least, mut flown) = (vec![f64::INFINITY; ways.len()], vec![None; ways.len()]);
        for _ in 0..TURNS {
            for ((least, flown), way) in least.iter_mut().zip(&mut flown).zip(&ways) {
                let begin = Instant::now();
                *flown = way()?;
                *least = least.min(begin.elapsed().as_secs_f64());
            }
        }
        let speeds: Vec<_> =
            least.iter().map(|least| format!("{:.0}", TRAJECTORIES as f64 * DURATION / least)).collect();
        let flown: Vec<_> = flown.iter().flatten().collect();
        println!(
            "| {robot} ({}) | {} | {:.2}, {:.2} | {:.2} |",
            fleet.model.dof(),
            speeds.join(" | "),
            flown[0].occupancy(),
            flown[1].occupancy(),
            flown[0].rejected()
        );
    }
    Ok(())
}

/// Random starts of a robot that tumbles, with springs and dampers in its joints, and torques.
struct Fleet {
    model: Model,
    starts: Vec<Start>,
    tau: Vec<Vec<f64>>,
    momentum: Vec<Wrench<f64>>,
}

impl Fleet {
    fn random(model: Model) -> Self {
        let n = model.dof();
        let mut random = fastrand::Rng::with_seed(1);
        let mut numbers = |len: usize| (0..len).map(|_| 2.0 * random.f64() - 1.0).collect::<Vec<_>>();
        let mut motion = tumbling(&model);
        let starts = (0..TRAJECTORIES)
            .map(|_| {
                let state = motion.state(Pose::identity(), &numbers(n), &numbers(n), Twist::zero());
                Start { state, from: 0.0, until: DURATION }
            })
            .collect();
        drop(motion);
        let tau = (0..TRAJECTORIES).map(|_| numbers(n)).collect();
        let momentum = (0..TRAJECTORIES).map(|_| Wrench::from_array(std::array::from_fn(|_| numbers(1)[0]))).collect();
        Self { model, starts, tau, momentum }
    }

    /// Puts what a trajectory has of its own into a lane.
    fn enter<T: Lane<Element = f64>>(&self, motion: &mut Tumbling<'_, T>, lane: usize, trajectory: usize) {
        motion.loads_mut().0.set(lane, &self.tau[trajectory]);
        motion.momentum_mut().set(lane, self.momentum[trajectory]);
    }

    /// One after the other.
    fn alone(&self) -> Result<Option<Flown>, Failure> {
        let mut motion = tumbling(&self.model);
        for (number, start) in self.starts.iter().enumerate() {
            self.enter(&mut motion, 0, number);
            let mut path = Adaptive::new(&DOP853, start.state.clone(), start.from, ACCURACY);
            while path.time() < start.until {
                path.advance(&mut motion, start.until)?;
            }
        }
        Ok(None)
    }

    fn fly<T: Lane<Element = f64>>(&self, model: &Model<T>, pool: &ThreadPool) -> Result<Option<Flown>, Failure> {
        let ensemble = Ensemble { tableau: &DOP853, accuracy: ACCURACY, times: Vec::new() };
        let fly = || {
            ensemble.fly(
                &self.starts,
                || tumbling(model),
                |motion, seat| self.enter(motion, seat.lane, seat.trajectory),
            )
        };
        Ok(Some(pool.install(fly)?))
    }
}

fn tumbling<T: Lane<Element = f64>>(model: &Model<T>) -> Tumbling<'_, T> {
    let n = model.dof();
    let springs = (Spring { stiffness: vec![2.0; n], rest: vec![0.0; n] }, Viscous { damping: vec![0.02; n] });
    Motion::new(model, Conserved { momentum: Wrench::zero() }, (Torques::none(n), springs))
}
