//! Small domains: points as in [`points`](super::points), drawn upon at random.

use super::points::{kind, points_from_bytes};
use super::{Case, array, guarded, without_one};
use crate::domains::{
    Domain, check_canonical, check_error, check_naive, check_sound, check_verified, has_crossing,
};
use crate::generate::Random;
use delone::{DomainRule, Point, Pslg, Region, SegmentPolicy, VertexId};
use std::ops::Range;

const RULES: [DomainRule; 3] = [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd];

/// Fills `domain` with the case that `seed` names, of at most so many points and segments.
pub fn case(seed: u64, max_points: usize, max_segments: usize, domain: &mut Domain) {
    let r = &mut Random::new(seed);
    domain.crossings = r.choose(&[
        SegmentPolicy::Split,
        SegmentPolicy::Split,
        SegmentPolicy::Split,
        SegmentPolicy::Error,
    ]);
    domain.rule = r.choose(&RULES);
    let pslg = &mut domain.pslg;
    let n = 1 + r.below(max_points);
    kind(r).fill(&mut pslg.points, n, r);
    place(&mut pslg.points, r);
    pslg.segments.clear();
    pslg.polygons.clear();
    draw(pslg, r.below(max_segments + 1), r);
    if r.below(8) == 0 {
        repeat(pslg, r);
    }
    plant(pslg, r);
}

/// Leaves the points where they are, tilts them, or moves them to where maps are.
fn place(points: &mut [Point], r: &mut Random) {
    let (sin, cos) = (r.unit() * std::f64::consts::TAU).sin_cos();
    let tilted = |p: Point| Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
    let on_map = |p: Point| Point::new(p.x * 0.1 + 500_000.1, p.y * 0.1 + 5_400_000.2);
    let moved: &dyn Fn(Point) -> Point = match r.below(8) {
        0 | 1 => &tilted,
        2 => &on_map,
        3 => &|p| on_map(tilted(p)),
        _ => return,
    };
    let is_finite = |&p: &Point| moved(p).is_finite();
    if points.iter().all(is_finite) {
        points.iter_mut().for_each(|p| *p = moved(*p));
    }
}

/// Draws loose segments, lines, or rings, all of which may share points, cross and overlap.
fn draw(pslg: &mut Pslg, segments: usize, r: &mut Random) {
    let style = r.below(4);
    let is_polygon = r.below(2) == 0;
    while pslg.segments.len() < segments {
        let first = pslg.segments.len();
        let some = |least: usize, r: &mut Random| {
            let count = least + r.below(5);
            let line: Vec<_> = (0..count).map(|_| any_vertex(pslg, r)).collect();
            line
        };
        match if style == 3 { r.below(3) } else { style } {
            0 => {
                let ends = [any_vertex(pslg, r), any_vertex(pslg, r)];
                pslg.segments.push(ends);
            }
            1 => {
                let line = some(2, r);
                pslg.add_polyline(line);
            }
            _ => {
                let ring = some(2, r);
                pslg.add_ring(ring);
                if is_polygon {
                    add_to_polygon(pslg, first, r);
                }
            }
        }
    }
}

fn any_vertex(pslg: &Pslg, r: &mut Random) -> VertexId {
    VertexId::new(r.below(pslg.points.len()))
}

/// Makes a polygon of the segments from `first` on, or adds them to the one before.
fn add_to_polygon(pslg: &mut Pslg, first: usize, r: &mut Random) {
    let end = pslg.segments.len();
    match pslg.polygons.last_mut() {
        Some(last) if last.end == first && r.below(3) == 0 => last.end = end,
        _ => pslg.polygons.push(first..end),
    }
}

/// Repeats some segments, in either direction.
fn repeat(pslg: &mut Pslg, r: &mut Random) {
    for i in 0..pslg.segments.len() {
        let [a, b] = pslg.segments[i];
        match r.below(4) {
            0 => pslg.segments.push([a, b]),
            1 => pslg.segments.push([b, a]),
            _ => {}
        }
    }
}

