//! Newton-Euler sweep: the wrench each body needs for a motion, and what the joints must give for it.

use super::composite::{outside_sums, subtree_sums};
use super::parts::{gather, scatter, splat};
use super::{Data, groups};
use crate::model::Model;
use crate::spatial::{Inertia, Twist, Wrench};
use crate::{Lanes, Real};

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
    let joints = model.joints();
    let (base_velocity, locked_lanes) = (data.velocity[0] + locked, splat(locked));
    for first in groups::<T>(0..joints) {
        let screw: Twist<T::Lanes> = data.screw.lanes(first);
        let velocity: Twist<T::Lanes> = gather(&data.velocity, first + 1);
        let accelerations = T::Lanes::from_fn(|lane| match first + lane {
            j if j < joints => acceleration(j),
            _ => T::zero(),
        });
        let rate = data.rate.lanes(first);
        scatter(
            &mut data.twist,
            first + 1,
            ((velocity + locked_lanes).ad(screw) * rate).plus_scaled(screw, accelerations),
        );
    }
    data.twist[0] = base;
    for (k, body) in model.bodies().iter().enumerate().skip(1) {
        data.twist[k] = data.twist[body.parent] + data.twist[k];
    }
    data.wrench[0] = needed(data.inertia[0], data.twist[0], base_velocity);
    for first in groups::<T>(0..joints) {
        let inertia: Inertia<T::Lanes> = gather(&data.inertia, first + 1);
        let velocity: Twist<T::Lanes> = gather(&data.velocity, first + 1);
        let wrench = needed(inertia, gather(&data.twist, first + 1), velocity + locked_lanes);
        scatter(&mut data.wrench, first + 1, wrench);
    }
}

/// The wrench `I a − ad_Vᵀ I V`.
#[inline(always)]
fn needed<T: Real>(inertia: Inertia<T>, acceleration: Twist<T>, velocity: Twist<T>) -> Wrench<T> {
    inertia * acceleration - velocity.ad_transpose(inertia * velocity)
}

/// `out = Σ_k J̃_kᵀ wrench_k`: per joint ŝ_j·fᶜ_j − A_j·fᵒ_j, with the wrench inside and outside the joint's subtree.
///
/// Afterwards `wrench[k]` is the sum over the subtree of k.
pub(crate) fn project<T: Real>(model: &Model<T>, data: &mut Data<T>, out: &mut [T]) {
    subtree_sums(model.bodies(), &mut data.wrench, &mut data.wrench_outside);
    data.wrench_before[0] = Wrench::zero();
    outside_sums(model.bodies(), &data.wrench, &mut data.wrench_outside, &mut data.wrench_before);
    model.gather(out, |j| {
        let (connection, reaction): (Twist<T>, Twist<T>) = (data.connection.at(j), data.reaction.at(j));
        reaction.dot(data.wrench[j + 1]) - connection.dot(data.wrench_outside[j + 1])
    });
}
