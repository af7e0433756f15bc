//! Places in a text.

use std::sync::Arc;

use crate::model::{Place, Problem};

/// A text and the name of its file.
pub(super) struct Source<'a> {
    pub text: &'a str,
    file: Arc<str>,
}

impl<'a> Source<'a> {
    pub fn new(text: &'a str, file: &str) -> Self {
        Self { text, file: file.into() }
    }

    /// The place at a line and column, both from 1.
    pub fn place(&self, line: usize, column: usize) -> Place {
        Place { file: self.file.clone(), line, column }
    }

    /// The place of a byte.
    pub fn place_of(&self, offset: usize) -> Place {
        Cursor::default().advance(self, offset)
    }

    /// Gives each problem the place of the byte it was found at, and sorts them by it; reads the text once.
    pub fn settle(&self, mut findings: Vec<(usize, Problem)>) -> Vec<Problem> {
        findings.sort_by_key(|(offset, _)| *offset);
        let mut cursor = Cursor::default();
        let settle = |(offset, problem)| Problem { place: Some(cursor.advance(self, offset)), ..problem };
        findings.into_iter().map(settle).collect()
    }
}

/// A reader's finger: lines and characters before a byte.
#[derive(Default)]
struct Cursor {
    offset: usize,
    line: usize,
    column: usize,
}

impl Cursor {
    /// Moves on to the byte `offset`, not before the last one.
    fn advance(&mut self, source: &Source<'_>, offset: usize) -> Place {
        for character in source.text[self.offset..offset].chars() {
            if character == '\n' {
                (self.line, self.column) = (self.line + 1, 0);
            } else {
                self.column += 1;
            }
        }
        self.offset = offset;
        source.place(self.line + 1, self.column + 1)
    }
}
