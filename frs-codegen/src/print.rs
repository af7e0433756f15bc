//! From tokens to text: the same on every machine.

use proc_macro2::TokenStream;

/// Prints a module.
///
/// `syn` checks that the tokens are Rust; a printer of fixed version lays them out. Comments, which tokens cannot hold,
/// travel as `section!("…");`.
pub fn print(tokens: TokenStream) -> String {
    let file = syn::parse2(tokens).expect("what is emitted is Rust");
    let mut text = String::new();
    for line in prettyplease::unparse(&file).lines() {
        match line.trim_start().strip_prefix("section!(\"").and_then(|rest| rest.strip_suffix("\");")) {
            Some(comment) => {
                text.push_str(&line[..line.len() - line.trim_start().len()]);
                text.push_str("// ");
                text.push_str(comment);
            }
            None => text.push_str(line),
        }
        text.push('\n');
    }
    text
}
