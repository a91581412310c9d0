//! How two segments meet, beyond sharing ends.

use super::vertices::Vertices;
use crate::predicates::{Orientation, orient2d};

/// What two segments have in common, besides ends of both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meeting {
    /// They cross properly.
    Crossing,
    /// They are collinear and share more than a point.
    Overlap,
    /// An end of the second segment lies in the interior of the first.
    EndOfSecond(u32),
    /// An end of the first segment lies in the interior of the second.
    EndOfFirst(u32),
}

/// A segment by its ends, the lexicographically smaller first.
pub(super) type Ends = [u32; 2];

/// Reports everything that two different segments have in common.
///
/// *Cost*: one to four orientations.
#[inline]
pub(super) fn meet(vertices: &Vertices, s: Ends, t: Ends, mut report: impl FnMut(Meeting)) {
    let of_t = t.map(|v| side(vertices, s, v));
    match of_t {
        [Orientation::Collinear, Orientation::Collinear] => {
            return meet_on_a_line(vertices, s, t, report);
        }
        // All of t lies on one side.
        [c, d] if c == d => return,
        // The lines meet in the shared end, and nowhere else.
        _ if s.iter().any(|v| t.contains(v)) => return,
        _ => {}
    }
    let of_s = s.map(|v| side(vertices, t, v));
    let end_inside = |sides: [Orientation; 2], ends: Ends, of: Ends| {
        let on_line = sides.iter().position(|&o| o == Orientation::Collinear);
        on_line
            .map(|k| ends[k])
            .filter(|&v| vertices.is_inside(of, v))
    };
    if let Some(v) = end_inside(of_t, t, s) {
        report(Meeting::EndOfSecond(v));
    } else if let Some(v) = end_inside(of_s, s, t) {
        report(Meeting::EndOfFirst(v));
    } else if !of_t.contains(&Orientation::Collinear)
        && !of_s.contains(&Orientation::Collinear)
        && of_s[0] != of_s[1]
    {
        report(Meeting::Crossing);
    }
}

/// The side of a segment on which a vertex lies.
#[inline]
fn side(vertices: &Vertices, s: Ends, v: u32) -> Orientation {
    if s.contains(&v) {
        return Orientation::Collinear;
    }
    let [a, b] = s.map(|v| vertices.at(v));
    orient2d(a, b, vertices.at(v))
}

/// Reports what two collinear segments have in common.
fn meet_on_a_line(vertices: &Vertices, s: Ends, t: Ends, mut report: impl FnMut(Meeting)) {
    let mut inside = 0;
    for v in t.into_iter().filter(|&v| vertices.is_inside(s, v)) {
        report(Meeting::EndOfSecond(v));
        inside += 1;
    }
    for v in s.into_iter().filter(|&v| vertices.is_inside(t, v)) {
        report(Meeting::EndOfFirst(v));
        inside += 1;
    }
    // Different segments overlap only if an end of one is inside the other.
    if inside > 0 {
        report(Meeting::Overlap);
    }
}
