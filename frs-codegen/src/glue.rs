//! What makes functions a robot: its name, its coordinates, and the interface it shares with the core.

use std::collections::BTreeSet;

use frs_core::{FUSED, Quantity};
use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};

use crate::emit::{Code, ident, structure};
use crate::module::Module;
use crate::name::camel_case;
use crate::options::{Form, Lanes};
use crate::report::FunctionReport;
use crate::table::TYPES;

impl Module<'_> {
    /// The lines of documentation of the module.
    pub fn module_documentation(&self) -> Vec<String> {
        let names = |list: &mut dyn Iterator<Item = &str>| list.collect::<Vec<_>>().join(", ");
        let model = self.model;
        let mut lines = vec![
            format!(
                " The dynamics of the robot '{}', generated: read it, review its changes, do not edit it.",
                model.name()
            ),
            String::new(),
            format!(" Coordinates: {}.", names(&mut model.coordinates().iter().map(|c| c.name.as_str()))),
            format!(
                " Base frame: link '{}'; six-vectors are angular part first, matrices by columns.",
                model.links()[0].name
            ),
        ];
        if FUSED {
            lines.push(
                " Sums of products are fused: these are the bits of a core that was built with the feature `fused`."
                    .into(),
            );
        }
        lines
    }

    /// What the type of the robot is called: its name, unless something else in the module has it.
    fn robot_name(&self, functions: &[FunctionReport], codes: &[Code]) -> Ident {
        let name = camel_case(self.model.name());
        let tabled = functions.iter().any(|function| function.form == Form::Tabled);
        let taken = ["FloatingBase", "Quantity", "F64x4", "F64x8", "F32x8", "F32x16"].contains(&name.as_str())
            || tabled && TYPES.contains(&name.as_str())
            || codes.iter().any(|code| structure(&code.name) == name);
        if taken { format_ident!("Robot{name}") } else { ident(&name) }
    }

    /// Constants and the type of the robot; `core` is the path of `frs-core`, if the module may stand on it, `codes` stand beside the type.
    /// `vectors`: whether functions of one state hold vectors.
    pub fn robot(
        &self,
        core: Option<&TokenStream>,
        functions: &[FunctionReport],
        codes: &[Code],
        vectors: bool,
    ) -> TokenStream {
        let n = Literal::usize_unsuffixed(self.model.dof());
        let coordinates = self.model.coordinates().iter().map(|coordinate| &coordinate.name);
        let constants = quote! {
            /// Number n of coordinates.
            pub const DOF: usize = #n;
            /// Names of the coordinates, in the order of the columns.
            pub const COORDINATES: [&str; DOF] = [#(#coordinates),*];
        };
        let Some(core) = core else { return constants };
        let robot = self.robot_name(functions, codes);
        let number = self.number();
        let lanes = match self.options.lanes {
            Lanes::One if vectors => quote!(use #core::lanes::F64x4;),
            Lanes::One => TokenStream::new(),
            _ => quote!(use #core::lanes::#number;),
        };
        let (fields, payload) = match self.options.payload {
            Some(_) => {
                let doc = " The payload: mass, centre of mass, rotational inertia about it (xx, xy, xz, yy, yz, zz), in its link's frame.";
                (quote!({ #[doc = #doc] pub payload: [#number; 10] }), true)
            }
            None => (quote!(;), false),
        };
        let functions: Vec<&FunctionReport> =
            functions.iter().filter(|function| function.has_the_inputs_of_its_quantity()).collect();
        let known = functions.iter().map(|function| quantity(function.quantity));
        let known =
            if functions.is_empty() { quote!(false) } else { quote!(matches!(quantity, #(Quantity::#known)|*)) };
        let unknown = functions.is_empty().then(|| quote!(let _ = quantity;));
        let calls = functions.iter().map(|function| self.call(function, payload));
        let used: Vec<_> = self.conversions(&functions);
        let uses = (!used.is_empty()).then(|| quote!(use #core::generated::{#(#used),*};));
        let contract = FUSED.then(|| {
            quote!(
                const _: () = assert!(#core::FUSED, "made for the feature `fused` of frs-core");
            )
        });
        quote! {
            #lanes
            #contract
            use #core::{FloatingBase, Quantity};
            #uses
            #constants
            /// The robot, as one that answers quantities.
            #[derive(Clone, Copy, Debug)]
            pub struct #robot #fields
            impl FloatingBase<#number> for #robot {
                fn dof(&self) -> usize {
                    DOF
                }
                fn answers(&self, quantity: Quantity) -> bool {
                    #unknown
                    #known
                }
                fn answer(&mut self, quantity: Quantity, inputs: &[&[#number]], outputs: &mut [&mut [#number]]) {
                    match (quantity, inputs, outputs) {
                        #(#calls)*
                        _ => #core::generated::refuse(quantity, self.answers(quantity)),
                    }
                }
            }
        }
    }

    /// The arm that answers a quantity.
    fn call(&self, function: &FunctionReport, payload: bool) -> TokenStream {
        let name = ident(&self.function_name(function.quantity));
        let (inputs, outputs) = arguments(function);
        let conversions = function.outputs.iter().zip(&outputs).map(|(&(_, shape, layers), name)| {
            let by = ident(conversion(shape, layers));
            quote!(#by(#name))
        });
        let quantity = quantity(function.quantity);
        let payload = payload.then(|| quote!(&self.payload,));
        quote! {
            (Quantity::#quantity, [#(#inputs),*], [#(#outputs),*]) => self::#name(#payload #(array(#inputs),)* #(#conversions),*),
        }
    }

    /// The conversions that calls use.
    fn conversions(&self, functions: &[&FunctionReport]) -> Vec<Ident> {
        let outputs = functions.iter().flat_map(|function| &function.outputs);
        let mut names: Vec<&str> = outputs.map(|&(_, shape, layers)| conversion(shape, layers)).collect();
        if !functions.is_empty() {
            names.push("array");
        }
        names.sort_unstable();
        names.dedup();
        names.into_iter().map(ident).collect()
    }
}

/// Sine and cosine of the core, for a module that stands alone: what of them `functions` call.
pub fn turn(functions: &TokenStream) -> TokenStream {
    let file: syn::File = syn::parse_str(frs_core::generated::TURN).expect("the core's own source is Rust");
    let (mut known, mut needed) = (BTreeSet::new(), vec![false; file.items.len()]);
    words(functions.clone(), &mut known);
    let next = |known: &BTreeSet<String>, needed: &[bool]| {
        let named = |item: &syn::Item| match item {
            syn::Item::Fn(function) => known.contains(&function.sig.ident.to_string()),
            syn::Item::Const(constant) => known.contains(&constant.ident.to_string()),
            _ => true,
        };
        (0..needed.len()).find(|&number| !needed[number] && named(&file.items[number]))
    };
    while let Some(number) = next(&known, &needed) {
        needed[number] = true;
        words(file.items[number].to_token_stream(), &mut known);
    }
    let documentation = &file.attrs;
    let items = file.items.iter().zip(needed).filter(|(_, needed)| *needed).map(|(item, _)| item);
    quote! {
        mod turn {
            #(#documentation)*
            #(#items)*
        }
    }
}

/// What the inputs of a function, but for a payload, and its outputs are called side by side: an input and an output may share a name.
pub fn arguments(function: &FunctionReport) -> (Vec<Ident>, Vec<Ident>) {
    let inputs = function.inputs.iter().map(|input| input.name).filter(|&name| name != "payload");
    let inputs: Vec<Ident> = inputs.map(ident).collect();
    let outputs = function.outputs.iter().map(|(name, ..)| ident(name));
    let outputs = outputs.map(|name| if inputs.contains(&name) { format_ident!("{name}_out") } else { name }).collect();
    (inputs, outputs)
}

/// Functions in the hybrid form in a module of their own, where the module already has unrolled ones: passes of both have the same names.
pub fn beside(items: &TokenStream, functions: &[FunctionReport]) -> TokenStream {
    let names = functions.iter().map(|function| ident(&function.name));
    let used = ["turn", "F64x4"].into_iter().filter(|word| mentions(items, word)).map(ident);
    quote! {
        pub use hybrid::{#(#names),*};
        mod hybrid {
            use super::{#(#used),*};
            #items
        }
    }
}

/// Whether `word` is among the identifiers of `tokens`.
pub fn mentions(tokens: &TokenStream, word: &str) -> bool {
    let mut known = BTreeSet::new();
    words(tokens.clone(), &mut known);
    known.contains(word)
}

/// Adds all identifiers of `tokens`.
fn words(tokens: TokenStream, known: &mut BTreeSet<String>) {
    for token in tokens {
        match token {
            TokenTree::Ident(word) => {
                known.insert(word.to_string());
            }
            TokenTree::Group(group) => words(group.stream(), known),
            _ => {}
        }
    }
}

/// The function that makes the output's type from a slice.
fn conversion(shape: [usize; 2], layers: usize) -> &'static str {
    match (shape, layers) {
        ([1, 1], 1) => "number_mut",
        ([_, 1], 1) => "array_mut",
        (_, 1) => "columns_mut",
        _ => "layers_mut",
    }
}

/// The quantity as a pattern.
pub fn quantity(quantity: Quantity) -> TokenStream {
    match quantity {
        Quantity::Kinematics(link) => {
            let link = Literal::usize_unsuffixed(link);
            quote!(Kinematics(#link))
        }
        _ => {
            let name = ident(&camel_case(quantity.name()));
            quote!(#name)
        }
    }
}
