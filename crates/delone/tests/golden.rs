//! Golden triangulations of cocircular sets, made with CGAL (`tests/golden/README.md`).

use delone::Point;
use delone::predicates::CircleSide;
use delone::predicates::{Orientation, in_circle, in_circle_perturbed, orient2d};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

type Triangle = [usize; 3];

struct Golden {
    name: String,
    points: Vec<Point>,
    triangles: BTreeSet<Triangle>,
}

fn goldens() -> Vec<Golden> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let mut all: Vec<Golden> = std::fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "txt"))
        .map(|path| read(&path))
        .collect();
    all.sort_by(|a, b| a.name.cmp(&b.name));
    assert_eq!(all.len(), 45);
    all
}

fn read(path: &Path) -> Golden {
    let text = std::fs::read_to_string(path).expect("a readable file");
    let mut words = text.split_whitespace();
    let mut next = || words.next().expect("a longer file");
    assert_eq!(next(), "points");
    let count: usize = next().parse().expect("a count");
    let mut number = || next().parse::<f64>().expect("a number");
    let points = (0..count).map(|_| Point::new(number(), number())).collect();
    assert_eq!(next(), "triangles");
    let count: usize = next().parse().expect("a count");
    let mut index = || next().parse::<usize>().expect("an index");
    let triangles = (0..count).map(|_| [index(), index(), index()]).collect();
    Golden {
        name: path.file_stem().expect("a name").to_string_lossy().into(),
        points,
        triangles,
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
        let triangles: BTreeSet<Triangle> = built
            .triangles()
            .iter()
            .map(|corners| smallest_first(corners.map(|v| v.index())))
            .collect();
        assert_eq!(triangles, golden.triangles, "{}", golden.name);
    }
}

fn smallest_first([a, b, c]: Triangle) -> Triangle {
    [[a, b, c], [b, c, a], [c, a, b]]
        .into_iter()
        .min()
        .expect("three rotations")
}
