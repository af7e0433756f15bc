//! States, as describe.py writes them.

use std::fs;
use std::io;

use crate::number::Number;

/// A state, or several side by side; for who knows no μ, `mu` is the base's own twist.
#[derive(Clone, Debug)]
pub struct State<T = f64> {
    /// Coordinates.
    pub q: Vec<T>,
    /// Their rates.
    pub qd: Vec<T>,
    /// Locked velocity.
    pub mu: [T; 6],
    /// Wrench on the base.
    pub wrench: [T; 6],
    /// Torques.
    pub tau: Vec<T>,
}

/// The states of a robot of `n` coordinates.
///
/// # Errors
/// If the file cannot be read, or holds other numbers.
pub fn states(path: &str, n: usize) -> io::Result<Vec<State>> {
    let text = fs::read_to_string(path)?;
    text.lines()
        .map(|line| state(line, n).ok_or_else(|| io::Error::other(format!("{path}: {n} coordinates"))))
        .collect()
}

fn state(line: &str, n: usize) -> Option<State> {
    let numbers: Vec<f64> = line.split(' ').map(str::parse).collect::<Result<_, _>>().ok()?;
    let (q, rest) = numbers.split_at_checked(n)?;
    let (qd, rest) = rest.split_at_checked(n)?;
    let (mu, rest) = rest.split_first_chunk()?;
    let (wrench, tau) = rest.split_first_chunk()?;
    (tau.len() == n).then(|| State { q: q.into(), qd: qd.into(), mu: *mu, wrench: *wrench, tau: tau.into() })
}

/// Groups of states side by side.
pub fn grouped<T: Number>(states: &[State]) -> Vec<State<T>> {
    states.chunks_exact(T::LANES).map(group).collect()
}

fn group<T: Number>(states: &[State]) -> State<T> {
    let vector = |of: fn(&State) -> &[f64]| -> Vec<T> {
        (0..of(&states[0]).len()).map(|i| T::gather(|lane| of(&states[lane])[i])).collect()
    };
    State {
        q: vector(|state| &state.q),
        qd: vector(|state| &state.qd),
        mu: std::array::from_fn(|i| T::gather(|lane| states[lane].mu[i])),
        wrench: std::array::from_fn(|i| T::gather(|lane| states[lane].wrench[i])),
        tau: vector(|state| &state.tau),
    }
}
