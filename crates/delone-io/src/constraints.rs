//! What is constrained in a mesh: edges with markers, holes, regions.

use crate::topology::Topology;
use crate::{Error, MeshView, cancel};
use delone::{Point, Region, VertexId, Watch};
use std::ops::Range;

/// Constrained edges of a mesh, and what lies between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Constraints {
    /// The constrained edges, each once, those outside of the triangles included.
    pub edges: Vec<[VertexId; 2]>,
    /// A marker for each of them; as in Triangle, those without and those of marker 0 count as 1 on
    /// the boundary of the triangles, and as 0 elsewhere.
    pub markers: Option<Vec<i32>>,
    /// A point in each hole.
    pub holes: Vec<Point>,
    /// Regions, each named by a point in it.
    pub regions: Vec<Region>,
    /// For each triangle its region, if that is known.
    pub region_of: Option<Vec<Option<u32>>>,
    /// The vertices that were added where segments cross, if that is known.
    pub crossings: Range<usize>,
}

impl Constraints {
    /// Tells whether there are no edges, holes and regions.
    pub(crate) fn is_empty(&self) -> bool {
        self.edges.is_empty() && !self.has_seeds()
    }

    /// Tells whether there are holes or regions, named by points.
    pub(crate) fn has_seeds(&self) -> bool {
        !self.holes.is_empty() || !self.regions.is_empty()
    }

    /// Returns the marker of a constrained edge; 0 is none.
    fn marker(&self, edge: usize) -> i32 {
        self.markers.as_ref().map_or(0, |markers| markers[edge])
    }

    /// Checks that edges join vertices, regions exist and every table has the right length.
    pub(crate) fn validate(&self, num_vertices: usize, num_triangles: usize) -> Result<(), Error> {
        let bad = |text: String| Err(Error::BadMesh(text));
        for (e, edge) in self.edges.iter().enumerate() {
            if let Some(v) = edge.iter().find(|v| v.index() >= num_vertices) {
                return bad(format!(
                    "constrained edge {e} names vertex {v} of {num_vertices} (numbered from 0)"
                ));
            }
        }
        let edges = self.edges.len();
        let markers = self.markers.as_ref().map_or(edges, Vec::len);
        if markers != edges {
            return bad(format!("{markers} markers for {edges} constrained edges"));
        }
        if self.crossings.end > num_vertices {
            let end = self.crossings.end;
            return bad(format!("crossings up to vertex {end} of {num_vertices}"));
        }
        let Some(region_of) = &self.region_of else {
            return Ok(());
        };
        if region_of.len() != num_triangles {
            let found = region_of.len();
            return bad(format!("regions of {found} triangles for {num_triangles}"));
        }
        let regions = self.regions.len();
        match region_of.iter().flatten().find(|&&r| r as usize >= regions) {
            Some(region) => bad(format!("a triangle in region {region} of {regions}")),
            None => Ok(()),
        }
    }
}

/// Finds constrained edges by their ends.
pub(crate) struct EdgeIndex {
    /// For each vertex where the edges begin of which it is the lower end; one more at the end.
    starts: Vec<usize>,
    /// The higher end and the index of each edge.
    edges: Vec<(VertexId, usize)>,
}

impl EdgeIndex {
    /// *Cost*: linear.
    pub fn new(edges: &[[VertexId; 2]], num_vertices: usize) -> Self {
        // Counts stand two places further on, so that after summing, and filling, they are beginnings.
        let mut starts = vec![0; num_vertices + 2];
        for [a, b] in edges {
            starts[a.min(b).index() + 2] += 1;
        }
        for v in 1..starts.len() {
            starts[v] += starts[v - 1];
        }
        let mut sorted = vec![(VertexId::INFINITE, 0); edges.len()];
        for (e, &[a, b]) in edges.iter().enumerate() {
            let place = &mut starts[a.min(b).index() + 1];
            sorted[*place] = (a.max(b), e);
            *place += 1;
        }
        Self {
            starts,
            edges: sorted,
        }
    }

