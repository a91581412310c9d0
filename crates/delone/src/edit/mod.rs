//! Live editing: vertices come, go and move, constraints too, and the triangulation is canonical after
//! every edit.
//!
//! ```text
//! point ── places ──> a vertex close by ── walk ──> where it lies ── insert ──> flips around it
//! vertex ── removal ──> star flattened, contracted, made constrained Delaunay
//! constraint ── sight ──> nothing in the way? ── corridor ──> its two sides triangulated anew
//! each ── primitive ──> a journal, by which edits that fail, and transactions, are undone
//! ```
//!
//! A [`LiveTriangulation`] holds points and constraints, and at any moment is *the* constrained Delaunay
//! triangulation of them, triangle by triangle what [`triangulate`](crate::triangulate) or
//! [`ConstrainedDelaunay`](crate::ConstrainedDelaunay), with the rule
//! [`Hull`](crate::DomainRule::Hull), would make of them from scratch. So no history shows, and the
//! inverse of an edit undoes it exactly.
//!
//! *Ids.* A vertex keeps its id until it is removed, moves included; a constraint until it is removed.
//! Ids of what has been removed are given out again, the latest first, so side tables stay small; whoever
//! removes something must forget its id. Half-edges and faces have new ids after any edit, and after one
//! that has failed.
//!
//! *Cost*, in practice: an insertion O(log n) to find the place, and a flip for every edge but three that
//! the vertex ends up with; a removal of a vertex with k neighbours O(log n + k), O(k log k) for large k;
//! a move that of both, or less if the star of the vertex can stay. A constraint costs its corridor. Never does anything depend linearly on n, but
//! for what the docs of a method say.
//!
//! *Does not* carve: there are no holes and no domain but the convex hull, and constraints that cross are
//! refused, not split. There are no attributes; ids index the caller's tables.
//!
//! Papers: Lawson 1977 and Lee and Lin 1986 (flips), Devillers 1999 (removal), Devillers, Pion and
//! Teillaud 2002 (straight walks).

mod build;
mod constraints;
mod error;
mod places;
mod primitive;
mod queries;
mod removal;
mod sight;
mod slots;
mod snapshot;

pub use crate::delaunay::Inserted;
pub use constraints::ConstraintId;
pub use error::EditError;
pub(crate) use removal::{Room, remove};
pub use snapshot::Snapshot;

use crate::constrained::{Draft, Inserter};
use crate::delaunay::check_number;
use crate::locate::Location;
use crate::predicates::{crossing_point, is_between};
use crate::{Error, Mesh, Point, VertexId};
use constraints::Constraints;
use places::Places;
use primitive::Step;
use slots::Slots;
use std::fmt;

/// A constrained Delaunay triangulation that can be edited, canonical after every edit.
///
/// ```
/// use delone::edit::{EditError, LiveTriangulation};
/// use delone::Point;
///
/// let mut live = LiveTriangulation::new();
/// let mut put = |x, y| live.insert((x, y)).map(|inserted| inserted.vertex());
/// let [a, b, c, d] = [put(0.0, 0.0)?, put(4.0, 0.0)?, put(4.0, 4.0)?, put(0.0, 4.0)?];
/// let diagonal = live.add_constraint(a, c)?;
///
/// let m = live.insert((2.0, 2.0))?.vertex(); // upon the constraint
/// assert_eq!(live.chain(diagonal), Some(vec![a, m, c]));
/// live.move_to(m, (3.0, 2.0))?; // and away from it
/// assert_eq!(live.chain(diagonal), Some(vec![a, c]));
/// assert!(matches!(live.add_constraint(b, d), Err(EditError::Crossing { .. })));
///
/// // All or nothing.
/// let before = live.hash();
/// let outcome = live.transaction(|live| {
///     live.remove(m)?;
///     live.remove(a) // is an end of the constraint
/// });
/// assert!(matches!(outcome, Err(EditError::IsEnd { .. })));
/// assert_eq!(live.hash(), before);
/// assert_eq!(live.point(m), Some(Point::new(3.0, 2.0)));
/// # Ok::<(), EditError>(())
/// ```
#[derive(Clone)]
pub struct LiveTriangulation {
    /// Mesh, points and marks; the places of vertices that are not in use hold whatever was there.
    draft: Draft,
    vertices: Slots,
    places: Places,
    constraints: Constraints,
    /// Steps that may have to be undone.
    journal: Vec<Step>,
    /// How many transactions are open.
    open: usize,
    inserter: Inserter,
    room: Room,
}

impl fmt::Debug for LiveTriangulation {
    /// Says how many vertices and constraints there are.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LiveTriangulation")
            .field("vertices", &self.num_vertices())
            .field("constraints", &self.num_constraints())
            .finish_non_exhaustive()
    }
}

impl Default for LiveTriangulation {
    fn default() -> Self {
        Self::new()
    }
}

