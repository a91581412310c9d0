//! Where a sweep is: for who watches, and for nobody else.

use super::Board;
use crate::{Event, Observer};

/// The position of a sweep line or circle, as far as it was told.
#[derive(Default)]
pub(super) struct Swept(Option<f64>);

impl Swept {
    /// Returns where it is; unknown if nobody watches.
    pub fn position(&self) -> Option<f64> {
        self.0
    }

    /// Tells that it is elsewhere, at most at the largest number.
    pub fn tell_at<O: Observer>(&mut self, board: &mut Board<O>, position: impl FnOnce() -> f64) {
        let from = self.0;
        let to = &mut self.0;
        board.tell(|| {
            *to = Some(position().clamp(-f64::MAX, f64::MAX));
            Event::SweptTo { from, to: *to }
        });
    }
}
