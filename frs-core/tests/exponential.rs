//! The exponentials of SO(3) and SE(3), their logarithms and tangents, against 320-bit power series.
//!
//! Errors are counted in units of the type's `EPSILON` times the natural scale of a result: the largest entry of the
//! exact vector, matrix or 3×3 block. `-- --nocapture` prints the worst of each.

mod extended;

use std::f64::consts::{PI, TAU};

use extended::{Big, exponential, exponential_series, largest};
use frs_core::Real;
use frs_core::spatial::{Pose, Twist};
use nalgebra::{Matrix3, Matrix4, Matrix6, SMatrix, Vector3};
use num_traits::Zero;

/// What every function keeps, for angles up to π.
const ULPS: f64 = 4.0;
/// Where the series give way to the trigonometric forms: θ² = 10.
const SWITCH: f64 = 3.162_277_660_168_379_5;
/// From nothing to π: subnormal; with squares that underflow, in f64 and in f32; with squares that vanish against 1.
const ANGLES: [f64; 23] = [
    0.0, 5e-324, 3e-310, 1e-300, 1e-160, 1e-40, 1e-25, 1e-20, 1e-8, 1e-6, 2e-6, 1e-4, 1e-2, 0.1, 0.5, 1.0, 1.5, 2.0, 2.5,
    3.0, PI - 1e-3, PI - 1e-8, PI - 1e-15,
];

trait Judged: Real {
    const EPSILON: f64;
    /// Below the smallest normal number a unit in the last place shrinks no more.
    const TINY: f64;
    fn big(self) -> Big;
}

macro_rules! judged {
    ($($float:ident),*) => {$(
        impl Judged for $float {
            const EPSILON: f64 = $float::EPSILON as f64;
            const TINY: f64 = $float::MIN_POSITIVE as f64;
            fn big(self) -> Big {
                Big::new(f64::from(self))
            }
        }
    )*};
}
judged!(f64, f32);

fn bigs<T: Judged, const R: usize, const C: usize>(matrix: SMatrix<T, R, C>) -> SMatrix<Big, R, C> {
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
        exact: SMatrix<Big, R, C>,
        scale: Big,
    ) {
        let floor = Big::new(T::TINY);
        let unit = if scale < floor { floor } else { scale } * Big::new(T::EPSILON);
        let ulps = (largest(&(bigs(got) - exact)) / unit).to_f64() / 1.0_f64.max(angle / PI);
        if ulps.is_nan() || ulps > self.ulps {
            (self.ulps, self.angle) = (ulps, angle);
        }
    }

    fn keeps<T>(&self, bound: f64) {
        println!("{} {:24} {:5.2} ulp  at {:e}", std::any::type_name::<T>(), self.name, self.ulps, self.angle);
        if std::env::var("NOPANIC").is_err() { return; }
        assert!(self.ulps <= bound, "{}: {} ulp at {:e}", self.name, self.ulps, self.angle);
    }
}

/// Random numbers in (−1, 1), the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / 2.0_f64.powi(52) - 1.0
    }
    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.next())
    }
}

fn twist<T: Real>(angular: Vector3<f64>, linear: Vector3<f64>) -> Twist<T> {
    Twist::new(angular.map(T::from_f64), linear.map(T::from_f64))
}

/// For every angle: every coordinate axis and random ones, with linear parts of all sizes.
fn twists<T: Real>(angles: &[f64]) -> Vec<(f64, Twist<T>)> {
    let mut random = Random(1);
    let axes = [Vector3::x(), -Vector3::y(), Vector3::z()];
    let each = |&angle: &f64| {
        (0..150).map(|k| {
            let axis = axes.get(k).copied().unwrap_or_else(|| random.vector().normalize());
            let linear = random.vector() * 10.0_f64.powi(k as i32 % 7 - 3);
            (angle, twist(axis * angle, linear))
        }).collect::<Vec<_>>()
    };
    angles.iter().flat_map(each).collect()
}

fn block(matrix: &Matrix6<Big>, row: usize, column: usize) -> Matrix3<Big> {
    matrix.fixed_view::<3, 3>(row, column).into_owned()
}

/// `ad_ζ`, exactly.
fn ad<T: Judged>(zeta: Twist<T>) -> Matrix6<Big> {
    bigs(zeta.ad_matrix())
}

/// `exp ζ` as (R, p), by the 4×4 series.
fn exact_exp(zeta: [Big; 6]) -> (Matrix3<Big>, Vector3<Big>) {
    let [x, y, z, u, v, w] = zeta;
    let o = Big::zero;
    let (a, b, c) = (-x.clone(), -y.clone(), -z.clone());
    let power = exponential(&Matrix4::new(o(), c, y, u, z, o(), a, v, b, x, o(), w, o(), o(), o(), o()));
    (power.fixed_view::<3, 3>(0, 0).into_owned(), power.fixed_view::<3, 1>(0, 3).into_owned())
}

