//! What is answered to a request: the page, the files that it was given, or a refusal. No socket in sight.
//!
//! Paths are looked up among the names that there are, and never touch the disk: so none leads out. Whoever asks
//! must call this machine by its own name, with the port: a page from elsewhere whose name has been made to mean
//! this machine (DNS rebinding) calls it by that name. Scripts come from here alone, and nothing here may be
//! framed, or fetched by other pages.

use super::given::{self, Content, Lent};
use super::page::Asset;
use percent_encoding::percent_decode_str;
use std::borrow::Cow;
use std::fs::File;
use std::path::Path;

/// What the page may load, and from where.
const POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; \
    img-src 'self' blob: data:; media-src 'self' blob:; worker-src 'self'; connect-src 'self'; \
    manifest-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Said with every answer.
const ALWAYS: [Field; 5] = [
    ("Content-Security-Policy", POLICY),
    ("X-Content-Type-Options", "nosniff"),
    ("Referrer-Policy", "no-referrer"),
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
];

/// The port that addresses need not name.
const USUAL_PORT: u16 = 80;

/// A line of the head of an answer.
pub type Field = (&'static str, &'static str);

/// A request, as far as it matters.
pub struct Asked<'r> {
    /// Whether it only wants to read: GET or HEAD.
    pub is_read: bool,
    /// What it asks for: path and query, as they came.
    pub target: &'r str,
    /// Whom it calls: its `Host` lines, of which there must be one.
    pub hosts: Vec<&'r str>,
    /// Whether it takes compressed content.
    pub takes_gzip: bool,
}

/// An answer.
pub struct Answer<'h> {
    /// Its status.
    pub status: u16,
    /// The lines of its head.
    pub head: Vec<Field>,
    /// Its content.
    pub body: Body<'h>,
}

/// The content of an answer.
pub enum Body<'h> {
    /// In memory.
    Bytes(Cow<'h, [u8]>),
    /// On disk: the file, and how many bytes of it.
    File(File, u64),
}

/// All that is served.
pub struct House {
    /// The page.
    pub page: &'static [Asset],
    /// What the page is to open.
    pub lent: Vec<Lent>,
    /// Where this listens.
    pub port: u16,
}

impl House {
    /// Answers a request.
    pub fn answer(&self, asked: &Asked<'_>) -> Answer<'_> {
        if !self.is_called(&asked.hosts) {
            return refusal(403, "this machine is not called that");
        }
        if !asked.is_read {
            let mut answer = refusal(405, "only GET and HEAD are understood");
            answer.head.push(("Allow", "GET, HEAD"));
            return answer;
        }
        let Some(path) = path(asked.target) else {
            return refusal(400, "this is no path");
        };
        match path.strip_prefix(given::FOLDER) {
            Some(name) => self.lent(name),
            None => self.part(&path, asked.takes_gzip),
        }
    }

    /// Tells whether a request calls this machine, and nobody else, by its own name.
    fn is_called(&self, hosts: &[&str]) -> bool {
        let [host] = hosts else {
            return false;
        };
        let (name, port) = match host.rsplit_once(':') {
            Some((name, port)) => (name, port.parse().ok()),
            None => (*host, Some(USUAL_PORT)),
        };
        let is_loopback = name == "127.0.0.1" || name.eq_ignore_ascii_case("localhost");
        is_loopback && port == Some(self.port)
    }

    /// Returns a part of the page.
    fn part(&self, path: &str, takes_gzip: bool) -> Answer<'_> {
        let is_folder = path.is_empty() || path.ends_with('/');
        let start = if is_folder { "index.html" } else { "" };
        let is_meant = |asset: &&Asset| asset.path.strip_prefix(path) == Some(start);
        let Some(asset) = self.page.iter().find(is_meant) else {
            return refusal(404, "there is nothing of this name");
        };
        let cache = match asset.is_hashed() {
            true => "public, max-age=31536000, immutable",
            false => "no-cache",
        };
        let body = match takes_gzip {
            true => Cow::Borrowed(asset.gzip),
            false => Cow::Owned(asset.plain()),
        };
        let mut answer = answer(200, asset.kind(), cache, Body::Bytes(body));
        answer.head.push(("Vary", "Accept-Encoding"));
        if takes_gzip {
            answer.head.push(("Content-Encoding", "gzip"));
        }
        answer
    }

    /// Returns a file that the page is to open.
    ///
    /// Whatever it holds, a browser shall take it for nothing but bytes.
    fn lent(&self, name: &str) -> Answer<'_> {
        let Some(file) = self.lent.iter().find(|file| file.name == name) else {
            return refusal(404, "there is nothing of this name");
        };
        let body = match &file.content {
            Content::Bytes(bytes) => Ok(Body::Bytes(bytes.into())),
            Content::File(path) => opened(path),
        };
        match body {
            Ok(body) => answer(200, "application/octet-stream", "no-cache", body),
            Err(_) => refusal(404, "this file has gone since the program started"),
        }
    }
}

fn opened<'h>(path: &Path) -> std::io::Result<Body<'h>> {
    let file = File::open(path)?;
    let length = file.metadata()?.len();
    Ok(Body::File(file, length))
}

/// Returns the path that a request asks for, decoded and without its first slash.
fn path(target: &str) -> Option<Cow<'_, str>> {
    let (path, _) = target.split_once('?').unwrap_or((target, ""));
    let path = path.strip_prefix('/')?;
    percent_decode_str(path).decode_utf8().ok()
}

fn answer<'h>(status: u16, kind: &'static str, cache: &'static str, body: Body<'h>) -> Answer<'h> {
    let mut head = vec![("Content-Type", kind), ("Cache-Control", cache)];
    head.extend(ALWAYS);
    Answer { status, head, body }
}

fn refusal<'h>(status: u16, why: &'static str) -> Answer<'h> {
    let body = Body::Bytes(Cow::Borrowed(why.as_bytes()));
    answer(status, "text/plain; charset=utf-8", "no-store", body)
}

/// Tells whether a line `Accept-Encoding` takes gzip.
pub fn takes_gzip(accepted: &str) -> bool {
    accepted.split(',').any(|coding| {
        let (name, quality) = coding.split_once(';').unwrap_or((coding, "q=1"));
        let quality = quality.trim().strip_prefix("q=").map(str::parse::<f32>);
        let is_wanted = matches!(quality, Some(Ok(quality)) if quality > 0.0);
        is_wanted && name.trim().eq_ignore_ascii_case("gzip")
    })
}

#[cfg(test)]
mod tests;
