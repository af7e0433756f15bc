//! Which quantity is written in which form, where the generator chooses.

use frs_core::{Model, Quantity};

use crate::error::GenerateError;
use crate::home::live;
use crate::options::{Form, Lanes, Options};
use crate::program::Program;
use crate::report::Counts;
use crate::simplify::Precision;

/// Bytes of machine code that a call in a form may take.
///
/// A processor's first cache holds 32 KiB. The hybrid form, half as long, takes over there; it was faster than the core's loops up to 48 KiB, and no slower
/// when nothing was at hand. In lanes a call is for several states, and twice as much still paid (docs/generated.md).
fn room(form: Form, options: &Options) -> usize {
    const KIB: usize = 1024;
    match (form, options.lanes, options.precision) {
        (Form::Unrolled, Lanes::One, Precision::Double) => 32 * KIB,
        (_, Lanes::One, _) => 48 * KIB,
        _ => 96 * KIB,
    }
}

/// Each form that is used, with its quantities in the order of `quantities`.
///
/// # Errors
/// If options exclude the form, or a number is too large for the scalar.
pub fn choose(
    model: &Model,
    options: &Options,
    quantities: Vec<Quantity>,
) -> Result<Vec<(Form, Vec<Quantity>)>, GenerateError> {
    if options.form != Form::Auto {
        for &quantity in &quantities {
            options.allows(options.form, quantity)?;
        }
        return Ok(vec![(options.form, quantities)]);
    }
    let mut chosen = [Form::Unrolled, Form::Hybrid, Form::Tabled].map(|form| (form, Vec::new()));
    for quantity in quantities {
        // The first that fits, else the last one.
        let mut place = &mut Vec::new();
        for (form, quantities) in chosen.iter_mut().filter(|(form, _)| options.allows(*form, quantity).is_ok()) {
            place = quantities;
            if *form == Form::Tabled
                || code_bytes(model, &Options { form: *form, ..options.clone() }, quantity)? <= room(*form, options)
            {
                break;
            }
        }
        place.push(quantity);
    }
    Ok(chosen.into_iter().filter(|(_, quantities)| !quantities.is_empty()).collect())
}

/// Predicted machine code of a quantity by itself.
fn code_bytes(model: &Model, options: &Options, quantity: Quantity) -> Result<usize, GenerateError> {
    let program = Program::of(&[quantity], model, options)?;
    let live = live(&program);
    let places = (0..).zip(live).filter_map(|(place, live)| live.then_some(place));
    Ok(Counts::of(&program.graph, places).code_bytes())
}
