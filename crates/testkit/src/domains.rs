//! What must hold of every constrained triangulation: by itself, against itself in another order,
//! and against the oracles.

use crate::generate::Random;
use crate::naive::{
    NaiveNoding, naive_constrained, naive_domain, naive_first_crossing, naive_noding,
    sorted_triangles,
};
use delone::check::{DomainMesh, verify_domain};
use delone::predicates::{Orientation, in_circle_perturbed, orient2d};
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Error, Origin, Pslg, Seed,
    SegmentPolicy, TriangleId, VertexId,
};
use std::collections::BTreeSet;

/// A domain, and how it is to be triangulated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Domain {
    /// What is drawn.
    pub pslg: Pslg,
    /// What is to be done with crossings.
    pub crossings: SegmentPolicy,
    /// What is to be kept.
    pub rule: DomainRule,
}

/// What failed, in words.
type Outcome = Result<(), String>;

impl Domain {
    /// Triangulates it.
    ///
    /// # Errors
    /// Those of the library.
    pub fn triangulate(&self, threads: usize) -> Result<ConstrainedTriangulation, Error> {
        ConstrainedDelaunay::new()
            .crossings(self.crossings)
            .domain(self.rule)
            .threads(threads)
            .triangulate(self.pslg.clone())
    }

    /// Puts points, segments and holes into another order, and turns segments round.
    pub fn permuted(&self, random: &mut Random) -> Self {
        let mut other = self.clone();
        let order = random.permutation(self.pslg.points.len());
        let mut place = vec![0; order.len()];
        for (new, &old) in order.iter().enumerate() {
            other.pslg.points[new] = self.pslg.points[old];
            place[old] = new;
        }
        for segment in &mut other.pslg.segments {
            *segment = segment.map(|v| VertexId::new(place[v.index()]));
            if random.below(2) == 0 {
                segment.reverse();
            }
        }
        if self.pslg.polygons.is_empty() {
            random.shuffle(&mut other.pslg.segments);
        }
        random.shuffle(&mut other.pslg.polygons);
        random.shuffle(&mut other.pslg.holes);
        other
    }
}

/// Checks that a result is the constrained Delaunay triangulation of its chains, and that the chains
/// are plausible. Linear, and complete but for the noding and the rule of the domain.
///
/// # Errors
/// What is wrong.
pub fn check_sound(pslg: &Pslg, t: &ConstrainedTriangulation) -> Outcome {
    let mesh = t.triangulation().mesh();
    mesh.validate().map_err(|e| e.to_string())?;
    check_faces(t)?;
    check_input(pslg, t)?;
    check_edges(t)?;
    check_chains(t)
}

fn ensure(holds: bool, otherwise: impl FnOnce() -> String) -> Outcome {
    if holds { Ok(()) } else { Err(otherwise()) }
}

/// Finite faces turn counter-clockwise and come before the ghosts; the hull is convex.
fn check_faces(t: &ConstrainedTriangulation) -> Outcome {
    let (points, mesh) = (t.triangulation().points(), t.triangulation().mesh());
    let turn = |corners: [VertexId; 3]| {
        let [a, b, c] = corners.map(|v| points[v.index()]);
        orient2d(a, b, c)
    };
    let mut ghosts = false;
    for face in 0..mesh.num_faces() {
        let face = TriangleId::new(face);
        let is_ghost = mesh.is_ghost(face);
        let is_early = is_ghost && face.index() < t.triangulation().num_triangles();
        ensure(!is_early && (is_ghost || !ghosts), || {
            format!("{face:?} is out of order")
        })?;
        ghosts |= is_ghost;
        if is_ghost {
            // Hull edges run clockwise: the next one turns right, or goes straight on or back.
            let h = mesh.hull_edge_of(face);
            let next = mesh.hull(h).nth(1).unwrap_or(h);
            let bend = [mesh.dest(h), mesh.origin(h), mesh.origin(next)];
            ensure(turn(bend) != Orientation::Right, || {
                format!("the hull is bent at {bend:?}")
            })?;
        } else {
            let corners = mesh.corners(face);
            ensure(turn(corners) == Orientation::Left, || {
                format!("{corners:?} does not turn left")
            })?;
        }
    }
    Ok(())
}

