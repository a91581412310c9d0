//! The sweep itself: points in lexicographic order, joined to a front that is their convex hull.

use crate::classic::Board;
use crate::classic::swept::Swept;
use crate::locate::Location;
use crate::predicates::Orientation;
use crate::{Error, Event, HalfEdgeId, Observer, Sweep, VertexId};

/// Joins vertices in lexicographic order, each to what it sees of those before.
///
/// The last vertex is on the hull, and the next one sees one of the two hull edges there; or all lie in a row.
/// So nothing is searched for. *Cost*: constant on average.
pub(super) fn sweep<O: Observer>(board: &mut Board<O>, order: &[VertexId]) -> Result<(), Error> {
    let [first, second, rest @ ..] = order else {
        return Ok(());
    };
    board.at(3);
    let mut front = Front::new(board, *first, *second);
    for &p in rest {
        front.board.step()?;
        front.take(p);
    }
    front.end();
    Ok(())
}

/// The front, with the sides of the last vertex.
struct Front<'b, 'r, O> {
    board: &'b mut Board<'r, O>,
    first: VertexId,
    /// The two hull edges at the last vertex, as half-edges of ghosts; in a row the two sides of the last
    /// edge, first the one that runs to the last vertex.
    sides: [HalfEdgeId; 2],
    /// Whether there is a triangle: only then there is a front to be told of.
    is_open: bool,
    line: Swept,
}

impl<'b, 'r, O: Observer> Front<'b, 'r, O> {
    fn new(board: &'b mut Board<'r, O>, first: VertexId, second: VertexId) -> Self {
        let h = board.seed(first, second);
        let sides = [h, board.mesh().twin(h)];
        Self {
            board,
            first,
            sides,
            is_open: false,
            line: Swept::default(),
        }
    }

    /// Lets the sweep come to `p`.
    fn take(&mut self, p: VertexId) {
        self.at(4);
        let x = self.board.point(p).x;
        self.line.tell_at(self.board, || Sweep::Vertical(x));
        self.board.tell(|| Event::PointConsidered { vertex: p });
        self.at(5);
        match self.visible_side(p) {
            Some(h) => self.join(h, p),
            None => self.lengthen(p),
        }
    }

    /// States which line runs; before there is a front, the line that makes it.
    fn at(&mut self, line: u16) {
        self.board.at(if self.is_open { line } else { 3 });
    }

    /// Returns a hull edge at the last vertex that has `p` beyond it; none in a row that `p` lengthens.
    fn visible_side(&mut self, p: VertexId) -> Option<HalfEdgeId> {
        self.sides.into_iter().find(|&h| {
            let [a, b] = self.board.ends(h);
            self.board.orient(a, b, p) == Orientation::Left
        })
    }

    fn join(&mut self, h: HalfEdgeId, p: VertexId) {
        self.at(6);
        let link = self.board.join(Location::Outside(h), p);
        let mesh = self.board.mesh();
        let [first, last] = [link[0], link[link.len() - 1]];
        self.sides = [mesh.twin(last.next()), mesh.twin(first.prev())];
        if std::mem::replace(&mut self.is_open, true) {
            self.at(7);
            self.replace(&link, p);
        } else {
            self.board.open_front(&self.vertices());
        }
    }

    /// Lengthens a row of vertices.
    fn lengthen(&mut self, p: VertexId) {
        let [_, beside] = self.board.open_edge(self.sides[0].next(), p);
        let back = beside.prev();
        self.sides = [self.board.mesh().twin(back), back];
    }

    /// Tells that `p` takes the place of the vertices inside its link, which goes back along the front.
    fn replace(&mut self, link: &[HalfEdgeId], p: VertexId) {
        if !self.board.is_watched() {
            return;
        }
        let run: Vec<_> = link.iter().map(|&h| self.board.ends(h)[1]).collect();
        for pair in run.windows(2) {
            self.board.leave_front(pair[0], Some(pair[1]));
        }
        self.board.enter_front(p, run.last().copied());
    }

    /// Gives up what is left of the front.
    fn end(mut self) {
        if self.is_open {
            let vertices = self.vertices();
            for pair in vertices.windows(2).rev() {
                self.board.leave_front(pair[1], Some(pair[0]));
            }
            self.board.leave_front(self.first, None);
        }
        self.line.tell_end(self.board);
    }

    /// Lists the front counter-clockwise, if anybody wants to know.
    fn vertices(&self) -> Vec<VertexId> {
        if !self.board.is_watched() {
            return vec![self.first];
        }
        let mesh = self.board.mesh();
        let mut vertices: Vec<_> = mesh.hull(self.sides[0]).map(|h| mesh.dest(h)).collect();
        let first = vertices.iter().position(|&v| v == self.first);
        vertices.rotate_left(first.expect("bug: the smallest vertex is on the hull"));
        vertices
    }
}
