//! L D Lᵀ of a symmetric positive definite matrix over any scalar, in place, without pivoting or roots.
//!
//! nalgebra's own factorisations ask for an ordered field; this one asks only for [`Real`].

use nalgebra::DMatrix;

use crate::Real;

/// Overwrites the lower triangle of `a` by L (below) and the *inverse* pivots 1/D (on the diagonal).
pub fn factor<T: Real>(a: &mut DMatrix<T>) {
    let n = a.nrows();
    for j in 0..n {
        let inverse = T::one() / a[(j, j)];
        a[(j, j)] = inverse;
        for i in j + 1..n {
            let scaled = a[(i, j)] * inverse;
            // Columns right of j lose what column j explains; a(k, j) is still unscaled for k ≥ i.
            let (left, mut right) = a.columns_range_pair_mut(j..j + 1, i..i + 1);
            for k in i..n {
                right[(k, 0)] = right[(k, 0)].minus_product(left[(k, 0)], scaled);
            }
            a[(i, j)] = scaled;
        }
    }
}

/// Overwrites `x` by the solution of `L D Lᵀ y = x`.
pub fn solve<T: Real>(factors: &DMatrix<T>, x: &mut [T]) {
    let n = x.len();
    for j in 0..n {
        let value = x[j];
        for i in j + 1..n {
            x[i] = x[i].minus_product(factors[(i, j)], value);
        }
    }
    for j in (0..n).rev() {
        let mut value = x[j] * factors[(j, j)];
        for i in j + 1..n {
            value = value.minus_product(factors[(i, j)], x[i]);
        }
        x[j] = value;
    }
}
