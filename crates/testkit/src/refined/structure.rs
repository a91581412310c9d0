//! The mesh is the constrained Delaunay triangulation of its vertices and subsegments, those are the
//! input's, and what was to stay stayed.

use super::{Job, Lines, Verdict, at, ensure, least_room, magnitude, ulp};
use delone::predicates::{CircleSide, in_diametral_circle};
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Encroachment, HalfEdgeId, Locked,
    Origin, Outcome, Point, Pslg, RefinedMesh, TriangleId, VertexId, hash_triangles,
};

/// How far vertices along a segment may lie beside it, in units in the last place of its largest
/// coordinate: noding and each split round anew.
const MOST_DRIFT: f64 = 16.0;

pub(super) fn check_structure(job: &Job, refined: &RefinedMesh, lines: &Lines) -> Verdict {
    let mesh = &refined.mesh;
    let topology = mesh.triangulation().mesh();
    topology.validate().map_err(|e| e.to_string())?;
    check_input(job, refined)?;
    check_origins(refined, lines)?;
    for segment in 0..mesh.segments().len() {
        check_chain(mesh, segment)?;
    }
    check_rebuilt(job, mesh)?;
    check_locked(job, mesh, lines)?;
    check_conforming(job, refined)
}

/// Points and segments of the input are as they were.
fn check_input(job: &Job, refined: &RefinedMesh) -> Verdict {
    let RefinedMesh { mesh, report, .. } = refined;
    let pslg = &job.domain.pslg;
    let points = mesh.triangulation().points();
    let segments = &mesh.segments()[..mesh.num_input_segments()];
    ensure(points.starts_with(&pslg.points), || {
        "input points moved".to_owned()
    })?;
    let is_same = mesh.num_input_points() == pslg.points.len() && segments == pslg.segments;
    ensure(is_same, || "other input".to_owned())?;
    ensure(points.iter().all(Point::is_finite), || {
        "an infinite vertex".to_owned()
    })?;
    let added = mesh.num_steiner();
    ensure(report.on_segments + report.free == added, || {
        format!(
            "{added} Steiner points are not {} + {}",
            report.on_segments, report.free
        )
    })
}

/// Vertices that are said to lie on a segment are in its chain, free ones in none, and inside the
/// domain.
fn check_origins(refined: &RefinedMesh, lines: &Lines) -> Verdict {
    let RefinedMesh { mesh, report, .. } = refined;
    let triangulation = mesh.triangulation();
    let first = triangulation.points().len() - mesh.num_steiner();
    let mut on_segments = 0;
    for v in (first..triangulation.points().len()).map(VertexId::new) {
        let through = lines.through(v);
        let is_right = match mesh.origin(v) {
            Origin::OnSegment(segment) => {
                on_segments += 1;
                through.first() == Some(&segment)
            }
            Origin::Free => through.is_empty() && is_interior(mesh, v),
            _ => false,
        };
        ensure(is_right, || {
            let origin = mesh.origin(v);
            format!("{v:?} is said to be {origin:?}, but is on segments {through:?}, or outside")
        })?;
    }
    ensure(on_segments == report.on_segments, || {
        format!(
            "{on_segments} vertices on segments, {} told",
            report.on_segments
        )
    })
}

/// Tells whether all faces around a vertex belong to the domain.
fn is_interior(mesh: &ConstrainedTriangulation, v: VertexId) -> bool {
    let mut star = mesh.triangulation().star(v).peekable();
    star.peek().is_some() && star.all(|h| is_inside(mesh, h))
}

fn is_inside(mesh: &ConstrainedTriangulation, h: HalfEdgeId) -> bool {
    h.triangle().index() < mesh.triangulation().num_triangles()
}

/// A chain leads from end to end of its segment, forwards only, and along it.
fn check_chain(mesh: &ConstrainedTriangulation, segment: usize) -> Verdict {
    let ends = mesh.segments()[segment].map(|v| mesh.triangulation().representative(v));
    let chain = mesh.chain(segment);
    let joins = chain.first() == Some(&ends[0]) && chain.last() == Some(&ends[1]);
    ensure(joins && (ends[0] == ends[1]) == (chain.len() == 1), || {
        format!("the chain of segment {segment} is {chain:?}")
    })?;
    let line = ends.map(|v| at(mesh, v));
    let along: Vec<_> = chain.iter().map(|&v| progress(line, at(mesh, v))).collect();
    ensure(along.is_sorted(), || {
        format!("segment {segment} turns back: {along:?}")
    })?;
    let most = MOST_DRIFT * ulp(magnitude(line));
    for &v in chain {
        let drift = distance(line, at(mesh, v));
        ensure(drift <= most, || {
            let point = at(mesh, v);
            format!("{v:?} at {point:?} is {drift} beside segment {segment}, {line:?}")
        })?;
    }
    Ok(())
}

