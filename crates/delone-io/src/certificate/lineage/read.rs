//! Reading the table of lineage, as text or as Parquet: the content tells.

use super::Lineage;
use super::row::{COLUMNS, Row};
use crate::scan::{self, Scanner};
use crate::{Error, Place, Problem, Source, parquet};
use delone::Watch;

impl Lineage {
    /// Reads a table of lineage for an input of so many segments.
    ///
    /// # Errors
    /// If the file cannot be read, is malformed (with its line), is of Parquet in a build without it, or the watch
    /// cancels.
    ///
    /// *Cost*: proportional to the file.
    pub fn read(source: &Source, num_segments: usize, watch: &dyn Watch) -> Result<Self, Error> {
        let bytes = source.load(watch)?;
        let file = source.to_string();
        let mut lineage = Self {
            num_segments,
            ..Self::default()
        };
        match parquet::sniff(&bytes) {
            true => lineage.take_columns(&file, &bytes, watch)?,
            false => lineage.take_text(&file, &bytes, watch)?,
        }
        Ok(lineage)
    }

    #[cfg(feature = "parquet")]
    fn take_columns(&mut self, file: &str, bytes: &[u8], watch: &dyn Watch) -> Result<(), Error> {
        parquet::read_lineage(file, bytes, watch, |row| self.take(row))
    }

    #[cfg(not(feature = "parquet"))]
    fn take_columns(&mut self, file: &str, _: &[u8], _: &dyn Watch) -> Result<(), Error> {
        let only = |format| format == crate::Format::Table;
        let (format, action) = (crate::Format::Parquet, "be read");
        Err(crate::points::unsupported(file, format, action, only))
    }

    fn take_text(&mut self, file: &str, bytes: &[u8], watch: &dyn Watch) -> Result<(), Error> {
        let mut scanner = Scanner::new(file, bytes, watch);
        let header = COLUMNS.join(",");
        match scanner.next_full_row()? {
            Some(row) if row.text == header.as_bytes() => {}
            _ => {
                let text = format!("a table of lineage begins with {header}");
                return Err(scanner.malformed(Place::Line(1), Problem::Other(text)));
            }
        }
        while let Some(row) = scanner.next_full_row()? {
            let taken = parse(row.text).and_then(|row| self.take(&row));
            taken.map_err(|problem| scanner.at(row, Problem::Other(problem)))?;
        }
        Ok(())
    }
}

/// Takes a line apart.
fn parse(line: &[u8]) -> Result<Row<'_>, String> {
    let text = str::from_utf8(line).map_err(|_| "not UTF-8".to_owned())?;
    let mut cells = [""; COLUMNS.len()];
    let mut given = text.split(',');
    for cell in &mut cells {
        *cell = given
            .next()
            .ok_or_else(|| format!("too few cells, there are {} columns", COLUMNS.len()))?;
    }
    if given.next().is_some() {
        return Err(format!(
            "too many cells, there are {} columns",
            COLUMNS.len()
        ));
    }
    let whole = |i: usize| cell(cells[i], COLUMNS[i], "a number from 0 on");
    let fraction = |i: usize| cell(cells[i], COLUMNS[i], "a number from 0 to 1");
    Ok(Row {
        element: cells[0],
        number: whole(1)?.ok_or("a row without number")?,
        origin: cells[2],
        feature: whole(3)?,
        at: fraction(4)?,
        to: fraction(5)?,
        other: whole(6)?,
        other_at: fraction(7)?,
        from_vertex: whole(8)?,
        to_vertex: whole(9)?,
    })
}

/// Reads what stands in a cell, if anything does.
fn cell<T: std::str::FromStr>(
    text: &str,
    column: &str,
    expected: &str,
) -> Result<Option<T>, String> {
    if text.is_empty() {
        return Ok(None);
    }
    let value = text.parse().map(Some);
    value.map_err(|_| {
        let text = scan::show(text.as_bytes());
        format!("{column} is {text:?}, it must be {expected}")
    })
}
