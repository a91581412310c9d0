//! Watching an algorithm at work, step by step: for lessons, pictures and tests.
//!
//! Where a [`Watch`](crate::Watch) learns how far work has come, an [`Observer`] learns what is done. There is
//! one vocabulary for all algorithms, [`Event`]: some events change what there is to see, and each of these
//! has its opposite; the others tell what was looked at, and what was found. So a [`Log`] of steps can be
//! played forwards and backwards on a [`Scene`], and an animation needs nothing else.
//!
//! - [`Step`]: an event, and the line of pseudocode that was running.
//! - [`Log`]: keeps every step, with what there was before the first.
//! - [`Scene`]: the picture between two steps.
//! - [`Tally`]: counts, and keeps nothing.
//!
//! *Cost*: none for who does not observe. `()` observes nothing, and the compiler removes what only it would
//! have been told; events are made in closures that then never run.

mod event;
mod log;
mod naming;
mod scene;
mod tally;

pub use event::{Cut, Event, Failure, Item, Queue, Stage, Sweep};
pub use log::Log;
pub(crate) use naming::{ascending, sides, smallest_first};
pub use scene::{NoSuchStep, Scene};
pub use tally::Tally;

/// A step of an algorithm.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Step {
    /// The line of the algorithm's [pseudocode](crate::classic::About::code), from 1; 0 for what has none.
    pub line: u16,
    /// What happened.
    pub event: Event,
}

/// Someone who is told each step.
///
/// ```
/// use delone::{Angle, DomainRule, Event, Observer, Pslg, Quality, Refinement, Step, Strategy};
///
/// #[derive(Default)]
/// struct Flips(usize);
/// impl Observer for Flips {
///     fn observe(&mut self, step: Step) {
///         self.0 += usize::from(matches!(step.event, Event::EdgeFlipped { .. }));
///     }
/// }
///
/// let mut outline = Pslg::from_points([(0.0, 0.0), (9.0, 0.0), (7.0, 2.0), (0.0, 1.0)]);
/// outline.add_ring([0, 1, 2, 3]);
/// let quality = Quality { max_edge: Some(1.0), ..Quality::default() };
/// let thesis = Refinement::new(quality).domain(DomainRule::Carve).strategy(Strategy::Thesis);
/// let mut flips = Flips::default();
/// thesis.observe(outline, &mut flips)?;
/// assert!(flips.0 > 0);
/// # Ok::<(), delone::Error>(())
/// ```
pub trait Observer {
    /// Told of a step that has just been taken.
    fn observe(&mut self, step: Step);

    /// Tells whether anybody listens; if not, events are not even made.
    #[inline]
    fn is_watching(&self) -> bool {
        true
    }

    /// Tells whether the conflicts between triangles and points are to be [counted](Event::ConflictsCounted),
    /// which costs O(n) after every flip.
    #[inline]
    fn wants_conflicts(&self) -> bool {
        false
    }

    /// Makes an event and observes it, if anybody listens.
    #[inline]
    fn tell(&mut self, line: u16, event: impl FnOnce() -> Event)
    where
        Self: Sized,
    {
        if self.is_watching() {
            let event = event();
            self.observe(Step { line, event });
        }
    }
}

/// Observes nothing, at no cost.
impl Observer for () {
    #[inline]
    fn observe(&mut self, _: Step) {}

    #[inline]
    fn is_watching(&self) -> bool {
        false
    }
}

/// Two observers at once.
impl<A: Observer, B: Observer> Observer for (A, B) {
    fn observe(&mut self, step: Step) {
        self.0.observe(step);
        self.1.observe(step);
    }

    fn is_watching(&self) -> bool {
        self.0.is_watching() || self.1.is_watching()
    }

    fn wants_conflicts(&self) -> bool {
        self.0.wants_conflicts() || self.1.wants_conflicts()
    }
}

/// Someone who observes for another.
impl<O: Observer> Observer for &mut O {
    #[inline]
    fn observe(&mut self, step: Step) {
        (**self).observe(step);
    }

    #[inline]
    fn is_watching(&self) -> bool {
        (**self).is_watching()
    }

    #[inline]
    fn wants_conflicts(&self) -> bool {
        (**self).wants_conflicts()
    }
}
