//! Which block computes a place, and what stands in a block.
//!
//! The sweeps' named quantities belong to their passes, and with them what only they need. What several functions have in
//! common beyond that belongs to them together, and the rest to one function, or is repeated where it is read.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use frs_core::Pass;

use crate::cut::Cutter;
use crate::program::{Function, Program};
use crate::record::{Operation, Place};
use crate::schedule::{Block, Line, Purpose};

/// Operations that several quantities must have in common for a block of their own; fewer are repeated.
const WORTH_SHARING: usize = 200;

/// Nested operations beyond which an expression gets a name of its own.
const DEPTH: u32 = 12;

/// Where each place of a program is computed.
pub struct Homes<'p> {
    program: &'p Program,
    live: Vec<bool>,
    /// The purpose whose block computes a place for others.
    pub home: Vec<Option<Purpose>>,
    /// Functions that only put others together: which.
    pub parts: Vec<Option<Vec<usize>>>,
}

impl<'p> Homes<'p> {
    /// Gives every place its home.
    pub fn new(program: &'p Program) -> Self {
        let live = live(program);
        let home = vec![None; live.len()];
        let parts = (0..program.functions.len()).map(|number| put_together(program, number)).collect();
        let mut homes = Self { program, live, home, parts };
        for (&place, named) in program.sweeps.iter().filter(|(place, _)| homes.live[**place as usize]) {
            homes.home[place as usize] = Some(Purpose::Pass(named.pass));
        }
        homes.settle();
        // What others read as well is computed as early as it can be, so that they need no later pass for it.
        let earliest = homes.earliest();
        for place in homes.read_elsewhere() {
            if !program.sweeps.contains_key(&place) {
                homes.home[place as usize] = earliest[place as usize].map(Purpose::Pass);
            }
        }
        homes.settle();
        homes.find_common();
        homes
    }

    /// What a pass reads is computed there or before it.
    fn settle(&mut self) {
        for place in (0..self.live.len()).rev().filter(|&place| self.live[place]) {
            for operand in self.program.graph.operation(place as Place).operands() {
                let both = [self.home[operand as usize].take(), self.home[place].clone()];
                self.home[operand as usize] = both.into_iter().flatten().min();
            }
        }
    }

    /// The first pass after which each place can be computed.
    fn earliest(&self) -> Vec<Option<Pass>> {
        let mut earliest: Vec<Option<Pass>> = Vec::with_capacity(self.live.len());
        for (place, operation) in (0..).zip(self.program.graph.operations()) {
            earliest.push(match (self.program.sweeps.get(&place), operation) {
                (Some(named), _) => Some(named.pass),
                (None, Operation::Constant(_)) => None,
                (None, Operation::Input(number)) => match self.program.inputs[self.program.input_of(*number).0].name {
                    "qd" => Some(Pass::Velocities),
                    _ => Some(Pass::Poses),
                },
                (None, _) => operation.operands().filter_map(|operand| earliest[operand as usize]).max(),
            });
        }
        earliest
    }

    /// The places of passes that others read: other passes, functions, or outputs.
    fn read_elsewhere(&self) -> BTreeSet<Place> {
        let mut read = BTreeSet::new();
        for place in (0..self.live.len() as Place).filter(|&place| self.live[place as usize]) {
            let differs = |operand: &Place| self.home[*operand as usize] != self.home[place as usize];
            read.extend(self.reads(place).filter(differs));
        }
        read.extend(self.program.functions.iter().flat_map(outputs).filter_map(|place| self.value(place)));
        read.retain(|place| self.home[*place as usize].is_some());
        read
    }

