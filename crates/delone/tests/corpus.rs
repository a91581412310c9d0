//! Every file of the shared corpus: triangulated, verified, and the same again when shuffled,
//! rotated or scaled; and by name the inputs on which other systems broke.

use delone::check::{self, Certificate};
use delone::{Duplicate, Point, Triangulation, VertexId, triangulate};
use delone_testkit::corpus;
use std::collections::HashMap;
use std::fs;
use std::path::Path;

/// Beyond this many points the extreme scalings, which need wide arithmetic, take too long here.
const FEW: usize = 3000;

/// The few files of the corpus that are part of the repository.
const FIXTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");

/// The golden results of the fixtures: name, then vertices, duplicates, triangles, hull edges, hash.
const GOLDEN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/corpus-hashes.txt");

/// Triangulates, verifies, and compares what the result says of itself with what was verified.
fn verified(name: &str, points: &[Point]) -> (Triangulation, Certificate) {
    let t = triangulate(points.iter().copied()).unwrap_or_else(|e| panic!("{name}: {e}"));
    let verdict = check::verify(points, t.triangles(), &()).expect("finite points");
    let certificate = verdict
        .into_result()
        .unwrap_or_else(|defects| panic!("{name}:\n{defects}"));
    assert_eq!(t.num_vertices(), certificate.vertices, "{name}");
    assert_eq!(t.num_triangles(), certificate.triangles, "{name}");
    assert_eq!(t.num_edges(), certificate.edges, "{name}");
    assert_eq!(t.num_hull_edges(), certificate.hull_edges, "{name}");
    assert_eq!(t.duplicates().len(), certificate.duplicates, "{name}");
    assert_eq!(t.hash(), certificate.hash, "{name}");
    assert_lowest_kept(name, &t);
    (t, certificate)
}

fn assert_lowest_kept(name: &str, t: &Triangulation) {
    let mut first_at: HashMap<[u64; 2], VertexId> = HashMap::new();
    for (v, p) in t.points().iter().enumerate() {
        let v = VertexId::new(v);
        let place = [p.x, p.y].map(|c| (c + 0.0).to_bits());
        let first = *first_at.entry(place).or_insert(v);
        assert_eq!(t.representative(v), first, "{name}: point {v}");
    }
}

/// The triangles as vertices, in an order that depends on the set alone.
fn sorted_triangles(t: &Triangulation) -> Vec<[VertexId; 3]> {
    let mut triangles = t.triangles().to_vec();
    for corners in &mut triangles {
        let lowest = (0..3).min_by_key(|&k| corners[k]);
        corners.rotate_left(lowest.expect("three corners"));
    }
    triangles.sort();
    triangles
}

/// A generator of 64 random bits a call (SplitMix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn shuffle(&mut self, points: &mut [Point]) {
        for last in (1..points.len()).rev() {
            points.swap(last, (self.next() % (last as u64 + 1)) as usize);
        }
    }

    fn rotate(&mut self, points: &mut [Point]) {
        let (sin, cos) = ((self.next() >> 11) as f64 * 2f64.powi(-50)).sin_cos();
        for p in points {
            *p = Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
        }
    }
}

/// Multiplies by a power of two; `None` unless that is exact for every coordinate.
fn scaled(points: &[Point], exponent: i32) -> Option<Vec<Point>> {
    let scale = 2f64.powi(exponent);
    let times = |p: &Point| Point::new(p.x * scale, p.y * scale);
    let is_exact = |p: &Point| times(p).x / scale == p.x && times(p).y / scale == p.y;
    points
        .iter()
        .all(is_exact)
        .then(|| points.iter().map(times).collect())
}

/// Calls `test` for every fixture, and for every file of the shared corpus if it is there, with a
/// generator of its own.
fn for_each_file(mut test: impl FnMut(corpus::Entry, Random)) {
    let mut files = 0;
    let mut test_all = |root: &Path| {
        for entry in corpus::read_all(root) {
            files += 1;
            test(entry, Random(files));
        }
    };
    test_all(Path::new(FIXTURES));
    if let Some(shared) = corpus::root() {
        test_all(&shared);
        assert!(files > 150, "only {files} files with points");
    } else {
        eprintln!("fixtures only: set DELONE_SHARED to the folder that holds the shared data/");
    }
}

#[test]
fn every_file_is_triangulated_whatever_its_order() {
    for_each_file(|mut entry, mut random| {
        let (_, certificate) = verified(&entry.name, &entry.pslg.points);
        random.shuffle(&mut entry.pslg.points);
        let (_, shuffled) = verified(&entry.name, &entry.pslg.points);
        assert_eq!(shuffled, certificate, "{} shuffled", entry.name);
    });
}

#[test]
fn every_file_is_triangulated_when_rotated() {
    for_each_file(|mut entry, mut random| {
        random.rotate(&mut entry.pslg.points);
        if entry.pslg.points.iter().all(Point::is_finite) {
            verified(&format!("{} rotated", entry.name), &entry.pslg.points);
        }
    });
}

