//! The dynamics of the robot 'planar_three_link', generated: read it, review its changes, do not edit it.
//!
//! Coordinates: joint_1, joint_2.
//! Base frame: link 'base'; six-vectors are angular part first, matrices by columns.
#![allow(
    clippy::approx_constant,
    clippy::excessive_precision,
    clippy::too_many_arguments
)]
use ::frs_core::turn;
use ::frs_core::{FloatingBase, Quantity};
use ::frs_core::generated::{array, array_mut, columns_mut, layers_mut, number_mut};
/// Number n of coordinates.
pub const DOF: usize = 2;
/// Names of the coordinates, in the order of the columns.
pub const COORDINATES: [&str; DOF] = ["joint_1", "joint_2"];
/// The robot, as one that answers quantities.
#[derive(Clone, Copy, Debug)]
pub struct PlanarThreeLink;
impl FloatingBase<f64> for PlanarThreeLink {
    fn dof(&self) -> usize {
        DOF
    }
    fn answers(&self, quantity: Quantity) -> bool {
        matches!(
            quantity, Quantity::Inertia | Quantity::DMu | Quantity::B2 |
            Quantity::Matrices | Quantity::DQdot | Quantity::CouplingTorque |
            Quantity::DMuXi | Quantity::DQdotXi | Quantity::HamelBias |
            Quantity::Curvature | Quantity::Momentum | Quantity::VelocityOfMomentum |
            Quantity::BaseTwist | Quantity::KineticEnergy | Quantity::ForwardDynamics |
            Quantity::StateRate | Quantity::InverseDynamics | Quantity::Kinematics(2)
        )
    }
    fn answer(
        &mut self,
        quantity: Quantity,
        inputs: &[&[f64]],
        outputs: &mut [&mut [f64]],
    ) {
        match (quantity, inputs, outputs) {
            (Quantity::Inertia, [q], [locked_inertia, connection, shape_inertia]) => {
                self::inertia(
                    array(q),
                    columns_mut(locked_inertia),
                    columns_mut(connection),
                    columns_mut(shape_inertia),
                )
            }
            (Quantity::DMu, [q, mu], [d_mu]) => {
                self::d_mu(array(q), array(mu), columns_mut(d_mu))
            }
            (Quantity::B2, [q, mu], [b2]) => {
                self::b2(array(q), array(mu), columns_mut(b2))
            }
            (
                Quantity::Matrices,
                [q,
                mu,
                ],
                [locked_inertia,
                connection,
                shape_inertia,
                d_mu,
                b2,
                ],
            ) => {
                self::matrices(
                    array(q),
                    array(mu),
                    columns_mut(locked_inertia),
                    columns_mut(connection),
                    columns_mut(shape_inertia),
                    columns_mut(d_mu),
                    columns_mut(b2),
                )
            }
            (Quantity::DQdot, [q, qd], [d_qdot]) => {
                self::d_qdot(array(q), array(qd), columns_mut(d_qdot))
            }
            (Quantity::CouplingTorque, [q, mu], [coupling_torque]) => {
                self::coupling_torque(array(q), array(mu), array_mut(coupling_torque))
            }
            (Quantity::DMuXi, [q, qd, mu], [d_mu_xi]) => {
                self::d_mu_xi(array(q), array(qd), array(mu), array_mut(d_mu_xi))
            }
            (Quantity::DQdotXi, [q, qd, mu], [d_qdot_xi]) => {
                self::d_qdot_xi(array(q), array(qd), array(mu), array_mut(d_qdot_xi))
            }
            (Quantity::HamelBias, [q, qd, base_twist], [hamel_bias]) => {
                self::hamel_bias(
                    array(q),
                    array(qd),
                    array(base_twist),
                    array_mut(hamel_bias),
                )
            }
            (Quantity::Curvature, [q], [curvature, com]) => {
                self::curvature(array(q), layers_mut(curvature), array_mut(com))
            }
            (Quantity::Momentum, [q, mu], [body_momentum, centroidal_momentum]) => {
                self::momentum(
                    array(q),
                    array(mu),
                    array_mut(body_momentum),
                    array_mut(centroidal_momentum),
                )
            }
            (Quantity::VelocityOfMomentum, [q, body_momentum], [mu]) => {
                self::velocity_of_momentum(array(q), array(body_momentum), array_mut(mu))
            }
            (Quantity::BaseTwist, [q, qd, mu], [base_twist]) => {
                self::base_twist(array(q), array(qd), array(mu), array_mut(base_twist))
            }
            (Quantity::KineticEnergy, [q, qd, mu], [kinetic_energy]) => {
                self::kinetic_energy(
                    array(q),
                    array(qd),
                    array(mu),
                    number_mut(kinetic_energy),
                )
            }
            (
                Quantity::ForwardDynamics,
                [q,
                qd,
                mu,
                gravity,
                base_wrench,
                tau,
                ],
                [xi_dot,
                ],
            ) => {
                self::forward_dynamics(
                    array(q),
                    array(qd),
                    array(mu),
                    array(gravity),
                    array(base_wrench),
                    array(tau),
                    array_mut(xi_dot),
                )
            }
            (
                Quantity::StateRate,
                [q,
                qd,
                mu,
                gravity,
                base_wrench,
                tau,
                ],
                [base_twist,
                xi_dot,
                ],
            ) => {
                self::state_rate(
                    array(q),
                    array(qd),
                    array(mu),
                    array(gravity),
                    array(base_wrench),
                    array(tau),
                    array_mut(base_twist),
                    array_mut(xi_dot),
                )
            }
            (
                Quantity::InverseDynamics,
                [q,
                qd,
                mu,
                gravity,
                xi_dot,
                ],
                [base_wrench,
                tau,
                ],
            ) => {
                self::inverse_dynamics(
                    array(q),
                    array(qd),
                    array(mu),
                    array(gravity),
                    array(xi_dot),
                    array_mut(base_wrench),
                    array_mut(tau),
                )
            }
            (Quantity::Kinematics(2), [q], [pose, generalized_jacobian]) => {
                self::kinematics_link_2(
                    array(q),
                    columns_mut(pose),
                    columns_mut(generalized_jacobian),
                )
            }
            _ => ::frs_core::generated::refuse(quantity, self.answers(quantity)),
        }
    }
}
/// Rotations and origins of the bodies, from the centre of mass, base axes.
struct Poses {
    sin_joint_1: f64,
    cos_joint_1: f64,
    rotation_link_2_xx: f64,
    rotation_link_2_yx: f64,
    com_x: f64,
    com_y: f64,
    minus_origin_base_x_1_0: f64,
    minus_origin_base_y_1_0: f64,
    minus_origin_base_x_1_3: f64,
    minus_origin_base_y_1_3: f64,
    minus_origin_base_x_1: f64,
    minus_origin_base_y_1: f64,
    minus_origin_base_x: f64,
    minus_origin_base_y: f64,
    origin_link_1_x: f64,
    origin_link_2_x: f64,
    origin_link_2_y: f64,
}
/// Rotations and origins of the bodies, from the centre of mass, base axes.
fn poses(q: &[f64; 2]) -> Poses {
    // link_1
    let [(sin_joint_1, cos_joint_1), (sin_joint_2, cos_joint_2)] = turn::sin_cos_each([
        q[0],
        q[1],
    ]);
    let origin_link_2_y_0 = sin_joint_1 * 0.875;
    let origin_link_2_x_0 = 0.5 + cos_joint_1 * 0.875;
    // link_2
    let rotation_link_2_xx = cos_joint_1 * cos_joint_2 - sin_joint_1 * sin_joint_2;
    let rotation_link_2_yx = sin_joint_1 * cos_joint_2 + cos_joint_1 * sin_joint_2;
    let com_y_0 = sin_joint_1 * 0.375;
    let com_x_0 = 0.5 + cos_joint_1 * 0.375;
    let com_x_1 = origin_link_2_x_0 + rotation_link_2_xx * 0.5;
    let com_y_1 = origin_link_2_y_0 + rotation_link_2_yx * 0.5;
    let com_x = (com_x_0 + com_x_1 * 0.75) * 0.26666666666666666;
    let com_y = (com_y_0 + com_y_1 * 0.75) * 0.26666666666666666;
    let minus_origin_base_x_1_0 = com_x_0 - com_x;
    let minus_origin_base_y_1_0 = com_y_0 - com_y;
    let minus_origin_base_x_1_3 = com_x_1 - com_x;
    let minus_origin_base_y_1_3 = com_y_1 - com_y;
    let minus_origin_base_x_1 = (minus_origin_base_x_1_0 - com_x * 2.0
        + minus_origin_base_x_1_3 * 0.75) * 0.26666666666666666;
    let minus_origin_base_y_1 = (minus_origin_base_y_1_0 - com_y * 2.0
        + minus_origin_base_y_1_3 * 0.75) * 0.26666666666666666;
    // base
    let minus_origin_base_x = com_x + minus_origin_base_x_1;
    let minus_origin_base_y = com_y + minus_origin_base_y_1;
    // link_1
    let origin_link_1_x = 0.5 - com_x - minus_origin_base_x_1;
    // link_2
    let origin_link_2_x = origin_link_2_x_0 - com_x - minus_origin_base_x_1;
    let origin_link_2_y = origin_link_2_y_0 - com_y - minus_origin_base_y_1;
    Poses {
        sin_joint_1,
        cos_joint_1,
        rotation_link_2_xx,
        rotation_link_2_yx,
        com_x,
        com_y,
        minus_origin_base_x_1_0,
        minus_origin_base_y_1_0,
        minus_origin_base_x_1_3,
        minus_origin_base_y_1_3,
        minus_origin_base_x_1,
        minus_origin_base_y_1,
        minus_origin_base_x,
        minus_origin_base_y,
        origin_link_1_x,
        origin_link_2_x,
        origin_link_2_y,
    }
}
/// Inertias of the bodies and of their subtrees, centroidal frame.
struct Inertias {
    minus_inertia_base_hx: f64,
    minus_inertia_base_hy: f64,
    inertia_base_xx_1: f64,
    minus_inertia_base_xy: f64,
    inertia_base_xx: f64,
    inertia_base_yy: f64,
    inertia_base_zz: f64,
    inertia_link_1_hx: f64,
    inertia_link_1_hy: f64,
    inertia_link_1_xx: f64,
    minus_inertia_link_1_xy: f64,
    inertia_link_1_yy: f64,
    inertia_link_1_zz: f64,
    inertia_link_2_hx: f64,
    inertia_link_2_hy: f64,
    inertia_link_2_xx: f64,
    minus_inertia_link_2_xy: f64,
    inertia_link_2_yy: f64,
    inertia_link_2_zz: f64,
    composite_link_1_hx: f64,
    composite_link_1_hy: f64,
    composite_link_1_xx: f64,
    minus_composite_link_1_xy: f64,
    composite_link_1_yy: f64,
    composite_link_1_zz: f64,
    composite_base_xx: f64,
    minus_composite_base_xy: f64,
    composite_base_yy: f64,
    composite_base_zz: f64,
    locked_inverse_pivot_x: f64,
    locked_inverse_pivot_y_2: f64,
    locked_inverse_pivot_y: f64,
    locked_inverse_pivot_z: f64,
    inside_joint_1_mz_1_1: f64,
    inside_joint_1_mz_1_0: f64,
    inside_joint_2_mz_1_0: f64,
    inside_joint_2_mz_1_1: f64,
}
/// Inertias of the bodies and of their subtrees, centroidal frame.
fn inertias(poses: &Poses) -> Inertias {
    // base
    let minus_inertia_base_hx = poses.minus_origin_base_x * 2.0;
    let minus_inertia_base_hy = poses.minus_origin_base_y * 2.0;
    let inertia_base_yy_1 = minus_inertia_base_hx * poses.minus_origin_base_x;
    let inertia_base_xx_1 = minus_inertia_base_hy * poses.minus_origin_base_y;
    let minus_inertia_base_xy = minus_inertia_base_hx * poses.minus_origin_base_y;
    let inertia_base_xx = 0.25 + inertia_base_xx_1;
    let inertia_base_yy = 0.375 + inertia_base_yy_1;
    let inertia_base_zz = 0.5 + (inertia_base_yy_1 + inertia_base_xx_1);
    let inertia_link_1_xx_0 = 0.0625 * poses.sin_joint_1;
    // link_1
    let inertia_link_1_hx = poses.minus_origin_base_x_1_0 - poses.minus_origin_base_x_1;
    let inertia_link_1_hy = poses.minus_origin_base_y_1_0 - poses.minus_origin_base_y_1;
    let inertia_link_1_yy_4 = inertia_link_1_hx * inertia_link_1_hx;
    let inertia_link_1_xx_3 = inertia_link_1_hy * inertia_link_1_hy;
    let inertia_link_1_xx = inertia_link_1_xx_0 * poses.sin_joint_1 + 0.125
        + inertia_link_1_xx_3;
    let minus_inertia_link_1_xy = inertia_link_1_xx_0 * poses.cos_joint_1
        + inertia_link_1_hx * inertia_link_1_hy;
    let inertia_link_1_yy = 0.0625 * poses.cos_joint_1 * poses.cos_joint_1 + 0.125
        + inertia_link_1_yy_4;
    let inertia_link_1_zz = 0.25 + (inertia_link_1_yy_4 + inertia_link_1_xx_3);
    let inertia_link_2_xx_0 = 0.03125 * poses.rotation_link_2_yx;
    let inertia_link_2_hx_0 = poses.minus_origin_base_x_1_3
        - poses.minus_origin_base_x_1;
    let inertia_link_2_hy_0 = poses.minus_origin_base_y_1_3
        - poses.minus_origin_base_y_1;
    // link_2
    let inertia_link_2_hx = inertia_link_2_hx_0 * 0.75;
    let inertia_link_2_hy = inertia_link_2_hy_0 * 0.75;
    let inertia_link_2_yy_4 = inertia_link_2_hx * inertia_link_2_hx_0;
    let inertia_link_2_xx_3 = inertia_link_2_hy * inertia_link_2_hy_0;
    let inertia_link_2_xx = inertia_link_2_xx_0 * poses.rotation_link_2_yx + 0.0625
        + inertia_link_2_xx_3;
    let minus_inertia_link_2_xy = inertia_link_2_xx_0 * poses.rotation_link_2_xx
        + inertia_link_2_hx * inertia_link_2_hy_0;
    let inertia_link_2_yy = 0.03125 * poses.rotation_link_2_xx * poses.rotation_link_2_xx
        + 0.0625 + inertia_link_2_yy_4;
    let inertia_link_2_zz = 0.125 + (inertia_link_2_yy_4 + inertia_link_2_xx_3);
    // link_1
    let composite_link_1_hx = inertia_link_1_hx + inertia_link_2_hx;
    let composite_link_1_hy = inertia_link_1_hy + inertia_link_2_hy;
    let composite_link_1_xx = inertia_link_1_xx + inertia_link_2_xx;
    let minus_composite_link_1_xy = minus_inertia_link_1_xy + minus_inertia_link_2_xy;
    let composite_link_1_yy = inertia_link_1_yy + inertia_link_2_yy;
    let composite_link_1_zz = inertia_link_1_zz + inertia_link_2_zz;
    // base
    let composite_base_xx = inertia_base_xx + composite_link_1_xx;
    let minus_composite_base_xy = minus_inertia_base_xy + minus_composite_link_1_xy;
    let composite_base_yy = inertia_base_yy + composite_link_1_yy;
    let composite_base_zz = inertia_base_zz + composite_link_1_zz;
    let locked_inverse_pivot_x = 1.0 / composite_base_xx;
    let locked_inverse_pivot_y_2 = minus_composite_base_xy * locked_inverse_pivot_x;
    let locked_inverse_pivot_y = 1.0
        / (composite_base_yy - locked_inverse_pivot_y_2 * minus_composite_base_xy);
    let locked_inverse_pivot_z = 1.0 / composite_base_zz;
    let inside_joint_1_mz_1_1 = composite_link_1_hx * poses.origin_link_1_x;
    let inside_joint_1_mz_1_0 = composite_link_1_hy * poses.minus_origin_base_y;
    let inside_joint_2_mz_1_0 = inertia_link_2_hx * poses.origin_link_2_x;
    let inside_joint_2_mz_1_1 = inertia_link_2_hy * poses.origin_link_2_y;
    Inertias {
        minus_inertia_base_hx,
        minus_inertia_base_hy,
        inertia_base_xx_1,
        minus_inertia_base_xy,
        inertia_base_xx,
        inertia_base_yy,
        inertia_base_zz,
        inertia_link_1_hx,
        inertia_link_1_hy,
        inertia_link_1_xx,
        minus_inertia_link_1_xy,
        inertia_link_1_yy,
        inertia_link_1_zz,
        inertia_link_2_hx,
        inertia_link_2_hy,
        inertia_link_2_xx,
        minus_inertia_link_2_xy,
        inertia_link_2_yy,
        inertia_link_2_zz,
        composite_link_1_hx,
        composite_link_1_hy,
        composite_link_1_xx,
        minus_composite_link_1_xy,
        composite_link_1_yy,
        composite_link_1_zz,
        composite_base_xx,
        minus_composite_base_xy,
        composite_base_yy,
        composite_base_zz,
        locked_inverse_pivot_x,
        locked_inverse_pivot_y_2,
        locked_inverse_pivot_y,
        locked_inverse_pivot_z,
        inside_joint_1_mz_1_1,
        inside_joint_1_mz_1_0,
        inside_joint_2_mz_1_0,
        inside_joint_2_mz_1_1,
    }
}
/// Inertias of what is outside each subtree, centroidal frame.
struct Complements {
    complement_link_2_hx: f64,
    complement_link_2_hy: f64,
    complement_link_2_xx: f64,
    minus_complement_link_2_xy: f64,
    complement_link_2_yy: f64,
    complement_link_2_zz: f64,
}
/// Inertias of what is outside each subtree, centroidal frame.
fn complements(inertias: &Inertias) -> Complements {
    // link_2
    let complement_link_2_hx = inertias.inertia_link_1_hx
        - inertias.minus_inertia_base_hx;
    let complement_link_2_hy = inertias.inertia_link_1_hy
        - inertias.minus_inertia_base_hy;
    let complement_link_2_xx = inertias.inertia_link_1_xx + inertias.inertia_base_xx;
    let minus_complement_link_2_xy = inertias.minus_inertia_link_1_xy
        + inertias.minus_inertia_base_xy;
    let complement_link_2_yy = inertias.inertia_link_1_yy + inertias.inertia_base_yy;
    let complement_link_2_zz = inertias.inertia_link_1_zz + inertias.inertia_base_zz;
    Complements {
        complement_link_2_hx,
        complement_link_2_hy,
        complement_link_2_xx,
        minus_complement_link_2_xy,
        complement_link_2_yy,
        complement_link_2_zz,
    }
}
/// Screw axes s_j, their momenta h_j = Iᶜ_j s_j, the connection Λ_c⁻¹ h_j.
struct Screws {
    minus_inside_joint_1_fx: f64,
    inside_joint_1_fy: f64,
    connection_joint_1_wz: f64,
    minus_connection_joint_1_vx: f64,
    connection_joint_1_vy: f64,
    inside_joint_2_mz: f64,
    inside_joint_2_fx: f64,
    inside_joint_2_fy: f64,
    connection_joint_2_wz: f64,
    connection_joint_2_vx: f64,
    connection_joint_2_vy: f64,
}
/// Screw axes s_j, their momenta h_j = Iᶜ_j s_j, the connection Λ_c⁻¹ h_j.
fn screws(poses: &Poses, inertias: &Inertias) -> Screws {
    // joint_1
    let inside_joint_1_mz = inertias.composite_link_1_zz
        + (inertias.inside_joint_1_mz_1_0 - inertias.inside_joint_1_mz_1_1);
    let minus_inside_joint_1_fx = poses.minus_origin_base_y * 1.75
        + inertias.composite_link_1_hy;
    let inside_joint_1_fy = inertias.composite_link_1_hx - poses.origin_link_1_x * 1.75;
    let connection_joint_1_wz = inside_joint_1_mz * inertias.locked_inverse_pivot_z;
    let minus_connection_joint_1_vx = minus_inside_joint_1_fx * 0.26666666666666666;
    let connection_joint_1_vy = inside_joint_1_fy * 0.26666666666666666;
    // joint_2
    let inside_joint_2_mz = inertias.inertia_link_2_zz
        - (inertias.inside_joint_2_mz_1_0 + inertias.inside_joint_2_mz_1_1);
    let inside_joint_2_fx = poses.origin_link_2_y * 0.75 - inertias.inertia_link_2_hy;
    let inside_joint_2_fy = inertias.inertia_link_2_hx - poses.origin_link_2_x * 0.75;
    let connection_joint_2_wz = inside_joint_2_mz * inertias.locked_inverse_pivot_z;
    let connection_joint_2_vx = inside_joint_2_fx * 0.26666666666666666;
    let connection_joint_2_vy = inside_joint_2_fy * 0.26666666666666666;
    Screws {
        minus_inside_joint_1_fx,
        inside_joint_1_fy,
        connection_joint_1_wz,
        minus_connection_joint_1_vx,
        connection_joint_1_vy,
        inside_joint_2_mz,
        inside_joint_2_fx,
        inside_joint_2_fy,
        connection_joint_2_wz,
        connection_joint_2_vx,
        connection_joint_2_vy,
    }
}
/// Momenta Iᵒ_j s_j of the screws outside the subtrees.
struct Outside {
    outside_joint_1_mz: f64,
    minus_outside_joint_1_fy: f64,
    outside_joint_2_mz: f64,
    outside_joint_2_fx: f64,
    outside_joint_2_fy: f64,
}
/// Momenta Iᵒ_j s_j of the screws outside the subtrees.
fn outside(poses: &Poses, inertias: &Inertias, complements: &Complements) -> Outside {
    // joint_1
    let outside_joint_1_mz = inertias.inertia_base_zz
        + (inertias.minus_inertia_base_hx * poses.origin_link_1_x
            - inertias.inertia_base_xx_1);
    let minus_outside_joint_1_fy = poses.origin_link_1_x * 2.0
        + inertias.minus_inertia_base_hx;
    // joint_2
    let outside_joint_2_mz = complements.complement_link_2_zz
        - (complements.complement_link_2_hx * poses.origin_link_2_x
            + complements.complement_link_2_hy * poses.origin_link_2_y);
    let outside_joint_2_fx = poses.origin_link_2_y * 3.0
        - complements.complement_link_2_hy;
    let outside_joint_2_fy = complements.complement_link_2_hx
        - poses.origin_link_2_x * 3.0;
    Outside {
        outside_joint_1_mz,
        minus_outside_joint_1_fy,
        outside_joint_2_mz,
        outside_joint_2_fx,
        outside_joint_2_fy,
    }
}
/// How each joint moves its own subtree at zero momentum.
struct Reactions {
    reaction_joint_1_wz: f64,
    minus_reaction_joint_1_vy: f64,
    reaction_joint_2_wz: f64,
    reaction_joint_2_vx: f64,
    reaction_joint_2_vy: f64,
}
/// How each joint moves its own subtree at zero momentum.
fn reactions(inertias: &Inertias, outside: &Outside) -> Reactions {
    // joint_1
    let reaction_joint_1_wz = outside.outside_joint_1_mz
        * inertias.locked_inverse_pivot_z;
    let minus_reaction_joint_1_vy = outside.minus_outside_joint_1_fy
        * 0.26666666666666666;
    // joint_2
    let reaction_joint_2_wz = outside.outside_joint_2_mz
        * inertias.locked_inverse_pivot_z;
    let reaction_joint_2_vx = outside.outside_joint_2_fx * 0.26666666666666666;
    let reaction_joint_2_vy = outside.outside_joint_2_fy * 0.26666666666666666;
    Reactions {
        reaction_joint_1_wz,
        minus_reaction_joint_1_vy,
        reaction_joint_2_wz,
        reaction_joint_2_vx,
        reaction_joint_2_vy,
    }
}
/// Velocities of the bodies at zero momentum.
struct Velocities {
    minus_velocity_base_wz: f64,
    velocity_base_vx: f64,
    minus_velocity_base_vy: f64,
    velocity_link_1_wz: f64,
    velocity_link_1_vx: f64,
    minus_velocity_link_1_vy: f64,
    velocity_link_2_wz: f64,
    velocity_link_2_vx: f64,
    minus_velocity_link_2_vy: f64,
}
/// Velocities of the bodies at zero momentum.
fn velocities(qd: &[f64; 2], poses: &Poses, screws: &Screws) -> Velocities {
    // base
    let minus_velocity_base_wz = screws.connection_joint_1_wz * qd[0]
        + screws.connection_joint_2_wz * qd[1];
    let velocity_base_vx = screws.minus_connection_joint_1_vx * qd[0]
        - screws.connection_joint_2_vx * qd[1];
    let minus_velocity_base_vy = screws.connection_joint_1_vy * qd[0]
        + screws.connection_joint_2_vy * qd[1];
    // link_1
    let velocity_link_1_wz = qd[0] - minus_velocity_base_wz;
    let velocity_link_1_vx = velocity_base_vx - poses.minus_origin_base_y * qd[0];
    let minus_velocity_link_1_vy = minus_velocity_base_vy
        + poses.origin_link_1_x * qd[0];
    // link_2
    let velocity_link_2_wz = velocity_link_1_wz + qd[1];
    let velocity_link_2_vx = velocity_link_1_vx + poses.origin_link_2_y * qd[1];
    let minus_velocity_link_2_vy = minus_velocity_link_1_vy
        + poses.origin_link_2_x * qd[1];
    Velocities {
        minus_velocity_base_wz,
        velocity_base_vx,
        minus_velocity_base_vy,
        velocity_link_1_wz,
        velocity_link_1_vx,
        minus_velocity_link_1_vy,
        velocity_link_2_wz,
        velocity_link_2_vx,
        minus_velocity_link_2_vy,
    }
}
/// What only `inertia` computes.
fn inertia_itself(
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    outside: &Outside,
    locked_inertia: &mut [[f64; 6]; 6],
    connection: &mut [[f64; 6]; 2],
    shape_inertia: &mut [[f64; 2]; 2],
) {
    let locked_inertia_0_0_1_0 = poses.com_y * 3.75;
    let locked_inertia_0_0_1 = locked_inertia_0_0_1_0 * poses.com_y;
    // Λ_b column 0
    locked_inertia[0][0] = inertias.composite_base_xx + locked_inertia_0_0_1 + 0.0;
    let locked_inertia_1_0_1_0 = poses.com_x + 0.25;
    let locked_inertia_1_0_1 = locked_inertia_1_0_1_0 * 3.75;
    let locked_inertia_1_0 = inertias.minus_composite_base_xy
        + locked_inertia_1_0_1 * poses.com_y;
    locked_inertia[0][1] = 0.0 - locked_inertia_1_0;
    locked_inertia[0][2] = 0.0;
    locked_inertia[0][3] = 0.0;
    locked_inertia[0][4] = 0.0;
    locked_inertia[0][5] = locked_inertia_0_0_1_0 + 0.0;
    // Λ_b column 1
    locked_inertia[1][0] = 0.0 - locked_inertia_1_0;
    let locked_inertia_1_1_1 = locked_inertia_1_0_1 * locked_inertia_1_0_1_0;
    locked_inertia[1][1] = inertias.composite_base_yy + locked_inertia_1_1_1 + 0.0;
    locked_inertia[1][2] = 0.0;
    locked_inertia[1][3] = 0.0;
    locked_inertia[1][4] = 0.0;
    locked_inertia[1][5] = 0.0 - locked_inertia_1_0_1;
    // Λ_b column 2
    locked_inertia[2][0] = 0.0;
    locked_inertia[2][1] = 0.0;
    locked_inertia[2][2] = inertias.composite_base_zz
        + (locked_inertia_1_1_1 + locked_inertia_0_0_1) + 0.0;
    locked_inertia[2][3] = 0.0 - locked_inertia_0_0_1_0;
    locked_inertia[2][4] = locked_inertia_1_0_1 + 0.0;
    locked_inertia[2][5] = 0.0;
    // Λ_b column 3
    locked_inertia[3][0] = 0.0;
    locked_inertia[3][1] = 0.0;
    locked_inertia[3][2] = 0.0 - locked_inertia_0_0_1_0;
    locked_inertia[3][3] = 3.75;
    locked_inertia[3][4] = 0.0;
    locked_inertia[3][5] = 0.0;
    // Λ_b column 4
    locked_inertia[4][0] = 0.0;
    locked_inertia[4][1] = 0.0;
    locked_inertia[4][2] = locked_inertia_1_0_1 + 0.0;
    locked_inertia[4][3] = 0.0;
    locked_inertia[4][4] = 3.75;
    locked_inertia[4][5] = 0.0;
    // Λ_b column 5
    locked_inertia[5][0] = locked_inertia_0_0_1_0 + 0.0;
    locked_inertia[5][1] = 0.0 - locked_inertia_1_0_1;
    locked_inertia[5][2] = 0.0;
    locked_inertia[5][3] = 0.0;
    locked_inertia[5][4] = 0.0;
    locked_inertia[5][5] = 3.75;
    // A_l column joint_1
    connection[0][0] = 0.0;
    connection[0][1] = 0.0;
    connection[0][2] = screws.connection_joint_1_wz + 0.0;
    connection[0][3] = screws.connection_joint_1_wz * poses.com_y
        - screws.minus_connection_joint_1_vx + 0.0;
    connection[0][4] = screws.connection_joint_1_vy
        - screws.connection_joint_1_wz * locked_inertia_1_0_1_0 + 0.0;
    connection[0][5] = 0.0;
    // A_l column joint_2
    connection[1][0] = 0.0;
    connection[1][1] = 0.0;
    connection[1][2] = screws.connection_joint_2_wz + 0.0;
    connection[1][3] = screws.connection_joint_2_vx
        + screws.connection_joint_2_wz * poses.com_y + 0.0;
    connection[1][4] = screws.connection_joint_2_vy
        - screws.connection_joint_2_wz * locked_inertia_1_0_1_0 + 0.0;
    connection[1][5] = 0.0;
    // Λ_q column joint_1
    shape_inertia[0][0] = outside.outside_joint_1_mz * screws.connection_joint_1_wz
        - outside.minus_outside_joint_1_fy * screws.connection_joint_1_vy + 0.0;
    let shape_inertia_1_0 = outside.outside_joint_1_mz * screws.connection_joint_2_wz
        - outside.minus_outside_joint_1_fy * screws.connection_joint_2_vy;
    shape_inertia[0][1] = shape_inertia_1_0 + 0.0;
    // Λ_q column joint_2
    shape_inertia[1][0] = shape_inertia_1_0 + 0.0;
    shape_inertia[1][1] = outside.outside_joint_2_mz * screws.connection_joint_2_wz
        + outside.outside_joint_2_fx * screws.connection_joint_2_vx
        + outside.outside_joint_2_fy * screws.connection_joint_2_vy + 0.0;
}
/// What only `d_mu` computes.
fn d_mu_itself(
    mu: &[f64; 6],
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    reactions: &Reactions,
    d_mu: &mut [[f64; 8]; 8],
) {
    // D_μ column 0
    d_mu[0][0] = 0.0;
    let d_mu_1_0_1 = (inertias.composite_base_xx + inertias.composite_base_yy
        + inertias.composite_base_zz) * 0.5;
    let d_mu_1_0 = mu[2] * d_mu_1_0_1 - inertias.composite_base_zz * mu[2];
    d_mu[0][1] = 0.0 - d_mu_1_0;
    let six_joint_1_my_12 = poses.com_x + 0.25;
    let six_joint_1_mx_7 = inertias.composite_base_yy * mu[1]
        - inertias.minus_composite_base_xy * mu[0];
    let d_mu_2_0_0 = mu[1] * d_mu_1_0_1 - six_joint_1_mx_7;
    let d_mu_2_0_4_0 = mu[1] * 3.75;
    let d_mu_2_0_2_0 = mu[0] * 3.75;
    let d_mu_2_0_4 = d_mu_2_0_4_0 * poses.com_y;
    let d_mu_2_0_2 = d_mu_2_0_2_0 * poses.com_y;
    d_mu[0][2] = d_mu_2_0_0 + (six_joint_1_my_12 * d_mu_2_0_2 + poses.com_y * d_mu_2_0_4)
        + 0.0;
    d_mu[0][3] = 0.0 - d_mu_2_0_4;
    d_mu[0][4] = d_mu_2_0_2 + 0.0;
    d_mu[0][5] = 0.0;
    let six_joint_1_mx_0 = inertias.minus_composite_link_1_xy
        + inertias.minus_composite_link_1_xy;
    let six_joint_1_mx_1_1 = inertias.composite_link_1_hy * poses.origin_link_1_x;
    let six_joint_1_mx_1 = six_joint_1_mx_1_1 + six_joint_1_mx_1_1;
    let six_joint_1_mx_3 = inertias.composite_link_1_xx - inertias.composite_link_1_yy
        + (inertias.inside_joint_1_mz_1_1 + inertias.inside_joint_1_mz_1_0);
    let six_joint_1_mx_9_0 = mu[5] + (mu[0] * poses.com_y - mu[1] * six_joint_1_my_12);
    let six_joint_1_mx_9 = six_joint_1_mx_9_0 * 3.75;
    let six_joint_1_fz_0 = mu[0] * 0.5;
    let six_joint_1_fz_2 = mu[1] * 0.5;
    let six_joint_1_mx_6 = six_joint_1_mx_9_0 * 0.5;
    let six_joint_1_fz = six_joint_1_fz_0 * screws.inside_joint_1_fy
        + six_joint_1_fz_2 * screws.minus_inside_joint_1_fx;
    let six_joint_1_mx = (six_joint_1_mx_0 - six_joint_1_mx_1) * six_joint_1_fz_0
        + six_joint_1_mx_3 * six_joint_1_fz_2
        + screws.inside_joint_1_fy * six_joint_1_mx_6
        + (six_joint_1_mx_7 * screws.connection_joint_1_wz
            - six_joint_1_mx_9 * screws.connection_joint_1_vy)
        + six_joint_1_fz * poses.com_y;
    d_mu[0][6] = six_joint_1_mx + 0.0;
    let six_joint_2_mx_0 = inertias.minus_inertia_link_2_xy
        + inertias.minus_inertia_link_2_xy;
    let six_joint_2_mx_1_1 = inertias.inertia_link_2_hy * poses.origin_link_2_x;
    let six_joint_2_mx_1 = six_joint_2_mx_1_1 + six_joint_2_mx_1_1;
    let six_joint_2_mx_3 = inertias.inertia_link_2_xx - inertias.inertia_link_2_yy
        - (inertias.inside_joint_2_mz_1_1 - inertias.inside_joint_2_mz_1_0);
    let six_joint_2_fz = six_joint_1_fz_0 * screws.inside_joint_2_fy
        - six_joint_1_fz_2 * screws.inside_joint_2_fx;
    let six_joint_2_mx = (six_joint_2_mx_0 - six_joint_2_mx_1) * six_joint_1_fz_0
        + six_joint_2_mx_3 * six_joint_1_fz_2
        + screws.inside_joint_2_fy * six_joint_1_mx_6
        + (six_joint_1_mx_7 * screws.connection_joint_2_wz
            - six_joint_1_mx_9 * screws.connection_joint_2_vy)
        + six_joint_2_fz * poses.com_y;
    d_mu[0][7] = six_joint_2_mx + 0.0;
    // D_μ column 1
    d_mu[1][0] = d_mu_1_0 + 0.0;
    d_mu[1][1] = 0.0;
    let six_joint_1_my_7 = inertias.composite_base_xx * mu[0]
        - inertias.minus_composite_base_xy * mu[1];
    let d_mu_2_1_0 = mu[0] * d_mu_1_0_1 - six_joint_1_my_7;
    let d_mu_2_1_4 = d_mu_2_0_4_0 * six_joint_1_my_12;
    let d_mu_2_1_2 = d_mu_2_0_2_0 * six_joint_1_my_12;
    d_mu[1][2] = 0.0
        - (d_mu_2_1_0 + (six_joint_1_my_12 * d_mu_2_1_2 + poses.com_y * d_mu_2_1_4));
    d_mu[1][3] = d_mu_2_1_4 + 0.0;
    d_mu[1][4] = 0.0 - d_mu_2_1_2;
    d_mu[1][5] = 0.0;
    let six_joint_1_my_3_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let six_joint_1_my_3 = six_joint_1_my_3_1 + six_joint_1_my_3_1;
    let six_joint_1_my = six_joint_1_mx_3 * six_joint_1_fz_0
        - (six_joint_1_mx_0 + six_joint_1_my_3) * six_joint_1_fz_2
        + screws.minus_inside_joint_1_fx * six_joint_1_mx_6
        - (six_joint_1_my_7 * screws.connection_joint_1_wz
            + six_joint_1_mx_9 * screws.minus_connection_joint_1_vx)
        - six_joint_1_fz * six_joint_1_my_12;
    d_mu[1][6] = six_joint_1_my + 0.0;
    let six_joint_2_my_2_1 = inertias.inertia_link_2_hx * poses.origin_link_2_y;
    let six_joint_2_my_2 = six_joint_2_my_2_1 + six_joint_2_my_2_1;
    let six_joint_2_my = six_joint_2_mx_3 * six_joint_1_fz_0
        + (six_joint_2_my_2 - six_joint_2_mx_0) * six_joint_1_fz_2
        - screws.inside_joint_2_fx * six_joint_1_mx_6
        + (six_joint_1_mx_9 * screws.connection_joint_2_vx
            - six_joint_1_my_7 * screws.connection_joint_2_wz)
        - six_joint_2_fz * six_joint_1_my_12;
    d_mu[1][7] = six_joint_2_my + 0.0;
    let d_mu_0_2_2 = d_mu_2_1_2 + d_mu_2_0_4;
    // D_μ column 2
    d_mu[2][0] = 0.0 - (d_mu_2_0_0 + poses.com_y * d_mu_0_2_2);
    d_mu[2][1] = d_mu_2_1_0 + six_joint_1_my_12 * d_mu_0_2_2 + 0.0;
    let d_mu_2_2_3_0 = mu[2] * 3.75;
    let d_mu_2_2_3 = d_mu_2_2_3_0 * poses.com_y;
    let d_mu_2_2_1 = d_mu_2_2_3_0 * six_joint_1_my_12;
    d_mu[2][2] = 0.0 - (poses.com_y * d_mu_2_2_1 - six_joint_1_my_12 * d_mu_2_2_3);
    d_mu[2][3] = d_mu_2_2_1 + 0.0;
    d_mu[2][4] = d_mu_2_2_3 + 0.0;
    d_mu[2][5] = 0.0 - d_mu_0_2_2;
    let minus_six_joint_1_fy_2_0 = mu[3] - mu[2] * poses.com_y;
    let six_joint_1_fx_0_0 = mu[4] + mu[2] * six_joint_1_my_12;
    let minus_six_joint_1_fy_2 = minus_six_joint_1_fy_2_0 * 3.75;
    let six_joint_1_fx_0 = six_joint_1_fx_0_0 * 3.75;
    let six_joint_1_fx_2 = mu[2] * 0.5;
    let six_joint_1_mz_10 = minus_six_joint_1_fy_2_0 * 0.5;
    let six_joint_1_mz_8 = six_joint_1_fx_0_0 * 0.5;
    let six_joint_1_fx = six_joint_1_fx_0 * screws.connection_joint_1_wz
        - six_joint_1_fx_2 * screws.inside_joint_1_fy;
    let minus_six_joint_1_fy = six_joint_1_fx_2 * screws.minus_inside_joint_1_fx
        + minus_six_joint_1_fy_2 * screws.connection_joint_1_wz;
    let six_joint_1_mz = minus_six_joint_1_fy_2 * screws.connection_joint_1_vy
        + six_joint_1_fx_0 * screws.minus_connection_joint_1_vx
        - ((six_joint_1_my_3 + six_joint_1_mx_1) * six_joint_1_fx_2
            + (screws.minus_inside_joint_1_fx * six_joint_1_mz_8
                + screws.inside_joint_1_fy * six_joint_1_mz_10))
        - (six_joint_1_fx * poses.com_y + minus_six_joint_1_fy * six_joint_1_my_12);
    d_mu[2][6] = six_joint_1_mz + 0.0;
    let six_joint_2_mz_0 = six_joint_2_my_2 - six_joint_2_mx_1;
    let six_joint_2_fx = six_joint_1_fx_0 * screws.connection_joint_2_wz
        - six_joint_1_fx_2 * screws.inside_joint_2_fy;
    let six_joint_2_fy = six_joint_1_fx_2 * screws.inside_joint_2_fx
        - minus_six_joint_1_fy_2 * screws.connection_joint_2_wz;
    let six_joint_2_mz = six_joint_2_mz_0 * six_joint_1_fx_2
        + (screws.inside_joint_2_fx * six_joint_1_mz_8
            - screws.inside_joint_2_fy * six_joint_1_mz_10)
        + (minus_six_joint_1_fy_2 * screws.connection_joint_2_vy
            - six_joint_1_fx_0 * screws.connection_joint_2_vx)
        + (six_joint_2_fy * six_joint_1_my_12 - six_joint_2_fx * poses.com_y);
    d_mu[2][7] = six_joint_2_mz + 0.0;
    // D_μ column 3
    d_mu[3][0] = d_mu_2_0_4 + 0.0;
    d_mu[3][1] = 0.0 - d_mu_2_1_4;
    d_mu[3][2] = 0.0 - d_mu_2_2_1;
    d_mu[3][3] = 0.0;
    d_mu[3][4] = 0.0 - d_mu_2_2_3_0;
    d_mu[3][5] = d_mu_2_0_4_0 + 0.0;
    d_mu[3][6] = six_joint_1_fx + 0.0;
    d_mu[3][7] = six_joint_2_fx + 0.0;
    // D_μ column 4
    d_mu[4][0] = 0.0 - d_mu_2_0_2;
    d_mu[4][1] = d_mu_2_1_2 + 0.0;
    d_mu[4][2] = 0.0 - d_mu_2_2_3;
    d_mu[4][3] = d_mu_2_2_3_0 + 0.0;
    d_mu[4][4] = 0.0;
    d_mu[4][5] = 0.0 - d_mu_2_0_2_0;
    d_mu[4][6] = 0.0 - minus_six_joint_1_fy;
    d_mu[4][7] = six_joint_2_fy + 0.0;
    // D_μ column 5
    d_mu[5][0] = 0.0;
    d_mu[5][1] = 0.0;
    d_mu[5][2] = d_mu_0_2_2 + 0.0;
    d_mu[5][3] = 0.0 - d_mu_2_0_4_0;
    d_mu[5][4] = d_mu_2_0_2_0 + 0.0;
    d_mu[5][5] = 0.0;
    d_mu[5][6] = six_joint_1_fz + 0.0;
    d_mu[5][7] = six_joint_2_fz + 0.0;
    // D_μ column joint_1
    d_mu[6][0] = 0.0 - six_joint_1_mx;
    d_mu[6][1] = 0.0 - six_joint_1_my;
    d_mu[6][2] = 0.0 - six_joint_1_mz;
    d_mu[6][3] = 0.0 - six_joint_1_fx;
    d_mu[6][4] = minus_six_joint_1_fy + 0.0;
    d_mu[6][5] = 0.0 - six_joint_1_fz;
    d_mu[6][6] = 0.0;
    let d_mu_7_6_5 = inertias.minus_inertia_base_hy * poses.origin_link_1_x;
    let six_more_joint_2_mz = six_joint_2_mz_0 * mu[2];
    let d_mu_7_6 = reactions.reaction_joint_1_wz * six_more_joint_2_mz
        - (inertias.minus_inertia_base_xy + inertias.minus_inertia_base_xy
            + (d_mu_7_6_5 + d_mu_7_6_5)) * mu[2] * screws.connection_joint_2_wz
        - reactions.minus_reaction_joint_1_vy * (mu[2] * 7.5)
            * screws.connection_joint_2_vx;
    d_mu[6][7] = d_mu_7_6 + 0.0;
    // D_μ column joint_2
    d_mu[7][0] = 0.0 - six_joint_2_mx;
    d_mu[7][1] = 0.0 - six_joint_2_my;
    d_mu[7][2] = 0.0 - six_joint_2_mz;
    d_mu[7][3] = 0.0 - six_joint_2_fx;
    d_mu[7][4] = 0.0 - six_joint_2_fy;
    d_mu[7][5] = 0.0 - six_joint_2_fz;
    d_mu[7][6] = 0.0 - d_mu_7_6;
    d_mu[7][7] = 0.0;
}
/// What only `b2` computes.
fn b2_itself(
    mu: &[f64; 6],
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    reactions: &Reactions,
    b2: &mut [[f64; 2]; 2],
) {
    // B_2(μ) column joint_1
    b2[0][0] = 0.0;
    let minus_six_joint_1_mz_3 = inertias.minus_inertia_base_hy * poses.origin_link_1_x;
    let minus_six_joint_1_mz = (inertias.minus_inertia_base_xy
        + inertias.minus_inertia_base_xy
        + (minus_six_joint_1_mz_3 + minus_six_joint_1_mz_3)) * mu[2];
    let minus_six_joint_1_fx = reactions.minus_reaction_joint_1_vy * (mu[2] * 7.5);
    let six_more_joint_2_mz_1 = inertias.inertia_link_2_hx * poses.origin_link_2_y;
    let six_more_joint_2_mz_3 = inertias.inertia_link_2_hy * poses.origin_link_2_x;
    let six_more_joint_2_mz = (six_more_joint_2_mz_1 + six_more_joint_2_mz_1
        - (six_more_joint_2_mz_3 + six_more_joint_2_mz_3)) * mu[2];
    let b2_1_0 = (reactions.reaction_joint_1_wz * six_more_joint_2_mz
        - minus_six_joint_1_mz * screws.connection_joint_2_wz
        - minus_six_joint_1_fx * screws.connection_joint_2_vx) * 0.5;
    b2[0][1] = 0.0 - b2_1_0;
    // B_2(μ) column joint_2
    b2[1][0] = b2_1_0 + 0.0;
    b2[1][1] = 0.0;
}
/// What only `base_twist` computes.
fn base_twist_itself(
    mu: &[f64; 6],
    poses: &Poses,
    velocities: &Velocities,
    base_twist: &mut [f64; 6],
) {
    // V₁
    base_twist[0] = mu[0] + 0.0;
    base_twist[1] = mu[1] + 0.0;
    base_twist[2] = mu[2] - velocities.minus_velocity_base_wz + 0.0;
    base_twist[3] = mu[3]
        + (velocities.velocity_base_vx - velocities.minus_velocity_base_wz * poses.com_y)
        + 0.0;
    base_twist[4] = mu[4]
        + (velocities.minus_velocity_base_wz * (poses.com_x + 0.25)
            - velocities.minus_velocity_base_vy) + 0.0;
    base_twist[5] = mu[5] + 0.0;
}
/// What only `forward_dynamics` computes.
fn forward_dynamics_itself(
    mu: &[f64; 6],
    qd: &[f64; 2],
    gravity: &[f64; 3],
    base_wrench: &[f64; 6],
    tau: &[f64; 2],
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    velocities: &Velocities,
    xi_dot: &mut [f64; 8],
) {
    let xi_dot_0_3_21_4_0_4 = poses.com_x + 0.25;
    let xi_dot_0_3_2 = inertias.composite_base_xx * mu[0]
        - inertias.minus_composite_base_xy * mu[1];
    let xi_dot_0_3_21_0 = inertias.composite_base_yy * mu[1]
        - inertias.minus_composite_base_xy * mu[0];
    let xi_dot_0_3_21_2 = inertias.composite_base_zz * mu[2];
    let xi_dot_0_3_21_6 = inertias.minus_composite_link_1_xy
        + inertias.minus_composite_link_1_xy;
    let xi_dot_0_3_12_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let xi_dot_0_3_21_7_1 = inertias.composite_link_1_hy * poses.origin_link_1_x;
    let xi_dot_0_3_21_7 = xi_dot_0_3_21_7_1 + xi_dot_0_3_21_7_1;
    let xi_dot_0_3_12 = xi_dot_0_3_12_1 + xi_dot_0_3_12_1;
    let xi_dot_0_3_21_9 = inertias.minus_inertia_link_2_xy
        + inertias.minus_inertia_link_2_xy;
    let xi_dot_0_3_8_1 = inertias.inertia_link_2_hx * poses.origin_link_2_y;
    let xi_dot_0_3_21_10_1 = inertias.inertia_link_2_hy * poses.origin_link_2_x;
    let xi_dot_0_3_21_10 = xi_dot_0_3_21_10_1 + xi_dot_0_3_21_10_1;
    let xi_dot_0_3_8 = xi_dot_0_3_8_1 + xi_dot_0_3_8_1;
    let xi_dot_0_3_21_4_0 = mu[5] + (mu[0] * poses.com_y - mu[1] * xi_dot_0_3_21_4_0_4);
    let xi_dot_0_3_21_4 = xi_dot_0_3_21_4_0 * 3.75;
    let xi_dot_0_3_21_13 = (inertias.composite_link_1_xx - inertias.composite_link_1_yy
        + (inertias.inside_joint_1_mz_1_1 + inertias.inside_joint_1_mz_1_0)) * qd[0]
        + (inertias.inertia_link_2_xx - inertias.inertia_link_2_yy
            - (inertias.inside_joint_2_mz_1_1 - inertias.inside_joint_2_mz_1_0)) * qd[1];
    let xi_dot_0_3_15 = velocities.velocity_base_vx * 3.75;
    let xi_dot_0_3_21_15 = velocities.minus_velocity_base_vy * 3.75;
    let wrench_base_fx_1 = mu[2] - velocities.minus_velocity_base_wz;
    let xi_dot_0_3_21 = xi_dot_0_3_21_0 * wrench_base_fx_1 - xi_dot_0_3_21_2 * mu[1]
        + xi_dot_0_3_21_4 * velocities.minus_velocity_base_vy
        - (((xi_dot_0_3_21_6 - xi_dot_0_3_21_7) * qd[0]
            + (xi_dot_0_3_21_9 - xi_dot_0_3_21_10) * qd[1]) * mu[0]
            + xi_dot_0_3_21_13 * mu[1] + xi_dot_0_3_21_15 * xi_dot_0_3_21_4_0)
        + (base_wrench[0] - base_wrench[5] * poses.com_y);
    let xi_dot_0_3 = (xi_dot_0_3_21_2 * mu[0] - xi_dot_0_3_2 * wrench_base_fx_1
        + xi_dot_0_3_21_4 * velocities.velocity_base_vx
        - (xi_dot_0_3_21_13 * mu[0]
            + ((xi_dot_0_3_8 - xi_dot_0_3_21_9) * qd[1]
                - (xi_dot_0_3_21_6 + xi_dot_0_3_12) * qd[0]) * mu[1]
            + xi_dot_0_3_15 * xi_dot_0_3_21_4_0)
        + (base_wrench[1] + base_wrench[5] * xi_dot_0_3_21_4_0_4)
        + inertias.locked_inverse_pivot_y_2 * xi_dot_0_3_21)
        * inertias.locked_inverse_pivot_y;
    let xi_dot_0 = xi_dot_0_3_21 * inertias.locked_inverse_pivot_x
        + inertias.locked_inverse_pivot_y_2 * xi_dot_0_3;
    // ξ\u{307} = [μ\u{307}; q\u{308}]
    xi_dot[0] = xi_dot_0 + 0.0;
    xi_dot[1] = xi_dot_0_3 + 0.0;
    let xi_dot_2_4_0 = mu[3] - mu[2] * poses.com_y;
    let xi_dot_2_6_0 = mu[4] + mu[2] * xi_dot_0_3_21_4_0_4;
    let xi_dot_2_4 = xi_dot_2_4_0 * 3.75;
    let xi_dot_2_6 = xi_dot_2_6_0 * 3.75;
    let wrench_base_mz_17 = base_wrench[2]
        + (base_wrench[3] * poses.com_y - base_wrench[4] * xi_dot_0_3_21_4_0_4);
    let xi_dot_2 = (xi_dot_0_3_2 * mu[1] - xi_dot_0_3_21_0 * mu[0]
        - (xi_dot_2_4 * velocities.minus_velocity_base_vy
            + xi_dot_2_6 * velocities.velocity_base_vx)
        - (((xi_dot_0_3_8 - xi_dot_0_3_21_10) * qd[1]
            - (xi_dot_0_3_12 + xi_dot_0_3_21_7) * qd[0]) * mu[2]
            - (xi_dot_0_3_15 * xi_dot_2_6_0 + xi_dot_0_3_21_15 * xi_dot_2_4_0))
        + wrench_base_mz_17) * inertias.locked_inverse_pivot_z;
    xi_dot[2] = xi_dot_2 + 0.0;
    xi_dot[3] = (xi_dot_2_6 * wrench_base_fx_1 - xi_dot_0_3_21_4 * mu[1]
        + mu[2] * xi_dot_0_3_21_15 + base_wrench[3]) * 0.26666666666666666
        + xi_dot_2 * poses.com_y + gravity[0] + 0.0;
    xi_dot[4] = (xi_dot_0_3_21_4 * mu[0] - xi_dot_2_4 * wrench_base_fx_1
        + mu[2] * xi_dot_0_3_15 + base_wrench[4]) * 0.26666666666666666
        - xi_dot_2 * xi_dot_0_3_21_4_0_4 + gravity[1] + 0.0;
    xi_dot[5] = (xi_dot_2_4 * mu[1] - xi_dot_2_6 * mu[0]
        - (mu[0] * xi_dot_0_3_21_15 + mu[1] * xi_dot_0_3_15) + base_wrench[5])
        * 0.26666666666666666
        + (xi_dot_0_3 * xi_dot_0_3_21_4_0_4 - xi_dot_0 * poses.com_y) + gravity[2] + 0.0;
    let wrench_base_fx_2 = mu[1] * inertias.minus_inertia_base_hx
        - mu[0] * inertias.minus_inertia_base_hy;
    let wrench_link_2_fx_4 = mu[0] * inertias.inertia_link_2_hy
        - mu[1] * inertias.inertia_link_2_hx;
    let wrench_link_1_fx_2 = velocities.velocity_link_1_wz + mu[2];
    let wrench_link_1_mz_6 = (wrench_link_1_fx_2 * poses.origin_link_1_x
        - velocities.minus_velocity_link_1_vy) * qd[0];
    let wrench_link_1_mz_4 = (wrench_link_1_fx_2 * poses.minus_origin_base_y
        + velocities.velocity_link_1_vx) * qd[0];
    let wrench_link_2_fx_3 = velocities.velocity_link_2_wz + mu[2];
    let wrench_link_2_mz_3 = wrench_link_1_mz_6
        + (wrench_link_2_fx_3 * poses.origin_link_2_x
            - velocities.minus_velocity_link_2_vy) * qd[1];
    let wrench_link_2_mz_1 = (wrench_link_2_fx_3 * poses.origin_link_2_y
        - velocities.velocity_link_2_vx) * qd[1] - wrench_link_1_mz_4;
    let wrench_base_mz_15 = velocities.velocity_base_vx * 2.0
        + wrench_base_fx_1 * inertias.minus_inertia_base_hy;
    let wrench_base_mz_13 = velocities.minus_velocity_base_vy * 2.0
        + wrench_base_fx_1 * inertias.minus_inertia_base_hx;
    let wrench_link_1_fx_3 = mu[0] * inertias.inertia_link_1_hy
        - mu[1] * inertias.inertia_link_1_hx;
    let wrench_link_1_mz_17 = velocities.velocity_link_1_vx
        - wrench_link_1_fx_2 * inertias.inertia_link_1_hy;
    let wrench_link_1_mz_19 = wrench_link_1_fx_2 * inertias.inertia_link_1_hx
        - velocities.minus_velocity_link_1_vy;
    let wrench_link_2_mz_14 = velocities.velocity_link_2_vx * 0.75
        - wrench_link_2_fx_3 * inertias.inertia_link_2_hy;
    let wrench_link_2_mz_16 = wrench_link_2_fx_3 * inertias.inertia_link_2_hx
        - velocities.minus_velocity_link_2_vy * 0.75;
    let wrench_link_2_mz = inertias.inertia_link_2_hx * wrench_link_2_mz_1
        - inertias.inertia_link_2_hy * wrench_link_2_mz_3
        - ((inertias.inertia_link_2_xx * mu[0]
            - inertias.minus_inertia_link_2_xy * mu[1]) * mu[1]
            - (inertias.inertia_link_2_yy * mu[1]
                - inertias.minus_inertia_link_2_xy * mu[0]) * mu[0]
            - (wrench_link_2_mz_14 * velocities.minus_velocity_link_2_vy
                + wrench_link_2_mz_16 * velocities.velocity_link_2_vx));
    let wrench_link_2_fx = wrench_link_2_mz_3 * 0.75
        - (wrench_link_2_mz_16 * wrench_link_2_fx_3 - wrench_link_2_fx_4 * mu[1]);
    let wrench_link_2_fy = wrench_link_2_mz_1 * 0.75
        - (wrench_link_2_fx_4 * mu[0] - wrench_link_2_mz_14 * wrench_link_2_fx_3);
    let inverse_pivot_joint_2_d = 1.0
        / (screws.inside_joint_2_mz + poses.origin_link_2_y * screws.inside_joint_2_fx
            - poses.origin_link_2_x * screws.inside_joint_2_fy);
    let wrench_link_1_mz_2_0 = tau[1]
        - (wrench_link_2_mz + poses.origin_link_2_y * wrench_link_2_fx
            - poses.origin_link_2_x * wrench_link_2_fy);
    let wrench_link_1_mz_2 = wrench_link_1_mz_2_0 * inverse_pivot_joint_2_d;
    let wrench_link_1_mz = wrench_link_2_mz
        + screws.inside_joint_2_mz * wrench_link_1_mz_2
        - (inertias.inertia_link_1_hx * wrench_link_1_mz_4
            + inertias.inertia_link_1_hy * wrench_link_1_mz_6
            + ((inertias.inertia_link_1_xx * mu[0]
                - inertias.minus_inertia_link_1_xy * mu[1]) * mu[1]
                - (inertias.inertia_link_1_yy * mu[1]
                    - inertias.minus_inertia_link_1_xy * mu[0]) * mu[0]
                - (wrench_link_1_mz_17 * velocities.minus_velocity_link_1_vy
                    + wrench_link_1_mz_19 * velocities.velocity_link_1_vx)));
    let wrench_link_1_fx = wrench_link_1_mz_6
        - (wrench_link_1_mz_19 * wrench_link_1_fx_2 - wrench_link_1_fx_3 * mu[1])
        + (wrench_link_2_fx + screws.inside_joint_2_fx * wrench_link_1_mz_2);
    let wrench_link_1_fy = wrench_link_2_fy
        + screws.inside_joint_2_fy * wrench_link_1_mz_2
        - (wrench_link_1_mz_4
            + (wrench_link_1_fx_3 * mu[0] - wrench_link_1_mz_17 * wrench_link_1_fx_2));
    let articulated_link_1_jzz_2 = screws.inside_joint_2_mz * inverse_pivot_joint_2_d;
    let minus_articulated_link_1_mxy_0 = screws.inside_joint_2_fx
        * inverse_pivot_joint_2_d;
    let minus_articulated_link_1_mxy = minus_articulated_link_1_mxy_0
        * screws.inside_joint_2_fy;
    let articulated_link_1_jzz = inertias.inertia_link_1_zz
        + (inertias.inertia_link_2_zz
            - articulated_link_1_jzz_2 * screws.inside_joint_2_mz);
    let minus_articulated_link_1_hzx = inertias.inertia_link_1_hy
        + (inertias.inertia_link_2_hy
            + articulated_link_1_jzz_2 * screws.inside_joint_2_fx);
    let articulated_link_1_hzy = inertias.inertia_link_1_hx
        + (inertias.inertia_link_2_hx
            - articulated_link_1_jzz_2 * screws.inside_joint_2_fy);
    let articulated_link_1_mxx = 1.0
        + (0.75 - minus_articulated_link_1_mxy_0 * screws.inside_joint_2_fx);
    let articulated_link_1_myy = 1.0
        + (0.75
            - screws.inside_joint_2_fy * inverse_pivot_joint_2_d
                * screws.inside_joint_2_fy);
    let wrench_outside_link_1_mz = articulated_link_1_jzz
        + (minus_articulated_link_1_hzx * poses.minus_origin_base_y
            - articulated_link_1_hzy * poses.origin_link_1_x);
    let wrench_outside_link_1_fx = minus_articulated_link_1_mxy * poses.origin_link_1_x
        - articulated_link_1_mxx * poses.minus_origin_base_y
        - minus_articulated_link_1_hzx;
    let wrench_outside_link_1_fy = articulated_link_1_hzy
        + (minus_articulated_link_1_mxy * poses.minus_origin_base_y
            - articulated_link_1_myy * poses.origin_link_1_x);
    let inverse_pivot_joint_1_d = 1.0
        / (wrench_outside_link_1_mz
            - poses.minus_origin_base_y * wrench_outside_link_1_fx
            - poses.origin_link_1_x * wrench_outside_link_1_fy);
    let wrench_base_mz_2_0 = tau[0]
        - (wrench_link_1_mz - poses.minus_origin_base_y * wrench_link_1_fx
            - poses.origin_link_1_x * wrench_link_1_fy);
    let wrench_base_mz_2 = wrench_base_mz_2_0 * inverse_pivot_joint_1_d;
    let wrench_base_mz = wrench_link_1_mz + wrench_outside_link_1_mz * wrench_base_mz_2
        - ((inertias.inertia_base_xx * mu[0] - inertias.minus_inertia_base_xy * mu[1])
            * mu[1]
            - (inertias.inertia_base_yy * mu[1] - inertias.minus_inertia_base_xy * mu[0])
                * mu[0]
            + (wrench_base_mz_13 * velocities.velocity_base_vx
                - wrench_base_mz_15 * velocities.minus_velocity_base_vy)
            + wrench_base_mz_17);
    let wrench_base_fx = wrench_base_mz_13 * wrench_base_fx_1 + wrench_base_fx_2 * mu[1]
        - base_wrench[3]
        + (wrench_link_1_fx + wrench_outside_link_1_fx * wrench_base_mz_2);
    let wrench_base_fy = wrench_link_1_fy + wrench_outside_link_1_fy * wrench_base_mz_2
        - (wrench_base_fx_2 * mu[0] - wrench_base_mz_15 * wrench_base_fx_1
            + base_wrench[4]);
    let articulated_base_jzz_2 = wrench_outside_link_1_mz * inverse_pivot_joint_1_d;
    let minus_articulated_base_mxy_1 = wrench_outside_link_1_fx
        * inverse_pivot_joint_1_d;
    let minus_articulated_base_mxy = minus_articulated_link_1_mxy
        + minus_articulated_base_mxy_1 * wrench_outside_link_1_fy;
    let articulated_base_jzz = inertias.inertia_base_zz
        + (articulated_link_1_jzz - articulated_base_jzz_2 * wrench_outside_link_1_mz);
    let articulated_base_hzx = inertias.minus_inertia_base_hy
        - (minus_articulated_link_1_hzx
            + articulated_base_jzz_2 * wrench_outside_link_1_fx);
    let articulated_base_hzy = articulated_link_1_hzy
        - articulated_base_jzz_2 * wrench_outside_link_1_fy
        - inertias.minus_inertia_base_hx;
    let articulated_base_mxx = 2.0
        + (articulated_link_1_mxx
            - minus_articulated_base_mxy_1 * wrench_outside_link_1_fx);
    let articulated_base_myy = 2.0
        + (articulated_link_1_myy
            - wrench_outside_link_1_fy * inverse_pivot_joint_1_d
                * wrench_outside_link_1_fy);
    let twist_base_wz_12 = 1.0 / articulated_base_mxx;
    let twist_base_wz_13 = minus_articulated_base_mxy * twist_base_wz_12;
    let minus_twist_base_vy_5 = 1.0
        / (articulated_base_myy - twist_base_wz_13 * minus_articulated_base_mxy);
    let twist_base_wz_16 = (articulated_base_hzy
        + twist_base_wz_13 * articulated_base_hzx) * minus_twist_base_vy_5;
    let twist_base_wz_6 = (wrench_base_fy + twist_base_wz_13 * wrench_base_fx)
        * minus_twist_base_vy_5;
    let twist_base_wz = (articulated_base_hzy * twist_base_wz_6
        + articulated_base_hzx
            * (wrench_base_fx * twist_base_wz_12 + twist_base_wz_13 * twist_base_wz_6)
        - wrench_base_mz)
        * (1.0
            / (articulated_base_jzz
                - (articulated_base_hzx
                    * (articulated_base_hzx * twist_base_wz_12
                        + twist_base_wz_13 * twist_base_wz_16)
                    + articulated_base_hzy * twist_base_wz_16)));
    let minus_twist_base_vy_4 = wrench_base_fx + articulated_base_hzx * twist_base_wz;
    let minus_twist_base_vy = (wrench_base_fy + articulated_base_hzy * twist_base_wz
        + twist_base_wz_13 * minus_twist_base_vy_4) * minus_twist_base_vy_5;
    let minus_twist_base_vx = minus_twist_base_vy_4 * twist_base_wz_12
        + twist_base_wz_13 * minus_twist_base_vy;
    let twist_link_1_wz_1 = (wrench_base_mz_2_0
        - (twist_base_wz * wrench_outside_link_1_mz
            - minus_twist_base_vx * wrench_outside_link_1_fx
            - minus_twist_base_vy * wrench_outside_link_1_fy)) * inverse_pivot_joint_1_d;
    xi_dot[6] = twist_link_1_wz_1 + 0.0;
    let twist_link_1_wz = twist_base_wz + twist_link_1_wz_1;
    let minus_twist_link_1_vx = minus_twist_base_vx
        + poses.minus_origin_base_y * twist_link_1_wz_1;
    let minus_twist_link_1_vy = minus_twist_base_vy
        + poses.origin_link_1_x * twist_link_1_wz_1;
    xi_dot[7] = (wrench_link_1_mz_2_0
        - (twist_link_1_wz * screws.inside_joint_2_mz
            - minus_twist_link_1_vx * screws.inside_joint_2_fx
            - minus_twist_link_1_vy * screws.inside_joint_2_fy))
        * inverse_pivot_joint_2_d + 0.0;
}
/// The block-diagonal inertia diag(Λ_b, Λ_q) and the connection A_l = Λ_b⁻¹ M_bq.
///
/// - `q`: shape (2; rad, m)
/// - `locked_inertia`: Λ_b, inertia with the joints locked, base frame (6×6, by columns; kg·m², kg·m, kg)
/// - `connection`: A_l, local mechanical connection, base frame: V₁ = −A_l q̇ at rest (6×2, by columns; rad, m)
/// - `shape_inertia`: Λ_q, inertia that the joints feel on the floating base (2×2, by columns; kg·m²)
///
/// 176 operations: 92 + −, 81 ×, 3 ÷; 2 sin cos; about 2.1 KiB of code.
pub fn inertia(
    q: &[f64; 2],
    locked_inertia: &mut [[f64; 6]; 6],
    connection: &mut [[f64; 6]; 2],
    shape_inertia: &mut [[f64; 2]; 2],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    inertia_itself(
        &poses,
        &inertias,
        &screws,
        &outside,
        locked_inertia,
        connection,
        shape_inertia,
    );
}
/// D_μ = [[−C_b^μ, −S(μ) − ad~_{Λ_bμ} A_l], [S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}, −2 B_2(μ)]].
///
/// - `q`: shape (2; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `d_mu`: D_μ, Coriolis terms linear in μ, skew, base frame (8×8, by columns; Λ's · 1/s)
///
/// 333 operations: 159 + −, 171 ×, 3 ÷; 2 sin cos; about 4.0 KiB of code.
pub fn d_mu(q: &[f64; 2], mu: &[f64; 6], d_mu: &mut [[f64; 8]; 8]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    d_mu_itself(mu, &poses, &inertias, &screws, &reactions, d_mu);
}
/// B_2(μ) = Σ_k J̃_kᵀ C(M_k; X_k μ) J̃_k.
///
/// - `q`: shape (2; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `b2`: B_2(μ), how momentum feels the curvature, skew: −½ ⟨Λ_b μ, 𝓑(e_i, e_j)⟩ (2×2, by columns; kg·m²/s)
///
/// 170 operations: 86 + −, 81 ×, 3 ÷; 2 sin cos; about 2.1 KiB of code.
pub fn b2(q: &[f64; 2], mu: &[f64; 6], b2: &mut [[f64; 2]; 2]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    b2_itself(mu, &poses, &inertias, &screws, &reactions, b2);
}
/// Λ_b, A_l, Λ_q, D_μ and B_2 at once, sharing their work.
///
/// - `q`: shape (2; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `locked_inertia`: Λ_b, inertia with the joints locked, base frame (6×6, by columns; kg·m², kg·m, kg)
/// - `connection`: A_l, local mechanical connection, base frame: V₁ = −A_l q̇ at rest (6×2, by columns; rad, m)
/// - `shape_inertia`: Λ_q, inertia that the joints feel on the floating base (2×2, by columns; kg·m²)
/// - `d_mu`: D_μ, Coriolis terms linear in μ, skew, base frame (8×8, by columns; Λ's · 1/s)
/// - `b2`: B_2(μ), how momentum feels the curvature, skew: −½ ⟨Λ_b μ, 𝓑(e_i, e_j)⟩ (2×2, by columns; kg·m²/s)
///
/// 382 operations: 181 + −, 198 ×, 3 ÷; 2 sin cos; about 4.6 KiB of code.
pub fn matrices(
    q: &[f64; 2],
    mu: &[f64; 6],
    locked_inertia: &mut [[f64; 6]; 6],
    connection: &mut [[f64; 6]; 2],
    shape_inertia: &mut [[f64; 2]; 2],
    d_mu: &mut [[f64; 8]; 8],
    b2: &mut [[f64; 2]; 2],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    inertia_itself(
        &poses,
        &inertias,
        &screws,
        &outside,
        locked_inertia,
        connection,
        shape_inertia,
    );
    d_mu_itself(mu, &poses, &inertias, &screws, &reactions, d_mu);
    b2_itself(mu, &poses, &inertias, &screws, &reactions, b2);
}
/// D_q̇ = diag(½ P(q̇), Γ'_q(q̇)): dΛ_q/dt = Γ'_q + Γ'_qᵀ, dΛ_b/dt = P(q̇).
///
/// - `q`: shape (2; rad, m)
/// - `qd`: shape velocity (2; rad/s, m/s)
/// - `d_qdot`: D_q̇, diag(½ P(q̇), Γ'_q(q̇)), base frame (8×8, by columns; Λ's · 1/s)
///
/// 344 operations: 175 + −, 166 ×, 3 ÷; 2 sin cos; about 4.1 KiB of code.
pub fn d_qdot(q: &[f64; 2], qd: &[f64; 2], d_qdot: &mut [[f64; 8]; 8]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let d_qdot_0_0_0 = inertias.minus_composite_link_1_xy
        + inertias.minus_composite_link_1_xy;
    let d_qdot_0_0_1_1 = inertias.composite_link_1_hy * poses.origin_link_1_x;
    let d_qdot_0_0_1 = d_qdot_0_0_1_1 + d_qdot_0_0_1_1;
    let d_qdot_0_0_3 = inertias.minus_inertia_link_2_xy
        + inertias.minus_inertia_link_2_xy;
    let d_qdot_0_0_4_1 = inertias.inertia_link_2_hy * poses.origin_link_2_x;
    let d_qdot_0_0_4 = d_qdot_0_0_4_1 + d_qdot_0_0_4_1;
    let d_qdot_0_0_8_0 = velocities.minus_velocity_base_vy * 3.75 * 0.5;
    let d_qdot_0_0_8 = d_qdot_0_0_8_0 * poses.com_y;
    // D_q\u{307} column 0
    d_qdot[0][0] = ((d_qdot_0_0_0 - d_qdot_0_0_1) * qd[0]
        + (d_qdot_0_0_3 - d_qdot_0_0_4) * qd[1]) * 0.5 + d_qdot_0_0_8 + d_qdot_0_0_8
        + 0.0;
    let d_qdot_1_0_2_1 = poses.com_x + 0.25;
    let d_qdot_1_0_0 = ((inertias.composite_link_1_xx - inertias.composite_link_1_yy
        + (inertias.inside_joint_1_mz_1_1 + inertias.inside_joint_1_mz_1_0)) * qd[0]
        + (inertias.inertia_link_2_xx - inertias.inertia_link_2_yy
            - (inertias.inside_joint_2_mz_1_1 - inertias.inside_joint_2_mz_1_0)) * qd[1])
        * 0.5;
    let d_qdot_1_0_1_0 = velocities.velocity_base_vx * 3.75 * 0.5;
    let d_qdot_1_0_1 = d_qdot_1_0_1_0 * poses.com_y;
    let d_qdot_1_0_2 = d_qdot_0_0_8_0 * d_qdot_1_0_2_1;
    d_qdot[0][1] = d_qdot_1_0_0 + d_qdot_1_0_1 - d_qdot_1_0_2 + 0.0;
    d_qdot[0][2] = 0.0;
    d_qdot[0][3] = 0.0;
    d_qdot[0][4] = 0.0;
    d_qdot[0][5] = d_qdot_0_0_8_0 + 0.0;
    d_qdot[0][6] = 0.0;
    d_qdot[0][7] = 0.0;
    // D_q\u{307} column 1
    d_qdot[1][0] = d_qdot_1_0_0 - d_qdot_1_0_2 + d_qdot_1_0_1 + 0.0;
    let d_qdot_1_1_4_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let d_qdot_1_1_4 = d_qdot_1_1_4_1 + d_qdot_1_1_4_1;
    let d_qdot_1_1_0_1 = inertias.inertia_link_2_hx * poses.origin_link_2_y;
    let d_qdot_1_1_0 = d_qdot_1_1_0_1 + d_qdot_1_1_0_1;
    let d_qdot_1_1_8 = d_qdot_1_0_1_0 * d_qdot_1_0_2_1;
    d_qdot[1][1] = ((d_qdot_1_1_0 - d_qdot_0_0_3) * qd[1]
        - (d_qdot_0_0_0 + d_qdot_1_1_4) * qd[0]) * 0.5 - d_qdot_1_1_8 - d_qdot_1_1_8
        + 0.0;
    d_qdot[1][2] = 0.0;
    d_qdot[1][3] = 0.0;
    d_qdot[1][4] = 0.0;
    d_qdot[1][5] = d_qdot_1_0_1_0 + 0.0;
    d_qdot[1][6] = 0.0;
    d_qdot[1][7] = 0.0;
    // D_q\u{307} column 2
    d_qdot[2][0] = 0.0;
    d_qdot[2][1] = 0.0;
    let d_qdot_2_2_8 = d_qdot_1_1_8 - d_qdot_0_0_8;
    d_qdot[2][2] = ((d_qdot_1_1_0 - d_qdot_0_0_4) * qd[1]
        - (d_qdot_1_1_4 + d_qdot_0_0_1) * qd[0]) * 0.5 - d_qdot_2_2_8 - d_qdot_2_2_8
        + 0.0;
    d_qdot[2][3] = 0.0 - d_qdot_0_0_8_0;
    d_qdot[2][4] = 0.0 - d_qdot_1_0_1_0;
    d_qdot[2][5] = 0.0;
    d_qdot[2][6] = 0.0;
    d_qdot[2][7] = 0.0;
    // D_q\u{307} column 3
    d_qdot[3][0] = 0.0;
    d_qdot[3][1] = 0.0;
    d_qdot[3][2] = 0.0 - d_qdot_0_0_8_0;
    d_qdot[3][3] = 0.0;
    d_qdot[3][4] = 0.0;
    d_qdot[3][5] = 0.0;
    d_qdot[3][6] = 0.0;
    d_qdot[3][7] = 0.0;
    // D_q\u{307} column 4
    d_qdot[4][0] = 0.0;
    d_qdot[4][1] = 0.0;
    d_qdot[4][2] = 0.0 - d_qdot_1_0_1_0;
    d_qdot[4][3] = 0.0;
    d_qdot[4][4] = 0.0;
    d_qdot[4][5] = 0.0;
    d_qdot[4][6] = 0.0;
    d_qdot[4][7] = 0.0;
    // D_q\u{307} column 5
    d_qdot[5][0] = d_qdot_0_0_8_0 + 0.0;
    d_qdot[5][1] = d_qdot_1_0_1_0 + 0.0;
    d_qdot[5][2] = 0.0;
    d_qdot[5][3] = 0.0;
    d_qdot[5][4] = 0.0;
    d_qdot[5][5] = 0.0;
    d_qdot[5][6] = 0.0;
    d_qdot[5][7] = 0.0;
    // D_q\u{307} column joint_1
    d_qdot[6][0] = 0.0;
    d_qdot[6][1] = 0.0;
    d_qdot[6][2] = 0.0;
    d_qdot[6][3] = 0.0;
    d_qdot[6][4] = 0.0;
    d_qdot[6][5] = 0.0;
    let factor_outside_link_1_zz = inertias.minus_inertia_base_hy
        * velocities.minus_velocity_base_vy
        - inertias.minus_inertia_base_hx * velocities.velocity_base_vx;
    let factor_outside_link_1_px = velocities.velocity_base_vx * 2.0
        - velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hy;
    let factor_outside_link_1_py = velocities.minus_velocity_base_wz
        * inertias.minus_inertia_base_hx - velocities.minus_velocity_base_vy * 2.0;
    let factor_link_1_zz_0 = inertias.inertia_link_1_hx * velocities.velocity_link_1_vx
        - inertias.inertia_link_1_hy * velocities.minus_velocity_link_1_vy;
    let factor_link_1_px_0 = velocities.velocity_link_1_vx
        - velocities.velocity_link_1_wz * inertias.inertia_link_1_hy;
    let factor_link_2_zz = inertias.inertia_link_2_hx * velocities.velocity_link_2_vx
        - inertias.inertia_link_2_hy * velocities.minus_velocity_link_2_vy;
    let factor_link_2_px = velocities.velocity_link_2_vx * 0.75
        - velocities.velocity_link_2_wz * inertias.inertia_link_2_hy;
    let factor_link_1_zz = factor_link_1_zz_0 + factor_link_2_zz;
    let factor_link_1_px = factor_link_1_px_0 + factor_link_2_px;
    let six_joint_1_mz_4 = velocities.velocity_link_1_wz * poses.origin_link_1_x
        - velocities.minus_velocity_link_1_vy;
    let six_joint_1_mz_2 = velocities.velocity_link_1_wz * poses.minus_origin_base_y
        + velocities.velocity_link_1_vx;
    let three_joint_1_z_0 = factor_outside_link_1_zz * screws.connection_joint_1_wz;
    let three_joint_1_z_5 = factor_link_1_zz * reactions.reaction_joint_1_wz;
    let three_joint_1_z = three_joint_1_z_0
        + (factor_outside_link_1_px * screws.connection_joint_1_vy
            + factor_outside_link_1_py * screws.minus_connection_joint_1_vx)
        - (three_joint_1_z_5 - factor_link_1_px * reactions.minus_reaction_joint_1_vy);
    let six_joint_1_mz = factor_link_1_zz
        - (inertias.composite_link_1_hx * six_joint_1_mz_2
            + inertias.composite_link_1_hy * six_joint_1_mz_4);
    let six_joint_1_fy = factor_link_1_px - six_joint_1_mz_2 * 1.75;
    d_qdot[6][6] = reactions.reaction_joint_1_wz * six_joint_1_mz
        - reactions.minus_reaction_joint_1_vy * six_joint_1_fy
        + three_joint_1_z * screws.connection_joint_1_wz + 0.0;
    let factor_link_1_py_0 = velocities.velocity_link_1_wz * inertias.inertia_link_1_hx
        - velocities.minus_velocity_link_1_vy;
    let factor_link_2_py = velocities.velocity_link_2_wz * inertias.inertia_link_2_hx
        - velocities.minus_velocity_link_2_vy * 0.75;
    let factor_link_1_py = factor_link_1_py_0 + factor_link_2_py;
    let six_more_joint_1_mz = three_joint_1_z_0 - three_joint_1_z_5
        + (inertias.minus_inertia_base_hx * six_joint_1_mz_2
            + inertias.minus_inertia_base_hy * six_joint_1_mz_4);
    let six_more_joint_1_fx = reactions.reaction_joint_1_wz * factor_link_1_py
        - screws.connection_joint_1_wz * factor_outside_link_1_py
        + six_joint_1_mz_4 * 2.0;
    let six_more_joint_1_fy = screws.connection_joint_1_wz * factor_outside_link_1_px
        - reactions.reaction_joint_1_wz * factor_link_1_px - six_joint_1_mz_2 * 2.0;
    let three_more_joint_2_z = factor_link_2_zz
        - (factor_link_2_px * poses.origin_link_2_x
            + factor_link_2_py * poses.origin_link_2_y);
    d_qdot[6][7] = six_more_joint_1_mz * screws.connection_joint_2_wz
        + six_more_joint_1_fx * screws.connection_joint_2_vx
        + six_more_joint_1_fy * screws.connection_joint_2_vy
        + reactions.reaction_joint_1_wz * three_more_joint_2_z + 0.0;
    // D_q\u{307} column joint_2
    d_qdot[7][0] = 0.0;
    d_qdot[7][1] = 0.0;
    d_qdot[7][2] = 0.0;
    d_qdot[7][3] = 0.0;
    d_qdot[7][4] = 0.0;
    d_qdot[7][5] = 0.0;
    let six_joint_2_mz_4 = velocities.velocity_link_2_wz * poses.origin_link_2_x
        - velocities.minus_velocity_link_2_vy;
    let six_joint_2_mz_2 = velocities.velocity_link_2_wz * poses.origin_link_2_y
        - velocities.velocity_link_2_vx;
    let six_joint_2_mz = factor_link_2_zz
        + (inertias.inertia_link_2_hx * six_joint_2_mz_2
            - inertias.inertia_link_2_hy * six_joint_2_mz_4);
    let six_joint_2_fy = factor_link_2_px + six_joint_2_mz_2 * 0.75;
    d_qdot[7][6] = reactions.reaction_joint_1_wz * six_joint_2_mz
        - reactions.minus_reaction_joint_1_vy * six_joint_2_fy
        + three_joint_1_z * screws.connection_joint_2_wz + 0.0;
    let factor_outside_link_2_zz = factor_link_1_zz_0 + factor_outside_link_1_zz;
    let factor_outside_link_2_px = factor_link_1_px_0 + factor_outside_link_1_px;
    let factor_outside_link_2_py = factor_link_1_py_0 + factor_outside_link_1_py;
    let three_joint_2_z = factor_outside_link_2_zz * screws.connection_joint_2_wz
        + (factor_outside_link_2_px * screws.connection_joint_2_vy
            - factor_outside_link_2_py * screws.connection_joint_2_vx)
        - (factor_link_2_zz * reactions.reaction_joint_2_wz
            + (factor_link_2_px * reactions.reaction_joint_2_vy
                - factor_link_2_py * reactions.reaction_joint_2_vx));
    let six_joint_2_fx = six_joint_2_mz_4 * 0.75 - factor_link_2_py;
    d_qdot[7][7] = reactions.reaction_joint_2_wz * six_joint_2_mz
        + reactions.reaction_joint_2_vx * six_joint_2_fx
        + reactions.reaction_joint_2_vy * six_joint_2_fy
        + three_joint_2_z * screws.connection_joint_2_wz + 0.0;
}
/// The (μ, μ) term of the shape equation.
///
/// - `q`: shape (2; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `coupling_torque`: (S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}) μ, what turning as one body asks (2; N·m, N)
///
/// 247 operations: 110 + −, 134 ×, 3 ÷; 2 sin cos; about 3.0 KiB of code.
pub fn coupling_torque(q: &[f64; 2], mu: &[f64; 6], coupling_torque: &mut [f64; 2]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    let coupling_torque_0_38 = mu[1] * inertias.minus_inertia_base_hx
        - mu[0] * inertias.minus_inertia_base_hy;
    // (S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}) μ
    coupling_torque[0] = reactions.reaction_joint_1_wz
        * ((inertias.composite_link_1_xx * mu[0]
            - inertias.minus_composite_link_1_xy * mu[1]) * mu[1]
            - (inertias.composite_link_1_yy * mu[1]
                - inertias.minus_composite_link_1_xy * mu[0]) * mu[0])
        - reactions.minus_reaction_joint_1_vy
            * ((mu[0] * inertias.composite_link_1_hy
                - mu[1] * inertias.composite_link_1_hx) * mu[0]
                + mu[2] * inertias.composite_link_1_hy * mu[2])
        - (screws.connection_joint_1_wz
            * ((inertias.inertia_base_xx * mu[0]
                - inertias.minus_inertia_base_xy * mu[1]) * mu[1]
                - (inertias.inertia_base_yy * mu[1]
                    - inertias.minus_inertia_base_xy * mu[0]) * mu[0])
            + screws.minus_connection_joint_1_vx
                * (mu[2] * inertias.minus_inertia_base_hx * mu[2]
                    + coupling_torque_0_38 * mu[1])
            + screws.connection_joint_1_vy
                * (coupling_torque_0_38 * mu[0]
                    - mu[2] * inertias.minus_inertia_base_hy * mu[2])) + 0.0;
    let coupling_torque_1_18 = mu[0] * inertias.inertia_link_2_hy
        - mu[1] * inertias.inertia_link_2_hx;
    let coupling_torque_1_41 = mu[0] * complements.complement_link_2_hy
        - mu[1] * complements.complement_link_2_hx;
    coupling_torque[1] = reactions.reaction_joint_2_wz
        * ((inertias.inertia_link_2_xx * mu[0]
            - inertias.minus_inertia_link_2_xy * mu[1]) * mu[1]
            - (inertias.inertia_link_2_yy * mu[1]
                - inertias.minus_inertia_link_2_xy * mu[0]) * mu[0])
        + reactions.reaction_joint_2_vx
            * (mu[2] * inertias.inertia_link_2_hx * mu[2] - coupling_torque_1_18 * mu[1])
        + reactions.reaction_joint_2_vy
            * (coupling_torque_1_18 * mu[0] + mu[2] * inertias.inertia_link_2_hy * mu[2])
        - (screws.connection_joint_2_wz
            * ((complements.complement_link_2_xx * mu[0]
                - complements.minus_complement_link_2_xy * mu[1]) * mu[1]
                - (complements.complement_link_2_yy * mu[1]
                    - complements.minus_complement_link_2_xy * mu[0]) * mu[0])
            + screws.connection_joint_2_vx
                * (mu[2] * complements.complement_link_2_hx * mu[2]
                    - coupling_torque_1_41 * mu[1])
            + screws.connection_joint_2_vy
                * (coupling_torque_1_41 * mu[0]
                    + mu[2] * complements.complement_link_2_hy * mu[2])) + 0.0;
}
/// D_μ ξ, without forming D_μ.
///
/// - `q`: shape (2; rad, m)
/// - `qd`: shape velocity (2; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `d_mu_xi`: D_μ ξ, D_μ on ξ = [μ; q̇], base frame (8; N·m, N)
///
/// 454 operations: 203 + −, 248 ×, 3 ÷; 2 sin cos; about 5.4 KiB of code.
pub fn d_mu_xi(q: &[f64; 2], qd: &[f64; 2], mu: &[f64; 6], d_mu_xi: &mut [f64; 8]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let d_mu_xi_0_18_2_0_2 = poses.com_x + 0.25;
    let d_mu_xi_0_0 = inertias.composite_base_yy * mu[1]
        - inertias.minus_composite_base_xy * mu[0];
    let d_mu_xi_0_2 = inertias.composite_base_zz * mu[2];
    let d_mu_xi_0_6 = inertias.minus_composite_link_1_xy
        + inertias.minus_composite_link_1_xy;
    let d_mu_xi_0_7_1 = inertias.composite_link_1_hy * poses.origin_link_1_x;
    let d_mu_xi_0_7 = d_mu_xi_0_7_1 + d_mu_xi_0_7_1;
    let d_mu_xi_0_9 = inertias.minus_inertia_link_2_xy
        + inertias.minus_inertia_link_2_xy;
    let d_mu_xi_0_10_1 = inertias.inertia_link_2_hy * poses.origin_link_2_x;
    let d_mu_xi_0_10 = d_mu_xi_0_10_1 + d_mu_xi_0_10_1;
    let d_mu_xi_0_18_0_0 = mu[3] - mu[2] * poses.com_y;
    let d_mu_xi_0_18_2_0 = mu[4] + mu[2] * d_mu_xi_0_18_2_0_2;
    let d_mu_xi_0_4_0 = mu[5] + (mu[0] * poses.com_y - mu[1] * d_mu_xi_0_18_2_0_2);
    let d_mu_xi_0_18_0 = d_mu_xi_0_18_0_0 * 3.75;
    let d_mu_xi_0_18_2 = d_mu_xi_0_18_2_0 * 3.75;
    let d_mu_xi_0_4 = d_mu_xi_0_4_0 * 3.75;
    let d_mu_xi_0_13 = (inertias.composite_link_1_xx - inertias.composite_link_1_yy
        + (inertias.inside_joint_1_mz_1_1 + inertias.inside_joint_1_mz_1_0)) * qd[0]
        + (inertias.inertia_link_2_xx - inertias.inertia_link_2_yy
            - (inertias.inside_joint_2_mz_1_1 - inertias.inside_joint_2_mz_1_0)) * qd[1];
    let d_mu_xi_0_18_7 = velocities.velocity_base_vx * 3.75;
    let d_mu_xi_0_18_5 = velocities.minus_velocity_base_vy * 3.75;
    let d_mu_xi_0_1 = mu[2] - velocities.minus_velocity_base_wz;
    let d_mu_xi_0_18 = d_mu_xi_0_18_0 * mu[1] - d_mu_xi_0_18_2 * mu[0]
        - (mu[0] * d_mu_xi_0_18_5 + mu[1] * d_mu_xi_0_18_7) * 0.5;
    // D_μ ξ
    d_mu_xi[0] = d_mu_xi_0_0 * d_mu_xi_0_1 - d_mu_xi_0_2 * mu[1]
        + d_mu_xi_0_4 * velocities.minus_velocity_base_vy
        - (((d_mu_xi_0_6 - d_mu_xi_0_7) * qd[0] + (d_mu_xi_0_9 - d_mu_xi_0_10) * qd[1])
            * mu[0] + d_mu_xi_0_13 * mu[1] + d_mu_xi_0_18_5 * d_mu_xi_0_4_0) * 0.5
        + d_mu_xi_0_18 * poses.com_y + 0.0;
    let d_mu_xi_1_2 = inertias.composite_base_xx * mu[0]
        - inertias.minus_composite_base_xy * mu[1];
    let d_mu_xi_1_12_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let d_mu_xi_1_12 = d_mu_xi_1_12_1 + d_mu_xi_1_12_1;
    let d_mu_xi_1_8_1 = inertias.inertia_link_2_hx * poses.origin_link_2_y;
    let d_mu_xi_1_8 = d_mu_xi_1_8_1 + d_mu_xi_1_8_1;
    d_mu_xi[1] = d_mu_xi_0_2 * mu[0] - d_mu_xi_1_2 * d_mu_xi_0_1
        + d_mu_xi_0_4 * velocities.velocity_base_vx
        - (d_mu_xi_0_13 * mu[0]
            + ((d_mu_xi_1_8 - d_mu_xi_0_9) * qd[1]
                - (d_mu_xi_0_6 + d_mu_xi_1_12) * qd[0]) * mu[1]
            + d_mu_xi_0_18_7 * d_mu_xi_0_4_0) * 0.5 - d_mu_xi_0_18 * d_mu_xi_0_18_2_0_2
        + 0.0;
    let d_mu_xi_2_22 = d_mu_xi_0_18_2 * d_mu_xi_0_1 - d_mu_xi_0_4 * mu[1]
        + mu[2] * d_mu_xi_0_18_5 * 0.5;
    let d_mu_xi_2_20 = d_mu_xi_0_4 * mu[0] - d_mu_xi_0_18_0 * d_mu_xi_0_1
        + mu[2] * d_mu_xi_0_18_7 * 0.5;
    d_mu_xi[2] = d_mu_xi_1_2 * mu[1] - d_mu_xi_0_0 * mu[0]
        - (d_mu_xi_0_18_0 * velocities.minus_velocity_base_vy
            + d_mu_xi_0_18_2 * velocities.velocity_base_vx)
        - (((d_mu_xi_1_8 - d_mu_xi_0_10) * qd[1] - (d_mu_xi_1_12 + d_mu_xi_0_7) * qd[0])
            * mu[2]
            - (d_mu_xi_0_18_7 * d_mu_xi_0_18_2_0 + d_mu_xi_0_18_5 * d_mu_xi_0_18_0_0))
            * 0.5 + (d_mu_xi_2_20 * d_mu_xi_0_18_2_0_2 - d_mu_xi_2_22 * poses.com_y)
        + 0.0;
    d_mu_xi[3] = d_mu_xi_2_22 + 0.0;
    d_mu_xi[4] = d_mu_xi_2_20 + 0.0;
    d_mu_xi[5] = d_mu_xi_0_18 + 0.0;
    let d_mu_xi_6_38 = mu[1] * inertias.minus_inertia_base_hx
        - mu[0] * inertias.minus_inertia_base_hy;
    let wrench_outside_link_1_mz_1 = mu[2] * velocities.minus_velocity_base_vy;
    let wrench_outside_link_1_mz_3 = mu[2] * velocities.velocity_base_vx;
    let wrench_outside_link_1_mz = inertias.minus_inertia_base_hy
        * wrench_outside_link_1_mz_1
        - inertias.minus_inertia_base_hx * wrench_outside_link_1_mz_3;
    let wrench_outside_link_1_fx = wrench_outside_link_1_mz_1 * 2.0
        - mu[2] * (velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hx);
    let wrench_outside_link_1_fy = wrench_outside_link_1_mz_3 * 2.0
        - mu[2] * (velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hy);
    let wrench_outside_link_2_fx_0 = mu[2] * velocities.minus_velocity_link_1_vy;
    let wrench_link_1_mz_0_1 = mu[2] * velocities.velocity_link_1_vx;
    let wrench_link_1_mz_0 = inertias.inertia_link_1_hx * wrench_link_1_mz_0_1
        - inertias.inertia_link_1_hy * wrench_outside_link_2_fx_0;
    let wrench_link_1_fy_0 = wrench_link_1_mz_0_1
        - mu[2] * (velocities.velocity_link_1_wz * inertias.inertia_link_1_hy);
    let wrench_link_2_mz_3 = mu[2] * velocities.minus_velocity_link_2_vy;
    let wrench_link_2_mz_1 = mu[2] * velocities.velocity_link_2_vx;
    let wrench_link_2_mz = inertias.inertia_link_2_hx * wrench_link_2_mz_1
        - inertias.inertia_link_2_hy * wrench_link_2_mz_3;
    let wrench_link_2_fy = wrench_link_2_mz_1 * 0.75
        - mu[2] * (velocities.velocity_link_2_wz * inertias.inertia_link_2_hy);
    let wrench_link_1_mz = wrench_link_1_mz_0 + wrench_link_2_mz;
    let wrench_link_1_fy = wrench_link_1_fy_0 + wrench_link_2_fy;
    let d_mu_xi_6_44 = reactions.reaction_joint_1_wz * wrench_link_1_mz
        - reactions.minus_reaction_joint_1_vy * wrench_link_1_fy
        - (screws.connection_joint_1_wz * wrench_outside_link_1_mz
            - screws.minus_connection_joint_1_vx * wrench_outside_link_1_fx
            + screws.connection_joint_1_vy * wrench_outside_link_1_fy);
    d_mu_xi[6] = reactions.reaction_joint_1_wz
        * ((inertias.composite_link_1_xx * mu[0]
            - inertias.minus_composite_link_1_xy * mu[1]) * mu[1]
            - (inertias.composite_link_1_yy * mu[1]
                - inertias.minus_composite_link_1_xy * mu[0]) * mu[0])
        - reactions.minus_reaction_joint_1_vy
            * ((mu[0] * inertias.composite_link_1_hy
                - mu[1] * inertias.composite_link_1_hx) * mu[0]
                + mu[2] * inertias.composite_link_1_hy * mu[2])
        - (screws.connection_joint_1_wz
            * ((inertias.inertia_base_xx * mu[0]
                - inertias.minus_inertia_base_xy * mu[1]) * mu[1]
                - (inertias.inertia_base_yy * mu[1]
                    - inertias.minus_inertia_base_xy * mu[0]) * mu[0])
            + screws.minus_connection_joint_1_vx
                * (mu[2] * inertias.minus_inertia_base_hx * mu[2] + d_mu_xi_6_38 * mu[1])
            + screws.connection_joint_1_vy
                * (d_mu_xi_6_38 * mu[0]
                    - mu[2] * inertias.minus_inertia_base_hy * mu[2])) - d_mu_xi_6_44
        - d_mu_xi_6_44 + 0.0;
    let d_mu_xi_7_18 = mu[0] * inertias.inertia_link_2_hy
        - mu[1] * inertias.inertia_link_2_hx;
    let d_mu_xi_7_41 = mu[0] * complements.complement_link_2_hy
        - mu[1] * complements.complement_link_2_hx;
    let wrench_link_2_fx = wrench_link_2_mz_3 * 0.75
        - mu[2] * (velocities.velocity_link_2_wz * inertias.inertia_link_2_hx);
    let wrench_outside_link_2_mz = wrench_link_1_mz_0 + wrench_outside_link_1_mz;
    let wrench_outside_link_2_fx = wrench_outside_link_2_fx_0
        - mu[2] * (velocities.velocity_link_1_wz * inertias.inertia_link_1_hx)
        + wrench_outside_link_1_fx;
    let wrench_outside_link_2_fy = wrench_link_1_fy_0 + wrench_outside_link_1_fy;
    let d_mu_xi_7_47 = reactions.reaction_joint_2_wz * wrench_link_2_mz
        + reactions.reaction_joint_2_vx * wrench_link_2_fx
        + reactions.reaction_joint_2_vy * wrench_link_2_fy
        - (screws.connection_joint_2_wz * wrench_outside_link_2_mz
            + screws.connection_joint_2_vx * wrench_outside_link_2_fx
            + screws.connection_joint_2_vy * wrench_outside_link_2_fy);
    d_mu_xi[7] = reactions.reaction_joint_2_wz
        * ((inertias.inertia_link_2_xx * mu[0]
            - inertias.minus_inertia_link_2_xy * mu[1]) * mu[1]
            - (inertias.inertia_link_2_yy * mu[1]
                - inertias.minus_inertia_link_2_xy * mu[0]) * mu[0])
        + reactions.reaction_joint_2_vx
            * (mu[2] * inertias.inertia_link_2_hx * mu[2] - d_mu_xi_7_18 * mu[1])
        + reactions.reaction_joint_2_vy
            * (d_mu_xi_7_18 * mu[0] + mu[2] * inertias.inertia_link_2_hy * mu[2])
        - (screws.connection_joint_2_wz
            * ((complements.complement_link_2_xx * mu[0]
                - complements.minus_complement_link_2_xy * mu[1]) * mu[1]
                - (complements.complement_link_2_yy * mu[1]
                    - complements.minus_complement_link_2_xy * mu[0]) * mu[0])
            + screws.connection_joint_2_vx
                * (mu[2] * complements.complement_link_2_hx * mu[2]
                    - d_mu_xi_7_41 * mu[1])
            + screws.connection_joint_2_vy
                * (d_mu_xi_7_41 * mu[0]
                    + mu[2] * complements.complement_link_2_hy * mu[2])) - d_mu_xi_7_47
        - d_mu_xi_7_47 + 0.0;
}
/// D_q̇ ξ = [½ P(q̇) μ; Γ'_q(q̇) q̇], without forming D_q̇.
///
/// - `q`: shape (2; rad, m)
/// - `qd`: shape velocity (2; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `d_qdot_xi`: D_q̇ ξ, D_q̇ on ξ, base frame (8; N·m, N)
///
/// 333 operations: 162 + −, 168 ×, 3 ÷; 2 sin cos; about 4.0 KiB of code.
pub fn d_qdot_xi(q: &[f64; 2], qd: &[f64; 2], mu: &[f64; 6], d_qdot_xi: &mut [f64; 8]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let d_qdot_xi_0_10_4 = poses.com_x + 0.25;
    let d_qdot_xi_0_0 = inertias.minus_composite_link_1_xy
        + inertias.minus_composite_link_1_xy;
    let d_qdot_xi_0_1_1 = inertias.composite_link_1_hy * poses.origin_link_1_x;
    let d_qdot_xi_0_1 = d_qdot_xi_0_1_1 + d_qdot_xi_0_1_1;
    let d_qdot_xi_0_3 = inertias.minus_inertia_link_2_xy
        + inertias.minus_inertia_link_2_xy;
    let d_qdot_xi_0_4_1 = inertias.inertia_link_2_hy * poses.origin_link_2_x;
    let d_qdot_xi_0_4 = d_qdot_xi_0_4_1 + d_qdot_xi_0_4_1;
    let d_qdot_xi_0_10 = mu[5] + (mu[0] * poses.com_y - mu[1] * d_qdot_xi_0_10_4);
    let d_qdot_xi_0_7 = (inertias.composite_link_1_xx - inertias.composite_link_1_yy
        + (inertias.inside_joint_1_mz_1_1 + inertias.inside_joint_1_mz_1_0)) * qd[0]
        + (inertias.inertia_link_2_xx - inertias.inertia_link_2_yy
            - (inertias.inside_joint_2_mz_1_1 - inertias.inside_joint_2_mz_1_0)) * qd[1];
    let d_qdot_xi_0_12_3 = velocities.velocity_base_vx * 3.75;
    let d_qdot_xi_0_12_1 = velocities.minus_velocity_base_vy * 3.75;
    let d_qdot_xi_0_12 = (mu[0] * d_qdot_xi_0_12_1 + mu[1] * d_qdot_xi_0_12_3) * 0.5;
    // D_q\u{307} ξ
    d_qdot_xi[0] = (((d_qdot_xi_0_0 - d_qdot_xi_0_1) * qd[0]
        + (d_qdot_xi_0_3 - d_qdot_xi_0_4) * qd[1]) * mu[0] + d_qdot_xi_0_7 * mu[1]
        + d_qdot_xi_0_12_1 * d_qdot_xi_0_10) * 0.5 + d_qdot_xi_0_12 * poses.com_y + 0.0;
    let d_qdot_xi_1_6_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let d_qdot_xi_1_6 = d_qdot_xi_1_6_1 + d_qdot_xi_1_6_1;
    let d_qdot_xi_1_2_1 = inertias.inertia_link_2_hx * poses.origin_link_2_y;
    let d_qdot_xi_1_2 = d_qdot_xi_1_2_1 + d_qdot_xi_1_2_1;
    d_qdot_xi[1] = (d_qdot_xi_0_7 * mu[0]
        + ((d_qdot_xi_1_2 - d_qdot_xi_0_3) * qd[1]
            - (d_qdot_xi_0_0 + d_qdot_xi_1_6) * qd[0]) * mu[1]
        + d_qdot_xi_0_12_3 * d_qdot_xi_0_10) * 0.5 - d_qdot_xi_0_12 * d_qdot_xi_0_10_4
        + 0.0;
    let d_qdot_xi_2_16 = mu[2] * d_qdot_xi_0_12_1 * 0.5;
    let d_qdot_xi_2_18 = mu[2] * d_qdot_xi_0_12_3 * 0.5;
    d_qdot_xi[2] = (((d_qdot_xi_1_2 - d_qdot_xi_0_4) * qd[1]
        - (d_qdot_xi_1_6 + d_qdot_xi_0_1) * qd[0]) * mu[2]
        - (d_qdot_xi_0_12_3 * (mu[4] + mu[2] * d_qdot_xi_0_10_4)
            + d_qdot_xi_0_12_1 * (mu[3] - mu[2] * poses.com_y))) * 0.5
        + (d_qdot_xi_2_16 * poses.com_y - d_qdot_xi_2_18 * d_qdot_xi_0_10_4) + 0.0;
    d_qdot_xi[3] = 0.0 - d_qdot_xi_2_16;
    d_qdot_xi[4] = 0.0 - d_qdot_xi_2_18;
    d_qdot_xi[5] = d_qdot_xi_0_12 + 0.0;
    let wrench_outside_link_1_mz_0 = velocities.velocity_base_vx * 2.0
        - velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hy;
    let wrench_outside_link_1_mz_2 = velocities.minus_velocity_base_wz
        * inertias.minus_inertia_base_hx - velocities.minus_velocity_base_vy * 2.0;
    let wrench_link_1_mz_0_0 = velocities.velocity_link_1_vx
        - velocities.velocity_link_1_wz * inertias.inertia_link_1_hy;
    let wrench_outside_link_2_fx_1 = velocities.velocity_link_1_wz
        * inertias.inertia_link_1_hx - velocities.minus_velocity_link_1_vy;
    let wrench_link_2_mz_4 = velocities.velocity_link_2_vx * 0.75
        - velocities.velocity_link_2_wz * inertias.inertia_link_2_hy;
    let wrench_link_2_mz_6 = velocities.velocity_link_2_wz * inertias.inertia_link_2_hx
        - velocities.minus_velocity_link_2_vy * 0.75;
    let twist_link_1_vx = (velocities.velocity_link_1_wz * poses.origin_link_1_x
        - velocities.minus_velocity_link_1_vy) * qd[0];
    let minus_twist_link_1_vy = (velocities.velocity_link_1_wz
        * poses.minus_origin_base_y + velocities.velocity_link_1_vx) * qd[0];
    let twist_link_2_vx = twist_link_1_vx
        + (velocities.velocity_link_2_wz * poses.origin_link_2_x
            - velocities.minus_velocity_link_2_vy) * qd[1];
    let twist_link_2_vy = (velocities.velocity_link_2_wz * poses.origin_link_2_y
        - velocities.velocity_link_2_vx) * qd[1] - minus_twist_link_1_vy;
    let wrench_outside_link_1_mz = wrench_outside_link_1_mz_0
        * velocities.minus_velocity_base_vy
        + wrench_outside_link_1_mz_2 * velocities.velocity_base_vx;
    let wrench_outside_link_1_fx = wrench_outside_link_1_mz_2
        * velocities.minus_velocity_base_wz;
    let minus_wrench_outside_link_1_fy = wrench_outside_link_1_mz_0
        * velocities.minus_velocity_base_wz;
    let wrench_link_1_mz_0 = wrench_link_1_mz_0_0 * velocities.minus_velocity_link_1_vy
        + wrench_outside_link_2_fx_1 * velocities.velocity_link_1_vx
        - (inertias.inertia_link_1_hx * minus_twist_link_1_vy
            + inertias.inertia_link_1_hy * twist_link_1_vx);
    let wrench_link_1_fy_0 = wrench_link_1_mz_0_0 * velocities.velocity_link_1_wz
        - minus_twist_link_1_vy;
    let wrench_link_2_mz = inertias.inertia_link_2_hx * twist_link_2_vy
        - inertias.inertia_link_2_hy * twist_link_2_vx
        + (wrench_link_2_mz_4 * velocities.minus_velocity_link_2_vy
            + wrench_link_2_mz_6 * velocities.velocity_link_2_vx);
    let wrench_link_2_fy = twist_link_2_vy * 0.75
        + wrench_link_2_mz_4 * velocities.velocity_link_2_wz;
    let wrench_link_1_mz = wrench_link_1_mz_0 + wrench_link_2_mz;
    let wrench_link_1_fy = wrench_link_1_fy_0 + wrench_link_2_fy;
    d_qdot_xi[6] = reactions.reaction_joint_1_wz * wrench_link_1_mz
        - reactions.minus_reaction_joint_1_vy * wrench_link_1_fy
        - (screws.connection_joint_1_wz * wrench_outside_link_1_mz
            - screws.minus_connection_joint_1_vx * wrench_outside_link_1_fx
            - screws.connection_joint_1_vy * minus_wrench_outside_link_1_fy) + 0.0;
    let wrench_link_2_fx = twist_link_2_vx * 0.75
        - wrench_link_2_mz_6 * velocities.velocity_link_2_wz;
    let wrench_outside_link_2_mz = wrench_link_1_mz_0 + wrench_outside_link_1_mz;
    let wrench_outside_link_2_fx = twist_link_1_vx
        - wrench_outside_link_2_fx_1 * velocities.velocity_link_1_wz
        + wrench_outside_link_1_fx;
    let wrench_outside_link_2_fy = wrench_link_1_fy_0 - minus_wrench_outside_link_1_fy;
    d_qdot_xi[7] = reactions.reaction_joint_2_wz * wrench_link_2_mz
        + reactions.reaction_joint_2_vx * wrench_link_2_fx
        + reactions.reaction_joint_2_vy * wrench_link_2_fy
        - (screws.connection_joint_2_wz * wrench_outside_link_2_mz
            + screws.connection_joint_2_vx * wrench_outside_link_2_fx
            + screws.connection_joint_2_vy * wrench_outside_link_2_fy) + 0.0;
}
/// C(q, V) V in M V̇ + C V = [F₁; τ], V = [V₁; q̇], by one Newton-Euler sweep.
///
/// - `q`: shape (2; rad, m)
/// - `qd`: shape velocity (2; rad/s, m/s)
/// - `base_twist`: body twist of the base, base frame (6; rad/s, m/s)
/// - `hamel_bias`: C V, Coriolis force on V = [V₁; q̇], base frame (8; N·m, N)
///
/// 438 operations: 214 + −, 221 ×, 3 ÷; 2 sin cos; about 5.2 KiB of code.
pub fn hamel_bias(
    q: &[f64; 2],
    qd: &[f64; 2],
    base_twist: &[f64; 6],
    hamel_bias: &mut [f64; 8],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let screws = screws(&poses, &inertias);
    let velocities = velocities(qd, &poses, &screws);
    let minus_wrench_outside_link_1_mx_5_4 = poses.com_x + 0.25;
    let minus_wrench_outside_link_1_mx_5 = base_twist[5]
        + (base_twist[0] * poses.com_y
            - base_twist[1] * minus_wrench_outside_link_1_mx_5_4);
    let minus_wrench_outside_link_1_mx_1_0 = base_twist[2]
        + velocities.minus_velocity_base_wz;
    let minus_wrench_outside_link_1_my_5_1 = base_twist[3] - base_twist[2] * poses.com_y
        - velocities.velocity_base_vx;
    let minus_wrench_outside_link_1_mx_7_0 = base_twist[4]
        + base_twist[2] * minus_wrench_outside_link_1_mx_5_4
        + velocities.minus_velocity_base_vy;
    let minus_wrench_outside_link_1_mx_1 = minus_wrench_outside_link_1_mx_1_0
        - velocities.minus_velocity_base_wz;
    let minus_wrench_outside_link_1_my_5 = velocities.velocity_base_vx
        + minus_wrench_outside_link_1_my_5_1;
    let minus_wrench_outside_link_1_mx_7 = minus_wrench_outside_link_1_mx_7_0
        - velocities.minus_velocity_base_vy;
    let wrench_outside_link_2_mx_7 = velocities.velocity_link_1_wz
        + minus_wrench_outside_link_1_mx_1_0;
    let minus_wrench_outside_link_2_my_11 = velocities.velocity_link_1_vx
        + minus_wrench_outside_link_1_my_5_1;
    let wrench_outside_link_2_mx_13 = minus_wrench_outside_link_1_mx_7_0
        - velocities.minus_velocity_link_1_vy;
    let twist_link_1_wx = base_twist[1] * qd[0];
    let minus_twist_link_1_wy = base_twist[0] * qd[0];
    let twist_link_1_vz = (base_twist[1] * poses.minus_origin_base_y
        - base_twist[0] * poses.origin_link_1_x) * qd[0];
    let wrench_link_2_mx_7 = velocities.velocity_link_2_wz
        + minus_wrench_outside_link_1_mx_1_0;
    let minus_wrench_link_2_my_11 = velocities.velocity_link_2_vx
        + minus_wrench_outside_link_1_my_5_1;
    let wrench_link_2_mx_13 = minus_wrench_outside_link_1_mx_7_0
        - velocities.minus_velocity_link_2_vy;
    let twist_link_2_wx = twist_link_1_wx + base_twist[1] * qd[1];
    let minus_twist_link_2_wy = minus_twist_link_1_wy + base_twist[0] * qd[1];
    let twist_link_2_vz = twist_link_1_vz
        - (base_twist[0] * poses.origin_link_2_x + base_twist[1] * poses.origin_link_2_y)
            * qd[1];
    let minus_wrench_outside_link_1_mx_0 = inertias.inertia_base_yy * base_twist[1]
        - inertias.minus_inertia_base_xy * base_twist[0]
        + inertias.minus_inertia_base_hx * minus_wrench_outside_link_1_mx_5;
    let minus_wrench_outside_link_1_mx_2 = inertias.inertia_base_zz
        * minus_wrench_outside_link_1_mx_1
        + (inertias.minus_inertia_base_hy * minus_wrench_outside_link_1_my_5
            - inertias.minus_inertia_base_hx * minus_wrench_outside_link_1_mx_7);
    let minus_wrench_outside_link_1_fz_0 = minus_wrench_outside_link_1_my_5 * 2.0
        + minus_wrench_outside_link_1_mx_1 * inertias.minus_inertia_base_hy;
    let minus_wrench_outside_link_1_mx_4 = minus_wrench_outside_link_1_mx_7 * 2.0
        - minus_wrench_outside_link_1_mx_1 * inertias.minus_inertia_base_hx;
    let minus_wrench_outside_link_1_mx_6 = minus_wrench_outside_link_1_mx_5 * 2.0
        + (base_twist[1] * inertias.minus_inertia_base_hx
            - base_twist[0] * inertias.minus_inertia_base_hy);
    let minus_wrench_outside_link_1_mx = minus_wrench_outside_link_1_mx_0
        * minus_wrench_outside_link_1_mx_1
        - minus_wrench_outside_link_1_mx_2 * base_twist[1]
        + (minus_wrench_outside_link_1_mx_4 * minus_wrench_outside_link_1_mx_5
            - minus_wrench_outside_link_1_mx_6 * minus_wrench_outside_link_1_mx_7);
    let minus_wrench_outside_link_1_fz = minus_wrench_outside_link_1_fz_0 * base_twist[1]
        - minus_wrench_outside_link_1_mx_4 * base_twist[0];
    let wrench_outside_link_2_mx_6 = inertias.inertia_link_1_yy * base_twist[1]
        - inertias.minus_inertia_link_1_xy * base_twist[0]
        - inertias.inertia_link_1_hx * minus_wrench_outside_link_1_mx_5;
    let wrench_outside_link_2_mx_8 = inertias.inertia_link_1_zz
        * wrench_outside_link_2_mx_7
        + (inertias.inertia_link_1_hx * wrench_outside_link_2_mx_13
            - inertias.inertia_link_1_hy * minus_wrench_outside_link_2_my_11);
    let wrench_outside_link_2_fz_5 = minus_wrench_outside_link_2_my_11
        - wrench_outside_link_2_mx_7 * inertias.inertia_link_1_hy;
    let wrench_outside_link_2_mx_10 = wrench_outside_link_2_mx_13
        + wrench_outside_link_2_mx_7 * inertias.inertia_link_1_hx;
    let wrench_outside_link_2_mx_12 = minus_wrench_outside_link_1_mx_5
        + (base_twist[0] * inertias.inertia_link_1_hy
            - base_twist[1] * inertias.inertia_link_1_hx);
    let wrench_outside_link_2_mx = inertias.inertia_link_1_xx * twist_link_1_wx
        + inertias.minus_inertia_link_1_xy * minus_twist_link_1_wy
        + inertias.inertia_link_1_hy * twist_link_1_vz
        - (wrench_outside_link_2_mx_6 * wrench_outside_link_2_mx_7
            - wrench_outside_link_2_mx_8 * base_twist[1]
            + (wrench_outside_link_2_mx_10 * minus_wrench_outside_link_1_mx_5
                - wrench_outside_link_2_mx_12 * wrench_outside_link_2_mx_13));
    let wrench_outside_link_2_fz = twist_link_1_vz
        + (twist_link_1_wx * inertias.inertia_link_1_hy
            + minus_twist_link_1_wy * inertias.inertia_link_1_hx)
        - (wrench_outside_link_2_fz_5 * base_twist[1]
            - wrench_outside_link_2_mx_10 * base_twist[0]);
    let wrench_link_2_mx_6 = inertias.inertia_link_2_yy * base_twist[1]
        - inertias.minus_inertia_link_2_xy * base_twist[0]
        - inertias.inertia_link_2_hx * minus_wrench_outside_link_1_mx_5;
    let wrench_link_2_mx_8 = inertias.inertia_link_2_zz * wrench_link_2_mx_7
        + (inertias.inertia_link_2_hx * wrench_link_2_mx_13
            - inertias.inertia_link_2_hy * minus_wrench_link_2_my_11);
    let wrench_link_2_fz_6 = minus_wrench_link_2_my_11 * 0.75
        - wrench_link_2_mx_7 * inertias.inertia_link_2_hy;
    let wrench_link_2_mx_10 = wrench_link_2_mx_13 * 0.75
        + wrench_link_2_mx_7 * inertias.inertia_link_2_hx;
    let wrench_link_2_mx_12 = minus_wrench_outside_link_1_mx_5 * 0.75
        + (base_twist[0] * inertias.inertia_link_2_hy
            - base_twist[1] * inertias.inertia_link_2_hx);
    let wrench_link_2_mx = inertias.inertia_link_2_xx * twist_link_2_wx
        + inertias.minus_inertia_link_2_xy * minus_twist_link_2_wy
        + inertias.inertia_link_2_hy * twist_link_2_vz
        - (wrench_link_2_mx_6 * wrench_link_2_mx_7 - wrench_link_2_mx_8 * base_twist[1]
            + (wrench_link_2_mx_10 * minus_wrench_outside_link_1_mx_5
                - wrench_link_2_mx_12 * wrench_link_2_mx_13));
    let wrench_link_2_fz = twist_link_2_vz * 0.75
        + (twist_link_2_wx * inertias.inertia_link_2_hy
            + minus_twist_link_2_wy * inertias.inertia_link_2_hx)
        - (wrench_link_2_fz_6 * base_twist[1] - wrench_link_2_mx_10 * base_twist[0]);
    let wrench_link_1_mx = wrench_outside_link_2_mx + wrench_link_2_mx;
    let wrench_link_1_fz = wrench_outside_link_2_fz + wrench_link_2_fz;
    let wrench_base_mx = wrench_link_1_mx - minus_wrench_outside_link_1_mx;
    let wrench_base_fz = wrench_link_1_fz - minus_wrench_outside_link_1_fz;
    // C V
    hamel_bias[0] = wrench_base_mx + wrench_base_fz * poses.com_y + 0.0;
    let minus_wrench_outside_link_1_my_2 = inertias.inertia_base_xx * base_twist[0]
        - inertias.minus_inertia_base_xy * base_twist[1]
        - inertias.minus_inertia_base_hy * minus_wrench_outside_link_1_mx_5;
    let minus_wrench_outside_link_1_my = minus_wrench_outside_link_1_mx_2 * base_twist[0]
        - minus_wrench_outside_link_1_my_2 * minus_wrench_outside_link_1_mx_1
        + (minus_wrench_outside_link_1_mx_6 * minus_wrench_outside_link_1_my_5
            - minus_wrench_outside_link_1_fz_0 * minus_wrench_outside_link_1_mx_5);
    let minus_wrench_outside_link_2_my_8 = inertias.inertia_link_1_xx * base_twist[0]
        - inertias.minus_inertia_link_1_xy * base_twist[1]
        + inertias.inertia_link_1_hy * minus_wrench_outside_link_1_mx_5;
    let minus_wrench_outside_link_2_my = inertias.minus_inertia_link_1_xy
        * twist_link_1_wx + inertias.inertia_link_1_yy * minus_twist_link_1_wy
        + inertias.inertia_link_1_hx * twist_link_1_vz
        + (wrench_outside_link_2_mx_8 * base_twist[0]
            - minus_wrench_outside_link_2_my_8 * wrench_outside_link_2_mx_7
            + (wrench_outside_link_2_mx_12 * minus_wrench_outside_link_2_my_11
                - wrench_outside_link_2_fz_5 * minus_wrench_outside_link_1_mx_5));
    let minus_wrench_link_2_my_8 = inertias.inertia_link_2_xx * base_twist[0]
        - inertias.minus_inertia_link_2_xy * base_twist[1]
        + inertias.inertia_link_2_hy * minus_wrench_outside_link_1_mx_5;
    let minus_wrench_link_2_my = inertias.minus_inertia_link_2_xy * twist_link_2_wx
        + inertias.inertia_link_2_yy * minus_twist_link_2_wy
        + inertias.inertia_link_2_hx * twist_link_2_vz
        + (wrench_link_2_mx_8 * base_twist[0]
            - minus_wrench_link_2_my_8 * wrench_link_2_mx_7
            + (wrench_link_2_mx_12 * minus_wrench_link_2_my_11
                - wrench_link_2_fz_6 * minus_wrench_outside_link_1_mx_5));
    let minus_wrench_link_1_my = minus_wrench_outside_link_2_my + minus_wrench_link_2_my;
    let minus_wrench_base_my = minus_wrench_outside_link_1_my + minus_wrench_link_1_my;
    hamel_bias[1] = 0.0
        - (minus_wrench_base_my + wrench_base_fz * minus_wrench_outside_link_1_mx_5_4);
    let twist_link_1_vx = (wrench_outside_link_2_mx_7 * poses.origin_link_1_x
        + wrench_outside_link_2_mx_13) * qd[0];
    let minus_twist_link_1_vy = (wrench_outside_link_2_mx_7 * poses.minus_origin_base_y
        + minus_wrench_outside_link_2_my_11) * qd[0];
    let twist_link_2_vx = twist_link_1_vx
        + (wrench_link_2_mx_7 * poses.origin_link_2_x + wrench_link_2_mx_13) * qd[1];
    let twist_link_2_vy = (wrench_link_2_mx_7 * poses.origin_link_2_y
        - minus_wrench_link_2_my_11) * qd[1] - minus_twist_link_1_vy;
    let minus_wrench_outside_link_1_mz = minus_wrench_outside_link_1_my_2 * base_twist[1]
        - minus_wrench_outside_link_1_mx_0 * base_twist[0]
        + (minus_wrench_outside_link_1_fz_0 * minus_wrench_outside_link_1_mx_7
            - minus_wrench_outside_link_1_mx_4 * minus_wrench_outside_link_1_my_5);
    let minus_wrench_outside_link_1_fx = minus_wrench_outside_link_1_mx_4
        * minus_wrench_outside_link_1_mx_1
        - minus_wrench_outside_link_1_mx_6 * base_twist[1];
    let minus_wrench_outside_link_1_fy = minus_wrench_outside_link_1_mx_6 * base_twist[0]
        - minus_wrench_outside_link_1_fz_0 * minus_wrench_outside_link_1_mx_1;
    let minus_wrench_outside_link_2_mz = inertias.inertia_link_1_hx
        * minus_twist_link_1_vy + inertias.inertia_link_1_hy * twist_link_1_vx
        + (minus_wrench_outside_link_2_my_8 * base_twist[1]
            - wrench_outside_link_2_mx_6 * base_twist[0]
            + (wrench_outside_link_2_fz_5 * wrench_outside_link_2_mx_13
                - wrench_outside_link_2_mx_10 * minus_wrench_outside_link_2_my_11));
    let wrench_outside_link_2_fx = twist_link_1_vx
        - (wrench_outside_link_2_mx_10 * wrench_outside_link_2_mx_7
            - wrench_outside_link_2_mx_12 * base_twist[1]);
    let minus_wrench_outside_link_2_fy = minus_twist_link_1_vy
        + (wrench_outside_link_2_mx_12 * base_twist[0]
            - wrench_outside_link_2_fz_5 * wrench_outside_link_2_mx_7);
    let wrench_link_2_mz = inertias.inertia_link_2_hx * twist_link_2_vy
        - inertias.inertia_link_2_hy * twist_link_2_vx
        - (minus_wrench_link_2_my_8 * base_twist[1] - wrench_link_2_mx_6 * base_twist[0]
            + (wrench_link_2_fz_6 * wrench_link_2_mx_13
                - wrench_link_2_mx_10 * minus_wrench_link_2_my_11));
    let wrench_link_2_fx = twist_link_2_vx * 0.75
        - (wrench_link_2_mx_10 * wrench_link_2_mx_7
            - wrench_link_2_mx_12 * base_twist[1]);
    let wrench_link_2_fy = twist_link_2_vy * 0.75
        - (wrench_link_2_mx_12 * base_twist[0]
            - wrench_link_2_fz_6 * wrench_link_2_mx_7);
    let wrench_link_1_mz = wrench_link_2_mz - minus_wrench_outside_link_2_mz;
    let wrench_link_1_fx = wrench_outside_link_2_fx + wrench_link_2_fx;
    let wrench_link_1_fy = wrench_link_2_fy - minus_wrench_outside_link_2_fy;
    let wrench_base_mz = wrench_link_1_mz - minus_wrench_outside_link_1_mz;
    let wrench_base_fx = wrench_link_1_fx - minus_wrench_outside_link_1_fx;
    let wrench_base_fy = wrench_link_1_fy - minus_wrench_outside_link_1_fy;
    hamel_bias[2] = wrench_base_mz
        + (wrench_base_fy * minus_wrench_outside_link_1_mx_5_4
            - wrench_base_fx * poses.com_y) + 0.0;
    hamel_bias[3] = wrench_base_fx + 0.0;
    hamel_bias[4] = wrench_base_fy + 0.0;
    hamel_bias[5] = wrench_base_fz + 0.0;
    hamel_bias[6] = wrench_link_1_mz - poses.minus_origin_base_y * wrench_link_1_fx
        - poses.origin_link_1_x * wrench_link_1_fy + 0.0;
    hamel_bias[7] = wrench_link_2_mz + poses.origin_link_2_y * wrench_link_2_fx
        - poses.origin_link_2_x * wrench_link_2_fy + 0.0;
}
/// 𝓑(e_i, e_j) = ∂_i A_j − ∂_j A_i − ad_{A_i} A_j for all pairs of coordinates.
///
/// - `q`: shape (2; rad, m)
/// - `curvature`: 𝓑_ω(e_i, e_j), angular part of the curvature, base axes: x, y, z (3 of 2×2, by columns; rad)
/// - `com`: c, total centre of mass, base frame; 𝓑_v = c × 𝓑_ω (3; m)
///
/// 170 operations: 87 + −, 80 ×, 3 ÷; 2 sin cos; about 2.1 KiB of code.
pub fn curvature(q: &[f64; 2], curvature: &mut [[[f64; 2]; 2]; 3], com: &mut [f64; 3]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    // 𝓑_ω(e_i, e_j) x, column joint_1
    curvature[0][0][0] = 0.0;
    curvature[0][0][1] = 0.0;
    // 𝓑_ω(e_i, e_j) x, column joint_2
    curvature[0][1][0] = 0.0;
    curvature[0][1][1] = 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_1
    curvature[1][0][0] = 0.0;
    curvature[1][0][1] = 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_2
    curvature[1][1][0] = 0.0;
    curvature[1][1][1] = 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_1
    curvature[2][0][0] = 0.0;
    let minus_six_joint_1_mz_3 = inertias.minus_inertia_base_hy * poses.origin_link_1_x;
    let six_more_joint_2_mz_1 = inertias.inertia_link_2_hx * poses.origin_link_2_y;
    let six_more_joint_2_mz_3 = inertias.inertia_link_2_hy * poses.origin_link_2_x;
    let minus_six_joint_1_mz = (inertias.minus_inertia_base_xy
        + inertias.minus_inertia_base_xy
        + (minus_six_joint_1_mz_3 + minus_six_joint_1_mz_3))
        * inertias.locked_inverse_pivot_z;
    let minus_six_joint_1_fx = reactions.minus_reaction_joint_1_vy
        * (inertias.locked_inverse_pivot_z * 7.5);
    let six_more_joint_2_mz = (six_more_joint_2_mz_1 + six_more_joint_2_mz_1
        - (six_more_joint_2_mz_3 + six_more_joint_2_mz_3))
        * inertias.locked_inverse_pivot_z;
    let curvature_z_1_0 = reactions.reaction_joint_1_wz * six_more_joint_2_mz
        - minus_six_joint_1_mz * screws.connection_joint_2_wz
        - minus_six_joint_1_fx * screws.connection_joint_2_vx;
    curvature[2][0][1] = curvature_z_1_0 + 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_2
    curvature[2][1][0] = 0.0 - curvature_z_1_0;
    curvature[2][1][1] = 0.0;
    // c
    com[0] = poses.com_x + 0.25 + 0.0;
    com[1] = poses.com_y + 0.0;
    com[2] = 0.0;
}
/// The momentum Λ_b μ, in the base frame and about the centre of mass.
///
/// - `q`: shape (2; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `body_momentum`: Λ_b μ, momentum, base frame (6; kg·m²/s, kg·m/s)
/// - `centroidal_momentum`: Λ_c μ, momentum about c, base axes (6; kg·m²/s, kg·m/s)
///
/// 136 operations: 68 + −, 65 ×, 3 ÷; 2 sin cos; about 1.7 KiB of code.
pub fn momentum(
    q: &[f64; 2],
    mu: &[f64; 6],
    body_momentum: &mut [f64; 6],
    centroidal_momentum: &mut [f64; 6],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let body_momentum_0_1_4 = poses.com_x + 0.25;
    let body_momentum_0_0 = inertias.composite_base_xx * mu[0]
        - inertias.minus_composite_base_xy * mu[1];
    let body_momentum_0_1 = (mu[5] + (mu[0] * poses.com_y - mu[1] * body_momentum_0_1_4))
        * 3.75;
    // Λ_b μ
    body_momentum[0] = body_momentum_0_0 + body_momentum_0_1 * poses.com_y + 0.0;
    let body_momentum_1_0 = inertias.composite_base_yy * mu[1]
        - inertias.minus_composite_base_xy * mu[0];
    body_momentum[1] = body_momentum_1_0 - body_momentum_0_1 * body_momentum_0_1_4 + 0.0;
    let body_momentum_2_0 = inertias.composite_base_zz * mu[2];
    let body_momentum_2_3 = (mu[3] - mu[2] * poses.com_y) * 3.75;
    let body_momentum_2_1 = (mu[4] + mu[2] * body_momentum_0_1_4) * 3.75;
    body_momentum[2] = body_momentum_2_0
        + (body_momentum_2_1 * body_momentum_0_1_4 - body_momentum_2_3 * poses.com_y)
        + 0.0;
    body_momentum[3] = body_momentum_2_3 + 0.0;
    body_momentum[4] = body_momentum_2_1 + 0.0;
    body_momentum[5] = body_momentum_0_1 + 0.0;
    // Λ_c μ
    centroidal_momentum[0] = body_momentum_0_0 + 0.0;
    centroidal_momentum[1] = body_momentum_1_0 + 0.0;
    centroidal_momentum[2] = body_momentum_2_0 + 0.0;
    centroidal_momentum[3] = body_momentum_2_3 + 0.0;
    centroidal_momentum[4] = body_momentum_2_1 + 0.0;
    centroidal_momentum[5] = body_momentum_0_1 + 0.0;
}
/// μ = Λ_b⁻¹ p: in free flight, where the momentum is known, μ need not be integrated.
///
/// - `q`: shape (2; rad, m)
/// - `body_momentum`: momentum, base frame (6; kg·m²/s, kg·m/s)
/// - `mu`: μ, locked velocity, base frame (6; rad/s, m/s)
///
/// 136 operations: 68 + −, 65 ×, 3 ÷; 2 sin cos; about 1.7 KiB of code.
pub fn velocity_of_momentum(q: &[f64; 2], body_momentum: &[f64; 6], mu: &mut [f64; 6]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let mu_0_3_2 = poses.com_x + 0.25;
    let mu_0_3_4 = body_momentum[0] - body_momentum[5] * poses.com_y;
    let mu_0_3 = (body_momentum[1] + body_momentum[5] * mu_0_3_2
        + inertias.locked_inverse_pivot_y_2 * mu_0_3_4)
        * inertias.locked_inverse_pivot_y;
    let mu_0 = mu_0_3_4 * inertias.locked_inverse_pivot_x
        + inertias.locked_inverse_pivot_y_2 * mu_0_3;
    // μ
    mu[0] = mu_0 + 0.0;
    mu[1] = mu_0_3 + 0.0;
    let mu_2 = (body_momentum[2]
        + (body_momentum[3] * poses.com_y - body_momentum[4] * mu_0_3_2))
        * inertias.locked_inverse_pivot_z;
    mu[2] = mu_2 + 0.0;
    mu[3] = body_momentum[3] * 0.26666666666666666 + mu_2 * poses.com_y + 0.0;
    mu[4] = body_momentum[4] * 0.26666666666666666 - mu_2 * mu_0_3_2 + 0.0;
    mu[5] = body_momentum[5] * 0.26666666666666666
        + (mu_0_3 * mu_0_3_2 - mu_0 * poses.com_y) + 0.0;
}
/// V₁ = μ − A_l q̇, which reconstructs the pose of the base: ġ₁ = g₁ V₁^.
///
/// - `q`: shape (2; rad, m)
/// - `qd`: shape velocity (2; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `base_twist`: V₁, body twist of the base, base frame (6; rad/s, m/s)
///
/// 154 operations: 80 + −, 71 ×, 3 ÷; 2 sin cos; about 1.9 KiB of code.
pub fn base_twist(
    q: &[f64; 2],
    qd: &[f64; 2],
    mu: &[f64; 6],
    base_twist: &mut [f64; 6],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let screws = screws(&poses, &inertias);
    let velocities = velocities(qd, &poses, &screws);
    base_twist_itself(mu, &poses, &velocities, base_twist);
}
/// ½ μᵀ Λ_b μ + ½ q̇ᵀ Λ_q q̇.
///
/// - `q`: shape (2; rad, m)
/// - `qd`: shape velocity (2; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `kinetic_energy`: ½ ξᵀ Λ ξ, kinetic energy (1; J)
///
/// 226 operations: 107 + −, 116 ×, 3 ÷; 2 sin cos; about 2.7 KiB of code.
pub fn kinetic_energy(
    q: &[f64; 2],
    qd: &[f64; 2],
    mu: &[f64; 6],
    kinetic_energy: &mut f64,
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let screws = screws(&poses, &inertias);
    let velocities = velocities(qd, &poses, &screws);
    let kinetic_energy_0_17_2 = poses.com_x + 0.25;
    let kinetic_energy_0_14 = mu[3] - mu[2] * poses.com_y;
    let kinetic_energy_0_17 = mu[4] + mu[2] * kinetic_energy_0_17_2;
    let kinetic_energy_0_20 = mu[5]
        + (mu[0] * poses.com_y - mu[1] * kinetic_energy_0_17_2);
    // ½ ξᵀ Λ ξ
    *kinetic_energy = (mu[0]
        * (inertias.composite_base_xx * mu[0] - inertias.minus_composite_base_xy * mu[1])
        + mu[1]
            * (inertias.composite_base_yy * mu[1]
                - inertias.minus_composite_base_xy * mu[0])
        + mu[2] * (inertias.composite_base_zz * mu[2])
        + kinetic_energy_0_14 * (kinetic_energy_0_14 * 3.75)
        + kinetic_energy_0_17 * (kinetic_energy_0_17 * 3.75)
        + kinetic_energy_0_20 * (kinetic_energy_0_20 * 3.75)
        + (velocities.velocity_base_vx
            * (velocities.velocity_base_vx * 2.0
                - velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hy)
            - velocities.minus_velocity_base_wz
                * (velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hx
                    + velocities.velocity_base_vx * inertias.minus_inertia_base_hy
                    - inertias.inertia_base_zz * velocities.minus_velocity_base_wz)
            - velocities.minus_velocity_base_vy
                * (velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hx
                    - velocities.minus_velocity_base_vy * 2.0))
        + (velocities.velocity_link_1_wz
            * (inertias.inertia_link_1_zz * velocities.velocity_link_1_wz
                - (velocities.minus_velocity_link_1_vy * inertias.inertia_link_1_hx
                    + velocities.velocity_link_1_vx * inertias.inertia_link_1_hy))
            + velocities.velocity_link_1_vx
                * (velocities.velocity_link_1_vx
                    - velocities.velocity_link_1_wz * inertias.inertia_link_1_hy)
            - velocities.minus_velocity_link_1_vy
                * (velocities.velocity_link_1_wz * inertias.inertia_link_1_hx
                    - velocities.minus_velocity_link_1_vy))
        + (velocities.velocity_link_2_wz
            * (inertias.inertia_link_2_zz * velocities.velocity_link_2_wz
                - (velocities.minus_velocity_link_2_vy * inertias.inertia_link_2_hx
                    + velocities.velocity_link_2_vx * inertias.inertia_link_2_hy))
            + velocities.velocity_link_2_vx
                * (velocities.velocity_link_2_vx * 0.75
                    - velocities.velocity_link_2_wz * inertias.inertia_link_2_hy)
            - velocities.minus_velocity_link_2_vy
                * (velocities.velocity_link_2_wz * inertias.inertia_link_2_hx
                    - velocities.minus_velocity_link_2_vy * 0.75))) * 0.5 + 0.0;
}
/// ξ̇ = Λ⁻¹ (D_μ ξ − D_q̇ ξ + [F₁; τ − A_lᵀ F₁]) + [0; γ; 0], in O(n); factoring Λ_q where joints mimic.
///
/// - `q`: shape (2; rad, m)
/// - `qd`: shape velocity (2; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `gravity`: acceleration of free fall, base axes (3; m/s²)
/// - `base_wrench`: wrench on the base, base frame (6; N·m, N)
/// - `tau`: joint torques (2; N·m, N)
/// - `xi_dot`: ξ̇ = [μ̇; q̈], acceleration, base frame (8; rad/s², m/s²)
///
/// 551 operations: 266 + −, 277 ×, 8 ÷; 2 sin cos; about 6.5 KiB of code.
pub fn forward_dynamics(
    q: &[f64; 2],
    qd: &[f64; 2],
    mu: &[f64; 6],
    gravity: &[f64; 3],
    base_wrench: &[f64; 6],
    tau: &[f64; 2],
    xi_dot: &mut [f64; 8],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let screws = screws(&poses, &inertias);
    let velocities = velocities(qd, &poses, &screws);
    forward_dynamics_itself(
        mu,
        qd,
        gravity,
        base_wrench,
        tau,
        &poses,
        &inertias,
        &screws,
        &velocities,
        xi_dot,
    );
}
/// V₁ = μ − A_l q̇ and ξ̇ at once: the rates of the pose, ġ₁ = g₁ V₁^, and of ξ.
///
/// - `q`: shape (2; rad, m)
/// - `qd`: shape velocity (2; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `gravity`: acceleration of free fall, base axes (3; m/s²)
/// - `base_wrench`: wrench on the base, base frame (6; N·m, N)
/// - `tau`: joint torques (2; N·m, N)
/// - `base_twist`: V₁, body twist of the base, base frame (6; rad/s, m/s)
/// - `xi_dot`: ξ̇ = [μ̇; q̈], acceleration, base frame (8; rad/s², m/s²)
///
/// 559 operations: 272 + −, 279 ×, 8 ÷; 2 sin cos; about 6.6 KiB of code.
pub fn state_rate(
    q: &[f64; 2],
    qd: &[f64; 2],
    mu: &[f64; 6],
    gravity: &[f64; 3],
    base_wrench: &[f64; 6],
    tau: &[f64; 2],
    base_twist: &mut [f64; 6],
    xi_dot: &mut [f64; 8],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let screws = screws(&poses, &inertias);
    let velocities = velocities(qd, &poses, &screws);
    base_twist_itself(mu, &poses, &velocities, base_twist);
    forward_dynamics_itself(
        mu,
        qd,
        gravity,
        base_wrench,
        tau,
        &poses,
        &inertias,
        &screws,
        &velocities,
        xi_dot,
    );
}
/// [F₁; τ − A_lᵀ F₁] = Λ (ξ̇ − [0; γ; 0]) + D_q̇ ξ − D_μ ξ, in O(n).
///
/// - `q`: shape (2; rad, m)
/// - `qd`: shape velocity (2; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `gravity`: acceleration of free fall, base axes (3; m/s²)
/// - `xi_dot`: acceleration, base frame (8; rad/s², m/s²)
/// - `base_wrench`: F₁, wrench on the base, base frame (6; N·m, N)
/// - `tau`: τ, joint torques (2; N·m, N)
///
/// 509 operations: 249 + −, 257 ×, 3 ÷; 2 sin cos; about 6.0 KiB of code.
pub fn inverse_dynamics(
    q: &[f64; 2],
    qd: &[f64; 2],
    mu: &[f64; 6],
    gravity: &[f64; 3],
    xi_dot: &[f64; 8],
    base_wrench: &mut [f64; 6],
    tau: &mut [f64; 2],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let screws = screws(&poses, &inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let base_wrench_0_21_13_0_2 = poses.com_x + 0.25;
    let base_wrench_0_15 = inertias.composite_base_yy * mu[1]
        - inertias.minus_composite_base_xy * mu[0];
    let base_wrench_0_17 = inertias.composite_base_zz * mu[2];
    let base_wrench_0_4 = inertias.minus_composite_link_1_xy
        + inertias.minus_composite_link_1_xy;
    let base_wrench_0_5_1 = inertias.composite_link_1_hy * poses.origin_link_1_x;
    let base_wrench_0_5 = base_wrench_0_5_1 + base_wrench_0_5_1;
    let base_wrench_0_7 = inertias.minus_inertia_link_2_xy
        + inertias.minus_inertia_link_2_xy;
    let base_wrench_0_8_1 = inertias.inertia_link_2_hy * poses.origin_link_2_x;
    let base_wrench_0_8 = base_wrench_0_8_1 + base_wrench_0_8_1;
    let base_wrench_0_21_11_0 = mu[3] - mu[2] * poses.com_y;
    let base_wrench_0_21_13_0 = mu[4] + mu[2] * base_wrench_0_21_13_0_2;
    let base_wrench_0_19_0 = mu[5]
        + (mu[0] * poses.com_y - mu[1] * base_wrench_0_21_13_0_2);
    let base_wrench_0_21_11 = base_wrench_0_21_11_0 * 3.75;
    let base_wrench_0_21_13 = base_wrench_0_21_13_0 * 3.75;
    let base_wrench_0_19 = base_wrench_0_19_0 * 3.75;
    let base_wrench_0_11 = (inertias.composite_link_1_xx - inertias.composite_link_1_yy
        + (inertias.inside_joint_1_mz_1_1 + inertias.inside_joint_1_mz_1_0)) * qd[0]
        + (inertias.inertia_link_2_xx - inertias.inertia_link_2_yy
            - (inertias.inside_joint_2_mz_1_1 - inertias.inside_joint_2_mz_1_0)) * qd[1];
    let base_wrench_0_21_10 = velocities.velocity_base_vx * 3.75;
    let base_wrench_0_21_8 = velocities.minus_velocity_base_vy * 3.75;
    let wrench_outside_link_1_fx_5 = mu[2] - velocities.minus_velocity_base_wz;
    let base_wrench_0_21 = (xi_dot[5] - gravity[2]
        + (xi_dot[0] * poses.com_y - xi_dot[1] * base_wrench_0_21_13_0_2)) * 3.75
        + (mu[0] * base_wrench_0_21_8 + mu[1] * base_wrench_0_21_10)
        - (base_wrench_0_21_11 * mu[1] - base_wrench_0_21_13 * mu[0]);
    // F₁
    base_wrench[0] = inertias.composite_base_xx * xi_dot[0]
        - inertias.minus_composite_base_xy * xi_dot[1]
        + (((base_wrench_0_4 - base_wrench_0_5) * qd[0]
            + (base_wrench_0_7 - base_wrench_0_8) * qd[1]) * mu[0]
            + base_wrench_0_11 * mu[1] + base_wrench_0_21_8 * base_wrench_0_19_0)
        - (base_wrench_0_15 * wrench_outside_link_1_fx_5 - base_wrench_0_17 * mu[1]
            + base_wrench_0_19 * velocities.minus_velocity_base_vy)
        + base_wrench_0_21 * poses.com_y + 0.0;
    let base_wrench_1_17 = inertias.composite_base_xx * mu[0]
        - inertias.minus_composite_base_xy * mu[1];
    let base_wrench_1_10_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let base_wrench_1_10 = base_wrench_1_10_1 + base_wrench_1_10_1;
    let base_wrench_1_6_1 = inertias.inertia_link_2_hx * poses.origin_link_2_y;
    let base_wrench_1_6 = base_wrench_1_6_1 + base_wrench_1_6_1;
    base_wrench[1] = inertias.composite_base_yy * xi_dot[1]
        - inertias.minus_composite_base_xy * xi_dot[0]
        + (base_wrench_0_11 * mu[0]
            + ((base_wrench_1_6 - base_wrench_0_7) * qd[1]
                - (base_wrench_0_4 + base_wrench_1_10) * qd[0]) * mu[1]
            + base_wrench_0_21_10 * base_wrench_0_19_0)
        - (base_wrench_0_17 * mu[0] - base_wrench_1_17 * wrench_outside_link_1_fx_5
            + base_wrench_0_19 * velocities.velocity_base_vx)
        - base_wrench_0_21 * base_wrench_0_21_13_0_2 + 0.0;
    let base_wrench_2_0 = inertias.composite_base_zz * xi_dot[2]
        + (((base_wrench_1_6 - base_wrench_0_8) * qd[1]
            - (base_wrench_1_10 + base_wrench_0_5) * qd[0]) * mu[2]
            - (base_wrench_0_21_10 * base_wrench_0_21_13_0
                + base_wrench_0_21_8 * base_wrench_0_21_11_0))
        - (base_wrench_1_17 * mu[1] - base_wrench_0_15 * mu[0]
            - (base_wrench_0_21_11 * velocities.minus_velocity_base_vy
                + base_wrench_0_21_13 * velocities.velocity_base_vx));
    let base_wrench_2_3 = (xi_dot[3] - gravity[0] - xi_dot[2] * poses.com_y) * 3.75
        - mu[2] * base_wrench_0_21_8
        - (base_wrench_0_21_13 * wrench_outside_link_1_fx_5 - base_wrench_0_19 * mu[1]);
    let base_wrench_2_1 = (xi_dot[4] - gravity[1] + xi_dot[2] * base_wrench_0_21_13_0_2)
        * 3.75 - mu[2] * base_wrench_0_21_10
        - (base_wrench_0_19 * mu[0] - base_wrench_0_21_11 * wrench_outside_link_1_fx_5);
    base_wrench[2] = base_wrench_2_0
        + (base_wrench_2_1 * base_wrench_0_21_13_0_2 - base_wrench_2_3 * poses.com_y)
        + 0.0;
    base_wrench[3] = base_wrench_2_3 + 0.0;
    base_wrench[4] = base_wrench_2_1 + 0.0;
    base_wrench[5] = base_wrench_0_21 + 0.0;
    let wrench_outside_link_1_fx_6 = mu[1] * inertias.minus_inertia_base_hx
        - mu[0] * inertias.minus_inertia_base_hy;
    let wrench_link_2_fy_4 = mu[0] * inertias.inertia_link_2_hy
        - mu[1] * inertias.inertia_link_2_hx;
    let twist_link_1_vx_1 = velocities.velocity_link_1_wz + mu[2];
    let twist_link_2_vx_1 = velocities.velocity_link_2_wz + mu[2];
    let wrench_outside_link_1_mz_18 = velocities.velocity_base_vx * 2.0
        + wrench_outside_link_1_fx_5 * inertias.minus_inertia_base_hy;
    let wrench_outside_link_1_mz_16 = velocities.minus_velocity_base_vy * 2.0
        + wrench_outside_link_1_fx_5 * inertias.minus_inertia_base_hx;
    let wrench_outside_link_2_fx_5 = mu[0] * inertias.inertia_link_1_hy
        - mu[1] * inertias.inertia_link_1_hx;
    let wrench_link_1_mz_0_16 = velocities.velocity_link_1_vx
        - twist_link_1_vx_1 * inertias.inertia_link_1_hy;
    let wrench_outside_link_2_fx_3 = twist_link_1_vx_1 * inertias.inertia_link_1_hx
        - velocities.minus_velocity_link_1_vy;
    let wrench_link_2_mz_16 = velocities.velocity_link_2_vx * 0.75
        - twist_link_2_vx_1 * inertias.inertia_link_2_hy;
    let wrench_link_2_mz_18 = twist_link_2_vx_1 * inertias.inertia_link_2_hx
        - velocities.minus_velocity_link_2_vy * 0.75;
    let minus_twist_base_wz = screws.connection_joint_1_wz * xi_dot[6]
        + screws.connection_joint_2_wz * xi_dot[7];
    let twist_base_vx = screws.minus_connection_joint_1_vx * xi_dot[6]
        - screws.connection_joint_2_vx * xi_dot[7];
    let minus_twist_base_vy = screws.connection_joint_1_vy * xi_dot[6]
        + screws.connection_joint_2_vy * xi_dot[7];
    let twist_link_1_wz = xi_dot[6] - minus_twist_base_wz;
    let twist_link_1_vx = twist_base_vx
        + ((twist_link_1_vx_1 * poses.origin_link_1_x
            - velocities.minus_velocity_link_1_vy) * qd[0]
            - poses.minus_origin_base_y * xi_dot[6]);
    let minus_twist_link_1_vy = minus_twist_base_vy
        + ((twist_link_1_vx_1 * poses.minus_origin_base_y
            + velocities.velocity_link_1_vx) * qd[0]
            + poses.origin_link_1_x * xi_dot[6]);
    let twist_link_2_wz = twist_link_1_wz + xi_dot[7];
    let twist_link_2_vx = twist_link_1_vx
        + ((twist_link_2_vx_1 * poses.origin_link_2_x
            - velocities.minus_velocity_link_2_vy) * qd[1]
            + poses.origin_link_2_y * xi_dot[7]);
    let twist_link_2_vy = (twist_link_2_vx_1 * poses.origin_link_2_y
        - velocities.velocity_link_2_vx) * qd[1] - poses.origin_link_2_x * xi_dot[7]
        - minus_twist_link_1_vy;
    let wrench_outside_link_1_mz = inertias.minus_inertia_base_hx * minus_twist_base_vy
        + inertias.minus_inertia_base_hy * twist_base_vx
        - inertias.inertia_base_zz * minus_twist_base_wz
        - ((inertias.inertia_base_xx * mu[0] - inertias.minus_inertia_base_xy * mu[1])
            * mu[1]
            - (inertias.inertia_base_yy * mu[1] - inertias.minus_inertia_base_xy * mu[0])
                * mu[0]
            + (wrench_outside_link_1_mz_16 * velocities.velocity_base_vx
                - wrench_outside_link_1_mz_18 * velocities.minus_velocity_base_vy));
    let wrench_outside_link_1_fx = twist_base_vx * 2.0
        - minus_twist_base_wz * inertias.minus_inertia_base_hy
        + (wrench_outside_link_1_mz_16 * wrench_outside_link_1_fx_5
            + wrench_outside_link_1_fx_6 * mu[1]);
    let wrench_outside_link_1_fy = minus_twist_base_wz * inertias.minus_inertia_base_hx
        - minus_twist_base_vy * 2.0
        - (wrench_outside_link_1_fx_6 * mu[0]
            - wrench_outside_link_1_mz_18 * wrench_outside_link_1_fx_5);
    let wrench_link_1_mz_0 = inertias.inertia_link_1_zz * twist_link_1_wz
        - (inertias.inertia_link_1_hx * minus_twist_link_1_vy
            + inertias.inertia_link_1_hy * twist_link_1_vx)
        - ((inertias.inertia_link_1_xx * mu[0]
            - inertias.minus_inertia_link_1_xy * mu[1]) * mu[1]
            - (inertias.inertia_link_1_yy * mu[1]
                - inertias.minus_inertia_link_1_xy * mu[0]) * mu[0]
            - (wrench_link_1_mz_0_16 * velocities.minus_velocity_link_1_vy
                + wrench_outside_link_2_fx_3 * velocities.velocity_link_1_vx));
    let wrench_link_1_fy_0 = twist_link_1_wz * inertias.inertia_link_1_hx
        - minus_twist_link_1_vy
        - (wrench_outside_link_2_fx_5 * mu[0]
            - wrench_link_1_mz_0_16 * twist_link_1_vx_1);
    let wrench_link_2_mz = inertias.inertia_link_2_zz * twist_link_2_wz
        + (inertias.inertia_link_2_hx * twist_link_2_vy
            - inertias.inertia_link_2_hy * twist_link_2_vx)
        - ((inertias.inertia_link_2_xx * mu[0]
            - inertias.minus_inertia_link_2_xy * mu[1]) * mu[1]
            - (inertias.inertia_link_2_yy * mu[1]
                - inertias.minus_inertia_link_2_xy * mu[0]) * mu[0]
            - (wrench_link_2_mz_16 * velocities.minus_velocity_link_2_vy
                + wrench_link_2_mz_18 * velocities.velocity_link_2_vx));
    let wrench_link_2_fy = twist_link_2_vy * 0.75
        + twist_link_2_wz * inertias.inertia_link_2_hx
        - (wrench_link_2_fy_4 * mu[0] - wrench_link_2_mz_16 * twist_link_2_vx_1);
    let wrench_link_1_mz = wrench_link_1_mz_0 + wrench_link_2_mz;
    let wrench_link_1_fy = wrench_link_1_fy_0 + wrench_link_2_fy;
    // τ
    tau[0] = reactions.reaction_joint_1_wz * wrench_link_1_mz
        - reactions.minus_reaction_joint_1_vy * wrench_link_1_fy
        - (screws.connection_joint_1_wz * wrench_outside_link_1_mz
            - screws.minus_connection_joint_1_vx * wrench_outside_link_1_fx
            + screws.connection_joint_1_vy * wrench_outside_link_1_fy)
        + (screws.connection_joint_1_wz * base_wrench_2_0
            - screws.minus_connection_joint_1_vx * base_wrench_2_3
            + screws.connection_joint_1_vy * base_wrench_2_1) + 0.0;
    let wrench_link_2_fx = twist_link_2_vx * 0.75
        - twist_link_2_wz * inertias.inertia_link_2_hy
        - (wrench_link_2_mz_18 * twist_link_2_vx_1 - wrench_link_2_fy_4 * mu[1]);
    let wrench_outside_link_2_mz = wrench_link_1_mz_0 + wrench_outside_link_1_mz;
    let wrench_outside_link_2_fx = twist_link_1_vx
        - twist_link_1_wz * inertias.inertia_link_1_hy
        - (wrench_outside_link_2_fx_3 * twist_link_1_vx_1
            - wrench_outside_link_2_fx_5 * mu[1]) + wrench_outside_link_1_fx;
    let wrench_outside_link_2_fy = wrench_link_1_fy_0 + wrench_outside_link_1_fy;
    tau[1] = reactions.reaction_joint_2_wz * wrench_link_2_mz
        + reactions.reaction_joint_2_vx * wrench_link_2_fx
        + reactions.reaction_joint_2_vy * wrench_link_2_fy
        - (screws.connection_joint_2_wz * wrench_outside_link_2_mz
            + screws.connection_joint_2_vx * wrench_outside_link_2_fx
            + screws.connection_joint_2_vy * wrench_outside_link_2_fy)
        + (screws.connection_joint_2_wz * base_wrench_2_0
            + screws.connection_joint_2_vx * base_wrench_2_3
            + screws.connection_joint_2_vy * base_wrench_2_1) + 0.0;
}
/// Where a link is, and how the joints move it at zero momentum.
///
/// - `q`: shape (2; rad, m)
/// - `pose`: g_k = [R p], rotation and position of the link in the base frame (3×4, by columns; m)
/// - `generalized_jacobian`: J̃_k = J_k − X_k A_l, body Jacobian of the link at zero momentum, link frame (6×2, by columns; rad, m)
///
/// 155 operations: 80 + −, 72 ×, 3 ÷; 2 sin cos; about 1.9 KiB of code.
pub fn kinematics_link_2(
    q: &[f64; 2],
    pose: &mut [[f64; 3]; 4],
    generalized_jacobian: &mut [[f64; 6]; 2],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&inertias);
    let outside = outside(&poses, &inertias, &complements);
    let reactions = reactions(&inertias, &outside);
    // g_k = [R p] column 0
    pose[0][0] = poses.rotation_link_2_xx + 0.0;
    pose[0][1] = poses.rotation_link_2_yx + 0.0;
    pose[0][2] = 0.0;
    // g_k = [R p] column 1
    pose[1][0] = 0.0 - poses.rotation_link_2_yx;
    pose[1][1] = poses.rotation_link_2_xx + 0.0;
    pose[1][2] = 0.0;
    // g_k = [R p] column 2
    pose[2][0] = 0.0;
    pose[2][1] = 0.0;
    pose[2][2] = 1.0;
    // g_k = [R p] column 3
    pose[3][0] = poses.origin_link_2_x + (poses.com_x + 0.25) + 0.0;
    pose[3][1] = poses.origin_link_2_y + poses.com_y + 0.0;
    pose[3][2] = 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_1
    generalized_jacobian[0][0] = 0.0;
    generalized_jacobian[0][1] = 0.0;
    generalized_jacobian[0][2] = reactions.reaction_joint_1_wz + 0.0;
    let generalized_jacobian_3_0_3 = reactions.reaction_joint_1_wz
        * poses.origin_link_2_y;
    let generalized_jacobian_3_0_1 = reactions.reaction_joint_1_wz
        * poses.origin_link_2_x - reactions.minus_reaction_joint_1_vy;
    generalized_jacobian[0][3] = poses.rotation_link_2_yx * generalized_jacobian_3_0_1
        - poses.rotation_link_2_xx * generalized_jacobian_3_0_3 + 0.0;
    generalized_jacobian[0][4] = poses.rotation_link_2_yx * generalized_jacobian_3_0_3
        + poses.rotation_link_2_xx * generalized_jacobian_3_0_1 + 0.0;
    generalized_jacobian[0][5] = 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_2
    generalized_jacobian[1][0] = 0.0;
    generalized_jacobian[1][1] = 0.0;
    generalized_jacobian[1][2] = reactions.reaction_joint_2_wz + 0.0;
    let generalized_jacobian_3_1_1 = reactions.reaction_joint_2_vx
        - reactions.reaction_joint_2_wz * poses.origin_link_2_y;
    let generalized_jacobian_3_1_3 = reactions.reaction_joint_2_vy
        + reactions.reaction_joint_2_wz * poses.origin_link_2_x;
    generalized_jacobian[1][3] = poses.rotation_link_2_xx * generalized_jacobian_3_1_1
        + poses.rotation_link_2_yx * generalized_jacobian_3_1_3 + 0.0;
    generalized_jacobian[1][4] = poses.rotation_link_2_xx * generalized_jacobian_3_1_3
        - poses.rotation_link_2_yx * generalized_jacobian_3_1_1 + 0.0;
    generalized_jacobian[1][5] = 0.0;
}