/// Plants the seeds of holes and regions, more often between points than upon them.
fn plant(pslg: &mut Pslg, r: &mut Random) {
    let seed = |r: &mut Random| {
        let [a, b, c] = [0; 3].map(|_| pslg.points[r.below(pslg.points.len())]);
        let middle = |a: f64, b: f64| a / 2.0 + b / 2.0;
        let ab = Point::new(middle(a.x, b.x), middle(a.y, b.y));
        match r.below(8) {
            0 => a,
            1 => ab,
            2 => Point::new(ab.x + 1.0, ab.y - 0.25),
            _ => Point::new(middle(ab.x, c.x), middle(ab.y, c.y)),
        }
    };
    let some = |r: &mut Random| {
        let count = r.below(6).saturating_sub(3);
        let seeds: Vec<_> = (0..count).map(|_| seed(r)).collect();
        seeds
    };
    let (holes, regions) = (some(r), some(r));
    pslg.holes = holes;
    pslg.regions = regions.into_iter().map(region).collect();
}

fn region(at: Point) -> Region {
    Region {
        at,
        attribute: 1.0,
        max_area: None,
    }
}

/// Reads a domain from a fuzzer's bytes: policy and rule, a number of segments, their ends, whether
/// they bound a polygon, and then [points](points_from_bytes), the first ones holes if asked for.
pub fn domain_from_bytes(bytes: &[u8]) -> Domain {
    let Some((&[mode, count], rest)) = bytes.split_first_chunk() else {
        return Domain::default();
    };
    let segments = 2 * usize::from(count % 32).min(rest.len() / 2);
    let (ends, rest) = rest.split_at(segments);
    let points = points_from_bytes(rest);
    let mut domain = Domain {
        crossings: if mode & 1 == 0 {
            SegmentPolicy::Split
        } else {
            SegmentPolicy::Error
        },
        rule: RULES[usize::from(mode >> 1) % 3],
        ..Domain::default()
    };
    if points.is_empty() {
        return domain;
    }
    let vertex = |&end: &u8| VertexId::new(usize::from(end) % points.len());
    let pslg = &mut domain.pslg;
    pslg.segments = ends
        .as_chunks()
        .0
        .iter()
        .map(|[a, b]| [vertex(a), vertex(b)])
        .collect();
    if mode & 0x40 != 0 {
        pslg.polygons.push(0..pslg.segments.len());
    }
    if mode & 0x80 != 0 {
        pslg.holes = points[..1].to_vec();
        pslg.regions = points[1..]
            .first()
            .map(|&at| region(at))
            .into_iter()
            .collect();
    }
    pslg.points = points;
    domain
}

/// Triangulates a domain and checks the result; a panic is a failure too. With `is_deep`, it is
/// compared with the definitions, and built on several threads.
///
/// # Errors
/// What went wrong.
pub fn check(domain: &Domain, is_deep: bool, seed: u64) -> Result<(), String> {
    guarded(|| check_result(domain, is_deep, seed))
}

fn check_result(domain: &Domain, is_deep: bool, seed: u64) -> Result<(), String> {
    let t = match domain.triangulate(1) {
        Ok(t) => t,
        Err(error) => return check_error(domain, &error),
    };
    if domain.crossings == SegmentPolicy::Error && has_crossing(&domain.pslg) {
        return Err("a crossing was not refused".to_owned());
    }
    check_sound(&domain.pslg, &t)?;
    let threads = if is_deep { 3 } else { 1 };
    check_canonical(domain, &t, threads, &mut Random::new(seed))?;
    if is_deep {
        check_naive(domain, &t)?;
        check_verified(domain, &t)?;
    }
    Ok(())
}

impl Case for Domain {
    fn smaller(&self) -> Vec<Self> {
        let pslg = &self.pslg;
        let parts = [
            without_one(&pslg.polygons)
                .map(|polygons| Pslg {
                    polygons,
                    ..pslg.clone()
                })
                .collect(),
            without_one(&pslg.holes)
                .map(|holes| Pslg {
                    holes,
                    ..pslg.clone()
                })
                .collect(),
            without_one(&pslg.regions)
                .map(|regions| Pslg {
                    regions,
                    ..pslg.clone()
                })
                .collect(),
            (0..pslg.segments.len())
                .map(|s| without_segment(pslg, s))
                .collect(),
            (0..pslg.points.len())
                .filter_map(|v| without_point(pslg, v))
                .collect::<Vec<_>>(),
        ];
        let with = |pslg| Self {
            pslg,
            ..self.clone()
        };
        parts.into_iter().flatten().map(with).collect()
    }

