//! Any recording, compiled, has the bits of its operations performed one by one.

use frs_codegen::record::{Operation, Place, replay};
use frs_jit::{Code, JitError};

/// Numbers that each random recording reads.
const INPUTS: usize = 5;

/// Constants at which something is folded, and others.
const CONSTANTS: [f64; 9] = [0.0, -0.0, 1.0, -1.0, 2.0, -0.5, 1e-300, 5e-324, 0.1];

/// A random recording of `len` operations. Operands are near or anywhere, so that some values wait for long.
fn tape(random: &mut fastrand::Rng, len: u32) -> Vec<Operation> {
    let mut tape: Vec<Operation> = (0..INPUTS as u32).map(Operation::Input).collect();
    for place in INPUTS as u32..len {
        let mut at = || if random.bool() { random.u32(place.saturating_sub(6)..place) } else { random.u32(..place) };
        let (a, b, c) = (at(), at(), at());
        tape.push(match random.u32(..27) {
            0 => Operation::constant(CONSTANTS[random.usize(..CONSTANTS.len())]),
            1 => Operation::Sin(a),
            2 => Operation::Cos(a),
            3 => Operation::Neg(a),
            4 => Operation::Sqrt(a),
            5 => Operation::Div(a, b),
            6..13 => Operation::Add(a, b),
            13..18 => Operation::Sub(a, b),
            18..21 => Operation::MulAdd(a, b, c),
            _ => Operation::Mul(a, b),
        });
    }
    tape
}

/// Compares the finite outputs of compiled code with the recording's, at several inputs; returns how many there were.
///
/// An output counts where everything recorded is finite: `x·0` is folded to 0 whatever x is.
fn compared(random: &mut fastrand::Rng, tape: &[Operation], outputs: &[Place], code: &mut Code) -> usize {
    let mut compared = 0;
    for _ in 0..10 {
        let inputs: [f64; INPUTS] = std::array::from_fn(|_| random.f64() * 4.0 - 2.0);
        let values = replay(tape, &inputs);
        let mut actual = vec![f64::NAN; outputs.len()];
        code.call(&inputs, &mut actual);
        let finite = finite(tape, &values);
        for (&output, actual) in outputs.iter().zip(actual) {
            if finite[output as usize] {
                let expected = values[output as usize] + 0.0;
                assert_eq!(expected.to_bits(), actual.to_bits(), "place {output}: {expected:e}, {actual:e}\n{tape:?}");
                compared += 1;
            }
        }
    }
    compared
}

/// Which places stand on finite numbers only.
fn finite(tape: &[Operation], values: &[f64]) -> Vec<bool> {
    let mut finite: Vec<bool> = Vec::new();
    for (operation, value) in tape.iter().zip(values) {
        finite.push(value.is_finite() && operation.operands().all(|operand| finite[operand as usize]));
    }
    finite
}

#[test]
fn short_recordings_have_the_bits_of_their_operations() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut seen = 0;
    for _ in 0..300 {
        let len = random.u32(6..120);
        let tape = tape(&mut random, len);
        // Inputs, constants, sines, and places that are asked for twice.
        let outputs: Vec<Place> = (0..20).map(|_| random.u32(..len)).collect();
        let mut code = Code::compile(&tape, &outputs, INPUTS).unwrap();
        seen += compared(&mut random, &tape, &outputs, &mut code);
    }
    // Of 300 × 20 × 10.
    assert!(seen > 20_000, "only {seen} outputs were finite");
}

