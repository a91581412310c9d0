//! One array: what its element says about it, and its numbers from text or base64.

use super::{Stop, other, poll};
use crate::{Problem, exact, points, scan};
use base64::prelude::{BASE64_STANDARD, Engine};
use delone::Watch;
use quick_xml::events::BytesStart;
use std::borrow::Cow;

/// Letters of base64 decoded between two looks at the watch; divisible by 4.
const LETTERS_PER_POLL: usize = 1 << 18;

/// How binary arrays are written, from the root element.
#[derive(Clone, Copy, Default)]
pub(super) struct Encoding {
    pub big_endian: bool,
    /// Whether the count of bytes takes eight bytes instead of four.
    pub wide_counts: bool,
}

/// What an element says about its array.
pub(super) struct ArrayHead {
    pub name: String,
    pub components: usize,
    meaning: Meaning,
    /// Bytes of one number.
    width: usize,
    in_base64: bool,
}

impl ArrayHead {
    pub fn read(start: &BytesStart<'_>) -> Result<Self, Problem> {
        let get = |key| attribute(start, key);
        let components = get("NumberOfComponents")?.unwrap_or_else(|| "1".to_owned());
        let what = "NumberOfComponents".to_owned();
        let count = components.parse().map_err(|_| Problem::NotANumber {
            what,
            text: scan::show(components.as_bytes()),
        })?;
        let name = get("Name")?.unwrap_or_default();
        let kind = get("type")?.unwrap_or_default();
        let (meaning, width) = element(&kind)
            .ok_or_else(|| other(format!("array {name:?}: type {kind:?} is not understood")))?;
        Ok(Self {
            components: points::check_columns(count)?.max(1),
            in_base64: is_base64(&name, get("format")?.as_deref())?,
            meaning,
            width,
            name,
        })
    }

    /// Whether the numbers are integers by their type.
    pub fn is_integer(&self) -> bool {
        !matches!(self.meaning, Meaning::Float)
    }

    /// Reads the numbers.
    pub fn decode(
        &self,
        encoding: Encoding,
        text: &[u8],
        watch: &dyn Watch,
    ) -> Result<Vec<f64>, Stop> {
        if self.in_base64 {
            self.decode_base64(encoding, text, watch)
        } else {
            self.decode_ascii(text, watch)
        }
    }

    fn decode_ascii(&self, text: &[u8], watch: &dyn Watch) -> Result<Vec<f64>, Stop> {
        let words = text
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty());
        let mut values = Vec::new();
        for word in words {
            poll(watch, values.len())?;
            values.push(self.word(word, values.len())?);
        }
        Ok(values)
    }

    /// Reads number `i` from text.
    fn word(&self, word: &[u8], i: usize) -> Result<f64, Problem> {
        let text = std::str::from_utf8(word).ok();
        if self.is_integer()
            && let Some(value) = text.and_then(|text| text.parse().ok())
        {
            return self.exact(value, i);
        }
        scan::number(word).ok_or_else(|| Problem::NotANumber {
            what: format!("value of array {:?}", self.name),
            text: scan::show(word),
        })
    }

    fn exact(&self, value: i128, i: usize) -> Result<f64, Problem> {
        exact::to_double(value).ok_or_else(|| {
            let problem = exact::inexact(i / self.components, value);
            self.broken(&problem.to_string())
        })
    }

    fn decode_base64(
        &self,
        encoding: Encoding,
        text: &[u8],
        watch: &dyn Watch,
    ) -> Result<Vec<f64>, Stop> {
        let bytes = self.bytes(text, watch)?;
        if bytes.is_empty() {
            return Ok(Vec::new());
        }
        let data = self.counted(encoding, &bytes)?;
        let width = self.width;
        if !data.len().is_multiple_of(width) {
            return Err(self.broken("ends within a number").into());
        }
        let mut values = Vec::with_capacity(data.len() / width);
        for (i, number) in data.chunks_exact(width).enumerate() {
            poll(watch, i)?;
            let bits = unsigned(number, encoding.big_endian);
            values.push(match self.meaning {
                Meaning::Float if width == 4 => f32::from_bits(bits as u32).into(),
                Meaning::Float => f64::from_bits(bits),
                Meaning::Unsigned => self.exact(bits.into(), i)?,
                Meaning::Signed => self.exact(signed(bits, width).into(), i)?,
            });
        }
        Ok(values)
    }

    /// Decodes base64, in pieces between which cancellation is noticed.
    fn bytes(&self, text: &[u8], watch: &dyn Watch) -> Result<Vec<u8>, Stop> {
        let letters = without_blanks(text.trim_ascii());
        let mut bytes = Vec::with_capacity(letters.len() / 4 * 3 + 3);
        for piece in letters.chunks(LETTERS_PER_POLL) {
            poll(watch, 0)?;
            BASE64_STANDARD
                .decode_vec(piece, &mut bytes)
                .map_err(|e| self.broken(&format!("broken base64: {e}")))?;
        }
        Ok(bytes)
    }

    /// Returns the data behind their count of bytes, which must be right.
    fn counted<'b>(&self, encoding: Encoding, bytes: &'b [u8]) -> Result<&'b [u8], Problem> {
        let count_width = if encoding.wide_counts { 8 } else { 4 };
        let (count, data) = bytes
            .split_at_checked(count_width)
            .ok_or_else(|| self.broken("shorter than its count"))?;
        let count = unsigned(count, encoding.big_endian);
        if count == data.len() as u64 {
            return Ok(data);
        }
        Err(self.broken(&format!(
            "truncated: declares {count} bytes, has {}",
            data.len()
        )))
    }

    fn broken(&self, what: &str) -> Problem {
        other(format!("array {:?}: {what}", self.name))
    }
}

