//! The verifier of domains: right triangulations pass, and each way of being wrong is found and
//! named.

use delone::check::{self, Certificate, Defect, Defects, DomainMesh, DomainNumbers};
use delone::{DomainRule, Error, Phase, Point, Pslg, Seed, VertexId, Watch};
use delone_testkit::generate::{Kind, Random};
use delone_testkit::naive::{naive_constrained, naive_domain, naive_noding};
use std::sync::atomic::{AtomicU64, Ordering};

const RULES: [DomainRule; 3] = [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd];

/// An input, and a mesh that is claimed to be its triangulation.
#[derive(Clone, Debug)]
struct Claim {
    input: Pslg,
    rule: DomainRule,
    points: Vec<Point>,
    triangles: Vec<[VertexId; 3]>,
    subsegments: Vec<[VertexId; 2]>,
    chains: Vec<Vec<VertexId>>,
}

impl Claim {
    /// Makes the right claim by the definitions, or none if a seed lies on a segment.
    fn right(input: &Pslg, rule: DomainRule) -> Option<Self> {
        let noding = naive_noding(&input.points, &input.segments);
        let mut subsegments = noding.edges();
        subsegments.iter_mut().for_each(|ends| ends.sort_unstable());
        subsegments.sort_unstable();
        subsegments.dedup();
        let triangles = naive_constrained(&noding.points, &subsegments);
        let domain = naive_domain(input, &noding, &triangles, rule).ok()?;
        Some(Self {
            input: input.clone(),
            rule,
            points: noding.points,
            triangles: domain.triangles,
            subsegments,
            chains: noding.chains,
        })
    }

    fn verify(&self) -> Result<Certificate, Defects> {
        let mesh = DomainMesh::new(&self.points, &self.triangles, &self.subsegments);
        let verdict = check::verify_domain(&self.input, self.rule, &mesh, &());
        verdict.expect("a proper input").into_result()
    }

    fn verify_chains(&self) -> Result<Certificate, Defects> {
        let chains = |segment: usize| &self.chains[segment][..];
        let mesh = DomainMesh::new(&self.points, &self.triangles, &self.subsegments);
        let mesh = mesh.with_chains(&chains);
        let verdict = check::verify_domain(&self.input, self.rule, &mesh, &());
        verdict.expect("a proper input").into_result()
    }

    fn numbers(&self) -> DomainNumbers {
        let certificate = self.verify().unwrap_or_else(|d| panic!("{d}\n{self:?}"));
        assert_eq!(self.verify_chains(), Ok(certificate));
        certificate.domain.expect("numbers of the domain")
    }

    fn error(&self) -> Error {
        let mesh = DomainMesh::new(&self.points, &self.triangles, &self.subsegments);
        let verdict = check::verify_domain(&self.input, self.rule, &mesh, &());
        verdict.expect_err("an improper input")
    }
}

macro_rules! assert_rejected {
    ($claim:expr, $($kind:pat),+ $(,)?) => {
        assert_defects!($claim.verify(), $($kind),+)
    };
}

macro_rules! assert_defects {
    ($verdict:expr, $($kind:pat),+ $(,)?) => {{
        let defects = $verdict.expect_err("a wrong triangulation passed");
        $(assert!(
            defects.listed().iter().any(|d| matches!(d, $kind)),
            "no {} among:\n{defects}", stringify!($kind)
        );)+
        defects
    }};
}

