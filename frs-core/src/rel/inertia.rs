//! Λ_b and Λ_q, the two blocks of the inertia.

use nalgebra::{DMatrix, Vector3};

use crate::Real;
use crate::spatial::{Inertia, Symmetric3, Twist};
use crate::sweep::{Shape, Square, add_dot, dot, splat};

impl<T: Real> Shape<'_, '_, T> {
    /// The locked inertia `Λ_b = Σ_k X_kᵀ M_k X_k` (6×6, base frame): the robot's inertia with its joints locked.
    ///
    /// Source: the paper; docs/mathematics.md §2. [`Inertia::to_matrix`] gives the matrix.
    pub fn locked_inertia(&self) -> Inertia<T> {
        let (about_com, com) = (self.data.composite[0], self.com());
        Inertia::from_com(about_com.mass, com, about_com.rotational)
    }

    /// The shape inertia `Λ_q = Σ_k J̃_kᵀ M_k J̃_k` (n×n, symmetric; kg·m², kg·m, kg), by the complement form.
    ///
    /// `Λ_q(i,j) = A_j·k_i` where i is j or an ancestor of j, `−A_i·h_j` where neither is the other's ancestor. No two
    /// large numbers cancel, so it keeps its digits for a base of any lightness. Source: docs/mathematics.md §3.
    ///
    /// # Panics
    /// If `out` is not n×n.
    pub fn shape_inertia(&mut self, out: &mut DMatrix<T>) {
        let (model, data) = (self.model, &mut *self.data);
        let (joints, row) = (model.joints(), &mut data.row);
        let (connections, insides) = (data.connection.groups(), data.inside.groups());
        let mut out = Square::new(model, out, 0);
        for i in 0..joints {
            let end = model.bodies()[i + 1].end - 1;
            let (outside, connection) =
                (splat(data.outside.at::<[T; 6]>(i)), splat(-data.connection.at::<Twist<T>>(i)));
            row.fill([i, end, joints], |g| dot(outside, &connections[g]), |g| dot(connection, &insides[g]));
            out.both(i, T::one(), row);
        }
        out.mirror(T::one());
    }

    /// The shape inertia by the textbook form `Λ_q = M_q − A_lᵀ Λ_b A_l`, for comparison.
    ///
    /// Loses about as many digits as the base is lighter than the arm; prefer [`shape_inertia`](Self::shape_inertia).
    ///
    /// # Panics
    /// If `out` is not n×n.
    pub fn shape_inertia_textbook(&mut self, out: &mut DMatrix<T>) {
        let (model, data) = (self.model, &mut *self.data);
        let (joints, row) = (model.joints(), &mut data.row);
        let insides = data.inside.groups();
        let mut out = Square::new(model, out, 0);
        for i in 0..joints {
            let end = model.bodies()[i + 1].end - 1;
            let (screw, connection) = (splat(data.screw.at::<[T; 6]>(i)), splat(-data.connection.at::<Twist<T>>(i)));
            row.fill(
                [i, end, joints],
                |g| add_dot(dot(screw, &insides[g]), connection, &insides[g]),
                |g| dot(connection, &insides[g]),
            );
            out.both(i, T::one(), row);
        }
        out.mirror(T::one());
    }

    /// The rotational inertia about the centre of mass, base axes, with joints locked.
    pub fn locked_rotational_inertia(&self) -> Symmetric3<T> {
        self.data.composite[0].rotational
    }

    /// The pivots of `L D Lᵀ = ` [`locked_rotational_inertia`](Self::locked_rotational_inertia), inverted: not finite or
    /// not positive where the locked inertia is singular in this shape.
    pub fn locked_inverse_pivots(&self) -> Vector3<T> {
        self.data.locked.inverse_pivots
    }
}
