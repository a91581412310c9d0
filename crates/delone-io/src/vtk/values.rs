//! Numbers of a declared type, as text or bytes.

use crate::cursor::{Cursor, join, signed};
use crate::{Error, exact, scan};

/// How the bits of a number are meant, and how many bytes it takes.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Kind {
    Float(usize),
    Signed(usize),
    Unsigned(usize),
    /// Eight to a byte.
    Bit,
    Text,
}

impl Kind {
    /// Tells the type from its name.
    pub fn from_name(name: &[u8]) -> Option<Self> {
        Some(match name.to_ascii_lowercase().as_slice() {
            b"bit" => Self::Bit,
            b"unsigned_char" | b"vtktypeuint8" => Self::Unsigned(1),
            b"char" | b"signed_char" | b"vtktypeint8" => Self::Signed(1),
            b"unsigned_short" | b"vtktypeuint16" => Self::Unsigned(2),
            b"short" | b"vtktypeint16" => Self::Signed(2),
            b"unsigned_int" | b"vtktypeuint32" => Self::Unsigned(4),
            // VTK writes its ids as four bytes in this format.
            b"int" | b"vtktypeint32" | b"vtkidtype" => Self::Signed(4),
            b"unsigned_long" | b"unsigned_long_long" | b"vtktypeuint64" => Self::Unsigned(8),
            b"long" | b"long_long" | b"vtktypeint64" => Self::Signed(8),
            b"float" | b"vtktypefloat32" => Self::Float(4),
            b"double" | b"vtktypefloat64" => Self::Float(8),
            b"string" | b"utf8_string" => Self::Text,
            _ => return None,
        })
    }

    /// Tells whether its numbers are integers.
    pub fn is_integer(self) -> bool {
        !matches!(self, Self::Float(_))
    }
}

/// Reads so many numbers.
pub(super) fn read(
    cursor: &mut Cursor<'_>,
    is_binary: bool,
    kind: Kind,
    count: u64,
) -> Result<Vec<f64>, Error> {
    match (kind, is_binary) {
        (Kind::Text, _) => skip_texts(cursor, is_binary, count).map(|()| Vec::new()),
        (_, true) => read_bytes(cursor, kind, count),
        (_, false) => read_text(cursor, kind, count),
    }
}

fn read_text(cursor: &mut Cursor<'_>, kind: Kind, count: u64) -> Result<Vec<f64>, Error> {
    let mut values = Vec::new();
    cursor.reserve(&mut values, 2, count);
    for _ in 0..count {
        let word = cursor.need_word("a number")?;
        let integer = || std::str::from_utf8(word).ok()?.parse::<i128>().ok();
        let value = match kind.is_integer().then(integer).flatten() {
            Some(integer) => exactly(cursor, integer)?,
            None => match scan::number(word) {
                Some(value) => value,
                None => {
                    let text = format!("{:?} is not a number", scan::show(word));
                    return Err(cursor.refuse(text));
                }
            },
        };
        values.push(value);
    }
    Ok(values)
}

fn read_bytes(cursor: &mut Cursor<'_>, kind: Kind, count: u64) -> Result<Vec<f64>, Error> {
    let width = match kind {
        Kind::Float(width) | Kind::Signed(width) | Kind::Unsigned(width) => width,
        Kind::Bit | Kind::Text => 1,
    };
    let items = if kind == Kind::Bit {
        count.div_ceil(8)
    } else {
        count
    };
    let length = usize::try_from(items.saturating_mul(width as u64)).unwrap_or(usize::MAX);
    let bytes = cursor.take(length, "an array of numbers")?;
    let count = count as usize;
    if kind == Kind::Bit {
        let bit = |i: usize| f64::from(bytes[i / 8] >> (7 - i % 8) & 1);
        return Ok((0..count).map(bit).collect());
    }
    let mut values = Vec::with_capacity(count);
    for row in bytes.chunks_exact(width) {
        cursor.poll()?;
        let bits = join(row, true);
        values.push(match kind {
            Kind::Float(4) => f32::from_bits(bits as u32).into(),
            Kind::Float(_) => f64::from_bits(bits),
            Kind::Signed(_) => exactly(cursor, signed(bits, width).into())?,
            _ => exactly(cursor, bits.into())?,
        });
    }
    Ok(values)
}

fn exactly(cursor: &Cursor<'_>, value: i128) -> Result<f64, Error> {
    exact::to_double(value)
        .ok_or_else(|| cursor.refuse(format!("{value} cannot be held exactly by a double")))
}

/// Passes over strings: a line each; in files of bytes, their length before them, in one to eight bytes of which
/// the first two bits tell the number.
fn skip_texts(cursor: &mut Cursor<'_>, is_binary: bool, count: u64) -> Result<(), Error> {
    for _ in 0..count {
        if !is_binary {
            if cursor.left() == 0 {
                return Err(cursor.refuse("truncated: the file ends among strings"));
            }
            cursor.poll()?;
            cursor.line();
            continue;
        }
        let first = cursor.bits(1, "the length of a string")?;
        let further = match first >> 6 {
            3 => 0,
            2 => 1,
            1 => 3,
            _ => 7,
        };
        let rest = cursor.take(further, "the length of a string")?;
        let length = rest
            .iter()
            .fold(first & 63, |sum, &b| sum << 8 | u64::from(b));
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        cursor.take(length, "a string")?;
    }
    Ok(())
}