fn point(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

/// Adds a square ring around a centre.
fn add_square(input: &mut Pslg, [x, y]: [f64; 2], half: f64) {
    let first = input.points.len() as u32;
    let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
    let corners = corners.map(|(dx, dy)| point(x + dx, y + dy));
    input.points.extend(corners);
    input.add_ring(first..first + 4);
}

/// Rings in rings: a lake, an island in it, a pond on the island; and loose points all around.
fn lake() -> Pslg {
    let mut input = Pslg::default();
    for half in [8.0, 5.0, 2.0] {
        add_square(&mut input, [0.0, 0.0], half);
    }
    let loose = [
        (7.0, 0.5),
        (4.0, 0.5),
        (1.0, 0.5),
        (9.0, 11.0),
        (-7.0, -6.0),
    ];
    input.points.extend(loose.map(Point::from));
    input
}

/// Two segments that cross in a rounded point, in a square.
fn crossed() -> Pslg {
    let mut input = Pslg::default();
    add_square(&mut input, [0.5, 0.5], 2.0);
    let ends = [(0.0, 0.0), (1.0, 1.0), (0.1, 0.7), (0.9, 0.2)];
    input.points.extend(ends.map(Point::from));
    input.add_segment(4, 5);
    input.add_segment(6, 7);
    input
}

fn right(input: &Pslg, rule: DomainRule) -> Claim {
    Claim::right(input, rule).expect("no seed on a segment")
}

// Right ones.

#[test]
fn accepts_rings_in_rings_under_every_rule() {
    let counts = |rule| {
        let numbers = right(&lake(), rule).numbers();
        [numbers.components, numbers.holes, numbers.carved]
    };
    assert_eq!(counts(DomainRule::Hull), [1, 0, 0]);
    assert_eq!(counts(DomainRule::Carve), [1, 0, 1]);
    assert_eq!(counts(DomainRule::EvenOdd), [2, 1, 2]);
}

#[test]
fn accepts_crossings_and_names_what_it_proves() {
    let claim = right(&crossed(), DomainRule::Hull);
    let numbers = claim.numbers();
    assert_eq!((numbers.added, numbers.subsegments), (1, 8));
    let text = claim.verify().expect("right").to_string();
    assert!(text.starts_with("the canonical constrained Delaunay triangulation "));
    assert!(
        text.ends_with("8 subsegments, 1 added vertices, 1 components, 0 holes, 0 points outside")
    );
}

#[test]
fn accepts_what_has_no_triangles_only_where_nothing_is() {
    let open = || {
        let mut input = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (1.0, 3.0)]);
        input.add_polyline([0u32, 1, 2]);
        input
    };
    let line = || {
        let mut input = Pslg::from_points([(0.0, 0.0), (2.0, 2.0), (1.0, 1.0)]);
        input.add_segment(0, 1);
        input
    };
    for rule in RULES {
        right(&Pslg::default(), rule).numbers();
        right(&line(), rule).numbers();
        let mut claim = right(&open(), rule);
        claim.numbers();
        claim.triangles.clear();
        match rule {
            DomainRule::Hull => drop(assert_rejected!(claim, Defect::Uncovered { .. })),
            _ => assert_eq!(claim.numbers().components, 0),
        }
    }
    let mut claim = right(&lake(), DomainRule::Carve);
    claim.triangles.clear();
    assert_rejected!(claim, Defect::Uncovered { .. }, Defect::MissingPoint { .. });
}

#[test]
fn accepts_any_one_of_equal_points() {
    let mut input = lake();
    let copies = [input.points[0], input.points[13]];
    input.points.extend(copies);
    input.add_segment(17, 1);
    input.add_segment(18, 13);
    let mut claim = right(&input, DomainRule::Carve);
    let certificate = claim.verify().expect("right");
    assert_eq!(
        (
            certificate.points,
            certificate.vertices,
            certificate.duplicates
        ),
        (19, 17, 2)
    );
    for corner in claim.triangles.as_flattened_mut() {
        *corner = if corner.index() == 0 {
            17.into()
        } else {
            *corner
        };
    }
    assert_eq!(claim.verify(), Ok(certificate));
    // But not both.
    let corner = claim.triangles.as_flattened_mut();
    *corner
        .iter_mut()
        .find(|v| v.index() == 17)
        .expect("a corner") = 0.into();
    assert_rejected!(claim, Defect::SharedPosition { .. });
}

/// A random input: points with segments of all kinds, sometimes polygons and holes.
fn random_input(random: &mut Random) -> Pslg {
    let kind = random.choose(&[
        Kind::Lattice { side: 3 },
        Kind::Lattice { side: 5 },
        Kind::Uniform,
    ]);
    let n = 4 + random.below(5);
    let mut input = Pslg::from_points(kind.points(n, random.bits()));
    let vertex = |random: &mut Random| random.below(n) as u32;
    if random.below(3) == 0 {
        for _ in 0..1 + random.below(2) {
            let first = input.segments.len();
            let ring: Vec<_> = (0..3 + random.below(2)).map(|_| vertex(random)).collect();
            input.add_ring(ring);
            input.polygons.push(first..input.segments.len());
        }
    }
    for _ in 0..random.below(6) {
        input.add_segment(vertex(random), vertex(random));
    }
    let scale = if kind == Kind::Uniform { 1.0 } else { 4.0 };
    for _ in 0..random.below(3) {
        let at = point(random.unit() * scale, random.unit() * scale);
        input.holes.push(at);
    }
    input
}

#[test]
fn accepts_what_the_definitions_yield() {
    let mut random = Random::new(1);
    let mut added = 0;
    for _ in 0..400 {
        let input = random_input(&mut random);
        for rule in RULES {
            if let Some(claim) = Claim::right(&input, rule) {
                added += claim.numbers().added;
            }
        }
    }
    assert!(added > 100, "only {added} crossings");
}

