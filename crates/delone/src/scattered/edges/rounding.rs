//! Points for places on an edge of the outline: on its line, or outside, so that no datum is left out.

use super::rim::Rim;
use crate::predicates::{Orientation, compare_distances, cross_properly, is_between, orient2d};
use crate::{Point, VertexId};

/// Returns the point nearest to `t`, rounded from a place on `ab`, that is not to the left of ab: `t` itself, or one up
/// to two steps away in each coordinate. Of equally near ones the lexicographically smallest.
///
/// There is one unless coordinates end there: ab passes `t` at less than one step.
pub(super) fn outward([a, b]: [Point; 2], t: Point) -> Option<Point> {
    let is_good = |p: &Point| p.is_finite() && orient2d(a, b, *p) != Orientation::Left;
    if is_good(&t) {
        return Some(t);
    }
    let near = |c: f64| {
        let [up, down] = [c.next_up(), c.next_down()];
        [c, up, down, up.next_up(), down.next_down()]
    };
    let [xs, ys] = [near(t.x), near(t.y)];
    let points = xs.into_iter().flat_map(|x| ys.map(|y| [x, y]));
    let points = points.map(|[x, y]| Point::new(x + 0.0, y + 0.0));
    points.filter(is_good).min_by(|&p, &q| {
        let by_position = || p.lex_cmp(&q);
        compare_distances(t, p, q).then_with(by_position)
    })
}

/// Tells whether the outer edge `ab`, which starts at vertex `start`, may go by way of `t`, on its line or outside,
/// without meeting the outline elsewhere, as it might where that is not convex.
///
/// *Cost*: that of a question to the [rim](Rim), unless `t` lies on the edge.
pub(in super::super) fn is_free(rim: &Rim, start: VertexId, [a, b]: [Point; 2], t: Point) -> bool {
    orient2d(a, b, t) == Orientation::Collinear
        || !rim.has_near([a, t, b], start, |other| meets([a, t, b], other))
}

/// Tells whether an edge `pq` of the outline meets the way a–t–b, or p lies between that and the edge ab.
fn meets([a, t, b]: [Point; 3], [p, q]: [Point; 2]) -> bool {
    let sides = [[a, t], [t, b], [b, a]];
    let is_left = |&[from, to]: &[Point; 2]| orient2d(from, to, p) != Orientation::Right;
    let is_enclosed = p != a && p != b && sides.iter().all(is_left);
    let is_crossed = sides[..2].iter().any(|&side| cross_properly(side, [p, q]));
    is_enclosed || is_crossed || is_between(p, q, t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::predicates::point_between;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn points_are_near_and_not_inside(
            [x, y, z, w] in prop::array::uniform4(-1.0..1.0), b in 0.0..1.0, offset in 0..3,
        ) {
            let offset = [0.0, 1e6, -1e12][offset as usize];
            let ab = [Point::new(x + offset, y), Point::new(z, w + offset)];
            let t = point_between(ab, b);
            let p = outward(ab, t).unwrap();
            prop_assert!(orient2d(ab[0], ab[1], p) != Orientation::Left);
            let steps = |c: f64, d: f64| c.to_bits().abs_diff(d.to_bits());
            prop_assert!((t.x == 0.0 || steps(t.x, p.x) <= 2) && (t.y == 0.0 || steps(t.y, p.y) <= 2));
        }
    }

    #[test]
    fn places_on_edges_along_the_axes_stay() {
        let ab = [Point::new(0.1, 0.3), Point::new(0.7, 0.3)];
        let t = point_between(ab, 0.375);
        assert_eq!(outward(ab, t), Some(t));
        assert_eq!(outward([ab[1], ab[0]], t), Some(t));
    }

    #[test]
    fn nothing_of_the_outline_is_met() {
        let [a, t, b] = [(0.0, 0.0), (4.0, -1.0), (8.0, 0.0)].map(Point::from);
        let far = [(8.0, 0.0), (9.0, 9.0)].map(Point::from);
        assert!(!meets([a, t, b], far));
        let across = [(3.0, -0.5), (3.0, -5.0)].map(Point::from);
        assert!(meets([a, t, b], across));
        let from_end = [(0.0, 0.0), (8.0, -1.0)].map(Point::from);
        assert!(meets([a, t, b], from_end));
        let through = [(0.0, -1.0), (8.0, -1.0)].map(Point::from);
        assert!(meets([a, t, b], through));
    }
}
