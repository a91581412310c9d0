//! Where trouble is: places, points and segments of a drawing, or a line of a file.

use delone::{Error, Facts, Point, VertexId};
use delone_io::Place;
use std::collections::BTreeSet;

/// Crossings that are marked; more are a mess in any picture.
const MOST_CROSSINGS: usize = 100;

/// What is to be marked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marks {
    /// Coordinates of places, x and y in turns.
    pub places: Vec<f64>,
    /// Numbers of segments.
    pub segments: Vec<u32>,
    /// Numbers of points.
    pub points: Vec<u32>,
    /// A line of the file, from 1.
    pub line: Option<u64>,
}

impl Marks {
    /// Marks what an error of the library names.
    pub fn of(error: &Error) -> Self {
        let mut marks = Self::default();
        match error {
            Error::NotFinite { index, .. }
            | Error::BadSize { index, .. }
            | Error::BadWeight { index, .. }
            | Error::WeightNotPositive { index, .. } => marks.points.push(*index as u32),
            Error::BadSegment { segment, .. } => marks.segments.push(*segment as u32),
            Error::Crossing { segments, at } => {
                marks.segments.extend(segments.map(|s| s as u32));
                marks.place(*at);
            }
            Error::SharedSegment { segment, .. } => marks.segments.push(*segment as u32),
            Error::OpenPolygon { vertex, .. } | Error::ValueNotFinite { vertex, .. } => {
                marks.vertices(&[*vertex]);
            }
            Error::SeedNotFinite { at, .. } => marks.place(*at),
            Error::SeedOnSegment { at, segment, .. } => {
                marks.segments.push(*segment as u32);
                marks.place(*at);
            }
            Error::ValuesDiffer { vertices, .. } => marks.vertices(vertices),
            Error::NotDelaunay { edge } | Error::SameSide { edge, .. } => marks.vertices(edge),
            Error::DatumOutside { datum, at } => {
                marks.points.push(*datum as u32);
                marks.place(*at);
            }
            Error::BadHolder { datum, .. } => marks.points.push(*datum as u32),
            Error::DomainTooEmpty { triangle, .. } => {
                triangle.iter().for_each(|&corner| marks.place(corner));
            }
            _ => {}
        }
        marks
    }

    /// Marks what an error of a file names: a line. Points have there the numbers of the file.
    pub fn of_file(error: &delone_io::Error) -> Self {
        let delone_io::Error::Malformed { place, .. } = error else {
            return Self::default();
        };
        let line = match *place {
            Place::Line(line) | Place::Column(line, _) => Some(line),
            _ => None,
        };
        Self {
            line,
            ..Self::default()
        }
    }

    /// Marks more crossings, and the segments that cross there. Those in a vertex are none to be refused.
    pub fn add_crossings(&mut self, facts: &Facts) {
        let on = &facts.on_segments;
        if on.count > on.first.len() as u64 {
            // Who crosses in a vertex is not known then.
            return;
        }
        let on: BTreeSet<_> = on.first.iter().map(|on| (on.segment, on.vertex)).collect();
        let of = |s: usize| on.range((s, VertexId::new(0))..(s + 1, VertexId::new(0)));
        let is_in_vertex = |[s, t]: [usize; 2]| of(s).any(|&(_, v)| on.contains(&(t, v)));
        let refused = facts.crossings.first.iter();
        let refused = refused.filter(|crossing| !is_in_vertex(crossing.segments));
        for crossing in refused.take(MOST_CROSSINGS) {
            self.place(crossing.at);
            self.segments.extend(crossing.segments.map(|s| s as u32));
        }
        self.segments.sort_unstable();
        self.segments.dedup();
    }

    /// Marks the places of the points that are marked.
    pub fn place_points(&mut self, points: &[Point]) {
        let numbers = self.points.clone();
        let known = numbers.iter().filter_map(|&i| points.get(i as usize));
        known.for_each(|&p| self.place(p));
    }

    fn vertices(&mut self, vertices: &[VertexId]) {
        let numbers = vertices.iter().map(|v| v.index() as u32);
        self.points.extend(numbers);
    }

    /// Marks a place, if it is one, and once.
    fn place(&mut self, at: Point) {
        let (known, _) = self.places.as_chunks::<2>();
        if at.is_finite() && !known.contains(&[at.x, at.y]) {
            self.places.extend([at.x, at.y]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;
    use crate::mesh::Mesh;
    use delone::Seed;

    fn marks(points: &[f64], segments: &[u32], holes: &[f64]) -> Marks {
        let drawing = Drawing::new(points, segments, holes).expect("a drawing");
        let refused = Mesh::constrain(&drawing, None, None);
        refused.err().expect("something is wrong").marks()
    }

    #[test]
    fn all_crossings_are_marked() {
        // A line across two others.
        let points = [0.0, 0.0, 4.0, 0.0, 1.0, -1.0, 1.0, 1.0, 2.0, -1.0, 2.0, 1.0];
        let found = marks(&points, &[0, 1, 2, 3, 4, 5], &[]);
        assert_eq!(found.places, [1.0, 0.0, 2.0, 0.0]);
        assert_eq!(found.segments, [0, 1, 2]);
    }

    /// The two diagonals meet in a vertex, which is in order; a third line crosses one of them beside it.
    #[test]
    fn crossings_in_a_vertex_are_in_order() {
        let points = [
            0.0, 0.0, 4.0, 4.0, 0.0, 4.0, 4.0, 0.0, 2.0, 2.0, 0.0, 2.0, 2.0, 0.0,
        ];
        let found = marks(&points, &[0, 1, 2, 3, 5, 6], &[]);
        assert_eq!(found.places, [1.0, 1.0]);
        assert_eq!(found.segments, [0, 2]);
    }

    #[test]
    fn points_and_seeds_are_marked() {
        let nowhere = marks(&[0.0, 0.0, 1.0, f64::NAN], &[], &[]);
        assert_eq!((nowhere.points, nowhere.places), (vec![1], vec![]));
        let triangle = [0.0, 0.0, 4.0, 0.0, 0.0, 4.0];
        let on = marks(&triangle, &[0, 1, 1, 2, 2, 0], &[1.0, 0.0]);
        assert_eq!((on.segments, on.places), (vec![0], vec![1.0, 0.0]));
    }

    /// Its number would be taken for that of one.
    #[test]
    fn a_seed_is_no_point() {
        let at = Point::new(1.0, 2.0);
        let seed = Seed::Hole(3);
        let segment = 7;
        let found = Marks::of(&Error::SeedOnSegment { seed, at, segment });
        assert!(found.points.is_empty());
    }

    #[test]
    fn open_polygons_are_marked_where_they_are_open() {
        let at = Point::new(4.0, 5.0);
        let mut found = Marks::of(&Error::OpenPolygon {
            polygon: 0,
            vertex: VertexId::new(1),
            at,
        });
        found.place_points(&[Point::new(0.0, 0.0), at]);
        assert_eq!((found.points, found.places), (vec![1], vec![4.0, 5.0]));
    }
}
