//! Embeds the page of the theatre, so that the program is one file: all of `web/dist`, compressed, if it holds a page.
//!
//! Where there is none, nothing is embedded, and `delone theatre` says how to build it. Packages of this crate
//! alone have none.

use flate2::{Compression, write::GzEncoder};
use std::env;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

fn main() {
    println!("cargo::rustc-check-cfg=cfg(has_page)");
    println!("cargo::rerun-if-changed=build.rs");
    let dist = folder("CARGO_MANIFEST_DIR").join("../../web/dist");
    if dist.is_dir() {
        println!("cargo::rerun-if-changed={}", dist.display());
    }
    let has_page = dist.join("index.html").is_file();
    if has_page {
        println!("cargo::rustc-cfg=has_page");
    }
    let files = if has_page { files(&dist) } else { Vec::new() };
    embed(&dist, &files, &folder("OUT_DIR"));
}

/// Returns a folder that Cargo names.
fn folder(variable: &str) -> PathBuf {
    env::var_os(variable).expect("Cargo sets it").into()
}

/// Lists the files in a folder and below, without hidden ones and links, sorted.
fn files(root: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| unreadable(&folder, &error)) {
            let entry = entry.unwrap_or_else(|error| unreadable(&folder, &error));
            let kind = entry.file_type();
            let kind = kind.unwrap_or_else(|error| unreadable(&entry.path(), &error));
            if entry.file_name().as_encoded_bytes().starts_with(b".") {
                continue;
            } else if kind.is_dir() {
                folders.push(entry.path());
            } else if kind.is_file() {
                files.push(entry.path());
            }
        }
    }
    files.sort();
    files
}

/// Writes the compressed files, and the table that `theatre/page.rs` includes.
fn embed(root: &Path, files: &[PathBuf], out: &Path) {
    let mut table = "&[\n".to_owned();
    for (number, file) in files.iter().enumerate() {
        let compressed = out.join(format!("page-{number}.gz"));
        let bytes = fs::read(file).unwrap_or_else(|error| unreadable(file, &error));
        write(&compressed, &compress(&bytes));
        let path = address(file.strip_prefix(root).expect("it lies below"));
        let row = format!("Asset {{ path: {path:?}, gzip: include_bytes!({compressed:?}) }},");
        writeln!(table, "    {row}").expect("memory takes every byte");
    }
    table += "]\n";
    write(&out.join("page.rs"), table.as_bytes());
}

/// Returns a relative path as addresses have it, with slashes on every system.
fn address(path: &Path) -> String {
    let names = path.iter().map(|name| match name.to_str() {
        Some(name) => name,
        None => panic!("{}: a name that is not UTF-8", path.display()),
    });
    names.collect::<Vec<_>>().join("/")
}

fn compress(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    written.expect("memory takes every byte")
}

fn write(path: &Path, bytes: &[u8]) {
    if let Err(error) = fs::write(path, bytes) {
        panic!("cannot write {}: {error}", path.display());
    }
}

fn unreadable<T>(path: &Path, error: &std::io::Error) -> T {
    panic!("cannot read {}: {error}", path.display());
}
