//! Which triangles belong to the domain: rays, floods, and shortest ways on a table of edges.

use super::NaiveNoding;
use super::noding::exact;
use dashu_ratio::RBig;
use delone::predicates::{Orientation, orient2d};
use delone::{DomainRule, Point, Pslg, Seed, VertexId};
use std::collections::{BTreeMap, BTreeSet};

/// The triangles of a domain.
#[derive(Clone, Debug, PartialEq)]
pub struct NaiveDomain {
    /// Counter-clockwise, lowest index first, sorted.
    pub triangles: Vec<[VertexId; 3]>,
    /// For each triangle its region.
    pub regions: Vec<Option<usize>>,
}

/// Chooses the domain among all `triangles` of the hull.
///
/// Polygons must be closed, and coordinates finite.
///
/// # Errors
/// A seed that lies on a segment.
pub fn naive_domain(
    pslg: &Pslg,
    noding: &NaiveNoding,
    triangles: &[[VertexId; 3]],
    rule: DomainRule,
) -> Result<NaiveDomain, Seed> {
    let sheet = Sheet::new(noding, triangles);
    let mut is_inside = match rule {
        DomainRule::Hull => vec![true; triangles.len()],
        DomainRule::Carve => sheet.enclosed(),
        DomainRule::EvenOdd if pslg.polygons.is_empty() => sheet.odd_depth(),
        DomainRule::EvenOdd => sheet.in_polygons(pslg),
    };
    for (i, &at) in pslg.holes.iter().enumerate() {
        for t in sheet.around(at, Seed::Hole(i))? {
            is_inside[t] = false;
        }
    }
    let mut regions = vec![None; triangles.len()];
    for (i, region) in pslg.regions.iter().enumerate() {
        for t in sheet.around(region.at, Seed::Region(i))? {
            regions[t] = regions[t].or(Some(i));
        }
    }
    let kept = || (0..triangles.len()).filter(|&t| is_inside[t]);
    Ok(NaiveDomain {
        triangles: kept().map(|t| triangles[t]).collect(),
        regions: kept().map(|t| regions[t]).collect(),
    })
}

/// Tells whether every vertex is the end of an even number of the segments' edges; then parity is
/// the same along every way.
#[cfg(test)]
fn is_closed(noding: &NaiveNoding) -> bool {
    let mut odd = BTreeSet::new();
    for v in noding.edges().into_iter().flatten() {
        if !odd.remove(&v) {
            odd.insert(v);
        }
    }
    odd.is_empty()
}

/// Triangles, and how often segments run along their edges.
struct Sheet<'a> {
    noding: &'a NaiveNoding,
    triangles: &'a [[VertexId; 3]],
    /// To each directed edge the triangle on its left.
    left_of: BTreeMap<[VertexId; 2], usize>,
    /// To each edge of a segment, in both directions, how many segments run there.
    multiplicity: BTreeMap<[VertexId; 2], usize>,
}

impl<'a> Sheet<'a> {
    fn new(noding: &'a NaiveNoding, triangles: &'a [[VertexId; 3]]) -> Self {
        let mut multiplicity = BTreeMap::new();
        for [a, b] in noding.edges() {
            *multiplicity.entry([a, b]).or_default() += 1;
            *multiplicity.entry([b, a]).or_default() += 1;
        }
        let sides = triangles.iter().enumerate();
        let left_of = sides.flat_map(|(t, &corners)| edges(corners).map(|edge| (edge, t)));
        Self {
            noding,
            triangles,
            left_of: left_of.collect(),
            multiplicity,
        }
    }

    /// Lists for each edge of a triangle the triangle beyond, if any, and the segments on it.
    fn neighbors(&self, t: usize) -> [(Option<usize>, usize); 3] {
        edges(self.triangles[t]).map(|[a, b]| {
            let segments = self.multiplicity.get(&[a, b]).copied().unwrap_or(0);
            (self.left_of.get(&[b, a]).copied(), segments)
        })
    }

