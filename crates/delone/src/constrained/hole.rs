//! A hole that has been filled somehow, made constrained Delaunay.
//!
//! Where a vertex has been removed, the edges around its star stay: nothing but the faces within has
//! to change. Flips make them constrained Delaunay (Lee and Lin, *Generalized Delaunay triangulation
//! for planar graphs*, 1986), and need few steps for a handful of faces. Around the hub of a wheel they
//! may need a number that is quadratic; then each part of the hole between constrained edges is
//! triangulated [in bulk](super::bulk).
//!
//! *Cost*: in practice linear in the faces if they are few; O(k log k) for k of them.

use super::bulk;
use super::corridor::{FLIPS_PER_FACE, Inserter};
use super::draft::Draft;
use super::side::Side;
use crate::{HalfEdgeId, TriangleId};
use std::collections::BTreeSet;

/// Replaces `faces`, which are triangles, by as many that are constrained Delaunay and cover the same.
/// Parts of them that hang together must be simple polygons without vertices inside. `suspects` is
/// room to work in.
pub(crate) fn refill(draft: &mut Draft, faces: &[TriangleId], suspects: &mut Vec<HalfEdgeId>) {
    for &t in faces {
        draft.marks.enter_corridor(t);
    }
    let half_edges = faces.iter().flat_map(|t| t.half_edges());
    suspects.clear();
    suspects.extend(half_edges.filter(|&h| h < draft.mesh.twin(h)));
    let is_done = draft.legalise(suspects, budget(faces.len()), ());
    for &t in faces {
        draft.marks.leave_corridor(t);
    }
    if !is_done {
        suspects.clear();
        refill_in_bulk(draft, faces);
    }
}

/// Returns how many flips are allowed.
fn budget(faces: usize) -> usize {
    // Both ways lead to the same triangles. The tests beside take the rare one often.
    if cfg!(test) && faces.is_multiple_of(2) {
        0
    } else {
        FLIPS_PER_FACE * faces
    }
}

#[cold]
fn refill_in_bulk(draft: &mut Draft, faces: &[TriangleId]) {
    let mut left: BTreeSet<_> = faces.iter().copied().collect();
    while let Some(first) = left.pop_first() {
        let part = part_of(draft, first, &mut left);
        for &t in &part {
            draft.marks.enter_corridor(t);
        }
        refill_part(draft, &part);
        for &t in &part {
            draft.marks.leave_corridor(t);
        }
    }
}

/// Lists the faces that hang together with the first one, and removes them from those left.
fn part_of(draft: &Draft, first: TriangleId, left: &mut BTreeSet<TriangleId>) -> Vec<TriangleId> {
    let mut part = vec![first];
    let mut next = 0;
    while next < part.len() {
        for h in part[next].half_edges() {
            let beyond = draft.mesh.twin(h).triangle();
            if !draft.marks.is_constrained(h) && left.remove(&beyond) {
                part.push(beyond);
            }
        }
        next += 1;
    }
    part
}

/// Triangulates a polygon, whose faces are marked, anew.
fn refill_part(draft: &mut Draft, faces: &[TriangleId]) {
    let rim = rim_of(draft, faces);
    let (&last, others) = rim.split_last().expect("bug: a polygon without sides");
    let start = draft.mesh.origin(others[0]);
    let (beyond, mark) = (draft.mesh.twin(last), draft.marks.get(last));
    let mut side = Side::default();
    for &h in others {
        side.push(draft, h);
    }
    let mut faces = faces.iter().copied();
    let last = bulk::fill(&side, start, draft, &mut faces, Inserter::default());
    draft.mesh.bond(last, beyond);
    draft.marks.set(last, mark);
}

/// Lists the half-edges along the sides of a polygon, whose faces are marked, counter-clockwise.
fn rim_of(draft: &Draft, faces: &[TriangleId]) -> Vec<HalfEdgeId> {
    let is_side = |&h: &HalfEdgeId| {
        let beyond = draft.mesh.twin(h).triangle();
        draft.marks.is_constrained(h) || !draft.marks.is_in_corridor(beyond)
    };
    let next = |&h: &HalfEdgeId| {
        let mut next = h.next();
        while !is_side(&next) {
            next = draft.mesh.twin(next).next();
        }
        next
    };
    let first = faces.iter().flat_map(|t| t.half_edges()).find(is_side);
    let first = first.expect("bug: a hole without sides");
    let mut rim = vec![first];
    let mut h = next(&first);
    while h != first {
        rim.push(h);
        h = next(&h);
    }
    rim
}
