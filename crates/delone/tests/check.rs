//! The verifier: right triangulations pass, and each way of being wrong is found and named.

use delone::check::{self, Certificate, Defect, Defects, Verdict};
use delone::predicates::{Orientation, in_circle_perturbed, orient2d};
use delone::{Error, Phase, Point, VertexId, Watch};
use std::collections::BTreeSet;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

type Triangle = [u32; 3];

fn verify(points: &[Point], triangles: &[Triangle]) -> Result<Certificate, Defects> {
    let triangles: Vec<_> = triangles.iter().map(|t| t.map(VertexId::from)).collect();
    let verdict = check::verify(points, &triangles, &()).expect("finite points");
    verdict.into_result()
}

fn points(coordinates: &[(f64, f64)]) -> Vec<Point> {
    coordinates.iter().copied().map(Point::from).collect()
}

/// Finds the canonical triangles by their definition: counter-clockwise, nobody in the circle.
fn by_definition(points: &[Point]) -> Vec<Triangle> {
    let n = points.len() as u32;
    let is_first = |v: u32| {
        points[..v as usize]
            .iter()
            .all(|&p| p != points[v as usize])
    };
    let distinct: Vec<u32> = (0..n).filter(|&v| is_first(v)).collect();
    let at = |v: u32| points[v as usize];
    let is_canonical = |&[a, b, c]: &Triangle| {
        orient2d(at(a), at(b), at(c)) == Orientation::Left
            && distinct.iter().all(|&d| {
                [a, b, c].contains(&d) || !in_circle_perturbed(at(a), at(b), at(c), at(d))
            })
    };
    let mut triangles = Vec::new();
    for &a in &distinct {
        for &b in distinct.iter().filter(|&&b| b > a) {
            let third = distinct.iter().filter(|&&c| c > a && c != b);
            triangles.extend(third.map(|&c| [a, b, c]).filter(is_canonical));
        }
    }
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

    fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit as u64) as usize
    }

    fn lattice_point(&mut self, side: usize) -> Point {
        Point::new(self.below(side) as f64, self.below(side) as f64)
    }
}

/// A house with a point inside: five on the hull, six triangles would be one too many.
fn house() -> (Vec<Point>, Vec<Triangle>) {
    let points = points(&[(0., 0.), (4., 0.), (5., 3.), (2., 6.), (-1., 3.), (2., 2.)]);
    let triangles = vec![[0, 1, 5], [1, 2, 5], [2, 3, 5], [3, 4, 5], [4, 0, 5]];
    (points, triangles)
}

/// The canonical triangulation of a square grid: diagonals avoid the upper right corner.
fn grid(side: u32) -> (Vec<Point>, Vec<Triangle>) {
    let ordinates = 0..side;
    let points = ordinates
        .flat_map(|y| (0..side).map(move |x| Point::new(x.into(), y.into())))
        .collect();
    let cells = (0..side - 1).flat_map(|y| (0..side - 1).map(move |x| y * side + x));
    let triangles = cells
        .flat_map(|v| [[v, v + 1, v + side], [v + 1, v + side + 1, v + side]])
        .collect();
    (points, triangles)
}

macro_rules! assert_rejected {
    ($points:expr, $triangles:expr, $($kind:pat),+ $(,)?) => {{
        let defects = verify($points, $triangles).expect_err("a wrong triangulation passed");
        $(assert!(
            defects.listed().iter().any(|d| matches!(d, $kind)),
            "no {} among:\n{defects}", stringify!($kind)
        );)+
        defects
    }};
}

// Right ones.

#[test]
fn accepts_a_house_and_counts_its_parts() {
    let (points, triangles) = house();
    let certificate = verify(&points, &triangles).unwrap();
    assert_eq!((certificate.points, certificate.vertices), (6, 6));
    assert_eq!((certificate.triangles, certificate.edges), (5, 10));
    assert_eq!((certificate.hull_edges, certificate.duplicates), (5, 0));
    let corners = |t: &Triangle| t.map(|v| points[v as usize]);
    let hash = delone::hash_triangles(triangles.iter().map(corners));
    assert_eq!(certificate.hash, hash);
    assert!(certificate.to_string().contains(&hash.to_string()));
}

#[test]
fn accepts_a_grid_with_collinear_hull_vertices() {
    let (points, triangles) = grid(12);
    let certificate = verify(&points, &triangles).unwrap();
    assert_eq!(certificate.hull_edges, 44);
    assert_eq!(certificate.triangles, 242);
}

