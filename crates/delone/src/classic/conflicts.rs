//! Conflicts: pairs of a triangle and a vertex in its circle, by which the lecture proves that flipping ends.
//!
//! Φ is their number. A Delaunay flip takes at least two away, since d no longer lies in the circle of (a, b, c)
//! nor b in that of (a, c, d), and no other vertex gains; Φ = 0 if and only if the triangulation is Delaunay; and
//! if Φ > 0 some edge can be flipped. All that holds for points in general position, and for all points once the
//! perturbation decides who lies in a circle: with the strict test, flipping a tie takes nothing away.
//!
//! Φ is counted only if someone [wants](crate::Observer::wants_conflicts) it, and only without constraints, in a
//! triangulation of the whole convex hull: a constrained Delaunay triangulation leaves conflicts across its
//! constraints, and which of them count depends on what is visible. *Cost*: O(n²) at the start, O(n) a flip, since only two triangles change.

use super::Board;
use crate::predicates::in_circle_perturbed;
use crate::{Error, Event, HalfEdgeId, Observer, TriangleId, VertexId};

/// Φ, kept up to date.
pub(super) struct Conflicts {
    vertices: Vec<VertexId>,
    /// `None`: nobody wants to know, or it would mean nothing.
    count: Option<u64>,
}

impl Conflicts {
    /// Counts the conflicts of a triangulation and tells their number, if someone wants it.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn count<O: Observer>(board: &mut Board<O>) -> Result<Self, Error> {
        let mut conflicts = Self {
            vertices: Vec::new(),
            count: None,
        };
        if board.wants_conflicts() && is_whole(board) {
            conflicts.vertices = vertices(board);
            let mut count = 0;
            for t in board.mesh().triangles().collect::<Vec<_>>() {
                board.spend(conflicts.vertices.len())?;
                count += conflicts.of(board, t);
            }
            conflicts.count = Some(count);
            board.tell(|| Event::ConflictsCounted { conflicts: count });
        }
        Ok(conflicts)
    }

    /// Flips the edge of `h`, and tells how many conflicts are left.
    pub fn flip<O: Observer>(&mut self, board: &mut Board<O>, h: HalfEdgeId) {
        let pair = [h, board.mesh().twin(h)].map(HalfEdgeId::triangle);
        let before = self.of_pair(board, pair);
        board.flip(h);
        let after = self.of_pair(board, pair);
        if let Some(count) = &mut self.count {
            *count = *count - before + after;
            let conflicts = *count;
            board.tell(|| Event::ConflictsCounted { conflicts });
        }
    }

    /// Counts the conflicts of two triangles, if anyone wants to know.
    fn of_pair<O: Observer>(&self, board: &Board<O>, pair: [TriangleId; 2]) -> u64 {
        match self.count {
            Some(_) => pair.map(|t| self.of(board, t)).iter().sum(),
            None => 0,
        }
    }

    /// Counts the conflicts of a triangle.
    fn of<O: Observer>(&self, board: &Board<O>, t: TriangleId) -> u64 {
        let [a, b, c] = board.mesh().corners(t).map(|v| board.point(v));
        let inside = |&&v: &&VertexId| in_circle_perturbed(a, b, c, board.point(v));
        self.vertices.iter().filter(inside).count() as u64
    }
}

/// Tells whether the convex hull is filled, and every edge may be flipped.
fn is_whole<O: Observer>(board: &Board<O>) -> bool {
    let mut triangles = board.mesh().triangles();
    board.locked().is_empty() && triangles.all(|t| board.is_inside(t))
}

/// Lists the vertices of the mesh.
fn vertices<O: Observer>(board: &Board<O>) -> Vec<VertexId> {
    let corners = board.mesh().faces().as_flattened().iter().copied();
    let mut vertices: Vec<_> = corners.filter(|v| !v.is_infinite()).collect();
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}
