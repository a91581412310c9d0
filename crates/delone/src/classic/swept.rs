//! Where a sweep is, and its front: for who watches, and for nobody else.

use super::Board;
use crate::{Event, Observer, Sweep, VertexId};

/// A front on which a vertex has one place at most: that of its own number.
impl<O: Observer> Board<'_, O> {
    /// Tells that a vertex comes to the front, after another; `None`: as the first.
    pub fn enter_front(&mut self, vertex: VertexId, after: Option<VertexId>) {
        self.tell(|| Event::FrontEntered {
            place: vertex.raw(),
            vertex,
            after: after.map(VertexId::raw),
        });
    }

    /// Tells of the first front.
    pub fn open_front(&mut self, vertices: &[VertexId]) {
        let mut after = None;
        for &vertex in vertices {
            self.enter_front(vertex, after);
            after = Some(vertex);
        }
    }

    /// Tells that a vertex, which comes after another, leaves the front.
    pub fn leave_front(&mut self, vertex: VertexId, after: Option<VertexId>) {
        self.tell(|| Event::FrontLeft {
            place: vertex.raw(),
            vertex,
            after: after.map(VertexId::raw),
        });
    }
}

/// The sweep line or circle, as far as it was told.
#[derive(Default)]
pub(super) struct Swept(Option<Sweep>);

impl Swept {
    /// Returns where it is; unknown if nobody watches.
    pub fn position(&self) -> Option<Sweep> {
        self.0
    }

    /// Tells that it is elsewhere, if it is.
    pub fn tell_at<O: Observer>(&mut self, board: &mut Board<O>, at: impl FnOnce() -> Sweep) {
        if board.is_watched() {
            self.go(board, Some(at()));
        }
    }

    /// Tells that it is over.
    pub fn tell_end<O: Observer>(&mut self, board: &mut Board<O>) {
        self.go(board, None);
    }

    fn go<O: Observer>(&mut self, board: &mut Board<O>, to: Option<Sweep>) {
        let from = std::mem::replace(&mut self.0, to);
        if from != to {
            board.tell(|| Event::SweptTo { from, to });
        }
    }
}
