//! Near misses: vertices within the tolerance of each other, or of segments.

use super::graph::Graph;
use super::trouble::Trouble;
use crate::parallel::Workers;
use crate::predicates::{Orientation, length_up, orient2d};
use crate::pslg::{First, Nearby, Scratch};
use crate::{Listed, Point, VertexId, Watch};

/// Vertices between two looks at the watch.
const STRIDE: usize = 1 << 8;

/// Finds pairs of vertices within the tolerance, and vertices within that of segments; `None` if the watch
/// cancelled.
pub(super) fn misses(
    graph: &Graph,
    tolerance: f64,
    limit: usize,
    workers: Workers,
    watch: &dyn Watch,
) -> Option<[Listed<Trouble>; 2]> {
    if tolerance == 0.0 {
        return Some([Listed::default(), Listed::default()]);
    }
    let vertices: Vec<u32> = graph.vertices().collect();
    let others = Nearby::of_points(graph.points, &vertices, workers);
    let segments = Nearby::of_segments(graph.points, &graph.ends, workers);
    let (mut pairs, mut beside) = (First::new(limit), First::new(limit));
    let mut scratch = Scratch::default();
    for (i, &v) in vertices.iter().enumerate() {
        if i.is_multiple_of(STRIDE) && watch.is_cancelled() {
            return None;
        }
        let p = graph.at(v);
        others.points_within(p, tolerance, &mut scratch, |u| {
            if v < u {
                pairs.add([v, u]);
            }
        });
        segments.segments_beside(v, tolerance, &mut scratch, |s| {
            let [a, b] = graph.places(s);
            // What lies on it exactly is another trouble.
            if orient2d(a, b, p) != Orientation::Collinear {
                beside.add([graph.names[s as usize], v]);
            }
        });
    }
    let pairs = pairs.listed(|[v, u]| {
        let [p, q] = [v, u].map(|v| graph.at(v));
        Trouble {
            points: [v, u].map(VertexId::from).into(),
            at: Some(p),
            to: Some(q),
            size: Some(length_up([p, q])),
            ..Trouble::default()
        }
    });
    let beside = beside.listed(|[segment, v]| {
        let s = graph.names.binary_search(&segment);
        let ends = graph.places(s.expect("bug: a merged segment") as u32);
        Trouble {
            points: vec![v.into()],
            segments: vec![segment as usize],
            at: Some(graph.at(v)),
            size: Some(distance(ends, graph.at(v))),
            ..Trouble::default()
        }
    });
    Some([pairs, beside])
}

/// The distance of a point from a segment, as far as `f64` can tell.
pub(super) fn distance([a, b]: [Point; 2], p: Point) -> f64 {
    // Scaled so that no product overflows or vanishes.
    let [u, v] = [b, p].map(|q| [q.x - a.x, q.y - a.y]);
    let largest = [u, v]
        .as_flattened()
        .iter()
        .fold(0.0, |m: f64, c| m.max(c.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    let [u, v] = [u, v].map(|w| w.map(|c| c / largest));
    let square = u[0] * u[0] + u[1] * u[1];
    let share = match square > 0.0 {
        true => ((u[0] * v[0] + u[1] * v[1]) / square).clamp(0.0, 1.0),
        false => 0.0,
    };
    largest * (v[0] - share * u[0]).hypot(v[1] - share * u[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_the_nearest_place() {
        let d =
            |a: (f64, f64), b: (f64, f64), p: (f64, f64)| distance([a.into(), b.into()], p.into());
        assert_eq!(d((0.0, 0.0), (4.0, 0.0), (2.0, 3.0)), 3.0);
        assert_eq!(d((0.0, 0.0), (4.0, 0.0), (7.0, 4.0)), 5.0);
        assert_eq!(d((0.0, 0.0), (4e300, 0.0), (2e300, 3e300)), 3e300);
        assert_eq!(d((1.0, 1.0), (1.0, 1.0), (1.0, 1.0)), 0.0);
    }
}