    fn as_source(&self) -> String {
        let Self {
            pslg,
            crossings,
            rule,
        } = self;
        let segments: Vec<_> = pslg.segments.iter().map(|s| s.map(|v| v.raw())).collect();
        format!(
            "let pslg = Pslg {{\n\
             points: {}.map(Point::from).to_vec(),\n\
             segments: {segments:?}.map(|s: [u32; 2]| s.map(VertexId::from)).to_vec(),\n\
             polygons: vec!{:?},\n\
             holes: vec!{:?},\n\
             regions: vec!{:?},\n\
             }};\n\
             // SegmentPolicy::{crossings:?}, DomainRule::{rule:?}",
            array(&pslg.points),
            pslg.polygons,
            pslg.holes,
            pslg.regions,
        )
    }
}

fn without_segment(pslg: &Pslg, segment: usize) -> Pslg {
    let mut fewer = pslg.clone();
    fewer.segments.remove(segment);
    let moved = |end: usize| end - usize::from(end > segment);
    for Range { start, end } in &mut fewer.polygons {
        (*start, *end) = (moved(*start), moved(*end));
    }
    fewer
}

/// Drops a point that is no end of a segment.
fn without_point(pslg: &Pslg, point: usize) -> Option<Pslg> {
    let mut fewer = pslg.clone();
    fewer.points.remove(point);
    for v in fewer.segments.as_flattened_mut() {
        if v.index() == point {
            return None;
        }
        *v = VertexId::new(v.index() - usize::from(v.index() > point));
    }
    Some(fewer)
}

#[cfg(test)]
mod tests {
    use super::super::shrink;
    use super::*;

    fn domain(seed: u64) -> Domain {
        let mut domain = Domain::default();
        case(seed, 10, 8, &mut domain);
        domain
    }

    #[test]
    fn cases_are_named_by_their_seeds_and_pass() {
        for seed in 0..2000 {
            let found = domain(seed);
            assert_eq!(found, domain(seed));
            let outcome = check(&found, seed % 8 == 0, seed);
            assert_eq!(outcome, Ok(()), "seed {seed}\n{}", found.as_source());
        }
    }

    #[test]
    fn cases_are_of_every_sort() {
        let sorts: [fn(&Domain) -> bool; 6] = [
            |d| has_crossing(&d.pslg),
            |d| !d.pslg.holes.is_empty(),
            |d| d.pslg.regions.len() > 1,
            |d| d.pslg.polygons.len() > 1,
            |d| d.pslg.segments.iter().any(|[a, b]| a == b),
            |d| d.triangulate(1).is_ok_and(|t| t.num_crossings() > 2),
        ];
        for (i, is_of_sort) in sorts.iter().enumerate() {
            let count = (0..1000).filter(|&seed| is_of_sort(&domain(seed))).count();
            assert!(count > 20, "only {count} of sort {i}");
        }
    }

    #[test]
    fn shrinking_keeps_what_matters() {
        let mut found = domain(1);
        found.pslg =
            Pslg::from_points([(5.0, 5.0), (0.0, 0.0), (4.0, 4.0), (0.0, 4.0), (4.0, 0.0)]);
        found.pslg.add_ring([0u32, 1, 2]);
        found.pslg.add_ring([3u32, 4, 0]);
        found.pslg.polygons.push(0..6);
        found.pslg.holes.push(Point::default());
        let small = shrink(&found, |d| has_crossing(&d.pslg));
        let mut expected = Pslg::from_points([(0.0, 0.0), (4.0, 4.0), (0.0, 4.0), (4.0, 0.0)]);
        expected.add_segment(0, 1);
        expected.add_segment(2, 3);
        assert_eq!(small.pslg, expected);
        assert!(small.as_source().contains("[[0, 1], [2, 3]].map("));
    }

    #[test]
    fn bytes_become_domains() {
        assert_eq!(domain_from_bytes(&[]), Domain::default());
        let bytes = [0xc3, 2, 0, 1, 2, 3, 0, 0, 0, 0, 1, 1, 1, 1, 0];
        let found = domain_from_bytes(&bytes);
        assert_eq!(found.pslg.points.len(), 4);
        assert_eq!(
            found.pslg.segments,
            [[0, 1], [2, 3]].map(|s| s.map(VertexId::from))
        );
        assert_eq!(
            (found.crossings, found.rule),
            (SegmentPolicy::Error, DomainRule::Carve)
        );
        assert_eq!((found.pslg.polygons.len(), found.pslg.holes.len()), (1, 1));
    }
}
