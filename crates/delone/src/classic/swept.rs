//! Where a sweep is: for who watches, and for nobody else.

use super::Board;
use crate::{Event, Observer, Sweep};

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
