//! Every public quantity equals the sum over links that defines it.

use frs_core::Curvature;
use frs_core::spatial::{Pose, Twist, Wrench};
use nalgebra::{DVector, Matrix3, Matrix6xX, Vector1, Vector3, Vector6};
use proptest::prelude::*;

use crate::algebra::{adjoint, adjoint_inverse, coriolis};
use crate::asking::{six_by, square, twist, vector, wrench};
use crate::closeness::{ROUNDING, close};
use crate::specification::{Link, stack, unit};
use crate::trees::{case, config};

proptest! {
    #![proptest_config(config())]

    #[test]
    fn locked_inertia(case in case()) {
        case.judge(|spec, robot| {
            close(&robot.locked_inertia().to_matrix(), &spec.lambda_b, ROUNDING)?;
            let about_com = adjoint(&Matrix3::identity(), &robot.com());
            let rotational = (about_com.transpose() * spec.lambda_b * about_com).fixed_view::<3, 3>(0, 0).into_owned();
            close(&robot.locked_rotational_inertia().to_matrix(), &rotational, ROUNDING)?;
            // The pivots of LDLᵀ are the ratios of leading minors.
            let minor = |size: usize| rotational.view((0, 0), (size, size)).determinant();
            let inverse_pivots = Vector3::new(1.0 / minor(1), minor(1) / minor(2), minor(2) / minor(3));
            close(&robot.locked_inverse_pivots(), &inverse_pivots, ROUNDING)
        })?;
    }

    #[test]
    fn base_joint_inertia(case in case()) {
        case.judge(|spec, robot| {
            close(&six_by(spec.dof(), |out| robot.base_joint_inertia(out)), &spec.m_bq, ROUNDING)
        })?;
    }

    #[test]
    fn connection(case in case()) {
        case.judge(|spec, robot| {
            close(&six_by(spec.dof(), |out| robot.connection(out)), &spec.a, ROUNDING)
        })?;
    }

    #[test]
    fn shape_inertia(case in case()) {
        case.judge(|spec, robot| {
            let (n, expected) = (spec.dof(), spec.lambda_q());
            close(&square(n, |out| robot.shape_inertia(out)), &expected, ROUNDING)?;
            close(&square(n, |out| robot.shape_inertia_textbook(out)), &expected, ROUNDING)
        })?;
    }

    #[test]
    fn hamel_inertia(case in case()) {
        case.judge(|spec, robot| {
            let expected = spec.hamel_inertia();
            close(&square(6 + spec.dof(), |out| robot.hamel_inertia(out)), &expected, ROUNDING)
        })?;
    }

    #[test]
    fn inertia_velocity(case in case()) {
        case.judge(|spec, robot| {
            close(&robot.inertia_velocity(case.x.as_slice()), &spec.p(&case.x), ROUNDING)
        })?;
    }

    #[test]
    fn inertia_derivative(case in case()) {
        case.judge(|spec, robot| {
            let actual = six_by(spec.dof(), |out| robot.inertia_derivative(twist(&case.mu), out));
            close(&actual, &spec.s(&case.mu), ROUNDING)
        })?;
    }

    #[test]
    fn locked_coriolis(case in case()) {
        case.judge(|spec, robot| {
            close(&robot.locked_coriolis(twist(&case.mu)), &spec.c_b(&case.mu), ROUNDING)
        })?;
    }

    #[test]
    fn gamma_q(case in case()) {
        case.judge(|spec, robot| {
            let (n, expected) = (spec.dof(), spec.gamma_q());
            close(&square(n, |out| robot.gamma_q(out)), &expected, ROUNDING)?;
            close(&vector(n, |out| robot.gamma_q_rates(out)), &(expected * &case.qd), ROUNDING)
        })?;
    }

    #[test]
    fn b2(case in case()) {
        case.judge(|spec, robot| {
            let actual = square(spec.dof(), |out| robot.b2(twist(&case.mu), out));
            close(&actual, &spec.b2(&case.mu), ROUNDING)
        })?;
    }

    #[test]
    fn d_qdot(case in case()) {
        case.judge(|spec, robot| {
            let (size, expected) = (6 + spec.dof(), spec.d_qdot());
            close(&square(size, |out| robot.d_qdot(out)), &expected, ROUNDING)?;
            let along = vector(size, |out| robot.d_qdot_xi(twist(&case.mu), out));
            close(&along, &(expected * spec.xi(&case.mu)), ROUNDING)
        })?;
    }

    #[test]
    fn d_mu(case in case()) {
        case.judge(|spec, robot| {
            let (size, expected) = (6 + spec.dof(), spec.d_mu(&case.mu));
            close(&square(size, |out| robot.d_mu(twist(&case.mu), out)), &expected, ROUNDING)?;
            let along = vector(size, |out| robot.d_mu_xi(twist(&case.mu), out));
            close(&along, &(expected * spec.xi(&case.mu)), ROUNDING)
        })?;
    }

    #[test]
    fn coupling_torque(case in case()) {
        case.judge(|spec, robot| {
            let actual = vector(spec.dof(), |out| robot.coupling_torque(twist(&case.mu), out));
            close(&actual, &spec.coupling_torque(&case.mu), ROUNDING)
        })?;
    }

    #[test]
    fn curvature(case in case()) {
        case.judge(|spec, robot| {
            let n = spec.dof();
            let mut curvature = Curvature::new(n);
            robot.curvature(&mut curvature);
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let expected = spec.curvature(&unit(n, i), &unit(n, j));
                close(&curvature.get(i, j).to_vector(), &expected, ROUNDING)?;
            }
            let actual = robot.curvature_on(case.x.as_slice(), case.y.as_slice()).to_vector();
            close(&actual, &spec.curvature(&case.x, &case.y), ROUNDING)
        })?;
    }

    #[test]
    fn centre_of_mass(case in case()) {
        case.judge(|spec, robot| {
            let bodies = spec.links.iter().zip(&case.robot.links).map(|(k, link)| (&k.motion, link.inertial));
            let moment: Vector3<f64> =
                bodies.map(|(at, body)| (at.rotation * body.com + at.translation) * body.mass).sum();
            close(&robot.com(), &(moment / spec.lambda_b[(3, 3)]), ROUNDING)
        })?;
    }

    #[test]
    fn link_poses_and_jacobians(case in case()) {
        case.judge(|spec, robot| {
            for (k, link) in spec.links.iter().zip(&case.robot.links) {
                let number = robot.model().link(&link.name).expect("every link is in the model");
                let pose = robot.link_pose(number);
                close(&pose.rotation, &k.motion.rotation, ROUNDING)?;
                close(&pose.translation, &k.motion.translation, ROUNDING)?;
                close(&six_by(spec.dof(), |out| robot.link_jacobian(number, out)), &k.j, ROUNDING)?;
                let generalized = six_by(spec.dof(), |out| robot.generalized_jacobian(number, out));
                close(&generalized, &k.jt, ROUNDING)?;
            }
            Ok(())
        })?;
    }

    /// What the older form of the equations cancels, −Γ_bqᵀ μ, is −c(μ) + B_2(μ) q̇ with the coupling torque c.
    #[test]
    fn the_older_decoupling_torque(case in case()) {
        case.judge(|spec, robot| {
            let (n, mu) = (spec.dof(), twist(&case.mu));
            let mut expected = DVector::zeros(n);
            for k in &spec.links {
                let own = k.x * case.mu + &k.jt * &case.qd;
                expected += k.jt.transpose() * ((coriolis(&k.m, &own) * k.x + k.m * k.x_rate) * case.mu);
            }
            let b2 = square(n, |out| robot.b2(mu, out));
            let found = &b2 * &case.qd - vector(n, |out| robot.coupling_torque(mu, out));
            close(&found, &expected, ROUNDING)
        })?;
    }

    #[test]
    fn wrenches_on_links_do_the_work_of_links(case in case()) {
        case.judge(|spec, robot| {
            let mu = twist(&case.mu);
            let (base, wrench) = (robot.base_twist(mu), Wrench::from_array([0.7, -0.3, 0.5, 1.1, -0.8, 0.4]));
            for link in 0..robot.model().links().len() {
                let mut jacobian = Matrix6xX::zeros(spec.dof());
                robot.link_jacobian(link, &mut jacobian);
                let own = robot.link_pose(link).act_inverse(base).to_vector() + &jacobian * &case.qd;
                close(&robot.link_twist(link, mu).to_vector(), &own, ROUNDING)?;
                let mut tau = vec![0.0; spec.dof()];
                let on_base = robot.add_link_wrench(link, wrench, &mut tau);
                let power = base.dot(on_base) + DVector::from_vec(tau).dot(&case.qd);
                let expected = own.dot(&wrench.to_vector());
                let size = own.norm() + 1.0;
                close(&Vector1::new(power / size), &Vector1::new(expected / size), ROUNDING)?;
            }
            Ok(())
        })?;
    }

    /// `V̇_k = X_k μ̇ + Ẋ_k μ + J̃_k q̈ + dJ̃_k/dt q̇`.
    #[test]
    fn link_accelerations(case in case()) {
        case.judge(|spec, robot| {
            // Any acceleration will do: [v₁; y].
            let xi_rate = stack(&case.v1, &case.y);
            let number = |name: &str| robot.model().link(name).expect("every link is in the model");
            let links: Vec<usize> = case.robot.links.iter().map(|link| number(&link.name)).collect();
            let mut found = vec![Twist::from_array([f64::NAN; 6]); links.len()];
            robot.link_accelerations(twist(&case.mu), xi_rate.as_slice(), &links, &mut found);
            for (own, found) in spec.links.iter().zip(found) {
                let turning = own.x_rate * case.mu + &own.jt_rate * &case.qd;
                let expected = own.x * case.v1 + &own.jt * &case.y + turning;
                close(&found.to_vector(), &expected, ROUNDING)?;
            }
            Ok(())
        })?;
    }

    #[test]
    fn velocities_and_momenta(case in case()) {
        case.judge(|spec, robot| {
            let (mu, moved) = (twist(&case.mu), &spec.a * &case.qd);
            let moved = Vector6::from_column_slice(moved.as_slice());
            close(&robot.locked_velocity(mu).to_vector(), &(case.mu + moved), ROUNDING)?;
            close(&robot.base_twist(mu).to_vector(), &(case.mu - moved), ROUNDING)?;

            let momentum = spec.lambda_b * case.mu;
            close(&robot.body_momentum(mu).to_vector(), &momentum, ROUNDING)?;
            // In a frame in which the base has pose g, the momentum h of the base frame is Ad_g⁻ᵀ h.
            let seen = |pose: &Pose<f64>| adjoint_inverse(&pose.rotation, &pose.translation).transpose() * momentum;
            close(&robot.spatial_momentum(&case.pose, mu).to_vector(), &seen(&case.pose), ROUNDING)?;
            let centroidal = Pose::new(Matrix3::identity(), -robot.com());
            close(&robot.centroidal_momentum(mu).to_vector(), &seen(&centroidal), ROUNDING)
        })?;
    }

    #[test]
    fn kinetic_energy(case in case()) {
        case.judge(|spec, robot| {
            let v1 = case.mu - (&spec.a * &case.qd);
            let of_link = |k: &Link| {
                let velocity = k.x * v1 + (&k.j * &case.qd);
                0.5 * velocity.dot(&(k.m * velocity))
            };
            let expected: f64 = spec.links.iter().map(of_link).sum();
            let actual = robot.kinetic_energy(twist(&case.mu));
            close(&Vector1::new(actual), &Vector1::new(expected), ROUNDING)
        })?;
    }

    #[test]
    fn hamel_coriolis(case in case()) {
        case.judge(|spec, robot| {
            let (size, expected) = (6 + spec.dof(), spec.hamel_coriolis(&case.v1));
            close(&square(size, |out| robot.hamel_coriolis(twist(&case.v1), out)), &expected, ROUNDING)?;
            let velocity = stack(&case.v1, &case.qd);
            let bias = expected * velocity;
            close(&vector(size, |out| robot.hamel_bias(twist(&case.v1), out)), &bias, ROUNDING)
        })?;
    }

    #[test]
    fn forward_dynamics(case in case()) {
        case.judge(|spec, robot| {
            let (mu, force, tau) = (twist(&case.mu), wrench(&case.wrench), case.tau.as_slice());
            let expected = spec.forward_dynamics(&case.mu, &case.wrench, &case.tau);
            let tolerance = ROUNDING * spec.shape_condition();
            let factored = vector(expected.len(), |out| robot.forward_dynamics(mu, force, tau, out));
            close(&factored, &expected, tolerance)?;
            let swept = vector(expected.len(), |out| robot.forward_dynamics_articulated(mu, force, tau, out));
            close(&swept, &expected, tolerance)
        })?;
    }

    #[test]
    fn inverse_dynamics(case in case()) {
        case.judge(|spec, robot| {
            // Any acceleration will do: [v₁; y].
            let xi_rate = stack(&case.v1, &case.y);
            let expected = spec.lambda() * &xi_rate + (spec.d_qdot() - spec.d_mu(&case.mu)) * spec.xi(&case.mu);
            let mut tau = vec![f64::NAN; spec.dof()];
            let force = robot.inverse_dynamics(twist(&case.mu), xi_rate.as_slice(), &mut tau).to_vector();
            let actual = spec.force(&force, &DVector::from_vec(tau));
            close(&actual, &expected, ROUNDING)
        })?;
    }
}
