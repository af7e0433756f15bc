//! Sine and cosine against 256-bit numbers, near zero, far from it, and where they vanish.

#[allow(dead_code, reason = "other tests use other parts of it")]
mod extended;

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use extended::Big;
use extended::judge::Random;
use frs_core::extended::DoubleDouble;
use frs_core::{Real, turn};

/// Units in the last place that are promised. Half a one is the rounding of the last sum. What is added to y is up to 0.078 where a unit is 2⁻⁵³, with four
/// roundings: 0.31. What is added to 1 − y²/2 has a quarter from rounding y², up to 0.62, and 0.06 from the rest.
const ULPS: f64 = 0.85;

/// The gap between the double nearest to `exact` and the next one.
fn ulp(exact: f64) -> f64 {
    exact.abs().next_up() - exact.abs()
}

/// Errors of sine and cosine in units in the last place.
fn errors(x: f64, exact: [f64; 2], off: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = turn::sin_cos(x);
    assert!(sin.abs() <= 1.0 && cos.abs() <= 1.0, "{x:e}: {sin}, {cos}");
    [0, 1].map(|i| (off[i] / ulp(exact[i])).abs())
}

#[track_caller]
fn judge(x: f64) {
    let (sin, cos) = turn::sin_cos(x);
    let exact = Big::new(x).sin_cos();
    let off = [(sin, &exact.0), (cos, &exact.1)].map(|(got, exact)| (Big::new(got) - exact.clone()).to_f64());
    let [of_sin, of_cos] = errors(x, [exact.0.to_f64(), exact.1.to_f64()], off);
    assert!(of_sin <= ULPS && of_cos <= ULPS, "{x:e}: {of_sin}, {of_cos}");
}

#[test]
fn hard_angles_are_within_a_unit_in_the_last_place() {
    let sizes = (-324..=308).map(|power| 1.2345 * 10.0_f64.powi(power));
    // Next to multiples of a quarter turn, where either vanishes, and of an eighth, where the quarter changes.
    let beside = |x: f64| [x.next_down(), x, x.next_up()];
    let quarters = (1..3000).flat_map(|k| beside(f64::from(k) * FRAC_PI_2));
    let eighths = (1..400).step_by(2).flat_map(|k| beside(f64::from(k) * FRAC_PI_4));
    // The double nearest to a multiple of a quarter turn of all (J.-M. Muller, Elementary Functions, 3rd ed., 2016, §11.3.2): off by 2⁻⁶¹ of a rad.
    let nearest =
        [6_381_956_970_095_103.0 * 2.0_f64.powi(797), f64::MAX, 1600.0, 1600.0_f64.next_down(), 2.0_f64.powi(60)];
    for x in sizes.chain(quarters).chain(eighths).chain(nearest) {
        judge(x);
        judge(-x);
    }
}

#[test]
fn angles_of_all_sizes_are_within_a_unit_in_the_last_place() {
    let mut random = Random(23);
    for _ in 0..20_000 {
        judge(random.number() * 10.0_f64.powf(5.0 * random.number()));
        judge(random.number() * 10.0_f64.powf(154.0 * (1.0 + random.number())));
    }
}

/// A million angles of a joint, against sines of 31 digits; the variable `FRS_ANGLES` asks for another number of them.
#[test]
fn angles_of_joints_are_within_a_unit_in_the_last_place() {
    let angles: usize = std::env::var("FRS_ANGLES").map_or(1_000_000, |number| number.parse().unwrap());
    let (mut random, mut worst) = (Random(29), 0.0_f64);
    for _ in 0..angles {
        let x = 10.0 * random.number();
        let (sin, cos) = turn::sin_cos(x);
        let exact = DoubleDouble::from(x).sin_cos();
        let off = [(sin, exact.0), (cos, exact.1)].map(|(got, exact)| (exact - got.into()).high());
        let [of_sin, of_cos] = errors(x, [exact.0.high(), exact.1.high()], off);
        worst = worst.max(of_sin).max(of_cos);
    }
    println!("worst of {angles} angles: {worst:.3} units in the last place");
    assert!(worst <= ULPS, "{worst}");
}

/// Angles near and far from zero, in groups of every length.
#[test]
fn several_angles_at_once_have_the_bits_of_one() {
    fn check<const N: usize>(random: &mut Random) {
        let mut angles = [0.0; N];
        for size in [1.0, 1e-8, 1e3, 1e4, 1e300] {
            for _ in 0..1000 {
                angles = angles.map(|_| size * random.number());
                let bits = |(sin, cos): (f64, f64)| [sin.to_bits(), cos.to_bits()];
                assert_eq!(turn::sin_cos_each(angles).map(bits), angles.map(turn::sin_cos).map(bits));
                let (singles, bits) =
                    (angles.map(|x| x as f32), |(sin, cos): (f32, f32)| [sin.to_bits(), cos.to_bits()]);
                let finite = singles.map(|x| if x.is_finite() { x } else { 1.0 });
                assert_eq!(turn::sin_cos_single_each(finite).map(bits), finite.map(turn::sin_cos_single).map(bits));
            }
        }
    }
    let mut random = Random(31);
    check::<1>(&mut random);
    check::<4>(&mut random);
    check::<7>(&mut random);
    check::<8>(&mut random);
    assert_eq!(turn::sin_cos_each([]), []);
}

#[test]
fn zeros_and_what_is_no_number() {
    assert_eq!(turn::sin_cos(0.0), (0.0, 1.0));
    assert_eq!(turn::sin_cos(-0.0), (0.0, 1.0));
    assert_eq!(turn::sin_cos(5e-324), (5e-324, 1.0));
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (sin, cos) = turn::sin_cos(x);
        assert!(sin.is_nan() && cos.is_nan());
    }
}

/// A few bits as they were, on x86-64, so that a machine or a compiler that computes otherwise is seen.
#[test]
fn bits_are_the_same_everywhere() {
    let found = [0.1, 1.0, -2.5, 100.0, 1e6, 1e300].map(|x| {
        let (sin, cos) = turn::sin_cos(x);
        [sin.to_bits(), cos.to_bits()]
    });
    assert_eq!(
        found,
        [
            [4591858176471321388, 4607137420321232833],
            [4605754516372524270, 4603041830072026764],
            [13826937814250408624, 13828763316576947069],
            [13826108192625282488, 4605942297449095135],
            [13823348579196524647, 4606612732610269996],
            [13828914081749328773, 13826729873758864577],
        ]
    );
}
