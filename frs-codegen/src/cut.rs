//! Blocks too long for a compiler to digest in linear time, cut.

use crate::record::Place;
use crate::schedule::{Block, Line, Purpose};

/// Operations up to which a block stays whole: about 40 KiB of machine code. Beyond the instruction cache (32 KiB), straight-line
/// code gains nothing from standing together.
const WHOLE: usize = 3300;

/// Operations and written entries of the parts of a longer block: compile time then grows with the length of the code and no
/// faster.
const PART: usize = 300;

/// Cuts lines into blocks.
pub struct Cutter {
    blocks: Vec<Block>,
    part: usize,
    filled: usize,
}

impl Cutter {
    /// Ready for a block of so many operations.
    pub fn new(purpose: Purpose, operations: usize) -> Self {
        let part = if operations > WHOLE { PART } else { usize::MAX };
        Self { blocks: vec![Block::new(purpose, 0)], part, filled: 0 }
    }

    /// Performs an operation, on a line of its own if it gets a name.
    pub fn operation(&mut self, place: Place, named: bool) {
        self.last().operations.push(place);
        self.filled += 1;
        if named {
            self.line(Line::Let(place));
        }
    }

    /// Adds a line that completes what was performed.
    pub fn line(&mut self, line: Line) {
        self.last().lines.push(line);
        self.filled += usize::from(matches!(line, Line::Store(..)));
        if self.filled >= self.part {
            let next = Block::new(self.last().purpose.clone(), self.last().part + 1);
            self.blocks.push(next);
            self.filled = 0;
        }
    }

    fn last(&mut self) -> &mut Block {
        self.blocks.last_mut().expect("there is a block")
    }

    /// The blocks that hold something.
    pub fn finish(mut self) -> Vec<Block> {
        self.blocks.retain(|block| !block.lines.is_empty());
        self.blocks
    }
}
