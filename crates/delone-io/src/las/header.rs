//! The header: where records are, how long, and what their integers mean.

use crate::decimal::Axis;
use crate::{Error, Place, Problem};
use std::io::{ErrorKind, Read, Seek, SeekFrom};

/// Bytes of the shortest header, that of version 1.0.
const SHORTEST: usize = 227;

/// Bytes of a header of version 1.4, which counts points in 64 bits.
const LONGEST: usize = 375;

/// Bytes of a record of each format, without those that are extra.
const RECORDS: [u16; 11] = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67];

/// What is needed of a header.
#[derive(Clone, Debug)]
pub(super) struct Header {
    /// The format of records, from 0 to 10.
    pub format: u8,
    pub is_compressed: bool,
    /// Bytes of a record, those included that are extra.
    pub record: usize,
    /// Points that the file claims to hold.
    pub points: u64,
    /// Where records begin.
    pub start: u64,
    /// x, y and z.
    pub axes: [Axis; 3],
    /// Where the records of variable length begin that stand between header and points, and how many there are.
    pub variable: (u64, u32),
}

/// Where something is read from, with its name and length.
pub(super) struct Input<'a, R> {
    pub file: &'a str,
    pub read: R,
    pub size: u64,
}

impl<R: Read + Seek> Input<'_, R> {
    /// Makes the error for a problem.
    pub fn malformed(&self, place: Place, problem: Problem) -> Error {
        Error::Malformed {
            file: self.file.to_owned(),
            place,
            problem,
        }
    }

    /// Makes the error for anything else.
    pub fn other(&self, place: Place, text: impl Into<String>) -> Error {
        self.malformed(place, Problem::Other(text.into()))
    }

    /// Makes the error for what the operating system says.
    pub fn failed(&self, source: std::io::Error) -> Error {
        Error::Io {
            action: "read",
            file: self.file.to_owned(),
            source,
        }
    }

    /// Goes to a byte.
    pub fn seek(&mut self, byte: u64) -> Result<(), Error> {
        let sought = self.read.seek(SeekFrom::Start(byte));
        sought.map(drop).map_err(|e| self.failed(e))
    }

    /// Tells where the next byte is.
    pub fn position(&mut self) -> Result<u64, Error> {
        self.read.stream_position().map_err(|e| self.failed(e))
    }

    /// Reads so many bytes as there is room for; false if the file ends before.
    pub fn fill(&mut self, bytes: &mut [u8]) -> Result<bool, Error> {
        match self.read.read_exact(bytes) {
            Ok(()) => Ok(true),
            Err(e) if e.kind() == ErrorKind::UnexpectedEof => Ok(false),
            Err(e) => Err(self.failed(e)),
        }
    }
}

impl Header {
    /// Reads the header from the beginning of a file.
    pub fn read<R: Read + Seek>(input: &mut Input<'_, R>) -> Result<Self, Error> {
        if input.size == 0 {
            return Err(input.malformed(Place::File, Problem::Empty));
        }
        let mut bytes = [0; LONGEST];
        let there = usize::try_from(input.size).map_or(LONGEST, |size| size.min(LONGEST));
        let is_full = input.fill(&mut bytes[..there])?;
        if !super::sniff(&bytes) {
            let text = "not a point cloud: the file does not begin with LASF";
            return Err(input.other(Place::Byte(0), text));
        }
        if !is_full || there < SHORTEST {
            let text = "truncated: the file ends within the header";
            return Err(input.other(Place::Byte(there as u64), text));
        }
        let fields = Fields(&bytes[..there]);
        let at = |byte, text: String| input.other(Place::Byte(byte), text);
        if fields.byte(24) != 1 {
            let (major, minor) = (fields.byte(24), fields.byte(25));
            let text = format!("version {major}.{minor}: known are 1.0 to 1.4");
            return Err(at(24, text));
        }
        let (length, start) = (u64::from(fields.short(94)), u64::from(fields.long(96)));
        if length < SHORTEST as u64 || start < length || start > input.size {
            let size = input.size;
            return Err(at(
                94,
                format!("header of {length} bytes, points at byte {start} of {size}: cannot be"),
            ));
        }
        let (format, record) = (fields.byte(104) & 0x3f, fields.short(105));
        match RECORDS.get(usize::from(format)) {
            None => return Err(at(104, format!("point format {format}: known are 0 to 10"))),
            Some(&least) if record < least => {
                let text = format!(
                    "records of {record} bytes: those of format {format} have {least} or more"
                );
                return Err(at(105, text));
            }
            Some(_) => {}
        }
        Ok(Self {
            format,
            is_compressed: fields.byte(104) & 0xc0 != 0,
            record: record.into(),
            points: fields.points(length as usize),
            start,
            axes: fields.axes().map_err(|(byte, text)| at(byte, text))?,
            variable: (length, fields.long(100)),
        })
    }

    /// Bytes of a record that no specification knows.
    pub fn extra(&self) -> u16 {
        self.record as u16 - RECORDS[usize::from(self.format)]
    }
}

/// The bytes of a header, by place.
struct Fields<'a>(&'a [u8]);

impl Fields<'_> {
    fn take<const N: usize>(&self, at: usize) -> [u8; N] {
        let mut bytes = [0; N];
        bytes.copy_from_slice(&self.0[at..at + N]);
        bytes
    }

    fn byte(&self, at: usize) -> u8 {
        self.0[at]
    }

    fn short(&self, at: usize) -> u16 {
        u16::from_le_bytes(self.take(at))
    }

    fn long(&self, at: usize) -> u32 {
        u32::from_le_bytes(self.take(at))
    }

    fn double(&self, at: usize) -> f64 {
        f64::from_le_bytes(self.take(at))
    }

    /// Counts points: in 64 bits where there are such, unless only the older field has been filled in.
    fn points(&self, length: usize) -> u64 {
        let is_long = self.byte(25) >= 4 && length >= LONGEST && self.0.len() >= LONGEST;
        let long = if is_long {
            u64::from_le_bytes(self.take(247))
        } else {
            0
        };
        if long > 0 {
            long
        } else {
            self.long(107).into()
        }
    }

    fn axes(&self) -> Result<[Axis; 3], (u64, String)> {
        let axis = |k: usize| {
            let (scale, offset) = (self.double(131 + 8 * k), self.double(155 + 8 * k));
            let name = ['x', 'y', 'z'][k];
            let place = 131 + 8 * k as u64;
            let says = |why| format!("scale {scale} and offset {offset} of {name}: {why}");
            Axis::new(scale, offset).map_err(|why| (place, says(why)))
        };
        Ok([axis(0)?, axis(1)?, axis(2)?])
    }
}
