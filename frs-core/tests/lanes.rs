//! Every lane has the bits of the plain number, in each operation and in the core.

use frs_core::lanes::{F32x8, F32x16, F64x4, F64x8};
use frs_core::spatial::{Twist, Wrench};
use frs_core::{Model, Real, Workspace};
use nalgebra::DMatrix;
use num_traits::{One, Zero};
use proptest::prelude::*;

/// Asserts equal bits in all lanes; where the plain number is not a number, neither may the lane be one.
macro_rules! assert_lanes {
    ($found:expr, $expected:expr, $what:expr) => {
        for (found, expected) in $found.to_array().into_iter().zip($expected) {
            let same = found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan());
            assert!(same, "{}: {found:e} is not {expected:e}", $what);
        }
    };
}

/// Asserts an operator with lanes, and with a plain number on either side.
macro_rules! assert_operator {
    ($Lanes:ident, $x:ident $operator:tt $y:ident, $assign:tt) => {{
        let (a, b) = ($Lanes::from_array($x), $Lanes::from_array($y));
        let each = |f: &dyn Fn(usize) -> _| std::array::from_fn::<_, { $Lanes::LANES }, _>(|i| f(i));
        let what = format!("{:?} {} {:?}", $x, stringify!($operator), $y);
        assert_lanes!(a $operator b, each(&|i| $x[i] $operator $y[i]), what);
        assert_lanes!(a $operator $y[0], each(&|i| $x[i] $operator $y[0]), what);
        assert_lanes!($x[0] $operator b, each(&|i| $x[0] $operator $y[i]), what);
        let (mut by_lanes, mut by_one) = (a, a);
        by_lanes $assign b;
        by_one $assign $y[0];
        assert_lanes!(by_lanes, each(&|i| $x[i] $operator $y[i]), what);
        assert_lanes!(by_one, each(&|i| $x[i] $operator $y[0]), what);
    }};
}

macro_rules! assert_operations {
    ($test:ident, $Lanes:ident, $element:ident, $tiny:literal, $huge:literal, $width:ident) => {
        #[test]
        fn $test() {
            let check = |x: [$element; $Lanes::LANES], y: [$element; $Lanes::LANES]| {
                assert_operator!($Lanes, x + y, +=);
                assert_operator!($Lanes, x - y, -=);
                assert_operator!($Lanes, x * y, *=);
                assert_operator!($Lanes, x / y, /=);
                let (a, b) = ($Lanes::from_array(x), $Lanes::from_array(y));
                assert_lanes!(-a, x.map(|x| -x), "negation");
                // What the product's own rounding leaves, and a sum.
                for z in [std::array::from_fn(|i| -(x[i] * y[i])), y] {
                    let expected = std::array::from_fn::<_, { $Lanes::LANES }, _>(|i| x[i].mul_add(y[i], z[i]));
                    assert_lanes!(Real::mul_add(a, b, $Lanes::from_array(z)), expected, "mul_add");
                }
                assert_lanes!(Real::sqrt(a), x.map($element::sqrt), "sqrt");
                let (sin, cos) = Real::sin_cos(a);
                assert_lanes!(sin, x.map(|x| Real::sin_cos(x).0), "sin");
                assert_lanes!(cos, x.map(|x| Real::sin_cos(x).1), "cos");
                assert_lanes!(Real::atan2(a, b), std::array::from_fn::<_, { $Lanes::LANES }, _>(|i| x[i].atan2(y[i])), "atan2");
                // Above y is a limit that single precision cannot hold.
                let limit = f64::from(y[0]);
                for limit in [0.0, limit, limit.next_up()] {
                    let expected = std::array::from_fn::<_, { $Lanes::LANES }, _>(|i| x[i].select_below(limit, x[i], y[i]));
                    assert_lanes!(Real::select_below(a, limit, a, b), expected, "select_below");
                }
            };
            let hard: [$element; 16] = [
                0.0, -0.0, 1.0, -1.0, 0.1, -0.1, 3.0, std::f64::consts::PI as $element, $tiny, -$tiny, $huge, -$huge,
                $element::MIN_POSITIVE, -$element::from_bits(1), $element::MAX, 1.0 + $element::EPSILON,
            ];
            for first in 0..hard.len() {
                for second in 0..hard.len() {
                    // Lane i holds another pair; over all shifts every lane sees every pair.
                    let at = |shift: usize| std::array::from_fn(|i| hard[(shift + i * i) % hard.len()]);
                    check(at(first), at(second));
                }
            }
            let any = || prop::num::$element::NORMAL | prop::num::$element::SUBNORMAL | prop::num::$element::ZERO;
            let lanes = || prop_oneof![prop::array::$width(any()), prop::array::$width(-4.0..4.0 as $element)];
            proptest!(|(x in lanes(), y in lanes())| check(x, y));
        }
    };
}