/// Tells base64 from text; other formats are refused.
fn is_base64(name: &str, format: Option<&str>) -> Result<bool, Problem> {
    match format {
        None | Some("ascii") => Ok(false),
        Some("binary") => Ok(true),
        Some(format) => Err(other(format!(
            "array {name:?} is in format {format}: only inline ascii and binary are understood"
        ))),
    }
}

fn without_blanks(text: &[u8]) -> Cow<'_, [u8]> {
    if !text.iter().any(u8::is_ascii_whitespace) {
        return Cow::Borrowed(text);
    }
    let letters = text.iter().copied().filter(|b| !b.is_ascii_whitespace());
    Cow::Owned(letters.collect())
}

/// Joins up to eight bytes.
fn unsigned(bytes: &[u8], big_endian: bool) -> u64 {
    let join = |sum: u64, &b: &u8| sum << 8 | u64::from(b);
    if big_endian {
        bytes.iter().fold(0, join)
    } else {
        bytes.iter().rev().fold(0, join)
    }
}

/// Carries the sign of a number of `width` bytes to the top.
fn signed(bits: u64, width: usize) -> i64 {
    let unused = 64 - 8 * width as u32;
    ((bits << unused) as i64) >> unused
}

/// How the bits of a number are meant.
#[derive(Clone, Copy)]
enum Meaning {
    Float,
    Signed,
    Unsigned,
}

/// Returns meaning and width in bytes of a VTK number type.
fn element(kind: &str) -> Option<(Meaning, usize)> {
    Some(match kind {
        "Float32" => (Meaning::Float, 4),
        "Float64" => (Meaning::Float, 8),
        "Int8" => (Meaning::Signed, 1),
        "Int16" => (Meaning::Signed, 2),
        "Int32" => (Meaning::Signed, 4),
        "Int64" => (Meaning::Signed, 8),
        "UInt8" => (Meaning::Unsigned, 1),
        "UInt16" => (Meaning::Unsigned, 2),
        "UInt32" => (Meaning::Unsigned, 4),
        "UInt64" => (Meaning::Unsigned, 8),
        _ => return None,
    })
}

/// Returns the value of an attribute of an element.
pub(super) fn attribute(start: &BytesStart<'_>, key: &str) -> Result<Option<String>, Problem> {
    let broken = |e: &dyn std::fmt::Display| other(format!("broken XML: {e}"));
    let Some(found) = start.try_get_attribute(key).map_err(|e| broken(&e))? else {
        return Ok(None);
    };
    let value = found.unescape_value().map_err(|e| broken(&e))?;
    Ok(Some(value.into_owned()))
}
