//! The smallest robot and a large one.

use frs_core::Curvature;
use frs_core::model::RobotDescription;
use nalgebra::DVector;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use crate::asking::{six_by, square, twist, vector, wrench};
use crate::closeness::{ROUNDING, close};
use crate::trees::{Case, case, case_with, config};

/// Joints of a large robot.
const MANY: usize = 200;

/// Rounding where lever arms are tens of metres long and Λ_b is a millionth as stiff about one axis as about another.
const LARGE_ROUNDING: f64 = 1e-10;

/// How many large robots are tried: the sums over links take a second for each.
const LARGE_CASES: u32 = 2;

proptest! {
    #![proptest_config(config())]

    /// A rigid body: Euler's equations Λ_b μ̇ = ad_μᵀ Λ_b μ + F₁.
    #[test]
    fn a_body_without_joints_obeys_eulers_equations(case in case()) {
        let Case { robot, mu, v1, wrench: force, pose, .. } = case;
        let robot = RobotDescription { joints: Vec::new(), links: robot.links[..1].to_vec(), ..robot };
        let [q, qd, x, y, tau] = std::array::from_fn(|_| DVector::zeros(0));
        let case = Case { robot, q, qd, x, y, tau, mu, v1, wrench: force, pose };
        case.judge(|spec, robot| {
            prop_assert_eq!(spec.dof(), 0);
            let mu = twist(&case.mu);
            let mu_rate = vector(6, |out| robot.forward_dynamics(mu, wrench(&case.wrench), &[], out));
            let turning = mu.ad_transpose(robot.body_momentum(mu)).to_vector();
            close(&(spec.lambda_b * &mu_rate), &(turning + case.wrench), ROUNDING)?;
            let swept = vector(6, |out| robot.forward_dynamics_articulated(mu, wrench(&case.wrench), &[], out));
            close(&swept, &mu_rate, ROUNDING)?;
            let force = robot.inverse_dynamics(mu, mu_rate.as_slice(), &mut []).to_vector();
            close(&force, &case.wrench, ROUNDING)?;
            close(&square(6, |out| robot.d_mu(mu, out)), &spec.d_mu(&case.mu), ROUNDING)?;
            close(&square(6, |out| robot.d_qdot(out)), &spec.d_qdot(), ROUNDING)?;
            close(&square(6, |out| robot.hamel_coriolis(mu, out)), &spec.hamel_coriolis(&case.mu), ROUNDING)?;
            close(&square(0, |out| robot.gamma_q(out)), &spec.gamma_q(), ROUNDING)?;
            close(&square(0, |out| robot.b2(mu, out)), &spec.b2(&case.mu), ROUNDING)?;
            robot.curvature(&mut Curvature::new(0));
            Ok(())
        })?;
    }
}

#[test]
fn robots_of_two_hundred_joints_are_specified_alike() {
    let mut random = TestRunner::deterministic();
    for _ in 0..LARGE_CASES {
        let case = case_with(MANY, false).new_tree(&mut random).expect("every tree is a case").current();
        case.judge(|spec, robot| {
            let (n, mu) = (spec.dof(), twist(&case.mu));
            let a = six_by(n, |out| robot.connection(out));
            close(&a, &spec.a, LARGE_ROUNDING)?;
            close(&square(n, |out| robot.shape_inertia(out)), &spec.lambda_q(), LARGE_ROUNDING)?;
            close(&square(n, |out| robot.gamma_q(out)), &spec.gamma_q(), LARGE_ROUNDING)?;
            close(&square(n, |out| robot.b2(mu, out)), &spec.b2(&case.mu), LARGE_ROUNDING)?;
            let curvature = robot.curvature_on(case.x.as_slice(), case.y.as_slice()).to_vector();
            close(&curvature, &spec.curvature(&case.x, &case.y), LARGE_ROUNDING)?;
            // Λ_q is too badly conditioned to compare accelerations: they are judged by the forces they need.
            let (lambda, expected) = (spec.lambda(), spec.driving_force(&case.mu, &case.wrench, &case.tau));
            let (force, tau) = (wrench(&case.wrench), case.tau.as_slice());
            let factored = vector(6 + n, |out| robot.forward_dynamics(mu, force, tau, out));
            close(&(&lambda * &factored), &expected, LARGE_ROUNDING * factored.amax())?;
            let swept = vector(6 + n, |out| robot.forward_dynamics_articulated(mu, force, tau, out));
            close(&(lambda * &swept), &expected, LARGE_ROUNDING * swept.amax())
        })
        .expect("the core and the sums over links agree");
    }
}