    /// Gives what several functions have in common, beyond the passes, a block of its own.
    fn find_common(&mut self) {
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); self.live.len()];
        for (number, function) in self.program.functions.iter().enumerate() {
            if self.parts[number].is_none() {
                for place in self.cone(outputs(function), |place| self.home[place as usize].is_none()) {
                    users[place as usize].push(number);
                }
            }
        }
        let mut sizes: HashMap<&[usize], usize> = HashMap::new();
        for (place, users) in users.iter().enumerate().filter(|(_, users)| users.len() > 1) {
            let counts = self.value(place as Place) == Some(place as Place);
            *sizes.entry(users).or_default() += usize::from(counts);
        }
        for (place, users) in users.iter().enumerate() {
            if sizes.get(users.as_slice()).is_some_and(|&size| size >= WORTH_SHARING) {
                self.home[place] = Some(Purpose::Shared(users.clone()));
            }
        }
    }

    /// The place whose value stands behind signs and lanes; nothing for what is written where it is read.
    fn value(&self, place: Place) -> Option<Place> {
        let operation = self.program.graph.operation(place);
        match (operation, operation.handed_on()) {
            (_, Some(a)) => self.value(a),
            (Operation::Input(_) | Operation::Constant(_), _) => None,
            _ => Some(place).filter(|&place| !self.program.graph.is_table(place)),
        }
    }

    /// The code of a purpose that others read.
    pub fn shared_blocks(&self, purpose: Purpose) -> Vec<Block> {
        let at_home = |place: Place| self.home[place as usize].as_ref() == Some(&purpose);
        let exports: BTreeSet<Place> = self.read_elsewhere().into_iter().filter(|&place| at_home(place)).collect();
        let own = self.cone(exports.iter().copied(), |place| at_home(place) || self.home[place as usize].is_none());
        let known = |place: &Place| match &purpose {
            Purpose::Shared(functions) => self.program.functions[functions[0]].scratch.contains_key(place),
            _ => self.program.sweeps.contains_key(place),
        };
        let lets = self.lets(&own, |place| known(&place) || exports.contains(&place), &[]);
        let mut blocks = Cutter::new(purpose, own.len());
        for place in own {
            blocks.operation(place, lets.contains(&place));
        }
        blocks.finish()
    }

    /// The code of a function, without what it shares.
    pub fn function_blocks(&self, number: usize) -> Vec<Block> {
        let function = &self.program.functions[number];
        let within = |place: Place| self.home[place as usize].is_none();
        let roots: Vec<Place> =
            outputs(function).filter_map(|place| self.value(place)).filter(|&p| within(p)).collect();
        let own = self.cone(roots.iter().copied(), within);
        let lets = self.lets(&own, |place| function.scratch.contains_key(&place), &roots);
        let mut blocks = Cutter::new(Purpose::Function(number), own.len());
        let mut done: BTreeSet<Place> = BTreeSet::new();
        for (number, output) in function.outputs.iter().enumerate() {
            for (entry, &place) in output.places.iter().enumerate() {
                let cone = self.cone([place], |place| within(place) && !done.contains(&place));
                for &place in &cone {
                    blocks.operation(place, lets.contains(&place));
                }
                done.extend(cone);
                blocks.line(Line::Store(number, entry));
            }
        }
        blocks.finish()
    }

    /// What `roots` stand on within a part of the program, operands first.
    fn cone(&self, roots: impl IntoIterator<Item = Place>, within: impl Fn(Place) -> bool) -> BTreeSet<Place> {
        let mut cone = BTreeSet::new();
        let mut open: Vec<Place> = roots.into_iter().collect();
        while let Some(place) = open.pop() {
            if within(place) && cone.insert(place) {
                open.extend(self.program.graph.operation(place).operands());
            }
        }
        cone
    }

    /// The places of a part that get a line of their own: what has a name, is read more than once, or is deeply nested.
    ///
    /// `roots` are read once more, from outside.
    fn lets(&self, own: &BTreeSet<Place>, named: impl Fn(Place) -> bool, roots: &[Place]) -> BTreeSet<Place> {
        let mut reads: BTreeMap<Place, u32> = BTreeMap::new();
        let operands = own.iter().flat_map(|&place| self.reads(place));
        for place in operands.chain(roots.iter().copied()) {
            *reads.entry(place).or_default() += 1;
        }
        let mut depth: BTreeMap<Place, u32> = BTreeMap::new();
        let mut lets = BTreeSet::new();
        for &place in own.iter().filter(|&&place| self.value(place) == Some(place)) {
            let operation = self.program.graph.operation(place);
            let nested = self.reads(place).filter_map(|operand| depth.get(&operand)).max().copied().unwrap_or(0) + 1;
            let function = matches!(operation, Operation::Sin(_) | Operation::Cos(_));
            if named(place) || function || nested > DEPTH || reads.get(&place).is_some_and(|&count| count > 1) {
                lets.insert(place);
            } else {
                depth.insert(place, nested);
            }
        }
        lets
    }

    /// The values that a place reads, signs and lanes passed over; none for a sign itself.
    fn reads(&self, place: Place) -> impl Iterator<Item = Place> {
        let operation = self.program.graph.operation(place);
        let hands_on = operation.handed_on().is_some();
        operation.operands().filter(move |_| !hands_on).filter_map(|operand| self.value(operand))
    }

    /// The first place that reads each place, and as which operand.
    pub fn first_readers(&self) -> Vec<Option<(Place, usize)>> {
        let mut reader = vec![None; self.live.len()];
        for (place, operation) in (0..).zip(self.program.graph.operations()).filter(|(p, _)| self.live[*p as usize]) {
            for (position, operand) in operation.operands().enumerate() {
                reader[operand as usize].get_or_insert((place, position));
            }
        }
        reader
    }
}

/// The functions that a function puts together, if its outputs are nothing else.
fn put_together(program: &Program, number: usize) -> Option<Vec<usize>> {
    let function = &program.functions[number];
    let mut rest = function.outputs.as_slice();
    let mut parts = Vec::new();
    while !rest.is_empty() {
        let part = program.functions.iter().position(|other| {
            let len = other.outputs.len();
            len < function.outputs.len()
                && rest.len() >= len
                && other.outputs.iter().zip(rest).all(|(a, b)| a.name == b.name && a.places == b.places)
        })?;
        rest = &rest[program.functions[part].outputs.len()..];
        parts.push(part);
    }
    Some(parts)
}

/// The places a function writes.
fn outputs(function: &Function) -> impl Iterator<Item = Place> {
    function.outputs.iter().flat_map(|output| output.places.iter().copied())
}

/// Which places the outputs stand on.
pub fn live(program: &Program) -> Vec<bool> {
    let operations = program.graph.operations();
    let mut live = vec![false; operations.len()];
    program.functions.iter().flat_map(outputs).for_each(|place| live[place as usize] = true);
    for place in (0..operations.len()).rev() {
        if live[place] {
            operations[place].operands().for_each(|operand| live[operand as usize] = true);
        }
    }
    live
}