/// How far a point is along a segment, by the coordinate that changes most.
fn progress([a, b]: [Point; 2], p: Point) -> f64 {
    let is_flat = (b.x / 2.0 - a.x / 2.0).abs() >= (b.y / 2.0 - a.y / 2.0).abs();
    let (from, to, value) = if is_flat {
        (a.x, b.x, p.x)
    } else {
        (a.y, b.y, p.y)
    };
    if from <= to { value } else { -value }
}

/// The distance of a point from a line, measured at the point's other coordinate: at most √2 times
/// the true one.
fn distance([a, b]: [Point; 2], p: Point) -> f64 {
    let half = |p: Point| [p.x / 2.0, p.y / 2.0];
    let ([ax, ay], [bx, by], [px, py]) = (half(a), half(b), half(p));
    let [dx, dy] = [bx - ax, by - ay];
    if dx == 0.0 && dy == 0.0 {
        return 2.0 * (px - ax).abs().max((py - ay).abs());
    }
    let beside = if dx.abs() >= dy.abs() {
        (py - ay) - (px - ax) * (dy / dx)
    } else {
        (px - ax) - (py - ay) * (dx / dy)
    };
    2.0 * beside.abs()
}

/// Built anew of all vertices and subsegments, the triangulation has the same triangles, and under the
/// same rule the same domain and regions.
fn check_rebuilt(job: &Job, mesh: &ConstrainedTriangulation) -> Verdict {
    let pslg = all_pieces(job, mesh);
    let build = |rule, pslg: Pslg| {
        let again = ConstrainedDelaunay::new().domain(rule).triangulate(pslg);
        again.map_err(|e| format!("its vertices and subsegments: {e}"))
    };
    let pieces = Pslg {
        points: pslg.points.clone(),
        segments: pslg.segments.clone(),
        ..Pslg::default()
    };
    let hull = build(DomainRule::Hull, pieces)?;
    let old = mesh.triangulation();
    let finite = old.mesh().triangles();
    let all = hash_triangles(finite.map(|t| old.mesh().corners(t).map(|v| old.point(v))));
    ensure(hull.triangulation().hash() == all, || {
        "it is not the constrained Delaunay triangulation of its subsegments".to_owned()
    })?;
    ensure(
        old.duplicates() == hull.triangulation().duplicates(),
        || "a vertex was added twice".to_owned(),
    )?;
    if has_seed_on_segment(job, mesh) {
        return Ok(());
    }
    // The hull that was refined is carved along its own edges: rounding may bend them inwards.
    let is_closed = mesh.segments().len() > mesh.num_input_segments();
    let rule = if is_closed {
        DomainRule::Carve
    } else {
        job.domain.rule
    };
    let domain = build(rule, pslg)?;
    ensure(domain.triangulation().hash() == old.hash(), || {
        "it covers another domain".to_owned()
    })?;
    let regions = 0..job.domain.pslg.regions.len();
    let wrong = regions
        .into_iter()
        .find(|&r| hash_of_region(mesh, r) != hash_of_region(&domain, r));
    ensure(wrong.is_none(), || {
        format!("region {wrong:?} has other triangles")
    })
}

/// The input with all vertices, and with the pieces of each segment for the segment.
fn all_pieces(job: &Job, mesh: &ConstrainedTriangulation) -> Pslg {
    let input = &job.domain.pslg;
    let mut pslg = Pslg {
        points: mesh.triangulation().points().to_vec(),
        holes: input.holes.clone(),
        regions: input.regions.clone(),
        ..Pslg::default()
    };
    let mut starts = vec![0];
    for segment in 0..mesh.segments().len() {
        // Edges of the hull that are no segments of the input bound nothing.
        pslg.add_polyline(mesh.chain(segment).iter().copied());
        starts.push(pslg.segments.len());
    }
    let of_pieces = |polygon: &std::ops::Range<usize>| starts[polygon.start]..starts[polygon.end];
    // Empty ones, too: with any polygon, segments of none bound nothing.
    pslg.polygons = input.polygons.iter().map(of_pieces).collect();
    pslg
}

