//! Link poses and Jacobians.

use nalgebra::Matrix6xX;

use crate::Real;
use crate::spatial::{Pose, Twist};
use crate::sweep::Shape;

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
        self.jacobian(link, out, |j| self.data.screw[j], |_| Twist::zero());
    }

    /// The generalized Jacobian `J̃_k = J_k − X_k A_l` of a link (6×n, link frame): its body twist at zero momentum is
    /// `J̃_k q̇`.
    ///
    /// # Panics
    /// If `out` does not have n columns.
    pub fn generalized_jacobian(&self, link: usize, out: &mut Matrix6xX<T>) {
        let (reaction, connection) = (&self.data.reaction, &self.data.connection);
        self.jacobian(link, out, |j| reaction[j], |j| -connection[j]);
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
