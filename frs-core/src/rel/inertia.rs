//! Λ_b and Λ_q, the two blocks of the inertia.

use nalgebra::{DMatrix, Vector3};

use crate::Real;
use crate::spatial::{Inertia, Symmetric3, Twist, Wrench};
use crate::sweep::{Shape, Square, Symmetry, groups, joined};

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
        let (connections, insides) = (data.connection.groups(), data.inside.groups());
        let mut out = Square::new(model, out, 0, Symmetry::Symmetric, &mut data.row);
        for first in groups::<T>(0..model.joints()) {
            let connection: Twist<T::Lanes> = data.connection.lanes(first);
            out.rows(first, (data.outside.group(first), connections), (&(-connection).to_array(), insides));
        }
        out.mirror();
    }

    /// The shape inertia by the textbook form `Λ_q = M_q − A_lᵀ Λ_b A_l`, for comparison.
    ///
    /// Loses about as many digits as the base is lighter than the arm; prefer [`shape_inertia`](Self::shape_inertia).
    ///
    /// # Panics
    /// If `out` is not n×n.
    pub fn shape_inertia_textbook(&mut self, out: &mut DMatrix<T>) {
        let (model, data) = (self.model, &mut *self.data);
        for first in groups::<T>(0..model.joints()) {
            let inside: Wrench<T::Lanes> = data.inside.lanes(first);
            data.twelve_rows.set_lanes(first, joined(inside, inside));
        }
        let (insides, twice) = (data.inside.groups(), data.twelve_rows.groups());
        let mut out = Square::new(model, out, 0, Symmetry::Symmetric, &mut data.row);
        for first in groups::<T>(0..model.joints()) {
            let (screw, connection): (Twist<T::Lanes>, Twist<_>) =
                (data.screw.lanes(first), data.connection.lanes(first));
            out.rows(first, (&joined(screw, -connection), twice), (&(-connection).to_array(), insides));
        }
        out.mirror();
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
