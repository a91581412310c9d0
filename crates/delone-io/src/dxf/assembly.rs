//! Points, loops, lines and faces, put together to a domain.
//!
//! Whatever is closed together with the rest bounds by parity: loops within loops are holes. If every end of a
//! line meets another exactly, so that lines and arcs close as well, all segments count; otherwise the hull is
//! taken, and the loops stand ready as one polygon for the rule even-odd. Faces are areas, each a polygon.

use crate::curve::Place3;
use crate::{Attribute, DomainData, PointSet, Problem, node};
use delone::{DomainRule, Point, VertexId};
use std::ops::Range;

/// A domain in the making.
#[derive(Default)]
pub(super) struct Assembly {
    points: Vec<Point>,
    z: Vec<f64>,
    loops: Vec<([VertexId; 2], i32)>,
    lines: Vec<([VertexId; 2], i32)>,
    borders: Vec<([VertexId; 2], i32)>,
    /// Each a range of `borders`.
    faces: Vec<Range<usize>>,
}

impl Assembly {
    pub fn num_points(&self) -> usize {
        self.points.len()
    }

    /// Adds a loose point.
    pub fn point(&mut self, place: Place3) -> Result<(), Problem> {
        self.push(place).map(drop)
    }

    /// Adds a polyline, closed if it ends with its first point.
    pub fn line(&mut self, line: &[Place3], marker: i32) -> Result<(), Problem> {
        let is_closed = line.len() > 3 && line.first() == line.last();
        let segments = self.segments(line, is_closed, marker)?;
        match is_closed {
            true => self.loops.extend(segments),
            false => self.lines.extend(segments),
        }
        Ok(())
    }

    /// Adds the border of a face; one of less than three corners is a line.
    pub fn face(&mut self, line: &[Place3], marker: i32) -> Result<(), Problem> {
        if line.len() < 4 {
            return self.line(line, marker);
        }
        let start = self.borders.len();
        let segments = self.segments(line, true, marker)?;
        self.borders.extend(segments);
        self.faces.push(start..self.borders.len());
        Ok(())
    }

    fn segments(
        &mut self,
        line: &[Place3],
        is_closed: bool,
        marker: i32,
    ) -> Result<Vec<([VertexId; 2], i32)>, Problem> {
        let distinct = &line[..line.len() - usize::from(is_closed)];
        let first = self.points.len();
        for &place in distinct {
            self.push(place)?;
        }
        let vertices = (first..self.points.len()).map(VertexId::new);
        let mut next = vertices
            .clone()
            .skip(1)
            .chain(is_closed.then(|| VertexId::new(first)));
        let ends = vertices.map_while(|v| Some([v, next.next()?]));
        Ok(ends.map(|ends| (ends, marker)).collect())
    }

    fn push(&mut self, [x, y, z]: Place3) -> Result<(), Problem> {
        if self.points.len() as u64 == node::MAX_POINTS {
            return Err(node::too_many(node::MAX_POINTS + 1));
        }
        for (axis, value) in [('x', x), ('y', y), ('z', z)] {
            if !value.is_finite() {
                return Err(Problem::NotFinite {
                    index: self.points.len() as u64,
                    axis,
                    text: value.to_string(),
                });
            }
        }
        // A negative zero, which mirroring makes, would be another text when it is written.
        self.points.push(Point::new(x + 0.0, y + 0.0));
        self.z.push(z + 0.0);
        Ok(())
    }

    /// Makes the domain, and says at how many places lines end loosely.
    pub fn finish(self) -> (DomainData, usize) {
        let loose = self.loose_ends();
        let num_loops = self.loops.len();
        let mut polygons: Vec<_> = self
            .faces
            .iter()
            .map(|f| f.start + num_loops..f.end + num_loops)
            .collect();
        let usual_rule = match (num_loops + self.lines.len(), self.faces.is_empty(), loose) {
            (0, true, _) => DomainRule::Hull,
            (_, true, 1..) => DomainRule::Hull,
            _ => DomainRule::EvenOdd,
        };
        let all_close = self.faces.is_empty() && loose == 0;
        if num_loops > 0 && !all_close {
            polygons.push(0..num_loops);
        }
        let all = [self.loops, self.borders, self.lines].concat();
        let (segments, markers): (Vec<_>, Vec<_>) = all.into_iter().unzip();
        let has_z = self.z.iter().any(|z| *z != 0.0);
        let z = has_z.then_some(Attribute {
            name: "z".to_owned(),
            values: self.z,
        });
        let domain = DomainData {
            vertices: PointSet {
                points: self.points,
                attributes: z.into_iter().collect(),
                ..PointSet::default()
            },
            segment_markers: (!segments.is_empty()).then_some(markers),
            segments,
            polygons,
            usual_rule,
            ..DomainData::default()
        };
        (domain, loose)
    }

    /// Counts the places where an odd number of lines end.
    fn loose_ends(&self) -> usize {
        let ends = self.lines.iter().flat_map(|(ends, _)| *ends);
        let mut places: Vec<_> = ends.map(|v| self.points[v.index()]).collect();
        places.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        places
            .chunk_by(|a, b| a == b)
            .filter(|same| same.len() % 2 == 1)
            .count()
    }
}
