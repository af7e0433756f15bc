//! Added mass: the water that links set in motion.
//!
//! ```text
//! V = V_k − [0; R_kᵀ u]                                     the link's twist as the water sees it
//! F_k = ad_Vᵀ M_A V − M_A V̇                                 M_A (6×6, frame of the link): Kirchhoff's equations
//! (Λ + Σ Jᵀ M_A J) ξ̇ = f + Σ Jᵀ (ad_Vᵀ M_A V − M_A V̇⁰)      J = [X_k  J̃_k];  V̇⁰: V̇ where ξ̇ = 0;  Λ ξ̇ = f without water
//! ```
//!
//! Assumed is ideal water without bounds that flows everywhere alike with the velocity u (m/s, world axes), and that links do not feel
//! what others set in motion: M_A is constant in the axes of its link, and ½ Vᵀ M_A V is the water's energy as seen from the water.
//!
//! The wrenches depend on the accelerations that they give. Λ and the added inertia are factored as one to find them, and they are
//! loads like others then. They lose as many digits as the added inertia exceeds the robot's own.
//!
//! Source: Lamb, *Hydrodynamics* (1932), §124; Fossen, *Handbook of Marine Craft Hydrodynamics and Motion Control* (2011), §6.3.

use frs_core::ldl::{factor, solve};
use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Moving, Real};
use nalgebra::{DMatrix, Matrix6xX, Vector3};

use super::Effect;
use crate::motion::{Drives, Instant, Load, Loads};

/// Added mass of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct AddedMass {
    /// The link's number.
    pub link: usize,
    /// M_A by rows, symmetric, not negative; about the origin of the link's frame, in its axes (kg·m², kg·m, kg).
    pub inertia: [[f64; 6]; 6],
}

/// Water that links set in motion.
///
/// Its place is after all other effects: what they add up to decides about the accelerations.
#[derive(Clone, Debug)]
pub struct Water<T: Real = f64> {
    /// Numbers of the links, and what the water does to each.
    links: Vec<usize>,
    around: Vec<Around<T>>,
    /// u, m/s, world axes.
    current: [f64; 3],
    drives: Option<Drives<T>>,
    /// Λ + Σ Jᵀ M_A J with the rotors (its lower triangle), then its factors.
    inertia: DMatrix<T>,
    /// Λ_q and A_l.
    shape_inertia: DMatrix<T>,
    connection: Matrix6xX<T>,
    /// V̇⁰ of each link.
    accelerations: Vec<Twist<T>>,
    /// ξ̇, and the joint torques that the motion takes by itself.
    xi_dot: Vec<T>,
    torques: Vec<T>,
}

/// Water around one link.
#[derive(Clone, Debug)]
struct Around<T: Real> {
    /// M_A by rows.
    inertia: [[T; 6]; 6],
    /// The columns of J, and of M_A J.
    jacobian: Vec<Twist<T>>,
    carried: Vec<Wrench<T>>,
    /// F_k.
    wrench: Wrench<T>,
}

impl<T: Real> Water<T> {
    /// Water that moves with `current` (m/s, world axes) around links of a robot of n coordinates with these `drives`.
    pub fn new(added: &[AddedMass], current: [f64; 3], drives: Option<Drives<T>>, n: usize) -> Self {
        let around = |added: &AddedMass| Around {
            inertia: added.inertia.map(|row| row.map(T::from_f64)),
            jacobian: vec![Twist::zero(); 6 + n],
            carried: vec![Wrench::zero(); 6 + n],
            wrench: Wrench::zero(),
        };
        Self {
            links: added.iter().map(|added| added.link).collect(),
            around: added.iter().map(around).collect(),
            current,
            drives,
            inertia: DMatrix::zeros(6 + n, 6 + n),
            shape_inertia: DMatrix::zeros(n, n),
            connection: Matrix6xX::zeros(n),
            accelerations: vec![Twist::zero(); added.len()],
            xi_dot: vec![T::zero(); 6 + n],
            torques: vec![T::zero(); n],
        }
    }

    /// Each link, and the momentum `M_A V_k` that its water has where the current is still; and the energy of all, J.
    pub(crate) fn momenta(&self, robot: &Moving<'_, '_, '_, T>, mu: Twist<T>) -> (Vec<(usize, Wrench<T>)>, T) {
        let mut twice = T::zero();
        let each = self.links.iter().zip(&self.around).map(|(&link, around)| {
            let twist = robot.link_twist(link, mu);
            let momentum = around.momentum(twist);
            twice += twist.dot(momentum);
            (link, momentum)
        });
        (each.collect(), twice * T::from_f64(0.5))
    }

    /// Adds what the water does to a robot at rest under impulses, for which accelerations are as velocities; those of joints on a course are
    /// in `rates`.
    pub(crate) fn add_impulses(
        &mut self,
        instant: &Instant<'_, T>,
        robot: &mut Moving<'_, '_, '_, T>,
        load: &mut Load<T>,
        rates: &[T],
    ) {
        self.xi_dot.fill(T::zero());
        if let Some(drives) = &self.drives {
            drives.put_given(rates, &mut self.xi_dot[6..]);
        }
        self.push(instant, robot, load);
    }

