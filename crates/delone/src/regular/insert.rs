//! The builder: locate, dig, fill, one site after the other.

use super::cavity::Cavity;
use super::order::Sites;
use super::row;
use crate::locate::{Location, locate};
use crate::pace::Pace;
use crate::predicates::{
    Orientation, Weighted, in_power_circle_perturbed, in_power_segment_perturbed, orient2d,
};
use crate::{Error, HalfEdgeId, Mesh, Phase, TriangleId, VertexId, Watch};

impl Sites {
    #[inline]
    pub fn site(&self, v: VertexId) -> Weighted {
        Weighted {
            point: self.points[v.index()],
            weight: self.weights[v.index()],
        }
    }
}

/// Makes the mesh of at least one site, triangles first, in the caller's numbering, and counts its
/// triangles.
pub(super) fn build(mut sites: Sites, watch: &dyn Watch) -> Result<(Mesh, usize), Error> {
    let n = sites.points.len();
    let mut pace = Pace::new(watch, Phase::Triangulate, n as u64);
    let mesh = if bring_triangle_forward(&mut sites) {
        let mut growing = Growing::new(&sites);
        let mut cavity = Cavity::default();
        for v in (3..n).map(VertexId::new) {
            pace.step()?;
            growing.insert(v, &mut cavity);
        }
        growing.mesh
    } else {
        row::build(&sites, &mut pace)?
    };
    pace.finish();
    watch.progress(Phase::Export, 0, 1);
    let result = handed_out(mesh, &sites.names);
    watch.progress(Phase::Export, 1, 1);
    Ok(result)
}

/// Makes the first three sites turn counter-clockwise; false if all sites lie on one line.
fn bring_triangle_forward(sites: &mut Sites) -> bool {
    let [a, b, others @ ..] = &sites.points[..] else {
        return false;
    };
    let turns = others.iter().map(|&c| orient2d(*a, *b, c));
    let found = (2..)
        .zip(turns)
        .find(|(_, turn)| *turn != Orientation::Collinear);
    let Some((third, turn)) = found else {
        return false;
    };
    sites.swap(2, third);
    if turn == Orientation::Right {
        sites.swap(0, 1);
    }
    true
}

/// Drops the faces that are free, puts ghosts behind triangles, and gives vertices their names.
fn handed_out(mut mesh: Mesh, names: &[VertexId]) -> (Mesh, usize) {
    let is_used = |t: &TriangleId| mesh.corners(*t) != FREE;
    let faces = (0..mesh.num_faces()).map(TriangleId::new).filter(is_used);
    let (ghosts, mut order): (Vec<_>, Vec<_>) = faces.partition(|&t| mesh.is_ghost(t));
    let num_triangles = order.len();
    order.extend(ghosts);
    mesh.reorder_faces(&order);
    mesh.rename_vertices(names);
    (mesh, num_triangles)
}

/// The corners of a face that is not in use.
const FREE: [VertexId; 3] = [VertexId::INFINITE; 3];

/// A regular triangulation that grows site by site.
pub(super) struct Growing<'s> {
    sites: &'s Sites,
    pub mesh: Mesh,
    /// Faces that are not in use.
    free: Vec<TriangleId>,
    /// Where the next walk begins.
    hint: HalfEdgeId,
}

impl<'s> Growing<'s> {
    /// Begins with the first three sites, which turn counter-clockwise.
    fn new(sites: &'s Sites) -> Self {
        let mut mesh = Mesh::default();
        let [a, b, c] = [0, 1, 2].map(VertexId::new);
        let hint = mesh.seed(a, b);
        mesh.split_face(hint.triangle(), c);
        Self {
            sites,
            mesh,
            free: Vec::new(),
            hint,
        }
    }

    /// Makes `v` a vertex, if the sites before do not hide it.
    fn insert(&mut self, v: VertexId, cavity: &mut Cavity) {
        let goal = self.sites.points[v.index()];
        let location = locate(&self.mesh, &self.sites.points, self.hint, goal);
        let t = match location {
            Location::Face(t) => t,
            Location::Edge(h) | Location::Outside(h) => h.triangle(),
            Location::Vertex(_) => unreachable!("bug: two sites in one place"),
            Location::Beyond(_) | Location::Apart => {
                unreachable!("bug: a triangulation without triangles")
            }
            Location::Carved(_) => unreachable!("bug: a mesh without a domain"),
        };
        if !self.conflicts(t, v) {
            let [h, ..] = t.half_edges();
            self.hint = h;
            return;
        }
        cavity.dig(self, t, v);
        let used = self.free.len();
        self.hint = cavity.fill(&mut self.mesh, &mut self.free, v);
        for &t in self.free.iter().skip(used) {
            self.mesh.replace_face(t, FREE);
        }
    }

    /// Tells whether face `t` cannot stay when `v` is there: `v`, lifted, lies below it.
    ///
    /// A ghost is vertical: below it is what lies strictly outside its edge, and on the line of the edge
    /// what lies below that.
    #[inline]
    pub fn conflicts(&self, t: TriangleId, v: VertexId) -> bool {
        let v = self.sites.site(v);
        if self.mesh.is_ghost(t) {
            let h = self.mesh.hull_edge_of(t);
            let [a, b] = [self.mesh.origin(h), self.mesh.dest(h)].map(|v| self.sites.site(v));
            match orient2d(a.point, b.point, v.point) {
                Orientation::Left => true,
                Orientation::Right => false,
                Orientation::Collinear => in_power_segment_perturbed(a, b, v),
            }
        } else {
            let [a, b, c] = self.mesh.corners(t).map(|v| self.sites.site(v));
            in_power_circle_perturbed(a, b, c, v)
        }
    }
}
