//! One place as a Rust expression.
//!
//! Parentheses keep the order of operations: Rust reads `a + b + c` and `a * b * c` from the left, and so does this.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::options::Lanes;
use crate::program::Program;
use crate::record::{Operation, Place};
use crate::simplify::Precision;

/// How tightly an expression binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// Writes places of a program as expressions.
pub struct Expressions<'a> {
    /// The program.
    pub program: &'a Program,
    /// How constants are written.
    pub precision: Precision,
    /// How many numbers are side by side.
    pub lanes: Lanes,
    /// A constant where no operation lifts it to all lanes.
    pub lift: &'a dyn Fn(TokenStream) -> TokenStream,
    /// What a place is called where it has a name.
    pub names: &'a dyn Fn(Place) -> Option<TokenStream>,
}

impl Expressions<'_> {
    /// The expression that computes `place`, even where it has a name.
    pub fn definition(&self, place: Place) -> TokenStream {
        self.operation(place).0
    }

    /// Sine and cosine of a place.
    pub fn sin_cos(&self, place: Place) -> TokenStream {
        let least = if self.lanes == Lanes::One { Binding::Sum } else { Binding::Atom };
        let angle = self.operand(place, least);
        match (self.lanes, self.precision) {
            (Lanes::One, Precision::Double) => quote!(turn::sin_cos(#angle)),
            (Lanes::One, Precision::Single) => quote!(turn::sin_cos_single(#angle)),
            _ => quote!(#angle.sin_cos()),
        }
    }

    /// Sines and cosines of several places at once, for plain numbers.
    pub fn sin_cos_each(&self, places: &[Place]) -> TokenStream {
        let angles = places.iter().map(|&place| self.operand(place, Binding::Sum));
        match self.precision {
            Precision::Double => quote!(turn::sin_cos_each([#(#angles),*])),
            Precision::Single => quote!(turn::sin_cos_single_each([#(#angles),*])),
        }
    }

    /// `place` plus 0: no −0 leaves a function.
    pub fn output(&self, place: Place) -> TokenStream {
        match self.program.graph.operation(place) {
            Operation::Constant(_) => (self.lift)(self.operand(place, Binding::Sum)),
            Operation::Neg(a) => {
                let a = self.operand(a, Binding::Product);
                quote!(0.0 - #a)
            }
            _ => {
                let value = self.operand(place, Binding::Sum);
                quote!(#value + 0.0)
            }
        }
    }

    /// The place as an operand of something that binds as tightly as `least`.
    fn operand(&self, place: Place, least: Binding) -> TokenStream {
        let (tokens, binding) = match (self.names)(place) {
            Some(name) => (name, Binding::Atom),
            None => self.operation(place),
        };
        if binding < least { quote!((#tokens)) } else { tokens }
    }

    fn operation(&self, place: Place) -> (TokenStream, Binding) {
        let at = |place, least| self.operand(place, least);
        match self.program.graph.operation(place) {
            Operation::Input(number) => {
                let (array, index) = self.program.input_of(number);
                let name = proc_macro2::Ident::new(self.program.inputs[array].name, proc_macro2::Span::call_site());
                let index = Literal::usize_unsuffixed(index);
                (quote!(#name[#index]), Binding::Atom)
            }
            Operation::Constant(bits) => self.constant(f64::from_bits(bits)),
            Operation::Add(a, b) => {
                let (a, b) = (at(a, Binding::Sum), at(b, Binding::Product));
                (quote!(#a + #b), Binding::Sum)
            }
            Operation::Sub(a, b) => {
                let (a, b) = (at(a, Binding::Sum), at(b, Binding::Product));
                (quote!(#a - #b), Binding::Sum)
            }
            Operation::Mul(a, b) => {
                let (a, b) = (at(a, Binding::Product), at(b, Binding::Sign));
                (quote!(#a * #b), Binding::Product)
            }
            Operation::Div(a, b) => {
                let (a, b) = (at(a, Binding::Product), at(b, Binding::Sign));
                (quote!(#a / #b), Binding::Product)
            }
            Operation::MulAdd(a, b, c) => {
                let [b, c] = [b, c].map(|place| self.argument(place));
                let a = self.receiver(a);
                (quote!(#a.mul_add(#b, #c)), Binding::Atom)
            }
            Operation::Neg(a) => {
                let a = at(a, Binding::Atom);
                (quote!(-#a), Binding::Sign)
            }
            Operation::Sqrt(a) => {
                let a = at(a, Binding::Atom);
                (quote!(#a.sqrt()), Binding::Atom)
            }
            Operation::Sin(a) => {
                let both = self.sin_cos(a);
                (quote!(#both.0), Binding::Atom)
            }
            Operation::Cos(a) => {
                let both = self.sin_cos(a);
                (quote!(#both.1), Binding::Atom)
            }
            Operation::Gather(numbers) => {
                let numbers = numbers.map(|number| at(number, Binding::Sum));
                (quote!(F64x4::from_array([#(#numbers),*])), Binding::Atom)
            }
            // A vector takes a number on its other side: it is the same in all lanes.
            Operation::Splat(a) => match (self.names)(a) {
                Some(name) => (name, Binding::Atom),
                None => self.operation(a),
            },
            Operation::Lane(a, number) => {
                let (a, number) = (at(a, Binding::Atom), Literal::u8_unsuffixed(number));
                (quote!(#a.as_array()[#number]), Binding::Atom)
            }
        }
    }

    /// The place as an argument of a method, where no operator lifts a constant to all lanes.
    fn argument(&self, place: Place) -> TokenStream {
        let value = self.operand(place, Binding::Sum);
        if self.is_splat(place) {
            return quote!(F64x4::splat(#value));
        }
        if self.program.graph.constant_at(place).is_some() { (self.lift)(value) } else { value }
    }

    /// The place as what has a method: of a plain constant the type must be said.
    fn receiver(&self, place: Place) -> TokenStream {
        match (self.program.graph.constant_at(place), self.lanes) {
            (Some(value), Lanes::One) => {
                let size = match self.precision {
                    Precision::Single => Literal::f32_suffixed(value.abs() as f32),
                    Precision::Double => Literal::f64_suffixed(value.abs()),
                };
                if value < 0.0 { quote!((-#size)) } else { quote!(#size) }
            }
            (Some(_), _) => self.argument(place),
            (None, _) if self.is_splat(place) => self.argument(place),
            (None, _) => self.operand(place, Binding::Atom),
        }
    }

    /// Whether a vector is written as the number that stands in all its lanes.
    fn is_splat(&self, place: Place) -> bool {
        match self.program.graph.operation(place) {
            Operation::Splat(_) => true,
            Operation::Neg(a) => self.is_splat(a),
            _ => false,
        }
    }

    /// The shortest literal that reads back to the same bits.
    fn constant(&self, value: f64) -> (TokenStream, Binding) {
        let size = match self.precision {
            Precision::Single => Literal::f32_unsuffixed(value.abs() as f32),
            Precision::Double => Literal::f64_unsuffixed(value.abs()),
        };
        if value < 0.0 { (quote!(-#size), Binding::Sign) } else { (quote!(#size), Binding::Atom) }
    }
}
