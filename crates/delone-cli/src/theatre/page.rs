//! The page as it lies in the program: its files, compressed, and what is said of them when they are sent.

use flate2::read::GzDecoder;
use std::io::Read;

/// The page; without files if the program was built before there was one.
///
/// `build.rs` writes the table.
pub const PAGE: &[Asset] = include!(concat!(env!("OUT_DIR"), "/page.rs"));

/// A file of the page.
pub struct Asset {
    /// Where it lies, from the root of the page.
    pub path: &'static str,
    /// Its content, compressed.
    pub gzip: &'static [u8],
}

/// Content types by extension.
const KINDS: [(&str, &str); 18] = [
    ("html", "text/html; charset=utf-8"),
    ("js", "text/javascript; charset=utf-8"),
    ("mjs", "text/javascript; charset=utf-8"),
    ("css", "text/css; charset=utf-8"),
    ("wasm", "application/wasm"),
    ("json", "application/json"),
    ("map", "application/json"),
    ("webmanifest", "application/manifest+json"),
    ("txt", "text/plain; charset=utf-8"),
    ("svg", "image/svg+xml"),
    ("png", "image/png"),
    ("jpg", "image/jpeg"),
    ("webp", "image/webp"),
    ("gif", "image/gif"),
    ("ico", "image/x-icon"),
    ("woff2", "font/woff2"),
    ("webm", "video/webm"),
    ("mp4", "video/mp4"),
];

/// Digits of the hash that the bundler puts behind names.
const HASH: usize = 8;

impl Asset {
    /// Returns its content type.
    pub fn kind(&self) -> &'static str {
        let extension = self.path.rsplit_once('.').map(|(_, extension)| extension);
        let known = KINDS.iter().find(|(name, _)| extension == Some(name));
        known.map_or("application/octet-stream", |(_, kind)| kind)
    }

    /// Tells whether its name holds a hash of its content, so that it never changes under this name.
    pub fn is_hashed(&self) -> bool {
        let Some(name) = self.path.strip_prefix("assets/") else {
            return false;
        };
        let stem = name.split_once('.').map_or(name, |(stem, _)| stem);
        let is_digit = |c: u8| c.is_ascii_alphanumeric() || c == b'_' || c == b'-';
        let hash = stem
            .len()
            .checked_sub(HASH + 1)
            .map(|at| &stem.as_bytes()[at..]);
        hash.is_some_and(|hash| hash[0] == b'-' && hash[1..].iter().copied().all(is_digit))
    }

    /// Returns the content as it was.
    pub fn plain(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        let read = GzDecoder::new(self.gzip).read_to_end(&mut bytes);
        read.expect("bug: the page was compressed by the build");
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(path: &'static str) -> Asset {
        Asset { path, gzip: &[] }
    }

    #[test]
    fn types_are_what_browsers_insist_on() {
        for (path, kind) in [
            ("index.html", "text/html; charset=utf-8"),
            ("assets/index-B7s_x-9k.js", "text/javascript; charset=utf-8"),
            ("assets/delone_bg-DEADbeef.wasm", "application/wasm"),
            ("assets/index-B7s_x-9k.css", "text/css; charset=utf-8"),
            ("LICENSE", "application/octet-stream"),
            ("a.b/c", "application/octet-stream"),
        ] {
            assert_eq!(named(path).kind(), kind, "{path}");
        }
    }

    #[test]
    fn only_names_with_a_hash_never_change() {
        for (path, expected) in [
            ("assets/index-B7s_x-9k.js", true),
            ("assets/delone_bg-DEADbeef.wasm", true),
            ("assets/index.js", false),
            ("assets/plain-name.js", false),
            ("assets/ü-short.js", false),
            ("assets/xéabcdefgh.js", false),
            ("index-B7s_x-9k.js", false),
            ("index.html", false),
        ] {
            assert_eq!(named(path).is_hashed(), expected, "{path}");
        }
    }

    #[test]
    fn every_file_of_the_page_is_whole() {
        for asset in PAGE {
            asset.plain();
        }
        let has_start = PAGE.iter().any(|asset| asset.path == "index.html");
        assert_eq!(has_start, cfg!(has_page));
    }
}
