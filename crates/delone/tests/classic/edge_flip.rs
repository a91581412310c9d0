//! Edge flips of the thesis: its worked example, random starts with and without constraints, and what a
//! flip does to angles; and the tables as they are printed.

use super::suite::{run, sorted};
use delone::classic::{Algorithm, EdgeTables, Input};
use delone::predicates::{Orientation, in_circle_perturbed, orient2d};
use delone::{ConstrainedDelaunay, ConstrainedTriangulation, Error, Event, Point, Pslg, VertexId};
use delone_testkit::generate::Random;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

fn example(text: &str) -> Value {
    serde_json::from_str(text).expect("an example")
}

fn flips() -> Value {
    example(include_str!("../data/thesis/000-ex2.20-edge-flip.json"))
}

fn structures() -> Value {
    example(include_str!(
        "../data/thesis/000-ex2.13-2.15-2.17-structures.json"
    ))
}

fn rows<const N: usize>(value: &Value) -> Vec<[u32; N]> {
    let rows: Vec<Vec<u32>> = serde_json::from_value(value.clone()).expect("rows");
    let row = |row: Vec<u32>| row.try_into().expect("its length");
    rows.into_iter().map(row).collect()
}

/// Printed triangles, which count from 1.
fn triangles(value: &Value) -> Vec<[VertexId; 3]> {
    let rows = rows(value).into_iter();
    rows.map(|t: [u32; 3]| t.map(|v| VertexId::new(v as usize - 1)))
        .collect()
}

fn flips_of(log: &delone::Log) -> Vec<[[VertexId; 2]; 2]> {
    let flips = log.steps.iter().filter_map(|step| match step.event {
        Event::EdgeFlipped { from, to } => Some([from, to]),
        _ => None,
    });
    flips.collect()
}

#[test]
fn the_worked_example_is_flipped_as_printed() {
    let printed = flips();
    let points: Vec<[f64; 2]> = serde_json::from_value(printed["points"].clone()).expect("points");
    let mut input = Input::from_points(points);
    input.start = triangles(&printed["before"]["triangulation"]);
    let (output, log) = run(Algorithm::EdgeFlip, &input);
    let expected = printed["flips_in_order"].as_array().expect("flips");
    let expected: Vec<_> = expected
        .iter()
        .map(|flip| {
            [
                rows(&Value::from(vec![flip["old"].clone()])),
                rows(&Value::from(vec![flip["new"].clone()])),
            ]
        })
        .map(|[old, new]| [old[0], new[0]].map(|edge: [u32; 2]| edge.map(|v| v - 1)))
        .collect();
    let flipped = flips_of(&log).into_iter();
    let flipped: Vec<_> = flipped
        .map(|f| f.map(|edge| edge.map(VertexId::raw)))
        .collect();
    assert_eq!(flipped, expected);
    let examined = |event: &Event| matches!(event, Event::EdgeExamined { .. });
    let examined = log.steps.iter().filter(|step| examined(&step.event));
    assert_eq!(
        examined.count() as u64,
        printed["edges_examined"].as_u64().unwrap()
    );
    // Slots and corners, as the tables leave them.
    assert_eq!(
        output.triangles,
        triangles(&printed["after"]["triangulation"])
    );
}

#[test]
fn tables_are_printed_as_in_the_thesis() {
    let printed = structures();
    let tables = EdgeTables::new(10, &triangles(&printed["triangulation"])).expect("a mesh");
    assert_eq!(tables.triangles, rows(&printed["triangulation"]));
    let expected = rows(&printed["edges_with_triangles"]);
    assert_eq!(tables.edges_with_triangles, expected);
    let expected = rows(&printed["triangles_with_edges"]);
    assert_eq!(tables.triangles_with_edges, expected);
    let mut matrix = vec![[0; 10]; 10];
    for [row, column, triangle] in tables.edges() {
        matrix[row as usize - 1][column as usize - 1] = triangle;
    }
    assert_eq!(matrix, rows::<10>(&printed["edges_matrix"]));
    // Example 2.17 prints the first triangle turned.
    let variant = &printed["variant_2_17"];
    let mut turned = triangles(&printed["triangulation"]);
    turned[0] = triangles(&Value::from(vec![variant["triangle1"].clone()]))[0];
    let tables = EdgeTables::new(10, &turned).expect("a mesh");
    let expected: [u32; 3] = serde_json::from_value(variant["row1"].clone()).expect("a row");
    assert_eq!(tables.triangles_with_edges[0], expected);
}

