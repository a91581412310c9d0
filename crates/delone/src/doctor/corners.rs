//! Corners between segments that follow each other around a vertex: what is sharp stays sharp in any mesh.
//!
//! Sides are sorted around their vertex, and angles compared with the limits, exactly; the cosines of 1° and
//! 20° are rounded, that of 60° is not. Shown angles are rounded. *Cost*: O(n log n).

use super::graph::Graph;
use super::trouble::{Diagnosis, Kind, Trouble};
use crate::predicates::{Orientation, is_sharper, orient2d};
use crate::{Point, VertexId, Watch};
use std::cmp::Ordering;

/// The squares of the cosines of 60°, 20° and 1°.
const LIMITS: [f64; 3] = [0.25, 0.883_022_221_559_489, 0.999_695_413_509_547_9];

/// A corner: its angle in degrees, its apex, and its sides.
type Corner = (f64, u32, [u32; 2]);

/// Finds the sharp corners; `None` if the watch cancelled.
pub(super) fn examine(
    graph: &Graph,
    limit: usize,
    found: &mut Diagnosis,
    watch: &dyn Watch,
) -> Option<()> {
    let (mut needles, mut sharp) = (Vec::new(), Vec::new());
    let mut sharpest: Option<Corner> = None;
    let mut sides = Vec::new();
    for (i, v) in graph.vertices().enumerate() {
        if i.is_multiple_of(1 << 12) && watch.is_cancelled() {
            return None;
        }
        sort_sides(graph, v, &mut sides);
        for corner in corners_at(graph, v, &sides) {
            found.corners_below_60 += u64::from(is_below(graph, &corner, 0));
            if is_below(graph, &corner, 2) {
                needles.push(corner);
            } else if is_below(graph, &corner, 1) {
                sharp.push(corner);
            }
            if sharpest.is_none_or(|least| corner.0 < least.0) {
                sharpest = Some(corner);
            }
        }
    }
    found.sharpest = sharpest.map(|corner| describe(graph, &corner));
    for (kind, mut corners) in [(Kind::Needle, needles), (Kind::SharpCorner, sharp)] {
        corners.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let count = corners.len() as u64;
        let first = corners
            .iter()
            .take(limit)
            .map(|corner| describe(graph, corner));
        let first = first.collect();
        found.add(kind, crate::Listed { count, first });
    }
    Some(())
}

fn is_below(graph: &Graph, &(_, v, sides): &Corner, limit: usize) -> bool {
    let [a, b] = sides.map(|s| graph.at(graph.opposite(s, v)));
    is_sharper(graph.at(v), a, b, LIMITS[limit])
}

fn describe(graph: &Graph, &(degrees, v, sides): &Corner) -> Trouble {
    let mut segments = sides.map(|s| graph.names[s as usize] as usize);
    segments.sort_unstable();
    Trouble {
        points: vec![VertexId::from(v)],
        segments: segments.into(),
        at: Some(graph.at(v)),
        size: Some(degrees),
        ..Trouble::default()
    }
}

/// Sorts the segments that end in a vertex counter-clockwise, equal directions by number.
fn sort_sides(graph: &Graph, v: u32, sides: &mut Vec<u32>) {
    let apex = graph.at(v);
    sides.clear();
    sides.extend_from_slice(graph.around(v));
    if sides.len() < 3 {
        return;
    }
    let end = |s: &u32| graph.at(graph.opposite(*s, v));
    // To the right comes before to the left; within half a turn, the order is that of orientation.
    let is_left = |p: &Point| p.lex_cmp(&apex).is_lt();
    sides.sort_unstable_by(|s, t| {
        let [p, q] = [end(s), end(t)];
        let turn = || match orient2d(apex, p, q) {
            Orientation::Left => Ordering::Less,
            Orientation::Right => Ordering::Greater,
            Orientation::Collinear => s.cmp(t),
        };
        is_left(&p).cmp(&is_left(&q)).then_with(turn)
    });
}

/// Lists the corners at a vertex: between two segments the one below 180°, between more those that follow
/// each other. Sides of the same direction overlap, which is another trouble.
fn corners_at<'a>(graph: &'a Graph, v: u32, sides: &'a [u32]) -> impl Iterator<Item = Corner> + 'a {
    let n = sides.len();
    let pairs = if n == 2 { 1 } else { n };
    let apex = graph.at(v);
    let all = (0..pairs).filter(move |_| n >= 2);
    let all = all.map(move |i| [sides[i], sides[(i + 1) % n]]);
    all.filter_map(move |pair| {
        let [a, b] = pair.map(|s| graph.at(graph.opposite(s, v)));
        let side = orient2d(apex, a, b);
        // A reflex corner is no sharp one; its complement is not empty.
        let is_corner = side == Orientation::Left || (n == 2 && side == Orientation::Right);
        is_corner.then(|| (angle(apex, a, b), v, pair))
    })
}

/// The angle in degrees, as far as `f64` can tell.
fn angle(apex: Point, a: Point, b: Point) -> f64 {
    let side = |p: Point| {
        let [x, y] = [p.x / 4.0 - apex.x / 4.0, p.y / 4.0 - apex.y / 4.0];
        let size = x.abs().max(y.abs()).max(f64::MIN_POSITIVE);
        [x / size, y / size]
    };
    let ([x, y], [u, v]) = (side(a), side(b));
    (x * v - y * u).abs().atan2(x * u + y * v).to_degrees()
}
