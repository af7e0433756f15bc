//! The exponentials of SO(3) and SE(3), their logarithms and tangents, against power series in extended precision.
//!
//! Errors are counted in units of the type's `EPSILON` times the natural scale of a result: the largest entry of the
//! exact vector, matrix or 3×3 block. `-- --nocapture` prints the worst of each function.

mod extended;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use extended::exact::{self, largest};
use extended::judge::{Judged, Random, Worst, big, block, matrix, twist, twists};
use extended::{Big, Wide};
use frs_core::derivatives::Dual;
use frs_core::spatial::{Pose, Twist, so3};
use nalgebra::{Matrix3, Matrix4, Vector3, Vector6};

/// What every function keeps.
const ULPS: f64 = 4.0;
/// What two functions in a row, or one and the rounding of what it is given, keep.
const PRODUCT_ULPS: f64 = 2.0 * ULPS;

/// Up to π: zero and subnormal; squares that underflow in `f64`, in `f32`; squares that vanish against 1; both sides of
/// θ² = 10⁻¹⁶, of tan² ½θ = 10⁻¹⁷ and of θ² = 4, where the forms change.
const ANGLES: [f64; 29] = [
    0.0,
    5e-324,
    3e-310,
    1e-300,
    1e-160,
    1e-40,
    1e-25,
    1e-20,
    6.324e-9,
    6.325e-9,
    9.999e-9,
    1.001e-8,
    1e-6,
    1e-4,
    1e-2,
    0.1,
    0.5,
    1.0,
    1.5,
    2.0 - 1e-6,
    2.0 + 1e-6,
    2.5,
    3.0,
    PI - 1e-3,
    PI - 1e-6,
    PI - 1e-8,
    PI - 1e-12,
    PI - 1e-15,
    PI,
];

fn judge_exp<T: Judged>() {
    let [mut rotation, mut translation] = ["exp, R", "exp, p"].map(Worst::of);
    for (angle, zeta) in twists::<T>(&ANGLES) {
        let (r, p) = exact::exp(zeta.to_array().map(T::big));
        let got = Pose::exp(zeta);
        rotation.see(angle, got.rotation, &r);
        translation.see(angle, got.translation, &p);
    }
    rotation.keeps::<T>(ULPS);
    translation.keeps::<T>(ULPS);
}

#[test]
fn exp_is_the_matrix_exponential() {
    judge_exp::<f64>();
    judge_exp::<f32>();
    judge_exp::<Wide>();
}

/// Beyond π the rounding of θ = |φ|, relative to θ, is an error of the angle.
#[test]
fn exp_of_many_turns_errs_by_the_rounding_of_the_angle() {
    for angle in [4.0, 5.0, TAU - 1e-8, TAU, TAU + 1e-8, 7.0, 30.0, 1e3, 1e8] {
        let [mut rotation, mut translation] = ["exp of many turns, R", "exp of many turns, p"].map(Worst::of);
        for (angle, zeta) in twists::<f64>(&[angle]) {
            let (r, p) = exact::exp(zeta.to_array().map(Big::new));
            let got = Pose::exp(zeta);
            rotation.see(angle, got.rotation, &r);
            // At 2π a p across the axis is zero.
            translation.see_at_scale(angle, got.translation, &p, largest(&big(zeta.linear)));
        }
        rotation.keeps::<f64>(ULPS * angle / PI);
        translation.keeps::<f64>(ULPS);
    }
}

/// At 2π dexp is singular, but its entries are as good as anywhere.
#[test]
fn dexp_of_many_turns_errs_by_the_rounding_of_the_angle() {
    for angle in [5.0, TAU - 1e-8, TAU, TAU + 1e-8, 7.0, 30.0] {
        let mut worst = Worst::of("dexp of many turns");
        for (angle, zeta) in twists::<f64>(&[angle]) {
            let exact = exact::exponential_series(&big(zeta.ad_matrix()), 1);
            worst.see(angle, matrix(|w| zeta.dexp(w)), &exact);
        }
        worst.keeps::<f64>(ULPS * angle / PI);
    }
}

fn judge_log<T: Judged>() {
    let [mut angular, mut linear] = ["log, φ", "log, ρ"].map(Worst::of);
    for (angle, zeta) in twists::<T>(&ANGLES) {
        let (r, p) = exact::exp(zeta.to_array().map(T::big));
        let pose = Pose::new(r.map(|e| T::nearest(&e)), p.map(|e| T::nearest(&e)));
        let got = pose.log();
        let phi = exact::log(&big(pose.rotation), &big(got.angular));
        let j = exact::exponential_series(&exact::cross(&phi), 1);
        angular.see(angle, got.angular, &phi);
        linear.see(angle, got.linear, &(exact::inverse(&j) * big(pose.translation)));
    }
    angular.keeps::<T>(ULPS);
    linear.keeps::<T>(ULPS);
}

