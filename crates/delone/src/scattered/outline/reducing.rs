//! A corner less (3.31): an edge shrinks to the point where the lines of its neighbours meet.
//!
//! ```text
//!           t              The polygon becomes the convex hull of itself and t. As t is beyond ab, and not left
//!          / \             of pa and bq, neither a nor b is a corner of that. Where t has been rounded away from
//!         a───b            the lines, p and q may be corners no longer: whoever sees t not strictly to the left
//!        /     \           goes, too; there are few, and all next to t, because what t sees of a convex polygon
//!       p       q          is connected.
//! ```
//!
//! So the polygon grows, exactly, and loses a corner at least. That t is rounded outwards means: into the cone
//! beyond the exact point, between the two lines. Lines that meet too [far](FARTHEST) away count as parallel.
//!
//! *Cost*: O(log h) for a polygon that had h corners, and about 2 µs for the point.

use super::{Outline, Ring};
use crate::Point;
use crate::predicates::{Orientation, compare_distances, meeting_of_lines, orient2d};

/// How far a corner may be from the enclosing triangle, by its legs: 2²⁵, half the digits of a number. A rectangle
/// that is not parallel to the axes has, when rounded, sides that do meet, a billion times as far away: a needle.
const FARTHEST: f64 = (1_u32 << 25) as f64;

/// What has become of the polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::scattered) enum Reduction {
    /// An edge has shrunk.
    Edge {
        /// The numbers of its ends; the first one is now that of the new corner.
        ends: [usize; 2],
        /// Where it is.
        at: Point,
    },
    /// No edge could: it has become the enclosing triangle, with corners 0, 1 and 2.
    Enclosed,
}

impl Outline {
    /// Lets the shortest edge shrink whose interior angles sum to more than π (of several that of lowest
    /// number). If there is none, or no double-precision point near the right place is beyond its neighbours'
    /// lines, the polygon becomes the enclosing triangle. `None` if it is a triangle already.
    ///
    /// It contains what it contained, or, if [enclosed](Reduction::Enclosed), all data.
    pub fn reduce(&mut self) -> Option<Reduction> {
        if self.is_triangle() {
            return None;
        }
        let shortest = self.edges.pop();
        let found = shortest.and_then(|i| Some((i, outer_meeting(&self.ring, i, self.enclosing)?)));
        Some(match found {
            Some((i, at)) => self.shrink(i, at),
            None => {
                *self = Self::of(self.enclosing.to_vec(), self.enclosing);
                Reduction::Enclosed
            }
        })
    }

    /// Replaces both ends of the edge that begins in corner `i`.
    fn shrink(&mut self, i: usize, at: Point) -> Reduction {
        let ring = &mut self.ring;
        let ends = [i, ring.next[i]];
        ring.places[i] = at;
        self.edges.forget(ends[1]);
        ring.unlink(ends[1]);
        for neighbor in [
            |r: &Ring, i: usize| r.previous[i],
            |r: &Ring, i: usize| r.next[i],
        ] {
            // It ends: a triangle has no corner to spare.
            loop {
                let beside = neighbor(ring, i);
                if is_strict(ring, beside) {
                    break;
                }
                self.edges.forget(beside);
                ring.unlink(beside);
            }
        }
        // Their ends have changed, or those of an edge beside them.
        let before = ring.previous[i];
        for from in [ring.previous[before], before, i, ring.next[i]] {
            self.edges.renew(ring, from);
        }
        Reduction::Edge { ends, at }
    }
}

/// Tells whether a polygon turns left in a corner, or has no corner to spare.
fn is_strict(ring: &Ring, i: usize) -> bool {
    let [before, after] = [ring.previous[i], ring.next[i]].map(|k| ring.at(k));
    ring.count == 3 || orient2d(before, ring.at(i), after) == Orientation::Left
}

/// Finds the point where the neighbours of the edge that begins in corner `i` meet, rounded outwards.
///
/// If the nearest points are not in the cone, because it is narrow, the search goes on farther out in it.
fn outer_meeting(ring: &Ring, i: usize, [origin, x, y]: [Point; 3]) -> Option<Point> {
    let [p, a, b, q] = ring.around(i).map(|k| ring.at(k));
    let meeting = meeting_of_lines([p, a], [q, b])?;
    let farthest = FARTHEST * (x.x - origin.x).max(y.y - origin.y);
    let is_near =
        |t: Point| (t.x - origin.x).abs() <= farthest && (t.y - origin.y).abs() <= farthest;
    let is_wanted = |t: Point| {
        t.is_finite()
            && is_near(t)
            && orient2d(a, b, t) == Orientation::Right
            && orient2d(p, a, t) != Orientation::Left
            && orient2d(b, q, t) != Orientation::Left
    };
    let outwards = [[p, a], [q, b]].map(direction);
    let outwards = [0, 1].map(|k| outwards[0][k] + outwards[1][k]);
    let unit = meeting.x.abs().max(meeting.y.abs()) * f64::EPSILON;
    // Half the digits of a number: farther out it would be another polygon.
    let reaches = (0..=12).map(|k| {
        if k == 0 {
            0.0
        } else {
            f64::from(1 << (2 * k)) * unit
        }
    });
    reaches
        .map(|reach| {
            let [x, y] = outwards.map(|c| reach * c);
            Point::new(meeting.x + x, meeting.y + y)
        })
        .find_map(|center| nearest_around(center, is_wanted))
}

/// Returns the direction of a segment, as a vector of about length one; zero if that overflows.
fn direction([from, to]: [Point; 2]) -> [f64; 2] {
    let vector = [to.x - from.x, to.y - from.y];
    let size = vector[0].abs().max(vector[1].abs());
    let vector = vector.map(|c| c / size);
    if vector[0].is_finite() && vector[1].is_finite() {
        vector
    } else {
        [0.0; 2]
    }
}

/// Finds, of a point and those up to two units in the last place beside it, the nearest one that is wanted.
fn nearest_around(center: Point, is_wanted: impl Fn(Point) -> bool) -> Option<Point> {
    if is_wanted(center) {
        return Some(center);
    }
    let [x, y] = [center.x, center.y].map(beside);
    let all = x.into_iter().flat_map(|x| y.map(|y| Point::new(x, y)));
    let wanted = all.filter(|&p| is_wanted(p));
    wanted.min_by(|&p, &q| compare_distances(center, p, q))
}

/// Returns a number and its neighbours.
fn beside(c: f64) -> [f64; 5] {
    let [below, above] = [c.next_down(), c.next_up()];
    // Adding zero turns −0.0 into 0.0.
    [below.next_down(), below, c, above, above.next_up()].map(|c| c + 0.0)
}
