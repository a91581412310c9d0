//! The edges of the outline, found by where they lie: a tree of boxes.
//!
//! At first it halves the list of edges again and again; an edge that is divided becomes a node with two leaves.
//! Boxes of neighbours along the outline of a convex polygon touch, and others mostly do not. A place halves its
//! edge, or about, so no leaf is deep.
//!
//! *Cost*: linear to make; O(log h) in practice for a question, or a division, if the outline has h edges.

use crate::{Mesh, Point, VertexId};

/// The outline.
pub(in super::super) struct Rim {
    /// The root is the first.
    nodes: Vec<Node>,
    /// The leaf of the edge that starts, counter-clockwise, at each vertex.
    leaves: Vec<Option<usize>>,
}

struct Node {
    extent: [Point; 2],
    parent: Option<usize>,
    content: Content,
}

enum Content {
    /// An edge, by the vertex where it starts.
    Edge(VertexId, [Point; 2]),
    /// Nodes.
    Halves([usize; 2]),
}

impl Rim {
    /// Looks along the outline of a mesh.
    pub fn new(mesh: &Mesh, point: impl Fn(VertexId) -> Point) -> Self {
        let starts = outline(mesh);
        let ends = starts.iter().cycle().skip(1);
        let edges = starts.iter().zip(ends);
        let edges: Vec<_> = edges.map(|(&a, &b)| (a, [point(a), point(b)])).collect();
        let mut rim = Self {
            nodes: Vec::with_capacity(2 * edges.len()),
            leaves: Vec::new(),
        };
        if !edges.is_empty() {
            rim.build(&edges, None);
        }
        rim
    }

    /// Makes a node of some edges, one after the other on the outline. Recursion is as deep as their number has digits.
    fn build(&mut self, edges: &[(VertexId, [Point; 2])], parent: Option<usize>) -> usize {
        if let &[(start, ends)] = edges {
            return self.grow(start, ends, parent);
        }
        let node = self.nodes.len();
        self.nodes.push(Node {
            extent: edges[0].1,
            parent,
            content: Content::Halves([node; 2]),
        });
        let (first, second) = edges.split_at(edges.len() / 2);
        let halves = [first, second].map(|half| self.build(half, Some(node)));
        self.nodes[node].content = Content::Halves(halves);
        self.nodes[node].extent = joined(halves.map(|half| self.nodes[half].extent));
        node
    }

    /// Makes a leaf.
    fn grow(&mut self, start: VertexId, ends: [Point; 2], parent: Option<usize>) -> usize {
        let leaf = self.nodes.len();
        self.nodes.push(Node {
            extent: extent(ends),
            parent,
            content: Content::Edge(start, ends),
        });
        if self.leaves.len() <= start.index() {
            self.leaves.resize(start.index() + 1, None);
        }
        self.leaves[start.index()] = Some(leaf);
        leaf
    }

    /// Puts a vertex on the edge that starts at `start`.
    pub fn divide(&mut self, start: VertexId, v: VertexId, at: Point) {
        let known = self.leaves.get(start.index()).copied().flatten();
        let leaf = known.expect("bug: no edge of the outline starts there");
        let Content::Edge(_, [a, b]) = self.nodes[leaf].content else {
            unreachable!("bug: a leaf is an edge");
        };
        let halves = [
            self.grow(start, [a, at], Some(leaf)),
            self.grow(v, [at, b], Some(leaf)),
        ];
        self.nodes[leaf].content = Content::Halves(halves);
        let mut above = Some(leaf);
        while let Some(node) = above {
            let grown = joined([self.nodes[node].extent, [at, at]]);
            if grown == self.nodes[node].extent {
                return;
            }
            self.nodes[node].extent = grown;
            above = self.nodes[node].parent;
        }
    }

    /// Tells whether an edge is as asked for, other than the one that starts at `start`, of all whose boxes meet that of
    /// some points.
    pub fn has_near(
        &self,
        points: [Point; 3],
        start: VertexId,
        is_wanted: impl Fn([Point; 2]) -> bool,
    ) -> bool {
        let [a, b, c] = points;
        let here = joined([extent([a, b]), [c, c]]);
        let mut open: Vec<usize> = (0..self.nodes.len().min(1)).collect();
        while let Some(node) = open.pop() {
            let node = &self.nodes[node];
            if !do_meet(node.extent, here) {
                continue;
            }
            match node.content {
                Content::Halves(halves) => open.extend(halves),
                Content::Edge(other, ends) if other != start && is_wanted(ends) => return true,
                Content::Edge(..) => {}
            }
        }
        false
    }
}

/// Lists the vertices of the outline, counter-clockwise.
fn outline(mesh: &Mesh) -> Vec<VertexId> {
    let Some(ghost) = mesh.ghosts().next() else {
        return Vec::new();
    };
    let all = mesh.hull(mesh.hull_edge_of(ghost));
    // They run clockwise.
    all.map(|g| mesh.dest(g)).collect()
}

/// The box of two points: its lower left and its upper right corner.
fn extent([a, b]: [Point; 2]) -> [Point; 2] {
    joined([[a, a], [b, b]])
}

/// The box of two boxes.
fn joined([[a, b], [c, d]]: [[Point; 2]; 2]) -> [Point; 2] {
    [
        Point::new(a.x.min(c.x), a.y.min(c.y)),
        Point::new(b.x.max(d.x), b.y.max(d.y)),
    ]
}

fn do_meet([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    a.x <= d.x && c.x <= b.x && a.y <= d.y && c.y <= b.y
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::triangulate;
    use proptest::prelude::*;

    /// The edges of the outline after some have been divided, as a plain list.
    fn divided(rim: &mut Rim, edges: &mut Vec<(usize, [Point; 2])>, place: usize, next: usize) {
        let place = place % edges.len();
        let (start, [a, b]) = edges[place];
        let at = Point::new(f64::midpoint(a.x, b.x), f64::midpoint(a.y, b.y) - 0.25);
        rim.divide(VertexId::new(start), VertexId::new(next), at);
        edges[place].1 = [a, at];
        edges.push((next, [at, b]));
    }

    proptest! {
        #[test]
        fn what_is_near_is_found(
            points in prop::collection::vec((-20i32..20, -20i32..20), 3..40),
            places in prop::collection::vec(0usize..1000, 0..20),
            [x, y, z] in prop::array::uniform3((-25i32..25, -25i32..25)),
        ) {
            let points: Vec<_> = points.into_iter().map(|(x, y)| (f64::from(x), f64::from(y))).collect();
            let Ok(t) = triangulate(points) else { return Ok(()) };
            let mut rim = Rim::new(t.mesh(), |v| t.point(v));
            let starts = outline(t.mesh());
            let ends = starts.iter().cycle().skip(1);
            let edge = |(a, b): (&VertexId, &VertexId)| (a.index(), [t.point(*a), t.point(*b)]);
            let mut edges: Vec<_> = starts.iter().zip(ends).map(edge).collect();
            prop_assume!(!edges.is_empty());
            for (k, place) in places.into_iter().enumerate() {
                divided(&mut rim, &mut edges, place, t.points().len() + k);
            }
            let here = [x, y, z].map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
            let region = joined([extent([here[0], here[1]]), [here[2]; 2]]);
            for &(start, own) in &edges {
                // Each is found unless it is left out, and only if it is near.
                let is_near = do_meet(extent(own), region);
                let has = |except| rim.has_near(here, VertexId::new(except), |ends| ends == own);
                prop_assert_eq!(has(usize::from(u16::MAX)), is_near);
                prop_assert!(!has(start));
            }
        }
    }
}