#[test]
fn accepts_sets_without_triangles_only_on_a_line() {
    let sets: [&[(f64, f64)]; 6] = [
        &[],
        &[(3., 4.)],
        &[(3., 4.), (3., 4.)],
        &[(3., 4.), (1e300, -7.)],
        &[(0., 0.), (0.5, 0.5), (2., 2.), (0.5, 0.5), (-3., -3.)],
        &[(0., 1.), (-0., 1.), (0., 2.)],
    ];
    let expected_vertices = [0, 1, 1, 2, 4, 2];
    for (set, vertices) in sets.iter().zip(expected_vertices) {
        let certificate = verify(&points(set), &[]).unwrap();
        assert_eq!(certificate.vertices, vertices, "{set:?}");
        assert_eq!(certificate.duplicates, set.len() - vertices, "{set:?}");
        assert_eq!(certificate.hull_edges, vertices.saturating_sub(1));
    }
    let (points, _) = house();
    assert_rejected!(&points, &[], Defect::NoTriangles { .. });
}

#[test]
fn accepts_any_one_of_equal_points() {
    let (mut points, mut triangles) = house();
    points.extend([points[5], points[0], points[0]]);
    points[7] = Point::new(-0.0, 0.0);
    let certificate = verify(&points, &triangles).unwrap();
    assert_eq!((certificate.vertices, certificate.duplicates), (6, 3));
    for corner in triangles.as_flattened_mut() {
        *corner = if *corner == 0 { 7 } else { *corner };
    }
    assert_eq!(verify(&points, &triangles), Ok(certificate));
}

#[test]
fn accepts_what_the_definition_yields_under_any_numbering() {
    let mut random = Random(1);
    for round in 0..300 {
        let side = 2 + round % 5;
        let n = 3 + random.below(9);
        let points: Vec<Point> = (0..n).map(|_| random.lattice_point(side)).collect();
        let triangles = by_definition(&points);
        let certificate = verify(&points, &triangles).unwrap_or_else(|d| panic!("{points:?}\n{d}"));

        let shift = random.below(n);
        let moved: Vec<Point> = (0..n).map(|v| points[(v + shift) % n]).collect();
        let renumber = |v: u32| (v as usize + n - shift) as u32 % n as u32;
        let rotated = triangles
            .iter()
            .rev()
            .map(|&[a, b, c]| [c, a, b].map(renumber));
        let same = verify(&moved, &rotated.collect::<Vec<_>>()).unwrap();
        assert_eq!(same, certificate);
    }
}

// Wrong ones, by kind.

#[test]
fn rejects_corners_that_are_no_vertices() {
    let (points, mut triangles) = house();
    triangles[3][1] = 6;
    let defects = assert_rejected!(&points, &triangles, Defect::OutOfRange { .. });
    let text = "triangle 3 names vertex 6, but there are 6 points";
    assert_eq!(defects.to_string(), text);
    triangles[3][1] = u32::MAX;
    assert_rejected!(&points, &triangles, Defect::OutOfRange { .. });
    triangles[3][1] = 3;
    let defects = assert_rejected!(&points, &triangles, Defect::RepeatedCorner { .. });
    assert_eq!(
        defects.to_string(),
        "triangle 3 has vertex 3 (2.0, 6.0) twice"
    );
    for repeated in [[3, 3, 5], [3, 5, 3], [5, 3, 3]] {
        triangles[3] = repeated;
        assert_rejected!(&points, &triangles, Defect::RepeatedCorner { .. });
    }
}

#[test]
fn rejects_a_reversed_triangle() {
    let (points, mut triangles) = house();
    triangles[2].swap(0, 1);
    assert_rejected!(
        &points,
        &triangles,
        Defect::Clockwise { .. },
        Defect::SameSide { .. }
    );
}

#[test]
fn rejects_a_mirrored_triangulation() {
    let (points, triangles) = house();
    let mirrored: Vec<Triangle> = triangles.iter().map(|&[a, b, c]| [b, a, c]).collect();
    let defects = assert_rejected!(
        &points,
        &mirrored,
        Defect::Clockwise { .. },
        Defect::DentedHull { .. }
    );
    // Five triangles, five corners of the hull; circles have no inside here.
    assert_eq!(defects.total(), 10, "{defects}");
}

