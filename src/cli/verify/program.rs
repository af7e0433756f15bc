//! The program around generated code: reads states, writes answers, measures times. Native bits, little-endian.
//!
//! `frs verify` compiles this file, after a line `mod robot;` and the definitions that depend on the robot: `Element`,
//! `Number`, `State`, `LANES`, `pack`, `unpack`, `FUNCTIONS`.

use std::io::{self, ErrorKind, Read, Write};

/// Straight-line code of large robots keeps much on the stack.
const STACK: usize = 256 << 20;

fn main() {
    let server = std::thread::Builder::new().stack_size(STACK).spawn(serve).unwrap();
    server.join().unwrap().unwrap();
}

/// Answers blocks of states until there are no more. A block is the number of its groups of `LANES` states, what to do
/// with them (0: answer, 1: measure), and the states.
fn serve() -> io::Result<()> {
    let (mut input, mut output) = (io::stdin().lock(), io::stdout().lock());
    let mut head = [0; 8];
    loop {
        match input.read_exact(&mut head) {
            Err(error) if error.kind() == ErrorKind::UnexpectedEof => return Ok(()),
            result => result?,
        }
        let [groups, measure] = [0, 4].map(|at| u32::from_le_bytes(head[at..at + 4].try_into().unwrap()));
        let states = (0..groups).map(|_| read(&mut input)).collect::<io::Result<Vec<State>>>()?;
        let mut answer = Vec::new();
        for function in FUNCTIONS {
            if measure == 0 {
                function(&states, Some(&mut answer));
            } else {
                answer.extend(time::nanoseconds(|| function(&states, None)).to_le_bytes());
            }
        }
        output.write_all(&answer)?;
        output.flush()?;
    }
}

/// A group of states, side by side.
fn read(input: &mut impl Read) -> io::Result<State> {
    const BYTES: usize = size_of::<Element>();
    let mut lanes = [[0.0; INPUTS]; LANES];
    for number in lanes.as_flattened_mut() {
        let mut bytes = [0; BYTES];
        input.read_exact(&mut bytes)?;
        *number = Element::from_le_bytes(bytes);
    }
    Ok(std::array::from_fn(|entry| pack(lanes.map(|lane| lane[entry]))))
}

/// Lane after lane of each number.
fn write(answer: &mut Vec<u8>, numbers: &[Number]) {
    for number in numbers {
        answer.extend(unpack(*number).iter().flat_map(|lane| lane.to_le_bytes()));
    }
}

/// An array of a state.
fn part<const N: usize>(state: &State, start: usize) -> &[Number; N] {
    state[start..start + N].try_into().unwrap()
}