#[test]
fn log_undoes_the_matrix_exponential() {
    judge_log::<f64>();
    judge_log::<f32>();
    judge_log::<Wide>();
}

fn judge_dexp<T: Judged>() {
    let mut worst = ["dexp, J", "dexp, Q", "dexp⁻¹, J⁻¹", "dexp⁻¹, −J⁻¹QJ⁻¹"].map(Worst::of);
    for (angle, zeta) in twists::<T>(&[&ANGLES[..], &[3.5, 4.0]].concat()) {
        let exact = exact::exponential_series(&big(zeta.ad_matrix()), 1);
        let (j, q) = (block(&exact, 0, 0), block(&exact, 3, 0));
        let j_inverse = exact::inverse(&j);
        let (forward, backward) = (matrix(|w| zeta.dexp(w)), matrix(|w| zeta.dexp_inverse(w)));
        worst[0].see(angle, block(&forward, 0, 0), &j);
        worst[0].see(angle, block(&forward, 3, 3), &j);
        worst[1].see(angle, block(&forward, 3, 0), &q);
        worst[2].see(angle, block(&backward, 0, 0), &j_inverse);
        worst[2].see(angle, block(&backward, 3, 3), &j_inverse);
        worst[3].see(angle, block(&backward, 3, 0), &-(&j_inverse * q * &j_inverse));
        for upper in [block(&forward, 0, 3), block(&backward, 0, 3)] {
            assert_eq!(upper, Matrix3::zeros());
        }
    }
    for worst in worst {
        worst.keeps::<T>(ULPS);
    }
}

#[test]
fn dexp_and_its_inverse_are_series_in_ad() {
    judge_dexp::<f64>();
    judge_dexp::<f32>();
    judge_dexp::<Wide>();
}

/// d/dt exp(ζ + tη) = (dexp_ζ η)^ exp ζ = exp ζ (dexp_{−ζ} η)^, by a central difference whose own error is 10⁻⁴⁰.
#[test]
fn dexp_is_the_tangent_of_exp() {
    let step = Big::new(2.0_f64.powi(-70));
    let mut random = Random(2);
    let [mut space, mut body] = ["dexp as a tangent, left", "dexp as a tangent, right"].map(Worst::of);
    for (angle, zeta) in twists::<f64>(&[0.0, 1e-4, 0.5, 1.9, 2.1, 3.0]) {
        let eta = twist::<f64>(random.vector(), random.vector());
        let (at, along) =
            (exact::hat(zeta.to_array().map(Big::new)), exact::hat(eta.to_array().map(Big::new)) * step.clone());
        let rate =
            (exact::exponential(&(&at + &along)) - exact::exponential(&(&at - &along))) / (step.clone() + step.clone());
        let back = exact::exponential(&-at);
        // The entries of dexp times η, whose sum may be small.
        let scale = (Big::new(1.0) + largest(&big(zeta.to_vector()))) * largest(&big(eta.to_vector()));
        let vee = |rate: Matrix4<Big>| {
            Vector6::from([(2, 1), (0, 2), (1, 0), (0, 3), (1, 3), (2, 3)].map(|entry| rate[entry].clone()))
        };
        space.see_at_scale(angle, zeta.dexp(eta).to_vector(), &vee(&rate * &back), scale.clone());
        body.see_at_scale(angle, (-zeta).dexp(eta).to_vector(), &vee(&back * &rate), scale);
    }
    space.keeps::<f64>(ULPS);
    body.keeps::<f64>(ULPS);
}

#[test]
fn dexp_and_its_inverse_make_one() {
    let mut one = Worst::of("dexp dexp⁻¹ = 1");
    for (angle, zeta) in twists::<f64>(&ANGLES) {
        let exact = Matrix3::identity();
        for product in [matrix(|w| zeta.dexp(zeta.dexp_inverse(w))), matrix(|w| zeta.dexp_inverse(zeta.dexp(w)))] {
            one.see(angle, block(&product, 0, 0), &exact);
            one.see_at_scale(angle, block(&product, 3, 0), &Matrix3::zeros(), largest(&big(zeta.linear)));
        }
    }
    one.keeps::<f64>(PRODUCT_ULPS);
}

#[test]
fn adjoint_of_exp_is_exp_of_ad() {
    let [mut diagonal, mut lower] = ["Ad exp, R", "Ad exp, p×R"].map(Worst::of);
    for (angle, zeta) in twists::<f64>(&ANGLES) {
        let exact = exact::exponential(&big(zeta.ad_matrix()));
        let got = Pose::exp(zeta).adjoint();
        diagonal.see(angle, block(&got, 3, 3), &block(&exact, 3, 3));
        lower.see(angle, block(&got, 3, 0), &block(&exact, 3, 0));
    }
    diagonal.keeps::<f64>(ULPS);
    lower.keeps::<f64>(PRODUCT_ULPS);
}

