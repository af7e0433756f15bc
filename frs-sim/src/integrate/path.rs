//! A motion on its way, by any method.

use std::ops::Range;

use frs_core::Real;

use super::{
    Adaptive, DOP853, DOPRI5, EULER, Explicit, ImplicitMidpoint, IntegrationError, MIDPOINT, Pace, RK4, SemiImplicit,
    State, System, Tableau, Tangent,
};

/// A method of integration, by its name in scenes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// [`EULER`], order 1.
    Euler,
    /// [`SemiImplicit`], order 1.
    SemiImplicit,
    /// [`MIDPOINT`], order 2.
    Rkmk2,
    /// [`ImplicitMidpoint`], order 2.
    ImplicitMidpoint,
    /// [`RK4`], order 4.
    Rkmk4,
    /// [`DOPRI5`], order 5.
    Dopri5,
    /// [`DOP853`], order 8.
    Dop853,
}

impl Method {
    /// All of them, by order.
    pub const ALL: [Self; 7] =
        [Self::Euler, Self::SemiImplicit, Self::Rkmk2, Self::ImplicitMidpoint, Self::Rkmk4, Self::Dopri5, Self::Dop853];

    /// Its name, as users write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::SemiImplicit => "semi_implicit",
            Self::ImplicitMidpoint => "implicit_midpoint",
            _ => self.tableau().map_or("", |tableau| tableau.name),
        }
    }

    /// Order of the error of a whole motion: the step to this power.
    pub fn order(self) -> usize {
        match self {
            Self::SemiImplicit => 1,
            Self::ImplicitMidpoint => 2,
            _ => self.tableau().map_or(0, |tableau| tableau.order),
        }
    }

    /// Whether it estimates its error, and can choose its steps by it.
    pub fn estimates_its_error(self) -> bool {
        self.tableau().is_some_and(|tableau| tableau.error_order > 0)
    }

    /// Its numbers, if it is an explicit Runge-Kutta method.
    fn tableau(self) -> Option<&'static Tableau> {
        match self {
            Self::Euler => Some(&EULER),
            Self::Rkmk2 => Some(&MIDPOINT),
            Self::Rkmk4 => Some(&RK4),
            Self::Dopri5 => Some(&DOPRI5),
            Self::Dop853 => Some(&DOP853),
            Self::SemiImplicit | Self::ImplicitMidpoint => None,
        }
    }
}

/// How long steps are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Steps {
    /// As long as this error of a step allows ([`Adaptive`]).
    Accuracy(f64),
    /// This long, s; shorter before an event.
    Length(f64),
}

/// A motion on its way: time and state, and the method that makes its steps.
#[derive(Clone, Debug)]
pub enum Path<T: Real = f64> {
    /// Steps as long as the accuracy allows.
    Adaptive(Adaptive<T>),
    /// Steps of one length.
    Uniform(Uniform<T>),
}

/// A motion with steps of one length.
#[derive(Clone, Debug)]
pub struct Uniform<T: Real = f64> {
    method: OneStep<T>,
    length: f64,
    /// Start of the last step, and the state there.
    start: T,
    before: State<T>,
    time: T,
    state: State<T>,
    evaluations: usize,
}

/// A system that counts how often it is evaluated.
struct Counted<'s, S> {
    system: &'s mut S,
    evaluations: &'s mut usize,
}

impl<T: Real, S: System<T>> System<T> for Counted<'_, S> {
    fn dimension(&self) -> usize {
        self.system.dimension()
    }

    fn velocities(&self) -> Range<usize> {
        self.system.velocities()
    }

    fn rate(&mut self, time: T, state: &State<T>, rate: &mut Tangent<T>) {
        *self.evaluations += 1;
        self.system.rate(time, state, rate);
    }
}

#[derive(Clone, Debug)]
enum OneStep<T: Real> {
    Explicit(Explicit<T>),
    SemiImplicit(SemiImplicit<T>),
    ImplicitMidpoint(ImplicitMidpoint<T>),
}

/// A step that would leave less than this share of itself before the limit goes to the limit.
const STRETCH: f64 = 1e-6;

impl<T: Real + Into<f64>> Path<T> {
    /// The motion from `state` at `time` (s).
    ///
    /// # Panics
    /// If an accuracy is given to a method that estimates no error, or if the accuracy or the length is not positive.
    pub fn new(method: Method, steps: Steps, state: State<T>, time: T) -> Self {
        let dimension = state.flat.len();
        match (steps, method.tableau()) {
            (Steps::Accuracy(accuracy), Some(tableau)) => Self::Adaptive(Adaptive::new(tableau, state, time, accuracy)),
            (Steps::Accuracy(_), None) => panic!("{} estimates no error", method.name()),
            (Steps::Length(length), tableau) => {
                assert!(length > 0.0, "the length of steps must be positive");
                let method = match (tableau, method) {
                    (Some(tableau), _) => OneStep::Explicit(Explicit::new(tableau, dimension)),
                    (None, Method::SemiImplicit) => OneStep::SemiImplicit(SemiImplicit::new(dimension)),
                    (None, _) => OneStep::ImplicitMidpoint(ImplicitMidpoint::new(dimension)),
                };
                let before = state.clone();
                Self::Uniform(Uniform { method, length, start: time, before, time, state, evaluations: 0 })
            }
        }
    }

