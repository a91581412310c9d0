use super::*;
use flate2::{Compression, write::GzEncoder};
use std::io::Write;
use std::path::Path;

/// Repeated, a file that is larger than what servers keep in one piece.
pub const LARGE: &str = "let there = 'be light';\n";

/// A page to be served in tests.
pub fn page() -> &'static [Asset] {
    let script = LARGE.repeat(10_000);
    let files = [
        ("index.html", "<!doctype html><title>Delone</title>"),
        ("assets/index-abcd1234.js", &script),
        ("guide/index.html", "<!doctype html><title>Guide</title>"),
    ];
    let assets = files.map(|(path, content)| Asset {
        path,
        gzip: compressed(content),
    });
    Vec::leak(assets.into())
}

fn compressed(content: &str) -> &'static [u8] {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder
        .write_all(content.as_bytes())
        .expect("memory takes every byte");
    encoder.finish().expect("memory takes every byte").leak()
}

fn theatre(file: Option<&Path>, port: u16) -> Theatre {
    Theatre {
        file: file.map(Path::to_owned),
        port,
        no_open: true,
    }
}

/// Serves the page of the tests with a file, and returns what stands behind its address.
fn opened_with(file: &Path) -> Result<String, Failure> {
    let (address, _) = theatre(Some(file), 0).begin(page(), true)?;
    let (address, fragment) = address.split_once('#').expect("a fragment");
    assert!(address.starts_with("http://127.0.0.1:") && address.ends_with('/'));
    Ok(fragment.to_owned())
}

#[test]
fn a_program_without_page_says_how_to_build_it() {
    let failure = theatre(None, 0).begin(&[], true).err().expect("a failure");
    assert_eq!(failure.code(), 4);
    let words = "cargo run --release -p delone-web-build -- --open";
    assert!(failure.to_string().contains(words), "{failure}");
}

#[test]
fn without_a_file_the_address_is_bare() {
    let (address, _) = theatre(None, 0).begin(page(), true).expect("a page");
    assert!(address.ends_with('/'), "{address}");
}

#[test]
fn a_port_that_is_taken_is_named() {
    let (address, _service) = theatre(None, 0).begin(page(), true).expect("a page");
    let port = address
        .trim_end_matches('/')
        .rsplit_once(':')
        .expect("a port")
        .1;
    let port = port.parse().expect("a number");
    let failure = theatre(None, port)
        .begin(page(), true)
        .err()
        .expect("a failure");
    assert_eq!(failure.code(), 4);
    assert!(failure.to_string().contains(&port.to_string()), "{failure}");
}

#[test]
fn files_bring_those_that_they_need() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let write = |name: &str, content: &str| std::fs::write(at(name), content).expect("a file");
    write("m.node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n");
    write("m.ele", "1 3 0\n0 0 1 2\n");
    write("m.poly", "0 2 0 0\n1 0\n0 0 1\n0\n");
    write("p.csv", "0,0\n1,0\n0,1\n");
    write(
        "p.geojson",
        "{\"type\": \"Point\", \"coordinates\": [1, 2]}",
    );
    for (name, expected) in [
        ("m.ele", "open=open/m.ele,open/m.node,open/m.poly"),
        ("m.poly", "open=open/m.poly,open/m.node"),
        ("m.node", "open=open/m.node,open/m.ele,open/m.poly"),
        ("p.csv", "open=open/p.csv"),
        ("p.geojson", "open=open/p.geojson"),
    ] {
        let fragment = opened_with(&at(name)).unwrap_or_else(|failure| panic!("{name}: {failure}"));
        assert_eq!(fragment, expected, "{name}");
    }
}

#[test]
fn logs_are_read_as_logs() {
    use delone::classic::{Algorithm, Input};
    use delone_io::{Recording, write_log};
    let folder = tempfile::tempdir().expect("a folder");
    let input = Input::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]);
    let mut log = delone::Log::new("incremental", input.pslg.points.clone());
    Algorithm::Incremental
        .observe(&input, &mut log)
        .expect("a run");
    let recording = Recording::new(Algorithm::Incremental.about(), log);
    for name in ["run.json", "run.dlog"] {
        let path = folder.path().join(name);
        write_log(&recording, Some(&path), None, &()).expect("a log");
        assert_eq!(
            opened_with(&path).expect("a log"),
            format!("open=open/{name}")
        );
        let content = std::fs::read(&path).expect("a log");
        std::fs::write(&path, &content[..content.len() / 2]).expect("a file");
        let failure = opened_with(&path).expect_err("half a log");
        assert_eq!(failure.code(), 3);
        assert!(failure.to_string().contains(name), "{failure}");
    }
}

#[test]
fn a_file_that_cannot_be_read_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("word.csv"), "x,y\n0,0\n1,zero\n").expect("a file");
    for (name, word) in [
        ("nowhere.csv", "nowhere.csv"),
        ("nowhere", "nowhere"),
        ("word.csv", "word.csv:3"),
    ] {
        let failure = opened_with(&at(name)).expect_err("no page for this");
        assert_eq!(failure.code(), 3, "{name}: {failure}");
        assert!(failure.to_string().contains(word), "{failure}");
    }
}
