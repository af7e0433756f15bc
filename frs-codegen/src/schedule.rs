//! The code of a robot as blocks of straight-line code, in an order in which what is read comes first.
//!
//! What a pass of the sweeps computes is a shared block, as in the core; so is what several quantities compute alike. The
//! rest belongs to its quantity.

use std::collections::{BTreeSet, HashMap};
use std::ops::Range;

use frs_core::Pass;

use crate::home::Homes;
use crate::program::Program;
use crate::record::Place;

/// A line of generated code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// The place gets a name.
    Let(Place),
    /// An entry of an output is written: output, entry.
    Store(usize, usize),
}

/// What a block is for.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Purpose {
    /// A pass of the sweeps.
    Pass(Pass),
    /// What these functions have in common.
    Shared(Vec<usize>),
    /// A function.
    Function(usize),
}

/// Straight-line code.
#[derive(Debug)]
pub struct Block {
    /// What it is for.
    pub purpose: Purpose,
    /// Which part of that, from 0.
    pub part: usize,
    /// Its lines.
    pub lines: Vec<Line>,
    /// All operations it performs, those within expressions included.
    pub operations: Vec<Place>,
    /// Places that later blocks read from it.
    pub exports: BTreeSet<Place>,
}

/// The code of a robot.
pub struct Schedule {
    /// All blocks, in an order in which what is read comes first.
    pub blocks: Vec<Block>,
    /// The blocks of each function: its own.
    pub functions: Vec<Range<usize>>,
    /// Functions that only put others together: which, in the order of their outputs.
    pub parts: Vec<Option<Vec<usize>>>,
    /// The block that computes a place for others.
    pub home: Vec<Option<Purpose>>,
    /// The first place that reads a place, and as which operand.
    pub reader: Vec<Option<(Place, usize)>>,
    /// The first output entry that a place is written to: function, output, entry.
    pub written: HashMap<Place, [usize; 3]>,
}

impl Schedule {
    /// Orders a program.
    pub fn new(program: &Program) -> Self {
        let homes = Homes::new(program);
        let mut blocks = Vec::new();
        let purposes: BTreeSet<Purpose> = homes.home.iter().flatten().cloned().collect();
        let (passes, mut shared): (Vec<_>, Vec<_>) =
            purposes.into_iter().partition(|purpose| matches!(purpose, Purpose::Pass(_)));
        // What more functions have in common is read by what fewer have.
        shared.sort_by_key(|purpose| match purpose {
            Purpose::Shared(functions) => std::cmp::Reverse(functions.len()),
            _ => std::cmp::Reverse(0),
        });
        for purpose in passes.into_iter().chain(shared) {
            blocks.extend(homes.shared_blocks(purpose));
        }
        let mut functions = Vec::new();
        for number in 0..program.functions.len() {
            let start = blocks.len();
            if homes.parts[number].is_none() {
                blocks.extend(homes.function_blocks(number));
            }
            functions.push(start..blocks.len());
        }
        let (reader, written) = (homes.first_readers(), written(program));
        let mut schedule = Self { reader, written, parts: homes.parts, home: homes.home, blocks, functions };
        schedule.export(program);
        schedule
    }

    /// Marks what blocks read from earlier ones.
    fn export(&mut self, program: &Program) {
        let mut shared: HashMap<Place, usize> = HashMap::new();
        let mut exports: Vec<BTreeSet<Place>> = vec![BTreeSet::new(); self.blocks.len()];
        for (number, block) in self.blocks.iter().enumerate() {
            let lets = || block.lines.iter().filter_map(place_of);
            let own: BTreeSet<Place> = lets().collect();
            // Earlier parts of the same.
            let before: HashMap<Place, usize> = (number - block.part..number)
                .flat_map(|part| self.blocks[part].lines.iter().filter_map(place_of).map(move |place| (place, part)))
                .collect();
            for line in &block.lines {
                let mut open: Vec<Place> = match (*line, &block.purpose) {
                    (Line::Store(output, entry), Purpose::Function(function)) => {
                        vec![program.functions[*function].outputs[output].places[entry]]
                    }
                    (line, _) => {
                        place_of(&line).into_iter().flat_map(|p| program.graph.operation(p).operands()).collect()
                    }
                };
                while let Some(place) = open.pop() {
                    match before.get(&place).or_else(|| shared.get(&place)) {
                        _ if own.contains(&place) => {}
                        Some(&earlier) => {
                            exports[earlier].insert(place);
                        }
                        None => open.extend(program.graph.operation(place).operands()),
                    }
                }
            }
            let at_home = |place: &Place| self.home[*place as usize].as_ref() == Some(&block.purpose);
            shared.extend(lets().filter(at_home).map(|place| (place, number)));
        }
        for (block, exports) in self.blocks.iter_mut().zip(exports) {
            block.exports = exports;
        }
    }
}

/// The place that a line defines.
pub fn place_of(line: &Line) -> Option<Place> {
    match line {
        Line::Let(place) => Some(*place),
        Line::Store(..) => None,
    }
}

impl Block {
    /// A block without lines.
    pub fn new(purpose: Purpose, part: usize) -> Self {
        Self { purpose, part, lines: Vec::new(), operations: Vec::new(), exports: BTreeSet::new() }
    }
}

/// The first output entry that each place is written to.
fn written(program: &Program) -> HashMap<Place, [usize; 3]> {
    let mut written = HashMap::new();
    for (function, one) in program.functions.iter().enumerate() {
        for (output, places) in one.outputs.iter().map(|output| &output.places).enumerate() {
            for (entry, &place) in places.iter().enumerate() {
                written.entry(place).or_insert([function, output, entry]);
            }
        }
    }
    written
}