/// The input is handed on, and what was added is sorted, new, and crossed by its segments.
fn check_input(pslg: &Pslg, t: &ConstrainedTriangulation) -> Outcome {
    let n = pslg.points.len();
    let (old, added) = t.triangulation().points().split_at(n);
    ensure(old == pslg.points && t.segments() == pslg.segments, || {
        "other input".to_owned()
    })?;
    ensure(t.num_crossings() == added.len(), || {
        "miscounted crossings".to_owned()
    })?;
    let ascends = added
        .windows(2)
        .all(|pair| pair[0].lex_cmp(&pair[1]).is_lt());
    ensure(ascends, || "crossings are not sorted".to_owned())?;
    for (i, p) in added.iter().enumerate() {
        ensure(!old.contains(p), || {
            format!("crossing {p:?} is an input point")
        })?;
        let v = VertexId::new(n + i);
        let Origin::Crossing([s, other]) = t.origin(v) else {
            return Err(format!("{v:?} has no segments"));
        };
        let is_crossed = s < other && [s, other].iter().all(|&s| t.chain(s).contains(&v));
        ensure(is_crossed, || {
            format!("{v:?} is not on segments {s} and {other}")
        })?;
    }
    Ok(())
}

/// Edges know whether they are constrained from both sides, and are locally Delaunay if not.
fn check_edges(t: &ConstrainedTriangulation) -> Outcome {
    let (points, mesh) = (t.triangulation().points(), t.triangulation().mesh());
    for h in mesh.half_edges() {
        let twin = mesh.twin(h);
        let edge = [mesh.origin(h), mesh.dest(h)];
        ensure(t.is_constrained(h) == t.is_constrained(twin), || {
            format!("{edge:?} is constrained on one side")
        })?;
        let corners = [edge[0], edge[1], mesh.apex(h), mesh.apex(twin)];
        if h < twin && !t.is_constrained(h) && !corners.iter().any(|v| v.is_infinite()) {
            let [a, b, c, d] = corners.map(|v| points[v.index()]);
            ensure(!in_circle_perturbed(a, b, c, d), || {
                format!("{edge:?} is not locally Delaunay")
            })?;
        }
    }
    Ok(())
}

/// Chains join what their segments join, and the constrained edges are theirs.
fn check_chains(t: &ConstrainedTriangulation) -> Outcome {
    let constrained: BTreeSet<_> = t.constrained_edges().map(sorted_edge).collect();
    let mut in_chains = BTreeSet::new();
    for (s, ends) in t.segments().iter().enumerate() {
        let [a, b] = ends.map(|v| t.triangulation().representative(v));
        let chain = t.chain(s);
        let joins = chain.first() == Some(&a) && chain.last() == Some(&b);
        ensure(joins && (a == b) == (chain.len() == 1), || {
            format!("the chain of segment {s} is {chain:?}")
        })?;
        in_chains.extend(chain.windows(2).map(|e| sorted_edge([e[0], e[1]])));
    }
    ensure(constrained == in_chains, || {
        let edge = constrained.symmetric_difference(&in_chains).next();
        format!("{edge:?} is constrained or in a chain, but not both")
    })
}

