//! Every operation is written out once, in order: over numbers, or in the hybrid form over numbers and vectors.
//!
//! A section becomes a function that returns a structure of what others read; a quantity becomes a public function that
//! calls the sections it stands on and writes its outputs.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use frs_core::{Model, Pass, Quantity};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use crate::expression::Expressions;
use crate::name::{Parts, Scope, camel_case, names};
use crate::options::{Lanes, Options};
use crate::program::{Function, Output, Program};
use crate::record::{Operation, Place};
use crate::report::{Counts, FunctionReport};
use crate::schedule::{Block, Line, Purpose, Schedule, place_of};
use crate::simplify::Precision;

/// Operations of a robot's blocks together beyond which none is inlined where it is called, so that compile time does not
/// grow with the number of callers.
const INLINE: usize = 4000;

/// Writes the functions of a robot.
pub struct Emitter<'p> {
    pub program: &'p Program,
    pub schedule: &'p Schedule,
    pub parts: &'p Parts,
    pub options: &'p Options,
    pub model: &'p Model,
    /// Whether comments are marked, to be printed.
    pub comments: bool,
}

/// Where a place that is read here was computed: the block, and the field of its structure.
type Foreign = BTreeMap<Place, (usize, TokenStream)>;

/// A block as code.
pub struct Code {
    /// What it is called, as a function and as the variable that holds what it returns.
    name: Ident,
    /// Its lines.
    body: TokenStream,
    /// Names of what it exports.
    fields: Vec<Ident>,
    /// Inputs it reads, as numbers of arrays.
    inputs: BTreeSet<usize>,
    /// Blocks it reads from.
    blocks: BTreeSet<usize>,
    /// Outputs it writes.
    outputs: BTreeSet<usize>,
}

pub fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// What the block of a pass is called, and what it computes.
fn pass_words(pass: Pass) -> (&'static str, &'static str) {
    match pass {
        Pass::Poses => ("poses", "Rotations and origins of the bodies, from the centre of mass, base axes."),
        Pass::Inertias => ("inertias", "Inertias of the bodies and of their subtrees, centroidal frame."),
        Pass::Complements => ("complements", "Inertias of what is outside each subtree, centroidal frame."),
        Pass::Screws => ("screws", "Screw axes s_j, their momenta h_j = Iᶜ_j s_j, the connection Λ_c⁻¹ h_j."),
        Pass::Outside => ("outside", "Momenta Iᵒ_j s_j of the screws outside the subtrees."),
        Pass::Reactions => ("reactions", "How each joint moves its own subtree at zero momentum."),
        Pass::Velocities => ("velocities", "Velocities of the bodies at zero momentum."),
        Pass::Question => unreachable!("a question is no pass"),
    }
}

