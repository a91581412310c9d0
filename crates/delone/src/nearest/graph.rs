//! The edges of a Delaunay triangulation, each vertex with its neighbours at hand.

use crate::predicates::{CircleSide, in_circle};
use crate::{HalfEdgeId, Point, Triangulation, VertexId};

/// Vertices in the order in which triangles name them first, which keeps neighbours together, since builders
/// number triangles along a space-filling curve.
#[derive(Clone, Debug)]
pub(super) struct Graph {
    pub points: Vec<Point>,
    /// The caller's number of each vertex.
    pub names: Vec<VertexId>,
    /// Where the neighbours of each vertex begin; one more at the end.
    starts: Vec<u32>,
    neighbors: Vec<u32>,
}

impl Graph {
    /// Collects the edges; `None` if it is not the graph of a Delaunay triangulation of all points.
    ///
    /// *Cost*: linear, one in-circle test for each edge.
    pub fn of(t: &Triangulation) -> Option<Self> {
        let (names, first) = vertices(t);
        (names.len() == t.num_vertices() && is_delaunay(t)).then(|| Self::new(t, names, &first))
    }

    /// Collects the neighbours of the vertices `names`, given a half-edge from each.
    fn new(t: &Triangulation, names: Vec<VertexId>, first: &[HalfEdgeId]) -> Self {
        let mesh = t.mesh();
        let mut place = vec![0; t.points().len()];
        for (v, name) in (0..).zip(&names) {
            place[name.index()] = v;
        }
        let mut starts = Vec::with_capacity(names.len() + 1);
        let mut neighbors = Vec::with_capacity(2 * t.num_edges().max(mesh.num_faces()));
        starts.push(0);
        for &h in first {
            let ends = mesh.star(h).map(|g| mesh.dest(g));
            neighbors.extend(ends.filter(|w| !w.is_infinite()).map(|w| place[w.index()]));
            starts.push(neighbors.len() as u32);
        }
        // A single vertex has no half-edge.
        starts.resize(names.len() + 1, 0);
        Self {
            points: names.iter().map(|&v| t.point(v)).collect(),
            names,
            starts,
            neighbors,
        }
    }

    /// Returns the neighbours of a vertex; none only if there is no other.
    #[inline]
    pub fn neighbors(&self, v: u32) -> &[u32] {
        let range = self.starts[v as usize] as usize..self.starts[v as usize + 1] as usize;
        &self.neighbors[range]
    }
}

/// Lists the vertices in the order in which faces name them, each with a half-edge that starts there.
fn vertices(t: &Triangulation) -> (Vec<VertexId>, Vec<HalfEdgeId>) {
    let corners = t.mesh().faces().as_flattened();
    if corners.is_empty() {
        let only = (!t.points().is_empty()).then_some(VertexId::new(0));
        return (only.into_iter().collect(), Vec::new());
    }
    let mut is_named = vec![false; t.points().len()];
    let (mut names, mut first) = (Vec::new(), Vec::new());
    for (i, &v) in corners.iter().enumerate() {
        if !v.is_infinite() && !std::mem::replace(&mut is_named[v.index()], true) {
            names.push(v);
            // Half-edge i lies opposite the corner; the one before starts in it.
            first.push(HalfEdgeId::new(i).prev());
        }
    }
    (names, first)
}

/// Tells whether no vertex lies inside the circle of a triangle beside its own. Carved faces count.
fn is_delaunay(t: &Triangulation) -> bool {
    let mesh = t.mesh();
    let is_locally = |h: HalfEdgeId| {
        let twin = mesh.twin(h);
        let [c, d] = [mesh.apex(h), mesh.apex(twin)];
        if twin < h
            || [c, d, mesh.origin(h), mesh.dest(h)]
                .iter()
                .any(|v| v.is_infinite())
        {
            return true;
        }
        let [a, b, c, d] = [mesh.origin(h), mesh.dest(h), c, d].map(|v| t.point(v));
        in_circle(a, b, c, d) != CircleSide::Inside
    };
    mesh.half_edges().all(is_locally)
}
