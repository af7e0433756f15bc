//! Links: poses, Jacobians, twists, and what wrenches on them do.

use nalgebra::Matrix6xX;

use crate::Real;
use crate::spatial::{Pose, Twist, Wrench};
use crate::sweep::{Moving, Shape, newton_euler};

impl<T: Real> Shape<'_, '_, T> {
    /// The pose of link number `link` ([`Model::link`](crate::Model::link)) in the base frame.
    pub fn link_pose(&self, link: usize) -> Pose<T> {
        let pose = self.centroidal_pose(link);
        Pose::new(pose.rotation, pose.translation + self.com())
    }

    /// The body Jacobian `J_k` of a link relative to the base (6×n, link frame).
    ///
    /// # Panics
    /// If `out` does not have n columns.
    pub fn link_jacobian(&self, link: usize, out: &mut Matrix6xX<T>) {
        self.jacobian(link, out, |j| self.data.screw.at(j), |_| Twist::zero());
    }

    /// The generalized Jacobian `J̃_k = J_k − X_k A_l` of a link (6×n, link frame): its body twist at zero momentum is
    /// `J̃_k q̇`.
    ///
    /// # Panics
    /// If `out` does not have n columns.
    pub fn generalized_jacobian(&self, link: usize, out: &mut Matrix6xX<T>) {
        let (reaction, connection) = (&self.data.reaction, &self.data.connection);
        self.jacobian(link, out, |j| reaction.at(j), |j| -connection.at::<Twist<T>>(j));
    }

    /// What a wrench `F` (N·m, N; frame of the link, about its origin) does: returns the wrench `X_kᵀ F` on the base (base frame)
    /// and adds `J_kᵀ F` to the joint torques `tau` (length n).
    ///
    /// ```
    /// use frs_core::{Model, Workspace, spatial::Wrench};
    ///
    /// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
    /// let mut work = Workspace::new(&model);
    /// let (shape, mut tau) = (work.shape(&[0.1; 7]), [0.0; 7]);
    /// let hand = model.link("link_7").expect("the arm has it");
    /// let on_base = shape.add_link_wrench(hand, Wrench::from_array([0.0, 0.0, 1.0, 0.0, 0.0, 0.0]), &mut tau);
    /// assert!((on_base.moment.norm() - 1.0).abs() < 1e-15); // a moment is the same everywhere
    /// assert!((tau[6] - 1.0).abs() < 1e-15); // the last joint turns about this axis
    /// # Ok::<(), frs_core::urdf::UrdfError>(())
    /// ```
    ///
    /// # Panics
    /// If `tau` does not have n entries.
    pub fn add_link_wrench(&self, link: usize, wrench: Wrench<T>, tau: &mut [T]) -> Wrench<T> {
        assert_eq!(tau.len(), self.model.dof(), "tau must have one entry per coordinate");
        let wrench = self.centroidal_pose(link).act_wrench(wrench);
        let mut body = self.model.links()[link].body;
        while body > 0 {
            let joint = &self.model.bodies()[body];
            tau[joint.drive.coordinate] += self.data.screw.at::<Twist<T>>(body - 1).dot(wrench) * joint.drive.ratio;
            body = joint.parent;
        }
        wrench.at(-self.com())
    }

    /// Columns `moving(j)` for the joints that move the link and `still(j)` for the rest, in the link's frame.
    fn jacobian(
        &self,
        link: usize,
        out: &mut Matrix6xX<T>,
        moving: impl Fn(usize) -> Twist<T>,
        still: impl Fn(usize) -> Twist<T>,
    ) {
        let (pose, body) = (self.centroidal_pose(link), self.model.links()[link].body);
        self.model.gather_columns(out, |j| {
            let moves = (j + 1..self.model.bodies()[j + 1].end).contains(&body);
            pose.act_inverse(if moves { moving(j) } else { still(j) }).to_array()
        });
    }

    /// The link's pose in the centroidal frame.
    fn centroidal_pose(&self, link: usize) -> Pose<T> {
        let link = &self.model.links()[link];
        let body = Pose::new(self.data.rotation[link.body], self.data.origin[link.body]);
        body * link.placement
    }
}

impl<T: Real> Moving<'_, '_, '_, T> {
    /// The rates `V̇_k` of the body twists of links (their own frames), into `out`, where the motion changes by `ξ̇ = [μ̇; q̈]` (length 6+n):
    /// `V̇_k = X_k μ̇ + J̃_k q̈` and what the motion itself adds. One sweep for all.
    ///
    /// # Panics
    /// If `xi_dot` does not have 6+n entries, or `out` not one for each of `links`.
    pub fn link_accelerations(&mut self, mu: Twist<T>, xi_dot: &[T], links: &[usize], out: &mut [Twist<T>]) {
        assert_eq!(xi_dot.len(), 6 + self.model.dof(), "ξ̇ must have 6+n entries");
        assert_eq!(links.len(), out.len(), "out must have one entry per link");
        let (com, qdd) = (self.com(), &xi_dot[6..]);
        let (mu, mu_dot) = (mu.at(com), Twist::from_array(std::array::from_fn(|i| xi_dot[i])).at(com));
        let force = self.locked_momentum(mu_dot) + self.locked_rate() * mu - self.momentum_rate(mu);
        let (model, data) = (self.model, &mut *self.data);
        newton_euler(model, data, mu, Twist::zero(), |j| {
            let drive = model.bodies()[j + 1].drive;
            qdd[drive.coordinate] * drive.ratio
        });
        // With the base's acceleration 0 this is what the bodies would need together; the base has what the force is more.
        let needed =
            self.data.wrench[..self.model.bodies().len()].iter().fold(Wrench::zero(), |sum, wrench| sum + *wrench);
        let base = self.locked_solve(force - needed);
        for (out, &link) in out.iter_mut().zip(links) {
            let body = model.links()[link].body;
            *out = self.centroidal_pose(link).act_inverse(self.data.twist[body] + base);
        }
    }

    /// The body twist `V_k = X_k μ + J̃_k q̇` of a link (its own frame) at the locked velocity `mu` (base frame).
    pub fn link_twist(&self, link: usize, mu: Twist<T>) -> Twist<T> {
        let body = self.model.links()[link].body;
        self.centroidal_pose(link).act_inverse(self.data.velocity[body] + mu.at(self.com()))
    }
}
