//! The noding against its definition, done naively, and against what it promises.

use super::*;
use crate::predicates::{cross_properly, crossing_point, passes};
use crate::pslg::rounds::is_cascade;
use std::collections::BTreeSet;

/// A small generator (splitmix64), so that failures repeat.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn jitter(&mut self, x: f64) -> f64 {
        match self.below(3) {
            0 => x.next_down(),
            1 => x,
            _ => x.next_up(),
        }
    }
}

/// Points and segments as a user draws them, with equal points.
#[derive(Clone, Debug)]
struct Drawing {
    points: Vec<Point>,
    segments: Vec<[usize; 2]>,
}

impl Drawing {
    /// Joins points at random.
    fn joined(points: Vec<Point>, segments: usize, random: &mut Random) -> Self {
        let n = points.len();
        let segments = (0..segments).map(|_| [random.below(n), random.below(n)]);
        Self {
            segments: segments.collect(),
            points,
        }
    }

    fn of_segments(segments: impl IntoIterator<Item = [Point; 2]>) -> Self {
        let points: Vec<Point> = segments.into_iter().flatten().collect();
        let segments = (0..points.len() / 2).map(|i| [2 * i, 2 * i + 1]).collect();
        Self { points, segments }
    }

    /// Lists the distinct points, and the segments between them.
    fn merged(&self) -> (Vec<VertexId>, Vec<[VertexId; 2]>) {
        let first = |i: usize| self.points.iter().position(|p| *p == self.points[i]);
        let first = |i: usize| VertexId::new(first(i).expect("itself"));
        let all = 0..self.points.len();
        let vertices = all.filter(|&i| first(i).index() == i).map(VertexId::new);
        let segments = self.segments.iter().map(|ends| ends.map(first));
        (
            vertices.collect(),
            segments.filter(|[a, b]| a != b).collect(),
        )
    }

    fn node(&self) -> Noded {
        let (vertices, segments) = self.merged();
        let noding = node(&self.points, &vertices, &segments, Workers::ONE, &()).expect("no watch");
        let mut points = self.points.clone();
        points.extend(&noding.points);
        Noded {
            noding,
            points,
            vertices,
            segments,
        }
    }

    fn shuffled(&self, random: &mut Random) -> Self {
        let mut drawing = self.clone();
        let n = self.points.len();
        let mut order: Vec<usize> = (0..n).collect();
        for i in (1..n).rev() {
            order.swap(i, random.below(i + 1));
        }
        for (i, &place) in order.iter().enumerate() {
            drawing.points[place] = self.points[i];
        }
        for i in (1..self.segments.len()).rev() {
            drawing.segments.swap(i, random.below(i + 1));
        }
        for ends in &mut drawing.segments {
            *ends = ends.map(|v| order[v]);
            if random.below(2) == 0 {
                ends.reverse();
            }
        }
        drawing
    }
}

struct Noded {
    noding: Noding,
    points: Vec<Point>,
    vertices: Vec<VertexId>,
    segments: Vec<[VertexId; 2]>,
}

/// Coordinates that can be ordered.
type Key = [i64; 2];

fn key(p: Point) -> Key {
    [p.x, p.y].map(|c| {
        let bits = (c + 0.0).to_bits().cast_signed();
        if bits < 0 { i64::MIN - bits } else { bits }
    })
}

impl Noded {
    fn chain(&self, segment: usize) -> Vec<Point> {
        let chain = self
            .noding
            .chains
            .get(segment)
            .unwrap_or(&self.segments[segment]);
        chain.iter().map(|v| self.points[v.index()]).collect()
    }

    fn subsegments(&self) -> BTreeSet<[Key; 2]> {
        let mut all = BTreeSet::new();
        for i in 0..self.segments.len() {
            for pair in self.chain(i).windows(2) {
                let mut ends = [key(pair[0]), key(pair[1])];
                ends.sort_unstable();
                all.insert(ends);
            }
        }
        all
    }

    fn added(&self) -> Vec<Key> {
        self.noding.points.iter().map(|&p| key(p)).collect()
    }

