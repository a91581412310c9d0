//! What every edit is made of: five steps, each the inverse of another or of itself, noted in a journal.
//!
//! The result of an edit depends on points and constraints alone, so a step is taken back by its
//! inverse: no snapshot of faces is ever needed, and ids come back because they are given out again in
//! reverse order.

use super::removal;
use super::sight;
use super::{ConstraintId, LiveTriangulation};
use crate::constrained::{Ahead, Draft, Edge};
use crate::delaunay::insert;
use crate::locate::Location;
use crate::predicates::Orientation;
use crate::{HalfEdgeId, Point, VertexId};

/// What has been done, and what it takes to undo it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    Inserted(VertexId),
    Removed(VertexId, Point),
    Moved(VertexId, Point),
    Constrained(ConstraintId),
    Released(ConstraintId, [VertexId; 2]),
}

impl LiveTriangulation {
    /// Makes a vertex of a finite point, or returns the one that lies there.
    pub(super) fn put_in(&mut self, point: Point) -> Result<VertexId, VertexId> {
        let point = normal(point);
        let at = self.locate(point);
        if let Some(Location::Vertex(there)) = at {
            return Err(there);
        }
        let v = VertexId::from(self.vertices.take());
        self.draft.set_point(v, point);
        match at {
            Some(at) => self.put_in_mesh(at, v),
            None => {
                if let Some(other) = self.places.any() {
                    self.draft.seed(other, v);
                }
            }
        }
        self.places.insert(point, v);
        self.journal.push(Step::Inserted(v));
        Ok(v)
    }

    fn put_in_mesh(&mut self, at: Location, v: VertexId) {
        if let Location::Edge(h) = at
            && self.draft.marks.is_constrained(h)
        {
            self.constraints.split(self.ends(h), v);
        }
        let suspects = &mut self.room.suspects;
        suspects.clear();
        let inserted = insert(&mut self.draft, at, v, suspects);
        inserted.expect("bug: there is no vertex");
    }

    /// Removes a vertex in which no constraint ends and no two cross.
    pub(super) fn take_out(&mut self, v: VertexId) {
        if let [a, b] = self.constrained_neighbors(v)[..] {
            self.constraints.merge([a, b], v);
        }
        let point = self.draft.point(v);
        self.places.remove(point);
        self.vertices.give_back(v.raw());
        match self.num_vertices() {
            0 => {}
            1 => {
                let other = self.places.any().expect("bug: one vertex is left");
                self.draft.clear([v, other]);
            }
            _ => {
                let _ = removal::remove(&mut self.draft, v, &mut self.room);
            }
        }
        self.journal.push(Step::Removed(v, point));
    }

    /// Moves a vertex, in which no constraint ends and no two cross, to a vacant place.
    pub(super) fn relocate(&mut self, v: VertexId, at: Point) {
        let before = self.draft.point(v);
        let noted = self.journal.len();
        if self.stays_within_star(v, at) {
            self.relocate_within_star(v, normal(at));
        } else {
            self.take_out(v);
            let back = self.put_in(at);
            debug_assert_eq!(back, Ok(v), "bug: its id was given out last");
        }
        self.journal.truncate(noted);
        self.journal.push(Step::Moved(v, before));
    }

    /// Tells whether the star of a vertex would still consist of triangles if it lay at `at`, and no edge
    /// has to stay where it is.
    fn stays_within_star(&self, v: VertexId, at: Point) -> bool {
        let draft = &self.draft;
        draft.star(v).all(|h| {
            let is_finite = !draft.mesh.dest(h).is_infinite();
            is_finite
                && !draft.marks.is_constrained(h)
                && !draft.mesh.apex(h).is_infinite()
                && draft.side_of(h.next(), at) == Orientation::Left
        })
    }

    /// Moves a vertex and leaves its edges, which may have to be flipped then, as may those around it.
    fn relocate_within_star(&mut self, v: VertexId, at: Point) {
        self.places.remove(self.draft.point(v));
        self.places.insert(at, v);
        self.draft.set_point(v, at);
        let suspects = &mut self.room.suspects;
        suspects.clear();
        suspects.extend(self.draft.star(v).flat_map(|h| [h, h.next()]));
        self.settle();
    }

