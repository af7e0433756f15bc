//! States to compare at: random ones, and those that are hard on rounding.

use std::f64::consts::{FRAC_PI_2, PI};

use frs::Model;
use frs::model::{Body, Motion};
use frs_codegen::Input;

use super::element::Element;

/// States in which every number is drawn from the hard ones.
const MIXTURES: usize = 1000;

/// The numbers that functions read, one after the other.
#[derive(Clone, Debug)]
pub struct Layout {
    /// The arrays, by their start.
    pub inputs: Vec<Input>,
    /// Numbers of a state.
    pub len: usize,
}

impl Layout {
    /// All arrays that `functions` read.
    pub fn new<'f>(functions: impl IntoIterator<Item = &'f frs_codegen::FunctionReport>) -> Self {
        let mut inputs: Vec<Input> =
            functions.into_iter().flat_map(|function| function.inputs.iter().copied()).collect();
        inputs.sort_by_key(|input| (input.start, input.len));
        inputs.dedup();
        let len = inputs.last().map_or(0, |last| last.start as usize + last.len);
        Self { inputs, len }
    }
}

/// A sequence of states: the hard ones first, then random ones without end.
pub struct States<E> {
    layout: Layout,
    lengths: Vec<bool>,
    values: Vec<E>,
    rng: fastrand::Rng,
    next: usize,
}

impl<E: Element> States<E> {
    /// States for `model`; the same `seed` gives the same ones.
    pub fn new(model: &Model<E>, layout: Layout, seed: u64) -> Self {
        let slides = |column| {
            let driven = |body: &Body<E>| body.drive.coordinate == column && body.drive.ratio != E::zero();
            model.bodies()[1..].iter().any(|body| body.motion == Motion::Prismatic && driven(body))
        };
        let lengths = (0..model.dof()).map(slides).collect();
        Self { layout, lengths, values: hard_values(), rng: fastrand::Rng::with_seed(seed), next: 0 }
    }

    /// How many states are hard.
    pub fn hard(&self) -> usize {
        self.values.len() * (1 + self.layout.inputs.len()) + MIXTURES
    }

    /// A state with lengths that this type can tell from the robot: farther out, its inertia is singular to rounding.
    fn within_reach(&self, mut state: Vec<E>) -> Vec<E> {
        let longest = if E::BYTES == 8 { 1e6 } else { 1e3 };
        if let Some(input) = self.layout.inputs.iter().find(|input| input.name == "q") {
            let entries = state[input.start as usize..].iter_mut().zip(&self.lengths);
            for (entry, _) in entries.filter(|(_, is_length)| **is_length) {
                *entry = E::from_f64(entry.double().clamp(-longest, longest));
            }
        }
        state
    }

    /// A state of random numbers, and of nothing else.
    pub fn random(&mut self) -> Vec<E> {
        self.state(None, None)
    }

    /// A state: `chosen` number in `array`, or in all if `array` is `None`; random numbers elsewhere.
    fn state(&mut self, chosen: Option<E>, array: Option<usize>) -> Vec<E> {
        let Self { layout, rng, .. } = self;
        let mut state = vec![E::zero(); layout.len];
        for (number, input) in layout.inputs.iter().enumerate() {
            let entries = &mut state[input.start as usize..][..input.len];
            match chosen {
                _ if input.name == "payload" => entries.copy_from_slice(&payload(rng).map(E::from_f64)),
                Some(value) if array.is_none_or(|array| array == number) => entries.fill(value),
                _ => {
                    let scale = if input.name == "q" { PI } else { 1.0 };
                    entries.fill_with(|| E::from_f64(scale * unit(rng)));
                }
            }
        }
        state
    }
}

impl<E: Element> Iterator for States<E> {
    type Item = Vec<E>;

    fn next(&mut self) -> Option<Vec<E>> {
        let (number, values) = (self.next, self.values.len());
        self.next += 1;
        if number >= self.hard() {
            return Some(self.random());
        }
        if number < values * (1 + self.layout.inputs.len()) {
            let state = self.state(Some(self.values[number % values]), (number / values).checked_sub(1));
            return Some(self.within_reach(state));
        }
        let mut state = self.random();
        for input in self.layout.inputs.iter().filter(|input| input.name != "payload") {
            state[input.start as usize..][..input.len].fill_with(|| self.values[self.rng.usize(..values)]);
        }
        Some(self.within_reach(state))
    }
}

/// Zeros of both signs, quarter turns, large and small numbers, denormals.
fn hard_values<E: Element>() -> Vec<E> {
    // Squares of products of these stay within the range of the type.
    let (large, smallest, denormal) =
        if E::BYTES == 8 { (1e12, 5e-324, 1e-310) } else { (1e6, f64::from(f32::from_bits(1)), 1e-40) };
    let signless = [0.0, 1.0, large, 1.0 / large, smallest, denormal].into_iter();
    let quarters = (1..=4).map(|quarter| f64::from(quarter) * FRAC_PI_2);
    signless.chain(quarters).flat_map(|value| [value, -value]).map(E::from_f64).collect()
}

/// A number in ±1.
fn unit(rng: &mut fastrand::Rng) -> f64 {
    2.0 * rng.f64() - 1.0
}

/// Mass, centre of mass and inertia of four points of mass: a body that can exist.
fn payload(rng: &mut fastrand::Rng) -> [f64; 10] {
    let com: [f64; 3] = std::array::from_fn(|_| 0.5 * unit(rng));
    let (mut mass, mut inertia) = (0.0, [0.0; 6]);
    for _ in 0..4 {
        let (part, [x, y, z]) = (0.1 + rng.f64(), std::array::from_fn(|_| 0.3 * unit(rng)));
        mass += part;
        let about = [y * y + z * z, -x * y, -x * z, x * x + z * z, -y * z, x * x + y * y];
        inertia.iter_mut().zip(about).for_each(|(sum, moment)| *sum += part * moment);
    }
    let ([cx, cy, cz], [xx, xy, xz, yy, yz, zz]) = (com, inertia);
    [mass, cx, cy, cz, xx, xy, xz, yy, yz, zz]
}
