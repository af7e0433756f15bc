//! From a request to a module.

use std::path::Path;

use frs_codegen::{Generated, Precision, camel_case, generate_on};
use frs_core::Model;
use frs_core::urdf::Options;
use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};

use crate::request::{Request, stem};

/// The directory of the user's `Cargo.toml`.
const DIRECTORY: &str = "CARGO_MANIFEST_DIR";

/// The module, and every complaint.
pub fn expand(mut request: Request) -> TokenStream {
    let module = match read(&mut request) {
        Ok(model) => generated(&mut request, &model),
        Err(message) => {
            request.error(request.path.span(), message);
            unread(&request)
        }
    };
    let errors = request.errors.iter().map(syn::Error::to_compile_error);
    quote!(#module #(#errors)*)
}

/// The robot; else, why the file is none.
fn read(request: &mut Request) -> Result<Model, String> {
    let file = request.path.value();
    if Path::new(&file).is_absolute() {
        return Err(format!(
            "file '{file}': the path is absolute; expected one relative to the directory of Cargo.toml; \
             shorten it, so that the crate compiles elsewhere too"
        ));
    }
    let directory = std::env::var_os(DIRECTORY).unwrap_or_default();
    let full = Path::new(&directory).join(&file);
    let text = std::fs::read_to_string(&full).map_err(|error| {
        format!(
            "file '{file}': {} cannot be read: {error}; expected a URDF, relative to the directory of Cargo.toml \
             ({DIRECTORY}); correct the path",
            full.display()
        )
    })?;
    let (root, lenient) = (request.root.clone(), request.lenient);
    let from_root = |root| Model::from_urdf_with(&text, &Options { file: &file, root, lenient });
    let Some(root) = root else { return from_root(None).map_err(|error| error.to_string()) };
    from_root(Some(&root.value())).or_else(|error| {
        // A robot that is sound from its own root has its problem in the one that was asked for.
        let model = from_root(None).map_err(|_| error.to_string())?;
        request.error(root.span(), error);
        Ok(model)
    })
}

/// The module of a robot that could be read: what was asked for, as far as it can be had.
fn generated(request: &mut Request, model: &Model) -> TokenStream {
    let generated = loop {
        match generate_on(model, &request.options, &request.core, false) {
            Ok(generated) => break generated,
            Err(error) => request.take_away(&error),
        }
    };
    let Request { attributes, visibility, name, path, .. } = request;
    let (documentation, lints, items) = (generated.documentation(), Generated::lints(), generated.items());
    quote! {
        #(#attributes)*
        #visibility mod #name {
            #(#![doc = #documentation])*
            #![#lints]
            // Whoever changes the file compiles this again.
            const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!(#DIRECTORY), "/", #path));
            #items
        }
    }
}

/// The module of a robot that could not be read: the names that every robot has, so that whoever uses them is not told a second time.
/// Functions take whatever they are given, for the sizes are not known.
fn unread(request: &Request) -> TokenStream {
    let Request { core, attributes, visibility, name, path, options, .. } = request;
    let robot = format_ident!("{}", camel_case(&stem(&path.value())));
    let bits = match options.precision {
        Precision::Double => 64,
        Precision::Single => 32,
    };
    let number = match options.lanes.count() {
        1 => format_ident!("f{bits}").to_token_stream(),
        count => {
            let lanes = format_ident!("F{bits}x{count}");
            quote!(#core::lanes::#lanes)
        }
    };
    let functions = options.functions().map(|(name, arguments)| {
        let name = format_ident!("{name}");
        let kinds: Vec<_> = (0..arguments).map(|i| format_ident!("A{i}")).collect();
        quote!(pub fn #name<#(#kinds),*>(#(_: #kinds),*) {})
    });
    quote! {
        #(#attributes)*
        #visibility mod #name {
            #![allow(missing_docs)]
            use #core::{FloatingBase, Quantity};
            pub const DOF: usize = 0;
            pub const COORDINATES: [&str; DOF] = [];
            #(#functions)*
            #[derive(Clone, Copy, Debug)]
            pub struct #robot;
            impl FloatingBase<#number> for #robot {
                fn dof(&self) -> usize {
                    DOF
                }
                fn answers(&self, _: Quantity) -> bool {
                    false
                }
                fn answer(&mut self, quantity: Quantity, _: &[&[#number]], _: &mut [&mut [#number]]) {
                    #core::generated::refuse(quantity, false)
                }
            }
        }
    }
}
