//! The exponentials of SO(3) and SE(3), their logarithms and tangents, against power series in extended precision.
//!
//! Errors are counted in units of the type's `EPSILON` times the natural scale of a result: the largest entry of the
//! exact vector, matrix or 3×3 block. `-- --nocapture` prints the worst of each function.

mod extended;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use extended::{Big, Wide, exponential, exponential_series, largest};
use frs_core::Real;
use frs_core::spatial::{Pose, Twist, so3};
use nalgebra::{Matrix3, Matrix4, Matrix6, SMatrix, Vector3, Vector6};
use num_traits::Zero;

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

/// A number type under test.
trait Judged: Real {
    const EPSILON: f64;
    /// Below the smallest normal number a unit in the last place shrinks no more.
    const SMALLEST: f64;
    fn big(self) -> Big;
    fn nearest(value: &Big) -> Self;
}

macro_rules! judged {
    ($($float:ident),*) => {$(
        impl Judged for $float {
            const EPSILON: f64 = $float::EPSILON as f64;
            const SMALLEST: f64 = $float::MIN_POSITIVE as f64;
            fn big(self) -> Big {
                Big::new(f64::from(self))
            }
            fn nearest(value: &Big) -> Self {
                Self::from_f64(value.to_f64())
            }
        }
    )*};
}
judged!(f64, f32);

/// Its own error is far below: what is left is where a series was cut, promised to be below 10⁻³³.
impl Judged for Wide {
    const EPSILON: f64 = 1e-33 / ULPS;
    const SMALLEST: f64 = 1e-250;
    fn big(self) -> Big {
        self.big()
    }
    fn nearest(value: &Big) -> Self {
        Self::of(value.clone())
    }
}

fn big<T: Judged, const R: usize, const C: usize>(matrix: SMatrix<T, R, C>) -> SMatrix<Big, R, C> {
    matrix.map(T::big)
}

/// The worst error of one function.
struct Worst {
    name: &'static str,
    ulps: f64,
    angle: f64,
}

impl Worst {
    fn of(name: &'static str) -> Self {
        Self { name, ulps: 0.0, angle: f64::NAN }
    }

    fn see<T: Judged, const R: usize, const C: usize>(
        &mut self,
        angle: f64,
        got: SMatrix<T, R, C>,
        exact: &SMatrix<Big, R, C>,
    ) {
        self.see_at_scale(angle, got, exact, largest(exact));
    }

    fn see_at_scale<T: Judged, const R: usize, const C: usize>(
        &mut self,
        angle: f64,
        got: SMatrix<T, R, C>,
        exact: &SMatrix<Big, R, C>,
        scale: Big,
    ) {
        let smallest = Big::new(T::SMALLEST);
        let unit = if scale < smallest { smallest } else { scale } * Big::new(T::EPSILON);
        let ulps = (largest(&(big(got) - exact)) / unit).to_f64();
        if ulps.is_nan() || ulps > self.ulps {
            (self.ulps, self.angle) = (ulps, angle);
        }
    }

    fn keeps<T>(&self, bound: f64) {
        let Self { name, ulps, angle } = self;
        let report = format!("{} {name}: {ulps:.2} ulp at {angle:e}", std::any::type_name::<T>());
        println!("{report}");
        assert!(*ulps <= bound, "{report}");
    }
}

/// Numbers in (−1, 1), the same in every run.
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / 2.0_f64.powi(52) - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.number())
    }
}

fn twist<T: Real>(angular: Vector3<f64>, linear: Vector3<f64>) -> Twist<T> {
    Twist::new(angular.map(T::from_f64), linear.map(T::from_f64))
}

/// For every angle the coordinate axes and random ones, with linear parts of many sizes.
fn twists<T: Judged>(angles: &[f64]) -> Vec<(f64, Twist<T>)> {
    // Wide numbers are slow, and only series ends are looked for.
    let axes = if T::EPSILON < 1e-30 { 4 } else { 16 };
    let mut random = Random(1);
    let mut list = Vec::new();
    for &angle in angles {
        for k in 0..axes {
            let axis = [Vector3::x(), -Vector3::y(), Vector3::z()].get(k).copied();
            let axis = axis.unwrap_or_else(|| random.vector().normalize());
            list.push((angle, twist(axis * angle, random.vector() * 10.0_f64.powi(k as i32 % 7 - 3))));
        }
    }
    list
}

/// The 4×4 matrix of `zeta`.
fn hat([x, y, z, u, v, w]: [Big; 6]) -> Matrix4<Big> {
    let (o, [a, b, c]) = (Big::zero, [x.clone(), y.clone(), z.clone()].map(|e| -e));
    Matrix4::new(o(), c, y, u, z, o(), a, v, b, x, o(), w, o(), o(), o(), o())
}

fn exact_exp<T: Judged>(zeta: Twist<T>) -> (Matrix3<Big>, Vector3<Big>) {
    let power = exponential(&hat(zeta.to_array().map(T::big)));
    (power.fixed_view::<3, 3>(0, 0).into_owned(), power.fixed_view::<3, 1>(0, 3).into_owned())
}

