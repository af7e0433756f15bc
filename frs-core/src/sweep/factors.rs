//! What each body's own motion adds to a Coriolis matrix.

use super::parts::{gather, scatter, splat};
use super::{Data, groups};
use crate::Real;
use crate::model::Model;
use crate::spatial::{Inertia, Twist};

/// `factor[k] = C(I_k; V_k) − I_k ad_{V_k}` for body velocities V_k = w_k − `base`.
pub(crate) fn factors<T: Real>(model: &Model<T>, data: &mut Data<T>, base: Twist<T>) {
    data.factor[0] = data.inertia[0].coriolis_factor(data.velocity[0] - base);
    let base: Twist<T::Lanes> = splat(base);
    for first in groups::<T>(0..model.joints()) {
        let inertia: Inertia<T::Lanes> = gather(&data.inertia, first + 1);
        let velocity: Twist<T::Lanes> = gather(&data.velocity, first + 1);
        scatter(&mut data.factor, first + 1, inertia.coriolis_factor(velocity - base));
    }
}