// Wrong ones, at random.

/// Changes one thing; `None` if there is nothing of the kind to change.
fn mutate(claim: &Claim, random: &mut Random, kind: usize) -> Option<Claim> {
    let mut wrong = claim.clone();
    let triangle =
        (!claim.triangles.is_empty()).then(|| random.below(claim.triangles.len().max(1)));
    let n = claim.points.len();
    match kind {
        0 => drop(wrong.triangles.remove(triangle?)),
        1 => wrong.triangles.push(wrong.triangles[triangle?]),
        2 => flip(&mut wrong, triangle?)?,
        3 => {
            let edge = random.below(claim.subsegments.len().max(1));
            wrong.subsegments.get(edge)?;
            wrong.subsegments.remove(edge);
        }
        4 => {
            let mut ends = [0; 2].map(|_| VertexId::new(random.below(n)));
            ends.sort_unstable();
            let [a, b] = ends.map(|v| claim.points[v.index()]);
            let is_known = |e: &[VertexId; 2]| e.map(|v| claim.points[v.index()]) == [a, b];
            let reversed = claim.subsegments.iter().any(|&[v, w]| is_known(&[w, v]));
            if reversed || claim.subsegments.iter().any(is_known) {
                return None;
            }
            wrong.subsegments.push(ends);
        }
        5 => {
            let v = random.below(n);
            wrong.points[v].x += 0.5;
        }
        6 => wrong.triangles[triangle?].swap(0, 1),
        _ => {
            wrong.points.push(point(0.3, 0.4));
        }
    }
    Some(wrong)
}

/// Replaces the edge opposite some corner of a triangle by the other diagonal.
fn flip(claim: &mut Claim, t: usize) -> Option<()> {
    let [a, b, c] = claim.triangles[t];
    let turned = |[a, b, c]: [VertexId; 3]| [[a, b, c], [b, c, a], [c, a, b]];
    let across = |other: &[VertexId; 3]| {
        let apex = turned(*other).into_iter().find(|r| r[..2] == [c, b]);
        apex.map(|r| r[2])
    };
    let (u, d) = claim
        .triangles
        .iter()
        .enumerate()
        .find_map(|(u, o)| Some((u, across(o)?)))?;
    claim.triangles[t] = [a, b, d];
    claim.triangles[u] = [a, d, c];
    Some(())
}

#[test]
fn rejects_every_mutation() {
    let mut random = Random::new(2);
    let mut rejected = [0; 8];
    for _ in 0..150 {
        let input = random_input(&mut random);
        for rule in RULES {
            let Some(claim) = Claim::right(&input, rule) else {
                continue;
            };
            for kind in 0..8 {
                if let Some(wrong) = mutate(&claim, &mut random, kind) {
                    assert!(wrong.verify().is_err(), "{kind}: {claim:?}\n{wrong:?}");
                    rejected[kind] += 1;
                }
            }
        }
    }
    assert!(rejected.iter().all(|&count| count > 50), "{rejected:?}");
}

// Where rounding matters.

/// Points on a lattice of a few units in the last place, far from the origin: rounding moves every
/// crossing by as much as segments are apart.
fn hostile_input(random: &mut Random) -> Pslg {
    let origin = random.choose(&[
        [500_000.25, 4_500_000.5],
        [1.0, 1.0],
        [-3.0, 1e300],
        [0.0, 4.0],
    ]);
    let side = 3 + random.below(14);
    let mut coordinate = |c: f64| {
        let steps = random.below(side);
        (0..steps).fold(c, |c, _| c.next_up())
    };
    let points: Vec<_> = (0..8)
        .map(|_| Point::from(origin.map(&mut coordinate)))
        .collect();
    let mut input = Pslg::from_points(points);
    for _ in 0..6 {
        input.add_segment(random.below(8) as u32, random.below(8) as u32);
    }
    input
}

#[test]
fn accepts_crossings_within_a_few_units_in_the_last_place() {
    let mut random = Random::new(3);
    let mut added = 0;
    for _ in 0..1000 {
        let input = hostile_input(&mut random);
        for rule in RULES {
            let claim = right(&input, rule);
            let verdict = claim.verify_chains();
            let certificate = verdict.unwrap_or_else(|d| panic!("{d}\n{claim:?}"));
            added += certificate.domain.expect("numbers").added;
            // Which chain was meant matters only to parity.
            if rule != DomainRule::EvenOdd {
                assert_eq!(claim.verify(), Ok(certificate), "{claim:?}");
            }
        }
    }
    assert!(added > 1000, "only {added} crossings");
}
