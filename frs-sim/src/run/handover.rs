//! A payload is taken or let go: the momenta of before, and what it brings, are those of after.

use frs_core::Model;
use frs_core::spatial::{Pose, Twist, Wrench};
use nalgebra::Vector3;

use crate::effects::Water;
use crate::integrate::State;
use crate::motion::{Instant, Load, Momentum};
use crate::scene::Payload;

use super::metered::Metered;

/// What a handover changes besides the state.
pub struct Changed {
    /// Momentum about the centre of mass, world axes.
    pub momentum: Wrench<f64>,
    /// Centre of mass, world.
    pub com: Vector3<f64>,
    /// Total mass, kg.
    pub mass: f64,
}

impl<'m, M: Momentum<f64>> Metered<'m, M> {
    /// Goes on with the robot `after`, which has of `payloads` those that it has at `time`, and before had others. The energy that this
    /// gives or takes is what payloads brought, but for what the water takes, if there is some: its number among the forces, and what it is
    /// while it is still.
    pub fn hand_over<'p>(
        &mut self,
        after: &'m Model,
        payloads: impl Iterator<Item = &'p Payload>,
        mut water: Option<(usize, Water)>,
        time: f64,
        state: &mut State,
    ) -> Changed {
        self.set(state);
        let own = self.state.clone();
        let energy = self.motion.kinetic_energy(time, &own);
        let (q, qd) = self.motion.shape(time, &own);
        let (q, qd) = (q.to_vec(), qd.to_vec());
        let at_rest = vec![0.0; q.len()];

        let mut load = Load::zero(q.len());
        let mut lost = 0.0;
        self.motion.ask(time, &own, |robot, mu| {
            let (carried, stirred) =
                water.as_ref().map_or_else(Default::default, |(_, water)| water.momenta(robot, mu));
            lost = stirred;
            let came_and_went: Vec<(f64, &Payload, Twist<f64>)> = payloads
                .filter_map(|payload| {
                    let own = robot.link_twist(payload.link, mu);
                    if payload.grasp == Some(time) {
                        let rotation = state.pose.rotation * robot.link_pose(payload.link).rotation;
                        let given = payload.twist.map(|twist| {
                            let turn = rotation.transpose();
                            Twist::new(turn * twist.angular, turn * twist.linear).at(-payload.inertial.com)
                        });
                        Some((1.0, payload, given.unwrap_or(own)))
                    } else {
                        (payload.release == Some(time)).then_some((-1.0, payload, own))
                    }
                })
                .collect();
            let mut rest = robot.moving(&at_rest);
            let xi: Vec<f64> = mu.to_array().iter().chain(&qd).copied().collect();
            // At rest, accelerations and forces are as velocities and momenta.
            load.base_wrench = rest.inverse_dynamics(Twist::zero(), &xi, &mut load.tau);
            for (link, momentum) in carried {
                load.base_wrench += rest.add_link_wrench(link, momentum, &mut load.tau);
            }
            for (sign, payload, twist) in came_and_went {
                let momentum = payload.inertial.momentum(twist) * sign;
                load.base_wrench += rest.add_link_wrench(payload.link, momentum, &mut load.tau);
            }
        });

        let mut work = frs_core::Workspace::new(after);
        let mut shape = work.shape(&q);
        let (com, mass) = (shape.com(), shape.locked_inertia().mass);
        let mut rest = shape.moving(&at_rest);
        let mut rates = qd;
        if let Some(drives) = self.motion.drives() {
            drives.add_rotors(&rates, &mut load.tau);
        }
        if let Some((_, water)) = &mut water {
            let instant = Instant { time, pose: &state.pose, q: &q, qd: &at_rest, mu: Twist::zero() };
            water.add_impulses(&instant, &mut rest, &mut load, &rates);
        }
        match self.motion.drives() {
            None => rest.shape_acceleration(Twist::zero(), load.base_wrench, &load.tau, &mut rates),
            Some(drives) => drives.accelerations(&mut rest, Twist::zero(), &mut load, &mut rates),
        }
        let mu = rest.locked_acceleration(Twist::zero(), load.base_wrench);

        let turned = Pose::new(state.pose.rotation, Vector3::zeros());
        let momentum = turned.act_wrench(load.base_wrench.at(com));
        self.motion.change(after, time, momentum, mass);
        let own = self.motion.state(state.pose, &q, &rates, mu);
        let numbers = own.flat.len();
        state.flat[..numbers].copy_from_slice(&own.flat);
        let mut brought = self.motion.kinetic_energy(time, &own) - energy;
        if let Some((number, water)) = water {
            lost -= self.motion.ask(time, &own, |robot, mu| water.momenta(robot, mu).1);
            state.flat[numbers + number] += lost;
            brought -= lost;
        }
        *state.flat.last_mut().expect("what payloads brought is the last number") += brought;
        Changed { momentum, com: state.pose.transform(com), mass }
    }
}
