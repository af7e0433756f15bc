//! Articulated-body sweep: joint accelerations in O(n), without a matrix. Featherstone, RBDA §7.3, in the centroidal
//! frame, where no pass needs a coordinate transform.

use super::Data;
use crate::Real;
use crate::model::Model;
use crate::spatial::{ArticulatedInertia, Twist, Wrench};

/// `acceleration[j]` of every joint j, for body velocities V_k = `locked` + w_k, wrench `base_wrench` on the base
/// (centroidal frame) and joint torques `tau`. The joints must be independent (no mimic).
pub(crate) fn articulated_accelerations<T: Real>(
    model: &Model<T>,
    data: &mut Data<T>,
    locked: Twist<T>,
    base_wrench: Wrench<T>,
    tau: &[T],
) {
    let Data { articulated, wrench, twist, velocity, inertia, screw, rate, six, row, row_more, .. } = data;
    for k in 0..articulated.len() {
        let v = velocity[k] + locked;
        articulated[k] = ArticulatedInertia::rigid(&inertia[k]);
        wrench[k] = -v.ad_transpose(inertia[k] * v);
    }
    wrench[0] = wrench[0] - base_wrench;

    for (k, body) in model.bodies().iter().enumerate().skip(1).rev() {
        let (j, p) = (k - 1, body.parent);
        let s = Twist::from_array(screw.get(j));
        let bias = (velocity[k] + locked).ad(s) * rate[j];
        let u = articulated[k] * s;
        let inverse_pivot = T::one() / s.dot(u);
        let torque = tau[body.drive.coordinate] - s.dot(wrench[k]);
        let handed_down = wrench[k] + articulated[k] * bias + u * ((torque - bias.dot(u)) * inverse_pivot);
        wrench[p] = wrench[p] + handed_down;
        articulated[p] = articulated[p] + articulated[k].without(u, inverse_pivot);
        twist[k] = bias;
        six.set(j, u.to_array());
        row[j] = torque;
        row_more[j] = inverse_pivot;
    }

    twist[0] = articulated[0].solve(-wrench[0]);
    for (k, body) in model.bodies().iter().enumerate().skip(1) {
        let j = k - 1;
        let carried = twist[body.parent] + twist[k];
        row[j] = (row[j] - carried.dot(Wrench::from_array(six.get(j)))) * row_more[j];
        twist[k] = carried + Twist::from_array(screw.get(j)) * row[j];
    }
}
