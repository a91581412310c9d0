//! How much has to be sent, compressed, and how much may be.

use crate::failure::Failure;
use flate2::{Compression, write::GzEncoder};
use std::io::Write;
use std::path::Path;

/// A part of the page that must not grow beyond a size.
pub struct Budget {
    /// What it is called.
    pub what: &'static str,
    /// The most bytes, compressed.
    pub bytes: usize,
}

impl Budget {
    /// Prints the weight of files, and requires that it keeps to the budget.
    pub fn weigh<'f>(&self, files: impl IntoIterator<Item = &'f Path>) -> Result<(), Failure> {
        let (what, budget) = (self.what, self.bytes);
        let mut bytes = 0;
        for file in files {
            bytes += compressed(&read(file)?);
        }
        println!("gzip:      {bytes} bytes of at most {budget}: {what}");
        match bytes > budget {
            true => Err(Failure::TooLarge {
                what,
                bytes,
                budget,
            }),
            false => Ok(()),
        }
    }
}

/// Reads a file.
pub fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    std::fs::read(path).map_err(Failure::file("cannot read", path))
}

/// Counts the bytes that a server sends.
fn compressed(bytes: &[u8]) -> usize {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    written.expect("bug: memory takes every byte").len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_those_of_compressed_bytes() {
        assert!(compressed(&[0; 100_000]) < 1000);
    }

    #[test]
    fn what_is_too_large_is_named() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("a.js");
        std::fs::write(&file, "let x = 1;").expect("a file");
        let weigh = |bytes| {
            Budget {
                what: "scripts",
                bytes,
            }
            .weigh([file.as_path(), &file])
        };
        let size = compressed(b"let x = 1;");
        weigh(2 * size).expect("within the budget");
        let failure = weigh(2 * size - 1).expect_err("beyond the budget");
        assert!(failure.to_string().starts_with("scripts: "), "{failure}");
    }
}
