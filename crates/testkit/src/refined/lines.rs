//! Which vertices lie on which segments.

use super::{Shape, at};
use delone::predicates::{Orientation, orient2d};
use delone::{ConstrainedTriangulation, Point, VertexId};
use std::collections::BTreeMap;

/// The segments through each vertex.
pub(super) struct Lines<'a> {
    mesh: &'a ConstrainedTriangulation,
    through: BTreeMap<VertexId, Vec<usize>>,
}

impl<'a> Lines<'a> {
    pub(super) fn new(mesh: &'a ConstrainedTriangulation) -> Self {
        let mut through: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for segment in 0..mesh.segments().len() {
            for &v in mesh.chain(segment) {
                through.entry(v).or_default().push(segment);
            }
        }
        Self { mesh, through }
    }

    /// Lists the segments through a vertex, its ends' included.
    pub(super) fn through(&self, v: VertexId) -> &[usize] {
        self.through.get(&v).map_or(&[], Vec::as_slice)
    }

    /// Lists the angles, in degrees, at which two segments, as they were drawn, leave a vertex of both; up
    /// to four if they run through it. Segments that lie on each other make no angle.
    pub(super) fn angles(&self, v: VertexId, [s, t]: [usize; 2]) -> Vec<f64> {
        let is_on_line = |[a, b]: [Point; 2], p: Point| orient2d(a, b, p) == Orientation::Collinear;
        let [p, q] = [s, t].map(|segment| self.ends(segment));
        let is_one_line = q.into_iter().all(|end| is_on_line(p, end));
        let ways = |segment: usize| self.directions(v, segment);
        let pairs = ways(s).flat_map(|a| ways(t).map(move |b| [Point::new(0.0, 0.0), a, b]));
        let angles = pairs.map(|corner| Shape::of(corner).angles[0]);
        angles
            .filter(|&angle| angle > 90.0 || !is_one_line)
            .collect()
    }

    /// Visits the one or two directions in which a segment leaves a vertex of its chain.
    fn directions(&self, v: VertexId, segment: usize) -> impl Iterator<Item = Point> + use<> {
        let corner = at(self.mesh, v);
        let [a, b] = self.ends(segment);
        let ways = [(b, [a, b]), (a, [b, a])].into_iter();
        ways.filter(move |&(end, _)| end != corner)
            .map(|(_, [from, to])| difference(from, to))
    }

    fn ends(&self, segment: usize) -> [Point; 2] {
        let chain = self.mesh.chain(segment);
        [chain[0], chain[chain.len() - 1]].map(|v| at(self.mesh, v))
    }
}

/// The difference of two points, or half of it where that would overflow.
fn difference(from: Point, to: Point) -> Point {
    let whole = Point::new(to.x - from.x, to.y - from.y);
    match whole.is_finite() {
        true => whole,
        false => Point::new(to.x / 2.0 - from.x / 2.0, to.y / 2.0 - from.y / 2.0),
    }
}
