//! Streams taken in hand, and what the first bytes of a file betray.

use super::unreadable;
use crate::exit::Failure;
use delone_io::{Error, Format, Source};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// Bytes of a file that betray its format.
const HEAD: u64 = 4096;

/// Takes standard input, a pipe or a device into memory; a file stays where it is.
pub fn in_hand(source: Source) -> Result<Source, Failure> {
    let mut bytes = Vec::new();
    let read = match &source {
        Source::Stdin => io::stdin().lock().read_to_end(&mut bytes),
        Source::Path(path) if is_stream(path) => {
            File::open(path).and_then(|mut file| file.read_to_end(&mut bytes))
        }
        _ => return Ok(source),
    };
    let name = source.to_string();
    match read {
        Ok(_) => Ok(Source::Memory { name, bytes }),
        Err(source) => Err(unreadable(Error::Io {
            action: "read",
            file: name,
            source,
        })),
    }
}

fn is_stream(path: &Path) -> bool {
    path.metadata().is_ok_and(|m| !m.is_file() && !m.is_dir())
}

/// Returns the first bytes; none if there are none to be had, which the reader will explain.
pub fn head(source: &Source) -> Vec<u8> {
    match source {
        Source::Memory { bytes, .. } => bytes[..bytes.len().min(HEAD as usize)].to_vec(),
        Source::Path(path) if path.is_file() => {
            let mut bytes = Vec::new();
            let read = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut bytes));
            read.map_or_else(|_| Vec::new(), |_| bytes)
        }
        _ => Vec::new(),
    }
}

/// Tells the format from the content.
pub fn sniff(source: &Source) -> Option<Format> {
    let format = Format::sniff(&head(source));
    // Whether segments follow the points only the end can tell.
    match source {
        _ if format != Some(Format::Node) => format,
        Source::Memory { bytes, .. } => Format::sniff(bytes),
        Source::Path(path) => fs::read(path).map_or(format, |bytes| Format::sniff(&bytes)),
        _ => format,
    }
}

/// Tells whether the head of an array declares integers in rows of three.
pub fn holds_corners(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    let value = |key: &str, end: char| {
        let (_, rest) = text.split_once(key)?;
        rest.split_once(end).map(|(value, _)| value)
    };
    let kind = value("'descr':", ',').map(|v| v.trim_start_matches([' ', '\'', '<', '>', '|']));
    let shape = value("'shape':", ')').map(str::trim_end);
    kind.is_some_and(|k| k.starts_with(['i', 'u'])) && shape.is_some_and(|s| s.ends_with(", 3"))
}

/// Tells whether a `.poly` file declares no points, so that they are read from the `.node` file.
pub fn names_no_points(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    let mut lines = text
        .lines()
        .map(|l| l.split('#').next().unwrap_or(l).trim());
    let header = lines.find(|l| !l.is_empty());
    header.is_some_and(|l| l.split_whitespace().next() == Some("0"))
}

#[cfg(test)]
mod tests {
    use super::{holds_corners, names_no_points};

    #[test]
    fn corners_are_integers_in_rows_of_three() {
        let head = |descr, shape| {
            format!(
                "\u{93}NUMPY{{'descr': '{descr}', 'fortran_order': False, 'shape': ({shape}), }}"
            )
        };
        for (descr, shape, expected) in [
            ("<i4", "7, 3", true),
            ("|u1", "7, 3", true),
            ("<f8", "7, 3", false),
            ("<i8", "7, 2", false),
            ("<i8", "3,", false),
        ] {
            let head = head(descr, shape);
            assert_eq!(holds_corners(head.as_bytes()), expected, "{head}");
        }
    }

    #[test]
    fn a_poly_without_points_declares_zero() {
        assert!(names_no_points(b"# of k.node\n0 2 0 0\n1 0\n"));
        assert!(!names_no_points(b"3 2 0 0\n0 0 0\n"));
    }
}
