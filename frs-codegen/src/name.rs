//! Names that come from the robot and the mathematics.

use std::collections::{BTreeMap, BTreeSet};

use frs_core::Model;

use crate::program::{Function, Named, Program};
use crate::record::{Operation, Place};
use crate::schedule::{Line, Purpose, Schedule, place_of};

/// Quantities that belong to a joint rather than to a body.
const JOINT_SYMBOLS: [&str; 10] =
    ["screw", "inside", "outside", "connection", "reaction", "six", "six_more", "three", "three_more", "inverse_pivot"];

/// The names of a robot's parts, as pieces of identifiers; no two bodies and no two coordinates share one.
pub struct Parts {
    /// Of each body: its first link's.
    pub bodies: Vec<String>,
    /// Of each coordinate.
    pub coordinates: Vec<String>,
    /// Of each link.
    pub links: Vec<String>,
    /// Of the joint of each body: its coordinate's where it has one of its own, else the body's.
    pub joints: Vec<String>,
}

impl Parts {
    /// The names of `model`'s parts.
    pub fn new(model: &Model) -> Self {
        let coordinates = distinct(model.coordinates().iter().map(|coordinate| snake_case(&coordinate.name)));
        let own = |k: usize| model.coordinates().iter().position(|coordinate| coordinate.body == k);
        let bodies = distinct((0..model.bodies().len()).map(|k| {
            let link = model.links().iter().find(|link| link.body == k);
            match (link, own(k)) {
                (Some(link), _) => snake_case(&link.name),
                (None, Some(c)) => coordinates[c].clone(),
                (None, None) => format!("body_{k}"),
            }
        }));
        let joints =
            distinct((0..bodies.len()).map(|k| own(k).map_or_else(|| bodies[k].clone(), |c| coordinates[c].clone())));
        let links = distinct(model.links().iter().map(|link| snake_case(&link.name)));
        Self { bodies, coordinates, links, joints }
    }

    /// The name of the part that a place belongs to.
    pub fn part(&self, named: &Named) -> Option<&str> {
        let parts = if JOINT_SYMBOLS.contains(&named.symbol) { &self.joints } else { &self.bodies };
        named.body.map(|k| parts[k].as_str())
    }

    /// The identifier of a place.
    fn identifier(&self, named: &Named) -> String {
        let minus = if named.minus { "minus_" } else { "" };
        match self.part(named) {
            Some(part) => format!("{minus}{}_{part}_{}", named.symbol, named.component),
            None => format!("{minus}{}_{}", named.symbol, named.component),
        }
    }
}

/// Any text as a piece of an identifier in snake case: letters and digits of ASCII stay, what stands for a space becomes
/// `_`, everything else its code point.
pub fn snake_case(text: &str) -> String {
    let mut name = String::new();
    let mut before = None;
    for c in text.chars() {
        match c {
            'A'..='Z' => {
                if before.is_some_and(|b: char| b.is_ascii_lowercase() || b.is_ascii_digit()) {
                    name.push('_');
                }
                name.push(c.to_ascii_lowercase());
            }
            'a'..='z' | '0'..='9' => name.push(c),
            '_' | '-' | '.' | '/' | ' ' => name.push('_'),
            _ => name.push_str(&format!("u{:x}", u32::from(c))),
        }
        before = Some(c);
    }
    let words: Vec<&str> = name.split('_').filter(|word| !word.is_empty()).collect();
    if words.is_empty() { "unnamed".to_owned() } else { words.join("_") }
}

/// A robot's name as a type's.
///
/// ```
/// use frs_codegen::camel_case;
/// assert_eq!(camel_case("lwr_satellite"), "LwrSatellite");
/// assert_eq!([camel_case("b_2_11"), camel_case("b_21_1")], ["B2_11", "B21_1"]); // numbers stay apart
/// ```
pub fn camel_case(text: &str) -> String {
    let mut name = String::new();
    for word in snake_case(text).split('_') {
        let mut letters = word.chars();
        if let Some(first) = letters.next() {
            if first.is_ascii_digit() && name.ends_with(|last: char| last.is_ascii_digit()) {
                name.push('_');
            }
            name.push(first.to_ascii_uppercase());
            name.push_str(letters.as_str());
        }
    }
    match name.chars().next() {
        Some(first) if first.is_ascii_alphabetic() && name != "Self" => name,
        _ => format!("Robot{name}"),
    }
}

/// A robot's name as a module's or a file's.
pub fn module_name(text: &str) -> String {
    let name = snake_case(text);
    let plain = name.starts_with(|c: char| c.is_ascii_lowercase()) && syn::parse_str::<syn::Ident>(&name).is_ok();
    if plain { name } else { format!("robot_{name}") }
}

/// The same names, those met before told apart by their number among their like.
fn distinct(names: impl Iterator<Item = String>) -> Vec<String> {
    let mut taken: BTreeSet<String> = BTreeSet::new();
    names
        .map(|name| {
            let mut candidate = name.clone();
            let mut number = 2;
            while !taken.insert(candidate.clone()) {
                candidate = format!("{name}_{number}");
                number += 1;
            }
            candidate
        })
        .collect()
}

