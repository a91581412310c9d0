//! `.dlog`: a log as bytes.
//!
//! ```text
//! magic     89 44 4C 4F 47 0D 0A 1A     one byte that is no text, `DLOG`, and line ends that a
//!                                       transfer as text would spoil
//! version   natural
//! algorithm, title, source   text
//! code      natural, and as many texts
//! points    natural, and as many pairs of doubles
//! steps     natural, and as many steps: line, event
//! checksum  4 bytes: CRC-32 (as in PNG) of all before, little-endian
//! ```
//!
//! A natural number has seven bits a byte, the lowest first, and the highest bit on all but the last. A
//! text is the natural number of its bytes, and these, UTF-8. A double is its eight bytes, little-endian.
//! What may be absent is a byte 0, or 1 and what is there. An event, and whatever else is one of several, is
//! the number of its name, and its fields in their order. **Names are numbered as they come**: the number
//! after the last one that is known introduces a new name, whose text follows. So the file says itself what
//! its numbers mean, and words may be added to the vocabulary anywhere.

use super::decode::{Broken, Decoder};
use super::encode::Encoder;
use super::{Recording, VERSION};
use crate::target::Output;
use crate::{Error, Place, Problem, cancel};
use delone::{Log, Point, Step, Watch};
use serde::{Deserialize, Serialize};

const MAGIC: [u8; 8] = *b"\x89DLOG\r\n\x1a";

/// Bytes of the checksum.
const CHECKSUM: usize = 4;

/// Tells whether a file begins like one of these.
pub(super) fn sniff(head: &[u8]) -> bool {
    head.starts_with(&MAGIC)
}

/// Writes a log.
pub(super) fn write(out: &mut Output<'_>, recording: &Recording) -> Result<(), Error> {
    let mut sink = Sink {
        out,
        encoder: Encoder::default(),
        checksum: crc32fast::Hasher::new(),
    };
    sink.encoder.bytes.extend(MAGIC);
    let Recording {
        title,
        source,
        code,
        log,
    } = recording;
    sink.put(&VERSION)?;
    for text in [&log.algorithm, title, source] {
        sink.put(text)?;
    }
    sink.put(&(code.len() as u64))?;
    code.iter().try_for_each(|line| sink.put(line))?;
    sink.put(&(log.points.len() as u64))?;
    log.points.iter().try_for_each(|p| sink.put(p))?;
    sink.put(&(log.steps.len() as u64))?;
    for step in &log.steps {
        sink.put(step)?;
        sink.out.end_row()?;
    }
    let checksum = sink.checksum.finalize();
    out.bytes(&checksum.to_le_bytes())
}

/// What is written goes through the checksum.
struct Sink<'s, 'o> {
    out: &'s mut Output<'o>,
    encoder: Encoder,
    checksum: crc32fast::Hasher,
}

impl Sink<'_, '_> {
    fn put(&mut self, value: &impl Serialize) -> Result<(), Error> {
        let written = value.serialize(&mut self.encoder);
        written.expect("bug: a log is made of what can be encoded");
        self.checksum.update(&self.encoder.bytes);
        self.out.bytes(&self.encoder.bytes)?;
        self.encoder.bytes.clear();
        Ok(())
    }
}

/// Reads a log.
pub(super) fn read(bytes: &[u8], file: &str, watch: &dyn Watch) -> Result<Recording, Error> {
    let mut reader = Reader {
        file,
        decoder: Decoder::new(bytes, MAGIC.len()),
        watch,
    };
    let version: u64 = reader.take("version")?;
    if version != u64::from(VERSION) {
        return Err(reader.malformed(MAGIC.len(), other_version(version)));
    }
    let recording = reader.read_body()?;
    reader.require_end(bytes)?;
    Ok(recording)
}

/// Says that a file is of another version.
pub(super) fn other_version(found: u64) -> String {
    format!("version {found} of the format; this program reads version {VERSION}")
}

struct Reader<'b> {
    file: &'b str,
    decoder: Decoder<'b>,
    watch: &'b dyn Watch,
}

impl Reader<'_> {
    fn read_body(&mut self) -> Result<Recording, Error> {
        let algorithm = self.take("algorithm")?;
        let title = self.take("title")?;
        let source = self.take("source")?;
        let code = self.take_all("line of code")?;
        let points: Vec<Point> = self.take_all("point")?;
        let steps: Vec<Step> = self.take_all("step")?;
        let log = Log {
            algorithm,
            points,
            steps,
        };
        Ok(Recording {
            title,
            source,
            code,
            log,
        })
    }

    fn take<T: for<'d> Deserialize<'d>>(&mut self, what: &str) -> Result<T, Error> {
        let start = self.decoder.at;
        let taken = T::deserialize(&mut self.decoder);
        taken.map_err(|Broken(why)| self.malformed(start, format!("{what}: {why}")))
    }

    /// Reads a number, and so many values. Room grows with what is there, not with what is declared.
    fn take_all<T: for<'d> Deserialize<'d>>(&mut self, what: &str) -> Result<Vec<T>, Error> {
        let number: u64 = self.take(&format!("number of {what}s"))?;
        let mut all = Vec::new();
        for i in 0..number {
            cancel::check(self.watch, i as usize)?;
            let start = self.decoder.at;
            let taken = T::deserialize(&mut self.decoder);
            all.push(taken.map_err(|Broken(why)| {
                let problem = format!("{what} {i} of {number}: {why}");
                self.malformed(start, problem)
            })?);
        }
        Ok(all)
    }

    /// Refuses more or less than a checksum behind the steps, and one that does not fit.
    fn require_end(&self, bytes: &[u8]) -> Result<(), Error> {
        let at = self.decoder.at;
        let (content, rest) = bytes.split_at(at);
        let Ok(stored) = <[u8; CHECKSUM]>::try_from(rest) else {
            let problem = format!("{} bytes after the last step, expected 4", rest.len());
            return Err(self.malformed(at, problem));
        };
        if u32::from_le_bytes(stored) != crc32fast::hash(content) {
            let problem = "the checksum does not fit: the file is damaged".to_owned();
            return Err(self.malformed(at, problem));
        }
        Ok(())
    }

    fn malformed(&self, byte: usize, problem: String) -> Error {
        Error::Malformed {
            file: self.file.to_owned(),
            place: Place::Byte(byte as u64),
            problem: Problem::Other(problem),
        }
    }
}
