//! Triangles of six nodes: the corners, and the midpoint of each edge.
//!
//! As in Triangle, midpoints are numbered behind all vertices, and nodes 4, 5 and 6 of a triangle
//! lie on the edges opposite its corners 1, 2 and 3. A midpoint has the marker of its edge and the
//! means of the attributes of its ends. Edges are straight: what a file says about the place of a
//! midpoint is not looked at when it is read.
//!
//! *Cost*: linear.

use crate::constraints::{EdgeIndex, EdgeMarkers};
use crate::topology::Topology;
use crate::{Attribute, Error, MeshView, PointSet, Problem, node};
use delone::{Point, VertexId, Watch};

/// The nodes of a mesh, midpoints included.
pub(crate) struct SixNodes {
    points: Vec<Point>,
    attributes: Vec<Attribute>,
    /// Markers of the nodes; those of vertices are the caller's, if there are any.
    pub markers: Vec<i32>,
    middles: Middles,
}

/// Where the midpoints of edges are.
#[derive(Debug)]
pub(crate) struct Middles {
    /// For each triangle those opposite its corners.
    pub of_triangles: Vec<[VertexId; 3]>,
    /// For each constrained edge its midpoint, if it has a triangle.
    pub of_constrained: Vec<Option<VertexId>>,
}

impl SixNodes {
    /// Puts a node into the middle of every edge of a triangle.
    pub fn new(
        mesh: &MeshView<'_>,
        topology: &Topology,
        markers: &[i32],
        edge_markers: &EdgeMarkers,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        let vertices = mesh.points.len();
        let sides = topology.sides(mesh.triangles, watch)?;
        // Edges without triangles come last, and have none.
        let edges = sides.as_flattened().iter().max().map_or(0, |&e| e + 1) as usize;
        let ends: Vec<_> = topology.edges[..edges].iter().map(|e| e.ends).collect();
        let limit = node::MAX_POINTS as usize;
        if vertices + edges > limit {
            let nodes = vertices + edges;
            return Err(Error::BadMesh(format!(
                "{nodes} nodes, midpoints included, but at most {limit} are possible; write linear \
                 triangles"
            )));
        }
        let node = |edge: usize| VertexId::new(vertices + edge);
        let middles = Middles {
            of_triangles: sides
                .iter()
                .map(|row| row.map(|e| node(e as usize)))
                .collect(),
            of_constrained: of_constrained(mesh, &ends, node),
        };
        let position = |v: u32| mesh.points[v as usize];
        let middle = |&[a, b]: &[u32; 2]| {
            let (a, b) = (position(a), position(b));
            Point::new(a.x.midpoint(b.x), a.y.midpoint(b.y))
        };
        Ok(Self {
            points: extended(mesh.points, ends.iter().map(middle)),
            attributes: mesh.attributes.iter().map(|a| of_nodes(a, &ends)).collect(),
            markers: extended(markers, edge_markers.all[..edges].iter().copied()),
            middles,
        })
    }

    /// Shows the mesh with all its nodes.
    pub fn view<'a>(&'a self, mesh: &MeshView<'a>) -> MeshView<'a> {
        MeshView {
            points: &self.points,
            attributes: &self.attributes,
            markers: mesh.markers.map(|_| &self.markers[..]),
            middles: Some(&self.middles),
            ..*mesh
        }
    }
}

fn extended<T: Copy>(of_vertices: &[T], of_edges: impl ExactSizeIterator<Item = T>) -> Vec<T> {
    let mut all = Vec::with_capacity(of_vertices.len() + of_edges.len());
    all.extend_from_slice(of_vertices);
    all.extend(of_edges);
    all
}

fn of_nodes(attribute: &Attribute, ends: &[[u32; 2]]) -> Attribute {
    let values = &attribute.values;
    let mean = |ends: &[u32; 2]| {
        let [low, high] = ends.map(|v| values[v as usize]);
        low.midpoint(high)
    };
    Attribute {
        name: attribute.name.clone(),
        values: extended(values, ends.iter().map(mean)),
    }
}

fn of_constrained(
    mesh: &MeshView<'_>,
    ends: &[[u32; 2]],
    node: impl Fn(usize) -> VertexId,
) -> Vec<Option<VertexId>> {
    let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
    let index = EdgeIndex::new(edges, mesh.points.len());
    let mut middles = vec![None; edges.len()];
    for (e, ends) in ends.iter().enumerate() {
        if let Some(constrained) = index.find(ends.map(VertexId::from)) {
            middles[constrained] = Some(node(e));
        }
    }
    middles
}

/// Takes the midpoints out of nodes that were read, so that only vertices of triangles, and loose
/// ones, are left; `middles` lists those of all triangles and edges.
///
/// They must come behind all others, as they do in Triangle: what names a vertex by its number then
/// stays right.
pub(crate) fn drop_midpoints(
    nodes: &mut PointSet,
    triangles: &[[VertexId; 3]],
    middles: &[VertexId],
) -> Result<(), Problem> {
    let number = |v: usize| v + nodes.base as usize;
    let mut is_middle = vec![false; nodes.points.len()];
    middles.iter().for_each(|v| is_middle[v.index()] = true);
    let mut corners = triangles.as_flattened().iter();
    if let Some(v) = corners.find(|v| is_middle[v.index()]) {
        let v = number(v.index());
        return Err(Problem::Other(format!(
            "node {v} is a corner of one triangle and a midpoint of another"
        )));
    }
    let first = is_middle.iter().position(|&m| m);
    let vertices = first.unwrap_or(is_middle.len());
    if let Some(behind) = is_middle[vertices..].iter().position(|&m| !m) {
        let [middle, other] = [vertices, vertices + behind].map(number);
        return Err(Problem::Other(format!(
            "node {middle} is a midpoint, but node {other} behind it is none; number midpoints last"
        )));
    }
    nodes.points.truncate(vertices);
    for attribute in &mut nodes.attributes {
        attribute.values.truncate(vertices);
    }
    if let Some(markers) = &mut nodes.markers {
        markers.truncate(vertices);
    }
    Ok(())
}
