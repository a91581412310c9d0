//! `split_edges`: the segments in even pieces, before there is a mesh.

use super::code;
use super::limits::Limits;
use crate::constrained::Steiner;
use crate::tables::length;
use crate::{ConstrainedTriangulation, Event, Observer, Outcome, Point, TriangleId, VertexId};

/// Divides every constrained edge of the domain that is longer than `bound` into the fewest even pieces
/// that are not. Edges are visited by their smaller, then their larger vertex; the pieces begin at the
/// larger one.
///
/// # Errors
/// Why it stopped: the budget, or two divisions that round to one.
pub(super) fn split_edges(
    t: &ConstrainedTriangulation,
    bound: f64,
    steiner: &mut Steiner,
    limits: &mut Limits,
    observer: &mut impl Observer,
) -> Result<(), Outcome> {
    let vertices = t.triangulation().points().len();
    for ends in edges(t) {
        observer.tell(code::SEGMENTS, || Event::EdgeExamined { edge: ends });
        let [b, a] = ends.map(|v| t.triangulation().point(v));
        // In floats: there may be more pieces than integers.
        let pieces = (length(a, b) / bound).ceil();
        let (mut before, mut last) = (a, ends[1]);
        let mut i = 1.0;
        while i < pieces {
            let vertex = VertexId::new(vertices + steiner.points.len());
            limits.admit(vertex.index(), 0)?;
            let at = between(a, b, i / pieces);
            let is_new = before.lex_cmp(&at) == a.lex_cmp(&b) && at.lex_cmp(&b) == a.lex_cmp(&b);
            if !is_new {
                return Err(Outcome::PrecisionLimit);
            }
            let edge = [last, ends[0]];
            steiner.push(at, Some(edge));
            tell_division(edge, vertex, at, observer);
            (before, last) = (at, vertex);
            i += 1.0;
        }
    }
    Ok(())
}

/// Tells that a segment is divided at a new vertex, before there are triangles.
fn tell_division(edge: [VertexId; 2], vertex: VertexId, at: Point, observer: &mut impl Observer) {
    let mut tell = |event| observer.tell(code::DIVIDE, || event);
    tell(Event::VertexCreated { vertex, at });
    tell(Event::SegmentSplit { edge, vertex });
    tell(Event::EdgeUnlocked { edge });
    tell(Event::EdgeDeleted { edge });
    for edge in edge.map(|end| [end, vertex]) {
        tell(Event::EdgeCreated { edge });
        tell(Event::EdgeLocked { edge });
    }
}

/// Lists the constrained edges of the domain's triangles, the smaller end first, in order.
fn edges(t: &ConstrainedTriangulation) -> Vec<[VertexId; 2]> {
    let mesh = t.triangulation().mesh();
    let triangles = (0..t.triangulation().num_triangles()).map(TriangleId::new);
    let half_edges = triangles.flat_map(TriangleId::half_edges);
    let ends = half_edges.filter(|&h| t.is_constrained(h)).map(|h| {
        let [a, b] = [mesh.origin(h), mesh.dest(h)];
        [a.min(b), a.max(b)]
    });
    let mut edges: Vec<_> = ends.collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// The point at a fraction of the way from `a` to `b`.
fn between(a: Point, b: Point, fraction: f64) -> Point {
    let at = |a: f64, b: f64| {
        let way = b - a;
        if way.is_finite() {
            a + fraction * way
        } else {
            (1.0 - fraction) * a + fraction * b
        }
    };
    Point::new(at(a.x, b.x), at(a.y, b.y))
}
