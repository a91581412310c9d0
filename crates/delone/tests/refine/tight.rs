//! Features that are very close to each other, and inputs that hardly are domains.

use crate::support::{
    USUAL, asking, assert_complete, assert_ends, assert_ends_beyond, job, mesh, ring, square,
};
use delone::{DomainRule, Encroachment, Outcome, Point, Pslg};
use delone_testkit::refined::Job;

#[test]
fn nearly_parallel_segments_stay_within_the_budget() {
    for gap in [1e-12, 1e-13, 1e-15] {
        let mut pslg = square(1.0);
        let ends = [
            (0.2, 0.5),
            (0.8, 0.5),
            (0.2, 0.5 + gap),
            (0.8, 0.5 + 2.0 * gap),
        ];
        pslg.points.extend(ends.map(Point::from));
        pslg.add_segment(4, 5);
        pslg.add_segment(6, 7);
        for degrees in USUAL {
            let mut job = job(pslg.clone(), degrees);
            job.vertices = Some(3000);
            mesh(&job);
        }
    }
}

#[test]
fn a_tiny_gap_beside_a_huge_edge_is_graded() {
    // The gap is 10⁻⁶ long; the triangles around it grow by a constant factor.
    let points = [
        (0.0, 0.0),
        (0.5, 0.0),
        (0.5, 1e-6),
        (0.500001, 1e-6),
        (0.500001, 0.0),
        (1.0, 0.0),
        (1.0, 1.0),
        (0.0, 1.0),
    ];
    assert_ends(&ring(points));
    let refined = assert_complete(&job(ring(points), 30.0));
    let triangles = refined.mesh.triangulation().num_triangles();
    assert!(triangles < 2000, "{triangles} triangles");
}

#[test]
fn a_square_with_a_corner_ulps_from_a_side_ends() {
    for up in [1, 2, 50, 5000] {
        let nearly = f64::from_bits(0.5f64.to_bits() + up);
        let mut pslg = ring([(0.0, 0.0), (1.0, 0.0), (1.0, 0.5), (0.0, 0.5)]);
        pslg.points.push(Point::new(0.3, nearly));
        pslg.points.push(Point::new(0.4, 0.9));
        pslg.points.push(Point::new(0.2, 0.9));
        pslg.add_ring([4u32, 5, 6]);
        let mut job = job(pslg.clone(), 20.0);
        job.vertices = Some(20_000);
        assert_ne!(
            mesh(&job).report.outcome,
            Outcome::BudgetExhausted,
            "{up} ulps"
        );
        assert_ends_beyond(&pslg);
    }
}

/// A square with loose points at about this distance from its sides.
fn square_with_loose_points(distance: f64) -> Pslg {
    let mut pslg = square(1.0);
    let loose = [
        (0.5, distance),
        (0.25, 0.3 * distance),
        (1.0 - distance, 0.5),
    ];
    pslg.points.extend(loose.map(Point::from));
    pslg
}

#[test]
fn loose_points_nearly_on_segments_end() {
    for distance in [1e-3, 1e-9] {
        assert_ends(&square_with_loose_points(distance));
    }
}

#[test]
fn loose_points_closer_to_segments_than_vertices_may_be_end() {
    // Nothing can be put between such a point and the segment.
    for distance in [1e-15, 1e-17, 1e-300] {
        let pslg = square_with_loose_points(distance);
        for degrees in USUAL {
            let mut job = job(pslg.clone(), degrees);
            job.vertices = Some(20_000);
            assert_ne!(mesh(&job).report.outcome, Outcome::BudgetExhausted);
        }
        assert_ends_beyond(&pslg);
    }
}

#[test]
fn loose_points_close_to_each_other_end() {
    for distance in [1e-3, 1e-8, 1e-15] {
        let mut pslg = square(1.0);
        pslg.points
            .extend([(0.5, 0.5), (0.5 + distance, 0.5)].map(Point::from));
        assert_ends(&pslg);
    }
}

#[test]
fn crossing_segments_are_split_and_refined() {
    let mut pslg = square(4.0);
    pslg.points.extend(
        [
            (0.5, 0.5),
            (3.5, 3.3),
            (0.5, 3.1),
            (3.5, 0.7),
            (0.4, 2.0),
            (3.6, 2.1),
        ]
        .map(Point::from),
    );
    for [a, b] in [[4u32, 5], [6, 7], [8, 9]] {
        pslg.add_segment(a, b);
    }
    let refined = assert_complete(&job(pslg.clone(), 30.0));
    assert_eq!(refined.mesh.num_crossings(), 3);
    assert_ends(&pslg);
}

