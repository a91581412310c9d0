//! The search for a place (chapter 3.36): halving the segment.
//!
//! Begins in the middle. Where a triangle at one end of the segment holds too few data the next place is farther from that
//! end, by half the step before. If there is such a triangle at each end, no place will do, and the search is given
//! up: one of them only becomes smaller.
//!
//! The text counts a datum between two triangles for both. Here it can be in one only, and so a place may fail though
//! all counts are enough. Then the search goes on as if the two triangles at the start were short, if together they have
//! fewer than they need, or those at the end likewise; if both, it is given up; if neither, it goes on towards the start, as
//! the text does in any other case.
//!
//! *Cost*: O(n) for each place that the [forecast](super::forecast) leaves open, of N − 1.

use super::forecast::Forecast;
use super::plot::{Plot, Tally};
use crate::Point;
use crate::scattered::share::share;

/// A place that is good, and for each datum the part to which it goes.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Found {
    pub at: Point,
    pub shares: Vec<u8>,
}

/// What a place is worth.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Verdict {
    /// There is enough everywhere; who gets what.
    Good(Vec<u8>),
    /// Too few at the start of the segment.
    ShortAtStart,
    /// Too few at its end.
    ShortAtEnd,
    /// Both.
    Hopeless,
}

impl Verdict {
    /// Reads it from what is short at the start, and at the end.
    pub fn short([start, end]: [bool; 2]) -> Self {
        match (start, end) {
            (true, true) => Self::Hopeless,
            (true, false) => Self::ShortAtStart,
            (false, _) => Self::ShortAtEnd,
        }
    }
}

/// Who hears of the places that are tried. The place that is found is the same.
pub(in super::super) enum Listener<'t> {
    /// Nobody: data are counted only where the verdict is not known beforehand.
    Nobody,
    /// This one, of each place and what the parts would hold there.
    Told(&'t mut dyn FnMut(Point, [usize; 4])),
}

/// Looks for a place on the segment of a plot where each part gets at least `least` data, and tries fewer than
/// `bisections` places.
///
/// Ends for any number: the step becomes too small to matter after some fifty places, or a thousand near the start.
pub(in super::super) fn search(
    plot: &Plot,
    least: usize,
    bisections: u32,
    mut listener: Listener,
) -> Option<Found> {
    if plot.data.len() / plot.num_parts() < least {
        return None;
    }
    let forecast = match listener {
        Listener::Nobody => Some(Forecast::new(plot, least)),
        Listener::Told(_) => None,
    };
    if forecast.as_ref().is_some_and(|f| f.is_hopeless(bisections)) {
        return None;
    }
    let (mut b, mut step) = (0.5, 0.25);
    for _ in 1..bisections {
        let at = plot.place(b)?;
        let known = forecast.as_ref().and_then(|f| f.judge(plot, b, at));
        let verdict = known.unwrap_or_else(|| {
            let tally = plot.tally(at);
            if let Listener::Told(tell) = &mut listener {
                tell(at, tally.counts);
            }
            judge(plot, &tally, least)
        });
        let next = match verdict {
            Verdict::Good(shares) => return Some(Found { at, shares }),
            Verdict::ShortAtStart => b + step,
            Verdict::ShortAtEnd => b - step,
            Verdict::Hopeless => return None,
        };
        if next == b {
            return None;
        }
        (b, step) = (next, step / 2.0);
    }
    None
}

/// Judges a place by what its parts would hold.
fn judge(plot: &Plot, tally: &Tally, least: usize) -> Verdict {
    let parts = 0..plot.num_parts();
    let is_at_start = |k: &usize| plot.at_start() >> k & 1 != 0;
    let (start, end): (Vec<_>, Vec<_>) = parts.partition(is_at_start);
    let is_short = |parts: &[usize]| parts.iter().any(|&k| tally.counts[k] < least);
    let short = [&start, &end].map(|parts| is_short(parts));
    if short.contains(&true) {
        return Verdict::short(short);
    }
    if let Some(shares) = share(&tally.options, plot.num_parts(), least) {
        return Verdict::Good(shares);
    }
    let is_short_together = |parts: &[usize]| {
        let mask = parts.iter().fold(0, |mask, k| mask | 1 << k);
        let may = tally.options.iter().filter(|&o| o & mask != 0);
        may.count() < parts.len() * least
    };
    Verdict::short([&start, &end].map(|parts| is_short_together(parts)))
}
