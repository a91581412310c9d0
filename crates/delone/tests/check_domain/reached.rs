//! What refinement makes, before the verifier: the mesh is right, the bounds are met, and every excuse of
//! its report holds.

use crate::claim::lake;
use delone::check::{self, Asked, DomainMesh, QualityVerdict};
use delone::{
    Angle, Budget, DomainRule, Encroachment, Locked, Outcome, Pslg, Quality, RefinedMesh,
    Refinement, VertexId,
};
use delone_testkit::corpus;
use delone_testkit::domains::has_crossing;
use delone_testkit::generate::{Kind, Random};
use std::path::Path;

/// Lets the verifier look at a mesh, with its chains and without.
fn judge(input: &Pslg, rule: DomainRule, mesh: &RefinedMesh, asked: &Asked) -> QualityVerdict {
    let t = mesh.mesh.triangulation();
    let subsegments: Vec<_> = mesh.mesh.constrained_edges().collect();
    let claim = DomainMesh::new(t.points(), t.triangles(), &subsegments);
    // Whoever drew the segments has chains for these alone.
    let chains = |segment| {
        assert!(segment < input.segments.len(), "nobody drew {segment}");
        mesh.mesh.chain(segment)
    };
    let verify = |claim: &DomainMesh| {
        let verdict = check::verify_quality(input, rule, claim, asked, &());
        verdict
            .expect("a proper input")
            .unwrap_or_else(|d| panic!("{d}\n{input:?}"))
    };
    let verdict = verify(&claim.with_chains(&chains));
    // Of several excuses another one may come first.
    let counts = |verdict: &QualityVerdict| {
        let numbers = verdict.certificate.domain.as_ref().expect("numbers");
        let unexcused = verdict.counts().unexcused;
        (verdict.unmet.len(), unexcused, numbers.on_segments)
    };
    assert_eq!(counts(&verify(&claim)), counts(&verdict));
    verdict
}

/// Vertices that none of these domains needs: with more, refinement does not end by itself.
const PLENTY: usize = 100_000;

/// Refines, verifies, and compares with the report.
fn refine(input: &Pslg, rule: DomainRule, quality: Quality, locked: Locked) -> QualityVerdict {
    let refinement = Refinement::new(quality)
        .domain(rule)
        .locked(locked)
        .budget(Budget {
            vertices: Some(PLENTY),
            ..Budget::default()
        });
    let mesh = refinement.mesh(input.clone()).expect("a proper input");
    let verdict = judge(input, rule, &mesh, &Asked::new(quality).locked(locked));
    let report = &mesh.report;
    assert_eq!(verdict.certificate.hash, mesh.mesh.triangulation().hash());
    let domain = verdict.certificate.domain.expect("numbers");
    assert_eq!(
        (domain.on_segments, domain.free),
        (report.on_segments, report.free)
    );
    assert!(verdict.on_locked.is_empty());
    assert_eq!(verdict.unmet.len(), report.unmet.len(), "{input:?}");
    for unmet in &verdict.unmet {
        let mut said = report.unmet.iter().filter(|u| u.triangle == unmet.triangle);
        let said = said.next().expect("unmet, and not in the report");
        assert_eq!(said.broken, unmet.broken);
        assert_eq!(
            said.reason.is_excused(),
            unmet.excuse.is_some(),
            "{said:?} {unmet:?}\n{input:?}"
        );
    }
    assert_eq!(report.outcome == Outcome::Complete, verdict.is_met());
    verdict
}

fn angle(degrees: f64) -> Quality {
    Quality {
        min_angle: Some(Angle::degrees(degrees)),
        ..Quality::default()
    }
}

#[test]
fn rings_in_rings_are_met_under_every_rule() {
    for rule in [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd] {
        for degrees in [20.0, 30.0] {
            let quality = Quality {
                max_edge: Some(2.0),
                ..angle(degrees)
            };
            let verdict = refine(&lake(), rule, quality, Locked::Nothing);
            assert!(verdict.is_met() && verdict.certificate.triangles > 100);
        }
    }
}

#[test]
fn locked_segments_stay_and_excuse() {
    for locked in [Locked::Boundary, Locked::Segments] {
        let quality = Quality {
            max_area: Some(0.5),
            ..angle(25.0)
        };
        let verdict = refine(&lake(), DomainRule::Carve, quality, locked);
        assert!(verdict.counts().locked > 0);
    }
}