#[test]
fn rejects_a_flat_triangle() {
    let points = points(&[(0., 0.), (1., 0.), (2., 0.), (1., 5.)]);
    let triangles = [[0, 1, 2], [0, 2, 3]];
    let defects = assert_rejected!(&points, &triangles, Defect::Degenerate { .. });
    let text = "triangle 0 is flat: 0 (0.0, 0.0) – 1 (1.0, 0.0) – 2 (2.0, 0.0) lie on one line";
    assert!(defects.to_string().contains(text), "{defects}");
}

#[test]
fn rejects_a_flipped_edge() {
    let points = points(&[(0., 0.), (4., 0.), (5., 4.), (0., 3.)]);
    verify(&points, &[[0, 1, 3], [1, 2, 3]]).unwrap();
    let flipped = [[0, 1, 2], [0, 2, 3]];
    let defects = assert_rejected!(&points, &flipped, Defect::NotLocallyDelaunay { .. });
    assert_eq!(
        defects.to_string(),
        "edge 2 (5.0, 4.0) – 0 (0.0, 0.0) between triangles 0 and 1 is not locally Delaunay: \
         the circle through it and 1 (4.0, 0.0) contains 3 (0.0, 3.0)"
    );
}

#[test]
fn rejects_the_other_diagonal_of_a_square() {
    let (points, _) = grid(2);
    let other = [[0, 1, 3], [0, 3, 2]];
    let defects = assert_rejected!(&points, &other, Defect::NotLocallyDelaunay { .. });
    assert_eq!(defects.total(), 1);
}

#[test]
fn rejects_a_missing_triangle() {
    let (points, triangles) = grid(4);
    let inner = 8;
    let hole = [&triangles[..inner], &triangles[inner + 1..]].concat();
    assert_rejected!(
        &points,
        &hole,
        Defect::BoundaryCycles { cycles: 2 },
        Defect::DentedHull { .. }
    );
    // An ear: what is left is convex, but its tip is gone.
    let defects = assert_rejected!(&points, &triangles[1..], Defect::MissingPoint { .. });
    assert_eq!(
        defects.to_string(),
        "point 0 (0.0, 0.0) is missing: no triangle has it or a duplicate of it as a corner"
    );
    // A notch in a straight side.
    let notch = [&triangles[..2], &triangles[3..]].concat();
    assert_rejected!(&points, &notch, Defect::DentedHull { .. });
}

#[test]
fn rejects_a_hole_where_a_vertex_was() {
    let (points, triangles) = grid(4);
    let around: Vec<Triangle> = triangles
        .iter()
        .copied()
        .filter(|t| !t.contains(&5))
        .collect();
    assert_rejected!(
        &points,
        &around,
        Defect::MissingPoint { .. },
        Defect::BoundaryCycles { cycles: 2 }
    );
}

#[test]
fn rejects_a_skipped_vertex_on_the_hull() {
    // The middle of the lower side lies on an edge that ignores it.
    let points = points(&[(0., 0.), (1., 0.), (2., 0.), (1., 3.)]);
    let defects = assert_rejected!(&points, &[[0, 2, 3]], Defect::MissingPoint { .. });
    assert_eq!(defects.total(), 1);
}

#[test]
fn rejects_a_hanging_vertex() {
    // The middle of the inner edge is a corner on one side only.
    let points = points(&[(0., 0.), (2., 0.), (1., 3.), (1., -3.), (1., 0.)]);
    let hanging = [[0, 1, 2], [0, 3, 4], [3, 1, 4]];
    // Both parts are convex: only that there are two of them gives it away.
    assert_rejected!(&points, &hanging, Defect::BoundaryCycles { cycles: 2 });
    verify(&points, &[[0, 4, 2], [4, 1, 2], [0, 3, 4], [3, 1, 4]]).unwrap();
}

#[test]
fn rejects_a_repeated_triangle() {
    let (points, mut triangles) = house();
    triangles.push(triangles[0]);
    assert_rejected!(
        &points,
        &triangles,
        Defect::SameSide { .. },
        Defect::CrowdedEdge { count: 3, .. }
    );
}

#[test]
fn rejects_two_sheets_on_the_same_vertices() {
    let (points, triangles) = house();
    let twice = [&triangles[..], &triangles[..]].concat();
    let defects = assert_rejected!(&points, &twice, Defect::CrowdedEdge { count: 4, .. });
    // One for each edge, and none about a boundary that is not there.
    assert_eq!(defects.total(), 10, "{defects}");
}

