//! All triangulations of a few points, with naive answers.

use delone::predicates::{Orientation, in_circle_perturbed, orient2d};
use delone::{Point, VertexId, triangulate};
use delone_testkit::generate::{Kind, Random};
use delone_testkit::naive;
use std::collections::{BTreeMap, BTreeSet};

/// A triangulation as a set of triangles, each from its lowest corner on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Triangles(BTreeSet<[usize; 3]>);

/// A triangulation of points.
#[derive(Clone)]
pub struct Small<'p> {
    pub points: &'p [Point],
    pub triangles: Triangles,
}

/// Sets of few points: random ones, lattices full of ties, polygons.
pub fn sets() -> Vec<Vec<Point>> {
    let mut sets = Vec::new();
    for seed in 0..12 {
        sets.push(Kind::Lattice { side: 5 }.points(7, seed));
        sets.push(Kind::Lattice { side: 100 }.points(7, seed));
    }
    sets.push(Kind::CocircularRings.points(7, 3));
    let lattice = (0..9).map(|i| Point::new(f64::from(i % 3), f64::from(i / 3)));
    sets.push(lattice.collect());
    for set in &mut sets {
        set.sort_by(Point::lex_cmp);
        set.dedup();
        Random::new(1).shuffle(set);
    }
    sets
}

/// Lists all triangulations of a set.
pub fn all_triangulations(points: &[Point]) -> Vec<Small<'_>> {
    let all = naive::all_triangulations(points);
    let all = all.into_iter();
    all.map(|t| Small::new(points, t.into_iter())).collect()
}

impl<'p> Small<'p> {
    pub fn new(points: &'p [Point], triangles: impl Iterator<Item = [VertexId; 3]>) -> Self {
        let triangles = triangles.map(|t| normal(t.map(VertexId::index)));
        Self {
            points,
            triangles: Triangles(triangles.collect()),
        }
    }

    pub fn delaunay(points: &'p [Point]) -> Self {
        let delaunay = triangulate(points.iter().copied()).expect("finite");
        Self::new(points, delaunay.triangles().iter().copied())
    }

    pub fn triangles(&self) -> impl Iterator<Item = [usize; 3]> + '_ {
        self.triangles.0.iter().copied()
    }

    /// The apex of each directed edge.
    fn apexes(&self) -> BTreeMap<[usize; 2], usize> {
        let sides = |[a, b, c]: [usize; 3]| [([a, b], c), ([b, c], a), ([c, a], b)];
        self.triangles().flat_map(sides).collect()
    }

    /// The inner edges, and the outer ones that run counter-clockwise.
    pub fn edges(&self) -> Vec<[usize; 2]> {
        let apexes = self.apexes();
        let sides = apexes.keys().copied();
        sides
            .filter(|&[a, b]| a < b || !apexes.contains_key(&[b, a]))
            .collect()
    }

    /// The corners around an inner edge ac: a, b, c, d counter-clockwise.
    fn around(&self, [a, c]: [usize; 2]) -> Option<[usize; 4]> {
        let apexes = self.apexes();
        Some([a, *apexes.get(&[c, a])?, c, *apexes.get(&[a, c])?])
    }

    /// The triangulation after a flip, if it is admissible.
    pub fn flipped(&self, edge: [usize; 2]) -> Option<Self> {
        let [a, b, c, d] = self.around(edge)?;
        let is_left = |t: [usize; 3]| {
            let [a, b, c] = t.map(|v| self.points[v]);
            orient2d(a, b, c) == Orientation::Left
        };
        if !is_left([a, b, d]) || !is_left([b, c, d]) {
            return None;
        }
        let mut t = self.clone();
        for old in [[a, b, c], [a, c, d]] {
            assert!(t.triangles.0.remove(&normal(old)));
        }
        t.triangles.0.extend([[a, b, d], [b, c, d]].map(normal));
        Some(t)
    }

    /// The edges that are not locally Delaunay.
    pub fn failing_edges(&self) -> Vec<[usize; 2]> {
        let fails = |edge: &[usize; 2]| {
            let around = self.around(*edge);
            around.is_some_and(|[a, b, c, d]| self.is_in_conflict([a, b, c], d))
        };
        self.edges().into_iter().filter(fails).collect()
    }

    /// Φ.
    pub fn conflicts(&self) -> u64 {
        let triangles = self.triangles();
        let count = triangles.map(|t| {
            let inside = |&v: &usize| self.is_first(v) && self.is_in_conflict(t, v);
            (0..self.points.len()).filter(inside).count() as u64
        });
        count.sum()
    }

    /// Tells whether no earlier point equals it.
    fn is_first(&self, v: usize) -> bool {
        !self.points[..v].contains(&self.points[v])
    }

    fn is_in_conflict(&self, t: [usize; 3], v: usize) -> bool {
        let [a, b, c] = t.map(|v| self.points[v]);
        in_circle_perturbed(a, b, c, self.points[v])
    }
}

fn normal(mut t: [usize; 3]) -> [usize; 3] {
    let first = (0..3).min_by_key(|&k| t[k]).expect("three corners");
    t.rotate_left(first);
    t
}