#[test]
fn tables_of_no_mesh_are_refused() {
    let mesh = |t: &[[usize; 3]]| -> Vec<_> { t.iter().map(|t| t.map(VertexId::new)).collect() };
    let new = |points, t: &[[usize; 3]]| EdgeTables::new(points, &mesh(t));
    assert_eq!(new(0, &[]), Ok(EdgeTables::default()));
    let missing = Error::BadTriangle {
        triangle: 1,
        vertex: VertexId::new(3),
        points: 3,
    };
    assert_eq!(new(3, &[[0, 1, 2], [1, 3, 2]]), Err(missing));
    for (t, triangles, edge) in [
        (&[[0, 1, 2], [0, 1, 3]][..], [0, 1], [0, 1]),
        (&[[0, 1, 2], [1, 0, 3], [3, 1, 0]], [1, 2], [1, 0]),
        (&[[0, 1, 1]], [0, 0], [1, 1]),
    ] {
        let edge = edge.map(VertexId::new);
        assert_eq!(new(4, t), Err(Error::SameSide { triangles, edge }));
    }
}

/// A triangulation that is flipped at random, by a mirror of its directed edges.
struct Shuffled {
    points: Vec<Point>,
    /// The apex of each directed edge.
    apexes: BTreeMap<[VertexId; 2], VertexId>,
    locked: BTreeSet<[VertexId; 2]>,
}

impl Shuffled {
    fn new(t: &ConstrainedTriangulation) -> Self {
        let corners = t.triangulation().triangles().iter();
        let apexes = corners.flat_map(|&[a, b, c]| [([a, b], c), ([b, c], a), ([c, a], b)]);
        Self {
            points: t.triangulation().points().to_vec(),
            apexes: apexes.collect(),
            locked: t
                .constrained_edges()
                .map(|[a, b]| [a.min(b), a.max(b)])
                .collect(),
        }
    }

    fn orient(&self, corners: [VertexId; 3]) -> Orientation {
        let [a, b, c] = corners.map(|v| self.points[v.index()]);
        orient2d(a, b, c)
    }

    /// The corners beside an edge, if it is no constraint and has two triangles.
    fn beside(&self, [a, b]: [VertexId; 2]) -> Option<[VertexId; 2]> {
        if self.locked.contains(&[a.min(b), a.max(b)]) {
            return None;
        }
        Some([*self.apexes.get(&[a, b])?, *self.apexes.get(&[b, a])?])
    }

    /// Flips an edge if its quadrilateral is strictly convex.
    fn flip(&mut self, [a, b]: [VertexId; 2]) {
        let Some([c, d]) = self.beside([a, b]) else {
            return;
        };
        let new = [[c, d, b], [d, c, a]];
        if new.iter().all(|&t| self.orient(t) == Orientation::Left) {
            self.apexes.remove(&[a, b]);
            self.apexes.remove(&[b, a]);
            for [a, b, c] in new {
                self.apexes.extend([([a, b], c), ([b, c], a), ([c, a], b)]);
            }
        }
    }

    fn shuffle(&mut self, flips: usize, random: &mut Random) {
        for _ in 0..flips {
            if self.apexes.is_empty() {
                return;
            }
            let chosen = random.below(self.apexes.len());
            let edge = *self.apexes.keys().nth(chosen).expect("an edge");
            self.flip(edge);
        }
    }

    fn triangles(&self) -> Vec<[VertexId; 3]> {
        let sides = self.apexes.iter();
        sorted(
            sides
                .filter(|(e, c)| e[0] < e[1] && e[0] < **c)
                .map(|(&[a, b], &c)| [a, b, c]),
        )
    }

    /// Whether no edge that is no constraint has the corner beyond in its circle.
    fn is_locally_delaunay(&self) -> bool {
        self.apexes.keys().all(|&[a, b]| match self.beside([a, b]) {
            Some([c, d]) => {
                let [a, b, c, d] = [a, b, c, d].map(|v| self.points[v.index()]);
                !in_circle_perturbed(a, b, c, d)
            }
            None => true,
        })
    }
}

/// Points of a small lattice, or general ones, with a few segments that do not cross.
fn drawing(seed: u64) -> Pslg {
    let mut random = Random::new(seed);
    let (n, size) = (3 + random.below(20), random.choose(&[4, 8, 1000]));
    let points = (0..n).map(|_| [0, 1].map(|_| random.below(size) as f64));
    let mut pslg = Pslg::from_points(points.collect::<Vec<_>>());
    for _ in 0..random.below(6) {
        let ends = [0, 1].map(|_| VertexId::new(random.below(n)));
        let mut longer = pslg.clone();
        longer.segments.push(ends);
        if ConstrainedDelaunay::new()
            .triangulate(longer.clone())
            .is_ok()
        {
            pslg = longer;
        }
    }
    pslg
}

