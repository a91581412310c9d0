//! Golden triangulations of degenerate sets, made with CGAL (`tests/golden/README.md`).

use delone::predicates::{CircleSide, Orientation, in_circle, in_circle_perturbed, orient2d};
use delone::{ConstrainedDelaunay, DomainRule, Point, Pslg, VertexId};
use delone_testkit::naive::naive_constrained;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

type Triangle = [usize; 3];

struct Golden {
    name: String,
    points: Vec<Point>,
    segments: Vec<[usize; 2]>,
    triangles: BTreeSet<Triangle>,
    /// Of a constrained set, the triangles behind an odd number of constrained edges.
    odd: BTreeSet<Triangle>,
}

/// The sets without segments.
fn goldens() -> Vec<Golden> {
    let all = read_all("tests/golden");
    assert_eq!(all.len(), 45);
    all
}

/// The sets with segments.
fn constrained_goldens() -> Vec<Golden> {
    let all = read_all("tests/golden/constrained");
    assert_eq!(all.len(), 35);
    all
}

fn read_all(folder: &str) -> Vec<Golden> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut all: Vec<Golden> = std::fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "txt"))
        .map(|path| read(&path))
        .collect();
    all.sort_by(|a, b| a.name.cmp(&b.name));
    all
}

fn read(path: &Path) -> Golden {
    let text = std::fs::read_to_string(path).expect("a readable file");
    let mut sections = BTreeMap::new();
    let mut lines = text.lines();
    while let Some((heading, count)) = lines.next().and_then(|line| line.split_once(' ')) {
        let rows = lines.by_ref().take(count.parse().expect("a count"));
        let rows = rows.map(|line| line.split(' ').collect::<Vec<_>>());
        sections.insert(heading, rows.collect::<Vec<_>>());
    }
    let index = |field: &str| field.parse::<usize>().expect("an index");
    let indices = |heading: &str| {
        let rows = sections.get(heading).into_iter().flatten();
        rows.map(|row| row.iter().map(|field| index(field)).collect::<Vec<_>>())
    };
    let coordinate = |field: &str| field.parse::<f64>().expect("a number");
    let points = sections["points"].iter();
    let rows = || indices("triangles");
    Golden {
        name: path.file_stem().expect("a name").to_string_lossy().into(),
        points: points
            .map(|row| Point::new(coordinate(row[0]), coordinate(row[1])))
            .collect(),
        segments: indices("segments").map(|row| [row[0], row[1]]).collect(),
        triangles: rows().map(|row| [row[0], row[1], row[2]]).collect(),
        odd: rows()
            .filter(|row| row.get(3) == Some(&1))
            .map(|row| [row[0], row[1], row[2]])
            .collect(),
    }
}

impl Golden {
    /// Maps each directed edge to the corner on its left.
    fn apexes(&self) -> BTreeMap<[usize; 2], usize> {
        let sides = |&[a, b, c]: &Triangle| [([a, b], c), ([b, c], a), ([c, a], b)];
        let apexes: BTreeMap<_, _> = self.triangles.iter().flat_map(sides).collect();
        assert_eq!(apexes.len(), 3 * self.triangles.len(), "{}", self.name);
        apexes
    }

    fn orient2d(&self, corners: Triangle) -> Orientation {
        let [a, b, c] = corners.map(|i| self.points[i]);
        orient2d(a, b, c)
    }

    fn is_inside(&self, [a, b, c]: Triangle, d: usize) -> bool {
        let [a, b, c, d] = [a, b, c, d].map(|i| self.points[i]);
        in_circle_perturbed(a, b, c, d)
    }

    fn is_cocircular(&self, [a, b, c]: Triangle, d: usize) -> bool {
        let [a, b, c, d] = [a, b, c, d].map(|i| self.points[i]);
        in_circle(a, b, c, d) == CircleSide::On
    }

    fn pslg(&self) -> Pslg {
        let mut pslg = Pslg::from_points(self.points.iter().copied());
        let segments = self.segments.iter();
        pslg.segments = segments.map(|s| s.map(VertexId::new)).collect();
        pslg
    }

    /// Counts the segments that run along the edge `ab`.
    fn multiplicity(&self, [a, b]: [usize; 2]) -> usize {
        let runs_along = |&&[p, q]: &&[usize; 2]| {
            let [start, end] = [p, q].map(|v| self.points[v]);
            let is_on = |v: usize| {
                let p = self.points[v];
                let is_between = |c: f64, a: f64, b: f64| a.min(b) <= c && c <= a.max(b);
                is_between(p.x, start.x, end.x)
                    && is_between(p.y, start.y, end.y)
                    && orient2d(start, end, p) == Orientation::Collinear
            };
            is_on(a) && is_on(b)
        };
        self.segments.iter().filter(runs_along).count()
    }

