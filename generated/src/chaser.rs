//! The dynamics of the robot 'chaser', generated: read it, review its changes, do not edit it.
//!
//! Coordinates: joint_1, joint_2, joint_3.
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
pub const DOF: usize = 3;
/// Names of the coordinates, in the order of the columns.
pub const COORDINATES: [&str; DOF] = ["joint_1", "joint_2", "joint_3"];
/// The robot, as one that answers quantities.
#[derive(Clone, Copy, Debug)]
pub struct Chaser;
impl FloatingBase<f64> for Chaser {
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
            Quantity::StateRate | Quantity::InverseDynamics | Quantity::Kinematics(4)
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
            (Quantity::Kinematics(4), [q], [pose, generalized_jacobian]) => {
                self::kinematics_link_3(
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
    minus_rotation_link_3_xx: f64,
    rotation_link_3_yx: f64,
    rotation_link_3_zx: f64,
    rotation_link_3_xy: f64,
    rotation_link_3_yy: f64,
    rotation_link_3_zy: f64,
    com_x: f64,
    minus_com_y: f64,
    com_z: f64,
    minus_origin_base_z_1_0: f64,
    minus_origin_base_x_1_0: f64,
    origin_base_y_1_4: f64,
    minus_origin_base_z_1_4: f64,
    minus_origin_base_x_1_6: f64,
    origin_base_y_1_6: f64,
    minus_origin_base_z_1_6: f64,
    minus_origin_base_x_1: f64,
    origin_base_y_1: f64,
    minus_origin_base_z_1: f64,
    minus_origin_base_x: f64,
    origin_base_y: f64,
    minus_origin_base_z: f64,
    origin_link_2_z: f64,
    origin_link_3_x: f64,
    origin_link_3_y: f64,
    origin_link_3_z: f64,
}
/// Rotations and origins of the bodies, from the centre of mass, base axes.
#[inline(never)]
fn poses(q: &[f64; 3]) -> Poses {
    // link_1
    let [(sin_joint_1, cos_joint_1), (sin_joint_2, cos_joint_2),
    (sin_joint_3, cos_joint_3)] = turn::sin_cos_each([q[0], q[1], q[2]]);
    // link_2
    let minus_rotation_link_2_xx = sin_joint_1 * sin_joint_2;
    let rotation_link_2_yx = cos_joint_1 * sin_joint_2;
    let minus_rotation_link_2_xy = sin_joint_1 * cos_joint_2;
    let rotation_link_2_yy = cos_joint_1 * cos_joint_2;
    let origin_link_3_x_0 = minus_rotation_link_2_xx * 0.75;
    let origin_link_3_y_1 = rotation_link_2_yx * 0.75;
    let origin_link_3_z_0 = 0.8011904761904762 + cos_joint_2 * 0.75;
    // link_3
    let minus_rotation_link_3_xx = minus_rotation_link_2_xx * cos_joint_3
        + minus_rotation_link_2_xy * sin_joint_3;
    let rotation_link_3_yx = rotation_link_2_yx * cos_joint_3
        + rotation_link_2_yy * sin_joint_3;
    let rotation_link_3_zx = sin_joint_2 * sin_joint_3 - cos_joint_2 * cos_joint_3;
    let rotation_link_3_xy = minus_rotation_link_2_xx * sin_joint_3
        - minus_rotation_link_2_xy * cos_joint_3;
    let rotation_link_3_yy = rotation_link_2_yy * cos_joint_3
        - rotation_link_2_yx * sin_joint_3;
    let rotation_link_3_zy = sin_joint_2 * cos_joint_3 + cos_joint_2 * sin_joint_3;
    let com_x_0 = minus_rotation_link_2_xx * 0.375;
    let minus_com_y_0 = rotation_link_2_yx * 0.375;
    let com_z_1 = 0.8011904761904762 + cos_joint_2 * 0.375;
    let com_x_2 = origin_link_3_x_0 + minus_rotation_link_3_xx * 0.375;
    let minus_com_y_2 = origin_link_3_y_1 + rotation_link_3_yx * 0.375;
    let com_z_3 = origin_link_3_z_0 - rotation_link_3_zx * 0.375;
    let com_x = (com_x_0 * 10.0 + com_x_2 * 10.0) * 0.007692307692307693;
    let minus_com_y = (minus_com_y_0 * 10.0 + minus_com_y_2 * 10.0)
        * 0.007692307692307693;
    let com_z = (3.5059523809523805 + com_z_1 * 10.0 + com_z_3 * 10.0)
        * 0.007692307692307693;
    let minus_origin_base_z_1_0 = 0.7011904761904761 - com_z;
    let minus_origin_base_x_1_0 = com_x_0 - com_x;
    let origin_base_y_1_4 = minus_com_y - minus_com_y_0;
    let minus_origin_base_z_1_4 = com_z_1 - com_z;
    let minus_origin_base_x_1_6 = com_x_2 - com_x;
    let origin_base_y_1_6 = minus_com_y - minus_com_y_2;
    let minus_origin_base_z_1_6 = com_z_3 - com_z;
    let minus_origin_base_x_1 = (minus_origin_base_x_1_0 * 10.0
        - (com_x * 105.0 + com_x * 5.0) + minus_origin_base_x_1_6 * 10.0)
        * 0.007692307692307693;
    let origin_base_y_1 = (minus_com_y * 105.0 + minus_com_y * 5.0
        + origin_base_y_1_4 * 10.0 + origin_base_y_1_6 * 10.0) * 0.007692307692307693;
    let minus_origin_base_z_1 = (minus_origin_base_z_1_0 * 5.0 - com_z * 105.0
        + minus_origin_base_z_1_4 * 10.0 + minus_origin_base_z_1_6 * 10.0)
        * 0.007692307692307693;
    // base
    let minus_origin_base_x = com_x + minus_origin_base_x_1;
    let origin_base_y = minus_com_y - origin_base_y_1;
    let minus_origin_base_z = com_z + minus_origin_base_z_1;
    // link_2
    let origin_link_2_z = 0.8011904761904762 - com_z - minus_origin_base_z_1;
    // link_3
    let origin_link_3_x = origin_link_3_x_0 - com_x - minus_origin_base_x_1;
    let origin_link_3_y = minus_com_y - origin_link_3_y_1 - origin_base_y_1;
    let origin_link_3_z = origin_link_3_z_0 - com_z - minus_origin_base_z_1;
    Poses {
        sin_joint_1,
        cos_joint_1,
        minus_rotation_link_3_xx,
        rotation_link_3_yx,
        rotation_link_3_zx,
        rotation_link_3_xy,
        rotation_link_3_yy,
        rotation_link_3_zy,
        com_x,
        minus_com_y,
        com_z,
        minus_origin_base_z_1_0,
        minus_origin_base_x_1_0,
        origin_base_y_1_4,
        minus_origin_base_z_1_4,
        minus_origin_base_x_1_6,
        origin_base_y_1_6,
        minus_origin_base_z_1_6,
        minus_origin_base_x_1,
        origin_base_y_1,
        minus_origin_base_z_1,
        minus_origin_base_x,
        origin_base_y,
        minus_origin_base_z,
        origin_link_2_z,
        origin_link_3_x,
        origin_link_3_y,
        origin_link_3_z,
    }
}
/// Inertias of the bodies and of their subtrees, centroidal frame.
struct Inertias {
    minus_inertia_base_hx: f64,
    inertia_base_hy: f64,
    minus_inertia_base_hz: f64,
    inertia_base_yy_1: f64,
    inertia_base_xx_1: f64,
    inertia_base_xy: f64,
    minus_inertia_base_xz: f64,
    inertia_base_yz: f64,
    inertia_base_zz_1: f64,
    inertia_base_xx: f64,
    inertia_base_yy: f64,
    inertia_base_zz: f64,
    minus_inertia_link_1_hx: f64,
    inertia_link_1_hy: f64,
    inertia_link_1_hz: f64,
    inertia_link_1_xy: f64,
    inertia_link_1_xz: f64,
    minus_inertia_link_1_yz: f64,
    inertia_link_1_xx: f64,
    inertia_link_1_yy: f64,
    inertia_link_1_zz: f64,
    inertia_link_2_hx: f64,
    inertia_link_2_hy: f64,
    inertia_link_2_hz: f64,
    minus_inertia_link_2_xy: f64,
    minus_inertia_link_2_xz: f64,
    minus_inertia_link_2_yz: f64,
    inertia_link_2_xx: f64,
    inertia_link_2_yy: f64,
    inertia_link_2_zz: f64,
    inertia_link_3_hx: f64,
    inertia_link_3_hy: f64,
    inertia_link_3_hz: f64,
    minus_inertia_link_3_xy: f64,
    minus_inertia_link_3_xz: f64,
    minus_inertia_link_3_yz: f64,
    inertia_link_3_xx: f64,
    inertia_link_3_yy: f64,
    inertia_link_3_zz: f64,
    composite_link_2_hx: f64,
    composite_link_2_hy: f64,
    composite_link_2_hz: f64,
    composite_link_2_xx: f64,
    minus_composite_link_2_xy: f64,
    minus_composite_link_2_xz: f64,
    composite_link_2_yy: f64,
    minus_composite_link_2_yz: f64,
    composite_link_2_zz: f64,
    composite_link_1_hx: f64,
    composite_link_1_hy: f64,
    composite_link_1_hz: f64,
    composite_link_1_xx: f64,
    composite_link_1_xy: f64,
    composite_link_1_xz: f64,
    composite_link_1_yy: f64,
    minus_composite_link_1_yz: f64,
    composite_link_1_zz: f64,
    composite_base_xx: f64,
    composite_base_xy: f64,
    composite_base_xz: f64,
    composite_base_yy: f64,
    composite_base_yz: f64,
    composite_base_zz: f64,
    locked_inverse_pivot_x: f64,
    locked_inverse_pivot_y_2: f64,
    locked_inverse_pivot_z_2: f64,
    locked_inverse_pivot_y: f64,
    locked_inverse_pivot_z_4: f64,
    locked_inverse_pivot_z: f64,
    inside_joint_1_mz_1_0: f64,
    inside_joint_1_mz_1_1: f64,
    inside_joint_2_mx_0_1: f64,
    inside_joint_2_my_0_1: f64,
    inside_joint_2_mz_1_0: f64,
    inside_joint_2_mz_1_1: f64,
    inside_joint_3_mx_0_1: f64,
    inside_joint_3_my_0_1: f64,
    inside_joint_3_mz_1_0: f64,
    inside_joint_3_mz_1_1: f64,
}
/// Inertias of the bodies and of their subtrees, centroidal frame.
#[inline(never)]
fn inertias(poses: &Poses) -> Inertias {
    // base
    let minus_inertia_base_hx = poses.minus_origin_base_x * 105.0;
    let inertia_base_hy = poses.origin_base_y * 105.0;
    let minus_inertia_base_hz = poses.minus_origin_base_z * 105.0;
    let inertia_base_yy_1 = minus_inertia_base_hx * poses.minus_origin_base_x;
    let inertia_base_xx_1 = inertia_base_hy * poses.origin_base_y;
    let inertia_base_xx_2 = minus_inertia_base_hz * poses.minus_origin_base_z;
    let inertia_base_xy = minus_inertia_base_hx * poses.origin_base_y;
    let minus_inertia_base_xz = minus_inertia_base_hx * poses.minus_origin_base_z;
    let inertia_base_yz = inertia_base_hy * poses.minus_origin_base_z;
    let inertia_base_zz_1 = inertia_base_yy_1 + inertia_base_xx_1;
    let inertia_base_xx = 10.540476190476191 + (inertia_base_xx_1 + inertia_base_xx_2);
    let inertia_base_yy = 10.540476190476191 + (inertia_base_yy_1 + inertia_base_xx_2);
    let inertia_base_zz = 9.350000000000001 + inertia_base_zz_1;
    let inertia_link_1_hz_0 = poses.minus_origin_base_z_1_0
        - poses.minus_origin_base_z_1;
    // link_1
    let minus_inertia_link_1_hx = poses.minus_origin_base_x * 5.0;
    let inertia_link_1_hy = poses.origin_base_y * 5.0;
    let inertia_link_1_hz = inertia_link_1_hz_0 * 5.0;
    let inertia_link_1_yy_1 = minus_inertia_link_1_hx * poses.minus_origin_base_x;
    let inertia_link_1_xx_1 = inertia_link_1_hy * poses.origin_base_y;
    let inertia_link_1_xx_2 = inertia_link_1_hz * inertia_link_1_hz_0;
    let inertia_link_1_xy = minus_inertia_link_1_hx * poses.origin_base_y;
    let inertia_link_1_xz = minus_inertia_link_1_hx * inertia_link_1_hz_0;
    let minus_inertia_link_1_yz = inertia_link_1_hy * inertia_link_1_hz_0;
    let inertia_link_1_xx = 0.05 + (inertia_link_1_xx_1 + inertia_link_1_xx_2);
    let inertia_link_1_yy = 0.05 + (inertia_link_1_yy_1 + inertia_link_1_xx_2);
    let inertia_link_1_zz = 0.05 + (inertia_link_1_yy_1 + inertia_link_1_xx_1);
    let inertia_link_2_hx_0 = poses.minus_origin_base_x_1_0
        - poses.minus_origin_base_x_1;
    let inertia_link_2_hy_0 = poses.origin_base_y_1_4 - poses.origin_base_y_1;
    let inertia_link_2_hz_0 = poses.minus_origin_base_z_1_4
        - poses.minus_origin_base_z_1;
    // link_2
    let inertia_link_2_hx = inertia_link_2_hx_0 * 10.0;
    let inertia_link_2_hy = inertia_link_2_hy_0 * 10.0;
    let inertia_link_2_hz = inertia_link_2_hz_0 * 10.0;
    let inertia_link_2_yy_1 = inertia_link_2_hx * inertia_link_2_hx_0;
    let inertia_link_2_xx_1 = inertia_link_2_hy * inertia_link_2_hy_0;
    let inertia_link_2_xx_2 = inertia_link_2_hz * inertia_link_2_hz_0;
    let minus_inertia_link_2_xy = inertia_link_2_hx * inertia_link_2_hy_0;
    let minus_inertia_link_2_xz = inertia_link_2_hx * inertia_link_2_hz_0;
    let minus_inertia_link_2_yz = inertia_link_2_hy * inertia_link_2_hz_0;
    let inertia_link_2_xx = 0.1 + (inertia_link_2_xx_1 + inertia_link_2_xx_2);
    let inertia_link_2_yy = 0.1 + (inertia_link_2_yy_1 + inertia_link_2_xx_2);
    let inertia_link_2_zz = 0.1 + (inertia_link_2_yy_1 + inertia_link_2_xx_1);
    let inertia_link_3_hx_0 = poses.minus_origin_base_x_1_6
        - poses.minus_origin_base_x_1;
    let inertia_link_3_hy_0 = poses.origin_base_y_1_6 - poses.origin_base_y_1;
    let inertia_link_3_hz_0 = poses.minus_origin_base_z_1_6
        - poses.minus_origin_base_z_1;
    // link_3
    let inertia_link_3_hx = inertia_link_3_hx_0 * 10.0;
    let inertia_link_3_hy = inertia_link_3_hy_0 * 10.0;
    let inertia_link_3_hz = inertia_link_3_hz_0 * 10.0;
    let inertia_link_3_yy_1 = inertia_link_3_hx * inertia_link_3_hx_0;
    let inertia_link_3_xx_1 = inertia_link_3_hy * inertia_link_3_hy_0;
    let inertia_link_3_xx_2 = inertia_link_3_hz * inertia_link_3_hz_0;
    let minus_inertia_link_3_xy = inertia_link_3_hx * inertia_link_3_hy_0;
    let minus_inertia_link_3_xz = inertia_link_3_hx * inertia_link_3_hz_0;
    let minus_inertia_link_3_yz = inertia_link_3_hy * inertia_link_3_hz_0;
    let inertia_link_3_xx = 0.1 + (inertia_link_3_xx_1 + inertia_link_3_xx_2);
    let inertia_link_3_yy = 0.1 + (inertia_link_3_yy_1 + inertia_link_3_xx_2);
    let inertia_link_3_zz = 0.1 + (inertia_link_3_yy_1 + inertia_link_3_xx_1);
    // link_2
    let composite_link_2_hx = inertia_link_2_hx + inertia_link_3_hx;
    let composite_link_2_hy = inertia_link_2_hy + inertia_link_3_hy;
    let composite_link_2_hz = inertia_link_2_hz + inertia_link_3_hz;
    let composite_link_2_xx = inertia_link_2_xx + inertia_link_3_xx;
    let minus_composite_link_2_xy = minus_inertia_link_2_xy + minus_inertia_link_3_xy;
    let minus_composite_link_2_xz = minus_inertia_link_2_xz + minus_inertia_link_3_xz;
    let composite_link_2_yy = inertia_link_2_yy + inertia_link_3_yy;
    let minus_composite_link_2_yz = minus_inertia_link_2_yz + minus_inertia_link_3_yz;
    let composite_link_2_zz = inertia_link_2_zz + inertia_link_3_zz;
    // link_1
    let composite_link_1_hx = composite_link_2_hx - minus_inertia_link_1_hx;
    let composite_link_1_hy = inertia_link_1_hy + composite_link_2_hy;
    let composite_link_1_hz = inertia_link_1_hz + composite_link_2_hz;
    let composite_link_1_xx = inertia_link_1_xx + composite_link_2_xx;
    let composite_link_1_xy = inertia_link_1_xy - minus_composite_link_2_xy;
    let composite_link_1_xz = inertia_link_1_xz - minus_composite_link_2_xz;
    let composite_link_1_yy = inertia_link_1_yy + composite_link_2_yy;
    let minus_composite_link_1_yz = minus_inertia_link_1_yz + minus_composite_link_2_yz;
    let composite_link_1_zz = inertia_link_1_zz + composite_link_2_zz;
    // base
    let composite_base_xx = inertia_base_xx + composite_link_1_xx;
    let composite_base_xy = inertia_base_xy + composite_link_1_xy;
    let composite_base_xz = composite_link_1_xz - minus_inertia_base_xz;
    let composite_base_yy = inertia_base_yy + composite_link_1_yy;
    let composite_base_yz = inertia_base_yz - minus_composite_link_1_yz;
    let composite_base_zz = inertia_base_zz + composite_link_1_zz;
    let locked_inverse_pivot_x = 1.0 / composite_base_xx;
    let locked_inverse_pivot_y_2 = composite_base_xy * locked_inverse_pivot_x;
    let locked_inverse_pivot_z_2 = composite_base_xz * locked_inverse_pivot_x;
    let locked_inverse_pivot_y = 1.0
        / (composite_base_yy - locked_inverse_pivot_y_2 * composite_base_xy);
    let locked_inverse_pivot_z_5 = composite_base_yz
        - locked_inverse_pivot_z_2 * composite_base_xy;
    let locked_inverse_pivot_z_4 = locked_inverse_pivot_z_5 * locked_inverse_pivot_y;
    let locked_inverse_pivot_z = 1.0
        / (composite_base_zz - locked_inverse_pivot_z_2 * composite_base_xz
            - locked_inverse_pivot_z_4 * locked_inverse_pivot_z_5);
    let inside_joint_1_mz_1_0 = composite_link_1_hx * poses.minus_origin_base_x;
    let inside_joint_1_mz_1_1 = composite_link_1_hy * poses.origin_base_y;
    let inside_joint_2_mx_0_1 = minus_composite_link_2_xy * poses.sin_joint_1;
    let inside_joint_2_my_0_1 = minus_composite_link_2_xy * poses.cos_joint_1;
    let inside_joint_2_mz_1_0 = minus_composite_link_2_xz * poses.cos_joint_1;
    let inside_joint_2_mz_1_1 = minus_composite_link_2_yz * poses.sin_joint_1;
    let inside_joint_3_mx_0_1 = minus_inertia_link_3_xy * poses.sin_joint_1;
    let inside_joint_3_my_0_1 = minus_inertia_link_3_xy * poses.cos_joint_1;
    let inside_joint_3_mz_1_0 = minus_inertia_link_3_xz * poses.cos_joint_1;
    let inside_joint_3_mz_1_1 = minus_inertia_link_3_yz * poses.sin_joint_1;
    Inertias {
        minus_inertia_base_hx,
        inertia_base_hy,
        minus_inertia_base_hz,
        inertia_base_yy_1,
        inertia_base_xx_1,
        inertia_base_xy,
        minus_inertia_base_xz,
        inertia_base_yz,
        inertia_base_zz_1,
        inertia_base_xx,
        inertia_base_yy,
        inertia_base_zz,
        minus_inertia_link_1_hx,
        inertia_link_1_hy,
        inertia_link_1_hz,
        inertia_link_1_xy,
        inertia_link_1_xz,
        minus_inertia_link_1_yz,
        inertia_link_1_xx,
        inertia_link_1_yy,
        inertia_link_1_zz,
        inertia_link_2_hx,
        inertia_link_2_hy,
        inertia_link_2_hz,
        minus_inertia_link_2_xy,
        minus_inertia_link_2_xz,
        minus_inertia_link_2_yz,
        inertia_link_2_xx,
        inertia_link_2_yy,
        inertia_link_2_zz,
        inertia_link_3_hx,
        inertia_link_3_hy,
        inertia_link_3_hz,
        minus_inertia_link_3_xy,
        minus_inertia_link_3_xz,
        minus_inertia_link_3_yz,
        inertia_link_3_xx,
        inertia_link_3_yy,
        inertia_link_3_zz,
        composite_link_2_hx,
        composite_link_2_hy,
        composite_link_2_hz,
        composite_link_2_xx,
        minus_composite_link_2_xy,
        minus_composite_link_2_xz,
        composite_link_2_yy,
        minus_composite_link_2_yz,
        composite_link_2_zz,
        composite_link_1_hx,
        composite_link_1_hy,
        composite_link_1_hz,
        composite_link_1_xx,
        composite_link_1_xy,
        composite_link_1_xz,
        composite_link_1_yy,
        minus_composite_link_1_yz,
        composite_link_1_zz,
        composite_base_xx,
        composite_base_xy,
        composite_base_xz,
        composite_base_yy,
        composite_base_yz,
        composite_base_zz,
        locked_inverse_pivot_x,
        locked_inverse_pivot_y_2,
        locked_inverse_pivot_z_2,
        locked_inverse_pivot_y,
        locked_inverse_pivot_z_4,
        locked_inverse_pivot_z,
        inside_joint_1_mz_1_0,
        inside_joint_1_mz_1_1,
        inside_joint_2_mx_0_1,
        inside_joint_2_my_0_1,
        inside_joint_2_mz_1_0,
        inside_joint_2_mz_1_1,
        inside_joint_3_mx_0_1,
        inside_joint_3_my_0_1,
        inside_joint_3_mz_1_0,
        inside_joint_3_mz_1_1,
    }
}
/// Inertias of what is outside each subtree, centroidal frame.
struct Complements {
    minus_complement_link_2_hx: f64,
    complement_link_2_hy: f64,
    complement_link_2_hz: f64,
    complement_link_2_xx: f64,
    complement_link_2_xy: f64,
    complement_link_2_xz: f64,
    complement_link_2_yy: f64,
    complement_link_2_yz: f64,
    complement_link_2_zz: f64,
    complement_link_3_hx: f64,
    complement_link_3_hy: f64,
    complement_link_3_hz: f64,
    complement_link_3_xx: f64,
    complement_link_3_xy: f64,
    complement_link_3_xz: f64,
    complement_link_3_yy: f64,
    complement_link_3_yz: f64,
    complement_link_3_zz: f64,
    outside_joint_2_mx_0_1: f64,
    outside_joint_2_my_0_0: f64,
    outside_joint_2_mz_0_0: f64,
    outside_joint_2_mz_0_1: f64,
}
/// Inertias of what is outside each subtree, centroidal frame.
#[inline(never)]
fn complements(poses: &Poses, inertias: &Inertias) -> Complements {
    // link_2
    let minus_complement_link_2_hx = inertias.minus_inertia_link_1_hx
        + inertias.minus_inertia_base_hx;
    let complement_link_2_hy = inertias.inertia_link_1_hy + inertias.inertia_base_hy;
    let complement_link_2_hz = inertias.inertia_link_1_hz
        - inertias.minus_inertia_base_hz;
    let complement_link_2_xx = inertias.inertia_link_1_xx + inertias.inertia_base_xx;
    let complement_link_2_xy = inertias.inertia_link_1_xy + inertias.inertia_base_xy;
    let complement_link_2_xz = inertias.inertia_link_1_xz
        - inertias.minus_inertia_base_xz;
    let complement_link_2_yy = inertias.inertia_link_1_yy + inertias.inertia_base_yy;
    let complement_link_2_yz = inertias.inertia_base_yz
        - inertias.minus_inertia_link_1_yz;
    let complement_link_2_zz = inertias.inertia_link_1_zz + inertias.inertia_base_zz;
    // link_3
    let complement_link_3_hx = inertias.inertia_link_2_hx - minus_complement_link_2_hx;
    let complement_link_3_hy = inertias.inertia_link_2_hy + complement_link_2_hy;
    let complement_link_3_hz = inertias.inertia_link_2_hz + complement_link_2_hz;
    let complement_link_3_xx = inertias.inertia_link_2_xx + complement_link_2_xx;
    let complement_link_3_xy = complement_link_2_xy - inertias.minus_inertia_link_2_xy;
    let complement_link_3_xz = complement_link_2_xz - inertias.minus_inertia_link_2_xz;
    let complement_link_3_yy = inertias.inertia_link_2_yy + complement_link_2_yy;
    let complement_link_3_yz = complement_link_2_yz - inertias.minus_inertia_link_2_yz;
    let complement_link_3_zz = inertias.inertia_link_2_zz + complement_link_2_zz;
    let outside_joint_2_mx_0_1 = complement_link_2_xy * poses.sin_joint_1;
    let outside_joint_2_my_0_0 = complement_link_2_xy * poses.cos_joint_1;
    let outside_joint_2_mz_0_0 = complement_link_2_xz * poses.cos_joint_1;
    let outside_joint_2_mz_0_1 = complement_link_2_yz * poses.sin_joint_1;
    Complements {
        minus_complement_link_2_hx,
        complement_link_2_hy,
        complement_link_2_hz,
        complement_link_2_xx,
        complement_link_2_xy,
        complement_link_2_xz,
        complement_link_2_yy,
        complement_link_2_yz,
        complement_link_2_zz,
        complement_link_3_hx,
        complement_link_3_hy,
        complement_link_3_hz,
        complement_link_3_xx,
        complement_link_3_xy,
        complement_link_3_xz,
        complement_link_3_yy,
        complement_link_3_yz,
        complement_link_3_zz,
        outside_joint_2_mx_0_1,
        outside_joint_2_my_0_0,
        outside_joint_2_mz_0_0,
        outside_joint_2_mz_0_1,
    }
}
/// Screw axes s_j, their momenta h_j = Iᶜ_j s_j, the connection Λ_c⁻¹ h_j.
struct Screws {
    inside_joint_1_mx: f64,
    inside_joint_1_my: f64,
    inside_joint_1_fx: f64,
    inside_joint_1_fy: f64,
    connection_joint_1_wz: f64,
    connection_joint_1_wy: f64,
    connection_joint_1_wx: f64,
    connection_joint_1_vx: f64,
    connection_joint_1_vy: f64,
    minus_screw_joint_2_vx: f64,
    screw_joint_2_vy: f64,
    minus_screw_joint_2_vz: f64,
    inside_joint_2_mx_3: f64,
    inside_joint_2_mx_4: f64,
    inside_joint_2_my_4: f64,
    inside_joint_2_my_3: f64,
    inside_joint_2_mz_0: f64,
    inside_joint_2_mz_1: f64,
    inside_joint_2_fx: f64,
    inside_joint_2_fy: f64,
    inside_joint_2_fz: f64,
    outside_joint_2_mx_1_0: f64,
    outside_joint_2_mx_1_1: f64,
    outside_joint_2_my_1_0: f64,
    outside_joint_2_my_1_1: f64,
    outside_joint_2_mz_1_1: f64,
    outside_joint_2_mz_1_0: f64,
    connection_joint_2_wz: f64,
    connection_joint_2_wy: f64,
    connection_joint_2_wx: f64,
    connection_joint_2_vx: f64,
    connection_joint_2_vy: f64,
    connection_joint_2_vz: f64,
    minus_screw_joint_3_vx: f64,
    screw_joint_3_vy: f64,
    screw_joint_3_vz: f64,
    inside_joint_3_mx_3: f64,
    inside_joint_3_mx_4: f64,
    inside_joint_3_my_3: f64,
    inside_joint_3_my_4: f64,
    inside_joint_3_mz_0: f64,
    inside_joint_3_mz_1: f64,
    inside_joint_3_mx: f64,
    inside_joint_3_my: f64,
    inside_joint_3_mz: f64,
    inside_joint_3_fx: f64,
    inside_joint_3_fy: f64,
    inside_joint_3_fz: f64,
    connection_joint_3_wz: f64,
    connection_joint_3_wy: f64,
    connection_joint_3_wx: f64,
    connection_joint_3_vx: f64,
    connection_joint_3_vy: f64,
    connection_joint_3_vz: f64,
}
/// Screw axes s_j, their momenta h_j = Iᶜ_j s_j, the connection Λ_c⁻¹ h_j.
#[inline(never)]
fn screws(poses: &Poses, inertias: &Inertias, complements: &Complements) -> Screws {
    // joint_1
    let inside_joint_1_mx = inertias.composite_link_1_xz
        - inertias.composite_link_1_hz * poses.minus_origin_base_x;
    let inside_joint_1_my = inertias.composite_link_1_hz * poses.origin_base_y
        - inertias.minus_composite_link_1_yz;
    let inside_joint_1_mz = inertias.composite_link_1_zz
        + (inertias.inside_joint_1_mz_1_0 - inertias.inside_joint_1_mz_1_1);
    let inside_joint_1_fx = poses.origin_base_y * 25.0 - inertias.composite_link_1_hy;
    let inside_joint_1_fy = poses.minus_origin_base_x * 25.0
        + inertias.composite_link_1_hx;
    let connection_joint_1_wz_4 = inside_joint_1_my
        - inertias.locked_inverse_pivot_y_2 * inside_joint_1_mx;
    let connection_joint_1_wz = (inside_joint_1_mz
        - inertias.locked_inverse_pivot_z_2 * inside_joint_1_mx
        - inertias.locked_inverse_pivot_z_4 * connection_joint_1_wz_4)
        * inertias.locked_inverse_pivot_z;
    let connection_joint_1_wy = connection_joint_1_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * connection_joint_1_wz;
    let connection_joint_1_wx = inside_joint_1_mx * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * connection_joint_1_wy
        - inertias.locked_inverse_pivot_z_2 * connection_joint_1_wz;
    let connection_joint_1_vx = inside_joint_1_fx * 0.007692307692307693;
    let connection_joint_1_vy = inside_joint_1_fy * 0.007692307692307693;
    // joint_2
    let minus_screw_joint_2_vx = poses.origin_link_2_z * poses.sin_joint_1;
    let screw_joint_2_vy = poses.origin_link_2_z * poses.cos_joint_1;
    let minus_screw_joint_2_vz = poses.minus_origin_base_x * poses.sin_joint_1
        + poses.origin_base_y * poses.cos_joint_1;
    let inside_joint_2_mx_3 = inertias.composite_link_2_hy * minus_screw_joint_2_vz;
    let inside_joint_2_mx_4 = inertias.composite_link_2_hz * screw_joint_2_vy;
    let inside_joint_2_my_4 = inertias.composite_link_2_hz * minus_screw_joint_2_vx;
    let inside_joint_2_my_3 = inertias.composite_link_2_hx * minus_screw_joint_2_vz;
    let inside_joint_2_mz_0 = inertias.composite_link_2_hx * screw_joint_2_vy;
    let inside_joint_2_mz_1 = inertias.composite_link_2_hy * minus_screw_joint_2_vx;
    let inside_joint_2_mx = inertias.composite_link_2_xx * poses.cos_joint_1
        - inertias.inside_joint_2_mx_0_1 - (inside_joint_2_mx_3 + inside_joint_2_mx_4);
    let inside_joint_2_my = inertias.composite_link_2_yy * poses.sin_joint_1
        - inertias.inside_joint_2_my_0_1 + (inside_joint_2_my_3 - inside_joint_2_my_4);
    let inside_joint_2_mz = inside_joint_2_mz_0 + inside_joint_2_mz_1
        - (inertias.inside_joint_2_mz_1_0 + inertias.inside_joint_2_mz_1_1);
    let inside_joint_2_fx = poses.sin_joint_1 * inertias.composite_link_2_hz
        - minus_screw_joint_2_vx * 20.0;
    let inside_joint_2_fy = screw_joint_2_vy * 20.0
        - poses.cos_joint_1 * inertias.composite_link_2_hz;
    let inside_joint_2_fz = poses.cos_joint_1 * inertias.composite_link_2_hy
        - poses.sin_joint_1 * inertias.composite_link_2_hx
        - minus_screw_joint_2_vz * 20.0;
    let outside_joint_2_mx_1_0 = complements.complement_link_2_hy
        * minus_screw_joint_2_vz;
    let outside_joint_2_mx_1_1 = complements.complement_link_2_hz * screw_joint_2_vy;
    let outside_joint_2_my_1_0 = complements.complement_link_2_hz
        * minus_screw_joint_2_vx;
    let outside_joint_2_my_1_1 = complements.minus_complement_link_2_hx
        * minus_screw_joint_2_vz;
    let outside_joint_2_mz_1_1 = complements.minus_complement_link_2_hx
        * screw_joint_2_vy;
    let outside_joint_2_mz_1_0 = complements.complement_link_2_hy
        * minus_screw_joint_2_vx;
    let connection_joint_2_wz_4 = inside_joint_2_my
        - inertias.locked_inverse_pivot_y_2 * inside_joint_2_mx;
    let connection_joint_2_wz = (inside_joint_2_mz
        - inertias.locked_inverse_pivot_z_2 * inside_joint_2_mx
        - inertias.locked_inverse_pivot_z_4 * connection_joint_2_wz_4)
        * inertias.locked_inverse_pivot_z;
    let connection_joint_2_wy = connection_joint_2_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * connection_joint_2_wz;
    let connection_joint_2_wx = inside_joint_2_mx * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * connection_joint_2_wy
        - inertias.locked_inverse_pivot_z_2 * connection_joint_2_wz;
    let connection_joint_2_vx = inside_joint_2_fx * 0.007692307692307693;
    let connection_joint_2_vy = inside_joint_2_fy * 0.007692307692307693;
    let connection_joint_2_vz = inside_joint_2_fz * 0.007692307692307693;
    // joint_3
    let minus_screw_joint_3_vx = poses.origin_link_3_z * poses.sin_joint_1;
    let screw_joint_3_vy = poses.origin_link_3_z * poses.cos_joint_1;
    let screw_joint_3_vz = poses.origin_link_3_x * poses.sin_joint_1
        - poses.origin_link_3_y * poses.cos_joint_1;
    let inside_joint_3_mx_3 = inertias.inertia_link_3_hy * screw_joint_3_vz;
    let inside_joint_3_mx_4 = inertias.inertia_link_3_hz * screw_joint_3_vy;
    let inside_joint_3_my_3 = inertias.inertia_link_3_hz * minus_screw_joint_3_vx;
    let inside_joint_3_my_4 = inertias.inertia_link_3_hx * screw_joint_3_vz;
    let inside_joint_3_mz_0 = inertias.inertia_link_3_hx * screw_joint_3_vy;
    let inside_joint_3_mz_1 = inertias.inertia_link_3_hy * minus_screw_joint_3_vx;
    let inside_joint_3_mx = inertias.inertia_link_3_xx * poses.cos_joint_1
        - inertias.inside_joint_3_mx_0_1 + (inside_joint_3_mx_3 - inside_joint_3_mx_4);
    let inside_joint_3_my = inertias.inertia_link_3_yy * poses.sin_joint_1
        - inertias.inside_joint_3_my_0_1 - (inside_joint_3_my_3 + inside_joint_3_my_4);
    let inside_joint_3_mz = inside_joint_3_mz_0 + inside_joint_3_mz_1
        - (inertias.inside_joint_3_mz_1_0 + inertias.inside_joint_3_mz_1_1);
    let inside_joint_3_fx = poses.sin_joint_1 * inertias.inertia_link_3_hz
        - minus_screw_joint_3_vx * 10.0;
    let inside_joint_3_fy = screw_joint_3_vy * 10.0
        - poses.cos_joint_1 * inertias.inertia_link_3_hz;
    let inside_joint_3_fz = screw_joint_3_vz * 10.0
        + (poses.cos_joint_1 * inertias.inertia_link_3_hy
            - poses.sin_joint_1 * inertias.inertia_link_3_hx);
    let connection_joint_3_wz_4 = inside_joint_3_my
        - inertias.locked_inverse_pivot_y_2 * inside_joint_3_mx;
    let connection_joint_3_wz = (inside_joint_3_mz
        - inertias.locked_inverse_pivot_z_2 * inside_joint_3_mx
        - inertias.locked_inverse_pivot_z_4 * connection_joint_3_wz_4)
        * inertias.locked_inverse_pivot_z;
    let connection_joint_3_wy = connection_joint_3_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * connection_joint_3_wz;
    let connection_joint_3_wx = inside_joint_3_mx * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * connection_joint_3_wy
        - inertias.locked_inverse_pivot_z_2 * connection_joint_3_wz;
    let connection_joint_3_vx = inside_joint_3_fx * 0.007692307692307693;
    let connection_joint_3_vy = inside_joint_3_fy * 0.007692307692307693;
    let connection_joint_3_vz = inside_joint_3_fz * 0.007692307692307693;
    Screws {
        inside_joint_1_mx,
        inside_joint_1_my,
        inside_joint_1_fx,
        inside_joint_1_fy,
        connection_joint_1_wz,
        connection_joint_1_wy,
        connection_joint_1_wx,
        connection_joint_1_vx,
        connection_joint_1_vy,
        minus_screw_joint_2_vx,
        screw_joint_2_vy,
        minus_screw_joint_2_vz,
        inside_joint_2_mx_3,
        inside_joint_2_mx_4,
        inside_joint_2_my_4,
        inside_joint_2_my_3,
        inside_joint_2_mz_0,
        inside_joint_2_mz_1,
        inside_joint_2_fx,
        inside_joint_2_fy,
        inside_joint_2_fz,
        outside_joint_2_mx_1_0,
        outside_joint_2_mx_1_1,
        outside_joint_2_my_1_0,
        outside_joint_2_my_1_1,
        outside_joint_2_mz_1_1,
        outside_joint_2_mz_1_0,
        connection_joint_2_wz,
        connection_joint_2_wy,
        connection_joint_2_wx,
        connection_joint_2_vx,
        connection_joint_2_vy,
        connection_joint_2_vz,
        minus_screw_joint_3_vx,
        screw_joint_3_vy,
        screw_joint_3_vz,
        inside_joint_3_mx_3,
        inside_joint_3_mx_4,
        inside_joint_3_my_3,
        inside_joint_3_my_4,
        inside_joint_3_mz_0,
        inside_joint_3_mz_1,
        inside_joint_3_mx,
        inside_joint_3_my,
        inside_joint_3_mz,
        inside_joint_3_fx,
        inside_joint_3_fy,
        inside_joint_3_fz,
        connection_joint_3_wz,
        connection_joint_3_wy,
        connection_joint_3_wx,
        connection_joint_3_vx,
        connection_joint_3_vy,
        connection_joint_3_vz,
    }
}
/// Momenta Iᵒ_j s_j of the screws outside the subtrees.
struct Outside {
    outside_joint_1_mx: f64,
    outside_joint_1_my: f64,
    outside_joint_1_mz: f64,
    outside_joint_2_mx: f64,
    outside_joint_2_my: f64,
    outside_joint_2_mz: f64,
    outside_joint_2_fx: f64,
    outside_joint_2_fy: f64,
    outside_joint_2_fz: f64,
    outside_joint_3_mx: f64,
    outside_joint_3_my: f64,
    outside_joint_3_mz: f64,
    outside_joint_3_fx: f64,
    outside_joint_3_fy: f64,
    outside_joint_3_fz: f64,
}
/// Momenta Iᵒ_j s_j of the screws outside the subtrees.
#[inline(never)]
fn outside(
    poses: &Poses,
    inertias: &Inertias,
    complements: &Complements,
    screws: &Screws,
) -> Outside {
    // joint_1
    let outside_joint_1_mx = inertias.minus_inertia_base_hz * poses.minus_origin_base_x
        - inertias.minus_inertia_base_xz;
    let outside_joint_1_my = inertias.inertia_base_yz
        - inertias.minus_inertia_base_hz * poses.origin_base_y;
    let outside_joint_1_mz = inertias.inertia_base_zz - inertias.inertia_base_zz_1;
    // joint_2
    let outside_joint_2_mx = complements.complement_link_2_xx * poses.cos_joint_1
        + complements.outside_joint_2_mx_0_1
        - (screws.outside_joint_2_mx_1_0 + screws.outside_joint_2_mx_1_1);
    let outside_joint_2_my = complements.outside_joint_2_my_0_0
        + complements.complement_link_2_yy * poses.sin_joint_1
        - (screws.outside_joint_2_my_1_0 + screws.outside_joint_2_my_1_1);
    let outside_joint_2_mz = complements.outside_joint_2_mz_0_0
        + complements.outside_joint_2_mz_0_1
        + (screws.outside_joint_2_mz_1_0 - screws.outside_joint_2_mz_1_1);
    let outside_joint_2_fx = poses.sin_joint_1 * complements.complement_link_2_hz
        - screws.minus_screw_joint_2_vx * 110.0;
    let outside_joint_2_fy = screws.screw_joint_2_vy * 110.0
        - poses.cos_joint_1 * complements.complement_link_2_hz;
    let outside_joint_2_fz = poses.cos_joint_1 * complements.complement_link_2_hy
        + poses.sin_joint_1 * complements.minus_complement_link_2_hx
        - screws.minus_screw_joint_2_vz * 110.0;
    // joint_3
    let outside_joint_3_mx = complements.complement_link_3_xx * poses.cos_joint_1
        + complements.complement_link_3_xy * poses.sin_joint_1
        + (complements.complement_link_3_hy * screws.screw_joint_3_vz
            - complements.complement_link_3_hz * screws.screw_joint_3_vy);
    let outside_joint_3_my = complements.complement_link_3_xy * poses.cos_joint_1
        + complements.complement_link_3_yy * poses.sin_joint_1
        - (complements.complement_link_3_hz * screws.minus_screw_joint_3_vx
            + complements.complement_link_3_hx * screws.screw_joint_3_vz);
    let outside_joint_3_mz = complements.complement_link_3_xz * poses.cos_joint_1
        + complements.complement_link_3_yz * poses.sin_joint_1
        + (complements.complement_link_3_hx * screws.screw_joint_3_vy
            + complements.complement_link_3_hy * screws.minus_screw_joint_3_vx);
    let outside_joint_3_fx = poses.sin_joint_1 * complements.complement_link_3_hz
        - screws.minus_screw_joint_3_vx * 120.0;
    let outside_joint_3_fy = screws.screw_joint_3_vy * 120.0
        - poses.cos_joint_1 * complements.complement_link_3_hz;
    let outside_joint_3_fz = screws.screw_joint_3_vz * 120.0
        + (poses.cos_joint_1 * complements.complement_link_3_hy
            - poses.sin_joint_1 * complements.complement_link_3_hx);
    Outside {
        outside_joint_1_mx,
        outside_joint_1_my,
        outside_joint_1_mz,
        outside_joint_2_mx,
        outside_joint_2_my,
        outside_joint_2_mz,
        outside_joint_2_fx,
        outside_joint_2_fy,
        outside_joint_2_fz,
        outside_joint_3_mx,
        outside_joint_3_my,
        outside_joint_3_mz,
        outside_joint_3_fx,
        outside_joint_3_fy,
        outside_joint_3_fz,
    }
}
/// How each joint moves its own subtree at zero momentum.
struct Reactions {
    reaction_joint_1_wz: f64,
    reaction_joint_1_wy: f64,
    reaction_joint_1_wx: f64,
    reaction_joint_2_wz: f64,
    reaction_joint_2_wy: f64,
    reaction_joint_2_wx: f64,
    reaction_joint_2_vx: f64,
    reaction_joint_2_vy: f64,
    reaction_joint_2_vz: f64,
    reaction_joint_3_wz: f64,
    reaction_joint_3_wy: f64,
    reaction_joint_3_wx: f64,
    reaction_joint_3_vx: f64,
    reaction_joint_3_vy: f64,
    reaction_joint_3_vz: f64,
}
/// How each joint moves its own subtree at zero momentum.
#[inline(never)]
fn reactions(inertias: &Inertias, outside: &Outside) -> Reactions {
    let reaction_joint_1_wz_4 = outside.outside_joint_1_my
        - inertias.locked_inverse_pivot_y_2 * outside.outside_joint_1_mx;
    // joint_1
    let reaction_joint_1_wz = (outside.outside_joint_1_mz
        - inertias.locked_inverse_pivot_z_2 * outside.outside_joint_1_mx
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_1_wz_4)
        * inertias.locked_inverse_pivot_z;
    let reaction_joint_1_wy = reaction_joint_1_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_1_wz;
    let reaction_joint_1_wx = outside.outside_joint_1_mx
        * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * reaction_joint_1_wy
        - inertias.locked_inverse_pivot_z_2 * reaction_joint_1_wz;
    let reaction_joint_2_wz_4 = outside.outside_joint_2_my
        - inertias.locked_inverse_pivot_y_2 * outside.outside_joint_2_mx;
    // joint_2
    let reaction_joint_2_wz = (outside.outside_joint_2_mz
        - inertias.locked_inverse_pivot_z_2 * outside.outside_joint_2_mx
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_2_wz_4)
        * inertias.locked_inverse_pivot_z;
    let reaction_joint_2_wy = reaction_joint_2_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_2_wz;
    let reaction_joint_2_wx = outside.outside_joint_2_mx
        * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * reaction_joint_2_wy
        - inertias.locked_inverse_pivot_z_2 * reaction_joint_2_wz;
    let reaction_joint_2_vx = outside.outside_joint_2_fx * 0.007692307692307693;
    let reaction_joint_2_vy = outside.outside_joint_2_fy * 0.007692307692307693;
    let reaction_joint_2_vz = outside.outside_joint_2_fz * 0.007692307692307693;
    let reaction_joint_3_wz_4 = outside.outside_joint_3_my
        - inertias.locked_inverse_pivot_y_2 * outside.outside_joint_3_mx;
    // joint_3
    let reaction_joint_3_wz = (outside.outside_joint_3_mz
        - inertias.locked_inverse_pivot_z_2 * outside.outside_joint_3_mx
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_3_wz_4)
        * inertias.locked_inverse_pivot_z;
    let reaction_joint_3_wy = reaction_joint_3_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_3_wz;
    let reaction_joint_3_wx = outside.outside_joint_3_mx
        * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * reaction_joint_3_wy
        - inertias.locked_inverse_pivot_z_2 * reaction_joint_3_wz;
    let reaction_joint_3_vx = outside.outside_joint_3_fx * 0.007692307692307693;
    let reaction_joint_3_vy = outside.outside_joint_3_fy * 0.007692307692307693;
    let reaction_joint_3_vz = outside.outside_joint_3_fz * 0.007692307692307693;
    Reactions {
        reaction_joint_1_wz,
        reaction_joint_1_wy,
        reaction_joint_1_wx,
        reaction_joint_2_wz,
        reaction_joint_2_wy,
        reaction_joint_2_wx,
        reaction_joint_2_vx,
        reaction_joint_2_vy,
        reaction_joint_2_vz,
        reaction_joint_3_wz,
        reaction_joint_3_wy,
        reaction_joint_3_wx,
        reaction_joint_3_vx,
        reaction_joint_3_vy,
        reaction_joint_3_vz,
    }
}
/// Velocities of the bodies at zero momentum.
struct Velocities {
    minus_velocity_base_wx: f64,
    minus_velocity_base_wy: f64,
    minus_velocity_base_wz: f64,
    minus_velocity_base_vx: f64,
    minus_velocity_base_vy: f64,
    minus_velocity_base_vz: f64,
    velocity_link_1_wz: f64,
    velocity_link_1_vx: f64,
    velocity_link_1_vy: f64,
    velocity_link_2_wx: f64,
    velocity_link_2_wy: f64,
    velocity_link_2_vx: f64,
    velocity_link_2_vy: f64,
    minus_velocity_link_2_vz: f64,
    velocity_link_3_wx: f64,
    velocity_link_3_wy: f64,
    velocity_link_3_vx: f64,
    velocity_link_3_vy: f64,
    velocity_link_3_vz: f64,
}
/// Velocities of the bodies at zero momentum.
#[inline(never)]
fn velocities(qd: &[f64; 3], poses: &Poses, screws: &Screws) -> Velocities {
    // base
    let minus_velocity_base_wx = screws.connection_joint_1_wx * qd[0]
        + screws.connection_joint_2_wx * qd[1] + screws.connection_joint_3_wx * qd[2];
    let minus_velocity_base_wy = screws.connection_joint_1_wy * qd[0]
        + screws.connection_joint_2_wy * qd[1] + screws.connection_joint_3_wy * qd[2];
    let minus_velocity_base_wz = screws.connection_joint_1_wz * qd[0]
        + screws.connection_joint_2_wz * qd[1] + screws.connection_joint_3_wz * qd[2];
    let minus_velocity_base_vx = screws.connection_joint_1_vx * qd[0]
        + screws.connection_joint_2_vx * qd[1] + screws.connection_joint_3_vx * qd[2];
    let minus_velocity_base_vy = screws.connection_joint_1_vy * qd[0]
        + screws.connection_joint_2_vy * qd[1] + screws.connection_joint_3_vy * qd[2];
    let minus_velocity_base_vz = screws.connection_joint_2_vz * qd[1]
        + screws.connection_joint_3_vz * qd[2];
    // link_1
    let velocity_link_1_wz = qd[0] - minus_velocity_base_wz;
    let velocity_link_1_vx = poses.origin_base_y * qd[0] - minus_velocity_base_vx;
    let velocity_link_1_vy = poses.minus_origin_base_x * qd[0] - minus_velocity_base_vy;
    // link_2
    let velocity_link_2_wx = poses.cos_joint_1 * qd[1] - minus_velocity_base_wx;
    let velocity_link_2_wy = poses.sin_joint_1 * qd[1] - minus_velocity_base_wy;
    let velocity_link_2_vx = velocity_link_1_vx - screws.minus_screw_joint_2_vx * qd[1];
    let velocity_link_2_vy = velocity_link_1_vy + screws.screw_joint_2_vy * qd[1];
    let minus_velocity_link_2_vz = minus_velocity_base_vz
        + screws.minus_screw_joint_2_vz * qd[1];
    // link_3
    let velocity_link_3_wx = velocity_link_2_wx + poses.cos_joint_1 * qd[2];
    let velocity_link_3_wy = velocity_link_2_wy + poses.sin_joint_1 * qd[2];
    let velocity_link_3_vx = velocity_link_2_vx - screws.minus_screw_joint_3_vx * qd[2];
    let velocity_link_3_vy = velocity_link_2_vy + screws.screw_joint_3_vy * qd[2];
    let velocity_link_3_vz = screws.screw_joint_3_vz * qd[2] - minus_velocity_link_2_vz;
    Velocities {
        minus_velocity_base_wx,
        minus_velocity_base_wy,
        minus_velocity_base_wz,
        minus_velocity_base_vx,
        minus_velocity_base_vy,
        minus_velocity_base_vz,
        velocity_link_1_wz,
        velocity_link_1_vx,
        velocity_link_1_vy,
        velocity_link_2_wx,
        velocity_link_2_wy,
        velocity_link_2_vx,
        velocity_link_2_vy,
        minus_velocity_link_2_vz,
        velocity_link_3_wx,
        velocity_link_3_wy,
        velocity_link_3_vx,
        velocity_link_3_vy,
        velocity_link_3_vz,
    }
}
/// What `coupling_torque`, `d_mu_xi` have in common.
struct CommonCouplingTorqueDMuXi {
    coupling_torque_0_26: f64,
    coupling_torque_0_28: f64,
    coupling_torque_0_21: f64,
    coupling_torque_0: f64,
    coupling_torque_1: f64,
    coupling_torque_2_11: f64,
    coupling_torque_2_13: f64,
    coupling_torque_2_6: f64,
    coupling_torque_2: f64,
}
/// What `coupling_torque`, `d_mu_xi` have in common.
#[inline(never)]
fn common_coupling_torque_d_mu_xi(
    mu: &[f64; 6],
    inertias: &Inertias,
    complements: &Complements,
    screws: &Screws,
    reactions: &Reactions,
) -> CommonCouplingTorqueDMuXi {
    let coupling_torque_0_11 = inertias.composite_link_1_xx * mu[0]
        + inertias.composite_link_1_xy * mu[1] + inertias.composite_link_1_xz * mu[2];
    let coupling_torque_0_13 = inertias.composite_link_1_xy * mu[0]
        + inertias.composite_link_1_yy * mu[1]
        - inertias.minus_composite_link_1_yz * mu[2];
    let coupling_torque_0_6 = inertias.composite_link_1_xz * mu[0]
        - inertias.minus_composite_link_1_yz * mu[1]
        + inertias.composite_link_1_zz * mu[2];
    let coupling_torque_0_26 = inertias.inertia_base_xx * mu[0]
        + inertias.inertia_base_xy * mu[1] - inertias.minus_inertia_base_xz * mu[2];
    let coupling_torque_0_28 = inertias.inertia_base_xy * mu[0]
        + inertias.inertia_base_yy * mu[1] + inertias.inertia_base_yz * mu[2];
    let coupling_torque_0_21 = inertias.inertia_base_yz * mu[1]
        - inertias.minus_inertia_base_xz * mu[0] + inertias.inertia_base_zz * mu[2];
    let coupling_torque_0_39 = mu[0] * inertias.inertia_base_hy
        + mu[1] * inertias.minus_inertia_base_hx;
    let coupling_torque_0 = reactions.reaction_joint_1_wx
        * (coupling_torque_0_13 * mu[2] - coupling_torque_0_6 * mu[1])
        + reactions.reaction_joint_1_wy
            * (coupling_torque_0_6 * mu[0] - coupling_torque_0_11 * mu[2])
        + reactions.reaction_joint_1_wz
            * (coupling_torque_0_11 * mu[1] - coupling_torque_0_13 * mu[0])
        - (screws.connection_joint_1_wx
            * (coupling_torque_0_28 * mu[2] - coupling_torque_0_21 * mu[1])
            + screws.connection_joint_1_wy
                * (coupling_torque_0_21 * mu[0] - coupling_torque_0_26 * mu[2])
            + screws.connection_joint_1_wz
                * (coupling_torque_0_26 * mu[1] - coupling_torque_0_28 * mu[0])
            + screws.connection_joint_1_vx
                * ((mu[0] * inertias.minus_inertia_base_hz
                    - mu[2] * inertias.minus_inertia_base_hx) * mu[2]
                    - coupling_torque_0_39 * mu[1])
            + screws.connection_joint_1_vy
                * (coupling_torque_0_39 * mu[0]
                    + (mu[1] * inertias.minus_inertia_base_hz
                        + mu[2] * inertias.inertia_base_hy) * mu[2]));
    let coupling_torque_1_11 = inertias.composite_link_2_xx * mu[0]
        - inertias.minus_composite_link_2_xy * mu[1]
        - inertias.minus_composite_link_2_xz * mu[2];
    let coupling_torque_1_13 = inertias.composite_link_2_yy * mu[1]
        - inertias.minus_composite_link_2_xy * mu[0]
        - inertias.minus_composite_link_2_yz * mu[2];
    let coupling_torque_1_6 = inertias.composite_link_2_zz * mu[2]
        - (inertias.minus_composite_link_2_xz * mu[0]
            + inertias.minus_composite_link_2_yz * mu[1]);
    let coupling_torque_1_26 = mu[1] * inertias.composite_link_2_hz
        - mu[2] * inertias.composite_link_2_hy;
    let coupling_torque_1_28 = mu[2] * inertias.composite_link_2_hx
        - mu[0] * inertias.composite_link_2_hz;
    let coupling_torque_1_21 = mu[0] * inertias.composite_link_2_hy
        - mu[1] * inertias.composite_link_2_hx;
    let coupling_torque_1_41 = complements.complement_link_2_xx * mu[0]
        + complements.complement_link_2_xy * mu[1]
        + complements.complement_link_2_xz * mu[2];
    let coupling_torque_1_43 = complements.complement_link_2_xy * mu[0]
        + complements.complement_link_2_yy * mu[1]
        + complements.complement_link_2_yz * mu[2];
    let coupling_torque_1_36 = complements.complement_link_2_xz * mu[0]
        + complements.complement_link_2_yz * mu[1]
        + complements.complement_link_2_zz * mu[2];
    let coupling_torque_1_56 = mu[1] * complements.complement_link_2_hz
        - mu[2] * complements.complement_link_2_hy;
    let coupling_torque_1_58 = mu[2] * complements.minus_complement_link_2_hx
        + mu[0] * complements.complement_link_2_hz;
    let coupling_torque_1_51 = mu[0] * complements.complement_link_2_hy
        + mu[1] * complements.minus_complement_link_2_hx;
    let coupling_torque_1 = reactions.reaction_joint_2_wx
        * (coupling_torque_1_13 * mu[2] - coupling_torque_1_6 * mu[1])
        + reactions.reaction_joint_2_wy
            * (coupling_torque_1_6 * mu[0] - coupling_torque_1_11 * mu[2])
        + reactions.reaction_joint_2_wz
            * (coupling_torque_1_11 * mu[1] - coupling_torque_1_13 * mu[0])
        + reactions.reaction_joint_2_vx
            * (coupling_torque_1_28 * mu[2] - coupling_torque_1_21 * mu[1])
        + reactions.reaction_joint_2_vy
            * (coupling_torque_1_21 * mu[0] - coupling_torque_1_26 * mu[2])
        + reactions.reaction_joint_2_vz
            * (coupling_torque_1_26 * mu[1] - coupling_torque_1_28 * mu[0])
        - (screws.connection_joint_2_wx
            * (coupling_torque_1_43 * mu[2] - coupling_torque_1_36 * mu[1])
            + screws.connection_joint_2_wy
                * (coupling_torque_1_36 * mu[0] - coupling_torque_1_41 * mu[2])
            + screws.connection_joint_2_wz
                * (coupling_torque_1_41 * mu[1] - coupling_torque_1_43 * mu[0])
            - screws.connection_joint_2_vx
                * (coupling_torque_1_58 * mu[2] + coupling_torque_1_51 * mu[1])
            + screws.connection_joint_2_vy
                * (coupling_torque_1_51 * mu[0] - coupling_torque_1_56 * mu[2])
            + screws.connection_joint_2_vz
                * (coupling_torque_1_56 * mu[1] + coupling_torque_1_58 * mu[0]));
    let coupling_torque_2_11 = inertias.inertia_link_3_xx * mu[0]
        - inertias.minus_inertia_link_3_xy * mu[1]
        - inertias.minus_inertia_link_3_xz * mu[2];
    let coupling_torque_2_13 = inertias.inertia_link_3_yy * mu[1]
        - inertias.minus_inertia_link_3_xy * mu[0]
        - inertias.minus_inertia_link_3_yz * mu[2];
    let coupling_torque_2_6 = inertias.inertia_link_3_zz * mu[2]
        - (inertias.minus_inertia_link_3_xz * mu[0]
            + inertias.minus_inertia_link_3_yz * mu[1]);
    let coupling_torque_2_26 = mu[1] * inertias.inertia_link_3_hz
        - mu[2] * inertias.inertia_link_3_hy;
    let coupling_torque_2_28 = mu[2] * inertias.inertia_link_3_hx
        - mu[0] * inertias.inertia_link_3_hz;
    let coupling_torque_2_21 = mu[0] * inertias.inertia_link_3_hy
        - mu[1] * inertias.inertia_link_3_hx;
    let coupling_torque_2_41 = complements.complement_link_3_xx * mu[0]
        + complements.complement_link_3_xy * mu[1]
        + complements.complement_link_3_xz * mu[2];
    let coupling_torque_2_43 = complements.complement_link_3_xy * mu[0]
        + complements.complement_link_3_yy * mu[1]
        + complements.complement_link_3_yz * mu[2];
    let coupling_torque_2_36 = complements.complement_link_3_xz * mu[0]
        + complements.complement_link_3_yz * mu[1]
        + complements.complement_link_3_zz * mu[2];
    let coupling_torque_2_56 = mu[1] * complements.complement_link_3_hz
        - mu[2] * complements.complement_link_3_hy;
    let coupling_torque_2_58 = mu[2] * complements.complement_link_3_hx
        - mu[0] * complements.complement_link_3_hz;
    let coupling_torque_2_51 = mu[0] * complements.complement_link_3_hy
        - mu[1] * complements.complement_link_3_hx;
    let coupling_torque_2 = reactions.reaction_joint_3_wx
        * (coupling_torque_2_13 * mu[2] - coupling_torque_2_6 * mu[1])
        + reactions.reaction_joint_3_wy
            * (coupling_torque_2_6 * mu[0] - coupling_torque_2_11 * mu[2])
        + reactions.reaction_joint_3_wz
            * (coupling_torque_2_11 * mu[1] - coupling_torque_2_13 * mu[0])
        + reactions.reaction_joint_3_vx
            * (coupling_torque_2_28 * mu[2] - coupling_torque_2_21 * mu[1])
        + reactions.reaction_joint_3_vy
            * (coupling_torque_2_21 * mu[0] - coupling_torque_2_26 * mu[2])
        + reactions.reaction_joint_3_vz
            * (coupling_torque_2_26 * mu[1] - coupling_torque_2_28 * mu[0])
        - (screws.connection_joint_3_wx
            * (coupling_torque_2_43 * mu[2] - coupling_torque_2_36 * mu[1])
            + screws.connection_joint_3_wy
                * (coupling_torque_2_36 * mu[0] - coupling_torque_2_41 * mu[2])
            + screws.connection_joint_3_wz
                * (coupling_torque_2_41 * mu[1] - coupling_torque_2_43 * mu[0])
            + screws.connection_joint_3_vx
                * (coupling_torque_2_58 * mu[2] - coupling_torque_2_51 * mu[1])
            + screws.connection_joint_3_vy
                * (coupling_torque_2_51 * mu[0] - coupling_torque_2_56 * mu[2])
            + screws.connection_joint_3_vz
                * (coupling_torque_2_56 * mu[1] - coupling_torque_2_58 * mu[0]));
    CommonCouplingTorqueDMuXi {
        coupling_torque_0_26,
        coupling_torque_0_28,
        coupling_torque_0_21,
        coupling_torque_0,
        coupling_torque_1,
        coupling_torque_2_11,
        coupling_torque_2_13,
        coupling_torque_2_6,
        coupling_torque_2,
    }
}
/// What `forward_dynamics`, `inverse_dynamics` have in common.
struct CommonForwardDynamicsInverseDynamics {
    wrench_link_3_mx_0_0_0_0_1_0_0: f64,
    wrench_link_3_mx_0_0_0_1_1_0_1: f64,
    wrench_link_3_my_0_1_0_1_0_0: f64,
    wrench_link_3_mx_0_1_1_1_0_0: f64,
    wrench_link_3_mx_0_1_0_1_0_0: f64,
    wrench_link_3_mx_0_0_0_0_1_0_1: f64,
    wrench_link_3_mx_0_0_0_1_1_0_0: f64,
    wrench_link_3_mx_0_0_1_1_0: f64,
    wrench_link_3_my_0_1_0_1_0_1: f64,
    wrench_link_3_mx_0_1_1_1_0_1: f64,
    wrench_link_3_mx_0_1_0_1_0_1: f64,
    wrench_link_3_mx_0_0_0_0_1_1: f64,
    wrench_link_3_mx_0_0_0_1_1_1: f64,
    wrench_link_3_mx_0_0_1_1_1: f64,
    wrench_link_3_my_0_1_0_1_1: f64,
    wrench_link_3_mx_0_1_1_1_1: f64,
    wrench_link_3_mx_0_1_0_1_1: f64,
    wrench_base_mx_1_0: f64,
    wrench_base_my_1_0: f64,
    wrench_base_mz_1_0: f64,
    wrench_base_fx_1_0: f64,
    wrench_base_fy_1_0: f64,
    wrench_base_fz_0_0: f64,
    wrench_link_1_mx_0_1: f64,
    wrench_link_1_my_0_1: f64,
    wrench_link_1_mz_0_1: f64,
    wrench_link_1_fx_0_1: f64,
    wrench_link_1_fy_0_1: f64,
    wrench_link_1_fz_0_1: f64,
    wrench_link_2_mx_0_1: f64,
    wrench_link_2_my_0_1: f64,
    wrench_link_2_mz_0_1: f64,
    wrench_link_2_fx_0_1: f64,
    wrench_link_2_fy_0_1: f64,
    wrench_link_2_fz_0_1: f64,
    wrench_link_3_mx_1: f64,
    wrench_link_3_my_1: f64,
    wrench_link_3_mz_1: f64,
    wrench_link_3_fx_1: f64,
    wrench_link_3_fy_1: f64,
    wrench_link_3_fz_1: f64,
}
/// What `forward_dynamics`, `inverse_dynamics` have in common.
#[inline(never)]
fn common_forward_dynamics_inverse_dynamics(
    mu: &[f64; 6],
    qd: &[f64; 3],
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    velocities: &Velocities,
) -> CommonForwardDynamicsInverseDynamics {
    let wrench_link_3_mx_0_0_0_1_1_0_1_0 = mu[0] - velocities.minus_velocity_base_wx;
    let wrench_link_3_mx_0_0_0_0_1_0_0_0 = mu[1] - velocities.minus_velocity_base_wy;
    let wrench_base_my_1_0_2_5 = mu[2] - velocities.minus_velocity_base_wz;
    let wrench_link_3_my_0_1_0_1_0_0_1 = velocities.velocity_link_1_wz + mu[2];
    let wrench_link_3_mx_0_0_0_0_1_0_0 = wrench_link_3_mx_0_0_0_0_1_0_0_0 * qd[0];
    let wrench_link_3_mx_0_0_0_1_1_0_1 = wrench_link_3_mx_0_0_0_1_1_0_1_0 * qd[0];
    let wrench_link_3_my_0_1_0_1_0_0 = (velocities.velocity_link_1_vy
        - wrench_link_3_my_0_1_0_1_0_0_1 * poses.minus_origin_base_x) * qd[0];
    let wrench_link_3_mx_0_1_1_1_0_0 = (wrench_link_3_my_0_1_0_1_0_0_1
        * poses.origin_base_y - velocities.velocity_link_1_vx) * qd[0];
    let wrench_link_3_mx_0_1_0_1_0_0 = (wrench_link_3_mx_0_0_0_1_1_0_1_0
        * poses.minus_origin_base_x
        - wrench_link_3_mx_0_0_0_0_1_0_0_0 * poses.origin_base_y) * qd[0];
    let wrench_link_3_mx_0_0_1_1_0_0 = velocities.velocity_link_2_wx + mu[0];
    let wrench_link_3_mx_0_0_1_1_0_2 = velocities.velocity_link_2_wy + mu[1];
    let wrench_link_3_mx_0_0_0_0_1_0_1_0 = wrench_link_3_my_0_1_0_1_0_0_1
        * poses.sin_joint_1;
    let wrench_link_3_mx_0_0_0_1_1_0_0_0 = wrench_link_3_my_0_1_0_1_0_0_1
        * poses.cos_joint_1;
    let wrench_link_3_mx_0_0_0_0_1_0_1 = wrench_link_3_mx_0_0_0_0_1_0_1_0 * qd[1];
    let wrench_link_3_mx_0_0_0_1_1_0_0 = wrench_link_3_mx_0_0_0_1_1_0_0_0 * qd[1];
    let wrench_link_3_mx_0_0_1_1_0 = (wrench_link_3_mx_0_0_1_1_0_0 * poses.sin_joint_1
        - wrench_link_3_mx_0_0_1_1_0_2 * poses.cos_joint_1) * qd[1];
    let wrench_link_3_my_0_1_0_1_0_1 = (velocities.minus_velocity_link_2_vz
        * poses.sin_joint_1
        - (wrench_link_3_mx_0_0_1_1_0_2 * screws.minus_screw_joint_2_vz
            + wrench_link_3_my_0_1_0_1_0_0_1 * screws.screw_joint_2_vy)) * qd[1];
    let wrench_link_3_mx_0_1_1_1_0_1 = (wrench_link_3_mx_0_0_1_1_0_0
        * screws.minus_screw_joint_2_vz
        - wrench_link_3_my_0_1_0_1_0_0_1 * screws.minus_screw_joint_2_vx
        - velocities.minus_velocity_link_2_vz * poses.cos_joint_1) * qd[1];
    let wrench_link_3_mx_0_1_0_1_0_1 = (wrench_link_3_mx_0_0_1_1_0_0
        * screws.screw_joint_2_vy
        + wrench_link_3_mx_0_0_1_1_0_2 * screws.minus_screw_joint_2_vx
        + (velocities.velocity_link_2_vx * poses.sin_joint_1
            - velocities.velocity_link_2_vy * poses.cos_joint_1)) * qd[1];
    let wrench_link_3_mx_0_0_1_1_1_0 = velocities.velocity_link_3_wx + mu[0];
    let wrench_link_3_mx_0_0_1_1_1_2 = velocities.velocity_link_3_wy + mu[1];
    let wrench_link_3_mx_0_0_0_0_1_1 = wrench_link_3_mx_0_0_0_0_1_0_1_0 * qd[2];
    let wrench_link_3_mx_0_0_0_1_1_1 = wrench_link_3_mx_0_0_0_1_1_0_0_0 * qd[2];
    let wrench_link_3_mx_0_0_1_1_1 = (wrench_link_3_mx_0_0_1_1_1_0 * poses.sin_joint_1
        - wrench_link_3_mx_0_0_1_1_1_2 * poses.cos_joint_1) * qd[2];
    let wrench_link_3_my_0_1_0_1_1 = (wrench_link_3_mx_0_0_1_1_1_2
        * screws.screw_joint_3_vz
        - wrench_link_3_my_0_1_0_1_0_0_1 * screws.screw_joint_3_vy
        - velocities.velocity_link_3_vz * poses.sin_joint_1) * qd[2];
    let wrench_link_3_mx_0_1_1_1_1 = (velocities.velocity_link_3_vz * poses.cos_joint_1
        - (wrench_link_3_my_0_1_0_1_0_0_1 * screws.minus_screw_joint_3_vx
            + wrench_link_3_mx_0_0_1_1_1_0 * screws.screw_joint_3_vz)) * qd[2];
    let wrench_link_3_mx_0_1_0_1_1 = (wrench_link_3_mx_0_0_1_1_1_0
        * screws.screw_joint_3_vy
        + wrench_link_3_mx_0_0_1_1_1_2 * screws.minus_screw_joint_3_vx
        + (velocities.velocity_link_3_vx * poses.sin_joint_1
            - velocities.velocity_link_3_vy * poses.cos_joint_1)) * qd[2];
    let wrench_base_my_1_0_2 = inertias.inertia_base_xx
        * wrench_link_3_mx_0_0_0_1_1_0_1_0
        + inertias.inertia_base_xy * wrench_link_3_mx_0_0_0_0_1_0_0_0
        - inertias.minus_inertia_base_xz * wrench_base_my_1_0_2_5
        - (velocities.minus_velocity_base_vz * inertias.inertia_base_hy
            + velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hz);
    let wrench_base_mx_1_0_0 = inertias.inertia_base_xy
        * wrench_link_3_mx_0_0_0_1_1_0_1_0
        + inertias.inertia_base_yy * wrench_link_3_mx_0_0_0_0_1_0_0_0
        + inertias.inertia_base_yz * wrench_base_my_1_0_2_5
        + (velocities.minus_velocity_base_vx * inertias.minus_inertia_base_hz
            - velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hx);
    let wrench_base_mx_1_0_2 = inertias.inertia_base_yz
        * wrench_link_3_mx_0_0_0_0_1_0_0_0
        - inertias.minus_inertia_base_xz * wrench_link_3_mx_0_0_0_1_1_0_1_0
        + inertias.inertia_base_zz * wrench_base_my_1_0_2_5
        + (velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hx
            + velocities.minus_velocity_base_vx * inertias.inertia_base_hy);
    let wrench_base_my_1_0_6 = velocities.minus_velocity_base_vx * 105.0
        + (wrench_link_3_mx_0_0_0_0_1_0_0_0 * inertias.minus_inertia_base_hz
            + wrench_base_my_1_0_2_5 * inertias.inertia_base_hy);
    let wrench_base_mx_1_0_6 = wrench_link_3_mx_0_0_0_1_1_0_1_0
        * inertias.minus_inertia_base_hz
        - wrench_base_my_1_0_2_5 * inertias.minus_inertia_base_hx
        - velocities.minus_velocity_base_vy * 105.0;
    let wrench_base_mx_1_0_4 = wrench_link_3_mx_0_0_0_1_1_0_1_0
        * inertias.inertia_base_hy
        + wrench_link_3_mx_0_0_0_0_1_0_0_0 * inertias.minus_inertia_base_hx
        - velocities.minus_velocity_base_vz * 105.0;
    let wrench_base_mx_1_0 = wrench_base_mx_1_0_0 * wrench_base_my_1_0_2_5
        - wrench_base_mx_1_0_2 * wrench_link_3_mx_0_0_0_0_1_0_0_0
        + (wrench_base_mx_1_0_4 * velocities.minus_velocity_base_vy
            - wrench_base_mx_1_0_6 * velocities.minus_velocity_base_vz);
    let wrench_base_my_1_0 = wrench_base_mx_1_0_2 * wrench_link_3_mx_0_0_0_1_1_0_1_0
        - wrench_base_my_1_0_2 * wrench_base_my_1_0_2_5
        - (wrench_base_mx_1_0_4 * velocities.minus_velocity_base_vx
            + wrench_base_my_1_0_6 * velocities.minus_velocity_base_vz);
    let wrench_base_mz_1_0 = wrench_base_my_1_0_2 * wrench_link_3_mx_0_0_0_0_1_0_0_0
        - wrench_base_mx_1_0_0 * wrench_link_3_mx_0_0_0_1_1_0_1_0
        + (wrench_base_my_1_0_6 * velocities.minus_velocity_base_vy
            + wrench_base_mx_1_0_6 * velocities.minus_velocity_base_vx);
    let wrench_base_fx_1_0 = wrench_base_mx_1_0_6 * wrench_base_my_1_0_2_5
        - wrench_base_mx_1_0_4 * wrench_link_3_mx_0_0_0_0_1_0_0_0;
    let wrench_base_fy_1_0 = wrench_base_mx_1_0_4 * wrench_link_3_mx_0_0_0_1_1_0_1_0
        + wrench_base_my_1_0_6 * wrench_base_my_1_0_2_5;
    let wrench_base_fz_0_0 = wrench_base_my_1_0_6 * wrench_link_3_mx_0_0_0_0_1_0_0_0
        + wrench_base_mx_1_0_6 * wrench_link_3_mx_0_0_0_1_1_0_1_0;
    let wrench_link_1_my_0_1_2 = inertias.inertia_link_1_xx
        * wrench_link_3_mx_0_0_0_1_1_0_1_0
        + inertias.inertia_link_1_xy * wrench_link_3_mx_0_0_0_0_1_0_0_0
        + inertias.inertia_link_1_xz * wrench_link_3_my_0_1_0_1_0_0_1
        - (velocities.minus_velocity_base_vz * inertias.inertia_link_1_hy
            + velocities.velocity_link_1_vy * inertias.inertia_link_1_hz);
    let wrench_link_1_mx_0_1_0 = inertias.inertia_link_1_xy
        * wrench_link_3_mx_0_0_0_1_1_0_1_0
        + inertias.inertia_link_1_yy * wrench_link_3_mx_0_0_0_0_1_0_0_0
        - inertias.minus_inertia_link_1_yz * wrench_link_3_my_0_1_0_1_0_0_1
        + (velocities.velocity_link_1_vx * inertias.inertia_link_1_hz
            - velocities.minus_velocity_base_vz * inertias.minus_inertia_link_1_hx);
    let wrench_link_1_mx_0_1_2 = inertias.inertia_link_1_xz
        * wrench_link_3_mx_0_0_0_1_1_0_1_0
        - inertias.minus_inertia_link_1_yz * wrench_link_3_mx_0_0_0_0_1_0_0_0
        + inertias.inertia_link_1_zz * wrench_link_3_my_0_1_0_1_0_0_1
        - (velocities.velocity_link_1_vy * inertias.minus_inertia_link_1_hx
            + velocities.velocity_link_1_vx * inertias.inertia_link_1_hy);
    let wrench_link_1_my_0_1_6 = velocities.velocity_link_1_vx * 5.0
        + (wrench_link_3_mx_0_0_0_0_1_0_0_0 * inertias.inertia_link_1_hz
            - wrench_link_3_my_0_1_0_1_0_0_1 * inertias.inertia_link_1_hy);
    let wrench_link_1_mx_0_1_4 = velocities.velocity_link_1_vy * 5.0
        - (wrench_link_3_my_0_1_0_1_0_0_1 * inertias.minus_inertia_link_1_hx
            + wrench_link_3_mx_0_0_0_1_1_0_1_0 * inertias.inertia_link_1_hz);
    let wrench_link_1_mx_0_1_6 = wrench_link_3_mx_0_0_0_1_1_0_1_0
        * inertias.inertia_link_1_hy
        + wrench_link_3_mx_0_0_0_0_1_0_0_0 * inertias.minus_inertia_link_1_hx
        - velocities.minus_velocity_base_vz * 5.0;
    let wrench_link_1_mx_0_1 = wrench_link_1_mx_0_1_0 * wrench_link_3_my_0_1_0_1_0_0_1
        - wrench_link_1_mx_0_1_2 * wrench_link_3_mx_0_0_0_0_1_0_0_0
        - (wrench_link_1_mx_0_1_4 * velocities.minus_velocity_base_vz
            + wrench_link_1_mx_0_1_6 * velocities.velocity_link_1_vy);
    let wrench_link_1_my_0_1 = wrench_link_1_mx_0_1_2 * wrench_link_3_mx_0_0_0_1_1_0_1_0
        - wrench_link_1_my_0_1_2 * wrench_link_3_my_0_1_0_1_0_0_1
        + (wrench_link_1_mx_0_1_6 * velocities.velocity_link_1_vx
            + wrench_link_1_my_0_1_6 * velocities.minus_velocity_base_vz);
    let wrench_link_1_mz_0_1 = wrench_link_1_my_0_1_2 * wrench_link_3_mx_0_0_0_0_1_0_0_0
        - wrench_link_1_mx_0_1_0 * wrench_link_3_mx_0_0_0_1_1_0_1_0
        + (wrench_link_1_my_0_1_6 * velocities.velocity_link_1_vy
            - wrench_link_1_mx_0_1_4 * velocities.velocity_link_1_vx);
    let wrench_link_1_fx_0_1 = wrench_link_1_mx_0_1_4 * wrench_link_3_my_0_1_0_1_0_0_1
        - wrench_link_1_mx_0_1_6 * wrench_link_3_mx_0_0_0_0_1_0_0_0;
    let wrench_link_1_fy_0_1 = wrench_link_1_mx_0_1_6 * wrench_link_3_mx_0_0_0_1_1_0_1_0
        - wrench_link_1_my_0_1_6 * wrench_link_3_my_0_1_0_1_0_0_1;
    let wrench_link_1_fz_0_1 = wrench_link_1_my_0_1_6 * wrench_link_3_mx_0_0_0_0_1_0_0_0
        - wrench_link_1_mx_0_1_4 * wrench_link_3_mx_0_0_0_1_1_0_1_0;
    let wrench_link_2_my_0_1_2 = inertias.inertia_link_2_xx
        * wrench_link_3_mx_0_0_1_1_0_0
        - inertias.minus_inertia_link_2_xy * wrench_link_3_mx_0_0_1_1_0_2
        - inertias.minus_inertia_link_2_xz * wrench_link_3_my_0_1_0_1_0_0_1
        - (velocities.minus_velocity_link_2_vz * inertias.inertia_link_2_hy
            + velocities.velocity_link_2_vy * inertias.inertia_link_2_hz);
    let wrench_link_2_mx_0_1_0 = inertias.inertia_link_2_yy
        * wrench_link_3_mx_0_0_1_1_0_2
        - inertias.minus_inertia_link_2_xy * wrench_link_3_mx_0_0_1_1_0_0
        - inertias.minus_inertia_link_2_yz * wrench_link_3_my_0_1_0_1_0_0_1
        + (velocities.velocity_link_2_vx * inertias.inertia_link_2_hz
            + velocities.minus_velocity_link_2_vz * inertias.inertia_link_2_hx);
    let wrench_link_2_mx_0_1_2 = inertias.inertia_link_2_zz
        * wrench_link_3_my_0_1_0_1_0_0_1
        - (inertias.minus_inertia_link_2_xz * wrench_link_3_mx_0_0_1_1_0_0
            + inertias.minus_inertia_link_2_yz * wrench_link_3_mx_0_0_1_1_0_2)
        + (velocities.velocity_link_2_vy * inertias.inertia_link_2_hx
            - velocities.velocity_link_2_vx * inertias.inertia_link_2_hy);
    let wrench_link_2_my_0_1_6 = velocities.velocity_link_2_vx * 10.0
        + (wrench_link_3_mx_0_0_1_1_0_2 * inertias.inertia_link_2_hz
            - wrench_link_3_my_0_1_0_1_0_0_1 * inertias.inertia_link_2_hy);
    let wrench_link_2_mx_0_1_4 = velocities.velocity_link_2_vy * 10.0
        + (wrench_link_3_my_0_1_0_1_0_0_1 * inertias.inertia_link_2_hx
            - wrench_link_3_mx_0_0_1_1_0_0 * inertias.inertia_link_2_hz);
    let wrench_link_2_mx_0_1_6 = wrench_link_3_mx_0_0_1_1_0_0
        * inertias.inertia_link_2_hy
        - wrench_link_3_mx_0_0_1_1_0_2 * inertias.inertia_link_2_hx
        - velocities.minus_velocity_link_2_vz * 10.0;
    let wrench_link_2_mx_0_1 = wrench_link_2_mx_0_1_0 * wrench_link_3_my_0_1_0_1_0_0_1
        - wrench_link_2_mx_0_1_2 * wrench_link_3_mx_0_0_1_1_0_2
        - (wrench_link_2_mx_0_1_4 * velocities.minus_velocity_link_2_vz
            + wrench_link_2_mx_0_1_6 * velocities.velocity_link_2_vy);
    let wrench_link_2_my_0_1 = wrench_link_2_mx_0_1_2 * wrench_link_3_mx_0_0_1_1_0_0
        - wrench_link_2_my_0_1_2 * wrench_link_3_my_0_1_0_1_0_0_1
        + (wrench_link_2_mx_0_1_6 * velocities.velocity_link_2_vx
            + wrench_link_2_my_0_1_6 * velocities.minus_velocity_link_2_vz);
    let wrench_link_2_mz_0_1 = wrench_link_2_my_0_1_2 * wrench_link_3_mx_0_0_1_1_0_2
        - wrench_link_2_mx_0_1_0 * wrench_link_3_mx_0_0_1_1_0_0
        + (wrench_link_2_my_0_1_6 * velocities.velocity_link_2_vy
            - wrench_link_2_mx_0_1_4 * velocities.velocity_link_2_vx);
    let wrench_link_2_fx_0_1 = wrench_link_2_mx_0_1_4 * wrench_link_3_my_0_1_0_1_0_0_1
        - wrench_link_2_mx_0_1_6 * wrench_link_3_mx_0_0_1_1_0_2;
    let wrench_link_2_fy_0_1 = wrench_link_2_mx_0_1_6 * wrench_link_3_mx_0_0_1_1_0_0
        - wrench_link_2_my_0_1_6 * wrench_link_3_my_0_1_0_1_0_0_1;
    let wrench_link_2_fz_0_1 = wrench_link_2_my_0_1_6 * wrench_link_3_mx_0_0_1_1_0_2
        - wrench_link_2_mx_0_1_4 * wrench_link_3_mx_0_0_1_1_0_0;
    let wrench_link_3_my_1_2 = inertias.inertia_link_3_xx * wrench_link_3_mx_0_0_1_1_1_0
        - inertias.minus_inertia_link_3_xy * wrench_link_3_mx_0_0_1_1_1_2
        - inertias.minus_inertia_link_3_xz * wrench_link_3_my_0_1_0_1_0_0_1
        + (velocities.velocity_link_3_vz * inertias.inertia_link_3_hy
            - velocities.velocity_link_3_vy * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_1_0 = inertias.inertia_link_3_yy * wrench_link_3_mx_0_0_1_1_1_2
        - inertias.minus_inertia_link_3_xy * wrench_link_3_mx_0_0_1_1_1_0
        - inertias.minus_inertia_link_3_yz * wrench_link_3_my_0_1_0_1_0_0_1
        + (velocities.velocity_link_3_vx * inertias.inertia_link_3_hz
            - velocities.velocity_link_3_vz * inertias.inertia_link_3_hx);
    let wrench_link_3_mx_1_2 = inertias.inertia_link_3_zz
        * wrench_link_3_my_0_1_0_1_0_0_1
        - (inertias.minus_inertia_link_3_xz * wrench_link_3_mx_0_0_1_1_1_0
            + inertias.minus_inertia_link_3_yz * wrench_link_3_mx_0_0_1_1_1_2)
        + (velocities.velocity_link_3_vy * inertias.inertia_link_3_hx
            - velocities.velocity_link_3_vx * inertias.inertia_link_3_hy);
    let wrench_link_3_my_1_6 = velocities.velocity_link_3_vx * 10.0
        + (wrench_link_3_mx_0_0_1_1_1_2 * inertias.inertia_link_3_hz
            - wrench_link_3_my_0_1_0_1_0_0_1 * inertias.inertia_link_3_hy);
    let wrench_link_3_mx_1_4 = velocities.velocity_link_3_vy * 10.0
        + (wrench_link_3_my_0_1_0_1_0_0_1 * inertias.inertia_link_3_hx
            - wrench_link_3_mx_0_0_1_1_1_0 * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_1_6 = velocities.velocity_link_3_vz * 10.0
        + (wrench_link_3_mx_0_0_1_1_1_0 * inertias.inertia_link_3_hy
            - wrench_link_3_mx_0_0_1_1_1_2 * inertias.inertia_link_3_hx);
    let wrench_link_3_mx_1 = wrench_link_3_mx_1_0 * wrench_link_3_my_0_1_0_1_0_0_1
        - wrench_link_3_mx_1_2 * wrench_link_3_mx_0_0_1_1_1_2
        + (wrench_link_3_mx_1_4 * velocities.velocity_link_3_vz
            - wrench_link_3_mx_1_6 * velocities.velocity_link_3_vy);
    let wrench_link_3_my_1 = wrench_link_3_mx_1_2 * wrench_link_3_mx_0_0_1_1_1_0
        - wrench_link_3_my_1_2 * wrench_link_3_my_0_1_0_1_0_0_1
        + (wrench_link_3_mx_1_6 * velocities.velocity_link_3_vx
            - wrench_link_3_my_1_6 * velocities.velocity_link_3_vz);
    let wrench_link_3_mz_1 = wrench_link_3_my_1_2 * wrench_link_3_mx_0_0_1_1_1_2
        - wrench_link_3_mx_1_0 * wrench_link_3_mx_0_0_1_1_1_0
        + (wrench_link_3_my_1_6 * velocities.velocity_link_3_vy
            - wrench_link_3_mx_1_4 * velocities.velocity_link_3_vx);
    let wrench_link_3_fx_1 = wrench_link_3_mx_1_4 * wrench_link_3_my_0_1_0_1_0_0_1
        - wrench_link_3_mx_1_6 * wrench_link_3_mx_0_0_1_1_1_2;
    let wrench_link_3_fy_1 = wrench_link_3_mx_1_6 * wrench_link_3_mx_0_0_1_1_1_0
        - wrench_link_3_my_1_6 * wrench_link_3_my_0_1_0_1_0_0_1;
    let wrench_link_3_fz_1 = wrench_link_3_my_1_6 * wrench_link_3_mx_0_0_1_1_1_2
        - wrench_link_3_mx_1_4 * wrench_link_3_mx_0_0_1_1_1_0;
    CommonForwardDynamicsInverseDynamics {
        wrench_link_3_mx_0_0_0_0_1_0_0,
        wrench_link_3_mx_0_0_0_1_1_0_1,
        wrench_link_3_my_0_1_0_1_0_0,
        wrench_link_3_mx_0_1_1_1_0_0,
        wrench_link_3_mx_0_1_0_1_0_0,
        wrench_link_3_mx_0_0_0_0_1_0_1,
        wrench_link_3_mx_0_0_0_1_1_0_0,
        wrench_link_3_mx_0_0_1_1_0,
        wrench_link_3_my_0_1_0_1_0_1,
        wrench_link_3_mx_0_1_1_1_0_1,
        wrench_link_3_mx_0_1_0_1_0_1,
        wrench_link_3_mx_0_0_0_0_1_1,
        wrench_link_3_mx_0_0_0_1_1_1,
        wrench_link_3_mx_0_0_1_1_1,
        wrench_link_3_my_0_1_0_1_1,
        wrench_link_3_mx_0_1_1_1_1,
        wrench_link_3_mx_0_1_0_1_1,
        wrench_base_mx_1_0,
        wrench_base_my_1_0,
        wrench_base_mz_1_0,
        wrench_base_fx_1_0,
        wrench_base_fy_1_0,
        wrench_base_fz_0_0,
        wrench_link_1_mx_0_1,
        wrench_link_1_my_0_1,
        wrench_link_1_mz_0_1,
        wrench_link_1_fx_0_1,
        wrench_link_1_fy_0_1,
        wrench_link_1_fz_0_1,
        wrench_link_2_mx_0_1,
        wrench_link_2_my_0_1,
        wrench_link_2_mz_0_1,
        wrench_link_2_fx_0_1,
        wrench_link_2_fy_0_1,
        wrench_link_2_fz_0_1,
        wrench_link_3_mx_1,
        wrench_link_3_my_1,
        wrench_link_3_mz_1,
        wrench_link_3_fx_1,
        wrench_link_3_fy_1,
        wrench_link_3_fz_1,
    }
}
/// What only `inertia` computes.
#[inline(never)]
fn inertia_itself(
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    outside: &Outside,
    locked_inertia: &mut [[f64; 6]; 6],
    connection: &mut [[f64; 6]; 3],
    shape_inertia: &mut [[f64; 3]; 3],
) {
    let locked_inertia_0_0_2_0_0 = poses.com_z + 0.023809523809523808;
    let locked_inertia_0_0_1_0 = poses.minus_com_y * 130.0;
    let locked_inertia_0_0_2_0 = locked_inertia_0_0_2_0_0 * 130.0;
    let locked_inertia_0_0_1 = locked_inertia_0_0_1_0 * poses.minus_com_y;
    let locked_inertia_0_0_2 = locked_inertia_0_0_2_0 * locked_inertia_0_0_2_0_0;
    // Λ_b column 0
    locked_inertia[0][0] = inertias.composite_base_xx
        + (locked_inertia_0_0_1 + locked_inertia_0_0_2) + 0.0;
    let locked_inertia_1_0_1 = poses.com_x * 130.0;
    let locked_inertia_1_0 = inertias.composite_base_xy
        + locked_inertia_1_0_1 * poses.minus_com_y;
    locked_inertia[0][1] = locked_inertia_1_0 + 0.0;
    let locked_inertia_2_0 = inertias.composite_base_xz
        - locked_inertia_1_0_1 * locked_inertia_0_0_2_0_0;
    locked_inertia[0][2] = locked_inertia_2_0 + 0.0;
    locked_inertia[0][3] = 0.0;
    locked_inertia[0][4] = 0.0 - locked_inertia_0_0_2_0;
    locked_inertia[0][5] = 0.0 - locked_inertia_0_0_1_0;
    // Λ_b column 1
    locked_inertia[1][0] = locked_inertia_1_0 + 0.0;
    let locked_inertia_1_1_1 = locked_inertia_1_0_1 * poses.com_x;
    locked_inertia[1][1] = inertias.composite_base_yy
        + (locked_inertia_1_1_1 + locked_inertia_0_0_2) + 0.0;
    let locked_inertia_2_1 = inertias.composite_base_yz
        + locked_inertia_0_0_1_0 * locked_inertia_0_0_2_0_0;
    locked_inertia[1][2] = locked_inertia_2_1 + 0.0;
    locked_inertia[1][3] = locked_inertia_0_0_2_0 + 0.0;
    locked_inertia[1][4] = 0.0;
    locked_inertia[1][5] = 0.0 - locked_inertia_1_0_1;
    // Λ_b column 2
    locked_inertia[2][0] = locked_inertia_2_0 + 0.0;
    locked_inertia[2][1] = locked_inertia_2_1 + 0.0;
    locked_inertia[2][2] = inertias.composite_base_zz
        + (locked_inertia_1_1_1 + locked_inertia_0_0_1) + 0.0;
    locked_inertia[2][3] = locked_inertia_0_0_1_0 + 0.0;
    locked_inertia[2][4] = locked_inertia_1_0_1 + 0.0;
    locked_inertia[2][5] = 0.0;
    // Λ_b column 3
    locked_inertia[3][0] = 0.0;
    locked_inertia[3][1] = locked_inertia_0_0_2_0 + 0.0;
    locked_inertia[3][2] = locked_inertia_0_0_1_0 + 0.0;
    locked_inertia[3][3] = 130.0;
    locked_inertia[3][4] = 0.0;
    locked_inertia[3][5] = 0.0;
    // Λ_b column 4
    locked_inertia[4][0] = 0.0 - locked_inertia_0_0_2_0;
    locked_inertia[4][1] = 0.0;
    locked_inertia[4][2] = locked_inertia_1_0_1 + 0.0;
    locked_inertia[4][3] = 0.0;
    locked_inertia[4][4] = 130.0;
    locked_inertia[4][5] = 0.0;
    // Λ_b column 5
    locked_inertia[5][0] = 0.0 - locked_inertia_0_0_1_0;
    locked_inertia[5][1] = 0.0 - locked_inertia_1_0_1;
    locked_inertia[5][2] = 0.0;
    locked_inertia[5][3] = 0.0;
    locked_inertia[5][4] = 0.0;
    locked_inertia[5][5] = 130.0;
    // A_l column joint_1
    connection[0][0] = screws.connection_joint_1_wx + 0.0;
    connection[0][1] = screws.connection_joint_1_wy + 0.0;
    connection[0][2] = screws.connection_joint_1_wz + 0.0;
    connection[0][3] = screws.connection_joint_1_vx
        - (screws.connection_joint_1_wy * locked_inertia_0_0_2_0_0
            + screws.connection_joint_1_wz * poses.minus_com_y) + 0.0;
    connection[0][4] = screws.connection_joint_1_vy
        + (screws.connection_joint_1_wx * locked_inertia_0_0_2_0_0
            - screws.connection_joint_1_wz * poses.com_x) + 0.0;
    connection[0][5] = screws.connection_joint_1_wx * poses.minus_com_y
        + screws.connection_joint_1_wy * poses.com_x + 0.0;
    // A_l column joint_2
    connection[1][0] = screws.connection_joint_2_wx + 0.0;
    connection[1][1] = screws.connection_joint_2_wy + 0.0;
    connection[1][2] = screws.connection_joint_2_wz + 0.0;
    connection[1][3] = screws.connection_joint_2_vx
        - (screws.connection_joint_2_wy * locked_inertia_0_0_2_0_0
            + screws.connection_joint_2_wz * poses.minus_com_y) + 0.0;
    connection[1][4] = screws.connection_joint_2_vy
        + (screws.connection_joint_2_wx * locked_inertia_0_0_2_0_0
            - screws.connection_joint_2_wz * poses.com_x) + 0.0;
    connection[1][5] = screws.connection_joint_2_vz
        + (screws.connection_joint_2_wx * poses.minus_com_y
            + screws.connection_joint_2_wy * poses.com_x) + 0.0;
    // A_l column joint_3
    connection[2][0] = screws.connection_joint_3_wx + 0.0;
    connection[2][1] = screws.connection_joint_3_wy + 0.0;
    connection[2][2] = screws.connection_joint_3_wz + 0.0;
    connection[2][3] = screws.connection_joint_3_vx
        - (screws.connection_joint_3_wy * locked_inertia_0_0_2_0_0
            + screws.connection_joint_3_wz * poses.minus_com_y) + 0.0;
    connection[2][4] = screws.connection_joint_3_vy
        + (screws.connection_joint_3_wx * locked_inertia_0_0_2_0_0
            - screws.connection_joint_3_wz * poses.com_x) + 0.0;
    connection[2][5] = screws.connection_joint_3_vz
        + (screws.connection_joint_3_wx * poses.minus_com_y
            + screws.connection_joint_3_wy * poses.com_x) + 0.0;
    // Λ_q column joint_1
    shape_inertia[0][0] = outside.outside_joint_1_mx * screws.connection_joint_1_wx
        + outside.outside_joint_1_my * screws.connection_joint_1_wy
        + outside.outside_joint_1_mz * screws.connection_joint_1_wz + 0.0;
    let shape_inertia_1_0 = outside.outside_joint_1_mx * screws.connection_joint_2_wx
        + outside.outside_joint_1_my * screws.connection_joint_2_wy
        + outside.outside_joint_1_mz * screws.connection_joint_2_wz;
    shape_inertia[0][1] = shape_inertia_1_0 + 0.0;
    let shape_inertia_2_0 = outside.outside_joint_1_mx * screws.connection_joint_3_wx
        + outside.outside_joint_1_my * screws.connection_joint_3_wy
        + outside.outside_joint_1_mz * screws.connection_joint_3_wz;
    shape_inertia[0][2] = shape_inertia_2_0 + 0.0;
    // Λ_q column joint_2
    shape_inertia[1][0] = shape_inertia_1_0 + 0.0;
    shape_inertia[1][1] = outside.outside_joint_2_mx * screws.connection_joint_2_wx
        + outside.outside_joint_2_my * screws.connection_joint_2_wy
        + outside.outside_joint_2_mz * screws.connection_joint_2_wz
        + outside.outside_joint_2_fx * screws.connection_joint_2_vx
        + outside.outside_joint_2_fy * screws.connection_joint_2_vy
        + outside.outside_joint_2_fz * screws.connection_joint_2_vz + 0.0;
    let shape_inertia_2_1 = outside.outside_joint_2_mx * screws.connection_joint_3_wx
        + outside.outside_joint_2_my * screws.connection_joint_3_wy
        + outside.outside_joint_2_mz * screws.connection_joint_3_wz
        + outside.outside_joint_2_fx * screws.connection_joint_3_vx
        + outside.outside_joint_2_fy * screws.connection_joint_3_vy
        + outside.outside_joint_2_fz * screws.connection_joint_3_vz;
    shape_inertia[1][2] = shape_inertia_2_1 + 0.0;
    // Λ_q column joint_3
    shape_inertia[2][0] = shape_inertia_2_0 + 0.0;
    shape_inertia[2][1] = shape_inertia_2_1 + 0.0;
    shape_inertia[2][2] = outside.outside_joint_3_mx * screws.connection_joint_3_wx
        + outside.outside_joint_3_my * screws.connection_joint_3_wy
        + outside.outside_joint_3_mz * screws.connection_joint_3_wz
        + outside.outside_joint_3_fx * screws.connection_joint_3_vx
        + outside.outside_joint_3_fy * screws.connection_joint_3_vy
        + outside.outside_joint_3_fz * screws.connection_joint_3_vz + 0.0;
}
/// What only `d_mu` computes.
#[inline(never)]
fn d_mu_itself(
    mu: &[f64; 6],
    poses: &Poses,
    inertias: &Inertias,
    complements: &Complements,
    screws: &Screws,
    outside: &Outside,
    reactions: &Reactions,
    d_mu: &mut [[f64; 9]; 9],
) {
    let six_joint_1_mx_16 = poses.com_z + 0.023809523809523808;
    let d_mu_0_0_1_0 = mu[0] * 130.0;
    let d_mu_0_0_1 = d_mu_0_0_1_0 * six_joint_1_mx_16;
    let d_mu_0_0_3 = d_mu_0_0_1_0 * poses.minus_com_y;
    // D_μ column 0
    d_mu[0][0] = 0.0 - (poses.minus_com_y * d_mu_0_0_1 - six_joint_1_mx_16 * d_mu_0_0_3);
    let six_joint_1_mx_11 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let d_mu_1_0_0_1 = (inertias.composite_base_xx + inertias.composite_base_yy
        + inertias.composite_base_zz) * 0.5;
    let d_mu_1_0_0 = mu[2] * d_mu_1_0_0_1 - six_joint_1_mx_11;
    let d_mu_1_0_4_1_0 = mu[2] * 130.0;
    let d_mu_1_0_4_0_0 = mu[1] * 130.0;
    let d_mu_1_0_4_1 = d_mu_1_0_4_1_0 * six_joint_1_mx_16;
    let d_mu_1_0_4_0 = d_mu_1_0_4_0_0 * poses.minus_com_y;
    let d_mu_1_0_4 = d_mu_1_0_4_0 - d_mu_1_0_4_1;
    d_mu[0][1] = 0.0
        - (d_mu_1_0_0 + (poses.com_x * d_mu_0_0_1 - six_joint_1_mx_16 * d_mu_1_0_4));
    let six_joint_1_mx_9 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let d_mu_2_0_4 = mu[1] * d_mu_1_0_0_1 - six_joint_1_mx_9;
    d_mu[0][2] = 0.0
        - (poses.com_x * d_mu_0_0_3 - poses.minus_com_y * d_mu_1_0_4 - d_mu_2_0_4);
    d_mu[0][3] = d_mu_1_0_4 + 0.0;
    d_mu[0][4] = 0.0 - d_mu_0_0_3;
    d_mu[0][5] = d_mu_0_0_1 + 0.0;
    let six_joint_1_mx_1 = inertias.composite_link_1_xy + inertias.composite_link_1_xy;
    let six_joint_1_mx_0_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
    let six_joint_1_mx_0 = six_joint_1_mx_0_1 + six_joint_1_mx_0_1;
    let six_joint_1_mx_3 = inertias.composite_link_1_xx - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 + inertias.inside_joint_1_mz_1_1);
    let six_joint_1_fy_4_0 = mu[3]
        + (mu[1] * six_joint_1_mx_16 + mu[2] * poses.minus_com_y);
    let six_joint_1_fz_6_0 = mu[4] + (mu[2] * poses.com_x - mu[0] * six_joint_1_mx_16);
    let six_joint_1_fy_2_0 = mu[5] - (mu[0] * poses.minus_com_y + mu[1] * poses.com_x);
    let six_joint_1_fy_4 = six_joint_1_fy_4_0 * 130.0;
    let six_joint_1_fz_6 = six_joint_1_fz_6_0 * 130.0;
    let six_joint_1_fy_2 = six_joint_1_fy_2_0 * 130.0;
    let six_joint_1_fz_0 = mu[0] * 0.5;
    let six_joint_1_fz_2 = mu[1] * 0.5;
    let six_joint_1_fy_0 = mu[2] * 0.5;
    let six_joint_1_mx_8 = six_joint_1_fy_2_0 * 0.5;
    let six_joint_1_fy = six_joint_1_fy_0 * screws.inside_joint_1_fx
        + (six_joint_1_fy_2 * screws.connection_joint_1_wx
            - six_joint_1_fy_4 * screws.connection_joint_1_wz);
    let six_joint_1_fz = six_joint_1_fz_0 * screws.inside_joint_1_fy
        - six_joint_1_fz_2 * screws.inside_joint_1_fx
        + (six_joint_1_fy_4 * screws.connection_joint_1_wy
            - six_joint_1_fz_6 * screws.connection_joint_1_wx);
    let six_joint_1_mx = (six_joint_1_mx_0 - six_joint_1_mx_1) * six_joint_1_fz_0
        + six_joint_1_mx_3 * six_joint_1_fz_2
        - screws.inside_joint_1_my * six_joint_1_fy_0
        + screws.inside_joint_1_fy * six_joint_1_mx_8
        + (six_joint_1_mx_9 * screws.connection_joint_1_wz
            - six_joint_1_mx_11 * screws.connection_joint_1_wy
            - six_joint_1_fy_2 * screws.connection_joint_1_vy)
        - (six_joint_1_fy * six_joint_1_mx_16 + six_joint_1_fz * poses.minus_com_y);
    d_mu[0][6] = six_joint_1_mx + 0.0;
    let six_joint_2_mx_0_3 = poses.sin_joint_1 * inertias.minus_composite_link_2_xz;
    let six_joint_2_mx_0_0_1 = inertias.composite_link_2_hy * screws.screw_joint_2_vy;
    let six_joint_2_mx_0_1_1 = inertias.composite_link_2_hz
        * screws.minus_screw_joint_2_vz;
    let six_joint_2_mx_0_0 = six_joint_2_mx_0_0_1 + six_joint_2_mx_0_0_1;
    let six_joint_2_mx_0_1 = six_joint_2_mx_0_1_1 + six_joint_2_mx_0_1_1;
    let six_joint_2_mx_0 = six_joint_2_mx_0_0 - six_joint_2_mx_0_1
        - (six_joint_2_mx_0_3 + six_joint_2_mx_0_3);
    let six_joint_2_mx_2 = inertias.inside_joint_2_mz_1_0
        - inertias.inside_joint_2_mz_1_1
        - (screws.inside_joint_2_mz_0 - screws.inside_joint_2_mz_1);
    let six_joint_2_mx_4 = poses.sin_joint_1 * inertias.composite_link_2_zz
        - (inertias.inside_joint_2_my_0_1
            + poses.sin_joint_1 * inertias.composite_link_2_xx)
        + (screws.inside_joint_2_my_3 + screws.inside_joint_2_my_4);
    let six_joint_2_mx_9 = six_joint_1_fz_6_0 * 0.5;
    let six_joint_2_fy = six_joint_1_fy_0 * screws.inside_joint_2_fx
        - six_joint_1_fz_0 * screws.inside_joint_2_fz
        + (six_joint_1_fy_2 * screws.connection_joint_2_wx
            - six_joint_1_fy_4 * screws.connection_joint_2_wz);
    let six_joint_2_fz = six_joint_1_fz_0 * screws.inside_joint_2_fy
        - six_joint_1_fz_2 * screws.inside_joint_2_fx
        + (six_joint_1_fy_4 * screws.connection_joint_2_wy
            - six_joint_1_fz_6 * screws.connection_joint_2_wx);
    let six_joint_2_mx = six_joint_2_mx_0 * six_joint_1_fz_0
        + six_joint_2_mx_2 * six_joint_1_fz_2 + six_joint_2_mx_4 * six_joint_1_fy_0
        + (screws.inside_joint_2_fy * six_joint_1_mx_8
            - screws.inside_joint_2_fz * six_joint_2_mx_9)
        + (six_joint_1_mx_9 * screws.connection_joint_2_wz
            - six_joint_1_mx_11 * screws.connection_joint_2_wy
            + (six_joint_1_fz_6 * screws.connection_joint_2_vz
                - six_joint_1_fy_2 * screws.connection_joint_2_vy))
        - (six_joint_2_fy * six_joint_1_mx_16 + six_joint_2_fz * poses.minus_com_y);
    d_mu[0][7] = six_joint_2_mx + 0.0;
    let six_joint_3_mx_0_3 = poses.sin_joint_1 * inertias.minus_inertia_link_3_xz;
    let six_joint_3_mx_0_0_1 = inertias.inertia_link_3_hy * screws.screw_joint_3_vy;
    let six_joint_3_mx_0_1_1 = inertias.inertia_link_3_hz * screws.screw_joint_3_vz;
    let six_joint_3_mx_0_0 = six_joint_3_mx_0_0_1 + six_joint_3_mx_0_0_1;
    let six_joint_3_mx_0_1 = six_joint_3_mx_0_1_1 + six_joint_3_mx_0_1_1;
    let six_joint_3_mx_0 = six_joint_3_mx_0_0 + six_joint_3_mx_0_1
        - (six_joint_3_mx_0_3 + six_joint_3_mx_0_3);
    let six_joint_3_mx_2 = inertias.inside_joint_3_mz_1_0
        - inertias.inside_joint_3_mz_1_1
        - (screws.inside_joint_3_mz_0 - screws.inside_joint_3_mz_1);
    let six_joint_3_mx_4 = poses.sin_joint_1 * inertias.inertia_link_3_zz
        - (inertias.inside_joint_3_my_0_1
            + poses.sin_joint_1 * inertias.inertia_link_3_xx)
        - (screws.inside_joint_3_my_4 - screws.inside_joint_3_my_3);
    let six_joint_3_fy = six_joint_1_fy_0 * screws.inside_joint_3_fx
        - six_joint_1_fz_0 * screws.inside_joint_3_fz
        + (six_joint_1_fy_2 * screws.connection_joint_3_wx
            - six_joint_1_fy_4 * screws.connection_joint_3_wz);
    let six_joint_3_fz = six_joint_1_fz_0 * screws.inside_joint_3_fy
        - six_joint_1_fz_2 * screws.inside_joint_3_fx
        + (six_joint_1_fy_4 * screws.connection_joint_3_wy
            - six_joint_1_fz_6 * screws.connection_joint_3_wx);
    let six_joint_3_mx = six_joint_3_mx_0 * six_joint_1_fz_0
        + six_joint_3_mx_2 * six_joint_1_fz_2 + six_joint_3_mx_4 * six_joint_1_fy_0
        + (screws.inside_joint_3_fy * six_joint_1_mx_8
            - screws.inside_joint_3_fz * six_joint_2_mx_9)
        + (six_joint_1_mx_9 * screws.connection_joint_3_wz
            - six_joint_1_mx_11 * screws.connection_joint_3_wy
            + (six_joint_1_fz_6 * screws.connection_joint_3_vz
                - six_joint_1_fy_2 * screws.connection_joint_3_vy))
        - (six_joint_3_fy * six_joint_1_mx_16 + six_joint_3_fz * poses.minus_com_y);
    d_mu[0][8] = six_joint_3_mx + 0.0;
    let d_mu_0_1_1 = d_mu_1_0_4_0_0 * six_joint_1_mx_16;
    let d_mu_0_1_3_0 = d_mu_0_0_1_0 * poses.com_x;
    let d_mu_0_1_3 = d_mu_0_1_3_0 + d_mu_1_0_4_1;
    // D_μ column 1
    d_mu[1][0] = 0.0
        - (poses.minus_com_y * d_mu_0_1_1 - six_joint_1_mx_16 * d_mu_0_1_3 - d_mu_1_0_0);
    let d_mu_1_1_3 = d_mu_1_0_4_0_0 * poses.com_x;
    d_mu[1][1] = 0.0 - (poses.com_x * d_mu_0_1_1 - six_joint_1_mx_16 * d_mu_1_1_3);
    let six_joint_1_my_11 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let d_mu_2_1_0 = mu[0] * d_mu_1_0_0_1 - six_joint_1_my_11;
    d_mu[1][2] = 0.0
        - (d_mu_2_1_0 + (poses.com_x * d_mu_0_1_3 - poses.minus_com_y * d_mu_1_1_3));
    d_mu[1][3] = d_mu_1_1_3 + 0.0;
    d_mu[1][4] = 0.0 - d_mu_0_1_3;
    d_mu[1][5] = d_mu_0_1_1 + 0.0;
    let six_joint_1_my_3_1 = inertias.composite_link_1_hx * poses.origin_base_y;
    let six_joint_1_my_3 = six_joint_1_my_3_1 + six_joint_1_my_3_1;
    let six_joint_1_fx = six_joint_1_fz_6 * screws.connection_joint_1_wz
        - six_joint_1_fy_2 * screws.connection_joint_1_wy
        - six_joint_1_fy_0 * screws.inside_joint_1_fy;
    let six_joint_1_my = six_joint_1_mx_3 * six_joint_1_fz_0
        + (six_joint_1_mx_1 + six_joint_1_my_3) * six_joint_1_fz_2
        + screws.inside_joint_1_mx * six_joint_1_fy_0
        - screws.inside_joint_1_fx * six_joint_1_mx_8
        + (six_joint_1_mx_11 * screws.connection_joint_1_wx
            - six_joint_1_my_11 * screws.connection_joint_1_wz
            + six_joint_1_fy_2 * screws.connection_joint_1_vx)
        + (six_joint_1_fx * six_joint_1_mx_16 - six_joint_1_fz * poses.com_x);
    d_mu[1][6] = six_joint_1_my + 0.0;
    let six_joint_2_my_2_1 = poses.cos_joint_1 * inertias.minus_composite_link_2_yz;
    let six_joint_2_my_2_2_1 = inertias.composite_link_2_hx
        * screws.minus_screw_joint_2_vx;
    let six_joint_2_my_2_2 = six_joint_2_my_2_2_1 + six_joint_2_my_2_2_1;
    let six_joint_2_my_2 = six_joint_2_my_2_1 + six_joint_2_my_2_1
        - (six_joint_2_my_2_2 + six_joint_2_mx_0_1);
    let six_joint_2_my_4 = poses.cos_joint_1 * inertias.composite_link_2_yy
        + inertias.inside_joint_2_mx_0_1
        - poses.cos_joint_1 * inertias.composite_link_2_zz
        - (screws.inside_joint_2_mx_4 - screws.inside_joint_2_mx_3);
    let six_joint_2_my_7 = six_joint_1_fy_4_0 * 0.5;
    let six_joint_2_fx = six_joint_1_fz_2 * screws.inside_joint_2_fz
        - six_joint_1_fy_0 * screws.inside_joint_2_fy
        + (six_joint_1_fz_6 * screws.connection_joint_2_wz
            - six_joint_1_fy_2 * screws.connection_joint_2_wy);
    let six_joint_2_my = six_joint_2_mx_2 * six_joint_1_fz_0
        + six_joint_2_my_2 * six_joint_1_fz_2 + six_joint_2_my_4 * six_joint_1_fy_0
        + (screws.inside_joint_2_fz * six_joint_2_my_7
            - screws.inside_joint_2_fx * six_joint_1_mx_8)
        + (six_joint_1_mx_11 * screws.connection_joint_2_wx
            - six_joint_1_my_11 * screws.connection_joint_2_wz
            + (six_joint_1_fy_2 * screws.connection_joint_2_vx
                - six_joint_1_fy_4 * screws.connection_joint_2_vz))
        + (six_joint_2_fx * six_joint_1_mx_16 - six_joint_2_fz * poses.com_x);
    d_mu[1][7] = six_joint_2_my + 0.0;
    let six_joint_3_my_2_1 = poses.cos_joint_1 * inertias.minus_inertia_link_3_yz;
    let six_joint_3_my_2_3_1 = inertias.inertia_link_3_hx
        * screws.minus_screw_joint_3_vx;
    let six_joint_3_my_2_3 = six_joint_3_my_2_3_1 + six_joint_3_my_2_3_1;
    let six_joint_3_my_2 = six_joint_3_my_2_1 + six_joint_3_my_2_1
        + (six_joint_3_mx_0_1 - six_joint_3_my_2_3);
    let six_joint_3_my_4 = poses.cos_joint_1 * inertias.inertia_link_3_yy
        + inertias.inside_joint_3_mx_0_1 - poses.cos_joint_1 * inertias.inertia_link_3_zz
        - (screws.inside_joint_3_mx_3 + screws.inside_joint_3_mx_4);
    let six_joint_3_fx = six_joint_1_fz_2 * screws.inside_joint_3_fz
        - six_joint_1_fy_0 * screws.inside_joint_3_fy
        + (six_joint_1_fz_6 * screws.connection_joint_3_wz
            - six_joint_1_fy_2 * screws.connection_joint_3_wy);
    let six_joint_3_my = six_joint_3_mx_2 * six_joint_1_fz_0
        + six_joint_3_my_2 * six_joint_1_fz_2 + six_joint_3_my_4 * six_joint_1_fy_0
        + (screws.inside_joint_3_fz * six_joint_2_my_7
            - screws.inside_joint_3_fx * six_joint_1_mx_8)
        + (six_joint_1_mx_11 * screws.connection_joint_3_wx
            - six_joint_1_my_11 * screws.connection_joint_3_wz
            + (six_joint_1_fy_2 * screws.connection_joint_3_vx
                - six_joint_1_fy_4 * screws.connection_joint_3_vz))
        + (six_joint_3_fx * six_joint_1_mx_16 - six_joint_3_fz * poses.com_x);
    d_mu[1][8] = six_joint_3_my + 0.0;
    let d_mu_0_2_4 = d_mu_1_0_4_1_0 * poses.minus_com_y;
    let d_mu_0_2_2 = d_mu_1_0_4_0 - d_mu_0_1_3_0;
    // D_μ column 2
    d_mu[2][0] = 0.0
        - (d_mu_2_0_4
            + (poses.minus_com_y * d_mu_0_2_2 - six_joint_1_mx_16 * d_mu_0_2_4));
    let d_mu_1_2_3 = d_mu_1_0_4_1_0 * poses.com_x;
    d_mu[2][1] = 0.0
        - (poses.com_x * d_mu_0_2_2 - six_joint_1_mx_16 * d_mu_1_2_3 - d_mu_2_1_0);
    d_mu[2][2] = 0.0 - (poses.com_x * d_mu_0_2_4 - poses.minus_com_y * d_mu_1_2_3);
    d_mu[2][3] = d_mu_1_2_3 + 0.0;
    d_mu[2][4] = 0.0 - d_mu_0_2_4;
    d_mu[2][5] = d_mu_0_2_2 + 0.0;
    let six_joint_1_mz = screws.inside_joint_1_mx * six_joint_1_fz_2
        - screws.inside_joint_1_my * six_joint_1_fz_0
        + (six_joint_1_my_3 + six_joint_1_mx_0) * six_joint_1_fy_0
        + (screws.inside_joint_1_fx * six_joint_2_mx_9
            - screws.inside_joint_1_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_1_wy
            - six_joint_1_mx_9 * screws.connection_joint_1_wx
            + (six_joint_1_fy_4 * screws.connection_joint_1_vy
                - six_joint_1_fz_6 * screws.connection_joint_1_vx))
        + (six_joint_1_fx * poses.minus_com_y + six_joint_1_fy * poses.com_x);
    d_mu[2][6] = six_joint_1_mz + 0.0;
    let six_joint_2_mz_4_1 = six_joint_2_mx_0_3 - six_joint_2_my_2_1;
    let six_joint_2_mz_4 = six_joint_2_mz_4_1 + six_joint_2_mz_4_1
        + (six_joint_2_mx_0_0 - six_joint_2_my_2_2);
    let six_joint_2_mz = six_joint_2_mx_4 * six_joint_1_fz_0
        + six_joint_2_my_4 * six_joint_1_fz_2 + six_joint_2_mz_4 * six_joint_1_fy_0
        + (screws.inside_joint_2_fx * six_joint_2_mx_9
            - screws.inside_joint_2_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_2_wy
            - six_joint_1_mx_9 * screws.connection_joint_2_wx
            + (six_joint_1_fy_4 * screws.connection_joint_2_vy
                - six_joint_1_fz_6 * screws.connection_joint_2_vx))
        + (six_joint_2_fx * poses.minus_com_y + six_joint_2_fy * poses.com_x);
    d_mu[2][7] = six_joint_2_mz + 0.0;
    let six_joint_3_mz_4_1 = six_joint_3_mx_0_3 - six_joint_3_my_2_1;
    let six_joint_3_mz_4 = six_joint_3_mz_4_1 + six_joint_3_mz_4_1
        + (six_joint_3_mx_0_0 - six_joint_3_my_2_3);
    let six_joint_3_mz = six_joint_3_mx_4 * six_joint_1_fz_0
        + six_joint_3_my_4 * six_joint_1_fz_2 + six_joint_3_mz_4 * six_joint_1_fy_0
        + (screws.inside_joint_3_fx * six_joint_2_mx_9
            - screws.inside_joint_3_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_3_wy
            - six_joint_1_mx_9 * screws.connection_joint_3_wx
            + (six_joint_1_fy_4 * screws.connection_joint_3_vy
                - six_joint_1_fz_6 * screws.connection_joint_3_vx))
        + (six_joint_3_fx * poses.minus_com_y + six_joint_3_fy * poses.com_x);
    d_mu[2][8] = six_joint_3_mz + 0.0;
    // D_μ column 3
    d_mu[3][0] = 0.0 - d_mu_1_0_4;
    d_mu[3][1] = 0.0 - d_mu_1_1_3;
    d_mu[3][2] = 0.0 - d_mu_1_2_3;
    d_mu[3][3] = 0.0;
    d_mu[3][4] = 0.0 - d_mu_1_0_4_1_0;
    d_mu[3][5] = d_mu_1_0_4_0_0 + 0.0;
    d_mu[3][6] = six_joint_1_fx + 0.0;
    d_mu[3][7] = six_joint_2_fx + 0.0;
    d_mu[3][8] = six_joint_3_fx + 0.0;
    // D_μ column 4
    d_mu[4][0] = d_mu_0_0_3 + 0.0;
    d_mu[4][1] = d_mu_0_1_3 + 0.0;
    d_mu[4][2] = d_mu_0_2_4 + 0.0;
    d_mu[4][3] = d_mu_1_0_4_1_0 + 0.0;
    d_mu[4][4] = 0.0;
    d_mu[4][5] = 0.0 - d_mu_0_0_1_0;
    d_mu[4][6] = six_joint_1_fy + 0.0;
    d_mu[4][7] = six_joint_2_fy + 0.0;
    d_mu[4][8] = six_joint_3_fy + 0.0;
    // D_μ column 5
    d_mu[5][0] = 0.0 - d_mu_0_0_1;
    d_mu[5][1] = 0.0 - d_mu_0_1_1;
    d_mu[5][2] = 0.0 - d_mu_0_2_2;
    d_mu[5][3] = 0.0 - d_mu_1_0_4_0_0;
    d_mu[5][4] = d_mu_0_0_1_0 + 0.0;
    d_mu[5][5] = 0.0;
    d_mu[5][6] = six_joint_1_fz + 0.0;
    d_mu[5][7] = six_joint_2_fz + 0.0;
    d_mu[5][8] = six_joint_3_fz + 0.0;
    // D_μ column joint_1
    d_mu[6][0] = 0.0 - six_joint_1_mx;
    d_mu[6][1] = 0.0 - six_joint_1_my;
    d_mu[6][2] = 0.0 - six_joint_1_mz;
    d_mu[6][3] = 0.0 - six_joint_1_fx;
    d_mu[6][4] = 0.0 - six_joint_1_fy;
    d_mu[6][5] = 0.0 - six_joint_1_fz;
    d_mu[6][6] = 0.0;
    let d_mu_7_6_6_4_1 = inertias.inertia_base_hy * poses.minus_origin_base_x;
    let d_mu_7_6_6_4 = d_mu_7_6_6_4_1 + d_mu_7_6_6_4_1
        - (inertias.inertia_base_xy + inertias.inertia_base_xy);
    let d_mu_7_6_6_6 = inertias.inertia_base_xx - inertias.inertia_base_yy
        - (inertias.inertia_base_xx_1 - inertias.inertia_base_yy_1);
    let d_mu_7_6_6 = reactions.reaction_joint_1_wy * six_joint_1_mx_11
        - reactions.reaction_joint_1_wz * six_joint_1_mx_9
        - (d_mu_7_6_6_4 * mu[0] + d_mu_7_6_6_6 * mu[1]
            - outside.outside_joint_1_my * mu[2]);
    let d_mu_7_6_8 = reactions.reaction_joint_1_wz * six_joint_1_my_11
        - reactions.reaction_joint_1_wx * six_joint_1_mx_11
        - (d_mu_7_6_6_6 * mu[0] + outside.outside_joint_1_mx * mu[2]);
    let d_mu_7_6_10 = reactions.reaction_joint_1_wx * six_joint_1_mx_9
        - reactions.reaction_joint_1_wy * six_joint_1_my_11
        - (outside.outside_joint_1_mx * mu[1] - outside.outside_joint_1_my * mu[0]
            + d_mu_7_6_6_4 * mu[2]);
    let three_joint_2_x = six_joint_2_mx_0 * mu[0] + six_joint_2_mx_2 * mu[1]
        + six_joint_2_mx_4 * mu[2];
    let three_joint_2_y = six_joint_2_mx_2 * mu[0] + six_joint_2_my_2 * mu[1]
        + six_joint_2_my_4 * mu[2];
    let three_joint_2_z = six_joint_2_mx_4 * mu[0] + six_joint_2_my_4 * mu[1]
        + six_joint_2_mz_4 * mu[2];
    let d_mu_7_6 = reactions.reaction_joint_1_wx * three_joint_2_x
        + reactions.reaction_joint_1_wy * three_joint_2_y
        + reactions.reaction_joint_1_wz * three_joint_2_z
        + d_mu_7_6_6 * screws.connection_joint_2_wx
        + d_mu_7_6_8 * screws.connection_joint_2_wy
        + d_mu_7_6_10 * screws.connection_joint_2_wz;
    d_mu[6][7] = d_mu_7_6 + 0.0;
    let three_joint_3_x = six_joint_3_mx_0 * mu[0] + six_joint_3_mx_2 * mu[1]
        + six_joint_3_mx_4 * mu[2];
    let three_joint_3_y = six_joint_3_mx_2 * mu[0] + six_joint_3_my_2 * mu[1]
        + six_joint_3_my_4 * mu[2];
    let three_joint_3_z = six_joint_3_mx_4 * mu[0] + six_joint_3_my_4 * mu[1]
        + six_joint_3_mz_4 * mu[2];
    let d_mu_8_6 = reactions.reaction_joint_1_wx * three_joint_3_x
        + reactions.reaction_joint_1_wy * three_joint_3_y
        + reactions.reaction_joint_1_wz * three_joint_3_z
        + d_mu_7_6_6 * screws.connection_joint_3_wx
        + d_mu_7_6_8 * screws.connection_joint_3_wy
        + d_mu_7_6_10 * screws.connection_joint_3_wz;
    d_mu[6][8] = d_mu_8_6 + 0.0;
    // D_μ column joint_2
    d_mu[7][0] = 0.0 - six_joint_2_mx;
    d_mu[7][1] = 0.0 - six_joint_2_my;
    d_mu[7][2] = 0.0 - six_joint_2_mz;
    d_mu[7][3] = 0.0 - six_joint_2_fx;
    d_mu[7][4] = 0.0 - six_joint_2_fy;
    d_mu[7][5] = 0.0 - six_joint_2_fz;
    d_mu[7][6] = 0.0 - d_mu_7_6;
    d_mu[7][7] = 0.0;
    let d_mu_8_7_61 = mu[0] * 260.0;
    let d_mu_8_7_59 = mu[1] * 260.0;
    let d_mu_8_7_56 = mu[2] * 260.0;
    let d_mu_8_7_43_1 = poses.sin_joint_1 * complements.complement_link_2_xz;
    let d_mu_8_7_43_0 = poses.cos_joint_1 * complements.complement_link_2_yz;
    let d_mu_8_7_43 = d_mu_8_7_43_0 - d_mu_8_7_43_1;
    let d_mu_8_7_44_1 = complements.minus_complement_link_2_hx
        * screws.minus_screw_joint_2_vx;
    let d_mu_8_7_45_1 = complements.complement_link_2_hy * screws.screw_joint_2_vy;
    let d_mu_8_7_27_1 = complements.complement_link_2_hz * screws.minus_screw_joint_2_vz;
    let d_mu_8_7_45 = d_mu_8_7_45_1 + d_mu_8_7_45_1;
    let d_mu_8_7_27 = d_mu_8_7_27_1 + d_mu_8_7_27_1;
    let d_mu_8_7_44 = d_mu_8_7_44_1 + d_mu_8_7_44_1;
    let d_mu_8_7_24 = complements.outside_joint_2_mz_0_1
        - complements.outside_joint_2_mz_0_0
        + (screws.outside_joint_2_mz_1_1 + screws.outside_joint_2_mz_1_0);
    let d_mu_8_7_38 = poses.sin_joint_1 * complements.complement_link_2_zz
        + (complements.outside_joint_2_my_0_0
            - poses.sin_joint_1 * complements.complement_link_2_xx)
        - (screws.outside_joint_2_my_1_1 - screws.outside_joint_2_my_1_0);
    let d_mu_8_7_40 = poses.cos_joint_1 * complements.complement_link_2_yy
        - complements.outside_joint_2_mx_0_1
        - poses.cos_joint_1 * complements.complement_link_2_zz
        - (screws.outside_joint_2_mx_1_1 - screws.outside_joint_2_mx_1_0);
    let d_mu_8_7 = reactions.reaction_joint_2_wx * three_joint_3_x
        + reactions.reaction_joint_2_wy * three_joint_3_y
        + reactions.reaction_joint_2_wz * three_joint_3_z
        + (reactions.reaction_joint_2_wy * six_joint_1_mx_11
            - reactions.reaction_joint_2_wz * six_joint_1_mx_9
            - ((d_mu_8_7_43_1 + d_mu_8_7_43_1 + (d_mu_8_7_45 - d_mu_8_7_27)) * mu[0]
                + d_mu_8_7_24 * mu[1] + d_mu_8_7_38 * mu[2]))
            * screws.connection_joint_3_wx
        + (reactions.reaction_joint_2_wz * six_joint_1_my_11
            - reactions.reaction_joint_2_wx * six_joint_1_mx_11
            - (d_mu_8_7_24 * mu[0]
                + (d_mu_8_7_44 - d_mu_8_7_27 - (d_mu_8_7_43_0 + d_mu_8_7_43_0)) * mu[1]
                + d_mu_8_7_40 * mu[2])) * screws.connection_joint_3_wy
        + (reactions.reaction_joint_2_wx * six_joint_1_mx_9
            - reactions.reaction_joint_2_wy * six_joint_1_my_11
            - (d_mu_8_7_38 * mu[0] + d_mu_8_7_40 * mu[1]
                + (d_mu_8_7_43 + d_mu_8_7_43 + (d_mu_8_7_44 + d_mu_8_7_45)) * mu[2]))
            * screws.connection_joint_3_wz
        + (reactions.reaction_joint_2_vy * d_mu_8_7_56
            - reactions.reaction_joint_2_vz * d_mu_8_7_59) * screws.connection_joint_3_vx
        + (reactions.reaction_joint_2_vz * d_mu_8_7_61
            - reactions.reaction_joint_2_vx * d_mu_8_7_56) * screws.connection_joint_3_vy
        + (reactions.reaction_joint_2_vx * d_mu_8_7_59
            - reactions.reaction_joint_2_vy * d_mu_8_7_61)
            * screws.connection_joint_3_vz;
    d_mu[7][8] = d_mu_8_7 + 0.0;
    // D_μ column joint_3
    d_mu[8][0] = 0.0 - six_joint_3_mx;
    d_mu[8][1] = 0.0 - six_joint_3_my;
    d_mu[8][2] = 0.0 - six_joint_3_mz;
    d_mu[8][3] = 0.0 - six_joint_3_fx;
    d_mu[8][4] = 0.0 - six_joint_3_fy;
    d_mu[8][5] = 0.0 - six_joint_3_fz;
    d_mu[8][6] = 0.0 - d_mu_8_6;
    d_mu[8][7] = 0.0 - d_mu_8_7;
    d_mu[8][8] = 0.0;
}
/// What only `b2` computes.
#[inline(never)]
fn b2_itself(
    mu: &[f64; 6],
    poses: &Poses,
    inertias: &Inertias,
    complements: &Complements,
    screws: &Screws,
    outside: &Outside,
    reactions: &Reactions,
    b2: &mut [[f64; 3]; 3],
) {
    // B_2(μ) column joint_1
    b2[0][0] = 0.0;
    let six_joint_1_my_1 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let six_joint_1_mx_3 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let six_joint_1_mx_1 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let six_joint_1_mx_4_1 = inertias.inertia_base_hy * poses.minus_origin_base_x;
    let six_joint_1_mx_4 = six_joint_1_mx_4_1 + six_joint_1_mx_4_1
        - (inertias.inertia_base_xy + inertias.inertia_base_xy);
    let six_joint_1_mx_6 = inertias.inertia_base_xx - inertias.inertia_base_yy
        - (inertias.inertia_base_xx_1 - inertias.inertia_base_yy_1);
    let six_joint_1_mx = reactions.reaction_joint_1_wy * six_joint_1_mx_1
        - reactions.reaction_joint_1_wz * six_joint_1_mx_3
        - (six_joint_1_mx_4 * mu[0] + six_joint_1_mx_6 * mu[1]
            - outside.outside_joint_1_my * mu[2]);
    let six_joint_1_my = reactions.reaction_joint_1_wz * six_joint_1_my_1
        - reactions.reaction_joint_1_wx * six_joint_1_mx_1
        - (six_joint_1_mx_6 * mu[0] + outside.outside_joint_1_mx * mu[2]);
    let six_joint_1_mz = reactions.reaction_joint_1_wx * six_joint_1_mx_3
        - reactions.reaction_joint_1_wy * six_joint_1_my_1
        - (outside.outside_joint_1_mx * mu[1] - outside.outside_joint_1_my * mu[0]
            + six_joint_1_mx_4 * mu[2]);
    let three_joint_2_x_3 = poses.sin_joint_1 * inertias.minus_composite_link_2_xz;
    let three_joint_2_y_3 = poses.cos_joint_1 * inertias.minus_composite_link_2_yz;
    let three_joint_2_z_5 = three_joint_2_x_3 - three_joint_2_y_3;
    let three_joint_2_y_4_1 = inertias.composite_link_2_hx
        * screws.minus_screw_joint_2_vx;
    let three_joint_2_x_0_1 = inertias.composite_link_2_hy * screws.screw_joint_2_vy;
    let three_joint_2_x_1_1 = inertias.composite_link_2_hz
        * screws.minus_screw_joint_2_vz;
    let three_joint_2_x_0 = three_joint_2_x_0_1 + three_joint_2_x_0_1;
    let three_joint_2_x_1 = three_joint_2_x_1_1 + three_joint_2_x_1_1;
    let three_joint_2_y_4 = three_joint_2_y_4_1 + three_joint_2_y_4_1;
    let three_joint_2_x_5 = inertias.inside_joint_2_mz_1_0
        - inertias.inside_joint_2_mz_1_1
        - (screws.inside_joint_2_mz_0 - screws.inside_joint_2_mz_1);
    let three_joint_2_x_7 = poses.sin_joint_1 * inertias.composite_link_2_zz
        - (inertias.inside_joint_2_my_0_1
            + poses.sin_joint_1 * inertias.composite_link_2_xx)
        + (screws.inside_joint_2_my_3 + screws.inside_joint_2_my_4);
    let three_joint_2_y_7 = poses.cos_joint_1 * inertias.composite_link_2_yy
        + inertias.inside_joint_2_mx_0_1
        - poses.cos_joint_1 * inertias.composite_link_2_zz
        - (screws.inside_joint_2_mx_4 - screws.inside_joint_2_mx_3);
    let three_joint_2_x = (three_joint_2_x_0 - three_joint_2_x_1
        - (three_joint_2_x_3 + three_joint_2_x_3)) * mu[0] + three_joint_2_x_5 * mu[1]
        + three_joint_2_x_7 * mu[2];
    let three_joint_2_y = three_joint_2_x_5 * mu[0]
        + (three_joint_2_y_3 + three_joint_2_y_3
            - (three_joint_2_y_4 + three_joint_2_x_1)) * mu[1]
        + three_joint_2_y_7 * mu[2];
    let three_joint_2_z = three_joint_2_x_7 * mu[0] + three_joint_2_y_7 * mu[1]
        + (three_joint_2_z_5 + three_joint_2_z_5
            + (three_joint_2_x_0 - three_joint_2_y_4)) * mu[2];
    let b2_1_0 = (reactions.reaction_joint_1_wx * three_joint_2_x
        + reactions.reaction_joint_1_wy * three_joint_2_y
        + reactions.reaction_joint_1_wz * three_joint_2_z
        + six_joint_1_mx * screws.connection_joint_2_wx
        + six_joint_1_my * screws.connection_joint_2_wy
        + six_joint_1_mz * screws.connection_joint_2_wz) * 0.5;
    b2[0][1] = 0.0 - b2_1_0;
    let three_joint_3_x_3 = poses.sin_joint_1 * inertias.minus_inertia_link_3_xz;
    let three_joint_3_y_3 = poses.cos_joint_1 * inertias.minus_inertia_link_3_yz;
    let three_joint_3_z_5 = three_joint_3_x_3 - three_joint_3_y_3;
    let three_joint_3_y_5_1 = inertias.inertia_link_3_hx * screws.minus_screw_joint_3_vx;
    let three_joint_3_x_0_1 = inertias.inertia_link_3_hy * screws.screw_joint_3_vy;
    let three_joint_3_x_1_1 = inertias.inertia_link_3_hz * screws.screw_joint_3_vz;
    let three_joint_3_x_0 = three_joint_3_x_0_1 + three_joint_3_x_0_1;
    let three_joint_3_x_1 = three_joint_3_x_1_1 + three_joint_3_x_1_1;
    let three_joint_3_y_5 = three_joint_3_y_5_1 + three_joint_3_y_5_1;
    let three_joint_3_x_5 = inertias.inside_joint_3_mz_1_0
        - inertias.inside_joint_3_mz_1_1
        - (screws.inside_joint_3_mz_0 - screws.inside_joint_3_mz_1);
    let three_joint_3_x_7 = poses.sin_joint_1 * inertias.inertia_link_3_zz
        - (inertias.inside_joint_3_my_0_1
            + poses.sin_joint_1 * inertias.inertia_link_3_xx)
        - (screws.inside_joint_3_my_4 - screws.inside_joint_3_my_3);
    let three_joint_3_y_7 = poses.cos_joint_1 * inertias.inertia_link_3_yy
        + inertias.inside_joint_3_mx_0_1 - poses.cos_joint_1 * inertias.inertia_link_3_zz
        - (screws.inside_joint_3_mx_3 + screws.inside_joint_3_mx_4);
    let three_joint_3_x = (three_joint_3_x_0 + three_joint_3_x_1
        - (three_joint_3_x_3 + three_joint_3_x_3)) * mu[0] + three_joint_3_x_5 * mu[1]
        + three_joint_3_x_7 * mu[2];
    let three_joint_3_y = three_joint_3_x_5 * mu[0]
        + (three_joint_3_y_3 + three_joint_3_y_3
            + (three_joint_3_x_1 - three_joint_3_y_5)) * mu[1]
        + three_joint_3_y_7 * mu[2];
    let three_joint_3_z = three_joint_3_x_7 * mu[0] + three_joint_3_y_7 * mu[1]
        + (three_joint_3_z_5 + three_joint_3_z_5
            + (three_joint_3_x_0 - three_joint_3_y_5)) * mu[2];
    let b2_2_0 = (reactions.reaction_joint_1_wx * three_joint_3_x
        + reactions.reaction_joint_1_wy * three_joint_3_y
        + reactions.reaction_joint_1_wz * three_joint_3_z
        + six_joint_1_mx * screws.connection_joint_3_wx
        + six_joint_1_my * screws.connection_joint_3_wy
        + six_joint_1_mz * screws.connection_joint_3_wz) * 0.5;
    b2[0][2] = 0.0 - b2_2_0;
    // B_2(μ) column joint_2
    b2[1][0] = b2_1_0 + 0.0;
    b2[1][1] = 0.0;
    let six_joint_2_fy_1 = mu[0] * 260.0;
    let six_joint_2_fx_3 = mu[1] * 260.0;
    let six_joint_2_fx_1 = mu[2] * 260.0;
    let six_joint_2_mx_5 = poses.sin_joint_1 * complements.complement_link_2_xz;
    let six_joint_2_my_9 = poses.cos_joint_1 * complements.complement_link_2_yz;
    let six_joint_2_mz_9 = six_joint_2_my_9 - six_joint_2_mx_5;
    let six_joint_2_my_6_1 = complements.minus_complement_link_2_hx
        * screws.minus_screw_joint_2_vx;
    let six_joint_2_mx_6_1 = complements.complement_link_2_hy * screws.screw_joint_2_vy;
    let six_joint_2_mx_7_1 = complements.complement_link_2_hz
        * screws.minus_screw_joint_2_vz;
    let six_joint_2_mx_6 = six_joint_2_mx_6_1 + six_joint_2_mx_6_1;
    let six_joint_2_mx_7 = six_joint_2_mx_7_1 + six_joint_2_mx_7_1;
    let six_joint_2_my_6 = six_joint_2_my_6_1 + six_joint_2_my_6_1;
    let six_joint_2_mx_9 = complements.outside_joint_2_mz_0_1
        - complements.outside_joint_2_mz_0_0
        + (screws.outside_joint_2_mz_1_1 + screws.outside_joint_2_mz_1_0);
    let six_joint_2_mx_11 = poses.sin_joint_1 * complements.complement_link_2_zz
        + (complements.outside_joint_2_my_0_0
            - poses.sin_joint_1 * complements.complement_link_2_xx)
        - (screws.outside_joint_2_my_1_1 - screws.outside_joint_2_my_1_0);
    let six_joint_2_my_11 = poses.cos_joint_1 * complements.complement_link_2_yy
        - complements.outside_joint_2_mx_0_1
        - poses.cos_joint_1 * complements.complement_link_2_zz
        - (screws.outside_joint_2_mx_1_1 - screws.outside_joint_2_mx_1_0);
    let six_joint_2_mx = reactions.reaction_joint_2_wy * six_joint_1_mx_1
        - reactions.reaction_joint_2_wz * six_joint_1_mx_3
        - ((six_joint_2_mx_5 + six_joint_2_mx_5 + (six_joint_2_mx_6 - six_joint_2_mx_7))
            * mu[0] + six_joint_2_mx_9 * mu[1] + six_joint_2_mx_11 * mu[2]);
    let six_joint_2_my = reactions.reaction_joint_2_wz * six_joint_1_my_1
        - reactions.reaction_joint_2_wx * six_joint_1_mx_1
        - (six_joint_2_mx_9 * mu[0]
            + (six_joint_2_my_6 - six_joint_2_mx_7
                - (six_joint_2_my_9 + six_joint_2_my_9)) * mu[1]
            + six_joint_2_my_11 * mu[2]);
    let six_joint_2_mz = reactions.reaction_joint_2_wx * six_joint_1_mx_3
        - reactions.reaction_joint_2_wy * six_joint_1_my_1
        - (six_joint_2_mx_11 * mu[0] + six_joint_2_my_11 * mu[1]
            + (six_joint_2_mz_9 + six_joint_2_mz_9
                + (six_joint_2_my_6 + six_joint_2_mx_6)) * mu[2]);
    let six_joint_2_fx = reactions.reaction_joint_2_vy * six_joint_2_fx_1
        - reactions.reaction_joint_2_vz * six_joint_2_fx_3;
    let six_joint_2_fy = reactions.reaction_joint_2_vz * six_joint_2_fy_1
        - reactions.reaction_joint_2_vx * six_joint_2_fx_1;
    let six_joint_2_fz = reactions.reaction_joint_2_vx * six_joint_2_fx_3
        - reactions.reaction_joint_2_vy * six_joint_2_fy_1;
    let b2_2_1 = (reactions.reaction_joint_2_wx * three_joint_3_x
        + reactions.reaction_joint_2_wy * three_joint_3_y
        + reactions.reaction_joint_2_wz * three_joint_3_z
        + six_joint_2_mx * screws.connection_joint_3_wx
        + six_joint_2_my * screws.connection_joint_3_wy
        + six_joint_2_mz * screws.connection_joint_3_wz
        + six_joint_2_fx * screws.connection_joint_3_vx
        + six_joint_2_fy * screws.connection_joint_3_vy
        + six_joint_2_fz * screws.connection_joint_3_vz) * 0.5;
    b2[1][2] = 0.0 - b2_2_1;
    // B_2(μ) column joint_3
    b2[2][0] = b2_2_0 + 0.0;
    b2[2][1] = b2_2_1 + 0.0;
    b2[2][2] = 0.0;
}
/// What only `base_twist` computes.
#[inline(never)]
fn base_twist_itself(
    mu: &[f64; 6],
    poses: &Poses,
    velocities: &Velocities,
    base_twist: &mut [f64; 6],
) {
    // V₁
    base_twist[0] = mu[0] - velocities.minus_velocity_base_wx + 0.0;
    base_twist[1] = mu[1] - velocities.minus_velocity_base_wy + 0.0;
    base_twist[2] = mu[2] - velocities.minus_velocity_base_wz + 0.0;
    let base_twist_3_2 = poses.com_z + 0.023809523809523808;
    base_twist[3] = mu[3]
        + (velocities.minus_velocity_base_wy * base_twist_3_2
            + velocities.minus_velocity_base_wz * poses.minus_com_y
            - velocities.minus_velocity_base_vx) + 0.0;
    base_twist[4] = mu[4]
        + (velocities.minus_velocity_base_wz * poses.com_x
            - velocities.minus_velocity_base_wx * base_twist_3_2
            - velocities.minus_velocity_base_vy) + 0.0;
    base_twist[5] = mu[5]
        - (velocities.minus_velocity_base_vz
            + (velocities.minus_velocity_base_wx * poses.minus_com_y
                + velocities.minus_velocity_base_wy * poses.com_x)) + 0.0;
}
/// What only `forward_dynamics` computes.
#[inline(never)]
fn forward_dynamics_itself(
    mu: &[f64; 6],
    qd: &[f64; 3],
    gravity: &[f64; 3],
    base_wrench: &[f64; 6],
    tau: &[f64; 3],
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    velocities: &Velocities,
    common_forward_dynamics_inverse_dynamics: &CommonForwardDynamicsInverseDynamics,
    xi_dot: &mut [f64; 9],
) {
    let xi_dot_0_3_3_34_4_0_2 = poses.com_z + 0.023809523809523808;
    let xi_dot_0_3_3_34_2 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let xi_dot_0_3_3_34_32_0 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let xi_dot_0_3_3_34_32_2 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let xi_dot_0_3_3_34_32_9 = inertias.composite_link_1_xy
        + inertias.composite_link_1_xy;
    let xi_dot_0_3_3_34_11_1 = inertias.composite_link_1_hx * poses.origin_base_y;
    let xi_dot_0_3_3_34_32_8_1 = inertias.composite_link_1_hy
        * poses.minus_origin_base_x;
    let xi_dot_0_3_3_34_32_8 = xi_dot_0_3_3_34_32_8_1 + xi_dot_0_3_3_34_32_8_1;
    let xi_dot_0_3_3_34_11 = xi_dot_0_3_3_34_11_1 + xi_dot_0_3_3_34_11_1;
    let xi_dot_0_3_3_16_0 = poses.sin_joint_1 * inertias.minus_composite_link_2_xz;
    let xi_dot_0_3_3_16_1 = poses.cos_joint_1 * inertias.minus_composite_link_2_yz;
    let xi_dot_0_3_3_16 = xi_dot_0_3_3_16_0 - xi_dot_0_3_3_16_1;
    let xi_dot_0_3_3_34_15_1 = inertias.composite_link_2_hx
        * screws.minus_screw_joint_2_vx;
    let xi_dot_0_3_3_34_32_11_1 = inertias.composite_link_2_hy * screws.screw_joint_2_vy;
    let xi_dot_0_3_3_34_32_12_1 = inertias.composite_link_2_hz
        * screws.minus_screw_joint_2_vz;
    let xi_dot_0_3_3_34_32_11 = xi_dot_0_3_3_34_32_11_1 + xi_dot_0_3_3_34_32_11_1;
    let xi_dot_0_3_3_34_32_12 = xi_dot_0_3_3_34_32_12_1 + xi_dot_0_3_3_34_32_12_1;
    let xi_dot_0_3_3_34_15 = xi_dot_0_3_3_34_15_1 + xi_dot_0_3_3_34_15_1;
    let xi_dot_0_3_3_21_0 = poses.sin_joint_1 * inertias.minus_inertia_link_3_xz;
    let xi_dot_0_3_3_21_1 = poses.cos_joint_1 * inertias.minus_inertia_link_3_yz;
    let xi_dot_0_3_3_21 = xi_dot_0_3_3_21_0 - xi_dot_0_3_3_21_1;
    let xi_dot_0_3_3_34_21_1 = inertias.inertia_link_3_hx
        * screws.minus_screw_joint_3_vx;
    let xi_dot_0_3_3_34_32_16_1 = inertias.inertia_link_3_hy * screws.screw_joint_3_vy;
    let xi_dot_0_3_3_34_32_17_1 = inertias.inertia_link_3_hz * screws.screw_joint_3_vz;
    let xi_dot_0_3_3_34_32_16 = xi_dot_0_3_3_34_32_16_1 + xi_dot_0_3_3_34_32_16_1;
    let xi_dot_0_3_3_34_32_17 = xi_dot_0_3_3_34_32_17_1 + xi_dot_0_3_3_34_32_17_1;
    let xi_dot_0_3_3_34_21 = xi_dot_0_3_3_34_21_1 + xi_dot_0_3_3_34_21_1;
    let xi_dot_0_3_3_34_4_0 = mu[3]
        + (mu[1] * xi_dot_0_3_3_34_4_0_2 + mu[2] * poses.minus_com_y);
    let xi_dot_0_3_3_34_32_6_0 = mu[4]
        + (mu[2] * poses.com_x - mu[0] * xi_dot_0_3_3_34_4_0_2);
    let xi_dot_0_3_3_34_32_4_0 = mu[5]
        - (mu[0] * poses.minus_com_y + mu[1] * poses.com_x);
    let xi_dot_0_3_3_34_4 = xi_dot_0_3_3_34_4_0 * 130.0;
    let xi_dot_0_3_3_34_32_6 = xi_dot_0_3_3_34_32_6_0 * 130.0;
    let xi_dot_0_3_3_34_32_4 = xi_dot_0_3_3_34_32_4_0 * 130.0;
    let xi_dot_0_3_3_34_32_22 = (inertias.composite_link_1_xx
        - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 + inertias.inside_joint_1_mz_1_1)) * qd[0]
        + (inertias.inside_joint_2_mz_1_0 - inertias.inside_joint_2_mz_1_1
            - (screws.inside_joint_2_mz_0 - screws.inside_joint_2_mz_1)) * qd[1]
        + (inertias.inside_joint_3_mz_1_0 - inertias.inside_joint_3_mz_1_1
            - (screws.inside_joint_3_mz_0 - screws.inside_joint_3_mz_1)) * qd[2];
    let xi_dot_0_3_3_34_32_24 = (poses.sin_joint_1 * inertias.composite_link_2_zz
        - (inertias.inside_joint_2_my_0_1
            + poses.sin_joint_1 * inertias.composite_link_2_xx)
        + (screws.inside_joint_2_my_3 + screws.inside_joint_2_my_4)) * qd[1]
        - screws.inside_joint_1_my * qd[0]
        + (poses.sin_joint_1 * inertias.inertia_link_3_zz
            - (inertias.inside_joint_3_my_0_1
                + poses.sin_joint_1 * inertias.inertia_link_3_xx)
            - (screws.inside_joint_3_my_4 - screws.inside_joint_3_my_3)) * qd[2];
    let xi_dot_0_3_3_34_24 = screws.inside_joint_1_mx * qd[0]
        + (poses.cos_joint_1 * inertias.composite_link_2_yy
            + inertias.inside_joint_2_mx_0_1
            - poses.cos_joint_1 * inertias.composite_link_2_zz
            - (screws.inside_joint_2_mx_4 - screws.inside_joint_2_mx_3)) * qd[1]
        + (poses.cos_joint_1 * inertias.inertia_link_3_yy
            + inertias.inside_joint_3_mx_0_1
            - poses.cos_joint_1 * inertias.inertia_link_3_zz
            - (screws.inside_joint_3_mx_3 + screws.inside_joint_3_mx_4)) * qd[2];
    let xi_dot_0_3_3_34_28 = velocities.minus_velocity_base_vx * 130.0;
    let xi_dot_0_3_3_34_32_26 = velocities.minus_velocity_base_vy * 130.0;
    let xi_dot_0_3_3_34_32_28 = velocities.minus_velocity_base_vz * 130.0;
    let xi_dot_0_3_3_34_1 = mu[0] - velocities.minus_velocity_base_wx;
    let xi_dot_0_3_3_34_32_3 = mu[1] - velocities.minus_velocity_base_wy;
    let xi_dot_0_3_3_34_32_1 = mu[2] - velocities.minus_velocity_base_wz;
    let wrench_base_mx_4 = base_wrench[0]
        + (base_wrench[4] * xi_dot_0_3_3_34_4_0_2 + base_wrench[5] * poses.minus_com_y);
    let wrench_base_my_4 = base_wrench[1]
        + (base_wrench[5] * poses.com_x - base_wrench[3] * xi_dot_0_3_3_34_4_0_2);
    let wrench_base_mz_4 = base_wrench[2]
        - (base_wrench[3] * poses.minus_com_y + base_wrench[4] * poses.com_x);
    let xi_dot_0_3_3_34_32 = xi_dot_0_3_3_34_32_0 * xi_dot_0_3_3_34_32_1
        - xi_dot_0_3_3_34_32_2 * xi_dot_0_3_3_34_32_3
        + (xi_dot_0_3_3_34_32_4 * velocities.minus_velocity_base_vy
            - xi_dot_0_3_3_34_32_6 * velocities.minus_velocity_base_vz)
        - (((xi_dot_0_3_3_34_32_8 - xi_dot_0_3_3_34_32_9) * qd[0]
            + (xi_dot_0_3_3_34_32_11 - xi_dot_0_3_3_34_32_12
                - (xi_dot_0_3_3_16_0 + xi_dot_0_3_3_16_0)) * qd[1]
            + (xi_dot_0_3_3_34_32_16 + xi_dot_0_3_3_34_32_17
                - (xi_dot_0_3_3_21_0 + xi_dot_0_3_3_21_0)) * qd[2]) * mu[0]
            + xi_dot_0_3_3_34_32_22 * mu[1] + xi_dot_0_3_3_34_32_24 * mu[2]
            + (xi_dot_0_3_3_34_32_26 * xi_dot_0_3_3_34_32_4_0
                - xi_dot_0_3_3_34_32_28 * xi_dot_0_3_3_34_32_6_0)) + wrench_base_mx_4;
    let xi_dot_0_3_3_34 = xi_dot_0_3_3_34_32_2 * xi_dot_0_3_3_34_1
        - xi_dot_0_3_3_34_2 * xi_dot_0_3_3_34_32_1
        + (xi_dot_0_3_3_34_4 * velocities.minus_velocity_base_vz
            - xi_dot_0_3_3_34_32_4 * velocities.minus_velocity_base_vx)
        - (xi_dot_0_3_3_34_32_22 * mu[0]
            + ((xi_dot_0_3_3_34_32_9 + xi_dot_0_3_3_34_11) * qd[0]
                + (xi_dot_0_3_3_16_1 + xi_dot_0_3_3_16_1
                    - (xi_dot_0_3_3_34_15 + xi_dot_0_3_3_34_32_12)) * qd[1]
                + (xi_dot_0_3_3_21_1 + xi_dot_0_3_3_21_1
                    + (xi_dot_0_3_3_34_32_17 - xi_dot_0_3_3_34_21)) * qd[2]) * mu[1]
            + xi_dot_0_3_3_34_24 * mu[2]
            + (xi_dot_0_3_3_34_32_28 * xi_dot_0_3_3_34_4_0
                - xi_dot_0_3_3_34_28 * xi_dot_0_3_3_34_32_4_0)) + wrench_base_my_4
        - inertias.locked_inverse_pivot_y_2 * xi_dot_0_3_3_34_32;
    let xi_dot_0_3_3 = (xi_dot_0_3_3_34_2 * xi_dot_0_3_3_34_32_3
        - xi_dot_0_3_3_34_32_0 * xi_dot_0_3_3_34_1
        + (xi_dot_0_3_3_34_32_6 * velocities.minus_velocity_base_vx
            - xi_dot_0_3_3_34_4 * velocities.minus_velocity_base_vy)
        - (xi_dot_0_3_3_34_32_24 * mu[0] + xi_dot_0_3_3_34_24 * mu[1]
            + ((xi_dot_0_3_3_34_11 + xi_dot_0_3_3_34_32_8) * qd[0]
                + (xi_dot_0_3_3_16 + xi_dot_0_3_3_16
                    + (xi_dot_0_3_3_34_32_11 - xi_dot_0_3_3_34_15)) * qd[1]
                + (xi_dot_0_3_3_21 + xi_dot_0_3_3_21
                    + (xi_dot_0_3_3_34_32_16 - xi_dot_0_3_3_34_21)) * qd[2]) * mu[2]
            + (xi_dot_0_3_3_34_28 * xi_dot_0_3_3_34_32_6_0
                - xi_dot_0_3_3_34_32_26 * xi_dot_0_3_3_34_4_0)) + wrench_base_mz_4
        - inertias.locked_inverse_pivot_z_2 * xi_dot_0_3_3_34_32
        - inertias.locked_inverse_pivot_z_4 * xi_dot_0_3_3_34)
        * inertias.locked_inverse_pivot_z;
    let xi_dot_0_3 = xi_dot_0_3_3_34 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * xi_dot_0_3_3;
    let xi_dot_0 = xi_dot_0_3_3_34_32 * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * xi_dot_0_3
        - inertias.locked_inverse_pivot_z_2 * xi_dot_0_3_3;
    // ξ\u{307} = [μ\u{307}; q\u{308}]
    xi_dot[0] = xi_dot_0 + 0.0;
    xi_dot[1] = xi_dot_0_3 + 0.0;
    xi_dot[2] = xi_dot_0_3_3 + 0.0;
    xi_dot[3] = (xi_dot_0_3_3_34_32_6 * xi_dot_0_3_3_34_32_1
        - xi_dot_0_3_3_34_32_4 * xi_dot_0_3_3_34_32_3
        - (mu[1] * xi_dot_0_3_3_34_32_28 - mu[2] * xi_dot_0_3_3_34_32_26)
        + base_wrench[3]) * 0.007692307692307693
        - (xi_dot_0_3 * xi_dot_0_3_3_34_4_0_2 + xi_dot_0_3_3 * poses.minus_com_y)
        + gravity[0] + 0.0;
    xi_dot[4] = (xi_dot_0_3_3_34_32_4 * xi_dot_0_3_3_34_1
        - xi_dot_0_3_3_34_4 * xi_dot_0_3_3_34_32_1
        - (mu[2] * xi_dot_0_3_3_34_28 - mu[0] * xi_dot_0_3_3_34_32_28) + base_wrench[4])
        * 0.007692307692307693
        + (xi_dot_0 * xi_dot_0_3_3_34_4_0_2 - xi_dot_0_3_3 * poses.com_x) + gravity[1]
        + 0.0;
    xi_dot[5] = (xi_dot_0_3_3_34_4 * xi_dot_0_3_3_34_32_3
        - xi_dot_0_3_3_34_32_6 * xi_dot_0_3_3_34_1
        - (mu[0] * xi_dot_0_3_3_34_32_26 - mu[1] * xi_dot_0_3_3_34_28) + base_wrench[5])
        * 0.007692307692307693
        + (xi_dot_0 * poses.minus_com_y + xi_dot_0_3 * poses.com_x) + gravity[2] + 0.0;
    let wrench_link_2_mx_1 = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_0_0_0_1_0_0
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_0_1_0_1;
    let wrench_link_2_mx_3 = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_0_0_1_1_0_0
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_1_1_0_1;
    let wrench_link_2_my_7 = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_my_0_1_0_1_0_0
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_my_0_1_0_1_0_1;
    let wrench_link_2_mx_9 = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_1_1_1_0_0
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_1_1_0_1;
    let wrench_link_2_mx_7 = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_1_0_1_0_0
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_0_1_0_1;
    let wrench_link_3_mx_1 = wrench_link_2_mx_1
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_0_1_1;
    let wrench_link_3_mx_3 = wrench_link_2_mx_3
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_1_1_1;
    let wrench_link_3_mx_5 = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_0_1_1_0
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_1_1_1;
    let wrench_link_3_my_7 = wrench_link_2_my_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_my_0_1_0_1_1;
    let wrench_link_3_mx_9 = wrench_link_2_mx_9
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_1_1_1;
    let wrench_link_3_mx_7 = wrench_link_2_mx_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_0_1_1;
    let wrench_link_3_mx = inertias.inertia_link_3_xx * wrench_link_3_mx_1
        - inertias.minus_inertia_link_3_xy * wrench_link_3_mx_3
        - inertias.minus_inertia_link_3_xz * wrench_link_3_mx_5
        + (inertias.inertia_link_3_hy * wrench_link_3_mx_7
            - inertias.inertia_link_3_hz * wrench_link_3_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_1;
    let wrench_link_3_my = inertias.inertia_link_3_yy * wrench_link_3_mx_3
        - inertias.minus_inertia_link_3_xy * wrench_link_3_mx_1
        - inertias.minus_inertia_link_3_yz * wrench_link_3_mx_5
        + (inertias.inertia_link_3_hz * wrench_link_3_my_7
            - inertias.inertia_link_3_hx * wrench_link_3_mx_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_my_1;
    let wrench_link_3_mz = inertias.inertia_link_3_zz * wrench_link_3_mx_5
        - (inertias.minus_inertia_link_3_xz * wrench_link_3_mx_1
            + inertias.minus_inertia_link_3_yz * wrench_link_3_mx_3)
        + (inertias.inertia_link_3_hx * wrench_link_3_mx_9
            - inertias.inertia_link_3_hy * wrench_link_3_my_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mz_1;
    let wrench_link_3_fx = wrench_link_3_my_7 * 10.0
        + (wrench_link_3_mx_3 * inertias.inertia_link_3_hz
            - wrench_link_3_mx_5 * inertias.inertia_link_3_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fx_1;
    let wrench_link_3_fy = wrench_link_3_mx_9 * 10.0
        + (wrench_link_3_mx_5 * inertias.inertia_link_3_hx
            - wrench_link_3_mx_1 * inertias.inertia_link_3_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fy_1;
    let wrench_link_3_fz = wrench_link_3_mx_7 * 10.0
        + (wrench_link_3_mx_1 * inertias.inertia_link_3_hy
            - wrench_link_3_mx_3 * inertias.inertia_link_3_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fz_1;
    let inverse_pivot_joint_3_d = 1.0
        / (poses.cos_joint_1 * screws.inside_joint_3_mx
            + poses.sin_joint_1 * screws.inside_joint_3_my
            - screws.minus_screw_joint_3_vx * screws.inside_joint_3_fx
            + screws.screw_joint_3_vy * screws.inside_joint_3_fy
            + screws.screw_joint_3_vz * screws.inside_joint_3_fz);
    let wrench_link_2_mx_13_0 = tau[2]
        - (poses.cos_joint_1 * wrench_link_3_mx + poses.sin_joint_1 * wrench_link_3_my
            - screws.minus_screw_joint_3_vx * wrench_link_3_fx
            + screws.screw_joint_3_vy * wrench_link_3_fy
            + screws.screw_joint_3_vz * wrench_link_3_fz);
    let wrench_link_2_mx_13 = wrench_link_2_mx_13_0 * inverse_pivot_joint_3_d;
    let wrench_link_2_mx = inertias.inertia_link_2_xx * wrench_link_2_mx_1
        - inertias.minus_inertia_link_2_xy * wrench_link_2_mx_3
        - inertias.minus_inertia_link_2_xz
            * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_1_1_0
        + (inertias.inertia_link_2_hy * wrench_link_2_mx_7
            - inertias.inertia_link_2_hz * wrench_link_2_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_mx_0_1
        + (wrench_link_3_mx + screws.inside_joint_3_mx * wrench_link_2_mx_13);
    let wrench_link_2_my = inertias.inertia_link_2_yy * wrench_link_2_mx_3
        - inertias.minus_inertia_link_2_xy * wrench_link_2_mx_1
        - inertias.minus_inertia_link_2_yz
            * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_1_1_0
        + (inertias.inertia_link_2_hz * wrench_link_2_my_7
            - inertias.inertia_link_2_hx * wrench_link_2_mx_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_my_0_1
        + (wrench_link_3_my + screws.inside_joint_3_my * wrench_link_2_mx_13);
    let wrench_link_2_mz = inertias.inertia_link_2_zz
        * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_1_1_0
        - (inertias.minus_inertia_link_2_xz * wrench_link_2_mx_1
            + inertias.minus_inertia_link_2_yz * wrench_link_2_mx_3)
        + (inertias.inertia_link_2_hx * wrench_link_2_mx_9
            - inertias.inertia_link_2_hy * wrench_link_2_my_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_mz_0_1
        + (wrench_link_3_mz + screws.inside_joint_3_mz * wrench_link_2_mx_13);
    let wrench_link_2_fx = wrench_link_2_my_7 * 10.0
        + (wrench_link_2_mx_3 * inertias.inertia_link_2_hz
            - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_1_1_0
                * inertias.inertia_link_2_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fx_0_1
        + (wrench_link_3_fx + screws.inside_joint_3_fx * wrench_link_2_mx_13);
    let wrench_link_2_fy = wrench_link_2_mx_9 * 10.0
        + (common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_1_1_0
            * inertias.inertia_link_2_hx
            - wrench_link_2_mx_1 * inertias.inertia_link_2_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fy_0_1
        + (wrench_link_3_fy + screws.inside_joint_3_fy * wrench_link_2_mx_13);
    let wrench_link_2_fz = wrench_link_2_mx_7 * 10.0
        + (wrench_link_2_mx_1 * inertias.inertia_link_2_hy
            - wrench_link_2_mx_3 * inertias.inertia_link_2_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fz_0_1
        + (wrench_link_3_fz + screws.inside_joint_3_fz * wrench_link_2_mx_13);
    let minus_articulated_link_2_hxx_0 = screws.inside_joint_3_mx
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_hyy_0 = screws.inside_joint_3_my
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_hzz_0 = screws.inside_joint_3_mz
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_mxy_0 = screws.inside_joint_3_fx
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_myz_0 = screws.inside_joint_3_fy
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_hxx = minus_articulated_link_2_hxx_0
        * screws.inside_joint_3_fx;
    let minus_articulated_link_2_hyy = minus_articulated_link_2_hyy_0
        * screws.inside_joint_3_fy;
    let minus_articulated_link_2_hzz = minus_articulated_link_2_hzz_0
        * screws.inside_joint_3_fz;
    let minus_articulated_link_2_mxy = minus_articulated_link_2_mxy_0
        * screws.inside_joint_3_fy;
    let minus_articulated_link_2_mxz = minus_articulated_link_2_mxy_0
        * screws.inside_joint_3_fz;
    let minus_articulated_link_2_myz = minus_articulated_link_2_myz_0
        * screws.inside_joint_3_fz;
    let articulated_link_2_jxx = inertias.inertia_link_2_xx
        + (inertias.inertia_link_3_xx
            - minus_articulated_link_2_hxx_0 * screws.inside_joint_3_mx);
    let minus_articulated_link_2_jxy = inertias.minus_inertia_link_2_xy
        + (inertias.minus_inertia_link_3_xy
            + minus_articulated_link_2_hxx_0 * screws.inside_joint_3_my);
    let minus_articulated_link_2_jxz = inertias.minus_inertia_link_2_xz
        + (inertias.minus_inertia_link_3_xz
            + minus_articulated_link_2_hxx_0 * screws.inside_joint_3_mz);
    let articulated_link_2_jyy = inertias.inertia_link_2_yy
        + (inertias.inertia_link_3_yy
            - minus_articulated_link_2_hyy_0 * screws.inside_joint_3_my);
    let minus_articulated_link_2_jyz = inertias.minus_inertia_link_2_yz
        + (inertias.minus_inertia_link_3_yz
            + minus_articulated_link_2_hyy_0 * screws.inside_joint_3_mz);
    let articulated_link_2_jzz = inertias.inertia_link_2_zz
        + (inertias.inertia_link_3_zz
            - minus_articulated_link_2_hzz_0 * screws.inside_joint_3_mz);
    let articulated_link_2_hyx = inertias.inertia_link_2_hz
        + (inertias.inertia_link_3_hz
            - minus_articulated_link_2_hyy_0 * screws.inside_joint_3_fx);
    let minus_articulated_link_2_hzx = inertias.inertia_link_2_hy
        + (inertias.inertia_link_3_hy
            + minus_articulated_link_2_hzz_0 * screws.inside_joint_3_fx);
    let minus_articulated_link_2_hxy = inertias.inertia_link_2_hz
        + (inertias.inertia_link_3_hz
            + minus_articulated_link_2_hxx_0 * screws.inside_joint_3_fy);
    let articulated_link_2_hzy = inertias.inertia_link_2_hx
        + (inertias.inertia_link_3_hx
            - minus_articulated_link_2_hzz_0 * screws.inside_joint_3_fy);
    let articulated_link_2_hxz = inertias.inertia_link_2_hy
        + (inertias.inertia_link_3_hy
            - minus_articulated_link_2_hxx_0 * screws.inside_joint_3_fz);
    let minus_articulated_link_2_hyz = inertias.inertia_link_2_hx
        + (inertias.inertia_link_3_hx
            + minus_articulated_link_2_hyy_0 * screws.inside_joint_3_fz);
    let articulated_link_2_mxx = 10.0
        + (10.0 - minus_articulated_link_2_mxy_0 * screws.inside_joint_3_fx);
    let articulated_link_2_myy = 10.0
        + (10.0 - minus_articulated_link_2_myz_0 * screws.inside_joint_3_fy);
    let articulated_link_2_mzz = 10.0
        + (10.0
            - screws.inside_joint_3_fz * inverse_pivot_joint_3_d
                * screws.inside_joint_3_fz);
    let wrench_outside_link_2_mx = articulated_link_2_jxx * poses.cos_joint_1
        - minus_articulated_link_2_jxy * poses.sin_joint_1
        + (minus_articulated_link_2_hxx * screws.minus_screw_joint_2_vx
            - minus_articulated_link_2_hxy * screws.screw_joint_2_vy
            - articulated_link_2_hxz * screws.minus_screw_joint_2_vz);
    let wrench_outside_link_2_my = articulated_link_2_jyy * poses.sin_joint_1
        - minus_articulated_link_2_jxy * poses.cos_joint_1
        + (minus_articulated_link_2_hyz * screws.minus_screw_joint_2_vz
            - (minus_articulated_link_2_hyy * screws.screw_joint_2_vy
                + articulated_link_2_hyx * screws.minus_screw_joint_2_vx));
    let wrench_outside_link_2_mz = minus_articulated_link_2_hzz
        * screws.minus_screw_joint_2_vz
        + (articulated_link_2_hzy * screws.screw_joint_2_vy
            + minus_articulated_link_2_hzx * screws.minus_screw_joint_2_vx)
        - (minus_articulated_link_2_jxz * poses.cos_joint_1
            + minus_articulated_link_2_jyz * poses.sin_joint_1);
    let wrench_outside_link_2_fx = articulated_link_2_hyx * poses.sin_joint_1
        - minus_articulated_link_2_hxx * poses.cos_joint_1
        + (minus_articulated_link_2_mxz * screws.minus_screw_joint_2_vz
            - (articulated_link_2_mxx * screws.minus_screw_joint_2_vx
                + minus_articulated_link_2_mxy * screws.screw_joint_2_vy));
    let wrench_outside_link_2_fy = minus_articulated_link_2_mxy
        * screws.minus_screw_joint_2_vx
        + articulated_link_2_myy * screws.screw_joint_2_vy
        + minus_articulated_link_2_myz * screws.minus_screw_joint_2_vz
        - (minus_articulated_link_2_hxy * poses.cos_joint_1
            + minus_articulated_link_2_hyy * poses.sin_joint_1);
    let wrench_outside_link_2_fz = articulated_link_2_hxz * poses.cos_joint_1
        - minus_articulated_link_2_hyz * poses.sin_joint_1
        + (minus_articulated_link_2_mxz * screws.minus_screw_joint_2_vx
            - minus_articulated_link_2_myz * screws.screw_joint_2_vy
            - articulated_link_2_mzz * screws.minus_screw_joint_2_vz);
    let inverse_pivot_joint_2_d = 1.0
        / (poses.cos_joint_1 * wrench_outside_link_2_mx
            + poses.sin_joint_1 * wrench_outside_link_2_my
            - screws.minus_screw_joint_2_vx * wrench_outside_link_2_fx
            + screws.screw_joint_2_vy * wrench_outside_link_2_fy
            - screws.minus_screw_joint_2_vz * wrench_outside_link_2_fz);
    let wrench_link_1_mx_11_0 = tau[1]
        - (poses.cos_joint_1 * wrench_link_2_mx + poses.sin_joint_1 * wrench_link_2_my
            - screws.minus_screw_joint_2_vx * wrench_link_2_fx
            + screws.screw_joint_2_vy * wrench_link_2_fy
            - screws.minus_screw_joint_2_vz * wrench_link_2_fz);
    let wrench_link_1_mx_11 = wrench_link_1_mx_11_0 * inverse_pivot_joint_2_d;
    let wrench_link_1_mx = inertias.inertia_link_1_xx
        * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_0_1_0_0
        - inertias.inertia_link_1_xy
            * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_1_1_0_1
        + (inertias.inertia_link_1_hy
            * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_0_1_0_0
            - inertias.inertia_link_1_hz
                * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_1_1_0_0)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_mx_0_1
        + (wrench_link_2_mx + wrench_outside_link_2_mx * wrench_link_1_mx_11);
    let wrench_link_1_my = inertias.inertia_link_1_xy
        * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_0_1_0_0
        - inertias.inertia_link_1_yy
            * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_1_1_0_1
        + (inertias.inertia_link_1_hz
            * common_forward_dynamics_inverse_dynamics.wrench_link_3_my_0_1_0_1_0_0
            + inertias.minus_inertia_link_1_hx
                * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_0_1_0_0)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_my_0_1
        + (wrench_link_2_my + wrench_outside_link_2_my * wrench_link_1_mx_11);
    let wrench_link_1_mz = inertias.inertia_link_1_xz
        * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_0_1_0_0
        + inertias.minus_inertia_link_1_yz
            * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_1_1_0_1
        - (inertias.minus_inertia_link_1_hx
            * common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_1_1_0_0
            + inertias.inertia_link_1_hy
                * common_forward_dynamics_inverse_dynamics.wrench_link_3_my_0_1_0_1_0_0)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_mz_0_1
        + (wrench_link_2_mz + wrench_outside_link_2_mz * wrench_link_1_mx_11);
    let wrench_link_1_fx = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_my_0_1_0_1_0_0 * 5.0
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_1_1_0_1
            * inertias.inertia_link_1_hz
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_fx_0_1
        + (wrench_link_2_fx + wrench_outside_link_2_fx * wrench_link_1_mx_11);
    let wrench_link_1_fy = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_1_1_1_0_0 * 5.0
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_0_1_0_0
            * inertias.inertia_link_1_hz
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_fy_0_1
        + (wrench_link_2_fy + wrench_outside_link_2_fy * wrench_link_1_mx_11);
    let wrench_link_1_fz = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_1_0_1_0_0 * 5.0
        + (common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_0_1_0_0
            * inertias.inertia_link_1_hy
            - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_1_1_0_1
                * inertias.minus_inertia_link_1_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_fz_0_1
        + (wrench_link_2_fz + wrench_outside_link_2_fz * wrench_link_1_mx_11);
    let minus_articulated_link_1_hxx_1 = wrench_outside_link_2_mx
        * inverse_pivot_joint_2_d;
    let minus_articulated_link_1_hyy_1 = wrench_outside_link_2_my
        * inverse_pivot_joint_2_d;
    let minus_articulated_link_1_hzz_1 = wrench_outside_link_2_mz
        * inverse_pivot_joint_2_d;
    let minus_articulated_link_1_mxy_1 = wrench_outside_link_2_fx
        * inverse_pivot_joint_2_d;
    let minus_articulated_link_1_myz_1 = wrench_outside_link_2_fy
        * inverse_pivot_joint_2_d;
    let minus_articulated_link_1_hxx = minus_articulated_link_2_hxx
        + minus_articulated_link_1_hxx_1 * wrench_outside_link_2_fx;
    let minus_articulated_link_1_hyy = minus_articulated_link_2_hyy
        + minus_articulated_link_1_hyy_1 * wrench_outside_link_2_fy;
    let minus_articulated_link_1_hzz = minus_articulated_link_2_hzz
        + minus_articulated_link_1_hzz_1 * wrench_outside_link_2_fz;
    let minus_articulated_link_1_mxy = minus_articulated_link_2_mxy
        + minus_articulated_link_1_mxy_1 * wrench_outside_link_2_fy;
    let minus_articulated_link_1_mxz = minus_articulated_link_2_mxz
        + minus_articulated_link_1_mxy_1 * wrench_outside_link_2_fz;
    let minus_articulated_link_1_myz = minus_articulated_link_2_myz
        + minus_articulated_link_1_myz_1 * wrench_outside_link_2_fz;
    let articulated_link_1_jxx = inertias.inertia_link_1_xx
        + (articulated_link_2_jxx
            - minus_articulated_link_1_hxx_1 * wrench_outside_link_2_mx);
    let articulated_link_1_jxy = inertias.inertia_link_1_xy
        - (minus_articulated_link_2_jxy
            + minus_articulated_link_1_hxx_1 * wrench_outside_link_2_my);
    let articulated_link_1_jxz = inertias.inertia_link_1_xz
        - (minus_articulated_link_2_jxz
            + minus_articulated_link_1_hxx_1 * wrench_outside_link_2_mz);
    let articulated_link_1_jyy = inertias.inertia_link_1_yy
        + (articulated_link_2_jyy
            - minus_articulated_link_1_hyy_1 * wrench_outside_link_2_my);
    let minus_articulated_link_1_jyz = inertias.minus_inertia_link_1_yz
        + (minus_articulated_link_2_jyz
            + minus_articulated_link_1_hyy_1 * wrench_outside_link_2_mz);
    let articulated_link_1_jzz = inertias.inertia_link_1_zz
        + (articulated_link_2_jzz
            - minus_articulated_link_1_hzz_1 * wrench_outside_link_2_mz);
    let articulated_link_1_hyx = inertias.inertia_link_1_hz
        + (articulated_link_2_hyx
            - minus_articulated_link_1_hyy_1 * wrench_outside_link_2_fx);
    let minus_articulated_link_1_hzx = inertias.inertia_link_1_hy
        + (minus_articulated_link_2_hzx
            + minus_articulated_link_1_hzz_1 * wrench_outside_link_2_fx);
    let minus_articulated_link_1_hxy = inertias.inertia_link_1_hz
        + (minus_articulated_link_2_hxy
            + minus_articulated_link_1_hxx_1 * wrench_outside_link_2_fy);
    let articulated_link_1_hzy = articulated_link_2_hzy
        - minus_articulated_link_1_hzz_1 * wrench_outside_link_2_fy
        - inertias.minus_inertia_link_1_hx;
    let articulated_link_1_hxz = inertias.inertia_link_1_hy
        + (articulated_link_2_hxz
            - minus_articulated_link_1_hxx_1 * wrench_outside_link_2_fz);
    let articulated_link_1_hyz = inertias.minus_inertia_link_1_hx
        - (minus_articulated_link_2_hyz
            + minus_articulated_link_1_hyy_1 * wrench_outside_link_2_fz);
    let articulated_link_1_mxx = 5.0
        + (articulated_link_2_mxx
            - minus_articulated_link_1_mxy_1 * wrench_outside_link_2_fx);
    let articulated_link_1_myy = 5.0
        + (articulated_link_2_myy
            - minus_articulated_link_1_myz_1 * wrench_outside_link_2_fy);
    let articulated_link_1_mzz = 5.0
        + (articulated_link_2_mzz
            - wrench_outside_link_2_fz * inverse_pivot_joint_2_d
                * wrench_outside_link_2_fz);
    let wrench_outside_link_1_mx = articulated_link_1_jxz
        - (minus_articulated_link_1_hxy * poses.minus_origin_base_x
            + minus_articulated_link_1_hxx * poses.origin_base_y);
    let wrench_outside_link_1_my = articulated_link_1_hyx * poses.origin_base_y
        - minus_articulated_link_1_hyy * poses.minus_origin_base_x
        - minus_articulated_link_1_jyz;
    let wrench_outside_link_1_mz = articulated_link_1_jzz
        + (articulated_link_1_hzy * poses.minus_origin_base_x
            - minus_articulated_link_1_hzx * poses.origin_base_y);
    let wrench_outside_link_1_fx = articulated_link_1_mxx * poses.origin_base_y
        - minus_articulated_link_1_mxy * poses.minus_origin_base_x
        - minus_articulated_link_1_hzx;
    let wrench_outside_link_1_fy = articulated_link_1_hzy
        + (articulated_link_1_myy * poses.minus_origin_base_x
            - minus_articulated_link_1_mxy * poses.origin_base_y);
    let minus_wrench_outside_link_1_fz = minus_articulated_link_1_hzz
        + (minus_articulated_link_1_mxz * poses.origin_base_y
            + minus_articulated_link_1_myz * poses.minus_origin_base_x);
    let inverse_pivot_joint_1_d = 1.0
        / (wrench_outside_link_1_mz + poses.origin_base_y * wrench_outside_link_1_fx
            + poses.minus_origin_base_x * wrench_outside_link_1_fy);
    let wrench_base_mx_2_0 = tau[0]
        - (wrench_link_1_mz + poses.origin_base_y * wrench_link_1_fx
            + poses.minus_origin_base_x * wrench_link_1_fy);
    let wrench_base_mx_2 = wrench_base_mx_2_0 * inverse_pivot_joint_1_d;
    let wrench_base_mx = wrench_link_1_mx + wrench_outside_link_1_mx * wrench_base_mx_2
        - (common_forward_dynamics_inverse_dynamics.wrench_base_mx_1_0
            + wrench_base_mx_4);
    let wrench_base_my = wrench_link_1_my + wrench_outside_link_1_my * wrench_base_mx_2
        - (common_forward_dynamics_inverse_dynamics.wrench_base_my_1_0
            + wrench_base_my_4);
    let wrench_base_mz = wrench_link_1_mz + wrench_outside_link_1_mz * wrench_base_mx_2
        - (common_forward_dynamics_inverse_dynamics.wrench_base_mz_1_0
            + wrench_base_mz_4);
    let wrench_base_fx = wrench_link_1_fx + wrench_outside_link_1_fx * wrench_base_mx_2
        - (common_forward_dynamics_inverse_dynamics.wrench_base_fx_1_0 + base_wrench[3]);
    let wrench_base_fy = wrench_link_1_fy + wrench_outside_link_1_fy * wrench_base_mx_2
        - (common_forward_dynamics_inverse_dynamics.wrench_base_fy_1_0 + base_wrench[4]);
    let wrench_base_fz = common_forward_dynamics_inverse_dynamics.wrench_base_fz_0_0
        - base_wrench[5]
        + (wrench_link_1_fz - minus_wrench_outside_link_1_fz * wrench_base_mx_2);
    let minus_articulated_base_hxx_1 = wrench_outside_link_1_mx
        * inverse_pivot_joint_1_d;
    let minus_articulated_base_hyy_1 = wrench_outside_link_1_my
        * inverse_pivot_joint_1_d;
    let articulated_base_hzz_0 = wrench_outside_link_1_mz * inverse_pivot_joint_1_d;
    let minus_articulated_base_mxy_1 = wrench_outside_link_1_fx
        * inverse_pivot_joint_1_d;
    let articulated_base_myz_0 = wrench_outside_link_1_fy * inverse_pivot_joint_1_d;
    let minus_articulated_base_hxx = minus_articulated_link_1_hxx
        + minus_articulated_base_hxx_1 * wrench_outside_link_1_fx;
    let minus_articulated_base_hyy = minus_articulated_link_1_hyy
        + minus_articulated_base_hyy_1 * wrench_outside_link_1_fy;
    let articulated_base_hzz = articulated_base_hzz_0 * minus_wrench_outside_link_1_fz
        - minus_articulated_link_1_hzz;
    let minus_articulated_base_mxy = minus_articulated_link_1_mxy
        + minus_articulated_base_mxy_1 * wrench_outside_link_1_fy;
    let articulated_base_mxz = minus_articulated_base_mxy_1
        * minus_wrench_outside_link_1_fz - minus_articulated_link_1_mxz;
    let articulated_base_myz = articulated_base_myz_0 * minus_wrench_outside_link_1_fz
        - minus_articulated_link_1_myz;
    let articulated_base_jxx = inertias.inertia_base_xx
        + (articulated_link_1_jxx
            - minus_articulated_base_hxx_1 * wrench_outside_link_1_mx);
    let articulated_base_jxy = inertias.inertia_base_xy
        + (articulated_link_1_jxy
            - minus_articulated_base_hxx_1 * wrench_outside_link_1_my);
    let articulated_base_jxz = articulated_link_1_jxz
        - minus_articulated_base_hxx_1 * wrench_outside_link_1_mz
        - inertias.minus_inertia_base_xz;
    let articulated_base_jyy = inertias.inertia_base_yy
        + (articulated_link_1_jyy
            - minus_articulated_base_hyy_1 * wrench_outside_link_1_my);
    let articulated_base_jyz = inertias.inertia_base_yz
        - (minus_articulated_link_1_jyz
            + minus_articulated_base_hyy_1 * wrench_outside_link_1_mz);
    let articulated_base_jzz = inertias.inertia_base_zz
        + (articulated_link_1_jzz - articulated_base_hzz_0 * wrench_outside_link_1_mz);
    let articulated_base_hyx = articulated_link_1_hyx
        - minus_articulated_base_hyy_1 * wrench_outside_link_1_fx
        - inertias.minus_inertia_base_hz;
    let minus_articulated_base_hzx = inertias.inertia_base_hy
        + (minus_articulated_link_1_hzx
            + articulated_base_hzz_0 * wrench_outside_link_1_fx);
    let articulated_base_hxy = inertias.minus_inertia_base_hz
        - (minus_articulated_link_1_hxy
            + minus_articulated_base_hxx_1 * wrench_outside_link_1_fy);
    let articulated_base_hzy = articulated_link_1_hzy
        - articulated_base_hzz_0 * wrench_outside_link_1_fy
        - inertias.minus_inertia_base_hx;
    let articulated_base_hxz = inertias.inertia_base_hy
        + (articulated_link_1_hxz
            + minus_articulated_base_hxx_1 * minus_wrench_outside_link_1_fz);
    let articulated_base_hyz = inertias.minus_inertia_base_hx
        + (articulated_link_1_hyz
            + minus_articulated_base_hyy_1 * minus_wrench_outside_link_1_fz);
    let articulated_base_mxx = 105.0
        + (articulated_link_1_mxx
            - minus_articulated_base_mxy_1 * wrench_outside_link_1_fx);
    let articulated_base_myy = 105.0
        + (articulated_link_1_myy - articulated_base_myz_0 * wrench_outside_link_1_fy);
    let articulated_base_mzz = 105.0
        + (articulated_link_1_mzz
            - minus_wrench_outside_link_1_fz * inverse_pivot_joint_1_d
                * minus_wrench_outside_link_1_fz);
    let twist_base_wz_19 = 1.0 / articulated_base_mxx;
    let twist_base_wz_16 = minus_articulated_base_mxy * twist_base_wz_19;
    let twist_base_wz_20 = articulated_base_mxz * twist_base_wz_19;
    let minus_twist_base_vy_1 = 1.0
        / (articulated_base_myy - twist_base_wz_16 * minus_articulated_base_mxy);
    let twist_base_vz_9_0 = articulated_base_myz
        + twist_base_wz_20 * minus_articulated_base_mxy;
    let twist_base_vz_9 = twist_base_vz_9_0 * minus_twist_base_vy_1;
    let twist_base_vz_11 = 1.0
        / (articulated_base_mzz - twist_base_wz_20 * articulated_base_mxz
            - twist_base_vz_9 * twist_base_vz_9_0);
    let minus_twist_base_wx_2_0_2_1_3_4 = articulated_base_hxy
        - twist_base_wz_16 * minus_articulated_base_hxx;
    let minus_twist_base_wx_2_0_2_1_3 = (articulated_base_hxz
        + twist_base_wz_20 * minus_articulated_base_hxx
        - twist_base_vz_9 * minus_twist_base_wx_2_0_2_1_3_4) * twist_base_vz_11;
    let minus_twist_base_wx_2_0_2_1 = minus_twist_base_wx_2_0_2_1_3_4
        * minus_twist_base_vy_1 - twist_base_vz_9 * minus_twist_base_wx_2_0_2_1_3;
    let minus_twist_base_wx_2_0_2 = twist_base_wz_16 * minus_twist_base_wx_2_0_2_1
        - minus_articulated_base_hxx * twist_base_wz_19
        - twist_base_wz_20 * minus_twist_base_wx_2_0_2_1_3;
    let twist_base_wy_1_3_3_3_4 = twist_base_wz_16 * articulated_base_hyx
        - minus_articulated_base_hyy;
    let twist_base_wy_1_3_3_3 = (articulated_base_hyz
        - twist_base_wz_20 * articulated_base_hyx
        - twist_base_vz_9 * twist_base_wy_1_3_3_3_4) * twist_base_vz_11;
    let twist_base_wy_1_3_3 = twist_base_wy_1_3_3_3_4 * minus_twist_base_vy_1
        - twist_base_vz_9 * twist_base_wy_1_3_3_3;
    let twist_base_wy_1_3 = articulated_base_hyx * twist_base_wz_19
        + twist_base_wz_16 * twist_base_wy_1_3_3
        - twist_base_wz_20 * twist_base_wy_1_3_3_3;
    let twist_base_wz_23_4 = articulated_base_hzy
        - twist_base_wz_16 * minus_articulated_base_hzx;
    let twist_base_wz_23 = (articulated_base_hzz
        + twist_base_wz_20 * minus_articulated_base_hzx
        - twist_base_vz_9 * twist_base_wz_23_4) * twist_base_vz_11;
    let twist_base_wz_17 = twist_base_wz_23_4 * minus_twist_base_vy_1
        - twist_base_vz_9 * twist_base_wz_23;
    let minus_twist_base_wx_2_0 = articulated_base_jxy
        - (articulated_base_hyx * minus_twist_base_wx_2_0_2
            - minus_articulated_base_hyy * minus_twist_base_wx_2_0_2_1
            + articulated_base_hyz * minus_twist_base_wx_2_0_2_1_3);
    let twist_base_wz_25 = articulated_base_jxz
        - (articulated_base_hzy * minus_twist_base_wx_2_0_2_1
            - minus_articulated_base_hzx * minus_twist_base_wx_2_0_2
            + articulated_base_hzz * minus_twist_base_wx_2_0_2_1_3);
    let minus_twist_base_wx_1 = 1.0
        / (articulated_base_jxx
            - (articulated_base_hxy * minus_twist_base_wx_2_0_2_1
                - minus_articulated_base_hxx * minus_twist_base_wx_2_0_2
                + articulated_base_hxz * minus_twist_base_wx_2_0_2_1_3));
    let minus_twist_base_wx_2 = minus_twist_base_wx_2_0 * minus_twist_base_wx_1;
    let twist_base_wz_24 = twist_base_wz_25 * minus_twist_base_wx_1;
    let twist_base_wy_1 = 1.0
        / (articulated_base_jyy
            - (articulated_base_hyx * twist_base_wy_1_3
                - minus_articulated_base_hyy * twist_base_wy_1_3_3
                + articulated_base_hyz * twist_base_wy_1_3_3_3)
            - minus_twist_base_wx_2 * minus_twist_base_wx_2_0);
    let twist_base_wz_27 = articulated_base_jyz
        - (articulated_base_hzy * twist_base_wy_1_3_3
            - minus_articulated_base_hzx * twist_base_wy_1_3
            + articulated_base_hzz * twist_base_wy_1_3_3_3)
        - twist_base_wz_24 * minus_twist_base_wx_2_0;
    let twist_base_wz_26 = twist_base_wz_27 * twist_base_wy_1;
    let twist_base_wz_4_4 = wrench_base_fy + twist_base_wz_16 * wrench_base_fx;
    let twist_base_wz_4 = (twist_base_wz_20 * wrench_base_fx - wrench_base_fz
        + twist_base_vz_9 * twist_base_wz_4_4) * twist_base_vz_11;
    let twist_base_wz_8 = twist_base_wz_4_4 * minus_twist_base_vy_1
        + twist_base_vz_9 * twist_base_wz_4;
    let twist_base_wz_6 = wrench_base_fx * twist_base_wz_19
        + twist_base_wz_16 * twist_base_wz_8 + twist_base_wz_20 * twist_base_wz_4;
    let twist_base_wz_1 = wrench_base_mx
        + (articulated_base_hxz * twist_base_wz_4
            + (minus_articulated_base_hxx * twist_base_wz_6
                - articulated_base_hxy * twist_base_wz_8));
    let twist_base_wz_10 = minus_twist_base_wx_2 * twist_base_wz_1
        - (wrench_base_my
            + (articulated_base_hyz * twist_base_wz_4
                + (minus_articulated_base_hyy * twist_base_wz_8
                    - articulated_base_hyx * twist_base_wz_6)));
    let twist_base_wz = (twist_base_wz_24 * twist_base_wz_1
        - (wrench_base_mz
            + (articulated_base_hzz * twist_base_wz_4
                + (minus_articulated_base_hzx * twist_base_wz_6
                    - articulated_base_hzy * twist_base_wz_8)))
        - twist_base_wz_26 * twist_base_wz_10)
        * (1.0
            / (articulated_base_jzz
                - (articulated_base_hzy * twist_base_wz_17
                    - minus_articulated_base_hzx
                        * (twist_base_wz_16 * twist_base_wz_17
                            - minus_articulated_base_hzx * twist_base_wz_19
                            - twist_base_wz_20 * twist_base_wz_23)
                    + articulated_base_hzz * twist_base_wz_23)
                - twist_base_wz_24 * twist_base_wz_25
                - twist_base_wz_26 * twist_base_wz_27));
    let twist_base_wy = twist_base_wz_10 * twist_base_wy_1
        - twist_base_wz_26 * twist_base_wz;
    let minus_twist_base_wx = twist_base_wz_1 * minus_twist_base_wx_1
        + minus_twist_base_wx_2 * twist_base_wy + twist_base_wz_24 * twist_base_wz;
    let twist_base_vz_1 = wrench_base_fx
        + (minus_articulated_base_hxx * minus_twist_base_wx
            + articulated_base_hyx * twist_base_wy
            - minus_articulated_base_hzx * twist_base_wz);
    let twist_base_vz_10 = wrench_base_fy
        + (articulated_base_hzy * twist_base_wz
            - (articulated_base_hxy * minus_twist_base_wx
                + minus_articulated_base_hyy * twist_base_wy))
        + twist_base_wz_16 * twist_base_vz_1;
    let twist_base_vz = (twist_base_wz_20 * twist_base_vz_1
        - (wrench_base_fz
            + (articulated_base_hyz * twist_base_wy
                - articulated_base_hxz * minus_twist_base_wx
                + articulated_base_hzz * twist_base_wz))
        + twist_base_vz_9 * twist_base_vz_10) * twist_base_vz_11;
    let minus_twist_base_vy = twist_base_vz_10 * minus_twist_base_vy_1
        + twist_base_vz_9 * twist_base_vz;
    let minus_twist_base_vx = twist_base_vz_1 * twist_base_wz_19
        + twist_base_wz_16 * minus_twist_base_vy + twist_base_wz_20 * twist_base_vz;
    let twist_link_1_wz_1 = (wrench_base_mx_2_0
        - (twist_base_wy * wrench_outside_link_1_my
            - minus_twist_base_wx * wrench_outside_link_1_mx
            + twist_base_wz * wrench_outside_link_1_mz
            - minus_twist_base_vx * wrench_outside_link_1_fx
            - minus_twist_base_vy * wrench_outside_link_1_fy
            - twist_base_vz * minus_wrench_outside_link_1_fz)) * inverse_pivot_joint_1_d;
    xi_dot[6] = twist_link_1_wz_1 + 0.0;
    let twist_link_1_wz = twist_base_wz + twist_link_1_wz_1;
    let twist_link_1_vx = poses.origin_base_y * twist_link_1_wz_1 - minus_twist_base_vx;
    let twist_link_1_vy = poses.minus_origin_base_x * twist_link_1_wz_1
        - minus_twist_base_vy;
    let twist_link_2_wx_1 = (wrench_link_1_mx_11_0
        - (twist_base_wy * wrench_outside_link_2_my
            - minus_twist_base_wx * wrench_outside_link_2_mx
            + twist_link_1_wz * wrench_outside_link_2_mz
            + twist_link_1_vx * wrench_outside_link_2_fx
            + twist_link_1_vy * wrench_outside_link_2_fy
            + twist_base_vz * wrench_outside_link_2_fz)) * inverse_pivot_joint_2_d;
    xi_dot[7] = twist_link_2_wx_1 + 0.0;
    let twist_link_2_wx = poses.cos_joint_1 * twist_link_2_wx_1 - minus_twist_base_wx;
    let twist_link_2_wy = twist_base_wy + poses.sin_joint_1 * twist_link_2_wx_1;
    let twist_link_2_vx = twist_link_1_vx
        - screws.minus_screw_joint_2_vx * twist_link_2_wx_1;
    let twist_link_2_vy = twist_link_1_vy + screws.screw_joint_2_vy * twist_link_2_wx_1;
    let twist_link_2_vz = twist_base_vz
        - screws.minus_screw_joint_2_vz * twist_link_2_wx_1;
    xi_dot[8] = (wrench_link_2_mx_13_0
        - (twist_link_2_wx * screws.inside_joint_3_mx
            + twist_link_2_wy * screws.inside_joint_3_my
            + twist_link_1_wz * screws.inside_joint_3_mz
            + twist_link_2_vx * screws.inside_joint_3_fx
            + twist_link_2_vy * screws.inside_joint_3_fy
            + twist_link_2_vz * screws.inside_joint_3_fz)) * inverse_pivot_joint_3_d
        + 0.0;
}
/// The block-diagonal inertia diag(Λ_b, Λ_q) and the connection A_l = Λ_b⁻¹ M_bq.
///
/// - `q`: shape (3; rad, m)
/// - `locked_inertia`: Λ_b, inertia with the joints locked, base frame (6×6, by columns; kg·m², kg·m, kg)
/// - `connection`: A_l, local mechanical connection, base frame: V₁ = −A_l q̇ at rest (6×3, by columns; rad, m)
/// - `shape_inertia`: Λ_q, inertia that the joints feel on the floating base (3×3, by columns; kg·m²)
///
/// 524 operations: 248 + −, 273 ×, 3 ÷; 3 sin cos; about 6.3 KiB of code.
pub fn inertia(
    q: &[f64; 3],
    locked_inertia: &mut [[f64; 6]; 6],
    connection: &mut [[f64; 6]; 3],
    shape_inertia: &mut [[f64; 3]; 3],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
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
/// - `q`: shape (3; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `d_mu`: D_μ, Coriolis terms linear in μ, skew, base frame (9×9, by columns; Λ's · 1/s)
///
/// 1057 operations: 508 + −, 546 ×, 3 ÷; 3 sin cos; about 12.5 KiB of code.
pub fn d_mu(q: &[f64; 3], mu: &[f64; 6], d_mu: &mut [[f64; 9]; 9]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    d_mu_itself(
        mu,
        &poses,
        &inertias,
        &complements,
        &screws,
        &outside,
        &reactions,
        d_mu,
    );
}
/// B_2(μ) = Σ_k J̃_kᵀ C(M_k; X_k μ) J̃_k.
///
/// - `q`: shape (3; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `b2`: B_2(μ), how momentum feels the curvature, skew: −½ ⟨Λ_b μ, 𝓑(e_i, e_j)⟩ (3×3, by columns; kg·m²/s)
///
/// 730 operations: 358 + −, 369 ×, 3 ÷; 3 sin cos; about 8.7 KiB of code.
pub fn b2(q: &[f64; 3], mu: &[f64; 6], b2: &mut [[f64; 3]; 3]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    b2_itself(mu, &poses, &inertias, &complements, &screws, &outside, &reactions, b2);
}
/// Λ_b, A_l, Λ_q, D_μ and B_2 at once, sharing their work.
///
/// - `q`: shape (3; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `locked_inertia`: Λ_b, inertia with the joints locked, base frame (6×6, by columns; kg·m², kg·m, kg)
/// - `connection`: A_l, local mechanical connection, base frame: V₁ = −A_l q̇ at rest (6×3, by columns; rad, m)
/// - `shape_inertia`: Λ_q, inertia that the joints feel on the floating base (3×3, by columns; kg·m²)
/// - `d_mu`: D_μ, Coriolis terms linear in μ, skew, base frame (9×9, by columns; Λ's · 1/s)
/// - `b2`: B_2(μ), how momentum feels the curvature, skew: −½ ⟨Λ_b μ, 𝓑(e_i, e_j)⟩ (3×3, by columns; kg·m²/s)
///
/// 1416 operations: 696 + −, 717 ×, 3 ÷; 3 sin cos; about 16.7 KiB of code.
pub fn matrices(
    q: &[f64; 3],
    mu: &[f64; 6],
    locked_inertia: &mut [[f64; 6]; 6],
    connection: &mut [[f64; 6]; 3],
    shape_inertia: &mut [[f64; 3]; 3],
    d_mu: &mut [[f64; 9]; 9],
    b2: &mut [[f64; 3]; 3],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
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
    d_mu_itself(
        mu,
        &poses,
        &inertias,
        &complements,
        &screws,
        &outside,
        &reactions,
        d_mu,
    );
    b2_itself(mu, &poses, &inertias, &complements, &screws, &outside, &reactions, b2);
}
/// D_q̇ = diag(½ P(q̇), Γ'_q(q̇)): dΛ_q/dt = Γ'_q + Γ'_qᵀ, dΛ_b/dt = P(q̇).
///
/// - `q`: shape (3; rad, m)
/// - `qd`: shape velocity (3; rad/s, m/s)
/// - `d_qdot`: D_q̇, diag(½ P(q̇), Γ'_q(q̇)), base frame (9×9, by columns; Λ's · 1/s)
///
/// 1764 operations: 894 + −, 867 ×, 3 ÷; 3 sin cos; about 20.8 KiB of code.
pub fn d_qdot(q: &[f64; 3], qd: &[f64; 3], d_qdot: &mut [[f64; 9]; 9]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let d_qdot_0_0_15_1_1 = poses.com_z + 0.023809523809523808;
    let d_qdot_0_0_1 = inertias.composite_link_1_xy + inertias.composite_link_1_xy;
    let d_qdot_0_0_0_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
    let d_qdot_0_0_0 = d_qdot_0_0_0_1 + d_qdot_0_0_0_1;
    let d_qdot_0_0_6 = poses.sin_joint_1 * inertias.minus_composite_link_2_xz;
    let d_qdot_0_0_3_1 = inertias.composite_link_2_hy * screws.screw_joint_2_vy;
    let d_qdot_0_0_4_1 = inertias.composite_link_2_hz * screws.minus_screw_joint_2_vz;
    let d_qdot_0_0_3 = d_qdot_0_0_3_1 + d_qdot_0_0_3_1;
    let d_qdot_0_0_4 = d_qdot_0_0_4_1 + d_qdot_0_0_4_1;
    let d_qdot_0_0_11 = poses.sin_joint_1 * inertias.minus_inertia_link_3_xz;
    let d_qdot_0_0_8_1 = inertias.inertia_link_3_hy * screws.screw_joint_3_vy;
    let d_qdot_0_0_9_1 = inertias.inertia_link_3_hz * screws.screw_joint_3_vz;
    let d_qdot_0_0_8 = d_qdot_0_0_8_1 + d_qdot_0_0_8_1;
    let d_qdot_0_0_9 = d_qdot_0_0_9_1 + d_qdot_0_0_9_1;
    let d_qdot_0_0_15_1_0 = velocities.minus_velocity_base_vz * 130.0 * 0.5;
    let d_qdot_0_0_15_0_0 = velocities.minus_velocity_base_vy * 130.0 * 0.5;
    let d_qdot_0_0_15_1 = d_qdot_0_0_15_1_0 * d_qdot_0_0_15_1_1;
    let d_qdot_0_0_15_0 = d_qdot_0_0_15_0_0 * poses.minus_com_y;
    let d_qdot_0_0_15 = d_qdot_0_0_15_0 - d_qdot_0_0_15_1;
    // D_q\u{307} column 0
    d_qdot[0][0] = ((d_qdot_0_0_0 - d_qdot_0_0_1) * qd[0]
        + (d_qdot_0_0_3 - d_qdot_0_0_4 - (d_qdot_0_0_6 + d_qdot_0_0_6)) * qd[1]
        + (d_qdot_0_0_8 + d_qdot_0_0_9 - (d_qdot_0_0_11 + d_qdot_0_0_11)) * qd[2]) * 0.5
        - d_qdot_0_0_15 - d_qdot_0_0_15 + 0.0;
    let d_qdot_1_0_0 = ((inertias.composite_link_1_xx - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 + inertias.inside_joint_1_mz_1_1)) * qd[0]
        + (inertias.inside_joint_2_mz_1_0 - inertias.inside_joint_2_mz_1_1
            - (screws.inside_joint_2_mz_0 - screws.inside_joint_2_mz_1)) * qd[1]
        + (inertias.inside_joint_3_mz_1_0 - inertias.inside_joint_3_mz_1_1
            - (screws.inside_joint_3_mz_0 - screws.inside_joint_3_mz_1)) * qd[2]) * 0.5;
    let d_qdot_1_0_1_0 = velocities.minus_velocity_base_vx * 130.0 * 0.5;
    let d_qdot_1_0_1 = d_qdot_1_0_1_0 * poses.minus_com_y;
    let d_qdot_1_0_2 = d_qdot_0_0_15_0_0 * poses.com_x;
    d_qdot[0][1] = d_qdot_1_0_0 + d_qdot_1_0_1 - d_qdot_1_0_2 + 0.0;
    let d_qdot_2_0_0 = ((poses.sin_joint_1 * inertias.composite_link_2_zz
        - (inertias.inside_joint_2_my_0_1
            + poses.sin_joint_1 * inertias.composite_link_2_xx)
        + (screws.inside_joint_2_my_3 + screws.inside_joint_2_my_4)) * qd[1]
        - screws.inside_joint_1_my * qd[0]
        + (poses.sin_joint_1 * inertias.inertia_link_3_zz
            - (inertias.inside_joint_3_my_0_1
                + poses.sin_joint_1 * inertias.inertia_link_3_xx)
            - (screws.inside_joint_3_my_4 - screws.inside_joint_3_my_3)) * qd[2]) * 0.5;
    let d_qdot_2_0_1 = d_qdot_1_0_1_0 * d_qdot_0_0_15_1_1;
    let d_qdot_2_0_2 = d_qdot_0_0_15_1_0 * poses.com_x;
    d_qdot[0][2] = d_qdot_2_0_0 - d_qdot_2_0_1 - d_qdot_2_0_2 + 0.0;
    d_qdot[0][3] = 0.0;
    d_qdot[0][4] = 0.0 - d_qdot_0_0_15_1_0;
    d_qdot[0][5] = d_qdot_0_0_15_0_0 + 0.0;
    d_qdot[0][6] = 0.0;
    d_qdot[0][7] = 0.0;
    d_qdot[0][8] = 0.0;
    // D_q\u{307} column 1
    d_qdot[1][0] = d_qdot_1_0_0 - d_qdot_1_0_2 + d_qdot_1_0_1 + 0.0;
    let d_qdot_1_1_1_1 = inertias.composite_link_1_hx * poses.origin_base_y;
    let d_qdot_1_1_1 = d_qdot_1_1_1_1 + d_qdot_1_1_1_1;
    let d_qdot_1_1_4 = poses.cos_joint_1 * inertias.minus_composite_link_2_yz;
    let d_qdot_1_1_5_1 = inertias.composite_link_2_hx * screws.minus_screw_joint_2_vx;
    let d_qdot_1_1_5 = d_qdot_1_1_5_1 + d_qdot_1_1_5_1;
    let d_qdot_1_1_9 = poses.cos_joint_1 * inertias.minus_inertia_link_3_yz;
    let d_qdot_1_1_11_1 = inertias.inertia_link_3_hx * screws.minus_screw_joint_3_vx;
    let d_qdot_1_1_11 = d_qdot_1_1_11_1 + d_qdot_1_1_11_1;
    let d_qdot_1_1_15_0 = d_qdot_1_0_1_0 * poses.com_x;
    let d_qdot_1_1_15 = d_qdot_1_1_15_0 + d_qdot_0_0_15_1;
    d_qdot[1][1] = ((d_qdot_0_0_1 + d_qdot_1_1_1) * qd[0]
        + (d_qdot_1_1_4 + d_qdot_1_1_4 - (d_qdot_1_1_5 + d_qdot_0_0_4)) * qd[1]
        + (d_qdot_1_1_9 + d_qdot_1_1_9 + (d_qdot_0_0_9 - d_qdot_1_1_11)) * qd[2]) * 0.5
        + d_qdot_1_1_15 + d_qdot_1_1_15 + 0.0;
    let d_qdot_2_1_0 = (screws.inside_joint_1_mx * qd[0]
        + (poses.cos_joint_1 * inertias.composite_link_2_yy
            + inertias.inside_joint_2_mx_0_1
            - poses.cos_joint_1 * inertias.composite_link_2_zz
            - (screws.inside_joint_2_mx_4 - screws.inside_joint_2_mx_3)) * qd[1]
        + (poses.cos_joint_1 * inertias.inertia_link_3_yy
            + inertias.inside_joint_3_mx_0_1
            - poses.cos_joint_1 * inertias.inertia_link_3_zz
            - (screws.inside_joint_3_mx_3 + screws.inside_joint_3_mx_4)) * qd[2]) * 0.5;
    let d_qdot_2_1_1 = d_qdot_0_0_15_0_0 * d_qdot_0_0_15_1_1;
    let d_qdot_2_1_2 = d_qdot_0_0_15_1_0 * poses.minus_com_y;
    d_qdot[1][2] = d_qdot_2_1_0 - d_qdot_2_1_1 + d_qdot_2_1_2 + 0.0;
    d_qdot[1][3] = d_qdot_0_0_15_1_0 + 0.0;
    d_qdot[1][4] = 0.0;
    d_qdot[1][5] = 0.0 - d_qdot_1_0_1_0;
    d_qdot[1][6] = 0.0;
    d_qdot[1][7] = 0.0;
    d_qdot[1][8] = 0.0;
    // D_q\u{307} column 2
    d_qdot[2][0] = d_qdot_2_0_0 - d_qdot_2_0_2 - d_qdot_2_0_1 + 0.0;
    d_qdot[2][1] = d_qdot_2_1_0 + d_qdot_2_1_2 - d_qdot_2_1_1 + 0.0;
    let d_qdot_2_2_4 = d_qdot_0_0_6 - d_qdot_1_1_4;
    let d_qdot_2_2_9 = d_qdot_0_0_11 - d_qdot_1_1_9;
    let d_qdot_2_2_15 = d_qdot_0_0_15_0 - d_qdot_1_1_15_0;
    d_qdot[2][2] = ((d_qdot_1_1_1 + d_qdot_0_0_0) * qd[0]
        + (d_qdot_2_2_4 + d_qdot_2_2_4 + (d_qdot_0_0_3 - d_qdot_1_1_5)) * qd[1]
        + (d_qdot_2_2_9 + d_qdot_2_2_9 + (d_qdot_0_0_8 - d_qdot_1_1_11)) * qd[2]) * 0.5
        - d_qdot_2_2_15 - d_qdot_2_2_15 + 0.0;
    d_qdot[2][3] = 0.0 - d_qdot_0_0_15_0_0;
    d_qdot[2][4] = d_qdot_1_0_1_0 + 0.0;
    d_qdot[2][5] = 0.0;
    d_qdot[2][6] = 0.0;
    d_qdot[2][7] = 0.0;
    d_qdot[2][8] = 0.0;
    // D_q\u{307} column 3
    d_qdot[3][0] = 0.0;
    d_qdot[3][1] = d_qdot_0_0_15_1_0 + 0.0;
    d_qdot[3][2] = 0.0 - d_qdot_0_0_15_0_0;
    d_qdot[3][3] = 0.0;
    d_qdot[3][4] = 0.0;
    d_qdot[3][5] = 0.0;
    d_qdot[3][6] = 0.0;
    d_qdot[3][7] = 0.0;
    d_qdot[3][8] = 0.0;
    // D_q\u{307} column 4
    d_qdot[4][0] = 0.0 - d_qdot_0_0_15_1_0;
    d_qdot[4][1] = 0.0;
    d_qdot[4][2] = d_qdot_1_0_1_0 + 0.0;
    d_qdot[4][3] = 0.0;
    d_qdot[4][4] = 0.0;
    d_qdot[4][5] = 0.0;
    d_qdot[4][6] = 0.0;
    d_qdot[4][7] = 0.0;
    d_qdot[4][8] = 0.0;
    // D_q\u{307} column 5
    d_qdot[5][0] = d_qdot_0_0_15_0_0 + 0.0;
    d_qdot[5][1] = 0.0 - d_qdot_1_0_1_0;
    d_qdot[5][2] = 0.0;
    d_qdot[5][3] = 0.0;
    d_qdot[5][4] = 0.0;
    d_qdot[5][5] = 0.0;
    d_qdot[5][6] = 0.0;
    d_qdot[5][7] = 0.0;
    d_qdot[5][8] = 0.0;
    // D_q\u{307} column joint_1
    d_qdot[6][0] = 0.0;
    d_qdot[6][1] = 0.0;
    d_qdot[6][2] = 0.0;
    d_qdot[6][3] = 0.0;
    d_qdot[6][4] = 0.0;
    d_qdot[6][5] = 0.0;
    let factor_outside_link_1_yz_3_1 = (inertias.inertia_base_xx
        + inertias.inertia_base_yy + inertias.inertia_base_zz) * 0.5;
    let factor_outside_link_1_yz_3_5 = inertias.inertia_base_xy
        * velocities.minus_velocity_base_wy;
    let factor_outside_link_1_zy_0 = inertias.minus_inertia_base_xz
        * velocities.minus_velocity_base_wz;
    let factor_outside_link_1_xz_3_0 = inertias.inertia_base_xy
        * velocities.minus_velocity_base_wx;
    let factor_outside_link_1_zx_0 = inertias.inertia_base_yz
        * velocities.minus_velocity_base_wz;
    let factor_outside_link_1_xy_4 = inertias.minus_inertia_base_xz
        * velocities.minus_velocity_base_wx;
    let factor_outside_link_1_yx_2 = inertias.inertia_base_yz
        * velocities.minus_velocity_base_wy;
    let factor_outside_link_1_yz_3 = velocities.minus_velocity_base_wx
        * factor_outside_link_1_yz_3_1
        + (factor_outside_link_1_zy_0
            - (inertias.inertia_base_xx * velocities.minus_velocity_base_wx
                + factor_outside_link_1_yz_3_5));
    let factor_outside_link_1_xz_3 = factor_outside_link_1_xz_3_0
        + inertias.inertia_base_yy * velocities.minus_velocity_base_wy
        + factor_outside_link_1_zx_0
        - velocities.minus_velocity_base_wy * factor_outside_link_1_yz_3_1;
    let factor_outside_link_1_xy_5 = velocities.minus_velocity_base_wz
        * factor_outside_link_1_yz_3_1
        + (factor_outside_link_1_xy_4 - factor_outside_link_1_yx_2
            - inertias.inertia_base_zz * velocities.minus_velocity_base_wz);
    let factor_outside_link_1_xx_2 = inertias.minus_inertia_base_hx
        * velocities.minus_velocity_base_vx;
    let factor_outside_link_1_yy_2 = inertias.inertia_base_hy
        * velocities.minus_velocity_base_vy;
    let factor_outside_link_1_zz_2 = inertias.minus_inertia_base_hz
        * velocities.minus_velocity_base_vz;
    let factor_outside_link_1_xx_3 = factor_outside_link_1_xx_2
        - factor_outside_link_1_yy_2 + factor_outside_link_1_zz_2;
    let factor_outside_link_1_xx_0 = velocities.minus_velocity_base_wy
        * inertias.minus_inertia_base_xz;
    let factor_outside_link_1_xx_1 = velocities.minus_velocity_base_wz
        * inertias.inertia_base_xy;
    let factor_outside_link_1_xx = factor_outside_link_1_xx_0
        + factor_outside_link_1_xx_1 - factor_outside_link_1_xx_2
        + factor_outside_link_1_xx_3;
    let factor_outside_link_1_xy = velocities.minus_velocity_base_vx
        * inertias.inertia_base_hy
        - (velocities.minus_velocity_base_wz * inertias.inertia_base_xx
            + factor_outside_link_1_xy_4) + factor_outside_link_1_xy_5;
    let factor_outside_link_1_xz_0 = velocities.minus_velocity_base_wy
        * inertias.inertia_base_xx - factor_outside_link_1_xz_3_0;
    let factor_outside_link_1_xz = factor_outside_link_1_xz_0
        - velocities.minus_velocity_base_vx * inertias.minus_inertia_base_hz
        + factor_outside_link_1_xz_3;
    let factor_outside_link_1_yx = velocities.minus_velocity_base_wz
        * inertias.inertia_base_yy - factor_outside_link_1_yx_2
        - velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hx
        - factor_outside_link_1_xy_5;
    let factor_outside_link_1_yy_0 = velocities.minus_velocity_base_wx
        * inertias.inertia_base_yz;
    let factor_outside_link_1_yy = factor_outside_link_1_yy_0
        - factor_outside_link_1_xx_1 + factor_outside_link_1_yy_2
        + factor_outside_link_1_xx_3;
    let factor_outside_link_1_yz_0 = factor_outside_link_1_yz_3_5
        - velocities.minus_velocity_base_wx * inertias.inertia_base_yy;
    let factor_outside_link_1_yz = factor_outside_link_1_yz_0
        - velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hz
        + factor_outside_link_1_yz_3;
    let factor_outside_link_1_zx = factor_outside_link_1_zx_0
        - velocities.minus_velocity_base_wy * inertias.inertia_base_zz
        - velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hx
        - factor_outside_link_1_xz_3;
    let factor_outside_link_1_zy = factor_outside_link_1_zy_0
        + velocities.minus_velocity_base_wx * inertias.inertia_base_zz
        + velocities.minus_velocity_base_vz * inertias.inertia_base_hy
        - factor_outside_link_1_yz_3;
    let factor_outside_link_1_zz_1 = factor_outside_link_1_yy_0
        + factor_outside_link_1_xx_0;
    let factor_outside_link_1_zz = factor_outside_link_1_xx_3
        - (factor_outside_link_1_zz_1 + factor_outside_link_1_zz_2);
    let factor_outside_link_1_px_0 = velocities.minus_velocity_base_wy
        * inertias.minus_inertia_base_hz;
    let factor_outside_link_1_py_2 = velocities.minus_velocity_base_wx
        * inertias.minus_inertia_base_hz;
    let factor_outside_link_1_px = factor_outside_link_1_px_0
        + velocities.minus_velocity_base_wz * inertias.inertia_base_hy
        - velocities.minus_velocity_base_vx * 105.0;
    let factor_outside_link_1_py = velocities.minus_velocity_base_wz
        * inertias.minus_inertia_base_hx - factor_outside_link_1_py_2
        - velocities.minus_velocity_base_vy * 105.0;
    let minus_factor_outside_link_1_pz = velocities.minus_velocity_base_vz * 105.0
        + (velocities.minus_velocity_base_wx * inertias.inertia_base_hy
            + velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hx);
    let factor_link_1_yz_0_5_1 = (inertias.inertia_link_1_xx + inertias.inertia_link_1_yy
        + inertias.inertia_link_1_zz) * 0.5;
    let factor_link_1_yz_0_5_5 = inertias.inertia_link_1_xy
        * velocities.minus_velocity_base_wy;
    let factor_link_1_yz_0_5_2 = inertias.inertia_link_1_xz
        * velocities.velocity_link_1_wz;
    let factor_link_1_xz_0_5_0 = inertias.inertia_link_1_xy
        * velocities.minus_velocity_base_wx;
    let factor_link_1_xz_0_5_3 = inertias.minus_inertia_link_1_yz
        * velocities.velocity_link_1_wz;
    let factor_link_1_xy_0_5_3 = inertias.inertia_link_1_xz
        * velocities.minus_velocity_base_wx;
    let factor_link_1_xy_0_5_2 = inertias.minus_inertia_link_1_yz
        * velocities.minus_velocity_base_wy;
    let factor_link_1_yz_0_5 = velocities.minus_velocity_base_wx * factor_link_1_yz_0_5_1
        + (factor_link_1_yz_0_5_2
            - (inertias.inertia_link_1_xx * velocities.minus_velocity_base_wx
                + factor_link_1_yz_0_5_5));
    let factor_link_1_xz_0_5 = factor_link_1_xz_0_5_0
        + inertias.inertia_link_1_yy * velocities.minus_velocity_base_wy
        + factor_link_1_xz_0_5_3
        - velocities.minus_velocity_base_wy * factor_link_1_yz_0_5_1;
    let factor_link_1_xy_0_5 = velocities.velocity_link_1_wz * factor_link_1_yz_0_5_1
        - (factor_link_1_xy_0_5_2 - factor_link_1_xy_0_5_3
            + inertias.inertia_link_1_zz * velocities.velocity_link_1_wz);
    let factor_link_1_xx_0_3_1 = inertias.minus_inertia_link_1_hx
        * velocities.velocity_link_1_vx;
    let factor_link_1_xx_0_3_0 = inertias.inertia_link_1_hy
        * velocities.velocity_link_1_vy;
    let factor_link_1_xx_0_3_2 = inertias.inertia_link_1_hz
        * velocities.minus_velocity_base_vz;
    let factor_link_1_xx_0_3 = factor_link_1_xx_0_3_0 - factor_link_1_xx_0_3_1
        - factor_link_1_xx_0_3_2;
    let factor_link_1_xx_0_1 = velocities.minus_velocity_base_wy
        * inertias.inertia_link_1_xz;
    let factor_link_1_xx_0_2 = velocities.velocity_link_1_wz
        * inertias.inertia_link_1_xy;
    let factor_link_1_xx_0 = factor_link_1_xx_0_3_1
        - (factor_link_1_xx_0_1 + factor_link_1_xx_0_2) + factor_link_1_xx_0_3;
    let factor_link_1_xy_0 = velocities.velocity_link_1_wz * inertias.inertia_link_1_xx
        + factor_link_1_xy_0_5_3
        - velocities.velocity_link_1_vx * inertias.inertia_link_1_hy
        - factor_link_1_xy_0_5;
    let factor_link_1_xz_0 = velocities.minus_velocity_base_wy
        * inertias.inertia_link_1_xx - factor_link_1_xz_0_5_0
        - velocities.velocity_link_1_vx * inertias.inertia_link_1_hz
        + factor_link_1_xz_0_5;
    let factor_link_1_yx_0 = factor_link_1_xy_0_5_2
        - velocities.velocity_link_1_wz * inertias.inertia_link_1_yy
        + velocities.velocity_link_1_vy * inertias.minus_inertia_link_1_hx
        + factor_link_1_xy_0_5;
    let factor_link_1_yy_0_1 = velocities.minus_velocity_base_wx
        * inertias.minus_inertia_link_1_yz;
    let factor_link_1_yy_0 = factor_link_1_xx_0_2 - factor_link_1_yy_0_1
        - factor_link_1_xx_0_3_0 + factor_link_1_xx_0_3;
    let factor_link_1_yz_0 = factor_link_1_yz_0_5_5
        - velocities.minus_velocity_base_wx * inertias.inertia_link_1_yy
        - velocities.velocity_link_1_vy * inertias.inertia_link_1_hz
        + factor_link_1_yz_0_5;
    let factor_link_1_zx_0 = factor_link_1_xz_0_5_3
        - velocities.minus_velocity_base_wy * inertias.inertia_link_1_zz
        - velocities.minus_velocity_base_vz * inertias.minus_inertia_link_1_hx
        - factor_link_1_xz_0_5;
    let factor_link_1_zy_0 = factor_link_1_yz_0_5_2
        + velocities.minus_velocity_base_wx * inertias.inertia_link_1_zz
        + velocities.minus_velocity_base_vz * inertias.inertia_link_1_hy
        - factor_link_1_yz_0_5;
    let factor_link_1_zz_0 = factor_link_1_yy_0_1 + factor_link_1_xx_0_1
        + factor_link_1_xx_0_3_2 + factor_link_1_xx_0_3;
    let factor_link_2_yz_0_5_1 = (inertias.inertia_link_2_xx + inertias.inertia_link_2_yy
        + inertias.inertia_link_2_zz) * 0.5;
    let factor_link_2_yz_0_5_4 = inertias.minus_inertia_link_2_xy
        * velocities.velocity_link_2_wy;
    let factor_link_2_yz_0_5_5 = inertias.minus_inertia_link_2_xz
        * velocities.velocity_link_1_wz;
    let factor_link_2_xz_0_0_4 = inertias.minus_inertia_link_2_xy
        * velocities.velocity_link_2_wx;
    let factor_link_2_xz_0_0_5 = inertias.minus_inertia_link_2_yz
        * velocities.velocity_link_1_wz;
    let factor_link_2_xy_0_5_4 = inertias.minus_inertia_link_2_xz
        * velocities.velocity_link_2_wx;
    let factor_link_2_xy_0_5_5 = inertias.minus_inertia_link_2_yz
        * velocities.velocity_link_2_wy;
    let factor_link_2_yz_0_5 = velocities.velocity_link_2_wx * factor_link_2_yz_0_5_1
        - (inertias.inertia_link_2_xx * velocities.velocity_link_2_wx
            - factor_link_2_yz_0_5_4 - factor_link_2_yz_0_5_5);
    let factor_link_2_xz_0_0 = velocities.velocity_link_2_wy * factor_link_2_yz_0_5_1
        - (inertias.inertia_link_2_yy * velocities.velocity_link_2_wy
            - factor_link_2_xz_0_0_4 - factor_link_2_xz_0_0_5);
    let factor_link_2_xy_0_5 = velocities.velocity_link_1_wz * factor_link_2_yz_0_5_1
        - (inertias.inertia_link_2_zz * velocities.velocity_link_1_wz
            - (factor_link_2_xy_0_5_4 + factor_link_2_xy_0_5_5));
    let factor_link_2_xx_0_3_0 = inertias.inertia_link_2_hx
        * velocities.velocity_link_2_vx;
    let factor_link_2_xx_0_3_1 = inertias.inertia_link_2_hy
        * velocities.velocity_link_2_vy;
    let factor_link_2_xx_0_3_2 = inertias.inertia_link_2_hz
        * velocities.minus_velocity_link_2_vz;
    let factor_link_2_xx_0_3 = factor_link_2_xx_0_3_0 + factor_link_2_xx_0_3_1
        - factor_link_2_xx_0_3_2;
    let factor_link_2_xx_0_1 = velocities.velocity_link_2_wy
        * inertias.minus_inertia_link_2_xz;
    let factor_link_2_xx_0_0 = velocities.velocity_link_1_wz
        * inertias.minus_inertia_link_2_xy;
    let factor_link_2_xx_0 = factor_link_2_xx_0_0 - factor_link_2_xx_0_1
        - factor_link_2_xx_0_3_0 + factor_link_2_xx_0_3;
    let factor_link_2_xy_0 = velocities.velocity_link_1_wz * inertias.inertia_link_2_xx
        + factor_link_2_xy_0_5_4
        - velocities.velocity_link_2_vx * inertias.inertia_link_2_hy
        - factor_link_2_xy_0_5;
    let factor_link_2_xz_0 = factor_link_2_xz_0_0
        - (factor_link_2_xz_0_0_4
            + velocities.velocity_link_2_wy * inertias.inertia_link_2_xx
            + velocities.velocity_link_2_vx * inertias.inertia_link_2_hz);
    let factor_link_2_yx_0 = factor_link_2_xy_0_5
        - (factor_link_2_xy_0_5_5
            + velocities.velocity_link_1_wz * inertias.inertia_link_2_yy
            + velocities.velocity_link_2_vy * inertias.inertia_link_2_hx);
    let factor_link_2_yy_0_0 = velocities.velocity_link_2_wx
        * inertias.minus_inertia_link_2_yz;
    let factor_link_2_yy_0 = factor_link_2_yy_0_0 - factor_link_2_xx_0_0
        - factor_link_2_xx_0_3_1 + factor_link_2_xx_0_3;
    let factor_link_2_yz_0 = velocities.velocity_link_2_wx * inertias.inertia_link_2_yy
        + factor_link_2_yz_0_5_4
        - velocities.velocity_link_2_vy * inertias.inertia_link_2_hz
        - factor_link_2_yz_0_5;
    let factor_link_2_zx_0 = velocities.velocity_link_2_wy * inertias.inertia_link_2_zz
        + factor_link_2_xz_0_0_5
        + velocities.minus_velocity_link_2_vz * inertias.inertia_link_2_hx
        - factor_link_2_xz_0_0;
    let factor_link_2_zy_0 = velocities.minus_velocity_link_2_vz
        * inertias.inertia_link_2_hy
        - (factor_link_2_yz_0_5_5
            + velocities.velocity_link_2_wx * inertias.inertia_link_2_zz)
        + factor_link_2_yz_0_5;
    let factor_link_2_zz_0 = factor_link_2_xx_0_1 - factor_link_2_yy_0_0
        + factor_link_2_xx_0_3_2 + factor_link_2_xx_0_3;
    let factor_link_3_yz_5_1 = (inertias.inertia_link_3_xx + inertias.inertia_link_3_yy
        + inertias.inertia_link_3_zz) * 0.5;
    let factor_link_3_yz_2 = inertias.minus_inertia_link_3_xy
        * velocities.velocity_link_3_wy;
    let factor_link_3_zy_1 = inertias.minus_inertia_link_3_xz
        * velocities.velocity_link_1_wz;
    let factor_link_3_xz_1 = inertias.minus_inertia_link_3_xy
        * velocities.velocity_link_3_wx;
    let factor_link_3_zx_2 = inertias.minus_inertia_link_3_yz
        * velocities.velocity_link_1_wz;
    let factor_link_3_xy_2 = inertias.minus_inertia_link_3_xz
        * velocities.velocity_link_3_wx;
    let factor_link_3_yx_1 = inertias.minus_inertia_link_3_yz
        * velocities.velocity_link_3_wy;
    let factor_link_3_yz_5 = velocities.velocity_link_3_wx * factor_link_3_yz_5_1
        - (inertias.inertia_link_3_xx * velocities.velocity_link_3_wx
            - factor_link_3_yz_2 - factor_link_3_zy_1);
    let factor_link_3_xz_0 = velocities.velocity_link_3_wy * factor_link_3_yz_5_1
        - (inertias.inertia_link_3_yy * velocities.velocity_link_3_wy
            - factor_link_3_xz_1 - factor_link_3_zx_2);
    let factor_link_3_xy_5 = velocities.velocity_link_1_wz * factor_link_3_yz_5_1
        - (inertias.inertia_link_3_zz * velocities.velocity_link_1_wz
            - (factor_link_3_xy_2 + factor_link_3_yx_1));
    let factor_link_3_xx_2 = inertias.inertia_link_3_hx * velocities.velocity_link_3_vx;
    let factor_link_3_yy_2 = inertias.inertia_link_3_hy * velocities.velocity_link_3_vy;
    let factor_link_3_zz_2 = inertias.inertia_link_3_hz * velocities.velocity_link_3_vz;
    let factor_link_3_xx_3 = factor_link_3_xx_2 + factor_link_3_yy_2
        + factor_link_3_zz_2;
    let factor_link_3_xx_1 = velocities.velocity_link_3_wy
        * inertias.minus_inertia_link_3_xz;
    let factor_link_3_xx_0 = velocities.velocity_link_1_wz
        * inertias.minus_inertia_link_3_xy;
    let factor_link_3_xx = factor_link_3_xx_0 - factor_link_3_xx_1 - factor_link_3_xx_2
        + factor_link_3_xx_3;
    let factor_link_3_xy = velocities.velocity_link_1_wz * inertias.inertia_link_3_xx
        + factor_link_3_xy_2 - velocities.velocity_link_3_vx * inertias.inertia_link_3_hy
        - factor_link_3_xy_5;
    let factor_link_3_xz = factor_link_3_xz_0
        - (factor_link_3_xz_1
            + velocities.velocity_link_3_wy * inertias.inertia_link_3_xx
            + velocities.velocity_link_3_vx * inertias.inertia_link_3_hz);
    let factor_link_3_yx = factor_link_3_xy_5
        - (factor_link_3_yx_1
            + velocities.velocity_link_1_wz * inertias.inertia_link_3_yy
            + velocities.velocity_link_3_vy * inertias.inertia_link_3_hx);
    let factor_link_3_yy_0 = velocities.velocity_link_3_wx
        * inertias.minus_inertia_link_3_yz;
    let factor_link_3_yy = factor_link_3_yy_0 - factor_link_3_xx_0 - factor_link_3_yy_2
        + factor_link_3_xx_3;
    let factor_link_3_yz = velocities.velocity_link_3_wx * inertias.inertia_link_3_yy
        + factor_link_3_yz_2 - velocities.velocity_link_3_vy * inertias.inertia_link_3_hz
        - factor_link_3_yz_5;
    let factor_link_3_zx = velocities.velocity_link_3_wy * inertias.inertia_link_3_zz
        + factor_link_3_zx_2 - velocities.velocity_link_3_vz * inertias.inertia_link_3_hx
        - factor_link_3_xz_0;
    let factor_link_3_zy = factor_link_3_yz_5
        - (factor_link_3_zy_1
            + velocities.velocity_link_3_wx * inertias.inertia_link_3_zz
            + velocities.velocity_link_3_vz * inertias.inertia_link_3_hy);
    let factor_link_3_zz = factor_link_3_xx_1 - factor_link_3_yy_0 - factor_link_3_zz_2
        + factor_link_3_xx_3;
    let factor_link_2_xx = factor_link_2_xx_0 + factor_link_3_xx;
    let factor_link_2_yx = factor_link_2_yx_0 + factor_link_3_yx;
    let factor_link_2_zx = factor_link_2_zx_0 + factor_link_3_zx;
    let factor_link_2_xy = factor_link_2_xy_0 + factor_link_3_xy;
    let factor_link_2_yy = factor_link_2_yy_0 + factor_link_3_yy;
    let factor_link_2_zy = factor_link_2_zy_0 + factor_link_3_zy;
    let factor_link_2_xz = factor_link_2_xz_0 + factor_link_3_xz;
    let factor_link_2_yz = factor_link_2_yz_0 + factor_link_3_yz;
    let factor_link_2_zz = factor_link_2_zz_0 + factor_link_3_zz;
    let factor_link_1_xx = factor_link_1_xx_0 + factor_link_2_xx;
    let factor_link_1_yx = factor_link_1_yx_0 + factor_link_2_yx;
    let factor_link_1_zx = factor_link_1_zx_0 + factor_link_2_zx;
    let factor_link_1_xy = factor_link_1_xy_0 + factor_link_2_xy;
    let factor_link_1_yy = factor_link_1_yy_0 + factor_link_2_yy;
    let factor_link_1_zy = factor_link_1_zy_0 + factor_link_2_zy;
    let factor_link_1_xz = factor_link_1_xz_0 + factor_link_2_xz;
    let factor_link_1_yz = factor_link_1_yz_0 + factor_link_2_yz;
    let factor_link_1_zz = factor_link_1_zz_0 + factor_link_2_zz;
    let six_joint_1_mx_6 = velocities.minus_velocity_base_wy * poses.origin_base_y
        - velocities.minus_velocity_base_wx * poses.minus_origin_base_x;
    let six_joint_1_my_6 = velocities.velocity_link_1_vy
        - velocities.velocity_link_1_wz * poses.minus_origin_base_x;
    let six_joint_1_mx_8 = velocities.velocity_link_1_wz * poses.origin_base_y
        - velocities.velocity_link_1_vx;
    let three_joint_1_x_0 = factor_outside_link_1_xx * screws.connection_joint_1_wx;
    let three_joint_1_y_2 = factor_outside_link_1_yy * screws.connection_joint_1_wy;
    let three_joint_1_z_4 = factor_outside_link_1_zz * screws.connection_joint_1_wz;
    let three_joint_1_x_7 = factor_link_1_xx * reactions.reaction_joint_1_wx;
    let three_joint_1_y_9 = factor_link_1_yy * reactions.reaction_joint_1_wy;
    let three_joint_1_z_13 = factor_link_1_zz * reactions.reaction_joint_1_wz;
    let three_joint_1_x = three_joint_1_x_0
        + factor_outside_link_1_yx * screws.connection_joint_1_wy
        + factor_outside_link_1_zx * screws.connection_joint_1_wz
        + minus_factor_outside_link_1_pz * screws.connection_joint_1_vy
        - (three_joint_1_x_7 + factor_link_1_yx * reactions.reaction_joint_1_wy
            + factor_link_1_zx * reactions.reaction_joint_1_wz);
    let three_joint_1_y = factor_outside_link_1_xy * screws.connection_joint_1_wx
        + three_joint_1_y_2 + factor_outside_link_1_zy * screws.connection_joint_1_wz
        - minus_factor_outside_link_1_pz * screws.connection_joint_1_vx
        - (factor_link_1_xy * reactions.reaction_joint_1_wx + three_joint_1_y_9
            + factor_link_1_zy * reactions.reaction_joint_1_wz);
    let three_joint_1_z = factor_outside_link_1_xz * screws.connection_joint_1_wx
        + factor_outside_link_1_yz * screws.connection_joint_1_wy + three_joint_1_z_4
        + (factor_outside_link_1_px * screws.connection_joint_1_vy
            - factor_outside_link_1_py * screws.connection_joint_1_vx)
        - (factor_link_1_xz * reactions.reaction_joint_1_wx
            + factor_link_1_yz * reactions.reaction_joint_1_wy + three_joint_1_z_13);
    let six_joint_1_mx = factor_link_1_xz
        + (inertias.composite_link_1_xy * velocities.minus_velocity_base_wx
            - inertias.composite_link_1_xx * velocities.minus_velocity_base_wy
            + (inertias.composite_link_1_hy * six_joint_1_mx_6
                - inertias.composite_link_1_hz * six_joint_1_mx_8));
    let six_joint_1_my = factor_link_1_yz
        + (inertias.composite_link_1_yy * velocities.minus_velocity_base_wx
            - inertias.composite_link_1_xy * velocities.minus_velocity_base_wy
            + (inertias.composite_link_1_hz * six_joint_1_my_6
                - inertias.composite_link_1_hx * six_joint_1_mx_6));
    let six_joint_1_mz = factor_link_1_zz
        + (inertias.composite_link_1_hx * six_joint_1_mx_8
            - inertias.composite_link_1_hy * six_joint_1_my_6
            - (inertias.composite_link_1_xz * velocities.minus_velocity_base_wy
                + inertias.minus_composite_link_1_yz
                    * velocities.minus_velocity_base_wx));
    d_qdot[6][6] = reactions.reaction_joint_1_wx * six_joint_1_mx
        + reactions.reaction_joint_1_wy * six_joint_1_my
        + reactions.reaction_joint_1_wz * six_joint_1_mz
        + three_joint_1_x * screws.connection_joint_1_wx
        + three_joint_1_y * screws.connection_joint_1_wy
        + three_joint_1_z * screws.connection_joint_1_wz + 0.0;
    let factor_link_1_px_0 = velocities.velocity_link_1_vx * 5.0
        - (velocities.minus_velocity_base_wy * inertias.inertia_link_1_hz
            + velocities.velocity_link_1_wz * inertias.inertia_link_1_hy);
    let factor_link_1_py_0 = velocities.velocity_link_1_vy * 5.0
        + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hz
            - velocities.velocity_link_1_wz * inertias.minus_inertia_link_1_hx);
    let factor_link_1_pz_1 = velocities.minus_velocity_base_vz * 5.0
        + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hy
            + velocities.minus_velocity_base_wy * inertias.minus_inertia_link_1_hx);
    let factor_link_2_px_0 = velocities.velocity_link_2_vx * 10.0
        + (velocities.velocity_link_2_wy * inertias.inertia_link_2_hz
            - velocities.velocity_link_1_wz * inertias.inertia_link_2_hy);
    let factor_link_2_py_0 = velocities.velocity_link_2_vy * 10.0
        + (velocities.velocity_link_1_wz * inertias.inertia_link_2_hx
            - velocities.velocity_link_2_wx * inertias.inertia_link_2_hz);
    let factor_link_2_pz_0 = velocities.velocity_link_2_wx * inertias.inertia_link_2_hy
        - velocities.velocity_link_2_wy * inertias.inertia_link_2_hx
        - velocities.minus_velocity_link_2_vz * 10.0;
    let factor_link_3_px = velocities.velocity_link_3_vx * 10.0
        + (velocities.velocity_link_3_wy * inertias.inertia_link_3_hz
            - velocities.velocity_link_1_wz * inertias.inertia_link_3_hy);
    let factor_link_3_py = velocities.velocity_link_3_vy * 10.0
        + (velocities.velocity_link_1_wz * inertias.inertia_link_3_hx
            - velocities.velocity_link_3_wx * inertias.inertia_link_3_hz);
    let factor_link_3_pz = velocities.velocity_link_3_vz * 10.0
        + (velocities.velocity_link_3_wx * inertias.inertia_link_3_hy
            - velocities.velocity_link_3_wy * inertias.inertia_link_3_hx);
    let factor_link_2_px = factor_link_2_px_0 + factor_link_3_px;
    let factor_link_2_py = factor_link_2_py_0 + factor_link_3_py;
    let factor_link_2_pz = factor_link_2_pz_0 + factor_link_3_pz;
    let factor_link_1_px = factor_link_1_px_0 + factor_link_2_px;
    let factor_link_1_py = factor_link_1_py_0 + factor_link_2_py;
    let factor_link_1_pz = factor_link_2_pz - factor_link_1_pz_1;
    let six_more_joint_1_mx = factor_outside_link_1_xz * screws.connection_joint_1_wz
        + (factor_outside_link_1_xy * screws.connection_joint_1_wy + three_joint_1_x_0)
        - (factor_link_1_xz * reactions.reaction_joint_1_wz
            + (factor_link_1_xy * reactions.reaction_joint_1_wy + three_joint_1_x_7))
        + (inertias.inertia_base_hy * six_joint_1_mx_6
            + inertias.minus_inertia_base_hz * six_joint_1_mx_8
            - factor_outside_link_1_xz_0);
    let six_more_joint_1_my = factor_outside_link_1_yz * screws.connection_joint_1_wz
        + (three_joint_1_y_2 + factor_outside_link_1_yx * screws.connection_joint_1_wx)
        - (factor_link_1_yz * reactions.reaction_joint_1_wz
            + (three_joint_1_y_9 + factor_link_1_yx * reactions.reaction_joint_1_wx))
        + (inertias.minus_inertia_base_hx * six_joint_1_mx_6
            - inertias.minus_inertia_base_hz * six_joint_1_my_6
            - factor_outside_link_1_yz_0);
    let six_more_joint_1_mz = three_joint_1_z_4
        + (factor_outside_link_1_zy * screws.connection_joint_1_wy
            + factor_outside_link_1_zx * screws.connection_joint_1_wx)
        - (three_joint_1_z_13
            + (factor_link_1_zy * reactions.reaction_joint_1_wy
                + factor_link_1_zx * reactions.reaction_joint_1_wx))
        + (factor_outside_link_1_zz_1
            - (inertias.minus_inertia_base_hx * six_joint_1_mx_8
                + inertias.inertia_base_hy * six_joint_1_my_6));
    let six_more_joint_1_fx = six_joint_1_my_6 * 105.0 - factor_outside_link_1_py_2
        - (screws.connection_joint_1_wy * minus_factor_outside_link_1_pz
            + screws.connection_joint_1_wz * factor_outside_link_1_py
            + (reactions.reaction_joint_1_wy * factor_link_1_pz
                - reactions.reaction_joint_1_wz * factor_link_1_py));
    let six_more_joint_1_fy = screws.connection_joint_1_wz * factor_outside_link_1_px
        + screws.connection_joint_1_wx * minus_factor_outside_link_1_pz
        - (reactions.reaction_joint_1_wz * factor_link_1_px
            - reactions.reaction_joint_1_wx * factor_link_1_pz)
        + (six_joint_1_mx_8 * 105.0 - factor_outside_link_1_px_0);
    let six_more_joint_1_fz = screws.connection_joint_1_wx * factor_outside_link_1_py
        - screws.connection_joint_1_wy * factor_outside_link_1_px
        - (reactions.reaction_joint_1_wx * factor_link_1_py
            - reactions.reaction_joint_1_wy * factor_link_1_px)
        + (six_joint_1_mx_6 * 105.0
            + (velocities.minus_velocity_base_wx * inertias.minus_inertia_base_hx
                - velocities.minus_velocity_base_wy * inertias.inertia_base_hy));
    let three_more_joint_2_x_0 = factor_link_2_xx * poses.cos_joint_1;
    let three_more_joint_2_y_2 = factor_link_2_yy * poses.sin_joint_1;
    let three_more_joint_2_x = three_more_joint_2_x_0
        + factor_link_2_yx * poses.sin_joint_1
        - (factor_link_2_py * screws.minus_screw_joint_2_vz
            + factor_link_2_pz * screws.screw_joint_2_vy);
    let three_more_joint_2_y = factor_link_2_xy * poses.cos_joint_1
        + three_more_joint_2_y_2
        + (factor_link_2_px * screws.minus_screw_joint_2_vz
            - factor_link_2_pz * screws.minus_screw_joint_2_vx);
    let three_more_joint_2_z = factor_link_2_xz * poses.cos_joint_1
        + factor_link_2_yz * poses.sin_joint_1
        + (factor_link_2_px * screws.screw_joint_2_vy
            + factor_link_2_py * screws.minus_screw_joint_2_vx);
    d_qdot[6][7] = six_more_joint_1_mx * screws.connection_joint_2_wx
        + six_more_joint_1_my * screws.connection_joint_2_wy
        + six_more_joint_1_mz * screws.connection_joint_2_wz
        + six_more_joint_1_fx * screws.connection_joint_2_vx
        + six_more_joint_1_fy * screws.connection_joint_2_vy
        + six_more_joint_1_fz * screws.connection_joint_2_vz
        + reactions.reaction_joint_1_wx * three_more_joint_2_x
        + reactions.reaction_joint_1_wy * three_more_joint_2_y
        + reactions.reaction_joint_1_wz * three_more_joint_2_z + 0.0;
    let three_more_joint_3_x_0 = factor_link_3_xx * poses.cos_joint_1;
    let three_more_joint_3_y_2 = factor_link_3_yy * poses.sin_joint_1;
    let three_more_joint_3_x = three_more_joint_3_x_0
        + factor_link_3_yx * poses.sin_joint_1
        + (factor_link_3_py * screws.screw_joint_3_vz
            - factor_link_3_pz * screws.screw_joint_3_vy);
    let three_more_joint_3_y = factor_link_3_xy * poses.cos_joint_1
        + three_more_joint_3_y_2
        - (factor_link_3_pz * screws.minus_screw_joint_3_vx
            + factor_link_3_px * screws.screw_joint_3_vz);
    let three_more_joint_3_z = factor_link_3_xz * poses.cos_joint_1
        + factor_link_3_yz * poses.sin_joint_1
        + (factor_link_3_px * screws.screw_joint_3_vy
            + factor_link_3_py * screws.minus_screw_joint_3_vx);
    d_qdot[6][8] = six_more_joint_1_mx * screws.connection_joint_3_wx
        + six_more_joint_1_my * screws.connection_joint_3_wy
        + six_more_joint_1_mz * screws.connection_joint_3_wz
        + six_more_joint_1_fx * screws.connection_joint_3_vx
        + six_more_joint_1_fy * screws.connection_joint_3_vy
        + six_more_joint_1_fz * screws.connection_joint_3_vz
        + reactions.reaction_joint_1_wx * three_more_joint_3_x
        + reactions.reaction_joint_1_wy * three_more_joint_3_y
        + reactions.reaction_joint_1_wz * three_more_joint_3_z + 0.0;
    // D_q\u{307} column joint_2
    d_qdot[7][0] = 0.0;
    d_qdot[7][1] = 0.0;
    d_qdot[7][2] = 0.0;
    d_qdot[7][3] = 0.0;
    d_qdot[7][4] = 0.0;
    d_qdot[7][5] = 0.0;
    let six_joint_2_mx_8 = velocities.velocity_link_1_wz * poses.sin_joint_1;
    let six_joint_2_mx_10 = velocities.velocity_link_1_wz * poses.cos_joint_1;
    let six_joint_2_mx_12 = velocities.velocity_link_2_wx * poses.sin_joint_1
        - velocities.velocity_link_2_wy * poses.cos_joint_1;
    let six_joint_2_my_10 = velocities.minus_velocity_link_2_vz * poses.sin_joint_1
        - (velocities.velocity_link_2_wy * screws.minus_screw_joint_2_vz
            + velocities.velocity_link_1_wz * screws.screw_joint_2_vy);
    let six_joint_2_mx_6 = velocities.velocity_link_2_wx * screws.minus_screw_joint_2_vz
        - velocities.velocity_link_1_wz * screws.minus_screw_joint_2_vx
        - velocities.minus_velocity_link_2_vz * poses.cos_joint_1;
    let six_joint_2_mx_4 = velocities.velocity_link_2_wx * screws.screw_joint_2_vy
        + velocities.velocity_link_2_wy * screws.minus_screw_joint_2_vx
        + (velocities.velocity_link_2_vx * poses.sin_joint_1
            - velocities.velocity_link_2_vy * poses.cos_joint_1);
    let six_joint_2_mx = factor_link_2_xy * poses.sin_joint_1 + three_more_joint_2_x_0
        + (inertias.composite_link_2_hy * six_joint_2_mx_4
            - inertias.composite_link_2_hz * six_joint_2_mx_6
            - (inertias.composite_link_2_xx * six_joint_2_mx_8
                + inertias.minus_composite_link_2_xy * six_joint_2_mx_10
                + inertias.minus_composite_link_2_xz * six_joint_2_mx_12));
    let six_joint_2_my = three_more_joint_2_y_2 + factor_link_2_yx * poses.cos_joint_1
        + (inertias.minus_composite_link_2_xy * six_joint_2_mx_8
            + inertias.composite_link_2_yy * six_joint_2_mx_10
            - inertias.minus_composite_link_2_yz * six_joint_2_mx_12
            + (inertias.composite_link_2_hz * six_joint_2_my_10
                - inertias.composite_link_2_hx * six_joint_2_mx_4));
    let six_joint_2_mz = factor_link_2_zy * poses.sin_joint_1
        + factor_link_2_zx * poses.cos_joint_1
        + (inertias.minus_composite_link_2_xz * six_joint_2_mx_8
            - inertias.minus_composite_link_2_yz * six_joint_2_mx_10
            + inertias.composite_link_2_zz * six_joint_2_mx_12
            + (inertias.composite_link_2_hx * six_joint_2_mx_6
                - inertias.composite_link_2_hy * six_joint_2_my_10));
    d_qdot[7][6] = reactions.reaction_joint_1_wx * six_joint_2_mx
        + reactions.reaction_joint_1_wy * six_joint_2_my
        + reactions.reaction_joint_1_wz * six_joint_2_mz
        + three_joint_1_x * screws.connection_joint_2_wx
        + three_joint_1_y * screws.connection_joint_2_wy
        + three_joint_1_z * screws.connection_joint_2_wz + 0.0;
    let factor_outside_link_2_xx = factor_link_1_xx_0 + factor_outside_link_1_xx;
    let factor_outside_link_2_yx = factor_link_1_yx_0 + factor_outside_link_1_yx;
    let factor_outside_link_2_zx = factor_link_1_zx_0 + factor_outside_link_1_zx;
    let factor_outside_link_2_xy = factor_link_1_xy_0 + factor_outside_link_1_xy;
    let factor_outside_link_2_yy = factor_link_1_yy_0 + factor_outside_link_1_yy;
    let factor_outside_link_2_zy = factor_link_1_zy_0 + factor_outside_link_1_zy;
    let factor_outside_link_2_xz = factor_link_1_xz_0 + factor_outside_link_1_xz;
    let factor_outside_link_2_yz = factor_link_1_yz_0 + factor_outside_link_1_yz;
    let factor_outside_link_2_zz = factor_link_1_zz_0 + factor_outside_link_1_zz;
    let factor_outside_link_2_px = factor_link_1_px_0 + factor_outside_link_1_px;
    let factor_outside_link_2_py = factor_link_1_py_0 + factor_outside_link_1_py;
    let minus_factor_outside_link_2_pz = factor_link_1_pz_1
        + minus_factor_outside_link_1_pz;
    let three_joint_2_x_0 = factor_outside_link_2_xx * screws.connection_joint_2_wx;
    let three_joint_2_y_2 = factor_outside_link_2_yy * screws.connection_joint_2_wy;
    let three_joint_2_z_4 = factor_outside_link_2_zz * screws.connection_joint_2_wz;
    let three_joint_2_x_9 = factor_link_2_xx * reactions.reaction_joint_2_wx;
    let three_joint_2_y_11 = factor_link_2_yy * reactions.reaction_joint_2_wy;
    let three_joint_2_z_13 = factor_link_2_zz * reactions.reaction_joint_2_wz;
    let three_joint_2_x = three_joint_2_x_0
        + factor_outside_link_2_yx * screws.connection_joint_2_wy
        + factor_outside_link_2_zx * screws.connection_joint_2_wz
        + (factor_outside_link_2_py * screws.connection_joint_2_vz
            + minus_factor_outside_link_2_pz * screws.connection_joint_2_vy)
        - (three_joint_2_x_9 + factor_link_2_yx * reactions.reaction_joint_2_wy
            + factor_link_2_zx * reactions.reaction_joint_2_wz
            + (factor_link_2_py * reactions.reaction_joint_2_vz
                - factor_link_2_pz * reactions.reaction_joint_2_vy));
    let three_joint_2_y = factor_outside_link_2_xy * screws.connection_joint_2_wx
        + three_joint_2_y_2 + factor_outside_link_2_zy * screws.connection_joint_2_wz
        - (minus_factor_outside_link_2_pz * screws.connection_joint_2_vx
            + factor_outside_link_2_px * screws.connection_joint_2_vz)
        - (factor_link_2_xy * reactions.reaction_joint_2_wx + three_joint_2_y_11
            + factor_link_2_zy * reactions.reaction_joint_2_wz
            + (factor_link_2_pz * reactions.reaction_joint_2_vx
                - factor_link_2_px * reactions.reaction_joint_2_vz));
    let three_joint_2_z = factor_outside_link_2_xz * screws.connection_joint_2_wx
        + factor_outside_link_2_yz * screws.connection_joint_2_wy + three_joint_2_z_4
        + (factor_outside_link_2_px * screws.connection_joint_2_vy
            - factor_outside_link_2_py * screws.connection_joint_2_vx)
        - (factor_link_2_xz * reactions.reaction_joint_2_wx
            + factor_link_2_yz * reactions.reaction_joint_2_wy + three_joint_2_z_13
            + (factor_link_2_px * reactions.reaction_joint_2_vy
                - factor_link_2_py * reactions.reaction_joint_2_vx));
    let six_joint_2_fx = poses.sin_joint_1 * factor_link_2_pz
        + (six_joint_2_my_10 * 20.0
            + (six_joint_2_mx_10 * inertias.composite_link_2_hz
                - six_joint_2_mx_12 * inertias.composite_link_2_hy));
    let six_joint_2_fy = six_joint_2_mx_6 * 20.0
        + (six_joint_2_mx_12 * inertias.composite_link_2_hx
            + six_joint_2_mx_8 * inertias.composite_link_2_hz)
        - poses.cos_joint_1 * factor_link_2_pz;
    let six_joint_2_fz = poses.cos_joint_1 * factor_link_2_py
        - poses.sin_joint_1 * factor_link_2_px
        + (six_joint_2_mx_4 * 20.0
            - (six_joint_2_mx_8 * inertias.composite_link_2_hy
                + six_joint_2_mx_10 * inertias.composite_link_2_hx));
    d_qdot[7][7] = reactions.reaction_joint_2_wx * six_joint_2_mx
        + reactions.reaction_joint_2_wy * six_joint_2_my
        + reactions.reaction_joint_2_wz * six_joint_2_mz
        + reactions.reaction_joint_2_vx * six_joint_2_fx
        + reactions.reaction_joint_2_vy * six_joint_2_fy
        + reactions.reaction_joint_2_vz * six_joint_2_fz
        + three_joint_2_x * screws.connection_joint_2_wx
        + three_joint_2_y * screws.connection_joint_2_wy
        + three_joint_2_z * screws.connection_joint_2_wz + 0.0;
    let six_more_joint_2_mx = factor_outside_link_2_xz * screws.connection_joint_2_wz
        + (factor_outside_link_2_xy * screws.connection_joint_2_wy + three_joint_2_x_0)
        - (factor_link_2_xz * reactions.reaction_joint_2_wz
            + (factor_link_2_xy * reactions.reaction_joint_2_wy + three_joint_2_x_9))
        + (complements.complement_link_2_xy * six_joint_2_mx_10
            - complements.complement_link_2_xx * six_joint_2_mx_8
            + complements.complement_link_2_xz * six_joint_2_mx_12
            + (complements.complement_link_2_hy * six_joint_2_mx_4
                - complements.complement_link_2_hz * six_joint_2_mx_6));
    let six_more_joint_2_my = factor_outside_link_2_yz * screws.connection_joint_2_wz
        + (three_joint_2_y_2 + factor_outside_link_2_yx * screws.connection_joint_2_wx)
        - (factor_link_2_yz * reactions.reaction_joint_2_wz
            + (three_joint_2_y_11 + factor_link_2_yx * reactions.reaction_joint_2_wx))
        + (complements.complement_link_2_yy * six_joint_2_mx_10
            - complements.complement_link_2_xy * six_joint_2_mx_8
            + complements.complement_link_2_yz * six_joint_2_mx_12
            + (complements.complement_link_2_hz * six_joint_2_my_10
                + complements.minus_complement_link_2_hx * six_joint_2_mx_4));
    let six_more_joint_2_mz = three_joint_2_z_4
        + (factor_outside_link_2_zy * screws.connection_joint_2_wy
            + factor_outside_link_2_zx * screws.connection_joint_2_wx)
        - (three_joint_2_z_13
            + (factor_link_2_zy * reactions.reaction_joint_2_wy
                + factor_link_2_zx * reactions.reaction_joint_2_wx))
        + (complements.complement_link_2_yz * six_joint_2_mx_10
            - complements.complement_link_2_xz * six_joint_2_mx_8
            + complements.complement_link_2_zz * six_joint_2_mx_12
            - (complements.minus_complement_link_2_hx * six_joint_2_mx_6
                + complements.complement_link_2_hy * six_joint_2_my_10));
    let six_more_joint_2_fx = six_joint_2_my_10 * 110.0
        + (six_joint_2_mx_10 * complements.complement_link_2_hz
            - six_joint_2_mx_12 * complements.complement_link_2_hy)
        - (screws.connection_joint_2_wy * minus_factor_outside_link_2_pz
            + screws.connection_joint_2_wz * factor_outside_link_2_py
            + (reactions.reaction_joint_2_wy * factor_link_2_pz
                - reactions.reaction_joint_2_wz * factor_link_2_py));
    let six_more_joint_2_fy = screws.connection_joint_2_wz * factor_outside_link_2_px
        + screws.connection_joint_2_wx * minus_factor_outside_link_2_pz
        - (reactions.reaction_joint_2_wz * factor_link_2_px
            - reactions.reaction_joint_2_wx * factor_link_2_pz)
        + (six_joint_2_mx_6 * 110.0
            + (six_joint_2_mx_8 * complements.complement_link_2_hz
                - six_joint_2_mx_12 * complements.minus_complement_link_2_hx));
    let six_more_joint_2_fz = screws.connection_joint_2_wx * factor_outside_link_2_py
        - screws.connection_joint_2_wy * factor_outside_link_2_px
        - (reactions.reaction_joint_2_wx * factor_link_2_py
            - reactions.reaction_joint_2_wy * factor_link_2_px)
        + (six_joint_2_mx_4 * 110.0
            + (six_joint_2_mx_10 * complements.minus_complement_link_2_hx
                - six_joint_2_mx_8 * complements.complement_link_2_hy));
    d_qdot[7][8] = six_more_joint_2_mx * screws.connection_joint_3_wx
        + six_more_joint_2_my * screws.connection_joint_3_wy
        + six_more_joint_2_mz * screws.connection_joint_3_wz
        + six_more_joint_2_fx * screws.connection_joint_3_vx
        + six_more_joint_2_fy * screws.connection_joint_3_vy
        + six_more_joint_2_fz * screws.connection_joint_3_vz
        + reactions.reaction_joint_2_wx * three_more_joint_3_x
        + reactions.reaction_joint_2_wy * three_more_joint_3_y
        + reactions.reaction_joint_2_wz * three_more_joint_3_z + 0.0;
    // D_q\u{307} column joint_3
    d_qdot[8][0] = 0.0;
    d_qdot[8][1] = 0.0;
    d_qdot[8][2] = 0.0;
    d_qdot[8][3] = 0.0;
    d_qdot[8][4] = 0.0;
    d_qdot[8][5] = 0.0;
    let six_joint_3_mx_12 = velocities.velocity_link_3_wx * poses.sin_joint_1
        - velocities.velocity_link_3_wy * poses.cos_joint_1;
    let six_joint_3_my_10 = velocities.velocity_link_3_wy * screws.screw_joint_3_vz
        - velocities.velocity_link_1_wz * screws.screw_joint_3_vy
        - velocities.velocity_link_3_vz * poses.sin_joint_1;
    let six_joint_3_mx_6 = velocities.velocity_link_3_vz * poses.cos_joint_1
        - (velocities.velocity_link_1_wz * screws.minus_screw_joint_3_vx
            + velocities.velocity_link_3_wx * screws.screw_joint_3_vz);
    let six_joint_3_mx_4 = velocities.velocity_link_3_wx * screws.screw_joint_3_vy
        + velocities.velocity_link_3_wy * screws.minus_screw_joint_3_vx
        + (velocities.velocity_link_3_vx * poses.sin_joint_1
            - velocities.velocity_link_3_vy * poses.cos_joint_1);
    let six_joint_3_mx = factor_link_3_xy * poses.sin_joint_1 + three_more_joint_3_x_0
        + (inertias.inertia_link_3_hy * six_joint_3_mx_4
            - inertias.inertia_link_3_hz * six_joint_3_mx_6
            - (inertias.inertia_link_3_xx * six_joint_2_mx_8
                + inertias.minus_inertia_link_3_xy * six_joint_2_mx_10
                + inertias.minus_inertia_link_3_xz * six_joint_3_mx_12));
    let six_joint_3_my = three_more_joint_3_y_2 + factor_link_3_yx * poses.cos_joint_1
        + (inertias.minus_inertia_link_3_xy * six_joint_2_mx_8
            + inertias.inertia_link_3_yy * six_joint_2_mx_10
            - inertias.minus_inertia_link_3_yz * six_joint_3_mx_12
            + (inertias.inertia_link_3_hz * six_joint_3_my_10
                - inertias.inertia_link_3_hx * six_joint_3_mx_4));
    let six_joint_3_mz = factor_link_3_zy * poses.sin_joint_1
        + factor_link_3_zx * poses.cos_joint_1
        + (inertias.minus_inertia_link_3_xz * six_joint_2_mx_8
            - inertias.minus_inertia_link_3_yz * six_joint_2_mx_10
            + inertias.inertia_link_3_zz * six_joint_3_mx_12
            + (inertias.inertia_link_3_hx * six_joint_3_mx_6
                - inertias.inertia_link_3_hy * six_joint_3_my_10));
    d_qdot[8][6] = reactions.reaction_joint_1_wx * six_joint_3_mx
        + reactions.reaction_joint_1_wy * six_joint_3_my
        + reactions.reaction_joint_1_wz * six_joint_3_mz
        + three_joint_1_x * screws.connection_joint_3_wx
        + three_joint_1_y * screws.connection_joint_3_wy
        + three_joint_1_z * screws.connection_joint_3_wz + 0.0;
    let six_joint_3_fx = poses.sin_joint_1 * factor_link_3_pz
        + (six_joint_3_my_10 * 10.0
            + (six_joint_2_mx_10 * inertias.inertia_link_3_hz
                - six_joint_3_mx_12 * inertias.inertia_link_3_hy));
    let six_joint_3_fy = six_joint_3_mx_6 * 10.0
        + (six_joint_3_mx_12 * inertias.inertia_link_3_hx
            + six_joint_2_mx_8 * inertias.inertia_link_3_hz)
        - poses.cos_joint_1 * factor_link_3_pz;
    let six_joint_3_fz = poses.cos_joint_1 * factor_link_3_py
        - poses.sin_joint_1 * factor_link_3_px
        + (six_joint_3_mx_4 * 10.0
            - (six_joint_2_mx_8 * inertias.inertia_link_3_hy
                + six_joint_2_mx_10 * inertias.inertia_link_3_hx));
    d_qdot[8][7] = reactions.reaction_joint_2_wx * six_joint_3_mx
        + reactions.reaction_joint_2_wy * six_joint_3_my
        + reactions.reaction_joint_2_wz * six_joint_3_mz
        + reactions.reaction_joint_2_vx * six_joint_3_fx
        + reactions.reaction_joint_2_vy * six_joint_3_fy
        + reactions.reaction_joint_2_vz * six_joint_3_fz
        + three_joint_2_x * screws.connection_joint_3_wx
        + three_joint_2_y * screws.connection_joint_3_wy
        + three_joint_2_z * screws.connection_joint_3_wz + 0.0;
    let factor_outside_link_3_xx = factor_link_2_xx_0 + factor_outside_link_2_xx;
    let factor_outside_link_3_yx = factor_link_2_yx_0 + factor_outside_link_2_yx;
    let factor_outside_link_3_zx = factor_link_2_zx_0 + factor_outside_link_2_zx;
    let factor_outside_link_3_xy = factor_link_2_xy_0 + factor_outside_link_2_xy;
    let factor_outside_link_3_yy = factor_link_2_yy_0 + factor_outside_link_2_yy;
    let factor_outside_link_3_zy = factor_link_2_zy_0 + factor_outside_link_2_zy;
    let factor_outside_link_3_xz = factor_link_2_xz_0 + factor_outside_link_2_xz;
    let factor_outside_link_3_yz = factor_link_2_yz_0 + factor_outside_link_2_yz;
    let factor_outside_link_3_zz = factor_link_2_zz_0 + factor_outside_link_2_zz;
    let factor_outside_link_3_px = factor_link_2_px_0 + factor_outside_link_2_px;
    let factor_outside_link_3_py = factor_link_2_py_0 + factor_outside_link_2_py;
    let factor_outside_link_3_pz = factor_link_2_pz_0 - minus_factor_outside_link_2_pz;
    let three_joint_3_x = factor_outside_link_3_xx * screws.connection_joint_3_wx
        + factor_outside_link_3_yx * screws.connection_joint_3_wy
        + factor_outside_link_3_zx * screws.connection_joint_3_wz
        + (factor_outside_link_3_py * screws.connection_joint_3_vz
            - factor_outside_link_3_pz * screws.connection_joint_3_vy)
        - (factor_link_3_xx * reactions.reaction_joint_3_wx
            + factor_link_3_yx * reactions.reaction_joint_3_wy
            + factor_link_3_zx * reactions.reaction_joint_3_wz
            + (factor_link_3_py * reactions.reaction_joint_3_vz
                - factor_link_3_pz * reactions.reaction_joint_3_vy));
    let three_joint_3_y = factor_outside_link_3_xy * screws.connection_joint_3_wx
        + factor_outside_link_3_yy * screws.connection_joint_3_wy
        + factor_outside_link_3_zy * screws.connection_joint_3_wz
        + (factor_outside_link_3_pz * screws.connection_joint_3_vx
            - factor_outside_link_3_px * screws.connection_joint_3_vz)
        - (factor_link_3_xy * reactions.reaction_joint_3_wx
            + factor_link_3_yy * reactions.reaction_joint_3_wy
            + factor_link_3_zy * reactions.reaction_joint_3_wz
            + (factor_link_3_pz * reactions.reaction_joint_3_vx
                - factor_link_3_px * reactions.reaction_joint_3_vz));
    let three_joint_3_z = factor_outside_link_3_xz * screws.connection_joint_3_wx
        + factor_outside_link_3_yz * screws.connection_joint_3_wy
        + factor_outside_link_3_zz * screws.connection_joint_3_wz
        + (factor_outside_link_3_px * screws.connection_joint_3_vy
            - factor_outside_link_3_py * screws.connection_joint_3_vx)
        - (factor_link_3_xz * reactions.reaction_joint_3_wx
            + factor_link_3_yz * reactions.reaction_joint_3_wy
            + factor_link_3_zz * reactions.reaction_joint_3_wz
            + (factor_link_3_px * reactions.reaction_joint_3_vy
                - factor_link_3_py * reactions.reaction_joint_3_vx));
    d_qdot[8][8] = reactions.reaction_joint_3_wx * six_joint_3_mx
        + reactions.reaction_joint_3_wy * six_joint_3_my
        + reactions.reaction_joint_3_wz * six_joint_3_mz
        + reactions.reaction_joint_3_vx * six_joint_3_fx
        + reactions.reaction_joint_3_vy * six_joint_3_fy
        + reactions.reaction_joint_3_vz * six_joint_3_fz
        + three_joint_3_x * screws.connection_joint_3_wx
        + three_joint_3_y * screws.connection_joint_3_wy
        + three_joint_3_z * screws.connection_joint_3_wz + 0.0;
}
/// The (μ, μ) term of the shape equation.
///
/// - `q`: shape (3; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `coupling_torque`: (S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}) μ, what turning as one body asks (3; N·m, N)
///
/// 765 operations: 330 + −, 432 ×, 3 ÷; 3 sin cos; about 9.1 KiB of code.
pub fn coupling_torque(q: &[f64; 3], mu: &[f64; 6], coupling_torque: &mut [f64; 3]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let common_coupling_torque_d_mu_xi = common_coupling_torque_d_mu_xi(
        mu,
        &inertias,
        &complements,
        &screws,
        &reactions,
    );
    // (S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}) μ
    coupling_torque[0] = common_coupling_torque_d_mu_xi.coupling_torque_0 + 0.0;
    coupling_torque[1] = common_coupling_torque_d_mu_xi.coupling_torque_1 + 0.0;
    coupling_torque[2] = common_coupling_torque_d_mu_xi.coupling_torque_2 + 0.0;
}
/// D_μ ξ, without forming D_μ.
///
/// - `q`: shape (3; rad, m)
/// - `qd`: shape velocity (3; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `d_mu_xi`: D_μ ξ, D_μ on ξ = [μ; q̇], base frame (9; N·m, N)
///
/// 1420 operations: 650 + −, 767 ×, 3 ÷; 3 sin cos; about 16.8 KiB of code.
pub fn d_mu_xi(q: &[f64; 3], qd: &[f64; 3], mu: &[f64; 6], d_mu_xi: &mut [f64; 9]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let common_coupling_torque_d_mu_xi = common_coupling_torque_d_mu_xi(
        mu,
        &inertias,
        &complements,
        &screws,
        &reactions,
    );
    let d_mu_xi_0_31_2_0_2 = poses.com_z + 0.023809523809523808;
    let d_mu_xi_0_0 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let d_mu_xi_0_2 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let d_mu_xi_0_9 = inertias.composite_link_1_xy + inertias.composite_link_1_xy;
    let d_mu_xi_0_8_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
    let d_mu_xi_0_8 = d_mu_xi_0_8_1 + d_mu_xi_0_8_1;
    let d_mu_xi_0_14 = poses.sin_joint_1 * inertias.minus_composite_link_2_xz;
    let d_mu_xi_0_11_1 = inertias.composite_link_2_hy * screws.screw_joint_2_vy;
    let d_mu_xi_0_12_1 = inertias.composite_link_2_hz * screws.minus_screw_joint_2_vz;
    let d_mu_xi_0_11 = d_mu_xi_0_11_1 + d_mu_xi_0_11_1;
    let d_mu_xi_0_12 = d_mu_xi_0_12_1 + d_mu_xi_0_12_1;
    let d_mu_xi_0_19 = poses.sin_joint_1 * inertias.minus_inertia_link_3_xz;
    let d_mu_xi_0_16_1 = inertias.inertia_link_3_hy * screws.screw_joint_3_vy;
    let d_mu_xi_0_17_1 = inertias.inertia_link_3_hz * screws.screw_joint_3_vz;
    let d_mu_xi_0_16 = d_mu_xi_0_16_1 + d_mu_xi_0_16_1;
    let d_mu_xi_0_17 = d_mu_xi_0_17_1 + d_mu_xi_0_17_1;
    let d_mu_xi_0_31_2_0 = mu[3]
        + (mu[1] * d_mu_xi_0_31_2_0_2 + mu[2] * poses.minus_com_y);
    let d_mu_xi_0_33_2_0 = mu[4] + (mu[2] * poses.com_x - mu[0] * d_mu_xi_0_31_2_0_2);
    let d_mu_xi_0_31_0_0 = mu[5] - (mu[0] * poses.minus_com_y + mu[1] * poses.com_x);
    let d_mu_xi_0_31_2 = d_mu_xi_0_31_2_0 * 130.0;
    let d_mu_xi_0_33_2 = d_mu_xi_0_33_2_0 * 130.0;
    let d_mu_xi_0_31_0 = d_mu_xi_0_31_0_0 * 130.0;
    let d_mu_xi_0_22 = (inertias.composite_link_1_xx - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 + inertias.inside_joint_1_mz_1_1)) * qd[0]
        + (inertias.inside_joint_2_mz_1_0 - inertias.inside_joint_2_mz_1_1
            - (screws.inside_joint_2_mz_0 - screws.inside_joint_2_mz_1)) * qd[1]
        + (inertias.inside_joint_3_mz_1_0 - inertias.inside_joint_3_mz_1_1
            - (screws.inside_joint_3_mz_0 - screws.inside_joint_3_mz_1)) * qd[2];
    let d_mu_xi_0_24 = (poses.sin_joint_1 * inertias.composite_link_2_zz
        - (inertias.inside_joint_2_my_0_1
            + poses.sin_joint_1 * inertias.composite_link_2_xx)
        + (screws.inside_joint_2_my_3 + screws.inside_joint_2_my_4)) * qd[1]
        - screws.inside_joint_1_my * qd[0]
        + (poses.sin_joint_1 * inertias.inertia_link_3_zz
            - (inertias.inside_joint_3_my_0_1
                + poses.sin_joint_1 * inertias.inertia_link_3_xx)
            - (screws.inside_joint_3_my_4 - screws.inside_joint_3_my_3)) * qd[2];
    let d_mu_xi_0_31_5 = velocities.minus_velocity_base_vx * 130.0;
    let d_mu_xi_0_33_5 = velocities.minus_velocity_base_vy * 130.0;
    let d_mu_xi_0_31_7 = velocities.minus_velocity_base_vz * 130.0;
    let d_mu_xi_0_31_1 = mu[0] - velocities.minus_velocity_base_wx;
    let d_mu_xi_0_33_1 = mu[1] - velocities.minus_velocity_base_wy;
    let d_mu_xi_0_31_3 = mu[2] - velocities.minus_velocity_base_wz;
    let d_mu_xi_0_31 = d_mu_xi_0_31_0 * d_mu_xi_0_31_1 - d_mu_xi_0_31_2 * d_mu_xi_0_31_3
        - (mu[2] * d_mu_xi_0_31_5 - mu[0] * d_mu_xi_0_31_7) * 0.5;
    let d_mu_xi_0_33 = d_mu_xi_0_31_2 * d_mu_xi_0_33_1 - d_mu_xi_0_33_2 * d_mu_xi_0_31_1
        - (mu[0] * d_mu_xi_0_33_5 - mu[1] * d_mu_xi_0_31_5) * 0.5;
    // D_μ ξ
    d_mu_xi[0] = d_mu_xi_0_0 * d_mu_xi_0_31_3 - d_mu_xi_0_2 * d_mu_xi_0_33_1
        + (d_mu_xi_0_31_0 * velocities.minus_velocity_base_vy
            - d_mu_xi_0_33_2 * velocities.minus_velocity_base_vz)
        - (((d_mu_xi_0_8 - d_mu_xi_0_9) * qd[0]
            + (d_mu_xi_0_11 - d_mu_xi_0_12 - (d_mu_xi_0_14 + d_mu_xi_0_14)) * qd[1]
            + (d_mu_xi_0_16 + d_mu_xi_0_17 - (d_mu_xi_0_19 + d_mu_xi_0_19)) * qd[2])
            * mu[0] + d_mu_xi_0_22 * mu[1] + d_mu_xi_0_24 * mu[2]
            + (d_mu_xi_0_33_5 * d_mu_xi_0_31_0_0 - d_mu_xi_0_31_7 * d_mu_xi_0_33_2_0))
            * 0.5
        - (d_mu_xi_0_31 * d_mu_xi_0_31_2_0_2 + d_mu_xi_0_33 * poses.minus_com_y) + 0.0;
    let d_mu_xi_1_2 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let d_mu_xi_1_11_1 = inertias.composite_link_1_hx * poses.origin_base_y;
    let d_mu_xi_1_11 = d_mu_xi_1_11_1 + d_mu_xi_1_11_1;
    let d_mu_xi_1_14 = poses.cos_joint_1 * inertias.minus_composite_link_2_yz;
    let d_mu_xi_1_15_1 = inertias.composite_link_2_hx * screws.minus_screw_joint_2_vx;
    let d_mu_xi_1_15 = d_mu_xi_1_15_1 + d_mu_xi_1_15_1;
    let d_mu_xi_1_19 = poses.cos_joint_1 * inertias.minus_inertia_link_3_yz;
    let d_mu_xi_1_21_1 = inertias.inertia_link_3_hx * screws.minus_screw_joint_3_vx;
    let d_mu_xi_1_21 = d_mu_xi_1_21_1 + d_mu_xi_1_21_1;
    let d_mu_xi_1_24 = screws.inside_joint_1_mx * qd[0]
        + (poses.cos_joint_1 * inertias.composite_link_2_yy
            + inertias.inside_joint_2_mx_0_1
            - poses.cos_joint_1 * inertias.composite_link_2_zz
            - (screws.inside_joint_2_mx_4 - screws.inside_joint_2_mx_3)) * qd[1]
        + (poses.cos_joint_1 * inertias.inertia_link_3_yy
            + inertias.inside_joint_3_mx_0_1
            - poses.cos_joint_1 * inertias.inertia_link_3_zz
            - (screws.inside_joint_3_mx_3 + screws.inside_joint_3_mx_4)) * qd[2];
    let d_mu_xi_1_31 = d_mu_xi_0_33_2 * d_mu_xi_0_31_3 - d_mu_xi_0_31_0 * d_mu_xi_0_33_1
        - (mu[1] * d_mu_xi_0_31_7 - mu[2] * d_mu_xi_0_33_5) * 0.5;
    d_mu_xi[1] = d_mu_xi_0_2 * d_mu_xi_0_31_1 - d_mu_xi_1_2 * d_mu_xi_0_31_3
        + (d_mu_xi_0_31_2 * velocities.minus_velocity_base_vz
            - d_mu_xi_0_31_0 * velocities.minus_velocity_base_vx)
        - (d_mu_xi_0_22 * mu[0]
            + ((d_mu_xi_0_9 + d_mu_xi_1_11) * qd[0]
                + (d_mu_xi_1_14 + d_mu_xi_1_14 - (d_mu_xi_1_15 + d_mu_xi_0_12)) * qd[1]
                + (d_mu_xi_1_19 + d_mu_xi_1_19 + (d_mu_xi_0_17 - d_mu_xi_1_21)) * qd[2])
                * mu[1] + d_mu_xi_1_24 * mu[2]
            + (d_mu_xi_0_31_7 * d_mu_xi_0_31_2_0 - d_mu_xi_0_31_5 * d_mu_xi_0_31_0_0))
            * 0.5 + (d_mu_xi_1_31 * d_mu_xi_0_31_2_0_2 - d_mu_xi_0_33 * poses.com_x)
        + 0.0;
    let d_mu_xi_2_16 = d_mu_xi_0_14 - d_mu_xi_1_14;
    let d_mu_xi_2_21 = d_mu_xi_0_19 - d_mu_xi_1_19;
    d_mu_xi[2] = d_mu_xi_1_2 * d_mu_xi_0_33_1 - d_mu_xi_0_0 * d_mu_xi_0_31_1
        + (d_mu_xi_0_33_2 * velocities.minus_velocity_base_vx
            - d_mu_xi_0_31_2 * velocities.minus_velocity_base_vy)
        - (d_mu_xi_0_24 * mu[0] + d_mu_xi_1_24 * mu[1]
            + ((d_mu_xi_1_11 + d_mu_xi_0_8) * qd[0]
                + (d_mu_xi_2_16 + d_mu_xi_2_16 + (d_mu_xi_0_11 - d_mu_xi_1_15)) * qd[1]
                + (d_mu_xi_2_21 + d_mu_xi_2_21 + (d_mu_xi_0_16 - d_mu_xi_1_21)) * qd[2])
                * mu[2]
            + (d_mu_xi_0_31_5 * d_mu_xi_0_33_2_0 - d_mu_xi_0_33_5 * d_mu_xi_0_31_2_0))
            * 0.5 + (d_mu_xi_1_31 * poses.minus_com_y + d_mu_xi_0_31 * poses.com_x)
        + 0.0;
    d_mu_xi[3] = d_mu_xi_1_31 + 0.0;
    d_mu_xi[4] = d_mu_xi_0_31 + 0.0;
    d_mu_xi[5] = d_mu_xi_0_33 + 0.0;
    let wrench_outside_link_1_my_0_1 = (inertias.inertia_base_xx
        + inertias.inertia_base_yy + inertias.inertia_base_zz) * 0.5;
    let wrench_outside_link_1_fy_3 = velocities.minus_velocity_base_wy
        * inertias.minus_inertia_base_hz
        + velocities.minus_velocity_base_wz * inertias.inertia_base_hy;
    let wrench_outside_link_1_fx_5 = velocities.minus_velocity_base_wz
        * inertias.minus_inertia_base_hx
        - velocities.minus_velocity_base_wx * inertias.minus_inertia_base_hz;
    let wrench_outside_link_1_fx_3 = velocities.minus_velocity_base_wx
        * inertias.inertia_base_hy
        + velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hx;
    let wrench_link_1_my_0_6_1 = (inertias.inertia_link_1_xx + inertias.inertia_link_1_yy
        + inertias.inertia_link_1_zz) * 0.5;
    let wrench_link_2_my_0_2_1 = (inertias.inertia_link_2_xx + inertias.inertia_link_2_yy
        + inertias.inertia_link_2_zz) * 0.5;
    let wrench_link_3_my_2_1 = (inertias.inertia_link_3_xx + inertias.inertia_link_3_yy
        + inertias.inertia_link_3_zz) * 0.5;
    let wrench_outside_link_1_my_7_2 = mu[1] * velocities.minus_velocity_base_vz;
    let wrench_outside_link_1_my_7 = mu[2] * velocities.minus_velocity_base_vy
        - wrench_outside_link_1_my_7_2;
    let wrench_outside_link_1_mx_7_0 = mu[0] * velocities.minus_velocity_base_vz;
    let wrench_outside_link_1_mx_7 = wrench_outside_link_1_mx_7_0
        - mu[2] * velocities.minus_velocity_base_vx;
    let wrench_outside_link_1_mx_5 = mu[1] * velocities.minus_velocity_base_vx
        - mu[0] * velocities.minus_velocity_base_vy;
    let wrench_outside_link_1_my_0 = mu[0] * wrench_outside_link_1_my_0_1
        - common_coupling_torque_d_mu_xi.coupling_torque_0_26;
    let wrench_outside_link_1_mx_2 = mu[1] * wrench_outside_link_1_my_0_1
        - common_coupling_torque_d_mu_xi.coupling_torque_0_28;
    let wrench_outside_link_1_mx_0 = mu[2] * wrench_outside_link_1_my_0_1
        - common_coupling_torque_d_mu_xi.coupling_torque_0_21;
    let wrench_outside_link_1_mx = wrench_outside_link_1_mx_0
        * velocities.minus_velocity_base_wy
        - wrench_outside_link_1_mx_2 * velocities.minus_velocity_base_wz
        + (inertias.inertia_base_hy * wrench_outside_link_1_mx_5
            + inertias.minus_inertia_base_hz * wrench_outside_link_1_mx_7);
    let wrench_outside_link_1_my = wrench_outside_link_1_my_0
        * velocities.minus_velocity_base_wz
        - wrench_outside_link_1_mx_0 * velocities.minus_velocity_base_wx
        + (inertias.minus_inertia_base_hx * wrench_outside_link_1_mx_5
            - inertias.minus_inertia_base_hz * wrench_outside_link_1_my_7);
    let wrench_outside_link_1_mz = wrench_outside_link_1_mx_2
        * velocities.minus_velocity_base_wx
        - wrench_outside_link_1_my_0 * velocities.minus_velocity_base_wy
        - (inertias.minus_inertia_base_hx * wrench_outside_link_1_mx_7
            + inertias.inertia_base_hy * wrench_outside_link_1_my_7);
    let wrench_outside_link_1_fx = wrench_outside_link_1_my_7 * 105.0
        - (mu[1] * wrench_outside_link_1_fx_3 + mu[2] * wrench_outside_link_1_fx_5);
    let wrench_outside_link_1_fy = wrench_outside_link_1_mx_7 * 105.0
        + (mu[2] * wrench_outside_link_1_fy_3 + mu[0] * wrench_outside_link_1_fx_3);
    let wrench_outside_link_2_fx_1 = wrench_outside_link_1_my_7_2
        + mu[2] * velocities.velocity_link_1_vy;
    let wrench_outside_link_2_fy_0 = mu[2] * velocities.velocity_link_1_vx
        + wrench_outside_link_1_mx_7_0;
    let wrench_outside_link_2_fz_0 = mu[0] * velocities.velocity_link_1_vy
        - mu[1] * velocities.velocity_link_1_vx;
    let wrench_link_1_my_0_6 = mu[0] * wrench_link_1_my_0_6_1
        - (inertias.inertia_link_1_xx * mu[0] + inertias.inertia_link_1_xy * mu[1]
            + inertias.inertia_link_1_xz * mu[2]);
    let wrench_link_1_mx_0_0 = mu[1] * wrench_link_1_my_0_6_1
        - (inertias.inertia_link_1_xy * mu[0] + inertias.inertia_link_1_yy * mu[1]
            - inertias.minus_inertia_link_1_yz * mu[2]);
    let wrench_link_1_mx_0_2 = mu[2] * wrench_link_1_my_0_6_1
        - (inertias.inertia_link_1_xz * mu[0] - inertias.minus_inertia_link_1_yz * mu[1]
            + inertias.inertia_link_1_zz * mu[2]);
    let wrench_link_1_mx_0 = wrench_link_1_mx_0_0 * velocities.velocity_link_1_wz
        + wrench_link_1_mx_0_2 * velocities.minus_velocity_base_wy
        + (inertias.inertia_link_1_hy * wrench_outside_link_2_fz_0
            - inertias.inertia_link_1_hz * wrench_outside_link_2_fy_0);
    let wrench_link_1_my_0 = inertias.minus_inertia_link_1_hx
        * wrench_outside_link_2_fz_0
        - inertias.inertia_link_1_hz * wrench_outside_link_2_fx_1
        - (wrench_link_1_mx_0_2 * velocities.minus_velocity_base_wx
            + wrench_link_1_my_0_6 * velocities.velocity_link_1_wz);
    let wrench_link_1_mz_0 = wrench_link_1_mx_0_0 * velocities.minus_velocity_base_wx
        - wrench_link_1_my_0_6 * velocities.minus_velocity_base_wy
        + (inertias.inertia_link_1_hy * wrench_outside_link_2_fx_1
            - inertias.minus_inertia_link_1_hx * wrench_outside_link_2_fy_0);
    let wrench_link_2_my_0_5 = mu[1] * velocities.minus_velocity_link_2_vz
        + mu[2] * velocities.velocity_link_2_vy;
    let wrench_link_2_mx_0_7 = mu[2] * velocities.velocity_link_2_vx
        + mu[0] * velocities.minus_velocity_link_2_vz;
    let wrench_link_2_mx_0_5 = mu[0] * velocities.velocity_link_2_vy
        - mu[1] * velocities.velocity_link_2_vx;
    let wrench_link_2_my_0_2 = mu[0] * wrench_link_2_my_0_2_1
        - (inertias.inertia_link_2_xx * mu[0] - inertias.minus_inertia_link_2_xy * mu[1]
            - inertias.minus_inertia_link_2_xz * mu[2]);
    let wrench_link_2_mx_0_0 = mu[1] * wrench_link_2_my_0_2_1
        - (inertias.inertia_link_2_yy * mu[1] - inertias.minus_inertia_link_2_xy * mu[0]
            - inertias.minus_inertia_link_2_yz * mu[2]);
    let wrench_link_2_mx_0_2 = mu[2] * wrench_link_2_my_0_2_1
        - (inertias.inertia_link_2_zz * mu[2]
            - (inertias.minus_inertia_link_2_xz * mu[0]
                + inertias.minus_inertia_link_2_yz * mu[1]));
    let wrench_link_2_mx_0 = wrench_link_2_mx_0_0 * velocities.velocity_link_1_wz
        - wrench_link_2_mx_0_2 * velocities.velocity_link_2_wy
        + (inertias.inertia_link_2_hy * wrench_link_2_mx_0_5
            - inertias.inertia_link_2_hz * wrench_link_2_mx_0_7);
    let wrench_link_2_my_0 = wrench_link_2_mx_0_2 * velocities.velocity_link_2_wx
        - wrench_link_2_my_0_2 * velocities.velocity_link_1_wz
        - (inertias.inertia_link_2_hz * wrench_link_2_my_0_5
            + inertias.inertia_link_2_hx * wrench_link_2_mx_0_5);
    let wrench_link_2_mz_0 = wrench_link_2_my_0_2 * velocities.velocity_link_2_wy
        - wrench_link_2_mx_0_0 * velocities.velocity_link_2_wx
        + (inertias.inertia_link_2_hx * wrench_link_2_mx_0_7
            + inertias.inertia_link_2_hy * wrench_link_2_my_0_5);
    let wrench_link_3_my_5 = mu[1] * velocities.velocity_link_3_vz
        - mu[2] * velocities.velocity_link_3_vy;
    let wrench_link_3_mx_7 = mu[2] * velocities.velocity_link_3_vx
        - mu[0] * velocities.velocity_link_3_vz;
    let wrench_link_3_mx_5 = mu[0] * velocities.velocity_link_3_vy
        - mu[1] * velocities.velocity_link_3_vx;
    let wrench_link_3_my_2 = mu[0] * wrench_link_3_my_2_1
        - common_coupling_torque_d_mu_xi.coupling_torque_2_11;
    let wrench_link_3_mx_0 = mu[1] * wrench_link_3_my_2_1
        - common_coupling_torque_d_mu_xi.coupling_torque_2_13;
    let wrench_link_3_mx_2 = mu[2] * wrench_link_3_my_2_1
        - common_coupling_torque_d_mu_xi.coupling_torque_2_6;
    let wrench_link_3_mx = wrench_link_3_mx_0 * velocities.velocity_link_1_wz
        - wrench_link_3_mx_2 * velocities.velocity_link_3_wy
        + (inertias.inertia_link_3_hy * wrench_link_3_mx_5
            - inertias.inertia_link_3_hz * wrench_link_3_mx_7);
    let wrench_link_3_my = wrench_link_3_mx_2 * velocities.velocity_link_3_wx
        - wrench_link_3_my_2 * velocities.velocity_link_1_wz
        + (inertias.inertia_link_3_hz * wrench_link_3_my_5
            - inertias.inertia_link_3_hx * wrench_link_3_mx_5);
    let wrench_link_3_mz = wrench_link_3_my_2 * velocities.velocity_link_3_wy
        - wrench_link_3_mx_0 * velocities.velocity_link_3_wx
        + (inertias.inertia_link_3_hx * wrench_link_3_mx_7
            - inertias.inertia_link_3_hy * wrench_link_3_my_5);
    let wrench_link_2_mx = wrench_link_2_mx_0 + wrench_link_3_mx;
    let wrench_link_2_my = wrench_link_2_my_0 + wrench_link_3_my;
    let wrench_link_2_mz = wrench_link_2_mz_0 + wrench_link_3_mz;
    let wrench_link_1_mx = wrench_link_1_mx_0 + wrench_link_2_mx;
    let wrench_link_1_my = wrench_link_1_my_0 + wrench_link_2_my;
    let wrench_link_1_mz = wrench_link_1_mz_0 + wrench_link_2_mz;
    let d_mu_xi_6_2 = reactions.reaction_joint_1_wx * wrench_link_1_mx
        + reactions.reaction_joint_1_wy * wrench_link_1_my
        + reactions.reaction_joint_1_wz * wrench_link_1_mz
        - (screws.connection_joint_1_wx * wrench_outside_link_1_mx
            + screws.connection_joint_1_wy * wrench_outside_link_1_my
            + screws.connection_joint_1_wz * wrench_outside_link_1_mz
            + screws.connection_joint_1_vx * wrench_outside_link_1_fx
            + screws.connection_joint_1_vy * wrench_outside_link_1_fy);
    d_mu_xi[6] = common_coupling_torque_d_mu_xi.coupling_torque_0 - d_mu_xi_6_2
        - d_mu_xi_6_2 + 0.0;
    let wrench_outside_link_2_fy_3 = velocities.minus_velocity_base_wy
        * inertias.inertia_link_1_hz
        + velocities.velocity_link_1_wz * inertias.inertia_link_1_hy;
    let wrench_outside_link_2_fx_6 = velocities.minus_velocity_base_wx
        * inertias.inertia_link_1_hz
        - velocities.velocity_link_1_wz * inertias.minus_inertia_link_1_hx;
    let wrench_outside_link_2_fx_4 = velocities.minus_velocity_base_wx
        * inertias.inertia_link_1_hy
        + velocities.minus_velocity_base_wy * inertias.minus_inertia_link_1_hx;
    let wrench_link_2_fy_0_5 = velocities.velocity_link_2_wy * inertias.inertia_link_2_hz
        - velocities.velocity_link_1_wz * inertias.inertia_link_2_hy;
    let wrench_link_2_fx_1_3 = velocities.velocity_link_1_wz * inertias.inertia_link_2_hx
        - velocities.velocity_link_2_wx * inertias.inertia_link_2_hz;
    let wrench_link_2_fx_1_5 = velocities.velocity_link_2_wx * inertias.inertia_link_2_hy
        - velocities.velocity_link_2_wy * inertias.inertia_link_2_hx;
    let wrench_link_3_fy_5 = velocities.velocity_link_3_wy * inertias.inertia_link_3_hz
        - velocities.velocity_link_1_wz * inertias.inertia_link_3_hy;
    let wrench_link_3_fx_3 = velocities.velocity_link_1_wz * inertias.inertia_link_3_hx
        - velocities.velocity_link_3_wx * inertias.inertia_link_3_hz;
    let wrench_link_3_fx_5 = velocities.velocity_link_3_wx * inertias.inertia_link_3_hy
        - velocities.velocity_link_3_wy * inertias.inertia_link_3_hx;
    let wrench_outside_link_1_fz = wrench_outside_link_1_mx_5 * 105.0
        - (mu[1] * wrench_outside_link_1_fy_3 - mu[0] * wrench_outside_link_1_fx_5);
    let wrench_link_2_fx_1 = wrench_link_2_my_0_5 * 10.0
        + (mu[2] * wrench_link_2_fx_1_3 - mu[1] * wrench_link_2_fx_1_5);
    let wrench_link_2_fy_0 = wrench_link_2_mx_0_7 * 10.0
        - (mu[0] * wrench_link_2_fx_1_5 - mu[2] * wrench_link_2_fy_0_5);
    let wrench_link_2_fz_0 = wrench_link_2_mx_0_5 * 10.0
        - (mu[1] * wrench_link_2_fy_0_5 - mu[0] * wrench_link_2_fx_1_3);
    let wrench_link_3_fx = wrench_link_3_my_5 * 10.0
        - (mu[2] * wrench_link_3_fx_3 - mu[1] * wrench_link_3_fx_5);
    let wrench_link_3_fy = wrench_link_3_mx_7 * 10.0
        - (mu[0] * wrench_link_3_fx_5 - mu[2] * wrench_link_3_fy_5);
    let wrench_link_3_fz = wrench_link_3_mx_5 * 10.0
        - (mu[1] * wrench_link_3_fy_5 - mu[0] * wrench_link_3_fx_3);
    let wrench_link_2_fx = wrench_link_3_fx - wrench_link_2_fx_1;
    let wrench_link_2_fy = wrench_link_2_fy_0 + wrench_link_3_fy;
    let wrench_link_2_fz = wrench_link_2_fz_0 + wrench_link_3_fz;
    let wrench_outside_link_2_mx = wrench_link_1_mx_0 + wrench_outside_link_1_mx;
    let wrench_outside_link_2_my = wrench_link_1_my_0 + wrench_outside_link_1_my;
    let wrench_outside_link_2_mz = wrench_link_1_mz_0 + wrench_outside_link_1_mz;
    let wrench_outside_link_2_fx = wrench_outside_link_1_fx
        - (wrench_outside_link_2_fx_1 * 5.0
            + (mu[1] * wrench_outside_link_2_fx_4 + mu[2] * wrench_outside_link_2_fx_6));
    let wrench_outside_link_2_fy = wrench_outside_link_2_fy_0 * 5.0
        - (mu[2] * wrench_outside_link_2_fy_3 - mu[0] * wrench_outside_link_2_fx_4)
        + wrench_outside_link_1_fy;
    let wrench_outside_link_2_fz = wrench_outside_link_2_fz_0 * 5.0
        + (mu[0] * wrench_outside_link_2_fx_6 + mu[1] * wrench_outside_link_2_fy_3)
        + wrench_outside_link_1_fz;
    let d_mu_xi_7_2 = reactions.reaction_joint_2_wx * wrench_link_2_mx
        + reactions.reaction_joint_2_wy * wrench_link_2_my
        + reactions.reaction_joint_2_wz * wrench_link_2_mz
        + reactions.reaction_joint_2_vx * wrench_link_2_fx
        + reactions.reaction_joint_2_vy * wrench_link_2_fy
        + reactions.reaction_joint_2_vz * wrench_link_2_fz
        - (screws.connection_joint_2_wx * wrench_outside_link_2_mx
            + screws.connection_joint_2_wy * wrench_outside_link_2_my
            + screws.connection_joint_2_wz * wrench_outside_link_2_mz
            + screws.connection_joint_2_vx * wrench_outside_link_2_fx
            + screws.connection_joint_2_vy * wrench_outside_link_2_fy
            + screws.connection_joint_2_vz * wrench_outside_link_2_fz);
    d_mu_xi[7] = common_coupling_torque_d_mu_xi.coupling_torque_1 - d_mu_xi_7_2
        - d_mu_xi_7_2 + 0.0;
    let wrench_outside_link_3_mx = wrench_link_2_mx_0 + wrench_outside_link_2_mx;
    let wrench_outside_link_3_my = wrench_link_2_my_0 + wrench_outside_link_2_my;
    let wrench_outside_link_3_mz = wrench_link_2_mz_0 + wrench_outside_link_2_mz;
    let wrench_outside_link_3_fx = wrench_outside_link_2_fx - wrench_link_2_fx_1;
    let wrench_outside_link_3_fy = wrench_link_2_fy_0 + wrench_outside_link_2_fy;
    let wrench_outside_link_3_fz = wrench_link_2_fz_0 + wrench_outside_link_2_fz;
    let d_mu_xi_8_2 = reactions.reaction_joint_3_wx * wrench_link_3_mx
        + reactions.reaction_joint_3_wy * wrench_link_3_my
        + reactions.reaction_joint_3_wz * wrench_link_3_mz
        + reactions.reaction_joint_3_vx * wrench_link_3_fx
        + reactions.reaction_joint_3_vy * wrench_link_3_fy
        + reactions.reaction_joint_3_vz * wrench_link_3_fz
        - (screws.connection_joint_3_wx * wrench_outside_link_3_mx
            + screws.connection_joint_3_wy * wrench_outside_link_3_my
            + screws.connection_joint_3_wz * wrench_outside_link_3_mz
            + screws.connection_joint_3_vx * wrench_outside_link_3_fx
            + screws.connection_joint_3_vy * wrench_outside_link_3_fy
            + screws.connection_joint_3_vz * wrench_outside_link_3_fz);
    d_mu_xi[8] = common_coupling_torque_d_mu_xi.coupling_torque_2 - d_mu_xi_8_2
        - d_mu_xi_8_2 + 0.0;
}
/// D_q̇ ξ = [½ P(q̇) μ; Γ'_q(q̇) q̇], without forming D_q̇.
///
/// - `q`: shape (3; rad, m)
/// - `qd`: shape velocity (3; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `d_qdot_xi`: D_q̇ ξ, D_q̇ on ξ, base frame (9; N·m, N)
///
/// 1284 operations: 606 + −, 675 ×, 3 ÷; 3 sin cos; about 15.2 KiB of code.
pub fn d_qdot_xi(q: &[f64; 3], qd: &[f64; 3], mu: &[f64; 6], d_qdot_xi: &mut [f64; 9]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let d_qdot_xi_0_21_4 = poses.com_z + 0.023809523809523808;
    let d_qdot_xi_0_1 = inertias.composite_link_1_xy + inertias.composite_link_1_xy;
    let d_qdot_xi_0_0_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
    let d_qdot_xi_0_0 = d_qdot_xi_0_0_1 + d_qdot_xi_0_0_1;
    let d_qdot_xi_0_6 = poses.sin_joint_1 * inertias.minus_composite_link_2_xz;
    let d_qdot_xi_0_3_1 = inertias.composite_link_2_hy * screws.screw_joint_2_vy;
    let d_qdot_xi_0_4_1 = inertias.composite_link_2_hz * screws.minus_screw_joint_2_vz;
    let d_qdot_xi_0_3 = d_qdot_xi_0_3_1 + d_qdot_xi_0_3_1;
    let d_qdot_xi_0_4 = d_qdot_xi_0_4_1 + d_qdot_xi_0_4_1;
    let d_qdot_xi_0_11 = poses.sin_joint_1 * inertias.minus_inertia_link_3_xz;
    let d_qdot_xi_0_8_1 = inertias.inertia_link_3_hy * screws.screw_joint_3_vy;
    let d_qdot_xi_0_9_1 = inertias.inertia_link_3_hz * screws.screw_joint_3_vz;
    let d_qdot_xi_0_8 = d_qdot_xi_0_8_1 + d_qdot_xi_0_8_1;
    let d_qdot_xi_0_9 = d_qdot_xi_0_9_1 + d_qdot_xi_0_9_1;
    let d_qdot_xi_0_21 = mu[4] + (mu[2] * poses.com_x - mu[0] * d_qdot_xi_0_21_4);
    let d_qdot_xi_0_19 = mu[5] - (mu[0] * poses.minus_com_y + mu[1] * poses.com_x);
    let d_qdot_xi_0_14 = (inertias.composite_link_1_xx - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 + inertias.inside_joint_1_mz_1_1)) * qd[0]
        + (inertias.inside_joint_2_mz_1_0 - inertias.inside_joint_2_mz_1_1
            - (screws.inside_joint_2_mz_0 - screws.inside_joint_2_mz_1)) * qd[1]
        + (inertias.inside_joint_3_mz_1_0 - inertias.inside_joint_3_mz_1_1
            - (screws.inside_joint_3_mz_0 - screws.inside_joint_3_mz_1)) * qd[2];
    let d_qdot_xi_0_16 = (poses.sin_joint_1 * inertias.composite_link_2_zz
        - (inertias.inside_joint_2_my_0_1
            + poses.sin_joint_1 * inertias.composite_link_2_xx)
        + (screws.inside_joint_2_my_3 + screws.inside_joint_2_my_4)) * qd[1]
        - screws.inside_joint_1_my * qd[0]
        + (poses.sin_joint_1 * inertias.inertia_link_3_zz
            - (inertias.inside_joint_3_my_0_1
                + poses.sin_joint_1 * inertias.inertia_link_3_xx)
            - (screws.inside_joint_3_my_4 - screws.inside_joint_3_my_3)) * qd[2];
    let d_qdot_xi_0_23_1 = velocities.minus_velocity_base_vx * 130.0;
    let d_qdot_xi_0_25_1 = velocities.minus_velocity_base_vy * 130.0;
    let d_qdot_xi_0_23_3 = velocities.minus_velocity_base_vz * 130.0;
    let d_qdot_xi_0_23 = (mu[2] * d_qdot_xi_0_23_1 - mu[0] * d_qdot_xi_0_23_3) * 0.5;
    let d_qdot_xi_0_25 = (mu[0] * d_qdot_xi_0_25_1 - mu[1] * d_qdot_xi_0_23_1) * 0.5;
    // D_q\u{307} ξ
    d_qdot_xi[0] = (((d_qdot_xi_0_0 - d_qdot_xi_0_1) * qd[0]
        + (d_qdot_xi_0_3 - d_qdot_xi_0_4 - (d_qdot_xi_0_6 + d_qdot_xi_0_6)) * qd[1]
        + (d_qdot_xi_0_8 + d_qdot_xi_0_9 - (d_qdot_xi_0_11 + d_qdot_xi_0_11)) * qd[2])
        * mu[0] + d_qdot_xi_0_14 * mu[1] + d_qdot_xi_0_16 * mu[2]
        + (d_qdot_xi_0_25_1 * d_qdot_xi_0_19 - d_qdot_xi_0_23_3 * d_qdot_xi_0_21)) * 0.5
        - (d_qdot_xi_0_23 * d_qdot_xi_0_21_4 + d_qdot_xi_0_25 * poses.minus_com_y) + 0.0;
    let d_qdot_xi_1_3_1 = inertias.composite_link_1_hx * poses.origin_base_y;
    let d_qdot_xi_1_3 = d_qdot_xi_1_3_1 + d_qdot_xi_1_3_1;
    let d_qdot_xi_1_6 = poses.cos_joint_1 * inertias.minus_composite_link_2_yz;
    let d_qdot_xi_1_7_1 = inertias.composite_link_2_hx * screws.minus_screw_joint_2_vx;
    let d_qdot_xi_1_7 = d_qdot_xi_1_7_1 + d_qdot_xi_1_7_1;
    let d_qdot_xi_1_11 = poses.cos_joint_1 * inertias.minus_inertia_link_3_yz;
    let d_qdot_xi_1_13_1 = inertias.inertia_link_3_hx * screws.minus_screw_joint_3_vx;
    let d_qdot_xi_1_13 = d_qdot_xi_1_13_1 + d_qdot_xi_1_13_1;
    let d_qdot_xi_1_19 = mu[3] + (mu[1] * d_qdot_xi_0_21_4 + mu[2] * poses.minus_com_y);
    let d_qdot_xi_1_16 = screws.inside_joint_1_mx * qd[0]
        + (poses.cos_joint_1 * inertias.composite_link_2_yy
            + inertias.inside_joint_2_mx_0_1
            - poses.cos_joint_1 * inertias.composite_link_2_zz
            - (screws.inside_joint_2_mx_4 - screws.inside_joint_2_mx_3)) * qd[1]
        + (poses.cos_joint_1 * inertias.inertia_link_3_yy
            + inertias.inside_joint_3_mx_0_1
            - poses.cos_joint_1 * inertias.inertia_link_3_zz
            - (screws.inside_joint_3_mx_3 + screws.inside_joint_3_mx_4)) * qd[2];
    let d_qdot_xi_1_23 = (mu[1] * d_qdot_xi_0_23_3 - mu[2] * d_qdot_xi_0_25_1) * 0.5;
    d_qdot_xi[1] = (d_qdot_xi_0_14 * mu[0]
        + ((d_qdot_xi_0_1 + d_qdot_xi_1_3) * qd[0]
            + (d_qdot_xi_1_6 + d_qdot_xi_1_6 - (d_qdot_xi_1_7 + d_qdot_xi_0_4)) * qd[1]
            + (d_qdot_xi_1_11 + d_qdot_xi_1_11 + (d_qdot_xi_0_9 - d_qdot_xi_1_13))
                * qd[2]) * mu[1] + d_qdot_xi_1_16 * mu[2]
        + (d_qdot_xi_0_23_3 * d_qdot_xi_1_19 - d_qdot_xi_0_23_1 * d_qdot_xi_0_19)) * 0.5
        + (d_qdot_xi_1_23 * d_qdot_xi_0_21_4 - d_qdot_xi_0_25 * poses.com_x) + 0.0;
    let d_qdot_xi_2_8 = d_qdot_xi_0_6 - d_qdot_xi_1_6;
    let d_qdot_xi_2_13 = d_qdot_xi_0_11 - d_qdot_xi_1_11;
    d_qdot_xi[2] = (d_qdot_xi_0_16 * mu[0] + d_qdot_xi_1_16 * mu[1]
        + ((d_qdot_xi_1_3 + d_qdot_xi_0_0) * qd[0]
            + (d_qdot_xi_2_8 + d_qdot_xi_2_8 + (d_qdot_xi_0_3 - d_qdot_xi_1_7)) * qd[1]
            + (d_qdot_xi_2_13 + d_qdot_xi_2_13 + (d_qdot_xi_0_8 - d_qdot_xi_1_13))
                * qd[2]) * mu[2]
        + (d_qdot_xi_0_23_1 * d_qdot_xi_0_21 - d_qdot_xi_0_25_1 * d_qdot_xi_1_19)) * 0.5
        + (d_qdot_xi_1_23 * poses.minus_com_y + d_qdot_xi_0_23 * poses.com_x) + 0.0;
    d_qdot_xi[3] = d_qdot_xi_1_23 + 0.0;
    d_qdot_xi[4] = d_qdot_xi_0_23 + 0.0;
    d_qdot_xi[5] = d_qdot_xi_0_25 + 0.0;
    let minus_wrench_outside_link_1_my_6 = velocities.minus_velocity_base_wy
        * inertias.minus_inertia_base_hz
        + velocities.minus_velocity_base_wz * inertias.inertia_base_hy
        - velocities.minus_velocity_base_vx * 105.0;
    let minus_wrench_outside_link_1_mx_4 = velocities.minus_velocity_base_wz
        * inertias.minus_inertia_base_hx
        - velocities.minus_velocity_base_wx * inertias.minus_inertia_base_hz
        - velocities.minus_velocity_base_vy * 105.0;
    let minus_wrench_outside_link_1_mx_6 = velocities.minus_velocity_base_vz * 105.0
        + (velocities.minus_velocity_base_wx * inertias.inertia_base_hy
            + velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hx);
    let wrench_outside_link_2_fy_6 = velocities.velocity_link_1_vx * 5.0
        - (velocities.minus_velocity_base_wy * inertias.inertia_link_1_hz
            + velocities.velocity_link_1_wz * inertias.inertia_link_1_hy);
    let wrench_outside_link_2_fx_4 = velocities.velocity_link_1_vy * 5.0
        + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hz
            - velocities.velocity_link_1_wz * inertias.minus_inertia_link_1_hx);
    let wrench_outside_link_2_fx_6 = velocities.minus_velocity_base_vz * 5.0
        + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hy
            + velocities.minus_velocity_base_wy * inertias.minus_inertia_link_1_hx);
    let wrench_link_2_my_0_16 = velocities.velocity_link_2_vx * 10.0
        + (velocities.velocity_link_2_wy * inertias.inertia_link_2_hz
            - velocities.velocity_link_1_wz * inertias.inertia_link_2_hy);
    let wrench_link_2_mx_0_14 = velocities.velocity_link_2_vy * 10.0
        + (velocities.velocity_link_1_wz * inertias.inertia_link_2_hx
            - velocities.velocity_link_2_wx * inertias.inertia_link_2_hz);
    let wrench_link_2_mx_0_16 = velocities.velocity_link_2_wx
        * inertias.inertia_link_2_hy
        - velocities.velocity_link_2_wy * inertias.inertia_link_2_hx
        - velocities.minus_velocity_link_2_vz * 10.0;
    let wrench_link_3_my_16 = velocities.velocity_link_3_vx * 10.0
        + (velocities.velocity_link_3_wy * inertias.inertia_link_3_hz
            - velocities.velocity_link_1_wz * inertias.inertia_link_3_hy);
    let wrench_link_3_mx_14 = velocities.velocity_link_3_vy * 10.0
        + (velocities.velocity_link_1_wz * inertias.inertia_link_3_hx
            - velocities.velocity_link_3_wx * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_16 = velocities.velocity_link_3_vz * 10.0
        + (velocities.velocity_link_3_wx * inertias.inertia_link_3_hy
            - velocities.velocity_link_3_wy * inertias.inertia_link_3_hx);
    let minus_twist_link_2_wx_1 = velocities.velocity_link_1_wz * poses.sin_joint_1;
    let twist_link_2_wy_1 = velocities.velocity_link_1_wz * poses.cos_joint_1;
    let minus_twist_link_1_wx = velocities.minus_velocity_base_wy * qd[0];
    let twist_link_1_wy = velocities.minus_velocity_base_wx * qd[0];
    let twist_link_1_vx = (velocities.velocity_link_1_vy
        - velocities.velocity_link_1_wz * poses.minus_origin_base_x) * qd[0];
    let twist_link_1_vy = (velocities.velocity_link_1_wz * poses.origin_base_y
        - velocities.velocity_link_1_vx) * qd[0];
    let twist_link_1_vz = (velocities.minus_velocity_base_wy * poses.origin_base_y
        - velocities.minus_velocity_base_wx * poses.minus_origin_base_x) * qd[0];
    let twist_link_2_wz = (velocities.velocity_link_2_wx * poses.sin_joint_1
        - velocities.velocity_link_2_wy * poses.cos_joint_1) * qd[1];
    let minus_twist_link_2_wx = minus_twist_link_1_wx + minus_twist_link_2_wx_1 * qd[1];
    let twist_link_2_wy = twist_link_1_wy + twist_link_2_wy_1 * qd[1];
    let twist_link_2_vx = twist_link_1_vx
        + (velocities.minus_velocity_link_2_vz * poses.sin_joint_1
            - (velocities.velocity_link_2_wy * screws.minus_screw_joint_2_vz
                + velocities.velocity_link_1_wz * screws.screw_joint_2_vy)) * qd[1];
    let twist_link_2_vy = twist_link_1_vy
        + (velocities.velocity_link_2_wx * screws.minus_screw_joint_2_vz
            - velocities.velocity_link_1_wz * screws.minus_screw_joint_2_vx
            - velocities.minus_velocity_link_2_vz * poses.cos_joint_1) * qd[1];
    let twist_link_2_vz = twist_link_1_vz
        + (velocities.velocity_link_2_wx * screws.screw_joint_2_vy
            + velocities.velocity_link_2_wy * screws.minus_screw_joint_2_vx
            + (velocities.velocity_link_2_vx * poses.sin_joint_1
                - velocities.velocity_link_2_vy * poses.cos_joint_1)) * qd[1];
    let minus_twist_link_3_wx = minus_twist_link_2_wx + minus_twist_link_2_wx_1 * qd[2];
    let twist_link_3_wy = twist_link_2_wy + twist_link_2_wy_1 * qd[2];
    let twist_link_3_wz = twist_link_2_wz
        + (velocities.velocity_link_3_wx * poses.sin_joint_1
            - velocities.velocity_link_3_wy * poses.cos_joint_1) * qd[2];
    let twist_link_3_vx = twist_link_2_vx
        + (velocities.velocity_link_3_wy * screws.screw_joint_3_vz
            - velocities.velocity_link_1_wz * screws.screw_joint_3_vy
            - velocities.velocity_link_3_vz * poses.sin_joint_1) * qd[2];
    let twist_link_3_vy = twist_link_2_vy
        + (velocities.velocity_link_3_vz * poses.cos_joint_1
            - (velocities.velocity_link_1_wz * screws.minus_screw_joint_3_vx
                + velocities.velocity_link_3_wx * screws.screw_joint_3_vz)) * qd[2];
    let twist_link_3_vz = twist_link_2_vz
        + (velocities.velocity_link_3_wx * screws.screw_joint_3_vy
            + velocities.velocity_link_3_wy * screws.minus_screw_joint_3_vx
            + (velocities.velocity_link_3_vx * poses.sin_joint_1
                - velocities.velocity_link_3_vy * poses.cos_joint_1)) * qd[2];
    let minus_wrench_outside_link_1_my_0 = inertias.minus_inertia_base_xz
        * velocities.minus_velocity_base_wz
        - (inertias.inertia_base_xx * velocities.minus_velocity_base_wx
            + inertias.inertia_base_xy * velocities.minus_velocity_base_wy)
        - (velocities.minus_velocity_base_vz * inertias.inertia_base_hy
            + velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hz);
    let minus_wrench_outside_link_1_mx_2 = velocities.minus_velocity_base_vx
        * inertias.minus_inertia_base_hz
        - velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hx
        - (inertias.inertia_base_xy * velocities.minus_velocity_base_wx
            + inertias.inertia_base_yy * velocities.minus_velocity_base_wy
            + inertias.inertia_base_yz * velocities.minus_velocity_base_wz);
    let minus_wrench_outside_link_1_mx_0 = inertias.minus_inertia_base_xz
        * velocities.minus_velocity_base_wx
        - inertias.inertia_base_yz * velocities.minus_velocity_base_wy
        - inertias.inertia_base_zz * velocities.minus_velocity_base_wz
        + (velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hx
            + velocities.minus_velocity_base_vx * inertias.inertia_base_hy);
    let minus_wrench_outside_link_1_mx = minus_wrench_outside_link_1_mx_0
        * velocities.minus_velocity_base_wy
        - minus_wrench_outside_link_1_mx_2 * velocities.minus_velocity_base_wz
        - (minus_wrench_outside_link_1_mx_4 * velocities.minus_velocity_base_vz
            + minus_wrench_outside_link_1_mx_6 * velocities.minus_velocity_base_vy);
    let minus_wrench_outside_link_1_my = minus_wrench_outside_link_1_my_0
        * velocities.minus_velocity_base_wz
        - minus_wrench_outside_link_1_mx_0 * velocities.minus_velocity_base_wx
        + (minus_wrench_outside_link_1_mx_6 * velocities.minus_velocity_base_vx
            + minus_wrench_outside_link_1_my_6 * velocities.minus_velocity_base_vz);
    let minus_wrench_outside_link_1_mz = minus_wrench_outside_link_1_mx_2
        * velocities.minus_velocity_base_wx
        - minus_wrench_outside_link_1_my_0 * velocities.minus_velocity_base_wy
        + (minus_wrench_outside_link_1_mx_4 * velocities.minus_velocity_base_vx
            - minus_wrench_outside_link_1_my_6 * velocities.minus_velocity_base_vy);
    let wrench_outside_link_1_fx = minus_wrench_outside_link_1_mx_4
        * velocities.minus_velocity_base_wz
        + minus_wrench_outside_link_1_mx_6 * velocities.minus_velocity_base_wy;
    let minus_wrench_outside_link_1_fy = minus_wrench_outside_link_1_mx_6
        * velocities.minus_velocity_base_wx
        + minus_wrench_outside_link_1_my_6 * velocities.minus_velocity_base_wz;
    let wrench_link_1_my_0_14 = inertias.inertia_link_1_xz
        * velocities.velocity_link_1_wz
        - (inertias.inertia_link_1_xx * velocities.minus_velocity_base_wx
            + inertias.inertia_link_1_xy * velocities.minus_velocity_base_wy)
        - (velocities.minus_velocity_base_vz * inertias.inertia_link_1_hy
            + velocities.velocity_link_1_vy * inertias.inertia_link_1_hz);
    let wrench_link_1_mx_0_8 = velocities.velocity_link_1_vx * inertias.inertia_link_1_hz
        - velocities.minus_velocity_base_vz * inertias.minus_inertia_link_1_hx
        - (inertias.inertia_link_1_xy * velocities.minus_velocity_base_wx
            + inertias.inertia_link_1_yy * velocities.minus_velocity_base_wy
            + inertias.minus_inertia_link_1_yz * velocities.velocity_link_1_wz);
    let wrench_link_1_mx_0_10 = inertias.minus_inertia_link_1_yz
        * velocities.minus_velocity_base_wy
        - inertias.inertia_link_1_xz * velocities.minus_velocity_base_wx
        + inertias.inertia_link_1_zz * velocities.velocity_link_1_wz
        - (velocities.velocity_link_1_vy * inertias.minus_inertia_link_1_hx
            + velocities.velocity_link_1_vx * inertias.inertia_link_1_hy);
    let wrench_link_1_mx_0 = inertias.inertia_link_1_xy * twist_link_1_wy
        - inertias.inertia_link_1_xx * minus_twist_link_1_wx
        + (inertias.inertia_link_1_hy * twist_link_1_vz
            - inertias.inertia_link_1_hz * twist_link_1_vy)
        - (wrench_link_1_mx_0_8 * velocities.velocity_link_1_wz
            + wrench_link_1_mx_0_10 * velocities.minus_velocity_base_wy
            + (wrench_outside_link_2_fx_6 * velocities.velocity_link_1_vy
                - wrench_outside_link_2_fx_4 * velocities.minus_velocity_base_vz));
    let wrench_link_1_my_0 = inertias.inertia_link_1_yy * twist_link_1_wy
        - inertias.inertia_link_1_xy * minus_twist_link_1_wx
        + (inertias.inertia_link_1_hz * twist_link_1_vx
            + inertias.minus_inertia_link_1_hx * twist_link_1_vz)
        - (wrench_outside_link_2_fy_6 * velocities.minus_velocity_base_vz
            - wrench_outside_link_2_fx_6 * velocities.velocity_link_1_vx
            - (wrench_link_1_mx_0_10 * velocities.minus_velocity_base_wx
                + wrench_link_1_my_0_14 * velocities.velocity_link_1_wz));
    let wrench_link_1_mz_1 = inertias.inertia_link_1_xz * minus_twist_link_1_wx
        + inertias.minus_inertia_link_1_yz * twist_link_1_wy
        + (inertias.minus_inertia_link_1_hx * twist_link_1_vy
            + inertias.inertia_link_1_hy * twist_link_1_vx)
        + (wrench_link_1_mx_0_8 * velocities.minus_velocity_base_wx
            - wrench_link_1_my_0_14 * velocities.minus_velocity_base_wy
            + (wrench_outside_link_2_fy_6 * velocities.velocity_link_1_vy
                - wrench_outside_link_2_fx_4 * velocities.velocity_link_1_vx));
    let wrench_link_2_my_0_12 = inertias.inertia_link_2_xx
        * velocities.velocity_link_2_wx
        - inertias.minus_inertia_link_2_xy * velocities.velocity_link_2_wy
        - inertias.minus_inertia_link_2_xz * velocities.velocity_link_1_wz
        - (velocities.minus_velocity_link_2_vz * inertias.inertia_link_2_hy
            + velocities.velocity_link_2_vy * inertias.inertia_link_2_hz);
    let wrench_link_2_mx_0_10 = inertias.inertia_link_2_yy
        * velocities.velocity_link_2_wy
        - inertias.minus_inertia_link_2_xy * velocities.velocity_link_2_wx
        - inertias.minus_inertia_link_2_yz * velocities.velocity_link_1_wz
        + (velocities.velocity_link_2_vx * inertias.inertia_link_2_hz
            + velocities.minus_velocity_link_2_vz * inertias.inertia_link_2_hx);
    let wrench_link_2_mx_0_12 = inertias.inertia_link_2_zz
        * velocities.velocity_link_1_wz
        - (inertias.minus_inertia_link_2_xz * velocities.velocity_link_2_wx
            + inertias.minus_inertia_link_2_yz * velocities.velocity_link_2_wy)
        + (velocities.velocity_link_2_vy * inertias.inertia_link_2_hx
            - velocities.velocity_link_2_vx * inertias.inertia_link_2_hy);
    let wrench_link_2_mx_0 = inertias.inertia_link_2_hy * twist_link_2_vz
        - inertias.inertia_link_2_hz * twist_link_2_vy
        - (inertias.inertia_link_2_xx * minus_twist_link_2_wx
            + inertias.minus_inertia_link_2_xy * twist_link_2_wy
            + inertias.minus_inertia_link_2_xz * twist_link_2_wz)
        - (wrench_link_2_mx_0_10 * velocities.velocity_link_1_wz
            - wrench_link_2_mx_0_12 * velocities.velocity_link_2_wy
            - (wrench_link_2_mx_0_14 * velocities.minus_velocity_link_2_vz
                + wrench_link_2_mx_0_16 * velocities.velocity_link_2_vy));
    let wrench_link_2_my_0 = inertias.minus_inertia_link_2_xy * minus_twist_link_2_wx
        + inertias.inertia_link_2_yy * twist_link_2_wy
        - inertias.minus_inertia_link_2_yz * twist_link_2_wz
        + (inertias.inertia_link_2_hz * twist_link_2_vx
            - inertias.inertia_link_2_hx * twist_link_2_vz)
        - (wrench_link_2_mx_0_12 * velocities.velocity_link_2_wx
            - wrench_link_2_my_0_12 * velocities.velocity_link_1_wz
            + (wrench_link_2_mx_0_16 * velocities.velocity_link_2_vx
                + wrench_link_2_my_0_16 * velocities.minus_velocity_link_2_vz));
    let wrench_link_2_mz_0 = inertias.minus_inertia_link_2_xz * minus_twist_link_2_wx
        - inertias.minus_inertia_link_2_yz * twist_link_2_wy
        + inertias.inertia_link_2_zz * twist_link_2_wz
        + (inertias.inertia_link_2_hx * twist_link_2_vy
            - inertias.inertia_link_2_hy * twist_link_2_vx)
        - (wrench_link_2_my_0_12 * velocities.velocity_link_2_wy
            - wrench_link_2_mx_0_10 * velocities.velocity_link_2_wx
            + (wrench_link_2_my_0_16 * velocities.velocity_link_2_vy
                - wrench_link_2_mx_0_14 * velocities.velocity_link_2_vx));
    let wrench_link_3_my_12 = inertias.inertia_link_3_xx * velocities.velocity_link_3_wx
        - inertias.minus_inertia_link_3_xy * velocities.velocity_link_3_wy
        - inertias.minus_inertia_link_3_xz * velocities.velocity_link_1_wz
        + (velocities.velocity_link_3_vz * inertias.inertia_link_3_hy
            - velocities.velocity_link_3_vy * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_10 = inertias.inertia_link_3_yy * velocities.velocity_link_3_wy
        - inertias.minus_inertia_link_3_xy * velocities.velocity_link_3_wx
        - inertias.minus_inertia_link_3_yz * velocities.velocity_link_1_wz
        + (velocities.velocity_link_3_vx * inertias.inertia_link_3_hz
            - velocities.velocity_link_3_vz * inertias.inertia_link_3_hx);
    let wrench_link_3_mx_12 = inertias.inertia_link_3_zz * velocities.velocity_link_1_wz
        - (inertias.minus_inertia_link_3_xz * velocities.velocity_link_3_wx
            + inertias.minus_inertia_link_3_yz * velocities.velocity_link_3_wy)
        + (velocities.velocity_link_3_vy * inertias.inertia_link_3_hx
            - velocities.velocity_link_3_vx * inertias.inertia_link_3_hy);
    let wrench_link_3_mx = inertias.inertia_link_3_hy * twist_link_3_vz
        - inertias.inertia_link_3_hz * twist_link_3_vy
        - (inertias.inertia_link_3_xx * minus_twist_link_3_wx
            + inertias.minus_inertia_link_3_xy * twist_link_3_wy
            + inertias.minus_inertia_link_3_xz * twist_link_3_wz)
        - (wrench_link_3_mx_10 * velocities.velocity_link_1_wz
            - wrench_link_3_mx_12 * velocities.velocity_link_3_wy
            + (wrench_link_3_mx_14 * velocities.velocity_link_3_vz
                - wrench_link_3_mx_16 * velocities.velocity_link_3_vy));
    let wrench_link_3_my = inertias.minus_inertia_link_3_xy * minus_twist_link_3_wx
        + inertias.inertia_link_3_yy * twist_link_3_wy
        - inertias.minus_inertia_link_3_yz * twist_link_3_wz
        + (inertias.inertia_link_3_hz * twist_link_3_vx
            - inertias.inertia_link_3_hx * twist_link_3_vz)
        - (wrench_link_3_mx_12 * velocities.velocity_link_3_wx
            - wrench_link_3_my_12 * velocities.velocity_link_1_wz
            + (wrench_link_3_mx_16 * velocities.velocity_link_3_vx
                - wrench_link_3_my_16 * velocities.velocity_link_3_vz));
    let wrench_link_3_mz = inertias.minus_inertia_link_3_xz * minus_twist_link_3_wx
        - inertias.minus_inertia_link_3_yz * twist_link_3_wy
        + inertias.inertia_link_3_zz * twist_link_3_wz
        + (inertias.inertia_link_3_hx * twist_link_3_vy
            - inertias.inertia_link_3_hy * twist_link_3_vx)
        - (wrench_link_3_my_12 * velocities.velocity_link_3_wy
            - wrench_link_3_mx_10 * velocities.velocity_link_3_wx
            + (wrench_link_3_my_16 * velocities.velocity_link_3_vy
                - wrench_link_3_mx_14 * velocities.velocity_link_3_vx));
    let wrench_link_2_mx = wrench_link_2_mx_0 + wrench_link_3_mx;
    let wrench_link_2_my = wrench_link_2_my_0 + wrench_link_3_my;
    let wrench_link_2_mz = wrench_link_2_mz_0 + wrench_link_3_mz;
    let wrench_link_1_mx = wrench_link_1_mx_0 + wrench_link_2_mx;
    let wrench_link_1_my = wrench_link_1_my_0 + wrench_link_2_my;
    let wrench_link_1_mz = wrench_link_2_mz - wrench_link_1_mz_1;
    d_qdot_xi[6] = reactions.reaction_joint_1_wx * wrench_link_1_mx
        + reactions.reaction_joint_1_wy * wrench_link_1_my
        + reactions.reaction_joint_1_wz * wrench_link_1_mz
        - (screws.connection_joint_1_vx * wrench_outside_link_1_fx
            - (screws.connection_joint_1_wx * minus_wrench_outside_link_1_mx
                + screws.connection_joint_1_wy * minus_wrench_outside_link_1_my
                + screws.connection_joint_1_wz * minus_wrench_outside_link_1_mz)
            - screws.connection_joint_1_vy * minus_wrench_outside_link_1_fy) + 0.0;
    let minus_wrench_outside_link_1_fz = minus_wrench_outside_link_1_mx_4
        * velocities.minus_velocity_base_wx
        - minus_wrench_outside_link_1_my_6 * velocities.minus_velocity_base_wy;
    let wrench_link_2_fx_0 = twist_link_2_vx * 10.0
        + (twist_link_2_wy * inertias.inertia_link_2_hz
            - twist_link_2_wz * inertias.inertia_link_2_hy)
        - (wrench_link_2_mx_0_14 * velocities.velocity_link_1_wz
            - wrench_link_2_mx_0_16 * velocities.velocity_link_2_wy);
    let wrench_link_2_fy_0 = twist_link_2_vy * 10.0
        + (twist_link_2_wz * inertias.inertia_link_2_hx
            + minus_twist_link_2_wx * inertias.inertia_link_2_hz)
        - (wrench_link_2_mx_0_16 * velocities.velocity_link_2_wx
            - wrench_link_2_my_0_16 * velocities.velocity_link_1_wz);
    let wrench_link_2_fz_0 = twist_link_2_vz * 10.0
        - (minus_twist_link_2_wx * inertias.inertia_link_2_hy
            + twist_link_2_wy * inertias.inertia_link_2_hx)
        - (wrench_link_2_my_0_16 * velocities.velocity_link_2_wy
            - wrench_link_2_mx_0_14 * velocities.velocity_link_2_wx);
    let wrench_link_3_fx = twist_link_3_vx * 10.0
        + (twist_link_3_wy * inertias.inertia_link_3_hz
            - twist_link_3_wz * inertias.inertia_link_3_hy)
        - (wrench_link_3_mx_14 * velocities.velocity_link_1_wz
            - wrench_link_3_mx_16 * velocities.velocity_link_3_wy);
    let wrench_link_3_fy = twist_link_3_vy * 10.0
        + (twist_link_3_wz * inertias.inertia_link_3_hx
            + minus_twist_link_3_wx * inertias.inertia_link_3_hz)
        - (wrench_link_3_mx_16 * velocities.velocity_link_3_wx
            - wrench_link_3_my_16 * velocities.velocity_link_1_wz);
    let wrench_link_3_fz = twist_link_3_vz * 10.0
        - (minus_twist_link_3_wx * inertias.inertia_link_3_hy
            + twist_link_3_wy * inertias.inertia_link_3_hx)
        - (wrench_link_3_my_16 * velocities.velocity_link_3_wy
            - wrench_link_3_mx_14 * velocities.velocity_link_3_wx);
    let wrench_link_2_fx = wrench_link_2_fx_0 + wrench_link_3_fx;
    let wrench_link_2_fy = wrench_link_2_fy_0 + wrench_link_3_fy;
    let wrench_link_2_fz = wrench_link_2_fz_0 + wrench_link_3_fz;
    let wrench_outside_link_2_mx = wrench_link_1_mx_0 - minus_wrench_outside_link_1_mx;
    let wrench_outside_link_2_my = wrench_link_1_my_0 - minus_wrench_outside_link_1_my;
    let minus_wrench_outside_link_2_mz = wrench_link_1_mz_1
        + minus_wrench_outside_link_1_mz;
    let wrench_outside_link_2_fx = twist_link_1_vx * 5.0
        + twist_link_1_wy * inertias.inertia_link_1_hz
        - (wrench_outside_link_2_fx_4 * velocities.velocity_link_1_wz
            - wrench_outside_link_2_fx_6 * velocities.minus_velocity_base_wy)
        + wrench_outside_link_1_fx;
    let wrench_outside_link_2_fy = twist_link_1_vy * 5.0
        + minus_twist_link_1_wx * inertias.inertia_link_1_hz
        - (wrench_outside_link_2_fx_6 * velocities.minus_velocity_base_wx
            - wrench_outside_link_2_fy_6 * velocities.velocity_link_1_wz)
        - minus_wrench_outside_link_1_fy;
    let wrench_outside_link_2_fz = twist_link_1_vz * 5.0
        + (twist_link_1_wy * inertias.minus_inertia_link_1_hx
            - minus_twist_link_1_wx * inertias.inertia_link_1_hy)
        - (wrench_outside_link_2_fx_4 * velocities.minus_velocity_base_wx
            - wrench_outside_link_2_fy_6 * velocities.minus_velocity_base_wy)
        - minus_wrench_outside_link_1_fz;
    d_qdot_xi[7] = reactions.reaction_joint_2_wx * wrench_link_2_mx
        + reactions.reaction_joint_2_wy * wrench_link_2_my
        + reactions.reaction_joint_2_wz * wrench_link_2_mz
        + reactions.reaction_joint_2_vx * wrench_link_2_fx
        + reactions.reaction_joint_2_vy * wrench_link_2_fy
        + reactions.reaction_joint_2_vz * wrench_link_2_fz
        - (screws.connection_joint_2_wx * wrench_outside_link_2_mx
            + screws.connection_joint_2_wy * wrench_outside_link_2_my
            - screws.connection_joint_2_wz * minus_wrench_outside_link_2_mz
            + screws.connection_joint_2_vx * wrench_outside_link_2_fx
            + screws.connection_joint_2_vy * wrench_outside_link_2_fy
            + screws.connection_joint_2_vz * wrench_outside_link_2_fz) + 0.0;
    let wrench_outside_link_3_mx = wrench_link_2_mx_0 + wrench_outside_link_2_mx;
    let wrench_outside_link_3_my = wrench_link_2_my_0 + wrench_outside_link_2_my;
    let wrench_outside_link_3_mz = wrench_link_2_mz_0 - minus_wrench_outside_link_2_mz;
    let wrench_outside_link_3_fx = wrench_link_2_fx_0 + wrench_outside_link_2_fx;
    let wrench_outside_link_3_fy = wrench_link_2_fy_0 + wrench_outside_link_2_fy;
    let wrench_outside_link_3_fz = wrench_link_2_fz_0 + wrench_outside_link_2_fz;
    d_qdot_xi[8] = reactions.reaction_joint_3_wx * wrench_link_3_mx
        + reactions.reaction_joint_3_wy * wrench_link_3_my
        + reactions.reaction_joint_3_wz * wrench_link_3_mz
        + reactions.reaction_joint_3_vx * wrench_link_3_fx
        + reactions.reaction_joint_3_vy * wrench_link_3_fy
        + reactions.reaction_joint_3_vz * wrench_link_3_fz
        - (screws.connection_joint_3_wx * wrench_outside_link_3_mx
            + screws.connection_joint_3_wy * wrench_outside_link_3_my
            + screws.connection_joint_3_wz * wrench_outside_link_3_mz
            + screws.connection_joint_3_vx * wrench_outside_link_3_fx
            + screws.connection_joint_3_vy * wrench_outside_link_3_fy
            + screws.connection_joint_3_vz * wrench_outside_link_3_fz) + 0.0;
}
/// C(q, V) V in M V̇ + C V = [F₁; τ], V = [V₁; q̇], by one Newton-Euler sweep.
///
/// - `q`: shape (3; rad, m)
/// - `qd`: shape velocity (3; rad/s, m/s)
/// - `base_twist`: body twist of the base, base frame (6; rad/s, m/s)
/// - `hamel_bias`: C V, Coriolis force on V = [V₁; q̇], base frame (9; N·m, N)
///
/// 1005 operations: 478 + −, 524 ×, 3 ÷; 3 sin cos; about 11.9 KiB of code.
pub fn hamel_bias(
    q: &[f64; 3],
    qd: &[f64; 3],
    base_twist: &[f64; 6],
    hamel_bias: &mut [f64; 9],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let velocities = velocities(qd, &poses, &screws);
    let minus_wrench_outside_link_1_my_5_0_2 = poses.com_z + 0.023809523809523808;
    let minus_twist_link_1_wy_0_0 = base_twist[0] + velocities.minus_velocity_base_wx;
    let twist_link_1_wx_0_0 = base_twist[1] + velocities.minus_velocity_base_wy;
    let minus_wrench_outside_link_1_mx_1_0 = base_twist[2]
        + velocities.minus_velocity_base_wz;
    let minus_wrench_outside_link_1_my_5_0 = base_twist[3]
        + (base_twist[1] * minus_wrench_outside_link_1_my_5_0_2
            + base_twist[2] * poses.minus_com_y) + velocities.minus_velocity_base_vx;
    let minus_wrench_outside_link_1_mx_7_0 = base_twist[4]
        + (base_twist[2] * poses.com_x
            - base_twist[0] * minus_wrench_outside_link_1_my_5_0_2)
        + velocities.minus_velocity_base_vy;
    let minus_wrench_outside_link_1_mx_5_0 = base_twist[5]
        - (base_twist[0] * poses.minus_com_y + base_twist[1] * poses.com_x)
        + velocities.minus_velocity_base_vz;
    let minus_twist_link_1_wy_0 = minus_twist_link_1_wy_0_0
        - velocities.minus_velocity_base_wx;
    let twist_link_1_wx_0 = twist_link_1_wx_0_0 - velocities.minus_velocity_base_wy;
    let minus_wrench_outside_link_1_mx_1 = minus_wrench_outside_link_1_mx_1_0
        - velocities.minus_velocity_base_wz;
    let minus_wrench_outside_link_1_my_5 = minus_wrench_outside_link_1_my_5_0
        - velocities.minus_velocity_base_vx;
    let minus_wrench_outside_link_1_mx_7 = minus_wrench_outside_link_1_mx_7_0
        - velocities.minus_velocity_base_vy;
    let minus_wrench_outside_link_1_mx_5 = minus_wrench_outside_link_1_mx_5_0
        - velocities.minus_velocity_base_vz;
    let twist_link_1_vy_0 = velocities.velocity_link_1_wz
        + minus_wrench_outside_link_1_mx_1_0;
    let twist_link_1_vy_2 = velocities.velocity_link_1_vx
        + minus_wrench_outside_link_1_my_5_0;
    let wrench_outside_link_2_mx_15 = velocities.velocity_link_1_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_1_wx = twist_link_1_wx_0 * qd[0];
    let minus_twist_link_1_wy = minus_twist_link_1_wy_0 * qd[0];
    let twist_link_1_vy = (twist_link_1_vy_0 * poses.origin_base_y - twist_link_1_vy_2)
        * qd[0];
    let twist_link_1_vz = (minus_twist_link_1_wy_0 * poses.minus_origin_base_x
        - twist_link_1_wx_0 * poses.origin_base_y) * qd[0];
    let twist_link_2_wz_0 = velocities.velocity_link_2_wx + minus_twist_link_1_wy_0_0;
    let twist_link_2_wz_2 = velocities.velocity_link_2_wy + twist_link_1_wx_0_0;
    let twist_link_2_vz_5 = velocities.velocity_link_2_vx
        + minus_wrench_outside_link_1_my_5_0;
    let twist_link_2_vz_7 = velocities.velocity_link_2_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_2_vy_5 = minus_wrench_outside_link_1_mx_5_0
        - velocities.minus_velocity_link_2_vz;
    let twist_link_2_wx_1 = twist_link_1_vy_0 * poses.sin_joint_1;
    let twist_link_2_wy_0 = twist_link_1_vy_0 * poses.cos_joint_1;
    let twist_link_2_wz = (twist_link_2_wz_0 * poses.sin_joint_1
        - twist_link_2_wz_2 * poses.cos_joint_1) * qd[1];
    let twist_link_3_wz_1 = velocities.velocity_link_3_wx + minus_twist_link_1_wy_0_0;
    let twist_link_3_wz_3 = velocities.velocity_link_3_wy + twist_link_1_wx_0_0;
    let twist_link_3_vz_5 = velocities.velocity_link_3_vx
        + minus_wrench_outside_link_1_my_5_0;
    let twist_link_3_vz_7 = velocities.velocity_link_3_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_3_vy_1 = velocities.velocity_link_3_vz
        + minus_wrench_outside_link_1_mx_5_0;
    let twist_link_2_wx = twist_link_1_wx - twist_link_2_wx_1 * qd[1];
    let twist_link_2_wy = twist_link_2_wy_0 * qd[1] - minus_twist_link_1_wy;
    let twist_link_2_vy = twist_link_1_vy
        + (twist_link_2_wz_0 * screws.minus_screw_joint_2_vz
            - twist_link_1_vy_0 * screws.minus_screw_joint_2_vx
            + twist_link_2_vy_5 * poses.cos_joint_1) * qd[1];
    let twist_link_2_vz = twist_link_1_vz
        + (twist_link_2_wz_0 * screws.screw_joint_2_vy
            + twist_link_2_wz_2 * screws.minus_screw_joint_2_vx
            + (twist_link_2_vz_5 * poses.sin_joint_1
                - twist_link_2_vz_7 * poses.cos_joint_1)) * qd[1];
    let twist_link_3_wx = twist_link_2_wx - twist_link_2_wx_1 * qd[2];
    let twist_link_3_wy = twist_link_2_wy + twist_link_2_wy_0 * qd[2];
    let twist_link_3_wz = twist_link_2_wz
        + (twist_link_3_wz_1 * poses.sin_joint_1 - twist_link_3_wz_3 * poses.cos_joint_1)
            * qd[2];
    let twist_link_3_vy = twist_link_2_vy
        + (twist_link_3_vy_1 * poses.cos_joint_1
            - (twist_link_1_vy_0 * screws.minus_screw_joint_3_vx
                + twist_link_3_wz_1 * screws.screw_joint_3_vz)) * qd[2];
    let twist_link_3_vz = twist_link_2_vz
        + (twist_link_3_wz_1 * screws.screw_joint_3_vy
            + twist_link_3_wz_3 * screws.minus_screw_joint_3_vx
            + (twist_link_3_vz_5 * poses.sin_joint_1
                - twist_link_3_vz_7 * poses.cos_joint_1)) * qd[2];
    let minus_wrench_outside_link_1_mx_0 = inertias.inertia_base_xy
        * minus_twist_link_1_wy_0 + inertias.inertia_base_yy * twist_link_1_wx_0
        + inertias.inertia_base_yz * minus_wrench_outside_link_1_mx_1
        + (inertias.minus_inertia_base_hx * minus_wrench_outside_link_1_mx_5
            - inertias.minus_inertia_base_hz * minus_wrench_outside_link_1_my_5);
    let minus_wrench_outside_link_1_mx_2 = inertias.inertia_base_yz * twist_link_1_wx_0
        - inertias.minus_inertia_base_xz * minus_twist_link_1_wy_0
        + inertias.inertia_base_zz * minus_wrench_outside_link_1_mx_1
        - (inertias.minus_inertia_base_hx * minus_wrench_outside_link_1_mx_7
            + inertias.inertia_base_hy * minus_wrench_outside_link_1_my_5);
    let minus_wrench_outside_link_1_fy_2 = minus_wrench_outside_link_1_my_5 * 105.0
        - (twist_link_1_wx_0 * inertias.minus_inertia_base_hz
            + minus_wrench_outside_link_1_mx_1 * inertias.inertia_base_hy);
    let minus_wrench_outside_link_1_mx_4 = minus_wrench_outside_link_1_mx_7 * 105.0
        + (minus_twist_link_1_wy_0 * inertias.minus_inertia_base_hz
            - minus_wrench_outside_link_1_mx_1 * inertias.minus_inertia_base_hx);
    let minus_wrench_outside_link_1_mx_6 = minus_wrench_outside_link_1_mx_5 * 105.0
        + (minus_twist_link_1_wy_0 * inertias.inertia_base_hy
            + twist_link_1_wx_0 * inertias.minus_inertia_base_hx);
    let minus_wrench_outside_link_1_mx = minus_wrench_outside_link_1_mx_0
        * minus_wrench_outside_link_1_mx_1
        - minus_wrench_outside_link_1_mx_2 * twist_link_1_wx_0
        + (minus_wrench_outside_link_1_mx_4 * minus_wrench_outside_link_1_mx_5
            - minus_wrench_outside_link_1_mx_6 * minus_wrench_outside_link_1_mx_7);
    let minus_wrench_outside_link_1_fy = minus_wrench_outside_link_1_mx_6
        * minus_twist_link_1_wy_0
        - minus_wrench_outside_link_1_fy_2 * minus_wrench_outside_link_1_mx_1;
    let minus_wrench_outside_link_1_fz = minus_wrench_outside_link_1_fy_2
        * twist_link_1_wx_0 - minus_wrench_outside_link_1_mx_4 * minus_twist_link_1_wy_0;
    let wrench_outside_link_2_mx_8 = inertias.inertia_link_1_xy * minus_twist_link_1_wy_0
        + inertias.inertia_link_1_yy * twist_link_1_wx_0
        - inertias.minus_inertia_link_1_yz * twist_link_1_vy_0
        + (inertias.inertia_link_1_hz * twist_link_1_vy_2
            + inertias.minus_inertia_link_1_hx * minus_wrench_outside_link_1_mx_5);
    let wrench_outside_link_2_mx_10 = inertias.inertia_link_1_xz
        * minus_twist_link_1_wy_0 - inertias.minus_inertia_link_1_yz * twist_link_1_wx_0
        + inertias.inertia_link_1_zz * twist_link_1_vy_0
        - (inertias.minus_inertia_link_1_hx * wrench_outside_link_2_mx_15
            + inertias.inertia_link_1_hy * twist_link_1_vy_2);
    let wrench_outside_link_2_fy_6 = twist_link_1_vy_2 * 5.0
        + (twist_link_1_wx_0 * inertias.inertia_link_1_hz
            - twist_link_1_vy_0 * inertias.inertia_link_1_hy);
    let wrench_outside_link_2_mx_12 = wrench_outside_link_2_mx_15 * 5.0
        - (twist_link_1_vy_0 * inertias.minus_inertia_link_1_hx
            + minus_twist_link_1_wy_0 * inertias.inertia_link_1_hz);
    let wrench_outside_link_2_mx_14 = minus_wrench_outside_link_1_mx_5 * 5.0
        + (minus_twist_link_1_wy_0 * inertias.inertia_link_1_hy
            + twist_link_1_wx_0 * inertias.minus_inertia_link_1_hx);
    let wrench_outside_link_2_mx = inertias.inertia_link_1_xx * twist_link_1_wx
        - inertias.inertia_link_1_xy * minus_twist_link_1_wy
        + (inertias.inertia_link_1_hy * twist_link_1_vz
            - inertias.inertia_link_1_hz * twist_link_1_vy)
        - (wrench_outside_link_2_mx_8 * twist_link_1_vy_0
            - wrench_outside_link_2_mx_10 * twist_link_1_wx_0
            + (wrench_outside_link_2_mx_12 * minus_wrench_outside_link_1_mx_5
                - wrench_outside_link_2_mx_14 * wrench_outside_link_2_mx_15));
    let wrench_outside_link_2_fy = twist_link_1_vy * 5.0
        - twist_link_1_wx * inertias.inertia_link_1_hz
        - (wrench_outside_link_2_mx_14 * minus_twist_link_1_wy_0
            - wrench_outside_link_2_fy_6 * twist_link_1_vy_0);
    let wrench_outside_link_2_fz = twist_link_1_vz * 5.0
        + (twist_link_1_wx * inertias.inertia_link_1_hy
            - minus_twist_link_1_wy * inertias.minus_inertia_link_1_hx)
        - (wrench_outside_link_2_fy_6 * twist_link_1_wx_0
            - wrench_outside_link_2_mx_12 * minus_twist_link_1_wy_0);
    let wrench_outside_link_3_mx_10 = inertias.inertia_link_2_yy * twist_link_2_wz_2
        - inertias.minus_inertia_link_2_xy * twist_link_2_wz_0
        - inertias.minus_inertia_link_2_yz * twist_link_1_vy_0
        + (inertias.inertia_link_2_hz * twist_link_2_vz_5
            - inertias.inertia_link_2_hx * twist_link_2_vy_5);
    let wrench_outside_link_3_mx_12 = inertias.inertia_link_2_zz * twist_link_1_vy_0
        - (inertias.minus_inertia_link_2_xz * twist_link_2_wz_0
            + inertias.minus_inertia_link_2_yz * twist_link_2_wz_2)
        + (inertias.inertia_link_2_hx * twist_link_2_vz_7
            - inertias.inertia_link_2_hy * twist_link_2_vz_5);
    let wrench_outside_link_3_fy_8 = twist_link_2_vz_5 * 10.0
        + (twist_link_2_wz_2 * inertias.inertia_link_2_hz
            - twist_link_1_vy_0 * inertias.inertia_link_2_hy);
    let wrench_outside_link_3_mx_14 = twist_link_2_vz_7 * 10.0
        + (twist_link_1_vy_0 * inertias.inertia_link_2_hx
            - twist_link_2_wz_0 * inertias.inertia_link_2_hz);
    let wrench_outside_link_3_mx_16 = twist_link_2_vy_5 * 10.0
        + (twist_link_2_wz_0 * inertias.inertia_link_2_hy
            - twist_link_2_wz_2 * inertias.inertia_link_2_hx);
    let wrench_outside_link_3_mx = inertias.inertia_link_2_xx * twist_link_2_wx
        - inertias.minus_inertia_link_2_xy * twist_link_2_wy
        - inertias.minus_inertia_link_2_xz * twist_link_2_wz
        + (inertias.inertia_link_2_hy * twist_link_2_vz
            - inertias.inertia_link_2_hz * twist_link_2_vy)
        - (wrench_outside_link_3_mx_10 * twist_link_1_vy_0
            - wrench_outside_link_3_mx_12 * twist_link_2_wz_2
            + (wrench_outside_link_3_mx_14 * twist_link_2_vy_5
                - wrench_outside_link_3_mx_16 * twist_link_2_vz_7));
    let wrench_outside_link_3_fy = twist_link_2_vy * 10.0
        + (twist_link_2_wz * inertias.inertia_link_2_hx
            - twist_link_2_wx * inertias.inertia_link_2_hz)
        - (wrench_outside_link_3_mx_16 * twist_link_2_wz_0
            - wrench_outside_link_3_fy_8 * twist_link_1_vy_0);
    let wrench_outside_link_3_fz = twist_link_2_vz * 10.0
        + (twist_link_2_wx * inertias.inertia_link_2_hy
            - twist_link_2_wy * inertias.inertia_link_2_hx)
        - (wrench_outside_link_3_fy_8 * twist_link_2_wz_2
            - wrench_outside_link_3_mx_14 * twist_link_2_wz_0);
    let wrench_link_3_mx_10 = inertias.inertia_link_3_yy * twist_link_3_wz_3
        - inertias.minus_inertia_link_3_xy * twist_link_3_wz_1
        - inertias.minus_inertia_link_3_yz * twist_link_1_vy_0
        + (inertias.inertia_link_3_hz * twist_link_3_vz_5
            - inertias.inertia_link_3_hx * twist_link_3_vy_1);
    let wrench_link_3_mx_12 = inertias.inertia_link_3_zz * twist_link_1_vy_0
        - (inertias.minus_inertia_link_3_xz * twist_link_3_wz_1
            + inertias.minus_inertia_link_3_yz * twist_link_3_wz_3)
        + (inertias.inertia_link_3_hx * twist_link_3_vz_7
            - inertias.inertia_link_3_hy * twist_link_3_vz_5);
    let wrench_link_3_fy_8 = twist_link_3_vz_5 * 10.0
        + (twist_link_3_wz_3 * inertias.inertia_link_3_hz
            - twist_link_1_vy_0 * inertias.inertia_link_3_hy);
    let wrench_link_3_mx_14 = twist_link_3_vz_7 * 10.0
        + (twist_link_1_vy_0 * inertias.inertia_link_3_hx
            - twist_link_3_wz_1 * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_16 = twist_link_3_vy_1 * 10.0
        + (twist_link_3_wz_1 * inertias.inertia_link_3_hy
            - twist_link_3_wz_3 * inertias.inertia_link_3_hx);
    let wrench_link_3_mx = inertias.inertia_link_3_xx * twist_link_3_wx
        - inertias.minus_inertia_link_3_xy * twist_link_3_wy
        - inertias.minus_inertia_link_3_xz * twist_link_3_wz
        + (inertias.inertia_link_3_hy * twist_link_3_vz
            - inertias.inertia_link_3_hz * twist_link_3_vy)
        - (wrench_link_3_mx_10 * twist_link_1_vy_0
            - wrench_link_3_mx_12 * twist_link_3_wz_3
            + (wrench_link_3_mx_14 * twist_link_3_vy_1
                - wrench_link_3_mx_16 * twist_link_3_vz_7));
    let wrench_link_3_fy = twist_link_3_vy * 10.0
        + (twist_link_3_wz * inertias.inertia_link_3_hx
            - twist_link_3_wx * inertias.inertia_link_3_hz)
        - (wrench_link_3_mx_16 * twist_link_3_wz_1
            - wrench_link_3_fy_8 * twist_link_1_vy_0);
    let wrench_link_3_fz = twist_link_3_vz * 10.0
        + (twist_link_3_wx * inertias.inertia_link_3_hy
            - twist_link_3_wy * inertias.inertia_link_3_hx)
        - (wrench_link_3_fy_8 * twist_link_3_wz_3
            - wrench_link_3_mx_14 * twist_link_3_wz_1);
    let wrench_link_2_mx = wrench_outside_link_3_mx + wrench_link_3_mx;
    let wrench_link_2_fy = wrench_outside_link_3_fy + wrench_link_3_fy;
    let wrench_link_2_fz = wrench_outside_link_3_fz + wrench_link_3_fz;
    let wrench_link_1_mx = wrench_outside_link_2_mx + wrench_link_2_mx;
    let wrench_link_1_fy = wrench_outside_link_2_fy + wrench_link_2_fy;
    let wrench_link_1_fz = wrench_outside_link_2_fz + wrench_link_2_fz;
    let wrench_base_mx = wrench_link_1_mx - minus_wrench_outside_link_1_mx;
    let wrench_base_fy = wrench_link_1_fy - minus_wrench_outside_link_1_fy;
    let wrench_base_fz = wrench_link_1_fz - minus_wrench_outside_link_1_fz;
    // C V
    hamel_bias[0] = wrench_base_mx
        - (wrench_base_fy * minus_wrench_outside_link_1_my_5_0_2
            + wrench_base_fz * poses.minus_com_y) + 0.0;
    let twist_link_1_vx = (wrench_outside_link_2_mx_15
        - twist_link_1_vy_0 * poses.minus_origin_base_x) * qd[0];
    let twist_link_2_vx = twist_link_1_vx
        - (twist_link_2_wz_2 * screws.minus_screw_joint_2_vz
            + twist_link_1_vy_0 * screws.screw_joint_2_vy
            + twist_link_2_vy_5 * poses.sin_joint_1) * qd[1];
    let twist_link_3_vx = twist_link_2_vx
        + (twist_link_3_wz_3 * screws.screw_joint_3_vz
            - twist_link_1_vy_0 * screws.screw_joint_3_vy
            - twist_link_3_vy_1 * poses.sin_joint_1) * qd[2];
    let minus_wrench_outside_link_1_my_2 = inertias.inertia_base_xx
        * minus_twist_link_1_wy_0 + inertias.inertia_base_xy * twist_link_1_wx_0
        - inertias.minus_inertia_base_xz * minus_wrench_outside_link_1_mx_1
        + (inertias.inertia_base_hy * minus_wrench_outside_link_1_mx_5
            + inertias.minus_inertia_base_hz * minus_wrench_outside_link_1_mx_7);
    let minus_wrench_outside_link_1_my = minus_wrench_outside_link_1_mx_2
        * minus_twist_link_1_wy_0
        - minus_wrench_outside_link_1_my_2 * minus_wrench_outside_link_1_mx_1
        + (minus_wrench_outside_link_1_mx_6 * minus_wrench_outside_link_1_my_5
            - minus_wrench_outside_link_1_fy_2 * minus_wrench_outside_link_1_mx_5);
    let minus_wrench_outside_link_1_fx = minus_wrench_outside_link_1_mx_4
        * minus_wrench_outside_link_1_mx_1
        - minus_wrench_outside_link_1_mx_6 * twist_link_1_wx_0;
    let wrench_outside_link_2_my_10 = inertias.inertia_link_1_xx
        * minus_twist_link_1_wy_0 + inertias.inertia_link_1_xy * twist_link_1_wx_0
        + inertias.inertia_link_1_xz * twist_link_1_vy_0
        + (inertias.inertia_link_1_hy * minus_wrench_outside_link_1_mx_5
            - inertias.inertia_link_1_hz * wrench_outside_link_2_mx_15);
    let wrench_outside_link_2_my = inertias.inertia_link_1_xy * twist_link_1_wx
        - inertias.inertia_link_1_yy * minus_twist_link_1_wy
        + (inertias.inertia_link_1_hz * twist_link_1_vx
            + inertias.minus_inertia_link_1_hx * twist_link_1_vz)
        - (wrench_outside_link_2_mx_10 * minus_twist_link_1_wy_0
            - wrench_outside_link_2_my_10 * twist_link_1_vy_0
            + (wrench_outside_link_2_mx_14 * twist_link_1_vy_2
                - wrench_outside_link_2_fy_6 * minus_wrench_outside_link_1_mx_5));
    let wrench_outside_link_2_fx = twist_link_1_vx * 5.0
        - minus_twist_link_1_wy * inertias.inertia_link_1_hz
        - (wrench_outside_link_2_mx_12 * twist_link_1_vy_0
            - wrench_outside_link_2_mx_14 * twist_link_1_wx_0);
    let wrench_outside_link_3_my_12 = inertias.inertia_link_2_xx * twist_link_2_wz_0
        - inertias.minus_inertia_link_2_xy * twist_link_2_wz_2
        - inertias.minus_inertia_link_2_xz * twist_link_1_vy_0
        + (inertias.inertia_link_2_hy * twist_link_2_vy_5
            - inertias.inertia_link_2_hz * twist_link_2_vz_7);
    let wrench_outside_link_3_my = inertias.inertia_link_2_yy * twist_link_2_wy
        - inertias.minus_inertia_link_2_xy * twist_link_2_wx
        - inertias.minus_inertia_link_2_yz * twist_link_2_wz
        + (inertias.inertia_link_2_hz * twist_link_2_vx
            - inertias.inertia_link_2_hx * twist_link_2_vz)
        - (wrench_outside_link_3_mx_12 * twist_link_2_wz_0
            - wrench_outside_link_3_my_12 * twist_link_1_vy_0
            + (wrench_outside_link_3_mx_16 * twist_link_2_vz_5
                - wrench_outside_link_3_fy_8 * twist_link_2_vy_5));
    let wrench_outside_link_3_fx = twist_link_2_vx * 10.0
        + (twist_link_2_wy * inertias.inertia_link_2_hz
            - twist_link_2_wz * inertias.inertia_link_2_hy)
        - (wrench_outside_link_3_mx_14 * twist_link_1_vy_0
            - wrench_outside_link_3_mx_16 * twist_link_2_wz_2);
    let wrench_link_3_my_12 = inertias.inertia_link_3_xx * twist_link_3_wz_1
        - inertias.minus_inertia_link_3_xy * twist_link_3_wz_3
        - inertias.minus_inertia_link_3_xz * twist_link_1_vy_0
        + (inertias.inertia_link_3_hy * twist_link_3_vy_1
            - inertias.inertia_link_3_hz * twist_link_3_vz_7);
    let wrench_link_3_my = inertias.inertia_link_3_yy * twist_link_3_wy
        - inertias.minus_inertia_link_3_xy * twist_link_3_wx
        - inertias.minus_inertia_link_3_yz * twist_link_3_wz
        + (inertias.inertia_link_3_hz * twist_link_3_vx
            - inertias.inertia_link_3_hx * twist_link_3_vz)
        - (wrench_link_3_mx_12 * twist_link_3_wz_1
            - wrench_link_3_my_12 * twist_link_1_vy_0
            + (wrench_link_3_mx_16 * twist_link_3_vz_5
                - wrench_link_3_fy_8 * twist_link_3_vy_1));
    let wrench_link_3_fx = twist_link_3_vx * 10.0
        + (twist_link_3_wy * inertias.inertia_link_3_hz
            - twist_link_3_wz * inertias.inertia_link_3_hy)
        - (wrench_link_3_mx_14 * twist_link_1_vy_0
            - wrench_link_3_mx_16 * twist_link_3_wz_3);
    let wrench_link_2_my = wrench_outside_link_3_my + wrench_link_3_my;
    let wrench_link_2_fx = wrench_outside_link_3_fx + wrench_link_3_fx;
    let wrench_link_1_my = wrench_outside_link_2_my + wrench_link_2_my;
    let wrench_link_1_fx = wrench_outside_link_2_fx + wrench_link_2_fx;
    let wrench_base_my = wrench_link_1_my - minus_wrench_outside_link_1_my;
    let wrench_base_fx = wrench_link_1_fx - minus_wrench_outside_link_1_fx;
    hamel_bias[1] = wrench_base_my
        + (wrench_base_fx * minus_wrench_outside_link_1_my_5_0_2
            - wrench_base_fz * poses.com_x) + 0.0;
    let minus_wrench_outside_link_1_mz = minus_wrench_outside_link_1_my_2
        * twist_link_1_wx_0 - minus_wrench_outside_link_1_mx_0 * minus_twist_link_1_wy_0
        + (minus_wrench_outside_link_1_fy_2 * minus_wrench_outside_link_1_mx_7
            - minus_wrench_outside_link_1_mx_4 * minus_wrench_outside_link_1_my_5);
    let wrench_outside_link_2_mz = inertias.inertia_link_1_xz * twist_link_1_wx
        + inertias.minus_inertia_link_1_yz * minus_twist_link_1_wy
        - (inertias.minus_inertia_link_1_hx * twist_link_1_vy
            + inertias.inertia_link_1_hy * twist_link_1_vx)
        - (wrench_outside_link_2_my_10 * twist_link_1_wx_0
            - wrench_outside_link_2_mx_8 * minus_twist_link_1_wy_0
            + (wrench_outside_link_2_fy_6 * wrench_outside_link_2_mx_15
                - wrench_outside_link_2_mx_12 * twist_link_1_vy_2));
    let wrench_outside_link_3_mz = inertias.inertia_link_2_zz * twist_link_2_wz
        - (inertias.minus_inertia_link_2_xz * twist_link_2_wx
            + inertias.minus_inertia_link_2_yz * twist_link_2_wy)
        + (inertias.inertia_link_2_hx * twist_link_2_vy
            - inertias.inertia_link_2_hy * twist_link_2_vx)
        - (wrench_outside_link_3_my_12 * twist_link_2_wz_2
            - wrench_outside_link_3_mx_10 * twist_link_2_wz_0
            + (wrench_outside_link_3_fy_8 * twist_link_2_vz_7
                - wrench_outside_link_3_mx_14 * twist_link_2_vz_5));
    let wrench_link_3_mz = inertias.inertia_link_3_zz * twist_link_3_wz
        - (inertias.minus_inertia_link_3_xz * twist_link_3_wx
            + inertias.minus_inertia_link_3_yz * twist_link_3_wy)
        + (inertias.inertia_link_3_hx * twist_link_3_vy
            - inertias.inertia_link_3_hy * twist_link_3_vx)
        - (wrench_link_3_my_12 * twist_link_3_wz_3
            - wrench_link_3_mx_10 * twist_link_3_wz_1
            + (wrench_link_3_fy_8 * twist_link_3_vz_7
                - wrench_link_3_mx_14 * twist_link_3_vz_5));
    let wrench_link_2_mz = wrench_outside_link_3_mz + wrench_link_3_mz;
    let wrench_link_1_mz = wrench_outside_link_2_mz + wrench_link_2_mz;
    let wrench_base_mz = wrench_link_1_mz - minus_wrench_outside_link_1_mz;
    hamel_bias[2] = wrench_base_mz
        + (wrench_base_fx * poses.minus_com_y + wrench_base_fy * poses.com_x) + 0.0;
    hamel_bias[3] = wrench_base_fx + 0.0;
    hamel_bias[4] = wrench_base_fy + 0.0;
    hamel_bias[5] = wrench_base_fz + 0.0;
    hamel_bias[6] = wrench_link_1_mz + poses.origin_base_y * wrench_link_1_fx
        + poses.minus_origin_base_x * wrench_link_1_fy + 0.0;
    hamel_bias[7] = poses.cos_joint_1 * wrench_link_2_mx
        + poses.sin_joint_1 * wrench_link_2_my
        - screws.minus_screw_joint_2_vx * wrench_link_2_fx
        + screws.screw_joint_2_vy * wrench_link_2_fy
        - screws.minus_screw_joint_2_vz * wrench_link_2_fz + 0.0;
    hamel_bias[8] = poses.cos_joint_1 * wrench_link_3_mx
        + poses.sin_joint_1 * wrench_link_3_my
        - screws.minus_screw_joint_3_vx * wrench_link_3_fx
        + screws.screw_joint_3_vy * wrench_link_3_fy
        + screws.screw_joint_3_vz * wrench_link_3_fz + 0.0;
}
/// 𝓑(e_i, e_j) = ∂_i A_j − ∂_j A_i − ad_{A_i} A_j for all pairs of coordinates.
///
/// - `q`: shape (3; rad, m)
/// - `curvature`: 𝓑_ω(e_i, e_j), angular part of the curvature, base axes: x, y, z (3 of 3×3, by columns; rad)
/// - `com`: c, total centre of mass, base frame; 𝓑_v = c × 𝓑_ω (3; m)
///
/// 932 operations: 448 + −, 481 ×, 3 ÷; 3 sin cos; about 11.0 KiB of code.
pub fn curvature(q: &[f64; 3], curvature: &mut [[[f64; 3]; 3]; 3], com: &mut [f64; 3]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    // 𝓑_ω(e_i, e_j) x, column joint_1
    curvature[0][0][0] = 0.0;
    let minus_six_joint_1_mz_0_1 = inertias.inertia_base_hy * poses.minus_origin_base_x;
    let minus_six_joint_1_mz_0 = minus_six_joint_1_mz_0_1 + minus_six_joint_1_mz_0_1
        - (inertias.inertia_base_xy + inertias.inertia_base_xy);
    let six_joint_1_mx_3 = inertias.inertia_base_xx - inertias.inertia_base_yy
        - (inertias.inertia_base_xx_1 - inertias.inertia_base_yy_1);
    let six_more_joint_2_mz_3_1_0 = poses.sin_joint_1
        * inertias.minus_composite_link_2_xz;
    let six_more_joint_2_mz_3_1_1 = poses.cos_joint_1
        * inertias.minus_composite_link_2_yz;
    let six_more_joint_2_mz_3_1 = six_more_joint_2_mz_3_1_0 - six_more_joint_2_mz_3_1_1;
    let three_joint_2_y_2_2_1 = inertias.composite_link_2_hx
        * screws.minus_screw_joint_2_vx;
    let three_joint_2_x_0_0_1 = inertias.composite_link_2_hy * screws.screw_joint_2_vy;
    let three_joint_2_x_0_1_1 = inertias.composite_link_2_hz
        * screws.minus_screw_joint_2_vz;
    let three_joint_2_x_0_0 = three_joint_2_x_0_0_1 + three_joint_2_x_0_0_1;
    let three_joint_2_x_0_1 = three_joint_2_x_0_1_1 + three_joint_2_x_0_1_1;
    let three_joint_2_y_2_2 = three_joint_2_y_2_2_1 + three_joint_2_y_2_2_1;
    let three_joint_2_x_0 = three_joint_2_x_0_0 - three_joint_2_x_0_1
        - (six_more_joint_2_mz_3_1_0 + six_more_joint_2_mz_3_1_0);
    let three_joint_2_x_2 = inertias.inside_joint_2_mz_1_0
        - inertias.inside_joint_2_mz_1_1
        - (screws.inside_joint_2_mz_0 - screws.inside_joint_2_mz_1);
    let three_joint_2_x_4 = poses.sin_joint_1 * inertias.composite_link_2_zz
        - (inertias.inside_joint_2_my_0_1
            + poses.sin_joint_1 * inertias.composite_link_2_xx)
        + (screws.inside_joint_2_my_3 + screws.inside_joint_2_my_4);
    let three_joint_2_y_2 = six_more_joint_2_mz_3_1_1 + six_more_joint_2_mz_3_1_1
        - (three_joint_2_y_2_2 + three_joint_2_x_0_1);
    let three_joint_2_y_4 = poses.cos_joint_1 * inertias.composite_link_2_yy
        + inertias.inside_joint_2_mx_0_1
        - poses.cos_joint_1 * inertias.composite_link_2_zz
        - (screws.inside_joint_2_mx_4 - screws.inside_joint_2_mx_3);
    let six_more_joint_2_mz_3 = six_more_joint_2_mz_3_1 + six_more_joint_2_mz_3_1
        + (three_joint_2_x_0_0 - three_joint_2_y_2_2);
    let curvature_x_1_0_21_1_2_3 = (inertias.locked_inverse_pivot_z_4
        * inertias.locked_inverse_pivot_y_2 - inertias.locked_inverse_pivot_z_2)
        * inertias.locked_inverse_pivot_z;
    let curvature_x_1_0_21_1_2 = inertias.locked_inverse_pivot_y_2
        * inertias.locked_inverse_pivot_y
        + inertias.locked_inverse_pivot_z_4 * curvature_x_1_0_21_1_2_3;
    let curvature_x_1_0_21_1 = inertias.locked_inverse_pivot_x
        + inertias.locked_inverse_pivot_y_2 * curvature_x_1_0_21_1_2
        - inertias.locked_inverse_pivot_z_2 * curvature_x_1_0_21_1_2_3;
    let curvature_x_1_0_21 = minus_six_joint_1_mz_0 * curvature_x_1_0_21_1
        - six_joint_1_mx_3 * curvature_x_1_0_21_1_2
        - outside.outside_joint_1_my * curvature_x_1_0_21_1_2_3;
    let curvature_x_1_0_23 = reactions.reaction_joint_1_wz
        - (six_joint_1_mx_3 * curvature_x_1_0_21_1
            + outside.outside_joint_1_mx * curvature_x_1_0_21_1_2_3);
    let curvature_x_1_0_25 = reactions.reaction_joint_1_wy
        + (minus_six_joint_1_mz_0 * curvature_x_1_0_21_1_2_3
            - (outside.outside_joint_1_my * curvature_x_1_0_21_1
                + outside.outside_joint_1_mx * curvature_x_1_0_21_1_2));
    let curvature_x_1_0 = reactions.reaction_joint_1_wx
        * (three_joint_2_x_0 * curvature_x_1_0_21_1
            - three_joint_2_x_2 * curvature_x_1_0_21_1_2
            + three_joint_2_x_4 * curvature_x_1_0_21_1_2_3)
        + reactions.reaction_joint_1_wy
            * (three_joint_2_x_2 * curvature_x_1_0_21_1
                - three_joint_2_y_2 * curvature_x_1_0_21_1_2
                + three_joint_2_y_4 * curvature_x_1_0_21_1_2_3)
        + reactions.reaction_joint_1_wz
            * (three_joint_2_x_4 * curvature_x_1_0_21_1
                - three_joint_2_y_4 * curvature_x_1_0_21_1_2
                + six_more_joint_2_mz_3 * curvature_x_1_0_21_1_2_3)
        - curvature_x_1_0_21 * screws.connection_joint_2_wx
        + curvature_x_1_0_23 * screws.connection_joint_2_wy
        - curvature_x_1_0_25 * screws.connection_joint_2_wz;
    curvature[0][0][1] = curvature_x_1_0 + 0.0;
    let six_more_joint_3_mz_3_1_0 = poses.sin_joint_1 * inertias.minus_inertia_link_3_xz;
    let six_more_joint_3_mz_3_1_1 = poses.cos_joint_1 * inertias.minus_inertia_link_3_yz;
    let six_more_joint_3_mz_3_1 = six_more_joint_3_mz_3_1_0 - six_more_joint_3_mz_3_1_1;
    let three_joint_3_y_2_3_1 = inertias.inertia_link_3_hx
        * screws.minus_screw_joint_3_vx;
    let three_joint_3_x_0_0_1 = inertias.inertia_link_3_hy * screws.screw_joint_3_vy;
    let three_joint_3_x_0_1_1 = inertias.inertia_link_3_hz * screws.screw_joint_3_vz;
    let three_joint_3_x_0_0 = three_joint_3_x_0_0_1 + three_joint_3_x_0_0_1;
    let three_joint_3_x_0_1 = three_joint_3_x_0_1_1 + three_joint_3_x_0_1_1;
    let three_joint_3_y_2_3 = three_joint_3_y_2_3_1 + three_joint_3_y_2_3_1;
    let three_joint_3_x_0 = three_joint_3_x_0_0 + three_joint_3_x_0_1
        - (six_more_joint_3_mz_3_1_0 + six_more_joint_3_mz_3_1_0);
    let three_joint_3_x_2 = inertias.inside_joint_3_mz_1_0
        - inertias.inside_joint_3_mz_1_1
        - (screws.inside_joint_3_mz_0 - screws.inside_joint_3_mz_1);
    let three_joint_3_x_4 = poses.sin_joint_1 * inertias.inertia_link_3_zz
        - (inertias.inside_joint_3_my_0_1
            + poses.sin_joint_1 * inertias.inertia_link_3_xx)
        - (screws.inside_joint_3_my_4 - screws.inside_joint_3_my_3);
    let three_joint_3_y_2 = six_more_joint_3_mz_3_1_1 + six_more_joint_3_mz_3_1_1
        + (three_joint_3_x_0_1 - three_joint_3_y_2_3);
    let three_joint_3_y_4 = poses.cos_joint_1 * inertias.inertia_link_3_yy
        + inertias.inside_joint_3_mx_0_1 - poses.cos_joint_1 * inertias.inertia_link_3_zz
        - (screws.inside_joint_3_mx_3 + screws.inside_joint_3_mx_4);
    let six_more_joint_3_mz_3 = six_more_joint_3_mz_3_1 + six_more_joint_3_mz_3_1
        + (three_joint_3_x_0_0 - three_joint_3_y_2_3);
    let curvature_x_2_0_1 = three_joint_3_x_0 * curvature_x_1_0_21_1
        - three_joint_3_x_2 * curvature_x_1_0_21_1_2
        + three_joint_3_x_4 * curvature_x_1_0_21_1_2_3;
    let curvature_x_2_0_3 = three_joint_3_x_2 * curvature_x_1_0_21_1
        - three_joint_3_y_2 * curvature_x_1_0_21_1_2
        + three_joint_3_y_4 * curvature_x_1_0_21_1_2_3;
    let curvature_x_2_0_5 = three_joint_3_x_4 * curvature_x_1_0_21_1
        - three_joint_3_y_4 * curvature_x_1_0_21_1_2
        + six_more_joint_3_mz_3 * curvature_x_1_0_21_1_2_3;
    let curvature_x_2_0 = reactions.reaction_joint_1_wx * curvature_x_2_0_1
        + reactions.reaction_joint_1_wy * curvature_x_2_0_3
        + reactions.reaction_joint_1_wz * curvature_x_2_0_5
        - curvature_x_1_0_21 * screws.connection_joint_3_wx
        + curvature_x_1_0_23 * screws.connection_joint_3_wy
        - curvature_x_1_0_25 * screws.connection_joint_3_wz;
    curvature[0][0][2] = curvature_x_2_0 + 0.0;
    // 𝓑_ω(e_i, e_j) x, column joint_2
    curvature[0][1][0] = 0.0 - curvature_x_1_0;
    curvature[0][1][1] = 0.0;
    let minus_six_joint_2_mz_3_1_1 = poses.sin_joint_1
        * complements.complement_link_2_xz;
    let minus_six_joint_2_mz_3_1_0 = poses.cos_joint_1
        * complements.complement_link_2_yz;
    let minus_six_joint_2_mz_3_1 = minus_six_joint_2_mz_3_1_0
        - minus_six_joint_2_mz_3_1_1;
    let minus_six_joint_2_my_3_0_1 = complements.minus_complement_link_2_hx
        * screws.minus_screw_joint_2_vx;
    let six_joint_2_mx_1_2_1 = complements.complement_link_2_hy
        * screws.screw_joint_2_vy;
    let six_joint_2_mx_1_3_1 = complements.complement_link_2_hz
        * screws.minus_screw_joint_2_vz;
    let six_joint_2_mx_1_2 = six_joint_2_mx_1_2_1 + six_joint_2_mx_1_2_1;
    let six_joint_2_mx_1_3 = six_joint_2_mx_1_3_1 + six_joint_2_mx_1_3_1;
    let minus_six_joint_2_my_3_0 = minus_six_joint_2_my_3_0_1
        + minus_six_joint_2_my_3_0_1;
    let six_joint_2_mx_1 = minus_six_joint_2_mz_3_1_1 + minus_six_joint_2_mz_3_1_1
        + (six_joint_2_mx_1_2 - six_joint_2_mx_1_3);
    let six_joint_2_mx_3 = complements.outside_joint_2_mz_0_1
        - complements.outside_joint_2_mz_0_0
        + (screws.outside_joint_2_mz_1_1 + screws.outside_joint_2_mz_1_0);
    let minus_six_joint_2_mz_0 = poses.sin_joint_1 * complements.complement_link_2_zz
        + (complements.outside_joint_2_my_0_0
            - poses.sin_joint_1 * complements.complement_link_2_xx)
        - (screws.outside_joint_2_my_1_1 - screws.outside_joint_2_my_1_0);
    let minus_six_joint_2_my_3 = minus_six_joint_2_my_3_0 - six_joint_2_mx_1_3
        - (minus_six_joint_2_mz_3_1_0 + minus_six_joint_2_mz_3_1_0);
    let minus_six_joint_2_my_5 = poses.cos_joint_1 * complements.complement_link_2_yy
        - complements.outside_joint_2_mx_0_1
        - poses.cos_joint_1 * complements.complement_link_2_zz
        - (screws.outside_joint_2_mx_1_1 - screws.outside_joint_2_mx_1_0);
    let minus_six_joint_2_mz_3 = minus_six_joint_2_mz_3_1 + minus_six_joint_2_mz_3_1
        + (minus_six_joint_2_my_3_0 + six_joint_2_mx_1_2);
    let curvature_x_2_1_42 = curvature_x_1_0_21_1 * 260.0;
    let curvature_x_2_1_40 = curvature_x_1_0_21_1_2 * 260.0;
    let curvature_x_2_1_37 = curvature_x_1_0_21_1_2_3 * 260.0;
    let curvature_x_2_1 = reactions.reaction_joint_2_wx * curvature_x_2_0_1
        + reactions.reaction_joint_2_wy * curvature_x_2_0_3
        + reactions.reaction_joint_2_wz * curvature_x_2_0_5
        - (six_joint_2_mx_1 * curvature_x_1_0_21_1
            - six_joint_2_mx_3 * curvature_x_1_0_21_1_2
            + minus_six_joint_2_mz_0 * curvature_x_1_0_21_1_2_3)
            * screws.connection_joint_3_wx
        + (reactions.reaction_joint_2_wz
            - (six_joint_2_mx_3 * curvature_x_1_0_21_1
                - minus_six_joint_2_my_3 * curvature_x_1_0_21_1_2
                + minus_six_joint_2_my_5 * curvature_x_1_0_21_1_2_3))
            * screws.connection_joint_3_wy
        - (reactions.reaction_joint_2_wy
            + (minus_six_joint_2_mz_0 * curvature_x_1_0_21_1
                - minus_six_joint_2_my_5 * curvature_x_1_0_21_1_2
                + minus_six_joint_2_mz_3 * curvature_x_1_0_21_1_2_3))
            * screws.connection_joint_3_wz
        + (reactions.reaction_joint_2_vy * curvature_x_2_1_37
            + reactions.reaction_joint_2_vz * curvature_x_2_1_40)
            * screws.connection_joint_3_vx
        + (reactions.reaction_joint_2_vz * curvature_x_2_1_42
            - reactions.reaction_joint_2_vx * curvature_x_2_1_37)
            * screws.connection_joint_3_vy
        - (reactions.reaction_joint_2_vx * curvature_x_2_1_40
            + reactions.reaction_joint_2_vy * curvature_x_2_1_42)
            * screws.connection_joint_3_vz;
    curvature[0][1][2] = curvature_x_2_1 + 0.0;
    // 𝓑_ω(e_i, e_j) x, column joint_3
    curvature[0][2][0] = 0.0 - curvature_x_2_0;
    curvature[0][2][1] = 0.0 - curvature_x_2_1;
    curvature[0][2][2] = 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_1
    curvature[1][0][0] = 0.0;
    let six_joint_1_mx_4 = inertias.locked_inverse_pivot_z_4
        * inertias.locked_inverse_pivot_z;
    let curvature_y_1_0_22_1_3 = inertias.locked_inverse_pivot_y
        + inertias.locked_inverse_pivot_z_4 * six_joint_1_mx_4;
    let curvature_y_1_0_22_1 = inertias.locked_inverse_pivot_z_2 * six_joint_1_mx_4
        - inertias.locked_inverse_pivot_y_2 * curvature_y_1_0_22_1_3;
    let minus_six_joint_1_mz_4 = outside.outside_joint_1_mx * six_joint_1_mx_4;
    let curvature_y_1_0_22 = six_joint_1_mx_3 * curvature_y_1_0_22_1
        - minus_six_joint_1_mz_4;
    let curvature_y_1_0_20 = reactions.reaction_joint_1_wz
        + (minus_six_joint_1_mz_0 * curvature_y_1_0_22_1
            + six_joint_1_mx_3 * curvature_y_1_0_22_1_3
            + outside.outside_joint_1_my * six_joint_1_mx_4);
    let curvature_y_1_0_24 = reactions.reaction_joint_1_wx
        - (outside.outside_joint_1_mx * curvature_y_1_0_22_1_3
            - outside.outside_joint_1_my * curvature_y_1_0_22_1
            - minus_six_joint_1_mz_0 * six_joint_1_mx_4);
    let six_more_joint_2_mz_2 = three_joint_2_y_4 * six_joint_1_mx_4;
    let curvature_y_1_0 = reactions.reaction_joint_1_wx
        * (three_joint_2_x_0 * curvature_y_1_0_22_1
            + three_joint_2_x_2 * curvature_y_1_0_22_1_3
            - three_joint_2_x_4 * six_joint_1_mx_4)
        + reactions.reaction_joint_1_wy
            * (three_joint_2_x_2 * curvature_y_1_0_22_1
                + three_joint_2_y_2 * curvature_y_1_0_22_1_3 - six_more_joint_2_mz_2)
        + reactions.reaction_joint_1_wz
            * (three_joint_2_x_4 * curvature_y_1_0_22_1
                + three_joint_2_y_4 * curvature_y_1_0_22_1_3
                - six_more_joint_2_mz_3 * six_joint_1_mx_4)
        - curvature_y_1_0_20 * screws.connection_joint_2_wx
        - curvature_y_1_0_22 * screws.connection_joint_2_wy
        + curvature_y_1_0_24 * screws.connection_joint_2_wz;
    curvature[1][0][1] = curvature_y_1_0 + 0.0;
    let curvature_y_2_0_1 = three_joint_3_x_0 * curvature_y_1_0_22_1
        + three_joint_3_x_2 * curvature_y_1_0_22_1_3
        - three_joint_3_x_4 * six_joint_1_mx_4;
    let six_more_joint_3_mz_2 = three_joint_3_y_4 * six_joint_1_mx_4;
    let curvature_y_2_0_3 = three_joint_3_x_2 * curvature_y_1_0_22_1
        + three_joint_3_y_2 * curvature_y_1_0_22_1_3 - six_more_joint_3_mz_2;
    let curvature_y_2_0_5 = three_joint_3_x_4 * curvature_y_1_0_22_1
        + three_joint_3_y_4 * curvature_y_1_0_22_1_3
        - six_more_joint_3_mz_3 * six_joint_1_mx_4;
    let curvature_y_2_0 = reactions.reaction_joint_1_wx * curvature_y_2_0_1
        + reactions.reaction_joint_1_wy * curvature_y_2_0_3
        + reactions.reaction_joint_1_wz * curvature_y_2_0_5
        - curvature_y_1_0_20 * screws.connection_joint_3_wx
        - curvature_y_1_0_22 * screws.connection_joint_3_wy
        + curvature_y_1_0_24 * screws.connection_joint_3_wz;
    curvature[1][0][2] = curvature_y_2_0 + 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_2
    curvature[1][1][0] = 0.0 - curvature_y_1_0;
    curvature[1][1][1] = 0.0;
    let curvature_y_2_1_40 = curvature_y_1_0_22_1 * 260.0;
    let curvature_y_2_1_38 = curvature_y_1_0_22_1_3 * 260.0;
    let six_joint_2_fx_3 = six_joint_1_mx_4 * 260.0;
    let minus_six_joint_2_mz_2 = minus_six_joint_2_my_5 * six_joint_1_mx_4;
    let minus_six_joint_2_fz_0 = reactions.reaction_joint_2_vx * six_joint_2_fx_3;
    let curvature_y_2_1 = reactions.reaction_joint_2_wx * curvature_y_2_0_1
        + reactions.reaction_joint_2_wy * curvature_y_2_0_3
        + reactions.reaction_joint_2_wz * curvature_y_2_0_5
        - (reactions.reaction_joint_2_wz
            + (six_joint_2_mx_1 * curvature_y_1_0_22_1
                + six_joint_2_mx_3 * curvature_y_1_0_22_1_3
                - minus_six_joint_2_mz_0 * six_joint_1_mx_4))
            * screws.connection_joint_3_wx
        - (six_joint_2_mx_3 * curvature_y_1_0_22_1
            + minus_six_joint_2_my_3 * curvature_y_1_0_22_1_3 - minus_six_joint_2_mz_2)
            * screws.connection_joint_3_wy
        + (reactions.reaction_joint_2_wx
            - (minus_six_joint_2_mz_0 * curvature_y_1_0_22_1
                + minus_six_joint_2_my_5 * curvature_y_1_0_22_1_3
                - minus_six_joint_2_mz_3 * six_joint_1_mx_4))
            * screws.connection_joint_3_wz
        - (reactions.reaction_joint_2_vy * six_joint_2_fx_3
            + reactions.reaction_joint_2_vz * curvature_y_2_1_38)
            * screws.connection_joint_3_vx
        + (reactions.reaction_joint_2_vz * curvature_y_2_1_40 + minus_six_joint_2_fz_0)
            * screws.connection_joint_3_vy
        + (reactions.reaction_joint_2_vx * curvature_y_2_1_38
            - reactions.reaction_joint_2_vy * curvature_y_2_1_40)
            * screws.connection_joint_3_vz;
    curvature[1][1][2] = curvature_y_2_1 + 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_3
    curvature[1][2][0] = 0.0 - curvature_y_2_0;
    curvature[1][2][1] = 0.0 - curvature_y_2_1;
    curvature[1][2][2] = 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_1
    curvature[2][0][0] = 0.0;
    let minus_six_joint_1_mz_3 = inertias.locked_inverse_pivot_y_2 * six_joint_1_mx_4
        - inertias.locked_inverse_pivot_z_2 * inertias.locked_inverse_pivot_z;
    let minus_six_joint_1_mz = minus_six_joint_1_mz_0 * inertias.locked_inverse_pivot_z
        - (outside.outside_joint_1_my * minus_six_joint_1_mz_3 + minus_six_joint_1_mz_4);
    let six_joint_1_mx = reactions.reaction_joint_1_wy
        - (minus_six_joint_1_mz_0 * minus_six_joint_1_mz_3
            - six_joint_1_mx_3 * six_joint_1_mx_4
            - outside.outside_joint_1_my * inertias.locked_inverse_pivot_z);
    let minus_six_joint_1_my = reactions.reaction_joint_1_wx
        + (six_joint_1_mx_3 * minus_six_joint_1_mz_3
            + outside.outside_joint_1_mx * inertias.locked_inverse_pivot_z);
    let three_joint_2_x = three_joint_2_x_0 * minus_six_joint_1_mz_3
        - three_joint_2_x_2 * six_joint_1_mx_4
        + three_joint_2_x_4 * inertias.locked_inverse_pivot_z;
    let three_joint_2_y = three_joint_2_x_2 * minus_six_joint_1_mz_3
        - three_joint_2_y_2 * six_joint_1_mx_4
        + three_joint_2_y_4 * inertias.locked_inverse_pivot_z;
    let six_more_joint_2_mz = three_joint_2_x_4 * minus_six_joint_1_mz_3
        - six_more_joint_2_mz_2
        + six_more_joint_2_mz_3 * inertias.locked_inverse_pivot_z;
    let curvature_z_1_0 = reactions.reaction_joint_1_wx * three_joint_2_x
        + reactions.reaction_joint_1_wy * three_joint_2_y
        + reactions.reaction_joint_1_wz * six_more_joint_2_mz
        + six_joint_1_mx * screws.connection_joint_2_wx
        - minus_six_joint_1_my * screws.connection_joint_2_wy
        - minus_six_joint_1_mz * screws.connection_joint_2_wz;
    curvature[2][0][1] = curvature_z_1_0 + 0.0;
    let three_joint_3_x = three_joint_3_x_0 * minus_six_joint_1_mz_3
        - three_joint_3_x_2 * six_joint_1_mx_4
        + three_joint_3_x_4 * inertias.locked_inverse_pivot_z;
    let three_joint_3_y = three_joint_3_x_2 * minus_six_joint_1_mz_3
        - three_joint_3_y_2 * six_joint_1_mx_4
        + three_joint_3_y_4 * inertias.locked_inverse_pivot_z;
    let six_more_joint_3_mz = three_joint_3_x_4 * minus_six_joint_1_mz_3
        - six_more_joint_3_mz_2
        + six_more_joint_3_mz_3 * inertias.locked_inverse_pivot_z;
    let curvature_z_2_0 = reactions.reaction_joint_1_wx * three_joint_3_x
        + reactions.reaction_joint_1_wy * three_joint_3_y
        + reactions.reaction_joint_1_wz * six_more_joint_3_mz
        + six_joint_1_mx * screws.connection_joint_3_wx
        - minus_six_joint_1_my * screws.connection_joint_3_wy
        - minus_six_joint_1_mz * screws.connection_joint_3_wz;
    curvature[2][0][2] = curvature_z_2_0 + 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_2
    curvature[2][1][0] = 0.0 - curvature_z_1_0;
    curvature[2][1][1] = 0.0;
    let six_joint_2_fy_1 = minus_six_joint_1_mz_3 * 260.0;
    let six_joint_2_fx_1 = inertias.locked_inverse_pivot_z * 260.0;
    let minus_six_joint_2_mz = minus_six_joint_2_mz_0 * minus_six_joint_1_mz_3
        - minus_six_joint_2_mz_2
        + minus_six_joint_2_mz_3 * inertias.locked_inverse_pivot_z;
    let six_joint_2_mx = reactions.reaction_joint_2_wy
        - (six_joint_2_mx_1 * minus_six_joint_1_mz_3
            - six_joint_2_mx_3 * six_joint_1_mx_4
            + minus_six_joint_2_mz_0 * inertias.locked_inverse_pivot_z);
    let minus_six_joint_2_my = reactions.reaction_joint_2_wx
        + (six_joint_2_mx_3 * minus_six_joint_1_mz_3
            - minus_six_joint_2_my_3 * six_joint_1_mx_4
            + minus_six_joint_2_my_5 * inertias.locked_inverse_pivot_z);
    let six_joint_2_fx = reactions.reaction_joint_2_vy * six_joint_2_fx_1
        + reactions.reaction_joint_2_vz * six_joint_2_fx_3;
    let six_joint_2_fy = reactions.reaction_joint_2_vz * six_joint_2_fy_1
        - reactions.reaction_joint_2_vx * six_joint_2_fx_1;
    let minus_six_joint_2_fz = minus_six_joint_2_fz_0
        + reactions.reaction_joint_2_vy * six_joint_2_fy_1;
    let curvature_z_2_1 = reactions.reaction_joint_2_wx * three_joint_3_x
        + reactions.reaction_joint_2_wy * three_joint_3_y
        + reactions.reaction_joint_2_wz * six_more_joint_3_mz
        + six_joint_2_mx * screws.connection_joint_3_wx
        - minus_six_joint_2_my * screws.connection_joint_3_wy
        - minus_six_joint_2_mz * screws.connection_joint_3_wz
        + six_joint_2_fx * screws.connection_joint_3_vx
        + six_joint_2_fy * screws.connection_joint_3_vy
        - minus_six_joint_2_fz * screws.connection_joint_3_vz;
    curvature[2][1][2] = curvature_z_2_1 + 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_3
    curvature[2][2][0] = 0.0 - curvature_z_2_0;
    curvature[2][2][1] = 0.0 - curvature_z_2_1;
    curvature[2][2][2] = 0.0;
    // c
    com[0] = poses.com_x + 0.0;
    com[1] = 0.0 - poses.minus_com_y;
    com[2] = poses.com_z + 0.023809523809523808 + 0.0;
}
/// The momentum Λ_b μ, in the base frame and about the centre of mass.
///
/// - `q`: shape (3; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `body_momentum`: Λ_b μ, momentum, base frame (6; kg·m²/s, kg·m/s)
/// - `centroidal_momentum`: Λ_c μ, momentum about c, base axes (6; kg·m²/s, kg·m/s)
///
/// 249 operations: 120 + −, 126 ×, 3 ÷; 3 sin cos; about 3.0 KiB of code.
pub fn momentum(
    q: &[f64; 3],
    mu: &[f64; 6],
    body_momentum: &mut [f64; 6],
    centroidal_momentum: &mut [f64; 6],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let body_momentum_0_1_4 = poses.com_z + 0.023809523809523808;
    let body_momentum_0_0 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let body_momentum_0_1 = (mu[4] + (mu[2] * poses.com_x - mu[0] * body_momentum_0_1_4))
        * 130.0;
    let body_momentum_0_3 = (mu[5] - (mu[0] * poses.minus_com_y + mu[1] * poses.com_x))
        * 130.0;
    // Λ_b μ
    body_momentum[0] = body_momentum_0_0
        - (body_momentum_0_1 * body_momentum_0_1_4
            + body_momentum_0_3 * poses.minus_com_y) + 0.0;
    let body_momentum_1_0 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let body_momentum_1_1 = (mu[3]
        + (mu[1] * body_momentum_0_1_4 + mu[2] * poses.minus_com_y)) * 130.0;
    body_momentum[1] = body_momentum_1_0
        + (body_momentum_1_1 * body_momentum_0_1_4 - body_momentum_0_3 * poses.com_x)
        + 0.0;
    let body_momentum_2_0 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    body_momentum[2] = body_momentum_2_0
        + (body_momentum_1_1 * poses.minus_com_y + body_momentum_0_1 * poses.com_x)
        + 0.0;
    body_momentum[3] = body_momentum_1_1 + 0.0;
    body_momentum[4] = body_momentum_0_1 + 0.0;
    body_momentum[5] = body_momentum_0_3 + 0.0;
    // Λ_c μ
    centroidal_momentum[0] = body_momentum_0_0 + 0.0;
    centroidal_momentum[1] = body_momentum_1_0 + 0.0;
    centroidal_momentum[2] = body_momentum_2_0 + 0.0;
    centroidal_momentum[3] = body_momentum_1_1 + 0.0;
    centroidal_momentum[4] = body_momentum_0_1 + 0.0;
    centroidal_momentum[5] = body_momentum_0_3 + 0.0;
}
/// μ = Λ_b⁻¹ p: in free flight, where the momentum is known, μ need not be integrated.
///
/// - `q`: shape (3; rad, m)
/// - `body_momentum`: momentum, base frame (6; kg·m²/s, kg·m/s)
/// - `mu`: μ, locked velocity, base frame (6; rad/s, m/s)
///
/// 249 operations: 120 + −, 126 ×, 3 ÷; 3 sin cos; about 3.0 KiB of code.
pub fn velocity_of_momentum(q: &[f64; 3], body_momentum: &[f64; 6], mu: &mut [f64; 6]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let mu_0_3_3_8_6_2 = poses.com_z + 0.023809523809523808;
    let mu_0_3_3_8_6 = body_momentum[0]
        + (body_momentum[4] * mu_0_3_3_8_6_2 + body_momentum[5] * poses.minus_com_y);
    let mu_0_3_3_8 = body_momentum[1]
        + (body_momentum[5] * poses.com_x - body_momentum[3] * mu_0_3_3_8_6_2)
        - inertias.locked_inverse_pivot_y_2 * mu_0_3_3_8_6;
    let mu_0_3_3 = (body_momentum[2]
        - (body_momentum[3] * poses.minus_com_y + body_momentum[4] * poses.com_x)
        - inertias.locked_inverse_pivot_z_2 * mu_0_3_3_8_6
        - inertias.locked_inverse_pivot_z_4 * mu_0_3_3_8)
        * inertias.locked_inverse_pivot_z;
    let mu_0_3 = mu_0_3_3_8 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * mu_0_3_3;
    let mu_0 = mu_0_3_3_8_6 * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * mu_0_3
        - inertias.locked_inverse_pivot_z_2 * mu_0_3_3;
    // μ
    mu[0] = mu_0 + 0.0;
    mu[1] = mu_0_3 + 0.0;
    mu[2] = mu_0_3_3 + 0.0;
    mu[3] = body_momentum[3] * 0.007692307692307693
        - (mu_0_3 * mu_0_3_3_8_6_2 + mu_0_3_3 * poses.minus_com_y) + 0.0;
    mu[4] = body_momentum[4] * 0.007692307692307693
        + (mu_0 * mu_0_3_3_8_6_2 - mu_0_3_3 * poses.com_x) + 0.0;
    mu[5] = body_momentum[5] * 0.007692307692307693
        + (mu_0 * poses.minus_com_y + mu_0_3 * poses.com_x) + 0.0;
}
/// V₁ = μ − A_l q̇, which reconstructs the pose of the base: ġ₁ = g₁ V₁^.
///
/// - `q`: shape (3; rad, m)
/// - `qd`: shape velocity (3; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `base_twist`: V₁, body twist of the base, base frame (6; rad/s, m/s)
///
/// 435 operations: 208 + −, 224 ×, 3 ÷; 3 sin cos; about 5.2 KiB of code.
pub fn base_twist(
    q: &[f64; 3],
    qd: &[f64; 3],
    mu: &[f64; 6],
    base_twist: &mut [f64; 6],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let velocities = velocities(qd, &poses, &screws);
    base_twist_itself(mu, &poses, &velocities, base_twist);
}
/// ½ μᵀ Λ_b μ + ½ q̇ᵀ Λ_q q̇.
///
/// - `q`: shape (3; rad, m)
/// - `qd`: shape velocity (3; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `kinetic_energy`: ½ ξᵀ Λ ξ, kinetic energy (1; J)
///
/// 675 operations: 309 + −, 363 ×, 3 ÷; 3 sin cos; about 8.0 KiB of code.
pub fn kinetic_energy(
    q: &[f64; 3],
    qd: &[f64; 3],
    mu: &[f64; 6],
    kinetic_energy: &mut f64,
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let velocities = velocities(qd, &poses, &screws);
    let kinetic_energy_0_0_22_2 = poses.com_z + 0.023809523809523808;
    let kinetic_energy_0_0_22 = mu[3]
        + (mu[1] * kinetic_energy_0_0_22_2 + mu[2] * poses.minus_com_y);
    let kinetic_energy_0_0_25 = mu[4]
        + (mu[2] * poses.com_x - mu[0] * kinetic_energy_0_0_22_2);
    let kinetic_energy_0_0_28 = mu[5]
        - (mu[0] * poses.minus_com_y + mu[1] * poses.com_x);
    let kinetic_energy_0_0 = mu[0]
        * (inertias.composite_base_xx * mu[0] + inertias.composite_base_xy * mu[1]
            + inertias.composite_base_xz * mu[2])
        + mu[1]
            * (inertias.composite_base_xy * mu[0] + inertias.composite_base_yy * mu[1]
                + inertias.composite_base_yz * mu[2])
        + mu[2]
            * (inertias.composite_base_xz * mu[0] + inertias.composite_base_yz * mu[1]
                + inertias.composite_base_zz * mu[2])
        + kinetic_energy_0_0_22 * (kinetic_energy_0_0_22 * 130.0)
        + kinetic_energy_0_0_25 * (kinetic_energy_0_0_25 * 130.0)
        + kinetic_energy_0_0_28 * (kinetic_energy_0_0_28 * 130.0)
        + (velocities.minus_velocity_base_vz
            * (velocities.minus_velocity_base_vz * 105.0
                + (velocities.minus_velocity_base_wx * inertias.inertia_base_hy
                    + velocities.minus_velocity_base_wy
                        * inertias.minus_inertia_base_hx))
            - (velocities.minus_velocity_base_wx
                * (inertias.minus_inertia_base_xz * velocities.minus_velocity_base_wz
                    - (inertias.inertia_base_xx * velocities.minus_velocity_base_wx
                        + inertias.inertia_base_xy * velocities.minus_velocity_base_wy)
                    - (velocities.minus_velocity_base_vz * inertias.inertia_base_hy
                        + velocities.minus_velocity_base_vy
                            * inertias.minus_inertia_base_hz))
                + velocities.minus_velocity_base_wy
                    * (velocities.minus_velocity_base_vx * inertias.minus_inertia_base_hz
                        - velocities.minus_velocity_base_vz
                            * inertias.minus_inertia_base_hx
                        - (inertias.inertia_base_xy * velocities.minus_velocity_base_wx
                            + inertias.inertia_base_yy
                                * velocities.minus_velocity_base_wy
                            + inertias.inertia_base_yz
                                * velocities.minus_velocity_base_wz))
                + velocities.minus_velocity_base_wz
                    * (inertias.minus_inertia_base_xz * velocities.minus_velocity_base_wx
                        - inertias.inertia_base_yz * velocities.minus_velocity_base_wy
                        - inertias.inertia_base_zz * velocities.minus_velocity_base_wz
                        + (velocities.minus_velocity_base_vy
                            * inertias.minus_inertia_base_hx
                            + velocities.minus_velocity_base_vx
                                * inertias.inertia_base_hy))
                + velocities.minus_velocity_base_vx
                    * (velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hz
                        + velocities.minus_velocity_base_wz * inertias.inertia_base_hy
                        - velocities.minus_velocity_base_vx * 105.0)
                + velocities.minus_velocity_base_vy
                    * (velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hx
                        - velocities.minus_velocity_base_wx
                            * inertias.minus_inertia_base_hz
                        - velocities.minus_velocity_base_vy * 105.0)))
        + (velocities.velocity_link_1_wz
            * (inertias.minus_inertia_link_1_yz * velocities.minus_velocity_base_wy
                - inertias.inertia_link_1_xz * velocities.minus_velocity_base_wx
                + inertias.inertia_link_1_zz * velocities.velocity_link_1_wz
                - (velocities.velocity_link_1_vy * inertias.minus_inertia_link_1_hx
                    + velocities.velocity_link_1_vx * inertias.inertia_link_1_hy))
            - (velocities.minus_velocity_base_wx
                * (inertias.inertia_link_1_xz * velocities.velocity_link_1_wz
                    - (inertias.inertia_link_1_xx * velocities.minus_velocity_base_wx
                        + inertias.inertia_link_1_xy * velocities.minus_velocity_base_wy)
                    - (velocities.minus_velocity_base_vz * inertias.inertia_link_1_hy
                        + velocities.velocity_link_1_vy * inertias.inertia_link_1_hz))
                + velocities.minus_velocity_base_wy
                    * (velocities.velocity_link_1_vx * inertias.inertia_link_1_hz
                        - velocities.minus_velocity_base_vz
                            * inertias.minus_inertia_link_1_hx
                        - (inertias.inertia_link_1_xy * velocities.minus_velocity_base_wx
                            + inertias.inertia_link_1_yy
                                * velocities.minus_velocity_base_wy
                            + inertias.minus_inertia_link_1_yz
                                * velocities.velocity_link_1_wz)))
            + velocities.velocity_link_1_vx
                * (velocities.velocity_link_1_vx * 5.0
                    - (velocities.minus_velocity_base_wy * inertias.inertia_link_1_hz
                        + velocities.velocity_link_1_wz * inertias.inertia_link_1_hy))
            + velocities.velocity_link_1_vy
                * (velocities.velocity_link_1_vy * 5.0
                    + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hz
                        - velocities.velocity_link_1_wz
                            * inertias.minus_inertia_link_1_hx))
            + velocities.minus_velocity_base_vz
                * (velocities.minus_velocity_base_vz * 5.0
                    + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hy
                        + velocities.minus_velocity_base_wy
                            * inertias.minus_inertia_link_1_hx)))
        + (velocities.velocity_link_2_wx
            * (inertias.inertia_link_2_xx * velocities.velocity_link_2_wx
                - inertias.minus_inertia_link_2_xy * velocities.velocity_link_2_wy
                - inertias.minus_inertia_link_2_xz * velocities.velocity_link_1_wz
                - (velocities.minus_velocity_link_2_vz * inertias.inertia_link_2_hy
                    + velocities.velocity_link_2_vy * inertias.inertia_link_2_hz))
            + velocities.velocity_link_2_wy
                * (inertias.inertia_link_2_yy * velocities.velocity_link_2_wy
                    - inertias.minus_inertia_link_2_xy * velocities.velocity_link_2_wx
                    - inertias.minus_inertia_link_2_yz * velocities.velocity_link_1_wz
                    + (velocities.velocity_link_2_vx * inertias.inertia_link_2_hz
                        + velocities.minus_velocity_link_2_vz
                            * inertias.inertia_link_2_hx))
            + velocities.velocity_link_1_wz
                * (inertias.inertia_link_2_zz * velocities.velocity_link_1_wz
                    - (inertias.minus_inertia_link_2_xz * velocities.velocity_link_2_wx
                        + inertias.minus_inertia_link_2_yz
                            * velocities.velocity_link_2_wy)
                    + (velocities.velocity_link_2_vy * inertias.inertia_link_2_hx
                        - velocities.velocity_link_2_vx * inertias.inertia_link_2_hy))
            + velocities.velocity_link_2_vx
                * (velocities.velocity_link_2_vx * 10.0
                    + (velocities.velocity_link_2_wy * inertias.inertia_link_2_hz
                        - velocities.velocity_link_1_wz * inertias.inertia_link_2_hy))
            + velocities.velocity_link_2_vy
                * (velocities.velocity_link_2_vy * 10.0
                    + (velocities.velocity_link_1_wz * inertias.inertia_link_2_hx
                        - velocities.velocity_link_2_wx * inertias.inertia_link_2_hz))
            - velocities.minus_velocity_link_2_vz
                * (velocities.velocity_link_2_wx * inertias.inertia_link_2_hy
                    - velocities.velocity_link_2_wy * inertias.inertia_link_2_hx
                    - velocities.minus_velocity_link_2_vz * 10.0));
    // ½ ξᵀ Λ ξ
    *kinetic_energy = (kinetic_energy_0_0
        + (velocities.velocity_link_3_wx
            * (inertias.inertia_link_3_xx * velocities.velocity_link_3_wx
                - inertias.minus_inertia_link_3_xy * velocities.velocity_link_3_wy
                - inertias.minus_inertia_link_3_xz * velocities.velocity_link_1_wz
                + (velocities.velocity_link_3_vz * inertias.inertia_link_3_hy
                    - velocities.velocity_link_3_vy * inertias.inertia_link_3_hz))
            + velocities.velocity_link_3_wy
                * (inertias.inertia_link_3_yy * velocities.velocity_link_3_wy
                    - inertias.minus_inertia_link_3_xy * velocities.velocity_link_3_wx
                    - inertias.minus_inertia_link_3_yz * velocities.velocity_link_1_wz
                    + (velocities.velocity_link_3_vx * inertias.inertia_link_3_hz
                        - velocities.velocity_link_3_vz * inertias.inertia_link_3_hx))
            + velocities.velocity_link_1_wz
                * (inertias.inertia_link_3_zz * velocities.velocity_link_1_wz
                    - (inertias.minus_inertia_link_3_xz * velocities.velocity_link_3_wx
                        + inertias.minus_inertia_link_3_yz
                            * velocities.velocity_link_3_wy)
                    + (velocities.velocity_link_3_vy * inertias.inertia_link_3_hx
                        - velocities.velocity_link_3_vx * inertias.inertia_link_3_hy))
            + velocities.velocity_link_3_vx
                * (velocities.velocity_link_3_vx * 10.0
                    + (velocities.velocity_link_3_wy * inertias.inertia_link_3_hz
                        - velocities.velocity_link_1_wz * inertias.inertia_link_3_hy))
            + velocities.velocity_link_3_vy
                * (velocities.velocity_link_3_vy * 10.0
                    + (velocities.velocity_link_1_wz * inertias.inertia_link_3_hx
                        - velocities.velocity_link_3_wx * inertias.inertia_link_3_hz))
            + velocities.velocity_link_3_vz
                * (velocities.velocity_link_3_vz * 10.0
                    + (velocities.velocity_link_3_wx * inertias.inertia_link_3_hy
                        - velocities.velocity_link_3_wy * inertias.inertia_link_3_hx))))
        * 0.5 + 0.0;
}
/// ξ̇ = Λ⁻¹ (D_μ ξ − D_q̇ ξ + [F₁; τ − A_lᵀ F₁]) + [0; γ; 0], in O(n); factoring Λ_q where joints mimic.
///
/// - `q`: shape (3; rad, m)
/// - `qd`: shape velocity (3; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `gravity`: acceleration of free fall, base axes (3; m/s²)
/// - `base_wrench`: wrench on the base, base frame (6; N·m, N)
/// - `tau`: joint torques (3; N·m, N)
/// - `xi_dot`: ξ̇ = [μ̇; q̈], acceleration, base frame (9; rad/s², m/s²)
///
/// 1808 operations: 874 + −, 922 ×, 12 ÷; 3 sin cos; about 21.3 KiB of code.
pub fn forward_dynamics(
    q: &[f64; 3],
    qd: &[f64; 3],
    mu: &[f64; 6],
    gravity: &[f64; 3],
    base_wrench: &[f64; 6],
    tau: &[f64; 3],
    xi_dot: &mut [f64; 9],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let velocities = velocities(qd, &poses, &screws);
    let common_forward_dynamics_inverse_dynamics = common_forward_dynamics_inverse_dynamics(
        mu,
        qd,
        &poses,
        &inertias,
        &screws,
        &velocities,
    );
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
        &common_forward_dynamics_inverse_dynamics,
        xi_dot,
    );
}
/// V₁ = μ − A_l q̇ and ξ̇ at once: the rates of the pose, ġ₁ = g₁ V₁^, and of ξ.
///
/// - `q`: shape (3; rad, m)
/// - `qd`: shape velocity (3; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `gravity`: acceleration of free fall, base axes (3; m/s²)
/// - `base_wrench`: wrench on the base, base frame (6; N·m, N)
/// - `tau`: joint torques (3; N·m, N)
/// - `base_twist`: V₁, body twist of the base, base frame (6; rad/s, m/s)
/// - `xi_dot`: ξ̇ = [μ̇; q̈], acceleration, base frame (9; rad/s², m/s²)
///
/// 1827 operations: 887 + −, 928 ×, 12 ÷; 3 sin cos; about 21.5 KiB of code.
pub fn state_rate(
    q: &[f64; 3],
    qd: &[f64; 3],
    mu: &[f64; 6],
    gravity: &[f64; 3],
    base_wrench: &[f64; 6],
    tau: &[f64; 3],
    base_twist: &mut [f64; 6],
    xi_dot: &mut [f64; 9],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let velocities = velocities(qd, &poses, &screws);
    let common_forward_dynamics_inverse_dynamics = common_forward_dynamics_inverse_dynamics(
        mu,
        qd,
        &poses,
        &inertias,
        &screws,
        &velocities,
    );
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
        &common_forward_dynamics_inverse_dynamics,
        xi_dot,
    );
}
/// [F₁; τ − A_lᵀ F₁] = Λ (ξ̇ − [0; γ; 0]) + D_q̇ ξ − D_μ ξ, in O(n).
///
/// - `q`: shape (3; rad, m)
/// - `qd`: shape velocity (3; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `gravity`: acceleration of free fall, base axes (3; m/s²)
/// - `xi_dot`: acceleration, base frame (9; rad/s², m/s²)
/// - `base_wrench`: F₁, wrench on the base, base frame (6; N·m, N)
/// - `tau`: τ, joint torques (3; N·m, N)
///
/// 1533 operations: 738 + −, 792 ×, 3 ÷; 3 sin cos; about 18.1 KiB of code.
pub fn inverse_dynamics(
    q: &[f64; 3],
    qd: &[f64; 3],
    mu: &[f64; 6],
    gravity: &[f64; 3],
    xi_dot: &[f64; 9],
    base_wrench: &mut [f64; 6],
    tau: &mut [f64; 3],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let common_forward_dynamics_inverse_dynamics = common_forward_dynamics_inverse_dynamics(
        mu,
        qd,
        &poses,
        &inertias,
        &screws,
        &velocities,
    );
    let base_wrench_0_1_13_0_2 = poses.com_z + 0.023809523809523808;
    let base_wrench_0_0_28 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let base_wrench_0_0_30 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let base_wrench_0_0_7 = inertias.composite_link_1_xy + inertias.composite_link_1_xy;
    let base_wrench_0_0_6_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
    let base_wrench_0_0_6 = base_wrench_0_0_6_1 + base_wrench_0_0_6_1;
    let base_wrench_0_0_12 = poses.sin_joint_1 * inertias.minus_composite_link_2_xz;
    let base_wrench_0_0_9_1 = inertias.composite_link_2_hy * screws.screw_joint_2_vy;
    let base_wrench_0_0_10_1 = inertias.composite_link_2_hz
        * screws.minus_screw_joint_2_vz;
    let base_wrench_0_0_9 = base_wrench_0_0_9_1 + base_wrench_0_0_9_1;
    let base_wrench_0_0_10 = base_wrench_0_0_10_1 + base_wrench_0_0_10_1;
    let base_wrench_0_0_17 = poses.sin_joint_1 * inertias.minus_inertia_link_3_xz;
    let base_wrench_0_0_14_1 = inertias.inertia_link_3_hy * screws.screw_joint_3_vy;
    let base_wrench_0_0_15_1 = inertias.inertia_link_3_hz * screws.screw_joint_3_vz;
    let base_wrench_0_0_14 = base_wrench_0_0_14_1 + base_wrench_0_0_14_1;
    let base_wrench_0_0_15 = base_wrench_0_0_15_1 + base_wrench_0_0_15_1;
    let base_wrench_0_1_13_0 = mu[3]
        + (mu[1] * base_wrench_0_1_13_0_2 + mu[2] * poses.minus_com_y);
    let base_wrench_0_0_34_0 = mu[4]
        + (mu[2] * poses.com_x - mu[0] * base_wrench_0_1_13_0_2);
    let base_wrench_0_0_32_0 = mu[5] - (mu[0] * poses.minus_com_y + mu[1] * poses.com_x);
    let base_wrench_0_1_13 = base_wrench_0_1_13_0 * 130.0;
    let base_wrench_0_0_34 = base_wrench_0_0_34_0 * 130.0;
    let base_wrench_0_0_32 = base_wrench_0_0_32_0 * 130.0;
    let base_wrench_0_0_20 = (inertias.composite_link_1_xx - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 + inertias.inside_joint_1_mz_1_1)) * qd[0]
        + (inertias.inside_joint_2_mz_1_0 - inertias.inside_joint_2_mz_1_1
            - (screws.inside_joint_2_mz_0 - screws.inside_joint_2_mz_1)) * qd[1]
        + (inertias.inside_joint_3_mz_1_0 - inertias.inside_joint_3_mz_1_1
            - (screws.inside_joint_3_mz_0 - screws.inside_joint_3_mz_1)) * qd[2];
    let base_wrench_0_0_22 = (poses.sin_joint_1 * inertias.composite_link_2_zz
        - (inertias.inside_joint_2_my_0_1
            + poses.sin_joint_1 * inertias.composite_link_2_xx)
        + (screws.inside_joint_2_my_3 + screws.inside_joint_2_my_4)) * qd[1]
        - screws.inside_joint_1_my * qd[0]
        + (poses.sin_joint_1 * inertias.inertia_link_3_zz
            - (inertias.inside_joint_3_my_0_1
                + poses.sin_joint_1 * inertias.inertia_link_3_xx)
            - (screws.inside_joint_3_my_4 - screws.inside_joint_3_my_3)) * qd[2];
    let base_wrench_0_1_8 = velocities.minus_velocity_base_vx * 130.0;
    let base_wrench_0_0_24 = velocities.minus_velocity_base_vy * 130.0;
    let base_wrench_0_0_26 = velocities.minus_velocity_base_vz * 130.0;
    let base_wrench_0_1_12 = mu[0] - velocities.minus_velocity_base_wx;
    let base_wrench_0_0_31 = mu[1] - velocities.minus_velocity_base_wy;
    let base_wrench_0_0_29 = mu[2] - velocities.minus_velocity_base_wz;
    let base_wrench_0_0 = inertias.composite_base_xx * xi_dot[0]
        + inertias.composite_base_xy * xi_dot[1] + inertias.composite_base_xz * xi_dot[2]
        + (((base_wrench_0_0_6 - base_wrench_0_0_7) * qd[0]
            + (base_wrench_0_0_9 - base_wrench_0_0_10
                - (base_wrench_0_0_12 + base_wrench_0_0_12)) * qd[1]
            + (base_wrench_0_0_14 + base_wrench_0_0_15
                - (base_wrench_0_0_17 + base_wrench_0_0_17)) * qd[2]) * mu[0]
            + base_wrench_0_0_20 * mu[1] + base_wrench_0_0_22 * mu[2]
            + (base_wrench_0_0_24 * base_wrench_0_0_32_0
                - base_wrench_0_0_26 * base_wrench_0_0_34_0))
        - (base_wrench_0_0_28 * base_wrench_0_0_29
            - base_wrench_0_0_30 * base_wrench_0_0_31
            + (base_wrench_0_0_32 * velocities.minus_velocity_base_vy
                - base_wrench_0_0_34 * velocities.minus_velocity_base_vz));
    let base_wrench_0_1 = (xi_dot[4] - gravity[1]
        + (xi_dot[2] * poses.com_x - xi_dot[0] * base_wrench_0_1_13_0_2)) * 130.0
        + (mu[2] * base_wrench_0_1_8 - mu[0] * base_wrench_0_0_26)
        - (base_wrench_0_0_32 * base_wrench_0_1_12
            - base_wrench_0_1_13 * base_wrench_0_0_29);
    let base_wrench_0_3 = (xi_dot[5] - gravity[2]
        - (xi_dot[0] * poses.minus_com_y + xi_dot[1] * poses.com_x)) * 130.0
        + (mu[0] * base_wrench_0_0_24 - mu[1] * base_wrench_0_1_8)
        - (base_wrench_0_1_13 * base_wrench_0_0_31
            - base_wrench_0_0_34 * base_wrench_0_1_12);
    // F₁
    base_wrench[0] = base_wrench_0_0
        - (base_wrench_0_1 * base_wrench_0_1_13_0_2
            + base_wrench_0_3 * poses.minus_com_y) + 0.0;
    let base_wrench_1_0_30 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let base_wrench_1_0_9_1 = inertias.composite_link_1_hx * poses.origin_base_y;
    let base_wrench_1_0_9 = base_wrench_1_0_9_1 + base_wrench_1_0_9_1;
    let base_wrench_1_0_12 = poses.cos_joint_1 * inertias.minus_composite_link_2_yz;
    let base_wrench_1_0_13_1 = inertias.composite_link_2_hx
        * screws.minus_screw_joint_2_vx;
    let base_wrench_1_0_13 = base_wrench_1_0_13_1 + base_wrench_1_0_13_1;
    let base_wrench_1_0_17 = poses.cos_joint_1 * inertias.minus_inertia_link_3_yz;
    let base_wrench_1_0_19_1 = inertias.inertia_link_3_hx
        * screws.minus_screw_joint_3_vx;
    let base_wrench_1_0_19 = base_wrench_1_0_19_1 + base_wrench_1_0_19_1;
    let base_wrench_1_0_22 = screws.inside_joint_1_mx * qd[0]
        + (poses.cos_joint_1 * inertias.composite_link_2_yy
            + inertias.inside_joint_2_mx_0_1
            - poses.cos_joint_1 * inertias.composite_link_2_zz
            - (screws.inside_joint_2_mx_4 - screws.inside_joint_2_mx_3)) * qd[1]
        + (poses.cos_joint_1 * inertias.inertia_link_3_yy
            + inertias.inside_joint_3_mx_0_1
            - poses.cos_joint_1 * inertias.inertia_link_3_zz
            - (screws.inside_joint_3_mx_3 + screws.inside_joint_3_mx_4)) * qd[2];
    let base_wrench_1_0 = inertias.composite_base_xy * xi_dot[0]
        + inertias.composite_base_yy * xi_dot[1] + inertias.composite_base_yz * xi_dot[2]
        + (base_wrench_0_0_20 * mu[0]
            + ((base_wrench_0_0_7 + base_wrench_1_0_9) * qd[0]
                + (base_wrench_1_0_12 + base_wrench_1_0_12
                    - (base_wrench_1_0_13 + base_wrench_0_0_10)) * qd[1]
                + (base_wrench_1_0_17 + base_wrench_1_0_17
                    + (base_wrench_0_0_15 - base_wrench_1_0_19)) * qd[2]) * mu[1]
            + base_wrench_1_0_22 * mu[2]
            + (base_wrench_0_0_26 * base_wrench_0_1_13_0
                - base_wrench_0_1_8 * base_wrench_0_0_32_0))
        - (base_wrench_0_0_30 * base_wrench_0_1_12
            - base_wrench_1_0_30 * base_wrench_0_0_29
            + (base_wrench_0_1_13 * velocities.minus_velocity_base_vz
                - base_wrench_0_0_32 * velocities.minus_velocity_base_vx));
    let base_wrench_1_1 = (xi_dot[3] - gravity[0]
        + (xi_dot[1] * base_wrench_0_1_13_0_2 + xi_dot[2] * poses.minus_com_y)) * 130.0
        + (mu[1] * base_wrench_0_0_26 - mu[2] * base_wrench_0_0_24)
        - (base_wrench_0_0_34 * base_wrench_0_0_29
            - base_wrench_0_0_32 * base_wrench_0_0_31);
    base_wrench[1] = base_wrench_1_0
        + (base_wrench_1_1 * base_wrench_0_1_13_0_2 - base_wrench_0_3 * poses.com_x)
        + 0.0;
    let base_wrench_2_0_14 = base_wrench_0_0_12 - base_wrench_1_0_12;
    let base_wrench_2_0_19 = base_wrench_0_0_17 - base_wrench_1_0_17;
    let base_wrench_2_0 = inertias.composite_base_xz * xi_dot[0]
        + inertias.composite_base_yz * xi_dot[1] + inertias.composite_base_zz * xi_dot[2]
        + (base_wrench_0_0_22 * mu[0] + base_wrench_1_0_22 * mu[1]
            + ((base_wrench_1_0_9 + base_wrench_0_0_6) * qd[0]
                + (base_wrench_2_0_14 + base_wrench_2_0_14
                    + (base_wrench_0_0_9 - base_wrench_1_0_13)) * qd[1]
                + (base_wrench_2_0_19 + base_wrench_2_0_19
                    + (base_wrench_0_0_14 - base_wrench_1_0_19)) * qd[2]) * mu[2]
            + (base_wrench_0_1_8 * base_wrench_0_0_34_0
                - base_wrench_0_0_24 * base_wrench_0_1_13_0))
        - (base_wrench_1_0_30 * base_wrench_0_0_31
            - base_wrench_0_0_28 * base_wrench_0_1_12
            + (base_wrench_0_0_34 * velocities.minus_velocity_base_vx
                - base_wrench_0_1_13 * velocities.minus_velocity_base_vy));
    base_wrench[2] = base_wrench_2_0
        + (base_wrench_1_1 * poses.minus_com_y + base_wrench_0_1 * poses.com_x) + 0.0;
    base_wrench[3] = base_wrench_1_1 + 0.0;
    base_wrench[4] = base_wrench_0_1 + 0.0;
    base_wrench[5] = base_wrench_0_3 + 0.0;
    let minus_twist_base_wx = screws.connection_joint_1_wx * xi_dot[6]
        + screws.connection_joint_2_wx * xi_dot[7]
        + screws.connection_joint_3_wx * xi_dot[8];
    let minus_twist_base_wy = screws.connection_joint_1_wy * xi_dot[6]
        + screws.connection_joint_2_wy * xi_dot[7]
        + screws.connection_joint_3_wy * xi_dot[8];
    let minus_twist_base_wz = screws.connection_joint_1_wz * xi_dot[6]
        + screws.connection_joint_2_wz * xi_dot[7]
        + screws.connection_joint_3_wz * xi_dot[8];
    let minus_twist_base_vx = screws.connection_joint_1_vx * xi_dot[6]
        + screws.connection_joint_2_vx * xi_dot[7]
        + screws.connection_joint_3_vx * xi_dot[8];
    let minus_twist_base_vy = screws.connection_joint_1_vy * xi_dot[6]
        + screws.connection_joint_2_vy * xi_dot[7]
        + screws.connection_joint_3_vy * xi_dot[8];
    let minus_twist_base_vz = screws.connection_joint_2_vz * xi_dot[7]
        + screws.connection_joint_3_vz * xi_dot[8];
    let twist_link_1_wx = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_0_0_0_1_0_0 - minus_twist_base_wx;
    let minus_twist_link_1_wy = minus_twist_base_wy
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_1_1_0_1;
    let twist_link_1_wz = xi_dot[6] - minus_twist_base_wz;
    let twist_link_1_vx = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_my_0_1_0_1_0_0 + poses.origin_base_y * xi_dot[6]
        - minus_twist_base_vx;
    let twist_link_1_vy = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_1_1_1_0_0 + poses.minus_origin_base_x * xi_dot[6]
        - minus_twist_base_vy;
    let twist_link_1_vz = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_1_0_1_0_0 - minus_twist_base_vz;
    let twist_link_2_wx = twist_link_1_wx
        + (poses.cos_joint_1 * xi_dot[7]
            - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_0_1_0_1);
    let twist_link_2_wy = common_forward_dynamics_inverse_dynamics
        .wrench_link_3_mx_0_0_0_1_1_0_0 + poses.sin_joint_1 * xi_dot[7]
        - minus_twist_link_1_wy;
    let twist_link_2_wz = twist_link_1_wz
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_1_1_0;
    let twist_link_2_vx = twist_link_1_vx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_3_my_0_1_0_1_0_1
            - screws.minus_screw_joint_2_vx * xi_dot[7]);
    let twist_link_2_vy = twist_link_1_vy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_1_1_0_1
            + screws.screw_joint_2_vy * xi_dot[7]);
    let twist_link_2_vz = twist_link_1_vz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_0_1_0_1
            - screws.minus_screw_joint_2_vz * xi_dot[7]);
    let twist_link_3_wx = twist_link_2_wx
        + (poses.cos_joint_1 * xi_dot[8]
            - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_0_1_1);
    let twist_link_3_wy = twist_link_2_wy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_0_1_1_1
            + poses.sin_joint_1 * xi_dot[8]);
    let twist_link_3_wz = twist_link_2_wz
        + common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_0_1_1_1;
    let twist_link_3_vx = twist_link_2_vx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_3_my_0_1_0_1_1
            - screws.minus_screw_joint_3_vx * xi_dot[8]);
    let twist_link_3_vy = twist_link_2_vy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_1_1_1
            + screws.screw_joint_3_vy * xi_dot[8]);
    let twist_link_3_vz = twist_link_2_vz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1_0_1_1
            + screws.screw_joint_3_vz * xi_dot[8]);
    let wrench_outside_link_1_mx = inertias.minus_inertia_base_xz * minus_twist_base_wz
        - (inertias.inertia_base_xx * minus_twist_base_wx
            + inertias.inertia_base_xy * minus_twist_base_wy)
        - (inertias.inertia_base_hy * minus_twist_base_vz
            + inertias.minus_inertia_base_hz * minus_twist_base_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_base_mx_1_0;
    let wrench_outside_link_1_my = inertias.minus_inertia_base_hz * minus_twist_base_vx
        - inertias.minus_inertia_base_hx * minus_twist_base_vz
        - (inertias.inertia_base_xy * minus_twist_base_wx
            + inertias.inertia_base_yy * minus_twist_base_wy
            + inertias.inertia_base_yz * minus_twist_base_wz)
        - common_forward_dynamics_inverse_dynamics.wrench_base_my_1_0;
    let wrench_outside_link_1_mz = inertias.minus_inertia_base_xz * minus_twist_base_wx
        - inertias.inertia_base_yz * minus_twist_base_wy
        - inertias.inertia_base_zz * minus_twist_base_wz
        + (inertias.minus_inertia_base_hx * minus_twist_base_vy
            + inertias.inertia_base_hy * minus_twist_base_vx)
        - common_forward_dynamics_inverse_dynamics.wrench_base_mz_1_0;
    let wrench_outside_link_1_fx = minus_twist_base_wy * inertias.minus_inertia_base_hz
        + minus_twist_base_wz * inertias.inertia_base_hy - minus_twist_base_vx * 105.0
        - common_forward_dynamics_inverse_dynamics.wrench_base_fx_1_0;
    let wrench_outside_link_1_fy = minus_twist_base_wz * inertias.minus_inertia_base_hx
        - minus_twist_base_wx * inertias.minus_inertia_base_hz
        - minus_twist_base_vy * 105.0
        - common_forward_dynamics_inverse_dynamics.wrench_base_fy_1_0;
    let wrench_link_1_mx_0 = inertias.inertia_link_1_xx * twist_link_1_wx
        - inertias.inertia_link_1_xy * minus_twist_link_1_wy
        + inertias.inertia_link_1_xz * twist_link_1_wz
        + (inertias.inertia_link_1_hy * twist_link_1_vz
            - inertias.inertia_link_1_hz * twist_link_1_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_mx_0_1;
    let wrench_link_1_my_0 = inertias.inertia_link_1_xy * twist_link_1_wx
        - inertias.inertia_link_1_yy * minus_twist_link_1_wy
        - inertias.minus_inertia_link_1_yz * twist_link_1_wz
        + (inertias.inertia_link_1_hz * twist_link_1_vx
            + inertias.minus_inertia_link_1_hx * twist_link_1_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_my_0_1;
    let wrench_link_1_mz_0 = inertias.inertia_link_1_xz * twist_link_1_wx
        + inertias.minus_inertia_link_1_yz * minus_twist_link_1_wy
        + inertias.inertia_link_1_zz * twist_link_1_wz
        - (inertias.minus_inertia_link_1_hx * twist_link_1_vy
            + inertias.inertia_link_1_hy * twist_link_1_vx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_mz_0_1;
    let wrench_link_2_mx_0 = inertias.inertia_link_2_xx * twist_link_2_wx
        - inertias.minus_inertia_link_2_xy * twist_link_2_wy
        - inertias.minus_inertia_link_2_xz * twist_link_2_wz
        + (inertias.inertia_link_2_hy * twist_link_2_vz
            - inertias.inertia_link_2_hz * twist_link_2_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_mx_0_1;
    let wrench_link_2_my_0 = inertias.inertia_link_2_yy * twist_link_2_wy
        - inertias.minus_inertia_link_2_xy * twist_link_2_wx
        - inertias.minus_inertia_link_2_yz * twist_link_2_wz
        + (inertias.inertia_link_2_hz * twist_link_2_vx
            - inertias.inertia_link_2_hx * twist_link_2_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_my_0_1;
    let wrench_link_2_mz_0 = inertias.inertia_link_2_zz * twist_link_2_wz
        - (inertias.minus_inertia_link_2_xz * twist_link_2_wx
            + inertias.minus_inertia_link_2_yz * twist_link_2_wy)
        + (inertias.inertia_link_2_hx * twist_link_2_vy
            - inertias.inertia_link_2_hy * twist_link_2_vx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_mz_0_1;
    let wrench_link_3_mx = inertias.inertia_link_3_xx * twist_link_3_wx
        - inertias.minus_inertia_link_3_xy * twist_link_3_wy
        - inertias.minus_inertia_link_3_xz * twist_link_3_wz
        + (inertias.inertia_link_3_hy * twist_link_3_vz
            - inertias.inertia_link_3_hz * twist_link_3_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_1;
    let wrench_link_3_my = inertias.inertia_link_3_yy * twist_link_3_wy
        - inertias.minus_inertia_link_3_xy * twist_link_3_wx
        - inertias.minus_inertia_link_3_yz * twist_link_3_wz
        + (inertias.inertia_link_3_hz * twist_link_3_vx
            - inertias.inertia_link_3_hx * twist_link_3_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_my_1;
    let wrench_link_3_mz = inertias.inertia_link_3_zz * twist_link_3_wz
        - (inertias.minus_inertia_link_3_xz * twist_link_3_wx
            + inertias.minus_inertia_link_3_yz * twist_link_3_wy)
        + (inertias.inertia_link_3_hx * twist_link_3_vy
            - inertias.inertia_link_3_hy * twist_link_3_vx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mz_1;
    let wrench_link_2_mx = wrench_link_2_mx_0 + wrench_link_3_mx;
    let wrench_link_2_my = wrench_link_2_my_0 + wrench_link_3_my;
    let wrench_link_2_mz = wrench_link_2_mz_0 + wrench_link_3_mz;
    let wrench_link_1_mx = wrench_link_1_mx_0 + wrench_link_2_mx;
    let wrench_link_1_my = wrench_link_1_my_0 + wrench_link_2_my;
    let wrench_link_1_mz = wrench_link_1_mz_0 + wrench_link_2_mz;
    // τ
    tau[0] = reactions.reaction_joint_1_wx * wrench_link_1_mx
        + reactions.reaction_joint_1_wy * wrench_link_1_my
        + reactions.reaction_joint_1_wz * wrench_link_1_mz
        - (screws.connection_joint_1_wx * wrench_outside_link_1_mx
            + screws.connection_joint_1_wy * wrench_outside_link_1_my
            + screws.connection_joint_1_wz * wrench_outside_link_1_mz
            + screws.connection_joint_1_vx * wrench_outside_link_1_fx
            + screws.connection_joint_1_vy * wrench_outside_link_1_fy)
        + (screws.connection_joint_1_wx * base_wrench_0_0
            + screws.connection_joint_1_wy * base_wrench_1_0
            + screws.connection_joint_1_wz * base_wrench_2_0
            + screws.connection_joint_1_vx * base_wrench_1_1
            + screws.connection_joint_1_vy * base_wrench_0_1) + 0.0;
    let wrench_outside_link_1_fz = common_forward_dynamics_inverse_dynamics
        .wrench_base_fz_0_0
        - (minus_twist_base_vz * 105.0
            + (minus_twist_base_wx * inertias.inertia_base_hy
                + minus_twist_base_wy * inertias.minus_inertia_base_hx));
    let wrench_link_2_fx_0 = twist_link_2_vx * 10.0
        + (twist_link_2_wy * inertias.inertia_link_2_hz
            - twist_link_2_wz * inertias.inertia_link_2_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fx_0_1;
    let wrench_link_2_fy_0 = twist_link_2_vy * 10.0
        + (twist_link_2_wz * inertias.inertia_link_2_hx
            - twist_link_2_wx * inertias.inertia_link_2_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fy_0_1;
    let wrench_link_2_fz_0 = twist_link_2_vz * 10.0
        + (twist_link_2_wx * inertias.inertia_link_2_hy
            - twist_link_2_wy * inertias.inertia_link_2_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fz_0_1;
    let wrench_link_3_fx = twist_link_3_vx * 10.0
        + (twist_link_3_wy * inertias.inertia_link_3_hz
            - twist_link_3_wz * inertias.inertia_link_3_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fx_1;
    let wrench_link_3_fy = twist_link_3_vy * 10.0
        + (twist_link_3_wz * inertias.inertia_link_3_hx
            - twist_link_3_wx * inertias.inertia_link_3_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fy_1;
    let wrench_link_3_fz = twist_link_3_vz * 10.0
        + (twist_link_3_wx * inertias.inertia_link_3_hy
            - twist_link_3_wy * inertias.inertia_link_3_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fz_1;
    let wrench_link_2_fx = wrench_link_2_fx_0 + wrench_link_3_fx;
    let wrench_link_2_fy = wrench_link_2_fy_0 + wrench_link_3_fy;
    let wrench_link_2_fz = wrench_link_2_fz_0 + wrench_link_3_fz;
    let wrench_outside_link_2_mx = wrench_link_1_mx_0 + wrench_outside_link_1_mx;
    let wrench_outside_link_2_my = wrench_link_1_my_0 + wrench_outside_link_1_my;
    let wrench_outside_link_2_mz = wrench_link_1_mz_0 + wrench_outside_link_1_mz;
    let wrench_outside_link_2_fx = twist_link_1_vx * 5.0
        - (minus_twist_link_1_wy * inertias.inertia_link_1_hz
            + twist_link_1_wz * inertias.inertia_link_1_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_fx_0_1
        + wrench_outside_link_1_fx;
    let wrench_outside_link_2_fy = twist_link_1_vy * 5.0
        - (twist_link_1_wz * inertias.minus_inertia_link_1_hx
            + twist_link_1_wx * inertias.inertia_link_1_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_fy_0_1
        + wrench_outside_link_1_fy;
    let wrench_outside_link_2_fz = twist_link_1_vz * 5.0
        + (twist_link_1_wx * inertias.inertia_link_1_hy
            - minus_twist_link_1_wy * inertias.minus_inertia_link_1_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_fz_0_1
        + wrench_outside_link_1_fz;
    tau[1] = reactions.reaction_joint_2_wx * wrench_link_2_mx
        + reactions.reaction_joint_2_wy * wrench_link_2_my
        + reactions.reaction_joint_2_wz * wrench_link_2_mz
        + reactions.reaction_joint_2_vx * wrench_link_2_fx
        + reactions.reaction_joint_2_vy * wrench_link_2_fy
        + reactions.reaction_joint_2_vz * wrench_link_2_fz
        - (screws.connection_joint_2_wx * wrench_outside_link_2_mx
            + screws.connection_joint_2_wy * wrench_outside_link_2_my
            + screws.connection_joint_2_wz * wrench_outside_link_2_mz
            + screws.connection_joint_2_vx * wrench_outside_link_2_fx
            + screws.connection_joint_2_vy * wrench_outside_link_2_fy
            + screws.connection_joint_2_vz * wrench_outside_link_2_fz)
        + (screws.connection_joint_2_wx * base_wrench_0_0
            + screws.connection_joint_2_wy * base_wrench_1_0
            + screws.connection_joint_2_wz * base_wrench_2_0
            + screws.connection_joint_2_vx * base_wrench_1_1
            + screws.connection_joint_2_vy * base_wrench_0_1
            + screws.connection_joint_2_vz * base_wrench_0_3) + 0.0;
    let wrench_outside_link_3_mx = wrench_link_2_mx_0 + wrench_outside_link_2_mx;
    let wrench_outside_link_3_my = wrench_link_2_my_0 + wrench_outside_link_2_my;
    let wrench_outside_link_3_mz = wrench_link_2_mz_0 + wrench_outside_link_2_mz;
    let wrench_outside_link_3_fx = wrench_link_2_fx_0 + wrench_outside_link_2_fx;
    let wrench_outside_link_3_fy = wrench_link_2_fy_0 + wrench_outside_link_2_fy;
    let wrench_outside_link_3_fz = wrench_link_2_fz_0 + wrench_outside_link_2_fz;
    tau[2] = reactions.reaction_joint_3_wx * wrench_link_3_mx
        + reactions.reaction_joint_3_wy * wrench_link_3_my
        + reactions.reaction_joint_3_wz * wrench_link_3_mz
        + reactions.reaction_joint_3_vx * wrench_link_3_fx
        + reactions.reaction_joint_3_vy * wrench_link_3_fy
        + reactions.reaction_joint_3_vz * wrench_link_3_fz
        - (screws.connection_joint_3_wx * wrench_outside_link_3_mx
            + screws.connection_joint_3_wy * wrench_outside_link_3_my
            + screws.connection_joint_3_wz * wrench_outside_link_3_mz
            + screws.connection_joint_3_vx * wrench_outside_link_3_fx
            + screws.connection_joint_3_vy * wrench_outside_link_3_fy
            + screws.connection_joint_3_vz * wrench_outside_link_3_fz)
        + (screws.connection_joint_3_wx * base_wrench_0_0
            + screws.connection_joint_3_wy * base_wrench_1_0
            + screws.connection_joint_3_wz * base_wrench_2_0
            + screws.connection_joint_3_vx * base_wrench_1_1
            + screws.connection_joint_3_vy * base_wrench_0_1
            + screws.connection_joint_3_vz * base_wrench_0_3) + 0.0;
}
/// Where a link is, and how the joints move it at zero momentum.
///
/// - `q`: shape (3; rad, m)
/// - `pose`: g_k = [R p], rotation and position of the link in the base frame (3×4, by columns; m)
/// - `generalized_jacobian`: J̃_k = J_k − X_k A_l, body Jacobian of the link at zero momentum, link frame (6×3, by columns; rad, m)
///
/// 588 operations: 267 + −, 318 ×, 3 ÷; 3 sin cos; about 7.0 KiB of code.
pub fn kinematics_link_3(
    q: &[f64; 3],
    pose: &mut [[f64; 3]; 4],
    generalized_jacobian: &mut [[f64; 6]; 3],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    // g_k = [R p] column 0
    pose[0][0] = poses.cos_joint_1 + 0.0;
    pose[0][1] = poses.sin_joint_1 + 0.0;
    pose[0][2] = 0.0;
    // g_k = [R p] column 1
    pose[1][0] = poses.rotation_link_3_xy + 0.0;
    pose[1][1] = poses.rotation_link_3_yy + 0.0;
    pose[1][2] = poses.rotation_link_3_zy + 0.0;
    // g_k = [R p] column 2
    pose[2][0] = poses.minus_rotation_link_3_xx + 0.0;
    pose[2][1] = 0.0 - poses.rotation_link_3_yx;
    pose[2][2] = 0.0 - poses.rotation_link_3_zx;
    // g_k = [R p] column 3
    pose[3][0] = poses.origin_link_3_x + poses.com_x + 0.0;
    pose[3][1] = poses.origin_link_3_y - poses.minus_com_y + 0.0;
    pose[3][2] = poses.origin_link_3_z + (poses.com_z + 0.023809523809523808) + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_1
    generalized_jacobian[0][0] = poses.cos_joint_1 * reactions.reaction_joint_1_wx
        + poses.sin_joint_1 * reactions.reaction_joint_1_wy + 0.0;
    generalized_jacobian[0][1] = poses.rotation_link_3_xy * reactions.reaction_joint_1_wx
        + poses.rotation_link_3_yy * reactions.reaction_joint_1_wy
        + poses.rotation_link_3_zy * reactions.reaction_joint_1_wz + 0.0;
    generalized_jacobian[0][2] = poses.minus_rotation_link_3_xx
        * reactions.reaction_joint_1_wx
        - poses.rotation_link_3_yx * reactions.reaction_joint_1_wy
        - poses.rotation_link_3_zx * reactions.reaction_joint_1_wz + 0.0;
    let generalized_jacobian_3_0_1 = reactions.reaction_joint_1_wy
        * poses.origin_link_3_z - reactions.reaction_joint_1_wz * poses.origin_link_3_y;
    let generalized_jacobian_3_0_3 = reactions.reaction_joint_1_wz
        * poses.origin_link_3_x - reactions.reaction_joint_1_wx * poses.origin_link_3_z;
    generalized_jacobian[0][3] = poses.cos_joint_1 * generalized_jacobian_3_0_1
        + poses.sin_joint_1 * generalized_jacobian_3_0_3 + 0.0;
    let generalized_jacobian_4_0_5 = reactions.reaction_joint_1_wx
        * poses.origin_link_3_y - reactions.reaction_joint_1_wy * poses.origin_link_3_x;
    generalized_jacobian[0][4] = poses.rotation_link_3_xy * generalized_jacobian_3_0_1
        + poses.rotation_link_3_yy * generalized_jacobian_3_0_3
        + poses.rotation_link_3_zy * generalized_jacobian_4_0_5 + 0.0;
    generalized_jacobian[0][5] = poses.minus_rotation_link_3_xx
        * generalized_jacobian_3_0_1
        - poses.rotation_link_3_yx * generalized_jacobian_3_0_3
        - poses.rotation_link_3_zx * generalized_jacobian_4_0_5 + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_2
    generalized_jacobian[1][0] = poses.cos_joint_1 * reactions.reaction_joint_2_wx
        + poses.sin_joint_1 * reactions.reaction_joint_2_wy + 0.0;
    generalized_jacobian[1][1] = poses.rotation_link_3_xy * reactions.reaction_joint_2_wx
        + poses.rotation_link_3_yy * reactions.reaction_joint_2_wy
        + poses.rotation_link_3_zy * reactions.reaction_joint_2_wz + 0.0;
    generalized_jacobian[1][2] = poses.minus_rotation_link_3_xx
        * reactions.reaction_joint_2_wx
        - poses.rotation_link_3_yx * reactions.reaction_joint_2_wy
        - poses.rotation_link_3_zx * reactions.reaction_joint_2_wz + 0.0;
    let generalized_jacobian_3_1_1 = reactions.reaction_joint_2_vx
        + (reactions.reaction_joint_2_wy * poses.origin_link_3_z
            - reactions.reaction_joint_2_wz * poses.origin_link_3_y);
    let generalized_jacobian_3_1_3 = reactions.reaction_joint_2_vy
        + (reactions.reaction_joint_2_wz * poses.origin_link_3_x
            - reactions.reaction_joint_2_wx * poses.origin_link_3_z);
    generalized_jacobian[1][3] = poses.cos_joint_1 * generalized_jacobian_3_1_1
        + poses.sin_joint_1 * generalized_jacobian_3_1_3 + 0.0;
    let generalized_jacobian_4_1_5 = reactions.reaction_joint_2_vz
        + (reactions.reaction_joint_2_wx * poses.origin_link_3_y
            - reactions.reaction_joint_2_wy * poses.origin_link_3_x);
    generalized_jacobian[1][4] = poses.rotation_link_3_xy * generalized_jacobian_3_1_1
        + poses.rotation_link_3_yy * generalized_jacobian_3_1_3
        + poses.rotation_link_3_zy * generalized_jacobian_4_1_5 + 0.0;
    generalized_jacobian[1][5] = poses.minus_rotation_link_3_xx
        * generalized_jacobian_3_1_1
        - poses.rotation_link_3_yx * generalized_jacobian_3_1_3
        - poses.rotation_link_3_zx * generalized_jacobian_4_1_5 + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_3
    generalized_jacobian[2][0] = poses.cos_joint_1 * reactions.reaction_joint_3_wx
        + poses.sin_joint_1 * reactions.reaction_joint_3_wy + 0.0;
    generalized_jacobian[2][1] = poses.rotation_link_3_xy * reactions.reaction_joint_3_wx
        + poses.rotation_link_3_yy * reactions.reaction_joint_3_wy
        + poses.rotation_link_3_zy * reactions.reaction_joint_3_wz + 0.0;
    generalized_jacobian[2][2] = poses.minus_rotation_link_3_xx
        * reactions.reaction_joint_3_wx
        - poses.rotation_link_3_yx * reactions.reaction_joint_3_wy
        - poses.rotation_link_3_zx * reactions.reaction_joint_3_wz + 0.0;
    let generalized_jacobian_3_2_1 = reactions.reaction_joint_3_vx
        + (reactions.reaction_joint_3_wy * poses.origin_link_3_z
            - reactions.reaction_joint_3_wz * poses.origin_link_3_y);
    let generalized_jacobian_3_2_3 = reactions.reaction_joint_3_vy
        + (reactions.reaction_joint_3_wz * poses.origin_link_3_x
            - reactions.reaction_joint_3_wx * poses.origin_link_3_z);
    generalized_jacobian[2][3] = poses.cos_joint_1 * generalized_jacobian_3_2_1
        + poses.sin_joint_1 * generalized_jacobian_3_2_3 + 0.0;
    let generalized_jacobian_4_2_5 = reactions.reaction_joint_3_vz
        + (reactions.reaction_joint_3_wx * poses.origin_link_3_y
            - reactions.reaction_joint_3_wy * poses.origin_link_3_x);
    generalized_jacobian[2][4] = poses.rotation_link_3_xy * generalized_jacobian_3_2_1
        + poses.rotation_link_3_yy * generalized_jacobian_3_2_3
        + poses.rotation_link_3_zy * generalized_jacobian_4_2_5 + 0.0;
    generalized_jacobian[2][5] = poses.minus_rotation_link_3_xx
        * generalized_jacobian_3_2_1
        - poses.rotation_link_3_yx * generalized_jacobian_3_2_3
        - poses.rotation_link_3_zx * generalized_jacobian_4_2_5 + 0.0;
}