    /// Returns the index of an edge, if it is constrained. *Cost*: proportional to the constrained
    /// edges at its lower end.
    pub fn find(&self, [a, b]: [VertexId; 2]) -> Option<usize> {
        let low = a.min(b).index();
        let range = self.starts[low]..self.starts[low + 1];
        let same = self.edges[range].iter().find(|edge| edge.0 == a.max(b));
        same.map(|&(_, e)| e)
    }
}

/// Markers of edges by the rule of Triangle: their own, or 1 on the boundary, or 0.
#[derive(Default)]
pub(crate) struct EdgeMarkers {
    /// Of all edges of the mesh.
    pub all: Vec<i32>,
    /// Of the constrained edges, those included that have no triangle.
    pub constrained: Vec<i32>,
}

impl EdgeMarkers {
    /// *Cost*: linear, if few constrained edges meet in a vertex.
    pub fn new(mesh: &MeshView<'_>, topology: &Topology, watch: &dyn Watch) -> Result<Self, Error> {
        let none = Constraints::default();
        let constraints = mesh.constraints.unwrap_or(&none);
        let index = EdgeIndex::new(&constraints.edges, mesh.points.len());
        // Without triangle, an edge is on the boundary as if it had one.
        let mut constrained: Vec<_> = (0..constraints.edges.len())
            .map(|e| or_boundary(constraints.marker(e), true))
            .collect();
        let mut all = Vec::with_capacity(topology.edges.len());
        for (i, edge) in topology.edges.iter().enumerate() {
            cancel::check(watch, i)?;
            let found = index.find(edge.ends.map(VertexId::from));
            let own = found.map_or(0, |e| constraints.marker(e));
            let marker = or_boundary(own, edge.on_boundary);
            if let Some(e) = found {
                constrained[e] = marker;
            }
            all.push(marker);
        }
        Ok(Self { all, constrained })
    }
}

fn or_boundary(marker: i32, on_boundary: bool) -> i32 {
    match marker {
        0 => on_boundary.into(),
        marker => marker,
    }
}

#[cfg(test)]
mod tests {
    use super::{Constraints, EdgeIndex};
    use delone::{Region, VertexId};

    fn edges() -> Vec<[VertexId; 2]> {
        [[3, 1], [0, 1], [1, 2], [4, 0]]
            .map(|e| e.map(VertexId::new))
            .to_vec()
    }

    #[test]
    fn edges_are_found_from_both_ends() {
        let edges = edges();
        let index = EdgeIndex::new(&edges, 5);
        for (e, &[a, b]) in edges.iter().enumerate() {
            assert_eq!(index.find([a, b]), Some(e));
            assert_eq!(index.find([b, a]), Some(e));
        }
        assert_eq!(index.find([edges[0][0], edges[2][1]]), None);
        assert_eq!(index.find([edges[3][0], edges[3][0]]), None);
    }

    #[test]
    fn tables_of_wrong_length_are_refused() {
        let good = Constraints {
            edges: edges(),
            markers: Some(vec![1; 4]),
            regions: vec![Region {
                at: delone::Point::new(0.0, 0.0),
                attribute: 1.0,
                max_area: None,
            }],
            region_of: Some(vec![Some(0), None]),
            ..Constraints::default()
        };
        assert!(good.validate(5, 2).is_ok());
        assert!(good.validate(4, 2).is_err(), "a vertex");
        assert!(good.validate(5, 3).is_err(), "a triangle");
        let mut bad = good.clone();
        bad.markers = Some(vec![1; 3]);
        assert!(bad.validate(5, 2).is_err(), "a marker");
        let mut bad = good.clone();
        bad.crossings = 4..6;
        assert!(bad.validate(5, 2).is_err(), "a crossing");
        let mut bad = good;
        bad.regions.clear();
        assert!(bad.validate(5, 2).is_err(), "a region");
    }
}
