//! Files of states and answers, made and read without the program.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use npyz::{NpyFile, Order, WriteOptions, WriterBuilder};
use parquet::basic::{Compression, Repetition, Type as Physical};
use parquet::data_type::DoubleType;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::record::RowAccessor;
use parquet::schema::types::Type;

/// A folder of a test's own, empty.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("batch").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Random numbers, `width` a state.
pub fn states(count: usize, width: usize) -> Vec<f64> {
    let mut random = fastrand::Rng::with_seed(count as u64);
    (0..count * width).map(|_| 4.0 * (random.f64() - 0.5)).collect()
}

/// Writes an array as the file `name`, whose numbers are given state by state.
pub fn write(folder: &Path, name: &str, order: Order, width: usize, numbers: &[f64]) {
    let count = numbers.len() / width;
    let file = File::create(folder.join(name)).unwrap();
    let options = WriteOptions::new().default_dtype().order(order).shape(&[count as u64, width as u64]);
    let mut writer = options.writer(std::io::BufWriter::new(file)).begin_nd().unwrap();
    let at = |i: usize| if order == Order::C { i } else { i % count * width + i / count };
    writer.extend((0..numbers.len()).map(|i| numbers[at(i)])).unwrap();
    writer.finish().unwrap();
}

/// The bits of a file of doubles.
pub fn read(folder: &Path, name: &str) -> (Vec<u64>, Vec<u64>) {
    let file = NpyFile::new(std::io::BufReader::new(File::open(folder.join(name)).unwrap())).unwrap();
    let shape = file.shape().to_vec();
    (shape, file.into_vec::<f64>().unwrap().into_iter().map(f64::to_bits).collect())
}

/// Writes numbers as a Parquet file with these columns, in groups of so many rows; a column whose name begins with `?` may lack numbers.
pub fn write_columns(path: &Path, names: &[&str], rows: &[Vec<f64>], group: usize) {
    let field = |name: &&str| {
        let (name, repetition) =
            name.strip_prefix('?').map_or((*name, Repetition::REQUIRED), |name| (name, Repetition::OPTIONAL));
        Arc::new(Type::primitive_type_builder(name, Physical::DOUBLE).with_repetition(repetition).build().unwrap())
    };
    let schema = Type::group_type_builder("states").with_fields(names.iter().map(field).collect()).build().unwrap();
    let properties = WriterProperties::builder().set_compression(Compression::SNAPPY).build();
    let mut file =
        SerializedFileWriter::new(File::create(path).unwrap(), Arc::new(schema), Arc::new(properties)).unwrap();
    for rows in rows.chunks(group) {
        let mut group = file.next_row_group().unwrap();
        for (number, name) in names.iter().enumerate() {
            let values: Vec<f64> = rows.iter().map(|row| row[number]).filter(|value| !value.is_nan()).collect();
            let levels: Vec<i16> = rows.iter().map(|row| i16::from(!row[number].is_nan())).collect();
            let levels = name.starts_with('?').then_some(levels.as_slice());
            let mut column = group.next_column().unwrap().unwrap();
            column.typed::<DoubleType>().write_batch(&values, levels, None).unwrap();
            column.close().unwrap();
        }
        group.close().unwrap();
    }
    file.close().unwrap();
}

/// The columns of a Parquet file, and the bits of its numbers, row by row.
pub fn read_columns(path: &Path) -> (Vec<String>, Vec<u64>) {
    let file = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
    let schema = file.metadata().file_metadata().schema_descr_ptr();
    let names = schema.columns().iter().map(|column| column.name().to_owned()).collect();
    let rows = file.get_row_iter(None).unwrap().map(Result::unwrap);
    let bits = rows.flat_map(|row| (0..row.len()).map(|i| row.get_double(i).unwrap().to_bits()).collect::<Vec<_>>());
    (names, bits.collect())
}
