//! What can go wrong with a file, said with file, place and remedy.

use crate::Format;
use std::fmt;
use std::io;

/// Why a file could not be read or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The operating system refused.
    #[error("cannot {action} {file}: {source}")]
    Io {
        /// What was tried: `read`, `write`, `create` …
        action: &'static str,
        /// Name of the file, `-` for standard input or output.
        file: String,
        /// What the operating system said.
        source: io::Error,
    },
    /// Of several files, some have been replaced and one could not be.
    #[error("cannot write {file}: {source}; already replaced: {replaced}")]
    PartlyWritten {
        /// Name of the file that could not be replaced.
        file: String,
        /// Names of the files that are new.
        replaced: String,
        /// What the operating system said.
        source: io::Error,
    },
    /// The content is not what the format demands.
    #[error("{file}{place}: {problem}")]
    Malformed {
        /// Name of the file, `-` for standard input.
        file: String,
        /// Where in the file.
        place: Place,
        /// What is wrong there.
        problem: Problem,
    },
    /// Neither name nor content tells the format.
    #[error("{file}: unknown format; name it by extension or option, one of {known}")]
    UnknownFormat {
        /// Name of the file.
        file: String,
        /// Names of the formats that would do.
        known: String,
    },
    /// A file is about another one, which was not given with it.
    #[error("{file} needs {needed}: open both together")]
    Alone {
        /// Name of the file.
        file: String,
        /// Name of the one that is missing.
        needed: String,
    },
    /// The format is known but cannot do this.
    #[error("{file}: format {format} cannot {action}; use one of {instead}")]
    Unsupported {
        /// Name of the file.
        file: String,
        /// The format.
        format: Format,
        /// What it cannot do.
        action: &'static str,
        /// Names of the formats that can.
        instead: String,
    },
    /// The format is known, but this build was made without it.
    #[error(
        "{file}: this build cannot read or write {format}; build delone-io with the feature {feature}"
    )]
    NotBuilt {
        /// Name of the file.
        file: String,
        /// The format.
        format: Format,
        /// The feature that brings it.
        feature: &'static str,
    },
    /// The column asked for does not exist.
    #[error("{file}: no column {column}; there are {available}")]
    NoSuchColumn {
        /// Name of the file.
        file: String,
        /// The column asked for.
        column: String,
        /// The columns that exist.
        available: String,
    },
    /// The column asked for as x is that asked for as y.
    #[error("{file}: x and y are the same column, {column}; name two")]
    SameColumn {
        /// Name of the file.
        file: String,
        /// The column asked for.
        column: String,
    },
    /// The mesh to be written is not one: a corner or a table does not fit the points.
    #[error("cannot write the mesh: {0}")]
    BadMesh(String),
    /// The picture cannot be made.
    #[error("cannot draw {file}: {reason}")]
    Picture {
        /// Name of the file.
        file: String,
        /// What is in the way and what to do.
        reason: String,
    },
    /// The caller's [`Watch`](delone::Watch) asked to stop; no file was left behind.
    #[error("cancelled")]
    Cancelled,
}

/// Where in a file something is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// On this line, counted from 1.
    Line(u64),
    /// On this line in this column, both counted from 1, columns in bytes.
    Column(u64, u64),
    /// At this byte, counted from 0.
    Byte(u64),
    /// In the file as a whole.
    File,
}

impl Place {
    /// Tells line and column of a byte in a text.
    pub(crate) fn in_text(text: &[u8], byte: usize) -> Self {
        let before = &text[..byte.min(text.len())];
        let lines = memchr::memchr_iter(b'\n', before).count();
        let start = memchr::memrchr(b'\n', before).map_or(0, |end| end + 1);
        Self::Column(lines as u64 + 1, (before.len() - start) as u64 + 1)
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, ":{line}"),
            Self::Column(line, column) => write!(f, ":{line}:{column}"),
            Self::Byte(byte) => write!(f, " at byte {byte}"),
            Self::File => Ok(()),
        }
    }
}

/// What is wrong with the content of a file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The file ends before everything it declares has come.
    #[error("truncated: header says {declared} {items}, file has {found}")]
    Truncated {
        /// What is counted: `points`, `triangles` …
        items: &'static str,
        /// The number the header declares.
        declared: u64,
        /// The number found.
        found: u64,
    },
    /// A number was expected.
    #[error("{what} is not a number: {text:?}")]
    NotANumber {
        /// What should have been a number.
        what: String,
        /// What stands there.
        text: String,
    },
    /// A coordinate is NaN or infinite, or too large for a double.
    #[error("point {index}: {axis} is {text}, coordinates must be finite; repair or remove it")]
    NotFinite {
        /// Index of the point, as the file numbers it.
        index: u64,
        /// `x` or `y`.
        axis: char,
        /// What stands there.
        text: String,
    },
    /// A row refers to something that does not exist.
    #[error("{item} {row} names {target} {index} of {limit}{}", base_hint(*.base))]
    BadIndex {
        /// What refers: `triangle`, `segment` …
        item: &'static str,
        /// Its number, as the file numbers it.
        row: u64,
        /// What is referred to: `vertex` …
        target: &'static str,
        /// The number that is out of range.
        index: i64,
        /// How many there are.
        limit: u64,
        /// The number of the first of them.
        base: u32,
    },
    /// A row does not carry the number it should.
    #[error("row is numbered {found:?}, expected {expected}; rows must be numbered without gaps")]
    BadRowNumber {
        /// The number that should come.
        expected: u64,
        /// What stands there.
        found: String,
    },
    /// The points are not points of the plane.
    #[error("dimension must be 2, not {0}")]
    Dimension(i64),
    /// A row has the wrong number of columns.
    #[error("expected {expected} columns, found {found}")]
    Columns {
        /// The number that should be.
        expected: usize,
        /// The number there is.
        found: usize,
    },
    /// There is nothing in the file.
    #[error("the file is empty")]
    Empty,
    /// More rows than 32-bit ids can number, or more columns than any point needs.
    #[error("{given} {items}, at most {limit} are possible; {}", remedy(.items))]
    TooMany {
        /// What is counted.
        items: &'static str,
        /// How many there are.
        given: u64,
        /// How many may be.
        limit: u64,
    },
    /// Anything else, said in full.
    #[error("{0}")]
    Other(String),
}

fn base_hint(base: u32) -> &'static str {
    if base == 1 {
        " (numbered from 1)"
    } else {
        " (numbered from 0)"
    }
}

fn remedy(items: &str) -> &'static str {
    match items {
        "columns" => "keep those that are needed",
        _ => "split the data into tiles",
    }
}