fn block<T: nalgebra::Scalar>(matrix: &Matrix6<T>, row: usize, column: usize) -> Matrix3<T> {
    matrix.fixed_view::<3, 3>(row, column).into_owned()
}

fn judge_exp<T: Judged>() {
    let [mut rotation, mut translation] = ["exp, R", "exp, p"].map(Worst::of);
    for (angle, zeta) in twists::<T>(&ANGLES) {
        let (r, p) = exact_exp(zeta);
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
    for angle in [4.0, 5.0, TAU, 7.0, 30.0, 1e3] {
        let [mut rotation, mut translation] = ["exp of many turns, R", "exp of many turns, p"].map(Worst::of);
        for (angle, zeta) in twists::<f64>(&[angle]) {
            let (r, p) = exact_exp(zeta);
            let got = Pose::exp(zeta);
            rotation.see(angle, got.rotation, &r);
            // At 2π a p across the axis is zero.
            translation.see_at_scale(angle, got.translation, &p, largest(&big(zeta.linear)));
        }
        rotation.keeps::<f64>(ULPS * angle / PI);
        translation.keeps::<f64>(ULPS);
    }
}

fn cross(phi: &Vector3<Big>) -> Matrix3<Big> {
    Matrix3::from_columns(&[0, 1, 2].map(|k| phi.cross(&Vector3::ith(k, Big::new(1.0)))))
}

/// The logarithm φ of the rotation nearest to `r`, in the sense of `like` where |φ| is about π.
fn exact_log(r: &Matrix3<Big>, like: &Vector3<Big>) -> Vector3<Big> {
    let number = Big::new;
    // The last summand gives an exact half turn a sense, and is nothing otherwise.
    let mut x = r + cross(like) * number(1e-60);
    for _ in 0..3 {
        x = &x * (Matrix3::identity() * number(3.0) - x.transpose() * &x) * number(0.5);
    }
    let skew = (&x - x.transpose()) * number(0.5);
    let axis = Vector3::from([(2, 1), (0, 2), (1, 0)].map(|entry| skew[entry].clone()));
    let sin = axis.dot(&axis).sqrt();
    if sin.is_zero() {
        return axis;
    }
    let mut angle = sin.atan2(&((x.trace() - number(1.0)) * number(0.5)));
    if axis.dot(like) < number(0.0) {
        // The other way round.
        angle -= number(1.0).atan2(&number(0.0)) * number(4.0);
    }
    axis * (angle / sin)
}

fn judge_log<T: Judged>() {
    let [mut angular, mut linear] = ["log, φ", "log, ρ"].map(Worst::of);
    for (angle, zeta) in twists::<T>(&ANGLES) {
        let (r, p) = exact_exp(zeta);
        let pose = Pose::new(r.map(|e| T::nearest(&e)), p.map(|e| T::nearest(&e)));
        let got = pose.log();
        let phi = exact_log(&big(pose.rotation), &big(got.angular));
        let j = exponential_series(&cross(&phi), 1);
        angular.see(angle, got.angular, &phi);
        linear.see(angle, got.linear, &(inverse(&j) * big(pose.translation)));
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

/// The 6×6 matrix of a linear map of twists.
fn matrix<T: Real>(map: impl Fn(Twist<T>) -> Twist<T>) -> Matrix6<T> {
    let columns: [Vector6<T>; 6] = std::array::from_fn(|k| {
        let mut unit = [T::zero(); 6];
        unit[k] = T::one();
        map(Twist::from_array(unit)).to_vector()
    });
    Matrix6::from_columns(&columns)
}

/// `J⁻¹` by Newton's iteration from `f64`.
fn inverse(j: &Matrix3<Big>) -> Matrix3<Big> {
    let mut x = j.map(|e| e.to_f64()).try_inverse().expect("J is regular below 2π").map(Big::new);
    for _ in 0..3 {
        x = &x * (Matrix3::identity() * Big::new(2.0) - j * &x);
    }
    x
}

fn judge_dexp<T: Judged>() {
    let mut worst = ["dexp, J", "dexp, Q", "dexp⁻¹, J⁻¹", "dexp⁻¹, −J⁻¹QJ⁻¹"].map(Worst::of);
    for (angle, zeta) in twists::<T>(&[&ANGLES[..], &[3.5, 4.0]].concat()) {
        let exact = exponential_series(&big(zeta.ad_matrix()), 1);
        let (j, q) = (block(&exact, 0, 0), block(&exact, 3, 0));
        let j_inverse = inverse(&j);
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
        let (at, along) = (hat(zeta.to_array().map(Big::new)), hat(eta.to_array().map(Big::new)) * step.clone());
        let rate = (exponential(&(&at + &along)) - exponential(&(&at - &along))) / (step.clone() + step.clone());
        let back = exponential(&-at);
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
        let exact = exponential(&big(zeta.ad_matrix()));
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
