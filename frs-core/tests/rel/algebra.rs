//! The six-dimensional algebra of docs/mathematics.md §1, written out as 6×6 matrices of `f64`.

use frs_core::spatial::Pose;
use nalgebra::{Matrix3, Matrix4, Matrix6, Rotation3, Vector3, Vector6};

/// `R_z(yaw) R_y(pitch) R_x(roll)`.
pub fn rotation([roll, pitch, yaw]: [f64; 3]) -> Matrix3<f64> {
    Rotation3::from_euler_angles(roll, pitch, yaw).into_inner()
}

fn blocks(
    upper_left: Matrix3<f64>,
    upper_right: Matrix3<f64>,
    lower_left: Matrix3<f64>,
    lower_right: Matrix3<f64>,
) -> Matrix6<f64> {
    let mut matrix = Matrix6::zeros();
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&upper_left);
    matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&upper_right);
    matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&lower_left);
    matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&lower_right);
    matrix
}

fn halves(six: &Vector6<f64>) -> (Matrix3<f64>, Matrix3<f64>) {
    (Vector3::new(six[0], six[1], six[2]).cross_matrix(), Vector3::new(six[3], six[4], six[5]).cross_matrix())
}

/// `[angular; linear]`.
pub fn six(angular: Vector3<f64>, linear: Vector3<f64>) -> Vector6<f64> {
    Vector6::new(angular.x, angular.y, angular.z, linear.x, linear.y, linear.z)
}

/// `Ad_g = [[R, 0], [p×R, R]]` of the pose `g = (R, p)`.
pub fn adjoint(r: &Matrix3<f64>, p: &Vector3<f64>) -> Matrix6<f64> {
    blocks(*r, Matrix3::zeros(), p.cross_matrix() * r, *r)
}

/// `Ad_g⁻¹ = [[Rᵀ, 0], [−Rᵀp×, Rᵀ]]` of the pose `g = (R, p)`.
pub fn adjoint_inverse(r: &Matrix3<f64>, p: &Vector3<f64>) -> Matrix6<f64> {
    blocks(r.transpose(), Matrix3::zeros(), -r.transpose() * p.cross_matrix(), r.transpose())
}

/// `ad_V = [[ω×, 0], [v×, ω×]]`.
pub fn ad(twist: &Vector6<f64>) -> Matrix6<f64> {
    let (w, v) = halves(twist);
    blocks(w, Matrix3::zeros(), v, w)
}

/// `ad~_h = [[m×, f×], [f×, 0]]`.
pub fn ad_tilde(wrench: &Vector6<f64>) -> Matrix6<f64> {
    let (m, f) = halves(wrench);
    blocks(m, f, f, Matrix3::zeros())
}

/// `C(I; X) = ½(I ad_X − ad_Xᵀ I − ad~_{I X})`.
pub fn coriolis(inertia: &Matrix6<f64>, x: &Vector6<f64>) -> Matrix6<f64> {
    (inertia * ad(x) - ad(x).transpose() * inertia - ad_tilde(&(inertia * x))) * 0.5
}

/// The spatial inertia of a body: mass, centre of mass, rotational inertia about it, in the axes of the link.
pub fn inertia(mass: f64, com: Vector3<f64>, about_com: Matrix3<f64>) -> Matrix6<f64> {
    let c = com.cross_matrix();
    blocks(about_com - c * c * mass, c * mass, -c * mass, Matrix3::identity() * mass)
}

/// The twist as the 4×4 matrix `V^ = [[ω×, v], [0, 0]]`.
pub fn hat(twist: &Vector6<f64>) -> Matrix4<f64> {
    let mut matrix = Matrix4::zeros();
    let (angular, _) = halves(twist);
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&angular);
    matrix.fixed_view_mut::<3, 1>(0, 3).copy_from(&twist.fixed_rows::<3>(3));
    matrix
}

/// `g exp(V^)`: where a frame at `g` stands after moving by the twist `V` for a unit of time.
pub fn moved(pose: &Pose<f64>, twist: &Vector6<f64>) -> Pose<f64> {
    let step = hat(twist).exp();
    *pose * Pose::new(step.fixed_view::<3, 3>(0, 0).into_owned(), step.fixed_view::<3, 1>(0, 3).into_owned())
}