#[test]
fn rejects_two_sheets_on_equal_points() {
    let (points, triangles) = house();
    let copy = triangles.iter().map(|t| t.map(|v| v + 6));
    let sheets: Vec<Triangle> = triangles.iter().copied().chain(copy).collect();
    let defects = assert_rejected!(
        &[&points[..], &points[..]].concat(),
        &sheets,
        Defect::BoundaryCycles { cycles: 2 },
        Defect::SharedPosition { .. }
    );
    let text = "0 (0.0, 0.0) and 6 (0.0, 0.0) are equal, but both are corners";
    assert!(defects.to_string().contains(text), "{defects}");
}

#[test]
fn rejects_a_convex_boundary_that_goes_round_twice() {
    // Every triangle is counter-clockwise, every edge has its triangles, the boundary is one cycle
    // and turns left everywhere: only the number of turns gives it away.
    let coordinates = [
        (0., 0.),
        (2., 0.),
        (-1., 2.),
        (-1., -2.),
        (4., 0.),
        (-2., 4.),
        (-2., -4.),
    ];
    let winding: Vec<Triangle> = (0..6).map(|k| [0, 1 + k, 1 + (k + 1) % 6]).collect();
    let defects = assert_rejected!(
        &points(&coordinates),
        &winding,
        Defect::WindingBoundary { turns: 2 }
    );
    let is_dented = |d: &Defect| matches!(d, Defect::DentedHull { .. });
    assert!(!defects.listed().iter().any(is_dented), "{defects}");
}

#[test]
fn rejects_a_slit() {
    // Corner 0 has a copy, so the boundary runs in along the diagonal, turns back and runs out.
    let points = points(&[(0., 0.), (4., 0.), (4., 4.), (0., 4.), (2., 2.), (0., 0.)]);
    let slit = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 5, 4]];
    let defects = assert_rejected!(
        &points,
        &slit,
        Defect::DentedHull { .. },
        Defect::SharedPosition { .. }
    );
    let text = "the boundary is not convex at 4 (2.0, 2.0)";
    assert!(defects.to_string().contains(text), "{defects}");
}

#[test]
fn rejects_parts_that_touch_in_a_vertex() {
    let points = points(&[(0., 0.), (2., -1.), (2., 1.), (-2., 1.), (-2., -1.)]);
    let bow_tie = [[0, 1, 2], [0, 3, 4]];
    let defects = assert_rejected!(
        &points,
        &bow_tie,
        Defect::BoundaryCycles { cycles: 2 },
        Defect::SplitStar { .. }
    );
    let text = "vertex 0 (0.0, 0.0) has 2 triangles, but only 1 hang together around it";
    assert!(defects.to_string().contains(text), "{defects}");
}

#[test]
fn rejects_mixed_use_of_equal_points() {
    let (mut points, mut triangles) = house();
    points.push(points[5]);
    triangles[2][2] = 6;
    assert_rejected!(&points, &triangles, Defect::SharedPosition { .. });
}

#[test]
fn rejects_a_moved_point() {
    let (mut points, triangles) = house();
    points[5] = Point::new(2.0, 5.9);
    assert_rejected!(&points, &triangles, Defect::NotLocallyDelaunay { .. });
    points[5] = Point::new(2.0, 6.5);
    assert_rejected!(&points, &triangles, Defect::Clockwise { .. });
}

#[test]
fn rejects_a_point_moved_by_the_smallest_step() {
    let (mut points, triangles) = grid(3);
    let centre = &mut points[4].x;
    *centre = centre.next_up();
    assert_rejected!(&points, &triangles, Defect::NotLocallyDelaunay { .. });
}

#[test]
fn rejects_swapped_vertices() {
    let (mut points, triangles) = grid(4);
    points.swap(5, 10);
    assert_rejected!(&points, &triangles, Defect::Clockwise { .. });
}

#[test]
fn counts_all_defects_but_lists_few() {
    let (points, triangles) = grid(20);
    let reversed: Vec<Triangle> = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let defects = verify(&points, &reversed).unwrap_err();
    assert!(defects.total() >= reversed.len());
    assert!(
        defects.listed().len() <= 3 * Defects::LISTED_PER_KIND,
        "{defects}"
    );
    let more = format!("and {} more", defects.total() - defects.listed().len());
    assert!(defects.to_string().ends_with(&more));
}

