//! What all functions of a module have in common: the robot, its names, and the types they compute with.

use frs_core::{Model, Quantity};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use crate::name::Parts;
use crate::options::{Form, Options};
use crate::report::FunctionReport;
use crate::simplify::Precision;

/// A robot to write a module of.
pub struct Module<'p> {
    pub model: &'p Model,
    pub options: &'p Options,
    pub parts: &'p Parts,
}

impl Module<'_> {
    /// The type of a number.
    pub fn number(&self) -> TokenStream {
        let bits = match self.options.precision {
            Precision::Double => 64,
            Precision::Single => 32,
        };
        let name = match self.options.lanes.count() {
            1 => format_ident!("f{bits}"),
            count => format_ident!("F{bits}x{count}"),
        };
        quote!(#name)
    }

    /// The type behind an output.
    pub fn output_type(&self, shape: [usize; 2], layers: usize) -> TokenStream {
        let number = self.number();
        let [rows, columns] = shape.map(Literal::usize_unsuffixed);
        let all = Literal::usize_unsuffixed(layers);
        match (shape, layers) {
            ([1, 1], 1) => number,
            ([_, 1], 1) => quote!([#number; #rows]),
            (_, 1) => quote!([[#number; #rows]; #columns]),
            _ => quote!([[[#number; #rows]; #columns]; #all]),
        }
    }

    /// What the function of a quantity is called.
    pub fn function_name(&self, quantity: Quantity) -> String {
        match quantity {
            Quantity::Kinematics(link) => format!("kinematics_{}", self.parts.links[link]),
            _ => quantity.name().to_owned(),
        }
    }

    /// The documentation of a function; `about` are symbol, meaning and unit of each output.
    pub fn documentation<'o>(
        &self,
        report: &FunctionReport,
        about: impl Iterator<Item = (&'o str, &'o str, &'o str)>,
    ) -> Vec<String> {
        let mut doc = vec![format!(" {}", report.quantity.meaning()), String::new()];
        for input in &report.inputs {
            doc.push(format!(" - `{}`: {} ({}; {})", input.name, input.meaning, input.len, input.unit));
        }
        for (&(name, [rows, columns], layers), (symbol, meaning, unit)) in report.outputs.iter().zip(about) {
            let layers = if layers > 1 { format!("{layers} of ") } else { String::new() };
            let shape = if columns == 1 { rows.to_string() } else { format!("{layers}{rows}×{columns}, by columns") };
            doc.push(format!(" - `{name}`: {symbol}, {meaning} ({shape}; {unit})"));
        }
        doc.push(String::new());
        doc.push(match report.form {
            Form::Tabled => " By the core's loops over the tables of this module.".to_owned(),
            _ => format!(" {}; about {:.1} KiB of code.", report.counts, report.code_bytes as f64 / 1024.0),
        });
        doc
    }
}
