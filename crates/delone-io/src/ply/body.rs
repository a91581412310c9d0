//! The rows of elements, as text or as bytes.

use super::header::{Element, Encoding, Type};
use crate::scan::{self, Row, Scanner};
use crate::{Error, Place, Problem, cancel};
use delone::Watch;

/// Most numbers of a list that are kept: more than any list may have that is read.
const KEPT: usize = 4;

/// One row: a number for each property, and of the list that is wanted its beginning.
#[derive(Default)]
pub(super) struct Cells {
    /// One for each property; of lists, their length.
    pub numbers: Vec<f64>,
    /// The first numbers of the list.
    pub list: Vec<f64>,
}

/// What stands behind the header.
pub(super) struct Body<'s, 'a> {
    scanner: &'s mut Scanner<'a>,
    encoding: Encoding,
    /// All bytes behind the header, and those of them that have been read.
    bytes: &'a [u8],
    position: usize,
    /// Where the bytes begin in the file.
    offset: usize,
    watch: &'a dyn Watch,
    cells: Cells,
}

impl<'s, 'a> Body<'s, 'a> {
    pub fn new(
        scanner: &'s mut Scanner<'a>,
        file: &'a [u8],
        encoding: Encoding,
        watch: &'a dyn Watch,
    ) -> Self {
        let bytes = scanner.rest();
        Self {
            scanner,
            encoding,
            bytes,
            position: 0,
            offset: file.len() - bytes.len(),
            watch,
            cells: Cells::default(),
        }
    }

    /// Reserves room for as many rows as are declared, but no more than there can be.
    pub fn reserve<T>(&self, rows: &mut Vec<T>, element: &Element) {
        let left = self.bytes.len() - self.position;
        let possible = left / element.least_bytes(self.encoding).max(1) + 1;
        let declared = usize::try_from(element.rows).unwrap_or(usize::MAX);
        drop(rows.try_reserve(possible.min(declared)));
    }

    /// Reads the rows of an element, of each the beginning of the list in the place `wanted`, and hands them to
    /// `take`.
    pub fn read(
        &mut self,
        element: &Element,
        wanted: Option<usize>,
        mut take: impl FnMut(u64, &Cells) -> Result<(), Problem>,
    ) -> Result<(), Error> {
        if element.properties.is_empty() {
            // There may be any number of such rows: they take no room.
            return Ok(());
        }
        for number in 0..element.rows {
            let start = Place::Byte((self.offset + self.position) as u64);
            let place = match self.encoding {
                Encoding::Text => {
                    let Some(row) = self.scanner.next_row()? else {
                        return Err(self.scanner.here(element.truncated(number)));
                    };
                    let read = self.cells.read_text(row, element, wanted);
                    read.map_err(|problem| self.scanner.at(row, problem))?;
                    Place::Line(row.line)
                }
                Encoding::Bytes { big_endian } => {
                    cancel::check(self.watch, number as usize)?;
                    let rest = &self.bytes[self.position..];
                    let bytes = self.cells.read_bytes(rest, element, wanted, big_endian);
                    let Some(read) = bytes else {
                        return Err(self.scanner.malformed(start, element.truncated(number)));
                    };
                    self.position += read;
                    start
                }
            };
            take(number, &self.cells).map_err(|problem| self.scanner.malformed(place, problem))?;
        }
        Ok(())
    }

    /// Checks that nothing but blanks is left.
    pub fn expect_end(&mut self) -> Result<(), Error> {
        let text = || Problem::Other("more follows than the header declares".to_owned());
        match self.encoding {
            Encoding::Text => match self.scanner.next_row()? {
                Some(row) => Err(self.scanner.at(row, text())),
                None => Ok(()),
            },
            Encoding::Bytes { .. } => match self.bytes[self.position..].trim_ascii() {
                [] => Ok(()),
                _ => {
                    let place = Place::Byte((self.offset + self.position) as u64);
                    Err(self.scanner.malformed(place, text()))
                }
            },
        }
    }
}

