//! Sine and cosine, the same bits on every machine and in every lane.
//!
//! An angle is n quarter turns and a rest r = y₀ + y₁ within ±π/4, y₁ being what no longer fits into y₀; the rest has two polynomials, and n says
//! which is sine, which cosine, with which signs. Plain sums and products only, and no branch near zero: numbers side by side
//! go through the same operations. Errors are below 0.85 units in the last place (`tests/turn.rs`).
//!
//! Sources: reduction in parts, W. J. Cody and W. Waite, Software Manual for the Elementary Functions, 1980; far from zero, M. H. Payne and
//! R. N. Hanek, SIGNUM 18, 1983; coefficients of the polynomials, fdlibm 5.3 (`k_sin.c`, `k_cos.c`), Sun Microsystems.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};
use std::ops::{Add, Mul, Neg, Sub};

/// Below this angle (rad) there are fewer than 2¹⁰ quarter turns, and their products with the first two parts of π/2 are exact.
pub(crate) const NEAR: f64 = 1_600.0;

/// π/2 in parts of 43 bits, and the rest.
const PARTS: [f64; 3] = [1.5707963267948344, 6.223372171896261e-14, 3.5215598651832e-27];

/// π/2 less the nearest double.
const BEYOND: f64 = 6.123233995736766e-17;

/// A double plus this is rounded to an integer in its last bits.
const INTEGER: f64 = 6_755_399_441_055_744.0;

/// sin r = r + r³ (S₀ + S₁ r² + …), within ±π/4 to 2⁻⁵⁸.
const SINE: [f64; 6] = [
    -0.16666666666666632,
    0.00833333333332249,
    -0.0001984126982985795,
    2.7557313707070068e-06,
    -2.5050760253406863e-08,
    1.58969099521155e-10,
];

/// cos r = 1 − r²/2 + r⁴ (C₀ + C₁ r² + …), within ±π/4 to 2⁻⁵⁸.
const COSINE: [f64; 6] = [
    0.0416666666666666,
    -0.001388888888887411,
    2.480158728947673e-05,
    -2.7557314351390663e-07,
    2.087572321298175e-09,
    -1.1359647557788195e-11,
];

/// 2/π in binary: 64 zeros, then its first 1216 bits after the point.
const TWO_OVER_PI: [u64; 20] = [
    0x0000000000000000,
    0xa2f9836e4e441529,
    0xfc2757d1f534ddc0,
    0xdb6295993c439041,
    0xfe5163abdebbc561,
    0xb7246e3a424dd2e0,
    0x06492eea09d1921c,
    0xfe1deb1cb129a73e,
    0xe88235f52ebb4484,
    0xe99c7026b45f7e41,
    0x3991d639835339f4,
    0x9c845f8bbdf9283b,
    0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea,
    0x6bfb5fb11f8d5d08,
    0x56033046fc7b6bab,
];

/// (sin `x`, cos `x`), `x` in radians; NaN of what is no number.
pub fn sin_cos(x: f64) -> (f64, f64) {
    if x.abs() < NEAR {
        near(x, |value| value, below)
    } else if x.is_finite() {
        let (quarters, rest) = far(x.abs());
        let (sin, cos) = finish(quarters, rest, |value| value, below);
        (if x < 0.0 { -sin } else { sin }, cos)
    } else {
        (f64::NAN, f64::NAN)
    }
}

/// (sin, cos) of several angles, four at a time: each as [`sin_cos`] gives it.
pub fn sin_cos_each<const N: usize>(angles: [f64; N]) -> [(f64, f64); N] {
    let mut pairs = [(0.0, 0.0); N];
    for (pairs, angles) in pairs.chunks_mut(4).zip(angles.chunks(4)) {
        let mut four = [0.0; 4];
        four[..angles.len()].copy_from_slice(angles);
        let (sin, cos) = sin_cos_of_four(four);
        pairs.iter_mut().zip(sin.into_iter().zip(cos)).for_each(|(pair, both)| *pair = both);
    }
    pairs
}

/// [`sin_cos_each`] of singles, each rounded once more.
pub fn sin_cos_single_each<const N: usize>(angles: [f32; N]) -> [(f32, f32); N] {
    sin_cos_each(angles.map(f64::from)).map(|(sin, cos)| (sin as f32, cos as f32))
}

fn sin_cos_of_four(x: [f64; 4]) -> ([f64; 4], [f64; 4]) {
    let (mut sin, mut cos) = ([0.0; 4], [0.0; 4]);
    if x.iter().all(|x| x.abs() < NEAR) {
        // No branch and no call: a compiler does all four at once.
        for lane in 0..4 {
            (sin[lane], cos[lane]) = near(x[lane], |value| value, below);
        }
    } else {
        for lane in 0..4 {
            (sin[lane], cos[lane]) = sin_cos(x[lane]);
        }
    }
    (sin, cos)
}

