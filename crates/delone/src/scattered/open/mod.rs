//! A vertex inside a triangle that holds at least 3d data, so that the three new triangles hold at least d each.
//!
//! ```text
//!            t0            part k is the sub-triangle opposite corner k. A datum lies in part k if and only if
//!          / | \           it is not right of the way from t to the next corner, and not left of that from t to
//!        /   |   \         the one after. On a line it lies in two parts, in t in all, and chooses.
//!      / 1  _t_  2 \
//!    /   _-  0  -_   \
//!  t1 ---------------- t2
//! ```
//!
//! [`PointSearch`] is the search of the text, exact and step by step. [`open_at`] is what triangulations are
//! made with. It tries, in this order: the center of gravity, as the text does; a [`balanced`] place, in floats,
//! from which it goes back towards the center as far as data allow; and last the exact search, points
//! [`nearby`] where it ends, and data. Whatever is tried is a point with double-precision coordinates, and all tests of it
//! are exact.
//!
//! *Cost*: O(m) for m data if the center does, about 10 ns each; O(m log m) in practice for a balanced place, of
//! which a sample of many data is enough. The exact search is for up to a few thousand data.
//!
//! *Does not* find every such point there is: data may be so much on lines through corners that only points
//! exactly on such a line will do, or on several. If few or none of these have such coordinates, the result
//! may be `None`; so it is in triangles a few units in the last place wide. (Of 136,700 triangles and data on
//! lattices of up to ten times ten, that have a place by [`conditions`], all were opened but three, for
//! which no multiples of 1/16 do.)

mod balanced;
mod conditions;
mod nearby;
mod parts;
mod stepwise;

pub(super) use conditions::conditions;
pub use stepwise::{Counting, Move, Next, PointSearch, SearchStep, Steps};

use super::share::share;
use crate::Point;
use parts::Division;

/// Most data for the exact search.
const MOST_EXACT: usize = 4096;

/// Most data that are tried themselves.
const MOST_TRIED: usize = 256;

/// Most data from which a balanced place is looked for; of more, a sample is taken.
const SAMPLE: usize = 2048;

/// How often the way from the center to a balanced place is halved.
const HALVINGS: usize = 3;

/// A vertex that opens a triangle, and who has which datum then.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Opening {
    /// Where it is: strictly inside.
    pub at: Point,
    /// For each datum the corner opposite which the new triangle lies that has it.
    pub shares: Vec<u8>,
}

/// Finds a point strictly inside a counter-clockwise triangle such that each of the three sub-triangles can have at
/// least `least` of the data, which lie in the triangle and are different from each other; data on an edge between
/// two, or at the point, choose.
pub(super) fn open_at(corners: [Point; 3], data: &[Point], least: usize) -> Option<Opening> {
    if data.len() / 3 < least {
        return None;
    }
    let division = Division::new(corners, data, least);
    let at = choose(&division)?;
    let options: Vec<_> = division.options(at).collect();
    let shares = share(&options, 3, least)?;
    Some(Opening { at, shares })
}

/// As [`open_at`], but moves the point as the text does: `tell` hears of each place, with the counts of closed
/// sub-triangles, opposite corners 0, 1 and 2. Where the search ends between double-precision points, or there are too
/// many data for it, the result is that of [`open_at`].
pub(super) fn open_stepwise(
    corners: [Point; 3],
    data: &[Point],
    least: usize,
    mut tell: impl FnMut(Point, [usize; 3]),
) -> Option<Opening> {
    let division = Division::new(corners, data, least);
    if data.len() <= MOST_EXACT && conditions::hold(&division) {
        let search = PointSearch::new(corners, data, least, Counting::Unique).ok()?;
        for step in search {
            tell(step.at, step.counts);
            if matches!(step.next, Next::Found) && division.is_good(step.at) {
                let options: Vec<_> = division.options(step.at).collect();
                let shares = share(&options, 3, least)?;
                return Some(Opening {
                    at: step.at,
                    shares,
                });
            }
        }
    }
    let opening = open_at(corners, data, least)?;
    tell(opening.at, division.counts(opening.at));
    Some(opening)
}

/// Tries one way after the other.
fn choose(division: &Division) -> Option<Point> {
    let center = balanced::place(division.corners, [1.0; 3]);
    if division.is_good(center) {
        return Some(center);
    }
    if let Some(at) = balanced_place(division) {
        return Some(towards(division, center, at));
    }
    let may_be_searched = division.data.len() <= MOST_EXACT && conditions::hold(division);
    may_be_searched.then(|| searched(division)).flatten()
}

/// A place where the sub-triangles have about the same number of data.
fn balanced_place(division: &Division) -> Option<Point> {
    let Division {
        corners,
        data,
        least,
    } = *division;
    let find = |step: usize| {
        let sample: Vec<Point> = data.iter().copied().step_by(step).collect();
        let weights = balanced::weights(corners, &sample, least / step);
        let mut places = weights.into_iter().map(|w| balanced::place(corners, w));
        places.find(|&at| division.is_good(at))
    };
    let step = data.len().div_ceil(SAMPLE);
    let sampled = (step > 1).then(|| find(step)).flatten();
    sampled.or_else(|| find(1))
}

/// Goes from a good place towards the center, where triangles have better shapes, as far as a few halvings tell.
fn towards(division: &Division, center: Point, good: Point) -> Point {
    let (mut best, mut share) = (good, 1.0);
    let mut width = 0.5;
    for _ in 0..HALVINGS {
        let at = between(center, good, share - width);
        if division.is_good(at) {
            (best, share) = (at, share - width);
        }
        width /= 2.0;
    }
    best
}

fn between(a: Point, b: Point, share: f64) -> Point {
    let mixed = |a: f64, b: f64| a * (1.0 - share) + b * share;
    Point::new(mixed(a.x, b.x), mixed(a.y, b.y))
}

/// The exact search, and what lies near where it ends; or else one of the data, for on its lines to the
/// corners others may lie.
fn searched(division: &Division) -> Option<Point> {
    let Division {
        corners,
        data,
        least,
    } = *division;
    let search = PointSearch::new(corners, data, least, Counting::Unique).ok()?;
    let (place, lines) = search.found()?;
    let on_lines = lines.map(|datum| datum.map(|datum| data[datum]));
    let own = &data[..data.len().min(MOST_TRIED)];
    let mut places = nearby::places(corners, &place, on_lines).chain(own.iter().copied());
    places.find(|&at| division.is_good(at))
}

#[cfg(test)]
mod tests;
