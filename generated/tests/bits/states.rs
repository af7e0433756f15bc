//! States to compare at: random ones, and those where an operation that was moved, folded or contracted would show.

use std::f64::consts::FRAC_PI_2;

use frs_core::Quantity;

/// Numbers that are exact, huge, tiny, denormal, or zero of either sign.
const HARD: [f64; 14] = [
    0.0,
    -0.0,
    FRAC_PI_2,
    -FRAC_PI_2,
    2.0 * FRAC_PI_2,
    -3.0 * FRAC_PI_2,
    4.0 * FRAC_PI_2,
    1e12,
    -1e12,
    1e-12,
    -1e-12,
    5e-324,
    -2.2e-308,
    1.0,
];

/// A source of states with a seed.
pub struct States {
    random: fastrand::Rng,
    number: usize,
}

impl States {
    /// The states of `seed`.
    pub fn new(seed: u64) -> Self {
        Self { random: fastrand::Rng::with_seed(seed), number: 0 }
    }

    /// The inputs of `quantity` for the next state of a robot of `n` coordinates.
    ///
    /// Each hard number fills a state of its own; then hard numbers are mixed, one state in eight; the rest is random over
    /// several turns and magnitudes.
    pub fn next(&mut self, quantity: Quantity, n: usize) -> Vec<Vec<f64>> {
        let (number, random) = (self.number, &mut self.random);
        self.number += 1;
        let mut entry = || match number {
            _ if number < HARD.len() => HARD[number],
            _ if number % 8 == 0 => HARD[random.usize(..HARD.len())],
            _ => (random.f64() - 0.5) * 16.0,
        };
        quantity.inputs().map(|input| (0..input.len(n)).map(|_| entry()).collect()).collect()
    }
}
