//! Turns a floating-base robot into specialised Rust that equals the recursive core bit for bit.
//!
//! Nothing here knows dynamics. The core runs over a scalar that records its operations; what they are is folded without
//! changing a bit of any result, ordered, named after the robot and the mathematics, and written out.
//!
//! ```
//! use frs_codegen::{Options, generate};
//! let model = frs_core::Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
//! let generated = generate(&model, &Options::default())?;
//! assert!(generated.text().contains("pub fn inertia("));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod build;
mod choose;
mod cut;
mod emit;
mod error;
mod expression;
pub mod fresh;
mod glue;
mod home;
mod module;
mod name;
mod options;
mod print;
mod program;
pub mod record;
mod report;
mod schedule;
mod simplify;
mod table;

use frs_core::Model;
use proc_macro2::TokenStream;
use quote::quote;

use choose::choose;
use emit::Emitter;
use module::Module;
use program::quantities;
use schedule::Schedule;

pub use error::GenerateError;
pub use name::{camel_case, module_name};
pub use options::{Form, Lanes, Momentum, Options};
pub use program::{Function, Input, Named, Output, Program};
pub use report::{Counts, FunctionReport};
pub use simplify::{Graph, Precision};

/// The generated code of a robot.
pub struct Generated {
    documentation: Vec<String>,
    items: TokenStream,
    /// What each function does.
    pub functions: Vec<FunctionReport>,
}

/// Generates what `options` ask of `model`, standing on the crate `frs_core`.
///
/// # Errors
/// If options exclude each other, or name what the robot does not have.
pub fn generate(model: &Model, options: &Options) -> Result<Generated, GenerateError> {
    generate_on(model, options, &quote!(::frs_core), true)
}

/// [`generate`], with `core` for the path of `frs-core`; `comments` marks them, for text.
///
/// # Errors
/// As [`generate`].
pub fn generate_on(
    model: &Model,
    options: &Options,
    core: &TokenStream,
    comments: bool,
) -> Result<Generated, GenerateError> {
    options.check()?;
    let model = &options.specialise(model)?;
    let parts = &name::Parts::new(model);
    let module = &Module { model, options, parts };
    let mut items = TokenStream::new();
    let mut functions = Vec::new();
    let (mut codes, mut vectors) = (Vec::new(), false);
    for (form, quantities) in choose(model, options, quantities(model, options)?)? {
        let (tokens, reports) = match form {
            Form::Tabled => module.tabled(core, &quantities)?,
            _ => {
                let program = Program::of(&quantities, model, &Options { form, ..options.clone() })?;
                let schedule = Schedule::new(&program);
                let emitter = Emitter { module, program: &program, schedule: &schedule, form, comments };
                let own = emitter.codes();
                let (tokens, reports) = emitter.functions(&own);
                vectors |= form == Form::Hybrid && glue::mentions(&tokens, "F64x4");
                if codes.is_empty() {
                    codes = own;
                    (tokens, reports)
                } else {
                    (glue::beside(&tokens, &reports), reports)
                }
            }
        };
        items.extend(tokens);
        functions.extend(reports);
    }
    let robot = module.robot((!options.standalone).then_some(core), &functions, &codes, vectors);
    let turns = options.lanes == Lanes::One && functions.iter().any(|report| report.counts.sin_cos > 0);
    let turn = match (turns, options.standalone) {
        (false, _) => TokenStream::new(),
        (true, false) => quote!(use #core::turn;),
        (true, true) => glue::turn(&items),
    };
    Ok(Generated { documentation: module.module_documentation(), items: quote!(#turn #robot #items), functions })
}

impl Generated {
    /// The items, for whoever puts them into a module.
    pub fn items(&self) -> &TokenStream {
        &self.items
    }

    /// Lints that straight-line code of measured constants cannot keep.
    pub fn lints() -> TokenStream {
        quote!(allow(clippy::approx_constant, clippy::excessive_precision, clippy::too_many_arguments))
    }

    /// The module's documentation, line by line.
    pub fn documentation(&self) -> &[String] {
        &self.documentation
    }

    /// The items as text, for a file that is included into a module.
    pub fn included_text(&self) -> String {
        print::print(self.items.clone())
    }

    /// The module as text, for a file of its own.
    pub fn text(&self) -> String {
        let (documentation, items, lints) = (&self.documentation, &self.items, Self::lints());
        print::print(quote! {
            #(#![doc = #documentation])*
            #![#lints]
            #items
        })
    }
}
