//! Groups: a code, which says what the value is, and the value; in text two lines, in binary files both as bytes.

use crate::{Error, Place, Problem, cancel, scan};
use delone::{Phase, Watch};

/// What binary files begin with.
pub(super) const BINARY: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

/// A value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Value<'a> {
    Text(&'a [u8]),
    Number(f64),
}

/// A code with its value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group<'a> {
    pub code: i32,
    pub value: Value<'a>,
    /// Where the value stands: the line, or the byte in binary files.
    pub at: u64,
}

impl<'a> Group<'a> {
    /// Tells whether this is a word of the structure, such as `0 SECTION`.
    pub fn is(&self, code: i32, word: &str) -> bool {
        self.code == code && self.text().eq_ignore_ascii_case(word.as_bytes())
    }

    /// Returns the text; none of a number.
    pub fn text(&self) -> &'a [u8] {
        match self.value {
            Value::Text(text) => text,
            Value::Number(_) => b"",
        }
    }

    /// Returns the number, if the value is a finite one.
    pub fn number(&self) -> Result<f64, Problem> {
        let (value, shown) = match self.value {
            Value::Number(number) => (Some(number), number.to_string()),
            Value::Text(text) => (scan::number(text), scan::show(text)),
        };
        match value {
            Some(number) if number.is_finite() => Ok(number),
            Some(_) => Err(Problem::Other(format!(
                "the value of group {} is {shown}, numbers must be finite; repair or remove it",
                self.code
            ))),
            None => Err(Problem::NotANumber {
                what: format!("the value of group {}", self.code),
                text: shown,
            }),
        }
    }
}

/// Walks over the groups of a file.
pub(super) struct Groups<'a> {
    file: &'a str,
    bytes: &'a [u8],
    position: usize,
    /// Lines read so far, if the file is text.
    line: u64,
    kind: Kind,
    round: usize,
    watch: &'a dyn Watch,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Text,
    /// Binary, with codes of this many bytes: one up to release 12, then two.
    Binary(usize),
}

impl<'a> Groups<'a> {
    pub fn new(file: &'a str, bytes: &'a [u8], watch: &'a dyn Watch) -> Self {
        let (kind, position) = match bytes.strip_prefix(BINARY) {
            // The first group is 0, "SECTION".
            Some([_, 0, ..]) => (Kind::Binary(2), BINARY.len()),
            Some(_) => (Kind::Binary(1), BINARY.len()),
            None => (Kind::Text, bytes.len() - scan::without_mark(bytes).len()),
        };
        Self {
            file,
            bytes,
            position,
            line: 0,
            kind,
            round: 0,
            watch,
        }
    }

    /// Returns the next group, or `None` at the end of the file.
    pub fn next(&mut self) -> Result<Option<Group<'a>>, Error> {
        cancel::check(self.watch, self.round)?;
        if self.round.is_multiple_of(1 << 14) {
            let (done, total) = (self.position as u64, self.bytes.len() as u64);
            self.watch.progress(Phase::Read, done, total);
        }
        self.round += 1;
        match self.kind {
            Kind::Text => self.next_lines(),
            Kind::Binary(width) => self.next_bytes(width),
        }
    }

    /// Counts the groups that were asked for.
    pub fn round(&self) -> usize {
        self.round
    }

    /// Makes the error for a problem at a group.
    pub fn malformed(&self, at: u64, problem: Problem) -> Error {
        Error::Malformed {
            file: self.file.to_owned(),
            place: match self.kind {
                Kind::Text => Place::Line(at),
                Kind::Binary(_) => Place::Byte(at),
            },
            problem,
        }
    }

    /// Makes the error for a file that ends where something should come.
    pub fn truncated(&self, wanted: &str) -> Error {
        let at = match self.kind {
            Kind::Text => self.line.max(1),
            Kind::Binary(_) => self.bytes.len() as u64,
        };
        let text = format!("truncated: the file ends before {wanted}");
        self.malformed(at, Problem::Other(text))
    }

    fn next_lines(&mut self) -> Result<Option<Group<'a>>, Error> {
        let Some(code) = self.next_line() else {
            return Ok(None);
        };
        // Blank lines at the end are none.
        if code.is_empty() && self.bytes[self.position..].trim_ascii().is_empty() {
            return Ok(None);
        }
        let at = self.line;
        let number = scan::integer(code).and_then(|code| i32::try_from(code).ok());
        let Some(code) = number else {
            let problem = Problem::NotANumber {
                what: "the code of a group".to_owned(),
                text: scan::show(code),
            };
            return Err(self.malformed(at, problem));
        };
        let Some(text) = self.next_line() else {
            return Err(self.truncated("the value of the last group"));
        };
        Ok(Some(Group {
            code,
            value: Value::Text(text),
            at: self.line,
        }))
    }

    fn next_line(&mut self) -> Option<&'a [u8]> {
        let rest = &self.bytes[self.position..];
        if rest.is_empty() {
            return None;
        }
        let end = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        let is_pair = rest[end..].starts_with(b"\r\n");
        self.position += (end + 1 + usize::from(is_pair)).min(rest.len());
        self.line += 1;
        Some(rest[..end].trim_ascii())
    }

    fn next_bytes(&mut self, width: usize) -> Result<Option<Group<'a>>, Error> {
        if self.position == self.bytes.len() {
            return Ok(None);
        }
        let mut code = match width {
            1 => self.take::<1>()?.map(i32::from)[0],
            _ => i16::from_le_bytes(self.take()?).into(),
        };
        if (width, code) == (1, 255) {
            code = i16::from_le_bytes(self.take()?).into();
        }
        let at = self.position as u64;
        let value = match code {
            10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => {
                Value::Number(f64::from_le_bytes(self.take()?))
            }
            60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => {
                Value::Number(i16::from_le_bytes(self.take()?).into())
            }
            90..=99 | 420..=429 | 440..=459 | 1071 => {
                Value::Number(i32::from_le_bytes(self.take()?).into())
            }
            160..=169 => Value::Number(i64::from_le_bytes(self.take()?) as f64),
            290..=299 => Value::Number(self.take::<1>()?[0].into()),
            310..=319 | 1004 => {
                let length = self.take::<1>()?[0];
                self.skip(length.into())?;
                Value::Text(b"")
            }
            0..=1071 => {
                let rest = &self.bytes[self.position..];
                let Some(end) = memchr::memchr(0, rest) else {
                    return Err(self.truncated("the end of a text"));
                };
                self.position += end + 1;
                Value::Text(rest[..end].trim_ascii())
            }
            _ => {
                let text = format!("group code {code} is none of those that there are, 0 to 1071");
                return Err(self.malformed(at, Problem::Other(text)));
            }
        };
        Ok(Some(Group { code, value, at }))
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], Error> {
        let found = self.bytes[self.position..].first_chunk::<N>().copied();
        self.position += N;
        found.ok_or_else(|| self.truncated("the value of the last group"))
    }

    fn skip(&mut self, length: usize) -> Result<(), Error> {
        self.position += length;
        match self.position <= self.bytes.len() {
            true => Ok(()),
            false => Err(self.truncated("the end of binary data")),
        }
    }
}
