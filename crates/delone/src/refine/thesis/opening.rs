//! How a skinny triangle is opened: where the next vertex goes.

use super::code;
use super::sight::{lowest_around, sight};
use crate::predicates::{CircleSide, in_diametral_circle};
use crate::tables::{Side, Tables, Teller, circumcenter};
use crate::{Event, Observer};

/// Where the next vertex goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Opening {
    /// In the middle of the edge of this row.
    Bisect(u32),
    /// At the circumcenter of this triangle.
    Circumcenter(u32),
}

/// Decides how triangle ABC is opened; `sine` is that of the smallest angle wanted.
///
/// Without an angle of 90° or more its longest edge is bisected. Otherwise its circumcenter lies on or
/// beyond that edge, in a triangle PQR (of several the lowest number). If a constraint hides it from the
/// opposite corner, which includes that there is no PQR, the longest edge of ABC is bisected after all.
/// Else PQR is what is opened: by its circumcenter if its largest angle is below 90°, and, if its
/// longest edge is a constraint, by at least the angle wanted (the ε-rule: the circumcenter then stays
/// away from the constraint); else by bisecting its longest edge.
///
/// Angles are compared with 90° exactly, with 90° − ε in rounded cosines.
pub(super) fn opening<O: Observer>(
    tables: &Tables,
    t: u32,
    sine: f64,
    teller: &mut Teller<O>,
) -> Opening {
    let longest = longest_side(tables, t);
    let center = circumcenter(tables.corners(t));
    if seen_from_apex(tables, longest) == CircleSide::Outside || !center.is_finite() {
        teller.at(code::ACUTE);
        return bisect(tables, longest, teller);
    }
    teller.at(code::SIGHT);
    let Some(place) = sight(tables, longest, center, teller) else {
        teller.at(code::HIDDEN);
        return bisect(tables, longest, teller);
    };
    let other = lowest_around(tables, place);
    teller.tell(|names| Event::TriangleVisited {
        triangle: names.of(tables.triangles[other as usize]),
    });
    let longest = longest_side(tables, other);
    let row = tables.row_of(longest);
    let is_wide = seen_from_apex(tables, longest) != CircleSide::Outside
        || tables.row(row).is_constraint && tables.shape(other).largest_cosine < sine;
    if is_wide {
        teller.at(code::WIDE);
        return bisect(tables, longest, teller);
    }
    teller.at(code::INSERT);
    Opening::Circumcenter(other)
}

/// Chooses to bisect the longest side of a triangle instead of using its circumcenter.
fn bisect<O: Observer>(tables: &Tables, longest: Side, teller: &mut Teller<O>) -> Opening {
    teller.tell(|names| Event::CircumcenterRejected {
        triangle: names.of(tables.triangles[longest.triangle as usize]),
        edge: names.of(tables.ends(longest)),
    });
    Opening::Bisect(tables.row_of(longest))
}

fn longest_side(tables: &Tables, t: u32) -> Side {
    Side::new(t, tables.shape(t).longest)
}

/// Tells whether the angle opposite a side is above 90° (`Inside`), exactly that, or below.
fn seen_from_apex(tables: &Tables, side: Side) -> CircleSide {
    let [a, b] = tables.ends(side).map(|v| tables.point(v));
    in_diametral_circle(a, b, tables.point(tables.apex(side)))
}