impl LiveTriangulation {
    /// Starts without vertices.
    pub fn new() -> Self {
        let draft = Draft::new(Vec::new(), Mesh::default());
        Self::of(draft, Slots::default(), Constraints::default())
    }

    /// Starts with a triangulation.
    fn of(draft: Draft, vertices: Slots, constraints: Constraints) -> Self {
        let ids = vertices.ids().map(VertexId::from);
        Self {
            places: Places::new(ids.map(|v| (draft.point(v), v))),
            draft,
            vertices,
            constraints,
            journal: Vec::new(),
            open: 0,
            inserter: Inserter::default(),
            room: Room::default(),
        }
    }

    /// Inserts a point, unless there is a vertex already. If it lies on constraints, they run through it
    /// from now on.
    ///
    /// # Errors
    /// [`EditError::NotFinite`]; [`EditError::TooManyVertices`].
    ///
    /// *Cost*: O(log n) and the degree of the new vertex, in practice; O(n) at worst. *Ids invalidated*:
    /// half-edges and faces.
    pub fn insert(&mut self, point: impl Into<Point>) -> Result<Inserted, EditError> {
        let point = finite(point.into())?;
        self.check_number()?;
        let inserted = match self.put_in(point) {
            Ok(v) => Inserted::Vertex(v),
            Err(there) => Inserted::Duplicate(there),
        };
        self.close();
        Ok(inserted)
    }

    /// Removes a vertex, and returns where it was. Constraints that run straight through it go on
    /// without it.
    ///
    /// # Errors
    /// [`EditError::NoVertex`]; [`EditError::IsEnd`] names a constraint that ends there;
    /// [`EditError::Crossroads`] two constraints that would cross without the vertex.
    ///
    /// *Cost*: O(log n) and O(k log k) for k neighbours, in practice O(k). *Ids invalidated*: half-edges
    /// and faces; the vertex's may be given out again.
    pub fn remove(&mut self, v: VertexId) -> Result<Point, EditError> {
        let point = self.require(v)?;
        if let Some(&constraint) = self.constraints_ending_at(v).first() {
            return Err(EditError::IsEnd {
                vertex: v,
                constraint,
            });
        }
        self.require_no_crossroads(v)?;
        self.take_out(v);
        self.close();
        Ok(point)
    }

    /// Moves a vertex. Constraints that end there move with it, those that run through it do not; if the
    /// new place lies on a constraint, that runs through it from now on.
    ///
    /// # Errors
    /// [`EditError::NoVertex`]; [`EditError::NotFinite`]; [`EditError::Occupied`] names the vertex that
    /// lies there; [`EditError::Crossroads`] two constraints that would cross without the vertex;
    /// [`EditError::Crossing`] a constraint that would cross another. Nothing has changed then.
    ///
    /// *Cost*: O(log n); for a small step, with which no triangle turns over, a few tests for each
    /// neighbour, else a removal and an insertion; and every constraint that ends there, twice. *Ids
    /// invalidated*: half-edges and faces.
    pub fn move_to(&mut self, v: VertexId, point: impl Into<Point>) -> Result<(), EditError> {
        let before = self.require(v)?;
        let at = finite(point.into())?;
        match self.locate(at) {
            _ if before == at => return Ok(()),
            Some(Location::Vertex(vertex)) => return Err(EditError::Occupied { vertex, at }),
            _ => {}
        }
        let kept = self.journal.len();
        let outcome = self.carry(v, at);
        if outcome.is_err() {
            self.undo(kept);
        }
        self.close();
        outcome
    }

    /// Moves a vertex to a vacant place; if that fails, some of it may have been done.
    fn carry(&mut self, v: VertexId, at: Point) -> Result<(), EditError> {
        let ending = self.constraints_ending_at(v);
        let ends = ending.iter().map(|&id| self.constraints.ends(id));
        let ends: Vec<_> = ends.map(|ends| ends.expect("bug: it ends here")).collect();
        for (&id, &ends) in ending.iter().zip(&ends) {
            self.release(id, ends);
        }
        self.require_no_crossroads(v)?;
        self.relocate(v, at);
        // In reverse order each gets its id back.
        for (&id, &ends) in ending.iter().zip(&ends).rev() {
            self.require_free_way(ends)?;
            let back = self.constrain(ends);
            debug_assert_eq!(back, id, "bug: its id was given out last");
        }
        Ok(())
    }

