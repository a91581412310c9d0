//! Segments, inserted into any triangulation of their ends: walk along each, and flip what crosses it.
//!
//! The edges that cross a segment from a to b are found by a walk, through vertices and along edges where the
//! segment runs so. They form a fan at each vertex on the left:
//!
//! ```text
//!            w                  The fan at w: all edges that lead from w to the other side. If w sticks
//!    prev  / | \  next          out, that is if prev, w, next turn right, each flip of an edge of the fan
//!      .--/  |  \--.            takes one from it: the last one cuts w off, and prev–next takes its place.
//!   a /__/___|___\__\___ b
//!     \ /    |    \ /
//!      x1 -- x2 -- x3
//! ```
//!
//! *Why it ends*: while edges cross there is a left vertex that sticks out, the one that is farthest from
//! the segment. Of the ends x of its fan, the one farthest from the segment has a strictly convex
//! quadrilateral around its edge, so it can be flipped. So the vertices on the left are cut off one after the
//! other. Sloan (*A fast algorithm for generating constrained Delaunay triangulations*, 1993) flips whatever
//! comes, and tries again later what cannot be flipped yet; why that ends is less clear.
//!
//! *Cost*: at worst k² flips for k crossing edges, in practice a few for each; no recursion.

use super::{Board, Input, ascending};
use crate::observe::{Item, Queue};
use crate::predicates::Orientation;
use crate::{ConstrainedDelaunay, Error, Event, HalfEdgeId, Observer, Pslg, VertexId};
use std::ops::Range;

/// Which lines of pseudocode insert a segment.
#[derive(Clone, Copy)]
pub(super) struct Lines {
    /// Its turn has come.
    pub consider: u16,
    /// The edges that cross it are found.
    pub walk: u16,
    /// One of them is looked at.
    pub pop: u16,
    /// It is flipped.
    pub flip: u16,
    /// The segment is an edge.
    pub lock: u16,
}

/// Inserts all segments of the input, and returns each as the vertices along it, from its first end to its
/// second; equal points are represented by one of them.
///
/// # Errors
/// [`Error::Crossing`] names the first two that cross in a point that is no vertex; [`Error::Cancelled`].
pub(super) fn insert_all<O: Observer>(
    board: &mut Board<O>,
    input: &Input,
    lines: Lines,
) -> Result<Vec<Vec<VertexId>>, Error> {
    let segments = &input.pslg.segments;
    let mut inserter = Inserter { board, lines };
    let mut chains = Vec::with_capacity(segments.len());
    for ends in segments {
        inserter.board.step()?;
        match inserter.insert(ends.map(|v| inserter.board.representative(v))) {
            Ok(chain) => chains.push(chain),
            Err(Blocked) => return Err(first_crossing(input)),
        }
    }
    Ok(chains)
}

/// Asks the engine, which knows how to find the first pair.
fn first_crossing(input: &Input) -> Error {
    let pslg = Pslg {
        points: input.pslg.points.clone(),
        segments: input.pslg.segments.clone(),
        ..Pslg::default()
    };
    let found = ConstrainedDelaunay::new()
        .threads(1)
        .watch(input.watch)
        .triangulate(pslg);
    found.expect_err("bug: a segment was blocked by none that it crosses")
}

/// A constraint is in the way.
struct Blocked;

/// What lies ahead of a vertex.
enum Ahead {
    /// An edge runs exactly that way.
    Along(HalfEdgeId),
    /// The triangle to the left of the vertex ends with this edge, which runs from right to left.
    Across(HalfEdgeId),
}

struct Inserter<'b, 'r, O> {
    board: &'b mut Board<'r, O>,
    lines: Lines,
}

impl<O: Observer> Inserter<'_, '_, O> {
    /// Inserts a segment piece by piece, from vertex to vertex.
    fn insert(&mut self, [a, b]: [VertexId; 2]) -> Result<Vec<VertexId>, Blocked> {
        self.board.at(self.lines.consider);
        self.board
            .tell(|| Event::SegmentConsidered { segment: [a, b] });
        let mut chain = vec![a];
        let mut from = a;
        while from != b {
            let edge = match self.ahead(from, b) {
                Ahead::Along(h) => h,
                Ahead::Across(first) => self.clear(from, b, first)?,
            };
            self.board.at(self.lines.lock);
            self.board.lock(edge);
            from = self.board.ends(edge)[1];
            chain.push(from);
        }
        Ok(chain)
    }

    /// Looks from `a` towards `b`.
    fn ahead(&mut self, a: VertexId, b: VertexId) -> Ahead {
        self.board.at(self.lines.walk);
        let first = self.board.spoke(a);
        let mut h = first;
        loop {
            let [_, w] = self.board.ends(h);
            if w == b {
                return Ahead::Along(h);
            }
            let apex = self.board.mesh().apex(h);
            match self.side(a, b, w) {
                Some(Orientation::Collinear) if self.board.is_towards(a, w, b) => {
                    return Ahead::Along(h);
                }
                Some(Orientation::Right) if self.side(a, b, apex) == Some(Orientation::Left) => {
                    return Ahead::Across(h.next());
                }
                _ => h = self.board.mesh().onext(h),
            }
            assert!(h != first, "bug: a segment leaves the hull");
        }
    }

    /// Tells on which side of the line from `a` to `b` a vertex lies, if it is not at infinity.
    fn side(&mut self, a: VertexId, b: VertexId, v: VertexId) -> Option<Orientation> {
        (!v.is_infinite()).then(|| self.board.orient(a, b, v))
    }