impl Emitter<'_> {
    /// What the type of the robot is called: its name, unless something else in the module has it.
    pub fn robot_name(&self, codes: &[Code]) -> Ident {
        let name = camel_case(self.model.name());
        let taken = ["FloatingBase", "Quantity", "F64x4", "F64x8", "F32x8", "F32x16"].contains(&name.as_str())
            || codes.iter().any(|code| structure(&code.name) == name);
        if taken { format_ident!("Robot{name}") } else { ident(&name) }
    }

    /// All functions, with what they perform.
    pub fn functions(&self, codes: &[Code]) -> (TokenStream, Vec<FunctionReport>) {
        let operations: usize = self.schedule.blocks.iter().map(|block| self.counts([block]).flops()).sum();
        let attribute = (operations > INLINE).then(|| quote!(#[inline(never)]));
        let mut items = TokenStream::new();
        let mut start = 0;
        for one_purpose in self.schedule.blocks.chunk_by(|a, b| a.purpose == b.purpose) {
            let numbers = (start..start + one_purpose.len()).filter(|&number| !self.within_its_function(number));
            let visible = (one_purpose.len() > 1).then(|| quote!(pub(super)));
            let blocks = numbers.map(|number| self.block(number, codes, &attribute, &visible)).collect();
            items.extend(if visible.is_some() { module(&codes[start].name, blocks) } else { blocks });
            start += one_purpose.len();
        }
        let mut reports = Vec::new();
        for number in 0..self.program.functions.len() {
            let (tokens, report) = self.function(number, codes);
            items.extend(tokens);
            reports.push(report);
        }
        (items, reports)
    }

    /// Every block as code.
    pub fn codes(&self) -> Vec<Code> {
        let blocks = &self.schedule.blocks;
        let mut codes: Vec<Code> = Vec::with_capacity(blocks.len());
        let mut foreign = Foreign::new();
        let mut structures = BTreeSet::new();
        let mut start = 0;
        for one_purpose in blocks.chunk_by(|a, b| a.purpose == b.purpose) {
            let purpose = &one_purpose[0].purpose;
            let scope = Scope { program: self.program, schedule: self.schedule, purpose };
            let lines: Vec<Line> = one_purpose.iter().flat_map(|block| block.lines.iter().copied()).collect();
            let names = names(&scope, self.parts, &lines);
            let mut around = foreign.clone();
            for (number, block) in (start..).zip(one_purpose) {
                let mut code = self.lines(&scope, block, &names, &around);
                // Names that differ by an underscore alone are one as a structure's.
                let plain = code.name.clone();
                for more in 2.. {
                    if structures.insert(structure(&code.name)) {
                        break;
                    }
                    code.name = format_ident!("{plain}_{more}");
                }
                let holder = &code.name;
                for (&place, field) in block.exports.iter().zip(&code.fields) {
                    around.insert(place, (number, quote!(#holder.#field)));
                }
                codes.push(code);
            }
            start += one_purpose.len();
            around.retain(|place, _| self.schedule.home[*place as usize].is_some());
            if !matches!(purpose, Purpose::Function(_)) {
                foreign = around;
            }
        }
        codes
    }

    /// Whether a block is written where it is needed, because nobody else needs it.
    fn within_its_function(&self, number: usize) -> bool {
        match self.schedule.blocks[number].purpose {
            Purpose::Function(function) => {
                let part_of_others = self.schedule.parts.iter().flatten().any(|parts| parts.contains(&function));
                self.schedule.functions[function].len() == 1 && !part_of_others
            }
            _ => false,
        }
    }

    /// A block's structure and function.
    fn block(
        &self,
        number: usize,
        codes: &[Code],
        attribute: &Option<TokenStream>,
        visible: &Option<TokenStream>,
    ) -> TokenStream {
        let (block, Code { name, body, fields, .. }) = (&self.schedule.blocks[number], &codes[number]);
        let words = self.words(block);
        let elements = block.exports.iter().map(|&place| self.type_of(place));
        let parameters = self.parameters(block, codes, number);
        if fields.is_empty() {
            return quote! { #[doc = #words] #attribute #visible fn #name(#parameters) { #body } };
        }
        let structure = structure(name);
        quote! {
            #[doc = #words]
            #visible struct #structure { #(#visible #fields: #elements),* }
            #[doc = #words]
            #attribute
            #visible fn #name(#parameters) -> #structure {
                #body
                #structure { #(#fields),* }
            }
        }
    }

    /// What a block is for, in words.
    fn words(&self, block: &Block) -> String {
        let words = match &block.purpose {
            Purpose::Pass(pass) => pass_words(*pass).1.to_owned(),
            Purpose::Shared(functions) => {
                let names: Vec<_> = functions.iter().map(|&function| format!("`{}`", self.name(function))).collect();
                format!("What {} have in common.", names.join(", "))
            }
            Purpose::Function(function) => format!("What only `{}` computes.", self.name(*function)),
        };
        if block.part == 0 { format!(" {words}") } else { format!(" {words} Continued.") }
    }

    /// What a block is called.
    fn holder(&self, block: &Block, names: &BTreeMap<Place, String>) -> String {
        let start = match &block.purpose {
            Purpose::Pass(pass) => pass_words(*pass).0.to_owned(),
            Purpose::Shared(functions) => {
                let alike = |other: &Block| match &other.purpose {
                    Purpose::Shared(others) => {
                        others != functions && (others[0], others.len()) == (functions[0], functions.len())
                    }
                    _ => false,
                };
                if functions.len() > 3 && !self.schedule.blocks.iter().any(alike) {
                    format!("common_{}_and_{}_more", self.name(functions[0]), functions.len() - 1)
                } else {
                    let names: Vec<_> = functions.iter().map(|&function| self.name(function)).collect();
                    format!("common_{}", names.join("_"))
                }
            }
            Purpose::Function(function) => format!("{}_itself", self.name(*function)),
        };
        match (block.part, block.lines[0]) {
            (0, _) => start,
            (_, Line::Let(place)) => format!("{start}_from_{}", names[&place]),
            (_, Line::Store(output, entry)) => match block.purpose {
                Purpose::Function(function) => {
                    format!("{start}_from_{}", self.program.functions[function].outputs[output].entry_name(entry))
                }
                _ => unreachable!("only functions write outputs"),
            },
        }
    }

    /// A quantity's function.
    fn function(&self, number: usize, codes: &[Code]) -> (TokenStream, FunctionReport) {
        let function = &self.program.functions[number];
        let own: Vec<usize> = match &self.schedule.parts[number] {
            Some(parts) => parts.iter().flat_map(|&part| self.schedule.functions[part].clone()).collect(),
            None => self.schedule.functions[number].clone().collect(),
        };
        let needed = needed(&own, codes);
        let mut body = TokenStream::new();
        for &block in &needed {
            let Code { name, fields, .. } = &codes[block];
            let arguments = self.arguments(codes, block);
            body.extend(match (self.within_its_function(block), fields.is_empty()) {
                (true, _) => codes[block].body.clone(),
                (false, true) => quote!(#name(#arguments);),
                (false, false) => quote!(let #name = #name(#arguments);),
            });
        }
        let name = self.name(number);
        let counts = self.counts(needed.iter().map(|&block| &self.schedule.blocks[block]));
        let report = FunctionReport {
            name: name.clone(),
            quantity: function.quantity,
            inputs: function.inputs.iter().map(|&array| self.program.inputs[array]).collect(),
            outputs: function.outputs.iter().map(|output| (output.name, output.shape, output.layers)).collect(),
            counts,
            code_bytes: counts.code_bytes(),
        };
        let doc = self.documentation(function, &report);
        let element = self.number();
        let read: BTreeSet<usize> = needed.iter().flat_map(|&block| &codes[block].inputs).copied().collect();
        let inputs = function.inputs.iter().map(|&array| {
            let input = &self.program.inputs[array];
            let (name, len) = (ident(input.name), Literal::usize_unsuffixed(input.len));
            let pattern = if read.contains(&array) { quote!(#name) } else { quote!(_) };
            quote!(#pattern: &[#element; #len])
        });
        let outputs = function.outputs.iter().map(|output| {
            let (name, shape) = (ident(output.name), self.output_type(output));
            let pattern = if output.places.is_empty() { quote!(_) } else { quote!(#name) };
            quote!(#pattern: &mut #shape)
        });
        let name = ident(&name);
        let tokens = quote! {
            #(#[doc = #doc])*
            pub fn #name(#(#inputs,)* #(#outputs),*) {
                #body
            }
        };
        (tokens, report)
    }

    /// The lines of a block, and what they read.
    fn lines(&self, scope: &Scope<'_>, block: &Block, names: &BTreeMap<Place, String>, foreign: &Foreign) -> Code {
        let own: BTreeSet<Place> = block.lines.iter().filter_map(place_of).collect();
        let outputs = match scope.purpose {
            Purpose::Function(function) => self.program.functions[*function].outputs.as_slice(),
            _ => &[],
        };
        let (inputs, blocks) = (RefCell::new(BTreeSet::new()), RefCell::new(BTreeSet::new()));
        let name = |place: Place| {
            if own.contains(&place) {
                let name = ident(&names[&place]);
                Some(quote!(#name))
            } else if let Some((block, value)) = foreign.get(&place) {
                blocks.borrow_mut().insert(*block);
                Some(value.clone())
            } else {
                if let Operation::Input(number) = self.program.graph.operation(place) {
                    inputs.borrow_mut().insert(self.program.input_of(number).0);
                }
                None
            }
        };
        let expressions = Expressions {
            program: self.program,
            precision: self.options.precision,
            lanes: self.options.lanes,
            lift: &|constant| self.lift(constant),
            names: &name,
        };
        let mut body = TokenStream::new();
        let mut heading = None;
        let mut paired: BTreeSet<Place> = BTreeSet::new();
        let angles = self.angles(&own);
        for line in &block.lines {
            let above = self.heading(scope, line, outputs);
            if self.comments && above.is_some() && above != heading {
                body.extend(quote!(section!(#above);));
                heading = above;
            }
            match *line {
                Line::Let(place) => match self.program.graph.operation(place) {
                    Operation::Sin(a) | Operation::Cos(a) => {
                        // What no line of this block computes is turned at once.
                        let at_once = self.options.lanes == Lanes::One && !self.reads(a, &own);
                        let group: Vec<Place> = if at_once {
                            angles.keys().copied().filter(|&a| !paired.contains(&a) && !self.reads(a, &own)).collect()
                        } else {
                            Some(a).filter(|a| !paired.contains(a)).into_iter().collect()
                        };
                        let pairs = group.iter().map(|a| {
                            let [sin, cos] = angles[a].map(|side| match side {
                                Some(place) => ident(&names[&place]),
                                None => ident("_"),
                            });
                            quote!((#sin, #cos))
                        });
                        body.extend(match *group {
                            [] => TokenStream::new(),
                            [a] => {
                                let both = expressions.sin_cos(a);
                                quote!(let #(#pairs)* = #both;)
                            }
                            _ => {
                                let each = expressions.sin_cos_each(&group);
                                quote!(let [#(#pairs),*] = #each;)
                            }
                        });
                        paired.extend(group);
                    }
                    _ => {
                        let (name, value) = (ident(&names[&place]), expressions.definition(place));
                        body.extend(quote!(let #name = #value;));
                    }
                },
                Line::Store(number, entry) => {
                    let target = target(&outputs[number], entry);
                    let value = expressions.output(outputs[number].places[entry]);
                    body.extend(quote!(#target = #value;));
                }
            }
        }
        Code {
            name: ident(&self.holder(block, names)),
            body,
            fields: block.exports.iter().map(|place| ident(&names[place])).collect(),
            inputs: inputs.into_inner(),
            blocks: blocks.into_inner(),
            outputs: block
                .lines
                .iter()
                .filter_map(|line| if let Line::Store(o, _) = line { Some(*o) } else { None })
                .collect(),
        }
    }

    /// Whether what `place` stands on, itself included, is among `places`.
    fn reads(&self, place: Place, places: &BTreeSet<Place>) -> bool {
        places.contains(&place)
            || self.program.graph.operation(place).operands().any(|operand| self.reads(operand, places))
    }

    /// The sine and cosine of each angle among `places`.
    fn angles(&self, places: &BTreeSet<Place>) -> BTreeMap<Place, [Option<Place>; 2]> {
        let mut angles: BTreeMap<Place, [Option<Place>; 2]> = BTreeMap::new();
        for &place in places {
            match self.program.graph.operation(place) {
                Operation::Sin(a) => angles.entry(a).or_default()[0] = Some(place),
                Operation::Cos(a) => angles.entry(a).or_default()[1] = Some(place),
                _ => {}
            }
        }
        angles
    }

    /// The comment under which a line stands.
    fn heading(&self, scope: &Scope<'_>, line: &Line, outputs: &[Output]) -> Option<String> {
        match *line {
            Line::Let(_) if !matches!(scope.purpose, Purpose::Pass(_)) => None,
            Line::Let(place) => scope.named(place).and_then(|named| self.parts.part(named)).map(str::to_owned),
            Line::Store(number, entry) => {
                let (output, [layer, column, _]) = (&outputs[number], outputs[number].index(entry));
                let layer = if output.layers > 1 { ["x, ", "y, ", "z, "][layer] } else { "" };
                let of = match (output.shape[1], self.parts.coordinates.len()) {
                    (1, _) => String::new(),
                    (columns, n) if columns == n => format!("column {}", self.parts.coordinates[column]),
                    (columns, n) if columns == 6 + n && column >= 6 => {
                        format!("column {}", self.parts.coordinates[column - 6])
                    }
                    _ => format!("column {column}"),
                };
                Some(format!("{} {layer}{of}", output.symbol).trim_end().to_owned())
            }
        }
    }

    /// What a block is given: inputs, other blocks, outputs.
    fn parameters(&self, block: &Block, codes: &[Code], number: usize) -> TokenStream {
        let (code, element) = (&codes[number], self.number());
        let inputs = code.inputs.iter().map(|&array| {
            let input = &self.program.inputs[array];
            let (name, len) = (ident(input.name), Literal::usize_unsuffixed(input.len));
            quote!(#name: &[#element; #len],)
        });
        let blocks = code.blocks.iter().map(|&other| {
            let (name, structure) = (&codes[other].name, structure(&codes[other].name));
            quote!(#name: &#structure,)
        });
        let outputs = self.written(block, code).map(|output| {
            let (name, shape) = (ident(output.name), self.output_type(output));
            quote!(#name: &mut #shape,)
        });
        quote!(#(#inputs)* #(#blocks)* #(#outputs)*)
    }

    /// The arguments that match [`parameters`](Self::parameters).
    fn arguments(&self, codes: &[Code], number: usize) -> TokenStream {
        let code = &codes[number];
        let inputs = code.inputs.iter().map(|&array| ident(self.program.inputs[array].name));
        let blocks = code.blocks.iter().map(|&other| &codes[other].name);
        let outputs = self.written(&self.schedule.blocks[number], code).map(|output| ident(output.name));
        quote!(#(#inputs,)* #(&#blocks,)* #(#outputs,)*)
    }

    /// The outputs that a block writes.
    fn written<'a>(&'a self, block: &Block, code: &'a Code) -> impl Iterator<Item = &'a Output> {
        let function = match block.purpose {
            Purpose::Function(function) => function,
            _ => 0,
        };
        code.outputs.iter().map(move |&output| &self.program.functions[function].outputs[output])
    }

    /// What some blocks perform.
    fn counts<'a>(&self, blocks: impl IntoIterator<Item = &'a Block>) -> Counts {
        let mut counts = Counts::default();
        let graph = &self.program.graph;
        for &place in blocks.into_iter().flat_map(|block| &block.operations).filter(|&&place| !graph.is_table(place)) {
            let operation = graph.operation(place);
            if graph.is_vector(place) { counts.count_of_vectors(operation) } else { counts.count(operation) }
        }
        counts
    }

    /// What a function is called.
    fn name(&self, function: usize) -> String {
        self.function_name(self.program.functions[function].quantity)
    }

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

    /// The type of a place.
    fn type_of(&self, place: Place) -> TokenStream {
        if self.program.graph.is_vector(place) { quote!(F64x4) } else { self.number() }
    }

    /// A constant where no operation lifts it to all lanes.
    fn lift(&self, constant: TokenStream) -> TokenStream {
        match self.options.lanes {
            Lanes::One => constant,
            _ => {
                let number = self.number();
                quote!(#number::splat(#constant))
            }
        }
    }

    /// The type behind an output.
    pub fn output_type(&self, output: &Output) -> TokenStream {
        let number = self.number();
        let [rows, columns] = output.shape.map(Literal::usize_unsuffixed);
        let layers = Literal::usize_unsuffixed(output.layers);
        match (output.shape, output.layers) {
            ([1, 1], 1) => number,
            ([_, 1], 1) => quote!([#number; #rows]),
            (_, 1) => quote!([[#number; #rows]; #columns]),
            _ => quote!([[[#number; #rows]; #columns]; #layers]),
        }
    }

    /// What the function of a quantity is called.
    pub fn function_name(&self, quantity: Quantity) -> String {
        match quantity {
            Quantity::Kinematics(link) => format!("kinematics_{}", self.parts.links[link]),
            _ => quantity.name().to_owned(),
        }
    }

    fn documentation(&self, function: &Function, report: &FunctionReport) -> Vec<String> {
        let mut doc = vec![format!(" {}", function.quantity.meaning()), String::new()];
        for &array in &function.inputs {
            let input = &self.program.inputs[array];
            doc.push(format!(" - `{}`: {} ({}; {})", input.name, input.meaning, input.len, input.unit));
        }
        for output in &function.outputs {
            let [rows, columns] = output.shape;
            let layers = if output.layers > 1 { format!("{} of ", output.layers) } else { String::new() };
            let shape = if columns == 1 { rows.to_string() } else { format!("{layers}{rows}×{columns}, by columns") };
            doc.push(format!(" - `{}`: {}, {} ({shape}; {})", output.name, output.symbol, output.meaning, output.unit));
        }
        doc.push(String::new());
        doc.push(format!(" {}; about {:.1} KiB of code.", report.counts, report.code_bytes as f64 / 1024.0));
        doc
    }
}

/// The entry of an output that is written.
fn target(output: &Output, entry: usize) -> TokenStream {
    let name = ident(output.name);
    let [layer, column, row] = output.index(entry).map(Literal::usize_unsuffixed);
    match (output.shape, output.layers) {
        ([1, 1], 1) => quote!(*#name),
        ([_, 1], 1) => quote!(#name[#row]),
        (_, 1) => quote!(#name[#column][#row]),
        _ => quote!(#name[#layer][#column][#row]),
    }
}

/// The blocks that `own` stand on, and they, in order.
fn needed(own: &[usize], codes: &[Code]) -> BTreeSet<usize> {
    let mut needed = BTreeSet::new();
    let mut open = own.to_vec();
    while let Some(block) = open.pop() {
        if needed.insert(block) {
            open.extend(&codes[block].blocks);
        }
    }
    needed
}

/// The parts of a long block: a module of their own, which is what a compiler treats in parallel.
fn module(name: &Ident, blocks: TokenStream) -> TokenStream {
    quote! {
        use #name::*;
        mod #name {
            #[allow(unused_imports, reason = "not every block stands on others")]
            use super::*;
            #blocks
        }
    }
}

/// The structure that a block returns.
fn structure(name: &Ident) -> Ident {
    ident(&camel_case(&name.to_string()))
}
