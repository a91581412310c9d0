//! The values of a column as numbers or bytes.

use crate::{Error, exact};
use delone::Watch;
use parquet::basic::{ConvertedType, LogicalType, Type};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::ParquetError;
use parquet::schema::types::ColumnDescriptor;

/// Values decoded at once.
const BATCH: usize = 1 << 13;

/// Numbers, NaN where there is none; or the first row for which there is something else, and what stands there.
pub(super) type Values = Result<Vec<f64>, (usize, String)>;

/// Why reading stopped.
pub(super) enum Stop {
    Broken(ParquetError),
    Error(Error),
}

impl From<ParquetError> for Stop {
    fn from(error: ParquetError) -> Self {
        Self::Broken(error)
    }
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// Truth values or floating-point numbers.
    Number,
    /// Integers, to be divided by a power of ten.
    Integer { is_signed: bool, scale: f64 },
    /// Texts or bytes, and whether they are geometries.
    Bytes { is_geometry: bool },
    /// Something else, in a word.
    Other(&'static str),
}

impl Kind {
    /// Tells the kind of a column that is not nested.
    pub fn of(column: &ColumnDescriptor) -> Self {
        let logical = column.logical_type_ref();
        match column.physical_type() {
            Type::BOOLEAN | Type::FLOAT | Type::DOUBLE => Self::Number,
            Type::INT32 | Type::INT64 => Self::of_integer(column, logical),
            Type::BYTE_ARRAY => Self::Bytes {
                is_geometry: matches!(
                    logical,
                    Some(LogicalType::Geometry(_) | LogicalType::Geography(_))
                ),
            },
            Type::INT96 => Self::Other("times"),
            Type::FIXED_LEN_BYTE_ARRAY => Self::Other("bytes"),
        }
    }

    fn of_integer(column: &ColumnDescriptor, logical: Option<&LogicalType>) -> Self {
        let integer = |is_signed, digits: i32| match digits {
            // Up to 10²² powers of ten are exact, hence quotients as good as can be.
            0..=22 => Self::Integer {
                is_signed,
                scale: 10f64.powi(digits),
            },
            _ => Self::Other("decimals"),
        };
        match (logical, column.converted_type()) {
            (Some(LogicalType::Integer(kind)), _) => integer(kind.is_signed, 0),
            (Some(LogicalType::Decimal(kind)), _) => integer(true, kind.scale),
            (Some(_), _) => Self::Other("dates or times"),
            (None, ConvertedType::DECIMAL) => integer(true, column.type_scale()),
            (
                None,
                ConvertedType::UINT_8
                | ConvertedType::UINT_16
                | ConvertedType::UINT_32
                | ConvertedType::UINT_64,
            ) => integer(false, 0),
            (
                None,
                ConvertedType::NONE
                | ConvertedType::INT_8
                | ConvertedType::INT_16
                | ConvertedType::INT_32
                | ConvertedType::INT_64,
            ) => integer(true, 0),
            (None, _) => Self::Other("dates or times"),
        }
    }

    /// Tells whether the column holds numbers.
    pub fn is_number(self) -> bool {
        matches!(self, Self::Number | Self::Integer { .. })
    }

    /// Tells whether the column holds integers.
    pub fn is_integer(self) -> bool {
        matches!(self, Self::Integer { scale: 1.0, .. })
    }

    /// Says what a column holds that is left out.
    pub fn name(self) -> &'static str {
        match self {
            Self::Number | Self::Integer { .. } => "numbers",
            Self::Bytes { .. } => "text",
            Self::Other(name) => name,
        }
    }
}

/// A column within a group.
pub(super) struct Chunk<'w> {
    pub reader: ColumnReader,
    pub rows: usize,
    /// The level of values that are there.
    pub full: i16,
    pub watch: &'w dyn Watch,
}

/// Numbers as they come.
pub(super) struct Numbers {
    is_signed: bool,
    scale: f64,
    values: Vec<f64>,
    /// The first row that is no number, and what stands there.
    bad: Option<(usize, String)>,
}

