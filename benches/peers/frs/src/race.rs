//! All our contestants of one robot.

use std::env;
use std::error::Error;
use std::fs;
use std::thread;

use frs_core::lanes::{F64x4, F64x8};
use frs_core::{Model, Quantity};

use crate::core::Core;
use crate::ready::Ready;
use crate::serve::{Named, serve};
use crate::states::{State, states};

/// Straight-line code of large robots keeps much on the stack.
const STACK: usize = 256 << 20;

/// Arguments of every program, in this order.
const ARGUMENTS: &str =
    "expected ROBOT.urdf, its states, and the quantities to compile at run time, with commas between";

/// Serves the core in all widths, code compiled at run time, and what `generated` adds.
///
/// # Errors
/// If an argument is missing or names nothing.
pub fn race(generated: fn(&[State]) -> Vec<Named<'static>>) -> Result<(), Box<dyn Error + Send + Sync>> {
    let server = thread::Builder::new().stack_size(STACK).spawn(move || all(generated))?;
    server.join().map_err(|_| "the server panicked")?
}

fn all(generated: fn(&[State]) -> Vec<Named<'static>>) -> Result<(), Box<dyn Error + Send + Sync>> {
    let mut arguments = env::args().skip(1);
    let mut argument = || arguments.next().ok_or(ARGUMENTS);
    let model = Model::from_urdf(&fs::read_to_string(argument()?)?)?;
    let (four, eight): (Model<F64x4>, Model<F64x8>) = (model.cast(), model.cast());
    let states = states(&argument()?, model.dof())?;
    let asked = argument()?;
    let mut contestants: Vec<Named<'_>> = vec![
        ("core", Box::new(Core::new(&model, &states))),
        ("core_4", Box::new(Core::new(&four, &states))),
        ("core_8", Box::new(Core::new(&eight, &states))),
    ];
    let quantities: Vec<Quantity> =
        Quantity::ALL.into_iter().filter(|quantity| asked.split(',').any(|name| name == quantity.name())).collect();
    if !quantities.is_empty() {
        let robot = frs_jit::Robot::new(&model, &quantities)?;
        contestants.push(("compiled", Box::new(Ready::new(robot, &states))));
    }
    contestants.extend(generated(&states));
    Ok(serve(contestants)?)
}
