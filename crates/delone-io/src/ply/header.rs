//! The header: lines of text that name elements and their properties.

use crate::scan::{self, Row, Scanner};
use crate::{Error, Place, Problem, points};

/// Tells whether the bytes begin like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    head.starts_with(b"ply\n") || head.starts_with(b"ply\r")
}

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Bytes { big_endian: bool },
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Type {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Type {
    fn of(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// Returns the number of bytes.
    pub const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub const fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

/// What every row of an element has.
pub(super) struct Property {
    pub name: String,
    /// The type of the number, or of each number of the list.
    pub kind: Type,
    /// Of a list, the type of its length.
    pub length: Option<Type>,
}

/// Rows that have the same properties.
pub(super) struct Element {
    pub name: String,
    pub rows: u64,
    pub properties: Vec<Property>,
    /// Where the header names it.
    pub line: u64,
}

impl Element {
    /// Returns the place of a property that is no list.
    pub fn number(&self, name: &str) -> Option<usize> {
        let mut all = self.properties.iter();
        all.position(|p| p.name == name && p.length.is_none())
    }

    /// Returns the place of a list.
    pub fn list(&self, name: &str) -> Option<usize> {
        let mut all = self.properties.iter();
        all.position(|p| p.name == name && p.length.is_some())
    }

    /// Returns the fewest bytes that a row takes.
    pub fn least_bytes(&self, encoding: Encoding) -> usize {
        let of = |p: &Property| p.length.unwrap_or(p.kind).size();
        match encoding {
            Encoding::Text => 2 * self.properties.len(),
            Encoding::Bytes { .. } => self.properties.iter().map(of).sum(),
        }
    }

    /// Makes the problem that the file ends after so many rows.
    pub fn truncated(&self, found: u64) -> Problem {
        let items = match self.name.as_str() {
            "vertex" => "points",
            "face" => "faces",
            "edge" => "edges",
            _ => "rows",
        };
        Problem::Truncated {
            items,
            declared: self.rows,
            found,
        }
    }
}

/// What the header says.
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
}

impl Header {
    /// Reads up to and with the line `end_header`.
    pub fn read(scanner: &mut Scanner<'_>) -> Result<Self, Error> {
        match scanner.next_row()? {
            Some(row) if row.text == b"ply" => {}
            Some(row) => {
                let text = "the first line must be `ply`".to_owned();
                return Err(scanner.at(row, Problem::Other(text)));
            }
            None => return Err(scanner.malformed(Place::File, Problem::Empty)),
        }
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        while let Some(row) = scanner.next_row()? {
            let mut words = row.words();
            let read = match words.next() {
                Some(b"end_header") => {
                    let encoding = encoding.ok_or_else(|| {
                        scanner.at(row, Problem::Other("the header names no format".to_owned()))
                    })?;
                    return Ok(Self { encoding, elements });
                }
                Some(b"comment" | b"obj_info") => Ok(()),
                Some(b"format") => read_format(words).map(|format| encoding = Some(format)),
                Some(b"element") => read_element(row, words, &elements).map(|e| elements.push(e)),
                Some(b"property") => read_property(words, elements.last_mut()),
                _ => Err(Problem::Other(format!(
                    "{:?} in the header is neither format, element, property, comment nor end_header",
                    scan::show(row.text)
                ))),
            };
            read.map_err(|problem| scanner.at(row, problem))?;
        }
        let text = "truncated: the file ends before end_header".to_owned();
        Err(scanner.here(Problem::Other(text)))
    }
}

fn read_format<'w>(mut words: impl Iterator<Item = &'w [u8]>) -> Result<Encoding, Problem> {
    let name = words.next().unwrap_or_default();
    if words.next() != Some(b"1.0") {
        return Err(Problem::Other("the version must be 1.0".to_owned()));
    }
    match name {
        b"ascii" => Ok(Encoding::Text),
        b"binary_little_endian" => Ok(Encoding::Bytes { big_endian: false }),
        b"binary_big_endian" => Ok(Encoding::Bytes { big_endian: true }),
        other => Err(Problem::Other(format!(
            "format {:?} is none of ascii, binary_little_endian, binary_big_endian",
            scan::show(other)
        ))),
    }
}

fn read_element<'w>(
    row: Row<'_>,
    mut words: impl Iterator<Item = &'w [u8]>,
    others: &[Element],
) -> Result<Element, Problem> {
    let name = words.next().unwrap_or_default();
    let name = String::from_utf8_lossy(name).into_owned();
    let count = words.next().unwrap_or_default();
    let rows = scan::integer(count).and_then(|n| u64::try_from(n).ok());
    let rows = rows.ok_or_else(|| Problem::NotANumber {
        what: "count of an element".to_owned(),
        text: scan::show(count),
    })?;
    // Few are known; without a bound, many would be searched for each of them.
    if others.len() >= 256 || others.iter().any(|e| e.name == name) {
        let shown = scan::show(name.as_bytes());
        return Err(Problem::Other(format!("one element {shown:?} too many")));
    }
    Ok(Element {
        name,
        rows,
        properties: Vec::new(),
        line: row.line,
    })
}

fn read_property<'w>(
    mut words: impl Iterator<Item = &'w [u8]>,
    element: Option<&mut Element>,
) -> Result<(), Problem> {
    let Some(element) = element else {
        let text = "a property stands before every element".to_owned();
        return Err(Problem::Other(text));
    };
    let mut word = || words.next().unwrap_or_default();
    let known = |name: &[u8]| {
        Type::of(name).ok_or_else(|| {
            Problem::Other(format!(
                "type {:?} is none of char, uchar, short, ushort, int, uint, float, double",
                scan::show(name)
            ))
        })
    };
    let first = word();
    let (length, kind) = match first {
        b"list" => (Some(known(word())?), known(word())?),
        kind => (None, known(kind)?),
    };
    let name = String::from_utf8_lossy(word()).into_owned();
    let is_known = element.properties.iter().any(|p| p.name == name);
    if is_known || name.is_empty() {
        let (shown, element) = (scan::show(name.as_bytes()), &element.name);
        let text = format!("property {shown:?} of element {element:?} needs a name of its own");
        return Err(Problem::Other(text));
    }
    points::check_columns(element.properties.len() as u64 + 1)?;
    element.properties.push(Property { name, kind, length });
    Ok(())
}