fn exp<T: Judged>() {
    let (mut rotation, mut translation) = (Worst::of("exp, rotation"), Worst::of("exp, translation"));
    let beyond = [PI, SWITCH - 1e-12, SWITCH + 1e-12, 4.0, 5.0, TAU, 7.0, 30.0, 1e3];
    for (angle, zeta) in twists::<T>(&[&ANGLES[..], &beyond].concat()) {
        let (r, p) = exact_exp(zeta.to_array().map(T::big));
        let got = Pose::exp(zeta);
        let size = largest(&r);
        rotation.see(angle, got.rotation, r, size);
        let size = if angle > PI { largest(&bigs(zeta.linear)) } else { largest(&p) };
        translation.see(angle, got.translation, p, size);
    }
    rotation.keeps::<T>(ULPS);
    translation.keeps::<T>(ULPS);
}

#[test]
fn exp_is_the_matrix_exponential() {
    exp::<f64>();
    exp::<f32>();
}

fn log<T: Judged>() {
    let (mut angular, mut linear) = (Worst::of("log, angular"), Worst::of("log, linear"));
    let (mut rotation, mut translation) = (Worst::of("exp log, rotation"), Worst::of("exp log, translation"));
    for (angle, zeta) in twists::<T>(&[&ANGLES[..], &[PI]].concat()) {
        let (r, p) = exact_exp(zeta.to_array().map(T::big));
        let pose = Pose::new(r.map(|x| T::from_f64(x.to_f64())), p.map(|x| T::from_f64(x.to_f64())));
        let got = pose.log();
        if angle < 3.1 {
            let (phi, rho) = (bigs(zeta.angular), bigs(zeta.linear));
            let (p, q) = (largest(&phi), largest(&rho));
            angular.see(angle, got.angular, phi, p);
            linear.see(angle, got.linear, rho, q);
        }
        let (r, p) = exact_exp(got.to_array().map(T::big));
        let (s, t) = (largest(&r), largest(&p));
        rotation.see(angle, pose.rotation, r, s);
        translation.see(angle, pose.translation, p, t);
    }
    angular.keeps::<T>(ULPS);
    linear.keeps::<T>(ULPS);
    rotation.keeps::<T>(ULPS);
    translation.keeps::<T>(ULPS);
}

#[test]
fn log_undoes_the_matrix_exponential() {
    log::<f64>();
    log::<f32>();
}

/// `M W` for a 6×6 matrix map of twists.
fn matrix<T: Judged>(map: impl Fn(Twist<T>) -> Twist<T>) -> Matrix6<T> {
    let columns: [_; 6] = std::array::from_fn(|k| {
        let mut unit = [T::zero(); 6];
        unit[k] = T::one();
        map(Twist::from_array(unit)).to_vector()
    });
    Matrix6::from_columns(&columns)
}

fn judge<T: Judged>(worst: &mut [Worst; 4], angle: f64, map: impl Fn(Twist<T>) -> Twist<T>, exact: &Matrix6<Big>, random: &mut Random) {
    let got = matrix(&map);
    let (j, q) = (block(exact, 0, 0), block(exact, 3, 0));
    let size = largest(&j);
    worst[0].see(angle, got.fixed_view::<3, 3>(0, 0).into_owned(), j.clone(), size);
    let size = largest(&q);
    worst[1].see(angle, got.fixed_view::<3, 3>(3, 0).into_owned(), q.clone(), size);
    let other = twist::<T>(random.vector(), random.vector());
    let (a, b) = (bigs(other.angular), bigs(other.linear));
    let (ja, jb, qa) = (&j * &a, &j * &b, &q * &a);
    let got = map(other);
    let size = largest(&ja);
    worst[2].see(angle, got.angular, ja, size);
    let (x, y) = (largest(&j) * largest(&b), largest(&q) * largest(&a));
    worst[3].see(angle, got.linear, jb + qa, if x < y { y } else { x });
}

fn inverse(j: &Matrix3<Big>) -> Matrix3<Big> {
    let mut x = j.map(|x| x.to_f64()).try_inverse().unwrap().map(Big::new);
    for _ in 0..4 {
        x = &x * (Matrix3::identity() * Big::new(2.0) - j * &x);
    }
    x
}

fn dexp<T: Judged>() {
    let mut random = Random(7);
    let mut forward = ["dexp, diagonal block", "dexp, lower block", "dexp, angular", "dexp, linear"].map(Worst::of);
    let mut backward = ["dexp⁻¹, diagonal block", "dexp⁻¹, lower block", "dexp⁻¹, angular", "dexp⁻¹, linear"].map(Worst::of);
    for (angle, zeta) in twists::<T>(&[&ANGLES[..], &[PI, SWITCH - 1e-12, SWITCH + 1e-12]].concat()) {
        let exact = exponential_series(&ad(zeta), 1);
        judge(&mut forward, angle, |w| zeta.dexp(w), &exact, &mut random);
        let (j, q) = (inverse(&block(&exact, 0, 0)), block(&exact, 3, 0));
        let q = -(&j * q) * &j;
        let mut exact = Matrix6::zeros();
        exact.fixed_view_mut::<3, 3>(0, 0).copy_from(&j);
        exact.fixed_view_mut::<3, 3>(3, 3).copy_from(&j);
        exact.fixed_view_mut::<3, 3>(3, 0).copy_from(&q);
        judge(&mut backward, angle, |w| zeta.dexp_inverse(w), &exact, &mut random);
    }
    for w in forward.iter().chain(&backward) { w.keeps::<T>(ULPS); }
}

#[test]
fn dexp_is_its_series() {
    dexp::<f64>();
    dexp::<f32>();
}
