//! Paths of shapes in smooth pieces.

/// A path of shapes q(t) in smooth pieces, one after the other.
///
/// Corners lie between pieces only, so that whoever integrates along the path can hit them exactly.
pub trait Path {
    /// How many coordinates a shape has, n.
    fn dof(&self) -> usize;

    /// How many smooth pieces the path has.
    fn pieces(&self) -> usize;

    /// Writes `q(t)` and `dq/dt` at `t` ∈ [0, 1] of a piece (rad, m).
    ///
    /// # Panics
    /// May panic if `q` or `dq` has not n numbers, or if there is no such piece.
    fn at(&self, piece: usize, t: f64, q: &mut [f64], dq: &mut [f64]);
}

impl<P: Path> Path for &P {
    fn dof(&self) -> usize {
        (**self).dof()
    }

    fn pieces(&self) -> usize {
        (**self).pieces()
    }

    fn at(&self, piece: usize, t: f64, q: &mut [f64], dq: &mut [f64]) {
        (**self).at(piece, t, q, dq);
    }
}

/// A path walked from its end to its start.
#[derive(Clone, Copy, Debug)]
pub struct Reversed<P>(pub P);

impl<P: Path> Path for Reversed<P> {
    fn dof(&self) -> usize {
        self.0.dof()
    }

    fn pieces(&self) -> usize {
        self.0.pieces()
    }

    fn at(&self, piece: usize, t: f64, q: &mut [f64], dq: &mut [f64]) {
        self.0.at(self.0.pieces() - 1 - piece, 1.0 - t, q, dq);
        dq.iter_mut().for_each(|rate| *rate = -*rate);
    }
}

/// Euclidean length of a path in all its coordinates, to the accuracy that `panels` of two nodes a piece have.
pub fn length(path: &impl Path, panels: usize) -> f64 {
    let (mut q, mut dq) = (vec![0.0; path.dof()], vec![0.0; path.dof()]);
    let node = 0.5 / 3.0_f64.sqrt();
    let mut sum = 0.0;
    for (piece, panel) in (0..path.pieces()).flat_map(|piece| (0..panels).map(move |panel| (piece, panel))) {
        for offset in [0.5 - node, 0.5 + node] {
            path.at(piece, (panel as f64 + offset) / panels as f64, &mut q, &mut dq);
            sum += 0.5 * norm(&dq) / panels as f64;
        }
    }
    sum
}

/// |v|.
pub(crate) fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
