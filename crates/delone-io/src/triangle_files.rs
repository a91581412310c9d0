//! What the text formats of Triangle share: a header of counts, then numbered rows.
//!
//! J. R. Shewchuk, *Triangle*, <https://www.cs.cmu.edu/~quake/triangle.html>, section "file formats".
//! Rows are numbered from 0 or 1, which the first row decides, and stay in order; `#` starts a
//! comment. Counts of the header are checked against the rows, never trusted for an allocation.

use crate::scan::{self, Row, Scanner};
use crate::{Error, Lines, Place, Problem};

/// The counts in a header, with the row they stand in.
pub(crate) struct Header<'a> {
    row: Row<'a>,
    counts: Vec<i64>,
}

/// Most counts that a header of these formats has.
const MAX_COUNTS: usize = 4;

impl<'a> Header<'a> {
    /// Reads the header from the next row; counts left out are read as zero.
    pub fn read(scanner: &mut Scanner<'a>) -> Result<Self, Error> {
        Self::read_if_any(scanner)?.ok_or_else(|| scanner.malformed(Place::File, Problem::Empty))
    }

    /// As [`read`](Self::read), but the text may also be at its end.
    pub fn read_if_any(scanner: &mut Scanner<'a>) -> Result<Option<Self>, Error> {
        let Some(row) = scanner.next_row()? else {
            return Ok(None);
        };
        let mut counts = Vec::new();
        for word in row.words() {
            let count = scan::integer(word).ok_or_else(|| {
                let what = "count in the header".to_owned();
                let text = scan::show(word);
                scanner.at(row, Problem::NotANumber { what, text })
            })?;
            if counts.len() == MAX_COUNTS {
                let (expected, found) = (MAX_COUNTS, row.words().count());
                return Err(scanner.at(row, Problem::Columns { expected, found }));
            }
            counts.push(count);
        }
        Ok(Some(Self { row, counts }))
    }

    /// Returns count number `place`, or what is usual if the header ends before it.
    pub fn get(&self, place: usize, usual: i64) -> i64 {
        self.counts.get(place).copied().unwrap_or(usual)
    }

    /// Returns count number `place`, which must not be negative.
    pub fn count(&self, scanner: &Scanner<'_>, place: usize, what: &str) -> Result<u64, Error> {
        u64::try_from(self.get(place, 0)).map_err(|_| {
            let count = self.get(place, 0);
            self.problem(
                scanner,
                Problem::Other(format!("{count} {what}: a count cannot be negative")),
            )
        })
    }

    /// Makes the error for a problem in the header.
    pub fn problem(&self, scanner: &Scanner<'_>, problem: Problem) -> Error {
        scanner.at(self.row, problem)
    }
}

/// A block of numbered rows.
pub(crate) struct Block {
    /// What a row is, in plural, for messages.
    pub items: &'static str,
    /// Number of rows that the header declares.
    pub declared: u64,
    /// Number of columns, the row's own number included.
    pub columns: usize,
    /// Number of the first row, if it is known already.
    pub base: Option<u32>,
}

impl Block {
    /// Reads the rows, gives each with its number and its further cells to `take`, and returns the
    /// number of the first and the lines of all.
    pub fn read<'a>(
        &self,
        scanner: &mut Scanner<'a>,
        take: impl FnMut(u64, &[&'a [u8]]) -> Result<(), Problem>,
    ) -> Result<(u32, Lines), Error> {
        self.read_ragged(scanner, self.columns, take)
    }

    /// As [`read`](Self::read), but rows may end after `least` columns.
    pub fn read_ragged<'a>(
        &self,
        scanner: &mut Scanner<'a>,
        least: usize,
        mut take: impl FnMut(u64, &[&'a [u8]]) -> Result<(), Problem>,
    ) -> Result<(u32, Lines), Error> {
        let mut base = self.base;
        let mut lines = Lines::default();
        let mut cells = Vec::new();
        for found in 0..self.declared {
            let Some(row) = scanner.next_row()? else {
                let (items, declared) = (self.items, self.declared);
                return Err(scanner.here(Problem::Truncated {
                    items,
                    declared,
                    found,
                }));
            };
            cells.clear();
            cells.extend(row.words().take(self.columns.saturating_add(1)));
            let number = self
                .check_row(row, &cells, least, base.map(|base| found + u64::from(base)))
                .map_err(|problem| scanner.at(row, problem))?;
            base.get_or_insert(number as u32);
            take(number, &cells[1..]).map_err(|problem| scanner.at(row, problem))?;
            lines.push(row.line);
        }
        Ok((base.unwrap_or(0), lines))
    }

    /// Checks width and number of a row and returns the number.
    fn check_row(
        &self,
        row: Row<'_>,
        cells: &[&[u8]],
        least: usize,
        due: Option<u64>,
    ) -> Result<u64, Problem> {
        if !(least..=self.columns).contains(&cells.len()) {
            let (expected, found) = (self.columns, row.words().count());
            return Err(Problem::Columns { expected, found });
        }
        let number = scan::integer(cells[0]).and_then(|n| u64::try_from(n).ok());
        match number {
            Some(n) if due.map_or(n <= 1, |due| n == due) => Ok(n),
            _ => Err(Problem::BadRowNumber {
                expected: due.unwrap_or(0),
                found: scan::show(cells[0]),
            }),
        }
    }
}

/// Checks that nothing follows the rows that the header declares.
pub(crate) fn expect_end(
    scanner: &mut Scanner<'_>,
    items: &str,
    declared: u64,
) -> Result<(), Error> {
    match scanner.next_row()? {
        None => Ok(()),
        Some(row) => Err(scanner.at(
            row,
            Problem::Other(format!(
                "header says {declared} {items}, but more rows follow"
            )),
        )),
    }
}

/// Reads a number of any kind; the name says what it is.
pub(crate) fn number(word: &[u8], what: &str) -> Result<f64, Problem> {
    scan::number(word).ok_or_else(|| Problem::NotANumber {
        what: what.to_owned(),
        text: scan::show(word),
    })
}

/// Reads an integer that fits 32 bits.
pub(crate) fn marker(word: &[u8]) -> Result<i32, Problem> {
    let text = || scan::show(word);
    let value = scan::integer(word).ok_or_else(|| Problem::NotANumber {
        what: "marker".to_owned(),
        text: text(),
    })?;
    i32::try_from(value)
        .map_err(|_| Problem::Other(format!("marker {} does not fit 32 bits", text())))
}

/// Reads a reference to a vertex and returns its index from 0.
pub(crate) fn vertex(
    word: &[u8],
    (item, row): (&'static str, u64),
    base: u32,
    num_vertices: usize,
) -> Result<u32, Problem> {
    let index = scan::integer(word).ok_or_else(|| Problem::NotANumber {
        what: format!("vertex of {item} {row}"),
        text: scan::show(word),
    })?;
    let from_zero = index
        .checked_sub(i64::from(base))
        .and_then(|i| u32::try_from(i).ok());
    from_zero
        .filter(|&i| (i as usize) < num_vertices)
        .ok_or(Problem::BadIndex {
            item,
            row,
            target: "vertex",
            index,
            limit: num_vertices as u64,
            base,
        })
}
