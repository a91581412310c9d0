//! Drawings from files: one that is opened, and those beside it.

use super::Drawing;
use crate::Trouble;
use delone::predicates::{Orientation, orient2d};
use delone::{DomainRule, Point, VertexId};
use delone_io::{
    Constraints, DomainData, Format, LogFormat, MemoryFile, MeshData, ReadOptions, Source,
    read_domain, read_mesh,
};
use js_sys::Uint8Array;
use std::path::Path;
use std::sync::Arc;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
impl Drawing {
    /// Reads a file of any format that the command line reads: its name, for the extension and for messages, and
    /// its bytes. Errors name the line.
    #[wasm_bindgen(js_name = fromFile)]
    pub fn from_file(name: &str, bytes: &[u8]) -> Result<Self, Trouble> {
        Self::read([file(name, bytes.to_vec())].into())
    }

    /// Reads the first of some files, which lie beside each other: `a.ele` finds the points of `a.node` and the
    /// segments of `a.poly`, `a.poly` without points finds them in `a.node`, `a.npy` in `a.points.npy`. A mesh
    /// brings its triangles.
    #[wasm_bindgen(js_name = fromFiles)]
    pub fn from_files(names: Vec<String>, bytes: Vec<Uint8Array>) -> Result<Self, Trouble> {
        let (n, m) = (names.len(), bytes.len());
        if n != m || n == 0 {
            let message = format!("{n} names and {m} contents of files: there must be one or more");
            return Err(Trouble::asked(message));
        }
        let files = names.iter().zip(bytes);
        Self::read(files.map(|(n, b)| file(n, b.to_vec())).collect())
    }
}

impl Drawing {
    /// Reads the first of some files.
    pub(crate) fn read(files: Arc<[MemoryFile]>) -> Result<Self, Trouble> {
        let has_triangles = brings_triangles(&files);
        let source = Source::Together { files, opened: 0 };
        let options = ReadOptions::default();
        match has_triangles {
            true => Ok(read_mesh(&source, &options, &())?.into()),
            false => Ok(read_domain(&source, &options, &())?.into()),
        }
    }
}

impl From<MeshData> for Drawing {
    fn from(mesh: MeshData) -> Self {
        let start = counter_clockwise(mesh.triangles, &mesh.vertices.points);
        let Constraints {
            edges,
            markers,
            holes,
            regions,
            ..
        } = mesh.constraints.unwrap_or_default();
        let usual_rule = match edges.is_empty() {
            true => DomainRule::Hull,
            false => DomainRule::Carve,
        };
        let data = DomainData {
            segments: edges,
            segment_markers: markers,
            holes,
            regions,
            usual_rule,
            ..DomainData::from(mesh.vertices)
        };
        Self { data, start }
    }
}

/// Tells what a file may be opened as, from its name and the beginning of its content: `"log"`, by
/// `Player.fromLog`; `"drawing"`, by `Drawing.fromFiles`; `"unknown"`.
#[wasm_bindgen(js_name = fileKind)]
pub fn file_kind(name: &str, bytes: &[u8]) -> String {
    let reads = |format: Format| format.reads_points();
    let kind = if LogFormat::is_log(bytes) {
        "log"
    } else if format_of(name, bytes).is_some_and(reads) {
        "drawing"
    } else {
        "unknown"
    };
    kind.to_owned()
}

fn file(name: &str, bytes: Vec<u8>) -> MemoryFile {
    let name = name.into();
    MemoryFile { name, bytes }
}

fn format_of(name: &str, bytes: &[u8]) -> Option<Format> {
    Format::detect(Some(Path::new(name)), bytes)
}

/// Tells whether the first file is one of a mesh: by itself, or with its other half beside it.
fn brings_triangles(files: &[MemoryFile]) -> bool {
    let [first, others @ ..] = files else {
        return false;
    };
    let has = |extension: &str| {
        let wanted = first.name.with_extension(extension);
        let is_it = |f: &MemoryFile| f.name.as_os_str().eq_ignore_ascii_case(&wanted);
        others.iter().any(is_it)
    };
    match format_of(&first.name.to_string_lossy(), &first.bytes) {
        Some(Format::Vtu | Format::Ele) => true,
        Some(Format::Node) => has("ele"),
        Some(Format::Npy) => has("points.npy"),
        _ => false,
    }
}