    /// Checks everything that a noding promises, by brute force.
    fn validate(&self) {
        self.validate_chains();
        self.validate_lineage();
        let mut edges: Vec<[Point; 2]> = Vec::new();
        let mut seen = BTreeSet::new();
        for i in 0..self.segments.len() {
            for pair in self.chain(i).windows(2) {
                let mut ends = [key(pair[0]), key(pair[1])];
                ends.sort_unstable();
                if seen.insert(ends) {
                    edges.push([pair[0], pair[1]]);
                }
            }
        }
        let added = &self.points[self.points.len() - self.noding.points.len()..];
        let vertices = self.vertices.iter().map(|v| self.points[v.index()]);
        let vertices: Vec<Point> = vertices.chain(added.iter().copied()).collect();
        for (i, &s) in edges.iter().enumerate() {
            assert!(s[0] != s[1]);
            for &t in &edges[..i] {
                assert!(!cross_properly(s, t), "{s:?} and {t:?} cross");
            }
            for &p in &vertices {
                assert!(!is_between(s[0], s[1], p), "{p:?} lies on {s:?}");
            }
        }
    }

    fn validate_chains(&self) {
        for (i, &[a, b]) in self.segments.iter().enumerate() {
            let chain = self.chain(i);
            let ends = [a, b].map(|v| self.points[v.index()]);
            assert_eq!([chain[0], chain[chain.len() - 1]], ends);
            let directions = |p: [Point; 2]| [p[0].x.total_cmp(&p[1].x), p[0].y.total_cmp(&p[1].y)];
            let way = directions(ends);
            for pair in chain.windows(2) {
                let step = directions([pair[0], pair[1]]);
                let is_on = |k: usize| step[k].is_eq() || step[k] == way[k];
                assert!(is_on(0) && is_on(1), "{chain:?} turns back");
                assert!(pair[0] != pair[1]);
            }
            assert!(
                self.noding
                    .chains
                    .get(i)
                    .is_none_or(|chain| chain.len() > 2)
            );
        }
    }

    fn validate_lineage(&self) {
        let Noding {
            points, crossings, ..
        } = &self.noding;
        assert!(points.windows(2).all(|p| p[0].lex_cmp(&p[1]).is_lt()));
        assert_eq!(points.len(), crossings.len());
        let n = self.points.len() - points.len();
        for (i, p) in points.iter().enumerate() {
            assert!(!self.points[..n].contains(p));
            let [s, t] = crossings[i];
            assert!(s < t);
            for s in [s, t] {
                let chain = self.noding.chains.get(s as usize).expect("a cut segment");
                assert!(chain.contains(&VertexId::new(n + i)));
            }
        }
    }
}

/// The rounds as they are defined, on sets of coordinates.
struct Naive {
    vertices: BTreeSet<Key>,
    set: BTreeSet<[Key; 2]>,
    /// The places of crossings.
    struck: BTreeSet<Key>,
    rounds: usize,
    first_places: usize,
}

fn position(key: Key) -> Point {
    let [x, y] = key
        .map(|bits| if bits < 0 { i64::MIN - bits } else { bits })
        .map(|bits| f64::from_bits(bits.cast_unsigned()));
    Point::new(x, y)
}

fn sorted(mut ends: [Key; 2]) -> [Key; 2] {
    ends.sort_unstable();
    ends
}

impl Naive {
    fn new(drawing: &Drawing) -> Self {
        let vertices: BTreeSet<Key> = drawing.points.iter().map(|&p| key(p)).collect();
        let ends = drawing.segments.iter();
        let ends = ends.map(|ends| sorted(ends.map(|v| key(drawing.points[v]))));
        let set: BTreeSet<_> = ends.filter(|[a, b]| a != b).collect();
        Self {
            vertices,
            set,
            struck: BTreeSet::new(),
            rounds: 0,
            first_places: 0,
        }
    }

    /// Makes one round; false if there is nothing to cut.
    fn step(&mut self) -> bool {
        let mut cuts: BTreeSet<([Key; 2], Key)> = BTreeSet::new();
        let mut crossings: BTreeSet<([Key; 2], Key)> = BTreeSet::new();
        for &s in &self.set {
            let ends = s.map(position);
            let on = |v: &Key| is_between(ends[0], ends[1], position(*v));
            cuts.extend(self.vertices.iter().copied().filter(on).map(|v| (s, v)));
            let crossing = |t: &[Key; 2]| crossing_point(ends, t.map(position)).map(key);
            crossings.extend(self.set.iter().filter_map(crossing).map(|v| (s, v)));
        }
        let places: BTreeSet<Key> = crossings.iter().map(|&(_, v)| v).collect();
        if self.rounds == 0 {
            self.first_places = places.len();
        }
        let is_cascade = is_cascade(self.rounds, places.len(), self.first_places);
        if is_cascade {
            for &s in &self.set {
                let ends = s.map(position);
                let passed = self.struck.iter().filter(|v| passes(ends, position(**v)));
                cuts.extend(passed.map(|&v| (s, v)));
            }
        }
        if !is_cascade || cuts.is_empty() {
            self.vertices.extend(&places);
            self.struck.extend(places);
            cuts.extend(crossings);
            cuts.retain(|(s, v)| !s.contains(v));
        }
        self.cut(&cuts);
        self.rounds += usize::from(!cuts.is_empty());
        !cuts.is_empty()
    }

