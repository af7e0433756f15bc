//! A body as the box that has its mass and inertia.

use frs::model::Inertial;
use frs::nalgebra::{SymmetricEigen, Vector3};

/// The corners, in the frame of the body; bits 0, 1, 2 of a corner's number tell its side along each axis.
pub fn corners(body: &Inertial) -> [Vector3<f64>; 8] {
    let half = half_edges(body);
    std::array::from_fn(|corner| {
        let sides = (0..3).map(|axis| half[axis] * if corner >> axis & 1 == 0 { -1.0 } else { 1.0 });
        body.com + sides.sum::<Vector3<f64>>()
    })
}

/// Half the edges: `a² = 6 (I_b + I_c − I_a) / m` for edges a, b, c.
fn half_edges(body: &Inertial) -> [Vector3<f64>; 3] {
    let axes = SymmetricEigen::new(body.inertia.to_matrix());
    [0, 1, 2].map(|i| {
        let square = 6.0 * (axes.eigenvalues.sum() - 2.0 * axes.eigenvalues[i]) / body.mass;
        axes.eigenvectors.column(i) * (0.5 * square.max(0.0).sqrt())
    })
}
