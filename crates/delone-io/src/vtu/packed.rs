//! Numbers in bytes: behind a count, or in compressed blocks; as such, or in base64.
//!
//! Compressed data have the number of blocks, the size of a block and of the last one (0 if it is full), and the size
//! of each when compressed, before them. Nothing of that is believed: what is unpacked of a file is bounded by a budget.

use super::{Stop, poll};
use base64::prelude::{BASE64_STANDARD, Engine};
use delone::Watch;
use flate2::bufread::ZlibDecoder;
use std::borrow::Cow;
use std::io::Read;

/// Letters of base64 decoded between two looks at the watch; divisible by 4.
const LETTERS_PER_POLL: usize = 1 << 18;

/// Bytes that may be unpacked of any file, and times its size. Meshes are packed five to one, and constant data a thousand
/// to one; all of a file never is.
const UNPACKED_AT_LEAST: u64 = 64 << 20;
const UNPACKED_TIMES: u64 = 100;

/// How numbers in bytes are written, from the root element.
#[derive(Clone, Copy, Default)]
pub(super) struct Encoding {
    pub big_endian: bool,
    /// Whether counts of bytes take eight bytes instead of four.
    pub wide_counts: bool,
    /// Whether blocks are compressed, with zlib.
    pub compressed: bool,
}

/// How much may still be unpacked, and read of what is appended: several arrays could name the same bytes.
pub(super) struct Budget {
    unpacked: u64,
    appended: u64,
}

impl Budget {
    pub fn of_file(size: usize) -> Self {
        let size = size as u64;
        Self {
            unpacked: size.saturating_mul(UNPACKED_TIMES).max(UNPACKED_AT_LEAST),
            appended: size.saturating_mul(2),
        }
    }

    fn unpack(&mut self, bytes: u64) -> Result<(), String> {
        let left = self.unpacked.checked_sub(bytes);
        self.unpacked = left.ok_or_else(|| {
            format!(
                "{bytes} bytes when unpacked, too many for a file of this size; write without compression"
            )
        })?;
        Ok(())
    }

    fn read_appended(&mut self, bytes: u64) -> Result<(), String> {
        let left = self.appended.checked_sub(bytes);
        self.appended = left.ok_or_else(|| "shares its bytes with too many others".to_owned())?;
        Ok(())
    }
}

/// Bytes, or the letters that stand for them.
pub(super) enum Feed<'a> {
    Bytes(&'a [u8]),
    /// Letters of base64 without blanks, and what has been decoded ahead.
    Letters(Cow<'a, [u8]>, usize, Vec<u8>),
}

impl<'a> Feed<'a> {
    /// Takes letters, among which blanks mean nothing.
    pub fn letters_of_text(text: &'a [u8]) -> Self {
        let text = text.trim_ascii();
        let letters = match text.iter().any(u8::is_ascii_whitespace) {
            false => Cow::Borrowed(text),
            true => {
                let letters = text.iter().copied().filter(|b| !b.is_ascii_whitespace());
                Cow::Owned(letters.collect())
            }
        };
        Self::Letters(letters, 0, Vec::new())
    }

    /// Returns how many bytes there are at most.
    fn most(&self) -> u64 {
        let most = match self {
            Self::Bytes(bytes) => bytes.len(),
            Self::Letters(letters, at, ahead) => (letters.len() - at) / 4 * 3 + ahead.len(),
        };
        most as u64
    }

    /// Reads so many bytes, or as many as there are.
    fn read(&mut self, count: u64, watch: &dyn Watch) -> Result<Cow<'a, [u8]>, Fault> {
        let count = count.min(self.most()) as usize;
        match self {
            Self::Bytes(bytes) => {
                let (first, rest) = bytes.split_at(count);
                *bytes = rest;
                Ok(Cow::Borrowed(first))
            }
            Self::Letters(letters, at, ahead) => {
                while ahead.len() < count && *at < letters.len() {
                    poll(watch, 0).map_err(Fault::Stop)?;
                    let wanted = (count - ahead.len()).div_ceil(3) * 4;
                    let end = letters.len().min(*at + wanted.min(LETTERS_PER_POLL));
                    let piece = &letters[*at..end];
                    // Where one array has been encoded in two parts, letters go on behind the filling.
                    let filled = memchr::memchr(b'=', piece).map(|p| (p / 4 + 1) * 4);
                    let piece = &piece[..filled.unwrap_or(piece.len()).min(piece.len())];
                    BASE64_STANDARD
                        .decode_vec(piece, ahead)
                        .map_err(|e| Fault::Broken(format!("broken base64: {e}")))?;
                    *at += piece.len();
                }
                let rest = ahead.split_off(count.min(ahead.len()));
                Ok(Cow::Owned(std::mem::replace(ahead, rest)))
            }
        }
    }
}

