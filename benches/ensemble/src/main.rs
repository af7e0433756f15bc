//! Simulated seconds per second of many trajectories, as the table of docs/ensemble.md: all ways must agree bit by bit. The last columns are how
//! many times as fast as one thread several are, in generated code of eight lanes.

use std::time::Instant as Clock;

use frs::lanes::{F64x4, F64x8, Lane};
use frs::spatial::{Pose, Twist};
use frs::{Evaluator, FloatingBase, Model};
use frs_sim::ensemble::{Ensemble, Flown, Start, Torques};
use frs_sim::integrate::DOP853;
use frs_sim::motion::{Answered, Instant, Load};
use rayon::{ThreadPool, ThreadPoolBuilder};

frs::frs_model!(mod satellite = "../../robots/lwr_satellite.urdf", form = hybrid, outputs(state_rate));
frs::frs_model!(mod satellite_4 = "../../robots/lwr_satellite.urdf", form = unrolled, lanes = 4, outputs(state_rate));
frs::frs_model!(mod satellite_8 = "../../robots/lwr_satellite.urdf", form = unrolled, lanes = 8, outputs(state_rate));
frs::frs_model!(mod quadruped = "../../robots/quadruped.urdf", form = hybrid, outputs(state_rate));
frs::frs_model!(mod quadruped_4 = "../../robots/quadruped.urdf", form = unrolled, lanes = 4, outputs(state_rate));
frs::frs_model!(mod quadruped_8 = "../../robots/quadruped.urdf", form = unrolled, lanes = 8, outputs(state_rate));
frs::frs_model!(mod humanoid = "../../robots/humanoid.urdf", form = hybrid, outputs(state_rate));
frs::frs_model!(mod humanoid_4 = "../../robots/humanoid.urdf", form = unrolled, lanes = 4, outputs(state_rate));
frs::frs_model!(mod humanoid_8 = "../../robots/humanoid.urdf", form = unrolled, lanes = 8, outputs(state_rate));

/// Trajectories of a call.
const TRAJECTORIES: usize = 128;

/// Length of each, s.
const DURATION: f64 = 0.25;

/// Calls of each way; they take turns, so that what else the machine does meets all alike. The fastest counts.
const TURNS: usize = 20;

/// Integrates all trajectories.
type Way<'f> = Box<dyn Fn() -> Flown + 'f>;