    /// Checks the edge `ab` between `abc` and `bad` from both sides, and its flip `dc`.
    fn check_edge(&self, [a, b]: [usize; 2], c: usize, d: usize) {
        let name = &self.name;
        assert!(!self.is_inside([a, b, c], d), "{name}: {a} {b} {c}, {d}");
        assert!(!self.is_inside([b, a, d], c), "{name}: {b} {a} {d}, {c}");
        let is_convex = self.orient2d([a, d, c]) == Orientation::Left
            && self.orient2d([d, b, c]) == Orientation::Left;
        if is_convex {
            assert!(self.is_inside([a, d, c], b), "{name}: {a} {d} {c}, {b}");
            assert!(self.is_inside([d, b, c], a), "{name}: {d} {b} {c}, {a}");
        }
    }
}

/// No builder needed: CGAL's choice among cocircular diagonals is ours, edge by edge.
#[test]
fn golden_edges_are_locally_delaunay() {
    let mut ties = 0;
    for golden in goldens() {
        let apexes = golden.apexes();
        for &triangle in &golden.triangles {
            assert_eq!(golden.orient2d(triangle), Orientation::Left);
        }
        for (&[a, b], &c) in &apexes {
            if let Some(&d) = apexes.get(&[b, a]) {
                golden.check_edge([a, b], c, d);
                ties += usize::from(golden.is_cocircular([a, b, c], d));
            }
        }
    }
    assert!(ties > 1000, "only {ties} ties");
}

#[test]
fn triangulate_agrees_with_golden() {
    for golden in goldens() {
        let built = delone::triangulate(golden.points.iter().copied()).expect("finite points");
        let triangles = triangle_set(built.triangles());
        assert_eq!(triangles, golden.triangles, "{}", golden.name);
    }
}

/// No builder needed here either.
#[test]
fn constrained_golden_edges_are_segments_or_locally_delaunay() {
    let (mut ties, mut kept) = (0, 0);
    for golden in constrained_goldens() {
        let apexes = golden.apexes();
        for (&[a, b], &c) in &apexes {
            assert_eq!(golden.orient2d([a, b, c]), Orientation::Left);
            let Some(&d) = apexes.get(&[b, a]) else {
                continue;
            };
            if golden.multiplicity([a, b]) == 0 {
                golden.check_edge([a, b], c, d);
                ties += usize::from(golden.is_cocircular([a, b, c], d));
            } else {
                kept += usize::from(golden.is_inside([a, b, c], d));
            }
        }
    }
    assert!(ties > 1000, "only {ties} ties");
    assert!(kept > 300, "only {kept} edges are there for their segments");
}

#[test]
fn constrained_delaunay_agrees_with_golden() {
    for golden in constrained_goldens() {
        let built = ConstrainedDelaunay::new().triangulate(golden.pslg());
        let built = built.unwrap_or_else(|e| panic!("{}: {e}", golden.name));
        let triangles = triangle_set(built.triangulation().triangles());
        assert_eq!(triangles, golden.triangles, "{}", golden.name);
    }
}

/// CGAL's level of nesting counts a constrained edge once, however many segments share it.
#[test]
fn even_odd_agrees_with_golden_where_no_segments_share_an_edge() {
    let mut compared = 0;
    for golden in constrained_goldens() {
        let apexes = golden.apexes();
        if apexes.keys().any(|&edge| golden.multiplicity(edge) > 1) {
            continue;
        }
        let rule = ConstrainedDelaunay::new().domain(DomainRule::EvenOdd);
        let built = rule.triangulate(golden.pslg()).expect("no crossings");
        let triangles = triangle_set(built.triangulation().triangles());
        assert_eq!(triangles, golden.odd, "{}", golden.name);
        compared += usize::from(!golden.odd.is_empty());
    }
    assert!(compared > 8, "only {compared} sets");
}

#[test]
fn the_constrained_oracle_agrees_with_golden() {
    let few = |golden: &Golden| golden.points.len() <= 40;
    for golden in constrained_goldens().into_iter().filter(few) {
        let apexes = golden.apexes();
        let edges = apexes.keys().filter(|&&edge| golden.multiplicity(edge) > 0);
        let edges: Vec<_> = edges.map(|edge| edge.map(VertexId::new)).collect();
        let triangles = triangle_set(&naive_constrained(&golden.points, &edges));
        assert_eq!(triangles, golden.triangles, "{}", golden.name);
    }
}

fn triangle_set(triangles: &[[VertexId; 3]]) -> BTreeSet<Triangle> {
    let triangles = triangles.iter().map(|corners| corners.map(VertexId::index));
    triangles.map(smallest_first).collect()
}

fn smallest_first([a, b, c]: Triangle) -> Triangle {
    [[a, b, c], [b, c, a], [c, a, b]]
        .into_iter()
        .min()
        .expect("three rotations")
}
