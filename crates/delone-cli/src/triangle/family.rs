//! What Triangle's files hold beyond points and triangles: markers, and the segments that are left.
//!
//! An edge has the marker of its segment or, if that is 0, 1 on the border. Segments with no triangle at
//! either side are gone, unlike in our other files.

use super::switches::Switches;
use crate::refinable::Ancestors;
use delone::{ConstrainedTriangulation, HalfEdgeId, TriangleId, VertexId};
use delone_io::{Attribute, Constraints, Inherited, MeshView};

/// The data that go with the vertices, triangles and edges of a mesh.
pub struct Family {
    attributes: Vec<Attribute>,
    markers: Vec<i32>,
    triangle_attributes: Vec<Attribute>,
    constraints: Constraints,
}

impl Family {
    /// Takes what a mesh has inherited from its domain, and from the triangles that were refined.
    pub fn new(
        mesh: &ConstrainedTriangulation,
        inherited: Inherited,
        ancestors: Option<&Ancestors>,
        switches: &Switches,
    ) -> Self {
        let constraints = left_constraints(mesh, inherited.constraints, switches.hull);
        let triangle_attributes = match ancestors {
            Some(ancestors) => ancestors.hand_down(mesh),
            None if switches.attributes => inherited.triangle_attributes,
            None => Vec::new(),
        };
        Self {
            attributes: inherited.attributes,
            markers: inherited.markers.unwrap_or_default(),
            triangle_attributes,
            constraints,
        }
    }

    /// Shows the mesh with these data.
    pub fn view<'a>(&'a self, mesh: &'a ConstrainedTriangulation) -> MeshView<'a> {
        self.dress(MeshView::from(mesh.triangulation()))
    }

    fn dress<'a>(&'a self, mut view: MeshView<'a>) -> MeshView<'a> {
        view.attributes = &self.attributes;
        view.markers = Some(&self.markers);
        view.triangle_attributes = &self.triangle_attributes;
        view.with_constraints(&self.constraints)
    }

    /// Leaves out the vertices that no triangle has, and counts the others anew.
    pub fn jettison(self, mesh: &ConstrainedTriangulation) -> Jettisoned {
        let triangulation = mesh.triangulation();
        let mut is_used = vec![false; triangulation.points().len()];
        for v in triangulation.triangles().as_flattened() {
            is_used[v.index()] = true;
        }
        let mut numbers = Vec::with_capacity(is_used.len());
        let mut next = 0;
        for &is_used in &is_used {
            numbers.push(VertexId::new(next));
            next += usize::from(is_used);
        }
        let renumber = |v: VertexId| numbers[v.index()];
        let mut family = self;
        for attribute in &mut family.attributes {
            keep(&mut attribute.values, &is_used);
        }
        keep(&mut family.markers, &is_used);
        for ends in &mut family.constraints.edges {
            *ends = ends.map(renumber);
        }
        let mut points = triangulation.points().to_vec();
        keep(&mut points, &is_used);
        let triangles = triangulation.triangles().iter();
        Jettisoned {
            points,
            triangles: triangles.map(|t| t.map(renumber)).collect(),
            family,
        }
    }
}

/// A mesh without unused vertices.
pub struct Jettisoned {
    points: Vec<delone::Point>,
    triangles: Vec<[VertexId; 3]>,
    family: Family,
}

impl Jettisoned {
    /// Shows the mesh with its data.
    pub fn view(&self) -> MeshView<'_> {
        self.family
            .dress(MeshView::new(&self.points, &self.triangles))
    }
}

fn keep<T>(values: &mut Vec<T>, is_kept: &[bool]) {
    let mut is_kept = is_kept.iter();
    values.retain(|_| *is_kept.next().expect("bug: more values than vertices"));
}

/// Visits each edge of a triangle once, as a half-edge, and tells whether it lies on the border.
fn sides(mesh: &ConstrainedTriangulation) -> impl Iterator<Item = (HalfEdgeId, bool)> {
    let triangulation = mesh.triangulation();
    (0..triangulation.num_triangles()).flat_map(move |t| {
        let neighbors = triangulation.neighbors(TriangleId::new(t));
        let of_this = move |&k: &usize| neighbors[k].is_none_or(|n| t < n.index());
        let side = move |k: usize| (HalfEdgeId::new(3 * t + k), neighbors[k].is_none());
        (0..3).filter(of_this).map(side)
    })
}

/// Returns the ends of an edge, the smaller one first.
fn ends(mesh: &ConstrainedTriangulation, h: HalfEdgeId) -> [VertexId; 2] {
    let mesh = mesh.triangulation().mesh();
    let [a, b] = [mesh.origin(h), mesh.dest(h)];
    [a.min(b), a.max(b)]
}

/// Keeps the constrained edges that a triangle has, and adds the border if the hull is asked for.
fn left_constraints(
    mesh: &ConstrainedTriangulation,
    inherited: Constraints,
    hull: bool,
) -> Constraints {
    let is_left = |&(h, is_border): &(_, bool)| mesh.is_constrained(h) || hull && is_border;
    let mut edges: Vec<_> = sides(mesh)
        .filter(is_left)
        .map(|(h, _)| ends(mesh, h))
        .collect();
    edges.sort_unstable();
    // What is inherited is sorted too.
    let known = &inherited.edges;
    let of_known = inherited.markers.as_ref();
    let marker = |edge| match known.binary_search(edge) {
        Ok(e) => of_known.map_or(0, |markers| markers[e]),
        Err(_) => 0,
    };
    Constraints {
        markers: Some(edges.iter().map(marker).collect()),
        edges,
        holes: inherited.holes,
        regions: inherited.regions,
        ..Constraints::default()
    }
}
