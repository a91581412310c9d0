//! The geometries of GeoJSON and WKT, put together to a domain.
//!
//! Each position becomes a point of its own, in the order of the file, except that the last of a ring
//! is its first: so the position of a vertex in the file can be told from its index, and equal points
//! of neighbouring polygons are merged, as all are, by the library. Points are loose, lines become
//! segments of no polygon, and each polygon is a range of segments, outline and holes together.

use crate::{Attribute, DomainData, PointSet, Problem, node};
use delone::{DomainRule, Point, VertexId};
use std::ops::Range;

/// Numbers that a position may carry beyond x and y.
const EXTRAS: [&str; 2] = ["z", "m"];

/// A position as a file has it; NaN where it has no number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Position {
    pub point: Point,
    pub extras: [f64; EXTRAS.len()],
}

/// A domain in the making.
#[derive(Default)]
pub(crate) struct Shapes {
    points: Vec<Point>,
    /// For each extra its values, none as long as no position has it.
    extras: [Vec<f64>; EXTRAS.len()],
    segments: Vec<[VertexId; 2]>,
    polygons: Vec<Range<usize>>,
    markers: Vec<i32>,
    /// Whether the file itself has given a marker.
    has_markers: bool,
    /// Number of features that are complete.
    features: usize,
}

impl Shapes {
    /// Returns the number of points so far.
    pub fn num_points(&self) -> usize {
        self.points.len()
    }

    /// Adds a loose point.
    pub fn point(&mut self, position: Position) -> Result<(), Problem> {
        self.push(position).map(|_| ())
    }

    /// Adds a line, which may be closed. No positions at all are an empty line.
    pub fn line(&mut self, line: &[Position]) -> Result<(), Problem> {
        match line {
            [] => Ok(()),
            [_] => Err(Problem::Other(
                "a line of one position; at least 2 are needed".to_owned(),
            )),
            [first, .., last] if line.len() > 3 && first.point == last.point => self.closed(line),
            _ => self.open(line).map(|_| ()),
        }
    }

    /// Adds a polygon: its outline, then its holes. No rings at all are an empty polygon.
    pub fn polygon<'p>(
        &mut self,
        rings: impl IntoIterator<Item = &'p [Position]>,
    ) -> Result<(), Problem> {
        let start = self.segments.len();
        for (number, ring) in rings.into_iter().enumerate() {
            check_ring(number, ring)?;
            self.closed(ring)?;
        }
        if start < self.segments.len() {
            self.polygons.push(start..self.segments.len());
        }
        Ok(())
    }

    /// Ends a feature; its segments get its own marker, or else its number, from 1.
    pub fn end_feature(&mut self, marker: Option<i32>) {
        self.features += 1;
        self.has_markers |= marker.is_some();
        let marker = marker.unwrap_or_else(|| i32::try_from(self.features).unwrap_or(i32::MAX));
        self.markers.resize(self.segments.len(), marker);
    }

    /// Makes the domain. A single feature needs no markers to tell it from others.
    pub fn finish(self) -> DomainData {
        let usual_rule = match self.polygons.is_empty() {
            true => DomainRule::Hull,
            false => DomainRule::EvenOdd,
        };
        let extras = EXTRAS.into_iter().zip(self.extras);
        let attributes = extras
            .filter(|(_, values)| !values.is_empty())
            .map(|(name, values)| Attribute {
                name: name.to_owned(),
                values,
            });
        DomainData {
            vertices: PointSet {
                points: self.points,
                attributes: attributes.collect(),
                ..PointSet::default()
            },
            segments: self.segments,
            segment_markers: (self.has_markers || self.features > 1).then_some(self.markers),
            polygons: self.polygons,
            usual_rule,
            ..DomainData::default()
        }
    }

    fn push(&mut self, position: Position) -> Result<VertexId, Problem> {
        let index = self.points.len();
        if index as u64 == node::MAX_POINTS {
            return Err(node::too_many(node::MAX_POINTS + 1));
        }
        self.points.push(position.point);
        for (values, extra) in self.extras.iter_mut().zip(position.extras) {
            if !values.is_empty() || !extra.is_nan() {
                values.resize(index, f64::NAN);
                values.push(extra);
            }
        }
        Ok(VertexId::new(index))
    }

    /// Adds the segments along a line and returns its first and last vertex.
    fn open(&mut self, line: &[Position]) -> Result<Option<[VertexId; 2]>, Problem> {
        let mut ends: Option<[VertexId; 2]> = None;
        for &position in line {
            let v = self.push(position)?;
            if let Some([_, last]) = ends {
                self.segments.push([last, v]);
            }
            ends = Some([ends.map_or(v, |[first, _]| first), v]);
        }
        Ok(ends)
    }

    /// Adds the segments of a ring whose last position is its first.
    fn closed(&mut self, ring: &[Position]) -> Result<(), Problem> {
        if let Some([first, last]) = self.open(&ring[..ring.len() - 1])? {
            self.segments.push([last, first]);
        }
        Ok(())
    }
}

/// Checks that a ring is one.
fn check_ring(number: usize, ring: &[Position]) -> Result<(), Problem> {
    match ring {
        [first, _, _, .., last] if first.point == last.point => Ok(()),
        [first, _, _, .., last] => {
            let [a, b] = [first.point, last.point];
            Err(Problem::Other(format!(
                "ring {number} is not closed: it begins at ({}, {}) and ends at ({}, {})",
                a.x, a.y, b.x, b.y
            )))
        }
        _ => Err(Problem::Other(format!(
            "ring {number} has {} positions; at least 4 are needed, the last like the first",
            ring.len()
        ))),
    }
}