fn sorted_edge([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}

/// Checks that another order of the input, and other threads, yield the same.
///
/// # Errors
/// What differs.
pub fn check_canonical(
    domain: &Domain,
    t: &ConstrainedTriangulation,
    threads: usize,
    random: &mut Random,
) -> Outcome {
    let other = domain.permuted(random);
    let again = other.triangulate(threads);
    let again = again.map_err(|e| format!("permuted: {e}\n{other:?}"))?;
    let hash = |t: &ConstrainedTriangulation| t.triangulation().hash();
    let counts = |t: &ConstrainedTriangulation| {
        let constrained = t.constrained_edges().count();
        let faces = t.triangulation().mesh().num_faces();
        (
            t.num_crossings(),
            t.triangulation().num_triangles(),
            faces,
            constrained,
        )
    };
    ensure(
        hash(t) == hash(&again) && counts(t) == counts(&again),
        || format!("permuted, it has other triangles:\n{other:?}"),
    )
}

/// Checks that the verifier certifies a result.
///
/// # Errors
/// What it finds wrong.
pub fn check_verified(domain: &Domain, t: &ConstrainedTriangulation) -> Outcome {
    let result = t.triangulation();
    let subsegments: Vec<_> = t.constrained_edges().collect();
    let chains = |segment: usize| t.chain(segment);
    let mesh = DomainMesh::new(result.points(), result.triangles(), &subsegments);
    let verdict = verify_domain(&domain.pslg, domain.rule, &mesh.with_chains(&chains), &());
    let verdict = verdict.map_err(|e| format!("the verifier refuses: {e}"))?;
    let certificate = verdict.into_result().map_err(|e| e.to_string())?;
    ensure(certificate.hash == result.hash(), || {
        "other hash".to_owned()
    })
}

/// Checks that a result is what the definitions say; of the triangles only if there are few vertices.
///
/// # Errors
/// What differs.
pub fn check_naive(domain: &Domain, t: &ConstrainedTriangulation) -> Outcome {
    let pslg = &domain.pslg;
    let noding = naive_noding(&pslg.points, &pslg.segments);
    check_noding(&noding, t)?;
    if noding.points.len() > MOST_FOR_DEFINITIONS {
        return Ok(());
    }
    let all = naive_constrained(&noding.points, &noding.edges());
    let expected = naive_domain(pslg, &noding, &all, domain.rule);
    let expected = expected.map_err(|seed| format!("{seed} lies on a segment"))?;
    let found = sorted_triangles(t.triangulation());
    ensure(found == expected.triangles, || {
        format!("has triangles {found:?}, not {:?}", expected.triangles)
    })?;
    for (i, corners) in t.triangulation().triangles().iter().enumerate() {
        let corners = lowest_first(*corners);
        let at = expected
            .triangles
            .binary_search(&corners)
            .expect("the same triangles");
        ensure(t.region(TriangleId::new(i)) == expected.regions[at], || {
            format!("{corners:?} is not in region {:?}", expected.regions[at])
        })?;
    }
    Ok(())
}

fn check_noding(noding: &NaiveNoding, t: &ConstrainedTriangulation) -> Outcome {
    let points = t.triangulation().points();
    ensure(points == noding.points, || {
        format!("has vertices {points:?}, not {:?}", noding.points)
    })?;
    for (s, chain) in noding.chains.iter().enumerate() {
        let found = t.chain(s);
        ensure(found == chain, || {
            format!("segment {s} is {found:?}, not {chain:?}")
        })?;
    }
    Ok(())
}

fn lowest_first(corners: [VertexId; 3]) -> [VertexId; 3] {
    let [a, b, c] = corners;
    let rotations = [[a, b, c], [b, c, a], [c, a, b]];
    rotations.into_iter().min().expect("three rotations")
}

/// The definition takes O(n⁴): seconds for more points than this.
const MOST_FOR_DEFINITIONS: usize = 32;

/// Checks that an error is deserved, if the noding is small enough for the definition.
///
/// # Errors
/// Why it is not.
pub fn check_error(domain: &Domain, error: &Error) -> Outcome {
    let Pslg {
        points, segments, ..
    } = &domain.pslg;
    let deserved = match *error {
        Error::NotFinite { index, .. } => points.iter().position(|p| !p.is_finite()) == Some(index),
        Error::Crossing { segments: pair, at } => {
            domain.crossings == SegmentPolicy::Error
                && naive_first_crossing(points, segments) == Some((pair, at))
        }
        Error::SeedOnSegment { seed, .. } => {
            let noding = naive_noding(points, segments);
            if noding.points.len() > MOST_FOR_DEFINITIONS {
                return Ok(());
            }
            let all = naive_constrained(&noding.points, &noding.edges());
            naive_domain(&domain.pslg, &noding, &all, domain.rule) == Err(seed)
        }
        Error::SeedNotFinite {
            seed: Seed::Hole(i),
            ..
        } => !domain.pslg.holes[i].is_finite(),
        Error::SeedNotFinite {
            seed: Seed::Region(i),
            ..
        } => !domain.pslg.regions[i].at.is_finite(),
        Error::OpenPolygon {
            polygon, vertex, ..
        } => is_open_at(&domain.pslg, polygon, vertex),
        _ => false,
    };
    ensure(deserved, || format!("undeserved: {error}"))
}

/// Tells whether the error policy must refuse this.
pub fn has_crossing(pslg: &Pslg) -> bool {
    naive_first_crossing(&pslg.points, &pslg.segments).is_some()
}

/// Tells whether an odd number of a polygon's segments end in the point that `vertex` stands for.
fn is_open_at(pslg: &Pslg, polygon: usize, vertex: VertexId) -> bool {
    let border = pslg.segments[pslg.polygons[polygon].clone()].as_flattened();
    let at = |v: &&VertexId| pslg.points[v.index()] == pslg.points[vertex.index()];
    border.iter().filter(at).count() % 2 == 1
}
