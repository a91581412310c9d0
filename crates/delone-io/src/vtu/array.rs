//! One array: what its element says about it, and its numbers from text or bytes.

use super::grid::Data;
use super::packed::{Budget, Encoding, Fault, Feed, unpack};
use super::{Stop, other, poll};
use crate::cursor::{join, signed};
use crate::{Problem, exact, points, scan};
use delone::Watch;
use quick_xml::events::BytesStart;

/// What stands behind the elements, for arrays that are there.
#[derive(Clone, Copy)]
pub(super) struct Appended<'a> {
    pub bytes: &'a [u8],
    /// Whether they are bytes as such, not letters.
    pub is_raw: bool,
}

/// Where the numbers of an array are.
enum Home {
    Text,
    Letters,
    /// Behind the elements, so many bytes from the beginning.
    Appended(u64),
}

/// What an element says about its array.
pub(super) struct ArrayHead {
    pub name: String,
    pub components: usize,
    meaning: Meaning,
    /// Bytes of one number.
    width: usize,
    home: Home,
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
            home: home(&name, start)?,
            meaning,
            width,
            name,
        })
    }

    /// Whether the numbers are integers by their type.
    fn is_integer(&self) -> bool {
        !matches!(self.meaning, Meaning::Float)
    }

    /// Reads the numbers.
    pub fn decode(
        self,
        encoding: Encoding,
        text: &[u8],
        appended: Option<Appended<'_>>,
        budget: &mut Budget,
        watch: &dyn Watch,
    ) -> Result<Data, Stop> {
        let feed = match (&self.home, appended) {
            (Home::Text, _) => None,
            (Home::Letters, _) => Some(Feed::letters_of_text(text)),
            (Home::Appended(offset), Some(appended)) => {
                let offset = usize::try_from(*offset).ok();
                let bytes = offset.and_then(|offset| appended.bytes.get(offset..));
                let bytes = bytes.ok_or_else(|| self.broken("begins behind the appended data"))?;
                Some(match appended.is_raw {
                    true => Feed::Bytes(bytes),
                    false => Feed::Letters(bytes.into(), 0, Vec::new()),
                })
            }
            (Home::Appended(_), None) => {
                return Err(self
                    .broken("is appended, but there are no appended data")
                    .into());
            }
        };
        let values = match feed {
            None => self.decode_ascii(text, watch)?,
            Some(feed) => {
                let is_alone = matches!(self.home, Home::Letters);
                let data = unpack(feed, encoding, is_alone, budget, watch);
                let data = data.map_err(|fault| match fault {
                    Fault::Broken(text) => self.broken(&text).into(),
                    Fault::Stop(stop) => stop,
                })?;
                self.decode_bytes(encoding, &data, watch)?
            }
        };
        Ok(Data {
            are_integers: self.is_integer(),
            name: self.name,
            components: self.components,
            values,
        })
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

    fn decode_bytes(
        &self,
        encoding: Encoding,
        data: &[u8],
        watch: &dyn Watch,
    ) -> Result<Vec<f64>, Stop> {
        let width = self.width;
        if !data.len().is_multiple_of(width) {
            return Err(self.broken("ends within a number").into());
        }
        let mut values = Vec::with_capacity(data.len() / width);
        for (i, number) in data.chunks_exact(width).enumerate() {
            poll(watch, i)?;
            let bits = join(number, encoding.big_endian);
            values.push(match self.meaning {
                Meaning::Float if width == 4 => f32::from_bits(bits as u32).into(),
                Meaning::Float => f64::from_bits(bits),
                Meaning::Unsigned => self.exact(bits.into(), i)?,
                Meaning::Signed => self.exact(signed(bits, width).into(), i)?,
            });
        }
        Ok(values)
    }

    fn broken(&self, what: &str) -> Problem {
        other(format!("array {:?}: {what}", self.name))
    }
}

/// Says where the numbers of an array are.
fn home(name: &str, start: &BytesStart<'_>) -> Result<Home, Problem> {
    match attribute(start, "format")?.as_deref() {
        None | Some("ascii") => Ok(Home::Text),
        Some("binary") => Ok(Home::Letters),
        Some("appended") => {
            let offset = attribute(start, "offset")?.unwrap_or_default();
            let (what, text) = ("offset".to_owned(), scan::show(offset.as_bytes()));
            let offset = offset.trim().parse();
            Ok(Home::Appended(
                offset.map_err(|_| Problem::NotANumber { what, text })?,
            ))
        }
        Some(format) => Err(other(format!(
            "array {name:?} is in format {format}: only ascii, binary and appended are understood"
        ))),
    }
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
