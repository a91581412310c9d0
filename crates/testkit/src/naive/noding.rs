//! Canonical noding: segments are cut where they meet, in rounds, in rational arithmetic.
//!
//! In each round every pair of pieces is tried, O(m²), and every vertex against every piece. All
//! cuts of a round are found before any is made; a crossing is an exact rational point, rounded to
//! the nearest `f64` in each coordinate. In a cascade of crossings, pieces are first cut at
//! the places of earlier ones that they pass up to rounding.

use super::facts::bits;
use super::pairs::{Ends, cross, is_inside};
use dashu_ratio::RBig;
use delone::{Point, VertexId};
use std::collections::BTreeMap;

/// Into what segments have been cut.
#[derive(Clone, Debug, PartialEq)]
pub struct NaiveNoding {
    /// The input points, then those added where segments cross, sorted by x, then y.
    pub points: Vec<Point>,
    /// For each segment the vertices along it, from its first end to its second; of equal points the
    /// first. A segment of no length has one vertex.
    pub chains: Vec<Vec<VertexId>>,
}

impl NaiveNoding {
    /// Lists the edges of all chains, repeated as often as segments run there.
    pub fn edges(&self) -> Vec<[VertexId; 2]> {
        let edges_of = |chain: &Vec<VertexId>| chain.windows(2).map(|e| [e[0], e[1]]).collect();
        self.chains.iter().flat_map::<Vec<_>, _>(edges_of).collect()
    }
}

/// Tells whether a round, counted from 0, that finds crossings in so many places is part of a cascade,
/// when the first round found them in `first`.
fn is_cascade(number: usize, places: usize, first: usize) -> bool {
    number >= 4 || (number > 0 && places > first / 8 + 8)
}

/// Tells whether no piece is cut.
fn is_done(cuts: &Cuts) -> bool {
    cuts.values().all(|line| line.len() == 2)
}

/// Cuts segments until they meet only at shared ends. Coordinates must be finite.
pub fn naive_noding(points: &[Point], segments: &[[VertexId; 2]]) -> NaiveNoding {
    let places: Places = points.iter().map(|&p| (bits(p), p)).collect();
    let ends = segments.iter().map(|s| s.map(|v| points[v.index()]));
    let mut lines: Vec<Vec<Point>> = ends.map(|[a, b]| [a, b].to_vec()).collect();
    lines.iter_mut().for_each(|line| line.dedup());
    let mut rounds = Rounds {
        places,
        struck: Places::new(),
        lines,
        first_places: 0,
        number: 0,
    };
    while rounds.step() {}
    numbered(points, rounds.places, &rounds.lines)
}

/// The state between two rounds.
struct Rounds {
    places: Places,
    /// The places of crossings.
    struck: Places,
    lines: Vec<Vec<Point>>,
    first_places: usize,
    number: usize,
}

impl Rounds {
    /// Cuts all pieces that must be; false if there are none.
    fn step(&mut self) -> bool {
        let pieces = pieces(&self.lines);
        let crossings = crossings(&pieces);
        let stops = |(&key, &piece): (&Key, &Ends)| {
            let on_it = self.places.values().filter(|&&p| is_inside(piece, p));
            (key, through(piece, on_it))
        };
        let mut cuts: Cuts = pieces.iter().map(stops).collect();
        let struck: Places = crossings
            .values()
            .flatten()
            .map(|&p| (bits(p), p))
            .collect();
        if self.number == 0 {
            self.first_places = struck.len();
        }
        let is_cascade = is_cascade(self.number, struck.len(), self.first_places);
        if is_cascade {
            self.snap(&pieces, &mut cuts);
        }
        if !is_cascade || is_done(&cuts) {
            for (key, crossings) in &crossings {
                let line = through(pieces[key], crossings.iter().chain(&cuts[key]));
                cuts.insert(*key, line);
            }
            self.places.extend(&struck);
            self.struck.extend(struck);
        }
        let lines = self.lines.iter().map(|line| replaced(line, &cuts));
        self.lines = lines.collect();
        self.number += 1;
        !is_done(&cuts)
    }

    /// Cuts at the places of crossings that are passed up to rounding too.
    fn snap(&self, pieces: &BTreeMap<Key, Ends>, cuts: &mut Cuts) {
        for (key, &piece) in pieces {
            let passed = self.struck.values().filter(|&&p| passes(piece, p));
            let line = through(piece, passed.chain(&cuts[key]));
            cuts.insert(*key, line);
        }
    }
}