/// (sin `x`, cos `x`) of a single, each rounded once more.
pub fn sin_cos_single(x: f32) -> (f32, f32) {
    let (sin, cos) = sin_cos(x.into());
    (sin as f32, cos as f32)
}

fn below(x: f64, limit: f64, below: f64, otherwise: f64) -> f64 {
    if x < limit { below } else { otherwise }
}

/// (sin, cos) of angles below [`NEAR`]; `lift` makes a number of any kind, `below(x, limit, a, b)` is a where x < limit, else b.
pub(crate) fn near<T>(x: T, lift: impl Fn(f64) -> T, below: impl Fn(T, f64, T, T) -> T) -> (T, T)
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T>,
{
    let round = |x: T| (x + lift(INTEGER)) - lift(INTEGER);
    let n = round(x * lift(FRAC_2_PI));
    // Exact, both: the products by their few bits, the first difference by its nearness.
    let (first, second) = (x - n * lift(PARTS[0]), n * lift(PARTS[1]));
    let rest = first - second;
    let back = rest - first;
    let lost = (first - (rest - back)) - (second + back);
    let tail = lost - n * lift(PARTS[2]);
    let y = rest + tail;
    let tail = (rest - y) + tail;
    // What is left of four quarters: −2 … 2.
    let turns = round(n * lift(0.25));
    finish(n - turns * lift(4.0), [y, tail], lift, below)
}

/// (sin, cos) of `quarters` quarter turns (−2 … 2) and a rest.
fn finish<T>(quarters: T, [y, tail]: [T; 2], lift: impl Fn(f64) -> T, below: impl Fn(T, f64, T, T) -> T) -> (T, T)
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T>,
{
    let square = y * y;
    let polynomial = |coefficients: [f64; 6]| {
        // One by one: `map` of an array of lanes is not inlined.
        let [a, b, c, d, e, f] = coefficients;
        let [a, b, c, d, e, f] = [lift(a), lift(b), lift(c), lift(d), lift(e), lift(f)];
        // In two halves, which a processor computes at once.
        let fourth = square * square;
        (a + square * b) + fourth * ((c + square * d) + fourth * (e + square * f))
    };
    let half = lift(0.5) * square;
    let one = lift(1.0);
    let sin = y + ((square * y) * polynomial(SINE) + tail * (one - half));
    let most = one - half;
    let cos = most + (((one - most) - half) + ((square * square) * polynomial(COSINE) - y * tail));

    // (quarters² − 1)² is 0 where there is an odd number of them, else 1 or 9.
    let even = quarters * quarters - one;
    let even = even * even;
    let (sin, cos) = (below(even, 0.5, cos, sin), below(even, 0.5, sin, cos));
    let (first, last) = (quarters - lift(0.5), quarters + lift(0.5));
    // Sine is positive in the first half turn, quarters 0 and 1; cosine in quarters −1 and 0.
    (below(first * first, 1.0, sin, -sin), below(last * last, 1.0, cos, -cos))
}

/// The quarter turns in a finite `x` ≥ 1, as a number from −1 to 2, and the rest.
///
/// x is m 2ᵉ with an integer m. Bits of 2/π whose product with it is a multiple of four quarters are left out; of m times the next 192, the lowest
/// 192 bits begin with the two of the quarter.
fn far(x: f64) -> (f64, [f64; 2]) {
    let bits = x.to_bits();
    let exponent = (bits >> 52) as usize;
    let m = u128::from((bits & ((1 << 52) - 1)) | (1 << 52));
    // e − 2 bits are left out, and 64 zeros come first; e is the exponent less 1075.
    let from = exponent - 1013;
    let (word, shift) = (from / 64, from % 64);
    let window = [0, 1, 2].map(|i| {
        let both = (u128::from(TWO_OVER_PI[word + i]) << 64) | u128::from(TWO_OVER_PI[word + i + 1]);
        (both << shift) >> 64
    });
    let low = m * window[2];
    let middle = m * window[1] + (low >> 64);
    let high = (m * window[0] + (middle >> 64)) as u64;
    let (middle, low) = (middle as u64, low as u64);
    // The fraction of a quarter in 128 bits; half and more of one is the next quarter, less something.
    let fraction = ((u128::from((high << 2) | (middle >> 62)) << 64) | u128::from((middle << 2) | (low >> 62))) as i128;
    let quarters = (high >> 62) + u64::from(fraction < 0);
    let nearest = fraction as f64;
    let scale = 0.5_f64.powi(64) * 0.5_f64.powi(64);
    let (fraction, rest) = (nearest * scale, (fraction - nearest as i128) as f64 * scale);
    let y = fraction * FRAC_PI_2;
    let tail = fraction.mul_add(FRAC_PI_2, -y) + (fraction * BEYOND + rest * FRAC_PI_2);
    // Four quarters are none, three are one back.
    ([0.0, 1.0, 2.0, -1.0][quarters as usize % 4], [y, tail])
}