#[test]
fn every_start_ends_in_the_constrained_delaunay_triangulation() {
    let mut flipped = 0;
    for seed in 0..400 {
        let pslg = drawing(seed);
        let expected = ConstrainedDelaunay::new()
            .triangulate(pslg.clone())
            .expect("no crossing");
        let mut shuffled = Shuffled::new(&expected);
        shuffled.shuffle(60, &mut Random::new(seed));
        let mut input = Input::from_pslg(pslg);
        for start in [shuffled.triangles(), Vec::new()] {
            input.start = start;
            let (output, log) = run(Algorithm::EdgeFlip, &input);
            assert_eq!(
                output.hash(),
                expected.triangulation().hash(),
                "case {seed}"
            );
            assert_eq!(output.duplicates, expected.triangulation().duplicates());
            let constrained: Vec<_> = shuffled.locked.iter().copied().collect();
            assert_eq!(output.constrained, constrained, "case {seed}");
            flipped += flips_of(&log).len();
        }
    }
    assert!(flipped > 3000, "only {flipped} flips");
}

#[test]
fn locally_delaunay_everywhere_is_constrained_delaunay_and_nothing_else_is() {
    let (mut yes, mut no) = (0, 0);
    for seed in 0..400 {
        let pslg = drawing(seed);
        let expected = ConstrainedDelaunay::new()
            .triangulate(pslg)
            .expect("no crossing");
        let mut random = Random::new(seed);
        let mut shuffled = Shuffled::new(&expected);
        let goal = shuffled.triangles();
        for _ in 0..8 {
            let is_goal = shuffled.triangles() == goal;
            assert_eq!(shuffled.is_locally_delaunay(), is_goal, "case {seed}");
            *if is_goal { &mut yes } else { &mut no } += 1;
            shuffled.shuffle(2, &mut random);
        }
    }
    assert!(yes > 300 && no > 300, "{yes} {no}");
}

/// The cotangent of the angle at the first corner of a triangle that turns counter-clockwise, as a
/// fraction; the smaller the angle, the larger.
fn cotangent(corners: [VertexId; 3], points: &[Point]) -> [i128; 2] {
    let [a, b, c] = corners.map(|v| points[v.index()]);
    let [ux, uy, vx, vy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y].map(|d| d as i128);
    [ux * vx + uy * vy, ux * vy - uy * vx]
}

/// The largest cotangent in two triangles: that of their smallest angle.
fn sharpest(triangles: [[VertexId; 3]; 2], points: &[Point]) -> [i128; 2] {
    let corners = triangles
        .into_iter()
        .flat_map(|[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]]);
    let cotangents = corners.map(|corners| cotangent(corners, points));
    let sharpest = cotangents.max_by(|[p, q], [r, s]| (p * s).cmp(&(r * q)));
    sharpest.expect("six angles")
}

#[test]
fn a_flip_never_lowers_the_smallest_of_six_angles() {
    let (mut flips, mut raised) = (0, 0);
    for seed in 400..600 {
        let pslg = drawing(seed);
        let t = ConstrainedDelaunay::new()
            .triangulate(pslg.clone())
            .expect("no crossing");
        let mut shuffled = Shuffled::new(&t);
        shuffled.shuffle(60, &mut Random::new(seed));
        let mut input = Input::from_pslg(pslg);
        input.start = shuffled.triangles();
        let (_, log) = run(Algorithm::EdgeFlip, &input);
        let mut scene = log.first_scene();
        for step in &log.steps {
            if let Event::EdgeFlipped { from: [a, b], .. } = step.event {
                let [c, d] = [[a, b], [b, a]].map(|edge| scene.apex(edge).expect("a triangle"));
                let points = &input.pslg.points;
                let [p, q] = sharpest([[a, b, c], [b, a, d]], points);
                let [r, s] = sharpest([[c, d, b], [d, c, a]], points);
                assert!(r * q <= p * s, "case {seed}: {:?}", step.event);
                flips += 1;
                raised += usize::from(r * q < p * s);
            }
            scene.apply(step.event).expect("it fits");
        }
    }
    assert!(flips > 500 && raised > flips / 2, "{raised} of {flips}");
}

#[test]
fn starts_that_are_no_triangulation_are_refused() {
    let mut input = Input::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
    let start = |t: &[[usize; 3]]| t.iter().map(|t| t.map(VertexId::new)).collect();
    for bad in [
        &[[0, 2, 1]][..],
        &[[0, 1, 4]],
        &[[0, 1, 2], [0, 1, 3]],
        &[[0, 1, 1]],
    ] {
        input.start = start(bad);
        let error = Algorithm::EdgeFlip
            .run(&input)
            .expect_err("no triangulation");
        assert!(error.to_string().contains("triangle"), "{error}");
    }
    input.start = start(&[[0, 1, 2]]);
    let (output, _) = run(Algorithm::EdgeFlip, &input);
    assert_eq!(output.triangles, input.start);
}