/// Turns triangles counter-clockwise; a file may have them either way.
fn counter_clockwise(mut triangles: Vec<[VertexId; 3]>, points: &[Point]) -> Vec<[VertexId; 3]> {
    for corners in &mut triangles {
        let [a, b, c] = corners.map(|v| points[v.index()]);
        if orient2d(a, b, c) == Orientation::Right {
            corners.swap(1, 2);
        }
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;

    const NODE: &[u8] = b"4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n";
    /// One triangle in each direction.
    const ELE: &[u8] = b"2 3 0\n0 0 1 2\n1 0 3 2\n";
    const POLY: &[u8] = b"0 2 0 0\n4 1\n0 0 1 5\n1 1 2 5\n2 2 3 5\n3 3 0 5\n0\n1\n0 1 1 7 -1\n";

    fn open(files: &[(&str, &[u8])]) -> Result<Drawing, Trouble> {
        Drawing::read(files.iter().map(|(n, b)| file(n, b.to_vec())).collect())
    }

    #[test]
    fn files_are_read_from_memory_and_errors_name_the_line() {
        let wkt =
            Drawing::from_file("a.wkt", b"POLYGON ((0 0, 4 0, 0 4, 0 0))").expect("a polygon");
        assert_eq!(wkt.points().len(), 6);
        let error = Drawing::from_file("b.csv", b"x,y\n1,2\n3,oops\n").expect_err("a broken line");
        assert!(error.to_string().contains("b.csv:3"), "{error}");
        assert_eq!(error.marks().line, Some(3));
    }

    #[test]
    fn a_mesh_brings_its_triangles() {
        let mesh = Drawing::preset("grid", 16, 1).expect("points");
        let mesh = crate::mesh::Mesh::triangulate(&mesh, None).expect("a mesh");
        let files = mesh.save("a.vtu", None).expect("a file");
        let again = Drawing::from_file("a.vtu", &files[0].bytes()).expect("a mesh");
        assert_eq!(again.start.len(), 18);
        assert_eq!(again.points().len(), 32);
    }

    #[test]
    fn the_family_of_a_mesh_comes_whole() {
        for first in [("a.ele", ELE), ("a.node", NODE)] {
            let whole = open(&[first, ("a.node", NODE), ("a.ele", ELE), ("a.poly", POLY)]);
            let whole = whole.expect("a mesh");
            assert_eq!(whole.start[1].map(VertexId::index), [0, 2, 3]);
            assert_eq!(whole.data.segment_markers, Some(vec![5; 4]));
            assert_eq!(whole.regions()[..3], [1.0, 1.0, 7.0]);
            assert!(whole.about().contains(r#""rule":"carve""#));
        }
        let outline = open(&[("a.poly", POLY), ("a.node", NODE)]).expect("a domain");
        assert!(outline.start.is_empty());
        assert_eq!(outline.segments().len(), 8);
    }

    #[test]
    fn a_missing_half_is_named() {
        let error = open(&[("a.ele", ELE), ("b.node", NODE)]).expect_err("no points");
        assert_eq!(error.to_string(), "a.ele needs a.node: open both together");
        open(&[]).expect_err("no files");
        assert!(Drawing::from_files(Vec::new(), Vec::new()).is_err());
    }

    #[test]
    fn files_are_known_by_name_and_content() {
        let kind = |name: &str, bytes: &str| file_kind(name, bytes.as_bytes());
        assert_eq!(
            kind("a.json", r#"{"format":"delone-log","version":1"#),
            "log"
        );
        assert_eq!(kind("a.json", r#"{"type":"Point"}"#), "drawing");
        assert_eq!(kind("a.ele", ""), "drawing");
        assert_eq!(kind("points", "1 2\n3 4\n"), "drawing");
        for unknown in ["a.png", "a.edge", "a.docx"] {
            assert_eq!(kind(unknown, "?"), "unknown");
        }
    }
}
