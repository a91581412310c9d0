//! Numbers in files that lie: whatever a header says, memory stays in proportion to the file.
//!
//! Every file under `tests/data` of `delone-io`, of every format, is read again and again; each time one of its numbers
//! (in text), or four or eight of its bytes (in others), is huge. Peaks of allocation are measured.

use delone_filekit::Meter;
use delone_io::{Format, ReadOptions, Source, read_domain, read_mesh, read_points};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What a reader may take for a small file, lies or not: buffers, tables, decoders of compressed data.
const LEAST: usize = 48 << 20;
/// The same for Parquet, where a few bytes may well mean millions of equal numbers, up to a budget.
const LEAST_OF_PARQUET: usize = 640 << 20;
/// What it may take for each byte of a file.
const PER_BYTE: usize = 1200;
/// What a reader may take of time, on a busy machine.
const LONG: Duration = Duration::from_secs(10);
/// Most places in a file that are made to lie.
const PLACES: usize = 150;

/// Reads a file in every way that its format knows; returns the peak of memory and the time.
fn read(name: &Path, bytes: Vec<u8>) -> (usize, Duration) {
    let format = Format::from_path(name).expect("a format");
    let size = bytes.len();
    let source = Source::Memory {
        name: name.display().to_string(),
        bytes,
    };
    let options = ReadOptions::default();
    let meter = Meter::start();
    let start = Instant::now();
    // Whether these are results or errors is not asked here.
    if format.reads_mesh() {
        drop(read_mesh(&source, &options, &()));
    }
    drop(read_points(&source, &options, &()));
    drop(read_domain(&source, &options, &()));
    let time = start.elapsed();
    let peak = meter.peak();
    let least = match format {
        Format::Parquet => LEAST_OF_PARQUET,
        _ => LEAST,
    };
    assert!(
        peak <= least + PER_BYTE * size,
        "{}: {} MiB for {size} bytes",
        name.display(),
        peak >> 20
    );
    assert!(time < LONG, "{}: {time:?} for {size} bytes", name.display());
    (peak, time)
}

/// Lists where numbers stand in text, from their first digit to behind the last.
fn numbers(text: &[u8]) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut i = 0;
    while i < text.len() {
        let digits = text[i..].iter().take_while(|b| b.is_ascii_digit()).count();
        if digits > 0 {
            found.push((i, i + digits));
        }
        i += digits.max(1);
    }
    found
}

/// Lists the lies that can be told in a file.
fn lies(bytes: &[u8]) -> Vec<Vec<u8>> {
    let spread = |all: usize, i: usize| if all <= PLACES { i } else { i * all / PLACES };
    let mut lies = Vec::new();
    let is_text = std::str::from_utf8(bytes).is_ok() && !bytes.contains(&0);
    if is_text {
        let places = numbers(bytes);
        for i in 0..places.len().min(PLACES) {
            let (from, to) = places[spread(places.len(), i)];
            for huge in ["2147483646", "4000000000000", "100000"] {
                lies.push([&bytes[..from], huge.as_bytes(), &bytes[to..]].concat());
            }
        }
        return lies;
    }
    for i in 0..bytes.len().min(2 * PLACES) {
        // Half of the places lie at the beginning, where headers are.
        let at = if i < PLACES {
            i
        } else {
            spread(bytes.len(), i - PLACES)
        };
        for huge in [
            &[0xff, 0xff, 0xff, 0x7f][..],
            &[0x7f, 0xff, 0xff, 0xff],
            &[0xff, 0xff, 0x0f, 0],
            &[0, 0, 0, 0, 0xff, 0, 0, 0],
        ] {
            let mut lie = bytes.to_vec();
            let end = (at + huge.len()).min(lie.len());
            lie[at..end].copy_from_slice(&huge[..end - at]);
            lies.push(lie);
        }
    }
    lies
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<_> = entries.map(|e| e.expect("an entry").path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            files(&path, found);
        } else if Format::from_path(&path).is_some() {
            found.push(path);
        }
    }
}

#[test]
fn numbers_that_lie_cost_no_memory() {
    let mut all = Vec::new();
    files(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("../delone-io/tests/data"),
        &mut all,
    );
    assert!(all.len() > 40, "{} files", all.len());
    let mut count = 0;
    for path in all {
        let bytes = fs::read(&path).expect("a file");
        let mut most = (0, Duration::ZERO);
        for lie in lies(&bytes) {
            let (peak, time) = read(&path, lie);
            most = (most.0.max(peak), most.1.max(time));
            count += 1;
        }
        let name = path.file_name().unwrap_or_default().display();
        println!(
            "{name}: {} bytes, {} KiB, {:?}",
            bytes.len(),
            most.0 >> 10,
            most.1
        );
    }
    println!("{count} lies");
}