    /// Makes the part of the segment `ab` up to the first vertex on it an edge, which is returned; `first`
    /// crosses it and is opposite to `a`.
    fn clear(
        &mut self,
        a: VertexId,
        b: VertexId,
        first: HalfEdgeId,
    ) -> Result<HalfEdgeId, Blocked> {
        let mut fans = self.collect(a, b, first)?;
        let mesh = self.board.mesh();
        let piece = [a, mesh.apex(mesh.twin(fans[fans.len() - 1]))];
        let (mut edge, mut start) = (first, 0);
        while !fans.is_empty() {
            let end = self.fan_end(&fans, start);
            let [prev, w, next] = self.corner(&fans, start..end);
            if self.board.orient(prev, w, next) == Orientation::Right {
                edge = self.cut_off(&mut fans, start..end, piece);
                start = self.fan_before(&fans, start);
            } else {
                start = end;
            }
        }
        Ok(self.board.mesh().twin(edge.next()))
    }

    /// Walks towards `b` up to the first vertex on the way, and lists the edges that are crossed, each from
    /// right to left.
    fn collect(
        &mut self,
        a: VertexId,
        b: VertexId,
        first: HalfEdgeId,
    ) -> Result<Vec<HalfEdgeId>, Blocked> {
        let mut crossed = Vec::new();
        let mut h = first;
        loop {
            let edge = self.board.ends(h);
            self.board.tell(|| Event::WalkStepped { edge });
            if self.board.is_locked(h) {
                return Err(Blocked);
            }
            crossed.push(h);
            let beyond = self.board.mesh().twin(h);
            let w = self.board.mesh().apex(beyond);
            let is_reached = w == b;
            h = match self.board.orient(a, b, w) {
                Orientation::Left if !is_reached => beyond.next(),
                Orientation::Right if !is_reached => beyond.prev(),
                _ => break,
            };
        }
        for &h in &crossed {
            self.tell_waiting(h, true);
        }
        Ok(crossed)
    }

    /// Returns where the fan ends that begins at `start`: its edges lead to the same vertex on the left.
    fn fan_end(&self, fans: &[HalfEdgeId], start: usize) -> usize {
        let left = |&h: &HalfEdgeId| self.board.mesh().dest(h);
        let w = left(&fans[start]);
        start + fans[start..].iter().take_while(|h| left(h) == w).count()
    }

    /// Returns where the fan begins whose last edge is the one before `start`, or the first one begins.
    fn fan_before(&self, fans: &[HalfEdgeId], start: usize) -> usize {
        let left = |&h: &HalfEdgeId| self.board.mesh().dest(h);
        let Some(last) = fans[..start].last() else {
            return 0;
        };
        let of_fan = fans[..start]
            .iter()
            .rev()
            .take_while(|h| left(h) == left(last));
        start - of_fan.count()
    }

    /// Returns the vertex of a fan, between its neighbours on the left.
    fn corner(&self, fans: &[HalfEdgeId], fan: Range<usize>) -> [VertexId; 3] {
        let mesh = self.board.mesh();
        let [first, last] = [fans[fan.start], fans[fan.end - 1]];
        [
            mesh.apex(first),
            mesh.dest(first),
            mesh.apex(mesh.twin(last)),
        ]
    }

    /// Flips all edges of a fan whose vertex sticks out, and returns the last one that was flipped. What
    /// comes instead either does not cross the piece, or belongs to the fan before or behind.
    fn cut_off(
        &mut self,
        fans: &mut Vec<HalfEdgeId>,
        fan: Range<usize>,
        piece: [VertexId; 2],
    ) -> HalfEdgeId {
        let Range { mut start, mut end } = fan;
        let mut flipped = fans[start];
        let mut at = start;
        while start < end {
            debug_assert!(at < end, "bug: no edge of a fan can be flipped");
            let h = fans[at];
            if !self.is_convex(h) {
                at += 1;
                continue;
            }
            let (is_first, is_last) = (at == start, at + 1 == end);
            let comes = self.flip(fans, at);
            flipped = h;
            let crosses =
                is_first != is_last && !self.board.ends(comes).iter().any(|v| piece.contains(v));
            if crosses {
                // From right to left: it joins the left neighbour that it now leads to.
                fans[at] = if is_first {
                    comes
                } else {
                    self.board.mesh().twin(comes)
                };
                self.tell_waiting(comes, true);
            } else {
                fans.remove(at);
            }
            start += usize::from(is_first && crosses);
            end -= usize::from(!(is_first && crosses));
            at = at.saturating_sub(1).max(start);
        }
        flipped
    }

    /// Tells whether the quadrilateral around an edge of a fan is strictly convex; at the fan's vertex it is.
    fn is_convex(&mut self, h: HalfEdgeId) -> bool {
        self.board.at(self.lines.pop);
        let mesh = self.board.mesh();
        let [before, x, behind] = [mesh.apex(h), mesh.origin(h), mesh.apex(mesh.twin(h))];
        self.board.orient(before, x, behind) == Orientation::Left
    }

    /// Flips an edge of a fan, and returns the other diagonal, directed against the walk.
    fn flip(&mut self, fans: &mut [HalfEdgeId], at: usize) -> HalfEdgeId {
        self.board.at(self.lines.flip);
        let h = fans[at];
        self.tell_waiting(h, false);
        // The edge behind has its half-edge here in a face that changes.
        let behind = fans.get(at + 1).map(|&next| self.board.mesh().twin(next));
        self.board.flip(h);
        let mesh = self.board.mesh();
        if let Some(twin) = behind {
            fans[at + 1] = mesh.twin(twin);
        }
        h.next()
    }

    /// Tells that an edge begins to wait, or ends.
    fn tell_waiting(&mut self, h: HalfEdgeId, is_pushed: bool) {
        let edge = ascending(self.board.ends(h));
        let item = Item::Edge(edge);
        self.board.tell_waiting(Queue::Crossings, item, is_pushed);
    }
}
