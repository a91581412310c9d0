//! The strategy of the thesis: its own domain as it is worked there, and what must hold of any.

use delone::{
    Angle, Budget, ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Encroachment, Error,
    Event, Locked, Log, Origin, Outcome, Phase, Point, Pslg, Quality, Reason, RefinedMesh,
    Refinement, Scene, Stage, Strategy, VertexId, Watch, hash_triangles,
};
use delone_testkit::domains::Domain;
use delone_testkit::fuzz::segments::case;
use delone_testkit::generate::Random;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// The line of pseudocode that returns to the mesh saved.
const RETURN: u16 = 16;

/// All events of a run.
fn observed(refinement: Refinement, pslg: Pslg) -> (RefinedMesh, Log) {
    let mut log = Log::new("thesis", pslg.points.clone());
    let refined = refinement.observe(pslg, &mut log);
    (refined.expect("a mesh"), log)
}

/// Plays a log forwards, which ends with the mesh, and backwards, which ends with the points.
fn assert_played(log: &Log, mesh: &ConstrainedTriangulation) {
    let mut scene = log.last_scene().expect("every step fits");
    let t = mesh.triangulation();
    assert_eq!(scene.hash(), t.hash());
    assert_eq!(scene.vertices().count(), t.points().len());
    assert!(scene.vertices().all(|(v, at)| t.point(v) == at));
    let mut edges: Vec<_> = t.edges().chain(mesh.constrained_edges()).collect();
    for [a, b] in &mut edges {
        (*a, *b) = (*a.min(b), *b.max(a));
    }
    edges.sort();
    edges.dedup();
    assert_eq!(scene.edges().collect::<Vec<_>>(), edges);
    assert!(mesh.constrained_edges().all(|edge| scene.is_locked(edge)));
    let locked = scene.edges().filter(|&edge| scene.is_locked(edge));
    assert_eq!(locked.count(), mesh.constrained_edges().count());
    // Only what is taken back is mended at once: all else was told step by step.
    let is_back = log
        .steps
        .iter()
        .any(|step| matches!(step.event, Event::TakenBack { .. }));
    assert!(is_back || log.steps.iter().all(|step| step.line != RETURN));
    for step in log.steps.iter().rev() {
        scene.revert(step.event).expect("every step fits backwards");
    }
    assert!(scene == Scene::new(log.points.iter().copied()));
}

/// The domain of example 1.16.
fn thesis_domain() -> Pslg {
    let mut pslg = Pslg::from_points([
        (1.0, 0.0),
        (3.0, 1.0),
        (2.5, 3.0),
        (3.0, 4.0),
        (0.0, 3.0),
        (0.0, 1.0),
        (2.0, 1.0),
        (2.0, 2.0),
        (1.0, 2.0),
    ]);
    pslg.add_ring([0, 1, 2, 3, 4, 5]);
    pslg.add_ring([6, 7, 8]);
    pslg
}

fn quality(degrees: f64, max_edge: f64) -> Quality {
    Quality {
        min_angle: Some(Angle::degrees(degrees)),
        max_edge: Some(max_edge),
        ..Quality::default()
    }
}

fn thesis(quality: Quality) -> Refinement<'static> {
    Refinement::new(quality)
        .strategy(Strategy::Thesis)
        .domain(DomainRule::EvenOdd)
}

fn longest_edge(t: &ConstrainedTriangulation) -> f64 {
    let point = |v: VertexId| t.triangulation().point(v);
    let lengths = t.triangulation().edges().map(|edge| {
        let [a, b] = edge.map(point);
        (b.x - a.x).hypot(b.y - a.y)
    });
    lengths.fold(0.0, f64::max)
}

/// The mesh is the constrained Delaunay triangulation of its vertices and subsegments, and vertices and
/// segments know each other.
fn assert_valid(t: &ConstrainedTriangulation) {
    let triangulation = t.triangulation();
    let (points, mesh) = (triangulation.points(), triangulation.mesh());
    mesh.validate().expect("a closed sphere");
    let finite = mesh.triangles().map(|t| mesh.corners(t));
    let hash = hash_triangles(finite.map(|t| t.map(|v| points[v.index()])));
    let mut pslg = Pslg::from_points(points.iter().copied());
    pslg.segments = t.constrained_edges().collect();
    let again = ConstrainedDelaunay::new().triangulate(pslg);
    assert_eq!(again.expect("planar").triangulation().hash(), hash);

    let mut in_chains: Vec<_> = (0..t.segments().len())
        .flat_map(|s| t.chain(s).windows(2))
        .map(|pair| [pair[0].min(pair[1]), pair[0].max(pair[1])])
        .collect();
    in_chains.sort();
    in_chains.dedup();
    let constrained = t.constrained_edges().map(|[a, b]| [a.min(b), a.max(b)]);
    let mut constrained: Vec<_> = constrained.collect();
    constrained.sort();
    assert_eq!(constrained, in_chains);
    let first = points.len() - t.num_steiner();
    for v in (first..points.len()).map(VertexId::new) {
        let expected = (0..t.segments().len()).find(|&s| t.chain(s).contains(&v));
        match t.origin(v) {
            Origin::OnSegment(segment) => assert_eq!(Some(segment), expected),
            origin => assert_eq!((origin, expected), (Origin::Free, None)),
        }
    }
}

