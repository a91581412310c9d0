//! SHA-256 of files, as they are read and as they are written.

use super::FileFact;
use crate::{Error, Source};
use delone::Watch;
use sha2::{Digest, Sha256};
use std::io::{self, Write};
use std::path::Path;

/// Hashes a file. *Cost*: some 2 to 5 ns a byte.
///
/// # Errors
/// If it cannot be read, or the watch cancels.
pub fn digest_file(path: &Path, watch: &dyn Watch) -> Result<FileFact, Error> {
    let source = Source::Path(path.to_owned());
    let bytes = source.load(watch)?;
    let mut hash = Sha256::new();
    for chunk in bytes.chunks(1 << 20) {
        if watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        hash.update(chunk);
    }
    Ok(FileFact {
        name: file_name(path),
        sha256: hex(&hash.finalize()),
    })
}

/// Returns the name of a file without its folder.
pub(super) fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

/// Writes bytes as hexadecimal digits.
pub(crate) fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A sink that hashes what goes through.
pub(crate) struct Hashing<'a> {
    sink: &'a mut dyn Write,
    hash: Sha256,
}

impl<'a> Hashing<'a> {
    /// Begins with nothing.
    pub fn new(sink: &'a mut dyn Write) -> Self {
        Self {
            sink,
            hash: Sha256::new(),
        }
    }

    /// Names the file with the hash of all that went through.
    pub fn finish(self, file: &str) -> FileFact {
        FileFact {
            name: file_name(Path::new(file)),
            sha256: hex(&self.hash.finalize()),
        }
    }
}

impl Write for Hashing<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.sink.write(bytes)?;
        self.hash.update(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.flush()
    }
}
