//! Compressed records: chunks that stand behind each other.
//!
//! Records of formats 0 to 5 are coded one after the other (*pointwise*): where a chunk ends is known by
//! decoding it, and by the table of chunks, and the two must agree, as no checksum tells a broken chunk. Records
//! of formats 6 to 10 are coded field by field (*layered*): each chunk begins with its number of points and the
//! lengths of its layers, so that no table is needed; fields that are not wanted are skipped.
//!
//! What the decoder would trust is checked before: the list of what is compressed, the number of chunks, and the
//! lengths of layers.

use super::cloud::Cloud;
use super::header::{Header, Input};
use crate::{Error, Place};
use laz::DecompressionSelection;
use laz::laszip::ChunkTable;
use laz::record::{
    LayeredPointRecordDecompressor, RecordDecompressor, SequentialPointRecordDecompressor,
};
use laz::{LazItem, LazItemRecordBuilder, LazItemType, LazVlr};
use std::io::{Cursor, ErrorKind, Read, Seek};

/// Most bytes that a record may have beyond its format: the decoder keeps some kilobytes for each.
const MAX_EXTRA: u16 = 2048;

/// Bytes of what stands before a record of variable length.
const RECORD_HEADER: usize = 54;

/// How the records are compressed.
struct Coding {
    items: Vec<LazItem>,
    layered: bool,
    /// Points of a chunk; `None` if chunks differ.
    chunk: Option<u64>,
    /// Whether there are chunks, and a table of them.
    has_table: bool,
}

/// Reads all records, in blocks of so many.
pub(super) fn read<R: Read + Seek + Send + Sync>(
    input: &mut Input<'_, R>,
    header: &Header,
    cloud: &mut Cloud<'_>,
    block: usize,
) -> Result<(), Error> {
    let coding = Coding::read(input, header)?;
    let mut buffer = vec![0; block * header.record];
    if coding.layered {
        read_layered(input, header, &coding, cloud, &mut buffer)
    } else {
        read_pointwise(input, header, &coding, cloud, &mut buffer)
    }
}

impl Coding {
    /// Finds and checks the record that tells.
    fn read<R: Read + Seek>(input: &mut Input<'_, R>, header: &Header) -> Result<Self, Error> {
        let (at, bytes) = find(input, header)?;
        let bad = |what: &str| {
            let text = format!("the record of LASzip is broken: {what}");
            input.other(Place::Byte(at), text)
        };
        let vlr = LazVlr::from_buffer(&bytes).map_err(|e| bad(&e.to_string()))?;
        let extra = header.extra();
        if extra > MAX_EXTRA {
            let text = format!("{extra} extra bytes a point; at most {MAX_EXTRA} are possible");
            return Err(input.other(Place::Byte(105), text));
        }
        let expected = LazItemRecordBuilder::default_for_point_format_id(header.format, extra);
        let expected = expected.map_err(|e| bad(&e.to_string()))?;
        let kinds = |items: &[LazItem]| -> Vec<(LazItemType, u16)> {
            items.iter().map(|i| (i.item_type(), i.size())).collect()
        };
        let version = vlr.items().first().map_or(0, LazItem::version);
        let layered = header.format >= 6;
        let versions = if layered { 3..=4 } else { 1..=2 };
        let is_even = vlr.items().iter().all(|i| versions.contains(&i.version()));
        if kinds(vlr.items()) != kinds(&expected) || !is_even {
            return Err(bad("its fields are not those of the points"));
        }
        let compressor = u16::from_le_bytes([bytes[0], bytes[1]]);
        if !matches!((compressor, layered), (1 | 2, false) | (3, true)) {
            let text =
                format!("compressor {compressor}, version {version}, does not go with the points");
            return Err(bad(&text));
        }
        Ok(Self {
            layered,
            chunk: (!vlr.uses_variable_size_chunks()).then(|| vlr.chunk_size().into()),
            has_table: compressor == 2,
            items: vlr.items().clone(),
        })
    }

    /// Counts the layers of a chunk.
    fn layers(&self) -> usize {
        let of = |item: &LazItem| match item.item_type() {
            LazItemType::Point14 => 9,
            LazItemType::RGBNIR14 => 2,
            LazItemType::Byte14(count) => count.into(),
            _ => 1,
        };
        self.items.iter().map(of).sum()
    }
}