#[test]
fn the_thesis_own_domain_is_opened_twice() {
    let (refined, log) = observed(thesis(quality(20.0, 3.0)), thesis_domain());
    assert_played(&log, &refined.mesh);
    assert!((refined.statistics().min_angle - 26.565).abs() < 1e-3);
    let RefinedMesh { mesh, report, .. } = refined;
    assert_valid(&mesh);
    let [edge_split, first, second] = [(1.5, 3.5), (2.0, 0.5), (1.0, 1.0)].map(Point::from);
    assert_eq!(
        mesh.triangulation().points()[9..],
        [edge_split, first, second]
    );
    assert_eq!(mesh.triangulation().num_triangles(), 13);
    assert_eq!((report.outcome, report.unmet.len()), (Outcome::Complete, 0));
    assert_eq!((report.on_segments, report.free), (2, 1));

    let events = || log.steps.iter().map(|step| step.event);
    let split = events().filter_map(|event| match event {
        Event::SegmentSplit { edge, vertex } => Some((edge.map(VertexId::index), vertex.index())),
        _ => None,
    });
    assert!(split.eq([([4, 3], 9), ([1, 0], 10), ([8, 0], 11)]));
    let created = events().filter_map(|event| match event {
        Event::VertexCreated { vertex, at } => Some((vertex.index(), at)),
        _ => None,
    });
    assert!(created.eq([(9, edge_split), (10, first), (11, second)]));
    let stages = events().filter_map(|event| match event {
        Event::StageEnded { stage, min_angle } => {
            Some((stage, min_angle.map(|a| (1e3 * a.to_degrees()).round())))
        }
        _ => None,
    });
    assert!(stages.eq([
        (Stage::SplitEdges, None),
        (Stage::ShortenEdges, Some(18435.0)),
        (Stage::OpenTriangles, Some(26565.0)),
    ]));
    let opened = events().filter(|event| matches!(event, Event::CircumcenterRejected { .. }));
    assert_eq!(opened.count(), 2);
}

#[test]
fn without_success_the_mesh_of_phase_1_is_the_result() {
    let (refined, log) = observed(thesis(quality(40.0, 1.0)), thesis_domain());
    assert_played(&log, &refined.mesh);
    let RefinedMesh { mesh, report, .. } = &refined;
    assert_valid(mesh);
    assert_eq!(report.outcome, Outcome::FellBack);
    let only_edges = Quality {
        max_edge: Some(1.0),
        ..Quality::default()
    };
    let phase_1 = thesis(only_edges).mesh(thesis_domain()).unwrap();
    assert_eq!(phase_1.report.outcome, Outcome::Complete);
    assert_eq!(
        mesh.triangulation().hash(),
        phase_1.mesh.triangulation().hash()
    );
    assert!(longest_edge(mesh) <= 1.0);
    assert_eq!(refined.statistics(), phase_1.statistics());
    assert!(report.num_unexcused() > 0);
    let first = VertexId::new(mesh.triangulation().points().len());
    let back = Event::TakenBack { from: first };
    let at = log.steps.iter().position(|step| step.event == back);
    let (before, after) = log.steps.split_at(at.expect("taken back"));
    let deleted: Vec<_> = after
        .iter()
        .filter_map(|step| match step.event {
            Event::VertexDeleted { vertex, .. } => Some(vertex),
            _ => None,
        })
        .collect();
    let created = before.iter().filter_map(|step| match step.event {
        Event::VertexCreated { vertex, .. } => Some(vertex),
        _ => None,
    });
    let created: Vec<_> = created.filter(|&v| v >= first).collect();
    assert!(!created.is_empty() && created.iter().rev().eq(&deleted));
    assert!(after.iter().all(|step| step.line == after[0].line));
}

