//! The semi-implicit Euler method: velocities first, then positions with the new velocities.

use frs_core::Real;

use super::{State, System, Tangent};

/// The semi-implicit (symplectic) Euler method, order 1: `v' = v + h v̇(x, v)`, then positions with the rates that v' gives them.
#[derive(Clone, Debug)]
pub struct SemiImplicit<T: Real = f64> {
    rate: Tangent<T>,
}

impl<T: Real> SemiImplicit<T> {
    /// Memory for states of `dimension` numbers.
    pub fn new(dimension: usize) -> Self {
        Self { rate: Tangent::zero(dimension) }
    }

    /// One step of length `h` (s) from `from` at `time`, into `to`.
    pub fn step(&mut self, system: &mut impl System<T>, time: T, h: T, from: &State<T>, to: &mut State<T>) {
        let velocities = system.velocities();
        system.rate(time, from, &mut self.rate);
        to.clone_from(from);
        for i in velocities.clone() {
            to.flat[i] += self.rate.flat[i] * h;
        }
        system.rate(time, to, &mut self.rate);
        self.rate.twist = self.rate.twist * h;
        for (i, rate) in self.rate.flat.iter_mut().enumerate() {
            *rate = if velocities.contains(&i) { to.flat[i] - from.flat[i] } else { *rate * h };
        }
        to.set_moved(from, &self.rate);
    }
}
