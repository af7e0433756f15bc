//! Newton-Euler sweep: the wrench each body needs for a motion, and what the joints must give for it.

use super::Data;
use super::composite::{outside_sums, subtree_sums};
use crate::Real;
use crate::model::Model;
use crate::spatial::{Twist, Wrench};

/// `wrench[k] = I_k a_k − ad_{V_k}ᵀ I_k V_k` for body velocities V_k = `locked` + w_k in the centroidal frame.
///
/// Accelerations are those of an instantaneous inertial frame, `a_k = a_p + ad_{V_k} s_k q̇_k + s_k q̈_k`, from the base's
/// acceleration `base` and joint accelerations `acceleration`.
pub(crate) fn newton_euler<T: Real>(
    model: &Model<T>,
    data: &mut Data<T>,
    locked: Twist<T>,
    base: Twist<T>,
    acceleration: impl Fn(usize) -> T,
) {
    for (k, body) in model.bodies().iter().enumerate() {
        let v = data.velocity[k] + locked;
        data.twist[k] = if k == 0 {
            base
        } else {
            let screw = data.screw[k - 1];
            let turned = data.twist[body.parent].plus_scaled(v.ad(screw), data.rate[k - 1]);
            turned.plus_scaled(screw, acceleration(k - 1))
        };
        let inertia = data.inertia[k];
        data.wrench[k] = inertia * data.twist[k] - v.ad_transpose(inertia * v);
    }
}

/// `out = Σ_k J̃_kᵀ wrench_k`: per joint ŝ_j·fᶜ_j − A_j·fᵒ_j, with the wrench inside and outside the joint's subtree.
///
/// Afterwards `wrench[k]` is the sum over the subtree of k.
pub(crate) fn project<T: Real>(model: &Model<T>, data: &mut Data<T>, out: &mut [T]) {
    subtree_sums(model.bodies(), &mut data.wrench, &mut data.wrench_outside);
    data.wrench_before[0] = Wrench::zero();
    outside_sums(model.bodies(), &data.wrench, &mut data.wrench_outside, &mut data.wrench_before);
    model.gather(out, |j| {
        let inside = data.reaction[j].dot(data.wrench[j + 1]);
        inside - data.connection[j].dot(data.wrench_outside[j + 1])
    });
}
