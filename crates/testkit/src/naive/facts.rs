//! How segments meet: every pair against each other, every vertex against every segment.

use super::pairs::{cross, is_inside, overlap};
use crate::corpus::Facts;
use delone::{Point, Pslg};
use std::collections::BTreeMap;

/// Counts crossings, overlaps and vertices on segments, after merging equal points and segments.
///
/// *Cost*: O(m² + n m).
pub fn naive_facts(pslg: &Pslg) -> Facts {
    let segments = merged_segments(pslg);
    let places: BTreeMap<_, _> = pslg.points.iter().map(|&p| (bits(p), p)).collect();
    let mut facts = Facts::default();
    for (i, &s) in segments.iter().enumerate() {
        facts.on_segments += places.values().filter(|&&p| is_inside(s, p)).count();
        for &t in &segments[i + 1..] {
            facts.crossings += usize::from(cross(s, t));
            facts.overlaps += usize::from(overlap(s, t));
        }
    }
    facts
}

/// Lists the segments that have a length, each once.
fn merged_segments(pslg: &Pslg) -> Vec<[Point; 2]> {
    let ends = pslg
        .segments
        .iter()
        .map(|s| s.map(|v| pslg.points[v.index()]));
    let ends = ends.filter(|[a, b]| a != b);
    let keyed = ends.map(|[a, b]| {
        let (p, q) = if a.lex_cmp(&b).is_lt() {
            (a, b)
        } else {
            (b, a)
        };
        ([bits(p), bits(q)], [p, q])
    });
    keyed.collect::<BTreeMap<_, _>>().into_values().collect()
}

/// Makes a key of a place: equal for equal points.
pub(super) fn bits(p: Point) -> [u64; 2] {
    [p.x, p.y].map(|c| (c + 0.0).to_bits())
}
