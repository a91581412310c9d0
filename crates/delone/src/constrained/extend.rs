//! A triangulation once more, with vertices added: on its segments, and elsewhere.
//!
//! Whoever refines a domain without touching its mesh only says where the new vertices lie and which
//! edges they halve. Points and subsegments have one constrained Delaunay triangulation, so nothing else
//! is needed; and what belongs to the domain is not asked of seeds and rules again, which a boundary
//! that has moved by a rounding error might mislead, but is what lies beside the same subsegments.
//!
//! *Cost*: that of a triangulation.

use super::ConstrainedTriangulation;
use super::build::{Prepared, insert_noded, start};
use super::carve::{Carving, flood};
use super::draft::Draft;
use super::lengthen::NO_SEGMENT;
use super::names::Names;
use super::result::Lineage;
use super::segments::undirected;
use crate::pace::Pace;
use crate::parallel::Workers;
use crate::pslg::Chains;
use crate::{Error, HalfEdgeId, Phase, Point, Pslg, TriangleId, VertexId};
use std::collections::HashMap;

/// Vertices to add, in order; their numbers follow those that exist.
#[derive(Clone, Debug, Default)]
pub(crate) struct Steiner {
    pub points: Vec<Point>,
    /// For each the constrained edge that it halves, which may be half of one before.
    pub halved: Vec<Option<[VertexId; 2]>>,
}

impl Steiner {
    /// Adds a vertex.
    pub fn push(&mut self, at: Point, halved: Option<[VertexId; 2]>) {
        self.points.push(at);
        self.halved.push(halved);
    }
}

/// Triangulates the domain of `before` with the first `count` vertices of `steiner`. `None` if they were
/// rounded so badly that subsegments cross, or that a vertex has changed sides.
///
/// # Errors
/// [`Error::TooManyPoints`].
pub(crate) fn extend(
    before: &ConstrainedTriangulation,
    steiner: &Steiner,
    count: usize,
    workers: Workers,
) -> Result<Option<ConstrainedTriangulation>, Error> {
    let old = &before.triangulation;
    let pslg = Pslg {
        points: [old.points(), &steiner.points[..count]].concat(),
        segments: before.segments.clone(),
        regions: before.regions.clone(),
        ..Pslg::default()
    };
    let halves = Halves::new(&steiner.halved[..count], old.points().len());
    let lineage = halves.lineage(before, count);
    let (mut draft, names) = start(&pslg.points, workers, &())?;
    let chains = &lineage.chains;
    let is_planar = names.duplicates == old.duplicates()
        && insert_noded(&mut draft, &names, &pslg.segments, chains, workers, &())?;
    if !is_planar {
        return Ok(None);
    }
    let free = steiner.halved[..count].iter().filter(|h| h.is_none());
    let expected = old.num_triangles() + 2 * free.count();
    let Some(carving) = carve_again(before, &draft, &names, &halves, expected)? else {
        return Ok(None);
    };
    let prepared = Prepared::new(draft, carving, pslg, names, lineage);
    prepared.hand_out(workers, &()).map(Some)
}

/// For each constrained edge that was halved the vertex between the halves.
struct Halves(HashMap<[VertexId; 2], VertexId>);

impl Halves {
    fn new(halved: &[Option<[VertexId; 2]>], first: usize) -> Self {
        let added = (first..).map(VertexId::new).zip(halved);
        Self(
            added
                .filter_map(|(v, edge)| Some((undirected((*edge)?), v)))
                .collect(),
        )
    }

    /// Appends the vertices along the edge from `a` to `b`, without `a`.
    fn append(&self, [mut from, to]: [VertexId; 2], chain: &mut Vec<VertexId>) {
        let mut ahead = vec![to];
        while let Some(&next) = ahead.last() {
            match self.0.get(&undirected([from, next])) {
                Some(&between) => ahead.push(between),
                None => {
                    chain.push(next);
                    from = next;
                    ahead.pop();
                }
            }
        }
    }

    /// Lists the vertices along a chain of edges.
    fn along(&self, chain: &[VertexId]) -> Vec<VertexId> {
        let mut longer = chain[..1].to_vec();
        for pair in chain.windows(2) {
            self.append([pair[0], pair[1]], &mut longer);
        }
        longer
    }

    /// Finds out where everything comes from.
    fn lineage(&self, before: &ConstrainedTriangulation, count: usize) -> Lineage {
        let first = before.triangulation.points().len();
        let mut chains = Chains::default();
        let mut added = vec![NO_SEGMENT; count];
        for (i, ends) in before.segments.iter().enumerate() {
            let chain = self.along(before.chain(i));
            for v in &chain {
                let segment = v.index().checked_sub(first).map(|k| &mut added[k]);
                if let Some(segment) = segment.filter(|s| **s == NO_SEGMENT) {
                    *segment = i as u32;
                }
            }
            if chain != ends {
                chains.push(i, chain);
            }
        }
        let old = &before.lineage;
        Lineage {
            num_segments: old.num_segments,
            chains,
            crossings: old.crossings.clone(),
            steiner: [&old.steiner[..], &added].concat(),
        }
    }
}

/// Finds the domain and its regions: what lies beside the subsegments that bounded them before.
/// `None` if those do not bound `expected` triangles, and one more for each half beside the domain.
fn carve_again(
    before: &ConstrainedTriangulation,
    draft: &Draft,
    names: &Names,
    halves: &Halves,
    mut expected: usize,
) -> Result<Option<Carving>, Error> {
    let faces = draft.mesh.num_faces();
    let mut pace = Pace::new(&(), Phase::Carve, faces as u64);
    let mut outside = vec![true; faces];
    let mut region_of = vec![0; if before.regions.is_empty() { 0 } else { faces }];
    let mut found = 0;
    for (h, [a, b]) in boundary(before) {
        let pieces = halves.along(&[a, b]);
        expected += pieces.len() - 2;
        let region = before.region(h.triangle()).map_or(0, |r| r as u32 + 1);
        for pair in pieces.windows(2) {
            flood(draft, left_of(draft, names, pair), &mut pace, |t| {
                let is_new = std::mem::replace(&mut outside[t.index()], false);
                if is_new {
                    found += 1;
                    if let Some(of) = region_of.get_mut(t.index()) {
                        *of = region;
                    }
                }
                is_new
            })?;
        }
    }
    let leaks = draft.mesh.ghosts().any(|t| !outside[t.index()]);
    Ok((!leaks && found == expected).then(|| Carving {
        outside,
        region_of,
        warnings: before.warnings.clone(),
    }))
}

/// Visits the constrained half-edges of the domain's triangles, with their ends.
fn boundary(
    t: &ConstrainedTriangulation,
) -> impl Iterator<Item = (HalfEdgeId, [VertexId; 2])> + '_ {
    let triangles = (0..t.triangulation.num_triangles()).map(TriangleId::new);
    let half_edges = triangles.flat_map(TriangleId::half_edges);
    let mesh = t.triangulation.mesh();
    half_edges
        .filter(|&h| t.is_constrained(h))
        .map(|h| (h, [mesh.origin(h), mesh.dest(h)]))
}

/// Finds the face to the left of an edge that the draft has.
fn left_of(draft: &Draft, names: &Names, edge: &[VertexId]) -> TriangleId {
    let [a, b] = [edge[0], edge[1]].map(|v| names.positions[v.index()]);
    let h = draft.find_edge(a, b);
    let h = h.expect("bug: a subsegment is no edge");
    let from_a = draft.mesh.origin(h) == a;
    let h = if from_a { h } else { draft.mesh.twin(h) };
    h.triangle()
}
