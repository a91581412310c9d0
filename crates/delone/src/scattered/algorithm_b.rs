//! Algorithm B (chapter 3.34 to 3.37): vertices on edges, and on the other diagonals of quadrilaterals.
//!
//! Goes through the triangles, those with most data first, and stays at its place j in their order as long as the
//! triangle there can be divided. Since others come to be before it when the order changes, some are never looked at;
//! those that hold too many then are left to Algorithm C.
//!
//! *Corrected*: the text compares with 4k where it means 4d.
//!
//! *Ends*: each vertex makes more triangles, of which there are at most l/d; without one, j grows.
//!
//! *Cost*: O(n) in practice for each triangle that is looked at, and its n data and its neighbours', and O(log m) for each
//! triangle that changes.

use super::Cover;
use super::edges::{Found, Listener, Plot, search};
use super::field::Field;
use super::ranking::Ranking;
use crate::predicates::{Orientation, compare_lengths, cross_properly, orient2d};
use crate::{Error, Event, HalfEdgeId, Observer, Point, Stage, TriangleId, VertexId};

/// What is told as it runs, line by line; counted from 1.
pub(crate) const CODE_B: &[&str] = &[
    "T := all triangles, those that hold most data first; j := 1",
    "while there is a T[j], and it holds 2d data or more:",
    "  for each edge of T[j], opposite the largest, then the second, then the smallest angle, until there is a place:",
    "    if it is an outer edge: search it for a place that makes two triangles of d data or more",
    "    else if T[j] and its neighbour there hold 4d or more together:",
    "      if they form a strictly convex quadrilateral: search its other diagonal for a place that makes four",
    "      if there is no place yet: search the edge for one",
    "  if there is none: j := j + 1",
    "  else: put a vertex t there, and join it to all corners",
    "    if t lies inside T[j] or its neighbour: swap the edge from t into the other one, if that is better",
    "    swap edges opposite t as long as that is better; put T in order again",
    "search a segment: i := 1, and begin in the middle; while i < N:",
    "  if all triangles hold d: this is the place",
    "  if one at each end holds fewer: give up",
    "  if one at the start does: go 1/2^(i+1) of the segment towards its end, else towards its start; i := i + 1",
];

mod line {
    pub const BEGIN: u16 = 1;
    pub const NEXT: u16 = 2;
    pub const EDGE: u16 = 3;
    pub const FAIL: u16 = 8;
    pub const DIVIDE: u16 = 9;
    pub const OLD_EDGE: u16 = 10;
    pub const OPTIMIZE: u16 = 11;
    pub const TRY: u16 = 13;
}

/// Runs it: triangles hold no fewer than `options.least` data afterwards, if none did before.
///
/// # Errors
/// [`Error::TooManyPoints`], [`Error::Cancelled`].
pub(super) fn run(field: &mut Field<impl Observer>, options: &Cover) -> Result<(), Error> {
    field.at(line::BEGIN);
    let mut ranking = Ranking::default();
    let all: Vec<_> = field.draft.mesh.triangles().collect();
    all.into_iter().for_each(|t| field.stock.touch(t));
    update(&mut ranking, field);
    while let Some((t, count)) = ranking.current() {
        field.at(line::NEXT);
        if count < 2 * options.least {
            break;
        }
        let triangle = field.names(t);
        field.tell(|| Event::TriangleConsidered { triangle });
        if divide(field, t, options)? {
            update(&mut ranking, field);
        } else {
            field.at(line::FAIL);
            field.tell(|| Event::DivisionFailed { triangle });
            ranking.pass();
        }
    }
    field.tell(|| Event::StageEnded {
        stage: Stage::DivideEdges,
        min_angle: None,
    });
    Ok(())
}

/// Puts a vertex on an edge, if there is a place where the triangles there hold `options.least` data each, although its
/// triangles need not hold four times as many: one of them, the special case of 3.41, holds twice as many on the edge
/// itself. Tells whether it did; if not, nothing has changed.
///
/// # Errors
/// [`Error::TooManyPoints`], [`Error::Cancelled`].
pub(super) fn divide_at(
    field: &mut Field<impl Observer>,
    h: HalfEdgeId,
    options: &Cover,
) -> Result<bool, Error> {
    let [a, b, _] = field.edge(h);
    let is_on = |p: &Point| orient2d(a, b, *p) == Orientation::Collinear;
    let mut sides = sides(field, h).into_iter();
    if !sides.any(|t| field.data_of(t).filter(is_on).count() >= 2 * options.least) {
        return Ok(false);
    }
    let way = if field.is_outer(h) {
        Way::Outer
    } else {
        Way::Edge
    };
    divide_along(field, h, way, options)
}

/// Takes note of the triangles that have changed.
fn update(ranking: &mut Ranking, field: &mut Field<impl Observer>) {
    let mut touched: Vec<_> = field.stock.drain_touched().collect();
    touched.sort_unstable();
    touched.dedup();
    for t in touched {
        if t.index() < field.draft.mesh.num_faces() && !field.draft.mesh.is_ghost(t) {
            ranking.set(t, field.stock.count(t));
        }
    }
}

