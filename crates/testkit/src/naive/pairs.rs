//! How two segments, or a segment and a point, lie; by exact signs.

use delone::Point;
use delone::predicates::{Orientation, orient2d};

/// A segment as its two ends, which differ.
pub(super) type Ends = [Point; 2];

/// Tells whether two segments cross in a point of the interior of both, and nowhere else.
pub(super) fn cross(s: Ends, t: Ends) -> bool {
    boxes_meet(s, t) && parts(s, t) && parts(t, s)
}

/// Tells whether two segments share more than a point.
pub(super) fn overlap(s: Ends, t: Ends) -> bool {
    let along = |[a, b]: Ends| {
        if a.lex_cmp(&b).is_lt() {
            [a, b]
        } else {
            [b, a]
        }
    };
    let ([a, b], [c, d]) = (along(s), along(t));
    let is_on_line = |p| orient2d(a, b, p) == Orientation::Collinear;
    c.lex_cmp(&b).is_lt() && a.lex_cmp(&d).is_lt() && is_on_line(c) && is_on_line(d)
}

/// Tells whether `p` lies in the interior of a segment.
pub(super) fn is_inside([a, b]: Ends, p: Point) -> bool {
    p != a && p != b && boxes_meet([a, b], [p, p]) && orient2d(a, b, p) == Orientation::Collinear
}

/// Tells whether the ends of `t` lie strictly on different sides of the line of `s`.
fn parts([a, b]: Ends, t: Ends) -> bool {
    let [c, d] = t.map(|p| orient2d(a, b, p));
    c != Orientation::Collinear && c == d.reversed()
}

fn boxes_meet([a, b]: Ends, [c, d]: Ends) -> bool {
    let meet = |a: f64, b: f64, c: f64, d: f64| a.min(b) <= c.max(d) && c.min(d) <= a.max(b);
    meet(a.x, b.x, c.x, d.x) && meet(a.y, b.y, c.y, d.y)
}
