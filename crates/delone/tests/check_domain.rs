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

// Wrong ones, by kind.

/// The claim that is right for another rule, or for another input with the same points.
fn misread(claim: Claim, change: impl FnOnce(&mut Claim)) -> Claim {
    let mut wrong = claim;
    change(&mut wrong);
    wrong
}

#[test]
fn rejects_points_that_are_not_those_of_the_input() {
    let claim = right(&lake(), DomainRule::Carve);
    let moved = misread(claim.clone(), |c| c.points[14].x += 0.25);
    let defects = assert_rejected!(moved, Defect::MovedPoint { .. });
    let text = "point 14 (1.25, 0.5) lies at (1.0, 0.5) in the input";
    assert_eq!(defects.to_string(), text);
    let short = misread(claim.clone(), |c| {
        c.points.pop();
    });
    assert_rejected!(
        short,
        Defect::TooFewPoints {
            given: 16,
            expected: 17
        }
    );
    let shifted = misread(claim, |c| c.points.rotate_left(1));
    assert_rejected!(shifted, Defect::MovedPoint { .. });
}

#[test]
fn rejects_added_vertices_without_reason() {
    let claim = right(&lake(), DomainRule::Carve);
    let again = misread(claim.clone(), |c| c.points.push(c.points[3]));
    assert_rejected!(again, Defect::NotNew { .. });
    // The mesh is right but for the question who asked for the vertex.
    let loose = misread(claim, |c| {
        c.input.points.pop();
    });
    let defects = assert_rejected!(loose, Defect::NeedlessVertex { .. });
    assert_eq!(defects.total(), 1, "{defects}");
    // One in the middle of a segment, and of a second one on the same line.
    let mut input = lake();
    input.points.push(point(0.0, 8.0));
    input.segments.extend([[3, 2].map(VertexId::new)]);
    let mut steiner = right(&input, DomainRule::Carve);
    steiner.numbers();
    steiner.input.points.pop();
    assert_rejected!(steiner, Defect::NeedlessVertex { .. });
    assert_defects!(steiner.verify_chains(), Defect::NeedlessVertex { .. });
}

#[test]
fn rejects_subsegments_that_are_none() {
    let claim = right(&lake(), DomainRule::Carve);
    let with = |ends: [u32; 2]| {
        let ends = ends.map(VertexId::from);
        misread(claim.clone(), |c| c.subsegments.push(ends))
    };
    assert_rejected!(with([0, 99]), Defect::SubsegmentOutOfRange { .. });
    assert_rejected!(with([5, 5]), Defect::EmptySubsegment { .. });
    assert_rejected!(with([1, 0]), Defect::RepeatedSubsegment { .. });
    assert_rejected!(with([0, 9]), Defect::CrossingSubsegments { .. });
    assert_rejected!(with([4, 6]), Defect::VertexOnSubsegment { .. });
    let defects = assert_rejected!(with([0, 4]), Defect::StraySubsegment { .. });
    let text = "subsegment 0 (-8.0, -8.0) – 4 (-5.0, -5.0) is part of no segment";
    assert_eq!(defects.to_string(), text);
    let less = misread(claim.clone(), |c| {
        c.subsegments.pop();
    });
    let defects = assert_rejected!(less, Defect::BrokenChain { .. });
    assert!(defects.to_string().contains("it ends at"), "{defects}");
}

#[test]
fn rejects_crossings_that_are_not_split() {
    let right = right(&crossed(), DomainRule::Hull);
    let mut claim = right.clone();
    claim.points.pop();
    claim.triangles = naive_constrained(&claim.points, &claim.input.segments[..5]);
    claim.subsegments = claim.input.segments.clone();
    assert_rejected!(claim, Defect::CrossingSubsegments { .. });
    // Overlaps from a common end on, to the right and to the left.
    for (a, b) in [([0, 1], [0, 2]), ([1, 2], [0, 2])] {
        let mut input = Pslg::from_points([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]);
        input.segments = [a, b].map(|ends| ends.map(VertexId::new)).to_vec();
        let mut claim = self::right(&input, DomainRule::Hull);
        claim.numbers();
        claim.subsegments = input.segments.clone();
        assert!(claim.verify().is_err());
    }
}

#[test]
fn rejects_segments_that_are_bent() {
    // The middle point lies two units in the last place off the segment.
    let middle = point(1.0, 1.0 + 2.0 * f64::EPSILON);
    let mut input = Pslg::from_points([(0.0, 0.0), (2.0, 2.0), (0.0, 3.0)].map(Point::from));
    input.points.push(middle);
    input.add_polyline([0u32, 3, 1]);
    let mut claim = right(&input, DomainRule::Hull);
    claim.numbers();
    claim.input.segments = vec![[0, 1].map(VertexId::new)];
    claim.chains = vec![[0, 3, 1].map(VertexId::new).to_vec()];
    let defects = assert_rejected!(claim, Defect::BentChain { .. });
    assert_eq!(
        defects.to_string(),
        "segment 0, 0 (0.0, 0.0) – 1 (2.0, 2.0), is bent to 3 (1.0, 1.0000000000000004), \
         where no other crosses it"
    );
    assert_defects!(claim.verify_chains(), Defect::BentChain { .. });
    // Farther off it is no chain at all.
    let off = point(1.0, 1.0 + 40.0 * f64::EPSILON);
    claim.points[3] = off;
    claim.input.points[3] = off;
    assert_rejected!(claim, Defect::BrokenChain { .. });
}

