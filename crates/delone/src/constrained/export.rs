//! Hands the result out: triangles of the domain first, then those carved away, then ghosts, in the
//! caller's numbering.

use super::ConstrainedTriangulation;
use super::carve::Carving;
use super::draft::Draft;
use super::names::Names;
use crate::delaunay::rename;
use crate::parallel::Workers;
use crate::pslg::Chains;
use crate::{Error, Mesh, Phase, Pslg, TriangleId, Triangulation, VertexId, Watch};

/// Puts the result together. The lineage is the chains of segments and the pair of segments for each
/// point added at a crossing.
pub(super) fn hand_out(
    pslg: Pslg,
    draft: Draft,
    names: Names,
    carving: Carving,
    (chains, crossings): (Chains, Vec<[u32; 2]>),
    workers: Workers,
    watch: &dyn Watch,
) -> Result<ConstrainedTriangulation, Error> {
    watch.progress(Phase::Export, 0, 1);
    let Draft {
        mut mesh, marks, ..
    } = draft;
    let mut constrained = marks.into_bytes();
    let mut region_of = carving.region_of;
    let ghosts = mesh.ghosts().count();
    let num_finite = mesh.num_faces() - ghosts;
    let num_triangles = carving.outside.iter().filter(|&&o| !o).count();
    if num_triangles < num_finite {
        let order = domain_first(&carving.outside, num_finite);
        mesh.reorder_faces(&order);
        constrained = permute(&constrained, &order);
        region_of = permute(&region_of, &order);
    }
    region_of.truncate(num_triangles);
    let (mut corners, twins) = mesh.into_rows();
    let name = |v: VertexId| names.callers.get(v.index()).copied().unwrap_or(v);
    rename(&mut corners, name, workers, watch).ok_or(Error::Cancelled)?;
    let mesh = Mesh::from_rows(corners, twins);
    let triangulation = Triangulation::of_domain(
        pslg.points,
        mesh,
        num_triangles,
        num_finite,
        names.duplicates,
    );
    watch.progress(Phase::Export, 1, 1);
    Ok(ConstrainedTriangulation {
        triangulation,
        constrained,
        region_of,
        regions: pslg.regions,
        segments: pslg.segments,
        chains,
        crossings,
        warnings: carving.warnings,
        along: Default::default(),
    })
}

/// Orders the faces: those of the domain, those carved away, the ghosts, which come last already.
fn domain_first(outside: &[bool], num_finite: usize) -> Vec<TriangleId> {
    let finite = (0..num_finite).map(TriangleId::new);
    let (carved, mut order): (Vec<_>, Vec<_>) = finite.partition(|t| outside[t.index()]);
    order.extend(carved);
    order.extend((num_finite..outside.len()).map(TriangleId::new));
    order
}

/// Collects what belongs to each face in a new order; nothing stays nothing.
fn permute<T: Copy>(values: &[T], order: &[TriangleId]) -> Vec<T> {
    if values.is_empty() {
        return Vec::new();
    }
    order.iter().map(|t| values[t.index()]).collect()
}
