//! Random inputs: right triangulations by the definitions and by the builder, and mutations of them.

use crate::claim::{Claim, RULES, flip, point, right};
use delone::{ConstrainedDelaunay, DomainRule, Error, Point, Pslg, VertexId};
use delone_testkit::domains::{Domain, has_crossing};
use delone_testkit::fuzz::segments::case;
use delone_testkit::generate::{Kind, Random};

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
            for (kind, rejected) in rejected.iter_mut().enumerate() {
                if let Some(wrong) = mutate(&claim, &mut random, kind) {
                    assert!(wrong.verify().is_err(), "{kind}: {claim:?}\n{wrong:?}");
                    *rejected += 1;
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

// Larger variety.

/// What the builder makes of an input without crossings.
fn built(input: &Pslg, rule: DomainRule) -> Option<Claim> {
    let built = ConstrainedDelaunay::new()
        .domain(rule)
        .triangulate(input.clone());
    let t = match built {
        Err(Error::SeedOnSegment { .. } | Error::OpenPolygon { .. }) => return None,
        built => built.expect("a proper input"),
    };
    Some(Claim {
        input: input.clone(),
        rule,
        points: t.triangulation().points().to_vec(),
        triangles: t.triangulation().triangles().to_vec(),
        subsegments: t.constrained_edges().collect(),
        chains: (0..input.segments.len())
            .map(|s| t.chain(s).to_vec())
            .collect(),
    })
}

#[test]
fn builder_and_definitions_agree_before_the_verifier() {
    let mut domain = Domain::default();
    let mut both = 0;
    for seed in 0..3000 {
        case(seed, 10, 6, &mut domain);
        let (input, rule) = (&domain.pslg, domain.rule);
        let by_definition = Claim::right(input, rule).map(|claim| claim.verify_chains());
        if let Some(Err(defects)) = &by_definition {
            panic!("seed {seed}: {defects}\n{domain:?}");
        }
        if !has_crossing(input) {
            let built = built(input, rule).map(|claim| claim.verify_chains());
            assert_eq!(built, by_definition, "seed {seed}");
            both += usize::from(built.is_some());
        }
    }
    assert!(both > 500, "only {both}");
}
