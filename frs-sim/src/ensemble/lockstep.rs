//! The lanes of one thread: they step together, and each chooses its steps alone.

use frs_core::lanes::Lane;

use super::arrival::{Arrival, Part, Sample};
use super::{Ensemble, Seat, Start, lanes};
use crate::integrate::{Attempt, Control, State, System, Trial, first_length};

/// The lanes of a thread, and the trajectories in them.
pub struct Lockstep<'e, T: Lane, S> {
    ensemble: &'e Ensemble,
    starts: &'e [Start],
    system: S,
    /// Numbers of a state that error control sees.
    counted: usize,
    /// Trajectories are where it begins; in the lanes that make the step, where it ends.
    trial: Trial<T>,
    /// The trajectory of each lane.
    riders: Vec<Option<Rider>>,
    between: State<T>,
    part: Part,
}

/// A trajectory on its way.
struct Rider {
    trajectory: usize,
    control: Control,
    /// Where it is, and where it ends, s.
    time: f64,
    until: f64,
    /// The step that is tried.
    tried: Attempt,
    /// Whether it is made.
    made: bool,
    /// Which of the times of samples is the next.
    next_sample: usize,
    /// What is known of its end.
    arrival: Arrival,
}

impl<'e, T: Lane<Element = f64>, S: System<T>> Lockstep<'e, T, S> {
    pub fn new(ensemble: &'e Ensemble, starts: &'e [Start], system: S) -> Self {
        let origin = State::origin(system.dimension());
        Self {
            ensemble,
            starts,
            counted: system.dimension() - system.measured(),
            system,
            trial: Trial::new(ensemble.tableau, origin.clone(), T::WIDTH),
            riders: (0..T::WIDTH).map(|_| None).collect(),
            between: origin,
            part: Part { arrivals: Vec::new(), passes: 0 },
        }
    }

    /// Integrates what `next` gives until it gives nothing more.
    pub fn run(mut self, next: impl Fn() -> Option<usize>, take: &impl Fn(&mut S, Seat)) -> Part {
        loop {
            self.fill(&next, take);
            if self.riders.iter().all(Option::is_none) {
                return self.part;
            }
            self.pass();
        }
    }

    /// Empty lanes take the next trajectories.
    fn fill(&mut self, next: &impl Fn() -> Option<usize>, take: &impl Fn(&mut S, Seat)) {
        let mut any = false;
        for lane in 0..T::WIDTH {
            while self.riders[lane].is_none() {
                let Some(trajectory) = next() else { break };
                let (rider, start) = (Rider::new(self.ensemble, self.starts, trajectory), &self.starts[trajectory]);
                if rider.time >= rider.until {
                    self.part.arrivals.push((trajectory, rider.arrival));
                    continue;
                }
                lanes::set_state(&mut self.trial.from, lane, &start.state);
                take(&mut self.system, Seat { lane, trajectory });
                self.riders[lane] = Some(rider);
                any = true;
            }
        }
        if any {
            self.begin();
        }
    }

    /// The tangents of the trajectories that were not evaluated yet, and the lengths of their first steps.
    fn begin(&mut self) {
        let time = self.gather(|rider| rider.time);
        let Self { system, trial, riders, counted, .. } = self;
        system.rate(time, &trial.from, &mut trial.end_slope);
        for (lane, rider) in riders.iter_mut().enumerate() {
            let Some(rider) = rider.as_mut().filter(|rider| rider.arrival.evaluations == 0) else { continue };
            lanes::copy_tangent(&mut trial.slope, &trial.end_slope, lane);
            rider.arrival.evaluations = 1;
            let remaining = rider.until - rider.time;
            rider.control.begin(|| first_length(&trial.slope, &trial.from, *counted, remaining, |x: T| x.lane(lane)));
        }
    }