#[test]
fn conforming_meshes_conform() {
    let input = lake();
    let refinement = Refinement::new(angle(20.0)).domain(DomainRule::Carve);
    let mesh = refinement
        .encroachment(Encroachment::Circle)
        .mesh(input.clone());
    let asked = Asked::new(angle(20.0)).conforming();
    let verdict = judge(&input, DomainRule::Carve, &mesh.expect("a lake"), &asked);
    assert!(verdict.is_met(), "{verdict:?}");
}

#[test]
fn of_random_stars_the_report_is_right() {
    let mut random = Random::new(11);
    let mut met = 0;
    for _ in 0..40 {
        let n = 4 + random.below(12);
        let mut input = Pslg::from_points(Kind::Uniform.points(n, random.bits()));
        // A star, whose rays do not cross.
        for ray in 1..1 + random.below(n) {
            input.add_segment(VertexId::new(0), VertexId::new(ray));
        }
        let verdict = refine(&input, DomainRule::Hull, angle(20.0), Locked::Nothing);
        met += usize::from(verdict.is_met());
    }
    assert_eq!(met, 40);
}

/// Between the hull and two segments there is no room for more than rounding: which vertices are on which?
#[test]
fn a_hull_just_outside_of_segments_is_told_from_them() {
    let middle = |a: f64, b: f64| f64::midpoint(a, b);
    let (a, c) = ((202.5, 1143.9727), (-0.0, 869.6563));
    let b = (middle(a.0, c.0), middle(a.1, c.1).next_down());
    let input = |points: [(f64, f64); 5]| {
        let mut input = Pslg::from_points(points);
        for (from, to) in [(0, 1), (1, 2), (1, 3)] {
            input.add_segment(from, to);
        }
        input
    };
    let drawn = [a, b, c, (140.0, 990.0), (300.0, 800.0)];
    // Turned by a quarter each time, so that the hull goes in all directions.
    let turned = |p: (f64, f64)| (-p.1, p.0);
    let turns = std::iter::successors(Some(drawn), |points| Some(points.map(turned)));
    for points in turns.take(4) {
        let input = input(points);
        let quality = Quality {
            max_edge: Some(20.0),
            ..angle(30.0)
        };
        let verdict = refine(&input, DomainRule::Hull, quality, Locked::Nothing);
        let numbers = verdict.certificate.domain.as_ref().expect("numbers");
        assert_eq!(numbers.added, 0);
        assert!(numbers.on_segments > 20, "{numbers:?}");
        // Precision would be an excuse, too, but the angle between hull and segment is the reason.
        let counts = verdict.counts();
        assert!(counts.small_input_angle > 10, "{counts:?}");
        assert_eq!(counts.precision, 0);
    }
}

/// The few files of the corpus that are part of the repository.
const FIXTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");

#[test]
fn of_fixtures_the_report_is_right() {
    let (mut files, mut met) = (0, 0);
    for entry in corpus::read_all(Path::new(FIXTURES)) {
        let input = &entry.pslg;
        if input.points.len() > 2000 || has_crossing(input) {
            continue;
        }
        files += 2;
        for rule in [DomainRule::Hull, DomainRule::Carve] {
            let verdict = refine(input, rule, angle(20.0), Locked::Nothing);
            met += usize::from(verdict.is_met());
        }
    }
    assert!(files > 40 && met == files, "{met} of {files}");
}

#[test]
fn of_the_corpus_the_report_is_right() {
    let Some(root) = corpus::root() else { return };
    for entry in corpus::read_all(&root) {
        let input = &entry.pslg;
        if input.points.len() > 600 || has_crossing(input) {
            continue;
        }
        // Shown if it fails.
        println!("{}", entry.name);
        for degrees in [20.0, 30.0] {
            let verdict = refine(input, DomainRule::Carve, angle(degrees), Locked::Nothing);
            assert!(verdict.is_met(), "{degrees}");
            // Some hulls pass segments so closely that features leave no room.
            let _ = refine(input, DomainRule::Hull, angle(degrees), Locked::Nothing);
        }
    }
}
