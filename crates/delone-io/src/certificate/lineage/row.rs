//! The rows of the table, as its columns have them, whatever the file is.

use super::{Along, Lineage, OfEdge, OfVertex, Within};
use delone::VertexId;

/// The names of the columns.
pub(crate) const COLUMNS: [&str; 10] = [
    "element",
    "number",
    "origin",
    "feature",
    "at",
    "to",
    "other",
    "other_at",
    "from_vertex",
    "to_vertex",
];

/// What rows are about.
#[cfg(feature = "parquet")]
pub(crate) const ELEMENTS: [&str; 3] = ["vertex", "edge", "triangle"];

/// Where elements come from.
#[cfg(feature = "parquet")]
pub(crate) const ORIGINS: [&str; 8] = [
    "input",
    "duplicate",
    "crossing",
    "segment",
    "hull",
    "free",
    "region",
    "none",
];

/// The largest number of a vertex, segment or triangle.
const MOST: usize = u32::MAX as usize - 1;

/// A row: its cells by name, those that are empty none.
#[derive(Clone, Copy, Default)]
pub(crate) struct Row<'a> {
    pub element: &'a str,
    pub number: usize,
    pub origin: &'a str,
    pub feature: Option<usize>,
    pub at: Option<f64>,
    pub to: Option<f64>,
    pub other: Option<usize>,
    pub other_at: Option<f64>,
    pub from_vertex: Option<usize>,
    pub to_vertex: Option<usize>,
}

impl Row<'_> {
    /// Returns the cells behind the origin.
    pub fn numbers(&self) -> [Option<f64>; 7] {
        let whole = |cell: Option<usize>| cell.map(|number| number as f64);
        [
            whole(self.feature),
            self.at,
            self.to,
            whole(self.other),
            self.other_at,
            whole(self.from_vertex),
            whole(self.to_vertex),
        ]
    }
}

/// The rows of a table, by their places in it.
pub(crate) struct Rows<'a> {
    lineage: &'a Lineage,
    /// Of each row of a vertex the vertex, and how many rows it has before.
    of_vertices: Vec<(u32, u8)>,
}

impl Rows<'_> {
    /// Counts the rows.
    pub fn len(&self) -> usize {
        let triangles = self.lineage.regions.as_ref().map_or(0, Vec::len);
        self.of_vertices.len() + self.lineage.edges.len() + triangles
    }

    /// Returns a row.
    pub fn get(&self, i: usize) -> Row<'static> {
        let (vertices, edges) = (self.of_vertices.len(), self.lineage.edges.len());
        if let Some(&(number, before)) = self.of_vertices.get(i) {
            return self.lineage.row_of_vertex(number as usize, before);
        }
        match i - vertices {
            edge if edge < edges => self.lineage.row_of_edge(edge),
            triangle => self.lineage.row_of_triangle(triangle - edges),
        }
    }
}

