//! Random trajectories of a robot: stiff and easy, short and long, in lanes and alone.

use frs_core::lanes::Lane;
use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Model, Moving, Real};
use frs_sim::ensemble::{Arrival, Ensemble, Flown, Sample, Start, Torques};
use frs_sim::integrate::Adaptive;
use frs_sim::motion::{Instant, Load, Loads, Motion};
use nalgebra::Vector3;
use rayon::ThreadPoolBuilder;

use super::Case;

/// Springs in all joints, and a damper, as stiff in each lane as it may be.
#[derive(Clone)]
pub struct Springs<T> {
    stiffness: T,
}

impl<T: Real> Loads<T> for Springs<T> {
    fn add(&mut self, instant: &Instant<'_, T>, _: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        for ((tau, &q), &qd) in load.tau.iter_mut().zip(instant.q).zip(instant.qd) {
            *tau -= self.stiffness * q + T::from_f64(0.1) * qd;
        }
    }
}

/// A trajectory, and what is its own.
#[derive(Clone)]
pub struct Trajectory {
    start: Start,
    tau: Vec<f64>,
    stiffness: f64,
    momentum: Wrench<f64>,
}

pub struct Fleet {
    model: Model,
    trajectories: Vec<Trajectory>,
    pub ensemble: Ensemble,
}

/// The trajectory that fails: a torque of it is infinite.
const FAILING: usize = 5;

/// A trajectory that ends when it begins.
const EMPTY: usize = 7;

type Flight<'m, C, T> = Motion<'m, <C as Case>::Momentum<T>, (Torques<T>, Springs<T>), T>;

fn motion<C: Case, T: Lane<Element = f64>>(model: &Model<T>) -> Flight<'_, C, T> {
    Motion::new(model, C::make(), (Torques::none(model.dof()), Springs { stiffness: T::zero() }))
}

impl Trajectory {
    /// Puts what is its own into a lane.
    fn enter<C: Case, T: Lane<Element = f64>>(&self, motion: &mut Flight<'_, C, T>, lane: usize) {
        let (torques, springs) = motion.loads_mut();
        torques.set(lane, &self.tau);
        springs.stiffness.set_lane(lane, self.stiffness);
        C::set(motion.momentum_mut(), lane, self.momentum);
    }
}

impl Fleet {
    pub fn random<C: Case>(model: Model, count: usize, ensemble: Ensemble) -> Self {
        let n = model.dof();
        let mut random = fastrand::Rng::with_seed(3);
        let mut motion = motion::<C, f64>(&model);
        let trajectories = (0..count)
            .map(|number| {
                let mut numbers = |len: usize| (0..len).map(|_| 2.0 * random.f64() - 1.0).collect::<Vec<_>>();
                let pose = Pose::from_rpy(Vector3::from_vec(numbers(3)), [0.4, numbers(1)[0], -1.0]);
                let (q, qd) = (numbers(n), numbers(n));
                let [mu, momentum] = [0; 2].map(|_| std::array::from_fn(|_| numbers(1)[0]));
                let state = motion.state(pose, &q, &qd, Twist::from_array(mu));
                let from = 0.05 * f64::from((number % 3) as u8);
                let duration = if number == EMPTY { 0.0 } else { 0.1 + 0.9 * numbers(1)[0].powi(2) };
                let mut tau = numbers(n);
                if number == FAILING {
                    tau[n - 1] = f64::INFINITY;
                }
                Trajectory {
                    start: Start { state, from, until: from + duration },
                    tau,
                    stiffness: [0.0, 2.0, 50.0, 1000.0][number % 4],
                    momentum: Wrench::from_array(momentum),
                }
            })
            .collect();
        drop(motion);
        Self { model, trajectories, ensemble }
    }

    /// The last trajectory first.
    pub fn reversed(&self) -> Self {
        let trajectories = self.trajectories.iter().rev().cloned().collect();
        Self { model: self.model.clone(), trajectories, ensemble: self.ensemble.clone() }
    }

    pub fn fly<C: Case, T: Lane<Element = f64>>(&self, threads: usize) -> Flown {
        let model = self.model.cast::<T>();
        let starts: Vec<_> = self.trajectories.iter().map(|trajectory| trajectory.start.clone()).collect();
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let fly = || {
            self.ensemble.fly(
                &starts,
                || motion::<C, T>(&model),
                |motion, seat| self.trajectories[seat.trajectory].enter::<C, T>(motion, seat.lane),
            )
        };
        pool.install(fly).unwrap()
    }

    /// Each by itself, one after the other.
    pub fn alone<C: Case>(&self) -> Vec<Arrival> {
        self.trajectories.iter().map(|trajectory| self.one::<C>(trajectory)).collect()
    }

    fn one<C: Case>(&self, trajectory: &Trajectory) -> Arrival {
        let Ensemble { tableau, accuracy, times } = &self.ensemble;
        let Start { state, from, until } = trajectory.start.clone();
        let mut motion = motion::<C, f64>(&self.model);
        trajectory.enter::<C, f64>(&mut motion, 0);
        let mut times = times.iter().copied().filter(|time| (from..=until).contains(time)).peekable();
        let mut samples = Vec::new();
        samples.extend(times.next_if_eq(&from).map(|time| Sample { time, state: state.clone() }));

        let mut path = Adaptive::new(tableau, state, from, *accuracy);
        let (mut steps, mut end) = (0, Ok(()));
        while path.time() < until {
            end = path.advance(&mut motion, until);
            if end.is_err() {
                break;
            }
            steps += 1;
            while let Some(time) = times.next_if(|time| *time <= path.time()) {
                let mut state = path.state().clone();
                path.at(&mut motion, time, &mut state);
                samples.push(Sample { time, state });
            }
        }
        // Every step takes as many evaluations, and the first one more.
        let rejected = path.evaluations().saturating_sub(1) / tableau.stages - steps;
        let (state, time, evaluations) = (path.state().clone(), path.time(), path.evaluations());
        Arrival { state, time, steps, rejected, evaluations, samples, end }
    }
}