    /// Constrains the segment between two vertices: it becomes an edge, or a chain of edges if it runs
    /// through vertices. It may lie on others, and cross them in vertices.
    ///
    /// # Errors
    /// [`EditError::NoVertex`]; [`EditError::NoLength`]; [`EditError::Crossing`] names a constraint that
    /// it would cross elsewhere.
    ///
    /// *Cost*: in practice linear in the edges that it crosses, and the degrees of vertices on it; for k
    /// edges along a curve O(k log k). *Ids invalidated*: half-edges and faces.
    pub fn add_constraint(&mut self, a: VertexId, b: VertexId) -> Result<ConstraintId, EditError> {
        self.require(a)?;
        self.require(b)?;
        if a == b {
            return Err(EditError::NoLength { vertex: a });
        }
        self.require_free_way([a, b])?;
        let id = self.constrain([a, b]);
        self.close();
        Ok(id)
    }

    /// Removes a constraint, and returns its ends. The vertices stay.
    ///
    /// # Errors
    /// [`EditError::NoConstraint`].
    ///
    /// *Cost*: in practice linear in the edges that come back; at worst that of the triangulation from
    /// scratch. *Ids invalidated*: half-edges and faces; the constraint's may be given out again.
    pub fn remove_constraint(&mut self, id: ConstraintId) -> Result<[VertexId; 2], EditError> {
        let constraint = id;
        let ends = self.constraints.ends(id);
        let ends = ends.ok_or(EditError::NoConstraint { constraint })?;
        self.release(id, ends);
        self.close();
        Ok(ends)
    }

    /// Does several edits, or none: if `edits` fails, all that it has done is undone, ids included.
    /// Transactions may be nested.
    ///
    /// # Errors
    /// That of `edits`.
    ///
    /// # Panics
    /// If `edits` does; what it has done until then stays.
    ///
    /// *Cost*: a few bytes for each edit, and undoing costs as much as doing.
    pub fn transaction<T, E>(
        &mut self,
        edits: impl FnOnce(&mut Self) -> Result<T, E>,
    ) -> Result<T, E> {
        let kept = self.journal.len();
        self.open += 1;
        let outcome = edits(self);
        if outcome.is_err() {
            self.undo(kept);
        }
        // It would be lower if `edits` had put another triangulation in place of this one.
        self.open = self.open.saturating_sub(1);
        self.close();
        outcome
    }

    /// Forgets the steps of an edit that is done, unless a transaction may still undo them.
    fn close(&mut self) {
        if self.open == 0 {
            self.journal.clear();
        }
    }

    fn check_number(&self) -> Result<(), EditError> {
        check_number(self.num_vertices() + 1).map_err(|error| match error {
            Error::TooManyPoints { limit, .. } => EditError::TooManyVertices { limit },
            other => unreachable!("bug: {other}"),
        })
    }

    fn require(&self, vertex: VertexId) -> Result<Point, EditError> {
        self.point(vertex).ok_or(EditError::NoVertex { vertex })
    }

    /// Refuses a vertex in which constraints cross. None may end there.
    fn require_no_crossroads(&self, vertex: VertexId) -> Result<(), EditError> {
        let first = |w: &VertexId| self.constraints.along([vertex, *w]).next();
        let neighbors = self.constrained_neighbors(vertex);
        let mut through: Vec<_> = neighbors.iter().filter_map(first).collect();
        through.sort_unstable();
        // Each runs along two of the edges, and all of those along one edge run along the same two.
        through.dedup();
        match through[..] {
            [first, second, ..] => Err(EditError::Crossroads {
                vertex,
                constraints: [first, second],
            }),
            _ => Ok(()),
        }
    }

    /// Refuses a constraint that would cross another.
    fn require_free_way(&self, ends: [VertexId; 2]) -> Result<(), EditError> {
        let Some((crossed, edge)) = self.in_the_way(ends) else {
            return Ok(());
        };
        let segments = [ends, edge].map(|ends| ends.map(|v| self.draft.point(v)));
        let at = crossing_point(segments[0], segments[1]);
        let at = at.expect("bug: what is in the way is crossed");
        Err(EditError::Crossing { ends, crossed, at })
    }
}

fn finite(at: Point) -> Result<Point, EditError> {
    if at.is_finite() {
        Ok(at)
    } else {
        Err(EditError::NotFinite { at })
    }
}

/// Tells whether all vertices of a chain lie on the segment between its ends.
fn is_straight(chain: &[VertexId], point: impl Fn(VertexId) -> Point) -> bool {
    let (first, last) = (chain[0], chain[chain.len() - 1]);
    let inner = &chain[1..chain.len() - 1];
    inner
        .iter()
        .all(|&v| is_between(point(first), point(last), point(v)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_kept_only_while_they_may_be_undone() {
        let mut live = LiveTriangulation::new();
        let done = live.transaction(|live| {
            live.insert((0.0, 0.0))?;
            live.insert((1.0, 0.0))?;
            assert_eq!(live.journal.len(), 2);
            Ok::<_, EditError>(())
        });
        assert_eq!(done, Ok(()));
        assert!(live.journal.is_empty());
        live.insert((0.0, 1.0)).expect("finite");
        assert!(live.journal.is_empty());
    }
}
