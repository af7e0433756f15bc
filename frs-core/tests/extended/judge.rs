//! Errors of results in units of the last place, over a range of twists.

use frs_core::Real;
use frs_core::spatial::Twist;
use nalgebra::{Matrix3, Matrix6, SMatrix, Scalar, Vector3, Vector6};

use super::exact::largest;
use super::{Big, Wide};

/// A number type under test.
pub trait Judged: Real {
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

/// Its own error is far below: what is left is where a series was cut, promised to be below 10⁻³³, four units.
impl Judged for Wide {
    const EPSILON: f64 = 0.25e-33;
    const SMALLEST: f64 = 1e-250;
    fn big(self) -> Big {
        self.big()
    }
    fn nearest(value: &Big) -> Self {
        Self::of(value.clone())
    }
}

pub fn big<T: Judged, const R: usize, const C: usize>(matrix: SMatrix<T, R, C>) -> SMatrix<Big, R, C> {
    matrix.map(T::big)
}

/// The worst error of one function.
pub struct Worst {
    name: &'static str,
    ulps: f64,
    angle: f64,
}

impl Worst {
    pub fn of(name: &'static str) -> Self {
        Self { name, ulps: 0.0, angle: f64::NAN }
    }

    pub fn see<T: Judged, const R: usize, const C: usize>(
        &mut self,
        angle: f64,
        got: SMatrix<T, R, C>,
        exact: &SMatrix<Big, R, C>,
    ) {
        self.see_at_scale(angle, got, exact, largest(exact));
    }

    pub fn see_at_scale<T: Judged, const R: usize, const C: usize>(
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

    pub fn keeps<T>(&self, bound: f64) {
        let Self { name, ulps, angle } = self;
        let report = format!("{} {name}: {ulps:.2} ulp at {angle:e}", std::any::type_name::<T>());
        println!("{report}");
        assert!(*ulps <= bound, "{report}");
    }
}

/// Numbers in (−1, 1), the same in every run.
pub struct Random(pub u64);

impl Random {
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / 2.0_f64.powi(52) - 1.0
    }

    pub fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.number())
    }
}

pub fn twist<T: Real>(angular: Vector3<f64>, linear: Vector3<f64>) -> Twist<T> {
    Twist::new(angular.map(T::from_f64), linear.map(T::from_f64))
}

/// For every angle the coordinate axes and random ones, with linear parts of many sizes.
pub fn twists<T: Judged>(angles: &[f64]) -> Vec<(f64, Twist<T>)> {
    // Wide numbers are slow, and only series ends are looked for.
    let axes = if T::EPSILON < 1e-30 { 4 } else { 12 };
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

pub fn block<T: Scalar>(matrix: &Matrix6<T>, row: usize, column: usize) -> Matrix3<T> {
    matrix.fixed_view::<3, 3>(row, column).into_owned()
}

/// The 6×6 matrix of a linear map of twists.
pub fn matrix<T: Real>(map: impl Fn(Twist<T>) -> Twist<T>) -> Matrix6<T> {
    let columns: [Vector6<T>; 6] = std::array::from_fn(|k| {
        let mut unit = [T::zero(); 6];
        unit[k] = T::one();
        map(Twist::from_array(unit)).to_vector()
    });
    Matrix6::from_columns(&columns)
}