impl Cells {
    fn clear(&mut self) {
        self.numbers.clear();
        self.list.clear();
    }

    fn read_text(
        &mut self,
        row: Row<'_>,
        element: &Element,
        wanted: Option<usize>,
    ) -> Result<(), Problem> {
        self.clear();
        let mut words = row.words();
        let mut next = |name: &str| {
            let word = words.next().ok_or_else(|| {
                let name = scan::show(name.as_bytes());
                Problem::Other(format!("the row ends before property {name:?}"))
            })?;
            scan::number(word).ok_or_else(|| Problem::NotANumber {
                what: scan::show(name.as_bytes()),
                text: scan::show(word),
            })
        };
        for (place, property) in element.properties.iter().enumerate() {
            let number = next(&property.name)?;
            self.numbers.push(number);
            if property.length.is_none() {
                continue;
            }
            // A list that is said to be longer than the row ends with it.
            for i in 0..length(number)? {
                let number = next(&property.name)?;
                if wanted == Some(place) && i < KEPT as u64 {
                    self.list.push(number);
                }
            }
        }
        match words.next() {
            None => Ok(()),
            Some(word) => Err(Problem::Other(format!(
                "{:?} stands behind the last property of the row",
                scan::show(word)
            ))),
        }
    }

    /// Reads a row and returns the number of its bytes; `None` if the file ends within it, or if a list has no length.
    fn read_bytes(
        &mut self,
        bytes: &[u8],
        element: &Element,
        wanted: Option<usize>,
        big_endian: bool,
    ) -> Option<usize> {
        self.clear();
        let mut rest = bytes;
        for (place, property) in element.properties.iter().enumerate() {
            let number = take_number(
                &mut rest,
                property.length.unwrap_or(property.kind),
                big_endian,
            )?;
            self.numbers.push(number);
            if property.length.is_none() {
                continue;
            }
            let size = property.kind.size();
            let length = usize::try_from(length(number).ok()?).ok()?;
            let mut list;
            (list, rest) = rest.split_at_checked(length.checked_mul(size)?)?;
            if wanted == Some(place) {
                for _ in 0..length.min(KEPT) {
                    self.list
                        .push(take_number(&mut list, property.kind, big_endian)?);
                }
            }
        }
        Some(bytes.len() - rest.len())
    }
}

/// Takes the length of a list.
fn length(number: f64) -> Result<u64, Problem> {
    match number >= 0.0 && number.fract() == 0.0 && number < 2f64.powi(53) {
        true => Ok(number as u64),
        false => Err(Problem::Other(format!(
            "{number} is not the length of a list"
        ))),
    }
}

/// Takes a number off the beginning.
fn take_number(rest: &mut &[u8], kind: Type, big_endian: bool) -> Option<f64> {
    fn take<const N: usize>(rest: &mut &[u8], big_endian: bool) -> Option<[u8; N]> {
        let (bytes, others) = rest.split_first_chunk::<N>()?;
        *rest = others;
        let mut bytes = *bytes;
        if big_endian {
            bytes.reverse();
        }
        Some(bytes)
    }
    Some(match kind {
        Type::I8 => f64::from(i8::from_le_bytes(take(rest, big_endian)?)),
        Type::U8 => f64::from(u8::from_le_bytes(take(rest, big_endian)?)),
        Type::I16 => f64::from(i16::from_le_bytes(take(rest, big_endian)?)),
        Type::U16 => f64::from(u16::from_le_bytes(take(rest, big_endian)?)),
        Type::I32 => f64::from(i32::from_le_bytes(take(rest, big_endian)?)),
        Type::U32 => f64::from(u32::from_le_bytes(take(rest, big_endian)?)),
        Type::F32 => f64::from(f32::from_le_bytes(take(rest, big_endian)?)),
        Type::F64 => f64::from_le_bytes(take(rest, big_endian)?),
    })
}
