//! Rows and numbers of text files, with the line they stand on.
//!
//! A row is a line that holds something besides blanks and comments; a comment runs from `#` to the
//! end of the line. Bytes need not be UTF-8. No row is copied.

use crate::{Error, Place, Problem};
use delone::{Phase, Watch};

/// Lines between two looks at the watch: some 100 µs of work.
const LINES_PER_POLL: u64 = 1024;

/// Walks over the lines of a text.
pub(crate) struct Scanner<'a> {
    /// Name of the file, for messages.
    pub file: &'a str,
    text: &'a [u8],
    /// A line feed; a carriage return in files that have no line feed.
    line_end: u8,
    position: usize,
    line: u64,
    watch: &'a dyn Watch,
}

/// One line that holds something.
#[derive(Clone, Copy)]
pub(crate) struct Row<'a> {
    /// The line without comment and surrounding blanks; tabs may be left, see
    /// [`next_full_row`](Scanner::next_full_row).
    pub text: &'a [u8],
    /// Number of the line, from 1.
    pub line: u64,
}

impl<'a> Scanner<'a> {
    pub fn new(file: &'a str, bytes: &'a [u8], watch: &'a dyn Watch) -> Self {
        let has = |byte| memchr::memchr(byte, bytes).is_some();
        Self {
            file,
            text: without_mark(bytes),
            line_end: if has(b'\n') || !has(b'\r') {
                b'\n'
            } else {
                b'\r'
            },
            position: 0,
            line: 0,
            watch,
        }
    }

    /// Returns the next row, or `None` at the end.
    ///
    /// # Errors
    /// If the watch cancels.
    pub fn next_row(&mut self) -> Result<Option<Row<'a>>, Error> {
        self.next_row_by(strip_comment)
    }

    /// As [`next_row`](Self::next_row), but only whole lines are comments.
    ///
    /// Tabs at the ends stay: where they set cells apart, empty cells lie beyond them.
    pub fn next_full_row(&mut self) -> Result<Option<Row<'a>>, Error> {
        self.next_row_by(full_row)
    }

    fn next_row_by(&mut self, strip: impl Fn(&[u8]) -> &[u8]) -> Result<Option<Row<'a>>, Error> {
        while self.position < self.text.len() {
            let rest = &self.text[self.position..];
            let end = memchr::memchr(self.line_end, rest).unwrap_or(rest.len());
            self.position += (end + 1).min(rest.len());
            self.line += 1;
            if self.line.is_multiple_of(LINES_PER_POLL) {
                self.poll()?;
            }
            let text = strip(&rest[..end]);
            if !text.is_empty() {
                let line = self.line;
                return Ok(Some(Row { text, line }));
            }
        }
        self.poll().map(|()| None)
    }

    fn poll(&self) -> Result<(), Error> {
        if self.watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        let (done, total) = (self.position as u64, self.text.len() as u64);
        self.watch.progress(Phase::Read, done, total);
        Ok(())
    }

    /// Reserves room for the rows still to come: as many as are declared, but no more than the bytes
    /// left can hold. Without memory for so many, the vector grows with the rows that do come.
    pub fn reserve<T>(&self, rows: &mut Vec<T>, bytes_per_row: usize, declared: u64) {
        let possible = (self.text.len() - self.position) / bytes_per_row + 1;
        let declared = usize::try_from(declared).unwrap_or(usize::MAX);
        drop(rows.try_reserve(possible.min(declared)));
    }

    /// Returns what stands behind the row just read.
    pub fn rest(&self) -> &'a [u8] {
        &self.text[self.position..]
    }

    /// Makes the error for a problem in a row.
    pub fn at(&self, row: Row<'_>, problem: Problem) -> Error {
        self.malformed(Place::Line(row.line), problem)
    }

    /// Makes the error for a problem at the line just read.
    pub fn here(&self, problem: Problem) -> Error {
        self.malformed(Place::Line(self.line.max(1)), problem)
    }

    /// Makes the error for a problem of the whole file.
    pub fn malformed(&self, place: Place, problem: Problem) -> Error {
        Error::Malformed {
            file: self.file.to_owned(),
            place,
            problem,
        }
    }
}

impl<'a> Row<'a> {
    /// Splits the row at blanks.
    pub fn words(self) -> impl Iterator<Item = &'a [u8]> + Clone {
        self.text
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty())
    }
}

fn strip_comment(line: &[u8]) -> &[u8] {
    line[..memchr::memchr(b'#', line).unwrap_or(line.len())].trim_ascii()
}

fn full_row(mut line: &[u8]) -> &[u8] {
    if matches!(line.trim_ascii_start(), [] | [b'#', ..]) {
        return &[];
    }
    while let [b' ' | b'\r', rest @ ..] | [rest @ .., b' ' | b'\r'] = line {
        line = rest;
    }
    line
}

/// Takes off the mark of UTF-8 at the beginning of a text.
pub(crate) fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// Reads a number as Rust does: `1`, `-.5`, `1e-3`, `inf`, `nan`.
pub(crate) fn number(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// Reads an integer; `3.0` is one too.
pub(crate) fn integer(word: &[u8]) -> Option<i64> {
    let text = std::str::from_utf8(word).ok()?;
    text.parse().ok().or_else(|| {
        let value: f64 = text.parse().ok()?;
        (value.fract() == 0.0 && value.abs() < 2f64.powi(53)).then_some(value as i64)
    })
}

/// Shows a word of a file in a message: at most 40 characters, repaired to UTF-8.
pub(crate) fn show(word: &[u8]) -> String {
    let text = String::from_utf8_lossy(&word[..word.len().min(160)]);
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into_owned(),
    }
}

/// Reads a coordinate, which must be a finite number.
pub(crate) fn coordinate(word: &[u8], axis: char, index: u64) -> Result<f64, Problem> {
    match number(word) {
        Some(value) if value.is_finite() => Ok(value),
        Some(_) => Err(Problem::NotFinite {
            index,
            axis,
            text: show(word),
        }),
        None => Err(Problem::NotANumber {
            what: axis.to_string(),
            text: show(word),
        }),
    }
}
