//! Words, numbers and signs of well-known text.

use crate::{Problem, scan};
use delone::{Phase, Watch};

/// Tokens between two looks at the watch: some 100 µs of work.
const TOKENS_PER_POLL: u64 = 8192;

/// Why reading stopped early.
pub(super) enum Stop {
    Problem(Problem),
    Cancelled,
}

impl From<Problem> for Stop {
    fn from(problem: Problem) -> Self {
        Self::Problem(problem)
    }
}

/// A word, a number or a sign.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Token<'a> {
    Word(&'a [u8]),
    Number(&'a [u8]),
    Sign(u8),
    End,
}

impl Token<'_> {
    pub fn show(self) -> String {
        match self {
            Self::Word(text) | Self::Number(text) => format!("{:?}", scan::show(text)),
            Self::Sign(byte) => format!("{:?}", char::from(byte)),
            Self::End => "the end of the file".to_owned(),
        }
    }
}

/// The text, token by token.
pub(super) struct Text<'a> {
    bytes: &'a [u8],
    /// Where the last token begins.
    pub start: usize,
    /// Where the next one is looked for.
    position: usize,
    tokens: u64,
    watch: &'a dyn Watch,
}

impl<'a> Text<'a> {
    pub fn new(bytes: &'a [u8], watch: &'a dyn Watch) -> Self {
        Self {
            bytes,
            start: 0,
            position: 0,
            tokens: 0,
            watch,
        }
    }

    pub fn next(&mut self) -> Result<Token<'a>, Stop> {
        self.poll()?;
        self.skip_blanks();
        self.start = self.position;
        let rest = &self.bytes[self.start..];
        let is_in_word =
            |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'+' | b'-' | b'_');
        let length = rest.iter().take_while(|b| is_in_word(b)).count();
        self.position += length.max(1).min(rest.len());
        Ok(match rest {
            [] => Token::End,
            [first, ..] if length == 0 => Token::Sign(*first),
            [first, ..] if first.is_ascii_alphabetic() => Token::Word(&rest[..length]),
            _ => Token::Number(&rest[..length]),
        })
    }

    /// Takes the last token back.
    pub fn back(&mut self) {
        self.position = self.start;
    }

    fn skip_blanks(&mut self) {
        while let Some(byte) = self.bytes.get(self.position) {
            let rest = &self.bytes[self.position..];
            self.position += match byte {
                b'#' => memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len()),
                byte if byte.is_ascii_whitespace() => 1,
                _ => return,
            };
        }
    }

    fn poll(&mut self) -> Result<(), Stop> {
        self.tokens += 1;
        if self.tokens.is_multiple_of(TOKENS_PER_POLL) {
            if self.watch.is_cancelled() {
                return Err(Stop::Cancelled);
            }
            let (done, total) = (self.position as u64, self.bytes.len() as u64);
            self.watch.progress(Phase::Read, done, total);
        }
        Ok(())
    }
}
