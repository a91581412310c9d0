//! Writing: group by group, each in memory until it is complete.

use crate::target::Output;
use crate::{Attribute, Error, MeshView};
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical, ZstdLevel};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{ColumnPath, Type};
use std::sync::Arc;

/// Rows of a group, and rows between two looks at the watch.
const GROUP: usize = 1 << 20;
const BATCH: usize = 1 << 15;

/// A column of the table to be written.
struct Column<'a> {
    name: String,
    physical: Physical,
    /// The words that values are places among, if they are texts.
    words: &'a [&'a str],
    /// Whether values may be NaN, which are then nulls.
    is_optional: bool,
    /// Whether few values are repeated often.
    has_repetitions: bool,
    value: Box<dyn Fn(usize) -> f64 + 'a>,
}

/// The table to be written.
pub(super) struct Table<'a> {
    rows: usize,
    columns: Vec<Column<'a>>,
}

impl<'a> Table<'a> {
    pub fn new(rows: usize) -> Self {
        let columns = Vec::new();
        Self { rows, columns }
    }

    /// Adds a column; a name that is taken gets an underscore more.
    pub fn push(&mut self, name: &str, physical: Physical, value: impl Fn(usize) -> f64 + 'a) {
        let mut name = name.to_owned();
        while self.columns.iter().any(|column| column.name == name) {
            name.push('_');
        }
        self.columns.push(Column {
            name,
            physical,
            words: &[],
            is_optional: false,
            has_repetitions: false,
            value: Box::new(value),
        });
    }

    /// Adds a column of integers that stand for something, or NaN for nothing.
    fn push_labels(&mut self, name: &str, is_optional: bool, value: impl Fn(usize) -> f64 + 'a) {
        self.push(name, Physical::INT32, value);
        if let Some(column) = self.columns.last_mut() {
            column.is_optional = is_optional;
            column.has_repetitions = true;
        }
    }

    /// Adds a column of numbers, or NaN for none.
    pub fn push_nullable(
        &mut self,
        name: &str,
        physical: Physical,
        value: impl Fn(usize) -> f64 + 'a,
    ) {
        self.push(name, physical, value);
        if let Some(column) = self.columns.last_mut() {
            column.is_optional = true;
        }
    }

    /// Adds a column of words, each one of these.
    pub fn push_words(
        &mut self,
        name: &str,
        words: &'a [&'a str],
        value: impl Fn(usize) -> &'a str + 'a,
    ) {
        let place = move |i| words.iter().position(|&word| word == value(i));
        let place = move |i| place(i).expect("bug: a word that is not listed") as f64;
        self.push(name, Physical::BYTE_ARRAY, place);
        if let Some(column) = self.columns.last_mut() {
            column.words = words;
            column.has_repetitions = true;
        }
    }

    fn push_attributes(&mut self, attributes: &'a [Attribute]) {
        for Attribute { name, values } in attributes {
            self.push(name, Physical::DOUBLE, |i| values[i]);
            if let Some(column) = self.columns.last_mut() {
                column.is_optional = values.iter().any(|value| value.is_nan());
                column.has_repetitions = true;
            }
        }
    }
}

/// Writes the table of triangles.
pub(crate) fn write_triangles(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
) -> std::result::Result<(), Error> {
    let mut table = Table::new(mesh.triangles.len());
    for (k, name) in ["a", "b", "c"].into_iter().enumerate() {
        let corner = move |t: usize| mesh.triangles[t][k].raw().into();
        table.push(name, index_type(mesh), corner);
    }
    if let Some(regions) = mesh.constraints.and_then(|c| c.region_of.as_ref()) {
        let region = |t: usize| regions[t].map_or(f64::NAN, f64::from);
        table.push_labels("region", true, region);
    }
    table.push_attributes(mesh.triangle_attributes);
    write(out, &table)
}

/// Writes the table of points.
pub(crate) fn write_points(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
) -> std::result::Result<(), Error> {
    let mut table = Table::new(mesh.points.len());
    table.push("x", Physical::DOUBLE, |i| mesh.points[i].x);
    table.push("y", Physical::DOUBLE, |i| mesh.points[i].y);
    table.push_attributes(mesh.attributes);
    if let Some(markers) = mesh.markers {
        table.push_labels("marker", false, |i| markers[i].into());
    }
    write(out, &table)
}

