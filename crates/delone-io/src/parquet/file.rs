//! An opened file: its columns by name, and what they hold.

use super::columns::{self, Chunk, Kind, Numbers, Values};
use super::guard::{self, Budget};
use crate::{Error, Place, Problem, foreign, node, points};
use bytes::Bytes;
use delone::{Phase, Watch};
use parquet::file::reader::FileReader;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::schema::types::ColumnDescriptor;

/// What messages call the crate's part.
const NAME: &str = "Parquet";

/// A column at the top of the schema.
pub(super) struct Field {
    pub name: String,
    /// Where its values are, if it is not nested.
    pub leaf: Option<usize>,
    pub kind: Kind,
}

/// An opened file.
pub(super) struct File<'a> {
    name: &'a str,
    bytes: &'a [u8],
    reader: SerializedFileReader<Bytes>,
    pub fields: Vec<Field>,
    /// The number of rows, of all groups together.
    pub rows: usize,
    budget: Budget,
    watch: &'a dyn Watch,
}

impl<'a> File<'a> {
    /// Opens a file that has been read into memory.
    pub fn open(name: &'a str, bytes: &'a [u8], watch: &'a dyn Watch) -> Result<Self, Error> {
        let malformed = |problem| malformed(name, Place::File, problem);
        guard::check_footer(bytes).map_err(malformed)?;
        let reader = foreign::call(name, NAME, || {
            SerializedFileReader::new(Bytes::copy_from_slice(bytes)).map_err(|e| broken(name, &e))
        })?;
        let metadata = reader.metadata();
        let schema = metadata.file_metadata().schema_descr();
        points::check_columns(schema.num_columns() as u64).map_err(malformed)?;
        let groups = metadata.row_groups().iter();
        let rows = groups.map(|group| u64::try_from(group.num_rows()).ok());
        let rows = rows.sum::<Option<u64>>().ok_or_else(|| {
            malformed(Problem::Other(
                "a group of a negative number of rows".to_owned(),
            ))
        })?;
        if rows > node::MAX_POINTS {
            return Err(malformed(node::too_many(rows)));
        }
        let tops = schema.root_schema().get_fields();
        let mut fields: Vec<Field> = tops
            .iter()
            .map(|top| Field {
                name: top.name().to_owned(),
                leaf: None,
                kind: Kind::Other("nested"),
            })
            .collect();
        for (leaf, column) in schema.columns().iter().enumerate() {
            let field = &mut fields[schema.get_column_root_idx(leaf)];
            if column.path().parts().len() == 1 && column.max_rep_level() == 0 {
                field.leaf = Some(leaf);
                field.kind = Kind::of(column);
            }
        }
        Ok(Self {
            name,
            bytes,
            budget: Budget::new(bytes),
            fields,
            rows: rows as usize,
            reader,
            watch,
        })
    }

    /// Returns the names of the columns.
    pub fn names(&self) -> Vec<String> {
        self.fields.iter().map(|f| f.name.clone()).collect()
    }

    /// Finds a column by its name; case matters.
    pub fn field(&self, name: &str) -> Option<usize> {
        self.fields.iter().position(|f| f.name == name)
    }

    /// Returns what the file says under a key.
    pub fn value_of(&self, key: &str) -> Option<&str> {
        let metadata = self.reader.metadata().file_metadata();
        let pairs = metadata.key_value_metadata()?;
        pairs.iter().find(|pair| pair.key == key)?.value.as_deref()
    }

    /// Finds the values within a struct.
    pub fn leaf_within(&self, field: usize, name: &str) -> Option<(usize, Kind)> {
        let schema = self.reader.metadata().file_metadata().schema_descr();
        let is_it = |column: &ColumnDescriptor| {
            let parts = column.path().parts();
            parts.len() == 2 && parts[1] == name && column.max_rep_level() == 0
        };
        let mut leaves = schema.columns().iter().enumerate();
        leaves
            .find(|(leaf, column)| schema.get_column_root_idx(*leaf) == field && is_it(column))
            .map(|(leaf, column)| (leaf, Kind::of(column)))
    }