    /// What cannot be reached from outside without crossing a segment.
    fn enclosed(&self) -> Vec<bool> {
        let all = 0..self.triangles.len();
        let is_open = |&t: &usize| self.neighbors(t).contains(&(None, 0));
        let reached = self.flood(all.clone().filter(is_open).collect());
        all.map(|t| !reached.contains(&t)).collect()
    }

    /// What lies behind an odd number of segments on the way from outside that crosses the fewest;
    /// segments that run on each other count modulo 2.
    fn odd_depth(&self) -> Vec<bool> {
        let mut depth = vec![usize::MAX; self.triangles.len()];
        let mut changed = true;
        while changed {
            changed = false;
            for t in 0..depth.len() {
                let ways = self.neighbors(t).map(|(beyond, segments)| {
                    let before = beyond.map_or(0, |t| depth[t]);
                    before.saturating_add(segments % 2)
                });
                let least = ways.into_iter().min().expect("three ways");
                changed |= least < depth[t];
                depth[t] = depth[t].min(least);
            }
        }
        depth.into_iter().map(|depth| depth % 2 == 1).collect()
    }

    /// What a ray leaves across an odd number of edges of a polygon.
    fn in_polygons(&self, pslg: &Pslg) -> Vec<bool> {
        let mut is_inside = vec![false; self.triangles.len()];
        for polygon in &pslg.polygons {
            let chains = self.noding.chains[polygon.clone()].iter();
            let border: Vec<_> = chains.flat_map(|chain| chain.windows(2)).collect();
            for (t, inside) in is_inside.iter_mut().enumerate() {
                let centre = Centre::new(self.triangles[t].map(|v| self.point(v)));
                let crossed = border.iter().filter(|edge| {
                    let ends = [edge[0], edge[1]].map(|v| self.point(v));
                    centre.sees_to_the_right(ends)
                });
                *inside |= crossed.count() % 2 == 1;
            }
        }
        is_inside
    }

    /// Lists the triangles that can be reached from a seed without crossing a segment.
    fn around(&self, at: Point, seed: Seed) -> Result<BTreeSet<usize>, Seed> {
        let on = |&[a, b]: &[VertexId; 2]| lies_on(at, [self.point(a), self.point(b)]);
        if self.multiplicity.keys().any(on) {
            return Err(seed);
        }
        let contains = |&t: &usize| {
            let mut sides = edges(self.triangles[t]).into_iter();
            sides.all(|[a, b]| orient2d(self.point(a), self.point(b), at) != Orientation::Right)
        };
        let containing = (0..self.triangles.len()).filter(contains);
        Ok(self.flood(containing.collect()))
    }

    /// Adds to triangles all that can be reached from them without crossing a segment.
    fn flood(&self, mut reached: BTreeSet<usize>) -> BTreeSet<usize> {
        let mut todo: Vec<_> = reached.iter().copied().collect();
        while let Some(t) = todo.pop() {
            for (beyond, segments) in self.neighbors(t) {
                if let Some(t) = beyond.filter(|_| segments == 0)
                    && reached.insert(t)
                {
                    todo.push(t);
                }
            }
        }
        reached
    }

    fn point(&self, v: VertexId) -> Point {
        self.noding.points[v.index()]
    }
}

