//! Columns as Parquet, each number as it is in memory.

use std::path::Path;
use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use super::{Failure, write_bytes};

/// A column; all of a file are of one length.
pub enum Column {
    Number(Vec<f64>),
    Count(Vec<i64>),
    Text(Vec<String>),
}

/// Writes a file with these columns into a folder that is there.
pub fn write<'n>(
    path: &Path,
    title: &str,
    columns: impl IntoIterator<Item = (&'n str, Column)>,
) -> Result<(), Failure> {
    let bytes = file(title, columns).map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
    write_bytes(path, &bytes)
}

fn file<'n>(title: &str, columns: impl IntoIterator<Item = (&'n str, Column)>) -> Result<Vec<u8>, ParquetError> {
    let (names, columns): (Vec<&str>, Vec<Column>) = columns.into_iter().unzip();
    let field = |(name, column): (&&str, &Column)| {
        let (physical, logical) = match column {
            Column::Number(_) => (Physical::DOUBLE, None),
            Column::Count(_) => (Physical::INT64, None),
            Column::Text(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let field = Type::primitive_type_builder(name, physical).with_repetition(Repetition::REQUIRED);
        field.with_logical_type(logical).build().map(Arc::new)
    };
    let fields = names.iter().zip(&columns).map(field).collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder(title).with_fields(fields).build()?;
    // Numbers of a motion hardly ever repeat.
    let properties = WriterProperties::builder().set_dictionary_enabled(false).build();
    let mut writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    for column in columns {
        let Some(mut out) = group.next_column()? else { break };
        match column {
            Column::Number(values) => out.typed::<DoubleType>().write_batch(&values, None, None)?,
            Column::Count(values) => out.typed::<Int64Type>().write_batch(&values, None, None)?,
            Column::Text(values) => {
                let values: Vec<ByteArray> = values.iter().map(|text| text.as_str().into()).collect();
                out.typed::<ByteArrayType>().write_batch(&values, None, None)?
            }
        };
        out.close()?;
    }
    group.close()?;
    writer.into_inner()
}
