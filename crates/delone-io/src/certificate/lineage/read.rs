//! Reading the table of lineage.

use super::write::HEADER;
use super::{Along, Lineage, OfEdge, OfVertex};
use crate::scan::{Row, Scanner};
use crate::{Error, Place, Problem, Source};
use delone::{VertexId, Watch};

/// How many columns there are.
const COLUMNS: usize = 10;

/// The largest number of a vertex, segment or triangle.
const MOST: usize = u32::MAX as usize - 1;

impl Lineage {
    /// Reads a table of lineage for an input of so many segments.
    ///
    /// # Errors
    /// If the file cannot be read, is malformed (with its line), or the watch cancels.
    ///
    /// *Cost*: proportional to the file.
    pub fn read(source: &Source, num_segments: usize, watch: &dyn Watch) -> Result<Self, Error> {
        let bytes = source.load(watch)?;
        let file = source.to_string();
        let mut scanner = Scanner::new(&file, &bytes, watch);
        let malformed = |line: u64, problem: String| Error::Malformed {
            file: file.clone(),
            place: Place::Line(line),
            problem: Problem::Other(problem),
        };
        match scanner.next_full_row()? {
            Some(row) if row.text == HEADER.as_bytes() => {}
            _ => {
                return Err(malformed(
                    1,
                    format!("a table of lineage begins with {HEADER}"),
                ));
            }
        }
        let mut lineage = Self {
            num_segments,
            ..Self::default()
        };
        while let Some(row) = scanner.next_full_row()? {
            lineage
                .take(row)
                .map_err(|problem| malformed(row.line, problem))?;
        }
        Ok(lineage)
    }

    fn take(&mut self, row: Row<'_>) -> Result<(), String> {
        let text = str::from_utf8(row.text).map_err(|_| "not UTF-8".to_owned())?;
        let mut cells = [""; COLUMNS];
        let mut given = text.split(',');
        for cell in &mut cells {
            *cell = given
                .next()
                .ok_or_else(|| format!("too few cells, there are {COLUMNS} columns"))?;
        }
        if given.next().is_some() {
            return Err(format!("too many cells, there are {COLUMNS} columns"));
        }
        let [
            element,
            number,
            origin,
            feature,
            at,
            to,
            other,
            other_at,
            a,
            b,
        ] = cells;
        let number = whole("number", number)?;
        let expect = |next: usize| match number == next {
            true => Ok(()),
            false => Err(format!(
                "{element} {number} instead of {next}: rows must be in order"
            )),
        };
        match element {
            "vertex" => {
                expect(self.vertices.len())?;
                let vertex = match origin {
                    "input" if whole("feature", feature)? == number => OfVertex::Input,
                    "input" => return Err("another point of the input than the vertex".to_owned()),
                    "duplicate" => OfVertex::Duplicate(VertexId::new(whole("feature", feature)?)),
                    "free" => OfVertex::Free,
                    "crossing" => OfVertex::Crossing([
                        self.along("segment", feature, at)?,
                        self.along("segment", other, other_at)?,
                    ]),
                    kind => OfVertex::OnSegment(self.along(kind, feature, at)?),
                };
                self.vertices.push(vertex);
            }
            "edge" => {
                expect(self.edges.len())?;
                let from = self.along(origin, feature, at)?;
                let ends = [whole("from_vertex", a)?, whole("to_vertex", b)?];
                self.edges.push(OfEdge {
                    segment: from.segment,
                    ends: ends.map(VertexId::new),
                    at: [from.at, fraction("to", to)?],
                });
            }
            "triangle" => {
                let regions = self.regions.get_or_insert_default();
                expect(regions.len())?;
                regions.push(match origin {
                    "region" => Some(whole("feature", feature)?),
                    "none" => None,
                    _ => return Err(format!("origin {origin:?} of a triangle: region or none")),
                });
            }
            _ => return Err(format!("element {element:?}: vertex, edge or triangle")),
        }
        Ok(())
    }

    fn along(&self, kind: &str, feature: &str, at: &str) -> Result<Along, String> {
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

fn whole(column: &str, cell: &str) -> Result<usize, String> {
    let number = cell.parse().ok().filter(|&number: &usize| number < MOST);
    number.ok_or_else(|| format!("{column} is {cell:?}, it must be a number from 0 on"))
}

fn fraction(column: &str, cell: &str) -> Result<f64, String> {
    let number = cell.parse().ok().filter(|t| (0.0..=1.0).contains(t));
    number.ok_or_else(|| format!("{column} is {cell:?}, it must be a number from 0 to 1"))
}
