//! Blocks too long for a compiler to digest in linear time, cut.

use crate::record::Place;
use crate::schedule::{Block, Line, Purpose};

/// Operations up to which a block stays whole: about 48 KiB of machine code. Beyond the instruction cache (32 KiB), straight-line
/// code gains nothing from standing together.
const WHOLE: usize = 4000;

/// Operations of the parts of a longer block: compile time then grows with the length of the code and no faster.
const PART: usize = 300;

/// Cuts lines into blocks.
pub struct Cutter {
    blocks: Vec<Block>,
    part: usize,
}

impl Cutter {
    /// Ready for a block of so many operations.
    pub fn new(purpose: Purpose, operations: usize) -> Self {
        let part = if operations > WHOLE { PART } else { usize::MAX };
        Self { blocks: vec![Block::new(purpose, 0)], part }
    }

    /// Performs an operation, on a line of its own if it gets a name.
    pub fn operation(&mut self, place: Place, named: bool) {
        let last = self.blocks.last_mut().expect("there is a block");
        last.operations.push(place);
        if named {
            last.lines.push(Line::Let(place));
            if last.operations.len() >= self.part {
                let next = Block::new(last.purpose.clone(), last.part + 1);
                self.blocks.push(next);
            }
        }
    }

    /// Adds a line.
    pub fn line(&mut self, line: Line) {
        self.blocks.last_mut().expect("there is a block").lines.push(line);
    }

    /// The blocks that hold something.
    pub fn finish(mut self) -> Vec<Block> {
        self.blocks.retain(|block| !block.lines.is_empty());
        self.blocks
    }
}