/// Writes the table of constrained edges.
pub(crate) fn write_segments(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
) -> std::result::Result<(), Error> {
    let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
    let mut table = Table::new(edges.len());
    for (k, name) in ["a", "b"].into_iter().enumerate() {
        table.push(name, index_type(mesh), move |e| edges[e][k].raw().into());
    }
    table.push_labels("marker", false, |e| markers[e].into());
    write(out, &table)
}

/// Returns the type that the indices of points need.
fn index_type(mesh: &MeshView<'_>) -> Physical {
    match mesh.points.len() <= i32::MAX as usize {
        true => Physical::INT32,
        false => Physical::INT64,
    }
}

/// Writes a table.
pub(super) fn write(out: &mut Output<'_>, table: &Table<'_>) -> std::result::Result<(), Error> {
    let file = out.file();
    let failed = |error: ParquetError| Error::Io {
        action: "write",
        file: file.to_owned(),
        source: std::io::Error::other(error),
    };
    let mut writer = begin(table).map_err(failed)?;
    for start in (0..table.rows).step_by(GROUP) {
        let end = table.rows.min(start + GROUP);
        let mut group = writer.next_row_group().map_err(failed)?;
        for column in &table.columns {
            let next = group.next_column().map_err(failed)?;
            let mut next = next.expect("bug: a column for each of the schema");
            for from in (start..end).step_by(BATCH) {
                out.check()?;
                let rows = from..end.min(from + BATCH);
                write_batch(&mut next, column, rows).map_err(failed)?;
            }
            next.close().map_err(failed)?;
        }
        group.close().map_err(failed)?;
        out.many_bytes(&std::mem::take(writer.inner_mut()))?;
        (start..end).try_for_each(|_| out.end_row())?;
    }
    out.many_bytes(&writer.into_inner().map_err(failed)?)
}

/// Makes the writer of a table, which fills a vector that is emptied now and then.
fn begin(table: &Table<'_>) -> Result<SerializedFileWriter<Vec<u8>>> {
    let mut properties = WriterProperties::builder()
        .set_created_by(concat!("delone ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::ZSTD(ZstdLevel::try_new(3)?));
    let mut fields = Vec::new();
    for column in &table.columns {
        let repetition = match column.is_optional {
            true => Repetition::OPTIONAL,
            false => Repetition::REQUIRED,
        };
        let text = (column.physical == Physical::BYTE_ARRAY).then_some(LogicalType::String);
        let field = Type::primitive_type_builder(&column.name, column.physical);
        let field = field.with_logical_type(text);
        fields.push(Arc::new(field.with_repetition(repetition).build()?));
        let path = ColumnPath::new(vec![column.name.clone()]);
        properties = properties.set_column_dictionary_enabled(path, column.has_repetitions);
    }
    let schema = Type::group_type_builder("schema")
        .with_fields(fields)
        .build()?;
    SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties.build()))
}

/// Writes some rows of a column.
fn write_batch(
    writer: &mut SerializedColumnWriter<'_>,
    column: &Column<'_>,
    rows: std::ops::Range<usize>,
) -> Result<()> {
    let all = rows.map(|row| (column.value)(row));
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    for value in all {
        let is_there = !(column.is_optional && value.is_nan());
        levels.push(i16::from(is_there));
        if is_there {
            values.push(value);
        }
    }
    let levels = column.is_optional.then_some(&levels[..]);
    // Integers lose nothing in a double: they number points, or are of 32 bits.
    match column.physical {
        Physical::INT32 => {
            let values: Vec<i32> = values.iter().map(|&value| value as i32).collect();
            writer
                .typed::<Int32Type>()
                .write_batch(&values, levels, None)?;
        }
        Physical::INT64 => {
            let values: Vec<i64> = values.iter().map(|&value| value as i64).collect();
            writer
                .typed::<Int64Type>()
                .write_batch(&values, levels, None)?;
        }
        Physical::BYTE_ARRAY => {
            let word = |&place: &f64| ByteArray::from(column.words[place as usize]);
            let values: Vec<_> = values.iter().map(word).collect();
            writer
                .typed::<ByteArrayType>()
                .write_batch(&values, levels, None)?;
        }
        _ => {
            writer
                .typed::<DoubleType>()
                .write_batch(&values, levels, None)?;
        }
    }
    Ok(())
}
