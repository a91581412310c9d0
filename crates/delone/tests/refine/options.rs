//! What may be asked for besides an angle.

use crate::support::{assert_complete, job, mesh, ring, square};
use delone::{
    Encroachment, Error, Locked, Outcome, Point, Pslg, Quality, Reason, Refinement, Region,
};
use delone_testkit::refined::{Cone, Job, Shape};

/// A square of side 4 with a line through it, and a fine outline.
fn halves() -> Job {
    let mut pslg = square(4.0);
    pslg.points
        .extend([(0.0, 2.0), (4.0, 2.0), (1.0, 3.0), (1.1, 3.0)].map(Point::from));
    pslg.add_segment(4, 5);
    pslg.add_segment(6, 7);
    pslg.regions = vec![
        Region {
            at: Point::new(1.0, 1.0),
            attribute: 1.0,
            max_area: Some(0.01),
        },
        Region {
            at: Point::new(3.0, 3.0),
            attribute: 2.0,
            max_area: None,
        },
    ];
    job(pslg, 25.0)
}

#[test]
fn edges_and_areas_are_bounded() {
    for (edge, area) in [
        (Some(0.2), None),
        (None, Some(0.02)),
        (Some(0.3), Some(0.01)),
    ] {
        for degrees in [0.0, 20.0, 30.0] {
            let mut job = job(square(4.0), degrees);
            job.quality.max_edge = edge;
            job.quality.max_area = area;
            let refined = assert_complete(&job);
            assert!(refined.report.unmet.is_empty());
            // No more than a few times of what equilateral triangles would take.
            let ideal = 16.0
                / area
                    .unwrap_or(f64::INFINITY)
                    .min(edge.map_or(f64::INFINITY, |e| e * e * 0.433));
            let triangles = refined.mesh.triangulation().num_triangles() as f64;
            assert!(triangles < 4.0 * ideal, "{triangles} for {ideal}");
        }
    }
}

#[test]
fn an_edge_bound_alone_is_enough() {
    let mut job = job(square(4.0), 0.0);
    job.quality = Quality {
        max_edge: Some(0.5),
        ..Quality::default()
    };
    let refined = assert_complete(&job);
    assert!(refined.statistics().longest_edge <= 0.5);
    job.quality = Quality {
        max_area: Some(0.1),
        ..Quality::default()
    };
    assert!(assert_complete(&job).mesh.num_steiner() > 10);
}

#[test]
fn nothing_asked_for_adds_nothing() {
    let mut job = halves();
    job.quality = Quality::default();
    let refined = assert_complete(&job);
    assert_eq!(refined.mesh.num_steiner(), 0);
}

#[test]
fn what_is_good_already_is_left_alone() {
    let job = job(square(4.0), 30.0);
    assert_eq!(assert_complete(&job).mesh.num_steiner(), 0);
}

#[test]
fn regions_have_areas_of_their_own() {
    let mut job = halves();
    job.quality.region_areas = true;
    let refined = assert_complete(&job);
    let mesh = &refined.mesh;
    let count = |region| {
        let triangles = (0..mesh.triangulation().num_triangles()).map(delone::TriangleId::new);
        triangles
            .filter(|&t| mesh.region(t) == Some(region))
            .count()
    };
    assert!(count(0) >= 800 && count(0) < 3200, "{}", count(0));
    assert!(count(1) < 400, "{}", count(1));
    job.quality.region_areas = false;
    let coarse = assert_complete(&job).mesh.triangulation().num_triangles();
    assert!(coarse < 300, "{coarse}");
}

#[test]
fn a_sizing_field_of_1000_to_1_is_obeyed() {
    let mut job = job(square(10.0), 25.0);
    job.sizing = Some(Cone {
        tip: Point::new(2.0, 3.0),
        least: 0.002,
        growth: 0.25,
    });
    let refined = assert_complete(&job);
    let triangulation = refined.mesh.triangulation();
    let shapes = triangulation.triangles().iter().map(|t| {
        let corners = t.map(|v| triangulation.point(v));
        Shape::of(corners).longest()
    });
    let (least, most) = shapes.fold((f64::MAX, 0.0f64), |(l, m), e| (l.min(e), m.max(e)));
    assert!(most / least > 100.0, "{least} to {most}");
    let triangles = triangulation.num_triangles();
    assert!(triangles < 20_000, "{triangles}");
}

#[test]
fn fields_that_say_nothing_bound_nothing() {
    for nothing in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        let field = move |_: Point| nothing;
        let refined = Refinement::new(Quality::default()).sizing(&field);
        let refined = refined.mesh(square(1.0)).unwrap();
        assert_eq!(refined.mesh.num_steiner(), 0, "{nothing}");
        assert_eq!(refined.report.outcome, Outcome::Complete);
    }
}

#[test]
fn a_locked_boundary_is_not_split() {
    for locked in [Locked::Boundary, Locked::Segments] {
        for encroachment in [Encroachment::Lens, Encroachment::Circle] {
            let mut job = halves();
            job.quality.max_edge = Some(0.7);
            job.locked = locked;
            job.encroachment = encroachment;
            job.vertices = Some(20_000);
            let refined = mesh(&job);
            let report = &refined.report;
            assert_ne!(
                report.outcome,
                Outcome::BudgetExhausted,
                "{locked:?} {encroachment:?}"
            );
            assert!(
                report
                    .unmet
                    .iter()
                    .any(|u| u.reason == Reason::LockedBoundary)
            );
            assert_eq!(refined.mesh.chain(0).len(), 2);
            // The line through the middle and the short one are no boundary.
            let is_split = refined.mesh.chain(4).len() > 2;
            assert_eq!(is_split, locked == Locked::Boundary, "{locked:?}");
            assert!(report.free > 20, "{}", report.free);
        }
    }
}

