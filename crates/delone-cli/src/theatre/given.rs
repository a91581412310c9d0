//! The file that the page is to open: looked at before anything is served, and lent to the page under `open/`.

use crate::exit::Failure;
use crate::files::{self, Input, unreadable};
use crate::progress::Progress;
use delone_io::{Format, LogFormat, ReadOptions, Source, read_log};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use std::path::{Path, PathBuf};

/// The folder of the address below which these files lie.
pub const FOLDER: &str = "open/";

/// What is not encoded in addresses. A comma is, for it stands between two files.
const PLAIN: &AsciiSet = &NON_ALPHANUMERIC
    .remove(b'-')
    .remove(b'.')
    .remove(b'_')
    .remove(b'~');

/// What tells logs from other JSON.
const LOG: &[u8] = b"delone-log";

/// A file that the page may fetch.
#[derive(Debug)]
pub struct Lent {
    /// Its name, without its folder.
    pub name: String,
    /// Where its content is.
    pub content: Content,
}

/// The content of such a file.
#[derive(Debug)]
pub enum Content {
    /// On disk, and read whenever it is asked for: whoever edits the file loads the page again.
    File(PathBuf),
    /// In memory: it came in a stream, which cannot be read twice.
    Bytes(Vec<u8>),
}

/// Reads the file that is named, to see that it can be read, and returns it with those beside it that it needs.
///
/// # Errors
/// If it cannot be read.
pub fn look_at(arg: &Path, progress: &Progress) -> Result<Vec<Lent>, Failure> {
    let source = files::in_hand(Source::from_arg(arg))?;
    let head = files::head(&source);
    let log = log_format(arg, &head);
    if log.is_some() {
        read_log(&source, progress).map_err(unreadable)?;
    }
    let format = Format::from_path(arg).or_else(|| files::sniff(&source));
    let paths = match log {
        Some(_) => vec![arg.to_owned()],
        None => read(
            &Input::new(source.clone(), format, ReadOptions::default()),
            progress,
        )?,
    };
    Ok(match source {
        Source::Memory { bytes, .. } => {
            let extension = log.map(LogFormat::name).or(format.map(Format::name));
            vec![streamed(extension, bytes)]
        }
        _ => paths.into_iter().map(Lent::from).collect(),
    })
}

/// Reads an input as the page will, and returns the files that this takes.
fn read(input: &Input, progress: &Progress) -> Result<Vec<PathBuf>, Failure> {
    match input.brings_triangles(progress)? {
        true => drop(input.mesh(progress)?),
        false => drop(input.domain(progress)?),
    }
    Ok(input.files())
}

/// Tells whether a file is the log of a run, and of which format.
fn log_format(path: &Path, head: &[u8]) -> Option<LogFormat> {
    match LogFormat::sniff(head) {
        Some(LogFormat::Json) => {
            let is_log = head.windows(LOG.len()).any(|window| window == LOG);
            is_log.then_some(LogFormat::Json)
        }
        Some(LogFormat::Binary) => Some(LogFormat::Binary),
        None => LogFormat::from_path(path).filter(|format| *format == LogFormat::Binary),
    }
}

/// Names what came in a stream, so that the page knows what it is.
fn streamed(extension: Option<&str>, bytes: Vec<u8>) -> Lent {
    Lent {
        name: format!("input.{}", extension.unwrap_or("txt")),
        content: Content::Bytes(bytes),
    }
}

impl From<PathBuf> for Lent {
    fn from(path: PathBuf) -> Self {
        let name = path.file_name().unwrap_or(path.as_os_str());
        Self {
            name: name.to_string_lossy().into_owned(),
            content: Content::File(path),
        }
    }
}

/// Returns what stands behind the address of the page, so that it opens these files: the one named comes first.
pub fn fragment(lent: &[Lent]) -> String {
    let address = |file: &Lent| format!("{FOLDER}{}", utf8_percent_encode(&file.name, PLAIN));
    match lent {
        [] => String::new(),
        files => {
            let addresses: Vec<String> = files.iter().map(address).collect();
            format!("#open={}", addresses.join(","))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_keep_every_name_apart() {
        let lent: Vec<Lent> = ["a b,c#ü.ele", "a.node"]
            .map(|name| Lent::from(PathBuf::from("/some/where").join(name)))
            .into();
        let expected = "#open=open/a%20b%2Cc%23%C3%BC.ele,open/a.node";
        assert_eq!(fragment(&lent), expected);
        assert_eq!(fragment(&[]), "");
    }

    #[test]
    fn logs_are_known_by_their_content() {
        let format = |name: &str, head: &[u8]| log_format(Path::new(name), head);
        let log = b"{\"format\": \"delone-log\",";
        assert_eq!(format("-", log), Some(LogFormat::Json));
        assert_eq!(format("a.json", b"{\"type\": \"Point\"}"), None);
        assert_eq!(format("a.dlog", b""), Some(LogFormat::Binary));
        assert_eq!(format("a.json", b""), None);
    }

    #[test]
    fn a_stream_has_a_name_that_tells_its_format() {
        assert_eq!(streamed(Some("poly"), Vec::new()).name, "input.poly");
        assert_eq!(streamed(None, Vec::new()).name, "input.txt");
    }
}