impl Numbers {
    /// Begins with room for rows, if there is so much memory.
    pub fn new(kind: Kind, rows: usize) -> Self {
        let (is_signed, scale) = match kind {
            Kind::Integer { is_signed, scale } => (is_signed, scale),
            _ => (true, 1.0),
        };
        let mut values = Vec::new();
        drop(values.try_reserve_exact(rows));
        Self {
            is_signed,
            scale,
            values,
            bad: None,
        }
    }

    /// Adds the numbers of a chunk and returns their count.
    pub fn read(&mut self, chunk: Chunk<'_>) -> Result<usize, Stop> {
        let Chunk {
            reader,
            rows,
            full,
            watch,
        } = chunk;
        let is_signed = self.is_signed;
        match reader {
            ColumnReader::BoolColumnReader(reader) => each(reader, rows, full, watch, |value| {
                self.push(value.map(|&v| f64::from(u8::from(v))))
            }),
            ColumnReader::Int32ColumnReader(reader) => each(reader, rows, full, watch, |value| {
                self.push_integer(value.map(|&v| match is_signed {
                    true => v.into(),
                    false => (v as u32).into(),
                }))
            }),
            ColumnReader::Int64ColumnReader(reader) => each(reader, rows, full, watch, |value| {
                self.push_integer(value.map(|&v| match is_signed {
                    true => v.into(),
                    false => (v as u64).into(),
                }))
            }),
            ColumnReader::FloatColumnReader(reader) => each(reader, rows, full, watch, |value| {
                self.push(value.map(|&v| v.into()))
            }),
            ColumnReader::DoubleColumnReader(reader) => {
                each(reader, rows, full, watch, |value| self.push(value.copied()))
            }
            _ => Ok(0),
        }
    }

    /// Returns what has been read.
    pub fn finish(self) -> Values {
        match self.bad {
            Some(bad) => Err(bad),
            None => Ok(self.values),
        }
    }

    fn push(&mut self, value: Option<f64>) -> Result<(), Error> {
        self.values.push(value.unwrap_or(f64::NAN));
        Ok(())
    }

    fn push_integer(&mut self, value: Option<i128>) -> Result<(), Error> {
        let number = value.map(|value| match exact::to_double(value) {
            Some(number) => number / self.scale,
            None => {
                let row = self.values.len();
                self.bad.get_or_insert((row, value.to_string()));
                f64::NAN
            }
        });
        self.push(number)
    }
}

/// Visits texts or bytes and returns their count.
pub(super) fn bytes(
    chunk: Chunk<'_>,
    mut visit: impl FnMut(Option<&[u8]>) -> Result<(), Error>,
) -> Result<usize, Stop> {
    let Chunk {
        reader,
        rows,
        full,
        watch,
    } = chunk;
    match reader {
        ColumnReader::ByteArrayColumnReader(reader) => each(reader, rows, full, watch, |value| {
            visit(value.map(|bytes| bytes.data()))
        }),
        _ => Ok(0),
    }
}

/// Visits the values of a column; `None` is a null.
fn each<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    rows: usize,
    full: i16,
    watch: &dyn Watch,
    mut visit: impl FnMut(Option<&T::T>) -> Result<(), Error>,
) -> Result<usize, Stop> {
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    let mut done = 0;
    while done < rows && !watch.is_cancelled() {
        values.clear();
        levels.clear();
        let wanted = BATCH.min(rows - done);
        let (records, _, _) = reader.read_records(wanted, Some(&mut levels), None, &mut values)?;
        if records == 0 {
            break;
        }
        done += records;
        let mut values = values.iter();
        if full == 0 {
            values
                .try_for_each(|value| visit(Some(value)))
                .map_err(Stop::Error)?;
        }
        for &level in &levels {
            let value = (level == full).then(|| values.next()).flatten();
            visit(value).map_err(Stop::Error)?;
        }
    }
    Ok(done)
}
