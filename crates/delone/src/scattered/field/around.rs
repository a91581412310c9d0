//! Which triangle around a vertex contains a point, if there are many: by bisection of the angle.

use super::Field;
use super::deal::contains;
use crate::predicates::{Orientation, orient2d};
use crate::scattered::stock::Held;
use crate::{Error, Observer, Point, TriangleId, VertexId};

/// Triangles around a vertex from which on bisection is worth it.
pub(super) const MANY: usize = 24;

impl<O: Observer> Field<'_, O> {
    /// Gives each of `held` to the triangle at vertex `v` that contains it. Their lists are empty.
    ///
    /// *Cost*: O(log k) for each datum, for k triangles.
    pub(super) fn deal_around(&mut self, v: VertexId, held: &[Held]) -> Result<(), Error> {
        let fan = Fan::of(self, v);
        for &held in held {
            let p = self.data.points[held.datum()];
            let t = fan.triangles[fan.find(p)];
            let is_on_border = contains(&self.corners(t), p);
            let is_on_border =
                is_on_border.expect("bug: the triangles do not cover what they replace");
            self.stock.give(t, Held::new(held.datum(), is_on_border));
        }
        for &t in &fan.triangles {
            self.stock.touch(t);
        }
        self.spend(8 * held.len())
    }
}

/// Triangles around a vertex, counter-clockwise; at the outline, from its edge on.
struct Fan {
    hub: Point,
    triangles: Vec<TriangleId>,
    /// Where the edge ends that begins at the hub and has each triangle to its left.
    ends: Vec<Point>,
    /// Whether it turns away from the first by more than a straight angle.
    is_beyond: Vec<bool>,
}

impl Fan {
    fn of(field: &Field<impl Observer>, v: VertexId) -> Self {
        let mesh = &field.draft.mesh;
        let first = field
            .draft
            .star(v)
            .find(|&h| field.is_outer(h) && !mesh.is_ghost(h.triangle()));
        let first = first.or_else(|| field.draft.star(v).next());
        let star = mesh.star(first.expect("bug: the vertex is not in the mesh"));
        let spokes: Vec<_> = star.filter(|h| !mesh.is_ghost(h.triangle())).collect();
        let hub = field.draft.point(v);
        let ends: Vec<_> = spokes
            .iter()
            .map(|&h| field.draft.point(mesh.dest(h)))
            .collect();
        let is_beyond = ends
            .iter()
            .map(|&end| orient2d(hub, ends[0], end) == Orientation::Right);
        Self {
            hub,
            triangles: spokes.iter().map(|h| h.triangle()).collect(),
            is_beyond: is_beyond.collect(),
            ends,
        }
    }

    /// Finds the last edge that lies not beyond `p`, as the angle from the first edge grows.
    fn find(&self, p: Point) -> usize {
        let first = self.ends[0];
        let side = orient2d(self.hub, first, p);
        if side == Orientation::Collinear && self.hub.lex_cmp(&first) == self.hub.lex_cmp(&p)
            || p == self.hub
        {
            return 0;
        }
        let is_beyond = side == Orientation::Right;
        let is_before = |k: usize| match (self.is_beyond[k], is_beyond) {
            (false, true) => true,
            (true, false) => false,
            // Both within a straight angle, neither opposite to the other.
            _ => orient2d(self.hub, self.ends[k], p) != Orientation::Right,
        };
        // The first edge is before everything.
        let (mut low, mut high) = (0, self.ends.len());
        while high - low > 1 {
            let middle = low.midpoint(high);
            if is_before(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scattered::data::Data;

    /// A wheel whose hub is amid data on all spokes, between them, and on itself.
    #[test]
    fn data_around_a_hub_are_dealt_out_right() {
        let steps: Vec<i32> = (-4..=4).collect();
        let square = |k: i32| {
            steps
                .iter()
                .flat_map(move |&i| [(i, -k), (i, k), (-k, i), (k, i)])
        };
        let mut rim: Vec<(i32, i32)> = square(4).collect();
        rim.sort_by(|a, b| {
            f64::from(a.1)
                .atan2(f64::from(a.0))
                .total_cmp(&f64::from(b.1).atan2(f64::from(b.0)))
        });
        rim.dedup();
        let to = |(x, y): (i32, i32)| Point::new(f64::from(x), f64::from(y));
        let data = (1..=4).flat_map(square).chain([(0, 0)]).map(to);
        let data = Data::new(data).unwrap();
        let mut nobody = ();
        for turn in 0..rim.len() {
            rim.rotate_left(1);
            let mut field = Field::new(&data, 1, &(), &mut nobody);
            let n = rim.len();
            let fan = |k: usize| [0, 1 + k, 1 + (k + 1) % n].map(VertexId::new);
            let triangles: Vec<_> = (0..n).map(fan).collect();
            let points = std::iter::once((0, 0))
                .chain(rim.iter().copied())
                .map(to)
                .collect();
            field.lay_out(points, &triangles).unwrap();
            let all: Vec<_> = field.draft.mesh.triangles().collect();
            let held: Vec<_> = all.iter().flat_map(|&t| field.stock.take(t)).collect();
            assert_eq!(held.len(), data.points.len());
            field.deal_around(VertexId::new(0), &held).unwrap();
            let count: usize = all.iter().map(|&t| field.stock.count(t)).sum();
            assert_eq!(count, held.len(), "turned by {turn}");
        }
    }
}
