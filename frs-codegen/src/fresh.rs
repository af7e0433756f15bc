//! Checked-in files: written when they differ, or checked.

use std::fs;
use std::io;
use std::path::Path;

/// How a file stands to what it should hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Freshness {
    /// It holds exactly that.
    Fresh,
    /// It was written, because it did not.
    Written,
    /// It does not; nothing was written.
    Stale {
        /// Number of the first line that differs.
        line: usize,
        /// What stands there; `None` beyond the end, or if there is no file.
        found: Option<String>,
        /// What should stand there.
        expected: Option<String>,
    },
}

/// Compares the file with `text`.
///
/// # Errors
/// If the file exists but cannot be read.
pub fn check(path: &Path, text: &str) -> io::Result<Freshness> {
    let old = match fs::read_to_string(path) {
        Ok(old) => old,
        Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(error),
    };
    if old == text {
        return Ok(Freshness::Fresh);
    }
    let (mut found, mut expected) = (old.lines(), text.lines());
    for line in 1.. {
        let (found, expected) = (found.next(), expected.next());
        if found != expected || found.is_none() {
            let [found, expected] = [found, expected].map(|line| line.map(str::to_owned));
            return Ok(Freshness::Stale { line, found, expected });
        }
    }
    unreachable!("texts that differ differ in a line or in their ends")
}

/// Makes the file hold `text`. An interrupted write leaves the old file: the new one is written beside it and renamed.
///
/// # Errors
/// If the file can be neither read nor written.
pub fn write(path: &Path, text: &str) -> io::Result<Freshness> {
    if check(path, text)? == Freshness::Fresh {
        return Ok(Freshness::Fresh);
    }
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let mut beside = path.as_os_str().to_owned();
    beside.push(".new");
    fs::write(&beside, text)?;
    fs::rename(&beside, path)?;
    Ok(Freshness::Written)
}
