//! Every file of the shared corpus that has segments: triangulated as a domain under every rule and
//! both policies, and the same again when shuffled, rotated or scaled; and by name the inputs on
//! which other systems broke.

use delone::check::{self, DomainMesh};
use delone::{
    ConstrainedTriangulation, DomainRule, Error, Point, SegmentPolicy, VertexId, Warning,
    hash_triangles,
};
use delone_testkit::corpus::{self, Entry, Facts};
use delone_testkit::domains::{Domain, check_canonical, check_naive, check_sound, has_crossing};
use delone_testkit::generate::{Random, scaled};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

const RULES: [DomainRule; 3] = [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd];

/// Beyond this many points the extreme scalings, which need wide arithmetic, take too long here.
const FEW: usize = 3000;

/// Up to this many points the definitions, which take O(n⁴), are asked too.
const TINY: usize = 20;

/// The few files of the corpus that are part of the repository.
const FIXTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");

/// The golden results of the fixtures: rule and name, then vertices, crossings, constrained edges,
/// triangles, hash.
const GOLDEN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/corpus-domains.txt");

fn domain(entry: &Entry, crossings: SegmentPolicy, rule: DomainRule) -> Domain {
    Domain {
        pslg: entry.pslg.clone(),
        crossings,
        rule,
    }
}

/// Triangulates with crossings split, and verifies.
fn verified(name: &str, domain: &Domain) -> ConstrainedTriangulation {
    let t = domain
        .triangulate(2)
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    check_sound(&domain.pslg, &t).unwrap_or_else(|reason| panic!("{name}: {reason}"));
    let subsegments: Vec<_> = t.constrained_edges().collect();
    let result = t.triangulation();
    let chains = |segment: usize| t.chain(segment);
    let mesh = DomainMesh::new(result.points(), result.triangles(), &subsegments);
    let mesh = mesh.with_chains(&chains);
    let verdict = check::verify_domain(&domain.pslg, domain.rule, &mesh, &());
    let verdict = verdict.unwrap_or_else(|e| panic!("{name}: {e}"));
    if let Err(defects) = verdict.into_result() {
        panic!("{name}, {:?}:\n{defects}", domain.rule);
    }
    t
}

/// Calls `test` for every fixture with segments, and for every such file of the shared corpus if it
/// is there, with a generator of its own.
fn for_each_file(mut test: impl FnMut(Entry, Random)) {
    let mut files = 0;
    let mut test_all = |root: &Path| {
        for entry in corpus::read_all(root) {
            if !entry.pslg.segments.is_empty() {
                files += 1;
                test(entry, Random::new(files));
            }
        }
    };
    test_all(Path::new(FIXTURES));
    if let Some(shared) = corpus::root() {
        test_all(&shared);
        assert!(files > 150, "only {files} files with segments");
    } else {
        eprintln!("fixtures only: set DELONE_SHARED to the folder that holds the shared data/");
    }
}

/// What the shared corpus states of its files, if it is there.
fn stated_facts() -> BTreeMap<String, Facts> {
    corpus::root()
        .map(|root| corpus::facts(&root))
        .unwrap_or_default()
}

#[test]
fn every_domain_is_triangulated_whatever_its_order() {
    for_each_file(|entry, mut random| {
        for rule in RULES {
            let domain = domain(&entry, SegmentPolicy::Split, rule);
            let t = verified(&entry.name, &domain);
            let outcome = check_canonical(&domain, &t, 1, &mut random);
            let outcome = outcome.and_then(|()| {
                if entry.pslg.points.len() <= TINY {
                    check_naive(&domain, &t)
                } else {
                    Ok(())
                }
            });
            outcome.unwrap_or_else(|reason| panic!("{}, {rule:?}: {reason}", entry.name));
        }
    });
}

#[test]
fn clean_files_pass_the_error_policy_and_crossing_ones_are_named() {
    let facts = stated_facts();
    let (mut clean, mut crossing) = (0, 0);
    for_each_file(|entry, _| {
        let name = &entry.name;
        let refused = domain(&entry, SegmentPolicy::Error, DomainRule::Hull).triangulate(1);
        let stated = facts.get(name).map(|facts| facts.crossings > 0);
        match refused {
            Ok(t) => {
                // Crossings that are stated may all lie in vertices.
                assert!(stated != Some(true) || !has_crossing(&entry.pslg), "{name}");
                let split = domain(&entry, SegmentPolicy::Split, DomainRule::Hull);
                let split = split.triangulate(1).expect("no crossings");
                assert_eq!(split.num_crossings(), 0, "{name}");
                assert_eq!(
                    t.triangulation().hash(),
                    split.triangulation().hash(),
                    "{name}"
                );
                clean += 1;
            }
            Err(Error::Crossing { segments, at }) => {
                assert_ne!(stated, Some(false), "{name} has no crossings");
                assert_crosses(&entry, segments, at);
                crossing += 1;
            }
            Err(error) => panic!("{name}: {error}"),
        }
    });
    if corpus::root().is_some() {
        assert!(clean > 130, "only {clean} clean files");
        assert!(crossing > 20, "only {crossing} crossing files");
    }
}

