//! The specification judged by itself: what it differentiates by hand agrees with differences of what it does not.

use nalgebra::{DVector, Matrix3, Vector3};
use proptest::prelude::*;

use crate::algebra::{ad, coriolis};
use crate::asking::coordinates;
use crate::closeness::{Around, DIFFERENCES, ROUNDING, close, derivative};
use crate::specification::Specification;
use crate::trees::{Case, case, config};

proptest! {
    #![proptest_config(config())]

    #[test]
    fn jacobians_are_rates_of_poses(case in case()) {
        let (spec, around) = (along(&case, &case.qd)(0.0), Around::zero(along(&case, &case.qd)));
        for (k, link) in spec.links.iter().enumerate() {
            let velocity = &link.j * &case.qd;
            let back: Matrix3<f64> = link.motion.rotation.transpose();
            let turning = back * around.rate(|at| at.links[k].motion.rotation);
            let moving = back * around.rate(|at| at.links[k].motion.translation);
            let angular: Vector3<f64> = velocity.fixed_rows::<3>(0).into_owned();
            close(&turning, &angular.cross_matrix(), DIFFERENCES)?;
            close(&moving, &velocity.fixed_rows::<3>(3), DIFFERENCES)?;
        }
    }

    #[test]
    fn rates_of_jacobians_and_connection_are_their_derivatives(case in case()) {
        let (spec, around) = (along(&case, &case.qd)(0.0), Around::zero(along(&case, &case.qd)));
        for (k, link) in spec.links.iter().enumerate() {
            close(&link.j_rate, &around.rate(|at| at.links[k].j.clone()), DIFFERENCES)?;
            close(&link.x_rate, &around.rate(|at| at.links[k].x), DIFFERENCES)?;
            close(&link.jt_rate, &around.rate(|at| at.links[k].jt.clone()), DIFFERENCES)?;
        }
        close(&spec.a_rate, &around.rate(|at| at.a.clone()), DIFFERENCES)?;
        close(&spec.p(&case.qd), &around.rate(|at| at.lambda_b), DIFFERENCES)?;
    }

    /// 𝓑(x, y) = ∂_x A_y − ∂_y A_x − [A_x, A_y]: the formula without derivatives has this sign.
    #[test]
    fn curvature_is_the_curl_of_the_connection_less_the_bracket(case in case()) {
        let spec = along(&case, &case.qd)(0.0);
        let partial = |direction: &DVector<f64>| derivative(|h| along(&case, direction)(h).a);
        let (x, y) = ((&spec.a * &case.x), (&spec.a * &case.y));
        let expected = (&partial(&case.x) * &case.y) - (&partial(&case.y) * &case.x) - ad(&x) * y;
        close(&spec.curvature(&case.x, &case.y), &expected, DIFFERENCES)?;
    }

    /// C(I; X) is skew and C(I; X)X = −ad_Xᵀ I X, the bias of Euler's equations.
    #[test]
    fn coriolis_is_the_skew_factor_of_eulers_bias(case in case()) {
        let spec = along(&case, &case.qd)(0.0);
        for link in &spec.links {
            let c = coriolis(&link.m, &case.mu);
            close(&c, &-c.transpose(), ROUNDING)?;
            close(&(c * case.mu), &(-ad(&case.mu).transpose() * link.m * case.mu), ROUNDING)?;
        }
    }
}

/// The case's specification at q + h·direction, rates unchanged.
fn along(case: &Case, direction: &DVector<f64>) -> impl Fn(f64) -> Specification {
    let names = coordinates(&case.model());
    move |h| Specification::new(&case.robot, &names, &(&case.q + direction * h), &case.qd)
}
