//! What can be seen from a corner of a triangle, if only constraints block the view.

use crate::predicates::{Orientation, orient2d};
use crate::tables::{Side, Tables, Teller};
use crate::{Event, Observer, Point};

/// Where in the mesh a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// In the interior of a triangle.
    Triangle(u32),
    /// In the interior of an edge; the triangle from which it was seen, and the edge's position there.
    Edge(Side),
    /// On the corner opposite this side.
    Vertex(Side),
}

/// Looks from the corner opposite `side` across it towards `goal`: finds where that lies, or `None` if a
/// constraint crosses the line of sight, a vertex lies on it, or it does not lead across `side`.
///
/// Every sign is exact, so the straight way ends: each triangle is passed once.
pub(super) fn sight<O: Observer>(
    tables: &Tables,
    side: Side,
    goal: Point,
    teller: &mut Teller<O>,
) -> Option<Place> {
    let eye = tables.point(tables.apex(side));
    let [right, left] = tables.ends(side).map(|v| tables.point(v));
    let is_ahead = orient2d(eye, right, goal) == Orientation::Left
        && orient2d(eye, goal, left) == Orientation::Left;
    if !is_ahead {
        return None;
    }
    let mut side = side;
    loop {
        match tables.orient(side, goal) {
            Orientation::Left => return Some(Place::Triangle(side.triangle)),
            Orientation::Collinear => return Some(Place::Edge(side)),
            Orientation::Right => {}
        }
        if tables.row(tables.row_of(side)).is_constraint {
            return None;
        }
        let entered = tables.across(side)?;
        teller.tell(|names| Event::WalkStepped {
            edge: names.of(tables.ends(side)),
        });
        let apex = tables.point(tables.apex(entered));
        side = match orient2d(eye, goal, apex) {
            Orientation::Left => entered.next(),
            Orientation::Right => entered.prev(),
            Orientation::Collinear if apex == goal => return Some(Place::Vertex(entered)),
            Orientation::Collinear => {
                // The apex lies behind the goal or hides it.
                let is_hidden = eye.lex_cmp(&apex) == apex.lex_cmp(&goal);
                return (!is_hidden).then_some(Place::Triangle(entered.triangle));
            }
        };
    }
}

/// The triangle of lowest number that contains a point: borders count.
pub(super) fn lowest_around(tables: &Tables, place: Place) -> u32 {
    match place {
        Place::Triangle(t) => t,
        Place::Edge(side) => {
            let other = tables.across(side).map(|side| side.triangle);
            side.triangle.min(other.unwrap_or(u32::MAX))
        }
        Place::Vertex(side) => {
            // Around the corner opposite `side`, one way and the other until the border.
            let star = |turn: fn(&Tables, Side) -> Option<Side>| {
                let next = move |&s: &Side| turn(tables, s).filter(|&s| s != side);
                let star = std::iter::successors(Some(side), next);
                star.map(|s| s.triangle).min().unwrap_or(side.triangle)
            };
            let left = star(|tables, s| Some(tables.across(s.prev())?.prev()));
            let right = star(|tables, s| Some(tables.across(s.next())?.next()));
            left.min(right)
        }
    }
}