    /// Where the motion is, s.
    pub fn time(&self) -> T {
        match self {
            Self::Adaptive(path) => path.time(),
            Self::Uniform(path) => path.time,
        }
    }

    /// Where the last step began, s.
    pub fn last_start(&self) -> T {
        match self {
            Self::Adaptive(path) => path.last_start(),
            Self::Uniform(path) => path.start,
        }
    }

    /// The state at [`time`](Self::time).
    pub fn state(&self) -> &State<T> {
        match self {
            Self::Adaptive(path) => path.state(),
            Self::Uniform(path) => &path.state,
        }
    }

    /// The state, to be changed at an event. The next step asks the system again how to go on.
    pub fn event(&mut self) -> &mut State<T> {
        match self {
            Self::Adaptive(path) => path.event(),
            Self::Uniform(path) => &mut path.state,
        }
    }

    /// What it takes to go on from the present time and state.
    pub fn pace(&self) -> Pace {
        match self {
            Self::Adaptive(path) => path.pace(),
            Self::Uniform(path) => Pace { next: path.length, error: 1.0, smooth: false, evaluations: path.evaluations },
        }
    }

    /// Goes on at a pace, as made by [`new`](Self::new) at the time and state at which it was taken.
    pub fn resume(&mut self, system: &mut impl System<T>, pace: Pace) {
        match self {
            Self::Adaptive(path) => path.resume(system, pace),
            Self::Uniform(path) => path.evaluations = pace.evaluations,
        }
    }

    /// One step, not beyond `limit` (s), and exactly to it when it is near.
    ///
    /// # Errors
    /// If the motion is not finite, or a step cannot be made. The motion is where it was then.
    pub fn advance(&mut self, system: &mut impl System<T>, limit: T) -> Result<(), IntegrationError> {
        match self {
            Self::Adaptive(path) => path.advance(system, limit),
            Self::Uniform(path) => path.advance(system, limit),
        }
    }

    /// The state at `time` (s) within the last step.
    pub fn at(&mut self, system: &mut impl System<T>, time: T, state: &mut State<T>) {
        match self {
            Self::Adaptive(path) => path.at(system, time, state),
            Self::Uniform(path) => path.at(system, time, state),
        }
    }

    /// Goes back to `time` (s) within the last step: something happens there.
    pub fn cut(&mut self, system: &mut impl System<T>, time: T) {
        match self {
            Self::Adaptive(path) => path.cut(system, time),
            Self::Uniform(path) => {
                let mut state = path.state.clone();
                path.at(system, time, &mut state);
                (path.time, path.state) = (time, state);
            }
        }
    }
}

impl<T: Real + Into<f64>> Uniform<T> {
    fn advance(&mut self, system: &mut impl System<T>, limit: T) -> Result<(), IntegrationError> {
        let remaining: f64 = (limit - self.time).into();
        if remaining <= 0.0 {
            return Ok(());
        }
        let last = self.length * (1.0 + STRETCH) >= remaining;
        let h = if last { limit - self.time } else { T::from_f64(self.length) };
        let mut next = self.state.clone();
        self.method.step(
            &mut Counted { system, evaluations: &mut self.evaluations },
            self.time,
            h,
            &self.state,
            &mut next,
        )?;
        let pose = next.pose.rotation.iter().chain(&next.pose.translation);
        if !pose.chain(&next.flat).all(|&x| x.into().is_finite()) {
            return Err(IntegrationError::NotFinite { time: self.time.into() });
        }
        self.start = self.time;
        self.time = if last { limit } else { self.time + h };
        self.before = std::mem::replace(&mut self.state, next);
        Ok(())
    }

    /// A shorter step from where the last one began.
    fn at(&mut self, system: &mut impl System<T>, time: T, state: &mut State<T>) {
        if time == self.time {
            return state.clone_from(&self.state);
        }
        state.clone_from(&self.before);
        if time != self.start && self.method.step(system, self.start, time - self.start, &self.before, state).is_err() {
            // The whole step was solved: only rounding can keep a part of it from it.
            state.clone_from(&self.state);
        }
    }
}

impl<T: Real + Into<f64>> OneStep<T> {
    fn step(
        &mut self,
        system: &mut impl System<T>,
        time: T,
        h: T,
        from: &State<T>,
        to: &mut State<T>,
    ) -> Result<(), IntegrationError> {
        match self {
            Self::Explicit(method) => method.step(system, time, h, from, to),
            Self::SemiImplicit(method) => method.step(system, time, h, from, to),
            Self::ImplicitMidpoint(method) => return method.step(system, time, h, from, to),
        }
        Ok(())
    }
}
