//! What is folded of vectors keeps the bits of every lane.

mod side_by_side;

use frs_codegen::record::{Operation, Place, Tape};
use frs_codegen::{Graph, Precision};
use side_by_side::replay;

const INPUTS: u32 = 6;

/// A random recording, and which of its places are vectors; how often each kind occurs favours what can be folded.
fn recording(random: &mut fastrand::Rng, len: usize) -> (Tape, Vec<Place>) {
    const CONSTANTS: [f64; 6] = [0.0, -0.0, 1.0, -1.0, 0.5, -2.5];
    let mut tape: Tape = (0..INPUTS).map(Operation::Input).collect();
    tape.extend(CONSTANTS.map(Operation::constant));
    let mut numbers: Vec<Place> = (0..tape.len() as Place).collect();
    let mut vectors: Vec<Place> = Vec::new();
    while tape.len() < len {
        let place = tape.len() as Place;
        let number = |random: &mut fastrand::Rng| numbers[random.usize(..numbers.len())];
        if vectors.is_empty() || random.u8(..4) == 0 {
            let several: [Place; 4] = std::array::from_fn(|_| number(random));
            let lanes = || numbers.windows(4).rev().map(|all| [all[0], all[1], all[2], all[3]]);
            let of_one_vector = |all: &[Place; 4]| all.iter().all(|&p| matches!(tape[p as usize], Operation::Lane(..)));
            tape.push(match random.u8(..4) {
                0 => Operation::Splat(several[0]),
                // What was taken apart last, put together again.
                1 | 2 => Operation::Gather(lanes().find(of_one_vector).unwrap_or(several)),
                _ => Operation::Gather(several),
            });
            vectors.push(place);
            continue;
        }
        let vector = vectors[random.usize(..vectors.len())];
        if random.u8(..4) == 0 {
            // All lanes, in their order or another one.
            let turn = random.u8(..2) * random.u8(..4);
            for lane in 0..4 {
                numbers.push(tape.len() as Place);
                tape.push(Operation::Lane(vector, (lane + turn) % 4));
            }
            continue;
        }
        let of_vectors = random.bool();
        let [a, b] = if of_vectors {
            [vector, vectors[random.usize(..vectors.len())]]
        } else {
            // Neighbours are often lanes of two vectors.
            let first = random.usize(..numbers.len());
            [numbers[first], numbers[(first + [1, 4][random.usize(..2)]) % numbers.len()]]
        };
        tape.push(match random.u8(..6) {
            0 => Operation::Neg(a),
            1 | 2 => Operation::Add(a, b),
            3 => Operation::Sub(a, b),
            _ => Operation::Mul(a, b),
        });
        if of_vectors { &mut vectors } else { &mut numbers }.push(place);
    }
    (tape, vectors)
}

#[test]
fn a_folded_recording_of_vectors_is_the_recording() {
    let mut random = fastrand::Rng::with_seed(9);
    let (mut compared, mut folded) = (0, 0);
    for _ in 0..5000 {
        let (tape, vectors) = recording(&mut random, 80);
        let mut graph = Graph::new(Precision::Double);
        let places = graph.absorb(&tape);
        let inputs: Vec<f64> = (0..INPUTS).map(|_| random.f64() * 4.0 - 2.0).collect();
        let (expected, actual) = (replay(&tape, &inputs), replay(graph.operations(), &inputs));
        if !expected.iter().all(|value| value.to_array().iter().all(|number| number.is_finite())) {
            continue;
        }
        for (place, (expected, &to)) in expected.iter().zip(&places).enumerate() {
            assert_eq!(
                graph.is_vector(to),
                vectors.contains(&(place as Place)),
                "{place}: {:?} in {tape:?}",
                tape[place]
            );
            // 0 has no sign.
            let [expected, actual] = [*expected, actual[to as usize]].map(|value| (value + 0.0).to_array());
            assert_eq!(expected.map(f64::to_bits), actual.map(f64::to_bits), "{place}: {:?} in {tape:?}", tape[place]);
        }
        compared += 1;
        folded += tape.len() - graph.operations().len().min(tape.len());
    }
    assert!(compared > 3000 && folded > 20 * compared, "{compared} recordings, {folded} operations folded");
}