    /// Every lane tries a step; those whose error is too large stay where they are.
    fn pass(&mut self) {
        self.part.passes += 1;
        for rider in self.riders.iter_mut().flatten() {
            rider.tried = rider.control.attempt(rider.time, rider.until);
        }
        let [start, length, end] = self.tried();
        let Self { ensemble, system, counted, trial, riders, .. } = self;
        trial.step(system, [start, length, end]);
        trial.estimate(length, *counted, ensemble.accuracy, |x, lane| x.lane(lane));
        for (lane, rider) in riders.iter_mut().enumerate() {
            if let Some(rider) = rider {
                rider.judge(trial.error(lane), trial.tableau().stages);
            }
        }
        self.sample();
        self.go_on();
        self.arrive();
    }

    /// Takes the samples within the steps just made.
    fn sample(&mut self) {
        let times = &self.ensemble.times;
        let due = |rider: &Rider| times.get(rider.next_sample).copied().filter(|&time| time <= rider.time);
        while self.riders.iter().flatten().any(|rider| due(rider).is_some()) {
            let [start, length, _] = self.tried();
            let theta =
                self.gather(|rider| due(rider).map_or(0.0, |time| (time - rider.tried.start) / rider.tried.length));
            self.trial.interpolate(&mut self.system, [start, length, theta], &mut self.between);
            for (lane, rider) in self.riders.iter_mut().enumerate() {
                let Some(rider) = rider else { continue };
                if let Some(time) = due(rider) {
                    rider.arrival.samples.push(Sample { time, state: lanes::state(&self.between, lane) });
                    rider.next_sample += 1;
                }
            }
        }
    }

    /// The lanes that made their step are at its end.
    fn go_on(&mut self) {
        let Self { trial, riders, .. } = self;
        if riders.iter().flatten().all(|rider| rider.made) {
            return trial.turn();
        }
        for (lane, _) in riders.iter().enumerate().filter(|(_, rider)| rider.as_ref().is_some_and(|rider| rider.made)) {
            lanes::copy_state(&mut trial.from, &trial.to, lane);
            lanes::copy_tangent(&mut trial.slope, &trial.end_slope, lane);
        }
    }

    /// Trajectories that are at their end leave their lanes.
    fn arrive(&mut self) {
        for (lane, seat) in self.riders.iter_mut().enumerate() {
            if let Some(mut rider) = seat.take_if(|rider| rider.time >= rider.until || rider.arrival.end.is_err()) {
                rider.arrival.time = rider.time;
                rider.arrival.state = lanes::state(&self.trial.from, lane);
                self.part.arrivals.push((rider.trajectory, rider.arrival));
            }
        }
    }

    /// A number of each trajectory; 0 in empty lanes, where steps of no length are made.
    fn gather(&self, of: impl Fn(&Rider) -> f64) -> T {
        T::from_fn(|lane| self.riders[lane].as_ref().map_or(0.0, &of))
    }

    /// Start, length and end of the steps that are tried, s.
    fn tried(&self) -> [T; 3] {
        [
            self.gather(|rider| rider.tried.start),
            self.gather(|rider| rider.tried.length),
            self.gather(|rider| rider.tried.end),
        ]
    }
}

impl Rider {
    fn new(ensemble: &Ensemble, starts: &[Start], trajectory: usize) -> Self {
        let Start { state, from, until } = starts[trajectory].clone();
        let control = Control::new(ensemble.tableau.error_order, ensemble.accuracy);
        let times = &ensemble.times;
        let mut next_sample = times.partition_point(|&time| time < from);
        let mut samples = Vec::new();
        if times.get(next_sample) == Some(&from) {
            samples.push(Sample { time: from, state: state.clone() });
            next_sample += 1;
        }
        Self {
            trajectory,
            control,
            time: from,
            until,
            tried: control.attempt(from, until),
            made: false,
            next_sample,
            arrival: Arrival { state, time: from, steps: 0, rejected: 0, evaluations: 0, samples, end: Ok(()) },
        }
    }

    /// Makes the step that was tried, by its error, or not.
    fn judge(&mut self, error: f64, evaluations: usize) {
        let judged = self.control.judge(&self.tried, error);
        self.made = judged == Ok(true);
        self.arrival.end = judged.map(|_| ());
        self.arrival.evaluations += evaluations;
        if self.made {
            self.arrival.steps += 1;
            self.time = self.tried.end;
        } else {
            self.arrival.rejected += 1;
        }
    }
}
