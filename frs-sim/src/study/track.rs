//! The states of a scene at chosen times, over any scalar.

use frs_core::Real;
use frs_core::extended::DoubleDouble;
use frs_core::spatial::Pose;

use crate::integrate::{IntegrationError, Path, State, System};
use crate::run::Equations;
use crate::scene::Scene;

/// A scalar that motions are computed with.
pub trait Number: Real + Into<f64> + Into<DoubleDouble> {}

impl<T: Real + Into<f64> + Into<DoubleDouble>> Number for T {}

/// Where equations come from: those that hold from a time (s) on.
pub type Equate<'e, 'm, T> = &'e mut dyn FnMut(f64) -> Box<dyn Equations<T> + 'm>;

/// A motion at chosen times.
pub struct Track<T: Real> {
    /// One state a time.
    pub states: Vec<State<T>>,
    /// How often the equations were evaluated.
    pub evaluations: usize,
}

/// The motion of a scene at `times` (s, increasing), which its steps meet if `met`, and else are interpolated as those of a
/// [`run`](crate::run::run).
///
/// # Errors
/// If the motion cannot be continued.
pub fn fly<T: Number>(
    scene: &Scene,
    times: &[f64],
    met: bool,
    equate: Equate<'_, '_, T>,
) -> Result<Track<T>, IntegrationError> {
    let duration = scene.duration;
    let mut events: Vec<f64> = scene.forces.iter().flat_map(|named| named.force.knots()).collect();
    events.retain(|time| *time > 0.0 && *time < duration);
    let mut stops = [events.as_slice(), if met { times } else { &[] }, &[duration]].concat();
    stops.sort_by(f64::total_cmp);
    stops.dedup();

    let mut equations = equate(0.0);
    let start = equations.start(&scene.start);
    let mut states = vec![start.clone(); times.len()];
    let mut path = Path::new(scene.solver.method, scene.solver.steps, start, T::zero());
    let mut known = 0;
    for stop in stops {
        let limit = T::from_f64(stop);
        while path.time() != limit {
            path.advance(&mut equations, limit)?;
            let reached: f64 = path.time().into();
            while known < times.len() && times[known] <= reached {
                path.at(&mut equations, T::from_f64(times[known]), &mut states[known]);
                known += 1;
            }
        }
        if events.contains(&stop) {
            equations = equate(stop);
            path.event();
        }
    }
    Ok(Track { states, evaluations: path.pace().evaluations })
}

/// The same state with 31 digits.
pub fn widened<T: Number>(state: &State<T>) -> State<DoubleDouble> {
    let widen = |x: T| -> DoubleDouble { x.into() };
    let pose = Pose::new(state.pose.rotation.map(widen), state.pose.translation.map(widen));
    State { pose, flat: state.flat.iter().copied().map(widen).collect() }
}

impl<T: Real> System<T> for Box<dyn Equations<T> + '_> {
    fn dimension(&self) -> usize {
        (**self).dimension()
    }

    fn velocities(&self) -> std::ops::Range<usize> {
        (**self).velocities()
    }

    fn rate(&mut self, time: T, state: &State<T>, rate: &mut crate::integrate::Tangent<T>) {
        (**self).rate(time, state, rate);
    }
}
