//! A drawing with equal points and equal segments merged, as all looks at it need it.

use crate::{Point, Pslg};

/// Distinct vertices, and distinct segments that have a length.
pub(super) struct Graph<'a> {
    pub points: &'a [Point],
    /// For each point the first one equal to it.
    pub kept: Vec<u32>,
    /// The ends of each segment, the lexicographically smaller first.
    pub ends: Vec<[u32; 2]>,
    /// The index of each in the input, ascending.
    pub names: Vec<u32>,
    /// Where the segments of each vertex begin in `around`; one more at the end.
    starts: Vec<u32>,
    around: Vec<u32>,
}

impl<'a> Graph<'a> {
    /// Merges; indices must be right.
    pub fn new(pslg: &'a Pslg) -> Self {
        let points = &pslg.points[..];
        let kept = merged(points);
        let ends_of = |s: usize| sorted(points, pslg.segments[s].map(|v| kept[v.index()]));
        let all = (0..pslg.segments.len()).map(|s| (ends_of(s), s as u32));
        let mut segments: Vec<_> = all.filter(|([a, b], _)| a != b).collect();
        segments.sort_unstable();
        segments.dedup_by_key(|(ends, _)| *ends);
        segments.sort_unstable_by_key(|&(_, s)| s);
        let (ends, names): (Vec<[u32; 2]>, Vec<u32>) = segments.into_iter().unzip();
        let (starts, around) = incidences(&ends, points.len());
        Self {
            points,
            kept,
            ends,
            names,
            starts,
            around,
        }
    }

    pub fn at(&self, v: u32) -> Point {
        self.points[v as usize]
    }

    /// Lists the vertices: of equal points the first.
    pub fn vertices(&self) -> impl Iterator<Item = u32> + '_ {
        let all = (0..).zip(&self.kept);
        all.filter(|&(v, &kept)| v == kept).map(|(v, _)| v)
    }

    /// Lists the segments that end in a vertex.
    pub fn around(&self, v: u32) -> &[u32] {
        let [from, to] = [v, v + 1].map(|i| self.starts[i as usize] as usize);
        &self.around[from..to]
    }

    /// Returns the other end of a segment.
    pub fn opposite(&self, s: u32, v: u32) -> u32 {
        let [a, b] = self.ends[s as usize];
        if v == a { b } else { a }
    }

    /// Returns the ends of a segment as places.
    pub fn places(&self, s: u32) -> [Point; 2] {
        self.ends[s as usize].map(|v| self.at(v))
    }
}

/// Finds for each point the first equal one.
pub(super) fn merged(points: &[Point]) -> Vec<u32> {
    let at = |v: u32| points[v as usize];
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_unstable_by(|&u, &v| at(u).lex_cmp(&at(v)).then(u.cmp(&v)));
    let mut kept = vec![0; points.len()];
    for group in order.chunk_by(|&u, &v| at(u) == at(v)) {
        for &v in group {
            kept[v as usize] = group[0];
        }
    }
    kept
}

/// Returns two vertices, the lexicographically smaller first.
pub(super) fn sorted(points: &[Point], [a, b]: [u32; 2]) -> [u32; 2] {
    match points[b as usize].lex_cmp(&points[a as usize]) {
        std::cmp::Ordering::Less => [b, a],
        _ => [a, b],
    }
}

/// Lists the segments at each vertex.
fn incidences(ends: &[[u32; 2]], vertices: usize) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; vertices + 2];
    for &v in ends.as_flattened() {
        starts[v as usize + 2] += 1;
    }
    for i in 1..starts.len() {
        starts[i] += starts[i - 1];
    }
    let mut around = vec![0; 2 * ends.len()];
    for (s, ends) in (0..).zip(ends) {
        for &v in ends {
            let place = &mut starts[v as usize + 1];
            around[*place as usize] = s;
            *place += 1;
        }
    }
    starts.pop();
    (starts, around)
}