/// Returns the record of variable length that LASzip writes, and where it is.
fn find<R: Read + Seek>(
    input: &mut Input<'_, R>,
    header: &Header,
) -> Result<(u64, Vec<u8>), Error> {
    let (mut at, records) = header.variable;
    for _ in 0..records {
        let mut head = [0; RECORD_HEADER];
        input.seek(at)?;
        if at + RECORD_HEADER as u64 > header.start || !input.fill(&mut head)? {
            break;
        }
        let length = u16::from_le_bytes([head[20], head[21]]);
        let is_it = head[2..].starts_with(LazVlr::USER_ID.as_bytes())
            && u16::from_le_bytes([head[18], head[19]]) == LazVlr::RECORD_ID;
        at += RECORD_HEADER as u64;
        if is_it {
            let mut bytes = vec![0; length.into()];
            if input.fill(&mut bytes)? && bytes.len() >= 2 {
                return Ok((at, bytes));
            }
            break;
        }
        at += u64::from(length);
    }
    let text = "compressed, but without the record that tells how; was it renamed or cut off?";
    Err(input.other(Place::Byte(header.variable.0), text))
}

/// Fails as a decoder did.
fn failed<R: Read + Seek>(
    input: &Input<'_, R>,
    cloud: &Cloud<'_>,
    source: std::io::Error,
) -> Error {
    match source.kind() {
        ErrorKind::UnexpectedEof => cloud.truncated(),
        _ => input.failed(source),
    }
}

fn broken<R: Read + Seek>(input: &Input<'_, R>, at: u64, chunk: usize, why: &str) -> Error {
    let text = format!("chunk {chunk} (from 0) is broken: {why}; get the file once more");
    input.other(Place::Byte(at), text)
}

/// Decodes the points of one chunk and hands them over in blocks.
fn decode<D>(
    decoder: &mut impl RecordDecompressor<D>,
    points: u64,
    record: usize,
    cloud: &mut Cloud<'_>,
    buffer: &mut [u8],
) -> Result<Result<(), std::io::Error>, Error> {
    let mut left = points;
    while left > 0 {
        let now = left.min((buffer.len() / record) as u64);
        let records = &mut buffer[..now as usize * record];
        for (i, one) in records.chunks_exact_mut(record).enumerate() {
            if let Err(error) = decoder.decompress_next(one) {
                cloud.take(&records[..i * record])?;
                return Ok(Err(error));
            }
        }
        cloud.take(records)?;
        left -= now;
    }
    Ok(Ok(()))
}

fn read_pointwise<R: Read + Seek + Send + Sync>(
    input: &mut Input<'_, R>,
    header: &Header,
    coding: &Coding,
    cloud: &mut Cloud<'_>,
    buffer: &mut [u8],
) -> Result<(), Error> {
    let table = match coding.has_table {
        true => read_table(input, header, coding)?,
        false => None,
    };
    if table.is_none() && coding.has_table && coding.chunk.is_none() {
        let text = "the table of chunks is missing or broken; get the file once more";
        return Err(input.other(Place::Byte(header.start), text));
    }
    input.seek(header.start + if coding.has_table { 8 } else { 0 })?;
    let entries = table.as_ref().map(AsRef::as_ref);
    for chunk in 0.. {
        let left = header.points - cloud.seen;
        if left == 0 {
            break;
        }
        let at = input.position()?;
        let entry = match entries {
            Some(entries) => {
                let entry: Option<&laz::laszip::ChunkTableEntry> = entries.get(chunk);
                Some(*entry.ok_or_else(|| cloud.truncated())?)
            }
            None => None,
        };
        let points = match (entry, coding.chunk) {
            (_, Some(points)) if coding.has_table => points.min(left),
            (Some(entry), None) => entry.point_count,
            _ => left,
        };
        if points == 0 || points > left {
            let why = format!("it claims {points} points, and {left} are left");
            return Err(broken(input, at, chunk, &why));
        }
        let mut decoder = SequentialPointRecordDecompressor::new(&mut input.read);
        let set = decoder.set_fields_from(&coding.items);
        let decoded = match set {
            Ok(()) => decode(&mut decoder, points, header.record, cloud, buffer)?,
            Err(error) => Err(std::io::Error::other(error.to_string())),
        };
        drop(decoder);
        decoded.map_err(|e| failed(input, cloud, e))?;
        let end = input.position()?;
        if entry.is_some_and(|entry| at.checked_add(entry.byte_count) != Some(end)) {
            return Err(broken(
                input,
                at,
                chunk,
                "its points do not end where it ends",
            ));
        }
    }
    Ok(())
}