type Forces<T> = (Torques<T>, fn(&Instant<'_, T>, &mut Load<T>));

fn main() {
    println!(
        "| robot (n) | core, one at a time | generated | core, 4 lanes | 8 lanes | generated, 4 lanes | 8 lanes | occupancy of 8 lanes | rejected |{}",
        pools().map(|pool| format!(" {} threads |", pool.current_num_threads())).collect::<String>()
    );
    println!("|---|---|---|---|---|---|---|---|---|{}", "---|".repeat(pools().count()));
    let (robots, text) =
        ((satellite::LwrSatellite, satellite_4::LwrSatellite, satellite_8::LwrSatellite), "lwr_satellite");
    race(text, include_str!("../../../robots/lwr_satellite.urdf"), robots);
    let (robots, text) = ((quadruped::Quadruped, quadruped_4::Quadruped, quadruped_8::Quadruped), "quadruped");
    race(text, include_str!("../../../robots/quadruped.urdf"), robots);
    let (robots, text) = ((humanoid::Humanoid, humanoid_4::Humanoid, humanoid_8::Humanoid), "humanoid");
    race(text, include_str!("../../../robots/humanoid.urdf"), robots);
}

fn race<A, B, C>(name: &str, urdf: &str, (one, four, eight): (A, B, C))
where
    A: FloatingBase<f64> + Copy + Sync,
    B: FloatingBase<F64x4> + Copy + Sync,
    C: FloatingBase<F64x8> + Copy + Sync,
{
    let single = &pool(1);
    let model = Model::from_urdf(urdf).unwrap_or_else(|error| panic!("{error}"));
    let (fours, eights) = (model.cast::<F64x4>(), model.cast::<F64x8>());
    let fleet = &Fleet::random(&model, TRAJECTORIES);
    let ways: Vec<Way<'_>> = vec![
        Box::new(|| fleet.fly::<f64, _>(single, || Evaluator::new(&model))),
        Box::new(|| fleet.fly::<f64, _>(single, || one)),
        Box::new(|| fleet.fly::<F64x4, _>(single, || Evaluator::new(&fours))),
        Box::new(|| fleet.fly::<F64x8, _>(single, || Evaluator::new(&eights))),
        Box::new(|| fleet.fly::<F64x4, _>(single, || four)),
        Box::new(|| fleet.fly::<F64x8, _>(single, || eight)),
    ];
    let first = ways[0]();
    let (mut least, mut last) = (vec![f64::INFINITY; ways.len()], first.clone());
    for _ in 0..TURNS {
        for (least, way) in least.iter_mut().zip(&ways) {
            let begin = Clock::now();
            last = way();
            *least = least.min(begin.elapsed().as_secs_f64());
            let ends = last.arrivals.iter().map(|arrival| &arrival.state);
            assert!(ends.eq(first.arrivals.iter().map(|arrival| &arrival.state)), "{name}");
        }
    }
    let speeds: Vec<_> = least.iter().map(|least| format!("{:.0}", TRAJECTORIES as f64 * DURATION / least)).collect();
    // As many trajectories as keep all lanes of all threads busy.
    let fleet = Fleet::random(&model, 16 * TRAJECTORIES);
    let time = |pool: &ThreadPool| {
        let once = || {
            let begin = Clock::now();
            fleet.fly::<F64x8, _>(pool, || eight);
            begin.elapsed().as_secs_f64()
        };
        (0..5).map(|_| once()).fold(f64::INFINITY, f64::min)
    };
    let alone = time(single);
    let gains: String = pools().map(|pool| format!(" {:.2} |", alone / time(&pool))).collect();
    println!(
        "| {name} ({}) | {} | {:.2} | {:.2} |{gains}",
        model.dof(),
        speeds.join(" | "),
        last.occupancy(),
        last.rejected()
    );
}

/// Two threads, four, …, as many as there are.
fn pools() -> impl Iterator<Item = ThreadPool> {
    let most = std::thread::available_parallelism().map_or(1, usize::from);
    std::iter::successors(Some(2), |threads| Some(2 * threads)).take_while(move |&threads| threads <= most).map(pool)
}

fn pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started")
}

/// Random starts of a robot that tumbles, with springs and dampers in its joints, and torques.
struct Fleet {
    starts: Vec<Start>,
    tau: Vec<Vec<f64>>,
}

impl Fleet {
    fn random(model: &Model, count: usize) -> Self {
        let n = model.dof();
        let mut random = fastrand::Rng::with_seed(1);
        let mut numbers = |len: usize| (0..len).map(|_| 2.0 * random.f64() - 1.0).collect::<Vec<_>>();
        let motion = Answered::new(Evaluator::new(model), ());
        let starts = (0..count)
            .map(|_| {
                let mu = Twist::from_array(std::array::from_fn(|_| numbers(1)[0]));
                let state = motion.state(Pose::identity(), &numbers(n), &numbers(n), mu);
                Start { state, from: 0.0, until: DURATION }
            })
            .collect();
        Self { starts, tau: (0..count).map(|_| numbers(n)).collect() }
    }

    fn fly<T, R>(&self, pool: &ThreadPool, robot: impl Fn() -> R + Sync) -> Flown
    where
        T: Lane<Element = f64>,
        R: FloatingBase<T>,
    {
        let ensemble = Ensemble { tableau: &DOP853, accuracy: 1e-6, times: Vec::new() };
        let motion = || {
            let robot = robot();
            let forces: Forces<T> = (Torques::none(robot.dof()), springs_and_dampers);
            Answered::new(robot, forces)
        };
        let fly = || {
            ensemble.fly(&self.starts, motion, |motion, seat| {
                motion.forces_mut().0.set(seat.lane, &self.tau[seat.trajectory]);
            })
        };
        pool.install(fly).unwrap_or_else(|error| panic!("{error}"))
    }
}

fn springs_and_dampers<T: Lane>(instant: &Instant<'_, T>, load: &mut Load<T>) {
    let [stiffness, damping] = [2.0, 0.02].map(T::from_f64);
    for ((tau, &q), &qd) in load.tau.iter_mut().zip(instant.q).zip(instant.qd) {
        *tau -= stiffness * q + damping * qd;
    }
}