#[test]
fn a_random_tangle_ends() {
    let mut random = delone_testkit::generate::Random::new(4);
    let mut pslg = square(1.0);
    for _ in 0..12 {
        let first = pslg.points.len() as u32;
        pslg.points
            .extend([0; 2].map(|_| Point::new(random.unit(), random.unit())));
        pslg.add_segment(first, first + 1);
    }
    assert_ends(&pslg);
}

#[test]
fn single_triangles_end() {
    for apex in [
        (0.5, 0.8660254037844386),
        (0.0, 1.0),
        (0.5, 1e-3),
        (0.5, 1e-200),
        (20.0, 1.0),
    ] {
        assert_ends(&ring([(0.0, 0.0), (1.0, 0.0), apex]));
    }
}

#[test]
fn what_is_no_domain_is_complete_and_empty() {
    let line = |n: i32| Pslg::from_points((0..n).map(|i| (f64::from(i), 2.0 * f64::from(i))));
    let mut collinear = line(4);
    collinear.add_segment(0, 3);
    let open = {
        let mut pslg = line(1);
        pslg.points.push(Point::new(1.0, 0.0));
        pslg.add_segment(0, 1);
        pslg
    };
    for pslg in [Pslg::default(), line(1), line(2), line(5), collinear, open] {
        for rule in [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd] {
            let mut job = job(pslg.clone(), 30.0);
            job.domain.rule = rule;
            job.quality.max_edge = Some(0.1);
            let refined = assert_complete(&job);
            assert_eq!(refined.mesh.triangulation().num_triangles(), 0);
            assert_eq!(refined.mesh.num_steiner(), 0);
        }
    }
}

#[test]
fn bare_points_keep_their_hull_and_are_refined() {
    let points = delone_testkit::generate::Kind::Uniform.points(60, 3);
    for degrees in USUAL {
        let job = Job {
            quality: asking(degrees),
            vertices: Some(20_000),
            ..Job::default()
        };
        let mut job = job;
        job.domain.pslg = Pslg::from_points(points.iter().copied());
        let refined = mesh(&job);
        assert_eq!(refined.report.num_unexcused(), 0, "{degrees}");
        let hull = Pslg::from_points(points.iter().copied());
        let hull = delone::ConstrainedDelaunay::new()
            .triangulate(hull)
            .unwrap();
        let edges = hull.triangulation().num_hull_edges();
        let appended = refined.mesh.segments().len() - refined.mesh.num_input_segments();
        assert_eq!(appended, edges);
    }
}

#[test]
fn segments_that_overlap_but_for_rounding_are_split_until_none_is_encroached_upon() {
    // The second segment ends beside the first one, a few units off.
    let mut pslg = Pslg::from_points([
        (-4.8406105001918815, -9.673080687424875),
        (9.681221000383763, 19.34616137484975),
        (14.2662896556027, 6.817109318651372),
        (30.657199834548585, 61.26284435369088),
    ]);
    for [a, b] in [[3, 0], [2, 0], [0, 1], [1, 2]] {
        pslg.add_segment(a, b);
    }
    let mut job = job(pslg, 0.0);
    job.encroachment = Encroachment::Circle;
    job.domain.rule = DomainRule::EvenOdd;
    // The judge looks for vertices in circles.
    let refined = assert_complete(&job);
    assert!(refined.report.on_segments > 2);
}

#[test]
fn smoothing_takes_no_vertex_into_a_circle_in_exchange_for_another() {
    // Two corners are three units apart, so one lies in a circle for good.
    let mut pslg = Pslg::from_points([
        (2.206414750829339, 2.2653330764641892),
        (-0.029459162817425555, 2.235873913646764),
        (2.176955588011915, 4.501206990110953),
        (0.858998570077796, 2.694832361503087),
        (0.42949928503889767, 1.3474161807515437),
        (-0.029459162817425333, 2.235873913646764),
    ]);
    pslg.add_segment(0, 5);
    pslg.add_segment(5, 1);
    let mut job = job(pslg, 20.0);
    job.encroachment = Encroachment::Circle;
    job.domain.rule = DomainRule::Hull;
    job.smoothing = 2;
    assert_complete(&job);
}

#[test]
fn segments_are_split_towards_zero_until_squares_of_distances_would_vanish() {
    // A segment and an edge of the hull leave the origin in all but the same direction.
    let mut pslg = Pslg::from_points([
        (0.8184000552533245, -1.82488940748785),
        (0.0, 0.0),
        (1.2276000828799867, -2.7373341112317746),
        (-2.3281340836051125, -2.1400447866239114),
    ]);
    pslg.add_segment(0, 1);
    let mut job = job(pslg, 0.0);
    job.quality.min_angle = None;
    job.encroachment = Encroachment::Circle;
    job.domain.rule = DomainRule::Hull;
    assert_complete(&job);
}
