//! Which triangle a point lies in: a tree of boxes, since walks may run in circles where triangles are not
//! Delaunay, and into bays where their outline is not convex.
//!
//! *Exact*: on the edge of several triangles the one of lowest number is found. *Cost*: building takes O(n log n); a
//! question O(log n) for triangles that are as long as wide, at worst O(n).

use crate::predicates::{Orientation, orient2d};
use crate::{Point, TriangleId, VertexId};

/// Triangles in a leaf, at most.
const LEAF: usize = 4;

/// Most nodes that wait to be looked at: one a level, and halving ends after 32 levels.
const MOST_OPEN: usize = 40;

/// The least box around some triangles, closed.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    low: Point,
    high: Point,
}

impl Bounds {
    fn of(points: impl IntoIterator<Item = Point>) -> Self {
        let (far, near) = (f64::INFINITY, f64::NEG_INFINITY);
        let none = Self {
            low: Point::new(far, far),
            high: Point::new(near, near),
        };
        points.into_iter().fold(none, |b, p| Self {
            low: Point::new(b.low.x.min(p.x), b.low.y.min(p.y)),
            high: Point::new(b.high.x.max(p.x), b.high.y.max(p.y)),
        })
    }

    fn has(&self, p: Point) -> bool {
        self.low.x <= p.x && p.x <= self.high.x && self.low.y <= p.y && p.y <= self.high.y
    }

    /// Returns about where a triangle lies along the longer side; halves and thirds, since wholes may overflow.
    fn along(&self, corners: [Point; 3]) -> f64 {
        let [low, high] = [self.low, self.high].map(|p| [p.x * 0.5, p.y * 0.5]);
        let axis = usize::from(high[1] - low[1] > high[0] - low[0]);
        corners
            .iter()
            .map(|&p| <[f64; 2]>::from(p)[axis] / 3.0)
            .sum()
    }
}

/// A node: the box around its triangles, and where the upper half of them begins its nodes; the lower half's follow
/// the node.
#[derive(Clone, Debug)]
struct Node {
    bounds: Bounds,
    upper: usize,
}

/// Triangles in a tree: below a node lie the two halves of its triangles.
#[derive(Clone, Debug)]
pub(super) struct Places {
    order: Vec<TriangleId>,
    nodes: Vec<Node>,
}

impl Places {
    pub fn new(points: &[Point], triangles: &[[VertexId; 3]]) -> Self {
        let mut order: Vec<_> = (0..triangles.len()).map(TriangleId::new).collect();
        let corners = |t: &TriangleId| triangles[t.index()].map(|v| points[v.index()]);
        let mut nodes: Vec<Node> = Vec::new();
        let mut open = vec![(0..order.len(), None)];
        while let Some((range, below)) = open.pop() {
            let node = nodes.len();
            if let Some(below) = below {
                let below: &mut Node = &mut nodes[below];
                below.upper = node;
            }
            let part = &mut order[range.clone()];
            let bounds = Bounds::of(part.iter().flat_map(corners));
            nodes.push(Node { bounds, upper: 0 });
            if part.len() > LEAF {
                let half = part.len() / 2;
                let key = |t: &TriangleId| bounds.along(corners(t));
                part.select_nth_unstable_by(half, |a, b| key(a).total_cmp(&key(b)).then(a.cmp(b)));
                let middle = range.start + half;
                open.push((middle..range.end, Some(node)));
                open.push((range.start..middle, None));
            }
        }
        Self { order, nodes }
    }

    /// Returns the triangle of lowest number in whose closure `p` lies; `corners` tells where triangles are.
    pub fn find(&self, p: Point, corners: impl Fn(TriangleId) -> [Point; 3]) -> Option<TriangleId> {
        let mut found: Option<TriangleId> = None;
        let mut open = [(0, 0, 0); MOST_OPEN];
        let mut count = 1;
        open[0] = (0, 0, self.order.len());
        while count > 0 {
            count -= 1;
            let (node, start, end) = open[count];
            let Node { bounds, upper } = &self.nodes[node];
            if !bounds.has(p) {
                continue;
            }
            if end - start > LEAF {
                let middle = start + (end - start) / 2;
                open[count] = (*upper, middle, end);
                open[count + 1] = (node + 1, start, middle);
                count += 2;
                continue;
            }
            for &t in &self.order[start..end] {
                if found.is_none_or(|f| t < f) && has(corners(t), p) {
                    found = Some(t);
                }
            }
        }
        found
    }
}

/// Tells whether a point lies in a closed triangle.
fn has([a, b, c]: [Point; 3], p: Point) -> bool {
    [[a, b], [b, c], [c, a]]
        .iter()
        .all(|&[from, to]| orient2d(from, to, p) != Orientation::Right)
}

/// Tells whether a point lies in an open triangle.
pub(super) fn has_within([a, b, c]: [Point; 3], p: Point) -> bool {
    [[a, b], [b, c], [c, a]]
        .iter()
        .all(|&[from, to]| orient2d(from, to, p) == Orientation::Left)
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone_testkit::generate::{Kind, Random};

    fn naive(t: &crate::Triangulation, p: Point) -> Option<TriangleId> {
        let corners = |[a, b, c]: [VertexId; 3]| [t.point(a), t.point(b), t.point(c)];
        let found = t.triangles().iter().position(|&v| has(corners(v), p));
        found.map(TriangleId::new)
    }

    #[test]
    fn places_are_those_of_a_look_at_all() {
        for kind in Kind::ALL {
            // The kit knows this library by another name: so do its points.
            let points = kind.points(60, 5).into_iter().map(<[f64; 2]>::from);
            let t = crate::triangulate(points).expect("finite points");
            let places = Places::new(t.points(), t.triangles());
            let corners = |f: TriangleId| t.triangles()[f.index()].map(|v| t.point(v));
            let mut random = Random::new(3);
            let at = |random: &mut Random| t.points()[random.below(t.points().len())];
            for _ in 0..200 {
                let (a, b) = (at(&mut random), at(&mut random));
                let middle = Point::new(a.x * 0.5 + b.x * 0.5, a.y * 0.5 + b.y * 0.5);
                for p in [a, middle] {
                    assert_eq!(places.find(p, corners), naive(&t, p), "{kind:?} {p:?}");
                }
            }
        }
    }

    #[test]
    fn nothing_lies_where_there_is_nothing() {
        let places = Places::new(&[], &[]);
        let nowhere = places.find(Point::new(0.0, 0.0), |_| unreachable!());
        assert_eq!(nowhere, None);
    }
}
