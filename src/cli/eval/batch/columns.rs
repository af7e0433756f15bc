//! Names of the numbers of arguments, as columns of tables.

use frs::{Argument, Model};

const TWIST: [&str; 6] = ["omega_x", "omega_y", "omega_z", "v_x", "v_y", "v_z"];
const WRENCH: [&str; 6] = ["moment_x", "moment_y", "moment_z", "force_x", "force_y", "force_z"];
const AXES: [&str; 3] = ["x", "y", "z"];
/// Columns of a pose [R p].
const POSE: [&str; 4] = ["x", "y", "z", "p"];

/// A name for each number: `q.elbow`, `mu.omega_x`, `connection.omega_x.elbow`, row before column, `kinetic_energy`.
pub fn names(arguments: impl Iterator<Item = Argument>, model: &Model) -> Vec<String> {
    arguments.flat_map(|argument| of_argument(&argument, model)).collect()
}

/// The arguments with their lengths, as a message tells them.
pub fn lengths(arguments: impl Iterator<Item = Argument>, model: &Model) -> String {
    arguments
        .map(|argument| format!("{} ({})", argument.name, argument.len(model.dof())))
        .collect::<Vec<_>>()
        .join(", ")
}

fn of_argument(argument: &Argument, model: &Model) -> Vec<String> {
    let ([rows, columns], [rows_with_one, columns_with_one]) = (argument.shape(0), argument.shape(1));
    let is_vector = columns == 1 && columns_with_one == 1;
    // Momenta and forces are wrenches, everything else with six numbers is a twist.
    let six =
        if is_vector && ["N", "kg·m²/s"].iter().any(|unit| argument.unit.starts_with(unit)) { WRENCH } else { TWIST };
    let labels = |constant: usize, with_one: usize| -> Vec<String> {
        let fixed: &[&str] = match constant {
            6 => &six,
            3 => &AXES,
            4 => &POSE,
            _ => &[],
        };
        let coordinates = model.coordinates().iter().filter(|_| with_one > constant).map(|c| c.name.as_str());
        fixed.iter().copied().chain(coordinates).map(|label| format!(".{label}")).collect()
    };
    let one = |labels: Vec<String>| if labels.is_empty() { vec![String::new()] } else { labels };
    let (rows, columns) = (one(labels(rows, rows_with_one)), one(labels(columns, columns_with_one)));
    let layers: Vec<String> = match argument.layers() {
        1 => vec![argument.name.to_owned()],
        _ => AXES.map(|axis| format!("{}.{axis}", argument.name)).to_vec(),
    };
    let columns = layers.iter().flat_map(|layer| columns.iter().map(move |column| (layer, column)));
    columns.flat_map(|(layer, column)| rows.iter().map(move |row| format!("{layer}{row}{column}"))).collect()
}