#[test]
fn rejects_wrong_lineage() {
    let claim = right(&crossed(), DomainRule::Hull);
    let wrong = |change: fn(&mut Vec<Vec<VertexId>>)| {
        let claim = misread(claim.clone(), |c| change(&mut c.chains));
        assert!(claim.verify().is_ok());
        assert_defects!(claim.verify_chains(), Defect::BrokenChain { .. })
    };
    wrong(|chains| chains.rotate_left(1));
    wrong(|chains| chains[4].reverse());
    wrong(|chains| {
        chains[4].remove(1);
    });
    wrong(|chains| {
        chains[4].pop();
    });
    wrong(|chains| chains[4].clear());
    wrong(|chains| chains[4][1] = 77.into());
    wrong(|chains| {
        let last = chains[4][1];
        chains[4].push(last);
    });
    // Both ends are right, but the way between them is another segment's.
    let mut input = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (2.0, 1.0)]);
    input.add_ring([0, 1, 2]);
    let mut claim = right(&input, DomainRule::Carve);
    claim.numbers();
    claim.chains[0] = [0, 2, 1].map(VertexId::new).to_vec();
    assert_defects!(claim.verify_chains(), Defect::BrokenChain { .. });
}

#[test]
fn rejects_a_forgotten_island_and_a_filled_pond() {
    let claim = right(&lake(), DomainRule::EvenOdd);
    let on_island = |c: &Claim, t: &[VertexId; 3]| {
        t.iter()
            .all(|v| c.points[v.index()].x.abs().max(c.points[v.index()].y.abs()) <= 2.0)
    };
    let forgotten = misread(claim.clone(), |c| {
        c.triangles = c
            .triangles
            .iter()
            .copied()
            .filter(|t| !on_island(c, t))
            .collect();
    });
    assert_rejected!(
        forgotten,
        Defect::Uncovered { .. },
        Defect::MissingPoint { .. }
    );
    let filled = misread(right(&lake(), DomainRule::Carve), |c| {
        c.rule = DomainRule::EvenOdd
    });
    assert_rejected!(filled, Defect::OutsideDomain { .. });
    let kept = misread(right(&lake(), DomainRule::Hull), |c| {
        c.rule = DomainRule::Carve
    });
    assert_rejected!(kept, Defect::OutsideDomain { .. }, Defect::OpenEdge { .. });
    let carved = misread(right(&lake(), DomainRule::Carve), |c| {
        c.rule = DomainRule::Hull
    });
    assert_rejected!(
        carved,
        Defect::Uncovered { .. },
        Defect::MissingPoint { .. }
    );
}

#[test]
fn rejects_triangles_in_a_hole() {
    for rule in RULES {
        let seed = point(6.0, 0.25);
        let mut claim = right(&lake(), rule);
        claim.input.holes.push(seed);
        let defects = assert_rejected!(claim, Defect::FilledHole { hole: 0, .. });
        assert!(
            defects
                .to_string()
                .contains("lies in hole 0 of seed (6.0, 0.25)")
        );
        let mut carved = right(&claim.input, rule);
        carved.numbers();
        carved.input.holes.clear();
        assert_rejected!(carved, Defect::Uncovered { .. });
    }
}

#[test]
fn rejects_gaps_and_sheets() {
    let claim = right(&lake(), DomainRule::Carve);
    let at_pond = |t: &[VertexId; 3]| {
        t.iter()
            .all(|v| (8..12).contains(&v.index()) || v.index() == 14)
    };
    let t = claim
        .triangles
        .iter()
        .position(at_pond)
        .expect("a triangle in the pond");
    let gap = misread(claim.clone(), |c| {
        c.triangles.remove(t);
    });
    assert_rejected!(gap, Defect::OpenEdge { .. });
    let twice = misread(claim.clone(), |c| c.triangles.push(c.triangles[t]));
    assert_rejected!(twice, Defect::CrowdedEdge { .. });
    let turned = misread(claim.clone(), |c| c.triangles[t].reverse());
    assert_rejected!(turned, Defect::Clockwise { .. });
    let flipped = misread(claim, |c| flip(c, t).expect("an edge"));
    assert!(flipped.verify().is_err());
}

#[test]
fn rejects_a_flip_that_only_the_perturbation_forbids() {
    let mut input = Pslg::default();
    add_square(&mut input, [0.0, 0.0], 1.0);
    let mut claim = right(&input, DomainRule::Carve);
    claim.numbers();
    claim.triangles = vec![[0, 1, 2], [0, 2, 3]]
        .into_iter()
        .map(|t| t.map(VertexId::new))
        .collect();
    let defects = assert_rejected!(claim, Defect::NotLocallyDelaunay { .. });
    assert_eq!(defects.total(), 1);
    // A segment exempts the diagonal.
    input.add_segment(0, 2);
    claim.input.add_segment(0, 2);
    claim.subsegments.push([0, 2].map(VertexId::new));
    claim.verify().expect("the diagonal is constrained");
}

