//! Who is told each step of the insertion of segments, and of the carving.
//!
//! As with [divide and conquer](crate::delaunay), what inserts is generic over its witness, and nobody is one:
//! `()` is not told anything, and the compiler leaves nothing of it in the code.

use super::draft::Draft;
use crate::{HalfEdgeId, TriangleId, VertexId};
use std::collections::BTreeSet;

/// A step; vertices have the numbers of the draft.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Deed {
    /// A segment's turn has come.
    Segment([VertexId; 2]),
    /// The segment runs over this edge, from its left to its right.
    Cross([VertexId; 2]),
    /// A line and a point: on which side is it?
    Turn([VertexId; 3]),
    /// What the segment has run through is cleared.
    Clear,
    /// A triangle is cut off a side.
    Ear,
    /// An edge of a new triangle is looked at.
    Suspect([VertexId; 2]),
    /// A triangle and a vertex: is that in its circle?
    Circle([VertexId; 4]),
    /// The first edge gives way to the second.
    Flip([VertexId; 2], [VertexId; 2]),
    /// There have been too many flips: both sides are triangulated in bulk.
    Bulk,
    /// An edge becomes a constraint.
    Lock([VertexId; 2]),
    /// All segments are in.
    Inserted,
    /// A flood has come to this triangle.
    Reach([VertexId; 3]),
    EdgeCreated([VertexId; 2]),
    EdgeDeleted([VertexId; 2]),
    TriangleCreated([VertexId; 3]),
    TriangleDeleted([VertexId; 3]),
}

/// Someone who is told.
pub(crate) trait Witness: Copy {
    /// Whether it is worth telling.
    const IS_WATCHING: bool;

    /// Shown the triangulation of the points, and what the caller calls its vertices.
    fn begin(self, draft: &Draft, callers: &[VertexId]);

    /// Told of a step.
    fn tell(self, deed: Deed);

    /// Shown which faces lie outside of the domain, in the end.
    fn carve(self, draft: &Draft, outside: &[bool]);
}

impl Witness for () {
    const IS_WATCHING: bool = false;

    #[inline(always)]
    fn begin(self, _: &Draft, _: &[VertexId]) {}

    #[inline(always)]
    fn tell(self, _: Deed) {}

    #[inline(always)]
    fn carve(self, _: &Draft, _: &[bool]) {}
}

#[inline(always)]
pub(super) fn is_watching<W: Witness>(_: W) -> bool {
    W::IS_WATCHING
}

/// Tells of what can be read off a half-edge.
#[inline(always)]
pub(super) fn tell_of(
    witness: impl Witness,
    draft: &Draft,
    h: HalfEdgeId,
    deed: impl Fn([VertexId; 2]) -> Deed,
) {
    if is_watching(witness) {
        witness.tell(deed(ends(draft, h)));
    }
}

/// Tells that a flood has come to a face, unless that is a ghost.
#[inline(always)]
pub(super) fn tell_reached(witness: impl Witness, draft: &Draft, t: TriangleId) {
    if is_watching(witness) && !draft.mesh.is_ghost(t) {
        witness.tell(Deed::Reach(draft.mesh.corners(t)));
    }
}

/// Tells that the edge of `h` becomes a constraint, unless it is one.
#[inline(always)]
pub(super) fn tell_lock(witness: impl Witness, draft: &Draft, h: HalfEdgeId) {
    if is_watching(witness) && !draft.marks.is_constrained(h) {
        witness.tell(Deed::Lock(ends(draft, h)));
    }
}

/// Tells that the edge of `h` is looked at, and its circle, unless it is constrained.
#[inline(always)]
pub(super) fn tell_suspect(witness: impl Witness, draft: &Draft, h: HalfEdgeId) {
    if is_watching(witness) {
        let [a, b] = ends(draft, h);
        witness.tell(Deed::Suspect([a, b]));
        if !draft.marks.is_constrained(h) {
            let [c, d] = apexes(draft, h);
            witness.tell(Deed::Circle([a, b, c, d]));
        }
    }
}

/// Tells that the edge of `h` is about to be flipped.
#[inline(always)]
pub(super) fn tell_flip(witness: impl Witness, draft: &Draft, h: HalfEdgeId) {
    if is_watching(witness) {
        witness.tell(Deed::Flip(ends(draft, h), apexes(draft, h)));
    }
}

/// Tells that the triangles of a corridor are about to go, which follow one another, and the edges between them.
/// Other edges may have the corridor on both sides, too: those stay.
pub(super) fn tell_clearing(witness: impl Witness, draft: &Draft, corridor: &[TriangleId]) {
    witness.tell(Deed::Clear);
    for &t in corridor {
        witness.tell(Deed::TriangleDeleted(draft.mesh.corners(t)));
    }
    for pair in corridor.windows(2) {
        let leads_on = |&h: &HalfEdgeId| draft.mesh.twin(h).triangle() == pair[1];
        let between = pair[0].half_edges().into_iter().find(leads_on);
        let between = between.expect("bug: a corridor is torn");
        witness.tell(Deed::EdgeDeleted(ends(draft, between)));
    }
}

/// Tells that the faces of a corridor were others, with these edges, and have been built anew.
pub(super) fn tell_rebuilt(
    witness: impl Witness,
    draft: &Draft,
    corridor: &[TriangleId],
    before: &Outline,
) {
    let after = Outline::of(draft, corridor);
    witness.tell(Deed::Bulk);
    for &triangle in &before.triangles {
        witness.tell(Deed::TriangleDeleted(triangle));
    }
    for &edge in before.edges.difference(&after.edges) {
        witness.tell(Deed::EdgeDeleted(edge));
    }
    for &edge in after.edges.difference(&before.edges) {
        witness.tell(Deed::EdgeCreated(edge));
    }
    for &triangle in &after.triangles {
        witness.tell(Deed::TriangleCreated(triangle));
    }
}

/// Some triangles, and their edges.
#[derive(Default)]
pub(super) struct Outline {
    triangles: Vec<[VertexId; 3]>,
    /// The smaller end first.
    edges: BTreeSet<[VertexId; 2]>,
}

impl Outline {
    pub fn of(draft: &Draft, faces: &[TriangleId]) -> Self {
        let half_edges = faces.iter().flat_map(|t| t.half_edges());
        let edges = half_edges.map(|h| {
            let [a, b] = ends(draft, h);
            [a.min(b), a.max(b)]
        });
        Self {
            triangles: faces.iter().map(|&t| draft.mesh.corners(t)).collect(),
            edges: edges.collect(),
        }
    }
}

fn ends(draft: &Draft, h: HalfEdgeId) -> [VertexId; 2] {
    [draft.mesh.origin(h), draft.mesh.dest(h)]
}

fn apexes(draft: &Draft, h: HalfEdgeId) -> [VertexId; 2] {
    [h, draft.mesh.twin(h)].map(|h| draft.mesh.apex(h))
}