/// Algorithm 3.35: puts a vertex on an edge of triangle `t`, or on a diagonal beside it; false if there is no place.
fn divide(field: &mut Field<impl Observer>, t: TriangleId, options: &Cover) -> Result<bool, Error> {
    for h in longest_first(field, t) {
        field.at(line::EDGE);
        let edge = [field.draft.mesh.origin(h), field.draft.mesh.dest(h)].map(|v| field.name(v));
        field.tell(|| Event::EdgeExamined { edge });
        for way in ways(field, h, options.least) {
            if divide_along(field, h, *way, options)? {
                return Ok(true);
            }
        }
    }
    Ok(false)
}

/// Lists the edges of a triangle, those opposite larger angles first, which are the longer ones; of equal ones that of the
/// lowest slot.
fn longest_first(field: &Field<impl Observer>, t: TriangleId) -> [HalfEdgeId; 3] {
    let mut edges = t.half_edges();
    let ends = |h: HalfEdgeId| {
        let [a, b, _] = field.edge(h);
        [a, b]
    };
    edges.sort_by(|&h, &g| compare_lengths(ends(g), ends(h)));
    edges
}

/// Where to look for a place.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// On an outer edge.
    Outer,
    /// On an edge inside.
    Edge,
    /// On the other diagonal of its quadrilateral.
    Diagonal,
}

/// Lists where to look beside an edge.
fn ways(field: &Field<impl Observer>, h: HalfEdgeId, least: usize) -> &'static [Way] {
    if field.is_outer(h) {
        return &[Way::Outer];
    }
    let held: usize = sides(field, h).iter().map(|&t| field.stock.count(t)).sum();
    let [a, b, c, d] = quadrilateral(field, h);
    if held < 4 * least {
        &[]
    } else if cross_properly([a, b], [c, d]) {
        &[Way::Diagonal, Way::Edge]
    } else {
        &[Way::Edge]
    }
}

/// Lists the triangles at an edge, that of `h` first.
fn sides(field: &Field<impl Observer>, h: HalfEdgeId) -> Vec<TriangleId> {
    let mut sides = vec![h.triangle()];
    if !field.is_outer(h) {
        sides.push(field.draft.mesh.twin(h).triangle());
    }
    sides
}

/// The ends of an inner edge, what is opposite, and what is opposite beyond.
fn quadrilateral(field: &Field<impl Observer>, h: HalfEdgeId) -> [Point; 4] {
    let [a, b, c] = field.edge(h);
    let [_, _, d] = field.edge(field.draft.mesh.twin(h));
    [a, b, c, d]
}

/// Puts a vertex on an edge or a diagonal, if there is a place; false if not.
fn divide_along(
    field: &mut Field<impl Observer>,
    h: HalfEdgeId,
    way: Way,
    options: &Cover,
) -> Result<bool, Error> {
    let sides = sides(field, h);
    let data: Vec<Point> = sides.iter().flat_map(|&t| field.data_of(t)).collect();
    field.spend(8 * data.len())?;
    let Some(found) = find(field, h, way, &data, options) else {
        return Ok(false);
    };
    let old_edge = match way {
        Way::Diagonal => across(field, h, found.at),
        _ => None,
    };
    field.at(line::DIVIDE);
    let v = field.divide_edge(h, found.at, &found.shares)?;
    field.advance()?;
    if options.optimizes {
        optimize(field, v, old_edge, options.least)?;
    }
    Ok(true)
}

/// Looks for a place.
fn find(
    field: &mut Field<impl Observer>,
    h: HalfEdgeId,
    way: Way,
    data: &[Point],
    options: &Cover,
) -> Option<Found> {
    let plot = match way {
        Way::Outer => Plot::outer(field.edge(h), data),
        Way::Edge => Plot::edge(quadrilateral(field, h), data),
        Way::Diagonal => Plot::diagonal(quadrilateral(field, h), data),
    };
    field.at(line::TRY);
    let is_watched = field.is_watched();
    let mut tell = |at, counts: [usize; 4]| {
        let counts = counts.map(|count| count as u32);
        field.tell(|| Event::PlaceTried { at, counts });
    };
    let listener = match is_watched {
        true => Listener::Told(&mut tell),
        false => Listener::Nobody,
    };
    let found = search(&plot, options.least, options.bisections, listener)?;
    let is_good = way != Way::Outer || field.is_free(h, found.at);
    is_good.then_some(found)
}

/// Returns the corner beyond the edge of `h` from a place strictly inside one of its two triangles.
fn across(field: &Field<impl Observer>, h: HalfEdgeId, at: Point) -> Option<VertexId> {
    let mesh = &field.draft.mesh;
    match field.draft.side_of(h, at) {
        Orientation::Left => Some(mesh.apex(mesh.twin(h))),
        Orientation::Right => Some(mesh.apex(h)),
        Orientation::Collinear => None,
    }
}

/// Algorithm 3.37: flips edges around a new vertex; before all others the one that leads over an edge that was there
/// before, to corner `across`, which brings that edge back.
fn optimize(
    field: &mut Field<impl Observer>,
    v: VertexId,
    across: Option<VertexId>,
    least: usize,
) -> Result<(), Error> {
    field.at(line::OLD_EDGE);
    if let Some(spoke) = across.and_then(|corner| field.draft.find_edge(v, corner).ok()) {
        field.swap(spoke, least)?;
    }
    field.at(line::OPTIMIZE);
    field.optimize(v, least)?;
    Ok(())
}

#[cfg(test)]
mod tests;
