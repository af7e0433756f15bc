//! A motion as Parquet: the columns of the table, each as it is in memory.

use std::sync::Arc;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::DoubleType;
use parquet::errors::Result;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

/// The bytes of a file with these columns; each row has a number for each name.
pub fn file(names: &[String], rows: &[Vec<f64>]) -> Result<Vec<u8>> {
    let field = |name: &String| {
        let field = Type::primitive_type_builder(name, Physical::DOUBLE).with_repetition(Repetition::REQUIRED);
        field.build().map(Arc::new)
    };
    let fields = names.iter().map(field).collect::<Result<_>>()?;
    let schema = Type::group_type_builder("trajectory").with_fields(fields).build()?;
    // Numbers of a motion hardly ever repeat.
    let properties = WriterProperties::builder().set_dictionary_enabled(false).build();
    let mut writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    let mut number = 0;
    while let Some(mut column) = group.next_column()? {
        let values: Vec<f64> = rows.iter().map(|row| row[number]).collect();
        column.typed::<DoubleType>().write_batch(&values, None, None)?;
        column.close()?;
        number += 1;
    }
    group.close()?;
    writer.into_inner()
}
