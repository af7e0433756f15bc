//! What is computed at a state, and whether the state determines it.

use frs::nalgebra::{DMatrix, Scalar};
use frs::{Model, Moving, Real, Workspace};

use crate::cli::answer::{Key, Value};
use crate::cli::state::{BaseMotion, State};

/// The quantities at a state, and the numbers by which they are judged; over any scalar, so that it can be recorded.
#[derive(Clone, Debug)]
pub struct Evaluation<T: Scalar> {
    /// The diagonal of the locked rotational inertia about the centre of mass.
    diagonal: [T; 3],
    /// Its pivots, inverted.
    inverse_pivots: [T; 3],
    /// Λ_q, where accelerations are asked for.
    shape_inertia: Option<DMatrix<T>>,
    values: Vec<Value<T>>,
}

impl<T: Real> Evaluation<T> {
    /// Computes `keys` at `state`.
    pub fn new(work: &mut Workspace<'_, T>, state: &State<T>, keys: &[Key]) -> Self {
        let mut shape = work.shape(&state.q);
        let (inertia, inverse_pivots) = (shape.locked_rotational_inertia(), shape.locked_inverse_pivots());
        let shape_inertia = keys.contains(&Key::XiDot).then(|| {
            let mut shape_inertia = DMatrix::zeros(state.q.len(), state.q.len());
            shape.shape_inertia(&mut shape_inertia);
            shape_inertia
        });
        let mut motion: Moving<T> = shape.moving(&state.qd);
        let mu = match state.base {
            BaseMotion::Locked(mu) => mu,
            BaseMotion::Base(base_twist) => motion.locked_velocity(base_twist),
        };
        Self {
            diagonal: [inertia.xx, inertia.yy, inertia.zz],
            inverse_pivots: inverse_pivots.into(),
            shape_inertia,
            values: keys.iter().map(|key| key.answer(&mut motion, mu, state)).collect(),
        }
    }
}

impl<T: Scalar> Evaluation<T> {
    /// Every number through `change`, one after the other.
    pub fn map<U: Scalar>(self, mut change: impl FnMut(T) -> U) -> Evaluation<U> {
        Evaluation {
            diagonal: self.diagonal.map(&mut change),
            inverse_pivots: self.inverse_pivots.map(&mut change),
            shape_inertia: self.shape_inertia.map(|matrix| matrix.map(&mut change)),
            values: self.values.into_iter().map(|value| value.map(&mut change)).collect(),
        }
    }
}

impl Evaluation<f64> {
    /// The values of `keys`, or why the state does not determine them.
    pub fn judged(self, model: &Model, keys: &[Key]) -> Result<Vec<Value>, String> {
        if !self.is_definite() {
            return Err(
                "the locked inertia Λ_b is singular in this shape: all mass lies on one line, or a number overflowed; \
                 no locked velocity is determined. Move the joints off this shape or give a link its thickness"
                    .into(),
            );
        }
        if let Some(joint) = self.shape_inertia.as_ref().and_then(|matrix| undetermined(matrix, model)) {
            return Err(format!(
                "the shape inertia Λ_q is singular in this shape: nothing resists the motion of joint '{joint}'; no \
                 acceleration is determined. Leave xi_dot out with --only, or give the joint's links their inertia"
            ));
        }
        match self.values.iter().zip(keys).find(|(value, _)| !value.is_finite()) {
            None => Ok(self.values),
            Some((_, key)) => Err(format!(
                "{} is not finite: the numbers of this state are too large for double precision; check the units",
                key.name()
            )),
        }
    }

    /// Whether the locked rotational inertia is positive definite to working precision; false for what is not finite.
    fn is_definite(&self) -> bool {
        let mut pivots = self.diagonal.iter().zip(&self.inverse_pivots);
        pivots.all(|(own, inverse)| 1.0 / inverse > SINGULAR_PIVOT * own)
    }
}

/// Relative size below which a pivot of a factored inertia is rounding: a few times n ε for n of hundreds.
const SINGULAR_PIVOT: f64 = 1e-14;

/// The coordinate whose pivot of Λ_q vanishes, if one does.
fn undetermined(matrix: &DMatrix<f64>, model: &Model) -> Option<String> {
    let vanishes = |size: usize| {
        let leading = matrix.view((0, 0), (size, size)).into_owned();
        let own: Vec<f64> = leading.diagonal().iter().copied().collect();
        leading.cholesky().is_none_or(|factors| {
            let l = factors.l_dirty();
            (0..size).any(|i| l[(i, i)] * l[(i, i)] <= SINGULAR_PIVOT * own[i])
        })
    };
    let n = matrix.nrows();
    let first = if vanishes(n) { (1..=n).find(|&size| vanishes(size)) } else { None };
    first.map(|size| model.coordinates()[size - 1].name.clone())
}