/// A wedge of 10°: the triangle in its corner has two segments as its longer edges.
#[test]
fn angles_given_by_the_domain_are_left_alone_and_excused() {
    let mut wedge = Pslg::from_points([(0.0, 0.0), (8.0, 0.0), (8.0, 1.41)]);
    wedge.add_ring([0, 1, 2]);
    let RefinedMesh { mesh, report, .. } = thesis(quality(15.0, 9.0)).mesh(wedge).unwrap();
    assert_eq!((report.outcome, mesh.num_steiner()), (Outcome::Complete, 0));
    let [unmet] = report.unmet[..] else {
        panic!("{:?}", report.unmet)
    };
    assert!(unmet.broken.angle && !unmet.broken.edge);
    assert!(matches!(
        unmet.reason,
        Reason::SmallInputAngle { vertex, segments: [0, 2], .. } if vertex.index() == 0
    ));
}

#[test]
fn lines_inside_are_constraints_too() {
    let mut square =
        Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (1.0, 1.0)]);
    square.add_ring([0, 1, 2, 3]);
    square.polygons.push(0..4);
    square.add_segment(4, 2);
    let RefinedMesh { mesh, report, .. } = thesis(quality(20.0, 0.7)).mesh(square).unwrap();
    assert_valid(&mesh);
    assert_eq!(report.outcome, Outcome::Complete);
    assert!(mesh.chain(4).len() >= 8, "divided from end to end");
    assert!(longest_edge(&mesh) <= 0.7);
}

#[test]
fn the_hull_is_bounded_by_segments() {
    let mut random = Random::new(3);
    let points: Vec<_> = (0..40).map(|_| (random.unit(), random.unit())).collect();
    let hull = delone::triangulate(points.clone()).unwrap();
    let refined = thesis(quality(20.0, 0.1)).domain(DomainRule::Hull);
    let RefinedMesh { mesh, .. } = refined.mesh(Pslg::from_points(points)).unwrap();
    assert_valid(&mesh);
    assert_eq!(mesh.num_input_segments(), 0);
    assert_eq!(mesh.segments().len(), hull.num_hull_edges());
    assert!(longest_edge(&mesh) <= 0.1);
}

#[test]
fn what_the_thesis_does_not_know_is_refused() {
    let with = |change: fn(&mut Quality)| {
        let mut asked = quality(20.0, 1.0);
        change(&mut asked);
        thesis(asked)
    };
    let plain = thesis(quality(20.0, 1.0));
    let field = |_: Point| 1.0;
    for (refinement, named) in [
        (plain.sizing(&field), "sizing field"),
        (with(|q| q.max_area = Some(1.0)), "largest area"),
        (with(|q| q.region_areas = true), "largest area by region"),
        (plain.locked(Locked::Boundary), "locked edges"),
        (plain.encroachment(Encroachment::Circle), "conforming mesh"),
        (plain.smoothing(1), "smoothing"),
    ] {
        let refused = refinement.mesh(thesis_domain()).err();
        assert_eq!(refused, Some(Error::NotInThesis { what: named }));
    }
}

#[test]
fn budgets_end_it_with_a_valid_mesh() {
    let refinement = thesis(quality(20.0, 0.05));
    for vertices in [0, 9, 10, 60, 500] {
        let budget = Budget {
            vertices: Some(vertices),
            ..Budget::default()
        };
        let (refined, log) = observed(refinement.budget(budget), thesis_domain());
        let RefinedMesh { mesh, report, .. } = refined;
        assert_valid(&mesh);
        assert_played(&log, &mesh);
        assert_eq!(report.outcome, Outcome::BudgetExhausted);
        assert_eq!(mesh.triangulation().points().len(), vertices.max(9));
        assert!(report.unmet.iter().any(|u| u.broken.edge));
        assert!(report.num_unexcused() > 0);
    }
    let budget = Budget {
        time: Some(Duration::ZERO),
        ..Budget::default()
    };
    let refined = refinement.budget(budget).mesh(thesis_domain()).unwrap();
    assert_eq!(refined.report.outcome, Outcome::BudgetExhausted);
}

/// Cancels once refinement has come some way.
struct Impatient(AtomicBool);

