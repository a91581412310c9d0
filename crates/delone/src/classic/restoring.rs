//! Flips until edges are locally Delaunay: those around a vertex that was joined, or all.

use super::{Board, ascending};
use crate::observe::{Item, Queue};
use crate::{Error, HalfEdgeId, Observer};

/// Which lines of pseudocode [restore](Board::restore).
#[derive(Clone, Copy)]
pub(super) struct Restoring {
    /// Suspects are pushed.
    pub push: u16,
    /// One is popped.
    pub pop: u16,
    /// It is examined.
    pub examine: u16,
    /// It is flipped, and others are pushed.
    pub flip: u16,
}

impl<O: Observer> Board<'_, O> {
    /// Makes every edge locally Delaunay again after `v` was joined: examines the edges opposite to it, and
    /// where one is flipped the two beyond. The last one that was added is examined first, so the order is
    /// that of a recursion: counter-clockwise around `v`.
    pub fn restore(&mut self, link: Vec<HalfEdgeId>, lines: Restoring) {
        let mut suspects = link;
        suspects.reverse();
        self.at(lines.push);
        for &h in &suspects {
            self.tell_suspect(h, true);
        }
        while let Some(h) = suspects.pop() {
            self.at(lines.pop);
            self.tell_suspect(h, false);
            self.at(lines.examine);
            if self.is_locally_delaunay(h) {
                continue;
            }
            let twin = self.mesh().twin(h);
            self.at(lines.flip);
            self.flip(h);
            for suspect in [twin.prev(), h] {
                self.tell_suspect(suspect, true);
                suspects.push(suspect);
            }
        }
    }

    /// Makes every edge locally Delaunay (Lawson): examines all, and where `flip` has flipped one, the four around
    /// it. On the stack an edge waits at most once.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn restore_all(
        &mut self,
        lines: Restoring,
        mut flip: impl FnMut(&mut Self, HalfEdgeId),
    ) -> Result<(), Error> {
        let mut list = List::of(self);
        self.at(lines.push);
        for edge in 0..list.half_edges.len() {
            list.push(self, edge);
        }
        loop {
            self.at(lines.pop);
            let Some(h) = list.pop(self) else {
                return Ok(());
            };
            self.at(lines.examine);
            if self.is_locally_delaunay(h) {
                continue;
            }
            self.step()?;
            self.at(lines.flip);
            let around = list.flip(h, self.mesh().twin(h));
            flip(self, h);
            for edge in around {
                list.push(self, edge);
            }
        }
    }

    /// Tells that an edge begins to wait, or ends.
    pub fn tell_suspect(&mut self, h: HalfEdgeId, is_pushed: bool) {
        let edge = ascending(self.ends(h));
        if !edge.iter().any(|v| v.is_infinite()) {
            self.tell_waiting(Queue::Suspects, Item::Edge(edge), is_pushed);
        }
    }
}

/// Edges that have numbers, and those that wait.
struct List {
    /// The number of the edge of each half-edge; nothing to read at infinity or amid carved faces.
    numbers: Vec<usize>,
    /// A half-edge of each edge.
    half_edges: Vec<HalfEdgeId>,
    waits: Vec<bool>,
    stack: Vec<usize>,
}

impl List {
    /// Numbers the edges.
    fn of<O: Observer>(board: &Board<O>) -> Self {
        let mesh = board.mesh();
        let half_edges = board.visible_edges();
        let mut numbers = vec![usize::MAX; 3 * mesh.num_faces()];
        for (edge, &h) in half_edges.iter().enumerate() {
            numbers[h.index()] = edge;
            numbers[mesh.twin(h).index()] = edge;
        }
        Self {
            numbers,
            waits: vec![false; half_edges.len()],
            stack: Vec::new(),
            half_edges,
        }
    }

    fn push<O: Observer>(&mut self, board: &mut Board<O>, edge: usize) {
        if !std::mem::replace(&mut self.waits[edge], true) {
            board.tell_suspect(self.half_edges[edge], true);
            self.stack.push(edge);
        }
    }

    fn pop<O: Observer>(&mut self, board: &mut Board<O>) -> Option<HalfEdgeId> {
        let edge = self.stack.pop()?;
        self.waits[edge] = false;
        board.tell_suspect(self.half_edges[edge], false);
        Some(self.half_edges[edge])
    }

    /// Follows the edges through a flip of `h`, whose twin is `g`, and returns the numbers of those around.
    ///
    /// Of these, two change their half-edges, as drawn at [`Mesh::flip`](crate::Mesh::flip): what was
    /// `g.next()` is then `h`, what was `h.next()` is `g`, and both become halves of the diagonal.
    fn flip(&mut self, h: HalfEdgeId, g: HalfEdgeId) -> [usize; 4] {
        let diagonal = self.numbers[h.index()];
        let around = [h.next(), h.prev(), g.next(), g.prev()].map(|s| self.numbers[s.index()]);
        let [bc, _, ad, _] = around;
        for (side, edge) in [(h, ad), (g, bc), (h.next(), diagonal), (g.next(), diagonal)] {
            self.numbers[side.index()] = edge;
            self.half_edges[edge] = side;
        }
        around
    }
}
