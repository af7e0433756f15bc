//! C V, without forming C.

use crate::Real;
use crate::spatial::Twist;
use crate::sweep::{Moving, newton_euler, subtree_sums};

impl<T: Real> Moving<'_, '_, '_, T> {
    /// The bias force `C(q, V) V` (length 6+n, base frame) of a base moving with `V₁ = base_twist`: one Newton-Euler sweep.
    ///
    /// # Panics
    /// If `out` does not have 6+n entries.
    pub fn hamel_bias(&mut self, base_twist: Twist<T>, out: &mut [T]) {
        let com = self.com();
        let (model, data) = (self.model, &mut *self.data);
        let locked = base_twist.at(com) - data.velocity[0];
        newton_euler(model, data, locked, Twist::zero(), |_| T::zero());
        subtree_sums(model.bodies(), &mut data.wrench, &mut data.wrench_outside);
        out[..6].copy_from_slice(&data.wrench[0].at(-com).to_array());
        model.gather(&mut out[6..], |j| data.screw.at::<Twist<T>>(j).dot(data.wrench[j + 1]));
    }
}
