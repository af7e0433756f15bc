//! Generated numbers against the core's, bit for bit.

use frs_codegen::{FunctionReport, Input};
use serde_json::{Value, json};

use super::element::Element;
use super::reference::part;

/// What was compared, function by function, and the first difference.
#[derive(Default)]
pub struct Comparison {
    /// One for each function.
    pub tallies: Vec<Tally>,
    /// The first difference, if there is one.
    pub first: Option<Difference>,
}

/// Numbers of a function.
#[derive(Clone, Copy, Default)]
pub struct Tally {
    /// How many were compared.
    pub compared: u64,
    /// How many differ.
    pub differences: u64,
    /// How many are not finite on both sides, and so count as equal.
    pub not_finite: u64,
}

/// Two numbers that should be one.
#[derive(Debug)]
pub struct Difference {
    function: String,
    entry: String,
    state: usize,
    inputs: Vec<(&'static str, Vec<f64>)>,
    generated: Number,
    core: Number,
}

/// A number with its bits.
#[derive(Debug)]
struct Number {
    value: f64,
    bits: u64,
    digits: usize,
}

impl Comparison {
    /// Nothing compared yet.
    pub fn new(functions: usize) -> Self {
        Self { tallies: vec![Tally::default(); functions], first: None }
    }

    /// Compares what function number `number` gives at a state with the core's answer.
    pub fn see<E: Element>(
        &mut self,
        (number, function): (usize, &FunctionReport),
        (state_number, state): (usize, &[E]),
        generated: impl Iterator<Item = E>,
        core: impl Iterator<Item = E>,
    ) {
        let tally = &mut self.tallies[number];
        for (entry, (generated, core)) in generated.zip(core).enumerate() {
            tally.compared += 1;
            if generated.bits() == core.bits() {
                continue;
            }
            if !generated.double().is_finite() && !core.double().is_finite() {
                tally.not_finite += 1;
                continue;
            }
            tally.differences += 1;
            self.first.get_or_insert_with(|| Difference {
                function: function.name.clone(),
                entry: entry_name(function, entry),
                state: state_number,
                inputs: function.inputs.iter().map(|input| (input.name, doubles(state, input))).collect(),
                generated: Number::new(generated),
                core: Number::new(core),
            });
        }
    }

    /// How many numbers differ.
    pub fn differences(&self) -> u64 {
        self.tallies.iter().map(|tally| tally.differences).sum()
    }
}

fn doubles<E: Element>(state: &[E], input: &Input) -> Vec<f64> {
    part(state, input).iter().map(|number| number.double()).collect()
}

/// The name of a number that a function writes: output, then row and column where there are several.
fn entry_name(function: &FunctionReport, mut entry: usize) -> String {
    for &(name, [rows, columns], layers) in &function.outputs {
        let len = rows * columns * layers;
        if entry >= len {
            entry -= len;
            continue;
        }
        let layer = if layers > 1 { [" x", " y", " z"][entry / (rows * columns)] } else { "" };
        let (row, column) = (entry % rows, entry / rows % columns);
        return match (rows, columns) {
            (1, 1) => format!("{name}{layer}"),
            (_, 1) => format!("{name}{layer}[{row}]"),
            _ => format!("{name}{layer}[{row}][{column}]"),
        };
    }
    unreachable!("the number of an entry lies within the outputs")
}

impl Number {
    fn new<E: Element>(number: E) -> Self {
        Self { value: number.double(), bits: number.bits(), digits: 2 * E::BYTES }
    }

    fn hexadecimal(&self) -> String {
        format!("0x{:0digits$x}", self.bits, digits = self.digits)
    }

    fn json(&self) -> Value {
        json!({ "value": self.value, "bits": self.hexadecimal() })
    }

    fn text(&self) -> String {
        format!("{:e} ({})", self.value, self.hexadecimal())
    }
}

impl Difference {
    /// For people.
    pub fn text(&self) -> String {
        let Self { function, entry, state, inputs, generated, core } = self;
        let inputs: String = inputs.iter().map(|(name, values)| format!("\n  {name} = {values:?}")).collect();
        format!(
            "{function}: {entry} at state {state}:\n  generated {}\n  core      {}{inputs}",
            generated.text(),
            core.text()
        )
    }

    /// For programs.
    pub fn json(&self) -> Value {
        let inputs: serde_json::Map<_, _> =
            self.inputs.iter().map(|(name, values)| ((*name).to_owned(), json!(values))).collect();
        json!({
            "function": self.function,
            "entry": self.entry,
            "state": self.state,
            "inputs": inputs,
            "generated": self.generated.json(),
            "core": self.core.json(),
        })
    }
}

#[cfg(test)]
mod tests {
    use frs::{Model, Quantity};
    use frs_codegen::{Options, generate};

    use super::*;

    fn inertia() -> FunctionReport {
        let model = Model::from_urdf(frs::urdf::LWR_SATELLITE).unwrap();
        let options = Options { outputs: Some(vec![Quantity::Inertia]), ..Options::default() };
        generate(&model, &options).unwrap().functions.remove(0)
    }

    #[test]
    fn a_flipped_bit_is_found_and_named() {
        let function = inertia();
        let state = [0.25; 7];
        let core: Vec<f64> = (0..36 + 42 + 49).map(f64::from).collect();
        let mut generated = core.clone();
        // Entry (4, 2) of the 6×7 connection, which follows the 6×6 locked inertia.
        let place = 36 + 2 * 6 + 4;
        generated[place] = f64::from_bits(core[place].to_bits() ^ 1);
        let mut comparison = Comparison::new(1);
        comparison.see((0, &function), (17, &state), generated.into_iter(), core.into_iter());
        assert_eq!((comparison.tallies[0].compared, comparison.differences()), (127, 1));
        let first = comparison.first.unwrap();
        assert_eq!((first.entry.as_str(), first.state), ("connection[4][2]", 17));
        assert!(first.text().contains("(0x404a000000000001)"), "{}", first.text());
        assert_eq!(first.json()["core"]["bits"], "0x404a000000000000");
    }

    #[test]
    fn a_number_that_is_finite_on_one_side_only_differs() {
        let function = inertia();
        let both = |generated: f64, core: f64| {
            let mut comparison = Comparison::new(1);
            comparison.see((0, &function), (0, &[0.0; 7]), [generated].into_iter(), [core].into_iter());
            (comparison.tallies[0].differences, comparison.tallies[0].not_finite)
        };
        assert_eq!(both(f64::INFINITY, f64::NAN), (0, 1));
        assert_eq!(both(1.0, f64::NAN), (1, 0));
        assert_eq!(both(f64::INFINITY, 1.0), (1, 0));
        assert_eq!(both(0.0, -0.0), (1, 0));
    }
}
