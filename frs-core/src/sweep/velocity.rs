//! Velocity sweep: what every body does when the momentum is zero. docs/mathematics.md §3.

use super::{Columns, Data, Row};
use crate::Real;
use crate::model::Model;
use crate::spatial::Twist;

/// Fills `rate` and `velocity`: w_k = Σ_{l⪯k} ŝ_l q̇_l − Σ_{l⋠k} A_l q̇_l, recursively w_k = w_p + s_k q̇_k.
pub(super) fn velocity<T: Real>(model: &Model<T>, qd: &[T], data: &mut Data<T>) {
    for (j, body) in model.bodies()[1..].iter().enumerate() {
        data.rate[j] = qd[body.drive.coordinate] * body.drive.ratio;
    }
    let Data { rate, velocity, connection, screw, .. } = data;
    free_velocities(model, rate, connection, screw, velocity);
}

/// The velocities w_k of the bodies at zero momentum, for joint rates `rate`.
pub(crate) fn free_velocities<T: Real>(
    model: &Model<T>,
    rate: &Row<T>,
    connection: &Columns<T, 6>,
    screw: &Columns<T, 6>,
    velocity: &mut [Twist<T>],
) {
    let mut base = Twist::zero();
    for j in 0..model.joints() {
        base = base.minus_scaled(connection.at(j), rate[j]);
    }
    velocity[0] = base;
    for (k, body) in model.bodies().iter().enumerate().skip(1) {
        velocity[k] = velocity[body.parent].plus_scaled(screw.at(k - 1), rate[k - 1]);
    }
}
