//! The grammar of settings, whatever they mean: `key`, `key = value`, `key(setting, …)`, separated by commas.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::{Expr, ExprLit, ExprUnary, Ident, Lit, LitStr, Token, UnOp, parenthesized, token};

/// One setting.
pub struct Setting {
    /// Its key, a word or a text in quotes.
    pub key: String,
    /// Where the key stands.
    pub span: Span,
    value: Value,
}

enum Value {
    None,
    Is(Expr),
    List(Vec<Setting>),
}

/// The settings up to the end of `input`. What cannot be read is left out and told in `errors`.
pub fn settings(input: ParseStream<'_>, errors: &mut Vec<syn::Error>) -> Vec<Setting> {
    let mut settings = Vec::new();
    while !input.is_empty() {
        match setting(input, errors) {
            Ok(setting) => settings.push(setting),
            Err(error) => errors.push(error),
        }
        while !input.is_empty() && !input.peek(Token![,]) {
            let _ = input.parse::<TokenTree>();
        }
        let _ = input.parse::<Token![,]>();
    }
    settings
}

fn setting(input: ParseStream<'_>, errors: &mut Vec<syn::Error>) -> syn::Result<Setting> {
    let (key, span) = if input.peek(LitStr) {
        let text: LitStr = input.parse()?;
        (text.value(), text.span())
    } else if input.peek(Ident::peek_any) {
        let word = input.call(Ident::parse_any)?;
        (word.to_string(), word.span())
    } else {
        return Err(
            input.error("settings: this is no key; expected a word, or a name in quotes; see the keys of frs_model!")
        );
    };
    let value = if input.peek(token::Paren) {
        let content;
        parenthesized!(content in input);
        Value::List(settings(&content, errors))
    } else if input.peek(Token![=]) {
        input.parse::<Token![=]>()?;
        let missing = |_| {
            let message =
                format!("key '{key}': what follows `=` is no value; expected one; write it, or take `=` away");
            syn::Error::new(span, message)
        };
        Value::Is(Expr::parse(input).map_err(missing)?)
    } else {
        Value::None
    };
    if !input.is_empty() && !input.peek(Token![,]) {
        let message = format!("key '{key}': something else follows; expected a comma; put one before this");
        return Err(input.error(message));
    }
    Ok(Setting { key, span, value })
}

impl Setting {
    /// What stands for the value, in words.
    pub fn found(&self) -> String {
        match &self.value {
            Value::None => "it has no value".into(),
            Value::Is(value) => format!("its value is `{}`", value.to_token_stream()),
            Value::List(_) => "it has a list".into(),
        }
    }

    /// Where the value stands, or the key where there is none.
    pub fn value_span(&self) -> Span {
        match &self.value {
            Value::Is(value) => first_span(value.to_token_stream()),
            _ => self.span,
        }
    }

    /// Whether there is a key alone.
    pub fn is_bare(&self) -> bool {
        matches!(self.value, Value::None)
    }

    /// The settings in parentheses.
    pub fn list(&self) -> Option<&[Setting]> {
        match &self.value {
            Value::List(settings) => Some(settings),
            _ => None,
        }
    }

    /// The value as a text in quotes.
    pub fn text(&self) -> Option<LitStr> {
        match &self.value {
            Value::Is(Expr::Lit(ExprLit { lit: Lit::Str(text), .. })) => Some(text.clone()),
            _ => None,
        }
    }

    /// The value as one of `words`, by its position.
    pub fn word<T: Copy>(&self, words: &[(&str, T)]) -> Option<T> {
        let Value::Is(value) = &self.value else { return None };
        let value = value.to_token_stream().to_string();
        words.iter().find(|(word, _)| *word == value).map(|&(_, meaning)| meaning)
    }

    /// The value as a finite number.
    pub fn number(&self) -> Option<f64> {
        match &self.value {
            Value::Is(Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. })) => number(expr).map(|number| -number),
            Value::Is(value) => number(value),
            _ => None,
        }
    }
}

fn number(value: &Expr) -> Option<f64> {
    let Expr::Lit(ExprLit { lit, .. }) = value else { return None };
    let number: f64 = match lit {
        Lit::Float(number) => number.base10_parse().ok()?,
        Lit::Int(number) => number.base10_parse().ok()?,
        _ => return None,
    };
    number.is_finite().then_some(number)
}

fn first_span(tokens: TokenStream) -> Span {
    tokens.into_iter().next().map_or_else(Span::call_site, |token| token.span())
}