/// The pair alone crosses, where it was said to.
fn assert_crosses(entry: &Entry, [i, j]: [usize; 2], at: Point) {
    assert!(i < j, "{}", entry.name);
    let mut pair = domain(entry, SegmentPolicy::Split, DomainRule::Hull);
    let ends = [i, j].map(|s| entry.pslg.segments[s]).into_iter().flatten();
    pair.pslg.points = ends.map(|v| entry.pslg.points[v.index()]).collect();
    pair.pslg.segments = [[0, 1], [2, 3]].map(|s| s.map(VertexId::from)).to_vec();
    pair.pslg.polygons.clear();
    let t = pair.triangulate(1).expect("a result");
    assert!(t.triangulation().points().contains(&at), "{}", entry.name);
    pair.crossings = SegmentPolicy::Error;
    let refused = pair.triangulate(1).expect_err("a crossing");
    let segments = [0, 1];
    assert_eq!(refused, Error::Crossing { segments, at }, "{}", entry.name);
}

#[test]
fn every_domain_is_triangulated_when_rotated() {
    for_each_file(|mut entry, mut random| {
        let (sin, cos) = (8.0 * random.unit()).sin_cos();
        let rotate = |p: &mut Point| {
            *p = Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
        };
        entry.pslg.points.iter_mut().for_each(rotate);
        entry.pslg.holes.iter_mut().for_each(rotate);
        entry
            .pslg
            .regions
            .iter_mut()
            .for_each(|r| rotate(&mut r.at));
        let rule = random.choose(&RULES);
        let name = format!("{} rotated", entry.name);
        verified(&name, &domain(&entry, SegmentPolicy::Split, rule));
    });
}

#[test]
fn every_domain_keeps_its_triangles_when_scaled() {
    let mut extremes = 0;
    for_each_file(|entry, mut random| {
        let few = entry.pslg.points.len() <= FEW;
        let exponents: &[i32] = if few { &[-40, 30, -700, 700] } else { &[30] };
        let original = domain(&entry, SegmentPolicy::Split, random.choose(&RULES));
        let hash = original
            .triangulate(2)
            .expect("a result")
            .triangulation()
            .hash();
        for &exponent in exponents {
            let times = |p: Point, e| Point::new(scaled(p.x, e), scaled(p.y, e));
            let mut other = original.clone();
            let pslg = &mut other.pslg;
            pslg.points
                .iter_mut()
                .for_each(|p| *p = times(*p, exponent));
            pslg.holes.iter_mut().for_each(|p| *p = times(*p, exponent));
            pslg.regions
                .iter_mut()
                .for_each(|r| r.at = times(r.at, exponent));
            let t = other.triangulate(2).expect("a result");
            let back = |v: VertexId| times(t.triangulation().point(v), -exponent);
            let triangles = t.triangulation().triangles().iter();
            let scaled_back = hash_triangles(triangles.map(|corners| corners.map(back)));
            assert_eq!(scaled_back, hash, "{} times 2^{exponent}", entry.name);
            extremes += usize::from(exponent.abs() > 40);
        }
    });
    assert!(extremes > 50, "only {extremes} extreme scalings");
}

fn golden_line(entry: &Entry, rule: DomainRule) -> String {
    let t = verified(&entry.name, &domain(entry, SegmentPolicy::Split, rule));
    let result = t.triangulation();
    let counts = [
        result.num_vertices(),
        t.num_crossings(),
        t.constrained_edges().count(),
        result.num_triangles(),
    ];
    let [vertices, crossings, constrained, triangles] = counts;
    let (name, hash) = (&entry.name, result.hash());
    format!("{rule:?} {name} {vertices} {crossings} {constrained} {triangles} {hash}\n")
}

/// Run with `DELONE_BLESS=1` to write the file anew, and read the difference.
#[test]
fn fixtures_have_their_golden_hashes() {
    let mut found = String::new();
    let has_segments = |entry: &Entry| !entry.pslg.segments.is_empty();
    for entry in corpus::read_all(Path::new(FIXTURES)).filter(has_segments) {
        for rule in RULES {
            let _ = write!(found, "{}", golden_line(&entry, rule));
        }
    }
    if std::env::var_os("DELONE_BLESS").is_some() {
        fs::write(GOLDEN, &found).expect("a writable golden file");
    }
    let expected = fs::read_to_string(GOLDEN).expect("the golden file");
    assert_eq!(found, expected);
}