impl Watch for Impatient {
    fn progress(&self, phase: Phase, done: u64, _: u64) {
        let is_enough = phase == Phase::Refine && done > 1000;
        self.0.fetch_or(is_enough, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

#[test]
fn cancelling_leaves_the_mesh_so_far() {
    let watch = Impatient(AtomicBool::new(false));
    let refined = thesis(quality(20.0, 0.01))
        .watch(&watch)
        .mesh(thesis_domain());
    let RefinedMesh { mesh, report, .. } = refined.unwrap();
    assert_valid(&mesh);
    assert_eq!(report.outcome, Outcome::Cancelled);
    assert!((1000..2000).contains(&mesh.triangulation().points().len()));
}

/// Powers of two change nothing, however large or small.
#[test]
fn the_scale_does_not_matter() {
    let refine = |scale: f64| {
        let mut pslg = thesis_domain();
        for p in &mut pslg.points {
            *p = Point::new(p.x * scale, p.y * scale);
        }
        let (refined, log) = observed(thesis(quality(25.0, 0.5 * scale)), pslg);
        let RefinedMesh { mesh, report, .. } = refined;
        assert_valid(&mesh);
        assert_played(&log, &mesh);
        let points = mesh.triangulation().points().iter();
        let points: Vec<_> = points.map(|p| [p.x / scale, p.y / scale]).collect();
        (
            report.outcome,
            points,
            mesh.triangulation().triangles().to_vec(),
        )
    };
    let ordinary = refine(1.0);
    assert_eq!(ordinary.0, Outcome::Complete);
    for exponent in [-900, -300, 300, 1000] {
        assert_eq!(refine(2f64.powi(exponent)), ordinary, "2^{exponent}");
    }
}

/// Coordinates without room for other vertices.
#[test]
fn precision_ends_it_with_a_valid_mesh() {
    let [a, b] = [1.0, 1.0 + 8.0 * f64::EPSILON];
    let mut tiny = Pslg::from_points([(a, a), (b, a), (b, b), (a, b)]);
    tiny.add_ring([0, 1, 2, 3]);
    for max_edge in [f64::EPSILON / 4.0, 1e-300] {
        let (refined, log) = observed(thesis(quality(30.0, max_edge)), tiny.clone());
        assert_valid(&refined.mesh);
        assert_played(&log, &refined.mesh);
        assert_eq!(refined.report.outcome, Outcome::PrecisionLimit);
    }
}

/// Whatever is drawn: an error, or a valid mesh of the same domain that keeps what is promised.
#[test]
fn random_drawings_are_refined_or_refused() {
    let (mut refined, mut complete) = (0, 0);
    for seed in 0..2000 {
        let mut domain = Domain::default();
        case(seed, 24, 24, &mut domain);
        let mut random = Random::new(seed);
        let Ok(before) = domain.triangulate(1) else {
            continue;
        };
        let points = before.triangulation().points().len();
        let size = longest_edge(&before);
        let max_edge = size * (0.1 + random.unit());
        let budget = Budget {
            vertices: Some(points + 400),
            ..Budget::default()
        };
        let asked = Quality {
            min_angle: Some(Angle::degrees(35.0 * random.unit())),
            max_edge: Some(max_edge).filter(|&l| l > 0.0 && l.is_finite()),
            ..Quality::default()
        };
        let refinement = thesis(asked)
            .domain(domain.rule)
            .crossings(domain.crossings)
            .budget(budget);
        let (result, log) = observed(refinement.threads(1), domain.pslg.clone());
        let RefinedMesh { mesh, report, .. } = &result;
        assert_valid(mesh);
        assert_played(&log, mesh);
        let points = mesh.triangulation().points();
        assert!(points.len() <= before.triangulation().points().len() + 400);
        let again = refinement.threads(2).mesh(domain.pslg.clone()).unwrap();
        assert_eq!(again.mesh.triangulation().points(), points, "case {seed}");
        let [old, new] = [&before, mesh].map(|t| {
            let t = t.triangulation();
            delone::check::statistics(t.points(), t.triangles()).area
        });
        // What was cut off or added by rounding vertices on segments.
        let largest = points.iter().flat_map(|p| [p.x.abs(), p.y.abs()]);
        let largest = largest.fold(0.0, f64::max);
        let is_as_large = old == new || (old - new).abs() <= 1e-12 * largest * largest;
        assert!(is_as_large, "case {seed}: {old} {new}");
        let is_promised = matches!(report.outcome, Outcome::Complete | Outcome::FellBack);
        if let Some(bound) = asked.max_edge
            && is_promised
        {
            // Of triangles: there may be none.
            let longest = result.statistics().longest_edge;
            assert!(longest <= bound * (1.0 + 1e-12), "case {seed}: {longest}");
            assert!(report.unmet.iter().all(|u| !u.broken.edge), "case {seed}");
        }
        if report.outcome == Outcome::Complete {
            assert_eq!(report.num_unexcused(), 0, "case {seed}: {:?}", report.unmet);
        }
        refined += 1;
        complete += usize::from(report.outcome == Outcome::Complete);
    }
    assert!(refined > 200 && complete > 50, "{refined} {complete}");
}
