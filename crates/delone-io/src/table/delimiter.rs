//! What sets the cells of a row apart, and how a row is taken apart.

use crate::points::{MAX_COLUMNS, check_columns};
use crate::scan::{self, Row, Scanner};
use crate::{Error, Problem};
use std::borrow::Cow;

/// Rows that are looked at to tell the delimiter.
pub(super) const ROWS_LOOKED_AT: usize = 8;

/// What sets cells apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Delimiter {
    Byte(u8),
    Blanks,
}

impl Delimiter {
    /// Takes the first of tab, semicolon and comma that divides the first rows into equally many
    /// cells, otherwise blanks.
    pub fn detect(file: &str, bytes: &[u8]) -> Result<Self, Error> {
        let mut scanner = Scanner::new(file, bytes, &());
        let mut rows = Vec::new();
        while rows.len() < ROWS_LOOKED_AT
            && let Some(row) = scanner.next_full_row()?
        {
            rows.push(without_remark(row.text));
        }
        // Rows of unequal width are an error soon; the delimiter that stands in the first row
        // makes the best message.
        let stands = |byte: &&u8| rows.first().is_some_and(|row| row.contains(byte));
        let found = b"\t;,".iter().find(|&&byte| divides(&rows, byte));
        let found = found.or_else(|| b";,".iter().find(stands));
        Ok(found.map_or(Self::Blanks, |&byte| Self::Byte(byte)))
    }

    pub fn next_row<'a>(self, scanner: &mut Scanner<'a>) -> Result<Option<Row<'a>>, Error> {
        match self {
            Self::Byte(_) => scanner.next_full_row(),
            Self::Blanks => scanner.next_row(),
        }
    }

    /// Splits a row into `cells`, unless there are more than a table may have: a line without end costs no memory.
    pub fn split<'a>(self, row: Row<'a>, cells: &mut Vec<Cow<'a, [u8]>>) -> Result<(), Problem> {
        cells.clear();
        if row.text.contains(&b'\r') {
            return Err(Problem::Other(
                "a carriage return within a line: end all lines in the same way".to_owned(),
            ));
        }
        match self {
            Self::Blanks => {
                cells.extend(row.words().take(MAX_COLUMNS + 1).map(Cow::Borrowed));
                check(cells, || row.words().count())
            }
            Self::Byte(byte) => {
                for cell in Cells::new(row.text, byte).take(MAX_COLUMNS + 1) {
                    cells.push(unquote(cell)?);
                }
                check(cells, || Cells::new(row.text, byte).count())
            }
        }
    }
}

/// Refuses cells of more columns than there may be; only then are all counted.
fn check(cells: &[Cow<'_, [u8]>], count: impl FnOnce() -> usize) -> Result<(), Problem> {
    if cells.len() <= MAX_COLUMNS {
        return Ok(());
    }
    check_columns(count() as u64).map(drop)
}

/// Cuts off a remark behind numbers set apart by blanks: commas in it set nothing apart. Elsewhere,
/// as in an address, `#` is a letter.
fn without_remark(row: &[u8]) -> &[u8] {
    let Some(end) = memchr::memchr(b'#', row) else {
        return row;
    };
    let before = row[..end].split(u8::is_ascii_whitespace);
    let mut words = before.filter(|word| !word.is_empty());
    let all_numbers = words.clone().count() >= 2 && words.all(|w| scan::number(w).is_some());
    if all_numbers { &row[..end] } else { row }
}

/// Tells whether a delimiter divides rows into equally many cells, and does not just stand at ends
/// of rows, as a tab may.
fn divides(rows: &[&[u8]], byte: u8) -> bool {
    let mut widths = rows.iter().map(|row| Cells::new(row, byte).count());
    let inside = rows.iter().any(|row| row.trim_ascii().contains(&byte));
    inside
        && widths
            .next()
            .is_some_and(|first| first > 1 && widths.all(|w| w == first))
}

/// Splits a line at a delimiter that does not stand between quotes.
struct Cells<'a> {
    rest: Option<&'a [u8]>,
    delimiter: u8,
}

impl<'a> Cells<'a> {
    fn new(line: &'a [u8], delimiter: u8) -> Self {
        let rest = Some(line);
        Self { rest, delimiter }
    }
}

impl<'a> Iterator for Cells<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let line = self.rest?;
        let mut quoted = false;
        let end = line.iter().position(|&b| {
            quoted ^= b == b'"';
            b == self.delimiter && !quoted
        });
        let end = end.unwrap_or(line.len());
        self.rest = line.get(end + 1..);
        Some(line[..end].trim_ascii())
    }
}

/// Removes the quotes around a cell; doubled ones within stand for one.
fn unquote(cell: &[u8]) -> Result<Cow<'_, [u8]>, Problem> {
    let Some(inner) = cell.strip_prefix(b"\"") else {
        return Ok(Cow::Borrowed(cell));
    };
    let Some(inner) = inner.strip_suffix(b"\"") else {
        let text = scan::show(cell);
        return Err(Problem::Other(format!("quote without end: {text}")));
    };
    if !inner.contains(&b'"') {
        return Ok(Cow::Borrowed(inner.trim_ascii()));
    }
    let mut kept = Vec::with_capacity(inner.len());
    let mut after_quote = false;
    for &b in inner {
        after_quote = b == b'"' && !after_quote;
        if !after_quote {
            kept.push(b);
        }
    }
    Ok(Cow::Owned(kept))
}
