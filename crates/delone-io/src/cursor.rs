//! Words of a text and numbers in bytes, in turn: for formats in which the two alternate.
//!
//! Nothing is copied, and nothing that a file says about its size is believed: whoever asks for more than
//! there is gets an error with line or byte.

use crate::{Error, Place, Problem, scan};
use delone::{Phase, Watch};

/// Words or numbers between two looks at the watch: some 100 µs of work.
const ITEMS_PER_POLL: usize = 4096;

/// Walks over a file.
pub(crate) struct Cursor<'a> {
    /// Name of the file, for messages.
    file: &'a str,
    bytes: &'a [u8],
    at: usize,
    /// Where the item read last begins.
    mark: usize,
    /// Items read since the last look at the watch.
    items: usize,
    watch: &'a dyn Watch,
    /// Whether places are told in bytes, for there are no lines.
    pub in_bytes: bool,
    /// Whether numbers in bytes begin with the highest.
    pub big_endian: bool,
}

impl<'a> Cursor<'a> {
    pub fn new(file: &'a str, bytes: &'a [u8], watch: &'a dyn Watch) -> Self {
        Self {
            file,
            bytes,
            at: bytes.len() - scan::without_mark(bytes).len(),
            mark: 0,
            items: 0,
            watch,
            in_bytes: false,
            big_endian: false,
        }
    }

