//! The double-double scalar against 256-bit numbers.

#[allow(dead_code, reason = "other tests use other parts of it")]
mod extended;

use std::f64::consts::FRAC_PI_2;

use extended::Big;
use extended::judge::Random;
use frs_core::extended::DoubleDouble;
use frs_core::spatial::Pose;
use frs_core::{Model, Real, Workspace, urdf};
use nalgebra::Matrix3;

/// What the documentation promises of arithmetic, sine, cosine and angle: 2⁻¹⁰⁰.
const PROMISED: f64 = 1.0 / (1u128 << 100) as f64;

fn big(x: DoubleDouble) -> Big {
    Big::new(x.high()) + Big::new(x.low())
}

/// A number with both words in use, of a size between 10⁻⁸ and 10⁸.
fn number(random: &mut Random) -> DoubleDouble {
    let high = random.number() * 10.0_f64.powf(8.0 * random.number());
    DoubleDouble::from(high) + DoubleDouble::from(high * random.number() * 1e-16)
}

#[track_caller]
fn close(got: DoubleDouble, exact: &Big, scale: &Big) {
    let error = ((big(got) - exact.clone()).abs() / scale.clone()).to_f64();
    assert!(error <= PROMISED, "{got:?} is off by {error:e}");
}

#[test]
fn arithmetic_has_a_hundred_bits() {
    let mut random = Random(7);
    for _ in 0..2_000 {
        let (a, b) = (number(&mut random), number(&mut random));
        for (got, exact) in [
            (a + b, big(a) + big(b)),
            (a - b, big(a) - big(b)),
            (a * b, big(a) * big(b)),
            (a / b, big(a) / big(b)),
            ((a * a).sqrt(), (big(a * a)).sqrt()),
        ] {
            close(got, &exact, &exact.abs());
        }
    }
}

/// Every size up to 10¹⁶ rad, and the neighbourhoods of multiples of π/2, where quarters are told apart.
#[test]
fn sine_and_cosine_have_a_hundred_bits() {
    let mut random = Random(11);
    let sizes = (0..2_000).map(|i| 10.0_f64.powf(f64::from(i) * 0.014 - 12.0));
    let quarters = (-40..40).map(|i| f64::from(i) * FRAC_PI_2);
    for angle in sizes.chain(quarters).chain([1e8, 1e12, 1e15, 9.9e15]) {
        let angle = DoubleDouble::from(angle) + DoubleDouble::from(angle * random.number() * 1e-16);
        let (sin, cos) = angle.sin_cos();
        let (sin_exact, cos_exact) = big(angle).sin_cos();
        close(sin, &sin_exact, &Big::new(1.0));
        close(cos, &cos_exact, &Big::new(1.0));
    }
}

#[test]
fn the_angle_of_a_point_has_a_hundred_bits() {
    let mut random = Random(13);
    for _ in 0..2_000 {
        let (y, x) = (number(&mut random), number(&mut random));
        let exact = big(y).atan2(&big(x));
        close(y.atan2(x), &exact, &exact.abs());
    }
    let zero = DoubleDouble::from(0.0);
    assert_eq!(zero.atan2(zero), zero);
    assert_eq!(DoubleDouble::from(2.0).atan2(zero).high(), FRAC_PI_2);
}

#[test]
fn what_is_no_number_stays_none() {
    for value in [f64::NAN, f64::INFINITY] {
        let (sin, cos) = DoubleDouble::from(value).sin_cos();
        assert!(sin.high().is_nan() && cos.high().is_nan());
    }
}

/// A rotation read from a file is orthonormal to a double's digits; evaluated with more, it must be so to more.
#[test]
fn orthonormalised_rotations_are_orthonormal_to_thirty_digits() {
    let text = urdf::LWR_SATELLITE.replace("<origin ", r#"<origin rpy="0.3 -1.1 0.7" "#);
    let model = Model::from_urdf(&text).unwrap().cast::<DoubleDouble>();
    let off = |model: &Model<DoubleDouble>| {
        let bodies = model.bodies().iter().map(|body| body.placement);
        let links = model.links().iter().map(|link| link.placement);
        let error = |pose: Pose<DoubleDouble>| {
            let error = pose.rotation.transpose() * pose.rotation - Matrix3::identity();
            error.map(|entry| entry.high().abs()).max()
        };
        bodies.chain(links).map(error).fold(0.0, f64::max)
    };
    let (before, after) = (off(&model), off(&model.clone().orthonormalised()));
    assert!(after <= PROMISED, "{after:e}");
    assert!(before > 1e-17, "the robot has no rounded rotation, so this test says nothing: {before:e}");
}

/// Twice the digits: what doubles compute agrees with it to theirs, and is not the same.
#[test]
fn the_core_runs_over_it() {
    let model = Model::from_urdf(urdf::LWR_SATELLITE).unwrap();
    let wide = model.cast::<DoubleDouble>().orthonormalised();
    let q = [0.1, -0.4, 0.3, 1.2, 0.0, -0.7, 0.2];
    let com = Workspace::new(&model).shape(&q).com();
    let com_wide = Workspace::new(&wide).shape(&q.map(DoubleDouble::from)).com();
    let off = com_wide.zip_map(&com, |wide, double| (wide - double.into()).high().abs()).max();
    assert!(off > 0.0 && off < 1e-14, "{off:e}");
}
