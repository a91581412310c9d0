//! Hands the result out: triangles of the domain first, then those carved away, then ghosts, in the
//! caller's numbering.

use super::ConstrainedTriangulation;
use super::build::{Context, Faces};
use super::draft::Draft;
use super::names::Names;
use super::result::Lineage;
use crate::delaunay::rename;
use crate::parallel::Workers;
use crate::pslg::Chains;
use crate::{Error, Mesh, Phase, Point, Pslg, TriangleId, Triangulation, VertexId, Watch};

/// Puts the result together.
pub(super) fn hand_out(
    faces: Faces,
    context: Context,
    workers: Workers,
    watch: &dyn Watch,
) -> Result<ConstrainedTriangulation, Error> {
    let Context {
        pslg,
        names,
        lineage,
        warnings,
    } = context;
    watch.progress(Phase::Export, 0, 1);
    let Faces {
        mut mesh,
        mut constrained,
        outside,
        mut region_of,
    } = faces;
    let num_finite = mesh.num_faces() - mesh.ghosts().count();
    let num_triangles = outside.iter().filter(|&&o| !o).count();
    if !stand_in_order(&mesh, &outside) {
        let order = in_order(&mesh, &outside, [num_triangles, num_finite]);
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
        lineage,
        warnings,
        along: Default::default(),
    })
}

/// The place of face `t` in the order: a triangle of the domain, one that was carved away, or a ghost.
fn class(mesh: &Mesh, outside: &[bool], t: TriangleId) -> usize {
    match outside[t.index()] {
        false => 0,
        true if !mesh.is_ghost(t) => 1,
        true => 2,
    }
}

fn stand_in_order(mesh: &Mesh, outside: &[bool]) -> bool {
    let faces = (0..outside.len()).map(TriangleId::new);
    faces.is_sorted_by_key(|t| class(mesh, outside, t))
}

/// Lists the faces class by class, each in the order of the faces, given where the later classes begin.
fn in_order(mesh: &Mesh, outside: &[bool], [carved, ghosts]: [usize; 2]) -> Vec<TriangleId> {
    let mut order = vec![TriangleId::new(0); outside.len()];
    let mut next = [0, carved, ghosts];
    for t in (0..outside.len()).map(TriangleId::new) {
        let place = &mut next[class(mesh, outside, t)];
        order[*place] = t;
        *place += 1;
    }
    order
}

/// Puts a result together from a draft that goes on being edited, nothing carved away. `callers` are the
/// new numbers of its vertices; everything else is in their terms.
pub(crate) fn hand_out_draft(
    draft: &Draft,
    callers: Vec<VertexId>,
    points: Vec<Point>,
    segments: Vec<[VertexId; 2]>,
    chains: Chains,
) -> ConstrainedTriangulation {
    let mesh = draft.mesh.clone();
    let faces = (0..mesh.num_faces()).map(TriangleId::new);
    let faces = Faces {
        outside: faces.map(|t| mesh.is_ghost(t)).collect(),
        constrained: draft.marks.clone().into_bytes(),
        region_of: Vec::new(),
        mesh,
    };
    let lineage = Lineage {
        num_segments: segments.len(),
        chains,
        ..Lineage::default()
    };
    let context = Context {
        pslg: Pslg {
            points,
            segments,
            ..Pslg::default()
        },
        names: Names {
            callers,
            ..Names::default()
        },
        lineage,
        warnings: Vec::new(),
    };
    hand_out(faces, context, Workers::ONE, &()).expect("bug: nobody cancels")
}

/// Collects what belongs to each face in a new order; nothing stays nothing.
fn permute<T: Copy>(values: &[T], order: &[TriangleId]) -> Vec<T> {
    if values.is_empty() {
        return Vec::new();
    }
    order.iter().map(|t| values[t.index()]).collect()
}
