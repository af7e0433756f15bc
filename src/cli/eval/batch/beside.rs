//! A file that is written beside its place, and is there as a whole or not at all.

use std::fs::{File, remove_file, rename};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use super::super::super::Failure;

/// A file being written; it goes away unless it is [`finished`](Self::finish).
pub struct Beside {
    /// None once it is finished.
    file: Option<BufWriter<File>>,
    at: PathBuf,
    to: PathBuf,
}

impl Beside {
    /// Begins a file that will be at `to`.
    pub fn create(to: &Path) -> Result<Self, Failure> {
        let mut at = to.as_os_str().to_owned();
        at.push(".new");
        let (at, to) = (PathBuf::from(at), to.to_owned());
        match File::create(&at) {
            Ok(file) => Ok(Self { file: Some(BufWriter::new(file)), at, to }),
            Err(error) => Err(Failure::Input(format!(
                "{}: cannot be written: {error}; --out takes a file in a folder that is there",
                to.display()
            ))),
        }
    }

    /// Why writing failed.
    pub fn failed(&self, error: &dyn std::fmt::Display) -> Failure {
        Failure::Input(format!("{}: cannot be written: {error}", self.to.display()))
    }

    /// Puts the file into its place.
    pub fn finish(mut self) -> Result<(), Failure> {
        let done = self.flush().and_then(|()| {
            self.file = None;
            rename(&self.at, &self.to)
        });
        done.map_err(|error| self.failed(&error))
    }
}

impl Write for Beside {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.file.as_mut().map_or(Ok(0), |file| file.write(bytes))
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.as_mut().map_or(Ok(()), Write::flush)
    }
}

impl Drop for Beside {
    fn drop(&mut self) {
        // Renamed, it is not there any more.
        if self.file.take().is_some() {
            let _ = remove_file(&self.at);
        }
    }
}