/// Finds the lexicographically first pair of segments that cross in a point that is no vertex, and
/// that point, rounded.
pub fn naive_first_crossing(
    points: &[Point],
    segments: &[[VertexId; 2]],
) -> Option<([usize; 2], Point)> {
    let ends = |i: usize| segments[i].map(|v| points[v.index()]);
    let mut pairs = (0..segments.len()).flat_map(|i| (i + 1..segments.len()).map(move |j| [i, j]));
    let meet_at_vertex = |s, t| points.iter().any(|&p| is_inside(s, p) && is_inside(t, p));
    let [i, j] = pairs.find(|pair| {
        let [s, t] = pair.map(ends);
        cross(s, t) && !meet_at_vertex(s, t)
    })?;
    let [s, t] = [ends(i), ends(j)];
    Some(([i, j], rounded(&crossing(s, t))))
}

type Key = [[u64; 2]; 2];
type Places = BTreeMap<[u64; 2], Point>;
/// The points along each piece.
type Cuts = BTreeMap<Key, Vec<Point>>;

/// The pieces that lines consist of, each once and in one direction.
fn pieces(lines: &[Vec<Point>]) -> BTreeMap<Key, Ends> {
    let steps = lines.iter().flat_map(|line| line.windows(2));
    let pieces = steps.map(|step| forward([step[0], step[1]]));
    pieces.map(|piece| (piece.map(bits), piece)).collect()
}

fn forward([a, b]: Ends) -> Ends {
    if a.lex_cmp(&b).is_lt() {
        [a, b]
    } else {
        [b, a]
    }
}

/// Lists for each piece where others cross it, rounded.
fn crossings(pieces: &BTreeMap<Key, Ends>) -> BTreeMap<Key, Vec<Point>> {
    let mut crossings: BTreeMap<Key, Vec<Point>> = BTreeMap::new();
    let all: Vec<_> = pieces.iter().collect();
    for (i, &(key, &piece)) in all.iter().enumerate() {
        for &(other_key, &other) in all[i + 1..]
            .iter()
            .filter(|(_, other)| cross(piece, **other))
        {
            let at = rounded(&crossing(piece, other));
            crossings.entry(*key).or_default().push(at);
            crossings.entry(*other_key).or_default().push(at);
        }
    }
    crossings
}

/// Tells whether the point of a segment with the abscissa of `p`, or that with its ordinate, rounds
/// to `p`; ends do not count.
fn passes([a, b]: Ends, p: Point) -> bool {
    let is_between = |c: f64, a: f64, b: f64| a.min(b) <= c && c <= a.max(b);
    if p == a || p == b || !is_between(p.x, a.x, b.x) || !is_between(p.y, a.y, b.y) {
        return false;
    }
    let [from, to, at] = [a, b, p].map(exact);
    let along = minus(&to, &from);
    let on_line = |axis: usize| {
        let share = (&at[axis] - &from[axis]) / &along[axis];
        let [x, y] = [0, 1].map(|k| &from[k] + &along[k] * &share);
        rounded(&[x, y]) == p
    };
    (0..2).any(|axis| along[axis] == RBig::ZERO || on_line(axis))
}

/// Orders points along a piece, ends included. As rounding is monotone, they follow each other in x,
/// and then in y, as they do on the piece.
fn through<'a>([a, b]: Ends, stops: impl Iterator<Item = &'a Point>) -> Vec<Point> {
    let mut line: Vec<_> = stops.copied().collect();
    let upright = |p: Point| Point::new(p.x, if b.y < a.y { -p.y } else { p.y });
    line.extend([a, b]);
    line.sort_by(|&p, &q| upright(p).lex_cmp(&upright(q)));
    line.dedup();
    line
}

/// The exact point where two segments cross properly.
fn crossing(s: Ends, t: Ends) -> [RBig; 2] {
    let [[a, b], [c, d]] = [s, t].map(|ends| ends.map(exact));
    let along = minus(&b, &a);
    let other = minus(&d, &c);
    let share = det(&minus(&c, &a), &other) / det(&along, &other);
    let [x, y] = along.map(|step| step * &share);
    let [ax, ay] = a;
    [ax + x, ay + y]
}

fn minus([ax, ay]: &[RBig; 2], [bx, by]: &[RBig; 2]) -> [RBig; 2] {
    [ax - bx, ay - by]
}