impl Lineage {
    /// Returns the rows of the table. *Cost*: 8 bytes for each that is of a vertex.
    pub(crate) fn rows(&self) -> Rows<'_> {
        let vertices = (0_u32..).zip(&self.vertices);
        let rows = vertices.flat_map(|(v, of)| (0..of.num_rows() as u8).map(move |k| (v, k)));
        Rows {
            lineage: self,
            of_vertices: rows.collect(),
        }
    }

    fn row_of_triangle(&self, number: usize) -> Row<'static> {
        let region = self.regions.as_ref().and_then(|regions| regions[number]);
        Row {
            element: "triangle",
            number,
            origin: region.map_or("none", |_| "region"),
            feature: region,
            ..Row::default()
        }
    }

    fn row_of_vertex(&self, number: usize, before: u8) -> Row<'static> {
        let (element, empty) = ("vertex", Row::default());
        let row = match self.vertices[number] {
            OfVertex::Input => Row {
                origin: "input",
                feature: Some(number),
                ..empty
            },
            OfVertex::Duplicate(kept) => Row {
                origin: "duplicate",
                feature: Some(kept.index()),
                ..empty
            },
            OfVertex::Free(within) => {
                let corner = within.corners().nth(before.into());
                Row {
                    origin: "free",
                    feature: corner.map(|(corner, _)| corner.index()),
                    at: corner.map(|(_, weight)| weight),
                    ..empty
                }
            }
            OfVertex::OnSegment(Along { segment, at }) => {
                let (origin, feature) = self.feature(segment);
                Row {
                    origin,
                    feature: Some(feature),
                    at: Some(at),
                    ..empty
                }
            }
            OfVertex::Crossing([first, second]) => Row {
                origin: "crossing",
                feature: Some(first.segment),
                at: Some(first.at),
                other: Some(second.segment),
                other_at: Some(second.at),
                ..empty
            },
        };
        Row {
            element,
            number,
            ..row
        }
    }

    fn row_of_edge(&self, number: usize) -> Row<'static> {
        let edge = self.edges[number];
        let (origin, feature) = self.feature(edge.segment);
        let [from, to] = edge.ends.map(VertexId::index);
        Row {
            element: "edge",
            number,
            origin,
            feature: Some(feature),
            at: Some(edge.at[0]),
            to: Some(edge.at[1]),
            from_vertex: Some(from),
            to_vertex: Some(to),
            ..Row::default()
        }
    }

    /// Tells whether a segment is one of the input or an edge of the hull, and which.
    fn feature(&self, segment: usize) -> (&'static str, usize) {
        match segment.checked_sub(self.num_segments) {
            None => ("segment", segment),
            Some(hull) => ("hull", hull),
        }
    }

    /// Adds a row; the problem is in words.
    pub(crate) fn take(&mut self, row: &Row<'_>) -> Result<(), String> {
        let Row {
            element, number, ..
        } = *row;
        let expect = |next: usize| match number == next {
            true => Ok(()),
            false => Err(format!(
                "{element} {number} instead of {next}: rows must be in order"
            )),
        };
        match element {
            "vertex"
                if row.origin == "free" && self.vertices.len().checked_sub(1) == Some(number) =>
            {
                let (corner, weight) = corner(row)?;
                match self.vertices.last_mut() {
                    Some(OfVertex::Free(within)) => within.push(corner, weight)?,
                    _ => expect(number + 1)?,
                }
            }
            "vertex" => {
                expect(self.vertices.len())?;
                let vertex = self.vertex(row)?;
                self.vertices.push(vertex);
            }
            "edge" => {
                expect(self.edges.len())?;
                let from = self.along(row.origin, row.feature, row.at)?;
                let ends = [
                    whole("from_vertex", row.from_vertex)?,
                    whole("to_vertex", row.to_vertex)?,
                ];
                self.edges.push(OfEdge {
                    segment: from.segment,
                    ends: ends.map(VertexId::new),
                    at: [from.at, fraction("to", row.to)?],
                });
            }
            "triangle" => {
                let regions = self.regions.get_or_insert_default();
                expect(regions.len())?;
                regions.push(match row.origin {
                    "region" => Some(whole("feature", row.feature)?),
                    "none" => None,
                    other => {
                        return Err(format!("origin {other:?} of a triangle: region or none"));
                    }
                });
            }
            _ => return Err(format!("element {element:?}: vertex, edge or triangle")),
        }
        Ok(())
    }

    fn vertex(&self, row: &Row<'_>) -> Result<OfVertex, String> {
        Ok(match row.origin {
            "input" if whole("feature", row.feature)? == row.number => OfVertex::Input,
            "input" => return Err("another point of the input than the vertex".to_owned()),
            "duplicate" => OfVertex::Duplicate(VertexId::new(whole("feature", row.feature)?)),
            "free" => {
                let (corner, weight) = corner(row)?;
                OfVertex::Free(Within::first(corner, weight))
            }
            "crossing" => OfVertex::Crossing([
                self.along("segment", row.feature, row.at)?,
                self.along("segment", row.other, row.other_at)?,
            ]),
            kind => OfVertex::OnSegment(self.along(kind, row.feature, row.at)?),
        })
    }

    fn along(&self, kind: &str, feature: Option<usize>, at: Option<f64>) -> Result<Along, String> {
        let number = whole("feature", feature)?;
        let segment = match kind {
            "segment" if number < self.num_segments => number,
            "segment" => {
                let segments = self.num_segments;
                return Err(format!("segment {number} of {segments} (numbered from 0)"));
            }
            "hull" => number.saturating_add(self.num_segments).min(MOST),
            _ => {
                return Err(format!(
                    "origin {kind:?}: input, duplicate, crossing, segment, hull or free"
                ));
            }
        };
        Ok(Along {
            segment,
            at: fraction("at", at)?,
        })
    }
}

/// Reads a corner and its weight.
fn corner(row: &Row<'_>) -> Result<(VertexId, f64), String> {
    let corner = VertexId::new(whole("feature", row.feature)?);
    Ok((corner, fraction("at", row.at)?))
}

fn whole(column: &str, cell: Option<usize>) -> Result<usize, String> {
    let number = cell.filter(|&number| number < MOST);
    number.ok_or_else(|| {
        let given = cell.map_or_else(|| "missing".to_owned(), |number| number.to_string());
        format!("{column} is {given}, it must be a number from 0 on")
    })
}

fn fraction(column: &str, cell: Option<f64>) -> Result<f64, String> {
    let number = cell.filter(|t| (0.0..=1.0).contains(t));
    number.ok_or_else(|| {
        let given = cell.map_or_else(|| "missing".to_owned(), |number| number.to_string());
        format!("{column} is {given}, it must be a number from 0 to 1")
    })
}