fn edges([a, b, c]: [VertexId; 3]) -> [[VertexId; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// Tells whether `p` lies on a segment, its ends included.
fn lies_on(p: Point, [a, b]: [Point; 2]) -> bool {
    let is_between = |c: f64, a: f64, b: f64| a.min(b) <= c && c <= a.max(b);
    is_between(p.x, a.x, b.x)
        && is_between(p.y, a.y, b.y)
        && orient2d(a, b, p) == Orientation::Collinear
}

/// Three times the centre of a triangle, exactly.
struct Centre([RBig; 2]);

impl Centre {
    fn new(corners: [Point; 3]) -> Self {
        let [[ax, ay], [bx, by], [cx, cy]] = corners.map(exact);
        Self([ax + bx + cx, ay + by + cy])
    }

    /// Tells whether the ray from the centre to the right crosses an edge, which it does not touch.
    fn sees_to_the_right(&self, ends: [Point; 2]) -> bool {
        let Self([x, y]) = self;
        let three = RBig::from(3);
        let [[ax, ay], [bx, by]] = ends.map(|p| exact(p).map(|c| c * &three));
        let (a_above, b_above) = (&ay > y, &by > y);
        if a_above == b_above {
            return false;
        }
        let turn = (&bx - &ax) * (y - &ay) - (&by - &ay) * (x - &ax);
        // Upwards the centre must be to the left, downwards to the right.
        (turn > RBig::ZERO) == b_above
    }
}

#[cfg(test)]
mod tests {
    use super::super::{naive_constrained, naive_noding};
    use super::*;
    use crate::generate::{Kind, Random};

    fn triangulated(pslg: &Pslg) -> (NaiveNoding, Vec<[VertexId; 3]>) {
        let noding = naive_noding(&pslg.points, &pslg.segments);
        let triangles = naive_constrained(&noding.points, &noding.edges());
        (noding, triangles)
    }

    fn domain(pslg: &Pslg, rule: DomainRule) -> Result<NaiveDomain, Seed> {
        let (noding, triangles) = triangulated(pslg);
        naive_domain(pslg, &noding, &triangles, rule)
    }

    /// Squares around (0, 0) with these half sides.
    fn squares(sizes: &[f64]) -> Pslg {
        let mut pslg = Pslg::default();
        for (i, &r) in (0..).zip(sizes) {
            let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
            pslg.points.extend(corners.map(Point::from));
            pslg.add_ring(4 * i..4 * i + 4);
        }
        pslg
    }

    #[test]
    fn nested_squares_follow_every_rule() {
        let mut pslg = squares(&[4.0, 3.0, 2.0]);
        pslg.points.push(Point::new(9.0, 0.0));
        let count = |pslg: &Pslg, rule| domain(pslg, rule).map(|d| d.triangles.len());
        assert_eq!(count(&pslg, DomainRule::Hull), Ok(8 + 8 + 2 + 1));
        assert_eq!(count(&pslg, DomainRule::Carve), Ok(8 + 8 + 2));
        assert_eq!(count(&pslg, DomainRule::EvenOdd), Ok(8 + 2));
        pslg.polygons = vec![0..4, 4..12];
        assert_eq!(count(&pslg, DomainRule::EvenOdd), Ok(8 + 8 + 2));
        pslg.holes = vec![Point::new(3.5, 0.0)];
        assert_eq!(count(&pslg, DomainRule::Carve), Ok(8 + 2));
        pslg.holes = vec![Point::new(3.0, 0.5)];
        assert_eq!(count(&pslg, DomainRule::Carve), Err(Seed::Hole(0)));
    }

    #[test]
    fn a_border_used_twice_counts_twice() {
        let mut pslg = squares(&[4.0, 2.0]);
        pslg.add_ring(4..8u32);
        let kept = domain(&pslg, DomainRule::EvenOdd).expect("no seeds");
        assert_eq!(kept.triangles.len(), 10);
    }

    #[test]
    fn rays_and_ways_agree_where_lines_are_closed() {
        let mut random = Random::new(1);
        for seed in 0..100 {
            let mut pslg = Pslg::from_points(Kind::Lattice { side: 4 }.points(8, seed));
            for _ in 0..2 {
                let ring = [0; 4].map(|_| random.below(8) as u32);
                pslg.add_ring(ring);
            }
            let (noding, triangles) = triangulated(&pslg);
            assert!(is_closed(&noding));
            let by_ways = naive_domain(&pslg, &noding, &triangles, DomainRule::EvenOdd);
            pslg.polygons.push(0..8);
            let by_rays = naive_domain(&pslg, &noding, &triangles, DomainRule::EvenOdd);
            assert_eq!(by_ways, by_rays, "{pslg:?}");
        }
    }
}