/// Tells whether the seed of a hole or region lies so close to a segment that rounded pieces of it may
/// pass on the other side.
fn has_seed_on_segment(job: &Job, mesh: &ConstrainedTriangulation) -> bool {
    let regions = job.domain.pslg.regions.iter().map(|r| r.at);
    let seeds: Vec<_> = job
        .domain
        .pslg
        .holes
        .iter()
        .copied()
        .chain(regions)
        .collect();
    let is_near = |line: [Point; 2], seed: Point| {
        let drift = MOST_DRIFT * ulp(magnitude(line));
        let is_within = |a: f64, b: f64, c: f64| a.min(b) - drift <= c && c <= a.max(b) + drift;
        let [a, b] = line;
        is_within(a.x, b.x, seed.x) && is_within(a.y, b.y, seed.y) && distance(line, seed) <= drift
    };
    let mut lines = mesh.segments().iter().map(|s| s.map(|v| at(mesh, v)));
    lines.any(|line| seeds.iter().any(|&seed| is_near(line, seed)))
}

fn hash_of_region(mesh: &ConstrainedTriangulation, region: usize) -> delone::TriangulationHash {
    let triangles = mesh.triangulation().triangles().iter().enumerate();
    let of_region = triangles.filter(|&(t, _)| mesh.region(TriangleId::new(t)) == Some(region));
    hash_triangles(of_region.map(|(_, corners)| corners.map(|v| at(mesh, v))))
}

/// Tells whether an edge must not be split.
pub(super) fn is_locked(job: &Job, mesh: &ConstrainedTriangulation, h: HalfEdgeId) -> bool {
    let beyond = mesh.triangulation().mesh().twin(h);
    let is_boundary = is_inside(mesh, h) != is_inside(mesh, beyond);
    match job.locked {
        Locked::Boundary => is_boundary,
        Locked::Segments => mesh.is_constrained(h) || is_boundary,
        _ => false,
    }
}

/// No vertex was added on what is locked.
fn check_locked(job: &Job, mesh: &ConstrainedTriangulation, lines: &Lines) -> Verdict {
    let triangulation = mesh.triangulation();
    let first = triangulation.points().len() - mesh.num_steiner();
    if job.locked == Locked::Nothing {
        return Ok(());
    }
    for v in (first..triangulation.points().len()).map(VertexId::new) {
        let is_split = !lines.through(v).is_empty();
        let mut star = triangulation.star(v);
        let is_wrong = is_split && star.any(|h| mesh.is_constrained(h) && is_locked(job, mesh, h));
        ensure(!is_wrong, || format!("{v:?} splits what is locked"))?;
    }
    Ok(())
}

/// If circles were asked for, no vertex of the domain lies in one: then every triangle is Delaunay.
/// Not promised where splitting had to stop, nor of vertices that are too close to leave room.
fn check_conforming(job: &Job, refined: &RefinedMesh) -> Verdict {
    let mesh = &refined.mesh;
    let is_promised = job.encroachment == Encroachment::Circle
        && job.locked == Locked::Nothing
        && refined.report.outcome == Outcome::Complete;
    if !is_promised {
        return Ok(());
    }
    let triangulation = mesh.triangulation();
    for h in triangulation.mesh().half_edges() {
        if !is_inside(mesh, h) || !mesh.is_constrained(h) {
            continue;
        }
        let topology = triangulation.mesh();
        let [a, b, apex] =
            [topology.origin(h), topology.dest(h), topology.apex(h)].map(|v| at(mesh, v));
        let is_encroached = in_diametral_circle(a, b, apex) == CircleSide::Inside;
        ensure(!is_encroached || is_tiny(mesh, [a, b], apex), || {
            format!("{apex:?} lies in the diametral circle of {a:?} {b:?}")
        })?;
    }
    Ok(())
}

/// Tells whether a subsegment is too short to be split, or its apex too close to it.
fn is_tiny(mesh: &ConstrainedTriangulation, [a, b]: [Point; 2], apex: Point) -> bool {
    let least = least_room(mesh, [a, b]);
    let length = (b.x - a.x).hypot(b.y - a.y);
    length < least || distance([a, b], apex) < least
}
