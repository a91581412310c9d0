//! The edges of a Delaunay triangulation, each vertex with its neighbours at hand.

use crate::pace::Pace;
use crate::{Error, HalfEdgeId, Phase, Point, Triangulation, VertexId, Watch};

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
    /// Collects the edges.
    ///
    /// *Cost*: linear.
    pub fn new(t: &Triangulation, watch: &dyn Watch) -> Result<Self, Error> {
        let mesh = t.mesh();
        let (names, first) = vertices(t);
        debug_assert_eq!(names.len(), t.num_vertices(), "a vertex is in no face");
        let mut place = vec![0; t.points().len()];
        for (v, name) in (0..).zip(&names) {
            place[name.index()] = v;
        }
        let mut pace = Pace::new(watch, Phase::Export, names.len() as u64);
        let mut starts = Vec::with_capacity(names.len() + 1);
        let mut neighbors = Vec::with_capacity(3 * mesh.num_faces());
        starts.push(0);
        for &h in &first {
            pace.step()?;
            let ends = mesh.star(h).map(|g| mesh.dest(g));
            neighbors.extend(ends.filter(|w| !w.is_infinite()).map(|w| place[w.index()]));
            starts.push(neighbors.len() as u32);
        }
        pace.finish();
        // A single vertex has no half-edge.
        starts.resize(names.len() + 1, 0);
        Ok(Self {
            points: names.iter().map(|&v| t.point(v)).collect(),
            names,
            starts,
            neighbors,
        })
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
