//! The maps by their definitions: power series, and what undoes them.

use nalgebra::{Matrix3, Matrix4, SMatrix, Vector3};
use num_traits::{One, Zero};

use super::Big;

/// The largest absolute entry, NaN if one is.
pub fn largest<const R: usize, const C: usize>(matrix: &SMatrix<Big, R, C>) -> Big {
    matrix.iter().map(Big::abs).fold(Big::zero(), |a, b| if b.is_nan() || a < b { b } else { a })
}

/// `Σ a^k/(k+shift)!`: `exp(a)` for shift 0, its right-trivialised tangent for shift 1.
pub fn exponential_series<const N: usize>(a: &SMatrix<Big, N, N>, shift: u32) -> SMatrix<Big, N, N> {
    let negligible = largest(a) * Big::new(1e-42);
    let mut term = SMatrix::<Big, N, N>::identity();
    let mut sum = term.clone();
    let mut k = 0;
    while largest(&term) > negligible {
        k += 1;
        term = &term * a * (Big::one() / Big::new(f64::from(k + shift)));
        sum += &term;
    }
    sum
}

/// `exp(a)` for large `a` too: `exp(a/2^m)^(2^m)`.
pub fn exponential<const N: usize>(a: &SMatrix<Big, N, N>) -> SMatrix<Big, N, N> {
    let mut halvings = 0;
    while largest(a) > Big::new(2.0_f64.powi(halvings)) {
        halvings += 1;
    }
    let mut power = exponential_series(&(a * Big::new(0.5_f64.powi(halvings))), 0);
    for _ in 0..halvings {
        power = &power * &power;
    }
    power
}

/// The 4×4 matrix of `zeta`.
pub fn hat([x, y, z, u, v, w]: [Big; 6]) -> Matrix4<Big> {
    let (o, [a, b, c]) = (Big::zero, [x.clone(), y.clone(), z.clone()].map(|e| -e));
    Matrix4::new(o(), c, y, u, z, o(), a, v, b, x, o(), w, o(), o(), o(), o())
}

/// `exp ζ` as (R, p).
pub fn exp(zeta: [Big; 6]) -> (Matrix3<Big>, Vector3<Big>) {
    let power = exponential(&hat(zeta));
    (power.fixed_view::<3, 3>(0, 0).into_owned(), power.fixed_view::<3, 1>(0, 3).into_owned())
}

/// `J⁻¹` by Newton's iteration from `f64`.
pub fn inverse(j: &Matrix3<Big>) -> Matrix3<Big> {
    let mut x = j.map(|e| e.to_f64()).try_inverse().expect("J is regular below 2π").map(Big::new);
    for _ in 0..3 {
        x = &x * (Matrix3::identity() * Big::new(2.0) - j * &x);
    }
    x
}

/// `φ×`.
pub fn cross(phi: &Vector3<Big>) -> Matrix3<Big> {
    Matrix3::from_columns(&[0, 1, 2].map(|k| phi.cross(&Vector3::ith(k, Big::new(1.0)))))
}

/// The logarithm φ of the rotation nearest to `r`, in the sense of `like` where |φ| is about π.
pub fn log(r: &Matrix3<Big>, like: &Vector3<Big>) -> Vector3<Big> {
    let number = Big::new;
    // The last summand gives an exact half turn a sense, and is nothing otherwise.
    let mut x = r + cross(like) * number(1e-60);
    for _ in 0..3 {
        x = &x * (Matrix3::identity() * number(3.0) - x.transpose() * &x) * number(0.5);
    }
    let skew = (&x - x.transpose()) * number(0.5);
    let axis = Vector3::from([(2, 1), (0, 2), (1, 0)].map(|entry| skew[entry].clone()));
    let sin = axis.dot(&axis).sqrt();
    if sin.is_zero() {
        return axis;
    }
    let mut angle = sin.atan2(&((x.trace() - number(1.0)) * number(0.5)));
    if axis.dot(like) < number(0.0) {
        // The other way round.
        angle -= number(1.0).atan2(&number(0.0)) * number(4.0);
    }
    axis * (angle / sin)
}
