//! The convex hull of chapter 3.17: two chains, sorted, from which dents are deleted.
//!
//! The text drops all points on the line from leftmost to rightmost but these two; if nothing lies on one side
//! of it, they are on the hull's boundary, and belong to the result. Three points in a row are no dent.

use super::{About, Board, Input, Output, Takes};
use crate::predicates::Orientation;
use crate::{Error, Event, Observer, Point, VertexId};
use std::cmp::Ordering;

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "convex-hull",
    title: "convex hull by two chains",
    source: "Diploma thesis, Duisburg, about 1998, algorithm 3.17; Graham 1972, Andrew 1979",
    idea: "Sort what lies above the line from the leftmost point to the rightmost from right to left, what lies \
           below it from left to right, join both, and delete dents.",
    cost: "O(n log n)",
    guarantees: "all points on the hull's boundary, counter-clockwise from the rightmost; no triangles",
    takes: Takes::Points,
    is_delaunay: false,
    code: &[
        "t_l := the leftmost point (of several the lowest), t_r := the rightmost (the topmost)",
        "for each point t: above or below the line t_l t_r?",
        "sort those above by descending x, those below by ascending x; of equal x keep the outer",
        "join both chains to a polygon, beginning with t_r",
        "for each three consecutive points a, b, c of the polygon:",
        "  while c lies right of a → b: delete b, and go back by one",
    ],
};

/// Finds the hull.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let (mut board, order) = Board::new(input, observer)?;
    let polygon = match extremes(&board, &order) {
        Some([l, r]) if l != r => polygon(&mut board, &order, [l, r])?,
        _ => order,
    };
    let hull = delete_dents(&mut board, polygon)?;
    Ok(Output {
        hull,
        ..board.finish()
    })
}

/// The first and the last point, by x, then y.
fn extremes<O: Observer>(board: &Board<O>, order: &[VertexId]) -> Option<[VertexId; 2]> {
    let by = |v: &VertexId, w: &VertexId| board.point(*v).lex_cmp(&board.point(*w));
    let l = order.iter().copied().min_by(by)?;
    Some([l, order.iter().copied().max_by(by)?])
}

/// Both chains, joined.
fn polygon<O: Observer>(
    board: &mut Board<O>,
    order: &[VertexId],
    [l, r]: [VertexId; 2],
) -> Result<Vec<VertexId>, Error> {
    let (mut above, mut below, mut on) = (Vec::new(), Vec::new(), Vec::new());
    board.at(1);
    for vertex in [l, r] {
        board.tell(|| Event::PointConsidered { vertex });
    }
    board.at(2);
    for &t in order.iter().filter(|&&t| t != l && t != r) {
        board.step()?;
        match board.orient(l, r, t) {
            Orientation::Left => above.push(t),
            Orientation::Right => below.push(t),
            Orientation::Collinear => on.push(t),
        }
    }
    if below.is_empty() {
        below.append(&mut on);
    } else if above.is_empty() {
        above.append(&mut on);
    }
    board.at(3);
    let ends = [l, r].map(|v| board.point(v));
    let above = chain(board, above, ends, Ordering::reverse);
    let below = chain(board, below, ends, |order| order);
    board.at(4);
    let polygon = [&[r][..], &above, &[l], &below].concat();
    let sides = polygon.iter().zip(polygon.iter().cycle().skip(1));
    for (&a, &b) in sides.take(if polygon.len() == 2 { 1 } else { polygon.len() }) {
        board.tell(|| Event::EdgeCreated { edge: [a, b] });
    }
    Ok(polygon)
}

/// Sorts a chain by (x, y), for the upper one reversed, and of those above each other keeps the outer, but for
/// the abscissas of the ends: there all are on the boundary.
fn chain<O: Observer>(
    board: &Board<O>,
    mut chain: Vec<VertexId>,
    ends: [Point; 2],
    direct: impl Fn(Ordering) -> Ordering,
) -> Vec<VertexId> {
    let point = |v: VertexId| board.point(v);
    chain.sort_by(|&v, &w| direct(point(v).lex_cmp(&point(w))));
    // Either chain has the outer one first.
    let is_end = |x: f64| ends.iter().any(|end| end.x == x);
    chain.dedup_by(|v, kept| point(*v).x == point(*kept).x && !is_end(point(*v).x));
    chain
}

/// Deletes what lies within the hull from a polygon that begins with a vertex of it.
fn delete_dents<O: Observer>(
    board: &mut Board<O>,
    polygon: Vec<VertexId>,
) -> Result<Vec<VertexId>, Error> {
    if polygon.len() < 4 {
        return Ok(polygon);
    }
    let first = polygon[0];
    let mut hull: Vec<VertexId> = Vec::with_capacity(polygon.len());
    for c in polygon.into_iter().chain([first]) {
        board.step()?;
        while let [.., a, b] = hull[..] {
            board.at(5);
            if board.orient(a, b, c) != Orientation::Right {
                break;
            }
            board.at(6);
            for edge in [[a, b], [b, c]] {
                board.tell(|| Event::EdgeDeleted { edge });
            }
            board.tell(|| Event::EdgeCreated { edge: [a, c] });
            hull.pop();
        }
        hull.push(c);
    }
    hull.pop();
    Ok(hull)
}
