//! Orthonormal frames along an axis.

use nalgebra::{Matrix3, Vector3};

/// A rotation `Q` with `Q z = axis/|axis|`; `axis` must be finite and not zero.
///
/// The completion is the branchless one of Duff et al., "Building an Orthonormal Basis, Revisited" (2017): accurate to
/// rounding for every axis, the identity for z, and a signed permutation (entries exactly 0 and ±1) for every
/// coordinate axis.
pub(super) fn along(axis: Vector3<f64>) -> Matrix3<f64> {
    // The largest entry becomes ±1, so that neither huge nor tiny axes lose their squares; −0 becomes 0.
    let scaled = (axis / axis.amax()).add_scalar(0.0);
    let n = scaled / scaled.norm();
    let sign = 1.0_f64.copysign(n.z);
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    Matrix3::new(1.0 + sign * n.x * n.x * a, b, n.x, sign * b, sign + n.y * n.y * a, n.y, -sign * n.x, -n.y, n.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rotation made of a dozen roundings.
    const ROUNDING: f64 = 4.0 * f64::EPSILON;

    #[test]
    fn coordinate_axes_give_signed_permutations_and_z_the_identity() {
        for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
            for length in [1.0, -1.0, 3.0, -1e-300, 1e30] {
                let q = along(axis * length);
                assert!(q.iter().all(|entry| [0.0, 1.0, -1.0].contains(entry)), "{q}");
                assert_eq!(q.column(2), axis * length.signum());
                assert_eq!(q.determinant(), 1.0);
            }
        }
        assert_eq!(along(Vector3::z()), Matrix3::identity());
        assert_eq!(along(Vector3::new(1.0, 0.0, -0.0)), along(Vector3::x()));
    }

    #[test]
    fn any_axis_gives_a_rotation_that_takes_z_to_it() {
        for axis in [
            Vector3::new(1.0, 2.0, 3.0),
            Vector3::new(1e-9, 0.0, -1.0),
            Vector3::new(-1e-200, 1e-200, 0.0),
            Vector3::new(0.577350269, -0.577350269, 0.577350269),
        ] {
            let q = along(axis);
            assert!((q.transpose() * q - Matrix3::identity()).amax() < ROUNDING);
            assert!((q.determinant() - 1.0).abs() < ROUNDING);
            let unit = axis / axis.amax();
            assert!((q.column(2) * unit.norm() - unit).amax() < ROUNDING);
        }
    }
}