    fn cut(&mut self, cuts: &BTreeSet<([Key; 2], Key)>) {
        let mut pieces = BTreeSet::new();
        for s in cuts.iter().map(|(s, _)| *s).collect::<BTreeSet<_>>() {
            let inner = cuts.range((s, [i64::MIN; 2])..=(s, [i64::MAX; 2]));
            let mut chain: Vec<Key> = inner.map(|&(_, v)| v).chain(s).collect();
            chain.sort_by_key(|&[x, y]| [x, if s[1][1] < s[0][1] { -y } else { y }]);
            assert_eq!([chain[0], chain[chain.len() - 1]], s);
            pieces.extend(chain.windows(2).map(|pair| sorted([pair[0], pair[1]])));
            self.set.remove(&s);
        }
        self.set.extend(pieces);
    }
}

fn small_lattice(random: &mut Random) -> Drawing {
    let (size, segments) = (2 + random.below(5), 1 + random.below(9));
    let points = 3 + random.below(8);
    let mut c = || random.below(size) as f64;
    let points = (0..points).map(|_| Point::new(c(), c())).collect();
    Drawing::joined(points, segments, random)
}

/// A small lattice, turned, at an offset, or squeezed: what lay on a line nearly does.
fn tilted_lattice(random: &mut Random) -> Drawing {
    let mut drawing = small_lattice(random);
    let (sin, cos) = (random.unit() * 6.0).sin_cos();
    let [scale, x, y] = [
        (1.0, 0.0, 0.0),
        (1.0, 5e5, 5e6),
        (1e-9, 5e5, 5e6),
        (1e150, 0.0, 0.0),
        (1e-310, 0.0, 0.0),
    ]
    .map(|(s, x, y)| [s, x, y])[random.below(5)];
    for p in &mut drawing.points {
        *p = Point::new(
            x + scale * (cos * p.x - sin * p.y),
            y + scale * (sin * p.x + cos * p.y),
        );
    }
    drawing
}

fn within_one_ulp(random: &mut Random) -> Drawing {
    let [x, y] = [[0.0, 0.0], [5e5, 5e6], [1.0, 1.0]][random.below(3)];
    let lines = 2 + random.below(5);
    let base = [0; 4].map(|_| random.unit());
    let segments: Vec<[Point; 2]> = (0..lines)
        .map(|_| {
            let end = |u: f64, v: f64, random: &mut Random| {
                Point::new(random.jitter(x + u), random.jitter(y + v))
            };
            [end(base[0], base[1], random), end(base[2], base[3], random)]
        })
        .collect();
    Drawing::of_segments(segments)
}

fn nearly_parallel(random: &mut Random) -> Drawing {
    let slope = [0.0, 1.0, random.unit()][random.below(3)];
    let [x, y] = [[0.0, 0.0], [5e5, 5e6]][random.below(2)];
    let height = [1e-3, 1e-9, 1e-15][random.below(3)];
    let segments: Vec<[Point; 2]> = (0..8)
        .map(|_| {
            [0.0, 1.0].map(|u| {
                let u = u + 0.1 * random.unit();
                Point::new(x + u, y + slope * u + height * random.unit())
            })
        })
        .collect();
    Drawing::of_segments(segments)
}

/// Segments through a point that may or may not be a vertex.
fn fan(random: &mut Random) -> Drawing {
    let [x, y] = [[0.0, 0.0], [0.1, 0.3], [5e5, 5e6], [1.0 / 3.0, 1.0 / 7.0]][random.below(4)];
    let spokes = 3 + random.below(8);
    let segments: Vec<[Point; 2]> = (0..spokes)
        .map(|_| {
            let [u, v] = [random.unit() - 0.5, random.unit() - 0.5];
            [Point::new(x + u, y + v), Point::new(x - u, y - v)]
        })
        .collect();
    let mut drawing = Drawing::of_segments(segments);
    if random.below(2) == 0 {
        drawing.points.push(Point::new(x, y));
    }
    drawing
}

