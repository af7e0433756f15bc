//! Joints that are driven otherwise than by torques: rotors that turn with them, and courses that they follow.

use frs_core::spatial::Twist;
use frs_core::{Moving, Real};
use nalgebra::DMatrix;

use super::Load;
use crate::signal::Signal;

/// What a joint does, whatever it takes.
#[derive(Clone, Debug, PartialEq)]
pub enum Course {
    /// `q = offset + amplitude·sin(rate·t + phase)`
    Sinusoid {
        /// Middle of the motion (rad, m).
        offset: f64,
        /// Half of its width (rad, m).
        amplitude: f64,
        /// Angular frequency, rad/s.
        rate: f64,
        /// Phase at time 0, rad.
        phase: f64,
    },
    /// A function given piece by piece; one piece is a joint that is held.
    Pieces(Signal),
}

impl Course {
    /// Value, rate, and acceleration at a time (s).
    pub fn at<T: Real>(&self, time: T) -> [T; 3] {
        match self {
            Self::Sinusoid { offset, amplitude, rate, phase } => {
                let [offset, amplitude, rate, phase] = [offset, amplitude, rate, phase].map(|x| T::from_f64(*x));
                let (sin, cos) = (rate * time + phase).sin_cos();
                let swing = amplitude * sin;
                [offset + swing, amplitude * rate * cos, -(rate * rate * swing)]
            }
            Self::Pieces(signal) => signal.with_rates(time),
        }
    }

    /// Times at which it is not smooth, s.
    pub fn knots(&self) -> &[f64] {
        match self {
            Self::Pieces(signal) => signal.knots(),
            Self::Sinusoid { .. } => &[],
        }
    }

    /// It goes on from `time` (s) as it is after it.
    pub fn enter(&mut self, time: f64) {
        if let Self::Pieces(signal) = self {
            signal.enter(time);
        }
    }
}

/// Rotors and courses of a robot's joints.
///
/// A rotor that turns by the joint's angle times its gear ratio adds `J = ratio²·I` to the diagonal of Λ_q; its share of the momentum of the
/// whole is neglected, as is usual for high ratios. A joint on a course moves as the course says, and its torque is what that takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Drives<T: Real = f64> {
    rotor: Vec<T>,
    courses: Vec<Option<Course>>,
    given: Vec<bool>,
}

impl<T: Real> Drives<T> {
    /// Rotor inertias as the joints feel them (kg·m², kg) and courses, one each per coordinate.
    ///
    /// # Panics
    /// If there are not as many rotors as courses.
    pub fn new(rotor: &[f64], courses: Vec<Option<Course>>) -> Self {
        assert_eq!(rotor.len(), courses.len(), "one rotor and one course per coordinate");
        let given = courses.iter().map(Option::is_some).collect();
        Self { rotor: rotor.iter().map(|rotor| T::from_f64(*rotor)).collect(), courses, given }
    }

    /// How many coordinates these are for.
    pub fn dof(&self) -> usize {
        self.rotor.len()
    }

    /// The motion goes on from `time` (s): the courses are those after it.
    pub fn enter(&mut self, time: f64) {
        self.courses.iter_mut().flatten().for_each(|course| course.enter(time));
    }

    /// Puts joints on their courses: values, rates, and accelerations.
    pub(super) fn place(&self, time: T, q: &mut [T], qd: &mut [T], qdd: &mut [T]) {
        for (i, course) in self.courses.iter().enumerate() {
            if let Some(course) = course {
                [q[i], qd[i], qdd[i]] = course.at(time);
            }
        }
    }

    /// Accelerations of the joints on a course, where `qdd` has those of all.
    pub(crate) fn put_accelerations(&self, time: T, qdd: &mut [T]) {
        for (qdd, course) in qdd.iter_mut().zip(&self.courses) {
            if let Some(course) = course {
                [_, _, *qdd] = course.at(time);
            }
        }
    }

    /// Of joints on a course, what `all` has.
    pub(crate) fn put_given(&self, all: &[T], out: &mut [T]) {
        for ((out, &one), _) in out.iter_mut().zip(all).zip(&self.given).filter(|(_, given)| **given) {
            *out = one;
        }
    }

    /// Adds the rotors to an inertia in ξ, of which the lower triangle counts, and lets joints on a course not feel a `force` in ξ.
    pub(crate) fn hold(&self, inertia: &mut DMatrix<T>, force: &mut [T]) {
        for (i, (&rotor, &given)) in (6..).zip(self.rotor.iter().zip(&self.given)) {
            inertia[(i, i)] += rotor;
            if given {
                inertia.row_mut(i).fill(T::zero());
                inertia.column_mut(i).fill(T::zero());
                (inertia[(i, i)], force[i]) = (T::one(), T::zero());
            }
        }
    }

    /// Accelerations of the free joints into `qdd`, torques of the others, whose accelerations are there, into the load.
    pub fn accelerations(&self, robot: &mut Moving<'_, '_, '_, T>, mu: Twist<T>, load: &mut Load<T>, qdd: &mut [T]) {
        robot.hybrid_dynamics(mu, load.base_wrench, &self.rotor, &self.given, &mut load.tau, qdd);
    }

    /// Adds `J_i q̇_i`, the rotors' share of the shape's momentum.
    pub fn add_rotors(&self, qd: &[T], momentum: &mut [T]) {
        for ((sum, &rotor), &qd) in momentum.iter_mut().zip(&self.rotor).zip(qd) {
            *sum += rotor * qd;
        }
    }

    /// `½ Σ J_i q̇_i²`, J.
    pub(super) fn kinetic_energy(&self, qd: &[T]) -> T {
        let twice = self.rotor.iter().zip(qd).fold(T::zero(), |sum, (rotor, &qd)| sum + *rotor * qd * qd);
        twice * T::from_f64(0.5)
    }
}