    /// Returns the watch.
    pub fn watch(&self) -> &'a dyn Watch {
        self.watch
    }

    /// Returns how many bytes are left.
    pub fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    /// Reserves room for items still to come: as many as are declared, but no more than the bytes left can
    /// hold.
    pub fn reserve<T>(&self, items: &mut Vec<T>, bytes_per_item: usize, declared: u64) {
        let possible = self.left() / bytes_per_item + 1;
        let declared = usize::try_from(declared).unwrap_or(usize::MAX);
        drop(items.try_reserve(possible.min(declared)));
    }

    /// Looks at the watch, in one of many calls.
    pub fn poll(&mut self) -> Result<(), Error> {
        self.items += 1;
        if self.items.is_multiple_of(ITEMS_PER_POLL) {
            if self.watch.is_cancelled() {
                return Err(Error::Cancelled);
            }
            let (done, total) = (self.at as u64, self.bytes.len() as u64);
            self.watch.progress(Phase::Read, done, total);
        }
        Ok(())
    }

    /// Returns the next word; `None` at the end.
    pub fn word(&mut self) -> Result<Option<&'a [u8]>, Error> {
        self.poll()?;
        let rest = &self.bytes[self.at..];
        let blanks = rest.iter().take_while(|b| b.is_ascii_whitespace()).count();
        let rest = &rest[blanks..];
        let length = rest.iter().position(u8::is_ascii_whitespace);
        let word = &rest[..length.unwrap_or(rest.len())];
        self.mark = self.at + blanks;
        self.at = self.mark + word.len();
        Ok((!word.is_empty()).then_some(word))
    }

    /// Returns the next line that is not blank, without going on to the one behind it; `None` at the end.
    pub fn peek_line(&mut self) -> Result<Option<&'a [u8]>, Error> {
        let line = self.full_line()?;
        self.at = self.mark;
        Ok(line)
    }

    /// Returns the next line that is not blank; `None` at the end.
    pub fn full_line(&mut self) -> Result<Option<&'a [u8]>, Error> {
        while self.left() > 0 {
            self.poll()?;
            let line = self.line();
            if !line.is_empty() {
                return Ok(Some(line));
            }
        }
        Ok(None)
    }

    /// Returns the next word, which must be there.
    pub fn need_word(&mut self, what: &'static str) -> Result<&'a [u8], Error> {
        match self.word()? {
            Some(word) => Ok(word),
            None => Err(self.ends_before(what)),
        }
    }

    /// Returns the rest of the line, and goes to the beginning of the next.
    pub fn line(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let end = memchr::memchr(b'\n', rest).unwrap_or(rest.len());
        self.mark = self.at;
        self.at += (end + 1).min(rest.len());
        rest[..end].trim_ascii()
    }

    /// Returns the next bytes.
    pub fn take(&mut self, length: usize, what: &'static str) -> Result<&'a [u8], Error> {
        self.poll()?;
        self.mark = self.at;
        let rest = &self.bytes[self.at..];
        let Some(bytes) = rest.get(..length) else {
            return Err(self.ends_before(what));
        };
        self.at += length;
        Ok(bytes)
    }

    /// Goes behind the next place where `text` stands; tells whether there is one.
    pub fn seek_behind(&mut self, text: &[u8]) -> bool {
        let found = memchr::memmem::find(&self.bytes[self.at..], text);
        match found {
            Some(place) => self.at += place + text.len(),
            None => self.at = self.bytes.len(),
        }
        found.is_some()
    }

    /// Reads an integer from text.
    pub fn text_integer(&mut self, what: &'static str) -> Result<i64, Error> {
        let word = self.need_word(what)?;
        scan::integer(word).ok_or_else(|| self.no_number(what, word))
    }

    /// Reads a count from text.
    pub fn text_count(&mut self, what: &'static str) -> Result<u64, Error> {
        let count = self.text_integer(what)?;
        u64::try_from(count).map_err(|_| self.negative(what, count))
    }

    /// Reads a number from text.
    pub fn text_number(&mut self, what: &'static str) -> Result<f64, Error> {
        let word = self.need_word(what)?;
        scan::number(word).ok_or_else(|| self.no_number(what, word))
    }

    /// Reads an unsigned integer of so many bytes, at most eight.
    pub fn bits(&mut self, width: usize, what: &'static str) -> Result<u64, Error> {
        let bytes = self.take(width, what)?;
        Ok(join(bytes, self.big_endian))
    }

    /// Makes the error of a negative count.
    pub fn negative(&self, what: &str, count: i64) -> Error {
        self.fail(Problem::Other(format!(
            "{count} {what}: a count cannot be negative"
        )))
    }

    fn no_number(&self, what: &str, word: &[u8]) -> Error {
        let (what, text) = (what.to_owned(), scan::show(word));
        self.fail(Problem::NotANumber { what, text })
    }

    /// Makes the error of a file that ends too early.
    fn ends_before(&self, what: &str) -> Error {
        let text = format!("truncated: the file ends where {what} should be");
        self.fail(Problem::Other(text))
    }

    /// Makes the error for a problem with the item read last.
    pub fn fail(&self, problem: Problem) -> Error {
        let place = match self.in_bytes {
            true => Place::Byte(self.mark as u64),
            false => {
                let before = &self.bytes[..self.mark.min(self.bytes.len())];
                Place::Line(memchr::memchr_iter(b'\n', before).count() as u64 + 1)
            }
        };
        self.fail_at(place, problem)
    }

    /// Makes the error for a problem of the whole file.
    pub fn fail_whole(&self, problem: Problem) -> Error {
        self.fail_at(Place::File, problem)
    }

    /// As [`fail`](Self::fail), in words.
    pub fn refuse(&self, text: impl Into<String>) -> Error {
        self.fail(Problem::Other(text.into()))
    }

    fn fail_at(&self, place: Place, problem: Problem) -> Error {
        let file = self.file.to_owned();
        Error::Malformed {
            file,
            place,
            problem,
        }
    }
}

/// Joins up to eight bytes.
pub(crate) fn join(bytes: &[u8], big_endian: bool) -> u64 {
    let join = |sum: u64, &b: &u8| sum << 8 | u64::from(b);
    if big_endian {
        bytes.iter().fold(0, join)
    } else {
        bytes.iter().rev().fold(0, join)
    }
}

/// Carries the sign of a number of `width` bytes to the top.
pub(crate) fn signed(bits: u64, width: usize) -> i64 {
    let unused = 64 - 8 * width as u32;
    ((bits << unused) as i64) >> unused
}

#[cfg(test)]
mod tests {
    use super::{join, signed};

    #[test]
    fn numbers_of_every_width_have_their_sign() {
        for (bytes, expected) in [
            (&[0x7f][..], 127),
            (&[0xff], -1),
            (&[0x80, 0x01], -32_767),
            (&[0x7f, 0xff, 0xff, 0xff], i32::MAX.into()),
            (&[0xff, 0xff, 0xff, 0xfe], -2),
            (&[0x80, 0, 0, 0, 0, 0, 0, 0], i64::MIN),
        ] {
            assert_eq!(signed(join(bytes, true), bytes.len()), expected);
            let little: Vec<u8> = bytes.iter().rev().copied().collect();
            assert_eq!(signed(join(&little, false), bytes.len()), expected);
        }
    }
}