// Inputs that have no domain.

#[test]
fn improper_inputs_are_errors_that_name_the_culprit() {
    let base = right(&lake(), DomainRule::EvenOdd);
    let error = |change: fn(&mut Pslg)| misread(base.clone(), |c| change(&mut c.input)).error();
    let found = error(|input| input.add_segment(3, 40));
    let vertex = 40.into();
    assert_eq!(
        found,
        Error::BadSegment {
            segment: 12,
            vertex,
            points: 17
        }
    );
    let found = error(|input| input.polygons.push(3..13));
    assert_eq!(
        found,
        Error::BadPolygon {
            polygon: 0,
            range: 3..13,
            segments: 12
        }
    );
    let found = error(|input| input.polygons.push(0..3));
    assert!(matches!(found, Error::OpenPolygon { polygon: 0, .. }));
    let found = error(|input| input.holes.push(point(f64::NAN, 0.0)));
    assert!(matches!(
        found,
        Error::SeedNotFinite {
            seed: Seed::Hole(0),
            ..
        }
    ));
    let found = error(|input| input.points[2].y = f64::INFINITY);
    assert!(matches!(found, Error::NotFinite { index: 2, .. }));
    for at in [point(-5.0, 1.0), point(5.0, 5.0)] {
        let mut claim = base.clone();
        claim.input.holes.push(at);
        let seed = Seed::Hole(0);
        let found = claim.error();
        assert!(matches!(found, Error::SeedOnSegment { seed: s, segment: 4..8, .. } if s == seed));
    }
}

#[test]
fn seeds_on_the_bare_hull_and_on_loose_points_stand_for_what_is_inside() {
    let mut input = Pslg::from_points([(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)]);
    input
        .points
        .extend([point(4.0, 0.0), point(4.0, 8.0), point(2.0, 3.0)]);
    input.add_segment(4, 5);
    for at in [(0.0, 3.0), (0.0, 0.0), (2.0, 3.0), (1.0, 1.0)] {
        input.holes = vec![at.into()];
        let numbers = right(&input, DomainRule::Hull).numbers();
        assert_eq!((numbers.components, numbers.carved), (1, 3), "{at:?}");
    }
    input.holes = vec![point(-1.0, 3.0), point(9.0, 3.0)];
    assert_eq!(right(&input, DomainRule::Hull).numbers().carved, 0);
}

#[test]
fn polygons_are_united_each_by_its_own_parity() {
    let mut input = Pslg::default();
    for (x, half) in [(0.0, 4.0), (0.0, 2.0), (20.0, 4.0), (22.0, 4.0), (0.0, 1.0)] {
        add_square(&mut input, [x, 0.0], half);
    }
    // An outline with a hole; two that overlap; loose segments.
    input.polygons = vec![0..8, 8..12, 12..16];
    let numbers = right(&input, DomainRule::EvenOdd).numbers();
    assert_eq!(
        (numbers.components, numbers.holes, numbers.carved),
        (2, 1, 4)
    );
    // All together, the overlap is behind two segments and the innermost square behind three.
    input.polygons.clear();
    let numbers = right(&input, DomainRule::EvenOdd).numbers();
    assert_eq!(
        (numbers.components, numbers.holes, numbers.carved),
        (4, 1, 0)
    );
}

// Long work.

/// Cancels when asked for the `limit`-th time.
struct Impatient {
    asked: AtomicU64,
    limit: u64,
    last: AtomicU64,
}

impl Watch for Impatient {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        assert_eq!(phase, Phase::Check);
        assert!(done <= total);
        self.last.store(total - done, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) >= self.limit
    }
}

/// A square with many points in it, without segments: what the bare builder makes is right.
fn large() -> (Pslg, Vec<[VertexId; 3]>) {
    let input = Pslg::from_points(Kind::Uniform.points(20_000, 4));
    let t = delone::triangulate(input.points.iter().copied()).expect("finite");
    (input, t.triangles().to_vec())
}

#[test]
fn long_work_reports_and_can_be_cancelled_anywhere() {
    let (input, triangles) = large();
    let verify = |limit| {
        let watch = Impatient {
            asked: AtomicU64::new(0),
            limit,
            last: AtomicU64::new(1),
        };
        let mesh = DomainMesh::new(&input.points, &triangles, &[]);
        let verdict = check::verify_domain(&input, DomainRule::Hull, &mesh, &watch);
        (verdict, watch.asked.into_inner(), watch.last.into_inner())
    };
    let (verdict, polls, left) = verify(u64::MAX);
    let certificate = verdict
        .expect("not cancelled")
        .into_result()
        .expect("right");
    assert_eq!((certificate.points, left), (20_000, 0));
    assert!(polls > 100, "only {polls}");
    for limit in (0..polls).step_by(7) {
        assert_eq!(verify(limit).0, Err(Error::Cancelled), "{limit}");
    }
}
