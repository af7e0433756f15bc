//! Articulated-body sweep: joint accelerations in O(n), without a matrix. Featherstone, RBDA §7.3, in the centroidal
//! frame, where no pass needs a coordinate transform.

use super::{Data, newton_euler};
use crate::Real;
use crate::model::Model;
use crate::spatial::{ArticulatedInertia, Twist, Wrench};

/// Leaves in `row[j]` the acceleration of every joint j, for body velocities V_k = `locked` + w_k, wrench `base_wrench` on the base
/// (centroidal frame) and joint torques `tau`. The joints must be independent (no mimic).
pub(crate) fn articulated_accelerations<T: Real>(
    model: &Model<T>,
    data: &mut Data<T>,
    locked: Twist<T>,
    base_wrench: Wrench<T>,
    tau: &[T],
) {
    // What the bodies need while no joint accelerates; from here on twists are what the joints' accelerations add.
    newton_euler(model, data, locked, Twist::zero(), |_| T::zero());
    let Data { articulated, wrench, twist, inertia, screw, inverse_pivot, .. } = data;
    let (torque, column) = (&mut data.row, &mut data.wrench_outside);
    for k in 0..model.bodies().len() {
        articulated[k] = ArticulatedInertia::rigid(&inertia[k]);
    }
    wrench[0] = wrench[0] - base_wrench;

    for (k, body) in model.bodies().iter().enumerate().skip(1).rev() {
        let (j, p) = (k - 1, body.parent);
        let s: Twist<T> = screw.at(j);
        let u = articulated[k] * s;
        let inverse = T::one() / s.dot(u);
        let unmet = tau[body.drive.coordinate] - s.dot(wrench[k]);
        let handed_down = wrench[k].plus_scaled(u, unmet * inverse);
        wrench[p] += handed_down;
        articulated[p] = articulated[p] + articulated[k].without(u, inverse);
        column[k] = u;
        torque[j] = unmet;
        inverse_pivot[j] = inverse;
    }

    twist[0] = articulated[0].solve(-wrench[0]);
    for (k, body) in model.bodies().iter().enumerate().skip(1) {
        let j = k - 1;
        let carried = twist[body.parent];
        torque[j] = (torque[j] - carried.dot(column[k])) * inverse_pivot[j];
        twist[k] = carried.plus_scaled(screw.at(j), torque[j]);
    }
}
