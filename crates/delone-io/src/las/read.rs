//! Reading, a block after the other.

use super::cloud::Cloud;
use super::header::{Header, Input};
use super::laz;
use crate::{Error, Format, PointSet, ReadOptions, Source, foreign};
use delone::Watch;
use std::fs::File;
use std::io::{BufReader, Cursor, Read, Seek};
use std::path::Path;

/// Bytes of records that are taken at once.
const BLOCK: usize = 1 << 18;

/// Tells whether a source is a point cloud, without loading it: by the format asked for, by name, and where these
/// say nothing, by the beginning of the file.
pub(crate) fn is_one(source: &Source, options: &ReadOptions) -> bool {
    let by_name = || source.path().and_then(Format::from_path);
    match (options.format.or_else(by_name), source) {
        (Some(format), _) => format == Format::Las,
        (None, Source::Path(path)) => begins_like_one(path),
        (None, _) => false,
    }
}

fn begins_like_one(path: &Path) -> bool {
    let mut head = [0; 4];
    path.is_file()
        && File::open(path).is_ok_and(|mut file| file.read_exact(&mut head).is_ok())
        && super::sniff(&head)
}

/// Reads points; a file in blocks, all else from memory.
pub(crate) fn read_points(
    source: &Source,
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    let name = source.to_string();
    let Source::Path(path) = source else {
        return read_loaded(&name, &source.load(watch)?, options, watch);
    };
    if !path.is_file() {
        return read_loaded(&name, &source.load(watch)?, options, watch);
    }
    let opened = File::open(path).and_then(|file| Ok((file.metadata()?.len(), file)));
    let (size, file) = opened.map_err(|source| Error::Io {
        action: "read",
        file: name.clone(),
        source,
    })?;
    let input = Input {
        file: &name,
        read: BufReader::with_capacity(BLOCK, file),
        size,
    };
    read(input, options, watch)
}

/// Reads points from the content of a file.
pub(crate) fn read_loaded(
    file: &str,
    bytes: &[u8],
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    let input = Input {
        file,
        read: Cursor::new(bytes),
        size: bytes.len() as u64,
    };
    read(input, options, watch)
}

fn read<R: Read + Seek + Send + Sync>(
    mut input: Input<'_, R>,
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    let header = Header::read(&mut input)?;
    let bytes = input.size - header.start;
    // A compressed point takes a few bytes, and hardly ever less than one.
    let most = match header.is_compressed {
        true => bytes,
        false => bytes / header.record as u64,
    };
    let mut cloud = Cloud::new(input.file, &header, most, options, watch)?;
    if header.is_compressed {
        let file = input.file;
        foreign::call(file, "LAZ", || {
            laz::read(&mut input, &header, &mut cloud, block(header.record))
        })?;
    } else {
        read_plain(&mut input, &header, &mut cloud, most)?;
    }
    cloud.finish()
}

/// Returns how many records are taken at once.
fn block(record: usize) -> usize {
    (BLOCK / record).max(1)
}

/// Reads records as they are.
fn read_plain<R: Read + Seek>(
    input: &mut Input<'_, R>,
    header: &Header,
    cloud: &mut Cloud<'_>,
    most: u64,
) -> Result<(), Error> {
    if header.points > most {
        // Found are those that could be read.
        cloud.seen = most;
        return Err(cloud.truncated());
    }
    input.seek(header.start)?;
    let mut buffer = vec![0; block(header.record) * header.record];
    while cloud.seen < header.points {
        let left = (header.points - cloud.seen).min(block(header.record) as u64) as usize;
        let records = &mut buffer[..left * header.record];
        if !input.fill(records)? {
            return Err(cloud.truncated());
        }
        cloud.take(records)?;
    }
    Ok(())
}