// Wrong ones, at random: the triangulation is unique, so a set passes exactly if it is the right set.

#[test]
fn accepts_exactly_the_canonical_set() {
    let mut random = Random(7);
    let (mut right, mut wrong) = (0, 0);
    for round in 0..4000 {
        let side = 3 + round % 4;
        let n = 4 + random.below(6);
        let mut points: Vec<Point> = (0..n).map(|_| random.lattice_point(side)).collect();
        let mut triangles = by_definition(&points);
        if triangles.is_empty() {
            continue;
        }
        for _ in 0..=random.below(2) {
            mutate(&mut points, &mut triangles, &mut random);
        }
        let is_right = as_set(&points, &triangles) == as_set(&points, &by_definition(&points))
            && uses_each_place_once(&points, &triangles);
        let verdict = verify(&points, &triangles);
        assert_eq!(
            verdict.is_ok(),
            is_right,
            "{points:?}\n{triangles:?}\n{verdict:?}"
        );
        *(if is_right { &mut right } else { &mut wrong }) += 1;
    }
    assert!(right > 100 && wrong > 1000, "{right} right, {wrong} wrong");
}

#[test]
fn finds_a_single_mistake_among_many_triangles() {
    let mut random = Random(3);
    let points: Vec<Point> = (0..3000).map(|_| random.lattice_point(1000)).collect();
    let t = delone::triangulate(points.iter().copied()).unwrap();
    let right: Vec<Triangle> = t.triangles().iter().map(|t| t.map(VertexId::raw)).collect();
    for _ in 0..100 {
        let mut triangles = right.clone();
        let t = random.below(triangles.len());
        match random.below(3) {
            0 => drop(triangles.swap_remove(t)),
            1 => triangles[t][random.below(3)] = random.below(points.len()) as u32,
            _ => flip(&mut triangles, t, random.below(3)),
        }
        let is_same = triangles == right;
        assert_eq!(verify(&points, &triangles).is_ok(), is_same, "triangle {t}");
    }
}

fn mutate(points: &mut [Point], triangles: &mut Vec<Triangle>, random: &mut Random) {
    if triangles.is_empty() {
        return;
    }
    let t = random.below(triangles.len());
    let v = random.below(points.len());
    match random.below(8) {
        0 => drop(triangles.swap_remove(t)),
        1 => triangles[t].swap(0, 1),
        2 => triangles[t].rotate_left(1),
        3 => triangles.push(triangles[t]),
        4 => triangles[t][random.below(3)] = v as u32,
        5 => points[v] = random.lattice_point(5),
        6 => points.swap(v, 0),
        _ => flip(triangles, t, random.below(3)),
    }
}

/// Replaces the edge opposite a corner of `t` by the other diagonal, if it has a triangle beyond.
fn flip(triangles: &mut [Triangle], t: usize, corner: usize) {
    let mut turned = triangles[t];
    turned.rotate_left(corner);
    let [c, a, b] = turned;
    let beyond = triangles
        .iter()
        .position(|u| (0..3).any(|k| [u[k], u[(k + 1) % 3]] == [b, a]));
    if let Some(u) = beyond {
        let d = *triangles[u]
            .iter()
            .find(|&&v| v != a && v != b)
            .unwrap_or(&a);
        triangles[t] = [c, a, d];
        triangles[u] = [d, b, c];
    }
}

/// The triangles as sorted corners' coordinates; empty for a set that holds one twice.
fn as_set(points: &[Point], triangles: &[Triangle]) -> BTreeSet<Vec<(i64, i64)>> {
    let corner = |v: u32| points[v as usize];
    let canonical = |t: &Triangle| {
        let smallest = (0..3).min_by(|&i, &j| corner(t[i]).lex_cmp(&corner(t[j])));
        let mut turned = *t;
        turned.rotate_left(smallest.unwrap());
        let whole = |v| (corner(v).x as i64, corner(v).y as i64);
        turned.map(whole).to_vec()
    };
    let set: BTreeSet<_> = triangles.iter().map(canonical).collect();
    if set.len() == triangles.len() {
        set
    } else {
        BTreeSet::new()
    }
}

