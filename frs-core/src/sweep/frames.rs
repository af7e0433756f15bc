//! From the centroidal frame back to the base frame.

use nalgebra::{Matrix6, Vector3};

use crate::Real;
use crate::spatial::cross_matrix;

/// `Tᵀ X T` with `T = Ad_{(1,com)}⁻¹ = [[1, 0], [−com×, 1]]`: a matrix from twists to wrenches, in the base frame.
pub(crate) fn base_matrix<T: Real>(centroidal: &Matrix6<T>, com: Vector3<T>) -> Matrix6<T> {
    let c = cross_matrix(com);
    let block = |row, column| centroidal.fixed_view::<3, 3>(row, column).into_owned();
    let (upper, lower) = (block(0, 0) - block(0, 3) * c, block(3, 0) - block(3, 3) * c);
    let mut matrix = *centroidal;
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&(upper + c * lower));
    matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&(block(0, 3) + c * block(3, 3)));
    matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&lower);
    matrix
}
