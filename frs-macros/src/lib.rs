//! `frs_model!`: a robot's generated dynamics as a module, from its URDF at compile time.
//!
//! A thin shell over `frs-codegen`: it reads what the user asks, reads the file, and puts every complaint on the word it
//! is about. Users call it as `frs::frs_model!`, which says where the generated code finds `frs`.

mod expand;
mod request;
mod setting;

use proc_macro::TokenStream;

/// The module of a robot; `frs::frs_model!` calls it with the path of `frs` in brackets before what the user wrote.
#[proc_macro]
pub fn frs_model(input: TokenStream) -> TokenStream {
    match syn::parse::<request::Request>(input) {
        Ok(request) => expand::expand(request),
        Err(error) => error.to_compile_error(),
    }
    .into()
}
