//! A term of a sum of products is rounded once in a build with the feature `fused`, twice in any other.

use frs_codegen::record::{Operation, Recorded, record};
use frs_core::lanes::{F32x8, F32x16, F64x4, F64x8};
use frs_core::spatial::{Twist, Wrench};
use frs_core::{FUSED, Real};

/// `(1 + ε)² − (1 + 2ε)`, by either sign and within a power: ε², which a product that is rounded by itself has lost.
fn rests<T: Real>(epsilon: f64) -> [T; 3] {
    let [x, most] = [1.0 + epsilon, 1.0 + 2.0 * epsilon].map(T::from_f64);
    let (zero, one) = (T::zero(), T::one());
    let (twist, wrench) = ([zero, zero, one, x, zero, zero], [zero, zero, -most, x, zero, zero]);
    [(-most).plus_product(x, x), -most.minus_product(x, x), Twist::from_array(twist).dot(Wrench::from_array(wrench))]
}

#[test]
fn numbers_and_lanes_round_as_the_build_says() {
    let expected = |epsilon: f64| if FUSED { epsilon * epsilon } else { 0.0 };
    let double = expected(f64::EPSILON);
    assert_eq!(rests::<f64>(f64::EPSILON), [double; 3]);
    assert_eq!(rests::<F64x4>(f64::EPSILON), [F64x4::splat(double); 3]);
    assert_eq!(rests::<F64x8>(f64::EPSILON), [F64x8::splat(double); 3]);
    let epsilon = f64::from(f32::EPSILON);
    let single = expected(epsilon) as f32;
    assert_eq!(rests::<f32>(epsilon), [single; 3]);
    assert_eq!(rests::<F32x8>(epsilon), [F32x8::splat(single); 3]);
    assert_eq!(rests::<F32x16>(epsilon), [F32x16::splat(single); 3]);
}

#[test]
fn recordings_hold_what_the_build_rounds() {
    let (_, tape) = record(|| rests::<Recorded>(f64::EPSILON));
    let fused = tape.iter().filter(|operation| matches!(operation, Operation::MulAdd(..))).count();
    // One in each of the first two, five terms after the first in the power.
    assert_eq!(fused, if FUSED { 7 } else { 0 });
}

#[test]
fn the_feature_is_the_constant() {
    assert_eq!(FUSED, cfg!(feature = "fused"));
}