/// Why numbers cannot be had.
pub(super) enum Fault {
    /// They are not what they should be.
    Broken(String),
    Stop(Stop),
}

impl From<String> for Fault {
    fn from(text: String) -> Self {
        Self::Broken(text)
    }
}

/// Reads the bytes of one array; `is_alone` if the feed must end behind them.
pub(super) fn unpack<'a>(
    mut feed: Feed<'a>,
    encoding: Encoding,
    is_alone: bool,
    budget: &mut Budget,
    watch: &dyn Watch,
) -> Result<Cow<'a, [u8]>, Fault> {
    if feed.most() == 0 {
        return Ok(Cow::Borrowed(&[]));
    }
    if encoding.compressed {
        return inflate(feed, encoding, budget, watch).map(Cow::Owned);
    }
    let count = counts(&mut feed, 1, encoding, watch)?[0];
    let wanted = if is_alone { u64::MAX } else { count };
    if !is_alone {
        budget.read_appended(count.min(feed.most()))?;
    }
    let data = feed.read(wanted, watch)?;
    if count == data.len() as u64 {
        return Ok(data);
    }
    let found = data.len();
    Err(format!("truncated: declares {count} bytes, has {found}").into())
}

/// Reads counts of bytes.
fn counts(
    feed: &mut Feed<'_>,
    count: u64,
    encoding: Encoding,
    watch: &dyn Watch,
) -> Result<Vec<u64>, Fault> {
    let width = if encoding.wide_counts { 8 } else { 4 };
    let wanted = count.saturating_mul(width);
    let bytes = feed.read(wanted, watch)?;
    if (bytes.len() as u64) < wanted {
        return Err("shorter than its count".to_owned().into());
    }
    let rows = bytes.chunks_exact(width as usize);
    Ok(rows
        .map(|row| crate::cursor::join(row, encoding.big_endian))
        .collect())
}

/// Reads compressed blocks.
fn inflate(
    mut feed: Feed<'_>,
    encoding: Encoding,
    budget: &mut Budget,
    watch: &dyn Watch,
) -> Result<Vec<u8>, Fault> {
    let blocks = counts(&mut feed, 1, encoding, watch)?[0];
    if blocks == 0 {
        return Ok(Vec::new());
    }
    let sizes = counts(&mut feed, 2, encoding, watch)?;
    let (full, last) = (sizes[0], if sizes[1] == 0 { sizes[0] } else { sizes[1] });
    let total = (blocks - 1).saturating_mul(full).saturating_add(last);
    budget.unpack(total)?;
    let packed = counts(&mut feed, blocks, encoding, watch)?;
    budget.read_appended(
        packed
            .iter()
            .fold(blocks, |sum, &size| sum.saturating_add(size)),
    )?;
    let mut data = Vec::new();
    for (i, &size) in packed.iter().enumerate() {
        poll(watch, 0).map_err(Fault::Stop)?;
        let block = feed.read(size, watch)?;
        if (block.len() as u64) < size {
            return Err("truncated among its compressed blocks".to_owned().into());
        }
        let expected = if i + 1 == packed.len() { last } else { full };
        let before = data.len() as u64;
        let mut unpacked = ZlibDecoder::new(&*block).take(expected.saturating_add(1));
        unpacked
            .read_to_end(&mut data)
            .map_err(|e| format!("block {i} cannot be unpacked: {e}"))?;
        let found = data.len() as u64 - before;
        if found != expected {
            let text =
                format!("block {i} is declared as {expected} bytes, but it is another number");
            return Err(text.into());
        }
    }
    Ok(data)
}