fn uses_each_place_once(points: &[Point], triangles: &[Triangle]) -> bool {
    let used: BTreeSet<u32> = triangles.as_flattened().iter().copied().collect();
    let place = |v: &u32| (points[*v as usize].x as i64, points[*v as usize].y as i64);
    let places: BTreeSet<_> = used.iter().map(place).collect();
    places.len() == used.len()
}

// Input and watch.

#[test]
fn refuses_points_that_are_not_finite() {
    let points = points(&[(0., 0.), (f64::NAN, 1.)]);
    let refused = check::verify(&points, &[], &());
    assert!(matches!(refused, Err(Error::NotFinite { index: 1, .. })));
}

#[derive(Default)]
struct Recorder {
    reports: Mutex<Vec<(u64, u64)>>,
    cancels_after: Option<u64>,
    asked: AtomicU64,
}

impl Watch for Recorder {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        assert_eq!(phase, Phase::Check);
        self.reports.lock().unwrap().push((done, total));
    }

    fn is_cancelled(&self) -> bool {
        let asked = self.asked.fetch_add(1, Ordering::Relaxed);
        self.cancels_after.is_some_and(|limit| asked >= limit)
    }
}

fn verify_watched(watch: &Recorder) -> Result<Verdict, Error> {
    let (points, triangles) = grid(60);
    let triangles: Vec<_> = triangles.iter().map(|t| t.map(VertexId::from)).collect();
    check::verify(&points, &triangles, watch)
}

#[test]
fn reports_progress_up_to_the_end() {
    let watch = Recorder::default();
    assert!(matches!(verify_watched(&watch), Ok(Verdict::Right(_))));
    let reports = watch.reports.into_inner().unwrap();
    assert!(reports.len() > 20 && reports.is_sorted());
    assert!(reports.iter().all(|&(done, total)| done <= total));
    let (done, total) = *reports.last().unwrap();
    assert_eq!(done, total);
    let (almost, _) = reports[reports.len() - 2];
    assert!(almost as f64 > 0.9 * total as f64, "{almost} of {total}");
}

#[test]
fn stops_when_cancelled() {
    for limit in [0, 5, 20] {
        let watch = Recorder {
            cancels_after: Some(limit),
            ..Recorder::default()
        };
        assert_eq!(verify_watched(&watch), Err(Error::Cancelled));
        assert_eq!(watch.asked.into_inner(), limit + 1);
    }
}

// Quality.

#[test]
fn measures_a_right_isosceles_triangle() {
    for scale in [1.0, 2f64.powi(-1000), 2f64.powi(1000), 5e-324 * 64.0] {
        let corners = [(0., 0.), (scale, 0.), (0., scale)].map(Point::from);
        let shape = check::Shape::of(corners);
        let close = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-2;
        assert!(
            close(shape.angles[0], 90.0) && close(shape.angles[1], 45.0),
            "{shape:?}"
        );
        assert!(close(shape.edges[0], scale * 2f64.sqrt()), "{shape:?}");
        assert!(close(shape.aspect, 2.0), "{shape:?}");
        assert_eq!(shape.area, 0.5 * scale * scale);
    }
}

#[test]
fn sums_up_a_grid() {
    let (points, triangles) = grid(5);
    let triangles: Vec<_> = triangles.iter().map(|t| t.map(VertexId::from)).collect();
    let quality = check::statistics(&points, &triangles);
    assert_eq!((quality.triangles, quality.area), (32, 16.0));
    assert!((quality.min_angle - 45.0).abs() < 1e-9);
    assert!((quality.max_angle - 90.0).abs() < 1e-9);
    assert!((quality.mean_min_angle - 45.0).abs() < 1e-9);
    assert_eq!(
        (quality.shortest_edge, quality.longest_edge),
        (1.0, 2f64.sqrt())
    );
    assert_eq!(quality.min_angles[44] + quality.min_angles[45], 32);
    let equilateral = [(0., 0.), (1., 0.), (0.5, 0.75f64.sqrt())].map(Point::from);
    let quality = check::statistics(&equilateral, &[[0, 1, 2].map(VertexId::from)]);
    assert_eq!(quality.min_angles[59], 1);
    assert!((quality.worst_aspect - 2.0 / 3f64.sqrt()).abs() < 1e-9);
}

#[test]
fn sums_up_nothing() {
    let quality = check::statistics(&[], &[]);
    assert_eq!((quality.triangles, quality.mean_min_angle), (0, 0.0));
}
