//! What there is to triangulate: points, segments and holes.

mod presets;

use crate::{Trouble, json};
use delone::predicates::{Orientation, orient2d};
use delone::{DomainRule, Point, VertexId};
use delone_io::{DomainData, Format, ReadOptions, Source, read_domain, read_mesh};
use serde::{Deserialize, Serialize};
use std::path::Path;
use wasm_bindgen::prelude::wasm_bindgen;

/// Points, segments between them, and a point in each hole; perhaps triangles to begin with.
#[wasm_bindgen]
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    pub(crate) data: DomainData,
    /// Triangles that a file brings, counter-clockwise.
    pub(crate) start: Vec<[VertexId; 3]>,
}

/// Which triangles belong to a domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Rule {
    Hull,
    Carve,
    EvenOdd,
}

impl From<Rule> for DomainRule {
    fn from(rule: Rule) -> Self {
        match rule {
            Rule::Hull => Self::Hull,
            Rule::Carve => Self::Carve,
            Rule::EvenOdd => Self::EvenOdd,
        }
    }
}

/// What of a file is not used, and what it is.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct About<'a> {
    points: usize,
    segments: usize,
    holes: usize,
    regions: usize,
    triangles: usize,
    rule: Rule,
    attributes: Vec<&'a str>,
    left_out: Vec<&'a str>,
}

#[wasm_bindgen]
impl Drawing {
    /// Makes a drawing of coordinates (x, y, x, y, …), segments (pairs of indices of points) and a place in each
    /// hole (x, y, …).
    #[wasm_bindgen(constructor)]
    pub fn new(points: &[f64], segments: &[u32], holes: &[f64]) -> Result<Self, Trouble> {
        let points = rows("points", points)?;
        let (segments, holes) = (rows("segments", segments)?, rows("holes", holes)?);
        Ok(DomainData::from_rows(points, segments, holes)?.into())
    }

    /// Reads a file of any format that the command line reads: its name, for the extension and for messages, and
    /// its bytes. Errors name the line.
    #[wasm_bindgen(js_name = fromFile)]
    pub fn from_file(name: &str, bytes: &[u8]) -> Result<Self, Trouble> {
        let source = Source::Memory {
            name: name.to_owned(),
            bytes: bytes.to_vec(),
        };
        let options = ReadOptions::default();
        let format = Format::from_path(Path::new(name)).or_else(|| Format::sniff(bytes));
        if format == Some(Format::Vtu) {
            let mesh = read_mesh(&source, &options, &())?;
            let start = counter_clockwise(mesh.triangles, &mesh.vertices.points);
            let mut data = DomainData::from(mesh.vertices);
            data.segments = mesh.constraints.map_or_else(Vec::new, |c| c.edges);
            return Ok(Self { data, start });
        }
        Ok(read_domain(&source, &options, &())?.into())
    }

    /// Draws a preset; `count`, of points or segments, and `seed` matter for those that say so.
    pub fn preset(name: &str, count: u32, seed: u32) -> Result<Self, Trouble> {
        presets::draw(name, count, seed).map(Self::from)
    }

    /// Lists the presets, as JSON: `[{name, about, kind: "points" | "domain" | "scene", sized}]`.
    pub fn presets() -> String {
        json::write(&presets::list())
    }

    /// Returns the coordinates of the points.
    pub fn points(&self) -> Vec<f64> {
        json::coordinates(self.data.vertices.points.iter().copied())
    }

    /// Returns the segments, as pairs of indices.
    pub fn segments(&self) -> Vec<u32> {
        json::indices(self.data.segments.iter().copied())
    }

    /// Returns the coordinates of a place in each hole.
    pub fn holes(&self) -> Vec<f64> {
        json::coordinates(self.data.holes.iter().copied())
    }

    /// Tells what is there, as JSON: `{points, segments, holes, regions, triangles, rule, attributes, leftOut}`;
    /// `rule` is the usual one of this drawing: `"hull"`, `"carve"` or `"evenodd"`.
    pub fn about(&self) -> String {
        let DomainData { vertices, .. } = &self.data;
        json::write(&About {
            points: vertices.points.len(),
            segments: self.data.segments.len(),
            holes: self.data.holes.len(),
            regions: self.data.regions.len(),
            triangles: self.start.len(),
            rule: match self.data.usual_rule {
                DomainRule::Hull => Rule::Hull,
                DomainRule::Carve => Rule::Carve,
                DomainRule::EvenOdd => Rule::EvenOdd,
            },
            attributes: vertices.attributes.iter().map(|a| &a.name[..]).collect(),
            left_out: vertices.left_out.iter().map(|l| &l.name[..]).collect(),
        })
    }
}

impl From<DomainData> for Drawing {
    fn from(data: DomainData) -> Self {
        let start = Vec::new();
        Self { data, start }
    }
}

/// Cuts a list into rows.
fn rows<T: Copy, const N: usize>(what: &str, list: &[T]) -> Result<Vec<[T; N]>, Trouble> {
    let (rows, rest) = list.as_chunks();
    match rest {
        [] => Ok(rows.to_vec()),
        _ => {
            let n = list.len();
            let message = format!("{what}: {n} numbers are no multiple of {N}");
            Err(Trouble::asked(message))
        }
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

    #[test]
    fn what_goes_in_comes_out() {
        let points = [0.0, 0.0, 4.0, 0.0, 0.0, 3.0];
        let drawing = Drawing::new(&points, &[0, 1, 1, 2], &[1.0, 1.0]).expect("a drawing");
        assert_eq!(drawing.points(), points);
        assert_eq!(drawing.segments(), [0, 1, 1, 2]);
        assert_eq!(drawing.holes(), [1.0, 1.0]);
        assert!(drawing.about().contains(r#""rule":"carve""#));
    }

    #[test]
    fn nonsense_is_refused_by_name() {
        let refused = |points: &[f64], segments: &[u32]| {
            let drawing = Drawing::new(points, segments, &[]);
            drawing.expect_err("nonsense").to_string()
        };
        assert!(refused(&[0.0; 3], &[]).contains("points: 3 numbers"));
        assert!(refused(&[0.0; 4], &[0, 2]).contains("segment 0 joins 0 and 2 of 2 points"));
    }

    #[test]
    fn files_are_read_from_memory_and_errors_name_the_line() {
        let wkt =
            Drawing::from_file("a.wkt", b"POLYGON ((0 0, 4 0, 0 4, 0 0))").expect("a polygon");
        assert_eq!(wkt.points().len(), 6);
        let error = Drawing::from_file("b.csv", b"x,y\n1,2\n3,oops\n").expect_err("a broken line");
        assert!(error.to_string().contains("b.csv:3"), "{error}");
        Drawing::from_file("c.ele", b"1 3 0\n1 1 2 3\n").expect_err("points are missing");
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
}
