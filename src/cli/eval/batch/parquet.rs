//! States and answers as columns of Parquet, read and written piece by piece.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ndarray::{ArrayView2, ArrayViewMut2};
use parquet::basic::{Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::data_type::DoubleType;
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use super::super::super::Failure;
use super::beside::Beside;
use super::{Sink, Source};

/// A file of states.
pub struct Reader {
    path: PathBuf,
    file: SerializedFileReader<File>,
    /// Which columns of the file are read, and their names.
    columns: Vec<(usize, String)>,
    states: usize,
    /// The group of rows that comes next.
    group: usize,
    /// The group that is being read: its columns, and how many of its rows are left.
    open: (Vec<ColumnReader>, usize),
}

impl Reader {
    /// Opens a file with a column for each of `names`.
    pub fn open(path: &Path, names: &[String]) -> Result<Self, Failure> {
        let failed = |fact: &dyn std::fmt::Display| Failure::Input(format!("{}: {fact}", path.display()));
        let file = File::open(path).map_err(|error| failed(&format_args!("cannot be opened: {error}")))?;
        let file = SerializedFileReader::new(file)
            .map_err(|error| failed(&format_args!("this is no Parquet file: {error}")))?;
        let schema = file.metadata().file_metadata().schema_descr_ptr();
        let (mut columns, mut missing) = (Vec::new(), Vec::new());
        for name in names {
            // A name with dots in it is one name.
            let found = schema.columns().iter().position(|column| column.path().parts().join(".") == *name);
            match found.map(|number| (number, schema.column(number))) {
                None => missing.push(name.as_str()),
                Some((_, column))
                    if !matches!(column.physical_type(), Physical::DOUBLE | Physical::FLOAT)
                        || column.max_rep_level() > 0 =>
                {
                    let kind = column.physical_type();
                    return Err(failed(&format_args!(
                        "column {name} is of type {kind}; expected DOUBLE or FLOAT, one a row"
                    )));
                }
                Some((number, _)) => columns.push((number, name.clone())),
            }
        }
        if !missing.is_empty() {
            let there: Vec<String> = schema.columns().iter().map(|column| column.path().parts().join(".")).collect();
            return Err(failed(&format_args!(
                "these columns are missing: {}; the file has: {}",
                missing.join(", "),
                there.join(", ")
            )));
        }
        let states = usize::try_from(file.metadata().file_metadata().num_rows()).map_err(|error| failed(&error))?;
        Ok(Self { path: path.to_owned(), file, columns, states, group: 0, open: (Vec::new(), 0) })
    }

    fn rows(&mut self, rows: &mut ArrayViewMut2<'_, f64>) -> Result<(), ParquetError> {
        let mut done = 0;
        while done < rows.nrows() {
            while self.open.1 == 0 {
                let group = self.file.get_row_group(self.group)?;
                let columns = self.columns.iter().map(|(number, _)| group.get_column_reader(*number));
                let columns = columns.collect::<Result<_, _>>()?;
                self.open = (columns, usize::try_from(group.metadata().num_rows()).unwrap_or(0));
                self.group += 1;
            }
            let count = self.open.1.min(rows.nrows() - done);
            for (number, reader) in self.open.0.iter_mut().enumerate() {
                let values = numbers(reader, count)?;
                if values.len() != count {
                    let name = &self.columns[number].1;
                    return Err(ParquetError::General(format!("column {name} has rows without a number")));
                }
                let column = rows.column_mut(number).into_iter().skip(done);
                column.zip(values).for_each(|(entry, value)| *entry = value);
            }
            self.open.1 -= count;
            done += count;
        }
        Ok(())
    }
}

/// The next `count` numbers of a column; fewer where some are missing.
fn numbers(column: &mut ColumnReader, count: usize) -> Result<Vec<f64>, ParquetError> {
    let mut levels = Vec::new();
    match column {
        ColumnReader::DoubleColumnReader(column) => {
            let mut values = Vec::with_capacity(count);
            column.read_records(count, Some(&mut levels), None, &mut values)?;
            Ok(values)
        }
        ColumnReader::FloatColumnReader(column) => {
            let mut values = Vec::with_capacity(count);
            column.read_records(count, Some(&mut levels), None, &mut values)?;
            Ok(values.into_iter().map(f64::from).collect())
        }
        _ => Ok(Vec::new()),
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
    file: SerializedFileWriter<Beside>,
    path: PathBuf,
}

impl Writer {
    /// Begins a file with columns of these names.
    pub fn create(path: &Path, title: &str, names: &[String]) -> Result<Self, Failure> {
        let field = |name: &String| {
            let field = Type::primitive_type_builder(name, Physical::DOUBLE).with_repetition(Repetition::REQUIRED);
            field.build().map(Arc::new)
        };
        let beside = Beside::create(path)?;
        // Numbers of an answer hardly ever repeat.
        let properties = WriterProperties::builder().set_dictionary_enabled(false).build();
        let fields = names.iter().map(field).collect::<Result<_, _>>();
        let schema = fields.and_then(|fields| Type::group_type_builder(title).with_fields(fields).build());
        let file = schema.and_then(|schema| SerializedFileWriter::new(beside, Arc::new(schema), Arc::new(properties)));
        match file {
            Ok(file) => Ok(Self { file, path: path.to_owned() }),
            Err(error) => Err(failed(path, &error)),
        }
    }

    fn group(&mut self, rows: ArrayView2<'_, f64>) -> Result<(), ParquetError> {
        let mut group = self.file.next_row_group()?;
        for column in rows.columns() {
            let Some(mut out) = group.next_column()? else { break };
            match column.as_slice() {
                Some(values) => out.typed::<DoubleType>().write_batch(values, None, None)?,
                None => out.typed::<DoubleType>().write_batch(&column.to_vec(), None, None)?,
            };
            out.close()?;
        }
        group.close().map(drop)
    }
}

impl Sink for Writer {
    fn write(&mut self, rows: ArrayView2<'_, f64>) -> Result<(), Failure> {
        self.group(rows).map_err(|error| failed(&self.path, &error))
    }

    fn finish(self: Box<Self>) -> Result<(), Failure> {
        let Self { file, path } = *self;
        file.into_inner().map_err(|error| failed(&path, &error))?.finish()
    }
}

fn failed(path: &Path, error: &ParquetError) -> Failure {
    Failure::Input(format!("{}: cannot be written: {error}", path.display()))
}
