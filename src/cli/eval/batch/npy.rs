//! States and answers as NumPy's `.npy`, read and written piece by piece.

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use ndarray::{ArrayView2, ArrayViewMut2};
use npyz::{DType, NpyHeader, Order, WriteOptions, WriterBuilder};

use super::super::super::Failure;
use super::beside::Beside;
use super::{Sink, Source};

/// A file of states.
pub struct Reader {
    path: PathBuf,
    file: BufReader<File>,
    /// Where the numbers begin.
    begin: u64,
    /// Bytes of a number.
    size: usize,
    order: Order,
    states: usize,
    /// States that have been read.
    done: usize,
    bytes: Vec<u8>,
}

impl Reader {
    /// Opens a file with a state a row of `width` numbers, which are `what`.
    pub fn open(path: &Path, what: &str, width: usize) -> Result<Self, Failure> {
        let failed = |fact: &dyn std::fmt::Display| Failure::Input(format!("{}: {fact}", path.display()));
        let file = File::open(path).map_err(|error| failed(&format_args!("cannot be opened: {error}")))?;
        let len = file.metadata().map_or(0, |about| about.len());
        let mut file = BufReader::new(file);
        let header = NpyHeader::from_reader(&mut file)
            .map_err(|error| failed(&format_args!("this is no .npy file: {error}")))?;
        let begin = file.stream_position().map_err(|error| failed(&error))?;
        let kind = match header.dtype() {
            DType::Plain(kind) => kind.to_string(),
            other => other.descr(),
        };
        let size = match kind.as_str() {
            "<f8" => 8,
            "<f4" => 4,
            _ => {
                return Err(failed(&format_args!(
                    "numbers are of type {kind}; expected <f8 or <f4; write array.astype('<f8')"
                )));
            }
        };
        let (states, found) = match *header.shape() {
            [states, found] => (states, found),
            ref other => {
                let axes = other.len();
                return Err(failed(&format_args!(
                    "the array has {axes} axes; expected 2: a state a row, of {width} numbers: {what}"
                )));
            }
        };
        if found != width as u64 {
            return Err(failed(&format_args!("rows have {found} numbers; expected {width}: {what}")));
        }
        let expected = begin + states * found * size as u64;
        if len < expected {
            return Err(failed(&format_args!(
                "the file ends after {len} bytes; expected {expected} for {states} states"
            )));
        }
        let states = usize::try_from(states).map_err(|error| failed(&error))?;
        Ok(Self { path: path.to_owned(), file, begin, size, order: header.order(), states, done: 0, bytes: Vec::new() })
    }

    /// The next `count` numbers of the file.
    fn numbers(&mut self, count: usize) -> std::io::Result<impl Iterator<Item = f64>> {
        self.bytes.resize(count * self.size, 0);
        self.file.read_exact(&mut self.bytes)?;
        let size = self.size;
        Ok(self.bytes.chunks_exact(size).map(move |bytes| match *bytes {
            [a, b, c, d] => f64::from(f32::from_le_bytes([a, b, c, d])),
            _ => f64::from_le_bytes(std::array::from_fn(|i| bytes[i])),
        }))
    }

    fn rows(&mut self, rows: &mut ArrayViewMut2<'_, f64>) -> std::io::Result<()> {
        let (count, width) = rows.dim();
        match self.order {
            Order::C => rows.iter_mut().zip(self.numbers(count * width)?).for_each(|(entry, number)| *entry = number),
            Order::Fortran => {
                for (number, mut column) in rows.columns_mut().into_iter().enumerate() {
                    let before = (number * self.states + self.done) * self.size;
                    self.file.seek(SeekFrom::Start(self.begin + before as u64))?;
                    column.iter_mut().zip(self.numbers(count)?).for_each(|(entry, number)| *entry = number);
                }
            }
        }
        self.done += count;
        Ok(())
    }
}

impl Source for Reader {
    fn states(&self) -> usize {
        self.states
    }

    fn read(&mut self, rows: &mut ArrayViewMut2<'_, f64>) -> Result<(), Failure> {
        self.rows(rows).map_err(|error| Failure::Input(format!("{}: cannot be read: {error}", self.path.display())))
    }
}

/// A file of answers.
pub struct Writer {
    file: Beside,
    bytes: Vec<u8>,
}

impl Writer {
    /// Begins a file of `states` rows of `width` doubles.
    pub fn create(path: &Path, states: usize, width: usize) -> Result<Self, Failure> {
        let mut file = Beside::create(path)?;
        let header = WriteOptions::<f64>::new().default_dtype().shape(&[states as u64, width as u64]).writer(&mut file);
        let begun = header.write_header_only();
        match begun {
            Ok(_) => Ok(Self { file, bytes: Vec::new() }),
            Err(error) => Err(file.failed(&error)),
        }
    }
}

impl Sink for Writer {
    fn write(&mut self, rows: ArrayView2<'_, f64>) -> Result<(), Failure> {
        self.bytes.clear();
        self.bytes.extend(rows.iter().flat_map(|number| number.to_le_bytes()));
        self.file.write_all(&self.bytes).map_err(|error| self.file.failed(&error))
    }

    fn finish(self: Box<Self>) -> Result<(), Failure> {
        self.file.finish()
    }
}
