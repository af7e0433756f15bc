//! How far one motion is from another.

use frs_core::Real;
use frs_core::extended::DoubleDouble;
use frs_core::spatial::{Pose, Wrench};

use crate::integrate::State;
use crate::run::Equations;

/// What of a state is compared.
#[derive(Clone, Debug)]
pub struct Observed {
    pose: Pose<DoubleDouble>,
    /// q and q̇.
    shape: Vec<DoubleDouble>,
    momentum: Wrench<DoubleDouble>,
    energy: DoubleDouble,
}

impl Observed {
    pub(super) fn of(
        equations: &mut dyn Equations<DoubleDouble>,
        time: DoubleDouble,
        state: &State<DoubleDouble>,
    ) -> Self {
        Self {
            pose: state.pose,
            shape: equations.shape(time, state),
            momentum: equations.momentum(time, state),
            energy: equations.kinetic_energy(time, state),
        }
    }
}

/// The largest differences of two motions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Of the base's orientation (rad), and of its position (m; relative beyond 1 m).
    pub pose: f64,
    /// Of the joints (rad, m; relative beyond 1).
    pub shape: f64,
    /// Of the momentum about the world's origin (kg·m²/s, kg·m/s).
    pub momentum: f64,
    /// Of the kinetic energy, relative to the largest of the motion; absolute (J) where that is 0.
    pub energy: f64,
}

impl Errors {
    /// The larger of pose and shape: what a motion is ranked by.
    pub fn of_state(&self) -> f64 {
        self.pose.max(self.shape)
    }

    /// Between a motion and the one that counts as exact; infinite where something is no number.
    pub fn between(found: &[Observed], exact: &[Observed]) -> Self {
        let mut errors = Self::default();
        let most = exact.iter().fold(0.0, |most: f64, observed| most.max(observed.energy.high()));
        let unit = if most > 0.0 { most } else { 1.0 };
        for (found, exact) in found.iter().zip(exact) {
            errors.place(&found.pose, &found.shape, exact);
            for (a, b) in found.momentum.to_array().into_iter().zip(exact.momentum.to_array()) {
                raise(&mut errors.momentum, (a - b).high().abs());
            }
            raise(&mut errors.energy, (found.energy - exact.energy).high().abs() / unit);
        }
        errors
    }

    /// Of places and shapes alone; momentum and energy are not known.
    pub(super) fn of_places<'p>(
        found: impl Iterator<Item = (&'p Pose<DoubleDouble>, &'p [DoubleDouble])>,
        exact: &[Observed],
    ) -> Self {
        let mut errors = Self { momentum: f64::NAN, energy: f64::NAN, ..Self::default() };
        found.zip(exact).for_each(|((pose, q), exact)| errors.place(pose, q, exact));
        errors
    }

    /// Of a pose and of as many coordinates as the robot has.
    fn place(&mut self, pose: &Pose<DoubleDouble>, q: &[DoubleDouble], exact: &Observed) {
        let turn = pose.rotation.transpose() * exact.pose.rotation;
        // For small angles, the skew half of a rotation is its angle.
        let half = DoubleDouble::from_f64(0.5);
        let skew = [(2, 1), (0, 2), (1, 0)].map(|(i, j)| ((turn[(i, j)] - turn[(j, i)]) * half).high());
        let angle = match turn.trace().high() < 1.0 {
            // More than a right angle: the sine says nothing any more.
            true => std::f64::consts::FRAC_PI_2,
            false => skew.iter().map(|x| x * x).sum::<f64>().sqrt(),
        };
        raise(&mut self.pose, angle);
        for (a, b) in pose.translation.iter().zip(&exact.pose.translation) {
            raise(&mut self.pose, apart(*a, *b));
        }
        let joints = exact.shape.len() / 2;
        for (a, b) in q.iter().zip(&exact.shape).take(joints) {
            raise(&mut self.shape, apart(*a, *b));
        }
    }
}

/// A difference, relative beyond 1.
fn apart(found: DoubleDouble, exact: DoubleDouble) -> f64 {
    (found - exact).high().abs() / exact.high().abs().max(1.0)
}

/// The larger of both; what is no number is infinite.
fn raise(largest: &mut f64, value: f64) {
    *largest = if value.is_nan() { f64::INFINITY } else { largest.max(value) };
}