    /// Adds the wrenches to the load, where `xi_dot` has the accelerations of joints on a course and is 0 elsewhere.
    fn push(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        self.at_rates(instant, robot);
        self.solve(instant, robot, load);
        for (around, &link) in self.around.iter().zip(&self.links) {
            let carried = around.carried.iter().zip(&self.xi_dot);
            let wrench = carried.fold(around.wrench, |wrench, (&carried, &rate)| wrench - carried * rate);
            load.base_wrench += robot.add_link_wrench(link, wrench, &mut load.tau);
        }
    }

    /// J and the wrenches where `ξ̇ = 0`, but for joints on a course.
    fn at_rates(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>) {
        let Self { links, around, current, connection: jacobian, accelerations, xi_dot, .. } = self;
        robot.link_accelerations(instant.mu, xi_dot, links, accelerations);
        for ((around, &link), acceleration) in around.iter_mut().zip(&*links).zip(accelerations) {
            let pose = robot.link_pose(link);
            let mut twist = robot.link_twist(link, instant.mu);
            if *current != [0.0; 3] {
                let rotation = instant.pose.rotation * pose.rotation;
                let passing = rotation.transpose() * Vector3::from(current.map(T::from_f64));
                twist.linear -= passing;
                acceleration.linear += twist.angular.cross(&passing);
            }
            let momentum = around.momentum(twist);
            around.wrench = twist.ad_transpose(momentum) - around.momentum(*acceleration);
            robot.generalized_jacobian(link, jacobian);
            around.put_jacobian(&pose, jacobian);
        }
    }

    /// ξ̇ less what joints on a course accelerate, into `xi_dot`.
    fn solve(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &Load<T>) {
        let Self { around, drives, inertia, shape_inertia, connection, xi_dot, torques, .. } = self;
        robot.shape_torque(instant.mu, &xi_dot[6..], torques);
        let fall = Twist::new(Vector3::zeros(), load.gravity.into());
        let rate = robot.locked_acceleration(instant.mu, load.base_wrench) + fall;
        xi_dot[..6].copy_from_slice(&robot.body_momentum(rate).to_array());
        robot.connection(connection);
        for (j, column) in connection.column_iter().enumerate() {
            let carried = Twist::from_array(std::array::from_fn(|i| column[i])).dot(load.base_wrench);
            xi_dot[6 + j] = load.tau[j] - carried - torques[j];
        }

        robot.shape_inertia(shape_inertia);
        inertia.fill(T::zero());
        inertia.view_mut((0, 0), (6, 6)).copy_from(&robot.locked_inertia().to_matrix());
        inertia.view_mut((6, 6), shape_inertia.shape()).copy_from(shape_inertia);
        for around in around {
            around.add(inertia, xi_dot);
        }
        if let Some(drives) = drives {
            drives.hold(inertia, xi_dot);
        }
        factor(inertia);
        solve(inertia, xi_dot);
    }
}

impl<T: Real> Around<T> {
    /// `M_A V`
    fn momentum(&self, twist: Twist<T>) -> Wrench<T> {
        Wrench::from_array(self.inertia.map(|row| twist.dot(Wrench::from_array(row))))
    }

    /// J of a link at `pose` (in the base), from its generalized Jacobian.
    fn put_jacobian(&mut self, pose: &Pose<T>, generalized: &Matrix6xX<T>) {
        for i in 0..self.jacobian.len() {
            self.jacobian[i] = if i < 6 {
                pose.act_inverse(Twist::from_array(std::array::from_fn(|k| if k == i { T::one() } else { T::zero() })))
            } else {
                Twist::from_array(std::array::from_fn(|k| generalized[(k, i - 6)]))
            };
            self.carried[i] = self.momentum(self.jacobian[i]);
        }
    }

    /// Adds `Jᵀ M_A J` to the lower triangle, and `Jᵀ F`.
    fn add(&self, inertia: &mut DMatrix<T>, force: &mut [T]) {
        for (j, &column) in self.jacobian.iter().enumerate() {
            force[j] += column.dot(self.wrench);
            for (i, &carried) in self.carried.iter().enumerate().skip(j) {
                inertia[(i, j)] += column.dot(carried);
            }
        }
    }
}

impl<T: Real> Loads<T> for Water<T> {
    fn add(&mut self, instant: &Instant<'_, T>, robot: &mut Moving<'_, '_, '_, T>, load: &mut Load<T>) {
        self.xi_dot.fill(T::zero());
        if let Some(drives) = &self.drives {
            drives.put_accelerations(instant.time, &mut self.xi_dot[6..]);
        }
        self.push(instant, robot, load);
    }
}

impl<T: Real> Effect<T> for Water<T> {
    fn enter(&mut self, time: f64) {
        if let Some(drives) = &mut self.drives {
            drives.enter(time);
        }
    }
}
