//! The dynamics of the robot 'lwr_satellite', generated: read it, review its changes, do not edit it.
//!
//! Coordinates: joint_1, joint_2, joint_3, joint_4, joint_5, joint_6, joint_7.
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
pub const DOF: usize = 7;
/// Names of the coordinates, in the order of the columns.
pub const COORDINATES: [&str; DOF] = [
    "joint_1",
    "joint_2",
    "joint_3",
    "joint_4",
    "joint_5",
    "joint_6",
    "joint_7",
];
/// The robot, as one that answers quantities.
#[derive(Clone, Copy, Debug)]
pub struct LwrSatellite;
impl FloatingBase<f64> for LwrSatellite {
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
            Quantity::StateRate | Quantity::InverseDynamics | Quantity::Kinematics(7)
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
            (Quantity::Kinematics(7), [q], [pose, generalized_jacobian]) => {
                self::kinematics_link_7(
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
    sin_joint_2: f64,
    cos_joint_2: f64,
    rotation_link_2_xx: f64,
    rotation_link_2_yx: f64,
    minus_rotation_link_2_xy: f64,
    minus_rotation_link_2_yy: f64,
    rotation_link_3_zx: f64,
    rotation_link_3_xx: f64,
    rotation_link_3_yx: f64,
    minus_rotation_link_3_zy: f64,
    minus_rotation_link_3_xy: f64,
    rotation_link_3_yy: f64,
    rotation_link_4_xx: f64,
    rotation_link_4_yx: f64,
    rotation_link_4_zx: f64,
    rotation_link_4_xy: f64,
    rotation_link_4_yy: f64,
    rotation_link_5_zz: f64,
    rotation_link_5_xx: f64,
    rotation_link_5_yx: f64,
    rotation_link_5_zx: f64,
    rotation_link_6_xz: f64,
    rotation_link_5_yy: f64,
    rotation_link_6_zz: f64,
    minus_rotation_link_6_xy: f64,
    minus_rotation_link_6_yy: f64,
    rotation_link_6_zy: f64,
    rotation_link_7_xx: f64,
    rotation_link_7_yx: f64,
    rotation_link_7_zx: f64,
    minus_rotation_link_7_xy: f64,
    rotation_link_7_yy: f64,
    minus_rotation_link_7_zy: f64,
    com_x: f64,
    com_y: f64,
    com_z: f64,
    minus_origin_base_x_1_4: f64,
    minus_origin_base_y_1_0: f64,
    minus_origin_base_z_1_0: f64,
    minus_origin_base_x_1_0: f64,
    minus_origin_base_y_1_4: f64,
    minus_origin_base_z_1_4: f64,
    minus_origin_base_x_1_6: f64,
    minus_origin_base_y_1_6: f64,
    minus_origin_base_z_1_6: f64,
    minus_origin_base_x_1_8: f64,
    minus_origin_base_y_1_8: f64,
    minus_origin_base_z_1_8: f64,
    minus_origin_base_x_1_10: f64,
    minus_origin_base_y_1_10: f64,
    minus_origin_base_z_1_10: f64,
    minus_origin_base_x_1: f64,
    minus_origin_base_y_1: f64,
    minus_origin_base_z_1: f64,
    minus_origin_base_x: f64,
    minus_origin_base_y: f64,
    minus_origin_base_z: f64,
    origin_link_2_z: f64,
    minus_origin_link_3_x: f64,
    minus_origin_link_3_y: f64,
    origin_link_3_z: f64,
    minus_origin_link_4_x: f64,
    minus_origin_link_4_y: f64,
    origin_link_4_z: f64,
    minus_origin_link_5_x: f64,
    minus_origin_link_5_y: f64,
    origin_link_5_z: f64,
    minus_origin_link_6_x: f64,
    minus_origin_link_6_y: f64,
    origin_link_6_z: f64,
    minus_origin_link_7_x: f64,
    minus_origin_link_7_y: f64,
    origin_link_7_z: f64,
}
/// Rotations and origins of the bodies, from the centre of mass, base axes.
#[inline(never)]
fn poses(q: &[f64; 7]) -> Poses {
    // link_1
    let [(sin_joint_1, cos_joint_1), (sin_joint_2, cos_joint_2),
    (sin_joint_3, cos_joint_3), (sin_joint_4, cos_joint_4), (sin_joint_5, cos_joint_5),
    (sin_joint_6, cos_joint_6), (sin_joint_7, cos_joint_7)] = turn::sin_cos_each([
        q[0],
        q[1],
        q[2],
        q[3],
        q[4],
        q[5],
        q[6],
    ]);
    // link_2
    let rotation_link_2_xx = cos_joint_1 * cos_joint_2;
    let rotation_link_2_yx = sin_joint_1 * cos_joint_2;
    let minus_rotation_link_2_xy = cos_joint_1 * sin_joint_2;
    let minus_rotation_link_2_yy = sin_joint_1 * sin_joint_2;
    let minus_origin_link_3_x_0 = minus_rotation_link_2_xy * 0.2;
    let minus_origin_link_3_y_0 = minus_rotation_link_2_yy * 0.2;
    let origin_link_3_z_0_1 = cos_joint_2 * 0.2;
    let origin_link_3_z_0 = 0.31 + origin_link_3_z_0_1;
    // link_3
    let rotation_link_3_zx = sin_joint_2 * cos_joint_3;
    let rotation_link_3_xx = rotation_link_2_xx * cos_joint_3
        - sin_joint_1 * sin_joint_3;
    let rotation_link_3_yx = rotation_link_2_yx * cos_joint_3
        + cos_joint_1 * sin_joint_3;
    let minus_rotation_link_3_zy = sin_joint_2 * sin_joint_3;
    let minus_rotation_link_3_xy = sin_joint_1 * cos_joint_3
        + rotation_link_2_xx * sin_joint_3;
    let rotation_link_3_yy = cos_joint_1 * cos_joint_3
        - rotation_link_2_yx * sin_joint_3;
    let minus_origin_link_4_x_0 = minus_origin_link_3_x_0 + minus_origin_link_3_x_0;
    let minus_origin_link_4_y_0 = minus_origin_link_3_y_0 + minus_origin_link_3_y_0;
    let origin_link_4_z_0 = origin_link_3_z_0 + origin_link_3_z_0_1;
    // link_4
    let rotation_link_4_xx = rotation_link_3_xx * cos_joint_4
        + minus_rotation_link_2_xy * sin_joint_4;
    let rotation_link_4_yx = rotation_link_3_yx * cos_joint_4
        + minus_rotation_link_2_yy * sin_joint_4;
    let rotation_link_4_zx = rotation_link_3_zx * cos_joint_4
        - cos_joint_2 * sin_joint_4;
    let rotation_link_4_xy = minus_rotation_link_2_xy * cos_joint_4
        - rotation_link_3_xx * sin_joint_4;
    let rotation_link_4_yy = minus_rotation_link_2_yy * cos_joint_4
        - rotation_link_3_yx * sin_joint_4;
    // link_5
    let rotation_link_5_zz = cos_joint_2 * cos_joint_4
        + rotation_link_3_zx * sin_joint_4;
    let minus_origin_link_5_x_0 = minus_origin_link_4_x_0 + rotation_link_4_xy * 0.2;
    let minus_origin_link_5_y_0 = minus_origin_link_4_y_0 + rotation_link_4_yy * 0.2;
    let origin_link_5_z_0 = origin_link_4_z_0 + rotation_link_5_zz * 0.2;
    let rotation_link_5_xx = rotation_link_4_xx * cos_joint_5
        - minus_rotation_link_3_xy * sin_joint_5;
    let rotation_link_5_yx = rotation_link_4_yx * cos_joint_5
        + rotation_link_3_yy * sin_joint_5;
    let rotation_link_5_zx = rotation_link_4_zx * cos_joint_5
        - minus_rotation_link_3_zy * sin_joint_5;
    // link_6
    let rotation_link_6_xz = minus_rotation_link_3_xy * cos_joint_5
        + rotation_link_4_xx * sin_joint_5;
    // link_5
    let rotation_link_5_yy = rotation_link_3_yy * cos_joint_5
        - rotation_link_4_yx * sin_joint_5;
    // link_6
    let rotation_link_6_zz = minus_rotation_link_3_zy * cos_joint_5
        + rotation_link_4_zx * sin_joint_5;
    let com_x_10 = minus_origin_link_5_x_0 + rotation_link_4_xy * 0.19;
    let com_y_10 = minus_origin_link_5_y_0 + rotation_link_4_yy * 0.19;
    let com_z_9 = origin_link_5_z_0 + rotation_link_5_zz * 0.19;
    let rotation_link_6_xx = rotation_link_5_xx * cos_joint_6
        - rotation_link_4_xy * sin_joint_6;
    let rotation_link_6_yx = rotation_link_5_yx * cos_joint_6
        - rotation_link_4_yy * sin_joint_6;
    let rotation_link_6_zx = rotation_link_5_zx * cos_joint_6
        + rotation_link_5_zz * sin_joint_6;
    let minus_rotation_link_6_xy = rotation_link_4_xy * cos_joint_6
        + rotation_link_5_xx * sin_joint_6;
    let minus_rotation_link_6_yy = rotation_link_4_yy * cos_joint_6
        + rotation_link_5_yx * sin_joint_6;
    let rotation_link_6_zy = rotation_link_5_zz * cos_joint_6
        - rotation_link_5_zx * sin_joint_6;
    let com_x_12 = com_x_10 + minus_rotation_link_6_xy * 0.078;
    let com_y_12 = com_y_10 + minus_rotation_link_6_yy * 0.078;
    let com_z_11 = com_z_9 + rotation_link_6_zy * 0.078;
    // link_7
    let rotation_link_7_xx = rotation_link_6_xx * cos_joint_7
        - rotation_link_6_xz * sin_joint_7;
    let rotation_link_7_yx = rotation_link_6_yx * cos_joint_7
        + rotation_link_5_yy * sin_joint_7;
    let rotation_link_7_zx = rotation_link_6_zx * cos_joint_7
        - rotation_link_6_zz * sin_joint_7;
    let minus_rotation_link_7_xy = rotation_link_6_xz * cos_joint_7
        + rotation_link_6_xx * sin_joint_7;
    let rotation_link_7_yy = rotation_link_5_yy * cos_joint_7
        - rotation_link_6_yx * sin_joint_7;
    let minus_rotation_link_7_zy = rotation_link_6_zz * cos_joint_7
        + rotation_link_6_zx * sin_joint_7;
    let com_x_2 = sin_joint_1 * 0.04;
    let com_y_0 = cos_joint_1 * 0.04;
    let com_x_0 = com_x_2 - minus_rotation_link_2_xy * 0.07;
    let com_y_2 = com_y_0 + minus_rotation_link_2_yy * 0.07;
    let com_z_1 = 0.31 + cos_joint_2 * 0.07;
    let com_x_4_0 = minus_rotation_link_3_xy * 0.04;
    let com_y_4_3 = rotation_link_3_yy * 0.04;
    let com_z_3_3 = minus_rotation_link_3_zy * 0.04;
    let com_x_4 = com_x_4_0 - minus_rotation_link_2_xy * 0.13 - minus_origin_link_3_x_0;
    let com_y_4 = minus_origin_link_3_y_0
        + (minus_rotation_link_2_yy * 0.13 + com_y_4_3);
    let com_z_3 = origin_link_3_z_0 + (cos_joint_2 * 0.13 + com_z_3_3);
    let com_x_6 = minus_origin_link_4_x_0 + (com_x_4_0 + rotation_link_4_xy * 0.07);
    let com_y_6 = com_y_4_3 - rotation_link_4_yy * 0.07 - minus_origin_link_4_y_0;
    let com_z_5 = origin_link_4_z_0 + (rotation_link_5_zz * 0.07 - com_z_3_3);
    let com_x_8 = minus_origin_link_5_x_0
        + (rotation_link_4_xy * 0.124 + rotation_link_6_xz * 0.02);
    let com_y_8 = rotation_link_5_yy * 0.02 - rotation_link_4_yy * 0.124
        - minus_origin_link_5_y_0;
    let com_z_7 = origin_link_5_z_0
        + (rotation_link_5_zz * 0.124 - rotation_link_6_zz * 0.02);
    let com_x = (com_x_0 * 2.0 - com_x_2 * 2.0 + com_x_4 * 2.0 - com_x_6 * 2.0
        - com_x_8 * 2.0 - com_x_10 * 2.0 - com_x_12 * 2.0) * 0.05714285714285714;
    let com_y = (com_y_0 * 2.0 - com_y_2 * 2.0 - com_y_4 * 2.0 + com_y_6 * 2.0
        + com_y_8 * 2.0 - com_y_10 * 2.0 - com_y_12 * 2.0) * 0.05714285714285714;
    let com_z = (0.48 + com_z_1 * 2.0 + com_z_3 * 2.0 + com_z_5 * 2.0 + com_z_7 * 2.0
        + com_z_9 * 2.0 + com_z_11 * 2.0) * 0.05714285714285714;
    let minus_origin_base_x_1_4 = com_x_2 + com_x;
    let minus_origin_base_y_1_0 = com_y_0 - com_y;
    let minus_origin_base_z_1_0 = 0.24 - com_z;
    let minus_origin_base_x_1_0 = com_x_0 - com_x;
    let minus_origin_base_y_1_4 = com_y_2 + com_y;
    let minus_origin_base_z_1_4 = com_z_1 - com_z;
    let minus_origin_base_x_1_6 = com_x_4 - com_x;
    let minus_origin_base_y_1_6 = com_y_4 + com_y;
    let minus_origin_base_z_1_6 = com_z_3 - com_z;
    let minus_origin_base_x_1_8 = com_x_6 + com_x;
    let minus_origin_base_y_1_8 = com_y_6 - com_y;
    let minus_origin_base_z_1_8 = com_z_5 - com_z;
    let minus_origin_base_x_1_10 = com_x_8 + com_x;
    let minus_origin_base_y_1_10 = com_y_8 - com_y;
    let minus_origin_base_z_1_10 = com_z_7 - com_z;
    let minus_origin_link_6_x_0 = com_x_10 + com_x;
    let minus_origin_link_6_y_0 = com_y_10 + com_y;
    let origin_link_6_z_0 = com_z_9 - com_z;
    let minus_origin_link_7_x_0 = com_x_12 + com_x;
    let minus_origin_link_7_y_0 = com_y_12 + com_y;
    let origin_link_7_z_0 = com_z_11 - com_z;
    let minus_origin_base_x_1 = (minus_origin_base_x_1_0 * 2.0
        - (com_x * 3.5 + minus_origin_base_x_1_4 * 2.0) + minus_origin_base_x_1_6 * 2.0
        - minus_origin_base_x_1_8 * 2.0 - minus_origin_base_x_1_10 * 2.0
        - minus_origin_link_6_x_0 * 2.0 - minus_origin_link_7_x_0 * 2.0)
        * 0.05714285714285714;
    let minus_origin_base_y_1 = (minus_origin_base_y_1_0 * 2.0 - com_y * 3.5
        - minus_origin_base_y_1_4 * 2.0 - minus_origin_base_y_1_6 * 2.0
        + minus_origin_base_y_1_8 * 2.0 + minus_origin_base_y_1_10 * 2.0
        - minus_origin_link_6_y_0 * 2.0 - minus_origin_link_7_y_0 * 2.0)
        * 0.05714285714285714;
    let minus_origin_base_z_1 = (minus_origin_base_z_1_0 * 2.0 - com_z * 3.5
        + minus_origin_base_z_1_4 * 2.0 + minus_origin_base_z_1_6 * 2.0
        + minus_origin_base_z_1_8 * 2.0 + minus_origin_base_z_1_10 * 2.0
        + origin_link_6_z_0 * 2.0 + origin_link_7_z_0 * 2.0) * 0.05714285714285714;
    // base
    let minus_origin_base_x = com_x + minus_origin_base_x_1;
    let minus_origin_base_y = com_y + minus_origin_base_y_1;
    let minus_origin_base_z = com_z + minus_origin_base_z_1;
    // link_2
    let origin_link_2_z = 0.31 - com_z - minus_origin_base_z_1;
    // link_3
    let minus_origin_link_3_x = minus_origin_link_3_x_0 + com_x + minus_origin_base_x_1;
    let minus_origin_link_3_y = minus_origin_link_3_y_0 + com_y + minus_origin_base_y_1;
    let origin_link_3_z = origin_link_3_z_0 - com_z - minus_origin_base_z_1;
    // link_4
    let minus_origin_link_4_x = minus_origin_link_4_x_0 + com_x + minus_origin_base_x_1;
    let minus_origin_link_4_y = minus_origin_link_4_y_0 + com_y + minus_origin_base_y_1;
    let origin_link_4_z = origin_link_4_z_0 - com_z - minus_origin_base_z_1;
    // link_5
    let minus_origin_link_5_x = minus_origin_link_5_x_0 + com_x + minus_origin_base_x_1;
    let minus_origin_link_5_y = minus_origin_link_5_y_0 + com_y + minus_origin_base_y_1;
    let origin_link_5_z = origin_link_5_z_0 - com_z - minus_origin_base_z_1;
    // link_6
    let minus_origin_link_6_x = minus_origin_link_6_x_0 + minus_origin_base_x_1;
    let minus_origin_link_6_y = minus_origin_link_6_y_0 + minus_origin_base_y_1;
    let origin_link_6_z = origin_link_6_z_0 - minus_origin_base_z_1;
    // link_7
    let minus_origin_link_7_x = minus_origin_link_7_x_0 + minus_origin_base_x_1;
    let minus_origin_link_7_y = minus_origin_link_7_y_0 + minus_origin_base_y_1;
    let origin_link_7_z = origin_link_7_z_0 - minus_origin_base_z_1;
    Poses {
        sin_joint_1,
        cos_joint_1,
        sin_joint_2,
        cos_joint_2,
        rotation_link_2_xx,
        rotation_link_2_yx,
        minus_rotation_link_2_xy,
        minus_rotation_link_2_yy,
        rotation_link_3_zx,
        rotation_link_3_xx,
        rotation_link_3_yx,
        minus_rotation_link_3_zy,
        minus_rotation_link_3_xy,
        rotation_link_3_yy,
        rotation_link_4_xx,
        rotation_link_4_yx,
        rotation_link_4_zx,
        rotation_link_4_xy,
        rotation_link_4_yy,
        rotation_link_5_zz,
        rotation_link_5_xx,
        rotation_link_5_yx,
        rotation_link_5_zx,
        rotation_link_6_xz,
        rotation_link_5_yy,
        rotation_link_6_zz,
        minus_rotation_link_6_xy,
        minus_rotation_link_6_yy,
        rotation_link_6_zy,
        rotation_link_7_xx,
        rotation_link_7_yx,
        rotation_link_7_zx,
        minus_rotation_link_7_xy,
        rotation_link_7_yy,
        minus_rotation_link_7_zy,
        com_x,
        com_y,
        com_z,
        minus_origin_base_x_1_4,
        minus_origin_base_y_1_0,
        minus_origin_base_z_1_0,
        minus_origin_base_x_1_0,
        minus_origin_base_y_1_4,
        minus_origin_base_z_1_4,
        minus_origin_base_x_1_6,
        minus_origin_base_y_1_6,
        minus_origin_base_z_1_6,
        minus_origin_base_x_1_8,
        minus_origin_base_y_1_8,
        minus_origin_base_z_1_8,
        minus_origin_base_x_1_10,
        minus_origin_base_y_1_10,
        minus_origin_base_z_1_10,
        minus_origin_base_x_1,
        minus_origin_base_y_1,
        minus_origin_base_z_1,
        minus_origin_base_x,
        minus_origin_base_y,
        minus_origin_base_z,
        origin_link_2_z,
        minus_origin_link_3_x,
        minus_origin_link_3_y,
        origin_link_3_z,
        minus_origin_link_4_x,
        minus_origin_link_4_y,
        origin_link_4_z,
        minus_origin_link_5_x,
        minus_origin_link_5_y,
        origin_link_5_z,
        minus_origin_link_6_x,
        minus_origin_link_6_y,
        origin_link_6_z,
        minus_origin_link_7_x,
        minus_origin_link_7_y,
        origin_link_7_z,
    }
}
/// Inertias of the bodies and of their subtrees, centroidal frame.
struct Inertias {
    minus_inertia_base_hx: f64,
    minus_inertia_base_hy: f64,
    minus_inertia_base_hz: f64,
    inertia_base_yy_1: f64,
    inertia_base_xx_1: f64,
    minus_inertia_base_xy: f64,
    minus_inertia_base_xz: f64,
    minus_inertia_base_yz: f64,
    inertia_base_zz_1: f64,
    inertia_base_xx: f64,
    inertia_base_yy: f64,
    inertia_base_zz: f64,
    minus_inertia_link_1_hx: f64,
    inertia_link_1_hy: f64,
    inertia_link_1_hz: f64,
    inertia_link_1_xz: f64,
    minus_inertia_link_1_yz: f64,
    inertia_link_1_xx: f64,
    inertia_link_1_xy: f64,
    inertia_link_1_yy: f64,
    inertia_link_1_zz: f64,
    inertia_link_2_hx: f64,
    minus_inertia_link_2_hy: f64,
    inertia_link_2_hz: f64,
    inertia_link_2_xx: f64,
    inertia_link_2_xy: f64,
    inertia_link_2_xz: f64,
    inertia_link_2_yy: f64,
    inertia_link_2_yz: f64,
    inertia_link_2_zz: f64,
    inertia_link_3_hx: f64,
    minus_inertia_link_3_hy: f64,
    inertia_link_3_hz: f64,
    inertia_link_3_xx: f64,
    inertia_link_3_xy: f64,
    inertia_link_3_xz: f64,
    inertia_link_3_yy: f64,
    inertia_link_3_yz: f64,
    inertia_link_3_zz: f64,
    minus_inertia_link_4_hx: f64,
    inertia_link_4_hy: f64,
    inertia_link_4_hz: f64,
    inertia_link_4_xx: f64,
    inertia_link_4_xy: f64,
    inertia_link_4_xz: f64,
    inertia_link_4_yy: f64,
    inertia_link_4_yz: f64,
    inertia_link_4_zz: f64,
    minus_inertia_link_5_hx: f64,
    inertia_link_5_hy: f64,
    inertia_link_5_hz: f64,
    inertia_link_5_xx: f64,
    inertia_link_5_xy: f64,
    inertia_link_5_xz: f64,
    inertia_link_5_yy: f64,
    inertia_link_5_yz: f64,
    inertia_link_5_zz: f64,
    minus_inertia_link_6_hx: f64,
    minus_inertia_link_6_hy: f64,
    inertia_link_6_hz: f64,
    minus_inertia_link_6_xy: f64,
    inertia_link_6_xz: f64,
    inertia_link_6_yz: f64,
    inertia_link_6_xx: f64,
    inertia_link_6_yy: f64,
    inertia_link_6_zz: f64,
    minus_inertia_link_7_hx: f64,
    minus_inertia_link_7_hy: f64,
    inertia_link_7_hz: f64,
    minus_inertia_link_7_xy: f64,
    inertia_link_7_xz: f64,
    inertia_link_7_yz: f64,
    inertia_link_7_xx: f64,
    inertia_link_7_yy: f64,
    inertia_link_7_zz: f64,
    minus_composite_link_6_hx: f64,
    minus_composite_link_6_hy: f64,
    composite_link_6_hz: f64,
    composite_link_6_xx: f64,
    minus_composite_link_6_xy: f64,
    composite_link_6_xz: f64,
    composite_link_6_yy: f64,
    composite_link_6_yz: f64,
    composite_link_6_zz: f64,
    minus_composite_link_5_hx: f64,
    composite_link_5_hy: f64,
    composite_link_5_hz: f64,
    composite_link_5_xx: f64,
    composite_link_5_xy: f64,
    composite_link_5_xz: f64,
    composite_link_5_yy: f64,
    composite_link_5_yz: f64,
    composite_link_5_zz: f64,
    minus_composite_link_4_hx: f64,
    composite_link_4_hy: f64,
    composite_link_4_hz: f64,
    composite_link_4_xx: f64,
    composite_link_4_xy: f64,
    composite_link_4_xz: f64,
    composite_link_4_yy: f64,
    composite_link_4_yz: f64,
    composite_link_4_zz: f64,
    composite_link_3_hx: f64,
    composite_link_3_hy: f64,
    composite_link_3_hz: f64,
    composite_link_3_xx: f64,
    composite_link_3_xy: f64,
    composite_link_3_xz: f64,
    composite_link_3_yy: f64,
    composite_link_3_yz: f64,
    composite_link_3_zz: f64,
    composite_link_2_hx: f64,
    composite_link_2_hy: f64,
    composite_link_2_hz: f64,
    composite_link_2_xx: f64,
    composite_link_2_xy: f64,
    composite_link_2_xz: f64,
    composite_link_2_yy: f64,
    composite_link_2_yz: f64,
    composite_link_2_zz: f64,
    composite_link_1_hx: f64,
    composite_link_1_hy: f64,
    composite_link_1_hz: f64,
    composite_link_1_xx: f64,
    composite_link_1_xy: f64,
    composite_link_1_xz: f64,
    composite_link_1_yy: f64,
    composite_link_1_yz: f64,
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
    inside_joint_2_my_0_0: f64,
    inside_joint_2_mz_0_0: f64,
    inside_joint_2_mz_0_1: f64,
    inside_joint_3_mx_0_1_1: f64,
    inside_joint_3_mx_0_0: f64,
    inside_joint_3_my_0_1_0: f64,
    inside_joint_3_my_0_0: f64,
    inside_joint_3_mz_0_1_0: f64,
    inside_joint_3_mz_0_1_1: f64,
    inside_joint_4_mx_0_0_0: f64,
    inside_joint_4_mx_0_1: f64,
    inside_joint_4_my_0_0_1: f64,
    inside_joint_4_my_0_1: f64,
    inside_joint_4_mz_0_0_1: f64,
    inside_joint_4_mz_0_0_0: f64,
    inside_joint_5_mx_0_1_1: f64,
    inside_joint_5_mx_0_0: f64,
    inside_joint_5_my_0_1_0: f64,
    inside_joint_5_my_0_0: f64,
    inside_joint_5_mz_0_1_0: f64,
    inside_joint_5_mz_0_1_1: f64,
    inside_joint_6_mx_0_0_1: f64,
    inside_joint_6_mx_0_1: f64,
    inside_joint_6_my_0_1_0: f64,
    inside_joint_6_my_0_0: f64,
    inside_joint_6_mz_0_0_0: f64,
    inside_joint_6_mz_0_0_1: f64,
    inside_joint_7_mx_0_0_0: f64,
    inside_joint_7_mx_0_1: f64,
    inside_joint_7_my_0_0_0: f64,
    inside_joint_7_my_0_1: f64,
    inside_joint_7_mz_0_1_0: f64,
    inside_joint_7_mz_0_1_1: f64,
}
/// Inertias of the bodies and of their subtrees, centroidal frame.
#[inline(never)]
fn inertias(poses: &Poses) -> Inertias {
    // base
    let minus_inertia_base_hx = poses.minus_origin_base_x * 3.5;
    let minus_inertia_base_hy = poses.minus_origin_base_y * 3.5;
    let minus_inertia_base_hz = poses.minus_origin_base_z * 3.5;
    let inertia_base_yy_1 = minus_inertia_base_hx * poses.minus_origin_base_x;
    let inertia_base_xx_1 = minus_inertia_base_hy * poses.minus_origin_base_y;
    let inertia_base_xx_2 = minus_inertia_base_hz * poses.minus_origin_base_z;
    let minus_inertia_base_xy = minus_inertia_base_hx * poses.minus_origin_base_y;
    let minus_inertia_base_xz = minus_inertia_base_hx * poses.minus_origin_base_z;
    let minus_inertia_base_yz = minus_inertia_base_hy * poses.minus_origin_base_z;
    let inertia_base_zz_1 = inertia_base_yy_1 + inertia_base_xx_1;
    let inertia_base_xx = 0.12 + (inertia_base_xx_1 + inertia_base_xx_2);
    let inertia_base_yy = 0.14 + (inertia_base_yy_1 + inertia_base_xx_2);
    let inertia_base_zz = 0.12 + inertia_base_zz_1;
    let inertia_link_1_xx_0 = 0.0106666667 * poses.cos_joint_1;
    let inertia_link_1_xx_2_0 = 0.008866666700000001 * poses.sin_joint_1;
    let inertia_link_1_xx_2 = inertia_link_1_xx_2_0 * poses.sin_joint_1;
    let inertia_link_1_xy_2 = inertia_link_1_xx_2_0 * poses.cos_joint_1;
    let inertia_link_1_yy_3 = 0.008866666700000001 * poses.cos_joint_1
        * poses.cos_joint_1;
    let minus_inertia_link_1_hx_0 = poses.minus_origin_base_x_1_4
        + poses.minus_origin_base_x_1;
    let inertia_link_1_hy_0 = poses.minus_origin_base_y_1_0
        - poses.minus_origin_base_y_1;
    let inertia_link_1_hz_0 = poses.minus_origin_base_z_1_0
        - poses.minus_origin_base_z_1;
    // link_1
    let minus_inertia_link_1_hx = minus_inertia_link_1_hx_0 * 2.0;
    let inertia_link_1_hy = inertia_link_1_hy_0 * 2.0;
    let inertia_link_1_hz = inertia_link_1_hz_0 * 2.0;
    let inertia_link_1_yy_5 = minus_inertia_link_1_hx * minus_inertia_link_1_hx_0;
    let inertia_link_1_xx_4 = inertia_link_1_hy * inertia_link_1_hy_0;
    let inertia_link_1_xx_5 = inertia_link_1_hz * inertia_link_1_hz_0;
    let inertia_link_1_xz = minus_inertia_link_1_hx * inertia_link_1_hz_0;
    let minus_inertia_link_1_yz = inertia_link_1_hy * inertia_link_1_hz_0;
    let inertia_link_1_xx = inertia_link_1_xx_0 * poses.cos_joint_1 + inertia_link_1_xx_2
        + 0.003 + (inertia_link_1_xx_4 + inertia_link_1_xx_5);
    let inertia_link_1_xy = inertia_link_1_xx_0 * poses.sin_joint_1 - inertia_link_1_xy_2
        + minus_inertia_link_1_hx * inertia_link_1_hy_0;
    let inertia_link_1_yy = 0.0106666667 * poses.sin_joint_1 * poses.sin_joint_1
        + inertia_link_1_yy_3 + 0.003 + (inertia_link_1_yy_5 + inertia_link_1_xx_5);
    let inertia_link_1_zz = 0.003 + (inertia_link_1_yy_5 + inertia_link_1_xx_4);
    let inertia_link_2_xx_0 = 0.0106666667 * poses.rotation_link_2_xx;
    let inertia_link_2_yy_0 = 0.0106666667 * poses.rotation_link_2_yx;
    let inertia_link_2_hx_0 = poses.minus_origin_base_x_1_0
        - poses.minus_origin_base_x_1;
    let minus_inertia_link_2_hy_0 = poses.minus_origin_base_y_1_4
        + poses.minus_origin_base_y_1;
    let inertia_link_2_hz_0 = poses.minus_origin_base_z_1_4
        - poses.minus_origin_base_z_1;
    // link_2
    let inertia_link_2_hx = inertia_link_2_hx_0 * 2.0;
    let minus_inertia_link_2_hy = minus_inertia_link_2_hy_0 * 2.0;
    let inertia_link_2_hz = inertia_link_2_hz_0 * 2.0;
    let inertia_link_2_yy_4 = inertia_link_2_hx * inertia_link_2_hx_0;
    let inertia_link_2_xx_4 = minus_inertia_link_2_hy * minus_inertia_link_2_hy_0;
    let inertia_link_2_xx_5 = inertia_link_2_hz * inertia_link_2_hz_0;
    let inertia_link_2_xx = inertia_link_2_xx_0 * poses.rotation_link_2_xx
        + inertia_link_1_xx_2 + 0.003 + (inertia_link_2_xx_4 + inertia_link_2_xx_5);
    let inertia_link_2_xy = inertia_link_2_xx_0 * poses.rotation_link_2_yx
        - inertia_link_1_xy_2 + inertia_link_2_hx * minus_inertia_link_2_hy_0;
    let inertia_link_2_xz = inertia_link_2_xx_0 * poses.sin_joint_2
        - inertia_link_2_hx * inertia_link_2_hz_0;
    let inertia_link_2_yy = inertia_link_2_yy_0 * poses.rotation_link_2_yx
        + inertia_link_1_yy_3 + 0.003 + (inertia_link_2_yy_4 + inertia_link_2_xx_5);
    let inertia_link_2_yz = inertia_link_2_yy_0 * poses.sin_joint_2
        + minus_inertia_link_2_hy * inertia_link_2_hz_0;
    let inertia_link_2_zz = 0.0106666667 * poses.sin_joint_2 * poses.sin_joint_2 + 0.003
        + (inertia_link_2_yy_4 + inertia_link_2_xx_4);
    let inertia_link_3_xx_0 = 0.0106666667 * poses.rotation_link_3_xx;
    let inertia_link_3_xx_2_0 = 0.008866666700000001 * poses.minus_rotation_link_3_xy;
    let inertia_link_3_yy_0 = 0.0106666667 * poses.rotation_link_3_yx;
    let inertia_link_3_yy_2_0 = 0.008866666700000001 * poses.rotation_link_3_yy;
    let inertia_link_3_xx_2 = inertia_link_3_xx_2_0 * poses.minus_rotation_link_3_xy;
    let inertia_link_3_xy_2 = inertia_link_3_xx_2_0 * poses.rotation_link_3_yy;
    let inertia_link_3_xz_2 = inertia_link_3_xx_2_0 * poses.minus_rotation_link_3_zy;
    let inertia_link_3_yy_2 = inertia_link_3_yy_2_0 * poses.rotation_link_3_yy;
    let inertia_link_3_yz_2 = inertia_link_3_yy_2_0 * poses.minus_rotation_link_3_zy;
    let inertia_link_3_zz_3 = 0.008866666700000001 * poses.minus_rotation_link_3_zy
        * poses.minus_rotation_link_3_zy;
    let inertia_link_3_hx_0 = poses.minus_origin_base_x_1_6
        - poses.minus_origin_base_x_1;
    let minus_inertia_link_3_hy_0 = poses.minus_origin_base_y_1_6
        + poses.minus_origin_base_y_1;
    let inertia_link_3_hz_0 = poses.minus_origin_base_z_1_6
        - poses.minus_origin_base_z_1;
    // link_3
    let inertia_link_3_hx = inertia_link_3_hx_0 * 2.0;
    let minus_inertia_link_3_hy = minus_inertia_link_3_hy_0 * 2.0;
    let inertia_link_3_hz = inertia_link_3_hz_0 * 2.0;
    let inertia_link_3_yy_4 = inertia_link_3_hx * inertia_link_3_hx_0;
    let inertia_link_3_xx_4 = minus_inertia_link_3_hy * minus_inertia_link_3_hy_0;
    let inertia_link_3_xx_5 = inertia_link_3_hz * inertia_link_3_hz_0;
    let inertia_link_3_xx = inertia_link_3_xx_0 * poses.rotation_link_3_xx
        + inertia_link_3_xx_2 + 0.003 + (inertia_link_3_xx_4 + inertia_link_3_xx_5);
    let inertia_link_3_xy = inertia_link_3_xx_0 * poses.rotation_link_3_yx
        - inertia_link_3_xy_2 + inertia_link_3_hx * minus_inertia_link_3_hy_0;
    let inertia_link_3_xz = inertia_link_3_xx_0 * poses.rotation_link_3_zx
        + inertia_link_3_xz_2 - inertia_link_3_hx * inertia_link_3_hz_0;
    let inertia_link_3_yy = inertia_link_3_yy_0 * poses.rotation_link_3_yx
        + inertia_link_3_yy_2 + 0.003 + (inertia_link_3_yy_4 + inertia_link_3_xx_5);
    let inertia_link_3_yz = inertia_link_3_yy_0 * poses.rotation_link_3_zx
        - inertia_link_3_yz_2 + minus_inertia_link_3_hy * inertia_link_3_hz_0;
    let inertia_link_3_zz = 0.0106666667 * poses.rotation_link_3_zx
        * poses.rotation_link_3_zx + inertia_link_3_zz_3 + 0.003
        + (inertia_link_3_yy_4 + inertia_link_3_xx_4);
    let inertia_link_4_xx_0 = 0.0106666667 * poses.rotation_link_4_xx;
    let inertia_link_4_yy_0 = 0.0106666667 * poses.rotation_link_4_yx;
    let minus_inertia_link_4_hx_0 = poses.minus_origin_base_x_1_8
        + poses.minus_origin_base_x_1;
    let inertia_link_4_hy_0 = poses.minus_origin_base_y_1_8
        - poses.minus_origin_base_y_1;
    let inertia_link_4_hz_0 = poses.minus_origin_base_z_1_8
        - poses.minus_origin_base_z_1;
    // link_4
    let minus_inertia_link_4_hx = minus_inertia_link_4_hx_0 * 2.0;
    let inertia_link_4_hy = inertia_link_4_hy_0 * 2.0;
    let inertia_link_4_hz = inertia_link_4_hz_0 * 2.0;
    let inertia_link_4_yy_4 = minus_inertia_link_4_hx * minus_inertia_link_4_hx_0;
    let inertia_link_4_xx_4 = inertia_link_4_hy * inertia_link_4_hy_0;
    let inertia_link_4_xx_5 = inertia_link_4_hz * inertia_link_4_hz_0;
    let inertia_link_4_xx = inertia_link_4_xx_0 * poses.rotation_link_4_xx
        + inertia_link_3_xx_2 + 0.003 + (inertia_link_4_xx_4 + inertia_link_4_xx_5);
    let inertia_link_4_xy = inertia_link_4_xx_0 * poses.rotation_link_4_yx
        - inertia_link_3_xy_2 + minus_inertia_link_4_hx * inertia_link_4_hy_0;
    let inertia_link_4_xz = inertia_link_4_xx_0 * poses.rotation_link_4_zx
        + inertia_link_3_xz_2 + minus_inertia_link_4_hx * inertia_link_4_hz_0;
    let inertia_link_4_yy = inertia_link_4_yy_0 * poses.rotation_link_4_yx
        + inertia_link_3_yy_2 + 0.003 + (inertia_link_4_yy_4 + inertia_link_4_xx_5);
    let inertia_link_4_yz = inertia_link_4_yy_0 * poses.rotation_link_4_zx
        - inertia_link_3_yz_2 - inertia_link_4_hy * inertia_link_4_hz_0;
    let inertia_link_4_zz = 0.0106666667 * poses.rotation_link_4_zx
        * poses.rotation_link_4_zx + inertia_link_3_zz_3 + 0.003
        + (inertia_link_4_yy_4 + inertia_link_4_xx_4);
    let inertia_link_5_xx_0 = 0.009650666700000001 * poses.rotation_link_5_xx;
    let inertia_link_5_xx_2 = 0.007850666700000002 * poses.rotation_link_6_xz;
    let inertia_link_5_yy_0 = 0.009650666700000001 * poses.rotation_link_5_yx;
    let inertia_link_5_yy_2 = 0.007850666700000002 * poses.rotation_link_5_yy;
    let minus_inertia_link_5_hx_0 = poses.minus_origin_base_x_1_10
        + poses.minus_origin_base_x_1;
    let inertia_link_5_hy_0 = poses.minus_origin_base_y_1_10
        - poses.minus_origin_base_y_1;
    let inertia_link_5_hz_0 = poses.minus_origin_base_z_1_10
        - poses.minus_origin_base_z_1;
    // link_5
    let minus_inertia_link_5_hx = minus_inertia_link_5_hx_0 * 2.0;
    let inertia_link_5_hy = inertia_link_5_hy_0 * 2.0;
    let inertia_link_5_hz = inertia_link_5_hz_0 * 2.0;
    let inertia_link_5_yy_5 = minus_inertia_link_5_hx * minus_inertia_link_5_hx_0;
    let inertia_link_5_xx_5 = inertia_link_5_hy * inertia_link_5_hy_0;
    let inertia_link_5_xx_6 = inertia_link_5_hz * inertia_link_5_hz_0;
    let inertia_link_5_xx = inertia_link_5_xx_0 * poses.rotation_link_5_xx
        + inertia_link_5_xx_2 * poses.rotation_link_6_xz + 0.003
        + (inertia_link_5_xx_5 + inertia_link_5_xx_6);
    let inertia_link_5_xy = inertia_link_5_xx_0 * poses.rotation_link_5_yx
        - inertia_link_5_xx_2 * poses.rotation_link_5_yy
        + minus_inertia_link_5_hx * inertia_link_5_hy_0;
    let inertia_link_5_xz = inertia_link_5_xx_0 * poses.rotation_link_5_zx
        + inertia_link_5_xx_2 * poses.rotation_link_6_zz
        + minus_inertia_link_5_hx * inertia_link_5_hz_0;
    let inertia_link_5_yy = inertia_link_5_yy_0 * poses.rotation_link_5_yx
        + inertia_link_5_yy_2 * poses.rotation_link_5_yy + 0.003
        + (inertia_link_5_yy_5 + inertia_link_5_xx_6);
    let inertia_link_5_yz = inertia_link_5_yy_0 * poses.rotation_link_5_zx
        - inertia_link_5_yy_2 * poses.rotation_link_6_zz
        - inertia_link_5_hy * inertia_link_5_hz_0;
    let inertia_link_5_zz = 0.009650666700000001 * poses.rotation_link_5_zx
        * poses.rotation_link_5_zx
        + 0.007850666700000002 * poses.rotation_link_6_zz * poses.rotation_link_6_zz
        + 0.003 + (inertia_link_5_yy_5 + inertia_link_5_xx_5);
    // link_6
    let minus_inertia_link_6_hx = poses.minus_origin_link_6_x * 2.0;
    let minus_inertia_link_6_hy = poses.minus_origin_link_6_y * 2.0;
    let inertia_link_6_hz = poses.origin_link_6_z * 2.0;
    let inertia_link_6_yy_1 = minus_inertia_link_6_hx * poses.minus_origin_link_6_x;
    let inertia_link_6_xx_1 = minus_inertia_link_6_hy * poses.minus_origin_link_6_y;
    let inertia_link_6_xx_2 = inertia_link_6_hz * poses.origin_link_6_z;
    let minus_inertia_link_6_xy = minus_inertia_link_6_hx * poses.minus_origin_link_6_y;
    let inertia_link_6_xz = minus_inertia_link_6_hx * poses.origin_link_6_z;
    let inertia_link_6_yz = minus_inertia_link_6_hy * poses.origin_link_6_z;
    let inertia_link_6_xx = 0.0052083333 + (inertia_link_6_xx_1 + inertia_link_6_xx_2);
    let inertia_link_6_yy = 0.0052083333 + (inertia_link_6_yy_1 + inertia_link_6_xx_2);
    let inertia_link_6_zz = 0.0052083333 + (inertia_link_6_yy_1 + inertia_link_6_xx_1);
    // link_7
    let minus_inertia_link_7_hx = poses.minus_origin_link_7_x * 2.0;
    let minus_inertia_link_7_hy = poses.minus_origin_link_7_y * 2.0;
    let inertia_link_7_hz = poses.origin_link_7_z * 2.0;
    let inertia_link_7_yy_1 = minus_inertia_link_7_hx * poses.minus_origin_link_7_x;
    let inertia_link_7_xx_1 = minus_inertia_link_7_hy * poses.minus_origin_link_7_y;
    let inertia_link_7_xx_2 = inertia_link_7_hz * poses.origin_link_7_z;
    let minus_inertia_link_7_xy = minus_inertia_link_7_hx * poses.minus_origin_link_7_y;
    let inertia_link_7_xz = minus_inertia_link_7_hx * poses.origin_link_7_z;
    let inertia_link_7_yz = minus_inertia_link_7_hy * poses.origin_link_7_z;
    let inertia_link_7_xx = 0.0008333333 + (inertia_link_7_xx_1 + inertia_link_7_xx_2);
    let inertia_link_7_yy = 0.0008333333 + (inertia_link_7_yy_1 + inertia_link_7_xx_2);
    let inertia_link_7_zz = 0.0008333333 + (inertia_link_7_yy_1 + inertia_link_7_xx_1);
    // link_6
    let minus_composite_link_6_hx = minus_inertia_link_6_hx + minus_inertia_link_7_hx;
    let minus_composite_link_6_hy = minus_inertia_link_6_hy + minus_inertia_link_7_hy;
    let composite_link_6_hz = inertia_link_6_hz + inertia_link_7_hz;
    let composite_link_6_xx = inertia_link_6_xx + inertia_link_7_xx;
    let minus_composite_link_6_xy = minus_inertia_link_6_xy + minus_inertia_link_7_xy;
    let composite_link_6_xz = inertia_link_6_xz + inertia_link_7_xz;
    let composite_link_6_yy = inertia_link_6_yy + inertia_link_7_yy;
    let composite_link_6_yz = inertia_link_6_yz + inertia_link_7_yz;
    let composite_link_6_zz = inertia_link_6_zz + inertia_link_7_zz;
    // link_5
    let minus_composite_link_5_hx = minus_inertia_link_5_hx + minus_composite_link_6_hx;
    let composite_link_5_hy = inertia_link_5_hy - minus_composite_link_6_hy;
    let composite_link_5_hz = inertia_link_5_hz + composite_link_6_hz;
    let composite_link_5_xx = inertia_link_5_xx + composite_link_6_xx;
    let composite_link_5_xy = inertia_link_5_xy - minus_composite_link_6_xy;
    let composite_link_5_xz = inertia_link_5_xz + composite_link_6_xz;
    let composite_link_5_yy = inertia_link_5_yy + composite_link_6_yy;
    let composite_link_5_yz = inertia_link_5_yz + composite_link_6_yz;
    let composite_link_5_zz = inertia_link_5_zz + composite_link_6_zz;
    // link_4
    let minus_composite_link_4_hx = minus_inertia_link_4_hx + minus_composite_link_5_hx;
    let composite_link_4_hy = inertia_link_4_hy + composite_link_5_hy;
    let composite_link_4_hz = inertia_link_4_hz + composite_link_5_hz;
    let composite_link_4_xx = inertia_link_4_xx + composite_link_5_xx;
    let composite_link_4_xy = inertia_link_4_xy + composite_link_5_xy;
    let composite_link_4_xz = inertia_link_4_xz + composite_link_5_xz;
    let composite_link_4_yy = inertia_link_4_yy + composite_link_5_yy;
    let composite_link_4_yz = inertia_link_4_yz + composite_link_5_yz;
    let composite_link_4_zz = inertia_link_4_zz + composite_link_5_zz;
    // link_3
    let composite_link_3_hx = inertia_link_3_hx - minus_composite_link_4_hx;
    let composite_link_3_hy = composite_link_4_hy - minus_inertia_link_3_hy;
    let composite_link_3_hz = inertia_link_3_hz + composite_link_4_hz;
    let composite_link_3_xx = inertia_link_3_xx + composite_link_4_xx;
    let composite_link_3_xy = inertia_link_3_xy + composite_link_4_xy;
    let composite_link_3_xz = inertia_link_3_xz + composite_link_4_xz;
    let composite_link_3_yy = inertia_link_3_yy + composite_link_4_yy;
    let composite_link_3_yz = inertia_link_3_yz + composite_link_4_yz;
    let composite_link_3_zz = inertia_link_3_zz + composite_link_4_zz;
    // link_2
    let composite_link_2_hx = inertia_link_2_hx + composite_link_3_hx;
    let composite_link_2_hy = composite_link_3_hy - minus_inertia_link_2_hy;
    let composite_link_2_hz = inertia_link_2_hz + composite_link_3_hz;
    let composite_link_2_xx = inertia_link_2_xx + composite_link_3_xx;
    let composite_link_2_xy = inertia_link_2_xy + composite_link_3_xy;
    let composite_link_2_xz = inertia_link_2_xz + composite_link_3_xz;
    let composite_link_2_yy = inertia_link_2_yy + composite_link_3_yy;
    let composite_link_2_yz = inertia_link_2_yz + composite_link_3_yz;
    let composite_link_2_zz = inertia_link_2_zz + composite_link_3_zz;
    // link_1
    let composite_link_1_hx = composite_link_2_hx - minus_inertia_link_1_hx;
    let composite_link_1_hy = inertia_link_1_hy + composite_link_2_hy;
    let composite_link_1_hz = inertia_link_1_hz + composite_link_2_hz;
    let composite_link_1_xx = inertia_link_1_xx + composite_link_2_xx;
    let composite_link_1_xy = inertia_link_1_xy + composite_link_2_xy;
    let composite_link_1_xz = inertia_link_1_xz + composite_link_2_xz;
    let composite_link_1_yy = inertia_link_1_yy + composite_link_2_yy;
    let composite_link_1_yz = composite_link_2_yz - minus_inertia_link_1_yz;
    let composite_link_1_zz = inertia_link_1_zz + composite_link_2_zz;
    // base
    let composite_base_xx = inertia_base_xx + composite_link_1_xx;
    let composite_base_xy = composite_link_1_xy - minus_inertia_base_xy;
    let composite_base_xz = composite_link_1_xz - minus_inertia_base_xz;
    let composite_base_yy = inertia_base_yy + composite_link_1_yy;
    let composite_base_yz = composite_link_1_yz - minus_inertia_base_yz;
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
    let inside_joint_1_mz_1_1 = composite_link_1_hy * poses.minus_origin_base_y;
    let inside_joint_2_mx_0_1 = composite_link_2_xy * poses.cos_joint_1;
    let inside_joint_2_my_0_0 = composite_link_2_xy * poses.sin_joint_1;
    let inside_joint_2_mz_0_0 = composite_link_2_xz * poses.sin_joint_1;
    let inside_joint_2_mz_0_1 = composite_link_2_yz * poses.cos_joint_1;
    let inside_joint_3_mx_0_1_1 = composite_link_3_xy * poses.minus_rotation_link_2_yy;
    let inside_joint_3_mx_0_0 = composite_link_3_xz * poses.cos_joint_2;
    let inside_joint_3_my_0_1_0 = composite_link_3_xy * poses.minus_rotation_link_2_xy;
    let inside_joint_3_my_0_0 = composite_link_3_yz * poses.cos_joint_2;
    let inside_joint_3_mz_0_1_0 = composite_link_3_xz * poses.minus_rotation_link_2_xy;
    let inside_joint_3_mz_0_1_1 = composite_link_3_yz * poses.minus_rotation_link_2_yy;
    let inside_joint_4_mx_0_0_0 = composite_link_4_xy * poses.rotation_link_3_yy;
    let inside_joint_4_mx_0_1 = composite_link_4_xz * poses.minus_rotation_link_3_zy;
    let inside_joint_4_my_0_0_1 = composite_link_4_xy * poses.minus_rotation_link_3_xy;
    let inside_joint_4_my_0_1 = composite_link_4_yz * poses.minus_rotation_link_3_zy;
    let inside_joint_4_mz_0_0_1 = composite_link_4_xz * poses.minus_rotation_link_3_xy;
    let inside_joint_4_mz_0_0_0 = composite_link_4_yz * poses.rotation_link_3_yy;
    let inside_joint_5_mx_0_1_1 = composite_link_5_xy * poses.rotation_link_4_yy;
    let inside_joint_5_mx_0_0 = composite_link_5_xz * poses.rotation_link_5_zz;
    let inside_joint_5_my_0_1_0 = composite_link_5_xy * poses.rotation_link_4_xy;
    let inside_joint_5_my_0_0 = composite_link_5_yz * poses.rotation_link_5_zz;
    let inside_joint_5_mz_0_1_0 = composite_link_5_xz * poses.rotation_link_4_xy;
    let inside_joint_5_mz_0_1_1 = composite_link_5_yz * poses.rotation_link_4_yy;
    let inside_joint_6_mx_0_0_1 = minus_composite_link_6_xy * poses.rotation_link_5_yy;
    let inside_joint_6_mx_0_1 = composite_link_6_xz * poses.rotation_link_6_zz;
    let inside_joint_6_my_0_1_0 = minus_composite_link_6_xy * poses.rotation_link_6_xz;
    let inside_joint_6_my_0_0 = composite_link_6_yz * poses.rotation_link_6_zz;
    let inside_joint_6_mz_0_0_0 = composite_link_6_xz * poses.rotation_link_6_xz;
    let inside_joint_6_mz_0_0_1 = composite_link_6_yz * poses.rotation_link_5_yy;
    let inside_joint_7_mx_0_0_0 = minus_inertia_link_7_xy
        * poses.minus_rotation_link_6_yy;
    let inside_joint_7_mx_0_1 = inertia_link_7_xz * poses.rotation_link_6_zy;
    let inside_joint_7_my_0_0_0 = minus_inertia_link_7_xy
        * poses.minus_rotation_link_6_xy;
    let inside_joint_7_my_0_1 = inertia_link_7_yz * poses.rotation_link_6_zy;
    let inside_joint_7_mz_0_1_0 = inertia_link_7_xz * poses.minus_rotation_link_6_xy;
    let inside_joint_7_mz_0_1_1 = inertia_link_7_yz * poses.minus_rotation_link_6_yy;
    Inertias {
        minus_inertia_base_hx,
        minus_inertia_base_hy,
        minus_inertia_base_hz,
        inertia_base_yy_1,
        inertia_base_xx_1,
        minus_inertia_base_xy,
        minus_inertia_base_xz,
        minus_inertia_base_yz,
        inertia_base_zz_1,
        inertia_base_xx,
        inertia_base_yy,
        inertia_base_zz,
        minus_inertia_link_1_hx,
        inertia_link_1_hy,
        inertia_link_1_hz,
        inertia_link_1_xz,
        minus_inertia_link_1_yz,
        inertia_link_1_xx,
        inertia_link_1_xy,
        inertia_link_1_yy,
        inertia_link_1_zz,
        inertia_link_2_hx,
        minus_inertia_link_2_hy,
        inertia_link_2_hz,
        inertia_link_2_xx,
        inertia_link_2_xy,
        inertia_link_2_xz,
        inertia_link_2_yy,
        inertia_link_2_yz,
        inertia_link_2_zz,
        inertia_link_3_hx,
        minus_inertia_link_3_hy,
        inertia_link_3_hz,
        inertia_link_3_xx,
        inertia_link_3_xy,
        inertia_link_3_xz,
        inertia_link_3_yy,
        inertia_link_3_yz,
        inertia_link_3_zz,
        minus_inertia_link_4_hx,
        inertia_link_4_hy,
        inertia_link_4_hz,
        inertia_link_4_xx,
        inertia_link_4_xy,
        inertia_link_4_xz,
        inertia_link_4_yy,
        inertia_link_4_yz,
        inertia_link_4_zz,
        minus_inertia_link_5_hx,
        inertia_link_5_hy,
        inertia_link_5_hz,
        inertia_link_5_xx,
        inertia_link_5_xy,
        inertia_link_5_xz,
        inertia_link_5_yy,
        inertia_link_5_yz,
        inertia_link_5_zz,
        minus_inertia_link_6_hx,
        minus_inertia_link_6_hy,
        inertia_link_6_hz,
        minus_inertia_link_6_xy,
        inertia_link_6_xz,
        inertia_link_6_yz,
        inertia_link_6_xx,
        inertia_link_6_yy,
        inertia_link_6_zz,
        minus_inertia_link_7_hx,
        minus_inertia_link_7_hy,
        inertia_link_7_hz,
        minus_inertia_link_7_xy,
        inertia_link_7_xz,
        inertia_link_7_yz,
        inertia_link_7_xx,
        inertia_link_7_yy,
        inertia_link_7_zz,
        minus_composite_link_6_hx,
        minus_composite_link_6_hy,
        composite_link_6_hz,
        composite_link_6_xx,
        minus_composite_link_6_xy,
        composite_link_6_xz,
        composite_link_6_yy,
        composite_link_6_yz,
        composite_link_6_zz,
        minus_composite_link_5_hx,
        composite_link_5_hy,
        composite_link_5_hz,
        composite_link_5_xx,
        composite_link_5_xy,
        composite_link_5_xz,
        composite_link_5_yy,
        composite_link_5_yz,
        composite_link_5_zz,
        minus_composite_link_4_hx,
        composite_link_4_hy,
        composite_link_4_hz,
        composite_link_4_xx,
        composite_link_4_xy,
        composite_link_4_xz,
        composite_link_4_yy,
        composite_link_4_yz,
        composite_link_4_zz,
        composite_link_3_hx,
        composite_link_3_hy,
        composite_link_3_hz,
        composite_link_3_xx,
        composite_link_3_xy,
        composite_link_3_xz,
        composite_link_3_yy,
        composite_link_3_yz,
        composite_link_3_zz,
        composite_link_2_hx,
        composite_link_2_hy,
        composite_link_2_hz,
        composite_link_2_xx,
        composite_link_2_xy,
        composite_link_2_xz,
        composite_link_2_yy,
        composite_link_2_yz,
        composite_link_2_zz,
        composite_link_1_hx,
        composite_link_1_hy,
        composite_link_1_hz,
        composite_link_1_xx,
        composite_link_1_xy,
        composite_link_1_xz,
        composite_link_1_yy,
        composite_link_1_yz,
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
        inside_joint_2_my_0_0,
        inside_joint_2_mz_0_0,
        inside_joint_2_mz_0_1,
        inside_joint_3_mx_0_1_1,
        inside_joint_3_mx_0_0,
        inside_joint_3_my_0_1_0,
        inside_joint_3_my_0_0,
        inside_joint_3_mz_0_1_0,
        inside_joint_3_mz_0_1_1,
        inside_joint_4_mx_0_0_0,
        inside_joint_4_mx_0_1,
        inside_joint_4_my_0_0_1,
        inside_joint_4_my_0_1,
        inside_joint_4_mz_0_0_1,
        inside_joint_4_mz_0_0_0,
        inside_joint_5_mx_0_1_1,
        inside_joint_5_mx_0_0,
        inside_joint_5_my_0_1_0,
        inside_joint_5_my_0_0,
        inside_joint_5_mz_0_1_0,
        inside_joint_5_mz_0_1_1,
        inside_joint_6_mx_0_0_1,
        inside_joint_6_mx_0_1,
        inside_joint_6_my_0_1_0,
        inside_joint_6_my_0_0,
        inside_joint_6_mz_0_0_0,
        inside_joint_6_mz_0_0_1,
        inside_joint_7_mx_0_0_0,
        inside_joint_7_mx_0_1,
        inside_joint_7_my_0_0_0,
        inside_joint_7_my_0_1,
        inside_joint_7_mz_0_1_0,
        inside_joint_7_mz_0_1_1,
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
    minus_complement_link_2_yz: f64,
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
    complement_link_4_hx: f64,
    complement_link_4_hy: f64,
    complement_link_4_hz: f64,
    complement_link_4_xx: f64,
    complement_link_4_xy: f64,
    complement_link_4_xz: f64,
    complement_link_4_yy: f64,
    complement_link_4_yz: f64,
    complement_link_4_zz: f64,
    complement_link_5_hx: f64,
    complement_link_5_hy: f64,
    complement_link_5_hz: f64,
    complement_link_5_xx: f64,
    complement_link_5_xy: f64,
    complement_link_5_xz: f64,
    complement_link_5_yy: f64,
    complement_link_5_yz: f64,
    complement_link_5_zz: f64,
    complement_link_6_hx: f64,
    complement_link_6_hy: f64,
    complement_link_6_hz: f64,
    complement_link_6_xx: f64,
    complement_link_6_xy: f64,
    complement_link_6_xz: f64,
    complement_link_6_yy: f64,
    complement_link_6_yz: f64,
    complement_link_6_zz: f64,
    complement_link_7_hx: f64,
    complement_link_7_hy: f64,
    complement_link_7_hz: f64,
    complement_link_7_xx: f64,
    complement_link_7_xy: f64,
    complement_link_7_xz: f64,
    complement_link_7_yy: f64,
    complement_link_7_yz: f64,
    complement_link_7_zz: f64,
    outside_joint_2_mx_0_1: f64,
    outside_joint_2_my_0_0: f64,
    outside_joint_2_mz_0_0: f64,
    outside_joint_2_mz_0_1: f64,
    outside_joint_3_mx_0_1_1: f64,
    outside_joint_3_mx_0_0: f64,
    outside_joint_3_my_0_1_0: f64,
    outside_joint_3_my_0_0: f64,
    outside_joint_3_mz_0_1_0: f64,
    outside_joint_3_mz_0_1_1: f64,
    outside_joint_4_mx_0_0_0: f64,
    outside_joint_4_mx_0_1: f64,
    outside_joint_4_my_0_0_1: f64,
    outside_joint_4_my_0_1: f64,
    outside_joint_4_mz_0_0_1: f64,
    outside_joint_4_mz_0_0_0: f64,
    outside_joint_5_mx_0_1_1: f64,
    outside_joint_5_mx_0_0: f64,
    outside_joint_5_my_0_1_0: f64,
    outside_joint_5_my_0_0: f64,
    outside_joint_5_mz_0_1_0: f64,
    outside_joint_5_mz_0_1_1: f64,
    outside_joint_6_mx_0_0_1: f64,
    outside_joint_6_mx_0_1: f64,
    outside_joint_6_my_0_0_0: f64,
    outside_joint_6_my_0_1: f64,
    outside_joint_6_mz_0_0_0: f64,
    outside_joint_6_mz_0_0_1: f64,
}
/// Inertias of what is outside each subtree, centroidal frame.
#[inline(never)]
fn complements(poses: &Poses, inertias: &Inertias) -> Complements {
    // link_2
    let minus_complement_link_2_hx = inertias.minus_inertia_link_1_hx
        + inertias.minus_inertia_base_hx;
    let complement_link_2_hy = inertias.inertia_link_1_hy
        - inertias.minus_inertia_base_hy;
    let complement_link_2_hz = inertias.inertia_link_1_hz
        - inertias.minus_inertia_base_hz;
    let complement_link_2_xx = inertias.inertia_link_1_xx + inertias.inertia_base_xx;
    let complement_link_2_xy = inertias.inertia_link_1_xy
        - inertias.minus_inertia_base_xy;
    let complement_link_2_xz = inertias.inertia_link_1_xz
        - inertias.minus_inertia_base_xz;
    let complement_link_2_yy = inertias.inertia_link_1_yy + inertias.inertia_base_yy;
    let minus_complement_link_2_yz = inertias.minus_inertia_link_1_yz
        + inertias.minus_inertia_base_yz;
    let complement_link_2_zz = inertias.inertia_link_1_zz + inertias.inertia_base_zz;
    // link_3
    let complement_link_3_hx = inertias.inertia_link_2_hx - minus_complement_link_2_hx;
    let complement_link_3_hy = complement_link_2_hy - inertias.minus_inertia_link_2_hy;
    let complement_link_3_hz = inertias.inertia_link_2_hz + complement_link_2_hz;
    let complement_link_3_xx = inertias.inertia_link_2_xx + complement_link_2_xx;
    let complement_link_3_xy = inertias.inertia_link_2_xy + complement_link_2_xy;
    let complement_link_3_xz = inertias.inertia_link_2_xz + complement_link_2_xz;
    let complement_link_3_yy = inertias.inertia_link_2_yy + complement_link_2_yy;
    let complement_link_3_yz = inertias.inertia_link_2_yz - minus_complement_link_2_yz;
    let complement_link_3_zz = inertias.inertia_link_2_zz + complement_link_2_zz;
    // link_4
    let complement_link_4_hx = inertias.inertia_link_3_hx + complement_link_3_hx;
    let complement_link_4_hy = complement_link_3_hy - inertias.minus_inertia_link_3_hy;
    let complement_link_4_hz = inertias.inertia_link_3_hz + complement_link_3_hz;
    let complement_link_4_xx = inertias.inertia_link_3_xx + complement_link_3_xx;
    let complement_link_4_xy = inertias.inertia_link_3_xy + complement_link_3_xy;
    let complement_link_4_xz = inertias.inertia_link_3_xz + complement_link_3_xz;
    let complement_link_4_yy = inertias.inertia_link_3_yy + complement_link_3_yy;
    let complement_link_4_yz = inertias.inertia_link_3_yz + complement_link_3_yz;
    let complement_link_4_zz = inertias.inertia_link_3_zz + complement_link_3_zz;
    // link_5
    let complement_link_5_hx = complement_link_4_hx - inertias.minus_inertia_link_4_hx;
    let complement_link_5_hy = inertias.inertia_link_4_hy + complement_link_4_hy;
    let complement_link_5_hz = inertias.inertia_link_4_hz + complement_link_4_hz;
    let complement_link_5_xx = inertias.inertia_link_4_xx + complement_link_4_xx;
    let complement_link_5_xy = inertias.inertia_link_4_xy + complement_link_4_xy;
    let complement_link_5_xz = inertias.inertia_link_4_xz + complement_link_4_xz;
    let complement_link_5_yy = inertias.inertia_link_4_yy + complement_link_4_yy;
    let complement_link_5_yz = inertias.inertia_link_4_yz + complement_link_4_yz;
    let complement_link_5_zz = inertias.inertia_link_4_zz + complement_link_4_zz;
    // link_6
    let complement_link_6_hx = complement_link_5_hx - inertias.minus_inertia_link_5_hx;
    let complement_link_6_hy = inertias.inertia_link_5_hy + complement_link_5_hy;
    let complement_link_6_hz = inertias.inertia_link_5_hz + complement_link_5_hz;
    let complement_link_6_xx = inertias.inertia_link_5_xx + complement_link_5_xx;
    let complement_link_6_xy = inertias.inertia_link_5_xy + complement_link_5_xy;
    let complement_link_6_xz = inertias.inertia_link_5_xz + complement_link_5_xz;
    let complement_link_6_yy = inertias.inertia_link_5_yy + complement_link_5_yy;
    let complement_link_6_yz = inertias.inertia_link_5_yz + complement_link_5_yz;
    let complement_link_6_zz = inertias.inertia_link_5_zz + complement_link_5_zz;
    // link_7
    let complement_link_7_hx = complement_link_6_hx - inertias.minus_inertia_link_6_hx;
    let complement_link_7_hy = complement_link_6_hy - inertias.minus_inertia_link_6_hy;
    let complement_link_7_hz = inertias.inertia_link_6_hz + complement_link_6_hz;
    let complement_link_7_xx = inertias.inertia_link_6_xx + complement_link_6_xx;
    let complement_link_7_xy = complement_link_6_xy - inertias.minus_inertia_link_6_xy;
    let complement_link_7_xz = inertias.inertia_link_6_xz + complement_link_6_xz;
    let complement_link_7_yy = inertias.inertia_link_6_yy + complement_link_6_yy;
    let complement_link_7_yz = inertias.inertia_link_6_yz + complement_link_6_yz;
    let complement_link_7_zz = inertias.inertia_link_6_zz + complement_link_6_zz;
    let outside_joint_2_mx_0_1 = complement_link_2_xy * poses.cos_joint_1;
    let outside_joint_2_my_0_0 = complement_link_2_xy * poses.sin_joint_1;
    let outside_joint_2_mz_0_0 = complement_link_2_xz * poses.sin_joint_1;
    let outside_joint_2_mz_0_1 = minus_complement_link_2_yz * poses.cos_joint_1;
    let outside_joint_3_mx_0_1_1 = complement_link_3_xy * poses.minus_rotation_link_2_yy;
    let outside_joint_3_mx_0_0 = complement_link_3_xz * poses.cos_joint_2;
    let outside_joint_3_my_0_1_0 = complement_link_3_xy * poses.minus_rotation_link_2_xy;
    let outside_joint_3_my_0_0 = complement_link_3_yz * poses.cos_joint_2;
    let outside_joint_3_mz_0_1_0 = complement_link_3_xz * poses.minus_rotation_link_2_xy;
    let outside_joint_3_mz_0_1_1 = complement_link_3_yz * poses.minus_rotation_link_2_yy;
    let outside_joint_4_mx_0_0_0 = complement_link_4_xy * poses.rotation_link_3_yy;
    let outside_joint_4_mx_0_1 = complement_link_4_xz * poses.minus_rotation_link_3_zy;
    let outside_joint_4_my_0_0_1 = complement_link_4_xy * poses.minus_rotation_link_3_xy;
    let outside_joint_4_my_0_1 = complement_link_4_yz * poses.minus_rotation_link_3_zy;
    let outside_joint_4_mz_0_0_1 = complement_link_4_xz * poses.minus_rotation_link_3_xy;
    let outside_joint_4_mz_0_0_0 = complement_link_4_yz * poses.rotation_link_3_yy;
    let outside_joint_5_mx_0_1_1 = complement_link_5_xy * poses.rotation_link_4_yy;
    let outside_joint_5_mx_0_0 = complement_link_5_xz * poses.rotation_link_5_zz;
    let outside_joint_5_my_0_1_0 = complement_link_5_xy * poses.rotation_link_4_xy;
    let outside_joint_5_my_0_0 = complement_link_5_yz * poses.rotation_link_5_zz;
    let outside_joint_5_mz_0_1_0 = complement_link_5_xz * poses.rotation_link_4_xy;
    let outside_joint_5_mz_0_1_1 = complement_link_5_yz * poses.rotation_link_4_yy;
    let outside_joint_6_mx_0_0_1 = complement_link_6_xy * poses.rotation_link_5_yy;
    let outside_joint_6_mx_0_1 = complement_link_6_xz * poses.rotation_link_6_zz;
    let outside_joint_6_my_0_0_0 = complement_link_6_xy * poses.rotation_link_6_xz;
    let outside_joint_6_my_0_1 = complement_link_6_yz * poses.rotation_link_6_zz;
    let outside_joint_6_mz_0_0_0 = complement_link_6_xz * poses.rotation_link_6_xz;
    let outside_joint_6_mz_0_0_1 = complement_link_6_yz * poses.rotation_link_5_yy;
    Complements {
        minus_complement_link_2_hx,
        complement_link_2_hy,
        complement_link_2_hz,
        complement_link_2_xx,
        complement_link_2_xy,
        complement_link_2_xz,
        complement_link_2_yy,
        minus_complement_link_2_yz,
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
        complement_link_4_hx,
        complement_link_4_hy,
        complement_link_4_hz,
        complement_link_4_xx,
        complement_link_4_xy,
        complement_link_4_xz,
        complement_link_4_yy,
        complement_link_4_yz,
        complement_link_4_zz,
        complement_link_5_hx,
        complement_link_5_hy,
        complement_link_5_hz,
        complement_link_5_xx,
        complement_link_5_xy,
        complement_link_5_xz,
        complement_link_5_yy,
        complement_link_5_yz,
        complement_link_5_zz,
        complement_link_6_hx,
        complement_link_6_hy,
        complement_link_6_hz,
        complement_link_6_xx,
        complement_link_6_xy,
        complement_link_6_xz,
        complement_link_6_yy,
        complement_link_6_yz,
        complement_link_6_zz,
        complement_link_7_hx,
        complement_link_7_hy,
        complement_link_7_hz,
        complement_link_7_xx,
        complement_link_7_xy,
        complement_link_7_xz,
        complement_link_7_yy,
        complement_link_7_yz,
        complement_link_7_zz,
        outside_joint_2_mx_0_1,
        outside_joint_2_my_0_0,
        outside_joint_2_mz_0_0,
        outside_joint_2_mz_0_1,
        outside_joint_3_mx_0_1_1,
        outside_joint_3_mx_0_0,
        outside_joint_3_my_0_1_0,
        outside_joint_3_my_0_0,
        outside_joint_3_mz_0_1_0,
        outside_joint_3_mz_0_1_1,
        outside_joint_4_mx_0_0_0,
        outside_joint_4_mx_0_1,
        outside_joint_4_my_0_0_1,
        outside_joint_4_my_0_1,
        outside_joint_4_mz_0_0_1,
        outside_joint_4_mz_0_0_0,
        outside_joint_5_mx_0_1_1,
        outside_joint_5_mx_0_0,
        outside_joint_5_my_0_1_0,
        outside_joint_5_my_0_0,
        outside_joint_5_mz_0_1_0,
        outside_joint_5_mz_0_1_1,
        outside_joint_6_mx_0_0_1,
        outside_joint_6_mx_0_1,
        outside_joint_6_my_0_0_0,
        outside_joint_6_my_0_1,
        outside_joint_6_mz_0_0_0,
        outside_joint_6_mz_0_0_1,
    }
}
/// Screw axes s_j, their momenta h_j = Iᶜ_j s_j, the connection Λ_c⁻¹ h_j.
struct Screws {
    inside_joint_1_mx: f64,
    inside_joint_1_my: f64,
    minus_inside_joint_1_fx: f64,
    inside_joint_1_fy: f64,
    connection_joint_1_wz: f64,
    connection_joint_1_wy: f64,
    connection_joint_1_wx: f64,
    minus_connection_joint_1_vx: f64,
    connection_joint_1_vy: f64,
    screw_joint_2_vx: f64,
    screw_joint_2_vy: f64,
    screw_joint_2_vz: f64,
    inside_joint_2_mx_3: f64,
    inside_joint_2_mx_4: f64,
    inside_joint_2_my_3: f64,
    inside_joint_2_my_4: f64,
    inside_joint_2_mz_2: f64,
    inside_joint_2_mz_3: f64,
    inside_joint_2_fx: f64,
    inside_joint_2_fy: f64,
    inside_joint_2_fz: f64,
    outside_joint_2_mx_1_0: f64,
    outside_joint_2_mx_1_1: f64,
    outside_joint_2_my_1_0: f64,
    outside_joint_2_my_1_1: f64,
    outside_joint_2_mz_1_0: f64,
    outside_joint_2_mz_1_1: f64,
    connection_joint_2_wz: f64,
    connection_joint_2_wy: f64,
    connection_joint_2_wx: f64,
    connection_joint_2_vx: f64,
    connection_joint_2_vy: f64,
    connection_joint_2_vz: f64,
    screw_joint_3_vx: f64,
    screw_joint_3_vy: f64,
    screw_joint_3_vz: f64,
    inside_joint_3_mx_4: f64,
    inside_joint_3_mx_5: f64,
    inside_joint_3_my_4: f64,
    inside_joint_3_my_5: f64,
    inside_joint_3_mz_4: f64,
    inside_joint_3_mz_5: f64,
    inside_joint_3_fx: f64,
    inside_joint_3_fy: f64,
    inside_joint_3_fz: f64,
    outside_joint_3_mx_1_0: f64,
    outside_joint_3_mx_1_1: f64,
    outside_joint_3_my_1_0: f64,
    outside_joint_3_my_1_1: f64,
    outside_joint_3_mz_1_0: f64,
    outside_joint_3_mz_1_1: f64,
    connection_joint_3_wz: f64,
    connection_joint_3_wy: f64,
    connection_joint_3_wx: f64,
    connection_joint_3_vx: f64,
    connection_joint_3_vy: f64,
    connection_joint_3_vz: f64,
    screw_joint_4_vx: f64,
    minus_screw_joint_4_vy: f64,
    minus_screw_joint_4_vz: f64,
    inside_joint_4_mx_5: f64,
    inside_joint_4_mx_4: f64,
    inside_joint_4_my_4: f64,
    inside_joint_4_my_5: f64,
    inside_joint_4_mz_4: f64,
    inside_joint_4_mz_5: f64,
    inside_joint_4_fx: f64,
    inside_joint_4_fy: f64,
    inside_joint_4_fz: f64,
    outside_joint_4_mx_1_1: f64,
    outside_joint_4_mx_1_0: f64,
    outside_joint_4_my_1_0: f64,
    outside_joint_4_my_1_1: f64,
    outside_joint_4_mz_1_0: f64,
    outside_joint_4_mz_1_1: f64,
    connection_joint_4_wz: f64,
    connection_joint_4_wy: f64,
    connection_joint_4_wx: f64,
    connection_joint_4_vx: f64,
    connection_joint_4_vy: f64,
    connection_joint_4_vz: f64,
    screw_joint_5_vx: f64,
    screw_joint_5_vy: f64,
    screw_joint_5_vz: f64,
    inside_joint_5_mx_4: f64,
    inside_joint_5_mx_5: f64,
    inside_joint_5_my_4: f64,
    inside_joint_5_my_5: f64,
    inside_joint_5_mz_4: f64,
    inside_joint_5_mz_5: f64,
    inside_joint_5_fx: f64,
    inside_joint_5_fy: f64,
    inside_joint_5_fz: f64,
    outside_joint_5_mx_1_0: f64,
    outside_joint_5_mx_1_1: f64,
    outside_joint_5_my_1_0: f64,
    outside_joint_5_my_1_1: f64,
    outside_joint_5_mz_1_0: f64,
    outside_joint_5_mz_1_1: f64,
    connection_joint_5_wz: f64,
    connection_joint_5_wy: f64,
    connection_joint_5_wx: f64,
    connection_joint_5_vx: f64,
    connection_joint_5_vy: f64,
    connection_joint_5_vz: f64,
    screw_joint_6_vx: f64,
    screw_joint_6_vy: f64,
    screw_joint_6_vz: f64,
    inside_joint_6_mx_4: f64,
    inside_joint_6_mx_5: f64,
    inside_joint_6_my_4: f64,
    inside_joint_6_my_5: f64,
    inside_joint_6_mz_5: f64,
    inside_joint_6_mz_4: f64,
    inside_joint_6_fx: f64,
    inside_joint_6_fy: f64,
    inside_joint_6_fz: f64,
    outside_joint_6_mx_1_0: f64,
    outside_joint_6_mx_1_1: f64,
    outside_joint_6_my_1_0: f64,
    outside_joint_6_my_1_1: f64,
    outside_joint_6_mz_1_0: f64,
    outside_joint_6_mz_1_1: f64,
    connection_joint_6_wz: f64,
    connection_joint_6_wy: f64,
    connection_joint_6_wx: f64,
    connection_joint_6_vx: f64,
    connection_joint_6_vy: f64,
    connection_joint_6_vz: f64,
    screw_joint_7_vx: f64,
    screw_joint_7_vy: f64,
    screw_joint_7_vz: f64,
    inside_joint_7_mx_4: f64,
    inside_joint_7_mx_5: f64,
    inside_joint_7_my_4: f64,
    inside_joint_7_my_5: f64,
    inside_joint_7_mz_5: f64,
    inside_joint_7_mz_4: f64,
    inside_joint_7_mx: f64,
    inside_joint_7_my: f64,
    inside_joint_7_mz: f64,
    inside_joint_7_fx: f64,
    inside_joint_7_fy: f64,
    inside_joint_7_fz: f64,
    connection_joint_7_wz: f64,
    connection_joint_7_wy: f64,
    connection_joint_7_wx: f64,
    connection_joint_7_vx: f64,
    connection_joint_7_vy: f64,
    connection_joint_7_vz: f64,
}
/// Screw axes s_j, their momenta h_j = Iᶜ_j s_j, the connection Λ_c⁻¹ h_j.
#[inline(never)]
fn screws(poses: &Poses, inertias: &Inertias, complements: &Complements) -> Screws {
    // joint_1
    let inside_joint_1_mx = inertias.composite_link_1_xz
        - inertias.composite_link_1_hz * poses.minus_origin_base_x;
    let inside_joint_1_my = inertias.composite_link_1_yz
        - inertias.composite_link_1_hz * poses.minus_origin_base_y;
    let inside_joint_1_mz = inertias.composite_link_1_zz
        + (inertias.inside_joint_1_mz_1_0 + inertias.inside_joint_1_mz_1_1);
    let minus_inside_joint_1_fx = poses.minus_origin_base_y * 14.0
        + inertias.composite_link_1_hy;
    let inside_joint_1_fy = poses.minus_origin_base_x * 14.0
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
    let minus_connection_joint_1_vx = minus_inside_joint_1_fx * 0.05714285714285714;
    let connection_joint_1_vy = inside_joint_1_fy * 0.05714285714285714;
    // joint_2
    let screw_joint_2_vx = poses.origin_link_2_z * poses.cos_joint_1;
    let screw_joint_2_vy = poses.origin_link_2_z * poses.sin_joint_1;
    let screw_joint_2_vz = poses.minus_origin_base_x * poses.cos_joint_1
        + poses.minus_origin_base_y * poses.sin_joint_1;
    let inside_joint_2_mx_3 = inertias.composite_link_2_hy * screw_joint_2_vz;
    let inside_joint_2_mx_4 = inertias.composite_link_2_hz * screw_joint_2_vy;
    let inside_joint_2_my_3 = inertias.composite_link_2_hz * screw_joint_2_vx;
    let inside_joint_2_my_4 = inertias.composite_link_2_hx * screw_joint_2_vz;
    let inside_joint_2_mz_2 = inertias.composite_link_2_hx * screw_joint_2_vy;
    let inside_joint_2_mz_3 = inertias.composite_link_2_hy * screw_joint_2_vx;
    let inside_joint_2_mx = inertias.composite_link_2_xx * poses.sin_joint_1
        - inertias.inside_joint_2_mx_0_1 + (inside_joint_2_mx_3 - inside_joint_2_mx_4);
    let inside_joint_2_my = inertias.inside_joint_2_my_0_0
        - inertias.composite_link_2_yy * poses.cos_joint_1
        + (inside_joint_2_my_3 - inside_joint_2_my_4);
    let inside_joint_2_mz = inertias.inside_joint_2_mz_0_0
        - inertias.inside_joint_2_mz_0_1 + (inside_joint_2_mz_2 - inside_joint_2_mz_3);
    let inside_joint_2_fx = screw_joint_2_vx * 12.0
        - poses.cos_joint_1 * inertias.composite_link_2_hz;
    let inside_joint_2_fy = screw_joint_2_vy * 12.0
        - poses.sin_joint_1 * inertias.composite_link_2_hz;
    let inside_joint_2_fz = screw_joint_2_vz * 12.0
        + (poses.sin_joint_1 * inertias.composite_link_2_hy
            + poses.cos_joint_1 * inertias.composite_link_2_hx);
    let outside_joint_2_mx_1_0 = complements.complement_link_2_hy * screw_joint_2_vz;
    let outside_joint_2_mx_1_1 = complements.complement_link_2_hz * screw_joint_2_vy;
    let outside_joint_2_my_1_0 = complements.complement_link_2_hz * screw_joint_2_vx;
    let outside_joint_2_my_1_1 = complements.minus_complement_link_2_hx
        * screw_joint_2_vz;
    let outside_joint_2_mz_1_0 = complements.minus_complement_link_2_hx
        * screw_joint_2_vy;
    let outside_joint_2_mz_1_1 = complements.complement_link_2_hy * screw_joint_2_vx;
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
    let connection_joint_2_vx = inside_joint_2_fx * 0.05714285714285714;
    let connection_joint_2_vy = inside_joint_2_fy * 0.05714285714285714;
    let connection_joint_2_vz = inside_joint_2_fz * 0.05714285714285714;
    // joint_3
    let screw_joint_3_vx = poses.origin_link_3_z * poses.minus_rotation_link_2_yy
        - poses.minus_origin_link_3_y * poses.cos_joint_2;
    let screw_joint_3_vy = poses.minus_origin_link_3_x * poses.cos_joint_2
        - poses.origin_link_3_z * poses.minus_rotation_link_2_xy;
    let screw_joint_3_vz = poses.minus_origin_link_3_x * poses.minus_rotation_link_2_yy
        - poses.minus_origin_link_3_y * poses.minus_rotation_link_2_xy;
    let inside_joint_3_mx_4 = inertias.composite_link_3_hy * screw_joint_3_vz;
    let inside_joint_3_mx_5 = inertias.composite_link_3_hz * screw_joint_3_vy;
    let inside_joint_3_my_4 = inertias.composite_link_3_hz * screw_joint_3_vx;
    let inside_joint_3_my_5 = inertias.composite_link_3_hx * screw_joint_3_vz;
    let inside_joint_3_mz_4 = inertias.composite_link_3_hx * screw_joint_3_vy;
    let inside_joint_3_mz_5 = inertias.composite_link_3_hy * screw_joint_3_vx;
    let inside_joint_3_mx = inertias.inside_joint_3_mx_0_0
        - (inertias.composite_link_3_xx * poses.minus_rotation_link_2_xy
            + inertias.inside_joint_3_mx_0_1_1)
        + (inside_joint_3_mx_4 - inside_joint_3_mx_5);
    let inside_joint_3_my = inertias.inside_joint_3_my_0_0
        - (inertias.inside_joint_3_my_0_1_0
            + inertias.composite_link_3_yy * poses.minus_rotation_link_2_yy)
        + (inside_joint_3_my_4 - inside_joint_3_my_5);
    let inside_joint_3_mz = inertias.composite_link_3_zz * poses.cos_joint_2
        - (inertias.inside_joint_3_mz_0_1_0 + inertias.inside_joint_3_mz_0_1_1)
        + (inside_joint_3_mz_4 - inside_joint_3_mz_5);
    let inside_joint_3_fx = screw_joint_3_vx * 10.0
        - (poses.minus_rotation_link_2_yy * inertias.composite_link_3_hz
            + poses.cos_joint_2 * inertias.composite_link_3_hy);
    let inside_joint_3_fy = screw_joint_3_vy * 10.0
        + (poses.cos_joint_2 * inertias.composite_link_3_hx
            + poses.minus_rotation_link_2_xy * inertias.composite_link_3_hz);
    let inside_joint_3_fz = screw_joint_3_vz * 10.0
        + (poses.minus_rotation_link_2_yy * inertias.composite_link_3_hx
            - poses.minus_rotation_link_2_xy * inertias.composite_link_3_hy);
    let outside_joint_3_mx_1_0 = complements.complement_link_3_hy * screw_joint_3_vz;
    let outside_joint_3_mx_1_1 = complements.complement_link_3_hz * screw_joint_3_vy;
    let outside_joint_3_my_1_0 = complements.complement_link_3_hz * screw_joint_3_vx;
    let outside_joint_3_my_1_1 = complements.complement_link_3_hx * screw_joint_3_vz;
    let outside_joint_3_mz_1_0 = complements.complement_link_3_hx * screw_joint_3_vy;
    let outside_joint_3_mz_1_1 = complements.complement_link_3_hy * screw_joint_3_vx;
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
    let connection_joint_3_vx = inside_joint_3_fx * 0.05714285714285714;
    let connection_joint_3_vy = inside_joint_3_fy * 0.05714285714285714;
    let connection_joint_3_vz = inside_joint_3_fz * 0.05714285714285714;
    // joint_4
    let screw_joint_4_vx = poses.minus_origin_link_4_y * poses.minus_rotation_link_3_zy
        - poses.origin_link_4_z * poses.rotation_link_3_yy;
    let minus_screw_joint_4_vy = poses.origin_link_4_z * poses.minus_rotation_link_3_xy
        + poses.minus_origin_link_4_x * poses.minus_rotation_link_3_zy;
    let minus_screw_joint_4_vz = poses.minus_origin_link_4_x * poses.rotation_link_3_yy
        + poses.minus_origin_link_4_y * poses.minus_rotation_link_3_xy;
    let inside_joint_4_mx_5 = inertias.composite_link_4_hy * minus_screw_joint_4_vz;
    let inside_joint_4_mx_4 = inertias.composite_link_4_hz * minus_screw_joint_4_vy;
    let inside_joint_4_my_4 = inertias.composite_link_4_hz * screw_joint_4_vx;
    let inside_joint_4_my_5 = inertias.minus_composite_link_4_hx
        * minus_screw_joint_4_vz;
    let inside_joint_4_mz_4 = inertias.minus_composite_link_4_hx
        * minus_screw_joint_4_vy;
    let inside_joint_4_mz_5 = inertias.composite_link_4_hy * screw_joint_4_vx;
    let inside_joint_4_mx = inertias.inside_joint_4_mx_0_0_0
        - inertias.composite_link_4_xx * poses.minus_rotation_link_3_xy
        - inertias.inside_joint_4_mx_0_1 + (inside_joint_4_mx_4 - inside_joint_4_mx_5);
    let inside_joint_4_my = inertias.composite_link_4_yy * poses.rotation_link_3_yy
        - inertias.inside_joint_4_my_0_0_1 - inertias.inside_joint_4_my_0_1
        + (inside_joint_4_my_4 - inside_joint_4_my_5);
    let inside_joint_4_mz = inertias.inside_joint_4_mz_0_0_0
        - inertias.inside_joint_4_mz_0_0_1
        - inertias.composite_link_4_zz * poses.minus_rotation_link_3_zy
        + (inside_joint_4_mz_4 - inside_joint_4_mz_5);
    let inside_joint_4_fx = screw_joint_4_vx * 8.0
        + (poses.rotation_link_3_yy * inertias.composite_link_4_hz
            + poses.minus_rotation_link_3_zy * inertias.composite_link_4_hy);
    let inside_joint_4_fy = poses.minus_rotation_link_3_zy
        * inertias.minus_composite_link_4_hx
        + poses.minus_rotation_link_3_xy * inertias.composite_link_4_hz
        - minus_screw_joint_4_vy * 8.0;
    let inside_joint_4_fz = poses.rotation_link_3_yy * inertias.minus_composite_link_4_hx
        - poses.minus_rotation_link_3_xy * inertias.composite_link_4_hy
        - minus_screw_joint_4_vz * 8.0;
    let outside_joint_4_mx_1_1 = complements.complement_link_4_hy
        * minus_screw_joint_4_vz;
    let outside_joint_4_mx_1_0 = complements.complement_link_4_hz
        * minus_screw_joint_4_vy;
    let outside_joint_4_my_1_0 = complements.complement_link_4_hz * screw_joint_4_vx;
    let outside_joint_4_my_1_1 = complements.complement_link_4_hx
        * minus_screw_joint_4_vz;
    let outside_joint_4_mz_1_0 = complements.complement_link_4_hx
        * minus_screw_joint_4_vy;
    let outside_joint_4_mz_1_1 = complements.complement_link_4_hy * screw_joint_4_vx;
    let connection_joint_4_wz_4 = inside_joint_4_my
        - inertias.locked_inverse_pivot_y_2 * inside_joint_4_mx;
    let connection_joint_4_wz = (inside_joint_4_mz
        - inertias.locked_inverse_pivot_z_2 * inside_joint_4_mx
        - inertias.locked_inverse_pivot_z_4 * connection_joint_4_wz_4)
        * inertias.locked_inverse_pivot_z;
    let connection_joint_4_wy = connection_joint_4_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * connection_joint_4_wz;
    let connection_joint_4_wx = inside_joint_4_mx * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * connection_joint_4_wy
        - inertias.locked_inverse_pivot_z_2 * connection_joint_4_wz;
    let connection_joint_4_vx = inside_joint_4_fx * 0.05714285714285714;
    let connection_joint_4_vy = inside_joint_4_fy * 0.05714285714285714;
    let connection_joint_4_vz = inside_joint_4_fz * 0.05714285714285714;
    // joint_5
    let screw_joint_5_vx = poses.origin_link_5_z * poses.rotation_link_4_yy
        - poses.minus_origin_link_5_y * poses.rotation_link_5_zz;
    let screw_joint_5_vy = poses.minus_origin_link_5_x * poses.rotation_link_5_zz
        - poses.origin_link_5_z * poses.rotation_link_4_xy;
    let screw_joint_5_vz = poses.minus_origin_link_5_x * poses.rotation_link_4_yy
        - poses.minus_origin_link_5_y * poses.rotation_link_4_xy;
    let inside_joint_5_mx_4 = inertias.composite_link_5_hy * screw_joint_5_vz;
    let inside_joint_5_mx_5 = inertias.composite_link_5_hz * screw_joint_5_vy;
    let inside_joint_5_my_4 = inertias.composite_link_5_hz * screw_joint_5_vx;
    let inside_joint_5_my_5 = inertias.minus_composite_link_5_hx * screw_joint_5_vz;
    let inside_joint_5_mz_4 = inertias.minus_composite_link_5_hx * screw_joint_5_vy;
    let inside_joint_5_mz_5 = inertias.composite_link_5_hy * screw_joint_5_vx;
    let inside_joint_5_mx = inertias.inside_joint_5_mx_0_0
        - (inertias.composite_link_5_xx * poses.rotation_link_4_xy
            + inertias.inside_joint_5_mx_0_1_1)
        + (inside_joint_5_mx_4 - inside_joint_5_mx_5);
    let inside_joint_5_my = inertias.inside_joint_5_my_0_0
        - (inertias.inside_joint_5_my_0_1_0
            + inertias.composite_link_5_yy * poses.rotation_link_4_yy)
        + (inside_joint_5_my_4 + inside_joint_5_my_5);
    let inside_joint_5_mz = inertias.composite_link_5_zz * poses.rotation_link_5_zz
        - (inertias.inside_joint_5_mz_0_1_0 + inertias.inside_joint_5_mz_0_1_1)
        - (inside_joint_5_mz_4 + inside_joint_5_mz_5);
    let inside_joint_5_fx = screw_joint_5_vx * 6.0
        - (poses.rotation_link_4_yy * inertias.composite_link_5_hz
            + poses.rotation_link_5_zz * inertias.composite_link_5_hy);
    let inside_joint_5_fy = screw_joint_5_vy * 6.0
        + (poses.rotation_link_4_xy * inertias.composite_link_5_hz
            - poses.rotation_link_5_zz * inertias.minus_composite_link_5_hx);
    let inside_joint_5_fz = screw_joint_5_vz * 6.0
        - (poses.rotation_link_4_xy * inertias.composite_link_5_hy
            + poses.rotation_link_4_yy * inertias.minus_composite_link_5_hx);
    let outside_joint_5_mx_1_0 = complements.complement_link_5_hy * screw_joint_5_vz;
    let outside_joint_5_mx_1_1 = complements.complement_link_5_hz * screw_joint_5_vy;
    let outside_joint_5_my_1_0 = complements.complement_link_5_hz * screw_joint_5_vx;
    let outside_joint_5_my_1_1 = complements.complement_link_5_hx * screw_joint_5_vz;
    let outside_joint_5_mz_1_0 = complements.complement_link_5_hx * screw_joint_5_vy;
    let outside_joint_5_mz_1_1 = complements.complement_link_5_hy * screw_joint_5_vx;
    let connection_joint_5_wz_4 = inside_joint_5_my
        - inertias.locked_inverse_pivot_y_2 * inside_joint_5_mx;
    let connection_joint_5_wz = (inside_joint_5_mz
        - inertias.locked_inverse_pivot_z_2 * inside_joint_5_mx
        - inertias.locked_inverse_pivot_z_4 * connection_joint_5_wz_4)
        * inertias.locked_inverse_pivot_z;
    let connection_joint_5_wy = connection_joint_5_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * connection_joint_5_wz;
    let connection_joint_5_wx = inside_joint_5_mx * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * connection_joint_5_wy
        - inertias.locked_inverse_pivot_z_2 * connection_joint_5_wz;
    let connection_joint_5_vx = inside_joint_5_fx * 0.05714285714285714;
    let connection_joint_5_vy = inside_joint_5_fy * 0.05714285714285714;
    let connection_joint_5_vz = inside_joint_5_fz * 0.05714285714285714;
    // joint_6
    let screw_joint_6_vx = poses.origin_link_6_z * poses.rotation_link_5_yy
        - poses.minus_origin_link_6_y * poses.rotation_link_6_zz;
    let screw_joint_6_vy = poses.origin_link_6_z * poses.rotation_link_6_xz
        + poses.minus_origin_link_6_x * poses.rotation_link_6_zz;
    let screw_joint_6_vz = poses.minus_origin_link_6_x * poses.rotation_link_5_yy
        + poses.minus_origin_link_6_y * poses.rotation_link_6_xz;
    let inside_joint_6_mx_4 = inertias.minus_composite_link_6_hy * screw_joint_6_vz;
    let inside_joint_6_mx_5 = inertias.composite_link_6_hz * screw_joint_6_vy;
    let inside_joint_6_my_4 = inertias.composite_link_6_hz * screw_joint_6_vx;
    let inside_joint_6_my_5 = inertias.minus_composite_link_6_hx * screw_joint_6_vz;
    let inside_joint_6_mz_5 = inertias.minus_composite_link_6_hx * screw_joint_6_vy;
    let inside_joint_6_mz_4 = inertias.minus_composite_link_6_hy * screw_joint_6_vx;
    let inside_joint_6_mx = inertias.composite_link_6_xx * poses.rotation_link_6_xz
        + inertias.inside_joint_6_mx_0_0_1 + inertias.inside_joint_6_mx_0_1
        - (inside_joint_6_mx_4 + inside_joint_6_mx_5);
    let inside_joint_6_my = inertias.inside_joint_6_my_0_0
        - (inertias.inside_joint_6_my_0_1_0
            + inertias.composite_link_6_yy * poses.rotation_link_5_yy)
        + (inside_joint_6_my_4 + inside_joint_6_my_5);
    let inside_joint_6_mz = inertias.inside_joint_6_mz_0_0_0
        - inertias.inside_joint_6_mz_0_0_1
        + inertias.composite_link_6_zz * poses.rotation_link_6_zz
        + (inside_joint_6_mz_4 - inside_joint_6_mz_5);
    let inside_joint_6_fx = screw_joint_6_vx * 4.0
        + (poses.rotation_link_6_zz * inertias.minus_composite_link_6_hy
            - poses.rotation_link_5_yy * inertias.composite_link_6_hz);
    let inside_joint_6_fy = screw_joint_6_vy * 4.0
        - (poses.rotation_link_6_zz * inertias.minus_composite_link_6_hx
            + poses.rotation_link_6_xz * inertias.composite_link_6_hz);
    let inside_joint_6_fz = screw_joint_6_vz * 4.0
        - (poses.rotation_link_6_xz * inertias.minus_composite_link_6_hy
            + poses.rotation_link_5_yy * inertias.minus_composite_link_6_hx);
    let outside_joint_6_mx_1_0 = complements.complement_link_6_hy * screw_joint_6_vz;
    let outside_joint_6_mx_1_1 = complements.complement_link_6_hz * screw_joint_6_vy;
    let outside_joint_6_my_1_0 = complements.complement_link_6_hz * screw_joint_6_vx;
    let outside_joint_6_my_1_1 = complements.complement_link_6_hx * screw_joint_6_vz;
    let outside_joint_6_mz_1_0 = complements.complement_link_6_hx * screw_joint_6_vy;
    let outside_joint_6_mz_1_1 = complements.complement_link_6_hy * screw_joint_6_vx;
    let connection_joint_6_wz_4 = inside_joint_6_my
        - inertias.locked_inverse_pivot_y_2 * inside_joint_6_mx;
    let connection_joint_6_wz = (inside_joint_6_mz
        - inertias.locked_inverse_pivot_z_2 * inside_joint_6_mx
        - inertias.locked_inverse_pivot_z_4 * connection_joint_6_wz_4)
        * inertias.locked_inverse_pivot_z;
    let connection_joint_6_wy = connection_joint_6_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * connection_joint_6_wz;
    let connection_joint_6_wx = inside_joint_6_mx * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * connection_joint_6_wy
        - inertias.locked_inverse_pivot_z_2 * connection_joint_6_wz;
    let connection_joint_6_vx = inside_joint_6_fx * 0.05714285714285714;
    let connection_joint_6_vy = inside_joint_6_fy * 0.05714285714285714;
    let connection_joint_6_vz = inside_joint_6_fz * 0.05714285714285714;
    // joint_7
    let screw_joint_7_vx = poses.origin_link_7_z * poses.minus_rotation_link_6_yy
        - poses.minus_origin_link_7_y * poses.rotation_link_6_zy;
    let screw_joint_7_vy = poses.minus_origin_link_7_x * poses.rotation_link_6_zy
        - poses.origin_link_7_z * poses.minus_rotation_link_6_xy;
    let screw_joint_7_vz = poses.minus_origin_link_7_x * poses.minus_rotation_link_6_yy
        - poses.minus_origin_link_7_y * poses.minus_rotation_link_6_xy;
    let inside_joint_7_mx_4 = inertias.minus_inertia_link_7_hy * screw_joint_7_vz;
    let inside_joint_7_mx_5 = inertias.inertia_link_7_hz * screw_joint_7_vy;
    let inside_joint_7_my_4 = inertias.inertia_link_7_hz * screw_joint_7_vx;
    let inside_joint_7_my_5 = inertias.minus_inertia_link_7_hx * screw_joint_7_vz;
    let inside_joint_7_mz_5 = inertias.minus_inertia_link_7_hx * screw_joint_7_vy;
    let inside_joint_7_mz_4 = inertias.minus_inertia_link_7_hy * screw_joint_7_vx;
    let inside_joint_7_mx = inertias.inside_joint_7_mx_0_0_0
        - inertias.inertia_link_7_xx * poses.minus_rotation_link_6_xy
        + inertias.inside_joint_7_mx_0_1 - (inside_joint_7_mx_4 + inside_joint_7_mx_5);
    let inside_joint_7_my = inertias.inside_joint_7_my_0_0_0
        - inertias.inertia_link_7_yy * poses.minus_rotation_link_6_yy
        + inertias.inside_joint_7_my_0_1 + (inside_joint_7_my_4 + inside_joint_7_my_5);
    let inside_joint_7_mz = inertias.inertia_link_7_zz * poses.rotation_link_6_zy
        - (inertias.inside_joint_7_mz_0_1_0 + inertias.inside_joint_7_mz_0_1_1)
        + (inside_joint_7_mz_4 - inside_joint_7_mz_5);
    let inside_joint_7_fx = screw_joint_7_vx * 2.0
        + (poses.rotation_link_6_zy * inertias.minus_inertia_link_7_hy
            - poses.minus_rotation_link_6_yy * inertias.inertia_link_7_hz);
    let inside_joint_7_fy = screw_joint_7_vy * 2.0
        + (poses.minus_rotation_link_6_xy * inertias.inertia_link_7_hz
            - poses.rotation_link_6_zy * inertias.minus_inertia_link_7_hx);
    let inside_joint_7_fz = screw_joint_7_vz * 2.0
        + (poses.minus_rotation_link_6_xy * inertias.minus_inertia_link_7_hy
            - poses.minus_rotation_link_6_yy * inertias.minus_inertia_link_7_hx);
    let connection_joint_7_wz_4 = inside_joint_7_my
        - inertias.locked_inverse_pivot_y_2 * inside_joint_7_mx;
    let connection_joint_7_wz = (inside_joint_7_mz
        - inertias.locked_inverse_pivot_z_2 * inside_joint_7_mx
        - inertias.locked_inverse_pivot_z_4 * connection_joint_7_wz_4)
        * inertias.locked_inverse_pivot_z;
    let connection_joint_7_wy = connection_joint_7_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * connection_joint_7_wz;
    let connection_joint_7_wx = inside_joint_7_mx * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * connection_joint_7_wy
        - inertias.locked_inverse_pivot_z_2 * connection_joint_7_wz;
    let connection_joint_7_vx = inside_joint_7_fx * 0.05714285714285714;
    let connection_joint_7_vy = inside_joint_7_fy * 0.05714285714285714;
    let connection_joint_7_vz = inside_joint_7_fz * 0.05714285714285714;
    Screws {
        inside_joint_1_mx,
        inside_joint_1_my,
        minus_inside_joint_1_fx,
        inside_joint_1_fy,
        connection_joint_1_wz,
        connection_joint_1_wy,
        connection_joint_1_wx,
        minus_connection_joint_1_vx,
        connection_joint_1_vy,
        screw_joint_2_vx,
        screw_joint_2_vy,
        screw_joint_2_vz,
        inside_joint_2_mx_3,
        inside_joint_2_mx_4,
        inside_joint_2_my_3,
        inside_joint_2_my_4,
        inside_joint_2_mz_2,
        inside_joint_2_mz_3,
        inside_joint_2_fx,
        inside_joint_2_fy,
        inside_joint_2_fz,
        outside_joint_2_mx_1_0,
        outside_joint_2_mx_1_1,
        outside_joint_2_my_1_0,
        outside_joint_2_my_1_1,
        outside_joint_2_mz_1_0,
        outside_joint_2_mz_1_1,
        connection_joint_2_wz,
        connection_joint_2_wy,
        connection_joint_2_wx,
        connection_joint_2_vx,
        connection_joint_2_vy,
        connection_joint_2_vz,
        screw_joint_3_vx,
        screw_joint_3_vy,
        screw_joint_3_vz,
        inside_joint_3_mx_4,
        inside_joint_3_mx_5,
        inside_joint_3_my_4,
        inside_joint_3_my_5,
        inside_joint_3_mz_4,
        inside_joint_3_mz_5,
        inside_joint_3_fx,
        inside_joint_3_fy,
        inside_joint_3_fz,
        outside_joint_3_mx_1_0,
        outside_joint_3_mx_1_1,
        outside_joint_3_my_1_0,
        outside_joint_3_my_1_1,
        outside_joint_3_mz_1_0,
        outside_joint_3_mz_1_1,
        connection_joint_3_wz,
        connection_joint_3_wy,
        connection_joint_3_wx,
        connection_joint_3_vx,
        connection_joint_3_vy,
        connection_joint_3_vz,
        screw_joint_4_vx,
        minus_screw_joint_4_vy,
        minus_screw_joint_4_vz,
        inside_joint_4_mx_5,
        inside_joint_4_mx_4,
        inside_joint_4_my_4,
        inside_joint_4_my_5,
        inside_joint_4_mz_4,
        inside_joint_4_mz_5,
        inside_joint_4_fx,
        inside_joint_4_fy,
        inside_joint_4_fz,
        outside_joint_4_mx_1_1,
        outside_joint_4_mx_1_0,
        outside_joint_4_my_1_0,
        outside_joint_4_my_1_1,
        outside_joint_4_mz_1_0,
        outside_joint_4_mz_1_1,
        connection_joint_4_wz,
        connection_joint_4_wy,
        connection_joint_4_wx,
        connection_joint_4_vx,
        connection_joint_4_vy,
        connection_joint_4_vz,
        screw_joint_5_vx,
        screw_joint_5_vy,
        screw_joint_5_vz,
        inside_joint_5_mx_4,
        inside_joint_5_mx_5,
        inside_joint_5_my_4,
        inside_joint_5_my_5,
        inside_joint_5_mz_4,
        inside_joint_5_mz_5,
        inside_joint_5_fx,
        inside_joint_5_fy,
        inside_joint_5_fz,
        outside_joint_5_mx_1_0,
        outside_joint_5_mx_1_1,
        outside_joint_5_my_1_0,
        outside_joint_5_my_1_1,
        outside_joint_5_mz_1_0,
        outside_joint_5_mz_1_1,
        connection_joint_5_wz,
        connection_joint_5_wy,
        connection_joint_5_wx,
        connection_joint_5_vx,
        connection_joint_5_vy,
        connection_joint_5_vz,
        screw_joint_6_vx,
        screw_joint_6_vy,
        screw_joint_6_vz,
        inside_joint_6_mx_4,
        inside_joint_6_mx_5,
        inside_joint_6_my_4,
        inside_joint_6_my_5,
        inside_joint_6_mz_5,
        inside_joint_6_mz_4,
        inside_joint_6_fx,
        inside_joint_6_fy,
        inside_joint_6_fz,
        outside_joint_6_mx_1_0,
        outside_joint_6_mx_1_1,
        outside_joint_6_my_1_0,
        outside_joint_6_my_1_1,
        outside_joint_6_mz_1_0,
        outside_joint_6_mz_1_1,
        connection_joint_6_wz,
        connection_joint_6_wy,
        connection_joint_6_wx,
        connection_joint_6_vx,
        connection_joint_6_vy,
        connection_joint_6_vz,
        screw_joint_7_vx,
        screw_joint_7_vy,
        screw_joint_7_vz,
        inside_joint_7_mx_4,
        inside_joint_7_mx_5,
        inside_joint_7_my_4,
        inside_joint_7_my_5,
        inside_joint_7_mz_5,
        inside_joint_7_mz_4,
        inside_joint_7_mx,
        inside_joint_7_my,
        inside_joint_7_mz,
        inside_joint_7_fx,
        inside_joint_7_fy,
        inside_joint_7_fz,
        connection_joint_7_wz,
        connection_joint_7_wy,
        connection_joint_7_wx,
        connection_joint_7_vx,
        connection_joint_7_vy,
        connection_joint_7_vz,
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
    outside_joint_4_mx: f64,
    outside_joint_4_my: f64,
    outside_joint_4_mz: f64,
    outside_joint_4_fx: f64,
    outside_joint_4_fy: f64,
    minus_outside_joint_4_fz: f64,
    outside_joint_5_mx: f64,
    outside_joint_5_my: f64,
    outside_joint_5_mz: f64,
    outside_joint_5_fx: f64,
    outside_joint_5_fy: f64,
    outside_joint_5_fz: f64,
    outside_joint_6_mx: f64,
    outside_joint_6_my: f64,
    outside_joint_6_mz: f64,
    outside_joint_6_fx: f64,
    outside_joint_6_fy: f64,
    outside_joint_6_fz: f64,
    outside_joint_7_mx: f64,
    outside_joint_7_my: f64,
    outside_joint_7_mz: f64,
    outside_joint_7_fx: f64,
    outside_joint_7_fy: f64,
    outside_joint_7_fz: f64,
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
    let outside_joint_1_my = inertias.minus_inertia_base_hz * poses.minus_origin_base_y
        - inertias.minus_inertia_base_yz;
    let outside_joint_1_mz = inertias.inertia_base_zz - inertias.inertia_base_zz_1;
    // joint_2
    let outside_joint_2_mx = complements.complement_link_2_xx * poses.sin_joint_1
        - complements.outside_joint_2_mx_0_1
        + (screws.outside_joint_2_mx_1_0 - screws.outside_joint_2_mx_1_1);
    let outside_joint_2_my = complements.outside_joint_2_my_0_0
        - complements.complement_link_2_yy * poses.cos_joint_1
        + (screws.outside_joint_2_my_1_0 + screws.outside_joint_2_my_1_1);
    let outside_joint_2_mz = complements.outside_joint_2_mz_0_0
        + complements.outside_joint_2_mz_0_1
        - (screws.outside_joint_2_mz_1_0 + screws.outside_joint_2_mz_1_1);
    let outside_joint_2_fx = screws.screw_joint_2_vx * 5.5
        - poses.cos_joint_1 * complements.complement_link_2_hz;
    let outside_joint_2_fy = screws.screw_joint_2_vy * 5.5
        - poses.sin_joint_1 * complements.complement_link_2_hz;
    let outside_joint_2_fz = screws.screw_joint_2_vz * 5.5
        + (poses.sin_joint_1 * complements.complement_link_2_hy
            - poses.cos_joint_1 * complements.minus_complement_link_2_hx);
    // joint_3
    let outside_joint_3_mx = complements.outside_joint_3_mx_0_0
        - (complements.complement_link_3_xx * poses.minus_rotation_link_2_xy
            + complements.outside_joint_3_mx_0_1_1)
        + (screws.outside_joint_3_mx_1_0 - screws.outside_joint_3_mx_1_1);
    let outside_joint_3_my = complements.outside_joint_3_my_0_0
        - (complements.outside_joint_3_my_0_1_0
            + complements.complement_link_3_yy * poses.minus_rotation_link_2_yy)
        + (screws.outside_joint_3_my_1_0 - screws.outside_joint_3_my_1_1);
    let outside_joint_3_mz = complements.complement_link_3_zz * poses.cos_joint_2
        - (complements.outside_joint_3_mz_0_1_0 + complements.outside_joint_3_mz_0_1_1)
        + (screws.outside_joint_3_mz_1_0 - screws.outside_joint_3_mz_1_1);
    let outside_joint_3_fx = screws.screw_joint_3_vx * 7.5
        - (poses.minus_rotation_link_2_yy * complements.complement_link_3_hz
            + poses.cos_joint_2 * complements.complement_link_3_hy);
    let outside_joint_3_fy = screws.screw_joint_3_vy * 7.5
        + (poses.cos_joint_2 * complements.complement_link_3_hx
            + poses.minus_rotation_link_2_xy * complements.complement_link_3_hz);
    let outside_joint_3_fz = screws.screw_joint_3_vz * 7.5
        + (poses.minus_rotation_link_2_yy * complements.complement_link_3_hx
            - poses.minus_rotation_link_2_xy * complements.complement_link_3_hy);
    // joint_4
    let outside_joint_4_mx = complements.outside_joint_4_mx_0_0_0
        - complements.complement_link_4_xx * poses.minus_rotation_link_3_xy
        - complements.outside_joint_4_mx_0_1
        + (screws.outside_joint_4_mx_1_0 - screws.outside_joint_4_mx_1_1);
    let outside_joint_4_my = complements.complement_link_4_yy * poses.rotation_link_3_yy
        - complements.outside_joint_4_my_0_0_1 - complements.outside_joint_4_my_0_1
        + (screws.outside_joint_4_my_1_0 + screws.outside_joint_4_my_1_1);
    let outside_joint_4_mz = complements.outside_joint_4_mz_0_0_0
        - complements.outside_joint_4_mz_0_0_1
        - complements.complement_link_4_zz * poses.minus_rotation_link_3_zy
        - (screws.outside_joint_4_mz_1_0 + screws.outside_joint_4_mz_1_1);
    let outside_joint_4_fx = screws.screw_joint_4_vx * 9.5
        + (poses.rotation_link_3_yy * complements.complement_link_4_hz
            + poses.minus_rotation_link_3_zy * complements.complement_link_4_hy);
    let outside_joint_4_fy = poses.minus_rotation_link_3_xy
        * complements.complement_link_4_hz
        - poses.minus_rotation_link_3_zy * complements.complement_link_4_hx
        - screws.minus_screw_joint_4_vy * 9.5;
    let minus_outside_joint_4_fz = screws.minus_screw_joint_4_vz * 9.5
        + (poses.minus_rotation_link_3_xy * complements.complement_link_4_hy
            + poses.rotation_link_3_yy * complements.complement_link_4_hx);
    // joint_5
    let outside_joint_5_mx = complements.outside_joint_5_mx_0_0
        - (complements.complement_link_5_xx * poses.rotation_link_4_xy
            + complements.outside_joint_5_mx_0_1_1)
        + (screws.outside_joint_5_mx_1_0 - screws.outside_joint_5_mx_1_1);
    let outside_joint_5_my = complements.outside_joint_5_my_0_0
        - (complements.outside_joint_5_my_0_1_0
            + complements.complement_link_5_yy * poses.rotation_link_4_yy)
        + (screws.outside_joint_5_my_1_0 - screws.outside_joint_5_my_1_1);
    let outside_joint_5_mz = complements.complement_link_5_zz * poses.rotation_link_5_zz
        - (complements.outside_joint_5_mz_0_1_0 + complements.outside_joint_5_mz_0_1_1)
        + (screws.outside_joint_5_mz_1_0 - screws.outside_joint_5_mz_1_1);
    let outside_joint_5_fx = screws.screw_joint_5_vx * 11.5
        - (poses.rotation_link_4_yy * complements.complement_link_5_hz
            + poses.rotation_link_5_zz * complements.complement_link_5_hy);
    let outside_joint_5_fy = screws.screw_joint_5_vy * 11.5
        + (poses.rotation_link_5_zz * complements.complement_link_5_hx
            + poses.rotation_link_4_xy * complements.complement_link_5_hz);
    let outside_joint_5_fz = screws.screw_joint_5_vz * 11.5
        + (poses.rotation_link_4_yy * complements.complement_link_5_hx
            - poses.rotation_link_4_xy * complements.complement_link_5_hy);
    // joint_6
    let outside_joint_6_mx = complements.complement_link_6_xx * poses.rotation_link_6_xz
        - complements.outside_joint_6_mx_0_0_1 + complements.outside_joint_6_mx_0_1
        + (screws.outside_joint_6_mx_1_0 - screws.outside_joint_6_mx_1_1);
    let outside_joint_6_my = complements.outside_joint_6_my_0_0_0
        - complements.complement_link_6_yy * poses.rotation_link_5_yy
        + complements.outside_joint_6_my_0_1
        + (screws.outside_joint_6_my_1_0 - screws.outside_joint_6_my_1_1);
    let outside_joint_6_mz = complements.outside_joint_6_mz_0_0_0
        - complements.outside_joint_6_mz_0_0_1
        + complements.complement_link_6_zz * poses.rotation_link_6_zz
        + (screws.outside_joint_6_mz_1_0 - screws.outside_joint_6_mz_1_1);
    let outside_joint_6_fx = screws.screw_joint_6_vx * 13.5
        - (poses.rotation_link_5_yy * complements.complement_link_6_hz
            + poses.rotation_link_6_zz * complements.complement_link_6_hy);
    let outside_joint_6_fy = screws.screw_joint_6_vy * 13.5
        + (poses.rotation_link_6_zz * complements.complement_link_6_hx
            - poses.rotation_link_6_xz * complements.complement_link_6_hz);
    let outside_joint_6_fz = screws.screw_joint_6_vz * 13.5
        + (poses.rotation_link_6_xz * complements.complement_link_6_hy
            + poses.rotation_link_5_yy * complements.complement_link_6_hx);
    // joint_7
    let outside_joint_7_mx = complements.complement_link_7_xz * poses.rotation_link_6_zy
        - (complements.complement_link_7_xx * poses.minus_rotation_link_6_xy
            + complements.complement_link_7_xy * poses.minus_rotation_link_6_yy)
        + (complements.complement_link_7_hy * screws.screw_joint_7_vz
            - complements.complement_link_7_hz * screws.screw_joint_7_vy);
    let outside_joint_7_my = complements.complement_link_7_yz * poses.rotation_link_6_zy
        - (complements.complement_link_7_xy * poses.minus_rotation_link_6_xy
            + complements.complement_link_7_yy * poses.minus_rotation_link_6_yy)
        + (complements.complement_link_7_hz * screws.screw_joint_7_vx
            - complements.complement_link_7_hx * screws.screw_joint_7_vz);
    let outside_joint_7_mz = complements.complement_link_7_zz * poses.rotation_link_6_zy
        - (complements.complement_link_7_xz * poses.minus_rotation_link_6_xy
            + complements.complement_link_7_yz * poses.minus_rotation_link_6_yy)
        + (complements.complement_link_7_hx * screws.screw_joint_7_vy
            - complements.complement_link_7_hy * screws.screw_joint_7_vx);
    let outside_joint_7_fx = screws.screw_joint_7_vx * 15.5
        - (poses.minus_rotation_link_6_yy * complements.complement_link_7_hz
            + poses.rotation_link_6_zy * complements.complement_link_7_hy);
    let outside_joint_7_fy = screws.screw_joint_7_vy * 15.5
        + (poses.rotation_link_6_zy * complements.complement_link_7_hx
            + poses.minus_rotation_link_6_xy * complements.complement_link_7_hz);
    let outside_joint_7_fz = screws.screw_joint_7_vz * 15.5
        + (poses.minus_rotation_link_6_yy * complements.complement_link_7_hx
            - poses.minus_rotation_link_6_xy * complements.complement_link_7_hy);
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
        outside_joint_4_mx,
        outside_joint_4_my,
        outside_joint_4_mz,
        outside_joint_4_fx,
        outside_joint_4_fy,
        minus_outside_joint_4_fz,
        outside_joint_5_mx,
        outside_joint_5_my,
        outside_joint_5_mz,
        outside_joint_5_fx,
        outside_joint_5_fy,
        outside_joint_5_fz,
        outside_joint_6_mx,
        outside_joint_6_my,
        outside_joint_6_mz,
        outside_joint_6_fx,
        outside_joint_6_fy,
        outside_joint_6_fz,
        outside_joint_7_mx,
        outside_joint_7_my,
        outside_joint_7_mz,
        outside_joint_7_fx,
        outside_joint_7_fy,
        outside_joint_7_fz,
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
    reaction_joint_4_wz: f64,
    reaction_joint_4_wy: f64,
    reaction_joint_4_wx: f64,
    reaction_joint_4_vx: f64,
    reaction_joint_4_vy: f64,
    minus_reaction_joint_4_vz: f64,
    reaction_joint_5_wz: f64,
    reaction_joint_5_wy: f64,
    reaction_joint_5_wx: f64,
    reaction_joint_5_vx: f64,
    reaction_joint_5_vy: f64,
    reaction_joint_5_vz: f64,
    reaction_joint_6_wz: f64,
    reaction_joint_6_wy: f64,
    reaction_joint_6_wx: f64,
    reaction_joint_6_vx: f64,
    reaction_joint_6_vy: f64,
    reaction_joint_6_vz: f64,
    reaction_joint_7_wz: f64,
    reaction_joint_7_wy: f64,
    reaction_joint_7_wx: f64,
    reaction_joint_7_vx: f64,
    reaction_joint_7_vy: f64,
    reaction_joint_7_vz: f64,
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
    let reaction_joint_2_vx = outside.outside_joint_2_fx * 0.05714285714285714;
    let reaction_joint_2_vy = outside.outside_joint_2_fy * 0.05714285714285714;
    let reaction_joint_2_vz = outside.outside_joint_2_fz * 0.05714285714285714;
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
    let reaction_joint_3_vx = outside.outside_joint_3_fx * 0.05714285714285714;
    let reaction_joint_3_vy = outside.outside_joint_3_fy * 0.05714285714285714;
    let reaction_joint_3_vz = outside.outside_joint_3_fz * 0.05714285714285714;
    let reaction_joint_4_wz_4 = outside.outside_joint_4_my
        - inertias.locked_inverse_pivot_y_2 * outside.outside_joint_4_mx;
    // joint_4
    let reaction_joint_4_wz = (outside.outside_joint_4_mz
        - inertias.locked_inverse_pivot_z_2 * outside.outside_joint_4_mx
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_4_wz_4)
        * inertias.locked_inverse_pivot_z;
    let reaction_joint_4_wy = reaction_joint_4_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_4_wz;
    let reaction_joint_4_wx = outside.outside_joint_4_mx
        * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * reaction_joint_4_wy
        - inertias.locked_inverse_pivot_z_2 * reaction_joint_4_wz;
    let reaction_joint_4_vx = outside.outside_joint_4_fx * 0.05714285714285714;
    let reaction_joint_4_vy = outside.outside_joint_4_fy * 0.05714285714285714;
    let minus_reaction_joint_4_vz = outside.minus_outside_joint_4_fz
        * 0.05714285714285714;
    let reaction_joint_5_wz_4 = outside.outside_joint_5_my
        - inertias.locked_inverse_pivot_y_2 * outside.outside_joint_5_mx;
    // joint_5
    let reaction_joint_5_wz = (outside.outside_joint_5_mz
        - inertias.locked_inverse_pivot_z_2 * outside.outside_joint_5_mx
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_5_wz_4)
        * inertias.locked_inverse_pivot_z;
    let reaction_joint_5_wy = reaction_joint_5_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_5_wz;
    let reaction_joint_5_wx = outside.outside_joint_5_mx
        * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * reaction_joint_5_wy
        - inertias.locked_inverse_pivot_z_2 * reaction_joint_5_wz;
    let reaction_joint_5_vx = outside.outside_joint_5_fx * 0.05714285714285714;
    let reaction_joint_5_vy = outside.outside_joint_5_fy * 0.05714285714285714;
    let reaction_joint_5_vz = outside.outside_joint_5_fz * 0.05714285714285714;
    let reaction_joint_6_wz_4 = outside.outside_joint_6_my
        - inertias.locked_inverse_pivot_y_2 * outside.outside_joint_6_mx;
    // joint_6
    let reaction_joint_6_wz = (outside.outside_joint_6_mz
        - inertias.locked_inverse_pivot_z_2 * outside.outside_joint_6_mx
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_6_wz_4)
        * inertias.locked_inverse_pivot_z;
    let reaction_joint_6_wy = reaction_joint_6_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_6_wz;
    let reaction_joint_6_wx = outside.outside_joint_6_mx
        * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * reaction_joint_6_wy
        - inertias.locked_inverse_pivot_z_2 * reaction_joint_6_wz;
    let reaction_joint_6_vx = outside.outside_joint_6_fx * 0.05714285714285714;
    let reaction_joint_6_vy = outside.outside_joint_6_fy * 0.05714285714285714;
    let reaction_joint_6_vz = outside.outside_joint_6_fz * 0.05714285714285714;
    let reaction_joint_7_wz_4 = outside.outside_joint_7_my
        - inertias.locked_inverse_pivot_y_2 * outside.outside_joint_7_mx;
    // joint_7
    let reaction_joint_7_wz = (outside.outside_joint_7_mz
        - inertias.locked_inverse_pivot_z_2 * outside.outside_joint_7_mx
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_7_wz_4)
        * inertias.locked_inverse_pivot_z;
    let reaction_joint_7_wy = reaction_joint_7_wz_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * reaction_joint_7_wz;
    let reaction_joint_7_wx = outside.outside_joint_7_mx
        * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * reaction_joint_7_wy
        - inertias.locked_inverse_pivot_z_2 * reaction_joint_7_wz;
    let reaction_joint_7_vx = outside.outside_joint_7_fx * 0.05714285714285714;
    let reaction_joint_7_vy = outside.outside_joint_7_fy * 0.05714285714285714;
    let reaction_joint_7_vz = outside.outside_joint_7_fz * 0.05714285714285714;
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
        reaction_joint_4_wz,
        reaction_joint_4_wy,
        reaction_joint_4_wx,
        reaction_joint_4_vx,
        reaction_joint_4_vy,
        minus_reaction_joint_4_vz,
        reaction_joint_5_wz,
        reaction_joint_5_wy,
        reaction_joint_5_wx,
        reaction_joint_5_vx,
        reaction_joint_5_vy,
        reaction_joint_5_vz,
        reaction_joint_6_wz,
        reaction_joint_6_wy,
        reaction_joint_6_wx,
        reaction_joint_6_vx,
        reaction_joint_6_vy,
        reaction_joint_6_vz,
        reaction_joint_7_wz,
        reaction_joint_7_wy,
        reaction_joint_7_wx,
        reaction_joint_7_vx,
        reaction_joint_7_vy,
        reaction_joint_7_vz,
    }
}
/// Velocities of the bodies at zero momentum.
struct Velocities {
    minus_velocity_base_wx: f64,
    minus_velocity_base_wy: f64,
    minus_velocity_base_wz: f64,
    velocity_base_vx: f64,
    minus_velocity_base_vy: f64,
    minus_velocity_base_vz: f64,
    velocity_link_1_wz: f64,
    velocity_link_1_vx: f64,
    velocity_link_1_vy: f64,
    velocity_link_2_wx: f64,
    minus_velocity_link_2_wy: f64,
    velocity_link_2_vx: f64,
    velocity_link_2_vy: f64,
    velocity_link_2_vz: f64,
    velocity_link_3_wx: f64,
    minus_velocity_link_3_wy: f64,
    velocity_link_3_wz: f64,
    velocity_link_3_vx: f64,
    velocity_link_3_vy: f64,
    velocity_link_3_vz: f64,
    velocity_link_4_wx: f64,
    velocity_link_4_wy: f64,
    velocity_link_4_wz: f64,
    velocity_link_4_vx: f64,
    velocity_link_4_vy: f64,
    velocity_link_4_vz: f64,
    velocity_link_5_wx: f64,
    velocity_link_5_wy: f64,
    velocity_link_5_wz: f64,
    velocity_link_5_vx: f64,
    velocity_link_5_vy: f64,
    velocity_link_5_vz: f64,
    velocity_link_6_wx: f64,
    velocity_link_6_wy: f64,
    velocity_link_6_wz: f64,
    velocity_link_6_vx: f64,
    velocity_link_6_vy: f64,
    velocity_link_6_vz: f64,
    velocity_link_7_wx: f64,
    velocity_link_7_wy: f64,
    velocity_link_7_wz: f64,
    velocity_link_7_vx: f64,
    velocity_link_7_vy: f64,
    velocity_link_7_vz: f64,
}
/// Velocities of the bodies at zero momentum.
#[inline(never)]
fn velocities(qd: &[f64; 7], poses: &Poses, screws: &Screws) -> Velocities {
    // base
    let minus_velocity_base_wx = screws.connection_joint_1_wx * qd[0]
        + screws.connection_joint_2_wx * qd[1] + screws.connection_joint_3_wx * qd[2]
        + screws.connection_joint_4_wx * qd[3] + screws.connection_joint_5_wx * qd[4]
        + screws.connection_joint_6_wx * qd[5] + screws.connection_joint_7_wx * qd[6];
    let minus_velocity_base_wy = screws.connection_joint_1_wy * qd[0]
        + screws.connection_joint_2_wy * qd[1] + screws.connection_joint_3_wy * qd[2]
        + screws.connection_joint_4_wy * qd[3] + screws.connection_joint_5_wy * qd[4]
        + screws.connection_joint_6_wy * qd[5] + screws.connection_joint_7_wy * qd[6];
    let minus_velocity_base_wz = screws.connection_joint_1_wz * qd[0]
        + screws.connection_joint_2_wz * qd[1] + screws.connection_joint_3_wz * qd[2]
        + screws.connection_joint_4_wz * qd[3] + screws.connection_joint_5_wz * qd[4]
        + screws.connection_joint_6_wz * qd[5] + screws.connection_joint_7_wz * qd[6];
    let velocity_base_vx = screws.minus_connection_joint_1_vx * qd[0]
        - screws.connection_joint_2_vx * qd[1] - screws.connection_joint_3_vx * qd[2]
        - screws.connection_joint_4_vx * qd[3] - screws.connection_joint_5_vx * qd[4]
        - screws.connection_joint_6_vx * qd[5] - screws.connection_joint_7_vx * qd[6];
    let minus_velocity_base_vy = screws.connection_joint_1_vy * qd[0]
        + screws.connection_joint_2_vy * qd[1] + screws.connection_joint_3_vy * qd[2]
        + screws.connection_joint_4_vy * qd[3] + screws.connection_joint_5_vy * qd[4]
        + screws.connection_joint_6_vy * qd[5] + screws.connection_joint_7_vy * qd[6];
    let minus_velocity_base_vz = screws.connection_joint_2_vz * qd[1]
        + screws.connection_joint_3_vz * qd[2] + screws.connection_joint_4_vz * qd[3]
        + screws.connection_joint_5_vz * qd[4] + screws.connection_joint_6_vz * qd[5]
        + screws.connection_joint_7_vz * qd[6];
    // link_1
    let velocity_link_1_wz = qd[0] - minus_velocity_base_wz;
    let velocity_link_1_vx = velocity_base_vx - poses.minus_origin_base_y * qd[0];
    let velocity_link_1_vy = poses.minus_origin_base_x * qd[0] - minus_velocity_base_vy;
    // link_2
    let velocity_link_2_wx = poses.sin_joint_1 * qd[1] - minus_velocity_base_wx;
    let minus_velocity_link_2_wy = minus_velocity_base_wy + poses.cos_joint_1 * qd[1];
    let velocity_link_2_vx = velocity_link_1_vx + screws.screw_joint_2_vx * qd[1];
    let velocity_link_2_vy = velocity_link_1_vy + screws.screw_joint_2_vy * qd[1];
    let velocity_link_2_vz = screws.screw_joint_2_vz * qd[1] - minus_velocity_base_vz;
    // link_3
    let velocity_link_3_wx = velocity_link_2_wx - poses.minus_rotation_link_2_xy * qd[2];
    let minus_velocity_link_3_wy = minus_velocity_link_2_wy
        + poses.minus_rotation_link_2_yy * qd[2];
    let velocity_link_3_wz = velocity_link_1_wz + poses.cos_joint_2 * qd[2];
    let velocity_link_3_vx = velocity_link_2_vx + screws.screw_joint_3_vx * qd[2];
    let velocity_link_3_vy = velocity_link_2_vy + screws.screw_joint_3_vy * qd[2];
    let velocity_link_3_vz = velocity_link_2_vz + screws.screw_joint_3_vz * qd[2];
    // link_4
    let velocity_link_4_wx = velocity_link_3_wx - poses.minus_rotation_link_3_xy * qd[3];
    let velocity_link_4_wy = poses.rotation_link_3_yy * qd[3] - minus_velocity_link_3_wy;
    let velocity_link_4_wz = velocity_link_3_wz - poses.minus_rotation_link_3_zy * qd[3];
    let velocity_link_4_vx = velocity_link_3_vx + screws.screw_joint_4_vx * qd[3];
    let velocity_link_4_vy = velocity_link_3_vy - screws.minus_screw_joint_4_vy * qd[3];
    let velocity_link_4_vz = velocity_link_3_vz - screws.minus_screw_joint_4_vz * qd[3];
    // link_5
    let velocity_link_5_wx = velocity_link_4_wx - poses.rotation_link_4_xy * qd[4];
    let velocity_link_5_wy = velocity_link_4_wy - poses.rotation_link_4_yy * qd[4];
    let velocity_link_5_wz = velocity_link_4_wz + poses.rotation_link_5_zz * qd[4];
    let velocity_link_5_vx = velocity_link_4_vx + screws.screw_joint_5_vx * qd[4];
    let velocity_link_5_vy = velocity_link_4_vy + screws.screw_joint_5_vy * qd[4];
    let velocity_link_5_vz = velocity_link_4_vz + screws.screw_joint_5_vz * qd[4];
    // link_6
    let velocity_link_6_wx = velocity_link_5_wx + poses.rotation_link_6_xz * qd[5];
    let velocity_link_6_wy = velocity_link_5_wy - poses.rotation_link_5_yy * qd[5];
    let velocity_link_6_wz = velocity_link_5_wz + poses.rotation_link_6_zz * qd[5];
    let velocity_link_6_vx = velocity_link_5_vx + screws.screw_joint_6_vx * qd[5];
    let velocity_link_6_vy = velocity_link_5_vy + screws.screw_joint_6_vy * qd[5];
    let velocity_link_6_vz = velocity_link_5_vz + screws.screw_joint_6_vz * qd[5];
    // link_7
    let velocity_link_7_wx = velocity_link_6_wx - poses.minus_rotation_link_6_xy * qd[6];
    let velocity_link_7_wy = velocity_link_6_wy - poses.minus_rotation_link_6_yy * qd[6];
    let velocity_link_7_wz = velocity_link_6_wz + poses.rotation_link_6_zy * qd[6];
    let velocity_link_7_vx = velocity_link_6_vx + screws.screw_joint_7_vx * qd[6];
    let velocity_link_7_vy = velocity_link_6_vy + screws.screw_joint_7_vy * qd[6];
    let velocity_link_7_vz = velocity_link_6_vz + screws.screw_joint_7_vz * qd[6];
    Velocities {
        minus_velocity_base_wx,
        minus_velocity_base_wy,
        minus_velocity_base_wz,
        velocity_base_vx,
        minus_velocity_base_vy,
        minus_velocity_base_vz,
        velocity_link_1_wz,
        velocity_link_1_vx,
        velocity_link_1_vy,
        velocity_link_2_wx,
        minus_velocity_link_2_wy,
        velocity_link_2_vx,
        velocity_link_2_vy,
        velocity_link_2_vz,
        velocity_link_3_wx,
        minus_velocity_link_3_wy,
        velocity_link_3_wz,
        velocity_link_3_vx,
        velocity_link_3_vy,
        velocity_link_3_vz,
        velocity_link_4_wx,
        velocity_link_4_wy,
        velocity_link_4_wz,
        velocity_link_4_vx,
        velocity_link_4_vy,
        velocity_link_4_vz,
        velocity_link_5_wx,
        velocity_link_5_wy,
        velocity_link_5_wz,
        velocity_link_5_vx,
        velocity_link_5_vy,
        velocity_link_5_vz,
        velocity_link_6_wx,
        velocity_link_6_wy,
        velocity_link_6_wz,
        velocity_link_6_vx,
        velocity_link_6_vy,
        velocity_link_6_vz,
        velocity_link_7_wx,
        velocity_link_7_wy,
        velocity_link_7_wz,
        velocity_link_7_vx,
        velocity_link_7_vy,
        velocity_link_7_vz,
    }
}
/// What `d_mu`, `b2`, `d_qdot`, `d_mu_xi`, `d_qdot_xi`, `curvature`, `forward_dynamics`, `inverse_dynamics` have in common.
struct CommonDMuAnd7More {
    three_joint_2_x_0_0_0: f64,
    three_joint_2_x_0_1_0: f64,
    three_joint_2_x_1_0: f64,
    three_joint_2_y_0_0_0: f64,
    three_joint_2_y_1_0: f64,
    three_joint_2_z_1_0: f64,
    three_joint_3_x_0_0_0: f64,
    three_joint_3_x_0_1_0: f64,
    three_joint_3_x_1_0: f64,
    three_joint_3_y_0_1_0: f64,
    three_joint_3_y_1_0: f64,
    three_joint_3_z_1_0: f64,
    three_joint_4_x_0_0_0: f64,
    three_joint_4_x_0_1_0: f64,
    three_joint_4_x_1_0: f64,
    three_joint_4_y_0_1_0: f64,
    three_joint_4_y_1_0: f64,
    three_joint_4_z_1_0: f64,
    three_joint_5_x_0_0_0: f64,
    three_joint_5_x_0_1_0: f64,
    three_joint_5_x_1_0: f64,
    three_joint_5_y_0_1_0: f64,
    three_joint_5_y_1_0: f64,
    three_joint_5_z_1_0: f64,
    three_joint_6_x_0_0_0: f64,
    three_joint_6_x_0_1_0: f64,
    three_joint_6_x_1_0: f64,
    three_joint_6_y_0_1_0: f64,
    three_joint_6_y_1_0: f64,
    three_joint_6_z_1_0: f64,
    three_joint_7_x_0_0_0: f64,
    three_joint_7_x_0_1_0: f64,
    three_joint_7_x_1_0: f64,
    three_joint_7_y_0_1_0: f64,
    three_joint_7_y_1_0: f64,
    three_joint_7_z_1_0: f64,
}
/// What `d_mu`, `b2`, `d_qdot`, `d_mu_xi`, `d_qdot_xi`, `curvature`, `forward_dynamics`, `inverse_dynamics` have in common.
#[inline(never)]
fn common_d_mu_and_7_more(
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
) -> CommonDMuAnd7More {
    let three_joint_2_z_1_0_1_1 = poses.cos_joint_1 * inertias.composite_link_2_xz;
    let three_joint_2_z_1_0_1_0 = poses.sin_joint_1 * inertias.composite_link_2_yz;
    let three_joint_2_z_1_0_1 = three_joint_2_z_1_0_1_0 + three_joint_2_z_1_0_1_1;
    let three_joint_2_y_0_0_0_0_1 = inertias.composite_link_2_hx
        * screws.screw_joint_2_vx;
    let three_joint_2_x_0_0_0_0_1 = inertias.composite_link_2_hy
        * screws.screw_joint_2_vy;
    let three_joint_2_x_0_0_0_1_1 = inertias.composite_link_2_hz
        * screws.screw_joint_2_vz;
    let three_joint_2_x_0_0_0_0 = three_joint_2_x_0_0_0_0_1 + three_joint_2_x_0_0_0_0_1;
    let three_joint_2_x_0_0_0_1 = three_joint_2_x_0_0_0_1_1 + three_joint_2_x_0_0_0_1_1;
    let three_joint_2_y_0_0_0_0 = three_joint_2_y_0_0_0_0_1 + three_joint_2_y_0_0_0_0_1;
    let three_joint_2_x_0_0_0 = three_joint_2_x_0_0_0_0 + three_joint_2_x_0_0_0_1
        - (three_joint_2_z_1_0_1_1 + three_joint_2_z_1_0_1_1);
    let three_joint_2_x_0_1_0 = inertias.inside_joint_2_mz_0_1
        + inertias.inside_joint_2_mz_0_0
        + (screws.inside_joint_2_mz_2 + screws.inside_joint_2_mz_3);
    let three_joint_2_x_1_0 = inertias.inside_joint_2_my_0_0
        + poses.cos_joint_1 * inertias.composite_link_2_xx
        - poses.cos_joint_1 * inertias.composite_link_2_zz
        - (screws.inside_joint_2_my_4 + screws.inside_joint_2_my_3);
    let three_joint_2_y_0_0_0 = three_joint_2_y_0_0_0_0 + three_joint_2_x_0_0_0_1
        - (three_joint_2_z_1_0_1_0 + three_joint_2_z_1_0_1_0);
    let three_joint_2_y_1_0 = poses.sin_joint_1 * inertias.composite_link_2_yy
        + inertias.inside_joint_2_mx_0_1
        - poses.sin_joint_1 * inertias.composite_link_2_zz
        - (screws.inside_joint_2_mx_3 + screws.inside_joint_2_mx_4);
    let three_joint_2_z_1_0 = three_joint_2_z_1_0_1 + three_joint_2_z_1_0_1
        + (three_joint_2_y_0_0_0_0 + three_joint_2_x_0_0_0_0);
    let three_joint_3_x_0_0_0_3_0 = poses.minus_rotation_link_2_yy
        * inertias.composite_link_3_xz;
    let three_joint_3_x_0_0_0_3_1 = poses.cos_joint_2 * inertias.composite_link_3_xy;
    let three_joint_3_x_0_0_0_3 = three_joint_3_x_0_0_0_3_0 + three_joint_3_x_0_0_0_3_1;
    let three_joint_3_y_0_1_0_1_1 = poses.minus_rotation_link_2_xy
        * inertias.composite_link_3_yz;
    let three_joint_3_y_0_1_0_1 = three_joint_3_x_0_0_0_3_1 + three_joint_3_y_0_1_0_1_1;
    let three_joint_3_z_1_0_1 = three_joint_3_x_0_0_0_3_0 - three_joint_3_y_0_1_0_1_1;
    let three_joint_3_y_0_1_0_2_1 = inertias.composite_link_3_hx
        * screws.screw_joint_3_vx;
    let three_joint_3_x_0_0_0_0_1 = inertias.composite_link_3_hy
        * screws.screw_joint_3_vy;
    let three_joint_3_x_0_0_0_1_1 = inertias.composite_link_3_hz
        * screws.screw_joint_3_vz;
    let three_joint_3_x_0_0_0_0 = three_joint_3_x_0_0_0_0_1 + three_joint_3_x_0_0_0_0_1;
    let three_joint_3_x_0_0_0_1 = three_joint_3_x_0_0_0_1_1 + three_joint_3_x_0_0_0_1_1;
    let three_joint_3_y_0_1_0_2 = three_joint_3_y_0_1_0_2_1 + three_joint_3_y_0_1_0_2_1;
    let three_joint_3_x_0_0_0 = three_joint_3_x_0_0_0_0 + three_joint_3_x_0_0_0_1
        - (three_joint_3_x_0_0_0_3 + three_joint_3_x_0_0_0_3);
    let three_joint_3_x_0_1_0 = poses.cos_joint_2 * inertias.composite_link_3_xx
        + inertias.inside_joint_3_mz_0_1_0
        - (inertias.inside_joint_3_mz_0_1_1
            + poses.cos_joint_2 * inertias.composite_link_3_yy)
        - (screws.inside_joint_3_mz_4 + screws.inside_joint_3_mz_5);
    let three_joint_3_x_1_0 = poses.minus_rotation_link_2_yy
        * inertias.composite_link_3_xx - inertias.inside_joint_3_my_0_1_0
        - (poses.minus_rotation_link_2_yy * inertias.composite_link_3_zz
            + inertias.inside_joint_3_my_0_0)
        - (screws.inside_joint_3_my_5 + screws.inside_joint_3_my_4);
    let three_joint_3_y_0_1_0 = three_joint_3_y_0_1_0_1 + three_joint_3_y_0_1_0_1
        + (three_joint_3_y_0_1_0_2 + three_joint_3_x_0_0_0_1);
    let three_joint_3_y_1_0 = inertias.inside_joint_3_mx_0_0
        + poses.minus_rotation_link_2_xy * inertias.composite_link_3_zz
        + (inertias.inside_joint_3_mx_0_1_1
            - poses.minus_rotation_link_2_xy * inertias.composite_link_3_yy)
        - (screws.inside_joint_3_mx_4 + screws.inside_joint_3_mx_5);
    let three_joint_3_z_1_0 = three_joint_3_z_1_0_1 + three_joint_3_z_1_0_1
        + (three_joint_3_y_0_1_0_2 + three_joint_3_x_0_0_0_0);
    let three_joint_4_x_0_0_0_1_0 = poses.rotation_link_3_yy
        * inertias.composite_link_4_xz;
    let three_joint_4_x_0_0_0_1_1 = poses.minus_rotation_link_3_zy
        * inertias.composite_link_4_xy;
    let three_joint_4_x_0_0_0_1 = three_joint_4_x_0_0_0_1_0 + three_joint_4_x_0_0_0_1_1;
    let three_joint_4_y_0_1_0_1_0 = poses.minus_rotation_link_3_xy
        * inertias.composite_link_4_yz;
    let three_joint_4_y_0_1_0_1 = three_joint_4_y_0_1_0_1_0 - three_joint_4_x_0_0_0_1_1;
    let three_joint_4_z_1_0_1 = three_joint_4_y_0_1_0_1_0 + three_joint_4_x_0_0_0_1_0;
    let three_joint_4_y_0_1_0_2_1 = inertias.minus_composite_link_4_hx
        * screws.screw_joint_4_vx;
    let three_joint_4_x_0_0_0_2_1 = inertias.composite_link_4_hy
        * screws.minus_screw_joint_4_vy;
    let three_joint_4_x_0_0_0_3_1 = inertias.composite_link_4_hz
        * screws.minus_screw_joint_4_vz;
    let three_joint_4_x_0_0_0_2 = three_joint_4_x_0_0_0_2_1 + three_joint_4_x_0_0_0_2_1;
    let three_joint_4_x_0_0_0_3 = three_joint_4_x_0_0_0_3_1 + three_joint_4_x_0_0_0_3_1;
    let three_joint_4_y_0_1_0_2 = three_joint_4_y_0_1_0_2_1 + three_joint_4_y_0_1_0_2_1;
    let three_joint_4_x_0_0_0 = three_joint_4_x_0_0_0_1 + three_joint_4_x_0_0_0_1
        - (three_joint_4_x_0_0_0_2 + three_joint_4_x_0_0_0_3);
    let three_joint_4_x_0_1_0 = inertias.inside_joint_4_mz_0_0_0
        + poses.minus_rotation_link_3_zy * inertias.composite_link_4_yy
        + (inertias.inside_joint_4_mz_0_0_1
            - poses.minus_rotation_link_3_zy * inertias.composite_link_4_xx)
        - (screws.inside_joint_4_mz_4 + screws.inside_joint_4_mz_5);
    let three_joint_4_x_1_0 = poses.rotation_link_3_yy * inertias.composite_link_4_zz
        + inertias.inside_joint_4_my_0_1
        - (inertias.inside_joint_4_my_0_0_1
            + poses.rotation_link_3_yy * inertias.composite_link_4_xx)
        - (screws.inside_joint_4_my_5 + screws.inside_joint_4_my_4);
    let three_joint_4_y_0_1_0 = three_joint_4_y_0_1_0_1 + three_joint_4_y_0_1_0_1
        - (three_joint_4_y_0_1_0_2 + three_joint_4_x_0_0_0_3);
    let three_joint_4_y_1_0 = poses.minus_rotation_link_3_xy
        * inertias.composite_link_4_zz - inertias.inside_joint_4_mx_0_1
        - (poses.minus_rotation_link_3_xy * inertias.composite_link_4_yy
            + inertias.inside_joint_4_mx_0_0_0)
        + (screws.inside_joint_4_mx_5 + screws.inside_joint_4_mx_4);
    let three_joint_4_z_1_0 = three_joint_4_z_1_0_1 + three_joint_4_z_1_0_1
        + (three_joint_4_y_0_1_0_2 + three_joint_4_x_0_0_0_2);
    let three_joint_5_x_0_0_0_3_0 = poses.rotation_link_4_yy
        * inertias.composite_link_5_xz;
    let three_joint_5_x_0_0_0_3_1 = poses.rotation_link_5_zz
        * inertias.composite_link_5_xy;
    let three_joint_5_x_0_0_0_3 = three_joint_5_x_0_0_0_3_0 + three_joint_5_x_0_0_0_3_1;
    let three_joint_5_y_0_1_0_1_1 = poses.rotation_link_4_xy
        * inertias.composite_link_5_yz;
    let three_joint_5_y_0_1_0_1 = three_joint_5_x_0_0_0_3_1 + three_joint_5_y_0_1_0_1_1;
    let three_joint_5_z_1_0_1 = three_joint_5_x_0_0_0_3_0 - three_joint_5_y_0_1_0_1_1;
    let three_joint_5_y_0_1_0_3_1 = inertias.minus_composite_link_5_hx
        * screws.screw_joint_5_vx;
    let three_joint_5_x_0_0_0_0_1 = inertias.composite_link_5_hy
        * screws.screw_joint_5_vy;
    let three_joint_5_x_0_0_0_1_1 = inertias.composite_link_5_hz
        * screws.screw_joint_5_vz;
    let three_joint_5_x_0_0_0_0 = three_joint_5_x_0_0_0_0_1 + three_joint_5_x_0_0_0_0_1;
    let three_joint_5_x_0_0_0_1 = three_joint_5_x_0_0_0_1_1 + three_joint_5_x_0_0_0_1_1;
    let three_joint_5_y_0_1_0_3 = three_joint_5_y_0_1_0_3_1 + three_joint_5_y_0_1_0_3_1;
    let three_joint_5_x_0_0_0 = three_joint_5_x_0_0_0_0 + three_joint_5_x_0_0_0_1
        - (three_joint_5_x_0_0_0_3 + three_joint_5_x_0_0_0_3);
    let three_joint_5_x_0_1_0 = poses.rotation_link_5_zz * inertias.composite_link_5_xx
        + inertias.inside_joint_5_mz_0_1_0
        - (inertias.inside_joint_5_mz_0_1_1
            + poses.rotation_link_5_zz * inertias.composite_link_5_yy)
        - (screws.inside_joint_5_mz_5 - screws.inside_joint_5_mz_4);
    let three_joint_5_x_1_0 = poses.rotation_link_4_yy * inertias.composite_link_5_xx
        - inertias.inside_joint_5_my_0_1_0
        - (poses.rotation_link_4_yy * inertias.composite_link_5_zz
            + inertias.inside_joint_5_my_0_0)
        - (screws.inside_joint_5_my_4 - screws.inside_joint_5_my_5);
    let three_joint_5_y_0_1_0 = three_joint_5_y_0_1_0_1 + three_joint_5_y_0_1_0_1
        + (three_joint_5_x_0_0_0_1 - three_joint_5_y_0_1_0_3);
    let three_joint_5_y_1_0 = inertias.inside_joint_5_mx_0_0
        + poses.rotation_link_4_xy * inertias.composite_link_5_zz
        + (inertias.inside_joint_5_mx_0_1_1
            - poses.rotation_link_4_xy * inertias.composite_link_5_yy)
        - (screws.inside_joint_5_mx_4 + screws.inside_joint_5_mx_5);
    let three_joint_5_z_1_0 = three_joint_5_z_1_0_1 + three_joint_5_z_1_0_1
        + (three_joint_5_x_0_0_0_0 - three_joint_5_y_0_1_0_3);
    let three_joint_6_x_0_0_0_1_1 = poses.rotation_link_5_yy
        * inertias.composite_link_6_xz;
    let three_joint_6_x_0_0_0_1_0 = poses.rotation_link_6_zz
        * inertias.minus_composite_link_6_xy;
    let three_joint_6_x_0_0_0_1 = three_joint_6_x_0_0_0_1_0 - three_joint_6_x_0_0_0_1_1;
    let three_joint_6_y_0_1_0_3_1 = poses.rotation_link_6_xz
        * inertias.composite_link_6_yz;
    let three_joint_6_y_0_1_0_3 = three_joint_6_x_0_0_0_1_0 + three_joint_6_y_0_1_0_3_1;
    let three_joint_6_z_1_0_1 = three_joint_6_y_0_1_0_3_1 + three_joint_6_x_0_0_0_1_1;
    let three_joint_6_y_0_1_0_1_1 = inertias.minus_composite_link_6_hx
        * screws.screw_joint_6_vx;
    let three_joint_6_x_0_0_0_3_1 = inertias.minus_composite_link_6_hy
        * screws.screw_joint_6_vy;
    let three_joint_6_x_0_0_0_2_1 = inertias.composite_link_6_hz
        * screws.screw_joint_6_vz;
    let three_joint_6_x_0_0_0_3 = three_joint_6_x_0_0_0_3_1 + three_joint_6_x_0_0_0_3_1;
    let three_joint_6_x_0_0_0_2 = three_joint_6_x_0_0_0_2_1 + three_joint_6_x_0_0_0_2_1;
    let three_joint_6_y_0_1_0_1 = three_joint_6_y_0_1_0_1_1 + three_joint_6_y_0_1_0_1_1;
    let three_joint_6_x_0_0_0 = three_joint_6_x_0_0_0_1 + three_joint_6_x_0_0_0_1
        + (three_joint_6_x_0_0_0_2 - three_joint_6_x_0_0_0_3);
    let three_joint_6_x_0_1_0 = poses.rotation_link_6_zz * inertias.composite_link_6_xx
        - inertias.inside_joint_6_mz_0_0_0
        - (inertias.inside_joint_6_mz_0_0_1
            + poses.rotation_link_6_zz * inertias.composite_link_6_yy)
        + (screws.inside_joint_6_mz_5 + screws.inside_joint_6_mz_4);
    let three_joint_6_x_1_0 = poses.rotation_link_5_yy * inertias.composite_link_6_xx
        - inertias.inside_joint_6_my_0_1_0
        - (poses.rotation_link_5_yy * inertias.composite_link_6_zz
            + inertias.inside_joint_6_my_0_0)
        - (screws.inside_joint_6_my_4 - screws.inside_joint_6_my_5);
    let three_joint_6_y_0_1_0 = three_joint_6_x_0_0_0_2 - three_joint_6_y_0_1_0_1
        - (three_joint_6_y_0_1_0_3 + three_joint_6_y_0_1_0_3);
    let three_joint_6_y_1_0 = inertias.inside_joint_6_mx_0_1
        - poses.rotation_link_6_xz * inertias.composite_link_6_zz
        + (poses.rotation_link_6_xz * inertias.composite_link_6_yy
            - inertias.inside_joint_6_mx_0_0_1)
        - (screws.inside_joint_6_mx_5 - screws.inside_joint_6_mx_4);
    let three_joint_6_z_1_0 = three_joint_6_z_1_0_1 + three_joint_6_z_1_0_1
        - (three_joint_6_y_0_1_0_1 + three_joint_6_x_0_0_0_3);
    let three_joint_7_x_0_0_0_1_1 = poses.minus_rotation_link_6_yy
        * inertias.inertia_link_7_xz;
    let three_joint_7_x_0_0_0_1_0 = poses.rotation_link_6_zy
        * inertias.minus_inertia_link_7_xy;
    let three_joint_7_x_0_0_0_1 = three_joint_7_x_0_0_0_1_0 - three_joint_7_x_0_0_0_1_1;
    let three_joint_7_y_0_1_0_1_0 = poses.minus_rotation_link_6_xy
        * inertias.inertia_link_7_yz;
    let three_joint_7_y_0_1_0_1 = three_joint_7_y_0_1_0_1_0 - three_joint_7_x_0_0_0_1_0;
    let three_joint_7_z_1_0_1 = three_joint_7_x_0_0_0_1_1 - three_joint_7_y_0_1_0_1_0;
    let three_joint_7_y_0_1_0_3_1 = inertias.minus_inertia_link_7_hx
        * screws.screw_joint_7_vx;
    let three_joint_7_x_0_0_0_3_1 = inertias.minus_inertia_link_7_hy
        * screws.screw_joint_7_vy;
    let three_joint_7_x_0_0_0_2_1 = inertias.inertia_link_7_hz * screws.screw_joint_7_vz;
    let three_joint_7_x_0_0_0_3 = three_joint_7_x_0_0_0_3_1 + three_joint_7_x_0_0_0_3_1;
    let three_joint_7_x_0_0_0_2 = three_joint_7_x_0_0_0_2_1 + three_joint_7_x_0_0_0_2_1;
    let three_joint_7_y_0_1_0_3 = three_joint_7_y_0_1_0_3_1 + three_joint_7_y_0_1_0_3_1;
    let three_joint_7_x_0_0_0 = three_joint_7_x_0_0_0_1 + three_joint_7_x_0_0_0_1
        + (three_joint_7_x_0_0_0_2 - three_joint_7_x_0_0_0_3);
    let three_joint_7_x_0_1_0 = poses.rotation_link_6_zy * inertias.inertia_link_7_xx
        + inertias.inside_joint_7_mz_0_1_0
        - (inertias.inside_joint_7_mz_0_1_1
            + poses.rotation_link_6_zy * inertias.inertia_link_7_yy)
        + (screws.inside_joint_7_mz_5 + screws.inside_joint_7_mz_4);
    let three_joint_7_x_1_0 = inertias.inside_joint_7_my_0_0_0
        + poses.minus_rotation_link_6_yy * inertias.inertia_link_7_xx
        - (poses.minus_rotation_link_6_yy * inertias.inertia_link_7_zz
            + inertias.inside_joint_7_my_0_1)
        - (screws.inside_joint_7_my_4 - screws.inside_joint_7_my_5);
    let three_joint_7_y_0_1_0 = three_joint_7_y_0_1_0_1 + three_joint_7_y_0_1_0_1
        + (three_joint_7_x_0_0_0_2 - three_joint_7_y_0_1_0_3);
    let three_joint_7_y_1_0 = inertias.inside_joint_7_mx_0_1
        + poses.minus_rotation_link_6_xy * inertias.inertia_link_7_zz
        - (poses.minus_rotation_link_6_xy * inertias.inertia_link_7_yy
            + inertias.inside_joint_7_mx_0_0_0)
        - (screws.inside_joint_7_mx_5 - screws.inside_joint_7_mx_4);
    let three_joint_7_z_1_0 = three_joint_7_z_1_0_1 + three_joint_7_z_1_0_1
        - (three_joint_7_y_0_1_0_3 + three_joint_7_x_0_0_0_3);
    CommonDMuAnd7More {
        three_joint_2_x_0_0_0,
        three_joint_2_x_0_1_0,
        three_joint_2_x_1_0,
        three_joint_2_y_0_0_0,
        three_joint_2_y_1_0,
        three_joint_2_z_1_0,
        three_joint_3_x_0_0_0,
        three_joint_3_x_0_1_0,
        three_joint_3_x_1_0,
        three_joint_3_y_0_1_0,
        three_joint_3_y_1_0,
        three_joint_3_z_1_0,
        three_joint_4_x_0_0_0,
        three_joint_4_x_0_1_0,
        three_joint_4_x_1_0,
        three_joint_4_y_0_1_0,
        three_joint_4_y_1_0,
        three_joint_4_z_1_0,
        three_joint_5_x_0_0_0,
        three_joint_5_x_0_1_0,
        three_joint_5_x_1_0,
        three_joint_5_y_0_1_0,
        three_joint_5_y_1_0,
        three_joint_5_z_1_0,
        three_joint_6_x_0_0_0,
        three_joint_6_x_0_1_0,
        three_joint_6_x_1_0,
        three_joint_6_y_0_1_0,
        three_joint_6_y_1_0,
        three_joint_6_z_1_0,
        three_joint_7_x_0_0_0,
        three_joint_7_x_0_1_0,
        three_joint_7_x_1_0,
        three_joint_7_y_0_1_0,
        three_joint_7_y_1_0,
        three_joint_7_z_1_0,
    }
}
/// What `d_mu`, `b2`, `curvature` have in common.
struct CommonDMuB2Curvature {
    d_mu_7_6_0_0_1_0_1_0_0_0: f64,
    d_mu_7_6_0_0_1_0_1_0_1_0: f64,
    d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0: f64,
    d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_8_7_0_0_0_0_0_1_0_1_1_0: f64,
    d_mu_8_7_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_8_7_0_0_0_0_1_0_1_1_0: f64,
    d_mu_8_7_0_0_0_1_0_1_1_0: f64,
    d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0: f64,
    d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_9_8_0_0_0_0_0_1_0_1_1_0: f64,
    d_mu_9_8_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_9_8_0_0_0_0_1_0_1_1_0: f64,
    d_mu_9_8_0_0_0_1_0_1_1_0: f64,
    d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0: f64,
    d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_10_9_0_0_0_0_0_1_0_1_1_0: f64,
    d_mu_10_9_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_10_9_0_0_0_0_1_0_1_1_0: f64,
    d_mu_10_9_0_0_0_1_0_1_1_0: f64,
    d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0: f64,
    d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_11_10_0_0_0_0_0_1_0_1_1_0: f64,
    d_mu_11_10_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_11_10_0_0_0_0_1_0_1_1_0: f64,
    d_mu_11_10_0_0_0_1_0_1_1_0: f64,
    d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0: f64,
    d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_12_11_0_0_0_0_0_1_0_1_1_0: f64,
    d_mu_12_11_0_0_0_0_1_0_1_0_1_0: f64,
    d_mu_12_11_0_0_0_0_1_0_1_1_0: f64,
    d_mu_12_11_0_0_0_1_0_1_1_0: f64,
}
/// What `d_mu`, `b2`, `curvature` have in common.
#[inline(never)]
fn common_d_mu_b2_curvature(
    poses: &Poses,
    inertias: &Inertias,
    complements: &Complements,
    screws: &Screws,
) -> CommonDMuB2Curvature {
    let d_mu_7_6_0_0_1_0_1_0_0_0_3 = inertias.minus_inertia_base_hy
        * poses.minus_origin_base_x;
    let d_mu_7_6_0_0_1_0_1_0_0_0 = inertias.minus_inertia_base_xy
        + inertias.minus_inertia_base_xy
        - (d_mu_7_6_0_0_1_0_1_0_0_0_3 + d_mu_7_6_0_0_1_0_1_0_0_0_3);
    let d_mu_7_6_0_0_1_0_1_0_1_0 = inertias.inertia_base_xx - inertias.inertia_base_yy
        - (inertias.inertia_base_xx_1 - inertias.inertia_base_yy_1);
    let d_mu_8_7_0_0_0_1_0_1_1_0_1_0 = poses.cos_joint_1
        * complements.complement_link_2_xz;
    let d_mu_8_7_0_0_0_1_0_1_1_0_1_1 = poses.sin_joint_1
        * complements.minus_complement_link_2_yz;
    let d_mu_8_7_0_0_0_1_0_1_1_0_1 = d_mu_8_7_0_0_0_1_0_1_1_0_1_0
        - d_mu_8_7_0_0_0_1_0_1_1_0_1_1;
    let d_mu_8_7_0_0_0_0_1_0_1_0_1_0_3_1 = complements.minus_complement_link_2_hx
        * screws.screw_joint_2_vx;
    let d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_0_1 = complements.complement_link_2_hy
        * screws.screw_joint_2_vy;
    let d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_1_1 = complements.complement_link_2_hz
        * screws.screw_joint_2_vz;
    let d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_0 = d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_0_1
        + d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_0_1;
    let d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_1 = d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_1_1
        + d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_1_1;
    let d_mu_8_7_0_0_0_0_1_0_1_0_1_0_3 = d_mu_8_7_0_0_0_0_1_0_1_0_1_0_3_1
        + d_mu_8_7_0_0_0_0_1_0_1_0_1_0_3_1;
    let d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0 = d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_0
        + d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_1
        - (d_mu_8_7_0_0_0_1_0_1_1_0_1_0 + d_mu_8_7_0_0_0_1_0_1_1_0_1_0);
    let d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0 = complements.outside_joint_2_mz_0_1
        - complements.outside_joint_2_mz_0_0
        - (screws.outside_joint_2_mz_1_1 - screws.outside_joint_2_mz_1_0);
    let d_mu_8_7_0_0_0_0_0_1_0_1_1_0 = complements.outside_joint_2_my_0_0
        + poses.cos_joint_1 * complements.complement_link_2_xx
        - poses.cos_joint_1 * complements.complement_link_2_zz
        - (screws.outside_joint_2_my_1_0 - screws.outside_joint_2_my_1_1);
    let d_mu_8_7_0_0_0_0_1_0_1_0_1_0 = d_mu_8_7_0_0_0_1_0_1_1_0_1_1
        + d_mu_8_7_0_0_0_1_0_1_1_0_1_1
        + (d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_1 - d_mu_8_7_0_0_0_0_1_0_1_0_1_0_3);
    let d_mu_8_7_0_0_0_0_1_0_1_1_0 = poses.sin_joint_1 * complements.complement_link_2_yy
        + complements.outside_joint_2_mx_0_1
        - poses.sin_joint_1 * complements.complement_link_2_zz
        - (screws.outside_joint_2_mx_1_0 + screws.outside_joint_2_mx_1_1);
    let d_mu_8_7_0_0_0_1_0_1_1_0 = d_mu_8_7_0_0_0_1_0_1_1_0_1
        + d_mu_8_7_0_0_0_1_0_1_1_0_1
        + (d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0_0 - d_mu_8_7_0_0_0_0_1_0_1_0_1_0_3);
    let d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_3_0 = poses.minus_rotation_link_2_yy
        * complements.complement_link_3_xz;
    let d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_3_1 = poses.cos_joint_2
        * complements.complement_link_3_xy;
    let d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_3 = d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_3_0
        + d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_3_1;
    let d_mu_9_8_0_0_0_0_1_0_1_0_1_0_1_1 = poses.minus_rotation_link_2_xy
        * complements.complement_link_3_yz;
    let d_mu_9_8_0_0_0_0_1_0_1_0_1_0_1 = d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_3_1
        + d_mu_9_8_0_0_0_0_1_0_1_0_1_0_1_1;
    let d_mu_9_8_0_0_0_1_0_1_1_0_1 = d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_3_0
        - d_mu_9_8_0_0_0_0_1_0_1_0_1_0_1_1;
    let d_mu_9_8_0_0_0_0_1_0_1_0_1_0_2_1 = complements.complement_link_3_hx
        * screws.screw_joint_3_vx;
    let d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_0_1 = complements.complement_link_3_hy
        * screws.screw_joint_3_vy;
    let d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_1_1 = complements.complement_link_3_hz
        * screws.screw_joint_3_vz;
    let d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_0 = d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_0_1
        + d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_0_1;
    let d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_1 = d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_1_1
        + d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_1_1;
    let d_mu_9_8_0_0_0_0_1_0_1_0_1_0_2 = d_mu_9_8_0_0_0_0_1_0_1_0_1_0_2_1
        + d_mu_9_8_0_0_0_0_1_0_1_0_1_0_2_1;
    let d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0 = d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_0
        + d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_1
        - (d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_3 + d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_3);
    let d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0 = poses.cos_joint_2
        * complements.complement_link_3_xx + complements.outside_joint_3_mz_0_1_0
        - (complements.outside_joint_3_mz_0_1_1
            + poses.cos_joint_2 * complements.complement_link_3_yy)
        - (screws.outside_joint_3_mz_1_0 + screws.outside_joint_3_mz_1_1);
    let d_mu_9_8_0_0_0_0_0_1_0_1_1_0 = poses.minus_rotation_link_2_yy
        * complements.complement_link_3_xx - complements.outside_joint_3_my_0_1_0
        - (poses.minus_rotation_link_2_yy * complements.complement_link_3_zz
            + complements.outside_joint_3_my_0_0)
        - (screws.outside_joint_3_my_1_1 + screws.outside_joint_3_my_1_0);
    let d_mu_9_8_0_0_0_0_1_0_1_0_1_0 = d_mu_9_8_0_0_0_0_1_0_1_0_1_0_1
        + d_mu_9_8_0_0_0_0_1_0_1_0_1_0_1
        + (d_mu_9_8_0_0_0_0_1_0_1_0_1_0_2 + d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_1);
    let d_mu_9_8_0_0_0_0_1_0_1_1_0 = complements.outside_joint_3_mx_0_0
        + poses.minus_rotation_link_2_xy * complements.complement_link_3_zz
        + (complements.outside_joint_3_mx_0_1_1
            - poses.minus_rotation_link_2_xy * complements.complement_link_3_yy)
        - (screws.outside_joint_3_mx_1_0 + screws.outside_joint_3_mx_1_1);
    let d_mu_9_8_0_0_0_1_0_1_1_0 = d_mu_9_8_0_0_0_1_0_1_1_0_1
        + d_mu_9_8_0_0_0_1_0_1_1_0_1
        + (d_mu_9_8_0_0_0_0_1_0_1_0_1_0_2 + d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0_0);
    let d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_1_0 = poses.rotation_link_3_yy
        * complements.complement_link_4_xz;
    let d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_1_1 = poses.minus_rotation_link_3_zy
        * complements.complement_link_4_xy;
    let d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_1 = d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_1_0
        + d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_1_1;
    let d_mu_10_9_0_0_0_0_1_0_1_0_1_0_1_0 = poses.minus_rotation_link_3_xy
        * complements.complement_link_4_yz;
    let d_mu_10_9_0_0_0_0_1_0_1_0_1_0_1 = d_mu_10_9_0_0_0_0_1_0_1_0_1_0_1_0
        - d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_1_1;
    let d_mu_10_9_0_0_0_1_0_1_1_0_3 = d_mu_10_9_0_0_0_0_1_0_1_0_1_0_1_0
        + d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_1_0;
    let d_mu_10_9_0_0_0_0_1_0_1_0_1_0_2_1 = complements.complement_link_4_hx
        * screws.screw_joint_4_vx;
    let d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_2_1 = complements.complement_link_4_hy
        * screws.minus_screw_joint_4_vy;
    let d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_3_1 = complements.complement_link_4_hz
        * screws.minus_screw_joint_4_vz;
    let d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_2 = d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_2_1
        + d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_2_1;
    let d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_3 = d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_3_1
        + d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_3_1;
    let d_mu_10_9_0_0_0_0_1_0_1_0_1_0_2 = d_mu_10_9_0_0_0_0_1_0_1_0_1_0_2_1
        + d_mu_10_9_0_0_0_0_1_0_1_0_1_0_2_1;
    let d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0 = d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_1
        + d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_1
        - (d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_2 + d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_3);
    let d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0 = complements.outside_joint_4_mz_0_0_0
        + poses.minus_rotation_link_3_zy * complements.complement_link_4_yy
        + (complements.outside_joint_4_mz_0_0_1
            - poses.minus_rotation_link_3_zy * complements.complement_link_4_xx)
        - (screws.outside_joint_4_mz_1_1 - screws.outside_joint_4_mz_1_0);
    let d_mu_10_9_0_0_0_0_0_1_0_1_1_0 = poses.rotation_link_3_yy
        * complements.complement_link_4_zz + complements.outside_joint_4_my_0_1
        - (complements.outside_joint_4_my_0_0_1
            + poses.rotation_link_3_yy * complements.complement_link_4_xx)
        - (screws.outside_joint_4_my_1_0 - screws.outside_joint_4_my_1_1);
    let d_mu_10_9_0_0_0_0_1_0_1_0_1_0 = d_mu_10_9_0_0_0_0_1_0_1_0_1_0_1
        + d_mu_10_9_0_0_0_0_1_0_1_0_1_0_1
        + (d_mu_10_9_0_0_0_0_1_0_1_0_1_0_2 - d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_3);
    let d_mu_10_9_0_0_0_0_1_0_1_1_0 = poses.minus_rotation_link_3_xy
        * complements.complement_link_4_zz - complements.outside_joint_4_mx_0_1
        - (poses.minus_rotation_link_3_xy * complements.complement_link_4_yy
            + complements.outside_joint_4_mx_0_0_0)
        + (screws.outside_joint_4_mx_1_1 + screws.outside_joint_4_mx_1_0);
    let d_mu_10_9_0_0_0_1_0_1_1_0 = d_mu_10_9_0_0_0_0_1_0_1_0_1_0_2
        - d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0_2
        - (d_mu_10_9_0_0_0_1_0_1_1_0_3 + d_mu_10_9_0_0_0_1_0_1_1_0_3);
    let d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_3_0 = poses.rotation_link_4_yy
        * complements.complement_link_5_xz;
    let d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_3_1 = poses.rotation_link_5_zz
        * complements.complement_link_5_xy;
    let d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_3 = d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_3_0
        + d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_3_1;
    let d_mu_11_10_0_0_0_0_1_0_1_0_1_0_1_1 = poses.rotation_link_4_xy
        * complements.complement_link_5_yz;
    let d_mu_11_10_0_0_0_0_1_0_1_0_1_0_1 = d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_3_1
        + d_mu_11_10_0_0_0_0_1_0_1_0_1_0_1_1;
    let d_mu_11_10_0_0_0_1_0_1_1_0_1 = d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_3_0
        - d_mu_11_10_0_0_0_0_1_0_1_0_1_0_1_1;
    let d_mu_11_10_0_0_0_0_1_0_1_0_1_0_2_1 = complements.complement_link_5_hx
        * screws.screw_joint_5_vx;
    let d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_0_1 = complements.complement_link_5_hy
        * screws.screw_joint_5_vy;
    let d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_1_1 = complements.complement_link_5_hz
        * screws.screw_joint_5_vz;
    let d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_0 = d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_0_1
        + d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_0_1;
    let d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_1 = d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_1_1
        + d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_1_1;
    let d_mu_11_10_0_0_0_0_1_0_1_0_1_0_2 = d_mu_11_10_0_0_0_0_1_0_1_0_1_0_2_1
        + d_mu_11_10_0_0_0_0_1_0_1_0_1_0_2_1;
    let d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0 = d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_0
        + d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_1
        - (d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_3 + d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_3);
    let d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0 = poses.rotation_link_5_zz
        * complements.complement_link_5_xx + complements.outside_joint_5_mz_0_1_0
        - (complements.outside_joint_5_mz_0_1_1
            + poses.rotation_link_5_zz * complements.complement_link_5_yy)
        - (screws.outside_joint_5_mz_1_0 + screws.outside_joint_5_mz_1_1);
    let d_mu_11_10_0_0_0_0_0_1_0_1_1_0 = poses.rotation_link_4_yy
        * complements.complement_link_5_xx - complements.outside_joint_5_my_0_1_0
        - (poses.rotation_link_4_yy * complements.complement_link_5_zz
            + complements.outside_joint_5_my_0_0)
        - (screws.outside_joint_5_my_1_1 + screws.outside_joint_5_my_1_0);
    let d_mu_11_10_0_0_0_0_1_0_1_0_1_0 = d_mu_11_10_0_0_0_0_1_0_1_0_1_0_1
        + d_mu_11_10_0_0_0_0_1_0_1_0_1_0_1
        + (d_mu_11_10_0_0_0_0_1_0_1_0_1_0_2 + d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_1);
    let d_mu_11_10_0_0_0_0_1_0_1_1_0 = complements.outside_joint_5_mx_0_0
        + poses.rotation_link_4_xy * complements.complement_link_5_zz
        + (complements.outside_joint_5_mx_0_1_1
            - poses.rotation_link_4_xy * complements.complement_link_5_yy)
        - (screws.outside_joint_5_mx_1_0 + screws.outside_joint_5_mx_1_1);
    let d_mu_11_10_0_0_0_1_0_1_1_0 = d_mu_11_10_0_0_0_1_0_1_1_0_1
        + d_mu_11_10_0_0_0_1_0_1_1_0_1
        + (d_mu_11_10_0_0_0_0_1_0_1_0_1_0_2 + d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0_0);
    let d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_3_0 = poses.rotation_link_5_yy
        * complements.complement_link_6_xz;
    let d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_3_1 = poses.rotation_link_6_zz
        * complements.complement_link_6_xy;
    let d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_3 = d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_3_0
        + d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_3_1;
    let d_mu_12_11_0_0_0_0_1_0_1_0_1_0_1_1 = poses.rotation_link_6_xz
        * complements.complement_link_6_yz;
    let d_mu_12_11_0_0_0_0_1_0_1_0_1_0_1 = d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_3_1
        - d_mu_12_11_0_0_0_0_1_0_1_0_1_0_1_1;
    let d_mu_12_11_0_0_0_1_0_1_1_0_1 = d_mu_12_11_0_0_0_0_1_0_1_0_1_0_1_1
        + d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_3_0;
    let d_mu_12_11_0_0_0_0_1_0_1_0_1_0_2_1 = complements.complement_link_6_hx
        * screws.screw_joint_6_vx;
    let d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_0_1 = complements.complement_link_6_hy
        * screws.screw_joint_6_vy;
    let d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_1_1 = complements.complement_link_6_hz
        * screws.screw_joint_6_vz;
    let d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_0 = d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_0_1
        + d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_0_1;
    let d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_1 = d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_1_1
        + d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_1_1;
    let d_mu_12_11_0_0_0_0_1_0_1_0_1_0_2 = d_mu_12_11_0_0_0_0_1_0_1_0_1_0_2_1
        + d_mu_12_11_0_0_0_0_1_0_1_0_1_0_2_1;
    let d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0 = d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_0
        + d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_1
        - (d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_3 + d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_3);
    let d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0 = poses.rotation_link_6_zz
        * complements.complement_link_6_xx - complements.outside_joint_6_mz_0_0_0
        - (complements.outside_joint_6_mz_0_0_1
            + poses.rotation_link_6_zz * complements.complement_link_6_yy)
        - (screws.outside_joint_6_mz_1_0 + screws.outside_joint_6_mz_1_1);
    let d_mu_12_11_0_0_0_0_0_1_0_1_1_0 = complements.outside_joint_6_my_0_0_0
        + poses.rotation_link_5_yy * complements.complement_link_6_xx
        - (poses.rotation_link_5_yy * complements.complement_link_6_zz
            + complements.outside_joint_6_my_0_1)
        - (screws.outside_joint_6_my_1_1 + screws.outside_joint_6_my_1_0);
    let d_mu_12_11_0_0_0_0_1_0_1_0_1_0 = d_mu_12_11_0_0_0_0_1_0_1_0_1_0_1
        + d_mu_12_11_0_0_0_0_1_0_1_0_1_0_1
        + (d_mu_12_11_0_0_0_0_1_0_1_0_1_0_2 + d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_1);
    let d_mu_12_11_0_0_0_0_1_0_1_1_0 = complements.outside_joint_6_mx_0_1
        - poses.rotation_link_6_xz * complements.complement_link_6_zz
        + (poses.rotation_link_6_xz * complements.complement_link_6_yy
            + complements.outside_joint_6_mx_0_0_1)
        - (screws.outside_joint_6_mx_1_0 + screws.outside_joint_6_mx_1_1);
    let d_mu_12_11_0_0_0_1_0_1_1_0 = d_mu_12_11_0_0_0_1_0_1_1_0_1
        + d_mu_12_11_0_0_0_1_0_1_1_0_1
        + (d_mu_12_11_0_0_0_0_1_0_1_0_1_0_2 + d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0_0);
    CommonDMuB2Curvature {
        d_mu_7_6_0_0_1_0_1_0_0_0,
        d_mu_7_6_0_0_1_0_1_0_1_0,
        d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0,
        d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0,
        d_mu_8_7_0_0_0_0_0_1_0_1_1_0,
        d_mu_8_7_0_0_0_0_1_0_1_0_1_0,
        d_mu_8_7_0_0_0_0_1_0_1_1_0,
        d_mu_8_7_0_0_0_1_0_1_1_0,
        d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0,
        d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0,
        d_mu_9_8_0_0_0_0_0_1_0_1_1_0,
        d_mu_9_8_0_0_0_0_1_0_1_0_1_0,
        d_mu_9_8_0_0_0_0_1_0_1_1_0,
        d_mu_9_8_0_0_0_1_0_1_1_0,
        d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0,
        d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0,
        d_mu_10_9_0_0_0_0_0_1_0_1_1_0,
        d_mu_10_9_0_0_0_0_1_0_1_0_1_0,
        d_mu_10_9_0_0_0_0_1_0_1_1_0,
        d_mu_10_9_0_0_0_1_0_1_1_0,
        d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0,
        d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0,
        d_mu_11_10_0_0_0_0_0_1_0_1_1_0,
        d_mu_11_10_0_0_0_0_1_0_1_0_1_0,
        d_mu_11_10_0_0_0_0_1_0_1_1_0,
        d_mu_11_10_0_0_0_1_0_1_1_0,
        d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0,
        d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0,
        d_mu_12_11_0_0_0_0_0_1_0_1_1_0,
        d_mu_12_11_0_0_0_0_1_0_1_0_1_0,
        d_mu_12_11_0_0_0_0_1_0_1_1_0,
        d_mu_12_11_0_0_0_1_0_1_1_0,
    }
}
/// What `d_mu`, `b2` have in common.
struct CommonDMuB2 {
    d_mu_7_6: f64,
    d_mu_8_6: f64,
    d_mu_9_6: f64,
    d_mu_10_6: f64,
    d_mu_11_6: f64,
    d_mu_12_6: f64,
    d_mu_8_7: f64,
    d_mu_9_7: f64,
    d_mu_10_7: f64,
    d_mu_11_7: f64,
    d_mu_12_7: f64,
    d_mu_9_8: f64,
    d_mu_10_8: f64,
    d_mu_11_8: f64,
    d_mu_12_8: f64,
    d_mu_10_9: f64,
    d_mu_11_9: f64,
    d_mu_12_9: f64,
    d_mu_11_10: f64,
    d_mu_12_10: f64,
    d_mu_12_11: f64,
}
/// What `d_mu`, `b2` have in common.
#[inline(never)]
fn common_d_mu_b2(
    mu: &[f64; 6],
    inertias: &Inertias,
    screws: &Screws,
    outside: &Outside,
    reactions: &Reactions,
    common_d_mu_and_7_more: &CommonDMuAnd7More,
    common_d_mu_b2_curvature: &CommonDMuB2Curvature,
) -> CommonDMuB2 {
    let d_mu_7_6_8_1 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let d_mu_7_6_6_3 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let d_mu_7_6_6_1 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let d_mu_8_7_14_1 = mu[0] * 35.0;
    let d_mu_8_7_12_3 = mu[1] * 35.0;
    let d_mu_8_7_12_1 = mu[2] * 35.0;
    let d_mu_7_6_6 = reactions.reaction_joint_1_wy * d_mu_7_6_6_1
        - reactions.reaction_joint_1_wz * d_mu_7_6_6_3
        - (common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_0_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_1_0 * mu[1]
            - outside.outside_joint_1_my * mu[2]);
    let d_mu_7_6_8 = reactions.reaction_joint_1_wz * d_mu_7_6_8_1
        - reactions.reaction_joint_1_wx * d_mu_7_6_6_1
        - (common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_1_0 * mu[0]
            + outside.outside_joint_1_mx * mu[2]);
    let d_mu_7_6_10 = reactions.reaction_joint_1_wx * d_mu_7_6_6_3
        - reactions.reaction_joint_1_wy * d_mu_7_6_8_1
        - (outside.outside_joint_1_mx * mu[1] - outside.outside_joint_1_my * mu[0]
            + common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_0_0 * mu[2]);
    let three_joint_2_x = common_d_mu_and_7_more.three_joint_2_x_0_0_0 * mu[0]
        - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_2_x_1_0 * mu[2];
    let three_joint_2_y = common_d_mu_and_7_more.three_joint_2_y_0_0_0 * mu[1]
        - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_2_y_1_0 * mu[2];
    let three_joint_2_z = common_d_mu_and_7_more.three_joint_2_x_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_2_y_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_2_z_1_0 * mu[2];
    let d_mu_8_7_6 = reactions.reaction_joint_2_wy * d_mu_7_6_6_1
        - reactions.reaction_joint_2_wz * d_mu_7_6_6_3
        - (common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_8_7_8 = reactions.reaction_joint_2_wz * d_mu_7_6_8_1
        - reactions.reaction_joint_2_wx * d_mu_7_6_6_1
        - (common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_0_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_8_7_10 = reactions.reaction_joint_2_wx * d_mu_7_6_6_3
        - reactions.reaction_joint_2_wy * d_mu_7_6_8_1
        - (common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_1_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_8_7_12 = reactions.reaction_joint_2_vy * d_mu_8_7_12_1
        - reactions.reaction_joint_2_vz * d_mu_8_7_12_3;
    let d_mu_8_7_14 = reactions.reaction_joint_2_vz * d_mu_8_7_14_1
        - reactions.reaction_joint_2_vx * d_mu_8_7_12_1;
    let d_mu_8_7_16 = reactions.reaction_joint_2_vx * d_mu_8_7_12_3
        - reactions.reaction_joint_2_vy * d_mu_8_7_14_1;
    let three_joint_3_x = common_d_mu_and_7_more.three_joint_3_x_0_0_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_3_x_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_3_x_1_0 * mu[2];
    let three_joint_3_y = common_d_mu_and_7_more.three_joint_3_x_0_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_3_y_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * mu[2];
    let three_joint_3_z = common_d_mu_and_7_more.three_joint_3_x_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_3_z_1_0 * mu[2];
    let d_mu_9_8_6 = reactions.reaction_joint_3_wy * d_mu_7_6_6_1
        - reactions.reaction_joint_3_wz * d_mu_7_6_6_3
        - (common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_9_8_8 = reactions.reaction_joint_3_wz * d_mu_7_6_8_1
        - reactions.reaction_joint_3_wx * d_mu_7_6_6_1
        - (common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_0_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_9_8_10 = reactions.reaction_joint_3_wx * d_mu_7_6_6_3
        - reactions.reaction_joint_3_wy * d_mu_7_6_8_1
        - (common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_1_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_9_8_12 = reactions.reaction_joint_3_vy * d_mu_8_7_12_1
        - reactions.reaction_joint_3_vz * d_mu_8_7_12_3;
    let d_mu_9_8_14 = reactions.reaction_joint_3_vz * d_mu_8_7_14_1
        - reactions.reaction_joint_3_vx * d_mu_8_7_12_1;
    let d_mu_9_8_16 = reactions.reaction_joint_3_vx * d_mu_8_7_12_3
        - reactions.reaction_joint_3_vy * d_mu_8_7_14_1;
    let three_joint_4_x = common_d_mu_and_7_more.three_joint_4_x_0_0_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_4_x_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_4_x_1_0 * mu[2];
    let three_joint_4_y = common_d_mu_and_7_more.three_joint_4_x_0_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_4_y_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * mu[2];
    let three_joint_4_z = common_d_mu_and_7_more.three_joint_4_x_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * mu[1]
        - common_d_mu_and_7_more.three_joint_4_z_1_0 * mu[2];
    let d_mu_10_9_6 = reactions.reaction_joint_4_wy * d_mu_7_6_6_1
        - reactions.reaction_joint_4_wz * d_mu_7_6_6_3
        - (common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_10_9_8 = reactions.reaction_joint_4_wz * d_mu_7_6_8_1
        - reactions.reaction_joint_4_wx * d_mu_7_6_6_1
        - (common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_0_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_10_9_10 = reactions.reaction_joint_4_wx * d_mu_7_6_6_3
        - reactions.reaction_joint_4_wy * d_mu_7_6_8_1
        - (common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_1_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_10_9_12 = reactions.reaction_joint_4_vy * d_mu_8_7_12_1
        + reactions.minus_reaction_joint_4_vz * d_mu_8_7_12_3;
    let d_mu_10_9_14 = reactions.minus_reaction_joint_4_vz * d_mu_8_7_14_1
        + reactions.reaction_joint_4_vx * d_mu_8_7_12_1;
    let d_mu_10_9_16 = reactions.reaction_joint_4_vx * d_mu_8_7_12_3
        - reactions.reaction_joint_4_vy * d_mu_8_7_14_1;
    let three_joint_5_x = common_d_mu_and_7_more.three_joint_5_x_0_0_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_5_x_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_5_x_1_0 * mu[2];
    let three_joint_5_y = common_d_mu_and_7_more.three_joint_5_x_0_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_5_y_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * mu[2];
    let three_joint_5_z = common_d_mu_and_7_more.three_joint_5_x_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_5_z_1_0 * mu[2];
    let d_mu_11_10_6 = reactions.reaction_joint_5_wy * d_mu_7_6_6_1
        - reactions.reaction_joint_5_wz * d_mu_7_6_6_3
        - (common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_11_10_8 = reactions.reaction_joint_5_wz * d_mu_7_6_8_1
        - reactions.reaction_joint_5_wx * d_mu_7_6_6_1
        - (common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_0_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_11_10_10 = reactions.reaction_joint_5_wx * d_mu_7_6_6_3
        - reactions.reaction_joint_5_wy * d_mu_7_6_8_1
        - (common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_1_0 * mu[0]
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_1_0 * mu[1]
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_1_0_1_1_0 * mu[2]);
    let d_mu_11_10_12 = reactions.reaction_joint_5_vy * d_mu_8_7_12_1
        - reactions.reaction_joint_5_vz * d_mu_8_7_12_3;
    let d_mu_11_10_14 = reactions.reaction_joint_5_vz * d_mu_8_7_14_1
        - reactions.reaction_joint_5_vx * d_mu_8_7_12_1;
    let d_mu_11_10_16 = reactions.reaction_joint_5_vx * d_mu_8_7_12_3
        - reactions.reaction_joint_5_vy * d_mu_8_7_14_1;
    let three_joint_6_x = common_d_mu_and_7_more.three_joint_6_x_0_0_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_6_x_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_6_x_1_0 * mu[2];
    let three_joint_6_y = common_d_mu_and_7_more.three_joint_6_x_0_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_6_y_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * mu[2];
    let three_joint_6_z = common_d_mu_and_7_more.three_joint_6_x_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_6_z_1_0 * mu[2];
    let three_joint_7_x = common_d_mu_and_7_more.three_joint_7_x_0_0_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_7_x_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_7_x_1_0 * mu[2];
    let three_joint_7_y = common_d_mu_and_7_more.three_joint_7_x_0_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_7_y_0_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * mu[2];
    let three_joint_7_z = common_d_mu_and_7_more.three_joint_7_x_1_0 * mu[0]
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * mu[1]
        + common_d_mu_and_7_more.three_joint_7_z_1_0 * mu[2];
    let d_mu_7_6 = reactions.reaction_joint_1_wx * three_joint_2_x
        + reactions.reaction_joint_1_wy * three_joint_2_y
        + reactions.reaction_joint_1_wz * three_joint_2_z
        + d_mu_7_6_6 * screws.connection_joint_2_wx
        + d_mu_7_6_8 * screws.connection_joint_2_wy
        + d_mu_7_6_10 * screws.connection_joint_2_wz;
    let d_mu_8_6 = reactions.reaction_joint_1_wx * three_joint_3_x
        + reactions.reaction_joint_1_wy * three_joint_3_y
        + reactions.reaction_joint_1_wz * three_joint_3_z
        + d_mu_7_6_6 * screws.connection_joint_3_wx
        + d_mu_7_6_8 * screws.connection_joint_3_wy
        + d_mu_7_6_10 * screws.connection_joint_3_wz;
    let d_mu_9_6 = reactions.reaction_joint_1_wx * three_joint_4_x
        + reactions.reaction_joint_1_wy * three_joint_4_y
        + reactions.reaction_joint_1_wz * three_joint_4_z
        + d_mu_7_6_6 * screws.connection_joint_4_wx
        + d_mu_7_6_8 * screws.connection_joint_4_wy
        + d_mu_7_6_10 * screws.connection_joint_4_wz;
    let d_mu_10_6 = reactions.reaction_joint_1_wx * three_joint_5_x
        + reactions.reaction_joint_1_wy * three_joint_5_y
        + reactions.reaction_joint_1_wz * three_joint_5_z
        + d_mu_7_6_6 * screws.connection_joint_5_wx
        + d_mu_7_6_8 * screws.connection_joint_5_wy
        + d_mu_7_6_10 * screws.connection_joint_5_wz;
    let d_mu_11_6 = reactions.reaction_joint_1_wx * three_joint_6_x
        + reactions.reaction_joint_1_wy * three_joint_6_y
        + reactions.reaction_joint_1_wz * three_joint_6_z
        + d_mu_7_6_6 * screws.connection_joint_6_wx
        + d_mu_7_6_8 * screws.connection_joint_6_wy
        + d_mu_7_6_10 * screws.connection_joint_6_wz;
    let d_mu_12_6 = reactions.reaction_joint_1_wx * three_joint_7_x
        + reactions.reaction_joint_1_wy * three_joint_7_y
        + reactions.reaction_joint_1_wz * three_joint_7_z
        + d_mu_7_6_6 * screws.connection_joint_7_wx
        + d_mu_7_6_8 * screws.connection_joint_7_wy
        + d_mu_7_6_10 * screws.connection_joint_7_wz;
    let d_mu_8_7 = reactions.reaction_joint_2_wx * three_joint_3_x
        + reactions.reaction_joint_2_wy * three_joint_3_y
        + reactions.reaction_joint_2_wz * three_joint_3_z
        + d_mu_8_7_6 * screws.connection_joint_3_wx
        + d_mu_8_7_8 * screws.connection_joint_3_wy
        + d_mu_8_7_10 * screws.connection_joint_3_wz
        + d_mu_8_7_12 * screws.connection_joint_3_vx
        + d_mu_8_7_14 * screws.connection_joint_3_vy
        + d_mu_8_7_16 * screws.connection_joint_3_vz;
    let d_mu_9_7 = reactions.reaction_joint_2_wx * three_joint_4_x
        + reactions.reaction_joint_2_wy * three_joint_4_y
        + reactions.reaction_joint_2_wz * three_joint_4_z
        + d_mu_8_7_6 * screws.connection_joint_4_wx
        + d_mu_8_7_8 * screws.connection_joint_4_wy
        + d_mu_8_7_10 * screws.connection_joint_4_wz
        + d_mu_8_7_12 * screws.connection_joint_4_vx
        + d_mu_8_7_14 * screws.connection_joint_4_vy
        + d_mu_8_7_16 * screws.connection_joint_4_vz;
    let d_mu_10_7 = reactions.reaction_joint_2_wx * three_joint_5_x
        + reactions.reaction_joint_2_wy * three_joint_5_y
        + reactions.reaction_joint_2_wz * three_joint_5_z
        + d_mu_8_7_6 * screws.connection_joint_5_wx
        + d_mu_8_7_8 * screws.connection_joint_5_wy
        + d_mu_8_7_10 * screws.connection_joint_5_wz
        + d_mu_8_7_12 * screws.connection_joint_5_vx
        + d_mu_8_7_14 * screws.connection_joint_5_vy
        + d_mu_8_7_16 * screws.connection_joint_5_vz;
    let d_mu_11_7 = reactions.reaction_joint_2_wx * three_joint_6_x
        + reactions.reaction_joint_2_wy * three_joint_6_y
        + reactions.reaction_joint_2_wz * three_joint_6_z
        + d_mu_8_7_6 * screws.connection_joint_6_wx
        + d_mu_8_7_8 * screws.connection_joint_6_wy
        + d_mu_8_7_10 * screws.connection_joint_6_wz
        + d_mu_8_7_12 * screws.connection_joint_6_vx
        + d_mu_8_7_14 * screws.connection_joint_6_vy
        + d_mu_8_7_16 * screws.connection_joint_6_vz;
    let d_mu_12_7 = reactions.reaction_joint_2_wx * three_joint_7_x
        + reactions.reaction_joint_2_wy * three_joint_7_y
        + reactions.reaction_joint_2_wz * three_joint_7_z
        + d_mu_8_7_6 * screws.connection_joint_7_wx
        + d_mu_8_7_8 * screws.connection_joint_7_wy
        + d_mu_8_7_10 * screws.connection_joint_7_wz
        + d_mu_8_7_12 * screws.connection_joint_7_vx
        + d_mu_8_7_14 * screws.connection_joint_7_vy
        + d_mu_8_7_16 * screws.connection_joint_7_vz;
    let d_mu_9_8 = reactions.reaction_joint_3_wx * three_joint_4_x
        + reactions.reaction_joint_3_wy * three_joint_4_y
        + reactions.reaction_joint_3_wz * three_joint_4_z
        + d_mu_9_8_6 * screws.connection_joint_4_wx
        + d_mu_9_8_8 * screws.connection_joint_4_wy
        + d_mu_9_8_10 * screws.connection_joint_4_wz
        + d_mu_9_8_12 * screws.connection_joint_4_vx
        + d_mu_9_8_14 * screws.connection_joint_4_vy
        + d_mu_9_8_16 * screws.connection_joint_4_vz;
    let d_mu_10_8 = reactions.reaction_joint_3_wx * three_joint_5_x
        + reactions.reaction_joint_3_wy * three_joint_5_y
        + reactions.reaction_joint_3_wz * three_joint_5_z
        + d_mu_9_8_6 * screws.connection_joint_5_wx
        + d_mu_9_8_8 * screws.connection_joint_5_wy
        + d_mu_9_8_10 * screws.connection_joint_5_wz
        + d_mu_9_8_12 * screws.connection_joint_5_vx
        + d_mu_9_8_14 * screws.connection_joint_5_vy
        + d_mu_9_8_16 * screws.connection_joint_5_vz;
    let d_mu_11_8 = reactions.reaction_joint_3_wx * three_joint_6_x
        + reactions.reaction_joint_3_wy * three_joint_6_y
        + reactions.reaction_joint_3_wz * three_joint_6_z
        + d_mu_9_8_6 * screws.connection_joint_6_wx
        + d_mu_9_8_8 * screws.connection_joint_6_wy
        + d_mu_9_8_10 * screws.connection_joint_6_wz
        + d_mu_9_8_12 * screws.connection_joint_6_vx
        + d_mu_9_8_14 * screws.connection_joint_6_vy
        + d_mu_9_8_16 * screws.connection_joint_6_vz;
    let d_mu_12_8 = reactions.reaction_joint_3_wx * three_joint_7_x
        + reactions.reaction_joint_3_wy * three_joint_7_y
        + reactions.reaction_joint_3_wz * three_joint_7_z
        + d_mu_9_8_6 * screws.connection_joint_7_wx
        + d_mu_9_8_8 * screws.connection_joint_7_wy
        + d_mu_9_8_10 * screws.connection_joint_7_wz
        + d_mu_9_8_12 * screws.connection_joint_7_vx
        + d_mu_9_8_14 * screws.connection_joint_7_vy
        + d_mu_9_8_16 * screws.connection_joint_7_vz;
    let d_mu_10_9 = reactions.reaction_joint_4_wx * three_joint_5_x
        + reactions.reaction_joint_4_wy * three_joint_5_y
        + reactions.reaction_joint_4_wz * three_joint_5_z
        + d_mu_10_9_6 * screws.connection_joint_5_wx
        + d_mu_10_9_8 * screws.connection_joint_5_wy
        + d_mu_10_9_10 * screws.connection_joint_5_wz
        + d_mu_10_9_12 * screws.connection_joint_5_vx
        - d_mu_10_9_14 * screws.connection_joint_5_vy
        + d_mu_10_9_16 * screws.connection_joint_5_vz;
    let d_mu_11_9 = reactions.reaction_joint_4_wx * three_joint_6_x
        + reactions.reaction_joint_4_wy * three_joint_6_y
        + reactions.reaction_joint_4_wz * three_joint_6_z
        + d_mu_10_9_6 * screws.connection_joint_6_wx
        + d_mu_10_9_8 * screws.connection_joint_6_wy
        + d_mu_10_9_10 * screws.connection_joint_6_wz
        + d_mu_10_9_12 * screws.connection_joint_6_vx
        - d_mu_10_9_14 * screws.connection_joint_6_vy
        + d_mu_10_9_16 * screws.connection_joint_6_vz;
    let d_mu_12_9 = reactions.reaction_joint_4_wx * three_joint_7_x
        + reactions.reaction_joint_4_wy * three_joint_7_y
        + reactions.reaction_joint_4_wz * three_joint_7_z
        + d_mu_10_9_6 * screws.connection_joint_7_wx
        + d_mu_10_9_8 * screws.connection_joint_7_wy
        + d_mu_10_9_10 * screws.connection_joint_7_wz
        + d_mu_10_9_12 * screws.connection_joint_7_vx
        - d_mu_10_9_14 * screws.connection_joint_7_vy
        + d_mu_10_9_16 * screws.connection_joint_7_vz;
    let d_mu_11_10 = reactions.reaction_joint_5_wx * three_joint_6_x
        + reactions.reaction_joint_5_wy * three_joint_6_y
        + reactions.reaction_joint_5_wz * three_joint_6_z
        + d_mu_11_10_6 * screws.connection_joint_6_wx
        + d_mu_11_10_8 * screws.connection_joint_6_wy
        + d_mu_11_10_10 * screws.connection_joint_6_wz
        + d_mu_11_10_12 * screws.connection_joint_6_vx
        + d_mu_11_10_14 * screws.connection_joint_6_vy
        + d_mu_11_10_16 * screws.connection_joint_6_vz;
    let d_mu_12_10 = reactions.reaction_joint_5_wx * three_joint_7_x
        + reactions.reaction_joint_5_wy * three_joint_7_y
        + reactions.reaction_joint_5_wz * three_joint_7_z
        + d_mu_11_10_6 * screws.connection_joint_7_wx
        + d_mu_11_10_8 * screws.connection_joint_7_wy
        + d_mu_11_10_10 * screws.connection_joint_7_wz
        + d_mu_11_10_12 * screws.connection_joint_7_vx
        + d_mu_11_10_14 * screws.connection_joint_7_vy
        + d_mu_11_10_16 * screws.connection_joint_7_vz;
    let d_mu_12_11 = reactions.reaction_joint_6_wx * three_joint_7_x
        + reactions.reaction_joint_6_wy * three_joint_7_y
        + reactions.reaction_joint_6_wz * three_joint_7_z
        + (reactions.reaction_joint_6_wy * d_mu_7_6_6_1
            - reactions.reaction_joint_6_wz * d_mu_7_6_6_3
            - (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0 * mu[0]
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0 * mu[1]
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_1_0 * mu[2]))
            * screws.connection_joint_7_wx
        + (reactions.reaction_joint_6_wz * d_mu_7_6_8_1
            - reactions.reaction_joint_6_wx * d_mu_7_6_6_1
            - (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0 * mu[0]
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_0_1_0 * mu[1]
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_1_0 * mu[2]))
            * screws.connection_joint_7_wy
        + (reactions.reaction_joint_6_wx * d_mu_7_6_6_3
            - reactions.reaction_joint_6_wy * d_mu_7_6_8_1
            - (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_1_0 * mu[0]
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_1_0 * mu[1]
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_1_0_1_1_0 * mu[2]))
            * screws.connection_joint_7_wz
        + (reactions.reaction_joint_6_vy * d_mu_8_7_12_1
            - reactions.reaction_joint_6_vz * d_mu_8_7_12_3)
            * screws.connection_joint_7_vx
        + (reactions.reaction_joint_6_vz * d_mu_8_7_14_1
            - reactions.reaction_joint_6_vx * d_mu_8_7_12_1)
            * screws.connection_joint_7_vy
        + (reactions.reaction_joint_6_vx * d_mu_8_7_12_3
            - reactions.reaction_joint_6_vy * d_mu_8_7_14_1)
            * screws.connection_joint_7_vz;
    CommonDMuB2 {
        d_mu_7_6,
        d_mu_8_6,
        d_mu_9_6,
        d_mu_10_6,
        d_mu_11_6,
        d_mu_12_6,
        d_mu_8_7,
        d_mu_9_7,
        d_mu_10_7,
        d_mu_11_7,
        d_mu_12_7,
        d_mu_9_8,
        d_mu_10_8,
        d_mu_11_8,
        d_mu_12_8,
        d_mu_10_9,
        d_mu_11_9,
        d_mu_12_9,
        d_mu_11_10,
        d_mu_12_10,
        d_mu_12_11,
    }
}
/// What `coupling_torque`, `d_mu_xi` have in common.
struct CommonCouplingTorqueDMuXi {
    coupling_torque_0_26: f64,
    coupling_torque_0_28: f64,
    coupling_torque_0_21: f64,
    coupling_torque_0: f64,
    coupling_torque_1: f64,
    coupling_torque_2: f64,
    coupling_torque_3: f64,
    coupling_torque_4: f64,
    coupling_torque_5: f64,
    coupling_torque_6_11: f64,
    coupling_torque_6_13: f64,
    coupling_torque_6_6: f64,
    coupling_torque_6: f64,
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
        + inertias.composite_link_1_yy * mu[1] + inertias.composite_link_1_yz * mu[2];
    let coupling_torque_0_6 = inertias.composite_link_1_xz * mu[0]
        + inertias.composite_link_1_yz * mu[1] + inertias.composite_link_1_zz * mu[2];
    let coupling_torque_0_26 = inertias.inertia_base_xx * mu[0]
        - inertias.minus_inertia_base_xy * mu[1]
        - inertias.minus_inertia_base_xz * mu[2];
    let coupling_torque_0_28 = inertias.inertia_base_yy * mu[1]
        - inertias.minus_inertia_base_xy * mu[0]
        - inertias.minus_inertia_base_yz * mu[2];
    let coupling_torque_0_21 = inertias.inertia_base_zz * mu[2]
        - (inertias.minus_inertia_base_xz * mu[0]
            + inertias.minus_inertia_base_yz * mu[1]);
    let coupling_torque_0_39 = mu[1] * inertias.minus_inertia_base_hx
        - mu[0] * inertias.minus_inertia_base_hy;
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
            - screws.minus_connection_joint_1_vx
                * ((mu[0] * inertias.minus_inertia_base_hz
                    - mu[2] * inertias.minus_inertia_base_hx) * mu[2]
                    - coupling_torque_0_39 * mu[1])
            + screws.connection_joint_1_vy
                * (coupling_torque_0_39 * mu[0]
                    - (mu[2] * inertias.minus_inertia_base_hy
                        - mu[1] * inertias.minus_inertia_base_hz) * mu[2]));
    let coupling_torque_1_11 = inertias.composite_link_2_xx * mu[0]
        + inertias.composite_link_2_xy * mu[1] + inertias.composite_link_2_xz * mu[2];
    let coupling_torque_1_13 = inertias.composite_link_2_xy * mu[0]
        + inertias.composite_link_2_yy * mu[1] + inertias.composite_link_2_yz * mu[2];
    let coupling_torque_1_6 = inertias.composite_link_2_xz * mu[0]
        + inertias.composite_link_2_yz * mu[1] + inertias.composite_link_2_zz * mu[2];
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
        - complements.minus_complement_link_2_yz * mu[2];
    let coupling_torque_1_36 = complements.complement_link_2_xz * mu[0]
        - complements.minus_complement_link_2_yz * mu[1]
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
    let coupling_torque_2_11 = inertias.composite_link_3_xx * mu[0]
        + inertias.composite_link_3_xy * mu[1] + inertias.composite_link_3_xz * mu[2];
    let coupling_torque_2_13 = inertias.composite_link_3_xy * mu[0]
        + inertias.composite_link_3_yy * mu[1] + inertias.composite_link_3_yz * mu[2];
    let coupling_torque_2_6 = inertias.composite_link_3_xz * mu[0]
        + inertias.composite_link_3_yz * mu[1] + inertias.composite_link_3_zz * mu[2];
    let coupling_torque_2_26 = mu[1] * inertias.composite_link_3_hz
        - mu[2] * inertias.composite_link_3_hy;
    let coupling_torque_2_28 = mu[2] * inertias.composite_link_3_hx
        - mu[0] * inertias.composite_link_3_hz;
    let coupling_torque_2_21 = mu[0] * inertias.composite_link_3_hy
        - mu[1] * inertias.composite_link_3_hx;
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
    let coupling_torque_3_11 = inertias.composite_link_4_xx * mu[0]
        + inertias.composite_link_4_xy * mu[1] + inertias.composite_link_4_xz * mu[2];
    let coupling_torque_3_13 = inertias.composite_link_4_xy * mu[0]
        + inertias.composite_link_4_yy * mu[1] + inertias.composite_link_4_yz * mu[2];
    let coupling_torque_3_6 = inertias.composite_link_4_xz * mu[0]
        + inertias.composite_link_4_yz * mu[1] + inertias.composite_link_4_zz * mu[2];
    let coupling_torque_3_26 = mu[1] * inertias.composite_link_4_hz
        - mu[2] * inertias.composite_link_4_hy;
    let coupling_torque_3_28 = mu[2] * inertias.minus_composite_link_4_hx
        + mu[0] * inertias.composite_link_4_hz;
    let coupling_torque_3_21 = mu[0] * inertias.composite_link_4_hy
        + mu[1] * inertias.minus_composite_link_4_hx;
    let coupling_torque_3_41 = complements.complement_link_4_xx * mu[0]
        + complements.complement_link_4_xy * mu[1]
        + complements.complement_link_4_xz * mu[2];
    let coupling_torque_3_43 = complements.complement_link_4_xy * mu[0]
        + complements.complement_link_4_yy * mu[1]
        + complements.complement_link_4_yz * mu[2];
    let coupling_torque_3_36 = complements.complement_link_4_xz * mu[0]
        + complements.complement_link_4_yz * mu[1]
        + complements.complement_link_4_zz * mu[2];
    let coupling_torque_3_56 = mu[1] * complements.complement_link_4_hz
        - mu[2] * complements.complement_link_4_hy;
    let coupling_torque_3_58 = mu[2] * complements.complement_link_4_hx
        - mu[0] * complements.complement_link_4_hz;
    let coupling_torque_3_51 = mu[0] * complements.complement_link_4_hy
        - mu[1] * complements.complement_link_4_hx;
    let coupling_torque_3 = reactions.reaction_joint_4_wx
        * (coupling_torque_3_13 * mu[2] - coupling_torque_3_6 * mu[1])
        + reactions.reaction_joint_4_wy
            * (coupling_torque_3_6 * mu[0] - coupling_torque_3_11 * mu[2])
        + reactions.reaction_joint_4_wz
            * (coupling_torque_3_11 * mu[1] - coupling_torque_3_13 * mu[0])
        - reactions.reaction_joint_4_vx
            * (coupling_torque_3_28 * mu[2] + coupling_torque_3_21 * mu[1])
        + reactions.reaction_joint_4_vy
            * (coupling_torque_3_21 * mu[0] - coupling_torque_3_26 * mu[2])
        - reactions.minus_reaction_joint_4_vz
            * (coupling_torque_3_26 * mu[1] + coupling_torque_3_28 * mu[0])
        - (screws.connection_joint_4_wx
            * (coupling_torque_3_43 * mu[2] - coupling_torque_3_36 * mu[1])
            + screws.connection_joint_4_wy
                * (coupling_torque_3_36 * mu[0] - coupling_torque_3_41 * mu[2])
            + screws.connection_joint_4_wz
                * (coupling_torque_3_41 * mu[1] - coupling_torque_3_43 * mu[0])
            + screws.connection_joint_4_vx
                * (coupling_torque_3_58 * mu[2] - coupling_torque_3_51 * mu[1])
            + screws.connection_joint_4_vy
                * (coupling_torque_3_51 * mu[0] - coupling_torque_3_56 * mu[2])
            + screws.connection_joint_4_vz
                * (coupling_torque_3_56 * mu[1] - coupling_torque_3_58 * mu[0]));
    let coupling_torque_4_11 = inertias.composite_link_5_xx * mu[0]
        + inertias.composite_link_5_xy * mu[1] + inertias.composite_link_5_xz * mu[2];
    let coupling_torque_4_13 = inertias.composite_link_5_xy * mu[0]
        + inertias.composite_link_5_yy * mu[1] + inertias.composite_link_5_yz * mu[2];
    let coupling_torque_4_6 = inertias.composite_link_5_xz * mu[0]
        + inertias.composite_link_5_yz * mu[1] + inertias.composite_link_5_zz * mu[2];
    let coupling_torque_4_26 = mu[1] * inertias.composite_link_5_hz
        - mu[2] * inertias.composite_link_5_hy;
    let coupling_torque_4_28 = mu[2] * inertias.minus_composite_link_5_hx
        + mu[0] * inertias.composite_link_5_hz;
    let coupling_torque_4_21 = mu[0] * inertias.composite_link_5_hy
        + mu[1] * inertias.minus_composite_link_5_hx;
    let coupling_torque_4_41 = complements.complement_link_5_xx * mu[0]
        + complements.complement_link_5_xy * mu[1]
        + complements.complement_link_5_xz * mu[2];
    let coupling_torque_4_43 = complements.complement_link_5_xy * mu[0]
        + complements.complement_link_5_yy * mu[1]
        + complements.complement_link_5_yz * mu[2];
    let coupling_torque_4_36 = complements.complement_link_5_xz * mu[0]
        + complements.complement_link_5_yz * mu[1]
        + complements.complement_link_5_zz * mu[2];
    let coupling_torque_4_56 = mu[1] * complements.complement_link_5_hz
        - mu[2] * complements.complement_link_5_hy;
    let coupling_torque_4_58 = mu[2] * complements.complement_link_5_hx
        - mu[0] * complements.complement_link_5_hz;
    let coupling_torque_4_51 = mu[0] * complements.complement_link_5_hy
        - mu[1] * complements.complement_link_5_hx;
    let coupling_torque_4 = reactions.reaction_joint_5_wx
        * (coupling_torque_4_13 * mu[2] - coupling_torque_4_6 * mu[1])
        + reactions.reaction_joint_5_wy
            * (coupling_torque_4_6 * mu[0] - coupling_torque_4_11 * mu[2])
        + reactions.reaction_joint_5_wz
            * (coupling_torque_4_11 * mu[1] - coupling_torque_4_13 * mu[0])
        - reactions.reaction_joint_5_vx
            * (coupling_torque_4_28 * mu[2] + coupling_torque_4_21 * mu[1])
        + reactions.reaction_joint_5_vy
            * (coupling_torque_4_21 * mu[0] - coupling_torque_4_26 * mu[2])
        + reactions.reaction_joint_5_vz
            * (coupling_torque_4_26 * mu[1] + coupling_torque_4_28 * mu[0])
        - (screws.connection_joint_5_wx
            * (coupling_torque_4_43 * mu[2] - coupling_torque_4_36 * mu[1])
            + screws.connection_joint_5_wy
                * (coupling_torque_4_36 * mu[0] - coupling_torque_4_41 * mu[2])
            + screws.connection_joint_5_wz
                * (coupling_torque_4_41 * mu[1] - coupling_torque_4_43 * mu[0])
            + screws.connection_joint_5_vx
                * (coupling_torque_4_58 * mu[2] - coupling_torque_4_51 * mu[1])
            + screws.connection_joint_5_vy
                * (coupling_torque_4_51 * mu[0] - coupling_torque_4_56 * mu[2])
            + screws.connection_joint_5_vz
                * (coupling_torque_4_56 * mu[1] - coupling_torque_4_58 * mu[0]));
    let coupling_torque_5_11 = inertias.composite_link_6_xx * mu[0]
        - inertias.minus_composite_link_6_xy * mu[1]
        + inertias.composite_link_6_xz * mu[2];
    let coupling_torque_5_13 = inertias.composite_link_6_yy * mu[1]
        - inertias.minus_composite_link_6_xy * mu[0]
        + inertias.composite_link_6_yz * mu[2];
    let coupling_torque_5_6 = inertias.composite_link_6_xz * mu[0]
        + inertias.composite_link_6_yz * mu[1] + inertias.composite_link_6_zz * mu[2];
    let coupling_torque_5_26 = mu[1] * inertias.composite_link_6_hz
        + mu[2] * inertias.minus_composite_link_6_hy;
    let coupling_torque_5_28 = mu[2] * inertias.minus_composite_link_6_hx
        + mu[0] * inertias.composite_link_6_hz;
    let coupling_torque_5_21 = mu[1] * inertias.minus_composite_link_6_hx
        - mu[0] * inertias.minus_composite_link_6_hy;
    let coupling_torque_5_41 = complements.complement_link_6_xx * mu[0]
        + complements.complement_link_6_xy * mu[1]
        + complements.complement_link_6_xz * mu[2];
    let coupling_torque_5_43 = complements.complement_link_6_xy * mu[0]
        + complements.complement_link_6_yy * mu[1]
        + complements.complement_link_6_yz * mu[2];
    let coupling_torque_5_36 = complements.complement_link_6_xz * mu[0]
        + complements.complement_link_6_yz * mu[1]
        + complements.complement_link_6_zz * mu[2];
    let coupling_torque_5_56 = mu[1] * complements.complement_link_6_hz
        - mu[2] * complements.complement_link_6_hy;
    let coupling_torque_5_58 = mu[2] * complements.complement_link_6_hx
        - mu[0] * complements.complement_link_6_hz;
    let coupling_torque_5_51 = mu[0] * complements.complement_link_6_hy
        - mu[1] * complements.complement_link_6_hx;
    let coupling_torque_5 = reactions.reaction_joint_6_wx
        * (coupling_torque_5_13 * mu[2] - coupling_torque_5_6 * mu[1])
        + reactions.reaction_joint_6_wy
            * (coupling_torque_5_6 * mu[0] - coupling_torque_5_11 * mu[2])
        + reactions.reaction_joint_6_wz
            * (coupling_torque_5_11 * mu[1] - coupling_torque_5_13 * mu[0])
        - reactions.reaction_joint_6_vx
            * (coupling_torque_5_28 * mu[2] + coupling_torque_5_21 * mu[1])
        + reactions.reaction_joint_6_vy
            * (coupling_torque_5_21 * mu[0] - coupling_torque_5_26 * mu[2])
        + reactions.reaction_joint_6_vz
            * (coupling_torque_5_26 * mu[1] + coupling_torque_5_28 * mu[0])
        - (screws.connection_joint_6_wx
            * (coupling_torque_5_43 * mu[2] - coupling_torque_5_36 * mu[1])
            + screws.connection_joint_6_wy
                * (coupling_torque_5_36 * mu[0] - coupling_torque_5_41 * mu[2])
            + screws.connection_joint_6_wz
                * (coupling_torque_5_41 * mu[1] - coupling_torque_5_43 * mu[0])
            + screws.connection_joint_6_vx
                * (coupling_torque_5_58 * mu[2] - coupling_torque_5_51 * mu[1])
            + screws.connection_joint_6_vy
                * (coupling_torque_5_51 * mu[0] - coupling_torque_5_56 * mu[2])
            + screws.connection_joint_6_vz
                * (coupling_torque_5_56 * mu[1] - coupling_torque_5_58 * mu[0]));
    let coupling_torque_6_11 = inertias.inertia_link_7_xx * mu[0]
        - inertias.minus_inertia_link_7_xy * mu[1] + inertias.inertia_link_7_xz * mu[2];
    let coupling_torque_6_13 = inertias.inertia_link_7_yy * mu[1]
        - inertias.minus_inertia_link_7_xy * mu[0] + inertias.inertia_link_7_yz * mu[2];
    let coupling_torque_6_6 = inertias.inertia_link_7_xz * mu[0]
        + inertias.inertia_link_7_yz * mu[1] + inertias.inertia_link_7_zz * mu[2];
    let coupling_torque_6_26 = mu[1] * inertias.inertia_link_7_hz
        + mu[2] * inertias.minus_inertia_link_7_hy;
    let coupling_torque_6_28 = mu[2] * inertias.minus_inertia_link_7_hx
        + mu[0] * inertias.inertia_link_7_hz;
    let coupling_torque_6_21 = mu[1] * inertias.minus_inertia_link_7_hx
        - mu[0] * inertias.minus_inertia_link_7_hy;
    let coupling_torque_6_41 = complements.complement_link_7_xx * mu[0]
        + complements.complement_link_7_xy * mu[1]
        + complements.complement_link_7_xz * mu[2];
    let coupling_torque_6_43 = complements.complement_link_7_xy * mu[0]
        + complements.complement_link_7_yy * mu[1]
        + complements.complement_link_7_yz * mu[2];
    let coupling_torque_6_36 = complements.complement_link_7_xz * mu[0]
        + complements.complement_link_7_yz * mu[1]
        + complements.complement_link_7_zz * mu[2];
    let coupling_torque_6_56 = mu[1] * complements.complement_link_7_hz
        - mu[2] * complements.complement_link_7_hy;
    let coupling_torque_6_58 = mu[2] * complements.complement_link_7_hx
        - mu[0] * complements.complement_link_7_hz;
    let coupling_torque_6_51 = mu[0] * complements.complement_link_7_hy
        - mu[1] * complements.complement_link_7_hx;
    let coupling_torque_6 = reactions.reaction_joint_7_wx
        * (coupling_torque_6_13 * mu[2] - coupling_torque_6_6 * mu[1])
        + reactions.reaction_joint_7_wy
            * (coupling_torque_6_6 * mu[0] - coupling_torque_6_11 * mu[2])
        + reactions.reaction_joint_7_wz
            * (coupling_torque_6_11 * mu[1] - coupling_torque_6_13 * mu[0])
        - reactions.reaction_joint_7_vx
            * (coupling_torque_6_28 * mu[2] + coupling_torque_6_21 * mu[1])
        + reactions.reaction_joint_7_vy
            * (coupling_torque_6_21 * mu[0] - coupling_torque_6_26 * mu[2])
        + reactions.reaction_joint_7_vz
            * (coupling_torque_6_26 * mu[1] + coupling_torque_6_28 * mu[0])
        - (screws.connection_joint_7_wx
            * (coupling_torque_6_43 * mu[2] - coupling_torque_6_36 * mu[1])
            + screws.connection_joint_7_wy
                * (coupling_torque_6_36 * mu[0] - coupling_torque_6_41 * mu[2])
            + screws.connection_joint_7_wz
                * (coupling_torque_6_41 * mu[1] - coupling_torque_6_43 * mu[0])
            + screws.connection_joint_7_vx
                * (coupling_torque_6_58 * mu[2] - coupling_torque_6_51 * mu[1])
            + screws.connection_joint_7_vy
                * (coupling_torque_6_51 * mu[0] - coupling_torque_6_56 * mu[2])
            + screws.connection_joint_7_vz
                * (coupling_torque_6_56 * mu[1] - coupling_torque_6_58 * mu[0]));
    CommonCouplingTorqueDMuXi {
        coupling_torque_0_26,
        coupling_torque_0_28,
        coupling_torque_0_21,
        coupling_torque_0,
        coupling_torque_1,
        coupling_torque_2,
        coupling_torque_3,
        coupling_torque_4,
        coupling_torque_5,
        coupling_torque_6_11,
        coupling_torque_6_13,
        coupling_torque_6_6,
        coupling_torque_6,
    }
}
/// What `forward_dynamics`, `inverse_dynamics` have in common.
struct CommonForwardDynamicsInverseDynamics {
    wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0: f64,
    wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1: f64,
    wrench_link_7_my_0_1_0_1_0_0_0_0_0_0: f64,
    wrench_link_7_mx_0_1_1_1_0_0_0_0_0_1: f64,
    wrench_link_7_mx_0_1_0_1_0_0_0_0_0_0: f64,
    wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_1: f64,
    wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_0: f64,
    wrench_link_7_mx_0_0_1_1_0_0_0_0_1: f64,
    wrench_link_7_my_0_1_0_1_0_0_0_0_0_1: f64,
    wrench_link_7_mx_0_1_1_1_0_0_0_0_0_0: f64,
    wrench_link_7_mx_0_1_0_1_0_0_0_0_0_1: f64,
    wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1: f64,
    wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1: f64,
    wrench_link_7_mx_0_0_1_1_0_0_0_0_0: f64,
    wrench_link_7_my_0_1_0_1_0_0_0_0_1: f64,
    wrench_link_7_mx_0_1_1_1_0_0_0_0_1: f64,
    wrench_link_7_mx_0_1_0_1_0_0_0_0_1: f64,
    wrench_link_7_mx_0_0_0_0_1_0_0_0_1: f64,
    wrench_link_7_mx_0_0_0_1_1_0_0_0_1: f64,
    wrench_link_7_mx_0_0_1_1_0_0_0_1: f64,
    wrench_link_7_my_0_1_0_1_0_0_0_1: f64,
    wrench_link_7_mx_0_1_1_1_0_0_0_1: f64,
    wrench_link_7_mx_0_1_0_1_0_0_0_1: f64,
    wrench_link_7_mx_0_0_0_0_1_0_0_1: f64,
    wrench_link_7_mx_0_0_0_1_1_0_0_1: f64,
    wrench_link_7_mx_0_0_1_1_0_0_1: f64,
    wrench_link_7_my_0_1_0_1_0_0_1: f64,
    wrench_link_7_mx_0_1_1_1_0_0_1: f64,
    wrench_link_7_mx_0_1_0_1_0_0_1: f64,
    wrench_link_7_mx_0_0_0_0_1_0_1: f64,
    wrench_link_7_mx_0_0_0_1_1_0_1: f64,
    wrench_link_7_mx_0_0_1_1_0_1: f64,
    wrench_link_7_my_0_1_0_1_0_1: f64,
    wrench_link_7_mx_0_1_1_1_0_1: f64,
    wrench_link_7_mx_0_1_0_1_0_1: f64,
    wrench_link_7_mx_0_0_0_0_1_1: f64,
    wrench_link_7_mx_0_0_0_1_1_1: f64,
    wrench_link_7_mx_0_0_1_1_1: f64,
    wrench_link_7_my_0_1_0_1_1: f64,
    wrench_link_7_mx_0_1_1_1_1: f64,
    wrench_link_7_mx_0_1_0_1_1: f64,
    wrench_base_mx_1_0: f64,
    wrench_base_my_1_0: f64,
    wrench_base_mz_1_0: f64,
    wrench_base_fx_1_0: f64,
    wrench_base_fy_1_0: f64,
    wrench_base_fz_1_0: f64,
    wrench_link_1_mx_0_1: f64,
    wrench_link_1_my_0_1: f64,
    wrench_link_1_mz_0_1: f64,
    wrench_link_1_fx_0_1: f64,
    wrench_link_1_fy_1_1: f64,
    wrench_link_1_fz_0_1: f64,
    wrench_link_2_mx_0_1: f64,
    wrench_link_2_my_0_1: f64,
    wrench_link_2_mz_0_1: f64,
    wrench_link_2_fx_0_1: f64,
    wrench_link_2_fy_0_1: f64,
    wrench_link_2_fz_0_1: f64,
    wrench_link_3_mx_0_1: f64,
    wrench_link_3_my_0_1: f64,
    wrench_link_3_mz_0_1: f64,
    wrench_link_3_fx_0_1: f64,
    wrench_link_3_fy_0_1: f64,
    wrench_link_3_fz_0_1: f64,
    wrench_link_4_mx_0_1: f64,
    wrench_link_4_my_0_1: f64,
    wrench_link_4_mz_0_1: f64,
    wrench_link_4_fx_0_1: f64,
    wrench_link_4_fy_0_1: f64,
    wrench_link_4_fz_0_1: f64,
    wrench_link_5_mx_0_1: f64,
    wrench_link_5_my_0_1: f64,
    wrench_link_5_mz_0_1: f64,
    wrench_link_5_fx_0_1: f64,
    wrench_link_5_fy_0_1: f64,
    wrench_link_5_fz_0_1: f64,
    wrench_link_6_mx_0_1: f64,
    wrench_link_6_my_0_1: f64,
    wrench_link_6_mz_0_1: f64,
    wrench_link_6_fx_0_1: f64,
    wrench_link_6_fy_0_1: f64,
    wrench_link_6_fz_0_1: f64,
    wrench_link_7_mx_1: f64,
    wrench_link_7_my_1: f64,
    wrench_link_7_mz_1: f64,
    wrench_link_7_fx_1: f64,
    wrench_link_7_fy_1: f64,
    wrench_link_7_fz_1: f64,
}
/// What `forward_dynamics`, `inverse_dynamics` have in common.
#[inline(never)]
fn common_forward_dynamics_inverse_dynamics(
    mu: &[f64; 6],
    qd: &[f64; 7],
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    velocities: &Velocities,
) -> CommonForwardDynamicsInverseDynamics {
    let wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0 = mu[0]
        - velocities.minus_velocity_base_wx;
    let wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0 = mu[1]
        - velocities.minus_velocity_base_wy;
    let wrench_base_my_1_0_2_5 = mu[2] - velocities.minus_velocity_base_wz;
    let wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1 = velocities.velocity_link_1_wz + mu[2];
    let wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0 = wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        * qd[0];
    let wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1 = wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        * qd[0];
    let wrench_link_7_my_0_1_0_1_0_0_0_0_0_0 = (velocities.velocity_link_1_vy
        - wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1 * poses.minus_origin_base_x) * qd[0];
    let wrench_link_7_mx_0_1_1_1_0_0_0_0_0_1 = (wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        * poses.minus_origin_base_y + velocities.velocity_link_1_vx) * qd[0];
    let wrench_link_7_mx_0_1_0_1_0_0_0_0_0_0 = (wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        * poses.minus_origin_base_x
        + wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0 * poses.minus_origin_base_y) * qd[0];
    let wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0 = velocities.velocity_link_2_wx + mu[0];
    let wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2 = mu[1]
        - velocities.minus_velocity_link_2_wy;
    let wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_1 = wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        * poses.cos_joint_1 * qd[1];
    let wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_0 = wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        * poses.sin_joint_1 * qd[1];
    let wrench_link_7_mx_0_0_1_1_0_0_0_0_1 = (wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0
        * poses.cos_joint_1 + wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2 * poses.sin_joint_1)
        * qd[1];
    let wrench_link_7_my_0_1_0_1_0_0_0_0_0_1 = (wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2
        * screws.screw_joint_2_vz
        - wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1 * screws.screw_joint_2_vy
        + velocities.velocity_link_2_vz * poses.cos_joint_1) * qd[1];
    let wrench_link_7_mx_0_1_1_1_0_0_0_0_0_0 = (wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        * screws.screw_joint_2_vx
        - wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0 * screws.screw_joint_2_vz
        + velocities.velocity_link_2_vz * poses.sin_joint_1) * qd[1];
    let wrench_link_7_mx_0_1_0_1_0_0_0_0_0_1 = (wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0
        * screws.screw_joint_2_vy
        - wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2 * screws.screw_joint_2_vx
        - (velocities.velocity_link_2_vx * poses.cos_joint_1
            + velocities.velocity_link_2_vy * poses.sin_joint_1)) * qd[1];
    let wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2 = velocities.velocity_link_3_wx + mu[0];
    let wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0 = mu[1]
        - velocities.minus_velocity_link_3_wy;
    let wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2 = velocities.velocity_link_3_wz + mu[2];
    let wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0
        * poses.cos_joint_2
        + wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2 * poses.minus_rotation_link_2_yy)
        * qd[2];
    let wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2
        * poses.minus_rotation_link_2_xy
        + wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2 * poses.cos_joint_2) * qd[2];
    let wrench_link_7_mx_0_0_1_1_0_0_0_0_0 = (wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0
        * poses.minus_rotation_link_2_xy
        - wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2 * poses.minus_rotation_link_2_yy)
        * qd[2];
    let wrench_link_7_my_0_1_0_1_0_0_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0
        * screws.screw_joint_3_vz
        - wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2 * screws.screw_joint_3_vy
        + (velocities.velocity_link_3_vy * poses.cos_joint_2
            + velocities.velocity_link_3_vz * poses.minus_rotation_link_2_yy)) * qd[2];
    let wrench_link_7_mx_0_1_1_1_0_0_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2
        * screws.screw_joint_3_vx
        - wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2 * screws.screw_joint_3_vz
        - (velocities.velocity_link_3_vz * poses.minus_rotation_link_2_xy
            + velocities.velocity_link_3_vx * poses.cos_joint_2)) * qd[2];
    let wrench_link_7_mx_0_1_0_1_0_0_0_0_1 = (wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2
        * screws.screw_joint_3_vy
        - wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0 * screws.screw_joint_3_vx
        + (velocities.velocity_link_3_vy * poses.minus_rotation_link_2_xy
            - velocities.velocity_link_3_vx * poses.minus_rotation_link_2_yy)) * qd[2];
    let wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0 = velocities.velocity_link_4_wx + mu[0];
    let wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0 = velocities.velocity_link_4_wy + mu[1];
    let wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2 = velocities.velocity_link_4_wz + mu[2];
    let wrench_link_7_mx_0_0_0_0_1_0_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0
        * poses.minus_rotation_link_3_zy
        + wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2 * poses.rotation_link_3_yy) * qd[3];
    let wrench_link_7_mx_0_0_0_1_1_0_0_0_1 = (wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0
        * poses.minus_rotation_link_3_zy
        - wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2 * poses.minus_rotation_link_3_xy) * qd[3];
    let wrench_link_7_mx_0_0_1_1_0_0_0_1 = (wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0
        * poses.rotation_link_3_yy
        + wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0 * poses.minus_rotation_link_3_xy) * qd[3];
    let wrench_link_7_my_0_1_0_1_0_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2
        * screws.minus_screw_joint_4_vy
        - wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0 * screws.minus_screw_joint_4_vz
        - (velocities.velocity_link_4_vy * poses.minus_rotation_link_3_zy
            + velocities.velocity_link_4_vz * poses.rotation_link_3_yy)) * qd[3];
    let wrench_link_7_mx_0_1_1_1_0_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2
        * screws.screw_joint_4_vx
        + wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0 * screws.minus_screw_joint_4_vz
        + (velocities.velocity_link_4_vx * poses.minus_rotation_link_3_zy
            - velocities.velocity_link_4_vz * poses.minus_rotation_link_3_xy)) * qd[3];
    let wrench_link_7_mx_0_1_0_1_0_0_0_1 = (velocities.velocity_link_4_vx
        * poses.rotation_link_3_yy
        + velocities.velocity_link_4_vy * poses.minus_rotation_link_3_xy
        - (wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0 * screws.minus_screw_joint_4_vy
            + wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0 * screws.screw_joint_4_vx)) * qd[3];
    let wrench_link_7_mx_0_0_0_1_1_0_0_1_2 = velocities.velocity_link_5_wx + mu[0];
    let wrench_link_7_mx_0_0_0_0_1_0_0_1_0 = velocities.velocity_link_5_wy + mu[1];
    let wrench_link_7_mx_0_0_0_0_1_0_0_1_2 = velocities.velocity_link_5_wz + mu[2];
    let wrench_link_7_mx_0_0_0_0_1_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_1_0
        * poses.rotation_link_5_zz
        + wrench_link_7_mx_0_0_0_0_1_0_0_1_2 * poses.rotation_link_4_yy) * qd[4];
    let wrench_link_7_mx_0_0_0_1_1_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_1_2
        * poses.rotation_link_4_xy
        + wrench_link_7_mx_0_0_0_1_1_0_0_1_2 * poses.rotation_link_5_zz) * qd[4];
    let wrench_link_7_mx_0_0_1_1_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_1_0
        * poses.rotation_link_4_xy
        - wrench_link_7_mx_0_0_0_1_1_0_0_1_2 * poses.rotation_link_4_yy) * qd[4];
    let wrench_link_7_my_0_1_0_1_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_1_0
        * screws.screw_joint_5_vz
        - wrench_link_7_mx_0_0_0_0_1_0_0_1_2 * screws.screw_joint_5_vy
        + (velocities.velocity_link_5_vy * poses.rotation_link_5_zz
            + velocities.velocity_link_5_vz * poses.rotation_link_4_yy)) * qd[4];
    let wrench_link_7_mx_0_1_1_1_0_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_0_1_2
        * screws.screw_joint_5_vx
        - wrench_link_7_mx_0_0_0_1_1_0_0_1_2 * screws.screw_joint_5_vz
        - (velocities.velocity_link_5_vz * poses.rotation_link_4_xy
            + velocities.velocity_link_5_vx * poses.rotation_link_5_zz)) * qd[4];
    let wrench_link_7_mx_0_1_0_1_0_0_1 = (wrench_link_7_mx_0_0_0_1_1_0_0_1_2
        * screws.screw_joint_5_vy
        - wrench_link_7_mx_0_0_0_0_1_0_0_1_0 * screws.screw_joint_5_vx
        + (velocities.velocity_link_5_vy * poses.rotation_link_4_xy
            - velocities.velocity_link_5_vx * poses.rotation_link_4_yy)) * qd[4];
    let wrench_link_7_mx_0_0_0_1_1_0_1_2 = velocities.velocity_link_6_wx + mu[0];
    let wrench_link_7_mx_0_0_0_0_1_0_1_0 = velocities.velocity_link_6_wy + mu[1];
    let wrench_link_7_mx_0_0_0_0_1_0_1_2 = velocities.velocity_link_6_wz + mu[2];
    let wrench_link_7_mx_0_0_0_0_1_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_1_0
        * poses.rotation_link_6_zz
        + wrench_link_7_mx_0_0_0_0_1_0_1_2 * poses.rotation_link_5_yy) * qd[5];
    let wrench_link_7_mx_0_0_0_1_1_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_1_2
        * poses.rotation_link_6_xz
        - wrench_link_7_mx_0_0_0_1_1_0_1_2 * poses.rotation_link_6_zz) * qd[5];
    let wrench_link_7_mx_0_0_1_1_0_1 = (wrench_link_7_mx_0_0_0_1_1_0_1_2
        * poses.rotation_link_5_yy
        + wrench_link_7_mx_0_0_0_0_1_0_1_0 * poses.rotation_link_6_xz) * qd[5];
    let wrench_link_7_my_0_1_0_1_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_1_0
        * screws.screw_joint_6_vz
        - wrench_link_7_mx_0_0_0_0_1_0_1_2 * screws.screw_joint_6_vy
        + (velocities.velocity_link_6_vy * poses.rotation_link_6_zz
            + velocities.velocity_link_6_vz * poses.rotation_link_5_yy)) * qd[5];
    let wrench_link_7_mx_0_1_1_1_0_1 = (wrench_link_7_mx_0_0_0_0_1_0_1_2
        * screws.screw_joint_6_vx
        - wrench_link_7_mx_0_0_0_1_1_0_1_2 * screws.screw_joint_6_vz
        + (velocities.velocity_link_6_vz * poses.rotation_link_6_xz
            - velocities.velocity_link_6_vx * poses.rotation_link_6_zz)) * qd[5];
    let wrench_link_7_mx_0_1_0_1_0_1 = (wrench_link_7_mx_0_0_0_1_1_0_1_2
        * screws.screw_joint_6_vy
        - wrench_link_7_mx_0_0_0_0_1_0_1_0 * screws.screw_joint_6_vx
        - (velocities.velocity_link_6_vx * poses.rotation_link_5_yy
            + velocities.velocity_link_6_vy * poses.rotation_link_6_xz)) * qd[5];
    let wrench_link_7_mx_0_0_0_1_1_1_2 = velocities.velocity_link_7_wx + mu[0];
    let wrench_link_7_mx_0_0_0_0_1_1_0 = velocities.velocity_link_7_wy + mu[1];
    let wrench_link_7_mx_0_0_0_0_1_1_2 = velocities.velocity_link_7_wz + mu[2];
    let wrench_link_7_mx_0_0_0_0_1_1 = (wrench_link_7_mx_0_0_0_0_1_1_0
        * poses.rotation_link_6_zy
        + wrench_link_7_mx_0_0_0_0_1_1_2 * poses.minus_rotation_link_6_yy) * qd[6];
    let wrench_link_7_mx_0_0_0_1_1_1 = (wrench_link_7_mx_0_0_0_0_1_1_2
        * poses.minus_rotation_link_6_xy
        + wrench_link_7_mx_0_0_0_1_1_1_2 * poses.rotation_link_6_zy) * qd[6];
    let wrench_link_7_mx_0_0_1_1_1 = (wrench_link_7_mx_0_0_0_0_1_1_0
        * poses.minus_rotation_link_6_xy
        - wrench_link_7_mx_0_0_0_1_1_1_2 * poses.minus_rotation_link_6_yy) * qd[6];
    let wrench_link_7_my_0_1_0_1_1 = (wrench_link_7_mx_0_0_0_0_1_1_0
        * screws.screw_joint_7_vz
        - wrench_link_7_mx_0_0_0_0_1_1_2 * screws.screw_joint_7_vy
        + (velocities.velocity_link_7_vy * poses.rotation_link_6_zy
            + velocities.velocity_link_7_vz * poses.minus_rotation_link_6_yy)) * qd[6];
    let wrench_link_7_mx_0_1_1_1_1 = (wrench_link_7_mx_0_0_0_0_1_1_2
        * screws.screw_joint_7_vx
        - wrench_link_7_mx_0_0_0_1_1_1_2 * screws.screw_joint_7_vz
        - (velocities.velocity_link_7_vz * poses.minus_rotation_link_6_xy
            + velocities.velocity_link_7_vx * poses.rotation_link_6_zy)) * qd[6];
    let wrench_link_7_mx_0_1_0_1_1 = (wrench_link_7_mx_0_0_0_1_1_1_2
        * screws.screw_joint_7_vy
        - wrench_link_7_mx_0_0_0_0_1_1_0 * screws.screw_joint_7_vx
        + (velocities.velocity_link_7_vy * poses.minus_rotation_link_6_xy
            - velocities.velocity_link_7_vx * poses.minus_rotation_link_6_yy)) * qd[6];
    let wrench_base_my_1_0_2 = inertias.inertia_base_xx
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        - inertias.minus_inertia_base_xy * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        - inertias.minus_inertia_base_xz * wrench_base_my_1_0_2_5
        + (velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hy
            - velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hz);
    let wrench_base_mx_1_0_0 = inertias.inertia_base_yy
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        - inertias.minus_inertia_base_xy * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        - inertias.minus_inertia_base_yz * wrench_base_my_1_0_2_5
        - (velocities.velocity_base_vx * inertias.minus_inertia_base_hz
            + velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hx);
    let wrench_base_mx_1_0_2 = inertias.inertia_base_zz * wrench_base_my_1_0_2_5
        - (inertias.minus_inertia_base_xz * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
            + inertias.minus_inertia_base_yz * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0)
        + (velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hx
            + velocities.velocity_base_vx * inertias.minus_inertia_base_hy);
    let wrench_base_my_1_0_6 = velocities.velocity_base_vx * 3.5
        + (wrench_base_my_1_0_2_5 * inertias.minus_inertia_base_hy
            - wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0 * inertias.minus_inertia_base_hz);
    let wrench_base_mx_1_0_6 = wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        * inertias.minus_inertia_base_hz
        - wrench_base_my_1_0_2_5 * inertias.minus_inertia_base_hx
        - velocities.minus_velocity_base_vy * 3.5;
    let wrench_base_mx_1_0_4 = wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        * inertias.minus_inertia_base_hx
        - wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0 * inertias.minus_inertia_base_hy
        - velocities.minus_velocity_base_vz * 3.5;
    let wrench_base_mx_1_0 = wrench_base_mx_1_0_0 * wrench_base_my_1_0_2_5
        - wrench_base_mx_1_0_2 * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        + (wrench_base_mx_1_0_4 * velocities.minus_velocity_base_vy
            - wrench_base_mx_1_0_6 * velocities.minus_velocity_base_vz);
    let wrench_base_my_1_0 = wrench_base_mx_1_0_2
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        - wrench_base_my_1_0_2 * wrench_base_my_1_0_2_5
        + (wrench_base_mx_1_0_4 * velocities.velocity_base_vx
            + wrench_base_my_1_0_6 * velocities.minus_velocity_base_vz);
    let wrench_base_mz_1_0 = wrench_base_my_1_0_2
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        - wrench_base_mx_1_0_0 * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        - (wrench_base_my_1_0_6 * velocities.minus_velocity_base_vy
            + wrench_base_mx_1_0_6 * velocities.velocity_base_vx);
    let wrench_base_fx_1_0 = wrench_base_mx_1_0_6 * wrench_base_my_1_0_2_5
        - wrench_base_mx_1_0_4 * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0;
    let wrench_base_fy_1_0 = wrench_base_mx_1_0_4
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        - wrench_base_my_1_0_6 * wrench_base_my_1_0_2_5;
    let wrench_base_fz_1_0 = wrench_base_my_1_0_6
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        - wrench_base_mx_1_0_6 * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0;
    let wrench_link_1_my_0_1_2 = inertias.inertia_link_1_xx
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        + inertias.inertia_link_1_xy * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        + inertias.inertia_link_1_xz * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        - (velocities.minus_velocity_base_vz * inertias.inertia_link_1_hy
            + velocities.velocity_link_1_vy * inertias.inertia_link_1_hz);
    let wrench_link_1_mx_0_1_0 = inertias.inertia_link_1_xy
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        + inertias.inertia_link_1_yy * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        - inertias.minus_inertia_link_1_yz * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        + (velocities.velocity_link_1_vx * inertias.inertia_link_1_hz
            - velocities.minus_velocity_base_vz * inertias.minus_inertia_link_1_hx);
    let wrench_link_1_mx_0_1_2 = inertias.inertia_link_1_xz
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        - inertias.minus_inertia_link_1_yz * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        + inertias.inertia_link_1_zz * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        - (velocities.velocity_link_1_vy * inertias.minus_inertia_link_1_hx
            + velocities.velocity_link_1_vx * inertias.inertia_link_1_hy);
    let wrench_link_1_my_0_1_6 = velocities.velocity_link_1_vx * 2.0
        + (wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0 * inertias.inertia_link_1_hz
            - wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1 * inertias.inertia_link_1_hy);
    let wrench_link_1_mx_0_1_4 = velocities.velocity_link_1_vy * 2.0
        - (wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1 * inertias.minus_inertia_link_1_hx
            + wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0 * inertias.inertia_link_1_hz);
    let wrench_link_1_mx_0_1_6 = wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        * inertias.inertia_link_1_hy
        + wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0 * inertias.minus_inertia_link_1_hx
        - velocities.minus_velocity_base_vz * 2.0;
    let wrench_link_1_mx_0_1 = wrench_link_1_mx_0_1_0
        * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        - wrench_link_1_mx_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        - (wrench_link_1_mx_0_1_4 * velocities.minus_velocity_base_vz
            + wrench_link_1_mx_0_1_6 * velocities.velocity_link_1_vy);
    let wrench_link_1_my_0_1 = wrench_link_1_mx_0_1_2
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        - wrench_link_1_my_0_1_2 * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        + (wrench_link_1_mx_0_1_6 * velocities.velocity_link_1_vx
            + wrench_link_1_my_0_1_6 * velocities.minus_velocity_base_vz);
    let wrench_link_1_mz_0_1 = wrench_link_1_my_0_1_2
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        - wrench_link_1_mx_0_1_0 * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        + (wrench_link_1_my_0_1_6 * velocities.velocity_link_1_vy
            - wrench_link_1_mx_0_1_4 * velocities.velocity_link_1_vx);
    let wrench_link_1_fx_0_1 = wrench_link_1_mx_0_1_4
        * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        - wrench_link_1_mx_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0;
    let wrench_link_1_fy_1_1 = wrench_link_1_mx_0_1_6
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0
        - wrench_link_1_my_0_1_6 * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1;
    let wrench_link_1_fz_0_1 = wrench_link_1_my_0_1_6
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0_0
        - wrench_link_1_mx_0_1_4 * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1_0;
    let wrench_link_2_my_0_1_2 = inertias.inertia_link_2_xx
        * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0
        + inertias.inertia_link_2_xy * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2
        + inertias.inertia_link_2_xz * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        - (velocities.velocity_link_2_vz * inertias.minus_inertia_link_2_hy
            + velocities.velocity_link_2_vy * inertias.inertia_link_2_hz);
    let wrench_link_2_mx_0_1_0 = inertias.inertia_link_2_xy
        * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0
        + inertias.inertia_link_2_yy * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2
        + inertias.inertia_link_2_yz * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        + (velocities.velocity_link_2_vx * inertias.inertia_link_2_hz
            - velocities.velocity_link_2_vz * inertias.inertia_link_2_hx);
    let wrench_link_2_mx_0_1_2 = inertias.inertia_link_2_xz
        * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0
        + inertias.inertia_link_2_yz * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2
        + inertias.inertia_link_2_zz * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        + (velocities.velocity_link_2_vy * inertias.inertia_link_2_hx
            + velocities.velocity_link_2_vx * inertias.minus_inertia_link_2_hy);
    let wrench_link_2_my_0_1_6 = velocities.velocity_link_2_vx * 2.0
        + (wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2 * inertias.inertia_link_2_hz
            + wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1 * inertias.minus_inertia_link_2_hy);
    let wrench_link_2_mx_0_1_4 = velocities.velocity_link_2_vy * 2.0
        + (wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1 * inertias.inertia_link_2_hx
            - wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0 * inertias.inertia_link_2_hz);
    let wrench_link_2_mx_0_1_6 = velocities.velocity_link_2_vz * 2.0
        - (wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0 * inertias.minus_inertia_link_2_hy
            + wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2 * inertias.inertia_link_2_hx);
    let wrench_link_2_mx_0_1 = wrench_link_2_mx_0_1_0
        * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        - wrench_link_2_mx_0_1_2 * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2
        + (wrench_link_2_mx_0_1_4 * velocities.velocity_link_2_vz
            - wrench_link_2_mx_0_1_6 * velocities.velocity_link_2_vy);
    let wrench_link_2_my_0_1 = wrench_link_2_mx_0_1_2
        * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0
        - wrench_link_2_my_0_1_2 * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        + (wrench_link_2_mx_0_1_6 * velocities.velocity_link_2_vx
            - wrench_link_2_my_0_1_6 * velocities.velocity_link_2_vz);
    let wrench_link_2_mz_0_1 = wrench_link_2_my_0_1_2
        * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2
        - wrench_link_2_mx_0_1_0 * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0
        + (wrench_link_2_my_0_1_6 * velocities.velocity_link_2_vy
            - wrench_link_2_mx_0_1_4 * velocities.velocity_link_2_vx);
    let wrench_link_2_fx_0_1 = wrench_link_2_mx_0_1_4
        * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1
        - wrench_link_2_mx_0_1_6 * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2;
    let wrench_link_2_fy_0_1 = wrench_link_2_mx_0_1_6
        * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0
        - wrench_link_2_my_0_1_6 * wrench_link_7_my_0_1_0_1_0_0_0_0_0_0_1;
    let wrench_link_2_fz_0_1 = wrench_link_2_my_0_1_6
        * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_2
        - wrench_link_2_mx_0_1_4 * wrench_link_7_mx_0_0_1_1_0_0_0_0_1_0;
    let wrench_link_3_my_0_1_2 = inertias.inertia_link_3_xx
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2
        + inertias.inertia_link_3_xy * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0
        + inertias.inertia_link_3_xz * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2
        - (velocities.velocity_link_3_vz * inertias.minus_inertia_link_3_hy
            + velocities.velocity_link_3_vy * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_0_1_0 = inertias.inertia_link_3_xy
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2
        + inertias.inertia_link_3_yy * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0
        + inertias.inertia_link_3_yz * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2
        + (velocities.velocity_link_3_vx * inertias.inertia_link_3_hz
            - velocities.velocity_link_3_vz * inertias.inertia_link_3_hx);
    let wrench_link_3_mx_0_1_2 = inertias.inertia_link_3_xz
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2
        + inertias.inertia_link_3_yz * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0
        + inertias.inertia_link_3_zz * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2
        + (velocities.velocity_link_3_vy * inertias.inertia_link_3_hx
            + velocities.velocity_link_3_vx * inertias.minus_inertia_link_3_hy);
    let wrench_link_3_my_0_1_6 = velocities.velocity_link_3_vx * 2.0
        + (wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0 * inertias.inertia_link_3_hz
            + wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2 * inertias.minus_inertia_link_3_hy);
    let wrench_link_3_mx_0_1_4 = velocities.velocity_link_3_vy * 2.0
        + (wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2 * inertias.inertia_link_3_hx
            - wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2 * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_0_1_6 = velocities.velocity_link_3_vz * 2.0
        - (wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2 * inertias.minus_inertia_link_3_hy
            + wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0 * inertias.inertia_link_3_hx);
    let wrench_link_3_mx_0_1 = wrench_link_3_mx_0_1_0
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2
        - wrench_link_3_mx_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0
        + (wrench_link_3_mx_0_1_4 * velocities.velocity_link_3_vz
            - wrench_link_3_mx_0_1_6 * velocities.velocity_link_3_vy);
    let wrench_link_3_my_0_1 = wrench_link_3_mx_0_1_2
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2
        - wrench_link_3_my_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2
        + (wrench_link_3_mx_0_1_6 * velocities.velocity_link_3_vx
            - wrench_link_3_my_0_1_6 * velocities.velocity_link_3_vz);
    let wrench_link_3_mz_0_1 = wrench_link_3_my_0_1_2
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0
        - wrench_link_3_mx_0_1_0 * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2
        + (wrench_link_3_my_0_1_6 * velocities.velocity_link_3_vy
            - wrench_link_3_mx_0_1_4 * velocities.velocity_link_3_vx);
    let wrench_link_3_fx_0_1 = wrench_link_3_mx_0_1_4
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2
        - wrench_link_3_mx_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0;
    let wrench_link_3_fy_0_1 = wrench_link_3_mx_0_1_6
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2
        - wrench_link_3_my_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_2;
    let wrench_link_3_fz_0_1 = wrench_link_3_my_0_1_6
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1_0
        - wrench_link_3_mx_0_1_4 * wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1_2;
    let wrench_link_4_my_0_1_2 = inertias.inertia_link_4_xx
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0
        + inertias.inertia_link_4_xy * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0
        + inertias.inertia_link_4_xz * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2
        + (velocities.velocity_link_4_vz * inertias.inertia_link_4_hy
            - velocities.velocity_link_4_vy * inertias.inertia_link_4_hz);
    let wrench_link_4_mx_0_1_0 = inertias.inertia_link_4_xy
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0
        + inertias.inertia_link_4_yy * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0
        + inertias.inertia_link_4_yz * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2
        + (velocities.velocity_link_4_vx * inertias.inertia_link_4_hz
            + velocities.velocity_link_4_vz * inertias.minus_inertia_link_4_hx);
    let wrench_link_4_mx_0_1_2 = inertias.inertia_link_4_xz
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0
        + inertias.inertia_link_4_yz * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0
        + inertias.inertia_link_4_zz * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2
        - (velocities.velocity_link_4_vy * inertias.minus_inertia_link_4_hx
            + velocities.velocity_link_4_vx * inertias.inertia_link_4_hy);
    let wrench_link_4_my_0_1_6 = velocities.velocity_link_4_vx * 2.0
        + (wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0 * inertias.inertia_link_4_hz
            - wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2 * inertias.inertia_link_4_hy);
    let wrench_link_4_mx_0_1_4 = velocities.velocity_link_4_vy * 2.0
        - (wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2 * inertias.minus_inertia_link_4_hx
            + wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0 * inertias.inertia_link_4_hz);
    let wrench_link_4_mx_0_1_6 = velocities.velocity_link_4_vz * 2.0
        + (wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0 * inertias.inertia_link_4_hy
            + wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0 * inertias.minus_inertia_link_4_hx);
    let wrench_link_4_mx_0_1 = wrench_link_4_mx_0_1_0
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2
        - wrench_link_4_mx_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0
        + (wrench_link_4_mx_0_1_4 * velocities.velocity_link_4_vz
            - wrench_link_4_mx_0_1_6 * velocities.velocity_link_4_vy);
    let wrench_link_4_my_0_1 = wrench_link_4_mx_0_1_2
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0
        - wrench_link_4_my_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2
        + (wrench_link_4_mx_0_1_6 * velocities.velocity_link_4_vx
            - wrench_link_4_my_0_1_6 * velocities.velocity_link_4_vz);
    let wrench_link_4_mz_0_1 = wrench_link_4_my_0_1_2
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0
        - wrench_link_4_mx_0_1_0 * wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0
        + (wrench_link_4_my_0_1_6 * velocities.velocity_link_4_vy
            - wrench_link_4_mx_0_1_4 * velocities.velocity_link_4_vx);
    let wrench_link_4_fx_0_1 = wrench_link_4_mx_0_1_4
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2
        - wrench_link_4_mx_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0;
    let wrench_link_4_fy_0_1 = wrench_link_4_mx_0_1_6
        * wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0
        - wrench_link_4_my_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_2;
    let wrench_link_4_fz_0_1 = wrench_link_4_my_0_1_6
        * wrench_link_7_mx_0_0_0_0_1_0_0_0_1_0
        - wrench_link_4_mx_0_1_4 * wrench_link_7_mx_0_0_0_1_1_0_0_0_1_0;
    let wrench_link_5_my_0_1_2 = inertias.inertia_link_5_xx
        * wrench_link_7_mx_0_0_0_1_1_0_0_1_2
        + inertias.inertia_link_5_xy * wrench_link_7_mx_0_0_0_0_1_0_0_1_0
        + inertias.inertia_link_5_xz * wrench_link_7_mx_0_0_0_0_1_0_0_1_2
        + (velocities.velocity_link_5_vz * inertias.inertia_link_5_hy
            - velocities.velocity_link_5_vy * inertias.inertia_link_5_hz);
    let wrench_link_5_mx_0_1_0 = inertias.inertia_link_5_xy
        * wrench_link_7_mx_0_0_0_1_1_0_0_1_2
        + inertias.inertia_link_5_yy * wrench_link_7_mx_0_0_0_0_1_0_0_1_0
        + inertias.inertia_link_5_yz * wrench_link_7_mx_0_0_0_0_1_0_0_1_2
        + (velocities.velocity_link_5_vx * inertias.inertia_link_5_hz
            + velocities.velocity_link_5_vz * inertias.minus_inertia_link_5_hx);
    let wrench_link_5_mx_0_1_2 = inertias.inertia_link_5_xz
        * wrench_link_7_mx_0_0_0_1_1_0_0_1_2
        + inertias.inertia_link_5_yz * wrench_link_7_mx_0_0_0_0_1_0_0_1_0
        + inertias.inertia_link_5_zz * wrench_link_7_mx_0_0_0_0_1_0_0_1_2
        - (velocities.velocity_link_5_vy * inertias.minus_inertia_link_5_hx
            + velocities.velocity_link_5_vx * inertias.inertia_link_5_hy);
    let wrench_link_5_my_0_1_6 = velocities.velocity_link_5_vx * 2.0
        + (wrench_link_7_mx_0_0_0_0_1_0_0_1_0 * inertias.inertia_link_5_hz
            - wrench_link_7_mx_0_0_0_0_1_0_0_1_2 * inertias.inertia_link_5_hy);
    let wrench_link_5_mx_0_1_4 = velocities.velocity_link_5_vy * 2.0
        - (wrench_link_7_mx_0_0_0_0_1_0_0_1_2 * inertias.minus_inertia_link_5_hx
            + wrench_link_7_mx_0_0_0_1_1_0_0_1_2 * inertias.inertia_link_5_hz);
    let wrench_link_5_mx_0_1_6 = velocities.velocity_link_5_vz * 2.0
        + (wrench_link_7_mx_0_0_0_1_1_0_0_1_2 * inertias.inertia_link_5_hy
            + wrench_link_7_mx_0_0_0_0_1_0_0_1_0 * inertias.minus_inertia_link_5_hx);
    let wrench_link_5_mx_0_1 = wrench_link_5_mx_0_1_0
        * wrench_link_7_mx_0_0_0_0_1_0_0_1_2
        - wrench_link_5_mx_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_0_1_0
        + (wrench_link_5_mx_0_1_4 * velocities.velocity_link_5_vz
            - wrench_link_5_mx_0_1_6 * velocities.velocity_link_5_vy);
    let wrench_link_5_my_0_1 = wrench_link_5_mx_0_1_2
        * wrench_link_7_mx_0_0_0_1_1_0_0_1_2
        - wrench_link_5_my_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_0_1_2
        + (wrench_link_5_mx_0_1_6 * velocities.velocity_link_5_vx
            - wrench_link_5_my_0_1_6 * velocities.velocity_link_5_vz);
    let wrench_link_5_mz_0_1 = wrench_link_5_my_0_1_2
        * wrench_link_7_mx_0_0_0_0_1_0_0_1_0
        - wrench_link_5_mx_0_1_0 * wrench_link_7_mx_0_0_0_1_1_0_0_1_2
        + (wrench_link_5_my_0_1_6 * velocities.velocity_link_5_vy
            - wrench_link_5_mx_0_1_4 * velocities.velocity_link_5_vx);
    let wrench_link_5_fx_0_1 = wrench_link_5_mx_0_1_4
        * wrench_link_7_mx_0_0_0_0_1_0_0_1_2
        - wrench_link_5_mx_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_0_1_0;
    let wrench_link_5_fy_0_1 = wrench_link_5_mx_0_1_6
        * wrench_link_7_mx_0_0_0_1_1_0_0_1_2
        - wrench_link_5_my_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_0_1_2;
    let wrench_link_5_fz_0_1 = wrench_link_5_my_0_1_6
        * wrench_link_7_mx_0_0_0_0_1_0_0_1_0
        - wrench_link_5_mx_0_1_4 * wrench_link_7_mx_0_0_0_1_1_0_0_1_2;
    let wrench_link_6_my_0_1_2 = inertias.inertia_link_6_xx
        * wrench_link_7_mx_0_0_0_1_1_0_1_2
        - inertias.minus_inertia_link_6_xy * wrench_link_7_mx_0_0_0_0_1_0_1_0
        + inertias.inertia_link_6_xz * wrench_link_7_mx_0_0_0_0_1_0_1_2
        - (velocities.velocity_link_6_vz * inertias.minus_inertia_link_6_hy
            + velocities.velocity_link_6_vy * inertias.inertia_link_6_hz);
    let wrench_link_6_mx_0_1_0 = inertias.inertia_link_6_yy
        * wrench_link_7_mx_0_0_0_0_1_0_1_0
        - inertias.minus_inertia_link_6_xy * wrench_link_7_mx_0_0_0_1_1_0_1_2
        + inertias.inertia_link_6_yz * wrench_link_7_mx_0_0_0_0_1_0_1_2
        + (velocities.velocity_link_6_vx * inertias.inertia_link_6_hz
            + velocities.velocity_link_6_vz * inertias.minus_inertia_link_6_hx);
    let wrench_link_6_mx_0_1_2 = inertias.inertia_link_6_xz
        * wrench_link_7_mx_0_0_0_1_1_0_1_2
        + inertias.inertia_link_6_yz * wrench_link_7_mx_0_0_0_0_1_0_1_0
        + inertias.inertia_link_6_zz * wrench_link_7_mx_0_0_0_0_1_0_1_2
        + (velocities.velocity_link_6_vx * inertias.minus_inertia_link_6_hy
            - velocities.velocity_link_6_vy * inertias.minus_inertia_link_6_hx);
    let wrench_link_6_my_0_1_6 = velocities.velocity_link_6_vx * 2.0
        + (wrench_link_7_mx_0_0_0_0_1_0_1_0 * inertias.inertia_link_6_hz
            + wrench_link_7_mx_0_0_0_0_1_0_1_2 * inertias.minus_inertia_link_6_hy);
    let wrench_link_6_mx_0_1_4 = velocities.velocity_link_6_vy * 2.0
        - (wrench_link_7_mx_0_0_0_0_1_0_1_2 * inertias.minus_inertia_link_6_hx
            + wrench_link_7_mx_0_0_0_1_1_0_1_2 * inertias.inertia_link_6_hz);
    let wrench_link_6_mx_0_1_6 = velocities.velocity_link_6_vz * 2.0
        + (wrench_link_7_mx_0_0_0_0_1_0_1_0 * inertias.minus_inertia_link_6_hx
            - wrench_link_7_mx_0_0_0_1_1_0_1_2 * inertias.minus_inertia_link_6_hy);
    let wrench_link_6_mx_0_1 = wrench_link_6_mx_0_1_0 * wrench_link_7_mx_0_0_0_0_1_0_1_2
        - wrench_link_6_mx_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_1_0
        + (wrench_link_6_mx_0_1_4 * velocities.velocity_link_6_vz
            - wrench_link_6_mx_0_1_6 * velocities.velocity_link_6_vy);
    let wrench_link_6_my_0_1 = wrench_link_6_mx_0_1_2 * wrench_link_7_mx_0_0_0_1_1_0_1_2
        - wrench_link_6_my_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_1_2
        + (wrench_link_6_mx_0_1_6 * velocities.velocity_link_6_vx
            - wrench_link_6_my_0_1_6 * velocities.velocity_link_6_vz);
    let wrench_link_6_mz_0_1 = wrench_link_6_my_0_1_2 * wrench_link_7_mx_0_0_0_0_1_0_1_0
        - wrench_link_6_mx_0_1_0 * wrench_link_7_mx_0_0_0_1_1_0_1_2
        + (wrench_link_6_my_0_1_6 * velocities.velocity_link_6_vy
            - wrench_link_6_mx_0_1_4 * velocities.velocity_link_6_vx);
    let wrench_link_6_fx_0_1 = wrench_link_6_mx_0_1_4 * wrench_link_7_mx_0_0_0_0_1_0_1_2
        - wrench_link_6_mx_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_1_0;
    let wrench_link_6_fy_0_1 = wrench_link_6_mx_0_1_6 * wrench_link_7_mx_0_0_0_1_1_0_1_2
        - wrench_link_6_my_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_1_2;
    let wrench_link_6_fz_0_1 = wrench_link_6_my_0_1_6 * wrench_link_7_mx_0_0_0_0_1_0_1_0
        - wrench_link_6_mx_0_1_4 * wrench_link_7_mx_0_0_0_1_1_0_1_2;
    let wrench_link_7_my_1_2 = inertias.inertia_link_7_xx
        * wrench_link_7_mx_0_0_0_1_1_1_2
        - inertias.minus_inertia_link_7_xy * wrench_link_7_mx_0_0_0_0_1_1_0
        + inertias.inertia_link_7_xz * wrench_link_7_mx_0_0_0_0_1_1_2
        - (velocities.velocity_link_7_vz * inertias.minus_inertia_link_7_hy
            + velocities.velocity_link_7_vy * inertias.inertia_link_7_hz);
    let wrench_link_7_mx_1_0 = inertias.inertia_link_7_yy
        * wrench_link_7_mx_0_0_0_0_1_1_0
        - inertias.minus_inertia_link_7_xy * wrench_link_7_mx_0_0_0_1_1_1_2
        + inertias.inertia_link_7_yz * wrench_link_7_mx_0_0_0_0_1_1_2
        + (velocities.velocity_link_7_vx * inertias.inertia_link_7_hz
            + velocities.velocity_link_7_vz * inertias.minus_inertia_link_7_hx);
    let wrench_link_7_mx_1_2 = inertias.inertia_link_7_xz
        * wrench_link_7_mx_0_0_0_1_1_1_2
        + inertias.inertia_link_7_yz * wrench_link_7_mx_0_0_0_0_1_1_0
        + inertias.inertia_link_7_zz * wrench_link_7_mx_0_0_0_0_1_1_2
        + (velocities.velocity_link_7_vx * inertias.minus_inertia_link_7_hy
            - velocities.velocity_link_7_vy * inertias.minus_inertia_link_7_hx);
    let wrench_link_7_my_1_6 = velocities.velocity_link_7_vx * 2.0
        + (wrench_link_7_mx_0_0_0_0_1_1_0 * inertias.inertia_link_7_hz
            + wrench_link_7_mx_0_0_0_0_1_1_2 * inertias.minus_inertia_link_7_hy);
    let wrench_link_7_mx_1_4 = velocities.velocity_link_7_vy * 2.0
        - (wrench_link_7_mx_0_0_0_0_1_1_2 * inertias.minus_inertia_link_7_hx
            + wrench_link_7_mx_0_0_0_1_1_1_2 * inertias.inertia_link_7_hz);
    let wrench_link_7_mx_1_6 = velocities.velocity_link_7_vz * 2.0
        + (wrench_link_7_mx_0_0_0_0_1_1_0 * inertias.minus_inertia_link_7_hx
            - wrench_link_7_mx_0_0_0_1_1_1_2 * inertias.minus_inertia_link_7_hy);
    let wrench_link_7_mx_1 = wrench_link_7_mx_1_0 * wrench_link_7_mx_0_0_0_0_1_1_2
        - wrench_link_7_mx_1_2 * wrench_link_7_mx_0_0_0_0_1_1_0
        + (wrench_link_7_mx_1_4 * velocities.velocity_link_7_vz
            - wrench_link_7_mx_1_6 * velocities.velocity_link_7_vy);
    let wrench_link_7_my_1 = wrench_link_7_mx_1_2 * wrench_link_7_mx_0_0_0_1_1_1_2
        - wrench_link_7_my_1_2 * wrench_link_7_mx_0_0_0_0_1_1_2
        + (wrench_link_7_mx_1_6 * velocities.velocity_link_7_vx
            - wrench_link_7_my_1_6 * velocities.velocity_link_7_vz);
    let wrench_link_7_mz_1 = wrench_link_7_my_1_2 * wrench_link_7_mx_0_0_0_0_1_1_0
        - wrench_link_7_mx_1_0 * wrench_link_7_mx_0_0_0_1_1_1_2
        + (wrench_link_7_my_1_6 * velocities.velocity_link_7_vy
            - wrench_link_7_mx_1_4 * velocities.velocity_link_7_vx);
    let wrench_link_7_fx_1 = wrench_link_7_mx_1_4 * wrench_link_7_mx_0_0_0_0_1_1_2
        - wrench_link_7_mx_1_6 * wrench_link_7_mx_0_0_0_0_1_1_0;
    let wrench_link_7_fy_1 = wrench_link_7_mx_1_6 * wrench_link_7_mx_0_0_0_1_1_1_2
        - wrench_link_7_my_1_6 * wrench_link_7_mx_0_0_0_0_1_1_2;
    let wrench_link_7_fz_1 = wrench_link_7_my_1_6 * wrench_link_7_mx_0_0_0_0_1_1_0
        - wrench_link_7_mx_1_4 * wrench_link_7_mx_0_0_0_1_1_1_2;
    CommonForwardDynamicsInverseDynamics {
        wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0,
        wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1,
        wrench_link_7_my_0_1_0_1_0_0_0_0_0_0,
        wrench_link_7_mx_0_1_1_1_0_0_0_0_0_1,
        wrench_link_7_mx_0_1_0_1_0_0_0_0_0_0,
        wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_1,
        wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_0,
        wrench_link_7_mx_0_0_1_1_0_0_0_0_1,
        wrench_link_7_my_0_1_0_1_0_0_0_0_0_1,
        wrench_link_7_mx_0_1_1_1_0_0_0_0_0_0,
        wrench_link_7_mx_0_1_0_1_0_0_0_0_0_1,
        wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1,
        wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1,
        wrench_link_7_mx_0_0_1_1_0_0_0_0_0,
        wrench_link_7_my_0_1_0_1_0_0_0_0_1,
        wrench_link_7_mx_0_1_1_1_0_0_0_0_1,
        wrench_link_7_mx_0_1_0_1_0_0_0_0_1,
        wrench_link_7_mx_0_0_0_0_1_0_0_0_1,
        wrench_link_7_mx_0_0_0_1_1_0_0_0_1,
        wrench_link_7_mx_0_0_1_1_0_0_0_1,
        wrench_link_7_my_0_1_0_1_0_0_0_1,
        wrench_link_7_mx_0_1_1_1_0_0_0_1,
        wrench_link_7_mx_0_1_0_1_0_0_0_1,
        wrench_link_7_mx_0_0_0_0_1_0_0_1,
        wrench_link_7_mx_0_0_0_1_1_0_0_1,
        wrench_link_7_mx_0_0_1_1_0_0_1,
        wrench_link_7_my_0_1_0_1_0_0_1,
        wrench_link_7_mx_0_1_1_1_0_0_1,
        wrench_link_7_mx_0_1_0_1_0_0_1,
        wrench_link_7_mx_0_0_0_0_1_0_1,
        wrench_link_7_mx_0_0_0_1_1_0_1,
        wrench_link_7_mx_0_0_1_1_0_1,
        wrench_link_7_my_0_1_0_1_0_1,
        wrench_link_7_mx_0_1_1_1_0_1,
        wrench_link_7_mx_0_1_0_1_0_1,
        wrench_link_7_mx_0_0_0_0_1_1,
        wrench_link_7_mx_0_0_0_1_1_1,
        wrench_link_7_mx_0_0_1_1_1,
        wrench_link_7_my_0_1_0_1_1,
        wrench_link_7_mx_0_1_1_1_1,
        wrench_link_7_mx_0_1_0_1_1,
        wrench_base_mx_1_0,
        wrench_base_my_1_0,
        wrench_base_mz_1_0,
        wrench_base_fx_1_0,
        wrench_base_fy_1_0,
        wrench_base_fz_1_0,
        wrench_link_1_mx_0_1,
        wrench_link_1_my_0_1,
        wrench_link_1_mz_0_1,
        wrench_link_1_fx_0_1,
        wrench_link_1_fy_1_1,
        wrench_link_1_fz_0_1,
        wrench_link_2_mx_0_1,
        wrench_link_2_my_0_1,
        wrench_link_2_mz_0_1,
        wrench_link_2_fx_0_1,
        wrench_link_2_fy_0_1,
        wrench_link_2_fz_0_1,
        wrench_link_3_mx_0_1,
        wrench_link_3_my_0_1,
        wrench_link_3_mz_0_1,
        wrench_link_3_fx_0_1,
        wrench_link_3_fy_0_1,
        wrench_link_3_fz_0_1,
        wrench_link_4_mx_0_1,
        wrench_link_4_my_0_1,
        wrench_link_4_mz_0_1,
        wrench_link_4_fx_0_1,
        wrench_link_4_fy_0_1,
        wrench_link_4_fz_0_1,
        wrench_link_5_mx_0_1,
        wrench_link_5_my_0_1,
        wrench_link_5_mz_0_1,
        wrench_link_5_fx_0_1,
        wrench_link_5_fy_0_1,
        wrench_link_5_fz_0_1,
        wrench_link_6_mx_0_1,
        wrench_link_6_my_0_1,
        wrench_link_6_mz_0_1,
        wrench_link_6_fx_0_1,
        wrench_link_6_fy_0_1,
        wrench_link_6_fz_0_1,
        wrench_link_7_mx_1,
        wrench_link_7_my_1,
        wrench_link_7_mz_1,
        wrench_link_7_fx_1,
        wrench_link_7_fy_1,
        wrench_link_7_fz_1,
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
    connection: &mut [[f64; 6]; 7],
    shape_inertia: &mut [[f64; 7]; 7],
) {
    let locked_inertia_0_0_1_0 = poses.com_y * 17.5;
    let locked_inertia_0_0_2_0 = poses.com_z * 17.5;
    let locked_inertia_0_0_1 = locked_inertia_0_0_1_0 * poses.com_y;
    let locked_inertia_0_0_2 = locked_inertia_0_0_2_0 * poses.com_z;
    // Λ_b column 0
    locked_inertia[0][0] = inertias.composite_base_xx
        + (locked_inertia_0_0_1 + locked_inertia_0_0_2) + 0.0;
    let locked_inertia_1_0_1 = poses.com_x * 17.5;
    let locked_inertia_1_0 = inertias.composite_base_xy
        - locked_inertia_1_0_1 * poses.com_y;
    locked_inertia[0][1] = locked_inertia_1_0 + 0.0;
    let locked_inertia_2_0 = inertias.composite_base_xz
        - locked_inertia_1_0_1 * poses.com_z;
    locked_inertia[0][2] = locked_inertia_2_0 + 0.0;
    locked_inertia[0][3] = 0.0;
    locked_inertia[0][4] = 0.0 - locked_inertia_0_0_2_0;
    locked_inertia[0][5] = locked_inertia_0_0_1_0 + 0.0;
    // Λ_b column 1
    locked_inertia[1][0] = locked_inertia_1_0 + 0.0;
    let locked_inertia_1_1_1 = locked_inertia_1_0_1 * poses.com_x;
    locked_inertia[1][1] = inertias.composite_base_yy
        + (locked_inertia_1_1_1 + locked_inertia_0_0_2) + 0.0;
    let locked_inertia_2_1 = inertias.composite_base_yz
        - locked_inertia_0_0_1_0 * poses.com_z;
    locked_inertia[1][2] = locked_inertia_2_1 + 0.0;
    locked_inertia[1][3] = locked_inertia_0_0_2_0 + 0.0;
    locked_inertia[1][4] = 0.0;
    locked_inertia[1][5] = 0.0 - locked_inertia_1_0_1;
    // Λ_b column 2
    locked_inertia[2][0] = locked_inertia_2_0 + 0.0;
    locked_inertia[2][1] = locked_inertia_2_1 + 0.0;
    locked_inertia[2][2] = inertias.composite_base_zz
        + (locked_inertia_1_1_1 + locked_inertia_0_0_1) + 0.0;
    locked_inertia[2][3] = 0.0 - locked_inertia_0_0_1_0;
    locked_inertia[2][4] = locked_inertia_1_0_1 + 0.0;
    locked_inertia[2][5] = 0.0;
    // Λ_b column 3
    locked_inertia[3][0] = 0.0;
    locked_inertia[3][1] = locked_inertia_0_0_2_0 + 0.0;
    locked_inertia[3][2] = 0.0 - locked_inertia_0_0_1_0;
    locked_inertia[3][3] = 17.5;
    locked_inertia[3][4] = 0.0;
    locked_inertia[3][5] = 0.0;
    // Λ_b column 4
    locked_inertia[4][0] = 0.0 - locked_inertia_0_0_2_0;
    locked_inertia[4][1] = 0.0;
    locked_inertia[4][2] = locked_inertia_1_0_1 + 0.0;
    locked_inertia[4][3] = 0.0;
    locked_inertia[4][4] = 17.5;
    locked_inertia[4][5] = 0.0;
    // Λ_b column 5
    locked_inertia[5][0] = locked_inertia_0_0_1_0 + 0.0;
    locked_inertia[5][1] = 0.0 - locked_inertia_1_0_1;
    locked_inertia[5][2] = 0.0;
    locked_inertia[5][3] = 0.0;
    locked_inertia[5][4] = 0.0;
    locked_inertia[5][5] = 17.5;
    // A_l column joint_1
    connection[0][0] = screws.connection_joint_1_wx + 0.0;
    connection[0][1] = screws.connection_joint_1_wy + 0.0;
    connection[0][2] = screws.connection_joint_1_wz + 0.0;
    connection[0][3] = screws.connection_joint_1_wz * poses.com_y
        - screws.connection_joint_1_wy * poses.com_z - screws.minus_connection_joint_1_vx
        + 0.0;
    connection[0][4] = screws.connection_joint_1_vy
        + (screws.connection_joint_1_wx * poses.com_z
            - screws.connection_joint_1_wz * poses.com_x) + 0.0;
    connection[0][5] = screws.connection_joint_1_wy * poses.com_x
        - screws.connection_joint_1_wx * poses.com_y + 0.0;
    // A_l column joint_2
    connection[1][0] = screws.connection_joint_2_wx + 0.0;
    connection[1][1] = screws.connection_joint_2_wy + 0.0;
    connection[1][2] = screws.connection_joint_2_wz + 0.0;
    connection[1][3] = screws.connection_joint_2_vx
        + (screws.connection_joint_2_wz * poses.com_y
            - screws.connection_joint_2_wy * poses.com_z) + 0.0;
    connection[1][4] = screws.connection_joint_2_vy
        + (screws.connection_joint_2_wx * poses.com_z
            - screws.connection_joint_2_wz * poses.com_x) + 0.0;
    connection[1][5] = screws.connection_joint_2_vz
        + (screws.connection_joint_2_wy * poses.com_x
            - screws.connection_joint_2_wx * poses.com_y) + 0.0;
    // A_l column joint_3
    connection[2][0] = screws.connection_joint_3_wx + 0.0;
    connection[2][1] = screws.connection_joint_3_wy + 0.0;
    connection[2][2] = screws.connection_joint_3_wz + 0.0;
    connection[2][3] = screws.connection_joint_3_vx
        + (screws.connection_joint_3_wz * poses.com_y
            - screws.connection_joint_3_wy * poses.com_z) + 0.0;
    connection[2][4] = screws.connection_joint_3_vy
        + (screws.connection_joint_3_wx * poses.com_z
            - screws.connection_joint_3_wz * poses.com_x) + 0.0;
    connection[2][5] = screws.connection_joint_3_vz
        + (screws.connection_joint_3_wy * poses.com_x
            - screws.connection_joint_3_wx * poses.com_y) + 0.0;
    // A_l column joint_4
    connection[3][0] = screws.connection_joint_4_wx + 0.0;
    connection[3][1] = screws.connection_joint_4_wy + 0.0;
    connection[3][2] = screws.connection_joint_4_wz + 0.0;
    connection[3][3] = screws.connection_joint_4_vx
        + (screws.connection_joint_4_wz * poses.com_y
            - screws.connection_joint_4_wy * poses.com_z) + 0.0;
    connection[3][4] = screws.connection_joint_4_vy
        + (screws.connection_joint_4_wx * poses.com_z
            - screws.connection_joint_4_wz * poses.com_x) + 0.0;
    connection[3][5] = screws.connection_joint_4_vz
        + (screws.connection_joint_4_wy * poses.com_x
            - screws.connection_joint_4_wx * poses.com_y) + 0.0;
    // A_l column joint_5
    connection[4][0] = screws.connection_joint_5_wx + 0.0;
    connection[4][1] = screws.connection_joint_5_wy + 0.0;
    connection[4][2] = screws.connection_joint_5_wz + 0.0;
    connection[4][3] = screws.connection_joint_5_vx
        + (screws.connection_joint_5_wz * poses.com_y
            - screws.connection_joint_5_wy * poses.com_z) + 0.0;
    connection[4][4] = screws.connection_joint_5_vy
        + (screws.connection_joint_5_wx * poses.com_z
            - screws.connection_joint_5_wz * poses.com_x) + 0.0;
    connection[4][5] = screws.connection_joint_5_vz
        + (screws.connection_joint_5_wy * poses.com_x
            - screws.connection_joint_5_wx * poses.com_y) + 0.0;
    // A_l column joint_6
    connection[5][0] = screws.connection_joint_6_wx + 0.0;
    connection[5][1] = screws.connection_joint_6_wy + 0.0;
    connection[5][2] = screws.connection_joint_6_wz + 0.0;
    connection[5][3] = screws.connection_joint_6_vx
        + (screws.connection_joint_6_wz * poses.com_y
            - screws.connection_joint_6_wy * poses.com_z) + 0.0;
    connection[5][4] = screws.connection_joint_6_vy
        + (screws.connection_joint_6_wx * poses.com_z
            - screws.connection_joint_6_wz * poses.com_x) + 0.0;
    connection[5][5] = screws.connection_joint_6_vz
        + (screws.connection_joint_6_wy * poses.com_x
            - screws.connection_joint_6_wx * poses.com_y) + 0.0;
    // A_l column joint_7
    connection[6][0] = screws.connection_joint_7_wx + 0.0;
    connection[6][1] = screws.connection_joint_7_wy + 0.0;
    connection[6][2] = screws.connection_joint_7_wz + 0.0;
    connection[6][3] = screws.connection_joint_7_vx
        + (screws.connection_joint_7_wz * poses.com_y
            - screws.connection_joint_7_wy * poses.com_z) + 0.0;
    connection[6][4] = screws.connection_joint_7_vy
        + (screws.connection_joint_7_wx * poses.com_z
            - screws.connection_joint_7_wz * poses.com_x) + 0.0;
    connection[6][5] = screws.connection_joint_7_vz
        + (screws.connection_joint_7_wy * poses.com_x
            - screws.connection_joint_7_wx * poses.com_y) + 0.0;
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
    let shape_inertia_3_0 = outside.outside_joint_1_mx * screws.connection_joint_4_wx
        + outside.outside_joint_1_my * screws.connection_joint_4_wy
        + outside.outside_joint_1_mz * screws.connection_joint_4_wz;
    shape_inertia[0][3] = shape_inertia_3_0 + 0.0;
    let shape_inertia_4_0 = outside.outside_joint_1_mx * screws.connection_joint_5_wx
        + outside.outside_joint_1_my * screws.connection_joint_5_wy
        + outside.outside_joint_1_mz * screws.connection_joint_5_wz;
    shape_inertia[0][4] = shape_inertia_4_0 + 0.0;
    let shape_inertia_5_0 = outside.outside_joint_1_mx * screws.connection_joint_6_wx
        + outside.outside_joint_1_my * screws.connection_joint_6_wy
        + outside.outside_joint_1_mz * screws.connection_joint_6_wz;
    shape_inertia[0][5] = shape_inertia_5_0 + 0.0;
    let shape_inertia_6_0 = outside.outside_joint_1_mx * screws.connection_joint_7_wx
        + outside.outside_joint_1_my * screws.connection_joint_7_wy
        + outside.outside_joint_1_mz * screws.connection_joint_7_wz;
    shape_inertia[0][6] = shape_inertia_6_0 + 0.0;
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
    let shape_inertia_3_1 = outside.outside_joint_2_mx * screws.connection_joint_4_wx
        + outside.outside_joint_2_my * screws.connection_joint_4_wy
        + outside.outside_joint_2_mz * screws.connection_joint_4_wz
        + outside.outside_joint_2_fx * screws.connection_joint_4_vx
        + outside.outside_joint_2_fy * screws.connection_joint_4_vy
        + outside.outside_joint_2_fz * screws.connection_joint_4_vz;
    shape_inertia[1][3] = shape_inertia_3_1 + 0.0;
    let shape_inertia_4_1 = outside.outside_joint_2_mx * screws.connection_joint_5_wx
        + outside.outside_joint_2_my * screws.connection_joint_5_wy
        + outside.outside_joint_2_mz * screws.connection_joint_5_wz
        + outside.outside_joint_2_fx * screws.connection_joint_5_vx
        + outside.outside_joint_2_fy * screws.connection_joint_5_vy
        + outside.outside_joint_2_fz * screws.connection_joint_5_vz;
    shape_inertia[1][4] = shape_inertia_4_1 + 0.0;
    let shape_inertia_5_1 = outside.outside_joint_2_mx * screws.connection_joint_6_wx
        + outside.outside_joint_2_my * screws.connection_joint_6_wy
        + outside.outside_joint_2_mz * screws.connection_joint_6_wz
        + outside.outside_joint_2_fx * screws.connection_joint_6_vx
        + outside.outside_joint_2_fy * screws.connection_joint_6_vy
        + outside.outside_joint_2_fz * screws.connection_joint_6_vz;
    shape_inertia[1][5] = shape_inertia_5_1 + 0.0;
    let shape_inertia_6_1 = outside.outside_joint_2_mx * screws.connection_joint_7_wx
        + outside.outside_joint_2_my * screws.connection_joint_7_wy
        + outside.outside_joint_2_mz * screws.connection_joint_7_wz
        + outside.outside_joint_2_fx * screws.connection_joint_7_vx
        + outside.outside_joint_2_fy * screws.connection_joint_7_vy
        + outside.outside_joint_2_fz * screws.connection_joint_7_vz;
    shape_inertia[1][6] = shape_inertia_6_1 + 0.0;
    // Λ_q column joint_3
    shape_inertia[2][0] = shape_inertia_2_0 + 0.0;
    shape_inertia[2][1] = shape_inertia_2_1 + 0.0;
    shape_inertia[2][2] = outside.outside_joint_3_mx * screws.connection_joint_3_wx
        + outside.outside_joint_3_my * screws.connection_joint_3_wy
        + outside.outside_joint_3_mz * screws.connection_joint_3_wz
        + outside.outside_joint_3_fx * screws.connection_joint_3_vx
        + outside.outside_joint_3_fy * screws.connection_joint_3_vy
        + outside.outside_joint_3_fz * screws.connection_joint_3_vz + 0.0;
    let shape_inertia_3_2 = outside.outside_joint_3_mx * screws.connection_joint_4_wx
        + outside.outside_joint_3_my * screws.connection_joint_4_wy
        + outside.outside_joint_3_mz * screws.connection_joint_4_wz
        + outside.outside_joint_3_fx * screws.connection_joint_4_vx
        + outside.outside_joint_3_fy * screws.connection_joint_4_vy
        + outside.outside_joint_3_fz * screws.connection_joint_4_vz;
    shape_inertia[2][3] = shape_inertia_3_2 + 0.0;
    let shape_inertia_4_2 = outside.outside_joint_3_mx * screws.connection_joint_5_wx
        + outside.outside_joint_3_my * screws.connection_joint_5_wy
        + outside.outside_joint_3_mz * screws.connection_joint_5_wz
        + outside.outside_joint_3_fx * screws.connection_joint_5_vx
        + outside.outside_joint_3_fy * screws.connection_joint_5_vy
        + outside.outside_joint_3_fz * screws.connection_joint_5_vz;
    shape_inertia[2][4] = shape_inertia_4_2 + 0.0;
    let shape_inertia_5_2 = outside.outside_joint_3_mx * screws.connection_joint_6_wx
        + outside.outside_joint_3_my * screws.connection_joint_6_wy
        + outside.outside_joint_3_mz * screws.connection_joint_6_wz
        + outside.outside_joint_3_fx * screws.connection_joint_6_vx
        + outside.outside_joint_3_fy * screws.connection_joint_6_vy
        + outside.outside_joint_3_fz * screws.connection_joint_6_vz;
    shape_inertia[2][5] = shape_inertia_5_2 + 0.0;
    let shape_inertia_6_2 = outside.outside_joint_3_mx * screws.connection_joint_7_wx
        + outside.outside_joint_3_my * screws.connection_joint_7_wy
        + outside.outside_joint_3_mz * screws.connection_joint_7_wz
        + outside.outside_joint_3_fx * screws.connection_joint_7_vx
        + outside.outside_joint_3_fy * screws.connection_joint_7_vy
        + outside.outside_joint_3_fz * screws.connection_joint_7_vz;
    shape_inertia[2][6] = shape_inertia_6_2 + 0.0;
    // Λ_q column joint_4
    shape_inertia[3][0] = shape_inertia_3_0 + 0.0;
    shape_inertia[3][1] = shape_inertia_3_1 + 0.0;
    shape_inertia[3][2] = shape_inertia_3_2 + 0.0;
    shape_inertia[3][3] = outside.outside_joint_4_mx * screws.connection_joint_4_wx
        + outside.outside_joint_4_my * screws.connection_joint_4_wy
        + outside.outside_joint_4_mz * screws.connection_joint_4_wz
        + outside.outside_joint_4_fx * screws.connection_joint_4_vx
        + outside.outside_joint_4_fy * screws.connection_joint_4_vy
        - outside.minus_outside_joint_4_fz * screws.connection_joint_4_vz + 0.0;
    let shape_inertia_4_3 = outside.outside_joint_4_mx * screws.connection_joint_5_wx
        + outside.outside_joint_4_my * screws.connection_joint_5_wy
        + outside.outside_joint_4_mz * screws.connection_joint_5_wz
        + outside.outside_joint_4_fx * screws.connection_joint_5_vx
        + outside.outside_joint_4_fy * screws.connection_joint_5_vy
        - outside.minus_outside_joint_4_fz * screws.connection_joint_5_vz;
    shape_inertia[3][4] = shape_inertia_4_3 + 0.0;
    let shape_inertia_5_3 = outside.outside_joint_4_mx * screws.connection_joint_6_wx
        + outside.outside_joint_4_my * screws.connection_joint_6_wy
        + outside.outside_joint_4_mz * screws.connection_joint_6_wz
        + outside.outside_joint_4_fx * screws.connection_joint_6_vx
        + outside.outside_joint_4_fy * screws.connection_joint_6_vy
        - outside.minus_outside_joint_4_fz * screws.connection_joint_6_vz;
    shape_inertia[3][5] = shape_inertia_5_3 + 0.0;
    let shape_inertia_6_3 = outside.outside_joint_4_mx * screws.connection_joint_7_wx
        + outside.outside_joint_4_my * screws.connection_joint_7_wy
        + outside.outside_joint_4_mz * screws.connection_joint_7_wz
        + outside.outside_joint_4_fx * screws.connection_joint_7_vx
        + outside.outside_joint_4_fy * screws.connection_joint_7_vy
        - outside.minus_outside_joint_4_fz * screws.connection_joint_7_vz;
    shape_inertia[3][6] = shape_inertia_6_3 + 0.0;
    // Λ_q column joint_5
    shape_inertia[4][0] = shape_inertia_4_0 + 0.0;
    shape_inertia[4][1] = shape_inertia_4_1 + 0.0;
    shape_inertia[4][2] = shape_inertia_4_2 + 0.0;
    shape_inertia[4][3] = shape_inertia_4_3 + 0.0;
    shape_inertia[4][4] = outside.outside_joint_5_mx * screws.connection_joint_5_wx
        + outside.outside_joint_5_my * screws.connection_joint_5_wy
        + outside.outside_joint_5_mz * screws.connection_joint_5_wz
        + outside.outside_joint_5_fx * screws.connection_joint_5_vx
        + outside.outside_joint_5_fy * screws.connection_joint_5_vy
        + outside.outside_joint_5_fz * screws.connection_joint_5_vz + 0.0;
    let shape_inertia_5_4 = outside.outside_joint_5_mx * screws.connection_joint_6_wx
        + outside.outside_joint_5_my * screws.connection_joint_6_wy
        + outside.outside_joint_5_mz * screws.connection_joint_6_wz
        + outside.outside_joint_5_fx * screws.connection_joint_6_vx
        + outside.outside_joint_5_fy * screws.connection_joint_6_vy
        + outside.outside_joint_5_fz * screws.connection_joint_6_vz;
    shape_inertia[4][5] = shape_inertia_5_4 + 0.0;
    let shape_inertia_6_4 = outside.outside_joint_5_mx * screws.connection_joint_7_wx
        + outside.outside_joint_5_my * screws.connection_joint_7_wy
        + outside.outside_joint_5_mz * screws.connection_joint_7_wz
        + outside.outside_joint_5_fx * screws.connection_joint_7_vx
        + outside.outside_joint_5_fy * screws.connection_joint_7_vy
        + outside.outside_joint_5_fz * screws.connection_joint_7_vz;
    shape_inertia[4][6] = shape_inertia_6_4 + 0.0;
    // Λ_q column joint_6
    shape_inertia[5][0] = shape_inertia_5_0 + 0.0;
    shape_inertia[5][1] = shape_inertia_5_1 + 0.0;
    shape_inertia[5][2] = shape_inertia_5_2 + 0.0;
    shape_inertia[5][3] = shape_inertia_5_3 + 0.0;
    shape_inertia[5][4] = shape_inertia_5_4 + 0.0;
    shape_inertia[5][5] = outside.outside_joint_6_mx * screws.connection_joint_6_wx
        + outside.outside_joint_6_my * screws.connection_joint_6_wy
        + outside.outside_joint_6_mz * screws.connection_joint_6_wz
        + outside.outside_joint_6_fx * screws.connection_joint_6_vx
        + outside.outside_joint_6_fy * screws.connection_joint_6_vy
        + outside.outside_joint_6_fz * screws.connection_joint_6_vz + 0.0;
    let shape_inertia_6_5 = outside.outside_joint_6_mx * screws.connection_joint_7_wx
        + outside.outside_joint_6_my * screws.connection_joint_7_wy
        + outside.outside_joint_6_mz * screws.connection_joint_7_wz
        + outside.outside_joint_6_fx * screws.connection_joint_7_vx
        + outside.outside_joint_6_fy * screws.connection_joint_7_vy
        + outside.outside_joint_6_fz * screws.connection_joint_7_vz;
    shape_inertia[5][6] = shape_inertia_6_5 + 0.0;
    // Λ_q column joint_7
    shape_inertia[6][0] = shape_inertia_6_0 + 0.0;
    shape_inertia[6][1] = shape_inertia_6_1 + 0.0;
    shape_inertia[6][2] = shape_inertia_6_2 + 0.0;
    shape_inertia[6][3] = shape_inertia_6_3 + 0.0;
    shape_inertia[6][4] = shape_inertia_6_4 + 0.0;
    shape_inertia[6][5] = shape_inertia_6_5 + 0.0;
    shape_inertia[6][6] = outside.outside_joint_7_mx * screws.connection_joint_7_wx
        + outside.outside_joint_7_my * screws.connection_joint_7_wy
        + outside.outside_joint_7_mz * screws.connection_joint_7_wz
        + outside.outside_joint_7_fx * screws.connection_joint_7_vx
        + outside.outside_joint_7_fy * screws.connection_joint_7_vy
        + outside.outside_joint_7_fz * screws.connection_joint_7_vz + 0.0;
}
/// What only `d_mu` computes.
#[inline(never)]
fn d_mu_itself(
    mu: &[f64; 6],
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    common_d_mu_and_7_more: &CommonDMuAnd7More,
    common_d_mu_b2: &CommonDMuB2,
    d_mu: &mut [[f64; 13]; 13],
) {
    let d_mu_0_0_3_0 = mu[0] * 17.5;
    let d_mu_0_0_3 = d_mu_0_0_3_0 * poses.com_z;
    let d_mu_0_0_1 = d_mu_0_0_3_0 * poses.com_y;
    // D_μ column 0
    d_mu[0][0] = 0.0 - (poses.com_z * d_mu_0_0_1 - poses.com_y * d_mu_0_0_3);
    let six_joint_1_mx_11 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let d_mu_1_0_0_1 = (inertias.composite_base_xx + inertias.composite_base_yy
        + inertias.composite_base_zz) * 0.5;
    let d_mu_1_0_0 = mu[2] * d_mu_1_0_0_1 - six_joint_1_mx_11;
    let d_mu_1_0_4_1_0 = mu[2] * 17.5;
    let d_mu_1_0_4_0_0 = mu[1] * 17.5;
    let d_mu_1_0_4_1 = d_mu_1_0_4_1_0 * poses.com_z;
    let d_mu_1_0_4_0 = d_mu_1_0_4_0_0 * poses.com_y;
    let d_mu_1_0_4 = d_mu_1_0_4_0 + d_mu_1_0_4_1;
    d_mu[0][1] = 0.0
        - (d_mu_1_0_0 + (poses.com_x * d_mu_0_0_3 + poses.com_z * d_mu_1_0_4));
    let six_joint_1_mx_9 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let d_mu_2_0_0 = mu[1] * d_mu_1_0_0_1 - six_joint_1_mx_9;
    d_mu[0][2] = d_mu_2_0_0 + (poses.com_x * d_mu_0_0_1 + poses.com_y * d_mu_1_0_4)
        + 0.0;
    d_mu[0][3] = 0.0 - d_mu_1_0_4;
    d_mu[0][4] = d_mu_0_0_1 + 0.0;
    d_mu[0][5] = d_mu_0_0_3 + 0.0;
    let six_joint_1_mx_1 = inertias.composite_link_1_xy + inertias.composite_link_1_xy;
    let six_joint_1_mx_0_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
    let six_joint_1_mx_0 = six_joint_1_mx_0_1 + six_joint_1_mx_0_1;
    let six_joint_1_mx_3 = inertias.composite_link_1_xx - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 - inertias.inside_joint_1_mz_1_1);
    let six_joint_1_fy_2_0 = mu[3] + (mu[1] * poses.com_z - mu[2] * poses.com_y);
    let six_joint_1_fz_6_0 = mu[4] + (mu[2] * poses.com_x - mu[0] * poses.com_z);
    let six_joint_1_fy_0_0 = mu[5] + (mu[0] * poses.com_y - mu[1] * poses.com_x);
    let six_joint_1_fy_2 = six_joint_1_fy_2_0 * 17.5;
    let six_joint_1_fz_6 = six_joint_1_fz_6_0 * 17.5;
    let six_joint_1_fy_0 = six_joint_1_fy_0_0 * 17.5;
    let six_joint_1_fz_0 = mu[0] * 0.5;
    let six_joint_1_fz_2 = mu[1] * 0.5;
    let six_joint_1_fy_4 = mu[2] * 0.5;
    let six_joint_1_mx_8 = six_joint_1_fy_0_0 * 0.5;
    let six_joint_1_fy = six_joint_1_fy_0 * screws.connection_joint_1_wx
        - six_joint_1_fy_2 * screws.connection_joint_1_wz
        - six_joint_1_fy_4 * screws.minus_inside_joint_1_fx;
    let six_joint_1_fz = six_joint_1_fz_0 * screws.inside_joint_1_fy
        + six_joint_1_fz_2 * screws.minus_inside_joint_1_fx
        + (six_joint_1_fy_2 * screws.connection_joint_1_wy
            - six_joint_1_fz_6 * screws.connection_joint_1_wx);
    let six_joint_1_mx = (six_joint_1_mx_0 - six_joint_1_mx_1) * six_joint_1_fz_0
        + six_joint_1_mx_3 * six_joint_1_fz_2
        - screws.inside_joint_1_my * six_joint_1_fy_4
        + screws.inside_joint_1_fy * six_joint_1_mx_8
        + (six_joint_1_mx_9 * screws.connection_joint_1_wz
            - six_joint_1_mx_11 * screws.connection_joint_1_wy
            - six_joint_1_fy_0 * screws.connection_joint_1_vy)
        + (six_joint_1_fz * poses.com_y - six_joint_1_fy * poses.com_z);
    d_mu[0][6] = six_joint_1_mx + 0.0;
    let six_joint_2_mx_9 = six_joint_1_fz_6_0 * 0.5;
    let six_joint_2_fy = six_joint_1_fy_4 * screws.inside_joint_2_fx
        - six_joint_1_fz_0 * screws.inside_joint_2_fz
        + (six_joint_1_fy_0 * screws.connection_joint_2_wx
            - six_joint_1_fy_2 * screws.connection_joint_2_wz);
    let six_joint_2_fz = six_joint_1_fz_0 * screws.inside_joint_2_fy
        - six_joint_1_fz_2 * screws.inside_joint_2_fx
        + (six_joint_1_fy_2 * screws.connection_joint_2_wy
            - six_joint_1_fz_6 * screws.connection_joint_2_wx);
    let six_joint_2_mx = common_d_mu_and_7_more.three_joint_2_x_0_0_0 * six_joint_1_fz_0
        - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_2_x_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_2_fy * six_joint_1_mx_8
            - screws.inside_joint_2_fz * six_joint_2_mx_9)
        + (six_joint_1_mx_9 * screws.connection_joint_2_wz
            - six_joint_1_mx_11 * screws.connection_joint_2_wy
            + (six_joint_1_fz_6 * screws.connection_joint_2_vz
                - six_joint_1_fy_0 * screws.connection_joint_2_vy))
        + (six_joint_2_fz * poses.com_y - six_joint_2_fy * poses.com_z);
    d_mu[0][7] = six_joint_2_mx + 0.0;
    let six_joint_3_fy = six_joint_1_fy_4 * screws.inside_joint_3_fx
        - six_joint_1_fz_0 * screws.inside_joint_3_fz
        + (six_joint_1_fy_0 * screws.connection_joint_3_wx
            - six_joint_1_fy_2 * screws.connection_joint_3_wz);
    let six_joint_3_fz = six_joint_1_fz_0 * screws.inside_joint_3_fy
        - six_joint_1_fz_2 * screws.inside_joint_3_fx
        + (six_joint_1_fy_2 * screws.connection_joint_3_wy
            - six_joint_1_fz_6 * screws.connection_joint_3_wx);
    let six_joint_3_mx = common_d_mu_and_7_more.three_joint_3_x_0_0_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_3_x_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_3_x_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_3_fy * six_joint_1_mx_8
            - screws.inside_joint_3_fz * six_joint_2_mx_9)
        + (six_joint_1_mx_9 * screws.connection_joint_3_wz
            - six_joint_1_mx_11 * screws.connection_joint_3_wy
            + (six_joint_1_fz_6 * screws.connection_joint_3_vz
                - six_joint_1_fy_0 * screws.connection_joint_3_vy))
        + (six_joint_3_fz * poses.com_y - six_joint_3_fy * poses.com_z);
    d_mu[0][8] = six_joint_3_mx + 0.0;
    let six_joint_4_fy = six_joint_1_fy_4 * screws.inside_joint_4_fx
        - six_joint_1_fz_0 * screws.inside_joint_4_fz
        + (six_joint_1_fy_0 * screws.connection_joint_4_wx
            - six_joint_1_fy_2 * screws.connection_joint_4_wz);
    let six_joint_4_fz = six_joint_1_fz_0 * screws.inside_joint_4_fy
        - six_joint_1_fz_2 * screws.inside_joint_4_fx
        + (six_joint_1_fy_2 * screws.connection_joint_4_wy
            - six_joint_1_fz_6 * screws.connection_joint_4_wx);
    let six_joint_4_mx = common_d_mu_and_7_more.three_joint_4_x_0_0_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_4_x_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_4_x_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_4_fy * six_joint_1_mx_8
            - screws.inside_joint_4_fz * six_joint_2_mx_9)
        + (six_joint_1_mx_9 * screws.connection_joint_4_wz
            - six_joint_1_mx_11 * screws.connection_joint_4_wy
            + (six_joint_1_fz_6 * screws.connection_joint_4_vz
                - six_joint_1_fy_0 * screws.connection_joint_4_vy))
        + (six_joint_4_fz * poses.com_y - six_joint_4_fy * poses.com_z);
    d_mu[0][9] = six_joint_4_mx + 0.0;
    let six_joint_5_fy = six_joint_1_fy_4 * screws.inside_joint_5_fx
        - six_joint_1_fz_0 * screws.inside_joint_5_fz
        + (six_joint_1_fy_0 * screws.connection_joint_5_wx
            - six_joint_1_fy_2 * screws.connection_joint_5_wz);
    let six_joint_5_fz = six_joint_1_fz_0 * screws.inside_joint_5_fy
        - six_joint_1_fz_2 * screws.inside_joint_5_fx
        + (six_joint_1_fy_2 * screws.connection_joint_5_wy
            - six_joint_1_fz_6 * screws.connection_joint_5_wx);
    let six_joint_5_mx = common_d_mu_and_7_more.three_joint_5_x_0_0_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_5_x_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_5_x_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_5_fy * six_joint_1_mx_8
            - screws.inside_joint_5_fz * six_joint_2_mx_9)
        + (six_joint_1_mx_9 * screws.connection_joint_5_wz
            - six_joint_1_mx_11 * screws.connection_joint_5_wy
            + (six_joint_1_fz_6 * screws.connection_joint_5_vz
                - six_joint_1_fy_0 * screws.connection_joint_5_vy))
        + (six_joint_5_fz * poses.com_y - six_joint_5_fy * poses.com_z);
    d_mu[0][10] = six_joint_5_mx + 0.0;
    let six_joint_6_fy = six_joint_1_fy_4 * screws.inside_joint_6_fx
        - six_joint_1_fz_0 * screws.inside_joint_6_fz
        + (six_joint_1_fy_0 * screws.connection_joint_6_wx
            - six_joint_1_fy_2 * screws.connection_joint_6_wz);
    let six_joint_6_fz = six_joint_1_fz_0 * screws.inside_joint_6_fy
        - six_joint_1_fz_2 * screws.inside_joint_6_fx
        + (six_joint_1_fy_2 * screws.connection_joint_6_wy
            - six_joint_1_fz_6 * screws.connection_joint_6_wx);
    let six_joint_6_mx = common_d_mu_and_7_more.three_joint_6_x_0_0_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_6_x_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_6_x_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_6_fy * six_joint_1_mx_8
            - screws.inside_joint_6_fz * six_joint_2_mx_9)
        + (six_joint_1_mx_9 * screws.connection_joint_6_wz
            - six_joint_1_mx_11 * screws.connection_joint_6_wy
            + (six_joint_1_fz_6 * screws.connection_joint_6_vz
                - six_joint_1_fy_0 * screws.connection_joint_6_vy))
        + (six_joint_6_fz * poses.com_y - six_joint_6_fy * poses.com_z);
    d_mu[0][11] = six_joint_6_mx + 0.0;
    let six_joint_7_fy = six_joint_1_fy_4 * screws.inside_joint_7_fx
        - six_joint_1_fz_0 * screws.inside_joint_7_fz
        + (six_joint_1_fy_0 * screws.connection_joint_7_wx
            - six_joint_1_fy_2 * screws.connection_joint_7_wz);
    let six_joint_7_fz = six_joint_1_fz_0 * screws.inside_joint_7_fy
        - six_joint_1_fz_2 * screws.inside_joint_7_fx
        + (six_joint_1_fy_2 * screws.connection_joint_7_wy
            - six_joint_1_fz_6 * screws.connection_joint_7_wx);
    let six_joint_7_mx = common_d_mu_and_7_more.three_joint_7_x_0_0_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_7_x_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_7_x_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_7_fy * six_joint_1_mx_8
            - screws.inside_joint_7_fz * six_joint_2_mx_9)
        + (six_joint_1_mx_9 * screws.connection_joint_7_wz
            - six_joint_1_mx_11 * screws.connection_joint_7_wy
            + (six_joint_1_fz_6 * screws.connection_joint_7_vz
                - six_joint_1_fy_0 * screws.connection_joint_7_vy))
        + (six_joint_7_fz * poses.com_y - six_joint_7_fy * poses.com_z);
    d_mu[0][12] = six_joint_7_mx + 0.0;
    let d_mu_0_1_2 = d_mu_1_0_4_0_0 * poses.com_z;
    let d_mu_0_1_4_0 = d_mu_0_0_3_0 * poses.com_x;
    let d_mu_0_1_4 = d_mu_0_1_4_0 + d_mu_1_0_4_1;
    // D_μ column 1
    d_mu[1][0] = d_mu_1_0_0 + (poses.com_y * d_mu_0_1_2 + poses.com_z * d_mu_0_1_4)
        + 0.0;
    let d_mu_1_1_3 = d_mu_1_0_4_0_0 * poses.com_x;
    d_mu[1][1] = 0.0 - (poses.com_x * d_mu_0_1_2 - poses.com_z * d_mu_1_1_3);
    let six_joint_1_my_11 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let d_mu_2_1_0 = mu[0] * d_mu_1_0_0_1 - six_joint_1_my_11;
    d_mu[1][2] = 0.0
        - (d_mu_2_1_0 + (poses.com_x * d_mu_0_1_4 + poses.com_y * d_mu_1_1_3));
    d_mu[1][3] = d_mu_1_1_3 + 0.0;
    d_mu[1][4] = 0.0 - d_mu_0_1_4;
    d_mu[1][5] = d_mu_0_1_2 + 0.0;
    let six_joint_1_my_3_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let six_joint_1_my_3 = six_joint_1_my_3_1 + six_joint_1_my_3_1;
    let six_joint_1_fx = six_joint_1_fz_6 * screws.connection_joint_1_wz
        - six_joint_1_fy_0 * screws.connection_joint_1_wy
        - six_joint_1_fy_4 * screws.inside_joint_1_fy;
    let six_joint_1_my = six_joint_1_mx_3 * six_joint_1_fz_0
        + (six_joint_1_mx_1 - six_joint_1_my_3) * six_joint_1_fz_2
        + screws.inside_joint_1_mx * six_joint_1_fy_4
        + screws.minus_inside_joint_1_fx * six_joint_1_mx_8
        + (six_joint_1_mx_11 * screws.connection_joint_1_wx
            - six_joint_1_my_11 * screws.connection_joint_1_wz
            - six_joint_1_fy_0 * screws.minus_connection_joint_1_vx)
        + (six_joint_1_fx * poses.com_z - six_joint_1_fz * poses.com_x);
    d_mu[1][6] = six_joint_1_my + 0.0;
    let six_joint_2_my_7 = six_joint_1_fy_2_0 * 0.5;
    let six_joint_2_fx = six_joint_1_fz_2 * screws.inside_joint_2_fz
        - six_joint_1_fy_4 * screws.inside_joint_2_fy
        + (six_joint_1_fz_6 * screws.connection_joint_2_wz
            - six_joint_1_fy_0 * screws.connection_joint_2_wy);
    let six_joint_2_my = common_d_mu_and_7_more.three_joint_2_y_0_0_0 * six_joint_1_fz_2
        - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_2_y_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_2_fz * six_joint_2_my_7
            - screws.inside_joint_2_fx * six_joint_1_mx_8)
        + (six_joint_1_mx_11 * screws.connection_joint_2_wx
            - six_joint_1_my_11 * screws.connection_joint_2_wz
            + (six_joint_1_fy_0 * screws.connection_joint_2_vx
                - six_joint_1_fy_2 * screws.connection_joint_2_vz))
        + (six_joint_2_fx * poses.com_z - six_joint_2_fz * poses.com_x);
    d_mu[1][7] = six_joint_2_my + 0.0;
    let six_joint_3_fx = six_joint_1_fz_2 * screws.inside_joint_3_fz
        - six_joint_1_fy_4 * screws.inside_joint_3_fy
        + (six_joint_1_fz_6 * screws.connection_joint_3_wz
            - six_joint_1_fy_0 * screws.connection_joint_3_wy);
    let six_joint_3_my = common_d_mu_and_7_more.three_joint_3_x_0_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_3_y_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_3_fz * six_joint_2_my_7
            - screws.inside_joint_3_fx * six_joint_1_mx_8)
        + (six_joint_1_mx_11 * screws.connection_joint_3_wx
            - six_joint_1_my_11 * screws.connection_joint_3_wz
            + (six_joint_1_fy_0 * screws.connection_joint_3_vx
                - six_joint_1_fy_2 * screws.connection_joint_3_vz))
        + (six_joint_3_fx * poses.com_z - six_joint_3_fz * poses.com_x);
    d_mu[1][8] = six_joint_3_my + 0.0;
    let six_joint_4_fx = six_joint_1_fz_2 * screws.inside_joint_4_fz
        - six_joint_1_fy_4 * screws.inside_joint_4_fy
        + (six_joint_1_fz_6 * screws.connection_joint_4_wz
            - six_joint_1_fy_0 * screws.connection_joint_4_wy);
    let six_joint_4_my = common_d_mu_and_7_more.three_joint_4_x_0_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_4_y_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_4_fz * six_joint_2_my_7
            - screws.inside_joint_4_fx * six_joint_1_mx_8)
        + (six_joint_1_mx_11 * screws.connection_joint_4_wx
            - six_joint_1_my_11 * screws.connection_joint_4_wz
            + (six_joint_1_fy_0 * screws.connection_joint_4_vx
                - six_joint_1_fy_2 * screws.connection_joint_4_vz))
        + (six_joint_4_fx * poses.com_z - six_joint_4_fz * poses.com_x);
    d_mu[1][9] = six_joint_4_my + 0.0;
    let six_joint_5_fx = six_joint_1_fz_2 * screws.inside_joint_5_fz
        - six_joint_1_fy_4 * screws.inside_joint_5_fy
        + (six_joint_1_fz_6 * screws.connection_joint_5_wz
            - six_joint_1_fy_0 * screws.connection_joint_5_wy);
    let six_joint_5_my = common_d_mu_and_7_more.three_joint_5_x_0_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_5_y_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_5_fz * six_joint_2_my_7
            - screws.inside_joint_5_fx * six_joint_1_mx_8)
        + (six_joint_1_mx_11 * screws.connection_joint_5_wx
            - six_joint_1_my_11 * screws.connection_joint_5_wz
            + (six_joint_1_fy_0 * screws.connection_joint_5_vx
                - six_joint_1_fy_2 * screws.connection_joint_5_vz))
        + (six_joint_5_fx * poses.com_z - six_joint_5_fz * poses.com_x);
    d_mu[1][10] = six_joint_5_my + 0.0;
    let six_joint_6_fx = six_joint_1_fz_2 * screws.inside_joint_6_fz
        - six_joint_1_fy_4 * screws.inside_joint_6_fy
        + (six_joint_1_fz_6 * screws.connection_joint_6_wz
            - six_joint_1_fy_0 * screws.connection_joint_6_wy);
    let six_joint_6_my = common_d_mu_and_7_more.three_joint_6_x_0_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_6_y_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_6_fz * six_joint_2_my_7
            - screws.inside_joint_6_fx * six_joint_1_mx_8)
        + (six_joint_1_mx_11 * screws.connection_joint_6_wx
            - six_joint_1_my_11 * screws.connection_joint_6_wz
            + (six_joint_1_fy_0 * screws.connection_joint_6_vx
                - six_joint_1_fy_2 * screws.connection_joint_6_vz))
        + (six_joint_6_fx * poses.com_z - six_joint_6_fz * poses.com_x);
    d_mu[1][11] = six_joint_6_my + 0.0;
    let six_joint_7_fx = six_joint_1_fz_2 * screws.inside_joint_7_fz
        - six_joint_1_fy_4 * screws.inside_joint_7_fy
        + (six_joint_1_fz_6 * screws.connection_joint_7_wz
            - six_joint_1_fy_0 * screws.connection_joint_7_wy);
    let six_joint_7_my = common_d_mu_and_7_more.three_joint_7_x_0_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_7_y_0_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_7_fz * six_joint_2_my_7
            - screws.inside_joint_7_fx * six_joint_1_mx_8)
        + (six_joint_1_mx_11 * screws.connection_joint_7_wx
            - six_joint_1_my_11 * screws.connection_joint_7_wz
            + (six_joint_1_fy_0 * screws.connection_joint_7_vx
                - six_joint_1_fy_2 * screws.connection_joint_7_vz))
        + (six_joint_7_fx * poses.com_z - six_joint_7_fz * poses.com_x);
    d_mu[1][12] = six_joint_7_my + 0.0;
    let d_mu_0_2_4 = d_mu_1_0_4_1_0 * poses.com_y;
    let d_mu_0_2_2 = d_mu_0_1_4_0 + d_mu_1_0_4_0;
    // D_μ column 2
    d_mu[2][0] = 0.0
        - (d_mu_2_0_0 + (poses.com_y * d_mu_0_2_2 + poses.com_z * d_mu_0_2_4));
    let d_mu_1_2_4 = d_mu_1_0_4_1_0 * poses.com_x;
    d_mu[2][1] = d_mu_2_1_0 + (poses.com_x * d_mu_0_2_2 + poses.com_z * d_mu_1_2_4)
        + 0.0;
    d_mu[2][2] = 0.0 - (poses.com_y * d_mu_1_2_4 - poses.com_x * d_mu_0_2_4);
    d_mu[2][3] = d_mu_1_2_4 + 0.0;
    d_mu[2][4] = d_mu_0_2_4 + 0.0;
    d_mu[2][5] = 0.0 - d_mu_0_2_2;
    let six_joint_1_mz = screws.inside_joint_1_mx * six_joint_1_fz_2
        - screws.inside_joint_1_my * six_joint_1_fz_0
        + (six_joint_1_mx_0 - six_joint_1_my_3) * six_joint_1_fy_4
        - (screws.minus_inside_joint_1_fx * six_joint_2_mx_9
            + screws.inside_joint_1_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_1_wy
            - six_joint_1_mx_9 * screws.connection_joint_1_wx
            + (six_joint_1_fy_2 * screws.connection_joint_1_vy
                + six_joint_1_fz_6 * screws.minus_connection_joint_1_vx))
        + (six_joint_1_fy * poses.com_x - six_joint_1_fx * poses.com_y);
    d_mu[2][6] = six_joint_1_mz + 0.0;
    let six_joint_2_mz = common_d_mu_and_7_more.three_joint_2_x_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_2_y_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_2_z_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_2_fx * six_joint_2_mx_9
            - screws.inside_joint_2_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_2_wy
            - six_joint_1_mx_9 * screws.connection_joint_2_wx
            + (six_joint_1_fy_2 * screws.connection_joint_2_vy
                - six_joint_1_fz_6 * screws.connection_joint_2_vx))
        + (six_joint_2_fy * poses.com_x - six_joint_2_fx * poses.com_y);
    d_mu[2][7] = six_joint_2_mz + 0.0;
    let six_joint_3_mz = common_d_mu_and_7_more.three_joint_3_x_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_3_z_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_3_fx * six_joint_2_mx_9
            - screws.inside_joint_3_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_3_wy
            - six_joint_1_mx_9 * screws.connection_joint_3_wx
            + (six_joint_1_fy_2 * screws.connection_joint_3_vy
                - six_joint_1_fz_6 * screws.connection_joint_3_vx))
        + (six_joint_3_fy * poses.com_x - six_joint_3_fx * poses.com_y);
    d_mu[2][8] = six_joint_3_mz + 0.0;
    let six_joint_4_mz = common_d_mu_and_7_more.three_joint_4_x_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * six_joint_1_fz_2
        - common_d_mu_and_7_more.three_joint_4_z_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_4_fx * six_joint_2_mx_9
            - screws.inside_joint_4_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_4_wy
            - six_joint_1_mx_9 * screws.connection_joint_4_wx
            + (six_joint_1_fy_2 * screws.connection_joint_4_vy
                - six_joint_1_fz_6 * screws.connection_joint_4_vx))
        + (six_joint_4_fy * poses.com_x - six_joint_4_fx * poses.com_y);
    d_mu[2][9] = six_joint_4_mz + 0.0;
    let six_joint_5_mz = common_d_mu_and_7_more.three_joint_5_x_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_5_z_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_5_fx * six_joint_2_mx_9
            - screws.inside_joint_5_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_5_wy
            - six_joint_1_mx_9 * screws.connection_joint_5_wx
            + (six_joint_1_fy_2 * screws.connection_joint_5_vy
                - six_joint_1_fz_6 * screws.connection_joint_5_vx))
        + (six_joint_5_fy * poses.com_x - six_joint_5_fx * poses.com_y);
    d_mu[2][10] = six_joint_5_mz + 0.0;
    let six_joint_6_mz = common_d_mu_and_7_more.three_joint_6_x_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_6_z_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_6_fx * six_joint_2_mx_9
            - screws.inside_joint_6_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_6_wy
            - six_joint_1_mx_9 * screws.connection_joint_6_wx
            + (six_joint_1_fy_2 * screws.connection_joint_6_vy
                - six_joint_1_fz_6 * screws.connection_joint_6_vx))
        + (six_joint_6_fy * poses.com_x - six_joint_6_fx * poses.com_y);
    d_mu[2][11] = six_joint_6_mz + 0.0;
    let six_joint_7_mz = common_d_mu_and_7_more.three_joint_7_x_1_0 * six_joint_1_fz_0
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * six_joint_1_fz_2
        + common_d_mu_and_7_more.three_joint_7_z_1_0 * six_joint_1_fy_4
        + (screws.inside_joint_7_fx * six_joint_2_mx_9
            - screws.inside_joint_7_fy * six_joint_2_my_7)
        + (six_joint_1_my_11 * screws.connection_joint_7_wy
            - six_joint_1_mx_9 * screws.connection_joint_7_wx
            + (six_joint_1_fy_2 * screws.connection_joint_7_vy
                - six_joint_1_fz_6 * screws.connection_joint_7_vx))
        + (six_joint_7_fy * poses.com_x - six_joint_7_fx * poses.com_y);
    d_mu[2][12] = six_joint_7_mz + 0.0;
    // D_μ column 3
    d_mu[3][0] = d_mu_1_0_4 + 0.0;
    d_mu[3][1] = 0.0 - d_mu_1_1_3;
    d_mu[3][2] = 0.0 - d_mu_1_2_4;
    d_mu[3][3] = 0.0;
    d_mu[3][4] = 0.0 - d_mu_1_0_4_1_0;
    d_mu[3][5] = d_mu_1_0_4_0_0 + 0.0;
    d_mu[3][6] = six_joint_1_fx + 0.0;
    d_mu[3][7] = six_joint_2_fx + 0.0;
    d_mu[3][8] = six_joint_3_fx + 0.0;
    d_mu[3][9] = six_joint_4_fx + 0.0;
    d_mu[3][10] = six_joint_5_fx + 0.0;
    d_mu[3][11] = six_joint_6_fx + 0.0;
    d_mu[3][12] = six_joint_7_fx + 0.0;
    // D_μ column 4
    d_mu[4][0] = 0.0 - d_mu_0_0_1;
    d_mu[4][1] = d_mu_0_1_4 + 0.0;
    d_mu[4][2] = 0.0 - d_mu_0_2_4;
    d_mu[4][3] = d_mu_1_0_4_1_0 + 0.0;
    d_mu[4][4] = 0.0;
    d_mu[4][5] = 0.0 - d_mu_0_0_3_0;
    d_mu[4][6] = six_joint_1_fy + 0.0;
    d_mu[4][7] = six_joint_2_fy + 0.0;
    d_mu[4][8] = six_joint_3_fy + 0.0;
    d_mu[4][9] = six_joint_4_fy + 0.0;
    d_mu[4][10] = six_joint_5_fy + 0.0;
    d_mu[4][11] = six_joint_6_fy + 0.0;
    d_mu[4][12] = six_joint_7_fy + 0.0;
    // D_μ column 5
    d_mu[5][0] = 0.0 - d_mu_0_0_3;
    d_mu[5][1] = 0.0 - d_mu_0_1_2;
    d_mu[5][2] = d_mu_0_2_2 + 0.0;
    d_mu[5][3] = 0.0 - d_mu_1_0_4_0_0;
    d_mu[5][4] = d_mu_0_0_3_0 + 0.0;
    d_mu[5][5] = 0.0;
    d_mu[5][6] = six_joint_1_fz + 0.0;
    d_mu[5][7] = six_joint_2_fz + 0.0;
    d_mu[5][8] = six_joint_3_fz + 0.0;
    d_mu[5][9] = six_joint_4_fz + 0.0;
    d_mu[5][10] = six_joint_5_fz + 0.0;
    d_mu[5][11] = six_joint_6_fz + 0.0;
    d_mu[5][12] = six_joint_7_fz + 0.0;
    // D_μ column joint_1
    d_mu[6][0] = 0.0 - six_joint_1_mx;
    d_mu[6][1] = 0.0 - six_joint_1_my;
    d_mu[6][2] = 0.0 - six_joint_1_mz;
    d_mu[6][3] = 0.0 - six_joint_1_fx;
    d_mu[6][4] = 0.0 - six_joint_1_fy;
    d_mu[6][5] = 0.0 - six_joint_1_fz;
    d_mu[6][6] = 0.0;
    d_mu[6][7] = common_d_mu_b2.d_mu_7_6 + 0.0;
    d_mu[6][8] = common_d_mu_b2.d_mu_8_6 + 0.0;
    d_mu[6][9] = common_d_mu_b2.d_mu_9_6 + 0.0;
    d_mu[6][10] = common_d_mu_b2.d_mu_10_6 + 0.0;
    d_mu[6][11] = common_d_mu_b2.d_mu_11_6 + 0.0;
    d_mu[6][12] = common_d_mu_b2.d_mu_12_6 + 0.0;
    // D_μ column joint_2
    d_mu[7][0] = 0.0 - six_joint_2_mx;
    d_mu[7][1] = 0.0 - six_joint_2_my;
    d_mu[7][2] = 0.0 - six_joint_2_mz;
    d_mu[7][3] = 0.0 - six_joint_2_fx;
    d_mu[7][4] = 0.0 - six_joint_2_fy;
    d_mu[7][5] = 0.0 - six_joint_2_fz;
    d_mu[7][6] = 0.0 - common_d_mu_b2.d_mu_7_6;
    d_mu[7][7] = 0.0;
    d_mu[7][8] = common_d_mu_b2.d_mu_8_7 + 0.0;
    d_mu[7][9] = common_d_mu_b2.d_mu_9_7 + 0.0;
    d_mu[7][10] = common_d_mu_b2.d_mu_10_7 + 0.0;
    d_mu[7][11] = common_d_mu_b2.d_mu_11_7 + 0.0;
    d_mu[7][12] = common_d_mu_b2.d_mu_12_7 + 0.0;
    // D_μ column joint_3
    d_mu[8][0] = 0.0 - six_joint_3_mx;
    d_mu[8][1] = 0.0 - six_joint_3_my;
    d_mu[8][2] = 0.0 - six_joint_3_mz;
    d_mu[8][3] = 0.0 - six_joint_3_fx;
    d_mu[8][4] = 0.0 - six_joint_3_fy;
    d_mu[8][5] = 0.0 - six_joint_3_fz;
    d_mu[8][6] = 0.0 - common_d_mu_b2.d_mu_8_6;
    d_mu[8][7] = 0.0 - common_d_mu_b2.d_mu_8_7;
    d_mu[8][8] = 0.0;
    d_mu[8][9] = common_d_mu_b2.d_mu_9_8 + 0.0;
    d_mu[8][10] = common_d_mu_b2.d_mu_10_8 + 0.0;
    d_mu[8][11] = common_d_mu_b2.d_mu_11_8 + 0.0;
    d_mu[8][12] = common_d_mu_b2.d_mu_12_8 + 0.0;
    // D_μ column joint_4
    d_mu[9][0] = 0.0 - six_joint_4_mx;
    d_mu[9][1] = 0.0 - six_joint_4_my;
    d_mu[9][2] = 0.0 - six_joint_4_mz;
    d_mu[9][3] = 0.0 - six_joint_4_fx;
    d_mu[9][4] = 0.0 - six_joint_4_fy;
    d_mu[9][5] = 0.0 - six_joint_4_fz;
    d_mu[9][6] = 0.0 - common_d_mu_b2.d_mu_9_6;
    d_mu[9][7] = 0.0 - common_d_mu_b2.d_mu_9_7;
    d_mu[9][8] = 0.0 - common_d_mu_b2.d_mu_9_8;
    d_mu[9][9] = 0.0;
    d_mu[9][10] = common_d_mu_b2.d_mu_10_9 + 0.0;
    d_mu[9][11] = common_d_mu_b2.d_mu_11_9 + 0.0;
    d_mu[9][12] = common_d_mu_b2.d_mu_12_9 + 0.0;
    // D_μ column joint_5
    d_mu[10][0] = 0.0 - six_joint_5_mx;
    d_mu[10][1] = 0.0 - six_joint_5_my;
    d_mu[10][2] = 0.0 - six_joint_5_mz;
    d_mu[10][3] = 0.0 - six_joint_5_fx;
    d_mu[10][4] = 0.0 - six_joint_5_fy;
    d_mu[10][5] = 0.0 - six_joint_5_fz;
    d_mu[10][6] = 0.0 - common_d_mu_b2.d_mu_10_6;
    d_mu[10][7] = 0.0 - common_d_mu_b2.d_mu_10_7;
    d_mu[10][8] = 0.0 - common_d_mu_b2.d_mu_10_8;
    d_mu[10][9] = 0.0 - common_d_mu_b2.d_mu_10_9;
    d_mu[10][10] = 0.0;
    d_mu[10][11] = common_d_mu_b2.d_mu_11_10 + 0.0;
    d_mu[10][12] = common_d_mu_b2.d_mu_12_10 + 0.0;
    // D_μ column joint_6
    d_mu[11][0] = 0.0 - six_joint_6_mx;
    d_mu[11][1] = 0.0 - six_joint_6_my;
    d_mu[11][2] = 0.0 - six_joint_6_mz;
    d_mu[11][3] = 0.0 - six_joint_6_fx;
    d_mu[11][4] = 0.0 - six_joint_6_fy;
    d_mu[11][5] = 0.0 - six_joint_6_fz;
    d_mu[11][6] = 0.0 - common_d_mu_b2.d_mu_11_6;
    d_mu[11][7] = 0.0 - common_d_mu_b2.d_mu_11_7;
    d_mu[11][8] = 0.0 - common_d_mu_b2.d_mu_11_8;
    d_mu[11][9] = 0.0 - common_d_mu_b2.d_mu_11_9;
    d_mu[11][10] = 0.0 - common_d_mu_b2.d_mu_11_10;
    d_mu[11][11] = 0.0;
    d_mu[11][12] = common_d_mu_b2.d_mu_12_11 + 0.0;
    // D_μ column joint_7
    d_mu[12][0] = 0.0 - six_joint_7_mx;
    d_mu[12][1] = 0.0 - six_joint_7_my;
    d_mu[12][2] = 0.0 - six_joint_7_mz;
    d_mu[12][3] = 0.0 - six_joint_7_fx;
    d_mu[12][4] = 0.0 - six_joint_7_fy;
    d_mu[12][5] = 0.0 - six_joint_7_fz;
    d_mu[12][6] = 0.0 - common_d_mu_b2.d_mu_12_6;
    d_mu[12][7] = 0.0 - common_d_mu_b2.d_mu_12_7;
    d_mu[12][8] = 0.0 - common_d_mu_b2.d_mu_12_8;
    d_mu[12][9] = 0.0 - common_d_mu_b2.d_mu_12_9;
    d_mu[12][10] = 0.0 - common_d_mu_b2.d_mu_12_10;
    d_mu[12][11] = 0.0 - common_d_mu_b2.d_mu_12_11;
    d_mu[12][12] = 0.0;
}
/// What only `b2` computes.
#[inline(never)]
fn b2_itself(common_d_mu_b2: &CommonDMuB2, b2: &mut [[f64; 7]; 7]) {
    // B_2(μ) column joint_1
    b2[0][0] = 0.0;
    let b2_1_0 = common_d_mu_b2.d_mu_7_6 * 0.5;
    b2[0][1] = 0.0 - b2_1_0;
    let b2_2_0 = common_d_mu_b2.d_mu_8_6 * 0.5;
    b2[0][2] = 0.0 - b2_2_0;
    let b2_3_0 = common_d_mu_b2.d_mu_9_6 * 0.5;
    b2[0][3] = 0.0 - b2_3_0;
    let b2_4_0 = common_d_mu_b2.d_mu_10_6 * 0.5;
    b2[0][4] = 0.0 - b2_4_0;
    let b2_5_0 = common_d_mu_b2.d_mu_11_6 * 0.5;
    b2[0][5] = 0.0 - b2_5_0;
    let b2_6_0 = common_d_mu_b2.d_mu_12_6 * 0.5;
    b2[0][6] = 0.0 - b2_6_0;
    // B_2(μ) column joint_2
    b2[1][0] = b2_1_0 + 0.0;
    b2[1][1] = 0.0;
    let b2_2_1 = common_d_mu_b2.d_mu_8_7 * 0.5;
    b2[1][2] = 0.0 - b2_2_1;
    let b2_3_1 = common_d_mu_b2.d_mu_9_7 * 0.5;
    b2[1][3] = 0.0 - b2_3_1;
    let b2_4_1 = common_d_mu_b2.d_mu_10_7 * 0.5;
    b2[1][4] = 0.0 - b2_4_1;
    let b2_5_1 = common_d_mu_b2.d_mu_11_7 * 0.5;
    b2[1][5] = 0.0 - b2_5_1;
    let b2_6_1 = common_d_mu_b2.d_mu_12_7 * 0.5;
    b2[1][6] = 0.0 - b2_6_1;
    // B_2(μ) column joint_3
    b2[2][0] = b2_2_0 + 0.0;
    b2[2][1] = b2_2_1 + 0.0;
    b2[2][2] = 0.0;
    let b2_3_2 = common_d_mu_b2.d_mu_9_8 * 0.5;
    b2[2][3] = 0.0 - b2_3_2;
    let b2_4_2 = common_d_mu_b2.d_mu_10_8 * 0.5;
    b2[2][4] = 0.0 - b2_4_2;
    let b2_5_2 = common_d_mu_b2.d_mu_11_8 * 0.5;
    b2[2][5] = 0.0 - b2_5_2;
    let b2_6_2 = common_d_mu_b2.d_mu_12_8 * 0.5;
    b2[2][6] = 0.0 - b2_6_2;
    // B_2(μ) column joint_4
    b2[3][0] = b2_3_0 + 0.0;
    b2[3][1] = b2_3_1 + 0.0;
    b2[3][2] = b2_3_2 + 0.0;
    b2[3][3] = 0.0;
    let b2_4_3 = common_d_mu_b2.d_mu_10_9 * 0.5;
    b2[3][4] = 0.0 - b2_4_3;
    let b2_5_3 = common_d_mu_b2.d_mu_11_9 * 0.5;
    b2[3][5] = 0.0 - b2_5_3;
    let b2_6_3 = common_d_mu_b2.d_mu_12_9 * 0.5;
    b2[3][6] = 0.0 - b2_6_3;
    // B_2(μ) column joint_5
    b2[4][0] = b2_4_0 + 0.0;
    b2[4][1] = b2_4_1 + 0.0;
    b2[4][2] = b2_4_2 + 0.0;
    b2[4][3] = b2_4_3 + 0.0;
    b2[4][4] = 0.0;
    let b2_5_4 = common_d_mu_b2.d_mu_11_10 * 0.5;
    b2[4][5] = 0.0 - b2_5_4;
    let b2_6_4 = common_d_mu_b2.d_mu_12_10 * 0.5;
    b2[4][6] = 0.0 - b2_6_4;
    // B_2(μ) column joint_6
    b2[5][0] = b2_5_0 + 0.0;
    b2[5][1] = b2_5_1 + 0.0;
    b2[5][2] = b2_5_2 + 0.0;
    b2[5][3] = b2_5_3 + 0.0;
    b2[5][4] = b2_5_4 + 0.0;
    b2[5][5] = 0.0;
    let b2_6_5 = common_d_mu_b2.d_mu_12_11 * 0.5;
    b2[5][6] = 0.0 - b2_6_5;
    // B_2(μ) column joint_7
    b2[6][0] = b2_6_0 + 0.0;
    b2[6][1] = b2_6_1 + 0.0;
    b2[6][2] = b2_6_2 + 0.0;
    b2[6][3] = b2_6_3 + 0.0;
    b2[6][4] = b2_6_4 + 0.0;
    b2[6][5] = b2_6_5 + 0.0;
    b2[6][6] = 0.0;
}
use d_qdot_itself::*;
mod d_qdot_itself {
    #[allow(unused_imports, reason = "not every block stands on others")]
    use super::*;
    /// What only `d_qdot` computes.
    pub(super) struct DQdotItself {
        pub(super) factor_outside_link_1_xx: f64,
        pub(super) factor_outside_link_1_xy: f64,
        pub(super) factor_outside_link_1_xz_0: f64,
        pub(super) factor_outside_link_1_xz: f64,
        pub(super) factor_outside_link_1_yx: f64,
        pub(super) factor_outside_link_1_yy: f64,
        pub(super) factor_outside_link_1_yz_1: f64,
        pub(super) factor_outside_link_1_yz: f64,
        pub(super) factor_outside_link_1_zx: f64,
        pub(super) factor_outside_link_1_zy: f64,
        pub(super) factor_outside_link_1_zz_0: f64,
        pub(super) factor_outside_link_1_zz: f64,
        pub(super) factor_outside_link_1_px_2: f64,
        pub(super) factor_outside_link_1_py_2: f64,
    }
    /// What only `d_qdot` computes.
    #[inline(never)]
    pub(super) fn d_qdot_itself(
        qd: &[f64; 7],
        poses: &Poses,
        inertias: &Inertias,
        screws: &Screws,
        velocities: &Velocities,
        common_d_mu_and_7_more: &CommonDMuAnd7More,
        d_qdot: &mut [[f64; 13]; 13],
    ) -> DQdotItself {
        let d_qdot_0_0_1 = inertias.composite_link_1_xy + inertias.composite_link_1_xy;
        let d_qdot_0_0_0_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
        let d_qdot_0_0_0 = d_qdot_0_0_0_1 + d_qdot_0_0_0_1;
        let d_qdot_0_0_17_1_0 = velocities.minus_velocity_base_vz * 17.5 * 0.5;
        let d_qdot_0_0_17_0_0 = velocities.minus_velocity_base_vy * 17.5 * 0.5;
        let d_qdot_0_0_17_1 = d_qdot_0_0_17_1_0 * poses.com_z;
        let d_qdot_0_0_17_0 = d_qdot_0_0_17_0_0 * poses.com_y;
        let d_qdot_0_0_17 = d_qdot_0_0_17_0 + d_qdot_0_0_17_1;
        // D_q\u{307} column 0
        d_qdot[0][0] = ((d_qdot_0_0_0 - d_qdot_0_0_1) * qd[0]
            + common_d_mu_and_7_more.three_joint_2_x_0_0_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_x_0_0_0 * qd[2]
            + common_d_mu_and_7_more.three_joint_4_x_0_0_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_x_0_0_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_x_0_0_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_x_0_0_0 * qd[6]) * 0.5 + d_qdot_0_0_17
            + d_qdot_0_0_17 + 0.0;
        let d_qdot_1_0_0 = ((inertias.composite_link_1_xx - inertias.composite_link_1_yy
            - (inertias.inside_joint_1_mz_1_0 - inertias.inside_joint_1_mz_1_1)) * qd[0]
            - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_x_0_1_0 * qd[2]
            + common_d_mu_and_7_more.three_joint_4_x_0_1_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_x_0_1_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_x_0_1_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_x_0_1_0 * qd[6]) * 0.5;
        let d_qdot_1_0_1_0 = velocities.velocity_base_vx * 17.5 * 0.5;
        let d_qdot_1_0_1 = d_qdot_1_0_1_0 * poses.com_y;
        let d_qdot_1_0_2 = d_qdot_0_0_17_0_0 * poses.com_x;
        d_qdot[0][1] = d_qdot_1_0_0 + d_qdot_1_0_1 - d_qdot_1_0_2 + 0.0;
        let d_qdot_2_0_0 = (common_d_mu_and_7_more.three_joint_2_x_1_0 * qd[1]
            - screws.inside_joint_1_my * qd[0]
            + common_d_mu_and_7_more.three_joint_3_x_1_0 * qd[2]
            + common_d_mu_and_7_more.three_joint_4_x_1_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_x_1_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_x_1_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_x_1_0 * qd[6]) * 0.5;
        let d_qdot_2_0_1 = d_qdot_1_0_1_0 * poses.com_z;
        let d_qdot_2_0_2 = d_qdot_0_0_17_1_0 * poses.com_x;
        d_qdot[0][2] = d_qdot_2_0_0 + d_qdot_2_0_1 - d_qdot_2_0_2 + 0.0;
        d_qdot[0][3] = 0.0;
        d_qdot[0][4] = 0.0 - d_qdot_0_0_17_1_0;
        d_qdot[0][5] = d_qdot_0_0_17_0_0 + 0.0;
        d_qdot[0][6] = 0.0;
        d_qdot[0][7] = 0.0;
        d_qdot[0][8] = 0.0;
        d_qdot[0][9] = 0.0;
        d_qdot[0][10] = 0.0;
        d_qdot[0][11] = 0.0;
        d_qdot[0][12] = 0.0;
        // D_q\u{307} column 1
        d_qdot[1][0] = d_qdot_1_0_0 - d_qdot_1_0_2 + d_qdot_1_0_1 + 0.0;
        let d_qdot_1_1_1_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
        let d_qdot_1_1_1 = d_qdot_1_1_1_1 + d_qdot_1_1_1_1;
        let d_qdot_1_1_17_0 = d_qdot_1_0_1_0 * poses.com_x;
        let d_qdot_1_1_17 = d_qdot_1_1_17_0 - d_qdot_0_0_17_1;
        d_qdot[1][1] = ((d_qdot_0_0_1 - d_qdot_1_1_1) * qd[0]
            + common_d_mu_and_7_more.three_joint_2_y_0_0_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_y_0_1_0 * qd[2]
            + common_d_mu_and_7_more.three_joint_4_y_0_1_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_y_0_1_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_y_0_1_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_y_0_1_0 * qd[6]) * 0.5 - d_qdot_1_1_17
            - d_qdot_1_1_17 + 0.0;
        let d_qdot_2_1_0 = (screws.inside_joint_1_mx * qd[0]
            + common_d_mu_and_7_more.three_joint_2_y_1_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_y_1_0 * qd[2]
            + common_d_mu_and_7_more.three_joint_4_y_1_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_y_1_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_y_1_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_y_1_0 * qd[6]) * 0.5;
        let d_qdot_2_1_1 = d_qdot_0_0_17_0_0 * poses.com_z;
        let d_qdot_2_1_2 = d_qdot_0_0_17_1_0 * poses.com_y;
        d_qdot[1][2] = d_qdot_2_1_0 - d_qdot_2_1_1 - d_qdot_2_1_2 + 0.0;
        d_qdot[1][3] = d_qdot_0_0_17_1_0 + 0.0;
        d_qdot[1][4] = 0.0;
        d_qdot[1][5] = d_qdot_1_0_1_0 + 0.0;
        d_qdot[1][6] = 0.0;
        d_qdot[1][7] = 0.0;
        d_qdot[1][8] = 0.0;
        d_qdot[1][9] = 0.0;
        d_qdot[1][10] = 0.0;
        d_qdot[1][11] = 0.0;
        d_qdot[1][12] = 0.0;
        // D_q\u{307} column 2
        d_qdot[2][0] = d_qdot_2_0_0 - d_qdot_2_0_2 + d_qdot_2_0_1 + 0.0;
        d_qdot[2][1] = d_qdot_2_1_0 - d_qdot_2_1_2 - d_qdot_2_1_1 + 0.0;
        let d_qdot_2_2_17 = d_qdot_1_1_17_0 - d_qdot_0_0_17_0;
        d_qdot[2][2] = ((d_qdot_0_0_0 - d_qdot_1_1_1) * qd[0]
            + common_d_mu_and_7_more.three_joint_2_z_1_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_z_1_0 * qd[2]
            - common_d_mu_and_7_more.three_joint_4_z_1_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_z_1_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_z_1_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_z_1_0 * qd[6]) * 0.5 - d_qdot_2_2_17
            - d_qdot_2_2_17 + 0.0;
        d_qdot[2][3] = 0.0 - d_qdot_0_0_17_0_0;
        d_qdot[2][4] = 0.0 - d_qdot_1_0_1_0;
        d_qdot[2][5] = 0.0;
        d_qdot[2][6] = 0.0;
        d_qdot[2][7] = 0.0;
        d_qdot[2][8] = 0.0;
        d_qdot[2][9] = 0.0;
        d_qdot[2][10] = 0.0;
        d_qdot[2][11] = 0.0;
        d_qdot[2][12] = 0.0;
        // D_q\u{307} column 3
        d_qdot[3][0] = 0.0;
        d_qdot[3][1] = d_qdot_0_0_17_1_0 + 0.0;
        d_qdot[3][2] = 0.0 - d_qdot_0_0_17_0_0;
        d_qdot[3][3] = 0.0;
        d_qdot[3][4] = 0.0;
        d_qdot[3][5] = 0.0;
        d_qdot[3][6] = 0.0;
        d_qdot[3][7] = 0.0;
        d_qdot[3][8] = 0.0;
        d_qdot[3][9] = 0.0;
        d_qdot[3][10] = 0.0;
        d_qdot[3][11] = 0.0;
        d_qdot[3][12] = 0.0;
        // D_q\u{307} column 4
        d_qdot[4][0] = 0.0 - d_qdot_0_0_17_1_0;
        d_qdot[4][1] = 0.0;
        d_qdot[4][2] = 0.0 - d_qdot_1_0_1_0;
        d_qdot[4][3] = 0.0;
        d_qdot[4][4] = 0.0;
        d_qdot[4][5] = 0.0;
        d_qdot[4][6] = 0.0;
        d_qdot[4][7] = 0.0;
        d_qdot[4][8] = 0.0;
        d_qdot[4][9] = 0.0;
        d_qdot[4][10] = 0.0;
        d_qdot[4][11] = 0.0;
        d_qdot[4][12] = 0.0;
        // D_q\u{307} column 5
        d_qdot[5][0] = d_qdot_0_0_17_0_0 + 0.0;
        d_qdot[5][1] = d_qdot_1_0_1_0 + 0.0;
        d_qdot[5][2] = 0.0;
        d_qdot[5][3] = 0.0;
        d_qdot[5][4] = 0.0;
        d_qdot[5][5] = 0.0;
        d_qdot[5][6] = 0.0;
        d_qdot[5][7] = 0.0;
        d_qdot[5][8] = 0.0;
        d_qdot[5][9] = 0.0;
        d_qdot[5][10] = 0.0;
        d_qdot[5][11] = 0.0;
        d_qdot[5][12] = 0.0;
        // D_q\u{307} column joint_1
        d_qdot[6][0] = 0.0;
        d_qdot[6][1] = 0.0;
        d_qdot[6][2] = 0.0;
        d_qdot[6][3] = 0.0;
        d_qdot[6][4] = 0.0;
        d_qdot[6][5] = 0.0;
        let factor_outside_link_1_yz_0_1 = (inertias.inertia_base_xx
            + inertias.inertia_base_yy + inertias.inertia_base_zz) * 0.5;
        let factor_outside_link_1_yz_0_2 = inertias.minus_inertia_base_xy
            * velocities.minus_velocity_base_wy;
        let factor_outside_link_1_zy_0 = inertias.minus_inertia_base_xz
            * velocities.minus_velocity_base_wz;
        let factor_outside_link_1_xz_3_2 = inertias.minus_inertia_base_xy
            * velocities.minus_velocity_base_wx;
        let factor_outside_link_1_zx_3 = inertias.minus_inertia_base_yz
            * velocities.minus_velocity_base_wz;
        let factor_outside_link_1_xy_4 = inertias.minus_inertia_base_xz
            * velocities.minus_velocity_base_wx;
        let factor_outside_link_1_yx_0 = inertias.minus_inertia_base_yz
            * velocities.minus_velocity_base_wy;
        let factor_outside_link_1_yz_0 = velocities.minus_velocity_base_wx
            * factor_outside_link_1_yz_0_1
            + (factor_outside_link_1_yz_0_2
                - inertias.inertia_base_xx * velocities.minus_velocity_base_wx
                + factor_outside_link_1_zy_0);
        let factor_outside_link_1_xz_3 = velocities.minus_velocity_base_wy
            * factor_outside_link_1_yz_0_1
            + (factor_outside_link_1_xz_3_2
                - inertias.inertia_base_yy * velocities.minus_velocity_base_wy
                + factor_outside_link_1_zx_3);
        let factor_outside_link_1_xy_5 = velocities.minus_velocity_base_wz
            * factor_outside_link_1_yz_0_1
            + (factor_outside_link_1_xy_4 + factor_outside_link_1_yx_0
                - inertias.inertia_base_zz * velocities.minus_velocity_base_wz);
        let factor_outside_link_1_xx_2 = inertias.minus_inertia_base_hx
            * velocities.velocity_base_vx;
        let factor_outside_link_1_yy_2 = inertias.minus_inertia_base_hy
            * velocities.minus_velocity_base_vy;
        let factor_outside_link_1_zz_1 = inertias.minus_inertia_base_hz
            * velocities.minus_velocity_base_vz;
        let factor_outside_link_1_xx_3 = factor_outside_link_1_yy_2
            - factor_outside_link_1_xx_2 + factor_outside_link_1_zz_1;
        let factor_outside_link_1_xx_0 = velocities.minus_velocity_base_wy
            * inertias.minus_inertia_base_xz;
        let factor_outside_link_1_xx_1 = velocities.minus_velocity_base_wz
            * inertias.minus_inertia_base_xy;
        let factor_outside_link_1_xx = factor_outside_link_1_xx_0
            - factor_outside_link_1_xx_1 + factor_outside_link_1_xx_2
            + factor_outside_link_1_xx_3;
        let factor_outside_link_1_xy = velocities.velocity_base_vx
            * inertias.minus_inertia_base_hy
            - (velocities.minus_velocity_base_wz * inertias.inertia_base_xx
                + factor_outside_link_1_xy_4) + factor_outside_link_1_xy_5;
        let factor_outside_link_1_xz_0 = factor_outside_link_1_xz_3_2
            + velocities.minus_velocity_base_wy * inertias.inertia_base_xx;
        let factor_outside_link_1_xz = factor_outside_link_1_xz_0
            + velocities.velocity_base_vx * inertias.minus_inertia_base_hz
            - factor_outside_link_1_xz_3;
        let factor_outside_link_1_yx = factor_outside_link_1_yx_0
            + velocities.minus_velocity_base_wz * inertias.inertia_base_yy
            - velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hx
            - factor_outside_link_1_xy_5;
        let factor_outside_link_1_yy_1 = velocities.minus_velocity_base_wx
            * inertias.minus_inertia_base_yz;
        let factor_outside_link_1_yy = factor_outside_link_1_xx_1
            - factor_outside_link_1_yy_1 - factor_outside_link_1_yy_2
            + factor_outside_link_1_xx_3;
        let factor_outside_link_1_yz_1 = velocities.minus_velocity_base_wx
            * inertias.inertia_base_yy + factor_outside_link_1_yz_0_2;
        let factor_outside_link_1_yz = factor_outside_link_1_yz_0
            - (factor_outside_link_1_yz_1
                + velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hz);
        let factor_outside_link_1_zx = factor_outside_link_1_xz_3
            - (velocities.minus_velocity_base_wy * inertias.inertia_base_zz
                + factor_outside_link_1_zx_3
                + velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hx);
        let factor_outside_link_1_zy = factor_outside_link_1_zy_0
            + velocities.minus_velocity_base_wx * inertias.inertia_base_zz
            - velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hy
            - factor_outside_link_1_yz_0;
        let factor_outside_link_1_zz_0 = factor_outside_link_1_yy_1
            - factor_outside_link_1_xx_0;
        let factor_outside_link_1_zz = factor_outside_link_1_zz_0
            - factor_outside_link_1_zz_1 + factor_outside_link_1_xx_3;
        let factor_outside_link_1_px_2 = velocities.minus_velocity_base_wy
            * inertias.minus_inertia_base_hz;
        let factor_outside_link_1_py_2 = velocities.minus_velocity_base_wx
            * inertias.minus_inertia_base_hz;
        DQdotItself {
            factor_outside_link_1_xx,
            factor_outside_link_1_xy,
            factor_outside_link_1_xz_0,
            factor_outside_link_1_xz,
            factor_outside_link_1_yx,
            factor_outside_link_1_yy,
            factor_outside_link_1_yz_1,
            factor_outside_link_1_yz,
            factor_outside_link_1_zx,
            factor_outside_link_1_zy,
            factor_outside_link_1_zz_0,
            factor_outside_link_1_zz,
            factor_outside_link_1_px_2,
            factor_outside_link_1_py_2,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromFactorOutsideLink1Px {
        pub(super) factor_outside_link_1_px: f64,
        pub(super) factor_outside_link_1_py: f64,
        pub(super) factor_outside_link_1_pz: f64,
        pub(super) factor_link_1_xx_0: f64,
        pub(super) factor_link_1_xy_0: f64,
        pub(super) factor_link_1_xz_0: f64,
        pub(super) factor_link_1_yx_0: f64,
        pub(super) factor_link_1_yy_0: f64,
        pub(super) factor_link_1_yz_0: f64,
        pub(super) factor_link_1_zx_0: f64,
        pub(super) factor_link_1_zy_0: f64,
        pub(super) factor_link_1_zz_0: f64,
        pub(super) factor_link_2_xx_0: f64,
        pub(super) factor_link_2_xy_0: f64,
        pub(super) factor_link_2_xz_0: f64,
        pub(super) factor_link_2_yx_0: f64,
        pub(super) factor_link_2_yy_0: f64,
        pub(super) factor_link_2_yz_0: f64,
        pub(super) factor_link_2_zx_0: f64,
        pub(super) factor_link_2_zy_0: f64,
        pub(super) factor_link_2_zz_0: f64,
        pub(super) factor_link_3_xx_0: f64,
        pub(super) factor_link_3_xy_0: f64,
        pub(super) factor_link_3_xz_0: f64,
        pub(super) factor_link_3_yx_0: f64,
        pub(super) factor_link_3_yy_0: f64,
        pub(super) factor_link_3_yz_0: f64,
        pub(super) factor_link_3_zx_0: f64,
        pub(super) factor_link_3_zy_0: f64,
        pub(super) factor_link_3_zz_0: f64,
        pub(super) factor_link_4_xx_0: f64,
        pub(super) factor_link_4_xy_0: f64,
        pub(super) factor_link_4_xz_0: f64,
        pub(super) factor_link_4_yx_0: f64,
        pub(super) factor_link_4_yy_0: f64,
        pub(super) factor_link_4_yz_0: f64,
        pub(super) factor_link_4_zx_0: f64,
        pub(super) factor_link_4_zy_0: f64,
        pub(super) factor_link_4_zz_0: f64,
        pub(super) factor_link_5_yz_0_5_1: f64,
        pub(super) factor_link_5_yz_0_5_4: f64,
        pub(super) factor_link_5_yz_0_5_5: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_factor_outside_link_1_px(
        inertias: &Inertias,
        velocities: &Velocities,
        d_qdot_itself: &DQdotItself,
    ) -> DQdotItselfFromFactorOutsideLink1Px {
        let factor_outside_link_1_px = velocities.velocity_base_vx * 3.5
            + (d_qdot_itself.factor_outside_link_1_px_2
                - velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hy);
        let factor_outside_link_1_py = velocities.minus_velocity_base_wz
            * inertias.minus_inertia_base_hx - d_qdot_itself.factor_outside_link_1_py_2
            - velocities.minus_velocity_base_vy * 3.5;
        let factor_outside_link_1_pz = velocities.minus_velocity_base_wx
            * inertias.minus_inertia_base_hy
            - velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hx
            - velocities.minus_velocity_base_vz * 3.5;
        let factor_link_1_yz_0_5_1 = (inertias.inertia_link_1_xx
            + inertias.inertia_link_1_yy + inertias.inertia_link_1_zz) * 0.5;
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
        let factor_link_1_yz_0_5 = velocities.minus_velocity_base_wx
            * factor_link_1_yz_0_5_1
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
        let factor_link_1_xy_0 = velocities.velocity_link_1_wz
            * inertias.inertia_link_1_xx + factor_link_1_xy_0_5_3
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
        let factor_link_2_yz_0_5_1 = (inertias.inertia_link_2_xx
            + inertias.inertia_link_2_yy + inertias.inertia_link_2_zz) * 0.5;
        let factor_link_2_yz_0_5_4 = inertias.inertia_link_2_xy
            * velocities.minus_velocity_link_2_wy;
        let factor_link_2_yz_0_5_5 = inertias.inertia_link_2_xz
            * velocities.velocity_link_1_wz;
        let factor_link_2_xz_0_5_2 = inertias.inertia_link_2_xy
            * velocities.velocity_link_2_wx;
        let factor_link_2_xz_0_5_5 = inertias.inertia_link_2_yz
            * velocities.velocity_link_1_wz;
        let factor_link_2_xy_0_5_2 = inertias.inertia_link_2_xz
            * velocities.velocity_link_2_wx;
        let factor_link_2_xy_0_5_3 = inertias.inertia_link_2_yz
            * velocities.minus_velocity_link_2_wy;
        let factor_link_2_yz_0_5 = velocities.velocity_link_2_wx * factor_link_2_yz_0_5_1
            - (inertias.inertia_link_2_xx * velocities.velocity_link_2_wx
                - factor_link_2_yz_0_5_4 + factor_link_2_yz_0_5_5);
        let factor_link_2_xz_0_5 = velocities.minus_velocity_link_2_wy
            * factor_link_2_yz_0_5_1
            + (factor_link_2_xz_0_5_2
                - inertias.inertia_link_2_yy * velocities.minus_velocity_link_2_wy
                + factor_link_2_xz_0_5_5);
        let factor_link_2_xy_0_5 = velocities.velocity_link_1_wz * factor_link_2_yz_0_5_1
            - (factor_link_2_xy_0_5_2 - factor_link_2_xy_0_5_3
                + inertias.inertia_link_2_zz * velocities.velocity_link_1_wz);
        let factor_link_2_xx_0_0_0 = inertias.inertia_link_2_hx
            * velocities.velocity_link_2_vx;
        let factor_link_2_xx_0_0_1 = inertias.minus_inertia_link_2_hy
            * velocities.velocity_link_2_vy;
        let factor_link_2_xx_0_0_2 = inertias.inertia_link_2_hz
            * velocities.velocity_link_2_vz;
        let factor_link_2_xx_0_0 = factor_link_2_xx_0_0_0 - factor_link_2_xx_0_0_1
            + factor_link_2_xx_0_0_2;
        let factor_link_2_xx_0_1 = velocities.minus_velocity_link_2_wy
            * inertias.inertia_link_2_xz;
        let factor_link_2_xx_0_2 = velocities.velocity_link_1_wz
            * inertias.inertia_link_2_xy;
        let factor_link_2_xx_0 = factor_link_2_xx_0_0
            - (factor_link_2_xx_0_1 + factor_link_2_xx_0_2 + factor_link_2_xx_0_0_0);
        let factor_link_2_xy_0 = velocities.velocity_link_1_wz
            * inertias.inertia_link_2_xx - factor_link_2_xy_0_5_2
            + velocities.velocity_link_2_vx * inertias.minus_inertia_link_2_hy
            - factor_link_2_xy_0_5;
        let factor_link_2_xz_0 = factor_link_2_xz_0_5_2
            + velocities.minus_velocity_link_2_wy * inertias.inertia_link_2_xx
            - velocities.velocity_link_2_vx * inertias.inertia_link_2_hz
            - factor_link_2_xz_0_5;
        let factor_link_2_yx_0 = factor_link_2_xy_0_5
            - (factor_link_2_xy_0_5_3
                + velocities.velocity_link_1_wz * inertias.inertia_link_2_yy
                + velocities.velocity_link_2_vy * inertias.inertia_link_2_hx);
        let factor_link_2_yy_0_1 = velocities.velocity_link_2_wx
            * inertias.inertia_link_2_yz;
        let factor_link_2_yy_0 = factor_link_2_xx_0_2 - factor_link_2_yy_0_1
            + factor_link_2_xx_0_0_1 + factor_link_2_xx_0_0;
        let factor_link_2_yz_0 = velocities.velocity_link_2_wx
            * inertias.inertia_link_2_yy + factor_link_2_yz_0_5_4
            - velocities.velocity_link_2_vy * inertias.inertia_link_2_hz
            - factor_link_2_yz_0_5;
        let factor_link_2_zx_0 = factor_link_2_xz_0_5
            - (velocities.minus_velocity_link_2_wy * inertias.inertia_link_2_zz
                + factor_link_2_xz_0_5_5
                + velocities.velocity_link_2_vz * inertias.inertia_link_2_hx);
        let factor_link_2_zy_0 = factor_link_2_yz_0_5_5
            - velocities.velocity_link_2_wx * inertias.inertia_link_2_zz
            + velocities.velocity_link_2_vz * inertias.minus_inertia_link_2_hy
            + factor_link_2_yz_0_5;
        let factor_link_2_zz_0 = factor_link_2_yy_0_1 + factor_link_2_xx_0_1
            - factor_link_2_xx_0_0_2 + factor_link_2_xx_0_0;
        let factor_link_3_yz_0_5_1 = (inertias.inertia_link_3_xx
            + inertias.inertia_link_3_yy + inertias.inertia_link_3_zz) * 0.5;
        let factor_link_3_yz_0_5_4 = inertias.inertia_link_3_xy
            * velocities.minus_velocity_link_3_wy;
        let factor_link_3_yz_0_5_5 = inertias.inertia_link_3_xz
            * velocities.velocity_link_3_wz;
        let factor_link_3_xz_0_5_2 = inertias.inertia_link_3_xy
            * velocities.velocity_link_3_wx;
        let factor_link_3_xz_0_5_5 = inertias.inertia_link_3_yz
            * velocities.velocity_link_3_wz;
        let factor_link_3_xy_0_5_2 = inertias.inertia_link_3_xz
            * velocities.velocity_link_3_wx;
        let factor_link_3_xy_0_5_3 = inertias.inertia_link_3_yz
            * velocities.minus_velocity_link_3_wy;
        let factor_link_3_yz_0_5 = velocities.velocity_link_3_wx * factor_link_3_yz_0_5_1
            - (inertias.inertia_link_3_xx * velocities.velocity_link_3_wx
                - factor_link_3_yz_0_5_4 + factor_link_3_yz_0_5_5);
        let factor_link_3_xz_0_5 = velocities.minus_velocity_link_3_wy
            * factor_link_3_yz_0_5_1
            + (factor_link_3_xz_0_5_2
                - inertias.inertia_link_3_yy * velocities.minus_velocity_link_3_wy
                + factor_link_3_xz_0_5_5);
        let factor_link_3_xy_0_5 = velocities.velocity_link_3_wz * factor_link_3_yz_0_5_1
            - (factor_link_3_xy_0_5_2 - factor_link_3_xy_0_5_3
                + inertias.inertia_link_3_zz * velocities.velocity_link_3_wz);
        let factor_link_3_xx_0_0_0 = inertias.inertia_link_3_hx
            * velocities.velocity_link_3_vx;
        let factor_link_3_xx_0_0_1 = inertias.minus_inertia_link_3_hy
            * velocities.velocity_link_3_vy;
        let factor_link_3_xx_0_0_2 = inertias.inertia_link_3_hz
            * velocities.velocity_link_3_vz;
        let factor_link_3_xx_0_0 = factor_link_3_xx_0_0_0 - factor_link_3_xx_0_0_1
            + factor_link_3_xx_0_0_2;
        let factor_link_3_xx_0_1 = velocities.minus_velocity_link_3_wy
            * inertias.inertia_link_3_xz;
        let factor_link_3_xx_0_2 = velocities.velocity_link_3_wz
            * inertias.inertia_link_3_xy;
        let factor_link_3_xx_0 = factor_link_3_xx_0_0
            - (factor_link_3_xx_0_1 + factor_link_3_xx_0_2 + factor_link_3_xx_0_0_0);
        let factor_link_3_xy_0 = velocities.velocity_link_3_wz
            * inertias.inertia_link_3_xx - factor_link_3_xy_0_5_2
            + velocities.velocity_link_3_vx * inertias.minus_inertia_link_3_hy
            - factor_link_3_xy_0_5;
        let factor_link_3_xz_0 = factor_link_3_xz_0_5_2
            + velocities.minus_velocity_link_3_wy * inertias.inertia_link_3_xx
            - velocities.velocity_link_3_vx * inertias.inertia_link_3_hz
            - factor_link_3_xz_0_5;
        let factor_link_3_yx_0 = factor_link_3_xy_0_5
            - (factor_link_3_xy_0_5_3
                + velocities.velocity_link_3_wz * inertias.inertia_link_3_yy
                + velocities.velocity_link_3_vy * inertias.inertia_link_3_hx);
        let factor_link_3_yy_0_1 = velocities.velocity_link_3_wx
            * inertias.inertia_link_3_yz;
        let factor_link_3_yy_0 = factor_link_3_xx_0_2 - factor_link_3_yy_0_1
            + factor_link_3_xx_0_0_1 + factor_link_3_xx_0_0;
        let factor_link_3_yz_0 = velocities.velocity_link_3_wx
            * inertias.inertia_link_3_yy + factor_link_3_yz_0_5_4
            - velocities.velocity_link_3_vy * inertias.inertia_link_3_hz
            - factor_link_3_yz_0_5;
        let factor_link_3_zx_0 = factor_link_3_xz_0_5
            - (velocities.minus_velocity_link_3_wy * inertias.inertia_link_3_zz
                + factor_link_3_xz_0_5_5
                + velocities.velocity_link_3_vz * inertias.inertia_link_3_hx);
        let factor_link_3_zy_0 = factor_link_3_yz_0_5_5
            - velocities.velocity_link_3_wx * inertias.inertia_link_3_zz
            + velocities.velocity_link_3_vz * inertias.minus_inertia_link_3_hy
            + factor_link_3_yz_0_5;
        let factor_link_3_zz_0 = factor_link_3_yy_0_1 + factor_link_3_xx_0_1
            - factor_link_3_xx_0_0_2 + factor_link_3_xx_0_0;
        let factor_link_4_yz_0_5_1 = (inertias.inertia_link_4_xx
            + inertias.inertia_link_4_yy + inertias.inertia_link_4_zz) * 0.5;
        let factor_link_4_yz_0_5_4 = inertias.inertia_link_4_xy
            * velocities.velocity_link_4_wy;
        let factor_link_4_yz_0_5_5 = inertias.inertia_link_4_xz
            * velocities.velocity_link_4_wz;
        let factor_link_4_xz_0_5_2 = inertias.inertia_link_4_xy
            * velocities.velocity_link_4_wx;
        let factor_link_4_xz_0_5_5 = inertias.inertia_link_4_yz
            * velocities.velocity_link_4_wz;
        let factor_link_4_xy_0_5_2 = inertias.inertia_link_4_xz
            * velocities.velocity_link_4_wx;
        let factor_link_4_xy_0_5_3 = inertias.inertia_link_4_yz
            * velocities.velocity_link_4_wy;
        let factor_link_4_yz_0_5 = velocities.velocity_link_4_wx * factor_link_4_yz_0_5_1
            - (inertias.inertia_link_4_xx * velocities.velocity_link_4_wx
                + factor_link_4_yz_0_5_4 + factor_link_4_yz_0_5_5);
        let factor_link_4_xz_0_5 = velocities.velocity_link_4_wy * factor_link_4_yz_0_5_1
            - (factor_link_4_xz_0_5_2
                + inertias.inertia_link_4_yy * velocities.velocity_link_4_wy
                + factor_link_4_xz_0_5_5);
        let factor_link_4_xy_0_5 = velocities.velocity_link_4_wz * factor_link_4_yz_0_5_1
            - (factor_link_4_xy_0_5_2 + factor_link_4_xy_0_5_3
                + inertias.inertia_link_4_zz * velocities.velocity_link_4_wz);
        let factor_link_4_xx_0_3_1 = inertias.minus_inertia_link_4_hx
            * velocities.velocity_link_4_vx;
        let factor_link_4_xx_0_3_0 = inertias.inertia_link_4_hy
            * velocities.velocity_link_4_vy;
        let factor_link_4_xx_0_3_2 = inertias.inertia_link_4_hz
            * velocities.velocity_link_4_vz;
        let factor_link_4_xx_0_3 = factor_link_4_xx_0_3_0 - factor_link_4_xx_0_3_1
            + factor_link_4_xx_0_3_2;
        let factor_link_4_xx_0_0 = velocities.velocity_link_4_wy
            * inertias.inertia_link_4_xz;
        let factor_link_4_xx_0_1 = velocities.velocity_link_4_wz
            * inertias.inertia_link_4_xy;
        let factor_link_4_xx_0 = factor_link_4_xx_0_0 - factor_link_4_xx_0_1
            + factor_link_4_xx_0_3_1 + factor_link_4_xx_0_3;
        let factor_link_4_xy_0 = velocities.velocity_link_4_wz
            * inertias.inertia_link_4_xx - factor_link_4_xy_0_5_2
            - velocities.velocity_link_4_vx * inertias.inertia_link_4_hy
            - factor_link_4_xy_0_5;
        let factor_link_4_xz_0 = factor_link_4_xz_0_5_2
            - velocities.velocity_link_4_wy * inertias.inertia_link_4_xx
            - velocities.velocity_link_4_vx * inertias.inertia_link_4_hz
            + factor_link_4_xz_0_5;
        let factor_link_4_yx_0 = factor_link_4_xy_0_5_3
            - velocities.velocity_link_4_wz * inertias.inertia_link_4_yy
            + velocities.velocity_link_4_vy * inertias.minus_inertia_link_4_hx
            + factor_link_4_xy_0_5;
        let factor_link_4_yy_0_1 = velocities.velocity_link_4_wx
            * inertias.inertia_link_4_yz;
        let factor_link_4_yy_0 = factor_link_4_xx_0_1 - factor_link_4_yy_0_1
            - factor_link_4_xx_0_3_0 + factor_link_4_xx_0_3;
        let factor_link_4_yz_0 = velocities.velocity_link_4_wx
            * inertias.inertia_link_4_yy - factor_link_4_yz_0_5_4
            - velocities.velocity_link_4_vy * inertias.inertia_link_4_hz
            - factor_link_4_yz_0_5;
        let factor_link_4_zx_0 = velocities.velocity_link_4_wy
            * inertias.inertia_link_4_zz - factor_link_4_xz_0_5_5
            + velocities.velocity_link_4_vz * inertias.minus_inertia_link_4_hx
            - factor_link_4_xz_0_5;
        let factor_link_4_zy_0 = factor_link_4_yz_0_5_5
            - velocities.velocity_link_4_wx * inertias.inertia_link_4_zz
            - velocities.velocity_link_4_vz * inertias.inertia_link_4_hy
            + factor_link_4_yz_0_5;
        let factor_link_4_zz_0 = factor_link_4_yy_0_1 - factor_link_4_xx_0_0
            - factor_link_4_xx_0_3_2 + factor_link_4_xx_0_3;
        let factor_link_5_yz_0_5_1 = (inertias.inertia_link_5_xx
            + inertias.inertia_link_5_yy + inertias.inertia_link_5_zz) * 0.5;
        let factor_link_5_yz_0_5_4 = inertias.inertia_link_5_xy
            * velocities.velocity_link_5_wy;
        let factor_link_5_yz_0_5_5 = inertias.inertia_link_5_xz
            * velocities.velocity_link_5_wz;
        DQdotItselfFromFactorOutsideLink1Px {
            factor_outside_link_1_px,
            factor_outside_link_1_py,
            factor_outside_link_1_pz,
            factor_link_1_xx_0,
            factor_link_1_xy_0,
            factor_link_1_xz_0,
            factor_link_1_yx_0,
            factor_link_1_yy_0,
            factor_link_1_yz_0,
            factor_link_1_zx_0,
            factor_link_1_zy_0,
            factor_link_1_zz_0,
            factor_link_2_xx_0,
            factor_link_2_xy_0,
            factor_link_2_xz_0,
            factor_link_2_yx_0,
            factor_link_2_yy_0,
            factor_link_2_yz_0,
            factor_link_2_zx_0,
            factor_link_2_zy_0,
            factor_link_2_zz_0,
            factor_link_3_xx_0,
            factor_link_3_xy_0,
            factor_link_3_xz_0,
            factor_link_3_yx_0,
            factor_link_3_yy_0,
            factor_link_3_yz_0,
            factor_link_3_zx_0,
            factor_link_3_zy_0,
            factor_link_3_zz_0,
            factor_link_4_xx_0,
            factor_link_4_xy_0,
            factor_link_4_xz_0,
            factor_link_4_yx_0,
            factor_link_4_yy_0,
            factor_link_4_yz_0,
            factor_link_4_zx_0,
            factor_link_4_zy_0,
            factor_link_4_zz_0,
            factor_link_5_yz_0_5_1,
            factor_link_5_yz_0_5_4,
            factor_link_5_yz_0_5_5,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromFactorLink5Xz0_5_2 {
        pub(super) factor_link_5_xx_0: f64,
        pub(super) factor_link_5_xy_0: f64,
        pub(super) factor_link_5_xz_0: f64,
        pub(super) factor_link_5_yx_0: f64,
        pub(super) factor_link_5_yy_0: f64,
        pub(super) factor_link_5_yz_0: f64,
        pub(super) factor_link_5_zx_0: f64,
        pub(super) factor_link_5_zy_0: f64,
        pub(super) factor_link_5_zz_0: f64,
        pub(super) factor_link_6_xx_0: f64,
        pub(super) factor_link_6_xy_0: f64,
        pub(super) factor_link_6_xz_0: f64,
        pub(super) factor_link_6_yx_0: f64,
        pub(super) factor_link_6_yy_0: f64,
        pub(super) factor_link_6_yz_0: f64,
        pub(super) factor_link_6_zx_0: f64,
        pub(super) factor_link_6_zy_0: f64,
        pub(super) factor_link_6_zz_0: f64,
        pub(super) factor_link_7_xx: f64,
        pub(super) factor_link_7_xy: f64,
        pub(super) factor_link_7_xz: f64,
        pub(super) factor_link_7_yx: f64,
        pub(super) factor_link_7_yy: f64,
        pub(super) factor_link_7_yz: f64,
        pub(super) factor_link_7_zx: f64,
        pub(super) factor_link_7_zy: f64,
        pub(super) factor_link_7_zz: f64,
        pub(super) factor_link_6_xx: f64,
        pub(super) factor_link_6_yx: f64,
        pub(super) factor_link_6_zx: f64,
        pub(super) factor_link_6_xy: f64,
        pub(super) factor_link_6_yy: f64,
        pub(super) factor_link_6_zy: f64,
        pub(super) factor_link_6_xz: f64,
        pub(super) factor_link_6_yz: f64,
        pub(super) factor_link_6_zz: f64,
        pub(super) factor_link_5_xx: f64,
        pub(super) factor_link_5_yx: f64,
        pub(super) factor_link_5_zx: f64,
        pub(super) factor_link_5_xy: f64,
        pub(super) factor_link_5_yy: f64,
        pub(super) factor_link_5_zy: f64,
        pub(super) factor_link_5_xz: f64,
        pub(super) factor_link_5_yz: f64,
        pub(super) factor_link_5_zz: f64,
        pub(super) factor_link_4_xx: f64,
        pub(super) factor_link_4_yx: f64,
        pub(super) factor_link_4_zx: f64,
        pub(super) factor_link_4_xy: f64,
        pub(super) factor_link_4_yy: f64,
        pub(super) factor_link_4_zy: f64,
        pub(super) factor_link_4_xz: f64,
        pub(super) factor_link_4_yz: f64,
        pub(super) factor_link_4_zz: f64,
        pub(super) factor_link_3_xx: f64,
        pub(super) factor_link_3_yx: f64,
        pub(super) factor_link_3_zx: f64,
        pub(super) factor_link_3_xy: f64,
        pub(super) factor_link_3_yy: f64,
        pub(super) factor_link_3_zy: f64,
        pub(super) factor_link_3_xz: f64,
        pub(super) factor_link_3_yz: f64,
        pub(super) factor_link_3_zz: f64,
        pub(super) factor_link_2_xx: f64,
        pub(super) factor_link_2_yx: f64,
        pub(super) factor_link_2_zx: f64,
        pub(super) factor_link_2_xy: f64,
        pub(super) factor_link_2_yy: f64,
        pub(super) factor_link_2_zy: f64,
        pub(super) factor_link_2_xz: f64,
        pub(super) factor_link_2_yz: f64,
        pub(super) factor_link_2_zz: f64,
        pub(super) factor_link_1_yx: f64,
        pub(super) factor_link_1_zx: f64,
        pub(super) factor_link_1_xy: f64,
        pub(super) factor_link_1_zy: f64,
        pub(super) factor_link_1_xz: f64,
        pub(super) factor_link_1_yz: f64,
        pub(super) factor_link_1_zz: f64,
        pub(super) six_joint_1_mx_8: f64,
        pub(super) six_joint_1_my_6: f64,
        pub(super) six_joint_1_mx_6: f64,
        pub(super) three_joint_1_x_0: f64,
        pub(super) three_joint_1_y_2: f64,
        pub(super) three_joint_1_z_4: f64,
        pub(super) three_joint_1_x_7: f64,
        pub(super) three_joint_1_y_9: f64,
        pub(super) three_joint_1_z_13: f64,
        pub(super) three_joint_1_x: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_factor_link_5_xz_0_5_2(
        poses: &Poses,
        inertias: &Inertias,
        screws: &Screws,
        reactions: &Reactions,
        velocities: &Velocities,
        d_qdot_itself: &DQdotItself,
        d_qdot_itself_from_factor_outside_link_1_px: &DQdotItselfFromFactorOutsideLink1Px,
    ) -> DQdotItselfFromFactorLink5Xz0_5_2 {
        let factor_link_5_xz_0_5_2 = inertias.inertia_link_5_xy
            * velocities.velocity_link_5_wx;
        let factor_link_5_xz_0_5_5 = inertias.inertia_link_5_yz
            * velocities.velocity_link_5_wz;
        let factor_link_5_xy_0_5_2 = inertias.inertia_link_5_xz
            * velocities.velocity_link_5_wx;
        let factor_link_5_xy_0_5_3 = inertias.inertia_link_5_yz
            * velocities.velocity_link_5_wy;
        let factor_link_5_yz_0_5 = velocities.velocity_link_5_wx
            * d_qdot_itself_from_factor_outside_link_1_px.factor_link_5_yz_0_5_1
            - (inertias.inertia_link_5_xx * velocities.velocity_link_5_wx
                + d_qdot_itself_from_factor_outside_link_1_px.factor_link_5_yz_0_5_4
                + d_qdot_itself_from_factor_outside_link_1_px.factor_link_5_yz_0_5_5);
        let factor_link_5_xz_0_5 = velocities.velocity_link_5_wy
            * d_qdot_itself_from_factor_outside_link_1_px.factor_link_5_yz_0_5_1
            - (factor_link_5_xz_0_5_2
                + inertias.inertia_link_5_yy * velocities.velocity_link_5_wy
                + factor_link_5_xz_0_5_5);
        let factor_link_5_xy_0_5 = velocities.velocity_link_5_wz
            * d_qdot_itself_from_factor_outside_link_1_px.factor_link_5_yz_0_5_1
            - (factor_link_5_xy_0_5_2 + factor_link_5_xy_0_5_3
                + inertias.inertia_link_5_zz * velocities.velocity_link_5_wz);
        let factor_link_5_xx_0_3_1 = inertias.minus_inertia_link_5_hx
            * velocities.velocity_link_5_vx;
        let factor_link_5_xx_0_3_0 = inertias.inertia_link_5_hy
            * velocities.velocity_link_5_vy;
        let factor_link_5_xx_0_3_2 = inertias.inertia_link_5_hz
            * velocities.velocity_link_5_vz;
        let factor_link_5_xx_0_3 = factor_link_5_xx_0_3_0 - factor_link_5_xx_0_3_1
            + factor_link_5_xx_0_3_2;
        let factor_link_5_xx_0_0 = velocities.velocity_link_5_wy
            * inertias.inertia_link_5_xz;
        let factor_link_5_xx_0_1 = velocities.velocity_link_5_wz
            * inertias.inertia_link_5_xy;
        let factor_link_5_xx_0 = factor_link_5_xx_0_0 - factor_link_5_xx_0_1
            + factor_link_5_xx_0_3_1 + factor_link_5_xx_0_3;
        let factor_link_5_xy_0 = velocities.velocity_link_5_wz
            * inertias.inertia_link_5_xx - factor_link_5_xy_0_5_2
            - velocities.velocity_link_5_vx * inertias.inertia_link_5_hy
            - factor_link_5_xy_0_5;
        let factor_link_5_xz_0 = factor_link_5_xz_0_5_2
            - velocities.velocity_link_5_wy * inertias.inertia_link_5_xx
            - velocities.velocity_link_5_vx * inertias.inertia_link_5_hz
            + factor_link_5_xz_0_5;
        let factor_link_5_yx_0 = factor_link_5_xy_0_5_3
            - velocities.velocity_link_5_wz * inertias.inertia_link_5_yy
            + velocities.velocity_link_5_vy * inertias.minus_inertia_link_5_hx
            + factor_link_5_xy_0_5;
        let factor_link_5_yy_0_1 = velocities.velocity_link_5_wx
            * inertias.inertia_link_5_yz;
        let factor_link_5_yy_0 = factor_link_5_xx_0_1 - factor_link_5_yy_0_1
            - factor_link_5_xx_0_3_0 + factor_link_5_xx_0_3;
        let factor_link_5_yz_0 = velocities.velocity_link_5_wx
            * inertias.inertia_link_5_yy
            - d_qdot_itself_from_factor_outside_link_1_px.factor_link_5_yz_0_5_4
            - velocities.velocity_link_5_vy * inertias.inertia_link_5_hz
            - factor_link_5_yz_0_5;
        let factor_link_5_zx_0 = velocities.velocity_link_5_wy
            * inertias.inertia_link_5_zz - factor_link_5_xz_0_5_5
            + velocities.velocity_link_5_vz * inertias.minus_inertia_link_5_hx
            - factor_link_5_xz_0_5;
        let factor_link_5_zy_0 = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_5_yz_0_5_5
            - velocities.velocity_link_5_wx * inertias.inertia_link_5_zz
            - velocities.velocity_link_5_vz * inertias.inertia_link_5_hy
            + factor_link_5_yz_0_5;
        let factor_link_5_zz_0 = factor_link_5_yy_0_1 - factor_link_5_xx_0_0
            - factor_link_5_xx_0_3_2 + factor_link_5_xx_0_3;
        let factor_link_6_yz_0_5_1 = (inertias.inertia_link_6_xx
            + inertias.inertia_link_6_yy + inertias.inertia_link_6_zz) * 0.5;
        let factor_link_6_yz_0_5_4 = inertias.minus_inertia_link_6_xy
            * velocities.velocity_link_6_wy;
        let factor_link_6_yz_0_5_5 = inertias.inertia_link_6_xz
            * velocities.velocity_link_6_wz;
        let factor_link_6_xz_0_0_4 = inertias.minus_inertia_link_6_xy
            * velocities.velocity_link_6_wx;
        let factor_link_6_xz_0_0_5 = inertias.inertia_link_6_yz
            * velocities.velocity_link_6_wz;
        let factor_link_6_xy_0_5_2 = inertias.inertia_link_6_xz
            * velocities.velocity_link_6_wx;
        let factor_link_6_xy_0_5_3 = inertias.inertia_link_6_yz
            * velocities.velocity_link_6_wy;
        let factor_link_6_yz_0_5 = velocities.velocity_link_6_wx * factor_link_6_yz_0_5_1
            - (inertias.inertia_link_6_xx * velocities.velocity_link_6_wx
                - factor_link_6_yz_0_5_4 + factor_link_6_yz_0_5_5);
        let factor_link_6_xz_0_0 = velocities.velocity_link_6_wy * factor_link_6_yz_0_5_1
            - (inertias.inertia_link_6_yy * velocities.velocity_link_6_wy
                - factor_link_6_xz_0_0_4 + factor_link_6_xz_0_0_5);
        let factor_link_6_xy_0_5 = velocities.velocity_link_6_wz * factor_link_6_yz_0_5_1
            - (factor_link_6_xy_0_5_2 + factor_link_6_xy_0_5_3
                + inertias.inertia_link_6_zz * velocities.velocity_link_6_wz);
        let factor_link_6_xx_0_3_1 = inertias.minus_inertia_link_6_hx
            * velocities.velocity_link_6_vx;
        let factor_link_6_xx_0_3_2 = inertias.minus_inertia_link_6_hy
            * velocities.velocity_link_6_vy;
        let factor_link_6_xx_0_3_0 = inertias.inertia_link_6_hz
            * velocities.velocity_link_6_vz;
        let factor_link_6_xx_0_3 = factor_link_6_xx_0_3_0
            - (factor_link_6_xx_0_3_1 + factor_link_6_xx_0_3_2);
        let factor_link_6_xx_0_0 = velocities.velocity_link_6_wy
            * inertias.inertia_link_6_xz;
        let factor_link_6_xx_0_1 = velocities.velocity_link_6_wz
            * inertias.minus_inertia_link_6_xy;
        let factor_link_6_xx_0 = factor_link_6_xx_0_0 + factor_link_6_xx_0_1
            + factor_link_6_xx_0_3_1 + factor_link_6_xx_0_3;
        let factor_link_6_xy_0 = velocities.velocity_link_6_wz
            * inertias.inertia_link_6_xx - factor_link_6_xy_0_5_2
            + velocities.velocity_link_6_vx * inertias.minus_inertia_link_6_hy
            - factor_link_6_xy_0_5;
        let factor_link_6_xz_0 = factor_link_6_xz_0_0
            - (factor_link_6_xz_0_0_4
                + velocities.velocity_link_6_wy * inertias.inertia_link_6_xx
                + velocities.velocity_link_6_vx * inertias.inertia_link_6_hz);
        let factor_link_6_yx_0 = factor_link_6_xy_0_5_3
            - velocities.velocity_link_6_wz * inertias.inertia_link_6_yy
            + velocities.velocity_link_6_vy * inertias.minus_inertia_link_6_hx
            + factor_link_6_xy_0_5;
        let factor_link_6_yy_0_2 = velocities.velocity_link_6_wx
            * inertias.inertia_link_6_yz;
        let factor_link_6_yy_0 = factor_link_6_xx_0_3_2
            - (factor_link_6_xx_0_1 + factor_link_6_yy_0_2) + factor_link_6_xx_0_3;
        let factor_link_6_yz_0 = velocities.velocity_link_6_wx
            * inertias.inertia_link_6_yy + factor_link_6_yz_0_5_4
            - velocities.velocity_link_6_vy * inertias.inertia_link_6_hz
            - factor_link_6_yz_0_5;
        let factor_link_6_zx_0 = velocities.velocity_link_6_wy
            * inertias.inertia_link_6_zz - factor_link_6_xz_0_0_5
            + velocities.velocity_link_6_vz * inertias.minus_inertia_link_6_hx
            - factor_link_6_xz_0_0;
        let factor_link_6_zy_0 = factor_link_6_yz_0_5_5
            - velocities.velocity_link_6_wx * inertias.inertia_link_6_zz
            + velocities.velocity_link_6_vz * inertias.minus_inertia_link_6_hy
            + factor_link_6_yz_0_5;
        let factor_link_6_zz_0 = factor_link_6_yy_0_2 - factor_link_6_xx_0_0
            - factor_link_6_xx_0_3_0 + factor_link_6_xx_0_3;
        let factor_link_7_yz_5_1 = (inertias.inertia_link_7_xx
            + inertias.inertia_link_7_yy + inertias.inertia_link_7_zz) * 0.5;
        let factor_link_7_yz_2 = inertias.minus_inertia_link_7_xy
            * velocities.velocity_link_7_wy;
        let factor_link_7_zy_0 = inertias.inertia_link_7_xz
            * velocities.velocity_link_7_wz;
        let factor_link_7_xz_1 = inertias.minus_inertia_link_7_xy
            * velocities.velocity_link_7_wx;
        let factor_link_7_zx_2 = inertias.inertia_link_7_yz
            * velocities.velocity_link_7_wz;
        let factor_link_7_xy_2 = inertias.inertia_link_7_xz
            * velocities.velocity_link_7_wx;
        let factor_link_7_yx_0 = inertias.inertia_link_7_yz
            * velocities.velocity_link_7_wy;
        let factor_link_7_yz_5 = velocities.velocity_link_7_wx * factor_link_7_yz_5_1
            - (inertias.inertia_link_7_xx * velocities.velocity_link_7_wx
                - factor_link_7_yz_2 + factor_link_7_zy_0);
        let factor_link_7_xz_0 = velocities.velocity_link_7_wy * factor_link_7_yz_5_1
            - (inertias.inertia_link_7_yy * velocities.velocity_link_7_wy
                - factor_link_7_xz_1 + factor_link_7_zx_2);
        let factor_link_7_xy_5 = velocities.velocity_link_7_wz * factor_link_7_yz_5_1
            - (factor_link_7_xy_2 + factor_link_7_yx_0
                + inertias.inertia_link_7_zz * velocities.velocity_link_7_wz);
        let factor_link_7_xx_2 = inertias.minus_inertia_link_7_hx
            * velocities.velocity_link_7_vx;
        let factor_link_7_yy_0 = inertias.minus_inertia_link_7_hy
            * velocities.velocity_link_7_vy;
        let factor_link_7_zz_2 = inertias.inertia_link_7_hz
            * velocities.velocity_link_7_vz;
        let factor_link_7_xx_3 = factor_link_7_zz_2
            - (factor_link_7_xx_2 + factor_link_7_yy_0);
        let factor_link_7_xx_0 = velocities.velocity_link_7_wy
            * inertias.inertia_link_7_xz;
        let factor_link_7_xx_1 = velocities.velocity_link_7_wz
            * inertias.minus_inertia_link_7_xy;
        let factor_link_7_xx = factor_link_7_xx_0 + factor_link_7_xx_1
            + factor_link_7_xx_2 + factor_link_7_xx_3;
        let factor_link_7_xy = velocities.velocity_link_7_wz * inertias.inertia_link_7_xx
            - factor_link_7_xy_2
            + velocities.velocity_link_7_vx * inertias.minus_inertia_link_7_hy
            - factor_link_7_xy_5;
        let factor_link_7_xz = factor_link_7_xz_0
            - (factor_link_7_xz_1
                + velocities.velocity_link_7_wy * inertias.inertia_link_7_xx
                + velocities.velocity_link_7_vx * inertias.inertia_link_7_hz);
        let factor_link_7_yx = factor_link_7_yx_0
            - velocities.velocity_link_7_wz * inertias.inertia_link_7_yy
            + velocities.velocity_link_7_vy * inertias.minus_inertia_link_7_hx
            + factor_link_7_xy_5;
        let factor_link_7_yy_2 = velocities.velocity_link_7_wx
            * inertias.inertia_link_7_yz;
        let factor_link_7_yy = factor_link_7_yy_0
            - (factor_link_7_xx_1 + factor_link_7_yy_2) + factor_link_7_xx_3;
        let factor_link_7_yz = velocities.velocity_link_7_wx * inertias.inertia_link_7_yy
            + factor_link_7_yz_2
            - velocities.velocity_link_7_vy * inertias.inertia_link_7_hz
            - factor_link_7_yz_5;
        let factor_link_7_zx = velocities.velocity_link_7_wy * inertias.inertia_link_7_zz
            - factor_link_7_zx_2
            + velocities.velocity_link_7_vz * inertias.minus_inertia_link_7_hx
            - factor_link_7_xz_0;
        let factor_link_7_zy = factor_link_7_zy_0
            - velocities.velocity_link_7_wx * inertias.inertia_link_7_zz
            + velocities.velocity_link_7_vz * inertias.minus_inertia_link_7_hy
            + factor_link_7_yz_5;
        let factor_link_7_zz = factor_link_7_yy_2 - factor_link_7_xx_0
            - factor_link_7_zz_2 + factor_link_7_xx_3;
        let factor_link_6_xx = factor_link_6_xx_0 + factor_link_7_xx;
        let factor_link_6_yx = factor_link_6_yx_0 + factor_link_7_yx;
        let factor_link_6_zx = factor_link_6_zx_0 + factor_link_7_zx;
        let factor_link_6_xy = factor_link_6_xy_0 + factor_link_7_xy;
        let factor_link_6_yy = factor_link_6_yy_0 + factor_link_7_yy;
        let factor_link_6_zy = factor_link_6_zy_0 + factor_link_7_zy;
        let factor_link_6_xz = factor_link_6_xz_0 + factor_link_7_xz;
        let factor_link_6_yz = factor_link_6_yz_0 + factor_link_7_yz;
        let factor_link_6_zz = factor_link_6_zz_0 + factor_link_7_zz;
        let factor_link_5_xx = factor_link_5_xx_0 + factor_link_6_xx;
        let factor_link_5_yx = factor_link_5_yx_0 + factor_link_6_yx;
        let factor_link_5_zx = factor_link_5_zx_0 + factor_link_6_zx;
        let factor_link_5_xy = factor_link_5_xy_0 + factor_link_6_xy;
        let factor_link_5_yy = factor_link_5_yy_0 + factor_link_6_yy;
        let factor_link_5_zy = factor_link_5_zy_0 + factor_link_6_zy;
        let factor_link_5_xz = factor_link_5_xz_0 + factor_link_6_xz;
        let factor_link_5_yz = factor_link_5_yz_0 + factor_link_6_yz;
        let factor_link_5_zz = factor_link_5_zz_0 + factor_link_6_zz;
        let factor_link_4_xx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_xx_0 + factor_link_5_xx;
        let factor_link_4_yx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_yx_0 + factor_link_5_yx;
        let factor_link_4_zx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_zx_0 + factor_link_5_zx;
        let factor_link_4_xy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_xy_0 + factor_link_5_xy;
        let factor_link_4_yy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_yy_0 + factor_link_5_yy;
        let factor_link_4_zy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_zy_0 + factor_link_5_zy;
        let factor_link_4_xz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_xz_0 + factor_link_5_xz;
        let factor_link_4_yz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_yz_0 + factor_link_5_yz;
        let factor_link_4_zz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_zz_0 + factor_link_5_zz;
        let factor_link_3_xx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_xx_0 + factor_link_4_xx;
        let factor_link_3_yx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_yx_0 + factor_link_4_yx;
        let factor_link_3_zx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_zx_0 + factor_link_4_zx;
        let factor_link_3_xy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_xy_0 + factor_link_4_xy;
        let factor_link_3_yy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_yy_0 + factor_link_4_yy;
        let factor_link_3_zy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_zy_0 + factor_link_4_zy;
        let factor_link_3_xz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_xz_0 + factor_link_4_xz;
        let factor_link_3_yz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_yz_0 + factor_link_4_yz;
        let factor_link_3_zz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_zz_0 + factor_link_4_zz;
        let factor_link_2_xx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_xx_0 + factor_link_3_xx;
        let factor_link_2_yx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_yx_0 + factor_link_3_yx;
        let factor_link_2_zx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_zx_0 + factor_link_3_zx;
        let factor_link_2_xy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_xy_0 + factor_link_3_xy;
        let factor_link_2_yy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_yy_0 + factor_link_3_yy;
        let factor_link_2_zy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_zy_0 + factor_link_3_zy;
        let factor_link_2_xz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_xz_0 + factor_link_3_xz;
        let factor_link_2_yz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_yz_0 + factor_link_3_yz;
        let factor_link_2_zz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_zz_0 + factor_link_3_zz;
        let factor_link_1_xx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_xx_0 + factor_link_2_xx;
        let factor_link_1_yx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_yx_0 + factor_link_2_yx;
        let factor_link_1_zx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_zx_0 + factor_link_2_zx;
        let factor_link_1_xy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_xy_0 + factor_link_2_xy;
        let factor_link_1_yy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_yy_0 + factor_link_2_yy;
        let factor_link_1_zy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_zy_0 + factor_link_2_zy;
        let factor_link_1_xz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_xz_0 + factor_link_2_xz;
        let factor_link_1_yz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_yz_0 + factor_link_2_yz;
        let factor_link_1_zz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_zz_0 + factor_link_2_zz;
        let six_joint_1_mx_8 = velocities.minus_velocity_base_wx
            * poses.minus_origin_base_x
            + velocities.minus_velocity_base_wy * poses.minus_origin_base_y;
        let six_joint_1_my_6 = velocities.velocity_link_1_vy
            - velocities.velocity_link_1_wz * poses.minus_origin_base_x;
        let six_joint_1_mx_6 = velocities.velocity_link_1_wz * poses.minus_origin_base_y
            + velocities.velocity_link_1_vx;
        let three_joint_1_x_0 = d_qdot_itself.factor_outside_link_1_xx
            * screws.connection_joint_1_wx;
        let three_joint_1_y_2 = d_qdot_itself.factor_outside_link_1_yy
            * screws.connection_joint_1_wy;
        let three_joint_1_z_4 = d_qdot_itself.factor_outside_link_1_zz
            * screws.connection_joint_1_wz;
        let three_joint_1_x_7 = factor_link_1_xx * reactions.reaction_joint_1_wx;
        let three_joint_1_y_9 = factor_link_1_yy * reactions.reaction_joint_1_wy;
        let three_joint_1_z_13 = factor_link_1_zz * reactions.reaction_joint_1_wz;
        let three_joint_1_x = three_joint_1_x_0
            + d_qdot_itself.factor_outside_link_1_yx * screws.connection_joint_1_wy
            + d_qdot_itself.factor_outside_link_1_zx * screws.connection_joint_1_wz
            - d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_pz
                * screws.connection_joint_1_vy
            - (three_joint_1_x_7 + factor_link_1_yx * reactions.reaction_joint_1_wy
                + factor_link_1_zx * reactions.reaction_joint_1_wz);
        DQdotItselfFromFactorLink5Xz0_5_2 {
            factor_link_5_xx_0,
            factor_link_5_xy_0,
            factor_link_5_xz_0,
            factor_link_5_yx_0,
            factor_link_5_yy_0,
            factor_link_5_yz_0,
            factor_link_5_zx_0,
            factor_link_5_zy_0,
            factor_link_5_zz_0,
            factor_link_6_xx_0,
            factor_link_6_xy_0,
            factor_link_6_xz_0,
            factor_link_6_yx_0,
            factor_link_6_yy_0,
            factor_link_6_yz_0,
            factor_link_6_zx_0,
            factor_link_6_zy_0,
            factor_link_6_zz_0,
            factor_link_7_xx,
            factor_link_7_xy,
            factor_link_7_xz,
            factor_link_7_yx,
            factor_link_7_yy,
            factor_link_7_yz,
            factor_link_7_zx,
            factor_link_7_zy,
            factor_link_7_zz,
            factor_link_6_xx,
            factor_link_6_yx,
            factor_link_6_zx,
            factor_link_6_xy,
            factor_link_6_yy,
            factor_link_6_zy,
            factor_link_6_xz,
            factor_link_6_yz,
            factor_link_6_zz,
            factor_link_5_xx,
            factor_link_5_yx,
            factor_link_5_zx,
            factor_link_5_xy,
            factor_link_5_yy,
            factor_link_5_zy,
            factor_link_5_xz,
            factor_link_5_yz,
            factor_link_5_zz,
            factor_link_4_xx,
            factor_link_4_yx,
            factor_link_4_zx,
            factor_link_4_xy,
            factor_link_4_yy,
            factor_link_4_zy,
            factor_link_4_xz,
            factor_link_4_yz,
            factor_link_4_zz,
            factor_link_3_xx,
            factor_link_3_yx,
            factor_link_3_zx,
            factor_link_3_xy,
            factor_link_3_yy,
            factor_link_3_zy,
            factor_link_3_xz,
            factor_link_3_yz,
            factor_link_3_zz,
            factor_link_2_xx,
            factor_link_2_yx,
            factor_link_2_zx,
            factor_link_2_xy,
            factor_link_2_yy,
            factor_link_2_zy,
            factor_link_2_xz,
            factor_link_2_yz,
            factor_link_2_zz,
            factor_link_1_yx,
            factor_link_1_zx,
            factor_link_1_xy,
            factor_link_1_zy,
            factor_link_1_xz,
            factor_link_1_yz,
            factor_link_1_zz,
            six_joint_1_mx_8,
            six_joint_1_my_6,
            six_joint_1_mx_6,
            three_joint_1_x_0,
            three_joint_1_y_2,
            three_joint_1_z_4,
            three_joint_1_x_7,
            three_joint_1_y_9,
            three_joint_1_z_13,
            three_joint_1_x,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromThreeJoint1Y {
        pub(super) factor_link_1_px_0: f64,
        pub(super) factor_link_1_py_0: f64,
        pub(super) factor_link_1_pz_1: f64,
        pub(super) factor_link_2_px_0: f64,
        pub(super) factor_link_2_py_0: f64,
        pub(super) factor_link_2_pz_0: f64,
        pub(super) factor_link_3_px_0: f64,
        pub(super) factor_link_3_py_0: f64,
        pub(super) factor_link_3_pz_0: f64,
        pub(super) factor_link_4_px_0: f64,
        pub(super) factor_link_4_py_0: f64,
        pub(super) factor_link_4_pz_0: f64,
        pub(super) factor_link_5_px_0: f64,
        pub(super) factor_link_5_py_0: f64,
        pub(super) factor_link_5_pz_0: f64,
        pub(super) factor_link_6_px_0: f64,
        pub(super) factor_link_6_py_0: f64,
        pub(super) factor_link_6_pz_0: f64,
        pub(super) factor_link_7_px: f64,
        pub(super) factor_link_7_py: f64,
        pub(super) factor_link_7_pz: f64,
        pub(super) factor_link_6_px: f64,
        pub(super) factor_link_6_py: f64,
        pub(super) factor_link_6_pz: f64,
        pub(super) factor_link_5_px: f64,
        pub(super) factor_link_5_py: f64,
        pub(super) factor_link_5_pz: f64,
        pub(super) factor_link_4_px: f64,
        pub(super) factor_link_4_py: f64,
        pub(super) factor_link_4_pz: f64,
        pub(super) factor_link_3_px: f64,
        pub(super) factor_link_3_py: f64,
        pub(super) factor_link_3_pz: f64,
        pub(super) factor_link_2_px: f64,
        pub(super) factor_link_2_py: f64,
        pub(super) factor_link_2_pz: f64,
        pub(super) six_more_joint_1_mx: f64,
        pub(super) six_more_joint_1_my: f64,
        pub(super) six_more_joint_1_mz: f64,
        pub(super) six_more_joint_1_fx: f64,
        pub(super) six_more_joint_1_fy: f64,
        pub(super) six_more_joint_1_fz: f64,
        pub(super) three_joint_1_y: f64,
        pub(super) three_joint_1_z: f64,
        pub(super) three_more_joint_2_x_0: f64,
        pub(super) three_more_joint_2_y_2: f64,
        pub(super) three_more_joint_3_x_2: f64,
        pub(super) three_more_joint_3_y_4: f64,
        pub(super) three_more_joint_3_z_0: f64,
        pub(super) three_more_joint_3_x: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_three_joint_1_y(
        poses: &Poses,
        inertias: &Inertias,
        screws: &Screws,
        reactions: &Reactions,
        velocities: &Velocities,
        d_qdot_itself: &DQdotItself,
        d_qdot_itself_from_factor_outside_link_1_px: &DQdotItselfFromFactorOutsideLink1Px,
        d_qdot_itself_from_factor_link_5_xz_0_5_2: &DQdotItselfFromFactorLink5Xz0_5_2,
        d_qdot: &mut [[f64; 13]; 13],
    ) -> DQdotItselfFromThreeJoint1Y {
        let three_joint_1_y = d_qdot_itself.factor_outside_link_1_xy
            * screws.connection_joint_1_wx
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_y_2
            + d_qdot_itself.factor_outside_link_1_zy * screws.connection_joint_1_wz
            - d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_pz
                * screws.minus_connection_joint_1_vx
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_xy
                * reactions.reaction_joint_1_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_y_9
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_zy
                    * reactions.reaction_joint_1_wz);
        let three_joint_1_z = d_qdot_itself.factor_outside_link_1_xz
            * screws.connection_joint_1_wx
            + d_qdot_itself.factor_outside_link_1_yz * screws.connection_joint_1_wy
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_z_4
            + (d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_px
                * screws.connection_joint_1_vy
                + d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_py
                    * screws.minus_connection_joint_1_vx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_xz
                * reactions.reaction_joint_1_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_yz
                    * reactions.reaction_joint_1_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_z_13);
        let six_joint_1_mx = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_xz
            + (inertias.composite_link_1_xy * velocities.minus_velocity_base_wx
                - inertias.composite_link_1_xx * velocities.minus_velocity_base_wy
                + (inertias.composite_link_1_hz
                    * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_6
                    - inertias.composite_link_1_hy
                        * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_8));
        let six_joint_1_my = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_yz
            + (inertias.composite_link_1_yy * velocities.minus_velocity_base_wx
                - inertias.composite_link_1_xy * velocities.minus_velocity_base_wy
                + (inertias.composite_link_1_hz
                    * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_my_6
                    + inertias.composite_link_1_hx
                        * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_8));
        let six_joint_1_mz = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_zz
            + (inertias.composite_link_1_yz * velocities.minus_velocity_base_wx
                - inertias.composite_link_1_xz * velocities.minus_velocity_base_wy
                - (inertias.composite_link_1_hx
                    * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_6
                    + inertias.composite_link_1_hy
                        * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_my_6));
        // D_q\u{307} column joint_1
        d_qdot[6][6] = reactions.reaction_joint_1_wx * six_joint_1_mx
            + reactions.reaction_joint_1_wy * six_joint_1_my
            + reactions.reaction_joint_1_wz * six_joint_1_mz
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_x
                * screws.connection_joint_1_wx
            + three_joint_1_y * screws.connection_joint_1_wy
            + three_joint_1_z * screws.connection_joint_1_wz + 0.0;
        let factor_link_1_px_0 = velocities.velocity_link_1_vx * 2.0
            - (velocities.minus_velocity_base_wy * inertias.inertia_link_1_hz
                + velocities.velocity_link_1_wz * inertias.inertia_link_1_hy);
        let factor_link_1_py_0 = velocities.velocity_link_1_vy * 2.0
            + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hz
                - velocities.velocity_link_1_wz * inertias.minus_inertia_link_1_hx);
        let factor_link_1_pz_1 = velocities.minus_velocity_base_vz * 2.0
            + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hy
                + velocities.minus_velocity_base_wy * inertias.minus_inertia_link_1_hx);
        let factor_link_2_px_0 = velocities.velocity_link_2_vx * 2.0
            + (velocities.velocity_link_1_wz * inertias.minus_inertia_link_2_hy
                - velocities.minus_velocity_link_2_wy * inertias.inertia_link_2_hz);
        let factor_link_2_py_0 = velocities.velocity_link_2_vy * 2.0
            + (velocities.velocity_link_1_wz * inertias.inertia_link_2_hx
                - velocities.velocity_link_2_wx * inertias.inertia_link_2_hz);
        let factor_link_2_pz_0 = velocities.velocity_link_2_vz * 2.0
            + (velocities.minus_velocity_link_2_wy * inertias.inertia_link_2_hx
                - velocities.velocity_link_2_wx * inertias.minus_inertia_link_2_hy);
        let factor_link_3_px_0 = velocities.velocity_link_3_vx * 2.0
            + (velocities.velocity_link_3_wz * inertias.minus_inertia_link_3_hy
                - velocities.minus_velocity_link_3_wy * inertias.inertia_link_3_hz);
        let factor_link_3_py_0 = velocities.velocity_link_3_vy * 2.0
            + (velocities.velocity_link_3_wz * inertias.inertia_link_3_hx
                - velocities.velocity_link_3_wx * inertias.inertia_link_3_hz);
        let factor_link_3_pz_0 = velocities.velocity_link_3_vz * 2.0
            + (velocities.minus_velocity_link_3_wy * inertias.inertia_link_3_hx
                - velocities.velocity_link_3_wx * inertias.minus_inertia_link_3_hy);
        let factor_link_4_px_0 = velocities.velocity_link_4_vx * 2.0
            + (velocities.velocity_link_4_wy * inertias.inertia_link_4_hz
                - velocities.velocity_link_4_wz * inertias.inertia_link_4_hy);
        let factor_link_4_py_0 = velocities.velocity_link_4_vy * 2.0
            - (velocities.velocity_link_4_wz * inertias.minus_inertia_link_4_hx
                + velocities.velocity_link_4_wx * inertias.inertia_link_4_hz);
        let factor_link_4_pz_0 = velocities.velocity_link_4_vz * 2.0
            + (velocities.velocity_link_4_wx * inertias.inertia_link_4_hy
                + velocities.velocity_link_4_wy * inertias.minus_inertia_link_4_hx);
        let factor_link_5_px_0 = velocities.velocity_link_5_vx * 2.0
            + (velocities.velocity_link_5_wy * inertias.inertia_link_5_hz
                - velocities.velocity_link_5_wz * inertias.inertia_link_5_hy);
        let factor_link_5_py_0 = velocities.velocity_link_5_vy * 2.0
            - (velocities.velocity_link_5_wz * inertias.minus_inertia_link_5_hx
                + velocities.velocity_link_5_wx * inertias.inertia_link_5_hz);
        let factor_link_5_pz_0 = velocities.velocity_link_5_vz * 2.0
            + (velocities.velocity_link_5_wx * inertias.inertia_link_5_hy
                + velocities.velocity_link_5_wy * inertias.minus_inertia_link_5_hx);
        let factor_link_6_px_0 = velocities.velocity_link_6_vx * 2.0
            + (velocities.velocity_link_6_wy * inertias.inertia_link_6_hz
                + velocities.velocity_link_6_wz * inertias.minus_inertia_link_6_hy);
        let factor_link_6_py_0 = velocities.velocity_link_6_vy * 2.0
            - (velocities.velocity_link_6_wz * inertias.minus_inertia_link_6_hx
                + velocities.velocity_link_6_wx * inertias.inertia_link_6_hz);
        let factor_link_6_pz_0 = velocities.velocity_link_6_vz * 2.0
            + (velocities.velocity_link_6_wy * inertias.minus_inertia_link_6_hx
                - velocities.velocity_link_6_wx * inertias.minus_inertia_link_6_hy);
        let factor_link_7_px = velocities.velocity_link_7_vx * 2.0
            + (velocities.velocity_link_7_wy * inertias.inertia_link_7_hz
                + velocities.velocity_link_7_wz * inertias.minus_inertia_link_7_hy);
        let factor_link_7_py = velocities.velocity_link_7_vy * 2.0
            - (velocities.velocity_link_7_wz * inertias.minus_inertia_link_7_hx
                + velocities.velocity_link_7_wx * inertias.inertia_link_7_hz);
        let factor_link_7_pz = velocities.velocity_link_7_vz * 2.0
            + (velocities.velocity_link_7_wy * inertias.minus_inertia_link_7_hx
                - velocities.velocity_link_7_wx * inertias.minus_inertia_link_7_hy);
        let factor_link_6_px = factor_link_6_px_0 + factor_link_7_px;
        let factor_link_6_py = factor_link_6_py_0 + factor_link_7_py;
        let factor_link_6_pz = factor_link_6_pz_0 + factor_link_7_pz;
        let factor_link_5_px = factor_link_5_px_0 + factor_link_6_px;
        let factor_link_5_py = factor_link_5_py_0 + factor_link_6_py;
        let factor_link_5_pz = factor_link_5_pz_0 + factor_link_6_pz;
        let factor_link_4_px = factor_link_4_px_0 + factor_link_5_px;
        let factor_link_4_py = factor_link_4_py_0 + factor_link_5_py;
        let factor_link_4_pz = factor_link_4_pz_0 + factor_link_5_pz;
        let factor_link_3_px = factor_link_3_px_0 + factor_link_4_px;
        let factor_link_3_py = factor_link_3_py_0 + factor_link_4_py;
        let factor_link_3_pz = factor_link_3_pz_0 + factor_link_4_pz;
        let factor_link_2_px = factor_link_2_px_0 + factor_link_3_px;
        let factor_link_2_py = factor_link_2_py_0 + factor_link_3_py;
        let factor_link_2_pz = factor_link_2_pz_0 + factor_link_3_pz;
        let factor_link_1_px = factor_link_1_px_0 + factor_link_2_px;
        let factor_link_1_py = factor_link_1_py_0 + factor_link_2_py;
        let factor_link_1_pz = factor_link_2_pz - factor_link_1_pz_1;
        let six_more_joint_1_mx = d_qdot_itself.factor_outside_link_1_xz
            * screws.connection_joint_1_wz
            + (d_qdot_itself.factor_outside_link_1_xy * screws.connection_joint_1_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_x_0)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_xz
                * reactions.reaction_joint_1_wz
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_xy
                    * reactions.reaction_joint_1_wy
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_x_7))
            + (inertias.minus_inertia_base_hy
                * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_8
                - inertias.minus_inertia_base_hz
                    * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_6
                - d_qdot_itself.factor_outside_link_1_xz_0);
        let six_more_joint_1_my = d_qdot_itself.factor_outside_link_1_yz
            * screws.connection_joint_1_wz
            + (d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_y_2
                + d_qdot_itself.factor_outside_link_1_yx * screws.connection_joint_1_wx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_yz
                * reactions.reaction_joint_1_wz
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_y_9
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_yx
                        * reactions.reaction_joint_1_wx))
            + (d_qdot_itself.factor_outside_link_1_yz_1
                - (inertias.minus_inertia_base_hz
                    * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_my_6
                    + inertias.minus_inertia_base_hx
                        * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_8));
        let six_more_joint_1_mz = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .three_joint_1_z_4
            + (d_qdot_itself.factor_outside_link_1_zy * screws.connection_joint_1_wy
                + d_qdot_itself.factor_outside_link_1_zx * screws.connection_joint_1_wx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_z_13
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_zy
                    * reactions.reaction_joint_1_wy
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_1_zx
                        * reactions.reaction_joint_1_wx))
            + (inertias.minus_inertia_base_hx
                * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_6
                + inertias.minus_inertia_base_hy
                    * d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_my_6
                - d_qdot_itself.factor_outside_link_1_zz_0);
        let six_more_joint_1_fx = screws.connection_joint_1_wy
            * d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_pz
            - screws.connection_joint_1_wz
                * d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_py
            - (reactions.reaction_joint_1_wy * factor_link_1_pz
                - reactions.reaction_joint_1_wz * factor_link_1_py)
            + (d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_my_6 * 3.5
                - d_qdot_itself.factor_outside_link_1_py_2);
        let six_more_joint_1_fy = screws.connection_joint_1_wz
            * d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_px
            - screws.connection_joint_1_wx
                * d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_pz
            - (reactions.reaction_joint_1_wz * factor_link_1_px
                - reactions.reaction_joint_1_wx * factor_link_1_pz)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_6 * 3.5
                + d_qdot_itself.factor_outside_link_1_px_2);
        let six_more_joint_1_fz = screws.connection_joint_1_wx
            * d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_py
            - screws.connection_joint_1_wy
                * d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_px
            - (reactions.reaction_joint_1_wx * factor_link_1_py
                - reactions.reaction_joint_1_wy * factor_link_1_px)
            + (velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hy
                + velocities.minus_velocity_base_wx * inertias.minus_inertia_base_hx
                - d_qdot_itself_from_factor_link_5_xz_0_5_2.six_joint_1_mx_8 * 3.5);
        let three_more_joint_2_x_0 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_2_xx * poses.sin_joint_1;
        let three_more_joint_2_y_2 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_2_yy * poses.cos_joint_1;
        let three_more_joint_2_x = three_more_joint_2_x_0
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_yx
                * poses.cos_joint_1
            + (factor_link_2_py * screws.screw_joint_2_vz
                - factor_link_2_pz * screws.screw_joint_2_vy);
        let three_more_joint_2_y = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_2_xy * poses.sin_joint_1 - three_more_joint_2_y_2
            + (factor_link_2_pz * screws.screw_joint_2_vx
                - factor_link_2_px * screws.screw_joint_2_vz);
        let three_more_joint_2_z = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_2_xz * poses.sin_joint_1
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_yz
                * poses.cos_joint_1
            + (factor_link_2_px * screws.screw_joint_2_vy
                - factor_link_2_py * screws.screw_joint_2_vx);
        d_qdot[6][7] = six_more_joint_1_mx * screws.connection_joint_2_wx
            + six_more_joint_1_my * screws.connection_joint_2_wy
            + six_more_joint_1_mz * screws.connection_joint_2_wz
            + six_more_joint_1_fx * screws.connection_joint_2_vx
            + six_more_joint_1_fy * screws.connection_joint_2_vy
            + six_more_joint_1_fz * screws.connection_joint_2_vz
            + reactions.reaction_joint_1_wx * three_more_joint_2_x
            + reactions.reaction_joint_1_wy * three_more_joint_2_y
            + reactions.reaction_joint_1_wz * three_more_joint_2_z + 0.0;
        let three_more_joint_3_x_2 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_3_xx * poses.minus_rotation_link_2_xy;
        let three_more_joint_3_y_4 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_3_yy * poses.minus_rotation_link_2_yy;
        let three_more_joint_3_z_0 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_3_zz * poses.cos_joint_2;
        let three_more_joint_3_x = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_3_zx * poses.cos_joint_2
            - (three_more_joint_3_x_2
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_yx
                    * poses.minus_rotation_link_2_yy)
            + (factor_link_3_py * screws.screw_joint_3_vz
                - factor_link_3_pz * screws.screw_joint_3_vy);
        DQdotItselfFromThreeJoint1Y {
            factor_link_1_px_0,
            factor_link_1_py_0,
            factor_link_1_pz_1,
            factor_link_2_px_0,
            factor_link_2_py_0,
            factor_link_2_pz_0,
            factor_link_3_px_0,
            factor_link_3_py_0,
            factor_link_3_pz_0,
            factor_link_4_px_0,
            factor_link_4_py_0,
            factor_link_4_pz_0,
            factor_link_5_px_0,
            factor_link_5_py_0,
            factor_link_5_pz_0,
            factor_link_6_px_0,
            factor_link_6_py_0,
            factor_link_6_pz_0,
            factor_link_7_px,
            factor_link_7_py,
            factor_link_7_pz,
            factor_link_6_px,
            factor_link_6_py,
            factor_link_6_pz,
            factor_link_5_px,
            factor_link_5_py,
            factor_link_5_pz,
            factor_link_4_px,
            factor_link_4_py,
            factor_link_4_pz,
            factor_link_3_px,
            factor_link_3_py,
            factor_link_3_pz,
            factor_link_2_px,
            factor_link_2_py,
            factor_link_2_pz,
            six_more_joint_1_mx,
            six_more_joint_1_my,
            six_more_joint_1_mz,
            six_more_joint_1_fx,
            six_more_joint_1_fy,
            six_more_joint_1_fz,
            three_joint_1_y,
            three_joint_1_z,
            three_more_joint_2_x_0,
            three_more_joint_2_y_2,
            three_more_joint_3_x_2,
            three_more_joint_3_y_4,
            three_more_joint_3_z_0,
            three_more_joint_3_x,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromThreeMoreJoint3Y {
        pub(super) factor_outside_link_2_xx: f64,
        pub(super) factor_outside_link_2_yx: f64,
        pub(super) factor_outside_link_2_zx: f64,
        pub(super) factor_outside_link_2_xy: f64,
        pub(super) factor_outside_link_2_yy: f64,
        pub(super) factor_outside_link_2_zy: f64,
        pub(super) factor_outside_link_2_xz: f64,
        pub(super) factor_outside_link_2_yz: f64,
        pub(super) factor_outside_link_2_zz: f64,
        pub(super) factor_outside_link_2_px: f64,
        pub(super) factor_outside_link_2_py: f64,
        pub(super) factor_outside_link_2_pz: f64,
        pub(super) six_joint_2_mx_4: f64,
        pub(super) six_joint_2_mx_6: f64,
        pub(super) six_joint_2_mx_8: f64,
        pub(super) six_joint_2_my_10: f64,
        pub(super) six_joint_2_mx_12: f64,
        pub(super) six_joint_2_mx_10: f64,
        pub(super) three_joint_2_x_0: f64,
        pub(super) three_joint_2_y_2: f64,
        pub(super) three_joint_2_z_4: f64,
        pub(super) three_joint_2_x_9: f64,
        pub(super) three_joint_2_y_11: f64,
        pub(super) three_joint_2_z_13: f64,
        pub(super) three_joint_2_x: f64,
        pub(super) six_joint_2_mx: f64,
        pub(super) six_joint_2_my: f64,
        pub(super) six_joint_2_mz: f64,
        pub(super) three_more_joint_3_y: f64,
        pub(super) three_more_joint_3_z: f64,
        pub(super) three_more_joint_4_x_2: f64,
        pub(super) three_more_joint_4_y_0: f64,
        pub(super) three_more_joint_4_z_4: f64,
        pub(super) three_more_joint_4_x: f64,
        pub(super) three_more_joint_4_y: f64,
        pub(super) three_more_joint_4_z: f64,
        pub(super) three_more_joint_5_x_2: f64,
        pub(super) three_more_joint_5_y_4: f64,
        pub(super) three_more_joint_5_z_0: f64,
        pub(super) three_more_joint_5_x: f64,
        pub(super) three_more_joint_5_y: f64,
        pub(super) three_more_joint_5_z: f64,
        pub(super) three_more_joint_6_x_0: f64,
        pub(super) three_more_joint_6_y_2: f64,
        pub(super) three_more_joint_6_z_4: f64,
        pub(super) three_more_joint_6_x: f64,
        pub(super) three_more_joint_6_y: f64,
        pub(super) three_more_joint_6_z: f64,
        pub(super) three_more_joint_7_x_2: f64,
        pub(super) three_more_joint_7_y_4: f64,
        pub(super) three_more_joint_7_z_0: f64,
        pub(super) three_more_joint_7_x: f64,
        pub(super) three_more_joint_7_y: f64,
        pub(super) three_more_joint_7_z: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_three_more_joint_3_y(
        poses: &Poses,
        inertias: &Inertias,
        screws: &Screws,
        reactions: &Reactions,
        velocities: &Velocities,
        d_qdot_itself: &DQdotItself,
        d_qdot_itself_from_factor_outside_link_1_px: &DQdotItselfFromFactorOutsideLink1Px,
        d_qdot_itself_from_factor_link_5_xz_0_5_2: &DQdotItselfFromFactorLink5Xz0_5_2,
        d_qdot_itself_from_three_joint_1_y: &DQdotItselfFromThreeJoint1Y,
        d_qdot: &mut [[f64; 13]; 13],
    ) -> DQdotItselfFromThreeMoreJoint3Y {
        let three_more_joint_3_y = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_3_zy * poses.cos_joint_2
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_xy
                * poses.minus_rotation_link_2_xy
                + d_qdot_itself_from_three_joint_1_y.three_more_joint_3_y_4)
            + (d_qdot_itself_from_three_joint_1_y.factor_link_3_pz
                * screws.screw_joint_3_vx
                - d_qdot_itself_from_three_joint_1_y.factor_link_3_px
                    * screws.screw_joint_3_vz);
        let three_more_joint_3_z = d_qdot_itself_from_three_joint_1_y
            .three_more_joint_3_z_0
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_xz
                * poses.minus_rotation_link_2_xy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_yz
                    * poses.minus_rotation_link_2_yy)
            + (d_qdot_itself_from_three_joint_1_y.factor_link_3_px
                * screws.screw_joint_3_vy
                - d_qdot_itself_from_three_joint_1_y.factor_link_3_py
                    * screws.screw_joint_3_vx);
        // D_q\u{307} column joint_1
        d_qdot[6][8] = d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mx
            * screws.connection_joint_3_wx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_my
                * screws.connection_joint_3_wy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mz
                * screws.connection_joint_3_wz
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fx
                * screws.connection_joint_3_vx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fy
                * screws.connection_joint_3_vy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fz
                * screws.connection_joint_3_vz
            + reactions.reaction_joint_1_wx
                * d_qdot_itself_from_three_joint_1_y.three_more_joint_3_x
            + reactions.reaction_joint_1_wy * three_more_joint_3_y
            + reactions.reaction_joint_1_wz * three_more_joint_3_z + 0.0;
        let three_more_joint_4_x_2 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_4_xx * poses.minus_rotation_link_3_xy;
        let three_more_joint_4_y_0 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_4_yy * poses.rotation_link_3_yy;
        let three_more_joint_4_z_4 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_4_zz * poses.minus_rotation_link_3_zy;
        let three_more_joint_4_x = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_4_yx * poses.rotation_link_3_yy - three_more_joint_4_x_2
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_zx
                * poses.minus_rotation_link_3_zy
            + (d_qdot_itself_from_three_joint_1_y.factor_link_4_pz
                * screws.minus_screw_joint_4_vy
                - d_qdot_itself_from_three_joint_1_y.factor_link_4_py
                    * screws.minus_screw_joint_4_vz);
        let three_more_joint_4_y = three_more_joint_4_y_0
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_xy
                * poses.minus_rotation_link_3_xy
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_zy
                * poses.minus_rotation_link_3_zy
            + (d_qdot_itself_from_three_joint_1_y.factor_link_4_pz
                * screws.screw_joint_4_vx
                + d_qdot_itself_from_three_joint_1_y.factor_link_4_px
                    * screws.minus_screw_joint_4_vz);
        let three_more_joint_4_z = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_4_yz * poses.rotation_link_3_yy
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_xz
                * poses.minus_rotation_link_3_xy - three_more_joint_4_z_4
            - (d_qdot_itself_from_three_joint_1_y.factor_link_4_px
                * screws.minus_screw_joint_4_vy
                + d_qdot_itself_from_three_joint_1_y.factor_link_4_py
                    * screws.screw_joint_4_vx);
        d_qdot[6][9] = d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mx
            * screws.connection_joint_4_wx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_my
                * screws.connection_joint_4_wy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mz
                * screws.connection_joint_4_wz
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fx
                * screws.connection_joint_4_vx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fy
                * screws.connection_joint_4_vy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fz
                * screws.connection_joint_4_vz
            + reactions.reaction_joint_1_wx * three_more_joint_4_x
            + reactions.reaction_joint_1_wy * three_more_joint_4_y
            + reactions.reaction_joint_1_wz * three_more_joint_4_z + 0.0;
        let three_more_joint_5_x_2 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_xx * poses.rotation_link_4_xy;
        let three_more_joint_5_y_4 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_yy * poses.rotation_link_4_yy;
        let three_more_joint_5_z_0 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_zz * poses.rotation_link_5_zz;
        let three_more_joint_5_x = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_zx * poses.rotation_link_5_zz
            - (three_more_joint_5_x_2
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_yx
                    * poses.rotation_link_4_yy)
            + (d_qdot_itself_from_three_joint_1_y.factor_link_5_py
                * screws.screw_joint_5_vz
                - d_qdot_itself_from_three_joint_1_y.factor_link_5_pz
                    * screws.screw_joint_5_vy);
        let three_more_joint_5_y = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_zy * poses.rotation_link_5_zz
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_xy
                * poses.rotation_link_4_xy + three_more_joint_5_y_4)
            + (d_qdot_itself_from_three_joint_1_y.factor_link_5_pz
                * screws.screw_joint_5_vx
                - d_qdot_itself_from_three_joint_1_y.factor_link_5_px
                    * screws.screw_joint_5_vz);
        let three_more_joint_5_z = three_more_joint_5_z_0
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_xz
                * poses.rotation_link_4_xy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_yz
                    * poses.rotation_link_4_yy)
            + (d_qdot_itself_from_three_joint_1_y.factor_link_5_px
                * screws.screw_joint_5_vy
                - d_qdot_itself_from_three_joint_1_y.factor_link_5_py
                    * screws.screw_joint_5_vx);
        d_qdot[6][10] = d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mx
            * screws.connection_joint_5_wx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_my
                * screws.connection_joint_5_wy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mz
                * screws.connection_joint_5_wz
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fx
                * screws.connection_joint_5_vx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fy
                * screws.connection_joint_5_vy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fz
                * screws.connection_joint_5_vz
            + reactions.reaction_joint_1_wx * three_more_joint_5_x
            + reactions.reaction_joint_1_wy * three_more_joint_5_y
            + reactions.reaction_joint_1_wz * three_more_joint_5_z + 0.0;
        let three_more_joint_6_x_0 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_xx * poses.rotation_link_6_xz;
        let three_more_joint_6_y_2 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_yy * poses.rotation_link_5_yy;
        let three_more_joint_6_z_4 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_zz * poses.rotation_link_6_zz;
        let three_more_joint_6_x = three_more_joint_6_x_0
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_yx
                * poses.rotation_link_5_yy
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_zx
                * poses.rotation_link_6_zz
            + (d_qdot_itself_from_three_joint_1_y.factor_link_6_py
                * screws.screw_joint_6_vz
                - d_qdot_itself_from_three_joint_1_y.factor_link_6_pz
                    * screws.screw_joint_6_vy);
        let three_more_joint_6_y = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_xy * poses.rotation_link_6_xz - three_more_joint_6_y_2
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_zy
                * poses.rotation_link_6_zz
            + (d_qdot_itself_from_three_joint_1_y.factor_link_6_pz
                * screws.screw_joint_6_vx
                - d_qdot_itself_from_three_joint_1_y.factor_link_6_px
                    * screws.screw_joint_6_vz);
        let three_more_joint_6_z = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_xz * poses.rotation_link_6_xz
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_yz
                * poses.rotation_link_5_yy + three_more_joint_6_z_4
            + (d_qdot_itself_from_three_joint_1_y.factor_link_6_px
                * screws.screw_joint_6_vy
                - d_qdot_itself_from_three_joint_1_y.factor_link_6_py
                    * screws.screw_joint_6_vx);
        d_qdot[6][11] = d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mx
            * screws.connection_joint_6_wx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_my
                * screws.connection_joint_6_wy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mz
                * screws.connection_joint_6_wz
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fx
                * screws.connection_joint_6_vx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fy
                * screws.connection_joint_6_vy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fz
                * screws.connection_joint_6_vz
            + reactions.reaction_joint_1_wx * three_more_joint_6_x
            + reactions.reaction_joint_1_wy * three_more_joint_6_y
            + reactions.reaction_joint_1_wz * three_more_joint_6_z + 0.0;
        let three_more_joint_7_x_2 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_7_xx * poses.minus_rotation_link_6_xy;
        let three_more_joint_7_y_4 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_7_yy * poses.minus_rotation_link_6_yy;
        let three_more_joint_7_z_0 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_7_zz * poses.rotation_link_6_zy;
        let three_more_joint_7_x = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_7_zx * poses.rotation_link_6_zy
            - (three_more_joint_7_x_2
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_yx
                    * poses.minus_rotation_link_6_yy)
            + (d_qdot_itself_from_three_joint_1_y.factor_link_7_py
                * screws.screw_joint_7_vz
                - d_qdot_itself_from_three_joint_1_y.factor_link_7_pz
                    * screws.screw_joint_7_vy);
        let three_more_joint_7_y = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_7_zy * poses.rotation_link_6_zy
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_xy
                * poses.minus_rotation_link_6_xy + three_more_joint_7_y_4)
            + (d_qdot_itself_from_three_joint_1_y.factor_link_7_pz
                * screws.screw_joint_7_vx
                - d_qdot_itself_from_three_joint_1_y.factor_link_7_px
                    * screws.screw_joint_7_vz);
        let three_more_joint_7_z = three_more_joint_7_z_0
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_xz
                * poses.minus_rotation_link_6_xy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_yz
                    * poses.minus_rotation_link_6_yy)
            + (d_qdot_itself_from_three_joint_1_y.factor_link_7_px
                * screws.screw_joint_7_vy
                - d_qdot_itself_from_three_joint_1_y.factor_link_7_py
                    * screws.screw_joint_7_vx);
        d_qdot[6][12] = d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mx
            * screws.connection_joint_7_wx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_my
                * screws.connection_joint_7_wy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_mz
                * screws.connection_joint_7_wz
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fx
                * screws.connection_joint_7_vx
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fy
                * screws.connection_joint_7_vy
            + d_qdot_itself_from_three_joint_1_y.six_more_joint_1_fz
                * screws.connection_joint_7_vz
            + reactions.reaction_joint_1_wx * three_more_joint_7_x
            + reactions.reaction_joint_1_wy * three_more_joint_7_y
            + reactions.reaction_joint_1_wz * three_more_joint_7_z + 0.0;
        // D_q\u{307} column joint_2
        d_qdot[7][0] = 0.0;
        d_qdot[7][1] = 0.0;
        d_qdot[7][2] = 0.0;
        d_qdot[7][3] = 0.0;
        d_qdot[7][4] = 0.0;
        d_qdot[7][5] = 0.0;
        let six_joint_2_mx_4 = velocities.velocity_link_1_wz * poses.cos_joint_1;
        let six_joint_2_mx_6 = velocities.velocity_link_1_wz * poses.sin_joint_1;
        let six_joint_2_mx_8 = velocities.minus_velocity_link_2_wy * poses.sin_joint_1
            - velocities.velocity_link_2_wx * poses.cos_joint_1;
        let six_joint_2_my_10 = velocities.velocity_link_2_vz * poses.cos_joint_1
            - (velocities.minus_velocity_link_2_wy * screws.screw_joint_2_vz
                + velocities.velocity_link_1_wz * screws.screw_joint_2_vy);
        let six_joint_2_mx_12 = velocities.velocity_link_1_wz * screws.screw_joint_2_vx
            - velocities.velocity_link_2_wx * screws.screw_joint_2_vz
            + velocities.velocity_link_2_vz * poses.sin_joint_1;
        let six_joint_2_mx_10 = velocities.velocity_link_2_wx * screws.screw_joint_2_vy
            + velocities.minus_velocity_link_2_wy * screws.screw_joint_2_vx
            - (velocities.velocity_link_2_vx * poses.cos_joint_1
                + velocities.velocity_link_2_vy * poses.sin_joint_1);
        let six_joint_2_mx = d_qdot_itself_from_three_joint_1_y.three_more_joint_2_x_0
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_xy
                * poses.cos_joint_1
            + (inertias.composite_link_2_xx * six_joint_2_mx_4
                + inertias.composite_link_2_xy * six_joint_2_mx_6
                + inertias.composite_link_2_xz * six_joint_2_mx_8
                + (inertias.composite_link_2_hy * six_joint_2_mx_10
                    - inertias.composite_link_2_hz * six_joint_2_mx_12));
        let six_joint_2_my = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_yx
            * poses.sin_joint_1
            - d_qdot_itself_from_three_joint_1_y.three_more_joint_2_y_2
            + (inertias.composite_link_2_xy * six_joint_2_mx_4
                + inertias.composite_link_2_yy * six_joint_2_mx_6
                + inertias.composite_link_2_yz * six_joint_2_mx_8
                + (inertias.composite_link_2_hz * six_joint_2_my_10
                    - inertias.composite_link_2_hx * six_joint_2_mx_10));
        let six_joint_2_mz = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_zx
            * poses.sin_joint_1
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_zy
                * poses.cos_joint_1
            + (inertias.composite_link_2_xz * six_joint_2_mx_4
                + inertias.composite_link_2_yz * six_joint_2_mx_6
                + inertias.composite_link_2_zz * six_joint_2_mx_8
                + (inertias.composite_link_2_hx * six_joint_2_mx_12
                    - inertias.composite_link_2_hy * six_joint_2_my_10));
        d_qdot[7][6] = reactions.reaction_joint_1_wx * six_joint_2_mx
            + reactions.reaction_joint_1_wy * six_joint_2_my
            + reactions.reaction_joint_1_wz * six_joint_2_mz
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_x
                * screws.connection_joint_2_wx
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_y
                * screws.connection_joint_2_wy
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_z
                * screws.connection_joint_2_wz + 0.0;
        let factor_outside_link_2_xx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_xx_0 + d_qdot_itself.factor_outside_link_1_xx;
        let factor_outside_link_2_yx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_yx_0 + d_qdot_itself.factor_outside_link_1_yx;
        let factor_outside_link_2_zx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_zx_0 + d_qdot_itself.factor_outside_link_1_zx;
        let factor_outside_link_2_xy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_xy_0 + d_qdot_itself.factor_outside_link_1_xy;
        let factor_outside_link_2_yy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_yy_0 + d_qdot_itself.factor_outside_link_1_yy;
        let factor_outside_link_2_zy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_zy_0 + d_qdot_itself.factor_outside_link_1_zy;
        let factor_outside_link_2_xz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_xz_0 + d_qdot_itself.factor_outside_link_1_xz;
        let factor_outside_link_2_yz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_yz_0 + d_qdot_itself.factor_outside_link_1_yz;
        let factor_outside_link_2_zz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_1_zz_0 + d_qdot_itself.factor_outside_link_1_zz;
        let factor_outside_link_2_px = d_qdot_itself_from_three_joint_1_y
            .factor_link_1_px_0
            + d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_px;
        let factor_outside_link_2_py = d_qdot_itself_from_three_joint_1_y
            .factor_link_1_py_0
            + d_qdot_itself_from_factor_outside_link_1_px.factor_outside_link_1_py;
        let factor_outside_link_2_pz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_outside_link_1_pz
            - d_qdot_itself_from_three_joint_1_y.factor_link_1_pz_1;
        let three_joint_2_x_0 = factor_outside_link_2_xx * screws.connection_joint_2_wx;
        let three_joint_2_y_2 = factor_outside_link_2_yy * screws.connection_joint_2_wy;
        let three_joint_2_z_4 = factor_outside_link_2_zz * screws.connection_joint_2_wz;
        let three_joint_2_x_9 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_2_xx * reactions.reaction_joint_2_wx;
        let three_joint_2_y_11 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_2_yy * reactions.reaction_joint_2_wy;
        let three_joint_2_z_13 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_2_zz * reactions.reaction_joint_2_wz;
        let three_joint_2_x = three_joint_2_x_0
            + factor_outside_link_2_yx * screws.connection_joint_2_wy
            + factor_outside_link_2_zx * screws.connection_joint_2_wz
            + (factor_outside_link_2_py * screws.connection_joint_2_vz
                - factor_outside_link_2_pz * screws.connection_joint_2_vy)
            - (three_joint_2_x_9
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_yx
                    * reactions.reaction_joint_2_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_zx
                    * reactions.reaction_joint_2_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_2_py
                    * reactions.reaction_joint_2_vz
                    - d_qdot_itself_from_three_joint_1_y.factor_link_2_pz
                        * reactions.reaction_joint_2_vy));
        DQdotItselfFromThreeMoreJoint3Y {
            factor_outside_link_2_xx,
            factor_outside_link_2_yx,
            factor_outside_link_2_zx,
            factor_outside_link_2_xy,
            factor_outside_link_2_yy,
            factor_outside_link_2_zy,
            factor_outside_link_2_xz,
            factor_outside_link_2_yz,
            factor_outside_link_2_zz,
            factor_outside_link_2_px,
            factor_outside_link_2_py,
            factor_outside_link_2_pz,
            six_joint_2_mx_4,
            six_joint_2_mx_6,
            six_joint_2_mx_8,
            six_joint_2_my_10,
            six_joint_2_mx_12,
            six_joint_2_mx_10,
            three_joint_2_x_0,
            three_joint_2_y_2,
            three_joint_2_z_4,
            three_joint_2_x_9,
            three_joint_2_y_11,
            three_joint_2_z_13,
            three_joint_2_x,
            six_joint_2_mx,
            six_joint_2_my,
            six_joint_2_mz,
            three_more_joint_3_y,
            three_more_joint_3_z,
            three_more_joint_4_x_2,
            three_more_joint_4_y_0,
            three_more_joint_4_z_4,
            three_more_joint_4_x,
            three_more_joint_4_y,
            three_more_joint_4_z,
            three_more_joint_5_x_2,
            three_more_joint_5_y_4,
            three_more_joint_5_z_0,
            three_more_joint_5_x,
            three_more_joint_5_y,
            three_more_joint_5_z,
            three_more_joint_6_x_0,
            three_more_joint_6_y_2,
            three_more_joint_6_z_4,
            three_more_joint_6_x,
            three_more_joint_6_y,
            three_more_joint_6_z,
            three_more_joint_7_x_2,
            three_more_joint_7_y_4,
            three_more_joint_7_z_0,
            three_more_joint_7_x,
            three_more_joint_7_y,
            three_more_joint_7_z,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromThreeJoint2Y {
        pub(super) three_joint_2_y: f64,
        pub(super) three_joint_2_z: f64,
        pub(super) six_joint_3_mx_6: f64,
        pub(super) six_joint_3_mx_8: f64,
        pub(super) six_joint_3_mx_10: f64,
        pub(super) six_joint_3_my_12: f64,
        pub(super) six_joint_3_mx_14: f64,
        pub(super) six_joint_3_mx_12: f64,
        pub(super) six_joint_3_mx: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_three_joint_2_y(
        poses: &Poses,
        inertias: &Inertias,
        complements: &Complements,
        screws: &Screws,
        reactions: &Reactions,
        velocities: &Velocities,
        d_qdot_itself_from_factor_link_5_xz_0_5_2: &DQdotItselfFromFactorLink5Xz0_5_2,
        d_qdot_itself_from_three_joint_1_y: &DQdotItselfFromThreeJoint1Y,
        d_qdot_itself_from_three_more_joint_3_y: &DQdotItselfFromThreeMoreJoint3Y,
        d_qdot: &mut [[f64; 13]; 13],
    ) -> DQdotItselfFromThreeJoint2Y {
        let three_joint_2_y = d_qdot_itself_from_three_more_joint_3_y
            .factor_outside_link_2_xy * screws.connection_joint_2_wx
            + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_y_2
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_zy
                * screws.connection_joint_2_wz
            + (d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_pz
                * screws.connection_joint_2_vx
                - d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_px
                    * screws.connection_joint_2_vz)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_xy
                * reactions.reaction_joint_2_wx
                + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_y_11
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_zy
                    * reactions.reaction_joint_2_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_2_pz
                    * reactions.reaction_joint_2_vx
                    - d_qdot_itself_from_three_joint_1_y.factor_link_2_px
                        * reactions.reaction_joint_2_vz));
        let three_joint_2_z = d_qdot_itself_from_three_more_joint_3_y
            .factor_outside_link_2_xz * screws.connection_joint_2_wx
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_yz
                * screws.connection_joint_2_wy
            + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_z_4
            + (d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_px
                * screws.connection_joint_2_vy
                - d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_py
                    * screws.connection_joint_2_vx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_xz
                * reactions.reaction_joint_2_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_yz
                    * reactions.reaction_joint_2_wy
                + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_z_13
                + (d_qdot_itself_from_three_joint_1_y.factor_link_2_px
                    * reactions.reaction_joint_2_vy
                    - d_qdot_itself_from_three_joint_1_y.factor_link_2_py
                        * reactions.reaction_joint_2_vx));
        let six_joint_2_fx = d_qdot_itself_from_three_more_joint_3_y.six_joint_2_my_10
            * 12.0
            + (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_6
                * inertias.composite_link_2_hz
                - d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_8
                    * inertias.composite_link_2_hy)
            - poses.cos_joint_1 * d_qdot_itself_from_three_joint_1_y.factor_link_2_pz;
        let six_joint_2_fy = d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_12
            * 12.0
            + (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_8
                * inertias.composite_link_2_hx
                - d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_4
                    * inertias.composite_link_2_hz)
            - poses.sin_joint_1 * d_qdot_itself_from_three_joint_1_y.factor_link_2_pz;
        let six_joint_2_fz = poses.sin_joint_1
            * d_qdot_itself_from_three_joint_1_y.factor_link_2_py
            + poses.cos_joint_1 * d_qdot_itself_from_three_joint_1_y.factor_link_2_px
            + (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_10 * 12.0
                + (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_4
                    * inertias.composite_link_2_hy
                    - d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_6
                        * inertias.composite_link_2_hx));
        // D_q\u{307} column joint_2
        d_qdot[7][7] = reactions.reaction_joint_2_wx
            * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx
            + reactions.reaction_joint_2_wy
                * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_my
            + reactions.reaction_joint_2_wz
                * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mz
            + reactions.reaction_joint_2_vx * six_joint_2_fx
            + reactions.reaction_joint_2_vy * six_joint_2_fy
            + reactions.reaction_joint_2_vz * six_joint_2_fz
            + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_x
                * screws.connection_joint_2_wx
            + three_joint_2_y * screws.connection_joint_2_wy
            + three_joint_2_z * screws.connection_joint_2_wz + 0.0;
        let six_more_joint_2_mx = d_qdot_itself_from_three_more_joint_3_y
            .factor_outside_link_2_xz * screws.connection_joint_2_wz
            + (d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_xy
                * screws.connection_joint_2_wy
                + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_x_0)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_xz
                * reactions.reaction_joint_2_wz
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_xy
                    * reactions.reaction_joint_2_wy
                    + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_x_9))
            + (complements.complement_link_2_xx
                * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_4
                + complements.complement_link_2_xy
                    * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_6
                + complements.complement_link_2_xz
                    * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_8
                + (complements.complement_link_2_hy
                    * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_10
                    - complements.complement_link_2_hz
                        * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_12));
        let six_more_joint_2_my = d_qdot_itself_from_three_more_joint_3_y
            .factor_outside_link_2_yz * screws.connection_joint_2_wz
            + (d_qdot_itself_from_three_more_joint_3_y.three_joint_2_y_2
                + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_yx
                    * screws.connection_joint_2_wx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_yz
                * reactions.reaction_joint_2_wz
                + (d_qdot_itself_from_three_more_joint_3_y.three_joint_2_y_11
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_yx
                        * reactions.reaction_joint_2_wx))
            + (complements.complement_link_2_xy
                * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_4
                + complements.complement_link_2_yy
                    * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_6
                - complements.minus_complement_link_2_yz
                    * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_8
                + (complements.complement_link_2_hz
                    * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_my_10
                    + complements.minus_complement_link_2_hx
                        * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_10));
        let six_more_joint_2_mz = d_qdot_itself_from_three_more_joint_3_y
            .three_joint_2_z_4
            + (d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_zy
                * screws.connection_joint_2_wy
                + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_zx
                    * screws.connection_joint_2_wx)
            - (d_qdot_itself_from_three_more_joint_3_y.three_joint_2_z_13
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_zy
                    * reactions.reaction_joint_2_wy
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_2_zx
                        * reactions.reaction_joint_2_wx))
            + (complements.complement_link_2_xz
                * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_4
                - complements.minus_complement_link_2_yz
                    * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_6
                + complements.complement_link_2_zz
                    * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_8
                - (complements.minus_complement_link_2_hx
                    * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_12
                    + complements.complement_link_2_hy
                        * d_qdot_itself_from_three_more_joint_3_y.six_joint_2_my_10));
        let six_more_joint_2_fx = screws.connection_joint_2_wy
            * d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_pz
            - screws.connection_joint_2_wz
                * d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_py
            - (reactions.reaction_joint_2_wy
                * d_qdot_itself_from_three_joint_1_y.factor_link_2_pz
                - reactions.reaction_joint_2_wz
                    * d_qdot_itself_from_three_joint_1_y.factor_link_2_py)
            + (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_my_10 * 5.5
                + (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_6
                    * complements.complement_link_2_hz
                    - d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_8
                        * complements.complement_link_2_hy));
        let six_more_joint_2_fy = screws.connection_joint_2_wz
            * d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_px
            - screws.connection_joint_2_wx
                * d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_pz
            - (reactions.reaction_joint_2_wz
                * d_qdot_itself_from_three_joint_1_y.factor_link_2_px
                - reactions.reaction_joint_2_wx
                    * d_qdot_itself_from_three_joint_1_y.factor_link_2_pz)
            + (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_12 * 5.5
                - (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_8
                    * complements.minus_complement_link_2_hx
                    + d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_4
                        * complements.complement_link_2_hz));
        let six_more_joint_2_fz = screws.connection_joint_2_wx
            * d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_py
            - screws.connection_joint_2_wy
                * d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_px
            - (reactions.reaction_joint_2_wx
                * d_qdot_itself_from_three_joint_1_y.factor_link_2_py
                - reactions.reaction_joint_2_wy
                    * d_qdot_itself_from_three_joint_1_y.factor_link_2_px)
            + (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_10 * 5.5
                + (d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_4
                    * complements.complement_link_2_hy
                    + d_qdot_itself_from_three_more_joint_3_y.six_joint_2_mx_6
                        * complements.minus_complement_link_2_hx));
        d_qdot[7][8] = six_more_joint_2_mx * screws.connection_joint_3_wx
            + six_more_joint_2_my * screws.connection_joint_3_wy
            + six_more_joint_2_mz * screws.connection_joint_3_wz
            + six_more_joint_2_fx * screws.connection_joint_3_vx
            + six_more_joint_2_fy * screws.connection_joint_3_vy
            + six_more_joint_2_fz * screws.connection_joint_3_vz
            + reactions.reaction_joint_2_wx
                * d_qdot_itself_from_three_joint_1_y.three_more_joint_3_x
            + reactions.reaction_joint_2_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_3_y
            + reactions.reaction_joint_2_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_3_z + 0.0;
        d_qdot[7][9] = six_more_joint_2_mx * screws.connection_joint_4_wx
            + six_more_joint_2_my * screws.connection_joint_4_wy
            + six_more_joint_2_mz * screws.connection_joint_4_wz
            + six_more_joint_2_fx * screws.connection_joint_4_vx
            + six_more_joint_2_fy * screws.connection_joint_4_vy
            + six_more_joint_2_fz * screws.connection_joint_4_vz
            + reactions.reaction_joint_2_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_4_x
            + reactions.reaction_joint_2_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_4_y
            + reactions.reaction_joint_2_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_4_z + 0.0;
        d_qdot[7][10] = six_more_joint_2_mx * screws.connection_joint_5_wx
            + six_more_joint_2_my * screws.connection_joint_5_wy
            + six_more_joint_2_mz * screws.connection_joint_5_wz
            + six_more_joint_2_fx * screws.connection_joint_5_vx
            + six_more_joint_2_fy * screws.connection_joint_5_vy
            + six_more_joint_2_fz * screws.connection_joint_5_vz
            + reactions.reaction_joint_2_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_x
            + reactions.reaction_joint_2_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_y
            + reactions.reaction_joint_2_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_z + 0.0;
        d_qdot[7][11] = six_more_joint_2_mx * screws.connection_joint_6_wx
            + six_more_joint_2_my * screws.connection_joint_6_wy
            + six_more_joint_2_mz * screws.connection_joint_6_wz
            + six_more_joint_2_fx * screws.connection_joint_6_vx
            + six_more_joint_2_fy * screws.connection_joint_6_vy
            + six_more_joint_2_fz * screws.connection_joint_6_vz
            + reactions.reaction_joint_2_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_x
            + reactions.reaction_joint_2_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_y
            + reactions.reaction_joint_2_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_z + 0.0;
        d_qdot[7][12] = six_more_joint_2_mx * screws.connection_joint_7_wx
            + six_more_joint_2_my * screws.connection_joint_7_wy
            + six_more_joint_2_mz * screws.connection_joint_7_wz
            + six_more_joint_2_fx * screws.connection_joint_7_vx
            + six_more_joint_2_fy * screws.connection_joint_7_vy
            + six_more_joint_2_fz * screws.connection_joint_7_vz
            + reactions.reaction_joint_2_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_x
            + reactions.reaction_joint_2_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_y
            + reactions.reaction_joint_2_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_z + 0.0;
        // D_q\u{307} column joint_3
        d_qdot[8][0] = 0.0;
        d_qdot[8][1] = 0.0;
        d_qdot[8][2] = 0.0;
        d_qdot[8][3] = 0.0;
        d_qdot[8][4] = 0.0;
        d_qdot[8][5] = 0.0;
        let six_joint_3_mx_6 = velocities.velocity_link_3_wz
            * poses.minus_rotation_link_2_yy
            - velocities.minus_velocity_link_3_wy * poses.cos_joint_2;
        let six_joint_3_mx_8 = velocities.velocity_link_3_wz
            * poses.minus_rotation_link_2_xy
            + velocities.velocity_link_3_wx * poses.cos_joint_2;
        let six_joint_3_mx_10 = velocities.velocity_link_3_wx
            * poses.minus_rotation_link_2_yy
            + velocities.minus_velocity_link_3_wy * poses.minus_rotation_link_2_xy;
        let six_joint_3_my_12 = velocities.velocity_link_3_vy * poses.cos_joint_2
            + velocities.velocity_link_3_vz * poses.minus_rotation_link_2_yy
            - (velocities.minus_velocity_link_3_wy * screws.screw_joint_3_vz
                + velocities.velocity_link_3_wz * screws.screw_joint_3_vy);
        let six_joint_3_mx_14 = velocities.velocity_link_3_wz * screws.screw_joint_3_vx
            - velocities.velocity_link_3_wx * screws.screw_joint_3_vz
            - (velocities.velocity_link_3_vz * poses.minus_rotation_link_2_xy
                + velocities.velocity_link_3_vx * poses.cos_joint_2);
        let six_joint_3_mx_12 = velocities.velocity_link_3_wx * screws.screw_joint_3_vy
            + velocities.minus_velocity_link_3_wy * screws.screw_joint_3_vx
            + (velocities.velocity_link_3_vy * poses.minus_rotation_link_2_xy
                - velocities.velocity_link_3_vx * poses.minus_rotation_link_2_yy);
        let six_joint_3_mx = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_xz
            * poses.cos_joint_2
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_xy
                * poses.minus_rotation_link_2_yy
                + d_qdot_itself_from_three_joint_1_y.three_more_joint_3_x_2)
            + (inertias.composite_link_3_xx * six_joint_3_mx_6
                - inertias.composite_link_3_xy * six_joint_3_mx_8
                - inertias.composite_link_3_xz * six_joint_3_mx_10
                + (inertias.composite_link_3_hy * six_joint_3_mx_12
                    - inertias.composite_link_3_hz * six_joint_3_mx_14));
        DQdotItselfFromThreeJoint2Y {
            three_joint_2_y,
            three_joint_2_z,
            six_joint_3_mx_6,
            six_joint_3_mx_8,
            six_joint_3_mx_10,
            six_joint_3_my_12,
            six_joint_3_mx_14,
            six_joint_3_mx_12,
            six_joint_3_mx,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromSixJoint3My {
        pub(super) factor_outside_link_3_xx: f64,
        pub(super) factor_outside_link_3_yx: f64,
        pub(super) factor_outside_link_3_zx: f64,
        pub(super) factor_outside_link_3_xy: f64,
        pub(super) factor_outside_link_3_yy: f64,
        pub(super) factor_outside_link_3_zy: f64,
        pub(super) factor_outside_link_3_xz: f64,
        pub(super) factor_outside_link_3_yz: f64,
        pub(super) factor_outside_link_3_zz: f64,
        pub(super) factor_outside_link_3_px: f64,
        pub(super) factor_outside_link_3_py: f64,
        pub(super) factor_outside_link_3_pz: f64,
        pub(super) three_joint_3_x: f64,
        pub(super) three_joint_3_y: f64,
        pub(super) three_joint_3_z: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_six_joint_3_my(
        poses: &Poses,
        inertias: &Inertias,
        complements: &Complements,
        screws: &Screws,
        reactions: &Reactions,
        d_qdot_itself_from_factor_outside_link_1_px: &DQdotItselfFromFactorOutsideLink1Px,
        d_qdot_itself_from_factor_link_5_xz_0_5_2: &DQdotItselfFromFactorLink5Xz0_5_2,
        d_qdot_itself_from_three_joint_1_y: &DQdotItselfFromThreeJoint1Y,
        d_qdot_itself_from_three_more_joint_3_y: &DQdotItselfFromThreeMoreJoint3Y,
        d_qdot_itself_from_three_joint_2_y: &DQdotItselfFromThreeJoint2Y,
        d_qdot: &mut [[f64; 13]; 13],
    ) -> DQdotItselfFromSixJoint3My {
        let six_joint_3_my = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_yz
            * poses.cos_joint_2
            - (d_qdot_itself_from_three_joint_1_y.three_more_joint_3_y_4
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_yx
                    * poses.minus_rotation_link_2_xy)
            + (inertias.composite_link_3_xy
                * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_6
                - inertias.composite_link_3_yy
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_8
                - inertias.composite_link_3_yz
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_10
                + (inertias.composite_link_3_hz
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_my_12
                    - inertias.composite_link_3_hx
                        * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_12));
        let six_joint_3_mz = d_qdot_itself_from_three_joint_1_y.three_more_joint_3_z_0
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_zy
                * poses.minus_rotation_link_2_yy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_zx
                    * poses.minus_rotation_link_2_xy)
            + (inertias.composite_link_3_xz
                * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_6
                - inertias.composite_link_3_yz
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_8
                - inertias.composite_link_3_zz
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_10
                + (inertias.composite_link_3_hx
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_14
                    - inertias.composite_link_3_hy
                        * d_qdot_itself_from_three_joint_2_y.six_joint_3_my_12));
        // D_q\u{307} column joint_3
        d_qdot[8][6] = reactions.reaction_joint_1_wx
            * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx
            + reactions.reaction_joint_1_wy * six_joint_3_my
            + reactions.reaction_joint_1_wz * six_joint_3_mz
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_x
                * screws.connection_joint_3_wx
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_y
                * screws.connection_joint_3_wy
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_z
                * screws.connection_joint_3_wz + 0.0;
        let six_joint_3_fx = d_qdot_itself_from_three_joint_2_y.six_joint_3_my_12 * 10.0
            + (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_10
                * inertias.composite_link_3_hy
                - d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_8
                    * inertias.composite_link_3_hz)
            - (poses.minus_rotation_link_2_yy
                * d_qdot_itself_from_three_joint_1_y.factor_link_3_pz
                + poses.cos_joint_2
                    * d_qdot_itself_from_three_joint_1_y.factor_link_3_py);
        let six_joint_3_fy = poses.cos_joint_2
            * d_qdot_itself_from_three_joint_1_y.factor_link_3_px
            + poses.minus_rotation_link_2_xy
                * d_qdot_itself_from_three_joint_1_y.factor_link_3_pz
            + (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_14 * 10.0
                - (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_10
                    * inertias.composite_link_3_hx
                    + d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_6
                        * inertias.composite_link_3_hz));
        let six_joint_3_fz = poses.minus_rotation_link_2_yy
            * d_qdot_itself_from_three_joint_1_y.factor_link_3_px
            - poses.minus_rotation_link_2_xy
                * d_qdot_itself_from_three_joint_1_y.factor_link_3_py
            + (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_12 * 10.0
                + (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_6
                    * inertias.composite_link_3_hy
                    + d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_8
                        * inertias.composite_link_3_hx));
        d_qdot[8][7] = reactions.reaction_joint_2_wx
            * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx
            + reactions.reaction_joint_2_wy * six_joint_3_my
            + reactions.reaction_joint_2_wz * six_joint_3_mz
            + reactions.reaction_joint_2_vx * six_joint_3_fx
            + reactions.reaction_joint_2_vy * six_joint_3_fy
            + reactions.reaction_joint_2_vz * six_joint_3_fz
            + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_x
                * screws.connection_joint_3_wx
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_y
                * screws.connection_joint_3_wy
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_z
                * screws.connection_joint_3_wz + 0.0;
        let factor_outside_link_3_xx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_xx_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_xx;
        let factor_outside_link_3_yx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_yx_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_yx;
        let factor_outside_link_3_zx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_zx_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_zx;
        let factor_outside_link_3_xy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_xy_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_xy;
        let factor_outside_link_3_yy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_yy_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_yy;
        let factor_outside_link_3_zy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_zy_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_zy;
        let factor_outside_link_3_xz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_xz_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_xz;
        let factor_outside_link_3_yz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_yz_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_yz;
        let factor_outside_link_3_zz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_2_zz_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_zz;
        let factor_outside_link_3_px = d_qdot_itself_from_three_joint_1_y
            .factor_link_2_px_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_px;
        let factor_outside_link_3_py = d_qdot_itself_from_three_joint_1_y
            .factor_link_2_py_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_py;
        let factor_outside_link_3_pz = d_qdot_itself_from_three_joint_1_y
            .factor_link_2_pz_0
            + d_qdot_itself_from_three_more_joint_3_y.factor_outside_link_2_pz;
        let three_joint_3_x_0 = factor_outside_link_3_xx * screws.connection_joint_3_wx;
        let three_joint_3_y_2 = factor_outside_link_3_yy * screws.connection_joint_3_wy;
        let three_joint_3_z_4 = factor_outside_link_3_zz * screws.connection_joint_3_wz;
        let three_joint_3_x_9 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_3_xx * reactions.reaction_joint_3_wx;
        let three_joint_3_y_11 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_3_yy * reactions.reaction_joint_3_wy;
        let three_joint_3_z_13 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_3_zz * reactions.reaction_joint_3_wz;
        let three_joint_3_x = three_joint_3_x_0
            + factor_outside_link_3_yx * screws.connection_joint_3_wy
            + factor_outside_link_3_zx * screws.connection_joint_3_wz
            + (factor_outside_link_3_py * screws.connection_joint_3_vz
                - factor_outside_link_3_pz * screws.connection_joint_3_vy)
            - (three_joint_3_x_9
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_yx
                    * reactions.reaction_joint_3_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_zx
                    * reactions.reaction_joint_3_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_3_py
                    * reactions.reaction_joint_3_vz
                    - d_qdot_itself_from_three_joint_1_y.factor_link_3_pz
                        * reactions.reaction_joint_3_vy));
        let three_joint_3_y = factor_outside_link_3_xy * screws.connection_joint_3_wx
            + three_joint_3_y_2 + factor_outside_link_3_zy * screws.connection_joint_3_wz
            + (factor_outside_link_3_pz * screws.connection_joint_3_vx
                - factor_outside_link_3_px * screws.connection_joint_3_vz)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_xy
                * reactions.reaction_joint_3_wx + three_joint_3_y_11
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_zy
                    * reactions.reaction_joint_3_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_3_pz
                    * reactions.reaction_joint_3_vx
                    - d_qdot_itself_from_three_joint_1_y.factor_link_3_px
                        * reactions.reaction_joint_3_vz));
        let three_joint_3_z = factor_outside_link_3_xz * screws.connection_joint_3_wx
            + factor_outside_link_3_yz * screws.connection_joint_3_wy + three_joint_3_z_4
            + (factor_outside_link_3_px * screws.connection_joint_3_vy
                - factor_outside_link_3_py * screws.connection_joint_3_vx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_xz
                * reactions.reaction_joint_3_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_yz
                    * reactions.reaction_joint_3_wy + three_joint_3_z_13
                + (d_qdot_itself_from_three_joint_1_y.factor_link_3_px
                    * reactions.reaction_joint_3_vy
                    - d_qdot_itself_from_three_joint_1_y.factor_link_3_py
                        * reactions.reaction_joint_3_vx));
        d_qdot[8][8] = reactions.reaction_joint_3_wx
            * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx
            + reactions.reaction_joint_3_wy * six_joint_3_my
            + reactions.reaction_joint_3_wz * six_joint_3_mz
            + reactions.reaction_joint_3_vx * six_joint_3_fx
            + reactions.reaction_joint_3_vy * six_joint_3_fy
            + reactions.reaction_joint_3_vz * six_joint_3_fz
            + three_joint_3_x * screws.connection_joint_3_wx
            + three_joint_3_y * screws.connection_joint_3_wy
            + three_joint_3_z * screws.connection_joint_3_wz + 0.0;
        let six_more_joint_3_mx = factor_outside_link_3_xz * screws.connection_joint_3_wz
            + (factor_outside_link_3_xy * screws.connection_joint_3_wy
                + three_joint_3_x_0)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_xz
                * reactions.reaction_joint_3_wz
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_xy
                    * reactions.reaction_joint_3_wy + three_joint_3_x_9))
            + (complements.complement_link_3_xx
                * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_6
                - complements.complement_link_3_xy
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_8
                - complements.complement_link_3_xz
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_10
                + (complements.complement_link_3_hy
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_12
                    - complements.complement_link_3_hz
                        * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_14));
        let six_more_joint_3_my = factor_outside_link_3_yz * screws.connection_joint_3_wz
            + (three_joint_3_y_2
                + factor_outside_link_3_yx * screws.connection_joint_3_wx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_yz
                * reactions.reaction_joint_3_wz
                + (three_joint_3_y_11
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_yx
                        * reactions.reaction_joint_3_wx))
            + (complements.complement_link_3_xy
                * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_6
                - complements.complement_link_3_yy
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_8
                - complements.complement_link_3_yz
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_10
                + (complements.complement_link_3_hz
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_my_12
                    - complements.complement_link_3_hx
                        * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_12));
        let six_more_joint_3_mz = three_joint_3_z_4
            + (factor_outside_link_3_zy * screws.connection_joint_3_wy
                + factor_outside_link_3_zx * screws.connection_joint_3_wx)
            - (three_joint_3_z_13
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_zy
                    * reactions.reaction_joint_3_wy
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_3_zx
                        * reactions.reaction_joint_3_wx))
            + (complements.complement_link_3_xz
                * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_6
                - complements.complement_link_3_yz
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_8
                - complements.complement_link_3_zz
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_10
                + (complements.complement_link_3_hx
                    * d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_14
                    - complements.complement_link_3_hy
                        * d_qdot_itself_from_three_joint_2_y.six_joint_3_my_12));
        let six_more_joint_3_fx = screws.connection_joint_3_wy * factor_outside_link_3_pz
            - screws.connection_joint_3_wz * factor_outside_link_3_py
            - (reactions.reaction_joint_3_wy
                * d_qdot_itself_from_three_joint_1_y.factor_link_3_pz
                - reactions.reaction_joint_3_wz
                    * d_qdot_itself_from_three_joint_1_y.factor_link_3_py)
            + (d_qdot_itself_from_three_joint_2_y.six_joint_3_my_12 * 7.5
                + (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_10
                    * complements.complement_link_3_hy
                    - d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_8
                        * complements.complement_link_3_hz));
        let six_more_joint_3_fy = screws.connection_joint_3_wz * factor_outside_link_3_px
            - screws.connection_joint_3_wx * factor_outside_link_3_pz
            - (reactions.reaction_joint_3_wz
                * d_qdot_itself_from_three_joint_1_y.factor_link_3_px
                - reactions.reaction_joint_3_wx
                    * d_qdot_itself_from_three_joint_1_y.factor_link_3_pz)
            + (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_14 * 7.5
                - (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_10
                    * complements.complement_link_3_hx
                    + d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_6
                        * complements.complement_link_3_hz));
        let six_more_joint_3_fz = screws.connection_joint_3_wx * factor_outside_link_3_py
            - screws.connection_joint_3_wy * factor_outside_link_3_px
            - (reactions.reaction_joint_3_wx
                * d_qdot_itself_from_three_joint_1_y.factor_link_3_py
                - reactions.reaction_joint_3_wy
                    * d_qdot_itself_from_three_joint_1_y.factor_link_3_px)
            + (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_12 * 7.5
                + (d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_6
                    * complements.complement_link_3_hy
                    + d_qdot_itself_from_three_joint_2_y.six_joint_3_mx_8
                        * complements.complement_link_3_hx));
        d_qdot[8][9] = six_more_joint_3_mx * screws.connection_joint_4_wx
            + six_more_joint_3_my * screws.connection_joint_4_wy
            + six_more_joint_3_mz * screws.connection_joint_4_wz
            + six_more_joint_3_fx * screws.connection_joint_4_vx
            + six_more_joint_3_fy * screws.connection_joint_4_vy
            + six_more_joint_3_fz * screws.connection_joint_4_vz
            + reactions.reaction_joint_3_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_4_x
            + reactions.reaction_joint_3_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_4_y
            + reactions.reaction_joint_3_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_4_z + 0.0;
        d_qdot[8][10] = six_more_joint_3_mx * screws.connection_joint_5_wx
            + six_more_joint_3_my * screws.connection_joint_5_wy
            + six_more_joint_3_mz * screws.connection_joint_5_wz
            + six_more_joint_3_fx * screws.connection_joint_5_vx
            + six_more_joint_3_fy * screws.connection_joint_5_vy
            + six_more_joint_3_fz * screws.connection_joint_5_vz
            + reactions.reaction_joint_3_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_x
            + reactions.reaction_joint_3_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_y
            + reactions.reaction_joint_3_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_z + 0.0;
        d_qdot[8][11] = six_more_joint_3_mx * screws.connection_joint_6_wx
            + six_more_joint_3_my * screws.connection_joint_6_wy
            + six_more_joint_3_mz * screws.connection_joint_6_wz
            + six_more_joint_3_fx * screws.connection_joint_6_vx
            + six_more_joint_3_fy * screws.connection_joint_6_vy
            + six_more_joint_3_fz * screws.connection_joint_6_vz
            + reactions.reaction_joint_3_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_x
            + reactions.reaction_joint_3_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_y
            + reactions.reaction_joint_3_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_z + 0.0;
        d_qdot[8][12] = six_more_joint_3_mx * screws.connection_joint_7_wx
            + six_more_joint_3_my * screws.connection_joint_7_wy
            + six_more_joint_3_mz * screws.connection_joint_7_wz
            + six_more_joint_3_fx * screws.connection_joint_7_vx
            + six_more_joint_3_fy * screws.connection_joint_7_vy
            + six_more_joint_3_fz * screws.connection_joint_7_vz
            + reactions.reaction_joint_3_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_x
            + reactions.reaction_joint_3_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_y
            + reactions.reaction_joint_3_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_z + 0.0;
        DQdotItselfFromSixJoint3My {
            factor_outside_link_3_xx,
            factor_outside_link_3_yx,
            factor_outside_link_3_zx,
            factor_outside_link_3_xy,
            factor_outside_link_3_yy,
            factor_outside_link_3_zy,
            factor_outside_link_3_xz,
            factor_outside_link_3_yz,
            factor_outside_link_3_zz,
            factor_outside_link_3_px,
            factor_outside_link_3_py,
            factor_outside_link_3_pz,
            three_joint_3_x,
            three_joint_3_y,
            three_joint_3_z,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromDQdot0_9 {
        pub(super) factor_outside_link_4_xx: f64,
        pub(super) factor_outside_link_4_yx: f64,
        pub(super) factor_outside_link_4_zx: f64,
        pub(super) factor_outside_link_4_xy: f64,
        pub(super) factor_outside_link_4_yy: f64,
        pub(super) factor_outside_link_4_zy: f64,
        pub(super) factor_outside_link_4_xz: f64,
        pub(super) factor_outside_link_4_yz: f64,
        pub(super) factor_outside_link_4_zz: f64,
        pub(super) factor_outside_link_4_px: f64,
        pub(super) factor_outside_link_4_py: f64,
        pub(super) factor_outside_link_4_pz: f64,
        pub(super) six_joint_4_mx_8: f64,
        pub(super) six_joint_4_mx_6: f64,
        pub(super) six_joint_4_mx_10: f64,
        pub(super) six_joint_4_my_12: f64,
        pub(super) six_joint_4_mx_14: f64,
        pub(super) six_joint_4_mx_12: f64,
        pub(super) three_joint_4_y_2: f64,
        pub(super) three_joint_4_z_4: f64,
        pub(super) three_joint_4_y_11: f64,
        pub(super) three_joint_4_z_13: f64,
        pub(super) six_more_joint_4_mx: f64,
        pub(super) three_joint_4_x: f64,
        pub(super) three_joint_4_y: f64,
        pub(super) three_joint_4_z: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_d_qdot_0_9(
        poses: &Poses,
        inertias: &Inertias,
        complements: &Complements,
        screws: &Screws,
        reactions: &Reactions,
        velocities: &Velocities,
        d_qdot_itself_from_factor_outside_link_1_px: &DQdotItselfFromFactorOutsideLink1Px,
        d_qdot_itself_from_factor_link_5_xz_0_5_2: &DQdotItselfFromFactorLink5Xz0_5_2,
        d_qdot_itself_from_three_joint_1_y: &DQdotItselfFromThreeJoint1Y,
        d_qdot_itself_from_three_more_joint_3_y: &DQdotItselfFromThreeMoreJoint3Y,
        d_qdot_itself_from_three_joint_2_y: &DQdotItselfFromThreeJoint2Y,
        d_qdot_itself_from_six_joint_3_my: &DQdotItselfFromSixJoint3My,
        d_qdot: &mut [[f64; 13]; 13],
    ) -> DQdotItselfFromDQdot0_9 {
        // D_q\u{307} column joint_4
        d_qdot[9][0] = 0.0;
        d_qdot[9][1] = 0.0;
        d_qdot[9][2] = 0.0;
        d_qdot[9][3] = 0.0;
        d_qdot[9][4] = 0.0;
        d_qdot[9][5] = 0.0;
        let six_joint_4_mx_8 = velocities.velocity_link_4_wy
            * poses.minus_rotation_link_3_zy
            + velocities.velocity_link_4_wz * poses.rotation_link_3_yy;
        let six_joint_4_mx_6 = velocities.velocity_link_4_wx
            * poses.minus_rotation_link_3_zy
            - velocities.velocity_link_4_wz * poses.minus_rotation_link_3_xy;
        let six_joint_4_mx_10 = velocities.velocity_link_4_wx * poses.rotation_link_3_yy
            + velocities.velocity_link_4_wy * poses.minus_rotation_link_3_xy;
        let six_joint_4_my_12 = velocities.velocity_link_4_wz
            * screws.minus_screw_joint_4_vy
            - velocities.velocity_link_4_wy * screws.minus_screw_joint_4_vz
            - (velocities.velocity_link_4_vy * poses.minus_rotation_link_3_zy
                + velocities.velocity_link_4_vz * poses.rotation_link_3_yy);
        let six_joint_4_mx_14 = velocities.velocity_link_4_wz * screws.screw_joint_4_vx
            + velocities.velocity_link_4_wx * screws.minus_screw_joint_4_vz
            + (velocities.velocity_link_4_vx * poses.minus_rotation_link_3_zy
                - velocities.velocity_link_4_vz * poses.minus_rotation_link_3_xy);
        let six_joint_4_mx_12 = velocities.velocity_link_4_vx * poses.rotation_link_3_yy
            + velocities.velocity_link_4_vy * poses.minus_rotation_link_3_xy
            - (velocities.velocity_link_4_wx * screws.minus_screw_joint_4_vy
                + velocities.velocity_link_4_wy * screws.screw_joint_4_vx);
        let six_joint_4_mx = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_xy
            * poses.rotation_link_3_yy
            - d_qdot_itself_from_three_more_joint_3_y.three_more_joint_4_x_2
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_xz
                * poses.minus_rotation_link_3_zy
            + (inertias.composite_link_4_xy * six_joint_4_mx_6
                - inertias.composite_link_4_xx * six_joint_4_mx_8
                + inertias.composite_link_4_xz * six_joint_4_mx_10
                + (inertias.composite_link_4_hy * six_joint_4_mx_12
                    - inertias.composite_link_4_hz * six_joint_4_mx_14));
        let six_joint_4_my = d_qdot_itself_from_three_more_joint_3_y
            .three_more_joint_4_y_0
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_yx
                * poses.minus_rotation_link_3_xy
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_yz
                * poses.minus_rotation_link_3_zy
            + (inertias.composite_link_4_yy * six_joint_4_mx_6
                - inertias.composite_link_4_xy * six_joint_4_mx_8
                + inertias.composite_link_4_yz * six_joint_4_mx_10
                + (inertias.composite_link_4_hz * six_joint_4_my_12
                    + inertias.minus_composite_link_4_hx * six_joint_4_mx_12));
        let six_joint_4_mz = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_zy
            * poses.rotation_link_3_yy
            - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_zx
                * poses.minus_rotation_link_3_xy
            - d_qdot_itself_from_three_more_joint_3_y.three_more_joint_4_z_4
            + (inertias.composite_link_4_yz * six_joint_4_mx_6
                - inertias.composite_link_4_xz * six_joint_4_mx_8
                + inertias.composite_link_4_zz * six_joint_4_mx_10
                - (inertias.minus_composite_link_4_hx * six_joint_4_mx_14
                    + inertias.composite_link_4_hy * six_joint_4_my_12));
        d_qdot[9][6] = reactions.reaction_joint_1_wx * six_joint_4_mx
            + reactions.reaction_joint_1_wy * six_joint_4_my
            + reactions.reaction_joint_1_wz * six_joint_4_mz
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_x
                * screws.connection_joint_4_wx
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_y
                * screws.connection_joint_4_wy
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_z
                * screws.connection_joint_4_wz + 0.0;
        let six_joint_4_fx = poses.rotation_link_3_yy
            * d_qdot_itself_from_three_joint_1_y.factor_link_4_pz
            + poses.minus_rotation_link_3_zy
                * d_qdot_itself_from_three_joint_1_y.factor_link_4_py
            + (six_joint_4_my_12 * 8.0
                + (six_joint_4_mx_6 * inertias.composite_link_4_hz
                    - six_joint_4_mx_10 * inertias.composite_link_4_hy));
        let six_joint_4_fy = poses.minus_rotation_link_3_xy
            * d_qdot_itself_from_three_joint_1_y.factor_link_4_pz
            - poses.minus_rotation_link_3_zy
                * d_qdot_itself_from_three_joint_1_y.factor_link_4_px
            + (six_joint_4_mx_14 * 8.0
                + (six_joint_4_mx_8 * inertias.composite_link_4_hz
                    - six_joint_4_mx_10 * inertias.minus_composite_link_4_hx));
        let six_joint_4_fz = six_joint_4_mx_12 * 8.0
            + (six_joint_4_mx_6 * inertias.minus_composite_link_4_hx
                - six_joint_4_mx_8 * inertias.composite_link_4_hy)
            - (poses.minus_rotation_link_3_xy
                * d_qdot_itself_from_three_joint_1_y.factor_link_4_py
                + poses.rotation_link_3_yy
                    * d_qdot_itself_from_three_joint_1_y.factor_link_4_px);
        d_qdot[9][7] = reactions.reaction_joint_2_wx * six_joint_4_mx
            + reactions.reaction_joint_2_wy * six_joint_4_my
            + reactions.reaction_joint_2_wz * six_joint_4_mz
            + reactions.reaction_joint_2_vx * six_joint_4_fx
            + reactions.reaction_joint_2_vy * six_joint_4_fy
            + reactions.reaction_joint_2_vz * six_joint_4_fz
            + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_x
                * screws.connection_joint_4_wx
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_y
                * screws.connection_joint_4_wy
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_z
                * screws.connection_joint_4_wz + 0.0;
        d_qdot[9][8] = reactions.reaction_joint_3_wx * six_joint_4_mx
            + reactions.reaction_joint_3_wy * six_joint_4_my
            + reactions.reaction_joint_3_wz * six_joint_4_mz
            + reactions.reaction_joint_3_vx * six_joint_4_fx
            + reactions.reaction_joint_3_vy * six_joint_4_fy
            + reactions.reaction_joint_3_vz * six_joint_4_fz
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_x
                * screws.connection_joint_4_wx
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_y
                * screws.connection_joint_4_wy
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_z
                * screws.connection_joint_4_wz + 0.0;
        let factor_outside_link_4_xx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_xx_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_xx;
        let factor_outside_link_4_yx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_yx_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_yx;
        let factor_outside_link_4_zx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_zx_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_zx;
        let factor_outside_link_4_xy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_xy_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_xy;
        let factor_outside_link_4_yy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_yy_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_yy;
        let factor_outside_link_4_zy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_zy_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_zy;
        let factor_outside_link_4_xz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_xz_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_xz;
        let factor_outside_link_4_yz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_yz_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_yz;
        let factor_outside_link_4_zz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_3_zz_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_zz;
        let factor_outside_link_4_px = d_qdot_itself_from_three_joint_1_y
            .factor_link_3_px_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_px;
        let factor_outside_link_4_py = d_qdot_itself_from_three_joint_1_y
            .factor_link_3_py_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_py;
        let factor_outside_link_4_pz = d_qdot_itself_from_three_joint_1_y
            .factor_link_3_pz_0
            + d_qdot_itself_from_six_joint_3_my.factor_outside_link_3_pz;
        let three_joint_4_x_0 = factor_outside_link_4_xx * screws.connection_joint_4_wx;
        let three_joint_4_y_2 = factor_outside_link_4_yy * screws.connection_joint_4_wy;
        let three_joint_4_z_4 = factor_outside_link_4_zz * screws.connection_joint_4_wz;
        let three_joint_4_x_9 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_4_xx * reactions.reaction_joint_4_wx;
        let three_joint_4_y_11 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_4_yy * reactions.reaction_joint_4_wy;
        let three_joint_4_z_13 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_4_zz * reactions.reaction_joint_4_wz;
        let three_joint_4_x = three_joint_4_x_0
            + factor_outside_link_4_yx * screws.connection_joint_4_wy
            + factor_outside_link_4_zx * screws.connection_joint_4_wz
            + (factor_outside_link_4_py * screws.connection_joint_4_vz
                - factor_outside_link_4_pz * screws.connection_joint_4_vy)
            - (three_joint_4_x_9
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_yx
                    * reactions.reaction_joint_4_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_zx
                    * reactions.reaction_joint_4_wz
                - (d_qdot_itself_from_three_joint_1_y.factor_link_4_py
                    * reactions.minus_reaction_joint_4_vz
                    + d_qdot_itself_from_three_joint_1_y.factor_link_4_pz
                        * reactions.reaction_joint_4_vy));
        let three_joint_4_y = factor_outside_link_4_xy * screws.connection_joint_4_wx
            + three_joint_4_y_2 + factor_outside_link_4_zy * screws.connection_joint_4_wz
            + (factor_outside_link_4_pz * screws.connection_joint_4_vx
                - factor_outside_link_4_px * screws.connection_joint_4_vz)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_xy
                * reactions.reaction_joint_4_wx + three_joint_4_y_11
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_zy
                    * reactions.reaction_joint_4_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_4_pz
                    * reactions.reaction_joint_4_vx
                    + d_qdot_itself_from_three_joint_1_y.factor_link_4_px
                        * reactions.minus_reaction_joint_4_vz));
        let three_joint_4_z = factor_outside_link_4_xz * screws.connection_joint_4_wx
            + factor_outside_link_4_yz * screws.connection_joint_4_wy + three_joint_4_z_4
            + (factor_outside_link_4_px * screws.connection_joint_4_vy
                - factor_outside_link_4_py * screws.connection_joint_4_vx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_xz
                * reactions.reaction_joint_4_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_yz
                    * reactions.reaction_joint_4_wy + three_joint_4_z_13
                + (d_qdot_itself_from_three_joint_1_y.factor_link_4_px
                    * reactions.reaction_joint_4_vy
                    - d_qdot_itself_from_three_joint_1_y.factor_link_4_py
                        * reactions.reaction_joint_4_vx));
        d_qdot[9][9] = reactions.reaction_joint_4_wx * six_joint_4_mx
            + reactions.reaction_joint_4_wy * six_joint_4_my
            + reactions.reaction_joint_4_wz * six_joint_4_mz
            + reactions.reaction_joint_4_vx * six_joint_4_fx
            + reactions.reaction_joint_4_vy * six_joint_4_fy
            - reactions.minus_reaction_joint_4_vz * six_joint_4_fz
            + three_joint_4_x * screws.connection_joint_4_wx
            + three_joint_4_y * screws.connection_joint_4_wy
            + three_joint_4_z * screws.connection_joint_4_wz + 0.0;
        let six_more_joint_4_mx = factor_outside_link_4_xz * screws.connection_joint_4_wz
            + (factor_outside_link_4_xy * screws.connection_joint_4_wy
                + three_joint_4_x_0)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_xz
                * reactions.reaction_joint_4_wz
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_xy
                    * reactions.reaction_joint_4_wy + three_joint_4_x_9))
            + (complements.complement_link_4_xy * six_joint_4_mx_6
                - complements.complement_link_4_xx * six_joint_4_mx_8
                + complements.complement_link_4_xz * six_joint_4_mx_10
                + (complements.complement_link_4_hy * six_joint_4_mx_12
                    - complements.complement_link_4_hz * six_joint_4_mx_14));
        DQdotItselfFromDQdot0_9 {
            factor_outside_link_4_xx,
            factor_outside_link_4_yx,
            factor_outside_link_4_zx,
            factor_outside_link_4_xy,
            factor_outside_link_4_yy,
            factor_outside_link_4_zy,
            factor_outside_link_4_xz,
            factor_outside_link_4_yz,
            factor_outside_link_4_zz,
            factor_outside_link_4_px,
            factor_outside_link_4_py,
            factor_outside_link_4_pz,
            six_joint_4_mx_8,
            six_joint_4_mx_6,
            six_joint_4_mx_10,
            six_joint_4_my_12,
            six_joint_4_mx_14,
            six_joint_4_mx_12,
            three_joint_4_y_2,
            three_joint_4_z_4,
            three_joint_4_y_11,
            three_joint_4_z_13,
            six_more_joint_4_mx,
            three_joint_4_x,
            three_joint_4_y,
            three_joint_4_z,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromSixMoreJoint4My {
        pub(super) factor_outside_link_5_xx: f64,
        pub(super) factor_outside_link_5_yx: f64,
        pub(super) factor_outside_link_5_zx: f64,
        pub(super) factor_outside_link_5_xy: f64,
        pub(super) factor_outside_link_5_yy: f64,
        pub(super) factor_outside_link_5_zy: f64,
        pub(super) factor_outside_link_5_xz: f64,
        pub(super) factor_outside_link_5_yz: f64,
        pub(super) factor_outside_link_5_zz: f64,
        pub(super) factor_outside_link_5_px: f64,
        pub(super) factor_outside_link_5_py: f64,
        pub(super) factor_outside_link_5_pz: f64,
        pub(super) six_joint_5_mx_6: f64,
        pub(super) six_joint_5_mx_8: f64,
        pub(super) six_joint_5_mx_10: f64,
        pub(super) six_joint_5_my_12: f64,
        pub(super) six_joint_5_mx_14: f64,
        pub(super) six_joint_5_mx_12: f64,
        pub(super) three_joint_5_x_0: f64,
        pub(super) three_joint_5_y_2: f64,
        pub(super) three_joint_5_z_4: f64,
        pub(super) three_joint_5_x_9: f64,
        pub(super) three_joint_5_y_11: f64,
        pub(super) three_joint_5_z_13: f64,
        pub(super) three_joint_5_x: f64,
        pub(super) three_joint_5_y: f64,
        pub(super) three_joint_5_z: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_six_more_joint_4_my(
        poses: &Poses,
        inertias: &Inertias,
        complements: &Complements,
        screws: &Screws,
        reactions: &Reactions,
        velocities: &Velocities,
        d_qdot_itself_from_factor_outside_link_1_px: &DQdotItselfFromFactorOutsideLink1Px,
        d_qdot_itself_from_factor_link_5_xz_0_5_2: &DQdotItselfFromFactorLink5Xz0_5_2,
        d_qdot_itself_from_three_joint_1_y: &DQdotItselfFromThreeJoint1Y,
        d_qdot_itself_from_three_more_joint_3_y: &DQdotItselfFromThreeMoreJoint3Y,
        d_qdot_itself_from_three_joint_2_y: &DQdotItselfFromThreeJoint2Y,
        d_qdot_itself_from_six_joint_3_my: &DQdotItselfFromSixJoint3My,
        d_qdot_itself_from_d_qdot_0_9: &DQdotItselfFromDQdot0_9,
        d_qdot: &mut [[f64; 13]; 13],
    ) -> DQdotItselfFromSixMoreJoint4My {
        let six_more_joint_4_my = d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_yz
            * screws.connection_joint_4_wz
            + (d_qdot_itself_from_d_qdot_0_9.three_joint_4_y_2
                + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_yx
                    * screws.connection_joint_4_wx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_yz
                * reactions.reaction_joint_4_wz
                + (d_qdot_itself_from_d_qdot_0_9.three_joint_4_y_11
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_yx
                        * reactions.reaction_joint_4_wx))
            + (complements.complement_link_4_yy
                * d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_6
                - complements.complement_link_4_xy
                    * d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_8
                + complements.complement_link_4_yz
                    * d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_10
                + (complements.complement_link_4_hz
                    * d_qdot_itself_from_d_qdot_0_9.six_joint_4_my_12
                    - complements.complement_link_4_hx
                        * d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_12));
        let six_more_joint_4_mz = d_qdot_itself_from_d_qdot_0_9.three_joint_4_z_4
            + (d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_zy
                * screws.connection_joint_4_wy
                + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_zx
                    * screws.connection_joint_4_wx)
            - (d_qdot_itself_from_d_qdot_0_9.three_joint_4_z_13
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_zy
                    * reactions.reaction_joint_4_wy
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_4_zx
                        * reactions.reaction_joint_4_wx))
            + (complements.complement_link_4_yz
                * d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_6
                - complements.complement_link_4_xz
                    * d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_8
                + complements.complement_link_4_zz
                    * d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_10
                + (complements.complement_link_4_hx
                    * d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_14
                    - complements.complement_link_4_hy
                        * d_qdot_itself_from_d_qdot_0_9.six_joint_4_my_12));
        let six_more_joint_4_fx = screws.connection_joint_4_wy
            * d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_pz
            - screws.connection_joint_4_wz
                * d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_py
            - (reactions.reaction_joint_4_wy
                * d_qdot_itself_from_three_joint_1_y.factor_link_4_pz
                - reactions.reaction_joint_4_wz
                    * d_qdot_itself_from_three_joint_1_y.factor_link_4_py)
            + (d_qdot_itself_from_d_qdot_0_9.six_joint_4_my_12 * 9.5
                + (d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_6
                    * complements.complement_link_4_hz
                    - d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_10
                        * complements.complement_link_4_hy));
        let six_more_joint_4_fy = screws.connection_joint_4_wz
            * d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_px
            - screws.connection_joint_4_wx
                * d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_pz
            - (reactions.reaction_joint_4_wz
                * d_qdot_itself_from_three_joint_1_y.factor_link_4_px
                - reactions.reaction_joint_4_wx
                    * d_qdot_itself_from_three_joint_1_y.factor_link_4_pz)
            + (d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_14 * 9.5
                + (d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_10
                    * complements.complement_link_4_hx
                    + d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_8
                        * complements.complement_link_4_hz));
        let six_more_joint_4_fz = screws.connection_joint_4_wx
            * d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_py
            - screws.connection_joint_4_wy
                * d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_px
            - (reactions.reaction_joint_4_wx
                * d_qdot_itself_from_three_joint_1_y.factor_link_4_py
                - reactions.reaction_joint_4_wy
                    * d_qdot_itself_from_three_joint_1_y.factor_link_4_px)
            + (d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_12 * 9.5
                - (d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_8
                    * complements.complement_link_4_hy
                    + d_qdot_itself_from_d_qdot_0_9.six_joint_4_mx_6
                        * complements.complement_link_4_hx));
        // D_q\u{307} column joint_4
        d_qdot[9][10] = d_qdot_itself_from_d_qdot_0_9.six_more_joint_4_mx
            * screws.connection_joint_5_wx
            + six_more_joint_4_my * screws.connection_joint_5_wy
            + six_more_joint_4_mz * screws.connection_joint_5_wz
            + six_more_joint_4_fx * screws.connection_joint_5_vx
            + six_more_joint_4_fy * screws.connection_joint_5_vy
            + six_more_joint_4_fz * screws.connection_joint_5_vz
            + reactions.reaction_joint_4_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_x
            + reactions.reaction_joint_4_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_y
            + reactions.reaction_joint_4_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_z + 0.0;
        d_qdot[9][11] = d_qdot_itself_from_d_qdot_0_9.six_more_joint_4_mx
            * screws.connection_joint_6_wx
            + six_more_joint_4_my * screws.connection_joint_6_wy
            + six_more_joint_4_mz * screws.connection_joint_6_wz
            + six_more_joint_4_fx * screws.connection_joint_6_vx
            + six_more_joint_4_fy * screws.connection_joint_6_vy
            + six_more_joint_4_fz * screws.connection_joint_6_vz
            + reactions.reaction_joint_4_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_x
            + reactions.reaction_joint_4_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_y
            + reactions.reaction_joint_4_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_z + 0.0;
        d_qdot[9][12] = d_qdot_itself_from_d_qdot_0_9.six_more_joint_4_mx
            * screws.connection_joint_7_wx
            + six_more_joint_4_my * screws.connection_joint_7_wy
            + six_more_joint_4_mz * screws.connection_joint_7_wz
            + six_more_joint_4_fx * screws.connection_joint_7_vx
            + six_more_joint_4_fy * screws.connection_joint_7_vy
            + six_more_joint_4_fz * screws.connection_joint_7_vz
            + reactions.reaction_joint_4_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_x
            + reactions.reaction_joint_4_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_y
            + reactions.reaction_joint_4_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_z + 0.0;
        // D_q\u{307} column joint_5
        d_qdot[10][0] = 0.0;
        d_qdot[10][1] = 0.0;
        d_qdot[10][2] = 0.0;
        d_qdot[10][3] = 0.0;
        d_qdot[10][4] = 0.0;
        d_qdot[10][5] = 0.0;
        let six_joint_5_mx_6 = velocities.velocity_link_5_wy * poses.rotation_link_5_zz
            + velocities.velocity_link_5_wz * poses.rotation_link_4_yy;
        let six_joint_5_mx_8 = velocities.velocity_link_5_wz * poses.rotation_link_4_xy
            + velocities.velocity_link_5_wx * poses.rotation_link_5_zz;
        let six_joint_5_mx_10 = velocities.velocity_link_5_wy * poses.rotation_link_4_xy
            - velocities.velocity_link_5_wx * poses.rotation_link_4_yy;
        let six_joint_5_my_12 = velocities.velocity_link_5_wy * screws.screw_joint_5_vz
            - velocities.velocity_link_5_wz * screws.screw_joint_5_vy
            + (velocities.velocity_link_5_vy * poses.rotation_link_5_zz
                + velocities.velocity_link_5_vz * poses.rotation_link_4_yy);
        let six_joint_5_mx_14 = velocities.velocity_link_5_wz * screws.screw_joint_5_vx
            - velocities.velocity_link_5_wx * screws.screw_joint_5_vz
            - (velocities.velocity_link_5_vz * poses.rotation_link_4_xy
                + velocities.velocity_link_5_vx * poses.rotation_link_5_zz);
        let six_joint_5_mx_12 = velocities.velocity_link_5_wx * screws.screw_joint_5_vy
            - velocities.velocity_link_5_wy * screws.screw_joint_5_vx
            + (velocities.velocity_link_5_vy * poses.rotation_link_4_xy
                - velocities.velocity_link_5_vx * poses.rotation_link_4_yy);
        let six_joint_5_mx = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_xz
            * poses.rotation_link_5_zz
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_xy
                * poses.rotation_link_4_yy
                + d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_x_2)
            + (inertias.composite_link_5_xx * six_joint_5_mx_6
                - inertias.composite_link_5_xy * six_joint_5_mx_8
                + inertias.composite_link_5_xz * six_joint_5_mx_10
                + (inertias.composite_link_5_hy * six_joint_5_mx_12
                    - inertias.composite_link_5_hz * six_joint_5_mx_14));
        let six_joint_5_my = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_yz
            * poses.rotation_link_5_zz
            - (d_qdot_itself_from_three_more_joint_3_y.three_more_joint_5_y_4
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_yx
                    * poses.rotation_link_4_xy)
            + (inertias.composite_link_5_xy * six_joint_5_mx_6
                - inertias.composite_link_5_yy * six_joint_5_mx_8
                + inertias.composite_link_5_yz * six_joint_5_mx_10
                + (inertias.composite_link_5_hz * six_joint_5_my_12
                    + inertias.minus_composite_link_5_hx * six_joint_5_mx_12));
        let six_joint_5_mz = d_qdot_itself_from_three_more_joint_3_y
            .three_more_joint_5_z_0
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_zy
                * poses.rotation_link_4_yy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_zx
                    * poses.rotation_link_4_xy)
            + (inertias.composite_link_5_xz * six_joint_5_mx_6
                - inertias.composite_link_5_yz * six_joint_5_mx_8
                + inertias.composite_link_5_zz * six_joint_5_mx_10
                - (inertias.minus_composite_link_5_hx * six_joint_5_mx_14
                    + inertias.composite_link_5_hy * six_joint_5_my_12));
        d_qdot[10][6] = reactions.reaction_joint_1_wx * six_joint_5_mx
            + reactions.reaction_joint_1_wy * six_joint_5_my
            + reactions.reaction_joint_1_wz * six_joint_5_mz
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_x
                * screws.connection_joint_5_wx
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_y
                * screws.connection_joint_5_wy
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_z
                * screws.connection_joint_5_wz + 0.0;
        let six_joint_5_fx = six_joint_5_my_12 * 6.0
            - (six_joint_5_mx_8 * inertias.composite_link_5_hz
                + six_joint_5_mx_10 * inertias.composite_link_5_hy)
            - (poses.rotation_link_4_yy
                * d_qdot_itself_from_three_joint_1_y.factor_link_5_pz
                + poses.rotation_link_5_zz
                    * d_qdot_itself_from_three_joint_1_y.factor_link_5_py);
        let six_joint_5_fy = poses.rotation_link_5_zz
            * d_qdot_itself_from_three_joint_1_y.factor_link_5_px
            + poses.rotation_link_4_xy
                * d_qdot_itself_from_three_joint_1_y.factor_link_5_pz
            + (six_joint_5_mx_14 * 6.0
                - (six_joint_5_mx_10 * inertias.minus_composite_link_5_hx
                    + six_joint_5_mx_6 * inertias.composite_link_5_hz));
        let six_joint_5_fz = poses.rotation_link_4_yy
            * d_qdot_itself_from_three_joint_1_y.factor_link_5_px
            - poses.rotation_link_4_xy
                * d_qdot_itself_from_three_joint_1_y.factor_link_5_py
            + (six_joint_5_mx_12 * 6.0
                + (six_joint_5_mx_6 * inertias.composite_link_5_hy
                    - six_joint_5_mx_8 * inertias.minus_composite_link_5_hx));
        d_qdot[10][7] = reactions.reaction_joint_2_wx * six_joint_5_mx
            + reactions.reaction_joint_2_wy * six_joint_5_my
            + reactions.reaction_joint_2_wz * six_joint_5_mz
            + reactions.reaction_joint_2_vx * six_joint_5_fx
            + reactions.reaction_joint_2_vy * six_joint_5_fy
            + reactions.reaction_joint_2_vz * six_joint_5_fz
            + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_x
                * screws.connection_joint_5_wx
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_y
                * screws.connection_joint_5_wy
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_z
                * screws.connection_joint_5_wz + 0.0;
        d_qdot[10][8] = reactions.reaction_joint_3_wx * six_joint_5_mx
            + reactions.reaction_joint_3_wy * six_joint_5_my
            + reactions.reaction_joint_3_wz * six_joint_5_mz
            + reactions.reaction_joint_3_vx * six_joint_5_fx
            + reactions.reaction_joint_3_vy * six_joint_5_fy
            + reactions.reaction_joint_3_vz * six_joint_5_fz
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_x
                * screws.connection_joint_5_wx
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_y
                * screws.connection_joint_5_wy
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_z
                * screws.connection_joint_5_wz + 0.0;
        d_qdot[10][9] = reactions.reaction_joint_4_wx * six_joint_5_mx
            + reactions.reaction_joint_4_wy * six_joint_5_my
            + reactions.reaction_joint_4_wz * six_joint_5_mz
            + reactions.reaction_joint_4_vx * six_joint_5_fx
            + reactions.reaction_joint_4_vy * six_joint_5_fy
            - reactions.minus_reaction_joint_4_vz * six_joint_5_fz
            + d_qdot_itself_from_d_qdot_0_9.three_joint_4_x
                * screws.connection_joint_5_wx
            + d_qdot_itself_from_d_qdot_0_9.three_joint_4_y
                * screws.connection_joint_5_wy
            + d_qdot_itself_from_d_qdot_0_9.three_joint_4_z
                * screws.connection_joint_5_wz + 0.0;
        let factor_outside_link_5_xx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_xx_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_xx;
        let factor_outside_link_5_yx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_yx_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_yx;
        let factor_outside_link_5_zx = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_zx_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_zx;
        let factor_outside_link_5_xy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_xy_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_xy;
        let factor_outside_link_5_yy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_yy_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_yy;
        let factor_outside_link_5_zy = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_zy_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_zy;
        let factor_outside_link_5_xz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_xz_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_xz;
        let factor_outside_link_5_yz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_yz_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_yz;
        let factor_outside_link_5_zz = d_qdot_itself_from_factor_outside_link_1_px
            .factor_link_4_zz_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_zz;
        let factor_outside_link_5_px = d_qdot_itself_from_three_joint_1_y
            .factor_link_4_px_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_px;
        let factor_outside_link_5_py = d_qdot_itself_from_three_joint_1_y
            .factor_link_4_py_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_py;
        let factor_outside_link_5_pz = d_qdot_itself_from_three_joint_1_y
            .factor_link_4_pz_0 + d_qdot_itself_from_d_qdot_0_9.factor_outside_link_4_pz;
        let three_joint_5_x_0 = factor_outside_link_5_xx * screws.connection_joint_5_wx;
        let three_joint_5_y_2 = factor_outside_link_5_yy * screws.connection_joint_5_wy;
        let three_joint_5_z_4 = factor_outside_link_5_zz * screws.connection_joint_5_wz;
        let three_joint_5_x_9 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_xx * reactions.reaction_joint_5_wx;
        let three_joint_5_y_11 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_yy * reactions.reaction_joint_5_wy;
        let three_joint_5_z_13 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_zz * reactions.reaction_joint_5_wz;
        let three_joint_5_x = three_joint_5_x_0
            + factor_outside_link_5_yx * screws.connection_joint_5_wy
            + factor_outside_link_5_zx * screws.connection_joint_5_wz
            + (factor_outside_link_5_py * screws.connection_joint_5_vz
                - factor_outside_link_5_pz * screws.connection_joint_5_vy)
            - (three_joint_5_x_9
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_yx
                    * reactions.reaction_joint_5_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_zx
                    * reactions.reaction_joint_5_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_5_py
                    * reactions.reaction_joint_5_vz
                    - d_qdot_itself_from_three_joint_1_y.factor_link_5_pz
                        * reactions.reaction_joint_5_vy));
        let three_joint_5_y = factor_outside_link_5_xy * screws.connection_joint_5_wx
            + three_joint_5_y_2 + factor_outside_link_5_zy * screws.connection_joint_5_wz
            + (factor_outside_link_5_pz * screws.connection_joint_5_vx
                - factor_outside_link_5_px * screws.connection_joint_5_vz)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_xy
                * reactions.reaction_joint_5_wx + three_joint_5_y_11
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_zy
                    * reactions.reaction_joint_5_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_5_pz
                    * reactions.reaction_joint_5_vx
                    - d_qdot_itself_from_three_joint_1_y.factor_link_5_px
                        * reactions.reaction_joint_5_vz));
        let three_joint_5_z = factor_outside_link_5_xz * screws.connection_joint_5_wx
            + factor_outside_link_5_yz * screws.connection_joint_5_wy + three_joint_5_z_4
            + (factor_outside_link_5_px * screws.connection_joint_5_vy
                - factor_outside_link_5_py * screws.connection_joint_5_vx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_xz
                * reactions.reaction_joint_5_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_yz
                    * reactions.reaction_joint_5_wy + three_joint_5_z_13
                + (d_qdot_itself_from_three_joint_1_y.factor_link_5_px
                    * reactions.reaction_joint_5_vy
                    - d_qdot_itself_from_three_joint_1_y.factor_link_5_py
                        * reactions.reaction_joint_5_vx));
        d_qdot[10][10] = reactions.reaction_joint_5_wx * six_joint_5_mx
            + reactions.reaction_joint_5_wy * six_joint_5_my
            + reactions.reaction_joint_5_wz * six_joint_5_mz
            + reactions.reaction_joint_5_vx * six_joint_5_fx
            + reactions.reaction_joint_5_vy * six_joint_5_fy
            + reactions.reaction_joint_5_vz * six_joint_5_fz
            + three_joint_5_x * screws.connection_joint_5_wx
            + three_joint_5_y * screws.connection_joint_5_wy
            + three_joint_5_z * screws.connection_joint_5_wz + 0.0;
        DQdotItselfFromSixMoreJoint4My {
            factor_outside_link_5_xx,
            factor_outside_link_5_yx,
            factor_outside_link_5_zx,
            factor_outside_link_5_xy,
            factor_outside_link_5_yy,
            factor_outside_link_5_zy,
            factor_outside_link_5_xz,
            factor_outside_link_5_yz,
            factor_outside_link_5_zz,
            factor_outside_link_5_px,
            factor_outside_link_5_py,
            factor_outside_link_5_pz,
            six_joint_5_mx_6,
            six_joint_5_mx_8,
            six_joint_5_mx_10,
            six_joint_5_my_12,
            six_joint_5_mx_14,
            six_joint_5_mx_12,
            three_joint_5_x_0,
            three_joint_5_y_2,
            three_joint_5_z_4,
            three_joint_5_x_9,
            three_joint_5_y_11,
            three_joint_5_z_13,
            three_joint_5_x,
            three_joint_5_y,
            three_joint_5_z,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromSixMoreJoint5Mx {
        pub(super) six_joint_6_mx_6: f64,
        pub(super) six_joint_6_mx_8: f64,
        pub(super) six_joint_6_mx_10: f64,
        pub(super) six_joint_6_my_12: f64,
        pub(super) six_joint_6_mx_14: f64,
        pub(super) six_joint_6_mx_12: f64,
        pub(super) six_joint_6_mx: f64,
        pub(super) six_joint_6_my: f64,
        pub(super) six_joint_6_mz: f64,
        pub(super) six_joint_6_fx: f64,
        pub(super) six_joint_6_fy: f64,
        pub(super) six_joint_6_fz: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_six_more_joint_5_mx(
        poses: &Poses,
        inertias: &Inertias,
        complements: &Complements,
        screws: &Screws,
        reactions: &Reactions,
        velocities: &Velocities,
        d_qdot_itself_from_factor_link_5_xz_0_5_2: &DQdotItselfFromFactorLink5Xz0_5_2,
        d_qdot_itself_from_three_joint_1_y: &DQdotItselfFromThreeJoint1Y,
        d_qdot_itself_from_three_more_joint_3_y: &DQdotItselfFromThreeMoreJoint3Y,
        d_qdot_itself_from_three_joint_2_y: &DQdotItselfFromThreeJoint2Y,
        d_qdot_itself_from_six_joint_3_my: &DQdotItselfFromSixJoint3My,
        d_qdot_itself_from_d_qdot_0_9: &DQdotItselfFromDQdot0_9,
        d_qdot_itself_from_six_more_joint_4_my: &DQdotItselfFromSixMoreJoint4My,
        d_qdot: &mut [[f64; 13]; 13],
    ) -> DQdotItselfFromSixMoreJoint5Mx {
        let six_more_joint_5_mx = d_qdot_itself_from_six_more_joint_4_my
            .factor_outside_link_5_xz * screws.connection_joint_5_wz
            + (d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_xy
                * screws.connection_joint_5_wy
                + d_qdot_itself_from_six_more_joint_4_my.three_joint_5_x_0)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_xz
                * reactions.reaction_joint_5_wz
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_xy
                    * reactions.reaction_joint_5_wy
                    + d_qdot_itself_from_six_more_joint_4_my.three_joint_5_x_9))
            + (complements.complement_link_5_xx
                * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_6
                - complements.complement_link_5_xy
                    * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_8
                + complements.complement_link_5_xz
                    * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_10
                + (complements.complement_link_5_hy
                    * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_12
                    - complements.complement_link_5_hz
                        * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_14));
        let six_more_joint_5_my = d_qdot_itself_from_six_more_joint_4_my
            .factor_outside_link_5_yz * screws.connection_joint_5_wz
            + (d_qdot_itself_from_six_more_joint_4_my.three_joint_5_y_2
                + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_yx
                    * screws.connection_joint_5_wx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_yz
                * reactions.reaction_joint_5_wz
                + (d_qdot_itself_from_six_more_joint_4_my.three_joint_5_y_11
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_yx
                        * reactions.reaction_joint_5_wx))
            + (complements.complement_link_5_xy
                * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_6
                - complements.complement_link_5_yy
                    * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_8
                + complements.complement_link_5_yz
                    * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_10
                + (complements.complement_link_5_hz
                    * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_my_12
                    - complements.complement_link_5_hx
                        * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_12));
        let six_more_joint_5_mz = d_qdot_itself_from_six_more_joint_4_my
            .three_joint_5_z_4
            + (d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_zy
                * screws.connection_joint_5_wy
                + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_zx
                    * screws.connection_joint_5_wx)
            - (d_qdot_itself_from_six_more_joint_4_my.three_joint_5_z_13
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_zy
                    * reactions.reaction_joint_5_wy
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_5_zx
                        * reactions.reaction_joint_5_wx))
            + (complements.complement_link_5_xz
                * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_6
                - complements.complement_link_5_yz
                    * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_8
                + complements.complement_link_5_zz
                    * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_10
                + (complements.complement_link_5_hx
                    * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_14
                    - complements.complement_link_5_hy
                        * d_qdot_itself_from_six_more_joint_4_my.six_joint_5_my_12));
        let six_more_joint_5_fx = screws.connection_joint_5_wy
            * d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_pz
            - screws.connection_joint_5_wz
                * d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_py
            - (reactions.reaction_joint_5_wy
                * d_qdot_itself_from_three_joint_1_y.factor_link_5_pz
                - reactions.reaction_joint_5_wz
                    * d_qdot_itself_from_three_joint_1_y.factor_link_5_py)
            + (d_qdot_itself_from_six_more_joint_4_my.six_joint_5_my_12 * 11.5
                - (d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_8
                    * complements.complement_link_5_hz
                    + d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_10
                        * complements.complement_link_5_hy));
        let six_more_joint_5_fy = screws.connection_joint_5_wz
            * d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_px
            - screws.connection_joint_5_wx
                * d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_pz
            - (reactions.reaction_joint_5_wz
                * d_qdot_itself_from_three_joint_1_y.factor_link_5_px
                - reactions.reaction_joint_5_wx
                    * d_qdot_itself_from_three_joint_1_y.factor_link_5_pz)
            + (d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_14 * 11.5
                + (d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_10
                    * complements.complement_link_5_hx
                    - d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_6
                        * complements.complement_link_5_hz));
        let six_more_joint_5_fz = screws.connection_joint_5_wx
            * d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_py
            - screws.connection_joint_5_wy
                * d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_px
            - (reactions.reaction_joint_5_wx
                * d_qdot_itself_from_three_joint_1_y.factor_link_5_py
                - reactions.reaction_joint_5_wy
                    * d_qdot_itself_from_three_joint_1_y.factor_link_5_px)
            + (d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_12 * 11.5
                + (d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_6
                    * complements.complement_link_5_hy
                    + d_qdot_itself_from_six_more_joint_4_my.six_joint_5_mx_8
                        * complements.complement_link_5_hx));
        // D_q\u{307} column joint_5
        d_qdot[10][11] = six_more_joint_5_mx * screws.connection_joint_6_wx
            + six_more_joint_5_my * screws.connection_joint_6_wy
            + six_more_joint_5_mz * screws.connection_joint_6_wz
            + six_more_joint_5_fx * screws.connection_joint_6_vx
            + six_more_joint_5_fy * screws.connection_joint_6_vy
            + six_more_joint_5_fz * screws.connection_joint_6_vz
            + reactions.reaction_joint_5_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_x
            + reactions.reaction_joint_5_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_y
            + reactions.reaction_joint_5_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_z + 0.0;
        d_qdot[10][12] = six_more_joint_5_mx * screws.connection_joint_7_wx
            + six_more_joint_5_my * screws.connection_joint_7_wy
            + six_more_joint_5_mz * screws.connection_joint_7_wz
            + six_more_joint_5_fx * screws.connection_joint_7_vx
            + six_more_joint_5_fy * screws.connection_joint_7_vy
            + six_more_joint_5_fz * screws.connection_joint_7_vz
            + reactions.reaction_joint_5_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_x
            + reactions.reaction_joint_5_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_y
            + reactions.reaction_joint_5_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_z + 0.0;
        // D_q\u{307} column joint_6
        d_qdot[11][0] = 0.0;
        d_qdot[11][1] = 0.0;
        d_qdot[11][2] = 0.0;
        d_qdot[11][3] = 0.0;
        d_qdot[11][4] = 0.0;
        d_qdot[11][5] = 0.0;
        let six_joint_6_mx_6 = velocities.velocity_link_6_wy * poses.rotation_link_6_zz
            + velocities.velocity_link_6_wz * poses.rotation_link_5_yy;
        let six_joint_6_mx_8 = velocities.velocity_link_6_wz * poses.rotation_link_6_xz
            - velocities.velocity_link_6_wx * poses.rotation_link_6_zz;
        let six_joint_6_mx_10 = velocities.velocity_link_6_wx * poses.rotation_link_5_yy
            + velocities.velocity_link_6_wy * poses.rotation_link_6_xz;
        let six_joint_6_my_12 = velocities.velocity_link_6_wy * screws.screw_joint_6_vz
            - velocities.velocity_link_6_wz * screws.screw_joint_6_vy
            + (velocities.velocity_link_6_vy * poses.rotation_link_6_zz
                + velocities.velocity_link_6_vz * poses.rotation_link_5_yy);
        let six_joint_6_mx_14 = velocities.velocity_link_6_wz * screws.screw_joint_6_vx
            - velocities.velocity_link_6_wx * screws.screw_joint_6_vz
            + (velocities.velocity_link_6_vz * poses.rotation_link_6_xz
                - velocities.velocity_link_6_vx * poses.rotation_link_6_zz);
        let six_joint_6_mx_12 = velocities.velocity_link_6_wx * screws.screw_joint_6_vy
            - velocities.velocity_link_6_wy * screws.screw_joint_6_vx
            - (velocities.velocity_link_6_vx * poses.rotation_link_5_yy
                + velocities.velocity_link_6_vy * poses.rotation_link_6_xz);
        let six_joint_6_mx = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_xz
            * poses.rotation_link_6_zz
            + (d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_x_0
                - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_xy
                    * poses.rotation_link_5_yy)
            + (inertias.composite_link_6_xx * six_joint_6_mx_6
                - inertias.minus_composite_link_6_xy * six_joint_6_mx_8
                - inertias.composite_link_6_xz * six_joint_6_mx_10
                - (inertias.minus_composite_link_6_hy * six_joint_6_mx_12
                    + inertias.composite_link_6_hz * six_joint_6_mx_14));
        let six_joint_6_my = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_yz
            * poses.rotation_link_6_zz
            + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_yx
                * poses.rotation_link_6_xz
                - d_qdot_itself_from_three_more_joint_3_y.three_more_joint_6_y_2)
            + (inertias.composite_link_6_yy * six_joint_6_mx_8
                - inertias.minus_composite_link_6_xy * six_joint_6_mx_6
                - inertias.composite_link_6_yz * six_joint_6_mx_10
                + (inertias.composite_link_6_hz * six_joint_6_my_12
                    + inertias.minus_composite_link_6_hx * six_joint_6_mx_12));
        let six_joint_6_mz = d_qdot_itself_from_three_more_joint_3_y
            .three_more_joint_6_z_4
            + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_zx
                * poses.rotation_link_6_xz
                - d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_zy
                    * poses.rotation_link_5_yy)
            + (inertias.composite_link_6_xz * six_joint_6_mx_6
                + inertias.composite_link_6_yz * six_joint_6_mx_8
                - inertias.composite_link_6_zz * six_joint_6_mx_10
                + (inertias.minus_composite_link_6_hy * six_joint_6_my_12
                    - inertias.minus_composite_link_6_hx * six_joint_6_mx_14));
        d_qdot[11][6] = reactions.reaction_joint_1_wx * six_joint_6_mx
            + reactions.reaction_joint_1_wy * six_joint_6_my
            + reactions.reaction_joint_1_wz * six_joint_6_mz
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_x
                * screws.connection_joint_6_wx
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_y
                * screws.connection_joint_6_wy
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_z
                * screws.connection_joint_6_wz + 0.0;
        let six_joint_6_fx = six_joint_6_my_12 * 4.0
            + (six_joint_6_mx_8 * inertias.composite_link_6_hz
                - six_joint_6_mx_10 * inertias.minus_composite_link_6_hy)
            - (poses.rotation_link_5_yy
                * d_qdot_itself_from_three_joint_1_y.factor_link_6_pz
                + poses.rotation_link_6_zz
                    * d_qdot_itself_from_three_joint_1_y.factor_link_6_py);
        let six_joint_6_fy = poses.rotation_link_6_zz
            * d_qdot_itself_from_three_joint_1_y.factor_link_6_px
            - poses.rotation_link_6_xz
                * d_qdot_itself_from_three_joint_1_y.factor_link_6_pz
            + (six_joint_6_mx_14 * 4.0
                + (six_joint_6_mx_10 * inertias.minus_composite_link_6_hx
                    - six_joint_6_mx_6 * inertias.composite_link_6_hz));
        let six_joint_6_fz = poses.rotation_link_6_xz
            * d_qdot_itself_from_three_joint_1_y.factor_link_6_py
            + poses.rotation_link_5_yy
                * d_qdot_itself_from_three_joint_1_y.factor_link_6_px
            + (six_joint_6_mx_12 * 4.0
                + (six_joint_6_mx_8 * inertias.minus_composite_link_6_hx
                    - six_joint_6_mx_6 * inertias.minus_composite_link_6_hy));
        d_qdot[11][7] = reactions.reaction_joint_2_wx * six_joint_6_mx
            + reactions.reaction_joint_2_wy * six_joint_6_my
            + reactions.reaction_joint_2_wz * six_joint_6_mz
            + reactions.reaction_joint_2_vx * six_joint_6_fx
            + reactions.reaction_joint_2_vy * six_joint_6_fy
            + reactions.reaction_joint_2_vz * six_joint_6_fz
            + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_x
                * screws.connection_joint_6_wx
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_y
                * screws.connection_joint_6_wy
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_z
                * screws.connection_joint_6_wz + 0.0;
        d_qdot[11][8] = reactions.reaction_joint_3_wx * six_joint_6_mx
            + reactions.reaction_joint_3_wy * six_joint_6_my
            + reactions.reaction_joint_3_wz * six_joint_6_mz
            + reactions.reaction_joint_3_vx * six_joint_6_fx
            + reactions.reaction_joint_3_vy * six_joint_6_fy
            + reactions.reaction_joint_3_vz * six_joint_6_fz
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_x
                * screws.connection_joint_6_wx
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_y
                * screws.connection_joint_6_wy
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_z
                * screws.connection_joint_6_wz + 0.0;
        d_qdot[11][9] = reactions.reaction_joint_4_wx * six_joint_6_mx
            + reactions.reaction_joint_4_wy * six_joint_6_my
            + reactions.reaction_joint_4_wz * six_joint_6_mz
            + reactions.reaction_joint_4_vx * six_joint_6_fx
            + reactions.reaction_joint_4_vy * six_joint_6_fy
            - reactions.minus_reaction_joint_4_vz * six_joint_6_fz
            + d_qdot_itself_from_d_qdot_0_9.three_joint_4_x
                * screws.connection_joint_6_wx
            + d_qdot_itself_from_d_qdot_0_9.three_joint_4_y
                * screws.connection_joint_6_wy
            + d_qdot_itself_from_d_qdot_0_9.three_joint_4_z
                * screws.connection_joint_6_wz + 0.0;
        DQdotItselfFromSixMoreJoint5Mx {
            six_joint_6_mx_6,
            six_joint_6_mx_8,
            six_joint_6_mx_10,
            six_joint_6_my_12,
            six_joint_6_mx_14,
            six_joint_6_mx_12,
            six_joint_6_mx,
            six_joint_6_my,
            six_joint_6_mz,
            six_joint_6_fx,
            six_joint_6_fy,
            six_joint_6_fz,
        }
    }
    /// What only `d_qdot` computes. Continued.
    pub(super) struct DQdotItselfFromDQdot10_11 {
        pub(super) factor_outside_link_6_xx: f64,
        pub(super) factor_outside_link_6_yx: f64,
        pub(super) factor_outside_link_6_zx: f64,
        pub(super) factor_outside_link_6_xy: f64,
        pub(super) factor_outside_link_6_yy: f64,
        pub(super) factor_outside_link_6_zy: f64,
        pub(super) factor_outside_link_6_xz: f64,
        pub(super) factor_outside_link_6_yz: f64,
        pub(super) factor_outside_link_6_zz: f64,
        pub(super) factor_outside_link_6_px: f64,
        pub(super) factor_outside_link_6_py: f64,
        pub(super) factor_outside_link_6_pz: f64,
        pub(super) three_joint_6_x: f64,
        pub(super) three_joint_6_y: f64,
        pub(super) three_joint_6_z: f64,
        pub(super) six_joint_7_mx_6: f64,
        pub(super) six_joint_7_mx_8: f64,
        pub(super) six_joint_7_mx_10: f64,
        pub(super) six_joint_7_my_12: f64,
        pub(super) six_joint_7_mx_14: f64,
        pub(super) six_joint_7_mx_12: f64,
        pub(super) six_joint_7_mx: f64,
        pub(super) six_joint_7_my: f64,
        pub(super) six_joint_7_mz: f64,
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_d_qdot_10_11(
        poses: &Poses,
        inertias: &Inertias,
        complements: &Complements,
        screws: &Screws,
        reactions: &Reactions,
        velocities: &Velocities,
        d_qdot_itself_from_factor_link_5_xz_0_5_2: &DQdotItselfFromFactorLink5Xz0_5_2,
        d_qdot_itself_from_three_joint_1_y: &DQdotItselfFromThreeJoint1Y,
        d_qdot_itself_from_three_more_joint_3_y: &DQdotItselfFromThreeMoreJoint3Y,
        d_qdot_itself_from_six_more_joint_4_my: &DQdotItselfFromSixMoreJoint4My,
        d_qdot_itself_from_six_more_joint_5_mx: &DQdotItselfFromSixMoreJoint5Mx,
        d_qdot: &mut [[f64; 13]; 13],
    ) -> DQdotItselfFromDQdot10_11 {
        // D_q\u{307} column joint_6
        d_qdot[11][10] = reactions.reaction_joint_5_wx
            * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx
            + reactions.reaction_joint_5_wy
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_my
            + reactions.reaction_joint_5_wz
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mz
            + reactions.reaction_joint_5_vx
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_fx
            + reactions.reaction_joint_5_vy
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_fy
            + reactions.reaction_joint_5_vz
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_fz
            + d_qdot_itself_from_six_more_joint_4_my.three_joint_5_x
                * screws.connection_joint_6_wx
            + d_qdot_itself_from_six_more_joint_4_my.three_joint_5_y
                * screws.connection_joint_6_wy
            + d_qdot_itself_from_six_more_joint_4_my.three_joint_5_z
                * screws.connection_joint_6_wz + 0.0;
        let factor_outside_link_6_xx = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_xx_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_xx;
        let factor_outside_link_6_yx = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_yx_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_yx;
        let factor_outside_link_6_zx = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_zx_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_zx;
        let factor_outside_link_6_xy = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_xy_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_xy;
        let factor_outside_link_6_yy = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_yy_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_yy;
        let factor_outside_link_6_zy = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_zy_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_zy;
        let factor_outside_link_6_xz = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_xz_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_xz;
        let factor_outside_link_6_yz = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_yz_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_yz;
        let factor_outside_link_6_zz = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_5_zz_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_zz;
        let factor_outside_link_6_px = d_qdot_itself_from_three_joint_1_y
            .factor_link_5_px_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_px;
        let factor_outside_link_6_py = d_qdot_itself_from_three_joint_1_y
            .factor_link_5_py_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_py;
        let factor_outside_link_6_pz = d_qdot_itself_from_three_joint_1_y
            .factor_link_5_pz_0
            + d_qdot_itself_from_six_more_joint_4_my.factor_outside_link_5_pz;
        let three_joint_6_x_0 = factor_outside_link_6_xx * screws.connection_joint_6_wx;
        let three_joint_6_y_2 = factor_outside_link_6_yy * screws.connection_joint_6_wy;
        let three_joint_6_z_4 = factor_outside_link_6_zz * screws.connection_joint_6_wz;
        let three_joint_6_x_9 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_xx * reactions.reaction_joint_6_wx;
        let three_joint_6_y_11 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_yy * reactions.reaction_joint_6_wy;
        let three_joint_6_z_13 = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_zz * reactions.reaction_joint_6_wz;
        let three_joint_6_x = three_joint_6_x_0
            + factor_outside_link_6_yx * screws.connection_joint_6_wy
            + factor_outside_link_6_zx * screws.connection_joint_6_wz
            + (factor_outside_link_6_py * screws.connection_joint_6_vz
                - factor_outside_link_6_pz * screws.connection_joint_6_vy)
            - (three_joint_6_x_9
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_yx
                    * reactions.reaction_joint_6_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_zx
                    * reactions.reaction_joint_6_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_6_py
                    * reactions.reaction_joint_6_vz
                    - d_qdot_itself_from_three_joint_1_y.factor_link_6_pz
                        * reactions.reaction_joint_6_vy));
        let three_joint_6_y = factor_outside_link_6_xy * screws.connection_joint_6_wx
            + three_joint_6_y_2 + factor_outside_link_6_zy * screws.connection_joint_6_wz
            + (factor_outside_link_6_pz * screws.connection_joint_6_vx
                - factor_outside_link_6_px * screws.connection_joint_6_vz)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_xy
                * reactions.reaction_joint_6_wx + three_joint_6_y_11
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_zy
                    * reactions.reaction_joint_6_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_6_pz
                    * reactions.reaction_joint_6_vx
                    - d_qdot_itself_from_three_joint_1_y.factor_link_6_px
                        * reactions.reaction_joint_6_vz));
        let three_joint_6_z = factor_outside_link_6_xz * screws.connection_joint_6_wx
            + factor_outside_link_6_yz * screws.connection_joint_6_wy + three_joint_6_z_4
            + (factor_outside_link_6_px * screws.connection_joint_6_vy
                - factor_outside_link_6_py * screws.connection_joint_6_vx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_xz
                * reactions.reaction_joint_6_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_yz
                    * reactions.reaction_joint_6_wy + three_joint_6_z_13
                + (d_qdot_itself_from_three_joint_1_y.factor_link_6_px
                    * reactions.reaction_joint_6_vy
                    - d_qdot_itself_from_three_joint_1_y.factor_link_6_py
                        * reactions.reaction_joint_6_vx));
        d_qdot[11][11] = reactions.reaction_joint_6_wx
            * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx
            + reactions.reaction_joint_6_wy
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_my
            + reactions.reaction_joint_6_wz
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mz
            + reactions.reaction_joint_6_vx
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_fx
            + reactions.reaction_joint_6_vy
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_fy
            + reactions.reaction_joint_6_vz
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_fz
            + three_joint_6_x * screws.connection_joint_6_wx
            + three_joint_6_y * screws.connection_joint_6_wy
            + three_joint_6_z * screws.connection_joint_6_wz + 0.0;
        let six_more_joint_6_mx = factor_outside_link_6_xz * screws.connection_joint_6_wz
            + (factor_outside_link_6_xy * screws.connection_joint_6_wy
                + three_joint_6_x_0)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_xz
                * reactions.reaction_joint_6_wz
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_xy
                    * reactions.reaction_joint_6_wy + three_joint_6_x_9))
            + (complements.complement_link_6_xx
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_6
                + complements.complement_link_6_xy
                    * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_8
                - complements.complement_link_6_xz
                    * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_10
                + (complements.complement_link_6_hy
                    * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_12
                    - complements.complement_link_6_hz
                        * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_14));
        let six_more_joint_6_my = factor_outside_link_6_yz * screws.connection_joint_6_wz
            + (three_joint_6_y_2
                + factor_outside_link_6_yx * screws.connection_joint_6_wx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_yz
                * reactions.reaction_joint_6_wz
                + (three_joint_6_y_11
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_yx
                        * reactions.reaction_joint_6_wx))
            + (complements.complement_link_6_xy
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_6
                + complements.complement_link_6_yy
                    * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_8
                - complements.complement_link_6_yz
                    * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_10
                + (complements.complement_link_6_hz
                    * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_my_12
                    - complements.complement_link_6_hx
                        * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_12));
        let six_more_joint_6_mz = three_joint_6_z_4
            + (factor_outside_link_6_zy * screws.connection_joint_6_wy
                + factor_outside_link_6_zx * screws.connection_joint_6_wx)
            - (three_joint_6_z_13
                + (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_zy
                    * reactions.reaction_joint_6_wy
                    + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_6_zx
                        * reactions.reaction_joint_6_wx))
            + (complements.complement_link_6_xz
                * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_6
                + complements.complement_link_6_yz
                    * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_8
                - complements.complement_link_6_zz
                    * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_10
                + (complements.complement_link_6_hx
                    * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_14
                    - complements.complement_link_6_hy
                        * d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_my_12));
        let six_more_joint_6_fx = screws.connection_joint_6_wy * factor_outside_link_6_pz
            - screws.connection_joint_6_wz * factor_outside_link_6_py
            - (reactions.reaction_joint_6_wy
                * d_qdot_itself_from_three_joint_1_y.factor_link_6_pz
                - reactions.reaction_joint_6_wz
                    * d_qdot_itself_from_three_joint_1_y.factor_link_6_py)
            + (d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_my_12 * 13.5
                + (d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_8
                    * complements.complement_link_6_hz
                    + d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_10
                        * complements.complement_link_6_hy));
        let six_more_joint_6_fy = screws.connection_joint_6_wz * factor_outside_link_6_px
            - screws.connection_joint_6_wx * factor_outside_link_6_pz
            - (reactions.reaction_joint_6_wz
                * d_qdot_itself_from_three_joint_1_y.factor_link_6_px
                - reactions.reaction_joint_6_wx
                    * d_qdot_itself_from_three_joint_1_y.factor_link_6_pz)
            + (d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_14 * 13.5
                - (d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_10
                    * complements.complement_link_6_hx
                    + d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_6
                        * complements.complement_link_6_hz));
        let six_more_joint_6_fz = screws.connection_joint_6_wx * factor_outside_link_6_py
            - screws.connection_joint_6_wy * factor_outside_link_6_px
            - (reactions.reaction_joint_6_wx
                * d_qdot_itself_from_three_joint_1_y.factor_link_6_py
                - reactions.reaction_joint_6_wy
                    * d_qdot_itself_from_three_joint_1_y.factor_link_6_px)
            + (d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_12 * 13.5
                + (d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_6
                    * complements.complement_link_6_hy
                    - d_qdot_itself_from_six_more_joint_5_mx.six_joint_6_mx_8
                        * complements.complement_link_6_hx));
        d_qdot[11][12] = six_more_joint_6_mx * screws.connection_joint_7_wx
            + six_more_joint_6_my * screws.connection_joint_7_wy
            + six_more_joint_6_mz * screws.connection_joint_7_wz
            + six_more_joint_6_fx * screws.connection_joint_7_vx
            + six_more_joint_6_fy * screws.connection_joint_7_vy
            + six_more_joint_6_fz * screws.connection_joint_7_vz
            + reactions.reaction_joint_6_wx
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_x
            + reactions.reaction_joint_6_wy
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_y
            + reactions.reaction_joint_6_wz
                * d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_z + 0.0;
        // D_q\u{307} column joint_7
        d_qdot[12][0] = 0.0;
        d_qdot[12][1] = 0.0;
        d_qdot[12][2] = 0.0;
        d_qdot[12][3] = 0.0;
        d_qdot[12][4] = 0.0;
        d_qdot[12][5] = 0.0;
        let six_joint_7_mx_6 = velocities.velocity_link_7_wy * poses.rotation_link_6_zy
            + velocities.velocity_link_7_wz * poses.minus_rotation_link_6_yy;
        let six_joint_7_mx_8 = velocities.velocity_link_7_wz
            * poses.minus_rotation_link_6_xy
            + velocities.velocity_link_7_wx * poses.rotation_link_6_zy;
        let six_joint_7_mx_10 = velocities.velocity_link_7_wy
            * poses.minus_rotation_link_6_xy
            - velocities.velocity_link_7_wx * poses.minus_rotation_link_6_yy;
        let six_joint_7_my_12 = velocities.velocity_link_7_wy * screws.screw_joint_7_vz
            - velocities.velocity_link_7_wz * screws.screw_joint_7_vy
            + (velocities.velocity_link_7_vy * poses.rotation_link_6_zy
                + velocities.velocity_link_7_vz * poses.minus_rotation_link_6_yy);
        let six_joint_7_mx_14 = velocities.velocity_link_7_wz * screws.screw_joint_7_vx
            - velocities.velocity_link_7_wx * screws.screw_joint_7_vz
            - (velocities.velocity_link_7_vz * poses.minus_rotation_link_6_xy
                + velocities.velocity_link_7_vx * poses.rotation_link_6_zy);
        let six_joint_7_mx_12 = velocities.velocity_link_7_wx * screws.screw_joint_7_vy
            - velocities.velocity_link_7_wy * screws.screw_joint_7_vx
            + (velocities.velocity_link_7_vy * poses.minus_rotation_link_6_xy
                - velocities.velocity_link_7_vx * poses.minus_rotation_link_6_yy);
        let six_joint_7_mx = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_xz
            * poses.rotation_link_6_zy
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_xy
                * poses.minus_rotation_link_6_yy
                + d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_x_2)
            + (inertias.inertia_link_7_xx * six_joint_7_mx_6
                + inertias.minus_inertia_link_7_xy * six_joint_7_mx_8
                + inertias.inertia_link_7_xz * six_joint_7_mx_10
                - (inertias.minus_inertia_link_7_hy * six_joint_7_mx_12
                    + inertias.inertia_link_7_hz * six_joint_7_mx_14));
        let six_joint_7_my = d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_yz
            * poses.rotation_link_6_zy
            - (d_qdot_itself_from_three_more_joint_3_y.three_more_joint_7_y_4
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_yx
                    * poses.minus_rotation_link_6_xy)
            + (inertias.inertia_link_7_yz * six_joint_7_mx_10
                - (inertias.minus_inertia_link_7_xy * six_joint_7_mx_6
                    + inertias.inertia_link_7_yy * six_joint_7_mx_8)
                + (inertias.inertia_link_7_hz * six_joint_7_my_12
                    + inertias.minus_inertia_link_7_hx * six_joint_7_mx_12));
        let six_joint_7_mz = d_qdot_itself_from_three_more_joint_3_y
            .three_more_joint_7_z_0
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_zy
                * poses.minus_rotation_link_6_yy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_zx
                    * poses.minus_rotation_link_6_xy)
            + (inertias.inertia_link_7_xz * six_joint_7_mx_6
                - inertias.inertia_link_7_yz * six_joint_7_mx_8
                + inertias.inertia_link_7_zz * six_joint_7_mx_10
                + (inertias.minus_inertia_link_7_hy * six_joint_7_my_12
                    - inertias.minus_inertia_link_7_hx * six_joint_7_mx_14));
        d_qdot[12][6] = reactions.reaction_joint_1_wx * six_joint_7_mx
            + reactions.reaction_joint_1_wy * six_joint_7_my
            + reactions.reaction_joint_1_wz * six_joint_7_mz
            + d_qdot_itself_from_factor_link_5_xz_0_5_2.three_joint_1_x
                * screws.connection_joint_7_wx
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_y
                * screws.connection_joint_7_wy
            + d_qdot_itself_from_three_joint_1_y.three_joint_1_z
                * screws.connection_joint_7_wz + 0.0;
        DQdotItselfFromDQdot10_11 {
            factor_outside_link_6_xx,
            factor_outside_link_6_yx,
            factor_outside_link_6_zx,
            factor_outside_link_6_xy,
            factor_outside_link_6_yy,
            factor_outside_link_6_zy,
            factor_outside_link_6_xz,
            factor_outside_link_6_yz,
            factor_outside_link_6_zz,
            factor_outside_link_6_px,
            factor_outside_link_6_py,
            factor_outside_link_6_pz,
            three_joint_6_x,
            three_joint_6_y,
            three_joint_6_z,
            six_joint_7_mx_6,
            six_joint_7_mx_8,
            six_joint_7_mx_10,
            six_joint_7_my_12,
            six_joint_7_mx_14,
            six_joint_7_mx_12,
            six_joint_7_mx,
            six_joint_7_my,
            six_joint_7_mz,
        }
    }
    /// What only `d_qdot` computes. Continued.
    #[inline(never)]
    pub(super) fn d_qdot_itself_from_six_joint_7_fx(
        poses: &Poses,
        inertias: &Inertias,
        screws: &Screws,
        reactions: &Reactions,
        d_qdot_itself_from_factor_link_5_xz_0_5_2: &DQdotItselfFromFactorLink5Xz0_5_2,
        d_qdot_itself_from_three_joint_1_y: &DQdotItselfFromThreeJoint1Y,
        d_qdot_itself_from_three_more_joint_3_y: &DQdotItselfFromThreeMoreJoint3Y,
        d_qdot_itself_from_three_joint_2_y: &DQdotItselfFromThreeJoint2Y,
        d_qdot_itself_from_six_joint_3_my: &DQdotItselfFromSixJoint3My,
        d_qdot_itself_from_d_qdot_0_9: &DQdotItselfFromDQdot0_9,
        d_qdot_itself_from_six_more_joint_4_my: &DQdotItselfFromSixMoreJoint4My,
        d_qdot_itself_from_d_qdot_10_11: &DQdotItselfFromDQdot10_11,
        d_qdot: &mut [[f64; 13]; 13],
    ) {
        let six_joint_7_fx = d_qdot_itself_from_d_qdot_10_11.six_joint_7_my_12 * 2.0
            + (d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx_10
                * inertias.minus_inertia_link_7_hy
                - d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx_8
                    * inertias.inertia_link_7_hz)
            - (poses.minus_rotation_link_6_yy
                * d_qdot_itself_from_three_joint_1_y.factor_link_7_pz
                + poses.rotation_link_6_zy
                    * d_qdot_itself_from_three_joint_1_y.factor_link_7_py);
        let six_joint_7_fy = poses.rotation_link_6_zy
            * d_qdot_itself_from_three_joint_1_y.factor_link_7_px
            + poses.minus_rotation_link_6_xy
                * d_qdot_itself_from_three_joint_1_y.factor_link_7_pz
            + (d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx_14 * 2.0
                - (d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx_10
                    * inertias.minus_inertia_link_7_hx
                    + d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx_6
                        * inertias.inertia_link_7_hz));
        let six_joint_7_fz = poses.minus_rotation_link_6_yy
            * d_qdot_itself_from_three_joint_1_y.factor_link_7_px
            - poses.minus_rotation_link_6_xy
                * d_qdot_itself_from_three_joint_1_y.factor_link_7_py
            + (d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx_12 * 2.0
                - (d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx_6
                    * inertias.minus_inertia_link_7_hy
                    + d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx_8
                        * inertias.minus_inertia_link_7_hx));
        // D_q\u{307} column joint_7
        d_qdot[12][7] = reactions.reaction_joint_2_wx
            * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx
            + reactions.reaction_joint_2_wy
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_my
            + reactions.reaction_joint_2_wz
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mz
            + reactions.reaction_joint_2_vx * six_joint_7_fx
            + reactions.reaction_joint_2_vy * six_joint_7_fy
            + reactions.reaction_joint_2_vz * six_joint_7_fz
            + d_qdot_itself_from_three_more_joint_3_y.three_joint_2_x
                * screws.connection_joint_7_wx
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_y
                * screws.connection_joint_7_wy
            + d_qdot_itself_from_three_joint_2_y.three_joint_2_z
                * screws.connection_joint_7_wz + 0.0;
        d_qdot[12][8] = reactions.reaction_joint_3_wx
            * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx
            + reactions.reaction_joint_3_wy
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_my
            + reactions.reaction_joint_3_wz
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mz
            + reactions.reaction_joint_3_vx * six_joint_7_fx
            + reactions.reaction_joint_3_vy * six_joint_7_fy
            + reactions.reaction_joint_3_vz * six_joint_7_fz
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_x
                * screws.connection_joint_7_wx
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_y
                * screws.connection_joint_7_wy
            + d_qdot_itself_from_six_joint_3_my.three_joint_3_z
                * screws.connection_joint_7_wz + 0.0;
        d_qdot[12][9] = reactions.reaction_joint_4_wx
            * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx
            + reactions.reaction_joint_4_wy
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_my
            + reactions.reaction_joint_4_wz
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mz
            + reactions.reaction_joint_4_vx * six_joint_7_fx
            + reactions.reaction_joint_4_vy * six_joint_7_fy
            - reactions.minus_reaction_joint_4_vz * six_joint_7_fz
            + d_qdot_itself_from_d_qdot_0_9.three_joint_4_x
                * screws.connection_joint_7_wx
            + d_qdot_itself_from_d_qdot_0_9.three_joint_4_y
                * screws.connection_joint_7_wy
            + d_qdot_itself_from_d_qdot_0_9.three_joint_4_z
                * screws.connection_joint_7_wz + 0.0;
        d_qdot[12][10] = reactions.reaction_joint_5_wx
            * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx
            + reactions.reaction_joint_5_wy
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_my
            + reactions.reaction_joint_5_wz
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mz
            + reactions.reaction_joint_5_vx * six_joint_7_fx
            + reactions.reaction_joint_5_vy * six_joint_7_fy
            + reactions.reaction_joint_5_vz * six_joint_7_fz
            + d_qdot_itself_from_six_more_joint_4_my.three_joint_5_x
                * screws.connection_joint_7_wx
            + d_qdot_itself_from_six_more_joint_4_my.three_joint_5_y
                * screws.connection_joint_7_wy
            + d_qdot_itself_from_six_more_joint_4_my.three_joint_5_z
                * screws.connection_joint_7_wz + 0.0;
        d_qdot[12][11] = reactions.reaction_joint_6_wx
            * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx
            + reactions.reaction_joint_6_wy
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_my
            + reactions.reaction_joint_6_wz
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mz
            + reactions.reaction_joint_6_vx * six_joint_7_fx
            + reactions.reaction_joint_6_vy * six_joint_7_fy
            + reactions.reaction_joint_6_vz * six_joint_7_fz
            + d_qdot_itself_from_d_qdot_10_11.three_joint_6_x
                * screws.connection_joint_7_wx
            + d_qdot_itself_from_d_qdot_10_11.three_joint_6_y
                * screws.connection_joint_7_wy
            + d_qdot_itself_from_d_qdot_10_11.three_joint_6_z
                * screws.connection_joint_7_wz + 0.0;
        let factor_outside_link_7_xx = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_xx_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_xx;
        let factor_outside_link_7_yx = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_yx_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_yx;
        let factor_outside_link_7_zx = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_zx_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_zx;
        let factor_outside_link_7_xy = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_xy_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_xy;
        let factor_outside_link_7_yy = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_yy_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_yy;
        let factor_outside_link_7_zy = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_zy_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_zy;
        let factor_outside_link_7_xz = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_xz_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_xz;
        let factor_outside_link_7_yz = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_yz_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_yz;
        let factor_outside_link_7_zz = d_qdot_itself_from_factor_link_5_xz_0_5_2
            .factor_link_6_zz_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_zz;
        let factor_outside_link_7_px = d_qdot_itself_from_three_joint_1_y
            .factor_link_6_px_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_px;
        let factor_outside_link_7_py = d_qdot_itself_from_three_joint_1_y
            .factor_link_6_py_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_py;
        let factor_outside_link_7_pz = d_qdot_itself_from_three_joint_1_y
            .factor_link_6_pz_0
            + d_qdot_itself_from_d_qdot_10_11.factor_outside_link_6_pz;
        let three_joint_7_x = factor_outside_link_7_xx * screws.connection_joint_7_wx
            + factor_outside_link_7_yx * screws.connection_joint_7_wy
            + factor_outside_link_7_zx * screws.connection_joint_7_wz
            + (factor_outside_link_7_py * screws.connection_joint_7_vz
                - factor_outside_link_7_pz * screws.connection_joint_7_vy)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_xx
                * reactions.reaction_joint_7_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_yx
                    * reactions.reaction_joint_7_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_zx
                    * reactions.reaction_joint_7_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_7_py
                    * reactions.reaction_joint_7_vz
                    - d_qdot_itself_from_three_joint_1_y.factor_link_7_pz
                        * reactions.reaction_joint_7_vy));
        let three_joint_7_y = factor_outside_link_7_xy * screws.connection_joint_7_wx
            + factor_outside_link_7_yy * screws.connection_joint_7_wy
            + factor_outside_link_7_zy * screws.connection_joint_7_wz
            + (factor_outside_link_7_pz * screws.connection_joint_7_vx
                - factor_outside_link_7_px * screws.connection_joint_7_vz)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_xy
                * reactions.reaction_joint_7_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_yy
                    * reactions.reaction_joint_7_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_zy
                    * reactions.reaction_joint_7_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_7_pz
                    * reactions.reaction_joint_7_vx
                    - d_qdot_itself_from_three_joint_1_y.factor_link_7_px
                        * reactions.reaction_joint_7_vz));
        let three_joint_7_z = factor_outside_link_7_xz * screws.connection_joint_7_wx
            + factor_outside_link_7_yz * screws.connection_joint_7_wy
            + factor_outside_link_7_zz * screws.connection_joint_7_wz
            + (factor_outside_link_7_px * screws.connection_joint_7_vy
                - factor_outside_link_7_py * screws.connection_joint_7_vx)
            - (d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_xz
                * reactions.reaction_joint_7_wx
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_yz
                    * reactions.reaction_joint_7_wy
                + d_qdot_itself_from_factor_link_5_xz_0_5_2.factor_link_7_zz
                    * reactions.reaction_joint_7_wz
                + (d_qdot_itself_from_three_joint_1_y.factor_link_7_px
                    * reactions.reaction_joint_7_vy
                    - d_qdot_itself_from_three_joint_1_y.factor_link_7_py
                        * reactions.reaction_joint_7_vx));
        d_qdot[12][12] = reactions.reaction_joint_7_wx
            * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mx
            + reactions.reaction_joint_7_wy
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_my
            + reactions.reaction_joint_7_wz
                * d_qdot_itself_from_d_qdot_10_11.six_joint_7_mz
            + reactions.reaction_joint_7_vx * six_joint_7_fx
            + reactions.reaction_joint_7_vy * six_joint_7_fy
            + reactions.reaction_joint_7_vz * six_joint_7_fz
            + three_joint_7_x * screws.connection_joint_7_wx
            + three_joint_7_y * screws.connection_joint_7_wy
            + three_joint_7_z * screws.connection_joint_7_wz + 0.0;
    }
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
    base_twist[3] = mu[3]
        + (velocities.velocity_base_vx
            + (velocities.minus_velocity_base_wy * poses.com_z
                - velocities.minus_velocity_base_wz * poses.com_y)) + 0.0;
    base_twist[4] = mu[4]
        + (velocities.minus_velocity_base_wz * poses.com_x
            - velocities.minus_velocity_base_wx * poses.com_z
            - velocities.minus_velocity_base_vy) + 0.0;
    base_twist[5] = mu[5]
        + (velocities.minus_velocity_base_wx * poses.com_y
            - velocities.minus_velocity_base_wy * poses.com_x
            - velocities.minus_velocity_base_vz) + 0.0;
}
/// What only `forward_dynamics` computes.
#[inline(never)]
fn forward_dynamics_itself(
    mu: &[f64; 6],
    qd: &[f64; 7],
    gravity: &[f64; 3],
    base_wrench: &[f64; 6],
    tau: &[f64; 7],
    poses: &Poses,
    inertias: &Inertias,
    screws: &Screws,
    velocities: &Velocities,
    common_d_mu_and_7_more: &CommonDMuAnd7More,
    common_forward_dynamics_inverse_dynamics: &CommonForwardDynamicsInverseDynamics,
    xi_dot: &mut [f64; 13],
) {
    let xi_dot_0_3_3_4_0_2 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let xi_dot_0_3_3_4_3_0_0 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let xi_dot_0_3_3_4_3_0_2 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let xi_dot_0_3_3_4_3_0_9 = inertias.composite_link_1_xy
        + inertias.composite_link_1_xy;
    let xi_dot_0_3_3_4_0_11_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let xi_dot_0_3_3_4_3_0_8_1 = inertias.composite_link_1_hy
        * poses.minus_origin_base_x;
    let xi_dot_0_3_3_4_3_0_8 = xi_dot_0_3_3_4_3_0_8_1 + xi_dot_0_3_3_4_3_0_8_1;
    let xi_dot_0_3_3_4_0_11 = xi_dot_0_3_3_4_0_11_1 + xi_dot_0_3_3_4_0_11_1;
    let xi_dot_0_3_3_4_0_6_0 = mu[3] + (mu[1] * poses.com_z - mu[2] * poses.com_y);
    let xi_dot_0_3_3_4_3_0_6_0 = mu[4] + (mu[2] * poses.com_x - mu[0] * poses.com_z);
    let xi_dot_0_3_3_4_3_0_4_0 = mu[5] + (mu[0] * poses.com_y - mu[1] * poses.com_x);
    let xi_dot_0_3_3_4_0_6 = xi_dot_0_3_3_4_0_6_0 * 17.5;
    let xi_dot_0_3_3_4_3_0_6 = xi_dot_0_3_3_4_3_0_6_0 * 17.5;
    let xi_dot_0_3_3_4_3_0_4 = xi_dot_0_3_3_4_3_0_4_0 * 17.5;
    let xi_dot_0_3_3_4_3_0_24 = (inertias.composite_link_1_xx
        - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 - inertias.inside_joint_1_mz_1_1)) * qd[0]
        - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_x_0_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_0_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_0_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_0_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_0_1_0 * qd[6];
    let xi_dot_0_3_3_4_3_0_26 = common_d_mu_and_7_more.three_joint_2_x_1_0 * qd[1]
        - screws.inside_joint_1_my * qd[0]
        + common_d_mu_and_7_more.three_joint_3_x_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_1_0 * qd[6];
    let xi_dot_0_3_3_4_0_26 = screws.inside_joint_1_mx * qd[0]
        + common_d_mu_and_7_more.three_joint_2_y_1_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * qd[6];
    let xi_dot_0_3_3_4_0_30 = velocities.velocity_base_vx * 17.5;
    let xi_dot_0_3_3_4_3_0_28 = velocities.minus_velocity_base_vy * 17.5;
    let xi_dot_0_3_3_4_3_0_30 = velocities.minus_velocity_base_vz * 17.5;
    let xi_dot_0_3_3_4_0_1 = mu[0] - velocities.minus_velocity_base_wx;
    let xi_dot_0_3_3_4_3_0_3 = mu[1] - velocities.minus_velocity_base_wy;
    let xi_dot_0_3_3_4_3_0_1 = mu[2] - velocities.minus_velocity_base_wz;
    let wrench_base_mx_4 = base_wrench[0]
        + (base_wrench[4] * poses.com_z - base_wrench[5] * poses.com_y);
    let wrench_base_my_4 = base_wrench[1]
        + (base_wrench[5] * poses.com_x - base_wrench[3] * poses.com_z);
    let wrench_base_mz_4 = base_wrench[2]
        + (base_wrench[3] * poses.com_y - base_wrench[4] * poses.com_x);
    let xi_dot_0_3_3_4_3_0 = xi_dot_0_3_3_4_3_0_0 * xi_dot_0_3_3_4_3_0_1
        - xi_dot_0_3_3_4_3_0_2 * xi_dot_0_3_3_4_3_0_3
        + (xi_dot_0_3_3_4_3_0_4 * velocities.minus_velocity_base_vy
            - xi_dot_0_3_3_4_3_0_6 * velocities.minus_velocity_base_vz)
        - (((xi_dot_0_3_3_4_3_0_8 - xi_dot_0_3_3_4_3_0_9) * qd[0]
            + common_d_mu_and_7_more.three_joint_2_x_0_0_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_x_0_0_0 * qd[2]
            + common_d_mu_and_7_more.three_joint_4_x_0_0_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_x_0_0_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_x_0_0_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_x_0_0_0 * qd[6]) * mu[0]
            + xi_dot_0_3_3_4_3_0_24 * mu[1] + xi_dot_0_3_3_4_3_0_26 * mu[2]
            + (xi_dot_0_3_3_4_3_0_28 * xi_dot_0_3_3_4_3_0_4_0
                - xi_dot_0_3_3_4_3_0_30 * xi_dot_0_3_3_4_3_0_6_0));
    let xi_dot_0_3_3_4_0 = xi_dot_0_3_3_4_3_0_2 * xi_dot_0_3_3_4_0_1
        - xi_dot_0_3_3_4_0_2 * xi_dot_0_3_3_4_3_0_1
        + (xi_dot_0_3_3_4_3_0_4 * velocities.velocity_base_vx
            + xi_dot_0_3_3_4_0_6 * velocities.minus_velocity_base_vz)
        - (xi_dot_0_3_3_4_3_0_24 * mu[0]
            + ((xi_dot_0_3_3_4_3_0_9 - xi_dot_0_3_3_4_0_11) * qd[0]
                + common_d_mu_and_7_more.three_joint_2_y_0_0_0 * qd[1]
                + common_d_mu_and_7_more.three_joint_3_y_0_1_0 * qd[2]
                + common_d_mu_and_7_more.three_joint_4_y_0_1_0 * qd[3]
                + common_d_mu_and_7_more.three_joint_5_y_0_1_0 * qd[4]
                + common_d_mu_and_7_more.three_joint_6_y_0_1_0 * qd[5]
                + common_d_mu_and_7_more.three_joint_7_y_0_1_0 * qd[6]) * mu[1]
            + xi_dot_0_3_3_4_0_26 * mu[2]
            + (xi_dot_0_3_3_4_3_0_30 * xi_dot_0_3_3_4_0_6_0
                + xi_dot_0_3_3_4_0_30 * xi_dot_0_3_3_4_3_0_4_0));
    let xi_dot_0_3_3_4_3 = xi_dot_0_3_3_4_3_0 + wrench_base_mx_4;
    let xi_dot_0_3_3_0 = xi_dot_0_3_3_4_0_2 * xi_dot_0_3_3_4_3_0_3
        - xi_dot_0_3_3_4_3_0_0 * xi_dot_0_3_3_4_0_1
        - (xi_dot_0_3_3_4_0_6 * velocities.minus_velocity_base_vy
            + xi_dot_0_3_3_4_3_0_6 * velocities.velocity_base_vx)
        - (xi_dot_0_3_3_4_3_0_26 * mu[0] + xi_dot_0_3_3_4_0_26 * mu[1]
            + ((xi_dot_0_3_3_4_3_0_8 - xi_dot_0_3_3_4_0_11) * qd[0]
                + common_d_mu_and_7_more.three_joint_2_z_1_0 * qd[1]
                + common_d_mu_and_7_more.three_joint_3_z_1_0 * qd[2]
                - common_d_mu_and_7_more.three_joint_4_z_1_0 * qd[3]
                + common_d_mu_and_7_more.three_joint_5_z_1_0 * qd[4]
                + common_d_mu_and_7_more.three_joint_6_z_1_0 * qd[5]
                + common_d_mu_and_7_more.three_joint_7_z_1_0 * qd[6]) * mu[2]
            - (xi_dot_0_3_3_4_0_30 * xi_dot_0_3_3_4_3_0_6_0
                + xi_dot_0_3_3_4_3_0_28 * xi_dot_0_3_3_4_0_6_0)) + wrench_base_mz_4;
    let xi_dot_0_3_3_4 = xi_dot_0_3_3_4_0 + wrench_base_my_4
        - inertias.locked_inverse_pivot_y_2 * xi_dot_0_3_3_4_3;
    let xi_dot_0_3_3 = (xi_dot_0_3_3_0
        - inertias.locked_inverse_pivot_z_2 * xi_dot_0_3_3_4_3
        - inertias.locked_inverse_pivot_z_4 * xi_dot_0_3_3_4)
        * inertias.locked_inverse_pivot_z;
    let xi_dot_0_3 = xi_dot_0_3_3_4 * inertias.locked_inverse_pivot_y
        - inertias.locked_inverse_pivot_z_4 * xi_dot_0_3_3;
    let xi_dot_0 = xi_dot_0_3_3_4_3 * inertias.locked_inverse_pivot_x
        - inertias.locked_inverse_pivot_y_2 * xi_dot_0_3
        - inertias.locked_inverse_pivot_z_2 * xi_dot_0_3_3;
    // ξ\u{307} = [μ\u{307}; q\u{308}]
    xi_dot[0] = xi_dot_0 + 0.0;
    xi_dot[1] = xi_dot_0_3 + 0.0;
    xi_dot[2] = xi_dot_0_3_3 + 0.0;
    xi_dot[3] = (xi_dot_0_3_3_4_3_0_6 * xi_dot_0_3_3_4_3_0_1
        - xi_dot_0_3_3_4_3_0_4 * xi_dot_0_3_3_4_3_0_3
        - (mu[1] * xi_dot_0_3_3_4_3_0_30 - mu[2] * xi_dot_0_3_3_4_3_0_28)
        + base_wrench[3]) * 0.05714285714285714
        + (xi_dot_0_3_3 * poses.com_y - xi_dot_0_3 * poses.com_z) + gravity[0] + 0.0;
    xi_dot[4] = (xi_dot_0_3_3_4_3_0_4 * xi_dot_0_3_3_4_0_1
        - xi_dot_0_3_3_4_0_6 * xi_dot_0_3_3_4_3_0_1
        + (mu[2] * xi_dot_0_3_3_4_0_30 + mu[0] * xi_dot_0_3_3_4_3_0_30) + base_wrench[4])
        * 0.05714285714285714 + (xi_dot_0 * poses.com_z - xi_dot_0_3_3 * poses.com_x)
        + gravity[1] + 0.0;
    xi_dot[5] = (xi_dot_0_3_3_4_0_6 * xi_dot_0_3_3_4_3_0_3
        - xi_dot_0_3_3_4_3_0_6 * xi_dot_0_3_3_4_0_1
        - (mu[0] * xi_dot_0_3_3_4_3_0_28 + mu[1] * xi_dot_0_3_3_4_0_30) + base_wrench[5])
        * 0.05714285714285714 + (xi_dot_0_3 * poses.com_x - xi_dot_0 * poses.com_y)
        + gravity[2] + 0.0;
    let wrench_link_2_mx_1 = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0
        + common_forward_dynamics_inverse_dynamics
            .wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_1;
    let wrench_link_2_mx_3 = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_0
        - common_forward_dynamics_inverse_dynamics
            .wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1;
    let wrench_link_2_my_7 = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_my_0_1_0_1_0_0_0_0_0_0
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_0_0_0_0_1;
    let wrench_link_2_mx_9 = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_mx_0_1_1_1_0_0_0_0_0_0
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_0_0_0_1;
    let wrench_link_2_mx_7 = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_mx_0_1_0_1_0_0_0_0_0_0
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_0_0_0_0_1;
    let wrench_link_3_mx_1 = wrench_link_2_mx_1
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1;
    let wrench_link_3_mx_3 = wrench_link_2_mx_3
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1;
    let wrench_link_3_mx_5 = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_mx_0_0_1_1_0_0_0_0_0
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_0_1;
    let wrench_link_3_my_7 = wrench_link_2_my_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_0_0_0_1;
    let wrench_link_3_mx_9 = wrench_link_2_mx_9
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_0_0_1;
    let wrench_link_3_mx_7 = wrench_link_2_mx_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_0_0_0_1;
    let wrench_link_4_mx_1 = wrench_link_3_mx_1
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_0_0_1;
    let wrench_link_4_mx_3 = wrench_link_3_mx_3
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_0_0_0_1;
    let wrench_link_4_mx_5 = wrench_link_3_mx_5
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_1;
    let wrench_link_4_my_7 = wrench_link_3_my_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_0_0_1;
    let wrench_link_4_mx_9 = wrench_link_3_mx_9
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_0_1;
    let wrench_link_4_mx_7 = wrench_link_3_mx_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_0_0_1;
    let wrench_link_5_mx_1 = wrench_link_4_mx_1
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_0_1;
    let wrench_link_5_mx_3 = wrench_link_4_mx_3
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_0_0_1;
    let wrench_link_5_mx_5 = wrench_link_4_mx_5
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_1;
    let wrench_link_5_my_7 = wrench_link_4_my_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_0_1;
    let wrench_link_5_mx_9 = wrench_link_4_mx_9
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_1;
    let wrench_link_5_mx_7 = wrench_link_4_mx_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_0_1;
    let wrench_link_6_mx_1 = wrench_link_5_mx_1
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_1;
    let wrench_link_6_mx_3 = wrench_link_5_mx_3
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_0_1;
    let wrench_link_6_mx_5 = wrench_link_5_mx_5
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_1;
    let wrench_link_6_my_7 = wrench_link_5_my_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_1;
    let wrench_link_6_mx_9 = wrench_link_5_mx_9
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_1;
    let wrench_link_6_mx_7 = wrench_link_5_mx_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_1;
    let wrench_link_7_mx_1 = wrench_link_6_mx_1
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_1;
    let wrench_link_7_mx_3 = wrench_link_6_mx_3
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_1;
    let wrench_link_7_mx_5 = wrench_link_6_mx_5
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_1;
    let wrench_link_7_my_7 = wrench_link_6_my_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_1;
    let wrench_link_7_mx_9 = wrench_link_6_mx_9
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_1;
    let wrench_link_7_mx_7 = wrench_link_6_mx_7
        + common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_1;
    let wrench_link_7_mx = inertias.inertia_link_7_xx * wrench_link_7_mx_1
        - inertias.minus_inertia_link_7_xy * wrench_link_7_mx_3
        + inertias.inertia_link_7_xz * wrench_link_7_mx_5
        - (inertias.minus_inertia_link_7_hy * wrench_link_7_mx_7
            + inertias.inertia_link_7_hz * wrench_link_7_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_1;
    let wrench_link_7_my = inertias.inertia_link_7_yy * wrench_link_7_mx_3
        - inertias.minus_inertia_link_7_xy * wrench_link_7_mx_1
        + inertias.inertia_link_7_yz * wrench_link_7_mx_5
        + (inertias.inertia_link_7_hz * wrench_link_7_my_7
            + inertias.minus_inertia_link_7_hx * wrench_link_7_mx_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_my_1;
    let wrench_link_7_mz = inertias.inertia_link_7_xz * wrench_link_7_mx_1
        + inertias.inertia_link_7_yz * wrench_link_7_mx_3
        + inertias.inertia_link_7_zz * wrench_link_7_mx_5
        + (inertias.minus_inertia_link_7_hy * wrench_link_7_my_7
            - inertias.minus_inertia_link_7_hx * wrench_link_7_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mz_1;
    let wrench_link_7_fx = wrench_link_7_my_7 * 2.0
        + (wrench_link_7_mx_3 * inertias.inertia_link_7_hz
            + wrench_link_7_mx_5 * inertias.minus_inertia_link_7_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_fx_1;
    let wrench_link_7_fy = wrench_link_7_mx_9 * 2.0
        - (wrench_link_7_mx_5 * inertias.minus_inertia_link_7_hx
            + wrench_link_7_mx_1 * inertias.inertia_link_7_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_fy_1;
    let wrench_link_7_fz = wrench_link_7_mx_7 * 2.0
        + (wrench_link_7_mx_3 * inertias.minus_inertia_link_7_hx
            - wrench_link_7_mx_1 * inertias.minus_inertia_link_7_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_fz_1;
    let inverse_pivot_joint_7_d = 1.0
        / (poses.rotation_link_6_zy * screws.inside_joint_7_mz
            - (poses.minus_rotation_link_6_xy * screws.inside_joint_7_mx
                + poses.minus_rotation_link_6_yy * screws.inside_joint_7_my)
            + screws.screw_joint_7_vx * screws.inside_joint_7_fx
            + screws.screw_joint_7_vy * screws.inside_joint_7_fy
            + screws.screw_joint_7_vz * screws.inside_joint_7_fz);
    let wrench_link_6_mx_13_0 = tau[6]
        - (poses.rotation_link_6_zy * wrench_link_7_mz
            - (poses.minus_rotation_link_6_xy * wrench_link_7_mx
                + poses.minus_rotation_link_6_yy * wrench_link_7_my)
            + screws.screw_joint_7_vx * wrench_link_7_fx
            + screws.screw_joint_7_vy * wrench_link_7_fy
            + screws.screw_joint_7_vz * wrench_link_7_fz);
    let wrench_link_6_mx_13 = wrench_link_6_mx_13_0 * inverse_pivot_joint_7_d;
    let wrench_link_6_mx = inertias.inertia_link_6_xx * wrench_link_6_mx_1
        - inertias.minus_inertia_link_6_xy * wrench_link_6_mx_3
        + inertias.inertia_link_6_xz * wrench_link_6_mx_5
        - (inertias.minus_inertia_link_6_hy * wrench_link_6_mx_7
            + inertias.inertia_link_6_hz * wrench_link_6_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_mx_0_1
        + (wrench_link_7_mx + screws.inside_joint_7_mx * wrench_link_6_mx_13);
    let wrench_link_6_my = inertias.inertia_link_6_yy * wrench_link_6_mx_3
        - inertias.minus_inertia_link_6_xy * wrench_link_6_mx_1
        + inertias.inertia_link_6_yz * wrench_link_6_mx_5
        + (inertias.inertia_link_6_hz * wrench_link_6_my_7
            + inertias.minus_inertia_link_6_hx * wrench_link_6_mx_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_my_0_1
        + (wrench_link_7_my + screws.inside_joint_7_my * wrench_link_6_mx_13);
    let wrench_link_6_mz = inertias.inertia_link_6_xz * wrench_link_6_mx_1
        + inertias.inertia_link_6_yz * wrench_link_6_mx_3
        + inertias.inertia_link_6_zz * wrench_link_6_mx_5
        + (inertias.minus_inertia_link_6_hy * wrench_link_6_my_7
            - inertias.minus_inertia_link_6_hx * wrench_link_6_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_mz_0_1
        + (wrench_link_7_mz + screws.inside_joint_7_mz * wrench_link_6_mx_13);
    let wrench_link_6_fx = wrench_link_6_my_7 * 2.0
        + (wrench_link_6_mx_3 * inertias.inertia_link_6_hz
            + wrench_link_6_mx_5 * inertias.minus_inertia_link_6_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_fx_0_1
        + (wrench_link_7_fx + screws.inside_joint_7_fx * wrench_link_6_mx_13);
    let wrench_link_6_fy = wrench_link_6_mx_9 * 2.0
        - (wrench_link_6_mx_5 * inertias.minus_inertia_link_6_hx
            + wrench_link_6_mx_1 * inertias.inertia_link_6_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_fy_0_1
        + (wrench_link_7_fy + screws.inside_joint_7_fy * wrench_link_6_mx_13);
    let wrench_link_6_fz = wrench_link_6_mx_7 * 2.0
        + (wrench_link_6_mx_3 * inertias.minus_inertia_link_6_hx
            - wrench_link_6_mx_1 * inertias.minus_inertia_link_6_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_fz_0_1
        + (wrench_link_7_fz + screws.inside_joint_7_fz * wrench_link_6_mx_13);
    let minus_articulated_link_6_hxx_0 = screws.inside_joint_7_mx
        * inverse_pivot_joint_7_d;
    let minus_articulated_link_6_hyy_0 = screws.inside_joint_7_my
        * inverse_pivot_joint_7_d;
    let minus_articulated_link_6_hzz_0 = screws.inside_joint_7_mz
        * inverse_pivot_joint_7_d;
    let minus_articulated_link_6_mxy_0 = screws.inside_joint_7_fx
        * inverse_pivot_joint_7_d;
    let minus_articulated_link_6_myz_0 = screws.inside_joint_7_fy
        * inverse_pivot_joint_7_d;
    let minus_articulated_link_6_hxx = minus_articulated_link_6_hxx_0
        * screws.inside_joint_7_fx;
    let minus_articulated_link_6_hyy = minus_articulated_link_6_hyy_0
        * screws.inside_joint_7_fy;
    let minus_articulated_link_6_hzz = minus_articulated_link_6_hzz_0
        * screws.inside_joint_7_fz;
    let minus_articulated_link_6_mxy = minus_articulated_link_6_mxy_0
        * screws.inside_joint_7_fy;
    let minus_articulated_link_6_mxz = minus_articulated_link_6_mxy_0
        * screws.inside_joint_7_fz;
    let minus_articulated_link_6_myz = minus_articulated_link_6_myz_0
        * screws.inside_joint_7_fz;
    let articulated_link_6_jxx = inertias.inertia_link_6_xx
        + (inertias.inertia_link_7_xx
            - minus_articulated_link_6_hxx_0 * screws.inside_joint_7_mx);
    let minus_articulated_link_6_jxy = inertias.minus_inertia_link_6_xy
        + (inertias.minus_inertia_link_7_xy
            + minus_articulated_link_6_hxx_0 * screws.inside_joint_7_my);
    let articulated_link_6_jxz = inertias.inertia_link_6_xz
        + (inertias.inertia_link_7_xz
            - minus_articulated_link_6_hxx_0 * screws.inside_joint_7_mz);
    let articulated_link_6_jyy = inertias.inertia_link_6_yy
        + (inertias.inertia_link_7_yy
            - minus_articulated_link_6_hyy_0 * screws.inside_joint_7_my);
    let articulated_link_6_jyz = inertias.inertia_link_6_yz
        + (inertias.inertia_link_7_yz
            - minus_articulated_link_6_hyy_0 * screws.inside_joint_7_mz);
    let articulated_link_6_jzz = inertias.inertia_link_6_zz
        + (inertias.inertia_link_7_zz
            - minus_articulated_link_6_hzz_0 * screws.inside_joint_7_mz);
    let articulated_link_6_hyx = inertias.inertia_link_6_hz
        + (inertias.inertia_link_7_hz
            - minus_articulated_link_6_hyy_0 * screws.inside_joint_7_fx);
    let articulated_link_6_hzx = inertias.minus_inertia_link_6_hy
        + (inertias.minus_inertia_link_7_hy
            - minus_articulated_link_6_hzz_0 * screws.inside_joint_7_fx);
    let minus_articulated_link_6_hxy = inertias.inertia_link_6_hz
        + (inertias.inertia_link_7_hz
            + minus_articulated_link_6_hxx_0 * screws.inside_joint_7_fy);
    let minus_articulated_link_6_hzy = inertias.minus_inertia_link_6_hx
        + (inertias.minus_inertia_link_7_hx
            + minus_articulated_link_6_hzz_0 * screws.inside_joint_7_fy);
    let minus_articulated_link_6_hxz = inertias.minus_inertia_link_6_hy
        + (inertias.minus_inertia_link_7_hy
            + minus_articulated_link_6_hxx_0 * screws.inside_joint_7_fz);
    let articulated_link_6_hyz = inertias.minus_inertia_link_6_hx
        + (inertias.minus_inertia_link_7_hx
            - minus_articulated_link_6_hyy_0 * screws.inside_joint_7_fz);
    let articulated_link_6_mxx = 2.0
        + (2.0 - minus_articulated_link_6_mxy_0 * screws.inside_joint_7_fx);
    let articulated_link_6_myy = 2.0
        + (2.0 - minus_articulated_link_6_myz_0 * screws.inside_joint_7_fy);
    let articulated_link_6_mzz = 2.0
        + (2.0
            - screws.inside_joint_7_fz * inverse_pivot_joint_7_d
                * screws.inside_joint_7_fz);
    let wrench_outside_link_6_mx = articulated_link_6_jxx * poses.rotation_link_6_xz
        + minus_articulated_link_6_jxy * poses.rotation_link_5_yy
        + articulated_link_6_jxz * poses.rotation_link_6_zz
        - (minus_articulated_link_6_hxz * screws.screw_joint_6_vz
            + (minus_articulated_link_6_hxy * screws.screw_joint_6_vy
                + minus_articulated_link_6_hxx * screws.screw_joint_6_vx));
    let wrench_outside_link_6_my = articulated_link_6_jyz * poses.rotation_link_6_zz
        - (minus_articulated_link_6_jxy * poses.rotation_link_6_xz
            + articulated_link_6_jyy * poses.rotation_link_5_yy)
        + (articulated_link_6_hyz * screws.screw_joint_6_vz
            + (articulated_link_6_hyx * screws.screw_joint_6_vx
                - minus_articulated_link_6_hyy * screws.screw_joint_6_vy));
    let wrench_outside_link_6_mz = articulated_link_6_jxz * poses.rotation_link_6_xz
        - articulated_link_6_jyz * poses.rotation_link_5_yy
        + articulated_link_6_jzz * poses.rotation_link_6_zz
        + (articulated_link_6_hzx * screws.screw_joint_6_vx
            - minus_articulated_link_6_hzy * screws.screw_joint_6_vy
            - minus_articulated_link_6_hzz * screws.screw_joint_6_vz);
    let wrench_outside_link_6_fx = articulated_link_6_hzx * poses.rotation_link_6_zz
        - (minus_articulated_link_6_hxx * poses.rotation_link_6_xz
            + articulated_link_6_hyx * poses.rotation_link_5_yy)
        + (articulated_link_6_mxx * screws.screw_joint_6_vx
            - minus_articulated_link_6_mxy * screws.screw_joint_6_vy
            - minus_articulated_link_6_mxz * screws.screw_joint_6_vz);
    let wrench_outside_link_6_fy = minus_articulated_link_6_hyy
        * poses.rotation_link_5_yy
        - minus_articulated_link_6_hxy * poses.rotation_link_6_xz
        - minus_articulated_link_6_hzy * poses.rotation_link_6_zz
        + (articulated_link_6_myy * screws.screw_joint_6_vy
            - minus_articulated_link_6_mxy * screws.screw_joint_6_vx
            - minus_articulated_link_6_myz * screws.screw_joint_6_vz);
    let wrench_outside_link_6_fz = articulated_link_6_mzz * screws.screw_joint_6_vz
        - (minus_articulated_link_6_mxz * screws.screw_joint_6_vx
            + minus_articulated_link_6_myz * screws.screw_joint_6_vy)
        - (minus_articulated_link_6_hxz * poses.rotation_link_6_xz
            + articulated_link_6_hyz * poses.rotation_link_5_yy
            + minus_articulated_link_6_hzz * poses.rotation_link_6_zz);
    let inverse_pivot_joint_6_d = 1.0
        / (poses.rotation_link_6_xz * wrench_outside_link_6_mx
            - poses.rotation_link_5_yy * wrench_outside_link_6_my
            + poses.rotation_link_6_zz * wrench_outside_link_6_mz
            + screws.screw_joint_6_vx * wrench_outside_link_6_fx
            + screws.screw_joint_6_vy * wrench_outside_link_6_fy
            + screws.screw_joint_6_vz * wrench_outside_link_6_fz);
    let wrench_link_5_mx_13_0 = tau[5]
        - (poses.rotation_link_6_xz * wrench_link_6_mx
            - poses.rotation_link_5_yy * wrench_link_6_my
            + poses.rotation_link_6_zz * wrench_link_6_mz
            + screws.screw_joint_6_vx * wrench_link_6_fx
            + screws.screw_joint_6_vy * wrench_link_6_fy
            + screws.screw_joint_6_vz * wrench_link_6_fz);
    let wrench_link_5_mx_13 = wrench_link_5_mx_13_0 * inverse_pivot_joint_6_d;
    let wrench_link_5_mx = inertias.inertia_link_5_xx * wrench_link_5_mx_1
        + inertias.inertia_link_5_xy * wrench_link_5_mx_3
        + inertias.inertia_link_5_xz * wrench_link_5_mx_5
        + (inertias.inertia_link_5_hy * wrench_link_5_mx_7
            - inertias.inertia_link_5_hz * wrench_link_5_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_mx_0_1
        + (wrench_link_6_mx + wrench_outside_link_6_mx * wrench_link_5_mx_13);
    let wrench_link_5_my = inertias.inertia_link_5_xy * wrench_link_5_mx_1
        + inertias.inertia_link_5_yy * wrench_link_5_mx_3
        + inertias.inertia_link_5_yz * wrench_link_5_mx_5
        + (inertias.inertia_link_5_hz * wrench_link_5_my_7
            + inertias.minus_inertia_link_5_hx * wrench_link_5_mx_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_my_0_1
        + (wrench_link_6_my + wrench_outside_link_6_my * wrench_link_5_mx_13);
    let wrench_link_5_mz = inertias.inertia_link_5_xz * wrench_link_5_mx_1
        + inertias.inertia_link_5_yz * wrench_link_5_mx_3
        + inertias.inertia_link_5_zz * wrench_link_5_mx_5
        - (inertias.minus_inertia_link_5_hx * wrench_link_5_mx_9
            + inertias.inertia_link_5_hy * wrench_link_5_my_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_mz_0_1
        + (wrench_link_6_mz + wrench_outside_link_6_mz * wrench_link_5_mx_13);
    let wrench_link_5_fx = wrench_link_5_my_7 * 2.0
        + (wrench_link_5_mx_3 * inertias.inertia_link_5_hz
            - wrench_link_5_mx_5 * inertias.inertia_link_5_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_fx_0_1
        + (wrench_link_6_fx + wrench_outside_link_6_fx * wrench_link_5_mx_13);
    let wrench_link_5_fy = wrench_link_5_mx_9 * 2.0
        - (wrench_link_5_mx_5 * inertias.minus_inertia_link_5_hx
            + wrench_link_5_mx_1 * inertias.inertia_link_5_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_fy_0_1
        + (wrench_link_6_fy + wrench_outside_link_6_fy * wrench_link_5_mx_13);
    let wrench_link_5_fz = wrench_link_5_mx_7 * 2.0
        + (wrench_link_5_mx_1 * inertias.inertia_link_5_hy
            + wrench_link_5_mx_3 * inertias.minus_inertia_link_5_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_fz_0_1
        + (wrench_link_6_fz + wrench_outside_link_6_fz * wrench_link_5_mx_13);
    let minus_articulated_link_5_hxx_1 = wrench_outside_link_6_mx
        * inverse_pivot_joint_6_d;
    let minus_articulated_link_5_hyy_1 = wrench_outside_link_6_my
        * inverse_pivot_joint_6_d;
    let minus_articulated_link_5_hzz_1 = wrench_outside_link_6_mz
        * inverse_pivot_joint_6_d;
    let minus_articulated_link_5_mxy_1 = wrench_outside_link_6_fx
        * inverse_pivot_joint_6_d;
    let minus_articulated_link_5_myz_1 = wrench_outside_link_6_fy
        * inverse_pivot_joint_6_d;
    let minus_articulated_link_5_hxx = minus_articulated_link_6_hxx
        + minus_articulated_link_5_hxx_1 * wrench_outside_link_6_fx;
    let minus_articulated_link_5_hyy = minus_articulated_link_6_hyy
        + minus_articulated_link_5_hyy_1 * wrench_outside_link_6_fy;
    let minus_articulated_link_5_hzz = minus_articulated_link_6_hzz
        + minus_articulated_link_5_hzz_1 * wrench_outside_link_6_fz;
    let minus_articulated_link_5_mxy = minus_articulated_link_6_mxy
        + minus_articulated_link_5_mxy_1 * wrench_outside_link_6_fy;
    let minus_articulated_link_5_mxz = minus_articulated_link_6_mxz
        + minus_articulated_link_5_mxy_1 * wrench_outside_link_6_fz;
    let minus_articulated_link_5_myz = minus_articulated_link_6_myz
        + minus_articulated_link_5_myz_1 * wrench_outside_link_6_fz;
    let articulated_link_5_jxx = inertias.inertia_link_5_xx
        + (articulated_link_6_jxx
            - minus_articulated_link_5_hxx_1 * wrench_outside_link_6_mx);
    let articulated_link_5_jxy = inertias.inertia_link_5_xy
        - (minus_articulated_link_6_jxy
            + minus_articulated_link_5_hxx_1 * wrench_outside_link_6_my);
    let articulated_link_5_jxz = inertias.inertia_link_5_xz
        + (articulated_link_6_jxz
            - minus_articulated_link_5_hxx_1 * wrench_outside_link_6_mz);
    let articulated_link_5_jyy = inertias.inertia_link_5_yy
        + (articulated_link_6_jyy
            - minus_articulated_link_5_hyy_1 * wrench_outside_link_6_my);
    let articulated_link_5_jyz = inertias.inertia_link_5_yz
        + (articulated_link_6_jyz
            - minus_articulated_link_5_hyy_1 * wrench_outside_link_6_mz);
    let articulated_link_5_jzz = inertias.inertia_link_5_zz
        + (articulated_link_6_jzz
            - minus_articulated_link_5_hzz_1 * wrench_outside_link_6_mz);
    let articulated_link_5_hyx = inertias.inertia_link_5_hz
        + (articulated_link_6_hyx
            - minus_articulated_link_5_hyy_1 * wrench_outside_link_6_fx);
    let articulated_link_5_hzx = articulated_link_6_hzx
        - minus_articulated_link_5_hzz_1 * wrench_outside_link_6_fx
        - inertias.inertia_link_5_hy;
    let minus_articulated_link_5_hxy = inertias.inertia_link_5_hz
        + (minus_articulated_link_6_hxy
            + minus_articulated_link_5_hxx_1 * wrench_outside_link_6_fy);
    let minus_articulated_link_5_hzy = inertias.minus_inertia_link_5_hx
        + (minus_articulated_link_6_hzy
            + minus_articulated_link_5_hzz_1 * wrench_outside_link_6_fy);
    let articulated_link_5_hxz = inertias.inertia_link_5_hy
        - (minus_articulated_link_6_hxz
            + minus_articulated_link_5_hxx_1 * wrench_outside_link_6_fz);
    let articulated_link_5_hyz = inertias.minus_inertia_link_5_hx
        + (articulated_link_6_hyz
            - minus_articulated_link_5_hyy_1 * wrench_outside_link_6_fz);
    let articulated_link_5_mxx = 2.0
        + (articulated_link_6_mxx
            - minus_articulated_link_5_mxy_1 * wrench_outside_link_6_fx);
    let articulated_link_5_myy = 2.0
        + (articulated_link_6_myy
            - minus_articulated_link_5_myz_1 * wrench_outside_link_6_fy);
    let articulated_link_5_mzz = 2.0
        + (articulated_link_6_mzz
            - wrench_outside_link_6_fz * inverse_pivot_joint_6_d
                * wrench_outside_link_6_fz);
    let wrench_outside_link_5_mx = articulated_link_5_jxz * poses.rotation_link_5_zz
        - (articulated_link_5_jxx * poses.rotation_link_4_xy
            + articulated_link_5_jxy * poses.rotation_link_4_yy)
        + (articulated_link_5_hxz * screws.screw_joint_5_vz
            - (minus_articulated_link_5_hxy * screws.screw_joint_5_vy
                + minus_articulated_link_5_hxx * screws.screw_joint_5_vx));
    let wrench_outside_link_5_my = articulated_link_5_jyz * poses.rotation_link_5_zz
        - (articulated_link_5_jxy * poses.rotation_link_4_xy
            + articulated_link_5_jyy * poses.rotation_link_4_yy)
        + (articulated_link_5_hyz * screws.screw_joint_5_vz
            + (articulated_link_5_hyx * screws.screw_joint_5_vx
                - minus_articulated_link_5_hyy * screws.screw_joint_5_vy));
    let wrench_outside_link_5_mz = articulated_link_5_jzz * poses.rotation_link_5_zz
        - (articulated_link_5_jxz * poses.rotation_link_4_xy
            + articulated_link_5_jyz * poses.rotation_link_4_yy)
        + (articulated_link_5_hzx * screws.screw_joint_5_vx
            - minus_articulated_link_5_hzy * screws.screw_joint_5_vy
            - minus_articulated_link_5_hzz * screws.screw_joint_5_vz);
    let wrench_outside_link_5_fx = minus_articulated_link_5_hxx
        * poses.rotation_link_4_xy - articulated_link_5_hyx * poses.rotation_link_4_yy
        + articulated_link_5_hzx * poses.rotation_link_5_zz
        + (articulated_link_5_mxx * screws.screw_joint_5_vx
            - minus_articulated_link_5_mxy * screws.screw_joint_5_vy
            - minus_articulated_link_5_mxz * screws.screw_joint_5_vz);
    let wrench_outside_link_5_fy = minus_articulated_link_5_hxy
        * poses.rotation_link_4_xy
        + minus_articulated_link_5_hyy * poses.rotation_link_4_yy
        - minus_articulated_link_5_hzy * poses.rotation_link_5_zz
        + (articulated_link_5_myy * screws.screw_joint_5_vy
            - minus_articulated_link_5_mxy * screws.screw_joint_5_vx
            - minus_articulated_link_5_myz * screws.screw_joint_5_vz);
    let wrench_outside_link_5_fz = articulated_link_5_mzz * screws.screw_joint_5_vz
        - (minus_articulated_link_5_mxz * screws.screw_joint_5_vx
            + minus_articulated_link_5_myz * screws.screw_joint_5_vy)
        - (articulated_link_5_hxz * poses.rotation_link_4_xy
            + articulated_link_5_hyz * poses.rotation_link_4_yy
            + minus_articulated_link_5_hzz * poses.rotation_link_5_zz);
    let inverse_pivot_joint_5_d = 1.0
        / (poses.rotation_link_5_zz * wrench_outside_link_5_mz
            - (poses.rotation_link_4_xy * wrench_outside_link_5_mx
                + poses.rotation_link_4_yy * wrench_outside_link_5_my)
            + screws.screw_joint_5_vx * wrench_outside_link_5_fx
            + screws.screw_joint_5_vy * wrench_outside_link_5_fy
            + screws.screw_joint_5_vz * wrench_outside_link_5_fz);
    let wrench_link_4_mx_13_0 = tau[4]
        - (poses.rotation_link_5_zz * wrench_link_5_mz
            - (poses.rotation_link_4_xy * wrench_link_5_mx
                + poses.rotation_link_4_yy * wrench_link_5_my)
            + screws.screw_joint_5_vx * wrench_link_5_fx
            + screws.screw_joint_5_vy * wrench_link_5_fy
            + screws.screw_joint_5_vz * wrench_link_5_fz);
    let wrench_link_4_mx_13 = wrench_link_4_mx_13_0 * inverse_pivot_joint_5_d;
    let wrench_link_4_mx = inertias.inertia_link_4_xx * wrench_link_4_mx_1
        + inertias.inertia_link_4_xy * wrench_link_4_mx_3
        + inertias.inertia_link_4_xz * wrench_link_4_mx_5
        + (inertias.inertia_link_4_hy * wrench_link_4_mx_7
            - inertias.inertia_link_4_hz * wrench_link_4_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_mx_0_1
        + (wrench_link_5_mx + wrench_outside_link_5_mx * wrench_link_4_mx_13);
    let wrench_link_4_my = inertias.inertia_link_4_xy * wrench_link_4_mx_1
        + inertias.inertia_link_4_yy * wrench_link_4_mx_3
        + inertias.inertia_link_4_yz * wrench_link_4_mx_5
        + (inertias.inertia_link_4_hz * wrench_link_4_my_7
            + inertias.minus_inertia_link_4_hx * wrench_link_4_mx_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_my_0_1
        + (wrench_link_5_my + wrench_outside_link_5_my * wrench_link_4_mx_13);
    let wrench_link_4_mz = inertias.inertia_link_4_xz * wrench_link_4_mx_1
        + inertias.inertia_link_4_yz * wrench_link_4_mx_3
        + inertias.inertia_link_4_zz * wrench_link_4_mx_5
        - (inertias.minus_inertia_link_4_hx * wrench_link_4_mx_9
            + inertias.inertia_link_4_hy * wrench_link_4_my_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_mz_0_1
        + (wrench_link_5_mz + wrench_outside_link_5_mz * wrench_link_4_mx_13);
    let wrench_link_4_fx = wrench_link_4_my_7 * 2.0
        + (wrench_link_4_mx_3 * inertias.inertia_link_4_hz
            - wrench_link_4_mx_5 * inertias.inertia_link_4_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_fx_0_1
        + (wrench_link_5_fx + wrench_outside_link_5_fx * wrench_link_4_mx_13);
    let wrench_link_4_fy = wrench_link_4_mx_9 * 2.0
        - (wrench_link_4_mx_5 * inertias.minus_inertia_link_4_hx
            + wrench_link_4_mx_1 * inertias.inertia_link_4_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_fy_0_1
        + (wrench_link_5_fy + wrench_outside_link_5_fy * wrench_link_4_mx_13);
    let wrench_link_4_fz = wrench_link_4_mx_7 * 2.0
        + (wrench_link_4_mx_1 * inertias.inertia_link_4_hy
            + wrench_link_4_mx_3 * inertias.minus_inertia_link_4_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_fz_0_1
        + (wrench_link_5_fz + wrench_outside_link_5_fz * wrench_link_4_mx_13);
    let minus_articulated_link_4_hxx_1 = wrench_outside_link_5_mx
        * inverse_pivot_joint_5_d;
    let minus_articulated_link_4_hyy_1 = wrench_outside_link_5_my
        * inverse_pivot_joint_5_d;
    let minus_articulated_link_4_hzz_1 = wrench_outside_link_5_mz
        * inverse_pivot_joint_5_d;
    let minus_articulated_link_4_mxy_1 = wrench_outside_link_5_fx
        * inverse_pivot_joint_5_d;
    let minus_articulated_link_4_myz_1 = wrench_outside_link_5_fy
        * inverse_pivot_joint_5_d;
    let minus_articulated_link_4_hxx = minus_articulated_link_5_hxx
        + minus_articulated_link_4_hxx_1 * wrench_outside_link_5_fx;
    let minus_articulated_link_4_hyy = minus_articulated_link_5_hyy
        + minus_articulated_link_4_hyy_1 * wrench_outside_link_5_fy;
    let minus_articulated_link_4_hzz = minus_articulated_link_5_hzz
        + minus_articulated_link_4_hzz_1 * wrench_outside_link_5_fz;
    let minus_articulated_link_4_mxy = minus_articulated_link_5_mxy
        + minus_articulated_link_4_mxy_1 * wrench_outside_link_5_fy;
    let minus_articulated_link_4_mxz = minus_articulated_link_5_mxz
        + minus_articulated_link_4_mxy_1 * wrench_outside_link_5_fz;
    let minus_articulated_link_4_myz = minus_articulated_link_5_myz
        + minus_articulated_link_4_myz_1 * wrench_outside_link_5_fz;
    let articulated_link_4_jxx = inertias.inertia_link_4_xx
        + (articulated_link_5_jxx
            - minus_articulated_link_4_hxx_1 * wrench_outside_link_5_mx);
    let articulated_link_4_jxy = inertias.inertia_link_4_xy
        + (articulated_link_5_jxy
            - minus_articulated_link_4_hxx_1 * wrench_outside_link_5_my);
    let articulated_link_4_jxz = inertias.inertia_link_4_xz
        + (articulated_link_5_jxz
            - minus_articulated_link_4_hxx_1 * wrench_outside_link_5_mz);
    let articulated_link_4_jyy = inertias.inertia_link_4_yy
        + (articulated_link_5_jyy
            - minus_articulated_link_4_hyy_1 * wrench_outside_link_5_my);
    let articulated_link_4_jyz = inertias.inertia_link_4_yz
        + (articulated_link_5_jyz
            - minus_articulated_link_4_hyy_1 * wrench_outside_link_5_mz);
    let articulated_link_4_jzz = inertias.inertia_link_4_zz
        + (articulated_link_5_jzz
            - minus_articulated_link_4_hzz_1 * wrench_outside_link_5_mz);
    let articulated_link_4_hyx = inertias.inertia_link_4_hz
        + (articulated_link_5_hyx
            - minus_articulated_link_4_hyy_1 * wrench_outside_link_5_fx);
    let articulated_link_4_hzx = articulated_link_5_hzx
        - minus_articulated_link_4_hzz_1 * wrench_outside_link_5_fx
        - inertias.inertia_link_4_hy;
    let minus_articulated_link_4_hxy = inertias.inertia_link_4_hz
        + (minus_articulated_link_5_hxy
            + minus_articulated_link_4_hxx_1 * wrench_outside_link_5_fy);
    let minus_articulated_link_4_hzy = inertias.minus_inertia_link_4_hx
        + (minus_articulated_link_5_hzy
            + minus_articulated_link_4_hzz_1 * wrench_outside_link_5_fy);
    let articulated_link_4_hxz = inertias.inertia_link_4_hy
        + (articulated_link_5_hxz
            - minus_articulated_link_4_hxx_1 * wrench_outside_link_5_fz);
    let articulated_link_4_hyz = inertias.minus_inertia_link_4_hx
        + (articulated_link_5_hyz
            - minus_articulated_link_4_hyy_1 * wrench_outside_link_5_fz);
    let articulated_link_4_mxx = 2.0
        + (articulated_link_5_mxx
            - minus_articulated_link_4_mxy_1 * wrench_outside_link_5_fx);
    let articulated_link_4_myy = 2.0
        + (articulated_link_5_myy
            - minus_articulated_link_4_myz_1 * wrench_outside_link_5_fy);
    let articulated_link_4_mzz = 2.0
        + (articulated_link_5_mzz
            - wrench_outside_link_5_fz * inverse_pivot_joint_5_d
                * wrench_outside_link_5_fz);
    let wrench_outside_link_4_mx = articulated_link_4_jxy * poses.rotation_link_3_yy
        - articulated_link_4_jxx * poses.minus_rotation_link_3_xy
        - articulated_link_4_jxz * poses.minus_rotation_link_3_zy
        + (minus_articulated_link_4_hxy * screws.minus_screw_joint_4_vy
            - minus_articulated_link_4_hxx * screws.screw_joint_4_vx
            - articulated_link_4_hxz * screws.minus_screw_joint_4_vz);
    let wrench_outside_link_4_my = articulated_link_4_jyy * poses.rotation_link_3_yy
        - articulated_link_4_jxy * poses.minus_rotation_link_3_xy
        - articulated_link_4_jyz * poses.minus_rotation_link_3_zy
        + (minus_articulated_link_4_hyy * screws.minus_screw_joint_4_vy
            + articulated_link_4_hyx * screws.screw_joint_4_vx
            - articulated_link_4_hyz * screws.minus_screw_joint_4_vz);
    let wrench_outside_link_4_mz = articulated_link_4_jyz * poses.rotation_link_3_yy
        - articulated_link_4_jxz * poses.minus_rotation_link_3_xy
        - articulated_link_4_jzz * poses.minus_rotation_link_3_zy
        + (minus_articulated_link_4_hzz * screws.minus_screw_joint_4_vz
            + (minus_articulated_link_4_hzy * screws.minus_screw_joint_4_vy
                + articulated_link_4_hzx * screws.screw_joint_4_vx));
    let wrench_outside_link_4_fx = minus_articulated_link_4_hxx
        * poses.minus_rotation_link_3_xy
        + articulated_link_4_hyx * poses.rotation_link_3_yy
        - articulated_link_4_hzx * poses.minus_rotation_link_3_zy
        + (articulated_link_4_mxx * screws.screw_joint_4_vx
            + minus_articulated_link_4_mxy * screws.minus_screw_joint_4_vy
            + minus_articulated_link_4_mxz * screws.minus_screw_joint_4_vz);
    let wrench_outside_link_4_fy = minus_articulated_link_4_hxy
        * poses.minus_rotation_link_3_xy
        - minus_articulated_link_4_hyy * poses.rotation_link_3_yy
        + minus_articulated_link_4_hzy * poses.minus_rotation_link_3_zy
        + (minus_articulated_link_4_myz * screws.minus_screw_joint_4_vz
            - (minus_articulated_link_4_mxy * screws.screw_joint_4_vx
                + articulated_link_4_myy * screws.minus_screw_joint_4_vy));
    let wrench_outside_link_4_fz = articulated_link_4_hyz * poses.rotation_link_3_yy
        - articulated_link_4_hxz * poses.minus_rotation_link_3_xy
        + minus_articulated_link_4_hzz * poses.minus_rotation_link_3_zy
        + (minus_articulated_link_4_myz * screws.minus_screw_joint_4_vy
            - minus_articulated_link_4_mxz * screws.screw_joint_4_vx
            - articulated_link_4_mzz * screws.minus_screw_joint_4_vz);
    let inverse_pivot_joint_4_d = 1.0
        / (poses.rotation_link_3_yy * wrench_outside_link_4_my
            - poses.minus_rotation_link_3_xy * wrench_outside_link_4_mx
            - poses.minus_rotation_link_3_zy * wrench_outside_link_4_mz
            + screws.screw_joint_4_vx * wrench_outside_link_4_fx
            - screws.minus_screw_joint_4_vy * wrench_outside_link_4_fy
            - screws.minus_screw_joint_4_vz * wrench_outside_link_4_fz);
    let wrench_link_3_mx_13_0 = tau[3]
        - (poses.rotation_link_3_yy * wrench_link_4_my
            - poses.minus_rotation_link_3_xy * wrench_link_4_mx
            - poses.minus_rotation_link_3_zy * wrench_link_4_mz
            + screws.screw_joint_4_vx * wrench_link_4_fx
            - screws.minus_screw_joint_4_vy * wrench_link_4_fy
            - screws.minus_screw_joint_4_vz * wrench_link_4_fz);
    let wrench_link_3_mx_13 = wrench_link_3_mx_13_0 * inverse_pivot_joint_4_d;
    let wrench_link_3_mx = inertias.inertia_link_3_xx * wrench_link_3_mx_1
        + inertias.inertia_link_3_xy * wrench_link_3_mx_3
        + inertias.inertia_link_3_xz * wrench_link_3_mx_5
        - (inertias.minus_inertia_link_3_hy * wrench_link_3_mx_7
            + inertias.inertia_link_3_hz * wrench_link_3_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1
        + (wrench_link_4_mx + wrench_outside_link_4_mx * wrench_link_3_mx_13);
    let wrench_link_3_my = inertias.inertia_link_3_xy * wrench_link_3_mx_1
        + inertias.inertia_link_3_yy * wrench_link_3_mx_3
        + inertias.inertia_link_3_yz * wrench_link_3_mx_5
        + (inertias.inertia_link_3_hz * wrench_link_3_my_7
            - inertias.inertia_link_3_hx * wrench_link_3_mx_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_my_0_1
        + (wrench_link_4_my + wrench_outside_link_4_my * wrench_link_3_mx_13);
    let wrench_link_3_mz = inertias.inertia_link_3_xz * wrench_link_3_mx_1
        + inertias.inertia_link_3_yz * wrench_link_3_mx_3
        + inertias.inertia_link_3_zz * wrench_link_3_mx_5
        + (inertias.inertia_link_3_hx * wrench_link_3_mx_9
            + inertias.minus_inertia_link_3_hy * wrench_link_3_my_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mz_0_1
        + (wrench_link_4_mz + wrench_outside_link_4_mz * wrench_link_3_mx_13);
    let wrench_link_3_fx = wrench_link_3_my_7 * 2.0
        + (wrench_link_3_mx_3 * inertias.inertia_link_3_hz
            + wrench_link_3_mx_5 * inertias.minus_inertia_link_3_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fx_0_1
        + (wrench_link_4_fx + wrench_outside_link_4_fx * wrench_link_3_mx_13);
    let wrench_link_3_fy = wrench_link_3_mx_9 * 2.0
        + (wrench_link_3_mx_5 * inertias.inertia_link_3_hx
            - wrench_link_3_mx_1 * inertias.inertia_link_3_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fy_0_1
        + (wrench_link_4_fy + wrench_outside_link_4_fy * wrench_link_3_mx_13);
    let wrench_link_3_fz = wrench_link_3_mx_7 * 2.0
        - (wrench_link_3_mx_1 * inertias.minus_inertia_link_3_hy
            + wrench_link_3_mx_3 * inertias.inertia_link_3_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fz_0_1
        + (wrench_link_4_fz + wrench_outside_link_4_fz * wrench_link_3_mx_13);
    let minus_articulated_link_3_hxx_1 = wrench_outside_link_4_mx
        * inverse_pivot_joint_4_d;
    let minus_articulated_link_3_hyy_1 = wrench_outside_link_4_my
        * inverse_pivot_joint_4_d;
    let minus_articulated_link_3_hzz_1 = wrench_outside_link_4_mz
        * inverse_pivot_joint_4_d;
    let minus_articulated_link_3_mxy_1 = wrench_outside_link_4_fx
        * inverse_pivot_joint_4_d;
    let minus_articulated_link_3_myz_1 = wrench_outside_link_4_fy
        * inverse_pivot_joint_4_d;
    let minus_articulated_link_3_hxx = minus_articulated_link_4_hxx
        + minus_articulated_link_3_hxx_1 * wrench_outside_link_4_fx;
    let minus_articulated_link_3_hyy = minus_articulated_link_4_hyy
        + minus_articulated_link_3_hyy_1 * wrench_outside_link_4_fy;
    let minus_articulated_link_3_hzz = minus_articulated_link_4_hzz
        + minus_articulated_link_3_hzz_1 * wrench_outside_link_4_fz;
    let minus_articulated_link_3_mxy = minus_articulated_link_4_mxy
        + minus_articulated_link_3_mxy_1 * wrench_outside_link_4_fy;
    let minus_articulated_link_3_mxz = minus_articulated_link_4_mxz
        + minus_articulated_link_3_mxy_1 * wrench_outside_link_4_fz;
    let minus_articulated_link_3_myz = minus_articulated_link_4_myz
        + minus_articulated_link_3_myz_1 * wrench_outside_link_4_fz;
    let articulated_link_3_jxx = inertias.inertia_link_3_xx
        + (articulated_link_4_jxx
            - minus_articulated_link_3_hxx_1 * wrench_outside_link_4_mx);
    let articulated_link_3_jxy = inertias.inertia_link_3_xy
        + (articulated_link_4_jxy
            - minus_articulated_link_3_hxx_1 * wrench_outside_link_4_my);
    let articulated_link_3_jxz = inertias.inertia_link_3_xz
        + (articulated_link_4_jxz
            - minus_articulated_link_3_hxx_1 * wrench_outside_link_4_mz);
    let articulated_link_3_jyy = inertias.inertia_link_3_yy
        + (articulated_link_4_jyy
            - minus_articulated_link_3_hyy_1 * wrench_outside_link_4_my);
    let articulated_link_3_jyz = inertias.inertia_link_3_yz
        + (articulated_link_4_jyz
            - minus_articulated_link_3_hyy_1 * wrench_outside_link_4_mz);
    let articulated_link_3_jzz = inertias.inertia_link_3_zz
        + (articulated_link_4_jzz
            - minus_articulated_link_3_hzz_1 * wrench_outside_link_4_mz);
    let articulated_link_3_hyx = inertias.inertia_link_3_hz
        + (articulated_link_4_hyx
            - minus_articulated_link_3_hyy_1 * wrench_outside_link_4_fx);
    let articulated_link_3_hzx = inertias.minus_inertia_link_3_hy
        + (articulated_link_4_hzx
            - minus_articulated_link_3_hzz_1 * wrench_outside_link_4_fx);
    let minus_articulated_link_3_hxy = inertias.inertia_link_3_hz
        + (minus_articulated_link_4_hxy
            + minus_articulated_link_3_hxx_1 * wrench_outside_link_4_fy);
    let articulated_link_3_hzy = inertias.inertia_link_3_hx
        - (minus_articulated_link_4_hzy
            + minus_articulated_link_3_hzz_1 * wrench_outside_link_4_fy);
    let articulated_link_3_hxz = articulated_link_4_hxz
        - minus_articulated_link_3_hxx_1 * wrench_outside_link_4_fz
        - inertias.minus_inertia_link_3_hy;
    let articulated_link_3_hyz = articulated_link_4_hyz
        - minus_articulated_link_3_hyy_1 * wrench_outside_link_4_fz
        - inertias.inertia_link_3_hx;
    let articulated_link_3_mxx = 2.0
        + (articulated_link_4_mxx
            - minus_articulated_link_3_mxy_1 * wrench_outside_link_4_fx);
    let articulated_link_3_myy = 2.0
        + (articulated_link_4_myy
            - minus_articulated_link_3_myz_1 * wrench_outside_link_4_fy);
    let articulated_link_3_mzz = 2.0
        + (articulated_link_4_mzz
            - wrench_outside_link_4_fz * inverse_pivot_joint_4_d
                * wrench_outside_link_4_fz);
    let wrench_outside_link_3_mx = articulated_link_3_jxz * poses.cos_joint_2
        - (articulated_link_3_jxx * poses.minus_rotation_link_2_xy
            + articulated_link_3_jxy * poses.minus_rotation_link_2_yy)
        + (articulated_link_3_hxz * screws.screw_joint_3_vz
            - (minus_articulated_link_3_hxy * screws.screw_joint_3_vy
                + minus_articulated_link_3_hxx * screws.screw_joint_3_vx));
    let wrench_outside_link_3_my = articulated_link_3_jyz * poses.cos_joint_2
        - (articulated_link_3_jxy * poses.minus_rotation_link_2_xy
            + articulated_link_3_jyy * poses.minus_rotation_link_2_yy)
        + (articulated_link_3_hyz * screws.screw_joint_3_vz
            + (articulated_link_3_hyx * screws.screw_joint_3_vx
                - minus_articulated_link_3_hyy * screws.screw_joint_3_vy));
    let wrench_outside_link_3_mz = articulated_link_3_jzz * poses.cos_joint_2
        - (articulated_link_3_jxz * poses.minus_rotation_link_2_xy
            + articulated_link_3_jyz * poses.minus_rotation_link_2_yy)
        + (articulated_link_3_hzy * screws.screw_joint_3_vy
            + articulated_link_3_hzx * screws.screw_joint_3_vx
            - minus_articulated_link_3_hzz * screws.screw_joint_3_vz);
    let wrench_outside_link_3_fx = minus_articulated_link_3_hxx
        * poses.minus_rotation_link_2_xy
        - articulated_link_3_hyx * poses.minus_rotation_link_2_yy
        + articulated_link_3_hzx * poses.cos_joint_2
        + (articulated_link_3_mxx * screws.screw_joint_3_vx
            - minus_articulated_link_3_mxy * screws.screw_joint_3_vy
            - minus_articulated_link_3_mxz * screws.screw_joint_3_vz);
    let wrench_outside_link_3_fy = minus_articulated_link_3_hxy
        * poses.minus_rotation_link_2_xy
        + minus_articulated_link_3_hyy * poses.minus_rotation_link_2_yy
        + articulated_link_3_hzy * poses.cos_joint_2
        + (articulated_link_3_myy * screws.screw_joint_3_vy
            - minus_articulated_link_3_mxy * screws.screw_joint_3_vx
            - minus_articulated_link_3_myz * screws.screw_joint_3_vz);
    let wrench_outside_link_3_fz = articulated_link_3_mzz * screws.screw_joint_3_vz
        - (minus_articulated_link_3_mxz * screws.screw_joint_3_vx
            + minus_articulated_link_3_myz * screws.screw_joint_3_vy)
        - (articulated_link_3_hxz * poses.minus_rotation_link_2_xy
            + articulated_link_3_hyz * poses.minus_rotation_link_2_yy
            + minus_articulated_link_3_hzz * poses.cos_joint_2);
    let inverse_pivot_joint_3_d = 1.0
        / (poses.cos_joint_2 * wrench_outside_link_3_mz
            - (poses.minus_rotation_link_2_xy * wrench_outside_link_3_mx
                + poses.minus_rotation_link_2_yy * wrench_outside_link_3_my)
            + screws.screw_joint_3_vx * wrench_outside_link_3_fx
            + screws.screw_joint_3_vy * wrench_outside_link_3_fy
            + screws.screw_joint_3_vz * wrench_outside_link_3_fz);
    let wrench_link_2_mx_13_0 = tau[2]
        - (poses.cos_joint_2 * wrench_link_3_mz
            - (poses.minus_rotation_link_2_xy * wrench_link_3_mx
                + poses.minus_rotation_link_2_yy * wrench_link_3_my)
            + screws.screw_joint_3_vx * wrench_link_3_fx
            + screws.screw_joint_3_vy * wrench_link_3_fy
            + screws.screw_joint_3_vz * wrench_link_3_fz);
    let wrench_link_2_mx_13 = wrench_link_2_mx_13_0 * inverse_pivot_joint_3_d;
    let wrench_link_2_mx = inertias.inertia_link_2_xx * wrench_link_2_mx_1
        + inertias.inertia_link_2_xy * wrench_link_2_mx_3
        - inertias.inertia_link_2_xz
            * common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_0_1
        - (inertias.minus_inertia_link_2_hy * wrench_link_2_mx_7
            + inertias.inertia_link_2_hz * wrench_link_2_mx_9)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_mx_0_1
        + (wrench_link_3_mx + wrench_outside_link_3_mx * wrench_link_2_mx_13);
    let wrench_link_2_my = inertias.inertia_link_2_xy * wrench_link_2_mx_1
        + inertias.inertia_link_2_yy * wrench_link_2_mx_3
        - inertias.inertia_link_2_yz
            * common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_0_1
        + (inertias.inertia_link_2_hz * wrench_link_2_my_7
            - inertias.inertia_link_2_hx * wrench_link_2_mx_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_my_0_1
        + (wrench_link_3_my + wrench_outside_link_3_my * wrench_link_2_mx_13);
    let wrench_link_2_mz = inertias.inertia_link_2_xz * wrench_link_2_mx_1
        + inertias.inertia_link_2_yz * wrench_link_2_mx_3
        - inertias.inertia_link_2_zz
            * common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_0_1
        + (inertias.inertia_link_2_hx * wrench_link_2_mx_9
            + inertias.minus_inertia_link_2_hy * wrench_link_2_my_7)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_mz_0_1
        + (wrench_link_3_mz + wrench_outside_link_3_mz * wrench_link_2_mx_13);
    let wrench_link_2_fx = wrench_link_2_my_7 * 2.0
        + (wrench_link_2_mx_3 * inertias.inertia_link_2_hz
            - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_0_1
                * inertias.minus_inertia_link_2_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fx_0_1
        + (wrench_link_3_fx + wrench_outside_link_3_fx * wrench_link_2_mx_13);
    let wrench_link_2_fy = wrench_link_2_mx_9 * 2.0
        - (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_0_1
            * inertias.inertia_link_2_hx
            + wrench_link_2_mx_1 * inertias.inertia_link_2_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fy_0_1
        + (wrench_link_3_fy + wrench_outside_link_3_fy * wrench_link_2_mx_13);
    let wrench_link_2_fz = wrench_link_2_mx_7 * 2.0
        - (wrench_link_2_mx_1 * inertias.minus_inertia_link_2_hy
            + wrench_link_2_mx_3 * inertias.inertia_link_2_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fz_0_1
        + (wrench_link_3_fz + wrench_outside_link_3_fz * wrench_link_2_mx_13);
    let minus_articulated_link_2_hxx_1 = wrench_outside_link_3_mx
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_hyy_1 = wrench_outside_link_3_my
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_hzz_1 = wrench_outside_link_3_mz
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_mxy_1 = wrench_outside_link_3_fx
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_myz_1 = wrench_outside_link_3_fy
        * inverse_pivot_joint_3_d;
    let minus_articulated_link_2_hxx = minus_articulated_link_3_hxx
        + minus_articulated_link_2_hxx_1 * wrench_outside_link_3_fx;
    let minus_articulated_link_2_hyy = minus_articulated_link_3_hyy
        + minus_articulated_link_2_hyy_1 * wrench_outside_link_3_fy;
    let minus_articulated_link_2_hzz = minus_articulated_link_3_hzz
        + minus_articulated_link_2_hzz_1 * wrench_outside_link_3_fz;
    let minus_articulated_link_2_mxy = minus_articulated_link_3_mxy
        + minus_articulated_link_2_mxy_1 * wrench_outside_link_3_fy;
    let minus_articulated_link_2_mxz = minus_articulated_link_3_mxz
        + minus_articulated_link_2_mxy_1 * wrench_outside_link_3_fz;
    let minus_articulated_link_2_myz = minus_articulated_link_3_myz
        + minus_articulated_link_2_myz_1 * wrench_outside_link_3_fz;
    let articulated_link_2_jxx = inertias.inertia_link_2_xx
        + (articulated_link_3_jxx
            - minus_articulated_link_2_hxx_1 * wrench_outside_link_3_mx);
    let articulated_link_2_jxy = inertias.inertia_link_2_xy
        + (articulated_link_3_jxy
            - minus_articulated_link_2_hxx_1 * wrench_outside_link_3_my);
    let articulated_link_2_jxz = inertias.inertia_link_2_xz
        + (articulated_link_3_jxz
            - minus_articulated_link_2_hxx_1 * wrench_outside_link_3_mz);
    let articulated_link_2_jyy = inertias.inertia_link_2_yy
        + (articulated_link_3_jyy
            - minus_articulated_link_2_hyy_1 * wrench_outside_link_3_my);
    let articulated_link_2_jyz = inertias.inertia_link_2_yz
        + (articulated_link_3_jyz
            - minus_articulated_link_2_hyy_1 * wrench_outside_link_3_mz);
    let articulated_link_2_jzz = inertias.inertia_link_2_zz
        + (articulated_link_3_jzz
            - minus_articulated_link_2_hzz_1 * wrench_outside_link_3_mz);
    let articulated_link_2_hyx = inertias.inertia_link_2_hz
        + (articulated_link_3_hyx
            - minus_articulated_link_2_hyy_1 * wrench_outside_link_3_fx);
    let articulated_link_2_hzx = inertias.minus_inertia_link_2_hy
        + (articulated_link_3_hzx
            - minus_articulated_link_2_hzz_1 * wrench_outside_link_3_fx);
    let minus_articulated_link_2_hxy = inertias.inertia_link_2_hz
        + (minus_articulated_link_3_hxy
            + minus_articulated_link_2_hxx_1 * wrench_outside_link_3_fy);
    let articulated_link_2_hzy = inertias.inertia_link_2_hx
        + (articulated_link_3_hzy
            - minus_articulated_link_2_hzz_1 * wrench_outside_link_3_fy);
    let articulated_link_2_hxz = articulated_link_3_hxz
        - minus_articulated_link_2_hxx_1 * wrench_outside_link_3_fz
        - inertias.minus_inertia_link_2_hy;
    let articulated_link_2_hyz = articulated_link_3_hyz
        - minus_articulated_link_2_hyy_1 * wrench_outside_link_3_fz
        - inertias.inertia_link_2_hx;
    let articulated_link_2_mxx = 2.0
        + (articulated_link_3_mxx
            - minus_articulated_link_2_mxy_1 * wrench_outside_link_3_fx);
    let articulated_link_2_myy = 2.0
        + (articulated_link_3_myy
            - minus_articulated_link_2_myz_1 * wrench_outside_link_3_fy);
    let articulated_link_2_mzz = 2.0
        + (articulated_link_3_mzz
            - wrench_outside_link_3_fz * inverse_pivot_joint_3_d
                * wrench_outside_link_3_fz);
    let wrench_outside_link_2_mx = articulated_link_2_jxx * poses.sin_joint_1
        - articulated_link_2_jxy * poses.cos_joint_1
        + (articulated_link_2_hxz * screws.screw_joint_2_vz
            - (minus_articulated_link_2_hxy * screws.screw_joint_2_vy
                + minus_articulated_link_2_hxx * screws.screw_joint_2_vx));
    let wrench_outside_link_2_my = articulated_link_2_jxy * poses.sin_joint_1
        - articulated_link_2_jyy * poses.cos_joint_1
        + (articulated_link_2_hyz * screws.screw_joint_2_vz
            + (articulated_link_2_hyx * screws.screw_joint_2_vx
                - minus_articulated_link_2_hyy * screws.screw_joint_2_vy));
    let wrench_outside_link_2_mz = articulated_link_2_jxz * poses.sin_joint_1
        - articulated_link_2_jyz * poses.cos_joint_1
        + (articulated_link_2_hzy * screws.screw_joint_2_vy
            + articulated_link_2_hzx * screws.screw_joint_2_vx
            - minus_articulated_link_2_hzz * screws.screw_joint_2_vz);
    let wrench_outside_link_2_fx = articulated_link_2_mxx * screws.screw_joint_2_vx
        - minus_articulated_link_2_mxy * screws.screw_joint_2_vy
        - minus_articulated_link_2_mxz * screws.screw_joint_2_vz
        - (minus_articulated_link_2_hxx * poses.sin_joint_1
            + articulated_link_2_hyx * poses.cos_joint_1);
    let wrench_outside_link_2_fy = minus_articulated_link_2_hyy * poses.cos_joint_1
        - minus_articulated_link_2_hxy * poses.sin_joint_1
        + (articulated_link_2_myy * screws.screw_joint_2_vy
            - minus_articulated_link_2_mxy * screws.screw_joint_2_vx
            - minus_articulated_link_2_myz * screws.screw_joint_2_vz);
    let wrench_outside_link_2_fz = articulated_link_2_hxz * poses.sin_joint_1
        - articulated_link_2_hyz * poses.cos_joint_1
        + (articulated_link_2_mzz * screws.screw_joint_2_vz
            - (minus_articulated_link_2_mxz * screws.screw_joint_2_vx
                + minus_articulated_link_2_myz * screws.screw_joint_2_vy));
    let inverse_pivot_joint_2_d = 1.0
        / (poses.sin_joint_1 * wrench_outside_link_2_mx
            - poses.cos_joint_1 * wrench_outside_link_2_my
            + screws.screw_joint_2_vx * wrench_outside_link_2_fx
            + screws.screw_joint_2_vy * wrench_outside_link_2_fy
            + screws.screw_joint_2_vz * wrench_outside_link_2_fz);
    let wrench_link_1_mx_11_0 = tau[1]
        - (poses.sin_joint_1 * wrench_link_2_mx - poses.cos_joint_1 * wrench_link_2_my
            + screws.screw_joint_2_vx * wrench_link_2_fx
            + screws.screw_joint_2_vy * wrench_link_2_fy
            + screws.screw_joint_2_vz * wrench_link_2_fz);
    let wrench_link_1_mx_11 = wrench_link_1_mx_11_0 * inverse_pivot_joint_2_d;
    let wrench_link_1_mx = inertias.inertia_link_1_xx
        * common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0
        - inertias.inertia_link_1_xy
            * common_forward_dynamics_inverse_dynamics
                .wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1
        + (inertias.inertia_link_1_hy
            * common_forward_dynamics_inverse_dynamics
                .wrench_link_7_mx_0_1_0_1_0_0_0_0_0_0
            + inertias.inertia_link_1_hz
                * common_forward_dynamics_inverse_dynamics
                    .wrench_link_7_mx_0_1_1_1_0_0_0_0_0_1)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_mx_0_1
        + (wrench_link_2_mx + wrench_outside_link_2_mx * wrench_link_1_mx_11);
    let wrench_link_1_my = inertias.inertia_link_1_xy
        * common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0
        - inertias.inertia_link_1_yy
            * common_forward_dynamics_inverse_dynamics
                .wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1
        + (inertias.inertia_link_1_hz
            * common_forward_dynamics_inverse_dynamics
                .wrench_link_7_my_0_1_0_1_0_0_0_0_0_0
            + inertias.minus_inertia_link_1_hx
                * common_forward_dynamics_inverse_dynamics
                    .wrench_link_7_mx_0_1_0_1_0_0_0_0_0_0)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_my_0_1
        + (wrench_link_2_my + wrench_outside_link_2_my * wrench_link_1_mx_11);
    let wrench_link_1_mz = inertias.inertia_link_1_xz
        * common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0
        + inertias.minus_inertia_link_1_yz
            * common_forward_dynamics_inverse_dynamics
                .wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1
        + (inertias.minus_inertia_link_1_hx
            * common_forward_dynamics_inverse_dynamics
                .wrench_link_7_mx_0_1_1_1_0_0_0_0_0_1
            - inertias.inertia_link_1_hy
                * common_forward_dynamics_inverse_dynamics
                    .wrench_link_7_my_0_1_0_1_0_0_0_0_0_0)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_mz_0_1
        + (wrench_link_2_mz + wrench_outside_link_2_mz * wrench_link_1_mx_11);
    let wrench_link_1_fx = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_my_0_1_0_1_0_0_0_0_0_0 * 2.0
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1
            * inertias.inertia_link_1_hz
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_fx_0_1
        + (wrench_link_2_fx + wrench_outside_link_2_fx * wrench_link_1_mx_11);
    let wrench_link_1_fy = wrench_link_2_fy
        + wrench_outside_link_2_fy * wrench_link_1_mx_11
        - (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_0_0_0_1
            * 2.0
            + common_forward_dynamics_inverse_dynamics
                .wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0 * inertias.inertia_link_1_hz
            + common_forward_dynamics_inverse_dynamics.wrench_link_1_fy_1_1);
    let wrench_link_1_fz = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_mx_0_1_0_1_0_0_0_0_0_0 * 2.0
        + (common_forward_dynamics_inverse_dynamics
            .wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0 * inertias.inertia_link_1_hy
            - common_forward_dynamics_inverse_dynamics
                .wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1
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
        + (articulated_link_2_jxy
            - minus_articulated_link_1_hxx_1 * wrench_outside_link_2_my);
    let articulated_link_1_jxz = inertias.inertia_link_1_xz
        + (articulated_link_2_jxz
            - minus_articulated_link_1_hxx_1 * wrench_outside_link_2_mz);
    let articulated_link_1_jyy = inertias.inertia_link_1_yy
        + (articulated_link_2_jyy
            - minus_articulated_link_1_hyy_1 * wrench_outside_link_2_my);
    let articulated_link_1_jyz = articulated_link_2_jyz
        - minus_articulated_link_1_hyy_1 * wrench_outside_link_2_mz
        - inertias.minus_inertia_link_1_yz;
    let articulated_link_1_jzz = inertias.inertia_link_1_zz
        + (articulated_link_2_jzz
            - minus_articulated_link_1_hzz_1 * wrench_outside_link_2_mz);
    let articulated_link_1_hyx = inertias.inertia_link_1_hz
        + (articulated_link_2_hyx
            - minus_articulated_link_1_hyy_1 * wrench_outside_link_2_fx);
    let articulated_link_1_hzx = articulated_link_2_hzx
        - minus_articulated_link_1_hzz_1 * wrench_outside_link_2_fx
        - inertias.inertia_link_1_hy;
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
        + (articulated_link_2_hyz
            - minus_articulated_link_1_hyy_1 * wrench_outside_link_2_fz);
    let articulated_link_1_mxx = 2.0
        + (articulated_link_2_mxx
            - minus_articulated_link_1_mxy_1 * wrench_outside_link_2_fx);
    let articulated_link_1_myy = 2.0
        + (articulated_link_2_myy
            - minus_articulated_link_1_myz_1 * wrench_outside_link_2_fy);
    let articulated_link_1_mzz = 2.0
        + (articulated_link_2_mzz
            - wrench_outside_link_2_fz * inverse_pivot_joint_2_d
                * wrench_outside_link_2_fz);
    let wrench_outside_link_1_mx = articulated_link_1_jxz
        + (minus_articulated_link_1_hxx * poses.minus_origin_base_y
            - minus_articulated_link_1_hxy * poses.minus_origin_base_x);
    let wrench_outside_link_1_my = articulated_link_1_jyz
        - (minus_articulated_link_1_hyy * poses.minus_origin_base_x
            + articulated_link_1_hyx * poses.minus_origin_base_y);
    let wrench_outside_link_1_mz = articulated_link_1_jzz
        + (articulated_link_1_hzy * poses.minus_origin_base_x
            - articulated_link_1_hzx * poses.minus_origin_base_y);
    let wrench_outside_link_1_fx = articulated_link_1_hzx
        - (articulated_link_1_mxx * poses.minus_origin_base_y
            + minus_articulated_link_1_mxy * poses.minus_origin_base_x);
    let wrench_outside_link_1_fy = articulated_link_1_hzy
        + (minus_articulated_link_1_mxy * poses.minus_origin_base_y
            + articulated_link_1_myy * poses.minus_origin_base_x);
    let wrench_outside_link_1_fz = minus_articulated_link_1_mxz
        * poses.minus_origin_base_y
        - minus_articulated_link_1_myz * poses.minus_origin_base_x
        - minus_articulated_link_1_hzz;
    let inverse_pivot_joint_1_d = 1.0
        / (wrench_outside_link_1_mz
            - poses.minus_origin_base_y * wrench_outside_link_1_fx
            + poses.minus_origin_base_x * wrench_outside_link_1_fy);
    let wrench_base_mx_2_0 = tau[0]
        - (wrench_link_1_mz - poses.minus_origin_base_y * wrench_link_1_fx
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
    let wrench_base_fz = wrench_link_1_fz + wrench_outside_link_1_fz * wrench_base_mx_2
        - (common_forward_dynamics_inverse_dynamics.wrench_base_fz_1_0 + base_wrench[5]);
    let minus_articulated_base_hxx_1 = wrench_outside_link_1_mx
        * inverse_pivot_joint_1_d;
    let minus_articulated_base_hyy_1 = wrench_outside_link_1_my
        * inverse_pivot_joint_1_d;
    let minus_articulated_base_hzz_1 = wrench_outside_link_1_mz
        * inverse_pivot_joint_1_d;
    let minus_articulated_base_mxy_1 = wrench_outside_link_1_fx
        * inverse_pivot_joint_1_d;
    let minus_articulated_base_myz_1 = wrench_outside_link_1_fy
        * inverse_pivot_joint_1_d;
    let minus_articulated_base_hxx = minus_articulated_link_1_hxx
        + minus_articulated_base_hxx_1 * wrench_outside_link_1_fx;
    let minus_articulated_base_hyy = minus_articulated_link_1_hyy
        + minus_articulated_base_hyy_1 * wrench_outside_link_1_fy;
    let minus_articulated_base_hzz = minus_articulated_link_1_hzz
        + minus_articulated_base_hzz_1 * wrench_outside_link_1_fz;
    let minus_articulated_base_mxy = minus_articulated_link_1_mxy
        + minus_articulated_base_mxy_1 * wrench_outside_link_1_fy;
    let minus_articulated_base_mxz = minus_articulated_link_1_mxz
        + minus_articulated_base_mxy_1 * wrench_outside_link_1_fz;
    let minus_articulated_base_myz = minus_articulated_link_1_myz
        + minus_articulated_base_myz_1 * wrench_outside_link_1_fz;
    let articulated_base_jxx = inertias.inertia_base_xx
        + (articulated_link_1_jxx
            - minus_articulated_base_hxx_1 * wrench_outside_link_1_mx);
    let articulated_base_jxy = articulated_link_1_jxy
        - minus_articulated_base_hxx_1 * wrench_outside_link_1_my
        - inertias.minus_inertia_base_xy;
    let articulated_base_jxz = articulated_link_1_jxz
        - minus_articulated_base_hxx_1 * wrench_outside_link_1_mz
        - inertias.minus_inertia_base_xz;
    let articulated_base_jyy = inertias.inertia_base_yy
        + (articulated_link_1_jyy
            - minus_articulated_base_hyy_1 * wrench_outside_link_1_my);
    let articulated_base_jyz = articulated_link_1_jyz
        - minus_articulated_base_hyy_1 * wrench_outside_link_1_mz
        - inertias.minus_inertia_base_yz;
    let articulated_base_jzz = inertias.inertia_base_zz
        + (articulated_link_1_jzz
            - minus_articulated_base_hzz_1 * wrench_outside_link_1_mz);
    let articulated_base_hyx = articulated_link_1_hyx
        - minus_articulated_base_hyy_1 * wrench_outside_link_1_fx
        - inertias.minus_inertia_base_hz;
    let articulated_base_hzx = inertias.minus_inertia_base_hy
        + (articulated_link_1_hzx
            - minus_articulated_base_hzz_1 * wrench_outside_link_1_fx);
    let articulated_base_hxy = inertias.minus_inertia_base_hz
        - (minus_articulated_link_1_hxy
            + minus_articulated_base_hxx_1 * wrench_outside_link_1_fy);
    let articulated_base_hzy = articulated_link_1_hzy
        - minus_articulated_base_hzz_1 * wrench_outside_link_1_fy
        - inertias.minus_inertia_base_hx;
    let articulated_base_hxz = articulated_link_1_hxz
        - minus_articulated_base_hxx_1 * wrench_outside_link_1_fz
        - inertias.minus_inertia_base_hy;
    let articulated_base_hyz = inertias.minus_inertia_base_hx
        + (articulated_link_1_hyz
            - minus_articulated_base_hyy_1 * wrench_outside_link_1_fz);
    let articulated_base_mxx = 3.5
        + (articulated_link_1_mxx
            - minus_articulated_base_mxy_1 * wrench_outside_link_1_fx);
    let articulated_base_myy = 3.5
        + (articulated_link_1_myy
            - minus_articulated_base_myz_1 * wrench_outside_link_1_fy);
    let articulated_base_mzz = 3.5
        + (articulated_link_1_mzz
            - wrench_outside_link_1_fz * inverse_pivot_joint_1_d
                * wrench_outside_link_1_fz);
    let twist_base_wz_15 = 1.0 / articulated_base_mxx;
    let twist_base_wz_16 = minus_articulated_base_mxy * twist_base_wz_15;
    let twist_base_wz_18 = minus_articulated_base_mxz * twist_base_wz_15;
    let minus_twist_base_vy_1 = 1.0
        / (articulated_base_myy - twist_base_wz_16 * minus_articulated_base_mxy);
    let minus_twist_base_vz_9_0 = minus_articulated_base_myz
        + twist_base_wz_18 * minus_articulated_base_mxy;
    let minus_twist_base_vz_9 = minus_twist_base_vz_9_0 * minus_twist_base_vy_1;
    let minus_twist_base_vz_11 = 1.0
        / (articulated_base_mzz - twist_base_wz_18 * minus_articulated_base_mxz
            - minus_twist_base_vz_9 * minus_twist_base_vz_9_0);
    let minus_twist_base_wx_2_0_2_1_3_4 = articulated_base_hxy
        - twist_base_wz_16 * minus_articulated_base_hxx;
    let minus_twist_base_wx_2_0_2_1_3 = (articulated_base_hxz
        - twist_base_wz_18 * minus_articulated_base_hxx
        + minus_twist_base_vz_9 * minus_twist_base_wx_2_0_2_1_3_4)
        * minus_twist_base_vz_11;
    let minus_twist_base_wx_2_0_2_1 = minus_twist_base_wx_2_0_2_1_3_4
        * minus_twist_base_vy_1 + minus_twist_base_vz_9 * minus_twist_base_wx_2_0_2_1_3;
    let minus_twist_base_wx_2_0_2 = twist_base_wz_16 * minus_twist_base_wx_2_0_2_1
        - minus_articulated_base_hxx * twist_base_wz_15
        + twist_base_wz_18 * minus_twist_base_wx_2_0_2_1_3;
    let twist_base_wy_1_3_3_3_4 = twist_base_wz_16 * articulated_base_hyx
        - minus_articulated_base_hyy;
    let twist_base_wy_1_3_3_3 = (articulated_base_hyz
        + twist_base_wz_18 * articulated_base_hyx
        + minus_twist_base_vz_9 * twist_base_wy_1_3_3_3_4) * minus_twist_base_vz_11;
    let twist_base_wy_1_3_3 = twist_base_wy_1_3_3_3_4 * minus_twist_base_vy_1
        + minus_twist_base_vz_9 * twist_base_wy_1_3_3_3;
    let twist_base_wy_1_3 = articulated_base_hyx * twist_base_wz_15
        + twist_base_wz_16 * twist_base_wy_1_3_3
        + twist_base_wz_18 * twist_base_wy_1_3_3_3;
    let twist_base_wz_23_4 = articulated_base_hzy
        + twist_base_wz_16 * articulated_base_hzx;
    let twist_base_wz_23 = (twist_base_wz_18 * articulated_base_hzx
        - minus_articulated_base_hzz + minus_twist_base_vz_9 * twist_base_wz_23_4)
        * minus_twist_base_vz_11;
    let twist_base_wz_21 = twist_base_wz_23_4 * minus_twist_base_vy_1
        + minus_twist_base_vz_9 * twist_base_wz_23;
    let minus_twist_base_wx_2_0 = articulated_base_jxy
        - (articulated_base_hyx * minus_twist_base_wx_2_0_2
            - minus_articulated_base_hyy * minus_twist_base_wx_2_0_2_1
            + articulated_base_hyz * minus_twist_base_wx_2_0_2_1_3);
    let twist_base_wz_25 = articulated_base_jxz
        - (articulated_base_hzx * minus_twist_base_wx_2_0_2
            + articulated_base_hzy * minus_twist_base_wx_2_0_2_1
            - minus_articulated_base_hzz * minus_twist_base_wx_2_0_2_1_3);
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
        - (articulated_base_hzx * twist_base_wy_1_3
            + articulated_base_hzy * twist_base_wy_1_3_3
            - minus_articulated_base_hzz * twist_base_wy_1_3_3_3)
        - twist_base_wz_24 * minus_twist_base_wx_2_0;
    let twist_base_wz_26 = twist_base_wz_27 * twist_base_wy_1;
    let twist_base_wz_4_4 = wrench_base_fy + twist_base_wz_16 * wrench_base_fx;
    let twist_base_wz_4 = (wrench_base_fz + twist_base_wz_18 * wrench_base_fx
        + minus_twist_base_vz_9 * twist_base_wz_4_4) * minus_twist_base_vz_11;
    let twist_base_wz_6 = twist_base_wz_4_4 * minus_twist_base_vy_1
        + minus_twist_base_vz_9 * twist_base_wz_4;
    let twist_base_wz_8 = wrench_base_fx * twist_base_wz_15
        + twist_base_wz_16 * twist_base_wz_6 + twist_base_wz_18 * twist_base_wz_4;
    let twist_base_wz_1 = wrench_base_mx
        + (minus_articulated_base_hxx * twist_base_wz_8
            - articulated_base_hxy * twist_base_wz_6
            - articulated_base_hxz * twist_base_wz_4);
    let twist_base_wz_10 = minus_twist_base_wx_2 * twist_base_wz_1
        - (wrench_base_my
            + (minus_articulated_base_hyy * twist_base_wz_6
                - articulated_base_hyx * twist_base_wz_8
                - articulated_base_hyz * twist_base_wz_4));
    let twist_base_wz = (twist_base_wz_24 * twist_base_wz_1
        - (wrench_base_mz
            + (minus_articulated_base_hzz * twist_base_wz_4
                - (articulated_base_hzy * twist_base_wz_6
                    + articulated_base_hzx * twist_base_wz_8)))
        - twist_base_wz_26 * twist_base_wz_10)
        * (1.0
            / (articulated_base_jzz
                - (articulated_base_hzx
                    * (articulated_base_hzx * twist_base_wz_15
                        + twist_base_wz_16 * twist_base_wz_21
                        + twist_base_wz_18 * twist_base_wz_23)
                    + articulated_base_hzy * twist_base_wz_21
                    - minus_articulated_base_hzz * twist_base_wz_23)
                - twist_base_wz_24 * twist_base_wz_25
                - twist_base_wz_26 * twist_base_wz_27));
    let twist_base_wy = twist_base_wz_10 * twist_base_wy_1
        - twist_base_wz_26 * twist_base_wz;
    let minus_twist_base_wx = twist_base_wz_1 * minus_twist_base_wx_1
        + minus_twist_base_wx_2 * twist_base_wy + twist_base_wz_24 * twist_base_wz;
    let minus_twist_base_vz_8 = wrench_base_fx
        + (minus_articulated_base_hxx * minus_twist_base_wx
            + articulated_base_hyx * twist_base_wy
            + articulated_base_hzx * twist_base_wz);
    let minus_twist_base_vz_10 = wrench_base_fy
        + (articulated_base_hzy * twist_base_wz
            - (articulated_base_hxy * minus_twist_base_wx
                + minus_articulated_base_hyy * twist_base_wy))
        + twist_base_wz_16 * minus_twist_base_vz_8;
    let minus_twist_base_vz = (wrench_base_fz
        + (articulated_base_hyz * twist_base_wy
            - articulated_base_hxz * minus_twist_base_wx
            - minus_articulated_base_hzz * twist_base_wz)
        + twist_base_wz_18 * minus_twist_base_vz_8
        + minus_twist_base_vz_9 * minus_twist_base_vz_10) * minus_twist_base_vz_11;
    let minus_twist_base_vy = minus_twist_base_vz_10 * minus_twist_base_vy_1
        + minus_twist_base_vz_9 * minus_twist_base_vz;
    let minus_twist_base_vx = minus_twist_base_vz_8 * twist_base_wz_15
        + twist_base_wz_16 * minus_twist_base_vy
        + twist_base_wz_18 * minus_twist_base_vz;
    let twist_link_1_wz_1 = (wrench_base_mx_2_0
        - (twist_base_wy * wrench_outside_link_1_my
            - minus_twist_base_wx * wrench_outside_link_1_mx
            + twist_base_wz * wrench_outside_link_1_mz
            - minus_twist_base_vx * wrench_outside_link_1_fx
            - minus_twist_base_vy * wrench_outside_link_1_fy
            - minus_twist_base_vz * wrench_outside_link_1_fz)) * inverse_pivot_joint_1_d;
    xi_dot[6] = twist_link_1_wz_1 + 0.0;
    let twist_link_1_wz = twist_base_wz + twist_link_1_wz_1;
    let minus_twist_link_1_vx = minus_twist_base_vx
        + poses.minus_origin_base_y * twist_link_1_wz_1;
    let twist_link_1_vy = poses.minus_origin_base_x * twist_link_1_wz_1
        - minus_twist_base_vy;
    let twist_link_2_wx_1 = (wrench_link_1_mx_11_0
        - (twist_base_wy * wrench_outside_link_2_my
            - minus_twist_base_wx * wrench_outside_link_2_mx
            + twist_link_1_wz * wrench_outside_link_2_mz
            - minus_twist_link_1_vx * wrench_outside_link_2_fx
            + twist_link_1_vy * wrench_outside_link_2_fy
            - minus_twist_base_vz * wrench_outside_link_2_fz)) * inverse_pivot_joint_2_d;
    xi_dot[7] = twist_link_2_wx_1 + 0.0;
    let twist_link_2_wx = poses.sin_joint_1 * twist_link_2_wx_1 - minus_twist_base_wx;
    let twist_link_2_wy = twist_base_wy - poses.cos_joint_1 * twist_link_2_wx_1;
    let twist_link_2_vx = screws.screw_joint_2_vx * twist_link_2_wx_1
        - minus_twist_link_1_vx;
    let twist_link_2_vy = twist_link_1_vy + screws.screw_joint_2_vy * twist_link_2_wx_1;
    let twist_link_2_vz = screws.screw_joint_2_vz * twist_link_2_wx_1
        - minus_twist_base_vz;
    let twist_link_3_wx_2 = (wrench_link_2_mx_13_0
        - (twist_link_2_wx * wrench_outside_link_3_mx
            + twist_link_2_wy * wrench_outside_link_3_my
            + twist_link_1_wz * wrench_outside_link_3_mz
            + twist_link_2_vx * wrench_outside_link_3_fx
            + twist_link_2_vy * wrench_outside_link_3_fy
            + twist_link_2_vz * wrench_outside_link_3_fz)) * inverse_pivot_joint_3_d;
    xi_dot[8] = twist_link_3_wx_2 + 0.0;
    let twist_link_3_wx = twist_link_2_wx
        - poses.minus_rotation_link_2_xy * twist_link_3_wx_2;
    let twist_link_3_wy = twist_link_2_wy
        - poses.minus_rotation_link_2_yy * twist_link_3_wx_2;
    let twist_link_3_wz = twist_link_1_wz + poses.cos_joint_2 * twist_link_3_wx_2;
    let twist_link_3_vx = twist_link_2_vx + screws.screw_joint_3_vx * twist_link_3_wx_2;
    let twist_link_3_vy = twist_link_2_vy + screws.screw_joint_3_vy * twist_link_3_wx_2;
    let twist_link_3_vz = twist_link_2_vz + screws.screw_joint_3_vz * twist_link_3_wx_2;
    let twist_link_4_wx_2 = (wrench_link_3_mx_13_0
        - (twist_link_3_wx * wrench_outside_link_4_mx
            + twist_link_3_wy * wrench_outside_link_4_my
            + twist_link_3_wz * wrench_outside_link_4_mz
            + twist_link_3_vx * wrench_outside_link_4_fx
            + twist_link_3_vy * wrench_outside_link_4_fy
            + twist_link_3_vz * wrench_outside_link_4_fz)) * inverse_pivot_joint_4_d;
    xi_dot[9] = twist_link_4_wx_2 + 0.0;
    let twist_link_4_wx = twist_link_3_wx
        - poses.minus_rotation_link_3_xy * twist_link_4_wx_2;
    let twist_link_4_wy = twist_link_3_wy + poses.rotation_link_3_yy * twist_link_4_wx_2;
    let twist_link_4_wz = twist_link_3_wz
        - poses.minus_rotation_link_3_zy * twist_link_4_wx_2;
    let twist_link_4_vx = twist_link_3_vx + screws.screw_joint_4_vx * twist_link_4_wx_2;
    let twist_link_4_vy = twist_link_3_vy
        - screws.minus_screw_joint_4_vy * twist_link_4_wx_2;
    let twist_link_4_vz = twist_link_3_vz
        - screws.minus_screw_joint_4_vz * twist_link_4_wx_2;
    let twist_link_5_wx_2 = (wrench_link_4_mx_13_0
        - (twist_link_4_wx * wrench_outside_link_5_mx
            + twist_link_4_wy * wrench_outside_link_5_my
            + twist_link_4_wz * wrench_outside_link_5_mz
            + twist_link_4_vx * wrench_outside_link_5_fx
            + twist_link_4_vy * wrench_outside_link_5_fy
            + twist_link_4_vz * wrench_outside_link_5_fz)) * inverse_pivot_joint_5_d;
    xi_dot[10] = twist_link_5_wx_2 + 0.0;
    let twist_link_5_wx = twist_link_4_wx - poses.rotation_link_4_xy * twist_link_5_wx_2;
    let twist_link_5_wy = twist_link_4_wy - poses.rotation_link_4_yy * twist_link_5_wx_2;
    let twist_link_5_wz = twist_link_4_wz + poses.rotation_link_5_zz * twist_link_5_wx_2;
    let twist_link_5_vx = twist_link_4_vx + screws.screw_joint_5_vx * twist_link_5_wx_2;
    let twist_link_5_vy = twist_link_4_vy + screws.screw_joint_5_vy * twist_link_5_wx_2;
    let twist_link_5_vz = twist_link_4_vz + screws.screw_joint_5_vz * twist_link_5_wx_2;
    let twist_link_6_wx_2 = (wrench_link_5_mx_13_0
        - (twist_link_5_wx * wrench_outside_link_6_mx
            + twist_link_5_wy * wrench_outside_link_6_my
            + twist_link_5_wz * wrench_outside_link_6_mz
            + twist_link_5_vx * wrench_outside_link_6_fx
            + twist_link_5_vy * wrench_outside_link_6_fy
            + twist_link_5_vz * wrench_outside_link_6_fz)) * inverse_pivot_joint_6_d;
    xi_dot[11] = twist_link_6_wx_2 + 0.0;
    let twist_link_6_wx = twist_link_5_wx + poses.rotation_link_6_xz * twist_link_6_wx_2;
    let twist_link_6_wy = twist_link_5_wy - poses.rotation_link_5_yy * twist_link_6_wx_2;
    let twist_link_6_wz = twist_link_5_wz + poses.rotation_link_6_zz * twist_link_6_wx_2;
    let twist_link_6_vx = twist_link_5_vx + screws.screw_joint_6_vx * twist_link_6_wx_2;
    let twist_link_6_vy = twist_link_5_vy + screws.screw_joint_6_vy * twist_link_6_wx_2;
    let twist_link_6_vz = twist_link_5_vz + screws.screw_joint_6_vz * twist_link_6_wx_2;
    xi_dot[12] = (wrench_link_6_mx_13_0
        - (twist_link_6_wx * screws.inside_joint_7_mx
            + twist_link_6_wy * screws.inside_joint_7_my
            + twist_link_6_wz * screws.inside_joint_7_mz
            + twist_link_6_vx * screws.inside_joint_7_fx
            + twist_link_6_vy * screws.inside_joint_7_fy
            + twist_link_6_vz * screws.inside_joint_7_fz)) * inverse_pivot_joint_7_d
        + 0.0;
}
/// The block-diagonal inertia diag(Λ_b, Λ_q) and the connection A_l = Λ_b⁻¹ M_bq.
///
/// - `q`: shape (7; rad, m)
/// - `locked_inertia`: Λ_b, inertia with the joints locked, base frame (6×6, by columns; kg·m², kg·m, kg)
/// - `connection`: A_l, local mechanical connection, base frame: V₁ = −A_l q̇ at rest (6×7, by columns; rad, m)
/// - `shape_inertia`: Λ_q, inertia that the joints feel on the floating base (7×7, by columns; kg·m²)
///
/// 1716 operations: 825 + −, 888 ×, 3 ÷; 7 sin cos; about 20.4 KiB of code.
pub fn inertia(
    q: &[f64; 7],
    locked_inertia: &mut [[f64; 6]; 6],
    connection: &mut [[f64; 6]; 7],
    shape_inertia: &mut [[f64; 7]; 7],
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
/// - `q`: shape (7; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `d_mu`: D_μ, Coriolis terms linear in μ, skew, base frame (13×13, by columns; Λ's · 1/s)
///
/// 3237 operations: 1611 + −, 1623 ×, 3 ÷; 7 sin cos; about 38.2 KiB of code.
pub fn d_mu(q: &[f64; 7], mu: &[f64; 6], d_mu: &mut [[f64; 13]; 13]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
    let common_d_mu_b2_curvature = common_d_mu_b2_curvature(
        &poses,
        &inertias,
        &complements,
        &screws,
    );
    let common_d_mu_b2 = common_d_mu_b2(
        mu,
        &inertias,
        &screws,
        &outside,
        &reactions,
        &common_d_mu_and_7_more,
        &common_d_mu_b2_curvature,
    );
    d_mu_itself(
        mu,
        &poses,
        &inertias,
        &screws,
        &common_d_mu_and_7_more,
        &common_d_mu_b2,
        d_mu,
    );
}
/// B_2(μ) = Σ_k J̃_kᵀ C(M_k; X_k μ) J̃_k.
///
/// - `q`: shape (7; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `b2`: B_2(μ), how momentum feels the curvature, skew: −½ ⟨Λ_b μ, 𝓑(e_i, e_j)⟩ (7×7, by columns; kg·m²/s)
///
/// 2578 operations: 1300 + −, 1275 ×, 3 ÷; 7 sin cos; about 30.5 KiB of code.
pub fn b2(q: &[f64; 7], mu: &[f64; 6], b2: &mut [[f64; 7]; 7]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
    let common_d_mu_b2_curvature = common_d_mu_b2_curvature(
        &poses,
        &inertias,
        &complements,
        &screws,
    );
    let common_d_mu_b2 = common_d_mu_b2(
        mu,
        &inertias,
        &screws,
        &outside,
        &reactions,
        &common_d_mu_and_7_more,
        &common_d_mu_b2_curvature,
    );
    b2_itself(&common_d_mu_b2, b2);
}
/// Λ_b, A_l, Λ_q, D_μ and B_2 at once, sharing their work.
///
/// - `q`: shape (7; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `locked_inertia`: Λ_b, inertia with the joints locked, base frame (6×6, by columns; kg·m², kg·m, kg)
/// - `connection`: A_l, local mechanical connection, base frame: V₁ = −A_l q̇ at rest (6×7, by columns; rad, m)
/// - `shape_inertia`: Λ_q, inertia that the joints feel on the floating base (7×7, by columns; kg·m²)
/// - `d_mu`: D_μ, Coriolis terms linear in μ, skew, base frame (13×13, by columns; Λ's · 1/s)
/// - `b2`: B_2(μ), how momentum feels the curvature, skew: −½ ⟨Λ_b μ, 𝓑(e_i, e_j)⟩ (7×7, by columns; kg·m²/s)
///
/// 3625 operations: 1780 + −, 1842 ×, 3 ÷; 7 sin cos; about 42.8 KiB of code.
pub fn matrices(
    q: &[f64; 7],
    mu: &[f64; 6],
    locked_inertia: &mut [[f64; 6]; 6],
    connection: &mut [[f64; 6]; 7],
    shape_inertia: &mut [[f64; 7]; 7],
    d_mu: &mut [[f64; 13]; 13],
    b2: &mut [[f64; 7]; 7],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
    let common_d_mu_b2_curvature = common_d_mu_b2_curvature(
        &poses,
        &inertias,
        &complements,
        &screws,
    );
    let common_d_mu_b2 = common_d_mu_b2(
        mu,
        &inertias,
        &screws,
        &outside,
        &reactions,
        &common_d_mu_and_7_more,
        &common_d_mu_b2_curvature,
    );
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
        &screws,
        &common_d_mu_and_7_more,
        &common_d_mu_b2,
        d_mu,
    );
    b2_itself(&common_d_mu_b2, b2);
}
/// D_q̇ = diag(½ P(q̇), Γ'_q(q̇)): dΛ_q/dt = Γ'_q + Γ'_qᵀ, dΛ_b/dt = P(q̇).
///
/// - `q`: shape (7; rad, m)
/// - `qd`: shape velocity (7; rad/s, m/s)
/// - `d_qdot`: D_q̇, diag(½ P(q̇), Γ'_q(q̇)), base frame (13×13, by columns; Λ's · 1/s)
///
/// 5322 operations: 2700 + −, 2619 ×, 3 ÷; 7 sin cos; about 62.6 KiB of code.
pub fn d_qdot(q: &[f64; 7], qd: &[f64; 7], d_qdot: &mut [[f64; 13]; 13]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
    let d_qdot_itself = d_qdot_itself(
        qd,
        &poses,
        &inertias,
        &screws,
        &velocities,
        &common_d_mu_and_7_more,
        d_qdot,
    );
    let d_qdot_itself_from_factor_outside_link_1_px = d_qdot_itself_from_factor_outside_link_1_px(
        &inertias,
        &velocities,
        &d_qdot_itself,
    );
    let d_qdot_itself_from_factor_link_5_xz_0_5_2 = d_qdot_itself_from_factor_link_5_xz_0_5_2(
        &poses,
        &inertias,
        &screws,
        &reactions,
        &velocities,
        &d_qdot_itself,
        &d_qdot_itself_from_factor_outside_link_1_px,
    );
    let d_qdot_itself_from_three_joint_1_y = d_qdot_itself_from_three_joint_1_y(
        &poses,
        &inertias,
        &screws,
        &reactions,
        &velocities,
        &d_qdot_itself,
        &d_qdot_itself_from_factor_outside_link_1_px,
        &d_qdot_itself_from_factor_link_5_xz_0_5_2,
        d_qdot,
    );
    let d_qdot_itself_from_three_more_joint_3_y = d_qdot_itself_from_three_more_joint_3_y(
        &poses,
        &inertias,
        &screws,
        &reactions,
        &velocities,
        &d_qdot_itself,
        &d_qdot_itself_from_factor_outside_link_1_px,
        &d_qdot_itself_from_factor_link_5_xz_0_5_2,
        &d_qdot_itself_from_three_joint_1_y,
        d_qdot,
    );
    let d_qdot_itself_from_three_joint_2_y = d_qdot_itself_from_three_joint_2_y(
        &poses,
        &inertias,
        &complements,
        &screws,
        &reactions,
        &velocities,
        &d_qdot_itself_from_factor_link_5_xz_0_5_2,
        &d_qdot_itself_from_three_joint_1_y,
        &d_qdot_itself_from_three_more_joint_3_y,
        d_qdot,
    );
    let d_qdot_itself_from_six_joint_3_my = d_qdot_itself_from_six_joint_3_my(
        &poses,
        &inertias,
        &complements,
        &screws,
        &reactions,
        &d_qdot_itself_from_factor_outside_link_1_px,
        &d_qdot_itself_from_factor_link_5_xz_0_5_2,
        &d_qdot_itself_from_three_joint_1_y,
        &d_qdot_itself_from_three_more_joint_3_y,
        &d_qdot_itself_from_three_joint_2_y,
        d_qdot,
    );
    let d_qdot_itself_from_d_qdot_0_9 = d_qdot_itself_from_d_qdot_0_9(
        &poses,
        &inertias,
        &complements,
        &screws,
        &reactions,
        &velocities,
        &d_qdot_itself_from_factor_outside_link_1_px,
        &d_qdot_itself_from_factor_link_5_xz_0_5_2,
        &d_qdot_itself_from_three_joint_1_y,
        &d_qdot_itself_from_three_more_joint_3_y,
        &d_qdot_itself_from_three_joint_2_y,
        &d_qdot_itself_from_six_joint_3_my,
        d_qdot,
    );
    let d_qdot_itself_from_six_more_joint_4_my = d_qdot_itself_from_six_more_joint_4_my(
        &poses,
        &inertias,
        &complements,
        &screws,
        &reactions,
        &velocities,
        &d_qdot_itself_from_factor_outside_link_1_px,
        &d_qdot_itself_from_factor_link_5_xz_0_5_2,
        &d_qdot_itself_from_three_joint_1_y,
        &d_qdot_itself_from_three_more_joint_3_y,
        &d_qdot_itself_from_three_joint_2_y,
        &d_qdot_itself_from_six_joint_3_my,
        &d_qdot_itself_from_d_qdot_0_9,
        d_qdot,
    );
    let d_qdot_itself_from_six_more_joint_5_mx = d_qdot_itself_from_six_more_joint_5_mx(
        &poses,
        &inertias,
        &complements,
        &screws,
        &reactions,
        &velocities,
        &d_qdot_itself_from_factor_link_5_xz_0_5_2,
        &d_qdot_itself_from_three_joint_1_y,
        &d_qdot_itself_from_three_more_joint_3_y,
        &d_qdot_itself_from_three_joint_2_y,
        &d_qdot_itself_from_six_joint_3_my,
        &d_qdot_itself_from_d_qdot_0_9,
        &d_qdot_itself_from_six_more_joint_4_my,
        d_qdot,
    );
    let d_qdot_itself_from_d_qdot_10_11 = d_qdot_itself_from_d_qdot_10_11(
        &poses,
        &inertias,
        &complements,
        &screws,
        &reactions,
        &velocities,
        &d_qdot_itself_from_factor_link_5_xz_0_5_2,
        &d_qdot_itself_from_three_joint_1_y,
        &d_qdot_itself_from_three_more_joint_3_y,
        &d_qdot_itself_from_six_more_joint_4_my,
        &d_qdot_itself_from_six_more_joint_5_mx,
        d_qdot,
    );
    d_qdot_itself_from_six_joint_7_fx(
        &poses,
        &inertias,
        &screws,
        &reactions,
        &d_qdot_itself_from_factor_link_5_xz_0_5_2,
        &d_qdot_itself_from_three_joint_1_y,
        &d_qdot_itself_from_three_more_joint_3_y,
        &d_qdot_itself_from_three_joint_2_y,
        &d_qdot_itself_from_six_joint_3_my,
        &d_qdot_itself_from_d_qdot_0_9,
        &d_qdot_itself_from_six_more_joint_4_my,
        &d_qdot_itself_from_d_qdot_10_11,
        d_qdot,
    );
}
/// The (μ, μ) term of the shape equation.
///
/// - `q`: shape (7; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `coupling_torque`: (S(μ)ᵀ − A_lᵀ ad~_{Λ_bμ}) μ, what turning as one body asks (7; N·m, N)
///
/// 2192 operations: 974 + −, 1215 ×, 3 ÷; 7 sin cos; about 26.0 KiB of code.
pub fn coupling_torque(q: &[f64; 7], mu: &[f64; 6], coupling_torque: &mut [f64; 7]) {
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
    coupling_torque[3] = common_coupling_torque_d_mu_xi.coupling_torque_3 + 0.0;
    coupling_torque[4] = common_coupling_torque_d_mu_xi.coupling_torque_4 + 0.0;
    coupling_torque[5] = common_coupling_torque_d_mu_xi.coupling_torque_5 + 0.0;
    coupling_torque[6] = common_coupling_torque_d_mu_xi.coupling_torque_6 + 0.0;
}
/// D_μ ξ, without forming D_μ.
///
/// - `q`: shape (7; rad, m)
/// - `qd`: shape velocity (7; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `d_mu_xi`: D_μ ξ, D_μ on ξ = [μ; q̇], base frame (13; N·m, N)
///
/// 3629 operations: 1720 + −, 1906 ×, 3 ÷; 7 sin cos; about 42.8 KiB of code.
pub fn d_mu_xi(q: &[f64; 7], qd: &[f64; 7], mu: &[f64; 6], d_mu_xi: &mut [f64; 13]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
    let common_coupling_torque_d_mu_xi = common_coupling_torque_d_mu_xi(
        mu,
        &inertias,
        &complements,
        &screws,
        &reactions,
    );
    let d_mu_xi_0_0 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let d_mu_xi_0_2 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let d_mu_xi_0_8_1 = inertias.composite_link_1_xy + inertias.composite_link_1_xy;
    let d_mu_xi_0_8_0_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
    let d_mu_xi_0_8_0 = d_mu_xi_0_8_0_1 + d_mu_xi_0_8_0_1;
    let d_mu_xi_0_11_2_0 = mu[3] + (mu[1] * poses.com_z - mu[2] * poses.com_y);
    let d_mu_xi_0_9_2_0 = mu[4] + (mu[2] * poses.com_x - mu[0] * poses.com_z);
    let d_mu_xi_0_11_0_0 = mu[5] + (mu[0] * poses.com_y - mu[1] * poses.com_x);
    let d_mu_xi_0_11_2 = d_mu_xi_0_11_2_0 * 17.5;
    let d_mu_xi_0_9_2 = d_mu_xi_0_9_2_0 * 17.5;
    let d_mu_xi_0_11_0 = d_mu_xi_0_11_0_0 * 17.5;
    let d_mu_xi_0_8_16 = (inertias.composite_link_1_xx - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 - inertias.inside_joint_1_mz_1_1)) * qd[0]
        - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_x_0_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_0_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_0_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_0_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_0_1_0 * qd[6];
    let d_mu_xi_0_8_18 = common_d_mu_and_7_more.three_joint_2_x_1_0 * qd[1]
        - screws.inside_joint_1_my * qd[0]
        + common_d_mu_and_7_more.three_joint_3_x_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_1_0 * qd[6];
    let d_mu_xi_0_11_5 = velocities.velocity_base_vx * 17.5;
    let d_mu_xi_0_8_20 = velocities.minus_velocity_base_vy * 17.5;
    let d_mu_xi_0_8_22 = velocities.minus_velocity_base_vz * 17.5;
    let d_mu_xi_0_11_1 = mu[0] - velocities.minus_velocity_base_wx;
    let d_mu_xi_0_9_1 = mu[1] - velocities.minus_velocity_base_wy;
    let d_mu_xi_0_11_3 = mu[2] - velocities.minus_velocity_base_wz;
    let d_mu_xi_0_8 = (((d_mu_xi_0_8_0 - d_mu_xi_0_8_1) * qd[0]
        + common_d_mu_and_7_more.three_joint_2_x_0_0_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_x_0_0_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_0_0_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_0_0_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_0_0_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_0_0_0 * qd[6]) * mu[0]
        + d_mu_xi_0_8_16 * mu[1] + d_mu_xi_0_8_18 * mu[2]
        + (d_mu_xi_0_8_20 * d_mu_xi_0_11_0_0 - d_mu_xi_0_8_22 * d_mu_xi_0_9_2_0)) * 0.5;
    let d_mu_xi_0_11 = d_mu_xi_0_11_0 * d_mu_xi_0_11_1 - d_mu_xi_0_11_2 * d_mu_xi_0_11_3
        + (mu[2] * d_mu_xi_0_11_5 + mu[0] * d_mu_xi_0_8_22) * 0.5;
    let d_mu_xi_0_9 = d_mu_xi_0_11_2 * d_mu_xi_0_9_1 - d_mu_xi_0_9_2 * d_mu_xi_0_11_1
        - (mu[0] * d_mu_xi_0_8_20 + mu[1] * d_mu_xi_0_11_5) * 0.5;
    // D_μ ξ
    d_mu_xi[0] = d_mu_xi_0_0 * d_mu_xi_0_11_3 - d_mu_xi_0_2 * d_mu_xi_0_9_1
        + (d_mu_xi_0_11_0 * velocities.minus_velocity_base_vy
            - d_mu_xi_0_9_2 * velocities.minus_velocity_base_vz) - d_mu_xi_0_8
        + (d_mu_xi_0_9 * poses.com_y - d_mu_xi_0_11 * poses.com_z) + 0.0;
    let d_mu_xi_1_2 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let d_mu_xi_1_8_3_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let d_mu_xi_1_8_3 = d_mu_xi_1_8_3_1 + d_mu_xi_1_8_3_1;
    let d_mu_xi_1_8_18 = screws.inside_joint_1_mx * qd[0]
        + common_d_mu_and_7_more.three_joint_2_y_1_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * qd[6];
    let d_mu_xi_1_8 = (d_mu_xi_0_8_16 * mu[0]
        + ((d_mu_xi_0_8_1 - d_mu_xi_1_8_3) * qd[0]
            + common_d_mu_and_7_more.three_joint_2_y_0_0_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_y_0_1_0 * qd[2]
            + common_d_mu_and_7_more.three_joint_4_y_0_1_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_y_0_1_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_y_0_1_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_y_0_1_0 * qd[6]) * mu[1]
        + d_mu_xi_1_8_18 * mu[2]
        + (d_mu_xi_0_8_22 * d_mu_xi_0_11_2_0 + d_mu_xi_0_11_5 * d_mu_xi_0_11_0_0)) * 0.5;
    let d_mu_xi_1_9 = d_mu_xi_0_9_2 * d_mu_xi_0_11_3 - d_mu_xi_0_11_0 * d_mu_xi_0_9_1
        - (mu[1] * d_mu_xi_0_8_22 - mu[2] * d_mu_xi_0_8_20) * 0.5;
    d_mu_xi[1] = d_mu_xi_0_2 * d_mu_xi_0_11_1 - d_mu_xi_1_2 * d_mu_xi_0_11_3
        + (d_mu_xi_0_11_0 * velocities.velocity_base_vx
            + d_mu_xi_0_11_2 * velocities.minus_velocity_base_vz) - d_mu_xi_1_8
        + (d_mu_xi_1_9 * poses.com_z - d_mu_xi_0_9 * poses.com_x) + 0.0;
    let d_mu_xi_2_0 = d_mu_xi_1_2 * d_mu_xi_0_9_1 - d_mu_xi_0_0 * d_mu_xi_0_11_1
        - (d_mu_xi_0_11_2 * velocities.minus_velocity_base_vy
            + d_mu_xi_0_9_2 * velocities.velocity_base_vx)
        - (d_mu_xi_0_8_18 * mu[0] + d_mu_xi_1_8_18 * mu[1]
            + ((d_mu_xi_0_8_0 - d_mu_xi_1_8_3) * qd[0]
                + common_d_mu_and_7_more.three_joint_2_z_1_0 * qd[1]
                + common_d_mu_and_7_more.three_joint_3_z_1_0 * qd[2]
                - common_d_mu_and_7_more.three_joint_4_z_1_0 * qd[3]
                + common_d_mu_and_7_more.three_joint_5_z_1_0 * qd[4]
                + common_d_mu_and_7_more.three_joint_6_z_1_0 * qd[5]
                + common_d_mu_and_7_more.three_joint_7_z_1_0 * qd[6]) * mu[2]
            - (d_mu_xi_0_11_5 * d_mu_xi_0_9_2_0 + d_mu_xi_0_8_20 * d_mu_xi_0_11_2_0))
            * 0.5;
    d_mu_xi[2] = d_mu_xi_2_0 + (d_mu_xi_0_11 * poses.com_x - d_mu_xi_1_9 * poses.com_y)
        + 0.0;
    d_mu_xi[3] = d_mu_xi_1_9 + 0.0;
    d_mu_xi[4] = d_mu_xi_0_11 + 0.0;
    d_mu_xi[5] = d_mu_xi_0_9 + 0.0;
    let wrench_outside_link_1_my_0_1 = (inertias.inertia_base_xx
        + inertias.inertia_base_yy + inertias.inertia_base_zz) * 0.5;
    let wrench_outside_link_1_fy_5 = velocities.minus_velocity_base_wy
        * inertias.minus_inertia_base_hz
        - velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hy;
    let wrench_outside_link_1_fx_3 = velocities.minus_velocity_base_wz
        * inertias.minus_inertia_base_hx
        - velocities.minus_velocity_base_wx * inertias.minus_inertia_base_hz;
    let wrench_outside_link_1_fx_5 = velocities.minus_velocity_base_wx
        * inertias.minus_inertia_base_hy
        - velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hx;
    let wrench_link_1_my_0_6_1 = (inertias.inertia_link_1_xx + inertias.inertia_link_1_yy
        + inertias.inertia_link_1_zz) * 0.5;
    let wrench_link_2_my_0_2_1 = (inertias.inertia_link_2_xx + inertias.inertia_link_2_yy
        + inertias.inertia_link_2_zz) * 0.5;
    let wrench_link_3_my_0_2_1 = (inertias.inertia_link_3_xx + inertias.inertia_link_3_yy
        + inertias.inertia_link_3_zz) * 0.5;
    let wrench_link_4_my_0_2_1 = (inertias.inertia_link_4_xx + inertias.inertia_link_4_yy
        + inertias.inertia_link_4_zz) * 0.5;
    let wrench_link_5_my_0_2_1 = (inertias.inertia_link_5_xx + inertias.inertia_link_5_yy
        + inertias.inertia_link_5_zz) * 0.5;
    let wrench_link_6_my_0_2_1 = (inertias.inertia_link_6_xx + inertias.inertia_link_6_yy
        + inertias.inertia_link_6_zz) * 0.5;
    let wrench_link_7_my_2_1 = (inertias.inertia_link_7_xx + inertias.inertia_link_7_yy
        + inertias.inertia_link_7_zz) * 0.5;
    let wrench_outside_link_1_my_5_2 = mu[1] * velocities.minus_velocity_base_vz;
    let wrench_outside_link_1_my_5 = mu[2] * velocities.minus_velocity_base_vy
        - wrench_outside_link_1_my_5_2;
    let wrench_outside_link_1_mx_7_2 = mu[0] * velocities.minus_velocity_base_vz;
    let wrench_outside_link_1_mx_7 = mu[2] * velocities.velocity_base_vx
        + wrench_outside_link_1_mx_7_2;
    let wrench_outside_link_1_mx_5 = mu[0] * velocities.minus_velocity_base_vy
        + mu[1] * velocities.velocity_base_vx;
    let wrench_outside_link_1_my_0 = mu[0] * wrench_outside_link_1_my_0_1
        - common_coupling_torque_d_mu_xi.coupling_torque_0_26;
    let wrench_outside_link_1_mx_2 = mu[1] * wrench_outside_link_1_my_0_1
        - common_coupling_torque_d_mu_xi.coupling_torque_0_28;
    let wrench_outside_link_1_mx_0 = mu[2] * wrench_outside_link_1_my_0_1
        - common_coupling_torque_d_mu_xi.coupling_torque_0_21;
    let wrench_outside_link_1_mx = wrench_outside_link_1_mx_0
        * velocities.minus_velocity_base_wy
        - wrench_outside_link_1_mx_2 * velocities.minus_velocity_base_wz
        + (inertias.minus_inertia_base_hy * wrench_outside_link_1_mx_5
            + inertias.minus_inertia_base_hz * wrench_outside_link_1_mx_7);
    let wrench_outside_link_1_my = wrench_outside_link_1_my_0
        * velocities.minus_velocity_base_wz
        - wrench_outside_link_1_mx_0 * velocities.minus_velocity_base_wx
        - (inertias.minus_inertia_base_hz * wrench_outside_link_1_my_5
            + inertias.minus_inertia_base_hx * wrench_outside_link_1_mx_5);
    let wrench_outside_link_1_mz = wrench_outside_link_1_mx_2
        * velocities.minus_velocity_base_wx
        - wrench_outside_link_1_my_0 * velocities.minus_velocity_base_wy
        + (inertias.minus_inertia_base_hy * wrench_outside_link_1_my_5
            - inertias.minus_inertia_base_hx * wrench_outside_link_1_mx_7);
    let wrench_outside_link_1_fx = wrench_outside_link_1_my_5 * 3.5
        - (mu[2] * wrench_outside_link_1_fx_3 - mu[1] * wrench_outside_link_1_fx_5);
    let wrench_outside_link_1_fy = wrench_outside_link_1_mx_7 * 3.5
        - (mu[0] * wrench_outside_link_1_fx_5 - mu[2] * wrench_outside_link_1_fy_5);
    let wrench_outside_link_2_fx_1 = wrench_outside_link_1_my_5_2
        + mu[2] * velocities.velocity_link_1_vy;
    let wrench_outside_link_2_fy_0 = mu[2] * velocities.velocity_link_1_vx
        + wrench_outside_link_1_mx_7_2;
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
    let wrench_link_2_my_0_5 = mu[1] * velocities.velocity_link_2_vz
        - mu[2] * velocities.velocity_link_2_vy;
    let wrench_link_2_mx_0_7 = mu[2] * velocities.velocity_link_2_vx
        - mu[0] * velocities.velocity_link_2_vz;
    let wrench_link_2_mx_0_5 = mu[0] * velocities.velocity_link_2_vy
        - mu[1] * velocities.velocity_link_2_vx;
    let wrench_link_2_my_0_2 = mu[0] * wrench_link_2_my_0_2_1
        - (inertias.inertia_link_2_xx * mu[0] + inertias.inertia_link_2_xy * mu[1]
            + inertias.inertia_link_2_xz * mu[2]);
    let wrench_link_2_mx_0_0 = mu[1] * wrench_link_2_my_0_2_1
        - (inertias.inertia_link_2_xy * mu[0] + inertias.inertia_link_2_yy * mu[1]
            + inertias.inertia_link_2_yz * mu[2]);
    let wrench_link_2_mx_0_2 = mu[2] * wrench_link_2_my_0_2_1
        - (inertias.inertia_link_2_xz * mu[0] + inertias.inertia_link_2_yz * mu[1]
            + inertias.inertia_link_2_zz * mu[2]);
    let wrench_link_2_mx_0 = wrench_link_2_mx_0_0 * velocities.velocity_link_1_wz
        + wrench_link_2_mx_0_2 * velocities.minus_velocity_link_2_wy
        - (inertias.minus_inertia_link_2_hy * wrench_link_2_mx_0_5
            + inertias.inertia_link_2_hz * wrench_link_2_mx_0_7);
    let wrench_link_2_my_0 = wrench_link_2_mx_0_2 * velocities.velocity_link_2_wx
        - wrench_link_2_my_0_2 * velocities.velocity_link_1_wz
        + (inertias.inertia_link_2_hz * wrench_link_2_my_0_5
            - inertias.inertia_link_2_hx * wrench_link_2_mx_0_5);
    let wrench_link_2_mz_0 = inertias.inertia_link_2_hx * wrench_link_2_mx_0_7
        + inertias.minus_inertia_link_2_hy * wrench_link_2_my_0_5
        - (wrench_link_2_my_0_2 * velocities.minus_velocity_link_2_wy
            + wrench_link_2_mx_0_0 * velocities.velocity_link_2_wx);
    let wrench_link_3_my_0_5 = mu[1] * velocities.velocity_link_3_vz
        - mu[2] * velocities.velocity_link_3_vy;
    let wrench_link_3_mx_0_7 = mu[2] * velocities.velocity_link_3_vx
        - mu[0] * velocities.velocity_link_3_vz;
    let wrench_link_3_mx_0_5 = mu[0] * velocities.velocity_link_3_vy
        - mu[1] * velocities.velocity_link_3_vx;
    let wrench_link_3_my_0_2 = mu[0] * wrench_link_3_my_0_2_1
        - (inertias.inertia_link_3_xx * mu[0] + inertias.inertia_link_3_xy * mu[1]
            + inertias.inertia_link_3_xz * mu[2]);
    let wrench_link_3_mx_0_0 = mu[1] * wrench_link_3_my_0_2_1
        - (inertias.inertia_link_3_xy * mu[0] + inertias.inertia_link_3_yy * mu[1]
            + inertias.inertia_link_3_yz * mu[2]);
    let wrench_link_3_mx_0_2 = mu[2] * wrench_link_3_my_0_2_1
        - (inertias.inertia_link_3_xz * mu[0] + inertias.inertia_link_3_yz * mu[1]
            + inertias.inertia_link_3_zz * mu[2]);
    let wrench_link_3_mx_0 = wrench_link_3_mx_0_0 * velocities.velocity_link_3_wz
        + wrench_link_3_mx_0_2 * velocities.minus_velocity_link_3_wy
        - (inertias.minus_inertia_link_3_hy * wrench_link_3_mx_0_5
            + inertias.inertia_link_3_hz * wrench_link_3_mx_0_7);
    let wrench_link_3_my_0 = wrench_link_3_mx_0_2 * velocities.velocity_link_3_wx
        - wrench_link_3_my_0_2 * velocities.velocity_link_3_wz
        + (inertias.inertia_link_3_hz * wrench_link_3_my_0_5
            - inertias.inertia_link_3_hx * wrench_link_3_mx_0_5);
    let wrench_link_3_mz_0 = inertias.inertia_link_3_hx * wrench_link_3_mx_0_7
        + inertias.minus_inertia_link_3_hy * wrench_link_3_my_0_5
        - (wrench_link_3_my_0_2 * velocities.minus_velocity_link_3_wy
            + wrench_link_3_mx_0_0 * velocities.velocity_link_3_wx);
    let wrench_link_4_my_0_5 = mu[1] * velocities.velocity_link_4_vz
        - mu[2] * velocities.velocity_link_4_vy;
    let wrench_link_4_mx_0_7 = mu[2] * velocities.velocity_link_4_vx
        - mu[0] * velocities.velocity_link_4_vz;
    let wrench_link_4_mx_0_5 = mu[0] * velocities.velocity_link_4_vy
        - mu[1] * velocities.velocity_link_4_vx;
    let wrench_link_4_my_0_2 = mu[0] * wrench_link_4_my_0_2_1
        - (inertias.inertia_link_4_xx * mu[0] + inertias.inertia_link_4_xy * mu[1]
            + inertias.inertia_link_4_xz * mu[2]);
    let wrench_link_4_mx_0_0 = mu[1] * wrench_link_4_my_0_2_1
        - (inertias.inertia_link_4_xy * mu[0] + inertias.inertia_link_4_yy * mu[1]
            + inertias.inertia_link_4_yz * mu[2]);
    let wrench_link_4_mx_0_2 = mu[2] * wrench_link_4_my_0_2_1
        - (inertias.inertia_link_4_xz * mu[0] + inertias.inertia_link_4_yz * mu[1]
            + inertias.inertia_link_4_zz * mu[2]);
    let wrench_link_4_mx_0 = wrench_link_4_mx_0_0 * velocities.velocity_link_4_wz
        - wrench_link_4_mx_0_2 * velocities.velocity_link_4_wy
        + (inertias.inertia_link_4_hy * wrench_link_4_mx_0_5
            - inertias.inertia_link_4_hz * wrench_link_4_mx_0_7);
    let wrench_link_4_my_0 = wrench_link_4_mx_0_2 * velocities.velocity_link_4_wx
        - wrench_link_4_my_0_2 * velocities.velocity_link_4_wz
        + (inertias.inertia_link_4_hz * wrench_link_4_my_0_5
            + inertias.minus_inertia_link_4_hx * wrench_link_4_mx_0_5);
    let wrench_link_4_mz_0 = wrench_link_4_my_0_2 * velocities.velocity_link_4_wy
        - wrench_link_4_mx_0_0 * velocities.velocity_link_4_wx
        - (inertias.minus_inertia_link_4_hx * wrench_link_4_mx_0_7
            + inertias.inertia_link_4_hy * wrench_link_4_my_0_5);
    let wrench_link_5_my_0_5 = mu[1] * velocities.velocity_link_5_vz
        - mu[2] * velocities.velocity_link_5_vy;
    let wrench_link_5_mx_0_7 = mu[2] * velocities.velocity_link_5_vx
        - mu[0] * velocities.velocity_link_5_vz;
    let wrench_link_5_mx_0_5 = mu[0] * velocities.velocity_link_5_vy
        - mu[1] * velocities.velocity_link_5_vx;
    let wrench_link_5_my_0_2 = mu[0] * wrench_link_5_my_0_2_1
        - (inertias.inertia_link_5_xx * mu[0] + inertias.inertia_link_5_xy * mu[1]
            + inertias.inertia_link_5_xz * mu[2]);
    let wrench_link_5_mx_0_0 = mu[1] * wrench_link_5_my_0_2_1
        - (inertias.inertia_link_5_xy * mu[0] + inertias.inertia_link_5_yy * mu[1]
            + inertias.inertia_link_5_yz * mu[2]);
    let wrench_link_5_mx_0_2 = mu[2] * wrench_link_5_my_0_2_1
        - (inertias.inertia_link_5_xz * mu[0] + inertias.inertia_link_5_yz * mu[1]
            + inertias.inertia_link_5_zz * mu[2]);
    let wrench_link_5_mx_0 = wrench_link_5_mx_0_0 * velocities.velocity_link_5_wz
        - wrench_link_5_mx_0_2 * velocities.velocity_link_5_wy
        + (inertias.inertia_link_5_hy * wrench_link_5_mx_0_5
            - inertias.inertia_link_5_hz * wrench_link_5_mx_0_7);
    let wrench_link_5_my_0 = wrench_link_5_mx_0_2 * velocities.velocity_link_5_wx
        - wrench_link_5_my_0_2 * velocities.velocity_link_5_wz
        + (inertias.inertia_link_5_hz * wrench_link_5_my_0_5
            + inertias.minus_inertia_link_5_hx * wrench_link_5_mx_0_5);
    let wrench_link_5_mz_0 = wrench_link_5_my_0_2 * velocities.velocity_link_5_wy
        - wrench_link_5_mx_0_0 * velocities.velocity_link_5_wx
        - (inertias.minus_inertia_link_5_hx * wrench_link_5_mx_0_7
            + inertias.inertia_link_5_hy * wrench_link_5_my_0_5);
    let wrench_link_6_my_0_5 = mu[1] * velocities.velocity_link_6_vz
        - mu[2] * velocities.velocity_link_6_vy;
    let wrench_link_6_mx_0_7 = mu[2] * velocities.velocity_link_6_vx
        - mu[0] * velocities.velocity_link_6_vz;
    let wrench_link_6_mx_0_5 = mu[0] * velocities.velocity_link_6_vy
        - mu[1] * velocities.velocity_link_6_vx;
    let wrench_link_6_my_0_2 = mu[0] * wrench_link_6_my_0_2_1
        - (inertias.inertia_link_6_xx * mu[0] - inertias.minus_inertia_link_6_xy * mu[1]
            + inertias.inertia_link_6_xz * mu[2]);
    let wrench_link_6_mx_0_0 = mu[1] * wrench_link_6_my_0_2_1
        - (inertias.inertia_link_6_yy * mu[1] - inertias.minus_inertia_link_6_xy * mu[0]
            + inertias.inertia_link_6_yz * mu[2]);
    let wrench_link_6_mx_0_2 = mu[2] * wrench_link_6_my_0_2_1
        - (inertias.inertia_link_6_xz * mu[0] + inertias.inertia_link_6_yz * mu[1]
            + inertias.inertia_link_6_zz * mu[2]);
    let wrench_link_6_mx_0 = wrench_link_6_mx_0_0 * velocities.velocity_link_6_wz
        - wrench_link_6_mx_0_2 * velocities.velocity_link_6_wy
        - (inertias.minus_inertia_link_6_hy * wrench_link_6_mx_0_5
            + inertias.inertia_link_6_hz * wrench_link_6_mx_0_7);
    let wrench_link_6_my_0 = wrench_link_6_mx_0_2 * velocities.velocity_link_6_wx
        - wrench_link_6_my_0_2 * velocities.velocity_link_6_wz
        + (inertias.inertia_link_6_hz * wrench_link_6_my_0_5
            + inertias.minus_inertia_link_6_hx * wrench_link_6_mx_0_5);
    let wrench_link_6_mz_0 = wrench_link_6_my_0_2 * velocities.velocity_link_6_wy
        - wrench_link_6_mx_0_0 * velocities.velocity_link_6_wx
        + (inertias.minus_inertia_link_6_hy * wrench_link_6_my_0_5
            - inertias.minus_inertia_link_6_hx * wrench_link_6_mx_0_7);
    let wrench_link_7_my_5 = mu[1] * velocities.velocity_link_7_vz
        - mu[2] * velocities.velocity_link_7_vy;
    let wrench_link_7_mx_7 = mu[2] * velocities.velocity_link_7_vx
        - mu[0] * velocities.velocity_link_7_vz;
    let wrench_link_7_mx_5 = mu[0] * velocities.velocity_link_7_vy
        - mu[1] * velocities.velocity_link_7_vx;
    let wrench_link_7_my_2 = mu[0] * wrench_link_7_my_2_1
        - common_coupling_torque_d_mu_xi.coupling_torque_6_11;
    let wrench_link_7_mx_0 = mu[1] * wrench_link_7_my_2_1
        - common_coupling_torque_d_mu_xi.coupling_torque_6_13;
    let wrench_link_7_mx_2 = mu[2] * wrench_link_7_my_2_1
        - common_coupling_torque_d_mu_xi.coupling_torque_6_6;
    let wrench_link_7_mx = wrench_link_7_mx_0 * velocities.velocity_link_7_wz
        - wrench_link_7_mx_2 * velocities.velocity_link_7_wy
        - (inertias.minus_inertia_link_7_hy * wrench_link_7_mx_5
            + inertias.inertia_link_7_hz * wrench_link_7_mx_7);
    let wrench_link_7_my = wrench_link_7_mx_2 * velocities.velocity_link_7_wx
        - wrench_link_7_my_2 * velocities.velocity_link_7_wz
        + (inertias.inertia_link_7_hz * wrench_link_7_my_5
            + inertias.minus_inertia_link_7_hx * wrench_link_7_mx_5);
    let wrench_link_7_mz = wrench_link_7_my_2 * velocities.velocity_link_7_wy
        - wrench_link_7_mx_0 * velocities.velocity_link_7_wx
        + (inertias.minus_inertia_link_7_hy * wrench_link_7_my_5
            - inertias.minus_inertia_link_7_hx * wrench_link_7_mx_7);
    let wrench_link_6_mx = wrench_link_6_mx_0 + wrench_link_7_mx;
    let wrench_link_6_my = wrench_link_6_my_0 + wrench_link_7_my;
    let wrench_link_6_mz = wrench_link_6_mz_0 + wrench_link_7_mz;
    let wrench_link_5_mx = wrench_link_5_mx_0 + wrench_link_6_mx;
    let wrench_link_5_my = wrench_link_5_my_0 + wrench_link_6_my;
    let wrench_link_5_mz = wrench_link_5_mz_0 + wrench_link_6_mz;
    let wrench_link_4_mx = wrench_link_4_mx_0 + wrench_link_5_mx;
    let wrench_link_4_my = wrench_link_4_my_0 + wrench_link_5_my;
    let wrench_link_4_mz = wrench_link_4_mz_0 + wrench_link_5_mz;
    let wrench_link_3_mx = wrench_link_3_mx_0 + wrench_link_4_mx;
    let wrench_link_3_my = wrench_link_3_my_0 + wrench_link_4_my;
    let wrench_link_3_mz = wrench_link_3_mz_0 + wrench_link_4_mz;
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
            - screws.minus_connection_joint_1_vx * wrench_outside_link_1_fx
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
    let wrench_link_2_fy_0_5 = velocities.velocity_link_1_wz
        * inertias.minus_inertia_link_2_hy
        - velocities.minus_velocity_link_2_wy * inertias.inertia_link_2_hz;
    let wrench_link_2_fx_0_3 = velocities.velocity_link_1_wz * inertias.inertia_link_2_hx
        - velocities.velocity_link_2_wx * inertias.inertia_link_2_hz;
    let wrench_link_2_fx_0_5 = velocities.minus_velocity_link_2_wy
        * inertias.inertia_link_2_hx
        - velocities.velocity_link_2_wx * inertias.minus_inertia_link_2_hy;
    let wrench_link_3_fy_0_5 = velocities.velocity_link_3_wz
        * inertias.minus_inertia_link_3_hy
        - velocities.minus_velocity_link_3_wy * inertias.inertia_link_3_hz;
    let wrench_link_3_fx_0_3 = velocities.velocity_link_3_wz * inertias.inertia_link_3_hx
        - velocities.velocity_link_3_wx * inertias.inertia_link_3_hz;
    let wrench_link_3_fx_0_5 = velocities.minus_velocity_link_3_wy
        * inertias.inertia_link_3_hx
        - velocities.velocity_link_3_wx * inertias.minus_inertia_link_3_hy;
    let wrench_link_4_fy_0_5 = velocities.velocity_link_4_wy * inertias.inertia_link_4_hz
        - velocities.velocity_link_4_wz * inertias.inertia_link_4_hy;
    let wrench_link_4_fx_0_5 = velocities.velocity_link_4_wz
        * inertias.minus_inertia_link_4_hx
        + velocities.velocity_link_4_wx * inertias.inertia_link_4_hz;
    let wrench_link_4_fx_0_3 = velocities.velocity_link_4_wx * inertias.inertia_link_4_hy
        + velocities.velocity_link_4_wy * inertias.minus_inertia_link_4_hx;
    let wrench_link_5_fy_0_5 = velocities.velocity_link_5_wy * inertias.inertia_link_5_hz
        - velocities.velocity_link_5_wz * inertias.inertia_link_5_hy;
    let wrench_link_5_fx_0_5 = velocities.velocity_link_5_wz
        * inertias.minus_inertia_link_5_hx
        + velocities.velocity_link_5_wx * inertias.inertia_link_5_hz;
    let wrench_link_5_fx_0_3 = velocities.velocity_link_5_wx * inertias.inertia_link_5_hy
        + velocities.velocity_link_5_wy * inertias.minus_inertia_link_5_hx;
    let wrench_link_6_fy_0_5 = velocities.velocity_link_6_wy * inertias.inertia_link_6_hz
        + velocities.velocity_link_6_wz * inertias.minus_inertia_link_6_hy;
    let wrench_link_6_fx_0_5 = velocities.velocity_link_6_wz
        * inertias.minus_inertia_link_6_hx
        + velocities.velocity_link_6_wx * inertias.inertia_link_6_hz;
    let wrench_link_6_fx_0_3 = velocities.velocity_link_6_wy
        * inertias.minus_inertia_link_6_hx
        - velocities.velocity_link_6_wx * inertias.minus_inertia_link_6_hy;
    let wrench_link_7_fy_5 = velocities.velocity_link_7_wy * inertias.inertia_link_7_hz
        + velocities.velocity_link_7_wz * inertias.minus_inertia_link_7_hy;
    let wrench_link_7_fx_5 = velocities.velocity_link_7_wz
        * inertias.minus_inertia_link_7_hx
        + velocities.velocity_link_7_wx * inertias.inertia_link_7_hz;
    let wrench_link_7_fx_3 = velocities.velocity_link_7_wy
        * inertias.minus_inertia_link_7_hx
        - velocities.velocity_link_7_wx * inertias.minus_inertia_link_7_hy;
    let minus_wrench_outside_link_1_fz = wrench_outside_link_1_mx_5 * 3.5
        + (mu[1] * wrench_outside_link_1_fy_5 - mu[0] * wrench_outside_link_1_fx_3);
    let wrench_link_2_fx_0 = wrench_link_2_my_0_5 * 2.0
        - (mu[2] * wrench_link_2_fx_0_3 - mu[1] * wrench_link_2_fx_0_5);
    let wrench_link_2_fy_0 = wrench_link_2_mx_0_7 * 2.0
        - (mu[0] * wrench_link_2_fx_0_5 - mu[2] * wrench_link_2_fy_0_5);
    let wrench_link_2_fz_0 = wrench_link_2_mx_0_5 * 2.0
        - (mu[1] * wrench_link_2_fy_0_5 - mu[0] * wrench_link_2_fx_0_3);
    let wrench_link_3_fx_0 = wrench_link_3_my_0_5 * 2.0
        - (mu[2] * wrench_link_3_fx_0_3 - mu[1] * wrench_link_3_fx_0_5);
    let wrench_link_3_fy_0 = wrench_link_3_mx_0_7 * 2.0
        - (mu[0] * wrench_link_3_fx_0_5 - mu[2] * wrench_link_3_fy_0_5);
    let wrench_link_3_fz_0 = wrench_link_3_mx_0_5 * 2.0
        - (mu[1] * wrench_link_3_fy_0_5 - mu[0] * wrench_link_3_fx_0_3);
    let wrench_link_4_fx_0 = wrench_link_4_my_0_5 * 2.0
        + (mu[1] * wrench_link_4_fx_0_3 + mu[2] * wrench_link_4_fx_0_5);
    let wrench_link_4_fy_0 = wrench_link_4_mx_0_7 * 2.0
        - (mu[0] * wrench_link_4_fx_0_3 - mu[2] * wrench_link_4_fy_0_5);
    let wrench_link_4_fz_0 = wrench_link_4_mx_0_5 * 2.0
        - (mu[0] * wrench_link_4_fx_0_5 + mu[1] * wrench_link_4_fy_0_5);
    let wrench_link_5_fx_0 = wrench_link_5_my_0_5 * 2.0
        + (mu[1] * wrench_link_5_fx_0_3 + mu[2] * wrench_link_5_fx_0_5);
    let wrench_link_5_fy_0 = wrench_link_5_mx_0_7 * 2.0
        - (mu[0] * wrench_link_5_fx_0_3 - mu[2] * wrench_link_5_fy_0_5);
    let wrench_link_5_fz_0 = wrench_link_5_mx_0_5 * 2.0
        - (mu[0] * wrench_link_5_fx_0_5 + mu[1] * wrench_link_5_fy_0_5);
    let wrench_link_6_fx_0 = wrench_link_6_my_0_5 * 2.0
        + (mu[1] * wrench_link_6_fx_0_3 + mu[2] * wrench_link_6_fx_0_5);
    let wrench_link_6_fy_0 = wrench_link_6_mx_0_7 * 2.0
        - (mu[0] * wrench_link_6_fx_0_3 - mu[2] * wrench_link_6_fy_0_5);
    let wrench_link_6_fz_0 = wrench_link_6_mx_0_5 * 2.0
        - (mu[0] * wrench_link_6_fx_0_5 + mu[1] * wrench_link_6_fy_0_5);
    let wrench_link_7_fx = wrench_link_7_my_5 * 2.0
        + (mu[1] * wrench_link_7_fx_3 + mu[2] * wrench_link_7_fx_5);
    let wrench_link_7_fy = wrench_link_7_mx_7 * 2.0
        - (mu[0] * wrench_link_7_fx_3 - mu[2] * wrench_link_7_fy_5);
    let wrench_link_7_fz = wrench_link_7_mx_5 * 2.0
        - (mu[0] * wrench_link_7_fx_5 + mu[1] * wrench_link_7_fy_5);
    let wrench_link_6_fx = wrench_link_6_fx_0 + wrench_link_7_fx;
    let wrench_link_6_fy = wrench_link_6_fy_0 + wrench_link_7_fy;
    let wrench_link_6_fz = wrench_link_6_fz_0 + wrench_link_7_fz;
    let wrench_link_5_fx = wrench_link_5_fx_0 + wrench_link_6_fx;
    let wrench_link_5_fy = wrench_link_5_fy_0 + wrench_link_6_fy;
    let wrench_link_5_fz = wrench_link_5_fz_0 + wrench_link_6_fz;
    let wrench_link_4_fx = wrench_link_4_fx_0 + wrench_link_5_fx;
    let wrench_link_4_fy = wrench_link_4_fy_0 + wrench_link_5_fy;
    let wrench_link_4_fz = wrench_link_4_fz_0 + wrench_link_5_fz;
    let wrench_link_3_fx = wrench_link_3_fx_0 + wrench_link_4_fx;
    let wrench_link_3_fy = wrench_link_3_fy_0 + wrench_link_4_fy;
    let wrench_link_3_fz = wrench_link_3_fz_0 + wrench_link_4_fz;
    let wrench_link_2_fx = wrench_link_2_fx_0 + wrench_link_3_fx;
    let wrench_link_2_fy = wrench_link_2_fy_0 + wrench_link_3_fy;
    let wrench_link_2_fz = wrench_link_2_fz_0 + wrench_link_3_fz;
    let wrench_outside_link_2_mx = wrench_link_1_mx_0 + wrench_outside_link_1_mx;
    let wrench_outside_link_2_my = wrench_link_1_my_0 + wrench_outside_link_1_my;
    let wrench_outside_link_2_mz = wrench_link_1_mz_0 + wrench_outside_link_1_mz;
    let wrench_outside_link_2_fx = wrench_outside_link_1_fx
        - (wrench_outside_link_2_fx_1 * 2.0
            + (mu[1] * wrench_outside_link_2_fx_4 + mu[2] * wrench_outside_link_2_fx_6));
    let wrench_outside_link_2_fy = wrench_outside_link_2_fy_0 * 2.0
        - (mu[2] * wrench_outside_link_2_fy_3 - mu[0] * wrench_outside_link_2_fx_4)
        + wrench_outside_link_1_fy;
    let wrench_outside_link_2_fz = wrench_outside_link_2_fz_0 * 2.0
        + (mu[0] * wrench_outside_link_2_fx_6 + mu[1] * wrench_outside_link_2_fy_3)
        - minus_wrench_outside_link_1_fz;
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
    let wrench_outside_link_3_fx = wrench_link_2_fx_0 + wrench_outside_link_2_fx;
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
    let wrench_outside_link_4_mx = wrench_link_3_mx_0 + wrench_outside_link_3_mx;
    let wrench_outside_link_4_my = wrench_link_3_my_0 + wrench_outside_link_3_my;
    let wrench_outside_link_4_mz = wrench_link_3_mz_0 + wrench_outside_link_3_mz;
    let wrench_outside_link_4_fx = wrench_link_3_fx_0 + wrench_outside_link_3_fx;
    let wrench_outside_link_4_fy = wrench_link_3_fy_0 + wrench_outside_link_3_fy;
    let wrench_outside_link_4_fz = wrench_link_3_fz_0 + wrench_outside_link_3_fz;
    let d_mu_xi_9_2 = reactions.reaction_joint_4_wx * wrench_link_4_mx
        + reactions.reaction_joint_4_wy * wrench_link_4_my
        + reactions.reaction_joint_4_wz * wrench_link_4_mz
        + reactions.reaction_joint_4_vx * wrench_link_4_fx
        + reactions.reaction_joint_4_vy * wrench_link_4_fy
        - reactions.minus_reaction_joint_4_vz * wrench_link_4_fz
        - (screws.connection_joint_4_wx * wrench_outside_link_4_mx
            + screws.connection_joint_4_wy * wrench_outside_link_4_my
            + screws.connection_joint_4_wz * wrench_outside_link_4_mz
            + screws.connection_joint_4_vx * wrench_outside_link_4_fx
            + screws.connection_joint_4_vy * wrench_outside_link_4_fy
            + screws.connection_joint_4_vz * wrench_outside_link_4_fz);
    d_mu_xi[9] = common_coupling_torque_d_mu_xi.coupling_torque_3 - d_mu_xi_9_2
        - d_mu_xi_9_2 + 0.0;
    let wrench_outside_link_5_mx = wrench_link_4_mx_0 + wrench_outside_link_4_mx;
    let wrench_outside_link_5_my = wrench_link_4_my_0 + wrench_outside_link_4_my;
    let wrench_outside_link_5_mz = wrench_link_4_mz_0 + wrench_outside_link_4_mz;
    let wrench_outside_link_5_fx = wrench_link_4_fx_0 + wrench_outside_link_4_fx;
    let wrench_outside_link_5_fy = wrench_link_4_fy_0 + wrench_outside_link_4_fy;
    let wrench_outside_link_5_fz = wrench_link_4_fz_0 + wrench_outside_link_4_fz;
    let d_mu_xi_10_2 = reactions.reaction_joint_5_wx * wrench_link_5_mx
        + reactions.reaction_joint_5_wy * wrench_link_5_my
        + reactions.reaction_joint_5_wz * wrench_link_5_mz
        + reactions.reaction_joint_5_vx * wrench_link_5_fx
        + reactions.reaction_joint_5_vy * wrench_link_5_fy
        + reactions.reaction_joint_5_vz * wrench_link_5_fz
        - (screws.connection_joint_5_wx * wrench_outside_link_5_mx
            + screws.connection_joint_5_wy * wrench_outside_link_5_my
            + screws.connection_joint_5_wz * wrench_outside_link_5_mz
            + screws.connection_joint_5_vx * wrench_outside_link_5_fx
            + screws.connection_joint_5_vy * wrench_outside_link_5_fy
            + screws.connection_joint_5_vz * wrench_outside_link_5_fz);
    d_mu_xi[10] = common_coupling_torque_d_mu_xi.coupling_torque_4 - d_mu_xi_10_2
        - d_mu_xi_10_2 + 0.0;
    let wrench_outside_link_6_mx = wrench_link_5_mx_0 + wrench_outside_link_5_mx;
    let wrench_outside_link_6_my = wrench_link_5_my_0 + wrench_outside_link_5_my;
    let wrench_outside_link_6_mz = wrench_link_5_mz_0 + wrench_outside_link_5_mz;
    let wrench_outside_link_6_fx = wrench_link_5_fx_0 + wrench_outside_link_5_fx;
    let wrench_outside_link_6_fy = wrench_link_5_fy_0 + wrench_outside_link_5_fy;
    let wrench_outside_link_6_fz = wrench_link_5_fz_0 + wrench_outside_link_5_fz;
    let d_mu_xi_11_2 = reactions.reaction_joint_6_wx * wrench_link_6_mx
        + reactions.reaction_joint_6_wy * wrench_link_6_my
        + reactions.reaction_joint_6_wz * wrench_link_6_mz
        + reactions.reaction_joint_6_vx * wrench_link_6_fx
        + reactions.reaction_joint_6_vy * wrench_link_6_fy
        + reactions.reaction_joint_6_vz * wrench_link_6_fz
        - (screws.connection_joint_6_wx * wrench_outside_link_6_mx
            + screws.connection_joint_6_wy * wrench_outside_link_6_my
            + screws.connection_joint_6_wz * wrench_outside_link_6_mz
            + screws.connection_joint_6_vx * wrench_outside_link_6_fx
            + screws.connection_joint_6_vy * wrench_outside_link_6_fy
            + screws.connection_joint_6_vz * wrench_outside_link_6_fz);
    d_mu_xi[11] = common_coupling_torque_d_mu_xi.coupling_torque_5 - d_mu_xi_11_2
        - d_mu_xi_11_2 + 0.0;
    let wrench_outside_link_7_mx = wrench_link_6_mx_0 + wrench_outside_link_6_mx;
    let wrench_outside_link_7_my = wrench_link_6_my_0 + wrench_outside_link_6_my;
    let wrench_outside_link_7_mz = wrench_link_6_mz_0 + wrench_outside_link_6_mz;
    let wrench_outside_link_7_fx = wrench_link_6_fx_0 + wrench_outside_link_6_fx;
    let wrench_outside_link_7_fy = wrench_link_6_fy_0 + wrench_outside_link_6_fy;
    let wrench_outside_link_7_fz = wrench_link_6_fz_0 + wrench_outside_link_6_fz;
    let d_mu_xi_12_2 = reactions.reaction_joint_7_wx * wrench_link_7_mx
        + reactions.reaction_joint_7_wy * wrench_link_7_my
        + reactions.reaction_joint_7_wz * wrench_link_7_mz
        + reactions.reaction_joint_7_vx * wrench_link_7_fx
        + reactions.reaction_joint_7_vy * wrench_link_7_fy
        + reactions.reaction_joint_7_vz * wrench_link_7_fz
        - (screws.connection_joint_7_wx * wrench_outside_link_7_mx
            + screws.connection_joint_7_wy * wrench_outside_link_7_my
            + screws.connection_joint_7_wz * wrench_outside_link_7_mz
            + screws.connection_joint_7_vx * wrench_outside_link_7_fx
            + screws.connection_joint_7_vy * wrench_outside_link_7_fy
            + screws.connection_joint_7_vz * wrench_outside_link_7_fz);
    d_mu_xi[12] = common_coupling_torque_d_mu_xi.coupling_torque_6 - d_mu_xi_12_2
        - d_mu_xi_12_2 + 0.0;
}
/// D_q̇ ξ = [½ P(q̇) μ; Γ'_q(q̇) q̇], without forming D_q̇.
///
/// - `q`: shape (7; rad, m)
/// - `qd`: shape velocity (7; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `d_qdot_xi`: D_q̇ ξ, D_q̇ on ξ, base frame (13; N·m, N)
///
/// 3403 operations: 1668 + −, 1732 ×, 3 ÷; 7 sin cos; about 40.2 KiB of code.
pub fn d_qdot_xi(q: &[f64; 7], qd: &[f64; 7], mu: &[f64; 6], d_qdot_xi: &mut [f64; 13]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
    let d_qdot_xi_0_0_1 = inertias.composite_link_1_xy + inertias.composite_link_1_xy;
    let d_qdot_xi_0_0_0_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
    let d_qdot_xi_0_0_0 = d_qdot_xi_0_0_0_1 + d_qdot_xi_0_0_0_1;
    let d_qdot_xi_0_0_23 = mu[4] + (mu[2] * poses.com_x - mu[0] * poses.com_z);
    let d_qdot_xi_0_0_21 = mu[5] + (mu[0] * poses.com_y - mu[1] * poses.com_x);
    let d_qdot_xi_0_0_16 = (inertias.composite_link_1_xx - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 - inertias.inside_joint_1_mz_1_1)) * qd[0]
        - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_x_0_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_0_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_0_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_0_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_0_1_0 * qd[6];
    let d_qdot_xi_0_0_18 = common_d_mu_and_7_more.three_joint_2_x_1_0 * qd[1]
        - screws.inside_joint_1_my * qd[0]
        + common_d_mu_and_7_more.three_joint_3_x_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_1_0 * qd[6];
    let d_qdot_xi_0_1_1 = velocities.velocity_base_vx * 17.5;
    let d_qdot_xi_0_0_20 = velocities.minus_velocity_base_vy * 17.5;
    let d_qdot_xi_0_0_22 = velocities.minus_velocity_base_vz * 17.5;
    let d_qdot_xi_0_0 = (((d_qdot_xi_0_0_0 - d_qdot_xi_0_0_1) * qd[0]
        + common_d_mu_and_7_more.three_joint_2_x_0_0_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_x_0_0_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_0_0_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_0_0_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_0_0_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_0_0_0 * qd[6]) * mu[0]
        + d_qdot_xi_0_0_16 * mu[1] + d_qdot_xi_0_0_18 * mu[2]
        + (d_qdot_xi_0_0_20 * d_qdot_xi_0_0_21 - d_qdot_xi_0_0_22 * d_qdot_xi_0_0_23))
        * 0.5;
    let d_qdot_xi_0_1 = (mu[2] * d_qdot_xi_0_1_1 + mu[0] * d_qdot_xi_0_0_22) * 0.5;
    let d_qdot_xi_0_3 = (mu[0] * d_qdot_xi_0_0_20 + mu[1] * d_qdot_xi_0_1_1) * 0.5;
    // D_q\u{307} ξ
    d_qdot_xi[0] = d_qdot_xi_0_0
        + (d_qdot_xi_0_1 * poses.com_z + d_qdot_xi_0_3 * poses.com_y) + 0.0;
    let d_qdot_xi_1_0_3_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let d_qdot_xi_1_0_3 = d_qdot_xi_1_0_3_1 + d_qdot_xi_1_0_3_1;
    let d_qdot_xi_1_0_21 = mu[3] + (mu[1] * poses.com_z - mu[2] * poses.com_y);
    let d_qdot_xi_1_0_18 = screws.inside_joint_1_mx * qd[0]
        + common_d_mu_and_7_more.three_joint_2_y_1_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * qd[6];
    let d_qdot_xi_1_0 = (d_qdot_xi_0_0_16 * mu[0]
        + ((d_qdot_xi_0_0_1 - d_qdot_xi_1_0_3) * qd[0]
            + common_d_mu_and_7_more.three_joint_2_y_0_0_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_y_0_1_0 * qd[2]
            + common_d_mu_and_7_more.three_joint_4_y_0_1_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_y_0_1_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_y_0_1_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_y_0_1_0 * qd[6]) * mu[1]
        + d_qdot_xi_1_0_18 * mu[2]
        + (d_qdot_xi_0_0_22 * d_qdot_xi_1_0_21 + d_qdot_xi_0_1_1 * d_qdot_xi_0_0_21))
        * 0.5;
    let d_qdot_xi_1_1 = (mu[1] * d_qdot_xi_0_0_22 - mu[2] * d_qdot_xi_0_0_20) * 0.5;
    d_qdot_xi[1] = d_qdot_xi_1_0
        + (d_qdot_xi_1_1 * poses.com_z - d_qdot_xi_0_3 * poses.com_x) + 0.0;
    let d_qdot_xi_2 = (d_qdot_xi_0_0_18 * mu[0] + d_qdot_xi_1_0_18 * mu[1]
        + ((d_qdot_xi_0_0_0 - d_qdot_xi_1_0_3) * qd[0]
            + common_d_mu_and_7_more.three_joint_2_z_1_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_z_1_0 * qd[2]
            - common_d_mu_and_7_more.three_joint_4_z_1_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_z_1_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_z_1_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_z_1_0 * qd[6]) * mu[2]
        - (d_qdot_xi_0_1_1 * d_qdot_xi_0_0_23 + d_qdot_xi_0_0_20 * d_qdot_xi_1_0_21))
        * 0.5 - (d_qdot_xi_1_1 * poses.com_y + d_qdot_xi_0_1 * poses.com_x);
    d_qdot_xi[2] = d_qdot_xi_2 + 0.0;
    d_qdot_xi[3] = d_qdot_xi_1_1 + 0.0;
    d_qdot_xi[4] = 0.0 - d_qdot_xi_0_1;
    d_qdot_xi[5] = d_qdot_xi_0_3 + 0.0;
    let minus_wrench_outside_link_1_my_6 = velocities.velocity_base_vx * 3.5
        + (velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hz
            - velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hy);
    let minus_wrench_outside_link_1_mx_6 = velocities.minus_velocity_base_wz
        * inertias.minus_inertia_base_hx
        - velocities.minus_velocity_base_wx * inertias.minus_inertia_base_hz
        - velocities.minus_velocity_base_vy * 3.5;
    let minus_wrench_outside_link_1_mx_4 = velocities.minus_velocity_base_wx
        * inertias.minus_inertia_base_hy
        - velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hx
        - velocities.minus_velocity_base_vz * 3.5;
    let wrench_outside_link_2_fy_6 = velocities.velocity_link_1_vx * 2.0
        - (velocities.minus_velocity_base_wy * inertias.inertia_link_1_hz
            + velocities.velocity_link_1_wz * inertias.inertia_link_1_hy);
    let wrench_outside_link_2_fx_4 = velocities.velocity_link_1_vy * 2.0
        + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hz
            - velocities.velocity_link_1_wz * inertias.minus_inertia_link_1_hx);
    let wrench_outside_link_2_fx_6 = velocities.minus_velocity_base_vz * 2.0
        + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hy
            + velocities.minus_velocity_base_wy * inertias.minus_inertia_link_1_hx);
    let wrench_link_2_my_0_16 = velocities.velocity_link_2_vx * 2.0
        + (velocities.velocity_link_1_wz * inertias.minus_inertia_link_2_hy
            - velocities.minus_velocity_link_2_wy * inertias.inertia_link_2_hz);
    let wrench_link_2_mx_0_14 = velocities.velocity_link_2_vy * 2.0
        + (velocities.velocity_link_1_wz * inertias.inertia_link_2_hx
            - velocities.velocity_link_2_wx * inertias.inertia_link_2_hz);
    let wrench_link_2_mx_0_16 = velocities.velocity_link_2_vz * 2.0
        + (velocities.minus_velocity_link_2_wy * inertias.inertia_link_2_hx
            - velocities.velocity_link_2_wx * inertias.minus_inertia_link_2_hy);
    let wrench_link_3_my_0_16 = velocities.velocity_link_3_vx * 2.0
        + (velocities.velocity_link_3_wz * inertias.minus_inertia_link_3_hy
            - velocities.minus_velocity_link_3_wy * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_0_14 = velocities.velocity_link_3_vy * 2.0
        + (velocities.velocity_link_3_wz * inertias.inertia_link_3_hx
            - velocities.velocity_link_3_wx * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_0_16 = velocities.velocity_link_3_vz * 2.0
        + (velocities.minus_velocity_link_3_wy * inertias.inertia_link_3_hx
            - velocities.velocity_link_3_wx * inertias.minus_inertia_link_3_hy);
    let wrench_link_4_my_0_16 = velocities.velocity_link_4_vx * 2.0
        + (velocities.velocity_link_4_wy * inertias.inertia_link_4_hz
            - velocities.velocity_link_4_wz * inertias.inertia_link_4_hy);
    let wrench_link_4_mx_0_14 = velocities.velocity_link_4_vy * 2.0
        - (velocities.velocity_link_4_wz * inertias.minus_inertia_link_4_hx
            + velocities.velocity_link_4_wx * inertias.inertia_link_4_hz);
    let wrench_link_4_mx_0_16 = velocities.velocity_link_4_vz * 2.0
        + (velocities.velocity_link_4_wx * inertias.inertia_link_4_hy
            + velocities.velocity_link_4_wy * inertias.minus_inertia_link_4_hx);
    let wrench_link_5_my_0_16 = velocities.velocity_link_5_vx * 2.0
        + (velocities.velocity_link_5_wy * inertias.inertia_link_5_hz
            - velocities.velocity_link_5_wz * inertias.inertia_link_5_hy);
    let wrench_link_5_mx_0_14 = velocities.velocity_link_5_vy * 2.0
        - (velocities.velocity_link_5_wz * inertias.minus_inertia_link_5_hx
            + velocities.velocity_link_5_wx * inertias.inertia_link_5_hz);
    let wrench_link_5_mx_0_16 = velocities.velocity_link_5_vz * 2.0
        + (velocities.velocity_link_5_wx * inertias.inertia_link_5_hy
            + velocities.velocity_link_5_wy * inertias.minus_inertia_link_5_hx);
    let wrench_link_6_my_0_16 = velocities.velocity_link_6_vx * 2.0
        + (velocities.velocity_link_6_wy * inertias.inertia_link_6_hz
            + velocities.velocity_link_6_wz * inertias.minus_inertia_link_6_hy);
    let wrench_link_6_mx_0_14 = velocities.velocity_link_6_vy * 2.0
        - (velocities.velocity_link_6_wz * inertias.minus_inertia_link_6_hx
            + velocities.velocity_link_6_wx * inertias.inertia_link_6_hz);
    let wrench_link_6_mx_0_16 = velocities.velocity_link_6_vz * 2.0
        + (velocities.velocity_link_6_wy * inertias.minus_inertia_link_6_hx
            - velocities.velocity_link_6_wx * inertias.minus_inertia_link_6_hy);
    let wrench_link_7_my_16 = velocities.velocity_link_7_vx * 2.0
        + (velocities.velocity_link_7_wy * inertias.inertia_link_7_hz
            + velocities.velocity_link_7_wz * inertias.minus_inertia_link_7_hy);
    let wrench_link_7_mx_14 = velocities.velocity_link_7_vy * 2.0
        - (velocities.velocity_link_7_wz * inertias.minus_inertia_link_7_hx
            + velocities.velocity_link_7_wx * inertias.inertia_link_7_hz);
    let wrench_link_7_mx_16 = velocities.velocity_link_7_vz * 2.0
        + (velocities.velocity_link_7_wy * inertias.minus_inertia_link_7_hx
            - velocities.velocity_link_7_wx * inertias.minus_inertia_link_7_hy);
    let minus_twist_link_1_wx = velocities.minus_velocity_base_wy * qd[0];
    let twist_link_1_wy = velocities.minus_velocity_base_wx * qd[0];
    let twist_link_1_vx = (velocities.velocity_link_1_vy
        - velocities.velocity_link_1_wz * poses.minus_origin_base_x) * qd[0];
    let minus_twist_link_1_vy = (velocities.velocity_link_1_wz
        * poses.minus_origin_base_y + velocities.velocity_link_1_vx) * qd[0];
    let minus_twist_link_1_vz = (velocities.minus_velocity_base_wx
        * poses.minus_origin_base_x
        + velocities.minus_velocity_base_wy * poses.minus_origin_base_y) * qd[0];
    let twist_link_2_wz = (velocities.minus_velocity_link_2_wy * poses.sin_joint_1
        - velocities.velocity_link_2_wx * poses.cos_joint_1) * qd[1];
    let twist_link_2_wx = velocities.velocity_link_1_wz * poses.cos_joint_1 * qd[1]
        - minus_twist_link_1_wx;
    let twist_link_2_wy = twist_link_1_wy
        + velocities.velocity_link_1_wz * poses.sin_joint_1 * qd[1];
    let twist_link_2_vx = twist_link_1_vx
        + (velocities.velocity_link_2_vz * poses.cos_joint_1
            - (velocities.minus_velocity_link_2_wy * screws.screw_joint_2_vz
                + velocities.velocity_link_1_wz * screws.screw_joint_2_vy)) * qd[1];
    let twist_link_2_vy = (velocities.velocity_link_1_wz * screws.screw_joint_2_vx
        - velocities.velocity_link_2_wx * screws.screw_joint_2_vz
        + velocities.velocity_link_2_vz * poses.sin_joint_1) * qd[1]
        - minus_twist_link_1_vy;
    let twist_link_2_vz = (velocities.velocity_link_2_wx * screws.screw_joint_2_vy
        + velocities.minus_velocity_link_2_wy * screws.screw_joint_2_vx
        - (velocities.velocity_link_2_vx * poses.cos_joint_1
            + velocities.velocity_link_2_vy * poses.sin_joint_1)) * qd[1]
        - minus_twist_link_1_vz;
    let twist_link_3_wx = twist_link_2_wx
        + (velocities.velocity_link_3_wz * poses.minus_rotation_link_2_yy
            - velocities.minus_velocity_link_3_wy * poses.cos_joint_2) * qd[2];
    let twist_link_3_wy = twist_link_2_wy
        - (velocities.velocity_link_3_wz * poses.minus_rotation_link_2_xy
            + velocities.velocity_link_3_wx * poses.cos_joint_2) * qd[2];
    let twist_link_3_wz = twist_link_2_wz
        - (velocities.velocity_link_3_wx * poses.minus_rotation_link_2_yy
            + velocities.minus_velocity_link_3_wy * poses.minus_rotation_link_2_xy)
            * qd[2];
    let twist_link_3_vx = twist_link_2_vx
        + (velocities.velocity_link_3_vy * poses.cos_joint_2
            + velocities.velocity_link_3_vz * poses.minus_rotation_link_2_yy
            - (velocities.minus_velocity_link_3_wy * screws.screw_joint_3_vz
                + velocities.velocity_link_3_wz * screws.screw_joint_3_vy)) * qd[2];
    let twist_link_3_vy = twist_link_2_vy
        + (velocities.velocity_link_3_wz * screws.screw_joint_3_vx
            - velocities.velocity_link_3_wx * screws.screw_joint_3_vz
            - (velocities.velocity_link_3_vz * poses.minus_rotation_link_2_xy
                + velocities.velocity_link_3_vx * poses.cos_joint_2)) * qd[2];
    let twist_link_3_vz = twist_link_2_vz
        + (velocities.velocity_link_3_wx * screws.screw_joint_3_vy
            + velocities.minus_velocity_link_3_wy * screws.screw_joint_3_vx
            + (velocities.velocity_link_3_vy * poses.minus_rotation_link_2_xy
                - velocities.velocity_link_3_vx * poses.minus_rotation_link_2_yy))
            * qd[2];
    let twist_link_4_wx = twist_link_3_wx
        - (velocities.velocity_link_4_wy * poses.minus_rotation_link_3_zy
            + velocities.velocity_link_4_wz * poses.rotation_link_3_yy) * qd[3];
    let twist_link_4_wy = twist_link_3_wy
        + (velocities.velocity_link_4_wx * poses.minus_rotation_link_3_zy
            - velocities.velocity_link_4_wz * poses.minus_rotation_link_3_xy) * qd[3];
    let twist_link_4_wz = twist_link_3_wz
        + (velocities.velocity_link_4_wx * poses.rotation_link_3_yy
            + velocities.velocity_link_4_wy * poses.minus_rotation_link_3_xy) * qd[3];
    let twist_link_4_vx = twist_link_3_vx
        + (velocities.velocity_link_4_wz * screws.minus_screw_joint_4_vy
            - velocities.velocity_link_4_wy * screws.minus_screw_joint_4_vz
            - (velocities.velocity_link_4_vy * poses.minus_rotation_link_3_zy
                + velocities.velocity_link_4_vz * poses.rotation_link_3_yy)) * qd[3];
    let twist_link_4_vy = twist_link_3_vy
        + (velocities.velocity_link_4_wz * screws.screw_joint_4_vx
            + velocities.velocity_link_4_wx * screws.minus_screw_joint_4_vz
            + (velocities.velocity_link_4_vx * poses.minus_rotation_link_3_zy
                - velocities.velocity_link_4_vz * poses.minus_rotation_link_3_xy))
            * qd[3];
    let twist_link_4_vz = twist_link_3_vz
        + (velocities.velocity_link_4_vx * poses.rotation_link_3_yy
            + velocities.velocity_link_4_vy * poses.minus_rotation_link_3_xy
            - (velocities.velocity_link_4_wx * screws.minus_screw_joint_4_vy
                + velocities.velocity_link_4_wy * screws.screw_joint_4_vx)) * qd[3];
    let twist_link_5_wx = twist_link_4_wx
        + (velocities.velocity_link_5_wy * poses.rotation_link_5_zz
            + velocities.velocity_link_5_wz * poses.rotation_link_4_yy) * qd[4];
    let twist_link_5_wy = twist_link_4_wy
        - (velocities.velocity_link_5_wz * poses.rotation_link_4_xy
            + velocities.velocity_link_5_wx * poses.rotation_link_5_zz) * qd[4];
    let twist_link_5_wz = twist_link_4_wz
        + (velocities.velocity_link_5_wy * poses.rotation_link_4_xy
            - velocities.velocity_link_5_wx * poses.rotation_link_4_yy) * qd[4];
    let twist_link_5_vx = twist_link_4_vx
        + (velocities.velocity_link_5_wy * screws.screw_joint_5_vz
            - velocities.velocity_link_5_wz * screws.screw_joint_5_vy
            + (velocities.velocity_link_5_vy * poses.rotation_link_5_zz
                + velocities.velocity_link_5_vz * poses.rotation_link_4_yy)) * qd[4];
    let twist_link_5_vy = twist_link_4_vy
        + (velocities.velocity_link_5_wz * screws.screw_joint_5_vx
            - velocities.velocity_link_5_wx * screws.screw_joint_5_vz
            - (velocities.velocity_link_5_vz * poses.rotation_link_4_xy
                + velocities.velocity_link_5_vx * poses.rotation_link_5_zz)) * qd[4];
    let twist_link_5_vz = twist_link_4_vz
        + (velocities.velocity_link_5_wx * screws.screw_joint_5_vy
            - velocities.velocity_link_5_wy * screws.screw_joint_5_vx
            + (velocities.velocity_link_5_vy * poses.rotation_link_4_xy
                - velocities.velocity_link_5_vx * poses.rotation_link_4_yy)) * qd[4];
    let twist_link_6_wx = twist_link_5_wx
        + (velocities.velocity_link_6_wy * poses.rotation_link_6_zz
            + velocities.velocity_link_6_wz * poses.rotation_link_5_yy) * qd[5];
    let twist_link_6_wy = twist_link_5_wy
        + (velocities.velocity_link_6_wz * poses.rotation_link_6_xz
            - velocities.velocity_link_6_wx * poses.rotation_link_6_zz) * qd[5];
    let twist_link_6_wz = twist_link_5_wz
        - (velocities.velocity_link_6_wx * poses.rotation_link_5_yy
            + velocities.velocity_link_6_wy * poses.rotation_link_6_xz) * qd[5];
    let twist_link_6_vx = twist_link_5_vx
        + (velocities.velocity_link_6_wy * screws.screw_joint_6_vz
            - velocities.velocity_link_6_wz * screws.screw_joint_6_vy
            + (velocities.velocity_link_6_vy * poses.rotation_link_6_zz
                + velocities.velocity_link_6_vz * poses.rotation_link_5_yy)) * qd[5];
    let twist_link_6_vy = twist_link_5_vy
        + (velocities.velocity_link_6_wz * screws.screw_joint_6_vx
            - velocities.velocity_link_6_wx * screws.screw_joint_6_vz
            + (velocities.velocity_link_6_vz * poses.rotation_link_6_xz
                - velocities.velocity_link_6_vx * poses.rotation_link_6_zz)) * qd[5];
    let twist_link_6_vz = twist_link_5_vz
        + (velocities.velocity_link_6_wx * screws.screw_joint_6_vy
            - velocities.velocity_link_6_wy * screws.screw_joint_6_vx
            - (velocities.velocity_link_6_vx * poses.rotation_link_5_yy
                + velocities.velocity_link_6_vy * poses.rotation_link_6_xz)) * qd[5];
    let twist_link_7_wx = twist_link_6_wx
        + (velocities.velocity_link_7_wy * poses.rotation_link_6_zy
            + velocities.velocity_link_7_wz * poses.minus_rotation_link_6_yy) * qd[6];
    let twist_link_7_wy = twist_link_6_wy
        - (velocities.velocity_link_7_wz * poses.minus_rotation_link_6_xy
            + velocities.velocity_link_7_wx * poses.rotation_link_6_zy) * qd[6];
    let twist_link_7_wz = twist_link_6_wz
        + (velocities.velocity_link_7_wy * poses.minus_rotation_link_6_xy
            - velocities.velocity_link_7_wx * poses.minus_rotation_link_6_yy) * qd[6];
    let twist_link_7_vx = twist_link_6_vx
        + (velocities.velocity_link_7_wy * screws.screw_joint_7_vz
            - velocities.velocity_link_7_wz * screws.screw_joint_7_vy
            + (velocities.velocity_link_7_vy * poses.rotation_link_6_zy
                + velocities.velocity_link_7_vz * poses.minus_rotation_link_6_yy))
            * qd[6];
    let twist_link_7_vy = twist_link_6_vy
        + (velocities.velocity_link_7_wz * screws.screw_joint_7_vx
            - velocities.velocity_link_7_wx * screws.screw_joint_7_vz
            - (velocities.velocity_link_7_vz * poses.minus_rotation_link_6_xy
                + velocities.velocity_link_7_vx * poses.rotation_link_6_zy)) * qd[6];
    let twist_link_7_vz = twist_link_6_vz
        + (velocities.velocity_link_7_wx * screws.screw_joint_7_vy
            - velocities.velocity_link_7_wy * screws.screw_joint_7_vx
            + (velocities.velocity_link_7_vy * poses.minus_rotation_link_6_xy
                - velocities.velocity_link_7_vx * poses.minus_rotation_link_6_yy))
            * qd[6];
    let minus_wrench_outside_link_1_my_0 = inertias.minus_inertia_base_xy
        * velocities.minus_velocity_base_wy
        - inertias.inertia_base_xx * velocities.minus_velocity_base_wx
        + inertias.minus_inertia_base_xz * velocities.minus_velocity_base_wz
        + (velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hy
            - velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hz);
    let minus_wrench_outside_link_1_mx_2 = inertias.minus_inertia_base_xy
        * velocities.minus_velocity_base_wx
        - inertias.inertia_base_yy * velocities.minus_velocity_base_wy
        + inertias.minus_inertia_base_yz * velocities.minus_velocity_base_wz
        - (velocities.velocity_base_vx * inertias.minus_inertia_base_hz
            + velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hx);
    let minus_wrench_outside_link_1_mx_0 = inertias.minus_inertia_base_xz
        * velocities.minus_velocity_base_wx
        + inertias.minus_inertia_base_yz * velocities.minus_velocity_base_wy
        - inertias.inertia_base_zz * velocities.minus_velocity_base_wz
        + (velocities.minus_velocity_base_vy * inertias.minus_inertia_base_hx
            + velocities.velocity_base_vx * inertias.minus_inertia_base_hy);
    let minus_wrench_outside_link_1_mx = minus_wrench_outside_link_1_mx_0
        * velocities.minus_velocity_base_wy
        - minus_wrench_outside_link_1_mx_2 * velocities.minus_velocity_base_wz
        + (minus_wrench_outside_link_1_mx_4 * velocities.minus_velocity_base_vy
            - minus_wrench_outside_link_1_mx_6 * velocities.minus_velocity_base_vz);
    let minus_wrench_outside_link_1_my = minus_wrench_outside_link_1_my_0
        * velocities.minus_velocity_base_wz
        - minus_wrench_outside_link_1_mx_0 * velocities.minus_velocity_base_wx
        + (minus_wrench_outside_link_1_mx_4 * velocities.velocity_base_vx
            + minus_wrench_outside_link_1_my_6 * velocities.minus_velocity_base_vz);
    let minus_wrench_outside_link_1_mz = minus_wrench_outside_link_1_mx_2
        * velocities.minus_velocity_base_wx
        - minus_wrench_outside_link_1_my_0 * velocities.minus_velocity_base_wy
        - (minus_wrench_outside_link_1_my_6 * velocities.minus_velocity_base_vy
            + minus_wrench_outside_link_1_mx_6 * velocities.velocity_base_vx);
    let minus_wrench_outside_link_1_fx = minus_wrench_outside_link_1_mx_4
        * velocities.minus_velocity_base_wy
        - minus_wrench_outside_link_1_mx_6 * velocities.minus_velocity_base_wz;
    let minus_wrench_outside_link_1_fy = minus_wrench_outside_link_1_my_6
        * velocities.minus_velocity_base_wz
        - minus_wrench_outside_link_1_mx_4 * velocities.minus_velocity_base_wx;
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
        + (inertias.inertia_link_1_hz * minus_twist_link_1_vy
            - inertias.inertia_link_1_hy * minus_twist_link_1_vz)
        - (wrench_link_1_mx_0_8 * velocities.velocity_link_1_wz
            + wrench_link_1_mx_0_10 * velocities.minus_velocity_base_wy
            + (wrench_outside_link_2_fx_6 * velocities.velocity_link_1_vy
                - wrench_outside_link_2_fx_4 * velocities.minus_velocity_base_vz));
    let wrench_link_1_my_0 = inertias.inertia_link_1_yy * twist_link_1_wy
        - inertias.inertia_link_1_xy * minus_twist_link_1_wx
        + (inertias.inertia_link_1_hz * twist_link_1_vx
            - inertias.minus_inertia_link_1_hx * minus_twist_link_1_vz)
        - (wrench_outside_link_2_fy_6 * velocities.minus_velocity_base_vz
            - wrench_outside_link_2_fx_6 * velocities.velocity_link_1_vx
            - (wrench_link_1_mx_0_10 * velocities.minus_velocity_base_wx
                + wrench_link_1_my_0_14 * velocities.velocity_link_1_wz));
    let wrench_link_1_mz_0 = inertias.minus_inertia_link_1_hx * minus_twist_link_1_vy
        - inertias.inertia_link_1_hy * twist_link_1_vx
        - (inertias.inertia_link_1_xz * minus_twist_link_1_wx
            + inertias.minus_inertia_link_1_yz * twist_link_1_wy)
        - (wrench_link_1_mx_0_8 * velocities.minus_velocity_base_wx
            - wrench_link_1_my_0_14 * velocities.minus_velocity_base_wy
            + (wrench_outside_link_2_fy_6 * velocities.velocity_link_1_vy
                - wrench_outside_link_2_fx_4 * velocities.velocity_link_1_vx));
    let wrench_link_2_my_0_12 = inertias.inertia_link_2_xx
        * velocities.velocity_link_2_wx
        - inertias.inertia_link_2_xy * velocities.minus_velocity_link_2_wy
        + inertias.inertia_link_2_xz * velocities.velocity_link_1_wz
        - (velocities.velocity_link_2_vz * inertias.minus_inertia_link_2_hy
            + velocities.velocity_link_2_vy * inertias.inertia_link_2_hz);
    let wrench_link_2_mx_0_10 = inertias.inertia_link_2_xy
        * velocities.velocity_link_2_wx
        - inertias.inertia_link_2_yy * velocities.minus_velocity_link_2_wy
        + inertias.inertia_link_2_yz * velocities.velocity_link_1_wz
        + (velocities.velocity_link_2_vx * inertias.inertia_link_2_hz
            - velocities.velocity_link_2_vz * inertias.inertia_link_2_hx);
    let wrench_link_2_mx_0_12 = inertias.inertia_link_2_xz
        * velocities.velocity_link_2_wx
        - inertias.inertia_link_2_yz * velocities.minus_velocity_link_2_wy
        + inertias.inertia_link_2_zz * velocities.velocity_link_1_wz
        + (velocities.velocity_link_2_vy * inertias.inertia_link_2_hx
            + velocities.velocity_link_2_vx * inertias.minus_inertia_link_2_hy);
    let wrench_link_2_mx_0 = inertias.inertia_link_2_xx * twist_link_2_wx
        + inertias.inertia_link_2_xy * twist_link_2_wy
        + inertias.inertia_link_2_xz * twist_link_2_wz
        - (inertias.minus_inertia_link_2_hy * twist_link_2_vz
            + inertias.inertia_link_2_hz * twist_link_2_vy)
        - (wrench_link_2_mx_0_10 * velocities.velocity_link_1_wz
            + wrench_link_2_mx_0_12 * velocities.minus_velocity_link_2_wy
            + (wrench_link_2_mx_0_14 * velocities.velocity_link_2_vz
                - wrench_link_2_mx_0_16 * velocities.velocity_link_2_vy));
    let wrench_link_2_my_0 = inertias.inertia_link_2_xy * twist_link_2_wx
        + inertias.inertia_link_2_yy * twist_link_2_wy
        + inertias.inertia_link_2_yz * twist_link_2_wz
        + (inertias.inertia_link_2_hz * twist_link_2_vx
            - inertias.inertia_link_2_hx * twist_link_2_vz)
        - (wrench_link_2_mx_0_12 * velocities.velocity_link_2_wx
            - wrench_link_2_my_0_12 * velocities.velocity_link_1_wz
            + (wrench_link_2_mx_0_16 * velocities.velocity_link_2_vx
                - wrench_link_2_my_0_16 * velocities.velocity_link_2_vz));
    let wrench_link_2_mz_0 = inertias.inertia_link_2_xz * twist_link_2_wx
        + inertias.inertia_link_2_yz * twist_link_2_wy
        + inertias.inertia_link_2_zz * twist_link_2_wz
        + (inertias.inertia_link_2_hx * twist_link_2_vy
            + inertias.minus_inertia_link_2_hy * twist_link_2_vx)
        - (wrench_link_2_my_0_16 * velocities.velocity_link_2_vy
            - wrench_link_2_mx_0_14 * velocities.velocity_link_2_vx
            - (wrench_link_2_my_0_12 * velocities.minus_velocity_link_2_wy
                + wrench_link_2_mx_0_10 * velocities.velocity_link_2_wx));
    let wrench_link_3_my_0_12 = inertias.inertia_link_3_xx
        * velocities.velocity_link_3_wx
        - inertias.inertia_link_3_xy * velocities.minus_velocity_link_3_wy
        + inertias.inertia_link_3_xz * velocities.velocity_link_3_wz
        - (velocities.velocity_link_3_vz * inertias.minus_inertia_link_3_hy
            + velocities.velocity_link_3_vy * inertias.inertia_link_3_hz);
    let wrench_link_3_mx_0_10 = inertias.inertia_link_3_xy
        * velocities.velocity_link_3_wx
        - inertias.inertia_link_3_yy * velocities.minus_velocity_link_3_wy
        + inertias.inertia_link_3_yz * velocities.velocity_link_3_wz
        + (velocities.velocity_link_3_vx * inertias.inertia_link_3_hz
            - velocities.velocity_link_3_vz * inertias.inertia_link_3_hx);
    let wrench_link_3_mx_0_12 = inertias.inertia_link_3_xz
        * velocities.velocity_link_3_wx
        - inertias.inertia_link_3_yz * velocities.minus_velocity_link_3_wy
        + inertias.inertia_link_3_zz * velocities.velocity_link_3_wz
        + (velocities.velocity_link_3_vy * inertias.inertia_link_3_hx
            + velocities.velocity_link_3_vx * inertias.minus_inertia_link_3_hy);
    let wrench_link_3_mx_0 = inertias.inertia_link_3_xx * twist_link_3_wx
        + inertias.inertia_link_3_xy * twist_link_3_wy
        + inertias.inertia_link_3_xz * twist_link_3_wz
        - (inertias.minus_inertia_link_3_hy * twist_link_3_vz
            + inertias.inertia_link_3_hz * twist_link_3_vy)
        - (wrench_link_3_mx_0_10 * velocities.velocity_link_3_wz
            + wrench_link_3_mx_0_12 * velocities.minus_velocity_link_3_wy
            + (wrench_link_3_mx_0_14 * velocities.velocity_link_3_vz
                - wrench_link_3_mx_0_16 * velocities.velocity_link_3_vy));
    let wrench_link_3_my_0 = inertias.inertia_link_3_xy * twist_link_3_wx
        + inertias.inertia_link_3_yy * twist_link_3_wy
        + inertias.inertia_link_3_yz * twist_link_3_wz
        + (inertias.inertia_link_3_hz * twist_link_3_vx
            - inertias.inertia_link_3_hx * twist_link_3_vz)
        - (wrench_link_3_mx_0_12 * velocities.velocity_link_3_wx
            - wrench_link_3_my_0_12 * velocities.velocity_link_3_wz
            + (wrench_link_3_mx_0_16 * velocities.velocity_link_3_vx
                - wrench_link_3_my_0_16 * velocities.velocity_link_3_vz));
    let wrench_link_3_mz_0 = inertias.inertia_link_3_xz * twist_link_3_wx
        + inertias.inertia_link_3_yz * twist_link_3_wy
        + inertias.inertia_link_3_zz * twist_link_3_wz
        + (inertias.inertia_link_3_hx * twist_link_3_vy
            + inertias.minus_inertia_link_3_hy * twist_link_3_vx)
        - (wrench_link_3_my_0_16 * velocities.velocity_link_3_vy
            - wrench_link_3_mx_0_14 * velocities.velocity_link_3_vx
            - (wrench_link_3_my_0_12 * velocities.minus_velocity_link_3_wy
                + wrench_link_3_mx_0_10 * velocities.velocity_link_3_wx));
    let wrench_link_4_my_0_12 = inertias.inertia_link_4_xx
        * velocities.velocity_link_4_wx
        + inertias.inertia_link_4_xy * velocities.velocity_link_4_wy
        + inertias.inertia_link_4_xz * velocities.velocity_link_4_wz
        + (velocities.velocity_link_4_vz * inertias.inertia_link_4_hy
            - velocities.velocity_link_4_vy * inertias.inertia_link_4_hz);
    let wrench_link_4_mx_0_10 = inertias.inertia_link_4_xy
        * velocities.velocity_link_4_wx
        + inertias.inertia_link_4_yy * velocities.velocity_link_4_wy
        + inertias.inertia_link_4_yz * velocities.velocity_link_4_wz
        + (velocities.velocity_link_4_vx * inertias.inertia_link_4_hz
            + velocities.velocity_link_4_vz * inertias.minus_inertia_link_4_hx);
    let wrench_link_4_mx_0_12 = inertias.inertia_link_4_xz
        * velocities.velocity_link_4_wx
        + inertias.inertia_link_4_yz * velocities.velocity_link_4_wy
        + inertias.inertia_link_4_zz * velocities.velocity_link_4_wz
        - (velocities.velocity_link_4_vy * inertias.minus_inertia_link_4_hx
            + velocities.velocity_link_4_vx * inertias.inertia_link_4_hy);
    let wrench_link_4_mx_0 = inertias.inertia_link_4_xx * twist_link_4_wx
        + inertias.inertia_link_4_xy * twist_link_4_wy
        + inertias.inertia_link_4_xz * twist_link_4_wz
        + (inertias.inertia_link_4_hy * twist_link_4_vz
            - inertias.inertia_link_4_hz * twist_link_4_vy)
        - (wrench_link_4_mx_0_10 * velocities.velocity_link_4_wz
            - wrench_link_4_mx_0_12 * velocities.velocity_link_4_wy
            + (wrench_link_4_mx_0_14 * velocities.velocity_link_4_vz
                - wrench_link_4_mx_0_16 * velocities.velocity_link_4_vy));
    let wrench_link_4_my_0 = inertias.inertia_link_4_xy * twist_link_4_wx
        + inertias.inertia_link_4_yy * twist_link_4_wy
        + inertias.inertia_link_4_yz * twist_link_4_wz
        + (inertias.inertia_link_4_hz * twist_link_4_vx
            + inertias.minus_inertia_link_4_hx * twist_link_4_vz)
        - (wrench_link_4_mx_0_12 * velocities.velocity_link_4_wx
            - wrench_link_4_my_0_12 * velocities.velocity_link_4_wz
            + (wrench_link_4_mx_0_16 * velocities.velocity_link_4_vx
                - wrench_link_4_my_0_16 * velocities.velocity_link_4_vz));
    let wrench_link_4_mz_0 = inertias.inertia_link_4_xz * twist_link_4_wx
        + inertias.inertia_link_4_yz * twist_link_4_wy
        + inertias.inertia_link_4_zz * twist_link_4_wz
        - (inertias.minus_inertia_link_4_hx * twist_link_4_vy
            + inertias.inertia_link_4_hy * twist_link_4_vx)
        - (wrench_link_4_my_0_12 * velocities.velocity_link_4_wy
            - wrench_link_4_mx_0_10 * velocities.velocity_link_4_wx
            + (wrench_link_4_my_0_16 * velocities.velocity_link_4_vy
                - wrench_link_4_mx_0_14 * velocities.velocity_link_4_vx));
    let wrench_link_5_my_0_12 = inertias.inertia_link_5_xx
        * velocities.velocity_link_5_wx
        + inertias.inertia_link_5_xy * velocities.velocity_link_5_wy
        + inertias.inertia_link_5_xz * velocities.velocity_link_5_wz
        + (velocities.velocity_link_5_vz * inertias.inertia_link_5_hy
            - velocities.velocity_link_5_vy * inertias.inertia_link_5_hz);
    let wrench_link_5_mx_0_10 = inertias.inertia_link_5_xy
        * velocities.velocity_link_5_wx
        + inertias.inertia_link_5_yy * velocities.velocity_link_5_wy
        + inertias.inertia_link_5_yz * velocities.velocity_link_5_wz
        + (velocities.velocity_link_5_vx * inertias.inertia_link_5_hz
            + velocities.velocity_link_5_vz * inertias.minus_inertia_link_5_hx);
    let wrench_link_5_mx_0_12 = inertias.inertia_link_5_xz
        * velocities.velocity_link_5_wx
        + inertias.inertia_link_5_yz * velocities.velocity_link_5_wy
        + inertias.inertia_link_5_zz * velocities.velocity_link_5_wz
        - (velocities.velocity_link_5_vy * inertias.minus_inertia_link_5_hx
            + velocities.velocity_link_5_vx * inertias.inertia_link_5_hy);
    let wrench_link_5_mx_0 = inertias.inertia_link_5_xx * twist_link_5_wx
        + inertias.inertia_link_5_xy * twist_link_5_wy
        + inertias.inertia_link_5_xz * twist_link_5_wz
        + (inertias.inertia_link_5_hy * twist_link_5_vz
            - inertias.inertia_link_5_hz * twist_link_5_vy)
        - (wrench_link_5_mx_0_10 * velocities.velocity_link_5_wz
            - wrench_link_5_mx_0_12 * velocities.velocity_link_5_wy
            + (wrench_link_5_mx_0_14 * velocities.velocity_link_5_vz
                - wrench_link_5_mx_0_16 * velocities.velocity_link_5_vy));
    let wrench_link_5_my_0 = inertias.inertia_link_5_xy * twist_link_5_wx
        + inertias.inertia_link_5_yy * twist_link_5_wy
        + inertias.inertia_link_5_yz * twist_link_5_wz
        + (inertias.inertia_link_5_hz * twist_link_5_vx
            + inertias.minus_inertia_link_5_hx * twist_link_5_vz)
        - (wrench_link_5_mx_0_12 * velocities.velocity_link_5_wx
            - wrench_link_5_my_0_12 * velocities.velocity_link_5_wz
            + (wrench_link_5_mx_0_16 * velocities.velocity_link_5_vx
                - wrench_link_5_my_0_16 * velocities.velocity_link_5_vz));
    let wrench_link_5_mz_0 = inertias.inertia_link_5_xz * twist_link_5_wx
        + inertias.inertia_link_5_yz * twist_link_5_wy
        + inertias.inertia_link_5_zz * twist_link_5_wz
        - (inertias.minus_inertia_link_5_hx * twist_link_5_vy
            + inertias.inertia_link_5_hy * twist_link_5_vx)
        - (wrench_link_5_my_0_12 * velocities.velocity_link_5_wy
            - wrench_link_5_mx_0_10 * velocities.velocity_link_5_wx
            + (wrench_link_5_my_0_16 * velocities.velocity_link_5_vy
                - wrench_link_5_mx_0_14 * velocities.velocity_link_5_vx));
    let wrench_link_6_my_0_12 = inertias.inertia_link_6_xx
        * velocities.velocity_link_6_wx
        - inertias.minus_inertia_link_6_xy * velocities.velocity_link_6_wy
        + inertias.inertia_link_6_xz * velocities.velocity_link_6_wz
        - (velocities.velocity_link_6_vz * inertias.minus_inertia_link_6_hy
            + velocities.velocity_link_6_vy * inertias.inertia_link_6_hz);
    let wrench_link_6_mx_0_10 = inertias.inertia_link_6_yy
        * velocities.velocity_link_6_wy
        - inertias.minus_inertia_link_6_xy * velocities.velocity_link_6_wx
        + inertias.inertia_link_6_yz * velocities.velocity_link_6_wz
        + (velocities.velocity_link_6_vx * inertias.inertia_link_6_hz
            + velocities.velocity_link_6_vz * inertias.minus_inertia_link_6_hx);
    let wrench_link_6_mx_0_12 = inertias.inertia_link_6_xz
        * velocities.velocity_link_6_wx
        + inertias.inertia_link_6_yz * velocities.velocity_link_6_wy
        + inertias.inertia_link_6_zz * velocities.velocity_link_6_wz
        + (velocities.velocity_link_6_vx * inertias.minus_inertia_link_6_hy
            - velocities.velocity_link_6_vy * inertias.minus_inertia_link_6_hx);
    let wrench_link_6_mx_0 = inertias.inertia_link_6_xx * twist_link_6_wx
        - inertias.minus_inertia_link_6_xy * twist_link_6_wy
        + inertias.inertia_link_6_xz * twist_link_6_wz
        - (inertias.minus_inertia_link_6_hy * twist_link_6_vz
            + inertias.inertia_link_6_hz * twist_link_6_vy)
        - (wrench_link_6_mx_0_10 * velocities.velocity_link_6_wz
            - wrench_link_6_mx_0_12 * velocities.velocity_link_6_wy
            + (wrench_link_6_mx_0_14 * velocities.velocity_link_6_vz
                - wrench_link_6_mx_0_16 * velocities.velocity_link_6_vy));
    let wrench_link_6_my_0 = inertias.inertia_link_6_yy * twist_link_6_wy
        - inertias.minus_inertia_link_6_xy * twist_link_6_wx
        + inertias.inertia_link_6_yz * twist_link_6_wz
        + (inertias.inertia_link_6_hz * twist_link_6_vx
            + inertias.minus_inertia_link_6_hx * twist_link_6_vz)
        - (wrench_link_6_mx_0_12 * velocities.velocity_link_6_wx
            - wrench_link_6_my_0_12 * velocities.velocity_link_6_wz
            + (wrench_link_6_mx_0_16 * velocities.velocity_link_6_vx
                - wrench_link_6_my_0_16 * velocities.velocity_link_6_vz));
    let wrench_link_6_mz_0 = inertias.inertia_link_6_xz * twist_link_6_wx
        + inertias.inertia_link_6_yz * twist_link_6_wy
        + inertias.inertia_link_6_zz * twist_link_6_wz
        + (inertias.minus_inertia_link_6_hy * twist_link_6_vx
            - inertias.minus_inertia_link_6_hx * twist_link_6_vy)
        - (wrench_link_6_my_0_12 * velocities.velocity_link_6_wy
            - wrench_link_6_mx_0_10 * velocities.velocity_link_6_wx
            + (wrench_link_6_my_0_16 * velocities.velocity_link_6_vy
                - wrench_link_6_mx_0_14 * velocities.velocity_link_6_vx));
    let wrench_link_7_my_12 = inertias.inertia_link_7_xx * velocities.velocity_link_7_wx
        - inertias.minus_inertia_link_7_xy * velocities.velocity_link_7_wy
        + inertias.inertia_link_7_xz * velocities.velocity_link_7_wz
        - (velocities.velocity_link_7_vz * inertias.minus_inertia_link_7_hy
            + velocities.velocity_link_7_vy * inertias.inertia_link_7_hz);
    let wrench_link_7_mx_10 = inertias.inertia_link_7_yy * velocities.velocity_link_7_wy
        - inertias.minus_inertia_link_7_xy * velocities.velocity_link_7_wx
        + inertias.inertia_link_7_yz * velocities.velocity_link_7_wz
        + (velocities.velocity_link_7_vx * inertias.inertia_link_7_hz
            + velocities.velocity_link_7_vz * inertias.minus_inertia_link_7_hx);
    let wrench_link_7_mx_12 = inertias.inertia_link_7_xz * velocities.velocity_link_7_wx
        + inertias.inertia_link_7_yz * velocities.velocity_link_7_wy
        + inertias.inertia_link_7_zz * velocities.velocity_link_7_wz
        + (velocities.velocity_link_7_vx * inertias.minus_inertia_link_7_hy
            - velocities.velocity_link_7_vy * inertias.minus_inertia_link_7_hx);
    let wrench_link_7_mx = inertias.inertia_link_7_xx * twist_link_7_wx
        - inertias.minus_inertia_link_7_xy * twist_link_7_wy
        + inertias.inertia_link_7_xz * twist_link_7_wz
        - (inertias.minus_inertia_link_7_hy * twist_link_7_vz
            + inertias.inertia_link_7_hz * twist_link_7_vy)
        - (wrench_link_7_mx_10 * velocities.velocity_link_7_wz
            - wrench_link_7_mx_12 * velocities.velocity_link_7_wy
            + (wrench_link_7_mx_14 * velocities.velocity_link_7_vz
                - wrench_link_7_mx_16 * velocities.velocity_link_7_vy));
    let wrench_link_7_my = inertias.inertia_link_7_yy * twist_link_7_wy
        - inertias.minus_inertia_link_7_xy * twist_link_7_wx
        + inertias.inertia_link_7_yz * twist_link_7_wz
        + (inertias.inertia_link_7_hz * twist_link_7_vx
            + inertias.minus_inertia_link_7_hx * twist_link_7_vz)
        - (wrench_link_7_mx_12 * velocities.velocity_link_7_wx
            - wrench_link_7_my_12 * velocities.velocity_link_7_wz
            + (wrench_link_7_mx_16 * velocities.velocity_link_7_vx
                - wrench_link_7_my_16 * velocities.velocity_link_7_vz));
    let wrench_link_7_mz = inertias.inertia_link_7_xz * twist_link_7_wx
        + inertias.inertia_link_7_yz * twist_link_7_wy
        + inertias.inertia_link_7_zz * twist_link_7_wz
        + (inertias.minus_inertia_link_7_hy * twist_link_7_vx
            - inertias.minus_inertia_link_7_hx * twist_link_7_vy)
        - (wrench_link_7_my_12 * velocities.velocity_link_7_wy
            - wrench_link_7_mx_10 * velocities.velocity_link_7_wx
            + (wrench_link_7_my_16 * velocities.velocity_link_7_vy
                - wrench_link_7_mx_14 * velocities.velocity_link_7_vx));
    let wrench_link_6_mx = wrench_link_6_mx_0 + wrench_link_7_mx;
    let wrench_link_6_my = wrench_link_6_my_0 + wrench_link_7_my;
    let wrench_link_6_mz = wrench_link_6_mz_0 + wrench_link_7_mz;
    let wrench_link_5_mx = wrench_link_5_mx_0 + wrench_link_6_mx;
    let wrench_link_5_my = wrench_link_5_my_0 + wrench_link_6_my;
    let wrench_link_5_mz = wrench_link_5_mz_0 + wrench_link_6_mz;
    let wrench_link_4_mx = wrench_link_4_mx_0 + wrench_link_5_mx;
    let wrench_link_4_my = wrench_link_4_my_0 + wrench_link_5_my;
    let wrench_link_4_mz = wrench_link_4_mz_0 + wrench_link_5_mz;
    let wrench_link_3_mx = wrench_link_3_mx_0 + wrench_link_4_mx;
    let wrench_link_3_my = wrench_link_3_my_0 + wrench_link_4_my;
    let wrench_link_3_mz = wrench_link_3_mz_0 + wrench_link_4_mz;
    let wrench_link_2_mx = wrench_link_2_mx_0 + wrench_link_3_mx;
    let wrench_link_2_my = wrench_link_2_my_0 + wrench_link_3_my;
    let wrench_link_2_mz = wrench_link_2_mz_0 + wrench_link_3_mz;
    let wrench_link_1_mx = wrench_link_1_mx_0 + wrench_link_2_mx;
    let wrench_link_1_my = wrench_link_1_my_0 + wrench_link_2_my;
    let wrench_link_1_mz = wrench_link_1_mz_0 + wrench_link_2_mz;
    d_qdot_xi[6] = reactions.reaction_joint_1_wx * wrench_link_1_mx
        + reactions.reaction_joint_1_wy * wrench_link_1_my
        + reactions.reaction_joint_1_wz * wrench_link_1_mz
        - (screws.minus_connection_joint_1_vx * minus_wrench_outside_link_1_fx
            - (screws.connection_joint_1_wx * minus_wrench_outside_link_1_mx
                + screws.connection_joint_1_wy * minus_wrench_outside_link_1_my
                + screws.connection_joint_1_wz * minus_wrench_outside_link_1_mz)
            - screws.connection_joint_1_vy * minus_wrench_outside_link_1_fy) + 0.0;
    let minus_wrench_outside_link_1_fz = minus_wrench_outside_link_1_mx_6
        * velocities.minus_velocity_base_wx
        - minus_wrench_outside_link_1_my_6 * velocities.minus_velocity_base_wy;
    let wrench_link_2_fx_0 = twist_link_2_vx * 2.0
        + (twist_link_2_wy * inertias.inertia_link_2_hz
            + twist_link_2_wz * inertias.minus_inertia_link_2_hy)
        - (wrench_link_2_mx_0_14 * velocities.velocity_link_1_wz
            + wrench_link_2_mx_0_16 * velocities.minus_velocity_link_2_wy);
    let wrench_link_2_fy_0 = twist_link_2_vy * 2.0
        + (twist_link_2_wz * inertias.inertia_link_2_hx
            - twist_link_2_wx * inertias.inertia_link_2_hz)
        - (wrench_link_2_mx_0_16 * velocities.velocity_link_2_wx
            - wrench_link_2_my_0_16 * velocities.velocity_link_1_wz);
    let wrench_link_2_fz_0 = twist_link_2_vz * 2.0
        - (twist_link_2_wx * inertias.minus_inertia_link_2_hy
            + twist_link_2_wy * inertias.inertia_link_2_hx)
        + (wrench_link_2_my_0_16 * velocities.minus_velocity_link_2_wy
            + wrench_link_2_mx_0_14 * velocities.velocity_link_2_wx);
    let wrench_link_3_fx_0 = twist_link_3_vx * 2.0
        + (twist_link_3_wy * inertias.inertia_link_3_hz
            + twist_link_3_wz * inertias.minus_inertia_link_3_hy)
        - (wrench_link_3_mx_0_14 * velocities.velocity_link_3_wz
            + wrench_link_3_mx_0_16 * velocities.minus_velocity_link_3_wy);
    let wrench_link_3_fy_0 = twist_link_3_vy * 2.0
        + (twist_link_3_wz * inertias.inertia_link_3_hx
            - twist_link_3_wx * inertias.inertia_link_3_hz)
        - (wrench_link_3_mx_0_16 * velocities.velocity_link_3_wx
            - wrench_link_3_my_0_16 * velocities.velocity_link_3_wz);
    let wrench_link_3_fz_0 = twist_link_3_vz * 2.0
        - (twist_link_3_wx * inertias.minus_inertia_link_3_hy
            + twist_link_3_wy * inertias.inertia_link_3_hx)
        + (wrench_link_3_my_0_16 * velocities.minus_velocity_link_3_wy
            + wrench_link_3_mx_0_14 * velocities.velocity_link_3_wx);
    let wrench_link_4_fx_0 = twist_link_4_vx * 2.0
        + (twist_link_4_wy * inertias.inertia_link_4_hz
            - twist_link_4_wz * inertias.inertia_link_4_hy)
        - (wrench_link_4_mx_0_14 * velocities.velocity_link_4_wz
            - wrench_link_4_mx_0_16 * velocities.velocity_link_4_wy);
    let wrench_link_4_fy_0 = twist_link_4_vy * 2.0
        - (twist_link_4_wz * inertias.minus_inertia_link_4_hx
            + twist_link_4_wx * inertias.inertia_link_4_hz)
        - (wrench_link_4_mx_0_16 * velocities.velocity_link_4_wx
            - wrench_link_4_my_0_16 * velocities.velocity_link_4_wz);
    let wrench_link_4_fz_0 = twist_link_4_vz * 2.0
        + (twist_link_4_wx * inertias.inertia_link_4_hy
            + twist_link_4_wy * inertias.minus_inertia_link_4_hx)
        - (wrench_link_4_my_0_16 * velocities.velocity_link_4_wy
            - wrench_link_4_mx_0_14 * velocities.velocity_link_4_wx);
    let wrench_link_5_fx_0 = twist_link_5_vx * 2.0
        + (twist_link_5_wy * inertias.inertia_link_5_hz
            - twist_link_5_wz * inertias.inertia_link_5_hy)
        - (wrench_link_5_mx_0_14 * velocities.velocity_link_5_wz
            - wrench_link_5_mx_0_16 * velocities.velocity_link_5_wy);
    let wrench_link_5_fy_0 = twist_link_5_vy * 2.0
        - (twist_link_5_wz * inertias.minus_inertia_link_5_hx
            + twist_link_5_wx * inertias.inertia_link_5_hz)
        - (wrench_link_5_mx_0_16 * velocities.velocity_link_5_wx
            - wrench_link_5_my_0_16 * velocities.velocity_link_5_wz);
    let wrench_link_5_fz_0 = twist_link_5_vz * 2.0
        + (twist_link_5_wx * inertias.inertia_link_5_hy
            + twist_link_5_wy * inertias.minus_inertia_link_5_hx)
        - (wrench_link_5_my_0_16 * velocities.velocity_link_5_wy
            - wrench_link_5_mx_0_14 * velocities.velocity_link_5_wx);
    let wrench_link_6_fx_0 = twist_link_6_vx * 2.0
        + (twist_link_6_wy * inertias.inertia_link_6_hz
            + twist_link_6_wz * inertias.minus_inertia_link_6_hy)
        - (wrench_link_6_mx_0_14 * velocities.velocity_link_6_wz
            - wrench_link_6_mx_0_16 * velocities.velocity_link_6_wy);
    let wrench_link_6_fy_0 = twist_link_6_vy * 2.0
        - (twist_link_6_wz * inertias.minus_inertia_link_6_hx
            + twist_link_6_wx * inertias.inertia_link_6_hz)
        - (wrench_link_6_mx_0_16 * velocities.velocity_link_6_wx
            - wrench_link_6_my_0_16 * velocities.velocity_link_6_wz);
    let wrench_link_6_fz_0 = twist_link_6_vz * 2.0
        + (twist_link_6_wy * inertias.minus_inertia_link_6_hx
            - twist_link_6_wx * inertias.minus_inertia_link_6_hy)
        - (wrench_link_6_my_0_16 * velocities.velocity_link_6_wy
            - wrench_link_6_mx_0_14 * velocities.velocity_link_6_wx);
    let wrench_link_7_fx = twist_link_7_vx * 2.0
        + (twist_link_7_wy * inertias.inertia_link_7_hz
            + twist_link_7_wz * inertias.minus_inertia_link_7_hy)
        - (wrench_link_7_mx_14 * velocities.velocity_link_7_wz
            - wrench_link_7_mx_16 * velocities.velocity_link_7_wy);
    let wrench_link_7_fy = twist_link_7_vy * 2.0
        - (twist_link_7_wz * inertias.minus_inertia_link_7_hx
            + twist_link_7_wx * inertias.inertia_link_7_hz)
        - (wrench_link_7_mx_16 * velocities.velocity_link_7_wx
            - wrench_link_7_my_16 * velocities.velocity_link_7_wz);
    let wrench_link_7_fz = twist_link_7_vz * 2.0
        + (twist_link_7_wy * inertias.minus_inertia_link_7_hx
            - twist_link_7_wx * inertias.minus_inertia_link_7_hy)
        - (wrench_link_7_my_16 * velocities.velocity_link_7_wy
            - wrench_link_7_mx_14 * velocities.velocity_link_7_wx);
    let wrench_link_6_fx = wrench_link_6_fx_0 + wrench_link_7_fx;
    let wrench_link_6_fy = wrench_link_6_fy_0 + wrench_link_7_fy;
    let wrench_link_6_fz = wrench_link_6_fz_0 + wrench_link_7_fz;
    let wrench_link_5_fx = wrench_link_5_fx_0 + wrench_link_6_fx;
    let wrench_link_5_fy = wrench_link_5_fy_0 + wrench_link_6_fy;
    let wrench_link_5_fz = wrench_link_5_fz_0 + wrench_link_6_fz;
    let wrench_link_4_fx = wrench_link_4_fx_0 + wrench_link_5_fx;
    let wrench_link_4_fy = wrench_link_4_fy_0 + wrench_link_5_fy;
    let wrench_link_4_fz = wrench_link_4_fz_0 + wrench_link_5_fz;
    let wrench_link_3_fx = wrench_link_3_fx_0 + wrench_link_4_fx;
    let wrench_link_3_fy = wrench_link_3_fy_0 + wrench_link_4_fy;
    let wrench_link_3_fz = wrench_link_3_fz_0 + wrench_link_4_fz;
    let wrench_link_2_fx = wrench_link_2_fx_0 + wrench_link_3_fx;
    let wrench_link_2_fy = wrench_link_2_fy_0 + wrench_link_3_fy;
    let wrench_link_2_fz = wrench_link_2_fz_0 + wrench_link_3_fz;
    let wrench_outside_link_2_mx = wrench_link_1_mx_0 - minus_wrench_outside_link_1_mx;
    let wrench_outside_link_2_my = wrench_link_1_my_0 - minus_wrench_outside_link_1_my;
    let wrench_outside_link_2_mz = wrench_link_1_mz_0 - minus_wrench_outside_link_1_mz;
    let wrench_outside_link_2_fx = twist_link_1_vx * 2.0
        + twist_link_1_wy * inertias.inertia_link_1_hz
        - (wrench_outside_link_2_fx_4 * velocities.velocity_link_1_wz
            - wrench_outside_link_2_fx_6 * velocities.minus_velocity_base_wy)
        - minus_wrench_outside_link_1_fx;
    let wrench_outside_link_2_fy = minus_twist_link_1_wx * inertias.inertia_link_1_hz
        - minus_twist_link_1_vy * 2.0
        - (wrench_outside_link_2_fx_6 * velocities.minus_velocity_base_wx
            - wrench_outside_link_2_fy_6 * velocities.velocity_link_1_wz)
        - minus_wrench_outside_link_1_fy;
    let wrench_outside_link_2_fz = twist_link_1_wy * inertias.minus_inertia_link_1_hx
        - minus_twist_link_1_wx * inertias.inertia_link_1_hy
        - minus_twist_link_1_vz * 2.0
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
            + screws.connection_joint_2_wz * wrench_outside_link_2_mz
            + screws.connection_joint_2_vx * wrench_outside_link_2_fx
            + screws.connection_joint_2_vy * wrench_outside_link_2_fy
            + screws.connection_joint_2_vz * wrench_outside_link_2_fz) + 0.0;
    let wrench_outside_link_3_mx = wrench_link_2_mx_0 + wrench_outside_link_2_mx;
    let wrench_outside_link_3_my = wrench_link_2_my_0 + wrench_outside_link_2_my;
    let wrench_outside_link_3_mz = wrench_link_2_mz_0 + wrench_outside_link_2_mz;
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
    let wrench_outside_link_4_mx = wrench_link_3_mx_0 + wrench_outside_link_3_mx;
    let wrench_outside_link_4_my = wrench_link_3_my_0 + wrench_outside_link_3_my;
    let wrench_outside_link_4_mz = wrench_link_3_mz_0 + wrench_outside_link_3_mz;
    let wrench_outside_link_4_fx = wrench_link_3_fx_0 + wrench_outside_link_3_fx;
    let wrench_outside_link_4_fy = wrench_link_3_fy_0 + wrench_outside_link_3_fy;
    let wrench_outside_link_4_fz = wrench_link_3_fz_0 + wrench_outside_link_3_fz;
    d_qdot_xi[9] = reactions.reaction_joint_4_wx * wrench_link_4_mx
        + reactions.reaction_joint_4_wy * wrench_link_4_my
        + reactions.reaction_joint_4_wz * wrench_link_4_mz
        + reactions.reaction_joint_4_vx * wrench_link_4_fx
        + reactions.reaction_joint_4_vy * wrench_link_4_fy
        - reactions.minus_reaction_joint_4_vz * wrench_link_4_fz
        - (screws.connection_joint_4_wx * wrench_outside_link_4_mx
            + screws.connection_joint_4_wy * wrench_outside_link_4_my
            + screws.connection_joint_4_wz * wrench_outside_link_4_mz
            + screws.connection_joint_4_vx * wrench_outside_link_4_fx
            + screws.connection_joint_4_vy * wrench_outside_link_4_fy
            + screws.connection_joint_4_vz * wrench_outside_link_4_fz) + 0.0;
    let wrench_outside_link_5_mx = wrench_link_4_mx_0 + wrench_outside_link_4_mx;
    let wrench_outside_link_5_my = wrench_link_4_my_0 + wrench_outside_link_4_my;
    let wrench_outside_link_5_mz = wrench_link_4_mz_0 + wrench_outside_link_4_mz;
    let wrench_outside_link_5_fx = wrench_link_4_fx_0 + wrench_outside_link_4_fx;
    let wrench_outside_link_5_fy = wrench_link_4_fy_0 + wrench_outside_link_4_fy;
    let wrench_outside_link_5_fz = wrench_link_4_fz_0 + wrench_outside_link_4_fz;
    d_qdot_xi[10] = reactions.reaction_joint_5_wx * wrench_link_5_mx
        + reactions.reaction_joint_5_wy * wrench_link_5_my
        + reactions.reaction_joint_5_wz * wrench_link_5_mz
        + reactions.reaction_joint_5_vx * wrench_link_5_fx
        + reactions.reaction_joint_5_vy * wrench_link_5_fy
        + reactions.reaction_joint_5_vz * wrench_link_5_fz
        - (screws.connection_joint_5_wx * wrench_outside_link_5_mx
            + screws.connection_joint_5_wy * wrench_outside_link_5_my
            + screws.connection_joint_5_wz * wrench_outside_link_5_mz
            + screws.connection_joint_5_vx * wrench_outside_link_5_fx
            + screws.connection_joint_5_vy * wrench_outside_link_5_fy
            + screws.connection_joint_5_vz * wrench_outside_link_5_fz) + 0.0;
    let wrench_outside_link_6_mx = wrench_link_5_mx_0 + wrench_outside_link_5_mx;
    let wrench_outside_link_6_my = wrench_link_5_my_0 + wrench_outside_link_5_my;
    let wrench_outside_link_6_mz = wrench_link_5_mz_0 + wrench_outside_link_5_mz;
    let wrench_outside_link_6_fx = wrench_link_5_fx_0 + wrench_outside_link_5_fx;
    let wrench_outside_link_6_fy = wrench_link_5_fy_0 + wrench_outside_link_5_fy;
    let wrench_outside_link_6_fz = wrench_link_5_fz_0 + wrench_outside_link_5_fz;
    d_qdot_xi[11] = reactions.reaction_joint_6_wx * wrench_link_6_mx
        + reactions.reaction_joint_6_wy * wrench_link_6_my
        + reactions.reaction_joint_6_wz * wrench_link_6_mz
        + reactions.reaction_joint_6_vx * wrench_link_6_fx
        + reactions.reaction_joint_6_vy * wrench_link_6_fy
        + reactions.reaction_joint_6_vz * wrench_link_6_fz
        - (screws.connection_joint_6_wx * wrench_outside_link_6_mx
            + screws.connection_joint_6_wy * wrench_outside_link_6_my
            + screws.connection_joint_6_wz * wrench_outside_link_6_mz
            + screws.connection_joint_6_vx * wrench_outside_link_6_fx
            + screws.connection_joint_6_vy * wrench_outside_link_6_fy
            + screws.connection_joint_6_vz * wrench_outside_link_6_fz) + 0.0;
    let wrench_outside_link_7_mx = wrench_link_6_mx_0 + wrench_outside_link_6_mx;
    let wrench_outside_link_7_my = wrench_link_6_my_0 + wrench_outside_link_6_my;
    let wrench_outside_link_7_mz = wrench_link_6_mz_0 + wrench_outside_link_6_mz;
    let wrench_outside_link_7_fx = wrench_link_6_fx_0 + wrench_outside_link_6_fx;
    let wrench_outside_link_7_fy = wrench_link_6_fy_0 + wrench_outside_link_6_fy;
    let wrench_outside_link_7_fz = wrench_link_6_fz_0 + wrench_outside_link_6_fz;
    d_qdot_xi[12] = reactions.reaction_joint_7_wx * wrench_link_7_mx
        + reactions.reaction_joint_7_wy * wrench_link_7_my
        + reactions.reaction_joint_7_wz * wrench_link_7_mz
        + reactions.reaction_joint_7_vx * wrench_link_7_fx
        + reactions.reaction_joint_7_vy * wrench_link_7_fy
        + reactions.reaction_joint_7_vz * wrench_link_7_fz
        - (screws.connection_joint_7_wx * wrench_outside_link_7_mx
            + screws.connection_joint_7_wy * wrench_outside_link_7_my
            + screws.connection_joint_7_wz * wrench_outside_link_7_mz
            + screws.connection_joint_7_vx * wrench_outside_link_7_fx
            + screws.connection_joint_7_vy * wrench_outside_link_7_fy
            + screws.connection_joint_7_vz * wrench_outside_link_7_fz) + 0.0;
}
/// C(q, V) V in M V̇ + C V = [F₁; τ], V = [V₁; q̇], by one Newton-Euler sweep.
///
/// - `q`: shape (7; rad, m)
/// - `qd`: shape velocity (7; rad/s, m/s)
/// - `base_twist`: body twist of the base, base frame (6; rad/s, m/s)
/// - `hamel_bias`: C V, Coriolis force on V = [V₁; q̇], base frame (13; N·m, N)
///
/// 2652 operations: 1267 + −, 1382 ×, 3 ÷; 7 sin cos; about 31.4 KiB of code.
pub fn hamel_bias(
    q: &[f64; 7],
    qd: &[f64; 7],
    base_twist: &[f64; 6],
    hamel_bias: &mut [f64; 13],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let velocities = velocities(qd, &poses, &screws);
    let minus_twist_link_1_wy_0_0 = base_twist[0] + velocities.minus_velocity_base_wx;
    let twist_link_1_wx_0_0 = base_twist[1] + velocities.minus_velocity_base_wy;
    let minus_wrench_outside_link_1_mx_1_0 = base_twist[2]
        + velocities.minus_velocity_base_wz;
    let minus_wrench_outside_link_1_my_5_1 = base_twist[3]
        + (base_twist[1] * poses.com_z - base_twist[2] * poses.com_y)
        - velocities.velocity_base_vx;
    let minus_wrench_outside_link_1_mx_7_0 = base_twist[4]
        + (base_twist[2] * poses.com_x - base_twist[0] * poses.com_z)
        + velocities.minus_velocity_base_vy;
    let minus_wrench_outside_link_1_mx_5_0 = base_twist[5]
        + (base_twist[0] * poses.com_y - base_twist[1] * poses.com_x)
        + velocities.minus_velocity_base_vz;
    let minus_twist_link_1_wy_0 = minus_twist_link_1_wy_0_0
        - velocities.minus_velocity_base_wx;
    let twist_link_1_wx_0 = twist_link_1_wx_0_0 - velocities.minus_velocity_base_wy;
    let minus_wrench_outside_link_1_mx_1 = minus_wrench_outside_link_1_mx_1_0
        - velocities.minus_velocity_base_wz;
    let minus_wrench_outside_link_1_my_5 = velocities.velocity_base_vx
        + minus_wrench_outside_link_1_my_5_1;
    let minus_wrench_outside_link_1_mx_7 = minus_wrench_outside_link_1_mx_7_0
        - velocities.minus_velocity_base_vy;
    let minus_wrench_outside_link_1_mx_5 = minus_wrench_outside_link_1_mx_5_0
        - velocities.minus_velocity_base_vz;
    let minus_twist_link_1_vy_0 = velocities.velocity_link_1_wz
        + minus_wrench_outside_link_1_mx_1_0;
    let minus_twist_link_1_vy_2 = velocities.velocity_link_1_vx
        + minus_wrench_outside_link_1_my_5_1;
    let wrench_outside_link_2_mx_15 = velocities.velocity_link_1_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_1_wx = twist_link_1_wx_0 * qd[0];
    let minus_twist_link_1_wy = minus_twist_link_1_wy_0 * qd[0];
    let minus_twist_link_1_vy = (minus_twist_link_1_vy_0 * poses.minus_origin_base_y
        + minus_twist_link_1_vy_2) * qd[0];
    let twist_link_1_vz = (minus_twist_link_1_wy_0 * poses.minus_origin_base_x
        + twist_link_1_wx_0 * poses.minus_origin_base_y) * qd[0];
    let minus_twist_link_2_wz_0 = velocities.velocity_link_2_wx
        + minus_twist_link_1_wy_0_0;
    let minus_twist_link_2_wz_2 = twist_link_1_wx_0_0
        - velocities.minus_velocity_link_2_wy;
    let twist_link_2_vz_5 = velocities.velocity_link_2_vx
        + minus_wrench_outside_link_1_my_5_1;
    let twist_link_2_vz_7 = velocities.velocity_link_2_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_2_vy_4 = velocities.velocity_link_2_vz
        + minus_wrench_outside_link_1_mx_5_0;
    let minus_twist_link_2_wz = (minus_twist_link_2_wz_0 * poses.cos_joint_1
        + minus_twist_link_2_wz_2 * poses.sin_joint_1) * qd[1];
    let twist_link_3_wy_3 = velocities.velocity_link_3_wx + minus_twist_link_1_wy_0_0;
    let twist_link_3_wx_1 = twist_link_1_wx_0_0 - velocities.minus_velocity_link_3_wy;
    let twist_link_3_wx_3 = velocities.velocity_link_3_wz
        + minus_wrench_outside_link_1_mx_1_0;
    let twist_link_3_vy_7 = velocities.velocity_link_3_vx
        + minus_wrench_outside_link_1_my_5_1;
    let twist_link_3_vz_5 = velocities.velocity_link_3_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_3_vy_5 = velocities.velocity_link_3_vz
        + minus_wrench_outside_link_1_mx_5_0;
    let twist_link_4_wy_1 = velocities.velocity_link_4_wx + minus_twist_link_1_wy_0_0;
    let twist_link_4_wx_1 = velocities.velocity_link_4_wy + twist_link_1_wx_0_0;
    let twist_link_4_wx_3 = velocities.velocity_link_4_wz
        + minus_wrench_outside_link_1_mx_1_0;
    let twist_link_4_vy_5 = velocities.velocity_link_4_vx
        + minus_wrench_outside_link_1_my_5_1;
    let twist_link_4_vz_3 = velocities.velocity_link_4_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_4_vy_7 = velocities.velocity_link_4_vz
        + minus_wrench_outside_link_1_mx_5_0;
    let twist_link_5_wy_3 = velocities.velocity_link_5_wx + minus_twist_link_1_wy_0_0;
    let twist_link_5_wx_1 = velocities.velocity_link_5_wy + twist_link_1_wx_0_0;
    let twist_link_5_wx_3 = velocities.velocity_link_5_wz
        + minus_wrench_outside_link_1_mx_1_0;
    let twist_link_5_vy_7 = velocities.velocity_link_5_vx
        + minus_wrench_outside_link_1_my_5_1;
    let twist_link_5_vz_5 = velocities.velocity_link_5_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_5_vy_5 = velocities.velocity_link_5_vz
        + minus_wrench_outside_link_1_mx_5_0;
    let twist_link_6_wy_3 = velocities.velocity_link_6_wx + minus_twist_link_1_wy_0_0;
    let twist_link_6_wx_1 = velocities.velocity_link_6_wy + twist_link_1_wx_0_0;
    let twist_link_6_wx_3 = velocities.velocity_link_6_wz
        + minus_wrench_outside_link_1_mx_1_0;
    let twist_link_6_vy_7 = velocities.velocity_link_6_vx
        + minus_wrench_outside_link_1_my_5_1;
    let twist_link_6_vz_7 = velocities.velocity_link_6_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_6_vy_5 = velocities.velocity_link_6_vz
        + minus_wrench_outside_link_1_mx_5_0;
    let twist_link_7_wy_3 = velocities.velocity_link_7_wx + minus_twist_link_1_wy_0_0;
    let twist_link_7_wx_1 = velocities.velocity_link_7_wy + twist_link_1_wx_0_0;
    let twist_link_7_wx_3 = velocities.velocity_link_7_wz
        + minus_wrench_outside_link_1_mx_1_0;
    let twist_link_7_vy_7 = velocities.velocity_link_7_vx
        + minus_wrench_outside_link_1_my_5_1;
    let twist_link_7_vz_5 = velocities.velocity_link_7_vy
        + minus_wrench_outside_link_1_mx_7_0;
    let twist_link_7_vy_5 = velocities.velocity_link_7_vz
        + minus_wrench_outside_link_1_mx_5_0;
    let twist_link_2_wx = twist_link_1_wx
        + minus_twist_link_1_vy_0 * poses.cos_joint_1 * qd[1];
    let twist_link_2_wy = minus_twist_link_1_vy_0 * poses.sin_joint_1 * qd[1]
        - minus_twist_link_1_wy;
    let twist_link_2_vy = (minus_twist_link_1_vy_0 * screws.screw_joint_2_vx
        - minus_twist_link_2_wz_0 * screws.screw_joint_2_vz
        + twist_link_2_vy_4 * poses.sin_joint_1) * qd[1] - minus_twist_link_1_vy;
    let twist_link_2_vz = twist_link_1_vz
        + (minus_twist_link_2_wz_0 * screws.screw_joint_2_vy
            - minus_twist_link_2_wz_2 * screws.screw_joint_2_vx
            - (twist_link_2_vz_5 * poses.cos_joint_1
                + twist_link_2_vz_7 * poses.sin_joint_1)) * qd[1];
    let twist_link_3_wx = twist_link_2_wx
        + (twist_link_3_wx_1 * poses.cos_joint_2
            + twist_link_3_wx_3 * poses.minus_rotation_link_2_yy) * qd[2];
    let twist_link_3_wy = twist_link_2_wy
        - (twist_link_3_wx_3 * poses.minus_rotation_link_2_xy
            + twist_link_3_wy_3 * poses.cos_joint_2) * qd[2];
    let twist_link_3_wz = (twist_link_3_wx_1 * poses.minus_rotation_link_2_xy
        - twist_link_3_wy_3 * poses.minus_rotation_link_2_yy) * qd[2]
        - minus_twist_link_2_wz;
    let twist_link_3_vy = twist_link_2_vy
        + (twist_link_3_wx_3 * screws.screw_joint_3_vx
            - twist_link_3_wy_3 * screws.screw_joint_3_vz
            - (twist_link_3_vy_5 * poses.minus_rotation_link_2_xy
                + twist_link_3_vy_7 * poses.cos_joint_2)) * qd[2];
    let twist_link_3_vz = twist_link_2_vz
        + (twist_link_3_wy_3 * screws.screw_joint_3_vy
            - twist_link_3_wx_1 * screws.screw_joint_3_vx
            + (twist_link_3_vz_5 * poses.minus_rotation_link_2_xy
                - twist_link_3_vy_7 * poses.minus_rotation_link_2_yy)) * qd[2];
    let twist_link_4_wx = twist_link_3_wx
        - (twist_link_4_wx_1 * poses.minus_rotation_link_3_zy
            + twist_link_4_wx_3 * poses.rotation_link_3_yy) * qd[3];
    let twist_link_4_wy = twist_link_3_wy
        + (twist_link_4_wy_1 * poses.minus_rotation_link_3_zy
            - twist_link_4_wx_3 * poses.minus_rotation_link_3_xy) * qd[3];
    let twist_link_4_wz = twist_link_3_wz
        + (twist_link_4_wy_1 * poses.rotation_link_3_yy
            + twist_link_4_wx_1 * poses.minus_rotation_link_3_xy) * qd[3];
    let twist_link_4_vy = twist_link_3_vy
        + (twist_link_4_wx_3 * screws.screw_joint_4_vx
            + twist_link_4_wy_1 * screws.minus_screw_joint_4_vz
            + (twist_link_4_vy_5 * poses.minus_rotation_link_3_zy
                - twist_link_4_vy_7 * poses.minus_rotation_link_3_xy)) * qd[3];
    let twist_link_4_vz = twist_link_3_vz
        + (twist_link_4_vy_5 * poses.rotation_link_3_yy
            + twist_link_4_vz_3 * poses.minus_rotation_link_3_xy
            - (twist_link_4_wy_1 * screws.minus_screw_joint_4_vy
                + twist_link_4_wx_1 * screws.screw_joint_4_vx)) * qd[3];
    let twist_link_5_wx = twist_link_4_wx
        + (twist_link_5_wx_1 * poses.rotation_link_5_zz
            + twist_link_5_wx_3 * poses.rotation_link_4_yy) * qd[4];
    let twist_link_5_wy = twist_link_4_wy
        - (twist_link_5_wx_3 * poses.rotation_link_4_xy
            + twist_link_5_wy_3 * poses.rotation_link_5_zz) * qd[4];
    let twist_link_5_wz = twist_link_4_wz
        + (twist_link_5_wx_1 * poses.rotation_link_4_xy
            - twist_link_5_wy_3 * poses.rotation_link_4_yy) * qd[4];
    let twist_link_5_vy = twist_link_4_vy
        + (twist_link_5_wx_3 * screws.screw_joint_5_vx
            - twist_link_5_wy_3 * screws.screw_joint_5_vz
            - (twist_link_5_vy_5 * poses.rotation_link_4_xy
                + twist_link_5_vy_7 * poses.rotation_link_5_zz)) * qd[4];
    let twist_link_5_vz = twist_link_4_vz
        + (twist_link_5_wy_3 * screws.screw_joint_5_vy
            - twist_link_5_wx_1 * screws.screw_joint_5_vx
            + (twist_link_5_vz_5 * poses.rotation_link_4_xy
                - twist_link_5_vy_7 * poses.rotation_link_4_yy)) * qd[4];
    let twist_link_6_wx = twist_link_5_wx
        + (twist_link_6_wx_1 * poses.rotation_link_6_zz
            + twist_link_6_wx_3 * poses.rotation_link_5_yy) * qd[5];
    let twist_link_6_wy = twist_link_5_wy
        + (twist_link_6_wx_3 * poses.rotation_link_6_xz
            - twist_link_6_wy_3 * poses.rotation_link_6_zz) * qd[5];
    let twist_link_6_wz = twist_link_5_wz
        - (twist_link_6_wy_3 * poses.rotation_link_5_yy
            + twist_link_6_wx_1 * poses.rotation_link_6_xz) * qd[5];
    let twist_link_6_vy = twist_link_5_vy
        + (twist_link_6_wx_3 * screws.screw_joint_6_vx
            - twist_link_6_wy_3 * screws.screw_joint_6_vz
            + (twist_link_6_vy_5 * poses.rotation_link_6_xz
                - twist_link_6_vy_7 * poses.rotation_link_6_zz)) * qd[5];
    let twist_link_6_vz = twist_link_5_vz
        + (twist_link_6_wy_3 * screws.screw_joint_6_vy
            - twist_link_6_wx_1 * screws.screw_joint_6_vx
            - (twist_link_6_vy_7 * poses.rotation_link_5_yy
                + twist_link_6_vz_7 * poses.rotation_link_6_xz)) * qd[5];
    let twist_link_7_wx = twist_link_6_wx
        + (twist_link_7_wx_1 * poses.rotation_link_6_zy
            + twist_link_7_wx_3 * poses.minus_rotation_link_6_yy) * qd[6];
    let twist_link_7_wy = twist_link_6_wy
        - (twist_link_7_wx_3 * poses.minus_rotation_link_6_xy
            + twist_link_7_wy_3 * poses.rotation_link_6_zy) * qd[6];
    let twist_link_7_wz = twist_link_6_wz
        + (twist_link_7_wx_1 * poses.minus_rotation_link_6_xy
            - twist_link_7_wy_3 * poses.minus_rotation_link_6_yy) * qd[6];
    let twist_link_7_vy = twist_link_6_vy
        + (twist_link_7_wx_3 * screws.screw_joint_7_vx
            - twist_link_7_wy_3 * screws.screw_joint_7_vz
            - (twist_link_7_vy_5 * poses.minus_rotation_link_6_xy
                + twist_link_7_vy_7 * poses.rotation_link_6_zy)) * qd[6];
    let twist_link_7_vz = twist_link_6_vz
        + (twist_link_7_wy_3 * screws.screw_joint_7_vy
            - twist_link_7_wx_1 * screws.screw_joint_7_vx
            + (twist_link_7_vz_5 * poses.minus_rotation_link_6_xy
                - twist_link_7_vy_7 * poses.minus_rotation_link_6_yy)) * qd[6];
    let minus_wrench_outside_link_1_mx_0 = inertias.inertia_base_yy * twist_link_1_wx_0
        - inertias.minus_inertia_base_xy * minus_twist_link_1_wy_0
        - inertias.minus_inertia_base_yz * minus_wrench_outside_link_1_mx_1
        + (inertias.minus_inertia_base_hx * minus_wrench_outside_link_1_mx_5
            - inertias.minus_inertia_base_hz * minus_wrench_outside_link_1_my_5);
    let minus_wrench_outside_link_1_mx_2 = inertias.inertia_base_zz
        * minus_wrench_outside_link_1_mx_1
        - (inertias.minus_inertia_base_xz * minus_twist_link_1_wy_0
            + inertias.minus_inertia_base_yz * twist_link_1_wx_0)
        + (inertias.minus_inertia_base_hy * minus_wrench_outside_link_1_my_5
            - inertias.minus_inertia_base_hx * minus_wrench_outside_link_1_mx_7);
    let minus_wrench_outside_link_1_fy_2 = minus_wrench_outside_link_1_my_5 * 3.5
        + (minus_wrench_outside_link_1_mx_1 * inertias.minus_inertia_base_hy
            - twist_link_1_wx_0 * inertias.minus_inertia_base_hz);
    let minus_wrench_outside_link_1_mx_4 = minus_wrench_outside_link_1_mx_7 * 3.5
        + (minus_twist_link_1_wy_0 * inertias.minus_inertia_base_hz
            - minus_wrench_outside_link_1_mx_1 * inertias.minus_inertia_base_hx);
    let minus_wrench_outside_link_1_mx_6 = minus_wrench_outside_link_1_mx_5 * 3.5
        + (twist_link_1_wx_0 * inertias.minus_inertia_base_hx
            - minus_twist_link_1_wy_0 * inertias.minus_inertia_base_hy);
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
        - inertias.minus_inertia_link_1_yz * minus_twist_link_1_vy_0
        + (inertias.inertia_link_1_hz * minus_twist_link_1_vy_2
            + inertias.minus_inertia_link_1_hx * minus_wrench_outside_link_1_mx_5);
    let wrench_outside_link_2_mx_10 = inertias.inertia_link_1_xz
        * minus_twist_link_1_wy_0 - inertias.minus_inertia_link_1_yz * twist_link_1_wx_0
        + inertias.inertia_link_1_zz * minus_twist_link_1_vy_0
        - (inertias.minus_inertia_link_1_hx * wrench_outside_link_2_mx_15
            + inertias.inertia_link_1_hy * minus_twist_link_1_vy_2);
    let minus_wrench_outside_link_2_fy_6 = minus_twist_link_1_vy_2 * 2.0
        + (twist_link_1_wx_0 * inertias.inertia_link_1_hz
            - minus_twist_link_1_vy_0 * inertias.inertia_link_1_hy);
    let wrench_outside_link_2_mx_12 = wrench_outside_link_2_mx_15 * 2.0
        - (minus_twist_link_1_vy_0 * inertias.minus_inertia_link_1_hx
            + minus_twist_link_1_wy_0 * inertias.inertia_link_1_hz);
    let wrench_outside_link_2_mx_14 = minus_wrench_outside_link_1_mx_5 * 2.0
        + (minus_twist_link_1_wy_0 * inertias.inertia_link_1_hy
            + twist_link_1_wx_0 * inertias.minus_inertia_link_1_hx);
    let wrench_outside_link_2_mx = inertias.inertia_link_1_xx * twist_link_1_wx
        - inertias.inertia_link_1_xy * minus_twist_link_1_wy
        + (inertias.inertia_link_1_hy * twist_link_1_vz
            + inertias.inertia_link_1_hz * minus_twist_link_1_vy)
        - (wrench_outside_link_2_mx_8 * minus_twist_link_1_vy_0
            - wrench_outside_link_2_mx_10 * twist_link_1_wx_0
            + (wrench_outside_link_2_mx_12 * minus_wrench_outside_link_1_mx_5
                - wrench_outside_link_2_mx_14 * wrench_outside_link_2_mx_15));
    let minus_wrench_outside_link_2_fy = minus_twist_link_1_vy * 2.0
        + twist_link_1_wx * inertias.inertia_link_1_hz
        + (wrench_outside_link_2_mx_14 * minus_twist_link_1_wy_0
            - minus_wrench_outside_link_2_fy_6 * minus_twist_link_1_vy_0);
    let wrench_outside_link_2_fz = twist_link_1_vz * 2.0
        + (twist_link_1_wx * inertias.inertia_link_1_hy
            - minus_twist_link_1_wy * inertias.minus_inertia_link_1_hx)
        - (minus_wrench_outside_link_2_fy_6 * twist_link_1_wx_0
            - wrench_outside_link_2_mx_12 * minus_twist_link_1_wy_0);
    let wrench_outside_link_3_mx_10 = inertias.inertia_link_2_xy
        * minus_twist_link_2_wz_0 + inertias.inertia_link_2_yy * minus_twist_link_2_wz_2
        + inertias.inertia_link_2_yz * minus_twist_link_1_vy_0
        + (inertias.inertia_link_2_hz * twist_link_2_vz_5
            - inertias.inertia_link_2_hx * twist_link_2_vy_4);
    let wrench_outside_link_3_mx_12 = inertias.inertia_link_2_xz
        * minus_twist_link_2_wz_0 + inertias.inertia_link_2_yz * minus_twist_link_2_wz_2
        + inertias.inertia_link_2_zz * minus_twist_link_1_vy_0
        + (inertias.inertia_link_2_hx * twist_link_2_vz_7
            + inertias.minus_inertia_link_2_hy * twist_link_2_vz_5);
    let wrench_outside_link_3_fy_8 = twist_link_2_vz_5 * 2.0
        + (minus_twist_link_2_wz_2 * inertias.inertia_link_2_hz
            + minus_twist_link_1_vy_0 * inertias.minus_inertia_link_2_hy);
    let wrench_outside_link_3_mx_14 = twist_link_2_vz_7 * 2.0
        + (minus_twist_link_1_vy_0 * inertias.inertia_link_2_hx
            - minus_twist_link_2_wz_0 * inertias.inertia_link_2_hz);
    let wrench_outside_link_3_mx_16 = twist_link_2_vy_4 * 2.0
        - (minus_twist_link_2_wz_0 * inertias.minus_inertia_link_2_hy
            + minus_twist_link_2_wz_2 * inertias.inertia_link_2_hx);
    let wrench_outside_link_3_mx = inertias.inertia_link_2_xx * twist_link_2_wx
        + inertias.inertia_link_2_xy * twist_link_2_wy
        - inertias.inertia_link_2_xz * minus_twist_link_2_wz
        - (inertias.minus_inertia_link_2_hy * twist_link_2_vz
            + inertias.inertia_link_2_hz * twist_link_2_vy)
        - (wrench_outside_link_3_mx_10 * minus_twist_link_1_vy_0
            - wrench_outside_link_3_mx_12 * minus_twist_link_2_wz_2
            + (wrench_outside_link_3_mx_14 * twist_link_2_vy_4
                - wrench_outside_link_3_mx_16 * twist_link_2_vz_7));
    let wrench_outside_link_3_fy = twist_link_2_vy * 2.0
        - (minus_twist_link_2_wz * inertias.inertia_link_2_hx
            + twist_link_2_wx * inertias.inertia_link_2_hz)
        - (wrench_outside_link_3_mx_16 * minus_twist_link_2_wz_0
            - wrench_outside_link_3_fy_8 * minus_twist_link_1_vy_0);
    let wrench_outside_link_3_fz = twist_link_2_vz * 2.0
        - (twist_link_2_wx * inertias.minus_inertia_link_2_hy
            + twist_link_2_wy * inertias.inertia_link_2_hx)
        - (wrench_outside_link_3_fy_8 * minus_twist_link_2_wz_2
            - wrench_outside_link_3_mx_14 * minus_twist_link_2_wz_0);
    let wrench_outside_link_4_mx_10 = inertias.inertia_link_3_xy * twist_link_3_wy_3
        + inertias.inertia_link_3_yy * twist_link_3_wx_1
        + inertias.inertia_link_3_yz * twist_link_3_wx_3
        + (inertias.inertia_link_3_hz * twist_link_3_vy_7
            - inertias.inertia_link_3_hx * twist_link_3_vy_5);
    let wrench_outside_link_4_mx_12 = inertias.inertia_link_3_xz * twist_link_3_wy_3
        + inertias.inertia_link_3_yz * twist_link_3_wx_1
        + inertias.inertia_link_3_zz * twist_link_3_wx_3
        + (inertias.inertia_link_3_hx * twist_link_3_vz_5
            + inertias.minus_inertia_link_3_hy * twist_link_3_vy_7);
    let wrench_outside_link_4_fy_8 = twist_link_3_vy_7 * 2.0
        + (twist_link_3_wx_1 * inertias.inertia_link_3_hz
            + twist_link_3_wx_3 * inertias.minus_inertia_link_3_hy);
    let wrench_outside_link_4_mx_14 = twist_link_3_vz_5 * 2.0
        + (twist_link_3_wx_3 * inertias.inertia_link_3_hx
            - twist_link_3_wy_3 * inertias.inertia_link_3_hz);
    let wrench_outside_link_4_mx_16 = twist_link_3_vy_5 * 2.0
        - (twist_link_3_wy_3 * inertias.minus_inertia_link_3_hy
            + twist_link_3_wx_1 * inertias.inertia_link_3_hx);
    let wrench_outside_link_4_mx = inertias.inertia_link_3_xx * twist_link_3_wx
        + inertias.inertia_link_3_xy * twist_link_3_wy
        + inertias.inertia_link_3_xz * twist_link_3_wz
        - (inertias.minus_inertia_link_3_hy * twist_link_3_vz
            + inertias.inertia_link_3_hz * twist_link_3_vy)
        - (wrench_outside_link_4_mx_10 * twist_link_3_wx_3
            - wrench_outside_link_4_mx_12 * twist_link_3_wx_1
            + (wrench_outside_link_4_mx_14 * twist_link_3_vy_5
                - wrench_outside_link_4_mx_16 * twist_link_3_vz_5));
    let wrench_outside_link_4_fy = twist_link_3_vy * 2.0
        + (twist_link_3_wz * inertias.inertia_link_3_hx
            - twist_link_3_wx * inertias.inertia_link_3_hz)
        - (wrench_outside_link_4_mx_16 * twist_link_3_wy_3
            - wrench_outside_link_4_fy_8 * twist_link_3_wx_3);
    let wrench_outside_link_4_fz = twist_link_3_vz * 2.0
        - (twist_link_3_wx * inertias.minus_inertia_link_3_hy
            + twist_link_3_wy * inertias.inertia_link_3_hx)
        - (wrench_outside_link_4_fy_8 * twist_link_3_wx_1
            - wrench_outside_link_4_mx_14 * twist_link_3_wy_3);
    let wrench_outside_link_5_mx_10 = inertias.inertia_link_4_xy * twist_link_4_wy_1
        + inertias.inertia_link_4_yy * twist_link_4_wx_1
        + inertias.inertia_link_4_yz * twist_link_4_wx_3
        + (inertias.inertia_link_4_hz * twist_link_4_vy_5
            + inertias.minus_inertia_link_4_hx * twist_link_4_vy_7);
    let wrench_outside_link_5_mx_12 = inertias.inertia_link_4_xz * twist_link_4_wy_1
        + inertias.inertia_link_4_yz * twist_link_4_wx_1
        + inertias.inertia_link_4_zz * twist_link_4_wx_3
        - (inertias.minus_inertia_link_4_hx * twist_link_4_vz_3
            + inertias.inertia_link_4_hy * twist_link_4_vy_5);
    let wrench_outside_link_5_fy_8 = twist_link_4_vy_5 * 2.0
        + (twist_link_4_wx_1 * inertias.inertia_link_4_hz
            - twist_link_4_wx_3 * inertias.inertia_link_4_hy);
    let wrench_outside_link_5_mx_14 = twist_link_4_vz_3 * 2.0
        - (twist_link_4_wx_3 * inertias.minus_inertia_link_4_hx
            + twist_link_4_wy_1 * inertias.inertia_link_4_hz);
    let wrench_outside_link_5_mx_16 = twist_link_4_vy_7 * 2.0
        + (twist_link_4_wy_1 * inertias.inertia_link_4_hy
            + twist_link_4_wx_1 * inertias.minus_inertia_link_4_hx);
    let wrench_outside_link_5_mx = inertias.inertia_link_4_xx * twist_link_4_wx
        + inertias.inertia_link_4_xy * twist_link_4_wy
        + inertias.inertia_link_4_xz * twist_link_4_wz
        + (inertias.inertia_link_4_hy * twist_link_4_vz
            - inertias.inertia_link_4_hz * twist_link_4_vy)
        - (wrench_outside_link_5_mx_10 * twist_link_4_wx_3
            - wrench_outside_link_5_mx_12 * twist_link_4_wx_1
            + (wrench_outside_link_5_mx_14 * twist_link_4_vy_7
                - wrench_outside_link_5_mx_16 * twist_link_4_vz_3));
    let wrench_outside_link_5_fy = twist_link_4_vy * 2.0
        - (twist_link_4_wz * inertias.minus_inertia_link_4_hx
            + twist_link_4_wx * inertias.inertia_link_4_hz)
        - (wrench_outside_link_5_mx_16 * twist_link_4_wy_1
            - wrench_outside_link_5_fy_8 * twist_link_4_wx_3);
    let wrench_outside_link_5_fz = twist_link_4_vz * 2.0
        + (twist_link_4_wx * inertias.inertia_link_4_hy
            + twist_link_4_wy * inertias.minus_inertia_link_4_hx)
        - (wrench_outside_link_5_fy_8 * twist_link_4_wx_1
            - wrench_outside_link_5_mx_14 * twist_link_4_wy_1);
    let wrench_outside_link_6_mx_10 = inertias.inertia_link_5_xy * twist_link_5_wy_3
        + inertias.inertia_link_5_yy * twist_link_5_wx_1
        + inertias.inertia_link_5_yz * twist_link_5_wx_3
        + (inertias.inertia_link_5_hz * twist_link_5_vy_7
            + inertias.minus_inertia_link_5_hx * twist_link_5_vy_5);
    let wrench_outside_link_6_mx_12 = inertias.inertia_link_5_xz * twist_link_5_wy_3
        + inertias.inertia_link_5_yz * twist_link_5_wx_1
        + inertias.inertia_link_5_zz * twist_link_5_wx_3
        - (inertias.minus_inertia_link_5_hx * twist_link_5_vz_5
            + inertias.inertia_link_5_hy * twist_link_5_vy_7);
    let wrench_outside_link_6_fy_8 = twist_link_5_vy_7 * 2.0
        + (twist_link_5_wx_1 * inertias.inertia_link_5_hz
            - twist_link_5_wx_3 * inertias.inertia_link_5_hy);
    let wrench_outside_link_6_mx_14 = twist_link_5_vz_5 * 2.0
        - (twist_link_5_wx_3 * inertias.minus_inertia_link_5_hx
            + twist_link_5_wy_3 * inertias.inertia_link_5_hz);
    let wrench_outside_link_6_mx_16 = twist_link_5_vy_5 * 2.0
        + (twist_link_5_wy_3 * inertias.inertia_link_5_hy
            + twist_link_5_wx_1 * inertias.minus_inertia_link_5_hx);
    let wrench_outside_link_6_mx = inertias.inertia_link_5_xx * twist_link_5_wx
        + inertias.inertia_link_5_xy * twist_link_5_wy
        + inertias.inertia_link_5_xz * twist_link_5_wz
        + (inertias.inertia_link_5_hy * twist_link_5_vz
            - inertias.inertia_link_5_hz * twist_link_5_vy)
        - (wrench_outside_link_6_mx_10 * twist_link_5_wx_3
            - wrench_outside_link_6_mx_12 * twist_link_5_wx_1
            + (wrench_outside_link_6_mx_14 * twist_link_5_vy_5
                - wrench_outside_link_6_mx_16 * twist_link_5_vz_5));
    let wrench_outside_link_6_fy = twist_link_5_vy * 2.0
        - (twist_link_5_wz * inertias.minus_inertia_link_5_hx
            + twist_link_5_wx * inertias.inertia_link_5_hz)
        - (wrench_outside_link_6_mx_16 * twist_link_5_wy_3
            - wrench_outside_link_6_fy_8 * twist_link_5_wx_3);
    let wrench_outside_link_6_fz = twist_link_5_vz * 2.0
        + (twist_link_5_wx * inertias.inertia_link_5_hy
            + twist_link_5_wy * inertias.minus_inertia_link_5_hx)
        - (wrench_outside_link_6_fy_8 * twist_link_5_wx_1
            - wrench_outside_link_6_mx_14 * twist_link_5_wy_3);
    let wrench_outside_link_7_mx_10 = inertias.inertia_link_6_yy * twist_link_6_wx_1
        - inertias.minus_inertia_link_6_xy * twist_link_6_wy_3
        + inertias.inertia_link_6_yz * twist_link_6_wx_3
        + (inertias.inertia_link_6_hz * twist_link_6_vy_7
            + inertias.minus_inertia_link_6_hx * twist_link_6_vy_5);
    let wrench_outside_link_7_mx_12 = inertias.inertia_link_6_xz * twist_link_6_wy_3
        + inertias.inertia_link_6_yz * twist_link_6_wx_1
        + inertias.inertia_link_6_zz * twist_link_6_wx_3
        + (inertias.minus_inertia_link_6_hy * twist_link_6_vy_7
            - inertias.minus_inertia_link_6_hx * twist_link_6_vz_7);
    let wrench_outside_link_7_fy_8 = twist_link_6_vy_7 * 2.0
        + (twist_link_6_wx_1 * inertias.inertia_link_6_hz
            + twist_link_6_wx_3 * inertias.minus_inertia_link_6_hy);
    let wrench_outside_link_7_mx_14 = twist_link_6_vz_7 * 2.0
        - (twist_link_6_wx_3 * inertias.minus_inertia_link_6_hx
            + twist_link_6_wy_3 * inertias.inertia_link_6_hz);
    let wrench_outside_link_7_mx_16 = twist_link_6_vy_5 * 2.0
        + (twist_link_6_wx_1 * inertias.minus_inertia_link_6_hx
            - twist_link_6_wy_3 * inertias.minus_inertia_link_6_hy);
    let wrench_outside_link_7_mx = inertias.inertia_link_6_xx * twist_link_6_wx
        - inertias.minus_inertia_link_6_xy * twist_link_6_wy
        + inertias.inertia_link_6_xz * twist_link_6_wz
        - (inertias.minus_inertia_link_6_hy * twist_link_6_vz
            + inertias.inertia_link_6_hz * twist_link_6_vy)
        - (wrench_outside_link_7_mx_10 * twist_link_6_wx_3
            - wrench_outside_link_7_mx_12 * twist_link_6_wx_1
            + (wrench_outside_link_7_mx_14 * twist_link_6_vy_5
                - wrench_outside_link_7_mx_16 * twist_link_6_vz_7));
    let wrench_outside_link_7_fy = twist_link_6_vy * 2.0
        - (twist_link_6_wz * inertias.minus_inertia_link_6_hx
            + twist_link_6_wx * inertias.inertia_link_6_hz)
        - (wrench_outside_link_7_mx_16 * twist_link_6_wy_3
            - wrench_outside_link_7_fy_8 * twist_link_6_wx_3);
    let wrench_outside_link_7_fz = twist_link_6_vz * 2.0
        + (twist_link_6_wy * inertias.minus_inertia_link_6_hx
            - twist_link_6_wx * inertias.minus_inertia_link_6_hy)
        - (wrench_outside_link_7_fy_8 * twist_link_6_wx_1
            - wrench_outside_link_7_mx_14 * twist_link_6_wy_3);
    let wrench_link_7_mx_10 = inertias.inertia_link_7_yy * twist_link_7_wx_1
        - inertias.minus_inertia_link_7_xy * twist_link_7_wy_3
        + inertias.inertia_link_7_yz * twist_link_7_wx_3
        + (inertias.inertia_link_7_hz * twist_link_7_vy_7
            + inertias.minus_inertia_link_7_hx * twist_link_7_vy_5);
    let wrench_link_7_mx_12 = inertias.inertia_link_7_xz * twist_link_7_wy_3
        + inertias.inertia_link_7_yz * twist_link_7_wx_1
        + inertias.inertia_link_7_zz * twist_link_7_wx_3
        + (inertias.minus_inertia_link_7_hy * twist_link_7_vy_7
            - inertias.minus_inertia_link_7_hx * twist_link_7_vz_5);
    let wrench_link_7_fy_8 = twist_link_7_vy_7 * 2.0
        + (twist_link_7_wx_1 * inertias.inertia_link_7_hz
            + twist_link_7_wx_3 * inertias.minus_inertia_link_7_hy);
    let wrench_link_7_mx_14 = twist_link_7_vz_5 * 2.0
        - (twist_link_7_wx_3 * inertias.minus_inertia_link_7_hx
            + twist_link_7_wy_3 * inertias.inertia_link_7_hz);
    let wrench_link_7_mx_16 = twist_link_7_vy_5 * 2.0
        + (twist_link_7_wx_1 * inertias.minus_inertia_link_7_hx
            - twist_link_7_wy_3 * inertias.minus_inertia_link_7_hy);
    let wrench_link_7_mx = inertias.inertia_link_7_xx * twist_link_7_wx
        - inertias.minus_inertia_link_7_xy * twist_link_7_wy
        + inertias.inertia_link_7_xz * twist_link_7_wz
        - (inertias.minus_inertia_link_7_hy * twist_link_7_vz
            + inertias.inertia_link_7_hz * twist_link_7_vy)
        - (wrench_link_7_mx_10 * twist_link_7_wx_3
            - wrench_link_7_mx_12 * twist_link_7_wx_1
            + (wrench_link_7_mx_14 * twist_link_7_vy_5
                - wrench_link_7_mx_16 * twist_link_7_vz_5));
    let wrench_link_7_fy = twist_link_7_vy * 2.0
        - (twist_link_7_wz * inertias.minus_inertia_link_7_hx
            + twist_link_7_wx * inertias.inertia_link_7_hz)
        - (wrench_link_7_mx_16 * twist_link_7_wy_3
            - wrench_link_7_fy_8 * twist_link_7_wx_3);
    let wrench_link_7_fz = twist_link_7_vz * 2.0
        + (twist_link_7_wy * inertias.minus_inertia_link_7_hx
            - twist_link_7_wx * inertias.minus_inertia_link_7_hy)
        - (wrench_link_7_fy_8 * twist_link_7_wx_1
            - wrench_link_7_mx_14 * twist_link_7_wy_3);
    let wrench_link_6_mx = wrench_outside_link_7_mx + wrench_link_7_mx;
    let wrench_link_6_fy = wrench_outside_link_7_fy + wrench_link_7_fy;
    let wrench_link_6_fz = wrench_outside_link_7_fz + wrench_link_7_fz;
    let wrench_link_5_mx = wrench_outside_link_6_mx + wrench_link_6_mx;
    let wrench_link_5_fy = wrench_outside_link_6_fy + wrench_link_6_fy;
    let wrench_link_5_fz = wrench_outside_link_6_fz + wrench_link_6_fz;
    let wrench_link_4_mx = wrench_outside_link_5_mx + wrench_link_5_mx;
    let wrench_link_4_fy = wrench_outside_link_5_fy + wrench_link_5_fy;
    let wrench_link_4_fz = wrench_outside_link_5_fz + wrench_link_5_fz;
    let wrench_link_3_mx = wrench_outside_link_4_mx + wrench_link_4_mx;
    let wrench_link_3_fy = wrench_outside_link_4_fy + wrench_link_4_fy;
    let wrench_link_3_fz = wrench_outside_link_4_fz + wrench_link_4_fz;
    let wrench_link_2_mx = wrench_outside_link_3_mx + wrench_link_3_mx;
    let wrench_link_2_fy = wrench_outside_link_3_fy + wrench_link_3_fy;
    let wrench_link_2_fz = wrench_outside_link_3_fz + wrench_link_3_fz;
    let wrench_link_1_mx = wrench_outside_link_2_mx + wrench_link_2_mx;
    let wrench_link_1_fy = wrench_link_2_fy - minus_wrench_outside_link_2_fy;
    let wrench_link_1_fz = wrench_outside_link_2_fz + wrench_link_2_fz;
    let wrench_base_mx = wrench_link_1_mx - minus_wrench_outside_link_1_mx;
    let wrench_base_fy = wrench_link_1_fy - minus_wrench_outside_link_1_fy;
    let wrench_base_fz = wrench_link_1_fz - minus_wrench_outside_link_1_fz;
    // C V
    hamel_bias[0] = wrench_base_mx
        + (wrench_base_fz * poses.com_y - wrench_base_fy * poses.com_z) + 0.0;
    let twist_link_1_vx = (wrench_outside_link_2_mx_15
        - minus_twist_link_1_vy_0 * poses.minus_origin_base_x) * qd[0];
    let twist_link_2_vx = twist_link_1_vx
        + (minus_twist_link_2_wz_2 * screws.screw_joint_2_vz
            - minus_twist_link_1_vy_0 * screws.screw_joint_2_vy
            + twist_link_2_vy_4 * poses.cos_joint_1) * qd[1];
    let twist_link_3_vx = twist_link_2_vx
        + (twist_link_3_wx_1 * screws.screw_joint_3_vz
            - twist_link_3_wx_3 * screws.screw_joint_3_vy
            + (twist_link_3_vz_5 * poses.cos_joint_2
                + twist_link_3_vy_5 * poses.minus_rotation_link_2_yy)) * qd[2];
    let twist_link_4_vx = twist_link_3_vx
        + (twist_link_4_wx_3 * screws.minus_screw_joint_4_vy
            - twist_link_4_wx_1 * screws.minus_screw_joint_4_vz
            - (twist_link_4_vz_3 * poses.minus_rotation_link_3_zy
                + twist_link_4_vy_7 * poses.rotation_link_3_yy)) * qd[3];
    let twist_link_5_vx = twist_link_4_vx
        + (twist_link_5_wx_1 * screws.screw_joint_5_vz
            - twist_link_5_wx_3 * screws.screw_joint_5_vy
            + (twist_link_5_vz_5 * poses.rotation_link_5_zz
                + twist_link_5_vy_5 * poses.rotation_link_4_yy)) * qd[4];
    let twist_link_6_vx = twist_link_5_vx
        + (twist_link_6_wx_1 * screws.screw_joint_6_vz
            - twist_link_6_wx_3 * screws.screw_joint_6_vy
            + (twist_link_6_vz_7 * poses.rotation_link_6_zz
                + twist_link_6_vy_5 * poses.rotation_link_5_yy)) * qd[5];
    let twist_link_7_vx = twist_link_6_vx
        + (twist_link_7_wx_1 * screws.screw_joint_7_vz
            - twist_link_7_wx_3 * screws.screw_joint_7_vy
            + (twist_link_7_vz_5 * poses.rotation_link_6_zy
                + twist_link_7_vy_5 * poses.minus_rotation_link_6_yy)) * qd[6];
    let minus_wrench_outside_link_1_my_2 = inertias.inertia_base_xx
        * minus_twist_link_1_wy_0 - inertias.minus_inertia_base_xy * twist_link_1_wx_0
        - inertias.minus_inertia_base_xz * minus_wrench_outside_link_1_mx_1
        + (inertias.minus_inertia_base_hz * minus_wrench_outside_link_1_mx_7
            - inertias.minus_inertia_base_hy * minus_wrench_outside_link_1_mx_5);
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
        + inertias.inertia_link_1_xz * minus_twist_link_1_vy_0
        + (inertias.inertia_link_1_hy * minus_wrench_outside_link_1_mx_5
            - inertias.inertia_link_1_hz * wrench_outside_link_2_mx_15);
    let wrench_outside_link_2_my = inertias.inertia_link_1_xy * twist_link_1_wx
        - inertias.inertia_link_1_yy * minus_twist_link_1_wy
        + (inertias.inertia_link_1_hz * twist_link_1_vx
            + inertias.minus_inertia_link_1_hx * twist_link_1_vz)
        - (wrench_outside_link_2_mx_10 * minus_twist_link_1_wy_0
            - wrench_outside_link_2_my_10 * minus_twist_link_1_vy_0
            + (wrench_outside_link_2_mx_14 * minus_twist_link_1_vy_2
                - minus_wrench_outside_link_2_fy_6 * minus_wrench_outside_link_1_mx_5));
    let wrench_outside_link_2_fx = twist_link_1_vx * 2.0
        - minus_twist_link_1_wy * inertias.inertia_link_1_hz
        - (wrench_outside_link_2_mx_12 * minus_twist_link_1_vy_0
            - wrench_outside_link_2_mx_14 * twist_link_1_wx_0);
    let wrench_outside_link_3_my_12 = inertias.inertia_link_2_xx
        * minus_twist_link_2_wz_0 + inertias.inertia_link_2_xy * minus_twist_link_2_wz_2
        + inertias.inertia_link_2_xz * minus_twist_link_1_vy_0
        - (inertias.minus_inertia_link_2_hy * twist_link_2_vy_4
            + inertias.inertia_link_2_hz * twist_link_2_vz_7);
    let wrench_outside_link_3_my = inertias.inertia_link_2_xy * twist_link_2_wx
        + inertias.inertia_link_2_yy * twist_link_2_wy
        - inertias.inertia_link_2_yz * minus_twist_link_2_wz
        + (inertias.inertia_link_2_hz * twist_link_2_vx
            - inertias.inertia_link_2_hx * twist_link_2_vz)
        - (wrench_outside_link_3_mx_12 * minus_twist_link_2_wz_0
            - wrench_outside_link_3_my_12 * minus_twist_link_1_vy_0
            + (wrench_outside_link_3_mx_16 * twist_link_2_vz_5
                - wrench_outside_link_3_fy_8 * twist_link_2_vy_4));
    let wrench_outside_link_3_fx = twist_link_2_vx * 2.0
        + (twist_link_2_wy * inertias.inertia_link_2_hz
            - minus_twist_link_2_wz * inertias.minus_inertia_link_2_hy)
        - (wrench_outside_link_3_mx_14 * minus_twist_link_1_vy_0
            - wrench_outside_link_3_mx_16 * minus_twist_link_2_wz_2);
    let wrench_outside_link_4_my_12 = inertias.inertia_link_3_xx * twist_link_3_wy_3
        + inertias.inertia_link_3_xy * twist_link_3_wx_1
        + inertias.inertia_link_3_xz * twist_link_3_wx_3
        - (inertias.minus_inertia_link_3_hy * twist_link_3_vy_5
            + inertias.inertia_link_3_hz * twist_link_3_vz_5);
    let wrench_outside_link_4_my = inertias.inertia_link_3_xy * twist_link_3_wx
        + inertias.inertia_link_3_yy * twist_link_3_wy
        + inertias.inertia_link_3_yz * twist_link_3_wz
        + (inertias.inertia_link_3_hz * twist_link_3_vx
            - inertias.inertia_link_3_hx * twist_link_3_vz)
        - (wrench_outside_link_4_mx_12 * twist_link_3_wy_3
            - wrench_outside_link_4_my_12 * twist_link_3_wx_3
            + (wrench_outside_link_4_mx_16 * twist_link_3_vy_7
                - wrench_outside_link_4_fy_8 * twist_link_3_vy_5));
    let wrench_outside_link_4_fx = twist_link_3_vx * 2.0
        + (twist_link_3_wy * inertias.inertia_link_3_hz
            + twist_link_3_wz * inertias.minus_inertia_link_3_hy)
        - (wrench_outside_link_4_mx_14 * twist_link_3_wx_3
            - wrench_outside_link_4_mx_16 * twist_link_3_wx_1);
    let wrench_outside_link_5_my_12 = inertias.inertia_link_4_xx * twist_link_4_wy_1
        + inertias.inertia_link_4_xy * twist_link_4_wx_1
        + inertias.inertia_link_4_xz * twist_link_4_wx_3
        + (inertias.inertia_link_4_hy * twist_link_4_vy_7
            - inertias.inertia_link_4_hz * twist_link_4_vz_3);
    let wrench_outside_link_5_my = inertias.inertia_link_4_xy * twist_link_4_wx
        + inertias.inertia_link_4_yy * twist_link_4_wy
        + inertias.inertia_link_4_yz * twist_link_4_wz
        + (inertias.inertia_link_4_hz * twist_link_4_vx
            + inertias.minus_inertia_link_4_hx * twist_link_4_vz)
        - (wrench_outside_link_5_mx_12 * twist_link_4_wy_1
            - wrench_outside_link_5_my_12 * twist_link_4_wx_3
            + (wrench_outside_link_5_mx_16 * twist_link_4_vy_5
                - wrench_outside_link_5_fy_8 * twist_link_4_vy_7));
    let wrench_outside_link_5_fx = twist_link_4_vx * 2.0
        + (twist_link_4_wy * inertias.inertia_link_4_hz
            - twist_link_4_wz * inertias.inertia_link_4_hy)
        - (wrench_outside_link_5_mx_14 * twist_link_4_wx_3
            - wrench_outside_link_5_mx_16 * twist_link_4_wx_1);
    let wrench_outside_link_6_my_12 = inertias.inertia_link_5_xx * twist_link_5_wy_3
        + inertias.inertia_link_5_xy * twist_link_5_wx_1
        + inertias.inertia_link_5_xz * twist_link_5_wx_3
        + (inertias.inertia_link_5_hy * twist_link_5_vy_5
            - inertias.inertia_link_5_hz * twist_link_5_vz_5);
    let wrench_outside_link_6_my = inertias.inertia_link_5_xy * twist_link_5_wx
        + inertias.inertia_link_5_yy * twist_link_5_wy
        + inertias.inertia_link_5_yz * twist_link_5_wz
        + (inertias.inertia_link_5_hz * twist_link_5_vx
            + inertias.minus_inertia_link_5_hx * twist_link_5_vz)
        - (wrench_outside_link_6_mx_12 * twist_link_5_wy_3
            - wrench_outside_link_6_my_12 * twist_link_5_wx_3
            + (wrench_outside_link_6_mx_16 * twist_link_5_vy_7
                - wrench_outside_link_6_fy_8 * twist_link_5_vy_5));
    let wrench_outside_link_6_fx = twist_link_5_vx * 2.0
        + (twist_link_5_wy * inertias.inertia_link_5_hz
            - twist_link_5_wz * inertias.inertia_link_5_hy)
        - (wrench_outside_link_6_mx_14 * twist_link_5_wx_3
            - wrench_outside_link_6_mx_16 * twist_link_5_wx_1);
    let wrench_outside_link_7_my_12 = inertias.inertia_link_6_xx * twist_link_6_wy_3
        - inertias.minus_inertia_link_6_xy * twist_link_6_wx_1
        + inertias.inertia_link_6_xz * twist_link_6_wx_3
        - (inertias.minus_inertia_link_6_hy * twist_link_6_vy_5
            + inertias.inertia_link_6_hz * twist_link_6_vz_7);
    let wrench_outside_link_7_my = inertias.inertia_link_6_yy * twist_link_6_wy
        - inertias.minus_inertia_link_6_xy * twist_link_6_wx
        + inertias.inertia_link_6_yz * twist_link_6_wz
        + (inertias.inertia_link_6_hz * twist_link_6_vx
            + inertias.minus_inertia_link_6_hx * twist_link_6_vz)
        - (wrench_outside_link_7_mx_12 * twist_link_6_wy_3
            - wrench_outside_link_7_my_12 * twist_link_6_wx_3
            + (wrench_outside_link_7_mx_16 * twist_link_6_vy_7
                - wrench_outside_link_7_fy_8 * twist_link_6_vy_5));
    let wrench_outside_link_7_fx = twist_link_6_vx * 2.0
        + (twist_link_6_wy * inertias.inertia_link_6_hz
            + twist_link_6_wz * inertias.minus_inertia_link_6_hy)
        - (wrench_outside_link_7_mx_14 * twist_link_6_wx_3
            - wrench_outside_link_7_mx_16 * twist_link_6_wx_1);
    let wrench_link_7_my_12 = inertias.inertia_link_7_xx * twist_link_7_wy_3
        - inertias.minus_inertia_link_7_xy * twist_link_7_wx_1
        + inertias.inertia_link_7_xz * twist_link_7_wx_3
        - (inertias.minus_inertia_link_7_hy * twist_link_7_vy_5
            + inertias.inertia_link_7_hz * twist_link_7_vz_5);
    let wrench_link_7_my = inertias.inertia_link_7_yy * twist_link_7_wy
        - inertias.minus_inertia_link_7_xy * twist_link_7_wx
        + inertias.inertia_link_7_yz * twist_link_7_wz
        + (inertias.inertia_link_7_hz * twist_link_7_vx
            + inertias.minus_inertia_link_7_hx * twist_link_7_vz)
        - (wrench_link_7_mx_12 * twist_link_7_wy_3
            - wrench_link_7_my_12 * twist_link_7_wx_3
            + (wrench_link_7_mx_16 * twist_link_7_vy_7
                - wrench_link_7_fy_8 * twist_link_7_vy_5));
    let wrench_link_7_fx = twist_link_7_vx * 2.0
        + (twist_link_7_wy * inertias.inertia_link_7_hz
            + twist_link_7_wz * inertias.minus_inertia_link_7_hy)
        - (wrench_link_7_mx_14 * twist_link_7_wx_3
            - wrench_link_7_mx_16 * twist_link_7_wx_1);
    let wrench_link_6_my = wrench_outside_link_7_my + wrench_link_7_my;
    let wrench_link_6_fx = wrench_outside_link_7_fx + wrench_link_7_fx;
    let wrench_link_5_my = wrench_outside_link_6_my + wrench_link_6_my;
    let wrench_link_5_fx = wrench_outside_link_6_fx + wrench_link_6_fx;
    let wrench_link_4_my = wrench_outside_link_5_my + wrench_link_5_my;
    let wrench_link_4_fx = wrench_outside_link_5_fx + wrench_link_5_fx;
    let wrench_link_3_my = wrench_outside_link_4_my + wrench_link_4_my;
    let wrench_link_3_fx = wrench_outside_link_4_fx + wrench_link_4_fx;
    let wrench_link_2_my = wrench_outside_link_3_my + wrench_link_3_my;
    let wrench_link_2_fx = wrench_outside_link_3_fx + wrench_link_3_fx;
    let wrench_link_1_my = wrench_outside_link_2_my + wrench_link_2_my;
    let wrench_link_1_fx = wrench_outside_link_2_fx + wrench_link_2_fx;
    let wrench_base_my = wrench_link_1_my - minus_wrench_outside_link_1_my;
    let wrench_base_fx = wrench_link_1_fx - minus_wrench_outside_link_1_fx;
    hamel_bias[1] = wrench_base_my
        + (wrench_base_fx * poses.com_z - wrench_base_fz * poses.com_x) + 0.0;
    let minus_wrench_outside_link_1_mz = minus_wrench_outside_link_1_my_2
        * twist_link_1_wx_0 - minus_wrench_outside_link_1_mx_0 * minus_twist_link_1_wy_0
        + (minus_wrench_outside_link_1_fy_2 * minus_wrench_outside_link_1_mx_7
            - minus_wrench_outside_link_1_mx_4 * minus_wrench_outside_link_1_my_5);
    let wrench_outside_link_2_mz = inertias.inertia_link_1_xz * twist_link_1_wx
        + inertias.minus_inertia_link_1_yz * minus_twist_link_1_wy
        + (inertias.minus_inertia_link_1_hx * minus_twist_link_1_vy
            - inertias.inertia_link_1_hy * twist_link_1_vx)
        - (wrench_outside_link_2_my_10 * twist_link_1_wx_0
            - wrench_outside_link_2_mx_8 * minus_twist_link_1_wy_0
            + (minus_wrench_outside_link_2_fy_6 * wrench_outside_link_2_mx_15
                - wrench_outside_link_2_mx_12 * minus_twist_link_1_vy_2));
    let wrench_outside_link_3_mz = inertias.inertia_link_2_xz * twist_link_2_wx
        + inertias.inertia_link_2_yz * twist_link_2_wy
        - inertias.inertia_link_2_zz * minus_twist_link_2_wz
        + (inertias.inertia_link_2_hx * twist_link_2_vy
            + inertias.minus_inertia_link_2_hy * twist_link_2_vx)
        - (wrench_outside_link_3_my_12 * minus_twist_link_2_wz_2
            - wrench_outside_link_3_mx_10 * minus_twist_link_2_wz_0
            + (wrench_outside_link_3_fy_8 * twist_link_2_vz_7
                - wrench_outside_link_3_mx_14 * twist_link_2_vz_5));
    let wrench_outside_link_4_mz = inertias.inertia_link_3_xz * twist_link_3_wx
        + inertias.inertia_link_3_yz * twist_link_3_wy
        + inertias.inertia_link_3_zz * twist_link_3_wz
        + (inertias.inertia_link_3_hx * twist_link_3_vy
            + inertias.minus_inertia_link_3_hy * twist_link_3_vx)
        - (wrench_outside_link_4_my_12 * twist_link_3_wx_1
            - wrench_outside_link_4_mx_10 * twist_link_3_wy_3
            + (wrench_outside_link_4_fy_8 * twist_link_3_vz_5
                - wrench_outside_link_4_mx_14 * twist_link_3_vy_7));
    let wrench_outside_link_5_mz = inertias.inertia_link_4_xz * twist_link_4_wx
        + inertias.inertia_link_4_yz * twist_link_4_wy
        + inertias.inertia_link_4_zz * twist_link_4_wz
        - (inertias.minus_inertia_link_4_hx * twist_link_4_vy
            + inertias.inertia_link_4_hy * twist_link_4_vx)
        - (wrench_outside_link_5_my_12 * twist_link_4_wx_1
            - wrench_outside_link_5_mx_10 * twist_link_4_wy_1
            + (wrench_outside_link_5_fy_8 * twist_link_4_vz_3
                - wrench_outside_link_5_mx_14 * twist_link_4_vy_5));
    let wrench_outside_link_6_mz = inertias.inertia_link_5_xz * twist_link_5_wx
        + inertias.inertia_link_5_yz * twist_link_5_wy
        + inertias.inertia_link_5_zz * twist_link_5_wz
        - (inertias.minus_inertia_link_5_hx * twist_link_5_vy
            + inertias.inertia_link_5_hy * twist_link_5_vx)
        - (wrench_outside_link_6_my_12 * twist_link_5_wx_1
            - wrench_outside_link_6_mx_10 * twist_link_5_wy_3
            + (wrench_outside_link_6_fy_8 * twist_link_5_vz_5
                - wrench_outside_link_6_mx_14 * twist_link_5_vy_7));
    let wrench_outside_link_7_mz = inertias.inertia_link_6_xz * twist_link_6_wx
        + inertias.inertia_link_6_yz * twist_link_6_wy
        + inertias.inertia_link_6_zz * twist_link_6_wz
        + (inertias.minus_inertia_link_6_hy * twist_link_6_vx
            - inertias.minus_inertia_link_6_hx * twist_link_6_vy)
        - (wrench_outside_link_7_my_12 * twist_link_6_wx_1
            - wrench_outside_link_7_mx_10 * twist_link_6_wy_3
            + (wrench_outside_link_7_fy_8 * twist_link_6_vz_7
                - wrench_outside_link_7_mx_14 * twist_link_6_vy_7));
    let wrench_link_7_mz = inertias.inertia_link_7_xz * twist_link_7_wx
        + inertias.inertia_link_7_yz * twist_link_7_wy
        + inertias.inertia_link_7_zz * twist_link_7_wz
        + (inertias.minus_inertia_link_7_hy * twist_link_7_vx
            - inertias.minus_inertia_link_7_hx * twist_link_7_vy)
        - (wrench_link_7_my_12 * twist_link_7_wx_1
            - wrench_link_7_mx_10 * twist_link_7_wy_3
            + (wrench_link_7_fy_8 * twist_link_7_vz_5
                - wrench_link_7_mx_14 * twist_link_7_vy_7));
    let wrench_link_6_mz = wrench_outside_link_7_mz + wrench_link_7_mz;
    let wrench_link_5_mz = wrench_outside_link_6_mz + wrench_link_6_mz;
    let wrench_link_4_mz = wrench_outside_link_5_mz + wrench_link_5_mz;
    let wrench_link_3_mz = wrench_outside_link_4_mz + wrench_link_4_mz;
    let wrench_link_2_mz = wrench_outside_link_3_mz + wrench_link_3_mz;
    let wrench_link_1_mz = wrench_outside_link_2_mz + wrench_link_2_mz;
    let wrench_base_mz = wrench_link_1_mz - minus_wrench_outside_link_1_mz;
    hamel_bias[2] = wrench_base_mz
        + (wrench_base_fy * poses.com_x - wrench_base_fx * poses.com_y) + 0.0;
    hamel_bias[3] = wrench_base_fx + 0.0;
    hamel_bias[4] = wrench_base_fy + 0.0;
    hamel_bias[5] = wrench_base_fz + 0.0;
    hamel_bias[6] = wrench_link_1_mz - poses.minus_origin_base_y * wrench_link_1_fx
        + poses.minus_origin_base_x * wrench_link_1_fy + 0.0;
    hamel_bias[7] = poses.sin_joint_1 * wrench_link_2_mx
        - poses.cos_joint_1 * wrench_link_2_my
        + screws.screw_joint_2_vx * wrench_link_2_fx
        + screws.screw_joint_2_vy * wrench_link_2_fy
        + screws.screw_joint_2_vz * wrench_link_2_fz + 0.0;
    hamel_bias[8] = poses.cos_joint_2 * wrench_link_3_mz
        - (poses.minus_rotation_link_2_xy * wrench_link_3_mx
            + poses.minus_rotation_link_2_yy * wrench_link_3_my)
        + screws.screw_joint_3_vx * wrench_link_3_fx
        + screws.screw_joint_3_vy * wrench_link_3_fy
        + screws.screw_joint_3_vz * wrench_link_3_fz + 0.0;
    hamel_bias[9] = poses.rotation_link_3_yy * wrench_link_4_my
        - poses.minus_rotation_link_3_xy * wrench_link_4_mx
        - poses.minus_rotation_link_3_zy * wrench_link_4_mz
        + screws.screw_joint_4_vx * wrench_link_4_fx
        - screws.minus_screw_joint_4_vy * wrench_link_4_fy
        - screws.minus_screw_joint_4_vz * wrench_link_4_fz + 0.0;
    hamel_bias[10] = poses.rotation_link_5_zz * wrench_link_5_mz
        - (poses.rotation_link_4_xy * wrench_link_5_mx
            + poses.rotation_link_4_yy * wrench_link_5_my)
        + screws.screw_joint_5_vx * wrench_link_5_fx
        + screws.screw_joint_5_vy * wrench_link_5_fy
        + screws.screw_joint_5_vz * wrench_link_5_fz + 0.0;
    hamel_bias[11] = poses.rotation_link_6_xz * wrench_link_6_mx
        - poses.rotation_link_5_yy * wrench_link_6_my
        + poses.rotation_link_6_zz * wrench_link_6_mz
        + screws.screw_joint_6_vx * wrench_link_6_fx
        + screws.screw_joint_6_vy * wrench_link_6_fy
        + screws.screw_joint_6_vz * wrench_link_6_fz + 0.0;
    hamel_bias[12] = poses.rotation_link_6_zy * wrench_link_7_mz
        - (poses.minus_rotation_link_6_xy * wrench_link_7_mx
            + poses.minus_rotation_link_6_yy * wrench_link_7_my)
        + screws.screw_joint_7_vx * wrench_link_7_fx
        + screws.screw_joint_7_vy * wrench_link_7_fy
        + screws.screw_joint_7_vz * wrench_link_7_fz + 0.0;
}
/// 𝓑(e_i, e_j) = ∂_i A_j − ∂_j A_i − ad_{A_i} A_j for all pairs of coordinates.
///
/// - `q`: shape (7; rad, m)
/// - `curvature`: 𝓑_ω(e_i, e_j), angular part of the curvature, base axes: x, y, z (3 of 7×7, by columns; rad)
/// - `com`: c, total centre of mass, base frame; 𝓑_v = c × 𝓑_ω (3; m)
///
/// 3601 operations: 1773 + −, 1825 ×, 3 ÷; 7 sin cos; about 42.5 KiB of code.
pub fn curvature(q: &[f64; 7], curvature: &mut [[[f64; 7]; 7]; 3], com: &mut [f64; 3]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
    let common_d_mu_b2_curvature = common_d_mu_b2_curvature(
        &poses,
        &inertias,
        &complements,
        &screws,
    );
    // 𝓑_ω(e_i, e_j) x, column joint_1
    curvature[0][0][0] = 0.0;
    let curvature_x_1_0_21_1_2_3 = (inertias.locked_inverse_pivot_z_4
        * inertias.locked_inverse_pivot_y_2 - inertias.locked_inverse_pivot_z_2)
        * inertias.locked_inverse_pivot_z;
    let curvature_x_1_0_21_1_2 = inertias.locked_inverse_pivot_y_2
        * inertias.locked_inverse_pivot_y
        + inertias.locked_inverse_pivot_z_4 * curvature_x_1_0_21_1_2_3;
    let curvature_x_1_0_21_1 = inertias.locked_inverse_pivot_x
        + inertias.locked_inverse_pivot_y_2 * curvature_x_1_0_21_1_2
        - inertias.locked_inverse_pivot_z_2 * curvature_x_1_0_21_1_2_3;
    let curvature_x_1_0_21 = common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_1_0 * curvature_x_1_0_21_1_2
        - outside.outside_joint_1_my * curvature_x_1_0_21_1_2_3;
    let curvature_x_1_0_23 = reactions.reaction_joint_1_wz
        - (common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_1_0 * curvature_x_1_0_21_1
            + outside.outside_joint_1_mx * curvature_x_1_0_21_1_2_3);
    let curvature_x_1_0_25 = reactions.reaction_joint_1_wy
        + (common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_0_0 * curvature_x_1_0_21_1_2_3
            - (outside.outside_joint_1_my * curvature_x_1_0_21_1
                + outside.outside_joint_1_mx * curvature_x_1_0_21_1_2));
    let curvature_x_1_0 = reactions.reaction_joint_1_wx
        * (common_d_mu_and_7_more.three_joint_2_x_0_0_0 * curvature_x_1_0_21_1
            + common_d_mu_and_7_more.three_joint_2_x_0_1_0 * curvature_x_1_0_21_1_2
            + common_d_mu_and_7_more.three_joint_2_x_1_0 * curvature_x_1_0_21_1_2_3)
        + reactions.reaction_joint_1_wy
            * (common_d_mu_and_7_more.three_joint_2_y_1_0 * curvature_x_1_0_21_1_2_3
                - (common_d_mu_and_7_more.three_joint_2_x_0_1_0 * curvature_x_1_0_21_1
                    + common_d_mu_and_7_more.three_joint_2_y_0_0_0
                        * curvature_x_1_0_21_1_2))
        + reactions.reaction_joint_1_wz
            * (common_d_mu_and_7_more.three_joint_2_x_1_0 * curvature_x_1_0_21_1
                - common_d_mu_and_7_more.three_joint_2_y_1_0 * curvature_x_1_0_21_1_2
                + common_d_mu_and_7_more.three_joint_2_z_1_0 * curvature_x_1_0_21_1_2_3)
        - curvature_x_1_0_21 * screws.connection_joint_2_wx
        + curvature_x_1_0_23 * screws.connection_joint_2_wy
        - curvature_x_1_0_25 * screws.connection_joint_2_wz;
    curvature[0][0][1] = curvature_x_1_0 + 0.0;
    let curvature_x_2_0_1 = common_d_mu_and_7_more.three_joint_3_x_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_3_x_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_3_x_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_2_0_3 = common_d_mu_and_7_more.three_joint_3_x_0_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_3_y_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_2_0_5 = common_d_mu_and_7_more.three_joint_3_x_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_3_y_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_3_z_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_2_0 = reactions.reaction_joint_1_wx * curvature_x_2_0_1
        + reactions.reaction_joint_1_wy * curvature_x_2_0_3
        + reactions.reaction_joint_1_wz * curvature_x_2_0_5
        - curvature_x_1_0_21 * screws.connection_joint_3_wx
        + curvature_x_1_0_23 * screws.connection_joint_3_wy
        - curvature_x_1_0_25 * screws.connection_joint_3_wz;
    curvature[0][0][2] = curvature_x_2_0 + 0.0;
    let curvature_x_3_0_1 = common_d_mu_and_7_more.three_joint_4_x_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_4_x_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_4_x_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_3_0_3 = common_d_mu_and_7_more.three_joint_4_x_0_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_4_y_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_3_0_5 = common_d_mu_and_7_more.three_joint_4_x_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_4_y_1_0 * curvature_x_1_0_21_1_2
        - common_d_mu_and_7_more.three_joint_4_z_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_3_0 = reactions.reaction_joint_1_wx * curvature_x_3_0_1
        + reactions.reaction_joint_1_wy * curvature_x_3_0_3
        + reactions.reaction_joint_1_wz * curvature_x_3_0_5
        - curvature_x_1_0_21 * screws.connection_joint_4_wx
        + curvature_x_1_0_23 * screws.connection_joint_4_wy
        - curvature_x_1_0_25 * screws.connection_joint_4_wz;
    curvature[0][0][3] = curvature_x_3_0 + 0.0;
    let curvature_x_4_0_1 = common_d_mu_and_7_more.three_joint_5_x_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_5_x_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_5_x_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_4_0_3 = common_d_mu_and_7_more.three_joint_5_x_0_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_5_y_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_4_0_5 = common_d_mu_and_7_more.three_joint_5_x_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_5_y_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_5_z_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_4_0 = reactions.reaction_joint_1_wx * curvature_x_4_0_1
        + reactions.reaction_joint_1_wy * curvature_x_4_0_3
        + reactions.reaction_joint_1_wz * curvature_x_4_0_5
        - curvature_x_1_0_21 * screws.connection_joint_5_wx
        + curvature_x_1_0_23 * screws.connection_joint_5_wy
        - curvature_x_1_0_25 * screws.connection_joint_5_wz;
    curvature[0][0][4] = curvature_x_4_0 + 0.0;
    let curvature_x_5_0_1 = common_d_mu_and_7_more.three_joint_6_x_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_6_x_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_6_x_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_5_0_3 = common_d_mu_and_7_more.three_joint_6_x_0_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_6_y_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_5_0_5 = common_d_mu_and_7_more.three_joint_6_x_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_6_y_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_6_z_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_5_0 = reactions.reaction_joint_1_wx * curvature_x_5_0_1
        + reactions.reaction_joint_1_wy * curvature_x_5_0_3
        + reactions.reaction_joint_1_wz * curvature_x_5_0_5
        - curvature_x_1_0_21 * screws.connection_joint_6_wx
        + curvature_x_1_0_23 * screws.connection_joint_6_wy
        - curvature_x_1_0_25 * screws.connection_joint_6_wz;
    curvature[0][0][5] = curvature_x_5_0 + 0.0;
    let curvature_x_6_0_1 = common_d_mu_and_7_more.three_joint_7_x_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_7_x_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_7_x_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_6_0_3 = common_d_mu_and_7_more.three_joint_7_x_0_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_7_y_0_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_6_0_5 = common_d_mu_and_7_more.three_joint_7_x_1_0
        * curvature_x_1_0_21_1
        - common_d_mu_and_7_more.three_joint_7_y_1_0 * curvature_x_1_0_21_1_2
        + common_d_mu_and_7_more.three_joint_7_z_1_0 * curvature_x_1_0_21_1_2_3;
    let curvature_x_6_0 = reactions.reaction_joint_1_wx * curvature_x_6_0_1
        + reactions.reaction_joint_1_wy * curvature_x_6_0_3
        + reactions.reaction_joint_1_wz * curvature_x_6_0_5
        - curvature_x_1_0_21 * screws.connection_joint_7_wx
        + curvature_x_1_0_23 * screws.connection_joint_7_wy
        - curvature_x_1_0_25 * screws.connection_joint_7_wz;
    curvature[0][0][6] = curvature_x_6_0 + 0.0;
    // 𝓑_ω(e_i, e_j) x, column joint_2
    curvature[0][1][0] = 0.0 - curvature_x_1_0;
    curvature[0][1][1] = 0.0;
    let curvature_x_2_1_14_1 = curvature_x_1_0_21_1 * 35.0;
    let curvature_x_2_1_12_3 = curvature_x_1_0_21_1_2 * 35.0;
    let curvature_x_2_1_12_1 = curvature_x_1_0_21_1_2_3 * 35.0;
    let curvature_x_2_1_6 = common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0
            * curvature_x_1_0_21_1_2
        + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_1_0
            * curvature_x_1_0_21_1_2_3;
    let curvature_x_2_1_8 = reactions.reaction_joint_2_wz
        - (common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0 * curvature_x_1_0_21_1
            - common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_0_1_0
                * curvature_x_1_0_21_1_2
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2_3);
    let curvature_x_2_1_10 = reactions.reaction_joint_2_wy
        + (common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_1_0 * curvature_x_1_0_21_1
            - common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2_3);
    let curvature_x_2_1_12 = reactions.reaction_joint_2_vy * curvature_x_2_1_12_1
        + reactions.reaction_joint_2_vz * curvature_x_2_1_12_3;
    let curvature_x_2_1_14 = reactions.reaction_joint_2_vz * curvature_x_2_1_14_1
        - reactions.reaction_joint_2_vx * curvature_x_2_1_12_1;
    let curvature_x_2_1_16 = reactions.reaction_joint_2_vx * curvature_x_2_1_12_3
        + reactions.reaction_joint_2_vy * curvature_x_2_1_14_1;
    let curvature_x_2_1 = reactions.reaction_joint_2_wx * curvature_x_2_0_1
        + reactions.reaction_joint_2_wy * curvature_x_2_0_3
        + reactions.reaction_joint_2_wz * curvature_x_2_0_5
        - curvature_x_2_1_6 * screws.connection_joint_3_wx
        + curvature_x_2_1_8 * screws.connection_joint_3_wy
        - curvature_x_2_1_10 * screws.connection_joint_3_wz
        + curvature_x_2_1_12 * screws.connection_joint_3_vx
        + curvature_x_2_1_14 * screws.connection_joint_3_vy
        - curvature_x_2_1_16 * screws.connection_joint_3_vz;
    curvature[0][1][2] = curvature_x_2_1 + 0.0;
    let curvature_x_3_1 = reactions.reaction_joint_2_wx * curvature_x_3_0_1
        + reactions.reaction_joint_2_wy * curvature_x_3_0_3
        + reactions.reaction_joint_2_wz * curvature_x_3_0_5
        - curvature_x_2_1_6 * screws.connection_joint_4_wx
        + curvature_x_2_1_8 * screws.connection_joint_4_wy
        - curvature_x_2_1_10 * screws.connection_joint_4_wz
        + curvature_x_2_1_12 * screws.connection_joint_4_vx
        + curvature_x_2_1_14 * screws.connection_joint_4_vy
        - curvature_x_2_1_16 * screws.connection_joint_4_vz;
    curvature[0][1][3] = curvature_x_3_1 + 0.0;
    let curvature_x_4_1 = reactions.reaction_joint_2_wx * curvature_x_4_0_1
        + reactions.reaction_joint_2_wy * curvature_x_4_0_3
        + reactions.reaction_joint_2_wz * curvature_x_4_0_5
        - curvature_x_2_1_6 * screws.connection_joint_5_wx
        + curvature_x_2_1_8 * screws.connection_joint_5_wy
        - curvature_x_2_1_10 * screws.connection_joint_5_wz
        + curvature_x_2_1_12 * screws.connection_joint_5_vx
        + curvature_x_2_1_14 * screws.connection_joint_5_vy
        - curvature_x_2_1_16 * screws.connection_joint_5_vz;
    curvature[0][1][4] = curvature_x_4_1 + 0.0;
    let curvature_x_5_1 = reactions.reaction_joint_2_wx * curvature_x_5_0_1
        + reactions.reaction_joint_2_wy * curvature_x_5_0_3
        + reactions.reaction_joint_2_wz * curvature_x_5_0_5
        - curvature_x_2_1_6 * screws.connection_joint_6_wx
        + curvature_x_2_1_8 * screws.connection_joint_6_wy
        - curvature_x_2_1_10 * screws.connection_joint_6_wz
        + curvature_x_2_1_12 * screws.connection_joint_6_vx
        + curvature_x_2_1_14 * screws.connection_joint_6_vy
        - curvature_x_2_1_16 * screws.connection_joint_6_vz;
    curvature[0][1][5] = curvature_x_5_1 + 0.0;
    let curvature_x_6_1 = reactions.reaction_joint_2_wx * curvature_x_6_0_1
        + reactions.reaction_joint_2_wy * curvature_x_6_0_3
        + reactions.reaction_joint_2_wz * curvature_x_6_0_5
        - curvature_x_2_1_6 * screws.connection_joint_7_wx
        + curvature_x_2_1_8 * screws.connection_joint_7_wy
        - curvature_x_2_1_10 * screws.connection_joint_7_wz
        + curvature_x_2_1_12 * screws.connection_joint_7_vx
        + curvature_x_2_1_14 * screws.connection_joint_7_vy
        - curvature_x_2_1_16 * screws.connection_joint_7_vz;
    curvature[0][1][6] = curvature_x_6_1 + 0.0;
    // 𝓑_ω(e_i, e_j) x, column joint_3
    curvature[0][2][0] = 0.0 - curvature_x_2_0;
    curvature[0][2][1] = 0.0 - curvature_x_2_1;
    curvature[0][2][2] = 0.0;
    let curvature_x_3_2_6 = common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0
            * curvature_x_1_0_21_1_2
        + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_1_0
            * curvature_x_1_0_21_1_2_3;
    let curvature_x_3_2_8 = reactions.reaction_joint_3_wz
        - (common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0 * curvature_x_1_0_21_1
            - common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_0_1_0
                * curvature_x_1_0_21_1_2
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2_3);
    let curvature_x_3_2_10 = reactions.reaction_joint_3_wy
        + (common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_1_0 * curvature_x_1_0_21_1
            - common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2_3);
    let curvature_x_3_2_12 = reactions.reaction_joint_3_vy * curvature_x_2_1_12_1
        + reactions.reaction_joint_3_vz * curvature_x_2_1_12_3;
    let curvature_x_3_2_14 = reactions.reaction_joint_3_vz * curvature_x_2_1_14_1
        - reactions.reaction_joint_3_vx * curvature_x_2_1_12_1;
    let curvature_x_3_2_16 = reactions.reaction_joint_3_vx * curvature_x_2_1_12_3
        + reactions.reaction_joint_3_vy * curvature_x_2_1_14_1;
    let curvature_x_3_2 = reactions.reaction_joint_3_wx * curvature_x_3_0_1
        + reactions.reaction_joint_3_wy * curvature_x_3_0_3
        + reactions.reaction_joint_3_wz * curvature_x_3_0_5
        - curvature_x_3_2_6 * screws.connection_joint_4_wx
        + curvature_x_3_2_8 * screws.connection_joint_4_wy
        - curvature_x_3_2_10 * screws.connection_joint_4_wz
        + curvature_x_3_2_12 * screws.connection_joint_4_vx
        + curvature_x_3_2_14 * screws.connection_joint_4_vy
        - curvature_x_3_2_16 * screws.connection_joint_4_vz;
    curvature[0][2][3] = curvature_x_3_2 + 0.0;
    let curvature_x_4_2 = reactions.reaction_joint_3_wx * curvature_x_4_0_1
        + reactions.reaction_joint_3_wy * curvature_x_4_0_3
        + reactions.reaction_joint_3_wz * curvature_x_4_0_5
        - curvature_x_3_2_6 * screws.connection_joint_5_wx
        + curvature_x_3_2_8 * screws.connection_joint_5_wy
        - curvature_x_3_2_10 * screws.connection_joint_5_wz
        + curvature_x_3_2_12 * screws.connection_joint_5_vx
        + curvature_x_3_2_14 * screws.connection_joint_5_vy
        - curvature_x_3_2_16 * screws.connection_joint_5_vz;
    curvature[0][2][4] = curvature_x_4_2 + 0.0;
    let curvature_x_5_2 = reactions.reaction_joint_3_wx * curvature_x_5_0_1
        + reactions.reaction_joint_3_wy * curvature_x_5_0_3
        + reactions.reaction_joint_3_wz * curvature_x_5_0_5
        - curvature_x_3_2_6 * screws.connection_joint_6_wx
        + curvature_x_3_2_8 * screws.connection_joint_6_wy
        - curvature_x_3_2_10 * screws.connection_joint_6_wz
        + curvature_x_3_2_12 * screws.connection_joint_6_vx
        + curvature_x_3_2_14 * screws.connection_joint_6_vy
        - curvature_x_3_2_16 * screws.connection_joint_6_vz;
    curvature[0][2][5] = curvature_x_5_2 + 0.0;
    let curvature_x_6_2 = reactions.reaction_joint_3_wx * curvature_x_6_0_1
        + reactions.reaction_joint_3_wy * curvature_x_6_0_3
        + reactions.reaction_joint_3_wz * curvature_x_6_0_5
        - curvature_x_3_2_6 * screws.connection_joint_7_wx
        + curvature_x_3_2_8 * screws.connection_joint_7_wy
        - curvature_x_3_2_10 * screws.connection_joint_7_wz
        + curvature_x_3_2_12 * screws.connection_joint_7_vx
        + curvature_x_3_2_14 * screws.connection_joint_7_vy
        - curvature_x_3_2_16 * screws.connection_joint_7_vz;
    curvature[0][2][6] = curvature_x_6_2 + 0.0;
    // 𝓑_ω(e_i, e_j) x, column joint_4
    curvature[0][3][0] = 0.0 - curvature_x_3_0;
    curvature[0][3][1] = 0.0 - curvature_x_3_1;
    curvature[0][3][2] = 0.0 - curvature_x_3_2;
    curvature[0][3][3] = 0.0;
    let curvature_x_4_3_6 = common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0
            * curvature_x_1_0_21_1_2
        + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_1_0
            * curvature_x_1_0_21_1_2_3;
    let curvature_x_4_3_8 = reactions.reaction_joint_4_wz
        - (common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0
            * curvature_x_1_0_21_1
            - common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_0_1_0
                * curvature_x_1_0_21_1_2
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2_3);
    let curvature_x_4_3_10 = reactions.reaction_joint_4_wy
        + (common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_1_0 * curvature_x_1_0_21_1
            - common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2_3);
    let curvature_x_4_3_12 = reactions.reaction_joint_4_vy * curvature_x_2_1_12_1
        - reactions.minus_reaction_joint_4_vz * curvature_x_2_1_12_3;
    let curvature_x_4_3_14 = reactions.minus_reaction_joint_4_vz * curvature_x_2_1_14_1
        + reactions.reaction_joint_4_vx * curvature_x_2_1_12_1;
    let curvature_x_4_3_16 = reactions.reaction_joint_4_vx * curvature_x_2_1_12_3
        + reactions.reaction_joint_4_vy * curvature_x_2_1_14_1;
    let curvature_x_4_3 = reactions.reaction_joint_4_wx * curvature_x_4_0_1
        + reactions.reaction_joint_4_wy * curvature_x_4_0_3
        + reactions.reaction_joint_4_wz * curvature_x_4_0_5
        - curvature_x_4_3_6 * screws.connection_joint_5_wx
        + curvature_x_4_3_8 * screws.connection_joint_5_wy
        - curvature_x_4_3_10 * screws.connection_joint_5_wz
        + curvature_x_4_3_12 * screws.connection_joint_5_vx
        - curvature_x_4_3_14 * screws.connection_joint_5_vy
        - curvature_x_4_3_16 * screws.connection_joint_5_vz;
    curvature[0][3][4] = curvature_x_4_3 + 0.0;
    let curvature_x_5_3 = reactions.reaction_joint_4_wx * curvature_x_5_0_1
        + reactions.reaction_joint_4_wy * curvature_x_5_0_3
        + reactions.reaction_joint_4_wz * curvature_x_5_0_5
        - curvature_x_4_3_6 * screws.connection_joint_6_wx
        + curvature_x_4_3_8 * screws.connection_joint_6_wy
        - curvature_x_4_3_10 * screws.connection_joint_6_wz
        + curvature_x_4_3_12 * screws.connection_joint_6_vx
        - curvature_x_4_3_14 * screws.connection_joint_6_vy
        - curvature_x_4_3_16 * screws.connection_joint_6_vz;
    curvature[0][3][5] = curvature_x_5_3 + 0.0;
    let curvature_x_6_3 = reactions.reaction_joint_4_wx * curvature_x_6_0_1
        + reactions.reaction_joint_4_wy * curvature_x_6_0_3
        + reactions.reaction_joint_4_wz * curvature_x_6_0_5
        - curvature_x_4_3_6 * screws.connection_joint_7_wx
        + curvature_x_4_3_8 * screws.connection_joint_7_wy
        - curvature_x_4_3_10 * screws.connection_joint_7_wz
        + curvature_x_4_3_12 * screws.connection_joint_7_vx
        - curvature_x_4_3_14 * screws.connection_joint_7_vy
        - curvature_x_4_3_16 * screws.connection_joint_7_vz;
    curvature[0][3][6] = curvature_x_6_3 + 0.0;
    // 𝓑_ω(e_i, e_j) x, column joint_5
    curvature[0][4][0] = 0.0 - curvature_x_4_0;
    curvature[0][4][1] = 0.0 - curvature_x_4_1;
    curvature[0][4][2] = 0.0 - curvature_x_4_2;
    curvature[0][4][3] = 0.0 - curvature_x_4_3;
    curvature[0][4][4] = 0.0;
    let curvature_x_5_4_6 = common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0
        * curvature_x_1_0_21_1
        - common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0
            * curvature_x_1_0_21_1_2
        + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_1_0
            * curvature_x_1_0_21_1_2_3;
    let curvature_x_5_4_8 = reactions.reaction_joint_5_wz
        - (common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0
            * curvature_x_1_0_21_1
            - common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_0_1_0
                * curvature_x_1_0_21_1_2
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2_3);
    let curvature_x_5_4_10 = reactions.reaction_joint_5_wy
        + (common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_1_0 * curvature_x_1_0_21_1
            - common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2_3);
    let curvature_x_5_4_12 = reactions.reaction_joint_5_vy * curvature_x_2_1_12_1
        + reactions.reaction_joint_5_vz * curvature_x_2_1_12_3;
    let curvature_x_5_4_14 = reactions.reaction_joint_5_vz * curvature_x_2_1_14_1
        - reactions.reaction_joint_5_vx * curvature_x_2_1_12_1;
    let curvature_x_5_4_16 = reactions.reaction_joint_5_vx * curvature_x_2_1_12_3
        + reactions.reaction_joint_5_vy * curvature_x_2_1_14_1;
    let curvature_x_5_4 = reactions.reaction_joint_5_wx * curvature_x_5_0_1
        + reactions.reaction_joint_5_wy * curvature_x_5_0_3
        + reactions.reaction_joint_5_wz * curvature_x_5_0_5
        - curvature_x_5_4_6 * screws.connection_joint_6_wx
        + curvature_x_5_4_8 * screws.connection_joint_6_wy
        - curvature_x_5_4_10 * screws.connection_joint_6_wz
        + curvature_x_5_4_12 * screws.connection_joint_6_vx
        + curvature_x_5_4_14 * screws.connection_joint_6_vy
        - curvature_x_5_4_16 * screws.connection_joint_6_vz;
    curvature[0][4][5] = curvature_x_5_4 + 0.0;
    let curvature_x_6_4 = reactions.reaction_joint_5_wx * curvature_x_6_0_1
        + reactions.reaction_joint_5_wy * curvature_x_6_0_3
        + reactions.reaction_joint_5_wz * curvature_x_6_0_5
        - curvature_x_5_4_6 * screws.connection_joint_7_wx
        + curvature_x_5_4_8 * screws.connection_joint_7_wy
        - curvature_x_5_4_10 * screws.connection_joint_7_wz
        + curvature_x_5_4_12 * screws.connection_joint_7_vx
        + curvature_x_5_4_14 * screws.connection_joint_7_vy
        - curvature_x_5_4_16 * screws.connection_joint_7_vz;
    curvature[0][4][6] = curvature_x_6_4 + 0.0;
    // 𝓑_ω(e_i, e_j) x, column joint_6
    curvature[0][5][0] = 0.0 - curvature_x_5_0;
    curvature[0][5][1] = 0.0 - curvature_x_5_1;
    curvature[0][5][2] = 0.0 - curvature_x_5_2;
    curvature[0][5][3] = 0.0 - curvature_x_5_3;
    curvature[0][5][4] = 0.0 - curvature_x_5_4;
    curvature[0][5][5] = 0.0;
    let curvature_x_6_5 = reactions.reaction_joint_6_wx * curvature_x_6_0_1
        + reactions.reaction_joint_6_wy * curvature_x_6_0_3
        + reactions.reaction_joint_6_wz * curvature_x_6_0_5
        - (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0
            * curvature_x_1_0_21_1
            - common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0
                * curvature_x_1_0_21_1_2
            + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1_2_3) * screws.connection_joint_7_wx
        + (reactions.reaction_joint_6_wz
            - (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0
                * curvature_x_1_0_21_1
                - common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_0_1_0
                    * curvature_x_1_0_21_1_2
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_1_0
                    * curvature_x_1_0_21_1_2_3)) * screws.connection_joint_7_wy
        - (reactions.reaction_joint_6_wy
            + (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_1_0
                * curvature_x_1_0_21_1
                - common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_1_0
                    * curvature_x_1_0_21_1_2
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_1_0_1_1_0
                    * curvature_x_1_0_21_1_2_3)) * screws.connection_joint_7_wz
        + (reactions.reaction_joint_6_vy * curvature_x_2_1_12_1
            + reactions.reaction_joint_6_vz * curvature_x_2_1_12_3)
            * screws.connection_joint_7_vx
        + (reactions.reaction_joint_6_vz * curvature_x_2_1_14_1
            - reactions.reaction_joint_6_vx * curvature_x_2_1_12_1)
            * screws.connection_joint_7_vy
        - (reactions.reaction_joint_6_vx * curvature_x_2_1_12_3
            + reactions.reaction_joint_6_vy * curvature_x_2_1_14_1)
            * screws.connection_joint_7_vz;
    curvature[0][5][6] = curvature_x_6_5 + 0.0;
    // 𝓑_ω(e_i, e_j) x, column joint_7
    curvature[0][6][0] = 0.0 - curvature_x_6_0;
    curvature[0][6][1] = 0.0 - curvature_x_6_1;
    curvature[0][6][2] = 0.0 - curvature_x_6_2;
    curvature[0][6][3] = 0.0 - curvature_x_6_3;
    curvature[0][6][4] = 0.0 - curvature_x_6_4;
    curvature[0][6][5] = 0.0 - curvature_x_6_5;
    curvature[0][6][6] = 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_1
    curvature[1][0][0] = 0.0;
    let six_joint_1_mx_4 = inertias.locked_inverse_pivot_z_4
        * inertias.locked_inverse_pivot_z;
    let curvature_y_1_0_22_1_3 = inertias.locked_inverse_pivot_y
        + inertias.locked_inverse_pivot_z_4 * six_joint_1_mx_4;
    let curvature_y_1_0_22_1 = inertias.locked_inverse_pivot_z_2 * six_joint_1_mx_4
        - inertias.locked_inverse_pivot_y_2 * curvature_y_1_0_22_1_3;
    let minus_six_joint_1_mz_4 = outside.outside_joint_1_mx * six_joint_1_mx_4;
    let curvature_y_1_0_22 = common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_1_0
        * curvature_y_1_0_22_1 - minus_six_joint_1_mz_4;
    let curvature_y_1_0_20 = reactions.reaction_joint_1_wz
        + (common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_0_0 * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_1_0 * curvature_y_1_0_22_1_3
            + outside.outside_joint_1_my * six_joint_1_mx_4);
    let curvature_y_1_0_24 = reactions.reaction_joint_1_wx
        - (outside.outside_joint_1_mx * curvature_y_1_0_22_1_3
            - outside.outside_joint_1_my * curvature_y_1_0_22_1
            - common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_0_0 * six_joint_1_mx_4);
    let six_more_joint_2_mz_2 = common_d_mu_and_7_more.three_joint_2_y_1_0
        * six_joint_1_mx_4;
    let curvature_y_1_0 = reactions.reaction_joint_1_wx
        * (common_d_mu_and_7_more.three_joint_2_x_0_0_0 * curvature_y_1_0_22_1
            - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * curvature_y_1_0_22_1_3
            - common_d_mu_and_7_more.three_joint_2_x_1_0 * six_joint_1_mx_4)
        + reactions.reaction_joint_1_wy
            * (common_d_mu_and_7_more.three_joint_2_y_0_0_0 * curvature_y_1_0_22_1_3
                - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * curvature_y_1_0_22_1
                - six_more_joint_2_mz_2)
        + reactions.reaction_joint_1_wz
            * (common_d_mu_and_7_more.three_joint_2_x_1_0 * curvature_y_1_0_22_1
                + common_d_mu_and_7_more.three_joint_2_y_1_0 * curvature_y_1_0_22_1_3
                - common_d_mu_and_7_more.three_joint_2_z_1_0 * six_joint_1_mx_4)
        - curvature_y_1_0_20 * screws.connection_joint_2_wx
        - curvature_y_1_0_22 * screws.connection_joint_2_wy
        + curvature_y_1_0_24 * screws.connection_joint_2_wz;
    curvature[1][0][1] = curvature_y_1_0 + 0.0;
    let curvature_y_2_0_1 = common_d_mu_and_7_more.three_joint_3_x_0_0_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_3_x_0_1_0 * curvature_y_1_0_22_1_3
        - common_d_mu_and_7_more.three_joint_3_x_1_0 * six_joint_1_mx_4;
    let six_more_joint_3_mz_2 = common_d_mu_and_7_more.three_joint_3_y_1_0
        * six_joint_1_mx_4;
    let curvature_y_2_0_3 = common_d_mu_and_7_more.three_joint_3_x_0_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_3_y_0_1_0 * curvature_y_1_0_22_1_3
        - six_more_joint_3_mz_2;
    let curvature_y_2_0_5 = common_d_mu_and_7_more.three_joint_3_x_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * curvature_y_1_0_22_1_3
        - common_d_mu_and_7_more.three_joint_3_z_1_0 * six_joint_1_mx_4;
    let curvature_y_2_0 = reactions.reaction_joint_1_wx * curvature_y_2_0_1
        + reactions.reaction_joint_1_wy * curvature_y_2_0_3
        + reactions.reaction_joint_1_wz * curvature_y_2_0_5
        - curvature_y_1_0_20 * screws.connection_joint_3_wx
        - curvature_y_1_0_22 * screws.connection_joint_3_wy
        + curvature_y_1_0_24 * screws.connection_joint_3_wz;
    curvature[1][0][2] = curvature_y_2_0 + 0.0;
    let curvature_y_3_0_1 = common_d_mu_and_7_more.three_joint_4_x_0_0_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_4_x_0_1_0 * curvature_y_1_0_22_1_3
        - common_d_mu_and_7_more.three_joint_4_x_1_0 * six_joint_1_mx_4;
    let six_more_joint_4_mz_2 = common_d_mu_and_7_more.three_joint_4_y_1_0
        * six_joint_1_mx_4;
    let curvature_y_3_0_3 = common_d_mu_and_7_more.three_joint_4_x_0_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_4_y_0_1_0 * curvature_y_1_0_22_1_3
        - six_more_joint_4_mz_2;
    let curvature_y_3_0_5 = common_d_mu_and_7_more.three_joint_4_x_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * curvature_y_1_0_22_1_3
        + common_d_mu_and_7_more.three_joint_4_z_1_0 * six_joint_1_mx_4;
    let curvature_y_3_0 = reactions.reaction_joint_1_wx * curvature_y_3_0_1
        + reactions.reaction_joint_1_wy * curvature_y_3_0_3
        + reactions.reaction_joint_1_wz * curvature_y_3_0_5
        - curvature_y_1_0_20 * screws.connection_joint_4_wx
        - curvature_y_1_0_22 * screws.connection_joint_4_wy
        + curvature_y_1_0_24 * screws.connection_joint_4_wz;
    curvature[1][0][3] = curvature_y_3_0 + 0.0;
    let curvature_y_4_0_1 = common_d_mu_and_7_more.three_joint_5_x_0_0_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_5_x_0_1_0 * curvature_y_1_0_22_1_3
        - common_d_mu_and_7_more.three_joint_5_x_1_0 * six_joint_1_mx_4;
    let six_more_joint_5_mz_2 = common_d_mu_and_7_more.three_joint_5_y_1_0
        * six_joint_1_mx_4;
    let curvature_y_4_0_3 = common_d_mu_and_7_more.three_joint_5_x_0_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_5_y_0_1_0 * curvature_y_1_0_22_1_3
        - six_more_joint_5_mz_2;
    let curvature_y_4_0_5 = common_d_mu_and_7_more.three_joint_5_x_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * curvature_y_1_0_22_1_3
        - common_d_mu_and_7_more.three_joint_5_z_1_0 * six_joint_1_mx_4;
    let curvature_y_4_0 = reactions.reaction_joint_1_wx * curvature_y_4_0_1
        + reactions.reaction_joint_1_wy * curvature_y_4_0_3
        + reactions.reaction_joint_1_wz * curvature_y_4_0_5
        - curvature_y_1_0_20 * screws.connection_joint_5_wx
        - curvature_y_1_0_22 * screws.connection_joint_5_wy
        + curvature_y_1_0_24 * screws.connection_joint_5_wz;
    curvature[1][0][4] = curvature_y_4_0 + 0.0;
    let curvature_y_5_0_1 = common_d_mu_and_7_more.three_joint_6_x_0_0_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_6_x_0_1_0 * curvature_y_1_0_22_1_3
        - common_d_mu_and_7_more.three_joint_6_x_1_0 * six_joint_1_mx_4;
    let six_more_joint_6_mz_2 = common_d_mu_and_7_more.three_joint_6_y_1_0
        * six_joint_1_mx_4;
    let curvature_y_5_0_3 = common_d_mu_and_7_more.three_joint_6_x_0_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_6_y_0_1_0 * curvature_y_1_0_22_1_3
        - six_more_joint_6_mz_2;
    let curvature_y_5_0_5 = common_d_mu_and_7_more.three_joint_6_x_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * curvature_y_1_0_22_1_3
        - common_d_mu_and_7_more.three_joint_6_z_1_0 * six_joint_1_mx_4;
    let curvature_y_5_0 = reactions.reaction_joint_1_wx * curvature_y_5_0_1
        + reactions.reaction_joint_1_wy * curvature_y_5_0_3
        + reactions.reaction_joint_1_wz * curvature_y_5_0_5
        - curvature_y_1_0_20 * screws.connection_joint_6_wx
        - curvature_y_1_0_22 * screws.connection_joint_6_wy
        + curvature_y_1_0_24 * screws.connection_joint_6_wz;
    curvature[1][0][5] = curvature_y_5_0 + 0.0;
    let curvature_y_6_0_1 = common_d_mu_and_7_more.three_joint_7_x_0_0_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_7_x_0_1_0 * curvature_y_1_0_22_1_3
        - common_d_mu_and_7_more.three_joint_7_x_1_0 * six_joint_1_mx_4;
    let six_more_joint_7_mz_2 = common_d_mu_and_7_more.three_joint_7_y_1_0
        * six_joint_1_mx_4;
    let curvature_y_6_0_3 = common_d_mu_and_7_more.three_joint_7_x_0_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_7_y_0_1_0 * curvature_y_1_0_22_1_3
        - six_more_joint_7_mz_2;
    let curvature_y_6_0_5 = common_d_mu_and_7_more.three_joint_7_x_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * curvature_y_1_0_22_1_3
        - common_d_mu_and_7_more.three_joint_7_z_1_0 * six_joint_1_mx_4;
    let curvature_y_6_0 = reactions.reaction_joint_1_wx * curvature_y_6_0_1
        + reactions.reaction_joint_1_wy * curvature_y_6_0_3
        + reactions.reaction_joint_1_wz * curvature_y_6_0_5
        - curvature_y_1_0_20 * screws.connection_joint_7_wx
        - curvature_y_1_0_22 * screws.connection_joint_7_wy
        + curvature_y_1_0_24 * screws.connection_joint_7_wz;
    curvature[1][0][6] = curvature_y_6_0 + 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_2
    curvature[1][1][0] = 0.0 - curvature_y_1_0;
    curvature[1][1][1] = 0.0;
    let curvature_y_2_1_14_1 = curvature_y_1_0_22_1 * 35.0;
    let curvature_y_2_1_12_3 = curvature_y_1_0_22_1_3 * 35.0;
    let six_joint_2_fx_3 = six_joint_1_mx_4 * 35.0;
    let minus_six_joint_2_mz_2 = common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_1_0
        * six_joint_1_mx_4;
    let curvature_y_2_1_8 = common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_0_1_0 * curvature_y_1_0_22_1_3
        - minus_six_joint_2_mz_2;
    let curvature_y_2_1_6 = reactions.reaction_joint_2_wz
        + (common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0 * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0
                * curvature_y_1_0_22_1_3
            - common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_1_0 * six_joint_1_mx_4);
    let curvature_y_2_1_10 = reactions.reaction_joint_2_wx
        - (common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_1_0 * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_1_0
                * curvature_y_1_0_22_1_3
            - common_d_mu_b2_curvature.d_mu_8_7_0_0_0_1_0_1_1_0 * six_joint_1_mx_4);
    let curvature_y_2_1_12 = reactions.reaction_joint_2_vy * six_joint_2_fx_3
        + reactions.reaction_joint_2_vz * curvature_y_2_1_12_3;
    let minus_six_joint_2_fz_0 = reactions.reaction_joint_2_vx * six_joint_2_fx_3;
    let curvature_y_2_1_14 = reactions.reaction_joint_2_vz * curvature_y_2_1_14_1
        + minus_six_joint_2_fz_0;
    let curvature_y_2_1_16 = reactions.reaction_joint_2_vx * curvature_y_2_1_12_3
        - reactions.reaction_joint_2_vy * curvature_y_2_1_14_1;
    let curvature_y_2_1 = reactions.reaction_joint_2_wx * curvature_y_2_0_1
        + reactions.reaction_joint_2_wy * curvature_y_2_0_3
        + reactions.reaction_joint_2_wz * curvature_y_2_0_5
        - curvature_y_2_1_6 * screws.connection_joint_3_wx
        - curvature_y_2_1_8 * screws.connection_joint_3_wy
        + curvature_y_2_1_10 * screws.connection_joint_3_wz
        - curvature_y_2_1_12 * screws.connection_joint_3_vx
        + curvature_y_2_1_14 * screws.connection_joint_3_vy
        + curvature_y_2_1_16 * screws.connection_joint_3_vz;
    curvature[1][1][2] = curvature_y_2_1 + 0.0;
    let curvature_y_3_1 = reactions.reaction_joint_2_wx * curvature_y_3_0_1
        + reactions.reaction_joint_2_wy * curvature_y_3_0_3
        + reactions.reaction_joint_2_wz * curvature_y_3_0_5
        - curvature_y_2_1_6 * screws.connection_joint_4_wx
        - curvature_y_2_1_8 * screws.connection_joint_4_wy
        + curvature_y_2_1_10 * screws.connection_joint_4_wz
        - curvature_y_2_1_12 * screws.connection_joint_4_vx
        + curvature_y_2_1_14 * screws.connection_joint_4_vy
        + curvature_y_2_1_16 * screws.connection_joint_4_vz;
    curvature[1][1][3] = curvature_y_3_1 + 0.0;
    let curvature_y_4_1 = reactions.reaction_joint_2_wx * curvature_y_4_0_1
        + reactions.reaction_joint_2_wy * curvature_y_4_0_3
        + reactions.reaction_joint_2_wz * curvature_y_4_0_5
        - curvature_y_2_1_6 * screws.connection_joint_5_wx
        - curvature_y_2_1_8 * screws.connection_joint_5_wy
        + curvature_y_2_1_10 * screws.connection_joint_5_wz
        - curvature_y_2_1_12 * screws.connection_joint_5_vx
        + curvature_y_2_1_14 * screws.connection_joint_5_vy
        + curvature_y_2_1_16 * screws.connection_joint_5_vz;
    curvature[1][1][4] = curvature_y_4_1 + 0.0;
    let curvature_y_5_1 = reactions.reaction_joint_2_wx * curvature_y_5_0_1
        + reactions.reaction_joint_2_wy * curvature_y_5_0_3
        + reactions.reaction_joint_2_wz * curvature_y_5_0_5
        - curvature_y_2_1_6 * screws.connection_joint_6_wx
        - curvature_y_2_1_8 * screws.connection_joint_6_wy
        + curvature_y_2_1_10 * screws.connection_joint_6_wz
        - curvature_y_2_1_12 * screws.connection_joint_6_vx
        + curvature_y_2_1_14 * screws.connection_joint_6_vy
        + curvature_y_2_1_16 * screws.connection_joint_6_vz;
    curvature[1][1][5] = curvature_y_5_1 + 0.0;
    let curvature_y_6_1 = reactions.reaction_joint_2_wx * curvature_y_6_0_1
        + reactions.reaction_joint_2_wy * curvature_y_6_0_3
        + reactions.reaction_joint_2_wz * curvature_y_6_0_5
        - curvature_y_2_1_6 * screws.connection_joint_7_wx
        - curvature_y_2_1_8 * screws.connection_joint_7_wy
        + curvature_y_2_1_10 * screws.connection_joint_7_wz
        - curvature_y_2_1_12 * screws.connection_joint_7_vx
        + curvature_y_2_1_14 * screws.connection_joint_7_vy
        + curvature_y_2_1_16 * screws.connection_joint_7_vz;
    curvature[1][1][6] = curvature_y_6_1 + 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_3
    curvature[1][2][0] = 0.0 - curvature_y_2_0;
    curvature[1][2][1] = 0.0 - curvature_y_2_1;
    curvature[1][2][2] = 0.0;
    let minus_six_joint_3_mz_2 = common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_1_0
        * six_joint_1_mx_4;
    let curvature_y_3_2_8 = common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_0_1_0 * curvature_y_1_0_22_1_3
        - minus_six_joint_3_mz_2;
    let curvature_y_3_2_6 = reactions.reaction_joint_3_wz
        + (common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0 * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0
                * curvature_y_1_0_22_1_3
            - common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_1_0 * six_joint_1_mx_4);
    let curvature_y_3_2_10 = reactions.reaction_joint_3_wx
        - (common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_1_0 * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_1_0
                * curvature_y_1_0_22_1_3
            - common_d_mu_b2_curvature.d_mu_9_8_0_0_0_1_0_1_1_0 * six_joint_1_mx_4);
    let curvature_y_3_2_12 = reactions.reaction_joint_3_vy * six_joint_2_fx_3
        + reactions.reaction_joint_3_vz * curvature_y_2_1_12_3;
    let minus_six_joint_3_fz_0 = reactions.reaction_joint_3_vx * six_joint_2_fx_3;
    let curvature_y_3_2_14 = reactions.reaction_joint_3_vz * curvature_y_2_1_14_1
        + minus_six_joint_3_fz_0;
    let curvature_y_3_2_16 = reactions.reaction_joint_3_vx * curvature_y_2_1_12_3
        - reactions.reaction_joint_3_vy * curvature_y_2_1_14_1;
    let curvature_y_3_2 = reactions.reaction_joint_3_wx * curvature_y_3_0_1
        + reactions.reaction_joint_3_wy * curvature_y_3_0_3
        + reactions.reaction_joint_3_wz * curvature_y_3_0_5
        - curvature_y_3_2_6 * screws.connection_joint_4_wx
        - curvature_y_3_2_8 * screws.connection_joint_4_wy
        + curvature_y_3_2_10 * screws.connection_joint_4_wz
        - curvature_y_3_2_12 * screws.connection_joint_4_vx
        + curvature_y_3_2_14 * screws.connection_joint_4_vy
        + curvature_y_3_2_16 * screws.connection_joint_4_vz;
    curvature[1][2][3] = curvature_y_3_2 + 0.0;
    let curvature_y_4_2 = reactions.reaction_joint_3_wx * curvature_y_4_0_1
        + reactions.reaction_joint_3_wy * curvature_y_4_0_3
        + reactions.reaction_joint_3_wz * curvature_y_4_0_5
        - curvature_y_3_2_6 * screws.connection_joint_5_wx
        - curvature_y_3_2_8 * screws.connection_joint_5_wy
        + curvature_y_3_2_10 * screws.connection_joint_5_wz
        - curvature_y_3_2_12 * screws.connection_joint_5_vx
        + curvature_y_3_2_14 * screws.connection_joint_5_vy
        + curvature_y_3_2_16 * screws.connection_joint_5_vz;
    curvature[1][2][4] = curvature_y_4_2 + 0.0;
    let curvature_y_5_2 = reactions.reaction_joint_3_wx * curvature_y_5_0_1
        + reactions.reaction_joint_3_wy * curvature_y_5_0_3
        + reactions.reaction_joint_3_wz * curvature_y_5_0_5
        - curvature_y_3_2_6 * screws.connection_joint_6_wx
        - curvature_y_3_2_8 * screws.connection_joint_6_wy
        + curvature_y_3_2_10 * screws.connection_joint_6_wz
        - curvature_y_3_2_12 * screws.connection_joint_6_vx
        + curvature_y_3_2_14 * screws.connection_joint_6_vy
        + curvature_y_3_2_16 * screws.connection_joint_6_vz;
    curvature[1][2][5] = curvature_y_5_2 + 0.0;
    let curvature_y_6_2 = reactions.reaction_joint_3_wx * curvature_y_6_0_1
        + reactions.reaction_joint_3_wy * curvature_y_6_0_3
        + reactions.reaction_joint_3_wz * curvature_y_6_0_5
        - curvature_y_3_2_6 * screws.connection_joint_7_wx
        - curvature_y_3_2_8 * screws.connection_joint_7_wy
        + curvature_y_3_2_10 * screws.connection_joint_7_wz
        - curvature_y_3_2_12 * screws.connection_joint_7_vx
        + curvature_y_3_2_14 * screws.connection_joint_7_vy
        + curvature_y_3_2_16 * screws.connection_joint_7_vz;
    curvature[1][2][6] = curvature_y_6_2 + 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_4
    curvature[1][3][0] = 0.0 - curvature_y_3_0;
    curvature[1][3][1] = 0.0 - curvature_y_3_1;
    curvature[1][3][2] = 0.0 - curvature_y_3_2;
    curvature[1][3][3] = 0.0;
    let minus_six_joint_4_mz_2 = common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_1_0
        * six_joint_1_mx_4;
    let curvature_y_4_3_8 = common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_0_1_0 * curvature_y_1_0_22_1_3
        - minus_six_joint_4_mz_2;
    let curvature_y_4_3_6 = reactions.reaction_joint_4_wz
        + (common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0
            * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0
                * curvature_y_1_0_22_1_3
            - common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_1_0 * six_joint_1_mx_4);
    let curvature_y_4_3_10 = reactions.reaction_joint_4_wx
        - (common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_1_0 * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_1_0
                * curvature_y_1_0_22_1_3
            - common_d_mu_b2_curvature.d_mu_10_9_0_0_0_1_0_1_1_0 * six_joint_1_mx_4);
    let curvature_y_4_3_12 = reactions.minus_reaction_joint_4_vz * curvature_y_2_1_12_3
        - reactions.reaction_joint_4_vy * six_joint_2_fx_3;
    let minus_six_joint_4_fz_0 = reactions.reaction_joint_4_vx * six_joint_2_fx_3;
    let curvature_y_4_3_14 = minus_six_joint_4_fz_0
        - reactions.minus_reaction_joint_4_vz * curvature_y_2_1_14_1;
    let curvature_y_4_3_16 = reactions.reaction_joint_4_vx * curvature_y_2_1_12_3
        - reactions.reaction_joint_4_vy * curvature_y_2_1_14_1;
    let curvature_y_4_3 = reactions.reaction_joint_4_wx * curvature_y_4_0_1
        + reactions.reaction_joint_4_wy * curvature_y_4_0_3
        + reactions.reaction_joint_4_wz * curvature_y_4_0_5
        - curvature_y_4_3_6 * screws.connection_joint_5_wx
        - curvature_y_4_3_8 * screws.connection_joint_5_wy
        + curvature_y_4_3_10 * screws.connection_joint_5_wz
        + curvature_y_4_3_12 * screws.connection_joint_5_vx
        + curvature_y_4_3_14 * screws.connection_joint_5_vy
        + curvature_y_4_3_16 * screws.connection_joint_5_vz;
    curvature[1][3][4] = curvature_y_4_3 + 0.0;
    let curvature_y_5_3 = reactions.reaction_joint_4_wx * curvature_y_5_0_1
        + reactions.reaction_joint_4_wy * curvature_y_5_0_3
        + reactions.reaction_joint_4_wz * curvature_y_5_0_5
        - curvature_y_4_3_6 * screws.connection_joint_6_wx
        - curvature_y_4_3_8 * screws.connection_joint_6_wy
        + curvature_y_4_3_10 * screws.connection_joint_6_wz
        + curvature_y_4_3_12 * screws.connection_joint_6_vx
        + curvature_y_4_3_14 * screws.connection_joint_6_vy
        + curvature_y_4_3_16 * screws.connection_joint_6_vz;
    curvature[1][3][5] = curvature_y_5_3 + 0.0;
    let curvature_y_6_3 = reactions.reaction_joint_4_wx * curvature_y_6_0_1
        + reactions.reaction_joint_4_wy * curvature_y_6_0_3
        + reactions.reaction_joint_4_wz * curvature_y_6_0_5
        - curvature_y_4_3_6 * screws.connection_joint_7_wx
        - curvature_y_4_3_8 * screws.connection_joint_7_wy
        + curvature_y_4_3_10 * screws.connection_joint_7_wz
        + curvature_y_4_3_12 * screws.connection_joint_7_vx
        + curvature_y_4_3_14 * screws.connection_joint_7_vy
        + curvature_y_4_3_16 * screws.connection_joint_7_vz;
    curvature[1][3][6] = curvature_y_6_3 + 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_5
    curvature[1][4][0] = 0.0 - curvature_y_4_0;
    curvature[1][4][1] = 0.0 - curvature_y_4_1;
    curvature[1][4][2] = 0.0 - curvature_y_4_2;
    curvature[1][4][3] = 0.0 - curvature_y_4_3;
    curvature[1][4][4] = 0.0;
    let minus_six_joint_5_mz_2 = common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_1_0
        * six_joint_1_mx_4;
    let curvature_y_5_4_8 = common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0
        * curvature_y_1_0_22_1
        + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_0_1_0
            * curvature_y_1_0_22_1_3 - minus_six_joint_5_mz_2;
    let curvature_y_5_4_6 = reactions.reaction_joint_5_wz
        + (common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0
            * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0
                * curvature_y_1_0_22_1_3
            - common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_1_0
                * six_joint_1_mx_4);
    let curvature_y_5_4_10 = reactions.reaction_joint_5_wx
        - (common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_1_0 * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_1_0
                * curvature_y_1_0_22_1_3
            - common_d_mu_b2_curvature.d_mu_11_10_0_0_0_1_0_1_1_0 * six_joint_1_mx_4);
    let curvature_y_5_4_12 = reactions.reaction_joint_5_vy * six_joint_2_fx_3
        + reactions.reaction_joint_5_vz * curvature_y_2_1_12_3;
    let minus_six_joint_5_fz_0 = reactions.reaction_joint_5_vx * six_joint_2_fx_3;
    let curvature_y_5_4_14 = reactions.reaction_joint_5_vz * curvature_y_2_1_14_1
        + minus_six_joint_5_fz_0;
    let curvature_y_5_4_16 = reactions.reaction_joint_5_vx * curvature_y_2_1_12_3
        - reactions.reaction_joint_5_vy * curvature_y_2_1_14_1;
    let curvature_y_5_4 = reactions.reaction_joint_5_wx * curvature_y_5_0_1
        + reactions.reaction_joint_5_wy * curvature_y_5_0_3
        + reactions.reaction_joint_5_wz * curvature_y_5_0_5
        - curvature_y_5_4_6 * screws.connection_joint_6_wx
        - curvature_y_5_4_8 * screws.connection_joint_6_wy
        + curvature_y_5_4_10 * screws.connection_joint_6_wz
        - curvature_y_5_4_12 * screws.connection_joint_6_vx
        + curvature_y_5_4_14 * screws.connection_joint_6_vy
        + curvature_y_5_4_16 * screws.connection_joint_6_vz;
    curvature[1][4][5] = curvature_y_5_4 + 0.0;
    let curvature_y_6_4 = reactions.reaction_joint_5_wx * curvature_y_6_0_1
        + reactions.reaction_joint_5_wy * curvature_y_6_0_3
        + reactions.reaction_joint_5_wz * curvature_y_6_0_5
        - curvature_y_5_4_6 * screws.connection_joint_7_wx
        - curvature_y_5_4_8 * screws.connection_joint_7_wy
        + curvature_y_5_4_10 * screws.connection_joint_7_wz
        - curvature_y_5_4_12 * screws.connection_joint_7_vx
        + curvature_y_5_4_14 * screws.connection_joint_7_vy
        + curvature_y_5_4_16 * screws.connection_joint_7_vz;
    curvature[1][4][6] = curvature_y_6_4 + 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_6
    curvature[1][5][0] = 0.0 - curvature_y_5_0;
    curvature[1][5][1] = 0.0 - curvature_y_5_1;
    curvature[1][5][2] = 0.0 - curvature_y_5_2;
    curvature[1][5][3] = 0.0 - curvature_y_5_3;
    curvature[1][5][4] = 0.0 - curvature_y_5_4;
    curvature[1][5][5] = 0.0;
    let minus_six_joint_6_mz_2 = common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_1_0
        * six_joint_1_mx_4;
    let minus_six_joint_6_fz_0 = reactions.reaction_joint_6_vx * six_joint_2_fx_3;
    let curvature_y_6_5 = reactions.reaction_joint_6_wx * curvature_y_6_0_1
        + reactions.reaction_joint_6_wy * curvature_y_6_0_3
        + reactions.reaction_joint_6_wz * curvature_y_6_0_5
        - (reactions.reaction_joint_6_wz
            + (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0
                * curvature_y_1_0_22_1
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0
                    * curvature_y_1_0_22_1_3
                - common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_1_0
                    * six_joint_1_mx_4)) * screws.connection_joint_7_wx
        - (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0
            * curvature_y_1_0_22_1
            + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_0_1_0
                * curvature_y_1_0_22_1_3 - minus_six_joint_6_mz_2)
            * screws.connection_joint_7_wy
        + (reactions.reaction_joint_6_wx
            - (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_1_0
                * curvature_y_1_0_22_1
                + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_1_0
                    * curvature_y_1_0_22_1_3
                - common_d_mu_b2_curvature.d_mu_12_11_0_0_0_1_0_1_1_0
                    * six_joint_1_mx_4)) * screws.connection_joint_7_wz
        - (reactions.reaction_joint_6_vy * six_joint_2_fx_3
            + reactions.reaction_joint_6_vz * curvature_y_2_1_12_3)
            * screws.connection_joint_7_vx
        + (reactions.reaction_joint_6_vz * curvature_y_2_1_14_1 + minus_six_joint_6_fz_0)
            * screws.connection_joint_7_vy
        + (reactions.reaction_joint_6_vx * curvature_y_2_1_12_3
            - reactions.reaction_joint_6_vy * curvature_y_2_1_14_1)
            * screws.connection_joint_7_vz;
    curvature[1][5][6] = curvature_y_6_5 + 0.0;
    // 𝓑_ω(e_i, e_j) y, column joint_7
    curvature[1][6][0] = 0.0 - curvature_y_6_0;
    curvature[1][6][1] = 0.0 - curvature_y_6_1;
    curvature[1][6][2] = 0.0 - curvature_y_6_2;
    curvature[1][6][3] = 0.0 - curvature_y_6_3;
    curvature[1][6][4] = 0.0 - curvature_y_6_4;
    curvature[1][6][5] = 0.0 - curvature_y_6_5;
    curvature[1][6][6] = 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_1
    curvature[2][0][0] = 0.0;
    let minus_six_joint_1_mz_3 = inertias.locked_inverse_pivot_y_2 * six_joint_1_mx_4
        - inertias.locked_inverse_pivot_z_2 * inertias.locked_inverse_pivot_z;
    let minus_six_joint_1_mz = common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_0_0
        * inertias.locked_inverse_pivot_z
        - (outside.outside_joint_1_my * minus_six_joint_1_mz_3 + minus_six_joint_1_mz_4);
    let six_joint_1_mx = reactions.reaction_joint_1_wy
        - (common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_0_0 * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_1_0 * six_joint_1_mx_4
            - outside.outside_joint_1_my * inertias.locked_inverse_pivot_z);
    let minus_six_joint_1_my = reactions.reaction_joint_1_wx
        + (common_d_mu_b2_curvature.d_mu_7_6_0_0_1_0_1_0_1_0 * minus_six_joint_1_mz_3
            + outside.outside_joint_1_mx * inertias.locked_inverse_pivot_z);
    let three_joint_2_x = common_d_mu_and_7_more.three_joint_2_x_0_0_0
        * minus_six_joint_1_mz_3
        + common_d_mu_and_7_more.three_joint_2_x_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_2_x_1_0 * inertias.locked_inverse_pivot_z;
    let three_joint_2_y = common_d_mu_and_7_more.three_joint_2_y_1_0
        * inertias.locked_inverse_pivot_z
        - (common_d_mu_and_7_more.three_joint_2_x_0_1_0 * minus_six_joint_1_mz_3
            + common_d_mu_and_7_more.three_joint_2_y_0_0_0 * six_joint_1_mx_4);
    let six_more_joint_2_mz = common_d_mu_and_7_more.three_joint_2_x_1_0
        * minus_six_joint_1_mz_3 - six_more_joint_2_mz_2
        + common_d_mu_and_7_more.three_joint_2_z_1_0 * inertias.locked_inverse_pivot_z;
    let curvature_z_1_0 = reactions.reaction_joint_1_wx * three_joint_2_x
        + reactions.reaction_joint_1_wy * three_joint_2_y
        + reactions.reaction_joint_1_wz * six_more_joint_2_mz
        + six_joint_1_mx * screws.connection_joint_2_wx
        - minus_six_joint_1_my * screws.connection_joint_2_wy
        - minus_six_joint_1_mz * screws.connection_joint_2_wz;
    curvature[2][0][1] = curvature_z_1_0 + 0.0;
    let three_joint_3_x = common_d_mu_and_7_more.three_joint_3_x_0_0_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_3_x_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_3_x_1_0 * inertias.locked_inverse_pivot_z;
    let three_joint_3_y = common_d_mu_and_7_more.three_joint_3_x_0_1_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_3_y_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * inertias.locked_inverse_pivot_z;
    let six_more_joint_3_mz = common_d_mu_and_7_more.three_joint_3_x_1_0
        * minus_six_joint_1_mz_3 - six_more_joint_3_mz_2
        + common_d_mu_and_7_more.three_joint_3_z_1_0 * inertias.locked_inverse_pivot_z;
    let curvature_z_2_0 = reactions.reaction_joint_1_wx * three_joint_3_x
        + reactions.reaction_joint_1_wy * three_joint_3_y
        + reactions.reaction_joint_1_wz * six_more_joint_3_mz
        + six_joint_1_mx * screws.connection_joint_3_wx
        - minus_six_joint_1_my * screws.connection_joint_3_wy
        - minus_six_joint_1_mz * screws.connection_joint_3_wz;
    curvature[2][0][2] = curvature_z_2_0 + 0.0;
    let three_joint_4_x = common_d_mu_and_7_more.three_joint_4_x_0_0_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_4_x_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_4_x_1_0 * inertias.locked_inverse_pivot_z;
    let three_joint_4_y = common_d_mu_and_7_more.three_joint_4_x_0_1_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_4_y_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * inertias.locked_inverse_pivot_z;
    let six_more_joint_4_mz = common_d_mu_and_7_more.three_joint_4_x_1_0
        * minus_six_joint_1_mz_3 - six_more_joint_4_mz_2
        - common_d_mu_and_7_more.three_joint_4_z_1_0 * inertias.locked_inverse_pivot_z;
    let curvature_z_3_0 = reactions.reaction_joint_1_wx * three_joint_4_x
        + reactions.reaction_joint_1_wy * three_joint_4_y
        + reactions.reaction_joint_1_wz * six_more_joint_4_mz
        + six_joint_1_mx * screws.connection_joint_4_wx
        - minus_six_joint_1_my * screws.connection_joint_4_wy
        - minus_six_joint_1_mz * screws.connection_joint_4_wz;
    curvature[2][0][3] = curvature_z_3_0 + 0.0;
    let three_joint_5_x = common_d_mu_and_7_more.three_joint_5_x_0_0_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_5_x_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_5_x_1_0 * inertias.locked_inverse_pivot_z;
    let three_joint_5_y = common_d_mu_and_7_more.three_joint_5_x_0_1_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_5_y_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * inertias.locked_inverse_pivot_z;
    let six_more_joint_5_mz = common_d_mu_and_7_more.three_joint_5_x_1_0
        * minus_six_joint_1_mz_3 - six_more_joint_5_mz_2
        + common_d_mu_and_7_more.three_joint_5_z_1_0 * inertias.locked_inverse_pivot_z;
    let curvature_z_4_0 = reactions.reaction_joint_1_wx * three_joint_5_x
        + reactions.reaction_joint_1_wy * three_joint_5_y
        + reactions.reaction_joint_1_wz * six_more_joint_5_mz
        + six_joint_1_mx * screws.connection_joint_5_wx
        - minus_six_joint_1_my * screws.connection_joint_5_wy
        - minus_six_joint_1_mz * screws.connection_joint_5_wz;
    curvature[2][0][4] = curvature_z_4_0 + 0.0;
    let three_joint_6_x = common_d_mu_and_7_more.three_joint_6_x_0_0_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_6_x_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_6_x_1_0 * inertias.locked_inverse_pivot_z;
    let three_joint_6_y = common_d_mu_and_7_more.three_joint_6_x_0_1_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_6_y_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * inertias.locked_inverse_pivot_z;
    let six_more_joint_6_mz = common_d_mu_and_7_more.three_joint_6_x_1_0
        * minus_six_joint_1_mz_3 - six_more_joint_6_mz_2
        + common_d_mu_and_7_more.three_joint_6_z_1_0 * inertias.locked_inverse_pivot_z;
    let curvature_z_5_0 = reactions.reaction_joint_1_wx * three_joint_6_x
        + reactions.reaction_joint_1_wy * three_joint_6_y
        + reactions.reaction_joint_1_wz * six_more_joint_6_mz
        + six_joint_1_mx * screws.connection_joint_6_wx
        - minus_six_joint_1_my * screws.connection_joint_6_wy
        - minus_six_joint_1_mz * screws.connection_joint_6_wz;
    curvature[2][0][5] = curvature_z_5_0 + 0.0;
    let three_joint_7_x = common_d_mu_and_7_more.three_joint_7_x_0_0_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_7_x_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_7_x_1_0 * inertias.locked_inverse_pivot_z;
    let three_joint_7_y = common_d_mu_and_7_more.three_joint_7_x_0_1_0
        * minus_six_joint_1_mz_3
        - common_d_mu_and_7_more.three_joint_7_y_0_1_0 * six_joint_1_mx_4
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * inertias.locked_inverse_pivot_z;
    let six_more_joint_7_mz = common_d_mu_and_7_more.three_joint_7_x_1_0
        * minus_six_joint_1_mz_3 - six_more_joint_7_mz_2
        + common_d_mu_and_7_more.three_joint_7_z_1_0 * inertias.locked_inverse_pivot_z;
    let curvature_z_6_0 = reactions.reaction_joint_1_wx * three_joint_7_x
        + reactions.reaction_joint_1_wy * three_joint_7_y
        + reactions.reaction_joint_1_wz * six_more_joint_7_mz
        + six_joint_1_mx * screws.connection_joint_7_wx
        - minus_six_joint_1_my * screws.connection_joint_7_wy
        - minus_six_joint_1_mz * screws.connection_joint_7_wz;
    curvature[2][0][6] = curvature_z_6_0 + 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_2
    curvature[2][1][0] = 0.0 - curvature_z_1_0;
    curvature[2][1][1] = 0.0;
    let six_joint_2_fy_1 = minus_six_joint_1_mz_3 * 35.0;
    let six_joint_2_fx_1 = inertias.locked_inverse_pivot_z * 35.0;
    let minus_six_joint_2_mz = common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_1_0
        * minus_six_joint_1_mz_3 - minus_six_joint_2_mz_2
        + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_1_0_1_1_0
            * inertias.locked_inverse_pivot_z;
    let six_joint_2_mx = reactions.reaction_joint_2_wy
        - (common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_0_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0 * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
    let minus_six_joint_2_my = reactions.reaction_joint_2_wx
        + (common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_0_1_0_1_0_1_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_0_1_0 * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_8_7_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
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
    let curvature_z_3_1 = reactions.reaction_joint_2_wx * three_joint_4_x
        + reactions.reaction_joint_2_wy * three_joint_4_y
        + reactions.reaction_joint_2_wz * six_more_joint_4_mz
        + six_joint_2_mx * screws.connection_joint_4_wx
        - minus_six_joint_2_my * screws.connection_joint_4_wy
        - minus_six_joint_2_mz * screws.connection_joint_4_wz
        + six_joint_2_fx * screws.connection_joint_4_vx
        + six_joint_2_fy * screws.connection_joint_4_vy
        - minus_six_joint_2_fz * screws.connection_joint_4_vz;
    curvature[2][1][3] = curvature_z_3_1 + 0.0;
    let curvature_z_4_1 = reactions.reaction_joint_2_wx * three_joint_5_x
        + reactions.reaction_joint_2_wy * three_joint_5_y
        + reactions.reaction_joint_2_wz * six_more_joint_5_mz
        + six_joint_2_mx * screws.connection_joint_5_wx
        - minus_six_joint_2_my * screws.connection_joint_5_wy
        - minus_six_joint_2_mz * screws.connection_joint_5_wz
        + six_joint_2_fx * screws.connection_joint_5_vx
        + six_joint_2_fy * screws.connection_joint_5_vy
        - minus_six_joint_2_fz * screws.connection_joint_5_vz;
    curvature[2][1][4] = curvature_z_4_1 + 0.0;
    let curvature_z_5_1 = reactions.reaction_joint_2_wx * three_joint_6_x
        + reactions.reaction_joint_2_wy * three_joint_6_y
        + reactions.reaction_joint_2_wz * six_more_joint_6_mz
        + six_joint_2_mx * screws.connection_joint_6_wx
        - minus_six_joint_2_my * screws.connection_joint_6_wy
        - minus_six_joint_2_mz * screws.connection_joint_6_wz
        + six_joint_2_fx * screws.connection_joint_6_vx
        + six_joint_2_fy * screws.connection_joint_6_vy
        - minus_six_joint_2_fz * screws.connection_joint_6_vz;
    curvature[2][1][5] = curvature_z_5_1 + 0.0;
    let curvature_z_6_1 = reactions.reaction_joint_2_wx * three_joint_7_x
        + reactions.reaction_joint_2_wy * three_joint_7_y
        + reactions.reaction_joint_2_wz * six_more_joint_7_mz
        + six_joint_2_mx * screws.connection_joint_7_wx
        - minus_six_joint_2_my * screws.connection_joint_7_wy
        - minus_six_joint_2_mz * screws.connection_joint_7_wz
        + six_joint_2_fx * screws.connection_joint_7_vx
        + six_joint_2_fy * screws.connection_joint_7_vy
        - minus_six_joint_2_fz * screws.connection_joint_7_vz;
    curvature[2][1][6] = curvature_z_6_1 + 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_3
    curvature[2][2][0] = 0.0 - curvature_z_2_0;
    curvature[2][2][1] = 0.0 - curvature_z_2_1;
    curvature[2][2][2] = 0.0;
    let minus_six_joint_3_mz = common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_1_0
        * minus_six_joint_1_mz_3 - minus_six_joint_3_mz_2
        + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_1_0_1_1_0
            * inertias.locked_inverse_pivot_z;
    let six_joint_3_mx = reactions.reaction_joint_3_wy
        - (common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_0_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0 * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
    let minus_six_joint_3_my = reactions.reaction_joint_3_wx
        + (common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_0_1_0_1_0_1_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_0_1_0 * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_9_8_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
    let six_joint_3_fx = reactions.reaction_joint_3_vy * six_joint_2_fx_1
        + reactions.reaction_joint_3_vz * six_joint_2_fx_3;
    let six_joint_3_fy = reactions.reaction_joint_3_vz * six_joint_2_fy_1
        - reactions.reaction_joint_3_vx * six_joint_2_fx_1;
    let minus_six_joint_3_fz = minus_six_joint_3_fz_0
        + reactions.reaction_joint_3_vy * six_joint_2_fy_1;
    let curvature_z_3_2 = reactions.reaction_joint_3_wx * three_joint_4_x
        + reactions.reaction_joint_3_wy * three_joint_4_y
        + reactions.reaction_joint_3_wz * six_more_joint_4_mz
        + six_joint_3_mx * screws.connection_joint_4_wx
        - minus_six_joint_3_my * screws.connection_joint_4_wy
        - minus_six_joint_3_mz * screws.connection_joint_4_wz
        + six_joint_3_fx * screws.connection_joint_4_vx
        + six_joint_3_fy * screws.connection_joint_4_vy
        - minus_six_joint_3_fz * screws.connection_joint_4_vz;
    curvature[2][2][3] = curvature_z_3_2 + 0.0;
    let curvature_z_4_2 = reactions.reaction_joint_3_wx * three_joint_5_x
        + reactions.reaction_joint_3_wy * three_joint_5_y
        + reactions.reaction_joint_3_wz * six_more_joint_5_mz
        + six_joint_3_mx * screws.connection_joint_5_wx
        - minus_six_joint_3_my * screws.connection_joint_5_wy
        - minus_six_joint_3_mz * screws.connection_joint_5_wz
        + six_joint_3_fx * screws.connection_joint_5_vx
        + six_joint_3_fy * screws.connection_joint_5_vy
        - minus_six_joint_3_fz * screws.connection_joint_5_vz;
    curvature[2][2][4] = curvature_z_4_2 + 0.0;
    let curvature_z_5_2 = reactions.reaction_joint_3_wx * three_joint_6_x
        + reactions.reaction_joint_3_wy * three_joint_6_y
        + reactions.reaction_joint_3_wz * six_more_joint_6_mz
        + six_joint_3_mx * screws.connection_joint_6_wx
        - minus_six_joint_3_my * screws.connection_joint_6_wy
        - minus_six_joint_3_mz * screws.connection_joint_6_wz
        + six_joint_3_fx * screws.connection_joint_6_vx
        + six_joint_3_fy * screws.connection_joint_6_vy
        - minus_six_joint_3_fz * screws.connection_joint_6_vz;
    curvature[2][2][5] = curvature_z_5_2 + 0.0;
    let curvature_z_6_2 = reactions.reaction_joint_3_wx * three_joint_7_x
        + reactions.reaction_joint_3_wy * three_joint_7_y
        + reactions.reaction_joint_3_wz * six_more_joint_7_mz
        + six_joint_3_mx * screws.connection_joint_7_wx
        - minus_six_joint_3_my * screws.connection_joint_7_wy
        - minus_six_joint_3_mz * screws.connection_joint_7_wz
        + six_joint_3_fx * screws.connection_joint_7_vx
        + six_joint_3_fy * screws.connection_joint_7_vy
        - minus_six_joint_3_fz * screws.connection_joint_7_vz;
    curvature[2][2][6] = curvature_z_6_2 + 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_4
    curvature[2][3][0] = 0.0 - curvature_z_3_0;
    curvature[2][3][1] = 0.0 - curvature_z_3_1;
    curvature[2][3][2] = 0.0 - curvature_z_3_2;
    curvature[2][3][3] = 0.0;
    let minus_six_joint_4_mz = common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_1_0
        * minus_six_joint_1_mz_3 - minus_six_joint_4_mz_2
        + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_1_0_1_1_0
            * inertias.locked_inverse_pivot_z;
    let six_joint_4_mx = reactions.reaction_joint_4_wy
        - (common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_0_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0 * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
    let minus_six_joint_4_my = reactions.reaction_joint_4_wx
        + (common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_0_1_0_1_0_1_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_0_1_0 * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_10_9_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
    let six_joint_4_fx = reactions.reaction_joint_4_vy * six_joint_2_fx_1
        - reactions.minus_reaction_joint_4_vz * six_joint_2_fx_3;
    let minus_six_joint_4_fy = reactions.minus_reaction_joint_4_vz * six_joint_2_fy_1
        + reactions.reaction_joint_4_vx * six_joint_2_fx_1;
    let minus_six_joint_4_fz = minus_six_joint_4_fz_0
        + reactions.reaction_joint_4_vy * six_joint_2_fy_1;
    let curvature_z_4_3 = reactions.reaction_joint_4_wx * three_joint_5_x
        + reactions.reaction_joint_4_wy * three_joint_5_y
        + reactions.reaction_joint_4_wz * six_more_joint_5_mz
        + six_joint_4_mx * screws.connection_joint_5_wx
        - minus_six_joint_4_my * screws.connection_joint_5_wy
        - minus_six_joint_4_mz * screws.connection_joint_5_wz
        + six_joint_4_fx * screws.connection_joint_5_vx
        - minus_six_joint_4_fy * screws.connection_joint_5_vy
        - minus_six_joint_4_fz * screws.connection_joint_5_vz;
    curvature[2][3][4] = curvature_z_4_3 + 0.0;
    let curvature_z_5_3 = reactions.reaction_joint_4_wx * three_joint_6_x
        + reactions.reaction_joint_4_wy * three_joint_6_y
        + reactions.reaction_joint_4_wz * six_more_joint_6_mz
        + six_joint_4_mx * screws.connection_joint_6_wx
        - minus_six_joint_4_my * screws.connection_joint_6_wy
        - minus_six_joint_4_mz * screws.connection_joint_6_wz
        + six_joint_4_fx * screws.connection_joint_6_vx
        - minus_six_joint_4_fy * screws.connection_joint_6_vy
        - minus_six_joint_4_fz * screws.connection_joint_6_vz;
    curvature[2][3][5] = curvature_z_5_3 + 0.0;
    let curvature_z_6_3 = reactions.reaction_joint_4_wx * three_joint_7_x
        + reactions.reaction_joint_4_wy * three_joint_7_y
        + reactions.reaction_joint_4_wz * six_more_joint_7_mz
        + six_joint_4_mx * screws.connection_joint_7_wx
        - minus_six_joint_4_my * screws.connection_joint_7_wy
        - minus_six_joint_4_mz * screws.connection_joint_7_wz
        + six_joint_4_fx * screws.connection_joint_7_vx
        - minus_six_joint_4_fy * screws.connection_joint_7_vy
        - minus_six_joint_4_fz * screws.connection_joint_7_vz;
    curvature[2][3][6] = curvature_z_6_3 + 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_5
    curvature[2][4][0] = 0.0 - curvature_z_4_0;
    curvature[2][4][1] = 0.0 - curvature_z_4_1;
    curvature[2][4][2] = 0.0 - curvature_z_4_2;
    curvature[2][4][3] = 0.0 - curvature_z_4_3;
    curvature[2][4][4] = 0.0;
    let minus_six_joint_5_mz = common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_1_0
        * minus_six_joint_1_mz_3 - minus_six_joint_5_mz_2
        + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_1_0_1_1_0
            * inertias.locked_inverse_pivot_z;
    let six_joint_5_mx = reactions.reaction_joint_5_wy
        - (common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_0_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0
                * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
    let minus_six_joint_5_my = reactions.reaction_joint_5_wx
        + (common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_0_1_0_1_0_1_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_0_1_0 * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_11_10_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
    let six_joint_5_fx = reactions.reaction_joint_5_vy * six_joint_2_fx_1
        + reactions.reaction_joint_5_vz * six_joint_2_fx_3;
    let six_joint_5_fy = reactions.reaction_joint_5_vz * six_joint_2_fy_1
        - reactions.reaction_joint_5_vx * six_joint_2_fx_1;
    let minus_six_joint_5_fz = minus_six_joint_5_fz_0
        + reactions.reaction_joint_5_vy * six_joint_2_fy_1;
    let curvature_z_5_4 = reactions.reaction_joint_5_wx * three_joint_6_x
        + reactions.reaction_joint_5_wy * three_joint_6_y
        + reactions.reaction_joint_5_wz * six_more_joint_6_mz
        + six_joint_5_mx * screws.connection_joint_6_wx
        - minus_six_joint_5_my * screws.connection_joint_6_wy
        - minus_six_joint_5_mz * screws.connection_joint_6_wz
        + six_joint_5_fx * screws.connection_joint_6_vx
        + six_joint_5_fy * screws.connection_joint_6_vy
        - minus_six_joint_5_fz * screws.connection_joint_6_vz;
    curvature[2][4][5] = curvature_z_5_4 + 0.0;
    let curvature_z_6_4 = reactions.reaction_joint_5_wx * three_joint_7_x
        + reactions.reaction_joint_5_wy * three_joint_7_y
        + reactions.reaction_joint_5_wz * six_more_joint_7_mz
        + six_joint_5_mx * screws.connection_joint_7_wx
        - minus_six_joint_5_my * screws.connection_joint_7_wy
        - minus_six_joint_5_mz * screws.connection_joint_7_wz
        + six_joint_5_fx * screws.connection_joint_7_vx
        + six_joint_5_fy * screws.connection_joint_7_vy
        - minus_six_joint_5_fz * screws.connection_joint_7_vz;
    curvature[2][4][6] = curvature_z_6_4 + 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_6
    curvature[2][5][0] = 0.0 - curvature_z_5_0;
    curvature[2][5][1] = 0.0 - curvature_z_5_1;
    curvature[2][5][2] = 0.0 - curvature_z_5_2;
    curvature[2][5][3] = 0.0 - curvature_z_5_3;
    curvature[2][5][4] = 0.0 - curvature_z_5_4;
    curvature[2][5][5] = 0.0;
    let minus_six_joint_6_mz = common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_1_0
        * minus_six_joint_1_mz_3 - minus_six_joint_6_mz_2
        + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_1_0_1_1_0
            * inertias.locked_inverse_pivot_z;
    let six_joint_6_mx = reactions.reaction_joint_6_wy
        - (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_0_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0
                * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
    let minus_six_joint_6_my = reactions.reaction_joint_6_wx
        + (common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_0_1_0_1_0_1_0
            * minus_six_joint_1_mz_3
            - common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_0_1_0 * six_joint_1_mx_4
            + common_d_mu_b2_curvature.d_mu_12_11_0_0_0_0_1_0_1_1_0
                * inertias.locked_inverse_pivot_z);
    let six_joint_6_fx = reactions.reaction_joint_6_vy * six_joint_2_fx_1
        + reactions.reaction_joint_6_vz * six_joint_2_fx_3;
    let six_joint_6_fy = reactions.reaction_joint_6_vz * six_joint_2_fy_1
        - reactions.reaction_joint_6_vx * six_joint_2_fx_1;
    let minus_six_joint_6_fz = minus_six_joint_6_fz_0
        + reactions.reaction_joint_6_vy * six_joint_2_fy_1;
    let curvature_z_6_5 = reactions.reaction_joint_6_wx * three_joint_7_x
        + reactions.reaction_joint_6_wy * three_joint_7_y
        + reactions.reaction_joint_6_wz * six_more_joint_7_mz
        + six_joint_6_mx * screws.connection_joint_7_wx
        - minus_six_joint_6_my * screws.connection_joint_7_wy
        - minus_six_joint_6_mz * screws.connection_joint_7_wz
        + six_joint_6_fx * screws.connection_joint_7_vx
        + six_joint_6_fy * screws.connection_joint_7_vy
        - minus_six_joint_6_fz * screws.connection_joint_7_vz;
    curvature[2][5][6] = curvature_z_6_5 + 0.0;
    // 𝓑_ω(e_i, e_j) z, column joint_7
    curvature[2][6][0] = 0.0 - curvature_z_6_0;
    curvature[2][6][1] = 0.0 - curvature_z_6_1;
    curvature[2][6][2] = 0.0 - curvature_z_6_2;
    curvature[2][6][3] = 0.0 - curvature_z_6_3;
    curvature[2][6][4] = 0.0 - curvature_z_6_4;
    curvature[2][6][5] = 0.0 - curvature_z_6_5;
    curvature[2][6][6] = 0.0;
    // c
    com[0] = poses.com_x + 0.0;
    com[1] = poses.com_y + 0.0;
    com[2] = poses.com_z + 0.0;
}
/// The momentum Λ_b μ, in the base frame and about the centre of mass.
///
/// - `q`: shape (7; rad, m)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `body_momentum`: Λ_b μ, momentum, base frame (6; kg·m²/s, kg·m/s)
/// - `centroidal_momentum`: Λ_c μ, momentum about c, base axes (6; kg·m²/s, kg·m/s)
///
/// 697 operations: 347 + −, 347 ×, 3 ÷; 7 sin cos; about 8.4 KiB of code.
pub fn momentum(
    q: &[f64; 7],
    mu: &[f64; 6],
    body_momentum: &mut [f64; 6],
    centroidal_momentum: &mut [f64; 6],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let body_momentum_0_0 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let body_momentum_0_3 = (mu[4] + (mu[2] * poses.com_x - mu[0] * poses.com_z)) * 17.5;
    let body_momentum_0_1 = (mu[5] + (mu[0] * poses.com_y - mu[1] * poses.com_x)) * 17.5;
    // Λ_b μ
    body_momentum[0] = body_momentum_0_0
        + (body_momentum_0_1 * poses.com_y - body_momentum_0_3 * poses.com_z) + 0.0;
    let body_momentum_1_0 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let body_momentum_1_1 = (mu[3] + (mu[1] * poses.com_z - mu[2] * poses.com_y)) * 17.5;
    body_momentum[1] = body_momentum_1_0
        + (body_momentum_1_1 * poses.com_z - body_momentum_0_1 * poses.com_x) + 0.0;
    let body_momentum_2_0 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    body_momentum[2] = body_momentum_2_0
        + (body_momentum_0_3 * poses.com_x - body_momentum_1_1 * poses.com_y) + 0.0;
    body_momentum[3] = body_momentum_1_1 + 0.0;
    body_momentum[4] = body_momentum_0_3 + 0.0;
    body_momentum[5] = body_momentum_0_1 + 0.0;
    // Λ_c μ
    centroidal_momentum[0] = body_momentum_0_0 + 0.0;
    centroidal_momentum[1] = body_momentum_1_0 + 0.0;
    centroidal_momentum[2] = body_momentum_2_0 + 0.0;
    centroidal_momentum[3] = body_momentum_1_1 + 0.0;
    centroidal_momentum[4] = body_momentum_0_3 + 0.0;
    centroidal_momentum[5] = body_momentum_0_1 + 0.0;
}
/// μ = Λ_b⁻¹ p: in free flight, where the momentum is known, μ need not be integrated.
///
/// - `q`: shape (7; rad, m)
/// - `body_momentum`: momentum, base frame (6; kg·m²/s, kg·m/s)
/// - `mu`: μ, locked velocity, base frame (6; rad/s, m/s)
///
/// 697 operations: 347 + −, 347 ×, 3 ÷; 7 sin cos; about 8.4 KiB of code.
pub fn velocity_of_momentum(q: &[f64; 7], body_momentum: &[f64; 6], mu: &mut [f64; 6]) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let mu_0_3_3_8_6 = body_momentum[0]
        + (body_momentum[4] * poses.com_z - body_momentum[5] * poses.com_y);
    let mu_0_3_3_8 = body_momentum[1]
        + (body_momentum[5] * poses.com_x - body_momentum[3] * poses.com_z)
        - inertias.locked_inverse_pivot_y_2 * mu_0_3_3_8_6;
    let mu_0_3_3 = (body_momentum[2]
        + (body_momentum[3] * poses.com_y - body_momentum[4] * poses.com_x)
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
    mu[3] = body_momentum[3] * 0.05714285714285714
        + (mu_0_3_3 * poses.com_y - mu_0_3 * poses.com_z) + 0.0;
    mu[4] = body_momentum[4] * 0.05714285714285714
        + (mu_0 * poses.com_z - mu_0_3_3 * poses.com_x) + 0.0;
    mu[5] = body_momentum[5] * 0.05714285714285714
        + (mu_0_3 * poses.com_x - mu_0 * poses.com_y) + 0.0;
}
/// V₁ = μ − A_l q̇, which reconstructs the pose of the base: ġ₁ = g₁ V₁^.
///
/// - `q`: shape (7; rad, m)
/// - `qd`: shape velocity (7; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `base_twist`: V₁, body twist of the base, base frame (6; rad/s, m/s)
///
/// 1329 operations: 635 + −, 691 ×, 3 ÷; 7 sin cos; about 15.8 KiB of code.
pub fn base_twist(
    q: &[f64; 7],
    qd: &[f64; 7],
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
/// - `q`: shape (7; rad, m)
/// - `qd`: shape velocity (7; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `kinetic_energy`: ½ ξᵀ Λ ξ, kinetic energy (1; J)
///
/// 1785 operations: 832 + −, 950 ×, 3 ÷; 7 sin cos; about 21.2 KiB of code.
pub fn kinetic_energy(
    q: &[f64; 7],
    qd: &[f64; 7],
    mu: &[f64; 6],
    kinetic_energy: &mut f64,
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let velocities = velocities(qd, &poses, &screws);
    let kinetic_energy_0_0_0_22 = mu[3] + (mu[1] * poses.com_z - mu[2] * poses.com_y);
    let kinetic_energy_0_0_0_25 = mu[4] + (mu[2] * poses.com_x - mu[0] * poses.com_z);
    let kinetic_energy_0_0_0_28 = mu[5] + (mu[0] * poses.com_y - mu[1] * poses.com_x);
    let kinetic_energy_0_0_0 = mu[0]
        * (inertias.composite_base_xx * mu[0] + inertias.composite_base_xy * mu[1]
            + inertias.composite_base_xz * mu[2])
        + mu[1]
            * (inertias.composite_base_xy * mu[0] + inertias.composite_base_yy * mu[1]
                + inertias.composite_base_yz * mu[2])
        + mu[2]
            * (inertias.composite_base_xz * mu[0] + inertias.composite_base_yz * mu[1]
                + inertias.composite_base_zz * mu[2])
        + kinetic_energy_0_0_0_22 * (kinetic_energy_0_0_0_22 * 17.5)
        + kinetic_energy_0_0_0_25 * (kinetic_energy_0_0_0_25 * 17.5)
        + kinetic_energy_0_0_0_28 * (kinetic_energy_0_0_0_28 * 17.5)
        + (velocities.velocity_base_vx
            * (velocities.velocity_base_vx * 3.5
                + (velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hz
                    - velocities.minus_velocity_base_wz
                        * inertias.minus_inertia_base_hy))
            - (velocities.minus_velocity_base_wx
                * (inertias.minus_inertia_base_xy * velocities.minus_velocity_base_wy
                    - inertias.inertia_base_xx * velocities.minus_velocity_base_wx
                    + inertias.minus_inertia_base_xz * velocities.minus_velocity_base_wz
                    + (velocities.minus_velocity_base_vz * inertias.minus_inertia_base_hy
                        - velocities.minus_velocity_base_vy
                            * inertias.minus_inertia_base_hz))
                + velocities.minus_velocity_base_wy
                    * (inertias.minus_inertia_base_xy * velocities.minus_velocity_base_wx
                        - inertias.inertia_base_yy * velocities.minus_velocity_base_wy
                        + inertias.minus_inertia_base_yz
                            * velocities.minus_velocity_base_wz
                        - (velocities.velocity_base_vx * inertias.minus_inertia_base_hz
                            + velocities.minus_velocity_base_vz
                                * inertias.minus_inertia_base_hx))
                + velocities.minus_velocity_base_wz
                    * (inertias.minus_inertia_base_xz * velocities.minus_velocity_base_wx
                        + inertias.minus_inertia_base_yz
                            * velocities.minus_velocity_base_wy
                        - inertias.inertia_base_zz * velocities.minus_velocity_base_wz
                        + (velocities.minus_velocity_base_vy
                            * inertias.minus_inertia_base_hx
                            + velocities.velocity_base_vx
                                * inertias.minus_inertia_base_hy)))
            - velocities.minus_velocity_base_vy
                * (velocities.minus_velocity_base_wz * inertias.minus_inertia_base_hx
                    - velocities.minus_velocity_base_wx * inertias.minus_inertia_base_hz
                    - velocities.minus_velocity_base_vy * 3.5)
            - velocities.minus_velocity_base_vz
                * (velocities.minus_velocity_base_wx * inertias.minus_inertia_base_hy
                    - velocities.minus_velocity_base_wy * inertias.minus_inertia_base_hx
                    - velocities.minus_velocity_base_vz * 3.5))
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
                * (velocities.velocity_link_1_vx * 2.0
                    - (velocities.minus_velocity_base_wy * inertias.inertia_link_1_hz
                        + velocities.velocity_link_1_wz * inertias.inertia_link_1_hy))
            + velocities.velocity_link_1_vy
                * (velocities.velocity_link_1_vy * 2.0
                    + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hz
                        - velocities.velocity_link_1_wz
                            * inertias.minus_inertia_link_1_hx))
            + velocities.minus_velocity_base_vz
                * (velocities.minus_velocity_base_vz * 2.0
                    + (velocities.minus_velocity_base_wx * inertias.inertia_link_1_hy
                        + velocities.minus_velocity_base_wy
                            * inertias.minus_inertia_link_1_hx)))
        + (velocities.velocity_link_2_wx
            * (inertias.inertia_link_2_xx * velocities.velocity_link_2_wx
                - inertias.inertia_link_2_xy * velocities.minus_velocity_link_2_wy
                + inertias.inertia_link_2_xz * velocities.velocity_link_1_wz
                - (velocities.velocity_link_2_vz * inertias.minus_inertia_link_2_hy
                    + velocities.velocity_link_2_vy * inertias.inertia_link_2_hz))
            - velocities.minus_velocity_link_2_wy
                * (inertias.inertia_link_2_xy * velocities.velocity_link_2_wx
                    - inertias.inertia_link_2_yy * velocities.minus_velocity_link_2_wy
                    + inertias.inertia_link_2_yz * velocities.velocity_link_1_wz
                    + (velocities.velocity_link_2_vx * inertias.inertia_link_2_hz
                        - velocities.velocity_link_2_vz * inertias.inertia_link_2_hx))
            + velocities.velocity_link_1_wz
                * (inertias.inertia_link_2_xz * velocities.velocity_link_2_wx
                    - inertias.inertia_link_2_yz * velocities.minus_velocity_link_2_wy
                    + inertias.inertia_link_2_zz * velocities.velocity_link_1_wz
                    + (velocities.velocity_link_2_vy * inertias.inertia_link_2_hx
                        + velocities.velocity_link_2_vx
                            * inertias.minus_inertia_link_2_hy))
            + velocities.velocity_link_2_vx
                * (velocities.velocity_link_2_vx * 2.0
                    + (velocities.velocity_link_1_wz * inertias.minus_inertia_link_2_hy
                        - velocities.minus_velocity_link_2_wy
                            * inertias.inertia_link_2_hz))
            + velocities.velocity_link_2_vy
                * (velocities.velocity_link_2_vy * 2.0
                    + (velocities.velocity_link_1_wz * inertias.inertia_link_2_hx
                        - velocities.velocity_link_2_wx * inertias.inertia_link_2_hz))
            + velocities.velocity_link_2_vz
                * (velocities.velocity_link_2_vz * 2.0
                    + (velocities.minus_velocity_link_2_wy * inertias.inertia_link_2_hx
                        - velocities.velocity_link_2_wx
                            * inertias.minus_inertia_link_2_hy)));
    let kinetic_energy_0_0 = kinetic_energy_0_0_0
        + (velocities.velocity_link_3_wx
            * (inertias.inertia_link_3_xx * velocities.velocity_link_3_wx
                - inertias.inertia_link_3_xy * velocities.minus_velocity_link_3_wy
                + inertias.inertia_link_3_xz * velocities.velocity_link_3_wz
                - (velocities.velocity_link_3_vz * inertias.minus_inertia_link_3_hy
                    + velocities.velocity_link_3_vy * inertias.inertia_link_3_hz))
            - velocities.minus_velocity_link_3_wy
                * (inertias.inertia_link_3_xy * velocities.velocity_link_3_wx
                    - inertias.inertia_link_3_yy * velocities.minus_velocity_link_3_wy
                    + inertias.inertia_link_3_yz * velocities.velocity_link_3_wz
                    + (velocities.velocity_link_3_vx * inertias.inertia_link_3_hz
                        - velocities.velocity_link_3_vz * inertias.inertia_link_3_hx))
            + velocities.velocity_link_3_wz
                * (inertias.inertia_link_3_xz * velocities.velocity_link_3_wx
                    - inertias.inertia_link_3_yz * velocities.minus_velocity_link_3_wy
                    + inertias.inertia_link_3_zz * velocities.velocity_link_3_wz
                    + (velocities.velocity_link_3_vy * inertias.inertia_link_3_hx
                        + velocities.velocity_link_3_vx
                            * inertias.minus_inertia_link_3_hy))
            + velocities.velocity_link_3_vx
                * (velocities.velocity_link_3_vx * 2.0
                    + (velocities.velocity_link_3_wz * inertias.minus_inertia_link_3_hy
                        - velocities.minus_velocity_link_3_wy
                            * inertias.inertia_link_3_hz))
            + velocities.velocity_link_3_vy
                * (velocities.velocity_link_3_vy * 2.0
                    + (velocities.velocity_link_3_wz * inertias.inertia_link_3_hx
                        - velocities.velocity_link_3_wx * inertias.inertia_link_3_hz))
            + velocities.velocity_link_3_vz
                * (velocities.velocity_link_3_vz * 2.0
                    + (velocities.minus_velocity_link_3_wy * inertias.inertia_link_3_hx
                        - velocities.velocity_link_3_wx
                            * inertias.minus_inertia_link_3_hy)))
        + (velocities.velocity_link_4_wx
            * (inertias.inertia_link_4_xx * velocities.velocity_link_4_wx
                + inertias.inertia_link_4_xy * velocities.velocity_link_4_wy
                + inertias.inertia_link_4_xz * velocities.velocity_link_4_wz
                + (velocities.velocity_link_4_vz * inertias.inertia_link_4_hy
                    - velocities.velocity_link_4_vy * inertias.inertia_link_4_hz))
            + velocities.velocity_link_4_wy
                * (inertias.inertia_link_4_xy * velocities.velocity_link_4_wx
                    + inertias.inertia_link_4_yy * velocities.velocity_link_4_wy
                    + inertias.inertia_link_4_yz * velocities.velocity_link_4_wz
                    + (velocities.velocity_link_4_vx * inertias.inertia_link_4_hz
                        + velocities.velocity_link_4_vz
                            * inertias.minus_inertia_link_4_hx))
            + velocities.velocity_link_4_wz
                * (inertias.inertia_link_4_xz * velocities.velocity_link_4_wx
                    + inertias.inertia_link_4_yz * velocities.velocity_link_4_wy
                    + inertias.inertia_link_4_zz * velocities.velocity_link_4_wz
                    - (velocities.velocity_link_4_vy * inertias.minus_inertia_link_4_hx
                        + velocities.velocity_link_4_vx * inertias.inertia_link_4_hy))
            + velocities.velocity_link_4_vx
                * (velocities.velocity_link_4_vx * 2.0
                    + (velocities.velocity_link_4_wy * inertias.inertia_link_4_hz
                        - velocities.velocity_link_4_wz * inertias.inertia_link_4_hy))
            + velocities.velocity_link_4_vy
                * (velocities.velocity_link_4_vy * 2.0
                    - (velocities.velocity_link_4_wz * inertias.minus_inertia_link_4_hx
                        + velocities.velocity_link_4_wx * inertias.inertia_link_4_hz))
            + velocities.velocity_link_4_vz
                * (velocities.velocity_link_4_vz * 2.0
                    + (velocities.velocity_link_4_wx * inertias.inertia_link_4_hy
                        + velocities.velocity_link_4_wy
                            * inertias.minus_inertia_link_4_hx)))
        + (velocities.velocity_link_5_wx
            * (inertias.inertia_link_5_xx * velocities.velocity_link_5_wx
                + inertias.inertia_link_5_xy * velocities.velocity_link_5_wy
                + inertias.inertia_link_5_xz * velocities.velocity_link_5_wz
                + (velocities.velocity_link_5_vz * inertias.inertia_link_5_hy
                    - velocities.velocity_link_5_vy * inertias.inertia_link_5_hz))
            + velocities.velocity_link_5_wy
                * (inertias.inertia_link_5_xy * velocities.velocity_link_5_wx
                    + inertias.inertia_link_5_yy * velocities.velocity_link_5_wy
                    + inertias.inertia_link_5_yz * velocities.velocity_link_5_wz
                    + (velocities.velocity_link_5_vx * inertias.inertia_link_5_hz
                        + velocities.velocity_link_5_vz
                            * inertias.minus_inertia_link_5_hx))
            + velocities.velocity_link_5_wz
                * (inertias.inertia_link_5_xz * velocities.velocity_link_5_wx
                    + inertias.inertia_link_5_yz * velocities.velocity_link_5_wy
                    + inertias.inertia_link_5_zz * velocities.velocity_link_5_wz
                    - (velocities.velocity_link_5_vy * inertias.minus_inertia_link_5_hx
                        + velocities.velocity_link_5_vx * inertias.inertia_link_5_hy))
            + velocities.velocity_link_5_vx
                * (velocities.velocity_link_5_vx * 2.0
                    + (velocities.velocity_link_5_wy * inertias.inertia_link_5_hz
                        - velocities.velocity_link_5_wz * inertias.inertia_link_5_hy))
            + velocities.velocity_link_5_vy
                * (velocities.velocity_link_5_vy * 2.0
                    - (velocities.velocity_link_5_wz * inertias.minus_inertia_link_5_hx
                        + velocities.velocity_link_5_wx * inertias.inertia_link_5_hz))
            + velocities.velocity_link_5_vz
                * (velocities.velocity_link_5_vz * 2.0
                    + (velocities.velocity_link_5_wx * inertias.inertia_link_5_hy
                        + velocities.velocity_link_5_wy
                            * inertias.minus_inertia_link_5_hx)));
    let kinetic_energy_0 = (kinetic_energy_0_0
        + (velocities.velocity_link_6_wx
            * (inertias.inertia_link_6_xx * velocities.velocity_link_6_wx
                - inertias.minus_inertia_link_6_xy * velocities.velocity_link_6_wy
                + inertias.inertia_link_6_xz * velocities.velocity_link_6_wz
                - (velocities.velocity_link_6_vz * inertias.minus_inertia_link_6_hy
                    + velocities.velocity_link_6_vy * inertias.inertia_link_6_hz))
            + velocities.velocity_link_6_wy
                * (inertias.inertia_link_6_yy * velocities.velocity_link_6_wy
                    - inertias.minus_inertia_link_6_xy * velocities.velocity_link_6_wx
                    + inertias.inertia_link_6_yz * velocities.velocity_link_6_wz
                    + (velocities.velocity_link_6_vx * inertias.inertia_link_6_hz
                        + velocities.velocity_link_6_vz
                            * inertias.minus_inertia_link_6_hx))
            + velocities.velocity_link_6_wz
                * (inertias.inertia_link_6_xz * velocities.velocity_link_6_wx
                    + inertias.inertia_link_6_yz * velocities.velocity_link_6_wy
                    + inertias.inertia_link_6_zz * velocities.velocity_link_6_wz
                    + (velocities.velocity_link_6_vx * inertias.minus_inertia_link_6_hy
                        - velocities.velocity_link_6_vy
                            * inertias.minus_inertia_link_6_hx))
            + velocities.velocity_link_6_vx
                * (velocities.velocity_link_6_vx * 2.0
                    + (velocities.velocity_link_6_wy * inertias.inertia_link_6_hz
                        + velocities.velocity_link_6_wz
                            * inertias.minus_inertia_link_6_hy))
            + velocities.velocity_link_6_vy
                * (velocities.velocity_link_6_vy * 2.0
                    - (velocities.velocity_link_6_wz * inertias.minus_inertia_link_6_hx
                        + velocities.velocity_link_6_wx * inertias.inertia_link_6_hz))
            + velocities.velocity_link_6_vz
                * (velocities.velocity_link_6_vz * 2.0
                    + (velocities.velocity_link_6_wy * inertias.minus_inertia_link_6_hx
                        - velocities.velocity_link_6_wx
                            * inertias.minus_inertia_link_6_hy)))
        + (velocities.velocity_link_7_wx
            * (inertias.inertia_link_7_xx * velocities.velocity_link_7_wx
                - inertias.minus_inertia_link_7_xy * velocities.velocity_link_7_wy
                + inertias.inertia_link_7_xz * velocities.velocity_link_7_wz
                - (velocities.velocity_link_7_vz * inertias.minus_inertia_link_7_hy
                    + velocities.velocity_link_7_vy * inertias.inertia_link_7_hz))
            + velocities.velocity_link_7_wy
                * (inertias.inertia_link_7_yy * velocities.velocity_link_7_wy
                    - inertias.minus_inertia_link_7_xy * velocities.velocity_link_7_wx
                    + inertias.inertia_link_7_yz * velocities.velocity_link_7_wz
                    + (velocities.velocity_link_7_vx * inertias.inertia_link_7_hz
                        + velocities.velocity_link_7_vz
                            * inertias.minus_inertia_link_7_hx))
            + velocities.velocity_link_7_wz
                * (inertias.inertia_link_7_xz * velocities.velocity_link_7_wx
                    + inertias.inertia_link_7_yz * velocities.velocity_link_7_wy
                    + inertias.inertia_link_7_zz * velocities.velocity_link_7_wz
                    + (velocities.velocity_link_7_vx * inertias.minus_inertia_link_7_hy
                        - velocities.velocity_link_7_vy
                            * inertias.minus_inertia_link_7_hx))
            + velocities.velocity_link_7_vx
                * (velocities.velocity_link_7_vx * 2.0
                    + (velocities.velocity_link_7_wy * inertias.inertia_link_7_hz
                        + velocities.velocity_link_7_wz
                            * inertias.minus_inertia_link_7_hy))
            + velocities.velocity_link_7_vy
                * (velocities.velocity_link_7_vy * 2.0
                    - (velocities.velocity_link_7_wz * inertias.minus_inertia_link_7_hx
                        + velocities.velocity_link_7_wx * inertias.inertia_link_7_hz))
            + velocities.velocity_link_7_vz
                * (velocities.velocity_link_7_vz * 2.0
                    + (velocities.velocity_link_7_wy * inertias.minus_inertia_link_7_hx
                        - velocities.velocity_link_7_wx
                            * inertias.minus_inertia_link_7_hy)))) * 0.5;
    // ½ ξᵀ Λ ξ
    *kinetic_energy = kinetic_energy_0 + 0.0;
}
/// ξ̇ = Λ⁻¹ (D_μ ξ − D_q̇ ξ + [F₁; τ − A_lᵀ F₁]) + [0; γ; 0], in O(n); factoring Λ_q where joints mimic.
///
/// - `q`: shape (7; rad, m)
/// - `qd`: shape velocity (7; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `gravity`: acceleration of free fall, base axes (3; m/s²)
/// - `base_wrench`: wrench on the base, base frame (6; N·m, N)
/// - `tau`: joint torques (7; N·m, N)
/// - `xi_dot`: ξ̇ = [μ̇; q̈], acceleration, base frame (13; rad/s², m/s²)
///
/// 4390 operations: 2162 + −, 2212 ×, 16 ÷; 7 sin cos; about 51.7 KiB of code.
pub fn forward_dynamics(
    q: &[f64; 7],
    qd: &[f64; 7],
    mu: &[f64; 6],
    gravity: &[f64; 3],
    base_wrench: &[f64; 6],
    tau: &[f64; 7],
    xi_dot: &mut [f64; 13],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let velocities = velocities(qd, &poses, &screws);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
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
        &common_d_mu_and_7_more,
        &common_forward_dynamics_inverse_dynamics,
        xi_dot,
    );
}
/// V₁ = μ − A_l q̇ and ξ̇ at once: the rates of the pose, ġ₁ = g₁ V₁^, and of ξ.
///
/// - `q`: shape (7; rad, m)
/// - `qd`: shape velocity (7; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `gravity`: acceleration of free fall, base axes (3; m/s²)
/// - `base_wrench`: wrench on the base, base frame (6; N·m, N)
/// - `tau`: joint torques (7; N·m, N)
/// - `base_twist`: V₁, body twist of the base, base frame (6; rad/s, m/s)
/// - `xi_dot`: ξ̇ = [μ̇; q̈], acceleration, base frame (13; rad/s², m/s²)
///
/// 4408 operations: 2174 + −, 2218 ×, 16 ÷; 7 sin cos; about 51.9 KiB of code.
pub fn state_rate(
    q: &[f64; 7],
    qd: &[f64; 7],
    mu: &[f64; 6],
    gravity: &[f64; 3],
    base_wrench: &[f64; 6],
    tau: &[f64; 7],
    base_twist: &mut [f64; 6],
    xi_dot: &mut [f64; 13],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let velocities = velocities(qd, &poses, &screws);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
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
        &common_d_mu_and_7_more,
        &common_forward_dynamics_inverse_dynamics,
        xi_dot,
    );
}
/// [F₁; τ − A_lᵀ F₁] = Λ (ξ̇ − [0; γ; 0]) + D_q̇ ξ − D_μ ξ, in O(n).
///
/// - `q`: shape (7; rad, m)
/// - `qd`: shape velocity (7; rad/s, m/s)
/// - `mu`: locked velocity, base frame (6; rad/s, m/s)
/// - `gravity`: acceleration of free fall, base axes (3; m/s²)
/// - `xi_dot`: acceleration, base frame (13; rad/s², m/s²)
/// - `base_wrench`: F₁, wrench on the base, base frame (6; N·m, N)
/// - `tau`: τ, joint torques (7; N·m, N)
///
/// 3811 operations: 1886 + −, 1922 ×, 3 ÷; 7 sin cos; about 44.9 KiB of code.
pub fn inverse_dynamics(
    q: &[f64; 7],
    qd: &[f64; 7],
    mu: &[f64; 6],
    gravity: &[f64; 3],
    xi_dot: &[f64; 13],
    base_wrench: &mut [f64; 6],
    tau: &mut [f64; 7],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    let velocities = velocities(qd, &poses, &screws);
    let common_d_mu_and_7_more = common_d_mu_and_7_more(&poses, &inertias, &screws);
    let common_forward_dynamics_inverse_dynamics = common_forward_dynamics_inverse_dynamics(
        mu,
        qd,
        &poses,
        &inertias,
        &screws,
        &velocities,
    );
    let base_wrench_0_0_1 = inertias.composite_base_xy * mu[0]
        + inertias.composite_base_yy * mu[1] + inertias.composite_base_yz * mu[2];
    let base_wrench_0_0_3 = inertias.composite_base_xz * mu[0]
        + inertias.composite_base_yz * mu[1] + inertias.composite_base_zz * mu[2];
    let base_wrench_0_0_0_7 = inertias.composite_link_1_xy
        + inertias.composite_link_1_xy;
    let base_wrench_0_0_0_6_1 = inertias.composite_link_1_hy * poses.minus_origin_base_x;
    let base_wrench_0_0_0_6 = base_wrench_0_0_0_6_1 + base_wrench_0_0_0_6_1;
    let base_wrench_0_3_13_0 = mu[3] + (mu[1] * poses.com_z - mu[2] * poses.com_y);
    let base_wrench_0_0_7_0 = mu[4] + (mu[2] * poses.com_x - mu[0] * poses.com_z);
    let base_wrench_0_0_5_0 = mu[5] + (mu[0] * poses.com_y - mu[1] * poses.com_x);
    let base_wrench_0_3_13 = base_wrench_0_3_13_0 * 17.5;
    let base_wrench_0_0_7 = base_wrench_0_0_7_0 * 17.5;
    let base_wrench_0_0_5 = base_wrench_0_0_5_0 * 17.5;
    let base_wrench_0_0_0_22 = (inertias.composite_link_1_xx
        - inertias.composite_link_1_yy
        - (inertias.inside_joint_1_mz_1_0 - inertias.inside_joint_1_mz_1_1)) * qd[0]
        - common_d_mu_and_7_more.three_joint_2_x_0_1_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_x_0_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_0_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_0_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_0_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_0_1_0 * qd[6];
    let base_wrench_0_0_0_24 = common_d_mu_and_7_more.three_joint_2_x_1_0 * qd[1]
        - screws.inside_joint_1_my * qd[0]
        + common_d_mu_and_7_more.three_joint_3_x_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_x_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_x_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_x_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_x_1_0 * qd[6];
    let base_wrench_0_3_8 = velocities.velocity_base_vx * 17.5;
    let base_wrench_0_0_0_26 = velocities.minus_velocity_base_vy * 17.5;
    let base_wrench_0_0_0_28 = velocities.minus_velocity_base_vz * 17.5;
    let base_wrench_0_3_12 = mu[0] - velocities.minus_velocity_base_wx;
    let base_wrench_0_0_4 = mu[1] - velocities.minus_velocity_base_wy;
    let base_wrench_0_0_2 = mu[2] - velocities.minus_velocity_base_wz;
    let base_wrench_0_0_0 = inertias.composite_base_xx * xi_dot[0]
        + inertias.composite_base_xy * xi_dot[1] + inertias.composite_base_xz * xi_dot[2]
        + (((base_wrench_0_0_0_6 - base_wrench_0_0_0_7) * qd[0]
            + common_d_mu_and_7_more.three_joint_2_x_0_0_0 * qd[1]
            + common_d_mu_and_7_more.three_joint_3_x_0_0_0 * qd[2]
            + common_d_mu_and_7_more.three_joint_4_x_0_0_0 * qd[3]
            + common_d_mu_and_7_more.three_joint_5_x_0_0_0 * qd[4]
            + common_d_mu_and_7_more.three_joint_6_x_0_0_0 * qd[5]
            + common_d_mu_and_7_more.three_joint_7_x_0_0_0 * qd[6]) * mu[0]
            + base_wrench_0_0_0_22 * mu[1] + base_wrench_0_0_0_24 * mu[2]
            + (base_wrench_0_0_0_26 * base_wrench_0_0_5_0
                - base_wrench_0_0_0_28 * base_wrench_0_0_7_0));
    let base_wrench_0_0 = base_wrench_0_0_0
        - (base_wrench_0_0_1 * base_wrench_0_0_2 - base_wrench_0_0_3 * base_wrench_0_0_4
            + (base_wrench_0_0_5 * velocities.minus_velocity_base_vy
                - base_wrench_0_0_7 * velocities.minus_velocity_base_vz));
    let base_wrench_0_3 = (xi_dot[4] - gravity[1]
        + (xi_dot[2] * poses.com_x - xi_dot[0] * poses.com_z)) * 17.5
        - (mu[2] * base_wrench_0_3_8 + mu[0] * base_wrench_0_0_0_28)
        - (base_wrench_0_0_5 * base_wrench_0_3_12
            - base_wrench_0_3_13 * base_wrench_0_0_2);
    let base_wrench_0_1 = (xi_dot[5] - gravity[2]
        + (xi_dot[0] * poses.com_y - xi_dot[1] * poses.com_x)) * 17.5
        + (mu[0] * base_wrench_0_0_0_26 + mu[1] * base_wrench_0_3_8)
        - (base_wrench_0_3_13 * base_wrench_0_0_4
            - base_wrench_0_0_7 * base_wrench_0_3_12);
    // F₁
    base_wrench[0] = base_wrench_0_0
        + (base_wrench_0_1 * poses.com_y - base_wrench_0_3 * poses.com_z) + 0.0;
    let base_wrench_1_0_3 = inertias.composite_base_xx * mu[0]
        + inertias.composite_base_xy * mu[1] + inertias.composite_base_xz * mu[2];
    let base_wrench_1_0_0_9_1 = inertias.composite_link_1_hx * poses.minus_origin_base_y;
    let base_wrench_1_0_0_9 = base_wrench_1_0_0_9_1 + base_wrench_1_0_0_9_1;
    let base_wrench_1_0_0_24 = screws.inside_joint_1_mx * qd[0]
        + common_d_mu_and_7_more.three_joint_2_y_1_0 * qd[1]
        + common_d_mu_and_7_more.three_joint_3_y_1_0 * qd[2]
        + common_d_mu_and_7_more.three_joint_4_y_1_0 * qd[3]
        + common_d_mu_and_7_more.three_joint_5_y_1_0 * qd[4]
        + common_d_mu_and_7_more.three_joint_6_y_1_0 * qd[5]
        + common_d_mu_and_7_more.three_joint_7_y_1_0 * qd[6];
    let base_wrench_1_0_0 = inertias.composite_base_xy * xi_dot[0]
        + inertias.composite_base_yy * xi_dot[1] + inertias.composite_base_yz * xi_dot[2]
        + (base_wrench_0_0_0_22 * mu[0]
            + ((base_wrench_0_0_0_7 - base_wrench_1_0_0_9) * qd[0]
                + common_d_mu_and_7_more.three_joint_2_y_0_0_0 * qd[1]
                + common_d_mu_and_7_more.three_joint_3_y_0_1_0 * qd[2]
                + common_d_mu_and_7_more.three_joint_4_y_0_1_0 * qd[3]
                + common_d_mu_and_7_more.three_joint_5_y_0_1_0 * qd[4]
                + common_d_mu_and_7_more.three_joint_6_y_0_1_0 * qd[5]
                + common_d_mu_and_7_more.three_joint_7_y_0_1_0 * qd[6]) * mu[1]
            + base_wrench_1_0_0_24 * mu[2]
            + (base_wrench_0_0_0_28 * base_wrench_0_3_13_0
                + base_wrench_0_3_8 * base_wrench_0_0_5_0));
    let base_wrench_1_0 = base_wrench_1_0_0
        - (base_wrench_0_0_3 * base_wrench_0_3_12 - base_wrench_1_0_3 * base_wrench_0_0_2
            + (base_wrench_0_0_5 * velocities.velocity_base_vx
                + base_wrench_0_3_13 * velocities.minus_velocity_base_vz));
    let base_wrench_1_1 = (xi_dot[3] - gravity[0]
        + (xi_dot[1] * poses.com_z - xi_dot[2] * poses.com_y)) * 17.5
        + (mu[1] * base_wrench_0_0_0_28 - mu[2] * base_wrench_0_0_0_26)
        - (base_wrench_0_0_7 * base_wrench_0_0_2
            - base_wrench_0_0_5 * base_wrench_0_0_4);
    base_wrench[1] = base_wrench_1_0
        + (base_wrench_1_1 * poses.com_z - base_wrench_0_1 * poses.com_x) + 0.0;
    let base_wrench_2_0 = inertias.composite_base_xz * xi_dot[0]
        + inertias.composite_base_yz * xi_dot[1] + inertias.composite_base_zz * xi_dot[2]
        + (base_wrench_0_0_0_24 * mu[0] + base_wrench_1_0_0_24 * mu[1]
            + ((base_wrench_0_0_0_6 - base_wrench_1_0_0_9) * qd[0]
                + common_d_mu_and_7_more.three_joint_2_z_1_0 * qd[1]
                + common_d_mu_and_7_more.three_joint_3_z_1_0 * qd[2]
                - common_d_mu_and_7_more.three_joint_4_z_1_0 * qd[3]
                + common_d_mu_and_7_more.three_joint_5_z_1_0 * qd[4]
                + common_d_mu_and_7_more.three_joint_6_z_1_0 * qd[5]
                + common_d_mu_and_7_more.three_joint_7_z_1_0 * qd[6]) * mu[2]
            - (base_wrench_0_3_8 * base_wrench_0_0_7_0
                + base_wrench_0_0_0_26 * base_wrench_0_3_13_0))
        - (base_wrench_1_0_3 * base_wrench_0_0_4 - base_wrench_0_0_1 * base_wrench_0_3_12
            - (base_wrench_0_3_13 * velocities.minus_velocity_base_vy
                + base_wrench_0_0_7 * velocities.velocity_base_vx));
    base_wrench[2] = base_wrench_2_0
        + (base_wrench_0_3 * poses.com_x - base_wrench_1_1 * poses.com_y) + 0.0;
    base_wrench[3] = base_wrench_1_1 + 0.0;
    base_wrench[4] = base_wrench_0_3 + 0.0;
    base_wrench[5] = base_wrench_0_1 + 0.0;
    let minus_twist_base_wx = screws.connection_joint_1_wx * xi_dot[6]
        + screws.connection_joint_2_wx * xi_dot[7]
        + screws.connection_joint_3_wx * xi_dot[8]
        + screws.connection_joint_4_wx * xi_dot[9]
        + screws.connection_joint_5_wx * xi_dot[10]
        + screws.connection_joint_6_wx * xi_dot[11]
        + screws.connection_joint_7_wx * xi_dot[12];
    let minus_twist_base_wy = screws.connection_joint_1_wy * xi_dot[6]
        + screws.connection_joint_2_wy * xi_dot[7]
        + screws.connection_joint_3_wy * xi_dot[8]
        + screws.connection_joint_4_wy * xi_dot[9]
        + screws.connection_joint_5_wy * xi_dot[10]
        + screws.connection_joint_6_wy * xi_dot[11]
        + screws.connection_joint_7_wy * xi_dot[12];
    let minus_twist_base_wz = screws.connection_joint_1_wz * xi_dot[6]
        + screws.connection_joint_2_wz * xi_dot[7]
        + screws.connection_joint_3_wz * xi_dot[8]
        + screws.connection_joint_4_wz * xi_dot[9]
        + screws.connection_joint_5_wz * xi_dot[10]
        + screws.connection_joint_6_wz * xi_dot[11]
        + screws.connection_joint_7_wz * xi_dot[12];
    let twist_base_vx = screws.minus_connection_joint_1_vx * xi_dot[6]
        - screws.connection_joint_2_vx * xi_dot[7]
        - screws.connection_joint_3_vx * xi_dot[8]
        - screws.connection_joint_4_vx * xi_dot[9]
        - screws.connection_joint_5_vx * xi_dot[10]
        - screws.connection_joint_6_vx * xi_dot[11]
        - screws.connection_joint_7_vx * xi_dot[12];
    let minus_twist_base_vy = screws.connection_joint_1_vy * xi_dot[6]
        + screws.connection_joint_2_vy * xi_dot[7]
        + screws.connection_joint_3_vy * xi_dot[8]
        + screws.connection_joint_4_vy * xi_dot[9]
        + screws.connection_joint_5_vy * xi_dot[10]
        + screws.connection_joint_6_vy * xi_dot[11]
        + screws.connection_joint_7_vy * xi_dot[12];
    let minus_twist_base_vz = screws.connection_joint_2_vz * xi_dot[7]
        + screws.connection_joint_3_vz * xi_dot[8]
        + screws.connection_joint_4_vz * xi_dot[9]
        + screws.connection_joint_5_vz * xi_dot[10]
        + screws.connection_joint_6_vz * xi_dot[11]
        + screws.connection_joint_7_vz * xi_dot[12];
    let twist_link_1_wx = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_0 - minus_twist_base_wx;
    let minus_twist_link_1_wy = minus_twist_base_wy
        + common_forward_dynamics_inverse_dynamics
            .wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_1;
    let twist_link_1_wz = xi_dot[6] - minus_twist_base_wz;
    let twist_link_1_vx = twist_base_vx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_0_0_0_0_0
            - poses.minus_origin_base_y * xi_dot[6]);
    let twist_link_1_vy = poses.minus_origin_base_x * xi_dot[6]
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_0_0_0_1
        - minus_twist_base_vy;
    let twist_link_1_vz = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_mx_0_1_0_1_0_0_0_0_0_0 - minus_twist_base_vz;
    let twist_link_2_wx = twist_link_1_wx
        + (common_forward_dynamics_inverse_dynamics
            .wrench_link_7_mx_0_0_0_0_1_0_0_0_0_0_1 + poses.sin_joint_1 * xi_dot[7]);
    let twist_link_2_wy = common_forward_dynamics_inverse_dynamics
        .wrench_link_7_mx_0_0_0_1_1_0_0_0_0_0_0 - poses.cos_joint_1 * xi_dot[7]
        - minus_twist_link_1_wy;
    let twist_link_2_wz = twist_link_1_wz
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_0_1;
    let twist_link_2_vx = twist_link_1_vx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_0_0_0_0_1
            + screws.screw_joint_2_vx * xi_dot[7]);
    let twist_link_2_vy = twist_link_1_vy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_0_0_0_0
            + screws.screw_joint_2_vy * xi_dot[7]);
    let twist_link_2_vz = twist_link_1_vz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_0_0_0_0_1
            + screws.screw_joint_2_vz * xi_dot[7]);
    let twist_link_3_wx = twist_link_2_wx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_0_0_0_1
            - poses.minus_rotation_link_2_xy * xi_dot[8]);
    let twist_link_3_wy = twist_link_2_wy
        - (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_0_0_0_0_1
            + poses.minus_rotation_link_2_yy * xi_dot[8]);
    let twist_link_3_wz = twist_link_2_wz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_0_0
            + poses.cos_joint_2 * xi_dot[8]);
    let twist_link_3_vx = twist_link_2_vx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_0_0_0_1
            + screws.screw_joint_3_vx * xi_dot[8]);
    let twist_link_3_vy = twist_link_2_vy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_0_0_1
            + screws.screw_joint_3_vy * xi_dot[8]);
    let twist_link_3_vz = twist_link_2_vz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_0_0_0_1
            + screws.screw_joint_3_vz * xi_dot[8]);
    let twist_link_4_wx = twist_link_3_wx
        - (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_0_0_1
            + poses.minus_rotation_link_3_xy * xi_dot[9]);
    let twist_link_4_wy = twist_link_3_wy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_0_0_0_1
            + poses.rotation_link_3_yy * xi_dot[9]);
    let twist_link_4_wz = twist_link_3_wz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_0_1
            - poses.minus_rotation_link_3_zy * xi_dot[9]);
    let twist_link_4_vx = twist_link_3_vx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_0_0_1
            + screws.screw_joint_4_vx * xi_dot[9]);
    let twist_link_4_vy = twist_link_3_vy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_0_1
            - screws.minus_screw_joint_4_vy * xi_dot[9]);
    let twist_link_4_vz = twist_link_3_vz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_0_0_1
            - screws.minus_screw_joint_4_vz * xi_dot[9]);
    let twist_link_5_wx = twist_link_4_wx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_0_1
            - poses.rotation_link_4_xy * xi_dot[10]);
    let twist_link_5_wy = twist_link_4_wy
        - (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_0_0_1
            + poses.rotation_link_4_yy * xi_dot[10]);
    let twist_link_5_wz = twist_link_4_wz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_0_1
            + poses.rotation_link_5_zz * xi_dot[10]);
    let twist_link_5_vx = twist_link_4_vx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_0_1
            + screws.screw_joint_5_vx * xi_dot[10]);
    let twist_link_5_vy = twist_link_4_vy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_0_1
            + screws.screw_joint_5_vy * xi_dot[10]);
    let twist_link_5_vz = twist_link_4_vz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_0_1
            + screws.screw_joint_5_vz * xi_dot[10]);
    let twist_link_6_wx = twist_link_5_wx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_0_1
            + poses.rotation_link_6_xz * xi_dot[11]);
    let twist_link_6_wy = twist_link_5_wy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_0_1
            - poses.rotation_link_5_yy * xi_dot[11]);
    let twist_link_6_wz = twist_link_5_wz
        + (poses.rotation_link_6_zz * xi_dot[11]
            - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_0_1);
    let twist_link_6_vx = twist_link_5_vx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_0_1
            + screws.screw_joint_6_vx * xi_dot[11]);
    let twist_link_6_vy = twist_link_5_vy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_0_1
            + screws.screw_joint_6_vy * xi_dot[11]);
    let twist_link_6_vz = twist_link_5_vz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_0_1
            + screws.screw_joint_6_vz * xi_dot[11]);
    let twist_link_7_wx = twist_link_6_wx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_0_1_1
            - poses.minus_rotation_link_6_xy * xi_dot[12]);
    let twist_link_7_wy = twist_link_6_wy
        - (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_0_1_1_1
            + poses.minus_rotation_link_6_yy * xi_dot[12]);
    let twist_link_7_wz = twist_link_6_wz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_0_1_1_1
            + poses.rotation_link_6_zy * xi_dot[12]);
    let twist_link_7_vx = twist_link_6_vx
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_my_0_1_0_1_1
            + screws.screw_joint_7_vx * xi_dot[12]);
    let twist_link_7_vy = twist_link_6_vy
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_1_1_1
            + screws.screw_joint_7_vy * xi_dot[12]);
    let twist_link_7_vz = twist_link_6_vz
        + (common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_0_1_0_1_1
            + screws.screw_joint_7_vz * xi_dot[12]);
    let wrench_outside_link_1_mx = inertias.minus_inertia_base_xy * minus_twist_base_wy
        - inertias.inertia_base_xx * minus_twist_base_wx
        + inertias.minus_inertia_base_xz * minus_twist_base_wz
        + (inertias.minus_inertia_base_hy * minus_twist_base_vz
            - inertias.minus_inertia_base_hz * minus_twist_base_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_base_mx_1_0;
    let wrench_outside_link_1_my = inertias.minus_inertia_base_xy * minus_twist_base_wx
        - inertias.inertia_base_yy * minus_twist_base_wy
        + inertias.minus_inertia_base_yz * minus_twist_base_wz
        - (inertias.minus_inertia_base_hz * twist_base_vx
            + inertias.minus_inertia_base_hx * minus_twist_base_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_base_my_1_0;
    let wrench_outside_link_1_mz = inertias.minus_inertia_base_xz * minus_twist_base_wx
        + inertias.minus_inertia_base_yz * minus_twist_base_wy
        - inertias.inertia_base_zz * minus_twist_base_wz
        + (inertias.minus_inertia_base_hx * minus_twist_base_vy
            + inertias.minus_inertia_base_hy * twist_base_vx)
        - common_forward_dynamics_inverse_dynamics.wrench_base_mz_1_0;
    let wrench_outside_link_1_fx = twist_base_vx * 3.5
        + (minus_twist_base_wy * inertias.minus_inertia_base_hz
            - minus_twist_base_wz * inertias.minus_inertia_base_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_base_fx_1_0;
    let wrench_outside_link_1_fy = minus_twist_base_wz * inertias.minus_inertia_base_hx
        - minus_twist_base_wx * inertias.minus_inertia_base_hz
        - minus_twist_base_vy * 3.5
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
        + inertias.inertia_link_2_xy * twist_link_2_wy
        + inertias.inertia_link_2_xz * twist_link_2_wz
        - (inertias.minus_inertia_link_2_hy * twist_link_2_vz
            + inertias.inertia_link_2_hz * twist_link_2_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_mx_0_1;
    let wrench_link_2_my_0 = inertias.inertia_link_2_xy * twist_link_2_wx
        + inertias.inertia_link_2_yy * twist_link_2_wy
        + inertias.inertia_link_2_yz * twist_link_2_wz
        + (inertias.inertia_link_2_hz * twist_link_2_vx
            - inertias.inertia_link_2_hx * twist_link_2_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_my_0_1;
    let wrench_link_2_mz_0 = inertias.inertia_link_2_xz * twist_link_2_wx
        + inertias.inertia_link_2_yz * twist_link_2_wy
        + inertias.inertia_link_2_zz * twist_link_2_wz
        + (inertias.inertia_link_2_hx * twist_link_2_vy
            + inertias.minus_inertia_link_2_hy * twist_link_2_vx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_mz_0_1;
    let wrench_link_3_mx_0 = inertias.inertia_link_3_xx * twist_link_3_wx
        + inertias.inertia_link_3_xy * twist_link_3_wy
        + inertias.inertia_link_3_xz * twist_link_3_wz
        - (inertias.minus_inertia_link_3_hy * twist_link_3_vz
            + inertias.inertia_link_3_hz * twist_link_3_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mx_0_1;
    let wrench_link_3_my_0 = inertias.inertia_link_3_xy * twist_link_3_wx
        + inertias.inertia_link_3_yy * twist_link_3_wy
        + inertias.inertia_link_3_yz * twist_link_3_wz
        + (inertias.inertia_link_3_hz * twist_link_3_vx
            - inertias.inertia_link_3_hx * twist_link_3_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_my_0_1;
    let wrench_link_3_mz_0 = inertias.inertia_link_3_xz * twist_link_3_wx
        + inertias.inertia_link_3_yz * twist_link_3_wy
        + inertias.inertia_link_3_zz * twist_link_3_wz
        + (inertias.inertia_link_3_hx * twist_link_3_vy
            + inertias.minus_inertia_link_3_hy * twist_link_3_vx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_mz_0_1;
    let wrench_link_4_mx_0 = inertias.inertia_link_4_xx * twist_link_4_wx
        + inertias.inertia_link_4_xy * twist_link_4_wy
        + inertias.inertia_link_4_xz * twist_link_4_wz
        + (inertias.inertia_link_4_hy * twist_link_4_vz
            - inertias.inertia_link_4_hz * twist_link_4_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_mx_0_1;
    let wrench_link_4_my_0 = inertias.inertia_link_4_xy * twist_link_4_wx
        + inertias.inertia_link_4_yy * twist_link_4_wy
        + inertias.inertia_link_4_yz * twist_link_4_wz
        + (inertias.inertia_link_4_hz * twist_link_4_vx
            + inertias.minus_inertia_link_4_hx * twist_link_4_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_my_0_1;
    let wrench_link_4_mz_0 = inertias.inertia_link_4_xz * twist_link_4_wx
        + inertias.inertia_link_4_yz * twist_link_4_wy
        + inertias.inertia_link_4_zz * twist_link_4_wz
        - (inertias.minus_inertia_link_4_hx * twist_link_4_vy
            + inertias.inertia_link_4_hy * twist_link_4_vx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_mz_0_1;
    let wrench_link_5_mx_0 = inertias.inertia_link_5_xx * twist_link_5_wx
        + inertias.inertia_link_5_xy * twist_link_5_wy
        + inertias.inertia_link_5_xz * twist_link_5_wz
        + (inertias.inertia_link_5_hy * twist_link_5_vz
            - inertias.inertia_link_5_hz * twist_link_5_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_mx_0_1;
    let wrench_link_5_my_0 = inertias.inertia_link_5_xy * twist_link_5_wx
        + inertias.inertia_link_5_yy * twist_link_5_wy
        + inertias.inertia_link_5_yz * twist_link_5_wz
        + (inertias.inertia_link_5_hz * twist_link_5_vx
            + inertias.minus_inertia_link_5_hx * twist_link_5_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_my_0_1;
    let wrench_link_5_mz_0 = inertias.inertia_link_5_xz * twist_link_5_wx
        + inertias.inertia_link_5_yz * twist_link_5_wy
        + inertias.inertia_link_5_zz * twist_link_5_wz
        - (inertias.minus_inertia_link_5_hx * twist_link_5_vy
            + inertias.inertia_link_5_hy * twist_link_5_vx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_mz_0_1;
    let wrench_link_6_mx_0 = inertias.inertia_link_6_xx * twist_link_6_wx
        - inertias.minus_inertia_link_6_xy * twist_link_6_wy
        + inertias.inertia_link_6_xz * twist_link_6_wz
        - (inertias.minus_inertia_link_6_hy * twist_link_6_vz
            + inertias.inertia_link_6_hz * twist_link_6_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_mx_0_1;
    let wrench_link_6_my_0 = inertias.inertia_link_6_yy * twist_link_6_wy
        - inertias.minus_inertia_link_6_xy * twist_link_6_wx
        + inertias.inertia_link_6_yz * twist_link_6_wz
        + (inertias.inertia_link_6_hz * twist_link_6_vx
            + inertias.minus_inertia_link_6_hx * twist_link_6_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_my_0_1;
    let wrench_link_6_mz_0 = inertias.inertia_link_6_xz * twist_link_6_wx
        + inertias.inertia_link_6_yz * twist_link_6_wy
        + inertias.inertia_link_6_zz * twist_link_6_wz
        + (inertias.minus_inertia_link_6_hy * twist_link_6_vx
            - inertias.minus_inertia_link_6_hx * twist_link_6_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_mz_0_1;
    let wrench_link_7_mx = inertias.inertia_link_7_xx * twist_link_7_wx
        - inertias.minus_inertia_link_7_xy * twist_link_7_wy
        + inertias.inertia_link_7_xz * twist_link_7_wz
        - (inertias.minus_inertia_link_7_hy * twist_link_7_vz
            + inertias.inertia_link_7_hz * twist_link_7_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mx_1;
    let wrench_link_7_my = inertias.inertia_link_7_yy * twist_link_7_wy
        - inertias.minus_inertia_link_7_xy * twist_link_7_wx
        + inertias.inertia_link_7_yz * twist_link_7_wz
        + (inertias.inertia_link_7_hz * twist_link_7_vx
            + inertias.minus_inertia_link_7_hx * twist_link_7_vz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_my_1;
    let wrench_link_7_mz = inertias.inertia_link_7_xz * twist_link_7_wx
        + inertias.inertia_link_7_yz * twist_link_7_wy
        + inertias.inertia_link_7_zz * twist_link_7_wz
        + (inertias.minus_inertia_link_7_hy * twist_link_7_vx
            - inertias.minus_inertia_link_7_hx * twist_link_7_vy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_mz_1;
    let wrench_link_6_mx = wrench_link_6_mx_0 + wrench_link_7_mx;
    let wrench_link_6_my = wrench_link_6_my_0 + wrench_link_7_my;
    let wrench_link_6_mz = wrench_link_6_mz_0 + wrench_link_7_mz;
    let wrench_link_5_mx = wrench_link_5_mx_0 + wrench_link_6_mx;
    let wrench_link_5_my = wrench_link_5_my_0 + wrench_link_6_my;
    let wrench_link_5_mz = wrench_link_5_mz_0 + wrench_link_6_mz;
    let wrench_link_4_mx = wrench_link_4_mx_0 + wrench_link_5_mx;
    let wrench_link_4_my = wrench_link_4_my_0 + wrench_link_5_my;
    let wrench_link_4_mz = wrench_link_4_mz_0 + wrench_link_5_mz;
    let wrench_link_3_mx = wrench_link_3_mx_0 + wrench_link_4_mx;
    let wrench_link_3_my = wrench_link_3_my_0 + wrench_link_4_my;
    let wrench_link_3_mz = wrench_link_3_mz_0 + wrench_link_4_mz;
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
            - screws.minus_connection_joint_1_vx * wrench_outside_link_1_fx
            + screws.connection_joint_1_vy * wrench_outside_link_1_fy)
        + (screws.connection_joint_1_wx * base_wrench_0_0
            + screws.connection_joint_1_wy * base_wrench_1_0
            + screws.connection_joint_1_wz * base_wrench_2_0
            - screws.minus_connection_joint_1_vx * base_wrench_1_1
            + screws.connection_joint_1_vy * base_wrench_0_3) + 0.0;
    let wrench_outside_link_1_fz = minus_twist_base_wx * inertias.minus_inertia_base_hy
        - minus_twist_base_wy * inertias.minus_inertia_base_hx
        - minus_twist_base_vz * 3.5
        - common_forward_dynamics_inverse_dynamics.wrench_base_fz_1_0;
    let wrench_link_2_fx_0 = twist_link_2_vx * 2.0
        + (twist_link_2_wy * inertias.inertia_link_2_hz
            + twist_link_2_wz * inertias.minus_inertia_link_2_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fx_0_1;
    let wrench_link_2_fy_0 = twist_link_2_vy * 2.0
        + (twist_link_2_wz * inertias.inertia_link_2_hx
            - twist_link_2_wx * inertias.inertia_link_2_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fy_0_1;
    let wrench_link_2_fz_0 = twist_link_2_vz * 2.0
        - (twist_link_2_wx * inertias.minus_inertia_link_2_hy
            + twist_link_2_wy * inertias.inertia_link_2_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_2_fz_0_1;
    let wrench_link_3_fx_0 = twist_link_3_vx * 2.0
        + (twist_link_3_wy * inertias.inertia_link_3_hz
            + twist_link_3_wz * inertias.minus_inertia_link_3_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fx_0_1;
    let wrench_link_3_fy_0 = twist_link_3_vy * 2.0
        + (twist_link_3_wz * inertias.inertia_link_3_hx
            - twist_link_3_wx * inertias.inertia_link_3_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fy_0_1;
    let wrench_link_3_fz_0 = twist_link_3_vz * 2.0
        - (twist_link_3_wx * inertias.minus_inertia_link_3_hy
            + twist_link_3_wy * inertias.inertia_link_3_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_3_fz_0_1;
    let wrench_link_4_fx_0 = twist_link_4_vx * 2.0
        + (twist_link_4_wy * inertias.inertia_link_4_hz
            - twist_link_4_wz * inertias.inertia_link_4_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_fx_0_1;
    let wrench_link_4_fy_0 = twist_link_4_vy * 2.0
        - (twist_link_4_wz * inertias.minus_inertia_link_4_hx
            + twist_link_4_wx * inertias.inertia_link_4_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_fy_0_1;
    let wrench_link_4_fz_0 = twist_link_4_vz * 2.0
        + (twist_link_4_wx * inertias.inertia_link_4_hy
            + twist_link_4_wy * inertias.minus_inertia_link_4_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_4_fz_0_1;
    let wrench_link_5_fx_0 = twist_link_5_vx * 2.0
        + (twist_link_5_wy * inertias.inertia_link_5_hz
            - twist_link_5_wz * inertias.inertia_link_5_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_fx_0_1;
    let wrench_link_5_fy_0 = twist_link_5_vy * 2.0
        - (twist_link_5_wz * inertias.minus_inertia_link_5_hx
            + twist_link_5_wx * inertias.inertia_link_5_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_fy_0_1;
    let wrench_link_5_fz_0 = twist_link_5_vz * 2.0
        + (twist_link_5_wx * inertias.inertia_link_5_hy
            + twist_link_5_wy * inertias.minus_inertia_link_5_hx)
        - common_forward_dynamics_inverse_dynamics.wrench_link_5_fz_0_1;
    let wrench_link_6_fx_0 = twist_link_6_vx * 2.0
        + (twist_link_6_wy * inertias.inertia_link_6_hz
            + twist_link_6_wz * inertias.minus_inertia_link_6_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_fx_0_1;
    let wrench_link_6_fy_0 = twist_link_6_vy * 2.0
        - (twist_link_6_wz * inertias.minus_inertia_link_6_hx
            + twist_link_6_wx * inertias.inertia_link_6_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_fy_0_1;
    let wrench_link_6_fz_0 = twist_link_6_vz * 2.0
        + (twist_link_6_wy * inertias.minus_inertia_link_6_hx
            - twist_link_6_wx * inertias.minus_inertia_link_6_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_6_fz_0_1;
    let wrench_link_7_fx = twist_link_7_vx * 2.0
        + (twist_link_7_wy * inertias.inertia_link_7_hz
            + twist_link_7_wz * inertias.minus_inertia_link_7_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_fx_1;
    let wrench_link_7_fy = twist_link_7_vy * 2.0
        - (twist_link_7_wz * inertias.minus_inertia_link_7_hx
            + twist_link_7_wx * inertias.inertia_link_7_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_fy_1;
    let wrench_link_7_fz = twist_link_7_vz * 2.0
        + (twist_link_7_wy * inertias.minus_inertia_link_7_hx
            - twist_link_7_wx * inertias.minus_inertia_link_7_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_7_fz_1;
    let wrench_link_6_fx = wrench_link_6_fx_0 + wrench_link_7_fx;
    let wrench_link_6_fy = wrench_link_6_fy_0 + wrench_link_7_fy;
    let wrench_link_6_fz = wrench_link_6_fz_0 + wrench_link_7_fz;
    let wrench_link_5_fx = wrench_link_5_fx_0 + wrench_link_6_fx;
    let wrench_link_5_fy = wrench_link_5_fy_0 + wrench_link_6_fy;
    let wrench_link_5_fz = wrench_link_5_fz_0 + wrench_link_6_fz;
    let wrench_link_4_fx = wrench_link_4_fx_0 + wrench_link_5_fx;
    let wrench_link_4_fy = wrench_link_4_fy_0 + wrench_link_5_fy;
    let wrench_link_4_fz = wrench_link_4_fz_0 + wrench_link_5_fz;
    let wrench_link_3_fx = wrench_link_3_fx_0 + wrench_link_4_fx;
    let wrench_link_3_fy = wrench_link_3_fy_0 + wrench_link_4_fy;
    let wrench_link_3_fz = wrench_link_3_fz_0 + wrench_link_4_fz;
    let wrench_link_2_fx = wrench_link_2_fx_0 + wrench_link_3_fx;
    let wrench_link_2_fy = wrench_link_2_fy_0 + wrench_link_3_fy;
    let wrench_link_2_fz = wrench_link_2_fz_0 + wrench_link_3_fz;
    let wrench_outside_link_2_mx = wrench_link_1_mx_0 + wrench_outside_link_1_mx;
    let wrench_outside_link_2_my = wrench_link_1_my_0 + wrench_outside_link_1_my;
    let wrench_outside_link_2_mz = wrench_link_1_mz_0 + wrench_outside_link_1_mz;
    let wrench_outside_link_2_fx = twist_link_1_vx * 2.0
        - (minus_twist_link_1_wy * inertias.inertia_link_1_hz
            + twist_link_1_wz * inertias.inertia_link_1_hy)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_fx_0_1
        + wrench_outside_link_1_fx;
    let wrench_outside_link_2_fy = twist_link_1_vy * 2.0
        - (twist_link_1_wz * inertias.minus_inertia_link_1_hx
            + twist_link_1_wx * inertias.inertia_link_1_hz)
        - common_forward_dynamics_inverse_dynamics.wrench_link_1_fy_1_1
        + wrench_outside_link_1_fy;
    let wrench_outside_link_2_fz = twist_link_1_vz * 2.0
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
            + screws.connection_joint_2_vy * base_wrench_0_3
            + screws.connection_joint_2_vz * base_wrench_0_1) + 0.0;
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
            + screws.connection_joint_3_vy * base_wrench_0_3
            + screws.connection_joint_3_vz * base_wrench_0_1) + 0.0;
    let wrench_outside_link_4_mx = wrench_link_3_mx_0 + wrench_outside_link_3_mx;
    let wrench_outside_link_4_my = wrench_link_3_my_0 + wrench_outside_link_3_my;
    let wrench_outside_link_4_mz = wrench_link_3_mz_0 + wrench_outside_link_3_mz;
    let wrench_outside_link_4_fx = wrench_link_3_fx_0 + wrench_outside_link_3_fx;
    let wrench_outside_link_4_fy = wrench_link_3_fy_0 + wrench_outside_link_3_fy;
    let wrench_outside_link_4_fz = wrench_link_3_fz_0 + wrench_outside_link_3_fz;
    tau[3] = reactions.reaction_joint_4_wx * wrench_link_4_mx
        + reactions.reaction_joint_4_wy * wrench_link_4_my
        + reactions.reaction_joint_4_wz * wrench_link_4_mz
        + reactions.reaction_joint_4_vx * wrench_link_4_fx
        + reactions.reaction_joint_4_vy * wrench_link_4_fy
        - reactions.minus_reaction_joint_4_vz * wrench_link_4_fz
        - (screws.connection_joint_4_wx * wrench_outside_link_4_mx
            + screws.connection_joint_4_wy * wrench_outside_link_4_my
            + screws.connection_joint_4_wz * wrench_outside_link_4_mz
            + screws.connection_joint_4_vx * wrench_outside_link_4_fx
            + screws.connection_joint_4_vy * wrench_outside_link_4_fy
            + screws.connection_joint_4_vz * wrench_outside_link_4_fz)
        + (screws.connection_joint_4_wx * base_wrench_0_0
            + screws.connection_joint_4_wy * base_wrench_1_0
            + screws.connection_joint_4_wz * base_wrench_2_0
            + screws.connection_joint_4_vx * base_wrench_1_1
            + screws.connection_joint_4_vy * base_wrench_0_3
            + screws.connection_joint_4_vz * base_wrench_0_1) + 0.0;
    let wrench_outside_link_5_mx = wrench_link_4_mx_0 + wrench_outside_link_4_mx;
    let wrench_outside_link_5_my = wrench_link_4_my_0 + wrench_outside_link_4_my;
    let wrench_outside_link_5_mz = wrench_link_4_mz_0 + wrench_outside_link_4_mz;
    let wrench_outside_link_5_fx = wrench_link_4_fx_0 + wrench_outside_link_4_fx;
    let wrench_outside_link_5_fy = wrench_link_4_fy_0 + wrench_outside_link_4_fy;
    let wrench_outside_link_5_fz = wrench_link_4_fz_0 + wrench_outside_link_4_fz;
    tau[4] = reactions.reaction_joint_5_wx * wrench_link_5_mx
        + reactions.reaction_joint_5_wy * wrench_link_5_my
        + reactions.reaction_joint_5_wz * wrench_link_5_mz
        + reactions.reaction_joint_5_vx * wrench_link_5_fx
        + reactions.reaction_joint_5_vy * wrench_link_5_fy
        + reactions.reaction_joint_5_vz * wrench_link_5_fz
        - (screws.connection_joint_5_wx * wrench_outside_link_5_mx
            + screws.connection_joint_5_wy * wrench_outside_link_5_my
            + screws.connection_joint_5_wz * wrench_outside_link_5_mz
            + screws.connection_joint_5_vx * wrench_outside_link_5_fx
            + screws.connection_joint_5_vy * wrench_outside_link_5_fy
            + screws.connection_joint_5_vz * wrench_outside_link_5_fz)
        + (screws.connection_joint_5_wx * base_wrench_0_0
            + screws.connection_joint_5_wy * base_wrench_1_0
            + screws.connection_joint_5_wz * base_wrench_2_0
            + screws.connection_joint_5_vx * base_wrench_1_1
            + screws.connection_joint_5_vy * base_wrench_0_3
            + screws.connection_joint_5_vz * base_wrench_0_1) + 0.0;
    let wrench_outside_link_6_mx = wrench_link_5_mx_0 + wrench_outside_link_5_mx;
    let wrench_outside_link_6_my = wrench_link_5_my_0 + wrench_outside_link_5_my;
    let wrench_outside_link_6_mz = wrench_link_5_mz_0 + wrench_outside_link_5_mz;
    let wrench_outside_link_6_fx = wrench_link_5_fx_0 + wrench_outside_link_5_fx;
    let wrench_outside_link_6_fy = wrench_link_5_fy_0 + wrench_outside_link_5_fy;
    let wrench_outside_link_6_fz = wrench_link_5_fz_0 + wrench_outside_link_5_fz;
    tau[5] = reactions.reaction_joint_6_wx * wrench_link_6_mx
        + reactions.reaction_joint_6_wy * wrench_link_6_my
        + reactions.reaction_joint_6_wz * wrench_link_6_mz
        + reactions.reaction_joint_6_vx * wrench_link_6_fx
        + reactions.reaction_joint_6_vy * wrench_link_6_fy
        + reactions.reaction_joint_6_vz * wrench_link_6_fz
        - (screws.connection_joint_6_wx * wrench_outside_link_6_mx
            + screws.connection_joint_6_wy * wrench_outside_link_6_my
            + screws.connection_joint_6_wz * wrench_outside_link_6_mz
            + screws.connection_joint_6_vx * wrench_outside_link_6_fx
            + screws.connection_joint_6_vy * wrench_outside_link_6_fy
            + screws.connection_joint_6_vz * wrench_outside_link_6_fz)
        + (screws.connection_joint_6_wx * base_wrench_0_0
            + screws.connection_joint_6_wy * base_wrench_1_0
            + screws.connection_joint_6_wz * base_wrench_2_0
            + screws.connection_joint_6_vx * base_wrench_1_1
            + screws.connection_joint_6_vy * base_wrench_0_3
            + screws.connection_joint_6_vz * base_wrench_0_1) + 0.0;
    let wrench_outside_link_7_mx = wrench_link_6_mx_0 + wrench_outside_link_6_mx;
    let wrench_outside_link_7_my = wrench_link_6_my_0 + wrench_outside_link_6_my;
    let wrench_outside_link_7_mz = wrench_link_6_mz_0 + wrench_outside_link_6_mz;
    let wrench_outside_link_7_fx = wrench_link_6_fx_0 + wrench_outside_link_6_fx;
    let wrench_outside_link_7_fy = wrench_link_6_fy_0 + wrench_outside_link_6_fy;
    let wrench_outside_link_7_fz = wrench_link_6_fz_0 + wrench_outside_link_6_fz;
    tau[6] = reactions.reaction_joint_7_wx * wrench_link_7_mx
        + reactions.reaction_joint_7_wy * wrench_link_7_my
        + reactions.reaction_joint_7_wz * wrench_link_7_mz
        + reactions.reaction_joint_7_vx * wrench_link_7_fx
        + reactions.reaction_joint_7_vy * wrench_link_7_fy
        + reactions.reaction_joint_7_vz * wrench_link_7_fz
        - (screws.connection_joint_7_wx * wrench_outside_link_7_mx
            + screws.connection_joint_7_wy * wrench_outside_link_7_my
            + screws.connection_joint_7_wz * wrench_outside_link_7_mz
            + screws.connection_joint_7_vx * wrench_outside_link_7_fx
            + screws.connection_joint_7_vy * wrench_outside_link_7_fy
            + screws.connection_joint_7_vz * wrench_outside_link_7_fz)
        + (screws.connection_joint_7_wx * base_wrench_0_0
            + screws.connection_joint_7_wy * base_wrench_1_0
            + screws.connection_joint_7_wz * base_wrench_2_0
            + screws.connection_joint_7_vx * base_wrench_1_1
            + screws.connection_joint_7_vy * base_wrench_0_3
            + screws.connection_joint_7_vz * base_wrench_0_1) + 0.0;
}
/// Where a link is, and how the joints move it at zero momentum.
///
/// - `q`: shape (7; rad, m)
/// - `pose`: g_k = [R p], rotation and position of the link in the base frame (3×4, by columns; m)
/// - `generalized_jacobian`: J̃_k = J_k − X_k A_l, body Jacobian of the link at zero momentum, link frame (6×7, by columns; rad, m)
///
/// 1766 operations: 824 + −, 939 ×, 3 ÷; 7 sin cos; about 21.0 KiB of code.
pub fn kinematics_link_7(
    q: &[f64; 7],
    pose: &mut [[f64; 3]; 4],
    generalized_jacobian: &mut [[f64; 6]; 7],
) {
    let poses = poses(q);
    let inertias = inertias(&poses);
    let complements = complements(&poses, &inertias);
    let screws = screws(&poses, &inertias, &complements);
    let outside = outside(&poses, &inertias, &complements, &screws);
    let reactions = reactions(&inertias, &outside);
    // g_k = [R p] column 0
    pose[0][0] = poses.rotation_link_7_xx + 0.0;
    pose[0][1] = poses.rotation_link_7_yx + 0.0;
    pose[0][2] = poses.rotation_link_7_zx + 0.0;
    // g_k = [R p] column 1
    pose[1][0] = 0.0 - poses.minus_rotation_link_7_xy;
    pose[1][1] = poses.rotation_link_7_yy + 0.0;
    pose[1][2] = 0.0 - poses.minus_rotation_link_7_zy;
    // g_k = [R p] column 2
    pose[2][0] = 0.0 - poses.minus_rotation_link_6_xy;
    pose[2][1] = 0.0 - poses.minus_rotation_link_6_yy;
    pose[2][2] = poses.rotation_link_6_zy + 0.0;
    // g_k = [R p] column 3
    pose[3][0] = poses.com_x - poses.minus_origin_link_7_x + 0.0;
    pose[3][1] = poses.com_y - poses.minus_origin_link_7_y + 0.0;
    pose[3][2] = poses.origin_link_7_z + poses.com_z + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_1
    generalized_jacobian[0][0] = poses.rotation_link_7_xx * reactions.reaction_joint_1_wx
        + poses.rotation_link_7_yx * reactions.reaction_joint_1_wy
        + poses.rotation_link_7_zx * reactions.reaction_joint_1_wz + 0.0;
    generalized_jacobian[0][1] = poses.rotation_link_7_yy * reactions.reaction_joint_1_wy
        - poses.minus_rotation_link_7_xy * reactions.reaction_joint_1_wx
        - poses.minus_rotation_link_7_zy * reactions.reaction_joint_1_wz + 0.0;
    generalized_jacobian[0][2] = poses.rotation_link_6_zy * reactions.reaction_joint_1_wz
        - (poses.minus_rotation_link_6_xy * reactions.reaction_joint_1_wx
            + poses.minus_rotation_link_6_yy * reactions.reaction_joint_1_wy) + 0.0;
    let generalized_jacobian_3_0_1 = reactions.reaction_joint_1_wy
        * poses.origin_link_7_z
        + reactions.reaction_joint_1_wz * poses.minus_origin_link_7_y;
    let generalized_jacobian_3_0_3 = reactions.reaction_joint_1_wz
        * poses.minus_origin_link_7_x
        + reactions.reaction_joint_1_wx * poses.origin_link_7_z;
    let generalized_jacobian_3_0_5 = reactions.reaction_joint_1_wy
        * poses.minus_origin_link_7_x
        - reactions.reaction_joint_1_wx * poses.minus_origin_link_7_y;
    generalized_jacobian[0][3] = poses.rotation_link_7_xx * generalized_jacobian_3_0_1
        - poses.rotation_link_7_yx * generalized_jacobian_3_0_3
        + poses.rotation_link_7_zx * generalized_jacobian_3_0_5 + 0.0;
    generalized_jacobian[0][4] = 0.0
        - (poses.minus_rotation_link_7_xy * generalized_jacobian_3_0_1
            + poses.rotation_link_7_yy * generalized_jacobian_3_0_3
            + poses.minus_rotation_link_7_zy * generalized_jacobian_3_0_5);
    generalized_jacobian[0][5] = poses.minus_rotation_link_6_yy
        * generalized_jacobian_3_0_3
        - poses.minus_rotation_link_6_xy * generalized_jacobian_3_0_1
        + poses.rotation_link_6_zy * generalized_jacobian_3_0_5 + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_2
    generalized_jacobian[1][0] = poses.rotation_link_7_xx * reactions.reaction_joint_2_wx
        + poses.rotation_link_7_yx * reactions.reaction_joint_2_wy
        + poses.rotation_link_7_zx * reactions.reaction_joint_2_wz + 0.0;
    generalized_jacobian[1][1] = poses.rotation_link_7_yy * reactions.reaction_joint_2_wy
        - poses.minus_rotation_link_7_xy * reactions.reaction_joint_2_wx
        - poses.minus_rotation_link_7_zy * reactions.reaction_joint_2_wz + 0.0;
    generalized_jacobian[1][2] = poses.rotation_link_6_zy * reactions.reaction_joint_2_wz
        - (poses.minus_rotation_link_6_xy * reactions.reaction_joint_2_wx
            + poses.minus_rotation_link_6_yy * reactions.reaction_joint_2_wy) + 0.0;
    let generalized_jacobian_3_1_1 = reactions.reaction_joint_2_vx
        + (reactions.reaction_joint_2_wy * poses.origin_link_7_z
            + reactions.reaction_joint_2_wz * poses.minus_origin_link_7_y);
    let generalized_jacobian_3_1_3 = reactions.reaction_joint_2_vy
        - (reactions.reaction_joint_2_wz * poses.minus_origin_link_7_x
            + reactions.reaction_joint_2_wx * poses.origin_link_7_z);
    let generalized_jacobian_3_1_5 = reactions.reaction_joint_2_vz
        + (reactions.reaction_joint_2_wy * poses.minus_origin_link_7_x
            - reactions.reaction_joint_2_wx * poses.minus_origin_link_7_y);
    generalized_jacobian[1][3] = poses.rotation_link_7_xx * generalized_jacobian_3_1_1
        + poses.rotation_link_7_yx * generalized_jacobian_3_1_3
        + poses.rotation_link_7_zx * generalized_jacobian_3_1_5 + 0.0;
    generalized_jacobian[1][4] = poses.rotation_link_7_yy * generalized_jacobian_3_1_3
        - poses.minus_rotation_link_7_xy * generalized_jacobian_3_1_1
        - poses.minus_rotation_link_7_zy * generalized_jacobian_3_1_5 + 0.0;
    generalized_jacobian[1][5] = poses.rotation_link_6_zy * generalized_jacobian_3_1_5
        - (poses.minus_rotation_link_6_xy * generalized_jacobian_3_1_1
            + poses.minus_rotation_link_6_yy * generalized_jacobian_3_1_3) + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_3
    generalized_jacobian[2][0] = poses.rotation_link_7_xx * reactions.reaction_joint_3_wx
        + poses.rotation_link_7_yx * reactions.reaction_joint_3_wy
        + poses.rotation_link_7_zx * reactions.reaction_joint_3_wz + 0.0;
    generalized_jacobian[2][1] = poses.rotation_link_7_yy * reactions.reaction_joint_3_wy
        - poses.minus_rotation_link_7_xy * reactions.reaction_joint_3_wx
        - poses.minus_rotation_link_7_zy * reactions.reaction_joint_3_wz + 0.0;
    generalized_jacobian[2][2] = poses.rotation_link_6_zy * reactions.reaction_joint_3_wz
        - (poses.minus_rotation_link_6_xy * reactions.reaction_joint_3_wx
            + poses.minus_rotation_link_6_yy * reactions.reaction_joint_3_wy) + 0.0;
    let generalized_jacobian_3_2_1 = reactions.reaction_joint_3_vx
        + (reactions.reaction_joint_3_wy * poses.origin_link_7_z
            + reactions.reaction_joint_3_wz * poses.minus_origin_link_7_y);
    let generalized_jacobian_3_2_3 = reactions.reaction_joint_3_vy
        - (reactions.reaction_joint_3_wz * poses.minus_origin_link_7_x
            + reactions.reaction_joint_3_wx * poses.origin_link_7_z);
    let generalized_jacobian_3_2_5 = reactions.reaction_joint_3_vz
        + (reactions.reaction_joint_3_wy * poses.minus_origin_link_7_x
            - reactions.reaction_joint_3_wx * poses.minus_origin_link_7_y);
    generalized_jacobian[2][3] = poses.rotation_link_7_xx * generalized_jacobian_3_2_1
        + poses.rotation_link_7_yx * generalized_jacobian_3_2_3
        + poses.rotation_link_7_zx * generalized_jacobian_3_2_5 + 0.0;
    generalized_jacobian[2][4] = poses.rotation_link_7_yy * generalized_jacobian_3_2_3
        - poses.minus_rotation_link_7_xy * generalized_jacobian_3_2_1
        - poses.minus_rotation_link_7_zy * generalized_jacobian_3_2_5 + 0.0;
    generalized_jacobian[2][5] = poses.rotation_link_6_zy * generalized_jacobian_3_2_5
        - (poses.minus_rotation_link_6_xy * generalized_jacobian_3_2_1
            + poses.minus_rotation_link_6_yy * generalized_jacobian_3_2_3) + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_4
    generalized_jacobian[3][0] = poses.rotation_link_7_xx * reactions.reaction_joint_4_wx
        + poses.rotation_link_7_yx * reactions.reaction_joint_4_wy
        + poses.rotation_link_7_zx * reactions.reaction_joint_4_wz + 0.0;
    generalized_jacobian[3][1] = poses.rotation_link_7_yy * reactions.reaction_joint_4_wy
        - poses.minus_rotation_link_7_xy * reactions.reaction_joint_4_wx
        - poses.minus_rotation_link_7_zy * reactions.reaction_joint_4_wz + 0.0;
    generalized_jacobian[3][2] = poses.rotation_link_6_zy * reactions.reaction_joint_4_wz
        - (poses.minus_rotation_link_6_xy * reactions.reaction_joint_4_wx
            + poses.minus_rotation_link_6_yy * reactions.reaction_joint_4_wy) + 0.0;
    let generalized_jacobian_3_3_1 = reactions.reaction_joint_4_vx
        + (reactions.reaction_joint_4_wy * poses.origin_link_7_z
            + reactions.reaction_joint_4_wz * poses.minus_origin_link_7_y);
    let generalized_jacobian_3_3_3 = reactions.reaction_joint_4_vy
        - (reactions.reaction_joint_4_wz * poses.minus_origin_link_7_x
            + reactions.reaction_joint_4_wx * poses.origin_link_7_z);
    let generalized_jacobian_3_3_5 = reactions.reaction_joint_4_wy
        * poses.minus_origin_link_7_x
        - reactions.reaction_joint_4_wx * poses.minus_origin_link_7_y
        - reactions.minus_reaction_joint_4_vz;
    generalized_jacobian[3][3] = poses.rotation_link_7_xx * generalized_jacobian_3_3_1
        + poses.rotation_link_7_yx * generalized_jacobian_3_3_3
        + poses.rotation_link_7_zx * generalized_jacobian_3_3_5 + 0.0;
    generalized_jacobian[3][4] = poses.rotation_link_7_yy * generalized_jacobian_3_3_3
        - poses.minus_rotation_link_7_xy * generalized_jacobian_3_3_1
        - poses.minus_rotation_link_7_zy * generalized_jacobian_3_3_5 + 0.0;
    generalized_jacobian[3][5] = poses.rotation_link_6_zy * generalized_jacobian_3_3_5
        - (poses.minus_rotation_link_6_xy * generalized_jacobian_3_3_1
            + poses.minus_rotation_link_6_yy * generalized_jacobian_3_3_3) + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_5
    generalized_jacobian[4][0] = poses.rotation_link_7_xx * reactions.reaction_joint_5_wx
        + poses.rotation_link_7_yx * reactions.reaction_joint_5_wy
        + poses.rotation_link_7_zx * reactions.reaction_joint_5_wz + 0.0;
    generalized_jacobian[4][1] = poses.rotation_link_7_yy * reactions.reaction_joint_5_wy
        - poses.minus_rotation_link_7_xy * reactions.reaction_joint_5_wx
        - poses.minus_rotation_link_7_zy * reactions.reaction_joint_5_wz + 0.0;
    generalized_jacobian[4][2] = poses.rotation_link_6_zy * reactions.reaction_joint_5_wz
        - (poses.minus_rotation_link_6_xy * reactions.reaction_joint_5_wx
            + poses.minus_rotation_link_6_yy * reactions.reaction_joint_5_wy) + 0.0;
    let generalized_jacobian_3_4_1 = reactions.reaction_joint_5_vx
        + (reactions.reaction_joint_5_wy * poses.origin_link_7_z
            + reactions.reaction_joint_5_wz * poses.minus_origin_link_7_y);
    let generalized_jacobian_3_4_3 = reactions.reaction_joint_5_vy
        - (reactions.reaction_joint_5_wz * poses.minus_origin_link_7_x
            + reactions.reaction_joint_5_wx * poses.origin_link_7_z);
    let generalized_jacobian_3_4_5 = reactions.reaction_joint_5_vz
        + (reactions.reaction_joint_5_wy * poses.minus_origin_link_7_x
            - reactions.reaction_joint_5_wx * poses.minus_origin_link_7_y);
    generalized_jacobian[4][3] = poses.rotation_link_7_xx * generalized_jacobian_3_4_1
        + poses.rotation_link_7_yx * generalized_jacobian_3_4_3
        + poses.rotation_link_7_zx * generalized_jacobian_3_4_5 + 0.0;
    generalized_jacobian[4][4] = poses.rotation_link_7_yy * generalized_jacobian_3_4_3
        - poses.minus_rotation_link_7_xy * generalized_jacobian_3_4_1
        - poses.minus_rotation_link_7_zy * generalized_jacobian_3_4_5 + 0.0;
    generalized_jacobian[4][5] = poses.rotation_link_6_zy * generalized_jacobian_3_4_5
        - (poses.minus_rotation_link_6_xy * generalized_jacobian_3_4_1
            + poses.minus_rotation_link_6_yy * generalized_jacobian_3_4_3) + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_6
    generalized_jacobian[5][0] = poses.rotation_link_7_xx * reactions.reaction_joint_6_wx
        + poses.rotation_link_7_yx * reactions.reaction_joint_6_wy
        + poses.rotation_link_7_zx * reactions.reaction_joint_6_wz + 0.0;
    generalized_jacobian[5][1] = poses.rotation_link_7_yy * reactions.reaction_joint_6_wy
        - poses.minus_rotation_link_7_xy * reactions.reaction_joint_6_wx
        - poses.minus_rotation_link_7_zy * reactions.reaction_joint_6_wz + 0.0;
    generalized_jacobian[5][2] = poses.rotation_link_6_zy * reactions.reaction_joint_6_wz
        - (poses.minus_rotation_link_6_xy * reactions.reaction_joint_6_wx
            + poses.minus_rotation_link_6_yy * reactions.reaction_joint_6_wy) + 0.0;
    let generalized_jacobian_3_5_1 = reactions.reaction_joint_6_vx
        + (reactions.reaction_joint_6_wy * poses.origin_link_7_z
            + reactions.reaction_joint_6_wz * poses.minus_origin_link_7_y);
    let generalized_jacobian_3_5_3 = reactions.reaction_joint_6_vy
        - (reactions.reaction_joint_6_wz * poses.minus_origin_link_7_x
            + reactions.reaction_joint_6_wx * poses.origin_link_7_z);
    let generalized_jacobian_3_5_5 = reactions.reaction_joint_6_vz
        + (reactions.reaction_joint_6_wy * poses.minus_origin_link_7_x
            - reactions.reaction_joint_6_wx * poses.minus_origin_link_7_y);
    generalized_jacobian[5][3] = poses.rotation_link_7_xx * generalized_jacobian_3_5_1
        + poses.rotation_link_7_yx * generalized_jacobian_3_5_3
        + poses.rotation_link_7_zx * generalized_jacobian_3_5_5 + 0.0;
    generalized_jacobian[5][4] = poses.rotation_link_7_yy * generalized_jacobian_3_5_3
        - poses.minus_rotation_link_7_xy * generalized_jacobian_3_5_1
        - poses.minus_rotation_link_7_zy * generalized_jacobian_3_5_5 + 0.0;
    generalized_jacobian[5][5] = poses.rotation_link_6_zy * generalized_jacobian_3_5_5
        - (poses.minus_rotation_link_6_xy * generalized_jacobian_3_5_1
            + poses.minus_rotation_link_6_yy * generalized_jacobian_3_5_3) + 0.0;
    // J\u{303}_k = J_k − X_k A_l column joint_7
    generalized_jacobian[6][0] = poses.rotation_link_7_xx * reactions.reaction_joint_7_wx
        + poses.rotation_link_7_yx * reactions.reaction_joint_7_wy
        + poses.rotation_link_7_zx * reactions.reaction_joint_7_wz + 0.0;
    generalized_jacobian[6][1] = poses.rotation_link_7_yy * reactions.reaction_joint_7_wy
        - poses.minus_rotation_link_7_xy * reactions.reaction_joint_7_wx
        - poses.minus_rotation_link_7_zy * reactions.reaction_joint_7_wz + 0.0;
    generalized_jacobian[6][2] = poses.rotation_link_6_zy * reactions.reaction_joint_7_wz
        - (poses.minus_rotation_link_6_xy * reactions.reaction_joint_7_wx
            + poses.minus_rotation_link_6_yy * reactions.reaction_joint_7_wy) + 0.0;
    let generalized_jacobian_3_6_1 = reactions.reaction_joint_7_vx
        + (reactions.reaction_joint_7_wy * poses.origin_link_7_z
            + reactions.reaction_joint_7_wz * poses.minus_origin_link_7_y);
    let generalized_jacobian_3_6_3 = reactions.reaction_joint_7_vy
        - (reactions.reaction_joint_7_wz * poses.minus_origin_link_7_x
            + reactions.reaction_joint_7_wx * poses.origin_link_7_z);
    let generalized_jacobian_3_6_5 = reactions.reaction_joint_7_vz
        + (reactions.reaction_joint_7_wy * poses.minus_origin_link_7_x
            - reactions.reaction_joint_7_wx * poses.minus_origin_link_7_y);
    generalized_jacobian[6][3] = poses.rotation_link_7_xx * generalized_jacobian_3_6_1
        + poses.rotation_link_7_yx * generalized_jacobian_3_6_3
        + poses.rotation_link_7_zx * generalized_jacobian_3_6_5 + 0.0;
    generalized_jacobian[6][4] = poses.rotation_link_7_yy * generalized_jacobian_3_6_3
        - poses.minus_rotation_link_7_xy * generalized_jacobian_3_6_1
        - poses.minus_rotation_link_7_zy * generalized_jacobian_3_6_5 + 0.0;
    generalized_jacobian[6][5] = poses.rotation_link_6_zy * generalized_jacobian_3_6_5
        - (poses.minus_rotation_link_6_xy * generalized_jacobian_3_6_1
            + poses.minus_rotation_link_6_yy * generalized_jacobian_3_6_3) + 0.0;
}