#[test]
fn every_file_keeps_its_triangles_when_scaled() {
    let mut extremes = 0;
    for_each_file(|entry, _| {
        let few = entry.pslg.points.len() <= FEW;
        let exponents: &[i32] = if few {
            &[-40, 30, -900, 700]
        } else {
            &[-40, 30]
        };
        let original = triangulate(entry.pslg.points.iter().copied()).expect("finite points");
        for &exponent in exponents {
            let name = format!("{} times 2^{exponent}", entry.name);
            if let Some(points) = scaled(&entry.pslg.points, exponent) {
                extremes += usize::from(exponent.abs() > 40);
                let (t, _) = verified(&name, &points);
                assert_eq!(sorted_triangles(&t), sorted_triangles(&original), "{name}");
            }
        }
    });
    assert!(
        corpus::root().is_none() || extremes > 200,
        "only {extremes} extreme scalings"
    );
}

fn golden_line(entry: &corpus::Entry) -> String {
    let (_, c) = verified(&entry.name, &entry.pslg.points);
    let counts = [c.vertices, c.duplicates, c.triangles, c.hull_edges];
    let [vertices, duplicates, triangles, hull_edges] = counts;
    let name = &entry.name;
    format!(
        "{name} {vertices} {duplicates} {triangles} {hull_edges} {}\n",
        c.hash
    )
}

/// Run with `DELONE_BLESS=1` to write the file anew, and read the difference.
#[test]
fn fixtures_have_their_golden_hashes() {
    let found: String = corpus::read_all(Path::new(FIXTURES))
        .map(|e| golden_line(&e))
        .collect();
    if std::env::var_os("DELONE_BLESS").is_some() {
        fs::write(GOLDEN, &found).expect("a writable golden file");
    }
    let expected = fs::read_to_string(GOLDEN).expect("the golden file");
    assert_eq!(found, expected);
}

// Inputs on which other systems broke, by name.

fn nasty(file: &str) -> (Triangulation, Certificate) {
    let name = format!("nasty/{file}");
    let entry = corpus::read(Path::new(FIXTURES), &name).expect("a file with points");
    verified(&name, &entry.pslg.points)
}

/// Expects numbers of vertices, duplicates, triangles and hull edges.
fn assert_nasty(file: &str, expected: [usize; 4]) {
    let (_, c) = nasty(file);
    let found = [c.vertices, c.duplicates, c.triangles, c.hull_edges];
    assert_eq!(
        found, expected,
        "{file}: vertices, duplicates, triangles, hull edges"
    );
}

#[test]
fn delaunator_rs_8_reports_the_duplicate() {
    let (t, certificate) = nasty("delaunator-rs-8-oob.node");
    assert_eq!((certificate.points, certificate.vertices), (14, 13));
    let expected = Duplicate {
        dropped: 13.into(),
        kept: 0.into(),
    };
    assert_eq!(t.duplicates(), [expected]);
}

#[test]
fn cdt_174_gives_exactly_one_triangle() {
    assert_nasty("cdt-174-tiny-bbox.node", [3, 0, 1, 3]);
}

#[test]
fn cdt_154a_gives_no_triangle() {
    assert_nasty("cdt-154a-huge.node", [2, 0, 0, 1]);
}

#[test]
fn adaptivepredicates_4_gives_one_triangle() {
    assert_nasty("adaptivepredicates-4-underflow.node", [3, 0, 1, 3]);
}

#[test]
fn robust_48a_takes_the_diagonal_of_the_exact_sign() {
    // The fourth point lies outside the circle of the others, by -8.01e-30 in the determinant.
    let (t, _) = nasty("robust-48a-nearcocircular.node");
    let expected = [[0, 1, 2], [0, 2, 3]].map(|t| t.map(VertexId::from));
    assert_eq!(sorted_triangles(&t), expected);
}

#[test]
fn spade_146_gives_one_triangle() {
    assert_nasty("spade-146-three-points.node", [3, 0, 1, 3]);
}

#[test]
fn spade_53_keeps_the_collinear_hull_vertex() {
    assert_nasty("spade-53-int-overflow.node", [4, 0, 2, 4]);
}

#[test]
fn delaunator_24_keeps_the_collinear_column() {
    let (t, _) = nasty("delaunator-24-collinear-column.node");
    assert_eq!(t.num_vertices(), 10);
}

#[test]
fn delaunator_11_keeps_its_twins() {
    let (t, _) = nasty("delaunator-11-halfedges.node");
    let mesh = t.mesh();
    assert!(
        mesh.half_edges()
            .all(|h| mesh.twin(mesh.twin(h)) == h && mesh.twin(h) != h)
    );
}

#[test]
fn earcut_177_and_129b_merge_where_rings_touch() {
    let duplicates = |file| nasty(file).1.duplicates;
    assert_eq!(duplicates("earcut-177-touching-holes.poly"), 1);
    assert_eq!(duplicates("earcut-129b-touching-holes.poly"), 2);
}