    /// Reads numbers; a null is NaN.
    pub fn numbers(&mut self, leaf: usize, kind: Kind) -> Result<Values, Error> {
        self.take(8 * self.rows as u64)?;
        let mut numbers = Numbers::new(kind, self.rows);
        self.each_group(leaf, |chunk| numbers.read(chunk))?;
        Ok(numbers.finish())
    }

    /// Visits texts or bytes with their rows.
    pub fn bytes(
        &mut self,
        leaf: usize,
        mut visit: impl FnMut(usize, Option<&[u8]>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let mut row = 0;
        self.each_group(leaf, |chunk| {
            columns::bytes(chunk, |bytes| {
                row += 1;
                visit(row - 1, bytes)
            })
        })
    }

    /// Reads a column group by group; `read` returns the rows that it has read.
    fn each_group(
        &mut self,
        leaf: usize,
        mut read: impl FnMut(Chunk<'_>) -> Result<usize, columns::Stop>,
    ) -> Result<(), Error> {
        let groups = self.reader.metadata().num_row_groups();
        let schema = self.reader.metadata().file_metadata().schema_descr();
        let full = schema.column(leaf).max_def_level();
        for group in 0..groups {
            self.watch
                .progress(Phase::Read, group as u64, groups as u64);
            let rows = self.check(group, leaf)?;
            let found = foreign::call(self.name, NAME, || {
                let broken = |e| broken(self.name, &e);
                let group = self.reader.get_row_group(group).map_err(broken)?;
                let reader = group.get_column_reader(leaf).map_err(broken)?;
                let chunk = Chunk {
                    reader,
                    rows,
                    full,
                    watch: self.watch,
                };
                read(chunk).map_err(|stop| match stop {
                    columns::Stop::Broken(e) => broken(e),
                    columns::Stop::Error(error) => error,
                })
            })?;
            if self.watch.is_cancelled() {
                return Err(Error::Cancelled);
            }
            if found != rows {
                let (items, declared, found) = ("rows", rows as u64, found as u64);
                let problem = Problem::Truncated {
                    items,
                    declared,
                    found,
                };
                return Err(self.malformed(problem));
            }
        }
        Ok(())
    }

    /// Checks the pages of a column in a group before they are read, and returns its rows.
    fn check(&mut self, group: usize, leaf: usize) -> Result<usize, Error> {
        let group = self.reader.metadata().row_group(group);
        let rows = group.num_rows() as usize;
        let column = group.columns().get(leaf);
        let column = column.ok_or_else(|| self.other("a group without all of the columns"))?;
        let offset = column
            .dictionary_page_offset()
            .unwrap_or(column.data_page_offset());
        let start = usize::try_from(offset).ok();
        let end = start.zip(usize::try_from(column.compressed_size()).ok());
        let end = end.and_then(|(start, size)| start.checked_add(size));
        let pages = start
            .zip(end)
            .and_then(|(start, end)| self.bytes.get(start..end));
        let pages = pages.ok_or_else(|| self.other("a column lies outside of the file"))?;
        let is_cancelled = || self.watch.is_cancelled();
        let checked = guard::check_pages(pages, rows as u64, &mut self.budget, &is_cancelled);
        checked.map_err(|(at, problem)| {
            let at = start.unwrap_or(0) + at;
            malformed(self.name, Place::Byte(at as u64), problem)
        })?;
        Ok(rows)
    }

    /// Takes memory from what is allowed.
    pub fn take(&mut self, bytes: u64) -> Result<(), Error> {
        let taken = self.budget.take(bytes);
        taken.map_err(|problem| self.malformed(problem))
    }

    pub fn other(&self, text: impl Into<String>) -> Error {
        self.malformed(Problem::Other(text.into()))
    }

    pub fn malformed(&self, problem: Problem) -> Error {
        malformed(self.name, Place::File, problem)
    }
}

fn malformed(file: &str, place: Place, problem: Problem) -> Error {
    Error::Malformed {
        file: file.to_owned(),
        place,
        problem,
    }
}

/// Passes on what the crate says.
fn broken(file: &str, error: &parquet::errors::ParquetError) -> Error {
    malformed(file, Place::File, Problem::Other(error.to_string()))
}