// Inputs on which other systems broke, by name.

/// Reads a file of the fixtures, or else of the shared corpus.
fn nasty(file: &str) -> Option<Entry> {
    let name = format!("nasty/{file}.poly");
    let fixtures = Path::new(FIXTURES);
    if fixtures.join(&name).exists() {
        return corpus::read(fixtures, &name);
    }
    let found = corpus::root().and_then(|root| corpus::read(&root, &name));
    if found.is_none() {
        eprintln!("skipped {name}: set DELONE_SHARED to the folder that holds the shared data/");
    }
    found
}

/// Expects this many vertices where segments cross; the definitions agree, and the error policy
/// refuses the file if there are some.
fn assert_crossings(file: &str, crossings: usize) {
    let Some(entry) = nasty(file) else { return };
    for rule in RULES {
        let domain = domain(&entry, SegmentPolicy::Split, rule);
        let t = verified(file, &domain);
        assert_eq!(t.num_crossings(), crossings, "{file}");
        check_naive(&domain, &t).unwrap_or_else(|reason| panic!("{file}: {reason}"));
    }
    let refused = domain(&entry, SegmentPolicy::Error, DomainRule::Hull).triangulate(1);
    match refused {
        Ok(_) => assert_eq!(crossings, 0, "{file}"),
        Err(error) => {
            assert!(matches!(error, Error::Crossing { .. }), "{file}: {error}");
            assert_ne!(crossings, 0, "{file}");
        }
    }
}

/// Expects these numbers of triangles under each rule, and no crossings.
fn assert_triangles(file: &str, expected: [usize; 3]) {
    let Some(entry) = nasty(file) else { return };
    let count = |rule| {
        let t = verified(file, &domain(&entry, SegmentPolicy::Error, rule));
        t.triangulation().num_triangles()
    };
    assert_eq!(RULES.map(count), expected, "{file}");
}

// A crossing can round to an end of a segment or to another crossing: there are fewer vertices than
// pairs that cross.

#[test]
fn spade_crossings_are_split() {
    assert_crossings("spade-107-split", 1);
    assert_crossings("spade-109-split-f32", 1);
    assert_crossings("spade-2151-own-fuzz-panic", 4);
    assert_crossings("spade-2151-own-fuzz-hang-tilted", 3);
    assert_crossings("spade-98-locate-loop", 0);
}

#[test]
fn cgal_crossings_are_split() {
    assert_crossings("cgal-cdt-degenerate", 2);
    assert_crossings("cgal-4405", 1);
    assert_crossings("cgal-3267-ulp", 2);
}

#[test]
fn trianglelite_1_merges_its_repeated_segment() {
    assert_crossings("trianglelite-1-tiny-failure", 1);
}

#[test]
fn poly2tri_18_crosses_itself() {
    assert_crossings("poly2tri-18-self-touching", 1);
}

#[test]
fn loops_of_others_end() {
    assert_crossings("constrainautor-15-near-degenerate", 0);
    assert_crossings("cdt-154b-pseudopoly-loop", 0);
    assert_crossings("cdt-154c-pseudopoly-loop", 0);
    assert_crossings("tinfour-35-collinear-disjoint", 0);
}

#[test]
fn cgal_781_has_one_triangle_and_a_very_tiny_edge() {
    assert_triangles("cgal-781-mesh", [1, 0, 0]);
    assert_crossings("cgal-781-very-tiny-edge", 0);
    assert_triangles("cgal-user-triangle-refine", [1, 1, 1]);
}

#[test]
fn poly2tri_15_is_a_plain_quadrilateral() {
    assert_triangles("poly2tri-15-case1", [2, 2, 2]);
}

#[test]
fn earcut_holes_touch_rings_and_each_other() {
    // A polygon of n corners with h holes that touch nothing has n + 2h − 2 triangles.
    assert_triangles("earcut-175-letterP", [20, 18, 14]);
    assert_triangles("earcut-177-touching-holes", [12, 12, 10]);
    assert_triangles("earcut-129b-touching-holes", [20, 15, 13]);
}

#[test]
fn wo80_10_and_libigl_487_are_squares() {
    assert_triangles("wo80-triangle-10-shared-vertex", [6, 4, 4]);
    assert_triangles("libigl-487-nested-squares", [8, 8, 8]);
}

#[test]
fn drufat_2_warns_of_its_hole() {
    let Some(entry) = nasty("drufat-triangle-2-core-dump") else {
        return;
    };
    let t = verified(
        "drufat-2",
        &domain(&entry, SegmentPolicy::Error, DomainRule::Carve),
    );
    let at = entry.pslg.holes[0];
    assert_eq!(t.warnings(), [Warning::HoleOutside { hole: 0, at }]);
    assert_eq!(t.triangulation().num_triangles(), 11);
}