/// A recording of `len` operations whose numbers all stay within ±2, as its inputs do; a sine now and then.
fn long(len: u32) -> (Vec<Operation>, Vec<Place>) {
    let mut random = fastrand::Rng::with_seed(u64::from(len));
    let mut tape: Vec<Operation> = (0..INPUTS as u32).map(Operation::Input).collect();
    tape.push(Operation::constant(0.5));
    let half = INPUTS as Place;
    let mut known: Vec<Place> = (0..half).collect();
    while tape.len() < len as usize {
        let (a, b) =
            (known[random.usize(..known.len())], known[random.usize(known.len().saturating_sub(40)..known.len())]);
        match random.u32(..500) {
            0 => tape.push(Operation::Sin(a)),
            // Half a sum, a difference, a product.
            choice => {
                tape.push([Operation::Add(a, b), Operation::Sub(a, b), Operation::Mul(a, b)][choice as usize % 3]);
                tape.push(Operation::Mul(tape.len() as Place - 1, half));
            }
        }
        known.push(tape.len() as Place - 1);
    }
    let outputs = (len / 2..len).step_by(7).collect();
    (tape, outputs)
}

#[test]
fn a_long_recording_has_the_bits_of_its_operations() {
    let (tape, outputs) = long(30_000);
    let mut code = Code::compile(&tape, &outputs, INPUTS).unwrap();
    let seen = compared(&mut fastrand::Rng::with_seed(2), &tape, &outputs, &mut code);
    assert_eq!(seen, 10 * outputs.len(), "all are finite");
}

#[test]
fn code_grows_with_the_operations_and_no_faster() {
    // A chain without a sine: x ← x·a + b.
    let bytes = |len: u32| {
        let mut tape: Vec<Operation> = (0..INPUTS as u32).map(Operation::Input).collect();
        let mut last = 0;
        while tape.len() < len as usize {
            tape.push(Operation::Mul(last, 1));
            last = tape.len() as Place;
            tape.push(Operation::Add(last - 1, 2));
        }
        let code = Code::compile(&tape, &[last], INPUTS).unwrap();
        assert!(code.operations() + INPUTS >= len as usize);
        code.bytes()
    };
    // What stands around each function is all that differs.
    let (short, long) = (bytes(10_000), bytes(40_000));
    assert!(long < 4 * short + short / 10, "{short} bytes, then {long}");
}

#[test]
fn what_is_not_read_is_not_performed() {
    let tape = [Operation::Input(0), Operation::Sqrt(0), Operation::Neg(0), Operation::Sqrt(2)];
    assert_eq!(Code::compile(&tape, &[1], 1).unwrap().operations(), 1);
    assert_eq!(Code::compile(&tape, &[], 1).unwrap().operations(), 0);
}

#[test]
fn a_recording_that_reads_what_is_not_there_is_refused() {
    let unknown = |tape: &[Operation]| Code::compile(tape, &[0], 1).unwrap_err().to_string();
    assert!(unknown(&[Operation::Input(1)]).contains("place 0: Input(1) reads what is not there"));
    assert!(unknown(&[Operation::Input(0), Operation::Add(0, 1)]).contains("place 1: Add(0, 1)"));
    let error = Code::compile(&[Operation::Input(0)], &[1], 1).unwrap_err();
    assert!(matches!(error, JitError::NoPlace { place: 1, len: 1 }), "{error}");
}

#[test]
fn a_recording_of_vectors_is_refused() {
    let error = Code::compile(&[Operation::Input(0), Operation::Splat(0), Operation::Lane(1, 0)], &[2], 1).unwrap_err();
    assert!(matches!(error, JitError::Vector { place: 1, .. }), "{error}");
}

#[test]
fn more_than_can_be_counted_is_refused() {
    let error = Code::compile(&[], &[], usize::MAX).unwrap_err();
    assert!(matches!(error, JitError::TooMany { what: "inputs", .. }), "{error}");
    let error = Code::compile_slices(&[], &[], &[1; 9]).unwrap_err();
    assert!(error.to_string().contains("9 slices of inputs are too many; expected at most 8"), "{error}");
}

#[test]
#[should_panic(expected = "must have the lengths")]
fn inputs_of_another_length_are_refused() {
    let mut code = Code::compile(&[Operation::Input(0)], &[0], 2).unwrap();
    code.call(&[1.0], &mut [0.0]);
}