fn det([ax, ay]: &[RBig; 2], [bx, by]: &[RBig; 2]) -> RBig {
    ax * by - ay * bx
}

/// A point's exact coordinates.
pub(super) fn exact(p: Point) -> [RBig; 2] {
    [p.x, p.y].map(|c| RBig::try_from(c).expect("finite"))
}

fn rounded([x, y]: &[RBig; 2]) -> Point {
    // Adding zero turns −0.0, which very small negative numbers round to, into 0.0.
    let [x, y] = [x, y].map(|c| c.to_f64().value() + 0.0);
    Point::new(x, y)
}

/// Replaces each piece of a line by what it was cut into.
fn replaced(line: &[Point], cuts: &Cuts) -> Vec<Point> {
    let mut result = line[..1].to_vec();
    for step in line.windows(2) {
        let piece = forward([step[0], step[1]]);
        let mut points = cuts[&piece.map(bits)].clone();
        if piece[0] != step[0] {
            points.reverse();
        }
        result.extend(&points[1..]);
    }
    result
}

/// Numbers the added points, and turns lines into chains.
fn numbered(points: &[Point], mut places: Places, lines: &[Vec<Point>]) -> NaiveNoding {
    let mut ids = BTreeMap::new();
    for (i, &p) in points.iter().enumerate() {
        places.remove(&bits(p));
        ids.entry(bits(p)).or_insert(VertexId::new(i));
    }
    let mut added: Vec<_> = places.into_values().collect();
    added.sort_by(Point::lex_cmp);
    let all = [points, &added].concat();
    ids.extend((points.len()..all.len()).map(|i| (bits(all[i]), VertexId::new(i))));
    let chain = |line: &Vec<Point>| line.iter().map(|&p| ids[&bits(p)]).collect();
    NaiveNoding {
        points: all,
        chains: lines.iter().map(chain).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noded(points: &[(f64, f64)], segments: &[[u32; 2]]) -> (usize, Vec<Vec<u32>>) {
        let points: Vec<_> = points.iter().map(|&p| Point::from(p)).collect();
        let segments: Vec<_> = segments.iter().map(|s| s.map(VertexId::from)).collect();
        let noding = naive_noding(&points, &segments);
        let raw = |chain: &Vec<VertexId>| chain.iter().map(|v| v.raw()).collect();
        let added = noding.points.len() - points.len();
        (added, noding.chains.iter().map(raw).collect())
    }

    #[test]
    fn a_cross_gets_a_vertex_and_touching_segments_none() {
        let square = [(0.0, 0.0), (2.0, 2.0), (0.0, 2.0), (2.0, 0.0)];
        let cross = [vec![0, 4, 1], vec![3, 4, 2]].to_vec();
        assert_eq!(noded(&square, &[[0, 1], [3, 2]]), (1, cross));
        let line = [(0.0, 0.0), (1.0, 0.0), (3.0, 0.0), (1.0, 0.0), (1.0, 4.0)];
        let chains = [vec![2, 1, 0], vec![1, 4], vec![1], vec![1, 2]].to_vec();
        let segments = [[2, 0], [3, 4], [1, 3], [3, 2]];
        assert_eq!(noded(&line, &segments), (0, chains));
    }

    #[test]
    fn rounding_is_to_nearest() {
        let mut state = crate::generate::Random::new(5);
        for _ in 0..500 {
            let [a, b, c] = [0; 3].map(|_| RBig::try_from(state.unit()).unwrap());
            let value = a - b * c;
            let found = value.to_f64().value();
            let off = |f: f64| {
                let off = RBig::try_from(f).unwrap() - &value;
                if off < RBig::ZERO { -off } else { off }
            };
            assert!(off(found) <= off(found.next_up()));
            assert!(off(found) <= off(found.next_down()));
        }
    }

    #[test]
    fn the_first_crossing_is_the_lexicographically_first() {
        let points = [(0.0, 0.0), (4.0, 4.0), (0.0, 4.0), (4.0, 0.0), (2.0, 2.0)].map(Point::from);
        let segments = [[0, 4], [2, 3], [0, 1], [1, 2]].map(|s| s.map(VertexId::from));
        assert_eq!(naive_first_crossing(&points, &segments), None);
        let found = naive_first_crossing(&points[..4], &segments[1..]);
        assert_eq!(found, Some(([0, 1], points[4])));
    }
}
