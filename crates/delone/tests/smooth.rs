//! Smoothing: better triangles, every bound kept, and still the canonical triangulation.

use delone::{
    Angle, Budget, ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Encroachment, Origin,
    Outcome, Phase, Point, Pslg, Quality, RefinedMesh, Refinement, SizingField, Triangulation,
    VertexId, Watch, triangulate,
};
use std::collections::HashSet;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// A comb with a hole, a line inside, and two loose points.
fn comb() -> Pslg {
    let mut pslg = Pslg::from_points([
        (0.0, 0.0),
        (8.0, 0.0),
        (8.0, 5.0),
        (6.0, 1.0),
        (4.0, 5.0),
        (3.0, 1.0),
        (0.0, 4.0),
        // The hole.
        (1.0, 1.0),
        (1.5, 1.0),
        (1.25, 2.0),
        // The line.
        (4.0, 3.0),
        (4.5, 1.0),
        // Loose.
        (2.0, 0.5),
        (7.5, 3.0),
    ]);
    pslg.add_ring([0, 1, 2, 3, 4, 5, 6]);
    pslg.add_ring([7, 8, 9]);
    pslg.add_segment(10, 11);
    pslg.holes.push(Point::new(1.25, 1.2));
    pslg
}

fn quality(min_angle: f64, max_area: f64) -> Quality {
    Quality {
        min_angle: Some(Angle::degrees(min_angle)),
        max_area: Some(max_area),
        ..Quality::default()
    }
}

fn refinement(quality: Quality) -> Refinement<'static> {
    Refinement::new(quality).domain(DomainRule::Carve)
}

fn corners(mesh: &ConstrainedTriangulation) -> impl Iterator<Item = [Point; 3]> + '_ {
    let t = mesh.triangulation();
    t.triangles().iter().map(|c| c.map(|v| t.point(v)))
}

fn doubled_area([a, b, c]: [Point; 3]) -> f64 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

fn squares([a, b, c]: [Point; 3]) -> [f64; 3] {
    let squared = |p: Point, q: Point| (p.x - q.x).powi(2) + (p.y - q.y).powi(2);
    [squared(b, c), squared(c, a), squared(a, b)]
}

/// The mean of area over squared edges: 1 if all triangles are equilateral.
fn mean_quality(mesh: &ConstrainedTriangulation) -> f64 {
    let one = |t| 2.0 * 3_f64.sqrt() * doubled_area(t) / squares(t).iter().sum::<f64>();
    corners(mesh).map(one).sum::<f64>() / corners(mesh).count() as f64
}

/// Triangulates the points of a mesh with its constrained edges anew.
fn require_canonical(mesh: &ConstrainedTriangulation, rule: DomainRule, holes: &[Point]) {
    let t = mesh.triangulation();
    t.mesh().validate().expect("a sphere");
    let mut pslg = Pslg::from_points(t.points().iter().copied());
    for [a, b] in mesh.constrained_edges() {
        pslg.add_segment(a, b);
    }
    pslg.holes = holes.to_vec();
    let anew = ConstrainedDelaunay::new().domain(rule).triangulate(pslg);
    assert_eq!(anew.unwrap().triangulation().hash(), t.hash());
}

/// Only free vertices may have moved.
fn require_same_vertices(before: &ConstrainedTriangulation, after: &ConstrainedTriangulation) {
    let [old, new] = [before, after].map(|m| m.triangulation().points());
    assert_eq!(old.len(), new.len());
    let mut moved = 0;
    for v in (0..old.len()).map(VertexId::new) {
        assert_eq!(before.origin(v), after.origin(v));
        let stays = old[v.index()] == new[v.index()];
        assert!(stays || after.origin(v) == Origin::Free, "{v} moved");
        moved += usize::from(!stays);
    }
    assert!(moved > 0);
}

#[test]
fn more_passes_are_better_and_break_nothing() {
    let quality = quality(25.0, 0.002);
    let meshes = [0, 1, 2, 5, 20].map(|passes| {
        let refined = refinement(quality).smoothing(passes).mesh(comb()).unwrap();
        assert_eq!(
            refined.report.num_unexcused(),
            0,
            "{:?}",
            refined.report.unmet
        );
        assert_eq!(refined.report.outcome, Outcome::Complete);
        require_canonical(&refined.mesh, DomainRule::Carve, &comb().holes);
        refined.mesh
    });
    for mesh in &meshes[1..] {
        require_same_vertices(&meshes[0], mesh);
    }
    let means = meshes.each_ref().map(mean_quality);
    assert!(means.is_sorted(), "{means:?}");
    assert!(means[3] > means[0] + 0.005, "{means:?}");
}

