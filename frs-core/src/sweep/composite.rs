//! Sums over subtrees and over what lies outside them, without a subtraction.

use std::ops::AddAssign;

use crate::Real;
use crate::model::Body;

/// `sums[k]`, the value of body k on entry, becomes the sum over the subtree of k.
///
/// On the way, `outside[k]` is set to what its parent has gathered before k: the parent itself and the later siblings.
pub(crate) fn subtree_sums<T: Real, S: Copy + AddAssign>(bodies: &[Body<T>], sums: &mut [S], outside: &mut [S]) {
    for (k, body) in bodies.iter().enumerate().skip(1).rev() {
        outside[k] = sums[body.parent];
        let sum = sums[k];
        sums[body.parent] += sum;
    }
}

/// After [`subtree_sums`]: `outside[k]` becomes the sum over everything that is not in the subtree of k.
///
/// On the way, `before[k]` gathers what lies outside k and the children of k already passed; its entries need no value
/// on entry but the base's, which is 0.
pub(crate) fn outside_sums<T: Real, S: Copy + AddAssign>(
    bodies: &[Body<T>],
    sums: &[S],
    outside: &mut [S],
    before: &mut [S],
) {
    for (k, body) in bodies.iter().enumerate().skip(1) {
        outside[k] += before[body.parent];
        before[body.parent] += sums[k];
        before[k] = outside[k];
    }
}
