//! A state of a robot, and what acts on it, by the names of the inputs of quantities.

use std::collections::BTreeMap;

use frs::extended::DoubleDouble;

/// Numbers in (−1, 1) for every input, from a seed, but where others are given.
#[derive(Clone, Default)]
pub struct State {
    seed: u64,
    given: BTreeMap<&'static str, Vec<f64>>,
}

impl State {
    pub fn random(seed: u64) -> Self {
        Self { seed, ..Self::default() }
    }

    /// The same with this input.
    pub fn with(mut self, name: &'static str, numbers: Vec<f64>) -> Self {
        self.given.insert(name, numbers);
        self
    }

    pub fn numbers(&self, name: &str, length: usize) -> Vec<f64> {
        if let Some(given) = self.given.get(name) {
            assert_eq!(given.len(), length, "{name}");
            return given.clone();
        }
        let name = name.bytes().fold(0, |hash: u64, byte| hash.wrapping_mul(257).wrapping_add(byte.into()));
        let mut random = fastrand::Rng::with_seed(self.seed.wrapping_mul(1_000_003).wrapping_add(name));
        (0..length).map(|_| 2.0 * random.f64() - 1.0).collect()
    }

    pub fn wide(&self, name: &str, length: usize) -> Vec<DoubleDouble> {
        self.numbers(name, length).into_iter().map(DoubleDouble::from).collect()
    }
}
