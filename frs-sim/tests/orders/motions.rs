//! Three motions, each over any scalar.

use std::ops::Range;

use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Model, Real, Workspace, urdf};
use frs_sim::integrate::{State, System, Tangent};
use nalgebra::Vector3;

/// How long each lasts, s.
pub const DURATION: f64 = 2.0;

/// A motion with its start, over any scalar.
pub trait Motion {
    type System<T: Real>: System<T>;

    fn make<T: Real>() -> Self::System<T>;
    fn start<T: Real>() -> State<T>;
}

fn number<T: Real>(x: f64) -> T {
    T::from_f64(x)
}

/// A free rigid body: the numbers are its angular momentum in its own axes.
pub struct Top;

impl Motion for Top {
    type System<T: Real> = Self;

    fn make<T: Real>() -> Self {
        Self
    }

    fn start<T: Real>() -> State<T> {
        State { pose: Pose::identity(), flat: [0.3, 2.0, 0.4].map(number).to_vec() }
    }
}

impl<T: Real> System<T> for Top {
    fn dimension(&self) -> usize {
        3
    }

    fn velocities(&self) -> Range<usize> {
        0..3
    }

    fn rate(&mut self, _: T, state: &State<T>, rate: &mut Tangent<T>) {
        let momentum = Vector3::from_column_slice(&state.flat);
        let omega = momentum.component_div(&Vector3::new(1.0, 2.0, 3.0).map(number));
        rate.twist = Twist::new(omega, Vector3::zeros());
        rate.flat.copy_from_slice(momentum.cross(&omega).as_slice());
    }
}

/// A base that is pulled along a screw that turns with time and with two numbers that oscillate.
pub struct Shaken;

impl Motion for Shaken {
    type System<T: Real> = Self;

    fn make<T: Real>() -> Self {
        Self
    }

    fn start<T: Real>() -> State<T> {
        State {
            pose: Pose::from_rpy(Vector3::new(1.0, 2.0, 3.0).map(number), [0.1, 0.2, 0.3].map(number)),
            flat: vec![number(1.0), number(0.5)],
        }
    }
}

impl<T: Real> System<T> for Shaken {
    fn dimension(&self) -> usize {
        2
    }

    fn velocities(&self) -> Range<usize> {
        1..2
    }

    fn rate(&mut self, time: T, state: &State<T>, rate: &mut Tangent<T>) {
        let (sin, cos) = time.sin_cos();
        let [x, v] = [state.flat[0], state.flat[1]];
        let height = state.pose.translation.z * number(0.1);
        rate.twist = Twist::from_array([cos, sin * x, v, x, number::<T>(1.0) - height, sin]);
        rate.flat.copy_from_slice(&[v, sin - x * number(4.0) - v * number(0.3)]);
    }
}

/// The planar robot with springs in its joints, given a push: q, q̇ and μ.
pub struct Robot;

/// The robot itself, with its equations.
pub struct Springs<T: Real> {
    model: Model<T>,
}

impl Motion for Robot {
    type System<T: Real> = Springs<T>;

    fn make<T: Real>() -> Springs<T> {
        Springs { model: Model::from_urdf(urdf::LWR_SATELLITE).unwrap().lock(&HELD).unwrap().cast() }
    }

    fn start<T: Real>() -> State<T> {
        let q = [0.4, -0.7, 0.9];
        let qd = [0.3, 0.2, -0.5];
        let mu = [0.1, 0.2, -0.1, 0.05, 0.0, 0.1];
        State { pose: Pose::identity(), flat: [&q[..], &qd, &mu].concat().into_iter().map(number).collect() }
    }
}

/// Joints that are held, so that the reference is quick.
const HELD: [(&str, f64); 4] = [("joint_1", 0.2), ("joint_3", -0.4), ("joint_5", 0.1), ("joint_7", 0.0)];

impl<T: Real> System<T> for Springs<T> {
    fn dimension(&self) -> usize {
        12
    }

    fn velocities(&self) -> Range<usize> {
        3..12
    }

    fn rate(&mut self, time: T, state: &State<T>, rate: &mut Tangent<T>) {
        let (q, rest) = state.flat.split_at(3);
        let (qd, mu) = rest.split_at(3);
        let mu = Twist::from_array(std::array::from_fn(|i| mu[i]));
        let tau: [T; 3] = std::array::from_fn(|i| -(q[i] * number(0.5) + qd[i] * number(0.05)));
        let push = Wrench::from_array([number(0.01), T::zero(), T::zero(), T::zero(), time * number(0.1), T::zero()]);
        let mut work = Workspace::new(&self.model);
        let mut shape = work.shape(q);
        let mut moving = shape.moving(qd);
        rate.twist = moving.base_twist(mu);
        let mut xi_dot = [T::zero(); 9];
        moving.forward_dynamics(mu, push, &tau, &mut xi_dot);
        rate.flat[..3].copy_from_slice(qd);
        rate.flat[3..6].copy_from_slice(&xi_dot[6..]);
        rate.flat[6..].copy_from_slice(&xi_dot[..6]);
    }
}
