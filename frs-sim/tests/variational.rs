//! The variational integrator: order 2, a momentum that never changes, an energy that does not drift.

use frs_core::spatial::{Pose, Twist};
use frs_core::{Model, Moving, Workspace, urdf};
use frs_sim::integrate::{Adaptive, DOP853};
use frs_sim::motion::{Canonical, Conserved, Instant, Load, Motion, Variational};
use nalgebra::Vector3;

/// Springs in the joints, 0.8 N·m/rad.
const STIFFNESS: f64 = 0.8;

fn springs(instant: &Instant<'_>, _: &mut Moving<'_, '_, '_>, load: &mut Load) {
    load.tau.iter_mut().zip(instant.q).for_each(|(tau, q)| *tau -= STIFFNESS * q);
}

fn pose() -> Pose<f64> {
    Pose::from_rpy(Vector3::new(1.0, -2.0, 0.5), [0.3, -0.6, 1.1])
}

const MU: [f64; 6] = [0.3, 0.4, -0.3, 0.1, -0.2, 0.3];

fn stored(state: &Canonical) -> f64 {
    0.5 * STIFFNESS * state.q.iter().map(|q| q * q).sum::<f64>()
}

/// A satellite with an arm, a robot in a plane, and a body without joints.
#[test]
fn it_has_order_two_on_three_motions() {
    let satellite = ([0.1, -0.4, 0.3, 1.2, 0.0, -0.7, 0.2], [0.5, -0.2, 0.1, 0.3, -0.4, 0.2, 0.6]);
    has_order_two(&Model::from_urdf(urdf::LWR_SATELLITE).unwrap(), &satellite.0, &satellite.1);
    let planar = Model::from_urdf(include_str!("../../robots/planar_three_link.urdf")).unwrap();
    has_order_two(&planar, &[0.5, -0.3], &[0.2, 0.4]);
    let inertial = "<mass value='2'/><inertia ixx='0.1' iyy='0.2' izz='0.25' ixy='0' ixz='0.02' iyz='0'/>";
    let body = format!("<robot name='body'><link name='body'><inertial>{inertial}</inertial></link></robot>");
    has_order_two(&Model::from_urdf(&body).unwrap(), &[], &[]);
}

fn has_order_two(model: &Model, q: &[f64], qd: &[f64]) {
    /// What the next power of h still contributes.
    const TOLERANCE: f64 = 0.05;
    const DURATION: f64 = 1.0;
    let mut variational = Variational::new(model, springs);
    let start = variational.state(pose(), q, qd, Twist::from_array(MU));

    let mut work = Workspace::new(model);
    let momentum = work.shape(q).centroidal_momentum(Twist::from_array(MU));
    let momentum = Pose::new(pose().rotation, Vector3::zeros()).act_wrench(momentum);
    let mut motion = Motion::new(model, Conserved { momentum }, springs);
    let state = motion.state(pose(), q, qd, Twist::zero());
    let mut exact = Adaptive::new(&DOP853, state, 0.0, 1e-13);
    while exact.time() < DURATION {
        exact.advance(&mut motion, DURATION).unwrap();
    }
    let errors = [400, 800, 1600].map(|steps| {
        let (mut state, h) = (start.clone(), DURATION / f64::from(steps));
        for i in 0..steps {
            variational.step(h * f64::from(i), h, &mut state).unwrap();
        }
        let turn = (state.pose.inverse() * exact.state().pose).log().to_vector().norm();
        let qd = variational.velocities(&state).qd;
        let numbers = state.q.iter().chain(&qd).zip(&exact.state().flat);
        numbers.map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt() + turn
    });
    let orders = [errors[0] / errors[1], errors[1] / errors[2]].map(f64::log2);
    assert!(orders.iter().all(|order| (order - 2.0).abs() < TOLERANCE), "{}: {orders:?} of {errors:?}", model.name());
}

/// A million steps: the energy swings about what it was, and the momentum has the bits that it had.
#[test]
fn a_million_steps_leave_energy_and_momentum() {
    /// Of the energy: it swings by h², and does not drift.
    const SWING: f64 = 1e-4;
    /// Of the largest error: how far the means of both halves may be apart. A steady drift puts them a half of it apart; the motion is
    /// chaotic, and its means are 0.15 of it apart where starts differ by 10⁻¹⁰.
    const APART: f64 = 0.3;
    const STEPS: u32 = 1_000_000;
    /// No multiple of a period, in steps.
    const EVERY: u32 = 20;
    const H: f64 = 0.01;
    let model = Model::from_urdf(include_str!("../../robots/planar_three_link.urdf")).unwrap();
    let mut motion = Variational::new(&model, springs);
    let mut state = motion.state(pose(), &[0.5, -0.3], &[0.2, 0.4], Twist::from_array(MU));
    let start = state.clone();
    let energy = |motion: &mut Variational<'_, _>, state: &Canonical| motion.kinetic_energy(state) + stored(state);
    let before = energy(&mut motion, &start);
    let (mut sums, mut worst) = ([0.0; 2], 0.0_f64);
    for i in 0..STEPS {
        motion.step(H * f64::from(i), H, &mut state).unwrap();
        if i % EVERY == 0 {
            let off = energy(&mut motion, &state) / before - 1.0;
            worst = worst.max(off.abs());
            sums[usize::from(i >= STEPS / 2)] += off / f64::from(STEPS / 2 / EVERY);
        }
    }
    assert!(worst < SWING && worst > 0.0, "{worst:e}");
    assert!((sums[1] - sums[0]).abs() < APART * worst, "it drifts from {:e} to {:e}", sums[0], sums[1]);
    assert_eq!(state.momentum, start.momentum);
    let velocities = motion.velocities(&state);
    let mut work = Workspace::new(&model);
    let found = work.shape(&state.q).spatial_momentum(&state.pose, velocities.mu);
    let drift = (found - start.momentum).to_vector().norm() / start.momentum.to_vector().norm();
    assert!(drift < 1e-12, "{drift:e}");
}
