//! Stumpff functions: all that the exponentials of SO(3) and SE(3) and their tangents ask of an angle.
//!
//! With `x = θ²` these are entire functions and their slopes `e_{k+2} = −dc_k/dx`; nothing happens at θ = 0:
//!
//! ```text
//! c_k = Σ (−x)^j/(k+2j)!        c₁ = sin θ/θ, c₂ = (1 − cos θ)/θ², c₃ = (θ − sin θ)/θ³;   c_k = 1/k! − x c_{k+2}
//! e_k = Σ (j+1)(−x)^j/(k+2j)!   e_k = c_k − x e_{k+2} = ½(c_{k−1} − (k−2) c_k)
//! ```
//!
//! With their help, and `x = φ·φ`, every map here is
//!
//! ```text
//! M(φ) = a·1 + b φ× + c φφᵀ = 1 + φ×(b + c φ×),   a = 1 − c x
//! ```
//!
//! and has a derivative made of the slopes `b' = 2 db/dx`, `c' = 2 dc/dx`:
//!
//! | map | a | b | c | b' | c' |
//! |---|---|---|---|---|---|
//! | dexp | c₁ | c₂ | c₃ | −2e₄ | −2e₅ |
//! | dexp⁻¹ | c₁/2c₂ | −½ | e₄/c₂ | 0 | e₆/c₂ |
//!
//! The last row has `a = ½θ cot ½θ` and `c = (1 − a)/θ²` with its slope, in a form without cancellation at θ = 0.

use nalgebra::Vector3;

use crate::Real;

/// Below this `x` the recurrences start from the series, above it from the trigonometric functions and go the other way.
/// Upwards they lose digits as `x` falls, downwards as it grows (c₁ = 0 at `x = π²` would be 1 − x c₃). Here neither loss
/// is felt: in a map `e₅` and `e₆` stand with |φ|³.
const SERIES_BELOW: f64 = 4.0;

/// Terms of a series. What is left out, `(j+1) x^j k!/(k+2j)!` of the leading term from `j = 17` on, is below 10⁻³³ at
/// `x = 4`: 3·10⁻³⁴ for e₆, less for the others.
const TERMS: u32 = 17;

/// Below this `x` two terms of `cos ½θ` and of `sin ½θ/θ` are enough: the third is less than 10⁻³⁴. So no quotient is
/// taken, and no root differentiated, where `x` underflows.
const TINY: f64 = 1e-16;

/// The functions of one angle.
pub(super) struct Stumpff<T> {
    /// `cos ½θ`.
    pub half_cos: T,
    /// `sin ½θ/θ`.
    pub half_sin: T,
    c1: T,
    c2: T,
    c3: T,
    e4: T,
    e5: T,
    e6: T,
}

impl<T: Real> Stumpff<T> {
    /// The functions at `x = θ²`.
    #[inline(always)]
    pub fn new(x: T) -> Self {
        let [one, two, half] = [1.0, 2.0, 0.5].map(T::from_f64);
        let [sixth, eighth, twenty_fourth, forty_eighth] = [6.0, 8.0, 24.0, 48.0].map(|n| one / T::from_f64(n));

        let theta = x.sqrt();
        let (sin, cos) = (theta * half).sin_cos();
        let half_cos = x.select_below(TINY, one - x * eighth, cos);
        let half_sin = x.select_below(TINY, half - x * forty_eighth, sin / theta);
        let (c1, c2) = (two * half_sin * half_cos, two * half_sin * half_sin);
        let (e1, e2) = (half * (cos * cos - sin * sin + c1), half * c1);

        // The recurrences of the header: down from the series, or up from c₁, c₂, e₁, e₂.
        let choose = |series: T, trigonometric: T| x.select_below(SERIES_BELOW, series, trigonometric);
        let [c5, c6, e6, e7] = [series(5, 1, x), series(6, 1, x), series(6, 2, x), series(7, 2, x)];
        let c3 = choose(sixth - x * c5, (one - c1) / x);
        let c4 = choose(twenty_fourth - x * c6, (half - c2) / x);
        let e3 = (c1 - e1) / x;
        let e4 = choose(c4 - x * e6, (c2 - e2) / x);
        let e5 = choose(c5 - x * e7, (c3 - e3) / x);
        let e6 = choose(e6, (c4 - e4) / x);
        let (c1, c2) = (choose(one - x * c3, c1), choose(half - x * c4, c2));
        Self { half_cos, half_sin, c1, c2, c3, e4, e5, e6 }
    }

    /// The row "dexp" of the table.
    pub fn dexp(&self) -> Coaxial<T> {
        let minus_two = T::from_f64(-2.0);
        Coaxial { a: self.c1, b: self.c2, c: self.c3, b_slope: minus_two * self.e4, c_slope: minus_two * self.e5 }
    }

    /// The row "dexp⁻¹" of the table.
    pub fn dexp_inverse(&self) -> Coaxial<T> {
        let half = T::from_f64(0.5);
        Coaxial {
            a: half * self.c1 / self.c2,
            b: -half,
            c: self.e4 / self.c2,
            b_slope: T::zero(),
            c_slope: self.e6 / self.c2,
        }
    }
}

/// `Σ w_j (−x)^j/(k+2j)!` in Horner's form, with weights `w_j = 1` or `j+1` for `order` 1 or 2.
#[inline(always)]
fn series<T: Real>(k: u32, order: u32, x: T) -> T {
    let number = |n: u32| T::from_f64(f64::from(n));
    let mut sum = T::one();
    for j in (1..TERMS).rev() {
        let last = k + 2 * j;
        sum = T::one() - x * number(j + order - 1) / number(j * last * (last - 1)) * sum;
    }
    sum / number((1..=k).product())
}

/// A map `M(φ)` of the header.
pub(super) struct Coaxial<T> {
    a: T,
    b: T,
    c: T,
    b_slope: T,
    c_slope: T,
}

impl<T: Real> Coaxial<T> {
    /// `M(φ) y`, by the form in which nothing cancels at |φ| = π.
    pub fn apply(&self, phi: Vector3<T>, y: Vector3<T>) -> Vector3<T> {
        y * self.a + phi.cross(&y) * self.b + phi * (phi.dot(&y) * self.c)
    }

    /// The derivative of `M(φ) y` in φ along `direction`.
    pub fn apply_slope(&self, phi: Vector3<T>, direction: Vector3<T>, y: Vector3<T>) -> Vector3<T> {
        let (turned, along) = (phi.cross(&y), phi.dot(&direction));
        let slope = y * (self.b_slope * along) + turned * (self.c_slope * along) + direction.cross(&y) * self.c;
        direction.cross(&(y * self.b + turned * self.c)) + phi.cross(&slope)
    }
}