/// What broke a bound before may do so afterwards, but nothing else, and it gets no worse.
#[test]
fn an_acute_corner_gets_no_worse() {
    let mut wedge = Pslg::from_points([(0.0, 0.0), (10.0, 0.0), (10.0, 0.5)]);
    wedge.add_ring([0, 1, 2]);
    let refined = |passes| {
        let refinement = refinement(quality(30.0, 0.01)).smoothing(passes);
        refinement.mesh(wedge.clone()).unwrap()
    };
    let [before, after] = [0, 10].map(refined);
    let report = |r: &RefinedMesh| (r.report.unmet.len(), r.report.num_unexcused());
    assert!(report(&after) <= report(&before));
    assert!(after.statistics().min_angle >= before.statistics().min_angle);
}

#[test]
fn sizes_of_a_field_are_kept() {
    let field = |p: Point| 0.02 + 0.1 * (p.x * p.x + p.y * p.y).sqrt();
    let quality = Quality {
        max_area: None,
        ..quality(25.0, 1.0)
    };
    let refined = refinement(quality).sizing(&field).smoothing(5).mesh(comb());
    let refined = refined.unwrap();
    assert_eq!(refined.report.num_unexcused(), 0);
    for t @ [a, b, c] in corners(&refined.mesh) {
        let centroid = Point::new((a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0);
        let longest = squares(t).iter().fold(0.0_f64, |m, &s| m.max(s)).sqrt();
        assert!(longest <= field.max_edge(centroid) * (1.0 + 1e-9));
    }
}

/// Without any segment but the hull's: then all triangles must stay Delaunay.
#[test]
fn a_conforming_mesh_stays_conforming() {
    let points = || comb().points;
    let refined = Refinement::new(quality(28.0, 0.05))
        .encroachment(Encroachment::Circle)
        .smoothing(6)
        .mesh(Pslg::from_points(points()));
    let mesh = refined.unwrap().mesh;
    // Rounding may have bent the hull inwards, so what its pieces enclose is compared.
    require_canonical(&mesh, DomainRule::Carve, &[]);
    let t = mesh.triangulation();
    let plain = triangulate(t.points().iter().copied()).unwrap();
    let sorted = |t: &Triangulation| {
        let least_first = |mut corners: [VertexId; 3]| {
            let least = (0..3).min_by_key(|&k| corners[k]).unwrap();
            corners.rotate_left(least);
            corners
        };
        t.triangles()
            .iter()
            .copied()
            .map(least_first)
            .collect::<HashSet<_>>()
    };
    assert!(sorted(t).is_subset(&sorted(&plain)));
}

#[test]
fn nothing_free_is_nothing_to_move() {
    let mut square = Pslg::from_points([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    square.add_ring([0, 1, 2, 3]);
    for pslg in [square, Pslg::default()] {
        let refine = |passes| {
            Refinement::new(Quality::default())
                .smoothing(passes)
                .mesh(pslg.clone())
        };
        let [before, after] = [0, 3].map(|passes| refine(passes).unwrap());
        assert_eq!(
            before.mesh.triangulation().hash(),
            after.mesh.triangulation().hash()
        );
    }
}

/// Cancels once smoothing has begun.
#[derive(Default)]
struct Impatient(AtomicBool);

impl Watch for Impatient {
    fn progress(&self, phase: Phase, done: u64, _: u64) {
        if phase == Phase::Smooth && done > 0 {
            self.0.store(true, Ordering::Relaxed);
        }
    }

    fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

#[test]
fn a_smoothing_that_is_cancelled_leaves_a_mesh() {
    let watch = Impatient::default();
    let refinement = refinement(quality(25.0, 0.001)).smoothing(1000);
    let refined = refinement.watch(&watch).mesh(comb()).unwrap();
    assert_eq!(refined.report.outcome, Outcome::Cancelled);
    require_canonical(&refined.mesh, DomainRule::Carve, &comb().holes);
}

#[test]
fn no_time_is_no_smoothing() {
    let budget = Budget {
        time: Some(Duration::ZERO),
        ..Budget::default()
    };
    let refine = |passes| {
        let refinement = refinement(quality(25.0, 0.02)).budget(budget);
        refinement.smoothing(passes).mesh(comb()).unwrap().mesh
    };
    let [before, after] = [0, 5].map(|passes| refine(passes).triangulation().hash());
    assert_eq!(before, after);
}
