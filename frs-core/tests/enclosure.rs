//! Intervals against 256-bit numbers: what they must hold, and how little else.

#[allow(dead_code, reason = "other tests use other parts of it")]
mod extended;

use std::f64::consts::{FRAC_PI_2, PI};

use extended::Big;
use extended::judge::Random;
use frs_core::Real;
use frs_core::enclosure::Interval;
use num_traits::Zero;

/// Numbers at which doubles are unlike others, and random ones of all sizes.
fn numbers() -> Vec<f64> {
    let mut random = Random(17);
    let edges = [0.0, 1.0, 3.0, 5e-324, 1e-310, 1e-290, 1e-200, 1e200, 1e300, f64::MAX, FRAC_PI_2];
    let sizes = [-300.0, -250.0, -100.0, -8.0, -1.0, 0.0, 0.0, 1.0, 8.0, 100.0, 250.0, 300.0];
    let drawn = sizes.map(|power| 10.0_f64.powf(power) * (1.5 + random.number()));
    edges.into_iter().chain(drawn).flat_map(|x| [x, -x]).collect()
}

/// Above this, nothing is lost to underflow.
const NEVER_LOST: f64 = 1e-276;

/// `exact` lies within, and no double lies within beside its neighbours.
#[track_caller]
fn tight(got: Interval, exact: &Big) {
    holds(got, exact);
    let inner = got.lower().next_up();
    assert!(inner >= got.upper() || !inner.is_normal(), "{got:?} is wider than it must be");
}

#[track_caller]
fn holds(got: Interval, exact: &Big) {
    let below = got.lower() == f64::NEG_INFINITY || Big::new(got.lower()) <= *exact;
    let above = got.upper() == f64::INFINITY || *exact <= Big::new(got.upper());
    assert!(below && above, "{got:?} does not hold {:e}", exact.to_f64());
}

#[test]
fn of_single_numbers_the_result_is_between_neighbours() {
    for a in numbers() {
        for b in numbers() {
            let (x, y) = (Interval::from(a), Interval::from(b));
            let (a, b) = (Big::new(a), Big::new(b));
            tight(x + y, &(a.clone() + b.clone()));
            tight(x - y, &(a.clone() - b.clone()));
            let product = a.clone() * b.clone();
            if product.abs() > Big::new(NEVER_LOST) {
                tight(x * y, &product)
            } else {
                holds(x * y, &product)
            }
            if !b.is_zero() {
                let quotient = a.clone() / b.clone();
                let kept = quotient.abs() > Big::new(NEVER_LOST) && a.abs() > Big::new(NEVER_LOST);
                if kept { tight(x / y, &quotient) } else { holds(x / y, &quotient) }
            }
        }
        let (root, exact) = (Interval::from(a.abs()).sqrt(), Big::new(a.abs()).sqrt());
        if a.abs() > NEVER_LOST { tight(root, &exact) } else { holds(root, &exact) }
    }
}

/// An interval around `middle`, as wide as chance has it.
fn wide(middle: f64, random: &mut Random) -> Interval {
    Interval::from(middle) + wide_by(middle.abs() * 10.0_f64.powf(-8.0 * random.number().abs()))
}

/// ±`half`.
fn wide_by(half: f64) -> Interval {
    // 1/3 lies between doubles: what it differs from itself by is an interval around 0.
    let third = Interval::from(1.0) / Interval::from(3.0);
    let zero = third + -third;
    zero * Interval::from(half / zero.upper())
}

/// Numbers of an interval: its ends and some between.
fn members(interval: Interval) -> Vec<f64> {
    let (lower, upper) = (interval.lower(), interval.upper());
    let inside = (1..8).map(|k| lower + (upper - lower) * f64::from(k) / 8.0);
    [lower, upper].into_iter().chain(inside).filter(|x| interval.contains(*x)).collect()
}

#[test]
fn of_intervals_the_result_holds_that_of_every_member() {
    let mut random = Random(19);
    for _ in 0..300 {
        let [a, b] = [(); 2].map(|()| 4.0 * random.number());
        let (x, y) = (wide(a, &mut random), wide(b, &mut random));
        let (sin, cos) = x.sin_cos();
        let square = x * x + Interval::from(1e-3);
        for a in members(x) {
            let exact = Big::new(a);
            let (sin_exact, cos_exact) = exact.sin_cos();
            holds(sin, &sin_exact);
            holds(cos, &cos_exact);
            holds(square.sqrt(), &(exact.clone() * exact.clone() + Big::new(1e-3)).sqrt());
            for b in members(y) {
                let (a, b) = (exact.clone(), Big::new(b));
                holds(x + y, &(a.clone() + b.clone()));
                holds(x - y, &(a.clone() - b.clone()));
                holds(x * y, &(a.clone() * b.clone()));
                if !b.is_zero() {
                    holds(x / y, &(a.clone() / b.clone()));
                    holds(y.atan2(x), &b.atan2(&a));
                }
            }
        }
    }
}

/// Where sine and cosine turn, their intervals end at ±1; far out, and for wide arguments, they hold everything they must.
#[test]
fn sines_turn_where_they_must() {
    let around = |middle: f64, half: f64| Interval::from(middle) + wide_by(half);
    for k in -8..8 {
        let quarter = f64::from(k) * FRAC_PI_2;
        let (sin, cos) = around(quarter, 0.2).sin_cos();
        let turned = if k % 2 == 0 { cos } else { sin };
        assert!(turned.contains(1.0) != turned.contains(-1.0), "{k}: {turned:?}");
        assert!(turned.upper() <= 1.0 && turned.lower() >= -1.0);
        let (sin_exact, cos_exact) = Big::new(quarter + 0.1).sin_cos();
        holds(sin, &sin_exact);
        holds(cos, &cos_exact);
    }
    for angle in [1e8, 1e15] {
        let (sin, _) = Interval::from(angle).sin_cos();
        holds(sin, &Big::new(angle).sin_cos().0);
        assert!(sin.upper() - sin.lower() < 1e-15, "{sin:?}");
    }
    for unknown in [Interval::from(1e17), around(0.0, 0.6), Interval::from(f64::NAN)] {
        let (sin, cos) = unknown.sin_cos();
        assert!([sin, cos].iter().all(|x| x.lower() == -1.0 && x.upper() == 1.0), "{unknown:?}");
    }
}

#[test]
fn what_is_not_bounded_is_everything() {
    let zero = wide_by(1.0);
    assert!(zero.lower() <= -1.0 && zero.upper() >= 1.0 && zero.upper() < 1.1);
    let one = Interval::from(1.0);
    for any in [one / zero, Interval::from(f64::NAN), one / Interval::zero(), one / zero + one] {
        assert!(any.lower() == f64::NEG_INFINITY && any.upper() == f64::INFINITY, "{any:?}");
    }
    assert_eq!(one / zero * Interval::zero(), Interval::zero());
    let angle = zero.atan2(-one);
    assert!(angle.contains(PI) && angle.contains(-PI));
    assert!(zero.sqrt().lower() == 0.0 && zero.sqrt().upper() >= 1.0);
}

#[test]
fn a_choice_that_is_not_known_is_both() {
    let (below, otherwise) = (Interval::from(-2.0), Interval::from(5.0));
    let chosen = |x: Interval| x.select_below(1.0, below, otherwise);
    assert_eq!(chosen(Interval::from(0.5)), below);
    assert_eq!(chosen(Interval::from(1.0)), otherwise);
    let both = chosen(Interval::from(1.0) + wide_by(0.1));
    assert_eq!((both.lower(), both.upper()), (-2.0, 5.0));
}