/// Reads the table of chunks; `None` if there is none, as in a file that was not finished.
fn read_table<R: Read + Seek>(
    input: &mut Input<'_, R>,
    header: &Header,
    coding: &Coding,
) -> Result<Option<ChunkTable>, Error> {
    let first = header.start + 8;
    let place = |input: &mut Input<'_, R>, at: u64| {
        let mut bytes = [0; 8];
        input.seek(at)?;
        let there = input.fill(&mut bytes)?.then(|| u64::from_le_bytes(bytes));
        Ok::<_, Error>(there.filter(|&at| at >= first && at.saturating_add(8) <= input.size))
    };
    // Who could not go back to the beginning wrote it at the very end.
    let start = match place(input, header.start)? {
        Some(start) => Some(start),
        None => place(input, input.size.saturating_sub(8))?,
    };
    let Some(start) = start else {
        return Ok(None);
    };
    let mut head = [0; 8];
    input.seek(start)?;
    input.fill(&mut head)?;
    let chunks = u32::from_le_bytes([head[4], head[5], head[6], head[7]]);
    // Each begins with a point as it is.
    if u64::from(chunks) * header.record as u64 > start - first {
        let text = format!("the table of chunks is broken: {chunks} do not fit into the file");
        return Err(input.other(Place::Byte(start), text));
    }
    input.seek(start)?;
    let read = ChunkTable::read(&mut input.read, coding.chunk.is_none());
    match read {
        Ok(table) => Ok(Some(table)),
        Err(error) if error.kind() == ErrorKind::UnexpectedEof => Ok(None),
        Err(error) => Err(input.failed(error)),
    }
}

fn read_layered<R: Read + Seek + Send + Sync>(
    input: &mut Input<'_, R>,
    header: &Header,
    coding: &Coding,
    cloud: &mut Cloud<'_>,
    buffer: &mut [u8],
) -> Result<(), Error> {
    let wanted = DecompressionSelection::base()
        .decompress_z()
        .decompress_classification()
        .decompress_flags()
        .decompress_intensity();
    // A point as it is, the number of points, and the length of each layer.
    let mut head = vec![0; header.record + 4 + 4 * coding.layers()];
    let mut bytes = Vec::new();
    input.seek(header.start + 8)?;
    for chunk in 0.. {
        let left = header.points - cloud.seen;
        if left == 0 {
            break;
        }
        let at = input.position()?;
        if !input.fill(&mut head)? {
            return Err(cloud.truncated());
        }
        let mut numbers = head[header.record..]
            .chunks_exact(4)
            .map(|n| u64::from(u32::from_le_bytes([n[0], n[1], n[2], n[3]])));
        let points = numbers.next().unwrap_or(0);
        let length: u64 = numbers.sum();
        if points == 0 || points > left || coding.chunk.is_some_and(|most| points > most) {
            let why = format!("it claims {points} points, and {left} are left");
            return Err(broken(input, at, chunk, &why));
        }
        if length > input.size - at - head.len() as u64 {
            return Err(cloud.truncated());
        }
        bytes.clear();
        bytes.extend_from_slice(&head);
        bytes.resize(head.len() + length as usize, 0);
        if !input.fill(&mut bytes[head.len()..])? {
            return Err(cloud.truncated());
        }
        let mut decoder = LayeredPointRecordDecompressor::new(Cursor::new(&bytes[..]));
        let set = decoder.set_fields_from(&coding.items);
        set.map_err(|error| input.other(Place::File, error.to_string()))?;
        decoder.set_selection(wanted);
        decode(&mut decoder, points, header.record, cloud, buffer)?.map_err(|error| match error
            .kind()
        {
            ErrorKind::UnexpectedEof => broken(input, at, chunk, "its layers end too early"),
            _ => input.failed(error),
        })?;
    }
    Ok(())
}