#[test]
fn dexp_forwards_is_the_adjoint_of_dexp_backwards() {
    let [mut diagonal, mut lower] = ["dexp_ζ = Ad dexp_{−ζ}, J", "dexp_ζ = Ad dexp_{−ζ}, Q"].map(Worst::of);
    for (angle, zeta) in twists::<f64>(&ANGLES) {
        let pose = Pose::exp(zeta);
        let (space, moved) = (matrix(|w| zeta.dexp(w)), matrix(|w| pose.act((-zeta).dexp(w))));
        diagonal.see(angle, block(&moved, 0, 0), &big(block(&space, 0, 0)));
        lower.see_at_scale(angle, block(&moved, 3, 0), &big(block(&space, 3, 0)), largest(&big(zeta.linear)));
    }
    diagonal.keeps::<f64>(PRODUCT_ULPS);
    lower.keeps::<f64>(PRODUCT_ULPS);
}

#[test]
fn exp_and_log_invert_each_other_on_random_poses() {
    let mut random = Random(4);
    let [mut poses, mut twists] = ["exp log = 1", "log exp = 1"].map(Worst::of);
    for _ in 0..5000 {
        let angles = [random.number() * PI, random.number() * FRAC_PI_2, random.number() * PI];
        let pose = Pose::from_rpy(random.vector(), angles);
        let zeta = pose.log();
        let (again, zeta_again) = (Pose::exp(zeta), Pose::exp(zeta).log());
        let angle = zeta.angular.norm();
        poses.see(angle, again.rotation, &big(pose.rotation));
        poses.see(angle, again.translation, &big(pose.translation));
        twists.see(angle, zeta_again.angular, &big(zeta.angular));
        twists.see(angle, zeta_again.linear, &big(zeta.linear));
    }
    poses.keeps::<f64>(PRODUCT_ULPS);
    twists.keeps::<f64>(PRODUCT_ULPS);
}

/// Both sides of every select are differentiated too, and the one not taken must stay out.
#[test]
fn dual_numbers_differentiate_exp_and_log() {
    let mut random = Random(5);
    let [mut exp, mut log] = ["d exp = dexp", "d log d exp = 1"].map(Worst::of);
    for (angle, zeta) in twists::<f64>(&ANGLES) {
        let eta = twist::<f64>(random.vector(), random.vector());
        let dual = |value: Vector3<f64>, rate: Vector3<f64>| value.zip_map(&rate, Dual::new);
        let pose = Pose::exp(Twist::new(dual(zeta.angular, eta.angular), dual(zeta.linear, eta.linear)));
        let (r, p) = (pose.rotation, pose.translation);
        // (Ṙ, ṗ) = (ω× R, ω × p + v) of the left velocity.
        let velocity = zeta.dexp(eta);
        let rate = velocity.angular.cross_matrix() * r.map(|e| e.value);
        let scale = (Big::new(1.0) + largest(&big(zeta.to_vector()))) * largest(&big(eta.to_vector()));
        exp.see_at_scale(angle, r.map(|e| e.derivative), &big(rate), scale.clone());
        let rate = velocity.angular.cross(&p.map(|e| e.value)) + velocity.linear;
        exp.see_at_scale(angle, p.map(|e| e.derivative), &big(rate), scale.clone());
        if angle < 3.0 {
            let again = pose.log();
            log.see_at_scale(angle, again.angular.map(|e| e.derivative), &big(eta.angular), scale.clone());
            log.see_at_scale(angle, again.linear.map(|e| e.derivative), &big(eta.linear), scale);
        }
    }
    exp.keeps::<f64>(PRODUCT_ULPS);
    log.keeps::<f64>(PRODUCT_ULPS);
}

#[test]
fn nothing_moves_at_the_identity() {
    let (zero, other) = (Twist::<f64>::zero(), Twist::from_array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]));
    assert_eq!(Pose::exp(zero), Pose::identity());
    assert_eq!(Pose::<f64>::identity().log(), zero);
    assert_eq!(zero.dexp(other), other);
    assert_eq!(zero.dexp_inverse(other), other);
}

/// `2 n nᵀ − 1`, exact for these axes, has φ = ±π n.
#[test]
fn log_of_a_half_turn_is_pi_about_its_axis() {
    for axis in
        [[1.0_f64, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.6, 0.8], [-0.8, 0.0, 0.6], [0.6, -0.8, 0.0]]
    {
        let n = Vector3::from(axis);
        let phi = so3::log(&(n * n.transpose() * 2.0 - Matrix3::identity()));
        let sign = f64::signum(phi.dot(&n));
        assert!((phi * sign - n * PI).amax() <= ULPS * f64::EPSILON * PI, "{phi} for {n}");
    }
}