/// The part of a program that names are given in: all blocks of one purpose.
pub struct Scope<'p> {
    /// The program.
    pub program: &'p Program,
    /// The schedule.
    pub schedule: &'p Schedule,
    /// What the blocks are for.
    pub purpose: &'p Purpose,
}

/// Names for the places that `lines` define.
///
/// What the sweeps name keeps that name. Anything else is called after what reads it first, and after its position
/// there, so that a change elsewhere does not rename it.
pub fn names(scope: &Scope<'_>, parts: &Parts, lines: &[Line]) -> BTreeMap<Place, String> {
    let defined: BTreeSet<Place> = lines.iter().filter_map(place_of).collect();
    let mut names: BTreeMap<Place, String> = BTreeMap::new();
    let mut taken: BTreeSet<String> = BTreeSet::new();
    let mut claim = |mut name: String| {
        while !taken.insert(name.clone()) {
            name.push('x');
        }
        name
    };
    for &place in &defined {
        if let Some(name) = scope.own_name(place, parts) {
            names.insert(place, claim(name));
        }
    }
    let fixed: BTreeSet<Place> = names.keys().copied().collect();
    // How well the reader after which a place is called says what it is: a part's quantity, any quantity, anything.
    let mut ranks: BTreeMap<Place, u8> = BTreeMap::new();
    for line in lines.iter().rev() {
        let (root, owner) = match *line {
            Line::Let(place) => {
                // What only others read is called after them.
                let name = names.get(&place).cloned().unwrap_or_else(|| scope.outer_name(place, parts));
                let name = if fixed.contains(&place) { name } else { claim(name) };
                names.insert(place, name.clone());
                (place, name)
            }
            Line::Store(number, entry) => {
                let output = &scope.function().expect("only functions write outputs").outputs[number];
                (output.places[entry], output.entry_name(entry))
            }
        };
        let mut leaves = Vec::new();
        scope.leaves(root, matches!(line, Line::Let(_)), &defined, &mut leaves);
        let whole = leaves.len() == 1 && matches!(line, Line::Store(..));
        let rank = match scope.named(root).filter(|_| fixed.contains(&root)) {
            Some(named) => u8::from(named.body.is_none()),
            None => 2,
        };
        for (position, leaf) in leaves.into_iter().enumerate() {
            let called = ranks.get(&leaf).is_some_and(|&before| before < rank);
            if defined.contains(&leaf) && !fixed.contains(&leaf) && !called {
                ranks.insert(leaf, rank);
                names.insert(leaf, if whole { owner.clone() } else { format!("{owner}_{position}") });
            }
        }
    }
    names
}

impl Scope<'_> {
    /// The function whose scratch has names here: the first of those that share a block.
    pub fn function(&self) -> Option<&Function> {
        match self.purpose {
            Purpose::Pass(_) => None,
            Purpose::Shared(functions) => Some(&self.program.functions[functions[0]]),
            Purpose::Function(function) => Some(&self.program.functions[*function]),
        }
    }

    /// The name that a place has by what it is.
    fn own_name(&self, place: Place, parts: &Parts) -> Option<String> {
        let angle = |a: Place| match self.program.graph.operation(a) {
            Operation::Input(number) => match self.program.input_of(number) {
                (array, index) if self.program.inputs[array].name == "q" => Some(parts.coordinates[index].as_str()),
                _ => None,
            },
            _ => None,
        };
        match self.program.graph.operation(place) {
            Operation::Sin(a) => angle(a).map(|name| format!("sin_{name}")),
            Operation::Cos(a) => angle(a).map(|name| format!("cos_{name}")),
            _ => self.named(place).map(|named| {
                let group = if self.program.graph.is_vector(place) { "_x4" } else { "" };
                parts.identifier(named) + group
            }),
        }
    }

    /// A name after where `place` is written, or after the first place with a name of its own that stands on it, through
    /// its first readers.
    fn outer_name(&self, place: Place, parts: &Parts) -> String {
        if let Some(&[function, output, entry]) = self.schedule.written.get(&place) {
            return self.program.functions[function].outputs[output].entry_name(entry);
        }
        let (reader, position) = self.schedule.reader[place as usize].expect("a place is read or written");
        let owner = self.own_name(reader, parts).unwrap_or_else(|| self.outer_name(reader, parts));
        if self.program.graph.operation(reader).handed_on().is_some() { owner } else { format!("{owner}_{position}") }
    }

    /// What the sweeps or the question call a place.
    pub fn named(&self, place: Place) -> Option<&Named> {
        let scratch = self.function().and_then(|function| function.scratch.get(&place));
        scratch.or_else(|| self.program.sweeps.get(&place))
    }

    /// The leaves of the expression that computes `place`, from left to right; `enter` looks into a place that has a name.
    fn leaves(&self, place: Place, enter: bool, defined: &BTreeSet<Place>, leaves: &mut Vec<Place>) {
        let operation = self.program.graph.operation(place);
        let home = self.schedule.home[place as usize].as_ref();
        let elsewhere = home.is_some() && home != Some(self.purpose);
        let plain = matches!(operation, Operation::Input(_) | Operation::Constant(_));
        if plain || elsewhere || (!enter && defined.contains(&place)) {
            leaves.push(place);
        } else {
            for operand in operation.operands() {
                self.leaves(operand, false, defined, leaves);
            }
        }
    }
}
