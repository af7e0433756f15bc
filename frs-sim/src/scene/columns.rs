//! Functions of time from a file of comma-separated values.
//!
//! The first column is the time, s; a first line without any number names the columns. Empty lines and what follows a `#` at the start of
//! a line do not count.

use std::path::Path;
use std::sync::Arc;

use csv::{ByteRecord, ReaderBuilder};
use frs_core::model::Place;

use super::reader::{Item, Table};
use crate::signal::Signal;

/// Rows of numbers at increasing times.
pub struct Columns {
    times: Vec<f64>,
    rows: Vec<Vec<f64>>,
}

impl Columns {
    /// The columns after the time as functions of it.
    pub fn signals(&self, through: impl Fn(&[f64], &[f64]) -> Signal) -> Vec<Signal> {
        let count = self.rows.first().map_or(0, Vec::len);
        (0..count).map(|i| through(&self.times, &self.rows.iter().map(|row| row[i]).collect::<Vec<_>>())).collect()
    }
}

/// The file under the key `csv`, with `what` in so many columns beside the time; none of the keys `others` may be there, too.
/// `Some(None)` if there is no such key.
pub fn read(table: &Table<'_, '_>, others: &[&str], count: usize, what: &str) -> Option<Option<Columns>> {
    let Some(item) = table.get("csv") else { return Some(None) };
    if let Some((key, other)) = others.iter().find_map(|key| Some((key, table.get(key)?))) {
        return other.refuse(format!("csv is given, too; expected csv or {key}"));
    }
    columns(&item, count, what).map(Some)
}

fn columns(item: &Item<'_, '_>, count: usize, what: &str) -> Option<Columns> {
    let expected = format!("a time (s) and {what}");
    let path = item.text("the path of a CSV file, from the scene's folder")?;
    let text = match item.file(path) {
        Ok(text) => text,
        Err(error) => {
            let hint = "expected the path of a CSV file, from the scene's folder";
            return item.refuse(format!("{path} cannot be read: {error}; {hint}"));
        }
    };
    let file: Arc<str> = Path::new(item.scene()).with_file_name(path).display().to_string().into();
    let place = |line: usize, column: usize| Place { file: file.clone(), line, column };
    let mut reader =
        ReaderBuilder::new().has_headers(false).flexible(true).comment(Some(b'#')).from_reader(text.as_bytes());
    let (mut times, mut rows) = (Vec::new(), Vec::new());
    let (mut record, mut whole, mut first) = (ByteRecord::new(), true, true);
    // A text in memory, with lines of any length, is never refused.
    while reader.read_byte_record(&mut record).unwrap_or(false) {
        let line = record.position().map_or(0, |position| position.line() as usize);
        let fields: Vec<_> = record.iter().map(String::from_utf8_lossy).collect();
        let numbers: Vec<Option<f64>> = fields.iter().map(|field| field.trim().parse().ok()).collect();
        if std::mem::take(&mut first) && numbers.iter().all(Option::is_none) {
            continue;
        }
        let mut wrong = |column: usize, message: String| {
            item.refuse_at(place(line, column), message);
            whole = false;
        };
        if fields.len() != count + 1 {
            wrong(1, format!("found {} numbers; expected {}: {expected}", fields.len(), count + 1));
            continue;
        }
        let mut column = 1;
        for (field, number) in fields.iter().zip(&numbers) {
            if number.is_none_or(|number| !number.is_finite()) {
                wrong(column, format!("found '{}'; expected a finite number", field.trim()));
            }
            column += field.chars().count() + 1;
        }
        let Some(numbers) = numbers.into_iter().collect::<Option<Vec<f64>>>() else { continue };
        if let Some(last) = times.last()
            && numbers[0] <= *last
        {
            wrong(1, format!("found {} s after {last} s; expected times that increase", numbers[0]));
        }
        times.push(numbers[0]);
        rows.push(numbers[1..].to_vec());
    }
    if whole && times.is_empty() {
        item.refuse_at(place(1, 1), format!("there are no numbers; expected lines of {expected}"));
        whole = false;
    }
    whole.then_some(Columns { times, rows })
}
