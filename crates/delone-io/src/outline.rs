//! What bare lines mean as a domain, in formats that say nothing about it.
//!
//! Lines that end in the open bound nothing. If all others make rings (an even number of them at every place), those
//! are the border, by parity: rings in rings are holes, for such formats cannot name holes. If they share sides, as the
//! borders of areas side by side do, parity means nothing, and all that the outside cannot reach belongs to the domain.
//! If there are no rings at all, it is the convex hull.
//!
//! *Cost*: O(s log s) for s segments.

use crate::DomainData;
use delone::{DomainRule, VertexId};

/// Decides on the rule of a domain that has segments, and no polygons yet. Rings then come before lines that end in the
/// open; otherwise the order stays.
pub(crate) fn settle(domain: &mut DomainData) {
    let ends = places(domain);
    let (is_ring, are_even) = rings(&ends);
    let first_open = is_ring.iter().filter(|&&r| r).count();
    domain.polygons.clear();
    domain.usual_rule = match (first_open, are_even) {
        (0, _) => DomainRule::Hull,
        (_, false) => DomainRule::Carve,
        (_, true) => {
            domain.polygons.push(0..first_open);
            domain.segments = rings_first(&domain.segments, &is_ring);
            let markers = domain.segment_markers.take();
            domain.segment_markers = markers.map(|markers| rings_first(&markers, &is_ring));
            DomainRule::EvenOdd
        }
    };
}

/// Numbers the places at which segments end: equal points are one place.
fn places(domain: &DomainData) -> Vec<[usize; 2]> {
    let at = |v: VertexId| {
        let p = domain.vertices.points[v.index()];
        // Both zeros are one place.
        [p.x + 0.0, p.y + 0.0]
    };
    let mut order: Vec<VertexId> = domain.segments.as_flattened().to_vec();
    let compare = |v: &VertexId, w: &VertexId| {
        let (p, q) = (at(*v), at(*w));
        p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1]))
    };
    order.sort_unstable_by(compare);
    let mut place_of = vec![0; domain.vertices.points.len()];
    for (place, same) in order.chunk_by(|v, w| compare(v, w).is_eq()).enumerate() {
        same.iter().for_each(|v| place_of[v.index()] = place);
    }
    let ends = |segment: &[VertexId; 2]| segment.map(|v| place_of[v.index()]);
    domain.segments.iter().map(ends).collect()
}

/// Tells which segments are left when those with a loose end are taken off, again and again, and whether then an even
/// number of them meets at every place.
fn rings(ends: &[[usize; 2]]) -> (Vec<bool>, bool) {
    let num_places = ends.as_flattened().iter().max().map_or(0, |&p| p + 1);
    let mut degrees = vec![0u32; num_places];
    // The exclusive or of what meets at a place: where but one segment is left, that is its number.
    let mut numbers = vec![0; num_places];
    let mut is_ring: Vec<bool> = ends.iter().map(|[a, b]| a != b).collect();
    for (s, segment) in ends.iter().enumerate().filter(|&(s, _)| is_ring[s]) {
        for &p in segment {
            degrees[p] += 1;
            numbers[p] ^= s;
        }
    }
    let mut loose: Vec<usize> = (0..num_places).filter(|&p| degrees[p] == 1).collect();
    while let Some(p) = loose.pop() {
        if degrees[p] != 1 {
            continue;
        }
        let s = numbers[p];
        is_ring[s] = false;
        for q in ends[s] {
            degrees[q] -= 1;
            numbers[q] ^= s;
            if degrees[q] == 1 {
                loose.push(q);
            }
        }
    }
    (is_ring, degrees.iter().all(|d| d % 2 == 0))
}

fn rings_first<T: Copy>(items: &[T], is_ring: &[bool]) -> Vec<T> {
    let of = |wanted: bool| {
        let all = items.iter().zip(is_ring);
        all.filter(move |&(_, &r)| r == wanted)
            .map(|(&item, _)| item)
    };
    of(true).chain(of(false)).collect()
}

#[cfg(test)]
mod tests {
    use super::settle;
    use crate::DomainData;
    use delone::DomainRule;

    fn settled(points: &[[f64; 2]], segments: &[[u32; 2]]) -> DomainData {
        let domain = DomainData::from_rows(points.to_vec(), segments.to_vec(), Vec::new());
        let mut domain = domain.expect("segments join points");
        domain.segment_markers = Some((0..segments.len() as i32).collect());
        settle(&mut domain);
        domain
    }

    const SQUARE: [[f64; 2]; 5] = [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [2., 2.]];

    #[test]
    fn rings_are_borders_and_open_lines_are_not() {
        let with_tail = [[2, 4], [0, 1], [1, 2], [2, 3], [3, 0]];
        let domain = settled(&SQUARE, &with_tail);
        assert_eq!(domain.usual_rule, DomainRule::EvenOdd);
        assert_eq!(domain.polygons, vec![0..4; 1]);
        assert_eq!(domain.segment_markers, Some(vec![1, 2, 3, 4, 0]));
    }

    #[test]
    fn open_lines_alone_mean_the_hull() {
        let domain = settled(&SQUARE, &[[0, 1], [1, 2], [2, 4], [1, 3]]);
        assert_eq!(domain.usual_rule, DomainRule::Hull);
        assert!(domain.polygons.is_empty());
    }

    #[test]
    fn shared_sides_mean_what_the_outside_cannot_reach() {
        let halves = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]];
        let domain = settled(&SQUARE, &halves);
        assert_eq!(domain.usual_rule, DomainRule::Carve);
        assert_eq!(domain.segment_markers, Some(vec![0, 1, 2, 3, 4]));
    }

    #[test]
    fn equal_points_close_rings() {
        let points = [[0., 0.], [1., 0.], [1., 1.], [-0., 0.]];
        let domain = settled(&points, &[[0, 1], [1, 2], [2, 3], [0, 3]]);
        assert_eq!(domain.usual_rule, DomainRule::EvenOdd);
        assert_eq!(domain.polygons, vec![0..3; 1], "one joins equal points");
    }
}