assert_operations!(four_doubles_have_the_bits_of_one, F64x4, f64, 1e-300, 1e300, uniform4);
assert_operations!(eight_doubles_have_the_bits_of_one, F64x8, f64, 1e-300, 1e300, uniform8);
assert_operations!(eight_singles_have_the_bits_of_one, F32x8, f32, 1e-37, 1e37, uniform8);
assert_operations!(sixteen_singles_have_the_bits_of_one, F32x16, f32, 1e-37, 1e37, uniform16);

#[test]
fn constants_are_the_nearest_numbers_in_every_lane() {
    assert_eq!(F64x4::from_f64(0.1).to_array(), [0.1; 4]);
    assert_eq!(F32x8::from_f64(0.1).to_array(), [0.1_f32; 8]);
    assert_eq!(F64x8::one().to_array(), [1.0; 8]);
    assert!(F64x8::zero().is_zero());
    assert!(!F64x8::from_array([0.0, 0.0, 0.0, 1e-300, 0.0, 0.0, 0.0, 0.0]).is_zero());
}

const LWR_SATELLITE: &str = include_str!("../../robots/lwr_satellite.urdf");
const QUADRUPED: &str = include_str!("../../robots/quadruped.urdf");

/// Λ_q, D_μ and ξ̇ at a state: q, q̇, τ (n each), μ, F₁.
fn answers<T: Real>(model: &Model<T>, state: &[T]) -> Vec<T> {
    let n = model.dof();
    let nothing = T::from_f64(f64::NAN);
    let (mut inertia, mut d_mu) = (DMatrix::repeat(n, n, nothing), DMatrix::repeat(6 + n, 6 + n, nothing));
    let mut xi_dot = vec![nothing; 6 + n];
    let [q, qd, tau] = [0, 1, 2].map(|part| &state[part * n..(part + 1) * n]);
    let six = |first: usize| std::array::from_fn(|i| state[first + i]);
    let (mu, wrench) = (Twist::from_array(six(3 * n)), Wrench::from_array(six(3 * n + 6)));
    let mut work = Workspace::new(model);
    let mut shape = work.shape(q);
    shape.shape_inertia(&mut inertia);
    shape.d_mu(mu, &mut d_mu);
    shape.moving(qd).forward_dynamics_articulated(mu, wrench, tau, &mut xi_dot);
    inertia.iter().chain(&d_mu).chain(&xi_dot).copied().collect()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(32) })]

    #[test]
    fn eight_states_at_once_are_eight_states(numbers in prop::collection::vec(prop::array::uniform8(-3.0..3.0), 3 * 12 + 12)) {
        for urdf in [LWR_SATELLITE, QUADRUPED] {
            let model = Model::from_urdf(urdf).unwrap();
            let size = 3 * model.dof() + 12;
            let state: Vec<F64x8> = numbers[..size].iter().copied().map(F64x8::from_array).collect();
            let found = answers(&model.cast::<F64x8>(), &state);
            for lane in 0..8 {
                let state: Vec<f64> = numbers[..size].iter().map(|lanes| lanes[lane]).collect();
                let expected: Vec<u64> = answers(&model, &state).iter().map(|number| number.to_bits()).collect();
                let found: Vec<u64> = found.iter().map(|lanes| lanes.to_array()[lane].to_bits()).collect();
                prop_assert_eq!(found, expected);
            }
        }
    }
}
