//! What there is to triangulate: points, segments and holes; drawn, or read from files, and changed.

mod edit;
mod files;
mod presets;
#[cfg(test)]
mod tests;

pub use files::file_kind;

use crate::{Trouble, json};
use delone::{DomainRule, Region, VertexId};
use delone_io::DomainData;
use edit::Edit;
use serde::{Deserialize, Serialize};
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

    /// Copies the drawing.
    pub fn copy(&self) -> Self {
        self.clone()
    }

    /// Makes a list of edits in their order, all or none. `edits` is JSON, an array of
    ///
    /// - `{"addPoint": [x, y]}`, `{"movePoint": [i, x, y]}`, `{"removePoint": i}` with the segments that end there;
    /// - `{"addSegment": [i, j]}`, `{"removeSegment": k}`;
    /// - `{"addHole": [x, y]}`, `{"moveHole": [k, x, y]}`, `{"removeHole": k}`;
    /// - `{"addRegion": [x, y, attribute, largest area or null]}`, `{"moveRegion": [k, x, y]}`, `{"removeRegion": k}`;
    /// - `{"clear": true}`.
    ///
    /// Numbers count from 0, and those behind what is removed move down by one. A new point has no value in any
    /// attribute and marker 0. Whoever edits points loses the triangles that a file brought. An error names the edit, and
    /// nothing is changed.
    ///
    /// *Cost*: constant for a single edit that adds or moves, linear for all else; many points are best
    /// removed in one list, the last one first.
    pub fn edit(&mut self, edits: &str) -> Result<(), Trouble> {
        edit::apply(self, &Edit::list(edits)?)
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

    /// Returns the regions, four numbers each: x and y of a place in it, its attribute, and its largest area or NaN.
    pub fn regions(&self) -> Vec<f64> {
        let row = |r: &Region| [r.at.x, r.at.y, r.attribute, r.max_area.unwrap_or(f64::NAN)];
        self.data.regions.iter().flat_map(row).collect()
    }

    /// Returns the corners of the triangles that a file brought, counter-clockwise; none unless it was a mesh.
    pub fn triangles(&self) -> Vec<u32> {
        json::indices(self.start.iter().copied())
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
