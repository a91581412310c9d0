//! The lower convex hull of the lifted points in rational arithmetic: no predicate of the library.

use crate::sites::everywhere;
use crate::{Site, built};
use dashu_ratio::Relaxed;
use delone::VertexId;

/// A lifted point: x, y and x² + y² − weight.
struct Lifted([Relaxed; 3]);

impl Lifted {
    fn new((p, w): Site) -> Self {
        let [x, y, w] = [p.x, p.y, w].map(|c| Relaxed::try_from(c).expect("finite"));
        let height = &x * &x + &y * &y - w;
        Self([x, y, height])
    }

    fn minus(&self, other: &Self) -> [Relaxed; 3] {
        std::array::from_fn(|k| &self.0[k] - &other.0[k])
    }
}

fn cross([a, b]: [&Relaxed; 2], [c, d]: [&Relaxed; 2]) -> Relaxed {
    a * d - b * c
}

/// How far `d` lies above the plane of `a`, `b`, `c`, times a positive number if they turn left.
fn above([a, b, c]: [&Lifted; 3], d: &Lifted) -> Relaxed {
    let [u, v, w] = [b.minus(a), c.minus(a), d.minus(a)];
    let normal = [
        cross([&u[1], &u[2]], [&v[1], &v[2]]),
        cross([&u[2], &u[0]], [&v[2], &v[0]]),
        cross([&u[0], &u[1]], [&v[0], &v[1]]),
    ];
    &normal[0] * &w[0] + &normal[1] * &w[1] + &normal[2] * &w[2]
}

/// Every triangle is a piece of a lower facet: no lifted point lies below its plane. Together with the
/// sphere that the mesh is, the triangles are the lower hull.
fn check(sites: &[Site], name: &str) {
    let t = built(sites);
    let lifted: Vec<Lifted> = sites.iter().map(|&s| Lifted::new(s)).collect();
    let mut area = Relaxed::ZERO;
    for row in t.triangulation().triangles() {
        let [a, b, c] = row.map(|v| &lifted[v.index()]);
        let [u, v] = [b.minus(a), c.minus(a)];
        let turn = cross([&u[0], &u[1]], [&v[0], &v[1]]);
        assert!(turn > Relaxed::ZERO, "{name}: {row:?} does not turn left");
        area += turn;
        for (i, d) in lifted.iter().enumerate() {
            let is_below = above([a, b, c], d) < Relaxed::ZERO;
            assert!(!is_below, "{name}: {i} lies below {row:?} of {sites:?}");
        }
    }
    assert_eq!(area, hull_area(sites, &lifted), "{name}: {sites:?}");
    let contained = |v: &VertexId| t.is_hidden(*v) == t.hidden().contains(v);
    assert!((0..sites.len()).map(VertexId::new).all(|v| contained(&v)));
}

/// Twice the area of the convex hull, by gift wrapping.
fn hull_area(sites: &[Site], lifted: &[Lifted]) -> Relaxed {
    let by_place = |&i: &usize, &j: &usize| sites[i].0.lex_cmp(&sites[j].0);
    let Some(first) = (0..sites.len()).min_by(by_place) else {
        return Relaxed::ZERO;
    };
    let turn = |i: usize, j: usize, k: usize| {
        let [u, v] = [lifted[j].minus(&lifted[i]), lifted[k].minus(&lifted[i])];
        (cross([&u[0], &u[1]], [&v[0], &v[1]]), [u, v])
    };
    let (mut area, mut last) = (Relaxed::ZERO, first);
    loop {
        // The next corner has everything to its left, and of those in a row it is the farthest.
        let elsewhere = (0..sites.len()).filter(|&j| sites[j].0 != sites[last].0);
        let better = |best: usize, j: usize| {
            let (side, [u, v]) = turn(last, best, j);
            let length = |v: &[Relaxed; 3]| &v[0] * &v[0] + &v[1] * &v[1];
            let is_farther = side == Relaxed::ZERO && length(&v) > length(&u);
            if side < Relaxed::ZERO || is_farther {
                j
            } else {
                best
            }
        };
        let Some(next) = elsewhere.reduce(better) else {
            return Relaxed::ZERO;
        };
        area += turn(first, last, next).0;
        if sites[next].0 == sites[first].0 {
            return area;
        }
        last = next;
    }
}

#[test]
fn no_site_lies_below_the_triangles() {
    everywhere(3..30, 8, check);
}