#[test]
fn locked_outlines_of_many_shapes_end() {
    let outlines = [
        ring([(0.0, 0.0), (10.0, 0.0), (10.0, 0.1), (0.0, 0.1)]),
        ring([(0.0, 0.0), (1.0, 0.0), (1.0, 1e-5), (10.0, 5.0), (0.0, 5.0)]),
        ring((0..50).map(|i| {
            let (sin, cos) = (0.1 * f64::from(i)).sin_cos();
            (cos * (1.0 + f64::from(i % 3)), sin)
        })),
    ];
    for outline in outlines {
        for degrees in [20.0, 30.0, 45.0] {
            let mut job = job(outline.clone(), degrees);
            job.locked = Locked::Boundary;
            job.vertices = Some(10_000);
            mesh(&job);
        }
    }
}

#[test]
fn circles_make_every_triangle_delaunay() {
    let mut job = halves();
    job.encroachment = Encroachment::Circle;
    for degrees in [0.0, 10.0, 20.0, 30.0] {
        job.quality.min_angle = Some(delone::Angle::degrees(degrees));
        let refined = assert_complete(&job);
        let points: Vec<_> = refined.mesh.triangulation().points().to_vec();
        let bare = delone::triangulate(points).unwrap();
        let hash = refined.mesh.triangulation().hash();
        assert_eq!(bare.hash(), hash, "{degrees}");
    }
}

#[test]
fn smoothing_keeps_bounds_and_boundary() {
    let mut job = halves();
    job.quality.max_edge = Some(0.4);
    for passes in [1, 5] {
        job.smoothing = passes;
        let refined = assert_complete(&job);
        assert!(refined.statistics().min_angle >= 25.0 - 1e-9);
    }
}

#[test]
fn bounds_that_make_no_sense_are_refused() {
    let angle = |degrees| Quality {
        min_angle: Some(delone::Angle::degrees(degrees)),
        ..Quality::default()
    };
    let edge = |edge| Quality {
        max_edge: Some(edge),
        ..Quality::default()
    };
    let area = |area| Quality {
        max_area: Some(area),
        ..Quality::default()
    };
    for (quality, word) in [
        (angle(60.0), "60"),
        (angle(-1.0), "-1"),
        (angle(f64::NAN), "NaN"),
        (edge(0.0), "longest edge"),
        (edge(f64::NAN), "NaN"),
        (area(-2.0), "largest area"),
    ] {
        let error = Refinement::new(quality)
            .mesh(square(1.0))
            .expect_err("refused");
        assert!(matches!(error, Error::BadQuality { .. }));
        assert!(error.to_string().contains(word), "{error}");
    }
}

#[test]
fn errors_of_the_input_are_handed_on() {
    let mut crossing = square(2.0);
    crossing.add_segment(0, 2);
    crossing.add_segment(1, 3);
    let error = Refinement::new(Quality::default())
        .mesh(crossing)
        .expect_err("a crossing");
    assert!(
        matches!(
            error,
            Error::Crossing {
                segments: [4, 5],
                ..
            }
        ),
        "{error}"
    );
    let mut infinite = square(2.0);
    infinite.points[1].x = f64::INFINITY;
    let error = Refinement::new(Quality::default())
        .mesh(infinite)
        .expect_err("not finite");
    assert!(
        matches!(error, Error::NotFinite { index: 1, .. }),
        "{error}"
    );
}

#[test]
fn what_hangs_on_a_locked_edge_is_excused_and_nothing_else_is_left() {
    // Long sides and a short one: near the long ones edges cannot be as short as asked for.
    let mut pslg = ring([(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (0.3, 5.0), (0.0, 5.0)]);
    pslg.points.push(Point::new(4.0, 0.2));
    for locked in [Locked::Boundary, Locked::Segments] {
        for degrees in [20.0, 25.0, 30.0] {
            let mut job = job(pslg.clone(), degrees);
            job.quality.max_edge = Some(0.5);
            job.locked = locked;
            let refined = assert_complete(&job);
            let mesh = refined.mesh.triangulation();
            let hangs = refined.report.unmet.iter().filter(|unmet| {
                let mut edges = unmet.triangle.half_edges().into_iter();
                unmet.reason == Reason::LockedBoundary
                    && !edges
                        .any(|h| mesh.mesh().twin(h).triangle().index() >= mesh.num_triangles())
            });
            assert!(hangs.count() > 0, "{locked:?} {degrees}");
        }
    }
}

#[test]
fn a_lattice_is_mended_by_moving_its_vertices() {
    // A square that is turned, so that the lattice fits none of its sides, with a hole. Where one new vertex
    // called for the next, there would be three times as many triangles at 33 degrees.
    let turned = |r: f64| [(r, 0.3 * r), (-0.3 * r, r), (-r, -0.3 * r), (0.3 * r, -r)];
    let mut pslg = Pslg::from_points([turned(2.0), turned(0.5)].concat());
    pslg.add_ring([0, 1, 2, 3]);
    pslg.add_ring([4, 5, 6, 7]);
    pslg.holes = vec![Point::new(0.0, 0.0)];
    let domain = 2.0 * 1.09 * (4.0 - 0.25);
    let bound = 0.001;
    for degrees in [20.0, 33.0] {
        let mut job = job(pslg.clone(), degrees);
        job.quality.max_area = Some(bound);
        let refined = assert_complete(&job);
        let fewest = domain / bound;
        let triangles = refined.mesh.triangulation().num_triangles() as f64;
        assert!(
            triangles < 1.15 * fewest,
            "{degrees}: {triangles} of {fewest}"
        );
    }
}
