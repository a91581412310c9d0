//! Seeded data as they come from measurements, and as they come from nobody but a tester.

use crate::generate::{Kind, Random};
use delone::Point;

/// How scattered data lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DataKind {
    /// On a square lattice, row by row: exact ties everywhere. The last row may be cut short.
    Lattice,
    /// A few places, each many times.
    Duplicates,
    /// All but the last on one line.
    LineAndPoint,
    /// On a circle as well as `f64` can.
    Circle,
    /// Along the ways of ships: exactly collinear runs in all directions, with gaps.
    ShipTracks,
    /// Along parallel lines, flown to and fro: dense along them, far apart across.
    FlightLines,
    /// Dense clusters, thinning out, and a few data between them.
    Clusters,
    /// Evenly in the unit square.
    Uniform,
    /// A unit square 10⁶ away.
    HugeOffset,
    /// A square of size 10⁻²⁰⁰.
    Tiny,
    /// A square of size 10²⁰⁰.
    Huge,
}

impl DataKind {
    /// Every kind, the degenerate ones first.
    pub const ALL: [Self; 11] = [
        Self::Lattice,
        Self::Duplicates,
        Self::LineAndPoint,
        Self::Circle,
        Self::ShipTracks,
        Self::FlightLines,
        Self::Clusters,
        Self::Uniform,
        Self::HugeOffset,
        Self::Tiny,
        Self::Huge,
    ];
}

/// Makes the `n` data of a kind that `seed` names.
pub fn data(kind: DataKind, n: usize, seed: u64) -> Vec<Point> {
    let uniform = || Kind::Uniform.points(n, seed);
    let moved = |f: fn(f64) -> f64| {
        let moved = uniform().into_iter().map(|p| Point::new(f(p.x), f(p.y)));
        moved.collect()
    };
    let mut random = Random::new(seed);
    match kind {
        DataKind::Lattice => lattice(n),
        DataKind::Duplicates => Kind::Duplicates.points(n, seed),
        DataKind::LineAndPoint => line_and_point(n, &mut random),
        DataKind::Circle => Kind::Circle.points(n, seed),
        DataKind::ShipTracks => ship_tracks(n, &mut random),
        DataKind::FlightLines => flight_lines(n, &mut random),
        DataKind::Clusters => clusters(n, &mut random),
        DataKind::Uniform => uniform(),
        DataKind::HugeOffset => moved(|c| c + 1e6),
        DataKind::Tiny => moved(|c| c * 1e-200),
        DataKind::Huge => moved(|c| c * 1e200),
    }
}

fn lattice(n: usize) -> Vec<Point> {
    let side = (1..).find(|side| side * side >= n).unwrap_or(1);
    let at = |i: usize| Point::new((i % side) as f64, (i / side) as f64);
    (0..n).map(at).collect()
}

fn line_and_point(n: usize, random: &mut Random) -> Vec<Point> {
    let [dx, dy] = direction(random);
    let mut data = along([0, 0], [dx, dy], 0..n.saturating_sub(1) as i64);
    if n > 0 {
        data.push(Point::new((-5 * dy) as f64, (5 * dx) as f64));
    }
    data
}

/// Data to a track, about.
const TRACK: usize = 25;

/// Within which ships set out, at least; where many do the sea is wider, so that few data coincide.
const SEA: usize = 400;

fn ship_tracks(n: usize, random: &mut Random) -> Vec<Point> {
    let mut data = Vec::with_capacity(n);
    let sea = SEA.max(4 * n.isqrt());
    while data.len() < n {
        let start = [0; 2].map(|_| random.below(sea) as i64);
        let way = direction(random);
        let mut step = 0;
        for _ in 0..TRACK.min(n - data.len()) {
            data.extend(along(start, way, step..step + 1));
            let is_gap = random.below(10) == 0;
            step += if is_gap {
                5 + random.below(16) as i64
            } else {
                1
            };
        }
    }
    data
}

fn flight_lines(n: usize, random: &mut Random) -> Vec<Point> {
    let [dx, dy] = direction(random);
    let lines = (1..).find(|lines| lines * lines * 8 >= n).unwrap_or(1);
    let length = n.div_ceil(lines);
    let mut data = Vec::with_capacity(n);
    for line in 0..lines {
        let steps = 0..length.min(n - data.len()) as i64;
        let across = 8 * line as i64;
        let mut flown = along([-across * dy, across * dx], [dx, dy], steps);
        if line % 2 == 1 {
            flown.reverse();
        }
        data.extend(flown);
    }
    data
}

fn clusters(n: usize, random: &mut Random) -> Vec<Point> {
    let centers = [0; 5].map(|_| [random.unit(), random.unit()]);
    let draw = |_| {
        if random.below(20) == 0 {
            return Point::new(random.unit(), random.unit());
        }
        let [x, y] = random.choose(&centers);
        // The cube is small more often than not.
        let [dx, dy] = [0; 2].map(|_| (2.0 * random.unit() - 1.0).powi(3) * 0.05);
        Point::new(x + dx, y + dy)
    };
    (0..n).map(draw).collect()
}

/// A direction in small integers, not zero.
fn direction(random: &mut Random) -> [i64; 2] {
    [1 + random.below(4) as i64, random.below(9) as i64 - 4]
}

/// Lists the points that lie so many `steps` of `way` from `start`; exactly, hence on one line.
fn along(start: [i64; 2], way: [i64; 2], steps: std::ops::Range<i64>) -> Vec<Point> {
    let at = |step: i64| [0, 1].map(|i| (start[i] + step * way[i]) as f64);
    steps.map(|step| Point::from(at(step))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::predicates::{Orientation, orient2d};

    #[test]
    fn every_kind_is_finite_and_named_by_its_seed() {
        for kind in DataKind::ALL {
            for n in [0, 1, 2, 3, 10, 257] {
                let found = data(kind, n, 5);
                assert_eq!(found.len(), n, "{kind:?}");
                assert!(found.iter().all(Point::is_finite), "{kind:?}");
                assert_eq!(found, data(kind, n, 5));
            }
        }
    }

    #[test]
    fn data_that_depend_on_chance_depend_on_the_seed() {
        for kind in DataKind::ALL {
            let first = data(kind, 100, 0);
            let differs = (1..5).any(|seed| data(kind, 100, seed) != first);
            assert_eq!(differs, kind != DataKind::Lattice, "{kind:?}");
        }
    }

    fn are_collinear(points: &[Point]) -> bool {
        let is_on = |&p: &Point| orient2d(points[0], points[1], p) == Orientation::Collinear;
        points.iter().all(is_on)
    }

    #[test]
    fn lines_are_straight() {
        for seed in 0..20 {
            let line = data(DataKind::LineAndPoint, 30, seed);
            assert!(are_collinear(&line[..29]) && !are_collinear(&line));
            let tracks = data(DataKind::ShipTracks, 3 * TRACK, seed);
            assert!(tracks.chunks(TRACK).all(are_collinear));
            let lines = data(DataKind::FlightLines, 200, seed);
            assert!(lines.chunks(40).all(are_collinear) && !are_collinear(&lines));
        }
    }
}
