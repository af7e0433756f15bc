//! The tabled form: the robot's constants, and functions that hand them to the core's loops.

use frs_core::model::{Body, Link, Motion};
use frs_core::{Argument, Quantity};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::emit::ident;
use crate::error::GenerateError;
use crate::glue::{arguments, quantity};
use crate::module::Module;
use crate::options::Form;
use crate::program::Input;
use crate::report::{Counts, FunctionReport};
use crate::simplify::Precision;

/// The types that tables are made of.
pub const TYPES: [&str; 5] = ["BodyTable", "Drive", "LinkTable", "Motion", "Tables"];

impl Module<'_> {
    /// The tables and the functions of `quantities`; `core` is the path of `frs-core`.
    pub fn tabled(
        &self,
        core: &TokenStream,
        quantities: &[Quantity],
    ) -> Result<(TokenStream, Vec<FunctionReport>), GenerateError> {
        let number = self.number();
        let (functions, reports): (TokenStream, Vec<_>) = quantities.iter().map(|&asked| self.in_loops(asked)).unzip();
        let (types, tables) = (TYPES.map(ident), self.tables()?);
        let items = quote! {
            use #core::generated::{#(#types),*};
            #tables
            /// Answers by the core's loops, in memory that each thread has of its own.
            fn in_loops(quantity: Quantity, inputs: &[&[#number]], outputs: &mut [&mut [#number]]) {
                use #core::{Evaluator, Model};
                static MODEL: ::std::sync::LazyLock<Model<#number>> = ::std::sync::LazyLock::new(|| TABLES.model().cast());
                ::std::thread_local! {
                    static ROBOT: ::std::cell::RefCell<Evaluator<'static, #number>> =
                        ::std::cell::RefCell::new(Evaluator::new(&MODEL));
                }
                ROBOT.with_borrow_mut(|robot| robot.answer(quantity, inputs, outputs));
            }
            #functions
        };
        Ok((items, reports))
    }

    /// A quantity's function.
    fn in_loops(&self, asked: Quantity) -> (TokenStream, FunctionReport) {
        let (n, number) = (self.model.dof(), self.number());
        let mut start = 0;
        let inputs = asked.inputs().map(|argument| {
            let Argument { name, meaning, unit, .. } = argument;
            let input = Input { name, meaning, unit, start, len: argument.len(n) };
            start += input.len as u32;
            input
        });
        let report = FunctionReport {
            name: self.function_name(asked),
            quantity: asked,
            inputs: inputs.collect(),
            outputs: asked.outputs().map(|output| (output.name, output.shape(n), output.layers())).collect(),
            counts: Counts::default(),
            code_bytes: 0,
            form: Form::Tabled,
        };
        let doc =
            self.documentation(&report, asked.outputs().map(|output| (output.symbol, output.meaning, output.unit)));
        let name = ident(&report.name);
        let (given, written) = arguments(&report);
        let lens = report.inputs.iter().map(|input| Literal::usize_unsuffixed(input.len));
        let types = report.outputs.iter().map(|&(_, shape, layers)| self.output_type(shape, layers));
        let slices = report.outputs.iter().zip(&written).map(|(&(_, shape, layers), name)| match (shape, layers) {
            ([1, 1], 1) => quote!(::std::slice::from_mut(#name)),
            ([_, 1], 1) => quote!(#name),
            (_, 1) => quote!(#name.as_flattened_mut()),
            _ => quote!(#name.as_flattened_mut().as_flattened_mut()),
        });
        let asked = quantity(asked);
        let tokens = quote! {
            #(#[doc = #doc])*
            pub fn #name(#(#given: &[#number; #lens],)* #(#written: &mut #types),*) {
                in_loops(Quantity::#asked, &[#(#given),*], &mut [#(#slices),*]);
            }
        };
        (tokens, report)
    }

    /// The robot as constants.
    fn tables(&self) -> Result<TokenStream, GenerateError> {
        let model = self.model;
        let bodies: Vec<TokenStream> = model.bodies().iter().map(|body| self.body(body)).collect::<Result<_, _>>()?;
        let links: Vec<TokenStream> = model.links().iter().map(|link| self.link(link)).collect::<Result<_, _>>()?;
        let names: Vec<Ident> =
            self.parts.bodies.iter().map(|name| format_ident!("BODY_{}", name.to_ascii_uppercase())).collect();
        let words = self.parts.bodies.iter().zip(&self.parts.joints).enumerate().map(|(k, (body, joint))| match k {
            0 => format!(" Body 0, the base: {body}."),
            _ => format!(" Body {k}: {body}, driven by {joint}."),
        });
        let coordinates = model.coordinates().iter().map(|coordinate| {
            let (name, body) = (&coordinate.name, Literal::usize_unsuffixed(coordinate.body));
            quote!((#name, #body))
        });
        let (name, has_mimic) = (model.name(), model.has_mimic());
        Ok(quote! {
            #(
                #[doc = #words]
                const #names: BodyTable = #bodies;
            )*
            /// What the core's loops read.
            static TABLES: Tables = Tables {
                name: #name,
                coordinates: &[#(#coordinates),*],
                has_mimic: #has_mimic,
                bodies: &[#(#names),*],
                links: &[#(#links),*],
            };
        })
    }

    fn body(&self, body: &Body) -> Result<TokenStream, GenerateError> {
        let [parent, end, coordinate, least_moment] =
            [body.parent, body.end, body.drive.coordinate, body.least_moment].map(Literal::usize_unsuffixed);
        let motion = match body.motion {
            Motion::Revolute => quote!(Revolute),
            Motion::Prismatic => quote!(Prismatic),
        };
        let rotation = self.numbers(body.placement.rotation.as_slice())?;
        let translation = self.numbers(body.placement.translation.as_slice())?;
        let (ratio, offset) = (self.constant(body.drive.ratio)?, self.constant(body.drive.offset)?);
        let (mass, com) = (self.constant(body.mass)?, self.numbers(body.com.as_slice())?);
        let moments = body.inertia;
        let inertia = self.numbers(&[moments.xx, moments.xy, moments.xz, moments.yy, moments.yz, moments.zz])?;
        Ok(quote! {
            BodyTable {
                parent: #parent,
                end: #end,
                motion: Motion::#motion,
                rotation: #rotation,
                translation: #translation,
                drive: Drive { coordinate: #coordinate, ratio: #ratio, offset: #offset },
                mass: #mass,
                com: #com,
                inertia: #inertia,
                least_moment: #least_moment,
            }
        })
    }

    fn link(&self, link: &Link) -> Result<TokenStream, GenerateError> {
        let (name, body) = (&link.name, Literal::usize_unsuffixed(link.body));
        let rotation = self.numbers(link.placement.rotation.as_slice())?;
        let translation = self.numbers(link.placement.translation.as_slice())?;
        Ok(quote!(LinkTable { name: #name, body: #body, rotation: #rotation, translation: #translation }))
    }

    fn numbers(&self, values: &[f64]) -> Result<TokenStream, GenerateError> {
        let values: Vec<TokenStream> = values.iter().map(|&value| self.constant(value)).collect::<Result<_, _>>()?;
        Ok(quote!([#(#values),*]))
    }

    /// The shortest literal that reads back to the same bits.
    ///
    /// # Errors
    /// If the scalar cannot hold it.
    fn constant(&self, value: f64) -> Result<TokenStream, GenerateError> {
        let held = match self.options.precision {
            Precision::Double => value.is_finite(),
            Precision::Single => (value as f32).is_finite(),
        };
        if !held {
            return Err(GenerateError::TooLarge { element: self.options.precision.name() });
        }
        let size = Literal::f64_unsuffixed(value.abs());
        Ok(if value.is_sign_negative() { quote!(-#size) } else { quote!(#size) })
    }
}
