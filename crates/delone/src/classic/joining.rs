//! One vertex more: joined to what it sees, as all incremental algorithms do.

use super::Board;
use crate::locate::Location;
use crate::predicates::Orientation;
use crate::{Error, HalfEdgeId, Observer, VertexId};

impl<O: Observer> Board<'_, O> {
    /// Joins `v` to what it sees where it lies, and returns the half-edges opposite to it,
    /// counter-clockwise: its link.
    ///
    /// In a triangle it is joined to three corners, on an edge to four; outside to the ends of all hull
    /// edges that it sees. In a row of collinear vertices it may lie on an edge, or beyond an end.
    pub fn join(&mut self, at: Location, v: VertexId) -> Vec<HalfEdgeId> {
        match at {
            Location::Face(t) => self.split_face(t, v).to_vec(),
            Location::Edge(h) => self.split_edge(h, v).to_vec(),
            Location::Outside(h) => self.join_outside(h, v),
            Location::Beyond(h) => self.open_edge(h, v).to_vec(),
            Location::Vertex(_) | Location::Carved(_) | Location::Apart => {
                unreachable!("bug: the points are distinct, and nothing is carved")
            }
        }
    }

    /// Joins `v`, which sees the hull edge of `h` (a half-edge of a ghost), to the boundary between two
    /// vertices, counter-clockwise: what it sees has been found before. Returns the half-edges opposite to
    /// it, counter-clockwise.
    pub fn join_chain(
        &mut self,
        h: HalfEdgeId,
        v: VertexId,
        [first, last]: [VertexId; 2],
    ) -> Vec<HalfEdgeId> {
        self.fan(h, v, |_, [a, b]| a != first && b != last)
    }

    /// Joins `v`, which sees the hull edge of `h` (a half-edge of a ghost), to all hull edges that it sees.
    ///
    /// ```text
    ///      z    v             The ghost of h is split: into triangle (a, b, v), and a ghost on either
    ///       \  /|\  c        side. As long as v sees the next hull edge, bc or za, too, the spoke to
    ///        \/ | \/         infinity between both is flipped, which makes one triangle more.
    ///        a--h→-b
    /// ```
    fn join_outside(&mut self, h: HalfEdgeId, v: VertexId) -> Vec<HalfEdgeId> {
        self.fan(h, v, |board, [a, b]| {
            board.orient(a, b, v) == Orientation::Left
        })
    }

    /// Joins `v` to the hull edge of `h`, and to those after and before it as long as `sees` says so.
    fn fan(
        &mut self,
        h: HalfEdgeId,
        v: VertexId,
        sees: impl Fn(&mut Self, [VertexId; 2]) -> bool,
    ) -> Vec<HalfEdgeId> {
        let mut link = self.split_face(h.triangle(), v);
        while self.ends(link[0]).iter().any(|w| w.is_infinite()) {
            link.rotate_left(1);
        }
        let [ab, mut onwards, backwards] = link;
        let mut link = vec![ab];
        while let Some(beyond) = self.flip_if(onwards, v, &sees) {
            link.push(onwards);
            onwards = beyond;
        }
        while let Some(beyond) = self.flip_if(backwards, v, &sees) {
            link.insert(0, beyond);
        }
        link
    }

    /// Flips `spoke`, which joins a hull vertex to infinity and has apex `v`, if `v` sees the hull edge
    /// beyond it. Returns the half-edge that `v` now sees besides.
    fn flip_if(
        &mut self,
        spoke: HalfEdgeId,
        v: VertexId,
        sees: impl Fn(&mut Self, [VertexId; 2]) -> bool,
    ) -> Option<HalfEdgeId> {
        let twin = self.mesh().twin(spoke);
        let [a, b] = self.ends(self.mesh().hull_edge_of(twin.triangle()));
        let is_visible = a != v && b != v && sees(self, [a, b]);
        is_visible.then(|| {
            self.flip(spoke);
            twin.prev()
        })
    }

    /// Divides vertices into the first ones that are on one line, sorted along it, and the others.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn first_row<'v>(
        &mut self,
        order: &'v [VertexId],
    ) -> Result<(Vec<VertexId>, &'v [VertexId]), Error> {
        let mut number = order.len().min(2);
        while number < order.len() {
            self.step()?;
            if self.orient(order[0], order[1], order[number]) != Orientation::Collinear {
                break;
            }
            number += 1;
        }
        let (row, rest) = order.split_at(number);
        let mut row = row.to_vec();
        row.sort_by(|&v, &w| self.point(v).lex_cmp(&self.point(w)));
        Ok((row, rest))
    }

    /// Lays vertices on one line, in their order, into a row.
    pub fn lay_row(&mut self, row: &[VertexId]) {
        let [a, b, rest @ ..] = row else { return };
        let mut end = self.seed(*a, *b).next();
        for &v in rest {
            let [link, _] = self.open_edge(end, v);
            end = link.prev();
        }
    }
}