fn extreme(random: &mut Random) -> Drawing {
    let values = [
        1e300,
        -1e300,
        f64::MAX,
        -f64::MAX,
        1.0,
        -1.0,
        0.0,
        1e-300,
        5e-324,
        -1e-308,
    ];
    let points = (0..8).map(|_| Point::new(values[random.below(10)], values[random.below(10)]));
    let points = points.collect();
    Drawing::joined(points, 6, random)
}

fn long(random: &mut Random) -> Drawing {
    let end = |random: &mut Random| Point::new(random.unit(), random.unit());
    let segments: Vec<[Point; 2]> = (0..30).map(|_| [end(random), end(random)]).collect();
    Drawing::of_segments(segments)
}

type Family = (&'static str, fn(&mut Random) -> Drawing, u64);

const FAMILIES: [Family; 7] = [
    ("small lattice", small_lattice, 3000),
    ("tilted lattice", tilted_lattice, 3000),
    ("within one ulp", within_one_ulp, 2000),
    ("nearly parallel", nearly_parallel, 500),
    ("fan", fan, 500),
    ("extreme", extreme, 500),
    ("long", long, 10),
];

/// Runs a check on every drawing of every family; `DELONE_CASES` multiplies their number.
fn for_each(mut check: impl FnMut(&str, &Drawing, &mut Random)) {
    let factor = std::env::var("DELONE_CASES").map_or(1, |n| n.parse().expect("a number"));
    for (name, make, cases) in FAMILIES {
        for seed in 0..cases * factor {
            let mut random = Random(seed);
            let drawing = make(&mut random);
            check(name, &drawing, &mut random);
        }
    }
}

#[test]
fn nodings_are_valid() {
    for_each(|_, drawing, _| drawing.node().validate());
}

#[test]
fn nodings_are_as_defined() {
    let mut most = 0;
    for_each(|name, drawing, _| {
        let mut naive = Naive::new(drawing);
        while naive.step() {}
        let noded = drawing.node();
        assert_eq!(noded.subsegments(), naive.set, "{name}: {drawing:?}");
        let all = noded
            .points
            .iter()
            .map(|&p| key(p))
            .collect::<BTreeSet<_>>();
        assert_eq!(all, naive.vertices, "{name}: {drawing:?}");
        most = most.max(naive.rounds);
    });
    assert!((5..=16).contains(&most), "{most} rounds");
}

/// Segments within a unit in the last place of each other, which exact rounds alone would cut 2⁵⁰
/// times.
#[test]
fn cascades_end() {
    for (lines, most) in [(3, 200), (30, 10_000), (150, 100_000)] {
        let mut random = Random(lines);
        let mut end = |x: f64, y: f64| Point::new(random.jitter(x), random.jitter(y));
        let segments = (0..lines).map(|_| [end(0.1, 0.2), end(0.7, 0.9)]);
        let drawing = Drawing::of_segments(segments.collect::<Vec<_>>());
        let noded = drawing.node();
        assert!(
            noded.noding.points.len() < most,
            "{}",
            noded.noding.points.len()
        );
        if lines < 100 {
            noded.validate();
        }
    }
}

#[test]
fn order_and_direction_play_no_part() {
    for_each(|name, drawing, random| {
        let noded = drawing.node();
        let other = drawing.shuffled(random).node();
        assert_eq!(noded.added(), other.added(), "{name}: {drawing:?}");
        assert_eq!(
            noded.subsegments(),
            other.subsegments(),
            "{name}: {drawing:?}"
        );
    });
}

/// Calls `visit` with every order of `items`.
fn permutations(items: &mut Vec<[usize; 2]>, from: usize, visit: &mut impl FnMut(&[[usize; 2]])) {
    if from == items.len() {
        return visit(items);
    }
    for i in from..items.len() {
        items.swap(from, i);
        permutations(items, from + 1, visit);
        items.swap(from, i);
    }
}

#[test]
fn all_orders_give_the_same() {
    for seed in 0..20 {
        let mut random = Random(seed);
        let points =
            (0..8).map(|_| Point::new(random.below(7) as f64 * 0.1, random.below(7) as f64 * 0.3));
        let points = points.collect();
        let drawing = Drawing::joined(points, 5, &mut random);
        let expected = drawing.node();
        let mut orders = 0;
        permutations(&mut drawing.segments.clone(), 0, &mut |segments| {
            let segments = segments.to_vec();
            let points = drawing.points.clone();
            let noded = Drawing { points, segments }.node();
            assert_eq!(noded.added(), expected.added());
            assert_eq!(noded.subsegments(), expected.subsegments());
            orders += 1;
        });
        assert_eq!(orders, 120);
    }
}

/// The lexicographically first pair that crosses in a point that is no vertex, by brute force.
fn naive_first(drawing: &Drawing) -> Option<Crossing> {
    let (vertices, segments) = drawing.merged();
    let at = |ends: [VertexId; 2]| ends.map(|v| drawing.points[v.index()]);
    for (i, &s) in segments.iter().enumerate() {
        for (j, &t) in segments.iter().enumerate().skip(i + 1) {
            let [s, t] = [at(s), at(t)];
            let is_at_vertex = vertices.iter().any(|v| {
                let p = drawing.points[v.index()];
                is_between(s[0], s[1], p) && is_between(t[0], t[1], p)
            });
            if let Some(p) = crossing_point(s, t).filter(|_| !is_at_vertex) {
                return Some(([i, j], p));
            }
        }
    }
    None
}

#[test]
fn the_first_crossing_is_found() {
    let mut found = [0; 2];
    for_each(|name, drawing, _| {
        let (vertices, segments) = drawing.merged();
        let first = first_crossing(&drawing.points, &vertices, &segments, Workers::ONE, &());
        let first = first.expect("no watch");
        assert_eq!(first, naive_first(drawing), "{name}: {drawing:?}");
        found[usize::from(first.is_some())] += 1;
    });
    assert!(found.iter().all(|&n| n > 500), "{found:?}");
}

#[test]
fn threads_do_not_change_the_noding() {
    let mut random = Random(1);
    let end = |random: &mut Random| Point::new(random.unit(), random.unit());
    let segments: Vec<[Point; 2]> = (0..300)
        .map(|_| [end(&mut random), end(&mut random)])
        .collect();
    let drawing = Drawing::of_segments(segments);
    let (vertices, segments) = drawing.merged();
    let run = |threads| {
        let work = |workers| node(&drawing.points, &vertices, &segments, workers, &());
        crate::parallel::with_workers(Some(threads), work)
            .expect("threads")
            .expect("no watch")
    };
    let [one, three] = [run(1), run(3)];
    assert!(one.points.len() > 5000);
    assert_eq!(one.points, three.points);
    assert_eq!(one.crossings, three.crossings);
    assert_eq!(one.chains, three.chains);
}

#[test]
fn a_cross_is_cut_in_its_middle() {
    let at = |x: f64, y: f64| Point::new(x, y);
    let cross = Drawing::of_segments([[at(0.0, 0.0), at(2.0, 2.0)], [at(0.0, 2.0), at(2.0, 0.0)]]);
    let noded = cross.node();
    assert_eq!(noded.noding.points, [at(1.0, 1.0)]);
    assert_eq!(noded.noding.crossings, [[0, 1]]);
    let chain = [0, 4, 1].map(VertexId::new);
    assert_eq!(noded.noding.chains.get(0), Some(&chain[..]));
}

/// Repeated and overlapping segments, and one through a vertex: cut, but nothing crosses.
#[test]
fn overlaps_are_shared() {
    let points = (0..5).map(|x| Point::new(f64::from(x), 0.0)).collect();
    let segments = vec![[0, 3], [4, 1], [3, 0], [2, 4]];
    let noded = Drawing { points, segments }.node();
    noded.validate();
    assert!(noded.noding.points.is_empty());
    let chain = |i| {
        noded
            .noding
            .chains
            .get(i)
            .map(|c| c.iter().map(|v| v.index()).collect::<Vec<_>>())
    };
    assert_eq!(chain(0), Some(vec![0, 1, 2, 3]));
    assert_eq!(chain(1), Some(vec![4, 3, 2, 1]));
    assert_eq!(chain(2), Some(vec![3, 2, 1, 0]));
    assert_eq!(chain(3), Some(vec![2, 3, 4]));
    assert_eq!(noded.subsegments().len(), 4);
}

struct Impatient;

impl Watch for Impatient {
    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn a_watch_can_cancel() {
    let drawing = long(&mut Random(0));
    let (vertices, segments) = drawing.merged();
    let points = &drawing.points;
    assert!(node(points, &vertices, &segments, Workers::ONE, &Impatient).is_none());
    let first = first_crossing(points, &vertices, &segments, Workers::ONE, &Impatient);
    assert!(first.is_none());
}

#[test]
fn nothing_is_cut_where_there_is_nothing() {
    for drawing in [
        Drawing::of_segments([]),
        Drawing::of_segments([[Point::new(0.0, 0.0), Point::new(1.0, 1.0)]]),
    ] {
        let noded = drawing.node();
        assert_eq!(noded.noding.chains, Chains::default());
        assert!(noded.noding.points.is_empty());
    }
}