    /// Adds a constraint between different vertices, which must cross no other.
    pub(super) fn constrain(&mut self, ends: [VertexId; 2]) -> ConstraintId {
        let id = self.constraints.add(ends);
        let edge = Edge {
            ends,
            is_odd: false,
        };
        let mut inner = Vec::new();
        let inserted = self.inserter.insert(&mut self.draft, edge, &mut inner);
        inserted.expect("bug: a constraint is in the way");
        let mut from = ends[0];
        for to in inner.into_iter().chain([ends[1]]) {
            self.constraints.attach([from, to], id);
            from = to;
        }
        self.journal.push(Step::Constrained(id));
        id
    }

    /// Removes a constraint; edges along which no other runs are free to flip.
    pub(super) fn release(&mut self, id: ConstraintId, ends: [VertexId; 2]) {
        let suspects = &mut self.room.suspects;
        suspects.clear();
        for h in half_edges_along(&self.draft, ends) {
            let edge = [self.draft.mesh.origin(h), self.draft.mesh.dest(h)];
            if self.constraints.detach(edge, id) {
                suspects.push(h);
            }
        }
        for &h in suspects.iter() {
            self.draft.release(h);
        }
        self.constraints.remove(id);
        self.settle();
        self.journal.push(Step::Released(id, ends));
    }

    /// Undoes the steps noted after the first `kept` ones.
    pub(super) fn undo(&mut self, kept: usize) {
        while self.journal.len() > kept {
            let step = self.journal.pop().expect("bug: a journal has its length");
            match step {
                Step::Inserted(v) => self.take_out(v),
                Step::Removed(v, point) => {
                    let back = self.put_in(point);
                    debug_assert_eq!(back, Ok(v), "bug: its id was given out last");
                }
                Step::Moved(v, point) => self.relocate(v, point),
                Step::Constrained(id) => {
                    let ends = self.constraints.ends(id).expect("bug: it was added");
                    self.release(id, ends);
                }
                Step::Released(id, ends) => {
                    let back = self.constrain(ends);
                    debug_assert_eq!(back, id, "bug: its id was given out last");
                }
            }
            // The inverse has been noted.
            self.journal.pop();
        }
    }

    /// Lists the neighbours of a vertex along constrained edges.
    pub(super) fn constrained_neighbors(&self, v: VertexId) -> Vec<VertexId> {
        let spokes = self.draft.star(v);
        let constrained = spokes.filter(|&h| self.draft.marks.is_constrained(h));
        constrained.map(|h| self.draft.mesh.dest(h)).collect()
    }

    /// Returns a constraint that would be in the way of one between two vertices, and an edge of it.
    pub(super) fn in_the_way(&self, ends: [VertexId; 2]) -> Option<(ConstraintId, [VertexId; 2])> {
        let edge = self.ends(sight::first_in_the_way(&self.draft, ends)?);
        let first = self.constraints.along(edge).next();
        Some((first.expect("bug: a constrained edge has none"), edge))
    }

    /// Returns the vertices where a half-edge starts and ends.
    pub(super) fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [self.draft.mesh.origin(h), self.draft.mesh.dest(h)]
    }
}

/// Turns −0.0 into 0.0, which is the same place.
fn normal(p: Point) -> Point {
    Point::new(p.x + 0.0, p.y + 0.0)
}

/// Visits the half-edges along the straight chain from one vertex to another.
pub(super) fn half_edges_along(
    draft: &Draft,
    [a, b]: [VertexId; 2],
) -> impl Iterator<Item = HalfEdgeId> + '_ {
    let mut at = a;
    std::iter::from_fn(move || {
        if at == b {
            return None;
        }
        let Ahead::Along(h) = draft.ahead(at, draft.point(b)) else {
            unreachable!("bug: a constraint is no chain of edges");
        };
        at = draft.mesh.dest(h);
        Some(h)
    })
}
